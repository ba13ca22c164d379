//! Trim: chosen accelerations vanish while chosen unknowns move; everything else is held.
//!
//! Newton's method with the model's exact Jacobian, steps by the pseudo-inverse (minimum norm, so that
//! directions that do nothing stay where they are) and halved until the residual falls. Actuator states
//! follow their commands: their rates are equations and they are unknowns, always.

use nalgebra::{DMatrix, DVector};
use runtime::{Model, Singular};
use std::fmt;

/// An unknown of a trim: a direction in [x | u].
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// Name for messages and for free directions.
    pub name: String,
    /// (state, weight): how states move with the unknown.
    pub states: Vec<(usize, f64)>,
    /// (signal, weight): how signals move with the unknown.
    pub signals: Vec<(usize, f64)>,
}

impl Unknown {
    /// A single state.
    #[must_use]
    pub fn state(name: &str, i: usize) -> Self {
        Self { name: name.to_owned(), states: vec![(i, 1.0)], signals: Vec::new() }
    }

    /// A single signal.
    #[must_use]
    pub fn signal(name: &str, i: usize) -> Self {
        Self { name: name.to_owned(), states: Vec::new(), signals: vec![(i, 1.0)] }
    }
}

/// What is held, what moves and what vanishes.
#[derive(Clone, Debug)]
pub struct TrimProblem {
    /// State at the start; entries that no unknown moves stay.
    pub x: Vec<f64>,
    /// Signals at the start.
    pub u: Vec<f64>,
    /// Unknowns.
    pub unknowns: Vec<Unknown>,
    /// Coordinates whose accelerations vanish.
    pub zero: Vec<usize>,
}

/// An operating point.
#[derive(Clone, Debug, PartialEq)]
pub struct Trim {
    /// State.
    pub x: Vec<f64>,
    /// Signals.
    pub u: Vec<f64>,
    /// Accelerations that remain, all coordinates.
    pub drift: Vec<f64>,
    /// Largest residual of the equations [SI].
    pub residual: f64,
    /// Rank of the equations in the unknowns.
    pub rank: usize,
    /// Number of unknowns, actuator states not counted.
    pub unknowns: usize,
    /// Unknowns whose change changes no equation: (name, weight) for each direction.
    pub free: Vec<Vec<(String, f64)>>,
    /// Newton steps.
    pub iterations: usize,
}

/// Why no operating point was found.
#[derive(Clone, Debug, PartialEq)]
pub enum TrimError {
    /// As many equations as unknowns are needed.
    NotSquare {
        /// Unknowns.
        unknowns: usize,
        /// Equations.
        equations: usize,
    },
    /// The mass matrix is singular on the way.
    Singular(Singular),
    /// The residual does not fall to rounding: no operating point near the start.
    NoConvergence {
        /// Largest residual that remains.
        residual: f64,
        /// Coordinate whose acceleration that is.
        coordinate: usize,
        /// Rank of the equations there.
        rank: usize,
        /// Newton steps.
        iterations: usize,
    },
    /// A value stopped being a number.
    NotFinite,
}

impl fmt::Display for TrimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotSquare { unknowns, equations } => write!(f, "{unknowns} unknowns for {equations} equations"),
            Self::Singular(s) => write!(f, "the mass matrix is singular in coordinate {}", s.coordinate),
            Self::NoConvergence { residual, coordinate, rank, iterations } => {
                write!(
                    f,
                    "no operating point: after {iterations} steps an acceleration of {residual:.3e} remains in coordinate {coordinate} (rank {rank})"
                )
            }
            Self::NotFinite => f.write_str("a value is not finite"),
        }
    }
}

impl std::error::Error for TrimError {}

const ITERATIONS: usize = 60;
/// Accelerations below this, relative to the largest force over inertia seen on the way, count as zero.
const TOLERANCE: f64 = 1e-11;

/// Finds the operating point.
///
/// # Errors
/// [`TrimError`], one variant a cause.
pub fn solve(model: &dyn Model, p: &[f64], problem: &TrimProblem) -> Result<Trim, TrimError> {
    let d = model.dimensions();
    let (n, states, signals) = (d.coordinates, d.states(), d.signals());
    if problem.unknowns.len() != problem.zero.len() {
        return Err(TrimError::NotSquare { unknowns: problem.unknowns.len(), equations: problem.zero.len() });
    }
    let mut unknowns = problem.unknowns.clone();
    unknowns.extend((0..d.lags).map(|k| Unknown::state("", 2 * n + k)));
    let rows: Vec<usize> = problem.zero.iter().map(|&i| n + i).chain((0..d.lags).map(|k| 2 * n + k)).collect();
    let count = unknowns.len();

    let (mut x, mut u) = (problem.x.clone(), problem.u.clone());
    let (mut dx, mut a, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * signals]);
    let move_by = |x: &[f64], u: &[f64], step: &DVector<f64>| {
        let (mut x, mut u) = (x.to_vec(), u.to_vec());
        for (unknown, s) in unknowns.iter().zip(step.iter()) {
            for &(i, w) in &unknown.states {
                x[i] += w * s;
            }
            for &(i, w) in &unknown.signals {
                u[i] += w * s;
            }
        }
        (x, u)
    };
    let size = |dx: &[f64]| rows.iter().fold(0.0_f64, |m, &r| if dx[r].is_nan() { f64::NAN } else { m.max(dx[r].abs()) });
    let mut scale = 1e-6_f64;
    let mut iterations = 0;
    let (jacobian, residual) = loop {
        model.linearize(0.0, &x, &u, p, &mut dx, &mut a, &mut b).map_err(TrimError::Singular)?;
        let residual = size(&dx);
        if !residual.is_finite() {
            return Err(TrimError::NotFinite);
        }
        scale = scale.max(residual);
        let jacobian = DMatrix::from_fn(rows.len(), count, |i, j| {
            let row = rows[i];
            let by_states: f64 = unknowns[j].states.iter().map(|&(k, w)| w * a[row * states + k]).sum();
            let by_signals: f64 = unknowns[j].signals.iter().map(|&(k, w)| w * b[row * signals + k]).sum();
            by_states + by_signals
        });
        if count == 0 || residual <= 4.0 * f64::EPSILON * scale || iterations == ITERATIONS {
            break (jacobian, residual);
        }
        let f = DVector::from_iterator(rows.len(), rows.iter().map(|&r| -dx[r]));
        let svd = jacobian.clone().svd(true, true);
        let largest = svd.singular_values.max();
        let Ok(step) = svd.solve(&f, 1e-10 * largest.max(f64::MIN_POSITIVE)) else { break (jacobian, residual) };
        let mut factor = 1.0;
        let mut accepted = false;
        while factor > 1e-6 {
            let (next_x, next_u) = move_by(&x, &u, &(&step * factor));
            let tried = model.rhs(0.0, &next_x, &next_u, p, &mut dx).is_ok();
            let next = size(&dx);
            if tried && next.is_finite() && next < residual {
                (x, u) = (next_x, next_u);
                accepted = true;
                break;
            }
            factor *= 0.5;
        }
        iterations += 1;
        if !accepted {
            break (jacobian, residual);
        }
    };
    let svd = jacobian.clone().svd(true, true);
    let largest = svd.singular_values.iter().copied().fold(0.0_f64, f64::max);
    let threshold = 1e-9 * largest;
    let full_rank = svd.singular_values.iter().filter(|&&s| s > threshold && s > 0.0).count();
    let rank = full_rank.saturating_sub(d.lags);
    model.rhs(0.0, &x, &u, p, &mut dx).map_err(TrimError::Singular)?;
    if residual > TOLERANCE * scale {
        let worst = problem.zero.iter().copied().max_by(|&i, &j| dx[n + i].abs().total_cmp(&dx[n + j].abs())).unwrap_or(0);
        return Err(TrimError::NoConvergence { residual, coordinate: worst, rank, iterations });
    }
    Ok(Trim {
        free: free_directions(&jacobian, &unknowns, threshold),
        drift: dx[n..2 * n].to_vec(),
        x,
        u,
        residual,
        rank,
        unknowns: problem.unknowns.len(),
        iterations,
    })
}

/// Null space of the equations, named; weights below 1e-6 left out.
fn free_directions(jacobian: &DMatrix<f64>, unknowns: &[Unknown], threshold: f64) -> Vec<Vec<(String, f64)>> {
    if jacobian.ncols() == 0 {
        return Vec::new();
    }
    let gram = jacobian.transpose() * jacobian;
    let eigen = gram.symmetric_eigen();
    let mut free = Vec::new();
    for (k, &value) in eigen.eigenvalues.iter().enumerate() {
        if value.max(0.0).sqrt() <= threshold.max(f64::MIN_POSITIVE) {
            let column = eigen.eigenvectors.column(k);
            let direction: Vec<(String, f64)> = unknowns
                .iter()
                .zip(column.iter())
                .filter(|(u, w)| !u.name.is_empty() && w.abs() > 1e-6)
                .map(|(u, w)| (u.name.clone(), *w))
                .collect();
            if !direction.is_empty() {
                free.push(direction);
            }
        }
    }
    free
}
