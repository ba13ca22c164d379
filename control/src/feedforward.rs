//! Feedforward from the trim manifold: the inputs that hold references where they are.
//!
//! Inputs u* of given references by the trim solver, warm-started from the last answer; no closed form is needed, so
//! that it works for any rig. For eq. 16 of the seed paper at rest it is f_s* = (a1 cos(theta) sin(eps) +
//! a2 cos(eps))/(b1 cos(theta)), f_d* = a3 cos(eps) sin(theta)/b2.

use crate::trim::{Trim, TrimError, TrimProblem, solve};
use runtime::Model;

/// The trim manifold over references.
pub struct Feedforward<'a> {
    model: &'a dyn Model,
    p: &'a [f64],
    problem: TrimProblem,
    held: Vec<usize>,
}

impl<'a> Feedforward<'a> {
    /// Inputs that solve `problem` with the states `held` at their references (indices into x).
    ///
    /// # Errors
    /// [`TrimError`] where the problem has no solution at its own start, or an index is out of range.
    pub fn new(model: &'a dyn Model, p: &'a [f64], problem: TrimProblem, held: Vec<usize>) -> Result<Self, TrimError> {
        if held.iter().any(|&i| i >= problem.x.len()) {
            return Err(TrimError::Shape);
        }
        let mut start = Self { model, p, problem, held };
        let trim = solve(start.model, start.p, &start.problem)?;
        (start.problem.x, start.problem.u) = (trim.x, trim.u);
        Ok(start)
    }

    /// The operating point with the held states at `references` (one for each, SI).
    ///
    /// # Errors
    /// [`TrimError`], where no inputs hold these references.
    pub fn at(&mut self, references: &[f64]) -> Result<Trim, TrimError> {
        if references.len() != self.held.len() {
            return Err(TrimError::Shape);
        }
        for (&i, &value) in self.held.iter().zip(references) {
            self.problem.x[i] = value;
        }
        let trim = solve(self.model, self.p, &self.problem)?;
        (self.problem.x, self.problem.u) = (trim.x.clone(), trim.u.clone());
        Ok(trim)
    }
}
