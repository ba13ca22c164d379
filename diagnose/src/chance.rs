//! Seeded normal numbers, and the probabilities that tests need.

use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};

/// SplitMix64 (G. L. Steele, D. Lea and C. H. Flood, OOPSLA 2014): the same numbers on every machine.
pub struct Chance(u64);

impl Chance {
    /// From a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in (0, 1).
    pub fn uniform(&mut self) -> f64 {
        ((self.next() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// Standard normal (Box and Muller).
    pub fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

/// Probability that chi-squared with `degrees` exceeds `value`.
#[must_use]
pub fn beyond(value: f64, degrees: usize) -> f64 {
    if degrees == 0 || value <= 0.0 {
        return 1.0;
    }
    if degrees == 1 {
        // 2 (1 - Phi(sqrt(value))), exact far out
        return statrs::function::erf::erfc((0.5 * value).sqrt());
    }
    ChiSquared::new(degrees as f64).map_or(1.0, |chi| chi.sf(value))
}

/// Standard normal quantile.
#[must_use]
pub fn quantile(p: f64) -> f64 {
    Normal::standard().inverse_cdf(p.clamp(1e-300, 1.0 - 1e-16))
}

/// Variance of the sum of values with mean zero that hang together over up to `lags` (Newey and West, 1987).
#[must_use]
pub fn variance_of_sum(values: &[f64], lags: usize) -> f64 {
    let product = |lag: usize| values.iter().zip(&values[lag..]).map(|(a, b)| a * b).sum::<f64>();
    let weight = |lag: usize| if lag == 0 { 1.0 } else { 2.0 * (1.0 - lag as f64 / (lags as f64 + 1.0)) };
    (0..=lags.min(values.len().saturating_sub(1))).map(|lag| weight(lag) * product(lag)).sum::<f64>().max(0.0)
}

/// Standard normal distribution function.
#[must_use]
pub fn below(z: f64) -> f64 {
    Normal::standard().cdf(z)
}
