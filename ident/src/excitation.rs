//! A first input for a rig: within its limits, about an operating point, over the band in which the rig moves; and what a
//! record of it would tell.
//!
//! The size is found by simulating: the largest with which every coordinate stays within its bounds. The standard errors are
//! those of the Fisher information of the outputs along that run, with the initial state unknown too, for a model that is
//! right and noise of the encoders alone: a real record tells less.

mod information;
mod shape;

pub use information::{Predicted, predict};
pub use shape::{Plan, Shape, plan};

use runtime::Model;
use sim::{Hold, Signal, Signals, SimError, Status, simulate};
use std::fmt;

/// What is asked for.
#[derive(Clone, Debug)]
pub struct Request {
    /// State about which the rig is excited.
    pub x: Vec<f64>,
    /// Signals there.
    pub u: Vec<f64>,
    /// Length [s].
    pub duration: f64,
    /// Samples per second.
    pub rate: f64,
    /// Shape.
    pub shape: Shape,
    /// Lowest and highest frequency [Hz].
    pub band: (f64, f64),
    /// For each coordinate how far it may go below and above the point; infinite where anywhere.
    pub within: Vec<(f64, f64)>,
    /// Seed of the phases.
    pub seed: u64,
}

/// A proposal.
#[derive(Clone, Debug)]
pub struct Excitation {
    /// Time stamps [s].
    pub t: Vec<f64>,
    /// One series for each signal.
    pub inputs: Vec<Vec<f64>>,
    /// Largest deviation of each signal from the point.
    pub amplitude: Vec<f64>,
    /// Least and largest value of each coordinate in the simulated run.
    pub excursion: Vec<(f64, f64)>,
    /// What keeps the input from being larger: an input (at nine tenths of its room) or a coordinate.
    pub limited_by: String,
    /// What the shape consists of, in words.
    pub words: String,
    /// What it would tell of the free parameters.
    pub predicted: Vec<Predicted>,
}

/// Why there is no proposal.
#[derive(Clone, Debug, PartialEq)]
pub enum ExciteError {
    /// A number that must be positive is not, or the samples are too few or too many.
    Request {
        /// What is wrong, as a sentence.
        why: String,
    },
    /// An input has no room about the point.
    NoRoom {
        /// Input.
        input: String,
        /// Its value there.
        value: f64,
        /// Its limits.
        limits: (f64, f64),
    },
    /// A coordinate leaves its bounds without any excitation at all.
    Leaves {
        /// Coordinate.
        coordinate: String,
        /// When [s].
        after: f64,
        /// Bounds (SI).
        bounds: (f64, f64),
    },
    /// The simulation's arguments are wrong.
    Simulation(SimError),
}

impl fmt::Display for ExciteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Request { why } => f.write_str(why),
            Self::NoRoom { input, value, limits } => write!(
                f,
                "`{input}` is {value:.4} at this point, at a limit of {} .. {}: there is no room to move it; choose another point with --trim or --at",
                limits.0, limits.1
            ),
            Self::Leaves { coordinate, after, bounds } => write!(
                f,
                "`{coordinate}` leaves {:.3} .. {:.3} after {after:.2} s even with inputs of next to nothing: the point is unstable or drifts; choose another point with --trim or --at, wider bounds with --within, a shorter --duration, or excite the rig in closed loop",
                bounds.0, bounds.1
            ),
            Self::Simulation(e) => e.fmt(f),
        }
    }
}

impl std::error::Error for ExciteError {}

/// Room of an input that is used.
const ROOM: f64 = 0.9;

/// Proposes an input; `free` are the parameters that a fit of the record would free.
///
/// # Errors
/// [`ExciteError`], one variant a cause.
pub fn propose(model: &dyn Model, p: &[f64], free: &[usize], request: &Request) -> Result<Excitation, ExciteError> {
    let d = model.dimensions();
    let samples = request.duration * request.rate;
    if !(request.duration > 0.0 && request.rate > 0.0 && (50.0..=2e6).contains(&samples)) {
        let why = format!("{} s at {} Hz make {samples:.0} samples; a record takes 50 to 2 million", request.duration, request.rate);
        return Err(ExciteError::Request { why });
    }
    if d.inputs == 0 {
        return Err(ExciteError::Request { why: "the rig has no input to move".to_owned() });
    }
    let t: Vec<f64> = (0..=samples.round() as usize).map(|k| k as f64 / request.rate).collect();
    let mut room = Vec::new();
    for i in 0..d.inputs {
        let limits = model.input_path(i, p).limits;
        let free = (request.u[i] - limits.0).min(limits.1 - request.u[i]);
        if free <= 0.0 {
            return Err(ExciteError::NoRoom { input: model.names().signal(i).to_owned(), value: request.u[i], limits });
        }
        room.push(ROOM * free);
    }
    let Plan { series, words } = plan(request.shape, &t, d.inputs, request.band, request.seed);
    // inputs without limits go with those that have some, or are scaled by what moves
    let finite = room.iter().copied().filter(|r| r.is_finite()).fold(f64::NAN, f64::min);
    let unit: Vec<f64> = room
        .iter()
        .map(|r| {
            if r.is_finite() {
                *r
            } else if finite.is_finite() {
                finite
            } else {
                1.0
            }
        })
        .collect();
    let inputs = |scale: f64| -> Vec<Vec<f64>> {
        (0..d.signals())
            .map(|i| match series.get(i) {
                Some(s) => s.iter().map(|s| request.u[i] + scale * unit[i] * s).collect(),
                None => vec![request.u[i]; t.len()],
            })
            .collect()
    };
    let run = |scale: f64| -> Result<Outcome, ExciteError> { outcome(model, p, request, &t, inputs(scale)) };
    let bounded = finite.is_finite();
    let mut limited_by = None;
    let (mut scale, mut largest) = (1.0, run(1.0)?);
    if largest.left.is_none() && !bounded {
        // no limit of an input: as large as the coordinates allow
        while let Some(next) = Some(run(2.0 * scale)?).filter(|o| o.left.is_none() && scale < 1e6) {
            scale *= 2.0;
            largest = next;
        }
        limited_by = run(2.0 * scale)?.left.map(|(i, _)| i);
    } else if let Some((i, _)) = largest.left {
        limited_by = Some(i);
        let (mut good, mut bad) = (0.0, scale);
        for _ in 0..40 {
            let middle = if good == 0.0 { bad / 4.0 } else { (good * bad).sqrt() };
            let next = run(middle)?;
            match next.left {
                None => (good, largest) = (middle, next),
                Some((i, _)) => (bad, limited_by) = (middle, Some(i)),
            }
            if good > 0.0 && bad / good < 1.03 || bad < 1e-5 {
                break;
            }
        }
        if good == 0.0
            && let Some((i, after)) = run(bad)?.left
        {
            let (low, high) = request.within[i];
            let bounds = (request.x[i] - low, request.x[i] + high);
            return Err(ExciteError::Leaves { coordinate: model.names().state(i).to_owned(), after, bounds });
        }
        scale = good;
    }
    let limited_by = match limited_by {
        Some(i) => model.names().state(i).to_owned(),
        None => {
            let i = (0..d.inputs).min_by(|&a, &b| room[a].total_cmp(&room[b])).unwrap_or(0);
            model.names().signal(i).to_owned()
        }
    };
    let inputs = inputs(scale);
    let amplitude = inputs.iter().enumerate().map(|(i, s)| s.iter().map(|s| (s - request.u[i]).abs()).fold(0.0, f64::max)).collect();
    let signals = held(&t, &inputs)?;
    let predicted = predict(model, p, free, &request.x, &signals, &t)?;
    Ok(Excitation { t, inputs, amplitude, excursion: largest.excursion, limited_by, words, predicted })
}

/// What a simulated run came to.
struct Outcome {
    excursion: Vec<(f64, f64)>,
    /// The first coordinate to leave its bounds, and when.
    left: Option<(usize, f64)>,
}

fn held(t: &[f64], inputs: &[Vec<f64>]) -> Result<Signals, ExciteError> {
    let signals = inputs.iter().map(|values| Signal { t: t.to_vec(), values: values.clone(), hold: Hold::Zero }).collect();
    Signals::new(signals).map_err(ExciteError::Simulation)
}

fn outcome(model: &dyn Model, p: &[f64], request: &Request, t: &[f64], inputs: Vec<Vec<f64>>) -> Result<Outcome, ExciteError> {
    let n = model.dimensions().coordinates;
    let options = sim::Options { relative: 1e-6, absolute: 1e-8, ..sim::Options::default() };
    let run = simulate(model, p, &request.x, &held(t, &inputs)?, t, &options).map_err(ExciteError::Simulation)?;
    let mut excursion: Vec<(f64, f64)> = (0..n).map(|i| (request.x[i], request.x[i])).collect();
    let mut left = None;
    for k in 0..run.t.len() {
        let x = run.state(k);
        for i in 0..n {
            excursion[i] = (excursion[i].0.min(x[i]), excursion[i].1.max(x[i]));
            let (low, high) = request.within[i];
            if left.is_none() && (x[i] < request.x[i] - low || x[i] > request.x[i] + high) {
                left = Some((i, run.t[k]));
            }
        }
    }
    if run.status != Status::Completed && left.is_none() {
        left = Some((0, run.valid_until));
    }
    Ok(Outcome { excursion, left })
}
