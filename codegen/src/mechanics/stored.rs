//! Energies: potentials of springs and of functions written directly, gravity's potential, kinetic functions.

use super::bodies::central;
use super::tree::Tree;
use super::vector::{V3, dot3, sub3};
use crate::expr::{F1, Graph, Id};
use crate::lower::Lowering;
use model_dsl::rig::{Along, EnergyKind, Expr, FrameRef, Rig};

/// Distance between two points of frames.
pub fn distance(tree: &Tree, lowering: &Lowering, g: &mut Graph, from: &(FrameRef, [Expr; 3]), to: &(FrameRef, [Expr; 3])) -> Id {
    let (a, b) = (tree.link_of(from.0), tree.link_of(to.0));
    let meet = tree.common(a, b);
    let place = |g: &mut Graph, link: Option<usize>, p: &[Expr; 3]| -> V3 {
        let p: V3 = std::array::from_fn(|k| lowering.expr(g, &p[k]));
        tree.express_point(g, p, link, meet)
    };
    let (p, q) = (place(g, a, &from.1), place(g, b, &to.1));
    let d = sub3(g, q, p);
    let dd = dot3(g, d, d);
    g.call(F1::Sqrt, dd)
}

/// Potential energy of springs and potential functions that `takes` accepts.
pub fn spring_potential(rig: &Rig, tree: &Tree, lowering: &Lowering, g: &mut Graph, takes: impl Fn(&str) -> bool) -> Id {
    let mut total = g.zero();
    for spring in rig.springs.iter().filter(|s| takes(&s.name)) {
        g.set_scope(spring.name.clone());
        let x = match &spring.along {
            Along::Coordinate(expr) => lowering.expr(g, expr),
            Along::Points { from, to } => distance(tree, lowering, g, from, to),
        };
        let (k, rest, k3) = (lowering.expr(g, &spring.stiffness), lowering.expr(g, &spring.rest), lowering.expr(g, &spring.cubic));
        let stretch = g.sub(x, rest);
        let square = g.square(stretch);
        let fourth = g.square(square);
        let (half, quarter) = (g.num(0.5), g.num(0.25));
        let (k, k3) = (g.mul(half, k), g.mul(quarter, k3));
        let (linear, cubic) = (g.mul(k, square), g.mul(k3, fourth));
        let energy = g.add(linear, cubic);
        total = g.add(total, energy);
    }
    for function in rig.functions.iter().filter(|f| f.kind == EnergyKind::Potential && takes(&f.name)) {
        g.set_scope(function.name.clone());
        let value = lowering.expr(g, &function.value);
        total = g.add(total, value);
    }
    total
}

/// Kinetic energy of functions written directly that `takes` accepts.
pub fn kinetic_functions(rig: &Rig, lowering: &Lowering, g: &mut Graph, takes: impl Fn(&str) -> bool) -> Id {
    let mut total = g.zero();
    for function in rig.functions.iter().filter(|f| f.kind == EnergyKind::Kinetic && takes(&f.name)) {
        g.set_scope(function.name.clone());
        let value = lowering.expr(g, &function.value);
        total = g.add(total, value);
    }
    total
}

/// Acceleration of free fall in ground.
pub fn free_fall(rig: &Rig, lowering: &Lowering, g: &mut Graph) -> V3 {
    match &rig.gravity {
        Some(gravity) => std::array::from_fn(|k| lowering.expr(g, &gravity.acceleration[k])),
        None => super::vector::zero3(g),
    }
}

/// Potential energy of gravity, -m g . p_WC summed over the bodies that `takes` accepts; zero at ground's origin.
pub fn gravity_potential(rig: &Rig, tree: &Tree, lowering: &Lowering, g: &mut Graph, takes: impl Fn(usize) -> bool) -> Id {
    let fall = free_fall(rig, lowering, g);
    let mut total = g.zero();
    for (k, body) in rig.bodies.iter().enumerate() {
        if !takes(k) {
            continue;
        }
        g.set_scope(body.name.clone());
        let own = central(body, lowering, g);
        let p = tree.express_point(g, own.c, tree.link_of(body.frame), None);
        let height = dot3(g, fall, p);
        let energy = g.mul(own.m, height);
        total = g.sub(total, energy);
    }
    total
}
