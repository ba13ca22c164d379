//! Fixed steps of the classical Runge-Kutta method of order 4, with the exact derivatives of the computed states.
//!
//! Each stage k = f(x, p) carries dk = A dx + df/dp, so that what comes out is the derivative of the numbers that come out,
//! not a second approximation: d x/d x0 and d x/d p for the fit of initial states and parameters. Steps end at every switch
//! of the signals and at every wanted time. Parameters that enter by delays only have zero columns: a delay moves switches.

use crate::error::SimError;
use crate::signals::{Segment, Signals, check_times};
use crate::simulate::{check, input_paths};
use crate::status::Status;
use runtime::Model;

/// States and their derivatives, one block for each time that was reached.
#[derive(Clone, Debug)]
pub struct Sensitivities {
    /// Times [s].
    pub t: Vec<f64>,
    /// States, times x states.
    pub x: Vec<f64>,
    /// d x/d x0, times x states x states.
    pub by_initial: Vec<f64>,
    /// d x/d p of the free parameters, times x states x free.
    pub by_parameters: Vec<f64>,
    /// How the run ended.
    pub status: Status,
    /// Up to this time the states are a solution [s].
    pub valid_until: f64,
}

/// Simulates with steps of at most `step` [s] and derivatives with respect to the initial state and to the parameters
/// whose indices are in `free`.
///
/// # Errors
/// [`SimError`] where the arguments are wrong.
pub fn simulate_fixed(
    model: &dyn Model,
    p: &[f64],
    x0: &[f64],
    signals: &Signals,
    times: &[f64],
    step: f64,
    free: &[usize],
) -> Result<Sensitivities, SimError> {
    check(model, p, x0, signals)?;
    check_times("times of the outputs", times)?;
    if !(step > 0.0 && step.is_finite()) {
        return Err(SimError::Option { what: "the step", value: step });
    }
    if let Some(&wrong) = free.iter().find(|&&i| i >= p.len()) {
        return Err(SimError::Length { what: "parameters", wanted: p.len(), found: wrong + 1 });
    }
    let paths = input_paths(model, p)?;
    let n = x0.len();
    let width = n + free.len();
    let mut run =
        Run { model, p, free, width, x: x0.to_vec(), s: vec![0.0; n * width], work: Work::new(n, width, signals.count(), p.len()) };
    (0..n).for_each(|i| run.s[i * width + i] = 1.0);
    let mut out = Sensitivities {
        t: Vec::new(),
        x: Vec::new(),
        by_initial: Vec::new(),
        by_parameters: Vec::new(),
        status: Status::Completed,
        valid_until: times[times.len() - 1],
    };
    run.write(times[0], &mut out);
    let mut next = 1;
    for segment in signals.segments(&paths, times[0], times[times.len() - 1]) {
        let mut from = segment.from;
        while from < segment.to {
            let to = times.get(next).copied().filter(|&t| t <= segment.to).unwrap_or(segment.to);
            // a remainder of rounding is no step of its own
            let count = ((to - from) / step * (1.0 - 1e-12)).ceil().max(1.0);
            let h = (to - from) / count;
            let mut k = 0.0;
            while k < count {
                let t = from + k * h;
                if let Err(status) = run.step(&segment, t, h) {
                    out.status = status;
                    out.valid_until = t;
                    return Ok(out);
                }
                k += 1.0;
            }
            if times.get(next) == Some(&to) {
                run.write(to, &mut out);
                next += 1;
            }
            from = to;
        }
    }
    Ok(out)
}

struct Run<'a> {
    model: &'a dyn Model,
    p: &'a [f64],
    free: &'a [usize],
    /// Columns of `s`: initial states, then free parameters.
    width: usize,
    x: Vec<f64>,
    s: Vec<f64>,
    work: Work,
}

/// Buffers of a step.
struct Work {
    u: Vec<f64>,
    stage: Vec<f64>,
    stage_s: Vec<f64>,
    k: Vec<f64>,
    a: Vec<f64>,
    b: Vec<f64>,
    dfdp: Vec<f64>,
    dk: Vec<f64>,
    sum: Vec<f64>,
    sum_s: Vec<f64>,
}

impl Work {
    fn new(n: usize, width: usize, signals: usize, parameters: usize) -> Self {
        Self {
            u: vec![0.0; signals],
            stage: vec![0.0; n],
            stage_s: vec![0.0; n * width],
            k: vec![0.0; n],
            a: vec![0.0; n * n],
            b: vec![0.0; n * signals],
            dfdp: vec![0.0; n * parameters],
            dk: vec![0.0; n * width],
            sum: vec![0.0; n],
            sum_s: vec![0.0; n * width],
        }
    }
}

impl Run<'_> {
    fn step(&mut self, segment: &Segment, t: f64, h: f64) -> Result<(), Status> {
        let w = &mut self.work;
        w.sum.fill(0.0);
        w.sum_s.fill(0.0);
        // (time and weight of the slope before) of each stage, weight in the sum
        for (c, weight) in [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
            let ahead = c * h;
            add(&self.x, ahead, &w.k, &mut w.stage);
            add(&self.s, ahead, &w.dk, &mut w.stage_s);
            let time = t + ahead;
            segment.at(time, &mut w.u);
            let singular = |s: runtime::Singular| Status::Singular { coordinate: self.model.names().state(s.coordinate).to_owned(), t };
            self.model.linearize(time, &w.stage, &w.u, self.p, &mut w.k, &mut w.a, &mut w.b).map_err(singular)?;
            if !self.free.is_empty() {
                self.model.parameter_jacobian(time, &w.stage, &w.u, self.p, &mut w.dfdp).map_err(singular)?;
            }
            let n = self.x.len();
            for i in 0..n {
                let row = &mut w.dk[i * self.width..(i + 1) * self.width];
                row.fill(0.0);
                for (column, &parameter) in self.free.iter().enumerate() {
                    row[n + column] = w.dfdp[i * self.p.len() + parameter];
                }
                for j in 0..n {
                    let slope = w.a[i * n + j];
                    if slope != 0.0 {
                        row.iter_mut().zip(&w.stage_s[j * self.width..(j + 1) * self.width]).for_each(|(d, s)| *d += slope * s);
                    }
                }
            }
            w.sum.iter_mut().zip(&w.k).for_each(|(sum, k)| *sum += weight * k);
            w.sum_s.iter_mut().zip(&w.dk).for_each(|(sum, k)| *sum += weight * k);
        }
        add(&self.x, h / 6.0, &w.sum, &mut w.stage);
        if let Some(i) = w.stage.iter().position(|x| !x.is_finite()) {
            return Err(Status::NotFinite { state: self.model.names().state(i).to_owned(), t });
        }
        add(&self.s, h / 6.0, &w.sum_s, &mut w.stage_s);
        std::mem::swap(&mut self.x, &mut w.stage);
        std::mem::swap(&mut self.s, &mut w.stage_s);
        Ok(())
    }

    fn write(&self, t: f64, out: &mut Sensitivities) {
        let n = self.x.len();
        out.t.push(t);
        out.x.extend_from_slice(&self.x);
        for row in self.s.chunks(self.width.max(1)) {
            out.by_initial.extend_from_slice(&row[..n]);
            out.by_parameters.extend_from_slice(&row[n..]);
        }
    }
}

/// out = x + h k; the first stage has h = 0, whatever k holds from before.
fn add(x: &[f64], h: f64, k: &[f64], out: &mut [f64]) {
    if h == 0.0 {
        out.copy_from_slice(x);
    } else {
        out.iter_mut().zip(x).zip(k).for_each(|((out, x), k)| *out = x + h * k);
    }
}
