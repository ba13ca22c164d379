//! Operating points, linear models and the design of linear controllers, of any [`runtime::Model`].
//!
//! Knows models through the trait only; knows nothing of rigs' texts and of files.
#![forbid(unsafe_code)]

mod balance;
mod cascade;
mod closed_loop;
mod discretize;
mod estimator;
mod feedforward;
mod filter;
mod gain;
mod kalman;
mod linear;
mod lqr;
mod lyapunov;
mod modes;
mod observer;
mod placement;
mod plant;
mod reach;
mod riccati;
mod schur;
#[cfg(test)]
mod testing;
mod tracking;
mod trim;
mod weight;

pub use cascade::Cascade;
pub use closed_loop::{Bench, BenchError, Controller, Noise, Run, Signal, Status, Surroundings, run};
pub use discretize::{SampleError, Sampled, SampledCost, sampled_cost, sampled_noise, tustin, zero_order_hold};
pub use estimator::{Estimation, KalmanEstimator, KalmanMatrices, PlantModel};
pub use feedforward::Feedforward;
pub use filter::{DerivativeFilter, Rule, Running, centred_mean, differences, moving_mean};
pub use gain::{Gain, GainError};
pub use kalman::{Kalman, KalmanError, kalman};
pub use linear::{LinearModel, LinearizeError, linearize};
pub use lqr::{Lqr, LqrDesign, LqrError, Sampling, lqr};
pub use lyapunov::{LyapunovError, lyapunov, stein};
pub use modes::{Time, show, who};
pub use observer::{AngleObserver, Observer};
pub use placement::{Placed, PlacementError, place, place_observer};
pub use plant::{Coupling, NameError, Plant};
pub use reach::{Mode, Reach, gramian, observability, pbh, reachability, rounding};
pub use riccati::{Riccati, RiccatiData, RiccatiError, care, dare, solve as solve_riccati};
pub use schur::{NoConvergence, eigenvalues};
pub use tracking::{Holding, InnerRate, Operating, Reference, Setup, Tracking, TrackingError, Trajectory};
pub use trim::{Trim, TrimError, TrimProblem, Unknown, solve};
pub use weight::{Weight, WeightError, Weighted};
