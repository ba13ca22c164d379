//! Our equations against numbers of independent numerical tools (Pinocchio, MuJoCo) at fixed states: helicopters,
//! Furuta, cart-pole, acrobot, double pendulum, Aero, two robots from URDF files. The numbers lie outside the project, in the
//! folder that `RIG_DATA` names; the rigs are `tests/rigs/golden/<name>.rig`.

use codegen::expr::{Id, SymbolKind};
use codegen::{Equations, Options, derive};
use cross_checks::close::by_rows;
use cross_checks::{record_folder, rig_of, rigs_in, root};
use serde_json::Value;

/// Both sides round at 1e-16; the tools' own tensors carry a few more digits of rounding.
const TOLERANCE: f64 = 1e-10;

/// State, inputs and accelerations at which expressions are evaluated.
struct Point {
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    u: Vec<f64>,
}

fn flat(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(list) => list.iter().flat_map(flat).collect(),
        other => vec![other.as_f64().unwrap_or(f64::NAN)],
    }
}

fn evaluate(e: &Equations, roots: &[Id], at: &Point) -> Vec<f64> {
    e.graph.evaluate(roots, |s| match e.graph.symbol_info(s).kind {
        SymbolKind::Coordinate(i) => at.q[i],
        SymbolKind::Rate(i) => at.v[i],
        SymbolKind::Acceleration(i) => at.a[i],
        SymbolKind::Signal(i) => at.u[i],
        SymbolKind::Parameter(i) => e.layout.nominal[i],
        SymbolKind::Time | SymbolKind::Lag(_) | SymbolKind::Definition(_) | SymbolKind::Inertial(_) => f64::NAN,
    })
}

/// Compares all samples of a file; `torques` are the rig's inputs that act on the coordinates, in order.
fn compare(name: &str, torques: &[&str]) {
    let Some(folder) = record_folder() else {
        println!("record test: skipped golden {name} (RIG_DATA is not set)");
        return;
    };
    let file = folder.join(format!("golden_numeric/{name}.json"));
    let text = std::fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let golden: Value = serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let rig = rig_of(&root().join(format!("tests/rigs/golden/{name}.rig")));
    let e = derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
    let n = e.layout.q.len();
    assert_eq!(torques.len(), n);
    let signal = |input: &str| e.layout.u.iter().position(|u| u.name == input).unwrap_or_else(|| panic!("{name}: no input {input}"));
    let places: Vec<usize> = torques.iter().map(|t| signal(t)).collect();
    let block =
        |rows: &[Vec<Id>], columns: &[usize]| rows[n..2 * n].iter().flat_map(|r| columns.iter().map(|&j| r[j])).collect::<Vec<Id>>();
    let (by_q, by_v): (Vec<usize>, Vec<usize>) = ((0..n).collect(), (n..2 * n).collect());
    let column = |input: &str| e.input_map.iter().map(|r| r[signal(input)]).collect::<Vec<Id>>();

    let samples = golden["samples"].as_array().expect("samples");
    assert!(samples.len() >= 6);
    let mut compared = std::collections::BTreeSet::new();
    let mut worst = 0.0_f64;
    let mut first: Option<(f64, f64)> = None;
    for (k, sample) in samples.iter().enumerate() {
        let mut at = Point { q: flat(&sample["q"]), v: flat(&sample["v"]), a: flat(&sample["a"]), u: vec![0.0; e.layout.u.len()] };
        let mut check = |what: &'static str, ours: &[f64], theirs: &[f64], columns: usize| {
            let d = by_rows(ours, theirs, columns);
            assert!(d < TOLERANCE, "{name}, sample {k}: {what} differs by {d:.1e}\nours   {ours:?}\ntheirs {theirs:?}");
            compared.insert(what);
            worst = worst.max(d);
        };
        let theirs = |key: &str| sample.get(key).map(flat);
        if let Some(m) = theirs("M") {
            check("M", &evaluate(&e, &e.mass_matrix.concat(), &at), &m, n);
        }
        if let Some(h) = theirs("nle").or_else(|| theirs("bias")) {
            check("bias", &evaluate(&e, &e.bias, &at), &h, n);
        }
        if let Some(h) = theirs("gravity") {
            check("gravity", &evaluate(&e, &e.gravity, &at), &h, n);
        }
        if let Some(passive) = theirs("passive") {
            let opposed: Vec<f64> = passive.iter().map(|x| -x).collect();
            check("dissipation", &evaluate(&e, &e.dissipation, &at), &opposed, n);
        }
        let tau = flat(&sample["tau"]);
        // the files of the URDF robots give tau for an acceleration, the others an acceleration for tau
        if sample.get("nle").or_else(|| sample.get("bias")).is_none() {
            check("inverse dynamics", &evaluate(&e, &e.inverse_dynamics, &at), &tau, n);
            continue;
        }
        for (&place, &t) in places.iter().zip(&tau) {
            at.u[place] = t;
        }
        check("accelerations", &evaluate(&e, &e.acceleration, &at), &flat(&sample["a"]), n);
        for (key, what, roots) in [
            ("da_dq", "da/dq", block(&e.linear.a, &by_q)),
            ("da_dv", "da/dv", block(&e.linear.a, &by_v)),
            ("da_dtau", "da/dtau", block(&e.linear.b, &places)),
        ] {
            if let Some(wanted) = theirs(key) {
                check(what, &evaluate(&e, &roots, &at), &wanted, n);
            }
        }
        for (key, what, input) in [("Q_front_unit_thrust", "front thrust", "V_f"), ("Q_back_unit_thrust", "back thrust", "V_b")] {
            if let Some(wanted) = theirs(key) {
                check(what, &evaluate(&e, &column(input), &at), &wanted, n);
            }
        }
        if let (Some(t), Some(v)) = (e.kinetic, e.potential)
            && let (Some(kinetic), Some(potential)) = (theirs("kinetic"), theirs("potential"))
        {
            check("kinetic energy", &evaluate(&e, &[t], &at), &kinetic, 1);
            // the tools count heights from where they like
            let ours = evaluate(&e, &[v], &at)[0];
            let (zero_ours, zero_theirs) = *first.get_or_insert((ours, potential[0]));
            let scale = potential[0].abs().max(zero_theirs.abs());
            let d = ((ours - zero_ours) - (potential[0] - zero_theirs)).abs() / scale;
            assert!(d < TOLERANCE, "{name}, sample {k}: potential energy differs by {d:.1e}");
            worst = worst.max(d);
        }
    }
    println!("{name:28} {} samples, worst {worst:.1e} in {compared:?}", samples.len());
    println!("record test: ran golden {name}");
}

/// The rigs are right in themselves, whether or not the numbers are at hand.
#[test]
fn every_rig_derives() {
    let rigs = rigs_in("tests/rigs/golden");
    assert_eq!(rigs.len(), 12);
    for path in rigs {
        derive(&rig_of(&path), Options::default()).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
}

#[test]
fn helicopters() {
    for name in ["heli3_imperial_2017", "heli3_quanser_2010", "heli3_ntnu_3_10"] {
        compare(name, &["tau_travel", "tau_elevation", "tau_pitch"]);
    }
}

#[test]
fn furuta_pendulums() {
    for name in ["furuta_qube2_rods", "furuta_qube2_rods_rotor"] {
        compare(name, &["tau", "tau_alpha"]);
    }
}

#[test]
fn carts_with_poles() {
    for name in ["cartpole_gym_numbers", "dmcontrol_cartpole"] {
        compare(name, &["F", "tau_theta"]);
    }
}

#[test]
fn acrobot() {
    compare("dmcontrol_acrobot", &["tau_shoulder", "tau"]);
}

#[test]
fn double_pendulum() {
    compare("double_pendulum_dfki_A_2_1", &["tau_1", "tau_2"]);
}

#[test]
fn aero() {
    compare("aero_ntnu_2025", &["tau_yaw", "tau_pitch"]);
}

#[test]
fn robots_from_urdf() {
    for name in ["urdf_twodof_asr", "urdf_double_pendulum_erd"] {
        compare(name, &["tau_1", "tau_2"]);
    }
}
