//! Effects on the way from a motion to its measured value.

use super::joint::is_dry;
use super::unit::{Text, is_angle};
use super::{Edit, Effect, EffectParameter, LARGEST, Names, Scales, Signature, at_most, parameter};
use model_dsl::rig::{Expr, Output, Rig, Symbol};
use std::f64::consts::TAU;

pub(super) fn effects(rig: &Rig, scales: &Scales, names: &mut Names, out: &mut Vec<Effect>) {
    for (output, y) in rig.outputs.iter().enumerate() {
        let unit = Text::read(&y.unit.text);
        let unit_text = if unit == Text::one() { "rad".to_owned() } else { unit.text() };
        let mut add = |id: &str, place: String, p: EffectParameter, entry: &'static str, signature: Signature, of_the_day: bool| {
            let value = p.name.clone();
            let edit = Edit::Output { output, entry, value };
            out.push(Effect { id: id.to_owned(), place, parameters: vec![p], shape: None, edit, signature, of_the_day, by_record: false });
        };
        let name = names.free(&format!("y_0_{}", y.name));
        let p = EffectParameter { most: farthest(rig, scales, y), ..parameter(&name, unit_text.clone(), false, "zero of the sensor") };
        add("sensor_bias", y.name.clone(), p, "bias", Signature::Parameters, true);
        let name = names.free(&format!("s_y_{}", y.name));
        let p = at_most(LARGEST, parameter(&name, "1".to_owned(), false, "relative error of the sensor's scale"));
        add("sensor_scale", y.name.clone(), p, "scale", Signature::Parameters, false);
        let name = names.free(&format!("d_y_{}", y.name));
        let p = parameter(&name, "s".to_owned(), true, "delay of the sensor");
        add("sensor_delay", y.name.clone(), p, "delay", Signature::OutputDelay(output), false);
        let name = names.free(&format!("r_y_{}", y.name));
        let p = parameter(&name, unit.by(&Text::read("s"), -1).text(), false, "drift of the sensor");
        add("sensor_drift", y.name.clone(), p, "drift", Signature::Parameters, true);
        let own = if let Expr::Symbol(Symbol::Coordinate(own)) = y.value { Some(own) } else { None };
        // a joint that sticks stands like a reading within its play: where the text has dry friction, records hardly tell one from the other
        if own.is_none_or(|own| !is_dry(rig, own)) {
            let name = names.free(&format!("w_{}", y.name));
            let p = parameter(&name, unit_text, true, "play between joint and sensor");
            add("backlash", y.name.clone(), p, "play", Signature::Parameters, false);
        }
        let Some(own) = own else { continue };
        // an axis that leans reads a part of another angle
        if !is_angle(rig, own) {
            continue;
        }
        for (_, c) in rig.coordinates.iter().enumerate().filter(|(other, _)| *other != own && is_angle(rig, *other)) {
            let name = names.free(&format!("m_{}_{}", y.name, c.name));
            let p = at_most(LARGEST, parameter(&name, "1".to_owned(), false, "share of the other angle"));
            let value = format!("{name} * {}", c.name);
            out.push(Effect {
                id: "sensor_misalignment".to_owned(),
                place: format!("{}->{}", c.name, y.name),
                parameters: vec![p],
                shape: None,
                edit: Edit::Output { output, entry: "value", value },
                signature: Signature::Parameters,
                of_the_day: false,
                by_record: false,
            });
        }
    }
}

/// How far the zero of a sensor can be off (SI): a turn; the length of a way, and as far again as it was gone from its zero.
fn farthest(rig: &Rig, scales: &Scales, y: &Output) -> Option<f64> {
    let Expr::Symbol(Symbol::Coordinate(own)) = y.value else { return None };
    if is_angle(rig, own) {
        return Some(TAU);
    }
    let (lo, hi) = *scales.range.get(own)?;
    (hi > lo).then(|| (hi - lo) + hi.abs().max(lo.abs()))
}
