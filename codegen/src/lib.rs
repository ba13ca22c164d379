//! From a checked rig to equations, and from equations to text and code.
//!
//! `expr` is the symbolic core; `lower` puts a rig's expressions onto it; `mechanics` derives;
//! `derive` strings the passes together and hands out [`Equations`]; `display` writes them as a
//! person would; `emit` prints code. Never prints to a terminal, never reads files.
#![forbid(unsafe_code)]

mod derive;
pub mod display;
pub mod emit;
mod equations;
pub mod expr;
mod lower;
mod manifold;
mod mechanics;
mod numbers;
mod operating;
mod regressor;
mod time_function;

pub use derive::{DeriveError, Options, derive};
pub use equations::{CrossCheck, Equations, Layout, Linear, OutputPath, OutputVariable, Variable};
pub use lower::Lumps;
pub use manifold::{Manifold, NoManifold, manifold};
pub use numbers::{Definitions, Numbers, definitions};
pub use operating::{Direction, OperatingPoint, direction_by_name, operating_points};
pub use regressor::{Column, Regressor, regressor};
pub use time_function::TimeFunction;
