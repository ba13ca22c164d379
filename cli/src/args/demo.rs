//! Arguments of `rig demo`.

use clap::Args;
use std::path::PathBuf;

/// `rig demo`.
#[derive(Args)]
pub struct Demo {
    /// Folder for the rig and the record.
    #[arg(long, default_value = "rig-demo")]
    pub out: PathBuf,
    /// Overwrite files of these names that are not ours.
    #[arg(long)]
    pub force: bool,
}
