//! The Quanser's carriage in its two ways: driven by a motor, and moved from outside. What one does when it is fed the
//! other's motion, what is left of it when it stands still, and what it does to trim and inertia on its way.

use codegen::{Equations, Lumps, Options, derive};
use cross_checks::random::Random;
use cross_checks::{rig_of, root};
use jit::InProcess;
use runtime::Model;
use sim::{Hold, Signal, Signals, Status, simulate};

fn example(name: &str) -> Equations {
    derive(&rig_of(&root().join("examples/rigs").join(name)), Options::default()).expect("derives")
}

fn nominal(model: &InProcess) -> Vec<f64> {
    let mut p = vec![0.0; model.dimensions().parameters];
    model.nominal(&mut p);
    p
}

fn state(model: &InProcess, name: &str) -> usize {
    (0..model.dimensions().states()).find(|&i| model.names().state(i) == name).expect("a state")
}

/// Motor voltages of the test: a start, a stop, a way back.
fn motor(t: f64) -> f64 {
    if t < 1.0 {
        1.5
    } else if t < 1.5 {
        0.0
    } else {
        -2.0
    }
}

/// s' of the driven rig goes into the prescribed one at every stage of one Runge-Kutta step: both are the same map.
#[test]
fn the_prescribed_rig_fed_the_driven_ones_motion_is_the_driven_rig() {
    let (driven, prescribed) = (InProcess::new(example("quanser_ads_driven.rig")), InProcess::new(example("quanser_ads.rig")));
    let (p, r) = (nominal(&driven), nominal(&prescribed));
    let n = driven.dimensions().states();
    assert_eq!(n, prescribed.dimensions().states());
    let (s, s_dot) = (state(&driven, "s"), state(&driven, "s.dot"));
    assert_eq!((s, s_dot), (state(&prescribed, "s"), state(&prescribed, "s.dot")));
    let both = |t: f64, x: &[f64]| -> Vec<f64> {
        let mut dx = vec![0.0; 2 * n];
        let (voltage_f, voltage_b) = (-2.4 + 0.3 * t.sin(), -2.6);
        driven.rhs(t, &x[..n], &[voltage_f, voltage_b, motor(t)], &p, &mut dx[..n]).expect("regular");
        let push = dx[s_dot];
        prescribed.rhs(t, &x[n..], &[voltage_f, voltage_b, push], &r, &mut dx[n..]).expect("regular");
        dx
    };
    let (mut x, h) = (vec![0.0; 2 * n], 1e-3);
    x[1] = 0.1;
    x[n + 1] = 0.1;
    let (mut worst, mut moved, mut swing) = (0.0_f64, 0.0_f64, 0.0_f64);
    for k in 0..2500 {
        let t = f64::from(k) * h;
        let shifted = |k: &[f64], a: f64| x.iter().zip(k).map(|(x, k)| x + a * k).collect::<Vec<f64>>();
        let k1 = both(t, &x);
        let k2 = both(t + 0.5 * h, &shifted(&k1, 0.5 * h));
        let k3 = both(t + 0.5 * h, &shifted(&k2, 0.5 * h));
        let k4 = both(t + h, &shifted(&k3, h));
        for i in 0..2 * n {
            x[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
        worst = (0..n).map(|i| (x[i] - x[n + i]).abs()).fold(worst, f64::max);
        moved = moved.max(x[s].abs());
        swing = swing.max((x[1] - 0.1).abs());
    }
    assert!(moved > 0.03 && swing > 0.05, "the carriage moved {moved} m, the arm {swing} rad: nothing was tested");
    assert!(worst < 1e-12, "{worst:e}");
    println!("driven against prescribed: carriage {moved:.3} m, arm {swing:.3} rad, largest difference {worst:.1e}");
}

/// The same through the program's own simulation: s'' of the driven run as samples, straight lines between them.
#[test]
fn samples_of_the_driven_run_steer_the_prescribed_rig() {
    let (driven, prescribed) = (InProcess::new(example("quanser_ads_driven.rig")), InProcess::new(example("quanser_ads.rig")));
    let (p, r) = (nominal(&driven), nominal(&prescribed));
    let difference = |samples: u32| -> f64 {
        let times: Vec<f64> = (0..=samples).map(|k| 2.0 * f64::from(k) / f64::from(samples)).collect();
        // a voltage that rises from zero: s'' has no jump
        let volts: Vec<f64> = times.iter().map(|t| 1.5 * (1.0 - (std::f64::consts::PI * t).cos())).collect();
        let motor = Signal { t: times.clone(), values: volts.clone(), hold: Hold::First };
        let signals = Signals::new(vec![Signal::constant(-2.5), Signal::constant(-2.5), motor]).expect("signals");
        let n = driven.dimensions().states();
        let run = simulate(&driven, &p, &vec![0.0; n], &signals, &times, &sim::Options::default()).expect("runs");
        assert_eq!(run.status, Status::Completed);
        let s_dot = state(&driven, "s.dot");
        let pushes: Vec<f64> = (0..times.len())
            .map(|k| {
                let mut dx = vec![0.0; n];
                driven.rhs(times[k], run.state(k), &[-2.5, -2.5, volts[k]], &p, &mut dx).expect("regular");
                dx[s_dot]
            })
            .collect();
        let push = Signal { t: times.clone(), values: pushes, hold: Hold::First };
        let signals = Signals::new(vec![Signal::constant(-2.5), Signal::constant(-2.5), push]).expect("signals");
        let other = simulate(&prescribed, &r, &vec![0.0; n], &signals, &times, &sim::Options::default()).expect("runs");
        run.x.iter().zip(&other.x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (difference(2000), difference(20_000));
    assert!(fine < 1e-7, "{fine:e} with samples 0.1 ms apart");
    assert!(coarse / fine > 50.0, "straight lines err with the square of the step: {coarse:e}, then {fine:e}");
    println!("samples 1 ms apart {coarse:.1e}, 0.1 ms apart {fine:.1e}");
}

const PARKED: &str = r#"use "quanser_ads.rig";
rig Parked extends QuanserAds {
    remove output s;
    remove prescribed s;
    param s: m = 0.05;
    remove inner, outer;
}"#;

const FIXED: &str = r#"use "quanser.rig";
rig Fixed extends Quanser {
    param m_s: kg = 0.3;
    param s_0: m = 0;
    param s: m = 0.05;
    body carriage on arm { mass m_s; at (s_0 + s, 0, 0); }
    trim home { zero elevation, pitch; solve V_s, V_d; }
}"#;

/// A rig that stands beside the examples.
fn beside(name: &str, text: &str) -> model_dsl::rig::Rig {
    struct Here(&'static str, String);
    impl model_dsl::Loader for Here {
        fn load(&self, path: &str) -> Result<Vec<u8>, String> {
            if path.ends_with(self.0) { Ok(self.1.clone().into_bytes()) } else { model_dsl::FileLoader.load(path) }
        }
    }
    let name: &'static str = Box::leak(name.to_owned().into_boxed_str());
    let path = root().join("examples/rigs").join(name);
    let checked = model_dsl::check(&path.display().to_string(), &Here(name, text.to_owned()), &model_dsl::CheckOptions::default());
    let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    checked.rig.unwrap_or_else(|| panic!("{}", shown.join("\n")))
}

#[test]
fn a_carriage_that_stands_still_is_a_body_on_the_arm() {
    let (parked, fixed) = (beside("parked_test.rig", PARKED), beside("fixed_test.rig", FIXED));
    let options = Options { lumps: Lumps::Expanded, ..Options::default() };
    let (a, b) = (derive(&parked, options).expect("derives"), derive(&fixed, options).expect("derives"));
    let difference = codegen::display::diff((&parked, &a), (&fixed, &b));
    assert!(difference.added.is_empty() && difference.removed.is_empty() && difference.changed.is_empty(), "{difference}");
    assert!(difference.to_string().starts_with("the equations are the same"), "{difference}");
    // and the diff is no blind one: another place on the arm is seen
    let moved = beside("moved_test.rig", &FIXED.replace("at (s_0 + s, 0, 0)", "at (s_0 + 2 * s, 0, 0)"));
    let c = derive(&moved, options).expect("derives");
    assert!(!codegen::display::diff((&parked, &a), (&moved, &c)).changed.is_empty());

    // the moving rig with s' = s'' = 0 gives the same accelerations at random states
    let (ads, still) = (InProcess::new(example("quanser_ads.rig")), InProcess::new(b));
    let (p, mut r) = (nominal(&ads), nominal(&still));
    let place = (0..r.len()).find(|&i| still.names().parameter(i) == "s").expect("s");
    let mut random = Random::new(5);
    for _ in 0..50 {
        let s = random.within(-0.13, 0.13);
        r[place] = s;
        let q: Vec<f64> = (0..3).map(|_| random.within(-1.0, 1.0)).collect();
        let v: Vec<f64> = (0..3).map(|_| random.within(-2.0, 2.0)).collect();
        let (mut dx, mut dy) = ([0.0; 8], [0.0; 6]);
        ads.rhs(0.0, &[q[0], q[1], q[2], s, v[0], v[1], v[2], 0.0], &[3.0, -2.0, 0.0], &p, &mut dx).expect("regular");
        still.rhs(0.0, &[q[0], q[1], q[2], v[0], v[1], v[2]], &[3.0, -2.0], &r, &mut dy).expect("regular");
        for i in 0..3 {
            assert!((dx[4 + i] - dy[3 + i]).abs() < 1e-12 * dy[3 + i].abs().max(1.0), "{i}: {} {}", dx[4 + i], dy[3 + i]);
        }
    }
}

/// Closed forms with sigma = s_0 + s, at pitch 0. Voltage that holds elevation e:
/// K_f L_a V_s = g ((m_h L_a - m_w L_w + m_s sigma) cos e + d (m_h + m_w + m_s) sin e); inertia of elevation
/// m_h (L_a^2 + d^2) + m_w (L_w^2 + d^2) + m_s (sigma^2 + d^2); of travel, with the distances from the column's axis,
/// m_h (r(L_a)^2 + L_h^2) + m_w r(-L_w)^2 + m_s r(sigma)^2 where r(x) = x cos e + d sin e.
#[test]
fn a_slow_sweep_changes_trim_and_inertia_by_the_closed_form() {
    let e = example("quanser_ads.rig");
    let values: Vec<(String, f64)> = e.layout.p.iter().map(|p| p.name.clone()).zip(e.layout.nominal.iter().copied()).collect();
    let p = |name: &str| values.iter().find(|v| v.0 == name).expect("a parameter").1;
    let (m_h, m_w, m_s, l_a, l_w, l_h, d, k_f, g, s_0) =
        (p("m_h"), p("m_w"), p("m_s"), p("L_a"), p("L_w"), p("L_h"), p("d"), p("K_f"), p("g"), p("s_0"));
    let moment = |s: f64| m_h * l_a - m_w * l_w + m_s * (s_0 + s);
    let mass = m_h + m_w + m_s;
    let roots: Vec<_> = e.mass_matrix.concat();
    let layout = e.layout.clone();
    let inertia = |x: &[f64]| -> (f64, f64) {
        let value = |symbol| {
            let state = layout.x().position(|v| v.symbol == symbol).map(|i| x[i]);
            state.unwrap_or_else(|| layout.p.iter().position(|v| v.symbol == symbol).map_or(0.0, |i| layout.nominal[i]))
        };
        let m = e.graph.evaluate(&roots, value);
        (m[0], m[layout.q.len() + 1])
    };
    // from end to end in 240 s, the voltage held at what balances the arm in the middle
    let (from, to, seconds) = (-0.12, 0.12, 240.0);
    let volts = 0.5 * g * moment(0.0) / (k_f * l_a);
    let level = |s: f64| {
        // A cos e + B sin e = F, the stable one of two solutions
        let (a, b, f) = (g * moment(s), g * d * mass, k_f * l_a * 2.0 * volts);
        (f / a.hypot(b)).asin() - a.atan2(b)
    };
    let speed = (to - from) / seconds;
    let model = InProcess::new(example("quanser_ads.rig"));
    let n = model.dimensions().states();
    let mut x0 = vec![0.0; n];
    (x0[1], x0[3], x0[n - 1]) = (level(from), from, speed);
    let times: Vec<f64> = (0..=240).map(f64::from).collect();
    let signals = Signals::constant(&[volts, volts, 0.0]).expect("signals");
    let run = simulate(&model, &nominal(&model), &x0, &signals, &times, &sim::Options::default()).expect("runs");
    assert_eq!(run.status, Status::Completed);
    let (mut lag, mut worst) = (0.0_f64, 0.0_f64);
    #[allow(clippy::needless_range_loop)] // several trajectories are read at the same sample
    for k in 0..times.len() {
        let x = run.state(k);
        let (elevation, pitch, s) = (x[1], x[2], x[3]);
        let planned = from + speed * times[k];
        // below level with thrust downwards pitch and travel have an unstable pole, up to 0.29 1/s: what rounding makes of
        // pitch grows, and enters the inertias with its square
        assert!(pitch.abs() < 1e-6 && (s - planned).abs() < 1e-8, "pitch {pitch:e}, s {s} for {planned}");
        lag = lag.max((elevation - level(s)).abs());
        let (sin, cos) = elevation.sin_cos();
        let r = |along: f64| along * cos + d * sin;
        let sigma = s_0 + s;
        let travel = m_h * (r(l_a).powi(2) + l_h.powi(2)) + m_w * r(-l_w).powi(2) + m_s * r(sigma).powi(2);
        let lift = m_h * (l_a * l_a + d * d) + m_w * (l_w * l_w + d * d) + m_s * (sigma * sigma + d * d);
        let (m_travel, m_elevation) = inertia(x);
        worst = worst.max((m_travel - travel).abs()).max((m_elevation - lift).abs());
    }
    let change = level(to) - level(from);
    println!("carriage end to end in {seconds} s: elevation changes by {change:.4} rad, at most {lag:.1e} rad off the closed form");
    assert!(change.abs() > 0.5, "{change}");
    // it swings about the closed form as fast as it was started: speed * d(level)/ds / frequency
    assert!(lag < 0.01 * change.abs(), "{lag} of {change}");
    assert!(worst < 1e-12, "{worst:e}");
}

/// The same change in symbols: what the carriage adds to mass matrix and gravity, as `rig diff` prints it.
#[test]
fn what_the_carriage_adds_in_symbols() {
    let (plain, ads) = (rig_of(&root().join("examples/rigs/quanser.rig")), rig_of(&root().join("examples/rigs/quanser_ads.rig")));
    let options = Options { lumps: Lumps::Expanded, jacobians: false, ..Options::default() };
    let (a, b) = (derive(&plain, options).expect("derives"), derive(&ads, options).expect("derives"));
    let difference = codegen::display::diff((&plain, &a), (&ads, &b));
    insta::assert_snapshot!("quanser_to_quanser_ads", difference.to_string());
}
