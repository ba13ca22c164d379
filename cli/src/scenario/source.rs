//! The text of a scenario, and failures that show the place in it.

use crate::failure::Failure;
use model_dsl::rig::Span;
use model_dsl::{Checked, Diagnostic, Sources, nearest};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The text of a scenario.
pub struct Source {
    /// Where files are looked up.
    pub folder: PathBuf,
    sources: Sources,
}

/// What went wrong at a place.
pub struct Wrong<'a> {
    /// What is wrong.
    pub message: String,
    /// At the place.
    pub label: &'a str,
    /// How to mend it.
    pub help: Option<String>,
}

impl Source {
    /// Reads a scenario; each override `key.key=value` (TOML) takes the place of what stands there.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, Failure> {
        let text = std::fs::read_to_string(path).map_err(|e| {
            let why = if e.kind() == std::io::ErrorKind::NotFound { "there is no such file".to_owned() } else { e.to_string() };
            Failure::new("C0601", format!("cannot read {}: {why}", path.display()))
        })?;
        let folder = path.parent().map_or_else(PathBuf::new, Path::to_path_buf);
        let of = |name: String, text: String| Self { folder: folder.clone(), sources: Sources { files: vec![(name, text)] } };
        let mut source = of(path.display().to_string(), text);
        if overrides.is_empty() {
            return Ok(source);
        }
        let mut root: toml::Table = source.text().parse().map_err(|e| source.toml(&e))?;
        for text in overrides {
            let (key, value) = crate::load::assignment(text)?;
            insert(&mut root, key, value)
                .map_err(|why| Failure::new("C0601", format!("--with {text}: {why}")).with_help("for example `--with encoders=false`"))?;
        }
        let text = toml::to_string(&root).map_err(|e| Failure::new("C0601", format!("{}: {e}", path.display())))?;
        source = of(format!("{} with {}", path.display(), overrides.join(", ")), text);
        Ok(source)
    }

    /// The text.
    pub fn text(&self) -> &str {
        self.sources.files.first().map_or("", |f| &f.1)
    }

    /// A mistake of TOML, or a key or value that does not belong there.
    pub fn toml(&self, error: &toml::de::Error) -> Failure {
        let span = error.span().unwrap_or(0..0);
        let message = error.message();
        let quoted: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
        let (message, label, help) = match quoted.split_first() {
            Some((found, known)) if message.starts_with("unknown field") || message.starts_with("unknown variant") => {
                let what = if message.starts_with("unknown field") { "key" } else { "choice" };
                let help = match nearest(found, known.iter().copied()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("there is {}", known.join(", ")),
                };
                (format!("there is no {what} `{found}` here"), "unknown", Some(help))
            }
            Some((missing, _)) if message.starts_with("missing field") => (
                format!("the key `{missing}` is missing"),
                "in this table",
                Some("docs/control.md lists the keys of a scenario".to_owned()),
            ),
            _ => (message.to_owned(), "here", None),
        };
        self.wrong(&span, Wrong { message, label, help })
    }

    /// A failure at a place.
    pub fn wrong(&self, span: &Range<usize>, wrong: Wrong<'_>) -> Failure {
        // a table's span covers all of its lines: its first one is shown
        let text = self.text();
        let start = span.start.min(text.len());
        let end = span.end.min(text.len()).max(start);
        let line = text.get(start..end).map_or(0, |t| t.trim_end().find('\n').unwrap_or(t.trim_end().len()));
        let span = Span { file: 0, start: to_u32(start), end: to_u32(start + line) };
        let mut diagnostic = Diagnostic::error("C0601", wrong.message, span, wrong.label);
        diagnostic.helps.extend(wrong.help);
        let checked = Checked { rig: None, diagnostics: vec![diagnostic], sources: self.sources.clone() };
        Failure::from_check(&checked, std::io::IsTerminal::is_terminal(&std::io::stderr()))
    }

    /// A failure of another part of the program that this place caused.
    pub fn caused(&self, span: &Range<usize>, failure: &Failure) -> Failure {
        let first = failure.diagnostics.first();
        let message = first.and_then(|d| d["message"].as_str()).unwrap_or(&failure.text).to_owned();
        let help = failure.text.split_once("\n  = help: ").map(|(_, help)| help.to_owned());
        self.wrong(span, Wrong { message, label: "from here", help })
    }
}

fn to_u32(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

/// Puts a value where a dotted key says.
fn insert(table: &mut toml::Table, key: &str, value: &str) -> Result<(), String> {
    let one: toml::Table = format!("value = {value}")
        .parse()
        .or_else(|_| format!("value = {value:?}").parse())
        .map_err(|e: toml::de::Error| e.message().to_owned())?;
    let value = one.get("value").cloned().ok_or("there is no value")?;
    // quoted parts hold dots: `start.at."eps.dot"`
    let mut parts: Vec<String> = Vec::new();
    for (i, piece) in key.split('"').enumerate() {
        if i % 2 == 1 {
            parts.push(piece.to_owned());
        } else {
            parts.extend(piece.split('.').map(str::trim).filter(|p| !p.is_empty()).map(str::to_owned));
        }
    }
    let Some((last, path)) = parts.split_last() else { return Err("there is no key".to_owned()) };
    let mut at = table;
    for part in path {
        at = match at.entry(part.clone()).or_insert_with(|| toml::Value::Table(toml::Table::new())) {
            toml::Value::Table(inner) => inner,
            other => {
                *other = toml::Value::Table(toml::Table::new());
                other.as_table_mut().ok_or("it is no table")?
            }
        };
    }
    at.insert(last.clone(), value);
    Ok(())
}
