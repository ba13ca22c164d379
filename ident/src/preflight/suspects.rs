//! Which changes would make model and record agree: every one is tried, and judged beside the record as it is.
//!
//! A change is declared only where it is clearly better: it cuts the product of the unexplained parts of all equations to a
//! quarter, over as many windows as make that no accident ([`EVIDENCE`]), and then explains the equation that gains most.
//! Changes that do as well are named beside it: a
//! mirror of the rig turns an input where two outputs are turned. Changes that alter nothing are what the record cannot tell.

use super::change::Change;
use super::judge::{Judge, Judgement};
use crate::compare::is_angle;
use crate::fit::FitError;
use crate::record::Record;
use std::f64::consts::PI;

/// ln of the factor by which a change must cut the unexplained part: errors of half the size in one equation. Effects that a
/// model lacks let a wrong change seem better by less.
const CLEAR: f64 = 1.386;
/// ln of the likelihood ratio that is asked for, by normal errors of unknown size in independent windows: odds of 20,000 to
/// one leave room for trying some dozens of changes.
const EVIDENCE: f64 = 10.0;
/// Changes within this of each other are as good, however long the record.
const ALIKE: f64 = 0.2;
/// Where no equation leaves more than this unexplained (ratio of amplitudes), offsets and units are not searched for.
const EXPLAINED: f64 = 0.25;
/// What a change may leave unexplained in the equation that gains most: a change that makes a bad model less bad is no finding.
/// (Real rigs lack effects: a turned sign leaves more than all unexplained, its mending as much as any model would.)
const LEFT: f64 = 0.85;
/// Where an equation leaves more than this unexplained, nothing is said of what the record cannot tell.
const TELLS: f64 = 0.5;
/// What a wrong unit, zero or input may leave unexplained in any equation once it is mended: they are searched for among many,
/// and one equation alone can be bent by accident.
const WHOLE: f64 = 0.75;
/// A model that leaves more than this unexplained is of another rig: it cannot judge its inputs.
const NONSENSE: f64 = 2.0;
/// Most changes that are declared for one record.
const MOST: usize = 3;

/// A change that was declared.
#[derive(Clone, Debug, PartialEq)]
pub struct Suspect {
    /// It.
    pub change: Change,
    /// Changes that explain the record as well.
    pub alternatives: Vec<Change>,
    /// The coordinate whose equation gains most.
    pub equation: String,
    /// Its unexplained part before and after, as ratios of amplitudes.
    pub unexplained: (f64, f64),
}

/// What was found in one record.
pub(super) struct Verdict {
    pub suspects: Vec<Suspect>,
    /// Changes that this record cannot tell from the record as it is.
    pub untold: Vec<Change>,
    /// Unexplained parts of the record as it is.
    pub as_it_is: Judgement,
}

/// Names that the search needs.
pub(super) struct Names {
    /// Measured outputs that move: name, unit.
    pub outputs: Vec<(String, String)>,
    /// Inputs: name, unit.
    pub inputs: Vec<(String, String)>,
    /// Outputs whose first sample is zero within two of their steps, while they move by many; with the offsets that keep
    /// them where the rig says that they can go.
    pub from_zero: Vec<(String, (f64, f64))>,
    /// Angles that may be counted from the other end.
    pub half_turns: Vec<String>,
    /// Parameters with a sign.
    pub parameters: Vec<String>,
}

impl Names {
    /// Turned signs and exchanged columns: judged always.
    fn wiring(&self) -> Vec<Change> {
        let mut list: Vec<Change> = self.outputs.iter().map(|(n, _)| Change::SignOfOutput(n.clone())).collect();
        list.extend(self.inputs.iter().map(|(n, _)| Change::SignOfInput(n.clone())));
        list.extend(pairs(&self.outputs).map(|(a, b)| Change::SwapOutputs(a, b)));
        list.extend(pairs(&self.inputs).map(|(a, b)| Change::SwapInputs(a, b)));
        list
    }

    /// Units and zeros: judged where the record is not explained.
    fn reading(&self) -> Vec<Change> {
        let angles: Vec<&String> = self.outputs.iter().filter(|(_, unit)| is_angle(unit)).map(|(n, _)| n).collect();
        let mut list: Vec<Change> = angles.iter().map(|n| Change::Degrees((*n).clone())).collect();
        list.extend(angles.iter().map(|n| Change::Radians((*n).clone())));
        list.extend(self.half_turns.iter().map(|n| Change::HalfTurn(n.clone())));
        list
    }
}

/// Pairs of the same unit.
fn pairs(list: &[(String, String)]) -> impl Iterator<Item = (String, String)> + '_ {
    list.iter().enumerate().flat_map(move |(k, (a, unit))| {
        list[k + 1..].iter().filter(move |(_, other)| other == unit).map(move |(b, _)| (a.clone(), b.clone()))
    })
}

/// Searches one record.
pub(super) fn search(judge: &Judge<'_>, record: &Record, names: &Names) -> Result<Verdict, FitError> {
    let as_it_is = judge.judge(record, &[])?;
    let silent = as_it_is.silent();
    let mut made: Vec<Change> = Vec::new();
    let mut suspects = Vec::new();
    let mut untold = Vec::new();
    let mut now = as_it_is.clone();
    for round in 0..MOST {
        let try_with = |change: Change| -> Option<(Change, Judgement)> {
            let judged = judge.judge(record, &[made.as_slice(), std::slice::from_ref(&change)].concat()).ok()?;
            judged.score(&silent).is_finite().then_some((change, judged))
        };
        let fresh = |list: Vec<Change>| list.into_iter().filter(|c| !made.contains(c)).collect::<Vec<_>>();
        let mut tried: Vec<(Change, Judgement)> = fresh(names.wiring()).into_iter().filter_map(try_with).collect();
        let before = now.score(&silent);
        if round == 0 {
            untold = tried
                .iter()
                .filter(|(_, j)| now.worst() < TELLS && (j.score(&silent) - before).abs() < ALIKE)
                .map(|(c, _)| c.clone())
                .collect();
        }
        let unexplained = now.worst() > EXPLAINED || !before.is_finite();
        if unexplained {
            tried.extend(fresh(names.reading()).into_iter().filter_map(try_with));
            // the dearest search, for what nothing else explains
            if tried.iter().all(|(_, j)| j.worst() > EXPLAINED) {
                let zeros = names.from_zero.iter().filter(|(n, _)| !made.iter().any(|c| c.channels().contains(n)));
                tried.extend(zeros.filter_map(|(name, range)| offset(judge, record, &made, name, *range, &silent)));
            }
        }
        let mut found = best(&now, tried, &silent);
        if found.is_none() && unexplained {
            let turned = names.parameters.iter().map(|p| Change::SignOfParameter(p.clone())).collect();
            found = best(&now, fresh(turned).into_iter().filter_map(try_with).collect(), &silent);
        }
        if found.is_none() && round == 0 && unexplained {
            found = foreign(judge, record, names, &now, &silent);
        }
        let Some((suspect, judged)) = found else { break };
        made.push(suspect.change.clone());
        suspects.push(suspect);
        now = judged;
    }
    Ok(Verdict { suspects, untold, as_it_is })
}

/// The best of the changes, if it is clearly better than none.
fn best(now: &Judgement, mut tried: Vec<(Change, Judgement)>, silent: &[usize]) -> Option<(Suspect, Judgement)> {
    // a change that is not allowed to count must not hide one that is
    tried.retain(|(c, j)| c.is_wiring() || j.worst() < WHOLE);
    tried.sort_by(|a, b| a.1.score(silent).total_cmp(&b.1.score(silent)));
    let (change, judged) = tried.first()?.clone();
    let gain = now.score(silent) - judged.score(silent);
    if !(gain > CLEAR && judged.evidence(now, silent) > EVIDENCE) {
        return None;
    }
    let as_good = |j: &Judgement| {
        let alike = j.score(silent) - judged.score(silent) < ALIKE;
        let clear = now.score(silent) - j.score(silent) > CLEAR;
        clear && (alike || judged.evidence(j, silent) < EVIDENCE)
    };
    let alternatives = tried[1..].iter().filter(|(_, j)| as_good(j)).map(|(c, _)| c.clone()).collect();
    let of = |j: &Judgement, i: usize| j.unexplained[i].1;
    let i = (0..now.unexplained.len())
        .filter(|i| !silent.contains(i))
        .max_by(|&a, &b| (of(now, a) / of(&judged, a)).total_cmp(&(of(now, b) / of(&judged, b))))?;
    let unexplained = (of(now, i).sqrt(), of(&judged, i).sqrt());
    if unexplained.1 > LEFT {
        return None;
    }
    Some((Suspect { change, alternatives, equation: now.unexplained[i].0.clone(), unexplained }, judged))
}

/// Inputs that explain no more of the motion than constant ones, where the model does not explain it: they drove another run.
fn foreign(judge: &Judge<'_>, record: &Record, names: &Names, now: &Judgement, silent: &[usize]) -> Option<(Suspect, Judgement)> {
    let change = Change::Foreign(names.inputs.iter().map(|(n, _)| n.clone()).collect());
    let constant = |name: &str| record.column(name).is_none_or(|c| c.values.iter().all(|v| *v == c.values[0]));
    if now.worst() < TELLS || now.worst() > NONSENSE || names.inputs.iter().all(|(n, _)| constant(n)) {
        return None;
    }
    let judged = judge.judge(record, std::slice::from_ref(&change)).ok()?;
    if judged.score(silent) > now.score(silent) + ALIKE {
        return None;
    }
    let i = (0..now.unexplained.len())
        .filter(|i| !silent.contains(i))
        .max_by(|&a, &b| now.unexplained[a].1.total_cmp(&now.unexplained[b].1))?;
    let unexplained = (now.unexplained[i].1.sqrt(), judged.unexplained[i].1.sqrt());
    Some((Suspect { change, alternatives: Vec::new(), equation: now.unexplained[i].0.clone(), unexplained }, judged))
}

/// The best offset of an output: a coarse grid, then finer about its best place.
fn offset(
    judge: &Judge<'_>,
    record: &Record,
    made: &[Change],
    name: &str,
    range: (f64, f64),
    silent: &[usize],
) -> Option<(Change, Judgement)> {
    let at = |by: f64| {
        let change = Change::Offset(name.to_owned(), by);
        judge.judge(record, &[made, std::slice::from_ref(&change)].concat()).ok().map(|j| (change, j))
    };
    let (mut middle, mut step) = (0.0, PI / 12.0);
    let mut found: Option<(Change, Judgement)> = None;
    for reach in [6, 2, 2, 2] {
        for k in -reach..=reach {
            let by = middle + step * f64::from(k);
            if (range.0..=range.1).contains(&by)
                && let Some(new) = at(by)
                && found.as_ref().is_none_or(|(_, old)| new.1.score(silent) < old.score(silent))
            {
                found = Some(new);
            }
        }
        if let Some((Change::Offset(_, by), _)) = &found {
            middle = *by;
        }
        step /= 3.0;
    }
    found.filter(|(c, j)| matches!(c, Change::Offset(_, by) if by.abs() > 0.02) && j.score(silent).is_finite())
}
