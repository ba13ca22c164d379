//! `rig closed-loop`.

use crate::args::ClosedLoop;
use crate::failure::Failure;
use crate::output::{Answer, number, prime, table};
use crate::pages::{self, closed_loop::Closed};
use crate::scenario::{Built, Machine, Scenario, Source, build};
use control::{Run, Status, Surroundings};
use nalgebra::DMatrix;
use serde_json::{Map, Value, json};
use std::fmt::Write;

pub fn run(args: &ClosedLoop) -> Result<Answer, Failure> {
    let scenario = Scenario::parse(Source::read(&args.scenario, &args.with)?)?;
    let plant = scenario.plant()?;
    let other = scenario.design()?;
    let design = other.as_ref().unwrap_or(&plant);
    let (bench, around) = scenario.bench(&plant)?;
    let settled = scenario.file.settled.as_ref().map(|v| scenario.seconds(v)).transpose()?;
    let mut built = build(&scenario, &plant, design)?;
    let run = control::run(&plant.model, plant.p(), &bench, &around, &mut built.tracking)
        .map_err(|e| Failure::new("C0602", format!("{}: {e}", args.scenario.display())))?;

    crate::write::write(&args.out, &record(&plant, &run, &around), args.force)?;
    let layout = plant.layout();
    let (status, sentence) = match &run.status {
        Status::Complete => ("complete", "complete".to_owned()),
        Status::Diverged { name } => ("diverged", format!("ended: `{name}` left all bounds, or its mass matrix became singular")),
        Status::Controller(why) => ("controller", format!("ended: the controller had no answer ({why})")),
    };
    let end = run.t.last().copied().unwrap_or(0.0);
    let rate = 1.0 / bench.period;
    let mut text = scenario.file.title.as_ref().map_or_else(String::new, |title| format!("{title}\n"));
    let _ = writeln!(
        text,
        "{}: {} s at {} Hz, {} samples; encoders {}, limits {}; {sentence}",
        plant.loaded.rig.name,
        number(end),
        number(rate),
        run.t.len(),
        if bench.encoders { "on" } else { "off" },
        if bench.limits { "on" } else { "off" },
    );
    if other.is_some() {
        let _ = writeln!(text, "controller designed for {}", design.loaded.rig.name);
    }
    text.push_str(&gain(&built));
    text.push_str(&errors(&plant, &run, settled));
    for (input, share) in layout.u.iter().zip(&run.saturated_percent) {
        let _ = writeln!(text, "{} at a limit in {share:.1} % of the samples", input.name);
    }
    let mut files = vec![args.out.display().to_string()];
    if let Some(path) = &args.report {
        let title = scenario.file.title.clone().unwrap_or_else(|| format!("{}: closed loop", plant.loaded.rig.name));
        let closed = Closed { title: &title, plant: &plant, built: &built, run: &run, bench: &bench, settled, ending: &sentence };
        let page = pages::closed_loop::page(&closed, &args.scenario);
        pages::write(path, &page, args.force)?;
        files.push(path.display().to_string());
    }
    let _ = writeln!(text, "wrote {}", files.join(", "));

    let tracked = |from: f64, which: fn((f64, f64)) -> f64| -> Value {
        let each = layout.outputs.iter().enumerate().filter_map(|(i, o)| Some((o.name.clone(), json!(which(run.errors(i, from)?)))));
        Value::Object(each.collect())
    };
    let rows = |m: &DMatrix<f64>| m.row_iter().map(|r| r.iter().copied().collect::<Vec<f64>>()).collect::<Vec<_>>();
    let mut json = json!({
        "rig": plant.loaded.rig.name,
        "design": design.loaded.rig.name,
        "status": status,
        "status_text": sentence,
        "valid_until": end,
        "samples": run.t.len(),
        "period": bench.period,
        "mean_abs_error": tracked(0.0, |e| e.0),
        "rms_error": tracked(0.0, |e| e.1),
        "saturated_percent": layout.u.iter().zip(&run.saturated_percent).map(|(u, s)| (u.name.clone(), json!(s))).collect::<Map<_, _>>(),
        "K": rows(&built.gain.k),
        "states": built.gain.states,
        "inputs": built.gain.inputs,
        "trim": built.found.json(&design.loaded, design.layout()),
        "final_state": run.x.last(),
        "files": files,
        "report": args.report.as_ref().map(|p| p.display().to_string()),
    });
    if let Some(from) = settled {
        json["settled"] = json!({"from": from, "mean_abs_error": tracked(from, |e| e.0), "rms_error": tracked(from, |e| e.1)});
    }
    Ok(Answer { text, json })
}

fn gain(built: &Built<'_>) -> String {
    let columns: Vec<String> = built.gain.states.iter().map(|s| prime(s)).collect();
    let rows: Vec<(String, Vec<f64>)> =
        built.gain.inputs.iter().cloned().zip(built.gain.k.row_iter().map(|r| r.iter().copied().collect())).collect();
    let from = built.designed.as_ref().map_or_else(|| "as given".to_owned(), |lqr| format!("Riccati residual {:.0e}", lqr.residual));
    format!("\nK ({from}):\n{}", table(&columns, &rows, usize::MAX))
}

/// Errors of the true outputs against their references.
fn errors(plant: &Machine, run: &Run, settled: Option<f64>) -> String {
    let outputs = &plant.layout().outputs;
    let width = outputs.iter().map(|o| o.name.chars().count()).max().unwrap_or(0).max(6);
    let mut text = format!("\n{:width$}  {:>12}  {:>12}", "error", "mean |e|", "rms");
    if let Some(from) = settled {
        let _ = write!(text, "  | from {} s: {:>12}  {:>12}", number(from), "mean |e|", "rms");
    }
    text.push('\n');
    let mut any = false;
    for (i, output) in outputs.iter().enumerate() {
        let Some((mean, rms)) = run.errors(i, 0.0) else { continue };
        any = true;
        let _ = write!(text, "{:width$}  {:>12}  {:>12}", output.name, number(mean), number(rms));
        if let Some(from) = settled {
            let pad = " ".repeat(format!("from {} s:", number(from)).chars().count());
            match run.errors(i, from) {
                Some((mean, rms)) => {
                    let _ = write!(text, "  | {pad} {:>12}  {:>12}", number(mean), number(rms));
                }
                None => {
                    let _ = write!(text, "  | {pad} {:>12}  {:>12}", "-", "-");
                }
            }
        }
        let _ = writeln!(text, "  {}", output.unit);
    }
    if any { text } else { "\nno output has a reference\n".to_owned() }
}

/// All signals as a record: inputs as applied, outputs as read, states, true outputs, references, estimated rates.
fn record(plant: &Machine, run: &Run, around: &Surroundings<'_>) -> String {
    let layout = plant.layout();
    let states: Vec<(usize, &str)> =
        layout.x().map(|v| v.name.as_str()).enumerate().filter(|(_, s)| !layout.outputs.iter().any(|o| o.name == *s)).collect();
    let referred: Vec<usize> = (0..layout.outputs.len()).filter(|&i| run.references.iter().any(|r| r[i].is_some())).collect();
    let estimated = !run.rates.is_empty();
    let mut head: Vec<String> = vec!["t".to_owned()];
    head.extend(layout.u.iter().map(|u| u.name.clone()));
    head.extend(layout.outputs.iter().map(|o| o.name.clone()));
    head.extend(states.iter().map(|s| s.1.to_owned()));
    head.extend(layout.outputs.iter().map(|o| format!("{}.true", o.name)));
    head.extend(referred.iter().flat_map(|&i| [".reference", ".dot.reference"].map(|end| format!("{}{end}", layout.outputs[i].name))));
    if estimated {
        head.extend(layout.outputs.iter().map(|o| format!("{}.dot.estimate", o.name)));
    }
    head.extend(around.disturbances.iter().map(|(i, _)| format!("{}.disturbance", layout.u[*i].name)));
    let mut csv = head.join(",");
    csv.push('\n');
    for k in 0..run.t.len() {
        let t = run.t[k];
        let _ = write!(csv, "{t}");
        let exogenous: Vec<f64> = around.exogenous.iter().map(|f| f(t)).collect();
        let disturbances: Vec<f64> = around.disturbances.iter().map(|(_, f)| f(t)).collect();
        let references: Vec<f64> =
            referred.iter().flat_map(|&i| run.references[k][i].map_or([f64::NAN; 2], |(value, rate)| [value, rate])).collect();
        let states: Vec<f64> = states.iter().map(|(i, _)| run.x[k][*i]).collect();
        let rates: &[f64] = if estimated { &run.rates[k] } else { &[] };
        for value in run.u[k]
            .iter()
            .chain(&exogenous)
            .chain(&run.read[k])
            .chain(&states)
            .chain(&run.y[k])
            .chain(&references)
            .chain(rates)
            .chain(&disturbances)
        {
            let _ = write!(csv, ",{value}");
        }
        csv.push('\n');
    }
    csv
}
