//! Random states of a rig within its ranges, for comparisons of one evaluation with another.

use crate::calls::Arguments;
use crate::random::Random;
use codegen::Equations;
use codegen::expr::{SymbolId, SymbolKind};

/// Numbers for every vector of a model.
#[derive(Clone, Debug)]
pub struct Point {
    /// Time [s].
    pub t: f64,
    /// State [q | v | z].
    pub x: Vec<f64>,
    /// Accelerations.
    pub a: Vec<f64>,
    /// Signals.
    pub u: Vec<f64>,
    /// Parameters: the nominal ones, each changed by up to 10 %.
    pub p: Vec<f64>,
    coordinates: usize,
}

impl Point {
    /// A random point.
    #[must_use]
    pub fn random(e: &Equations, r: &mut Random) -> Self {
        let l = &e.layout;
        let u = (0..l.u.len())
            .map(|i| match e.input_paths.get(i).and_then(|path| path.0) {
                Some((lo, hi)) => r.within(lo, hi),
                None => r.within(-2.0, 2.0),
            })
            .collect();
        Self {
            t: r.within(0.0, 5.0),
            x: (0..l.states()).map(|_| r.within(-1.2, 1.2)).collect(),
            a: (0..l.q.len()).map(|_| r.within(-3.0, 3.0)).collect(),
            u,
            p: l.nominal.iter().map(|x| x * r.within(0.9, 1.1)).collect(),
            coordinates: l.q.len(),
        }
    }

    /// Its parts as arguments of the named functions.
    #[must_use]
    pub fn arguments(&self) -> Arguments<'_> {
        let n = self.coordinates;
        Arguments { t: self.t, x: &self.x, q: &self.x[..n], v: &self.x[n..2 * n], z: &self.x[2 * n..], a: &self.a, u: &self.u, p: &self.p }
    }

    /// The value of a symbol of the equations' graph.
    #[must_use]
    pub fn value(&self, e: &Equations, symbol: SymbolId) -> f64 {
        let n = self.coordinates;
        match e.graph.symbol_info(symbol).kind {
            SymbolKind::Time => self.t,
            SymbolKind::Coordinate(i) => self.x[i],
            SymbolKind::Rate(i) => self.x[n + i],
            SymbolKind::Lag(i) => self.x[2 * n + i],
            SymbolKind::Acceleration(i) => self.a[i],
            SymbolKind::Signal(i) => self.u[i],
            SymbolKind::Parameter(i) => self.p[i],
            SymbolKind::Definition(_) | SymbolKind::Inertial(_) => f64::NAN,
        }
    }
}
