//! A model's free run laid over a measured record.

pub(crate) mod initial;
pub(crate) mod series;

pub use initial::{INITIAL_WINDOW, initial_state};
pub use series::{fit_percent, rmse};

use crate::record::{Bound, MatchError, Record, Start, bind};
use runtime::Model;
use sim::{Hold, SimError, Status, Trajectory, simulate};
use std::fmt;

/// Choices of a comparison.
#[derive(Clone, Debug, Default)]
pub struct CompareOptions {
    /// How the rig stood at the first sample; `None`: as the record says.
    pub start: Option<Start>,
    /// Initial states that are known: (state, value in SI), instead of what the record's start says.
    pub initial: Vec<(usize, f64)>,
    /// What logged inputs do between samples.
    pub hold: Hold,
    /// Tolerances and limits of the run.
    pub simulation: sim::Options,
}

/// Measured and simulated values of one output, and how well they agree.
#[derive(Clone, Debug)]
pub struct SignalFit {
    /// Name of the output.
    pub name: String,
    /// Measured values at the record's times, angles unwrapped (SI).
    pub measured: Vec<f64>,
    /// Simulated values, as far as the run came (SI).
    pub simulated: Vec<f64>,
    /// 100 (1 - |y - yhat| / |y - mean y|) over the times that the run reached; `None` where the signal is constant.
    pub fit_percent: Option<f64>,
    /// Root-mean-square difference (SI).
    pub rmse: Option<f64>,
}

/// A free run over a record.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// One entry for each measured output of the model.
    pub signals: Vec<SignalFit>,
    /// How the run ended.
    pub status: Status,
    /// Time up to which the run is valid [s]; figures are over the samples up to it.
    pub valid_until: f64,
    /// The initial state that was used.
    pub initial: Vec<f64>,
    /// The run.
    pub trajectory: Trajectory,
}

/// Why there is no comparison.
#[derive(Clone, Debug, PartialEq)]
pub enum CompareError {
    /// The record does not fit the model.
    Match(MatchError),
    /// The simulation's arguments are wrong.
    Simulation(SimError),
}

impl fmt::Display for CompareError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Match(e) => e.fmt(f),
            Self::Simulation(e) => e.fmt(f),
        }
    }
}

impl std::error::Error for CompareError {}

impl From<MatchError> for CompareError {
    fn from(e: MatchError) -> Self {
        Self::Match(e)
    }
}

impl From<SimError> for CompareError {
    fn from(e: SimError) -> Self {
        Self::Simulation(e)
    }
}

/// Runs the model freely from the record's initial state and compares.
///
/// # Errors
/// [`CompareError`], one variant a cause. A run that ends early is none: see [`Comparison::status`].
pub fn compare(model: &dyn Model, p: &[f64], record: &Record, options: &CompareOptions) -> Result<Comparison, CompareError> {
    let Bound { signals, mut outputs, .. } = bind(record, model, options.hold)?;
    let names = model.names();
    for (i, values) in outputs.iter_mut().enumerate() {
        if is_angle(names.output_unit(i)) {
            values.iter_mut().for_each(|v| series::unwrap(v));
        }
    }
    let start = options.start.unwrap_or(record.start);
    let mut initial = initial_state(model, p, &record.t, &outputs, &signals.at(record.t[0]), start);
    for &(i, value) in &options.initial {
        if let Some(x) = initial.get_mut(i) {
            *x = value;
        }
    }
    let trajectory = simulate(model, p, &initial, &signals, &record.t, &options.simulation)?;
    let signals = outputs
        .into_iter()
        .enumerate()
        .filter_map(|(i, measured)| {
            let measured = measured?;
            let simulated = trajectory.output(i);
            let reached = &measured[..simulated.len()];
            Some(SignalFit {
                name: names.output(i).to_owned(),
                fit_percent: fit_percent(reached, &simulated),
                rmse: rmse(reached, &simulated),
                measured,
                simulated,
            })
        })
        .collect();
    Ok(Comparison { signals, status: trajectory.status.clone(), valid_until: trajectory.valid_until, initial, trajectory })
}

/// The unit is one of angles.
pub(crate) fn is_angle(unit: &str) -> bool {
    matches!(unit, "rad" | "deg" | "turn" | "rev" | "mrad")
}
