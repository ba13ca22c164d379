//! Dissipative forces d(q, v), counted on the left-hand side: friction, dampers, dissipation functions.

use super::stored::distance;
use super::tree::{Tree, drives_of};
use crate::expr::{Derivative, F1, Graph, Id};
use crate::lower::Lowering;
use model_dsl::rig::{Along, EnergyKind, Friction, Rig};

/// Names of the statements that `takes` accepts, summed into one generalized force.
pub fn dissipation(rig: &Rig, tree: &Tree, lowering: &Lowering, g: &mut Graph, takes: impl Fn(&str) -> bool) -> Vec<Id> {
    let mut d = vec![g.zero(); rig.coordinates.len()];
    for friction in rig.frictions.iter().filter(|f| takes(&f.name)) {
        g.set_scope(format!("friction_{}", friction.name));
        let of = lowering.expr(g, &friction.of);
        let drives = drives_of(g, of, &lowering.q);
        let rate = Tree::drive_rate(g, &drives, lowering.rates());
        let force = friction_force(friction, lowering, g, rate);
        for (k, drive) in drives {
            let part = g.mul(drive, force);
            d[k] = g.add(d[k], part);
        }
    }
    for damper in rig.dampers.iter().filter(|d| takes(&d.name)) {
        g.set_scope(damper.name.clone());
        let length = match &damper.along {
            Along::Coordinate(expr) => lowering.expr(g, expr),
            Along::Points { from, to } => distance(tree, lowering, g, from, to),
        };
        let c = lowering.expr(g, &damper.viscous);
        let slopes = g.gradient(length, &lowering.q, Derivative::Exact);
        let parts: Vec<Id> = slopes.iter().zip(lowering.rates()).map(|(&s, &v)| g.mul(s, v)).collect();
        let rate = g.sum(&parts);
        let force = g.mul(c, rate);
        for (k, slope) in slopes.into_iter().enumerate() {
            let part = g.mul(slope, force);
            d[k] = g.add(d[k], part);
        }
    }
    for function in rig.functions.iter().filter(|f| f.kind == EnergyKind::Dissipation && takes(&f.name)) {
        g.set_scope(function.name.clone());
        let value = lowering.expr(g, &function.value);
        for (k, &v) in lowering.v.iter().enumerate() {
            let part = g.differentiate(&[value], v, Derivative::Exact)[0];
            d[k] = g.add(d[k], part);
        }
    }
    d
}

/// The friction law of [`Friction`] at one rate.
fn friction_force(friction: &Friction, lowering: &Lowering, g: &mut Graph, v: Id) -> Id {
    let mut total = g.zero();
    let add = |g: &mut Graph, total: &mut Id, part: Id| *total = g.add(*total, part);
    if let Some(viscous) = &friction.viscous {
        let c = lowering.expr(g, viscous);
        let part = g.mul(c, v);
        add(g, &mut total, part);
    }
    if friction.coulomb.is_some() || friction.stribeck.is_some() {
        let mut level = match &friction.coulomb {
            Some(f) => lowering.expr(g, f),
            None => g.zero(),
        };
        if let Some((excess, speed)) = &friction.stribeck {
            let (excess, speed) = (lowering.expr(g, excess), lowering.expr(g, speed));
            let ratio = g.div(v, speed);
            let square = g.square(ratio);
            let minus = g.neg(square);
            let bell = g.call(F1::Exp, minus);
            let part = g.mul(excess, bell);
            level = g.add(level, part);
        }
        let width = match &friction.width {
            Some(width) => lowering.expr(g, width),
            None => g.num(0.01),
        };
        let ratio = g.div(v, width);
        let direction = g.call(F1::SmoothSign, ratio);
        let part = g.mul(level, direction);
        add(g, &mut total, part);
    }
    if let Some(quadratic) = &friction.quadratic {
        let c = lowering.expr(g, quadratic);
        let size = g.call(F1::Abs, v);
        let drag = g.mul(v, size);
        let part = g.mul(c, drag);
        add(g, &mut total, part);
    }
    if let Some((slope, offset)) = &friction.asymmetric {
        let (slope, offset) = (lowering.expr(g, slope), lowering.expr(g, offset));
        let size = g.call(F1::Abs, v);
        let part = g.mul(slope, size);
        add(g, &mut total, part);
        add(g, &mut total, offset);
    }
    total
}
