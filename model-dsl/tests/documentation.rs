//! The language reference is true: every example in `docs/language.md` is compiled, and `docs/errors.md` lists the
//! catalogue, each code with a message that a wrong rig gets (`RIG_BLESS=1` writes it anew). Every example rig passes.

use model_dsl::{CATALOGUE, CheckOptions, Checked, FileLoader, Loader, Severity, check_text};
use std::fmt::Write;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn shown(checked: &Checked) -> String {
    checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect::<Vec<_>>().join("\n\n")
}

/// Line, words behind the fence, and text of each block of code.
fn fences(text: &str) -> Vec<(usize, String, String)> {
    let mut out: Vec<(usize, String, String)> = Vec::new();
    let mut open = false;
    for (k, line) in text.lines().enumerate() {
        match (line.strip_prefix("```"), open) {
            (Some(words), false) => {
                out.push((k + 1, words.trim().to_owned(), String::new()));
                open = true;
            }
            (Some(_), true) => open = false,
            (None, true) => {
                let _ = writeln!(out.last_mut().expect("an open block").2, "{line}");
            }
            (None, false) => {}
        }
    }
    assert!(!open, "a block of code is never closed");
    out
}

#[test]
fn every_example_of_the_language_reference_compiles() {
    let text = std::fs::read_to_string(root().join("docs/language.md")).expect("the language reference");
    let fences = fences(&text);
    let context = &fences.iter().find(|f| f.1 == "rig context").expect("the context of the fragments").2;
    let mut seen = 0;
    for (line, words, code) in &fences {
        assert!(words == "rig" || words == "rig context", "docs/language.md:{line}: code that is not checked");
        let whole = code.lines().any(|l| l.starts_with("rig ") || l.starts_with("use "));
        let source = if whole { code.clone() } else { format!("{context}rig Fragment extends Bench {{\n{code}}}\n") };
        let checked = check_text(&format!("docs/language.md:{line}"), &source);
        let wrong = checked.diagnostics.iter().any(|d| d.severity == Severity::Error || d.code == "W0404");
        assert!(!wrong && checked.rig.is_some(), "docs/language.md:{line}:\n{}", shown(&checked));
        seen += 1;
    }
    assert!(seen >= 15, "only {seen} examples");
}

#[test]
fn every_keyword_stands_in_an_example() {
    let text = std::fs::read_to_string(root().join("docs/language.md")).expect("the language reference");
    let code: String = fences(&text).into_iter().map(|f| f.2).collect();
    for word in [
        "param",
        "const",
        "derived",
        "lump",
        "coord",
        "prescribed",
        "frame",
        "body",
        "gravity",
        "input",
        "actuator",
        "mix",
        "force",
        "torque",
        "spring",
        "damper",
        "friction",
        "potential",
        "kinetic",
        "dissipation",
        "equation",
        "encoder",
        "output",
        "trim",
        "assume",
        "remove",
        "replace",
        "extends",
    ] {
        assert!(code.split(|c: char| !c.is_alphanumeric() && c != '_').any(|w| w == word), "no example of `{word}`");
    }
}

#[test]
fn every_example_rig_passes() {
    let folders = ["examples/rigs", "examples/measured", "examples/hidden"];
    let entries = folders.iter().flat_map(|f| std::fs::read_dir(root().join(f)).expect("the example rigs").flatten());
    for entry in entries.filter(|e| e.path().extension().is_some_and(|x| x == "rig")) {
        let checked = model_dsl::check(&entry.path().display().to_string(), &FileLoader, &CheckOptions::default());
        let wrong = checked.diagnostics.iter().any(|d| d.severity != Severity::Note);
        assert!(!wrong && checked.rig.is_some(), "{}", shown(&checked));
    }
}

/// Reads a wrong rig without the message at its end.
struct Wrong;

impl Loader for Wrong {
    fn load(&self, name: &str) -> Result<Vec<u8>, String> {
        let bytes = std::fs::read(root().join("tests/rigs/fail").join(name)).map_err(|_| "there is no such file".to_owned())?;
        let end = bytes.windows(4).position(|w| w == b"\n//~").map_or(bytes.len(), |k| k + 1);
        let mut text = bytes[..end].to_vec();
        while text.ends_with(b"\n\n") {
            text.pop();
        }
        Ok(text)
    }
}

#[test]
fn the_list_of_errors_is_up_to_date() {
    let mut names: Vec<String> = std::fs::read_dir(root().join("tests/rigs/fail"))
        .expect("the wrong rigs")
        .flatten()
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .filter(|n| n.ends_with(".rig"))
        .collect();
    names.sort();
    let checked: Vec<Checked> = names.iter().map(|n| model_dsl::check(n, &Wrong, &CheckOptions::default())).collect();
    let mut text = "# Errors, warnings and notes\n\nWritten by the tests from the catalogue in `model-dsl/src/diagnostic.rs` and the wrong rigs in `tests/rigs/fail`.\n".to_owned();
    for (code, sentence) in CATALOGUE {
        let _ = write!(text, "\n## {code}: {sentence}\n\n");
        // the rig that shows it with the least beside it
        let example = checked.iter().filter(|c| c.diagnostics.iter().any(|d| d.code == *code)).min_by_key(|c| c.diagnostics.len());
        if let Some(c) = example
            && let Some(d) = c.diagnostics.iter().find(|d| d.code == *code)
        {
            let shown: Vec<String> = d.render(&c.sources, false).lines().map(|l| l.trim_end().to_owned()).collect();
            let _ = write!(text, "```text\n{}\n```\n", shown.join("\n"));
        }
    }
    let path = root().join("docs/errors.md");
    if std::env::var_os("RIG_BLESS").is_some() {
        std::fs::write(&path, &text).expect("a writable file");
    }
    let stands = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(stands == text, "docs/errors.md is stale: RIG_BLESS=1 cargo test -p model-dsl writes it anew");
}
