//! Arguments of `rig draw`.

use super::{File, Point};
use clap::Args;
use std::path::PathBuf;

/// `rig draw`.
#[derive(Args)]
pub struct Draw {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Pose (default: every joint somewhat moved, so that it can be seen).
    #[command(flatten)]
    pub point: Point,
    /// The picture (default: beside the rig, with the ending `.svg`).
    #[arg(long, value_name = "SVG")]
    pub out: Option<PathBuf>,
    /// Overwrite a file that this program did not write.
    #[arg(long)]
    pub force: bool,
}
