//! Arguments of `rig fit-map`.

use clap::Args;
use std::path::PathBuf;

/// `rig fit-map`.
#[derive(Args)]
pub struct FitMap {
    /// Pairs: CSV with a header, abscissa then ordinate, units in brackets (`V [V], f [N]`).
    pub pairs: PathBuf,
    /// One form instead of the choice among all.
    #[arg(long, value_name = "FORM")]
    pub form: Option<String>,
    /// Evaluate the inverse at these ordinates.
    #[arg(long, value_delimiter = ',', value_name = "Y1,Y2", allow_hyphen_values = true)]
    pub invert: Vec<f64>,
}
