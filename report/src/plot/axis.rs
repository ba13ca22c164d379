//! Ends, ticks and their labels of an axis.

use super::{Axis, Ink, Plot, Shape};

/// Ends of an axis and how values become places on it.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    pub from: f64,
    pub to: f64,
    pub log: bool,
}

impl Scale {
    /// 0 at its start, 1 at its end; beyond both outside.
    pub fn place(&self, v: f64) -> f64 {
        if self.log {
            let v = v.max(f64::MIN_POSITIVE);
            (v.log10() - self.from.log10()) / (self.to.log10() - self.from.log10())
        } else {
            (v - self.from) / (self.to - self.from)
        }
    }

    /// Values and labels of about `count` ticks.
    pub fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        if self.log {
            return self.decades(count);
        }
        let ends = |step: f64| ((self.from / step - 1e-9).ceil(), (self.to / step + 1e-9).floor());
        let mut step = nice((self.to - self.from) / count.max(1) as f64);
        if !(step > 0.0 && step.is_finite()) {
            return Vec::new();
        }
        // one tick is no scale
        let (first, last) = ends(step);
        if last - first < 1.0 {
            step = nice(0.3 * step);
        }
        let (first, last) = ends(step);
        let ticks = (last - first).clamp(0.0, 100.0) as usize;
        let large = self.from.abs().max(self.to.abs());
        (0..=ticks)
            .map(|k| {
                let value = (first + k as f64) * step;
                (value, label(value, step, large))
            })
            .collect()
    }

    fn decades(&self, count: usize) -> Vec<(f64, String)> {
        let (first, last) = ((self.from.log10() - 1e-9).ceil() as i32, (self.to.log10() + 1e-9).floor() as i32);
        let every = last.abs_diff(first) as i32 / count.clamp(1, 1000) as i32 + 1;
        // less than a decade: its ends
        if last <= first {
            return [self.from, self.to].map(|v| (v, format!("{v:.2e}"))).to_vec();
        }
        (first..=last)
            .filter(|e| (e - first) % every == 0)
            .map(|e| {
                let value = 10.0_f64.powi(e);
                (value, if (-3..=4).contains(&e) { format!("{value}") } else { format!("1e{e}") })
            })
            .collect()
    }
}

/// 1, 2 or 5 times a power of ten, at least x.
fn nice(x: f64) -> f64 {
    let power = 10.0_f64.powf(x.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|d| d * power).find(|s| *s >= x * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

fn label(value: f64, step: f64, large: f64) -> String {
    if value.abs() < 1e-9 * step {
        return "0".to_owned();
    }
    if large >= 1e5 || step < 1e-4 {
        let digits = ((large.log10().floor() - (step.log10() + 1e-9).floor()).max(0.0) as usize).min(8);
        return format!("{value:.digits$e}");
    }
    let decimals = (-(step.log10() + 1e-9).floor()).max(0.0) as usize;
    format!("{value:.decimals$}")
}

/// How far other series may stretch the axis beyond what was measured, as a share of its span.
const BEYOND: f64 = 1.0;

/// The vertical axis: of the data, or, where something was measured, of that and what is near it.
pub fn vertical(plot: &Plot) -> Option<Scale> {
    let measured = hull(plot.series.iter().filter(|s| s.ink == Ink::Measured).flat_map(|s| s.y.iter().copied()));
    let zero = plot.series.iter().any(|s| s.shape == Shape::Stems).then_some(0.0);
    let upper = plot.series.iter().flat_map(|s| if let Shape::Band(y) = &s.shape { y.as_slice() } else { &[] });
    let all = plot.series.iter().flat_map(|s| &s.y).chain(upper).copied().chain(plot.levels.iter().copied()).chain(zero);
    let all = hull(all.filter(|v| !plot.y.log || *v > 0.0))?;
    let near = measured.filter(|(lo, hi)| hi > lo && !plot.y.log).map_or(all, |(lo, hi)| {
        let reach = BEYOND * (hi - lo);
        (all.0.max(lo - reach), all.1.min(hi + reach))
    });
    Some(padded(&plot.y, near, 0.06))
}

/// The horizontal axis.
pub fn horizontal(plot: &Plot) -> Option<Scale> {
    let all = hull(plot.series.iter().flat_map(|s| s.x.iter().copied()).filter(|v| !plot.x.log || *v > 0.0))?;
    let lines = plot.series.iter().all(|s| matches!(s.shape, Shape::Line | Shape::Dashed | Shape::Steps | Shape::Band(_)));
    Some(padded(&plot.x, all, if lines { 0.0 } else { 0.04 }))
}

/// Smallest and largest finite value.
fn hull(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.filter(|v| v.is_finite()).fold(None, |h: Option<(f64, f64)>, v| Some(h.map_or((v, v), |(lo, hi)| (lo.min(v), hi.max(v)))))
}

/// Some room at both ends, and a width where there is none.
fn padded(axis: &Axis, (lo, hi): (f64, f64), room: f64) -> Scale {
    if let Some((from, to)) = axis.range.filter(|(from, to)| to > from && (!axis.log || *from > 0.0)) {
        return Scale { from, to, log: axis.log };
    }
    if axis.log {
        let factor = if hi > lo { (hi / lo).powf(room) } else { 10.0 };
        return Scale { from: (lo / factor).max(1e-300), to: (hi * factor).min(1e300), log: true };
    }
    // halves, since the difference of two finite values need not be finite
    let half = 0.5 * hi - 0.5 * lo;
    if half <= 1e-12 * hi.abs().max(lo.abs()) || half == 0.0 {
        let width = if hi == 0.0 { 1.0 } else { 0.1 * hi.abs() };
        return Scale { from: lo - width, to: hi + width, log: false };
    }
    let scale = Scale { from: lo - 2.0 * half * room, to: hi + 2.0 * half * room, log: false };
    if (scale.to - scale.from).is_finite() { scale } else { Scale { from: -1e300, to: 1e300, log: false } }
}

#[cfg(test)]
mod tests {
    use super::{Scale, padded};
    use crate::Axis;

    fn labels(from: f64, to: f64, log: bool, count: usize) -> Vec<String> {
        Scale { from, to, log }.ticks(count).into_iter().map(|t| t.1).collect()
    }

    #[test]
    fn ticks_read_well() {
        assert_eq!(labels(0.0, 25.0, false, 6), ["0", "5", "10", "15", "20", "25"]);
        assert_eq!(labels(-0.13, 0.21, false, 4), ["-0.1", "0", "0.1", "0.2"]);
        assert_eq!(labels(0.6, 3.4, false, 2), ["1", "2", "3"]);
        assert_eq!(labels(0.01, 100.0, true, 6), ["0.01", "0.1", "1", "10", "100"]);
        assert_eq!(labels(1.0, 1.00001, false, 2), ["1.000000e0", "1.000005e0", "1.000010e0"]);
        assert_eq!(labels(0.0, 4e6, false, 4), ["0", "1e6", "2e6", "3e6", "4e6"]);
    }

    #[test]
    fn what_is_constant_gets_a_width() {
        for v in [0.0, 3.0, -1e-9, 1e12, f64::MAX] {
            let scale = padded(&Axis::new(""), (v, v), 0.06);
            assert!(scale.to > scale.from && (0.0..=1.0).contains(&scale.place(v)), "{v}: {scale:?}");
        }
        let scale = padded(&Axis::new(""), (f64::MIN, f64::MAX), 0.06);
        assert!((scale.to - scale.from).is_finite() || scale.from == -1e300, "{scale:?}");
    }
}
