//! Arguments of `rig excite`.

use super::{File, Point};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Shapes of a proposed input.
#[derive(Clone, Copy, ValueEnum)]
pub enum Shape {
    /// Sines of different frequencies on each input, with seeded phases.
    Multisine,
    /// Steps up and down, then a sweep of the frequency.
    Steps,
}

/// `rig excite`.
#[derive(Args)]
pub struct Excite {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Point about which the rig is excited.
    #[command(flatten)]
    pub point: Point,
    /// Length of the record [s].
    #[arg(long, default_value_t = 30.0, value_name = "SECONDS")]
    pub duration: f64,
    /// Samples per second.
    #[arg(long, default_value_t = 100.0, value_name = "HZ")]
    pub rate: f64,
    /// Shape.
    #[arg(long, value_enum, default_value = "multisine")]
    pub shape: Shape,
    /// How far a coordinate may go from the point: `name=value` with an optional unit (default: half way to the end of its
    /// range; 20 deg, or 0.1 m, where it has none).
    #[arg(long = "within", value_name = "NAME=VALUE")]
    pub within: Vec<String>,
    /// Seed of the phases.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Where the input goes.
    #[arg(long, value_name = "CSV")]
    pub out: PathBuf,
    /// Overwrite the output file.
    #[arg(long)]
    pub force: bool,
}
