//! Named trims of a rig in the vectors of its model: what is held at which value, what moves, what vanishes.
//!
//! Knows the rig's declarations and the order of the model's vectors; solves nothing (that is `control`'s).

use crate::equations::Layout;
use crate::expr::Graph;
use crate::lower::{Lowering, Lumps};
use model_dsl::rig::{Mix, Rig, Symbol};

/// A direction in [x | u]: how states and signals move with one quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Direction {
    /// Name in the rig: `f_1`, `psi.dot`, `f_s`.
    pub name: String,
    /// (state, weight).
    pub states: Vec<(usize, f64)>,
    /// (signal, weight).
    pub signals: Vec<(usize, f64)>,
}

/// A trim as declared, in the vectors of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct OperatingPoint {
    /// Name of the trim.
    pub name: String,
    /// Quantities held, with their values (SI).
    pub held: Vec<(Direction, f64)>,
    /// Quantities that are solved for.
    pub solved: Vec<Direction>,
    /// Coordinates whose accelerations vanish.
    pub zero: Vec<usize>,
}

impl OperatingPoint {
    /// State and signals with everything held at its value and all else zero.
    #[must_use]
    pub fn start(&self, layout: &Layout) -> (Vec<f64>, Vec<f64>) {
        let (mut x, mut u) = (vec![0.0; layout.states()], vec![0.0; layout.u.len()]);
        for (direction, value) in &self.held {
            direction.add(*value, &mut x, &mut u);
        }
        (x, u)
    }
}

impl Direction {
    /// Moves a point along the direction.
    pub fn add(&self, amount: f64, x: &mut [f64], u: &mut [f64]) {
        for &(i, weight) in &self.states {
            x[i] += weight * amount;
        }
        for &(i, weight) in &self.signals {
            u[i] += weight * amount;
        }
    }

    /// Whether both move the same quantity.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        self.states.iter().any(|(i, _)| other.states.iter().any(|(j, _)| i == j))
            || self.signals.iter().any(|(i, _)| other.signals.iter().any(|(j, _)| i == j))
    }
}

/// The rig's trims, with parameters at their present values.
#[must_use]
pub fn operating_points(rig: &Rig, layout: &Layout, lumps: Lumps) -> Vec<OperatingPoint> {
    let mut graph = Graph::new();
    let lowering = Lowering::new(rig, lumps, true, &mut graph);
    let values = &layout.nominal;
    let parameter = |s| lowering.p.iter().position(|&p| p == s).map_or(0.0, |i| values[i]);
    rig.trims
        .iter()
        .map(|trim| {
            let held = trim
                .fixed
                .iter()
                .filter_map(|(symbol, value)| {
                    let id = lowering.expr(&mut graph, value);
                    Some((direction(rig, layout, *symbol)?, graph.evaluate(&[id], parameter)[0]))
                })
                .collect();
            let solved = trim.solve.iter().filter_map(|&symbol| direction(rig, layout, symbol)).collect();
            OperatingPoint { name: trim.name.clone(), held, solved, zero: trim.zero.clone() }
        })
        .collect()
}

/// The direction of a coordinate, rate, actuator state, signal or mixed input by its name.
#[must_use]
pub fn direction_by_name(rig: &Rig, layout: &Layout, name: &str) -> Option<Direction> {
    if let Some(i) = layout.x().position(|v| v.name == name) {
        return Some(Direction { name: name.to_owned(), states: vec![(i, 1.0)], signals: Vec::new() });
    }
    if let Some(i) = layout.u.iter().position(|v| v.name == name) {
        return Some(Direction { name: name.to_owned(), states: Vec::new(), signals: vec![(i, 1.0)] });
    }
    rig.mixes.iter().find_map(|mix| mix.names.iter().position(|n| n == name).and_then(|row| mixed(mix, row)))
}

fn direction(rig: &Rig, layout: &Layout, symbol: Symbol) -> Option<Direction> {
    match symbol {
        Symbol::Coordinate(i) => direction_by_name(rig, layout, &rig.coordinates[i].name),
        Symbol::Rate(i) => direction_by_name(rig, layout, &format!("{}.dot", rig.coordinates[i].name)),
        Symbol::Input(i) => direction_by_name(rig, layout, &rig.inputs[i].name),
        Symbol::Mixed(m, row) => mixed(&rig.mixes[m], row),
        Symbol::Time | Symbol::Parameter(_) | Symbol::Definition(_) | Symbol::Acceleration(_) | Symbol::Actuator(_) => None,
    }
}

/// Inputs that move mixed input `row` alone: a column of the inverse of the mix.
fn mixed(mix: &Mix, row: usize) -> Option<Direction> {
    let n = mix.rows.len();
    let mut m: Vec<Vec<f64>> =
        mix.rows.iter().enumerate().map(|(i, r)| r.iter().copied().chain([f64::from(u8::from(i == row))]).collect()).collect();
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| m[a][i].abs().total_cmp(&m[b][i].abs()))?;
        m.swap(i, pivot);
        let lead = m[i].clone();
        for (k, other) in m.iter_mut().enumerate() {
            if k != i {
                let factor = other[i] / lead[i];
                other.iter_mut().zip(&lead).for_each(|(x, l)| *x -= factor * l);
            }
        }
    }
    let signals = mix.inputs.iter().enumerate().map(|(i, &input)| (input, m[i][n] / m[i][i])).filter(|(_, w)| *w != 0.0).collect();
    Some(Direction { name: mix.names[row].clone(), states: Vec::new(), signals })
}
