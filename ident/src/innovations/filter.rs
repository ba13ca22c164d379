//! One pass of the filter over one record: whitened innovations and their derivatives.

use super::noise::Noise;
use super::play::{Reading, Slack};
use super::transition::{Carried, Stepper, by_parameter};
use crate::fit::FitError;
use crate::fit::data::Data;
use crate::fit::initial::{estimate, usual};
use crate::fit::{InitialStates, Known};
use crate::record::{Record, Start};
use runtime::Model;
use sim::{Hold, Segment};

/// A record bound to a model, with the state at which it begins.
#[derive(Clone, Debug)]
pub struct Track {
    pub(crate) data: Data,
    /// Standard errors of the initial state.
    pub(crate) initial_sd: Vec<f64>,
    pub(crate) initial: Vec<f64>,
    /// Where readings behind play stand at the start, where that is known.
    pub(crate) readings: Vec<Reading>,
}

/// What innovations are differentiated by.
#[derive(Clone, Copy)]
pub enum Column<'a> {
    /// A parameter of the model.
    Parameter(usize),
    /// A further delay of an input.
    InputDelay(usize),
    /// A further delay of an output.
    OutputDelay(usize),
    /// The way from this model to another one with the same states, signals and parameters: x' + s (x'_other - x') at s = 0.
    Towards(&'a dyn Model),
    /// A force of a given shape, f(t, x, u), by the parameter of this disturbance (index into [`Noise::entries`]).
    Shaped(usize, &'a Shape),
    /// A parameter of the model whose action is multiplied by a shape.
    Weighted(usize, &'a Shape),
}

/// A number that depends on time, state and signals.
pub type Shape = dyn Fn(f64, &[f64], &[f64]) -> f64 + Sync;

/// Gains and standard deviations of a filter, to be used again: one entry for each innovation.
#[derive(Clone, Debug, Default)]
pub struct Gains {
    gain: Vec<f64>,
    /// Gains of the readings behind play.
    readings: Vec<f64>,
    /// Standard deviation of the way from a reading to the motion, at each sample.
    spread: Vec<f64>,
    /// Standard deviation of each innovation (SI).
    pub sd: Vec<f64>,
}

/// What a pass found.
#[derive(Clone, Debug, Default)]
pub struct Pass {
    /// Whitened innovations, by time, then by output.
    pub z: Vec<f64>,
    /// Sample and output (index in the model) of each.
    pub at: Vec<(usize, usize)>,
    /// Their derivatives, `z.len()` x columns.
    pub jacobian: Vec<f64>,
    /// Sum of the logarithms of the innovations' variances.
    pub log_variance: f64,
    /// Gains, if they were asked for.
    pub gains: Gains,
    /// Filtered states and disturbances at every sample, samples x order.
    pub states: Vec<f64>,
}

impl Pass {
    /// Logarithm of the likelihood, without the constant of 2 pi.
    #[must_use]
    pub fn log_likelihood(&self) -> f64 {
        -0.5 * (self.log_variance + self.z.iter().map(|z| z * z).sum::<f64>())
    }
}

/// How a pass is made.
pub(crate) enum Filtering<'g> {
    /// Gains from the noise, kept in the result.
    Riccati,
    /// Gains of an earlier pass.
    Frozen(&'g Gains),
}

impl Track {
    /// Binds a record. Values that are not to be used may be NaN.
    ///
    /// # Errors
    /// [`FitError`] where the record does not fit the model.
    pub fn new(record: &Record, model: &dyn Model, p: &[f64], hold: Hold) -> Result<Self, FitError> {
        let data = Data::new(record, model, hold)?;
        let mut track = Self { data, initial_sd: Vec::new(), initial: Vec::new(), readings: Vec::new() };
        track.begin(model, p);
        Ok(track)
    }

    /// Estimates the initial state anew.
    pub(crate) fn begin(&mut self, model: &dyn Model, p: &[f64]) {
        let last = self.data.times.len() - 1;
        let how = match usual(self.data.start) {
            InitialStates { rates: Known::Fixed, .. } => InitialStates { coordinates: Known::Prior, rates: Known::Fixed },
            _ => InitialStates { coordinates: Known::Prior, rates: Known::Prior },
        };
        let found = estimate(model, p, &self.data, (0, last), self.data.start, how);
        let d = model.dimensions();
        let mut sd = vec![0.0; d.states()];
        for unknown in &found.unknowns {
            sd[unknown.state] = 2.0 * unknown.size;
        }
        // coordinates that nothing measures, rates that are said to be zero: some room all the same
        let room = found.unknowns.iter().filter(|u| u.state < d.coordinates).map(|u| u.size).fold(0.0, f64::max);
        for (i, sd) in sd.iter_mut().enumerate().filter(|(_, sd)| **sd == 0.0) {
            *sd = if i < 2 * d.coordinates && self.data.start == Start::Free { 10.0 * room } else { room };
        }
        (self.initial, self.initial_sd) = (found.x, sd);
        self.readings.clear();
        let late: Vec<(usize, usize, f64)> =
            self.data.outputs.iter().map(|&o| (0, o, model.output_path(o, p).delay)).filter(|(_, _, delay)| *delay > 0.0).collect();
        if !late.is_empty() {
            let mut c = vec![0.0; d.outputs * d.states()];
            let mut dhdp = vec![0.0; d.outputs * d.parameters];
            model.output_jacobian(self.data.times[0], &self.initial, p, &mut c, &mut dhdp);
            let on = self.gone_on(model, p, &c, 1, &late);
            self.initial.iter_mut().zip(on).for_each(|(x, on)| *x += on);
        }
    }

    /// How far the motion has gone while outputs were on their way, states x columns; for column, output and seconds.
    fn gone_on(&self, model: &dyn Model, p: &[f64], c: &[f64], columns: usize, late: &[(usize, usize, f64)]) -> Vec<f64> {
        let d = model.dimensions();
        let n = d.states();
        let mut on = vec![0.0; n * columns];
        let t0 = self.data.times[0];
        let mut rate = vec![0.0; n];
        if model.rhs(t0, &self.initial, &self.inputs(model, p, t0), p, &mut rate).is_ok() {
            for &(column, output, seconds) in late {
                for state in (0..d.coordinates).filter(|state| c[output * n + state] != 0.0) {
                    for state in [state, d.coordinates + state] {
                        on[state * columns + column] += seconds * rate[state];
                    }
                }
            }
        }
        on
    }

    /// The same, with the initial state that belongs to `p`.
    #[must_use]
    pub fn begun(&self, model: &dyn Model, p: &[f64]) -> Self {
        let mut track = self.clone();
        track.begin(model, p);
        track
    }

    /// How the estimate of the initial state moves with parameters that outputs depend on and with delays of outputs, states x columns:
    /// a sensor whose zero is off began elsewhere.
    fn begins_by(&self, model: &dyn Model, p: &[f64], columns: &[Column<'_>], delayed: &[(usize, usize, f64)]) -> Vec<f64> {
        let d = model.dimensions();
        let (n, m) = (d.states(), columns.len());
        let mut by = vec![0.0; n * m];
        let (mut c, mut dhdp) = (vec![0.0; d.outputs * n], vec![0.0; d.outputs * d.parameters]);
        let t0 = self.data.times[0];
        model.output_jacobian(t0, &self.initial, p, &mut c, &mut dhdp);
        // a drift is nothing yet at the first sample
        let mut late = dhdp.clone();
        model.output_jacobian(self.data.times[self.data.times.len() - 1], &self.initial, p, &mut c.clone(), &mut late);
        let mut moved = p.to_vec();
        for (column, entry) in columns.iter().enumerate() {
            let Column::Parameter(i) = entry else { continue };
            if self.data.outputs.iter().all(|o| dhdp[o * d.parameters + i] == 0.0 && late[o * d.parameters + i] == 0.0) {
                continue;
            }
            let size = 1e-5 * p[*i].abs().max(1e-2);
            moved[*i] = p[*i] + size;
            let after = self.begun(model, &moved).initial;
            moved[*i] = p[*i];
            let before = self.begun(model, &moved).initial;
            for state in 0..n {
                by[state * m + column] = (after[state] - before[state]) / size;
            }
        }
        let on = self.gone_on(model, p, &c, m, delayed);
        by.iter_mut().zip(on).for_each(|(by, on)| *by += on);
        by
    }

    /// File of the record.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.data.source
    }

    /// Time stamps [s].
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.data.times
    }

    /// Measured outputs: index in the model and values.
    pub fn measured(&self) -> impl Iterator<Item = (usize, &[f64])> {
        self.data.outputs.iter().copied().zip(self.data.measured.iter().map(Vec::as_slice))
    }

    /// Takes a sample of an output out of use.
    pub fn discard(&mut self, output: usize, sample: usize) {
        if let Some(i) = self.data.outputs.iter().position(|&o| o == output)
            && let Some(value) = self.data.measured[i].get_mut(sample)
        {
            *value = f64::NAN;
        }
    }

    /// Leaves an output out.
    pub fn leave_out(&mut self, output: usize) {
        if let Some(i) = self.data.outputs.iter().position(|&o| o == output) {
            self.data.outputs.remove(i);
            self.data.measured.remove(i);
            self.data.steps.remove(i);
            self.data.white.remove(i);
        }
    }

    /// Only the samples `from..to`.
    #[must_use]
    pub fn part(&self, from: usize, to: usize, model: &dyn Model, p: &[f64]) -> Self {
        let mut data = self.data.clone();
        data.times = data.times[from..to].to_vec();
        data.measured.iter_mut().for_each(|m| *m = m[from..to].to_vec());
        if from > 0 {
            data.start = Start::Free;
        }
        let mut part = Self { data, initial_sd: Vec::new(), initial: Vec::new(), readings: Vec::new() };
        part.begin(model, p);
        part
    }

    /// With all inputs at their means; `None` where they do not change.
    #[must_use]
    pub fn without_inputs(&self, model: &dyn Model, p: &[f64]) -> Option<Self> {
        let all: Vec<Vec<f64>> = self.data.times.iter().map(|t| self.inputs(model, p, *t)).collect();
        let inputs = model.dimensions().inputs;
        let first = all.first()?;
        if all.iter().all(|u| u[..inputs] == first[..inputs]) || first.len() > inputs {
            return None;
        }
        let mean: Vec<f64> = (0..inputs).map(|j| all.iter().map(|u| u[j]).sum::<f64>() / all.len() as f64).collect();
        let mut still = self.clone();
        still.data.signals = sim::Signals::constant(&mean).ok()?;
        Some(still)
    }

    /// Inputs and exogenous signals at time t, within limits.
    #[must_use]
    pub fn inputs(&self, model: &dyn Model, p: &[f64], t: f64) -> Vec<f64> {
        self.data.inputs(model, p, t)
    }

    /// Pieces on which the inputs are straight.
    pub(crate) fn segments(&self, model: &dyn Model, p: &[f64]) -> Result<Vec<Segment>, FitError> {
        let paths = sim::input_paths(model, p)?;
        let t = &self.data.times;
        Ok(self.data.signals.segments(&paths, t[0], t[t.len() - 1]))
    }
}

/// One pass over a record with gains that follow from the noise; `None` where the model cannot be followed to the end.
///
/// # Errors
/// [`FitError`] where a delay is negative.
pub fn pass(model: &dyn Model, p: &[f64], track: &Track, noise: &Noise, columns: &[Column<'_>]) -> Result<Option<Pass>, FitError> {
    run(model, p, track, noise, columns, &Filtering::Riccati, &mut |_| {})
}

/// Mean variance of each output (SI squared) that random forces alone give a free run of the model over a record. `None` where the model
/// cannot be followed.
///
/// # Errors
/// As [`pass`].
pub fn wander(model: &dyn Model, p: &[f64], track: &Track, noise: &Noise) -> Result<Option<Vec<f64>>, FitError> {
    let mut blind = track.begun(model, p);
    blind.data.measured.iter_mut().for_each(|values| values.fill(f64::NAN));
    blind.initial_sd.fill(0.0);
    let d = model.dimensions();
    let (n, order) = (d.states(), d.states() + noise.entries.len());
    let (mut c, mut dhdp) = (vec![0.0; d.outputs * n], vec![0.0; d.outputs * d.parameters]);
    let mut sum = vec![0.0; d.outputs];
    let mut count = 0.0;
    let mut at = 0;
    let found = run(model, p, &blind, noise, &[], &Filtering::Riccati, &mut |seen| {
        let (state, covariance) = seen.updated;
        model.output_jacobian(blind.data.times[at], &state[..n], p, &mut c, &mut dhdp);
        for (i, sum) in sum.iter_mut().enumerate() {
            for a in 0..n {
                for b in 0..n {
                    *sum += c[i * n + a] * covariance[a * order + b] * c[i * n + b];
                }
            }
        }
        count += 1.0;
        at += 1;
    })?;
    Ok(found.map(|_| sum.into_iter().map(|s| s / f64::max(count, 1.0)).collect()))
}

/// What an observer of a pass sees at each sample.
pub(crate) struct Seen<'s> {
    /// Transition matrix from the sample before.
    pub transition: &'s [f64],
    /// State and covariance before the sample.
    pub predicted: (&'s [f64], &'s [f64]),
    /// After it.
    pub updated: (&'s [f64], &'s [f64]),
    /// Readings behind play, after it.
    pub readings: &'s [Reading],
}

/// A pass; `observe` is called at every sample where gains are computed.
pub(crate) fn run(
    model: &dyn Model,
    p: &[f64],
    track: &Track,
    noise: &Noise,
    columns: &[Column<'_>],
    filtering: &Filtering<'_>,
    observe: &mut dyn FnMut(&Seen<'_>),
) -> Result<Option<Pass>, FitError> {
    let d = model.dimensions();
    let (n, m) = (d.states(), columns.len());
    let order = n + noise.entries.len();
    // a track may come from a model with other states
    let own = (track.initial.len() != n).then(|| track.begun(model, p));
    let track = own.as_ref().unwrap_or(track);
    let segments = track.segments(model, p)?;
    let times = &track.data.times;
    let measured = shifted(model, p, &track.data);
    let variance: Vec<f64> = noise.sd.iter().map(|s| s * s).collect();
    let decay: Vec<f64> = noise.time.iter().map(|t| 1.0 / t).collect();
    let riccati = matches!(filtering, Filtering::Riccati);
    let mut stepper = Stepper::new(model, p, noise, variance.clone(), decay, columns);
    let mut carried = Carried {
        state: track.initial.iter().copied().chain(vec![0.0; noise.entries.len()]).collect(),
        covariance: if riccati { vec![0.0; order * order] } else { Vec::new() },
        sensitivity: vec![0.0; order * m],
        transition: if riccati { vec![0.0; order * order] } else { Vec::new() },
    };
    if riccati {
        for i in 0..order {
            carried.covariance[i * order + i] = if i < n { track.initial_sd[i].powi(2) } else { variance[i - n] };
        }
    }
    let mut found = Pass::default();
    found.states.reserve(times.len() * order);
    let (mut y, mut c, mut dhdp) = (vec![0.0; d.outputs], vec![0.0; d.outputs * n], vec![0.0; d.outputs * d.parameters]);
    let mut rate = vec![0.0; n];
    let mut u = vec![0.0; d.signals()];
    let (mut gain, mut row, mut with) = (vec![0.0; order], vec![0.0; m], vec![0.0; order]);
    let (mut predicted, mut covariance) = (vec![0.0; order], Vec::new());
    let mut segment = 0;
    // columns that delay an output: column, output, seconds for one unit of the column
    let mut delayed: Vec<(usize, usize, f64)> = Vec::new();
    for (c, column) in columns.iter().enumerate() {
        match column {
            Column::OutputDelay(o) => delayed.push((c, *o, 1.0)),
            Column::Parameter(i) => delayed.extend(
                by_parameter(p, *i, d.outputs, |o, p| model.output_path(o, p).delay).into_iter().map(|(o, seconds)| (c, o, seconds)),
            ),
            _ => {}
        }
    }
    if m > 0 {
        let by = track.begins_by(model, p, columns, &delayed);
        carried.sensitivity[..n * m].copy_from_slice(&by);
    }
    let weighted = columns.iter().any(|c| matches!(c, Column::Weighted(..)));
    let late = !delayed.is_empty() || weighted || measured.iter().any(|values| values.iter().any(|v| v.1 != 0.0));
    let (mut middle, mut rate_middle) = (vec![0.0; n], vec![0.0; n]);
    let mut readings = Reading::all(model, p, &track.data.outputs, columns, order);
    let gains = if let Filtering::Frozen(gains) = filtering { Some(*gains) } else { None };
    let mut gains_of_readings = vec![0.0; readings.len()];
    let mut followed = 0;
    for (k, &t) in times.iter().enumerate() {
        if k > 0 {
            if riccati {
                carried.transition.fill(0.0);
                (0..order).for_each(|i| carried.transition[i * order + i] = 1.0);
            }
            let mut from = times[k - 1];
            stepper.sample = t - from;
            while from < t {
                while segment + 1 < segments.len() && segments[segment].to <= from {
                    segment += 1;
                    let (before, after) = (&segments[segment - 1], &segments[segment]);
                    let jump: Vec<f64> = (0..d.signals())
                        .map(|i| after.values[i] - (before.values[i] + before.slopes[i] * (before.to - before.from)))
                        .collect();
                    if stepper.switch(from, after, &jump, &mut carried).is_err() {
                        return Ok(None);
                    }
                }
                let last = segment + 1 == segments.len();
                let to = if last { t } else { segments[segment].to.min(t) };
                if stepper.stretch(&segments[segment], from, to, &mut carried).is_err() {
                    return Ok(None);
                }
                from = to;
            }
        }
        predicted.copy_from_slice(&carried.state);
        if riccati {
            covariance.clone_from(&carried.covariance);
            if k > 0 {
                readings.iter_mut().for_each(|reading| reading.go_on(&carried.transition));
            }
        }
        model.outputs(t, &carried.state[..n], stepper.parameters(), &mut y);
        model.output_jacobian(t, &carried.state[..n], stepper.parameters(), &mut c, &mut dhdp);
        if late {
            segments[segment].at(t, &mut u);
            if model.rhs(t, &carried.state[..n], &u, stepper.parameters(), &mut rate).is_err() {
                return Ok(None);
            }
        }
        for (i, values) in measured.iter().enumerate() {
            let output = track.data.outputs[i];
            let (value, early) = values[k];
            let behind = readings.iter().position(|reading| reading.output == output);
            if !value.is_finite() && behind.is_none() {
                continue;
            }
            let c = &c[output * n..(output + 1) * n];
            // outputs before this one have moved the state
            let moved: f64 = (0..n).map(|j| c[j] * (carried.state[j] - predicted[j])).sum();
            // the sensor saw the motion `early` seconds before this sample
            let mut seen_before = 0.0;
            if early != 0.0 {
                (0..n).for_each(|j| middle[j] = predicted[j] - 0.5 * early * rate[j]);
                if model.rhs(t, &middle, &u, stepper.parameters(), &mut rate_middle).is_err() {
                    return Ok(None);
                }
                seen_before = early * (0..n).map(|j| c[j] * rate_middle[j]).sum::<f64>();
            }
            let (mut expected, mut slope) = ((y[output] - seen_before) + moved, 1.0);
            let weigh = |shape: &Shape| shape(t, &carried.state[..n], &u);
            turned(&mut row, (c, &carried.sensitivity), columns, &dhdp[output * d.parameters..(output + 1) * d.parameters], weigh);
            for &(column, _, seconds) in delayed.iter().filter(|(_, o, _)| *o == output) {
                row[column] += seconds * (0..n).map(|j| c[j] * rate[j]).sum::<f64>();
            }
            // covariance of what is expected with the states, and its own
            let mut variance = 0.0;
            if riccati {
                for (row, with) in with.iter_mut().enumerate() {
                    *with = (0..n).map(|j| carried.covariance[row * order + j] * c[j]).sum();
                }
                variance = (0..n).map(|j| c[j] * with[j]).sum::<f64>();
            }
            if let Some(reading) = behind.map(|i| &mut readings[i]) {
                if k == 0 {
                    reading.begin(track.readings.iter().find(|known| known.output == output), expected, (&with, variance), (c, &row));
                } else {
                    let cross: f64 = (0..n).map(|j| c[j] * reading.with[j]).sum();
                    if riccati {
                        found.gains.spread.push((variance - 2.0 * cross + reading.variance).max(0.0).sqrt());
                    }
                    let Some(&spread) = gains.unwrap_or(&found.gains).spread.get(followed) else { return Ok(None) };
                    followed += 1;
                    let slack = Slack::new(expected - reading.value, spread, reading.width);
                    reading.follow(&slack, &with, variance, cross);
                    let weight = |column: usize| if let Column::Weighted(_, shape) = columns[column] { weigh(shape) } else { 1.0 };
                    reading.turn(&slack, weight, &mut row);
                    slope = slack.slope;
                }
                (expected, variance) = (reading.value, reading.variance);
                with.copy_from_slice(&reading.with);
            }
            if !value.is_finite() {
                continue;
            }
            let error = value - expected;
            let sd = match gains {
                None => {
                    for (i, (of, reading)) in gains_of_readings.iter_mut().zip(&readings).enumerate() {
                        let with_motion = || slope * (0..n).map(|j| c[j] * reading.with[j]).sum::<f64>();
                        *of = if behind == Some(i) { variance } else { with_motion() };
                    }
                    let total = variance + noise.output_sd[output].powi(2);
                    for a in 0..order {
                        for b in 0..order {
                            carried.covariance[a * order + b] -= with[a] * with[b] / total;
                        }
                    }
                    for (of, reading) in gains_of_readings.iter_mut().zip(&mut readings) {
                        reading.learn(*of, &with, total);
                        *of /= total;
                    }
                    gain.iter_mut().zip(&with).for_each(|(g, with)| *g = with / total);
                    found.gains.gain.extend(&gain);
                    found.gains.readings.extend(&gains_of_readings);
                    found.gains.sd.push(total.sqrt());
                    total.sqrt()
                }
                Some(gains) => {
                    let at = found.z.len();
                    let Some(sd) = gains.sd.get(at) else { continue };
                    gain.copy_from_slice(&gains.gain[at * order..(at + 1) * order]);
                    let count = readings.len();
                    let Some(own) = gains.readings.get(at * count..(at + 1) * count) else { continue };
                    gains_of_readings.copy_from_slice(own);
                    *sd
                }
            };
            if m > 0 {
                for (a, &g) in gain.iter().enumerate() {
                    if g != 0.0 {
                        carried.sensitivity[a * m..(a + 1) * m].iter_mut().zip(&row).for_each(|(s, r)| *s += g * r);
                    }
                }
                found.jacobian.extend(row.iter().map(|r| r / sd));
            }
            for (reading, g) in readings.iter_mut().zip(&gains_of_readings) {
                reading.value += g * error;
                reading.by.iter_mut().zip(&row).for_each(|(s, r)| *s += g * r);
            }
            carried.state.iter_mut().zip(&gain).for_each(|(x, g)| *x += g * error);
            let z = error / sd;
            if !(z.abs() < 1e9 && sd > 0.0) {
                return Ok(None);
            }
            found.z.push(z);
            found.at.push((k, output));
            found.log_variance += 2.0 * sd.ln();
        }
        found.states.extend(&carried.state);
        if riccati {
            observe(&Seen {
                transition: &carried.transition,
                predicted: (&predicted, &covariance),
                updated: (&carried.state, &carried.covariance),
                readings: &readings,
            });
        }
    }
    Ok(Some(found))
}

/// `row`: derivatives of an output by the columns, with their sign turned; through the state, of which it has the derivatives `c`, and by
/// themselves (`dhdp`).
fn turned(row: &mut [f64], (c, sensitivity): (&[f64], &[f64]), columns: &[Column<'_>], dhdp: &[f64], weigh: impl Fn(&Shape) -> f64) {
    if row.is_empty() {
        return;
    }
    row.fill(0.0);
    for (c, sensitivity) in c.iter().zip(sensitivity.chunks_exact(row.len())) {
        if *c != 0.0 {
            row.iter_mut().zip(sensitivity).for_each(|(r, s)| *r -= c * s);
        }
    }
    for (r, column) in row.iter_mut().zip(columns) {
        match column {
            Column::Parameter(j) => *r -= dhdp[*j],
            Column::Weighted(j, shape) if dhdp[*j] != 0.0 => *r -= dhdp[*j] * weigh(*shape),
            _ => {}
        }
    }
}

/// Measured outputs of a sensor with a delay: what is nearest to each sample, and how long before the sample the sensor saw it [s].
fn shifted(model: &dyn Model, p: &[f64], data: &Data) -> Vec<Vec<(f64, f64)>> {
    let t = &data.times;
    data.outputs
        .iter()
        .zip(&data.measured)
        .map(|(&output, values)| {
            let delay = model.output_path(output, p).delay;
            if delay == 0.0 {
                return values.iter().map(|v| (*v, 0.0)).collect();
            }
            t.iter()
                .map(|s| {
                    let at = s + delay;
                    let after = t.partition_point(|t| *t < at).min(t.len() - 1);
                    let nearest = if after > 0 && at - t[after - 1] < t[after] - at { after - 1 } else { after };
                    let early = at - t[nearest];
                    // beyond the record's ends there is nothing
                    let spacing = (t[t.len() - 1] - t[0]) / (t.len() - 1) as f64;
                    (if early.abs() <= spacing { values[nearest] } else { f64::NAN }, early)
                })
                .collect()
        })
        .collect()
}
