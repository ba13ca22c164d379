//! What the first samples of a stretch say of the state at its beginning: values and standard errors.
//!
//! Each measured output is fitted over 0.2 s by the polynomial of degree 1 to 3 that the Bayesian information criterion
//! prefers: that is where a fit starts. A prior of rates is not laid on the rate at the first sample, for which an
//! acceleration would pass, but on the slope of the straight line over the 0.2 s: the model's must be the measured one to
//! within its standard error, samples having at least the standard deviation of an encoder's quantum.

use super::data::{Data, spread};
use super::options::{InitialStates, Known};
use crate::compare::INITIAL_WINDOW;
use crate::compare::initial::state_from;
use crate::compare::series::Line;
use crate::record::Start;
use nalgebra::{DMatrix, DVector};
use runtime::Model;

/// A state that is an unknown of the fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InitialUnknown {
    /// Index of the state.
    pub state: usize,
    /// Standard deviation of the prior about the estimate; `None` where there is none.
    pub prior_sd: Option<f64>,
    /// A size by which it may change.
    pub size: f64,
}

/// The slope of a straight line over the first samples of an output.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slope {
    /// Which of the measured outputs.
    pub output: usize,
    /// The slope is the sum of these times the first samples.
    pub weights: Vec<f64>,
    /// Measured.
    pub value: f64,
    /// Its standard error.
    pub sd: f64,
}

/// Estimate of an initial state.
#[derive(Clone, Debug)]
pub(crate) struct InitialEstimate {
    pub x: Vec<f64>,
    pub unknowns: Vec<InitialUnknown>,
    /// Priors of the rates.
    pub slopes: Vec<Slope>,
}

/// As a record that starts in this way is treated.
pub(crate) fn usual(start: Start) -> InitialStates {
    match start {
        Start::AtRest | Start::Settled => InitialStates { coordinates: Known::Prior, rates: Known::Fixed },
        Start::Free => InitialStates { coordinates: Known::Prior, rates: Known::Prior },
    }
}

/// The state at sample `from`, from the samples up to `to`.
pub(crate) fn estimate(
    model: &dyn Model,
    p: &[f64],
    data: &Data,
    (from, to): (usize, usize),
    start: Start,
    states: InitialStates,
) -> InitialEstimate {
    let t0 = data.times[from];
    let in_window = data.times[from..=to].iter().take_while(|&&t| t - t0 <= INITIAL_WINDOW).count();
    let window = in_window.max(FEWEST).min(to - from + 1);
    let mut lines = Vec::new();
    let mut errors = Vec::new();
    let mut slopes = Vec::new();
    for (output, (&i, values)) in data.outputs.iter().zip(&data.measured).enumerate() {
        // samples that are out of use are NaN
        let used: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
        let finite = |window: usize| -> (Vec<f64>, Vec<f64>) {
            data.times[from..from + window].iter().zip(&values[from..from + window]).filter(|(_, y)| y.is_finite()).unzip()
        };
        let mut first = finite(window);
        if first.0.len() < FEWEST {
            // the beginning is out of use: the first samples that are not
            let (mut t, mut y) = finite(to - from + 1);
            t.truncate(FEWEST);
            y.truncate(FEWEST);
            first = (t, y);
        }
        let (t, y) = if first.1.is_empty() { (vec![t0], vec![0.0]) } else { first };
        let floor = (model.output_path(i, p).quantum / 12_f64.sqrt()).max(1e-6 * spread(&used));
        let fitted = beginning(t0, &t, &y, floor);
        let value = match (start, states.coordinates) {
            (Start::Settled, _) => y.iter().sum::<f64>() / y.len() as f64,
            (Start::AtRest, _) | (_, Known::Fixed) => y[0],
            _ => fitted.value,
        };
        let rate = if states.rates == Known::Fixed { 0.0 } else { fitted.rate };
        lines.push((i, Line { value, rate }));
        errors.push((fitted.noise, fitted.rate_error));
        slopes.push(slope(output, &t, &y, fitted.noise));
    }
    let x = state_from(model, p, t0, &lines, &data.inputs(model, p, t0));

    let d = model.dimensions();
    let (n, count) = (d.states(), d.coordinates);
    let (mut c, mut dhdp) = (vec![0.0; d.outputs * n], vec![0.0; d.outputs * d.parameters]);
    model.output_jacobian(t0, &x, p, &mut c, &mut dhdp);
    let entry = |r: usize, j: usize| c[lines[r].0 * n + j];
    let back = DMatrix::from_fn(lines.len(), count, entry).pseudo_inverse(1e-9).unwrap_or_else(|_| DMatrix::zeros(count, lines.len()));
    let propagated = |i: usize, of: &dyn Fn(usize) -> f64| (0..lines.len()).map(|r| (back[(i, r)] * of(r)).powi(2)).sum::<f64>().sqrt();
    let mut unknowns = Vec::new();
    for i in 0..count {
        let seen = (0..lines.len()).any(|r| entry(r, i) != 0.0);
        let (sd, rate_sd) = (propagated(i, &|r| errors[r].0), propagated(i, &|r| errors[r].1));
        if seen && states.coordinates != Known::Fixed {
            unknowns.push(InitialUnknown { state: i, prior_sd: (states.coordinates == Known::Prior).then_some(sd), size: sd });
        }
        let rate_read = (0..lines.len()).any(|r| entry(r, count + i) != 0.0);
        if (seen || rate_read) && states.rates != Known::Fixed {
            unknowns.push(InitialUnknown { state: count + i, prior_sd: None, size: if seen { rate_sd } else { 1.0 } });
        }
    }
    // the slope of an output that sees rates is an acceleration
    let of_coordinates = |r: usize| (0..count).any(|j| entry(r, j) != 0.0) && (count..n).all(|j| entry(r, j) == 0.0);
    slopes.retain(|s| states.rates == Known::Prior && of_coordinates(s.output));
    InitialEstimate { x, unknowns, slopes }
}

/// Fewest samples from which a value and a rate are read.
const FEWEST: usize = 4;

/// The straight line over the samples; `noise` is their standard deviation.
fn slope(output: usize, t: &[f64], y: &[f64], noise: f64) -> Slope {
    let mean = t.iter().sum::<f64>() / t.len() as f64;
    let squares: f64 = t.iter().map(|t| (t - mean).powi(2)).sum();
    let weights: Vec<f64> = t.iter().map(|t| (t - mean) / squares.max(f64::MIN_POSITIVE)).collect();
    let value = weights.iter().zip(y).map(|(w, y)| w * y).sum();
    Slope { output, weights, value, sd: noise / squares.max(f64::MIN_POSITIVE).sqrt() }
}

struct Beginning {
    value: f64,
    rate: f64,
    rate_error: f64,
    noise: f64,
}

/// Value and rate at t0 from a few samples; `floor` is the least standard deviation that one sample can have.
fn beginning(t0: f64, t: &[f64], y: &[f64], floor: f64) -> Beginning {
    let n = t.len() as f64;
    let length = (t[t.len() - 1] - t[0]).max(f64::MIN_POSITIVE);
    let fits: Vec<Polynomial> = (1..=3).filter(|&d| d + 1 < t.len()).filter_map(|d| polynomial(t0, t, y, d, length)).collect();
    let Some(best) = (0..fits.len()).min_by(|&a, &b| {
        let bic = |f: &Polynomial| n * (f.squares / n).max(floor * floor).ln() + (f.degree + 1) as f64 * n.ln();
        bic(&fits[a]).total_cmp(&bic(&fits[b]))
    }) else {
        let rate = (y[y.len() - 1] - y[0]) / length;
        return Beginning { value: y[0], rate, rate_error: 2.0 * floor / length + rate.abs(), noise: floor };
    };
    let fit = &fits[best];
    let noise = (fit.squares / (n - fit.degree as f64 - 1.0)).sqrt().max(floor);
    let next = fits.get(best + 1).map_or(0.0, |f| f.rate - fit.rate);
    // errors of an encoder that stands still or creeps do not average out
    let creeping = floor / length;
    let rate_error = (noise * fit.rate_factor).hypot(next).max(creeping);
    Beginning { value: fit.value, rate: fit.rate, rate_error, noise }
}

struct Polynomial {
    degree: usize,
    value: f64,
    rate: f64,
    /// Standard error of the rate over that of a sample.
    rate_factor: f64,
    /// Sum of squared errors.
    squares: f64,
}

fn polynomial(t0: f64, t: &[f64], y: &[f64], degree: usize, length: f64) -> Option<Polynomial> {
    let a = DMatrix::from_fn(t.len(), degree + 1, |k, j| ((t[k] - t0) / length).powi(j as i32));
    let y = DVector::from_row_slice(y);
    let inverse = (a.transpose() * &a).try_inverse()?;
    let c = &inverse * (a.transpose() * &y);
    let squares = (&y - &a * &c).norm_squared();
    Some(Polynomial { degree, value: c[0], rate: c[1] / length, rate_factor: inverse[(1, 1)].max(0.0).sqrt() / length, squares })
}

#[cfg(test)]
mod tests {
    use super::beginning;

    #[test]
    fn an_acceleration_does_not_pass_for_a_rate() {
        let t: Vec<f64> = (0..41).map(|k| 0.005 * f64::from(k)).collect();
        let quantum = 0.0026;
        let floor = quantum / 12_f64.sqrt();
        let y: Vec<f64> = t.iter().map(|t| ((0.4 - 0.3 * t + 4.0 * t * t) / quantum).round() * quantum).collect();
        let b = beginning(0.0, &t, &y, floor);
        assert!((b.rate + 0.3).abs() < 3.0 * b.rate_error && b.rate_error < 0.1, "{} +- {}", b.rate, b.rate_error);
        // standing still: the error is what the quantum leaves open
        let b = beginning(0.0, &t, &vec![0.4; 41], floor);
        assert!(b.rate.abs() < 1e-12 && b.rate_error >= floor / 0.2 && b.rate_error < 0.01, "{}", b.rate_error);
    }
}
