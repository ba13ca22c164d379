//! Whether the inputs of a record are its own.
//!
//! Two ways have to say no: the filter with the model, to which a model that lacks much may be deaf, and a regression that knows no model.

use crate::chance::beyond;
use crate::model::Prepared;
use ident::fit::FitError;
use ident::innovations::{Noise, Track, likelihood};
use nalgebra::{DMatrix, DVector};

/// Log-likelihood that the inputs of a record must be worth.
const WORTH: f64 = 5.0;
/// Earlier values of an output, and of the inputs, in the regression.
const LAGS: usize = 3;
/// Samples between them.
const STRIDES: [usize; 5] = [1, 2, 4, 8, 16];
/// p-value at which a regression says that inputs matter: innovations of a poor model hang together, which makes p-values small.
const MATTERS: f64 = 1e-6;

/// Records whose inputs explain nothing of their motion, neither with the fitted parameters nor with the rig's own, nor without a model.
///
/// # Errors
/// As the filter.
pub fn strangers(prepared: &Prepared, fitted: &[Vec<f64>], own: &[f64], noise: &Noise, tracks: &[Track]) -> Result<Vec<String>, FitError> {
    let mut faults = Vec::new();
    for (track, fitted) in tracks.iter().zip(fitted) {
        let mut worth = f64::NEG_INFINITY;
        for p in [fitted.as_slice(), own] {
            let Some(still) = track.without_inputs(&prepared.model, p) else {
                worth = f64::INFINITY;
                break;
            };
            let of = |track: &Track| likelihood(&prepared.model, p, track, noise).map(|l| l.map(|l| l.iter().sum::<f64>()));
            worth = match (of(track)?, of(&still)?) {
                (Some(with), Some(without)) => worth.max(with - without),
                // without them the record cannot be followed
                (Some(_), None) => f64::INFINITY,
                // what cannot be followed says nothing
                (None, _) => worth,
            };
        }
        if worth < WORTH && !matter(prepared, own, track) {
            faults.push(format!(
                "{}: the inputs explain nothing of the motion{}: are they this record's own?",
                track.source(),
                if worth.is_finite() { format!(" (log-likelihood {worth:+.0} against their means)") } else { String::new() }
            ));
        }
    }
    Ok(faults)
}

/// Some output follows its own past better with the inputs' past: regressions with and without it, compared by their squared errors.
fn matter(prepared: &Prepared, p: &[f64], track: &Track) -> bool {
    let inputs: Vec<Vec<f64>> = track.times().iter().map(|t| track.inputs(&prepared.model, p, *t)).collect();
    let questions = (STRIDES.len() * track.measured().count()) as f64;
    track.measured().any(|(_, y)| STRIDES.iter().any(|&stride| questions * follows(y, &inputs, stride) < MATTERS))
}

/// p-value of an output not caring for the inputs, in samples `stride` apart.
fn follows(y: &[f64], inputs: &[Vec<f64>], stride: usize) -> f64 {
    let signals = inputs.first().map_or(0, Vec::len);
    let (short, long) = (1 + LAGS, 1 + LAGS + LAGS * signals);
    let mean = |k: usize, j: usize| inputs[k - stride..k].iter().map(|u| u[j]).sum::<f64>() / stride as f64;
    let rows: Vec<usize> = (LAGS..)
        .map(|k| k * stride)
        .take_while(|k| *k < y.len().min(inputs.len()))
        .filter(|k| (0..=LAGS).all(|lag| y[k - lag * stride].is_finite()))
        .collect();
    if signals == 0 || rows.len() < 4 * long {
        return 1.0;
    }
    let entry = |k: usize, c: usize| match c {
        0 => 1.0,
        c if c < short => y[k - c * stride],
        c => mean(k - (c - short) / signals * stride, (c - short) % signals),
    };
    let target = DVector::from_iterator(rows.len(), rows.iter().map(|k| y[*k]));
    let left = |columns: usize| {
        let x = DMatrix::from_fn(rows.len(), columns, |i, c| entry(rows[i], c));
        let solved = x.clone().svd(true, true).solve(&target, 1e-10).ok()?;
        Some((&target - x * solved).norm_squared())
    };
    match (left(short), left(long)) {
        (Some(without), Some(with)) if with > 0.0 => beyond(rows.len() as f64 * (without / with).ln(), long - short),
        _ => 1.0,
    }
}
