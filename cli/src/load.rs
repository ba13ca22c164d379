//! From a file on disk to a checked rig and its equations, with the command line's overrides.

use crate::args::File;
use crate::failure::Failure;
use codegen::{Equations, Lumps, Options};
use model_dsl::rig::Rig;
use model_dsl::{CheckOptions, Checked, FileLoader, Severity};
use serde_json::{Value, json};
use std::io::IsTerminal;
use std::path::Path;

/// A rig that passed its checks, with the parameter values to use.
pub struct Loaded {
    /// The rig; parameter values as overridden.
    pub rig: Rig,
    /// Warnings and notes stand here.
    pub checked: Checked,
    /// Lumps as parameters, or expanded.
    pub lumps: Lumps,
}

/// Reads and checks a rig; warnings go to standard error.
pub fn load(file: &File) -> Result<Loaded, Failure> {
    let loaded = load_path(&file.file, file.rig.as_deref(), &file.set, file.expand_lumps)?;
    Ok(loaded)
}

/// Reads and checks the rig of a path. Parameters in `set` that this rig lacks are an error.
pub fn load_path(path: &Path, name: Option<&str>, set: &[String], expand_lumps: bool) -> Result<Loaded, Failure> {
    let options = CheckOptions { rig: name.map(str::to_owned) };
    let mut checked = model_dsl::check(&path.display().to_string(), &FileLoader, &options);
    let color = std::io::stderr().is_terminal();
    let Some(mut rig) = checked.rig.take() else {
        return Err(Failure::from_check(&checked, color));
    };
    say(&checked, |severity| severity != Severity::Note);
    for assignment in set {
        override_parameter(&mut rig, assignment)?;
    }
    Ok(Loaded { rig, checked, lumps: if expand_lumps { Lumps::Expanded } else { Lumps::AsParameters } })
}

/// Findings of the chosen severities, to standard error. (Notes are for `rig check` alone.)
pub fn say(checked: &Checked, chosen: impl Fn(Severity) -> bool) {
    let color = std::io::stderr().is_terminal();
    let shown: Vec<String> = checked.diagnostics.iter().filter(|d| chosen(d.severity)).map(|d| d.render(&checked.sources, color)).collect();
    if !shown.is_empty() {
        eprintln!("{}", shown.join("\n\n"));
    }
}

/// Splits `name=value`.
pub fn assignment(text: &str) -> Result<(&str, &str), Failure> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => Ok((name.trim(), value.trim())),
        _ => Err(Failure::new("C0101", format!("`{text}` is no assignment")).with_help("write name=value, e.g. theta=5deg")),
    }
}

fn override_parameter(rig: &mut Rig, text: &str) -> Result<(), Failure> {
    let (name, value) = assignment(text)?;
    let Some(index) = rig.parameters.iter().position(|p| p.name == name) else {
        let names: Vec<&str> = rig.parameters.iter().map(|p| p.name.as_str()).collect();
        return Err(unknown("parameter", name, &names));
    };
    let unit = rig.parameters[index].unit.clone();
    rig.parameters[index].value = model_dsl::parse_value(value, &unit).map_err(|e| Failure::new("C0102", format!("--set {text}: {e}")))?;
    Ok(())
}

/// A name that the rig does not have, with the nearest one that it has.
pub fn unknown(what: &str, name: &str, names: &[&str]) -> Failure {
    let failure = Failure::new("C0103", format!("this rig has no {what} `{name}`"));
    match model_dsl::nearest(name, names.iter().copied()) {
        Some(near) => failure.with_help(&format!("did you mean `{near}`?")),
        None => failure.with_help(&format!("it has {}", names.join(", "))),
    }
}

/// Derives the equations.
pub fn equations(loaded: &Loaded, options: Options) -> Result<Equations, Failure> {
    let options = Options { lumps: loaded.lumps, ..options };
    codegen::derive(&loaded.rig, options).map_err(|e| Failure::new("C0201", e.to_string()))
}

/// Diagnostics as the terminal shows them.
pub fn rendered(checked: &Checked, color: bool) -> String {
    checked.diagnostics.iter().map(|d| d.render(&checked.sources, color)).collect::<Vec<_>>().join("\n\n")
}

/// Diagnostics as JSON.
pub fn diagnostics_json(checked: &Checked) -> Vec<Value> {
    checked
        .diagnostics
        .iter()
        .map(|d| {
            let place = d.place(&checked.sources);
            let severity = match d.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Note => "note",
            };
            json!({"code": d.code, "severity": severity, "message": d.message, "file": place.as_ref().map(|p| p.file.clone()),
                   "line": place.as_ref().map(|p| p.line), "column": place.as_ref().map(|p| p.column), "help": d.helps})
        })
        .collect()
}
