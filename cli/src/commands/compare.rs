//! `rig compare`: free runs of several rigs over one record.

use crate::args::Compare;
use crate::failure::Failure;
use crate::load::{self, Loaded};
use crate::output::{Answer, number};
use crate::point::Given;
use codegen::Options;
use ident::compare::{CompareOptions, Comparison, Figure, compare};
use ident::record;
use jit::InProcess;
use runtime::Model;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;
use std::fmt::Write;

pub fn run(args: &Compare) -> Result<Answer, Failure> {
    let record = record::read(&args.data).map_err(|e| Failure::new("C0501", e.to_string()))?;
    let mut rigs: Vec<(String, Loaded)> = Vec::new();
    let mut taken: BTreeSet<&String> = BTreeSet::new();
    for file in &args.files {
        let loaded = load::load_path(file, None, &[], args.expand_lumps)?;
        let known = |text: &&String| load::assignment(text).is_ok_and(|(name, _)| loaded.rig.parameters.iter().any(|p| p.name == name));
        let own: Vec<String> = args.set.iter().filter(known).cloned().collect();
        taken.extend(args.set.iter().filter(known));
        let loaded = if own.is_empty() { loaded } else { load::load_path(file, None, &own, args.expand_lumps)? };
        rigs.push((file.display().to_string(), loaded));
    }
    if let Some(missed) = args.set.iter().find(|s| !taken.contains(s)) {
        let (name, _) = load::assignment(missed)?;
        let names: BTreeSet<&str> = rigs.iter().flat_map(|(_, l)| l.rig.parameters.iter().map(|p| p.name.as_str())).collect();
        return Err(load::unknown("parameter", name, &names.into_iter().collect::<Vec<_>>()));
    }
    let options = CompareOptions { hold: args.hold.into(), ..CompareOptions::default() };
    let mut runs = Vec::new();
    for (file, loaded) in &rigs {
        let model = InProcess::new(load::equations(loaded, Options::default())?);
        let layout = &model.equations().layout;
        let given = Given::read(&loaded.rig, layout, &args.at)?;
        let mut options = options.clone();
        options.initial = given.entries.iter().flat_map(|(d, value)| d.states.iter().map(move |(i, w)| (*i, w * value))).collect();
        let result = compare(&model, &layout.nominal, &record, &options).map_err(|e| Failure::new("C0502", e.to_string()))?;
        let states: Vec<String> = (0..model.dimensions().states()).map(|i| model.names().state(i).to_owned()).collect();
        runs.push((file.clone(), loaded.rig.name.clone(), result, states));
    }
    let rate = if record.period() > 0.0 { 1.0 / record.period() } else { 0.0 };
    let head = format!(
        "{}: {} samples, {} s at {} Hz; free run from the record's start\n",
        args.data.display(),
        record.t.len(),
        number(record.duration()),
        number(rate)
    );
    let json = json!({
        "record": args.data.display().to_string(),
        "rigs": runs.iter().map(|(file, name, run, states)| document(file, name, run, states)).collect::<Vec<_>>(),
    });
    Ok(Answer { text: head + &table(&runs), json })
}

fn document(file: &str, name: &str, run: &Comparison, states: &[String]) -> Value {
    let figures = run.figures();
    let each = |f: &dyn Fn(&Figure) -> Value| figures.iter().map(|s| (s.name.clone(), f(s))).collect::<Map<_, _>>();
    json!({
        "file": file,
        "rig": name,
        "fit_percent": each(&|s| json!(s.fit_percent)),
        "rmse": each(&|s| json!(s.rmse)),
        "status": run.status.id(),
        "status_text": run.status.to_string(),
        "valid_until": run.valid_until,
        "horizon": run.horizon(),
        "hold": each(&|s| json!(s.hold)),
        "initial_state": states.iter().cloned().zip(run.initial.iter().map(|x| json!(x))).collect::<Map<_, _>>(),
    })
}

/// Rows: rigs; columns: fit of each measured signal.
fn table(runs: &[(String, String, Comparison, Vec<String>)]) -> String {
    let mut signals: Vec<&str> = Vec::new();
    let figures: Vec<Vec<Figure>> = runs.iter().map(|r| r.2.figures()).collect();
    for figure in figures.iter().flatten() {
        if !signals.contains(&figure.name.as_str()) {
            signals.push(&figure.name);
        }
    }
    let width = runs.iter().map(|r| r.0.chars().count()).max().unwrap_or(0).max(3);
    let mut text = format!("{:width$}", "fit");
    for s in &signals {
        let _ = write!(text, "  {s:>10}");
    }
    text.push('\n');
    for ((file, _, run, _), figures) in runs.iter().zip(&figures) {
        let _ = write!(text, "{file:width$}");
        for name in &signals {
            let cell = match figures.iter().find(|s| s.name == *name).map(|s| s.fit_percent) {
                Some(Some(fit)) => format!("{fit:.1} %"),
                Some(None) => "constant".to_owned(),
                None => "-".to_owned(),
            };
            let _ = write!(text, "  {cell:>10}");
        }
        if let Some(h) = run.horizon() {
            let _ = write!(text, "   {} s ahead: the free run would only show how unstable the rig is", number(h));
        }
        if run.status != sim::Status::Completed {
            let _ = write!(text, "   up to {} s: {}", number(run.valid_until), run.status);
        }
        text.push('\n');
        if figures.iter().any(|s| s.hold.is_some()) {
            let _ = write!(text, "{:width$}", "  rates held constant");
            for name in &signals {
                let hold = figures.iter().find(|s| s.name == *name).and_then(|s| s.hold);
                let _ = write!(text, "  {:>10}", hold.map_or_else(|| "-".to_owned(), |h| format!("{h:.1} %")));
            }
            text.push('\n');
        }
    }
    text
}
