//! Effects on the way from a command to what it moves.

use super::unit::{Text, of_row};
use super::{Edit, Effect, EffectParameter, Names, Scales, Signature, added, at_most, parameter, rounded, shape};
use model_dsl::rig::Rig;

pub(super) fn effects(rig: &Rig, scales: &Scales, names: &mut Names, out: &mut Vec<Effect>) {
    for j in 0..rig.inputs.len() {
        maps(rig, scales, j, names, out);
        timing(rig, j, names, out);
    }
    for j in 0..rig.inputs.len() {
        couplings(rig, j, names, out);
    }
}

fn map(
    rig: &Rig,
    input: usize,
    id: &str,
    parameters: Vec<EffectParameter>,
    shape: Option<String>,
    factor: Option<String>,
    addend: Option<String>,
) -> Effect {
    Effect {
        id: id.to_owned(),
        place: rig.inputs[input].name.clone(),
        parameters,
        shape,
        edit: Edit::Map { input, factor, addend, screened: None },
        signature: Signature::Parameters,
        of_the_day: false,
        by_record: false,
    }
}

fn maps(rig: &Rig, scales: &Scales, j: usize, names: &mut Names, out: &mut Vec<Effect>) {
    let u = &rig.inputs[j].name;
    let unit = Text::read(&rig.inputs[j].unit.text);
    let one = Text::one();
    let (largest, spread) = scales.input.get(j).copied().unwrap_or_default();
    let name = names.free(&format!("u_0_{u}"));
    let p = vec![parameter(&name, unit.text(), false, "offset of the command")];
    let mut bias = map(rig, j, "actuator_bias", p, None, None, Some(format!("+ {name}")));
    bias.of_the_day = true;
    out.push(bias);
    let name = names.free(&format!("g_{u}"));
    // beyond, it is another actuator, and likelier that all the rig's inertias and stiffnesses were carried off with it
    let p = vec![at_most(1.0, parameter(&name, one.text(), false, "relative change of the gain"))];
    out.push(map(rig, j, "actuator_gain", p, None, Some(format!("(1 + {name})")), None));
    let name = names.free(&format!("k_u_{u}"));
    let p = vec![parameter(&name, one.by(&unit, -1).text(), false, "curvature of the gain")];
    out.push(map(rig, j, "gain_curvature", p, None, Some(format!("(1 + {name} * {{u}})")), None));
    let name = names.free(&format!("a_{u}"));
    let p = vec![parameter(&name, "1/s".to_owned(), false, "loss of gain by time")];
    out.push(map(rig, j, "actuator_drift", p, None, Some(format!("(1 - {name} * t)")), None));
    if largest > 0.0 {
        let crosses = rig.inputs[j].limits.is_none_or(|(lo, hi)| lo < 0.0 && hi > 0.0);
        if crosses {
            let name = names.free(&format!("w_{u}"));
            let p = vec![parameter(&name, unit.text(), true, "half width of the dead zone")];
            let mut dead = map(rig, j, "actuator_deadzone", p, None, None, Some(format!("- saturate({{u}}, -{name}, {name})")));
            if let Edit::Map { screened, .. } = &mut dead.edit {
                *screened = Some(format!("- {name} * sign({{u}})"));
            }
            out.push(dead);
        }
        let limit = rounded(0.75 * largest);
        let (name, edge) = (names.free(&format!("s_{u}")), names.free(&format!("u_max_{u}")));
        let p = vec![
            parameter(&name, one.text(), true, "share that is lost beyond the limit"),
            shape(&edge, unit.text(), limit, (0.2 * largest, largest), "where it begins"),
        ];
        let over = format!("- {name} * ({{u}} - saturate({{u}}, -{edge}, {edge}))");
        out.push(map(rig, j, "actuator_saturation", p, Some(format!("beyond {limit} {}", unit.text())), None, Some(over)));
    }
    if spread > 0.0 || largest > 0.0 {
        let time = rounded((0.05 * scales.duration).clamp(0.2, 5.0));
        let (name, constant) = (names.free(&format!("k_t_{u}")), names.free(&format!("T_t_{u}")));
        let p = vec![
            parameter(&name, one.text(), false, "more gain at the start"),
            shape(&constant, "s".to_owned(), time, (0.2 * time, 5.0 * time), "time over which it is gone"),
        ];
        let factor = Some(format!("(1 + {name} * exp(-t / {constant}))"));
        out.push(map(rig, j, "start_transient", p, Some(format!("over {time} s")), factor, None));
    }
}

fn timing(rig: &Rig, j: usize, names: &mut Names, out: &mut Vec<Effect>) {
    let u = &rig.inputs[j].name;
    for (id, entry, prefix, doc) in
        [("input_delay", "delay", "d", "delay of the command"), ("actuator_lag", "lag", "T", "time constant of the actuator")]
    {
        // a path has one lag
        let has = |a: &&model_dsl::rig::Actuator| a.name == *u && a.lag.is_some();
        if entry == "lag" && rig.actuators.iter().any(|a| has(&a)) {
            continue;
        }
        let name = names.free(&format!("{prefix}_{u}"));
        out.push(Effect {
            id: id.to_owned(),
            place: u.clone(),
            parameters: vec![parameter(&name, "s".to_owned(), true, doc)],
            shape: None,
            edit: Edit::Path { input: j, entry, value: name },
            signature: Signature::InputDelay(j),
            of_the_day: false,
            by_record: false,
        });
    }
}

fn couplings(rig: &Rig, j: usize, names: &mut Names, out: &mut Vec<Effect>) {
    let input = &rig.inputs[j];
    let unit = Text::read(&input.unit.text);
    let free: Vec<usize> = (0..rig.coordinates.len()).filter(|&i| !rig.coordinates[i].prescribed).collect();
    if free.len() < 2 {
        return;
    }
    for &i in &free {
        let (u, q) = (&input.name, &rig.coordinates[i].name);
        let name = names.free(&format!("k_{u}_{q}"));
        let p = parameter(&name, of_row(rig, i).by(&unit, -1).text(), false, "input on this coordinate");
        let statement = format!("torque coupling_{u}_{q} on {q}: {name} * {u};");
        out.push(added("input_coupling", &format!("{u}->{q}"), vec![p], None, statement));
    }
}
