//! Equation error: the differential equations with measured coordinates put in, and no run of the model.
//!
//! Two ways. The *weak form* multiplies q'' = a(q, q', u, p) by bumps phi of compact support and shifts the derivatives onto
//! them: integral phi'' q = integral phi a; no acceleration is ever formed, so that it stands coarse encoders. The *filtered
//! form* smooths without delay, differences, filters both sides once more and takes every n-th sample (the way of M. Gautier
//! and A. Janot for robots). It gives starting values from which output error does not diverge, and estimates of its own
//! where accelerations can be had. Closed loops and noise in the regressors bias it: output error judges.

use super::answer::Estimate;
use super::build::{check, typical};
use super::bumps::bumps;
use super::covariance;
use super::data::Data;
use super::error::FitError;
use super::filter::{Butterworth, rates};
use super::minimize::{Ending, Evaluation, LevenbergMarquardt, Limits, Minimizer, Minimum, Objective};
use super::objective::Rows;
use super::options::FitOptions;
use super::rates_by::RatesBy;
use super::specification::ParameterSpec;
use crate::record::Record;
use control::centred_mean;
use nalgebra::{DMatrix, DVector};
use runtime::Model;
use sim::Hold;

/// How equations are made from samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Preparation {
    /// Weak form with bumps of this many samples.
    WeakForm {
        /// Samples of a bump.
        window: usize,
    },
    /// Filtered form.
    Filtered {
        /// Cut-off of the smoothing [Hz].
        cutoff: f64,
        /// Order of the Butterworth filter, which is run forwards and backwards.
        order: usize,
        /// Every n-th equation is kept.
        decimate: usize,
    },
    /// The seed paper's way: rates by an observer or a filter as it could run on the rig, smoothed by a centred mean,
    /// differenced, and both sides of the equations smoothed by that mean again.
    Observed {
        /// Where rates come from.
        rates: RatesBy,
        /// Samples of the mean.
        mean: usize,
    },
}

/// Estimates from equation error.
#[derive(Clone, Debug)]
pub struct EquationErrorFit {
    /// Fitted parameters.
    pub parameters: Vec<Estimate>,
    /// All parameters, for each record.
    pub p_of_record: Vec<Vec<f64>>,
    /// Error of each coordinate's equation in percent of its measured side, over all records.
    pub error_percent: Vec<(String, f64)>,
    /// How the search ended.
    pub ending: Ending,
    /// Evaluations.
    pub evaluations: usize,
}

/// Fits the free parameters by equation error.
///
/// # Errors
/// [`FitError`], one variant a cause; [`FitError::EquationError`] where a coordinate is not measured.
pub fn equation_error(
    model: &dyn Model,
    specs: &[ParameterSpec],
    records: &[Record],
    preparation: Preparation,
    hold: Hold,
) -> Result<EquationErrorFit, FitError> {
    fit(model, specs, &bound(model, specs, records, preparation, hold)?, preparation)
}

/// Records bound to the model, the request being checked.
pub(super) fn bound(
    model: &dyn Model,
    specs: &[ParameterSpec],
    records: &[Record],
    preparation: Preparation,
    hold: Hold,
) -> Result<Vec<Data>, FitError> {
    check(model, specs, records, &FitOptions::default())?;
    positive(preparation)?;
    records.iter().map(|r| Data::new(r, model, hold)).collect()
}

/// Numbers of a preparation that must be positive.
fn positive(preparation: Preparation) -> Result<(), FitError> {
    let (what, value) = match preparation {
        Preparation::WeakForm { .. } => return Ok(()),
        Preparation::Filtered { cutoff, .. } => ("the cut-off", cutoff),
        Preparation::Observed { rates: RatesBy::Filter { damping, .. }, .. } if !(damping > 0.0 && damping.is_finite()) => {
            ("the damping of the filter", damping)
        }
        Preparation::Observed { rates, .. } => ("the bandwidth", rates.bandwidth()),
    };
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(FitError::NotPositive { what: what.to_owned(), value }) }
}

/// As [`equation_error`], for records that are bound already.
pub(crate) fn fit(
    model: &dyn Model,
    specs: &[ParameterSpec],
    data: &[Data],
    preparation: Preparation,
) -> Result<EquationErrorFit, FitError> {
    let (problem, found) = solve(model, specs, data, (preparation, None), &Limits::default())?;
    Ok(EquationErrorFit {
        parameters: problem.estimates(&found, data)?,
        p_of_record: (0..data.len()).map(|r| problem.parameters_of(&found.x, r)).collect(),
        error_percent: problem.rows(&found.x).1,
        ending: found.ending,
        evaluations: problem.evaluations,
    })
}

/// Error of each coordinate's equation in percent of its measured side, after a search that may be short, and the parameters
/// of the first record there.
pub(crate) fn unexplained(
    model: &dyn Model,
    specs: &[ParameterSpec],
    data: &[Data],
    preparation: Preparation,
    limits: &Limits,
) -> Result<(ErrorPercent, Vec<f64>), FitError> {
    let (problem, found) = solve(model, specs, data, (preparation, None), limits)?;
    found.at.as_ref().ok_or_else(singular)?;
    Ok((problem.rows(&found.x).1, problem.parameters_of(&found.x, 0)))
}

/// Name of a coordinate, and the error of its equation in percent of the measured side.
pub(crate) type ErrorPercent = Vec<(String, f64)>;

pub(super) fn singular() -> FitError {
    FitError::EquationError { why: "the mass matrix is singular along the measured motion".to_owned() }
}

/// The problem, all equations or that of one coordinate, and its minimum.
pub(super) fn solve<'a>(
    model: &'a dyn Model,
    specs: &'a [ParameterSpec],
    data: &[Data],
    (preparation, channel): (Preparation, Option<usize>),
    limits: &Limits,
) -> Result<(EquationError<'a>, Minimum), FitError> {
    let (mut problem, start) = pose(model, specs, data, preparation, channel)?;
    problem.weigh(&start, true);
    let mut found = LevenbergMarquardt.minimize(&mut problem, &start, limits);
    // each equation by its own error, once the parameters are about right
    for _ in 0..3 {
        problem.weigh(&found.x, false);
        found = LevenbergMarquardt.minimize(&mut problem, &found.x, limits);
    }
    Ok((problem, found))
}

/// The problem, all equations or that of one coordinate, and where its search starts.
pub(super) fn pose<'a>(
    model: &'a dyn Model,
    specs: &'a [ParameterSpec],
    data: &[Data],
    preparation: Preparation,
    channel: Option<usize>,
) -> Result<(EquationError<'a>, Vec<f64>), FitError> {
    let base: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let records = data.iter().map(|d| Samples::new(model, &base, d, preparation)).collect::<Result<Vec<_>, _>>()?;
    let mut unknowns = Vec::new();
    let mut columns = vec![Vec::new(); data.len()];
    let mut parameters = Vec::new();
    for (i, s) in specs.iter().enumerate().filter(|(_, s)| s.free) {
        parameters.push(i);
        for (r, columns) in columns.iter_mut().enumerate() {
            if s.per_record || r == 0 {
                unknowns.push((i, s.per_record.then_some(r)));
            }
            columns.push(unknowns.len() - 1);
        }
    }
    let n = model.dimensions().coordinates;
    let weights = vec![1.0; n];
    let problem = EquationError { model, specs, base, records, unknowns, columns, parameters, channel, weights, evaluations: 0 };
    let start: Vec<f64> = problem.unknowns.iter().map(|&(i, _)| specs[i].value).collect();
    Ok((problem, start))
}

/// Measured motion and the functionals that make equations of it.
pub(super) struct Samples {
    times: Vec<f64>,
    /// Coordinates and rates, samples x 2 n.
    motion: Vec<f64>,
    /// Signals at each sample, in the middle of a switch their mean.
    signals: Vec<f64>,
    /// Measured side of each equation, equations x coordinates.
    left: Vec<f64>,
    functional: Functional,
}

/// How the other side of an equation is made from accelerations at samples.
enum Functional {
    /// (first sample, weights) of each equation.
    Bumps(Vec<(usize, Vec<f64>)>),
    /// Filtered, then every n-th.
    Filter {
        filter: Option<Butterworth>,
        every: usize,
        extension: usize,
        /// Samples at both ends, where the smoothing had the mirrored record on one side, that make no equation.
        ends: usize,
    },
    /// Centred mean, without the samples at both ends that have no full one, or where an observer still settles.
    Mean {
        /// Samples of the mean.
        mean: usize,
        /// Samples at both ends that make no equation.
        ends: usize,
    },
}

impl Samples {
    fn new(model: &dyn Model, p: &[f64], data: &Data, preparation: Preparation) -> Result<Self, FitError> {
        let n = model.dimensions().coordinates;
        let count = data.times.len();
        let mut q = coordinates(model, p, data)?;
        let t = &data.times;
        let period = (t[count - 1] - t[0]) / (count - 1) as f64;
        let (functional, v, left);
        match preparation {
            Preparation::WeakForm { window } => {
                let window = window.clamp(8, count);
                v = q.iter().map(|q| rates(t, q, (window / 4).max(4))).collect::<Vec<_>>();
                let bumps = bumps(t, window);
                left = bumps.iter().flat_map(|b| q.iter().map(|q| b.second.iter().zip(&q[b.first..]).map(|(w, q)| w * q).sum())).collect();
                functional = Functional::Bumps(bumps.into_iter().map(|b| (b.first, b.weights)).collect());
            }
            Preparation::Observed { rates, mean } => {
                constant_rate(data, period)?;
                let mean = mean.max(1);
                if count <= 4 * mean + 4 {
                    return Err(FitError::EquationError {
                        why: format!("{}: {count} samples are too few for means of {mean} of them", data.source),
                    });
                }
                let fast = || FitError::EquationError {
                    why: format!("{}: a bandwidth of {} rad/s cannot be sampled every {period} s", data.source, rates.bandwidth()),
                };
                let raw = q.iter().map(|q| rates.of(q, period)).collect::<Option<Vec<_>>>().ok_or_else(fast)?;
                v = raw.iter().map(|v| centred_mean(v, mean)).collect::<Vec<_>>();
                // what is late and smoothed on one side of the equations is so on the other
                q = q.iter().map(|q| rates.late(q, period, mean)).collect::<Option<Vec<_>>>().ok_or_else(fast)?;
                let settling = (8.0 / (rates.bandwidth() * period)).ceil() as usize;
                functional = Functional::Mean { mean, ends: (2 * mean + settling).min((count - 4) / 2) };
                let kept: Vec<Vec<f64>> = v.iter().map(|v| functional.filtered(&differences(v, period))).collect();
                left = (0..kept.first().map_or(0, Vec::len)).flat_map(|k| kept.iter().map(move |a| a[k])).collect();
            }
            Preparation::Filtered { cutoff, order, decimate } => {
                constant_rate(data, period)?;
                if cutoff * period >= 0.5 {
                    let half = 0.5 / period;
                    return Err(FitError::EquationError {
                        why: format!("{}: a cut-off of {cutoff} Hz is not below half of the sampling rate, {half:.6} Hz", data.source),
                    });
                }
                let smooth = Butterworth::new(order, cutoff * period);
                let extension = (3.0 / (cutoff * period)).ceil() as usize;
                q = q.iter().map(|q| smooth.zero_phase(q, extension)).collect();
                v = q.iter().map(|q| differences(q, period)).collect::<Vec<_>>();
                let a: Vec<Vec<f64>> = v.iter().map(|v| differences(v, period)).collect();
                let every = decimate.max(1);
                let filter = (every > 1).then(|| Butterworth::new(4, 0.4 / every as f64));
                let ends = (5.0 / (cutoff * period)).ceil() as usize;
                if count <= 2 * ends + 4 * every {
                    return Err(FitError::EquationError {
                        why: format!("{}: {count} samples are too few for a cut-off of {cutoff} Hz; choose a higher one", data.source),
                    });
                }
                functional = Functional::Filter { filter, every, extension: 10 * every, ends };
                let kept: Vec<Vec<f64>> = a.iter().map(|a| functional.filtered(a)).collect();
                left = (0..kept.first().map_or(0, Vec::len)).flat_map(|k| kept.iter().map(move |a| a[k])).collect();
            }
        }
        let motion = (0..count).flat_map(|k| q.iter().map(move |q| q[k]).chain(v.iter().map(move |v| v[k]))).collect();
        let delays: Vec<f64> = (0..model.dimensions().inputs).map(|i| model.input_path(i, p).delay).collect();
        let mut signals = Vec::with_capacity(count * model.dimensions().signals());
        for &time in t {
            let mut u: Vec<f64> = Vec::new();
            for i in 0..model.dimensions().signals() {
                let delay = delays.get(i).copied().unwrap_or(0.0);
                let at = |t: f64| data.inputs(model, p, t)[i];
                u.push(0.5 * (at(time - delay) + at(time - delay - 1e-3 * period)));
            }
            signals.extend(u);
        }
        if let Preparation::Observed { rates, mean } = preparation {
            let width = model.dimensions().signals();
            for i in 0..width {
                let own: Vec<f64> = signals.iter().skip(i).step_by(width).copied().collect();
                let late = rates.late(&own, period, mean).unwrap_or(own);
                signals.iter_mut().skip(i).step_by(width).zip(late).for_each(|(u, late)| *u = late);
            }
        }
        debug_assert_eq!(n, q.len());
        Ok(Self { times: t.clone(), motion, signals, left, functional })
    }
}

impl Functional {
    fn filtered(&self, series: &[f64]) -> Vec<f64> {
        match self {
            Self::Bumps(bumps) => bumps.iter().map(|(first, w)| w.iter().zip(&series[*first..]).map(|(w, s)| w * s).sum()).collect(),
            Self::Mean { mean, ends } => centred_mean(&series[*ends..series.len() - ends], *mean),
            Self::Filter { filter, every, extension, ends } => {
                let inside = &series[*ends..series.len() - ends];
                let smooth = filter.as_ref().map_or_else(|| inside.to_vec(), |f| f.zero_phase(inside, *extension));
                smooth.into_iter().step_by(*every).collect()
            }
        }
    }
}

fn constant_rate(data: &Data, period: f64) -> Result<(), FitError> {
    match data.times.windows(2).position(|w| ((w[1] - w[0]) / period - 1.0).abs() > 0.01) {
        None => Ok(()),
        Some(k) => Err(FitError::EquationError {
            why: format!("{}: filtering needs a constant rate, the step after {} s is another", data.source, data.times[k]),
        }),
    }
}

/// Central differences, one-sided at the ends.
fn differences(y: &[f64], period: f64) -> Vec<f64> {
    let last = y.len() - 1;
    (0..y.len())
        .map(|k| {
            let (a, b) = (k.saturating_sub(1), (k + 1).min(last));
            (y[b] - y[a]) / ((b - a).max(1) as f64 * period)
        })
        .collect()
}

/// Measured coordinates, from outputs: Newton's steps, each sample from the one before.
pub(crate) fn coordinates(model: &dyn Model, p: &[f64], data: &Data) -> Result<Vec<Vec<f64>>, FitError> {
    let d = model.dimensions();
    let (n, states, rows) = (d.coordinates, d.states(), data.outputs.len());
    let mut x = vec![0.0; states];
    let (mut y, mut c, mut dhdp) = (vec![0.0; d.outputs], vec![0.0; d.outputs * states], vec![0.0; d.outputs * d.parameters]);
    let mut q = vec![Vec::with_capacity(data.times.len()); n];
    for (k, &t) in data.times.iter().enumerate() {
        for _ in 0..if k == 0 { 20 } else { 4 } {
            model.outputs(t, &x, p, &mut y);
            model.output_jacobian(t, &x, p, &mut c, &mut dhdp);
            let by_q = DMatrix::from_fn(rows, n, |r, j| c[data.outputs[r] * states + j]);
            let error = DVector::from_fn(rows, |r, _| data.measured[r][k] - y[data.outputs[r]]);
            let normal = by_q.transpose() * &by_q;
            if k == 0
                && let Some(i) = (0..n).find(|&i| normal[(i, i)] == 0.0)
            {
                return Err(FitError::EquationError { why: format!("{}: `{}` was not measured", data.source, model.names().state(i)) });
            }
            let Some(step) = normal.lu().solve(&(by_q.transpose() * error)) else {
                return Err(FitError::EquationError { why: format!("{}: the measured outputs do not fix all coordinates", data.source) });
            };
            x.iter_mut().zip(step.iter()).for_each(|(x, s)| *x += s);
            if step.amax() <= 1e-12 * x[..n].iter().fold(1.0, |m: f64, x| m.max(x.abs())) {
                break;
            }
        }
        q.iter_mut().zip(&x).for_each(|(q, x)| q.push(*x));
    }
    Ok(q)
}

pub(super) struct EquationError<'a> {
    model: &'a dyn Model,
    specs: &'a [ParameterSpec],
    base: Vec<f64>,
    pub records: Vec<Samples>,
    /// (parameter, record).
    unknowns: Vec<(usize, Option<usize>)>,
    columns: Vec<Vec<usize>>,
    pub parameters: Vec<usize>,
    /// The only coordinate whose equation counts.
    channel: Option<usize>,
    /// 1 / scale of each coordinate's equations.
    weights: Vec<f64>,
    pub evaluations: usize,
}

/// Errors of one record's equations and their derivatives.
pub(super) struct Equations {
    /// Equations x coordinates.
    errors: Vec<f64>,
    /// (Equations x coordinates) x parameters.
    pub slopes: Vec<f64>,
}

impl EquationError<'_> {
    pub fn estimates(&self, found: &Minimum, data: &[Data]) -> Result<Vec<Estimate>, FitError> {
        let at = found.at.as_ref().ok_or_else(singular)?;
        let (rows, _) = self.rows(&found.x);
        let within = |(&(i, _), &x): (&(usize, Option<usize>), &f64)| self.specs[i].bounds.is_some_and(|(lo, hi)| x <= lo || x >= hi);
        let held: Vec<bool> = self.unknowns.iter().zip(&found.x).map(within).collect();
        let cov = covariance::covariance(&rows, &at.normal, &held);
        let estimate = |(k, &(i, record)): (usize, &(usize, Option<usize>))| {
            let std_error = cov.told[k].then(|| cov.matrix[(k, k)].max(0.0).sqrt());
            Estimate {
                name: self.specs[i].name.clone(),
                record: record.map(|r| data[r].source.clone()),
                unit: self.model.names().parameter_unit(i).to_owned(),
                value: found.x[k],
                std_error,
                ci95: std_error.map(|s| (found.x[k] - cov.factor * s, found.x[k] + cov.factor * s)),
                initial: self.specs[i].value,
                at_bound: held[k],
            }
        };
        Ok(self.unknowns.iter().enumerate().map(estimate).collect())
    }

    fn parameters_of(&self, theta: &[f64], record: usize) -> Vec<f64> {
        let mut p = self.base.clone();
        for (&(i, of), &value) in self.unknowns.iter().zip(theta) {
            if of.is_none_or(|r| r == record) {
                p[i] = value;
            }
        }
        p
    }

    /// Accelerations and derivatives at all samples, then through the functional. `None` where the model is singular.
    pub fn equations(&self, theta: &[f64], record: usize) -> Option<Equations> {
        let d = self.model.dimensions();
        let (n, states, m, signals) = (d.coordinates, d.states(), self.parameters.len(), d.signals());
        let samples = &self.records[record];
        let p = self.parameters_of(theta, record);
        let count = samples.times.len();
        // series of each coordinate: the acceleration, then its derivatives
        let mut series = vec![vec![0.0; count]; n * (1 + m)];
        let (mut dx, mut a, mut f) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * m]);
        let mut work = vec![0.0; d.sensitivity_work()];
        let mut x = vec![0.0; states];
        let mut lag = Lag::new(d.lags, m);
        for (k, &t) in samples.times.iter().enumerate().take(count) {
            x[..2 * n].copy_from_slice(&samples.motion[k * 2 * n..(k + 1) * 2 * n]);
            let u = &samples.signals[k * signals..(k + 1) * signals];
            self.model.sensitivities(t, &x, u, &p, &self.parameters, &mut dx, &mut a, &mut f, &mut work).ok()?;
            if d.lags > 0 {
                let dt = if k == 0 { f64::INFINITY } else { t - samples.times[k - 1] };
                lag.step(&mut x[2 * n..], dt, &dx[2 * n..], &a, &f, 2 * n)?;
                self.model.sensitivities(t, &x, u, &p, &self.parameters, &mut dx, &mut a, &mut f, &mut work).ok()?;
            }
            for i in 0..n {
                let row = n + i;
                series[i * (1 + m)][k] = dx[row];
                for j in 0..m {
                    let through_lags: f64 = (0..d.lags).map(|z| a[row * states + 2 * n + z] * lag.slopes[(z, j)]).sum();
                    series[i * (1 + m) + 1 + j][k] = f[row * m + j] + through_lags;
                }
            }
        }
        let filtered: Vec<Vec<f64>> = series.iter().map(|s| samples.functional.filtered(s)).collect();
        let equations = samples.left.len() / n.max(1);
        let mut errors = vec![0.0; equations * n];
        let mut slopes = vec![0.0; equations * n * m];
        for (at, error) in errors.iter_mut().enumerate() {
            let (e, i) = (at / n, at % n);
            *error = filtered[i * (1 + m)][e] - samples.left[at];
            for (slope, series) in slopes[at * m..(at + 1) * m].iter_mut().zip(&filtered[i * (1 + m) + 1..]) {
                *slope = series[e];
            }
        }
        (errors.iter().chain(&slopes).all(|e| e.is_finite())).then_some(Equations { errors, slopes })
    }

    /// Scales: the spread of the measured side at first, later the errors themselves.
    fn weigh(&mut self, theta: &[f64], first: bool) {
        let n = self.weights.len();
        let mut squares = vec![0.0; n];
        let mut left = vec![0.0; n];
        let mut count = 0;
        for r in 0..self.records.len() {
            for side in self.records[r].left.chunks(n.max(1)) {
                left.iter_mut().zip(side).for_each(|(l, s)| *l += s * s);
                count += 1;
            }
            if !first && let Some(e) = self.equations(theta, r) {
                e.errors.chunks(n.max(1)).for_each(|e| squares.iter_mut().zip(e).for_each(|(s, e)| *s += e * e));
            }
        }
        for i in 0..n {
            let scale = |s: f64| (s / count.max(1) as f64).sqrt();
            let floor = 1e-9 * scale(left[i]);
            let of = if first { scale(left[i]) } else { scale(squares[i]) };
            let counts = self.channel.is_none_or(|only| only == i);
            self.weights[i] = if counts { 1.0 / of.max(floor).max(f64::MIN_POSITIVE.sqrt()) } else { 0.0 };
        }
    }

    /// For the covariance, and the errors in percent of the measured side.
    pub fn rows(&self, theta: &[f64]) -> (Vec<Rows>, Vec<(String, f64)>) {
        let n = self.weights.len();
        let m = self.parameters.len();
        let (mut squares, mut left) = (vec![0.0; n], vec![0.0; n]);
        let mut rows = Vec::new();
        for r in 0..self.records.len() {
            let Some(Equations { mut errors, mut slopes }) = self.equations(theta, r) else { continue };
            for (e, side) in errors.chunks(n).zip(self.records[r].left.chunks(n)) {
                squares.iter_mut().zip(e).for_each(|(s, e)| *s += e * e);
                left.iter_mut().zip(side).for_each(|(l, s)| *l += s * s);
            }
            for (at, e) in errors.iter_mut().enumerate() {
                let w = self.weights[at % n];
                *e *= w;
                slopes[at * m..(at + 1) * m].iter_mut().for_each(|s| *s *= w);
            }
            let count = errors.len() / n;
            rows.push(Rows {
                record: r,
                times: (0..count).map(|k| k as f64).collect(),
                outputs: n,
                slopes: vec![1.0; errors.len()],
                errors,
                jacobian: slopes,
                columns: self.columns[r].clone(),
            });
        }
        let percent = (0..n).map(|i| (self.model.names().state(i).to_owned(), 100.0 * (squares[i] / left[i]).sqrt())).collect();
        (rows, percent)
    }
}

impl Objective for EquationError<'_> {
    fn unknowns(&self) -> usize {
        self.unknowns.len()
    }

    fn bounds(&self, i: usize) -> (f64, f64) {
        self.specs[self.unknowns[i].0].bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY))
    }

    fn size(&self, i: usize) -> f64 {
        typical(&self.specs[self.unknowns[i].0])
    }

    fn evaluate(&mut self, theta: &[f64]) -> Option<Evaluation> {
        self.evaluations += 1;
        let (count, m, n) = (theta.len(), self.parameters.len(), self.weights.len());
        let mut total = Evaluation { cost: 0.0, gradient: DVector::zeros(count), normal: DMatrix::zeros(count, count) };
        for r in 0..self.records.len() {
            let e = self.equations(theta, r)?;
            let columns = &self.columns[r];
            for (at, error) in e.errors.iter().enumerate() {
                let w = self.weights[at % n];
                let slopes = &e.slopes[at * m..(at + 1) * m];
                total.cost += 0.5 * (w * error).powi(2);
                for (a, &i) in columns.iter().enumerate() {
                    total.gradient[i] += w * w * error * slopes[a];
                    for (b, &j) in columns.iter().enumerate() {
                        total.normal[(i, j)] += w * w * slopes[a] * slopes[b];
                    }
                }
            }
        }
        for (k, &(i, _)) in self.unknowns.iter().enumerate() {
            if let Some(sd) = self.specs[i].prior_sd {
                let error = (theta[k] - self.specs[i].prior_mean) / sd;
                total.cost += 0.5 * error * error;
                total.gradient[k] += error / sd;
                total.normal[(k, k)] += 1.0 / (sd * sd);
            }
        }
        total.cost.is_finite().then_some(total)
    }
}

/// Actuator states along the measured motion, by implicit Euler, with their derivatives by the parameters.
struct Lag {
    slopes: DMatrix<f64>,
}

impl Lag {
    fn new(lags: usize, parameters: usize) -> Self {
        Self { slopes: DMatrix::zeros(lags, parameters) }
    }

    /// z' = f(z) is linear in z: one Newton step is exact. An infinite step settles them.
    fn step(&mut self, z: &mut [f64], dt: f64, dz: &[f64], a: &[f64], f: &[f64], at: usize) -> Option<()> {
        let (lags, m) = self.slopes.shape();
        let states = at + lags;
        let inverse_dt = 1.0 / dt;
        let matrix = DMatrix::from_fn(lags, lags, |i, j| (if i == j { inverse_dt } else { 0.0 }) - a[(at + i) * states + at + j]);
        let lu = matrix.lu();
        let moved = lu.solve(&DVector::from_column_slice(dz))?;
        z.iter_mut().zip(moved.iter()).for_each(|(z, s)| *z += s);
        let right = DMatrix::from_fn(lags, m, |i, j| f[(at + i) * m + j] + inverse_dt * self.slopes[(i, j)]);
        self.slopes = lu.solve(&right)?;
        Some(())
    }
}
