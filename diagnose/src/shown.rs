//! What records say of an effect of a given size: the share of it that each shows, 1 where it is there as it was found, 0 where it
//! is not there.
//!
//! One Gauss-Newton step from the refitted model along the effect's own parameters, the fitted parameters of the rig free beside it, so
//! that a rig that is slightly different on another day does not count against the effect. Where the record was not fitted, they stay near what
//! the others say of them: a record need not show all that the effect might be mistaken for.

use crate::chance::variance_of_sum;
use crate::model::Prepared;
use ident::fit::{FitError, ParameterSpec};
use ident::innovations::{Column, Noise, Pass, TAIL, Track, pass};
use ident::spectrum::pseudo_inverse;
use nalgebra::{DMatrix, DVector};
use runtime::Model;

/// A share and its standard error, which allows for innovations that are larger than the noise says, or hang together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// Share.
    pub value: f64,
    /// Standard error.
    pub sd: f64,
}

impl Share {
    /// Gain of log-likelihood over all samples that the effect in its size brings (the square law of small changes), and the half
    /// width of its 95 % interval.
    #[must_use]
    pub fn gain(self) -> (f64, f64) {
        let information = self.sd.powi(-2);
        ((self.value - 0.5) * information, 1.96 * information.sqrt())
    }
}

/// Samples over which innovations may hang together.
const LAGS: usize = 20;

/// How an effect enters.
pub enum Way<'a> {
    /// By these parameters of the refitted model.
    Parameters(&'a [usize]),
    /// As the way from this model, which lacks it.
    From(&'a dyn Model),
}

/// What is known of the rig's fitted numbers, beside which a record is asked.
#[derive(Clone, Copy)]
pub enum Beside<'a> {
    /// Nothing but standard deviations of those that other records know.
    Free(&'a [(usize, f64)]),
    /// All of them.
    Held,
}

/// The share that a record shows of the effect in the refitted model, whose parameters are `p`. `None` where the record cannot be followed, or
/// says nothing.
///
/// # Errors
/// As [`ident::innovations::pass`].
pub fn share(
    prepared: &Prepared,
    p: &[f64],
    way: &Way<'_>,
    noise: &Noise,
    track: &Track,
    beside: Beside<'_>,
) -> Result<Option<Share>, FitError> {
    let model: &dyn Model = &prepared.model;
    let noise = prepared.noise(noise);
    let track = track.begun(model, p);
    let own: &[usize] = match way {
        Way::Parameters(own) => own,
        Way::From(_) => &[],
    };
    let known = match beside {
        Beside::Free(known) => Some(known),
        Beside::Held => None,
    };
    let free = |(i, s): &(usize, &ParameterSpec)| known.is_some() && s.free && !own.contains(i);
    let base: Vec<usize> = prepared.specs.iter().enumerate().filter(free).map(|(i, _)| i).collect();
    let mut columns: Vec<Column<'_>> = base.iter().map(|&i| Column::Parameter(i)).collect();
    match way {
        Way::Parameters(own) => columns.extend(own.iter().map(|&i| Column::Parameter(i))),
        Way::From(other) => columns.push(Column::Towards(*other)),
    }
    let Some(pass) = pass(model, p, &track, &noise, &columns)? else { return Ok(None) };
    // along the effect as it was found; towards a model that lacks it is the way back
    let along: Vec<f64> = match way {
        Way::Parameters(own) => own.iter().map(|&i| p[i]).collect(),
        Way::From(_) => vec![-1.0],
    };
    let of_others = |i: usize| known.and_then(|known| known.iter().find(|(k, _)| *k == i)).map_or(0.0, |(_, sd)| sd.powi(-2));
    let prior = |&i: &usize| prepared.specs[i].prior_sd.map_or(0.0, |sd| sd.powi(-2)) + of_others(i);
    let priors: Vec<f64> = base.iter().map(prior).collect();
    Ok(step(&pass, columns.len(), &priors, &along))
}

fn step(pass: &Pass, count: usize, priors: &[f64], along: &[f64]) -> Option<Share> {
    let b = priors.len();
    // columns: the fitted parameters, then the effect
    let row_of = |row: &[f64]| -> DVector<f64> {
        let effect = row[b..].iter().zip(along).map(|(r, a)| r * a).sum::<f64>();
        DVector::from_iterator(b + 1, row[..b].iter().copied().chain([effect]))
    };
    let rows: Vec<DVector<f64>> = pass.jacobian.chunks_exact(count).map(row_of).collect();
    let mut normal = DMatrix::zeros(b + 1, b + 1);
    let mut right = DVector::zeros(b + 1);
    for (row, z) in rows.iter().zip(&pass.z) {
        if z.abs() < TAIL {
            normal.ger(1.0, row, row, 1.0);
        }
        right.axpy(-z.clamp(-TAIL, TAIL), row, 1.0);
    }
    for (i, prior) in priors.iter().enumerate() {
        normal[(i, i)] += prior;
    }
    let inverse = pseudo_inverse(&normal, 1e-11);
    let own = inverse.column(b).into_owned();
    if own[b] <= 0.0 || !own[b].is_finite() {
        return None;
    }
    let moved = inverse * right;
    // what each sample adds to the share, for its own variance
    let mut moments: Vec<(usize, f64)> = Vec::new();
    for ((row, z), (k, _)) in rows.iter().zip(&pass.z).zip(&pass.at) {
        let left = (z + row.dot(&moved)).clamp(-TAIL, TAIL);
        let part = own.dot(row) * left;
        match moments.last_mut() {
            Some((at, sum)) if at == k => *sum += part,
            _ => moments.push((*k, part)),
        }
    }
    let parts: Vec<f64> = moments.into_iter().map(|(_, part)| part).collect();
    let variance = variance_of_sum(&parts, LAGS);
    Some(Share { value: 1.0 + moved[b], sd: variance.max(own[b]).sqrt() })
}
