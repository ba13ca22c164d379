//! Rates of a sampled signal by an observer or a filter that could run on the rig, and signals that are as late as those. Knows no model.

use control::{AngleObserver, DerivativeFilter, Rule, Running, centred_mean};
use nalgebra::Complex;

/// Where rates come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RatesBy {
    /// Luenberger observer of a chain of three integrators with poles -w and w (-0.6 +- 0.8 i).
    Observer {
        /// w [rad/s].
        bandwidth: f64,
    },
    /// The filter of eq. 23, F(s) = w^2 s/(s^2 + 2 eta w s + w^2), for a held input.
    Filter {
        /// w [rad/s].
        bandwidth: f64,
        /// eta.
        damping: f64,
    },
}

impl RatesBy {
    /// w [rad/s].
    pub(super) fn bandwidth(self) -> f64 {
        match self {
            Self::Observer { bandwidth } | Self::Filter { bandwidth, .. } => bandwidth,
        }
    }

    /// Rates of a sampled coordinate; `None` where they cannot be sampled at this period [s].
    pub(super) fn of(self, q: &[f64], period: f64) -> Option<Vec<f64>> {
        let sampled = match self {
            Self::Observer { bandwidth } => {
                let (w, side) = (Complex::new(-bandwidth, 0.0), Complex::new(-0.6 * bandwidth, 0.8 * bandwidth));
                AngleObserver::new(&[w, side, side.conj()]).sampled(1, period)
            }
            Self::Filter { bandwidth, damping } => DerivativeFilter { omega: bandwidth, damping }.sampled(period, Rule::ZeroOrderHold),
        };
        let mut running = Running::new(sampled.ok()?);
        let rates: Vec<f64> = q.iter().map(|q| running.next(*q)).collect();
        rates.iter().all(|v| v.is_finite()).then_some(rates)
    }

    /// A signal as late as the rates are, and smoothed as they are: the rate of its integral.
    pub(super) fn late(self, signal: &[f64], period: f64, mean: usize) -> Option<Vec<f64>> {
        let mut sum = 0.0;
        let integral: Vec<f64> = std::iter::once(0.0)
            .chain(signal.windows(2).map(|w| {
                sum += 0.5 * period * (w[0] + w[1]);
                sum
            }))
            .collect();
        Some(centred_mean(&self.of(&integral, period)?, mean))
    }
}
