//! Integration steps for a fit: the cheapest that keep the outputs' error far below what encoders resolve.

use super::data::{Data, spread};
use super::error::FitError;
use runtime::Model;
use sim::{FixedMethod, Forward, Pattern, Status};

/// Stages of a step, by which patterns are compared.
fn stages(method: FixedMethod) -> usize {
    match method {
        FixedMethod::Classical => 4,
        FixedMethod::DormandPrince => 6,
    }
}

/// Pattern `a` needs fewer evaluations of the model than `b`.
pub(crate) fn cheaper(a: &Pattern, b: &Pattern) -> bool {
    stages(a.method) as f64 / a.step < stages(b.method) as f64 / b.step
}

/// Allowed error of each measured output: `tolerance` parts of its quantum, or of 1e-4 of its spread.
pub(crate) fn allowed(model: &dyn Model, p: &[f64], data: &Data, tolerance: f64) -> Vec<f64> {
    data.outputs
        .iter()
        .zip(&data.measured)
        .map(|(&i, values)| {
            let quantum = model.output_path(i, p).quantum;
            let resolution = if quantum > 0.0 { quantum } else { 1e-4 * spread(values) };
            tolerance * resolution.max(f64::MIN_POSITIVE)
        })
        .collect()
}

/// A stretch of a record, from sample `from` to sample `to`, and the state at its beginning.
pub(crate) struct Run {
    pub from: usize,
    pub to: usize,
    pub x0: Vec<f64>,
}

/// Steps that are tried, from 32 sample periods down by halves.
const HALVINGS: i32 = 14;
/// Of these, the ones that are tried on whole runs: where steps as fine as a sixteenth of a sample still disagree at the end, it is the
/// motion that is sensitive, not the steps that are coarse.
const OVER_ALL: i32 = 9;
/// Samples of the windows on which steps are tried then, each from where the finer of two steps has come.
const WINDOW: usize = 25;

/// The pattern with the fewest evaluations of the model whose outputs agree with those of half its step to within
/// `allowed`: over whole runs, or, where the motion is so sensitive that none does, over short windows of them. Where the run does not come
/// to its end the agreement is judged up to there.
pub(crate) fn choose(model: &dyn Model, p: &[f64], runs: &[Run], data: &Data, allowed: &[f64]) -> Result<Pattern, FitError> {
    let period = data.times[data.times.len() - 1] - data.times[0];
    let period = period / (data.times.len() - 1) as f64;
    // longer steps than from switch to switch are none
    let (coarsest, least) = (32.0 * period, longest(model, p, runs, data, 32.0 * period)?);
    let first = (0..HALVINGS).find(|k| coarsest * 0.5_f64.powi(*k) <= 2.0 * least).unwrap_or(0);
    for (window, halvings) in [(usize::MAX, OVER_ALL), (WINDOW, HALVINGS)] {
        let mut best: Option<(usize, Pattern)> = None;
        let trial = Trial { model, p, runs, data, window };
        for method in [FixedMethod::DormandPrince, FixedMethod::Classical] {
            for halving in first..halvings {
                let pattern = Pattern { method, step: coarsest * 0.5_f64.powi(halving) };
                let Some((steps, agree)) = trial.of(pattern, allowed)? else { continue };
                let work = steps * stages(method);
                if best.is_some_and(|(least, _)| work >= least) {
                    break;
                }
                if agree {
                    best = Some((work, pattern));
                    break;
                }
            }
        }
        if let Some((_, pattern)) = best {
            return Ok(pattern);
        }
    }
    // nothing agrees: the model is not smooth at any of these steps
    Ok(Pattern { method: FixedMethod::Classical, step: period / 16.0 })
}

/// Mean length of the steps that are taken where none should be longer than `step` [s].
fn longest(model: &dyn Model, p: &[f64], runs: &[Run], data: &Data, step: f64) -> Result<f64, FitError> {
    let Some(run) = runs.first() else { return Ok(step) };
    let trial = Trial { model, p, runs, data, window: usize::MAX };
    let taken = trial.outputs(run.from, run.to, &run.x0, Pattern { method: FixedMethod::Classical, step })?;
    Ok(match taken.status.time().unwrap_or(data.times[run.to]) - data.times[run.from] {
        span if span > 0.0 && taken.steps > 0 => span / taken.steps as f64,
        _ => step,
    })
}

/// The outputs of a pattern agree with those of half its step.
pub(crate) fn suffices(
    model: &dyn Model,
    p: &[f64],
    runs: &[Run],
    data: &Data,
    allowed: &[f64],
    pattern: Pattern,
) -> Result<bool, FitError> {
    let trial = Trial { model, p, runs, data, window: usize::MAX };
    let mut tried = pattern;
    for _ in 0..HALVINGS {
        match trial.of(tried, allowed)? {
            // switches are nearer to each other than steps are long
            None => tried.step *= 0.5,
            Some((_, agree)) => return Ok(agree),
        }
    }
    Ok(false)
}

/// Where steps are tried.
struct Trial<'a> {
    model: &'a dyn Model,
    p: &'a [f64],
    runs: &'a [Run],
    data: &'a Data,
    /// Samples after which the coarser run begins again from the state of the finer one.
    window: usize,
}

struct Outputs {
    values: Vec<Vec<f64>>,
    status: Status,
    steps: usize,
    end: Vec<f64>,
}

impl Trial<'_> {
    /// Steps that the pattern takes, and whether its outputs agree with those of half its step. `None` where both take the same steps,
    /// from switch to switch of the inputs.
    fn of(&self, pattern: Pattern, allowed: &[f64]) -> Result<Option<(usize, bool)>, FitError> {
        let half = Pattern { step: 0.5 * pattern.step, ..pattern };
        let (mut steps, mut finer) = (0, 0);
        let mut agrees = true;
        for run in self.runs {
            let (mut from, mut x) = (run.from, run.x0.clone());
            while from < run.to {
                let to = from.saturating_add(self.window).min(run.to);
                let (coarse, fine) = (self.outputs(from, to, &x, pattern)?, self.outputs(from, to, &x, half)?);
                (steps, finer) = (steps + coarse.steps, finer + fine.steps);
                if coarse.steps < fine.steps && !agree(&coarse, &fine, allowed) {
                    agrees = false;
                }
                // a window is enough to refuse, and nothing comes after the end of a run
                if fine.status != Status::Completed || !agrees && self.window < usize::MAX {
                    break;
                }
                (from, x) = (to, fine.end);
            }
        }
        Ok((finer > steps).then_some((steps, agrees)))
    }

    fn outputs(&self, from: usize, to: usize, x0: &[f64], pattern: Pattern) -> Result<Outputs, FitError> {
        let data = self.data;
        let mut values: Vec<Vec<f64>> = data.outputs.iter().map(|_| Vec::new()).collect();
        let mut forward = Forward::new(self.model, &data.signals, &data.times[from..=to], &data.outputs, &[], 0, pattern)?;
        let status = forward.run(self.p, x0, &[], &mut |_, i, y, _| values[i].push(y))?;
        Ok(Outputs { values, status, steps: forward.steps(), end: forward.state().to_vec() })
    }
}

fn agree(a: &Outputs, b: &Outputs, allowed: &[f64]) -> bool {
    // both come to the end, or end at about the same place
    let ends = match (a.status.time(), b.status.time()) {
        (None, None) => true,
        (Some(s), Some(t)) => (s - t).abs() < 0.1 * s.abs().max(t.abs()),
        _ => false,
    };
    // a run that dies grows without bound before; there the last tenth is not compared
    let dies = a.status.time().is_some();
    ends && a.values.iter().zip(&b.values).zip(allowed).all(|((a, b), allowed)| {
        let count = if dies { a.len().min(b.len()) / 2 } else { a.len() };
        a[..count].iter().zip(b).all(|(a, b)| (a - b).abs() <= *allowed)
    })
}
