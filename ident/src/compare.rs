//! A model's free run laid over a measured record; where that says nothing, a prediction over a short horizon.

mod growth;
pub(crate) mod initial;
mod prediction;
pub(crate) mod series;

pub use initial::{INITIAL_WINDOW, initial_state};
pub use prediction::{Prediction, PredictionFit};
pub use series::{fit_percent, rmse};

use crate::record::{Bound, MatchError, Record, Start, bind};
use runtime::Model;
use sim::{Hold, Signals, SimError, Status, Trajectory, simulate};
use std::fmt;

/// Choices of a comparison.
#[derive(Clone, Debug)]
pub struct CompareOptions {
    /// How the rig stood at the first sample; `None`: as the record says.
    pub start: Option<Start>,
    /// Initial states that are known: (state, value in SI), instead of what the record's start says.
    pub initial: Vec<(usize, f64)>,
    /// What logged inputs do between samples.
    pub hold: Hold,
    /// Tolerances and limits of the run.
    pub simulation: sim::Options,
    /// Predict this many seconds ahead too, whether or not the free run is sensitive [s].
    pub horizon: Option<f64>,
    /// Most starts of predictions along a record.
    pub starts: usize,
}

impl Default for CompareOptions {
    fn default() -> Self {
        let simulation = sim::Options::default();
        Self { start: None, initial: Vec::new(), hold: Hold::default(), simulation, horizon: None, starts: 400 }
    }
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
    /// Prediction over a horizon; there where the free run amplifies errors of its initial state by more than
    /// [`SENSITIVE`], or where it was asked for.
    pub prediction: Option<Prediction>,
}

/// Growth of d x(t)/d x(t_0), states in parts of the ranges that the record moves them through, beyond which a free run says nothing of the
/// model.
pub const SENSITIVE: f64 = 1e4;

/// One line of a table: the figures that count for an output.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Name of the output, or of its rate.
    pub name: String,
    /// Fit in percent.
    pub fit_percent: Option<f64>,
    /// Root-mean-square error (SI).
    pub rmse: Option<f64>,
    /// Fit of holding the rates constant, beside a prediction.
    pub hold: Option<f64>,
}

impl Comparison {
    /// The figures that count: those of the prediction where there is one, otherwise those of the free run.
    #[must_use]
    pub fn figures(&self) -> Vec<Figure> {
        match &self.prediction {
            Some(prediction) => prediction
                .signals
                .iter()
                .map(|s| Figure { name: s.name.clone(), fit_percent: s.fit_percent, rmse: s.rmse, hold: s.hold })
                .collect(),
            None => {
                self.signals.iter().map(|s| Figure { name: s.name.clone(), fit_percent: s.fit_percent, rmse: s.rmse, hold: None }).collect()
            }
        }
    }

    /// Seconds ahead of the figures; `None` for a free run.
    #[must_use]
    pub fn horizon(&self) -> Option<f64> {
        self.prediction.as_ref().map(|p| p.horizon)
    }
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
    if let Some(h) = options.horizon
        && !(h > 0.0 && h.is_finite())
    {
        return Err(CompareError::Simulation(SimError::Option { what: "the horizon", value: h }));
    }
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
    let horizon = options.horizon.or_else(|| sensible_horizon(model, p, record, &outputs, &signals, &trajectory));
    let prediction = horizon.map(|h| prediction::predict(model, p, &record.t, &outputs, &signals, h, options)).transpose()?;
    let signals = outputs
        .into_iter()
        .enumerate()
        .filter_map(|(i, measured)| {
            let measured = measured?;
            let simulated = trajectory.output(i);
            let reached = &measured[..simulated.len()];
            let (fit_percent, rmse) = (fit_percent(reached, &simulated), rmse(reached, &simulated));
            Some(SignalFit { name: names.output(i).to_owned(), fit_percent, rmse, measured, simulated })
        })
        .collect();
    Ok(Comparison { signals, status: trajectory.status.clone(), valid_until: trajectory.valid_until, initial, trajectory, prediction })
}

/// Where the model amplifies by [`SENSITIVE`], along its free run or along the measured states (an unstable rig's free run
/// falls to where it is stable): a quarter of the time that this takes, over which it amplifies about tenfold. A run into
/// a singular mass matrix is compared up to there: there a model is wrong, not sensitive.
fn sensible_horizon(
    model: &dyn Model,
    p: &[f64],
    record: &Record,
    outputs: &[Option<Vec<f64>>],
    signals: &Signals,
    run: &Trajectory,
) -> Option<f64> {
    /// Most samples that are looked at.
    const LOOKS: usize = 2000;
    if matches!(run.status, Status::Singular { .. }) {
        return None;
    }
    let t = &record.t;
    let stride = t.len().div_ceil(LOOKS);
    let some: Vec<usize> = (0..t.len()).step_by(stride).collect();
    let times = |samples: &[usize]| samples.iter().map(|&k| t[k]).collect::<Vec<f64>>();
    let measured: Vec<Vec<f64>> = some
        .iter()
        .map(|&k| initial::state_from(model, p, t[k], &series::smoothed(t, outputs, k, prediction::WINDOW), &signals.at(t[k])))
        .collect();
    let ranges = growth::ranges(model, p, t[0], &measured);
    let beyond = (ranges.as_slice(), SENSITIVE);
    let along_record = growth::time_of_growth(model, p, signals, &times(&some), &|k| measured[k].clone(), beyond);
    let reached: Vec<usize> = some.iter().copied().filter(|&k| k < run.t.len()).collect();
    let along_run = growth::time_of_growth(model, p, signals, &times(&reached), &|k| run.state(reached[k]).to_vec(), beyond);
    let time = [along_record, along_run].into_iter().flatten().min_by(f64::total_cmp)? - t[0];
    let shortest = 2.0 * record.period();
    Some(prediction::round_down(0.25 * time).max(shortest).min(0.5 * record.duration()))
}

/// The unit is one of angles.
pub(crate) fn is_angle(unit: &str) -> bool {
    matches!(unit, "rad" | "deg" | "turn" | "rev" | "mrad")
}
