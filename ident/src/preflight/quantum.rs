//! The step of an encoder, seen in the increments of what it recorded.

/// Increments that must lie on the lattice, of those that are examined.
const SHARE: f64 = 0.95;
/// How far from the lattice an increment may lie, in steps: files round to few decimals.
const TOLERANCE: f64 = 0.1;
/// Increments below which nothing is said.
const FEWEST: usize = 20;

/// The largest q of which the increments are multiples; `None` where they are multiples of nothing (a signal that is not
/// quantized, or filtered), or where there are too few.
#[must_use]
pub fn quantum(values: &[f64]) -> Option<f64> {
    let size = values.iter().fold(0.0_f64, |m, y| m.max(y.abs()));
    // two numbers that differ by rounding are equal
    let floor = 1e-12 * size;
    let mut increments: Vec<f64> = values.windows(2).map(|w| (w[1] - w[0]).abs()).filter(|d| *d > floor).collect();
    if increments.len() < FEWEST {
        return None;
    }
    increments.sort_by(f64::total_cmp);
    // the smallest increments are one step, or a few
    let least = increments[0];
    let cluster: Vec<f64> = increments.iter().copied().take_while(|d| *d < 1.15 * least).collect();
    let first = cluster.iter().sum::<f64>() / cluster.len() as f64;
    (1..=6).find_map(|parts| refine(&increments, first / f64::from(parts)))
}

/// Makes q exact by and by, with more and more steps; `None` where the increments do not lie on its lattice.
fn refine(increments: &[f64], mut q: f64) -> Option<f64> {
    let mut examined = 0;
    for reach in [3.5, 10.5, 40.5] {
        let inside: Vec<f64> = increments.iter().copied().take_while(|d| *d < reach * q).collect();
        let (mut on, mut top, mut bottom) = (0, 0.0, 0.0);
        for d in &inside {
            let n = (d / q).round();
            if n > 0.0 && (d / q - n).abs() <= TOLERANCE {
                on += 1;
                top += n * d;
                bottom += n * n;
            }
        }
        if (on as f64) < SHARE * inside.len() as f64 || on == 0 {
            return None;
        }
        q = top / bottom;
        examined = inside.len();
    }
    (examined >= FEWEST).then_some(q)
}

#[cfg(test)]
mod tests {
    use super::quantum;

    fn wave(n: usize, speed: f64) -> Vec<f64> {
        (0..n).map(|k| (speed * k as f64).sin() + 0.3 * (0.37 * speed * k as f64).cos()).collect()
    }

    #[test]
    fn of_encoders_and_of_what_is_none() {
        for (q, speed) in [(0.0026, 0.01), (0.0013, 0.1), (0.1, 0.3)] {
            let seen: Vec<f64> = wave(3000, speed).iter().map(|y| (y / q).round() * q).collect();
            let found = quantum(&seen).unwrap_or_else(|| panic!("{q}"));
            assert!((found / q - 1.0).abs() < 1e-3, "{q}: {found}");
            // written with four decimals
            let rounded: Vec<f64> = seen.iter().map(|y| (y * 1e4).round() / 1e4).collect();
            let found = quantum(&rounded).unwrap_or_else(|| panic!("{q} rounded"));
            assert!((found / q - 1.0).abs() < 0.02, "{q}: {found}");
        }
        assert_eq!(quantum(&wave(3000, 0.01)), None);
        assert_eq!(quantum(&[1.0; 100]), None);
        assert_eq!(quantum(&[]), None);
    }
}
