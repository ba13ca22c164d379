//! Numbers of bodies that a fit has moved so far from the text that they stand for something else: gravity does the work of a spring if an arm may
//! become twenty times as long.
//!
//! Knows the text and where the search ended; nothing of what records say.

use crate::base_fit::Starting;
use crate::effects::Effect;
use crate::patch::digits;
use crate::search::State;
use model_dsl::rig::{EnergyKind, Expr, Rig, Step, Symbol};
use runtime::Model;

/// A mass, length or inertia this many times as large or small as the text says is not what the text means.
const FAR: f64 = 4.0;
/// Standard errors by which it must be off besides.
const TOLD: f64 = 3.0;

/// How far they may go from the text where they are kept near it, in parts of that.
const NEAR: f64 = 0.1;

/// A number of a body that is far from the text.
pub(crate) struct Far {
    name: String,
    /// What the fit makes of it, and what the text says (SI).
    fitted: f64,
    text: f64,
    unit: String,
    /// Logarithm of how many times as large or small.
    off: f64,
}

impl Far {
    /// What it may be.
    pub fn words(&self) -> String {
        format!("{}: it may stand for something that is missing", self.came())
    }

    /// What does its work where it is kept near the text.
    pub fn words_instead(&self, names: &str) -> String {
        format!("{names}, or another number than the text's, these records cannot tell: without it {}", self.came())
    }

    fn came(&self) -> String {
        let Self { name, fitted, text, unit, .. } = self;
        format!("{name} came out as {} {unit}, where the text says {} {unit}", digits(*fitted, 3), digits(*text, 3))
    }
}

/// Numbers of bodies that are far from the text, the farthest first.
pub(crate) fn strained(rig: &Rig, state: &State) -> Vec<Far> {
    let of_bodies = of_bodies(rig);
    let specs = &state.prepared.specs;
    let mut far: Vec<Far> = Vec::new();
    for u in &state.fitted.found.unknowns {
        let name = &specs[u.parameter].name;
        let Some(own) = rig.parameters.iter().position(|p| p.name == *name).filter(|i| of_bodies.contains(i)) else { continue };
        let text = rig.parameters[own].value;
        if text == 0.0 || (u.value - text).abs() < TOLD * u.robust_sd {
            continue;
        }
        let times = u.value / text;
        let off = if times > 0.0 { times.ln().abs() } else { f64::INFINITY };
        if off > FAR.ln() {
            let unit = state.prepared.model.names().parameter_unit(u.parameter).to_owned();
            far.push(Far { name: name.clone(), fitted: u.value, text, unit, off });
        }
    }
    far.sort_by(|a, b| b.off.total_cmp(&a.off));
    far
}

/// What a fit begins with that keeps these numbers near the text.
pub(crate) fn kept(far: &[Far], starting: &Starting) -> Starting {
    let mut asked = starting.asked.to_vec();
    for spec in &mut asked {
        if let Some(own) = far.iter().find(|f| f.name == spec.name) {
            (spec.value, spec.prior_mean, spec.prior_sd) = (own.text, own.text, Some(NEAR * own.text.abs()));
        }
    }
    Starting { records: starting.records.clone(), hold: starting.hold, asked: asked.into() }
}

/// The effect is another word for such a number.
pub(crate) fn is_of_a_body(effect: &Effect) -> bool {
    ["gravity_offset", "added_mass"].contains(&effect.id.as_str())
}

/// Parameters in masses, places, inertias and kinetic energies.
fn of_bodies(rig: &Rig) -> Vec<usize> {
    let bodies = rig.bodies.iter().flat_map(|b| b.center.iter().chain(&b.inertia).chain([&b.mass]));
    let steps = rig.frames.iter().flat_map(|f| &f.steps).filter_map(|step| match step {
        Step::Translate(by) => Some(by),
        Step::Rotate { .. } => None,
    });
    let mut found = Vec::new();
    let kinetic = rig.functions.iter().filter(|e| matches!(e.kind, EnergyKind::Kinetic)).map(|e| &e.value);
    let mut open: Vec<&Expr> = bodies.chain(steps.flatten()).chain(kinetic).collect();
    while let Some(e) = open.pop() {
        for symbol in e.symbols() {
            match symbol {
                Symbol::Parameter(i) => found.push(i),
                Symbol::Definition(i) => open.extend(rig.definitions.get(i).map(|d| &d.value)),
                _ => {}
            }
        }
    }
    found
}
