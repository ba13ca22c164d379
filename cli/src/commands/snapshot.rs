//! `rig snapshot`: keeps what a rig comes to beside it, and shows what a change did.

use crate::args::Snapshot;
use crate::failure::Failure;
use crate::load;
use crate::output::Answer;
use crate::snapshot::{Change, changes, read, sections, write};
use codegen::Options;
use jit::InProcess;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;

pub fn run(args: &Snapshot) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::new(load::equations(&loaded, Options::default())?);
    let now = sections(&loaded, &model)?;
    let source = args.rig.file.file_name().map_or_else(|| "rig".to_owned(), |n| n.to_string_lossy().into_owned());
    let path = args.out.clone().unwrap_or_else(|| beside(&args.rig.file));
    let stands = std::fs::read_to_string(&path).ok();
    let found = stands.as_ref().map(|old| changes(&read(old), &now));
    let list = |all: &[Change]| -> Vec<Value> { all.iter().map(|c| json!({"section": c.section, "was": c.was, "is": c.is})).collect() };
    if !args.check {
        crate::write::write(&path, &write(&source, &now), args.force)?;
        let text = match &found {
            None => format!("wrote {}\n", path.display()),
            Some(all) if all.is_empty() => format!("{}: as it was\n", path.display()),
            Some(all) => format!("{}wrote {}\n", words(&source, all), path.display()),
        };
        return Ok(Answer { text, json: json!({"file": path, "changes": list(found.as_deref().unwrap_or_default())}) });
    }
    match found {
        None => Err(Failure::new("C0501", format!("there is no snapshot {}", path.display()))
            .with_help(&format!("make it: rig snapshot {}", args.rig.file.display()))),
        Some(all) if all.is_empty() => {
            Ok(Answer { text: format!("{source} is as its snapshot says\n"), json: json!({"file": path, "changes": []}) })
        }
        Some(all) => {
            let mut failure = Failure::new("C0502", format!("{source} is not as its snapshot {} says", path.display()))
                .with_help(&format!("if it is meant to be so: rig snapshot {}", args.rig.file.display()));
            failure.text = format!("{}{}", words(&source, &all), failure.text);
            failure.fields.push(("changes", list(&all).into()));
            Err(failure)
        }
    }
}

/// `googol.rig` has `googol.snapshot.txt` beside it.
fn beside(rig: &std::path::Path) -> PathBuf {
    rig.with_extension("snapshot.txt")
}

fn words(source: &str, all: &[Change]) -> String {
    let mut out = format!("{source}: {} {} since its snapshot\n", all.len(), if all.len() == 1 { "change" } else { "changes" });
    let mut section = "";
    for c in all {
        if c.section != section {
            section = &c.section;
            let _ = write!(out, "\n{section}\n");
        }
        if let ([was], [is]) = (c.was.as_slice(), c.is.as_slice())
            && let Some(line) = arrow(was, is)
        {
            let _ = writeln!(out, "  {line}");
            continue;
        }
        for (sign, line) in c.was.iter().map(|l| ('-', l)).chain(c.is.iter().map(|l| ('+', l))) {
            let _ = writeln!(out, "  {sign} {}", line.trim_start());
        }
    }
    out.push('\n');
    out
}

/// `eps'' by eps': -0.0512 -> -0.1313` where both lines name the same value.
fn arrow(was: &str, is: &str) -> Option<String> {
    [": ", " = "].iter().find_map(|mark| {
        let ((name, old), (other, new)) = (was.split_once(mark)?, is.split_once(mark)?);
        let plain = |s: &str| s.split_whitespace().next().is_some_and(|w| w.parse::<f64>().is_ok()) && !s.contains(',');
        (name == other && plain(old) && plain(new)).then(|| format!("{name}{mark}{old} -> {new}"))
    })
}
