//! Rates from angles as a controller on the rig gets them: derivative filter, differencing, moving mean.
//!
//! Knows sampled numbers only. The derivative filter is eq. 23 of the seed paper, F(s) = w^2 s/(s^2 + 2 eta w s + w^2),
//! sampled exactly for a held input or by Tustin's rule.

use crate::discretize::{SampleError, Sampled, tustin, zero_order_hold};
use nalgebra::{DMatrix, DVector, dmatrix};

/// F(s) = w^2 s/(s^2 + 2 eta w s + w^2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DerivativeFilter {
    /// w [rad/s].
    pub omega: f64,
    /// eta.
    pub damping: f64,
}

/// How a continuous filter becomes a sampled one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Exact for an input that is held over the period. Sampled between the steps of the staircase, the rate of a ramp
    /// comes out too small by about (w T)^2/12: 3 % at w = 125.66 rad/s and T = 5 ms.
    ZeroOrderHold,
    /// Tustin's rule.
    Tustin,
}

impl DerivativeFilter {
    /// A, B, C, D: states are the smoothed angle and its rate, the output is the rate.
    #[must_use]
    pub fn state_space(self) -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
        let w2 = self.omega * self.omega;
        (dmatrix![0.0, 1.0; -w2, -2.0 * self.damping * self.omega], dmatrix![0.0; w2], dmatrix![0.0, 1.0], dmatrix![0.0])
    }

    /// The filter sampled with a period [s].
    ///
    /// # Errors
    /// [`SampleError`], one variant a cause.
    pub fn sampled(self, period: f64, rule: Rule) -> Result<Sampled, SampleError> {
        let (a, b, c, d) = self.state_space();
        match rule {
            Rule::Tustin => tustin(&a, &b, &c, &d, period),
            Rule::ZeroOrderHold => zero_order_hold(&a, &b, period).map(|(a, b)| Sampled { a, b, c, d, period }),
        }
    }
}

/// A sampled filter with one input and one output, running.
#[derive(Clone, Debug, PartialEq)]
pub struct Running {
    system: Sampled,
    state: DVector<f64>,
    started: bool,
}

impl Running {
    /// Takes a system with one input and one output; it starts in the steady state of its first input.
    #[must_use]
    pub fn new(system: Sampled) -> Self {
        Self { state: DVector::zeros(system.a.nrows()), system, started: false }
    }

    /// The next output. A filter without steady state starts from zero.
    pub fn next(&mut self, input: f64) -> f64 {
        let s = &self.system;
        if !self.started {
            self.started = true;
            let n = s.a.nrows();
            let steady = (DMatrix::identity(n, n) - &s.a).lu().solve(&(s.b.column(0) * input));
            self.state = steady.filter(|x| x.iter().all(|v| v.is_finite())).unwrap_or_else(|| DVector::zeros(n));
        }
        let output = (s.c.row(0) * &self.state)[(0, 0)] + s.d[(0, 0)] * input;
        self.state = &s.a * &self.state + s.b.column(0) * input;
        output
    }
}

/// Rates by differences of consecutive samples; the first one is zero.
#[must_use]
pub fn differences(samples: &[f64], period: f64) -> Vec<f64> {
    let steps = samples.windows(2).map(|w| (w[1] - w[0]) / period);
    samples.first().map(|_| 0.0).into_iter().chain(steps).collect()
}

/// Mean of up to `width` samples about each one (fewer at the ends), without delay: for records, not for control.
#[must_use]
pub fn centred_mean(samples: &[f64], width: usize) -> Vec<f64> {
    let (before, after) = (width.saturating_sub(1) / 2, width / 2);
    let sums: Vec<f64> = std::iter::once(0.0)
        .chain(samples.iter().scan(0.0, |sum, x| {
            *sum += x;
            Some(*sum)
        }))
        .collect();
    (0..samples.len())
        .map(|i| {
            let (lo, hi) = (i.saturating_sub(before), (i + after + 1).min(samples.len()));
            (sums[hi] - sums[lo]) / (hi - lo) as f64
        })
        .collect()
}

/// Mean of the last `width` samples (fewer at the start), as it can run on the rig.
#[must_use]
pub fn moving_mean(samples: &[f64], width: usize) -> Vec<f64> {
    let width = width.max(1);
    (0..samples.len())
        .map(|i| {
            let window = &samples[(i + 1).saturating_sub(width)..=i];
            window.iter().sum::<f64>() / window.len() as f64
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gain and phase at a frequency, by running the filter on a sine.
    fn worst_rate_error(filter: DerivativeFilter, rule: Rule, period: f64) -> f64 {
        let mut running = Running::new(filter.sampled(period, rule).unwrap());
        let w = 2.0;
        (0..4000)
            .map(|k| (k, running.next((w * period * f64::from(k)).sin())))
            .skip(2000)
            .fold(0.0, |m, (k, v)| m.max((v - w * (w * period * f64::from(k)).cos()).abs()))
    }

    #[test]
    fn both_rules_give_the_rate_of_a_slow_sine() {
        // delay of the filter: 2 eta/w; at 2 rad/s an error of about 2 * 2 * 2 eta/w, and half a sample more for the hold
        let filter = DerivativeFilter { omega: 125.66, damping: 0.9 };
        let delay = 2.0 * 0.9 / 125.66;
        let tustin = worst_rate_error(filter, Rule::Tustin, 0.005);
        assert!((tustin - 4.0 * delay).abs() < 0.05 * 4.0 * delay, "{tustin}");
        let hold = worst_rate_error(filter, Rule::ZeroOrderHold, 0.005);
        let (late, small) = (4.0 * (delay + 0.0025), 2.0 * (125.66_f64 * 0.005).powi(2) / 12.0);
        assert!((hold - late.hypot(small)).abs() < 0.03 * hold, "{hold}");
    }

    #[test]
    fn the_filter_starts_at_rest_where_its_first_sample_is() {
        let mut running = Running::new(DerivativeFilter { omega: 100.0, damping: 0.9 }.sampled(0.005, Rule::ZeroOrderHold).unwrap());
        assert!((0..50).all(|_| running.next(-0.545).abs() < 1e-12));
    }

    #[test]
    fn means_and_differences() {
        assert_eq!(differences(&[1.0, 2.0, 4.0], 0.5), [0.0, 2.0, 4.0]);
        assert_eq!(centred_mean(&[0.0, 3.0, 6.0, 9.0], 3), [1.5, 3.0, 6.0, 7.5]);
        assert_eq!(moving_mean(&[0.0, 3.0, 6.0], 2), [0.0, 1.5, 4.5]);
        assert!(differences(&[], 1.0).is_empty());
    }
}
