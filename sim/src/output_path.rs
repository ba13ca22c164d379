//! The way of an output to its reader: delay (see `simulate`), then the play, then the encoder.

use runtime::OutputPath;
use std::f64::consts::{PI, TAU};

/// What an encoder shows for the value y: the nearest count, and modulo one turn in (-pi, pi] where it is wrapped.
#[must_use]
pub fn encoder(y: f64, path: &OutputPath) -> f64 {
    let counted = if path.quantum > 0.0 { (y / path.quantum).round() * path.quantum } else { y };
    if path.wrapped { PI - (PI - counted).rem_euclid(TAU) } else { counted }
}

/// What stands behind the play for the value y, where `before` was read before: it stands until y has gone through the
/// play, then y takes it along. The first reading, and one after what is not a number, is in the middle. y itself where the path
/// has no play.
#[must_use]
pub fn play(before: Option<f64>, y: f64, path: &OutputPath) -> f64 {
    let half = 0.5 * path.play.max(0.0);
    match contact(before, y, path) {
        // not y - (y - before): what stands keeps its last digit
        Contact::None(before) => before,
        Contact::Below => y - half,
        Contact::Above => y + half,
        Contact::Middle => y,
    }
}

/// How a reading hangs on the value y.
pub(crate) enum Contact {
    /// Not at all: it stands.
    None(f64),
    /// At the stop behind which it is half of the play below y.
    Below,
    /// At the other one.
    Above,
    /// It is put into the middle.
    Middle,
}

pub(crate) fn contact(before: Option<f64>, y: f64, path: &OutputPath) -> Contact {
    match before {
        Some(before) if (before - y).abs() <= 0.5 * path.play.max(0.0) => Contact::None(before),
        Some(before) if before < y => Contact::Below,
        Some(before) if before > y => Contact::Above,
        _ => Contact::Middle,
    }
}

#[cfg(test)]
mod tests {
    use super::{encoder, play};
    use runtime::OutputPath;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn counts_and_turns() {
        let plain = OutputPath { delay: 0.0, play: 0.0, quantum: 0.25, wrapped: false };
        assert_eq!(encoder(0.3, &plain), 0.25);
        assert_eq!(encoder(-0.4, &plain), -0.5);
        let wrapped = OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: true };
        assert!((encoder(TAU + 0.5, &wrapped) - 0.5).abs() < 1e-15);
        assert!((encoder(-TAU - 0.5, &wrapped) + 0.5).abs() < 1e-15);
        assert!((encoder(PI + 0.1, &wrapped) - (0.1 - PI)).abs() < 1e-15);
        assert_eq!(encoder(PI, &wrapped), PI);
    }

    /// All readings of a path.
    fn read(values: &[f64], width: f64) -> Vec<f64> {
        let path = OutputPath { delay: 0.0, play: width, quantum: 0.0, wrapped: false };
        let mut before = None;
        values
            .iter()
            .map(|&y| {
                before = Some(play(before, y, &path));
                before.unwrap_or(f64::NAN)
            })
            .collect()
    }

    #[test]
    fn a_triangle_through_a_play() {
        // width 2: half of it is lost at the start, all of it at each turn
        let triangle = [0.0, 0.5, 1.0, 2.0, 3.0, 2.0, 1.0, 0.0, -1.0, -3.0, -2.0, -1.0, 0.0, 0.5];
        assert_eq!(read(&triangle, 2.0), [0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0, 1.0, 0.0, -2.0, -2.0, -2.0, -1.0, -0.5]);
        // it begins in the middle, wherever that is
        assert_eq!(read(&[5.0, 5.5, 7.0, 5.5], 2.0), [5.0, 5.0, 6.0, 6.0]);
        // coarse samples and fine ones read the same where the value turns at a sample
        assert_eq!(read(&[0.0, 3.0, -3.0, 0.5], 2.0), [0.0, 2.0, -2.0, -0.5]);
    }

    #[test]
    fn a_play_that_is_none() {
        let values = [0.1, 0.3, -0.7, f64::INFINITY, 0.2, f64::NAN, 0.4];
        let read = read(&values, 0.0);
        assert!(values.iter().zip(&read).all(|(y, r)| y == r || (y.is_nan() && r.is_nan())), "{read:?}");
    }
}
