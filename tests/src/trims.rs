//! A trim as `codegen` reads it from a rig, as a problem for `control::solve`.

use codegen::{Layout, OperatingPoint};
use control::{TrimProblem, Unknown};

/// What is held, what moves and what vanishes, in the vectors of the model.
#[must_use]
pub fn problem(point: OperatingPoint, layout: &Layout) -> TrimProblem {
    let (x, u) = point.start(layout);
    let unknowns = point.solved.into_iter().map(|d| Unknown { name: d.name, states: d.states, signals: d.signals }).collect();
    TrimProblem { x, u, unknowns, zero: point.zero }
}
