//! Predictions some seconds ahead, from the states that the filter has by then: what a model is worth where a free run says nothing.

use super::filter::{Filtering, Track, run};
use super::noise::Noise;
use crate::fit::FitError;
use crate::record::Start;
use runtime::Model;

/// Predictions of one output over a record.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ahead {
    /// Output of the model.
    pub output: usize,
    /// Where each begins [s].
    pub t: Vec<f64>,
    /// Measured values at the ends of the predictions (SI, angles unwrapped).
    pub measured: Vec<f64>,
    /// Measured less predicted (SI).
    pub error: Vec<f64>,
    /// Standard deviation that the error has by the noise of the model: the state where it began, random forces since, the sensor.
    pub floor: Vec<f64>,
}

/// Predicts the measured outputs `horizon` [s] ahead from at most `starts` samples along the record, random forces unknown from there
/// on. `None` where the record cannot be followed; errors and floors are NaN where the model cannot be run, or nothing was measured.
///
/// # Errors
/// As [`super::pass`].
pub fn ahead(
    model: &dyn Model,
    p: &[f64],
    track: &Track,
    noise: &Noise,
    horizon: f64,
    starts: usize,
) -> Result<Option<Vec<Ahead>>, FitError> {
    let track = track.begun(model, p);
    let times = &track.data.times;
    let n = model.dimensions().states();
    let order = n + noise.entries.len();
    let target = |k: usize| times.partition_point(|&t| t < times[k] + horizon * (1.0 - 1e-9));
    let range: Vec<usize> = (0..times.len()).take_while(|&k| target(k) < times.len()).collect();
    let stride = range.len().div_ceil(starts.max(1)).max(1);
    let mut begun = Vec::new();
    let mut k = 0;
    // the filter has found its state by the first start
    let first = times.partition_point(|t| *t < times[0] + 0.5 * horizon);
    let found = run(model, p, &track, noise, &[], &Filtering::Riccati, &mut |seen| {
        let (state, covariance) = seen.updated;
        if k >= first && (k - first).is_multiple_of(stride) && k < range.len() {
            let sd: Vec<f64> = (0..n).map(|i| covariance[i * order + i].max(0.0).sqrt()).collect();
            begun.push((k, state[..n].to_vec(), sd, seen.readings.to_vec()));
        }
        k += 1;
    })?;
    if found.is_none() {
        return Ok(None);
    }
    let mut all: Vec<Ahead> = track.data.outputs.iter().map(|&output| Ahead { output, ..Ahead::default() }).collect();
    for (k, initial, initial_sd, readings) in begun {
        let end = target(k);
        let mut data = track.data.clone();
        data.times = times[k..=end].to_vec();
        data.start = Start::Free;
        for values in &mut data.measured {
            *values = values[k..=end].to_vec();
            let last = values.len() - 1;
            values[..last].fill(f64::NAN);
        }
        let part = Track { data, initial_sd, initial, readings };
        let pass = run(model, p, &part, noise, &[], &Filtering::Riccati, &mut |_| {})?.unwrap_or_default();
        for (i, own) in all.iter_mut().enumerate() {
            own.t.push(times[k]);
            own.measured.push(track.data.measured[i][end]);
            let at = pass.at.iter().position(|(_, output)| *output == own.output);
            let (error, floor) = at.map_or((f64::NAN, f64::NAN), |at| (pass.z[at] * pass.gains.sd[at], pass.gains.sd[at]));
            own.error.push(error);
            own.floor.push(floor);
        }
    }
    Ok(Some(all))
}
