//! One form fitted to pairs: starting values by linear least squares on a grid of shapes, then nonlinear least squares.

use super::form::Form;
use crate::fit::minimize::{Evaluation, LevenbergMarquardt, Limits, Minimizer, Objective};
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, StudentsT};

/// How the errors of the ordinates are sized.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Errors {
    /// All alike.
    Constant,
    /// In proportion to the map's value, as those of a sensor that is off by some percent.
    Proportional,
}

impl Errors {
    /// The word for JSON.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Proportional => "proportional",
        }
    }
}

/// A form with its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted {
    /// Form.
    pub form: Form,
    /// Errors.
    pub errors: Errors,
    /// Values of its parameters.
    pub p: Vec<f64>,
    /// Their standard errors; `None` where the pairs do not tell them.
    pub std_error: Option<Vec<f64>>,
    /// Half widths of the 95 % intervals over the standard errors (Student's t).
    pub factor: f64,
    /// Root-mean-square error of the ordinate.
    pub rms: f64,
    /// Size of the errors: in the ordinate's unit, or as a part of the value.
    pub sigma: f64,
    /// Akaike's criterion with the correction for few pairs (C. M. Hurvich and C.-L. Tsai, 1989).
    pub aicc: f64,
    /// Schwarz's criterion.
    pub bic: f64,
}

/// Fits one form; `None` where it does not apply or does not converge.
pub(super) fn fit(form: Form, errors: Errors, x: &[f64], y: &[f64]) -> Option<Fitted> {
    let count = form.parameters().len();
    let n = x.len();
    // the corrected criterion needs two more pairs than unknowns (the errors' size is one)
    if n < count + 3 || form.needs_positive() && x.iter().any(|x| *x < 0.0) {
        return None;
    }
    let top = x.iter().copied().fold(0.0, f64::max);
    let mut best: Option<(f64, Vec<f64>)> = None;
    for shape in form.starts(top) {
        let Some(p) = linear(form, errors, x, y, &shape) else { continue };
        let mut problem = Problem { form, x, y, weights: weights(form, errors, &p, x)? };
        let mut found = LevenbergMarquardt.minimize(&mut problem, &p, &Limits::default());
        if errors == Errors::Proportional {
            // weights go with the fitted values
            for _ in 0..10 {
                let Some(weights) = weights(form, errors, &found.x, x) else { break };
                problem.weights = weights;
                let before = found.x.clone();
                found = LevenbergMarquardt.minimize(&mut problem, &found.x, &Limits::default());
                if found.x.iter().zip(&before).all(|(a, b)| (a - b).abs() <= 1e-9 * b.abs()) {
                    break;
                }
            }
        }
        let Some(deviance) = deviance(form, errors, &found.x, x, y) else { continue };
        if best.as_ref().is_none_or(|(b, _)| deviance < *b) {
            best = Some((deviance, found.x));
        }
    }
    let (deviance, p) = best?;
    let weights = weights(form, errors, &p, x)?;
    let mut problem = Problem { form, x, y, weights };
    let at = problem.evaluate(&p)?;
    let free = (n - count) as f64;
    let sigma = (2.0 * at.cost / free).sqrt();
    let k = (count + 1) as f64;
    let n = n as f64;
    let std_error = at
        .normal
        .clone()
        .cholesky()
        .map(|c| c.inverse())
        .map(|c| (0..count).map(|i| sigma * c[(i, i)].max(0.0).sqrt()).collect::<Vec<f64>>())
        .filter(|s| s.iter().all(|s| s.is_finite()));
    let rms = (x.iter().zip(y).map(|(x, y)| (form.evaluate(&p, *x).0 - y).powi(2)).sum::<f64>() / n).sqrt();
    Some(Fitted {
        form,
        errors,
        std_error,
        factor: StudentsT::new(0.0, 1.0, free).map_or(1.96, |t| t.inverse_cdf(0.975)),
        rms,
        sigma,
        aicc: deviance + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0),
        bic: deviance + k * n.ln(),
        p,
    })
}

/// 1 / the size of each error, up to a factor; `None` where a proportional error has no size.
fn weights(form: Form, errors: Errors, p: &[f64], x: &[f64]) -> Option<Vec<f64>> {
    match errors {
        Errors::Constant => Some(vec![1.0; x.len()]),
        Errors::Proportional => {
            let values: Vec<f64> = x.iter().map(|x| form.evaluate(p, *x).0.abs()).collect();
            let largest = values.iter().copied().fold(0.0, f64::max);
            values.iter().all(|v| *v > 1e-6 * largest).then(|| values.iter().map(|v| 1.0 / v).collect())
        }
    }
}

/// -2 ln of the likelihood at its best error size.
fn deviance(form: Form, errors: Errors, p: &[f64], x: &[f64], y: &[f64]) -> Option<f64> {
    let w = weights(form, errors, p, x)?;
    let n = x.len() as f64;
    let sum: f64 = x.iter().zip(y).zip(&w).map(|((x, y), w)| (w * (form.evaluate(p, *x).0 - y)).powi(2)).sum();
    // pairs on the curve to rounding have no error to speak of
    let floor = y.iter().zip(&w).map(|(y, w)| (1e-12 * w * y).powi(2)).sum::<f64>().max(f64::MIN_POSITIVE);
    let d = n * (std::f64::consts::TAU * sum.max(floor) / n).ln() + n - 2.0 * w.iter().map(|w| w.ln()).sum::<f64>();
    d.is_finite().then_some(d)
}

/// Linear coefficients for a given shape, with errors weighted by the measured values.
fn linear(form: Form, errors: Errors, x: &[f64], y: &[f64], shape: &[f64]) -> Option<Vec<f64>> {
    let terms: Vec<Vec<f64>> = x.iter().map(|x| form.terms(*x, shape)).collect();
    let columns = terms.first().map(Vec::len).filter(|c| *c > 0)?;
    let w = |k: usize| if errors == Errors::Proportional { 1.0 / y[k].abs() } else { 1.0 };
    let a = DMatrix::from_fn(x.len(), columns, |k, j| w(k) * terms[k][j]);
    let b = DVector::from_fn(x.len(), |k, _| w(k) * y[k]);
    let svd = a.svd(true, true);
    let largest = svd.singular_values.max();
    let solved = svd.solve(&b, 1e-12 * largest.max(f64::MIN_POSITIVE)).ok()?;
    solved.iter().all(|c| c.is_finite()).then(|| form.assembled(solved.as_slice(), shape))
}

struct Problem<'a> {
    form: Form,
    x: &'a [f64],
    y: &'a [f64],
    weights: Vec<f64>,
}

impl Objective for Problem<'_> {
    fn unknowns(&self) -> usize {
        self.form.parameters().len()
    }

    fn bounds(&self, i: usize) -> (f64, f64) {
        let name = self.form.parameters()[i];
        let top = self.x.iter().copied().fold(0.0, f64::max);
        match (self.form, name) {
            (Form::Power | Form::PowerOffset, "b") => (0.02, 20.0),
            (Form::DeadZonePower, "b") => (1.0, 20.0),
            (Form::DeadZoneAffine | Form::DeadZoneQuadratic | Form::DeadZonePower, "d") => (0.0, 0.999 * top),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }

    fn size(&self, _: usize) -> f64 {
        1.0
    }

    fn evaluate(&mut self, p: &[f64]) -> Option<Evaluation> {
        let m = p.len();
        let mut total = Evaluation { cost: 0.0, gradient: DVector::zeros(m), normal: DMatrix::zeros(m, m) };
        for ((x, y), w) in self.x.iter().zip(self.y).zip(&self.weights) {
            let (value, slopes) = self.form.evaluate(p, *x);
            let error = w * (value - y);
            total.cost += 0.5 * error * error;
            for i in 0..m {
                total.gradient[i] += error * w * slopes[i];
                for j in 0..m {
                    total.normal[(i, j)] += w * w * slopes[i] * slopes[j];
                }
            }
        }
        total.cost.is_finite().then_some(total)
    }
}
