//! How fast a model amplifies an error of its initial state, along its free run and along what was measured.

use nalgebra::DMatrix;
use runtime::Model;
use sim::Signals;

/// The first time [s] at which an entry of d x(t)/d x(t[0]) exceeds `limit`, where the state at `t[k]` is `state(k)`;
/// `None` where it never does.
///
/// The slopes A are those at the samples, advanced by the implicit midpoint rule, (I - A h/2)^-1 (I + A h/2): it keeps
/// decaying modes decaying however fast they are.
pub(super) fn time_of_growth(
    model: &dyn Model,
    p: &[f64],
    signals: &Signals,
    t: &[f64],
    state: &dyn Fn(usize) -> Vec<f64>,
    limit: f64,
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
        if phi.iter().any(|x| x.is_nan() || x.abs() > limit) {
            return Some(w[1]);
        }
    }
    None
}
