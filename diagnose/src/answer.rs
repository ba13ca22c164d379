//! What a diagnosis says. Values are SI; names are those of the rig.

use ident::innovations::Noise;

/// How it ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Effects were found and nothing is left that the records show.
    Complete,
    /// Effects were found; more is missing that no candidate explains.
    Partial,
    /// An effect was found that cannot be told from others with these records.
    Ambiguous,
    /// What is missing is eaten by the fitted parameters: these records cannot say.
    NotIdentifiable,
    /// Something is missing, and it is none of the candidates.
    OutsideCatalogue,
    /// Nothing is missing that these records show.
    NoGap,
    /// The records cannot be used.
    BadData,
}

impl Verdict {
    /// The word of JSON.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::Partial => "partial",
            Self::Ambiguous => "ambiguous",
            Self::NotIdentifiable => "not_identifiable",
            Self::OutsideCatalogue => "outside_catalogue",
            Self::NoGap => "no_gap",
            Self::BadData => "bad_data",
        }
    }
}

/// Where simulation and record disagree.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Coordinate whose equation it is.
    pub equation: String,
    /// In words.
    pub sentence: String,
    /// Stretches of time [s] in which the disturbance is larger than chance, of the first record.
    pub windows: Vec<(f64, f64)>,
    /// Region of states, in words; empty where there is none.
    pub region: String,
    /// Root-mean-square disturbance (unit of the equation).
    pub size: f64,
    /// Its unit.
    pub unit: String,
}

/// A parameter of an accepted effect.
#[derive(Clone, Debug, PartialEq)]
pub struct EffectValue {
    /// Name in the patched rig.
    pub name: String,
    /// Record, where it belongs to the day.
    pub record: Option<String>,
    /// Value.
    pub value: f64,
    /// Standard error.
    pub sd: f64,
    /// Unit.
    pub unit: String,
}

/// An accepted effect.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Effect.
    pub effect: String,
    /// Place.
    pub place: String,
    /// What is fixed in its shape.
    pub shape: Option<String>,
    /// Its parameters.
    pub parameters: Vec<EffectValue>,
    /// Effects that the records cannot tell from it.
    pub equivalent: Vec<(String, String)>,
    /// p-value in the family of all candidates.
    pub p_value: f64,
    /// Gain of log-likelihood on the test records [nats/sample], and the half width of its 95 % interval.
    pub heldout_gain: (f64, f64),
    /// Squared error of predictions of the test records with it over that without, neither smaller than noise makes it; mean over signals.
    pub error_ratio: f64,
    /// Belongs to the day.
    pub per_record: bool,
}

/// A candidate and what became of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Effect.
    pub effect: String,
    /// Place.
    pub place: String,
    /// What is fixed in its shape.
    pub shape: Option<String>,
    /// Score in standard deviations (root of the statistic).
    pub score: f64,
    /// p-value in the family.
    pub p_value: f64,
    /// Share of its signature that is its own.
    pub unique_fraction: f64,
    /// Smallest sizes that would have been found: name, size, unit.
    pub minimal_detectable: Vec<(String, f64, String)>,
    /// Smallest sizes that would have been found in the test records (SI), in the same order; empty where there are none.
    pub detectable_in_test: Vec<f64>,
    /// Number of its class; candidates of one class cannot be told apart.
    pub class: usize,
    /// `accepted`, `equivalent`, `quiet`, `not identifiable`, `rejected: ..`.
    pub status: String,
}

/// How a model follows one output of one record.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Record.
    pub record: String,
    /// Output, or its rate.
    pub signal: String,
    /// Fit in percent.
    pub fit_percent: Option<f64>,
    /// Root-mean-square error (SI).
    pub rmse: Option<f64>,
    /// Seconds ahead, where it is a prediction and no free run.
    pub horizon: Option<f64>,
    /// Root-mean-square error that the noise alone gives a prediction (SI).
    pub floor: Option<f64>,
}

/// Figures of one model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures {
    /// On training records.
    pub train: Vec<Figure>,
    /// On test records.
    pub test: Vec<Figure>,
}

/// A fitted parameter before and after.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// Parameter.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Before: value and standard error.
    pub before: (f64, f64),
    /// After.
    pub after: (f64, f64),
}

/// A signal over the samples of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    /// State or input.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Values (SI).
    pub values: Vec<f64>,
}

/// What pushed the rig beside its model, in one equation over one training record.
#[derive(Clone, Debug, PartialEq)]
pub struct Pushed {
    /// Record.
    pub record: String,
    /// Coordinate whose equation it is.
    pub equation: String,
    /// Unit of the disturbance.
    pub unit: String,
    /// Times [s].
    pub t: Vec<f64>,
    /// Smoothed disturbance.
    pub force: Vec<f64>,
    /// Its standard error.
    pub sd: Vec<f64>,
    /// Coordinates, rates and inputs that it may depend on.
    pub against: Vec<Traced>,
}

/// Free runs laid over one output of one record.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlaid {
    /// Record.
    pub record: String,
    /// It is a test record.
    pub held_out: bool,
    /// Output.
    pub signal: String,
    /// Unit.
    pub unit: String,
    /// Times [s].
    pub t: Vec<f64>,
    /// Measured (SI).
    pub measured: Vec<f64>,
    /// The refitted base, as far as its run came (SI).
    pub before: Vec<f64>,
    /// The patched model; `None` without effects.
    pub after: Option<Vec<f64>>,
}

/// Everything.
#[derive(Clone, Debug)]
pub struct Diagnosis {
    /// How it ended.
    pub verdict: Verdict,
    /// Why, in a sentence.
    pub because: String,
    /// What is wrong with the records.
    pub faults: Vec<String>,
    /// Where.
    pub places: Vec<Place>,
    /// Effects.
    pub findings: Vec<Finding>,
    /// All candidates of the first screening.
    pub candidates: Vec<Candidate>,
    /// Smallest p-value of the first screening in its family: the screening's error, where nothing is missing.
    pub screening_p: f64,
    /// The rig as given.
    pub published: Figures,
    /// Refitted.
    pub before: Figures,
    /// With the effects.
    pub after: Figures,
    /// 1 - (after^2 - floor^2)/(before^2 - floor^2) of each signal over the test records.
    pub gap_shrink: Vec<(String, f64)>,
    /// Fitted parameters.
    pub moved: Vec<Moved>,
    /// Noise of the last model.
    pub noise: Option<Noise>,
    /// What to measure next.
    pub next_experiment: Option<String>,
    /// Files of the patched rig: name and text, the rig's own first; empty without effects.
    pub patched: Vec<(String, String)>,
    /// What pushed the rig; empty unless asked for.
    pub pushed: Vec<Pushed>,
    /// Runs; empty unless asked for.
    pub runs: Vec<Overlaid>,
    /// Seconds.
    pub seconds: f64,
}

impl Diagnosis {
    /// Before anything is known.
    pub(crate) fn empty() -> Self {
        Self {
            verdict: Verdict::NoGap,
            because: String::new(),
            faults: Vec::new(),
            places: Vec::new(),
            findings: Vec::new(),
            candidates: Vec::new(),
            screening_p: 1.0,
            published: Figures::default(),
            before: Figures::default(),
            after: Figures::default(),
            gap_shrink: Vec::new(),
            moved: Vec::new(),
            noise: None,
            next_experiment: None,
            patched: Vec::new(),
            pushed: Vec::new(),
            runs: Vec::new(),
            seconds: 0.0,
        }
    }
}
