//! What the generated calls of `named` take and give.

use runtime::Singular;

/// Arguments of all functions.
#[derive(Clone, Debug)]
pub struct Arguments<'a> {
    /// Time.
    pub t: f64,
    /// State.
    pub x: &'a [f64],
    /// Coordinates.
    pub q: &'a [f64],
    /// Rates.
    pub v: &'a [f64],
    /// Actuator states.
    pub z: &'a [f64],
    /// Accelerations.
    pub a: &'a [f64],
    /// Signals.
    pub u: &'a [f64],
    /// Parameters.
    pub p: &'a [f64],
}

/// Name of a function, and its results one after the other, each row by row.
pub type Called = (&'static str, Result<Vec<Vec<f64>>, Singular>);

/// Numbers of any shape, row by row.
pub trait Flat {
    /// The entries.
    fn flat(&self) -> Vec<f64>;
}

impl Flat for f64 {
    fn flat(&self) -> Vec<f64> {
        vec![*self]
    }
}

impl<const N: usize> Flat for [f64; N] {
    fn flat(&self) -> Vec<f64> {
        self.to_vec()
    }
}

impl<const C: usize, const R: usize> Flat for [[f64; C]; R] {
    fn flat(&self) -> Vec<f64> {
        self.as_flattened().to_vec()
    }
}
