//! From where the search ended to a verdict, parameters that moved, and the patched text.

use crate::accept::Refusal;
use crate::answer::{Candidate, Diagnosis, EffectValue, Finding, Moved, Verdict};
use crate::effects::{Effect, EffectParameter};
use crate::error::DiagnoseError;
use crate::model::Included;
use crate::patch::{Base, Written, check, compose, digits};
use crate::search::State;
use ident::innovations::Unknown;
use ident::record::Record;
use runtime::Model;

/// Most refusals that a sentence tells.
const REASONS: usize = 3;

/// A candidate that was refused.
pub(crate) struct Rejected {
    /// It.
    pub effect: Effect,
    /// Why.
    pub why: Refusal,
    /// It spoke in the screening beyond what chance does where nothing is missing, and not as the shadow of another.
    pub significant: bool,
    /// In this turn of the search.
    pub turn: usize,
}

/// What the last model leaves open.
pub(crate) struct StillOpen {
    /// A gap that no candidate explains.
    pub left_over: Option<String>,
    /// What the records could not have shown of an effect that was found.
    pub unseen: Option<String>,
    /// A number of a body that stands for something else.
    pub strained: Option<String>,
}

/// How a search ended.
pub(crate) struct Outcome<'a> {
    /// The last model.
    pub state: &'a State,
    /// Candidates that were refused.
    pub rejected: &'a [Rejected],
    /// The last turn of the search.
    pub last: usize,
    /// What that model leaves open.
    pub open: StillOpen,
}

/// Verdict, numbers of what was found, parameters that moved from `before`, patched text.
pub(crate) fn finish(
    base: &Base,
    answer: &mut Diagnosis,
    before: &[(String, String, f64, f64)],
    outcome: &Outcome<'_>,
    train: &[Record],
) -> Result<(), DiagnoseError> {
    let state = outcome.state;
    for (k, finding) in answer.findings.iter_mut().enumerate() {
        finding.parameters = numbers(state, k, train);
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
    say_what_became(&mut answer.candidates, &answer.findings, outcome.rejected);
    (answer.verdict, answer.because) = decide(answer, (outcome.rejected, outcome.last), &outcome.open);
    if !answer.findings.is_empty() {
        let files = compose(base, &written(state, &answer.findings), &[])?;
        check(&files, &base.rig.name)?;
        answer.patched = files;
    }
    Ok(())
}

/// Values of the `k`-th finding in the last model.
fn numbers(state: &State, k: usize, train: &[Record]) -> Vec<EffectValue> {
    let all = [&state.prepared.of_effect, &state.prepared.of_shape];
    let own: Vec<usize> = all.iter().filter_map(|of| of.get(k)).flatten().copied().collect();
    let of = |u: &Unknown| EffectValue {
        name: state.prepared.specs[u.parameter].name.clone(),
        record: u.record.and_then(|r| train.get(r)).map(|r| r.source.clone()),
        value: u.value,
        sd: u.robust_sd,
        unit: state.prepared.model.names().parameter_unit(u.parameter).to_owned(),
    };
    state.fitted.found.unknowns.iter().filter(|u| own.contains(&u.parameter)).map(of).collect()
}

/// The status of candidates that were found, or stand beside what was found, or were refused.
fn say_what_became(candidates: &mut [Candidate], findings: &[Finding], rejected: &[Rejected]) {
    for candidate in candidates {
        let title = |id: &str, place: &str| candidate.effect == id && candidate.place == place;
        let same = |r: &&Rejected| title(&r.effect.id, &r.effect.place) && r.effect.shape == candidate.shape;
        if findings.iter().any(|f| title(&f.effect, &f.place)) {
            "accepted".clone_into(&mut candidate.status);
        } else if findings.iter().any(|f| f.equivalent.iter().any(|(id, place)| title(id, place))) {
            "equivalent".clone_into(&mut candidate.status);
        } else if let Some(r) = rejected.iter().find(same) {
            candidate.status = format!("rejected: {}", r.why);
        }
    }
}

/// The verdict, and why.
fn decide(
    answer: &Diagnosis,
    (rejected, last): (&[Rejected], usize),
    StillOpen { left_over, unseen, strained }: &StillOpen,
) -> (Verdict, String) {
    let words = left_over.as_ref().map(|w| format!("; left over: {w}")).unwrap_or_default();
    // what the last model still leaves open
    let open: Vec<&Rejected> = rejected.iter().filter(|r| r.significant && r.turn == last).collect();
    let untold: Vec<String> = open.iter().filter(|r| matches!(r.why, Refusal::Untold(_))).map(|r| r.effect.title()).collect();
    let contradicted = open.iter().any(|r| !matches!(r.why, Refusal::Untold(_)));
    let (verdict, mut because) = if answer.findings.is_empty() {
        if contradicted {
            (
                Verdict::OutsideCatalogue,
                format!("there is a gap, but no candidate stands the test on other records: {}{words}", reasons(rejected)),
            )
        } else if !untold.is_empty() {
            (
                Verdict::NotIdentifiable,
                format!(
                    "the training records ask for {}, which the test records cannot confirm: they would show too little of it if it were \
                     there{words}",
                    untold.join(" or ")
                ),
            )
        } else if let Some(words) = left_over {
            (Verdict::OutsideCatalogue, format!("there is a gap that no candidate explains: {words}"))
        } else if answer.candidates.iter().all(|c| c.status == "not identifiable") && !answer.candidates.is_empty() {
            (Verdict::NotIdentifiable, "the fitted parameters imitate every candidate: these records move too little to tell".to_owned())
        } else if let Some(strained) = strained {
            (Verdict::NotIdentifiable, format!("nothing is left that these records could show, but {strained}"))
        } else {
            (Verdict::NoGap, "nothing is missing that these records could show".to_owned())
        }
    } else {
        let equivalents = answer
            .findings
            .iter()
            .find(|f| !f.equivalent.is_empty())
            .map(|f| format!("these records cannot tell {} on {} from {}", f.effect, f.place, listed(&f.equivalent)));
        let besides = equivalents.as_ref().map(|e| format!("; besides, {e}")).unwrap_or_default();
        let untold_number = unknown_number(&answer.findings);
        let small = strained.as_ref().or(unseen.as_ref()).or(untold_number.as_ref());
        if let Some(equivalents) = equivalents.filter(|_| left_over.is_none() && small.is_none()) {
            (Verdict::Ambiguous, equivalents)
        } else if !untold.is_empty() && !contradicted {
            (
                Verdict::Partial,
                format!(
                    "the test records cannot confirm {}, which the training records ask for besides{words}{besides}",
                    untold.join(" or ")
                ),
            )
        } else if contradicted || left_over.is_some() {
            (Verdict::Partial, format!("something is left that no candidate explains{words}{besides}"))
        } else if let Some(small) = small {
            (Verdict::Partial, format!("{small}{besides}"))
        } else {
            (Verdict::Complete, "what is left is white".to_owned())
        }
    };
    if let Some(strained) = strained.as_ref().filter(|words| !because.contains(words.as_str())) {
        because.push_str(&format!("; {strained}"));
    }
    (verdict, because)
}

/// A number of what was found of which these records say nothing, in words.
fn unknown_number(findings: &[Finding]) -> Option<String> {
    let (finding, number) = findings.iter().find_map(|f| Some((f, f.parameters.iter().find(|v| !v.sd.is_finite())?)))?;
    Some(format!("these records say nothing of {} of {} on {}", number.name, finding.effect, finding.place))
}

/// What was found, as it is written into the text.
fn written<'a>(state: &'a State, findings: &[Finding]) -> Vec<Written<'a>> {
    let one = |(included, finding): (&'a Included, &Finding)| {
        let mut evidence = format!(
            "rig diagnose: {} on {}; gain on records not used {} +- {} nats/sample",
            finding.effect,
            finding.place,
            digits(finding.heldout_gain.0, 2),
            digits(finding.heldout_gain.1, 1)
        );
        if !finding.equivalent.is_empty() {
            evidence.push_str(&format!("\nor {} (not separable with these records)", listed(&finding.equivalent)));
        }
        let value = |p: &EffectParameter| {
            let found = finding.parameters.iter().find(|v| v.name == p.name);
            found.map_or((p.shape.map_or(0.0, |s| s.at), 0.0), |v| (v.value, v.sd))
        };
        let values = included.effect.parameters.iter().map(value).collect();
        Written { effect: &included.effect, values, evidence: Some(evidence), per_record: finding.per_record, screened: false }
    };
    state.accepted.iter().zip(findings).map(one).collect()
}

/// `sensor_bias on phi2, base_tilt on x`.
fn listed(effects: &[(String, String)]) -> String {
    effects.iter().map(|(id, place)| format!("{id} on {place}")).collect::<Vec<_>>().join(", ")
}

/// Why candidates were refused, the first few; those that explain less than a refused one are only counted.
fn reasons(rejected: &[Rejected]) -> String {
    let (told, shadowed): (Vec<&Rejected>, Vec<&Rejected>) = rejected.iter().partition(|r| r.why != Refusal::Shadow);
    let mut list: Vec<String> = told.iter().take(REASONS).map(|r| format!("{} ({})", r.effect.title(), r.why)).collect();
    if told.len() > REASONS {
        list.push(format!("and {} more", told.len() - REASONS));
    }
    if !shadowed.is_empty() {
        list.push(format!("{} more explain the training records less than these", shadowed.len()));
    }
    list.join("; ")
}

#[cfg(test)]
mod tests {
    use super::{StillOpen, decide};
    use crate::answer::{Diagnosis, EffectValue, Finding, Verdict};

    #[test]
    fn a_number_of_which_nothing_is_known_is_told_and_no_diagnosis_with_it_is_complete() {
        let decided = |sd: f64, equivalent: &[(&str, &str)]| {
            let number = |name: &str, sd: f64| EffectValue { name: name.to_owned(), record: None, value: 0.3, sd, unit: "rad".to_owned() };
            let finding = Finding {
                effect: "hard_stop".to_owned(),
                place: "q".to_owned(),
                shape: None,
                parameters: vec![number("k", 0.1), number("edge", sd)],
                equivalent: equivalent.iter().map(|(id, place)| ((*id).to_owned(), (*place).to_owned())).collect(),
                p_value: 0.0,
                heldout_gain: (0.1, 0.01),
                error_ratio: 0.5,
                per_record: false,
            };
            let open = StillOpen { left_over: None, unseen: None, strained: None };
            decide(&Diagnosis { findings: vec![finding], ..Diagnosis::empty() }, (&[], 0), &open)
        };
        assert_eq!(decided(0.1, &[]).0, Verdict::Complete);
        let (verdict, because) = decided(f64::INFINITY, &[]);
        assert_eq!((verdict, because.as_str()), (Verdict::Partial, "these records say nothing of edge of hard_stop on q"));
        let (verdict, because) = decided(f64::INFINITY, &[("spring", "q")]);
        assert!(
            verdict == Verdict::Partial && because.ends_with("besides, these records cannot tell hard_stop on q from spring on q"),
            "{because}"
        );
    }
}
