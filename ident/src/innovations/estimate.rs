//! Parameters from innovations: noise and parameters in turn, gains held within each search.

use super::filter::{Column, Filtering, Gains, Pass, Track, run};
use super::noise::{Noise, likeliest};
use crate::fit::covariance;
use crate::fit::minimize::{Evaluation, LevenbergMarquardt, Limits, Minimizer, Objective};
use crate::fit::objective::Rows;
use crate::fit::{FitError, ParameterSpec};
use crate::parallel::in_parallel;
use crate::spectrum::of_symmetric;
use nalgebra::{DMatrix, DVector};
use runtime::Model;

/// One fitted number.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// Parameter.
    pub parameter: usize,
    /// Record, for a parameter of the day.
    pub record: Option<usize>,
    /// Value (SI).
    pub value: f64,
    /// Standard error, if the innovations are as the noise says.
    pub sd: f64,
    /// Standard error that allows for innovations that hang together or are larger than that (never less than `sd`); the same where the
    /// noise was not fitted.
    pub robust_sd: f64,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Estimated {
    /// Parameters of each record.
    pub p: Vec<Vec<f64>>,
    /// Fitted numbers.
    pub unknowns: Vec<Unknown>,
    /// Covariance in their order.
    pub covariance: DMatrix<f64>,
    /// Noise.
    pub noise: Noise,
    /// Logarithm of the likelihood over all records.
    pub log_likelihood: f64,
    /// Whitened innovations.
    pub samples: usize,
}

/// How much work is spent.
#[derive(Clone, Copy, Debug)]
pub struct EstimateOptions {
    /// Rounds of noise and parameters; none: parameters alone, once, with the noise as it is.
    pub rounds: usize,
    /// Finest step of the noise's logarithms.
    pub finest: f64,
    /// Evaluations of each search.
    pub evaluations: usize,
    /// Largest noise of an output in parts of its spread, where that is more than 30 steps of its encoder.
    pub blur: f64,
}

impl Default for EstimateOptions {
    fn default() -> Self {
        Self { rounds: 4, finest: 0.1, evaluations: 12, blur: 0.0 }
    }
}

struct Problem<'a> {
    model: &'a dyn Model,
    tracks: &'a [Track],
    specs: &'a [ParameterSpec],
    noise: Noise,
    gains: Vec<Gains>,
    base: Vec<Vec<f64>>,
    unknowns: Vec<(usize, Option<usize>)>,
}

impl Problem<'_> {
    fn parameters(&self, x: &[f64]) -> Vec<Vec<f64>> {
        let mut p = self.base.clone();
        for (&(i, record), &value) in self.unknowns.iter().zip(x) {
            match record {
                Some(r) => p[r][i] = value,
                None => p.iter_mut().for_each(|p| p[i] = value),
            }
        }
        p
    }

    fn passes(&self, p: &[Vec<f64>], columns: &[Column<'_>], frozen: bool) -> Option<Vec<Pass>> {
        let each = in_parallel(self.tracks, |r, track| {
            let filtering = if frozen { Filtering::Frozen(&self.gains[r]) } else { Filtering::Riccati };
            run(self.model, &p[r], &track.begun(self.model, &p[r]), &self.noise, columns, &filtering, &mut |_| {}).ok().flatten()
        });
        each.into_iter().collect()
    }
}

impl Problem<'_> {
    /// Free parameters, each once.
    fn free(&self) -> Vec<usize> {
        let mut parameters: Vec<usize> = self.unknowns.iter().map(|u| u.0).collect();
        parameters.sort_unstable();
        parameters.dedup();
        parameters
    }

    /// Standard errors from how the scores of all samples hang together; `None` where the model cannot be followed.
    fn robust(&self, x: &[f64], normal: &DMatrix<f64>) -> Option<Vec<f64>> {
        let free = self.free();
        let columns: Vec<Column<'_>> = free.iter().map(|&i| Column::Parameter(i)).collect();
        let passes = self.passes(&self.parameters(x), &columns, true)?;
        let rows: Vec<Rows> = passes
            .iter()
            .zip(self.tracks)
            .enumerate()
            .map(|(record, (pass, track))| {
                let of: Vec<(usize, usize)> = (0..self.unknowns.len())
                    .filter(|&k| self.unknowns[k].1.is_none_or(|r| r == record))
                    .filter_map(|k| Some((k, free.iter().position(|i| *i == self.unknowns[k].0)?)))
                    .collect();
                let outputs: Vec<usize> = track.measured().map(|(o, _)| o).collect();
                let (m, width, count) = (of.len(), outputs.len(), track.times().len());
                let mut rows = Rows {
                    record,
                    times: track.times().to_vec(),
                    outputs: width,
                    errors: vec![0.0; count * width],
                    slopes: vec![1.0; count * width],
                    jacobian: vec![0.0; count * width * m],
                    columns: of.iter().map(|(k, _)| *k).collect(),
                };
                let innovations = pass.at.iter().zip(&pass.z).zip(pass.jacobian.chunks_exact(free.len()));
                for ((&(sample, output), &z), by) in innovations {
                    let Some(place) = outputs.iter().position(|o| *o == output) else { continue };
                    let at = sample * width + place;
                    rows.errors[at] = z;
                    rows.jacobian[at * m..(at + 1) * m].iter_mut().zip(&of).for_each(|(to, (_, c))| *to = by[*c]);
                }
                rows
            })
            .collect();
        let found = covariance::covariance(&rows, normal, &vec![false; self.unknowns.len()]);
        Some((0..x.len()).map(|k| found.matrix[(k, k)].max(0.0).sqrt() * found.factor / 1.96).collect())
    }
}

impl Objective for Problem<'_> {
    fn unknowns(&self) -> usize {
        self.unknowns.len()
    }
    fn bounds(&self, i: usize) -> (f64, f64) {
        self.specs[self.unknowns[i].0].bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY))
    }
    fn size(&self, i: usize) -> f64 {
        let s = &self.specs[self.unknowns[i].0];
        if s.value != 0.0 { s.value.abs() } else { s.prior_sd.unwrap_or(1.0) }
    }
    fn evaluate(&mut self, x: &[f64]) -> Option<Evaluation> {
        let p = self.parameters(x);
        let parameters = self.free();
        let columns: Vec<Column<'_>> = parameters.iter().map(|&i| Column::Parameter(i)).collect();
        let passes = self.passes(&p, &columns, true)?;
        let m = self.unknowns.len();
        let mut total = Evaluation { cost: 0.0, gradient: DVector::zeros(m), normal: DMatrix::zeros(m, m) };
        for (r, pass) in passes.iter().enumerate() {
            // columns of this record, in the order of the unknowns
            let of: Vec<(usize, usize)> = self
                .unknowns
                .iter()
                .enumerate()
                .filter(|(_, (_, record))| record.is_none_or(|record| record == r))
                .filter_map(|(k, (i, _))| parameters.iter().position(|j| j == i).map(|c| (k, c)))
                .collect();
            for (z, row) in pass.z.iter().zip(pass.jacobian.chunks_exact(columns.len().max(1))) {
                total.cost += 0.5 * z * z;
                for &(a, ca) in &of {
                    total.gradient[a] += z * row[ca];
                    for &(b, cb) in &of {
                        total.normal[(a, b)] += row[ca] * row[cb];
                    }
                }
            }
        }
        for (k, &(i, _)) in self.unknowns.iter().enumerate() {
            if let Some(sd) = self.specs[i].prior_sd {
                let z = (x[k] - self.specs[i].prior_mean) / sd;
                total.cost += 0.5 * z * z;
                total.gradient[k] += z / sd;
                total.normal[(k, k)] += 1.0 / (sd * sd);
            }
        }
        total.cost.is_finite().then_some(total)
    }
}

/// Fits the free parameters of `specs`, from `start` (parameters of each record) and `noise`.
///
/// # Errors
/// [`FitError::NoStart`] where the model cannot be followed from there.
pub fn estimate(
    model: &dyn Model,
    specs: &[ParameterSpec],
    tracks: &mut [Track],
    start: &[Vec<f64>],
    noise: Noise,
    options: EstimateOptions,
) -> Result<Estimated, FitError> {
    let nowhere =
        |tracks: &[Track]| FitError::NoStart { file: tracks.first().map_or_else(String::new, |t| t.source().to_owned()), status: None };
    let mut unknowns = Vec::new();
    for (i, s) in specs.iter().enumerate().filter(|(_, s)| s.free) {
        if s.per_record {
            unknowns.extend((0..tracks.len()).map(|r| (i, Some(r))));
        } else {
            unknowns.push((i, None));
        }
    }
    let mut p = start.to_vec();
    // tracks may come from a model with other states
    for (track, p) in tracks.iter_mut().zip(&p) {
        track.begin(model, p);
    }
    let mut noise = noise;
    let mut value = f64::NEG_INFINITY;
    for round in 0..options.rounds.max(1) {
        // the first round comes from far, the others refine
        let steps = if round == 0 { (1.6, 0.7) } else { (0.4, options.finest) };
        if options.rounds > 0 {
            noise = likeliest(model, &p, tracks, &noise, steps, options.blur).ok_or_else(|| nowhere(tracks))?;
        }
        let mut problem =
            Problem { model, tracks, specs, noise: noise.clone(), gains: Vec::new(), base: p.clone(), unknowns: unknowns.clone() };
        let passes = problem.passes(&p, &[], false).ok_or_else(|| nowhere(tracks))?;
        let before: f64 = passes.iter().map(Pass::log_likelihood).sum();
        problem.gains = passes.into_iter().map(|pass| pass.gains).collect();
        if unknowns.is_empty() {
            break;
        }
        let x: Vec<f64> = unknowns.iter().map(|&(i, record)| p[record.unwrap_or(0)][i]).collect();
        let limits = Limits { evaluations: options.evaluations, step: 1e-6, cost: 1e-8, gradient: 1e-6 };
        let found = LevenbergMarquardt.minimize(&mut problem, &x, &limits);
        let moved = problem.parameters(&found.x);
        // gains follow the parameters: kept only where the likelihood agrees
        let after = problem.passes(&moved, &[], false).map_or(f64::NEG_INFINITY, |passes| passes.iter().map(Pass::log_likelihood).sum());
        if after < before - 0.5 && round > 0 {
            break;
        }
        if after.is_finite() {
            p = moved;
            drop(problem);
            for (track, p) in tracks.iter_mut().zip(&p) {
                track.begin(model, p);
            }
        }
        if round > 0 && (after - value).abs() < 0.1 {
            break;
        }
        value = after;
    }
    // at the end: the likelihood and what the parameters are known to
    let mut problem = Problem { model, tracks, specs, noise, gains: Vec::new(), base: p.clone(), unknowns: unknowns.clone() };
    let passes = problem.passes(&p, &[], false).ok_or_else(|| nowhere(problem.tracks))?;
    let log_likelihood = passes.iter().map(Pass::log_likelihood).sum();
    let samples = passes.iter().map(|pass| pass.z.len()).sum();
    problem.gains = passes.into_iter().map(|pass| pass.gains).collect();
    let x: Vec<f64> = unknowns.iter().map(|&(i, record)| p[record.unwrap_or(0)][i]).collect();
    let normal = problem.evaluate(&x).ok_or_else(|| nowhere(problem.tracks))?.normal;
    let covariance = inverse(&normal);
    let robust = if options.rounds > 0 && !x.is_empty() { problem.robust(&x, &normal) } else { None };
    let found = unknowns
        .iter()
        .enumerate()
        .map(|(k, &(parameter, record))| {
            let sd = covariance[(k, k)].max(0.0).sqrt();
            let robust_sd = robust.as_ref().map_or(sd, |r| r[k].max(sd));
            Unknown { parameter, record, value: x[k], sd, robust_sd }
        })
        .collect();
    Ok(Estimated { p, unknowns: found, covariance, noise: problem.noise, log_likelihood, samples })
}

/// Inverse of a normal matrix, scaled; directions without information have an infinite variance on their diagonal.
fn inverse(normal: &DMatrix<f64>) -> DMatrix<f64> {
    let m = normal.nrows();
    if m == 0 {
        return normal.clone();
    }
    let scale: Vec<f64> = (0..m).map(|i| normal[(i, i)].max(0.0).sqrt()).collect();
    let scaled = DMatrix::from_fn(m, m, |i, j| {
        let by = scale[i] * scale[j];
        if by > 0.0 { normal[(i, j)] / by } else { f64::from(u8::from(i == j)) }
    });
    let eigen = of_symmetric(scaled);
    DMatrix::from_fn(m, m, |i, j| {
        let sum: f64 = (0..m).map(|k| eigen.eigenvectors[(i, k)] * eigen.eigenvectors[(j, k)] / eigen.eigenvalues[k].max(1e-12)).sum();
        let by = scale[i] * scale[j];
        if by > 0.0 {
            sum / by
        } else if i == j {
            f64::INFINITY
        } else {
            0.0
        }
    })
}

/// Whitened innovations beyond this count by their magnitude (Huber): a few samples must not speak for a record.
pub const TAIL: f64 = 3.0;

/// Likelihood of a record with given parameters and noise: the sum over outputs of each sample's logarithm, by sample, with Huber's
/// tails; `None` where the model cannot be followed.
///
/// # Errors
/// As [`super::pass`].
pub fn likelihood(model: &dyn Model, p: &[f64], track: &Track, noise: &Noise) -> Result<Option<Vec<f64>>, FitError> {
    let Some(pass) = run(model, p, &track.begun(model, p), noise, &[], &Filtering::Riccati, &mut |_| {})? else { return Ok(None) };
    let mut by_sample = vec![0.0; track.times().len()];
    for (i, (&(k, _), z)) in pass.at.iter().zip(&pass.z).enumerate() {
        let loss = if z.abs() <= TAIL { 0.5 * z * z } else { TAIL * (z.abs() - 0.5 * TAIL) };
        by_sample[k] -= loss + pass.gains.sd[i].ln();
    }
    Ok(Some(by_sample))
}
