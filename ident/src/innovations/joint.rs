//! Parameters and noises together: the likelihood's own maximum, and what it says of all of them.
//!
//! [`super::estimate`] holds the gains while it searches; gains that follow the parameters move the maximum a little, and standard
//! errors more. Here gains follow. Innovations e with variance s^2 have the cost sum (e/s)^2/2 + ln s, which is that of two errors a
//! sample, e/s and (1 - (e/s)^2)/sqrt 2, with the derivatives e'/s and sqrt 2 (ln s)': the same Gauss-Newton matrix (Fisher's) and the same
//! gradient. Derivatives through the gains are central differences of passes over a fraction of a standard error, since second
//! derivatives of the model would be needed otherwise.

use super::filter::{Filtering, Pass, Track, run};
use super::noise::{Noise, Range, seen};
use crate::fit::ParameterSpec;
use crate::fit::minimize::{Evaluation, Objective};
use crate::fit::objective::Rows;
use crate::parallel::in_parallel;
use nalgebra::{DMatrix, DVector};
use runtime::Model;
use std::f64::consts::SQRT_2;

/// What an unknown is. Noises are searched by their logarithms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Parameter, and its record where it is one of the day.
    Parameter(usize, Option<usize>),
    /// Standard deviation of the k-th force.
    Size(usize),
    /// Its correlation time.
    Time(usize),
    /// Noise of an output of the model.
    Output(usize),
}

/// Step of differences, in standard errors.
const STEP: f64 = 0.3;
/// Step where no standard error is known, in parts of the unknown's size, or of a logarithm.
const FIRST_STEP: f64 = 1e-3;
/// How far below its start the logarithm of a force's size may go: it would be without effect there.
const BELOW: f64 = 5.0;

/// The likelihood of all records.
pub(crate) struct Joint<'a> {
    model: &'a dyn Model,
    tracks: &'a [Track],
    specs: &'a [ParameterSpec],
    base: Vec<Vec<f64>>,
    noise: Noise,
    pub kinds: Vec<Kind>,
    bounds: Vec<(f64, f64)>,
    steps: Vec<f64>,
    /// Logarithms of the innovations' standard deviations at the start, by record: so that costs are near half the samples.
    from: Vec<f64>,
    /// Evaluations, each a run over all records for each unknown.
    pub evaluations: usize,
}

impl<'a> Joint<'a> {
    /// At parameters and noise to start from; `sd` are standard errors of the parameters there. `None` where the model cannot be followed.
    pub fn new(
        model: &'a dyn Model,
        specs: &'a [ParameterSpec],
        tracks: &'a [Track],
        p: &[Vec<f64>],
        noise: &Noise,
        (blur, sd): (f64, &dyn Fn(usize, Option<usize>) -> f64),
    ) -> Option<(Self, Vec<f64>)> {
        let range = Range::of(model, p.first()?, tracks, blur);
        let logs = |(lo, hi): (f64, f64)| (lo.ln(), hi.ln());
        let (mut kinds, mut bounds, mut steps, mut x) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut add = |kind: Kind, value: f64, within: (f64, f64), step: f64| {
            kinds.push(kind);
            bounds.push(within);
            steps.push(step);
            x.push(value.max(within.0).min(within.1));
        };
        for (i, s) in specs.iter().enumerate().filter(|(_, s)| s.free) {
            let own: Vec<Option<usize>> = if s.per_record { (0..tracks.len()).map(Some).collect() } else { vec![None] };
            for record in own {
                let value = p[record.unwrap_or(0)][i];
                let error = STEP * sd(i, record);
                let size = FIRST_STEP * if value != 0.0 { value.abs() } else { 1.0 };
                let step = if error.is_finite() && error > 0.0 { error.min(1e3 * size) } else { size };
                add(Kind::Parameter(i, record), value, s.bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY)), step);
            }
        }
        for k in 0..noise.sd.len() {
            let size = noise.sd[k].ln();
            add(Kind::Size(k), size, (size - BELOW, f64::INFINITY), 0.02);
            add(Kind::Time(k), noise.time[k].ln(), logs(range.time), 0.02);
        }
        for o in seen(model, tracks) {
            add(Kind::Output(o), noise.output_sd[o].ln(), logs(range.output[o]), 0.02);
        }
        let from = vec![0.0; tracks.len()];
        let mut joint = Self { model, tracks, specs, base: p.to_vec(), noise: noise.clone(), kinds, bounds, steps, from, evaluations: 0 };
        let passes = (0..tracks.len()).map(|r| joint.pass(&x, r)).collect::<Option<Vec<_>>>()?;
        joint.from = passes.iter().map(|pass| 0.5 * pass.log_variance).collect();
        Some((joint, x))
    }

    /// Parameters of record `record`.
    pub fn parameters(&self, x: &[f64], record: usize) -> Vec<f64> {
        let mut p = self.base[record].clone();
        for (kind, &value) in self.kinds.iter().zip(x) {
            match kind {
                Kind::Parameter(i, of) if of.is_none_or(|of| of == record) => p[*i] = value,
                _ => {}
            }
        }
        p
    }

    /// Noises.
    pub fn noise(&self, x: &[f64]) -> Noise {
        let mut noise = self.noise.clone();
        for (kind, &value) in self.kinds.iter().zip(x) {
            match *kind {
                Kind::Parameter(..) => {}
                Kind::Size(k) => noise.sd[k] = value.exp(),
                Kind::Time(k) => noise.time[k] = value.exp(),
                Kind::Output(o) => noise.output_sd[o] = value.exp(),
            }
        }
        noise
    }

    fn pass(&self, x: &[f64], record: usize) -> Option<Pass> {
        let (p, noise) = (self.parameters(x, record), self.noise(x));
        run(self.model, &p, &self.tracks[record], &noise, &[], &Filtering::Riccati, &mut |_| {}).ok().flatten()
    }

    /// Unknowns that stand at a bound.
    pub fn held(&self, x: &[f64]) -> Vec<bool> {
        x.iter().zip(&self.bounds).map(|(x, (lo, hi))| x <= lo || x >= hi).collect()
    }

    /// Differences are taken over parts of these standard errors from now on.
    pub fn known_to(&mut self, sd: &[f64]) {
        for ((step, sd), kind) in self.steps.iter_mut().zip(sd).zip(&self.kinds) {
            let largest = if matches!(kind, Kind::Parameter(..)) { f64::INFINITY } else { 0.1 };
            if *sd > 0.0 && sd.is_finite() {
                *step = (STEP * sd).min(largest);
            }
        }
    }

    /// Both errors of each innovation with their derivatives, two for each measured output; records one after the other.
    pub fn rows(&mut self, x: &[f64]) -> Option<Vec<Rows>> {
        self.evaluations += 1;
        // (record, unknown and sign): the middle first, then both sides of each unknown
        let ends: Vec<(f64, f64)> =
            (0..x.len()).map(|k| ((x[k] - self.steps[k]).max(self.bounds[k].0), (x[k] + self.steps[k]).min(self.bounds[k].1))).collect();
        let mut jobs: Vec<(usize, Option<(usize, f64)>)> = Vec::new();
        for r in 0..self.tracks.len() {
            jobs.push((r, None));
            for (k, kind) in self.kinds.iter().enumerate() {
                if !matches!(kind, Kind::Parameter(_, Some(of)) if *of != r) {
                    jobs.extend([(r, Some((k, ends[k].0))), (r, Some((k, ends[k].1)))]);
                }
            }
        }
        let passes = in_parallel(&jobs, |_, (r, change)| {
            let mut x = x.to_vec();
            if let Some((k, value)) = change {
                x[*k] = *value;
            }
            self.pass(&x, *r)
        });
        let passes = passes.into_iter().collect::<Option<Vec<_>>>()?;
        let mut found = Vec::new();
        let mut at = 0;
        for (r, track) in self.tracks.iter().enumerate() {
            let own: Vec<usize> = (at..jobs.len()).take_while(|&j| jobs[j].0 == r).collect();
            at += own.len();
            let middle = &passes[*own.first()?];
            let columns: Vec<usize> = own.iter().skip(1).step_by(2).filter_map(|&j| Some(jobs[j].1?.0)).collect();
            let outputs: Vec<usize> = track.measured().map(|(o, _)| o).collect();
            let (m, width, count) = (columns.len(), 2 * outputs.len(), track.times().len());
            let mut rows = Rows {
                record: r,
                times: track.times().to_vec(),
                outputs: width,
                errors: vec![0.0; count * width],
                slopes: vec![1.0; count * width],
                jacobian: vec![0.0; count * width * m],
                columns: columns.clone(),
            };
            for (i, &(sample, output)) in middle.at.iter().enumerate() {
                let Some(place) = outputs.iter().position(|&o| o == output) else { continue };
                let (z, sd) = (middle.z[i], middle.gains.sd[i]);
                let first = sample * width + 2 * place;
                rows.errors[first] = z;
                rows.errors[first + 1] = (1.0 - z * z) / SQRT_2;
                for (c, &k) in columns.iter().enumerate() {
                    let (below, above) = (&passes[own[1 + 2 * c]], &passes[own[2 + 2 * c]]);
                    let step = ends[k].1 - ends[k].0;
                    if step <= 0.0 || i >= below.z.len() || i >= above.z.len() {
                        continue;
                    }
                    let error = |pass: &Pass| pass.z[i] * pass.gains.sd[i];
                    rows.jacobian[first * m + c] = (error(above) - error(below)) / (step * sd);
                    rows.jacobian[(first + 1) * m + c] = SQRT_2 * (above.gains.sd[i] / below.gains.sd[i]).ln() / step;
                }
            }
            found.push(rows);
        }
        Some(found)
    }

    /// Cost of the logarithms at `x`, against that of the start.
    fn logarithms(&self, x: &[f64]) -> Option<f64> {
        (0..self.tracks.len()).map(|r| Some(0.5 * self.pass(x, r)?.log_variance - self.from[r])).sum()
    }

    /// Minus the logarithm of the likelihood, without priors and the constant of 2 pi.
    pub fn cost(&self, x: &[f64]) -> Option<f64> {
        (0..self.tracks.len()).map(|r| Some(-self.pass(x, r)?.log_likelihood())).sum()
    }
}

impl Objective for Joint<'_> {
    fn unknowns(&self) -> usize {
        self.kinds.len()
    }

    fn bounds(&self, i: usize) -> (f64, f64) {
        self.bounds[i]
    }

    fn size(&self, i: usize) -> f64 {
        match self.kinds[i] {
            Kind::Parameter(i, _) => crate::fit::typical(&self.specs[i]),
            _ => 1.0,
        }
    }

    fn evaluate(&mut self, x: &[f64]) -> Option<Evaluation> {
        let rows = self.rows(x)?;
        let n = x.len();
        let mut total = Evaluation { cost: self.logarithms(x)?, gradient: DVector::zeros(n), normal: DMatrix::zeros(n, n) };
        for rows in &rows {
            let m = rows.columns.len();
            for (i, (error, j)) in rows.errors.iter().zip(rows.jacobian.chunks_exact(m.max(1))).enumerate() {
                // the second error of each pair has no share in the cost but through the logarithm
                if i % 2 == 0 {
                    total.cost += 0.5 * error * error;
                }
                for (a, &ka) in rows.columns.iter().enumerate() {
                    total.gradient[ka] += error * j[a];
                    for (b, &kb) in rows.columns.iter().enumerate() {
                        total.normal[(ka, kb)] += j[a] * j[b];
                    }
                }
            }
        }
        for (k, kind) in self.kinds.iter().enumerate() {
            if let Kind::Parameter(i, _) = *kind
                && let Some(sd) = self.specs[i].prior_sd
            {
                let z = (x[k] - self.specs[i].prior_mean) / sd;
                total.cost += 0.5 * z * z;
                total.gradient[k] += z / sd;
                total.normal[(k, k)] += 1.0 / (sd * sd);
            }
        }
        total.cost.is_finite().then_some(total)
    }
}
