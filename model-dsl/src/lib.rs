//! The rig language: text in, checked rig out.
pub mod rig;
pub mod units;
