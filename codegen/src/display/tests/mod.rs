//! Display forms keep values: normal forms against the graph, printed text and LaTeX read back and evaluated.

mod reading;

use super::arrange::{Knowledge, argument, shortened, written};
use super::entries::{knowledge, read_all};
use super::form::{Atom, Class, Forms, Sum};
use super::latex::latex;
use super::read::{Reader, register};
use super::text::text;
use super::tree::{Tree, name_of};
use crate::expr::{F1, F2, Graph, Id, Node, SymbolKind};
use crate::lower::{Lowering, Lumps};
use crate::{Equations, Options, derive};
use model_dsl::rig::{BinaryOp, Expr, Function, Rig, Symbol};
use rustc_hash::FxHashMap;
use std::path::PathBuf;

/// SplitMix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    fn within(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn example_rigs() -> Vec<(String, Rig)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../examples/rigs");
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("example rigs")
        .flatten()
        .map(|e| e.path())
        .filter(|p| p.extension().is_some_and(|x| x == "rig"))
        .collect();
    paths.sort();
    paths
        .into_iter()
        .map(|path| {
            let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
            (path.file_stem().expect("a file").to_string_lossy().into_owned(), checked.rig.expect("a correct rig"))
        })
        .collect()
}

fn all_entries(e: &Equations) -> Vec<Id> {
    let mut roots = e.mass_matrix.concat();
    roots.extend(e.coriolis.iter().flatten());
    roots.extend(
        e.gravity.iter().chain(&e.springs).chain(&e.bias).chain(&e.dissipation).chain(&e.force).chain(&e.lag_rates).chain(&e.outputs),
    );
    roots.extend(e.input_map.iter().flatten());
    roots
}

/// Values of names: coordinates, rates and signals at random, parameters nominal.
fn random_values(rig: &Rig, e: &Equations, r: &mut Random) -> FxHashMap<String, f64> {
    let mut values: FxHashMap<String, f64> = FxHashMap::default();
    for v in e.layout.x().chain(&e.layout.u).chain(&e.layout.a) {
        values.insert(v.name.clone(), r.within(-1.0, 1.0));
    }
    values.insert("t".to_owned(), r.within(0.0, 1.0));
    for (p, &x) in e.layout.p.iter().zip(&e.layout.nominal) {
        values.insert(p.name.clone(), x);
    }
    for mix in &rig.mixes {
        for (name, row) in mix.names.iter().zip(&mix.rows) {
            let x = mix.inputs.iter().zip(row).map(|(&i, k)| k * values[&rig.inputs[i].name]).sum();
            values.insert(name.clone(), x);
        }
    }
    // lumps without a value of their own stand for their definitions
    let mut graph = Graph::new();
    let lowering = Lowering::new(rig, e.lumps, true, &mut graph);
    for d in rig.definitions.iter().filter(|d| d.parameter.is_none()) {
        let id = lowering.expr(&mut graph, &d.value);
        let x = graph.evaluate(&[id], |s| values[&graph.symbol_info(s).name])[0];
        values.insert(d.name.clone(), x);
    }
    values
}

/// Sizes of what is added up on the way to each root: what the rounding of the graph's own value is relative to.
fn magnitudes(g: &Graph, roots: &[Id], value: impl Fn(&str) -> f64) -> Vec<f64> {
    let mut of: FxHashMap<Id, (f64, f64)> = FxHashMap::default();
    for id in g.reachable(roots) {
        let x = g.evaluate(&[id], |s| value(&g.symbol_info(s).name))[0];
        let size = match g.node(id) {
            Node::Add(a, b) | Node::Sub(a, b) => of[&a].1 + of[&b].1,
            Node::Mul(a, b) => of[&a].1 * of[&b].1,
            Node::Div(a, b) => of[&a].1 / of[&b].0.abs(),
            Node::Neg(a) => of[&a].1,
            Node::Powi(a, n) if n > 0 => of[&a].1.powi(n),
            _ => x.abs(),
        };
        of.insert(id, (x, size));
    }
    roots.iter().map(|id| of[id].1).collect()
}

/// Sum of the magnitudes of a form's terms: what rounding is relative to.
fn size(forms: &Forms, sum: &Sum, value: &dyn Fn(&str, Class) -> f64) -> f64 {
    sum.0.iter().map(|(m, k)| (k.value() * forms.evaluate_monomial(m, value)).abs()).sum()
}

#[test]
fn forms_of_every_entry_of_every_example_have_the_graphs_value() {
    let mut r = Random(1);
    for (name, rig) in example_rigs() {
        for lumps in [Lumps::AsParameters, Lumps::Expanded] {
            let e = derive(&rig, Options { lumps, jacobians: false, ..Options::default() }).expect("equations");
            let roots = all_entries(&e);
            let mut forms = Forms::new();
            register(&rig, &mut forms);
            let mut reader = Reader::new(&rig, &e.graph);
            reader.names_parts = true;
            let sums = read_all(&mut reader, &mut forms, &roots);
            let known = knowledge(&rig, &e, &mut reader, &mut forms, &roots);
            let short: Vec<Sum> = sums.iter().map(|s| shortened(&mut forms, &known, s)).collect();
            for _ in 0..3 {
                let mut values = random_values(&rig, &e, &mut r);
                for part in &reader.parts {
                    let x = forms.evaluate(&part.value, &|n, _| values[n]);
                    if let Atom::Name(i) = forms.atom(part.atom) {
                        values.insert(forms.name(*i).0.to_owned(), x);
                    }
                }
                let exact = e.graph.evaluate(&roots, |s| values[&e.graph.symbol_info(s).name]);
                let magnitudes = magnitudes(&e.graph, &roots, |n| values[n]);
                let at = |n: &str, _: Class| values[n];
                for (((x, sum), short), magnitude) in exact.iter().zip(&sums).zip(&short).zip(magnitudes) {
                    for form in [sum, short] {
                        let y = forms.evaluate(form, &at);
                        let scale = size(&forms, form, &at).max(magnitude);
                        assert!(
                            (x - y).abs() <= 1e-12 * scale || x.is_nan(),
                            "{name}: graph {x}, form {y}\n{}",
                            text(&written(&mut forms.clone(), &known, form))
                        );
                    }
                }
            }
        }
    }
}

const NAMES: [(&str, SymbolKind); 9] = [
    ("m_h", SymbolKind::Parameter(0)),
    ("l_cd", SymbolKind::Parameter(1)),
    ("I_psi", SymbolKind::Parameter(2)),
    ("k3", SymbolKind::Parameter(3)),
    ("eps", SymbolKind::Coordinate(0)),
    ("theta", SymbolKind::Coordinate(1)),
    ("eps.dot", SymbolKind::Rate(0)),
    ("f_1.lag", SymbolKind::Lag(0)),
    ("f_2", SymbolKind::Signal(0)),
];

/// A random expression on the graph; numbers are such that eight printed digits hold them.
fn random_expression(g: &mut Graph, r: &mut Random, depth: usize) -> Id {
    if depth == 0 || r.below(8) == 0 {
        return match r.below(4) {
            0 => g.num([1.0, 2.0, -3.0, 0.5, 0.25, 0.2, 1.5, 4e-6][r.below(8)]),
            _ => {
                let (name, kind) = NAMES[r.below(NAMES.len())];
                g.symbol(name, kind)
            }
        };
    }
    let a = random_expression(g, r, depth - 1);
    match r.below(13) {
        0..=2 => {
            let b = random_expression(g, r, depth - 1);
            g.add(a, b)
        }
        3 | 4 => {
            let b = random_expression(g, r, depth - 1);
            g.sub(a, b)
        }
        5..=7 => {
            let b = random_expression(g, r, depth - 1);
            g.mul(a, b)
        }
        8 => {
            let b = random_expression(g, r, depth - 1);
            g.div(a, b)
        }
        9 => g.powi(a, [-2, -1, 3, 2][r.below(4)]),
        10 => {
            let f =
                [F1::Sin, F1::Cos, F1::Tanh, F1::Exp, F1::Abs, F1::Sqrt, F1::Ln, F1::Atan, F1::Sign, F1::SmoothSign, F1::Tan][r.below(11)];
            g.call(f, a)
        }
        11 => {
            let b = random_expression(g, r, depth - 1);
            let f = [F2::Min, F2::Max, F2::Atan2][r.below(3)];
            g.call2(f, a, b)
        }
        _ => {
            let b = g.call(F1::Exp, a);
            let n = [2.072, 0.4716, -1.5][r.below(3)];
            let n = g.num(n);
            g.call2(F2::Pow, b, n)
        }
    }
}

fn empty_rig() -> Rig {
    model_dsl::check_text("empty.rig", "rig E { coord q: rad; frame f = ground.rotate(z, q); body b on f { mass 1 kg; at (1, 0, 0); } }")
        .rig
        .expect("a rig")
}

/// Where a value is too large or its terms cancel, rounding says more than the printer.
fn comparable(x: f64) -> bool {
    x.is_finite() && x.abs() < 1e4
}

#[test]
fn printed_expressions_read_back_to_the_same_value() {
    let rig = empty_rig();
    let mut r = Random(7);
    let mut compared = 0;
    for _ in 0..1500 {
        let mut g = Graph::new();
        let depth = 1 + r.below(4);
        let id = random_expression(&mut g, &mut r, depth);
        let mut forms = Forms::new();
        let mut reader = Reader::new(&rig, &g);
        let Some(form) = reader.read(&mut forms, &[id]).pop().flatten() else { continue };
        let none = Knowledge::default();
        let trees = [written(&mut forms, &none, &form), argument(&mut forms, &none, &form)];
        for _ in 0..3 {
            let values: FxHashMap<String, f64> = NAMES.iter().map(|n| (n.0.to_owned(), r.within(-1.5, 1.5))).collect();
            let exact = g.evaluate(&[id], |s| values[&g.symbol_info(s).name])[0];
            let at = |n: &str, _: Class| values[n];
            // rounding of cancelling terms is not the printer's
            let scale = size(&forms, &form, &at).max(1.0);
            if !comparable(exact) || !comparable(scale) {
                continue;
            }
            let form_value = forms.evaluate(&form, &at);
            assert!((form_value - exact).abs() <= 1e-9 * scale, "form {form_value}, graph {exact}: {}", text(&trees[0]));
            for tree in &trees {
                for (what, back) in
                    [(text(tree), reading::text_value(&text(tree), &values)), (latex(tree), reading::latex_value(&latex(tree), &values))]
                {
                    let back = back.unwrap_or_else(|error| panic!("{error}: {what}"));
                    if back.is_finite() {
                        compared += 1;
                        assert!((back - exact).abs() <= 1e-7 * scale, "{what}\nreads back as {back}, is {exact}");
                    }
                }
            }
        }
    }
    assert!(compared > 8_000, "{compared}");
}

/// A random expression as the language has it.
fn random_written(r: &mut Random, depth: usize) -> Expr {
    if depth == 0 || r.below(6) == 0 {
        return match r.below(3) {
            0 => Expr::Number([1.0, 2.0, -3.0, 0.5, 0.2, 2.072][r.below(6)]),
            _ => Expr::Symbol([Symbol::Coordinate(0), Symbol::Rate(0), Symbol::Time][r.below(3)]),
        };
    }
    let a = Box::new(random_written(r, depth - 1));
    match r.below(9) {
        0 => Expr::Neg(a),
        1 => Expr::Call([Function::Sin, Function::Tanh, Function::Exp, Function::Abs][r.below(4)], vec![*a]),
        2 => Expr::Call([Function::Saturate, Function::DeadZone, Function::Min][r.below(3)], vec![*a]),
        k => {
            let op = [BinaryOp::Add, BinaryOp::Sub, BinaryOp::Mul, BinaryOp::Div, BinaryOp::Pow, BinaryOp::Sub][k - 3];
            Expr::Binary(op, a, Box::new(random_written(r, depth - 1)))
        }
    }
}

/// Functions of several arguments get theirs filled up, so that the arity is right.
fn with_arity(expr: Expr) -> Expr {
    match expr {
        Expr::Call(f, args) => {
            let mut args: Vec<Expr> = args.into_iter().map(with_arity).collect();
            match f {
                Function::Saturate => args.extend([Expr::Number(-0.5), Expr::Number(0.5)]),
                Function::DeadZone | Function::Min => args.push(Expr::Number(0.5)),
                _ => {}
            }
            Expr::Call(f, args)
        }
        Expr::Neg(a) => Expr::Neg(Box::new(with_arity(*a))),
        Expr::Binary(op, a, b) => Expr::Binary(op, Box::new(with_arity(*a)), Box::new(with_arity(*b))),
        other => other,
    }
}

/// Value of an expression; not a number where any part of it is none.
fn value_of(expr: &Expr, value: &dyn Fn(Symbol) -> f64) -> f64 {
    match expr {
        Expr::Number(x) => *x,
        Expr::Symbol(s) => value(*s),
        Expr::Neg(a) => -value_of(a, value),
        Expr::Binary(op, a, b) => {
            let (a, b) = (value_of(a, value), value_of(b, value));
            match op {
                BinaryOp::Add => a + b,
                BinaryOp::Sub => a - b,
                BinaryOp::Mul => a * b,
                BinaryOp::Div => a / b,
                BinaryOp::Pow if a.is_nan() || b.is_nan() => f64::NAN,
                BinaryOp::Pow => a.powf(b),
            }
        }
        Expr::Call(f, args) => {
            let x = value_of(&args[0], value);
            match f {
                _ if x.is_nan() => f64::NAN,
                Function::Sin => x.sin(),
                Function::Tanh => x.tanh(),
                Function::Exp => x.exp(),
                Function::Abs => x.abs(),
                Function::Saturate => x.clamp(-0.5, 0.5),
                Function::DeadZone => x - x.clamp(-0.5, 0.5),
                _ => x.min(0.5),
            }
        }
    }
}

#[test]
fn written_expressions_keep_their_brackets() {
    let rig = empty_rig();
    let mut r = Random(3);
    let mut compared = 0;
    for _ in 0..3000 {
        let expr = with_arity(random_written(&mut r, 4));
        let tree = Tree::of_expr(&rig, &expr);
        let values: FxHashMap<String, f64> =
            [Symbol::Coordinate(0), Symbol::Rate(0), Symbol::Time].iter().map(|&s| (name_of(&rig, s), r.within(0.2, 1.5))).collect();
        let exact = value_of(&expr, &|s| values[&name_of(&rig, s)]);
        if !comparable(exact) {
            continue;
        }
        for (what, back) in
            [(text(&tree), reading::text_value(&text(&tree), &values)), (latex(&tree), reading::latex_value(&latex(&tree), &values))]
        {
            let back = back.unwrap_or_else(|error| panic!("{error}: {what}"));
            if back.is_finite() {
                compared += 1;
                assert!((back - exact).abs() <= 1e-7 * exact.abs().max(1.0), "{what}\nreads back as {back}, is {exact}");
            }
        }
    }
    assert!(compared > 3000, "{compared}");
}
