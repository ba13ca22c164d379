//! `rig new`: a first rig from a record's header.

use crate::args::New;
use crate::failure::Failure;
use crate::load;
use crate::output::Answer;
use ident::record;
use serde_json::json;
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::PathBuf;

pub fn run(args: &New) -> Result<Answer, Failure> {
    let record = record::read(&args.data).map_err(|e| Failure::new("C0501", e.to_string()))?;
    let inputs: Vec<String> = args.inputs.iter().map(|n| n.trim().to_owned()).collect();
    let text = ident::starter::starter(&args.name, &record, &inputs).map_err(|e| Failure::new("C0611", e.to_string()))?;
    let path = args.out.clone().unwrap_or_else(|| PathBuf::from(format!("{}.rig", args.name.to_lowercase())));
    // what is written can be used at once, or is not written
    let checked = model_dsl::check_text(&path.display().to_string(), &text);
    if checked.rig.is_none() {
        return Err(Failure::new(
            "C0612",
            format!("names or units of {} do not make a rig:\n{}", args.data.display(), load::rendered(&checked, false)),
        )
        .with_help("rename the columns, or describe them in a .toml, with names of letters, digits and `_`"));
    }
    let refused = |e: std::io::Error| match e.kind() {
        std::io::ErrorKind::AlreadyExists => Failure::new("C0401", format!("{} stands there already", path.display()))
            .with_help("`rig new` never overwrites: choose another name with --out"),
        _ => Failure::new("C0402", format!("cannot write {}: {e}", path.display())),
    };
    let mut file = OpenOptions::new().write(true).create_new(true).open(&path).map_err(refused)?;
    file.write_all(text.as_bytes()).map_err(refused)?;
    let todo = text.lines().filter(|l| l.contains("TODO")).count();
    let shown = path.display();
    Ok(Answer {
        text: format!(
            "wrote {shown}: {todo} lines are marked TODO\nnext: fill them in, then `rig check {shown}` and `rig preflight {shown} --data {}`\n",
            args.data.display()
        ),
        json: json!({"rig": args.name, "files": [shown.to_string()], "todo": todo}),
    })
}
