//! The trim manifold in closed form: the inputs that hold chosen states, where inputs enter the accelerations linearly.
//!
//! a(q, u) = a_0(q) + G(q) u for the accelerations that vanish, so that u* = -G^-1 a_0, by elimination on the graph with
//! the pivots of the operating point.

use crate::equations::Equations;
use crate::expr::{Graph, Id, SymbolId, SymbolKind};
use crate::operating::Direction;
use std::fmt;

/// u* as expressions over the held states and the parameters.
#[derive(Clone, Debug)]
pub struct Manifold {
    /// The graph of the expressions.
    pub graph: Graph,
    /// Symbols of the held states, in the order asked for.
    pub held: Vec<SymbolId>,
    /// Parameters, with their values.
    pub parameters: Vec<(SymbolId, f64)>,
    /// One expression for each signal of the model.
    pub inputs: Vec<Id>,
}

/// Why there is no closed form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoManifold {
    /// The trim solves for a state.
    State {
        /// Its name.
        name: String,
    },
    /// The inputs do not enter linearly.
    Nonlinear,
    /// Actuators with states of their own lie between.
    Lags,
    /// The equations do not determine the inputs at the operating point.
    Singular,
}

impl fmt::Display for NoManifold {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::State { name } => write!(f, "the trim solves for `{name}`, which is no input"),
            Self::Nonlinear => f.write_str("the inputs do not enter the accelerations linearly"),
            Self::Lags => f.write_str("an actuator has a state of its own"),
            Self::Singular => f.write_str("the inputs are not determined at the operating point"),
        }
    }
}

impl std::error::Error for NoManifold {}

/// The inputs along `solved` that make the accelerations `zero` vanish where the states `held` are given; everything else
/// is as in (x, u).
///
/// # Errors
/// [`NoManifold`], one variant a cause.
pub fn manifold(e: &Equations, solved: &[Direction], zero: &[usize], held: &[usize], x: &[f64], u: &[f64]) -> Result<Manifold, NoManifold> {
    let l = &e.layout;
    if let Some(direction) = solved.iter().find(|d| !d.states.is_empty()) {
        return Err(NoManifold::State { name: direction.name.clone() });
    }
    if !l.z.is_empty() {
        return Err(NoManifold::Lags);
    }
    if solved.len() != zero.len() || held.iter().any(|&i| i >= l.states()) {
        return Err(NoManifold::Singular);
    }
    let mut g = e.graph.clone();
    let rows: Vec<Id> = zero.iter().map(|&i| e.acceleration[i]).collect();
    let states: Vec<SymbolId> = l.x().map(|v| v.symbol).collect();
    let signals: Vec<SymbolId> = l.u.iter().map(|v| v.symbol).collect();
    let gains: Vec<Vec<Id>> = solved
        .iter()
        .map(|d| {
            let seeds: Vec<(SymbolId, Id)> = d.signals.iter().map(|&(i, w)| (signals[i], g.num(w))).collect();
            g.directional(&rows, &seeds)
        })
        .collect();
    // what is not held keeps its value; what is solved for starts from nothing
    let mut rest = u.to_vec();
    for d in solved {
        d.signals.iter().for_each(|&(i, _)| rest[i] = 0.0);
    }
    let moved: Vec<usize> = solved.iter().flat_map(|d| d.signals.iter().map(|s| s.0)).collect();
    let time = g.num(0.0);
    let values: Vec<(SymbolId, Id)> = states
        .iter()
        .enumerate()
        .filter(|(i, _)| !held.contains(i))
        .map(|(i, s)| (*s, x[i]))
        .chain(signals.iter().enumerate().filter(|(i, _)| !moved.contains(i)).map(|(i, s)| (*s, rest[i])))
        .map(|(s, value)| (s, g.num(value)))
        .chain([(l.t, time)])
        .collect();
    let known = |s: SymbolId| values.iter().find(|(k, _)| *k == s).map(|(_, id)| *id);
    let n = rows.len();
    let flat: Vec<Id> = gains.concat();
    let gains = g.substitute(&flat, known);
    let is_signal = |g: &Graph, s: SymbolId| matches!(g.symbol_info(s).kind, SymbolKind::Signal(_));
    if g.symbols_of(&gains).into_iter().any(|s| is_signal(&g, s)) {
        return Err(NoManifold::Nonlinear);
    }
    let zeros: Vec<(SymbolId, Id)> = moved.iter().map(|&i| (signals[i], time)).collect();
    let bias = g.substitute(&rows, |s| known(s).or_else(|| zeros.iter().find(|(k, _)| *k == s).map(|(_, id)| *id)));

    // [G | -a_0], eliminated with the pivots of the operating point
    let mut matrix: Vec<Vec<Id>> = (0..n)
        .map(|i| {
            let mut row: Vec<Id> = (0..n).map(|k| gains[k * n + i]).collect();
            row.push(g.neg(bias[i]));
            row
        })
        .collect();
    let parameter = |s: SymbolId| l.p.iter().position(|p| p.symbol == s).map(|i| l.nominal[i]);
    let at_point = |g: &Graph, id: Id| {
        g.evaluate(&[id], |s| parameter(s).or_else(|| states.iter().position(|k| *k == s).map(|i| x[i])).unwrap_or(f64::NAN))[0].abs()
    };
    let size = matrix.iter().flat_map(|row| &row[..n]).map(|&id| at_point(&g, id)).fold(0.0_f64, f64::max);
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| at_point(&g, matrix[i][k]).total_cmp(&at_point(&g, matrix[j][k]))).unwrap_or(k);
        let lead = at_point(&g, matrix[pivot][k]);
        if lead.is_nan() || lead <= 1e-10 * size {
            return Err(NoManifold::Singular);
        }
        matrix.swap(k, pivot);
        for i in k + 1..n {
            if g.is_zero(matrix[i][k]) {
                continue;
            }
            let factor = g.div(matrix[i][k], matrix[k][k]);
            let lead = matrix[k].clone();
            for (entry, above) in matrix[i].iter_mut().zip(&lead).skip(k) {
                let part = g.mul(factor, *above);
                *entry = g.sub(*entry, part);
            }
        }
    }
    let mut amounts = vec![time; n];
    for k in (0..n).rev() {
        let mut sum = matrix[k][n];
        for j in k + 1..n {
            let part = g.mul(matrix[k][j], amounts[j]);
            sum = g.sub(sum, part);
        }
        amounts[k] = g.div(sum, matrix[k][k]);
    }
    let inputs = (0..l.u.len())
        .map(|i| {
            let mut terms: Vec<Id> = Vec::new();
            for (d, amount) in solved.iter().zip(&amounts) {
                for &(_, w) in d.signals.iter().filter(|s| s.0 == i) {
                    let weight = g.num(w);
                    terms.push(g.mul(weight, *amount));
                }
            }
            if terms.is_empty() { g.num(rest[i]) } else { g.sum(&terms) }
        })
        .collect();
    let parameters = l.p.iter().map(|p| p.symbol).zip(l.nominal.iter().copied()).collect();
    Ok(Manifold { held: held.iter().map(|&i| states[i]).collect(), graph: g, parameters, inputs })
}
