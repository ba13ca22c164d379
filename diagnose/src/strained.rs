//! Numbers of bodies that a fit has moved so far from the text that they stand for something else: gravity does the work of a spring if an arm may
//! become twenty times as long.
//!
//! Knows the text and where the search ended; nothing of records.

use crate::patch::digits;
use crate::search::State;
use model_dsl::rig::{EnergyKind, Expr, Rig, Step, Symbol};
use runtime::Model;

/// A mass, length or inertia this many times as large or small as the text says is not what the text means.
const FAR: f64 = 4.0;
/// Standard errors by which it must be off besides.
const TOLD: f64 = 3.0;

/// The number of a body that is farthest from the text, in words.
pub(crate) fn strained(rig: &Rig, state: &State) -> Option<String> {
    let of_bodies = of_bodies(rig);
    let specs = &state.prepared.specs;
    let mut far: Vec<(f64, String)> = Vec::new();
    for u in &state.fitted.found.unknowns {
        let name = &specs[u.parameter].name;
        let Some(own) = rig.parameters.iter().position(|p| p.name == *name).filter(|i| of_bodies.contains(i)) else { continue };
        let (text, unit) = (rig.parameters[own].value, state.prepared.model.names().parameter_unit(u.parameter));
        if text == 0.0 || (u.value - text).abs() < TOLD * u.robust_sd {
            continue;
        }
        let times = u.value / text;
        let off = if times > 0.0 { times.ln().abs() } else { f64::INFINITY };
        if off > FAR.ln() {
            let came = format!("{name} came out as {} {unit}, where the text says {} {unit}", digits(u.value, 3), digits(text, 3));
            far.push((off, format!("{came}: it may stand for something that is missing")));
        }
    }
    far.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)).map(|f| f.1)
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
