//! A rig is the same whether it comes from a text or from the tokens of a macro.

use model_dsl::{CheckOptions, FileLoader, Loader, check, check_tokens};
use std::path::{Path, PathBuf};

/// Files beside the one that is under test.
struct Folder(PathBuf);

impl Loader for Folder {
    fn load(&self, name: &str) -> Result<Vec<u8>, String> {
        FileLoader.load(&self.0.join(name).to_string_lossy())
    }
}

/// A rig's fields, without places and without comments (which a macro does not see).
fn shown(rig: &model_dsl::rig::Rig) -> String {
    let mut out = String::new();
    let mut skip = false;
    for line in format!("{rig:#?}").lines() {
        let line = line.trim();
        skip |= line == "span: Span {";
        if !skip && !line.starts_with("doc: ") {
            out.push_str(line);
            out.push('\n');
        }
        if skip && line.starts_with('}') {
            skip = false;
        }
    }
    out
}

#[test]
fn a_macro_gives_the_rig_of_the_text() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut seen = 0;
    for folder in ["examples/rigs", "tests/rigs/statements", "tests/rigs/pass"].map(|f| root.join(f)) {
        for entry in std::fs::read_dir(&folder).expect("the rigs").flatten() {
            if entry.path().extension().is_none_or(|x| x != "rig") {
                continue;
            }
            let Ok(text) = std::fs::read_to_string(entry.path()) else { continue };
            let name = entry.file_name().to_string_lossy().into_owned();
            let options = CheckOptions::default();
            let loader = Folder(folder.clone());
            let from_text = check(&name, &loader, &options);
            let from_text = from_text.rig.unwrap_or_else(|| panic!("{name}: {:?}", from_text.diagnostics));
            let (checked, _) = check_tokens("src/lib.rs", text.parse().expect("Rust's lexer takes it"), &loader, &options);
            let messages: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
            let from_tokens = checked.rig.unwrap_or_else(|| panic!("{name}:\n{}", messages.join("\n")));
            assert_eq!(shown(&from_tokens), shown(&from_text), "{name}");
            seen += 1;
        }
    }
    assert!(seen > 30);
}

#[test]
fn messages_are_those_of_the_text() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/rigs/fail");
    let mut same = 0;
    for entry in std::fs::read_dir(&folder).expect("the rigs").flatten() {
        let Ok(text) = std::fs::read_to_string(entry.path()) else { continue };
        let text = text.split("\n//~").next().unwrap_or("").to_owned() + "\n";
        // what Rust's lexer does not take never reaches a macro
        let Ok(stream) = text.parse() else { continue };
        let name = entry.file_name().to_string_lossy().into_owned();
        let from_text = model_dsl::check_text(&name, &text);
        let (from_tokens, origin) = check_tokens(&name, stream, &model_dsl::NoFiles, &CheckOptions::default());
        let said = |c: &model_dsl::Checked| {
            c.diagnostics.iter().map(|d| (d.code, d.message.clone(), d.place(&c.sources).map(|p| (p.line, p.column)))).collect::<Vec<_>>()
        };
        if name != "no_rig_in_the_file.rig" {
            assert_eq!(said(&from_tokens), said(&from_text), "{name}");
            assert!(from_tokens.diagnostics.iter().all(|d| origin.origin(d.labels[0].0).is_some()), "{name}: a place without tokens");
        }
        same += 1;
    }
    assert!(same > 80, "only {same} wrong rigs reach a macro");
}
