//! Our equations against CasADi's, which knows only the declared rig (`tests/oracle/derive.py`; the numbers are kept
//! in `tests/oracle/data`, and `cargo xtask oracle` makes them anew).

use codegen::emit::{declared, declared_fingerprint};
use codegen::expr::{Id, SymbolKind};
use codegen::{Equations, Options, derive, direction_by_name, operating_points};
use control::{RiccatiData, TrimError};
use cross_checks::close::by_rows_of_scale;
use cross_checks::trims::problem;
use cross_checks::{oracle_rigs, rig_of, root};
use jit::InProcess;
use model_dsl::rig::Rig;
use nalgebra::DMatrix;
use runtime::Model;
use serde_json::Value;
use std::path::Path;

/// Largest difference allowed. Both sides round at 1e-16; what is left for conditioning is five decades.
const TOLERANCE: f64 = 1e-10;
/// Trims that have no solution, on purpose.
const REFUSED: [&str; 1] = ["assumed_twice, trim balance"];

/// A quantity: its name in the oracle's file, its entries row by row, its columns.
struct Quantity {
    name: &'static str,
    roots: Vec<Id>,
    columns: usize,
}

fn quantities(e: &Equations) -> Vec<Quantity> {
    let l = &e.layout;
    let n = l.q.len();
    let vector = |name, roots: Vec<Id>| Quantity { name, columns: roots.len(), roots };
    // the rows above are those of q' = v
    let matrix = |name, rows: &[Vec<Id>], skip: usize, columns| Quantity { name, roots: rows[skip..].concat(), columns };
    let mut list = vec![
        matrix("M", &e.mass_matrix, 0, n),
        vector("bias", e.bias.clone()),
        vector("gravity", e.gravity.clone()),
        vector("dissipation", e.dissipation.clone()),
        vector("force", e.force.clone()),
        vector("rates", e.acceleration.iter().chain(&e.lag_rates).copied().collect()),
        matrix("A", &e.linear.a, n, l.states()),
        matrix("B", &e.linear.b, n, l.u.len()),
        matrix("P", &e.parameter_jacobian, n, l.p.len()),
        vector("y", e.outputs.clone()),
        matrix("C", &e.output_jacobian, 0, l.states()),
        matrix("dydp", &e.output_parameter_jacobian, 0, l.p.len()),
    ];
    list.extend(e.kinetic.map(|t| vector("kinetic", vec![t])));
    list.extend(e.potential.map(|v| vector("potential", vec![v])));
    list
}

/// All numbers of a tree, row by row.
fn flat(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(list) => list.iter().flat_map(flat).collect(),
        other => vec![other.as_f64().unwrap_or(f64::NAN)],
    }
}

/// Values of roots at a state of the oracle's file.
fn evaluate(e: &Equations, roots: &[Id], state: &Value, p: &[f64]) -> Vec<f64> {
    let (x, u) = (flat(&state["x"]), flat(&state["u"]));
    let (n, t) = (e.layout.q.len(), state["t"].as_f64().unwrap_or(0.0));
    e.graph.evaluate(roots, |s| match e.graph.symbol_info(s).kind {
        SymbolKind::Time => t,
        SymbolKind::Coordinate(i) => x[i],
        SymbolKind::Rate(i) => x[n + i],
        SymbolKind::Lag(i) => x[2 * n + i],
        SymbolKind::Signal(i) => u[i],
        SymbolKind::Parameter(i) => p[i],
        SymbolKind::Acceleration(_) | SymbolKind::Definition(_) | SymbolKind::Inertial(_) => f64::NAN,
    })
}

fn kept(path: &Path) -> (String, Value) {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let file = root().join(format!("tests/oracle/data/{name}.json"));
    let text = std::fs::read_to_string(&file).unwrap_or_else(|_| panic!("{name}: no numbers of the oracle; run `cargo xtask oracle`"));
    (name, serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", file.display())))
}

/// Sizes of the terms that forces and accelerations are made of at a state. Terms cancel to nothing where a joint's axis
/// is one of symmetry, and then rounding of the terms is all that is left on one side or on both.
struct Scales {
    force: f64,
    /// For each row below q' = v.
    rates: Vec<f64>,
}

impl Scales {
    fn new(state: &Value, n: usize) -> Self {
        let size = |list: &[f64]| list.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let of = |key: &str| flat(&state[key]);
        let (m, x, rates) = (of("M"), of("x"), of("rates"));
        let speed = size(&x[n..2 * n]);
        let force =
            ["bias", "gravity", "dissipation", "force"].iter().fold(size(&m) * (speed * speed).max(1.0), |f, key| f.max(size(&of(key))));
        let row = |i: usize| if i < n && m[i * n + i] > 0.0 { rates[i].abs().max(force / m[i * n + i]) } else { rates[i].abs() };
        Self { force, rates: (0..rates.len()).map(row).collect() }
    }

    /// Largest difference of a quantity, relative; columns of P times their parameters, so that all are of a size.
    fn difference(&self, quantity: &Quantity, ours: &[f64], theirs: &[f64], p: &[f64]) -> f64 {
        match quantity.name {
            "P" => {
                let times = |list: &[f64]| {
                    list.iter().enumerate().map(|(k, x)| if p[k % p.len()] == 0.0 { *x } else { x * p[k % p.len()] }).collect::<Vec<_>>()
                };
                by_rows_of_scale(&times(ours), &times(theirs), quantity.columns, |i| self.rates[i])
            }
            "A" | "B" => by_rows_of_scale(ours, theirs, quantity.columns, |i| self.rates[i]),
            "rates" => by_rows_of_scale(ours, theirs, 1, |i| self.rates[i]),
            "bias" | "gravity" | "dissipation" | "force" => by_rows_of_scale(ours, theirs, quantity.columns, |_| self.force),
            _ => by_rows_of_scale(ours, theirs, quantity.columns, |_| 0.0),
        }
    }
}

/// Differences at all states: (quantity, state, difference).
fn differences(e: &Equations, oracle: &Value) -> Vec<(&'static str, usize, f64)> {
    let list = quantities(e);
    let states = oracle["states"].as_array().expect("states");
    assert_eq!(states.len(), 20);
    let mut out = Vec::new();
    for (k, state) in states.iter().enumerate() {
        let p = flat(&state["p"]);
        let scales = Scales::new(state, e.layout.q.len());
        for quantity in &list {
            // equations written directly have no energies on either side
            let ours = evaluate(e, &quantity.roots, state, &p);
            let theirs = flat(&state[quantity.name]);
            out.push((quantity.name, k, scales.difference(quantity, &ours, &theirs, &p)));
        }
    }
    out
}

fn derived(rig: &Rig, name: &str) -> Equations {
    derive(rig, Options::default()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn every_rig_agrees_with_casadi() {
    let mut faults = Vec::new();
    for path in oracle_rigs() {
        let rig = rig_of(&path);
        let (name, oracle) = kept(&path);
        assert_eq!(
            oracle["declared"],
            Value::from(declared_fingerprint(&declared(&rig))),
            "{name}: the rig has changed since the oracle's numbers were made; run `cargo xtask oracle`"
        );
        let e = derived(&rig, &name);
        let n = e.layout.q.len();
        // the upper rows of A, B and P say q' = v, whatever the rig
        for (i, row) in e.linear.a[..n].iter().enumerate() {
            let values = e.graph.evaluate(row, |_| f64::NAN);
            assert!(values.iter().enumerate().all(|(j, &x)| x == f64::from(u8::from(j == n + i))), "{name}: row {i} of A");
        }
        for row in e.linear.b[..n].iter().chain(&e.parameter_jacobian[..n]) {
            assert!(e.graph.evaluate(row, |_| f64::NAN).iter().all(|&x| x == 0.0), "{name}: upper rows of B and P");
        }
        let all = differences(&e, &oracle);
        let worst = all.iter().fold(("", 0, 0.0), |m, &d| if d.2 > m.2 { d } else { m });
        println!("{name:24} worst of {} comparisons {:.1e} in {}", all.len(), worst.2, worst.0);
        faults.extend(all.iter().filter(|d| d.2 > TOLERANCE).map(|(q, k, d)| format!("{name}: {q} at state {k} differs by {d:.1e}")));
    }
    assert!(faults.is_empty(), "{} differences from CasADi:\n{}", faults.len(), faults[..faults.len().min(40)].join("\n"));
}

#[test]
fn every_trim_agrees_with_casadi() {
    for path in oracle_rigs() {
        let rig = rig_of(&path);
        let (name, oracle) = kept(&path);
        let trims = oracle["trims"].as_array().expect("trims");
        assert_eq!(trims.len(), rig.trims.len(), "{name}");
        let e = derived(&rig, &name);
        let n = e.layout.q.len();
        let p = e.layout.nominal.clone();
        let list = quantities(&e);
        let model = InProcess::new(derived(&rig, &name));
        for (trim, theirs) in operating_points(&rig, &e.layout, e.lumps).into_iter().zip(trims) {
            let label = format!("{name}, trim {}", trim.name);
            assert_eq!(theirs["name"], trim.name.as_str());
            let residual = theirs["residual"].as_f64().unwrap_or(f64::NAN);
            let problem = problem(trim, &e.layout);
            let ours = control::solve(&model, &p, &problem);
            if residual > 1e-6 {
                assert!(
                    matches!(ours, Err(TrimError::NoConvergence { .. })),
                    "{label}: the oracle finds no operating point, ours: {ours:?}"
                );
                assert!(
                    REFUSED.contains(&label.as_str()),
                    "{label}: there is no such operating point; mend the rig, or list it as refused"
                );
                println!("{label}: refused by both");
                continue;
            }
            assert!(residual < 1e-9, "{label}: the oracle's residual is {residual:e}");
            // A and B at the oracle's operating point
            for quantity in list.iter().filter(|q| ["A", "B"].contains(&q.name)) {
                let ours = evaluate(&e, &quantity.roots, theirs, &p);
                let d = by_rows_of_scale(&ours, &flat(&theirs[quantity.name]), quantity.columns, |_| 0.0);
                assert!(d <= TOLERANCE, "{label}: {} differs by {d:.1e}", quantity.name);
            }
            regulator(&label, theirs, n, &model);
            // our own operating point
            let ours = ours.unwrap_or_else(|error| panic!("{label}: {error}"));
            let lags = model.dimensions().lags;
            let full = theirs["rank"] == theirs["unknowns"];
            assert_eq!(
                full,
                ours.rank == ours.unknowns,
                "{label}: rank {} of {}, the oracle's {} of {} (lags counted)",
                ours.rank,
                ours.unknowns,
                theirs["rank"],
                theirs["unknowns"]
            );
            assert_eq!(theirs["unknowns"].as_u64(), Some((ours.unknowns + lags) as u64), "{label}");
            if full {
                let (x, u) = (flat(&theirs["x"]), flat(&theirs["u"]));
                for (what, ours, theirs) in [("x*", &ours.x, &x), ("u*", &ours.u, &u)] {
                    // angles, rates and forces of about one
                    let d = ours.iter().zip(theirs).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs() / b.abs().max(1.0)));
                    assert!(d < 1e-9, "{label}: {what} differs by {d:.1e}\nours   {ours:?}\ntheirs {theirs:?}");
                }
                let drift = flat(&theirs["rates"]);
                assert!(
                    ours.drift.iter().zip(&drift[..n]).all(|(a, b)| (a - b).abs() < 1e-8),
                    "{label}: drift {:?}, the oracle's {drift:?}",
                    ours.drift
                );
            }
            println!("{label}: rank {} of {}, {}", ours.rank, ours.unknowns, if full { "agrees" } else { "free direction, A and B agree" });
        }
    }
}

/// The gain with identity weights at the oracle's A and B, by SciPy and by us; refused by both where the rig's inputs
/// cannot stabilize it.
fn regulator(label: &str, theirs: &Value, n: usize, model: &InProcess) {
    let (lags, inputs) = (model.dimensions().lags, model.dimensions().inputs);
    let states = 2 * n + lags;
    let rates = n + lags;
    let below = DMatrix::from_row_slice(rates, states, &flat(&theirs["A"]));
    let all = flat(&theirs["B"]);
    let below_b = DMatrix::from_row_slice(rates, all.len() / rates.max(1), &all);
    let a = DMatrix::from_fn(states, states, |i, j| if i < n { f64::from(u8::from(j == n + i)) } else { below[(i - n, j)] });
    let b = DMatrix::from_fn(states, inputs, |i, j| if i < n { 0.0 } else { below_b[(i - n, j)] });
    let (q, r) = (DMatrix::identity(states, states), DMatrix::identity(inputs, inputs));
    let ours = control::care(RiccatiData { a: &a, b: &b, q: &q, r: &r, cross: None });
    if theirs["K"].is_null() {
        assert!(ours.is_err(), "{label}: no gain stabilizes it, says the oracle; ours does");
        println!("{label}: no gain, for both");
        return;
    }
    let ours = ours.unwrap_or_else(|e| panic!("{label}: {e:?}"));
    let wanted = DMatrix::from_row_slice(inputs, states, &flat(&theirs["K"]));
    let d = (&ours.gain - &wanted).norm() / wanted.norm();
    println!("{label}: K differs by {d:.1e}");
    assert!(d < 1e-8, "{label}: K differs by {d:.1e}\nours {}theirs {wanted}", ours.gain);
}

/// The comparison can fail: one sign of one rig turned is seen in force, rates, B and P, and nowhere that it should not be.
#[test]
fn a_turned_sign_is_seen() {
    let path = root().join("examples/rigs/googol.rig");
    let text = std::fs::read_to_string(&path).expect("the rig");
    let wrong = text.replace("at (0, -l_df, 0): (0, 0, f_1)", "at (0, l_df, 0): (0, 0, f_1)");
    assert_ne!(text, wrong);
    let checked = model_dsl::check_text("wrong.rig", &wrong);
    let rig = checked.rig.expect("still a rig");
    let (_, oracle) = kept(&path);
    assert_ne!(oracle["declared"], Value::from(declared_fingerprint(&declared(&rig))));
    let e = derived(&rig, "wrong");
    let mut seen: Vec<&str> = differences(&e, &oracle).iter().filter(|d| d.2 > TOLERANCE).map(|d| d.0).collect();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen, ["A", "B", "P", "force", "rates"]);
}

/// An unknown is found by its name; a mixed input moves the inputs so that the other mixed inputs stay.
#[test]
fn mixed_inputs_move_their_inputs() {
    let rig = rig_of(&root().join("examples/rigs/googol.rig"));
    let layout = derived(&rig, "googol").layout;
    let f_d = direction_by_name(&rig, &layout, "f_d").expect("a mixed input");
    assert_eq!((f_d.name.as_str(), f_d.states, f_d.signals), ("f_d", vec![], vec![(0, 0.5), (1, -0.5)]));
}
