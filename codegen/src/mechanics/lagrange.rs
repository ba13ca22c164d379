//! Second road: d/dt dT/dv - dT/dq + dV/dq on the same graph.

use super::bodies::{central, kinetic};
use super::newton_euler::{angular_velocities, origin_velocities};
use super::tree::Tree;
use crate::expr::{Derivative, Graph, Id};
use crate::lower::Lowering;
use model_dsl::rig::Rig;

/// M and velocity products of a kinetic energy: T = 1/2 v^T M v.
pub struct Kinetic {
    /// M(q).
    pub mass_matrix: Vec<Vec<Id>>,
    /// c(q, v): (dp/dq) v - dT/dq with p = dT/dv.
    pub coriolis: Vec<Id>,
}

/// Kinetic energy of all bodies.
pub fn kinetic_energy(rig: &Rig, tree: &Tree, lowering: &Lowering, g: &mut Graph) -> Id {
    let omega = angular_velocities(tree, g, lowering.rates());
    let v = origin_velocities(tree, g, &omega, lowering.rates());
    let mut total = g.zero();
    for body in &rig.bodies {
        if let Some(link) = tree.link_of(body.frame) {
            g.set_scope(body.name.clone());
            let own = central(body, lowering, g);
            let energy = kinetic(g, &own, omega[link], v[link]);
            total = g.add(total, energy);
        }
    }
    total
}

/// Lagrange's equation for a kinetic energy.
pub fn from_kinetic_energy(g: &mut Graph, t: Id, lowering: &Lowering) -> Kinetic {
    let momentum = g.gradient(t, &lowering.v, Derivative::Exact);
    let mass_matrix = g.jacobian(&momentum, &lowering.v, Derivative::Exact);
    let seeds: Vec<_> = lowering.q.iter().copied().zip(lowering.rates().iter().copied()).collect();
    let carried = g.directional(&momentum, &seeds);
    let pull = g.gradient(t, &lowering.q, Derivative::Exact);
    let coriolis = carried.iter().zip(&pull).map(|(&a, &b)| g.sub(a, b)).collect();
    Kinetic { mass_matrix, coriolis }
}

/// dV/dq.
pub fn from_potential(g: &mut Graph, v: Id, lowering: &Lowering) -> Vec<Id> {
    g.gradient(v, &lowering.q, Derivative::Exact)
}
