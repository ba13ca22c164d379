//! `rig generate`.

use crate::args::{Generate, Language};
use crate::failure::Failure;
use crate::load;
use crate::output::Answer;
use crate::scenario::{Scenario, Source, code};
use codegen::Options;
use codegen::emit::controller::{controller_c, controller_rust};
use serde_json::json;

pub fn run(args: &Generate) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let equations = load::equations(&loaded, Options::default())?;
    let source = args.rig.file.file_name().map_or_else(|| "rig".to_owned(), |n| n.to_string_lossy().into_owned());
    let stem = args.rig.file.file_stem().map_or_else(|| "rig".to_owned(), |n| n.to_string_lossy().into_owned());
    let mut files = match args.lang {
        Language::Rust => vec![(format!("{stem}.rs"), codegen::emit::rust(&equations, &source))],
        Language::C => {
            let c = codegen::emit::c(&equations, &source);
            vec![(c.header_name, c.header), (c.source_name, c.source)]
        }
    };
    if let Some(path) = &args.controller {
        let scenario = Scenario::parse(Source::read(path, &[])?)?;
        let controller = code(&scenario, path, &args.rig.file)?;
        match args.lang {
            Language::Rust => files.push((format!("{}.rs", controller.name), controller_rust(&controller))),
            Language::C => {
                let c = controller_c(&controller);
                files.extend([(c.header_name, c.header), (c.source_name, c.source)]);
            }
        }
    }
    let mut written = Vec::new();
    for (name, text) in files {
        let path = args.out.join(name);
        if args.check {
            match std::fs::read_to_string(&path) {
                Ok(old) if old == text => {}
                Ok(_) => return Err(stale(&path.display().to_string(), "is stale: the rig or this program has changed since", args)),
                Err(_) => return Err(stale(&path.display().to_string(), "is not there", args)),
            }
        } else {
            crate::write::write(&path, &text, args.force)?;
        }
        written.push(path.display().to_string());
    }
    let verb = if args.check { "up to date:" } else { "wrote" };
    let text = format!("{verb} {}   model {}\n", written.join(", "), &equations.hash[..8]);
    Ok(Answer { text, json: json!({"files": written, "hash": equations.hash}) })
}

fn stale(path: &str, what: &str, args: &Generate) -> Failure {
    let controller = args.controller.as_ref().map_or_else(String::new, |c| format!(" --controller {}", c.display()));
    Failure::new("C0403", format!("{path} {what}")).with_help(&format!(
        "rig generate {}{controller} --out {}",
        args.rig.file.display(),
        args.out.display()
    ))
}
