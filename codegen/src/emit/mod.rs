//! Printers: equations to code, a rig to JSON.

mod casadi;

pub use casadi::casadi;
