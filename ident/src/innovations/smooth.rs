//! What pushed the rig: disturbances smoothed over the whole record (Rauch, Tung and Striebel, AIAA Journal 3, 1965).

use super::filter::{Filtering, Track, run};
use super::noise::Noise;
use crate::fit::FitError;
use nalgebra::{DMatrix, DVector};
use runtime::Model;

/// States and disturbances of a record, given all its samples.
#[derive(Clone, Debug)]
pub struct Smoothed {
    /// At each sample: states, then disturbances.
    pub state: Vec<Vec<f64>>,
    /// Standard errors of the disturbances.
    pub sd: Vec<Vec<f64>>,
}

/// Smooths; `None` where the model cannot be followed.
///
/// # Errors
/// As [`super::pass`].
pub fn smooth(model: &dyn Model, p: &[f64], track: &Track, noise: &Noise) -> Result<Option<Smoothed>, FitError> {
    struct Step {
        transition: DMatrix<f64>,
        predicted: (DVector<f64>, DMatrix<f64>),
        updated: (DVector<f64>, DMatrix<f64>),
    }
    let n = model.dimensions().states();
    let order = n + noise.entries.len();
    let mut steps: Vec<Step> = Vec::with_capacity(track.times().len());
    let square = |a: &[f64]| DMatrix::from_row_slice(order, order, a);
    let pass = run(model, p, track, noise, &[], &Filtering::Riccati, &mut |seen| {
        steps.push(Step {
            transition: square(seen.transition),
            predicted: (DVector::from_row_slice(seen.predicted.0), square(seen.predicted.1)),
            updated: (DVector::from_row_slice(seen.updated.0), square(seen.updated.1)),
        });
    })?;
    let (Some(_), Some(last)) = (pass, steps.last()) else { return Ok(None) };
    let (mut x, mut covariance) = last.updated.clone();
    let keep = |x: &DVector<f64>, p: &DMatrix<f64>| (x.as_slice().to_vec(), (n..order).map(|i| p[(i, i)].max(0.0).sqrt()).collect());
    let mut found = vec![keep(&x, &covariance)];
    for k in (0..steps.len() - 1).rev() {
        let (here, next) = (&steps[k], &steps[k + 1]);
        // J = P F^T (P-)^-1; scaled, since angles and torques differ by orders of magnitude
        let scale = DVector::from_fn(order, |i, _| next.predicted.1[(i, i)].max(f64::MIN_POSITIVE).sqrt().recip());
        let scaled =
            DMatrix::from_fn(order, order, |i, j| next.predicted.1[(i, j)] * scale[i] * scale[j]) + DMatrix::identity(order, order) * 1e-10;
        let Some(factor) = scaled.cholesky() else { return Ok(None) };
        let mut right = &next.transition * &here.updated.1;
        (0..order).for_each(|i| right.row_mut(i).scale_mut(scale[i]));
        let mut gain = factor.solve(&right);
        (0..order).for_each(|i| gain.row_mut(i).scale_mut(scale[i]));
        let gain = gain.transpose();
        x = &here.updated.0 + &gain * (&x - &next.predicted.0);
        covariance = &here.updated.1 + &gain * (&covariance - &next.predicted.1) * gain.transpose();
        found.push(keep(&x, &covariance));
    }
    found.reverse();
    let (state, sd) = found.into_iter().unzip();
    Ok(Some(Smoothed { state, sd }))
}
