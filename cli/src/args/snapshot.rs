//! Arguments of `rig snapshot`.

use super::File;
use clap::Args;
use std::path::PathBuf;

/// `rig snapshot`.
#[derive(Args)]
pub struct Snapshot {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Write nothing; show what changed since the snapshot, and fail if anything did.
    #[arg(long)]
    pub check: bool,
    /// The snapshot's file (default: beside the rig, with the ending `.snapshot.txt`).
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Overwrite a file that this program did not write.
    #[arg(long)]
    pub force: bool,
}
