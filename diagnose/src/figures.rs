//! How a model follows records: free runs, or predictions where free runs say nothing; and how far a gap shrank.

use crate::answer::{Figure, Figures};
use crate::model::Prepared;
use ident::compare::{CompareOptions, compare, fit_percent};
use ident::innovations::{Ahead, Noise, Track, ahead, wander};
use ident::record::{Blocks, Record};
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

/// Free runs, unless an axis integrates or the refitted base drifts off: then predictions `ahead` [s].
#[must_use]
pub fn view(free: &Figures, integrates: bool, ahead: f64, hold: Hold) -> View {
    let lost = free.train.iter().chain(&free.test).any(|f| f.horizon.is_none() && f.fit_percent.is_some_and(|p| p < FOLLOWS));
    View { hold, horizon: (lost || integrates).then_some(ahead) }
}

/// Records as they were read, and bound to a model.
#[derive(Clone, Copy)]
pub struct Measured<'a> {
    /// As they were read.
    pub records: &'a [Record],
    /// Bound.
    pub tracks: &'a [Track],
}

/// A model with parameters and noise.
#[derive(Clone, Copy)]
pub struct Judged<'a> {
    /// Model.
    pub prepared: &'a Prepared,
    /// Its noise.
    pub noise: &'a Noise,
    /// Parameters for training records.
    pub p_train: &'a [Vec<f64>],
    /// Parameters for test records.
    pub p_test: &'a [Vec<f64>],
}

/// How a model follows training and test records.
#[must_use]
pub fn figures(judged: Judged<'_>, train: Option<Measured<'_>>, test: Measured<'_>, view: View) -> Figures {
    let of = |measured: Measured<'_>, k: usize, p: &[f64]| match view.horizon {
        None => compared(&judged.prepared.model, p, &measured.records[k], view),
        Some(h) => predicted(judged, p, &measured.tracks[k], h),
    };
    let trained = train.iter().flat_map(|m| (0..m.records.len()).flat_map(|k| of(*m, k, &judged.p_train[k]))).collect();
    Figures { train: trained, test: (0..test.records.len()).flat_map(|k| of(test, k, &judged.p_test[k])).collect() }
}

/// A free run, or predictions from states that are smoothed without the model.
#[must_use]
pub fn compared(model: &dyn Model, p: &[f64], record: &Record, view: View) -> Vec<Figure> {
    let count = record.t.len().div_ceil(SAMPLES);
    let blocks = Blocks::of(model, p, view.hold);
    let count = view.horizon.map_or(1, |_| count);
    let (fewer, hold) = (blocks.averaged(record, count), blocks.hold(count));
    let simulation = sim::Options { relative: 1e-7, absolute: 1e-9, ..sim::Options::default() };
    let options = CompareOptions { hold, horizon: view.horizon, simulation, starts: STARTS, ..CompareOptions::default() };
    let Ok(found) = compare(model, p, &fewer, &options) else { return Vec::new() };
    let horizon = found.horizon();
    let of = |f: ident::compare::Figure| Figure {
        record: record.source.clone(),
        signal: f.name,
        fit_percent: f.fit_percent,
        rmse: f.rmse,
        horizon,
        floor: None,
    };
    found.figures().into_iter().map(of).collect()
}

/// Predictions of test records from the states that the model's own filter has; none where one cannot be followed.
#[must_use]
pub fn predictions(judged: Judged<'_>, held: &[Track], horizon: f64) -> Vec<Vec<Ahead>> {
    held.iter().zip(judged.p_test).map(|(track, p)| prediction(judged, p, track, horizon)).collect()
}

fn prediction(judged: Judged<'_>, p: &[f64], track: &Track, horizon: f64) -> Vec<Ahead> {
    let noise = judged.prepared.noise(judged.noise);
    ahead(&judged.prepared.model, p, track, &noise, horizon, STARTS).ok().flatten().unwrap_or_default()
}

fn predicted(judged: Judged<'_>, p: &[f64], track: &Track, horizon: f64) -> Vec<Figure> {
    let rms = |values: &[f64]| (!values.is_empty()).then(|| (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt());
    let of = |found: Ahead| {
        let known: Vec<usize> = (0..found.t.len()).filter(|&k| found.error[k].is_finite()).collect();
        let pick = |values: &[f64]| known.iter().map(|&k| values[k]).collect::<Vec<f64>>();
        let (measured, error, floor) = (pick(&found.measured), pick(&found.error), pick(&found.floor));
        let simulated: Vec<f64> = measured.iter().zip(&error).map(|(y, e)| y - e).collect();
        Figure {
            record: track.source().to_owned(),
            signal: judged.prepared.model.names().output(found.output).to_owned(),
            fit_percent: fit_percent(&measured, &simulated),
            rmse: rms(&error),
            horizon: Some(horizon),
            floor: rms(&floor),
        }
    };
    prediction(judged, p, track, horizon).into_iter().map(of).collect()
}

/// Squared errors below this multiple of the floor are no gap: those of a single run scatter about it by a third and more.
pub const NONE: f64 = 2.0;

/// 1 - (after^2 - floor^2)/(before^2 - floor^2) of each signal over all test records. The floor is the noise of its sensor and
/// what the random forces of the last model do to such a run: no model can be nearer. Signals whose gap is no larger are left out.
#[must_use]
pub fn shrink(judged: Judged<'_>, held: &[Track], before: &Figures, after: &Figures) -> Vec<(String, f64)> {
    let model: &dyn Model = &judged.prepared.model;
    let names = model.names();
    let mut signals: Vec<&str> = before.test.iter().map(|f| f.signal.as_str()).collect();
    signals.sort_unstable();
    signals.dedup();
    let noise = judged.prepared.noise(judged.noise);
    let mut wandering = vec![0.0; model.dimensions().outputs];
    for (track, p) in held.iter().zip(judged.p_test).filter(|_| before.test.iter().any(|f| f.horizon.is_none())) {
        if let Ok(Some(each)) = wander(model, p, track, &noise) {
            wandering.iter_mut().zip(&each).for_each(|(w, e)| *w += e / held.len() as f64);
        }
    }
    let mean_square = |figures: &Figures, signal: &str, of: fn(&Figure) -> Option<f64>| -> Option<f64> {
        let own: Vec<f64> = figures.test.iter().filter(|f| f.signal == signal).map(of).collect::<Option<_>>()?;
        Some(own.iter().map(|e| e * e).sum::<f64>() / own.len().max(1) as f64)
    };
    let floor = |signal: &str| {
        mean_square(after, signal, |f| f.floor).unwrap_or_else(|| {
            let output = (0..model.dimensions().outputs).find(|&i| names.output(i) == signal);
            output.map_or(0.0, |i| {
                noise.output_sd[i].powi(2).max(judged.p_test.first().map_or(0.0, |p| model.output_path(i, p).quantum.powi(2) / 12.0))
                    + wandering[i]
            })
        })
    };
    signals
        .into_iter()
        .filter_map(|signal| {
            let (b, a) = (mean_square(before, signal, |f| f.rmse)?, mean_square(after, signal, |f| f.rmse)?);
            let f = floor(signal);
            (b > NONE * f).then(|| (signal.to_owned(), 1.0 - (a - f).max(0.0) / (b - f)))
        })
        .collect()
}
