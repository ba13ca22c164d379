//! The model of a rig inside the process: equations behind the [`runtime::Model`] trait, no compiler needed.
//!
//! Knows equations and the model trait; knows nothing of text, files and records. `tape` orders the operations
//! (and interprets them: the reference), `compile` makes machine code of them, `native` owns and calls it,
//! `program` decides which of the two runs, `model` puts programs behind the trait.
#![deny(unsafe_op_in_unsafe_fn)]

mod compile;
mod model;
mod native;
mod program;
mod selection;
mod tape;

pub use compile::NoCode;
pub use model::InProcess;
pub use program::Evaluation;
