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

/// An entry is compared relative to itself, and to no less than this part of the largest entry of its row, and a row's
/// largest entry counts as no less than this part of the matrix's: what cancels to zero on one side is rounding of the
/// larger terms on the other.
const SMALL: f64 = 1e-3;

/// Largest difference of two matrices given row by row, each entry relative to its own size (see [`SMALL`]).
#[must_use]
pub fn by_rows(values: &[f64], wanted: &[f64], columns: usize) -> f64 {
    by_rows_of_scale(values, wanted, columns, |_| 0.0)
}

/// As [`by_rows`]; a row's largest entry counts as no less than `scale(row)`, the size of the terms that it is made of.
#[must_use]
pub fn by_rows_of_scale(values: &[f64], wanted: &[f64], columns: usize, scale: impl Fn(usize) -> f64) -> f64 {
    assert_eq!(values.len(), wanted.len(), "lengths differ");
    let size = |list: &[f64]| list.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let mut worst = 0.0_f64;
    for (row, (a, b)) in values.chunks(columns.max(1)).zip(wanted.chunks(columns.max(1))).enumerate() {
        let largest = size(b).max(SMALL * size(wanted)).max(scale(row));
        for (x, y) in a.iter().zip(b) {
            let d = if x == y { 0.0 } else { (x - y).abs() / y.abs().max(SMALL * largest) };
            // a NaN must not pass as a small difference
            worst = if d.is_nan() { f64::INFINITY } else { worst.max(d) };
        }
    }
    worst
}
