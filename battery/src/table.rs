//! Counts of outcomes, with their intervals.

use crate::run::{Outcome, Said};
use std::collections::BTreeMap;
use std::fmt::Write;

/// A share with its 95 % interval (E. B. Wilson, JASA 22, 1927).
#[must_use]
pub fn share(hits: usize, of: usize) -> String {
    if of == 0 {
        return "-".to_owned();
    }
    let (n, p, z) = (of as f64, hits as f64 / of as f64, 1.959_964_f64);
    let middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    let half = z / (1.0 + z * z / n) * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
    format!("{:.1} % [{:.1}, {:.1}] ({hits}/{of})", 100.0 * p, 100.0 * (middle - half).max(0.0), 100.0 * (middle + half).min(1.0))
}

fn median(mut values: Vec<f64>) -> String {
    values.retain(|v| v.is_finite());
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).map_or_else(|| "-".to_owned(), |v| format!("{v:.2}"))
}

/// The first effect that was said is the hidden one, or of its class.
#[must_use]
pub fn right(said: &Said, outcome: &Outcome, hidden: usize) -> bool {
    let h = &outcome.hidden[hidden];
    let same = |e: &str, p: &str| e == h.effect && p == h.place;
    let class = outcome.truth_class.get(hidden).copied().unwrap_or(0);
    same(&said.effect, &said.place) || said.equivalent.iter().any(|(e, p)| same(e, p)) || (class > 0 && said.class == class)
}

/// The hidden effect stands in what was said.
#[must_use]
pub fn covered(said: &Said, outcome: &Outcome, hidden: usize) -> bool {
    let h = &outcome.hidden[hidden];
    (said.effect == h.effect && said.place == h.place) || said.equivalent.iter().any(|(e, p)| *e == h.effect && *p == h.place)
}

/// All hidden effects have one of their class among what was said, and nothing else was said.
#[must_use]
pub fn all_right(outcome: &Outcome) -> bool {
    !outcome.failed
        && outcome.said.len() == outcome.hidden.len()
        && (0..outcome.hidden.len()).all(|k| outcome.said.iter().any(|s| right(s, outcome, k)))
}

/// Effects whose text has numbers that the truth does not share: their sizes cannot be compared.
const SHAPED: [&str; 5] = ["stribeck", "hard_stop", "actuator_saturation", "start_transient", "periodic_torque"];

/// Whether intervals of the coefficients hold the truth, for effects that were said by their own name.
fn coefficients(outcome: &Outcome) -> Vec<bool> {
    let mut all = Vec::new();
    for h in outcome.hidden.iter().filter(|h| !SHAPED.contains(&h.effect.as_str())) {
        if let Some(said) = outcome.said.iter().find(|s| s.effect == h.effect && s.place == h.place)
            && !said.by_record
            && said.values.len() == h.sizes.len()
        {
            let (value, sd) = said.values[0];
            all.push((value - h.sizes[0]).abs() <= 1.96 * sd);
        }
    }
    all
}

/// A name without a doubt that is not the hidden one's.
fn wrongly_confident(outcome: &Outcome) -> bool {
    let sure = outcome.verdict == "complete" || outcome.verdict == "ambiguous";
    sure && outcome.said.iter().any(|s| (0..outcome.hidden.len()).all(|k| !right(s, outcome, k)))
}

/// The tables of all rows in a list of outcomes, as Markdown.
#[must_use]
pub fn tables(all: &[Outcome]) -> String {
    let mut rows: Vec<&str> = all.iter().map(|o| o.row.as_str()).collect();
    rows.sort_unstable();
    rows.dedup();
    let mut text = String::new();
    for row in rows {
        let own: Vec<&Outcome> = all.iter().filter(|o| o.row == row).collect();
        let _ = writeln!(text, "\n## {row}: {} runs\n", own.len());
        match row {
            "nothing" | "bad-data" | "day" => {
                silent(&own, &mut text, "condition", &|o| o.part.clone());
                let _ = writeln!(text);
                silent(&own, &mut text, "rig", &|o| o.rig.clone());
            }
            "ablation" => {
                let (nothing, some): (Vec<&Outcome>, Vec<&Outcome>) = own.iter().partition(|o| o.hidden.is_empty());
                for (group, table) in [(&nothing, silent as Table), (&some, hidden)] {
                    if !group.is_empty() {
                        table(group, &mut text, "what is hidden: method", &|o| o.part.clone());
                        let _ = writeln!(text);
                    }
                }
            }
            "outside" => outside(&own, &mut text),
            "dose" => dose(&own, &mut text),
            _ => {
                hidden(&own, &mut text, "part", &|o| o.part.clone());
                let _ = writeln!(text);
                hidden(&own, &mut text, "rig", &|o| o.rig.clone());
                let _ = writeln!(text);
                hidden(&own, &mut text, "effect", &|o| o.hidden.iter().map(|h| h.effect.as_str()).collect::<Vec<_>>().join(" + "));
                confusion(&own, &mut text);
            }
        }
        failures(row, &own, &mut text);
    }
    text
}

fn groups<'a>(own: &[&'a Outcome], key: &dyn Fn(&Outcome) -> String) -> Vec<(String, Vec<&'a Outcome>)> {
    let mut found: BTreeMap<String, Vec<&Outcome>> = BTreeMap::new();
    for o in own {
        found.entry(key(o)).or_default().push(o);
    }
    let mut all: Vec<_> = found.into_iter().collect();
    if all.len() > 1 {
        all.push(("all".to_owned(), own.to_vec()));
    }
    all
}

fn verdicts(own: &[&Outcome]) -> String {
    let mut found: BTreeMap<&str, usize> = BTreeMap::new();
    own.iter().for_each(|o| *found.entry(&o.verdict).or_default() += 1);
    found.iter().map(|(v, n)| format!("{v} {n}")).collect::<Vec<_>>().join(", ")
}

/// An effect was said where none of the rig is there; what belongs to the day may be said of it.
fn speaks(o: &Outcome) -> bool {
    let day = o.part.starts_with("of-the-day") || o.part.starts_with("day:");
    o.said.iter().any(|s| !(day && s.by_record))
}

/// Counts of a list of outcomes, by what names their groups.
type Table = fn(&[&Outcome], &mut String, &str, &dyn Fn(&Outcome) -> String);

fn silent(own: &[&Outcome], text: &mut String, title: &str, key: &dyn Fn(&Outcome) -> String) {
    let _ = writeln!(text, "| {title} | screening error | effects reported | verdicts | median s |\n|---|---|---|---|---|");
    for (name, group) in groups(own, key) {
        let ran: Vec<&&Outcome> = group.iter().filter(|o| !o.failed && o.verdict != "bad_data").collect();
        let p = ran.iter().filter(|o| o.screening_p < 0.05).count();
        let said = group.iter().filter(|o| speaks(o)).count();
        let seconds = median(group.iter().map(|o| o.seconds).collect());
        let _ = writeln!(text, "| {name} | {} | {} | {} | {seconds} |", share(p, ran.len()), share(said, group.len()), verdicts(&group));
    }
}

fn hidden(own: &[&Outcome], text: &mut String, title: &str, key: &dyn Fn(&Outcome) -> String) {
    let _ = writeln!(
        text,
        "| {title} | screened | right class first in screening | something said | right, and nothing else | class said covers truth | coefficient in its interval | wrong and sure | median shrink | class size | test worse |\n|---|---|---|---|---|---|---|---|---|---|---|"
    );
    for (name, group) in groups(own, key) {
        let n = group.len();
        let screened = group.iter().filter(|o| o.screening_p < 0.05).count();
        let first = group.iter().filter(|o| o.strongest.as_ref().is_some_and(|s| o.truth_class.contains(&s.2))).count();
        let said = group.iter().filter(|o| !o.said.is_empty()).count();
        let right = group.iter().filter(|o| all_right(o)).count();
        let cover =
            group.iter().filter(|o| !o.said.is_empty() && (0..o.hidden.len()).all(|k| o.said.iter().any(|s| covered(s, o, k)))).count();
        let inside: Vec<bool> = group.iter().flat_map(|o| coefficients(o)).collect();
        let wrong = group.iter().filter(|o| wrongly_confident(o)).count();
        let shrunk = group.iter().filter(|o| !o.said.is_empty()).flat_map(|o| o.shrink.iter().map(|s| s.1).reduce(f64::max)).collect();
        let sizes: Vec<f64> = group.iter().flat_map(|o| o.class_size.iter().map(|s| *s as f64)).collect();
        let size = sizes.iter().sum::<f64>() / sizes.len().max(1) as f64;
        let worse = group.iter().filter(|o| !o.said.is_empty() && o.test_ratio.is_some_and(|r| r > 1.0)).count();
        let _ = writeln!(
            text,
            "| {name} | {} | {} | {} | {} | {} | {} | {} | {} | {size:.1} | {worse}/{said} |",
            share(screened, n),
            share(first, n),
            share(said, n),
            share(right, n),
            share(cover, said),
            share(inside.iter().filter(|i| **i).count(), inside.len()),
            share(wrong, n),
            median(shrunk),
        );
    }
}

fn outside(own: &[&Outcome], text: &mut String) {
    let _ = writeln!(text, "| hidden | gap seen | silent or partial | wrong and sure | names | verdicts |\n|---|---|---|---|---|---|");
    for (name, group) in groups(own, &|o| o.part.clone()) {
        let seen = group.iter().filter(|o| o.verdict != "no_gap" && o.verdict != "failed").count();
        let sure: Vec<&&Outcome> =
            group.iter().filter(|o| !o.said.is_empty() && (o.verdict == "complete" || o.verdict == "ambiguous")).collect();
        // a spring that gravity eats is in the catalogue
        let wrong = sure.iter().filter(|o| !(0..o.hidden.len()).all(|k| o.said.iter().any(|s| covered(s, o, k)))).count();
        let mut names: BTreeMap<&str, usize> = BTreeMap::new();
        group.iter().flat_map(|o| &o.said).for_each(|s| *names.entry(&s.effect).or_default() += 1);
        let names: Vec<String> = names.iter().map(|(n, k)| format!("{n} {k}")).collect();
        let _ = writeln!(
            text,
            "| {name} | {} | {} | {} | {} | {} |",
            share(seen, group.len()),
            share(group.len() - sure.len(), group.len()),
            share(wrong, group.len()),
            names.join(", "),
            verdicts(&group)
        );
    }
}

/// Standard normal distribution (Abramowitz and Stegun 26.2.17, error below 1e-7).
fn phi(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.231_641_9 * x.abs());
    let poly = t * (0.319_381_53 + t * (-0.356_563_782 + t * (1.781_477_937 + t * (-1.821_255_978 + t * 1.330_274_429))));
    let tail = (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt() * poly;
    if x >= 0.0 { 1.0 - tail } else { tail }
}

fn dose(own: &[&Outcome], text: &mut String) {
    let _ = writeln!(
        text,
        "Predicted is Phi(k (z + 1.28) - z) at k times the smallest size that shows, z = 2.8 (a family of about ten that differ).\n\n| effect | k | predicted | screened | right class first | said, right | said, wrong |\n|---|---|---|---|---|---|---|"
    );
    let mut found: BTreeMap<(String, u64), Vec<&Outcome>> = BTreeMap::new();
    for o in own.iter().filter(|o| !o.hidden.is_empty()) {
        found.entry((o.hidden[0].effect.clone(), (o.hidden[0].multiple * 1000.0) as u64)).or_default().push(o);
    }
    for ((effect, k), group) in found {
        let k = k as f64 / 1000.0;
        let n = group.len();
        let screened = group.iter().filter(|o| o.screening_p < 0.05).count();
        let first =
            group.iter().filter(|o| o.screening_p < 0.05 && o.strongest.as_ref().is_some_and(|s| o.truth_class.contains(&s.2))).count();
        let good = group.iter().filter(|o| all_right(o)).count();
        let wrong = group.iter().filter(|o| o.said.iter().any(|s| !right(s, o, 0))).count();
        let predicted = 100.0 * phi(k * (2.8 + 1.2816) - 2.8);
        let _ = writeln!(
            text,
            "| {effect} | {k} | {predicted:.0} % | {} | {} | {} | {} |",
            share(screened, n),
            share(first, n),
            share(good, n),
            share(wrong, n)
        );
    }
}

/// Hidden against first said.
fn confusion(own: &[&Outcome], text: &mut String) {
    let mut found: BTreeMap<&str, BTreeMap<String, usize>> = BTreeMap::new();
    for o in own {
        for (k, h) in o.hidden.iter().enumerate() {
            let said = o.said.iter().find(|s| right(s, o, k)).or_else(|| (o.hidden.len() == 1).then(|| o.said.first()).flatten());
            let name = said.map_or_else(
                || "(nothing)".to_owned(),
                |s| {
                    if s.effect == h.effect && s.place == h.place {
                        "itself".to_owned()
                    } else if right(s, o, k) {
                        format!("{} (same class)", s.effect)
                    } else {
                        format!("**{} on {}**", s.effect, s.place)
                    }
                },
            );
            *found.entry(&h.effect).or_default().entry(name).or_default() += 1;
        }
    }
    let _ = writeln!(text, "\n| hidden | said first (bold: another class) |\n|---|---|");
    for (effect, said) in found {
        let list: Vec<String> = said.iter().map(|(s, n)| format!("{s} {n}")).collect();
        let _ = writeln!(text, "| {effect} | {} |", list.join(", "));
    }
}

/// Every run that is not as it should be.
fn failures(row: &str, own: &[&Outcome], text: &mut String) {
    let bad: Vec<&&Outcome> = own
        .iter()
        .filter(|o| match row {
            _ if o.failed => true,
            "nothing" | "bad-data" | "day" => speaks(o),
            "outside" => !o.said.is_empty() && (o.verdict == "complete" || o.verdict == "ambiguous"),
            "dose" => o.said.iter().any(|s| !right(s, o, 0)),
            "ablation" => false,
            _ => !all_right(o) || wrongly_confident(o),
        })
        .collect();
    if bad.is_empty() {
        return;
    }
    let _ = writeln!(text, "\nNot as it should be ({}):\n", bad.len());
    for o in bad {
        let hidden: Vec<String> = o.hidden.iter().map(|h| format!("{} on {} {:?}", h.effect, h.place, h.sizes)).collect();
        let said: Vec<String> = o
            .said
            .iter()
            .map(|s| format!("{} on {} (gain {:.1e})", s.effect, s.place, s.gain.0) + if s.by_record { " of the day" } else { "" })
            .collect();
        let because: String = o.because.chars().take(220).collect();
        let _ = writeln!(
            text,
            "- {} {} no. {}: hidden {}; said {}; p {:.1e}; {}: {because}",
            o.part,
            o.rig,
            o.number,
            if hidden.is_empty() { "nothing".to_owned() } else { hidden.join(", ") },
            if said.is_empty() { "nothing".to_owned() } else { said.join(", ") },
            o.screening_p,
            o.verdict
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_have_wilsons_intervals() {
        // R: prop.test(8, 200, correct = FALSE)
        assert_eq!(share(8, 200), "4.0 % [2.0, 7.7] (8/200)");
        assert_eq!(share(0, 0), "-");
    }

    #[test]
    fn the_normal_distribution_is_that_of_tables() {
        assert!((phi(1.0) - 0.841_344_7).abs() < 1e-6 && (phi(-2.0) - 0.022_750_1).abs() < 1e-6);
    }
}
