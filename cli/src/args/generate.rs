//! Arguments of `rig generate`.

use super::{File, Language};
use clap::Args;
use std::path::PathBuf;

/// `rig generate`.
#[derive(Args)]
pub struct Generate {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Write the controller of a scenario for this rig, beside the model.
    #[arg(long, value_name = "SCENARIO")]
    pub controller: Option<PathBuf>,
    /// Folder to write to.
    #[arg(long)]
    pub out: PathBuf,
    /// Language.
    #[arg(long, value_enum, default_value = "rust")]
    pub lang: Language,
    /// Write nothing; fail if what stands there is stale.
    #[arg(long)]
    pub check: bool,
    /// Overwrite files that do not carry our header.
    #[arg(long)]
    pub force: bool,
}
