//! A whole run: signals through the input path, the differential equation, outputs through the output path.

use crate::error::SimError;
use crate::integrate::{Control, Fault, Integrator, Method, Stop};
use crate::output_path::{encoder, play};
use crate::signals::{Path, Signals, check_times};
use crate::status::Status;
use runtime::{Model, OutputPath};

/// Choices of a run.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Relative error of a step.
    pub relative: f64,
    /// Absolute error of a step, in the SI unit of each state.
    pub absolute: f64,
    /// Steps after which a run is given up, rejected ones included.
    pub max_steps: usize,
    /// Which method integrates.
    pub method: Method,
    /// Show outputs as their encoders do: in counts, and wrapped where they are.
    pub encoders: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { relative: 1e-10, absolute: 1e-12, max_steps: 1_000_000, method: Method::Auto, encoders: false }
    }
}

/// What a run gave: one row for each time that was reached.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// Times [s].
    pub t: Vec<f64>,
    /// States, times x states.
    pub x: Vec<f64>,
    /// Outputs, times x outputs.
    pub y: Vec<f64>,
    /// How the run ended.
    pub status: Status,
    /// Up to this time the trajectory is a solution [s].
    pub valid_until: f64,
    /// Steps taken, rejected ones included.
    pub steps: usize,
}

impl Trajectory {
    /// State at time k.
    #[must_use]
    pub fn state(&self, k: usize) -> &[f64] {
        row(&self.x, self.t.len(), k)
    }

    /// Outputs at time k.
    #[must_use]
    pub fn outputs(&self, k: usize) -> &[f64] {
        row(&self.y, self.t.len(), k)
    }

    /// Output i over time.
    #[must_use]
    pub fn output(&self, i: usize) -> Vec<f64> {
        (0..self.t.len()).filter_map(|k| self.outputs(k).get(i).copied()).collect()
    }
}

fn row(values: &[f64], rows: usize, k: usize) -> &[f64] {
    let width = values.len().checked_div(rows).unwrap_or(0);
    values.get(k * width..(k + 1) * width).unwrap_or(&[])
}

/// Simulates from the state `x0` at `times[0]` and returns states and outputs at all `times` [s].
///
/// Inputs are clipped to their limits and delayed; before its first sample an input holds that sample. Exogenous signals
/// (accelerations of prescribed coordinates) enter as they are. Outputs before `times[0]` + delay show the initial state.
/// An output behind a play is read at `times` and nowhere else: a motion to and fro between two of them does not move the reading.
///
/// # Errors
/// [`SimError`] where the arguments are wrong. A run that ends early is no error: see [`Trajectory::status`].
pub fn simulate(
    model: &dyn Model,
    p: &[f64],
    x0: &[f64],
    signals: &Signals,
    times: &[f64],
    options: &Options,
) -> Result<Trajectory, SimError> {
    let d = model.dimensions();
    let names = model.names();
    check(model, p, x0, signals)?;
    check_times("times of the outputs", times)?;
    for (what, value) in [("the relative tolerance", options.relative), ("the absolute tolerance", options.absolute)] {
        if !(value > 0.0 && value.is_finite()) {
            return Err(SimError::Option { what, value });
        }
    }
    let paths = input_paths(model, p)?;
    let outs = (0..d.outputs).map(|i| checked(names.output(i), model.output_path(i, p))).collect::<Result<Vec<OutputPath>, _>>()?;

    // the states that outputs need: at the times, and a delay earlier
    let start = times[0];
    let mut grid: Vec<f64> = times.to_vec();
    for path in outs.iter().filter(|path| path.delay > 0.0) {
        grid.extend(times.iter().map(|t| t - path.delay).filter(|t| *t > start));
    }
    grid.sort_by(f64::total_cmp);
    grid.dedup();

    let n = d.states();
    let end = times[times.len() - 1];
    let mut states = x0.to_vec();
    let mut x = x0.to_vec();
    let control = Control { relative: options.relative, absolute: options.absolute, max_steps: options.max_steps };
    let mut integrator = Integrator { model, p, control, method: options.method, h: 0.0, steps: 0, stiff: 0 };
    let mut status = Status::Completed;
    for segment in signals.segments(&paths, start, end) {
        let from = grid.partition_point(|&t| t <= segment.from);
        let to = grid.partition_point(|&t| t <= segment.to);
        let ended = integrator.run(&segment, &mut x, &grid[from..to], &mut |_, x| states.extend_from_slice(x));
        if let Err((t, stop)) = ended {
            status = match (stop, vanished(model, p, (start, x0), (t, &x))) {
                (Stop::TooManySteps, _) => Status::TooManySteps { t, steps: integrator.steps },
                (Stop::Fault(Fault::Singular(i)), _) | (_, Some(i)) => Status::Singular { coordinate: names.state(i).to_owned(), t },
                (Stop::Fault(Fault::NotFinite(i)), _) => Status::NotFinite { state: names.state(i).to_owned(), t },
                (Stop::Collapsed | Stop::Stiff, _) => {
                    match (0..n).filter(|&i| x[i].abs() > f64::MAX.sqrt()).max_by(|&i, &j| x[i].abs().total_cmp(&x[j].abs())) {
                        // error norms square the states
                        Some(i) => Status::NotFinite { state: names.state(i).to_owned(), t },
                        None => Status::StepCollapsed { t },
                    }
                }
            };
            break;
        }
    }

    let reached = states.len() / n.max(1);
    let state_at = |t: f64| {
        let k = grid.partition_point(|&g| g <= t).max(1) - 1;
        &states[k * n..(k + 1) * n]
    };
    let valid_until = status.time().unwrap_or(end);
    let mut out = Trajectory { t: Vec::new(), x: Vec::new(), y: Vec::new(), status, valid_until, steps: integrator.steps };
    let mut y = vec![0.0; d.outputs];
    let mut readings: Vec<Option<f64>> = vec![None; d.outputs];
    let last = if n == 0 { end } else { grid[reached - 1] };
    for &t in times.iter().take_while(|&&t| t <= last) {
        let now = state_at(t);
        out.t.push(t);
        out.x.extend_from_slice(now);
        let at = out.y.len();
        model.outputs(t, now, p, &mut y);
        out.y.extend_from_slice(&y);
        for (i, path) in outs.iter().enumerate() {
            if path.delay > 0.0 {
                let earlier = (t - path.delay).max(start);
                model.outputs(earlier, state_at(earlier), p, &mut y);
                out.y[at + i] = y[i];
            }
            out.y[at + i] = play(readings[i], out.y[at + i], path);
            readings[i] = Some(out.y[at + i]);
            if options.encoders {
                out.y[at + i] = encoder(out.y[at + i], path);
            }
        }
    }
    Ok(out)
}

/// The coordinate whose pivot of the mass matrix has all but vanished between the beginning and the end of a run. On the
/// way to a singular mass matrix accelerations grow without bound, so that steps collapse before the pivot is zero.
fn vanished(model: &dyn Model, p: &[f64], begin: (f64, &[f64]), end: (f64, &[f64])) -> Option<usize> {
    const VANISHED: f64 = 1e-6;
    let n = model.dimensions().coordinates;
    let (mut before, mut after) = (vec![0.0; n], vec![0.0; n]);
    let known = model.pivots(begin.0, begin.1, p, &mut before) && model.pivots(end.0, end.1, p, &mut after);
    // a pivot that vanishes spoils those of earlier coordinates
    (0..n).rev().filter(|_| known).find(|&k| after[k] < VANISHED * before[k])
}

/// Lengths and finiteness of what every kind of run takes.
pub(crate) fn check(model: &dyn Model, p: &[f64], x0: &[f64], signals: &Signals) -> Result<(), SimError> {
    let d = model.dimensions();
    let names = model.names();
    for (what, wanted, found) in
        [("parameters", d.parameters, p.len()), ("initial states", d.states(), x0.len()), ("signals", d.signals(), signals.count())]
    {
        if wanted != found {
            return Err(SimError::Length { what, wanted, found });
        }
    }
    if let Some(i) = p.iter().position(|p| !p.is_finite()) {
        return Err(SimError::NotFinite { what: format!("parameter {}", names.parameter(i)) });
    }
    if let Some(i) = x0.iter().position(|x| !x.is_finite()) {
        return Err(SimError::NotFinite { what: format!("the initial value of {}", names.state(i)) });
    }
    Ok(())
}

/// How each signal enters: limits and delay; exogenous signals have none.
///
/// # Errors
/// [`SimError::Delay`] where a delay is negative or not finite.
pub fn input_paths(model: &dyn Model, p: &[f64]) -> Result<Vec<Path>, SimError> {
    let d = model.dimensions();
    (0..d.signals())
        .map(|i| {
            if i >= d.inputs {
                return Ok(Path { limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0 });
            }
            let path = model.input_path(i, p);
            if !(path.delay >= 0.0 && path.delay.is_finite()) {
                return Err(SimError::Delay { of: model.names().signal(i).to_owned(), value: path.delay });
            }
            Ok(Path { limits: path.limits, delay: path.delay })
        })
        .collect()
}

/// The path of an output, if there can be such a one.
pub(crate) fn checked(of: &str, path: OutputPath) -> Result<OutputPath, SimError> {
    let possible = |x: f64| x >= 0.0 && x.is_finite();
    if !possible(path.delay) {
        return Err(SimError::Delay { of: of.to_owned(), value: path.delay });
    }
    if !possible(path.play) {
        return Err(SimError::Play { of: of.to_owned(), value: path.play });
    }
    Ok(path)
}
