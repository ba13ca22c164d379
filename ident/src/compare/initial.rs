//! The state at the beginning of a run, from what was measured there.
//!
//! Coordinates are those whose outputs are the measured ones (least squares, Newton's steps on h(q)); those that no output
//! sees stay zero. Actuator states are those at which nothing moves with the inputs held.

use super::series::{Line, polynomial};
use crate::record::Start;
use nalgebra::{DMatrix, DVector};
use runtime::Model;

/// Seconds of a record from which its initial state may be estimated.
pub const INITIAL_WINDOW: f64 = 0.2;

/// State at `t[0]`: `outputs[i]` are the measured values of output i at times `t`, `u` the signals at `t[0]`.
#[must_use]
pub fn initial_state(model: &dyn Model, p: &[f64], t: &[f64], outputs: &[Option<Vec<f64>>], u: &[f64], start: Start) -> Vec<f64> {
    let first = t.first().copied().unwrap_or(0.0);
    // at least two samples, however slow the record is
    let window = t.iter().take_while(|&&s| s - first <= INITIAL_WINDOW).count().max(2).min(t.len());
    let measured: Vec<(usize, Line)> = outputs
        .iter()
        .enumerate()
        .filter_map(|(i, values)| {
            let values = values.as_ref().filter(|v| v.len() == t.len() && !v.is_empty())?;
            Some((
                i,
                match start {
                    Start::AtRest => Line { value: values[0], rate: 0.0 },
                    Start::Settled => Line { value: values[..window].iter().sum::<f64>() / window as f64, rate: 0.0 },
                    Start::Free => polynomial(&t[..window], &values[..window], first, if window < 5 { 1 } else { 2 }),
                },
            ))
        })
        .collect();
    state_from(model, p, first, &measured, u)
}

/// Half of the time over which an output's own drift is read [s].
const DRIFT: f64 = 1e-3;

/// State whose outputs have these values and rates.
pub(crate) fn state_from(model: &dyn Model, p: &[f64], t: f64, measured: &[(usize, Line)], u: &[f64]) -> Vec<f64> {
    let d = model.dimensions();
    let (n, states) = (d.coordinates, d.states());
    let mut x = vec![0.0; states];
    let (mut y, mut c, mut dhdp) = (vec![0.0; d.outputs], vec![0.0; d.outputs * states], vec![0.0; d.outputs * d.parameters]);
    let rows = measured.len();
    // outputs of rates see v already in the first part; the few steps converge for any smooth h
    for _ in 0..10 {
        model.outputs(t, &x, p, &mut y);
        model.output_jacobian(t, &x, p, &mut c, &mut dhdp);
        let by_q = DMatrix::from_fn(rows, n, |r, j| c[measured[r].0 * states + j]);
        let residual = DVector::from_fn(rows, |r, _| measured[r].1.value - y[measured[r].0]);
        let Some(step) = least_squares(by_q, &residual) else { break };
        x.iter_mut().zip(step.iter()).for_each(|(x, s)| *x += s);
        if step.amax() <= 1e-14 * x[..n].iter().fold(1.0, |m: f64, x| m.max(x.abs())) {
            break;
        }
    }
    model.output_jacobian(t, &x, p, &mut c, &mut dhdp);
    let by_q = DMatrix::from_fn(rows, n, |r, j| c[measured[r].0 * states + j]);
    // a sensor that drifts reads a rate that is none
    let mut later = vec![0.0; d.outputs];
    model.outputs(t - DRIFT, &x, p, &mut y);
    model.outputs(t + DRIFT, &x, p, &mut later);
    let drift = |output: usize| (later[output] - y[output]) / (2.0 * DRIFT);
    if let Some(rates) = least_squares(by_q, &DVector::from_fn(rows, |r, _| measured[r].1.rate - drift(measured[r].0))) {
        x[n..2 * n].copy_from_slice(rates.as_slice());
    }
    settle_lags(model, p, t, u, &mut x);
    x
}

/// The smallest solution of least squares; `None` where numbers are not finite.
fn least_squares(a: DMatrix<f64>, b: &DVector<f64>) -> Option<DVector<f64>> {
    if a.ncols() == 0 || a.nrows() == 0 || !a.iter().chain(b.iter()).all(|x| x.is_finite()) {
        return None;
    }
    let svd = a.svd(true, true);
    let largest = svd.singular_values.max();
    svd.solve(b, 1e-9 * largest.max(f64::MIN_POSITIVE)).ok()
}

/// Actuator states at which z' = 0 with the signals held: Newton's steps on their part of the state.
pub(crate) fn settle_lags(model: &dyn Model, p: &[f64], t: f64, u: &[f64], x: &mut [f64]) {
    let d = model.dimensions();
    let (states, lags, at) = (d.states(), d.lags, 2 * d.coordinates);
    if lags == 0 {
        return;
    }
    let (mut dx, mut a, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * d.signals()]);
    for _ in 0..10 {
        if model.linearize(t, x, u, p, &mut dx, &mut a, &mut b).is_err() {
            return;
        }
        let slope = DMatrix::from_fn(lags, lags, |i, j| a[(at + i) * states + at + j]);
        let Some(step) = least_squares(slope, &DVector::from_fn(lags, |i, _| -dx[at + i])) else { return };
        x[at..].iter_mut().zip(step.iter()).for_each(|(x, s)| *x += s);
    }
}

/// Actuator states followed along a record, where coordinates and rates are measured: z' = f_z(x, u), with the slope of
/// each z taken as constant from sample to sample (exact for a first-order lag and held inputs).
pub(super) struct Held<'a> {
    model: &'a dyn Model,
    p: &'a [f64],
    /// Time, input and state of the sample before.
    before: Option<(f64, Vec<f64>, Vec<f64>)>,
}

impl<'a> Held<'a> {
    pub fn new(model: &'a dyn Model, p: &'a [f64]) -> Self {
        Self { model, p, before: None }
    }

    /// Puts the actuator states at time `t` into `x`, whose coordinates and rates are known.
    pub fn follow(&mut self, t: f64, u: &[f64], x: &mut [f64]) {
        let d = self.model.dimensions();
        let (states, at) = (d.states(), 2 * d.coordinates);
        if d.lags == 0 {
            return;
        }
        if let Some((before, u, old)) = &self.before {
            let (mut dx, mut a, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * d.signals()]);
            if self.model.linearize(*before, old, u, self.p, &mut dx, &mut a, &mut b).is_ok() {
                for i in at..states {
                    let (h, slope) = (t - before, a[i * states + i]);
                    let gain = if slope == 0.0 { h } else { (slope * h).exp_m1() / slope };
                    x[i] = old[i] + gain * dx[i];
                }
            }
        }
        self.before = Some((t, u.to_vec(), x.to_vec()));
    }
}
