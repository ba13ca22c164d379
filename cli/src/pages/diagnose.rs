//! The page of `rig diagnose`: where, what, how much, and from what.

use super::identify::overlay;
use super::{bracketed, brief, percent, short, shown, times, with_unit};
use crate::control_change::Change;
use crate::output::{number, poles_in_words, prime};
use diagnose::{Candidate, Diagnosis, Figure, Pushed, Traced, Verdict};
use report::{Block, Cell, Ink, Page, Plot, Series, Shape, Table, Tone};
use std::path::Path;

/// Candidates that are shown at once.
const FIRST: usize = 15;

/// What stands beside the diagnosis itself.
pub struct Around<'a> {
    /// Name of the rig.
    pub rig: &'a str,
    /// Its file.
    pub source: &'a Path,
    /// Files of the records.
    pub records: &'a [&'a Path],
    /// What was asked for: names and values.
    pub options: Vec<(String, String)>,
    /// Texts that were patched: name, before, after.
    pub texts: Vec<(String, String, String)>,
    /// What the patch changes for a regulator; `Err` says why there is none.
    pub control: Option<Result<Change, String>>,
}

/// The page.
pub fn page(found: &Diagnosis, around: &Around<'_>) -> Page {
    let mut blocks = vec![Block::Callout {
        tone: tone(found.verdict),
        word: format!("{}:", found.verdict.id().replace('_', " ")),
        sentence: found.because.clone(),
    }];
    blocks.extend(found.findings.iter().map(|f| Block::Text(format!("Found: {}", finding(f)))));
    if let Some(next) = &found.next_experiment {
        blocks.push(Block::Callout { tone: Tone::Plain, word: "Next experiment:".to_owned(), sentence: next.clone() });
    }
    blocks.extend(found.faults.iter().map(|fault| Block::Callout { tone: Tone::Bad, word: "Fault:".to_owned(), sentence: fault.clone() }));
    places(found, &mut blocks);
    candidates(&found.candidates, &mut blocks);
    accepted(found, around, &mut blocks);
    figures(found, &mut blocks);
    moved(found, &mut blocks);
    control(around, &mut blocks);
    let mut files = vec![around.source];
    files.extend(around.records);
    let mut provenance = super::provenance(&files);
    provenance.extend(around.options.iter().cloned());
    Page {
        mark: super::mark(around.source, "diagnose"),
        title: format!("{}: what the model lacks", around.rig),
        subtitle: String::new(),
        blocks,
        provenance,
        time: Some(format!("{} s", number(found.seconds))),
    }
}

fn tone(verdict: Verdict) -> Tone {
    match verdict {
        Verdict::Complete | Verdict::NoGap => Tone::Good,
        Verdict::Partial | Verdict::Ambiguous | Verdict::NotIdentifiable | Verdict::OutsideCatalogue => Tone::Warning,
        Verdict::BadData => Tone::Bad,
    }
}

fn finding(f: &diagnose::Finding) -> String {
    let values: Vec<String> =
        f.parameters.iter().map(|v| format!("{} = {} +- {}", v.name, brief(v.value), with_unit(brief(v.sd), &v.unit))).collect();
    format!("{} on {}, {}", f.effect, f.place, values.join(", "))
}

/// Where: what pushed each equation, over time and against what explains it best.
fn places(found: &Diagnosis, blocks: &mut Vec<Block>) {
    if found.places.is_empty() {
        return;
    }
    blocks.push(Block::Heading("Where they disagree".to_owned()));
    blocks.push(Block::Text("The refitted base, and the force or torque beside it that the records ask for (smoothed; shaded: two standard errors; marked: where it is beyond chance).".to_owned()));
    for place in &found.places {
        blocks.push(Block::Subheading(place.sentence.clone()));
        let own: Vec<&Pushed> = found.pushed.iter().filter(|p| p.equation == place.equation).collect();
        let mut plots = Vec::new();
        for (k, pushed) in own.iter().enumerate() {
            let edge = |sign: f64| pushed.force.iter().zip(&pushed.sd).map(|(d, sd)| d + sign * 2.0 * sd).collect::<Vec<f64>>();
            plots.push(Plot {
                series: vec![
                    Series::line("", Ink::Model, &pushed.t, &edge(-1.0)).drawn(Shape::Band(edge(1.0))),
                    Series::line("", Ink::Model, &pushed.t, &pushed.force),
                ],
                windows: if k == 0 { place.windows.clone() } else { Vec::new() },
                levels: vec![0.0],
                wide: true,
                ..Plot::new(short(&pushed.record), "t [s]", format!("on {}{}", place.equation, bracketed(&pushed.unit)))
            });
        }
        if let Some(first) = own.first() {
            for i in telling(&own) {
                plots.push(against(&own, &first.against[i], i, &place.equation, &place.unit));
            }
        }
        blocks.push(Block::Plots(plots));
    }
}

/// The disturbance against one variable, a colour for each record.
fn against(own: &[&Pushed], variable: &Traced, index: usize, equation: &str, unit: &str) -> Plot {
    let (factor, shown) = shown(&variable.unit);
    let name = prime(&variable.name);
    let series = own
        .iter()
        .enumerate()
        .filter_map(|(k, p)| {
            let label = if own.len() > 1 { short(&p.record) } else { String::new() };
            Some(Series::line(label, Ink::Slot(k), &times(&p.against.get(index)?.values, factor), &p.force).drawn(Shape::Dots))
        })
        .collect();
    Plot {
        series,
        levels: vec![0.0],
        ..Plot::new(format!("against {name}"), format!("{name}{}", bracketed(&shown)), format!("on {equation}{}", bracketed(unit)))
    }
}

/// Parts into which the range of a variable is cut.
const PARTS: usize = 12;

/// The two variables of which the disturbance is most a function: the share of its square that the means over parts of the
/// variable's range hold.
fn telling(own: &[&Pushed]) -> Vec<usize> {
    let count = own.iter().map(|p| p.against.len()).min().unwrap_or(0);
    let mut shares: Vec<(f64, usize)> = (0..count)
        .filter_map(|i| {
            let pairs = || own.iter().flat_map(|p| p.against[i].values.iter().copied().zip(p.force.iter().copied()));
            let (lo, hi) =
                pairs().filter(|p| p.0.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), (v, _)| (lo.min(v), hi.max(v)));
            let mut parts = [(0.0_f64, 0.0_f64); PARTS];
            let mut total = 0.0;
            for (v, d) in pairs().filter(|p| p.0.is_finite() && p.1.is_finite()) {
                let part = &mut parts[(((v - lo) / (hi - lo) * PARTS as f64) as usize).min(PARTS - 1)];
                *part = (part.0 + d, part.1 + 1.0);
                total += d * d;
            }
            let held: f64 = parts.iter().filter(|p| p.1 > 0.0).map(|p| p.0 * p.0 / p.1).sum();
            (hi > lo && total > 0.0).then_some((held / total, i))
        })
        .collect();
    shares.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    shares.into_iter().take(2).map(|s| s.1).collect()
}

/// What: all candidates, the strongest first.
fn candidates(all: &[Candidate], blocks: &mut Vec<Block>) {
    if all.is_empty() {
        return;
    }
    let longest = all.iter().filter(|c| c.status != "not identifiable").map(|c| c.score).filter(|s| s.is_finite()).fold(0.0, f64::max);
    let row = |c: &Candidate| {
        let sizes: Vec<String> =
            c.minimal_detectable.iter().filter(|m| m.1.is_finite()).map(|(n, v, u)| format!("{n} {}", with_unit(brief(*v), u))).collect();
        let shape = c.shape.as_ref().map_or_else(String::new, |s| format!(" ({s})"));
        vec![
            Cell::Bar { share: c.score / longest, text: format!("{:.1}", c.score) },
            Cell::Number(c.class.to_string()),
            Cell::Text(format!("{} on {}{shape}", c.effect, c.place)),
            Cell::Text(c.status.clone()),
            Cell::Number(brief(c.p_value)),
            Cell::Number(format!("{:.0} %", 100.0 * c.unique_fraction)),
            Cell::Text(if sizes.is_empty() { "-".to_owned() } else { sizes.join(", ") }),
        ]
    };
    let head = || ["score [sigma]", "class", "effect", "", "p (family)", "its own", "smallest that shows"].map(str::to_owned).to_vec();
    let (seen, unseen): (Vec<&Candidate>, Vec<&Candidate>) = all.iter().partition(|c| c.status != "not identifiable");
    blocks.push(Block::Heading("What could be missing".to_owned()));
    blocks.push(Block::Text(format!(
        "{} candidates, {} of them could have been seen. Candidates of one class cannot be told apart; \"its own\" is the share of a candidate's signature that the fitted parameters cannot imitate.",
        all.len(),
        seen.len()
    )));
    let (first, rest) = seen.split_at(seen.len().min(FIRST));
    blocks.push(Block::Table(Table { caption: String::new(), head: head(), rows: first.iter().map(|c| row(c)).collect() }));
    for (title, list) in [("Weaker candidates", rest), ("Candidates that these records cannot show", &unseen[..])] {
        if !list.is_empty() {
            let table = Table { caption: String::new(), head: head(), rows: list.iter().map(|c| row(c)).collect() };
            blocks.push(Block::Fold { title: format!("{title} ({})", list.len()), blocks: vec![Block::Table(table)] });
        }
    }
}

/// The accepted effects and the text with them.
fn accepted(found: &Diagnosis, around: &Around<'_>, blocks: &mut Vec<Block>) {
    if found.findings.is_empty() {
        return;
    }
    blocks.push(Block::Heading("What was found".to_owned()));
    let mut rows = Vec::new();
    for f in &found.findings {
        let equivalent: Vec<String> = f.equivalent.iter().map(|(id, place)| format!("{id} on {place}")).collect();
        for v in &f.parameters {
            let of = v.record.as_ref().map_or_else(String::new, |r| format!(" ({})", short(r)));
            let ends = v.sd.is_finite().then_some((v.value - 1.96 * v.sd, v.value + 1.96 * v.sd));
            rows.push(vec![
                Cell::Text(format!("{} on {}", f.effect, f.place)),
                Cell::Text(format!("{}{of}", v.name)),
                Cell::Number(format!("{} +- {}", brief(v.value), brief(v.sd))),
                Cell::Text(v.unit.clone()),
                Cell::Interval { value: v.value, ends, other: Some(0.0) },
                Cell::Number(format!("{} +- {}", brief(f.heldout_gain.0), brief(f.heldout_gain.1))),
                Cell::Text(if equivalent.is_empty() { "-".to_owned() } else { equivalent.join(", ") }),
            ]);
        }
    }
    let head = [
        "effect",
        "parameter",
        "value and std. error",
        "unit",
        "95 % interval, and 0",
        "gain on records not used [nats/sample]",
        "cannot be told from",
    ];
    blocks.push(Block::Table(Table { caption: String::new(), head: head.map(str::to_owned).to_vec(), rows }));
    blocks.extend(found.findings.iter().filter_map(|f| Some(Block::Text(format!("{} on {}: {}", f.effect, f.place, f.shape.as_ref()?)))));
    for (name, old, new) in &around.texts {
        blocks.push(Block::Difference { name: name.clone(), old: old.clone(), new: new.clone() });
    }
}

/// How much: figures of the rig as given, refitted and patched, and the runs.
fn figures(found: &Diagnosis, blocks: &mut Vec<Block>) {
    let patched = !found.findings.is_empty();
    let mut rows = Vec::new();
    for (role, before, published, after) in [
        ("training", &found.before.train, &found.published.train, &found.after.train),
        ("held out", &found.before.test, &found.published.test, &found.after.test),
    ] {
        for f in before {
            let same = |list: &[Figure]| list.iter().find(|o| o.record == f.record && o.signal == f.signal).cloned();
            let (given, then) = (same(published), same(after).filter(|_| patched));
            let unit = found.runs.iter().find(|r| r.record == f.record && r.signal == f.signal).map_or("", |r| r.unit.as_str());
            let (factor, unit) = shown(unit);
            let fit = |f: Option<&Figure>| f.map_or_else(|| Cell::Number("-".to_owned()), |f| percent(f.fit_percent));
            let rms = |f: Option<&Figure>| {
                Cell::Number(f.and_then(|f| f.rmse).map_or_else(|| "-".to_owned(), |e| format!("{} {unit}", brief(e * factor))))
            };
            rows.push(vec![
                Cell::Text(short(&f.record)),
                Cell::Text(role.to_owned()),
                Cell::Text(f.signal.clone()),
                fit(given.as_ref()),
                fit(Some(f)),
                fit(then.as_ref()),
                rms(Some(f)),
                rms(then.as_ref()),
                Cell::Text(f.horizon.map_or_else(|| "free run".to_owned(), |h| format!("{} s ahead", number(h)))),
            ]);
        }
    }
    if rows.is_empty() {
        return;
    }
    blocks.push(Block::Heading("How much".to_owned()));
    let head = ["record", "", "signal", "fit as given", "refitted", "with the effects", "rms refitted", "rms after", ""];
    blocks.push(Block::Table(Table { caption: String::new(), head: head.map(str::to_owned).to_vec(), rows }));
    if patched && !found.gap_shrink.is_empty() {
        let rows = found
            .gap_shrink
            .iter()
            .map(|(s, v)| vec![Cell::Text(s.clone()), Cell::Bar { share: *v, text: format!("{:.0} %", 100.0 * v) }])
            .collect();
        let caption = "The gap, as far as it stood above the noise, shrunk on records that were not used:".to_owned();
        blocks.push(Block::Table(Table { caption, head: Vec::new(), rows }));
    }
    if found.before.train.iter().chain(&found.before.test).any(|f| f.horizon.is_some()) {
        let text = "Figures are those of predictions where a free run says little; the runs below are free, and may drift off for no fault of the model.";
        blocks.push(Block::Text(text.to_owned()));
    }
    for held_out in [true, false] {
        let plots: Vec<Plot> = found
            .runs
            .iter()
            .filter(|r| r.held_out == held_out)
            .map(|r| {
                let (factor, unit) = shown(&r.unit);
                let title = format!("{}, {}", r.signal, short(&r.record));
                let label = format!("{}{}", r.signal, bracketed(&unit));
                match &r.after {
                    Some(after) => overlay(&title, &label, factor, &r.t, &r.measured, Some(&r.before), after),
                    None => {
                        let mut plot = overlay(&title, &label, factor, &r.t, &r.measured, None, &r.before);
                        plot.series.iter_mut().filter(|s| s.ink == Ink::Model).for_each(|s| "refitted".clone_into(&mut s.name));
                        plot
                    }
                }
            })
            .collect();
        if plots.is_empty() {
            continue;
        }
        if held_out {
            blocks.push(Block::Subheading("Free runs over records that were not used".to_owned()));
            blocks.push(Block::Plots(plots));
        } else {
            blocks.push(Block::Fold { title: "Free runs over the training records".to_owned(), blocks: vec![Block::Plots(plots)] });
        }
    }
}

fn moved(found: &Diagnosis, blocks: &mut Vec<Block>) {
    if found.findings.is_empty() || found.moved.is_empty() {
        return;
    }
    blocks.push(Block::Heading("Parameters before and after".to_owned()));
    let rows = found
        .moved
        .iter()
        .map(|m| {
            let reach = m.before.1.hypot(m.after.1);
            let far = (m.after.0 - m.before.0).abs() > 2.0 * reach;
            vec![
                Cell::Text(m.name.clone()),
                Cell::Number(format!("{} +- {}", number(m.before.0), brief(m.before.1))),
                Cell::Number(format!("{} +- {}", number(m.after.0), brief(m.after.1))),
                Cell::Text(m.unit.clone()),
                Cell::Interval {
                    value: m.after.0,
                    ends: Some((m.after.0 - 1.96 * m.after.1, m.after.0 + 1.96 * m.after.1)),
                    other: Some(m.before.0),
                },
                Cell::Text(if far { "had been absorbing what was missing".to_owned() } else { String::new() }),
            ]
        })
        .collect();
    let head = ["parameter", "before", "after", "unit", "after; stroke: before", ""];
    blocks.push(Block::Table(Table { caption: String::new(), head: head.map(str::to_owned).to_vec(), rows }));
}

fn control(around: &Around<'_>, blocks: &mut Vec<Block>) {
    let Some(change) = &around.control else { return };
    blocks.push(Block::Heading("What it means for a regulator".to_owned()));
    match change {
        Err(why) => blocks.push(Block::Text(format!("No regulator to compare: {why}"))),
        Ok(change) => {
            let at = change.trim.as_ref().map_or_else(String::new, |t| format!(" at the trim {t}"));
            blocks.push(Block::Text(format!("Linear-quadratic regulator with identity weights on all states and inputs{at}.")));
            let rows = [("before, of its own model", &change.before), ("after, of the patched model", &change.after)]
                .into_iter()
                .chain(change.old_gain.iter().map(|poles| ("the patched model with the regulator of before", poles)))
                .map(|(name, poles)| vec![Cell::Text(name.to_owned()), Cell::Text(poles_in_words(poles))])
                .collect();
            blocks.push(Block::Table(Table { caption: String::new(), head: ["", "poles [1/s]"].map(str::to_owned).to_vec(), rows }));
            let points = |name: &str, ink, shape, poles: &[nalgebra::Complex<f64>]| {
                let (x, y): (Vec<f64>, Vec<f64>) = poles.iter().map(|z| (z.re, z.im)).unzip();
                Series::line(name, ink, &x, &y).drawn(shape)
            };
            let series = vec![
                points("before", Ink::Before, Shape::Crosses, &change.before),
                points("after", Ink::Model, Shape::Rings, &change.after),
            ];
            blocks.push(Block::Plots(vec![Plot {
                series,
                equal: true,
                levels: vec![0.0],
                ..Plot::new("Poles", "Re s [1/s]", "Im s [1/s]")
            }]));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::telling;
    use diagnose::{Pushed, Traced};

    #[test]
    fn what_explains_it_comes_first() {
        let t: Vec<f64> = (0..400).map(|k| f64::from(k) * 0.05).collect();
        let trace = |name: &str, f: &dyn Fn(f64) -> f64| Traced {
            name: name.to_owned(),
            unit: String::new(),
            values: t.iter().map(|t| f(*t)).collect(),
        };
        let against =
            vec![trace("q", &|t| t.sin()), trace("q.dot", &|t| t.cos()), trace("still", &|_| 1.0), trace("u", &|t| (7.0 * t).sin())];
        let force = t.iter().map(|t| 0.3 * t.cos().signum()).collect();
        let pushed =
            Pushed { record: String::new(), equation: "q".to_owned(), unit: String::new(), sd: vec![0.1; t.len()], force, against, t };
        assert_eq!(telling(&[&pushed])[0], 1);
        assert!(!telling(&[&pushed]).contains(&2), "what is constant explains nothing");
    }
}
