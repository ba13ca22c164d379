//! Outputs that only a test record has are left out of it, since nothing is known of their noise. Knows records only.

use ident::innovations::Track;

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
