//! Comparison of numbers: relative to the size of what they stand in.

/// Largest difference of two slices relative to the largest entry of the second (and never to less than `floor`).
#[must_use]
pub fn relative(values: &[f64], wanted: &[f64], floor: f64) -> f64 {
    assert_eq!(values.len(), wanted.len(), "lengths differ");
    let size = wanted.iter().fold(floor, |m, x| m.max(x.abs()));
    values.iter().zip(wanted).fold(0.0, |m: f64, (a, b)| {
        let d = (a - b).abs() / size;
        // a NaN must not pass as a small difference
        if d.is_nan() { f64::INFINITY } else { m.max(d) }
    })
}
