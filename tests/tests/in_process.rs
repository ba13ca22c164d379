//! The in-process model against plain evaluation of the graph: every quantity of the model trait, compiled and
//! interpreted, for all example rigs and for random rigs; several threads at once; a singular mass matrix.

use codegen::expr::{Id, SymbolKind};
use codegen::{Equations, Options, derive};
use cross_checks::close::relative;
use cross_checks::random::Random;
use cross_checks::random_rig::random_rig;
use cross_checks::{example_rigs, rig_of};
use jit::{Evaluation, InProcess};
use model_dsl::rig::Rig;
use runtime::{Model, Singular};

/// Rounding of another order of the same operations, and of another library's sine.
const TOLERANCE: f64 = 1e-13;

struct Point {
    t: f64,
    x: Vec<f64>,
    u: Vec<f64>,
    p: Vec<f64>,
}

impl Point {
    fn new(r: &mut Random, e: &Equations) -> Self {
        let mut list = |n: usize| (0..n).map(|_| r.within(-0.8, 0.8)).collect::<Vec<_>>();
        let (x, u) = (list(e.layout.states()), list(e.layout.u.len()));
        let p = e.layout.nominal.iter().map(|v| v * r.within(0.9, 1.1)).collect();
        Self { t: 0.3, x, u, p }
    }

    fn evaluate(&self, e: &Equations, roots: &[Id]) -> Vec<f64> {
        let n = e.layout.q.len();
        e.graph.evaluate(roots, |s| match e.graph.symbol_info(s).kind {
            SymbolKind::Time => self.t,
            SymbolKind::Coordinate(i) => self.x[i],
            SymbolKind::Rate(i) => self.x[n + i],
            SymbolKind::Lag(i) => self.x[2 * n + i],
            SymbolKind::Signal(i) => self.u[i],
            SymbolKind::Parameter(i) => self.p[i],
            _ => f64::NAN,
        })
    }
}

/// All quantities of a model at a point.
#[derive(Debug, PartialEq)]
struct Quantities {
    lists: Vec<(&'static str, Vec<f64>)>,
}

fn quantities(model: &InProcess, at: &Point) -> Quantities {
    let d = model.dimensions();
    let (n, m, k, o) = (d.states(), d.signals(), d.parameters, d.outputs);
    let list = |length: usize| vec![f64::NAN; length];
    let (mut dx, mut dx2, mut dx3, mut a, mut a2, mut b, mut b2) =
        (list(n), list(n), list(n), list(n * n), list(n * n), list(n * m), list(n * m));
    let (mut dfdp, mut y, mut c, mut dhdp) = (list(n * k), list(o), list(o * n), list(o * k));
    let Point { t, x, u, p } = at;
    model.rhs(*t, x, u, p, &mut dx).expect("a regular point");
    model.linearize(*t, x, u, p, &mut dx2, &mut a, &mut b).expect("a regular point");
    model.linearize_without_friction_slope(*t, x, u, p, &mut dx3, &mut a2, &mut b2).expect("a regular point");
    model.parameter_jacobian(*t, x, u, p, &mut dfdp).expect("a regular point");
    model.outputs(*t, x, p, &mut y);
    model.output_jacobian(*t, x, p, &mut c, &mut dhdp);
    Quantities {
        lists: vec![
            ("x'", dx),
            ("x' with A, B", dx2),
            ("x' with A, B without slope", dx3),
            ("A", a),
            ("B", b),
            ("A without slope", a2),
            ("B without slope", b2),
            ("dx'/dp", dfdp),
            ("y", y),
            ("C", c),
            ("dy/dp", dhdp),
        ],
    }
}

fn wanted(e: &Equations, at: &Point) -> Vec<Vec<f64>> {
    let slope = e.linear_without_friction_slope.as_ref().unwrap_or(&e.linear);
    let dx = e.state_derivative();
    let all: [&[Id]; 11] = [
        &dx,
        &dx,
        &dx,
        &e.linear.a.concat(),
        &e.linear.b.concat(),
        &slope.a.concat(),
        &slope.b.concat(),
        &e.parameter_jacobian.concat(),
        &e.outputs,
        &e.output_jacobian.concat(),
        &e.output_parameter_jacobian.concat(),
    ];
    all.iter().map(|roots| at.evaluate(e, roots)).collect()
}

fn check(name: &str, rig: &Rig, seed: u64) {
    let equations = || derive(rig, Options::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
    let e = equations();
    let models = [InProcess::evaluated(equations(), Evaluation::Compiled), InProcess::evaluated(equations(), Evaluation::Interpreted)];
    let mut r = Random::new(seed);
    for _ in 0..3 {
        let at = Point::new(&mut r, &e);
        let wanted = wanted(&e, &at);
        for (model, how) in models.iter().zip(["compiled", "interpreted"]) {
            for ((what, values), wanted) in quantities(model, &at).lists.iter().zip(&wanted) {
                let difference = relative(values, wanted, f64::MIN_POSITIVE);
                assert!(difference < TOLERANCE, "{name}, {how}: {what} off by {difference:e}");
            }
            assert!(model.interpreted_because().is_none(), "{name}: this machine should be given code");
        }
    }
}

#[test]
fn example_rigs_agree_with_the_graph() {
    for path in example_rigs() {
        check(&path.display().to_string(), &rig_of(&path), 1);
    }
}

fn rig_of_text(text: &str) -> Rig {
    let checked = model_dsl::check_text("test.rig", text);
    let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    checked.rig.unwrap_or_else(|| panic!("{text}\n{}", shown.join("\n")))
}

#[test]
fn random_rigs_agree_with_the_graph() {
    // the last ones are large enough for code in many parts
    for (seed, n) in (0..30).map(|seed| (seed, 1 + seed as usize % 6)).chain([(900, 10), (901, 14)]) {
        check(&format!("seed {seed}"), &rig_of_text(&random_rig(seed, n)), seed);
    }
}

/// Every function of the language, with both signs of its argument where it has them.
const FUNCTIONS: &str = "rig Functions {
    param k: N*m = 1;
    param n: 1 = 1.7;
    coord a: rad; coord b: rad;
    frame f = ground.rotate(x, a); frame g = ground.rotate(y, b);
    body d on f { mass 1 kg; inertia diag(1, 1, 1); }
    body e on g { mass 1 kg; inertia diag(1, 1, 1); }
    torque t1 on a: k * (sin(b) + cos(b) + sin(2*a) + cos(3*b) + tan(a) + asin(a/2) + acos(b/2) + atan(3*a) + atan2(a, b));
    torque t2 on b: k * (sinh(a) + cosh(b) + tanh(a) + exp(b) + ln(2 + a) + sqrt(2 + b) + abs(a) + sign(b) + (2 + a)^n + b^3 + (2 + a)^(-3));
    torque t3 on a: k * (min(a, b) + max(a, b) + saturate(a, -0.2, 0.3) + dead_zone(b, 0.1) + a^5);
    friction b { viscous 0.1; coulomb 0.2 width 0.01; }
}";

#[test]
fn every_function_is_compiled_rightly() {
    check("functions", &rig_of_text(FUNCTIONS), 5);
}

#[test]
fn a_model_turns_from_interpreted_to_compiled_without_being_felt() {
    let rig = rig_of_text(&random_rig(7, 4));
    let e = derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let at = Point::new(&mut Random::new(7), &e);
    let wanted = at.evaluate(&e, &e.state_derivative());
    let model = InProcess::new(e);
    let mut dx = vec![0.0; wanted.len()];
    for _ in 0..3000 {
        model.rhs(at.t, &at.x, &at.u, &at.p, &mut dx).expect("a regular point");
        assert!(relative(&dx, &wanted, f64::MIN_POSITIVE) < TOLERANCE);
    }
}

#[test]
fn threads_may_call_at_once() {
    let rig = rig_of_text(&random_rig(11, 5));
    let equations = || derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let e = equations();
    // both the turn to machine code and the first compilation happen while others call
    for evaluation in [Evaluation::Adaptive, Evaluation::Compiled] {
        let model = InProcess::evaluated(equations(), evaluation);
        std::thread::scope(|scope| {
            for seed in 0..4 {
                let (model, e) = (&model, &e);
                scope.spawn(move || {
                    let mut r = Random::new(seed);
                    for _ in 0..50 {
                        let at = Point::new(&mut r, e);
                        let wanted = at.evaluate(e, &e.state_derivative());
                        let mut dx = vec![0.0; wanted.len()];
                        for _ in 0..20 {
                            model.rhs(at.t, &at.x, &at.u, &at.p, &mut dx).expect("a regular point");
                            assert!(relative(&dx, &wanted, f64::MIN_POSITIVE) < TOLERANCE);
                        }
                    }
                });
            }
        });
    }
}

#[test]
fn a_singular_mass_matrix_names_its_coordinate() {
    // the second joint's inertia vanishes with its parameter
    let rig = rig_of_text(
        "rig Singular { param I: kg*m^2 = 1; coord a: rad; coord b: rad; frame f = ground.rotate(x, a); frame g = f.rotate(y, b);
         body d on f { mass 1 kg; inertia diag(1, 1, 1); } body e on g { mass 1 kg; inertia diag(I, I, I); } }",
    );
    for evaluation in [Evaluation::Compiled, Evaluation::Interpreted] {
        let model = InProcess::evaluated(derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{error}")), evaluation);
        let mut dx = [0.0; 4];
        assert_eq!(model.rhs(0.0, &[0.1, 0.2, 0.3, 0.4], &[], &[1.0], &mut dx), Ok(()));
        for value in [0.0, f64::NAN] {
            assert!(matches!(model.rhs(0.0, &[0.1, 0.2, 0.3, 0.4], &[], &[value], &mut dx), Err(Singular { coordinate: 0 | 1 })));
        }
        assert_eq!(model.rhs(0.0, &[0.1, 0.2, 0.3, 0.4], &[], &[0.0], &mut dx), Err(Singular { coordinate: 1 }));
    }
}

#[test]
fn sines_of_all_sizes_of_angles_keep_their_digits() {
    let rig = rig_of_text(
        "rig Angles { coord a: rad; frame f = ground.rotate(x, a); body b on f { mass 1 kg; inertia diag(1, 1, 1); }
         output s: 1 = sin(a); output c: 1 = cos(a); }",
    );
    let model = InProcess::evaluated(derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{error}")), Evaluation::Compiled);
    let mut r = Random::new(1);
    let mut angles = vec![0.0, -0.0, 1e-300, f64::MIN_POSITIVE, 1e6, -1e6, 1.1e6, 1e15, -1e300];
    for _ in 0..20_000 {
        let size = 10.0_f64.powf(r.within(-12.0, 7.0));
        angles.push(size * r.within(-1.0, 1.0));
        // the numbers nearest to multiples of a quarter turn, where digits cancel
        angles.push((r.below(600_000) as f64 - 300_000.0) * std::f64::consts::FRAC_PI_2);
    }
    for angle in angles {
        let mut y = [0.0; 2];
        model.outputs(0.0, &[angle, 0.0], &[], &mut y);
        for (value, wanted) in y.into_iter().zip([angle.sin(), angle.cos()]) {
            // three units in the last place: two of ours, one of the library's
            assert!((value - wanted).abs() <= 3.0 * f64::EPSILON * wanted.abs(), "angle {angle:e}: {value:e} instead of {wanted:e}");
        }
    }
    for angle in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut y = [0.0; 2];
        model.outputs(0.0, &[angle, 0.0], &[], &mut y);
        assert!(y.iter().all(|v| v.is_nan()));
    }
}
