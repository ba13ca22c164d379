//! The catalogue: every effect at every place where it can act, each a patch of the rig's language.
//!
//! One family a file. Knows the rig, not its equations and no record but for the scales in [`Scales`] (how far and how fast each
//! coordinate was seen to move), from which the fixed numbers of a shape are taken.

mod actuator;
mod aero;
mod inertial;
pub(crate) mod joint;
mod own;
mod sensor;
pub(crate) mod unit;

pub use own::{OwnError, read_own};

use model_dsl::rig::Rig;

/// An effect at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// What it is: `coulomb`, `input_delay`.
    pub id: String,
    /// Where: a coordinate, input, output or body by its name; `f_1->eps` for a pair.
    pub place: String,
    /// Its parameters in the patched rig: coefficients, all zero where the effect is absent, then numbers of its shape.
    pub parameters: Vec<EffectParameter>,
    /// What is fixed in its shape, in words: `width 0.01 rad/s`.
    pub shape: Option<String>,
    /// The change of the text.
    pub edit: Edit,
    /// How innovations see it where it is absent.
    pub signature: Signature,
    /// It may belong to the day: a value for each record.
    pub of_the_day: bool,
    /// It is taken so.
    pub by_record: bool,
}

/// A parameter that an effect adds.
#[derive(Clone, Debug, PartialEq)]
pub struct EffectParameter {
    /// Name.
    pub name: String,
    /// Unit, as written.
    pub unit: String,
    /// It cannot be negative.
    pub positive: bool,
    /// Its largest magnitude (SI), where a larger one would be something else.
    pub most: Option<f64>,
    /// What it is.
    pub doc: String,
    /// A number of the effect's shape, which says nothing where the coefficients are zero: where screening holds it, and within what it
    /// is fitted once the effect is there.
    pub shape: Option<ShapeRange>,
}

impl EffectParameter {
    /// It is a number of the effect's shape, and fitted once the effect is there.
    #[must_use]
    pub fn is_fitted_shape(&self) -> bool {
        self.shape.is_some_and(|s| s.within.0 < s.within.1)
    }
}

/// Where a number of a shape is looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeRange {
    /// Its value in the screening.
    pub at: f64,
    /// Bounds of the fit; it is not fitted where they are equal.
    pub within: (f64, f64),
}

/// How a patch changes the text.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// A statement more.
    Add(String),
    /// The map of an input, `u` times the factor (`1 + g`) where there is one, plus the addend; `{u}` stands for the command.
    Map {
        /// Input.
        input: usize,
        /// Factor.
        factor: Option<String>,
        /// Addend, with its sign.
        addend: Option<String>,
        /// Addend where the derivative at the null value is wanted, if `addend` has none there.
        screened: Option<String>,
        /// Statements that it needs.
        besides: Vec<String>,
    },
    /// An entry of an input's path: `delay`, `lag`; added to what stands there.
    Path {
        /// Input.
        input: usize,
        /// Entry.
        entry: &'static str,
        /// Value.
        value: String,
    },
    /// Something of an output: `scale`, `bias`, `delay`, or `value` (an addend of what is measured).
    Output {
        /// Output.
        output: usize,
        /// Entry.
        entry: &'static str,
        /// Addend.
        value: String,
    },
    /// An addend of one component of a body's centre of mass.
    Center {
        /// Body.
        body: usize,
        /// x, y, z.
        axis: usize,
        /// Addend.
        value: String,
    },
    /// Gravity along this direction.
    Gravity(String),
    /// An assumption is dropped.
    Assumption(usize),
}

/// How innovations see an absent effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signature {
    /// By the derivatives with respect to its parameters.
    Parameters,
    /// As a delay of an input.
    InputDelay(usize),
    /// As a delay of an output.
    OutputDelay(usize),
    /// By the derivative with respect to its first parameter, times what a resonance leaves of an input; frequency and damping are its other
    /// parameters.
    Resonance(usize),
    /// As the way to the model that has it.
    Towards,
}

impl Effect {
    /// `coulomb on eps`.
    #[must_use]
    pub fn title(&self) -> String {
        match &self.shape {
            Some(shape) => format!("{} on {} ({shape})", self.id, self.place),
            None => format!("{} on {}", self.id, self.place),
        }
    }

    /// How many of its parameters are coefficients; they come first.
    #[must_use]
    pub fn coefficients(&self) -> usize {
        self.parameters.iter().filter(|p| p.shape.is_none()).count()
    }

    /// Values of all parameters with these coefficients, its shape as the screening has it.
    #[must_use]
    pub fn with(&self, coefficients: &[f64]) -> Vec<f64> {
        let of = |(i, p): (usize, &EffectParameter)| p.shape.map_or(coefficients.get(i).copied().unwrap_or(0.0), |s| s.at);
        self.parameters.iter().enumerate().map(of).collect()
    }
}

/// How far, how fast and how strongly a rig was seen to move; all SI.
#[derive(Clone, Debug)]
pub struct Scales {
    /// Lowest and highest value of each coordinate.
    pub range: Vec<(f64, f64)>,
    /// Root-mean-square rate of each coordinate.
    pub rate: Vec<f64>,
    /// Largest magnitude and spread of each input.
    pub input: Vec<(f64, f64)>,
    /// Longest record [s].
    pub duration: f64,
    /// Time between its samples [s].
    pub period: f64,
}

/// Ids of all effects, whether or not a rig has a place for them.
pub const IDS: [&str; 34] = [
    "viscous",
    "coulomb",
    "stribeck",
    "asymmetric_friction",
    "quadratic_drag",
    "spring",
    "cubic_spring",
    "constant_torque",
    "hard_stop",
    "periodic_torque",
    "velocity_product",
    "actuator_bias",
    "actuator_gain",
    "gain_curvature",
    "actuator_drift",
    "actuator_deadzone",
    "actuator_saturation",
    "start_transient",
    "input_delay",
    "actuator_lag",
    "input_coupling",
    "flexible_mode",
    "rotor_gyroscopic",
    "ground_effect",
    "sensor_bias",
    "sensor_scale",
    "sensor_delay",
    "sensor_drift",
    "sensor_misalignment",
    "backlash",
    "gravity_offset",
    "added_mass",
    "base_tilt",
    "neglected_inertia",
];

/// Those that may belong to the day, with a value for each record.
#[must_use]
pub fn by_record(effects: &[Effect]) -> Vec<Effect> {
    let of = |e: &Effect| Effect { by_record: true, shape: Some("a value for each record".to_owned()), ..e.clone() };
    effects.iter().filter(|e| e.of_the_day && e.parameters.len() == 1).map(of).collect()
}

/// All effects at all places of a rig.
#[must_use]
pub fn catalogue(rig: &Rig, scales: &Scales) -> Vec<Effect> {
    let mut all = Vec::new();
    let mut names = Names::new(rig);
    joint::effects(rig, scales, &mut names, &mut all);
    actuator::effects(rig, scales, &mut names, &mut all);
    aero::effects(rig, scales, &mut names, &mut all);
    sensor::effects(rig, scales, &mut names, &mut all);
    inertial::effects(rig, &mut names, &mut all);
    all
}

/// Names of parameters that are not taken.
pub(crate) struct Names {
    taken: Vec<String>,
}

impl Names {
    pub fn new(rig: &Rig) -> Self {
        let taken = rig
            .parameters
            .iter()
            .map(|p| p.name.clone())
            .chain(rig.definitions.iter().map(|d| d.name.clone()))
            .chain(rig.coordinates.iter().map(|c| c.name.clone()))
            .chain(rig.inputs.iter().map(|i| i.name.clone()))
            .chain(rig.actuators.iter().map(|a| a.name.clone()))
            .chain(rig.frames.iter().map(|f| f.name.clone()))
            .chain(rig.mixes.iter().flat_map(|m| m.names.clone()))
            .collect();
        Self { taken }
    }

    /// `wanted`, or with a number behind it.
    pub fn free(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut k = 1;
        while self.taken.contains(&name) {
            k += 1;
            name = format!("{wanted}_{k}");
        }
        self.taken.push(name.clone());
        name
    }
}

/// An effect that is a statement more.
pub(crate) fn added(id: &str, place: &str, parameters: Vec<EffectParameter>, shape: Option<String>, statement: String) -> Effect {
    Effect {
        id: id.to_owned(),
        place: place.to_owned(),
        parameters,
        shape,
        edit: Edit::Add(statement),
        signature: Signature::Parameters,
        of_the_day: false,
        by_record: false,
    }
}

/// A parameter of an effect.
pub(crate) fn parameter(name: &str, unit: String, positive: bool, doc: &str) -> EffectParameter {
    EffectParameter { name: name.to_owned(), unit, positive, most: None, doc: doc.to_owned(), shape: None }
}

/// The same, with a largest magnitude.
pub(crate) fn at_most(most: f64, parameter: EffectParameter) -> EffectParameter {
    EffectParameter { most: Some(most), ..parameter }
}

/// A number of an effect's shape.
pub(crate) fn shape(name: &str, unit: String, at: f64, within: (f64, f64), doc: &str) -> EffectParameter {
    EffectParameter { shape: Some(ShapeRange { at, within }), ..parameter(name, unit, false, doc) }
}

/// A number of an effect's shape that is not the rig's but the equations': it is not fitted, and what it could do is no effect.
pub(crate) fn crutch(name: &str, unit: String, at: f64, doc: &str) -> EffectParameter {
    shape(name, unit, at, (at, at), doc)
}

/// Largest relative error of a gain or a scale, and largest share of another angle: beyond, it is another actuator or sensor, and likelier
/// that all the rig's inertias and stiffnesses were carried off with it.
pub(crate) const LARGEST: f64 = 0.5;

/// A number as the language reads it, with few digits.
pub(crate) fn rounded(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return 0.0;
    }
    let scale = 10_f64.powf(value.abs().log10().floor() - 1.0);
    let text = format!("{:e}", (value / scale).round() * scale);
    text.parse::<f64>().map_or(value, |v| format!("{v:.12}").parse().unwrap_or(v))
}
