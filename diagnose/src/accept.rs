//! Whether an effect is accepted: it must help on records that it was not found on, and say the same in all of them.

use crate::base_fit::{Fitted, from_first_halves, middle};
use crate::chance::{beyond, variance_of_sum};
use crate::effects::Edit;
use crate::figures::{self, NONE, predictions};
use crate::model::{Included, Prepared};
use crate::options::Options;
use crate::shown::{Beside, Share, Way, share};
use ident::innovations::{Ahead, Estimated, Track};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

/// A refitted candidate.
pub struct Tried {
    /// Its number among the candidates that are left.
    pub index: usize,
    /// Log-likelihood less what its parameters cost.
    pub value: f64,
    /// Effects of this model.
    pub included: Vec<Included>,
    /// Model.
    pub prepared: Arc<Prepared>,
    /// Fit.
    pub fitted: Fitted,
    /// Candidates that cannot be told from it.
    pub equivalent: Vec<usize>,
}

/// What acceptance found.
pub struct Ruling {
    /// Why not; `None`: accepted.
    pub refused: Option<Refusal>,
    /// Gain on the test records [nats/sample], half width of its 95 % interval.
    pub gain: (f64, f64),
    /// Squared error of predictions of the test records with the effect over that without, neither smaller than noise makes it; mean over
    /// signals.
    pub error_ratio: f64,
}

/// Why an effect is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// Refitted, it is not there.
    Vanishes,
    /// Refitted, it is larger than such a thing can be: this parameter, at this value.
    Absurd {
        /// Parameter.
        parameter: String,
        /// Value (SI).
        value: f64,
    },
    /// Records say different things of its size.
    Contradiction {
        /// Probability of a difference as large where the sizes are equal.
        p: f64,
        /// Share of the effect that each record shows.
        shares: Vec<(String, Share)>,
    },
    /// The test records show too little to say: neither that it is there as it was found, nor that it is not.
    Untold(Option<Share>),
    /// The test records show less of it.
    NoGain(Share),
    /// It closes too little of the gap on the test records.
    Small(f64),
    /// It makes predictions of the test records worse.
    Worse,
    /// A record cannot be followed with it.
    Lost,
    /// The text with the numbers as they were found is no rig's.
    NoRig,
    /// Another one, which is refused, explains the training records better.
    Shadow,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let share = |s: &Share| format!("{:.2} +- {:.2}", s.value, 1.96 * s.sd);
        match self {
            Self::Vanishes => write!(f, "refitted it vanishes"),
            Self::Absurd { parameter, value } => write!(f, "refitted, {parameter} is {value:.2}, larger than such a thing can be"),
            Self::Contradiction { p, shares } => {
                let list: Vec<String> = shares.iter().map(|(name, s)| format!("{} in {name}", share(s))).collect();
                write!(f, "records contradict each other about its size (p = {p:.1e}; shares {})", list.join(", "))
            }
            Self::Untold(Some(s)) => write!(f, "the test records cannot confirm it: they show {} of it", share(s)),
            Self::Untold(None) => write!(f, "the test records do not exercise it"),
            Self::NoGain(s) => write!(f, "the test records do not have it: they show {} of it", share(s)),
            Self::Small(closed) => write!(f, "it closes only {:.0} % of the gap on other records", 100.0 * closed),
            Self::Worse => write!(f, "it makes predictions on other records worse"),
            Self::NoRig => write!(f, "refitted, it asks for a body that cannot be"),
            Self::Lost => write!(f, "a record cannot be followed with it"),
            Self::Shadow => write!(f, "an effect that is refused explains the training records better"),
        }
    }
}

/// Smallest p-value with which records may differ in an effect's size.
const DIFFER: f64 = 0.01;
/// Shares that differ by less are equal: no model is exact.
const SAME_SIZE: f64 = 0.1;
/// Standard error of a share beyond which the test records say nothing of the effect.
const TELLS: f64 = 0.5;
/// Smallest share of the gap that an effect must close.
const CLOSES: f64 = 0.10;
/// Largest squared error of predictions over that without the effect: beyond, no scatter excuses it.
const WORSE: f64 = 1.1;
/// Log-likelihood that an effect, as the training records found it, must gain on the test records: they are 20 times as likely with it. Where
/// it is absent its share is normal about 0, and this happens in Phi(-sqrt(2 ln 20)) = 0.7 % at most, whatever its error.
const LIKELY: f64 = 2.9957;
/// The same, 100 times (0.1 %).
const SURE: f64 = 4.6052;
/// Standard errors by which a number is surely not zero.
const KNOWN: f64 = 5.0;
/// Normal quantile of one-sided tests at 1 %, where several signals are asked, or less is known.
const CLEARLY: f64 = 2.326;
/// Normal quantile of one-sided tests at 5 %.
const ONE_SIDED: f64 = 1.645;

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
    /// Predictions of the model before, of each test record.
    pub before: &'a [Vec<Ahead>],
    /// Seconds ahead that are predicted.
    pub horizon: f64,
}

/// Judges a refitted candidate against the model before it.
pub fn judge(bench: &Bench<'_>, tried: &Tried, options: &Options<'_>) -> Ruling {
    let by_record = tried.included.last().is_some_and(|i| i.effect.by_record);
    // what belongs to the day is judged on the second half of every record, with what its first half says
    let (later, p_later) =
        if by_record { second_halves(bench, &tried.prepared, &tried.fitted) } else { (bench.held.to_vec(), tried.fitted.of_test.clone()) };
    let before = if by_record {
        let (_, p_test) = second_halves(bench, bench.prepared, bench.fitted);
        Cow::Owned(predictions(figures::Judged { p_test: &p_test, ..bench.fitted.judged(bench.prepared) }, &later, bench.horizon))
    } else {
        Cow::Borrowed(bench.before)
    };
    let new = figures::Judged { p_test: &p_later, ..tried.fitted.judged(&tried.prepared) };
    let weighed = weigh(&before, &predictions(new, &later, bench.horizon), bench.horizon);
    // from starts that filters of equal noise find: where it is another, errors differ for that alone
    let alike = figures::Judged { noise: &bench.fitted.found.noise, ..new };
    let alike = weigh(&before, &predictions(alike, &later, bench.horizon), bench.horizon);
    let error_ratio = alike.iter().map(Weighed::ratio).sum::<f64>() / alike.len().max(1) as f64;
    let refuse = |why: Refusal, gain: (f64, f64)| Ruling { refused: Some(why), gain, error_ratio };
    let none = (0.0, f64::INFINITY);
    let own = tried.prepared.of_effect.last().cloned().unwrap_or_default();
    let estimates: Vec<_> = tried.fitted.found.unknowns.iter().filter(|u| own.contains(&u.parameter)).collect();
    if !estimates.is_empty() && estimates.iter().all(|u| u.value.abs() < 1.96 * u.sd) {
        return refuse(Refusal::Vanishes, none);
    }
    if let Some(why) = absurd(tried) {
        return refuse(why, none);
    }
    if !options.method.other_records {
        let gain = (tried.fitted.found.log_likelihood - bench.fitted.found.log_likelihood) / tried.fitted.found.samples.max(1) as f64;
        return Ruling { refused: (gain <= 0.0).then_some(Refusal::Vanishes), gain: (gain, 0.0), error_ratio };
    }
    let way = if estimates.is_empty() { Way::From(&bench.prepared.model) } else { Way::Parameters(&own) };
    let noise = &tried.fitted.found.noise;
    let of = |p: &[f64], track: &Track, known: &[(usize, f64)]| {
        let beside = if options.method.absorption { Beside::Free(known) } else { Beside::Held };
        share(&tried.prepared, p, &way, noise, track, beside)
    };
    let known = known(&tried.fitted.found);
    let mut train: Vec<(String, Option<Share>)> = Vec::new();
    let mut held: Vec<(String, Option<Share>)> = Vec::new();
    for (track, p) in bench.train.iter().zip(&tried.fitted.found.p).filter(|_| !by_record) {
        let Ok(share) = of(p, track, &[]) else { return refuse(Refusal::Lost, none) };
        train.push((track.source().to_owned(), share));
    }
    for (track, p) in later.iter().zip(&p_later) {
        match of(p, track, &known) {
            Ok(share) => held.push((track.source().to_owned(), share)),
            Err(_) => return refuse(Refusal::Lost, none),
        }
    }
    let samples: usize = later.iter().map(|t| t.times().len()).sum();
    let pooled = pool(held.iter().filter_map(|(_, s)| s.as_ref()));
    let gain = pooled.map_or(none, |s| {
        let (gain, half) = s.gain();
        (gain / samples.max(1) as f64, half / samples.max(1) as f64)
    });
    let told: Vec<(String, Share)> =
        train.into_iter().chain(held).filter_map(|(name, s)| s.filter(|s| s.sd < 1.0).map(|s| (name, s))).collect();
    let p = if by_record { stays(&told) } else { differ(&told) };
    if p < DIFFER {
        return refuse(Refusal::Contradiction { p, shares: told }, gain);
    }
    let Some(pooled) = pooled else { return refuse(Refusal::Untold(None), gain) };
    if pooled.sd > TELLS {
        return refuse(Refusal::Untold(Some(pooled)), gain);
    }
    // what is of the day has no other record that confirms it
    let sure = if by_record { SURE } else { LIKELY };
    if gain.0 * samples.max(1) as f64 <= sure {
        let whole = pooled.value + 1.96 * pooled.sd.hypot(SAME_SIZE) > 1.0;
        return refuse(if whole { Refusal::Untold(Some(pooled)) } else { Refusal::NoGain(pooled) }, gain);
    }
    // when a sensor shows a motion says nothing of where the motion goes; what it says of the next sample, the record has confirmed
    let when = tried.included.last().is_some_and(|i| matches!(i.effect.edit, Edit::Output { entry: "play" | "delay", .. }));
    // where what is there is no larger than noise makes it, there is no gap to close
    let gaps: Vec<&Weighed> = weighed.iter().filter(|w| w.before > NONE * w.floor).collect();
    // what an instrument does may drown in what pushes the rig meanwhile: from one sample to the next it does not
    let instrument = tried.included.last().is_some_and(|i| matches!(i.effect.edit, Edit::Output { .. }));
    let at_once = || {
        let period = bench.held.iter().map(period).fold(f64::INFINITY, f64::min);
        let (_, p_test) =
            if by_record { second_halves(bench, bench.prepared, bench.fitted) } else { (Vec::new(), bench.fitted.of_test.clone()) };
        let of = |judged: figures::Judged<'_>, p_test: &[Vec<f64>]| predictions(figures::Judged { p_test, ..judged }, &later, period);
        let before = of(bench.fitted.judged(bench.prepared), &p_test);
        let each = weigh(&before, &of(tried.fitted.judged(&tried.prepared), &p_later), period);
        each.iter().any(Weighed::closes)
    };
    // a small gap that is closed beyond chance says more than a large one that something else has made
    let closed = || weighed.iter().any(Weighed::closes) || (instrument && at_once());
    if !when && !gaps.is_empty() && gaps.iter().all(|w| w.closes_less_than(CLOSES)) && !closed() {
        return refuse(Refusal::Small(gaps.iter().map(|w| w.closed()).fold(f64::NEG_INFINITY, f64::max)), gain);
    }
    if error_ratio > WORSE || (alike.iter().any(Weighed::worse) && !when) {
        return refuse(Refusal::Worse, gain);
    }
    Ruling { refused: None, gain, error_ratio }
}

/// A number of the effect that is larger than such a thing can be.
pub(crate) fn absurd(tried: &Tried) -> Option<Refusal> {
    let limits = tried.included.last().map(|i| i.effect.parameters.as_slice()).unwrap_or_default();
    let own = [tried.prepared.of_effect.last(), tried.prepared.of_shape.last()];
    let is_own = |i: &usize| own.iter().flatten().any(|of| of.contains(i));
    tried.fitted.found.unknowns.iter().filter(|u| is_own(&u.parameter)).find_map(|u| {
        let name = &tried.prepared.specs[u.parameter].name;
        let most = limits.iter().find(|p| p.name == *name)?.most?;
        (u.value.abs() > most).then(|| Refusal::Absurd { parameter: name.clone(), value: u.value })
    })
}

/// Time between samples [s].
fn period(track: &Track) -> f64 {
    let t = track.times();
    (t[t.len() - 1] - t[0]) / (t.len() - 1).max(1) as f64
}

/// Second halves of all records, and parameters with what the first halves say of the day.
fn second_halves(bench: &Bench<'_>, prepared: &Prepared, fitted: &Fitted) -> (Vec<Track>, Vec<Vec<f64>>) {
    let all: Vec<Track> = bench.train.iter().chain(bench.held).cloned().collect();
    let p = from_first_halves(prepared, &fitted.found, &all);
    let half = |(track, p): (&Track, &Vec<f64>)| track.part(middle(track), track.times().len(), &prepared.model, p);
    (all.iter().zip(&p).map(half).collect(), p)
}

/// What training records know of the rig's numbers: those that are surely not zero, with a standard error that leaves them to differ as much as
/// shares may.
fn known(found: &Estimated) -> Vec<(usize, f64)> {
    let sure = found.unknowns.iter().filter(|u| u.record.is_none() && u.value.abs() > KNOWN * u.robust_sd);
    sure.map(|u| (u.parameter, u.robust_sd.hypot(SAME_SIZE * u.value))).collect()
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

/// p-value of second halves that show what their first halves did, both known about equally well.
fn stays(told: &[(String, Share)]) -> f64 {
    let off = told.iter().map(|(_, s)| (s.value - 1.0).powi(2) / (2.0 * s.sd.powi(2) + SAME_SIZE.powi(2))).sum();
    beyond(off, told.len())
}

/// Mean squared errors of an output's predictions, each over the larger variance that the two models expect there: where a rig amplifies
/// whatever pushes it, errors say little.
#[derive(Clone, Copy, Debug)]
struct Weighed {
    before: f64,
    after: f64,
    /// What noise makes, by the model that has less of it: smaller errors are luck.
    floor: f64,
    /// Standard error of `before - after`; predictions overlap.
    sd: f64,
}

impl Weighed {
    fn closed(&self) -> f64 {
        1.0 - (self.after - self.floor).max(0.0) / (self.before - self.floor)
    }

    fn closes_less_than(&self, share: f64) -> bool {
        self.before - self.after + ONE_SIDED * self.sd < share * (self.before - self.floor)
    }

    /// Closes its share of a gap, beyond chance.
    fn closes(&self) -> bool {
        self.before > self.floor && self.closed() >= CLOSES && self.before - self.after > CLEARLY * self.sd
    }

    /// After over before, none smaller than noise makes it.
    fn ratio(&self) -> f64 {
        self.after.max(self.floor) / self.before.max(self.floor)
    }

    fn worse(&self) -> bool {
        self.after - self.before.max(self.floor) > CLEARLY * self.sd
    }
}

fn weigh(before: &[Vec<Ahead>], after: &[Vec<Ahead>], horizon: f64) -> Vec<Weighed> {
    let outputs: BTreeSet<usize> = before.iter().flatten().map(|a| a.output).collect();
    let of = |output: usize| {
        let mut sum = [0.0; 3];
        let mut gained: Vec<Vec<f64>> = Vec::new();
        let mut lags = 1;
        for (b, a) in before.iter().zip(after) {
            let own = |all: &[Ahead]| all.iter().position(|a| a.output == output);
            let (Some(b), Some(a)) = (own(b).map(|k| &b[k]), own(a).map(|k| &a[k])) else { continue };
            let mut of_record = Vec::new();
            for k in 0..b.t.len().min(a.t.len()) {
                let variance = b.floor[k].max(a.floor[k]).powi(2);
                let floor = b.floor[k].min(a.floor[k]);
                let parts = [b.error[k].powi(2), a.error[k].powi(2), floor.powi(2)].map(|v| v / variance);
                if parts.iter().all(|v| v.is_finite()) {
                    sum.iter_mut().zip(parts).for_each(|(s, v)| *s += v);
                    of_record.push(parts[0] - parts[1]);
                }
            }
            lags = lags.max(b.t.iter().take_while(|t| **t < b.t[0] + horizon).count());
            gained.push(of_record);
        }
        let count = gained.iter().map(Vec::len).sum::<usize>() as f64;
        let mean = (sum[0] - sum[1]) / count;
        let about = |record: &Vec<f64>| record.iter().map(|v| v - mean).collect::<Vec<f64>>();
        let variance: f64 = gained.iter().map(|record| variance_of_sum(&about(record), lags)).sum();
        let [before, after, floor] = sum.map(|s| s / count);
        (count > 0.0).then(|| Weighed { before, after, floor, sd: variance.sqrt() / count })
    };
    outputs.into_iter().filter_map(of).collect()
}
