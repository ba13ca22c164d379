//! Applied forces: wrenches on links, and generalized forces.

use super::newton_euler::{Wrench, project};
use super::tree::Tree;
use super::vector::{V3, cross3, neg3};
use crate::expr::{Graph, Id};
use crate::lower::Lowering;
use model_dsl::rig::{Expr, Force, ForceKind, FrameRef, Rig};

/// Wrenches of one applied force on the links that it acts on.
pub fn wrenches(force: &Force, tree: &Tree, lowering: &Lowering, g: &mut Graph) -> Vec<(usize, Wrench)> {
    let vector = |g: &mut Graph, v: &[Expr; 3]| -> V3 { std::array::from_fn(|k| lowering.expr(g, &v[k])) };
    g.set_scope(force.name.clone());
    let mut out = Vec::new();
    match &force.kind {
        ForceKind::Force { frame, point, vector: f, axes, against } => {
            let (point, f) = (vector(g, point), vector(g, f));
            let mut push = |g: &mut Graph, on: FrameRef, negative: bool| {
                if let Some(link) = tree.link_of(on) {
                    let p = tree.express_point(g, point, tree.link_of(*frame), Some(link));
                    let mut f = tree.express(g, f, tree.link_of(*axes), Some(link));
                    if negative {
                        f = neg3(g, f);
                    }
                    let n = cross3(g, p, f);
                    out.push((link, Wrench { f, n }));
                }
            };
            push(g, *frame, false);
            if let Some(other) = against {
                push(g, *other, true);
            }
        }
        ForceKind::Torque { frame, vector: n, axes, against } => {
            let n = vector(g, n);
            let mut turn = |g: &mut Graph, on: FrameRef, negative: bool| {
                if let Some(link) = tree.link_of(on) {
                    let mut n = tree.express(g, n, tree.link_of(*axes), Some(link));
                    if negative {
                        n = neg3(g, n);
                    }
                    let f = super::vector::zero3(g);
                    out.push((link, Wrench { f, n }));
                }
            };
            turn(g, *frame, false);
            if let Some(other) = against {
                turn(g, *other, true);
            }
        }
        ForceKind::Generalized { .. } => {}
    }
    out
}

/// Sum of the wrenches of all forces that `takes` accepts.
pub fn all_wrenches(rig: &Rig, tree: &Tree, lowering: &Lowering, g: &mut Graph, takes: impl Fn(&Force) -> bool) -> Vec<Wrench> {
    let zero = Wrench::zero(g);
    let mut total = vec![zero; tree.links.len()];
    for force in rig.forces.iter().filter(|f| takes(f)) {
        for (link, wrench) in wrenches(force, tree, lowering, g) {
            total[link] = total[link].plus(g, &wrench);
        }
    }
    total
}

/// Generalized forces written on coordinates, for the forces that `takes` accepts.
pub fn on_coordinates(rig: &Rig, lowering: &Lowering, g: &mut Graph, takes: impl Fn(&Force) -> bool) -> Vec<Id> {
    let mut q = vec![g.zero(); rig.coordinates.len()];
    for force in rig.forces.iter().filter(|f| takes(f)) {
        if let ForceKind::Generalized { coordinate, value } = &force.kind {
            g.set_scope(force.name.clone());
            let value = lowering.expr(g, value);
            q[*coordinate] = g.add(q[*coordinate], value);
        }
    }
    q
}

/// Generalized force Q of the forces that `takes` accepts.
pub fn generalized(rig: &Rig, tree: &Tree, lowering: &Lowering, g: &mut Graph, takes: impl Fn(&Force) -> bool + Copy) -> Vec<Id> {
    let wrenches = all_wrenches(rig, tree, lowering, g, takes);
    let mut q = project(tree, g, &wrenches, "_applied");
    for (total, part) in q.iter_mut().zip(on_coordinates(rig, lowering, g, takes)) {
        *total = g.add(*total, part);
    }
    q
}
