//! Synthetic truth: how often 95 % intervals hold the truth, and whether fits from starting values off by a factor of two
//! come home. Knows the example rigs by name; everything is drawn from one seed.

use crate::random::Random;
use crate::{rig_of, root};
use ident::fit::{FitOptions, ParameterSpec, identify, select};
use ident::record::{Column, Record, Start};
use jit::InProcess;
use runtime::Model;
use sim::{Hold, Signal, Signals, simulate};
use std::f64::consts::TAU;

/// A rig under study and its experiment.
pub struct Case {
    /// Name, for tables.
    pub name: &'static str,
    rig: Source,
    /// Parameters that are fitted.
    pub free: &'static [&'static str],
    /// Steps of each input [s], and how they are drawn from the true parameters.
    hold: f64,
    levels: fn(&Truth<'_>, &mut Random) -> Vec<f64>,
    /// Initial coordinates and rates.
    initial: &'static [f64],
    period: f64,
    samples: usize,
    /// Encoder steps, one an output.
    quanta: &'static [f64],
}

enum Source {
    Example(&'static str),
    Text(&'static str),
}

/// True parameters by name.
pub struct Truth<'a> {
    names: &'a [ParameterSpec],
    values: &'a [f64],
}

impl Truth<'_> {
    fn of(&self, name: &str) -> f64 {
        self.names.iter().position(|s| s.name == name).map_or(f64::NAN, |i| self.values[i])
    }
}

const PENDULUM: &str = "rig Pendulum {
    param J: kg*m^2 = 0.02; param mgl: N*m = 0.5 fixed; param c: N*m*s/rad = 0.01; param K: N*m/V = 0.1;
    coord q: rad; input V: V in -5..5;
    equation J * q.ddot = K * V - mgl * sin(q) - c * q.dot;
    encoder q: 2048;
}";

/// The four rigs.
pub const CASES: [Case; 4] = [
    Case {
        name: "pendulum",
        rig: Source::Text(PENDULUM),
        free: &["J", "c", "K"],
        hold: 0.375,
        levels: |_, random| vec![random.within(-2.0, 2.0)],
        initial: &[0.2, -0.5],
        period: 0.005,
        samples: 1500,
        quanta: &[TAU / 2048.0],
    },
    Case {
        name: "furuta",
        rig: Source::Example("furuta"),
        free: &["m_r", "m_p"],
        hold: 0.2,
        levels: |_, random| vec![random.within(-0.004, 0.004)],
        initial: &[0.0, 0.3, 0.0, 0.0],
        period: 0.004,
        samples: 1000,
        quanta: &[TAU / 2048.0, TAU / 2048.0],
    },
    Case {
        name: "googol_identified",
        rig: Source::Example("googol_identified"),
        free: &["a1", "a2", "a3", "b2", "b3", "c_psi", "c_eps", "c_theta"],
        hold: 1.0,
        levels: |truth, random| {
            // below level, where elevation is stable (a1 cos(eps) > a2 sin(eps)) and where the paper's records are
            let sum = truth.of("a2") / truth.of("b1") * random.within(0.75, 0.9);
            let difference = truth.of("a3") / truth.of("b2") * random.within(-0.15, 0.15);
            vec![0.5 * (sum + difference), 0.5 * (sum - difference)]
        },
        initial: &[0.0, -0.5, 0.0, 0.0, 0.0, 0.0],
        period: 0.02,
        samples: 1500,
        quanta: &[TAU / 4800.0, TAU / 2400.0, TAU / 2400.0],
    },
    Case {
        name: "emps",
        rig: Source::Example("emps"),
        free: &["M", "F_v", "F_c", "F_0"],
        hold: 0.4,
        levels: |truth, random| vec![random.within(-3.0, 3.0) * truth.of("F_c") / 20.0],
        initial: &[0.1, 0.0],
        period: 0.004,
        samples: 1500,
        quanta: &[1e-4],
    },
];

/// What came out for one rig.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Runs.
    pub runs: usize,
    /// Intervals that hold the truth, for each free parameter.
    pub covered: Vec<usize>,
    /// Runs whose search did not converge, or whose errors are larger than the noise that was put in.
    pub diverged: usize,
    /// Largest relative error of an estimate in a run that converged.
    pub worst: f64,
    /// Evaluations, all runs together.
    pub evaluations: usize,
}

impl Outcome {
    /// Share of the intervals that hold the truth.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.covered.iter().sum::<usize>() as f64 / (self.runs * self.covered.len()).max(1) as f64
    }

    /// 95 % interval of that share (E. B. Wilson, 1927), the intervals of a run counted as independent.
    #[must_use]
    pub fn share_interval(&self) -> (f64, f64) {
        let n = (self.runs * self.covered.len()).max(1) as f64;
        let (p, z) = (self.share(), 1.96_f64);
        let middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
        let half = z / (1.0 + z * z / n) * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
        (middle - half, middle + half)
    }
}

/// Fits `runs` records of as many random rigs.
///
/// # Panics
/// Where a rig or a simulation is wrong: this is for tests.
#[must_use]
pub fn study(case: &Case, runs: usize, seed: u64) -> Outcome {
    let rig = match case.rig {
        Source::Example(name) => rig_of(&root().join(format!("examples/rigs/{name}.rig"))),
        Source::Text(text) => {
            let checked = model_dsl::check_text("study.rig", text);
            checked.rig.unwrap_or_else(|| panic!("{:?}", checked.diagnostics))
        }
    };
    let model = InProcess::new(codegen::derive(&rig, codegen::Options::default()).unwrap_or_else(|e| panic!("{}: {e:?}", case.name)));
    let mut specs = ParameterSpec::of_rig(&rig);
    let free: Vec<String> = case.free.iter().map(|&s| s.to_owned()).collect();
    select(&mut specs, Some(&free), &[]).unwrap_or_else(|e| panic!("{}: {e}", case.name));
    let mut random = Random::new(seed);
    let mut outcome = Outcome { runs, covered: vec![0; free.len()], diverged: 0, worst: 0.0, evaluations: 0 };
    for run in 0..runs {
        let truth: Vec<f64> = specs.iter().map(|s| if s.free { s.value * random.within(0.7, 1.4) } else { s.value }).collect();
        let record = record(case, &model, &specs, &truth, &mut random);
        let mut off = specs.clone();
        for (s, truth) in off.iter_mut().zip(&truth).filter(|(s, _)| s.free) {
            s.value = truth * if random.chance(0.5) { 2.0 } else { 0.5 };
        }
        let Ok(fit) = identify(&model, &off, &[record], &[], &FitOptions::default()) else {
            outcome.diverged += 1;
            continue;
        };
        outcome.evaluations += fit.evaluations;
        let noisy = fit.train[0].signals.iter().zip(case.quanta).any(|(s, q)| s.rmse.is_none_or(|e| e > 1.2 * q * NOISE));
        if noisy || !fit.ending.converged() {
            eprintln!("{}, run {run}: {}, errors {:?}", case.name, fit.ending, fit.train[0].signals);
            outcome.diverged += 1;
        }
        for (e, covered) in fit.parameters.iter().zip(&mut outcome.covered) {
            let truth = specs.iter().position(|s| s.name == e.name).map_or(f64::NAN, |i| truth[i]);
            *covered += usize::from(e.ci95.is_some_and(|(lo, hi)| lo <= truth && truth <= hi));
            if !noisy {
                outcome.worst = outcome.worst.max((e.value / truth - 1.0).abs());
            }
        }
    }
    outcome
}

/// Standard deviation of half a quantum of noise and of rounding to the quantum, in quanta.
const NOISE: f64 = 0.577_350_269;

/// A simulated record: random steps, noise of half a quantum, quantized.
fn record(case: &Case, model: &InProcess, specs: &[ParameterSpec], truth: &[f64], random: &mut Random) -> Record {
    let t: Vec<f64> = (0..case.samples).map(|k| case.period * k as f64).collect();
    let every = (case.hold / case.period).round() as usize;
    let mut inputs = vec![Vec::with_capacity(t.len()); model.dimensions().inputs];
    let mut levels = Vec::new();
    for k in 0..t.len() {
        if k % every == 0 {
            levels = (case.levels)(&Truth { names: specs, values: truth }, random);
        }
        inputs.iter_mut().zip(&levels).for_each(|(u, level)| u.push(*level));
    }
    let signals = inputs.iter().map(|u| Signal { t: t.clone(), values: u.clone(), hold: Hold::Zero }).collect();
    let signals = Signals::new(signals).unwrap_or_else(|e| panic!("{}: {e}", case.name));
    let run = simulate(model, truth, case.initial, &signals, &t, &sim::Options::default()).unwrap_or_else(|e| panic!("{}: {e}", case.name));
    let mut columns: Vec<Column> =
        inputs.into_iter().enumerate().map(|(i, values)| Column { name: model.names().signal(i).to_owned(), unit: None, values }).collect();
    for (i, quantum) in case.quanta.iter().enumerate() {
        let noisy = |y: f64, random: &mut Random| ((y + 0.5 * quantum * normal(random)) / quantum).round() * quantum;
        let values = run.output(i).into_iter().map(|y| noisy(y, random)).collect();
        columns.push(Column { name: model.names().output(i).to_owned(), unit: None, values });
    }
    Record { source: "simulated".to_owned(), t, columns, declared: Vec::new(), start: Start::Free }
}

/// Standard normal (G. E. P. Box, M. E. Muller, 1958).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * random.within(f64::MIN_POSITIVE, 1.0).ln()).sqrt();
    radius * random.within(0.0, TAU).cos()
}
