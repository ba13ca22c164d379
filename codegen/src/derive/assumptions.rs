//! Declared assumptions, applied to the full derivation in a fixed order: set (already in the lowering),
//! velocity products, gravity, friction, named terms, entries of M, all of M.

use super::parts::Parts;
use crate::expr::{Graph, Id};
use crate::lower::Lowering;
use crate::mechanics::bodies::per_link;
use crate::mechanics::newton_euler::{inertial_wrenches, project};
use crate::mechanics::tree::Tree;
use crate::mechanics::{direct, forces, friction, lagrange, stored};
use model_dsl::rig::{AssumptionKind, EnergyKind, Rig};
use std::collections::BTreeSet;

/// Applies the rig's assumptions. Where one changes M, velocity products, gravity or a named term, the
/// direct use of the tree in forward dynamics ends: the parts are what counts.
///
/// First it is gathered what each row loses, so that a term that two assumptions drop is dropped once.
pub fn apply(rig: &Rig, lowering: &Lowering, g: &mut Graph, mut parts: Parts, wanted: bool) -> Parts {
    if !wanted || rig.assumptions.is_empty() {
        return parts;
    }
    let mut kinds: Vec<&AssumptionKind> = rig.assumptions.iter().map(|a| &a.kind).collect();
    kinds.sort_by_key(|kind| rank(kind));
    parts.assumptions = kinds.iter().map(|kind| in_words(rig, kind)).collect();
    let losses: Vec<Losses> = (0..rig.coordinates.len()).map(|row| Losses::of_row(&kinds, row)).collect();
    let context = Context { rig, lowering, tree: Tree::new(rig, lowering, g), losses };
    context.mass_matrix(g, &mut parts);
    context.bias(g, &mut parts);
    context.dissipation(g, &mut parts);
    context.force(g, &mut parts);
    for kind in &kinds {
        replace_inertia(rig, lowering, g, &mut parts, kind);
    }
    if kinds.iter().any(|kind| !matches!(kind, AssumptionKind::Set { .. } | AssumptionKind::NeglectFriction { .. })) {
        parts.body_road = None;
        parts.bias = (0..rig.coordinates.len())
            .map(|i| {
                let moving = parts.coriolis.as_ref().map_or_else(|| g.zero(), |c| c[i]);
                let sum = g.add(moving, parts.gravity[i]);
                g.add(sum, parts.springs[i])
            })
            .collect();
    }
    parts
}

fn rank(kind: &AssumptionKind) -> usize {
    match kind {
        AssumptionKind::Set { .. } => 0,
        AssumptionKind::NeglectCoriolis { .. } => 1,
        AssumptionKind::NeglectGravity { .. } => 2,
        AssumptionKind::NeglectFriction { .. } => 3,
        AssumptionKind::NeglectTerm { .. } => 4,
        AssumptionKind::NeglectInertia { .. } => 5,
        AssumptionKind::InertiaDiagonal(_) => 6,
    }
}

/// What one row loses.
#[derive(Default)]
struct Losses {
    coriolis: bool,
    gravity: bool,
    friction: bool,
    /// Bodies whose gravity it loses.
    bodies: BTreeSet<usize>,
    /// Named forces, springs, dampers, frictions and functions.
    terms: BTreeSet<String>,
}

impl Losses {
    fn of_row(kinds: &[&AssumptionKind], row: usize) -> Self {
        let covers = |rows: &Option<Vec<usize>>| rows.as_ref().is_none_or(|r| r.contains(&row));
        let mut out = Self::default();
        for kind in kinds {
            match kind {
                AssumptionKind::NeglectCoriolis { rows } if covers(rows) => out.coriolis = true,
                AssumptionKind::NeglectGravity { bodies: None, rows } if covers(rows) => out.gravity = true,
                AssumptionKind::NeglectGravity { bodies: Some(bodies), rows } if covers(rows) => out.bodies.extend(bodies),
                AssumptionKind::NeglectFriction { rows } if covers(rows) => out.friction = true,
                AssumptionKind::NeglectTerm { name, rows } if covers(rows) => {
                    out.terms.insert(name.clone());
                }
                _ => {}
            }
        }
        out
    }
}

struct Context<'a> {
    rig: &'a Rig,
    lowering: &'a Lowering,
    tree: Tree,
    losses: Vec<Losses>,
}

impl Context<'_> {
    /// M without the kinetic functions that either row loses.
    fn mass_matrix(&self, g: &mut Graph, parts: &mut Parts) {
        for i in 0..self.losses.len() {
            for j in 0..self.losses.len() {
                let lost: BTreeSet<&String> = self.losses[i].terms.union(&self.losses[j].terms).collect();
                if self.rig.functions.iter().any(|f| f.kind == EnergyKind::Kinetic && lost.contains(&f.name)) {
                    let energy = stored::kinetic_functions(self.rig, self.lowering, g, |n| lost.iter().any(|l| *l == n));
                    let dropped = lagrange::from_kinetic_energy(g, energy, self.lowering);
                    parts.mass_matrix[i][j] = g.sub(parts.mass_matrix[i][j], dropped.mass_matrix[i][j]);
                }
            }
        }
    }

    /// Velocity products, gravity, springs and potentials.
    fn bias(&self, g: &mut Graph, parts: &mut Parts) {
        let zero = g.zero();
        for (i, lost) in self.losses.iter().enumerate() {
            if let Some(coriolis) = &mut parts.coriolis {
                if lost.coriolis {
                    coriolis[i] = zero;
                } else if !lost.terms.is_empty() {
                    let energy = stored::kinetic_functions(self.rig, self.lowering, g, |n| lost.terms.contains(n));
                    let dropped = lagrange::from_kinetic_energy(g, energy, self.lowering).coriolis[i];
                    coriolis[i] = g.sub(coriolis[i], dropped);
                }
            }
            if lost.gravity {
                parts.gravity[i] = zero;
            } else if !lost.bodies.is_empty() {
                parts.gravity[i] = self.gravity(g, &lost.bodies)[i];
            }
            if !lost.terms.is_empty() {
                let energy = stored::spring_potential(self.rig, &self.tree, self.lowering, g, |n| !lost.terms.contains(n));
                parts.springs[i] = lagrange::from_potential(g, energy, self.lowering)[i];
            }
        }
    }

    /// Gravity of all bodies but some.
    fn gravity(&self, g: &mut Graph, without: &BTreeSet<usize>) -> Vec<Id> {
        let zero = g.zero();
        let inertia = per_link(self.rig, &self.tree, self.lowering, g, |k| !without.contains(&k));
        let still = vec![zero; self.losses.len()];
        let rest = vec![[zero; 3]; self.tree.links.len()];
        let fall = stored::free_fall(self.rig, self.lowering, g);
        let wrenches = inertial_wrenches(&self.tree, g, &inertia, &rest, &still, &still, fall);
        project(&self.tree, g, &wrenches, "_kept")
    }

    fn dissipation(&self, g: &mut Graph, parts: &mut Parts) {
        for (i, lost) in self.losses.iter().enumerate() {
            if lost.friction {
                parts.dissipation[i] = g.zero();
            } else if !lost.terms.is_empty() {
                // what equations written directly hold has no name
                let written =
                    if self.rig.equations.is_empty() { g.zero() } else { direct::take_apart(self.rig, self.lowering, g).dissipation[i] };
                let kept = friction::dissipation(self.rig, &self.tree, self.lowering, g, |n| !lost.terms.contains(n))[i];
                parts.dissipation[i] = g.add(written, kept);
            }
        }
    }

    fn force(&self, g: &mut Graph, parts: &mut Parts) {
        for (i, lost) in self.losses.iter().enumerate() {
            if self.rig.forces.iter().any(|f| lost.terms.contains(&f.name)) {
                let written =
                    if self.rig.equations.is_empty() { g.zero() } else { direct::take_apart(self.rig, self.lowering, g).force[i] };
                let kept = forces::generalized(self.rig, &self.tree, self.lowering, g, |f| !lost.terms.contains(&f.name))[i];
                parts.force[i] = g.add(written, kept);
            }
        }
    }
}

/// Entries of M, then all of M.
fn replace_inertia(rig: &Rig, lowering: &Lowering, g: &mut Graph, parts: &mut Parts, kind: &AssumptionKind) {
    let zero = g.zero();
    match kind {
        AssumptionKind::NeglectInertia { row, column } => {
            parts.mass_matrix[*row][*column] = zero;
            parts.mass_matrix[*column][*row] = zero;
        }
        AssumptionKind::InertiaDiagonal(entries) => {
            let free: Vec<usize> = (0..rig.coordinates.len()).filter(|&i| !rig.coordinates[i].prescribed).collect();
            for (k, &i) in free.iter().enumerate() {
                for &j in &free {
                    parts.mass_matrix[i][j] = zero;
                }
                if let Some(entry) = entries.get(k) {
                    parts.mass_matrix[i][i] = lowering.expr(g, entry);
                }
            }
            parts.kinetic = None;
        }
        _ => {}
    }
}

/// An assumption as a person would say it.
fn in_words(rig: &Rig, kind: &AssumptionKind) -> String {
    let names = |rows: &[usize]| rows.iter().map(|&i| rig.coordinates[i].name.as_str()).collect::<Vec<_>>().join(", ");
    let within = |rows: &Option<Vec<usize>>| rows.as_ref().map_or(String::new(), |r| format!(" in {}", names(r)));
    match kind {
        AssumptionKind::Set { parameter, value } => format!("{} = {value}", rig.parameters[*parameter].name),
        AssumptionKind::NeglectCoriolis { rows } => format!("no velocity products{}", within(rows)),
        AssumptionKind::NeglectGravity { bodies, rows } => {
            let of = bodies.as_ref().map_or(String::new(), |b| {
                format!(" of {}", b.iter().map(|&k| rig.bodies[k].name.as_str()).collect::<Vec<_>>().join(", "))
            });
            format!("no gravity{of}{}", within(rows))
        }
        AssumptionKind::NeglectFriction { rows } => format!("no friction{}", within(rows)),
        AssumptionKind::NeglectTerm { name, rows } => format!("no {name}{}", within(rows)),
        AssumptionKind::NeglectInertia { row, column } => {
            format!("M[{}, {}] = 0", rig.coordinates[*row].name, rig.coordinates[*column].name)
        }
        AssumptionKind::InertiaDiagonal(entries) => {
            let list: Vec<String> = entries.iter().map(|e| crate::display::plain(rig, e)).collect();
            format!("M = diag({})", list.join(", "))
        }
    }
}
