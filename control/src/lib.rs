//! Operating points and linear models, of any [`runtime::Model`].
//!
//! Knows models through the trait only; knows nothing of rigs' texts and of files.
#![forbid(unsafe_code)]

mod linear;
mod trim;

pub use linear::{LinearModel, LinearizeError, linearize, poles};
pub use trim::{Trim, TrimError, TrimProblem, Unknown, solve};
