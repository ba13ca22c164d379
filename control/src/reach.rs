//! What inputs can reach and outputs can see: staircase form, the test of Popov, Belevitch and Hautus, Gramians.
//!
//! Rank is decided by the staircase form of orthogonal transformations (Paige 1981), which keeps repeated and
//! defective eigenvalues together; the PBH distance says for each mode how near it is to being out of reach. Knows
//! matrices only; observability of (A, C) is reachability of (A^T, C^T).

use crate::lyapunov::{LyapunovError, lyapunov, stein};
use crate::modes::Time;
use crate::schur::{NoConvergence, eigenvalues};
use nalgebra::{Complex, DMatrix};

/// A mode and how well it is reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Eigenvalue.
    pub eigenvalue: Complex<f64>,
    /// Smallest singular value of [A - z I, B] over the norm of [A, B]: the relative change of the data that would put
    /// the mode out of reach.
    pub distance: f64,
    /// Combination of states that no input moves at this distance (length n, moduli, unit norm).
    pub combination: Vec<f64>,
}

/// What the inputs of (A, B) reach.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// Dimension of the reachable space.
    pub rank: usize,
    /// All modes, in the order of [`eigenvalues`].
    pub modes: Vec<Mode>,
    /// Eigenvalues of the part out of reach (n - rank of them).
    pub out_of_reach: Vec<Complex<f64>>,
}

/// Reachable space of (A: n x n, B: n x m), modes and their distances. `tolerance` is relative to the norm of [A, B];
/// [`rounding`] is a good one.
///
/// # Errors
/// [`NoConvergence`] where an entry is not finite.
pub fn reachability(a: &DMatrix<f64>, b: &DMatrix<f64>, tolerance: f64) -> Result<Reach, NoConvergence> {
    let staircase = Staircase::new(a, b, tolerance)?;
    let modes = eigenvalues(a)?.into_iter().map(|z| pbh(a, b, z)).collect();
    Ok(Reach { rank: staircase.rank, modes, out_of_reach: eigenvalues(&staircase.rest)? })
}

/// Observable space of (A: n x n, C: p x n): as [`reachability`] of the transposed matrices; `combination` is then the
/// shape of a motion that no output shows.
///
/// # Errors
/// [`NoConvergence`] where an entry is not finite.
pub fn observability(a: &DMatrix<f64>, c: &DMatrix<f64>, tolerance: f64) -> Result<Reach, NoConvergence> {
    reachability(&a.transpose(), &c.transpose(), tolerance)
}

/// Rounding of n x n data: changes of this relative size cannot be told from none.
#[must_use]
pub fn rounding(n: usize) -> f64 {
    8.0 * n as f64 * f64::EPSILON
}

/// Popov, Belevitch and Hautus: distance of one mode from being out of reach.
#[must_use]
pub fn pbh(a: &DMatrix<f64>, b: &DMatrix<f64>, z: Complex<f64>) -> Mode {
    let (n, m) = b.shape();
    let size = a.norm().hypot(b.norm()).max(f64::MIN_POSITIVE);
    let pencil = DMatrix::from_fn(n, n + m, |i, j| {
        let entry = if j < n { a[(i, j)] } else { b[(i, j - n)] };
        Complex::new(entry, 0.0) - if i == j { z } else { Complex::new(0.0, 0.0) }
    });
    let svd = pencil.svd(true, false);
    let (k, least) = svd.singular_values.argmin();
    let combination = svd.u.map_or_else(|| vec![0.0; n], |u| u.column(k).iter().map(|w| w.norm()).collect());
    Mode { eigenvalue: z, distance: least / size, combination }
}

/// Reachable dimension and the block of A that no input reaches.
pub(crate) struct Staircase {
    pub rank: usize,
    /// (n - rank) x (n - rank).
    pub rest: DMatrix<f64>,
}

impl Staircase {
    pub(crate) fn new(a: &DMatrix<f64>, b: &DMatrix<f64>, tolerance: f64) -> Result<Self, NoConvergence> {
        if a.iter().chain(b.iter()).any(|x| !x.is_finite()) {
            return Err(NoConvergence);
        }
        let threshold = tolerance * a.norm().hypot(b.norm());
        let (mut rest, mut enters, mut rank) = (a.clone(), b.clone(), 0);
        loop {
            let n = rest.nrows();
            if n == 0 || enters.ncols() == 0 {
                return Ok(Self { rank, rest });
            }
            // a square matrix, so that the left factor is a whole basis
            let mut square = DMatrix::zeros(n, n.max(enters.ncols()));
            square.view_mut((0, 0), enters.shape()).copy_from(&enters);
            let svd = square.svd(true, false);
            let Some(u) = svd.u else { return Err(NoConvergence) };
            let mut order: Vec<usize> = (0..n).collect();
            order.sort_by(|&i, &j| svd.singular_values[j].total_cmp(&svd.singular_values[i]));
            let step = order.iter().filter(|&&i| svd.singular_values[i] > threshold).count();
            if step == 0 {
                return Ok(Self { rank, rest });
            }
            let basis = DMatrix::from_fn(n, n, |i, j| u[(i, order[j])]);
            let turned = basis.transpose() * &rest * &basis;
            rank += step;
            enters = turned.view((step, 0), (n - step, step)).into_owned();
            rest = turned.view((step, step), (n - step, n - step)).into_owned();
        }
    }
}

/// Reachability Gramian of a stable pair: A W + W A^T + B B^T = 0, or A W A^T - W + B B^T = 0 (n x n). The observability
/// Gramian is that of (A^T, C^T).
///
/// # Errors
/// `Ok(None)` where A is not stable; [`LyapunovError`] where the equation has no solution.
pub fn gramian(a: &DMatrix<f64>, b: &DMatrix<f64>, time: Time) -> Result<Option<DMatrix<f64>>, LyapunovError> {
    if !time.stable(&eigenvalues(a).map_err(LyapunovError::NoConvergence)?) {
        return Ok(None);
    }
    let q = b * b.transpose();
    let solution = match time {
        Time::Continuous => lyapunov(a, &q),
        Time::Discrete => stein(a, &q),
    };
    solution.map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    #[test]
    fn a_chain_of_integrators_is_reached_from_its_end_only() {
        let n = 12;
        let a = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from(j == i + 1)));
        let end = DMatrix::from_fn(n, 1, |i, _| f64::from(u8::from(i == n - 1)));
        let start = DMatrix::from_fn(n, 1, |i, _| f64::from(u8::from(i == 0)));
        assert_eq!(reachability(&a, &end, rounding(n)).unwrap().rank, n);
        let reach = reachability(&a, &start, rounding(n)).unwrap();
        assert_eq!((reach.rank, reach.out_of_reach.len()), (1, n - 1));
        assert_eq!(observability(&a, &start.transpose(), rounding(n)).unwrap().rank, n);
    }

    #[test]
    fn a_hidden_mode_is_found_after_a_turn_of_the_coordinates() {
        let mut r = Random::new(3);
        let n = 7;
        let mut a = DMatrix::from_fn(n, n, |_, _| r.within(-1.0, 1.0));
        let mut b = DMatrix::from_fn(n, 2, |_, _| r.within(-1.0, 1.0));
        for j in 0..n - 1 {
            a[(n - 1, j)] = 0.0;
        }
        a[(n - 1, n - 1)] = 0.7;
        b.row_mut(n - 1).fill(0.0);
        let q = DMatrix::from_fn(n, n, |_, _| r.within(-1.0, 1.0)).qr().q();
        let (a, b) = (&q * a * q.transpose(), &q * b);
        let reach = reachability(&a, &b, rounding(n)).unwrap();
        assert_eq!(reach.rank, n - 1);
        assert!((reach.out_of_reach[0] - Complex::new(0.7, 0.0)).norm() < 1e-12);
        let near: Vec<&Mode> = reach.modes.iter().filter(|m| m.distance < 1e-13).collect();
        assert_eq!(near.len(), 1);
        assert!((near[0].eigenvalue.re - 0.7).abs() < 1e-12);
    }

    #[test]
    fn gramian_of_a_first_order_lag() {
        let one = DMatrix::from_element(1, 1, 1.0);
        let w = gramian(&(-2.0 * &one), &one, Time::Continuous).unwrap().unwrap();
        assert!((w[(0, 0)] - 0.25).abs() < 1e-15);
        assert_eq!(gramian(&(2.0 * &one), &one, Time::Continuous).unwrap(), None);
    }
}
