//! Multiple shooting: it finds what one long run cannot, and ends where output error does.

use codegen::{Options, derive};
use cross_checks::random::Random;
use ident::fit::{Fit, FitOptions, ParameterSpec, Starting, identify};
use ident::record::{Column, Record, Start};
use jit::InProcess;
use runtime::Model;
use sim::{Hold, Signal, Signals, simulate};
use std::f64::consts::TAU;

/// Two rods in the plane, q2 counted from the first rod; unit masses and lengths but for what is fitted. In free swing from high up its
/// motion is chaotic.
const DOUBLE: &str = "rig Double {
    param m: kg = 1.0 in 0.05..20; param c: N*m*s/rad = 0.02 in 0..1; param l: m = 1 fixed; param M: kg = 1.0 fixed; const g: m/s^2 = 9.81;
    coord q: rad; coord r: rad; input T: N*m in -5..5;
    gravity g along -z;
    frame one = ground.rotate(y, q); frame elbow = one.translate(0, 0, -l); frame two = elbow.rotate(y, r);
    body first on one { mass M; at (0, 0, -l); }
    body second on two { mass m; at (0, 0, -l); }
    torque drive on q: T - c * q.dot; torque brake on r: -c * r.dot;
    encoder q: 4096; encoder r: 4096;
}";

const PENDULUM: &str = "rig Pendulum {
    param J: kg*m^2 = 0.02; param mgl: N*m = 0.5 fixed; param c: N*m*s/rad = 0.01; param K: N*m/V = 0.1;
    coord q: rad; input V: V in -5..5;
    equation J * q.ddot = K * V - mgl * sin(q) - c * q.dot;
    encoder q: 2048;
}";

fn model(text: &str) -> (Vec<ParameterSpec>, InProcess) {
    let checked = model_dsl::check_text("test.rig", text);
    let rig = checked.rig.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    (ParameterSpec::of_rig(&rig), InProcess::new(derive(&rig, Options::default()).unwrap()))
}

fn record(model: &InProcess, p: &[f64], x0: &[f64], (count, period, quantum): (usize, f64, f64), random: &mut Random) -> Record {
    let t: Vec<f64> = (0..count).map(|k| period * k as f64).collect();
    let mut level = 0.0;
    let mut input = Vec::with_capacity(count);
    for k in 0..count {
        if k % 60 == 0 {
            level = random.within(-2.0, 2.0);
        }
        input.push(level);
    }
    let signals = Signals::new(vec![Signal { t: t.clone(), values: input.clone(), hold: Hold::Zero }]).unwrap();
    let exact = sim::Options { relative: 1e-11, absolute: 1e-12, ..sim::Options::default() };
    let run = simulate(model, p, x0, &signals, &t, &exact).unwrap();
    let mut columns = vec![Column { name: model.names().signal(0).to_owned(), unit: None, values: input }];
    for i in 0..model.dimensions().outputs {
        let noisy = |y: f64, random: &mut Random| {
            let normal: f64 = (0..12).map(|_| random.within(-0.5, 0.5)).sum();
            ((y + 0.5 * quantum * normal) / quantum).round() * quantum
        };
        let values = run.output(i).into_iter().map(|y| noisy(y, random)).collect();
        columns.push(Column { name: model.names().output(i).to_owned(), unit: None, values });
    }
    Record { source: "simulated".to_owned(), t, columns, declared: Vec::new(), start: Start::Free }
}

fn off(specs: &[ParameterSpec], factor: f64) -> Vec<ParameterSpec> {
    let mut off = specs.to_vec();
    off.iter_mut().filter(|s| s.free).for_each(|s| s.value *= factor);
    off
}

fn worst(fit: &Fit, specs: &[ParameterSpec]) -> f64 {
    let error = |name: &str, value: f64| specs.iter().find(|s| s.name == name).map_or(f64::NAN, |s| (value / s.value - 1.0).abs());
    fit.parameters.iter().map(|e| error(&e.name, e.value)).fold(0.0, f64::max)
}

#[test]
fn a_chaotic_record_from_starts_off_by_two() {
    let (specs, model) = model(DOUBLE);
    let truth: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let mut random = Random::new(3);
    let record = record(&model, &truth, &[2.6, 0.4, 0.0, 0.0], (700, 0.01, TAU / 4096.0), &mut random);
    for factor in [0.5, 2.0] {
        let start = off(&specs, factor);
        let free = FitOptions { starting: Starting::Nominal, ..FitOptions::default() };
        let single = identify(&model, &start, std::slice::from_ref(&record), &[], &free).unwrap();
        // one run's errors are as large as the motion: no minimum near the truth is in reach
        let shooting = FitOptions { shooting: Some(0.5), ..free };
        let joined = identify(&model, &start, std::slice::from_ref(&record), &[], &shooting).unwrap();
        println!(
            "from {factor} times the truth: one run {}, errors to {:.1e}, {:.1} s; shooting {}, errors to {:.1e}, {:.1} s",
            single.ending,
            worst(&single, &specs),
            single.seconds,
            joined.ending,
            worst(&joined, &specs),
            joined.seconds
        );
        for e in &joined.parameters {
            println!("  {} = {} +- {:?}, {:?}", e.name, e.value, e.std_error, e.ci95);
        }
        assert!(!single.ending.converged() || worst(&single, &specs) > 0.05, "one run finds it too: the record is too easy for this test");
        assert!(joined.ending.converged() && worst(&joined, &specs) < 0.01, "{}: {:?}", joined.ending, joined.parameters);
    }
}

#[test]
fn where_one_run_converges_shooting_ends_at_the_same_estimate() {
    let (specs, model) = model(PENDULUM);
    let truth: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let mut random = Random::new(4);
    let record = record(&model, &truth, &[0.2, -0.5], (1500, 0.005, TAU / 2048.0), &mut random);
    let start = off(&specs, 2.0);
    let single = identify(&model, &start, std::slice::from_ref(&record), &[], &FitOptions::default()).unwrap();
    for length in [0.3, 1.0, 3.0] {
        let options = FitOptions { shooting: Some(length), ..FitOptions::default() };
        let joined = identify(&model, &start, std::slice::from_ref(&record), &[], &options).unwrap();
        assert!(single.ending.converged() && joined.ending.converged(), "{}, {}", single.ending, joined.ending);
        for (one, many) in single.parameters.iter().zip(&joined.parameters) {
            let (own, other) = (one.std_error.unwrap(), many.std_error.unwrap());
            let apart = (one.value - many.value).abs() / own;
            println!(
                "pieces of {length} s: {} {} and {}: {apart:.1e} standard errors apart, standard errors {own:.3e} and {other:.3e}",
                one.name, one.value, many.value
            );
            assert!(apart < 0.02, "{}: {} and {}", one.name, one.value, many.value);
            assert!((other / own - 1.0).abs() < 0.1, "{}: standard errors {own} and {other}", one.name);
        }
    }
}
