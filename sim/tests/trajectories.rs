//! Adaptive runs against closed forms, and every way in which they end.

mod models;

use models::{Duffing, Explosion, Growth, Hand, Led, Linear, Misread, Paths, Pendulum, VanDerPol, Wall};
use nalgebra::{DMatrix, DVector};
use runtime::Model;
use sim::{Hold, Method, Options, Signal, Signals, SimError, Status, Trajectory, simulate};

fn times(end: f64, n: u32) -> Vec<f64> {
    (0..=n).map(|k| end * f64::from(k) / f64::from(n)).collect()
}

fn run(model: &dyn Model, p: &[f64], x0: &[f64], t: &[f64]) -> Trajectory {
    simulate(model, p, x0, &Signals::constant(&[0.0]).unwrap(), t, &Options::default()).unwrap()
}

/// x' = A x + B u with u held: exp of the block matrix, from switch to switch.
fn exact(p: &[f64], x0: &[f64], switches: &[(f64, f64)], t: f64) -> Vec<f64> {
    let mut x = DVector::from_row_slice(&[x0, &[0.0]].concat());
    for (k, &(from, u)) in switches.iter().enumerate() {
        let to = switches.get(k + 1).map_or(t, |s| s.0.min(t));
        if to <= from {
            break;
        }
        x[3] = u;
        let block = DMatrix::from_row_slice(
            4,
            4,
            &[0.0, 1.0, 0.0, 0.0, -p[0] * p[0], -2.0 * p[1], 1.0, 0.0, 0.0, 0.0, -1.0 / p[2], 1.0 / p[2], 0.0, 0.0, 0.0, 0.0],
        );
        x = (block * (to - from)).exp() * x;
    }
    x.as_slice()[..3].to_vec()
}

#[test]
fn linear_system_with_switches_between_samples_is_the_matrix_exponential() {
    let (p, x0) = ([5.0, 0.3, 0.1], [0.4, -1.0, 0.2]);
    // switches at times that are no multiples of the sample time
    let switches = [(0.0, 1.0), (0.7303, -2.0), (0.7304, 3.0), (2.0 / 3.0 + 1.0, 0.5)];
    let signal = Signal { t: switches.iter().map(|s| s.0).collect(), values: switches.iter().map(|s| s.1).collect(), hold: Hold::Zero };
    let t = times(3.0, 300);
    let out = simulate(&Hand(Linear), &p, &x0, &Signals::new(vec![signal]).unwrap(), &t, &Options::default()).unwrap();
    assert_eq!(out.status, Status::Completed);
    let worst = t
        .iter()
        .enumerate()
        .flat_map(|(k, &t)| exact(&p, &x0, &switches, t).into_iter().zip(out.state(k)).map(|(e, x)| (e - x).abs()).collect::<Vec<_>>())
        .fold(0.0, f64::max);
    // each step may err by its tolerance; states stay below 3
    assert!(worst < out.steps as f64 * 3e-10, "{worst:e} after {} steps", out.steps);
}

#[test]
fn straight_inputs_between_samples() {
    // q'' = u with u = 6 t from 0 to 1: q = t^3
    let signal = Signal { t: vec![0.0, 1.0], values: vec![0.0, 6.0], hold: Hold::First };
    let p = [0.0, 0.0, 1.0];
    let t = times(1.0, 10);
    let out = simulate(&Hand(Pendulum), &p, &[0.0, 0.0], &Signals::new(vec![signal]).unwrap(), &t, &Options::default()).unwrap();
    for (k, t) in t.iter().enumerate() {
        assert!((out.state(k)[0] - t.powi(3)).abs() < 1e-9, "{t}");
    }
}

#[test]
fn energy_of_the_duffing_oscillator_stays() {
    let x0 = [1.0, -0.5, 0.3, 0.8];
    let t = times(100.0, 1000);
    let out = run(&Hand(Duffing), &[1.0], &x0, &t);
    let energy = Duffing::energy(&x0);
    let worst = (0..t.len()).map(|k| (Duffing::energy(out.state(k)) / energy - 1.0).abs()).fold(0.0, f64::max);
    // each step may err by its tolerance in each of four states
    assert!(worst < out.steps as f64 * 4e-10, "{worst:e} after {} steps", out.steps);
    let tight = Options { relative: 1e-12, absolute: 1e-13, ..Options::default() };
    let out = simulate(&Hand(Duffing), &[1.0], &x0, &Signals::constant(&[0.0]).unwrap(), &t, &tight).unwrap();
    let worst = (0..t.len()).map(|k| (Duffing::energy(out.state(k)) / energy - 1.0).abs()).fold(0.0, f64::max);
    assert!(worst < out.steps as f64 * 4e-12, "{worst:e} after {} steps", out.steps);
}

#[test]
fn limits_delays_and_encoder() {
    // commanded 5, limited to 1, felt 0.125 s later: q = (t - 1.125)^2 / 2; before that nothing
    let signal = Signal { t: vec![0.0, 1.0], values: vec![0.0, 5.0], hold: Hold::Zero };
    let signals = Signals::new(vec![signal]).unwrap();
    let t = times(4.0, 64);
    let moved = |t: f64| 0.5 * (t - 1.125).max(0.0).powi(2);
    let plain = simulate(&Hand(Paths), &[1.0], &[0.0, 0.0], &signals, &t, &Options::default()).unwrap();
    let counted = simulate(&Hand(Paths), &[1.0], &[0.0, 0.0], &signals, &t, &Options { encoders: true, ..Options::default() }).unwrap();
    for (k, &t) in t.iter().enumerate() {
        assert!((plain.state(k)[0] - moved(t)).abs() < 1e-9, "{t}");
        assert!((plain.outputs(k)[0] - moved(t - 0.25)).abs() < 1e-9, "{t}");
        let counts = counted.outputs(k)[0] / 0.01;
        assert!((counts - counts.round()).abs() < 1e-9 && (counted.outputs(k)[0] - plain.outputs(k)[0]).abs() < 0.0051);
    }
}

#[test]
fn a_triangle_through_a_play() {
    // up to 1, down to -1, up again; everything is read 0.25 s later
    let signal = Signal { t: vec![0.0, 1.0, 3.0], values: vec![1.0, -1.0, 1.0], hold: Hold::Zero };
    let signals = Signals::new(vec![signal]).unwrap();
    let read = |t: &[f64], encoders: bool| {
        simulate(&Hand(Led), &[1.0], &[0.0, 0.0], &signals, t, &Options { encoders, ..Options::default() }).unwrap().output(0)
    };
    // half of the play is lost at the start, all of it at each turn
    let by_hand = |t: f64| match t - 0.25 {
        t if t < 0.25 => 0.0,
        t if t < 1.0 => t - 0.25,
        t if t < 1.5 => 0.75,
        t if t < 3.0 => 2.25 - t,
        t if t < 3.5 => -0.75,
        t => t - 4.25,
    };
    let t = times(5.0, 80);
    let (plain, counted) = (read(&t, false), read(&t, true));
    for (k, &t) in t.iter().enumerate() {
        assert!((plain[k] - by_hand(t)).abs() < 1e-9, "{t}: {}", plain[k]);
        // the encoder is behind the play
        assert!((counted[k] / 0.125).fract() == 0.0 && (counted[k] - plain[k]).abs() < 0.0626, "{t}: {}", counted[k]);
    }
    // motion between samples is not seen: at these times it has come back to where it was
    assert!(read(&[0.25, 2.25, 4.25], false).iter().all(|r| r.abs() < 1e-9));
}

#[test]
fn stiff_run_goes_implicit() {
    // reference: Hairer and Wanner's test set, mu = 1000 at t = 2000
    let t = [0.0, 1000.0, 2000.0];
    let auto = run(&Hand(VanDerPol), &[1000.0], &[2.0, 0.0], &t);
    assert_eq!(auto.status, Status::Completed);
    let error = (auto.state(2)[0] - 1.706_167_732_170_483).abs();
    assert!(error < 1e-6, "{error:e}");
    let explicit = Options { method: Method::Explicit, max_steps: 50_000, ..Options::default() };
    let stuck = simulate(&Hand(VanDerPol), &[1000.0], &[2.0, 0.0], &Signals::constant(&[0.0]).unwrap(), &t, &explicit).unwrap();
    assert!(matches!(stuck.status, Status::TooManySteps { steps: 50_000, .. }), "{:?}", stuck.status);
    assert!(auto.steps < 10_000, "{} steps", auto.steps);
    println!("van der Pol, mu = 1000: {} steps, error {error:.1e}", auto.steps);
}

#[test]
fn implicit_method_agrees_with_the_explicit_one() {
    let t = times(5.0, 50);
    let p = [9.81, 0.1, 1.0];
    let explicit = run(&Hand(Pendulum), &p, &[2.0, 0.0], &t);
    let error = |relative: f64| {
        let options = Options { method: Method::Implicit, relative, absolute: 0.1 * relative, ..Options::default() };
        let implicit = simulate(&Hand(Pendulum), &p, &[2.0, 0.0], &Signals::constant(&[0.0]).unwrap(), &t, &options).unwrap();
        let e = explicit.x.iter().zip(&implicit.x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!("implicit at {relative:e}: {e:e}, {} steps", implicit.steps);
        e
    };
    // in the worst of 50 points a few times the tolerance of a step
    let [coarse, fine] = [1e-7, 1e-9].map(error);
    assert!(coarse < 1e-6 && fine < 1e-8, "{coarse:e} {fine:e}");
}

#[test]
fn mass_matrix_that_turns_singular_ends_the_run_there() {
    let t = times(2.0, 20);
    let out = run(&Hand(Wall), &[0.8], &[0.0, 0.0], &t);
    let Status::Singular { coordinate, t: end } = &out.status else { panic!("{:?}", out.status) };
    assert_eq!(coordinate, "q0");
    assert!((end - 1.25).abs() < 1e-9, "{end}");
    assert_eq!(out.valid_until, *end);
    assert_eq!(out.t.len(), 13, "rows up to 1.2 s");
    assert!((out.state(12)[0] - 0.96).abs() < 1e-9);
    assert_eq!(out.status.to_string(), "the mass matrix turned singular in `q0` at t = 1.2500 s");
    // singular from the start
    let out = run(&Hand(Wall), &[0.8], &[1.5, 0.0], &t);
    assert_eq!((out.status.time(), out.t.len()), (Some(0.0), 1));
    // the same with the implicit method
    let options = Options { method: Method::Implicit, ..Options::default() };
    let out = simulate(&Hand(Wall), &[0.8], &[0.0, 0.0], &Signals::constant(&[0.0]).unwrap(), &t, &options).unwrap();
    assert!(matches!(out.status, Status::Singular { .. }) && (out.valid_until - 1.25).abs() < 1e-6, "{:?}", out.status);
}

#[test]
fn solutions_that_end_or_leave_all_bounds() {
    let t = times(10.0, 100);
    let out = run(&Hand(Explosion), &[1.0], &[0.0, 0.0], &t);
    let end = std::f64::consts::PI / 2.0_f64.sqrt();
    assert!(matches!(out.status, Status::StepCollapsed { .. } | Status::NotFinite { .. }), "{:?}", out.status);
    assert!((out.valid_until - end).abs() < 1e-6, "{} {end}", out.valid_until);
    let out = run(&Hand(Growth), &[100.0], &[1.0, 0.0], &t);
    let Status::NotFinite { state, t } = &out.status else { panic!("{:?}", out.status) };
    assert!(state == "q0" || state == "q0.dot", "{state}");
    // cosh(100 t) passes the root of the largest number at 3.55 s and that number at 7.1 s
    assert!((3.5..7.2).contains(t), "{t}");
    assert!(out.x.iter().all(|x| x.is_finite()));
}

#[test]
fn wrong_arguments() {
    let model = Hand(Pendulum);
    let (p, x0, t) = ([1.0; 3], [0.0; 2], [0.0, 1.0]);
    let u = Signals::constant(&[0.0]).unwrap();
    let call =
        |p: &[f64], x0: &[f64], u: &Signals, t: &[f64], options: Options| simulate(&model, p, x0, u, t, &options).unwrap_err().to_string();
    let options = Options::default();
    assert_eq!(call(&[1.0], &x0, &u, &t, options), "1 parameters were given, the model has 3");
    assert_eq!(call(&[1.0, f64::NAN, 1.0], &x0, &u, &t, options), "parameter p is not a finite number");
    assert_eq!(call(&p, &[0.0], &u, &t, options), "1 initial states were given, the model has 2");
    assert_eq!(call(&p, &[0.0, f64::INFINITY], &u, &t, options), "the initial value of q0.dot is not a finite number");
    assert_eq!(call(&p, &x0, &Signals::constant(&[]).unwrap(), &t, options), "0 signals were given, the model has 1");
    assert_eq!(call(&p, &x0, &u, &[], options), "there are no times of the outputs");
    assert_eq!(call(&p, &x0, &u, &[0.0, 1.0, 1.0], options), "the times of the outputs must increase, number 3 (1 s) does not");
    assert_eq!(call(&p, &x0, &u, &t, Options { relative: -1.0, ..options }), "the relative tolerance must be a positive number, not -1");
    let misread = simulate(&Hand(Misread), &[1.0], &x0, &u, &t, &options).unwrap_err();
    assert_eq!(misread.to_string(), "the play of q0 is -0.5; a play is zero or positive");
    let signal = |t: Vec<f64>, values: Vec<f64>| Signals::new(vec![Signal { t, values, hold: Hold::Zero }]).unwrap_err();
    assert_eq!(signal(vec![0.0, 0.0], vec![1.0, 1.0]), SimError::Order { what: "time stamps of a signal", index: 1, t: 0.0 });
    assert_eq!(signal(vec![0.0], vec![f64::NAN]).to_string(), "sample 1 of signal 1 is not a finite number");
    assert_eq!(signal(vec![0.0], vec![]).to_string(), "0 samples of a signal were given, the model has 1");
}
