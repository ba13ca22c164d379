//! Arguments of `rig preflight`.

use super::{File, Hold};
use clap::Args;
use std::path::PathBuf;

/// `rig preflight`.
#[derive(Args)]
pub struct Preflight {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Records.
    #[arg(long, required = true, num_args = 1.., value_name = "RECORD")]
    pub data: Vec<PathBuf>,
    /// What logged inputs do between samples.
    #[arg(long, value_enum, default_value = "zero")]
    pub hold: Hold,
}
