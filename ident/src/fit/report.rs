//! From the minimum to the answer.

use super::answer::{Estimate, Fit, InitialValue, RecordFigures, SignalFigure};
use super::build::typical;
use super::covariance::{self, Covariance};
use super::data::Data;
use super::error::FitError;
use super::identifiability::identifiable;
use super::minimize::{Evaluation, Minimum};
use super::objective::{OutputError, Piece, UnknownKind};
use super::options::{FitOptions, Loss, Weights};
use super::specification::ParameterSpec;
use super::whiteness::whiteness;
use crate::compare::{CompareError, CompareOptions, compare, fit_percent, rmse};
use crate::record::Record;
use nalgebra::DMatrix;
use runtime::Model;
use sim::{Forward, Hold, Status};

/// Lags of the whiteness test.
const LAGS: usize = 20;

/// Everything but tests, steps and effort.
pub(crate) fn answer(
    model: &dyn Model,
    specs: &[ParameterSpec],
    data: &[Data],
    problem: &mut OutputError<'_>,
    found: &Minimum,
    options: &FitOptions,
) -> Result<Fit, FitError> {
    let theta = &found.x;
    let (Some(at), Some(rows)) = (found.at.clone(), problem.rows(theta)) else {
        let (record, status) = problem.failed();
        return Err(FitError::NoStart { file: data[record].source.clone(), status });
    };
    let n = theta.len();
    let held: Vec<bool> = (0..n)
        .map(|i| {
            let (lo, hi) = problem.unknowns[i].bounds;
            theta[i] <= lo || theta[i] >= hi
        })
        .collect();
    let cov = covariance::covariance(&rows, &at.normal, &held);

    let wanted: Vec<usize> = (0..n).filter(|&i| matches!(problem.unknowns[i].kind, UnknownKind::Parameter(_))).collect();
    let parameters = wanted.iter().map(|&i| estimate(model, specs, data, problem, theta, &cov, &held, i)).collect();
    let covariance = DMatrix::from_fn(wanted.len(), wanted.len(), |a, b| cov.matrix[(wanted[a], wanted[b])]);
    let correlation = DMatrix::from_fn(wanted.len(), wanted.len(), |a, b| {
        let size = (covariance[(a, a)] * covariance[(b, b)]).sqrt();
        if size > 0.0 { covariance[(a, b)] / size } else { 0.0 }
    });
    let mut p = problem.parameters(theta, 0);
    for (value, spec) in p.iter_mut().zip(specs).filter(|(_, s)| s.per_record) {
        *value = spec.value;
    }
    let p_of_record: Vec<Vec<f64>> = (0..data.len()).map(|r| problem.parameters(theta, r)).collect();
    let scales = data
        .iter()
        .enumerate()
        .map(|(r, data)| {
            let weights = problem.pieces.iter().find(|p| p.record == r).map_or(&[][..], |p| &p.weights);
            let named = data.outputs.iter().zip(weights).filter(|(_, w)| **w > 0.0);
            named.map(|(&i, w)| (model.names().output(i).to_owned(), 1.0 / w)).collect()
        })
        .collect();
    let mut white = Vec::new();
    for (r, data) in data.iter().enumerate() {
        for (i, &output) in data.outputs.iter().enumerate() {
            let errors: Vec<f64> = rows
                .iter()
                .filter(|rows| rows.record == r)
                .flat_map(|rows| rows.errors.iter().skip(i).step_by(rows.outputs).copied())
                .collect();
            white.extend(whiteness(&data.source, model.names().output(output), &errors, LAGS));
        }
    }
    Ok(Fit {
        parameters,
        p,
        correlation,
        covariance,
        initial_states: initial_states(model, data, problem, theta),
        objective: describe(options),
        cost: at.cost,
        scales,
        ending: found.ending,
        intervals: format!("{}; errors hang together over {:.0} samples", covariance::SOURCE, cov.memory.max(1.0)),
        memory: cov.memory,
        identifiable: told(specs, data, problem, theta, &at, &cov, &wanted),
        whiteness: white,
        train: train(model, data, problem, theta, &p_of_record)?,
        p_of_record,
        test: Vec::new(),
        before: Vec::new(),
        before_test: Vec::new(),
        started_from: String::new(),
        patterns: Vec::new(),
        evaluations: 0,
        seconds: 0.0,
        search_seconds: 0.0,
    })
}

#[allow(clippy::too_many_arguments)]
fn estimate(
    model: &dyn Model,
    specs: &[ParameterSpec],
    data: &[Data],
    problem: &OutputError<'_>,
    theta: &[f64],
    cov: &Covariance,
    held: &[bool],
    i: usize,
) -> Estimate {
    let unknown = &problem.unknowns[i];
    let index = match unknown.kind {
        UnknownKind::Parameter(index) => index,
        UnknownKind::State { state, .. } => state,
    };
    let std_error = cov.told[i].then(|| cov.matrix[(i, i)].max(0.0).sqrt());
    Estimate {
        name: specs[index].name.clone(),
        record: unknown.record.map(|r| data[r].source.clone()),
        unit: model.names().parameter_unit(index).to_owned(),
        value: theta[i],
        std_error,
        ci95: std_error.map(|s| (theta[i] - cov.factor * s, theta[i] + cov.factor * s)),
        initial: specs[index].value,
        at_bound: held[i],
    }
}

fn initial_states(model: &dyn Model, data: &[Data], problem: &OutputError<'_>, theta: &[f64]) -> Vec<InitialValue> {
    let mut out = Vec::new();
    for (r, data) in data.iter().enumerate() {
        let Some(index) = problem.pieces.iter().position(|p| p.record == r) else { continue };
        let p = problem.parameters(theta, r);
        let Some((x, _)) = problem.initial(theta, &p, index) else { continue };
        for (state, &value) in x.iter().enumerate() {
            let unknown = problem.unknowns.iter().find(|u| u.kind == UnknownKind::State { piece: index, state });
            out.push(InitialValue {
                record: data.source.clone(),
                state: model.names().state(state).to_owned(),
                value,
                prior: unknown.and_then(|u| u.prior).or_else(|| slope_of(model, &p, &x, state, &problem.pieces[index])),
                free: unknown.is_some(),
            });
        }
    }
    out
}

/// The measured slope behind the rate of a coordinate that an output reads directly.
fn slope_of(model: &dyn Model, p: &[f64], x: &[f64], state: usize, piece: &Piece<'_>) -> Option<(f64, f64)> {
    let d = model.dimensions();
    let coordinate = state.checked_sub(d.coordinates).filter(|&i| i < d.coordinates)?;
    let (mut c, mut dhdp) = (vec![0.0; d.outputs * d.states()], vec![0.0; d.outputs * d.parameters]);
    model.output_jacobian(piece.data.times[0], x, p, &mut c, &mut dhdp);
    let row = |output: usize| &c[output * d.states()..(output + 1) * d.states()];
    piece.slopes.iter().find_map(|s| {
        let row = row(piece.data.outputs[s.output]);
        let alone = row.iter().enumerate().all(|(j, c)| (*c != 0.0) == (j == coordinate));
        alone.then(|| (s.value / row[coordinate], s.sd / row[coordinate].abs()))
    })
}

/// What the records tell of the parameters, those of the day under the name of their record.
#[allow(clippy::too_many_arguments)]
fn told(
    specs: &[ParameterSpec],
    data: &[Data],
    problem: &OutputError<'_>,
    theta: &[f64],
    at: &Evaluation,
    cov: &Covariance,
    wanted: &[usize],
) -> super::Identifiable {
    let others = (0..problem.unknowns.len()).filter(|i| !wanted.contains(i));
    let order: Vec<usize> = wanted.iter().copied().chain(others).collect();
    let mut normal = DMatrix::from_fn(order.len(), order.len(), |a, b| at.normal[(order[a], order[b])]);
    let (mut names, mut sizes) = (Vec::new(), Vec::new());
    for (a, &i) in wanted.iter().enumerate() {
        let unknown = &problem.unknowns[i];
        if let Some((_, sd)) = unknown.prior {
            normal[(a, a)] -= 1.0 / (sd * sd);
        }
        if let UnknownKind::Parameter(index) = unknown.kind {
            let spec = &specs[index];
            names.push(match unknown.record {
                Some(r) if data.len() > 1 => format!("{} ({})", spec.name, data[r].source),
                _ => spec.name.clone(),
            });
            // a start far below the value would make what is told well look dead
            sizes.push(typical(spec).max(theta[i].abs()));
        }
    }
    identifiable(&names, &sizes, &normal, cov.inflation)
}

/// Free runs from the fitted initial states.
fn train(
    model: &dyn Model,
    data: &[Data],
    problem: &OutputError<'_>,
    theta: &[f64],
    p: &[Vec<f64>],
) -> Result<Vec<RecordFigures>, FitError> {
    let mut out = Vec::new();
    for (r, (data, p)) in data.iter().zip(p).enumerate() {
        let Some(index) = problem.pieces.iter().position(|piece| piece.record == r) else { continue };
        let Some((x0, _)) = problem.initial(theta, p, index) else { continue };
        let pattern = problem.pieces[index].forward.pattern();
        let mut forward = Forward::new(model, &data.signals, &data.times, &data.outputs, &[], 0, pattern)?;
        let mut simulated: Vec<Vec<f64>> = vec![Vec::with_capacity(data.times.len()); data.outputs.len()];
        let status = forward.run(p, &x0, &[], &mut |_, i, y, _| simulated[i].push(y))?;
        let signals = data
            .outputs
            .iter()
            .enumerate()
            .map(|(i, &output)| SignalFigure {
                signal: model.names().output(output).to_owned(),
                fit_percent: fit_percent(&data.measured[i], &simulated[i]),
                rmse: rmse(&data.measured[i], &simulated[i]),
                hold: None,
            })
            .collect();
        let valid_until = status.time().unwrap_or(data.times[data.times.len() - 1]);
        out.push(RecordFigures { record: data.source.clone(), signals, status, valid_until, horizon: None });
    }
    Ok(out)
}

/// How far ahead a model is judged.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Ahead {
    /// A free run, but a prediction where that neither follows the record nor could.
    Sensible,
    /// A free run.
    Free,
    /// A prediction over so many seconds.
    Seconds(f64),
}

/// Figures of parameters over records, each from the state that its first samples give: free runs, or predictions over
/// `horizon` seconds, by request or where the free run says nothing.
///
/// # Errors
/// [`FitError::Match`], [`FitError::Simulation`].
pub fn figures(model: &dyn Model, p: &[f64], records: &[Record], hold: Hold, horizon: Option<f64>) -> Result<Vec<RecordFigures>, FitError> {
    let ahead = horizon.map_or(Ahead::Sensible, Ahead::Seconds);
    records.iter().map(|record| figure(model, p, record, hold, ahead, &[])).collect()
}

/// A free run over a record from states that are known.
///
/// # Errors
/// As [`figures`].
pub(crate) fn followed_from(
    model: &dyn Model,
    p: &[f64],
    record: &Record,
    hold: Hold,
    initial: &[(usize, f64)],
) -> Result<RecordFigures, FitError> {
    figure(model, p, record, hold, Ahead::Free, initial)
}

/// As [`figures`], for one record and with states that are known at its beginning.
fn figure(
    model: &dyn Model,
    p: &[f64],
    record: &Record,
    hold: Hold,
    ahead: Ahead,
    initial: &[(usize, f64)],
) -> Result<RecordFigures, FitError> {
    let horizon = if let Ahead::Seconds(h) = ahead { Some(h) } else { None };
    let choices = CompareOptions { hold, horizon, initial: initial.to_vec(), ..CompareOptions::default() };
    let c = compare(model, p, record, &choices).map_err(|e| match e {
        CompareError::Match(e) => FitError::Match(e),
        CompareError::Simulation(e) => FitError::Simulation(e),
    })?;
    let run = c.signals.iter().map(|s| SignalFigure { signal: s.name.clone(), fit_percent: s.fit_percent, rmse: s.rmse, hold: None });
    let run: Vec<SignalFigure> = run.collect();
    let free = ahead == Ahead::Free || ahead == Ahead::Sensible && c.status == Status::Completed && follows(&run);
    let (signals, horizon) = if free {
        (run, None)
    } else {
        let figures = c.figures().into_iter();
        (figures.map(|s| SignalFigure { signal: s.name, fit_percent: s.fit_percent, rmse: s.rmse, hold: s.hold }).collect(), c.horizon())
    };
    Ok(RecordFigures { record: record.source.clone(), signals, horizon, status: c.status, valid_until: c.valid_until })
}

/// A run that is nearer to every signal than its mean says something, however sensitive it is.
fn follows(signals: &[SignalFigure]) -> bool {
    signals.iter().all(|s| s.fit_percent.is_none_or(|f| f > 0.0))
}

/// Figures over training and test records, after and before the fit. A training record whose free run says nothing is
/// judged by predictions, too; before and after are judged in the same way.
pub(crate) fn judge(
    model: &dyn Model,
    specs: &[ParameterSpec],
    fit: &mut Fit,
    (records, tests): (&[Record], &[Record]),
    options: &FitOptions,
) -> Result<(), FitError> {
    let hold = options.hold;
    let nominal: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let ahead = options.horizon.map_or(Ahead::Sensible, Ahead::Seconds);
    let same = |after: &RecordFigures| after.horizon.map_or(Ahead::Free, Ahead::Seconds);
    for (r, record) in records.iter().enumerate() {
        let run = fit.train.get(r).filter(|t| ahead == Ahead::Sensible && t.status == Status::Completed && follows(&t.signals));
        if run.is_none() {
            let after = figure(model, &fit.p_of_record[r], record, hold, ahead, &[])?;
            if after.horizon.is_some() && r < fit.train.len() {
                fit.train[r] = after;
            }
        }
        let way = fit.train.get(r).map_or(ahead, same);
        fit.before.push(figure(model, &nominal, record, hold, way, &[])?);
    }
    for record in tests {
        let after = figure(model, &fit.p, record, hold, ahead, &[])?;
        fit.before_test.push(figure(model, &nominal, record, hold, same(&after), &[])?);
        fit.test.push(after);
    }
    Ok(())
}

fn describe(options: &FitOptions) -> String {
    let over = match &options.weights {
        Weights::Noise => "output errors over their standard deviation (estimated)".to_owned(),
        Weights::Spread => "output errors over the standard deviation of the measured signal".to_owned(),
        Weights::Given(scales) => {
            let named: Vec<String> = scales.iter().map(|(name, scale)| format!("{name}/{scale}")).collect();
            format!("output errors over given scales ({})", named.join(", "))
        }
    };
    let loss = match options.loss {
        Loss::Squares => "half the sum of squares".to_owned(),
        Loss::Huber(k) => format!("half the sum of Huber's loss (k = {k})"),
        Loss::Cauchy(k) => format!("half the sum of Cauchy's loss (k = {k})"),
    };
    let pieces = match options.shooting {
        None => String::new(),
        Some(s) if options.joined => format!(", in pieces of {s} s (multiple shooting)"),
        Some(s) => format!(", in windows of {s} s, each from a fitted state"),
    };
    format!("{loss} of {over}, priors added{pieces}")
}
