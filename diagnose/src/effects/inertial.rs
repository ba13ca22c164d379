//! Effects of masses: where they are, how many there are, which way is down, and what an assumption left out.

use super::{Edit, Effect, EffectParameter, Names, Signature, at_most, parameter};
use model_dsl::rig::{AssumptionKind, FrameRef, Rig};

/// A base that leans by more than this [rad] would be seen.
const STEEPEST: f64 = 0.5;

pub(super) fn effects(rig: &Rig, names: &mut Names, out: &mut Vec<Effect>) {
    let mut add = |id: &str, place: &str, parameters: Vec<EffectParameter>, edit: Edit, signature: Signature| {
        out.push(Effect {
            id: id.to_owned(),
            place: place.to_owned(),
            parameters,
            shape: None,
            edit,
            signature,
            of_the_day: false,
            by_record: false,
        });
    };
    for (k, body) in rig.bodies.iter().enumerate() {
        let FrameRef::Frame(frame) = body.frame else { continue };
        if rig.gravity.is_some() {
            for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
                let name = names.free(&format!("d{letter}_{}", body.name));
                let p = vec![parameter(&name, "m".to_owned(), false, "offset of the centre of mass")];
                let place = format!("{}.{letter}", body.name);
                add("gravity_offset", &place, p, Edit::Center { body: k, axis, value: name }, Signature::Parameters);
            }
        }
        let name = names.free(&format!("dm_{}", body.name));
        let p = vec![parameter(&name, "kg".to_owned(), true, "mass more")];
        let statement = format!("body added_{} on {} {{ mass {name}; at {{center of {k}}}; }}", body.name, rig.frames[frame].name);
        add("added_mass", &body.name, p, Edit::Add(statement), Signature::Parameters);
    }
    if let Some(gravity) = &rig.gravity
        && gravity.direction.is_none()
    {
        let (x, y) = (names.free("tilt_x"), names.free("tilt_y"));
        let p = vec![
            at_most(STEEPEST, parameter(&x, "rad".to_owned(), false, "lean of the base towards x")),
            at_most(STEEPEST, parameter(&y, "rad".to_owned(), false, "lean of the base towards y")),
        ];
        let along = format!("(sin({x}), cos({x}) * sin({y}), -cos({x}) * cos({y}))");
        out.push(Effect {
            id: "base_tilt".to_owned(),
            place: "ground".to_owned(),
            parameters: p,
            shape: None,
            edit: Edit::Gravity(along),
            signature: Signature::Parameters,
            of_the_day: true,
            by_record: false,
        });
    }
    for (k, assumption) in rig.assumptions.iter().enumerate() {
        let place = match &assumption.kind {
            AssumptionKind::Set { .. } => continue,
            AssumptionKind::NeglectCoriolis { .. } => "coriolis".to_owned(),
            AssumptionKind::NeglectGravity { .. } => "gravity".to_owned(),
            AssumptionKind::NeglectFriction { .. } => "friction".to_owned(),
            AssumptionKind::NeglectTerm { name, .. } => name.clone(),
            AssumptionKind::NeglectInertia { row, column } => {
                format!("inertia[{}, {}]", rig.coordinates[*row].name, rig.coordinates[*column].name)
            }
            AssumptionKind::InertiaDiagonal(_) => "inertia diag".to_owned(),
        };
        out.push(Effect {
            id: "neglected_inertia".to_owned(),
            place,
            parameters: Vec::new(),
            shape: None,
            edit: Edit::Assumption(k),
            signature: Signature::Towards,
            of_the_day: false,
            by_record: false,
        });
    }
}
