//! Sampled signals as numbers: unwrapping, straight lines, fit and rms error.

use nalgebra::{Matrix4, Vector4};
use std::f64::consts::{PI, TAU};

/// Value and rate of a signal at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Line {
    pub value: f64,
    pub rate: f64,
}

/// Value and rate at time `at` of the least-squares polynomial of the given degree (at most 3) through samples.
pub(super) fn polynomial(t: &[f64], y: &[f64], at: f64, degree: usize) -> Line {
    let reach = t.iter().fold(0.0_f64, |m, t| m.max((t - at).abs()));
    if reach == 0.0 {
        return Line { value: y.first().copied().unwrap_or(0.0), rate: 0.0 };
    }
    let degree = degree.min(3).min(t.len().saturating_sub(1));
    // times from -1 to 1: the normal equations are well conditioned
    let (mut sums, mut right) = ([0.0; 7], Vector4::<f64>::zeros());
    for (t, y) in t.iter().zip(y) {
        let s = (t - at) / reach;
        let mut power = 1.0;
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum += power;
            if i <= degree {
                right[i] += power * y;
            }
            power *= s;
        }
    }
    // powers that are not wanted have a row of their own
    let normal = Matrix4::from_fn(|i, j| if i.max(j) <= degree { sums[i + j] } else { f64::from(u8::from(i == j)) });
    match normal.cholesky() {
        Some(factor) => {
            let c = factor.solve(&right);
            Line { value: c[0], rate: c[1] / reach }
        }
        None => Line { value: y.iter().sum::<f64>() / y.len() as f64, rate: 0.0 },
    }
}

/// Value and rate of each measured output at `t[k]`, from a cubic through the samples within `reach` [s] of it (and always
/// through at least five where there are so many).
pub(super) fn smoothed(t: &[f64], outputs: &[Option<Vec<f64>>], k: usize, reach: f64) -> Vec<(usize, Line)> {
    let from = t.partition_point(|&s| s < t[k] - reach).min(k.saturating_sub(2));
    let to = t.partition_point(|&s| s <= t[k] + reach).max((k + 3).min(t.len()));
    // five samples carry a parabola
    let degree = if to - from < 7 { 2 } else { 3 };
    outputs.iter().enumerate().filter_map(|(i, y)| Some((i, polynomial(&t[from..to], &y.as_ref()?[from..to], t[k], degree)))).collect()
}

/// Takes out the jumps of a whole turn between samples [rad].
pub(crate) fn unwrap(y: &mut [f64]) {
    let mut turns = 0.0;
    for k in 1..y.len() {
        let jump = y[k] + turns - y[k - 1];
        if jump.abs() > PI {
            turns -= (jump / TAU).round() * TAU;
        }
        y[k] += turns;
    }
}

/// Fit in percent, 100 (1 - |y - yhat| / |y - mean y|); `None` where y is constant or there is nothing to compare.
#[must_use]
pub fn fit_percent(measured: &[f64], simulated: &[f64]) -> Option<f64> {
    let n = measured.len().min(simulated.len());
    let measured = &measured[..n];
    let mean = measured.iter().sum::<f64>() / n as f64;
    let spread = measured.iter().map(|y| (y - mean).powi(2)).sum::<f64>().sqrt();
    let size = measured.iter().fold(0.0_f64, |m, y| m.max(y.abs()));
    // the mean of equal numbers differs from them by rounding
    if n < 2 || spread <= 1e-14 * size * (n as f64).sqrt() {
        return None;
    }
    let error = measured.iter().zip(simulated).map(|(y, s)| (y - s).powi(2)).sum::<f64>().sqrt();
    Some(100.0 * (1.0 - error / spread))
}

/// Root of the mean squared difference; `None` where there is nothing to compare.
#[must_use]
pub fn rmse(measured: &[f64], simulated: &[f64]) -> Option<f64> {
    let n = measured.len().min(simulated.len());
    (n > 0).then(|| (measured.iter().zip(simulated).map(|(y, s)| (y - s).powi(2)).sum::<f64>() / n as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::{Line, fit_percent, polynomial, rmse, unwrap};
    use std::f64::consts::TAU;

    #[test]
    fn fits() {
        let y = [1.0, 2.0, 3.0, 4.0];
        assert_eq!(fit_percent(&y, &y), Some(100.0));
        assert_eq!(fit_percent(&y, &[2.5; 4]), Some(0.0));
        assert_eq!(fit_percent(&[0.1; 7], &[0.3; 7]), None);
        assert_eq!(fit_percent(&[], &[]), None);
        assert_eq!(rmse(&y, &[2.0, 3.0, 4.0, 5.0]), Some(1.0));
        assert_eq!(rmse(&[], &[1.0]), None);
    }

    #[test]
    fn polynomials_and_turns() {
        let t: Vec<f64> = (0..9).map(|k| 0.1 * f64::from(k)).collect();
        let y: Vec<f64> = t.iter().map(|t| 1.0 - 2.0 * t + 3.0 * t * t - t.powi(3)).collect();
        let found = polynomial(&t, &y, 0.4, 3);
        assert!((found.value - 0.616).abs() < 1e-12 && (found.rate + 0.08).abs() < 1e-11, "{found:?}");
        let found = polynomial(&[0.0, 1.0, 2.0], &[1.0, 3.0, 5.0], 0.0, 1);
        assert!((found.value - 1.0).abs() < 1e-12 && (found.rate - 2.0).abs() < 1e-12, "{found:?}");
        assert_eq!(polynomial(&[1.0], &[4.0], 1.0, 3), Line { value: 4.0, rate: 0.0 });
        let truth: Vec<f64> = (0..50).map(|k| -0.7 * f64::from(k)).collect();
        let mut wrapped: Vec<f64> = truth.iter().map(|y| y.rem_euclid(TAU) - TAU).collect();
        let offset = wrapped[0] - truth[0];
        unwrap(&mut wrapped);
        assert!(wrapped.iter().zip(&truth).all(|(w, t)| (w - t - offset).abs() < 1e-12));
    }
}
