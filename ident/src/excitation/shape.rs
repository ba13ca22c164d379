//! Shapes of an excitation, each input between -1 and 1.

use std::f64::consts::{PI, TAU};

/// What an input looks like.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shape {
    /// A sum of sines; each input has lines of its own, so that the inputs can be told apart.
    #[default]
    Multisine,
    /// Each input in turn: steps up and down, then a sweep of the frequency.
    Steps,
}

/// Series for all inputs, and their description.
#[derive(Clone, Debug)]
pub struct Plan {
    /// One series for each input, largest value 1.
    pub series: Vec<Vec<f64>>,
    /// In words.
    pub words: String,
}

/// Lines of a multisine for each input.
const LINES: usize = 8;
/// Sets of phases that are tried: the flattest one is taken.
const TRIES: usize = 30;

/// Plans series at times `t` within `band` [Hz].
#[must_use]
pub fn plan(shape: Shape, t: &[f64], inputs: usize, band: (f64, f64), seed: u64) -> Plan {
    match shape {
        Shape::Multisine => multisine(t, inputs, band, seed),
        Shape::Steps => steps(t, inputs, band),
    }
}

fn multisine(t: &[f64], inputs: usize, band: (f64, f64), seed: u64) -> Plan {
    let duration = t.last().copied().unwrap_or(1.0);
    // lines are whole periods of the record, spread evenly over the logarithm of the frequency, dealt out in turn
    let (lo, hi) = ((band.0 * duration).max(1.0), (band.1 * duration).max(2.0));
    let wanted = LINES * inputs;
    let mut lines: Vec<f64> = Vec::new();
    for k in 0..wanted {
        let line = (lo * (hi / lo).powf(k as f64 / (wanted.max(2) - 1) as f64)).round();
        let free = lines.last().map_or(line, |last| line.max(last + 1.0));
        if free <= hi.round().max((lo.round() + wanted as f64).min(2.0 * hi)) {
            lines.push(free);
        }
    }
    let mut random = Phases(seed);
    let series = (0..inputs)
        .map(|i| {
            let own: Vec<f64> = lines.iter().skip(i).step_by(inputs).copied().collect();
            (0..TRIES)
                .map(|_| {
                    let phases: Vec<f64> = own.iter().map(|_| TAU * random.next()).collect();
                    let wave = |t: f64| own.iter().zip(&phases).map(|(n, phase)| (TAU * n * t / duration + phase).sin()).sum::<f64>();
                    let mut values: Vec<f64> = t.iter().map(|&t| fade(t, duration) * wave(t)).collect();
                    bring_home(t, &mut values);
                    let peak = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                    (peak, values)
                })
                .min_by(|a, b| a.0.total_cmp(&b.0))
                .map(|(peak, values)| values.iter().map(|v| v / peak.max(f64::MIN_POSITIVE)).collect())
                .unwrap_or_default()
        })
        .collect();
    let (first, last) = (lines.first().copied().unwrap_or(0.0) / duration, lines.last().copied().unwrap_or(0.0) / duration);
    let each = if inputs == 1 { String::new() } else { ", dealt out to the inputs in turn".to_owned() };
    Plan {
        series,
        words: format!(
            "multisine: {} lines from {first:.3} to {last:.3} Hz{each}, faded in, without drift, phases by seed {seed}",
            lines.len()
        ),
    }
}

/// Takes out what would leave an axis without spring and friction turning, or elsewhere, at the end: makes both integrals
/// of the series vanish, by a hump and a sine of one period.
fn bring_home(t: &[f64], values: &mut [f64]) {
    let duration = t.last().copied().unwrap_or(1.0);
    let integrals = |f: &dyn Fn(usize) -> f64| {
        let (mut rate, mut place) = (0.0, 0.0);
        for k in 1..t.len() {
            let dt = t[k] - t[k - 1];
            place += dt * (rate + 0.5 * dt * f(k - 1));
            rate += dt * f(k - 1);
        }
        (rate, place)
    };
    let hump = |k: usize| 1.0 - (TAU * t[k] / duration).cos();
    let sine = |k: usize| (TAU * t[k] / duration).sin();
    let (own, by_hump, by_sine) = (integrals(&|k| values[k]), integrals(&hump), integrals(&sine));
    let det = by_hump.0 * by_sine.1 - by_sine.0 * by_hump.1;
    if det.abs() < f64::MIN_POSITIVE {
        return;
    }
    let a = (own.0 * by_sine.1 - by_sine.0 * own.1) / det;
    let b = (by_hump.0 * own.1 - own.0 * by_hump.1) / det;
    for (k, v) in values.iter_mut().enumerate() {
        *v -= a * hump(k) + b * sine(k);
    }
}

/// From 0 to 1 over the first twentieth: no jump at the start.
fn fade(t: f64, duration: f64) -> f64 {
    let s = (20.0 * t / duration).min(1.0);
    0.5 * (1.0 - (PI * s).cos())
}

fn steps(t: &[f64], inputs: usize, band: (f64, f64)) -> Plan {
    let duration = t.last().copied().unwrap_or(1.0);
    let part = duration / inputs as f64;
    let (lo, hi) = band;
    let series = (0..inputs)
        .map(|i| {
            t.iter()
                .map(|&t| {
                    let s = t - i as f64 * part;
                    // rest, up, down, rest; then the sweep
                    let half = 0.5 * part;
                    match s {
                        s if s < 0.05 * part || s >= part => 0.0,
                        s if s < 0.2 * part => 1.0,
                        s if s < 0.35 * part => -1.0,
                        s if s < half => 0.0,
                        s => {
                            let rate = (hi / lo).ln() / half;
                            (TAU * lo * ((rate * (s - half)).exp() - 1.0) / rate).sin()
                        }
                    }
                })
                .collect()
        })
        .collect();
    let each = if inputs == 1 { String::new() } else { format!("each of the {inputs} inputs in turn, ") };
    Plan { series, words: format!("{each}steps up and down, then a sweep from {lo:.3} to {hi:.3} Hz") }
}

/// Numbers in 0 .. 1 (SplitMix64).
struct Phases(u64);

impl Phases {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::{Shape, plan};

    #[test]
    fn within_one_and_apart_from_each_other() {
        let t: Vec<f64> = (0..=3000).map(|k| 0.01 * f64::from(k)).collect();
        for shape in [Shape::Multisine, Shape::Steps] {
            let p = plan(shape, &t, 2, (0.1, 2.0), 3);
            for s in &p.series {
                let peak = s.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                assert!(s[0] == 0.0 && peak <= 1.0 + 1e-12 && peak > 0.99, "{shape:?}: {peak}");
            }
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let (a, b) = (&p.series[0], &p.series[1]);
            assert!(dot(a, b).abs() < 0.1 * (dot(a, a) * dot(b, b)).sqrt(), "{shape:?}");
        }
        assert_ne!(plan(Shape::Multisine, &t, 1, (0.1, 2.0), 3).series, plan(Shape::Multisine, &t, 1, (0.1, 2.0), 4).series);
    }
}
