//! Preflight on simulated records of five rigs: clean ones pass, every usual mistake is found.

use codegen::{Options, derive};
use cross_checks::{random::Random, record_folder, rig_of, root};
use ident::fit::ParameterSpec;
use ident::preflight::{Change, FaultKind, Preflight, inspect};
use ident::record::{Column, Record, Start, read_with};
use jit::InProcess;
use runtime::Model;
use sim::{Hold, Signal, Signals, encoder, simulate};
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

/// A rig, how it is driven, and how it starts.
struct Case {
    rig: &'static str,
    seconds: f64,
    rate: f64,
    /// Level and amplitude of each input, and its lowest frequency [Hz].
    inputs: Vec<(f64, f64, f64)>,
    /// Coordinates at the start.
    start: Vec<f64>,
    /// Encoder steps that the rig does not declare.
    steps: Vec<f64>,
}

fn cases() -> Vec<Case> {
    vec![
        Case {
            rig: "googol_mrb",
            seconds: 20.0,
            rate: 100.0,
            inputs: vec![(2.35, 0.35, 0.08), (2.35, 0.3, 0.13)],
            start: vec![0.0, -0.3, 0.0],
            steps: vec![0.0; 3],
        },
        Case {
            rig: "quanser",
            seconds: 20.0,
            rate: 100.0,
            inputs: vec![(0.0, 1.2, 0.08), (0.0, 1.0, 0.13)],
            start: vec![0.0, -0.1, 0.0],
            steps: vec![0.0; 3],
        },
        Case {
            rig: "furuta",
            seconds: 12.0,
            rate: 200.0,
            inputs: vec![(0.0, 0.004, 0.5)],
            start: vec![0.0, 0.4],
            steps: vec![TAU / 2048.0; 2],
        },
        Case {
            rig: "cart_pole",
            seconds: 15.0,
            rate: 100.0,
            inputs: vec![(0.0, 2.0, 0.3)],
            start: vec![0.0, PI - 0.3],
            steps: vec![1e-4, TAU / 4096.0],
        },
        Case { rig: "emps", seconds: 12.0, rate: 500.0, inputs: vec![(0.0, 2.5, 0.4)], start: vec![0.1], steps: vec![1e-5] },
    ]
}

struct Made {
    model: InProcess,
    specs: Vec<ParameterSpec>,
    ranges: Vec<ident::preflight::Range>,
    record: Record,
}

fn example(name: &str) -> (InProcess, Vec<ParameterSpec>, Vec<ident::preflight::Range>) {
    let rig = rig_of(&root().join(format!("examples/rigs/{name}.rig")));
    let ranges = rig.coordinates.iter().filter_map(|c| Some((c.name.clone(), c.range?))).collect();
    (InProcess::new(derive(&rig, Options::default()).unwrap()), ParameterSpec::of_rig(&rig), ranges)
}

/// A record of a rig whose free parameters are 20 % off, with noise of a third of a step and quantized.
fn made(case: &Case, seed: u64) -> Made {
    let (model, specs, ranges) = example(case.rig);
    let mut random = Random::new(seed);
    let p: Vec<f64> = specs.iter().map(|s| if s.free { s.value * random.within(0.8, 1.25) } else { s.value }).collect();
    let d = model.dimensions();
    let t: Vec<f64> = (0..(case.seconds * case.rate) as usize).map(|k| k as f64 / case.rate).collect();
    let inputs: Vec<Vec<f64>> = case
        .inputs
        .iter()
        .map(|&(level, amplitude, lowest)| {
            let waves: Vec<(f64, f64)> = (0..5).map(|k| (lowest * 1.7_f64.powi(k), random.within(0.0, TAU))).collect();
            t.iter().map(|t| level + amplitude * waves.iter().map(|(f, phase)| (TAU * f * t + phase).sin()).sum::<f64>() / 2.0).collect()
        })
        .collect();
    let signals = Signals::new(inputs.iter().map(|u| Signal { t: t.clone(), values: u.clone(), hold: Hold::Zero }).collect()).unwrap();
    let mut x = vec![0.0; d.states()];
    x[..d.coordinates].copy_from_slice(&case.start);
    let options = sim::Options { relative: 1e-7, absolute: 1e-9, ..sim::Options::default() };
    let run = simulate(&model, &p, &x, &signals, &t, &options).unwrap();
    assert_eq!(run.t.len(), t.len(), "{}: {}", case.rig, run.status);
    let mut columns: Vec<Column> = (0..d.outputs)
        .map(|i| {
            let mut path = model.output_path(i, &p);
            path.quantum = path.quantum.max(case.steps[i]);
            let values = run.output(i).iter().map(|y| encoder(y + path.quantum * random.within(-0.6, 0.6), &path)).collect();
            Column { name: model.names().output(i).to_owned(), unit: None, values }
        })
        .collect();
    columns.extend(inputs.into_iter().enumerate().map(|(i, values)| Column {
        name: model.names().signal(i).to_owned(),
        unit: None,
        values,
    }));
    let record = Record { source: format!("{}.csv", case.rig), t, columns, declared: Vec::new(), start: Start::Free };
    Made { model, specs, ranges, record }
}

fn look(made: &Made, record: &Record) -> Preflight {
    inspect(&made.model, &made.specs, &made.ranges, std::slice::from_ref(record), Hold::Zero).unwrap()
}

fn column<'a>(record: &'a mut Record, name: &str) -> &'a mut Vec<f64> {
    &mut record.columns.iter_mut().find(|c| c.name == name).unwrap().values
}

/// Every usual mistake of a rig, and the change that undoes it.
fn mistakes(made: &Made) -> Vec<(Change, Record)> {
    let d = made.model.dimensions();
    let names = made.model.names();
    let outputs: Vec<(String, String)> = (0..d.outputs).map(|i| (names.output(i).to_owned(), names.output_unit(i).to_owned())).collect();
    let inputs: Vec<(String, String)> = (0..d.inputs).map(|i| (names.signal(i).to_owned(), names.signal_unit(i).to_owned())).collect();
    let mut list = Vec::new();
    for (k, (name, unit)) in outputs.iter().chain(&inputs).enumerate() {
        let mut wrong = made.record.clone();
        column(&mut wrong, name).iter_mut().for_each(|y| *y = -*y);
        list.push((if k < outputs.len() { Change::SignOfOutput(name.clone()) } else { Change::SignOfInput(name.clone()) }, wrong));
        if k < outputs.len() && unit == "rad" {
            let mut wrong = made.record.clone();
            column(&mut wrong, name).iter_mut().for_each(|y| *y = y.to_degrees());
            list.push((Change::Degrees(name.clone()), wrong));
        }
    }
    for (of, outs) in [(&outputs, true), (&inputs, false)] {
        for (k, (a, unit)) in of.iter().enumerate() {
            for (b, _) in of[k + 1..].iter().filter(|(_, other)| other == unit) {
                let mut wrong = made.record.clone();
                let (ya, yb) = (column(&mut wrong, a).clone(), column(&mut wrong, b).clone());
                *column(&mut wrong, a) = yb;
                *column(&mut wrong, b) = ya;
                list.push((if outs { Change::SwapOutputs(a.clone(), b.clone()) } else { Change::SwapInputs(a.clone(), b.clone()) }, wrong));
            }
        }
    }
    list
}

fn suspects(found: &Preflight) -> Vec<(&Change, &[Change])> {
    found
        .faults
        .iter()
        .filter_map(|f| match &f.kind {
            FaultKind::Contradicts(s) => Some((&s.change, s.alternatives.as_slice())),
            _ => None,
        })
        .collect()
}

/// A clean record passes, and each mistake is found, alone and first.
fn table(rig: &str) {
    let case = cases().into_iter().find(|c| c.rig == rig).unwrap();
    let made = made(&case, 1);
    let clean = look(&made, &made.record);
    let sentences: Vec<String> = clean.faults.iter().map(|f| f.sentence()).collect();
    let mut missed = sentences.len();
    let parts = clean.records[0].unexplained.iter().map(|(n, e)| format!("{n} {e:.3}")).collect::<Vec<_>>().join(", ");
    let mut table = format!("{rig}: clean record: {sentences:?}; unexplained: {parts}\n");
    assert_eq!(clean.records[0].not_judged, None);
    for (change, wrong) in mistakes(&made) {
        let found = look(&made, &wrong);
        let listed = suspects(&found);
        let right = listed.len() == 1 && (*listed[0].0 == change || listed[0].1.contains(&change));
        missed += usize::from(!right);
        let words: Vec<String> = listed
            .iter()
            .map(|(c, or)| std::iter::once(*c).chain(or.iter()).map(Change::claim).collect::<Vec<_>>().join(", or "))
            .collect();
        let _ = writeln!(table, "  {:6} {:42} found: {}", if right { "ok" } else { "MISSED" }, change.claim(), words.join("; and "));
    }
    println!("{table}");
    assert_eq!(missed, 0, "\n{table}");
}

#[test]
fn every_mistake_on_googol_mrb() {
    table("googol_mrb");
}

#[test]
fn every_mistake_on_quanser() {
    table("quanser");
}

#[test]
fn every_mistake_on_furuta() {
    table("furuta");
}

#[test]
fn every_mistake_on_cart_pole() {
    table("cart_pole");
}

#[test]
fn every_mistake_on_emps() {
    table("emps");
}

/// Faults that are none of the wiring: each found, named as what it is, alone.
#[test]
fn zeros_units_gaps_and_dead_channels() {
    let all = cases();
    let (googol, furuta) = (made(&all[0], 2), made(&all[2], 2));
    let only = |found: &Preflight| -> FaultKind {
        let sentences: Vec<String> = found.faults.iter().map(|f| f.sentence()).collect();
        assert_eq!(found.faults.len(), 1, "{sentences:#?}");
        println!("{}\n  mend: {}", sentences[0], found.faults[0].mend());
        found.faults[0].kind.clone()
    };
    let change = |found: &Preflight| match only(found) {
        FaultKind::Contradicts(s) => s,
        other => panic!("{other:?}"),
    };

    // switched on where the rig rests
    let mut zeroed = googol.record.clone();
    let first = column(&mut zeroed, "eps")[0];
    column(&mut zeroed, "eps").iter_mut().for_each(|y| *y -= first);
    match change(&look(&googol, &zeroed)).change {
        Change::Offset(name, by) => assert!(name == "eps" && (by - first).abs() < 0.03, "{name} {by} {first}"),
        other => panic!("{other:?}"),
    }

    // the pendulum counted from upright, the rig counts from hanging
    let mut upright = furuta.record.clone();
    column(&mut upright, "alpha").iter_mut().for_each(|y| *y += PI);
    let found = change(&look(&furuta, &upright));
    let names = |c: &Change| (c.id(), c.channels());
    let listed: Vec<_> = std::iter::once(&found.change).chain(&found.alternatives).map(names).collect();
    assert!(listed.contains(&("half_turn", vec!["alpha".to_owned()])), "{listed:?}");

    // inputs of another run
    let mut foreign = googol.record.clone();
    for name in ["f_1", "f_2"] {
        column(&mut foreign, name).rotate_left(613);
    }
    assert_eq!(change(&look(&googol, &foreign)).change.id(), "foreign_input");

    let mut gap = googol.record.clone();
    gap.t.iter_mut().skip(900).for_each(|t| *t += 0.4);
    assert!(
        look(&googol, &gap)
            .faults
            .iter()
            .any(|f| matches!(&f.kind, FaultKind::Gaps(g) if g.len() == 1 && (g[0].length - 0.41).abs() < 1e-9))
    );

    let mut dead = googol.record.clone();
    column(&mut dead, "psi").iter_mut().for_each(|y| *y = 0.0);
    assert!(look(&googol, &dead).faults.iter().any(|f| matches!(&f.kind, FaultKind::Dead { output, .. } if output == "psi")));

    let mut coarse = googol.record.clone();
    column(&mut coarse, "theta").iter_mut().for_each(|y| *y = (*y / (TAU / 600.0)).round() * (TAU / 600.0));
    assert!(matches!(only(&look(&googol, &coarse)), FaultKind::Quantum { output, .. } if output == "theta"));
}

/// Two columns turned at once.
#[test]
fn two_faults_in_one_record() {
    let all = cases();
    let quanser = made(&all[1], 3);
    let mut wrong = quanser.record.clone();
    column(&mut wrong, "travel").iter_mut().for_each(|y| *y = -*y);
    column(&mut wrong, "elevation").iter_mut().for_each(|y| *y = -*y);
    let found = look(&quanser, &wrong);
    let mut names: Vec<String> = found.faults.iter().flat_map(|f| f.channels()).collect();
    names.sort();
    println!("{:#?}", found.faults.iter().map(|f| f.sentence()).collect::<Vec<_>>());
    assert_eq!(names, ["elevation", "travel"]);
}

fn rig_from(text: &str) -> (InProcess, Vec<ParameterSpec>) {
    let checked = model_dsl::check_text("test.rig", text);
    let rig = checked.rig.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    (InProcess::new(derive(&rig, Options::default()).unwrap()), ParameterSpec::of_rig(&rig))
}

/// What a mirror of the rig hides is said, not guessed: a turned input looks like a turned output, and the sign of a free
/// swing shows in nothing.
#[test]
fn mirrors_are_named() {
    let t: Vec<f64> = (0..2000).map(|k| 0.01 * f64::from(k)).collect();
    let (cart, specs) = rig_from(
        "rig Cart { param m: kg = 1; param c: N*s/m = 0.5; param k: N/m = 8; coord x: m; input F: N;
         equation m * x.ddot = F - c * x.dot - k * x; }",
    );
    let force: Vec<f64> = t.iter().map(|t| (1.1 * t).sin() + (2.3 * t + 1.0).sin() + 0.5 * (5.1 * t).cos()).collect();
    let signals = Signals::new(vec![Signal { t: t.clone(), values: force.clone(), hold: Hold::Zero }]).unwrap();
    let mut p = vec![0.0; 3];
    cart.nominal(&mut p);
    let run = simulate(&cart, &p, &[0.0, 0.0], &signals, &t, &sim::Options::default()).unwrap();
    let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
    let record =
        |columns: Vec<Column>| Record { source: "r.csv".to_owned(), t: t.clone(), columns, declared: Vec::new(), start: Start::Free };
    let turned = record(vec![column("x", run.output(0)), column("F", force.iter().map(|f| -f).collect())]);
    let found = inspect(&cart, &specs, &[], &[turned], Hold::Zero).unwrap();
    assert_eq!(found.faults.len(), 1);
    println!("{}", found.faults[0].sentence());
    let listed = suspects(&found);
    let all: Vec<&Change> = std::iter::once(listed[0].0).chain(listed[0].1).collect();
    assert!(all.contains(&&Change::SignOfOutput("x".to_owned())) && all.contains(&&Change::SignOfInput("F".to_owned())), "{all:?}");

    let (pendulum, specs) =
        rig_from("rig Swing { param a: 1/s^2 = 20; param c: 1/s = 0.1; coord q: rad; equation q.ddot = -a * sin(q) - c * q.dot; }");
    let mut p = vec![0.0; 2];
    pendulum.nominal(&mut p);
    let run = simulate(&pendulum, &p, &[1.0, 0.0], &Signals::new(Vec::new()).unwrap(), &t, &sim::Options::default()).unwrap();
    let swing = record(vec![column("q", run.output(0))]);
    let found = inspect(&pendulum, &specs, &[], std::slice::from_ref(&swing), Hold::Zero).unwrap();
    assert_eq!((found.faults.len(), found.records[0].untold.as_slice()), (0, [Change::SignOfOutput("q".to_owned())].as_slice()));

    // gravity of the wrong sign, or the angle counted from the other end
    let (wrong, specs) =
        rig_from("rig Swing { param a: 1/s^2 = -20; param c: 1/s = 0.1; coord q: rad; equation q.ddot = -a * sin(q) - c * q.dot; }");
    let found = inspect(&wrong, &specs, &[], &[swing], Hold::Zero).unwrap();
    println!("{}", found.faults[0].sentence());
    assert_eq!(found.faults[0].id(), "half_turn");
}

/// A delay of the input is measured, and none is where there is none.
#[test]
fn delays_are_measured() {
    let all = cases();
    let furuta = made(&all[2], 4);
    let delays = |record: &Record| look(&furuta, record).records[0].delays.clone();
    let none = delays(&furuta.record);
    assert!(none.len() == 1 && none[0].seconds <= 0.01, "{none:?}");
    let mut late = furuta.record.clone();
    let input = column(&mut late, "tau");
    let lead = 12;
    // logged 12 samples before it acts
    let acted = input.clone();
    for k in 0..acted.len() {
        input[k] = acted[(k + lead).min(acted.len() - 1)];
    }
    let found = delays(&late);
    println!("no delay: {none:?}\n60 ms: {found:?}");
    assert!(found.len() == 1 && (found[0].seconds - 0.06).abs() < 0.01, "{found:?}");
}

/// The measured records that these rigs are of: clean as described, and the column that was logged turned is found.
#[test]
fn measured_records() {
    let Some(folder) = record_folder() else {
        println!("record test: skipped preflight of googol, emps, double_pendulum_dfki (RIG_DATA is not set)");
        return;
    };
    println!("record test: ran preflight of googol, emps, double_pendulum_dfki");
    for (rig, name) in [
        ("googol_identified", "googol_open_loop_steps"),
        ("googol_identified", "googol_elevation_identification"),
        ("emps", "emps_DATA_EMPS"),
        ("double_pendulum", "double_pendulum_dfki_designA_trajectory_03"),
    ] {
        let (model, specs, ranges) = example(rig);
        let record = read_with(&root().join(format!("examples/records/{name}.toml")), Some(&folder)).unwrap();
        let found = inspect(&model, &specs, &ranges, std::slice::from_ref(&record), Hold::Zero).unwrap();
        let sentences: Vec<String> = found.faults.iter().map(|f| f.sentence()).collect();
        println!("  {name}: {sentences:?}, unexplained {:.2?}", found.records[0].unexplained);
        assert!(sentences.is_empty());
        if name == "googol_open_loop_steps" {
            let mut logged = record;
            column(&mut logged, "theta").iter_mut().for_each(|y| *y = -*y);
            let found = inspect(&model, &specs, &ranges, &[logged], Hold::Zero).unwrap();
            assert_eq!(suspects(&found), [(&Change::SignOfOutput("theta".to_owned()), [].as_slice())]);
        }
    }
}
