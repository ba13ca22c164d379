//! Source texts, and where they come from. The only door to files is a [`Loader`].

use crate::rig::Span;

/// Fetches the text of a file.
pub trait Loader {
    /// Bytes of the file, or why it cannot be read.
    ///
    /// # Errors
    /// A sentence for the user.
    fn load(&self, name: &str) -> Result<Vec<u8>, String>;

    /// Name of a file that `from` names by `relative`.
    fn beside(&self, from: &str, relative: &str) -> String {
        match from.rfind(['/', '\\']) {
            Some(cut) if !relative.starts_with('/') => straight(&format!("{}/{relative}", from.get(..cut).unwrap_or(""))),
            _ => straight(relative),
        }
    }
}

/// A path without `a/..` and `./` in it, so that one file has one name.
fn straight(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." if parts.last().is_some_and(|p| !p.is_empty() && *p != "..") => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    parts.join("/")
}

/// Reads from the file system.
pub struct FileLoader;

impl Loader for FileLoader {
    fn load(&self, name: &str) -> Result<Vec<u8>, String> {
        std::fs::read(name).map_err(|e| match e.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => e.to_string(),
        })
    }
}

/// One text of its own: `use` finds nothing.
pub struct NoFiles;

impl Loader for NoFiles {
    fn load(&self, _name: &str) -> Result<Vec<u8>, String> {
        Err("this text stands alone: it cannot use other files".to_owned())
    }
}

/// All texts that went into a rig.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    /// Name and text of each file, by index.
    pub files: Vec<(String, String)>,
}

/// A place for people: 1-based line and column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// File name.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

impl Sources {
    /// The text of a span.
    #[must_use]
    pub fn text(&self, span: Span) -> Option<&str> {
        self.files.get(span.file as usize)?.1.get(span.start as usize..span.end as usize)
    }

    /// Line and column of the start of a span.
    #[must_use]
    pub fn place(&self, span: Span) -> Option<Place> {
        let (file, text) = self.files.get(span.file as usize)?;
        let before = text.get(..span.start as usize)?;
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().map_or(0, |l| l.chars().count()) + 1;
        Some(Place { file: file.clone(), line, column })
    }
}
