//! Arguments of `rig closed-loop`.

use clap::Args;
use std::path::PathBuf;

/// `rig closed-loop`.
#[derive(Args)]
pub struct ClosedLoop {
    /// The scenario (`.toml`).
    pub scenario: PathBuf,
    /// Where all signals go: a record with inputs, outputs as read, states, references.
    #[arg(long, value_name = "CSV")]
    pub out: PathBuf,
    /// Another value for a key of the scenario, as TOML: `encoders=false`, `controller.integrate=["eps"]`.
    #[arg(long = "with", value_name = "KEY=VALUE")]
    pub with: Vec<String>,
    /// Write a page with tables and plots (HTML, complete in itself).
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// Overwrite the output file.
    #[arg(long)]
    pub force: bool,
}
