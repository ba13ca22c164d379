//! `rig diagnose`: where simulation and record disagree, the missing effect, and the gap with it.

use crate::args::{Diagnose, Hold, Steps};
use crate::commands::linearize::source_name;
use crate::control_change::{self, Change};
use crate::failure::Failure;
use crate::load::{self, Loaded};
use crate::output::{Answer, number};
use crate::pages::{self, brief, diagnose::Around, short, with_unit};
use crate::write::{permitted, write};
use diagnose::effects::{Effect, read_own};
use diagnose::patch::Base;
use diagnose::{Diagnosis, Figures, Options, Step};
use ident::fit::{ParameterSpec, select};
use ident::record::{self, Record};
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};

pub fn run(args: &Diagnose) -> Result<Answer, Failure> {
    for name in ["index.html", "model.rs"] {
        args.out.as_ref().map_or(Ok(()), |out| permitted(&out.join(name), args.force))?;
    }
    let loaded = load::load(&args.rig)?;
    let read = |paths: &[PathBuf]| -> Result<Vec<Record>, Failure> {
        paths.iter().map(|p| record::read(p).map_err(|e| Failure::new("C0501", e.to_string()))).collect()
    };
    let (train, test) = (read(&args.data)?, read(&args.test)?);
    let mut specs = ParameterSpec::of_rig(&loaded.rig);
    let names = |list: &[String]| list.iter().map(|s| s.trim().to_owned()).collect::<Vec<_>>();
    let free = (!args.free.is_empty()).then(|| names(&args.free));
    select(&mut specs, free.as_deref(), &names(&args.fix)).map_err(|e| Failure::new("C0504", e.to_string()))?;
    let with_trim = !loaded.rig.trims.is_empty();
    let base = Base::new(loaded.rig, loaded.checked.sources);
    let own = args.catalogue.as_deref().map(own_effects).transpose()?.unwrap_or_default();
    let options = Options {
        seed: args.seed,
        only: names(&args.effects),
        own,
        hold: args.hold.into(),
        until: match args.steps {
            Steps::Preflight => Step::Preflight,
            Steps::Where => Step::Where,
            Steps::Screen => Step::Screen,
            Steps::Patch => Step::Patch,
        },
        traces: args.out.is_some(),
        next: true,
        progress: &|message| eprintln!("{message}"),
        ..Options::default()
    };
    let found = diagnose::diagnose(&base, &specs, &train, &test, &options).map_err(|e| Failure::new("C0701", e.to_string()))?;
    let mut text = words(&base.rig.name, &train, &test, &found);
    let mut document = document(&found);
    if let Some(out) = &args.out {
        let mut files = write_patched(out, &args.rig.file, &found, args.force)?;
        document["patched_model"] = json!(files.first().map(|f| f.display().to_string()));
        let control = match files.first().cloned() {
            Some(patched) => regenerate(args, &patched, out, with_trim, &mut files)?,
            None => None,
        };
        if let Some(Ok(change)) = &control {
            document["control"] = change.json();
        }
        let records: Vec<&Path> = args.data.iter().chain(&args.test).map(PathBuf::as_path).collect();
        let around =
            Around { rig: &base.rig.name, source: &args.rig.file, records: &records, options: asked(args), texts: texts(&found), control };
        let path = out.join("index.html");
        pages::write(&path, &pages::diagnose::page(&found, &around), args.force)?;
        document["report"] = json!(path.display().to_string());
        files.push(path);
        for file in &files {
            let _ = writeln!(text, "wrote      {}", file.display());
        }
    }
    Ok(Answer { text, json: document })
}

fn own_effects(path: &Path) -> Result<Vec<Effect>, Failure> {
    let text = std::fs::read_to_string(path).map_err(|e| Failure::new("C0702", format!("{}: {e}", path.display())))?;
    read_own(&text).map_err(|e| Failure::new("C0702", format!("{}: {e}", path.display())))
}

/// The model of the patched rig, written beside it, and what it means for a regulator where the rig has a trim.
fn regenerate(
    args: &Diagnose,
    patched: &Path,
    out: &Path,
    with_trim: bool,
    files: &mut Vec<PathBuf>,
) -> Result<Option<Result<Change, String>>, Failure> {
    let rig = &args.rig;
    let load = |path: &Path| load::load_path(path, rig.rig.as_deref(), &rig.set, rig.expand_lumps);
    let new = load(patched)?;
    let equations = load::equations(&new, codegen::Options::default())?;
    let path = out.join("model.rs");
    write(&path, &codegen::emit::rust(&equations, &source_name(patched)), args.force)?;
    files.push(path);
    let change = |new: &Loaded| control_change::change(&load(&rig.file)?, new);
    Ok(with_trim.then(|| change(&new).map_err(|failure| failure.text)))
}

/// Texts that differ from those that were read.
fn texts(found: &Diagnosis) -> Vec<(String, String, String)> {
    let read = found.patched.iter().filter_map(|(file, new)| Some((short_file(file), std::fs::read_to_string(file).ok()?, new.clone())));
    read.filter(|(_, old, new)| old != new).collect()
}

/// What was asked for, as the report says it.
fn asked(args: &Diagnose) -> Vec<(String, String)> {
    let named = |list: &[PathBuf]| list.iter().map(|p| p.display().to_string()).collect::<Vec<_>>().join(", ");
    let hold = if matches!(args.hold, Hold::Zero) { "zero" } else { "first" };
    let all = [
        ("training records", named(&args.data)),
        ("test records", named(&args.test)),
        ("seed", args.seed.to_string()),
        ("hold of inputs", hold.to_owned()),
        ("set", args.rig.set.join(", ")),
        ("free", args.free.join(", ")),
        ("fix", args.fix.join(", ")),
        ("effects", args.effects.join(", ")),
        ("catalogue", args.catalogue.as_ref().map_or_else(String::new, |c| c.display().to_string())),
    ];
    all.into_iter().filter(|(_, text)| !text.is_empty()).map(|(name, text)| (name.to_owned(), text)).collect()
}

/// Writes the patched rig and the files that it uses, side by side.
fn write_patched(out: &Path, rig: &Path, found: &Diagnosis, force: bool) -> Result<Vec<PathBuf>, Failure> {
    let mut written = Vec::new();
    let name = short_file;
    for (k, (file, text)) in found.patched.iter().enumerate() {
        let stem = rig.file_stem().map_or_else(|| "rig".to_owned(), |s| s.to_string_lossy().into_owned());
        let target = out.join(if k == 0 { format!("{stem}.patched.rig") } else { name(file) });
        // files that are used stand beside it now
        let mut own = String::new();
        for line in text.lines() {
            match line.trim_start().strip_prefix("use \"").and_then(|rest| rest.split_once('"')) {
                Some((used, tail)) => {
                    let _ = writeln!(own, "use \"{}\"{tail}", name(used));
                }
                None => {
                    let _ = writeln!(own, "{line}");
                }
            }
        }
        let marked = format!("// {}{}` by rig diagnose.\n{own}", crate::write::MARK, name(file));
        write(&target, &marked, force)?;
        written.push(target);
    }
    Ok(written)
}

/// A file's name without its folder.
fn short_file(file: &str) -> String {
    Path::new(file).file_name().map_or_else(|| file.to_owned(), |n| n.to_string_lossy().into_owned())
}

fn percent(figures: &[diagnose::Figure]) -> String {
    let mut records: Vec<&str> = Vec::new();
    for f in figures {
        if !records.contains(&f.record.as_str()) {
            records.push(&f.record);
        }
    }
    let of = |record: &str| {
        figures
            .iter()
            .filter(|f| f.record == record)
            .map(|f| format!("{} {}", f.signal, f.fit_percent.map_or_else(|| "-".to_owned(), |p| format!("{p:.1} %"))))
            .collect::<Vec<_>>()
            .join("  ")
    };
    records
        .into_iter()
        .map(|r| {
            let horizon = figures.iter().find(|f| f.record == r).and_then(|f| f.horizon);
            format!("{}: {}{}", short(r), of(r), horizon.map_or_else(String::new, |h| format!("  ({} s ahead)", number(h))))
        })
        .collect::<Vec<_>>()
        .join("\n             ")
}

fn block(text: &mut String, title: &str, figures: &Figures) {
    if figures.train.is_empty() && figures.test.is_empty() {
        return;
    }
    let _ = writeln!(text, "{title:10} {}", percent(&figures.train));
    if !figures.test.is_empty() {
        let _ = writeln!(text, "  held out {}", percent(&figures.test));
    }
}

fn words(rig: &str, train: &[Record], test: &[Record], found: &Diagnosis) -> String {
    let mut text = format!("{rig}\n");
    let samples: usize = train.iter().map(|r| r.t.len()).sum();
    let _ = writeln!(text, "records    {} to learn from ({samples} samples), {} to judge on", train.len(), test.len());
    for fault in &found.faults {
        let _ = writeln!(text, "fault      {fault}");
    }
    block(&mut text, "as given", &found.published);
    block(&mut text, "refitted", &found.before);
    for (k, place) in found.places.iter().enumerate() {
        let _ = writeln!(text, "{:10} {}", if k == 0 { "where" } else { "" }, place.sentence);
    }
    if !found.candidates.is_empty() {
        let could = found.candidates.iter().filter(|c| c.status != "not identifiable").count();
        let _ = writeln!(text, "\n{} candidates, {could} of them could have been seen; the strongest:", found.candidates.len());
        for c in found.candidates.iter().filter(|c| c.status != "not identifiable").take(6) {
            let sizes: Vec<String> = c.minimal_detectable.iter().map(|(n, v, u)| format!("{n} {}", with_unit(told(*v), u))).collect();
            let sizes = if sizes.is_empty() { String::new() } else { format!("   smallest that shows: {}", sizes.join(", ")) };
            let shape = c.shape.as_ref().map_or_else(String::new, |s| format!(" ({s})"));
            let _ =
                writeln!(text, "  {:5.1} sigma  class {:2}  {} on {}{shape}  [{}]{sizes}", c.score, c.class, c.effect, c.place, c.status);
        }
    }
    if !found.findings.is_empty() {
        let _ = writeln!(text);
    }
    for (k, f) in found.findings.iter().enumerate() {
        let values: Vec<String> = f
            .parameters
            .iter()
            .map(|v| {
                let of = v.record.as_ref().map_or_else(String::new, |r| format!(" ({})", short(r)));
                format!("{} = {} +- {}{of}", v.name, told(v.value), with_unit(told(v.sd), &v.unit))
            })
            .collect();
        let day = if f.per_record { ", of the day" } else { "" };
        let _ = writeln!(
            text,
            "  {}  {} on {}{day}   {}   gain on records not used {} +- {} nats/sample",
            k + 1,
            f.effect,
            f.place,
            values.join(", "),
            told(f.heldout_gain.0),
            told(f.heldout_gain.1)
        );
        if let Some(shape) = &f.shape {
            let _ = writeln!(text, "     {shape}");
        }
        if !f.equivalent.is_empty() {
            let list: Vec<String> = f.equivalent.iter().map(|(id, place)| format!("{id} on {place}")).collect();
            let _ = writeln!(text, "     cannot be told from here: {}", list.join(", "));
        }
    }
    if !found.findings.is_empty() {
        let _ = writeln!(text);
        block(&mut text, "after", &found.after);
        let list: Vec<String> = found.gap_shrink.iter().map(|(s, v)| format!("{s} {:.0} %", 100.0 * v)).collect();
        let list = if list.is_empty() {
            "by what cannot be told: it was no larger than random forces make it".to_owned()
        } else {
            list.join(", ")
        };
        let _ = writeln!(text, "gap shrunk {list} (on records not used)");
        for m in &found.moved {
            let reach = (m.before.1.powi(2) + m.after.1.powi(2)).sqrt();
            if (m.after.0 - m.before.0).abs() > 2.0 * reach {
                let _ = writeln!(
                    text,
                    "moved      {} from {} to {}: it had been absorbing what was missing",
                    m.name,
                    told(m.before.0),
                    with_unit(told(m.after.0), &m.unit)
                );
            }
        }
    }
    let _ = writeln!(text, "\nverdict    {}: {}", found.verdict.id().replace('_', " "), found.because);
    if let Some(next) = &found.next_experiment {
        let _ = writeln!(text, "next       {next}");
    }
    let _ = writeln!(text, "           {} s", number(found.seconds));
    text
}

/// A number as the page has it.
fn told(value: f64) -> String {
    if value.is_finite() { brief(value) } else { "unknown".to_owned() }
}

fn document(found: &Diagnosis) -> Value {
    let each = |list: &[diagnose::Figure], f: &dyn Fn(&diagnose::Figure) -> Value| {
        let mut records: Map<String, Value> = Map::new();
        for figure in list {
            let entry = records.entry(figure.record.clone()).or_insert_with(|| json!({}));
            entry[&figure.signal] = f(figure);
        }
        Value::Object(records)
    };
    let figures = |f: &Figures| {
        json!({
            "fit_percent": {"train": each(&f.train, &|f| json!(f.fit_percent)), "test": each(&f.test, &|f| json!(f.fit_percent))},
            "rmse": {"train": each(&f.train, &|f| json!(f.rmse)), "test": each(&f.test, &|f| json!(f.rmse))},
            "horizon": {"train": each(&f.train, &|f| json!(f.horizon)), "test": each(&f.test, &|f| json!(f.horizon))},
        })
    };
    json!({
        "verdict": found.verdict.id(),
        "because": found.because,
        "faults": found.faults,
        "where": found.places.iter().map(|p| json!({
            "equation": p.equation, "sentence": p.sentence, "windows": p.windows.iter().map(|w| [w.0, w.1]).collect::<Vec<_>>(),
            "region": p.region, "rms": p.size, "unit": p.unit,
        })).collect::<Vec<_>>(),
        "effects": found.findings.iter().map(|f| json!({
            "effect": f.effect, "place": f.place, "shape": f.shape, "per_record": f.per_record,
            "parameters": f.parameters.iter().map(|v| json!({
                "name": v.name, "record": v.record, "value": v.value, "unit": v.unit,
                "ci95": [v.value - 1.96 * v.sd, v.value + 1.96 * v.sd],
            })).collect::<Vec<_>>(),
            "equivalent": f.equivalent.iter().map(|(effect, place)| json!({"effect": effect, "place": place})).collect::<Vec<_>>(),
            "p_value": f.p_value,
            "heldout_gain": f.heldout_gain.0,
            "heldout_gain_ci95": [f.heldout_gain.0 - f.heldout_gain.1, f.heldout_gain.0 + f.heldout_gain.1],
        })).collect::<Vec<_>>(),
        "published": figures(&found.published),
        "before": figures(&found.before),
        "after": figures(&found.after),
        "gap_shrink": found.gap_shrink.iter().map(|(s, v)| (s.clone(), json!(v))).collect::<Map<_, _>>(),
        "moved": found.moved.iter().map(|m| json!({"name": m.name, "unit": m.unit, "before": m.before.0, "before_sd": m.before.1, "after": m.after.0, "after_sd": m.after.1})).collect::<Vec<_>>(),
        "candidates": found.candidates.iter().map(|c| json!({
            "effect": c.effect, "place": c.place, "shape": c.shape, "score": c.score, "p_value": c.p_value, "unique_fraction": c.unique_fraction,
            "detectable_in_test": c.detectable_in_test,
            "minimal_detectable": c.minimal_detectable.iter().map(|(n, v, u)| json!({"name": n, "value": v, "unit": u})).collect::<Vec<_>>(),
            "class": c.class, "status": c.status,
        })).collect::<Vec<_>>(),
        "screening_p": found.screening_p,
        "next_experiment": found.next_experiment,
        "patched_model": Value::Null,
        "report": Value::Null,
        "control": Value::Null,
        "seconds": found.seconds,
    })
}
