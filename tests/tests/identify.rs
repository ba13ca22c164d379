//! Identification: sensitivities against differences, the seed's record, synthetic truth.

use codegen::{Options, derive};
use cross_checks::{random::Random, record_folder, rig_of, root};
use ident::fit::{Fit, FitOptions, InitialStates, Known, ParameterSpec, Starting, Weights, identify, select};
use ident::record::{Column, Record, Start, read_with};
use jit::InProcess;
use model_dsl::rig::Rig;
use runtime::Model;
use sim::{FixedMethod, Forward, Hold, Pattern, Signal, Signals, simulate};
use std::path::PathBuf;

fn folder_for(name: &str) -> Option<PathBuf> {
    let folder = record_folder();
    match folder {
        Some(_) => println!("record test: ran {name}"),
        None => println!("record test: skipped {name} (RIG_DATA is not set)"),
    }
    folder
}

fn example(name: &str) -> (Rig, InProcess) {
    let rig = rig_of(&root().join(format!("examples/rigs/{name}.rig")));
    let model = InProcess::new(derive(&rig, Options::default()).unwrap());
    (rig, model)
}

fn rig_from(text: &str) -> (Rig, InProcess) {
    let checked = model_dsl::check_text("test.rig", text);
    let rig = checked.rig.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    let model = InProcess::new(derive(&rig, Options::default()).unwrap());
    (rig, model)
}

fn list(names: &str) -> Vec<String> {
    names.split(',').map(str::to_owned).collect()
}

fn figure(fit: &Fit, signal: &str) -> f64 {
    fit.train[0].signals.iter().find(|s| s.signal == signal).and_then(|s| s.fit_percent).unwrap()
}

fn show(title: &str, fit: &Fit) {
    println!("{title}: {}, cost {:.4}, {} evaluations, {:.3} s, {}", fit.ending, fit.cost, fit.evaluations, fit.seconds, fit.objective);
    for e in &fit.parameters {
        println!("  {:10} {:12.5} +- {:.2e} {}", e.name, e.value, e.std_error.unwrap_or(f64::NAN), e.unit);
    }
    for s in fit.initial_states.iter().filter(|s| s.free) {
        println!("  {:10} {:12.5}  prior {:.4?}", s.state, s.value, s.prior);
    }
    for r in fit.train.iter().chain(&fit.test) {
        println!(
            "  {}: {}",
            r.record,
            r.signals.iter().map(|s| format!("{} {:.2?} %", s.signal, s.fit_percent)).collect::<Vec<_>>().join(", ")
        );
    }
    let i = &fit.identifiable;
    println!("  rank {} of {}, dead {:?}, trade-offs {:?}; {}", i.rank, i.of, i.dead, i.trade_offs, fit.intervals);
}

const DELAYED: &str = "rig Delayed {
    param J: kg*m^2 = 0.02; param k: N*m/rad = 0.5; param c: N*m*s/rad = 0.01; param K: N*m/V = 0.1; param tau: s = 0.05;
    param d: s = 0.03; param d_y: s = 0.013; param s: 1 = 1.1; param b: rad = 0.02;
    coord q: rad; coord r: rad;
    input V: V in -5..5; actuator M: N*m = K * V { delay d; lag tau; }
    equation J * q.ddot = M - k * sin(q) - c * q.dot + k * (r - q) / 3;
    equation J * r.ddot = -k * (r - q) / 3 - c * r.dot;
    output q: rad = q { scale s; bias b; delay d_y; }
    output r: rad = r;
}";

#[test]
fn sensitivities_are_the_derivatives_of_the_trajectory() {
    let (_, model) = rig_from(DELAYED);
    let d = model.dimensions();
    let mut p = vec![0.0; d.parameters];
    model.nominal(&mut p);
    let t: Vec<f64> = (0..200).map(|k| 0.01 * f64::from(k)).collect();
    for (hold, step, method) in [
        (Hold::Zero, 0.0125, FixedMethod::DormandPrince),
        (Hold::First, 0.0125, FixedMethod::DormandPrince),
        (Hold::Zero, 0.005, FixedMethod::Classical),
    ] {
        let stamps: Vec<f64> = (0..9).map(|k| 0.25 * f64::from(k)).collect();
        let values = vec![0.0, 3.0, 3.0, -2.0, 1.0, 9.0, 0.0, -1.0, 2.0];
        let signals = Signals::new(vec![Signal { t: stamps, values, hold }]).unwrap();
        let x0 = [0.2, -0.1, 0.3, 0.4, 0.05];
        let all: Vec<usize> = (0..d.parameters).collect();
        let columns = d.parameters + d.states();
        let mut s0 = vec![0.0; d.states() * columns];
        (0..d.states()).for_each(|i| s0[i * columns + d.parameters + i] = 1.0);
        let mut forward = Forward::new(&model, &signals, &t, &[0, 1], &all, d.states(), Pattern { method, step }).unwrap();
        let mut y = vec![[0.0; 2]; t.len()];
        let mut dy = vec![vec![vec![0.0; columns]; 2]; t.len()];
        let mut keep = |k: usize, i: usize, value: f64, slopes: &[f64]| {
            y[k][i] = value;
            dy[k][i].copy_from_slice(slopes);
        };
        forward.run(&p, &x0, &s0, &mut keep).unwrap();
        let options = sim::Options { relative: 1e-12, absolute: 1e-13, ..sim::Options::default() };
        let exact = |p: &[f64], x0: &[f64]| simulate(&model, p, x0, &signals, &t, &options).unwrap();
        let reference = exact(&p, &x0);
        let (mut worst, mut worst_slope) = (0.0_f64, 0.0_f64);
        for (k, y) in y.iter().enumerate() {
            for (own, wanted) in y.iter().zip(reference.outputs(k)) {
                worst = worst.max((own - wanted).abs());
            }
        }
        for column in 0..columns {
            let shifted = |h: f64| {
                let (mut p, mut x0) = (p.clone(), x0);
                if column < d.parameters {
                    p[column] += h
                } else {
                    x0[column - d.parameters] += h
                }
                exact(&p, &x0)
            };
            let h = 1e-5;
            let (above, below) = (shifted(h), shifted(-h));
            for k in 0..t.len() {
                // a read that meets the start or a switch within h of it has one-sided derivatives
                let near = |delay: f64| ((t[k] - delay) / 0.25).fract().abs() < 1e-3;
                if column == 6 && near(p[6]) {
                    continue;
                }
                for (i, slopes) in dy[k].iter().enumerate() {
                    let difference = (above.outputs(k)[i] - below.outputs(k)[i]) / (2.0 * h);
                    let error = (slopes[column] - difference).abs() / (1.0 + difference.abs());
                    assert!(error < 2e-4, "{hold:?} {method:?} column {column} output {i} at {}: {} or {difference}", t[k], slopes[column]);
                    worst_slope = worst_slope.max(error);
                }
            }
        }
        println!("{hold:?} {method:?}: outputs to {worst:.1e}, sensitivities to {worst_slope:.1e}, {} steps", forward.steps());
        assert!(worst < 1e-5);
    }
}

fn googol(initial: Option<InitialStates>, weights: Weights, tolerance: f64) -> Option<Fit> {
    let folder = folder_for("googol_open_loop_steps, fitted")?;
    let (rig, model) = example("googol_identified");
    let record = read_with(&root().join("examples/records/googol_open_loop_steps.toml"), Some(&folder)).unwrap();
    let mut specs = ParameterSpec::of_rig(&rig);
    select(&mut specs, Some(&list("a1,a2,a3,b2,b3,c_psi,c_eps,c_theta")), &[]).unwrap();
    specs.iter_mut().find(|s| s.name == "c_eps").unwrap().value = 0.10;
    let options = FitOptions { weights, initial, starting: Starting::Nominal, tolerance, ..FitOptions::default() };
    Some(identify(&model, &specs, &[record], &[], &options).unwrap())
}

const RATES_FREE: InitialStates = InitialStates { coordinates: Known::Fixed, rates: Known::Free };
const RATES_PRIOR: InitialStates = InitialStates { coordinates: Known::Prior, rates: Known::Prior };

#[test]
fn eq_16_on_its_record_with_free_initial_rates_and_with_a_prior() {
    let Some(free) = googol(Some(RATES_FREE), Weights::Spread, 1e-3) else { return };
    show("initial rates free", &free);
    let prior = googol(Some(RATES_PRIOR), Weights::Spread, 1e-3).unwrap();
    show("prior from the first 0.2 s", &prior);
    // with the prior, elevation depends on how strong it is made: 48 with the slope's plain standard error, 38 with the slope exact
    for (fit, wanted, slack) in [(&free, [85.7, 70.9, 58.3], 0.5), (&prior, [77.3, 48.3, 58.3], 1.0)] {
        assert!(fit.ending.converged(), "{}", fit.ending);
        for (signal, wanted) in ["psi", "eps", "theta"].into_iter().zip(wanted) {
            let found = figure(fit, signal);
            assert!((found - wanted).abs() < slack, "{signal}: {found} instead of {wanted}");
        }
    }
}

#[test]
fn the_cost_that_scipy_and_casadi_find() {
    let scales = vec![("psi".to_owned(), 1.0), ("eps".to_owned(), 0.1), ("theta".to_owned(), 0.03)];
    let Some(fit) = googol(Some(RATES_FREE), Weights::Given(scales), 1e-3) else { return };
    show("baseline", &fit);
    assert!((fit.cost / 7739.2119 - 1.0).abs() < 1e-6, "{}", fit.cost);
}

/// A record simulated by the adaptive integrator, with noise and encoder.
fn simulated(model: &InProcess, p: &[f64], x0: &[f64], inputs: Vec<Vec<f64>>, period: f64, random: &mut Random, quantum: f64) -> Record {
    let count = inputs[0].len();
    let t: Vec<f64> = (0..count).map(|k| period * k as f64).collect();
    let signals = Signals::new(inputs.iter().map(|u| Signal { t: t.clone(), values: u.clone(), hold: Hold::Zero }).collect()).unwrap();
    let run = simulate(model, p, x0, &signals, &t, &sim::Options::default()).unwrap();
    let d = model.dimensions();
    let mut columns: Vec<Column> =
        inputs.into_iter().enumerate().map(|(i, values)| Column { name: model.names().signal(i).to_owned(), unit: None, values }).collect();
    for i in 0..d.outputs {
        let noisy = |y: f64, random: &mut Random| {
            let normal: f64 = (0..12).map(|_| random.within(-0.5, 0.5)).sum();
            ((y + 0.5 * quantum * normal) / quantum).round() * quantum
        };
        let values = run.output(i).into_iter().map(|y| noisy(y, random)).collect();
        columns.push(Column { name: model.names().output(i).to_owned(), unit: None, values });
    }
    Record { source: "simulated".to_owned(), t, columns, declared: Vec::new(), start: Start::Free }
}

const PENDULUM: &str = "rig Pendulum {
    param J: kg*m^2 = 0.02; param mgl: N*m = 0.5; param c: N*m*s/rad = 0.01; param K: N*m/V = 0.1;
    coord q: rad; input V: V in -5..5;
    equation J * q.ddot = K * V - mgl * sin(q) - c * q.dot;
    encoder q: 2048;
}";

#[test]
fn intervals_cover_the_truth_and_no_start_diverges() {
    let (rig, model) = rig_from(PENDULUM);
    let nominal = ParameterSpec::of_rig(&rig);
    let mut random = Random::new(7);
    let (mut covered, mut total, mut worst) = (0, 0, 0.0_f64);
    for run in 0..20 {
        let truth: Vec<f64> = nominal.iter().map(|s| s.value * random.within(0.7, 1.4)).collect();
        let mut level = 0.0;
        let input = (0..1500)
            .map(|k| {
                if k % 75 == 0 {
                    level = random.within(-3.0, 3.0);
                }
                level
            })
            .collect();
        let record = simulated(&model, &truth, &[0.2, -0.5], vec![input], 0.005, &mut random, std::f64::consts::TAU / 2048.0);
        // mgl alone fixes the scale of the equation
        let mut specs = nominal.clone();
        for (s, truth) in specs.iter_mut().zip(&truth) {
            s.value = if s.name == "mgl" { *truth } else { truth * if random.chance(0.5) { 2.0 } else { 0.5 } };
        }
        select(&mut specs, None, &list("mgl")).unwrap();
        let fit = identify(&model, &specs, &[record], &[], &FitOptions::default()).unwrap();
        if run == 0 {
            show("pendulum", &fit);
        }
        assert!(fit.ending.converged(), "run {run}: {}", fit.ending);
        for e in &fit.parameters {
            let truth = truth[specs.iter().position(|s| s.name == e.name).unwrap()];
            let (lo, hi) = e.ci95.unwrap();
            covered += usize::from(lo <= truth && truth <= hi);
            total += 1;
            worst = worst.max((e.value / truth - 1.0).abs());
        }
    }
    println!("pendulum: {covered} of {total} intervals cover the truth, largest error {:.2} %", 100.0 * worst);
    assert!(worst < 0.05 && covered * 100 >= 85 * total);
}
