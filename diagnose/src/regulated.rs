//! Experiments with a rig that falls without its regulator: a linear-quadratic regulator of the model holds it where its records held it,
//! and what is tried is added to the regulator's command. Knows models through their trait.

use control::{LinearModel, LqrDesign, Plant, Sampling, Weight, linearize, lqr};
use nalgebra::{DMatrix, DVector};
use runtime::Model;
use sim::{Hold, Signal, Signals, Status, simulate};

/// Steps towards a balanced state.
const STEPS: usize = 20;
/// Part of the accelerations at the mean that a balanced state may leave.
const BALANCED: f64 = 1e-8;

/// Mean and spread of states and signals of a record.
pub(crate) struct Seen {
    pub x: Vec<f64>,
    pub x_spread: Vec<f64>,
    pub u: Vec<f64>,
    pub u_spread: Vec<f64>,
}

/// u = u* - K (x - x*), sampled.
pub(crate) struct Regulator {
    x: Vec<f64>,
    u: Vec<f64>,
    k: DMatrix<f64>,
}

/// What a run gave, by sample.
pub(crate) struct Driven {
    pub x: Vec<Vec<f64>>,
    /// Signals as applied.
    pub u: Vec<Vec<f64>>,
    /// Outputs as read, without an encoder.
    pub y: Vec<Vec<f64>>,
}

impl Regulator {
    /// About the balanced state that is nearest to the mean of what was seen, each state and input weighed by its spread. `None` where
    /// there is no such state, or no regulator for it.
    pub fn new(model: &dyn Model, p: &[f64], seen: &Seen, period: f64) -> Option<Self> {
        let d = model.dimensions();
        let (x, u) = balanced(model, p, seen)?;
        let own = DMatrix::from_fn(d.signals(), d.inputs, |i, j| f64::from(u8::from(i == j)));
        let slope = |dx: &mut [f64], a: &mut [f64], b: &mut [f64]| model.linearize(0.0, &x, &u, p, dx, a, b);
        let linear: LinearModel = linearize(model, p, &x, &own, slope).ok()?;
        let inputs: Vec<String> = (0..d.inputs).map(|j| model.names().signal(j).to_owned()).collect();
        let weight = |spread: &[f64]| Weight::Diagonal(spread.iter().map(|s| s.powi(-2)).collect());
        let design = LqrDesign {
            states: Vec::new(),
            integrate: Vec::new(),
            weight_x: weight(&seen.x_spread),
            weight_u: weight(&seen.u_spread[..d.inputs]),
            sampling: Sampling::Integral { period },
        };
        let found = lqr(&Plant::new(model, &linear, &inputs), &design).ok()?;
        Some(Self { x, u, k: found.k })
    }

    /// A run from `start` over the samples `t`, with `added` put onto the command of input `j`; `inside` is asked of every state. `None`
    /// where it is left, or the model cannot be followed.
    pub fn run(
        &self,
        (model, p): (&dyn Model, &[f64]),
        (t, start): (&[f64], &[f64]),
        (j, added): (usize, &[f64]),
        inside: impl Fn(&[f64]) -> bool,
    ) -> Option<Driven> {
        let d = model.dimensions();
        let limits: Vec<(f64, f64)> = (0..d.inputs).map(|i| model.input_path(i, p).limits).collect();
        let options = sim::Options { relative: 1e-8, absolute: 1e-10, ..sim::Options::default() };
        let mut driven = Driven { x: vec![start.to_vec()], u: Vec::new(), y: Vec::new() };
        for k in 0..t.len() {
            let off = DVector::from_iterator(self.x.len(), driven.x[k].iter().zip(&self.x).map(|(x, at)| x - at));
            let back = &self.k * off;
            let mut u = self.u.clone();
            for (i, (u, limits)) in u.iter_mut().zip(&limits).enumerate() {
                *u += if i == j { added[k] } else { 0.0 } - back[i];
                *u = u.max(limits.0).min(limits.1);
            }
            driven.u.push(u);
            if k + 1 == t.len() {
                break;
            }
            let ends = [t[k], t[k + 1]];
            let run = simulate(model, p, &driven.x[k], &self.signals(&driven.u, t)?, &ends, &options).ok()?;
            if run.status != Status::Completed || !inside(run.state(1)) {
                return None;
            }
            driven.x.push(run.state(1).to_vec());
        }
        driven.y = self.read((model, p), t, &driven)?;
        Some(driven)
    }

    /// All commands so far: a delay may reach back.
    fn signals(&self, u: &[Vec<f64>], t: &[f64]) -> Option<Signals> {
        let of = |i: usize| Signal { t: t[..u.len()].to_vec(), values: u.iter().map(|u| u[i]).collect(), hold: Hold::Zero };
        Signals::new((0..self.u.len()).map(of).collect()).ok()
    }

    /// Outputs at every sample: late, and behind their play.
    fn read(&self, (model, p): (&dyn Model, &[f64]), t: &[f64], driven: &Driven) -> Option<Vec<Vec<f64>>> {
        let d = model.dimensions();
        let paths: Vec<_> = (0..d.outputs).map(|i| model.output_path(i, p)).collect();
        let options = sim::Options { relative: 1e-8, absolute: 1e-10, ..sim::Options::default() };
        let signals = self.signals(&driven.u, t)?;
        let mut readings: Vec<Option<f64>> = vec![None; d.outputs];
        let mut all = Vec::with_capacity(t.len());
        let mut y = vec![0.0; d.outputs];
        for (k, &now) in t.iter().enumerate() {
            let mut read = Vec::with_capacity(d.outputs);
            for (i, path) in paths.iter().enumerate() {
                let then = (now - path.delay).max(t[0]);
                let from = if path.delay > 0.0 { t.partition_point(|t| *t <= then).saturating_sub(1) } else { k };
                if then > t[from] && path.delay > 0.0 {
                    let run = simulate(model, p, &driven.x[from], &signals, &[t[from], then], &options).ok()?;
                    model.outputs(then, run.state(run.t.len().checked_sub(1)?), p, &mut y);
                } else {
                    model.outputs(t[from], &driven.x[from], p, &mut y);
                }
                readings[i] = Some(sim::play(readings[i], y[i], path));
                read.extend(readings[i]);
            }
            all.push(read);
        }
        Some(all)
    }
}

/// The state at rest and the inputs nearest to the mean (in parts of the spreads) at which nothing accelerates.
fn balanced(model: &dyn Model, p: &[f64], seen: &Seen) -> Option<(Vec<f64>, Vec<f64>)> {
    let d = model.dimensions();
    let (n, states, signals) = (d.coordinates, d.states(), d.signals());
    let (mut x, mut u) = (seen.x.clone(), seen.u.clone());
    x[n..2 * n].fill(0.0);
    // coordinates, lags and inputs move; rates rest
    let moved: Vec<usize> = (0..n).chain(2 * n..states).collect();
    let (mut dx, mut a, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * signals]);
    let mut first = None;
    for _ in 0..STEPS {
        model.linearize(0.0, &x, &u, p, &mut dx, &mut a, &mut b).ok()?;
        let rest = DVector::from_column_slice(&dx[n..]);
        let size = rest.norm();
        if !size.is_finite() {
            return None;
        }
        if size <= BALANCED * first.get_or_insert(size).max(1.0) {
            return Some((x, u));
        }
        let count = moved.len();
        let slope = DMatrix::from_fn(states - n, count + d.inputs, |row, c| {
            let row = n + row;
            match moved.get(c) {
                Some(&state) => a[row * states + state] * seen.x_spread[state],
                None => b[row * signals + c - count] * seen.u_spread[c - count],
            }
        });
        if slope.iter().any(|v| !v.is_finite()) {
            return None;
        }
        let step = slope.svd(true, true).solve(&rest, 1e-10).ok()?;
        moved.iter().enumerate().for_each(|(c, &state)| x[state] -= step[c] * seen.x_spread[state]);
        (0..d.inputs).for_each(|j| u[j] -= step[count + j] * seen.u_spread[j]);
    }
    None
}
