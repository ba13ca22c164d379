//! Arguments of `rig trim`.

use super::{File, Point};
use clap::Args;

/// `rig trim`.
#[derive(Args)]
pub struct Trim {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Point.
    #[command(flatten)]
    pub point: Point,
}
