//! The symbolic core against plain arithmetic: random expressions are built twice, on the graph (with its
//! rewrites) and as closures' values with their exact first derivatives (dual numbers), and must agree.

use codegen::expr::{Derivative, F1, F2, Graph, Id, SymbolKind};

/// Value and first derivative.
#[derive(Clone, Copy, Debug)]
struct Dual {
    x: f64,
    dx: f64,
}

struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }
}

const NAMES: [&str; 3] = ["a", "b", "c"];
const VALUES: [f64; 3] = [0.7, -0.4, 1.3];

/// One random expression over three symbols; the derivative is by `a`.
fn grow(g: &mut Graph, r: &mut Random, depth: u32) -> (Id, Dual) {
    if depth == 0 || r.below(8) == 0 {
        return match r.below(5) {
            0 => {
                let x = [0.0, 1.0, -1.0, 2.0, 0.5][r.below(5) as usize];
                (g.num(x), Dual { x, dx: 0.0 })
            }
            _ => {
                let k = r.below(3) as usize;
                (g.symbol(NAMES[k], SymbolKind::Coordinate(k)), Dual { x: VALUES[k], dx: if k == 0 { 1.0 } else { 0.0 } })
            }
        };
    }
    let (i, a) = grow(g, r, depth - 1);
    match r.below(14) {
        0 | 1 => {
            let (j, b) = grow(g, r, depth - 1);
            (g.add(i, j), Dual { x: a.x + b.x, dx: a.dx + b.dx })
        }
        2 | 3 => {
            let (j, b) = grow(g, r, depth - 1);
            (g.sub(i, j), Dual { x: a.x - b.x, dx: a.dx - b.dx })
        }
        4..=6 => {
            let (j, b) = grow(g, r, depth - 1);
            (g.mul(i, j), Dual { x: a.x * b.x, dx: a.dx * b.x + a.x * b.dx })
        }
        7 => {
            // a denominator away from zero: 2 + b^2
            let (j, b) = grow(g, r, depth - 1);
            let two = g.num(2.0);
            let square = g.square(j);
            let bottom = g.add(two, square);
            let d = 2.0 + b.x * b.x;
            (g.div(i, bottom), Dual { x: a.x / d, dx: (a.dx - a.x / d * 2.0 * b.x * b.dx) / d })
        }
        8 => (g.neg(i), Dual { x: -a.x, dx: -a.dx }),
        9 => (g.powi(i, 3), Dual { x: a.x.powi(3), dx: 3.0 * a.x * a.x * a.dx }),
        10 => (g.call(F1::Sin, i), Dual { x: a.x.sin(), dx: a.x.cos() * a.dx }),
        11 => (g.call(F1::Cos, i), Dual { x: a.x.cos(), dx: -a.x.sin() * a.dx }),
        12 => (g.call(F1::Tanh, i), Dual { x: a.x.tanh(), dx: (1.0 - a.x.tanh().powi(2)) * a.dx }),
        _ => (g.call(F1::Atan, i), Dual { x: a.x.atan(), dx: a.dx / (1.0 + a.x * a.x) }),
    }
}

#[test]
fn random_expressions_and_their_derivatives_keep_their_values() {
    for seed in 0..2000 {
        let mut r = Random(seed);
        let mut g = Graph::new();
        let (id, expected) = grow(&mut g, &mut r, 6);
        let symbol = {
            let a = g.symbol("a", SymbolKind::Coordinate(0));
            g.symbol_of(a).unwrap()
        };
        let slope = g.differentiate(&[id], symbol, Derivative::Exact)[0];
        let values = g.evaluate(&[id, slope], |s| match g.symbol_info(s).kind {
            SymbolKind::Coordinate(k) => VALUES[k],
            _ => f64::NAN,
        });
        if !expected.x.is_finite() || !expected.dx.is_finite() || expected.x.abs() > 1e12 || expected.dx.abs() > 1e12 {
            continue;
        }
        // rewrites reorder sums: rounding relative to the larger of value and one
        for (value, wanted) in values.iter().zip([expected.x, expected.dx]) {
            assert!((value - wanted).abs() <= 1e-9 * wanted.abs().max(1.0), "seed {seed}: {value} instead of {wanted}");
        }
    }
}

#[test]
fn every_function_has_its_derivative() {
    let all = [
        F1::Sin,
        F1::Cos,
        F1::Tan,
        F1::Asin,
        F1::Acos,
        F1::Atan,
        F1::Sinh,
        F1::Cosh,
        F1::Tanh,
        F1::Exp,
        F1::Ln,
        F1::Sqrt,
        F1::Abs,
        F1::SmoothSign,
    ];
    let mut g = Graph::new();
    let a = g.symbol("a", SymbolKind::Coordinate(0));
    let symbol = g.symbol_of(a).unwrap();
    for f in all {
        let y = g.call(f, a);
        let slope = g.differentiate(&[y], symbol, Derivative::Exact)[0];
        for x in [0.2, 0.6] {
            let value = g.evaluate(&[slope], |_| x)[0];
            // five-point difference: error far below the tolerance for these functions and this step
            let h = 1e-3;
            let d = |k: f64| f.apply(x + k * h);
            let wanted = (d(-2.0) - 8.0 * d(-1.0) + 8.0 * d(1.0) - d(2.0)) / (12.0 * h);
            assert!((value - wanted).abs() < 1e-8 * wanted.abs().max(1.0), "{f:?} at {x}: {value} instead of {wanted}");
        }
    }
    let frozen = g.call(F1::SmoothSign, a);
    let slope = g.differentiate(&[frozen], symbol, Derivative::WithoutFrictionSlope)[0];
    assert!(g.is_zero(slope));
}

#[test]
fn functions_of_two_arguments_have_their_derivatives() {
    let mut g = Graph::new();
    let a = g.symbol("a", SymbolKind::Coordinate(0));
    let b = g.symbol("b", SymbolKind::Coordinate(1));
    let symbols = [g.symbol_of(a).unwrap(), g.symbol_of(b).unwrap()];
    for f in [F2::Atan2, F2::Min, F2::Max, F2::Pow] {
        let y = g.call2(f, a, b);
        for (x, z) in [(0.8, 0.3), (0.4, 1.7)] {
            for (k, &symbol) in symbols.iter().enumerate() {
                let slope = g.differentiate(&[y], symbol, Derivative::Exact)[0];
                let value = g.evaluate(&[slope], |s| if s == symbols[0] { x } else { z })[0];
                let h = 1e-3;
                let d = |m: f64| if k == 0 { f.apply(x + m * h, z) } else { f.apply(x, z + m * h) };
                let wanted = (d(-2.0) - 8.0 * d(-1.0) + 8.0 * d(1.0) - d(2.0)) / (12.0 * h);
                assert!((value - wanted).abs() < 1e-8 * wanted.abs().max(1.0), "{f:?} by {k}: {value} instead of {wanted}");
            }
        }
    }
}

#[test]
fn equal_expressions_are_one_node() {
    let mut g = Graph::new();
    let a = g.symbol("a", SymbolKind::Coordinate(0));
    let b = g.symbol("b", SymbolKind::Coordinate(1));
    assert_eq!(g.add(a, b), g.add(b, a));
    assert_eq!(g.mul(a, b), g.mul(b, a));
    let (s, c) = (g.sin(a), g.cos(a));
    let (ss, cc) = (g.square(s), g.square(c));
    let unit = g.add(ss, cc);
    assert_eq!(g.number_of(unit), Some(1.0));
    let minus = g.neg(a);
    assert_eq!(g.cos(minus), c);
    let zero = g.sub(a, a);
    assert!(g.is_zero(zero));
    // no division by the number zero is folded away
    let quotient = g.div(a, zero);
    assert!(!g.evaluate(&[quotient], |_| 1.0)[0].is_finite());
}
