//! The symbolic core: one hash-consed graph of scalar expressions.
//!
//! Knows numbers, symbols and arithmetic; knows nothing of rigs and mechanics. Equal expressions
//! are one node; children are older than their parents, so a loop over ids in ascending order is
//! an evaluation order. Rewrites at construction never make an expression costlier.

mod build;
mod diff;
mod eval;
mod graph;
mod reach;

pub use diff::{Derivative, Differentiable};
pub use eval::{Op, Tape};
pub use graph::{F1, F2, Graph, Id, Node, SymbolId, SymbolInfo, SymbolKind};
pub use reach::Reach;
