//! Where the search stands, and its next step: screening, the few best refitted, what of a class can be told apart.

use crate::accept::{Tried, absurd};
use crate::base_fit::{Fitted, Starting, anew, likelihoods, refit};
use crate::chance::beyond;
use crate::effects::{Effect, Scales, Signature};
use crate::error::DiagnoseError;
use crate::model::{Included, Prepared, prepare};
use crate::options::Options;
use crate::patch::{Base, PatchError, Written, check, compose};
use crate::screen::{SAME, Score, ScreenOptions, Seen, UNIQUE, cosine, screen};
use crate::shapes::{uneven, unnamed};
use ident::fit::ParameterSpec;
use ident::innovations::{Noise, Track};
use ident::parallel::in_parallel;
use runtime::Model;
use std::sync::Arc;

/// Log-likelihood by which one effect must be ahead of another of its class, over all records, to be told from it (odds of 100 to 1).
pub(crate) const SEPARATES: f64 = 4.6;

/// Classes whose first member is refitted.
const CLASSES: usize = 8;

/// What is asked.
#[derive(Clone, Copy)]
pub(crate) struct Question<'a> {
    /// The rig.
    pub base: &'a Base,
    /// What a fit begins with that cannot go on from where the search stands.
    pub starting: &'a Starting,
    /// Choices.
    pub options: &'a Options<'a>,
}

/// Where the search stands.
#[derive(Clone)]
pub(crate) struct State {
    pub prepared: Arc<Prepared>,
    pub fitted: Fitted,
    pub accepted: Vec<Included>,
}

impl From<Tried> for State {
    fn from(tried: Tried) -> Self {
        Self { prepared: tried.prepared, fitted: tried.fitted, accepted: tried.included }
    }
}

/// A screening and what it is about.
pub(crate) struct Round {
    pub scores: Vec<Score>,
    /// What each candidate would have to be to be found in the test records (SI).
    pub in_test: Vec<Vec<f64>>,
    /// A shape that no candidate of the catalogue has, if it is significant.
    pub left_over: Option<String>,
}

impl State {
    /// Effects that can still be asked for, by their numbers.
    pub fn open(&self, effects: &[Effect]) -> Vec<usize> {
        let has = |id: &str, place: &str| self.accepted.iter().any(|a| a.effect.id == id && a.effect.place == place);
        (0..effects.len()).filter(|&i| !has(effects[i].id.as_str(), &effects[i].place)).collect()
    }

    pub fn free_parameters(&self) -> Vec<(String, String, f64, f64)> {
        let specs = &self.prepared.specs;
        self.fitted
            .found
            .unknowns
            .iter()
            .filter(|u| u.record.is_none_or(|r| r == 0))
            .map(|u| {
                (specs[u.parameter].name.clone(), self.prepared.model.names().parameter_unit(u.parameter).to_owned(), u.value, u.robust_sd)
            })
            .collect()
    }

    pub fn screen(&self, ask: &Question<'_>, left: &[&Effect], tracks: &[Track], held: &[Track]) -> Result<Round, DiagnoseError> {
        let Question { base, options, .. } = *ask;
        let asked = &self.fitted.asked[..];
        // one model with all candidates at their null values, beside what was accepted
        let mut included = self.accepted.clone();
        let accepted = self.accepted.len();
        // those of the day are seen through their siblings
        let mut column: Vec<usize> = Vec::new();
        for e in left {
            let sibling = included.iter().position(|i| e.by_record && i.effect.id == e.id && i.effect.place == e.place);
            column.push(sibling.unwrap_or(included.len()));
            if sibling.is_none() {
                included.push(include(&Effect { by_record: false, ..(*e).clone() }, &[], Vec::new(), tracks));
            }
        }
        let texts = prepare(base, asked, &included, accepted)?;
        let carried = |p: &[f64]| carry(&self.prepared, p, &texts);
        let p: Vec<Vec<f64>> = self.fitted.found.p.iter().map(|p| carried(p)).collect();
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
                _ if e.by_record => seen.push(Seen::ByRecord(texts.of_effect[column[k]].clone())),
                _ => seen.push(Seen::Effect(e, texts.of_effect[column[k]].clone())),
            }
        }
        let choices = ScreenOptions { family: options.family, seed: options.seed, absorption: options.method.absorption };
        let of_test: Vec<Vec<f64>> = self.fitted.of_test.iter().take(held.len()).map(|p| carried(p)).collect();
        let begun: Vec<Track> = held.iter().zip(&of_test).map(|(track, p)| track.begun(&texts.model, p)).collect();
        // a test record that cannot be followed shows nothing
        let in_test =
            if begun.is_empty() { Vec::new() } else { screen(&texts, &of_test, &noise, &begun, &seen, choices).unwrap_or_default() };
        let in_test = in_test.into_iter().map(|s| s.minimal_detectable).collect();
        let count = seen.len();
        seen.extend(unnamed(&texts, &self.scales(tracks)));
        let scores = screen(&texts, &p, &noise, tracks, &seen, choices)?;
        let left_over = loudest(&scores[count..], &seen[count..], options);
        Ok(Round { scores, in_test, left_over })
    }

    /// An accepted effect that differs from place to place, or as time goes: it stands for something that the catalogue does not have.
    /// Asked of all records, as a family of its own.
    pub fn uneven(&self, options: &Options<'_>, tracks: &[Track], held: &[Track]) -> Option<String> {
        let scales = self.scales(tracks);
        let begun = held.iter().zip(&self.fitted.of_test).map(|(track, p)| track.begun(&self.prepared.model, p));
        let all: Vec<Track> = tracks.iter().cloned().chain(begun).collect();
        let p: Vec<Vec<f64>> = self.fitted.found.p.iter().chain(&self.fitted.of_test).cloned().collect();
        let choices = ScreenOptions { family: options.family, seed: options.seed, absorption: options.method.absorption };
        let of = |(included, coefficients): (&Included, &Vec<usize>)| {
            let seen = uneven(&self.prepared, &scales, &included.effect, coefficients);
            let noise = &self.fitted.found.noise;
            // records that cannot be followed say nothing
            let scores = screen(&self.prepared, &p, noise, &all, &seen, choices).ok()?;
            Some(format!("{} is not the same everywhere: {}", included.effect.title(), loudest(&scores, &seen, options)?))
        };
        self.accepted.iter().zip(&self.prepared.of_effect).find_map(of)
    }

    fn scales(&self, tracks: &[Track]) -> Scales {
        scales(&self.prepared, tracks, &self.fitted)
    }

    /// Candidates that are significant, by what is gained over what is spent.
    pub fn speaking(&self, ask: &Question<'_>, left: &[&Effect], round: &Round) -> Vec<usize> {
        let options = ask.options;
        let scores = &round.scores[..left.len()];
        let worth = |s: &Score| s.statistic - 2.0 * spent(s.degrees, self.fitted.found.samples);
        let speaks = |s: &Score| {
            let beyond_chance = if options.method.family { s.p_family < options.family } else { worth(s) > 0.0 };
            beyond_chance && s.unique_fraction >= UNIQUE
        };
        let mut order: Vec<usize> = (0..left.len()).filter(|&i| speaks(&scores[i]) && !wrong_sign(left[i], &scores[i])).collect();
        order.sort_by(|&a, &b| worth(&scores[b]).total_cmp(&worth(&scores[a])));
        // of the resonances of an input the loudest: a fit finds the way to its neighbours
        let mut seen = Vec::new();
        order.retain(|&i| match left[i].signature {
            Signature::Resonance(input) if seen.contains(&input) => false,
            Signature::Resonance(input) => {
                seen.push(input);
                true
            }
            _ => true,
        });
        order
    }

    /// The state with candidate `i`, refitted in a hurry from `from` and from where the screening steps.
    pub fn with(
        &self,
        ask: &Question<'_>,
        left: &[&Effect],
        round: &Round,
        (i, from): (usize, &Fitted),
        (tracks, held): (&[Track], &[Track]),
    ) -> Option<Tried> {
        let score = &round.scores[i];
        let step: Vec<f64> = score.step.iter().map(|s| s.0).collect();
        let mut included = self.accepted.clone();
        included.push(include(left[i], &step, untold(score), tracks));
        self.hurried(ask, included, i, from, (tracks, held))
    }

    /// The significant candidates that explain most, refitted in a hurry; the best first.
    pub fn try_best(&self, ask: &Question<'_>, left: &[&Effect], round: &Round, tracks: &[Track], held: &[Track]) -> Vec<Tried> {
        let options = ask.options;
        let scores = &round.scores[..left.len()];
        let order = self.speaking(ask, left, round);
        // dry friction that holds a rig still does not show at its null value: tried from a finite one
        let level = self.fitted.found.noise.sd.clone();
        let pushed = |i: usize| self.prepared.coordinates.iter().position(|&c| ask.base.rig.coordinates[c].name == left[i].place);
        let dry: Vec<usize> = (0..left.len()).filter(|&i| left[i].id == "coulomb" && pushed(i).is_some() && !order.contains(&i)).collect();
        // the class of the best, and the first of every other class
        let alike = |a: usize, b: usize| cosine(&scores[a], &scores[b]).abs() > SAME;
        let mut few: Vec<usize> = order.iter().copied().filter(|&i| order.first().is_some_and(|&first| alike(i, first))).take(3).collect();
        let mut leaders: Vec<usize> = order.first().copied().into_iter().collect();
        for &i in &order {
            if leaders.len() < CLASSES && !leaders.iter().any(|&k| alike(i, k)) {
                leaders.push(i);
                few.push(i);
            }
        }
        few.extend(&dry);
        let refitted = in_parallel(&few, |_, &index| {
            let step: Vec<f64> = match pushed(index) {
                Some(k) if dry.contains(&index) => vec![level[k]],
                _ => scores[index].step.iter().map(|s| s.0).collect(),
            };
            let mut included = self.accepted.clone();
            included.push(include(left[index], &step, untold(&scores[index]), tracks));
            (options.progress)(&format!("  refitting with {} ..", left[index].title()));
            let gone_on = self.hurried(ask, included, index, &self.fitted, (tracks, held));
            let anew = if self.fitted.lost { self.begun_anew(ask, left[index], index, (tracks, held)) } else { None };
            gone_on.into_iter().chain(anew).max_by(|a, b| a.value.total_cmp(&b.value))
        });
        let mut tried: Vec<Tried> = Vec::new();
        for found in refitted.into_iter().flatten() {
            let index = found.index;
            // a resonance that is damped away is none, and casts no shadow on others
            if matches!(left[index].signature, Signature::Resonance(_))
                && let Some(why) = absurd(&found)
            {
                (options.progress)(&format!("  {}: {why}", left[index].title()));
                continue;
            }
            // judged by its likelihood ratio, as one of the family
            let ratio = 2.0 * (found.fitted.found.log_likelihood - self.fitted.found.log_likelihood);
            if dry.contains(&index) && beyond(ratio, scores[index].degrees.max(1)) * left.len() as f64 > options.family {
                continue;
            }
            tried.push(found);
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
                    let nested = scores[i].degrees > scores[t.index].degrees;
                    let own = scores[i].unique_fraction >= UNIQUE;
                    !same_name && !nested && own && alike(i, t.index) && !wrong_sign(left[i], &scores[i]) && fits(i)
                })
                .collect();
            t.equivalent.dedup_by(|a, b| left[*a].id == left[*b].id && left[*a].place == left[*b].place);
        }
        tried
    }

    /// The same effect with a value for each record.
    pub fn of_the_day(&self, ask: &Question<'_>, left: &[&Effect], t: &Tried, tracks: &[Track], held: &[Track]) -> Option<Tried> {
        let sibling = |i: usize| left.iter().position(|e| e.by_record && e.id == left[i].id && e.place == left[i].place);
        let index = sibling(t.index)?;
        let start: Vec<f64> = t.prepared.of_effect.last()?.iter().map(|&i| t.fitted.mean()[i]).collect();
        let mut included = self.accepted.clone();
        included.push(include(left[index], &start, Vec::new(), tracks));
        let found = self.hurried(ask, included, index, &self.fitted, (tracks, held))?;
        let equivalent = t.equivalent.iter().filter_map(|&i| sibling(i)).collect();
        Some(Tried { equivalent, ..found })
    }

    /// A fit from the rig's own values.
    fn begun_anew(&self, ask: &Question<'_>, effect: &Effect, index: usize, (tracks, held): (&[Track], &[Track])) -> Option<Tried> {
        let mut included = self.accepted.clone();
        included.push(include(effect, &[], Vec::new(), tracks));
        let (prepared, fitted) = anew(ask.base, ask.starting, &included, (tracks, held)).ok()?;
        Some(tried(index, included, prepared, fitted, tracks.len()))
    }

    /// A refit in which the noise stays as it is.
    fn hurried(
        &self,
        ask: &Question<'_>,
        included: Vec<Included>,
        index: usize,
        from: &Fitted,
        (tracks, held): (&[Track], &[Track]),
    ) -> Option<Tried> {
        let refitted = refit(ask.base, &included, from, (tracks, held), false);
        let why = |e: &DiagnoseError| {
            (ask.options.progress)(&format!("  {} cannot be fitted: {e}", included[self.accepted.len()].effect.title()))
        };
        let (prepared, fitted) = refitted.inspect_err(why).ok()?;
        Some(tried(index, included, prepared, fitted, tracks.len()))
    }

    /// Refits `t` to the end; drops from its class what its own noise, or the other records, can tell
    /// from it; puts the best in front.
    pub fn work_out(
        &self,
        ask: &Question<'_>,
        left: &[&Effect],
        round: &Round,
        t: &mut Tried,
        tracks: &[Track],
        held: &[Track],
    ) -> Result<(), DiagnoseError> {
        thorough(ask, t, (tracks, held));
        let total = |tried: &Tried, noise: &Noise| total(&tried.prepared, &tried.fitted, noise, held);
        let mut rivals = vec![(t.index, total(t, &t.fitted.found.noise)?)];
        for i in std::mem::take(&mut t.equivalent) {
            let Some(mut rival) = self.with(ask, left, round, (i, &t.fitted), (tracks, held)) else { continue };
            let worth = total(&rival, &t.fitted.found.noise)?;
            let best = rivals[0].1;
            rivals.push((i, worth));
            if worth > best + SEPARATES && thorough(ask, &mut rival, (tracks, held)) {
                *t = rival;
                rivals.swap_remove(0);
                rivals.insert(0, (i, total(t, &t.fitted.found.noise)?));
            }
        }
        let best = rivals[0].1;
        t.equivalent = rivals.into_iter().filter(|(i, v)| *i != t.index && *v > best - SEPARATES).map(|(i, _)| i).collect();
        t.equivalent.dedup_by(|a, b| left[*a].id == left[*b].id && left[*a].place == left[*b].place);
        writable(ask.base, t)
    }

    /// An accepted effect whose parameters have become indistinguishable from zero.
    pub fn superfluous(&self) -> Option<usize> {
        (0..self.accepted.len()).find(|&k| {
            let own = &self.prepared.of_effect[k];
            !own.is_empty() && self.fitted.found.unknowns.iter().filter(|u| own.contains(&u.parameter)).all(|u| u.value.abs() < 2.0 * u.sd)
        })
    }
}

/// A refitted candidate and what it is worth.
fn tried(index: usize, included: Vec<Included>, prepared: Arc<Prepared>, fitted: Fitted, records: usize) -> Tried {
    let last = prepared.of_effect.last().into_iter().chain(prepared.of_shape.last()).flatten();
    let values = |i: &usize| if prepared.specs[*i].per_record { records } else { 1 };
    let degrees: usize = last.filter(|&&i| prepared.specs[i].free).map(values).sum();
    let value = fitted.found.log_likelihood - spent(degrees, fitted.found.samples);
    Tried { index, value, included, prepared, fitted, equivalent: Vec::new() }
}

/// Of shapes that nobody named, the one that speaks loudest beyond chance.
fn loudest(scores: &[Score], seen: &[Seen<'_>], options: &Options<'_>) -> Option<String> {
    let beyond_chance = scores.iter().zip(seen).filter(|(s, _)| s.p_family < 0.2 * options.family);
    beyond_chance.max_by(|a, b| a.0.statistic.total_cmp(&b.0.statistic)).map(|(s, seen)| match seen {
        Seen::Shape(_, words) | Seen::Weighted(_, words) => format!("{words} (score {:.1})", s.statistic.sqrt()),
        _ => String::new(),
    })
}

/// Log-likelihood of all records, that of the test records with this noise.
pub(crate) fn total(prepared: &Prepared, fitted: &Fitted, noise: &Noise, held: &[Track]) -> Result<f64, DiagnoseError> {
    let of = |l: &Option<Vec<f64>>| l.as_ref().map_or(f64::NEG_INFINITY, |l| l.iter().sum());
    Ok(fitted.found.log_likelihood + likelihoods(prepared, fitted, noise, held)?.iter().map(of).sum::<f64>())
}

/// What parameters cost in log-likelihood (Schwarz, 1978).
pub(crate) fn spent(degrees: usize, samples: usize) -> f64 {
    0.5 * degrees as f64 * (samples.max(1) as f64).ln()
}

/// Log-likelihood of the training records, less what parameters cost.
pub(crate) fn paid(fitted: &Fitted) -> f64 {
    fitted.found.log_likelihood - spent(fitted.found.unknowns.len(), fitted.found.samples)
}

/// Log-likelihood of all records, that of the test records with this noise, less what parameters cost.
pub(crate) fn worth(prepared: &Prepared, fitted: &Fitted, noise: &Noise, held: &[Track]) -> Result<f64, DiagnoseError> {
    Ok(total(prepared, fitted, noise, held)? - spent(fitted.found.unknowns.len(), fitted.found.samples))
}

/// The text with the numbers as they were found is a rig's: a body may have come out that none can have.
fn writable(base: &Base, t: &Tried) -> Result<(), DiagnoseError> {
    let mean = t.fitted.mean();
    let value = |name: &str| t.fitted.names.iter().position(|n| n == name).map_or(0.0, |i| mean[i]);
    let values = |i: &Included| i.effect.parameters.iter().map(|p| (value(&p.name), 0.0)).collect();
    let written: Vec<Written<'_>> = t
        .included
        .iter()
        .map(|i| Written { effect: &i.effect, values: values(i), evidence: None, per_record: i.effect.by_record, screened: false })
        .collect();
    check(&compose(base, &written, &[])?, &base.rig.name)?;
    Ok(())
}

/// Refits to the end.
fn thorough(ask: &Question<'_>, t: &mut Tried, (tracks, held): (&[Track], &[Track])) -> bool {
    let Ok((prepared, fitted)) = refit(ask.base, &t.included, &t.fitted, (tracks, held), true) else { return false };
    (t.prepared, t.fitted) = (prepared, fitted);
    true
}

/// An effect with coefficients to start from.
fn include(effect: &Effect, step: &[f64], held: Vec<bool>, tracks: &[Track]) -> Included {
    Included { held, effect: effect.clone(), start: begin(effect, step, tracks) }
}

/// Parameters of an effect that the fitted ones have already: they stay at zero.
fn untold(score: &Score) -> Vec<bool> {
    score.minimal_detectable.iter().map(|m| !m.is_finite()).collect()
}

/// Starting values: a delay or lag of zero never leaves it.
fn begin(effect: &Effect, step: &[f64], tracks: &[Track]) -> Vec<f64> {
    let period = tracks.first().map_or(0.01, |t| (t.times()[t.times().len() - 1] - t.times()[0]) / (t.times().len() - 1) as f64);
    let step: Vec<f64> = match effect.signature {
        Signature::InputDelay(_) | Signature::OutputDelay(_) => step.iter().map(|s| s.max(0.02 * period)).collect(),
        _ => effect.parameters.iter().zip(step).map(|(p, s)| if p.positive { s.max(0.0) } else { *s }).collect(),
    };
    effect.with(&step)
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
    all.insert(accepted, include(effect, &[], Vec::new(), &[]));
    prepare(base, asked, &all, accepted + 1)
}

/// Parameters by name from one model to another.
pub(crate) fn carry(from: &Prepared, p: &[f64], to: &Prepared) -> Vec<f64> {
    to.specs.iter().map(|s| from.specs.iter().position(|o| o.name == s.name).map_or(s.value, |i| p[i])).collect()
}

pub(crate) fn scales(prepared: &Prepared, tracks: &[Track], fitted: &Fitted) -> Scales {
    let rig = &prepared.base.rig;
    let n = rig.coordinates.len();
    let mut range = vec![(f64::INFINITY, f64::NEG_INFINITY); n];
    let (mut squares, mut count) = (vec![0.0; n], 0.0);
    let mut input = vec![(0.0_f64, f64::INFINITY, f64::NEG_INFINITY); rig.inputs.len()];
    let (mut duration, mut period) = (0.0_f64, 0.0);
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
        let own = track.times()[track.times().len() - 1] - track.times()[0];
        if own > duration {
            (duration, period) = (own, own / (track.times().len() - 1).max(1) as f64);
        }
    }
    Scales {
        range: range.into_iter().map(|(lo, hi)| if lo <= hi { (lo, hi) } else { (0.0, 0.0) }).collect(),
        rate: squares.into_iter().map(|s: f64| (s / f64::max(count, 1.0)).sqrt()).collect(),
        input: input.into_iter().map(|(largest, lo, hi)| (largest, if hi > lo { hi - lo } else { 0.0 })).collect(),
        duration,
        period,
    }
}
