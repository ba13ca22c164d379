//! Which effects would the records like to have: score tests of all candidates at once, without refitting.
//!
//! Whitened innovations z and their derivatives D_c by each candidate, those by the fitted parameters D_b projected out: with
//! R = D_c - D_b (D_b^T D_b + priors)^-1 D_b^T D_c the statistic z^T R (R^T R)^-1 R^T z is chi-squared where the effect is absent (Rao's score test). All
//! candidates look at the same z: the threshold of the whole family is the 5 % quantile of the smallest p-value over draws of the
//! correlated scores. The variance of R^T z is also taken from the record itself, in case z is not as white as it should be; the
//! larger one counts.

use crate::chance::{Chance, beyond, quantile, variance_of_sum};
use crate::compliance::strain;
use crate::effects::{Effect, Signature};
use crate::model::Prepared;
use ident::fit::FitError;
use ident::innovations::{Column, Noise, Pass, Shape, TAIL, Track, pass};
use ident::parallel::in_parallel;
use ident::spectrum::{of_symmetric, pseudo_inverse};
use model_dsl::rig::{Expr, Friction, Symbol};
use nalgebra::{DMatrix, DVector};
use runtime::Model;

/// Below this share of its own an effect is eaten by the fitted parameters.
pub const UNIQUE: f64 = 0.05;
/// Signatures with a larger cosine cannot be told apart.
pub const SAME: f64 = 0.9;
/// Draws of the family's scores.
const DRAWS: usize = 4000;
/// Samples over which scores are allowed to hang together.
const LAGS: usize = 30;

/// A candidate's columns.
pub enum Seen<'a> {
    /// An effect of the catalogue: by parameters of the screening model, or as its signature says.
    Effect(&'a Effect, Vec<usize>),
    /// These parameters, with a value for each record.
    ByRecord(Vec<usize>),
    /// The way to another model.
    Towards(&'a dyn Model),
    /// A force of some shape on an equation, that no effect of the catalogue needs to have.
    Shape(Vec<(usize, Box<Shape>)>, String),
    /// These parameters, each multiplied by some shape.
    Weighted(Vec<(usize, Box<Shape>)>, String),
}

/// What the test says of a candidate.
#[derive(Clone, Debug)]
pub struct Score {
    /// Statistic, chi-squared with `degrees` where the effect is absent.
    pub statistic: f64,
    /// Degrees of freedom.
    pub degrees: usize,
    /// Its own p-value.
    pub p_single: f64,
    /// p-value in the family of all candidates.
    pub p_family: f64,
    /// Share of its signature that the fitted parameters do not have.
    pub unique_fraction: f64,
    /// Size of each parameter that would be found with 90 % probability (SI).
    pub minimal_detectable: Vec<f64>,
    /// One step from zero: value and standard error of each parameter.
    pub step: Vec<(f64, f64)>,
    /// Its whitened signature, projected, of length one.
    pub direction: Vec<f32>,
    /// The same of each of its parameters alone, where it is an effect that has several.
    pub each: Vec<Vec<f32>>,
}

/// How a screening is made.
#[derive(Clone, Copy, Debug)]
pub struct ScreenOptions {
    /// Probability that any of the family speaks where nothing is missing.
    pub family: f64,
    /// Seed of the draws.
    pub seed: u64,
    /// What the fitted parameters can do is taken out of each signature, and it must leave something.
    pub absorption: bool,
}

/// Scores all candidates, one entry for each, at the fitted parameters `p` of each record.
///
/// # Errors
/// [`FitError`] where a record cannot be followed.
pub fn screen(
    prepared: &Prepared,
    p: &[Vec<f64>],
    noise: &Noise,
    tracks: &[Track],
    candidates: &[Seen<'_>],
    options: ScreenOptions,
) -> Result<Vec<Score>, FitError> {
    let (model, specs): (&dyn Model, _) = (&prepared.model, &prepared.specs);
    // the width of a dry friction is a crutch of the equations, not the rig's: what it could do is no effect
    let crutches = widths(prepared);
    let fitted: Vec<usize> = specs.iter().enumerate().filter(|(i, s)| s.free || crutches.contains(i)).map(|(i, _)| i).collect();
    // what a record makes of its own command
    let strains: Vec<Vec<Box<Shape>>> = candidates.iter().map(|c| strains(c, prepared, p, tracks)).collect();
    let mut columns: Vec<Of<'_>> = fitted.iter().map(|&i| Of::All(Column::Parameter(i))).collect();
    // columns of the candidates: of the pass, and of which record
    let mut wide: Vec<(usize, Option<usize>)> = Vec::new();
    let mut own: Vec<std::ops::Range<usize>> = Vec::new();
    for (candidate, strains) in candidates.iter().zip(&strains) {
        let (first, from) = (columns.len(), wide.len());
        match candidate {
            Seen::Effect(effect, parameters) => match effect.signature {
                Signature::InputDelay(j) => columns.push(Of::All(Column::InputDelay(j))),
                Signature::OutputDelay(i) => columns.push(Of::All(Column::OutputDelay(i))),
                Signature::Resonance(_) => columns.extend(parameters.first().map(|&i| Of::Each(i, strains))),
                Signature::Parameters | Signature::Towards => columns.extend(parameters.iter().map(|&i| Of::All(Column::Parameter(i)))),
            },
            Seen::ByRecord(parameters) => {
                for i in parameters {
                    let known = columns.iter().position(|c| matches!(c, Of::All(Column::Parameter(own)) if own == i));
                    let column = known.unwrap_or(columns.len());
                    if known.is_none() {
                        columns.push(Of::All(Column::Parameter(*i)));
                    }
                    wide.extend((0..tracks.len()).map(|r| (column, Some(r))));
                }
                own.push(from..wide.len());
                continue;
            }
            Seen::Towards(other) => columns.push(Of::All(Column::Towards(*other))),
            Seen::Shape(shapes, _) => {
                columns.extend(shapes.iter().map(|(entry, shape)| Of::All(Column::Shaped(*entry, shape.as_ref()))));
            }
            Seen::Weighted(shapes, _) => {
                columns.extend(shapes.iter().map(|(i, shape)| Of::All(Column::Weighted(*i, shape.as_ref()))));
            }
        }
        wide.extend((first..columns.len()).map(|c| (c, None)));
        own.push(from..wide.len());
    }
    let here =
        |row: &[f64], (column, record): (usize, Option<usize>), r: usize| if record.is_none_or(|k| k == r) { row[column] } else { 0.0 };
    let mut passes = passes(model, p, tracks, noise, &columns)?;
    let count = columns.len();
    for (r, pass) in passes.iter_mut().enumerate() {
        clear_rounding(model, &p[r], &tracks[r], &of_record(&columns, r), pass);
    }

    // base columns: one for each record where the parameter belongs to the day
    let mut base: Vec<(usize, Option<usize>)> = Vec::new();
    for (c, &i) in fitted.iter().enumerate() {
        if specs[i].per_record {
            base.extend((0..tracks.len()).map(|r| (c, Some(r))));
        } else {
            base.push((c, None));
        }
    }
    let (b, m) = (base.len(), wide.len());
    let samples: usize = passes.iter().map(|pass| pass.z.len()).sum();
    let mut gram = DMatrix::<f64>::zeros(b, b);
    let mut cross = DMatrix::<f64>::zeros(b, m + 1);
    for (r, pass) in passes.iter().enumerate() {
        let of: Vec<(usize, usize)> =
            base.iter().enumerate().filter(|(_, (_, record))| record.is_none_or(|k| k == r)).map(|(k, (c, _))| (k, *c)).collect();
        for (z, row) in pass.z.iter().zip(pass.jacobian.chunks_exact(count)) {
            for &(i, ci) in &of {
                for &(j, cj) in &of {
                    gram[(i, j)] += row[ci] * row[cj];
                }
                for (j, column) in wide.iter().enumerate() {
                    cross[(i, j)] += row[ci] * here(row, *column, r);
                }
                // beyond the tail by its sign alone (Huber): no score hangs on one sample
                cross[(i, m)] += row[ci] * z.clamp(-TAIL, TAIL);
            }
        }
    }
    for (k, (c, _)) in base.iter().enumerate() {
        if let Some(sd) = specs[fitted[*c]].prior_sd {
            gram[(k, k)] += 1.0 / (sd * sd);
        }
    }
    let mut projection = pseudo_inverse(&gram, 1e-11) * &cross;
    if !options.absorption {
        projection.columns_mut(0, m).fill(0.0);
    }

    // residual columns and innovations
    let mut residual = vec![0.0; samples * m];
    let mut innovation = vec![0.0; samples];
    let mut whole = vec![0.0; m];
    let (mut at, mut record_of, mut time_of) = (0, vec![0_usize; samples], vec![0_usize; samples]);
    for (r, pass) in passes.iter().enumerate() {
        let of: Vec<(usize, usize)> =
            base.iter().enumerate().filter(|(_, (_, record))| record.is_none_or(|k| k == r)).map(|(k, (c, _))| (k, *c)).collect();
        for ((z, row), (k, _)) in pass.z.iter().zip(pass.jacobian.chunks_exact(count)).zip(&pass.at) {
            let out = &mut residual[at * m..(at + 1) * m];
            out.iter_mut().zip(&wide).for_each(|(out, column)| *out = here(row, *column, r));
            whole.iter_mut().zip(out.iter()).for_each(|(w, v)| *w += v * v);
            let mut z = z.clamp(-TAIL, TAIL);
            for &(i, ci) in &of {
                let value = row[ci];
                if value != 0.0 {
                    for (j, out) in out.iter_mut().enumerate() {
                        *out -= value * projection[(i, j)];
                    }
                    z -= value * projection[(i, m)];
                }
            }
            innovation[at] = z;
            (record_of[at], time_of[at]) = (r, *k);
            at += 1;
        }
    }
    let all = gram_of(&residual, m);
    let mut scores = Vec::new();
    let mut tests = Vec::new();
    for (candidate, range) in candidates.iter().zip(&own) {
        let test = Test::new(&all, &whole, range.clone());
        let mut score = score(&test, &residual, m, &innovation, &record_of, &time_of);
        if matches!(candidate, Seen::Effect(..)) && range.len() > 1 {
            score.each = range.clone().map(|i| unit(residual.chunks_exact(m).map(|row| row[i]))).collect();
        }
        scores.push(score);
        tests.push(test);
    }
    let least = draws(&all, &tests, options.seed);
    let eligible = tests.iter().filter(|t| t.speaks()).count().max(1);
    let place = ((options.family * least.len() as f64) as usize).min(least.len().saturating_sub(1));
    let threshold = least.get(place).copied().unwrap_or(options.family);
    let reach = quantile(1.0 - 0.5 * threshold) + 1.2816;
    for (score, test) in scores.iter_mut().zip(&tests) {
        let below = least.partition_point(|p| *p <= score.p_single) as f64;
        // beyond the draws the bound of Bonferroni holds
        score.p_family =
            if below > 0.0 { below / least.len() as f64 } else { (eligible as f64 * score.p_single).min(1.0 / least.len() as f64) };
        score.minimal_detectable = (0..test.range.len()).map(|k| reach / test.information(k, &whole).sqrt()).collect();
    }
    Ok(scores)
}

/// Parameters that are widths of dry friction.
fn widths(prepared: &Prepared) -> Vec<usize> {
    let of = |f: &Friction| match f.width {
        Some(Expr::Symbol(Symbol::Parameter(i))) => Some(i),
        _ => None,
    };
    prepared.base.rig.frictions.iter().filter_map(of).collect()
}

/// A column of the passes: the same for all records, or a parameter times a shape of each record's own.
enum Of<'a> {
    All(Column<'a>),
    Each(usize, &'a [Box<Shape>]),
}

/// Columns of record `r`.
fn of_record<'a>(columns: &[Of<'a>], r: usize) -> Vec<Column<'a>> {
    let own = |c: &Of<'a>| match c {
        Of::All(column) => *column,
        Of::Each(i, shapes) => Column::Weighted(*i, shapes[r].as_ref()),
    };
    columns.iter().map(own).collect()
}

/// For a resonance, what it leaves of each record's command.
fn strains(candidate: &Seen<'_>, prepared: &Prepared, p: &[Vec<f64>], tracks: &[Track]) -> Vec<Box<Shape>> {
    let Seen::Effect(effect, _) = candidate else { return Vec::new() };
    let Signature::Resonance(input) = effect.signature else { return Vec::new() };
    let number = |k: usize| effect.parameters.get(k).and_then(|p| p.shape).map_or(1.0, |s| s.at);
    tracks.iter().zip(p).map(|(track, p)| strain(&prepared.model, p, track, input, number(1), number(2))).collect()
}

fn passes(model: &dyn Model, p: &[Vec<f64>], tracks: &[Track], noise: &Noise, columns: &[Of<'_>]) -> Result<Vec<Pass>, FitError> {
    let each = in_parallel(tracks, |r, track| pass(model, &p[r], track, noise, &of_record(columns, r)));
    let mut found = Vec::new();
    for (one, track) in each.into_iter().zip(tracks) {
        found.push(one?.ok_or(FitError::NoStart { file: track.source().to_owned(), status: None })?);
    }
    Ok(found)
}

/// What rounding leaves of a parameter that an output shows directly, in parts of that: a sensor's zero where the motion's own does the same.
const ROUNDING: f64 = 1e-6;

/// Takes out derivatives that are nothing but rounding: they would be a signature of their own.
fn clear_rounding(model: &dyn Model, p: &[f64], track: &Track, columns: &[Column<'_>], pass: &mut Pass) {
    let d = model.dimensions();
    let order = pass.states.len() / track.times().len().max(1);
    let middle = track.times().len() / 2;
    let Some(state) = pass.states.get(middle * order..middle * order + d.states()) else { return };
    let (mut c, mut dhdp) = (vec![0.0; d.outputs * d.states()], vec![0.0; d.outputs * d.parameters]);
    model.output_jacobian(track.times()[middle], state, p, &mut c, &mut dhdp);
    let count = columns.len();
    for (column, i) in columns.iter().enumerate().filter_map(|(k, c)| if let Column::Parameter(i) = c { Some((k, *i)) } else { None }) {
        let direct = |o: usize| dhdp[o * d.parameters + i];
        let (mut seen, mut shown) = (0.0, 0.0);
        for (row, ((_, o), sd)) in pass.jacobian.chunks_exact(count).zip(pass.at.iter().zip(&pass.gains.sd)) {
            shown += row[column].powi(2);
            seen += (direct(*o) / sd).powi(2);
        }
        if shown < ROUNDING.powi(2) * seen {
            pass.jacobian.iter_mut().skip(column).step_by(count).for_each(|v| *v = 0.0);
        }
    }
}

fn gram_of(rows: &[f64], m: usize) -> DMatrix<f64> {
    let mut sum = vec![0.0; m * m];
    for row in rows.chunks_exact(m.max(1)) {
        for (i, a) in row.iter().enumerate() {
            if *a != 0.0 {
                sum[i * m + i..(i + 1) * m].iter_mut().zip(&row[i..]).for_each(|(s, b)| *s += a * b);
            }
        }
    }
    DMatrix::from_fn(m, m, |i, j| sum[i.min(j) * m + i.max(j)])
}

/// The information of one candidate.
struct Test {
    range: std::ops::Range<usize>,
    /// R^T R, and its pseudo-inverse over directions that are its own.
    normal: DMatrix<f64>,
    inverse: DMatrix<f64>,
    degrees: usize,
    unique: f64,
}

impl Test {
    fn new(all: &DMatrix<f64>, whole: &[f64], range: std::ops::Range<usize>) -> Self {
        let k = range.len();
        let normal = DMatrix::from_fn(k, k, |i, j| all[(range.start + i, range.start + j)]);
        let scale: Vec<f64> = range.clone().map(|i| if whole[i] > 0.0 { whole[i].sqrt().recip() } else { 0.0 }).collect();
        // share of each column that is its own, directions of it
        let shares = DMatrix::from_fn(k, k, |i, j| normal[(i, j)] * scale[i] * scale[j]);
        let eigen = of_symmetric(shares);
        let unique = eigen.eigenvalues.iter().copied().fold(0.0, f64::max).min(1.0);
        let mut inverse = DMatrix::zeros(k, k);
        let mut degrees = 0;
        for (l, value) in eigen.eigenvalues.iter().enumerate() {
            if *value > 1e-6 {
                degrees += 1;
                for i in 0..k {
                    for j in 0..k {
                        inverse[(i, j)] += eigen.eigenvectors[(i, l)] * eigen.eigenvectors[(j, l)] / value * scale[i] * scale[j];
                    }
                }
            }
        }
        Self { range, normal, inverse, degrees, unique }
    }

    fn speaks(&self) -> bool {
        self.degrees > 0 && self.unique >= UNIQUE
    }

    fn statistic(&self, b: &DVector<f64>) -> f64 {
        (b.transpose() * &self.inverse * b)[(0, 0)].max(0.0)
    }

    /// Information about parameter k, the others of the effect being known; nothing where the fitted parameters have it all.
    fn information(&self, k: usize, whole: &[f64]) -> f64 {
        let own = self.normal[(k, k)];
        if own > 1e-6 * whole[self.range.start + k] { own } else { 0.0 }
    }
}

fn score(test: &Test, residual: &[f64], m: usize, z: &[f64], record: &[usize], time: &[usize]) -> Score {
    let k = test.range.len();
    let rows = || residual.chunks_exact(m).map(|row| &row[test.range.clone()]);
    let mut b = DVector::<f64>::zeros(k);
    for (row, z) in rows().zip(z) {
        b.iter_mut().zip(row).for_each(|(b, r)| *b += r * z);
    }
    let mut statistic = test.statistic(&b);
    // the jacobian is that of the innovations: the step that removes them is down its slope
    let estimate = -(&test.inverse * &b);
    let along: Vec<f64> = rows().map(|row| row.iter().zip(estimate.iter()).map(|(r, e)| r * e).sum()).collect();
    // the record's own variance of the score along the step: of what is left with the effect, summed over the outputs of one sample
    let mut moments: Vec<Vec<f64>> = Vec::new();
    let mut last = None;
    for ((along, z), at) in along.iter().zip(z).zip(record.iter().zip(time)) {
        let product = along * (z + along);
        let new_record = last.is_none_or(|(r, _)| r != at.0);
        match moments.last_mut() {
            Some(of) if !new_record => match of.last_mut() {
                Some(sum) if last == Some(at) => *sum += product,
                _ => of.push(product),
            },
            _ => moments.push(vec![product]),
        }
        last = Some(at);
    }
    let meat_of: f64 = moments.iter().map(|of| variance_of_sum(of, LAGS)).sum();
    let model_of = (estimate.transpose() * &test.normal * &estimate)[(0, 0)];
    if meat_of > model_of && model_of > 0.0 {
        statistic *= model_of / meat_of;
    }
    let p_single = if test.speaks() { beyond(statistic, test.degrees) } else { 1.0 };
    let step = (0..k).map(|i| (estimate[i], test.inverse[(i, i)].max(0.0).sqrt())).collect();
    Score {
        statistic,
        degrees: test.degrees,
        p_single,
        p_family: 1.0,
        unique_fraction: test.unique,
        minimal_detectable: Vec::new(),
        step,
        direction: unit(along.iter().copied()),
        each: Vec::new(),
    }
}

/// A column of length one.
fn unit(column: impl Iterator<Item = f64> + Clone) -> Vec<f32> {
    let length = column.clone().map(|d| d * d).sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
    column.map(|d| (d / length) as f32).collect()
}

/// Smallest p-values of the family over draws with nothing missing, ascending.
fn draws(all: &DMatrix<f64>, tests: &[Test], seed: u64) -> Vec<f64> {
    let m = all.nrows();
    let scale: Vec<f64> = (0..m).map(|i| if all[(i, i)] > 0.0 { all[(i, i)].sqrt() } else { 0.0 }).collect();
    let unit = DMatrix::from_fn(m, m, |i, j| if scale[i] * scale[j] > 0.0 { all[(i, j)] / (scale[i] * scale[j]) } else { 0.0 });
    if m == 0 {
        return vec![1.0];
    }
    let eigen = of_symmetric(unit);
    let kept: Vec<usize> = (0..m).filter(|&k| eigen.eigenvalues[k] > 1e-10).collect();
    let root = DMatrix::from_fn(m, kept.len(), |i, k| scale[i] * eigen.eigenvectors[(i, kept[k])] * eigen.eigenvalues[kept[k]].sqrt());
    let mut chance = Chance::new(seed);
    let mut least: Vec<f64> = (0..DRAWS)
        .map(|_| {
            let xi = DVector::from_fn(kept.len(), |_, _| chance.normal());
            let b = &root * xi;
            tests
                .iter()
                .filter(|t| t.speaks())
                .map(|t| beyond(t.statistic(&DVector::from_fn(t.range.len(), |i, _| b[t.range.start + i])), t.degrees))
                .fold(1.0, f64::min)
        })
        .collect();
    least.sort_by(f64::total_cmp);
    least
}

/// Cosine of two signatures.
#[must_use]
pub fn cosine(a: &Score, b: &Score) -> f64 {
    between(&a.direction, &b.direction)
}

/// Cosine of two columns of length one.
#[must_use]
pub fn between(a: &[f32], b: &[f32]) -> f64 {
    a.iter().zip(b).map(|(x, y)| f64::from(*x) * f64::from(*y)).sum()
}
