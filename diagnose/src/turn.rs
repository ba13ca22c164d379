//! The turns of the search: of the best candidates the first that stands the test joins, alone or with companions; then what stands for
//! another one gives way, and what has become superfluous is dropped.
//!
//! Knows states, records and effects; nothing of figures, verdicts or texts.

use crate::accept::{Bench, Refusal, Tried, judge};
use crate::base_fit::refit;
use crate::effects::Effect;
use crate::error::DiagnoseError;
use crate::search::{Question, Round, State, paid};
use crate::swap::{Place, in_place_of};
use crate::together::{Against, Candidate, Passed, Refused, predicted, together};
use crate::verdict::Rejected;
use ident::innovations::{Ahead, Track};
use std::collections::VecDeque;

/// Log-likelihood by which a refused effect must be ahead of another for that one to be its shadow.
const FAR: f64 = 9.2;
/// Candidates that are worked out and judged in one turn.
const MOST_JUDGED: usize = 5;
/// Refused candidates that are tried with companions.
const MOST_ALONE: usize = 2;

/// A search on its way.
pub(crate) struct Search<'a> {
    pub ask: Question<'a>,
    pub against: Against<'a>,
    /// Where it stands.
    pub current: State,
    /// What passed, in the order of `current.accepted`.
    pub passed: Vec<Passed>,
    /// What was refused.
    pub rejected: Vec<Rejected>,
    /// What the training records ask for and the test records cannot show.
    pub unconfirmed: Option<State>,
    /// Turns that were begun.
    pub turns: usize,
    /// The first effect that joined; where none did, the first that was refused.
    pub began_with: Option<usize>,
    /// Largest log-likelihood of the training records, less what parameters cost, with what was refused while nothing had joined.
    pub refused: f64,
    /// Effects, by their numbers among all, that may not be the first to join.
    pub not_first: Vec<usize>,
    /// Predictions of the test records.
    at_gate: Vec<Vec<Ahead>>,
    swaps: usize,
}

impl<'a> Search<'a> {
    pub fn new(ask: Question<'a>, against: Against<'a>, current: State) -> Self {
        let at_gate = predicted(&current.fitted, &current.prepared, against.held, against.horizon);
        Self {
            ask,
            against,
            current,
            passed: Vec::new(),
            rejected: Vec::new(),
            unconfirmed: None,
            turns: 0,
            began_with: None,
            refused: f64::NEG_INFINITY,
            not_first: Vec::new(),
            at_gate,
            swaps: 0,
        }
    }

    /// Screens what is open; comes with the numbers of these among all effects.
    pub fn screen(&mut self, tracks: &[Track]) -> Result<(Vec<usize>, Round), DiagnoseError> {
        self.turns += 1;
        (self.ask.options.progress)(&format!("screening {} candidates ..", self.against.effects.len()));
        let numbers = self.current.open(self.against.effects);
        let left: Vec<&Effect> = numbers.iter().map(|&i| &self.against.effects[i]).collect();
        // what the test records could show is asked once
        let asked_of: &[Track] = if self.current.accepted.is_empty() { self.against.held } else { &[] };
        let round = self.current.screen(&self.ask, &left, tracks, asked_of)?;
        Ok((numbers, round))
    }

    /// One turn; says whether there should be another.
    pub fn turn(&mut self, (numbers, round): (&[usize], &Round), tracks: &[Track]) -> Result<bool, DiagnoseError> {
        let joined = self.join(numbers, round, tracks)?;
        let last = joined.is_none();
        if let Some((state, passed)) = joined {
            if self.turns == 1 {
                self.began_with = passed.first().map(|one| one.is.effect);
            }
            for one in &passed {
                (self.ask.options.progress)(&format!("  accepted: {}", self.against.effects[one.is.effect].title()));
            }
            self.passed.extend(passed);
            self.current = state;
        }
        let swapped = self.settle(last, tracks)?;
        if last && !swapped {
            return Ok(false);
        }
        self.drop_superfluous(tracks);
        self.at_gate = predicted(&self.current.fitted, &self.current.prepared, self.against.held, self.against.horizon);
        Ok(true)
    }

    /// The first of the best that stands the test, or a group that does.
    fn join(&mut self, numbers: &[usize], round: &Round, tracks: &[Track]) -> Result<Option<(State, Vec<Passed>)>, DiagnoseError> {
        let Against { effects, held, horizon } = self.against;
        let options = self.ask.options;
        let left: Vec<&Effect> = numbers.iter().map(|&i| &effects[i]).collect();
        let mut chosen: VecDeque<Tried> = self.current.try_best(&self.ask, &left, round, tracks, held).into();
        if self.turns == 1 {
            chosen.retain(|t| !self.not_first.contains(&numbers[t.index]));
            self.began_with = chosen.front().map(|t| numbers[t.index]);
        }
        // what is refused although it explains the records far better than another leaves that one no reason
        let mut refused = f64::NEG_INFINITY;
        let mut judged = 0;
        // refused ones that may lack a companion
        let mut alone: Vec<Refused> = Vec::new();
        while let Some(mut tried) = chosen.pop_front() {
            let (first, value) = (left[tried.index], tried.value);
            let mut error_ratio = 1.0;
            let why = if value < refused - FAR {
                Refusal::Shadow
            } else if judged == MOST_JUDGED {
                break;
            } else if let Err(why) = self.current.work_out(&self.ask, &left, round, &mut tried, tracks, held) {
                if matches!(why, DiagnoseError::Patch(_)) { Refusal::NoRig } else { Refusal::Lost }
            } else {
                judged += 1;
                let (prepared, fitted) = (&self.current.prepared, &self.current.fitted);
                let bench = Bench { prepared, fitted, train: tracks, held, before: &self.at_gate, horizon };
                let verdict = judge(&bench, &tried, options);
                error_ratio = verdict.error_ratio;
                let Some(why) = verdict.refused else {
                    let passed = Passed { is: Candidate::of(&tried, numbers, round), verdict, error_ratio };
                    return Ok(Some((State::from(tried), vec![passed])));
                };
                refused = refused.max(value);
                if self.current.accepted.is_empty() {
                    self.refused = self.refused.max(paid(&tried.fitted));
                }
                why
            };
            let effect = if why == Refusal::Shadow { first } else { left[tried.index] };
            (options.progress)(&format!("  {}: {why}", effect.title()));
            // five families in a hundred speak where nothing is missing
            let significant = round.scores[tried.index].p_family < 0.2 * options.family && why != Refusal::Shadow;
            // sizes that differ from record to record may belong to the day
            if matches!(why, Refusal::Contradiction { .. } | Refusal::NoGain(_))
                && effect.of_the_day
                && !effect.by_record
                && let Some(of_the_day) = self.current.of_the_day(&self.ask, &left, &tried, tracks, held)
            {
                chosen.push_front(of_the_day);
            }
            let untold = matches!(why, Refusal::Untold(_));
            let waits = untold || matches!(why, Refusal::Contradiction { .. } | Refusal::NoGain(_) | Refusal::Worse | Refusal::Small(_));
            self.rejected.push(Rejected { effect: effect.clone(), why, significant, turn: self.turns });
            if untold && significant && self.unconfirmed.is_none() {
                let (accepted, prepared, fitted) = (tried.included.clone(), tried.prepared.clone(), tried.fitted.clone());
                self.unconfirmed = Some(State { accepted, prepared, fitted });
            }
            if waits && significant && alone.len() < MOST_ALONE && !effect.by_record {
                alone.push(Refused { is: Candidate::of(&tried, numbers, round), tried, error_ratio });
            }
        }
        if options.method.other_records {
            for first in alone {
                if let Some(group) = together(&self.ask, first, &self.against, tracks)? {
                    return Ok(Some(group));
                }
            }
        }
        Ok(None)
    }

    /// Swaps what stands for another one; the latest waits for what may be missing beside it, until it is the `last`. Then those that are as
    /// likely are named beside it. Says whether anything was swapped.
    fn settle(&mut self, last: bool, tracks: &[Track]) -> Result<bool, DiagnoseError> {
        if !self.ask.options.method.other_records {
            return Ok(false);
        }
        let mut swapped = false;
        let mut as_likely = vec![Vec::new(); self.passed.len()];
        let mut out = 0;
        while out < self.passed.len() - usize::from(!last) && self.swaps < 2 * self.ask.options.most_effects {
            match in_place_of(out, &self.ask, &self.current, &self.against, tracks)? {
                Place::Swap(swap) => {
                    self.swaps += 1;
                    swapped = true;
                    self.passed.remove(out);
                    self.passed.push(swap.passed);
                    self.current = swap.state;
                    out = 0;
                }
                Place::Empty(state) => {
                    self.swaps += 1;
                    swapped = true;
                    self.passed.remove(out);
                    self.current = *state;
                    out = 0;
                }
                Place::AsLikely(others) => {
                    as_likely[out] = others;
                    out += 1;
                }
            }
        }
        if last && !swapped {
            for (one, others) in self.passed.iter_mut().zip(as_likely) {
                one.is.equivalent.extend(others);
            }
        }
        Ok(swapped)
    }

    /// Drops an earlier effect that is no longer there.
    fn drop_superfluous(&mut self, tracks: &[Track]) {
        let Some(out) = self.current.superfluous().filter(|out| out + 1 < self.passed.len()) else { return };
        (self.ask.options.progress)(&format!("  dropped again: {}", self.current.accepted[out].effect.title()));
        let mut fewer = self.current.accepted.clone();
        fewer.remove(out);
        if let Ok((prepared, fitted)) = refit(self.ask.base, &fewer, &self.current.fitted, (tracks, self.against.held), true) {
            self.passed.remove(out);
            self.current = State { prepared, fitted, accepted: fewer };
        }
    }
}
