//! The innovations form: a model that is disturbed, seen through an extended Kalman filter.
//!
//! A rig on a table is pushed by what no equation names: cables, draughts, teeth of gears. Output error takes all of that for
//! error of measurement, and then finds effects that are not there. Here each coordinate is pushed by a random force with an
//! exponential correlation (Ornstein-Uhlenbeck),
//!
//! ```text
//! x' = f(t, x, u, p; d),   d' = -d/tau + noise,   y = h(t, x, p) + noise,
//! ```
//!
//! and what a sample says beyond the samples before it, its *innovation*, is white where the model is right. Sizes of the noises
//! are those of maximum likelihood ([`Noise`]); parameters minimize the sum of squared whitened innovations, gains of the filter
//! held fixed within a search (L. Ljung, System Identification, 2nd ed., sections 7.4 and 10.3). [`pass`] gives innovations and
//! their derivatives by parameters, delays and other models: what a score test needs.
//!
//! Knows models through [`runtime::Model`] only; the force on a coordinate is a parameter of the model that is zero.

mod ahead;
mod estimate;
mod filter;
mod identify;
mod joint;
mod noise;
mod play;
mod smooth;
mod transition;
mod watched;

pub use ahead::{Ahead, ahead};
pub use estimate::{EstimateOptions, Estimated, TAIL, Unknown, estimate, likelihood};
pub use filter::{Column, Gains, Pass, Shape, Track, pass, wander};
pub use identify::{Driven, InnovationsFit, InnovationsOptions, OutputNoise, Positive, RandomForce, identify};
pub use noise::{Dry, Level, Noise, likeliest};
pub use smooth::{Smoothed, smooth};
pub use watched::unwatched;
