//! An experiment: commands, random pushes, and what the sensors wrote down.

use super::chance::Chance;
use super::motion::Motion;
use super::plant::Plant;
use super::{MOST, Row};
use std::f64::consts::TAU;

/// Steps of the integrator between two samples.
const FINER: usize = 16;

/// How a rig is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Excitation {
    /// Random levels, held for random times.
    Steps,
    /// Several sines with random phases.
    Sines,
    /// One sine that goes from slow to fast.
    Chirp,
}

/// What pushes a rig beside its commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pushes {
    /// Nothing.
    None,
    /// Ornstein-Uhlenbeck.
    Exponential,
    /// A damped resonance that noise drives.
    Band,
    /// Levels that change at random times.
    Levels,
}

/// An experiment.
#[derive(Clone, Debug)]
pub struct Experiment<'a> {
    /// Rig.
    pub plant: &'a Plant,
    /// Where it hangs.
    pub start: Row,
    /// Sampling period [s].
    pub period: f64,
    /// Samples.
    pub samples: usize,
    /// Command around which it is moved, and how far.
    pub command: [(f64, f64); MOST],
    /// Slowest and fastest command [Hz].
    pub band: (f64, f64),
    /// How.
    pub excitation: Excitation,
    /// Pushes, and their standard deviation on each coordinate.
    pub pushes: (Pushes, Row),
    /// A regulator, if the loop is closed.
    pub loop_: Option<Loop>,
}

/// Proportional and derivative feedback of each output, by input; the excitation moves the reference and a part of the command.
#[derive(Clone, Copy, Debug)]
pub struct Loop {
    /// Output that each input acts on.
    pub output: [usize; MOST],
    /// Gain of the error, and of its derivative, for each input.
    pub gain: [(f64, f64); MOST],
    /// How far the references go.
    pub reference: Row,
}

/// Samples of a record.
#[derive(Clone, Debug, Default)]
pub struct Samples {
    /// Time stamps [s].
    pub t: Vec<f64>,
    /// Measured, by output.
    pub y: Vec<Vec<f64>>,
    /// Commands, by input, each held until the next sample.
    pub u: Vec<Vec<f64>>,
    /// Root-mean-square rate of each coordinate, as it really was.
    pub rate: Row,
    /// Lowest and highest coordinates, as they really were.
    pub range: [(f64, f64); MOST],
}

/// Values of one signal in a record's time.
fn signal(kind: Excitation, band: (f64, f64), t: &[f64], chance: &mut Chance) -> Vec<f64> {
    let duration = t.last().copied().unwrap_or(0.0);
    match kind {
        Excitation::Steps => {
            let (mut value, mut until) = (0.0, 0.0);
            t.iter()
                .map(|&t| {
                    if t >= until {
                        until = t + chance.between(0.5 / band.1, 0.3 / band.0);
                        value = chance.between(-1.0, 1.0);
                    }
                    value
                })
                .collect()
        }
        Excitation::Sines => {
            let sines: Vec<(f64, f64)> = (0..8)
                .map(|k| (band.0 * (band.1 / band.0).powf((f64::from(k) + chance.uniform()) / 8.0), TAU * chance.uniform()))
                .collect();
            t.iter().map(|t| sines.iter().map(|(f, phase)| (TAU * f * t + phase).sin()).sum::<f64>() / 3.5).collect()
        }
        Excitation::Chirp => {
            let (ratio, phase) = ((band.1 / band.0).ln(), TAU * chance.uniform());
            t.iter().map(|t| (TAU * band.0 * duration / ratio * ((t / duration * ratio).exp() - 1.0) + phase).sin()).collect()
        }
    }
}

/// A random push that goes on.
struct Push {
    kind: Pushes,
    sd: f64,
    time: f64,
    x: [f64; 2],
    until: f64,
}

impl Push {
    fn next(&mut self, t: f64, h: f64, chance: &mut Chance) -> f64 {
        match self.kind {
            Pushes::None => return 0.0,
            Pushes::Exponential => {
                let decay = (-h / self.time).exp();
                self.x[0] = decay * self.x[0] + (1.0 - decay * decay).sqrt() * chance.normal();
            }
            Pushes::Band => {
                // x'' + 2 d w x' + w^2 x = sqrt(4 d w^3) noise has variance one
                let (w, d) = (TAU / (4.0 * self.time), 0.2);
                let white = chance.normal() * (4.0 * d * w.powi(3) / h).sqrt();
                self.x[1] += h * (white - 2.0 * d * w * self.x[1] - w * w * self.x[0]);
                self.x[0] += h * self.x[1];
            }
            Pushes::Levels => {
                if t >= self.until {
                    self.until = t - 2.0 * self.time * (1.0 - chance.uniform()).ln();
                    self.x[0] = chance.normal();
                }
            }
        }
        self.sd * self.x[0]
    }
}

impl Experiment<'_> {
    /// Runs it.
    #[must_use]
    pub fn run(&self, seed: u64) -> Samples {
        let n = self.plant.mechanics.coordinates();
        let inputs = self.command.iter().take_while(|c| c.1 > 0.0).count();
        let mut chance = Chance::new(seed, "experiment");
        // a computer samples a little early or late, and notes when
        let mut t: Vec<f64> = (0..self.samples)
            .map(|k| {
                let early = if k == 0 { 0.0 } else { chance.between(-0.02, 0.02) };
                ((k as f64 + early) * self.period * 1e6).round() / 1e6
            })
            .collect();
        t.push(self.samples as f64 * self.period);
        let wanted: Vec<Vec<f64>> = (0..inputs).map(|_| signal(self.excitation, self.band, &t, &mut chance)).collect();
        let references: Vec<Vec<f64>> =
            (0..inputs).map(|_| signal(self.excitation, (self.band.0, 0.3 * self.band.1), &t, &mut chance)).collect();
        let mut pushes: Vec<Push> = (0..n)
            .map(|i| Push {
                kind: self.pushes.0,
                sd: self.pushes.1[i],
                time: 0.05 * 20_f64.powf(chance.uniform()),
                x: [0.0; 2],
                until: 0.0,
            })
            .collect();
        for push in &mut pushes {
            push.x[0] = chance.normal();
        }

        let mut motion = Motion::new(self.plant, self.start);
        let mut out = Samples {
            y: vec![Vec::new(); n],
            u: vec![Vec::new(); inputs],
            range: [(f64::INFINITY, f64::NEG_INFINITY); MOST],
            ..Samples::default()
        };
        // what sensors have to show: for delays
        let mut seen: Vec<(f64, Row)> = vec![(0.0, self.start)];
        let mut acted = [0.0; MOST];
        let mut squares = [0.0; MOST];
        for j in 0..inputs {
            acted[j] = self.plant.paths[j].asked(0.0, self.command[j].0);
        }
        // springs behind actuators begin settled
        let mut bent: [(f64, f64); MOST] = acted.map(|u| (u, 0.0));
        let mut before: Option<Row> = None;
        for k in 0..self.samples {
            let y = self.measure(t[k], &seen, n, &mut chance);
            for j in 0..inputs {
                let (mean, reach) = self.command[j];
                let mut u = mean + reach * wanted[j][k];
                if let Some(regulator) = &self.loop_ {
                    let o = regulator.output[j];
                    let rate = before.map_or(0.0, |b| (y[o] - b[o]) / self.period);
                    let error = self.start[o] + regulator.reference[j] * references[j][k] - y[o];
                    u = mean + 0.15 * reach * wanted[j][k] + regulator.gain[j].0 * error - regulator.gain[j].1 * rate;
                    u = u.clamp(mean - 2.5 * reach, mean + 2.5 * reach);
                }
                out.u[j].push(u);
            }
            before = Some(y);
            (0..n).for_each(|i| out.y[i].push(y[i]));
            let h = (t[k + 1] - t[k]) / FINER as f64;
            for s in 0..FINER {
                let now = t[k] + s as f64 * h;
                for j in 0..inputs {
                    let path = &self.plant.paths[j];
                    let at = now + 0.5 * h;
                    let asked = path.asked(at, held(&t, &out.u[j], at - path.delay, self.command[j].0));
                    if path.lag > 0.0 {
                        // its value in the middle of the step
                        let decay = (-0.5 * h / path.lag).exp();
                        let middle = asked + (acted[j] - asked) * decay;
                        acted[j] = middle;
                    } else {
                        acted[j] = asked;
                    }
                }
                let mut acts = acted;
                for (j, path) in self.plant.paths.iter().enumerate().take(inputs) {
                    if let Some(spring) = &path.compliance {
                        let middle = spring.bend(bent[j], acted[j], 0.5 * h);
                        acts[j] = spring.acts(acted[j], middle.0);
                        bent[j] = spring.bend(middle, acted[j], 0.5 * h);
                    }
                }
                let pushed: Row = std::array::from_fn(|i| pushes.get_mut(i).map_or(0.0, |p| p.next(now, h, &mut chance)));
                motion.advance(h, &acts, &pushed);
                for (j, path) in self.plant.paths.iter().enumerate().take(inputs).filter(|(_, p)| p.lag > 0.0) {
                    let asked = path.asked(now + h, held(&t, &out.u[j], now + 0.999 * h - path.delay, self.command[j].0));
                    acted[j] = asked + (acted[j] - asked) * (-0.5 * h / path.lag).exp();
                }
                // sensors with play are pulled along
                let last = seen.last().map_or(self.start, |(_, q)| *q);
                let pulled: Row = std::array::from_fn(|i| {
                    let (q, half) = (motion.state.q[i], 0.5 * self.plant.sensors.get(i).map_or(0.0, |s| s.play));
                    last[i].clamp(q - half, q + half)
                });
                seen.push((now + h, pulled));
                for i in 0..n {
                    squares[i] += motion.state.v[i].powi(2);
                    out.range[i] = (out.range[i].0.min(motion.state.q[i]), out.range[i].1.max(motion.state.q[i]));
                }
            }
        }
        t.pop();
        out.t = t;
        out.rate = squares.map(|s| (s / (self.samples * FINER).max(1) as f64).sqrt());
        out
    }

    /// What sensors show at a time, of what was seen until then.
    fn measure(&self, t: f64, seen: &[(f64, Row)], n: usize, chance: &mut Chance) -> Row {
        std::array::from_fn(|i| {
            if i >= n {
                return 0.0;
            }
            let sensor = &self.plant.sensors[i];
            let q = at(seen, t - sensor.delay);
            let mut y = q[i];
            if let Some((other, share)) = sensor.misaligned {
                y += share * q[other];
            }
            y = (1.0 + sensor.scale) * y + sensor.bias + sensor.drift * t + sensor.noise * chance.normal();
            if sensor.quantum > 0.0 { (y / sensor.quantum).round() * sensor.quantum } else { y }
        })
    }
}

/// The command that was held at a time; before the first sample the one at rest.
fn held(t: &[f64], u: &[f64], at: f64, rest: f64) -> f64 {
    let known = &t[..u.len()];
    match known.partition_point(|t| *t <= at) {
        0 => rest,
        k => u[k - 1],
    }
}

/// Coordinates at a time, between two that were seen.
fn at(seen: &[(f64, Row)], t: f64) -> Row {
    let k = seen.partition_point(|(s, _)| *s <= t);
    if k == 0 {
        return seen[0].1;
    }
    if k == seen.len() {
        return seen[k - 1].1;
    }
    let ((t0, a), (t1, b)) = (seen[k - 1], seen[k]);
    let w = (t - t0) / (t1 - t0);
    std::array::from_fn(|i| a[i] + w * (b[i] - a[i]))
}
