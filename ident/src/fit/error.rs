//! Why there is no fit. How a fit ended that was begun is an [`Ending`](super::Ending), not an error.

use crate::record::MatchError;
use sim::{SimError, Status};
use std::fmt;

/// Why a fit was not begun or has no result.
#[derive(Clone, Debug, PartialEq)]
pub enum FitError {
    /// There is no record.
    NoRecord,
    /// A record does not fit the model.
    Match(MatchError),
    /// The arguments of a run are wrong.
    Simulation(SimError),
    /// Nothing is left to be fitted.
    NothingFree,
    /// A name that is no parameter of the rig.
    UnknownParameter {
        /// The name.
        name: String,
        /// A parameter with nearly this name.
        near: Option<String>,
    },
    /// A constant that was asked to be free.
    Constant {
        /// The name.
        name: String,
    },
    /// A name that is no measured output of the records.
    UnknownOutput {
        /// The name.
        name: String,
        /// The measured outputs.
        measured: Vec<String>,
    },
    /// A number that must be positive is not.
    NotPositive {
        /// What.
        what: String,
        /// Its value.
        value: f64,
    },
    /// A starting value outside of its bounds.
    OutsideBounds {
        /// Parameter.
        name: String,
        /// Its value (SI).
        value: f64,
        /// Bounds (SI).
        bounds: (f64, f64),
    },
    /// A value, prior or bound that is not a number.
    NotFinite {
        /// What.
        what: String,
    },
    /// The measured signal never changes: nothing can be weighted by its spread.
    Constantly {
        /// Record.
        file: String,
        /// Output.
        output: String,
    },
    /// Fewer samples than unknowns.
    TooFewSamples {
        /// Samples of all measured outputs.
        samples: usize,
        /// Unknowns.
        unknowns: usize,
    },
    /// The model cannot be run over a record from any of the starting values.
    NoStart {
        /// Record.
        file: String,
        /// What the run from the nominal values came to; `None` where it came to its end, but with errors that are no finite
        /// numbers.
        status: Option<Status>,
    },
    /// Equation error needs what the records do not hold.
    EquationError {
        /// What is missing, as a sentence.
        why: String,
    },
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoRecord => f.write_str("there is no record to fit to; name one with `--data`"),
            Self::Match(e) => e.fmt(f),
            Self::Simulation(e) => e.fmt(f),
            Self::NothingFree => f.write_str(
                "every parameter is fixed, so there is nothing to fit; free some with `--free NAME,NAME` or take the word `fixed` out of the rig",
            ),
            Self::UnknownParameter { name, near } => {
                write!(f, "`{name}` is no parameter of this rig")?;
                match near {
                    Some(near) => write!(f, "; is it `{near}`?"),
                    None => Ok(()),
                }
            }
            Self::Constant { name } => {
                write!(f, "`{name}` is a `const` and cannot be fitted; declare it as `param {name}` if it should be")
            }
            Self::UnknownOutput { name, measured } => {
                write!(f, "`{name}` is no measured output; measured are {}", measured.join(", "))
            }
            Self::NotPositive { what, value } => write!(f, "{what} must be a positive number, not {value}"),
            Self::OutsideBounds { name, value, bounds: (lo, hi) } => {
                write!(f, "the starting value {value} of `{name}` is outside of its bounds {lo} .. {hi}")
            }
            Self::NotFinite { what } => write!(f, "{what} is not a finite number"),
            Self::Constantly { file, output } => write!(
                f,
                "{file}: `{output}` never changes, so it cannot be weighted by its spread; leave it out of the record or give its weight"
            ),
            Self::TooFewSamples { samples, unknowns } => write!(
                f,
                "{samples} samples cannot tell {unknowns} unknowns (parameters and initial states); fix some parameters or use a longer record"
            ),
            Self::NoStart { file, status: Some(status) } => write!(
                f,
                "{file}: the model cannot be run over this record from the starting values: {status}; start nearer, or in pieces with multiple shooting"
            ),
            Self::NoStart { file, status: None } => write!(
                f,
                "{file}: from the starting values the errors over this record are not finite numbers; look at the sizes of the starting values (`--set`) and of the recorded signals (units)"
            ),
            Self::EquationError { why } => write!(f, "there are no estimates from equation error: {why}"),
        }
    }
}

impl std::error::Error for FitError {}

impl From<MatchError> for FitError {
    fn from(e: MatchError) -> Self {
        Self::Match(e)
    }
}

impl From<SimError> for FitError {
    fn from(e: SimError) -> Self {
        Self::Simulation(e)
    }
}
