//! The way from records to a verdict: the one list of steps.
//!
//! look at the records -> fit the base -> where -> screen -> refit the few best -> accept one or none -> again -> verdict -> patch.

use crate::accept::{Tried, judge};
use crate::answer::{Candidate, Diagnosis, EffectValue, Figures, Finding, Moved, Verdict};
use crate::base_fit::{Fitted, fit_base, likelihoods, refit};
use crate::chance::beyond;
use crate::effects::{Effect, IDS, Scales, Signature, catalogue};
use crate::figures::{View, figures, shrink, view};
use crate::locate::locate;
use crate::model::{Included, Prepared, prepare};
use crate::patch::{Base, PatchError, Written, check, compose, digits};
use crate::quality::{averaged, integrates, look, mended, mistaken, strangers, stride};
use crate::screen::{SAME, Score, ScreenOptions, Seen, UNIQUE, cosine, screen};
use crate::shapes::unnamed;
use crate::traces;
use ident::fit::{FitError, ParameterSpec};
use ident::innovations::{Noise, Track};
use ident::record::Record;
use runtime::Model;
use sim::Hold;
use std::fmt;
use std::time::Instant;

/// Choices of a diagnosis.
pub struct Options<'a> {
    /// Seed of the family's draws.
    pub seed: u64,
    /// Probability that screening names anything where nothing is missing.
    pub family: f64,
    /// Most effects.
    pub most_effects: usize,
    /// What logged inputs do between samples.
    pub hold: Hold,
    /// Only these effects of the catalogue; all where empty.
    pub only: Vec<String>,
    /// Effects of the user's own.
    pub own: Vec<Effect>,
    /// The last step that is done.
    pub until: Step,
    /// Which parts of the method are used.
    pub method: Method,
    /// Series that show the answer are handed over too.
    pub traces: bool,
    /// Told what is going on.
    pub progress: &'a (dyn Fn(&str) + Sync),
}

/// Parts of the method that can be left out, to show what they are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Method {
    /// Random forces in the filter; without, innovations are output errors.
    pub whitening: bool,
    /// The family's threshold; without, each candidate is tested on its own at 5 %.
    pub family: bool,
    /// Acceptance on other records; without, on the training records themselves.
    pub other_records: bool,
    /// Effects that the fitted parameters eat are set aside.
    pub absorption: bool,
}

impl Default for Method {
    fn default() -> Self {
        Self { whitening: true, family: true, other_records: true, absorption: true }
    }
}

/// Steps after which a diagnosis can stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// Quality of the records.
    Preflight,
    /// Base fit, its figures and where it disagrees.
    Where,
    /// First screening.
    Screen,
    /// All.
    Patch,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            seed: 1,
            family: 0.05,
            most_effects: 4,
            hold: Hold::Zero,
            only: Vec::new(),
            own: Vec::new(),
            until: Step::Patch,
            method: Method::default(),
            traces: false,
            progress: &|_| {},
        }
    }
}

/// Why there is no diagnosis.
#[derive(Clone, Debug, PartialEq)]
pub enum DiagnoseError {
    /// The base cannot be fitted or followed.
    Fit(FitError),
    /// The base's text cannot be patched.
    Patch(PatchError),
    /// There is no record to judge on.
    NoTest,
    /// An effect that is not in the catalogue.
    UnknownEffect {
        /// As asked for.
        name: String,
        /// All ids.
        known: Vec<String>,
    },
}

impl fmt::Display for DiagnoseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fit(e) => e.fmt(f),
            Self::Patch(e) => e.fmt(f),
            Self::NoTest => f.write_str(
                "no test record: an effect is accepted only if it helps on a record that it was not found on; give one with --test, with other excitation than the training records",
            ),
            Self::UnknownEffect { name, known } => write!(f, "there is no effect `{name}`; the catalogue has {}", known.join(", ")),
        }
    }
}

impl std::error::Error for DiagnoseError {}

impl From<FitError> for DiagnoseError {
    fn from(e: FitError) -> Self {
        Self::Fit(e)
    }
}

impl From<PatchError> for DiagnoseError {
    fn from(e: PatchError) -> Self {
        Self::Patch(e)
    }
}

/// Finds what a rig's text lacks. `asked` are its parameters as the request has them.
///
/// # Errors
/// [`DiagnoseError`], one variant a cause. Records that cannot be used are a verdict, no error.
pub fn diagnose(
    base: &Base,
    asked: &[ParameterSpec],
    train: &[Record],
    test: &[Record],
    options: &Options<'_>,
) -> Result<Diagnosis, DiagnoseError> {
    let began = Instant::now();
    let tell = options.progress;
    if test.is_empty() && options.method.other_records && options.until == Step::Patch {
        return Err(DiagnoseError::NoTest);
    }
    let mut answer = empty();
    let plain = prepare(base, asked, &[], 0)?;
    let p0: Vec<f64> = plain.specs.iter().map(|s| s.value).collect();
    let clean = |records: &[Record]| records.iter().map(|r| mended(&plain, &p0, r)).collect::<Vec<_>>();
    let (raw, raw_test) = (train, test);
    let (train, test) = (&clean(train)[..], &clean(test)[..]);
    let block = stride(&plain, &p0, train);
    let wrapped: Vec<String> =
        base.rig.outputs.iter().filter(|o| o.encoder.as_ref().is_some_and(|e| e.wrapped)).map(|o| o.name.clone()).collect();
    let hold = if block > 1 { Hold::First } else { options.hold };
    let held_inputs: Vec<String> =
        if options.hold == Hold::Zero { base.rig.inputs.iter().map(|i| i.name.clone()).collect() } else { Vec::new() };
    let bind = |records: &[Record]| {
        records
            .iter()
            .map(|r| Track::new(&averaged(r, block, &wrapped, &held_inputs), &plain.model, &p0, hold))
            .collect::<Result<Vec<_>, _>>()
    };
    let (mut tracks, mut held) = (bind(train)?, bind(test)?);
    let (mut first, mut second) = (bind(raw)?, bind(raw_test)?);
    if block > 1 {
        tell(&format!("  blocks of {block} samples are averaged"));
    }

    tell("looking at the records ..");
    answer.faults = look(&plain, &p0, &mut first, &mut second, (&mut tracks, &mut held));
    if !answer.faults.is_empty() {
        answer.because = format!("the records cannot be used: {}", answer.faults.join("; "));
        answer.verdict = Verdict::BadData;
        answer.seconds = began.elapsed().as_secs_f64();
        return Ok(answer);
    }
    if options.until == Step::Preflight {
        "the records can be used".clone_into(&mut answer.because);
        return Ok(answer);
    }

    let ranges: Vec<_> = base.rig.coordinates.iter().filter_map(|c| Some((c.name.clone(), c.range?))).collect();
    let all: Vec<Record> = train.iter().chain(test).map(|r| averaged(r, block, &wrapped, &held_inputs)).collect();
    answer.faults = mistaken(&plain, &ranges, &all, hold)?;
    if !answer.faults.is_empty() {
        answer.because = format!("the records cannot be used: {}", answer.faults.join("; "));
        answer.verdict = Verdict::BadData;
        answer.seconds = began.elapsed().as_secs_f64();
        return Ok(answer);
    }
    tell("fitting the base ..");
    let (fitted, asked) = fit_base(&plain, asked, train, &mut tracks, options)?;
    let asked = &asked[..];
    answer.faults = strangers(&plain, &fitted.found.p, &p0, &fitted.found.noise, &tracks)?;
    if !answer.faults.is_empty() {
        answer.because = format!("the records cannot be used: {}", answer.faults.join("; "));
        answer.verdict = Verdict::BadData;
        answer.seconds = began.elapsed().as_secs_f64();
        return Ok(answer);
    }
    let mut seen = View { hold: options.hold, horizon: None };
    answer.before = figures(&plain.model, &fitted.found.p, &fitted.mean(), train, test, seen);
    let longest = train.iter().map(Record::duration).fold(0.0, f64::max);
    seen = view(&answer.before, integrates(&plain, &fitted.mean(), longest), options.hold);
    if seen.horizon.is_some() {
        answer.before = figures(&plain.model, &fitted.found.p, &fitted.mean(), train, test, seen);
    }
    answer.published = figures(&plain.model, &vec![p0.clone(); tracks.len()], &p0, train, test, seen);
    answer.after = answer.before.clone();
    answer.noise = Some(fitted.found.noise.clone());
    tell("where do they disagree? ..");
    answer.places = locate(&plain, &fitted.found.p, &fitted.found.noise, &tracks)?;
    if options.traces {
        answer.pushed = traces::pushed(&plain, &fitted.found.p, &fitted.found.noise, &tracks, train)?;
        answer.runs = traces::before(&plain.model, &fitted.found.p, &fitted.mean(), train, test, options.hold);
    }
    if options.until == Step::Where {
        "stopped after the base fit".clone_into(&mut answer.because);
        answer.seconds = began.elapsed().as_secs_f64();
        return Ok(answer);
    }

    let scales = scales(&plain, &tracks, &fitted);
    let effects = chosen(base, &scales, options)?;
    let mut current = State { prepared: plain, fitted, accepted: Vec::new() };
    let base_state_names: Vec<(String, String, f64, f64)> = current.free_parameters();
    let base_figures = answer.before.clone();
    let mut rejected: Vec<(String, String)> = Vec::new();
    let mut contradicted = false;
    let mut left_over;
    loop {
        tell(&format!("screening {} candidates ..", effects.len()));
        let left: Vec<&Effect> = effects.iter().filter(|e| !current.has(e)).collect();
        let round = current.screen(base, asked, &left, &tracks, options)?;
        if current.accepted.is_empty() {
            answer.candidates = listed(&left, &round.scores);
            answer.screening_p = round.scores[..left.len()].iter().map(|s| s.p_family).fold(1.0, f64::min);
        }
        left_over = round.left_over.clone();
        if options.until == Step::Screen || current.accepted.len() >= options.most_effects {
            break;
        }
        let chosen = current.try_best(base, asked, &left, &round, &mut tracks, &held, options)?;
        let mut accepted = None;
        for tried in chosen {
            let verdict = judge(&current.fitted, &current.prepared, &tried, test, &held, &answer.after, seen, options)?;
            match verdict.refused {
                None => {
                    accepted = Some((tried, verdict));
                    break;
                }
                Some(why) => {
                    tell(&format!("  {}: {why}", left[tried.index].title()));
                    // five families in a hundred speak where nothing is missing
                    contradicted |= round.scores[tried.index].p_family < 0.2 * options.family;
                    rejected.push((left[tried.index].title(), why));
                }
            }
        }
        let Some((tried, verdict)) = accepted else { break };
        tell(&format!("  accepted: {}", left[tried.index].title()));
        let effect = left[tried.index].clone();
        let finding = Finding {
            effect: effect.id.clone(),
            place: effect.place.clone(),
            shape: effect.shape.clone(),
            parameters: Vec::new(),
            equivalent: tried.equivalent.iter().map(|&i| (left[i].id.clone(), left[i].place.clone())).collect(),
            p_value: round.scores[tried.index].p_family,
            heldout_gain: verdict.gain,
            per_record: tried.per_record,
        };
        answer.findings.push(finding);
        answer.after = figures(&tried.prepared.model, &tried.fitted.found.p, &tried.fitted.mean(), train, &[], seen);
        answer.after.test = verdict.figures.test;
        current = State { accepted: tried.included, prepared: tried.prepared, fitted: tried.fitted };
        contradicted = false;
        // what an earlier effect stood for may have been this one
        if let Some(drop) = current.superfluous().filter(|drop| drop + 1 < current.accepted.len()) {
            tell(&format!("  dropped again: {}", current.accepted[drop].effect.title()));
            let mut fewer = current.accepted.clone();
            fewer.remove(drop);
            if let Ok((prepared, fitted)) = refit(base, asked, &fewer, &current.fitted, &mut tracks, true) {
                answer.findings.remove(drop);
                answer.after = figures(&prepared.model, &fitted.found.p, &fitted.mean(), train, test, seen);
                current = State { prepared, fitted, accepted: fewer };
            }
        }
    }
    if options.traces && !answer.findings.is_empty() {
        let found = &current.fitted.found;
        traces::after(&mut answer.runs, &current.prepared.model, &found.p, &current.fitted.mean(), train, test, options.hold);
    }
    finish(base, &mut answer, &current, &base_state_names, &rejected, left_over, contradicted, train)?;
    answer.gap_shrink =
        shrink(&current.prepared.model, &current.fitted.mean(), &current.fitted.found.noise, &held, &base_figures, &answer.after);
    answer.seconds = began.elapsed().as_secs_f64();
    Ok(answer)
}

fn empty() -> Diagnosis {
    Diagnosis {
        verdict: Verdict::NoGap,
        because: String::new(),
        faults: Vec::new(),
        places: Vec::new(),
        findings: Vec::new(),
        candidates: Vec::new(),
        screening_p: 1.0,
        published: Figures::default(),
        before: Figures::default(),
        after: Figures::default(),
        gap_shrink: Vec::new(),
        moved: Vec::new(),
        noise: None,
        next_experiment: None,
        patched: Vec::new(),
        pushed: Vec::new(),
        runs: Vec::new(),
        seconds: 0.0,
    }
}

/// Log-likelihood by which one effect must be ahead of another of its class, over all records, to be told from it (odds of 100 to 1).
const SEPARATES: f64 = 4.6;

/// Classes whose first member is refitted.
const CLASSES: usize = 8;

/// Where the search stands.
struct State {
    prepared: Prepared,
    fitted: Fitted,
    accepted: Vec<Included>,
}

/// A screening and what it is about.
struct Round {
    scores: Vec<Score>,
    /// A shape that no candidate of the catalogue has, if it is significant.
    left_over: Option<String>,
}

impl State {
    fn has(&self, effect: &Effect) -> bool {
        self.accepted.iter().any(|a| a.effect.id == effect.id && a.effect.place == effect.place)
    }

    fn free_parameters(&self) -> Vec<(String, String, f64, f64)> {
        let specs = &self.prepared.specs;
        self.fitted
            .found
            .unknowns
            .iter()
            .filter(|u| u.record.is_none_or(|r| r == 0))
            .map(|u| (specs[u.parameter].name.clone(), self.prepared.model.names().parameter_unit(u.parameter).to_owned(), u.value, u.sd))
            .collect()
    }

    fn screen(
        &self,
        base: &Base,
        asked: &[ParameterSpec],
        left: &[&Effect],
        tracks: &[Track],
        options: &Options<'_>,
    ) -> Result<Round, DiagnoseError> {
        // one model with all candidates at their null values, beside what was accepted
        let mut included = self.accepted.clone();
        included.extend(left.iter().map(|e| Included {
            held: Vec::new(),
            effect: (*e).clone(),
            per_record: false,
            start: vec![0.0; e.parameters.len()],
        }));
        let accepted = self.accepted.len();
        let texts = prepare(base, asked, &included, accepted)?;
        let p: Vec<Vec<f64>> = self.fitted.found.p.iter().map(|p| carry(&self.prepared, p, &texts)).collect();
        let noise = self.fitted.noise_in(&texts, options.method.whitening);
        // models that an assumption was taken out of
        let mut other: Vec<Option<Prepared>> = Vec::new();
        for e in left {
            other.push(if e.signature == Signature::Towards { towards(base, asked, &included, accepted, e).ok() } else { None });
        }
        let mut seen: Vec<Seen<'_>> = Vec::new();
        for (k, e) in left.iter().enumerate() {
            match (&other[k], e.signature) {
                (Some(model), Signature::Towards) => seen.push(Seen::Towards(&model.model)),
                _ => seen.push(Seen::Effect(e, texts.of_effect[accepted + k].clone())),
            }
        }
        let count = seen.len();
        seen.extend(unnamed(&texts, &self.scales(tracks)));
        let scores = screen(&texts, &p, &noise, tracks, &seen, ScreenOptions { family: options.family, seed: options.seed })?;
        let left_over = scores[count..]
            .iter()
            .zip(&seen[count..])
            .filter(|(s, _)| s.p_family < 0.2 * options.family)
            .max_by(|a, b| a.0.statistic.total_cmp(&b.0.statistic))
            .map(|(s, seen)| match seen {
                Seen::Shape(_, words) => format!("{words} (score {:.1})", s.statistic.sqrt()),
                _ => String::new(),
            });
        Ok(Round { scores, left_over })
    }

    fn scales(&self, tracks: &[Track]) -> Scales {
        scales(&self.prepared, tracks, &self.fitted)
    }

    /// The significant candidates that explain most, refitted; the best first.
    #[allow(clippy::too_many_arguments)]
    fn try_best(
        &self,
        base: &Base,
        asked: &[ParameterSpec],
        left: &[&Effect],
        round: &Round,
        tracks: &mut [Track],
        held: &[Track],
        options: &Options<'_>,
    ) -> Result<Vec<Tried>, DiagnoseError> {
        let scores = &round.scores[..left.len()];
        let speaks = |s: &Score| {
            let p = if options.method.family { s.p_family } else { s.p_single };
            p < options.family && (s.unique_fraction >= UNIQUE || !options.method.absorption)
        };
        let mut order: Vec<usize> = (0..left.len()).filter(|&i| speaks(&scores[i]) && !wrong_sign(left[i], &scores[i])).collect();
        // by what is gained over what is spent
        let worth = |s: &Score| s.statistic - 2.0 * s.degrees as f64;
        order.sort_by(|&a, &b| worth(&scores[b]).total_cmp(&worth(&scores[a])));
        // dry friction that holds a rig still does not show at its null value: tried from a finite one
        let level = self.fitted.found.noise.sd.clone();
        let dry: Vec<usize> = (0..left.len()).filter(|&i| left[i].id == "coulomb" && !order.contains(&i)).collect();
        // the class of the best, then what else is significant and different
        let alike = |a: usize, b: usize| cosine(&scores[a], &scores[b]).abs() > SAME;
        // the class of the best, and the first of every other class
        let mut few: Vec<usize> = order.iter().copied().filter(|&i| order.first().is_some_and(|&first| alike(i, first))).take(3).collect();
        let mut leaders: Vec<usize> = order.first().copied().into_iter().collect();
        for &i in &order {
            if leaders.len() < CLASSES && !leaders.iter().any(|&k| alike(i, k)) {
                leaders.push(i);
                few.push(i);
            }
        }
        few.extend(&dry);
        let mut tried: Vec<Tried> = Vec::new();
        for index in few {
            let mut start = scores[index].step.iter().map(|s| s.0).collect::<Vec<_>>();
            let finite = dry.contains(&index);
            if finite {
                let entry = self.prepared.coordinates.iter().position(|&c| base.rig.coordinates[c].name == left[index].place);
                start = vec![entry.map_or(0.0, |k| level[k])];
            }
            let mut included = self.accepted.clone();
            included.push(Included {
                held: untold(&scores[index]),
                effect: left[index].clone(),
                per_record: false,
                start: begin(left[index], &start, tracks),
            });
            (options.progress)(&format!("  refitting with {} ..", left[index].title()));
            let Ok((prepared, fitted)) = refit(base, asked, &included, &self.fitted, tracks, false) else { continue };
            let degrees = left[index].parameters.len();
            // judged by its likelihood ratio, as one of the family
            let ratio = 2.0 * (fitted.found.log_likelihood - self.fitted.found.log_likelihood);
            if finite && beyond(ratio, degrees) * left.len() as f64 > options.family {
                continue;
            }
            tried.push(Tried {
                index,
                value: fitted.found.log_likelihood - degrees as f64,
                included,
                prepared,
                fitted,
                equivalent: Vec::new(),
                per_record: false,
                by_record: scores[index].by_record.clone(),
            });
        }
        tried.sort_by(|a, b| b.value.total_cmp(&a.value));
        // members of the best one's class that fit about as well
        let ranked: Vec<(usize, f64)> = tried.iter().map(|t| (t.index, t.value)).collect();
        for t in &mut tried {
            let fits = |i: usize| {
                ranked
                    .iter()
                    .find(|(k, _)| *k == i)
                    .map_or(scores[i].statistic > scores[t.index].statistic - 4.0, |(_, v)| *v > t.value - 2.0)
            };
            t.equivalent = (0..left.len())
                .filter(|&i| {
                    let same_name = left[i].id == left[t.index].id && left[i].place == left[t.index].place;
                    // a shape with more parameters that has this one in it says nothing else
                    let nested = left[i].parameters.len() > left[t.index].parameters.len();
                    let own = scores[i].unique_fraction >= UNIQUE;
                    !same_name && !nested && own && alike(i, t.index) && !wrong_sign(left[i], &scores[i]) && fits(i)
                })
                .collect();
            t.equivalent.dedup_by(|a, b| left[*a].id == left[*b].id && left[*a].place == left[*b].place);
        }
        // one of each class goes on, refitted to the end
        let mut kept: Vec<Tried> = Vec::new();
        for t in tried {
            if !kept.iter().any(|k| alike(k.index, t.index)) {
                kept.push(t);
            }
        }
        kept.truncate(3);
        for t in &mut kept {
            if let Ok((prepared, fitted)) = refit(base, asked, &t.included, &t.fitted, tracks, true) {
                (t.prepared, t.fitted) = (prepared, fitted);
            }
            self.separate(base, asked, left, scores, t, tracks, held)?;
        }
        Ok(kept)
    }

    /// Drops from the class of `t` what its own noise, or the other records, can tell from it; puts the best in front.
    #[allow(clippy::too_many_arguments)]
    fn separate(
        &self,
        base: &Base,
        asked: &[ParameterSpec],
        left: &[&Effect],
        scores: &[Score],
        t: &mut Tried,
        tracks: &mut [Track],
        held: &[Track],
    ) -> Result<(), DiagnoseError> {
        let total = |tried: &Tried, noise: &Noise| -> Result<f64, DiagnoseError> {
            let likelihoods = likelihoods(&tried.prepared, &tried.fitted, noise, held)?;
            let of = |l: &Option<Vec<f64>>| l.as_ref().map_or(f64::NEG_INFINITY, |l| l.iter().sum());
            Ok(tried.fitted.found.log_likelihood + likelihoods.iter().map(of).sum::<f64>())
        };
        let mut rivals = vec![(t.index, total(t, &t.fitted.found.noise)?)];
        for i in std::mem::take(&mut t.equivalent) {
            let step: Vec<f64> = scores[i].step.iter().map(|s| s.0).collect();
            let mut included = self.accepted.clone();
            included.push(Included {
                held: untold(&scores[i]),
                effect: left[i].clone(),
                per_record: false,
                start: begin(left[i], &step, tracks),
            });
            let Ok((prepared, fitted)) = refit(base, asked, &included, &t.fitted, tracks, false) else { continue };
            let rival = Tried {
                index: i,
                value: 0.0,
                included,
                prepared,
                fitted,
                equivalent: Vec::new(),
                per_record: false,
                by_record: scores[i].by_record.clone(),
            };
            let worth = total(&rival, &t.fitted.found.noise)?;
            let best = rivals[0].1;
            rivals.push((i, worth));
            if worth > best + SEPARATES
                && let Ok((prepared, fitted)) = refit(base, asked, &rival.included, &rival.fitted, tracks, true)
            {
                *t = Tried { prepared, fitted, ..rival };
                rivals.swap_remove(0);
                rivals.insert(0, (i, total(t, &t.fitted.found.noise)?));
            }
        }
        let best = rivals[0].1;
        t.equivalent = rivals.into_iter().filter(|(i, v)| *i != t.index && *v > best - SEPARATES).map(|(i, _)| i).collect();
        t.equivalent.dedup_by(|a, b| left[*a].id == left[*b].id && left[*a].place == left[*b].place);
        Ok(())
    }

    /// An accepted effect whose parameters have become indistinguishable from zero.
    fn superfluous(&self) -> Option<usize> {
        (0..self.accepted.len()).find(|&k| {
            let own = &self.prepared.of_effect[k];
            !own.is_empty() && self.fitted.found.unknowns.iter().filter(|u| own.contains(&u.parameter)).all(|u| u.value.abs() < 2.0 * u.sd)
        })
    }
}

/// Parameters of an effect that the fitted ones have already: they stay at zero.
fn untold(score: &Score) -> Vec<bool> {
    score.minimal_detectable.iter().map(|m| !m.is_finite()).collect()
}

/// Starting values: a delay or lag near zero never leaves it, and must leave room for its step.
fn begin(effect: &Effect, step: &[f64], tracks: &[Track]) -> Vec<f64> {
    let period = tracks.first().map_or(0.01, |t| (t.times()[t.times().len() - 1] - t.times()[0]) / (t.times().len() - 1) as f64);
    match effect.signature {
        Signature::InputDelay(_) | Signature::OutputDelay(_) => step.iter().map(|s| s.max(0.5 * period)).collect(),
        _ => effect.parameters.iter().zip(step).map(|(p, s)| if p.positive { s.max(0.0) } else { *s }).collect(),
    }
}

/// A one-sided effect that would be on the other side.
fn wrong_sign(effect: &Effect, score: &Score) -> bool {
    let positive: Vec<bool> = effect.parameters.iter().map(|p| p.positive).collect();
    match effect.signature {
        Signature::Towards => score.step.first().is_some_and(|s| s.0 < 0.25),
        _ => positive.iter().any(|p| *p) && positive.iter().zip(&score.step).filter(|(p, _)| **p).all(|(_, s)| s.0 <= 0.0),
    }
}

/// The screening model without the assumption that `effect` drops.
fn towards(base: &Base, asked: &[ParameterSpec], included: &[Included], accepted: usize, effect: &Effect) -> Result<Prepared, PatchError> {
    let mut all = included.to_vec();
    all.insert(accepted, Included { held: Vec::new(), effect: effect.clone(), per_record: false, start: Vec::new() });
    prepare(base, asked, &all, accepted + 1)
}

/// Parameters by name from one model to another.
fn carry(from: &Prepared, p: &[f64], to: &Prepared) -> Vec<f64> {
    to.specs.iter().map(|s| from.specs.iter().position(|o| o.name == s.name).map_or(s.value, |i| p[i])).collect()
}

fn scales(prepared: &Prepared, tracks: &[Track], fitted: &Fitted) -> Scales {
    let rig = &prepared.base.rig;
    let n = rig.coordinates.len();
    let mut range = vec![(f64::INFINITY, f64::NEG_INFINITY); n];
    let (mut squares, mut count) = (vec![0.0; n], 0.0);
    let mut input = vec![(0.0_f64, f64::INFINITY, f64::NEG_INFINITY); rig.inputs.len()];
    let mut duration = 0.0_f64;
    for (r, track) in tracks.iter().enumerate() {
        let p = &fitted.found.p[r];
        if let Ok(Some(pass)) = ident::innovations::pass(&prepared.model, p, track, &fitted.found.noise, &[]) {
            let order = pass.states.len() / track.times().len().max(1);
            for x in pass.states.chunks_exact(order) {
                for i in 0..n {
                    range[i] = (range[i].0.min(x[i]), range[i].1.max(x[i]));
                    squares[i] += x[n + i] * x[n + i];
                }
                count += 1.0;
            }
        }
        for t in track.times() {
            for (j, u) in track.inputs(&prepared.model, p, *t).into_iter().take(input.len()).enumerate() {
                input[j] = (input[j].0.max(u.abs()), input[j].1.min(u), input[j].2.max(u));
            }
        }
        duration = duration.max(track.times()[track.times().len() - 1] - track.times()[0]);
    }
    Scales {
        range: range.into_iter().map(|(lo, hi)| if lo <= hi { (lo, hi) } else { (0.0, 0.0) }).collect(),
        rate: squares.into_iter().map(|s: f64| (s / f64::max(count, 1.0)).sqrt()).collect(),
        input: input.into_iter().map(|(largest, lo, hi)| (largest, if hi > lo { hi - lo } else { 0.0 })).collect(),
        duration,
    }
}

/// The effects that are asked for.
fn chosen(base: &Base, scales: &Scales, options: &Options<'_>) -> Result<Vec<Effect>, DiagnoseError> {
    let mut all = catalogue(&base.rig, scales);
    all.extend(options.own.iter().cloned());
    for name in &options.only {
        let known: Vec<String> = IDS.iter().map(|s| (*s).to_owned()).chain(options.own.iter().map(|e| e.id.clone())).collect();
        if !known.contains(name) {
            return Err(DiagnoseError::UnknownEffect { name: name.clone(), known });
        }
    }
    if !options.only.is_empty() {
        all.retain(|e| options.only.contains(&e.id));
    }
    Ok(all)
}

/// The candidates of the first screening, with their classes.
fn listed(left: &[&Effect], scores: &[Score]) -> Vec<Candidate> {
    let mut classes: Vec<usize> = Vec::new();
    let mut class_of = vec![0; left.len()];
    let mut order: Vec<usize> = (0..left.len()).collect();
    order.sort_by(|&a, &b| scores[b].statistic.total_cmp(&scores[a].statistic));
    for &i in &order {
        let found = classes.iter().position(|&k| cosine(&scores[k], &scores[i]).abs() > SAME);
        class_of[i] = found.unwrap_or_else(|| {
            classes.push(i);
            classes.len() - 1
        }) + 1;
    }
    order
        .into_iter()
        .map(|i| {
            let (e, s) = (left[i], &scores[i]);
            let status = if s.degrees == 0 || s.unique_fraction < UNIQUE {
                "not identifiable"
            } else if s.p_family < 0.05 {
                "significant"
            } else {
                "quiet"
            };
            Candidate {
                effect: e.id.clone(),
                place: e.place.clone(),
                shape: e.shape.clone(),
                score: s.statistic.sqrt(),
                p_value: s.p_family,
                unique_fraction: s.unique_fraction,
                minimal_detectable: e
                    .parameters
                    .iter()
                    .zip(&s.minimal_detectable)
                    .map(|(p, m)| (p.name.clone(), *m, p.unit.clone()))
                    .collect(),
                class: class_of[i],
                status: status.to_owned(),
            }
        })
        .collect()
}

/// Verdict, moved parameters, patched text.
#[allow(clippy::too_many_arguments)]
fn finish(
    base: &Base,
    answer: &mut Diagnosis,
    state: &State,
    before: &[(String, String, f64, f64)],
    rejected: &[(String, String)],
    left_over: Option<String>,
    contradicted: bool,
    train: &[Record],
) -> Result<(), DiagnoseError> {
    let specs = &state.prepared.specs;
    for (k, finding) in answer.findings.iter_mut().enumerate() {
        let own = state.prepared.of_effect.get(k).cloned().unwrap_or_default();
        finding.parameters = state
            .fitted
            .found
            .unknowns
            .iter()
            .filter(|u| own.contains(&u.parameter))
            .map(|u| EffectValue {
                name: specs[u.parameter].name.clone(),
                record: u.record.and_then(|r| train.get(r)).map(|r| r.source.clone()),
                value: u.value,
                sd: u.sd,
                unit: state.prepared.model.names().parameter_unit(u.parameter).to_owned(),
            })
            .collect();
    }
    let after = state.free_parameters();
    answer.moved = before
        .iter()
        .filter_map(|(name, unit, value, sd)| {
            let (_, _, a, s) = after.iter().find(|(n, ..)| n == name)?;
            Some(Moved { name: name.clone(), unit: unit.clone(), before: (*value, *sd), after: (*a, *s) })
        })
        .collect();
    answer.noise = Some(state.fitted.found.noise.clone());
    for candidate in &mut answer.candidates {
        let title = |id: &str, place: &str| candidate.effect == id && candidate.place == place;
        if let Some(f) = answer.findings.iter().find(|f| title(&f.effect, &f.place)) {
            "accepted".clone_into(&mut candidate.status);
            let _ = f;
        } else if answer.findings.iter().any(|f| f.equivalent.iter().any(|(id, place)| title(id, place))) {
            "equivalent".clone_into(&mut candidate.status);
        } else if let Some((_, why)) = rejected.iter().find(|(t, _)| t.starts_with(&format!("{} on {}", candidate.effect, candidate.place)))
        {
            candidate.status = format!("rejected: {why}");
        }
    }
    let ambiguous = answer.findings.iter().any(|f| !f.equivalent.is_empty());
    let words = left_over.as_ref().map(|w| format!("; left over: {w}")).unwrap_or_default();
    (answer.verdict, answer.because) = if answer.findings.is_empty() {
        if contradicted {
            let list: Vec<String> = rejected.iter().map(|(t, why)| format!("{t} ({why})")).collect();
            (
                Verdict::OutsideCatalogue,
                format!("there is a gap, but no candidate stands the test on other records: {}{words}", list.join("; ")),
            )
        } else if let Some(words) = left_over {
            (Verdict::OutsideCatalogue, format!("there is a gap that no candidate explains: {words}"))
        } else if answer.candidates.iter().all(|c| c.status == "not identifiable") && !answer.candidates.is_empty() {
            (Verdict::NotIdentifiable, "the fitted parameters imitate every candidate: these records move too little to tell".to_owned())
        } else {
            (Verdict::NoGap, "nothing is missing that these records could show".to_owned())
        }
    } else if ambiguous {
        let of = answer.findings.iter().find(|f| !f.equivalent.is_empty());
        let list =
            of.map_or(String::new(), |f| f.equivalent.iter().map(|(id, place)| format!("{id} on {place}")).collect::<Vec<_>>().join(", "));
        (
            Verdict::Ambiguous,
            format!(
                "these records cannot tell {} from {list}{words}",
                of.map_or(String::new(), |f| format!("{} on {}", f.effect, f.place))
            ),
        )
    } else if contradicted || left_over.is_some() {
        (Verdict::Partial, format!("something is left that no candidate explains{words}"))
    } else {
        (Verdict::Complete, "what is left is white".to_owned())
    };
    if !answer.findings.is_empty() {
        let written: Vec<Written<'_>> = state
            .accepted
            .iter()
            .zip(&answer.findings)
            .map(|(included, finding)| {
                let mut evidence = format!(
                    "rig diagnose: {} on {}; gain on records not used {} +- {} nats/sample",
                    finding.effect,
                    finding.place,
                    digits(finding.heldout_gain.0, 2),
                    digits(finding.heldout_gain.1, 1)
                );
                if !finding.equivalent.is_empty() {
                    let list: Vec<String> = finding.equivalent.iter().map(|(id, place)| format!("{id} on {place}")).collect();
                    evidence.push_str(&format!("\nor {} (not separable with these records)", list.join(", ")));
                }
                let values = included
                    .effect
                    .parameters
                    .iter()
                    .map(|p| finding.parameters.iter().find(|v| v.name == p.name).map_or((0.0, 0.0), |v| (v.value, v.sd)))
                    .collect();
                Written { effect: &included.effect, values, evidence: Some(evidence), per_record: finding.per_record, screened: false }
            })
            .collect();
        let files = compose(base, &written, &[])?;
        check(&files, &base.rig.name)?;
        answer.patched = files;
    }
    Ok(())
}
