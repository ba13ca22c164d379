//! A closed loop as the rig runs it: encoders, a controller at its own rate, limits, delays, a plant between samples.
//!
//! Each period: outputs are read (delay, play, wrap, quantum), the controller answers, the command is limited and held; the
//! plant is integrated from switch to switch of the (delayed) inputs, never across one. What comes from outside are
//! functions of time. Knows models through the trait; play and encoder are those of `sim`. A play is read once a period: a
//! motion to and fro within one does not move the reading.

use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;
use runtime::{Model, OutputPath};
use sim::{encoder, play};
use std::fmt;

/// A sampled controller.
pub trait Controller {
    /// Command for the inputs (one for each input, SI) from the outputs read at time t [s].
    ///
    /// # Errors
    /// What the controller cannot do, in the user's words; the run ends there.
    fn command(&mut self, t: f64, y: &[f64], u: &mut [f64]) -> Result<(), String>;
    /// The inputs as limited (one for each input), told after every command: for anti-windup.
    fn applied(&mut self, u: &[f64]);
    /// References of the outputs at the last command, value and rate; `None` where there is none.
    fn references(&self) -> &[Option<(f64, f64)>];
    /// Rates of the outputs as estimated at the last command; empty where the controller estimates none.
    fn rates(&self) -> &[f64] {
        &[]
    }
}

/// What is run.
#[derive(Clone, Debug, PartialEq)]
pub struct Bench {
    /// State at the start.
    pub x: Vec<f64>,
    /// Period of the controller [s].
    pub period: f64,
    /// Length of the run [s].
    pub duration: f64,
    /// Longest step of the integration between samples [s].
    pub max_step: f64,
    /// Encoders quantize and wrap; otherwise outputs are read exactly.
    pub encoders: bool,
    /// Inputs keep to their limits; otherwise they are applied as asked.
    pub limits: bool,
}

/// A function of time [s].
pub type Signal<'a> = Box<dyn Fn(f64) -> f64 + 'a>;

/// What comes from outside.
#[derive(Default)]
pub struct Surroundings<'a> {
    /// Exogenous signals of the model (accelerations of prescribed coordinates), in its order.
    pub exogenous: Vec<Signal<'a>>,
    /// What is added to inputs behind their limits: (input, function).
    pub disturbances: Vec<(usize, Signal<'a>)>,
    /// Noise on outputs, behind their plays, before the encoders.
    pub noise: Option<Noise>,
}

/// Independent normal noise on outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// Standard deviation of each output (SI).
    pub deviation: Vec<f64>,
    /// Seed: equal seeds, equal noise.
    pub seed: u64,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// At its end.
    Complete,
    /// A state left the numbers, or the mass matrix became singular.
    Diverged {
        /// State or coordinate.
        name: String,
    },
    /// The controller gave up.
    Controller(String),
}

/// What a run gave; all vectors run over the samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Times [s].
    pub t: Vec<f64>,
    /// States.
    pub x: Vec<Vec<f64>>,
    /// True outputs, before delay, play and encoder.
    pub y: Vec<Vec<f64>>,
    /// Outputs as read.
    pub read: Vec<Vec<f64>>,
    /// Inputs as limited.
    pub u: Vec<Vec<f64>>,
    /// References of the outputs, value and rate.
    pub references: Vec<Vec<Option<(f64, f64)>>>,
    /// Rates of the outputs as the controller estimates them; empty where it does not.
    pub rates: Vec<Vec<f64>>,
    /// Share of samples at which each input was limited [%].
    pub saturated_percent: Vec<f64>,
    /// How it ended; the vectors reach up to there.
    pub status: Status,
}

impl Run {
    /// Mean absolute error and root mean square error of an output against its reference, from a time [s] on; `None`
    /// where it has no reference.
    #[must_use]
    pub fn errors(&self, output: usize, from: f64) -> Option<(f64, f64)> {
        let errors: Vec<f64> = (0..self.t.len())
            .filter(|&k| self.t[k] >= from)
            .filter_map(|k| Some(self.y[k].get(output)? - (*self.references[k].get(output)?)?.0))
            .collect();
        let n = errors.len() as f64;
        (n > 0.0).then(|| (errors.iter().map(|e| e.abs()).sum::<f64>() / n, (errors.iter().map(|e| e * e).sum::<f64>() / n).sqrt()))
    }
}

/// What is wrong with a bench.
#[derive(Clone, Debug, PartialEq)]
pub enum BenchError {
    /// The state has not one value for each state of the model.
    State {
        /// Values.
        found: usize,
        /// States.
        wanted: usize,
    },
    /// A time is not positive and finite, or the run would have more than ten million samples or steps in a sample.
    Time {
        /// `period`, `duration`, `max_step`.
        what: &'static str,
        /// Its value [s].
        value: f64,
    },
    /// An exogenous signal of the model (prescribed motion) has no function.
    Exogenous {
        /// The first one's name.
        signal: String,
    },
    /// A disturbance of an input that the model does not have, or noise on another number of outputs.
    Surroundings,
}

impl fmt::Display for BenchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::State { found, wanted } => write!(f, "{found} values for the state at the start, the model has {wanted} states"),
            Self::Time { what, value } => write!(
                f,
                "the {what} of {value} s makes no sense here: it must be positive, and the run must stay below ten million samples"
            ),
            Self::Exogenous { signal } => {
                write!(f, "the model is moved by `{signal}`, and nothing says how; give the motion as a function of time")
            }
            Self::Surroundings => f.write_str("a disturbance or a noise does not fit the inputs and outputs of the model"),
        }
    }
}

impl std::error::Error for BenchError {}

const MOST: f64 = 1e7;
/// A state beyond this has left the range of any rig.
const LARGEST: f64 = 1e9;

/// Runs a controller on a model with parameters `p`. Noise is drawn for every output at every sample, so that the noise of
/// one output does not depend on that of another.
///
/// # Errors
/// [`BenchError`] where the bench makes no sense; a run that fails on its way is no error but has a status.
pub fn run(
    model: &dyn Model,
    p: &[f64],
    bench: &Bench,
    around: &Surroundings<'_>,
    controller: &mut dyn Controller,
) -> Result<Run, BenchError> {
    check(model, bench, around)?;
    let d = model.dimensions();
    let names = model.names();
    let outputs: Vec<OutputPath> = (0..d.outputs).map(|i| model.output_path(i, p)).collect();
    let inputs: Vec<_> = (0..d.inputs).map(|i| model.input_path(i, p)).collect();
    let samples = (bench.duration / bench.period).round() as usize;
    let mut run = Run {
        t: Vec::new(),
        x: Vec::new(),
        y: Vec::new(),
        read: Vec::new(),
        u: Vec::new(),
        references: Vec::new(),
        rates: Vec::new(),
        saturated_percent: vec![0.0; d.inputs],
        status: Status::Complete,
    };
    let mut x = bench.x.clone();
    let mut past = History::default();
    let mut random = around.noise.as_ref().map(|noise| Pcg64::seed_from_u64(noise.seed));
    let mut readings: Vec<Option<f64>> = vec![None; d.outputs];
    let (mut y, mut u) = (vec![0.0; d.outputs], vec![0.0; d.inputs]);
    for k in 0..=samples {
        let t = k as f64 * bench.period;
        model.outputs(t, &x, p, &mut y);
        past.push(t, &y);
        let read: Vec<f64> = outputs
            .iter()
            .enumerate()
            .map(|(i, path)| {
                let mut value = play(readings[i], past.at(t - path.delay, i), path);
                readings[i] = Some(value);
                if let (Some(noise), Some(random)) = (&around.noise, &mut random) {
                    let normal: f64 = StandardNormal.sample(random);
                    value += noise.deviation[i] * normal;
                }
                if bench.encoders { encoder(value, path) } else { value }
            })
            .collect();
        if let Err(why) = controller.command(t, &read, &mut u) {
            run.status = Status::Controller(why);
            break;
        }
        for (i, path) in inputs.iter().enumerate() {
            if !bench.limits {
                continue;
            }
            let asked = u[i];
            u[i] = asked.max(path.limits.0).min(path.limits.1);
            // not `==`: a command that is not a number counts as limited
            run.saturated_percent[i] += if u[i] == asked { 0.0 } else { 100.0 };
        }
        controller.applied(&u);
        run.t.push(t);
        run.x.push(x.clone());
        run.y.push(y.clone());
        run.read.push(read);
        run.u.push(u.clone());
        run.references.push(controller.references().to_vec());
        if !controller.rates().is_empty() {
            run.rates.push(controller.rates().to_vec());
        }
        if k == samples {
            break;
        }
        // pieces of the period over which every delayed input is constant
        let end = (k + 1) as f64 * bench.period;
        let mut switches: Vec<f64> =
            inputs.iter().filter(|path| path.delay > 0.0).map(|path| t + path.delay.rem_euclid(bench.period)).collect();
        switches.push(end);
        switches.sort_by(f64::total_cmp);
        let mut from = t;
        let mut failed = None;
        for to in switches {
            if to - from <= 1e-12 * bench.period {
                continue;
            }
            let middle = 0.5 * (from + to);
            let held: Vec<f64> = inputs.iter().enumerate().map(|(i, path)| run.command_at(middle - path.delay, bench.period, i)).collect();
            let steps = ((to - from) / bench.max_step).ceil().max(1.0) as usize;
            for s in 0..steps {
                let h = (to - from) / steps as f64;
                failed = runge_kutta(model, p, from + s as f64 * h, &mut x, &held, around, h).err();
                if failed.is_some() {
                    break;
                }
                if outputs.iter().any(|path| path.delay > 0.0) {
                    model.outputs(from + (s + 1) as f64 * h, &x, p, &mut y);
                    past.push(from + (s + 1) as f64 * h, &y);
                }
            }
            from = to;
        }
        if let Some(state) = failed {
            run.status = Status::Diverged { name: names.state(state).to_owned() };
            break;
        }
    }
    let count = run.t.len().max(1) as f64;
    run.saturated_percent.iter_mut().for_each(|s| *s /= count);
    Ok(run)
}

fn check(model: &dyn Model, bench: &Bench, around: &Surroundings<'_>) -> Result<(), BenchError> {
    let d = model.dimensions();
    if bench.x.len() != d.states() {
        return Err(BenchError::State { found: bench.x.len(), wanted: d.states() });
    }
    if around.exogenous.len() < d.exogenous {
        return Err(BenchError::Exogenous { signal: model.names().signal(d.inputs + around.exogenous.len()).to_owned() });
    }
    let noise_fits = around.noise.as_ref().is_none_or(|noise| noise.deviation.len() == d.outputs);
    if around.exogenous.len() > d.exogenous || around.disturbances.iter().any(|(i, _)| *i >= d.inputs) || !noise_fits {
        return Err(BenchError::Surroundings);
    }
    let times =
        [("period", bench.period, MOST), ("duration", bench.duration, MOST * bench.period), ("max_step", bench.max_step, f64::INFINITY)];
    for (what, value, most) in times {
        if !(value > 0.0 && value <= most && value.is_finite()) {
            return Err(BenchError::Time { what, value });
        }
    }
    if bench.period / bench.max_step > MOST {
        return Err(BenchError::Time { what: "max_step", value: bench.max_step });
    }
    Ok(())
}

impl Run {
    /// The held command of input i at a time: the first one before the run began.
    fn command_at(&self, t: f64, period: f64, i: usize) -> f64 {
        let k = (t / period).floor().max(0.0) as usize;
        self.u.get(k).or(self.u.last()).map_or(0.0, |u| u[i])
    }
}

/// Outputs of the past, for delays.
#[derive(Default)]
struct History {
    t: Vec<f64>,
    y: Vec<Vec<f64>>,
}

impl History {
    fn push(&mut self, t: f64, y: &[f64]) {
        if self.t.last().is_none_or(|&last| t > last) {
            self.t.push(t);
            self.y.push(y.to_vec());
        }
    }

    /// Output i at a time, between its neighbours; before the start its first value.
    fn at(&self, t: f64, i: usize) -> f64 {
        let k = self.t.partition_point(|&s| s < t);
        match (k.checked_sub(1).map(|j| (self.t[j], self.y[j][i])), self.t.get(k).map(|&s| (s, self.y[k][i]))) {
            (_, Some((t1, y1))) if t1 == t => y1,
            (Some((t0, y0)), Some((t1, y1))) => y0 + (y1 - y0) * (t - t0) / (t1 - t0),
            (Some((_, y)), None) | (None, Some((_, y))) => y,
            (None, None) => 0.0,
        }
    }
}

/// One step of the classical fourth-order method with held inputs; the error is the index of a state that failed.
fn runge_kutta(model: &dyn Model, p: &[f64], t: f64, x: &mut [f64], held: &[f64], around: &Surroundings<'_>, h: f64) -> Result<(), usize> {
    let n = x.len();
    let mut k = [const { Vec::new() }; 4];
    let mut at = x.to_vec();
    let mut u = held.to_vec();
    u.resize(held.len() + around.exogenous.len(), 0.0);
    for (stage, c) in [0.0, 0.5, 0.5, 1.0].into_iter().enumerate() {
        if stage > 0 {
            for i in 0..n {
                at[i] = x[i] + c * h * k[stage - 1][i];
            }
        }
        let now = t + c * h;
        u[..held.len()].copy_from_slice(held);
        around.disturbances.iter().for_each(|(i, f)| u[*i] += f(now));
        u[held.len()..].iter_mut().zip(&around.exogenous).for_each(|(u, f)| *u = f(now));
        k[stage] = vec![0.0; n];
        model.rhs(now, &at, &u, p, &mut k[stage]).map_err(|s| s.coordinate)?;
    }
    for i in 0..n {
        x[i] += h / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
        if x[i].is_nan() || x[i].abs() > LARGEST {
            return Err(i);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn delayed_outputs_lie_between_their_neighbours() {
        let mut past = History::default();
        past.push(0.0, &[1.0]);
        past.push(1.0, &[3.0]);
        assert_eq!((past.at(-1.0, 0), past.at(0.25, 0), past.at(1.0, 0), past.at(2.0, 0)), (1.0, 1.5, 3.0, 3.0));
    }
}
