//! The way of an output to its reader: delay (see `simulate`), then the encoder.

use runtime::OutputPath;
use std::f64::consts::{PI, TAU};

/// What an encoder shows for the value y: the nearest count, and modulo one turn in (-pi, pi] where it is wrapped.
#[must_use]
pub fn encoder(y: f64, path: &OutputPath) -> f64 {
    let counted = if path.quantum > 0.0 { (y / path.quantum).round() * path.quantum } else { y };
    if path.wrapped { PI - (PI - counted).rem_euclid(TAU) } else { counted }
}

#[cfg(test)]
mod tests {
    use super::encoder;
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
}
