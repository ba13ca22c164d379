//! The command line: what can be asked, and how. Wrong usage ends with exit code 2.

use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Rig text in, models out.
#[derive(Parser)]
#[command(name = "rig", version, about, max_term_width = 100)]
pub struct Arguments {
    /// One JSON document on standard output, and nothing else there.
    #[arg(long, global = true)]
    pub json: bool,
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// Subcommands.
#[derive(Subcommand)]
pub enum Command {
    /// Parse a rig; check names, units and mechanics.
    Check(File),
    /// Print the equations as a person writes them.
    Show(Show),
    /// Numbers at one state: M, bias, forces, accelerations, Jacobians.
    Eval(Eval),
    /// What one model has and the other lacks, term by term.
    Diff(Diff),
    /// Write the model as Rust or C.
    Generate(Generate),
    /// Write the declared rig (json) or the derived equations (casadi, latex).
    Export(Export),
    /// Find an operating point.
    Trim(Trim),
    /// Linear models at operating points.
    Linearize(Linearize),
    /// Linear-quadratic regulator at an operating point.
    Lqr(Lqr),
    /// Simulate a rig under inputs from a record.
    Simulate(Simulate),
    /// Simulate a rig under a sampled controller with encoders and limits, as a scenario file says.
    ClosedLoop(ClosedLoop),
    /// Lay free runs of rigs over a measured record.
    Compare(Compare),
    /// Facts and faults of measured records, before anything is fitted to them.
    Preflight(Preflight),
    /// Start a rig from a record's header.
    New(New),
    /// Propose a first input within the limits, and say what it would tell.
    Excite(Excite),
    /// Fit a static map (voltage to thrust) to pairs, and invert it.
    FitMap(FitMap),
    /// Fit a rig's parameters to measured records.
    Identify(Identify),
    /// Find where simulation and record disagree, name the missing effect, and show the gap shrink.
    Diagnose(Diagnose),
    /// The fewest combinations of parameters that the equations depend on, and relations between lumps.
    BaseParameters(BaseParameters),
    /// Draw the tree of frames and bodies at a pose, as SVG.
    Draw(Draw),
    /// Keep equations, operation counts and linear models beside a rig, and show what a change did.
    Snapshot(Snapshot),
    /// The whole chain on a rig and a record that the program carries with it.
    Demo(Demo),
}

/// A rig file and changes of its parameters.
#[derive(Args, Clone)]
pub struct File {
    /// The rig (`.rig`).
    pub file: PathBuf,
    /// Which rig of the file (default: the last one).
    #[arg(long, value_name = "NAME")]
    pub rig: Option<String>,
    /// Override a parameter: `name=value`, with an optional unit (`theta0=5deg`).
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Use the definitions behind lumps instead of their own values.
    #[arg(long)]
    pub expand_lumps: bool,
}

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

/// An operating point.
#[derive(Args, Clone)]
pub struct Point {
    /// Named trim of the rig (default: its first one).
    #[arg(long, value_name = "NAME")]
    pub trim: Option<String>,
    /// A coordinate, rate or input of the operating point. Giving what the trim would solve for takes
    /// the point as it is, without solving.
    #[arg(long = "at", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub at: Vec<String>,
}

/// `rig trim`.
#[derive(Args)]
pub struct Trim {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Point.
    #[command(flatten)]
    pub point: Point,
}

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

/// What a logged input does between its samples.
#[derive(Clone, Copy, ValueEnum)]
pub enum Hold {
    /// Keeps the last sample, as a digital-to-analogue converter does.
    Zero,
    /// Goes straight from sample to sample.
    First,
}

impl From<Hold> for sim::Hold {
    fn from(hold: Hold) -> Self {
        match hold {
            Hold::Zero => Self::Zero,
            Hold::First => Self::First,
        }
    }
}

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

/// `rig simulate`.
#[derive(Args)]
pub struct Simulate {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Inputs over time: a record (CSV with `t` and the inputs, or a description file).
    #[arg(long, value_name = "CSV")]
    pub input: PathBuf,
    /// Where the simulated outputs and states go.
    #[arg(long, value_name = "CSV")]
    pub out: PathBuf,
    /// Initial coordinates, rates and actuator states; what is not given is 0.
    #[arg(long = "at", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub at: Vec<String>,
    /// What logged inputs do between samples.
    #[arg(long, value_enum, default_value = "zero")]
    pub hold: Hold,
    /// Show outputs as encoders do: in counts, and wrapped.
    #[arg(long)]
    pub encoders: bool,
    /// Write a page with tables and plots (HTML, complete in itself).
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// Overwrite the output file.
    #[arg(long)]
    pub force: bool,
}

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

/// `rig show`.
#[derive(Args)]
pub struct Show {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// LaTeX instead of text.
    #[arg(long)]
    pub latex: bool,
    /// The full derivation, before the declared assumptions.
    #[arg(long)]
    pub full: bool,
}

/// `rig diff`.
#[derive(Args)]
pub struct Diff {
    /// First rig.
    pub first: PathBuf,
    /// Second rig.
    pub second: PathBuf,
}

/// Languages of generated code.
#[derive(Clone, Copy, ValueEnum)]
pub enum Language {
    /// `no_std` Rust.
    Rust,
    /// C99.
    C,
}

/// `rig generate`.
#[derive(Args)]
pub struct Generate {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Write the controller of a scenario for this rig, beside the model.
    #[arg(long, value_name = "SCENARIO")]
    pub controller: Option<PathBuf>,
    /// Folder to write to.
    #[arg(long)]
    pub out: PathBuf,
    /// Language.
    #[arg(long, value_enum, default_value = "rust")]
    pub lang: Language,
    /// Write nothing; fail if what stands there is stale.
    #[arg(long)]
    pub check: bool,
    /// Overwrite files that do not carry our header.
    #[arg(long)]
    pub force: bool,
}

/// Targets of an export.
#[derive(Clone, Copy, ValueEnum)]
pub enum Target {
    /// The derived equations as a Python module for CasADi.
    Casadi,
    /// The declared rig: bodies, joints, forces, assumptions.
    Json,
    /// The derived equations.
    Latex,
}

/// `rig export`.
#[derive(Args)]
pub struct Export {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// What to write.
    #[arg(long, value_enum)]
    pub to: Target,
    /// File to write to (default: the rig's name beside the current folder, with the target's ending).
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Overwrite a file that stands there.
    #[arg(long)]
    pub force: bool,
}

/// `rig demo`.
#[derive(Args)]
pub struct Demo {
    /// Folder for the rig and the record.
    #[arg(long, default_value = "rig-demo")]
    pub out: PathBuf,
    /// Overwrite files of these names that are not ours.
    #[arg(long)]
    pub force: bool,
}

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
    /// What each sample says beyond those before it, seen through a Kalman filter: for rigs that random forces drive, or that a controller
    /// holds.
    Innovations,
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

/// `rig preflight`.
#[derive(Args)]
pub struct Preflight {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Records.
    #[arg(long, required = true, num_args = 1.., value_name = "RECORD")]
    pub data: Vec<PathBuf>,
    /// What logged inputs do between samples.
    #[arg(long, value_enum, default_value = "zero")]
    pub hold: Hold,
}

/// `rig new`.
#[derive(Args)]
pub struct New {
    /// Name of the rig, as in `Heli`; the file is its name in small letters.
    pub name: String,
    /// The record whose columns become inputs, coordinates and outputs.
    #[arg(long, value_name = "RECORD")]
    pub data: PathBuf,
    /// Columns that are inputs (default: guessed from names and units).
    #[arg(long, value_delimiter = ',', value_name = "A,B")]
    pub inputs: Vec<String>,
    /// File to write (default: `NAME.rig`); nothing is ever overwritten.
    #[arg(long, value_name = "RIG")]
    pub out: Option<PathBuf>,
}

/// Shapes of a proposed input.
#[derive(Clone, Copy, ValueEnum)]
pub enum Shape {
    /// Sines of different frequencies on each input, with seeded phases.
    Multisine,
    /// Steps up and down, then a sweep of the frequency.
    Steps,
}

/// `rig excite`.
#[derive(Args)]
pub struct Excite {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Point about which the rig is excited.
    #[command(flatten)]
    pub point: Point,
    /// Length of the record [s].
    #[arg(long, default_value_t = 30.0, value_name = "SECONDS")]
    pub duration: f64,
    /// Samples per second.
    #[arg(long, default_value_t = 100.0, value_name = "HZ")]
    pub rate: f64,
    /// Shape.
    #[arg(long, value_enum, default_value = "multisine")]
    pub shape: Shape,
    /// How far a coordinate may go from the point: `name=value` with an optional unit (default: half way to the end of its
    /// range; 20 deg, or 0.1 m, where it has none).
    #[arg(long = "within", value_name = "NAME=VALUE")]
    pub within: Vec<String>,
    /// Seed of the phases.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Where the input goes.
    #[arg(long, value_name = "CSV")]
    pub out: PathBuf,
    /// Overwrite the output file.
    #[arg(long)]
    pub force: bool,
}

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

/// `rig snapshot`.
#[derive(Args)]
pub struct Snapshot {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Write nothing; show what changed since the snapshot, and fail if anything did.
    #[arg(long)]
    pub check: bool,
    /// The snapshot's file (default: beside the rig, with the ending `.snapshot.txt`).
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Overwrite a file that this program did not write.
    #[arg(long)]
    pub force: bool,
}

/// `rig draw`.
#[derive(Args)]
pub struct Draw {
    /// Rig.
    #[command(flatten)]
    pub rig: File,
    /// Pose (default: every joint somewhat moved, so that it can be seen).
    #[command(flatten)]
    pub point: Point,
    /// The picture (default: beside the rig, with the ending `.svg`).
    #[arg(long, value_name = "SVG")]
    pub out: Option<PathBuf>,
    /// Overwrite a file that this program did not write.
    #[arg(long)]
    pub force: bool,
}
