//! E0305, W0401, W0402, W0403, N0501: what is declared and not used, or used only in what an assumption drops.

use super::Context;
use crate::diagnostic::Diagnostic;
use crate::rig::{Along, AssumptionKind, Expr, ForceKind, FrameRef, Step, Symbol};
use std::collections::BTreeSet;

/// E0305; which coordinates nothing uses.
pub(super) fn coordinates(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) -> Vec<bool> {
    let used = |i: usize| [Symbol::Coordinate(i), Symbol::Rate(i), Symbol::Acceleration(i)].iter().any(|s| c.used.contains(s));
    let torques = |i: usize| c.rig.forces.iter().any(|f| matches!(f.kind, ForceKind::Generalized { coordinate, .. } if coordinate == i));
    let unused: Vec<bool> = (0..c.rig.coordinates.len()).map(|i| !used(i) && !torques(i)).collect();
    for (q, _) in c.rig.coordinates.iter().zip(&unused).filter(|(_, u)| **u) {
        let step = if q.unit.text == "m" { format!("translate({}, 0, 0)", q.name) } else { format!("rotate(z, {})", q.name) };
        diagnostics.push(
            Diagnostic::error(
                "E0305",
                format!("nothing moves with the coordinate `{}`", q.name),
                q.span,
                "no frame, force or equation depends on it",
            )
            .help(format!("let a frame move with it, as in `frame NAME = ground.{step};`, or remove it")),
        );
    }
    unused
}

pub(super) fn check(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    for (k, p) in c.rig.parameters.iter().enumerate() {
        let used = p.definition.map_or_else(|| c.used.contains(&Symbol::Parameter(k)), |d| c.used.contains(&Symbol::Definition(d)));
        if !used {
            let what = if p.constant {
                "constant"
            } else if p.definition.is_some() {
                "lump"
            } else {
                "parameter"
            };
            diagnostics.push(
                Diagnostic::warning("W0401", format!("nothing uses the {what} `{}`", p.name), p.span, "declared here")
                    .help("remove it, or use it"),
            );
        }
    }
    // a lump may be there only to name what equations show
    for (k, d) in c.rig.definitions.iter().enumerate().filter(|(_, d)| !d.is_lump) {
        if !c.used.contains(&Symbol::Definition(k)) {
            let message = format!("nothing uses the derived parameter `{}`", d.name);
            diagnostics.push(Diagnostic::warning("W0401", message, d.span, "declared here").help("remove it, or use it"));
        }
    }
    signals(c, diagnostics);
    frames(c, diagnostics);
    assumed_away(c, diagnostics);
}

fn signals(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    let mixed = |i: usize| {
        c.rig.mixes.iter().enumerate().any(|(m, mix)| {
            mix.rows
                .iter()
                .enumerate()
                .any(|(r, row)| c.used.contains(&Symbol::Mixed(m, r)) && mix.inputs.iter().zip(row).any(|(&j, k)| j == i && *k != 0.0))
        })
    };
    for (i, u) in c.rig.inputs.iter().enumerate() {
        // an input with a path is used where its actuator is
        let own = c.rig.actuators.iter().position(|a| a.name == u.name);
        let used = own.map_or_else(|| c.used.contains(&Symbol::Input(i)), |a| c.used.contains(&Symbol::Actuator(a)));
        if !used && !mixed(i) {
            diagnostics.push(
                Diagnostic::warning("W0402", format!("nothing uses the input `{}`", u.name), u.span, "declared here")
                    .help("let a force or torque depend on it, or remove it"),
            );
        }
    }
    for (k, a) in c.rig.actuators.iter().enumerate() {
        if !c.rig.inputs.iter().any(|u| u.name == a.name) && !c.used.contains(&Symbol::Actuator(k)) {
            diagnostics.push(
                Diagnostic::warning("W0402", format!("nothing uses the actuator `{}`", a.name), a.span, "declared here")
                    .help("let a force or torque depend on it, or remove it"),
            );
        }
    }
}

fn frames(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    let mut named = vec![false; c.rig.frames.len()];
    let mut name = |f: &FrameRef| {
        if let FrameRef::Frame(k) = f {
            named[*k] = true;
        }
    };
    c.rig.frames.iter().for_each(|f| name(&f.parent));
    c.rig.bodies.iter().for_each(|b| name(&b.frame));
    for f in &c.rig.forces {
        match &f.kind {
            ForceKind::Force { frame, axes, against, .. } | ForceKind::Torque { frame, axes, against, .. } => {
                [Some(frame), Some(axes), against.as_ref()].into_iter().flatten().for_each(&mut name);
            }
            ForceKind::Generalized { .. } => {}
        }
    }
    for along in c.rig.springs.iter().map(|s| &s.along).chain(c.rig.dampers.iter().map(|d| &d.along)) {
        if let Along::Points { from, to } = along {
            name(&from.0);
            name(&to.0);
        }
    }
    for (f, _) in c.rig.frames.iter().zip(&named).filter(|(_, named)| !**named) {
        diagnostics.push(
            Diagnostic::warning(
                "W0403",
                format!("the frame `{}` carries nothing", f.name),
                c.head("frame", &f.name, f.span),
                "no body, force or frame is on it",
            )
            .help("remove it, or put a body on it"),
        );
    }
}

/// N0501: parameters that the equations lose to an assumption.
fn assumed_away(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    if c.rig.assumptions.is_empty() {
        return;
    }
    let alive = alive(c);
    for (k, p) in c.rig.parameters.iter().enumerate() {
        let used = p.definition.map_or_else(|| c.used.contains(&Symbol::Parameter(k)), |d| c.used.contains(&Symbol::Definition(d)));
        if used && !alive.contains(&k) {
            diagnostics.push(Diagnostic::note(
                "N0501",
                format!("the assumptions leave `{}` without effect", p.name),
                p.span,
                "does not occur in the equations",
            ));
        }
    }
}

/// Parameters that stand in what the assumptions leave.
fn alive(c: &Context<'_>) -> BTreeSet<usize> {
    let rig = c.rig;
    let mut all = Vec::new();
    let whole = |rows: &Option<Vec<usize>>| rows.as_ref().is_none_or(|r| (0..rig.coordinates.len()).all(|i| r.contains(&i)));
    let any = |test: &dyn Fn(&AssumptionKind) -> bool| rig.assumptions.iter().any(|a| test(&a.kind));
    let coriolis = any(&|k| matches!(k, AssumptionKind::NeglectCoriolis { rows } if whole(rows)));
    let diagonal = any(&|k| matches!(k, AssumptionKind::InertiaDiagonal(_)));
    let friction = any(&|k| matches!(k, AssumptionKind::NeglectFriction { rows } if whole(rows)));
    let weightless = any(&|k| matches!(k, AssumptionKind::NeglectGravity { bodies: None, rows } if whole(rows)));
    let dropped = |name: &str| any(&|k| matches!(k, AssumptionKind::NeglectTerm { name: n, rows } if n == name && whole(rows)));
    let mut see = |e: &Expr| all.extend(e.symbols());
    for (k, b) in rig.bodies.iter().enumerate() {
        let falls = rig.gravity.is_some()
            && !weightless
            && !any(&|a| matches!(a, AssumptionKind::NeglectGravity { bodies: Some(list), rows } if list.contains(&k) && whole(rows)));
        let inert = !(coriolis && diagonal);
        if inert {
            b.inertia.iter().for_each(&mut see);
        }
        if inert || falls {
            see(&b.mass);
            b.center.iter().for_each(&mut see);
        }
    }
    if !weightless && let Some(g) = &rig.gravity {
        g.acceleration.iter().for_each(&mut see);
    }
    for f in &rig.frames {
        for step in &f.steps {
            match step {
                Step::Rotate { angle, .. } => see(angle),
                Step::Translate(offset) => offset.iter().for_each(&mut see),
            }
        }
    }
    for f in rig.forces.iter().filter(|f| !dropped(&f.name)) {
        match &f.kind {
            ForceKind::Force { point, vector, .. } => point.iter().chain(vector).for_each(&mut see),
            ForceKind::Torque { vector, .. } => vector.iter().for_each(&mut see),
            ForceKind::Generalized { value, .. } => see(value),
        }
    }
    let along = |a: &Along, see: &mut dyn FnMut(&Expr)| match a {
        Along::Coordinate(e) => see(e),
        Along::Points { from, to } => from.1.iter().chain(&to.1).for_each(see),
    };
    for s in rig.springs.iter().filter(|s| !dropped(&s.name)) {
        along(&s.along, &mut see);
        [&s.stiffness, &s.rest, &s.cubic].into_iter().for_each(&mut see);
    }
    if !friction {
        for d in rig.dampers.iter().filter(|d| !dropped(&d.name)) {
            along(&d.along, &mut see);
            see(&d.viscous);
        }
        for f in rig.frictions.iter().filter(|f| !dropped(&f.name)) {
            see(&f.of);
            let pairs = [&f.stribeck, &f.asymmetric].into_iter().flatten().flat_map(|(a, b)| [a, b]);
            [&f.viscous, &f.coulomb, &f.width, &f.quadratic].into_iter().flatten().chain(pairs).for_each(&mut see);
        }
    }
    rig.functions.iter().filter(|f| !dropped(&f.name)).for_each(|f| see(&f.value));
    for e in &rig.equations {
        e.mass.iter().for_each(|(_, k)| see(k));
        see(&e.rhs);
    }
    rig.coordinates.iter().filter_map(|q| q.trajectory.as_ref()).for_each(&mut see);
    for a in &rig.actuators {
        see(&a.map);
        let ends = a.saturation.iter().flat_map(|(lo, hi)| [lo, hi]);
        [&a.delay, &a.dead_zone, &a.lag].into_iter().flatten().chain(ends).for_each(&mut see);
    }
    for o in &rig.outputs {
        see(&o.value);
        [&o.scale, &o.bias, &o.delay, &o.play].into_iter().flatten().for_each(&mut see);
        o.encoder.iter().filter_map(|e| e.zero.as_ref()).for_each(&mut see);
    }
    rig.trims.iter().flat_map(|t| &t.fixed).for_each(|(_, e)| see(e));
    for a in &rig.assumptions {
        if let AssumptionKind::InertiaDiagonal(entries) = &a.kind {
            entries.iter().for_each(&mut see);
        }
    }
    let mut out = BTreeSet::new();
    // definitions stand behind what they use: backwards, each has been asked for before it is opened
    let mut wanted: BTreeSet<usize> = BTreeSet::new();
    let take = |list: &[Symbol], wanted: &mut BTreeSet<usize>, out: &mut BTreeSet<usize>| {
        for s in list {
            match s {
                Symbol::Parameter(k) => {
                    out.insert(*k);
                }
                Symbol::Definition(k) => {
                    wanted.insert(*k);
                }
                _ => {}
            }
        }
    };
    take(&all, &mut wanted, &mut out);
    for k in (0..rig.definitions.len()).rev() {
        if wanted.contains(&k) {
            let d = &rig.definitions[k];
            // the definition of a lump with a value of its own is what it stands for when lumps are expanded
            out.extend(d.parameter);
            take(&d.value.symbols(), &mut wanted, &mut out);
        }
    }
    for a in &rig.assumptions {
        if let AssumptionKind::Set { parameter, .. } = a.kind {
            out.remove(&parameter);
        }
    }
    out
}
