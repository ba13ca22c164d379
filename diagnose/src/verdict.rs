//! From where the search ended to a verdict, parameters that moved, and the patched text.

use crate::answer::{Diagnosis, EffectValue, Moved, Verdict};
use crate::error::DiagnoseError;
use crate::patch::{Base, Written, check, compose, digits};
use crate::search::State;
use ident::record::Record;
use runtime::Model;

/// Verdict, moved parameters, patched text.
#[allow(clippy::too_many_arguments)]
pub(crate) fn finish(
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
        if answer.findings.iter().any(|f| title(&f.effect, &f.place)) {
            "accepted".clone_into(&mut candidate.status);
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
