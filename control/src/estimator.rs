//! What a controller knows between its encoders: how rates come from angles, or the whole state from a Kalman filter.
//!
//! Angle by angle: the derivative filter of eq. 23, the chain-of-integrators observer, differences. All at once: a
//! steady-state Kalman filter on the linear model, with the operating point's drift as a constant.

use crate::discretize::{SampleError, Sampled, zero_order_hold};
use crate::filter::{DerivativeFilter, Rule};
use crate::kalman::{KalmanError, kalman};
use crate::linear::LinearModel;
use crate::modes::Time;
use crate::observer::AngleObserver;
use crate::plant::Plant;
use crate::weight::Weight;
use nalgebra::{DMatrix, DVector, dmatrix};

/// How rates are estimated.
#[derive(Clone, Debug)]
pub enum Estimation {
    /// Derivative filter on each angle (eq. 23).
    Filter(DerivativeFilter, Rule),
    /// Observer of each angle (section 2.2 of the seed paper).
    Observer(AngleObserver),
    /// Difference of consecutive samples.
    Differences,
    /// Kalman filter on the linear model; needs what [`KalmanEstimator::new`] makes.
    Kalman(Box<KalmanEstimator>),
}

impl Estimation {
    /// The sampled filter from an angle to its rate; for a Kalman filter (which has no such part) differences.
    ///
    /// # Errors
    /// [`SampleError`], one variant a cause.
    pub fn of_one_angle(&self, period: f64) -> Result<Sampled, SampleError> {
        match self {
            Self::Filter(filter, rule) => filter.sampled(period, *rule),
            Self::Observer(observer) => observer.sampled(1, period),
            Self::Differences | Self::Kalman(_) => {
                if !(period > 0.0 && period.is_finite()) {
                    return Err(SampleError::Period(period));
                }
                Ok(Sampled { a: dmatrix![0.0], b: dmatrix![1.0], c: dmatrix![-1.0 / period], d: dmatrix![1.0 / period], period })
            }
        }
    }
}

/// A linear model with the point that it belongs to.
#[derive(Clone, Copy, Debug)]
pub struct PlantModel<'a> {
    /// A, B, C, drift.
    pub linear: &'a LinearModel,
    /// Names.
    pub plant: &'a Plant,
    /// State x* of the point (n).
    pub x: &'a [f64],
    /// Inputs u* of the point, as the columns of B (m).
    pub u: &'a [f64],
    /// Outputs y* of the point (p).
    pub y: &'a [f64],
}

/// A steady-state Kalman filter, running: x^ in the coordinates of the model, not as a deviation.
#[derive(Clone, Debug)]
pub struct KalmanEstimator {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    drift: DVector<f64>,
    c: DMatrix<f64>,
    correction: DMatrix<f64>,
    point: (DVector<f64>, DVector<f64>, DVector<f64>),
    /// x^ - x*, before the sample of now.
    predicted: DVector<f64>,
    corrected: DVector<f64>,
    started: bool,
}

/// What a running filter computes with: x^ = x- + M (y - y* - C x-), then x- = A x^ + B (u - u*) + drift, in deviations from x*.
#[derive(Clone, Debug, PartialEq)]
pub struct KalmanMatrices {
    /// A over a period (n x n).
    pub a: DMatrix<f64>,
    /// B over a period (n x m).
    pub b: DMatrix<f64>,
    /// What the operating point's drift adds over a period (n).
    pub drift: DVector<f64>,
    /// C (p x n).
    pub c: DMatrix<f64>,
    /// M (n x p).
    pub correction: DMatrix<f64>,
    /// M of the first sample (n x p).
    pub first: DMatrix<f64>,
    /// x*, u*, y*.
    pub point: (DVector<f64>, DVector<f64>, DVector<f64>),
}

impl KalmanEstimator {
    /// `process`: intensity of white noise on each state's rate [unit^2/s]; `measurement`: standard deviation of each output.
    ///
    /// # Errors
    /// [`KalmanError`], one variant a cause.
    pub fn new(model: PlantModel<'_>, process: &[f64], measurement: &[f64], period: f64) -> Result<Self, KalmanError> {
        let (n, m) = (model.plant.a.nrows(), model.plant.b.ncols());
        let mut inputs = DMatrix::zeros(n, m + 1);
        inputs.view_mut((0, 0), (n, m)).copy_from(&model.plant.b);
        inputs.set_column(m, &DVector::from_fn(n, |i, _| model.linear.drift.get(i).copied().unwrap_or(0.0)));
        let (a, inputs) = zero_order_hold(&model.plant.a, &inputs, period).map_err(KalmanError::Sampling)?;
        let sampled = Plant { a: a.clone(), b: inputs.columns(0, m).into_owned(), ..model.plant.clone() };
        let w = crate::discretize::sampled_noise(&model.plant.a, &DMatrix::from_diagonal(&DVector::from_column_slice(process)), period)
            .map_err(KalmanError::Sampling)?;
        let v = Weight::Diagonal(measurement.iter().map(|s| s * s).collect());
        let filter = kalman(&sampled, &Weight::Full(w), &v, Time::Discrete)?;
        let correction = filter.correction.unwrap_or_else(|| filter.gain.clone());
        let vector = |v: &[f64]| DVector::from_column_slice(v);
        Ok(Self {
            a,
            b: sampled.b,
            drift: inputs.column(m).into_owned(),
            c: model.plant.c.clone(),
            correction,
            point: (vector(model.x), vector(model.u), vector(model.y)),
            predicted: DVector::zeros(n),
            corrected: DVector::zeros(n),
            started: false,
        })
    }

    /// Its matrices, for code that is to do the same.
    #[must_use]
    pub fn matrices(&self) -> KalmanMatrices {
        KalmanMatrices {
            a: self.a.clone(),
            b: self.b.clone(),
            drift: self.drift.clone(),
            c: self.c.clone(),
            correction: self.correction.clone(),
            first: self.first(),
            point: self.point.clone(),
        }
    }

    /// The gain of the first sample: the outputs as they are, with all that they do not show at the operating point.
    fn first(&self) -> DMatrix<f64> {
        self.c.clone().pseudo_inverse(1e-9).unwrap_or_else(|_| self.correction.clone())
    }

    /// x^ with the outputs of now; the first ones are taken as they are, with all that they do not show at the operating point.
    pub fn read(&mut self, y: &[f64]) -> DVector<f64> {
        let deviation = DVector::from_fn(self.c.nrows(), |i, _| y.get(i).map_or(0.0, |y| y - self.point.2[i]));
        let innovation = deviation - &self.c * &self.predicted;
        let gain = if self.started { None } else { Some(self.first()) };
        self.started = true;
        self.corrected = &self.predicted + gain.as_ref().unwrap_or(&self.correction) * innovation;
        &self.corrected + &self.point.0
    }

    /// Tells the inputs that are held until the next sample.
    pub fn hold(&mut self, u: &DVector<f64>) {
        self.predicted = &self.a * &self.corrected + &self.b * (u - &self.point.1) + &self.drift;
    }
}
