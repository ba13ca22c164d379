//! Arguments of `rig linearize`.

use super::{File, Point};
use clap::Args;
use std::path::PathBuf;

/// `rig linearize`.
#[derive(Args)]
pub struct Linearize {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Point.
    #[command(flatten)]
    pub point: Point,
    /// Inputs of the linear model, mixed ones by their names: `f_s,f_d`.
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub inputs: Vec<String>,
    /// A series of points: `name=a:b:n`.
    #[arg(long, value_name = "NAME=A:B:N", allow_hyphen_values = true)]
    pub sweep: Option<String>,
    /// Keep the slope of regularized Coulomb friction.
    #[arg(long)]
    pub friction_slope: bool,
    /// Write A, B, C, D and the operating point for MATLAB, Octave or SciPy.
    #[arg(long, value_name = "FILE.mat|FILE.m")]
    pub export: Option<PathBuf>,
    /// Write a page with tables and plots (HTML, complete in itself).
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// Overwrite a file that is not ours.
    #[arg(long)]
    pub force: bool,
}
