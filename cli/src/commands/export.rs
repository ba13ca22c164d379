//! `rig export`.

use crate::args::{Export, Target};
use crate::failure::Failure;
use crate::load;
use crate::output::Answer;
use codegen::Options;
use serde_json::json;
use std::path::PathBuf;

pub fn run(args: &Export) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let (text, ending) = match args.to {
        Target::Json => (format!("{:#}\n", codegen::emit::declared(&loaded.rig)), "json"),
        Target::Latex => (codegen::display::latex(&loaded.rig, &load::equations(&loaded, Options::default())?), "tex"),
        Target::Casadi => (codegen::emit::casadi(&load::equations(&loaded, Options::default())?), "py"),
    };
    let stem = args.rig.file.file_stem().map_or_else(|| "rig".to_owned(), |s| s.to_string_lossy().into_owned());
    let path = args.out.clone().unwrap_or_else(|| PathBuf::from(format!("{stem}.{ending}")));
    crate::write::write(&path, &text, args.force)?;
    let shown = path.display().to_string();
    Ok(Answer { text: format!("wrote {shown}\n"), json: json!({"files": [shown]}) })
}
