//! Linear models at operating points: A, B, C, D, drift and poles.

use crate::schur::eigenvalues;
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
    Singular {
        /// Coordinate that moves no inertia.
        coordinate: String,
    },
    /// The directions of the inputs do not have one row for each signal of the model.
    Directions {
        /// Rows.
        found: usize,
        /// Signals.
        wanted: usize,
    },
    /// An entry is not finite.
    NotFinite,
}

impl fmt::Display for LinearizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Singular { coordinate } => write!(f, "the mass matrix is singular here: {coordinate} moves no inertia"),
            Self::Directions { found, wanted } => write!(f, "directions of inputs with {found} rows for {wanted} signals of the model"),
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
    if directions.nrows() != signals {
        return Err(LinearizeError::Directions { found: directions.nrows(), wanted: signals });
    }
    let (mut dx, mut a, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * signals]);
    slope(&mut dx, &mut a, &mut b).map_err(|s| LinearizeError::Singular { coordinate: model.names().state(s.coordinate).to_owned() })?;
    let a = DMatrix::from_row_slice(states, states, &a);
    let b = DMatrix::from_row_slice(states, signals, &b);
    let mut c = vec![0.0; d.outputs * states];
    let mut dhdp = vec![0.0; d.outputs * d.parameters];
    model.output_jacobian(0.0, x, p, &mut c, &mut dhdp);
    let c = DMatrix::from_row_slice(d.outputs, states, &c);
    if a.iter().chain(b.iter()).chain(c.iter()).chain(&dx).any(|v| !v.is_finite()) {
        return Err(LinearizeError::NotFinite);
    }
    let poles = eigenvalues(&a).map_err(|_| LinearizeError::NotFinite)?;
    Ok(LinearModel { drift: dx, poles, b: &b * directions, d: DMatrix::zeros(d.outputs, directions.ncols()), a, c })
}
