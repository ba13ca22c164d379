//! Arguments of `rig diagnose`.

use super::{File, Hold};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Steps after which a diagnosis can stop.
#[derive(Clone, Copy, ValueEnum)]
pub enum Steps {
    /// Quality of the records.
    Preflight,
    /// Base fit, and where it disagrees.
    Where,
    /// First screening.
    Screen,
    /// All.
    Patch,
}

/// `rig diagnose`.
#[derive(Args)]
pub struct Diagnose {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Records in which the gap is looked for.
    #[arg(long, required = true, num_args = 1.., value_name = "RECORD")]
    pub data: Vec<PathBuf>,
    /// Records on which an effect must help to be accepted; another experiment, with other excitation.
    #[arg(long, num_args = 1.., value_name = "RECORD")]
    pub test: Vec<PathBuf>,
    /// Parameters to fit, these and no others (default: those that the rig does not mark as fixed).
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub free: Vec<String>,
    /// Parameters to hold at their values.
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub fix: Vec<String>,
    /// Folder for the patched rig and the report.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Overwrite files in it that this program did not write.
    #[arg(long)]
    pub force: bool,
    /// Stop after this step.
    #[arg(long, value_enum, default_value = "patch")]
    pub steps: Steps,
    /// Only these effects of the catalogue.
    #[arg(long, value_delimiter = ',', value_name = "ID,ID")]
    pub effects: Vec<String>,
    /// Effects of your own: a TOML file of `[[effect]]` tables (see docs/diagnosis.md).
    #[arg(long, value_name = "TOML")]
    pub catalogue: Option<PathBuf>,
    /// Seed of the draws behind the family's threshold.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// What logged inputs do between samples.
    #[arg(long, value_enum, default_value = "zero")]
    pub hold: Hold,
}
