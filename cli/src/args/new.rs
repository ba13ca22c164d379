//! Arguments of `rig new`.

use clap::Args;
use std::path::PathBuf;

/// `rig new`.
#[derive(Args)]
pub struct New {
    /// Name of the rig, as in `Heli`; the file is its name in small letters.
    #[arg(required_unless_present = "example", conflicts_with = "example")]
    pub name: Option<String>,
    /// The record whose columns become inputs, coordinates and outputs.
    #[arg(long, value_name = "RECORD", required_unless_present = "example", conflicts_with = "example")]
    pub data: Option<PathBuf>,
    /// Columns that are inputs (default: guessed from names and units).
    #[arg(long, value_delimiter = ',', value_name = "A,B", conflicts_with = "example")]
    pub inputs: Vec<String>,
    /// An example rig instead, with the rigs that it extends; without a name: list the examples.
    #[arg(long, value_name = "EXAMPLE", num_args = 0..=1)]
    pub example: Option<Option<String>>,
    /// File to write (default: `NAME.rig`); nothing is ever overwritten.
    #[arg(long, value_name = "RIG")]
    pub out: Option<PathBuf>,
}
