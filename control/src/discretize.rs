//! Sampled models: zero-order hold, Tustin's rule, cost and noise between samples (Van Loan 1978).
//!
//! Knows matrices only. Everything goes through nalgebra's matrix exponential of a block matrix.

use nalgebra::DMatrix;
use std::fmt;

/// Why there is no sampled model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SampleError {
    /// The period is not a positive finite number.
    Period(f64),
    /// The matrix exponential overflows: the period is far too long for the fastest mode, or an entry is not finite.
    Overflow {
        /// Period [s].
        period: f64,
    },
    /// Tustin's rule has a pole of the continuous system at 2 / period.
    Tustin {
        /// Period [s].
        period: f64,
    },
}

impl fmt::Display for SampleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Period(period) => write!(f, "the sampling period must be a positive number of seconds, it is {period}"),
            Self::Overflow { period } => write!(f, "the model sampled at {period} s overflows: take a shorter period"),
            Self::Tustin { period } => {
                write!(f, "Tustin's rule fails at {period} s: the model has a pole at 2 / period; take another period")
            }
        }
    }
}

impl std::error::Error for SampleError {}

/// exp(M T), checked.
fn exponential(m: DMatrix<f64>, period: f64) -> Result<DMatrix<f64>, SampleError> {
    if !(period > 0.0 && period.is_finite()) {
        return Err(SampleError::Period(period));
    }
    let overflow = SampleError::Overflow { period };
    let m = m * period;
    // e^700 is near the end of the range
    if m.iter().any(|x| !x.is_finite()) || m.norm() > 1e9 {
        return Err(overflow);
    }
    let e = m.exp();
    if e.iter().all(|x| x.is_finite()) { Ok(e) } else { Err(overflow) }
}

fn blocks(rows: &[&[&DMatrix<f64>]]) -> DMatrix<f64> {
    let height: usize = rows.iter().map(|r| r[0].nrows()).sum();
    let width: usize = rows[0].iter().map(|b| b.ncols()).sum();
    let mut m = DMatrix::zeros(height, width);
    let mut i = 0;
    for row in rows {
        let mut j = 0;
        for block in *row {
            m.view_mut((i, j), block.shape()).copy_from(block);
            j += block.ncols();
        }
        i += row[0].nrows();
    }
    m
}

/// Zero-order hold: x(k + 1) = Ad x(k) + Bd u(k) for inputs held over the period [s]. A n x n, B n x m.
///
/// # Errors
/// [`SampleError`], one variant a cause.
pub fn zero_order_hold(a: &DMatrix<f64>, b: &DMatrix<f64>, period: f64) -> Result<(DMatrix<f64>, DMatrix<f64>), SampleError> {
    let (n, m) = b.shape();
    let e = exponential(blocks(&[&[a, b], &[&DMatrix::zeros(m, n), &DMatrix::zeros(m, m)]]), period)?;
    Ok((e.view((0, 0), (n, n)).into_owned(), e.view((0, n), (n, m)).into_owned()))
}

/// Cost of sampled inputs: the integral over a period of x^T Q x + u^T R u is x^T Qd x + 2 x^T Nd u + u^T Rd u.
#[derive(Clone, Debug, PartialEq)]
pub struct SampledCost {
    /// n x n.
    pub q: DMatrix<f64>,
    /// m x m.
    pub r: DMatrix<f64>,
    /// n x m.
    pub n: DMatrix<f64>,
}

/// Weights of the sampled problem that have the continuous cost (Van Loan 1978, as MATLAB's `lqrd`).
///
/// # Errors
/// [`SampleError`], one variant a cause.
pub fn sampled_cost(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    q: &DMatrix<f64>,
    r: &DMatrix<f64>,
    period: f64,
) -> Result<SampledCost, SampleError> {
    let (n, m) = b.shape();
    let motion = blocks(&[&[a, b], &[&DMatrix::zeros(m, n), &DMatrix::zeros(m, m)]]);
    let weight = blocks(&[&[q, &DMatrix::zeros(n, m)], &[&DMatrix::zeros(m, n), r]]);
    let total = integral(&motion, &weight, period)?;
    Ok(SampledCost {
        q: total.view((0, 0), (n, n)).into_owned(),
        r: total.view((n, n), (m, m)).into_owned(),
        n: total.view((0, n), (n, m)).into_owned(),
    })
}

/// Covariance that white noise of intensity W (n x n) adds over a period: the integral of exp(A s) W exp(A^T s).
///
/// # Errors
/// [`SampleError`], one variant a cause.
pub fn sampled_noise(a: &DMatrix<f64>, w: &DMatrix<f64>, period: f64) -> Result<DMatrix<f64>, SampleError> {
    integral(&a.transpose(), w, period)
}

/// The integral over the period of exp(M^T s) W exp(M s), symmetric.
fn integral(m: &DMatrix<f64>, w: &DMatrix<f64>, period: f64) -> Result<DMatrix<f64>, SampleError> {
    let n = m.nrows();
    let e = exponential(blocks(&[&[&-m.transpose(), w], &[&DMatrix::zeros(n, n), m]]), period)?;
    let value = e.view((n, n), (n, n)).transpose() * e.view((0, n), (n, n));
    Ok((&value + value.transpose()) * 0.5)
}

/// A sampled system: x(k + 1) = A x(k) + B u(k), y(k) = C x(k) + D u(k).
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// n x n.
    pub a: DMatrix<f64>,
    /// n x m.
    pub b: DMatrix<f64>,
    /// p x n.
    pub c: DMatrix<f64>,
    /// p x m.
    pub d: DMatrix<f64>,
    /// Period [s].
    pub period: f64,
}

/// Tustin's rule, s = 2/T (z - 1)/(z + 1), with states as in MATLAB's `c2d(.., 'tustin')`:
/// x(k) of the sampled system is (I - A T/2) x - B T/2 u of the continuous one.
///
/// # Errors
/// [`SampleError`], one variant a cause.
pub fn tustin(a: &DMatrix<f64>, b: &DMatrix<f64>, c: &DMatrix<f64>, d: &DMatrix<f64>, period: f64) -> Result<Sampled, SampleError> {
    if !(period > 0.0 && period.is_finite()) {
        return Err(SampleError::Period(period));
    }
    let one = DMatrix::<f64>::identity(a.nrows(), a.nrows());
    let half = a * (0.5 * period);
    let inverse = (&one - &half).try_inverse().filter(|m| m.iter().all(|x| x.is_finite())).ok_or(SampleError::Tustin { period })?;
    let output = c * &inverse;
    Ok(Sampled {
        a: (&one + &half) * &inverse,
        b: (&one + (&one + &half) * &inverse) * b * (0.5 * period),
        d: d + &output * b * (0.5 * period),
        c: output,
        period,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Complex, dmatrix};

    #[test]
    fn double_integrator_sampled_has_its_closed_form() {
        let (a, b) = (dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![0.0; 1.0]);
        let t = 0.1;
        let (ad, bd) = zero_order_hold(&a, &b, t).unwrap();
        assert!((ad - dmatrix![1.0, t; 0.0, 1.0]).norm() < 1e-15);
        assert!((bd - dmatrix![t * t / 2.0; t]).norm() < 1e-15);
        // cost of position: the integral of (x + v s + u s^2/2)^2
        let cost = sampled_cost(&a, &b, &dmatrix![1.0, 0.0; 0.0, 0.0], &dmatrix![1.0], t).unwrap();
        assert!((cost.q - dmatrix![t, t * t / 2.0; t * t / 2.0, t.powi(3) / 3.0]).norm() < 1e-15);
        assert!((cost.n - dmatrix![t.powi(3) / 6.0; t.powi(4) / 8.0]).norm() < 1e-15);
        assert!((cost.r[(0, 0)] - (t + t.powi(5) / 20.0)).abs() < 1e-15);
        // noise of acceleration
        let noise = sampled_noise(&a, &dmatrix![0.0, 0.0; 0.0, 1.0], t).unwrap();
        assert!((noise - dmatrix![t.powi(3) / 3.0, t * t / 2.0; t * t / 2.0, t]).norm() < 1e-15);
    }

    #[test]
    fn tustin_keeps_the_frequency_response_at_warped_frequencies() {
        let (a, b, c, d) = (dmatrix![-0.5, 2.0; -3.0, -0.1], dmatrix![1.0; 0.3], dmatrix![1.0, -0.4], dmatrix![0.2]);
        let t = 0.05;
        let s = tustin(&a, &b, &c, &d, t).unwrap();
        let response = |a: &DMatrix<f64>, b: &DMatrix<f64>, c: &DMatrix<f64>, d: &DMatrix<f64>, z: Complex<f64>| {
            let complex = |m: &DMatrix<f64>| m.map(|x| Complex::new(x, 0.0));
            let pencil = DMatrix::from_diagonal_element(2, 2, z) - complex(a);
            (complex(c) * pencil.lu().solve(&complex(b)).unwrap() + complex(d))[(0, 0)]
        };
        let z = Complex::new(0.0, 1.3 * t).exp();
        let warped = (z - 1.0) / (z + 1.0) * (2.0 / t);
        let difference = response(&s.a, &s.b, &s.c, &s.d, z) - response(&a, &b, &c, &d, warped);
        assert!(difference.norm() < 1e-13, "{difference}");
    }

    #[test]
    fn periods_that_make_no_sense_are_refused() {
        let (a, b) = (dmatrix![1.0], dmatrix![1.0]);
        assert_eq!(zero_order_hold(&a, &b, 0.0), Err(SampleError::Period(0.0)));
        assert!(matches!(zero_order_hold(&a, &b, 1e5), Err(SampleError::Overflow { .. })));
    }
}
