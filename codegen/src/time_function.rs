//! A function of time with its exact derivatives: references and prescribed motions of a closed loop.

use crate::expr::{Derivative, Graph, SymbolId, Tape};
use crate::lower::{Lowering, Lumps};
use model_dsl::rig::{Expr, Rig};

/// Value, rate and acceleration over time.
#[derive(Clone, Debug)]
pub struct TimeFunction {
    tape: Tape,
    time: SymbolId,
}

impl TimeFunction {
    /// From a checked expression over time.
    #[must_use]
    pub fn new(rig: &Rig, expr: &Expr) -> Self {
        let mut graph = Graph::new();
        let lowering = Lowering::new(rig, Lumps::AsParameters, false, &mut graph);
        let value = lowering.expr(&mut graph, expr);
        let rate = graph.differentiate(&[value], lowering.t, Derivative::Exact)[0];
        let acceleration = graph.differentiate(&[rate], lowering.t, Derivative::Exact)[0];
        Self { tape: graph.tape(&[value, rate, acceleration]), time: lowering.t }
    }

    /// Value, rate and acceleration at time t [s]; what stands for anything but time is not a number.
    #[must_use]
    pub fn at(&self, t: f64) -> [f64; 3] {
        let all = self.tape.run(|s| if s == self.time { t } else { f64::NAN });
        [all[0], all[1], all[2]]
    }
}
