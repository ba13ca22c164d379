//! Values of a checked rig's expressions at a pose: what drawings and checks of single bodies need.
//!
//! Evaluates; derives nothing. Rates, signals and time are zero.

use crate::expr::{Graph, SymbolId};
use crate::lower::{Lowering, Lumps};
use model_dsl::rig::{Expr, Rig};
use rustc_hash::FxHashMap;

/// Evaluates expressions of one rig, parameters at their present values.
pub struct Numbers {
    graph: Graph,
    lowering: Lowering,
    parameters: FxHashMap<SymbolId, f64>,
}

impl Numbers {
    /// Of a rig; `set` assumptions are in force.
    #[must_use]
    pub fn new(rig: &Rig, lumps: Lumps) -> Self {
        let mut graph = Graph::new();
        let lowering = Lowering::new(rig, lumps, true, &mut graph);
        let parameters = lowering.p.iter().copied().zip(rig.parameters.iter().map(|p| p.value)).collect();
        Self { graph, lowering, parameters }
    }

    /// Value of an expression at coordinates `q` [rad, m]; coordinates that are not given are zero.
    #[must_use]
    pub fn value(&mut self, expr: &Expr, q: &[f64]) -> f64 {
        let id = self.lowering.expr(&mut self.graph, expr);
        let coordinate = |s| self.lowering.q.iter().position(|&c| c == s).and_then(|i| q.get(i)).copied();
        self.graph.evaluate(&[id], |s| self.parameters.get(&s).copied().or_else(|| coordinate(s)).unwrap_or(0.0))[0]
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
