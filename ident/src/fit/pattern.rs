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

/// The pattern with the fewest evaluations of the model whose outputs agree with those of half its step to within
/// `allowed`. Where the run does not come to its end the agreement is judged up to there.
pub(crate) fn choose(model: &dyn Model, p: &[f64], runs: &[Run], data: &Data, allowed: &[f64]) -> Result<Pattern, FitError> {
    let period = data.times[data.times.len() - 1] - data.times[0];
    let period = period / (data.times.len() - 1) as f64;
    let mut best: Option<(usize, Pattern)> = None;
    for method in [FixedMethod::DormandPrince, FixedMethod::Classical] {
        let mut step = 32.0 * period;
        let mut coarse = outputs(model, p, runs, data, Pattern { method, step })?;
        for _ in 0..14 {
            let work = coarse.steps * stages(method);
            if best.is_some_and(|(least, _)| work >= least) {
                break;
            }
            let fine = outputs(model, p, runs, data, Pattern { method, step: 0.5 * step })?;
            if agree(&coarse, &fine, allowed) {
                best = Some((work, Pattern { method, step }));
                break;
            }
            step *= 0.5;
            coarse = fine;
        }
    }
    // nothing agrees: the model is not smooth at any of these steps; the finest is as good as any
    Ok(best.map_or(Pattern { method: FixedMethod::Classical, step: period / 64.0 }, |(_, pattern)| pattern))
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
    let coarse = outputs(model, p, runs, data, pattern)?;
    let fine = outputs(model, p, runs, data, Pattern { step: 0.5 * pattern.step, ..pattern })?;
    Ok(agree(&coarse, &fine, allowed))
}

struct Outputs {
    values: Vec<Vec<f64>>,
    status: Status,
    steps: usize,
}

fn outputs(model: &dyn Model, p: &[f64], runs: &[Run], data: &Data, pattern: Pattern) -> Result<Outputs, FitError> {
    let mut values: Vec<Vec<f64>> = data.outputs.iter().map(|_| Vec::new()).collect();
    let (mut status, mut steps) = (Status::Completed, 0);
    for run in runs {
        let mut forward = Forward::new(model, &data.signals, &data.times[run.from..=run.to], &data.outputs, &[], 0, pattern)?;
        let ended = forward.run(p, &run.x0, &[], &mut |_, i, y, _| values[i].push(y))?;
        steps += forward.steps();
        if ended != Status::Completed {
            status = ended;
            break;
        }
    }
    Ok(Outputs { values, status, steps })
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
