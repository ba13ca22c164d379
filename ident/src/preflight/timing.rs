//! The time stamps of a record: rate, jitter, gaps.

/// What the time stamps say.
#[derive(Clone, Debug, PartialEq)]
pub struct Timing {
    /// Samples.
    pub samples: usize,
    /// From first to last [s].
    pub duration: f64,
    /// 1 / median step [Hz].
    pub rate: f64,
    /// Standard deviation of the steps that are no gaps, over their median.
    pub jitter: f64,
    /// Steps of at least two and a half medians.
    pub gaps: Vec<Gap>,
}

/// Samples are missing here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Time stamp before it [s].
    pub after: f64,
    /// Its length [s].
    pub length: f64,
}

/// A gap of so many medians, or so many gaps a step, is a fault; a single late sample is not.
const LONG: f64 = 5.0;
const MANY: f64 = 2e-3;
/// A step that is this many medians long has lost at least one sample, whatever the jitter.
const GAP: f64 = 2.5;

impl Timing {
    /// The gaps are a fault of the record, no single late sample.
    #[must_use]
    pub fn is_broken(&self) -> bool {
        self.gaps.iter().any(|g| g.length * self.rate >= LONG) || self.gaps.len() as f64 > MANY * self.samples as f64
    }

    /// Of increasing time stamps [s].
    #[must_use]
    pub fn of(t: &[f64]) -> Self {
        let steps: Vec<f64> = t.windows(2).map(|w| w[1] - w[0]).collect();
        let mut sorted = steps.clone();
        sorted.sort_by(f64::total_cmp);
        let median = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
        let kept: Vec<f64> = steps.iter().copied().filter(|s| *s < GAP * median).collect();
        let mean = kept.iter().sum::<f64>() / kept.len().max(1) as f64;
        let sd = (kept.iter().map(|s| (s - mean).powi(2)).sum::<f64>() / kept.len().max(1) as f64).sqrt();
        let gaps = t.iter().zip(&steps).filter(|(_, s)| **s >= GAP * median).map(|(&after, &length)| Gap { after, length }).collect();
        Self {
            samples: t.len(),
            duration: t.last().copied().unwrap_or(0.0) - t.first().copied().unwrap_or(0.0),
            rate: if median > 0.0 { 1.0 / median } else { 0.0 },
            jitter: if median > 0.0 { sd / median } else { 0.0 },
            gaps,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Gap, Timing};

    #[test]
    fn a_lost_sample_is_no_gap_but_three_are() {
        let t = [0.0, 0.1, 0.2, 0.4, 0.5, 0.6, 1.0, 1.1];
        let found = Timing::of(&t);
        assert_eq!(found.gaps, [Gap { after: 0.6, length: 0.4 }]);
        assert!((found.rate - 10.0).abs() < 1e-9 && found.jitter > 0.3 && found.is_broken());
        assert_eq!(Timing::of(&[]).samples, 0);
    }
}
