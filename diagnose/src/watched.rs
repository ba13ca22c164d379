//! What the training records show: coordinates that none of them measures have no random force of their own, whose size could be anything;
//! outputs that only a test record has are left out of it, since nothing is known of their noise.
//!
//! Knows models and records; nothing of effects.

use crate::model::Prepared;
use ident::innovations::Track;
use runtime::Model;

/// Coordinates that no output of these records shows.
pub fn unwatched(prepared: &Prepared, p: &[f64], tracks: &[Track]) -> Vec<usize> {
    let d = prepared.model.dimensions();
    let n = d.states();
    // a state at which no derivative vanishes by chance
    let x: Vec<f64> = (0..n).map(|i| 0.1 + 0.01 * i as f64).collect();
    let (mut c, mut dhdp) = (vec![0.0; d.outputs * n], vec![0.0; d.outputs * d.parameters]);
    prepared.model.output_jacobian(0.0, &x, p, &mut c, &mut dhdp);
    let shows = |o: usize, i: usize| c[o * n + i] != 0.0 || c[o * n + d.coordinates + i] != 0.0;
    (0..d.coordinates).filter(|&i| !tracks.iter().flat_map(Track::measured).any(|(o, _)| shows(o, i))).collect()
}

/// Leaves outputs that no training record has out of the test records. A test record that has no other is a fault.
pub fn leave_out_unknown(tracks: &[Track], held: &mut [Track]) -> Vec<String> {
    let mut faults = Vec::new();
    for test in held {
        let unknown: Vec<usize> =
            test.measured().map(|(o, _)| o).filter(|o| !tracks.iter().flat_map(Track::measured).any(|(own, _)| own == *o)).collect();
        unknown.into_iter().for_each(|o| test.leave_out(o));
        if test.measured().next().is_none() {
            faults.push(format!(
                "{}: it measures nothing that a training record measures, so that nothing can be judged by it",
                test.source()
            ));
        }
    }
    faults
}
