//! `cargo xtask gallery [--check]`: docs/gallery.md and its pictures, from the example rigs.
//!
//! With `--check` writes nothing and fails where something is stale.

use codegen::{Lumps, Options};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Runs the task.
pub fn run(arguments: &[String]) -> Result<String, String> {
    let check = match arguments {
        [] => false,
        [flag] if flag == "--check" => true,
        _ => return Err("usage: cargo xtask gallery [--check]".to_owned()),
    };
    let root = crate::root();
    let wanted = pages(&root)?;
    let stale: Vec<&PathBuf> =
        wanted.iter().filter(|(path, text)| std::fs::read_to_string(root.join(path)).ok().as_ref() != Some(text)).map(|(p, _)| p).collect();
    let list = stale.iter().map(|p| p.display().to_string()).collect::<Vec<_>>().join("\n  ");
    if stale.is_empty() {
        return Ok(format!("{} files of the gallery, all as their rigs say", wanted.len()));
    }
    if check {
        return Err(format!("stale gallery; run `cargo xtask gallery`:\n  {list}"));
    }
    for path in &stale {
        let place = root.join(path);
        if let Some(folder) = place.parent() {
            std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        }
        std::fs::write(&place, &wanted[*path]).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    Ok(format!("{} of {} files of the gallery written:\n  {list}", stale.len(), wanted.len()))
}

/// The page and its pictures: path from the project's folder, and text.
fn pages(root: &Path) -> Result<BTreeMap<PathBuf, String>, String> {
    let folder = root.join("examples/rigs");
    let entries = std::fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut rigs: Vec<PathBuf> = entries.flatten().map(|e| e.path()).filter(|p| p.extension().is_some_and(|x| x == "rig")).collect();
    rigs.sort();
    let mut files = BTreeMap::new();
    let mut page = String::from(
        "# Gallery\n\nEvery rig of [examples/rigs](../examples/rigs) with its picture and its equations, written by `cargo xtask gallery`.\n\
         Pictures are those of `rig draw FILE`, equations those of `rig show FILE`. Blue: bodies, a disc at the centre of mass as\n\
         large as the cube root of the mass, and the uniform rods that have its moments of inertia; orange: joints with their\n\
         axes; green: forces; grey: frames' offsets.\n",
    );
    for path in rigs {
        let Some(stem) = path.file_stem().and_then(|s| s.to_str()) else { continue };
        let source = format!("{stem}.rig");
        let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
        let Some(rig) = checked.rig else { return Err(format!("{source} does not pass its checks: rig check examples/rigs/{source}")) };
        let equations = codegen::derive(&rig, Options::default()).map_err(|e| format!("{source}: {e}"))?;
        let mut doc = rig.doc.lines();
        let title = doc.next().unwrap_or(stem).trim_end_matches('.');
        let rest = doc.collect::<Vec<_>>().join("\n");
        let _ = write!(page, "\n## {title}\n\n[{source}](../examples/rigs/{source})\n\n");
        if !rest.trim().is_empty() {
            let _ = writeln!(page, "{}\n", rest.trim());
        }
        let pose = drawing::pose(&rig, Lumps::AsParameters, &drawing::sample(&rig));
        if !pose.links.is_empty() || !pose.masses.is_empty() {
            let _ = writeln!(page, "![{title}](gallery/{stem}.svg)\n");
            files.insert(PathBuf::from(format!("docs/gallery/{stem}.svg")), drawing::picture(&pose, title, &source));
        }
        let _ = writeln!(page, "```text\n{}\n```", codegen::display::text(&rig, &equations).trim_end());
    }
    files.insert(PathBuf::from("docs/gallery.md"), page);
    Ok(files)
}
