//! `rig lqr`.

use crate::args::Lqr;
use crate::commands::linearize::{at_point, inputs_of};
use crate::failure::Failure;
use crate::load;
use crate::output::{Answer, number, poles_in_words, prime, table};
use codegen::Options;
use control::{LqrDesign, LqrError, Plant, Sampling, Weight};
use jit::InProcess;
use nalgebra::DMatrix;
use serde_json::json;
use std::fmt::Write;

pub fn run(args: &Lqr) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::new(load::equations(&loaded, Options::default())?);
    let layout = &model.equations().layout;
    let inputs = inputs_of(&loaded, &model, &args.inputs)?;
    let linear = at_point(&loaded, &model, &args.point, &inputs.directions, args.friction_slope)?;
    let plant = Plant::new(&model, &linear.model, &inputs.names);
    let sampling = match (args.discrete, args.sum) {
        (None, _) => Sampling::Continuous,
        (Some(period), true) => Sampling::Sum { period },
        (Some(period), false) => Sampling::Integral { period },
    };
    let trimmed = |list: &[String]| list.iter().map(|s| s.trim().to_owned()).collect::<Vec<_>>();
    let design = LqrDesign {
        states: trimmed(&args.states),
        integrate: trimmed(&args.integrate),
        weight_x: Weight::Diagonal(args.weights_x.clone()),
        weight_u: Weight::Diagonal(args.weights_u.clone()),
        sampling,
    };
    let found = control::lqr(&plant, &design).map_err(|e| failure(&e))?;

    let mut text = linear.found.words(&loaded, layout);
    let columns: Vec<String> = found.states.iter().map(|s| prime(s)).collect();
    let rows: Vec<(String, Vec<f64>)> = found.inputs.iter().cloned().zip(found.k.row_iter().map(|r| r.iter().copied().collect())).collect();
    let _ = writeln!(text, "\nu = u* - K (x - x*)   K:");
    text.push_str(&table(&columns, &rows, usize::MAX));
    let kind = if found.period.is_some() { " (of z)" } else { "" };
    let _ = writeln!(text, "poles{kind}: {}", poles_in_words(&found.poles));
    if found.states.len() - found.integrals < plant.states.len() {
        let _ = writeln!(text, "poles of the whole model with this gain{kind}: {}", poles_in_words(&found.plant_poles));
    }
    for c in &found.neglected {
        let _ = writeln!(
            text,
            "neglected: {}' depends on {} by {}, which the design leaves out",
            prime(&c.onto),
            prime(&c.from),
            number(c.value)
        );
    }
    let _ = writeln!(text, "Riccati residual {:.0e} (relative)", found.residual);
    let matrix = |m: &DMatrix<f64>| m.row_iter().map(|r| r.iter().copied().collect::<Vec<f64>>()).collect::<Vec<_>>();
    let poles = |p: &[nalgebra::Complex<f64>]| p.iter().map(|z| [z.re, z.im]).collect::<Vec<_>>();
    let json = json!({
        "rig": loaded.rig.name,
        "K": matrix(&found.k),
        "P": matrix(&found.p),
        "poles": poles(&found.poles),
        "plant_poles": poles(&found.plant_poles),
        "states": found.states,
        "integrals": found.integrals,
        "inputs": found.inputs,
        "trim": linear.found.json(&loaded, layout),
        "residual": found.residual,
        "neglected": found.neglected.iter().map(|c| json!({"onto": c.onto, "from": c.from, "value": c.value})).collect::<Vec<_>>(),
        "anti_windup": matrix(&found.anti_windup),
        "tracking_time": if found.integrals > 0 { json!(found.tracking_time) } else { json!(null) },
        "period": found.period,
    });
    Ok(Answer { text, json })
}

fn failure(error: &LqrError) -> Failure {
    let failure = Failure::new("C0306", error.to_string());
    match error {
        LqrError::Riccati { .. } => {
            failure.with_help("leave states out that no input reaches (--states), weigh what has to be seen, or add an input")
        }
        LqrError::Name(_) => failure.with_help("names are those of `rig linearize`: `eps`, `eps.dot`, `f_s`"),
        LqrError::Weight(_) => {
            failure.with_help("--weights-x takes one number for each state (then each integral), --weights-u one for each input")
        }
        LqrError::Empty => failure.with_help("declare an input, or name some with --inputs"),
        LqrError::Sampling(_) => failure.with_help("--discrete takes the sampling period in seconds"),
        LqrError::NoConvergence(_) => failure,
    }
}
