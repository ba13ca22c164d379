//! The scenario file as it is written: TOML tables and keys, with the places of what can be wrong (reference:
//! `docs/control.md`). Knows no rig.

use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// A number, or a text with a unit (`"5 deg"`).
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged, expecting = "a number, or a text with a unit (\"5 deg\")")]
pub enum Value {
    /// In the unit of its place.
    Number(f64),
    /// With its unit.
    Text(String),
}

/// Names and values.
pub type Assignments = BTreeMap<Spanned<String>, Spanned<Value>>;
/// Names and functions of time.
pub type Functions = BTreeMap<Spanned<String>, Spanned<Value>>;

/// A scenario.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    /// One line about it.
    pub title: Option<String>,
    /// The rig that is controlled, beside the scenario.
    pub rig: Spanned<String>,
    /// Its parameters.
    #[serde(default)]
    pub set: Assignments,
    /// Use the definitions behind lumps.
    #[serde(default)]
    pub expand_lumps: bool,
    /// Length of the run.
    pub duration: Spanned<Value>,
    /// From here on errors are given once more.
    pub settled: Option<Spanned<Value>>,
    /// Longest step of integration.
    pub max_step: Option<Spanned<Value>>,
    /// Outputs are read through their encoders.
    #[serde(default = "yes")]
    pub encoders: bool,
    /// Inputs keep to the rig's limits.
    #[serde(default = "yes")]
    pub limits: bool,
    /// State at the start.
    #[serde(default)]
    pub start: Point,
    /// The controller.
    pub controller: Spanned<Controller>,
    /// Inputs that hold the references.
    pub feedforward: Option<Spanned<Feedforward>>,
    /// How rates are estimated.
    pub rates: Spanned<Rates>,
    /// References of outputs.
    #[serde(default)]
    pub references: Functions,
    /// Rates of references that are not to be the derivatives of these.
    #[serde(default)]
    pub reference_rates: Functions,
    /// References that an outer loop gives.
    #[serde(default)]
    pub cascades: BTreeMap<Spanned<String>, Cascade>,
    /// Prescribed coordinates.
    #[serde(default)]
    pub motion: Functions,
    /// What is added to inputs.
    #[serde(default)]
    pub disturbances: Functions,
    /// Noise on outputs.
    pub noise: Option<Noise>,
}

fn yes() -> bool {
    true
}

/// An operating point, or a state.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Point {
    /// Named trim.
    pub trim: Option<Spanned<String>>,
    /// Values.
    #[serde(default)]
    pub at: Assignments,
}

/// The controller.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Controller {
    /// Its period.
    pub period: Spanned<Value>,
    /// The rig that it is designed for, if another one.
    pub rig: Option<Spanned<String>>,
    /// Parameters of that.
    #[serde(default)]
    pub set: Assignments,
    /// Trim that it is designed at.
    pub trim: Option<Spanned<String>>,
    /// Values there.
    #[serde(default)]
    pub at: Assignments,
    /// Inputs.
    #[serde(default)]
    pub inputs: Vec<Spanned<String>>,
    /// States that are fed back.
    #[serde(default)]
    pub states: Vec<Spanned<String>>,
    /// Outputs that are integrated.
    #[serde(default)]
    pub integrate: Vec<Spanned<String>>,
    /// Designed here.
    pub lqr: Option<Spanned<Lqr>>,
    /// Given.
    pub gain: Option<Spanned<Gain>>,
}

/// Weights of a linear-quadratic regulator.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lqr {
    /// Diagonal of Q.
    pub weights_x: Spanned<Vec<f64>>,
    /// Diagonal of R.
    pub weights_u: Spanned<Vec<f64>>,
    /// How it is sampled.
    #[serde(default)]
    pub cost: Cost,
}

/// The cost of a regulator.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Cost {
    /// Continuous time.
    #[default]
    Continuous,
    /// Inputs held, the integral as in continuous time.
    Integral,
    /// Inputs held, the sum over the samples.
    Sum,
}

/// A gain.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gain {
    /// One row an input.
    #[serde(rename = "K")]
    pub k: Vec<Vec<f64>>,
    /// Time constant of the anti-windup.
    pub tracking_time: Option<Spanned<Value>>,
}

/// Feedforward from the trim manifold.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Feedforward {
    /// The trim that is solved.
    pub trim: Option<Spanned<String>>,
    /// Values held there.
    #[serde(default)]
    pub at: Assignments,
    /// Outputs held at their references.
    pub hold: Vec<Spanned<String>>,
}

/// Rates.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Rates {
    /// Eq. 23.
    Filter(Filter),
    /// Chain of integrators.
    Observer(Observer),
    /// Consecutive samples.
    Differences,
    /// Steady-state Kalman filter.
    Kalman(Kalman),
}

/// F(s) = w^2 s/(s^2 + 2 eta w s + w^2).
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Filter {
    /// w.
    pub omega: Spanned<Value>,
    /// eta.
    pub damping: f64,
    /// How it is sampled.
    #[serde(default)]
    pub rule: Rule,
}

/// How a filter is sampled.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Rule {
    /// For a held angle.
    #[default]
    Hold,
    /// Tustin's.
    Tustin,
}

/// Poles of an observer.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Observer {
    /// Real and imaginary part; a pair is given once.
    pub poles: Spanned<Vec<(f64, f64)>>,
}

/// Noise that a Kalman filter is designed for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kalman {
    /// Intensity on each state's rate.
    pub process: BTreeMap<Spanned<String>, f64>,
    /// Standard deviation of outputs (default: that of their encoder).
    #[serde(default)]
    pub measurement: Assignments,
}

/// A reference that an outer loop gives.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cascade {
    /// Its outer output.
    pub outer: Spanned<String>,
    /// K_p.
    pub proportional: f64,
    /// K_d.
    pub derivative: f64,
    /// Largest modulus.
    pub limit: Option<Spanned<Value>>,
    /// Where its rate comes from.
    pub rate: InnerRate,
}

/// The rate of an inner reference.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum InnerRate {
    /// Zero.
    Zero,
    /// By a filter.
    Filter(Filter),
}

/// Noise on outputs.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Noise {
    /// Seed.
    #[serde(default)]
    pub seed: u64,
    /// Standard deviation of outputs.
    pub deviation: Assignments,
}
