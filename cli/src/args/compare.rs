//! Arguments of `rig compare`.

use super::Hold;
use clap::Args;
use std::path::PathBuf;

/// `rig compare`.
#[derive(Args)]
pub struct Compare {
    /// Rigs.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// The record.
    #[arg(long, value_name = "RECORD")]
    pub data: PathBuf,
    /// Override a parameter in every rig that has it.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Use the definitions behind lumps instead of their own values.
    #[arg(long)]
    pub expand_lumps: bool,
    /// Initial coordinates and rates, instead of what the record's start says.
    #[arg(long = "at", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub at: Vec<String>,
    /// What logged inputs do between samples.
    #[arg(long, value_enum, default_value = "zero")]
    pub hold: Hold,
}
