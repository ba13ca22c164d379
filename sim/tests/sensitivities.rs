//! Fixed steps: order 4, agreement with adaptive runs, derivatives against differences.

mod models;

use models::{Hand, Linear, Pendulum, Wall};
use sim::sensitivity::{Sensitivities, simulate_fixed};
use sim::{Hold, Options, Signal, Signals, Status, simulate};

const P: [f64; 3] = [9.81, 0.2, 1.3];
const X0: [f64; 2] = [1.2, -0.4];

fn signals() -> Signals {
    // a switch that is no multiple of any step
    Signals::new(vec![Signal { t: vec![0.0, 0.777_77], values: vec![2.0, -1.0], hold: Hold::Zero }]).unwrap()
}

fn times() -> Vec<f64> {
    (0..=40).map(|k| f64::from(k) * 0.05).collect()
}

fn fixed(p: &[f64], x0: &[f64], step: f64) -> Sensitivities {
    simulate_fixed(&Hand(Pendulum), p, x0, &signals(), &times(), step, &[0, 1, 2]).unwrap()
}

#[test]
fn order_is_four() {
    let exact =
        simulate(&Hand(Pendulum), &P, &X0, &signals(), &times(), &Options { relative: 1e-13, absolute: 1e-14, ..Options::default() })
            .unwrap();
    let error = |step: f64| fixed(&P, &X0, step).x.iter().zip(&exact.x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let errors = [0.05, 0.025, 0.0125].map(error);
    // halving the step divides the error by 16, up to the next order
    for pair in errors.windows(2) {
        assert!((14.0..18.5).contains(&(pair[0] / pair[1])), "{errors:?}");
    }
    assert!(errors[2] < 1e-6, "{errors:?}");
}

#[test]
fn derivatives_are_those_of_the_computed_states() {
    let s = fixed(&P, &X0, 0.02);
    let rows = s.t.len();
    // central differences of the same computation: error h^2 f'''/6 + rounding/h, about 1e-9 here
    let h = 1e-5;
    let difference =
        |plus: &Sensitivities, minus: &Sensitivities| plus.x.iter().zip(&minus.x).map(|(a, b)| (a - b) / (2.0 * h)).collect::<Vec<f64>>();
    for j in 0..2 {
        let moved = |by: f64| {
            let mut x0 = X0;
            x0[j] += by;
            fixed(&P, &x0, 0.02)
        };
        let wanted = difference(&moved(h), &moved(-h));
        for k in 0..rows {
            for i in 0..2 {
                let found = s.by_initial[k * 4 + i * 2 + j];
                assert!((found - wanted[k * 2 + i]).abs() < 1e-7, "x{i} by x0_{j} at {k}: {found} {}", wanted[k * 2 + i]);
            }
        }
    }
    for j in 0..3 {
        let moved = |by: f64| {
            let mut p = P;
            p[j] += by;
            fixed(&p, &X0, 0.02)
        };
        let wanted = difference(&moved(h), &moved(-h));
        for k in 0..rows {
            for i in 0..2 {
                let found = s.by_parameters[k * 6 + i * 3 + j];
                assert!((found - wanted[k * 2 + i]).abs() < 1e-7, "x{i} by p{j} at {k}: {found} {}", wanted[k * 2 + i]);
            }
        }
    }
}

#[test]
fn only_the_free_parameters_have_columns() {
    let p = [3.0, 0.2, 0.1];
    let all = simulate_fixed(&Hand(Linear), &p, &[0.1, 0.2, 0.3], &signals(), &times(), 0.01, &[0, 1, 2]).unwrap();
    let some = simulate_fixed(&Hand(Linear), &p, &[0.1, 0.2, 0.3], &signals(), &times(), 0.01, &[2, 0]).unwrap();
    let none = simulate_fixed(&Hand(Linear), &p, &[0.1, 0.2, 0.3], &signals(), &times(), 0.01, &[]).unwrap();
    assert_eq!((none.by_parameters.len(), none.x == all.x, none.by_initial == all.by_initial), (0, true, true));
    for (all, some) in all.by_parameters.chunks(3).zip(some.by_parameters.chunks(2)) {
        assert_eq!(some, [all[2], all[0]]);
    }
}

#[test]
fn ends_and_arguments() {
    let run = |step: f64, free: &[usize]| {
        simulate_fixed(&Hand(Wall), &[0.8], &[0.0, 0.0], &Signals::constant(&[0.0]).unwrap(), &[0.0, 1.0, 2.0], step, free)
    };
    let out = run(0.01, &[]).unwrap();
    assert!(matches!(out.status, Status::Singular { .. }), "{:?}", out.status);
    assert_eq!(out.t, [0.0, 1.0]);
    assert!((out.valid_until - 1.25).abs() < 0.011, "{}", out.valid_until);
    assert_eq!(run(0.0, &[]).unwrap_err().to_string(), "the step must be a positive number, not 0");
    assert_eq!(run(0.1, &[7]).unwrap_err().to_string(), "8 parameters were given, the model has 1");
}
