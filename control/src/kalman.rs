//! Steady-state Kalman filters, by duality with the regulator.
//!
//! Continuous: x' = A x + w, y = C x + v with intensities W, V: A P + P A^T - P C^T V^-1 C P + W = 0, L = P C^T V^-1.
//! Discrete: x(k + 1) = A x(k) + w, y(k) = C x(k) + v with covariances W, V; P is the covariance of the prediction.

use crate::discretize::SampleError;
use crate::modes::{Time, show, who};
use crate::plant::Plant;
use crate::riccati::{RiccatiData, RiccatiError, solve};
use crate::weight::{Weight, WeightError, Weighted};
use nalgebra::{Complex, DMatrix};
use std::fmt;

/// A steady-state Kalman filter.
#[derive(Clone, Debug, PartialEq)]
pub struct Kalman {
    /// Gain L (n x p): x^' = A x^ + B u + L (y - C x^); discrete: of the one-step predictor,
    /// x^(k + 1) = A x^(k) + B u(k) + L (y(k) - C x^(k)).
    pub gain: DMatrix<f64>,
    /// Discrete only: gain M (n x p) of the correction x^(k) + M (y(k) - C x^(k)), with L = A M.
    pub correction: Option<DMatrix<f64>>,
    /// Covariance P of the error (n x n); discrete: before the correction.
    pub covariance: DMatrix<f64>,
    /// Poles of A - L C.
    pub poles: Vec<Complex<f64>>,
    /// Relative residual of the Riccati equation.
    pub residual: f64,
}

/// Why there is no filter.
#[derive(Clone, Debug, PartialEq)]
pub enum KalmanError {
    /// The intensity of the process noise is wrong.
    Process(WeightError),
    /// The intensity of the measurement noise is wrong.
    Measurement(WeightError),
    /// No states or no outputs.
    Empty,
    /// The plant cannot be sampled like this.
    Sampling(SampleError),
    /// The Riccati equation has no solution.
    Riccati {
        /// Why, in terms of the dual problem.
        error: RiccatiError,
        /// Names of the states.
        states: Vec<String>,
    },
}

impl fmt::Display for KalmanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Process(e) => write!(f, "process noise: {e}"),
            Self::Measurement(e) => write!(f, "measurement noise: {e}"),
            Self::Empty => f.write_str("a filter needs at least one state and one output"),
            Self::Sampling(e) => e.fmt(f),
            Self::Riccati { error: RiccatiError::Unreachable(m), states } => write!(
                f,
                "no output shows the mode at {} ({}), which does not decay by itself: measure one of its states, or leave them out",
                show(m.eigenvalue),
                who(&m.combination, states)
            ),
            Self::Riccati { error: RiccatiError::Unseen(m), states } => write!(
                f,
                "the process noise does not move the mode at {} ({}), which does not decay by itself: its gain would tend to zero; give one of its states some noise",
                show(m.eigenvalue),
                who(&m.combination, states)
            ),
            Self::Riccati { error, states } => f.write_str(&error.with_names(states)),
        }
    }
}

impl std::error::Error for KalmanError {}

/// Filter of a plant (its A discrete where `time` is) with process noise on its states and noise on its outputs.
///
/// # Errors
/// [`KalmanError`], one variant a cause.
pub fn kalman(plant: &Plant, process: &Weight, measurement: &Weight, time: Time) -> Result<Kalman, KalmanError> {
    if plant.states.is_empty() || plant.outputs.is_empty() {
        return Err(KalmanError::Empty);
    }
    let w = process.matrix(Weighted::States, &plant.states).map_err(KalmanError::Process)?;
    let v = measurement.matrix(Weighted::Inputs, &plant.outputs).map_err(KalmanError::Measurement)?;
    let (a, b) = (plant.a.transpose(), plant.c.transpose());
    let data = RiccatiData { a: &a, b: &b, q: &w, r: &v, cross: None };
    let s = solve(data, time).map_err(|error| KalmanError::Riccati { error, states: plant.states.clone() })?;
    let correction = match time {
        Time::Continuous => None,
        // M = P C^T (C P C^T + V)^-1
        Time::Discrete => (&plant.c * &s.x * &b + &v).cholesky().map(|inner| inner.solve(&(&plant.c * &s.x)).transpose()),
    };
    Ok(Kalman { gain: s.gain.transpose(), correction, covariance: s.x, poles: s.poles, residual: s.residual })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    fn plant(a: DMatrix<f64>, c: DMatrix<f64>) -> Plant {
        let names = ["q".to_owned(), "q.dot".to_owned()];
        Plant { states: names.to_vec(), inputs: Vec::new(), outputs: vec!["y".to_owned()], b: DMatrix::zeros(2, 0), a, c }
    }

    #[test]
    fn a_double_integrator_has_its_closed_form() {
        // acceleration noise W, angle noise V: L = (sqrt(2 w), w) with w = sqrt(W/V)
        let s = kalman(
            &plant(dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![1.0, 0.0]),
            &Weight::Diagonal(vec![0.0, 16.0]),
            &Weight::Diagonal(vec![1.0]),
            Time::Continuous,
        )
        .unwrap();
        assert!((s.gain - dmatrix![8.0_f64.sqrt(); 4.0]).norm() < 1e-13);
    }

    #[test]
    fn the_discrete_covariance_is_the_limit_of_the_recursion() {
        let (a, c) = (dmatrix![1.0, 0.1; 0.0, 1.0], dmatrix![1.0, 0.0]);
        let (w, v) = (dmatrix![1e-6, 0.0; 0.0, 1e-3], 1e-4);
        let s = kalman(&plant(a.clone(), c.clone()), &Weight::Full(w.clone()), &Weight::Diagonal(vec![v]), Time::Discrete).unwrap();
        let mut p = DMatrix::identity(2, 2);
        for _ in 0..2000 {
            let m = &p * c.transpose() / ((&c * &p * c.transpose())[(0, 0)] + v);
            p = &a * (&p - &m * &c * &p) * a.transpose() + &w;
        }
        assert!((&s.covariance - &p).norm() < 1e-12 * p.norm());
        let m = s.correction.unwrap();
        assert!((a * m - s.gain).norm() < 1e-12);
    }

    #[test]
    fn modes_that_nothing_shows_are_named() {
        let blind = plant(dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![0.0, 1.0]);
        let error = kalman(&blind, &Weight::Diagonal(vec![1.0, 1.0]), &Weight::Diagonal(vec![1.0]), Time::Continuous).unwrap_err();
        assert_eq!(
            error.to_string(),
            "no output shows the mode at 0 (q), which does not decay by itself: measure one of its states, or leave them out"
        );
        let still = plant(dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![1.0, 0.0]);
        let error = kalman(&still, &Weight::Diagonal(vec![1.0, 0.0]), &Weight::Diagonal(vec![1.0]), Time::Continuous).unwrap_err();
        assert!(error.to_string().starts_with("the process noise does not move the mode at 0 (q.dot)"), "{error}");
        let error = kalman(&still, &Weight::Diagonal(vec![1.0, 0.0]), &Weight::Diagonal(vec![0.0]), Time::Continuous).unwrap_err();
        assert!(error.to_string().starts_with("measurement noise: "), "{error}");
    }
}
