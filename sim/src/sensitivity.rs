//! A run with a frozen pattern of steps and exact sensitivities: what fitting evaluates again and again.
//!
//! With x' = f(t, x, u, p) it carries S = dx/d(unknowns), S' = A S + df/dp, through the same Runge-Kutta steps, so that
//! the sensitivities are the derivatives of the computed trajectory itself. No step crosses a switch of an input; a step
//! may span many samples, which are then read from the method's polynomial. Delays are time shifts: an input's delay
//! moves its switches (the state's sensitivity jumps there by the difference of the slopes), an output's delay the time
//! at which the state is read. A reading behind a play keeps its derivative as long as it stands. The workspace is made
//! once; a step allocates nothing.

use crate::error::SimError;
use crate::output_path::{Contact, contact};
use crate::signals::{Path, Segment, Signals, check_times};
use crate::simulate::{check, checked, input_paths};
use crate::status::Status;
use crate::tableau::{FixedMethod, Tableau};
use runtime::{Model, OutputPath, Singular};

/// Which steps are taken: as few equal ones as keep each no longer than `step` between two switches of the inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pattern {
    /// FixedMethod.
    pub method: FixedMethod,
    /// Longest step [s].
    pub step: f64,
}

/// Where results go: sample, output, value, and the value's derivatives along the columns.
pub type Sink<'s> = dyn FnMut(usize, usize, f64, &[f64]) + 's;

/// Runs of one model over the same signals and times, with parameters and initial states that change.
pub struct Forward<'a> {
    model: &'a dyn Model,
    signals: &'a Signals,
    times: &'a [f64],
    pattern: Pattern,
    /// Outputs that are read.
    outputs: Vec<usize>,
    /// Parameters of the first columns of S.
    parameters: Vec<usize>,
    /// Columns of S.
    columns: usize,
    delays: Vec<Path>,
    segments: Vec<Segment>,
    reads: Vec<Read>,
    output_delays: Vec<f64>,
    /// How the outputs that are read leave.
    paths: Vec<OutputPath>,
    work: Workspace,
    steps: usize,
}

/// Output `outputs[output]` at time `t` is its value at sample `sample`.
#[derive(Clone, Copy, Debug)]
struct Read {
    t: f64,
    sample: usize,
    output: usize,
}

/// z = [x | S by rows]; k are derivatives of z.
struct Workspace {
    z: Vec<f64>,
    end: Vec<f64>,
    stage: Vec<f64>,
    /// State at the time of a reading.
    inside: Vec<f64>,
    /// A row of S at the time of a reading.
    row: Vec<f64>,
    /// Factors and rows of S whose sum is a row of A S.
    terms: Vec<(f64, usize)>,
    k: Vec<Vec<f64>>,
    /// Coefficients of the polynomial inside a step.
    poly: [Vec<f64>; 4],
    u: Vec<f64>,
    a: Vec<f64>,
    b: Vec<f64>,
    dfdp: Vec<f64>,
    model: Vec<f64>,
    dx: Vec<f64>,
    y: Vec<f64>,
    c: Vec<f64>,
    dhdp: Vec<f64>,
    dy: Vec<f64>,
    /// d(delay of signal i)/d(parameter of column j), signals x parameters.
    input_delay_slopes: Vec<f64>,
    /// The same for the outputs that are read.
    output_delay_slopes: Vec<f64>,
    plays: Plays,
}

/// What a play remembers, for each output that is read.
struct Plays {
    /// The last reading.
    readings: Vec<Option<f64>>,
    /// Its derivatives, outputs x columns.
    slopes: Vec<f64>,
    /// d(play)/d(parameter of column j), outputs x parameters.
    width_slopes: Vec<f64>,
    /// There is a play, or one of no width that a parameter can open.
    acts: Vec<bool>,
}

/// Where and why a run stopped.
struct Stop {
    t: f64,
    fault: Fault,
}

enum Fault {
    Singular(usize),
    NotFinite(usize),
}

impl<'a> Forward<'a> {
    /// Outputs `outputs` are read at `times` [s]. The sensitivities have one column for each of `parameters`, then `others`
    /// columns for unknowns that enter through the initial state only; none at all make a plain run.
    ///
    /// # Errors
    /// [`SimError`] where times do not increase, an index is out of range or the step is not positive.
    pub fn new(
        model: &'a dyn Model,
        signals: &'a Signals,
        times: &'a [f64],
        outputs: &[usize],
        parameters: &[usize],
        others: usize,
        pattern: Pattern,
    ) -> Result<Self, SimError> {
        let d = model.dimensions();
        check_times("times of the outputs", times)?;
        for (what, list, length) in [("outputs", outputs, d.outputs), ("parameters", parameters, d.parameters)] {
            if let Some(&index) = list.iter().find(|&&i| i >= length) {
                return Err(SimError::Length { what, wanted: length, found: index + 1 });
            }
        }
        if !(pattern.step > 0.0 && pattern.step.is_finite()) {
            return Err(SimError::Option { what: "the step", value: pattern.step });
        }
        let (n, columns) = (d.states(), parameters.len() + others);
        let size = n * (1 + columns);
        let stages = pattern.method.tableau().b.len() + 1;
        let zeros = |length: usize| vec![0.0; length];
        let work = Workspace {
            z: zeros(size),
            end: zeros(size),
            stage: zeros(size),
            inside: zeros(n),
            row: zeros(columns),
            terms: Vec::with_capacity(n),
            k: (0..stages).map(|_| zeros(size)).collect(),
            poly: std::array::from_fn(|_| zeros(size)),
            u: zeros(d.signals()),
            a: zeros(n * n),
            b: zeros(n * d.signals()),
            dfdp: zeros(n * parameters.len()),
            model: zeros(d.sensitivity_work()),
            dx: zeros(n),
            y: zeros(d.outputs),
            c: zeros(d.outputs * n),
            dhdp: zeros(d.outputs * d.parameters),
            dy: zeros(columns),
            input_delay_slopes: zeros(d.signals() * parameters.len()),
            output_delay_slopes: zeros(outputs.len() * parameters.len()),
            plays: Plays {
                readings: vec![None; outputs.len()],
                slopes: zeros(outputs.len() * columns),
                width_slopes: zeros(outputs.len() * parameters.len()),
                acts: vec![false; outputs.len()],
            },
        };
        Ok(Self {
            model,
            signals,
            times,
            pattern,
            outputs: outputs.to_vec(),
            parameters: parameters.to_vec(),
            columns,
            delays: Vec::new(),
            segments: Vec::new(),
            reads: Vec::new(),
            output_delays: Vec::new(),
            paths: Vec::new(),
            work,
            steps: 0,
        })
    }

    /// Columns of the sensitivities.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The steps.
    #[must_use]
    pub fn pattern(&self) -> Pattern {
        self.pattern
    }

    /// Steps of the last run.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// State at which the last run ended.
    #[must_use]
    pub fn state(&self) -> &[f64] {
        &self.work.z[..self.model.dimensions().states()]
    }

    /// Sensitivities of [`Forward::state`], states x columns.
    #[must_use]
    pub fn sensitivities(&self) -> &[f64] {
        &self.work.z[self.model.dimensions().states()..]
    }

    /// Runs from `x0` at the first time with the sensitivities `s0` (states x columns). `sink(k, i, y, dy)` is given the
    /// value of `outputs[i]` at `times[k]` and its derivative by each column, without encoder. Behind a play, the reading at the
    /// first time is in the middle.
    ///
    /// # Errors
    /// [`SimError`] where arguments are wrong. A run that ends early is no error, see [`Status`]; what was read up to then
    /// has been given.
    pub fn run(&mut self, p: &[f64], x0: &[f64], s0: &[f64], sink: &mut Sink<'_>) -> Result<Status, SimError> {
        check(self.model, p, x0, self.signals)?;
        let n = self.model.dimensions().states();
        if s0.len() != n * self.columns {
            return Err(SimError::Length { what: "initial sensitivities", wanted: n * self.columns, found: s0.len() });
        }
        self.lay_out(p)?;
        let segments = std::mem::take(&mut self.segments);
        let reads = std::mem::take(&mut self.reads);
        self.work.z[..n].copy_from_slice(x0);
        self.work.z[n..].copy_from_slice(s0);
        let ended = self.travel(p, &segments, &reads, sink);
        self.segments = segments;
        self.reads = reads;
        let names = self.model.names();
        Ok(match ended {
            Ok(()) => Status::Completed,
            Err(Stop { t, fault: Fault::Singular(i) }) => Status::Singular { coordinate: names.state(i).to_owned(), t },
            Err(Stop { t, fault: Fault::NotFinite(i) }) => Status::NotFinite { state: names.state(i).to_owned(), t },
        })
    }

    /// Segments and reads for the delays that these parameters give; made anew only where these have changed.
    fn lay_out(&mut self, p: &[f64]) -> Result<(), SimError> {
        let (start, end) = (self.times[0], self.times[self.times.len() - 1]);
        let paths = input_paths(self.model, p)?;
        if paths != self.delays || self.segments.is_empty() {
            self.segments = self.signals.segments(&paths, start, end);
            self.delays = paths;
        }
        self.paths.clear();
        for &i in &self.outputs {
            self.paths.push(checked(self.model.names().output(i), self.model.output_path(i, p))?);
        }
        let delays: Vec<f64> = self.paths.iter().map(|path| path.delay).collect();
        if delays != self.output_delays || self.reads.is_empty() {
            self.reads.clear();
            for (sample, &t) in self.times.iter().enumerate() {
                self.reads.extend(delays.iter().enumerate().map(|(output, delay)| Read { t: t - delay, sample, output }));
            }
            if delays.iter().any(|&d| d != delays[0]) {
                self.reads.sort_by(|a, b| a.t.total_cmp(&b.t));
            }
            self.output_delays = delays;
        }
        self.path_slopes(p);
        Ok(())
    }

    /// Derivatives of delays and plays. Each is nearly always a parameter itself, for which the difference is exact.
    fn path_slopes(&mut self, p: &[f64]) {
        let d = self.model.dimensions();
        let count = self.parameters.len();
        let mut shifted = p.to_vec();
        for (column, &j) in self.parameters.iter().enumerate() {
            let h = 1e-4 * p[j].abs().max(1e-3);
            let mut difference = |read: &dyn Fn(&[f64]) -> [f64; 2]| {
                shifted[j] = p[j] + h;
                let above = read(&shifted);
                shifted[j] = p[j] - h;
                let below = read(&shifted);
                shifted[j] = p[j];
                [0, 1].map(|k| if above[k] == below[k] { 0.0 } else { (above[k] - below[k]) / (2.0 * h) })
            };
            for i in 0..d.inputs {
                let [delay, _] = difference(&|p| [self.model.input_path(i, p).delay, 0.0]);
                self.work.input_delay_slopes[i * count + column] = delay;
            }
            for (r, &i) in self.outputs.iter().enumerate() {
                let [delay, play] = difference(&|p| {
                    let path = self.model.output_path(i, p);
                    [path.delay, path.play]
                });
                self.work.output_delay_slopes[r * count + column] = delay;
                self.work.plays.width_slopes[r * count + column] = play;
            }
        }
        self.work.plays.lay_out(&self.paths);
    }

    fn travel(&mut self, p: &[f64], segments: &[Segment], reads: &[Read], sink: &mut Sink<'_>) -> Result<(), Stop> {
        let tableau = self.pattern.method.tableau();
        let moving_switches = self.work.input_delay_slopes.iter().any(|&s| s != 0.0);
        let start = self.times[0];
        let mut next = 0;
        self.steps = 0;
        // what is read at the start, or before it because of a delay
        if let Some(first) = segments.first() {
            self.work.u.copy_from_slice(&first.values);
        }
        self.work.inside.copy_from_slice(&self.work.z[..self.model.dimensions().states()]);
        next = self.read(p, start, None, reads, next, sink)?;
        for (index, segment) in segments.iter().enumerate() {
            let length = segment.to - segment.from;
            if length <= 0.0 {
                continue;
            }
            if moving_switches && index > 0 {
                let before = &segments[index - 1];
                before.at(before.to, &mut self.work.u);
                self.jump(p, segment)?;
            }
            let count = (length / self.pattern.step - 1e-9).ceil().max(1.0);
            let h = length / count;
            segment.at(segment.from, &mut self.work.u);
            self.derivative(p, segment.from, segment, 0, moving_switches, Source::Start)?;
            let count = count as usize;
            for step in 0..count {
                let t = segment.from + h * step as f64;
                let last = step + 1 == count;
                let to = if last { segment.to } else { segment.from + h * (step + 1) as f64 };
                self.step(p, t, h, segment, tableau, moving_switches)?;
                self.steps += 1;
                let inside = reads.get(next).is_some_and(|r| r.t < to);
                if !last || inside {
                    segment.at(to, &mut self.work.u);
                    self.derivative(p, to, segment, tableau.b.len(), moving_switches, Source::End)?;
                }
                if inside {
                    self.polynomial(h, tableau);
                    while let Some(read) = reads.get(next).filter(|r| r.t < to) {
                        let part = (read.t - t) / h;
                        self.interpolate(part);
                        segment.at(read.t, &mut self.work.u);
                        next = self.read(p, read.t, Some(part), reads, next, sink)?;
                    }
                }
                std::mem::swap(&mut self.work.z, &mut self.work.end);
                self.work.k.swap(0, tableau.b.len());
                if reads.get(next).is_some_and(|r| r.t <= to) {
                    let n = self.work.inside.len();
                    self.work.inside.copy_from_slice(&self.work.z[..n]);
                    segment.at(to, &mut self.work.u);
                    next = self.read(p, to, None, reads, next, sink)?;
                }
            }
        }
        Ok(())
    }

    /// One step from z to `end`; stage 0 is there.
    fn step(&mut self, p: &[f64], t: f64, h: f64, segment: &Segment, tableau: &Tableau, moving: bool) -> Result<(), Stop> {
        for (s, (row, c)) in tableau.a.iter().zip(tableau.c).enumerate() {
            let w = &mut self.work;
            combine(&mut w.stage, &w.z, &w.k, row, h);
            let at = t + c * h;
            segment.at(at, &mut w.u);
            self.derivative(p, at, segment, s + 1, moving, Source::Stage)?;
        }
        let w = &mut self.work;
        combine(&mut w.end, &w.z, &w.k, tableau.b, h);
        let n = self.model.dimensions().states();
        match w.end[..n].iter().position(|x| !x.is_finite()) {
            Some(i) => Err(Stop { t, fault: Fault::NotFinite(i) }),
            None => Ok(()),
        }
    }

    /// Derivative of z, of a stage or of `end`, written to stage `to`.
    fn derivative(&mut self, p: &[f64], t: f64, segment: &Segment, to: usize, moving: bool, source: Source) -> Result<(), Stop> {
        let d = self.model.dimensions();
        let (n, coordinates, m) = (d.states(), d.coordinates, self.columns);
        let w = &mut self.work;
        let z = match source {
            Source::Start => &w.z,
            Source::Stage => &w.stage,
            Source::End => &w.end,
        };
        let (x, s) = z.split_at(n);
        let (dx, ds) = w.k[to].split_at_mut(n);
        let stop = |Singular { coordinate }| Stop { t, fault: Fault::Singular(coordinate) };
        if m == 0 {
            return self.model.rhs(t, x, &w.u, p, dx).map_err(stop);
        }
        self.model.sensitivities(t, x, &w.u, p, &self.parameters, dx, &mut w.a, &mut w.dfdp, &mut w.model).map_err(stop)?;
        // q' = v holds for the sensitivities as well
        let (ds_q, ds_rest) = ds.split_at_mut(coordinates * m);
        ds_q.copy_from_slice(&s[coordinates * m..2 * coordinates * m]);
        let count = self.parameters.len();
        for (i, row) in (coordinates..n).zip(ds_rest.chunks_exact_mut(m)) {
            let (by_parameters, others) = row.split_at_mut(count);
            by_parameters.copy_from_slice(&w.dfdp[i * count..(i + 1) * count]);
            others.fill(0.0);
            w.terms.clear();
            w.terms.extend(w.a[i * n..(i + 1) * n].iter().enumerate().filter(|(_, a)| **a != 0.0).map(|(j, &a)| (a, j * m)));
            accumulate(row, &w.terms, s);
        }
        if moving && segment.slopes.iter().any(|&s| s != 0.0) {
            // a signal that is straight and comes later by d is lower by slope d
            self.model.linearize(t, x, &w.u, p, &mut w.dx, &mut w.a, &mut w.b).map_err(stop)?;
            let signals = d.signals();
            for (i, row) in (coordinates..n).zip(ds_rest.chunks_exact_mut(m)) {
                for (k, slope) in segment.slopes.iter().enumerate() {
                    let effect = -w.b[i * signals + k] * slope;
                    let by = &w.input_delay_slopes[k * count..(k + 1) * count];
                    row.iter_mut().zip(by).for_each(|(r, by)| *r += effect * by);
                }
            }
        }
        Ok(())
    }

    /// A switch that comes later keeps the old slope longer: S jumps by (f before - f after) d(delay)/d(unknown).
    fn jump(&mut self, p: &[f64], segment: &Segment) -> Result<(), Stop> {
        let d = self.model.dimensions();
        let (n, m, count) = (d.states(), self.columns, self.parameters.len());
        let w = &mut self.work;
        let t = segment.from;
        let stop = |Singular { coordinate }| Stop { t, fault: Fault::Singular(coordinate) };
        // `u` holds the signals at the end of the segment before; they change one after the other
        let (x, s) = w.z.split_at_mut(n);
        for i in 0..d.signals() {
            if w.u[i] == segment.values[i] {
                continue;
            }
            self.model.rhs(t, x, &w.u, p, &mut w.dx).map_err(stop)?;
            w.u[i] = segment.values[i];
            let by = &w.input_delay_slopes[i * count..(i + 1) * count];
            if by.iter().all(|&b| b == 0.0) {
                continue;
            }
            let after = &mut w.stage[..n];
            self.model.rhs(t, x, &w.u, p, after).map_err(stop)?;
            for ((row, before), after) in s.chunks_exact_mut(m).zip(&w.dx).zip(after.iter()) {
                row.iter_mut().zip(by).for_each(|(s, by)| *s += (before - after) * by);
            }
        }
        Ok(())
    }

    /// Coefficients of the polynomial of the step from z to `end`.
    fn polynomial(&mut self, h: f64, tableau: &Tableau) {
        let w = &mut self.work;
        let last = tableau.b.len();
        let [r2, r3, r4, r5] = &mut w.poly;
        let ends = w.z.iter().zip(&w.end).zip(w.k[0].iter().zip(&w.k[last]));
        for (((r2, r3), r4), ((z, end), (first, last))) in r2.iter_mut().zip(r3).zip(r4).zip(ends) {
            *r2 = end - z;
            *r3 = h * first - *r2;
            *r4 = *r2 - h * last - *r3;
        }
        r5.fill(0.0);
        for (d, k) in tableau.d.iter().zip(&w.k).filter(|(d, _)| **d != 0.0) {
            r5.iter_mut().zip(k).for_each(|(r, k)| *r += h * d * k);
        }
    }

    /// State at `part` of the step after z, written to `inside`.
    fn interpolate(&mut self, part: f64) {
        let w = &mut self.work;
        inside(&mut w.inside, &w.z, &w.poly, 0, part);
    }

    /// Gives all reads from `next` on that are due at time t, where `inside` is the state: at `part` of the step after z, or at z itself.
    /// Returns the first that is not.
    fn read(&mut self, p: &[f64], t: f64, part: Option<f64>, reads: &[Read], mut next: usize, sink: &mut Sink<'_>) -> Result<usize, Stop> {
        let d = self.model.dimensions();
        let (n, m, count) = (d.states(), self.columns, self.parameters.len());
        let w = &mut self.work;
        let x = &w.inside;
        if reads.get(next).is_none_or(|r| r.t > t) {
            return Ok(next);
        }
        self.model.outputs(t, x, p, &mut w.y);
        if m > 0 {
            self.model.output_jacobian(t, x, p, &mut w.c, &mut w.dhdp);
        }
        while let Some(read) = reads.get(next).filter(|r| r.t <= t) {
            let i = self.outputs[read.output];
            if m > 0 {
                let (by_parameters, others) = w.dy.split_at_mut(count);
                for (dy, &j) in by_parameters.iter_mut().zip(&self.parameters) {
                    *dy = w.dhdp[i * d.parameters + j];
                }
                others.fill(0.0);
                // only the rows of S that the output sees are interpolated
                for (k, &c) in w.c[i * n..(i + 1) * n].iter().enumerate().filter(|(_, c)| **c != 0.0) {
                    let from = n + k * m;
                    let row = match part {
                        Some(part) => {
                            inside(&mut w.row, &w.z, &w.poly, from, part);
                            &w.row
                        }
                        None => &w.z[from..from + m],
                    };
                    w.dy.iter_mut().zip(row).for_each(|(dy, s)| *dy += c * s);
                }
                let slopes = &w.output_delay_slopes[read.output * count..(read.output + 1) * count];
                // read before the start: the initial state, whatever the delay
                if slopes.iter().any(|&s| s != 0.0) && read.t >= self.times[0] {
                    self.model
                        .rhs(t, x, &w.u, p, &mut w.dx)
                        .map_err(|Singular { coordinate }| Stop { t, fault: Fault::Singular(coordinate) })?;
                    let rate: f64 = w.c[i * n..(i + 1) * n].iter().zip(&w.dx).map(|(c, dx)| c * dx).sum();
                    w.dy.iter_mut().zip(slopes).for_each(|(dy, slope)| *dy -= rate * slope);
                }
            }
            let path = &self.paths[read.output];
            // the reads of one output come in the order of their samples, whatever other outputs' delays are
            let y = if w.plays.acts[read.output] { w.plays.read(path, read.output, w.y[i], &mut w.dy) } else { w.y[i] };
            sink(read.sample, read.output, y, &w.dy);
            next += 1;
        }
        Ok(next)
    }
}

impl Plays {
    /// Before a run: nothing is read yet.
    fn lay_out(&mut self, paths: &[OutputPath]) {
        self.readings.fill(None);
        let count = self.width_slopes.len() / self.readings.len().max(1);
        for (r, (acts, path)) in self.acts.iter_mut().zip(paths).enumerate() {
            *acts = path.play > 0.0 || self.width_slopes[r * count..(r + 1) * count].iter().any(|&slope| slope != 0.0);
        }
    }

    /// The reading of output `r` for its value y; `dy`, the derivative of y, becomes that of the reading.
    fn read(&mut self, path: &OutputPath, r: usize, y: f64, dy: &mut [f64]) -> f64 {
        let count = self.width_slopes.len() / self.readings.len();
        let by_width = &self.width_slopes[r * count..(r + 1) * count];
        let kept = &mut self.slopes[r * dy.len()..(r + 1) * dy.len()];
        let side = match contact(self.readings[r], y, path) {
            Contact::None(before) => {
                dy.copy_from_slice(kept);
                return before;
            }
            Contact::Below => -0.5,
            Contact::Above => 0.5,
            Contact::Middle => 0.0,
        };
        dy.iter_mut().zip(by_width).for_each(|(dy, width)| *dy += side * width);
        kept.copy_from_slice(dy);
        let reading = y + side * path.play;
        self.readings[r] = Some(reading);
        reading
    }
}

/// Of which vector a derivative is wanted.
#[derive(Clone, Copy)]
enum Source {
    Start,
    Stage,
    End,
}

/// out = the polynomial's entries from `from` on, at `part` of the step after z.
fn inside(out: &mut [f64], z: &[f64], poly: &[Vec<f64>; 4], from: usize, part: f64) {
    let (to, rest) = (from + out.len(), 1.0 - part);
    let [r2, r3, r4, r5] = poly.each_ref().map(|r| &r[from..to]);
    let low = z[from..to].iter().zip(r2).zip(r3);
    let high = r4.iter().zip(r5);
    for (out, (((z, r2), r3), (r4, r5))) in out.iter_mut().zip(low.zip(high)) {
        *out = z + part * (r2 + rest * (r3 + part * (r4 + rest * r5)));
    }
}

/// row += the sum of the rows of S that begin at these places, times their factors; four columns at a time, which stay in registers.
fn accumulate(row: &mut [f64], terms: &[(f64, usize)], s: &[f64]) {
    const WIDE: usize = 4;
    let mut blocks = row.chunks_exact_mut(WIDE);
    let mut at = 0;
    for block in &mut blocks {
        let mut sum: [f64; WIDE] = std::array::from_fn(|k| block[k]);
        for &(a, from) in terms {
            if let Some(column) = s.get(from + at..from + at + WIDE) {
                sum.iter_mut().zip(column).for_each(|(sum, s)| *sum += a * s);
            }
        }
        block.copy_from_slice(&sum);
        at += WIDE;
    }
    for (k, r) in blocks.into_remainder().iter_mut().enumerate() {
        *r = terms.iter().fold(*r, |sum, &(a, from)| sum + a * s[from + at + k]);
    }
}

/// out = z + h (weights of k).
fn combine(out: &mut [f64], z: &[f64], k: &[Vec<f64>], weights: &[f64], h: f64) {
    out.copy_from_slice(z);
    for (weight, k) in weights.iter().zip(k).filter(|(w, _)| **w != 0.0) {
        let weight = h * weight;
        out.iter_mut().zip(k).for_each(|(o, k)| *o += weight * k);
    }
}
