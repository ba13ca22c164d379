//! Instructions that each step takes as joints grow, by valgrind, and the power of the joints with which they grow.
//!
//! A step is counted as the difference of two runs of this program, with the step and without it.

use crate::calls::{Quantity, calls};
use crate::rigs::{self, Shape};
use crate::table::Table;
use crate::{instructions, timing};
use codegen::{Equations, Options, derive};
use jit::{Evaluation, InProcess};
use std::collections::BTreeMap;
use std::hint::black_box;

/// The hidden argument by which this program is run under valgrind.
pub const STEP: &str = "--step";

const JOINTS: [usize; 4] = [15, 20, 25, 30];
/// Runs of a derivation of which the fastest counts.
const RUNS: usize = 7;

/// What is counted: name, the run with it, the run without it.
const STEPS: [(&str, &str, Option<&str>); 6] = [
    ("check the text", "check", None),
    ("derive, no Jacobians", "equations", Some("check")),
    ("derive, all", "derive", Some("check")),
    ("print Rust", "rust", Some("derive")),
    ("compile x'", "forward", Some("derive")),
    ("compile [A, B]", "linear", Some("derive")),
];

/// The order in which the program's shapes are listed, by name.
pub const SHAPES: [(Shape, &str); 3] = [(Shape::Planar, "planar chain"), (Shape::Chain, "chain z, y, x"), (Shape::Tree, "tree z, y, x")];

/// Does all up to a step once: what runs under valgrind.
///
/// # Errors
/// Where the arguments are not those that [`table`] gives.
pub fn run(arguments: &[String]) -> Result<(), String> {
    let [step, shape, joints] = arguments else { return Err(format!("{STEP} is for internal use")) };
    let (shape, _) = SHAPES.into_iter().find(|(_, name)| name == shape).ok_or("no such shape")?;
    let rig = rigs::check("family", &rigs::family(shape, joints.parse().map_err(|_| "no number")?))?;
    let compiled = |equations: Equations, what| {
        let model = InProcess::evaluated(equations, Evaluation::Compiled);
        calls(&model, what, |call| call(0.0))
    };
    match step.as_str() {
        "check" => {}
        "equations" => {
            black_box(derive(&rig, Options { jacobians: false, ..Options::default() }).map_err(|e| e.to_string())?);
        }
        "derive" => {
            black_box(rigs::equations(&rig)?);
        }
        "rust" => {
            black_box(codegen::emit::rust(&rigs::equations(&rig)?, "family.rig"));
        }
        "forward" => compiled(rigs::equations(&rig)?, Quantity::Forward)?,
        "linear" => compiled(rigs::equations(&rig)?, Quantity::Linear)?,
        _ => return Err(format!("{step}: no such step")),
    }
    black_box(&rig);
    Ok(())
}

/// Millions of instructions of each step, the power that fits them, and seconds of deriving beside them.
///
/// # Errors
/// Where valgrind is not there or fails.
pub fn table() -> Result<Table, String> {
    let mut head = vec!["shape".to_owned(), "step".to_owned()];
    head.extend(JOINTS.map(|n| format!("{n} joints")));
    head.push("power".to_owned());
    let mut table = Table::new(
        "instructions [10^6] of each step by joints, and the power of the joints that fits them",
        &head.iter().map(String::as_str).collect::<Vec<_>>(),
    );
    for (shape, name) in SHAPES {
        let mut counted: BTreeMap<(&str, usize), f64> = BTreeMap::new();
        for (words, with, without) in STEPS {
            let mut costs = Vec::new();
            for n in JOINTS {
                let count = instructions::counted(&[STEP, with, name, &n.to_string()])? / 1e6;
                counted.insert((with, n), count);
                // a step stands after the one without which it cannot be
                costs.push(count - without.and_then(|step| counted.get(&(step, n))).unwrap_or(&0.0));
            }
            row(&mut table, name, words, &costs);
        }
        let mut costs = Vec::new();
        for n in JOINTS {
            let rig = rigs::check("family", &rigs::family(shape, n))?;
            costs.push(timing::fastest(RUNS, || rigs::equations(&rig)).0);
        }
        row(&mut table, name, "derive, all [ms]", &costs);
    }
    Ok(table)
}

fn row(table: &mut Table, shape: &str, step: &str, costs: &[f64]) {
    let mut cells = vec![shape.to_owned(), step.to_owned()];
    cells.extend(costs.iter().map(|c| format!("{c:.1}")));
    cells.push(format!("{:.2}", power(&JOINTS.map(|n| n as f64), costs)));
    table.row(cells);
}

/// The k of the line log cost = k log n + c of least squares.
fn power(n: &[f64], cost: &[f64]) -> f64 {
    let mean = |v: &[f64]| v.iter().map(|x| x.ln()).sum::<f64>() / v.len() as f64;
    let (x, y) = (mean(n), mean(cost));
    let (top, bottom) = n.iter().zip(cost).fold((0.0, 0.0), |(top, bottom), (n, c)| {
        let d = n.ln() - x;
        (top + d * (c.ln() - y), bottom + d * d)
    });
    top / bottom
}
