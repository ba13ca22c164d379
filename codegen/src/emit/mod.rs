//! Printers: equations to code, a rig to JSON.

mod casadi;
mod declared;

pub use casadi::casadi;
pub use declared::{FORMAT as DECLARED_FORMAT, declared, declared_fingerprint};
