//! Derivatives of whitened innovations against differences: of the equations' parameters, and of all that a sensor can do, which moves the
//! state at the first sample too.

use codegen::{Options, derive};
use ident::innovations::{Column as By, Noise, Track, likeliest, pass};
use ident::record::{Blocks, Column, Record, Start};
use jit::InProcess;
use runtime::Model;
use sim::{Hold, Signal, Signals, simulate};

const PENDULUM: &str = "rig Pendulum {
    param J: kg*m^2 = 0.02; param mgl: N*m = 0.5; param c: N*m*s/rad = 0.01; param K: N*m/V = 0.1; param pushed: N*m = 0;
    param y_0: rad = 0; param s: 1 = 0; param r: rad/s = 0; param d: s = 0.0001;
    param w: rad = 0;
    coord q: rad; input V: V in -5..5;
    equation J * q.ddot = K * V - mgl * sin(q) - c * q.dot + pushed;
    output q: rad = q { scale 1 + s; bias y_0 + r * t; delay d; play w; }
}";

fn model() -> InProcess {
    model_of(PENDULUM)
}

fn model_of(text: &str) -> InProcess {
    let checked = model_dsl::check_text("test.rig", text);
    let rig = checked.rig.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    InProcess::new(derive(&rig, Options::default()).unwrap())
}

/// A record without noise.
fn record(model: &InProcess, p: &[f64], d: f64) -> Record {
    let t: Vec<f64> = (0..400).map(|k| 0.01 * f64::from(k)).collect();
    let input: Vec<f64> = t.iter().map(|t| if (t % 1.3) < 0.6 { 2.0 } else { -1.5 }).collect();
    let signals = Signals::new(vec![Signal { t: t.clone(), values: input.clone(), hold: Hold::Zero }]).unwrap();
    let exact = sim::Options { relative: 1e-11, absolute: 1e-12, ..sim::Options::default() };
    // the sensor is late: what it shows at t was there at t - d
    let early: Vec<f64> = std::iter::once(0.0).chain(t.iter().skip(1).map(|t| t - d)).collect();
    let run = simulate(model, p, &[0.3, 1.0], &signals, &early, &exact).unwrap();
    let mut y = run.output(0);
    y[0] -= d;
    let columns = vec![Column { name: "V".to_owned(), unit: None, values: input }, Column { name: "q".to_owned(), unit: None, values: y }];
    Record { source: "simulated".to_owned(), t, columns, declared: Vec::new(), start: Start::Free }
}

#[test]
fn derivatives_of_innovations_are_their_differences() {
    let model = model();
    let index = |name: &str| (0..model.dimensions().parameters).find(|&i| model.names().parameter(i) == name).unwrap();
    let mut p = vec![0.0; model.dimensions().parameters];
    model.nominal(&mut p);
    let record = record(&model, &p, p[index("d")]);
    for play in [0.0, 2e-3] {
        p[index("w")] = play;
        let track = Track::new(&record, &model, &p, Hold::Zero).unwrap();
        let noise = Noise { entries: vec![index("pushed")], sd: vec![0.01], time: vec![0.2], output_sd: vec![3e-4], dry: Vec::new() };
        for (name, step) in
            [("J", 1e-6), ("mgl", 1e-5), ("c", 1e-5), ("K", 1e-6), ("y_0", 1e-5), ("s", 1e-5), ("r", 1e-5), ("d", 1e-5), ("w", 1e-5)]
        {
            let i = index(name);
            let found = pass(&model, &p, &track.begun(&model, &p), &noise, &[By::Parameter(i)]).unwrap().unwrap();
            let at = |by: f64| {
                let mut moved = p.clone();
                moved[i] += by;
                pass(&model, &moved, &track.begun(&model, &moved), &noise, &[]).unwrap().unwrap().z
            };
            // play is not negative: from none on, to one side
            let back = if name == "w" && play == 0.0 { 0.0 } else { step };
            let (above, below) = (at(step), at(-back));
            let difference: Vec<f64> = above.iter().zip(&below).map(|(a, b)| (a - b) / (step + back)).collect();
            let norm = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
            let off: Vec<f64> = difference.iter().zip(&found.jacobian).map(|(a, b)| a - b).collect();
            // transitions are the exponential's series at the middle of a step, and gains move a little: good to a part in some hundred;
            // behind play the gains hang on where the motion is in it, on its width above all
            let good = match (name, play > 0.0) {
                (_, false) => 0.02,
                ("w", true) => 0.3,
                (_, true) => 0.06,
            };
            assert!(norm(&off) < good * norm(&difference), "{play} {name}: off by {:.1e} of {:.1e}", norm(&off), norm(&difference));
        }
    }
}

/// Normal numbers from a linear congruential generator, by the sum of twelve.
struct Chance(u64);

impl Chance {
    fn normal(&mut self) -> f64 {
        let mut uniform = || {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(|_| uniform()).sum::<f64>() - 6.0
    }
}

/// Slowly, a random torque is seen by its size squared times its time alone: a search along one of them after the other stays where it began.
#[test]
fn the_time_of_a_random_torque_is_found_from_one_that_is_nearly_white() {
    let model = model();
    let mut p = vec![0.0; model.dimensions().parameters];
    model.nominal(&mut p);
    let index = |name: &str| (0..p.len()).find(|&i| model.names().parameter(i) == name).unwrap();
    let (size, time) = (0.02, 0.5);
    for seed in 1..4 {
        let mut chance = Chance(seed);
        let (h, every) = (1e-3, 10);
        let (mut q, mut v, mut torque) = (0.0_f64, 0.0_f64, 0.0_f64);
        let (mut t, mut y) = (Vec::new(), Vec::new());
        for k in 0..12_000 {
            if k % every == 0 {
                t.push(f64::from(k) * h);
                y.push(q + 2e-3 * chance.normal());
            }
            torque += -torque * h / time + size * (2.0 * h / time).sqrt() * chance.normal();
            v += h * (torque - 0.5 * q.sin() - 0.01 * v) / 0.02;
            q += h * v;
        }
        let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
        let columns = vec![column("V", vec![0.0; t.len()]), column("q", y)];
        let record = Record { source: "pushed".to_owned(), t, columns, declared: Vec::new(), start: Start::Free };
        let track = Track::new(&record, &model, &p, Hold::Zero).unwrap();
        let white = Noise {
            entries: vec![index("pushed")],
            sd: vec![size * (time / 0.012_f64).sqrt()],
            time: vec![0.012],
            output_sd: vec![2e-3],
            dry: Vec::new(),
        };
        let found = likeliest(&model, std::slice::from_ref(&p), &[track], &white, (1.6, 0.2), 0.1).unwrap();
        // twelve seconds hold some two dozen independent stretches of such a torque
        assert!((0.5 * time..2.5 * time).contains(&found.time[0]) && (0.6 * size..1.6 * size).contains(&found.sd[0]), "{found:?}");
    }
}

/// What drives a rig turns faster than blocks are short: straight lines through its means would make a lighter rig likelier.
#[test]
fn a_rig_is_as_heavy_in_means_of_blocks_as_in_all_samples() {
    let model = model();
    let index = |name: &str| (0..model.dimensions().parameters).find(|&i| model.names().parameter(i) == name).unwrap();
    let mut p = vec![0.0; model.dimensions().parameters];
    model.nominal(&mut p);
    p[index("d")] = 0.0;
    let inertia = p[index("J")];
    let t: Vec<f64> = (0..4000).map(|k| 1e-3 * f64::from(k)).collect();
    let input: Vec<f64> = t.iter().map(|t| (60.0 * t).sin() + 2.0 * (97.0 * t).cos() + (150.0 * t).sin()).collect();
    let exact = sim::Options { relative: 1e-10, absolute: 1e-12, ..sim::Options::default() };
    for hold in [Hold::Zero, Hold::First] {
        let signals = Signals::new(vec![Signal { t: t.clone(), values: input.clone(), hold }]).unwrap();
        let y = simulate(&model, &p, &[0.3, 1.0], &signals, &t, &exact).unwrap().output(0);
        let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
        let columns = vec![column("V", input.clone()), column("q", y)];
        let record = Record { source: "fast".to_owned(), t: t.clone(), columns, declared: Vec::new(), start: Start::Free };
        let blocks = Blocks::of(&model, &p, hold);
        let track = Track::new(&blocks.averaged(&record, 10), &model, &p, blocks.hold(10)).unwrap();
        let noise = Noise { entries: vec![index("pushed")], sd: vec![0.001], time: vec![0.2], output_sd: vec![1e-6], dry: Vec::new() };
        let at = |share: f64| {
            let mut p = p.clone();
            p[index("J")] = share * inertia;
            pass(&model, &p, &track, &noise, &[]).unwrap().unwrap().log_likelihood()
        };
        let there = at(1.0);
        for share in [0.95, 0.99, 1.01, 1.05] {
            let away = at(share);
            assert!(there > away + 1.0, "{hold:?}: {there} and at {share} of it {away}");
        }
    }
}

/// A pendulum that is pushed at random, read behind play by an encoder.
fn played(seed: u64, width: f64, quantum: f64) -> Record {
    let mut chance = Chance(seed);
    let (h, every, size, time) = (1e-3, 10, 0.01, 0.2);
    let (mut q, mut v, mut torque, mut reading) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    let (mut t, mut y, mut input) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..12_000 {
        let now = f64::from(k) * h;
        let command = if (now % 2.6) < 1.2 { 1.0 } else { -0.8 };
        reading = reading.clamp(q - 0.5 * width, q + 0.5 * width);
        if k % every == 0 {
            t.push(now);
            y.push((reading / quantum).round() * quantum);
            input.push(command);
        }
        torque += -torque * h / time + size * (2.0 * h / time).sqrt() * chance.normal();
        v += h * (0.1 * command + torque - 0.5 * q.sin() - 0.01 * v) / 0.02;
        q += h * v;
    }
    let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
    Record { source: "played".to_owned(), t, columns: vec![column("V", input), column("q", y)], declared: Vec::new(), start: Start::Free }
}

#[test]
fn play_is_likeliest_where_it_is_though_an_encoder_counts_more_coarsely() {
    let model = model();
    let index = |name: &str| (0..model.dimensions().parameters).find(|&i| model.names().parameter(i) == name).unwrap();
    let mut p = vec![0.0; model.dimensions().parameters];
    model.nominal(&mut p);
    p[index("d")] = 0.0;
    for (width, quantum, sure) in [(4e-3, 2e-4, 0.1), (1e-3, 2e-4, 0.2), (1e-3, 1e-3, 0.3)] {
        for seed in 1..4 {
            let track = Track::new(&played(seed, width, quantum), &model, &p, Hold::Zero).unwrap();
            let output_sd = vec![quantum / 12_f64.sqrt()];
            let noise = Noise { entries: vec![index("pushed")], sd: vec![0.01], time: vec![0.2], output_sd, dry: Vec::new() };
            let mut at = |share: f64| {
                p[index("w")] = share * width;
                pass(&model, &p, &track, &noise, &[]).unwrap().unwrap().log_likelihood()
            };
            let there = at(1.0);
            for share in [0.0, 1.0 - 2.0 * sure, 1.0 + 2.0 * sure] {
                let away = at(share);
                assert!(there > away + 1.0, "play {width} counts {quantum} seed {seed}: {there} and at {share} of it {away}");
            }
        }
    }
}

#[test]
fn play_of_no_width_is_no_play() {
    let with = model();
    let plain = model_of(&PENDULUM.replace(" play w;", ""));
    let index = |model: &InProcess, name: &str| (0..model.dimensions().parameters).find(|&i| model.names().parameter(i) == name).unwrap();
    let found = [&with, &plain].map(|model| {
        let mut p = vec![0.0; model.dimensions().parameters];
        model.nominal(&mut p);
        p[index(model, "d")] = 0.0;
        let noise =
            Noise { entries: vec![index(model, "pushed")], sd: vec![0.01], time: vec![0.2], output_sd: vec![1e-4], dry: Vec::new() };
        let track = Track::new(&played(1, 1e-3, 2e-4), model, &p, Hold::Zero).unwrap();
        let columns = ["J", "mgl", "y_0", "r"].map(|name| By::Parameter(index(model, name)));
        pass(model, &p, &track, &noise, &columns).unwrap().unwrap()
    });
    let off = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs() / (1.0 + b.abs())).fold(0.0, f64::max);
    let [with, plain] = found;
    assert_eq!(with.z.len(), plain.z.len());
    println!("{} {}", off(&with.z, &plain.z), off(&with.jacobian, &plain.jacobian));
    assert!(off(&with.z, &plain.z) < 1e-9 && off(&with.jacobian, &plain.jacobian) < 1e-9);
}
