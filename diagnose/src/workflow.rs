//! The way from records to a verdict: the one list of steps.
//!
//! look at the records -> fit the base -> where -> screen -> refit the few best -> accept one or none -> again -> verdict -> patch.

use crate::answer::{Candidate, Diagnosis, Finding, Verdict};
use crate::base_fit::{Starting, fit_base};
use crate::beginning::{self, Ended};
use crate::effects::{Effect, EffectParameter, IDS, Scales, by_record, catalogue};
use crate::error::DiagnoseError;
use crate::figures::{self, Measured, View, figures, shrink, view};
use crate::locate::locate;
use crate::model::{Prepared, prepare};
use crate::next::{Open, propose};
use crate::options::{Options, Step};
use crate::patch::Base;
use crate::quality::{ahead, integrates, look, mended, mistaken, stride, stride_of_start};
use crate::screen::{SAME, UNIQUE, cosine};
use crate::search::{Question, Round, State, scales};
use crate::strained::{Far, is_of_a_body, kept, strained};
use crate::strangers::strangers;
use crate::together::{Against, Passed};
use crate::traces;
use crate::turn::Search;
use crate::verdict::{Outcome, finish};
use crate::watched::leave_out_unknown;
use ident::fit::ParameterSpec;
use ident::innovations::{Noise, Track, unwatched};
use ident::record::{Blocks, Record};
use runtime::Model;
use sim::Hold;
use std::sync::Arc;
use std::time::Instant;

/// Finds what a rig's text lacks. `asked` are its parameters as the request has them.
///
/// # Errors
/// [`DiagnoseError`], one variant a cause. Records that cannot be used are a verdict, no error.
pub fn diagnose(
    rig: &Base,
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
    let mut answer = Diagnosis::empty();
    let plain = prepare(rig, asked, &[], 0)?;
    let p0: Vec<f64> = plain.specs.iter().map(|s| s.value).collect();
    let clean = |records: &[Record]| records.iter().map(|r| mended(&plain, &p0, r)).collect::<Vec<_>>();
    let (raw, raw_test) = (train, test);
    let (train, test) = (&clean(train)[..], &clean(test)[..]);
    let block = stride(&plain, &p0, train);
    let blocks = Blocks::of(&plain.model, &p0, options.hold);
    let hold = blocks.hold(block);
    let bind = |records: &[Record]| {
        records.iter().map(|r| Track::new(&blocks.averaged(r, block), &plain.model, &p0, hold)).collect::<Result<Vec<_>, _>>()
    };
    let (mut tracks, mut held) = (bind(train)?, bind(test)?);
    if block > 1 {
        tell(&format!("  blocks of {block} samples are averaged"));
    }

    tell("looking at the records ..");
    answer.faults = look(&plain, &p0, raw, raw_test, (&mut tracks, &mut held));
    answer.faults.extend(leave_out_unknown(&tracks, &mut held));
    if !answer.faults.is_empty() {
        return Ok(unusable(answer, began));
    }
    if options.until == Step::Preflight {
        "the records can be used".clone_into(&mut answer.because);
        return Ok(answer);
    }

    let unwatched = unwatched(&plain.model, &p0, &tracks);
    for &i in &unwatched {
        tell(&format!("  no training record measures {}: it moves as the model says", rig.rig.coordinates[i].name));
    }
    let rig = &Base { unwatched, ..rig.clone() };
    let plain = prepare(rig, asked, &[], 0)?;
    let ranges: Vec<_> = rig.rig.coordinates.iter().filter_map(|c| Some((c.name.clone(), c.range?))).collect();
    let all: Vec<Record> = train.iter().chain(test).map(|r| blocks.averaged(r, block)).collect();
    // where the rig's own values cannot even be run, nothing is known of mistakes
    answer.faults = mistaken(&plain, &ranges, &all, hold).unwrap_or_default();
    if !answer.faults.is_empty() {
        return Ok(unusable(answer, began));
    }
    tell("fitting the base ..");
    // an output error starts from what a free run can see; inputs go straight between blocks
    let (records, held_still): (Vec<Record>, Vec<bool>) = train
        .iter()
        .map(|r| {
            let block = stride_of_start(&plain, &p0, r);
            (blocks.averaged(r, block), block == 1)
        })
        .unzip();
    let hold = if held_still.iter().all(|still| *still) { options.hold } else { Hold::First };
    let starting = Starting { records, hold, asked: asked.into() };
    let fitted = fit_base(&plain, (train, &starting), &mut tracks, &held, options)?;
    tell(&format!("  {}", in_words(&plain, &fitted.found.noise)));
    answer.faults = strangers(&plain, &fitted.found.p, &p0, &fitted.found.noise, &tracks)?;
    if !answer.faults.is_empty() {
        return Ok(unusable(answer, began));
    }
    let trained = Measured { records: train, tracks: &tracks.clone() };
    let tested = Measured { records: test, tracks: &held };
    let mut seen = View { hold: options.hold, horizon: None };
    answer.before = figures(fitted.judged(&plain), Some(trained), tested, seen);
    let longest = train.iter().map(Record::duration).fold(0.0, f64::max);
    seen = view(&answer.before, integrates(&plain, &fitted.mean(), longest), ahead(&plain, &p0), options.hold);
    if seen.horizon.is_some() {
        answer.before = figures(fitted.judged(&plain), Some(trained), tested, seen);
    }
    let given = vec![p0.clone(); tracks.len().max(held.len())];
    answer.published = figures(
        figures::Judged { prepared: &plain, noise: &fitted.found.noise, p_train: &given, p_test: &given },
        Some(trained),
        tested,
        seen,
    );
    answer.after = answer.before.clone();
    answer.noise = Some(fitted.found.noise.clone());
    tell("where do they disagree? ..");
    answer.places = locate(&plain, &fitted.found.p, &fitted.found.noise, &tracks)?;
    if options.traces {
        answer.pushed = traces::pushed(&plain, &fitted.found.p, &fitted.found.noise, &tracks, train)?;
        answer.runs = traces::before(&plain.model, &fitted.found.p, &fitted.of_test, train, test, options.hold);
    }
    if options.until == Step::Where {
        "stopped after the base fit".clone_into(&mut answer.because);
        answer.seconds = began.elapsed().as_secs_f64();
        return Ok(answer);
    }

    let scales = scales(&plain, &tracks, &fitted);
    let mut effects = chosen(rig, &scales, options)?;
    if train.len() > 1 {
        effects.extend(by_record(&effects));
    }
    let base = State { prepared: Arc::new(plain), fitted, accepted: Vec::new() };
    let base_parameters = base.free_parameters();
    // acceptance looks at predictions: many starts scatter less than one free run, which may go over the top
    let horizon = seen.horizon.unwrap_or(ahead(&base.prepared, &p0));
    let against = Against { effects: &effects, held: &held, horizon };
    let ask = Question { base: rig, starting: &starting, options };
    let begin = || Search::new(ask, against, base.clone());
    let mut ended = beginning::search(&begin, &tracks)?;
    let (numbers, round) = &ended.first;
    let left: Vec<&Effect> = numbers.iter().map(|&i| &effects[i]).collect();
    answer.candidates = listed(&left, round);
    answer.screening_p = round.scores[..left.len()].iter().map(|s| s.p_family).fold(1.0, f64::min);
    let far = strained(&rig.rig, &ended.search.current);
    ended.open.strained = far.first().map(Far::words);
    let near = kept(&far, &starting);
    // what would be another word for the same number is no answer
    let others: Vec<Effect> = effects.iter().filter(|e| !is_of_a_body(e)).cloned().collect();
    if let Some(worst) = far.first().filter(|_| options.until == Step::Patch) {
        let ask = Question { base: rig, starting: &near, options };
        if let Some(other) = beginning::near_text(ask, Against { effects: &others, ..against }, &ended, &tracks)? {
            let had = &ended.search.current.accepted;
            let new = other.search.current.accepted.iter().filter(|i| had.iter().all(|had| had.effect != i.effect));
            let instead = worst.words_instead(&new.map(|i| i.effect.title()).collect::<Vec<_>>().join(", "));
            ended = other;
            ended.open.strained = Some(instead);
        }
    }
    let Ended { search, open, .. } = ended;
    let Search { current, passed, rejected, unconfirmed, turns, ask, against: Against { effects, .. }, .. } = search;
    answer.findings = passed.iter().map(|one| finding(effects, one)).collect();
    if !passed.is_empty() {
        answer.after = figures(current.fitted.judged(&current.prepared), Some(trained), tested, seen);
    }
    if options.traces && !answer.findings.is_empty() {
        let found = &current.fitted.found;
        traces::after(&mut answer.runs, &current.prepared.model, &found.p, &current.fitted.of_test, train, test, options.hold);
    }
    if options.next {
        answer.next_experiment = next_experiment(&ask, &answer, &current, unconfirmed.as_ref(), effects, &tracks);
    }
    let outcome = Outcome { state: &current, rejected: &rejected, last: turns, open };
    finish(rig, &mut answer, &base_parameters, &outcome, train)?;
    answer.gap_shrink = shrink(current.fitted.judged(&current.prepared), &held, &answer.before, &answer.after);
    answer.seconds = began.elapsed().as_secs_f64();
    Ok(answer)
}

/// Records with faults are named, not fitted.
fn unusable(mut answer: Diagnosis, began: Instant) -> Diagnosis {
    answer.because = format!("the records cannot be used: {}", answer.faults.join("; "));
    answer.verdict = Verdict::BadData;
    answer.seconds = began.elapsed().as_secs_f64();
    answer
}

/// An effect that passed, its numbers left open until the end.
fn finding(effects: &[Effect], one: &Passed) -> Finding {
    let effect = &effects[one.is.effect];
    let mut equivalent: Vec<(String, String)> = Vec::new();
    for other in one.is.equivalent.iter().map(|&i| (effects[i].id.clone(), effects[i].place.clone())) {
        if !equivalent.contains(&other) {
            equivalent.push(other);
        }
    }
    // where a number of the shape was fitted, what the screening had set it to is no longer so
    let refitted = effect.parameters.iter().any(EffectParameter::is_fitted_shape);
    Finding {
        effect: effect.id.clone(),
        place: effect.place.clone(),
        shape: effect.shape.clone().filter(|_| !refitted),
        parameters: Vec::new(),
        equivalent,
        p_value: one.is.p_family,
        heldout_gain: one.verdict.gain,
        error_ratio: one.error_ratio,
        per_record: effect.by_record,
    }
}

/// The experiment that would settle what is open: an effect that has equivalents, or one that no test record can confirm.
fn next_experiment(
    ask: &Question<'_>,
    answer: &Diagnosis,
    current: &State,
    unconfirmed: Option<&State>,
    effects: &[Effect],
    tracks: &[Track],
) -> Option<String> {
    (ask.options.progress)("the next experiment ..");
    if let Some(k) = answer.findings.iter().position(|f| !f.equivalent.is_empty()) {
        let named = |(id, place): &(String, String)| effects.iter().find(|e| e.id == *id && e.place == *place);
        let rivals = answer.findings[k].equivalent.iter().filter_map(named).collect();
        return propose(ask, &Open { with: current, effect: k, rivals }, tracks);
    }
    let with = unconfirmed?;
    propose(ask, &Open { with, effect: with.accepted.len() - 1, rivals: Vec::new() }, tracks)
}

/// The noises: `random forces theta 0.006 N*m over 0.2 s; outputs theta 0.0002 rad`.
fn in_words(prepared: &Prepared, noise: &Noise) -> String {
    let names = prepared.model.names();
    let forces = noise.entries.iter().enumerate().map(|(k, &entry)| {
        let name = &prepared.base.rig.coordinates[prepared.coordinates[k]].name;
        format!("{name} {:.2e} {} over {:.2} s", noise.sd[k], names.parameter_unit(entry), noise.time[k])
    });
    let outputs = noise.output_sd.iter().enumerate().map(|(i, sd)| format!("{} {sd:.2e} {}", names.output(i), names.output_unit(i)));
    format!("random forces {}; outputs {}", forces.collect::<Vec<_>>().join(", "), outputs.collect::<Vec<_>>().join(", "))
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
fn listed(left: &[&Effect], round: &Round) -> Vec<Candidate> {
    let scores = &round.scores;
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
                detectable_in_test: round.in_test.get(i).cloned().unwrap_or_default(),
                class: class_of[i],
                status: status.to_owned(),
            }
        })
        .collect()
}
