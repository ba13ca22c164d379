//! Operating points, linear models and the design of linear controllers, of any [`runtime::Model`].
//!
//! Knows models through the trait only; knows nothing of rigs' texts and of files.
#![forbid(unsafe_code)]

mod balance;
mod discretize;
mod linear;
mod lqr;
mod lyapunov;
mod modes;
mod plant;
mod reach;
mod riccati;
mod schur;
#[cfg(test)]
mod testing;
mod trim;
mod weight;

pub use discretize::{SampleError, Sampled, SampledCost, sampled_cost, sampled_noise, tustin, zero_order_hold};
pub use linear::{LinearModel, LinearizeError, linearize, poles};
pub use lqr::{Lqr, LqrDesign, LqrError, Sampling, lqr};
pub use lyapunov::{LyapunovError, lyapunov, stein};
pub use modes::{Time, show, who};
pub use plant::{Coupling, NameError, Plant};
pub use reach::{Mode, Reach, gramian, observability, pbh, reachability, rounding};
pub use riccati::{Riccati, RiccatiData, RiccatiError, care, dare, solve as solve_riccati};
pub use schur::{NoConvergence, eigenvalues};
pub use trim::{Trim, TrimError, TrimProblem, Unknown, solve};
pub use weight::{Weight, WeightError, Weighted};
