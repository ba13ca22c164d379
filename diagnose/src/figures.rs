//! How a model follows records: free runs, or predictions where free runs say nothing; and how far a gap shrank.

use crate::answer::{Figure, Figures};
use ident::compare::{CompareOptions, compare};
use ident::innovations::{Noise, Track, wander};
use ident::record::{Record, averaged};
use runtime::Model;
use sim::Hold;

/// How runs are compared with records.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// What logged inputs do between samples.
    pub hold: Hold,
    /// Predict so many seconds ahead instead of running freely [s].
    pub horizon: Option<f64>,
}

/// Most seconds ahead where a free run says nothing.
pub const AHEAD: f64 = 1.0;
/// A free run that follows a signal less than this says nothing of what is missing [percent].
const FOLLOWS: f64 = 60.0;

/// Starts of predictions along a record: windows overlap, so that more say little.
const STARTS: usize = 150;
/// Samples of a record that is predicted.
const SAMPLES: usize = 1500;

/// Outputs that are read modulo one turn.
fn wrapped(model: &dyn Model, p: &[f64]) -> Vec<String> {
    let wraps = |i: &usize| model.output_path(*i, p).wrapped;
    (0..model.dimensions().outputs).filter(wraps).map(|i| model.names().output(i).to_owned()).collect()
}

/// Free runs, unless an axis integrates or the refitted base drifts off: then predictions `ahead` [s].
#[must_use]
pub fn view(free: &Figures, integrates: bool, ahead: f64, hold: Hold) -> View {
    let lost = free.train.iter().chain(&free.test).any(|f| f.horizon.is_none() && f.fit_percent.is_some_and(|p| p < FOLLOWS));
    View { hold, horizon: (lost || integrates).then_some(ahead) }
}

/// Figures of a model with parameters of its training records, and `p` for the test records.
#[must_use]
pub fn figures(model: &dyn Model, p_train: &[Vec<f64>], p: &[f64], train: &[Record], test: &[Record], view: View) -> Figures {
    let of = |record: &Record, p: &[f64]| -> Vec<Figure> {
        let count = record.t.len().div_ceil(SAMPLES);
        let inputs: Vec<String> = (0..model.dimensions().inputs).map(|i| model.names().signal(i).to_owned()).collect();
        let held = if view.hold == Hold::Zero { inputs } else { Vec::new() };
        let fewer = view.horizon.filter(|_| count > 1).map(|_| averaged(record, count, &wrapped(model, p), &held));
        let hold = if fewer.is_some() { Hold::First } else { view.hold };
        let simulation = sim::Options { relative: 1e-7, absolute: 1e-9, ..sim::Options::default() };
        let options = CompareOptions { hold, horizon: view.horizon, simulation, starts: STARTS, ..CompareOptions::default() };
        let Ok(found) = compare(model, p, fewer.as_ref().unwrap_or(record), &options) else { return Vec::new() };
        let horizon = found.horizon();
        found
            .figures()
            .into_iter()
            .map(|f| Figure { record: record.source.clone(), signal: f.name, fit_percent: f.fit_percent, rmse: f.rmse, horizon })
            .collect()
    };
    Figures {
        train: train.iter().zip(p_train).flat_map(|(record, p)| of(record, p)).collect(),
        test: test.iter().flat_map(|record| of(record, p)).collect(),
    }
}

/// Squared errors below this multiple of the floor are no gap: those of a single run scatter about it by a third and more.
const NONE: f64 = 2.0;

/// 1 - (after^2 - floor^2)/(before^2 - floor^2) of each signal over all test records. The floor is the noise of its sensor and
/// what the random forces of the last model do to such a run: no model can be nearer. Signals whose gap is no larger are left out.
#[must_use]
pub fn shrink(model: &dyn Model, p: &[f64], noise: &Noise, held: &[Track], before: &Figures, after: &Figures) -> Vec<(String, f64)> {
    let names = model.names();
    let mut signals: Vec<&str> = before.test.iter().map(|f| f.signal.as_str()).collect();
    signals.sort_unstable();
    signals.dedup();
    let horizon = before.test.iter().find_map(|f| f.horizon);
    let mut wandering = vec![0.0; model.dimensions().outputs];
    for track in held {
        if let Ok(Some(each)) = wander(model, p, track, noise, horizon) {
            wandering.iter_mut().zip(&each).for_each(|(w, e)| *w += e / held.len() as f64);
        }
    }
    let floor = |signal: &str| {
        let output = (0..model.dimensions().outputs).find(|&i| names.output(i) == signal);
        output.map_or(0.0, |i| noise.output_sd[i].powi(2).max(model.output_path(i, p).quantum.powi(2) / 12.0) + wandering[i])
    };
    signals
        .into_iter()
        .filter_map(|signal| {
            let square = |figures: &Figures| -> Option<f64> {
                let own: Vec<f64> = figures.test.iter().filter(|f| f.signal == signal).map(|f| f.rmse).collect::<Option<_>>()?;
                Some(own.iter().map(|e| e * e).sum::<f64>() / own.len().max(1) as f64)
            };
            let (b, a, f) = (square(before)?, square(after)?, floor(signal));
            (b > NONE * f).then(|| (signal.to_owned(), 1.0 - (a - f).max(0.0) / (b - f)))
        })
        .collect()
}
