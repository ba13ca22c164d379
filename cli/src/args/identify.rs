//! Arguments of `rig identify`.

use super::{File, Hold};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// How the errors of outputs are made comparable.
#[derive(Clone, Copy, ValueEnum)]
pub enum ErrorWeights {
    /// By their standard deviation, estimated with the parameters.
    Noise,
    /// By the standard deviation of the measured signal.
    Spread,
}

impl From<ErrorWeights> for ident::fit::Weights {
    fn from(weights: ErrorWeights) -> Self {
        match weights {
            ErrorWeights::Noise => Self::Noise,
            ErrorWeights::Spread => Self::Spread,
        }
    }
}

/// What is known of the rates at the start of a record.
#[derive(Clone, Copy, ValueEnum)]
pub enum InitialRates {
    /// The rig is at rest.
    Rest,
    /// The first 0.2 s give a prior.
    Prior,
    /// Nothing: they are fitted.
    Free,
}

impl From<InitialRates> for ident::fit::Known {
    fn from(rates: InitialRates) -> Self {
        match rates {
            InitialRates::Rest => Self::Fixed,
            InitialRates::Prior => Self::Prior,
            InitialRates::Free => Self::Free,
        }
    }
}

/// How `rig identify` fits.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// The model's run is laid over the record, and the errors of the outputs are lowered.
    OutputError,
    /// The differential equations with the measured motion put in: smoothed derivatives (--cutoff) or the weak form (--bump).
    EquationError,
    /// The seed paper's way: rates by an observer or a filter, smoothed by means and differenced, and each coordinate's equation fitted on its
    /// own, by the parameters that act in it and that no equation before has told (--derivative, --bandwidth, --mean).
    Channels,
    /// What each sample says beyond those before it, seen through a Kalman filter: for rigs that random forces drive, or that a controller
    /// holds.
    Innovations,
}

/// Where rates come from.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Derivative {
    /// Luenberger observer: chain of three integrators with poles -w, w (-0.6 +- 0.8 i).
    Observer,
    /// The derivative filter of the paper's eq. 23 with damping 0.9.
    Filter,
}

/// A frequency in hertz, with or without its unit.
fn hertz(text: &str) -> Result<f64, String> {
    text.trim().trim_end_matches("Hz").trim_end().parse().map_err(|_| "a frequency such as `100` or `100Hz` is wanted".to_owned())
}

/// `rig identify`.
#[derive(Args)]
pub struct Identify {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Records to fit to.
    #[arg(long, required = true, num_args = 1.., value_name = "RECORD")]
    pub data: Vec<PathBuf>,
    /// Records that are held out: the fitted model is judged on them too.
    #[arg(long, num_args = 1.., value_name = "RECORD")]
    pub test: Vec<PathBuf>,
    /// Parameters to fit, these and no others (default: those that the rig does not mark as fixed).
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub free: Vec<String>,
    /// Parameters to hold at their values.
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub fix: Vec<String>,
    /// What makes the errors of different outputs comparable.
    #[arg(long, value_enum, default_value = "noise")]
    pub weights: ErrorWeights,
    /// What is known of the initial rates (default: as each record says how it starts).
    #[arg(long, value_enum)]
    pub rates: Option<InitialRates>,
    /// Large errors count less (Huber's loss).
    #[arg(long)]
    pub robust: bool,
    /// How parameters are fitted.
    #[arg(long, value_enum, default_value = "output-error")]
    pub method: Method,
    /// Multiple shooting: pieces of this length [s], held together at their ends.
    #[arg(long, value_name = "SECONDS")]
    pub shooting: Option<f64>,
    /// Short runs of this length [s], each from a fitted state and not held together: for unstable rigs.
    #[arg(long, value_name = "SECONDS", conflicts_with = "shooting")]
    pub windows: Option<f64>,
    /// Judge by predictions this many seconds ahead instead of free runs (default: where the free run says nothing).
    #[arg(long, value_name = "SECONDS")]
    pub horizon: Option<f64>,
    /// Equation error by smoothed derivatives: cut-off of the zero-phase low pass [Hz].
    #[arg(long, value_name = "HZ", value_parser = hertz)]
    pub cutoff: Option<f64>,
    /// Equation error by smoothed derivatives: order of the Butterworth low pass.
    #[arg(long, value_name = "N", default_value_t = 4)]
    pub order: usize,
    /// Equation error by smoothed derivatives: keep every N-th equation, after a second low pass. Innovations: average N samples into
    /// one.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub decimate: usize,
    /// Equation error in weak form: samples of a test function.
    #[arg(long, value_name = "SAMPLES", default_value_t = 40, conflicts_with = "cutoff")]
    pub bump: usize,
    /// Channels: where rates come from.
    #[arg(long, value_enum, default_value = "observer")]
    pub derivative: Derivative,
    /// Channels: bandwidth w of the observer or filter [rad/s].
    #[arg(long, value_name = "RAD/S", default_value_t = 60.0)]
    pub bandwidth: f64,
    /// Channels: samples of the means that smooth rates and accelerations.
    #[arg(long, value_name = "N", default_value_t = 60)]
    pub mean: usize,
    /// What logged inputs do between samples.
    #[arg(long, value_enum, default_value = "zero")]
    pub hold: Hold,
    /// Write a page with tables and plots (HTML, complete in itself).
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// Overwrite a file that is not ours.
    #[arg(long)]
    pub force: bool,
}
