//! Texts to models: a rig with effects and with a force on every free coordinate, derived and ready to run.

use crate::effects::joint;
use crate::effects::{Effect, Signature};
use crate::forces::{dry_frictions, forces};
use crate::patch::{Base, PatchError, Written, check, compose};
use codegen::Options;
use ident::fit::ParameterSpec;
use ident::innovations::{Dry, Level, Noise};
use jit::InProcess;

/// An effect that the model has.
#[derive(Clone, Debug)]
pub struct Included {
    /// The effect.
    pub effect: Effect,
    /// Values to start from.
    pub start: Vec<f64>,
    /// Coefficients that stay at zero; none where empty.
    pub held: Vec<bool>,
}

/// A derived rig.
pub struct Prepared {
    /// The rig and its texts.
    pub base: Base,
    /// Its model.
    pub model: InProcess,
    /// Its parameters: those of the rig as asked, those of effects free, forces fixed.
    pub specs: Vec<ParameterSpec>,
    /// Parameters by which forces enter, one for each free coordinate.
    pub entries: Vec<usize>,
    /// The coordinates of these.
    pub coordinates: Vec<usize>,
    /// Dry friction on these.
    pub dry: Vec<Dry>,
    /// For each included effect the indices of its coefficients.
    pub of_effect: Vec<Vec<usize>>,
    /// For each included effect the indices of the numbers of its shape.
    pub of_shape: Vec<Vec<usize>>,
}

/// Composes, checks and derives. `asked` are the base rig's parameters as the request has them. The first `accepted` effects are free,
/// with their values to start from; the others are candidates at their null values, of which only those are written that are seen by the
/// derivatives of their parameters.
///
/// # Errors
/// [`PatchError`].
pub fn prepare(base: &Base, asked: &[ParameterSpec], effects: &[Included], accepted: usize) -> Result<Prepared, PatchError> {
    let written: Vec<Written<'_>> = effects
        .iter()
        .enumerate()
        .filter(|(k, e)| *k < accepted || matches!(e.effect.signature, Signature::Parameters | Signature::Resonance(_)))
        .map(|(k, e)| Written {
            effect: &e.effect,
            values: values(e, k < accepted).into_iter().map(|v| (v, 0.0)).collect(),
            evidence: None,
            per_record: e.effect.by_record,
            screened: k >= accepted,
        })
        .collect();
    let pushed = forces(base);
    let files = compose(base, &written, &pushed)?;
    let patched = check(&files, &base.rig.name)?;
    let equations = codegen::derive(&patched.rig, Options::default()).map_err(|e| PatchError::Derive { why: e.to_string() })?;
    let mut specs = ParameterSpec::of_rig(&patched.rig);
    let index = |specs: &[ParameterSpec], name: &str| specs.iter().position(|s| s.name == name);
    for own in asked {
        if let Some(i) = index(&specs, &own.name) {
            specs[i] = own.clone();
        }
    }
    let mut entries = Vec::new();
    for force in &pushed {
        if let Some(i) = index(&specs, &force.parameter) {
            specs[i].free = false;
            entries.push(i);
        }
    }
    let (mut of_effect, mut of_shape) = (Vec::new(), Vec::new());
    for (k, e) in effects.iter().enumerate() {
        let (mut own, mut shape) = (Vec::new(), Vec::new());
        for (j, p) in e.effect.parameters.iter().enumerate() {
            let Some(i) = index(&specs, &p.name) else { continue };
            let real = k < accepted;
            let held = e.held.get(j).copied().unwrap_or(false);
            specs[i].free = real && !held && (p.shape.is_none() || p.is_fitted_shape());
            specs[i].prior_sd = None;
            specs[i].value = if held { 0.0 } else { values(e, real)[j] };
            specs[i].per_record = e.effect.by_record;
            specs[i].bounds = p.shape.map(|s| s.within).or(p.positive.then_some((0.0, f64::INFINITY)));
            if p.shape.is_some() { &mut shape } else { &mut own }.push(i);
        }
        of_effect.push(own);
        of_shape.push(shape);
    }
    let coordinates: Vec<usize> = pushed.into_iter().map(|force| force.coordinate).collect();
    let mut dry = dry_frictions(&patched.rig, &coordinates);
    // friction that is written as a torque
    for (e, (own, shape)) in effects.iter().zip(of_effect.iter().zip(&of_shape)).take(accepted).filter(|(e, _)| e.effect.id == "stribeck") {
        let coordinate = patched.rig.coordinates.iter().position(|c| c.name == e.effect.place);
        if let (Some(i), Some(&level), Some(&speed)) = (coordinate, own.first(), shape.first())
            && let Some(entry) = coordinates.iter().position(|c| *c == i)
        {
            let rate = patched.rig.coordinates.len() + i;
            dry.push(Dry { entry, rate, level: Level::Parameter(level), width: Level::Part(speed, joint::STRIBECK_WIDTH) });
        }
    }
    Ok(Prepared { base: patched, model: InProcess::at_work(equations), specs, entries, coordinates, dry, of_effect, of_shape })
}

/// Values of an effect's parameters: as they start, or null.
fn values(e: &Included, real: bool) -> Vec<f64> {
    let null = e.effect.with(&[]);
    if real { null.iter().enumerate().map(|(i, null)| e.start.get(i).copied().unwrap_or(*null)).collect() } else { null }
}

impl Prepared {
    /// A noise found with another model, with the forces and frictions of this one.
    #[must_use]
    pub fn noise(&self, found: &Noise) -> Noise {
        Noise { entries: self.entries.clone(), dry: self.dry.clone(), ..found.clone() }
    }
}
