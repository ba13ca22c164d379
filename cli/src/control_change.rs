//! What a change of the model means for its regulator: poles of the linear-quadratic regulator with identity weights, at the
//! first trim, before and after.

use crate::args::Point;
use crate::commands::linearize::{at_point, inputs_of};
use crate::failure::Failure;
use crate::load::{self, Loaded};
use codegen::Options;
use control::{LqrDesign, Plant, Sampling, Weight};
use jit::InProcess;
use nalgebra::Complex;
use runtime::Model;
use serde_json::{Value, json};

/// Poles [1/s] before and after.
pub struct Change {
    /// Trim.
    pub trim: Option<String>,
    /// The regulator of the rig as it was, on its own model.
    pub before: Vec<Complex<f64>>,
    /// The regulator of the patched rig, on its own model.
    pub after: Vec<Complex<f64>>,
    /// The regulator of before on the patched model; `None` where its states are others.
    pub old_gain: Option<Vec<Complex<f64>>>,
}

impl Change {
    /// For JSON.
    pub fn json(&self) -> Value {
        let poles = |p: &[Complex<f64>]| p.iter().map(|z| [z.re, z.im]).collect::<Vec<_>>();
        json!({
            "trim": self.trim,
            "weights": "identity",
            "before": poles(&self.before),
            "after": poles(&self.after),
            "after_with_gain_of_before": self.old_gain.as_deref().map(poles),
        })
    }
}

/// Designs both regulators.
pub fn change(old: &Loaded, new: &Loaded) -> Result<Change, Failure> {
    let (trim, plant, before) = regulator(old)?;
    let (_, patched, after) = regulator(new)?;
    let same = plant.states == patched.states && plant.inputs == patched.inputs;
    let old_gain = same.then(|| control::eigenvalues(&(&patched.a - &patched.b * &before.k)).ok()).flatten();
    Ok(Change { trim, before: before.plant_poles, after: after.plant_poles, old_gain })
}

fn regulator(loaded: &Loaded) -> Result<(Option<String>, Plant, control::Lqr), Failure> {
    let model = InProcess::new(load::equations(loaded, Options::default())?);
    let layout = &model.equations().layout;
    let named: Vec<String> = layout.u[..layout.inputs].iter().map(|u| u.name.clone()).collect();
    let inputs = inputs_of(loaded, &model, &named)?;
    let linear = at_point(loaded, &model, &Point { trim: None, at: Vec::new() }, &inputs.directions, false)?;
    let plant = Plant::new(&model, &linear.model, &inputs.names);
    let design = LqrDesign {
        states: Vec::new(),
        integrate: Vec::new(),
        weight_x: Weight::Diagonal(vec![1.0; model.dimensions().states()]),
        weight_u: Weight::Diagonal(vec![1.0; named.len()]),
        sampling: Sampling::Continuous,
    };
    let found = control::lqr(&plant, &design).map_err(|e| Failure::new("C0306", e.to_string()))?;
    Ok((linear.found.name.clone(), plant, found))
}
