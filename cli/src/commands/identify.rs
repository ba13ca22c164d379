//! `rig identify`: grey-box identification on one or several records, judged on others.

use super::{equation_error, innovations};
use crate::args::{Identify, Method};
use crate::failure::Failure;
use crate::load;
use crate::output::{Answer, number, prime};
use crate::pages;
use codegen::Options;
use ident::fit::{Estimate, Fit, FitOptions, InitialStates, Known, Loss, ParameterSpec, RecordFigures, SignalFigure, identify, select};
use ident::record::{self, Record};
use jit::InProcess;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};

pub fn run(args: &Identify) -> Result<Answer, Failure> {
    args.report.as_ref().map_or(Ok(()), |path| crate::write::permitted(path, args.force))?;
    let loaded = load::load(&args.rig)?;
    let read = |paths: &[PathBuf]| -> Result<Vec<Record>, Failure> {
        paths.iter().map(|p| record::read(p).map_err(|e| Failure::new("C0501", e.to_string()))).collect()
    };
    let (records, tests) = (read(&args.data)?, read(&args.test)?);
    let failed = |e: ident::fit::FitError| Failure::new("C0504", e.to_string());
    let mut specs = ParameterSpec::of_rig(&loaded.rig);
    let names = |list: &[String]| list.iter().map(|s| s.trim().to_owned()).collect::<Vec<_>>();
    let free = (!args.free.is_empty()).then(|| names(&args.free));
    select(&mut specs, free.as_deref(), &names(&args.fix)).map_err(failed)?;
    if args.method == Method::Innovations {
        return innovations::run(args, loaded, &specs, (&records, &tests));
    }
    let model = InProcess::at_work(load::equations(&loaded, Options::default())?);
    if matches!(args.method, Method::EquationError | Method::Channels) {
        return equation_error::run(args, &loaded.rig.name, &model, &specs, (&records, &tests));
    }
    let initial = args.rates.map(|rates| InitialStates { coordinates: Known::Prior, rates: rates.into() });
    let options = FitOptions {
        weights: args.weights.into(),
        loss: if args.robust { Loss::Huber(1.345) } else { Loss::Squares },
        initial,
        hold: args.hold.into(),
        shooting: args.windows.or(args.shooting),
        joined: args.windows.is_none(),
        horizon: args.horizon,
        ..FitOptions::default()
    };
    eprintln!("fitting {} parameters to {} records ..", specs.iter().filter(|s| s.free).count(), records.len());
    let fit = identify(&model, &specs, &records, &tests, &options).map_err(failed)?;
    let mut answer = Answer { text: words(&loaded.rig.name, &fit, &[]), json: document(&loaded.rig.name, &fit) };
    report(args, &mut answer, || page(args, &loaded.rig.name, &model, &fit, &[], (&records, &tests)))?;
    Ok(answer)
}

/// Writes the page that was asked for.
pub(super) fn report(args: &Identify, answer: &mut Answer, page: impl FnOnce() -> report::Page) -> Result<(), Failure> {
    answer.json["report"] = json!(args.report.as_ref().map(|p| p.display().to_string()));
    if let Some(path) = &args.report {
        pages::write(path, &page(), args.force)?;
        let _ = writeln!(answer.text, "wrote {}", path.display());
    }
    Ok(())
}

/// The page of a fit; `more` are further facts.
pub(super) fn page(
    args: &Identify,
    rig: &str,
    model: &InProcess,
    fit: &Fit,
    more: &[(String, String)],
    (records, tests): (&[Record], &[Record]),
) -> report::Page {
    let nominal = &model.equations().layout.nominal;
    let hold = args.hold.into();
    let states: Vec<&str> = model.equations().layout.x().map(|v| v.name.as_str()).collect();
    let mut runs = Vec::new();
    for (record, p) in records.iter().zip(&fit.p_of_record) {
        let own = fit.initial_states.iter().filter(|s| s.record == record.source);
        let initial: Vec<(usize, f64)> = own.filter_map(|s| Some((states.iter().position(|n| *n == s.state)?, s.value))).collect();
        runs.extend(pages::identify::lay(model, (nominal, p), record, &initial, hold, false));
    }
    runs.extend(tests.iter().filter_map(|record| pages::identify::lay(model, (nominal, &fit.p), record, &[], hold, true)));
    let facts = [
        ("ended", format!("{}, {} evaluations, from the {} start", fit.ending, fit.evaluations, fit.started_from)),
        ("minimized", fit.objective.clone()),
        ("cost", number(fit.cost)),
        ("intervals", fit.intervals.clone()),
        ("told", format!("{} of {} directions", fit.identifiable.rank, fit.identifiable.of)),
    ];
    let found = pages::identify::Identified {
        rig,
        facts: facts.map(|(n, t)| (n.to_owned(), t)).into_iter().chain(more.iter().cloned()).collect(),
        warnings: warnings(fit),
        parameters: &fit.parameters,
        correlation: Some(&fit.correlation),
        train: (&fit.before, &fit.train),
        test: (&fit.before_test, &fit.test),
        runs,
    };
    pages::identify::page(&found, &args.rig.file, &paths(args), Some(format!("{} s", number(fit.seconds))))
}

/// Files of the records.
pub(super) fn paths(args: &Identify) -> Vec<&Path> {
    args.data.iter().chain(&args.test).map(PathBuf::as_path).collect()
}

/// What a reader should not miss.
fn warnings(fit: &Fit) -> Vec<String> {
    let mut list = Vec::new();
    let told = &fit.identifiable;
    if !told.dead.is_empty() {
        list.push(format!("without effect on the records: {}", told.dead.join(", ")));
    }
    for t in &told.trade_offs {
        let members: Vec<String> = t.members.iter().map(|(n, w)| format!("{} {n}", number(*w))).collect();
        list.push(format!("only {} is told: along {} nothing changes", t.name, members.join(", ")));
    }
    let bound: Vec<&str> = fit.parameters.iter().filter(|e| e.at_bound).map(|e| e.name.as_str()).collect();
    if !bound.is_empty() {
        list.push(format!("at a bound: {}", bound.join(", ")));
    }
    let mut coloured: Vec<&str> = fit.whiteness.iter().filter(|w| w.p_value < 0.01).map(|w| w.output.as_str()).collect();
    coloured.dedup();
    if !coloured.is_empty() {
        list.push(format!("errors are not white in {}: the model does not explain all of them", coloured.join(", ")));
    }
    list
}

/// The answer as text; `more` are lines below the parameters.
pub(super) fn words(rig: &str, fit: &Fit, more: &[String]) -> String {
    let mut text = format!(
        "{rig}: {}, {} evaluations in {} s, from the {} start\n",
        fit.ending,
        fit.evaluations,
        number(fit.seconds),
        fit.started_from
    );
    let _ = writeln!(text, "minimized: {}; {} = cost\n", fit.objective, number(fit.cost));
    estimates(&mut text, &fit.parameters);
    let _ = writeln!(text, "  intervals: {}", fit.intervals);
    more.iter().for_each(|line| text.push_str(&format!("  {line}\n")));
    for s in fit.initial_states.iter().filter(|s| s.free) {
        let prior = s.prior.map_or_else(String::new, |(mean, sd)| format!("   (first samples: {} +- {})", number(mean), number(sd)));
        let _ = writeln!(text, "  {} at the start of {}: {}{prior}", prime(&s.state), s.record, number(s.value));
    }
    let told = &fit.identifiable;
    let _ = writeln!(text, "\nthe records tell {} of {} directions", told.rank, told.of);
    if !told.dead.is_empty() {
        let _ = writeln!(text, "  without effect on them: {}", told.dead.join(", "));
    }
    for t in &told.trade_offs {
        let members: Vec<String> = t.members.iter().map(|(n, w)| format!("{} {n}", number(*w))).collect();
        let _ = writeln!(text, "  only {} is told: along {} nothing changes", t.name, members.join(", "));
    }
    for (what, before, after) in [("training", &fit.before, &fit.train), ("held out", &fit.before_test, &fit.test)] {
        followed(&mut text, what, before, after);
    }
    let coloured: Vec<String> = fit.whiteness.iter().filter(|w| w.p_value < 0.01).map(|w| w.output.clone()).collect();
    if !coloured.is_empty() {
        let _ = writeln!(text, "errors are not white in {}: the model does not explain all of them", coloured.join(", "));
    }
    text
}

/// The table of parameters.
pub(super) fn estimates(text: &mut String, parameters: &[Estimate]) {
    let width = parameters.iter().map(|e| e.name.chars().count()).max().unwrap_or(0).max(9);
    let _ =
        writeln!(text, "  {:width$}  {:>12}  {:>12}  {:>27}  {:>12}", "parameter", "value", "std. error", "95 % interval", "started at");
    for e in parameters {
        let name = e.record.as_ref().map_or_else(|| e.name.clone(), |r| format!("{} ({r})", e.name));
        let sd = e.std_error.map_or_else(|| "not told".to_owned(), number);
        let interval = e.ci95.map_or_else(|| "-".to_owned(), |(lo, hi)| format!("{} .. {}", number(lo), number(hi)));
        let bound = if e.at_bound { "  at its bound" } else { "" };
        let _ = writeln!(
            text,
            "  {name:width$}  {:>12}  {sd:>12}  {interval:>27}  {:>12}  {}{bound}",
            number(e.value),
            number(e.initial),
            e.unit
        );
    }
}

/// How the model follows records, with the figures of the starting values in brackets.
pub(super) fn followed(text: &mut String, what: &str, before: &[RecordFigures], after: &[RecordFigures]) {
    for (k, figures) in after.iter().enumerate() {
        let percent = |fit: Option<f64>| fit.map_or_else(|| "constant".to_owned(), |f| format!("{f:.1} %"));
        let cells: Vec<String> = figures
            .signals
            .iter()
            .map(|s| {
                let was = before.get(k).and_then(|b| b.signals.iter().find(|b| b.signal == s.signal));
                let was = was.map_or_else(String::new, |b| format!(" (was {})", percent(b.fit_percent)));
                let hold = s.hold.map_or_else(String::new, |h| format!(", held rates {h:.1} %"));
                format!("{} {}{was}{hold}", s.signal, percent(s.fit_percent))
            })
            .collect();
        let ahead = figures.horizon.map_or_else(String::new, |h| format!(" {} s ahead", number(h)));
        let end = if figures.status == sim::Status::Completed || figures.horizon.is_some() {
            String::new()
        } else {
            format!("   up to {} s: {}", number(figures.valid_until), figures.status)
        };
        let _ = writeln!(text, "{what:9} {}{ahead}: {}{end}", figures.record, cells.join("; "));
    }
}

/// A figure of every signal of every record.
pub(super) fn each(list: &[RecordFigures], of: &dyn Fn(&SignalFigure) -> Value) -> Map<String, Value> {
    list.iter().map(|r| (r.record.clone(), Value::Object(r.signals.iter().map(|s| (s.signal.clone(), of(s))).collect()))).collect()
}

/// Seconds ahead of the figures of each record; null for free runs.
pub(super) fn horizons(lists: [&[RecordFigures]; 2]) -> Map<String, Value> {
    lists.into_iter().flatten().map(|r| (r.record.clone(), json!(r.horizon))).collect()
}

pub(super) fn document(rig: &str, fit: &Fit) -> Value {
    let both = |f: &dyn Fn(&SignalFigure) -> Value| json!({"train": each(&fit.train, f), "test": each(&fit.test, f)});
    let told = &fit.identifiable;
    json!({
        "rig": rig,
        "parameters": fit.parameters.iter().map(|e| json!({
            "name": e.name, "record": e.record, "value": e.value, "unit": e.unit, "std_error": e.std_error,
            "ci95": e.ci95.map(|(lo, hi)| [lo, hi]), "initial": e.initial, "at_bound": e.at_bound,
        })).collect::<Vec<_>>(),
        "correlation": fit.correlation.row_iter().map(|r| r.iter().copied().collect::<Vec<f64>>()).collect::<Vec<_>>(),
        "initial_states": fit.initial_states.iter().map(|s| json!({"record": s.record, "state": s.state, "value": s.value, "free": s.free, "prior": s.prior.map(|(m, sd)| [m, sd])})).collect::<Vec<_>>(),
        "objective": fit.objective,
        "cost": fit.cost,
        "status": fit.ending.id(),
        "intervals": fit.intervals,
        "fit_percent": both(&|s| json!(s.fit_percent)),
        "fit_percent_before": json!({"train": each(&fit.before, &|s| json!(s.fit_percent)), "test": each(&fit.before_test, &|s| json!(s.fit_percent))}),
        "rmse": both(&|s| json!(s.rmse)),
        "horizon": horizons([&fit.train, &fit.test]),
        "hold": both(&|s| json!(s.hold)),
        "identifiable": {
            "rank": told.rank, "of": told.of, "dead": told.dead,
            "trade_offs": told.trade_offs.iter().map(|t| json!({"name": t.name, "members": t.members.iter().cloned().collect::<std::collections::BTreeMap<_, _>>(), "relative_sd": t.relative_sd})).collect::<Vec<_>>(),
        },
        "whiteness": fit.whiteness.iter().map(|w| json!({"record": w.record, "output": w.output, "ljung_box": w.ljung_box, "p_value": w.p_value})).collect::<Vec<_>>(),
        "started_from": fit.started_from,
        "evaluations": fit.evaluations,
        "seconds": fit.seconds,
    })
}
