//! `rig new`: a first rig, from a record's header or from an example that the program carries with it.

use crate::args::New;
use crate::examples::{EXAMPLES, Example};
use crate::failure::Failure;
use crate::load;
use crate::output::Answer;
use ident::record;
use serde_json::json;
use std::fmt::Write as _;
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::{Path, PathBuf};

pub fn run(args: &New) -> Result<Answer, Failure> {
    match (&args.example, &args.name, &args.data) {
        (Some(Some(name)), ..) => example(name, args.out.as_deref()),
        (None, Some(name), Some(data)) => from_record(name, data, args),
        // the command line asks for name and record where no example is wanted
        _ => Ok(list()),
    }
}

fn list() -> Answer {
    let width = EXAMPLES.iter().map(|e| e.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for example in EXAMPLES {
        let _ = writeln!(text, "{:width$}  {}", example.name, example.about());
    }
    text.push_str("next: `rig new --example NAME` writes one of them into this folder\n");
    Answer { text, json: json!({"examples": EXAMPLES.map(|e| json!({"name": e.name, "about": e.about()}))}) }
}

/// An example, and beside it the files that it uses.
fn example(name: &str, out: Option<&Path>) -> Result<Answer, Failure> {
    let Some(example) = Example::find(name) else {
        let near = model_dsl::nearest(name, EXAMPLES.iter().map(|e| e.name)).map(|near| format!("did you mean `{near}`? "));
        return Err(Failure::new("C0103", format!("there is no example `{name}`"))
            .with_help(&format!("{}`rig new --example` lists them", near.unwrap_or_default())));
    };
    let path = out.map_or_else(|| PathBuf::from(example.file()), Path::to_path_buf);
    let mut files: Vec<(PathBuf, &str)> = example.bases().iter().map(|b| (path.with_file_name(b.file()), b.text)).collect();
    files.push((path.clone(), example.text));
    // a base that stands there as it is carried is used as it stands; everything is looked at before anything is written
    files.retain(|(file, text)| *file == path || std::fs::read(file).map_or(true, |old| old != text.as_bytes()));
    if let Some((taken, _)) = files.iter().find(|(file, _)| file.exists()) {
        return Err(stands_there(taken));
    }
    for (file, text) in &files {
        create(file, text)?;
    }
    let written: Vec<String> = files.iter().map(|(file, _)| file.display().to_string()).collect();
    let text = format!("wrote {}: {}\nnext: `rig show {}`\n", written.join(" and "), example.about(), path.display());
    Ok(Answer { text, json: json!({"example": example.name, "files": written}) })
}

fn from_record(name: &str, data: &Path, args: &New) -> Result<Answer, Failure> {
    let record = record::read(data).map_err(|e| Failure::new("C0501", e.to_string()))?;
    let inputs: Vec<String> = args.inputs.iter().map(|n| n.trim().to_owned()).collect();
    let text = ident::starter::starter(name, &record, &inputs).map_err(|e| Failure::new("C0611", e.to_string()))?;
    let path = args.out.clone().unwrap_or_else(|| PathBuf::from(format!("{}.rig", name.to_lowercase())));
    // what is written can be used at once, or is not written
    let checked = model_dsl::check_text(&path.display().to_string(), &text);
    if checked.rig.is_none() {
        return Err(Failure::new(
            "C0612",
            format!("names or units of {} do not make a rig:\n{}", data.display(), load::rendered(&checked, false)),
        )
        .with_help("rename the columns, or describe them in a .toml, with names of letters, digits and `_`"));
    }
    create(&path, &text)?;
    let todo = text.lines().filter(|l| l.contains("TODO")).count();
    let shown = path.display();
    Ok(Answer {
        text: format!(
            "wrote {shown}: {todo} lines are marked TODO\nnext: fill them in, then `rig check {shown}` and `rig preflight {shown} --data {}`\n",
            data.display()
        ),
        json: json!({"rig": name, "files": [shown.to_string()], "todo": todo}),
    })
}

fn create(path: &Path, text: &str) -> Result<(), Failure> {
    let refused = |e: std::io::Error| match e.kind() {
        std::io::ErrorKind::AlreadyExists => stands_there(path),
        _ => Failure::new("C0402", format!("cannot write {}: {e}", path.display())),
    };
    let mut file = OpenOptions::new().write(true).create_new(true).open(path).map_err(refused)?;
    file.write_all(text.as_bytes()).map_err(refused)
}

fn stands_there(path: &Path) -> Failure {
    Failure::new("C0401", format!("{} stands there already", path.display()))
        .with_help("`rig new` never overwrites: choose another name or folder with --out")
}
