//! Whether an effect is accepted: it must help on records that it was not found on, and say the same in all of them.

use crate::answer::Figures;
use crate::base_fit::Fitted;
use crate::chance::beyond;
use crate::error::DiagnoseError;
use crate::figures::{View, figures, shrink};
use crate::model::{Included, Prepared};
use crate::options::Options;
use crate::shown::{Share, Way, share};
use ident::innovations::Track;
use ident::record::Record;
use std::fmt;

/// A refitted candidate.
pub struct Tried {
    /// Its number among the candidates that are left.
    pub index: usize,
    /// Log-likelihood less what its parameters cost.
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
}

/// What acceptance found.
pub struct Judged {
    /// Why not; `None`: accepted.
    pub refused: Option<Refusal>,
    /// Gain on the test records [nats/sample], half width of its 95 % interval.
    pub gain: (f64, f64),
    /// Figures of the test records with the effect.
    pub figures: Figures,
}

/// Why an effect is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// Refitted, it is not there.
    Vanishes,
    /// Records say different things of its size.
    Contradiction {
        /// Probability of a difference as large where the sizes are equal.
        p: f64,
        /// Share of the effect that each record shows.
        shares: Vec<(String, Share)>,
    },
    /// The test records could not show it, were it there as it was found.
    Untold(Option<Share>),
    /// The test records could show it and do not.
    NoGain(Share),
    /// It closes too little of the gap on the test records.
    Small(f64),
    /// It makes predictions of the test records worse.
    Worse,
    /// A test record cannot be followed with it.
    Lost,
    /// Another one, which is refused, explains the training records better.
    Shadow,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let share = |s: &Share| format!("{:.2} +- {:.2}", s.value, 1.96 * s.sd);
        match self {
            Self::Vanishes => write!(f, "refitted it vanishes"),
            Self::Contradiction { p, shares } => {
                let list: Vec<String> = shares.iter().map(|(name, s)| format!("{} in {name}", share(s))).collect();
                write!(f, "records contradict each other about its size (p = {p:.1e}; shares {})", list.join(", "))
            }
            Self::Untold(Some(s)) => write!(f, "the test records cannot show it: they see {} of it", share(s)),
            Self::Untold(None) => write!(f, "the test records do not exercise it"),
            Self::NoGain(s) => write!(f, "the test records do not have it: they show {} of it", share(s)),
            Self::Small(closed) => write!(f, "it closes only {:.0} % of the gap on other records", 100.0 * closed),
            Self::Worse => write!(f, "it makes predictions on other records worse"),
            Self::Lost => write!(f, "a test record cannot be followed with it"),
            Self::Shadow => write!(f, "an effect that is refused explains the training records better"),
        }
    }
}

/// Smallest p-value with which records may differ in an effect's size.
const DIFFER: f64 = 0.01;
/// Shares that differ by less are equal: no model is exact.
const SAME_SIZE: f64 = 0.1;
/// Standard error of a share above which a record could not confirm the effect if it showed all of it.
const TELLS: f64 = 0.5 / 1.645;
/// Smallest share of the gap that an effect must close.
const CLOSES: f64 = 0.10;
/// Squared errors that differ by less are equal; where the gap is no larger than random forces make it, equal runs differ by chance.
const EQUAL: (f64, f64) = (1.01, 1.05);

/// Records, and the refitted base on them, by which a candidate is judged.
pub struct Bench<'a> {
    /// The model before.
    pub prepared: &'a Prepared,
    /// Its fit.
    pub fitted: &'a Fitted,
    /// Training records.
    pub train: &'a [Track],
    /// Test records.
    pub held: &'a [Track],
    /// Test records as they were read.
    pub test: &'a [Record],
    /// Predictions of the model before.
    pub before: &'a Figures,
    /// How predictions are made.
    pub view: View,
}

/// Judges a refitted candidate against the model before it.
///
/// # Errors
/// [`DiagnoseError`] where a training record cannot be followed.
pub fn judge(bench: &Bench<'_>, tried: &Tried, options: &Options<'_>) -> Result<Judged, DiagnoseError> {
    let after = figures(&tried.prepared.model, &[], &tried.fitted.mean(), &[], bench.test, bench.view);
    let refuse = |why: Refusal, gain: (f64, f64)| Ok(Judged { refused: Some(why), gain, figures: after.clone() });
    let none = (0.0, f64::INFINITY);
    let own = tried.prepared.of_effect.last().cloned().unwrap_or_default();
    let estimates: Vec<_> = tried.fitted.found.unknowns.iter().filter(|u| own.contains(&u.parameter)).collect();
    if !estimates.is_empty() && estimates.iter().all(|u| u.value.abs() < 1.96 * u.sd) {
        return refuse(Refusal::Vanishes, none);
    }
    if !options.method.other_records {
        let gain = (tried.fitted.found.log_likelihood - bench.fitted.found.log_likelihood) / tried.fitted.found.samples.max(1) as f64;
        return Ok(Judged { refused: (gain <= 0.0).then_some(Refusal::Vanishes), gain: (gain, 0.0), figures: after });
    }
    let way = if estimates.is_empty() { Way::From(&bench.prepared.model) } else { Way::Parameters(&own) };
    let noise = &tried.fitted.found.noise;
    let of = |track: &Track| share(&tried.prepared, &tried.fitted, &way, noise, track);
    let train: Vec<Option<Share>> = bench.train.iter().map(of).collect::<Result<_, _>>()?;
    let mut held = Vec::new();
    for track in bench.held {
        match of(track) {
            Ok(share) => held.push(share),
            Err(_) => return refuse(Refusal::Lost, none),
        }
    }
    let samples: usize = bench.held.iter().map(|t| t.times().len()).sum();
    let pooled = pool(held.iter().flatten());
    let gain = pooled.map_or(none, |s| {
        let (gain, half) = s.gain();
        (gain / samples.max(1) as f64, half / samples.max(1) as f64)
    });
    let names = bench.train.iter().chain(bench.held).map(|t| t.source().to_owned());
    let told: Vec<(String, Share)> =
        names.zip(train.iter().chain(&held)).filter_map(|(name, s)| s.filter(|s| s.sd < 1.0).map(|s| (name, s))).collect();
    let p = differ(&told);
    if p < DIFFER && !tried.per_record {
        return refuse(Refusal::Contradiction { p, shares: told }, gain);
    }
    let Some(pooled) = pooled.filter(|s| s.sd < TELLS) else { return refuse(Refusal::Untold(pooled), gain) };
    if gain.0 <= gain.1 * (1.645 / 1.96) {
        return refuse(Refusal::NoGain(pooled), gain);
    }
    let shrunk = shrink(&tried.prepared.model, &tried.fitted.mean(), noise, bench.held, bench.before, &after);
    let best = shrunk.iter().map(|s| s.1).fold(f64::NEG_INFINITY, f64::max);
    let (worse, better) = weighed(bench.before, &after);
    if best < CLOSES && !shrunk.is_empty() {
        return refuse(Refusal::Small(best), gain);
    }
    if worse > better * if shrunk.is_empty() { EQUAL.1 } else { EQUAL.0 } {
        return refuse(Refusal::Worse, gain);
    }
    Ok(Judged { refused: None, gain, figures: after })
}

/// The share that several records show together.
fn pool<'a>(shares: impl Iterator<Item = &'a Share>) -> Option<Share> {
    let (mut weight, mut sum) = (0.0, 0.0);
    for s in shares {
        weight += s.sd.powi(-2);
        sum += s.value * s.sd.powi(-2);
    }
    (weight > 0.0).then(|| Share { value: sum / weight, sd: weight.recip().sqrt() })
}

/// p-value of equal sizes in all records; 1 for a single one.
fn differ(told: &[(String, Share)]) -> f64 {
    let wide = |s: &Share| Share { sd: s.sd.hypot(SAME_SIZE), ..*s };
    let wide: Vec<Share> = told.iter().map(|(_, s)| wide(s)).collect();
    let Some(mean) = pool(wide.iter()) else { return 1.0 };
    let spread: f64 = wide.iter().map(|s| ((s.value - mean.value) / s.sd).powi(2)).sum();
    beyond(spread, wide.len() - 1)
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
