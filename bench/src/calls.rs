//! Calls of any model at the point at which everything is measured.

use crate::timing;
use runtime::Model;
use std::hint::black_box;

/// Arguments at which everything is measured.
pub struct Point {
    /// State.
    pub x: Vec<f64>,
    /// Signals.
    pub u: Vec<f64>,
    /// Parameters: nominal.
    pub p: Vec<f64>,
}

impl Point {
    /// The point of a model; `casadi_peer.py` uses the same.
    #[must_use]
    pub fn of(model: &dyn Model) -> Self {
        let d = model.dimensions();
        let mut p = vec![0.0; d.parameters];
        model.nominal(&mut p);
        Self { x: (0..d.states()).map(|i| 0.1 * (i + 1) as f64).collect(), u: (0..d.signals()).map(|i| 1.5 - 0.1 * i as f64).collect(), p }
    }
}

/// What is asked of a model.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// x'.
    Forward,
    /// x' with A and B.
    Linear,
}

/// Calls a model again and again: `next` is given the call, to which it passes a small change of the first state.
///
/// # Errors
/// Where the mass matrix is singular at the point.
pub fn calls<R>(model: &dyn Model, what: Quantity, next: impl FnOnce(&mut dyn FnMut(f64)) -> R) -> Result<R, String> {
    let Point { mut x, u, p } = Point::of(model);
    let d = model.dimensions();
    let n = d.states();
    let (mut dx, mut a, mut b) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * d.signals()]);
    let start = x[0];
    let mut singular = false;
    let result = next(&mut |change| {
        x[0] = start + change;
        let (x, u, p) = black_box((&x, &u, &p));
        let result = match what {
            Quantity::Forward => model.rhs(0.0, x, u, p, &mut dx),
            Quantity::Linear => model.linearize(0.0, x, u, p, &mut dx, &mut a, &mut b),
        };
        singular |= result.is_err();
        black_box((&dx, &a, &b));
    });
    if singular { Err("the mass matrix is singular at the point of measurement".to_owned()) } else { Ok(result) }
}

/// Time per call of x', and of x' with A and B [ns]; not a number where the mass matrix is singular.
pub fn both(model: &dyn Model) -> [f64; 2] {
    [Quantity::Forward, Quantity::Linear].map(|what| calls(model, what, |call| timing::per_call(call)).unwrap_or(f64::NAN))
}
