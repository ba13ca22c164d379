//! Equation error channel by channel, as the seed paper fits (its section 2.2).

use super::answer::Estimate;
use super::data::Data;
use super::equation_error::{EquationErrorFit, Preparation, bound, pose, singular, solve};
use super::error::FitError;
use super::minimize::{Ending, Limits};
use super::specification::ParameterSpec;
use crate::record::Record;
use runtime::Model;
use sim::Hold;

/// Fits one coordinate's equation after the other, each by the parameters that act in it and that no equation before has told: the way of
/// the seed paper, section 2.2. Parameters of the day are fitted as one value for all records.
///
/// # Errors
/// As [`super::equation_error()`].
pub fn channel_by_channel(
    model: &dyn Model,
    specs: &[ParameterSpec],
    records: &[Record],
    preparation: Preparation,
    hold: Hold,
) -> Result<EquationErrorFit, FitError> {
    let data = bound(model, specs, records, preparation, hold)?;
    let mut left = specs.to_vec();
    let mut found: Vec<Estimate> = Vec::new();
    let (mut evaluations, mut ending) = (0, Ending::Exact);
    for channel in 0..model.dimensions().coordinates {
        let acting = acting(model, &left, &data, preparation, channel)?;
        if acting.is_empty() {
            continue;
        }
        let own: Vec<ParameterSpec> =
            left.iter().enumerate().map(|(i, s)| ParameterSpec { free: acting.contains(&i), per_record: false, ..s.clone() }).collect();
        let (problem, minimum) = solve(model, &own, &data, (preparation, Some(channel)), &Limits::default())?;
        let estimates = problem.estimates(&minimum, &data)?;
        evaluations += problem.evaluations;
        if !minimum.ending.converged() || ending == Ending::Exact {
            ending = minimum.ending;
        }
        for e in estimates {
            for s in left.iter_mut().filter(|s| s.name == e.name) {
                (s.value, s.free) = (e.value, false);
            }
            found.push(Estimate { initial: specs.iter().find(|s| s.name == e.name).map_or(e.initial, |s| s.value), ..e });
        }
    }
    // what acts in no equation stays as it is, and is not told
    let p: Vec<f64> = left.iter().map(|s| s.value).collect();
    for (i, s) in left.iter().enumerate().filter(|(_, s)| s.free) {
        let unit = model.names().parameter_unit(i).to_owned();
        let none = Estimate {
            name: s.name.clone(),
            record: None,
            unit,
            value: s.value,
            std_error: None,
            ci95: None,
            initial: s.value,
            at_bound: false,
        };
        found.push(none);
    }
    found.sort_by_key(|e| specs.iter().position(|s| s.name == e.name));
    let fixed: Vec<ParameterSpec> = left.iter().map(|s| ParameterSpec { free: false, ..s.clone() }).collect();
    let (problem, _) = solve(model, &fixed, &data, (preparation, None), &Limits::default())?;
    let error_percent = problem.rows(&[]).1;
    Ok(EquationErrorFit { parameters: found, p_of_record: vec![p; data.len()], error_percent, ending, evaluations })
}

/// Free parameters that act in a coordinate's equation.
fn acting(
    model: &dyn Model,
    specs: &[ParameterSpec],
    data: &[Data],
    preparation: Preparation,
    channel: usize,
) -> Result<Vec<usize>, FitError> {
    let (problem, start) = pose(model, specs, data, preparation, None)?;
    let (n, m) = (model.dimensions().coordinates, problem.parameters.len());
    let mut acts = vec![false; m];
    for r in 0..problem.records.len() {
        let equations = problem.equations(&start, r).ok_or_else(singular)?;
        for slopes in equations.slopes.chunks(m.max(1)).skip(channel).step_by(n) {
            acts.iter_mut().zip(slopes).for_each(|(acts, s)| *acts |= *s != 0.0);
        }
    }
    Ok(problem.parameters.iter().zip(acts).filter(|(_, acts)| *acts).map(|(i, _)| *i).collect())
}
