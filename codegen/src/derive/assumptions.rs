//! Declared assumptions, applied to the full derivation in a fixed order: set (already in the lowering),
//! velocity products, gravity, friction, named terms, entries of M, all of M.

use super::parts::Parts;
use crate::expr::{Graph, Id};
use crate::lower::Lowering;
use crate::mechanics::bodies::per_link;
use crate::mechanics::newton_euler::{inertial_wrenches, project};
use crate::mechanics::tree::Tree;
use crate::mechanics::{forces, friction, lagrange, stored};
use model_dsl::rig::{AssumptionKind, Rig};

/// Applies the rig's assumptions. Where one changes M, velocity products, gravity or a named term, the
/// direct use of the tree in forward dynamics ends: the parts are what counts.
pub fn apply(rig: &Rig, lowering: &Lowering, g: &mut Graph, mut parts: Parts, wanted: bool) -> Parts {
    if !wanted || rig.assumptions.is_empty() {
        return parts;
    }
    let mut kinds: Vec<&AssumptionKind> = rig.assumptions.iter().map(|a| &a.kind).collect();
    kinds.sort_by_key(|kind| rank(kind));
    let tree = Tree::new(rig, lowering, g);
    let mut changed = false;
    for kind in kinds {
        parts.assumptions.push(in_words(rig, kind));
        if !matches!(kind, AssumptionKind::Set { .. } | AssumptionKind::NeglectFriction { .. }) {
            changed = true;
        }
        apply_one(rig, lowering, g, &tree, &mut parts, kind);
    }
    if changed {
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

fn apply_one(rig: &Rig, lowering: &Lowering, g: &mut Graph, tree: &Tree, parts: &mut Parts, kind: &AssumptionKind) {
    let zero = g.zero();
    let all: Vec<usize> = (0..rig.coordinates.len()).collect();
    let chosen = |rows: &Option<Vec<usize>>| rows.clone().unwrap_or_else(|| all.clone());
    let minus = |g: &mut Graph, from: &mut [Id], what: &[Id], rows: &[usize]| {
        for &i in rows {
            from[i] = g.sub(from[i], what[i]);
        }
    };
    match kind {
        AssumptionKind::Set { .. } => {}
        AssumptionKind::NeglectCoriolis { rows } => {
            if let Some(coriolis) = &mut parts.coriolis {
                for i in chosen(rows) {
                    coriolis[i] = zero;
                }
            }
        }
        AssumptionKind::NeglectGravity { bodies: None, rows } => {
            for i in chosen(rows) {
                parts.gravity[i] = zero;
            }
        }
        AssumptionKind::NeglectGravity { bodies: Some(bodies), rows } => {
            let inertia = per_link(rig, tree, lowering, g, |k| !bodies.contains(&k));
            let still = vec![zero; rig.coordinates.len()];
            let rest = vec![[zero; 3]; tree.links.len()];
            let fall = stored::free_fall(rig, lowering, g);
            let wrenches = inertial_wrenches(tree, g, &inertia, &rest, &still, &still, fall);
            let kept = project(tree, g, &wrenches, "_kept");
            for i in chosen(rows) {
                parts.gravity[i] = kept[i];
            }
        }
        AssumptionKind::NeglectFriction { rows } => {
            for i in chosen(rows) {
                parts.dissipation[i] = zero;
            }
        }
        AssumptionKind::NeglectTerm { name, rows } => {
            let rows = chosen(rows);
            if rig.forces.iter().any(|f| f.name == *name) {
                let dropped = forces::generalized(rig, tree, lowering, g, |f| f.name == *name);
                if rows.len() == all.len() {
                    // derive again without it: cleaner than a difference
                    let named: Vec<String> = rig
                        .assumptions
                        .iter()
                        .filter_map(|a| match &a.kind {
                            AssumptionKind::NeglectTerm { name, rows: None } => Some(name.clone()),
                            _ => None,
                        })
                        .collect();
                    parts.force = forces::generalized(rig, tree, lowering, g, |f| !named.contains(&f.name));
                } else {
                    minus(g, &mut parts.force, &dropped, &rows);
                }
            }
            let energy = stored::spring_potential(rig, tree, lowering, g, |n| n == name);
            let springs = lagrange::from_potential(g, energy, lowering);
            minus(g, &mut parts.springs, &springs, &rows);
            let losses = friction::dissipation(rig, tree, lowering, g, |n| n == name);
            minus(g, &mut parts.dissipation, &losses, &rows);
            let moving = stored::kinetic_functions(rig, lowering, g, |n| n == name);
            let moving = lagrange::from_kinetic_energy(g, moving, lowering);
            if let Some(coriolis) = &mut parts.coriolis {
                minus(g, coriolis, &moving.coriolis, &rows);
            }
            for &i in &rows {
                for j in 0..all.len() {
                    parts.mass_matrix[i][j] = g.sub(parts.mass_matrix[i][j], moving.mass_matrix[i][j]);
                    if !rows.contains(&j) {
                        parts.mass_matrix[j][i] = g.sub(parts.mass_matrix[j][i], moving.mass_matrix[j][i]);
                    }
                }
            }
        }
        AssumptionKind::NeglectInertia { row, column } => {
            parts.mass_matrix[*row][*column] = zero;
            parts.mass_matrix[*column][*row] = zero;
        }
        AssumptionKind::InertiaDiagonal(entries) => {
            let free: Vec<usize> = all.iter().copied().filter(|&i| !rig.coordinates[i].prescribed).collect();
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
            let of = bodies.as_ref().map_or(String::new(), |b| format!(" of {}", b.iter().map(|&k| rig.bodies[k].name.as_str()).collect::<Vec<_>>().join(", ")));
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
