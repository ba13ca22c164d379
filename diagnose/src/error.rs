//! Why there is no diagnosis. What a diagnosis says, bad records included, is an answer.

use crate::patch::PatchError;
use ident::fit::FitError;
use std::fmt;

/// Why there is no diagnosis.
#[derive(Clone, Debug, PartialEq)]
pub enum DiagnoseError {
    /// The base cannot be fitted or followed.
    Fit(FitError),
    /// The base's text cannot be patched.
    Patch(PatchError),
    /// There is no record to judge on.
    NoTest,
    /// An effect that is not in the catalogue.
    UnknownEffect {
        /// As asked for.
        name: String,
        /// All ids.
        known: Vec<String>,
    },
}

impl fmt::Display for DiagnoseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fit(e) => e.fmt(f),
            Self::Patch(e) => e.fmt(f),
            Self::NoTest => f.write_str(
                "no test record: an effect is accepted only if it helps on a record that it was not found on; give one with --test, with other excitation than the training records",
            ),
            Self::UnknownEffect { name, known } => write!(f, "there is no effect `{name}`; the catalogue has {}", known.join(", ")),
        }
    }
}

impl std::error::Error for DiagnoseError {}

impl From<FitError> for DiagnoseError {
    fn from(e: FitError) -> Self {
        Self::Fit(e)
    }
}

impl From<PatchError> for DiagnoseError {
    fn from(e: PatchError) -> Self {
        Self::Patch(e)
    }
}
