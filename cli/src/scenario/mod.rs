//! Scenarios of `rig closed-loop`: a file's text to a rig, a controller and what comes from outside.

mod build;
mod code;
mod controller;
mod file;
mod source;

pub use build::{Machine, Scenario};
pub use code::code;
pub use controller::{Built, build};
pub use source::Source;
