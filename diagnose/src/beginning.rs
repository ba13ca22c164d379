//! The search from its first step to its last, and a second one with another first step where the first ends with something open: one that goes
//! step by step depends on where it began.
//!
//! Knows searches; nothing of figures or texts.

use crate::base_fit::{Fitted, anew};
use crate::effects::Effect;
use crate::error::DiagnoseError;
use crate::options::Step;
use crate::screen::{SAME, cosine};
use crate::search::{Question, Round, SEPARATES, State, paid, total, worth};
use crate::together::Against;
use crate::turn::Search;
use crate::unseen::unseen;
use crate::verdict::StillOpen;
use ident::innovations::Track;

/// A search that has ended.
pub(crate) struct Ended<'a> {
    pub search: Search<'a>,
    /// The first screening: candidates by their numbers among all effects, and what it says of them.
    pub first: (Vec<usize>, Round),
    pub open: StillOpen,
}

/// The search that `begin` makes; if its end leaves something open, also with another effect than the one it began with, and of both the likelier.
///
/// # Errors
/// [`DiagnoseError`] where a record cannot be followed.
pub(crate) fn search<'a>(begin: &dyn Fn() -> Search<'a>, tracks: &[Track]) -> Result<Ended<'a>, DiagnoseError> {
    let one = explore(begin(), tracks)?;
    let options = one.search.ask.options;
    if options.until == Step::Screen || !options.method.other_records || !unfinished(&one) {
        return Ok(one);
    }
    let Some(first) = one.search.began_with else { return Ok(one) };
    (options.progress)(&format!("once more, not beginning with {} ..", one.search.against.effects[first].title()));
    let mut other = begin();
    other.not_first = alike(first, &one.first);
    let Ok(other) = explore(other, tracks) else { return Ok(one) };
    if other.search.passed.is_empty() || !likelier(&other.search, &one.search)? {
        return Ok(one);
    }
    (options.progress)("  which explains more");
    Ok(Ended { first: one.first, ..other })
}

/// The search with numbers of bodies kept near the text (where `ask` starts), if what joins then explains all records as well as the free numbers
/// did.
///
/// # Errors
/// [`DiagnoseError`] where a record cannot be followed.
pub(crate) fn near_text<'a>(
    ask: Question<'a>,
    against: Against<'a>,
    one: &Ended<'_>,
    tracks: &[Track],
) -> Result<Option<Ended<'a>>, DiagnoseError> {
    let held = against.held;
    (ask.options.progress)("once more, with lengths and masses near the text ..");
    let Ok((prepared, fitted)) = anew(ask.base, ask.starting, &[], (tracks, held)) else { return Ok(None) };
    // it is far from the records: what joins begins anew
    let state = State { prepared, fitted: Fitted { lost: true, ..fitted }, accepted: Vec::new() };
    let Ok(other) = explore(Search::new(ask, against, state), tracks) else { return Ok(None) };
    let (before, after) = (&one.search.current, &other.search.current);
    let has_new = after.accepted.iter().any(|i| before.accepted.iter().all(|had| had.effect != i.effect));
    let noise = &before.fitted.found.noise;
    // what the text says of the kept number is worth more than any number of parameters
    let of = |state: &State| total(&state.prepared, &state.fitted, noise, held);
    Ok((has_new && of(after)? > of(before)? - SEPARATES).then_some(other))
}

/// Turns until nothing more joins.
fn explore<'a>(mut search: Search<'a>, tracks: &[Track]) -> Result<Ended<'a>, DiagnoseError> {
    let options = search.ask.options;
    let effects = search.against.effects;
    let mut first = None;
    loop {
        let (numbers, round) = search.screen(tracks)?;
        let left: Vec<&Effect> = numbers.iter().map(|&i| &effects[i]).collect();
        let mut open = StillOpen { left_over: round.left_over.clone(), unseen: unseen(&search.current, &left, &round), strained: None };
        let full = search.passed.len() >= options.most_effects;
        let goes_on = options.until != Step::Screen && !full && search.turn((&numbers, &round), tracks)?;
        let begun = first.take().unwrap_or((numbers, round));
        if !goes_on {
            if !search.current.accepted.is_empty() {
                open.left_over = search.current.uneven(options, tracks, search.against.held).or(open.left_over);
            }
            return Ok(Ended { search, first: begun, open });
        }
        first = Some(begun);
    }
}

/// Something is left, or was refused in the last turn, that is no chance.
fn unfinished(ended: &Ended<'_>) -> bool {
    let Ended { search, open, .. } = ended;
    let refused = search.rejected.iter().any(|r| r.significant && r.turn == search.turns);
    refused || (open.left_over.is_some() && !search.passed.is_empty())
}

/// The effect and those that the first screening cannot tell from it.
fn alike(effect: usize, (numbers, round): &(Vec<usize>, Round)) -> Vec<usize> {
    let Some(own) = numbers.iter().position(|&i| i == effect) else { return vec![effect] };
    let same = |k: &usize| *k == own || cosine(&round.scores[*k], &round.scores[own]).abs() > SAME;
    (0..numbers.len()).filter(same).map(|k| numbers[k]).collect()
}

/// All records find it likelier, and the training records no less likely than what the first search had to refuse: that would leave it no reason.
fn likelier(other: &Search<'_>, one: &Search<'_>) -> Result<bool, DiagnoseError> {
    let worth = |state: &State| worth(&state.prepared, &state.fitted, &one.current.fitted.found.noise, one.against.held);
    Ok(paid(&other.current.fitted) > one.refused && worth(&other.current)? > worth(&one.current)? + SEPARATES)
}
