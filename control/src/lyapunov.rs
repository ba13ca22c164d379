//! Lyapunov and Stein equations by the complex Schur form (Bartels and Stewart 1972; Kitagawa 1977).
//!
//! Knows matrices only.

use crate::schur::{NoConvergence, Schur};
use nalgebra::{Complex, DMatrix, DVector};
use std::fmt;

type C = Complex<f64>;

/// Why there is no solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LyapunovError {
    /// Two eigenvalues cancel (sum zero, or product one in discrete time): no unique solution.
    Resonant(Complex<f64>, Complex<f64>),
    /// An entry is not finite.
    NoConvergence(NoConvergence),
}

impl fmt::Display for LyapunovError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Resonant(a, b) => {
                write!(f, "no unique solution: the eigenvalues {} and {} cancel", crate::modes::show(*a), crate::modes::show(*b))
            }
            Self::NoConvergence(e) => e.fmt(f),
        }
    }
}

impl std::error::Error for LyapunovError {}

/// X of A X + X A^T + Q = 0 (all n x n, Q symmetric).
///
/// # Errors
/// [`LyapunovError`], one variant a cause.
pub fn lyapunov(a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<DMatrix<f64>, LyapunovError> {
    let schur = Schur::new(a).map_err(LyapunovError::NoConvergence)?;
    by_columns(&schur, q, |t, j, known| {
        let factor = t[(j, j)].conj();
        (known.rhs - &known.sum, C::new(1.0, 0.0), factor)
    })
}

/// X of A X A^T - X + Q = 0 (all n x n, Q symmetric).
///
/// # Errors
/// [`LyapunovError`], one variant a cause.
pub fn stein(a: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<DMatrix<f64>, LyapunovError> {
    let schur = Schur::new(a).map_err(LyapunovError::NoConvergence)?;
    by_columns(&schur, q, |t, j, known| {
        let factor = t[(j, j)].conj();
        (known.rhs - t * &known.sum, factor, C::new(-1.0, 0.0))
    })
}

/// What is known when column j is solved for: -c_j, and the sum over k > j of y_k conj(t_jk).
struct Known {
    rhs: DVector<C>,
    sum: DVector<C>,
}

/// Solves (alpha T + beta I) y_j = r for each column, from the last to the first; `column` gives (r, alpha, beta).
fn by_columns(
    schur: &Schur,
    q: &DMatrix<f64>,
    column: impl Fn(&DMatrix<C>, usize, Known) -> (DVector<C>, C, C),
) -> Result<DMatrix<f64>, LyapunovError> {
    let (u, t, n) = (&schur.u, &schur.t, q.nrows());
    let c = u.adjoint() * q.map(|x| C::new(x, 0.0)) * u;
    let mut y = DMatrix::<C>::zeros(n, n);
    for j in (0..n).rev() {
        let mut sum = DVector::<C>::zeros(n);
        for k in j + 1..n {
            sum.axpy(t[(j, k)].conj(), &y.column(k), C::new(1.0, 0.0));
        }
        let (mut r, alpha, beta) = column(t, j, Known { rhs: -c.column(j), sum });
        for i in (0..n).rev() {
            let pivot = alpha * t[(i, i)] + beta;
            if pivot.norm() <= f64::EPSILON * (alpha.norm() * t[(i, i)].norm()).max(beta.norm()) {
                return Err(LyapunovError::Resonant(t[(i, i)], t[(j, j)].conj()));
            }
            let value = r[i] / pivot;
            y[(i, j)] = value;
            for k in 0..i {
                r[k] -= alpha * t[(k, i)] * value;
            }
        }
    }
    let x = (u * y * u.adjoint()).map(|z| z.re);
    Ok((&x + x.transpose()) * 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    #[test]
    fn both_equations_hold_for_random_matrices() {
        let mut r = Random::new(7);
        for n in [1, 2, 4, 9, 20] {
            let a = DMatrix::from_fn(n, n, |_, _| r.within(-1.0, 1.0));
            let h = DMatrix::from_fn(n, n, |_, _| r.within(-1.0, 1.0));
            let q = &h * h.transpose();
            let shifted = &a - DMatrix::identity(n, n) * (1.0 + a.norm());
            let x = lyapunov(&shifted, &q).unwrap();
            assert!((&shifted * &x + &x * shifted.transpose() + &q).norm() < 1e-12 * q.norm().max(1.0));
            let small = &a * (0.9 / a.norm());
            let x = stein(&small, &q).unwrap();
            assert!((&small * &x * small.transpose() - &x + &q).norm() < 1e-12 * q.norm().max(1.0));
        }
    }

    #[test]
    fn eigenvalues_that_cancel_are_named() {
        let a = DMatrix::from_diagonal(&DVector::from_vec(vec![2.0, -2.0]));
        let error = lyapunov(&a, &DMatrix::identity(2, 2)).unwrap_err();
        assert_eq!(error.to_string(), "no unique solution: the eigenvalues 2 and -2 cancel");
    }
}
