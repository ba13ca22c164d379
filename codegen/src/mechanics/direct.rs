//! Equations of motion written directly: M a = rhs, the right-hand side taken apart term by term.

use crate::expr::{Graph, Id, SymbolKind};
use crate::lower::Lowering;
use model_dsl::rig::Rig;

/// M, bias, dissipation and force read off the equations as they were written.
pub struct Direct {
    /// Coefficients of the accelerations.
    pub mass_matrix: Vec<Vec<Id>>,
    /// Terms without rates and inputs, on the left-hand side.
    pub bias: Vec<Id>,
    /// Terms with rates and without inputs, on the left-hand side.
    pub dissipation: Vec<Id>,
    /// Terms with inputs or actuators.
    pub force: Vec<Id>,
}

/// Splits each right-hand side by its additive terms. A prescribed coordinate's row is 1 * a.
pub fn take_apart(rig: &Rig, lowering: &Lowering, g: &mut Graph) -> Direct {
    let n = rig.coordinates.len();
    let zero = g.zero();
    let mut out = Direct { mass_matrix: vec![vec![zero; n]; n], bias: vec![zero; n], dissipation: vec![zero; n], force: vec![zero; n] };
    for i in 0..n {
        if rig.coordinates[i].prescribed {
            out.mass_matrix[i][i] = g.one();
        }
    }
    for equation in &rig.equations {
        let row = equation.coordinate;
        g.set_scope(rig.coordinates[row].name.clone());
        for (column, coefficient) in &equation.mass {
            let value = lowering.expr(g, coefficient);
            out.mass_matrix[row][*column] = g.add(out.mass_matrix[row][*column], value);
        }
        let rhs = lowering.expr(g, &equation.rhs);
        for (negative, term) in g.terms(rhs) {
            let symbols = g.symbols_of(&[term]);
            let has = |wanted: fn(SymbolKind) -> bool| symbols.iter().any(|&s| wanted(g.symbol_info(s).kind));
            let acts = has(|k| matches!(k, SymbolKind::Signal(_) | SymbolKind::Lag(_)));
            let moves = has(|k| matches!(k, SymbolKind::Rate(_)));
            let signed = if negative { g.neg(term) } else { term };
            if acts {
                out.force[row] = g.add(out.force[row], signed);
            } else if moves {
                out.dissipation[row] = g.sub(out.dissipation[row], signed);
            } else {
                out.bias[row] = g.sub(out.bias[row], signed);
            }
        }
    }
    out
}
