//! A pendulum that a small random torque drives: how output error and innovations estimate it, in open loop and held upright by
//! a controller. Everything is drawn from one seed.

use crate::random::Random;
use ident::fit::{Estimate, FitOptions, ParameterSpec, identify as output_error, select};
use ident::innovations::{Driven, InnovationsOptions, RandomForce, identify as innovations};
use ident::record::{Column, Record, Start};
use jit::InProcess;
use sim::{Hold, Signal, Signals, simulate};
use std::f64::consts::TAU;

/// An experiment.
pub struct Experiment {
    /// Name, for tables.
    pub name: &'static str,
    /// Sign of the gravity's torque: -1 hanging, +1 upright.
    gravity: f64,
    /// Voltage from the reference and the state.
    law: fn(f64, &[f64]) -> f64,
    /// Largest reference.
    reference: f64,
}

/// The experiments.
pub const EXPERIMENTS: [Experiment; 2] = [
    Experiment { name: "hanging, open loop", gravity: -1.0, law: |r, _| r, reference: 2.0 },
    Experiment { name: "upright, closed loop", gravity: 1.0, law: |r, x| 15.0 * (r - x[0]) - 0.6 * x[1], reference: 0.3 },
];

/// Standard deviation of the random torque [N m].
pub const FORCE: f64 = 0.02;
/// Its correlation time [s].
pub const TIME: f64 = 0.2;
const PERIOD: f64 = 0.005;
const SAMPLES: usize = 4000;
const QUANTUM: f64 = TAU / 2048.0;
const FREE: [&str; 3] = ["J", "c", "K"];

fn rig(gravity: f64, force: &str) -> (model_dsl::rig::Rig, InProcess) {
    let sign = if gravity > 0.0 { "+" } else { "-" };
    let text = format!(
        "rig Driven {{ param J: kg*m^2 = 0.02 in 1e-4..1; param mgl: N*m = 0.5 fixed; param c: N*m*s/rad = 0.01; param K: N*m/V = 0.1;
        coord q: rad; input V: V in -20..20; {force}
        equation J * q.ddot = K * V + w {sign} mgl * sin(q) - c * q.dot; encoder q: 2048; }}"
    );
    let checked = model_dsl::check_text("driven.rig", &text);
    let rig = checked.rig.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    let model = InProcess::new(codegen::derive(&rig, codegen::Options::default()).unwrap_or_else(|e| panic!("{e:?}")));
    (rig, model)
}

/// How one method did.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Sets of parameters of which there is an estimate.
    pub fitted: usize,
    /// Intervals that hold the truth, for each parameter.
    pub covered: [usize; 3],
    /// Relative errors of the estimates, for each parameter.
    pub errors: [Vec<f64>; 3],
    /// Half widths of the intervals over the truth.
    pub widths: [Vec<f64>; 3],
}

impl Outcome {
    fn add(&mut self, estimates: &[Estimate], truth: &[f64], specs: &[ParameterSpec]) {
        self.fitted += 1;
        for (k, name) in FREE.iter().enumerate() {
            let Some(e) = estimates.iter().find(|e| e.name == *name) else { continue };
            let truth = specs.iter().position(|s| s.name == *name).map_or(f64::NAN, |i| truth[i]);
            self.covered[k] += usize::from(e.ci95.is_some_and(|(lo, hi)| lo <= truth && truth <= hi));
            self.errors[k].push(e.value / truth - 1.0);
            self.widths[k].push(e.ci95.map_or(f64::NAN, |(lo, hi)| 0.5 * (hi - lo) / truth));
        }
    }

    /// Share of the intervals that hold the truth.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.covered.iter().sum::<usize>() as f64 / (3 * self.fitted).max(1) as f64
    }

    /// 95 % interval of that share (E. B. Wilson, 1927), the intervals of a run counted as independent.
    #[must_use]
    pub fn share_interval(&self) -> (f64, f64) {
        let n = (3 * self.fitted).max(1) as f64;
        let (p, z) = (self.share(), 1.96_f64);
        let middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
        let half = z / (1.0 + z * z / n) * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
        (middle - half, middle + half)
    }

    /// Mean and root-mean-square relative error of parameter k.
    #[must_use]
    pub fn error(&self, k: usize) -> (f64, f64) {
        let n = self.errors[k].len().max(1) as f64;
        if self.errors[k].is_empty() {
            return (f64::NAN, f64::INFINITY);
        }
        (self.errors[k].iter().sum::<f64>() / n, (self.errors[k].iter().map(|e| e * e).sum::<f64>() / n).sqrt())
    }

    /// One line of a table.
    #[must_use]
    pub fn line(&self) -> String {
        let each = |k: usize| {
            let (mean, rms) = self.error(k);
            let mut widths = self.widths[k].clone();
            widths.sort_by(f64::total_cmp);
            let width = widths.get(widths.len() / 2).copied().unwrap_or(f64::NAN);
            format!(
                "{}: mean {:+.2} %, rms {:.2} %, interval +-{:.2} %, covers {}",
                FREE[k],
                100.0 * mean,
                100.0 * rms,
                100.0 * width,
                self.covered[k]
            )
        };
        let (lo, hi) = self.share_interval();
        let names: Vec<String> = (0..3).map(each).collect();
        format!(
            "{} fitted, {:.1} % covered ({:.1} .. {:.1}); {}",
            self.fitted,
            100.0 * self.share(),
            100.0 * lo,
            100.0 * hi,
            names.join("; ")
        )
    }
}

/// Both methods (or innovations alone) on `runs` records of as many random parameter sets; with the random torque as innovations found it.
///
/// # Panics
/// Where a rig or a simulation is wrong: this is for tests.
#[must_use]
pub fn study(experiment: &Experiment, runs: usize, seed: u64, both: bool) -> (Outcome, Outcome, Vec<RandomForce>) {
    let (_, plant) = rig(experiment.gravity, "input w: N*m in -9..9;");
    let (rig, model) = rig(experiment.gravity, "param w: N*m = 0 fixed;");
    let specs = ParameterSpec::of_rig(&rig);
    let force = specs.iter().position(|s| s.name == "w").unwrap_or(0);
    let mut random = Random::new(seed);
    let (mut outputs, mut filtered, mut forces) = (Outcome::default(), Outcome::default(), Vec::new());
    for run in 0..runs {
        let truth: Vec<f64> = specs.iter().map(|s| if s.free { s.value * random.within(0.8, 1.25) } else { s.value }).collect();
        let record = record(experiment, &plant, &truth[..4], &mut random);
        let mut start = specs.clone();
        for (s, truth) in start.iter_mut().zip(&truth).filter(|(s, _)| s.free) {
            s.value = truth * if random.chance(0.5) { 1.5 } else { 1.0 / 1.5 };
        }
        let free: Vec<String> = FREE.iter().map(|&s| s.to_owned()).collect();
        select(&mut start, Some(&free), &[]).unwrap_or_else(|e| panic!("{e}"));
        let records = [record];
        match both.then(|| output_error(&model, &start, &records, &[], &FitOptions::default())).transpose() {
            Ok(None) => {}
            Ok(Some(fit)) if fit.ending.converged() => outputs.add(&fit.parameters, &truth, &specs),
            Ok(Some(fit)) => eprintln!("{}, run {run}, output error: {}", experiment.name, fit.ending),
            Err(e) => eprintln!("{}, run {run}, output error: {e}", experiment.name),
        }
        let driven = Driven { forces: vec![("q".to_owned(), force)], ..Driven::default() };
        match innovations(&model, &start, &driven, &records, &[], &InnovationsOptions::default()) {
            Ok(found) if found.fit.ending.converged() => {
                filtered.add(&found.fit.parameters, &truth, &specs);
                forces.extend(found.forces);
            }
            Ok(found) => eprintln!("{}, run {run}, innovations: {}", experiment.name, found.fit.ending),
            Err(e) => eprintln!("{}, run {run}, innovations: {e}", experiment.name),
        }
    }
    (outputs, filtered, forces)
}

/// A simulated record: steps of the reference, an exponentially correlated torque, an encoder.
fn record(experiment: &Experiment, plant: &InProcess, truth: &[f64], random: &mut Random) -> Record {
    let t: Vec<f64> = (0..SAMPLES).map(|k| PERIOD * k as f64).collect();
    let keep = (-PERIOD / TIME).exp();
    let (mut w, mut r) = (FORCE * normal(random), 0.0);
    let (mut x, mut q, mut volts) = (vec![0.05, 0.0], Vec::with_capacity(SAMPLES), Vec::with_capacity(SAMPLES));
    let held = |value: f64| Signal { t: vec![0.0, 1.0], values: vec![value; 2], hold: Hold::Zero };
    for k in 0..SAMPLES {
        if k % 75 == 0 {
            r = random.within(-experiment.reference, experiment.reference);
        }
        let v = (experiment.law)(r, &x).clamp(-20.0, 20.0);
        q.push((x[0] / QUANTUM).round() * QUANTUM);
        volts.push(v);
        let signals = Signals::new(vec![held(v), held(w)]).unwrap_or_else(|e| panic!("{e}"));
        let run = simulate(plant, truth, &x, &signals, &[0.0, PERIOD], &sim::Options::default()).unwrap_or_else(|e| panic!("{e}"));
        x = run.state(1).to_vec();
        w = keep * w + FORCE * (1.0 - keep * keep).sqrt() * normal(random);
    }
    let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
    Record {
        source: "simulated".to_owned(),
        t,
        columns: vec![column("V", volts), column("q", q)],
        declared: Vec::new(),
        start: Start::Free,
    }
}

/// Standard normal (G. E. P. Box, M. E. Muller, 1958).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * random.within(f64::MIN_POSITIVE, 1.0).ln()).sqrt();
    radius * random.within(0.0, TAU).cos()
}
