//! `cargo xtask gen [--check]`: the checked-in models of `examples/rigs`, in Rust and C, and the list of their modules.
//!
//! Writes only what changed, removes files of rigs that are gone; with `--check` writes nothing and fails where
//! something is stale.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Runs the task.
pub fn run(arguments: &[String]) -> Result<String, String> {
    let check = match arguments {
        [] => false,
        [flag] if flag == "--check" => true,
        _ => return Err("usage: cargo xtask gen [--check]".to_owned()),
    };
    let root = crate::root();
    let wanted = models(&root)?;
    let stale = compare(&root, &wanted)?;
    if stale.is_empty() {
        return Ok(format!("{} generated files, all as their rigs say", wanted.len()));
    }
    let list: Vec<String> = stale.iter().map(|(path, why)| format!("{} ({why})", path.display())).collect();
    if check {
        return Err(format!("stale generated files; run `cargo xtask gen`:\n  {}", list.join("\n  ")));
    }
    for path in stale.keys() {
        let place = root.join(path);
        match wanted.get(path) {
            Some(text) => {
                if let Some(folder) = place.parent() {
                    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
                }
                std::fs::write(&place, text).map_err(|e| format!("{}: {e}", path.display()))?;
            }
            None => std::fs::remove_file(&place).map_err(|e| format!("{}: {e}", path.display()))?,
        }
    }
    Ok(format!("{} of {} generated files written or removed:\n  {}", list.len(), wanted.len(), list.join("\n  ")))
}

/// All generated files: path from the project's folder, and text.
fn models(root: &Path) -> Result<BTreeMap<PathBuf, String>, String> {
    let folder = root.join("examples/rigs");
    let entries = std::fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut rigs: Vec<PathBuf> = entries.flatten().map(|e| e.path()).filter(|p| p.extension().is_some_and(|x| x == "rig")).collect();
    rigs.sort();
    let mut files = BTreeMap::new();
    let mut modules = Vec::new();
    let mut calls = crate::named_calls::start();
    for path in rigs {
        let Some(stem) = path.file_stem().and_then(|s| s.to_str()) else {
            return Err(format!("{}: a module cannot have this name", path.display()));
        };
        if stem.starts_with(|c: char| c.is_ascii_digit()) || !stem.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_') {
            return Err(format!("{}: a module cannot have this name; use small letters, digits and `_`", path.display()));
        }
        let source = format!("{stem}.rig");
        let equations = derive(&path)?;
        let title = equations.layout.doc.lines().next().unwrap_or(stem).trim_end_matches('.').to_owned();
        files.insert(PathBuf::from(format!("generated/src/{stem}.rs")), codegen::emit::rust(&equations, &source));
        let c = codegen::emit::c(&equations, &source);
        files.insert(PathBuf::from("generated/c").join(&c.header_name), c.header);
        files.insert(PathBuf::from("generated/c").join(&c.source_name), c.source);
        crate::named_calls::write(&mut calls, stem, &equations);
        modules.push((stem.to_owned(), title, codegen::emit::rust_model_name(&equations)));
    }
    files.insert(PathBuf::from("generated/src/lib.rs"), library(&modules));
    files.insert(PathBuf::from("tests/src/named.rs"), crate::named_calls::finish(calls, modules.iter().map(|m| m.0.as_str())));
    Ok(files)
}

fn derive(path: &Path) -> Result<codegen::Equations, String> {
    let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
    let Some(rig) = checked.rig else {
        let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
        return Err(format!("{}:\n{}", path.display(), shown.join("\n")));
    };
    codegen::derive(&rig, codegen::Options::default()).map_err(|e| format!("{}: {e}", path.display()))
}

/// The crate's root: one module a rig.
fn library(modules: &[(String, String, String)]) -> String {
    let mut out = String::from(
        "//! Checked-in models of the example rigs, one module a rig.\n\
         //! Generated from `examples/rigs` by `cargo xtask gen`; edit the rigs, not these files.\n//!\n\
         //! Each module has structs with named fields, a function a quantity, and a unit struct with the rig's\n\
         //! name that implements `runtime::Model`. Without the feature `std` it needs `core` alone.\n\
         #![no_std]\n#![forbid(unsafe_code)]\n",
    );
    for (module, title, _) in modules {
        let _ = write!(out, "\n/// {title}.\npub mod {module};\n");
    }
    let _ = write!(
        out,
        "\n/// All models, by the names of their rigs' files.\npub const MODELS: [(&str, &dyn runtime::Model); {}] = [\n",
        modules.len()
    );
    for (module, _, model) in modules {
        let _ = writeln!(out, "    ({module:?}, &{module}::{model}),");
    }
    out.push_str("];\n");
    out
}

/// What is not as it should be, with the reason: files that are missing, that differ, or whose rig is gone.
fn compare(root: &Path, wanted: &BTreeMap<PathBuf, String>) -> Result<BTreeMap<PathBuf, &'static str>, String> {
    let mut stale = BTreeMap::new();
    for (path, text) in wanted {
        match std::fs::read_to_string(root.join(path)) {
            Ok(found) if found == *text => {}
            Ok(_) => drop(stale.insert(path.clone(), "differs")),
            Err(_) => drop(stale.insert(path.clone(), "missing")),
        }
    }
    for folder in ["generated/src", "generated/c"] {
        let Ok(entries) = std::fs::read_dir(root.join(folder)) else { continue };
        for entry in entries.flatten() {
            let path = PathBuf::from(folder).join(entry.file_name());
            if wanted.contains_key(&path) {
                continue;
            }
            let text = std::fs::read_to_string(entry.path()).unwrap_or_default();
            if !text.lines().take(8).any(|line| line.contains("Generated from `")) {
                return Err(format!("{}: not a generated file; this folder holds generated files only", path.display()));
            }
            stale.insert(path, "its rig is gone");
        }
    }
    Ok(stale)
}
