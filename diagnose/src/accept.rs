//! Whether an effect is accepted: it must help on records that it was not found on, and say the same in all of them.

use crate::answer::Figures;
use crate::base_fit::{Fitted, likelihoods};
use crate::chance::{beyond, mean_and_half_width};
use crate::error::DiagnoseError;
use crate::figures::{View, figures, shrink};
use crate::model::{Included, Prepared};
use crate::options::Options;
use ident::innovations::{Noise, Track};
use ident::record::Record;

/// A refitted candidate.
pub struct Tried {
    /// Its number among the candidates that are left.
    pub index: usize,
    /// Log-likelihood less its parameters.
    pub value: f64,
    /// Effects of this model.
    pub included: Vec<Included>,
    /// Model.
    pub prepared: Prepared,
    /// Fit.
    pub fitted: Fitted,
    /// Candidates that cannot be told from it.
    pub equivalent: Vec<usize>,
    /// Belongs to the day.
    pub per_record: bool,
    /// One step from zero of each parameter: by record, value and standard error.
    pub by_record: Vec<Vec<(f64, f64)>>,
}

/// What acceptance found.
pub struct Judged {
    /// Why not; `None`: accepted.
    pub refused: Option<String>,
    /// Gain on the test records [nats/sample], half width of its 95 % interval.
    pub gain: (f64, f64),
    /// Figures of the test records with the effect.
    pub figures: Figures,
}

/// Smallest p-value with which records may differ in an effect's size.
const DIFFER: f64 = 0.01;
/// Smallest share of the gap that an effect must close.
const CLOSES: f64 = 0.10;
/// Squared errors that differ by less are equal; where the gap is no larger than random forces make it, equal runs differ by chance.
const EQUAL: (f64, f64) = (1.01, 1.05);
/// Samples over which gains are allowed to hang together.
const LAGS: usize = 100;

/// Judges a refitted candidate against the model before it.
///
/// # Errors
/// [`DiagnoseError`] where a record cannot be followed by the model before.
#[allow(clippy::too_many_arguments)]
pub fn judge(
    before: &Fitted,
    prepared: &Prepared,
    tried: &Tried,
    test: &[Record],
    held: &[Track],
    figures_before: &Figures,
    seen: View,
    options: &Options<'_>,
) -> Result<Judged, DiagnoseError> {
    let after = figures(&tried.prepared.model, &[], &tried.fitted.mean(), &[], test, seen);
    let refuse = |why: String, gain: (f64, f64)| Ok(Judged { refused: Some(why), gain, figures: after.clone() });
    let none = (0.0, f64::INFINITY);
    let own = tried.prepared.of_effect.last().cloned().unwrap_or_default();
    let estimates: Vec<_> = tried.fitted.found.unknowns.iter().filter(|u| own.contains(&u.parameter)).collect();
    if !estimates.is_empty() && estimates.iter().all(|u| u.value.abs() < 1.96 * u.sd) {
        return refuse("refitted it vanishes".to_owned(), none);
    }
    if !options.method.other_records {
        let gain = (tried.fitted.found.log_likelihood - before.found.log_likelihood) / tried.fitted.found.samples.max(1) as f64;
        return Ok(Judged { refused: (gain <= 0.0).then(|| "it does not help".to_owned()), gain: (gain, 0.0), figures: after });
    }
    if let Some(p) = differ(&tried.by_record).filter(|p| *p < DIFFER && !tried.per_record) {
        return refuse(format!("training records contradict each other about its size (p = {p:.1e})"), none);
    }
    // with the noise of each, as each would predict; and both through the filter of the refitted one, since the noise of the model
    // before has grown to swallow what it lacks
    let noises = [(&before.found.noise, &tried.fitted.found.noise), (&tried.fitted.found.noise, &tried.fitted.found.noise)];
    let mut found = Vec::new();
    for (old, new) in noises {
        let Some(gains) = gains(before, prepared, old, tried, new, held)? else {
            return refuse("a test record cannot be followed with it".to_owned(), none);
        };
        found.push(mean_and_half_width(&gains, LAGS));
    }
    let gain = if found[0].0 > found[0].1 { found[0] } else { found[1] };
    if gain.0 - gain.1 <= 0.0 {
        return refuse(format!("no gain on other records: {:.2e} +- {:.1e} nats/sample", gain.0, gain.1), gain);
    }
    let shrunk = shrink(&tried.prepared.model, &tried.fitted.mean(), &tried.fitted.found.noise, held, figures_before, &after);
    let best = shrunk.iter().map(|s| s.1).fold(f64::NEG_INFINITY, f64::max);
    let (worse, better) = weighed(figures_before, &after);
    if best < CLOSES && !shrunk.is_empty() {
        return refuse(format!("it closes only {:.0} % of the gap on other records", 100.0 * best), gain);
    }
    if worse > better * if shrunk.is_empty() { EQUAL.1 } else { EQUAL.0 } {
        return refuse("it makes the run on other records worse".to_owned(), gain);
    }
    Ok(Judged { refused: None, gain, figures: after })
}

/// Gain of log-likelihood at each sample of the test records, the models with these noises. `None` where the refitted model cannot be
/// followed.
pub fn gains(
    before: &Fitted,
    prepared: &Prepared,
    noise_before: &Noise,
    tried: &Tried,
    noise: &Noise,
    held: &[Track],
) -> Result<Option<Vec<f64>>, DiagnoseError> {
    let old = likelihoods(prepared, before, noise_before, held)?;
    let new = likelihoods(&tried.prepared, &tried.fitted, noise, held)?;
    let mut gains = Vec::new();
    for (old, new) in old.iter().zip(&new) {
        match (old, new) {
            (Some(old), Some(new)) => gains.extend(old.iter().zip(new).map(|(o, n)| n - o)),
            (_, None) => return Ok(None),
            (None, Some(_)) => {}
        }
    }
    Ok(Some(gains))
}

/// p-value of equal sizes in all records; `None` for one record.
fn differ(by_record: &[Vec<(f64, f64)>]) -> Option<f64> {
    let told: Vec<&Vec<(f64, f64)>> = by_record.iter().filter(|r| r.iter().all(|(_, sd)| sd.is_finite())).collect();
    if told.len() < 2 {
        return None;
    }
    let parameters = told[0].len();
    let mut least = 1.0_f64;
    for k in 0..parameters {
        let weight: f64 = told.iter().map(|r| r[k].1.powi(-2)).sum();
        let mean = told.iter().map(|r| r[k].0 * r[k].1.powi(-2)).sum::<f64>() / weight;
        let spread: f64 = told.iter().map(|r| ((r[k].0 - mean) / r[k].1).powi(2)).sum();
        least = least.min(beyond(spread, told.len() - 1) * parameters as f64);
    }
    Some(least.min(1.0))
}

/// Errors after and before on test records, each over that before.
fn weighed(before: &Figures, after: &Figures) -> (f64, f64) {
    let (mut new, mut old) = (0.0, 0.0);
    for (b, a) in before.test.iter().zip(&after.test) {
        if let (Some(b), Some(a)) = (b.rmse, a.rmse)
            && b > 0.0
        {
            new += (a / b).powi(2);
            old += 1.0;
        }
    }
    (new, old)
}
