//! Arguments of `rig lqr`.

use super::{File, Language, Point};
use clap::Args;
use std::path::PathBuf;

/// `rig lqr`: u = u* - K (x - x*).
#[derive(Args)]
pub struct Lqr {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Point.
    #[command(flatten)]
    pub point: Point,
    /// Inputs that the regulator moves, mixed ones by their names: `f_s,f_d`.
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub inputs: Vec<String>,
    /// States that are fed back (default: all); the others are taken as constant.
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub states: Vec<String>,
    /// Outputs whose deviation is integrated.
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub integrate: Vec<String>,
    /// Diagonal of Q: one weight for each state, then one for each integral.
    #[arg(long, value_delimiter = ',', value_name = "Q1,Q2", required = true, allow_hyphen_values = true)]
    pub weights_x: Vec<f64>,
    /// Diagonal of R: one weight for each input.
    #[arg(long, value_delimiter = ',', value_name = "R1,R2", required = true, allow_hyphen_values = true)]
    pub weights_u: Vec<f64>,
    /// Sampled controller with this period: `0.005`, `5ms`.
    #[arg(long, value_name = "DT")]
    pub discrete: Option<String>,
    /// With --discrete: minimize the sum over the samples (as `dlqr`) instead of the integral (as `lqrd`).
    #[arg(long, requires = "discrete")]
    pub sum: bool,
    /// A gain at each of a series of points: `name=a:b:n`.
    #[arg(long, value_name = "NAME=A:B:N", allow_hyphen_values = true)]
    pub sweep: Option<String>,
    /// Keep the slope of regularized Coulomb friction.
    #[arg(long)]
    pub friction_slope: bool,
    /// Write A, B, C, D, K and the operating point for MATLAB, Octave or SciPy.
    #[arg(long, value_name = "FILE.mat|FILE.m")]
    pub export: Option<PathBuf>,
    /// Write u = u* - K (x - x*) as code to this folder; over a sweep with interpolated gains.
    #[arg(long, value_name = "DIR")]
    pub generate: Option<PathBuf>,
    /// Language of that.
    #[arg(long, value_enum, default_value = "rust")]
    pub lang: Language,
    /// Write a page with tables and plots (HTML, complete in itself).
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// Overwrite files that are not ours.
    #[arg(long)]
    pub force: bool,
}
