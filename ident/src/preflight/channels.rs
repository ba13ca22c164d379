//! One channel of a record by itself: range, step, speed, reversals, rest noise, saturation. Knows no model.

use super::quantum::quantum;
use crate::fit::rates;

/// Facts of a measured output.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputFacts {
    /// Name.
    pub name: String,
    /// Unit (SI), as the model names it.
    pub unit: String,
    /// First value.
    pub first: f64,
    /// Least and largest value; angles unwrapped.
    pub range: (f64, f64),
    /// Never changes.
    pub constant: bool,
    /// Step of the encoder, seen in the increments.
    pub quantum_seen: Option<f64>,
    /// Step that the rig declares.
    pub quantum_declared: Option<f64>,
    /// Least and largest speed, smoothed over 0.1 s.
    pub speed: (f64, f64),
    /// Turns of the motion that are larger than noise and steps.
    pub reversals: usize,
    /// Standard deviation about a straight line in the calmest half second.
    pub rest_noise: f64,
}

/// Facts of an input.
#[derive(Clone, Debug, PartialEq)]
pub struct InputFacts {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Least and largest value.
    pub range: (f64, f64),
    /// Limits of the rig; infinite where it has none.
    pub limits: (f64, f64),
    /// Share of the samples at a limit or beyond it.
    pub saturated: f64,
    /// Share of the samples beyond a limit.
    pub beyond: f64,
    /// Different values, at most 1000 counted.
    pub levels: usize,
    /// Not logged, but declared.
    pub declared: bool,
}

/// Of an output's values, angles unwrapped.
pub(super) fn output(name: &str, unit: &str, t: &[f64], values: &[f64], raw: &[f64], declared: f64) -> OutputFacts {
    let range = range_of(values);
    let period = super::timing::Timing::of(t).rate.recip();
    let quantum_seen = quantum(raw);
    let window = ((0.1 / period).round() as usize).clamp(4, t.len().max(4));
    let speed = if t.len() > window { range_of(&rates(t, values, window)) } else { (0.0, 0.0) };
    let noise = rest_noise(t, values);
    let step = quantum_seen.unwrap_or(0.0).max(declared);
    OutputFacts {
        name: name.to_owned(),
        unit: unit.to_owned(),
        first: values.first().copied().unwrap_or(0.0),
        range,
        constant: range.0 == range.1,
        quantum_seen,
        quantum_declared: (declared > 0.0).then_some(declared),
        speed,
        reversals: reversals(values, (0.03 * (range.1 - range.0)).max(3.0 * step).max(6.0 * noise)),
        rest_noise: noise,
    }
}

/// Of an input's values at the record's samples.
pub(super) fn input(name: &str, unit: &str, values: &[f64], limits: (f64, f64), declared: bool) -> InputFacts {
    let n = values.len().max(1) as f64;
    let hair = 1e-9 * (limits.1 - limits.0);
    let hair = if hair.is_finite() { hair } else { 0.0 };
    let share = |inside: &dyn Fn(f64) -> bool| values.iter().filter(|u| !inside(**u)).count() as f64 / n;
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    InputFacts {
        name: name.to_owned(),
        unit: unit.to_owned(),
        range: range_of(values),
        limits,
        saturated: share(&|u| u > limits.0 + hair && u < limits.1 - hair),
        beyond: share(&|u| u >= limits.0 - hair && u <= limits.1 + hair),
        levels: sorted.len().min(1000),
        declared,
    }
}

pub(super) fn range_of(values: &[f64]) -> (f64, f64) {
    let (lo, hi) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &y| (lo.min(y), hi.max(y)));
    if lo <= hi { (lo, hi) } else { (0.0, 0.0) }
}

/// Turns of more than `least`: a turn counts once the signal has come back by that much.
fn reversals(values: &[f64], least: f64) -> usize {
    let Some(&first) = values.first() else { return 0 };
    let (mut low, mut high, mut direction, mut count) = (first, first, 0_i8, 0);
    for &y in values {
        low = low.min(y);
        high = high.max(y);
        if direction >= 0 && high - y > least {
            count += usize::from(direction > 0);
            (direction, low, high) = (-1, y, y);
        } else if direction <= 0 && y - low > least {
            count += usize::from(direction < 0);
            (direction, low, high) = (1, y, y);
        }
    }
    count
}

/// Standard deviation about a straight line, in the calmest of the half seconds of a record.
fn rest_noise(t: &[f64], values: &[f64]) -> f64 {
    let mut least = f64::INFINITY;
    let mut from = 0;
    while from < t.len() {
        let to = t.partition_point(|&s| s < t[from] + 0.5).max(from + 1);
        if to - from >= 5 && (to < t.len() || least.is_infinite()) {
            let n = (to - from) as f64;
            let (t, y) = (&t[from..to], &values[from..to]);
            let mean = |v: &[f64]| v.iter().sum::<f64>() / n;
            let (mt, my) = (mean(t), mean(y));
            let (mut tt, mut ty, mut yy) = (0.0, 0.0, 0.0);
            for (t, y) in t.iter().zip(y) {
                tt += (t - mt).powi(2);
                ty += (t - mt) * (y - my);
                yy += (y - my).powi(2);
            }
            least = least.min(((yy - ty * ty / tt).max(0.0) / n).sqrt());
        }
        from = to;
    }
    let (lo, hi) = range_of(values);
    // rounding is no noise
    if least.is_finite() && least > 1e-9 * lo.abs().max(hi.abs()) { least } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{input, output, reversals};

    #[test]
    fn turns_of_a_wave_and_none_of_its_noise() {
        let y: Vec<f64> = (0..1000).map(|k| (0.02 * f64::from(k)).sin() + 0.01 * f64::from(k % 2)).collect();
        // 20 rad of a sine: turns at pi/2, 3 pi/2, ..
        assert_eq!(reversals(&y, 0.1), 6);
        assert_eq!(reversals(&[1.0; 9], 0.1), 0);
    }

    #[test]
    fn saturation_counts_values_at_a_limit_too() {
        let facts = input("u", "N", &[0.0, 1.0, 2.0, 3.0], (0.0, 2.0), false);
        assert_eq!((facts.saturated, facts.beyond, facts.levels), (0.75, 0.25, 4));
    }

    #[test]
    fn speed_and_rest() {
        let t: Vec<f64> = (0..400).map(|k| 0.01 * f64::from(k)).collect();
        let y: Vec<f64> = t.iter().map(|t| if *t < 2.0 { 0.0 } else { (t - 2.0).powi(2) }).collect();
        let facts = output("q", "m", &t, &y, &y, 0.0);
        assert!((facts.speed.1 - 3.98).abs() < 0.02 && facts.rest_noise == 0.0 && facts.reversals == 0, "{facts:?}");
    }
}
