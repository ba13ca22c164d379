//! `rig identify`: grey-box identification on one or several records, judged on others.

use crate::args::Identify;
use crate::failure::Failure;
use crate::load;
use crate::output::{Answer, number, prime};
use codegen::Options;
use ident::fit::{Fit, FitOptions, InitialStates, Known, Loss, ParameterSpec, RecordFigures, identify, select};
use ident::record::{self, Record};
use jit::InProcess;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::PathBuf;

pub fn run(args: &Identify) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::new(load::equations(&loaded, Options::default())?);
    let read = |paths: &[PathBuf]| -> Result<Vec<Record>, Failure> {
        paths.iter().map(|p| record::read(p).map_err(|e| Failure::new("C0501", e.to_string()))).collect()
    };
    let (records, tests) = (read(&args.data)?, read(&args.test)?);
    let failed = |e: ident::fit::FitError| Failure::new("C0504", e.to_string());
    let mut specs = ParameterSpec::of_rig(&loaded.rig);
    let names = |list: &[String]| list.iter().map(|s| s.trim().to_owned()).collect::<Vec<_>>();
    let free = (!args.free.is_empty()).then(|| names(&args.free));
    select(&mut specs, free.as_deref(), &names(&args.fix)).map_err(failed)?;
    let initial = args.rates.map(|rates| InitialStates { coordinates: Known::Prior, rates: rates.into() });
    let options = FitOptions {
        weights: args.weights.into(),
        loss: if args.robust { Loss::Huber(1.345) } else { Loss::Squares },
        initial,
        hold: args.hold.into(),
        shooting: args.shooting,
        ..FitOptions::default()
    };
    eprintln!("fitting {} parameters to {} records ..", specs.iter().filter(|s| s.free).count(), records.len());
    let fit = identify(&model, &specs, &records, &tests, &options).map_err(failed)?;
    Ok(Answer { text: words(&loaded.rig.name, &fit), json: document(&loaded.rig.name, &fit) })
}

fn words(rig: &str, fit: &Fit) -> String {
    let mut text = format!(
        "{rig}: {}, {} evaluations in {} s, from the {} start\n",
        fit.ending,
        fit.evaluations,
        number(fit.seconds),
        fit.started_from
    );
    let _ = writeln!(text, "minimized: {}; {} = cost\n", fit.objective, number(fit.cost));
    let width = fit.parameters.iter().map(|e| e.name.chars().count()).max().unwrap_or(0).max(9);
    let _ =
        writeln!(text, "  {:width$}  {:>12}  {:>12}  {:>27}  {:>12}", "parameter", "value", "std. error", "95 % interval", "started at");
    for e in &fit.parameters {
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
    let _ = writeln!(text, "  intervals: {}", fit.intervals);
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
    for (what, list) in [("training", &fit.train), ("held out", &fit.test)] {
        for figures in list {
            let cells: Vec<String> = figures
                .signals
                .iter()
                .map(|s| format!("{} {}", s.signal, s.fit_percent.map_or_else(|| "constant".to_owned(), |f| format!("{f:.1} %"))))
                .collect();
            let end = if figures.status == sim::Status::Completed { String::new() } else { format!("   {}", figures.status) };
            let _ = writeln!(text, "{what:9} {}: {}{end}", figures.record, cells.join(", "));
        }
    }
    let coloured: Vec<String> = fit.whiteness.iter().filter(|w| w.p_value < 0.01).map(|w| w.output.clone()).collect();
    if !coloured.is_empty() {
        let _ = writeln!(text, "errors are not white in {}: the model does not explain all of them", coloured.join(", "));
    }
    text
}

fn document(rig: &str, fit: &Fit) -> Value {
    let each = |list: &[RecordFigures], f: &dyn Fn(&ident::fit::SignalFigure) -> Value| {
        list.iter()
            .map(|r| (r.record.clone(), Value::Object(r.signals.iter().map(|s| (s.signal.clone(), f(s))).collect())))
            .collect::<Map<_, _>>()
    };
    let both = |f: &dyn Fn(&ident::fit::SignalFigure) -> Value| json!({"train": each(&fit.train, f), "test": each(&fit.test, f)});
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
        "rmse": both(&|s| json!(s.rmse)),
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
