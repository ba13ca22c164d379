//! Values of a checked rig's expressions at a pose: what drawings and checks of single bodies need.
//!
//! Evaluates; derives nothing. Rates and time are zero, signals and actuator states all have one chosen value.

use crate::expr::{Graph, SymbolId, SymbolKind};
use crate::lower::{Lowering, Lumps};
use model_dsl::rig::{Expr, Rig};
use rustc_hash::FxHashMap;

/// Evaluates expressions of one rig, parameters at their present values.
pub struct Numbers {
    graph: Graph,
    lowering: Lowering,
    parameters: FxHashMap<SymbolId, f64>,
    /// Value of every signal and actuator state: 0, or 1 where the direction of a force is asked for.
    pub signals: f64,
}

impl Numbers {
    /// Of a rig; `set` assumptions are in force.
    #[must_use]
    pub fn new(rig: &Rig, lumps: Lumps) -> Self {
        let mut graph = Graph::new();
        let lowering = Lowering::new(rig, lumps, true, &mut graph);
        let parameters = lowering.p.iter().copied().zip(rig.parameters.iter().map(|p| p.value)).collect();
        Self { graph, lowering, parameters, signals: 0.0 }
    }

    /// Slope of an expression along a coordinate at `q`; expressions of frames are affine, so it is the same everywhere.
    #[must_use]
    pub fn slope(&mut self, expr: &Expr, coordinate: usize, q: &[f64]) -> f64 {
        let mut moved = q.to_vec();
        if let Some(x) = moved.get_mut(coordinate) {
            *x += 1.0;
        }
        self.value(expr, &moved) - self.value(expr, q)
    }

    /// Value of an expression at coordinates `q` [rad, m]; coordinates that are not given are zero.
    #[must_use]
    pub fn value(&mut self, expr: &Expr, q: &[f64]) -> f64 {
        let id = self.lowering.expr(&mut self.graph, expr);
        self.graph.evaluate(&[id], |s| match self.graph.symbol_info(s).kind {
            SymbolKind::Parameter(_) => self.parameters.get(&s).copied().unwrap_or(0.0),
            SymbolKind::Coordinate(i) => q.get(i).copied().unwrap_or(0.0),
            SymbolKind::Signal(_) | SymbolKind::Lag(_) => self.signals,
            _ => 0.0,
        })[0]
    }
}

/// The definitions of a rig's lumps over its parameters.
pub struct Definitions {
    /// Where the values live.
    pub graph: Graph,
    /// Symbols of the parameters, in the rig's order.
    pub parameters: Vec<SymbolId>,
    /// What each definition stands for, in the rig's order, every lump written out.
    pub values: Vec<crate::expr::Id>,
}

/// The definitions of a rig, lumps with values of their own written out too.
#[must_use]
pub fn definitions(rig: &Rig) -> Definitions {
    let mut graph = Graph::new();
    let lowering = Lowering::new(rig, Lumps::Expanded, false, &mut graph);
    let values = rig.definitions.iter().map(|d| lowering.expr(&mut graph, &d.value)).collect();
    Definitions { parameters: lowering.p, values, graph }
}
