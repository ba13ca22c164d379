//! Output error over all records, priors and continuity as one sum of squares, with its exact gradient and Gauss-Newton
//! matrix.
//!
//! cost = 1/2 sum rho((y - h)/scale) + 1/2 sum ((x - prior)/sd)^2, the slopes of the first samples among the priors, [+ 1/2 sum (jump of the state between pieces / sd)^2].

use super::data::Data;
use super::initial::Slope;
use super::minimize::{Evaluation, Objective};
use super::options::Loss;
use crate::compare::initial::settle_lags;
use crate::parallel::in_parallel_mut;
use nalgebra::{DMatrix, DVector};
use runtime::Model;
use sim::{Forward, Status};

/// What an unknown is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UnknownKind {
    /// Parameter with this index.
    Parameter(usize),
    /// Initial value of the state with this index, in piece `piece`.
    State { piece: usize, state: usize },
}

/// One unknown.
#[derive(Clone, Debug)]
pub(crate) struct Unknown {
    pub kind: UnknownKind,
    /// The record that it belongs to; `None` for what all share.
    pub record: Option<usize>,
    pub bounds: (f64, f64),
    /// Mean and standard deviation.
    pub prior: Option<(f64, f64)>,
    pub size: f64,
}

/// A stretch of a record with an initial state of its own.
pub(crate) struct Piece<'a> {
    pub data: &'a Data,
    pub record: usize,
    /// First and last sample. The last one belongs to the next piece, where there is one.
    pub range: (usize, usize),
    pub forward: Forward<'a>,
    /// Unknown of each column of the sensitivities.
    pub columns: Vec<usize>,
    /// The initial state, as far as it is no unknown.
    pub x0: Vec<f64>,
    /// Continued by the next piece.
    pub continued: bool,
    /// Its end is held to the beginning of the next piece.
    pub joined: bool,
    /// 1 / scale of each measured output.
    pub weights: Vec<f64>,
    /// Priors of the rates at its beginning.
    pub slopes: Vec<Slope>,
}

/// Where a run of a piece begins: parameters, initial state, and its derivatives by the columns.
struct Beginning {
    p: Vec<f64>,
    x: Vec<f64>,
    s: Vec<f64>,
}

impl Piece<'_> {
    /// Runs it; `row(sample in the piece, measured output, error, derivatives)` in SI.
    ///
    /// # Errors
    /// How the run ended where it did not come to its end; `None` where it could not begin: a delay that turned negative, a parameter that
    /// is no number.
    fn run(&mut self, model: &dyn Model, from: &Beginning, row: &mut sim::Sink<'_>) -> Result<(), Option<Status>> {
        let Piece { data, range: (first, to), forward, continued, .. } = self;
        // a further piece knows nothing of what was before it
        let delays: Vec<f64> = data.outputs.iter().map(|&i| if *first > 0 { model.output_path(i, &from.p).delay } else { 0.0 }).collect();
        let (start, last) = (data.times[*first], *to - *first);
        let status = forward.run(&from.p, &from.x, &from.s, &mut |k, i, y, dy| {
            if *continued && k == last || data.times[*first + k] - delays[i] < start {
                return;
            }
            row(k, i, y - data.measured[i][*first + k], dy);
        });
        match status {
            Ok(Status::Completed) => Ok(()),
            Ok(status) => Err(Some(status)),
            Err(_) => Err(None),
        }
    }

    /// Its part of the objective.
    ///
    /// # Errors
    /// As [`Piece::run`].
    fn sums(&mut self, model: &dyn Model, from: &Beginning, loss: Loss) -> Result<Sums, Option<Status>> {
        let m = self.columns.len();
        let (weights, slopes) = (self.weights.clone(), self.slopes.clone());
        let mut sums = Sums::new(m);
        let mut lines: Vec<Line> = slopes.iter().map(|_| Line { error: 0.0, by: vec![0.0; m] }).collect();
        self.run(model, from, &mut |k, i, error, dy| {
            sums.add(loss, error * weights[i], weights[i], dy);
            for (slope, line) in slopes.iter().zip(&mut lines) {
                if slope.output == i && k < slope.weights.len() {
                    line.add(slope.weights[k], error, dy);
                }
            }
        })?;
        for (slope, line) in slopes.iter().zip(&lines) {
            sums.add(Loss::Squares, line.error / slope.sd, 1.0 / slope.sd, &line.by);
        }
        sums.multiply();
        Ok(sums)
    }
}

/// The objective.
pub(crate) struct OutputError<'a> {
    pub model: &'a dyn Model,
    /// Parameters that are fixed, and places for those that are not.
    pub base: Vec<f64>,
    pub unknowns: Vec<Unknown>,
    pub pieces: Vec<Piece<'a>>,
    pub loss: Loss,
    /// 1 / standard deviation of the jump of each state between pieces.
    pub continuity: Vec<f64>,
    /// Evaluations so far.
    pub evaluations: usize,
    /// How the last run that failed did.
    pub failure: Option<(usize, Status)>,
}

/// Errors of one piece and their derivatives.
pub(crate) struct Rows {
    pub record: usize,
    /// Times of the rows [s].
    pub times: Vec<f64>,
    /// Measured outputs.
    pub outputs: usize,
    /// Errors over their scales, times x outputs.
    pub errors: Vec<f64>,
    /// Their weights in the gradient.
    pub slopes: Vec<f64>,
    /// Derivatives by the columns, (times outputs) x columns.
    pub jacobian: Vec<f64>,
    /// Unknown of each column.
    pub columns: Vec<usize>,
}

impl OutputError<'_> {
    /// Record and status of the last run that failed; no status where none did, so that its errors must have been no numbers.
    pub fn failed(&self) -> (usize, Option<Status>) {
        self.failure.clone().map_or((0, None), |(record, status)| (record, Some(status)))
    }

    /// Parameters of record `record`.
    pub fn parameters(&self, theta: &[f64], record: usize) -> Vec<f64> {
        let mut p = self.base.clone();
        for (unknown, &value) in self.unknowns.iter().zip(theta) {
            if let UnknownKind::Parameter(i) = unknown.kind
                && unknown.record.is_none_or(|r| r == record)
            {
                p[i] = value;
            }
        }
        p
    }

    /// Initial state of piece `piece` and its derivatives by the columns.
    pub fn initial(&self, theta: &[f64], p: &[f64], index: usize) -> Option<(Vec<f64>, Vec<f64>)> {
        let piece = &self.pieces[index];
        let d = self.model.dimensions();
        let (n, m) = (d.states(), piece.columns.len());
        let mut x = piece.x0.clone();
        let mut s = vec![0.0; n * m];
        for (column, &unknown) in piece.columns.iter().enumerate() {
            if let UnknownKind::State { state, .. } = self.unknowns[unknown].kind {
                x[state] = theta[unknown];
                s[state * m + column] = 1.0;
            }
        }
        // actuators stand still at the start of a record; further pieces have their states as unknowns
        if d.lags > 0 && piece.range.0 == 0 {
            let t0 = piece.data.times[0];
            let u = piece.data.inputs(self.model, p, t0);
            settle_lags(self.model, p, t0, &u, &mut x);
            self.settled(p, t0, &u, &x, index, &mut s)?;
        }
        Some((x, s))
    }

    /// Derivatives of the actuators' states at rest: f_z(q, v, z, p) = 0.
    fn settled(&self, p: &[f64], t: f64, u: &[f64], x: &[f64], index: usize, s: &mut [f64]) -> Option<()> {
        let piece = &self.pieces[index];
        let d = self.model.dimensions();
        let (n, m, at, lags) = (d.states(), piece.columns.len(), 2 * d.coordinates, d.lags);
        let parameters: Vec<usize> = piece
            .columns
            .iter()
            .filter_map(|&c| match self.unknowns[c].kind {
                UnknownKind::Parameter(i) => Some(i),
                UnknownKind::State { .. } => None,
            })
            .collect();
        let count = parameters.len();
        let (mut dx, mut a, mut f) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * count]);
        let mut work = vec![0.0; d.sensitivity_work()];
        self.model.sensitivities(t, x, u, p, &parameters, &mut dx, &mut a, &mut f, &mut work).ok()?;
        let slope = DMatrix::from_fn(lags, lags, |i, j| a[(at + i) * n + at + j]).try_inverse()?;
        for column in 0..m {
            let right = DVector::from_fn(lags, |i, _| {
                let by_state: f64 = (0..at).map(|j| a[(at + i) * n + j] * s[j * m + column]).sum();
                -(by_state + if column < count { f[(at + i) * count + column] } else { 0.0 })
            });
            let solved = &slope * right;
            for i in 0..lags {
                s[(at + i) * m + column] = solved[i];
            }
        }
        Some(())
    }

    fn beginning(&self, theta: &[f64], index: usize) -> Option<Beginning> {
        let p = self.parameters(theta, self.pieces[index].record);
        let (x, s) = self.initial(theta, &p, index)?;
        Some(Beginning { p, x, s })
    }

    /// Runs piece `index`, see [`Piece::run`]. `None` where the run does not come to its end.
    fn run(&mut self, theta: &[f64], index: usize, row: &mut sim::Sink<'_>) -> Option<()> {
        let from = self.beginning(theta, index)?;
        let ended = self.pieces[index].run(self.model, &from, row);
        self.ended(index, ended)
    }

    /// What a run gave; how it failed is kept.
    fn ended<T>(&mut self, index: usize, ended: Result<T, Option<Status>>) -> Option<T> {
        match ended {
            Ok(found) => Some(found),
            Err(status) => {
                if let Some(status) = status {
                    self.failure = Some((self.pieces[index].record, status));
                }
                None
            }
        }
    }

    /// Errors and derivatives of all pieces.
    pub fn rows(&mut self, theta: &[f64]) -> Option<Vec<Rows>> {
        let loss = self.loss;
        (0..self.pieces.len())
            .map(|index| {
                let piece = &self.pieces[index];
                let (m, outputs) = (piece.columns.len(), piece.data.outputs.len());
                let weights = piece.weights.clone();
                let (from, to) = piece.range;
                let count = to - from + usize::from(!piece.continued);
                let mut rows = Rows {
                    record: piece.record,
                    times: piece.data.times[from..from + count].to_vec(),
                    outputs,
                    errors: vec![0.0; count * outputs],
                    slopes: vec![0.0; count * outputs],
                    jacobian: vec![0.0; count * outputs * m],
                    columns: piece.columns.clone(),
                };
                self.run(theta, index, &mut |k, i, error, dy| {
                    let at = k * outputs + i;
                    let error = error * weights[i];
                    rows.errors[at] = error;
                    rows.slopes[at] = loss.of(error).1;
                    rows.jacobian[at * m..(at + 1) * m].iter_mut().zip(dy).for_each(|(j, dy)| *j = weights[i] * dy);
                })?;
                Some(rows)
            })
            .collect()
    }

    /// Errors (SI) of each measured output of each record, pieces one after the other.
    pub fn errors(&mut self, theta: &[f64]) -> Option<Vec<Vec<Vec<f64>>>> {
        let records = self.pieces.iter().map(|p| p.record + 1).max().unwrap_or(0);
        let mut all: Vec<Vec<Vec<f64>>> = vec![Vec::new(); records];
        for index in 0..self.pieces.len() {
            let record = &mut all[self.pieces[index].record];
            record.resize(self.pieces[index].data.outputs.len(), Vec::new());
            let mut given = std::mem::take(record);
            let done = self.run(theta, index, &mut |_, i, error, _| given[i].push(error));
            all[self.pieces[index].record] = given;
            done?;
        }
        Some(all)
    }

    /// Adds the jump of the state from piece `index` to the next.
    fn continuity(&self, theta: &[f64], index: usize, total: &mut Evaluation) -> Option<()> {
        let next = index + 1;
        let (before, after) = (&self.pieces[index], &self.pieces[next]);
        let p = self.parameters(theta, after.record);
        let (x, s) = self.initial(theta, &p, next)?;
        let (mb, ma) = (before.columns.len(), after.columns.len());
        let mut row = vec![0.0; theta.len()];
        for (i, &weight) in self.continuity.iter().enumerate() {
            row.fill(0.0);
            for (c, &unknown) in before.columns.iter().enumerate() {
                row[unknown] += weight * before.forward.sensitivities()[i * mb + c];
            }
            for (c, &unknown) in after.columns.iter().enumerate() {
                row[unknown] -= weight * s[i * ma + c];
            }
            let error = weight * (before.forward.state()[i] - x[i]);
            total.cost += 0.5 * error * error;
            let touched: Vec<usize> = (0..row.len()).filter(|&k| row[k] != 0.0).collect();
            for &a in &touched {
                total.gradient[a] += error * row[a];
                for &b in &touched {
                    total.normal[(a, b)] += row[a] * row[b];
                }
            }
        }
        Some(())
    }

    /// Adds the priors.
    pub fn priors(&self, theta: &[f64], total: &mut Evaluation) {
        for (i, (unknown, &x)) in self.unknowns.iter().zip(theta).enumerate() {
            if let Some((mean, sd)) = unknown.prior {
                let error = (x - mean) / sd;
                total.cost += 0.5 * error * error;
                total.gradient[i] += error / sd;
                total.normal[(i, i)] += 1.0 / (sd * sd);
            }
        }
    }
}

impl Objective for OutputError<'_> {
    fn unknowns(&self) -> usize {
        self.unknowns.len()
    }

    fn bounds(&self, i: usize) -> (f64, f64) {
        self.unknowns[i].bounds
    }

    fn size(&self, i: usize) -> f64 {
        self.unknowns[i].size
    }

    fn evaluate(&mut self, theta: &[f64]) -> Option<Evaluation> {
        self.evaluations += 1;
        let n = theta.len();
        let mut total = Evaluation { cost: 0.0, gradient: DVector::zeros(n), normal: DMatrix::zeros(n, n) };
        let begun: Vec<Beginning> = (0..self.pieces.len()).map(|index| self.beginning(theta, index)).collect::<Option<_>>()?;
        let (model, loss) = (self.model, self.loss);
        let each = in_parallel_mut(&mut self.pieces, |index, piece| piece.sums(model, &begun[index], loss));
        for (index, sums) in each.into_iter().enumerate() {
            self.ended(index, sums)?.spread(&self.pieces[index].columns, &mut total);
            if self.pieces[index].joined {
                self.continuity(theta, index, &mut total)?;
            }
        }
        self.priors(theta, &mut total);
        total.cost.is_finite().then_some(total)
    }
}

/// The slope of the errors of the first samples, and its derivatives.
struct Line {
    error: f64,
    by: Vec<f64>,
}

impl Line {
    fn add(&mut self, weight: f64, error: f64, dy: &[f64]) {
        self.error += weight * error;
        self.by.iter_mut().zip(dy).for_each(|(b, d)| *b += weight * d);
    }
}

/// Cost, gradient and J^T J over the columns of one piece.
struct Sums {
    cost: f64,
    /// Lines [derivatives | error], each weighted, one a column of the matrix; the first `filled` are waiting.
    lines: DMatrix<f64>,
    filled: usize,
    /// Sum of the products of the lines' entries.
    products: DMatrix<f64>,
}

impl Sums {
    /// Lines that are multiplied at a time: few enough to stay in the first cache.
    const LINES: usize = 128;

    fn new(columns: usize) -> Self {
        let lines = DMatrix::zeros(columns + 1, Self::LINES);
        Self { cost: 0.0, lines, filled: 0, products: DMatrix::zeros(columns + 1, columns + 1) }
    }

    fn add(&mut self, loss: Loss, error: f64, weight: f64, dy: &[f64]) {
        let (rho, slope) = loss.of(error);
        self.cost += 0.5 * rho;
        let root = slope.sqrt();
        let mut line = self.lines.column_mut(self.filled);
        let (last, by) = line.as_mut_slice().split_last_mut().expect("a line has at least its error");
        by.iter_mut().zip(dy).for_each(|(to, d)| *to = root * weight * d);
        *last = root * error;
        self.filled += 1;
        if self.filled == Self::LINES {
            self.multiply();
        }
    }

    /// Adds the products of the lines that are waiting.
    fn multiply(&mut self) {
        let lines = self.lines.columns(0, self.filled);
        self.products.gemm(1.0, &lines, &lines.transpose(), 1.0);
        self.filled = 0;
    }

    fn spread(&self, columns: &[usize], total: &mut Evaluation) {
        let m = columns.len();
        total.cost += self.cost;
        for (a, &i) in columns.iter().enumerate() {
            total.gradient[i] += self.products[(a, m)];
            for (b, &j) in columns.iter().enumerate() {
                total.normal[(i, j)] += self.products[(a, b)];
            }
        }
    }
}
