//! Linear models at operating points: A, B, C, D, drift and poles.

use nalgebra::{Complex, DMatrix};
use runtime::{Model, Singular};
use std::fmt;

/// x' = drift + A (x - x*) + B (u - u*), y = C (x - x*) + D (u - u*).
#[derive(Clone, Debug)]
pub struct LinearModel {
    /// x' at the point: rates and what accelerations remain.
    pub drift: Vec<f64>,
    /// states x states.
    pub a: DMatrix<f64>,
    /// states x inputs.
    pub b: DMatrix<f64>,
    /// outputs x states.
    pub c: DMatrix<f64>,
    /// outputs x inputs: zero, since outputs do not see inputs.
    pub d: DMatrix<f64>,
    /// Eigenvalues of A, by real part, then by imaginary part.
    pub poles: Vec<Complex<f64>>,
}

/// Why there is no linear model.
#[derive(Clone, Debug, PartialEq)]
pub enum LinearizeError {
    /// The mass matrix is singular here.
    Singular(Singular),
    /// An entry is not finite.
    NotFinite,
}

impl fmt::Display for LinearizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Singular(s) => write!(f, "the mass matrix is singular in coordinate {}", s.coordinate),
            Self::NotFinite => f.write_str("an entry of the linear model is not finite"),
        }
    }
}

impl std::error::Error for LinearizeError {}

/// Linear model at a point. `slope` computes x', A, B over all signals; `directions` (signals x inputs) says how the
/// signals move with each input of the linear model: the identity for the rig's own inputs, the columns of the
/// inverse for mixed ones (so that the other mixed inputs are held).
///
/// # Errors
/// [`LinearizeError`], one variant a cause.
pub fn linearize(
    model: &dyn Model,
    p: &[f64],
    x: &[f64],
    directions: &DMatrix<f64>,
    slope: impl FnOnce(&mut [f64], &mut [f64], &mut [f64]) -> Result<(), Singular>,
) -> Result<LinearModel, LinearizeError> {
    let d = model.dimensions();
    let (states, signals) = (d.states(), d.signals());
    let (mut dx, mut a, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * signals]);
    slope(&mut dx, &mut a, &mut b).map_err(LinearizeError::Singular)?;
    let a = DMatrix::from_row_slice(states, states, &a);
    let b = DMatrix::from_row_slice(states, signals, &b);
    let mut c = vec![0.0; d.outputs * states];
    let mut dhdp = vec![0.0; d.outputs * d.parameters];
    model.output_jacobian(0.0, x, p, &mut c, &mut dhdp);
    let c = DMatrix::from_row_slice(d.outputs, states, &c);
    if a.iter().chain(b.iter()).chain(c.iter()).chain(&dx).any(|v| !v.is_finite()) {
        return Err(LinearizeError::NotFinite);
    }
    Ok(LinearModel { drift: dx, poles: poles(&a), b: &b * directions, d: DMatrix::zeros(d.outputs, directions.ncols()), a, c })
}

/// Eigenvalues, by real part, then by imaginary part.
#[must_use]
pub fn poles(a: &DMatrix<f64>) -> Vec<Complex<f64>> {
    let mut poles: Vec<Complex<f64>> = a.complex_eigenvalues().iter().copied().collect();
    // rounding must not decide the order of a pair
    let key = |x: f64| (x * 1e9).round();
    poles.sort_by(|p, q| key(p.re).total_cmp(&key(q.re)).then(key(p.im).total_cmp(&key(q.im))));
    poles
}
