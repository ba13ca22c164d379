//! From where the search ended to a verdict, parameters that moved, and the patched text.

use crate::accept::Refusal;
use crate::answer::{Diagnosis, EffectValue, Moved, Verdict};
use crate::effects::Effect;
use crate::error::DiagnoseError;
use crate::patch::{Base, Written, check, compose, digits};
use crate::search::State;
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

/// Verdict, moved parameters, patched text.
#[allow(clippy::too_many_arguments)]
pub(crate) fn finish(
    base: &Base,
    answer: &mut Diagnosis,
    state: &State,
    before: &[(String, String, f64, f64)],
    (rejected, last): (&[Rejected], usize),
    StillOpen { left_over, unseen, strained }: StillOpen,
    train: &[Record],
) -> Result<(), DiagnoseError> {
    let specs = &state.prepared.specs;
    for (k, finding) in answer.findings.iter_mut().enumerate() {
        let all = [&state.prepared.of_effect, &state.prepared.of_shape];
        let own: Vec<usize> = all.iter().filter_map(|of| of.get(k)).flatten().copied().collect();
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
                sd: u.robust_sd,
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
        if answer.findings.iter().any(|f| title(&f.effect, &f.place)) {
            "accepted".clone_into(&mut candidate.status);
        } else if answer.findings.iter().any(|f| f.equivalent.iter().any(|(id, place)| title(id, place))) {
            "equivalent".clone_into(&mut candidate.status);
        } else if let Some(r) = rejected
            .iter()
            .find(|r| r.effect.id == candidate.effect && r.effect.place == candidate.place && r.effect.shape == candidate.shape)
        {
            candidate.status = format!("rejected: {}", r.why);
        }
    }
    let equivalents = answer.findings.iter().find(|f| !f.equivalent.is_empty()).map(|f| {
        let list: Vec<String> = f.equivalent.iter().map(|(id, place)| format!("{id} on {place}")).collect();
        format!("these records cannot tell {} on {} from {}", f.effect, f.place, list.join(", "))
    });
    let besides = equivalents.as_ref().map(|e| format!("; besides, {e}")).unwrap_or_default();
    let words = left_over.as_ref().map(|w| format!("; left over: {w}")).unwrap_or_default();
    // what the last model still leaves open
    let open: Vec<&Rejected> = rejected.iter().filter(|r| r.significant && r.turn == last).collect();
    let untold: Vec<String> = open.iter().filter(|r| matches!(r.why, Refusal::Untold(_))).map(|r| r.effect.title()).collect();
    let contradicted = open.iter().any(|r| !matches!(r.why, Refusal::Untold(_)));
    (answer.verdict, answer.because) = if answer.findings.is_empty() {
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
        } else if let Some(strained) = &strained {
            (Verdict::NotIdentifiable, format!("nothing is left that these records could show, but {strained}"))
        } else {
            (Verdict::NoGap, "nothing is missing that these records could show".to_owned())
        }
    } else if let Some(equivalents) = equivalents.as_ref().filter(|_| left_over.is_none() && unseen.is_none() && strained.is_none()) {
        (Verdict::Ambiguous, equivalents.clone())
    } else if !untold.is_empty() && !contradicted {
        (
            Verdict::Partial,
            format!("the test records cannot confirm {}, which the training records ask for besides{words}{besides}", untold.join(" or ")),
        )
    } else if contradicted || left_over.is_some() {
        (Verdict::Partial, format!("something is left that no candidate explains{words}{besides}"))
    } else if let Some(strained) = &strained {
        (Verdict::Partial, format!("{strained}{besides}"))
    } else if let Some(unseen) = unseen {
        (Verdict::Partial, format!("{unseen}{besides}"))
    } else {
        (Verdict::Complete, "what is left is white".to_owned())
    };
    if let Some(strained) = strained.filter(|words| !answer.because.contains(words.as_str())) {
        answer.because.push_str(&format!("; {strained}"));
    }
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
                    .map(|p| {
                        let found = finding.parameters.iter().find(|v| v.name == p.name);
                        found.map_or((p.shape.map_or(0.0, |s| s.at), 0.0), |v| (v.value, v.sd))
                    })
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
