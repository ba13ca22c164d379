//! Arguments of `rig simulate`.

use super::{File, Hold};
use clap::Args;
use std::path::PathBuf;

/// `rig simulate`.
#[derive(Args)]
pub struct Simulate {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Inputs over time: a record (CSV with `t` and the inputs, or a description file).
    #[arg(long, value_name = "CSV")]
    pub input: PathBuf,
    /// Where the simulated outputs and states go.
    #[arg(long, value_name = "CSV")]
    pub out: PathBuf,
    /// Initial coordinates, rates and actuator states; what is not given is 0.
    #[arg(long = "at", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub at: Vec<String>,
    /// What logged inputs do between samples.
    #[arg(long, value_enum, default_value = "zero")]
    pub hold: Hold,
    /// Show outputs as encoders do: in counts, and wrapped.
    #[arg(long)]
    pub encoders: bool,
    /// Write a page with tables and plots (HTML, complete in itself).
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// Overwrite the output file.
    #[arg(long)]
    pub force: bool,
}
