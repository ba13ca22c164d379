//! Sampled signals as numbers: unwrapping, straight lines, fit and rms error.

use std::f64::consts::{PI, TAU};

/// Value and rate of a straight line at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Line {
    pub value: f64,
    pub rate: f64,
}

/// The least-squares line through samples, at time `at`.
pub(crate) fn line(t: &[f64], y: &[f64], at: f64) -> Line {
    let n = t.len() as f64;
    let (mt, my) = (t.iter().sum::<f64>() / n, y.iter().sum::<f64>() / n);
    let (mut stt, mut sty) = (0.0, 0.0);
    for (t, y) in t.iter().zip(y) {
        stt += (t - mt) * (t - mt);
        sty += (t - mt) * (y - my);
    }
    let rate = if stt > 0.0 { sty / stt } else { 0.0 };
    Line { value: my + rate * (at - mt), rate }
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
    use super::{Line, fit_percent, line, rmse, unwrap};
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
    fn lines_and_turns() {
        assert_eq!(line(&[0.0, 1.0, 2.0], &[1.0, 3.0, 5.0], 0.0), Line { value: 1.0, rate: 2.0 });
        let truth: Vec<f64> = (0..50).map(|k| -0.7 * f64::from(k)).collect();
        let mut wrapped: Vec<f64> = truth.iter().map(|y| y.rem_euclid(TAU) - TAU).collect();
        let offset = wrapped[0] - truth[0];
        unwrap(&mut wrapped);
        assert!(wrapped.iter().zip(&truth).all(|(w, t)| (w - t - offset).abs() < 1e-12));
    }
}
