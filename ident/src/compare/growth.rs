//! How fast a model amplifies an error of its initial state, along its free run and along what was measured, each state counted in parts
//! of the range that the record moves it through: so that units do not matter.

use nalgebra::DMatrix;
use runtime::Model;
use sim::Signals;

/// Least range of a coordinate or rate, in parts of the largest among those of the same unit: what hardly moves is not amplified.
const LEAST: f64 = 0.01;

/// The range of each state along a record; zero for those that do not move.
pub(super) fn ranges(model: &dyn Model, p: &[f64], t: f64, states: &[Vec<f64>]) -> Vec<f64> {
    let d = model.dimensions();
    let n = d.states();
    let mut range: Vec<f64> = (0..n)
        .map(|i| {
            let (lo, hi) = states.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x[i]), hi.max(x[i])));
            if hi > lo { hi - lo } else { 0.0 }
        })
        .collect();
    let Some(first) = states.first() else { return range };
    let (mut c, mut dhdp) = (vec![0.0; d.outputs * n], vec![0.0; d.outputs * d.parameters]);
    model.output_jacobian(t, first, p, &mut c, &mut dhdp);
    // the unit of a coordinate is that of an output that shows it alone
    let shows = |r: usize, i: usize| c[r * n..(r + 1) * n].iter().enumerate().all(|(j, c)| (*c != 0.0) == (j == i));
    let unit = |i: usize| (0..d.outputs).find(|&r| shows(r, i)).map(|r| model.names().output_unit(r));
    for offset in [0, d.coordinates] {
        let own = range.clone();
        for i in 0..d.coordinates {
            let alike = (0..d.coordinates).filter(|&j| unit(i).is_some() && unit(j) == unit(i)).map(|j| own[offset + j]);
            range[offset + i] = own[offset + i].max(LEAST * alike.fold(0.0, f64::max));
        }
    }
    range
}

/// The first time [s] at which an entry of d x(t)/d x(t[0]), states in parts of their `ranges`, exceeds `limit`, where the state at `t[k]`
/// is `state(k)`; `None` where it never does.
///
/// The slopes A are those at the samples, advanced by the implicit midpoint rule, (I - A h/2)^-1 (I + A h/2): it keeps
/// decaying modes decaying however fast they are.
pub(super) fn time_of_growth(
    model: &dyn Model,
    p: &[f64],
    signals: &Signals,
    t: &[f64],
    state: &dyn Fn(usize) -> Vec<f64>,
    (ranges, limit): (&[f64], f64),
) -> Option<f64> {
    let d = model.dimensions();
    let n = d.states();
    let (mut dx, mut a, mut b) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * d.signals()]);
    let mut phi = DMatrix::<f64>::identity(n, n);
    let identity = phi.clone();
    for (k, w) in t.windows(2).enumerate() {
        model.linearize(w[0], &state(k), &signals.at(w[0]), p, &mut dx, &mut a, &mut b).ok()?;
        let half = DMatrix::from_row_slice(n, n, &a) * (0.5 * (w[1] - w[0]));
        phi = (&identity - &half).lu().solve(&((&identity + &half) * &phi))?;
        // a NaN has left all bounds too
        let grown = |i: usize, j: usize| phi[(i, j)].is_nan() || ranges[i] > 0.0 && phi[(i, j)].abs() * ranges[j] > limit * ranges[i];
        if (0..n).any(|i| (0..n).any(|j| grown(i, j))) {
            return Some(w[1]);
        }
    }
    None
}
