//! Arguments of `rig show`.

use super::File;
use clap::Args;

/// `rig show`.
#[derive(Args)]
pub struct Show {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// LaTeX instead of text.
    #[arg(long)]
    pub latex: bool,
    /// The full derivation, before the declared assumptions.
    #[arg(long)]
    pub full: bool,
}
