//! Conditions of an experiment, and faults of its records.

use crate::rigs::Bench;
use crate::truth::chance::Chance;
use crate::truth::experiment::{Excitation, Experiment, Pushes, Samples};
use crate::truth::plant::Plant;

/// How an experiment is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Name on the command line and in files.
    pub name: &'static str,
    /// What pushes the rig.
    pub pushes: Pushes,
    /// Their size, in shares of what is strong for the rig.
    pub level: f64,
    /// A regulator is on.
    pub closed: bool,
    /// Share of the usual command.
    pub reach: f64,
    /// Samples of each record, where they are fewer than usual.
    pub samples: Option<usize>,
    /// What is wrong with the records.
    pub fault: Option<Fault>,
}

/// What is wrong with records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Spikes in one sample of a hundred.
    Outliers,
    /// Spikes in one sample of fifty.
    ManyOutliers,
    /// The inputs are those of another run.
    OtherInput,
    /// Inputs shuffled in time.
    Shuffled,
    /// The first output has the wrong sign.
    Flipped,
    /// The last output is dead.
    Dead,
    /// Measured values are those of another rig.
    OtherRig,
    /// Hundred samples.
    Short,
    /// Nothing moves but by a count.
    Quiet,
    /// The training records' joints are pushed by a force that the test record does not have.
    OfTheDay,
}

const fn open(name: &'static str, pushes: Pushes, level: f64) -> Condition {
    Condition { name, pushes, level, closed: false, reach: 1.0, samples: None, fault: None }
}

const fn faulty(name: &'static str, fault: Fault) -> Condition {
    Condition { fault: Some(fault), ..open(name, Pushes::Exponential, 0.01) }
}

/// Conditions with nothing hidden.
pub const NOTHING: [Condition; 10] = [
    open("white", Pushes::None, 0.0),
    open("torque-1", Pushes::Exponential, 0.003),
    open("torque-2", Pushes::Exponential, 0.01),
    open("torque-3", Pushes::Exponential, 0.03),
    open("torque-band", Pushes::Band, 0.01),
    open("torque-levels", Pushes::Levels, 0.01),
    Condition { closed: true, ..open("closed", Pushes::Exponential, 0.01) },
    Condition { reach: 0.1, ..open("low", Pushes::Exponential, 0.003) },
    faulty("outliers", Fault::Outliers),
    faulty("other-input", Fault::OtherInput),
];

/// Faults of records.
pub const BAD: [Condition; 7] = [
    faulty("shuffled", Fault::Shuffled),
    faulty("flipped", Fault::Flipped),
    faulty("dead", Fault::Dead),
    faulty("many-outliers", Fault::ManyOutliers),
    faulty("other-rig", Fault::OtherRig),
    Condition { samples: Some(100), ..faulty("short", Fault::Short) },
    Condition { reach: 1e-4, level: 0.0, ..faulty("quiet", Fault::Quiet) },
];

/// What the first training records have and the test record lacks.
pub const DAY: Condition = faulty("of-the-day", Fault::OfTheDay);

/// Conditions in which effects are hidden.
pub const HIDING: [Condition; 3] = [NOTHING[1], NOTHING[2], NOTHING[6]];

/// One experiment.
#[must_use]
pub fn experiment(bench: &Bench, plant: &Plant, condition: &Condition, excitation: Excitation, samples: usize, seed: u64) -> Samples {
    let mut command = bench.command;
    command.iter_mut().for_each(|c| c.1 *= condition.reach);
    Experiment {
        plant,
        start: bench.start,
        period: bench.period,
        samples,
        command,
        band: bench.band,
        excitation,
        pushes: (condition.pushes, bench.strong.map(|s| s * condition.level)),
        loop_: condition.closed.then_some(bench.regulator),
    }
    .run(seed)
}

/// Makes the records faulty.
pub fn spoil(all: &mut [Samples], other: &[Samples], fault: Fault, chance: &mut Chance) {
    for (k, samples) in all.iter_mut().enumerate() {
        let count = samples.t.len();
        match fault {
            Fault::Outliers | Fault::ManyOutliers => {
                let share = if fault == Fault::Outliers { 0.01 } else { 0.02 };
                for y in &mut samples.y {
                    let (low, high) = y.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
                    for v in y.iter_mut() {
                        if chance.uniform() < share {
                            *v += chance.sign() * chance.between(0.2, 1.5) * (high - low);
                        }
                    }
                }
            }
            Fault::OtherInput => {
                if let Some(other) = other.get(k) {
                    samples.u.clone_from(&other.u);
                    samples.u.iter_mut().for_each(|u| u.truncate(count));
                }
            }
            Fault::Shuffled => {
                for u in &mut samples.u {
                    for i in (1..u.len()).rev() {
                        u.swap(i, chance.index(i + 1));
                    }
                }
            }
            Fault::Flipped => samples.y[0].iter_mut().for_each(|v| *v = -*v),
            Fault::Dead => {
                if let Some(y) = samples.y.last_mut() {
                    y.iter_mut().for_each(|v| *v = 0.0);
                }
            }
            Fault::OtherRig => {
                if let Some(other) = other.get(k) {
                    let from = &other.y;
                    for (i, y) in samples.y.iter_mut().enumerate() {
                        y.clone_from(&from[i % from.len()]);
                        y.truncate(count);
                    }
                }
            }
            Fault::Short | Fault::Quiet | Fault::OfTheDay => {}
        }
    }
}
