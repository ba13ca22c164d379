//! Base parameters: the fewest combinations of a rig's parameters that its inverse dynamics depends on.
//!
//! Two questions are answered. [`base_parameters`] takes the equations as they are (assumptions applied, or written
//! directly) apart into products of parameters: everything unknown, geometry too. [`links`] asks the robotics
//! textbook's question of the full derivation: masses, first moments and inertias of links unknown, geometry and
//! gravity known.

use crate::draws::Draws;
use crate::rank::{self, Columns};
use codegen::display::{TorqueForm, torque_form};
use codegen::{Equations, Lumps, Regressor, regressor};
use model_dsl::rig::Rig;
use nalgebra::DMatrix;

/// A column of the stacked regressor is dependent if what it adds is below this part of its length.
pub const TOLERANCE: f64 = 1e-9;

/// One base parameter.
pub struct BaseParameter {
    /// What it is made of, over the rig's names.
    pub text: String,
    /// Its value (SI).
    pub value: f64,
    /// The products of parameters in it: (product, coefficient).
    pub terms: Vec<(usize, f64)>,
}

/// The minimal set.
pub struct Base {
    /// The products of parameters that stand in the equations.
    pub form: TorqueForm,
    /// Base parameters, plain ones first.
    pub parameters: Vec<BaseParameter>,
    /// Products of parameters before they were put together.
    pub products: usize,
    /// Parameters that stand in no equation.
    pub dead: Vec<String>,
    /// Parameters that show only together with others: no base parameter is theirs alone.
    pub combined: Vec<String>,
    /// Parameters inside functions of the motion: held at their values.
    pub inside: Vec<String>,
    /// States at which the regressor was stacked.
    pub states: usize,
    /// Smallest new part of a column that was kept.
    pub least_kept: f64,
    /// Largest new part of a column that was not.
    pub most_dropped: f64,
}

/// The minimal set of a model's equations; `None` where they are too long to be multiplied out.
#[must_use]
pub fn base_parameters(rig: &Rig, equations: &Equations, seed: u64) -> Option<Base> {
    let mut form = torque_form(rig, equations)?;
    let layout = &equations.layout;
    let nominal = |name: &str| layout.p.iter().position(|p| p.name == name).map_or(0.0, |i| layout.nominal[i]);
    let moving: Vec<&str> = layout.x().chain(&layout.u).chain(&layout.a).map(|v| v.name.as_str()).collect();
    let rows = form.rows();
    let states = 2 * form.len() / rows.max(1) + 20;
    let mut draws = Draws::new(seed);
    let mut stacked = DMatrix::zeros(states * rows, form.len());
    for s in 0..states {
        let values = state(rig, &moving, &mut draws);
        let time = draws.unit();
        let value = |name: &str| match moving.iter().position(|m| *m == name) {
            Some(i) => values[i],
            None if name == layout_time(equations) => time,
            None => nominal(name),
        };
        for (i, row) in form.regressor(&value).iter().enumerate() {
            row.iter().enumerate().for_each(|(j, &x)| stacked[(s * rows + i, j)] = x);
        }
    }
    let found = rank::columns(&stacked, TOLERANCE);
    let values = form.values(&nominal);
    let parameters: Vec<BaseParameter> = found
        .kept
        .iter()
        .enumerate()
        .map(|(k, &j)| {
            let terms = terms_of(&found, k, j);
            let value = terms.iter().map(|&(i, c)| c * values[i]).sum();
            BaseParameter { text: form.words(&terms), value, terms }
        })
        .collect();
    let named: Vec<Vec<String>> = (0..form.len()).map(|j| form.parameters_of(j)).collect();
    let appears = |name: &String| named.iter().any(|list| list.contains(name));
    let alone = |name: &String| parameters.iter().any(|b| matches!(b.terms[..], [(j, _)] if named[j] == [name.clone()]));
    let names = layout.p.iter().map(|p| p.name.clone());
    let dead = names.clone().filter(|n| !appears(n) && !form.inside.contains(n)).collect();
    let combined = names.filter(|n| appears(n) && !alone(n)).collect();
    let (products, inside) = (form.len(), form.inside.clone());
    let (least_kept, most_dropped) = (found.least_kept, found.most_dropped);
    Some(Base { form, parameters, products, dead, combined, inside, states, least_kept, most_dropped })
}

fn layout_time(equations: &Equations) -> &str {
    &equations.graph.symbol_info(equations.layout.t).name
}

/// A base parameter: its own column, and the dependent ones in which it has a part.
fn terms_of(found: &Columns, place: usize, own: usize) -> Vec<(usize, f64)> {
    let shares = found.dependent.iter().filter_map(|(j, made_of)| Some((*j, made_of.iter().find(|t| t.0 == place)?.1)));
    std::iter::once((own, 1.0)).chain(shares).collect()
}

/// A random state: coordinates within their ranges (angles within a turn where none is given), all else of size one.
fn state(rig: &Rig, names: &[&str], draws: &mut Draws) -> Vec<f64> {
    names
        .iter()
        .map(|name| {
            let x = draws.unit();
            match rig.coordinates.iter().find(|c| c.name == *name) {
                Some(c) => match c.range {
                    Some((lo, hi)) => 0.5 * (lo + hi) + 0.5 * (hi - lo) * x,
                    None if c.unit.text == "m" => x,
                    None => std::f64::consts::PI * x,
                },
                None => 2.0 * x,
            }
        })
        .collect()
}

/// The textbook's base of links' parameters.
pub struct Links {
    /// Entries of links' masses, first moments and inertias (and affine parameters of forces) in the equations.
    pub entries: usize,
    /// Independent ones among them.
    pub rank: usize,
    /// Base parameters that are entries put together: text over links' entries.
    pub combined: Vec<String>,
    /// Entries that no equation has.
    pub dead: Vec<String>,
    /// Parameters in which the equations are not affine: taken as known.
    pub known: Vec<String>,
}

/// Base parameters of a rig's links in the full derivation; `None` for equations written directly.
#[must_use]
pub fn links(rig: &Rig, lumps: Lumps, seed: u64) -> Option<Links> {
    let r = regressor(rig, lumps)?;
    let free: Vec<usize> = (0..rig.coordinates.len()).filter(|&i| !rig.coordinates[i].prescribed).collect();
    let roots: Vec<_> = free.iter().flat_map(|&i| r.columns.iter().map(move |c| c.entries[i])).collect();
    let tape = r.graph.tape(&roots);
    let states = 2 * r.columns.len() / free.len().max(1) + 20;
    let mut draws = Draws::new(seed);
    let symbols: Vec<_> = [&r.q, &r.v, &r.a, &r.u, &r.z].into_iter().flatten().copied().collect();
    let names: Vec<&str> = symbols.iter().map(|&s| r.graph.symbol_info(s).name.as_str()).collect();
    let mut stacked = DMatrix::zeros(states * free.len(), r.columns.len());
    for s in 0..states {
        let values = state(rig, &names, &mut draws);
        let row = tape.run(|symbol| match symbols.iter().position(|&m| m == symbol) {
            Some(i) => values[i],
            None => parameter(rig, &r, symbol),
        });
        for (k, x) in row.into_iter().enumerate() {
            stacked[(s * free.len() + k / r.columns.len(), k % r.columns.len())] = x;
        }
    }
    let found = rank::columns(&stacked, TOLERANCE);
    let mut combined = Vec::new();
    for (k, &j) in found.kept.iter().enumerate() {
        let terms = terms_of(&found, k, j);
        if terms.len() > 1 {
            combined.push(words(&r, &terms));
        }
    }
    let dead = r.dead.iter().cloned().chain(found.dead.iter().map(|&j| r.columns[j].name.clone())).collect();
    let entries = r.columns.len() - found.dead.len();
    Some(Links { entries, rank: found.kept.len(), combined, dead, known: r.not_affine })
}

fn parameter(rig: &Rig, r: &Regressor, symbol: codegen::expr::SymbolId) -> f64 {
    let name = &r.graph.symbol_info(symbol).name;
    rig.parameters.iter().find(|p| p.name == *name).map_or(0.0, |p| p.value)
}

fn words(r: &Regressor, terms: &[(usize, f64)]) -> String {
    let mut text = String::new();
    for (i, &(j, k)) in terms.iter().enumerate() {
        let sign = match (i, k < 0.0) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        let size = k.abs();
        let factor = if (size - 1.0).abs() < 1e-12 { String::new() } else { format!("{} ", short(size)) };
        text.push_str(&format!("{sign}{factor}{}", r.columns[j].name));
    }
    text
}

/// Four digits.
fn short(x: f64) -> String {
    let digits = (3.0 - x.abs().log10().floor()).clamp(0.0, 12.0) as usize;
    let text = format!("{x:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
