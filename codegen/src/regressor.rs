//! The regressor of inverse dynamics: ID(q, v, a) = Y(q, v, a) pi + rest
//! (Siciliano et al., Robotics, 2009, section 7.2.2).
//!
//! Each link's bodies enter linearly through (m, m c, I about the link's origin); user parameters of
//! friction, forces, springs and functions enter as columns of their own where ID is affine in them.
//! What is not affine stays in `rest` and is listed.

use crate::derive::BodyRoad;
use crate::expr::{Derivative, Differentiable, Graph, Id, SymbolId, SymbolKind};
use crate::lower::{Lowering, Lumps};
use crate::mechanics::bodies::{Inertia, per_link};
use crate::mechanics::tree::Tree;
use crate::mechanics::{forces, friction, lagrange, stored};
use model_dsl::rig::Rig;

/// One entry of pi.
pub struct Column {
    /// `m_heli`, `mc_heli_z`, `I_heli_xx`, or the parameter's own name.
    pub name: String,
    /// Its value, over the rig's parameters.
    pub value: Id,
    /// Column of Y: one entry a coordinate.
    pub entries: Vec<Id>,
}

/// Y, pi and what is left.
pub struct Regressor {
    /// Where the expressions live.
    pub graph: Graph,
    /// Symbols: q, v, a, parameters.
    pub q: Vec<SymbolId>,
    /// Rates.
    pub v: Vec<SymbolId>,
    /// Accelerations.
    pub a: Vec<SymbolId>,
    /// Signals.
    pub u: Vec<SymbolId>,
    /// Actuator states.
    pub z: Vec<SymbolId>,
    /// Columns with a structurally non-zero entry.
    pub columns: Vec<Column>,
    /// The part of ID that is in no column (known forces, terms that are not affine).
    pub rest: Vec<Id>,
    /// Parameters in which ID is not affine.
    pub not_affine: Vec<String>,
    /// Entries of links' masses, first moments and inertias that are in no equation.
    pub dead: Vec<String>,
}

/// Regressor of a rig with bodies; `None` for equations written directly. Assumptions other than `set`
/// are not applied: the regressor is that of the full derivation.
#[must_use]
pub fn regressor(rig: &Rig, lumps: Lumps) -> Option<Regressor> {
    if !rig.equations.is_empty() {
        return None;
    }
    let mut graph = Graph::new();
    let g = &mut graph;
    let lowering = Lowering::new(rig, lumps, true, g);
    let tree = Tree::new(rig, &lowering, g);
    let actual = per_link(rig, &tree, &lowering, g, |_| true);

    // inertias as symbols of their own, where a link carries anything
    let mut columns: Vec<(String, Id, SymbolId)> = Vec::new();
    let mut inertia = Vec::new();
    for (link, own) in actual.iter().enumerate() {
        let name = &tree.links[link].name;
        let mut take = |g: &mut Graph, what: String, value: Id| {
            if g.is_zero(value) {
                return value;
            }
            let id = g.symbol(&what, SymbolKind::Inertial(columns.len()));
            if let Some(symbol) = g.symbol_of(id) {
                columns.push((what, value, symbol));
            }
            id
        };
        let m = take(g, format!("m_{name}"), own.m);
        let mc = std::array::from_fn(|k| take(g, format!("mc_{name}_{}", ["x", "y", "z"][k]), own.mc[k]));
        let i = std::array::from_fn(|k| take(g, format!("I_{name}_{}", ["xx", "yy", "zz", "xy", "xz", "yz"][k]), own.i[k]));
        inertia.push(Inertia { m, mc, i });
    }
    let energy = stored::kinetic_functions(rig, &lowering, g, |_| true);
    let road = BodyRoad {
        functions: lagrange::from_kinetic_energy(g, energy, &lowering),
        applied: forces::all_wrenches(rig, &tree, &lowering, g, |_| true),
        applied_on_coordinates: forces::on_coordinates(rig, &lowering, g, |_| true),
        inertia,
        tree,
    };
    let accelerations: Vec<Id> = lowering.a.iter().map(|&s| g.node_of_symbol(s)).collect();
    let mut total = road.residual(rig, &lowering, g, &accelerations);
    let energy = stored::spring_potential(rig, &road.tree, &lowering, g, |_| true);
    let springs = lagrange::from_potential(g, energy, &lowering);
    let losses = friction::dissipation(rig, &road.tree, &lowering, g, |_| true);
    for (value, (&s, &d)) in total.iter_mut().zip(springs.iter().zip(&losses)) {
        *value = g.add(*value, s);
        *value = g.add(*value, d);
    }

    // user parameters outside the bodies: affine if no entry of dID/dp depends on any of them again
    let mut outside: Vec<(usize, Vec<Id>)> = Vec::new();
    let rows = Differentiable::new(g, &total);
    for (k, &symbol) in lowering.p.iter().enumerate() {
        let slopes = rows.by(g, symbol, Derivative::Exact);
        if slopes.iter().any(|&d| !g.is_zero(d)) {
            outside.push((k, slopes));
        }
    }
    let mut not_affine = Vec::new();
    let parameters = lowering.p.clone();
    for (k, slopes) in outside {
        let again = slopes.iter().any(|&d| g.depends(d, |s| parameters.contains(&s) || columns.iter().any(|c| c.2 == s)));
        if again {
            not_affine.push(rig.parameters[k].name.clone());
        } else {
            columns.push((rig.parameters[k].name.clone(), g.node_of_symbol(parameters[k]), parameters[k]));
        }
    }
    let symbols: Vec<SymbolId> = columns.iter().map(|c| c.2).collect();
    let y = g.jacobian(&total, &symbols, Derivative::Exact);
    let zero = g.zero();
    let rest = g.substitute(&total, |s| symbols.contains(&s).then_some(zero));
    let (columns, dead): (Vec<Column>, Vec<Column>) = columns
        .into_iter()
        .enumerate()
        .map(|(j, (name, value, _))| Column { name, value, entries: y.iter().map(|row| row[j]).collect() })
        .partition(|c| c.entries.iter().any(|&e| !g.is_zero(e)));
    let dead = dead.into_iter().map(|c| c.name).collect();
    Some(Regressor { q: lowering.q, v: lowering.v, a: lowering.a, u: lowering.u, z: lowering.z, columns, rest, not_affine, dead, graph })
}
