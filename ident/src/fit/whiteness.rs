//! Whether errors are white: autocorrelation and the test of Ljung and Box (Biometrika 65, 1978).

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Autocorrelation of the errors of one output over one record.
#[derive(Clone, Debug, PartialEq)]
pub struct Whiteness {
    /// Record.
    pub record: String,
    /// Output.
    pub output: String,
    /// Autocorrelation at lags of 1, 2, .. samples.
    pub autocorrelation: Vec<f64>,
    /// Ljung-Box statistic over these lags.
    pub ljung_box: f64,
    /// Probability of so large a statistic if the errors were white.
    pub p_value: f64,
}

/// Autocorrelation of `errors` at up to `lags` lags; `None` where they vanish or are too few.
pub(crate) fn whiteness(record: &str, output: &str, errors: &[f64], lags: usize) -> Option<Whiteness> {
    let n = errors.len();
    let lags = lags.min(n / 5);
    let mean = errors.iter().sum::<f64>() / n.max(1) as f64;
    let centred: Vec<f64> = errors.iter().map(|e| e - mean).collect();
    let power: f64 = centred.iter().map(|e| e * e).sum();
    if lags == 0 || power.is_nan() || power <= 0.0 {
        return None;
    }
    let autocorrelation: Vec<f64> =
        (1..=lags).map(|l| centred.iter().zip(&centred[l..]).map(|(a, b)| a * b).sum::<f64>() / power).collect();
    let n = n as f64;
    let ljung_box = n * (n + 2.0) * autocorrelation.iter().enumerate().map(|(l, r)| r * r / (n - l as f64 - 1.0)).sum::<f64>();
    let p_value = ChiSquared::new(lags as f64).map_or(f64::NAN, |chi| chi.sf(ljung_box));
    Some(Whiteness { record: record.to_owned(), output: output.to_owned(), autocorrelation, ljung_box, p_value })
}

#[cfg(test)]
mod tests {
    use super::whiteness;

    #[test]
    fn white_and_coloured() {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
        };
        let white: Vec<f64> = (0..2000).map(|_| next()).collect();
        let coloured: Vec<f64> = white.windows(2).map(|w| w[0] + w[1]).collect();
        assert!(whiteness("", "", &white, 20).unwrap().p_value > 0.01);
        let w = whiteness("", "", &coloured, 20).unwrap();
        assert!((w.autocorrelation[0] - 0.5).abs() < 0.05 && w.p_value < 1e-12);
        assert!(whiteness("", "", &[0.0; 50], 20).is_none());
    }
}
