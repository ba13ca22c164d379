//! What a fit says.

use super::identifiability::Identifiable;
use super::minimize::Ending;
use super::whiteness::Whiteness;
use nalgebra::DMatrix;
use sim::{Pattern, Status};

/// A fitted parameter (SI).
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Name.
    pub name: String,
    /// Record, for a parameter that belongs to the day.
    pub record: Option<String>,
    /// Unit, as the rig writes it; values are SI.
    pub unit: String,
    /// Value.
    pub value: f64,
    /// Standard error, corrected for coloured errors; `None` where the records do not tell it or a bound holds it.
    pub std_error: Option<f64>,
    /// 95 % interval.
    pub ci95: Option<(f64, f64)>,
    /// Starting value.
    pub initial: f64,
    /// It stands at one of its bounds.
    pub at_bound: bool,
}

/// A state at the beginning of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct InitialValue {
    /// Record.
    pub record: String,
    /// State.
    pub state: String,
    /// Value (SI).
    pub value: f64,
    /// What the first samples say, with its standard error; `None` where it was no prior. For a rate this is the slope of
    /// the line over the first 0.2 s, which the model's must meet, not the rate at the first sample.
    pub prior: Option<(f64, f64)>,
    /// It was fitted.
    pub free: bool,
}

/// How a free run follows one output of one record.
#[derive(Clone, Debug, PartialEq)]
pub struct SignalFigure {
    /// Output.
    pub signal: String,
    /// 100 (1 - |y - yhat| / |y - mean y|); `None` where the signal is constant.
    pub fit_percent: Option<f64>,
    /// Root-mean-square error (SI).
    pub rmse: Option<f64>,
    /// Fit of holding the rates constant, beside a prediction.
    pub hold: Option<f64>,
}

/// How a free run, or a prediction over a horizon, follows a record.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordFigures {
    /// Record.
    pub record: String,
    /// One entry for each measured output.
    pub signals: Vec<SignalFigure>,
    /// How the run ended.
    pub status: Status,
    /// Time up to which figures are taken [s].
    pub valid_until: f64,
    /// Seconds ahead of a prediction; `None` for a free run.
    pub horizon: Option<f64>,
}

/// The answer of a fit.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Fitted parameters, in the rig's order; those of the day once for each record.
    pub parameters: Vec<Estimate>,
    /// All parameters of the model, those of the day with their starting values.
    pub p: Vec<f64>,
    /// All parameters for each training record.
    pub p_of_record: Vec<Vec<f64>>,
    /// Correlation of the fitted parameters, in the order of `parameters`; zero where one is not told.
    pub correlation: DMatrix<f64>,
    /// Covariance of the fitted parameters, in the same order.
    pub covariance: DMatrix<f64>,
    /// Initial states of the training records.
    pub initial_states: Vec<InitialValue>,
    /// What was minimized, in words.
    pub objective: String,
    /// Its value.
    pub cost: f64,
    /// Scale by which errors of each measured output were divided, by record (SI).
    pub scales: Vec<Vec<(String, f64)>>,
    /// How the search ended.
    pub ending: Ending,
    /// How the intervals were found, in words.
    pub intervals: String,
    /// Samples over which the errors hang together.
    pub memory: f64,
    /// What the records can tell.
    pub identifiable: Identifiable,
    /// Whiteness of the errors.
    pub whiteness: Vec<Whiteness>,
    /// Free runs over the training records, from the fitted initial states.
    pub train: Vec<RecordFigures>,
    /// Free runs over the test records, from the state that their first 0.2 s give; parameters of the day as they started.
    pub test: Vec<RecordFigures>,
    /// The same for the starting values of the parameters, each record from the state that its first 0.2 s give.
    pub before: Vec<RecordFigures>,
    /// The same over the test records.
    pub before_test: Vec<RecordFigures>,
    /// Where the fit started: `nominal`, `equation error`.
    pub started_from: String,
    /// Integration steps of each training record.
    pub patterns: Vec<Pattern>,
    /// Evaluations of the objective, each one run over all training records.
    pub evaluations: usize,
    /// Time [s].
    pub seconds: f64,
    /// Of which the search for the minimum [s].
    pub search_seconds: f64,
}
