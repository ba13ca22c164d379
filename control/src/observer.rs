//! Luenberger observers: of a plant, by a gain from pole placement or from a Kalman filter; and of a single angle as a
//! chain of integrators, as the seed paper estimates rates and accelerations (its section 2.2).

use crate::discretize::{SampleError, Sampled, zero_order_hold};
use nalgebra::{Complex, DMatrix, DVector};

/// An observer as a sampled system: x^(k + 1) = (A - L C) x^(k) + B u(k) + L y(k).
#[derive(Clone, Debug, PartialEq)]
pub struct Observer {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    gain: DMatrix<f64>,
    /// The estimate x^ (n).
    pub estimate: DVector<f64>,
}

impl Observer {
    /// Of a continuous plant x' = A x + B u, y = C x with gain L (n x p), sampled exactly for held u and y.
    ///
    /// # Errors
    /// [`SampleError`], one variant a cause.
    pub fn sampled(a: &DMatrix<f64>, b: &DMatrix<f64>, c: &DMatrix<f64>, gain: &DMatrix<f64>, period: f64) -> Result<Self, SampleError> {
        let (n, m, p) = (a.nrows(), b.ncols(), gain.ncols());
        let mut inputs = DMatrix::zeros(n, m + p);
        inputs.view_mut((0, 0), (n, m)).copy_from(b);
        inputs.view_mut((0, m), (n, p)).copy_from(gain);
        let (a, inputs) = zero_order_hold(&(a - gain * c), &inputs, period)?;
        Ok(Self { a, b: inputs.columns(0, m).into_owned(), gain: inputs.columns(m, p).into_owned(), estimate: DVector::zeros(n) })
    }

    /// Takes the input held from now on and the output read now; the estimate is then that of the next sample.
    pub fn step(&mut self, u: &DVector<f64>, y: &DVector<f64>) {
        self.estimate = &self.a * &self.estimate + &self.b * u + &self.gain * y;
    }
}

/// Observer of an angle whose highest derivative is taken as constant: q, q', .. up to the number of poles - 1. The
/// gains are the coefficients of the polynomial with these roots. With two poles it is the filter of eq. 23.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleObserver {
    gains: Vec<f64>,
}

impl AngleObserver {
    /// From its poles (closed under conjugation): two for rates, three for accelerations too.
    #[must_use]
    pub fn new(poles: &[Complex<f64>]) -> Self {
        let mut polynomial = vec![Complex::new(1.0, 0.0)];
        for z in poles {
            polynomial.push(Complex::new(0.0, 0.0));
            for k in (1..polynomial.len()).rev() {
                let lower = polynomial[k - 1];
                polynomial[k] -= z * lower;
            }
        }
        Self { gains: polynomial.iter().skip(1).map(|c| c.re).collect() }
    }

    /// A, B, C of the observer from the angle to derivative `order` of it.
    #[must_use]
    pub fn state_space(&self, order: usize) -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
        let n = self.gains.len();
        let a = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from(j == i + 1)) - if j == 0 { self.gains[i] } else { 0.0 });
        let b = DMatrix::from_fn(n, 1, |i, _| self.gains[i]);
        (a, b, DMatrix::from_fn(1, n, |_, j| f64::from(u8::from(j == order))))
    }

    /// Sampled exactly for a held angle.
    ///
    /// # Errors
    /// [`SampleError`], one variant a cause.
    pub fn sampled(&self, order: usize, period: f64) -> Result<Sampled, SampleError> {
        let (a, b, c) = self.state_space(order);
        zero_order_hold(&a, &b, period).map(|(a, b)| Sampled { a, b, d: DMatrix::zeros(1, 1), c, period })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::filter::{DerivativeFilter, Rule, Running};
    use nalgebra::{dmatrix, dvector};

    #[test]
    fn two_poles_are_the_filter_of_eq_23() {
        let (w, eta) = (100.0, 0.9);
        let pole = Complex::new(-eta * w, w * (1.0_f64 - eta * eta).sqrt());
        let mut observer = Running::new(AngleObserver::new(&[pole, pole.conj()]).sampled(1, 0.005).unwrap());
        let mut filter = Running::new(DerivativeFilter { omega: w, damping: eta }.sampled(0.005, Rule::ZeroOrderHold).unwrap());
        for k in 0..400 {
            let y = (0.02 * f64::from(k)).sin();
            let (a, b) = (observer.next(y), filter.next(y));
            assert!((a - b).abs() < 1e-10, "{a} {b}");
        }
    }

    #[test]
    fn a_plant_observer_forgets_its_start() {
        let (a, b, c) = (dmatrix![0.0, 1.0; -25.5, -0.34], dmatrix![0.0; 5.33], dmatrix![1.0, 0.0]);
        let period = 0.005;
        let gain = crate::placement::place_observer(&a, &c, &[Complex::new(-20.0, 5.0), Complex::new(-20.0, -5.0)]).unwrap().gain;
        let mut observer = Observer::sampled(&a, &b, &c, &gain, period).unwrap();
        let (plant_a, plant_b) = zero_order_hold(&a, &b, period).unwrap();
        let mut x = dvector![0.3, -1.0];
        for _ in 0..400 {
            let u = dvector![0.2];
            observer.step(&u, &(&c * &x));
            x = &plant_a * x + &plant_b * u;
        }
        // a held output is half a period old: that is what remains
        assert!((&observer.estimate - &x).norm() < 0.05 * x.norm(), "{} {x}", observer.estimate);
    }
}
