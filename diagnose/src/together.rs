//! Effects that pass only together: while one is missing, the records contradict each other about the other one.

use crate::accept::{Bench, Ruling, Tried, judge};
use crate::base_fit::{Fitted, refit};
use crate::effects::Effect;
use crate::error::DiagnoseError;
use crate::figures::predictions;
use crate::model::Prepared;
use crate::search::{Question, Round, State};
use ident::innovations::Track;

/// Effects that may wait for each other.
const MOST: usize = 3;
/// Companions that are tried at each step.
const COMPANIONS: usize = 3;

/// A candidate, by its number among all effects.
#[derive(Clone)]
pub(crate) struct Candidate {
    pub effect: usize,
    /// Those that cannot be told from it, by the same numbers.
    pub equivalent: Vec<usize>,
    /// p-value in the family, with those before it.
    pub p_family: f64,
}

impl Candidate {
    /// `numbers` are those of the screening's candidates among all effects.
    pub fn of(tried: &Tried, numbers: &[usize], round: &Round) -> Self {
        let equivalent = tried.equivalent.iter().map(|&i| numbers[i]).collect();
        Self { effect: numbers[tried.index], equivalent, p_family: round.scores[tried.index].p_family }
    }
}

/// An effect that passed.
pub(crate) struct Passed {
    pub is: Candidate,
    /// What acceptance found, all others of its group being there.
    pub verdict: Ruling,
    /// Squared error of predictions over that of the model before it joined.
    pub error_ratio: f64,
}

/// A candidate that was refused on its own.
pub(crate) struct Refused {
    pub is: Candidate,
    pub tried: Tried,
    pub error_ratio: f64,
}

/// All effects, and the test records with how far they are predicted.
#[derive(Clone, Copy)]
pub(crate) struct Against<'a> {
    pub effects: &'a [Effect],
    pub held: &'a [Track],
    pub horizon: f64,
}

/// Takes `first` as if it had passed, looks for what is missing beside it, and asks each of the group again with all others there. `None`
/// where no group passes.
pub(crate) fn together(
    ask: &Question<'_>,
    first: Refused,
    against: &Against<'_>,
    tracks: &[Track],
) -> Result<Option<(State, Vec<Passed>)>, DiagnoseError> {
    let Against { effects, held, horizon } = *against;
    let tell = ask.options.progress;
    let before = first.tried.included.len() - 1;
    let none = Ruling { refused: None, gain: (0.0, f64::INFINITY), error_ratio: 1.0 };
    let mut group = vec![Passed { is: first.is, verdict: none, error_ratio: first.error_ratio }];
    let mut state = State::from(first.tried);
    while group.len() < MOST && state.accepted.len() < ask.options.most_effects {
        let numbers = state.open(effects);
        let left: Vec<&Effect> = numbers.iter().map(|&i| &effects[i]).collect();
        tell(&format!("  beside {}: screening {} candidates ..", state.accepted[before].effect.title(), left.len()));
        // what was refused may be a model that no record follows
        let Ok(round) = state.screen(ask, &left, tracks, &[]) else { return Ok(None) };
        let at_gate = predicted(&state.fitted, &state.prepared, held, horizon);
        let mut next: Option<(Tried, Ruling)> = None;
        for mut tried in state.try_best(ask, &left, &round, tracks, held).into_iter().take(COMPANIONS) {
            if state.work_out(ask, &left, &round, &mut tried, tracks, held).is_err() {
                continue;
            }
            let bench = Bench { prepared: &state.prepared, fitted: &state.fitted, train: tracks, held, before: &at_gate, horizon };
            let verdict = judge(&bench, &tried, ask.options);
            if let Some(why) = &verdict.refused {
                tell(&format!("    {}: {why}", left[tried.index].title()));
            }
            let passes = verdict.refused.is_none();
            // the strongest one goes on where none passes: a third may be missing
            if passes || next.is_none() {
                next = Some((tried, verdict));
            }
            if passes {
                break;
            }
        }
        let Some((tried, verdict)) = next else { return Ok(None) };
        let error_ratio = verdict.error_ratio;
        group.push(Passed { is: Candidate::of(&tried, &numbers, &round), verdict, error_ratio });
        state = State::from(tried);
        if all_pass(ask, &state, before, &mut group, against, tracks)? {
            return Ok(Some((state, group)));
        }
    }
    Ok(None)
}

/// Asks each of the group with all others there.
fn all_pass(
    ask: &Question<'_>,
    state: &State,
    before: usize,
    group: &mut [Passed],
    &Against { held, horizon, .. }: &Against<'_>,
    tracks: &[Track],
) -> Result<bool, DiagnoseError> {
    let last = group.len() - 1;
    if group[last].verdict.refused.is_some() {
        return Ok(false);
    }
    for (k, member) in group[..last].iter_mut().enumerate() {
        let mut fewer = state.accepted.clone();
        let own = fewer.remove(before + k);
        let Ok((without, fitted_without)) = refit(ask.base, &fewer, &state.fitted, (tracks, held), true) else {
            return Ok(false);
        };
        // the whole group again, with the one that is asked in the last place
        fewer.push(own);
        let Ok((prepared, fitted)) = refit(ask.base, &fewer, &state.fitted, (tracks, held), false) else {
            return Ok(false);
        };
        let tried = Tried { index: 0, value: 0.0, included: fewer, prepared, fitted, equivalent: Vec::new() };
        let at_gate = predicted(&fitted_without, &without, held, horizon);
        let bench = Bench { prepared: &without, fitted: &fitted_without, train: tracks, held, before: &at_gate, horizon };
        member.verdict = judge(&bench, &tried, ask.options);
        if let Some(why) = &member.verdict.refused {
            (ask.options.progress)(&format!("  {} with the others: {why}", tried.included[before + last].effect.title()));
            return Ok(false);
        }
    }
    Ok(true)
}

/// Predictions of the test records.
pub(crate) fn predicted(fitted: &Fitted, prepared: &Prepared, held: &[Track], horizon: f64) -> Vec<Vec<ident::innovations::Ahead>> {
    predictions(fitted.judged(prepared), held, horizon)
}
