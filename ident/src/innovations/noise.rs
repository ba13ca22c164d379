//! Sizes of the noises: what pushes the rig and what blurs its outputs.

use super::filter::{Column, Pass, Track, pass};
use crate::fit::data::{Data, spread};
use crate::parallel::in_parallel;
use crate::spectrum::of_symmetric;
use nalgebra::{DMatrix, DVector};
use runtime::Model;

/// A number of a friction law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Level {
    /// A parameter of the model.
    Parameter(usize),
    /// A part of a parameter.
    Part(usize, f64),
    /// A value (SI).
    Value(f64),
}

impl Level {
    pub(super) fn of(self, p: &[f64]) -> f64 {
        match self {
            Self::Parameter(i) => p.get(i).copied().unwrap_or(0.0).abs(),
            Self::Part(i, part) => (part * p.get(i).copied().unwrap_or(0.0)).abs(),
            Self::Value(value) => value.abs(),
        }
    }
}

/// Dry friction on a coordinate. Where the coordinate stands or turns, the friction takes any value up to its level and a smooth law says
/// little: within its width and the rate's uncertainty it is random.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dry {
    /// The random force of that coordinate (index into [`Noise::entries`]).
    pub entry: usize,
    /// State that is the rate.
    pub rate: usize,
    /// Level of the friction.
    pub level: Level,
    /// Width of the smooth law, in the rate's unit.
    pub width: Level,
}

/// Random forces on the coordinates, and noise of the outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// Parameters of the model by which the forces enter.
    pub entries: Vec<usize>,
    /// Standard deviation of each force, in the unit of its parameter.
    pub sd: Vec<f64>,
    /// Correlation time of each [s].
    pub time: Vec<f64>,
    /// Standard deviation of each output's noise (SI), by output of the model.
    pub output_sd: Vec<f64>,
    /// Dry friction.
    pub dry: Vec<Dry>,
}

/// Least and largest noise of an output, in standard deviations of its encoder's steps (or 1e-5 of its spread).
const OUTPUT: (f64, f64) = (1.0, 30.0);
/// An output whose sensor is noisier may have this many times what its samples show as white.
const WHITE: f64 = 2.0;

impl Noise {
    /// A start: forces that move the rates by a twentieth of their spread within a fifth of a second.
    #[must_use]
    pub fn guess(model: &dyn Model, p: &[f64], tracks: &[Track], entries: Vec<usize>) -> Self {
        let d = model.dimensions();
        let floor = floors(model, p, tracks);
        let mut jacobian = vec![0.0; d.states() * d.parameters];
        let mut sd = vec![1.0; entries.len()];
        if let Some(track) = tracks.first() {
            let t = track.times()[0];
            // it may come from a model with other states
            if model.parameter_jacobian(t, &track.begun(model, p).initial, &track.inputs(model, p, t), p, &mut jacobian).is_ok() {
                let span = track.times()[track.times().len() - 1] - t;
                for (sd, &entry) in sd.iter_mut().zip(&entries) {
                    let reach = (0..d.states()).map(|i| jacobian[i * d.parameters + entry].abs()).fold(0.0, f64::max);
                    let moved = track.measured().map(|(_, v)| spread_of(v)).fold(0.0, f64::max);
                    let rate = moved * 8.0 / span.min(10.0);
                    *sd = 0.05 * rate / 0.2 / if reach > 0.0 { reach } else { 1.0 };
                }
            }
        }
        Self { time: vec![0.2; entries.len()], entries, sd, output_sd: floor, dry: Vec::new() }
    }

    fn get(&self, k: usize) -> f64 {
        let nd = self.sd.len();
        match k {
            k if k < nd => self.sd[k],
            k if k < 2 * nd => self.time[k - nd],
            k => self.output_sd[k - 2 * nd],
        }
    }

    fn set(&mut self, k: usize, value: f64) {
        let nd = self.sd.len();
        match k {
            k if k < nd => self.sd[k] = value,
            k if k < 2 * nd => self.time[k - nd] = value,
            k => self.output_sd[k - 2 * nd] = value,
        }
    }
}

fn spread_of(values: &[f64]) -> f64 {
    let finite: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    if finite.is_empty() { 0.0 } else { spread(&finite) }
}

/// The least noise of each output: that of its encoder's steps, declared or seen.
pub(crate) fn floors(model: &dyn Model, p: &[f64], tracks: &[Track]) -> Vec<f64> {
    (0..model.dimensions().outputs)
        .map(|i| {
            // a text that says nothing of an encoder: the steps that are seen
            let declared = model.output_path(i, p).quantum;
            let quantum = if declared > 0.0 { declared } else { over(tracks, i, |data| &data.steps) };
            (quantum / 12_f64.sqrt()).max(1e-5 * spread_over(tracks, i)).max(1e-12)
        })
        .collect()
}

/// The noise of maximum likelihood, searched from `from` along its logarithms one after the other with steps that halve from the coarsest to the finest
/// (R. Hooke and T. A. Jeeves, "Direct search", 1961). An output's noise may be as large as 30 steps of its encoder, or as `blur`
/// times its spread if that is more. `None` where the model cannot be followed.
#[must_use]
pub fn likeliest(
    model: &dyn Model,
    p: &[Vec<f64>],
    tracks: &[Track],
    from: &Noise,
    (coarsest, finest): (f64, f64),
    blur: f64,
) -> Option<Noise> {
    let (mut parts, mut values) = (Vec::new(), Vec::new());
    for (track, p) in tracks.iter().zip(p) {
        // the noise of a rig does not need all samples to be known
        let samples = track.times().len();
        let wanted = (MOST_SAMPLES / tracks.len()).max(400);
        // windows spread over the record, an even number for two cores
        let windows = (wanted / 500).clamp(1, 2) * 2;
        let length = wanted.min(samples) / windows;
        for w in 0..windows {
            let at = (samples - length) * (2 * w + 1) / (2 * windows);
            parts.push(track.part(at, at + length, model, p));
            values.push(p.clone());
        }
    }
    let (nd, range) = (from.sd.len(), Range::of(model, p.first()?, tracks, blur));
    let seen = seen(model, tracks);
    let bounds = |k: usize| match k {
        k if k < nd => (1e-9, f64::INFINITY),
        k if k < 2 * nd => range.time,
        k => range.output[k - 2 * nd],
    };
    let constants: Vec<Column<'_>> = from.entries.iter().map(|&i| Column::Parameter(i)).collect();
    let likelihood = |noise: &Noise| -> f64 {
        let each = in_parallel(&parts, |i, part| pass(model, &values[i], part, noise, &constants).ok().flatten());
        each.into_iter().collect::<Option<Vec<Pass>>>().map_or(f64::NEG_INFINITY, |passes| restricted(&passes, nd))
    };
    let unknowns: Vec<usize> = (0..2 * nd).chain(seen.iter().map(|i| 2 * nd + i)).collect();
    // a slow motion sees sd^2 times time alone: along that ridge both move together
    let alone = unknowns.iter().map(|&k| (k, None));
    let directions: Vec<(usize, Option<usize>)> = alone.chain((0..nd).map(|k| (nd + k, Some(k)))).collect();
    let mut best = from.clone();
    for &k in &unknowns {
        let (lo, hi) = bounds(k);
        best.set(k, best.get(k).clamp(lo, hi));
    }
    let mut value = likelihood(&best);
    let mut step = coarsest;
    while step > finest {
        let mut moved = false;
        for &(k, with) in &directions {
            let (lo, hi) = bounds(k);
            for sign in [1.0, -1.0] {
                let mut went = false;
                loop {
                    let mut other = best.clone();
                    let to = (best.get(k) * (sign * step).exp()).clamp(lo, hi);
                    if to == best.get(k) {
                        break;
                    }
                    other.set(k, to);
                    if let Some(sd) = with {
                        other.set(sd, best.get(sd) * (best.get(k) / to).sqrt());
                    }
                    let at = likelihood(&other);
                    if at > value + 0.05 {
                        (best, value, went, moved) = (other, at, true, true);
                    } else {
                        break;
                    }
                }
                if went {
                    break;
                }
            }
        }
        if !moved {
            step *= 0.5;
        }
    }
    value.is_finite().then_some(best)
}

/// Restricted likelihood (H. D. Patterson and R. Thompson, Biometrika 58, 1971): what a constant force on each coordinate would explain is left
/// out, so that no slow random force stands for it. The derivatives of the passes are those by these forces.
fn restricted(passes: &[Pass], count: usize) -> f64 {
    let mut value: f64 = passes.iter().map(Pass::log_likelihood).sum();
    let (mut normal, mut right) = (DMatrix::<f64>::zeros(count, count), DVector::<f64>::zeros(count));
    for pass in passes {
        for (z, row) in pass.z.iter().zip(pass.jacobian.chunks_exact(count.max(1))) {
            let row = DVector::from_column_slice(row);
            right.axpy(*z, &row, 1.0);
            normal.ger(1.0, &row, &row, 1.0);
        }
    }
    let eigen = if count > 0 { of_symmetric(normal) } else { return value };
    let largest = eigen.eigenvalues.max();
    for (direction, &information) in eigen.eigenvectors.column_iter().zip(eigen.eigenvalues.iter()) {
        if information > 1e-12 * largest {
            value += 0.5 * direction.dot(&right).powi(2) / information - 0.5 * information.ln();
        }
    }
    value
}

/// Between what the sizes of noises are looked for.
#[derive(Clone, Debug)]
pub(crate) struct Range {
    /// Correlation times of the forces [s].
    pub time: (f64, f64),
    /// Noise of each output (SI).
    pub output: Vec<(f64, f64)>,
}

impl Range {
    /// For these records.
    pub fn of(model: &dyn Model, p: &[f64], tracks: &[Track], blur: f64) -> Self {
        let duration = |t: &Track| t.times()[t.times().len() - 1] - t.times()[0];
        let period = tracks.iter().map(|t| duration(t) / (t.times().len() - 1) as f64).fold(f64::INFINITY, f64::min);
        let shortest = tracks.iter().map(duration).fold(f64::INFINITY, f64::min);
        let output = floors(model, p, tracks)
            .into_iter()
            .enumerate()
            .map(|(i, floor)| {
                let white = WHITE * over(tracks, i, |data| &data.white);
                (OUTPUT.0 * floor, (OUTPUT.1 * floor).max(blur * spread_over(tracks, i)).max(white))
            })
            .collect();
        Self { time: (period, (0.1 * shortest).clamp(2.0 * period, f64::max(2.0 * period, 2.0))), output }
    }
}

/// Outputs that a record has.
pub(crate) fn seen(model: &dyn Model, tracks: &[Track]) -> Vec<usize> {
    (0..model.dimensions().outputs).filter(|&i| tracks.iter().any(|t| t.measured().any(|(o, _)| o == i))).collect()
}

/// The largest of what the records' data say of an output.
fn over(tracks: &[Track], output: usize, of: impl Fn(&Data) -> &Vec<f64>) -> f64 {
    let each = tracks.iter().flat_map(|t| t.data.outputs.iter().zip(of(&t.data)));
    each.filter(|(o, _)| **o == output).map(|(_, value)| *value).fold(0.0, f64::max)
}

/// Largest spread of an output over the records.
fn spread_over(tracks: &[Track], output: usize) -> f64 {
    tracks.iter().flat_map(Track::measured).filter(|(o, _)| *o == output).map(|(_, v)| spread_of(v)).fold(0.0, f64::max)
}

/// Samples from which the noise is found.
const MOST_SAMPLES: usize = 3000;
