//! Properties of whole random rigs: the two roads agree, energy balances (both inside `derive`), M is symmetric and
//! positive definite, M' - 2C is skew (as power), forward and inverse dynamics undo each other, the regressor
//! gives inverse dynamics back, and Jacobians agree with differences.

use codegen::expr::{Graph, SymbolId, SymbolKind};
use codegen::{CrossCheck, Equations, Lumps, Options, derive, regressor};
use cross_checks::close::relative;
use cross_checks::random::Random;
use cross_checks::random_rig::random_rig;

struct Point {
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    u: Vec<f64>,
    p: Vec<f64>,
}

impl Point {
    fn new(r: &mut Random, e: &Equations) -> Self {
        let n = e.layout.q.len();
        let mut list = |n: usize| (0..n).map(|_| r.within(-1.0, 1.0)).collect::<Vec<_>>();
        Self { q: list(n), v: list(n), a: list(n), u: list(e.layout.u.len()), p: e.layout.nominal.clone() }
    }

    fn value(&self, g: &Graph, s: SymbolId) -> f64 {
        match g.symbol_info(s).kind {
            SymbolKind::Coordinate(i) => self.q[i],
            SymbolKind::Rate(i) => self.v[i],
            SymbolKind::Acceleration(i) => self.a[i],
            SymbolKind::Signal(i) => self.u[i],
            SymbolKind::Parameter(i) => self.p[i],
            _ => 0.0,
        }
    }
}

#[test]
fn random_rigs_keep_the_laws_of_mechanics() {
    for seed in 0..60 {
        let n = 1 + (seed as usize % 6);
        let text = random_rig(seed, n);
        let checked = model_dsl::check_text("random.rig", &text);
        let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
        let rig = checked.rig.unwrap_or_else(|| panic!("seed {seed}:\n{text}\n{}", shown.join("\n")));
        let e = derive(&rig, Options::default()).unwrap_or_else(|error| panic!("seed {seed}: {error}\n{text}"));
        let CrossCheck::Agree { derivations, energy } = e.cross_check else { panic!("seed {seed}: no second road") };
        assert!(derivations < 1e-12 && energy < 1e-12, "seed {seed}: roads {derivations:e}, energy {energy:e}");
        let mut r = Random::new(seed + 1000);
        let point = Point::new(&mut r, &e);
        let g = &e.graph;
        let at = |s: SymbolId| point.value(g, s);

        // symmetric, positive definite
        let m = g.evaluate(&e.mass_matrix.concat(), at);
        for i in 0..n {
            for j in 0..n {
                assert!(
                    (m[i * n + j] - m[j * n + i]).abs() <= 1e-13 * m[i * n + i].abs().max(m[j * n + j].abs()),
                    "seed {seed}: M not symmetric"
                );
            }
        }
        assert!(g.evaluate(&e.pivots, at).iter().all(|&d| d > 0.0), "seed {seed}: M not positive definite");

        // forward, then inverse dynamics: no residual is left
        let a = g.evaluate(&e.acceleration, at);
        let left = g.evaluate(&e.inverse_dynamics, |s| match g.symbol_info(s).kind {
            SymbolKind::Acceleration(i) => a[i],
            _ => point.value(g, s),
        });
        let size = g.evaluate(&e.bias, at).iter().chain(&g.evaluate(&e.force, at)).fold(1.0_f64, |m, x| m.max(x.abs()));
        assert!(left.iter().all(|x| x.abs() <= 1e-9 * size), "seed {seed}: {left:?}");

        // the regressor gives inverse dynamics back
        let y = regressor(&rig, Lumps::AsParameters).expect("a rig of bodies");
        let full = g.evaluate(&e.inverse_dynamics, at);
        let mut sum = y.graph.evaluate(&y.rest, |s| point.value(&y.graph, s));
        for column in &y.columns {
            let pi = y.graph.evaluate(&[column.value], |s| point.value(&y.graph, s))[0];
            for (total, entry) in sum.iter_mut().zip(y.graph.evaluate(&column.entries, |s| point.value(&y.graph, s))) {
                *total += pi * entry;
            }
        }
        assert!(relative(&sum, &full, 1.0) < 1e-10, "seed {seed}: the regressor gives {sum:?}, inverse dynamics {full:?}");

        // power of the velocity products: v.(M'v/2 - c) = 0
        let c = g.evaluate(e.coriolis.as_ref().expect("a rig of bodies"), at);
        let h = 1e-5;
        let shifted = |k: f64| {
            g.evaluate(&e.mass_matrix.concat(), |s| match g.symbol_info(s).kind {
                SymbolKind::Coordinate(i) => point.q[i] + k * h * point.v[i],
                _ => point.value(g, s),
            })
        };
        let (minus, plus) = (shifted(-1.0), shifted(1.0));
        let mut power = 0.0;
        let mut terms = 1e-3;
        for i in 0..n {
            power -= point.v[i] * c[i];
            terms += (point.v[i] * c[i]).abs();
            for j in 0..n {
                power += 0.5 * point.v[i] * point.v[j] * (plus[i * n + j] - minus[i * n + j]) / (2.0 * h);
            }
        }
        // the difference quotient carries about h^2 of error
        assert!(power.abs() < 1e-7 * terms.max(1.0), "seed {seed}: power {power:e} of {terms:e}");

        // A against central differences, five points
        let states = e.layout.states();
        let analytic = g.evaluate(&e.linear.a.concat(), at);
        for k in 0..states {
            let h = 1e-3;
            let moved = |m: f64| {
                g.evaluate(&e.state_derivative(), |s| match g.symbol_info(s).kind {
                    SymbolKind::Coordinate(i) if i == k => point.q[i] + m * h,
                    SymbolKind::Rate(i) if n + i == k => point.v[i] + m * h,
                    _ => point.value(g, s),
                })
            };
            let (a, b, c, d) = (moved(-2.0), moved(-1.0), moved(1.0), moved(2.0));
            for i in 0..states {
                let wanted = (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h);
                let value = analytic[i * states + k];
                let scale = c[i].abs().max(wanted.abs()).max(1.0);
                // fifth derivatives of stiff random rigs grow with the rates of the rig: 1e-5 is far below any wrong term
                assert!((value - wanted).abs() < 1e-5 * scale, "seed {seed}: A[{i},{k}] = {value}, by differences {wanted}");
            }
        }
    }
}
