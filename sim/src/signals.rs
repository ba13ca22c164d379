//! Signals over time (inputs, then exogenous signals), and the pieces on which they are smooth.

use crate::error::SimError;

/// What a signal does between its samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// Keeps the last sample, as a digital-to-analogue converter does.
    #[default]
    Zero,
    /// Goes straight from sample to sample.
    First,
}

/// One signal: samples at its own time stamps.
///
/// Before the first stamp the first sample holds, after the last stamp the last one.
#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    /// Time stamps [s], increasing.
    pub t: Vec<f64>,
    /// Samples (SI).
    pub values: Vec<f64>,
    /// What it does between them.
    pub hold: Hold,
}

impl Signal {
    /// A signal that never changes.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self { t: vec![0.0], values: vec![value], hold: Hold::Zero }
    }
}

/// All signals of a model, in its order, checked.
#[derive(Clone, Debug)]
pub struct Signals(Vec<Signal>);

impl Signals {
    /// Checks the samples.
    ///
    /// # Errors
    /// [`SimError`] where a signal has no sample, not as many samples as stamps, a number that is not finite, or stamps
    /// that do not increase.
    pub fn new(signals: Vec<Signal>) -> Result<Self, SimError> {
        for (i, signal) in signals.iter().enumerate() {
            check_times("time stamps of a signal", &signal.t)?;
            if signal.values.len() != signal.t.len() {
                return Err(SimError::Length { what: "samples of a signal", wanted: signal.t.len(), found: signal.values.len() });
            }
            if let Some(k) = signal.values.iter().position(|u| !u.is_finite()) {
                return Err(SimError::NotFinite { what: format!("sample {} of signal {}", k + 1, i + 1) });
            }
        }
        Ok(Self(signals))
    }

    /// Signals that never change.
    ///
    /// # Errors
    /// [`SimError::NotFinite`] where a value is not finite.
    pub fn constant(values: &[f64]) -> Result<Self, SimError> {
        Self::new(values.iter().map(|&u| Signal::constant(u)).collect())
    }

    /// All signals at time t [s], before limits and delays.
    #[must_use]
    pub fn at(&self, t: f64) -> Vec<f64> {
        self.0
            .iter()
            .map(|signal| {
                let k = signal.t.partition_point(|&s| s <= t).max(1) - 1;
                match (signal.hold, signal.t.get(k + 1)) {
                    (Hold::First, Some(next)) if t > signal.t[k] => {
                        signal.values[k] + (signal.values[k + 1] - signal.values[k]) * (t - signal.t[k]) / (next - signal.t[k])
                    }
                    _ => signal.values[k],
                }
            })
            .collect()
    }

    /// Number of signals.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The pieces of [from, to] on which all signals are straight, after `limits` and `delay` of each signal.
    /// Equal consecutive samples make one piece; a switch lies exactly on a border.
    pub fn segments(&self, paths: &[Path], from: f64, to: f64) -> Vec<Segment> {
        let lines: Vec<Vec<Knot>> = self.0.iter().zip(paths).map(|(signal, path)| knots(signal, *path)).collect();
        // a signal holds its first value before its first knot: that knot is a border only if a slope begins there
        let mut borders: Vec<f64> =
            lines.iter().flat_map(|line| &line[usize::from(line[0].slope == 0.0)..]).map(|k| k.t).filter(|&t| t > from && t < to).collect();
        borders.sort_by(f64::total_cmp);
        borders.push(to);
        // borders closer than rounding of the time stamps are one
        let closest = 1e-12 * from.abs().max(to.abs()).max(to - from);
        let mut segments = Vec::new();
        let mut at = vec![0; lines.len()];
        let mut start = from;
        for (k, &border) in borders.iter().enumerate() {
            let last = k + 1 == borders.len();
            if border - start <= closest && !(last && segments.is_empty()) || !last && to - border <= closest {
                continue;
            }
            let (mut values, mut slopes) = (Vec::with_capacity(lines.len()), Vec::with_capacity(lines.len()));
            for (line, i) in lines.iter().zip(&mut at) {
                while line.get(*i + 1).is_some_and(|next| next.t <= start + closest) {
                    *i += 1;
                }
                let knot = &line[*i];
                // before its first sample a signal is held
                let begun = knot.t <= start + closest;
                let slope = if begun { knot.slope } else { 0.0 };
                values.push(knot.value + slope * (start - knot.t));
                slopes.push(slope);
            }
            segments.push(Segment { from: start, to: border, values, slopes });
            start = border;
        }
        segments
    }
}

fn knots(signal: &Signal, path: Path) -> Vec<Knot> {
    let clipped = |k: usize| signal.values[k].max(path.limits.0).min(path.limits.1);
    let mut knots: Vec<Knot> = Vec::new();
    for (k, &t) in signal.t.iter().enumerate() {
        let value = clipped(k);
        let slope = match (signal.hold, signal.t.get(k + 1)) {
            (Hold::First, Some(next)) => (clipped(k + 1) - value) / (next - t),
            _ => 0.0,
        };
        // held and unchanged: no border
        if slope == 0.0 && knots.last().is_some_and(|last| last.slope == 0.0 && last.value == value) {
            continue;
        }
        knots.push(Knot { t: t + path.delay, value, slope });
    }
    knots
}

/// Limits and delay of one signal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Lower and upper limit (SI).
    pub limits: (f64, f64),
    /// Delay [s].
    pub delay: f64,
}

struct Knot {
    t: f64,
    value: f64,
    slope: f64,
}

/// From `from` to `to` the signals are `values + slopes * (t - from)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Beginning [s].
    pub from: f64,
    /// End [s].
    pub to: f64,
    /// Signals at the beginning.
    pub values: Vec<f64>,
    /// Their slopes [1/s].
    pub slopes: Vec<f64>,
}

impl Segment {
    /// The signals at time t.
    pub fn at(&self, t: f64, u: &mut [f64]) {
        for ((u, value), slope) in u.iter_mut().zip(&self.values).zip(&self.slopes) {
            *u = value + slope * (t - self.from);
        }
    }
}

/// Times are there, finite, and increase.
pub(crate) fn check_times(what: &'static str, t: &[f64]) -> Result<(), SimError> {
    if t.is_empty() {
        return Err(SimError::Empty { what });
    }
    if let Some(k) = t.iter().position(|t| !t.is_finite()) {
        return Err(SimError::NotFinite { what: format!("number {} of the {what}", k + 1) });
    }
    match t.windows(2).position(|w| w[1] <= w[0]) {
        Some(k) => Err(SimError::Order { what, index: k + 1, t: t[k + 1] }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::{Hold, Path, Signal, Signals};

    const OPEN: Path = Path { limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0 };

    fn borders(signals: &Signals, paths: &[Path], from: f64, to: f64) -> Vec<(f64, f64)> {
        signals.segments(paths, from, to).iter().map(|s| (s.from, s.values[0])).collect()
    }

    #[test]
    fn equal_samples_make_one_segment() {
        let t: Vec<f64> = (0..10).map(f64::from).collect();
        let u = vec![1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 1.0, 1.0, 1.0];
        let signals = Signals::new(vec![Signal { t, values: u, hold: Hold::Zero }]).unwrap();
        assert_eq!(borders(&signals, &[OPEN], 0.0, 9.0), [(0.0, 1.0), (3.0, 2.0), (7.0, 1.0)]);
        assert_eq!(borders(&signals, &[Path { delay: 0.5, ..OPEN }], 0.0, 9.0), [(0.0, 1.0), (3.5, 2.0), (7.5, 1.0)]);
        // both levels above the limit: no switch is left
        assert_eq!(borders(&signals, &[Path { limits: (0.0, 0.7), delay: 0.0 }], 0.0, 9.0), [(0.0, 0.7)]);
        // only part of the record
        assert_eq!(borders(&signals, &[OPEN], 4.0, 7.5), [(4.0, 2.0), (7.0, 1.0)]);
    }

    #[test]
    fn straight_lines_and_held_ends() {
        let signals = Signals::new(vec![Signal { t: vec![0.0, 1.0, 2.0], values: vec![0.0, 2.0, 2.0], hold: Hold::First }]).unwrap();
        let pieces = signals.segments(&[OPEN], -1.0, 3.0);
        assert_eq!(
            pieces.iter().map(|s| (s.from, s.values[0], s.slopes[0])).collect::<Vec<_>>(),
            [(-1.0, 0.0, 0.0), (0.0, 0.0, 2.0), (1.0, 2.0, 0.0)]
        );
    }

    #[test]
    fn switches_of_two_signals_that_differ_by_rounding_are_one() {
        let signal = Signal { t: vec![0.0, 0.1 + 0.2, 1.0], values: vec![0.0, 1.0, 1.0], hold: Hold::Zero };
        let signals = Signals::new(vec![signal.clone(), signal]).unwrap();
        let paths = [OPEN, Path { delay: 5e-17, ..OPEN }];
        let pieces = signals.segments(&paths, 0.0, 1.0);
        assert_eq!(pieces.len(), 2);
        assert_eq!(pieces[1].values, [1.0, 1.0]);
    }
}
