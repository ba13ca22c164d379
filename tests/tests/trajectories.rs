//! Runs of whole rigs: prescribed motion, delays and plays of a rig, conservation of energy.

use codegen::{Options, derive};
use jit::InProcess;
use runtime::Model;
use sim::{Hold, Signal, Signals, Status, simulate};

fn model(text: &str) -> (InProcess, Vec<f64>) {
    let checked = model_dsl::check_text("test.rig", text);
    let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    let model = InProcess::new(derive(&checked.rig.unwrap_or_else(|| panic!("{}", shown.join("\n"))), Options::default()).unwrap());
    let mut p = vec![0.0; model.dimensions().parameters];
    model.nominal(&mut p);
    (model, p)
}

fn times(end: f64, n: u32) -> Vec<f64> {
    (0..=n).map(|k| end * f64::from(k) / f64::from(n)).collect()
}

#[test]
fn a_prescribed_coordinate_follows_its_acceleration() {
    // a mass on a spring, its support moved with the acceleration 2 m/s^2 for 1 s, then stopped with -2 m/s^2
    let (model, p) = model(
        "rig Cart { param m: kg = 2; prescribed s: m; coord x: m;\n\
         frame support = ground.translate(s, 0, 0); frame mass = support.translate(x, 0, 0);\n\
         body block on mass { mass m; } spring k on x { stiffness 18 [N/m]; } }",
    );
    assert_eq!((model.names().signal(0), model.dimensions().exogenous), ("s.ddot", 1));
    let signal = Signal { t: vec![0.0, 1.0, 2.0], values: vec![2.0, -2.0, 0.0], hold: Hold::Zero };
    let run = simulate(&model, &p, &[0.0; 4], &Signals::new(vec![signal]).unwrap(), &times(2.0, 20), &sim::Options::default()).unwrap();
    assert_eq!(run.status, Status::Completed);
    for (k, &t) in run.t.iter().enumerate() {
        let later = (t - 1.0).max(0.0);
        // x'' = -9 x - s'': a step of the acceleration by a moves x by -a (1 - cos 3t)/9
        let answer = |t: f64| (1.0 - (3.0 * t).cos()) / 9.0;
        let (s, x) = (t * t - 2.0 * later * later, -2.0 * answer(t) + 4.0 * answer(later));
        assert!((run.state(k)[0] - s).abs() < 1e-8 && (run.state(k)[1] - x).abs() < 1e-8, "{t}: {:?}, {s} {x}", run.state(k));
    }
}

#[test]
fn delays_and_limits_of_a_rig() {
    let (model, p) = model(
        "rig Slide { param m: kg = 1; param d: s = 0.03; coord x: m; frame f = ground.translate(x, 0, 0); body b on f { mass m; }\n\
         input u: N in -1..1 { delay d; } torque push on x: u; output y: m = x { delay 50 ms; } }",
    );
    let signal = Signal { t: vec![0.0, 0.2], values: vec![0.0, 7.0], hold: Hold::Zero };
    let run = simulate(&model, &p, &[0.0; 2], &Signals::new(vec![signal]).unwrap(), &times(1.0, 40), &sim::Options::default()).unwrap();
    for (k, &t) in run.t.iter().enumerate() {
        let moved = |t: f64| 0.5 * (t - 0.23).max(0.0).powi(2);
        assert!((run.state(k)[0] - moved(t)).abs() < 1e-9 && (run.outputs(k)[0] - moved(t - 0.05)).abs() < 1e-9, "{t}");
    }
}

/// x = 0.1 sin 2t, shown twice as large behind a play of 0.08: 0.06 at the first turn, held there until 0.2 sin 2t is 0.02.
const SWINGING: &str = "rig Swinging { param m: kg = 1; param w: m = 0.04; coord x: m; frame f = ground.translate(x, 0, 0);\n\
     body b on f { mass m; } spring k on x { stiffness 4 [N/m]; } input u: N; torque push on x: u;\n\
     output y: m = x { scale 2; play 2 * w; } output x: mm = x { play 20 mm; } }";

fn swinging(t: f64, amplitude: f64, half: f64) -> f64 {
    let (y, turn) = (amplitude * (2.0 * t).sin(), std::f64::consts::FRAC_PI_4);
    match t {
        t if t < turn => (y - half).max(0.0),
        t if t < 3.0 * turn => (y + half).min(amplitude - half),
        _ => (y - half).max(half - amplitude),
    }
}

#[test]
fn plays_of_a_rig() {
    let (model, p) = model(SWINGING);
    assert_eq!((model.output_path(0, &p).play, model.output_path(0, &[1.0, 0.01]).play), (0.08, 0.02));
    let t = times(std::f64::consts::PI, 64);
    let run = simulate(&model, &p, &[0.0, 0.2], &Signals::constant(&[0.0]).unwrap(), &t, &sim::Options::default()).unwrap();
    for (k, &t) in run.t.iter().enumerate() {
        let wanted = [swinging(t, 0.2, 0.04), swinging(t, 0.1, 0.01)];
        assert!(run.outputs(k).iter().zip(wanted).all(|(y, w)| (y - w).abs() < 1e-8), "{t}: {:?} {wanted:?}", run.outputs(k));
    }
}

/// Does nothing.
struct Idle;

impl control::Controller for Idle {
    fn command(&mut self, _: f64, _: &[f64], u: &mut [f64]) -> Result<(), String> {
        u.fill(0.0);
        Ok(())
    }
    fn applied(&mut self, _: &[f64]) {}
    fn references(&self) -> &[Option<(f64, f64)>] {
        &[]
    }
}

#[test]
fn plays_in_a_closed_loop() {
    let (model, p) = model(SWINGING);
    let period = std::f64::consts::PI / 64.0;
    let bench = control::Bench { x: vec![0.0, 0.2], period, duration: 64.0 * period, max_step: 1e-3, encoders: false, limits: true };
    let run = control::run(&model, &p, &bench, &control::Surroundings::default(), &mut Idle).unwrap();
    assert_eq!(run.t.len(), 65);
    for (k, &t) in run.t.iter().enumerate() {
        let wanted = [swinging(t, 0.2, 0.04), swinging(t, 0.1, 0.01)];
        assert!(run.read[k].iter().zip(wanted).all(|(y, w)| (y - w).abs() < 1e-8), "{t}: {:?} {wanted:?}", run.read[k]);
        assert!((run.y[k][0] - 0.2 * (2.0 * t).sin()).abs() < 1e-8, "y is what is there, not what is read");
    }
}

#[test]
fn a_double_pendulum_keeps_its_energy() {
    let (model, p) = model(
        "rig Double { param m: kg = 1; param l: m = 0.5; const g: m/s^2 = 9.81; coord a: rad; coord b: rad;\n\
         frame f = ground.rotate(y, a); frame h = f.translate(0, 0, -l).rotate(y, b);\n\
         body u on f { mass m; at (0, 0, -l); } body v on h { mass m; at (0, 0, -l); } gravity g; }",
    );
    let x0 = [2.0, -1.0, 0.5, 3.0];
    let run = simulate(&model, &p, &x0, &Signals::new(Vec::new()).unwrap(), &times(10.0, 100), &sim::Options::default()).unwrap();
    let energy = |x: &[f64]| {
        let (m, l, g) = (1.0, 0.5, 9.81);
        let (c, s) = (x[0] + x[1], x[2] + x[3]);
        let (vx, vz) = (l * (x[0].cos() * x[2] + c.cos() * s), l * (x[0].sin() * x[2] + c.sin() * s));
        0.5 * m * (l * x[2]).powi(2) + 0.5 * m * (vx * vx + vz * vz) - m * g * l * (2.0 * x[0].cos() + c.cos())
    };
    let first = energy(&x0);
    let worst = (0..run.t.len()).map(|k| (energy(run.state(k)) - first).abs()).fold(0.0, f64::max);
    // each step may err by 1e-10 of each state; the energy's slopes are below 30
    assert!(run.status == Status::Completed && worst < run.steps as f64 * 4.0 * 30e-10, "{worst:e} after {} steps", run.steps);
    println!("double pendulum: energy {first:.3} J kept to {worst:.1e} J over {} steps", run.steps);
}
