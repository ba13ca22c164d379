//! Smoothing without delay: Butterworth filters run forwards and backwards, rates by local polynomials.

use std::f64::consts::PI;

/// A Butterworth low pass of even order as second-order sections, by the bilinear transform with its frequency matched.
#[derive(Clone, Debug)]
pub(crate) struct Butterworth(Vec<Section>);

#[derive(Clone, Copy, Debug)]
struct Section {
    b: [f64; 3],
    a: [f64; 2],
}

impl Butterworth {
    /// `cutoff` in parts of the sampling rate, below one half; odd orders count as the next even one.
    pub fn new(order: usize, cutoff: f64) -> Self {
        let sections = order.div_ceil(2).max(1);
        let k = (PI * cutoff.clamp(1e-6, 0.499)).tan();
        let section = |i: usize| {
            // poles at angles (2 i + 1) / (2 n) of a half turn
            let damping = 2.0 * (PI * (2 * i + 1) as f64 / (4 * sections) as f64).sin();
            let norm = 1.0 / (1.0 + damping * k + k * k);
            let b0 = k * k * norm;
            Section { b: [b0, 2.0 * b0, b0], a: [2.0 * (k * k - 1.0) * norm, (1.0 - damping * k + k * k) * norm] }
        };
        Self((0..sections).map(section).collect())
    }

    /// Forwards and backwards: no delay, twice the attenuation. The ends are mirrored about their values.
    pub fn zero_phase(&self, y: &[f64], extension: usize) -> Vec<f64> {
        let n = y.len();
        let m = extension.min(n.saturating_sub(1));
        let mut long = Vec::with_capacity(n + 2 * m);
        long.extend((1..=m).rev().map(|k| 2.0 * y[0] - y[k]));
        long.extend_from_slice(y);
        long.extend((1..=m).map(|k| 2.0 * y[n - 1] - y[n - 1 - k]));
        for _ in 0..2 {
            self.run(&mut long);
            long.reverse();
        }
        long[m..m + n].to_vec()
    }

    fn run(&self, y: &mut [f64]) {
        for s in &self.0 {
            // as if the first value had held for ever
            let first = y.first().copied().unwrap_or(0.0);
            let mut z = [first * (1.0 - s.b[0]), first * (s.b[2] - s.a[1])];
            for y in y.iter_mut() {
                let x = *y;
                *y = s.b[0] * x + z[0];
                z = [s.b[1] * x - s.a[0] * *y + z[1], s.b[2] * x - s.a[1] * *y];
            }
        }
    }
}

/// Rates at each sample, by parabolas through the `window` samples about it.
pub(crate) fn rates(t: &[f64], y: &[f64], window: usize) -> Vec<f64> {
    let n = t.len();
    let half = (window / 2).max(1);
    (0..n)
        .map(|k| {
            let from = k.saturating_sub(half).min(n.saturating_sub(2 * half + 1));
            let to = (from + 2 * half).min(n - 1);
            // moments about the sample, in units of the window
            let unit = (t[to] - t[from]).max(f64::MIN_POSITIVE);
            let (mut s, mut m) = ([0.0; 5], [0.0; 3]);
            for j in from..=to {
                let x = (t[j] - t[k]) / unit;
                let mut power = 1.0;
                for (i, s) in s.iter_mut().enumerate() {
                    *s += power;
                    if i < 3 {
                        m[i] += power * (y[j] - y[k]);
                    }
                    power *= x;
                }
            }
            // Cramer's rule for the linear coefficient
            let det = |c: [[f64; 3]; 3]| {
                c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) - c[0][1] * (c[1][0] * c[2][2] - c[1][2] * c[2][0])
                    + c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0])
            };
            let whole = det([[s[0], s[1], s[2]], [s[1], s[2], s[3]], [s[2], s[3], s[4]]]);
            if whole.abs() < 1e-12 * s[0].powi(3) {
                return (y[to] - y[from]) / unit;
            }
            det([[s[0], m[0], s[2]], [s[1], m[1], s[3]], [s[2], m[2], s[4]]]) / whole / unit
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Butterworth, rates};
    use std::f64::consts::{PI, TAU};

    #[test]
    fn half_the_amplitude_at_the_cutoff_and_no_delay() {
        let filter = Butterworth::new(4, 0.1);
        let wave = |f: f64| (0..2000).map(|k| (TAU * f * f64::from(k) + 0.3).sin()).collect::<Vec<_>>();
        // forwards and backwards: 1/sqrt 2 twice
        for (f, gain) in [(0.1, 0.5), (0.01, 1.0 / (1.0 + ((PI * 0.01).tan() / (PI * 0.1).tan()).powi(8)))] {
            let (x, y) = (wave(f), filter.zero_phase(&wave(f), 200));
            let worst = (500..1500).map(|k| (y[k] - gain * x[k]).abs()).fold(0.0, f64::max);
            assert!(worst < 1e-6, "{f}: {worst}");
        }
        let constant = filter.zero_phase(&[3.0; 50], 20);
        assert!(constant.iter().all(|y| (y - 3.0).abs() < 1e-12));
    }

    #[test]
    fn rates_of_a_parabola_are_exact_up_to_its_ends() {
        let t: Vec<f64> = (0..30).map(|k| 0.1 * f64::from(k) + 0.01 * f64::from(k % 3)).collect();
        let y: Vec<f64> = t.iter().map(|t| 1.0 - 2.0 * t + 3.0 * t * t).collect();
        for (t, v) in t.iter().zip(rates(&t, &y, 7)) {
            assert!((v - (6.0 * t - 2.0)).abs() < 1e-9, "{t}: {v}");
        }
    }
}
