//! Which coordinates records show: one that no record shows moves as the model says, since a random force on it could be of any size.

use super::filter::Track;
use runtime::Model;

/// Coordinates that no measured output of these records shows, at the parameters `p`.
#[must_use]
pub fn unwatched(model: &dyn Model, p: &[f64], tracks: &[Track]) -> Vec<usize> {
    let d = model.dimensions();
    let n = d.states();
    // a state at which no derivative vanishes by chance
    let x: Vec<f64> = (0..n).map(|i| 0.1 + 0.01 * i as f64).collect();
    let (mut c, mut dhdp) = (vec![0.0; d.outputs * n], vec![0.0; d.outputs * d.parameters]);
    model.output_jacobian(0.0, &x, p, &mut c, &mut dhdp);
    let shows = |o: usize, i: usize| c[o * n + i] != 0.0 || c[o * n + d.coordinates + i] != 0.0;
    (0..d.coordinates).filter(|&i| !tracks.iter().flat_map(Track::measured).any(|(o, _)| shows(o, i))).collect()
}
