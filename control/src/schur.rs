//! Complex Schur form A = U T U^H and eigenvalues of real matrices, with a bounded number of steps.
//!
//! Knows matrices only. nalgebra's real Schur form has neither exceptional shifts nor a bound by default (a cyclic
//! permutation keeps it turning for ever), so that eigenvalues, Lyapunov equations and pole placement stand on this one.

use nalgebra::{Complex, DMatrix};
use std::fmt;

type C = Complex<f64>;

/// The QR iteration did not converge: the matrix holds a value that is not finite, or is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoConvergence;

impl fmt::Display for NoConvergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the eigenvalues of a matrix were not found: an entry is not finite or is out of range")
    }
}

impl std::error::Error for NoConvergence {}

/// A = U T U^H with U unitary and T upper triangular (n x n).
#[derive(Clone, Debug)]
pub(crate) struct Schur {
    /// Unitary.
    pub u: DMatrix<C>,
    /// Upper triangular; its diagonal holds the eigenvalues.
    pub t: DMatrix<C>,
}

/// Steps between deflations after which the matrix is given up.
const STEPS: usize = 90;

impl Schur {
    /// Single-shift QR iteration (Golub and Van Loan, Matrix Computations, 7.4-7.5) with Wilkinson's shift.
    pub(crate) fn new(a: &DMatrix<f64>) -> Result<Self, NoConvergence> {
        if a.iter().any(|x| !x.is_finite()) {
            return Err(NoConvergence);
        }
        let n = a.nrows();
        let mut s = Self { u: DMatrix::identity(n, n), t: a.map(|x| C::new(x, 0.0)) };
        s.reduce_to_hessenberg();
        let size = s.t.norm();
        let (mut end, mut steps) = (n.saturating_sub(1), 0);
        while end > 0 {
            let start = s.deflate(end, size);
            if start == end {
                end -= 1;
                steps = 0;
                continue;
            }
            steps += 1;
            if steps > STEPS {
                return Err(NoConvergence);
            }
            s.step(start, end, steps % 10 == 0);
        }
        Ok(s)
    }

    fn reduce_to_hessenberg(&mut self) {
        let n = self.t.nrows();
        for k in 0..n.saturating_sub(2) {
            for i in (k + 2..n).rev() {
                if self.t[(i, k)] != C::new(0.0, 0.0) {
                    // rotations of neighbours: zeros that are there stay exact
                    self.rotate(i - 1, self.t[(i - 1, k)], self.t[(i, k)], 0, n);
                    self.t[(i, k)] = C::new(0.0, 0.0);
                }
            }
        }
    }

    /// First row of the unreduced block that ends at `end`; negligible subdiagonals are set to zero.
    fn deflate(&mut self, end: usize, size: f64) -> usize {
        let mut l = end;
        while l > 0 {
            let near = self.t[(l, l)].norm() + self.t[(l - 1, l - 1)].norm();
            if self.t[(l, l - 1)].norm() <= f64::EPSILON * if near > 0.0 { near } else { size } {
                self.t[(l, l - 1)] = C::new(0.0, 0.0);
                break;
            }
            l -= 1;
        }
        l
    }

    fn step(&mut self, start: usize, end: usize, exceptional: bool) {
        let t = &self.t;
        let (a, b, c, d) = (t[(end - 1, end - 1)], t[(end - 1, end)], t[(end, end - 1)], t[(end, end)]);
        let shift = if exceptional {
            d + C::new(0.75 * c.norm(), 0.3 * c.norm())
        } else {
            let half = (a - d) * 0.5;
            let root = (half * half + b * c).sqrt();
            let far = if (half + root).norm() > (half - root).norm() { half + root } else { half - root };
            if far.norm() > 0.0 { d - b * c / far } else { d }
        };
        // bulge chase: the first rotation is that of T - shift I
        let (mut x, mut y) = (t[(start, start)] - shift, t[(start + 1, start)]);
        for k in start..end {
            if k > start {
                (x, y) = (self.t[(k, k - 1)], self.t[(k + 1, k - 1)]);
            }
            self.rotate(k, x, y, k.saturating_sub(usize::from(k > start)), (k + 3).min(end + 1));
            if k > start {
                self.t[(k + 1, k - 1)] = C::new(0.0, 0.0);
            }
        }
    }

    /// Similarity by the rotation of rows k, k + 1 that takes (x, y) to (r, 0): rows from column `from` on, columns down
    /// to row `below`.
    fn rotate(&mut self, k: usize, x: C, y: C, from: usize, below: usize) {
        let r = x.norm().hypot(y.norm());
        if r == 0.0 {
            return;
        }
        let (c, s) = (x / r, y / r);
        for j in from..self.t.ncols() {
            let (p, q) = (self.t[(k, j)], self.t[(k + 1, j)]);
            self.t[(k, j)] = c.conj() * p + s.conj() * q;
            self.t[(k + 1, j)] = c * q - s * p;
        }
        let right = |m: &mut DMatrix<C>, rows: usize| {
            for i in 0..rows {
                let (p, q) = (m[(i, k)], m[(i, k + 1)]);
                m[(i, k)] = p * c + q * s;
                m[(i, k + 1)] = q * c.conj() - p * s.conj();
            }
        };
        right(&mut self.t, below);
        let n = self.u.nrows();
        right(&mut self.u, n);
    }

    /// Exchanges the eigenvalues at k and k + 1.
    pub(crate) fn swap(&mut self, k: usize) {
        let (x, y) = (self.t[(k, k + 1)], self.t[(k + 1, k + 1)] - self.t[(k, k)]);
        self.rotate(k, x, y, k, k + 2);
        self.t[(k + 1, k)] = C::new(0.0, 0.0);
    }
}

/// Eigenvalues of a real square matrix, by real part, then by imaginary part; pairs are exact conjugates.
///
/// # Errors
/// [`NoConvergence`] where an entry is not finite.
pub fn eigenvalues(a: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, NoConvergence> {
    if a.iter().any(|x| !x.is_finite()) {
        return Err(NoConvergence);
    }
    let d = crate::balance::state_scaling(a);
    let schur = Schur::new(&crate::balance::scaled(a, &d))?;
    let mut left: Vec<C> = schur.t.diagonal().iter().copied().collect();
    left.sort_by(|p, q| q.im.abs().total_cmp(&p.im.abs()));
    let mut all = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let z = left.remove(0);
        let partner = left.iter().enumerate().map(|(j, w)| (j, (w - z.conj()).norm())).min_by(|p, q| p.1.total_cmp(&q.1));
        match partner {
            // nearer to another's mirror image than to its own: one of a pair
            Some((j, distance)) if distance < 2.0 * z.im.abs() => {
                let w = left.remove(j);
                let mean = C::new(0.5 * (z.re + w.re), 0.5 * (z.im.abs() + w.im.abs()));
                all.push(mean.conj());
                all.push(mean);
            }
            _ => all.push(C::new(z.re, 0.0)),
        }
    }
    // rounding must not decide the order of a pair
    let size = all.iter().fold(0.0_f64, |m, z| m.max(z.norm())).max(f64::MIN_POSITIVE);
    let key = |x: f64| (x / size * 1e9).round();
    all.sort_by(|p, q| key(p.re).total_cmp(&key(q.re)).then(p.im.total_cmp(&q.im)));
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    #[test]
    fn schur_form_multiplies_back_and_is_triangular() {
        let mut r = Random::new(1);
        for n in [1, 2, 3, 5, 8, 20] {
            let a = DMatrix::from_fn(n, n, |_, _| r.within(-1.0, 1.0));
            let s = Schur::new(&a).unwrap();
            let back = &s.u * &s.t * s.u.adjoint();
            assert!((back - a.map(|x| C::new(x, 0.0))).norm() < 1e-13 * n as f64);
            assert!((s.u.adjoint() * &s.u - DMatrix::identity(n, n)).norm() < 1e-13 * n as f64);
            assert!((0..n).all(|j| (j + 1..n).all(|i| s.t[(i, j)] == C::new(0.0, 0.0))));
        }
    }

    #[test]
    fn a_cyclic_permutation_has_the_roots_of_one() {
        let n = 6;
        let a = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from(i == (j + 1) % n)));
        for z in eigenvalues(&a).unwrap() {
            assert!((z.powu(6) - C::new(1.0, 0.0)).norm() < 1e-12, "{z}");
        }
    }

    #[test]
    fn pairs_are_exact_and_a_zero_stays_zero() {
        let a = DMatrix::from_row_slice(4, 4, &[0.0, 1.0, 0.0, 0.0, 0.0, -0.48, 1.6, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -25.5, -0.34]);
        let z = eigenvalues(&a).unwrap();
        assert_eq!(z[3], C::new(0.0, 0.0));
        assert_eq!(z[1], z[2].conj());
    }

    #[test]
    fn a_value_that_is_not_finite_is_an_error() {
        assert_eq!(eigenvalues(&DMatrix::from_element(3, 3, f64::NAN)), Err(NoConvergence));
    }
}
