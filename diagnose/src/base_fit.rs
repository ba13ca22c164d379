//! Fits of the base and of patched models, by innovations.

use crate::model::{Included, Prepared, prepare};
use crate::patch::Base;
use crate::workflow::{DiagnoseError, Options};
use ident::fit::minimize::Limits;
use ident::fit::{FitError, FitOptions, ParameterSpec, identify};
use ident::innovations::{Estimated, EstimateOptions, Noise, Track, estimate, likelihood};
use ident::record::Record;

/// A fitted model.
#[derive(Clone)]
pub struct Fitted {
    /// Parameters, noise, likelihood.
    pub found: Estimated,
    /// Names of the model's parameters.
    pub names: Vec<String>,
}

impl Fitted {
    /// Parameters for a record that was not fitted: those of the day as the mean over the records.
    pub fn mean(&self) -> Vec<f64> {
        let records = self.found.p.len().max(1) as f64;
        let length = self.found.p.first().map_or(0, Vec::len);
        (0..length).map(|i| self.found.p.iter().map(|p| p[i]).sum::<f64>() / records).collect()
    }

    /// The noise, with the forces where another model has them.
    pub fn noise_in(&self, other: &Prepared, whitening: bool) -> Noise {
        let mut noise = Noise { entries: other.entries.clone(), ..self.found.noise.clone() };
        if !whitening {
            still(&mut noise);
        }
        noise
    }
}

/// No random forces.
fn still(noise: &mut Noise) {
    noise.sd.iter_mut().for_each(|s| *s = 0.0);
}

/// Fits the rig as it is: from its own values and from those of output error, whichever the records find likelier.
pub fn fit_base(plain: &Prepared, train: &[Record], tracks: &mut [Track], options: &Options<'_>) -> Result<Fitted, DiagnoseError> {
    let p0: Vec<f64> = plain.specs.iter().map(|s| s.value).collect();
    let mut starts = vec![vec![p0.clone(); tracks.len()]];
    if plain.specs.iter().any(|s| s.free) {
        let fit = FitOptions { limits: Limits { evaluations: 40, ..Limits::default() }, hold: options.hold, ..FitOptions::default() };
        if let Ok(found) = identify(&plain.model, &plain.specs, train, &[], &fit) {
            starts.push(found.p_of_record);
        }
    }
    let mut best: Option<Estimated> = None;
    let mut failed = None;
    for start in &starts {
        let noise = Noise::guess(&plain.model, &p0, tracks, plain.entries.clone());
        let mut own = tracks.to_vec();
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
    Ok(Fitted { found, names: plain.specs.iter().map(|s| s.name.clone()).collect() })
}

/// Fits a patched rig from where the search stands. Not `thorough`: the noise stays as it is.
pub fn refit(
    base: &Base,
    asked: &[ParameterSpec],
    included: &[Included],
    from: &Fitted,
    tracks: &mut [Track],
    thorough: bool,
) -> Result<(Prepared, Fitted), DiagnoseError> {
    let prepared = prepare(base, asked, included, included.len())?;
    let start: Vec<Vec<f64>> = from
        .found
        .p
        .iter()
        .map(|p| prepared.specs.iter().map(|s| from.names.iter().position(|n| *n == s.name).map_or(s.value, |i| p[i])).collect())
        .collect();
    let noise = Noise { entries: prepared.entries.clone(), ..from.found.noise.clone() };
    let effort = if thorough {
        EstimateOptions { rounds: 3, ..EstimateOptions::default() }
    } else {
        EstimateOptions { rounds: 1, finest: f64::INFINITY, evaluations: 10 }
    };
    let mut own = tracks.to_vec();
    let found = estimate(&prepared.model, &prepared.specs, &mut own, &start, noise, effort)?;
    let names = prepared.specs.iter().map(|s| s.name.clone()).collect();
    Ok((prepared, Fitted { found, names }))
}

/// Likelihood of test records, by sample, with the sizes of `noise`; each record begins as its first samples say.
pub fn likelihoods(prepared: &Prepared, fitted: &Fitted, noise: &Noise, tracks: &[Track]) -> Result<Vec<Option<Vec<f64>>>, FitError> {
    let p = fitted.mean();
    let noise = Noise { entries: prepared.entries.clone(), ..noise.clone() };
    tracks.iter().map(|track| likelihood(&prepared.model, &p, track, &noise)).collect()
}
