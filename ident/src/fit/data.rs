//! A record as a fit needs it: signals, and the measured outputs with angles unwrapped.

use super::error::FitError;
use crate::compare::is_angle;
use crate::compare::series::unwrap;
use crate::preflight::quantum;
use crate::record::{Bound, Record, Start, bind};
use runtime::Model;
use sim::{Hold, Signals};

/// A record bound to a model.
#[derive(Clone, Debug)]
pub(crate) struct Data {
    pub source: String,
    pub times: Vec<f64>,
    pub signals: Signals,
    /// Outputs of the model that were measured.
    pub outputs: Vec<usize>,
    /// Their values, one list for each (SI).
    pub measured: Vec<Vec<f64>>,
    /// The step in which each of them comes; zero where none is seen.
    pub steps: Vec<f64>,
    /// No more than this is white in each of them (standard deviation, SI).
    pub white: Vec<f64>,
    pub start: Start,
}

impl Data {
    pub fn new(record: &Record, model: &dyn Model, hold: Hold) -> Result<Self, FitError> {
        let Bound { signals, outputs: columns, .. } = bind(record, model, hold)?;
        let (mut outputs, mut measured, mut steps) = (Vec::new(), Vec::new(), Vec::new());
        for (i, values) in columns.into_iter().enumerate() {
            let Some(mut values) = values else { continue };
            if is_angle(model.names().output_unit(i)) {
                unwrap(&mut values);
            }
            outputs.push(i);
            steps.push(quantum(&values).unwrap_or(0.0));
            measured.push(values);
        }
        let white = measured.iter().map(|values| white(values)).collect();
        Ok(Self { source: record.source.clone(), times: record.t.clone(), signals, outputs, measured, steps, white, start: record.start })
    }

    /// Inputs at time t [s] as the model sees them: within their limits.
    pub fn inputs(&self, model: &dyn Model, p: &[f64], t: f64) -> Vec<f64> {
        let mut u = self.signals.at(t);
        for (i, u) in u.iter_mut().enumerate().take(model.dimensions().inputs) {
            let (lo, hi) = model.input_path(i, p).limits;
            *u = u.max(lo).min(hi);
        }
        u
    }
}

/// White noise that would make the third differences of these values; motion only adds to it.
fn white(values: &[f64]) -> f64 {
    let mut third: Vec<f64> = values.windows(4).map(|v| (v[3] - 3.0 * v[2] + 3.0 * v[1] - v[0]).abs()).filter(|d| d.is_finite()).collect();
    third.sort_by(f64::total_cmp);
    1.4826 * third.get(third.len() / 2).copied().unwrap_or(0.0) / 20_f64.sqrt()
}

/// Standard deviation of samples about their mean.
pub(crate) fn spread(values: &[f64]) -> f64 {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt()
}
