//! Prediction over a short horizon from many starts along a record: the figure for rigs whose free run says nothing,
//! because their own sensitivities carry any error of the initial state away.

use super::initial::{Held, state_from};
use super::series::{fit_percent, rmse, smoothed};
use super::{CompareOptions, is_angle};
use runtime::Model;
use sim::{Signals, SimError, Status, simulate};
use std::f64::consts::PI;

/// Figures of a prediction over `horizon` seconds.
#[derive(Clone, Debug)]
pub struct Prediction {
    /// Seconds ahead.
    pub horizon: f64,
    /// Starts along the record.
    pub starts: usize,
    /// Starts from which the model's run ended early; they are left out of the figures.
    pub failed: usize,
    /// One entry for each measured output; for angles that turn by more than half a turn their rate too (`psi.dot`).
    pub signals: Vec<PredictionFit>,
}

/// How well one output is predicted.
#[derive(Clone, Debug)]
pub struct PredictionFit {
    /// Name of the output, or `NAME.dot`.
    pub name: String,
    /// 100 (1 - |y - yhat| / |y - mean y|) over all starts; `None` where the signal is constant.
    pub fit_percent: Option<f64>,
    /// Root-mean-square error (SI).
    pub rmse: Option<f64>,
    /// Fit of holding the rates of the start constant.
    pub hold: Option<f64>,
}

/// Half of the window from which a state is smoothed [s].
pub(super) const WINDOW: f64 = 0.1;

/// 1, 2 or 5 times a power of ten, not above x.
pub(super) fn round_down(x: f64) -> f64 {
    let power = 10.0_f64.powf(x.log10().floor());
    let digit = [5.0, 2.0, 1.0].into_iter().find(|d| d * power <= x * (1.0 + 1e-12)).unwrap_or(1.0);
    digit * power
}

/// Predicts `horizon` seconds ahead. `outputs[i]` are the measured values of output i at `t`, angles unwrapped.
pub(super) fn predict(
    model: &dyn Model,
    p: &[f64],
    t: &[f64],
    outputs: &[Option<Vec<f64>>],
    signals: &Signals,
    horizon: f64,
    options: &CompareOptions,
) -> Result<Prediction, SimError> {
    let d = model.dimensions();
    let measured: Vec<(usize, &Vec<f64>)> = outputs.iter().enumerate().filter_map(|(i, y)| Some((i, y.as_ref()?))).collect();
    // a window that does not reach beyond half of the horizon
    let reach = WINDOW.min(0.5 * horizon);
    let smoothed = |k: usize| smoothed(t, outputs, k, reach);
    let target = |k: usize| t.partition_point(|&s| s < t[k] + horizon * (1.0 - 1e-9));
    // the ends of the record, where the window has one side only, are left out where the record is long enough
    let inside = |k: usize| t[k] - t[0] >= reach && t[t.len() - 1] - t[target(k)] >= reach;
    let mut range: Vec<usize> = (0..t.len()).take_while(|&k| target(k) < t.len()).collect();
    if range.iter().any(|&k| inside(k)) {
        range.retain(|&k| inside(k));
    }
    let stride = range.len().div_ceil(options.starts.max(1)).max(1);
    let mut held = Held::new(model, p);
    // y, its prediction, its value by holding the rate; the same for the rate
    let mut rows: Vec<[Vec<f64>; 6]> = measured.iter().map(|_| Default::default()).collect();
    let (mut starts, mut failed) = (0, 0);
    let (mut dx, mut c, mut dhdp) = (vec![0.0; d.states()], vec![0.0; d.outputs * d.states()], vec![0.0; d.outputs * d.parameters]);
    for (count, &k) in range.iter().enumerate() {
        let is_start = count % stride == 0;
        if !is_start && d.lags == 0 {
            continue;
        }
        let lines = smoothed(k);
        let u = signals.at(t[k]);
        let mut x = state_from(model, p, t[k], &lines, &u);
        // actuator states go with the inputs from sample to sample
        held.follow(t[k], &u, &mut x);
        if !is_start {
            continue;
        }
        starts += 1;
        let j = target(k);
        let run = simulate(model, p, &x, signals, &[t[k], t[j]], &options.simulation)?;
        if run.status != Status::Completed || model.rhs(t[j], run.state(1), &signals.at(t[j]), p, &mut dx).is_err() {
            failed += 1;
            continue;
        }
        model.output_jacobian(t[j], run.state(1), p, &mut c, &mut dhdp);
        let later = smoothed(j);
        for (r, (i, y)) in measured.iter().enumerate() {
            let rate: f64 = c[i * d.states()..(i + 1) * d.states()].iter().zip(&dx).map(|(c, dx)| c * dx).sum();
            let now = lines[r].1;
            let row = [y[j], run.outputs(1)[*i], now.value + now.rate * (t[j] - t[k]), later[r].1.rate, rate, now.rate];
            rows[r].iter_mut().zip(row).for_each(|(column, value)| column.push(value));
        }
    }
    let mut figures = Vec::new();
    for ((i, y), [value, predicted, held, rate, predicted_rate, held_rate]) in measured.iter().zip(&rows) {
        let name = model.names().output(*i);
        figures.push(PredictionFit {
            name: name.to_owned(),
            fit_percent: fit_percent(value, predicted),
            rmse: rmse(value, predicted),
            hold: fit_percent(value, held),
        });
        let (low, high) = y.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &y| (lo.min(y), hi.max(y)));
        if is_angle(model.names().output_unit(*i)) && high - low > PI {
            figures.push(PredictionFit {
                name: format!("{name}.dot"),
                fit_percent: fit_percent(rate, predicted_rate),
                rmse: rmse(rate, predicted_rate),
                hold: fit_percent(rate, held_rate),
            });
        }
    }
    Ok(Prediction { horizon, starts, failed, signals: figures })
}

#[cfg(test)]
mod tests {
    use super::round_down;

    #[test]
    fn round_figures() {
        assert_eq!([0.37, 0.2, 0.0999, 7.0, 1.0].map(round_down), [0.2, 0.2, 0.05, 5.0, 1.0]);
    }
}
