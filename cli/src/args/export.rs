//! Arguments of `rig export`.

use super::File;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Targets of an export.
#[derive(Clone, Copy, ValueEnum)]
pub enum Target {
    /// The derived equations as a Python module for CasADi.
    Casadi,
    /// The declared rig: bodies, joints, forces, assumptions.
    Json,
    /// The derived equations.
    Latex,
}

/// `rig export`.
#[derive(Args)]
pub struct Export {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// What to write.
    #[arg(long, value_enum)]
    pub to: Target,
    /// File to write to (default: the rig's name beside the current folder, with the target's ending).
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Overwrite a file that stands there.
    #[arg(long)]
    pub force: bool,
}
