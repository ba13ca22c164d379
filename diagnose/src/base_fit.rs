//! Fits of the base and of patched models, by innovations.

use crate::answer::Figure;
use crate::error::DiagnoseError;
use crate::figures::{Judged, View, compared};
use crate::model::{Included, Prepared, prepare};
use crate::options::Options;
use crate::patch::Base;
use crate::quality::ahead;
use ident::fit::minimize::Limits;
use ident::fit::{FitError, FitOptions, Loss, ParameterSpec, identify};
use ident::innovations::{EstimateOptions, Estimated, Noise, Track, estimate, likelihood};
use ident::record::Record;
use sim::Hold;
use std::sync::Arc;

/// A fitted model.
#[derive(Clone)]
pub struct Fitted {
    /// Parameters, noise, likelihood.
    pub found: Estimated,
    /// Names of the model's parameters.
    pub names: Vec<String>,
    /// Parameters of each test record: those of the day from its first half.
    pub of_test: Vec<Vec<f64>>,
    /// The rig's parameters as they are treated: as the request has them, or held near where a model that would be lost predicts best.
    pub asked: Arc<[ParameterSpec]>,
    /// They are held so.
    pub lost: bool,
}

/// Training records as an output error starts from them, with how their inputs are held.
pub struct Starting {
    /// Records.
    pub records: Vec<Record>,
    /// Between samples.
    pub hold: Hold,
    /// The rig's parameters as the request has them.
    pub asked: Arc<[ParameterSpec]>,
}

impl Starting {
    /// Parameters of each record by output error; `None` where there is nothing to fit or it does not get anywhere.
    fn output_error(&self, prepared: &Prepared) -> Option<Vec<Vec<f64>>> {
        if prepared.specs.iter().all(|s| !s.free) {
            return None;
        }
        // to its end: from a start half way the innovations go astray on records of axes that drift
        let limits = Limits { evaluations: 40, ..Limits::default() };
        // a start needs no more digits than the encoders have
        let fit = FitOptions { limits, hold: self.hold, loss: Loss::Huber(1.345), tolerance: 0.05, ..FitOptions::default() };
        identify(&prepared.model, &prepared.specs, &self.records, &[], &fit).ok().map(|found| found.p_of_record)
    }
}

impl Fitted {
    /// Parameters of the rig: those of the day as the mean over the records.
    pub fn mean(&self) -> Vec<f64> {
        let records = self.found.p.len().max(1) as f64;
        let length = self.found.p.first().map_or(0, Vec::len);
        (0..length).map(|i| self.found.p.iter().map(|p| p[i]).sum::<f64>() / records).collect()
    }

    /// What figures are made of.
    pub fn judged<'a>(&'a self, prepared: &'a Prepared) -> Judged<'a> {
        Judged { prepared, noise: &self.found.noise, p_train: &self.found.p, p_test: &self.of_test }
    }

    /// The noise, with the forces where another model has them.
    pub fn noise_in(&self, other: &Prepared, whitening: bool) -> Noise {
        let mut noise = other.noise(&self.found.noise);
        if !whitening {
            still(&mut noise);
        }
        noise
    }
}

/// The middle of a record.
pub fn middle(track: &Track) -> usize {
    track.times().len() / 2
}

/// Parameters of records that were not fitted: those of the day are found from the first half of each.
pub fn from_first_halves(prepared: &Prepared, found: &Estimated, held: &[Track]) -> Vec<Vec<f64>> {
    let records = found.p.len().max(1) as f64;
    let mean: Vec<f64> = (0..prepared.specs.len()).map(|i| found.p.iter().map(|p| p[i]).sum::<f64>() / records).collect();
    let of_the_day: Vec<ParameterSpec> =
        prepared.specs.iter().map(|s| ParameterSpec { free: s.free && s.per_record, per_record: false, ..s.clone() }).collect();
    if of_the_day.iter().all(|s| !s.free) {
        return vec![mean; held.len()];
    }
    let of = |track: &Track| {
        let mut half = [track.part(0, middle(track), &prepared.model, &mean)];
        let effort = EstimateOptions { rounds: 0, evaluations: 10, ..EstimateOptions::default() };
        let noise = prepared.noise(&found.noise);
        let fitted = estimate(&prepared.model, &of_the_day, &mut half, std::slice::from_ref(&mean), noise, effort);
        fitted.map_or_else(|_| mean.clone(), |f| f.p[0].clone())
    };
    held.iter().map(of).collect()
}

/// No random forces.
fn still(noise: &mut Noise) {
    noise.sd.iter_mut().for_each(|s| *s = 0.0);
}

/// A fit by innovations whose squared predictions are this much worse than where it began has lost the rig. (A model that lacks an effect
/// may well predict somewhat worse with parameters that are nearer to the truth.)
const LOST: f64 = 8.0;
/// How far parameters may then go from there, as a prior.
const NEAR: f64 = 0.1;

/// Samples at the beginning of each record by which a start is chosen.
const CHOOSES: usize = 3000;

/// Fits the rig as it is: from its own values and from those of output error, whichever the records find likelier.
///
/// Likelihood alone can lose a rig whose model is far from it: heavier and heavier bodies, pushed by larger and larger random forces, until
/// the inputs do nothing. Where the fit predicts worse than where it began, parameters stay near there.
pub fn fit_base(
    plain: &Prepared,
    (train, starting): (&[Record], &Starting),
    tracks: &mut [Track],
    held: &[Track],
    options: &Options<'_>,
) -> Result<Fitted, DiagnoseError> {
    let p0: Vec<f64> = plain.specs.iter().map(|s| s.value).collect();
    let mut starts = vec![vec![p0.clone(); tracks.len()]];
    starts.extend(starting.output_error(plain));
    let mut best: Option<Estimated> = None;
    let mut failed = None;
    for start in &starts {
        let mut own: Vec<Track> = tracks.iter().map(|t| t.part(0, t.times().len().min(CHOOSES), &plain.model, &p0)).collect();
        let noise = plain.noise(&Noise::guess(&plain.model, &p0, &own, plain.entries.clone()));
        let rounds = EstimateOptions { rounds: 2, finest: 0.4, ..EstimateOptions::default() };
        match estimate(&plain.model, &plain.specs, &mut own, start, noise, rounds) {
            Ok(found) => {
                if best.as_ref().is_none_or(|b| found.log_likelihood > b.log_likelihood) {
                    best = Some(found);
                }
            }
            Err(e) => failed = Some(e),
        }
    }
    let Some(best) = best else { return Err(DiagnoseError::Fit(failed.unwrap_or(FitError::NoRecord))) };
    let found = estimate(&plain.model, &plain.specs, tracks, &best.p, best.noise, EstimateOptions::default())?;
    let names: Vec<String> = plain.specs.iter().map(|s| s.name.clone()).collect();
    let view = View { hold: options.hold, horizon: Some(ahead(plain, &p0)) };
    let error = |p: &[Vec<f64>]| {
        let each: Vec<Figure> = train.iter().zip(p).flat_map(|(record, p)| compared(&plain.model, p, record, view)).collect();
        error(&each)
    };
    let nearest = starts.iter().map(|p| (error(p), p)).min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, start)) = nearest.filter(|(least, _)| error(&found.p) > LOST * least) else {
        let of_test = from_first_halves(plain, &found, held);
        return Ok(Fitted { found, names, of_test, asked: starting.asked.clone(), lost: false });
    };
    (options.progress)("  likelihood alone would lose the rig: parameters stay near those that predict best");
    let near = |specs: &[ParameterSpec]| -> Vec<ParameterSpec> {
        let mut specs = specs.to_vec();
        for s in specs.iter_mut().filter(|s| s.free && s.prior_sd.is_none()) {
            if let Some(k) = names.iter().position(|n| *n == s.name) {
                let mean = start.iter().map(|p| p[k]).sum::<f64>() / start.len() as f64;
                (s.prior_mean, s.prior_sd) = (mean, (mean != 0.0).then(|| NEAR * mean.abs()));
            }
        }
        specs
    };
    let noise = plain.noise(&Noise::guess(&plain.model, &p0, tracks, plain.entries.clone()));
    let found = estimate(&plain.model, &near(&plain.specs), tracks, start, noise, EstimateOptions::default())?;
    let asked = near(&starting.asked).into();
    let of_test = from_first_halves(plain, &found, held);
    Ok(Fitted { found, names, of_test, asked, lost: true })
}

/// Fits a patched rig from the rig's own values, by output error first: where the base was lost, no way leads from there.
pub fn anew(
    base: &Base,
    starting: &Starting,
    included: &[Included],
    (tracks, held): (&[Track], &[Track]),
) -> Result<(Arc<Prepared>, Fitted), DiagnoseError> {
    let prepared = prepare(base, &starting.asked, included, included.len())?;
    let start = starting.output_error(&prepared).ok_or(DiagnoseError::Fit(FitError::NoRecord))?;
    let mut own = tracks.to_vec();
    let noise = prepared.noise(&Noise::guess(&prepared.model, &start[0], &own, prepared.entries.clone()));
    let rounds = EstimateOptions { rounds: 2, ..EstimateOptions::default() };
    let found = estimate(&prepared.model, &prepared.specs, &mut own, &start, noise, rounds)?;
    let names = prepared.specs.iter().map(|s| s.name.clone()).collect();
    let of_test = from_first_halves(&prepared, &found, held);
    Ok((Arc::new(prepared), Fitted { found, names, of_test, asked: starting.asked.clone(), lost: false }))
}

/// Squared errors over all signals, each over its own size.
fn error(figures: &[Figure]) -> f64 {
    let each: Vec<f64> = figures.iter().filter_map(|f| f.fit_percent).map(|p| (1.0 - 0.01 * p).powi(2)).collect();
    if each.is_empty() { f64::INFINITY } else { each.iter().sum() }
}

/// Fits a patched rig from where the search stands. Not `thorough`: the noise stays as it is.
pub fn refit(
    base: &Base,
    included: &[Included],
    from: &Fitted,
    (tracks, held): (&[Track], &[Track]),
    thorough: bool,
) -> Result<(Arc<Prepared>, Fitted), DiagnoseError> {
    let prepared = prepare(base, &from.asked, included, included.len())?;
    let start: Vec<Vec<f64>> = from
        .found
        .p
        .iter()
        .map(|p| prepared.specs.iter().map(|s| from.names.iter().position(|n| *n == s.name).map_or(s.value, |i| p[i])).collect())
        .collect();
    let noise = prepared.noise(&from.found.noise);
    let effort = if thorough {
        EstimateOptions { rounds: 3, ..EstimateOptions::default() }
    } else {
        EstimateOptions { rounds: 0, evaluations: 10, ..EstimateOptions::default() }
    };
    let mut own = tracks.to_vec();
    let found = estimate(&prepared.model, &prepared.specs, &mut own, &start, noise, effort)?;
    let names = prepared.specs.iter().map(|s| s.name.clone()).collect();
    let of_test = from_first_halves(&prepared, &found, held);
    Ok((Arc::new(prepared), Fitted { found, names, of_test, asked: from.asked.clone(), lost: from.lost }))
}

/// Likelihood of test records, by sample, with the sizes of `noise`; each record begins as its first samples say.
pub fn likelihoods(prepared: &Prepared, fitted: &Fitted, noise: &Noise, tracks: &[Track]) -> Result<Vec<Option<Vec<f64>>>, FitError> {
    let noise = prepared.noise(noise);
    tracks.iter().zip(&fitted.of_test).map(|(track, p)| likelihood(&prepared.model, p, track, &noise)).collect()
}
