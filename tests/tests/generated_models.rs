//! The checked-in models: fresh, equal to the graph's own evaluation, and with right derivatives.

use codegen::emit::functions;
use codegen::{Equations, Options, derive};
use cross_checks::close::relative;
use cross_checks::named::named;
use cross_checks::random::Random;
use cross_checks::states::Point;
use cross_checks::{example_rigs, rig_of, root};
use runtime::Model;

/// Rounding: a few hundred operations of 1.1e-16 each, and sums that cancel by a digit or so.
const TOLERANCE: f64 = 1e-13;

fn rigs() -> Vec<(String, Equations)> {
    let derived = example_rigs().into_iter().map(|path| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let e = derive(&rig_of(&path), Options::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
        (name, e)
    });
    derived.collect()
}

fn model_of(name: &str) -> &'static dyn Model {
    generated::MODELS
        .iter()
        .find(|m| m.0 == name)
        .map(|m| m.1)
        .unwrap_or_else(|| panic!("no generated model of {name}; run `cargo xtask gen`"))
}

/// The coordinate of the first pivot that is not positive.
fn singular_at(e: &Equations, point: &Point) -> Option<usize> {
    let pivots = e.graph.evaluate(&e.pivots, |s| point.value(e, s));
    e.free.iter().zip(pivots).find(|(_, d)| d.is_nan() || *d <= 0.0).map(|(&i, _)| i)
}

#[test]
fn checked_in_files_are_what_their_rigs_say() {
    for (name, e) in rigs() {
        let source = format!("{name}.rig");
        let c = codegen::emit::c(&e, &source);
        let wanted = [
            (format!("src/{name}.rs"), codegen::emit::rust(&e, &source)),
            (format!("c/{}", c.header_name), c.header),
            (format!("c/{}", c.source_name), c.source),
        ];
        for (file, text) in wanted {
            let found = std::fs::read_to_string(root().join("generated").join(&file)).unwrap_or_default();
            assert!(found == text, "generated/{file} is stale; run `cargo xtask gen`");
            assert!(text.lines().take(8).any(|line| line.contains("Generated from `")), "{file}: the header is missing");
            let long = text.lines().find(|line| line.chars().count() > 140);
            assert!(long.is_none(), "{file}: longer than 140 columns: {long:?}");
        }
    }
    let models: Vec<&str> = generated::MODELS.iter().map(|m| m.0).collect();
    let names: Vec<String> = rigs().into_iter().map(|r| r.0).collect();
    assert_eq!(models, names, "generated/src/lib.rs is stale; run `cargo xtask gen`");
}

#[test]
fn every_named_function_agrees_with_the_graph() {
    for (name, e) in rigs() {
        let mut random = Random::new(17);
        let mut worst = 0.0_f64;
        for _ in 0..20 {
            let point = Point::random(&e, &mut random);
            let singular = singular_at(&e, &point);
            let called = named(&name, &point.arguments()).unwrap_or_else(|| panic!("no calls of {name}; run `cargo xtask gen`"));
            let wanted = functions(&e);
            assert_eq!(called.len(), wanted.len(), "{name}: tests/src/named.rs is stale; run `cargo xtask gen`");
            for (function, (called_name, results)) in wanted.iter().zip(called) {
                assert_eq!(function.name, called_name);
                let results = match (results, singular.filter(|_| function.pivots.is_some())) {
                    (Ok(results), None) => results,
                    (Err(error), Some(coordinate)) => {
                        assert_eq!(error.coordinate, coordinate, "{name}::{called_name}");
                        continue;
                    }
                    (got, expected) => panic!("{name}::{called_name}: {got:?}, but the graph says singular at {expected:?}"),
                };
                for (output, result) in function.outputs.iter().zip(results) {
                    let graph = e.graph.evaluate(&output.roots, |s| point.value(&e, s));
                    let difference = relative(&result, &graph, f64::MIN_POSITIVE);
                    assert!(difference < TOLERANCE, "{name}::{called_name} {}: {difference:.1e}\n{result:?}\n{graph:?}", output.name);
                    worst = worst.max(difference);
                }
            }
        }
        println!("{name:20} largest relative difference of any function {worst:.1e}");
    }
}

#[test]
fn through_the_trait_it_is_the_in_process_model() {
    for (name, e) in rigs() {
        let model = model_of(&name);
        let mut random = Random::new(5);
        let points: Vec<Point> = (0..10).map(|_| Point::random(&e, &mut random)).collect();
        let other = jit::InProcess::new(e);
        let sizes = model.dimensions();
        assert_eq!(sizes, other.dimensions(), "{name}");
        let (n, m, np, ny) = (sizes.states(), sizes.signals(), sizes.parameters, sizes.outputs);
        let (left, right) = (model.names(), other.names());
        assert_eq!(left.rig(), right.rig());
        assert!((0..n).all(|i| left.state(i) == right.state(i)) && (0..m).all(|i| left.signal(i) == right.signal(i)), "{name}: names");
        assert!((0..np).all(|i| left.parameter(i) == right.parameter(i)), "{name}: names of parameters");
        assert!((0..ny).all(|i| left.output(i) == right.output(i) && left.output_unit(i) == right.output_unit(i)), "{name}: outputs");
        let nominal = |model: &dyn Model| {
            let mut p = vec![0.0; np];
            model.nominal(&mut p);
            p
        };
        assert_eq!(nominal(model), nominal(&other), "{name}");
        for point in points {
            let (t, x, u, p) = (point.t, &point.x, &point.u, &point.p);
            let run = |model: &dyn Model| {
                let (mut dx, mut dx_too, mut a, mut b) = (vec![0.0; n], vec![0.0; n], vec![0.0; n * n], vec![0.0; n * m]);
                let (mut by_p, mut y, mut c, mut dhdp) = (vec![0.0; n * np], vec![0.0; ny], vec![0.0; ny * n], vec![0.0; ny * np]);
                let status = [
                    model.rhs(t, x, u, p, &mut dx),
                    model.linearize(t, x, u, p, &mut dx_too, &mut a, &mut b),
                    model.parameter_jacobian(t, x, u, p, &mut by_p),
                ];
                model.outputs(t, x, p, &mut y);
                model.output_jacobian(t, x, p, &mut c, &mut dhdp);
                (status, [dx, dx_too, a, b, by_p, y, c, dhdp])
            };
            let ((status, values), (wanted_status, wanted)) = (run(model), run(&other));
            assert_eq!(status, wanted_status, "{name}");
            let after = if status[0].is_ok() { 0 } else { 5 };
            for k in after..values.len() {
                let difference = relative(&values[k], &wanted[k], f64::MIN_POSITIVE);
                assert!(difference < TOLERANCE, "{name}, result {k}: {difference:.1e}");
            }
            for i in 0..m {
                assert_eq!(model.input_path(i, p), other.input_path(i, p), "{name}, input {i}");
            }
            for i in 0..ny {
                assert_eq!(model.output_path(i, p), other.output_path(i, p), "{name}, output {i}");
            }
        }
    }
}

/// d f / d x_i by central differences at steps h, h/2 and h/4, extrapolated twice (Richardson): error O(h^6).
fn slope(f: &dyn Fn(f64) -> Option<Vec<f64>>, h: f64) -> Option<Vec<f64>> {
    let central = |h: f64| Some(f(h)?.into_iter().zip(f(-h)?).map(|(a, b)| (a - b) / (2.0 * h)).collect::<Vec<f64>>());
    let better =
        |fine: Vec<f64>, coarse: Vec<f64>, k: f64| fine.into_iter().zip(coarse).map(|(f, c)| (k * f - c) / (k - 1.0)).collect::<Vec<f64>>();
    let (one, half, quarter) = (central(h)?, central(h / 2.0)?, central(h / 4.0)?);
    Some(better(better(quarter, half.clone(), 4.0), better(half, one, 4.0), 16.0))
}

#[test]
fn derivatives_are_those_of_the_emitted_functions() {
    for (name, e) in rigs() {
        let model = model_of(&name);
        let sizes = model.dimensions();
        let (n, m, np, ny) = (sizes.states(), sizes.signals(), sizes.parameters, sizes.outputs);
        let mut random = Random::new(23);
        for _ in 0..5 {
            let point = Point::random(&e, &mut random);
            if singular_at(&e, &point).is_some() {
                continue;
            }
            let (t, x, u, p) = (point.t, &point.x, &point.u, &point.p);
            let (mut dx, mut a, mut b, mut by_p) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * m], vec![0.0; n * np]);
            let (mut c, mut dhdp) = (vec![0.0; ny * n], vec![0.0; ny * np]);
            assert!(model.linearize(t, x, u, p, &mut dx, &mut a, &mut b).is_ok());
            assert!(model.parameter_jacobian(t, x, u, p, &mut by_p).is_ok());
            model.output_jacobian(t, x, p, &mut c, &mut dhdp);
            // all arguments in one vector, all results in one vector
            let arguments: Vec<f64> = x.iter().chain(u).chain(p).copied().collect();
            let values = |w: &[f64]| {
                let (x, u, p) = (&w[..n], &w[n..n + m], &w[n + m..]);
                let mut result = vec![0.0; n + ny];
                let (dx, y) = result.split_at_mut(n);
                model.rhs(t, x, u, p, dx).ok()?;
                model.outputs(t, x, p, y);
                Some(result)
            };
            for j in 0..arguments.len() {
                let h = 1e-3 * arguments[j].abs().max(if j < n + m { 1.0 } else { 1e-9 });
                let along = |h: f64| {
                    let mut w = arguments.clone();
                    w[j] += h;
                    values(&w)
                };
                let Some(numeric) = slope(&along, h) else { continue };
                let column = |matrix: &[f64], rows: usize, columns: usize, j: usize| {
                    (0..rows).map(|i| matrix[i * columns + j]).collect::<Vec<f64>>()
                };
                let exact: Vec<f64> = if j < n {
                    [column(&a, n, n, j), column(&c, ny, n, j)].concat()
                } else if j < n + m {
                    [column(&b, n, m, j - n), vec![0.0; ny]].concat()
                } else {
                    [column(&by_p, n, np, j - n - m), column(&dhdp, ny, np, j - n - m)].concat()
                };
                // truncation about h^6 = 1e-18 of the seventh derivative (friction's is large); the function's own rounding, some
                // tens of eps |f|, comes out divided by the smallest step
                let size = along(0.0).map_or(0.0, |f| f.iter().fold(0.0_f64, |m, x| m.max(x.abs())));
                let rounding = 30.0 * f64::EPSILON * size / (h / 4.0);
                let allowed = 1e-7 * exact.iter().fold(0.0_f64, |m, x| m.max(x.abs())) + rounding;
                let worst = numeric
                    .iter()
                    .zip(&exact)
                    .map(|(a, b)| (a - b).abs())
                    .fold(0.0_f64, |m, d| if d.is_nan() { f64::INFINITY } else { m.max(d) });
                assert!(worst <= allowed, "{name}, column {j}: {worst:.1e} where {allowed:.1e} is allowed\n{numeric:?}\n{exact:?}");
            }
        }
    }
}
