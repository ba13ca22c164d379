//! Fixed steps: orders, agreement with adaptive runs, derivatives against differences, ways to end.

mod models;

use models::{Hand, Linear, Misread, Pendulum, Played, Wall};
use runtime::Model;
use sim::{FixedMethod, Forward, Hold, Options, Pattern, Signal, Signals, Status, simulate};

const P: [f64; 3] = [9.81, 0.2, 1.3];
const X0: [f64; 2] = [1.2, -0.4];

fn signals() -> Signals {
    // a switch that is no multiple of any step
    Signals::new(vec![Signal { t: vec![0.0, 0.777_77], values: vec![2.0, -1.0], hold: Hold::Zero }]).unwrap()
}

/// More often than any step.
fn times() -> Vec<f64> {
    (0..=200).map(|k| f64::from(k) * 0.01).collect()
}

/// Output 0 and its derivatives by `free` parameters and all initial states.
struct Run {
    y: Vec<f64>,
    dy: Vec<Vec<f64>>,
    status: Status,
}

fn fixed(model: &dyn Model, p: &[f64], x0: &[f64], free: &[usize], pattern: Pattern) -> Run {
    let (signals, times) = (signals(), times());
    let n = x0.len();
    let mut forward = Forward::new(model, &signals, &times, &[0], free, n, pattern).unwrap();
    let columns = forward.columns();
    let mut s0 = vec![0.0; n * columns];
    (0..n).for_each(|i| s0[i * columns + free.len() + i] = 1.0);
    let (mut y, mut dy) = (Vec::new(), Vec::new());
    let status = forward
        .run(p, x0, &s0, &mut |_, _, value, slopes| {
            y.push(value);
            dy.push(slopes.to_vec());
        })
        .unwrap();
    Run { y, dy, status }
}

fn steps(method: FixedMethod, step: f64) -> Pattern {
    Pattern { method, step }
}

#[test]
fn orders_inside_and_at_the_end_of_steps() {
    let tight = Options { relative: 1e-13, absolute: 1e-14, ..Options::default() };
    let exact = simulate(&Hand(Pendulum), &P, &X0, &signals(), &times(), &tight).unwrap().output(0);
    // halving the step divides the error by 2^order, up to the next order
    for (method, inside) in [(FixedMethod::Classical, 12.0..20.0), (FixedMethod::DormandPrince, 26.0..40.0)] {
        let errors = [0.08, 0.04, 0.02].map(|step| {
            let run = fixed(&Hand(Pendulum), &P, &X0, &[], steps(method, step));
            run.y.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        });
        for pair in errors.windows(2) {
            assert!(inside.contains(&(pair[0] / pair[1])), "{method:?}: {errors:?}");
        }
        assert!(errors[2] < 1e-6, "{method:?}: {errors:?}");
    }
}

/// The derivatives of output 0 by all parameters and initial states are those of the same computation.
fn compare_with_differences(model: &dyn Model, p: &[f64], pattern: Pattern) {
    let all: Vec<usize> = (0..p.len()).collect();
    let run = fixed(model, p, &X0, &all, pattern);
    // central differences of the same computation: error h^2 f'''/6 + rounding/h, about 1e-9 here
    let h = 1e-5;
    for column in 0..p.len() + 2 {
        let moved = |by: f64| {
            let (mut p, mut x0) = (p.to_vec(), X0);
            match column.checked_sub(p.len()) {
                None => p[column] += by,
                Some(state) => x0[state] += by,
            }
            fixed(model, &p, &x0, &[], pattern).y
        };
        for (k, (above, below)) in moved(h).iter().zip(moved(-h)).enumerate() {
            let wanted = (above - below) / (2.0 * h);
            let found = run.dy[k][column];
            assert!((found - wanted).abs() < 1e-7, "{pattern:?}, column {column} at {k}: {found} {wanted}");
        }
    }
}

#[test]
fn derivatives_are_those_of_the_computed_outputs() {
    for method in [FixedMethod::Classical, FixedMethod::DormandPrince] {
        compare_with_differences(&Hand(Pendulum), &P, steps(method, 0.05));
    }
}

#[test]
fn readings_behind_a_play_and_their_derivatives() {
    let p = [P[0], P[1], P[2], 0.3];
    for method in [FixedMethod::Classical, FixedMethod::DormandPrince] {
        compare_with_differences(&Hand(Played), &p, steps(method, 0.05));
    }
    // a play of no width opens: forwards differences
    let pattern = steps(FixedMethod::DormandPrince, 0.05);
    let [closed, open] = [0.0, 1e-6].map(|width| fixed(&Hand(Played), &[P[0], P[1], P[2], width], &X0, &[3], pattern));
    let worst = (0..closed.y.len()).map(|k| (closed.dy[k][0] - (open.y[k] - closed.y[k]) / 1e-6).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-6 && closed.dy.iter().any(|dy| dy[0].abs() == 1.0), "{worst:e}");
    let run = fixed(&Hand(Played), &p, &X0, &[3], steps(FixedMethod::DormandPrince, 0.005));
    let exact = simulate(&Hand(Played), &p, &X0, &signals(), &times(), &Options::default()).unwrap().output(0);
    assert!(run.y.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-8));
    // it stands, and its derivative with it, a good part of the time: at both turns at least
    let stands = (1..run.y.len()).filter(|&k| run.y[k] == run.y[k - 1]).collect::<Vec<_>>();
    assert!(stands.len() > 40 && stands.iter().all(|&k| run.dy[k] == run.dy[k - 1]), "{}", stands.len());
    // a wider play takes more off what was on the way up, and off what was on the way down
    assert!(run.dy.iter().any(|dy| dy[0] > 0.9) && run.dy.iter().any(|dy| dy[0] < -0.9), "{:?}", run.dy);
}

#[test]
fn only_the_free_parameters_have_columns() {
    let p = [3.0, 0.2, 0.1];
    let run = |free: &[usize]| fixed(&Hand(Linear), &p, &[0.1, 0.2, 0.3], free, steps(FixedMethod::Classical, 0.01));
    let (all, some, none) = (run(&[0, 1, 2]), run(&[2, 0]), run(&[]));
    assert!(none.y == all.y && none.dy[7].len() == 3);
    for (all, some) in all.dy.iter().zip(&some.dy) {
        assert_eq!(some[..], [all[2], all[0], all[3], all[4], all[5]]);
    }
}

#[test]
fn ends_and_arguments() {
    let run = fixed(&Hand(Wall), &[0.8], &[0.0, 0.0], &[], steps(FixedMethod::Classical, 0.01));
    assert!(matches!(run.status, Status::Singular { .. }), "{:?}", run.status);
    let end = run.status.time().unwrap();
    assert!((end - 1.25).abs() < 0.011 && (run.y.len() as f64 - end / 0.01).abs() < 2.0, "{end} {}", run.y.len());
    let (signals, times) = (signals(), times());
    let refused = |free: &[usize], step: f64| {
        Forward::new(&Hand(Wall), &signals, &times, &[0], free, 0, steps(FixedMethod::Classical, step)).err().unwrap().to_string()
    };
    let mut misread = Forward::new(&Hand(Misread), &signals, &times, &[0], &[], 0, steps(FixedMethod::Classical, 0.1)).unwrap();
    let refused_play = misread.run(&[1.0], &[0.0; 2], &[], &mut |_, _, _, _| {}).unwrap_err().to_string();
    assert_eq!(refused_play, "the play of q0 is -0.5; a play is zero or positive");
    assert_eq!(refused(&[], 0.0), "the step must be a positive number, not 0");
    assert_eq!(refused(&[7], 0.1), "8 parameters were given, the model has 1");
}
