//! `rig preflight`: facts and faults of records.

use crate::args::Preflight;
use crate::failure::Failure;
use crate::load;
use crate::output::{Answer, number, prime};
use codegen::Options;
use ident::fit::ParameterSpec;
use ident::preflight::{Change, Facts, Fault, FaultKind, InputFacts, OutputFacts, inspect};
use ident::record;
use jit::InProcess;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::fmt::Write;

pub fn run(args: &Preflight) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::at_work(load::equations(&loaded, Options::default())?);
    let records =
        args.data.iter().map(|p| record::read(p).map_err(|e| Failure::new("C0501", e.to_string()))).collect::<Result<Vec<_>, _>>()?;
    let specs = ParameterSpec::of_rig(&loaded.rig);
    let ranges: Vec<_> = loaded.rig.coordinates.iter().filter_map(|c| Some((c.name.clone(), c.range?))).collect();
    let found = inspect(&model, &specs, &ranges, &records, args.hold.into()).map_err(|e| Failure::new("C0502", e.to_string()))?;
    let mut text = String::new();
    for facts in &found.records {
        if !text.is_empty() {
            text.push('\n');
        }
        let faults: Vec<&Fault> = found.faults.iter().filter(|f| f.record == facts.source).collect();
        text.push_str(&words(facts, faults.iter().any(|f| matches!(f.kind, FaultKind::Contradicts(_)))));
        for fault in &faults {
            let _ = writeln!(text, "  FAULT    {}\n           mend: {}", fault.sentence(), fault.mend());
        }
        if faults.is_empty() {
            text.push_str("  no faults\n");
        }
    }
    let json = json!({
        "rig": loaded.rig.name,
        "records": found.records.iter().map(document).collect::<Vec<_>>(),
        "faults": found.faults.iter().map(fault_document).collect::<Vec<_>>(),
    });
    Ok(Answer { text, json })
}

fn percent(share: f64) -> String {
    match share {
        s if s < 1e-5 => "0 %".to_owned(),
        s if s < 1e-3 => "below 0.1 %".to_owned(),
        s => format!("{} %", number((1000.0 * s).round() / 10.0)),
    }
}

/// Two significant digits.
fn short(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let unit = 10.0_f64.powf(x.abs().log10().floor() - 1.0);
    number((x / unit).round() * unit)
}

/// Angles in degrees: that is how people see them.
fn angle(x: f64, unit: &str) -> String {
    if unit == "rad" { format!("{:.1}", x.to_degrees()) } else { number((1e4 * x).round() / 1e4) }
}

fn shown(unit: &str) -> &str {
    if unit == "rad" { "deg" } else { unit }
}

/// `settled`: a fault says why the model does not explain the record.
fn words(f: &Facts, settled: bool) -> String {
    let mut text = format!(
        "{}: {} samples, {} s at {} Hz, jitter {}{}\n",
        f.source,
        f.timing.samples,
        number((1e3 * f.timing.duration).round() / 1e3),
        number((1e3 * f.timing.rate).round() / 1e3),
        percent(f.timing.jitter),
        match f.timing.gaps.len() {
            0 => String::new(),
            1 => ", 1 gap".to_owned(),
            n => format!(", {n} gaps"),
        }
    );
    for o in &f.outputs {
        text.push_str(&output_words(o));
    }
    for i in &f.inputs {
        text.push_str(&input_words(i));
    }
    for d in &f.delays {
        let _ = writeln!(
            text,
            "  {:10} reaches {}'' after {} ms (correlation {:.2})",
            d.input,
            d.coordinate,
            number((1e3 * d.seconds).round()),
            d.correlation
        );
    }
    if !f.missing.is_empty() {
        let _ = writeln!(text, "  not in the record: {}", f.missing.join(", "));
    }
    if !f.unused.is_empty() {
        let _ = writeln!(text, "  columns that the rig has no use for: {}", f.unused.join(", "));
    }
    if !f.unexplained.is_empty() {
        let parts: Vec<String> = f.unexplained.iter().map(|(n, e)| format!("{n}'' {}", part(*e))).collect();
        let _ = writeln!(text, "  the model leaves unexplained after a quick fit: {}", parts.join(", "));
        let worse: Vec<&str> = f.unexplained.iter().filter(|(_, e)| e.is_finite() && *e > 1.0).map(|(n, _)| n.as_str()).collect();
        if !worse.is_empty() && !settled {
            let _ = writeln!(
                text,
                "  (of {} it explains nothing: parameters far off, too little motion, or a fault that is not looked for)",
                worse.join(", ")
            );
        }
    }
    match &f.not_judged {
        Some(why) => {
            let _ = writeln!(
                text,
                "  signs, exchanges and units were not checked: {}",
                why.replace("starting values from equation error are not to be had: ", "")
            );
        }
        None if !f.untold.is_empty() => {
            let list: Vec<String> = f.untold.iter().map(possibility).collect();
            let _ = writeln!(text, "  this record cannot tell: {}", list.join(", "));
        }
        None => {}
    }
    text
}

/// A part of the accelerations in percent; a coordinate that does not move has none.
fn part(e: f64) -> String {
    if e.is_finite() { percent(e) } else { "(at rest)".to_owned() }
}

fn possibility(change: &Change) -> String {
    match change {
        Change::SignOfOutput(a) | Change::SignOfInput(a) => format!("the sign of {a}"),
        Change::SwapOutputs(a, b) | Change::SwapInputs(a, b) => format!("{a} from {b}"),
        other => other.claim(),
    }
}

fn output_words(o: &OutputFacts) -> String {
    let unit = shown(&o.unit);
    if o.constant {
        return format!("  {:10} {} {unit}, constant\n", o.name, angle(o.first, &o.unit));
    }
    let step = |q: f64| if o.unit == "rad" { format!("{:.0} counts a turn", TAU / q) } else { format!("steps of {} {unit}", number(q)) };
    let encoder = match (o.quantum_seen, o.quantum_declared) {
        (Some(seen), Some(declared)) if (seen / declared - 1.0).abs() <= 0.1 => format!("{} seen, as declared", step(seen)),
        (Some(seen), Some(declared)) => format!("{} seen, {} declared", step(seen), step(declared)),
        (Some(seen), None) => format!("{} seen", step(seen)),
        (None, Some(declared)) => format!("no steps seen, {} declared", step(declared)),
        (None, None) => "no steps seen".to_owned(),
    };
    format!(
        "  {:10} {} .. {} {unit}, speed {} .. {} {unit}/s, {} reversal{}, rest noise {} {unit}, {encoder}\n",
        o.name,
        angle(o.range.0, &o.unit),
        angle(o.range.1, &o.unit),
        angle(o.speed.0, &o.unit),
        angle(o.speed.1, &o.unit),
        o.reversals,
        if o.reversals == 1 { "" } else { "s" },
        short(if o.unit == "rad" { o.rest_noise.to_degrees() } else { o.rest_noise }),
    )
}

fn input_words(i: &InputFacts) -> String {
    let unit = &i.unit;
    if i.range.0 == i.range.1 {
        return format!("  {:10} {} {unit}, constant{}\n", prime(&i.name), number(i.range.0), if i.declared { " (declared)" } else { "" });
    }
    let limits = if i.limits.0.is_finite() || i.limits.1.is_finite() {
        format!(", {} at a limit of {} .. {}", percent(i.saturated), number(i.limits.0), number(i.limits.1))
    } else {
        String::new()
    };
    let levels = if i.levels <= 20 { format!(", {} levels", i.levels) } else { String::new() };
    format!(
        "  {:10} {} .. {} {unit}{levels}{limits}{}\n",
        prime(&i.name),
        number(i.range.0),
        number(i.range.1),
        if i.declared { " (declared)" } else { "" }
    )
}

fn finite(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { Value::Null }
}

fn document(f: &Facts) -> Value {
    json!({
        "record": f.source,
        "samples": f.timing.samples,
        "duration": f.timing.duration,
        "rate": f.timing.rate,
        "jitter": f.timing.jitter,
        "gaps": f.timing.gaps.iter().map(|g| json!({"after": g.after, "length": g.length})).collect::<Vec<_>>(),
        "outputs": f.outputs.iter().map(|o| json!({
            "name": o.name, "unit": o.unit, "first": o.first, "range": [o.range.0, o.range.1], "constant": o.constant,
            "quantum_seen": o.quantum_seen, "quantum_declared": o.quantum_declared, "speed": [o.speed.0, o.speed.1],
            "reversals": o.reversals, "rest_noise": o.rest_noise,
        })).collect::<Vec<_>>(),
        "inputs": f.inputs.iter().map(|i| json!({
            "name": i.name, "unit": i.unit, "range": [i.range.0, i.range.1], "limits": [finite(i.limits.0), finite(i.limits.1)],
            "saturated": i.saturated, "beyond": i.beyond, "levels": i.levels, "declared": i.declared,
        })).collect::<Vec<_>>(),
        "delays": f.delays.iter().map(|d| json!({"input": d.input, "coordinate": d.coordinate, "seconds": d.seconds, "correlation": d.correlation})).collect::<Vec<_>>(),
        "missing": f.missing,
        "unused": f.unused,
        "unexplained": f.unexplained.iter().map(|(n, e)| (n.clone(), finite(*e))).collect::<serde_json::Map<_, _>>(),
        "untold": f.untold.iter().map(change_document).collect::<Vec<_>>(),
        "not_judged": f.not_judged,
    })
}

fn change_document(change: &Change) -> Value {
    json!({"kind": change.id(), "channels": change.channels()})
}

fn fault_document(f: &Fault) -> Value {
    let mut value = json!({
        "record": f.record, "kind": f.id(), "channels": f.channels(), "sentence": f.sentence(), "mend": f.mend(),
    });
    if let FaultKind::Contradicts(s) = &f.kind {
        value["alternatives"] = s.alternatives.iter().map(change_document).collect();
        value["equation"] = json!(s.equation);
        value["unexplained"] = json!([s.unexplained.0, s.unexplained.1]);
        if let Change::Offset(_, by) = s.change {
            value["offset"] = json!(by);
        }
    }
    value
}
