//! Arguments of `rig diff`.

use clap::Args;
use std::path::PathBuf;

/// `rig diff`.
#[derive(Args)]
pub struct Diff {
    /// First rig.
    pub first: PathBuf,
    /// Second rig.
    pub second: PathBuf,
}
