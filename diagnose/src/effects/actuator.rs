//! Effects on the way from a command to what it moves.

use super::unit::{Text, of_row};
use super::{Edit, Effect, EffectParameter, LARGEST, Names, Scales, Signature, added, at_most, parameter, rounded, shape};
use model_dsl::rig::Rig;

pub(super) fn effects(rig: &Rig, scales: &Scales, names: &mut Names, out: &mut Vec<Effect>) {
    for j in 0..rig.inputs.len() {
        maps(rig, scales, j, names, out);
        timing(rig, j, names, out);
        compliance(rig, scales, j, names, out);
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
        edit: Edit::Map { input, factor, addend, screened: None, besides: Vec::new() },
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
    let p = vec![at_most(LARGEST, parameter(&name, one.text(), false, "relative change of the gain"))];
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

/// Resonances that are tried, in radians per sample.
const RESONANCES: [f64; 4] = [0.12, 0.2, 0.33, 0.55];
/// Damping ratio in the screening: wide enough to see one between two of these.
const WIDE: f64 = 0.15;
/// Beyond, it is a lag.
const MOST_DAMPED: f64 = 0.3;

/// What an actuator moves hangs at a spring: its torque acts once on what is before it, and again, behind a resonance, on what is beyond.
fn compliance(rig: &Rig, scales: &Scales, j: usize, names: &mut Names, out: &mut Vec<Effect>) {
    if scales.period <= 0.0 {
        return;
    }
    let u = &rig.inputs[j].name;
    let unit = Text::read(&rig.inputs[j].unit.text);
    let one = if unit == Text::one() { String::new() } else { format!(" * 1 [{}]", unit.text()) };
    for per_sample in RESONANCES {
        let w = rounded(per_sample / scales.period);
        let (rho, frequency, damping) =
            (names.free(&format!("rho_{u}")), names.free(&format!("omega_{u}")), names.free(&format!("zeta_{u}")));
        let z = names.free(&format!("bent_{u}"));
        let p = vec![
            parameter(&rho, "1".to_owned(), true, "inertia beyond a compliance, in parts of that before it"),
            shape(&frequency, "1/s".to_owned(), w, (0.6 * w, 1.6 * w), "resonance of what is beyond"),
            at_most(MOST_DAMPED, shape(&damping, "1".to_owned(), WIDE, (0.005, 1.2 * MOST_DAMPED), "its damping ratio")),
        ];
        let over = if one.is_empty() { u.clone() } else { format!("{u} / (1 [{}])", unit.text()) };
        let follows = format!("{frequency}^2 * ({over} - {z}) - 2 * {damping} * {frequency} * {z}.dot");
        let mut besides = vec![format!("coord {z}: rad;  // how far it is bent, in parts of a unit of {u}")];
        if rig.equations.is_empty() {
            besides.push(format!("kinetic {z}: 1/2 * 1 [kg*m^2] * {z}.dot^2;"));
            besides.push(format!("torque {z}_spring on {z}: 1 [kg*m^2] * ({follows});"));
        } else {
            besides.push(format!("equation {z}.ddot = {follows};"));
        }
        let addend = Some(format!("+ {rho} * ({{u}} - {z}{one})"));
        out.push(Effect {
            id: "flexible_mode".to_owned(),
            place: u.clone(),
            parameters: p,
            shape: Some(format!("at {w} rad/s")),
            edit: Edit::Map { input: j, factor: None, addend, screened: Some(format!("+ {rho}{one}")), besides },
            signature: Signature::Resonance(j),
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
