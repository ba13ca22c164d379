//! The truth: rigs whose motion is written by hand and integrated with sharp friction, and the records that their sensors make.
//!
//! Shares no code with the side that fits: no model of the language, no derivation, no filter. What is hidden in a rig is a change of
//! its [`plant::Plant`].

pub mod chance;
pub mod experiment;
pub mod mechanics;
pub mod motion;
pub mod plant;

/// Most coordinates of a rig.
pub const MOST: usize = 3;
/// One number for each coordinate (or input, or output); those beyond the rig's own are zero.
pub type Row = [f64; MOST];
