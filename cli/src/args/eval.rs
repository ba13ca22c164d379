//! Arguments of `rig eval`.

use super::File;
use clap::Args;

/// `rig eval`.
#[derive(Args)]
pub struct Eval {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// A coordinate, rate (`eps.dot`), actuator state (`f_1.lag`) or input; what is not given is 0.
    #[arg(long = "at", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub at: Vec<String>,
    /// Time [s].
    #[arg(long, default_value_t = 0.0)]
    pub time: f64,
}
