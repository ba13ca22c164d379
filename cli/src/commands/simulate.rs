//! `rig simulate`.

use crate::args::Simulate;
use crate::failure::Failure;
use crate::load;
use crate::output::{Answer, number};
use crate::pages;
use crate::point::Given;
use codegen::Options;
use ident::record;
use jit::InProcess;
use serde_json::json;
use std::fmt::Write;

pub fn run(args: &Simulate) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::new(load::equations(&loaded, Options::default())?);
    let layout = &model.equations().layout;
    let given = Given::read(&loaded.rig, layout, &args.at)?;
    if let Some((direction, _)) = given.entries.iter().find(|(d, _)| d.states.is_empty()) {
        return Err(Failure::new("C0107", format!("`{}` is an input: its values come from the record", direction.name))
            .with_help("--at takes initial coordinates, rates and actuator states"));
    }
    let (x0, _) = given.vectors(layout);
    let record = record::read(&args.input).map_err(|e| Failure::new("C0501", e.to_string()))?;
    let signals = record::bind_signals(&record, &model, args.hold.into()).map_err(|e| Failure::new("C0502", e.to_string()))?;
    let options = sim::Options { encoders: args.encoders, ..sim::Options::default() };
    let run =
        sim::simulate(&model, &layout.nominal, &x0, &signals, &record.t, &options).map_err(|e| Failure::new("C0503", e.to_string()))?;

    // a record of its own: inputs and outputs by the rig's names, then the states that no output shows by name
    let states: Vec<(usize, &str)> =
        layout.x().map(|v| v.name.as_str()).enumerate().filter(|(_, s)| !layout.outputs.iter().any(|o| o.name == *s)).collect();
    let mut csv = String::from("t");
    for name in
        layout.u.iter().map(|v| v.name.as_str()).chain(layout.outputs.iter().map(|o| o.name.as_str())).chain(states.iter().map(|(_, s)| *s))
    {
        let _ = write!(csv, ",{name}");
    }
    csv.push('\n');
    for (k, t) in run.t.iter().enumerate() {
        let _ = write!(csv, "{t}");
        let (y, x) = (run.outputs(k), run.state(k));
        for value in signals.at(*t).iter().chain(y).chain(states.iter().map(|(i, _)| &x[*i])) {
            let _ = write!(csv, ",{value}");
        }
        csv.push('\n');
    }
    crate::write::write(&args.out, &csv, args.force)?;
    let last: Vec<f64> = run.t.len().checked_sub(1).map(|k| run.state(k).to_vec()).unwrap_or_default();
    let mut text = format!("{} over {}: {} samples, {}\n", loaded.rig.name, args.input.display(), run.t.len(), run.status);
    for (variable, value) in layout.x().zip(&last) {
        let _ = writeln!(text, "  {:14} {:>12} {}", crate::output::prime(&variable.name), number(*value), variable.unit);
    }
    let mut files = vec![args.out.display().to_string()];
    if let Some(path) = &args.report {
        let page = pages::runs::page(&loaded.rig.name, layout, &signals, &run, &args.rig.file, &args.input);
        pages::write(path, &page, args.force)?;
        files.push(path.display().to_string());
    }
    let _ = writeln!(text, "wrote {}", files.join(", "));
    let json = json!({
        "rig": loaded.rig.name,
        "samples": run.t.len(),
        "states": layout.x().map(|v| v.name.as_str()).collect::<Vec<_>>(),
        "final_state": last,
        "status": run.status.id(),
        "status_text": run.status.to_string(),
        "valid_until": run.valid_until,
        "steps": run.steps,
        "files": files,
        "report": args.report.as_ref().map(|p| p.display().to_string()),
    });
    Ok(Answer { text, json })
}
