//! The model of a rig inside the process: equations behind the [`runtime::Model`] trait, no compiler needed.
//!
//! Knows equations and the model trait; knows nothing of text, files and records.

mod model;
mod program;

pub use model::InProcess;
