//! Every operation of the graph, and random expressions, through both printers: the printed Rust (checked in as
//! `fixtures/operations.rs`, kept fresh here) and the printed C give the graph's own values.
//!
//! `UPDATE_FIXTURES=1 cargo test -p cross-checks --test printed_operations` writes the fixture anew.

use codegen::emit::{c_function, rust_function};
use codegen::expr::{F1, F2, Graph, Id, SymbolId, SymbolKind};
use cross_checks::c_compiler::{Compiled, compile_and_run};
use cross_checks::random::Random;
use std::fmt::Write;

#[rustfmt::skip]
mod fixtures {
    pub mod operations;
}

const ONE: [F1; 16] = [
    F1::Sin, F1::Cos, F1::Tan, F1::Asin, F1::Acos, F1::Atan, F1::Sinh, F1::Cosh, F1::Tanh, F1::Exp, F1::Ln, F1::Sqrt, F1::Abs, F1::Sign, F1::Step,
    F1::SmoothSign,
];
const TWO: [F2; 4] = [F2::Atan2, F2::Min, F2::Max, F2::Pow];
/// Functions of random expressions.
const RANDOM: u64 = 12;

/// Names that are keywords, functions or arguments elsewhere: the printers must cope with them too.
const NAMES: [&str; 4] = ["a", "type", "sin", "double.dot"];

struct Case {
    name: String,
    graph: Graph,
    symbols: Vec<SymbolId>,
    roots: Vec<Id>,
}

fn symbols(g: &mut Graph) -> Vec<Id> {
    NAMES.iter().enumerate().map(|(i, name)| g.symbol(name, SymbolKind::Parameter(i))).collect()
}

fn case(name: &str, build: impl FnOnce(&mut Graph, &[Id]) -> Vec<Id>) -> Case {
    let mut graph = Graph::new();
    let s = symbols(&mut graph);
    let roots = build(&mut graph, &s);
    let symbols = s.iter().filter_map(|&id| graph.symbol_of(id)).collect();
    Case { name: name.to_owned(), graph, symbols, roots }
}

/// Each of the systematic expressions is a function of its own, so that none is shared and all are written out.
fn cases() -> Vec<Case> {
    let mut list = Vec::new();
    for case in systematic() {
        for (k, &root) in case.roots.iter().enumerate() {
            list.push(Case { name: format!("{}_{k}", case.name), graph: case.graph.clone(), symbols: case.symbols.clone(), roots: vec![root] });
        }
    }
    list.extend((0..RANDOM).map(|seed| case(&format!("random_{seed}"), |g, s| random_expressions(g, s, seed))));
    list
}

fn systematic() -> Vec<Case> {
    vec![
        case("functions", |g, s| {
            let mut roots: Vec<Id> = ONE.iter().map(|&f| g.call(f, s[0])).collect();
            roots.extend(TWO.map(|f| g.call2(f, s[1], s[2])));
            // a function of a sum, of a product, of a function
            let sum = g.sub(s[0], s[1]);
            roots.push(g.cos(sum));
            let product = g.mul(s[0], s[3]);
            let double = g.num(2.0);
            let double = g.mul(double, s[1]);
            roots.extend([g.call(F1::Atan, product), g.sin(double), g.cos(double)]);
            let inner = g.call(F1::Abs, sum);
            let outer = g.call(F1::Sqrt, inner);
            roots.push(g.call2(F2::Atan2, outer, product));
            roots
        }),
        case("arithmetic", |g, s| {
            let (a, b, c, d) = (s[0], s[1], s[2], s[3]);
            let mut roots = Vec::new();
            let (ab, cd, bc) = (g.add(a, b), g.add(c, d), g.sub(b, c));
            let (product, quotient) = (g.mul(a, b), g.div(c, d));
            // nested differences: a - (b - c), (a - b) - c, a - (b + c)
            roots.push(g.sub(a, bc));
            let left = g.sub(a, b);
            roots.push(g.sub(left, c));
            roots.push(g.sub(a, cd));
            // signs of products and quotients, and what is subtracted from them
            let (minus_product, minus_quotient) = (g.neg(product), g.neg(quotient));
            roots.extend([minus_product, minus_quotient, g.sub(minus_product, quotient), g.sub(d, minus_quotient)]);
            // quotients of sums, of products, of quotients
            roots.extend([g.div(ab, cd), g.div(a, bc), g.div(product, quotient), g.div(quotient, product)]);
            let (upper, lower) = (g.div(a, b), g.div(ab, c));
            roots.extend([g.div(upper, lower), g.div(lower, upper), g.mul(upper, lower)]);
            let one = g.one();
            let inverse = g.div(one, product);
            roots.extend([inverse, g.div(one, inverse), g.sub(one, inverse)]);
            // products of sums, squares, powers
            roots.extend([g.mul(ab, cd), g.square(ab), g.square(a), g.mul(product, ab)]);
            for n in [-5, -3, -2, -1, 3, 4, 7] {
                roots.extend([g.powi(a, n), g.powi(bc, n)]);
            }
            // numbers: negative, large, small, exact
            for x in [-2.0, 0.5, 1e-9, 6.02e23, -1.0 / 3.0, 1e300] {
                let k = g.num(x);
                roots.extend([k, g.mul(k, a), g.add(a, k), g.sub(k, a), g.div(a, k), g.div(k, a), g.sub(product, k)]);
                let scaled = g.mul(k, ab);
                roots.extend([scaled, g.sub(c, scaled)]);
            }
            roots
        }),
    ]
}

/// A dozen values grown from the symbols, each over earlier ones, so that many are shared.
fn random_expressions(g: &mut Graph, s: &[Id], seed: u64) -> Vec<Id> {
    let mut r = Random::new(seed + 100);
    let mut pool = s.to_vec();
    for _ in 0..60 {
        let (a, b) = (pool[r.below(pool.len())], pool[r.below(pool.len())]);
        let made = match r.below(12) {
            0 | 1 => g.add(a, b),
            2..=4 => g.sub(a, b),
            5 | 6 => g.mul(a, b),
            7 => {
                // bounded away from zero, so that the comparison means something
                let one = g.one();
                let square = g.square(b);
                let below = g.add(one, square);
                g.div(a, below)
            }
            8 => g.neg(a),
            9 => {
                let bounded = g.call(F1::Atan, a);
                g.powi(bounded, 3 + r.below(3) as i32)
            }
            10 => {
                let f = [F1::Sin, F1::Cos, F1::Atan, F1::Tanh, F1::Abs, F1::SmoothSign][r.below(6)];
                g.call(f, a)
            }
            _ => g.call2([F2::Min, F2::Max, F2::Atan2][r.below(3)], a, b),
        };
        // large numbers would hide small ones
        let made = if r.chance(0.3) { g.sin(made) } else { made };
        pool.push(made);
    }
    pool.split_off(pool.len() - 12)
}

fn inputs(seed: u64) -> [f64; 4] {
    let mut r = Random::new(seed);
    [r.within(0.1, 0.9), r.within(0.2, 2.0), r.within(2.5, 4.0), r.within(-1.5, -0.2)]
}

fn agree(name: &str, language: &str, values: &[f64], wanted: &[f64]) {
    assert_eq!(values.len(), wanted.len(), "{name}");
    for (i, (a, b)) in values.iter().zip(wanted).enumerate() {
        // each entry by itself: these are short expressions. Random ones cancel by up to two digits
        let tolerance = if name.starts_with("random") { 1e-12 } else { 1e-13 };
        let same = a == b || a.is_nan() && b.is_nan() || (a - b).abs() <= tolerance * b.abs();
        assert!(same, "{name}, result {i} in {language}: {a:?} instead of {b:?}");
    }
}

fn fixture() -> String {
    let mut out = String::from("//! Printed expressions: see `printed_operations.rs`, which writes this file and keeps it fresh.\n\nuse runtime::math::*;\n");
    for case in cases() {
        let _ = write!(out, "\n{}", rust_function(&case.graph, &case.name, &case.symbols, &case.roots));
    }
    let calls: Vec<String> = cases().iter().map(|c| format!("        {0:?} => {0}(v[0], v[1], v[2], v[3]).to_vec(),\n", c.name)).collect();
    let _ = write!(out, "\npub fn call(name: &str, v: [f64; 4]) -> Vec<f64> {{\n    match name {{\n{}        _ => Vec::new(),\n    }}\n}}\n", calls.concat());
    out
}

#[test]
fn rust_gives_the_values_of_the_graph() {
    let place = cross_checks::root().join("tests/tests/fixtures/operations.rs");
    let wanted = fixture();
    if std::env::var_os("UPDATE_FIXTURES").is_some() {
        std::fs::write(&place, &wanted).unwrap_or_else(|e| panic!("{}: {e}", place.display()));
    }
    let found = std::fs::read_to_string(&place).unwrap_or_default();
    assert!(found == wanted, "fixtures/operations.rs is stale: run with UPDATE_FIXTURES=1, then again");
    for case in cases() {
        for seed in 0..8 {
            let v = inputs(seed);
            let graph = case.graph.evaluate(&case.roots, |s| v[case.symbols.iter().position(|&x| x == s).unwrap_or(0)]);
            agree(&case.name, "Rust", &fixtures::operations::call(&case.name, v), &graph);
        }
    }
}

#[test]
fn c_gives_the_values_of_the_graph() {
    let mut files: Vec<(String, String)> = Vec::new();
    let mut main = String::from("#include <stdio.h>\n\n");
    let mut systematic = String::from("#include <math.h>\n");
    let mut calls = String::new();
    for case in cases() {
        let text = c_function(&case.graph, &case.name, &case.symbols, &case.roots);
        let n = case.roots.len();
        let prototype = format!("void {}(double, double, double, double, double y[{n}]);\n", case.name);
        main.push_str(&prototype);
        for seed in 0..8 {
            let v = inputs(seed);
            let _ = writeln!(
                calls,
                "    {{\n        double y[{n}];\n        {}({:?}, {:?}, {:?}, {:?}, y);\n        for (int i = 0; i < {n}; i++) {{\n            printf(\"%.17g\\n\", y[i]);\n        }}\n    }}",
                case.name, v[0], v[1], v[2], v[3]
            );
        }
        // the static functions that each needs come once a file: one file for the expressions without them
        if text.starts_with("void") {
            let _ = write!(systematic, "\n{prototype}\n{text}");
        } else {
            files.push((format!("{}.c", case.name), format!("#include <math.h>\n\n{prototype}\n{text}")));
        }
    }
    let _ = write!(main, "\nint main(void)\n{{\n{calls}    return 0;\n}}\n");
    files.push(("systematic.c".to_owned(), systematic));
    files.push(("main.c".to_owned(), main));
    let borrowed: Vec<(&str, &str)> = files.iter().map(|f| (f.0.as_str(), f.1.as_str())).collect();
    let printed = match compile_and_run("c_operations", &borrowed) {
        Compiled::Printed(text) => text,
        Compiled::NoCompiler => {
            println!("printed operations in C: skipped (there is no C compiler `cc`)");
            return;
        }
    };
    let mut lines = printed.lines();
    for case in cases() {
        for seed in 0..8 {
            let v = inputs(seed);
            let graph = case.graph.evaluate(&case.roots, |s| v[case.symbols.iter().position(|&x| x == s).unwrap_or(0)]);
            let values: Vec<f64> = graph.iter().map(|_| lines.next().map_or(0.0, |l| if l.contains("nan") { f64::NAN } else { l.parse().unwrap_or(0.0) })).collect();
            agree(&case.name, "C", &values, &graph);
        }
    }
}
