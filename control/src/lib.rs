//! Operating points, linear models and the design of linear controllers, of any [`runtime::Model`].
//!
//! Knows models through the trait only; knows nothing of rigs' texts and of files.
#![forbid(unsafe_code)]

mod balance;
mod linear;
mod lyapunov;
mod modes;
mod reach;
mod riccati;
mod schur;
#[cfg(test)]
mod testing;
mod trim;

pub use linear::{LinearModel, LinearizeError, linearize, poles};
pub use lyapunov::{LyapunovError, lyapunov, stein};
pub use modes::{Time, show, who};
pub use reach::{Mode, Reach, gramian, observability, pbh, reachability, rounding};
pub use riccati::{Riccati, RiccatiData, RiccatiError, care, dare, solve as solve_riccati};
pub use schur::{NoConvergence, eigenvalues};
pub use trim::{Trim, TrimError, TrimProblem, Unknown, solve};
