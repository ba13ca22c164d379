//! The choices of a diagnosis.

use crate::effects::Effect;
use sim::Hold;

/// Choices of a diagnosis.
pub struct Options<'a> {
    /// Seed of the family's draws.
    pub seed: u64,
    /// Probability that screening names anything where nothing is missing.
    pub family: f64,
    /// Most effects.
    pub most_effects: usize,
    /// What logged inputs do between samples.
    pub hold: Hold,
    /// Only these effects of the catalogue; all where empty.
    pub only: Vec<String>,
    /// Effects of the user's own.
    pub own: Vec<Effect>,
    /// The last step that is done.
    pub until: Step,
    /// Which parts of the method are used.
    pub method: Method,
    /// Series that show the answer are handed over too.
    pub traces: bool,
    /// Where the answer is open, the experiment that would tell is looked for.
    pub next: bool,
    /// Told what is going on.
    pub progress: &'a (dyn Fn(&str) + Sync),
}

/// Parts of the method that can be left out, to show what they are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Method {
    /// Random forces in the filter; without, innovations are output errors.
    pub whitening: bool,
    /// The family's threshold; without, that of the Bayesian information criterion.
    pub family: bool,
    /// Acceptance on other records; without, on the training records themselves.
    pub other_records: bool,
    /// An effect is what the fitted parameters cannot do; without, these are as if known wherever an effect is judged.
    pub absorption: bool,
}

impl Default for Method {
    fn default() -> Self {
        Self { whitening: true, family: true, other_records: true, absorption: true }
    }
}

/// Steps after which a diagnosis can stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// Quality of the records.
    Preflight,
    /// Base fit, its figures and where it disagrees.
    Where,
    /// First screening.
    Screen,
    /// All.
    Patch,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            seed: 1,
            family: 0.05,
            most_effects: 4,
            hold: Hold::Zero,
            only: Vec::new(),
            own: Vec::new(),
            until: Step::Patch,
            method: Method::default(),
            traces: false,
            next: false,
            progress: &|_| {},
        }
    }
}
