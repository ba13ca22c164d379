//! Arguments of `rig base-parameters`.

use super::File;
use clap::Args;

/// `rig base-parameters`.
#[derive(Args)]
pub struct BaseParameters {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Parameters that count as known when relations are looked for (default: constants, and lengths marked as fixed).
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub known: Option<Vec<String>>,
    /// Seed of the random states.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
}
