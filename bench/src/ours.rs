//! One of our rigs measured: derivation, compilation inside the process, time per call.

use crate::calls::{Quantity, calls};
use crate::{rigs, timing};
use codegen::Equations;
use jit::{Evaluation, InProcess};
use model_dsl::rig::Rig;

/// Figures of one rig.
pub struct Figures {
    /// Deriving with all Jacobians [ms].
    pub derive_ms: f64,
    /// Scalar operations of x', and of x' with A and B.
    pub operations: [usize; 2],
    /// Compiling x', and x' with A and B, in the process [ms].
    pub compile_ms: [f64; 2],
    /// Time per call of x', and of x' with A and B [ns].
    pub call_ns: [f64; 2],
    /// The same, interpreted [ns].
    pub interpreted_ns: [f64; 2],
}

/// Measures a rig.
///
/// # Errors
/// What the derivation says.
pub fn measure(rig: &Rig, runs: usize) -> Result<(Figures, Equations), String> {
    let (derive_ms, equations) = timing::fastest(runs, || rigs::equations(rig));
    let equations = equations?;
    let operations = [equations.forward_operations(), equations.jacobian_operations()];
    let (mut compile_ms, mut call_ns) = ([f64::INFINITY; 2], [0.0; 2]);
    for run in 0..runs {
        let model = InProcess::evaluated(rigs::equations(rig)?, Evaluation::Compiled);
        for (k, what) in [Quantity::Forward, Quantity::Linear].into_iter().enumerate() {
            // the first call compiles
            let (ms, ()) = calls(&model, what, |call| timing::fastest(1, || call(0.0)))?;
            compile_ms[k] = ms.min(compile_ms[k]);
            if run + 1 == runs {
                call_ns[k] = calls(&model, what, |call| timing::per_call(call))?;
            }
        }
    }
    let model = InProcess::evaluated(rigs::equations(rig)?, Evaluation::Interpreted);
    let interpreted_ns = crate::calls::both(&model);
    Ok((Figures { derive_ms, operations, compile_ms, call_ns, interpreted_ns }, equations))
}
