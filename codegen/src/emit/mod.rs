//! Printers: equations to code, a rig to JSON.
//!
//! Rust and C share everything but spelling: `functions` lists what a model offers, `plan` turns roots
//! into statements, `split` cuts long functions, `form` adds the parentheses, `names` and `vocabulary`
//! know the languages.

mod about;
mod c;
mod casadi;
pub mod controller;
mod declared;
mod form;
mod functions;
mod names;
mod plan;
mod rust;
mod rust_model;
mod split;
mod vocabulary;

pub use c::{CSource, c, c_function};
pub use casadi::casadi;
pub use declared::{FORMAT as DECLARED_FORMAT, declared, declared_fingerprint};
pub use functions::{Function, Output, Shape, Vector, functions};
pub use rust::{rust, rust_function, rust_model_name};
