//! Grey-box identification: parameters of a model, fitted to measured records.
//!
//! The problem. A model x' = f(t, x, u, p), y = h(x, p) and records of inputs and outputs; unknown are some of the
//! parameters and the initial state of each record. Minimized is
//!
//! ```text
//! 1/2 sum over records, outputs, samples  rho((h - y) / scale)
//!   + 1/2 sum over priors  ((unknown - mean) / sd)^2      within the bounds,
//! ```
//!
//! the *output error*: the model runs freely over the record, with derivatives integrated along exactly. The way there: start
//! at the nominal values or at those of equation error ([`Starting`]), where needed in pieces (multiple shooting), then
//! Levenberg-Marquardt ([`minimize`]). The answer ([`Fit`]) has intervals that hold for coloured errors too, and says which
//! parameters the records cannot tell.
//!
//! Knows models through [`runtime::Model`] only, of the rig language only what it says of parameters.

mod answer;
mod build;
mod bumps;
mod channels;
pub(crate) mod covariance;
pub(crate) mod data;
mod equation_error;
mod error;
mod filter;
mod identifiability;
pub(crate) mod initial;
pub mod minimize;
pub(crate) mod objective;
mod options;
mod pattern;
mod rates_by;
mod report;
mod specification;
mod whiteness;

pub use answer::{Estimate, Fit, InitialValue, RecordFigures, SignalFigure};
pub use channels::channel_by_channel;
pub use equation_error::{EquationErrorFit, Preparation, equation_error};
pub(crate) use equation_error::{coordinates as measured_coordinates, unexplained};
pub use error::FitError;
pub(crate) use filter::rates;
pub(crate) use identifiability::identifiable;
pub use identifiability::{Identifiable, TradeOff};
pub use minimize::{Ending, LevenbergMarquardt, Limits, Minimizer};
pub use options::{FitOptions, InitialStates, Known, Loss, Starting, Weights};
pub use rates_by::RatesBy;
pub use report::figures;
pub(crate) use report::{followed_from, judge};
pub use specification::{ParameterSpec, select};
pub use whiteness::Whiteness;
pub(crate) use whiteness::whiteness;

use crate::record::Record;
use build::assemble;
pub(crate) use build::{check, typical};
pub(crate) use data::Data;
use minimize::{Minimum, Objective};
use objective::OutputError;
use runtime::Model;
use std::time::Instant;

/// Rounds of estimating scales and parameters in turn.
const ROUNDS: usize = 20;

/// Fits the free parameters of `specs` to `records`, and judges the result on `tests` too.
///
/// # Errors
/// [`FitError`], one variant a cause. A search that ends without a minimum is none, see [`Fit::ending`].
pub fn identify(
    model: &dyn Model,
    specs: &[ParameterSpec],
    records: &[Record],
    tests: &[Record],
    options: &FitOptions,
) -> Result<Fit, FitError> {
    let began = Instant::now();
    check(model, specs, records, options)?;
    let data = records.iter().map(|r| Data::new(r, model, options.hold)).collect::<Result<Vec<_>, _>>()?;
    let nominal: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let mut starts = starts(model, specs, &data, nominal, options)?;
    let (mut evaluations, mut search_seconds) = (0, 0.0);
    let mut patterns = build::first_patterns(model, &starts, &data, options)?;
    let mut solved;
    let mut problem;
    let mut started_from;
    loop {
        problem = assemble(model, specs, &data, &patterns, options)?;
        let again = || short_runs(model, specs, &data, &starts, options);
        let searching = Instant::now();
        (solved, started_from) = search(&mut problem, &starts, &again, options)?;
        search_seconds += searching.elapsed().as_secs_f64();
        evaluations += problem.evaluations;
        // the steps were chosen for the start; they must do for the result too
        let finer = build::refine(model, &problem, &solved.x, &data, &patterns, options)?;
        match finer {
            Some(finer) => {
                patterns = finer;
                let p = (0..data.len()).map(|r| problem.parameters(&solved.x, r)).collect();
                starts = vec![(started_from, p)];
            }
            None => break,
        }
    }
    let mut fit = report::answer(model, specs, &data, &mut problem, &solved, options)?;
    report::judge(model, specs, &mut fit, (records, tests), options)?;
    fit.started_from = started_from;
    fit.patterns = patterns;
    fit.evaluations = evaluations;
    fit.search_seconds = search_seconds;
    fit.seconds = began.elapsed().as_secs_f64();
    Ok(fit)
}

/// Name of the start from the values of the specification.
const NOMINAL: &str = "nominal";

/// Samples of the bumps of the weak form that are tried for starting values.
const WINDOWS: [usize; 4] = [16, 40, 100, 250];

/// Starting values: where they come from, and the parameters of every record.
type Starts = (String, Vec<Vec<f64>>);

/// All starting values that are tried.
fn starts(
    model: &dyn Model,
    specs: &[ParameterSpec],
    data: &[Data],
    nominal: Vec<f64>,
    options: &FitOptions,
) -> Result<Vec<Starts>, FitError> {
    let mut starts = Vec::new();
    if options.starting != Starting::EquationError {
        starts.push((NOMINAL.to_owned(), vec![nominal; data.len()]));
    }
    if options.starting != Starting::Nominal {
        let shortest = data.iter().map(|d| d.times.len()).min().unwrap_or(0);
        for window in WINDOWS.into_iter().filter(|w| 4 * w <= shortest) {
            match equation_error::fit(model, specs, data, Preparation::WeakForm { window }) {
                Ok(found) => starts.push((format!("equation error, windows of {window} samples"), found.p_of_record)),
                Err(e) if options.starting == Starting::EquationError => return Err(e),
                // not every coordinate is measured: the nominal values have to do
                Err(_) => break,
            }
        }
        if starts.is_empty() {
            return Err(FitError::EquationError { why: format!("{shortest} samples are too few for it") });
        }
    }
    Ok(starts)
}

/// Errors over the spread of the signals (root mean square) above which a minimum is not taken for the only one.
const POOR: f64 = 0.3;

/// From the best start to the minimum; where scales are estimated, in turn with them. The cost at a start says little of
/// where it leads if runs from there are wild: where the search ends badly, the best start of the other kind is tried too, and then
/// the parameters of short runs.
fn search(
    problem: &mut OutputError<'_>,
    starts: &[Starts],
    last_resort: &dyn Fn() -> Option<Starts>,
    options: &FitOptions,
) -> Result<(Minimum, String), FitError> {
    let mut at: Vec<(f64, usize, Vec<f64>)> = Vec::new();
    for (k, (_, p)) in starts.iter().enumerate() {
        let theta = build::start(problem, p);
        // a single start needs no rank
        let cost = if starts.len() == 1 { Some(0.0) } else { problem.evaluate(&theta).map(|found| found.cost) };
        at.extend(cost.map(|cost| (cost, k, theta)));
    }
    at.sort_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, best, _)) = at.first() else { return Err(no_start(problem)) };
    let nominal = |k: usize| starts[k].0 == NOMINAL;
    let other = at.iter().find(|(_, k, _)| nominal(*k) != nominal(*best));
    let samples: usize = problem.pieces.iter().map(|p| (p.range.1 - p.range.0) * p.data.outputs.len()).sum();
    // while scales still move there is no point in a sharp minimum
    let coarse = Limits { cost: options.limits.cost.max(1e-5), ..options.limits };
    let noise = options.weights == Weights::Noise;
    let limits = if noise { &coarse } else { &options.limits };
    let (mut from, mut found): (String, Option<Minimum>) = (starts[*best].0.clone(), None);
    let poor = |m: &Minimum| {
        let relative = !matches!(options.weights, Weights::Given(_));
        !m.ending.converged() || relative && (2.0 * m.cost() / samples.max(1) as f64).sqrt() > POOR
    };
    for (_, start, theta) in at.first().into_iter().chain(other) {
        if found.as_ref().is_some_and(|m| !poor(m)) {
            break;
        }
        let again = LevenbergMarquardt.minimize(problem, theta, limits);
        if found.as_ref().is_none_or(|m| again.cost() < m.cost()) {
            (from, found) = (starts[*start].0.clone(), Some(again));
        }
    }
    if found.as_ref().is_none_or(poor)
        && let Some((name, p)) = last_resort()
    {
        let theta = build::start(problem, &p);
        let again = LevenbergMarquardt.minimize(problem, &theta, limits);
        if found.as_ref().is_none_or(|m| again.cost() < m.cost()) {
            (from, found) = (name, Some(again));
        }
    }
    let Some(mut found) = found else { return Err(FitError::NoRecord) };
    if found.ending == Ending::NoStart {
        return Err(no_start(problem));
    }
    if problem.pieces.iter().any(|p| p.joined) {
        found = tightened(problem, found, &coarse, options);
    }
    if noise {
        for _ in 0..ROUNDS {
            let Some(change) = build::reweight(problem, &found.x, options) else { break };
            let settled = change < 1e-3;
            found = LevenbergMarquardt.minimize(problem, &found.x, if settled { &options.limits } else { &coarse });
            if settled && change < 1e-4 {
                break;
            }
        }
        // the last search must have been a sharp one
        found = LevenbergMarquardt.minimize(problem, &found.x, &options.limits);
    }
    Ok((found, from))
}

/// The model cannot be run from any start.
fn no_start(problem: &OutputError<'_>) -> FitError {
    let (record, status) = problem.failed();
    let file = problem.pieces.iter().find(|p| p.record == record).map_or_else(String::new, |p| p.data.source.clone());
    FitError::NoStart { file, status }
}

/// Standard deviations of jumps between pieces, in parts of the signals' spread, one after the other.
const JUMPS: [f64; 7] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

/// Multiple shooting: pieces that were free of each other are held together more and more, and are one run in the end. (Held together
/// tightly from the beginning, a search that starts far away creeps.)
fn tightened(problem: &mut OutputError<'_>, from: Minimum, limits: &Limits, options: &FitOptions) -> Minimum {
    let size = build::largest_spread(problem);
    let mut found = from;
    for jump in JUMPS {
        if options.weights == Weights::Noise {
            build::reweight(problem, &found.x, options);
        }
        problem.continuity.fill(1.0 / (jump * size));
        let again = LevenbergMarquardt.minimize(problem, &found.x, limits);
        if again.at.is_none() {
            break;
        }
        found = again;
    }
    found
}

/// Runs into which a record is cut for starting values.
const SHORT_RUNS: f64 = 15.0;

/// Parameters from short runs, each from a state of its own: no run is long enough to go wild. `None` where that fails, or
/// where the fit is made in pieces anyway.
fn short_runs(model: &dyn Model, specs: &[ParameterSpec], data: &[Data], starts: &[Starts], options: &FitOptions) -> Option<Starts> {
    if options.shooting.is_some() {
        return None;
    }
    let shortest = data.iter().map(|d| d.times[d.times.len() - 1] - d.times[0]).fold(f64::INFINITY, f64::min);
    let options = FitOptions { shooting: Some(shortest / SHORT_RUNS), joined: false, ..options.clone() };
    let patterns = build::first_patterns(model, starts, data, &options).ok()?;
    let mut problem = assemble(model, specs, data, &patterns, &options).ok()?;
    let mut best: Option<(f64, Vec<f64>)> = None;
    for (_, p) in starts {
        let theta = build::start(&problem, p);
        if let Some(at) = problem.evaluate(&theta)
            && best.as_ref().is_none_or(|(cost, _)| at.cost < *cost)
        {
            best = Some((at.cost, theta));
        }
    }
    let limits = Limits { cost: options.limits.cost.max(1e-5), ..options.limits };
    let found = LevenbergMarquardt.minimize(&mut problem, &best?.1, &limits);
    found.at.as_ref()?;
    Some(("short runs".to_owned(), (0..data.len()).map(|r| problem.parameters(&found.x, r)).collect()))
}
