//! Effects of rotors: on rigs that fly, of three free coordinates and more.

use super::joint::turns;
use super::unit::{Text, of_coordinate, of_rate, of_row};
use super::{Edit, Effect, Names, Scales, Signature, added, parameter, rounded};
use model_dsl::rig::Rig;

pub(super) fn effects(rig: &Rig, scales: &Scales, names: &mut Names, out: &mut Vec<Effect>) {
    let free: Vec<usize> = (0..rig.coordinates.len()).filter(|&i| !rig.coordinates[i].prescribed).collect();
    if free.len() < 3 {
        return;
    }
    for j in 0..rig.inputs.len() {
        for &i in &free {
            gyroscopic(rig, j, i, &free, names, out);
            // what turns all the way round is no height
            if !turns(rig, scales, i) {
                ground(rig, scales, j, i, names, out);
            }
        }
    }
}

/// Thrust that changes with height, to first order about the middle of what the records have.
fn ground(rig: &Rig, scales: &Scales, j: usize, i: usize, names: &mut Names, out: &mut Vec<Effect>) {
    let (u, q) = (&rig.inputs[j].name, &rig.coordinates[i].name);
    let (low, high) = scales.range.get(i).copied().unwrap_or_default();
    let (unit, middle) = (of_coordinate(rig, i), rounded(0.5 * (low + high)));
    let name = names.free(&format!("k_h_{u}_{q}"));
    let written = if unit.text() == "1" { String::new() } else { format!(" {}", unit.text()) };
    let about = if middle == 0.0 { q.clone() } else { format!("({q} - {middle}{written})").replace("- -", "+ ") };
    let factor = format!("(1 + {name} * {about})");
    out.push(Effect {
        id: "ground_effect".to_owned(),
        place: format!("{u},{q}"),
        parameters: vec![parameter(&name, Text::one().by(&unit, -1).text(), false, "change of thrust by height")],
        shape: None,
        edit: Edit::Map { input: j, factor: Some(factor), addend: None, screened: None, besides: Vec::new() },
        signature: Signature::Parameters,
        of_the_day: false,
        by_record: false,
    });
}

/// A rotor's momentum, by its command, times the rate of another axis.
fn gyroscopic(rig: &Rig, j: usize, i: usize, free: &[usize], names: &mut Names, out: &mut Vec<Effect>) {
    let (u, q) = (&rig.inputs[j].name, &rig.coordinates[i].name);
    let input = Text::read(&rig.inputs[j].unit.text);
    for &k in free.iter().filter(|&&k| k != i) {
        let v = &rig.coordinates[k].name;
        let name = names.free(&format!("H_{u}_{v}_{q}"));
        let unit = of_row(rig, i).by(&input, -1).by(&of_rate(rig, k), -1).text();
        let p = parameter(&name, unit, false, "rotor momentum by input");
        let statement = format!("torque gyroscopic_{u}_{v}_{q} on {q}: {name} * {u} * {v}.dot;");
        out.push(added("rotor_gyroscopic", &format!("{u},{v}->{q}"), vec![p], None, statement));
    }
}
