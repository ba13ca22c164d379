//! From a request to an objective: checks, unknowns, pieces, scales, integration steps.

use super::data::{Data, spread};
use super::error::FitError;
use super::initial::{InitialEstimate, estimate, usual};
use super::objective::{OutputError, Piece, Unknown, UnknownKind};
use super::options::{FitOptions, InitialStates, Known, Loss, Weights};
use super::pattern::{self, Run};
use super::specification::ParameterSpec;
use crate::record::{Record, Start};
use runtime::Model;
use sim::{Forward, Pattern};

/// Everything that can be said against a request before anything is computed.
pub(crate) fn check(model: &dyn Model, specs: &[ParameterSpec], records: &[Record], options: &FitOptions) -> Result<(), FitError> {
    let d = model.dimensions();
    if records.is_empty() {
        return Err(FitError::NoRecord);
    }
    if specs.len() != d.parameters {
        return Err(sim::SimError::Length { what: "parameters", wanted: d.parameters, found: specs.len() }.into());
    }
    if !specs.iter().any(|s| s.free) {
        return Err(FitError::NothingFree);
    }
    for s in specs {
        if !(s.value.is_finite() && s.prior_mean.is_finite()) {
            return Err(FitError::NotFinite { what: format!("the value of `{}`", s.name) });
        }
        if let Some(sd) = s.prior_sd.filter(|sd| sd.is_nan() || *sd <= 0.0) {
            return Err(FitError::NotPositive { what: format!("the prior's standard deviation of `{}`", s.name), value: sd });
        }
        if let Some((lo, hi)) = s.bounds.filter(|_| s.free)
            && !(lo <= s.value && s.value <= hi)
        {
            return Err(FitError::OutsideBounds { name: s.name.clone(), value: s.value, bounds: (lo, hi) });
        }
    }
    let positive = |what: &str, value: f64| {
        if value > 0.0 && value.is_finite() { Ok(()) } else { Err(FitError::NotPositive { what: what.to_owned(), value }) }
    };
    positive("the tolerance", options.tolerance)?;
    if let Some(length) = options.shooting {
        positive("the length of a piece", length)?;
    }
    if let Some(horizon) = options.horizon {
        positive("the horizon", horizon)?;
    }
    if let Loss::Huber(k) | Loss::Cauchy(k) = options.loss {
        positive("the width of the robust loss", k)?;
    }
    if let Weights::Given(scales) = &options.weights {
        for (name, scale) in scales {
            positive(&format!("the scale of `{name}`"), *scale)?;
        }
    }
    Ok(())
}

/// How each record's initial state is treated.
fn states(data: &Data, options: &FitOptions) -> InitialStates {
    options.initial.unwrap_or_else(|| usual(data.start))
}

/// The estimate of a record's initial state.
pub(crate) fn beginning(model: &dyn Model, p: &[f64], data: &Data, options: &FitOptions) -> InitialEstimate {
    estimate(model, p, data, (0, data.times.len() - 1), data.start, states(data, options))
}

/// Most pieces of a record on which steps are tried.
const TRIED: usize = 8;

/// Runs on which the steps of a record are tried: the whole record, or some of its pieces from the states measured there.
fn runs(model: &dyn Model, p: &[f64], data: &Data, options: &FitOptions) -> Vec<Run> {
    let cuts = cuts(data, options);
    let pieces: Vec<(usize, usize)> = cuts.windows(2).map(|w| (w[0], w[1])).collect();
    let stride = pieces.len().div_ceil(TRIED).max(1);
    pieces
        .iter()
        .step_by(stride)
        .map(|&(from, to)| {
            let x0 = match from {
                0 => beginning(model, p, data, options).x,
                _ => estimate(model, p, data, (from, to), Start::Free, InitialStates { coordinates: Known::Free, rates: Known::Free }).x,
            };
            Run { from, to, x0 }
        })
        .collect()
}

/// Integration steps to begin with: the cheapest of those that the first starts ask for. Bad starting values can make a
/// run wild, and steps that follow it through are of no use; [`refine`] mends steps that were too coarse.
pub(crate) fn first_patterns(
    model: &dyn Model,
    starts: &[(String, Vec<Vec<f64>>)],
    data: &[Data],
    options: &FitOptions,
) -> Result<Vec<Pattern>, FitError> {
    let mut cheapest: Vec<Pattern> = Vec::new();
    for (_, p) in starts.iter().take(2) {
        let found = patterns(model, p, data, options)?;
        if cheapest.is_empty() {
            cheapest = found;
        } else {
            for (kept, found) in cheapest.iter_mut().zip(found).filter(|(kept, found)| pattern::cheaper(found, kept)) {
                *kept = found;
            }
        }
    }
    Ok(cheapest)
}

/// Integration steps for each record.
pub(crate) fn patterns(model: &dyn Model, p: &[Vec<f64>], data: &[Data], options: &FitOptions) -> Result<Vec<Pattern>, FitError> {
    data.iter()
        .zip(p)
        .map(|(data, p)| match options.pattern {
            Some(pattern) => Ok(pattern),
            None => {
                let runs = runs(model, p, data, options);
                // pieces that are held together are one run in the end: their errors add up
                let pieces = if options.joined { cuts(data, options).len() - 1 } else { 1 };
                let tolerance = options.tolerance / pieces as f64;
                pattern::choose(model, p, &runs, data, &pattern::allowed(model, p, data, tolerance))
            }
        })
        .collect()
}

/// Finer steps where those that were used do not do for the result.
pub(crate) fn refine(
    model: &dyn Model,
    problem: &OutputError<'_>,
    theta: &[f64],
    data: &[Data],
    used: &[Pattern],
    options: &FitOptions,
) -> Result<Option<Vec<Pattern>>, FitError> {
    if options.pattern.is_some() || options.shooting.is_some() {
        return Ok(None);
    }
    let mut finer = used.to_vec();
    let mut changed = false;
    for (r, data) in data.iter().enumerate() {
        let p = problem.parameters(theta, r);
        let Some((x0, _)) = problem.pieces.iter().position(|piece| piece.record == r).and_then(|k| problem.initial(theta, &p, k)) else {
            continue;
        };
        let allowed = pattern::allowed(model, &p, data, options.tolerance);
        let whole = [Run { from: 0, to: data.times.len() - 1, x0 }];
        if !pattern::suffices(model, &p, &whole, data, &allowed, used[r])? {
            let better = pattern::choose(model, &p, &whole, data, &allowed)?;
            // no way back to coarser steps, so that this ends
            if better.step < used[r].step || better.method != used[r].method {
                finer[r] = Pattern { step: better.step.min(used[r].step), ..better };
                changed = finer[r] != used[r];
            }
        }
    }
    Ok(changed.then_some(finer))
}

/// The objective, with scales as far as they can be known before the first run.
pub(crate) fn assemble<'a>(
    model: &'a dyn Model,
    specs: &[ParameterSpec],
    data: &'a [Data],
    patterns: &[Pattern],
    options: &FitOptions,
) -> Result<OutputError<'a>, FitError> {
    let d = model.dimensions();
    let base: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let mut unknowns = Vec::new();
    let mut parameters: Vec<usize> = Vec::new();
    // unknown of each free parameter, for each record
    let mut columns: Vec<Vec<usize>> = vec![Vec::new(); data.len()];
    for (i, s) in specs.iter().enumerate().filter(|(_, s)| s.free) {
        parameters.push(i);
        let unknown = |record| Unknown {
            kind: UnknownKind::Parameter(i),
            record,
            bounds: s.bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY)),
            prior: s.prior_sd.map(|sd| (s.prior_mean, sd)),
            size: typical(s),
        };
        for (r, columns) in columns.iter_mut().enumerate() {
            if s.per_record || r == 0 {
                unknowns.push(unknown(s.per_record.then_some(r)));
            }
            columns.push(unknowns.len() - 1);
        }
    }
    let mut pieces = Vec::new();
    for (r, data) in data.iter().enumerate() {
        let weights = first_weights(model, data, options)?;
        let cuts = cuts(data, options);
        for (k, range) in cuts.windows(2).map(|w| (w[0], w[1])).enumerate() {
            // a further piece begins anywhere: everything is free there
            let (start, how) = match k {
                0 => (data.start, states(data, options)),
                _ => (Start::Free, InitialStates { coordinates: Known::Free, rates: Known::Free }),
            };
            let InitialEstimate { x, unknowns: mut at_start, slopes } = estimate(model, &base, data, range, start, how);
            if k > 0 {
                at_start = (0..d.states())
                    .map(|state| {
                        let known = at_start.iter().find(|u| u.state == state);
                        super::initial::InitialUnknown { state, prior_sd: None, size: known.map_or(1.0, |u| u.size) }
                    })
                    .collect();
            }
            let mut local = columns[r].clone();
            for u in &at_start {
                local.push(unknowns.len());
                unknowns.push(Unknown {
                    kind: UnknownKind::State { piece: pieces.len(), state: u.state },
                    record: Some(r),
                    bounds: (f64::NEG_INFINITY, f64::INFINITY),
                    prior: u.prior_sd.map(|sd| (x[u.state], sd)),
                    size: u.size,
                });
            }
            let times = &data.times[range.0..=range.1];
            let forward = Forward::new(model, &data.signals, times, &data.outputs, &parameters, at_start.len(), patterns[r])?;
            let continued = k + 2 < cuts.len();
            let (joined, weights) = (continued && options.joined, weights.clone());
            pieces.push(Piece { data, record: r, range, forward, columns: local, x0: x, continued, joined, weights, slopes });
        }
    }
    let samples = data.iter().map(|d| d.times.len() * d.outputs.len()).sum();
    if samples < unknowns.len() {
        return Err(FitError::TooFewSamples { samples, unknowns: unknowns.len() });
    }
    // pieces are found each for itself first, and held together then
    let continuity = vec![0.0; d.states()];
    Ok(OutputError { model, base, unknowns, pieces, loss: options.loss, continuity, evaluations: 0, failure: None })
}

/// A size by which a parameter may change.
pub(crate) fn typical(s: &ParameterSpec) -> f64 {
    if s.value != 0.0 {
        return s.value.abs();
    }
    match (s.prior_sd, s.bounds) {
        (Some(sd), _) => sd,
        (None, Some((lo, hi))) if hi > lo && (hi - lo).is_finite() => 0.1 * (hi - lo),
        _ => 1.0,
    }
}

/// Samples at which pieces begin, and the last sample.
fn cuts(data: &Data, options: &FitOptions) -> Vec<usize> {
    let last = data.times.len() - 1;
    let mut cuts = vec![0];
    if let Some(length) = options.shooting {
        let mut begun = data.times[0];
        for (k, &t) in data.times.iter().enumerate() {
            // a piece has four samples at least, and none is left over that is shorter than half
            if t - begun >= length * (1.0 - 1e-9) && k - cuts[cuts.len() - 1] >= 4 && data.times[last] - t >= 0.5 * length && last - k >= 4
            {
                cuts.push(k);
                begun = t;
            }
        }
    }
    cuts.push(last);
    cuts
}

/// The signal never changes but for rounding.
fn stands_still(values: &[f64]) -> bool {
    let largest = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    spread(values) <= 1e-12 * largest
}

/// 1 / scale of each measured output.
fn first_weights(model: &dyn Model, data: &Data, options: &FitOptions) -> Result<Vec<f64>, FitError> {
    let names = model.names();
    if let Weights::Given(scales) = &options.weights {
        let measured: Vec<String> = data.outputs.iter().map(|&i| names.output(i).to_owned()).collect();
        if let Some((name, _)) = scales.iter().find(|(name, _)| !measured.contains(name)) {
            return Err(FitError::UnknownOutput { name: name.clone(), measured });
        }
        let of = |name: &String| scales.iter().find(|(n, _)| n == name).map_or(0.0, |(_, scale)| 1.0 / scale);
        return Ok(measured.iter().map(of).collect());
    }
    data.outputs
        .iter()
        .zip(&data.measured)
        .map(|(&i, values)| {
            if !stands_still(values) {
                return Ok(1.0 / spread(values));
            }
            // a signal that stands still has errors too, and an encoder knows how large they are
            let quantum = model.output_path(i, &nominal(model)).quantum;
            if options.weights == Weights::Noise && quantum > 0.0 {
                return Ok(1.0 / quantum);
            }
            Err(FitError::Constantly { file: data.source.clone(), output: names.output(i).to_owned() })
        })
        .collect()
}

fn nominal(model: &dyn Model) -> Vec<f64> {
    let mut p = vec![0.0; model.dimensions().parameters];
    model.nominal(&mut p);
    p
}

/// Largest spread of a measured signal, by which jumps between pieces are judged.
pub(crate) fn largest_spread(problem: &OutputError<'_>) -> f64 {
    problem.pieces.iter().flat_map(|p| &p.data.measured).map(|v| spread(v)).fold(0.0, f64::max).max(1e-12)
}

/// Unknowns from parameters for each record, initial states as estimated.
pub(crate) fn start(problem: &OutputError<'_>, p: &[Vec<f64>]) -> Vec<f64> {
    problem
        .unknowns
        .iter()
        .map(|u| match u.kind {
            UnknownKind::Parameter(i) => p[u.record.unwrap_or(0)][i].max(u.bounds.0).min(u.bounds.1),
            UnknownKind::State { piece, state } => problem.pieces[piece].x0[state],
        })
        .collect()
}

/// Scales from the errors at `theta`, one for each output over all records: rms, or for robust losses the median of the
/// sizes over that of a normal distribution. Returns the largest relative change; `None` where the run fails.
pub(crate) fn reweight(problem: &mut OutputError<'_>, theta: &[f64], options: &FitOptions) -> Option<f64> {
    let errors = problem.errors(theta)?;
    let mut change = 0.0_f64;
    for output in 0..problem.model.dimensions().outputs {
        let mut all: Vec<f64> = Vec::new();
        for (r, record) in errors.iter().enumerate() {
            let Some(piece) = problem.pieces.iter().find(|p| p.record == r) else { continue };
            if let Some(i) = piece.data.outputs.iter().position(|&o| o == output) {
                all.extend(&record[i]);
            }
        }
        if all.is_empty() {
            continue;
        }
        let quantum = problem.model.output_path(output, &problem.base).quantum;
        let scale = match options.loss {
            Loss::Squares => (all.iter().map(|e| e * e).sum::<f64>() / all.len() as f64).sqrt(),
            _ => {
                all.iter_mut().for_each(|e| *e = e.abs());
                all.sort_by(f64::total_cmp);
                all[all.len() / 2] / 0.674_489_75
            }
        };
        for piece in &mut problem.pieces {
            if let Some(i) = piece.data.outputs.iter().position(|&o| o == output) {
                // errors below rounding of the signal are no noise; one that stands still is known to within its encoder's steps
                let values = &piece.data.measured[i];
                let floor = if stands_still(values) { quantum / 12_f64.sqrt() } else { 1e-9 * spread(values) };
                let weight = 1.0 / scale.max(floor).max(f64::MIN_POSITIVE.sqrt());
                change = change.max((weight / piece.weights[i] - 1.0).abs());
                piece.weights[i] = weight;
            }
        }
    }
    Some(change)
}
