//! CARE and DARE against SciPy on 200 random stabilizable systems each, and against 100-digit answers on benchmarks
//! from the literature; answers are kept in `oracle/riccati.json`, made by `oracle/riccati.py`.

use control::{Riccati, RiccatiData, Time, lyapunov, solve_riccati, stein};
use cross_checks::random::Random;
use nalgebra::{DMatrix, DVector};
use serde_json::Value;

struct System {
    time: Time,
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    q: DMatrix<f64>,
    r: DMatrix<f64>,
}

impl System {
    fn solve(&self) -> Result<Riccati, control::RiccatiError> {
        solve_riccati(RiccatiData { a: &self.a, b: &self.b, q: &self.q, r: &self.r, cross: None }, self.time)
    }

    /// Sum of the norms of the equation's terms at X.
    fn terms(&self, s: &Riccati) -> f64 {
        let (a, b, x) = (&self.a, &self.b, &s.x);
        match self.time {
            Time::Continuous => 2.0 * (x * a).norm() + (x * b * &s.gain).norm() + self.q.norm(),
            Time::Discrete => (a.transpose() * x * a).norm() + x.norm() + (a.transpose() * x * b * &s.gain).norm() + self.q.norm(),
        }
    }

    /// How far X may be off where the equation is off by `residual` (relative to its terms): to first order the inverse
    /// of the closed loop's Lyapunov operator, whose norm is that of its value at I.
    fn error_bound(&self, s: &Riccati, residual: f64) -> f64 {
        let closed = (&self.a - &self.b * &s.gain).transpose();
        let one = DMatrix::identity(self.a.nrows(), self.a.nrows());
        let w = match self.time {
            Time::Continuous => lyapunov(&closed, &one),
            Time::Discrete => stein(&closed, &one),
        };
        w.map_or(f64::INFINITY, |w| w.norm()) * residual * self.terms(s)
    }

    /// Residual that rounding alone leaves.
    fn rounding(&self) -> f64 {
        4.0 * self.a.nrows() as f64 * f64::EPSILON
    }
}

fn matrix(r: &mut Random, rows: usize, columns: usize, size: f64) -> DMatrix<f64> {
    let values: Vec<f64> = (0..rows * columns).map(|_| r.within(-size, size)).collect();
    DMatrix::from_row_slice(rows, columns, &values)
}

/// Stabilizable by construction: what no input reaches is stable. Same steps as `system` in `oracle/riccati.py`.
fn system(seed: u64, discrete: bool) -> System {
    let mut r = Random::new(seed);
    let n = 1 + r.below(20);
    let m = 1 + r.below(n.min(4));
    let kind = r.below(4);
    let size = r.within(0.3, 2.0);
    let mut a = matrix(&mut r, n, n, size);
    let mut b = matrix(&mut r, n, m, 1.0);
    if kind % 2 == 1 && n > 1 {
        let hidden = 1 + r.below(n / 2);
        for i in n - hidden..n {
            b.row_mut(i).fill(0.0);
            for j in 0..i {
                a[(i, j)] = 0.0;
            }
            a[(i, i)] = if discrete { r.within(-0.9, 0.9) } else { r.within(-2.0, -0.1) };
        }
    }
    let v = matrix(&mut r, n, 1, 1.0);
    let turn = DMatrix::identity(n, n) - &v * v.transpose() * (2.0 / v.norm_squared());
    a = &turn * a * &turn;
    b = &turn * b;
    if kind >= 2 {
        let d: Vec<f64> = (0..n).map(|_| r.within(-8.0, 8.0).round().exp2()).collect();
        a = DMatrix::from_fn(n, n, |i, j| a[(i, j)] * d[i] / d[j]);
        b = DMatrix::from_fn(n, m, |i, j| b[(i, j)] * d[i]);
    }
    let outputs = 1 + r.below(n);
    let c = matrix(&mut r, outputs, n, 1.0);
    let f = matrix(&mut r, m, m, 1.0);
    let time = if discrete { Time::Discrete } else { Time::Continuous };
    System { time, a, b, q: c.transpose() * c, r: &f * f.transpose() + DMatrix::identity(m, m) * 0.1 }
}

fn direction(n: usize) -> DVector<f64> {
    DVector::from_fn(n, |i, _| (((7 * i) % 11) as f64 - 5.0) / 5.0)
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().map(|list| list.iter().filter_map(Value::as_f64).collect()).unwrap_or_default()
}

fn rows(value: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = value.as_array().map(|list| list.iter().map(numbers).collect()).unwrap_or_default();
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

fn oracle() -> Value {
    serde_json::from_str(include_str!("../oracle/riccati.json")).unwrap_or_else(|e| panic!("riccati.json: {e}"))
}

#[test]
fn random_stabilizable_systems_agree_with_scipy() {
    let oracle = oracle();
    let cases = oracle["random"].as_array().map_or(&[][..], Vec::as_slice);
    assert_eq!(cases.len(), 400);
    let (mut worst, mut better, mut compared, mut refused) = (0.0_f64, 0, 0, Vec::new());
    for case in cases {
        let (seed, discrete) = (case["seed"].as_u64().unwrap_or(0), case["discrete"] == true);
        let system = system(seed, discrete);
        assert_eq!((case["n"].as_u64(), case["m"].as_u64()), (Some(system.a.nrows() as u64), Some(system.b.ncols() as u64)), "seed {seed}");
        let s = match system.solve() {
            Ok(s) => s,
            Err(e) => {
                // an answer is refused only where SciPy's does not satisfy the equation either, and the mode is named
                assert!(!(case["scipy"]["residual"].as_f64().is_some_and(|r| r <= 1e-9)), "seed {seed} {:?}: {e}", system.time);
                assert!(e.to_string().contains("the mode at "), "{e}");
                refused.push(format!("seed {seed} {:?}: {e}", system.time));
                continue;
            }
        };
        assert!(s.residual <= 1e-9, "seed {seed} {:?}: {}", system.time, s.residual);
        assert!(system.time.stable(&s.poles), "seed {seed}");
        worst = worst.max(s.residual);
        let Some(scipy) = case["scipy"]["residual"].as_f64() else { continue };
        compared += 1;
        better += usize::from(s.residual <= scipy.max(system.rounding()));
        let difference = (&s.x * direction(system.a.nrows()) - DVector::from_vec(numbers(&case["scipy"]["xw"]))).norm();
        let bound = system.error_bound(&s, s.residual + scipy + system.rounding());
        assert!(
            difference <= bound * direction(system.a.nrows()).norm() + 1e-12 * s.x.norm(),
            "seed {seed} {:?}: {difference:.2e} > {bound:.2e}",
            system.time
        );
    }
    println!(
        "400 random equations: largest relative residual {worst:.1e}, {} refused; residual at or below SciPy's (or rounding) in {better} of {compared}",
        refused.len()
    );
    for line in &refused {
        println!("  {line}");
    }
    assert!(refused.len() <= 4, "{refused:#?}");
}

#[test]
fn benchmarks_from_the_literature_agree_with_100_digits() {
    let oracle = oracle();
    println!("{:20} {:>10} {:>10} {:>10}   (SciPy: residual, error)", "", "residual", "error", "bound");
    let mut refused = Vec::new();
    for case in oracle["benchmarks"].as_array().map_or(&[][..], Vec::as_slice) {
        let time = if case["discrete"] == true { Time::Discrete } else { Time::Continuous };
        let system = System { time, a: rows(&case["a"]), b: rows(&case["b"]), q: rows(&case["q"]), r: rows(&case["r"]) };
        let name = case["name"].as_str().unwrap_or("");
        let scipy = |key: &str| case["scipy"][key].as_f64().map_or_else(|| "failed".to_owned(), |v| format!("{v:.1e}"));
        match system.solve() {
            Ok(s) => {
                let truth = rows(&case["x"]);
                let error = (&s.x - &truth).norm() / truth.norm();
                let bound = system.error_bound(&s, s.residual + system.rounding()) / truth.norm();
                println!("{name:20} {:10.1e} {error:10.1e} {bound:10.1e}   ({}, {})", s.residual, scipy("residual"), scipy("error"));
                assert!(s.residual <= 1e-9 && time.stable(&s.poles), "{name}");
                assert!(error <= bound + 1e-12, "{name}: {error:.2e} > {bound:.2e}");
            }
            Err(e) => {
                refused.push(name.to_owned());
                println!("{name:20} {e}   ({}, {})", scipy("residual"), scipy("error"));
            }
        }
    }
    // its closed loop has poles within 1e-12 of the imaginary axis: four digits of X are all there is in double precision
    assert_eq!(refused, ["carex 2.8 1e-06"]);
}
