//! Identification by innovations: from records to an answer of the same form as that of output error.

use super::estimate::{EstimateOptions, Estimated, estimate, likelihood};
use super::filter::Track;
use super::joint::{Joint, Kind};
use super::noise::{Dry, Noise};
use super::smooth::smooth;
use crate::fit::covariance::{self, Covariance};
use crate::fit::minimize::{Evaluation, LevenbergMarquardt, Limits, Minimizer, Objective};
use crate::fit::{
    Estimate, Fit, FitError, FitOptions, Identifiable, InitialValue, ParameterSpec, Preparation, check, equation_error, followed_from,
    identifiable, judge, typical, whiteness,
};
use crate::record::{Blocks, Record};
use nalgebra::DMatrix;
use runtime::Model;
use sim::Hold;
use std::time::Instant;

/// Choices.
#[derive(Clone, Copy, Debug)]
pub struct InnovationsOptions {
    /// What logged inputs do between samples.
    pub hold: Hold,
    /// Judge by predictions over this many seconds [s] instead of free runs; `None`: where the free run says nothing.
    pub horizon: Option<f64>,
    /// Largest noise of an output in parts of its spread, where that is more than 30 steps of its encoder.
    pub blur: f64,
    /// Samples that are averaged into one before anything is fitted: a filter looks one sample ahead, and a record at 1 kHz would ask it
    /// about rounding and vibrations that no rigid body has. Figures of fit are those of the record as it is.
    pub block: usize,
    /// Evaluations of the search for the likelihood's own maximum.
    pub evaluations: usize,
}

impl Default for InnovationsOptions {
    fn default() -> Self {
        Self { hold: Hold::default(), horizon: None, blur: 0.1, block: 1, evaluations: 10 }
    }
}

/// What drives a rig besides its inputs.
#[derive(Clone, Debug, Default)]
pub struct Driven {
    /// Coordinates with a random force, and the parameters of the model by which these enter.
    pub forces: Vec<(String, usize)>,
    /// Dry friction, which is random where its coordinate turns.
    pub dry: Vec<Dry>,
}

/// A positive number with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Positive {
    /// Value (SI).
    pub value: f64,
    /// 95 % interval, symmetric in the logarithm; `None` where the records do not tell it, or it stands at the end of its range.
    pub ci95: Option<(f64, f64)>,
    /// It stands at the end of the range in which it is looked for.
    pub at_bound: bool,
}

/// The random force on a coordinate: exponentially correlated in time.
#[derive(Clone, Debug, PartialEq)]
pub struct RandomForce {
    /// Name of the coordinate.
    pub coordinate: String,
    /// Unit of the force.
    pub unit: String,
    /// Its standard deviation.
    pub sd: Positive,
    /// Its correlation time [s].
    pub time: Positive,
}

/// The noise of an output.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputNoise {
    /// Name of the output.
    pub output: String,
    /// Its standard deviation (SI).
    pub sd: Positive,
}

/// The answer.
#[derive(Clone, Debug)]
pub struct InnovationsFit {
    /// As for output error; the whiteness is that of the innovations, initial states are smoothed ones.
    pub fit: Fit,
    /// What pushes the coordinates.
    pub forces: Vec<RandomForce>,
    /// What blurs the outputs.
    pub noise: Vec<OutputNoise>,
    /// Logarithm of the likelihood over all records, without the constant of 2 pi.
    pub log_likelihood: f64,
}

/// Lags of the whiteness test.
const LAGS: usize = 20;
/// Samples of the bumps of the weak form from which starting values are taken.
const BUMPS: [usize; 3] = [16, 40, 100];

/// Fits the free parameters of `specs` with random forces on coordinates: `forces` are the names of the coordinates and the parameters (zero,
/// not free) by which the forces enter.
///
/// # Errors
/// [`FitError`], one variant a cause.
pub fn identify(
    model: &dyn Model,
    specs: &[ParameterSpec],
    driven: &Driven,
    records: &[Record],
    tests: &[Record],
    options: &InnovationsOptions,
) -> Result<InnovationsFit, FitError> {
    let began = Instant::now();
    let judged = FitOptions { hold: options.hold, horizon: options.horizon, ..FitOptions::default() };
    check(model, specs, records, &judged)?;
    let nominal: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let blocks = Blocks::of(model, &nominal, options.hold);
    let (all, hold) = (records, blocks.hold(options.block));
    let records = &records.iter().map(|r| blocks.averaged(r, options.block)).collect::<Vec<_>>()[..];
    let mut tracks = records.iter().map(|r| Track::new(r, model, &nominal, hold)).collect::<Result<Vec<_>, _>>()?;
    let unknowns =
        specs.iter().filter(|s| s.free).map(|s| if s.per_record { records.len() } else { 1 }).sum::<usize>() + 2 * driven.forces.len();
    let samples: usize = tracks.iter().map(|t| t.times().len() * t.measured().count()).sum();
    if samples < unknowns {
        return Err(FitError::TooFewSamples { samples, unknowns });
    }
    let (started_from, found) = begin(model, specs, &mut tracks, (&nominal, driven), records, &InnovationsOptions { hold, ..*options })?;

    let nowhere = || FitError::NoStart { file: tracks[0].source().to_owned(), status: None };
    let sd =
        |i: usize, record: Option<usize>| found.unknowns.iter().find(|u| u.parameter == i && u.record == record).map_or(f64::NAN, |u| u.sd);
    let (mut joint, x) = Joint::new(model, specs, &tracks, &found.p, &found.noise, (options.blur, &sd)).ok_or_else(nowhere)?;
    // a difference of the likelihood's logarithm below a twentieth says nothing
    let limits = Limits { evaluations: options.evaluations, step: 1e-5, cost: 0.1 / samples as f64, gradient: 1e-5 };
    let mut minimum = LevenbergMarquardt.minimize(&mut joint, &x, &limits);
    // once more with differences over what is known now
    if let Some(at) = &minimum.at {
        let held = joint.held(&minimum.x);
        let rows = joint.rows(&minimum.x).ok_or_else(nowhere)?;
        let cov = covariance::covariance(&rows, &at.normal, &held);
        joint.known_to(&(0..minimum.x.len()).map(|k| cov.matrix[(k, k)].max(0.0).sqrt()).collect::<Vec<_>>());
        minimum = LevenbergMarquardt.minimize(&mut joint, &minimum.x, &limits);
    }
    let x = minimum.x.clone();
    let (at, rows) = (joint.evaluate(&x).ok_or_else(nowhere)?, joint.rows(&x).ok_or_else(nowhere)?);
    let held = joint.held(&x);
    let cov = covariance::covariance(&rows, &at.normal, &held);
    let cost = joint.cost(&x).ok_or_else(nowhere)?;
    let answer = Answer { model, specs, tracks: &tracks, joint: &joint, x: &x, at: &at, cov: &cov, held: &held };

    let (p_of_record, noise) = ((0..tracks.len()).map(|r| joint.parameters(&x, r)).collect::<Vec<_>>(), joint.noise(&x));
    let white = rows
        .iter()
        .flat_map(|rows| {
            let names = tracks[rows.record].measured().map(|(o, _)| model.names().output(o)).enumerate();
            names.filter_map(|(i, name)| {
                // a sample that is not used has no innovation
                let z: Vec<f64> = rows.errors.iter().skip(2 * i).step_by(rows.outputs).copied().filter(|z| *z != 0.0).collect();
                whiteness(tracks[rows.record].source(), name, &z, LAGS)
            })
        })
        .collect();
    let mut fit = Fit {
        parameters: answer.parameters(),
        p: answer.shared(),
        correlation: answer.correlation(),
        covariance: answer.covariance(),
        initial_states: initial_states(model, &p_of_record, &tracks, &noise),
        objective: "minus the logarithm of the likelihood of the innovations (random forces on the coordinates, noise of the outputs), priors added".to_owned(),
        cost: cost + priors(specs, &joint.kinds, &x),
        scales: tracks.iter().map(|t| t.measured().map(|(o, _)| (model.names().output(o).to_owned(), noise.output_sd[o])).collect()).collect(),
        ending: minimum.ending,
        intervals: format!("{}; parameters and noises together", covariance::SOURCE),
        memory: cov.memory,
        identifiable: answer.told(),
        whiteness: white,
        train: Vec::new(),
        test: Vec::new(),
        before: Vec::new(),
        before_test: Vec::new(),
        started_from,
        patterns: Vec::new(),
        evaluations: joint.evaluations,
        seconds: 0.0,
        search_seconds: began.elapsed().as_secs_f64(),
        p_of_record,
    };
    for (record, p) in all.iter().zip(&fit.p_of_record) {
        let of = fit.initial_states.iter().filter(|s| s.record == record.source);
        let states = 0..model.dimensions().states();
        let initial: Vec<(usize, f64)> =
            of.filter_map(|s| Some((states.clone().find(|&i| model.names().state(i) == s.state)?, s.value))).collect();
        fit.train.push(followed_from(model, p, record, options.hold, &initial)?);
    }
    judge(model, specs, &mut fit, (all, tests), &judged)?;
    fit.seconds = began.elapsed().as_secs_f64();
    let forces = driven.forces.iter().enumerate().map(|(k, (name, entry))| RandomForce {
        coordinate: name.clone(),
        unit: model.names().parameter_unit(*entry).to_owned(),
        sd: answer.positive(Kind::Size(k)),
        time: answer.positive(Kind::Time(k)),
    });
    let outputs = joint.kinds.iter().filter_map(|kind| match *kind {
        Kind::Output(o) => Some(OutputNoise { output: model.names().output(o).to_owned(), sd: answer.positive(*kind) }),
        _ => None,
    });
    Ok(InnovationsFit { forces: forces.collect(), noise: outputs.collect(), log_likelihood: -cost, fit })
}

/// From the rig's values and from those of equation error, whichever records find likelier after a short search; then a long one.
fn begin(
    model: &dyn Model,
    specs: &[ParameterSpec],
    tracks: &mut [Track],
    (nominal, driven): (&[f64], &Driven),
    records: &[Record],
    options: &InnovationsOptions,
) -> Result<(String, Estimated), FitError> {
    let mut starts = vec![("nominal".to_owned(), vec![nominal.to_vec(); records.len()])];
    for window in BUMPS {
        if records.iter().all(|r| 4 * window <= r.t.len())
            && let Ok(found) = equation_error(model, specs, records, Preparation::WeakForm { window }, options.hold)
            && found.p_of_record.iter().flatten().all(|p| p.is_finite())
        {
            starts.push((format!("equation error, windows of {window} samples"), found.p_of_record));
        }
    }
    let entries = driven.forces.iter().map(|f| f.1).collect();
    let guess = Noise { dry: driven.dry.clone(), ..Noise::guess(model, nominal, tracks, entries) };
    // how likely each start is says where to begin; the rig's own values are searched from in any case
    let mut likely: Vec<(f64, usize)> = Vec::new();
    for (k, (_, p)) in starts.iter().enumerate() {
        let mut sum = 0.0;
        for (track, p) in tracks.iter().zip(p) {
            sum += likelihood(model, p, track, &guess)?.map_or(f64::NEG_INFINITY, |l| l.iter().sum());
        }
        likely.push((sum, k));
    }
    likely.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut tried: Vec<usize> = likely.iter().take(1).map(|l| l.1).collect();
    if !tried.contains(&0) {
        tried.push(0);
    }
    let short = EstimateOptions { rounds: 2, finest: 0.4, evaluations: 30, blur: options.blur };
    let mut best: Option<(usize, Estimated)> = None;
    let mut failed = None;
    for k in tried {
        let mut own = tracks.to_vec();
        match estimate(model, specs, &mut own, &starts[k].1, guess.clone(), short) {
            Ok(found) => {
                if best.as_ref().is_none_or(|(_, b)| found.log_likelihood > b.log_likelihood) {
                    best = Some((k, found));
                }
            }
            Err(e) => failed = Some(e),
        }
    }
    let Some((k, best)) = best else { return Err(failed.unwrap_or(FitError::NoRecord)) };
    let long = EstimateOptions { rounds: 5, finest: 0.1, evaluations: 30, blur: options.blur };
    let found = estimate(model, specs, tracks, &best.p, best.noise, long)?;
    Ok((starts[k].0.clone(), found))
}

fn priors(specs: &[ParameterSpec], kinds: &[Kind], x: &[f64]) -> f64 {
    let each = kinds.iter().zip(x).filter_map(|(kind, x)| match *kind {
        Kind::Parameter(i, _) => specs[i].prior_sd.map(|sd| 0.5 * ((x - specs[i].prior_mean) / sd).powi(2)),
        _ => None,
    });
    each.sum()
}

/// States at the first sample, given all samples.
fn initial_states(model: &dyn Model, p: &[Vec<f64>], tracks: &[Track], noise: &Noise) -> Vec<InitialValue> {
    let mut all = Vec::new();
    for (track, p) in tracks.iter().zip(p) {
        let smoothed = smooth(model, p, track, noise).ok().flatten();
        let first = smoothed.as_ref().and_then(|s| s.state.first()).unwrap_or(&track.initial);
        for (state, &value) in first.iter().enumerate().take(model.dimensions().states()) {
            let sd = track.initial_sd[state];
            all.push(InitialValue {
                record: track.source().to_owned(),
                state: model.names().state(state).to_owned(),
                value,
                prior: (sd > 0.0).then_some((track.initial[state], sd)),
                free: sd > 0.0,
            });
        }
    }
    all
}

/// The maximum with all that belongs to it.
struct Answer<'a> {
    model: &'a dyn Model,
    specs: &'a [ParameterSpec],
    tracks: &'a [Track],
    joint: &'a Joint<'a>,
    x: &'a [f64],
    at: &'a Evaluation,
    cov: &'a Covariance,
    held: &'a [bool],
}

impl Answer<'_> {
    /// Unknowns that are parameters.
    fn wanted(&self) -> Vec<usize> {
        (0..self.x.len()).filter(|&k| matches!(self.joint.kinds[k], Kind::Parameter(..))).collect()
    }

    fn parameters(&self) -> Vec<Estimate> {
        let one = |k: usize| {
            let Kind::Parameter(i, record) = self.joint.kinds[k] else { return None };
            let std_error = self.cov.told[k].then(|| self.cov.matrix[(k, k)].max(0.0).sqrt());
            Some(Estimate {
                name: self.specs[i].name.clone(),
                record: record.map(|r| self.tracks[r].source().to_owned()),
                unit: self.model.names().parameter_unit(i).to_owned(),
                value: self.x[k],
                std_error,
                ci95: std_error.map(|s| (self.x[k] - self.cov.factor * s, self.x[k] + self.cov.factor * s)),
                initial: self.specs[i].value,
                at_bound: self.held[k],
            })
        };
        (0..self.x.len()).filter_map(one).collect()
    }

    /// Parameters for records that were not fitted: those of the day as they started.
    fn shared(&self) -> Vec<f64> {
        let mut p = self.joint.parameters(self.x, 0);
        for (value, spec) in p.iter_mut().zip(self.specs).filter(|(_, s)| s.per_record) {
            *value = spec.value;
        }
        p
    }

    fn covariance(&self) -> DMatrix<f64> {
        let wanted = self.wanted();
        DMatrix::from_fn(wanted.len(), wanted.len(), |a, b| self.cov.matrix[(wanted[a], wanted[b])])
    }

    fn correlation(&self) -> DMatrix<f64> {
        let c = self.covariance();
        DMatrix::from_fn(c.nrows(), c.nrows(), |a, b| {
            let size = (c[(a, a)] * c[(b, b)]).sqrt();
            if size > 0.0 { c[(a, b)] / size } else { 0.0 }
        })
    }

    fn told(&self) -> Identifiable {
        let wanted = self.wanted();
        // noises that stand at a bound or have no effect say nothing against a parameter
        let others = (0..self.x.len()).filter(|k| !wanted.contains(k) && !self.held[*k] && self.at.normal[(*k, *k)] > 0.0);
        let order: Vec<usize> = wanted.iter().copied().chain(others).collect();
        let mut normal = DMatrix::from_fn(order.len(), order.len(), |a, b| self.at.normal[(order[a], order[b])]);
        let (mut names, mut sizes) = (Vec::new(), Vec::new());
        for (a, &k) in wanted.iter().enumerate() {
            let Kind::Parameter(i, record) = self.joint.kinds[k] else { continue };
            let spec = &self.specs[i];
            if let Some(sd) = spec.prior_sd {
                normal[(a, a)] -= 1.0 / (sd * sd);
            }
            names.push(match record {
                Some(r) if self.tracks.len() > 1 => format!("{} ({})", spec.name, self.tracks[r].source()),
                _ => spec.name.clone(),
            });
            sizes.push(typical(spec).max(self.x[k].abs()));
        }
        identifiable(&names, &sizes, &normal, self.cov.inflation)
    }

    /// A noise, which is searched by its logarithm.
    fn positive(&self, kind: Kind) -> Positive {
        let Some(k) = self.joint.kinds.iter().position(|other| *other == kind) else {
            return Positive { value: 0.0, ci95: None, at_bound: false };
        };
        let value = self.x[k].exp();
        let half = self.cov.factor * self.cov.matrix[(k, k)].max(0.0).sqrt();
        // an interval over more than two decades tells nothing
        let told = self.cov.told[k] && !self.held[k] && half < 2.0 * std::f64::consts::LN_10;
        Positive { value, ci95: told.then(|| (value * (-half).exp(), value * half.exp())), at_bound: self.held[k] }
    }
}
