//! What a linear loop does: its response to a step of a reference, and each loop's gain over frequency.
//!
//! The regulator is u = -K (x - r) - K_i z with z' = y - y_r, sampled: z(k+1) = z(k) + T (y - y_r).

use control::{Lqr, Plant, zero_order_hold};
use nalgebra::{Complex, DMatrix, DVector};

/// A loop, in continuous time or from sample to sample.
pub struct Loop {
    /// Plant and integrals without feedback.
    a: DMatrix<f64>,
    /// How inputs move them.
    b: DMatrix<f64>,
    /// The feedback: inputs x (plant states, integrals).
    k: DMatrix<f64>,
    /// The readings that are integrated: integrals x plant states, times the period where sampled.
    read: DMatrix<f64>,
    period: Option<f64>,
    plant_states: usize,
}

/// A response: times [s]; one row for each sample.
pub struct Response {
    /// Times [s].
    pub t: Vec<f64>,
    /// States of the plant.
    pub x: Vec<Vec<f64>>,
    /// Inputs.
    pub u: Vec<Vec<f64>>,
}

/// Gain of one loop, broken at its input with the others closed.
pub struct OpenLoop {
    /// Angular frequencies [rad/s].
    pub w: Vec<f64>,
    /// Magnitude.
    pub gain: Vec<f64>,
    /// Phase [deg], without jumps.
    pub phase: Vec<f64>,
    /// Least distance to -1.
    pub distance: f64,
    /// Where the magnitude passes 1 with the least phase margin: frequency [rad/s] and margin [deg].
    pub margin: Option<(f64, f64)>,
}

/// Samples of a response in continuous time.
const SAMPLES: usize = 400;
/// Most samples of a response.
const MOST: usize = 5000;
/// Frequencies.
const FREQUENCIES: usize = 240;

impl Loop {
    /// The loop of a regulator; `None` where the plant cannot be sampled at its period.
    pub fn new(plant: &Plant, found: &Lqr) -> Option<Self> {
        let n = plant.states.len();
        let kept = found.states.len() - found.integrals;
        let (a, b) = match found.period {
            Some(period) => zero_order_hold(&plant.a, &plant.b, period).ok()?,
            None => (plant.a.clone(), plant.b.clone()),
        };
        let mut read = DMatrix::zeros(found.integrals, n);
        for (i, name) in found.states[kept..].iter().enumerate() {
            let row = plant.reading(name.strip_suffix(".integral")?).ok()?;
            read.row_mut(i).copy_from(&row);
        }
        let read = read * found.period.unwrap_or(1.0);
        let order = n + found.integrals;
        let (mut all, mut inputs, mut k) =
            (DMatrix::zeros(order, order), DMatrix::zeros(order, b.ncols()), DMatrix::zeros(b.ncols(), order));
        all.view_mut((0, 0), (n, n)).copy_from(&a);
        all.view_mut((n, 0), (found.integrals, n)).copy_from(&read);
        if found.period.is_some() {
            all.view_mut((n, n), (found.integrals, found.integrals)).fill_with_identity();
        }
        inputs.view_mut((0, 0), (n, b.ncols())).copy_from(&b);
        for (j, name) in found.states.iter().enumerate() {
            let column = if j < kept { plant.states.iter().position(|s| s == name)? } else { n + j - kept };
            k.column_mut(column).copy_from(&found.k.column(j));
        }
        Some(Self { a: all, b: inputs, k, read, period: found.period, plant_states: n })
    }

    /// Response to a reference of `size` for one state, over about `length` [s]; u is that beyond u*.
    pub fn step(&self, state: usize, size: f64, length: f64) -> Option<Response> {
        let (order, n) = (self.a.nrows(), self.plant_states);
        let mut reference = DVector::zeros(order);
        reference[state] = size;
        let closed = &self.a - &self.b * &self.k;
        let mut push = &self.b * (&self.k * &reference);
        for i in 0..order - n {
            push[n + i] -= self.read[(i, state)] * size;
        }
        let push = DMatrix::from_column_slice(order, 1, push.as_slice());
        let (a, b, period) = match self.period {
            Some(period) => (closed, push, period),
            None => {
                let period = length / SAMPLES as f64;
                let (a, b) = zero_order_hold(&closed, &push, period).ok()?;
                (a, b, period)
            }
        };
        let samples = ((length / period).ceil() as usize).clamp(2, MOST);
        let mut x = DVector::zeros(order);
        let mut response = Response { t: Vec::new(), x: Vec::new(), u: Vec::new() };
        for k in 0..=samples {
            response.t.push(k as f64 * period);
            response.x.push(x.as_slice()[..n].to_vec());
            response.u.push((-(&self.k * (&x - &reference))).as_slice().to_vec());
            x = &a * &x + b.column(0);
            if x.iter().any(|v| !v.is_finite()) {
                break;
            }
        }
        Some(response)
    }

    /// The loop broken at one input, between two frequencies [rad/s].
    pub fn broken(&self, input: usize, (from, to): (f64, f64)) -> OpenLoop {
        let order = self.a.nrows();
        let mut others = self.k.clone();
        others.row_mut(input).fill(0.0);
        let a = (&self.a - &self.b * others).map(|v| Complex::new(v, 0.0));
        let b = self.b.column(input).map(|v| Complex::new(v, 0.0));
        let k = self.k.row(input).map(|v| Complex::new(v, 0.0));
        let mut out = OpenLoop { w: Vec::new(), gain: Vec::new(), phase: Vec::new(), distance: f64::INFINITY, margin: None };
        for i in 0..FREQUENCIES {
            let w = from * (to / from).powf(i as f64 / (FREQUENCIES - 1) as f64);
            let s = self.period.map_or(Complex::new(0.0, w), |period| Complex::new(0.0, w * period).exp());
            let Some(x) = (DMatrix::identity(order, order) * s - &a).lu().solve(&b) else { continue };
            let l = (&k * x)[(0, 0)];
            if !(l.re.is_finite() && l.im.is_finite()) {
                continue;
            }
            let mut phase = l.arg().to_degrees();
            if let Some(last) = out.phase.last() {
                phase += 360.0 * ((last - phase) / 360.0).round();
            }
            out.distance = out.distance.min((l + 1.0).norm());
            if let (Some(&gain), Some(&before)) = (out.gain.last(), out.phase.last()) {
                let gain: f64 = gain;
                if (gain > 1.0) != (l.norm() > 1.0) {
                    // between two frequencies, straight in the logarithm
                    let part = gain.ln() / (gain / l.norm()).ln();
                    let at: f64 = before + part * (phase - before);
                    let margin = (at + 180.0) - 360.0 * ((at + 180.0) / 360.0).round();
                    if out.margin.is_none_or(|m: (f64, f64)| margin.abs() < m.1.abs()) {
                        let last = out.w[out.w.len() - 1];
                        out.margin = Some((last * (w / last).powf(part), margin));
                    }
                }
            }
            out.w.push(w);
            out.gain.push(l.norm());
            out.phase.push(phase);
        }
        out
    }
}

/// Time in which a loop with these poles settles [s], and the frequencies at which it is looked at [rad/s].
pub fn spans(poles: &[Complex<f64>], period: Option<f64>) -> (f64, (f64, f64)) {
    let of_s: Vec<Complex<f64>> = poles.iter().filter(|z| z.norm() > 0.0).map(|z| period.map_or(*z, |period| z.ln() / period)).collect();
    let fastest = of_s.iter().map(|s| s.norm()).fold(0.0, f64::max);
    if fastest.is_nan() || fastest <= 0.0 {
        return (10.0, (0.1, 100.0));
    }
    // what barely moves does not decide how long is looked
    let slowest = of_s.iter().map(|s| s.re.abs()).filter(|r| *r > 1e-4 * fastest).fold(f64::INFINITY, f64::min).min(fastest);
    let to = period.map_or(30.0 * fastest, |period| std::f64::consts::PI / period);
    let from = (0.05 * slowest).min(0.01 * to);
    (6.0 / slowest, (from, to))
}

#[cfg(test)]
mod tests {
    use super::{Loop, spans};
    use control::{LqrDesign, Plant, Sampling, Weight, lqr};
    use nalgebra::DMatrix;

    fn integrator(sampling: Sampling, integrate: &[&str]) -> (Plant, control::Lqr) {
        // q'' = u
        let plant = Plant {
            states: vec!["q".to_owned(), "q.dot".to_owned()],
            inputs: vec!["u".to_owned()],
            outputs: vec!["q".to_owned()],
            a: DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 0.0, 0.0]),
            b: DMatrix::from_row_slice(2, 1, &[0.0, 1.0]),
            c: DMatrix::from_row_slice(1, 2, &[1.0, 0.0]),
        };
        let design = LqrDesign {
            states: Vec::new(),
            integrate: integrate.iter().map(|s| (*s).to_owned()).collect(),
            weight_x: Weight::Diagonal(vec![1.0; 2 + integrate.len()]),
            weight_u: Weight::Diagonal(vec![1.0]),
            sampling,
        };
        let found = lqr(&plant, &design).unwrap();
        (plant, found)
    }

    #[test]
    fn a_step_arrives() {
        for (sampling, integrate) in [
            (Sampling::Continuous, &[][..]),
            (Sampling::Continuous, &["q"][..]),
            (Sampling::Integral { period: 0.05 }, &[][..]),
            (Sampling::Sum { period: 0.05 }, &["q"][..]),
        ] {
            let (plant, found) = integrator(sampling, integrate);
            let closed = Loop::new(&plant, &found).unwrap();
            let (length, _) = spans(&found.poles, found.period);
            let step = closed.step(0, 2.0, 3.0 * length).unwrap();
            let (x, u) = (step.x.last().unwrap(), step.u.last().unwrap());
            assert!((x[0] - 2.0).abs() < 0.02 && x[1].abs() < 0.02 && u[0].abs() < 0.02, "{sampling:?} {integrate:?}: {x:?} {u:?}");
            assert!((step.u[0][0] - 2.0 * found.k[(0, 0)]).abs() < 1e-12, "at once the full error");
        }
    }

    #[test]
    fn margins_of_the_double_integrator() {
        // K = [1, sqrt 3]: L = (1 + sqrt(3) s)/s^2; |L| = 1 at w^2 = (3 + sqrt 13)/2, margin atan(sqrt(3) w)
        let (plant, found) = integrator(Sampling::Continuous, &[]);
        let broken = Loop::new(&plant, &found).unwrap().broken(0, (0.01, 100.0));
        let w = f64::sqrt((3.0 + f64::sqrt(13.0)) / 2.0);
        let (at, margin) = broken.margin.unwrap();
        assert!((at - w).abs() < 1e-3 * w, "{at} {w}");
        assert!((margin - (3.0_f64.sqrt() * w).atan().to_degrees()).abs() < 0.05, "{margin}");
        assert!(broken.distance > 0.999, "a regulator of least squares stays a distance of 1 from -1: {}", broken.distance);
    }
}
