//! Swaps: an effect that was accepted may have stood for another one, which only shows beside its companions, or which all records
//! together find likelier, or which says the same with fewer numbers; and others may be as likely.

use crate::accept::{Bench, Refusal, Tried, judge};
use crate::base_fit::{Fitted, refit};
use crate::effects::Effect;
use crate::error::DiagnoseError;
use crate::model::Prepared;
use crate::screen::{SAME, Score, between, cosine};
use crate::search::{Question, SEPARATES, State, worth};
use crate::together::{Against, Candidate, Passed, predicted};
use ident::innovations::Track;
use ident::parallel::in_parallel;

/// Others that are tried in an effect's place.
const RIVALS: usize = 3;
/// Smallest statistic of these, in parts of that of the effect itself.
const NEARLY: f64 = 0.7;

/// Cosine of signatures that are one and the same.
const EQUAL: f64 = 0.999;

/// What may stand in the place of an accepted effect.
pub(crate) enum Place {
    /// Another one is likelier, or as likely with fewer numbers, and passes.
    Swap(Box<Swap>),
    /// These, by their numbers among all effects, are as likely, and would pass or cannot be ruled out.
    AsLikely(Vec<usize>),
    /// Nothing is needed there: the state without.
    Empty(Box<State>),
}

/// An effect that takes the place of an accepted one.
pub(crate) struct Swap {
    /// The state with the new one, which is its last.
    pub state: State,
    /// What acceptance says of the new one.
    pub passed: Passed,
}

/// What all records say of others in the place of accepted effect `out`.
///
/// # Errors
/// [`DiagnoseError`] where a record cannot be followed.
pub(crate) fn in_place_of(
    out: usize,
    ask: &Question<'_>,
    current: &State,
    &Against { effects, held, horizon }: &Against<'_>,
    tracks: &[Track],
) -> Result<Place, DiagnoseError> {
    let tell = ask.options.progress;
    let nothing = || Ok(Place::AsLikely(Vec::new()));
    let own = &current.accepted[out].effect;
    let mut fewer = current.accepted.clone();
    fewer.remove(out);
    let Ok((prepared, fitted)) = refit(ask.base, &fewer, &current.fitted, (tracks, held), false) else { return nothing() };
    let without = State { prepared, fitted, accepted: fewer };
    let numbers = without.open(effects);
    let left: Vec<&Effect> = numbers.iter().map(|&i| &effects[i]).collect();
    // a model that lacks it may not be able to follow the records at all
    let Ok(round) = without.screen(ask, &left, tracks, &[]) else { return nothing() };
    let is_own = |i: usize| left[i].id == own.id && left[i].place == own.place;
    let kin = Kin::new(&round.scores, (0..left.len()).filter(|&i| is_own(i)), only_one(current, out));
    let noise = &current.fitted.found.noise;
    let worth = |prepared: &Prepared, fitted: &Fitted| worth(prepared, fitted, noise, held);
    let before = worth(&current.prepared, &current.fitted)?;
    if worth(&without.prepared, &without.fitted)? >= before {
        tell(&format!("  dropped again: {}", own.title()));
        let (prepared, fitted) = refit(ask.base, &without.accepted, &without.fitted, (tracks, held), true)?;
        return Ok(Place::Empty(Box::new(State { prepared, fitted, ..without })));
    }
    let mut rivals: Vec<(f64, Tried)> = Vec::new();
    let others = |i: &usize| !is_own(*i);
    let nearest = kin.simplest((0..left.len()).filter(others));
    let likely = without.speaking(ask, &left, &round).into_iter().filter(others).filter(|&i| Some(i) != nearest && kin.rivals(i));
    let few: Vec<usize> = nearest.into_iter().chain(likely.take(RIVALS)).collect();
    let refitted = in_parallel(&few, |_, &i| without.with(ask, &left, &round, (i, &without.fitted), (tracks, held)));
    for rival in refitted.into_iter().flatten() {
        let own = worth(&rival.prepared, &rival.fitted)?;
        // a hurried fit may lack as much
        if own > before - 2.0 * SEPARATES {
            rivals.push((own, rival));
        }
    }
    rivals.sort_by(|a, b| b.0.total_cmp(&a.0));
    let at_gate = predicted(&without.fitted, &without.prepared, held, horizon);
    let mut as_likely = Vec::new();
    for (_, mut rival) in rivals {
        if without.work_out(ask, &left, &round, &mut rival, tracks, held).is_err() {
            continue;
        }
        let ahead = worth(&rival.prepared, &rival.fitted)? - before;
        if is_own(rival.index) || ahead < -SEPARATES {
            continue;
        }
        let title = left[rival.index].title();
        let bench = Bench { prepared: &without.prepared, fitted: &without.fitted, train: tracks, held, before: &at_gate, horizon };
        let verdict = judge(&bench, &rival, ask.options);
        if let Some(why) = &verdict.refused {
            tell(&format!("  {title} in the place of {}: {why}", own.title()));
        }
        let enough = if nearest == Some(rival.index) { 0.0 } else { SEPARATES };
        match (&verdict.refused, ahead > enough) {
            (None, true) => {
                tell(&format!("  {title} takes the place of {}", own.title()));
                let error_ratio = verdict.error_ratio;
                let passed = Passed { is: Candidate::of(&rival, &numbers, &round), verdict, error_ratio };
                let state = State::from(rival);
                return Ok(Place::Swap(Box::new(Swap { state, passed })));
            }
            // what the test records show too little of, they do not rule out either
            (None | Some(Refusal::Untold(_)), _) => {
                tell(&format!("  {title} is as likely as {}", own.title()));
                as_likely.push(numbers[rival.index]);
            }
            (Some(_), _) => {}
        }
    }
    Ok(Place::AsLikely(as_likely))
}

/// How others stand to the effect itself, in a screening without it.
struct Kin<'a> {
    scores: &'a [Score],
    itself: Option<usize>,
    /// The one column of its own that is not nothing.
    only: Option<usize>,
}

impl<'a> Kin<'a> {
    /// `itself` are the shapes of the effect: the loudest counts.
    fn new(scores: &'a [Score], itself: impl Iterator<Item = usize>, only: Option<usize>) -> Self {
        Self { scores, itself: itself.max_by(|&a, &b| scores[a].statistic.total_cmp(&scores[b].statistic)), only }
    }

    /// What says the same with one number where the effect has several of which the others are nothing.
    fn simplest(&self, among: impl Iterator<Item = usize>) -> Option<usize> {
        let column = self.scores[self.itself?].each.get(self.only?)?;
        let cosine = |i: usize| between(column, &self.scores[i].direction).abs();
        let same = among.filter(|&i| self.scores[i].degrees == 1).map(|i| (cosine(i), i)).filter(|(cosine, _)| *cosine > EQUAL);
        same.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
    }

    /// Nearly as loud, and not the same with more numbers.
    fn rivals(&self, i: usize) -> bool {
        let Some(own) = self.itself.map(|k| &self.scores[k]) else { return true };
        let one = &self.scores[i];
        let larger = one.degrees > own.degrees && cosine(own, one).abs() > SAME;
        !larger && one.statistic >= NEARLY * own.statistic
    }
}

/// The one coefficient of an accepted effect that is not zero, where it has several.
fn only_one(state: &State, out: usize) -> Option<usize> {
    let own = &state.prepared.of_effect[out];
    let is_there = |i: &usize| state.fitted.found.unknowns.iter().any(|u| u.parameter == *i && u.value.abs() > 1.96 * u.robust_sd);
    let mut there = (0..own.len()).filter(|&k| is_there(&own[k]));
    let first = there.next().filter(|_| own.len() > 1)?;
    there.next().is_none().then_some(first)
}
