//! Errors as part of the product: where, what, how to mend it. One static catalogue of codes.

use crate::rig::Span;
use crate::source::{Place, Sources};
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use std::collections::HashMap;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// No rig comes out.
    Error,
    /// Probably a mistake.
    Warning,
    /// For information.
    Note,
}

/// One finding about a rig.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// Code of [`CATALOGUE`].
    pub code: &'static str,
    /// How bad.
    pub severity: Severity,
    /// What is wrong, in the words of mechanics.
    pub message: String,
    /// Places, the first one is the main one.
    pub labels: Vec<(Span, String)>,
    /// How to mend it.
    pub helps: Vec<String>,
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(code: &'static str, message: impl Into<String>, span: Span, label: impl Into<String>) -> Self {
        Self { code, severity: Severity::Error, message: message.into(), labels: vec![(span, label.into())], helps: Vec::new() }
    }

    /// A warning at a place.
    pub fn warning(code: &'static str, message: impl Into<String>, span: Span, label: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(code, message, span, label) }
    }

    /// A note at a place.
    pub fn note(code: &'static str, message: impl Into<String>, span: Span, label: impl Into<String>) -> Self {
        Self { severity: Severity::Note, ..Self::error(code, message, span, label) }
    }

    /// With another place.
    #[must_use]
    pub fn also(mut self, span: Span, label: impl Into<String>) -> Self {
        self.labels.push((span, label.into()));
        self
    }

    /// With a way to mend it.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.helps.push(text.into());
        self
    }

    /// Where its main label starts.
    #[must_use]
    pub fn place(&self, sources: &Sources) -> Option<Place> {
        self.labels.first().and_then(|(span, _)| sources.place(*span))
    }

    /// In rustc's look.
    #[must_use]
    pub fn render(&self, sources: &Sources, color: bool) -> String {
        let level = match self.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
            Severity::Note => Level::NOTE,
        };
        let mut group = level.primary_title(self.message.as_str()).id(self.code).elements(Vec::<annotate_snippets::Message>::new());
        let mut files: Vec<u32> = Vec::new();
        for (span, _) in &self.labels {
            if !files.contains(&span.file) {
                files.push(span.file);
            }
        }
        for file in files {
            let Some((name, text)) = sources.files.get(file as usize) else { continue };
            let place = |span: &Span| {
                let start = text.floor_char_boundary(span.start as usize);
                (start, text.ceil_char_boundary(span.end as usize).max(start))
            };
            // only the lines that are shown: a long file must not make its messages slow
            let spans: Vec<(usize, usize)> = self.labels.iter().filter(|(s, _)| s.file == file).map(|(s, _)| place(s)).collect();
            let from = spans.iter().map(|s| s.0).min().unwrap_or(0);
            let from = text[..from].rfind('\n').map_or(0, |k| k + 1);
            let to = spans.iter().map(|s| s.1).max().unwrap_or(0);
            let to = text[to..].find('\n').map_or(text.len(), |k| to + k + 1);
            let line = text[..from].matches('\n').count() + 1;
            let mut snippet = Snippet::source(&text[from..to]).path(name.as_str()).line_start(line);
            for (k, (span, label)) in self.labels.iter().enumerate().filter(|(_, (s, _))| s.file == file) {
                let kind = if k == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
                let (start, end) = place(span);
                snippet = snippet.annotation(kind.span(start - from..end - from).label(label.as_str()));
            }
            group = group.element(snippet);
        }
        for help in &self.helps {
            group = group.element(Level::HELP.message(help.as_str()));
        }
        let renderer = if color { Renderer::styled() } else { Renderer::plain() };
        renderer.render(&[group])
    }
}

/// In the order of their places, errors first; one message for a name that is unknown in several places, none twice.
pub fn tidy(mut all: Vec<Diagnostic>) -> Vec<Diagnostic> {
    all.sort_by_key(|d| (d.severity, d.labels.first().map(|(s, _)| *s)));
    all.dedup();
    let mut first: HashMap<(&'static str, String), usize> = HashMap::new();
    let mut out: Vec<Diagnostic> = Vec::new();
    for d in all {
        if !matches!(d.code, "E0201" | "E0203") {
            out.push(d);
            continue;
        }
        match first.get(&(d.code, d.message.clone())) {
            // two more places are shown: a misspelt name is mended in all of them by then
            Some(&k) if out[k].labels.len() < 3 => out[k].labels.push((d.labels[0].0, "and here".to_owned())),
            Some(_) => {}
            None => {
                first.insert((d.code, d.message.clone()), out.len());
                out.push(d);
            }
        }
    }
    out
}

/// The nearest of `names` to a misspelt one, if any is near.
pub fn nearest<'a>(name: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // one letter of two says nothing, but capitals do
    let length = name.chars().count();
    let limit = if length <= 2 { 0 } else { (length / 3).max(1) };
    names
        .into_iter()
        .filter(|n| *n != name && n.chars().count().abs_diff(length) <= limit)
        .map(|n| (distance(&name.to_lowercase(), &n.to_lowercase()), n))
        .filter(|(d, _)| *d <= limit)
        .min_by_key(|(d, n)| (*d, n.len()))
        .map(|(_, n)| n)
}

/// Edit distance with transpositions of neighbours (optimal string alignment).
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(64).collect(), b.chars().take(64).collect());
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let swap = usize::from(a[i - 1] != b[j - 1]);
            row[j] = (rows[i - 1][j] + 1).min(row[j - 1] + 1).min(rows[i - 1][j - 1] + swap);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(rows[i - 2][j - 2] + 1);
            }
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

/// Every code and what it stands for.
pub const CATALOGUE: &[(&str, &str)] = &[
    ("E0101", "a character without meaning"),
    ("E0102", "a number that overflows or is no number"),
    ("E0103", "a comment or text that is never closed"),
    ("E0104", "a file that cannot be read"),
    ("E0105", "files that use each other in a circle"),
    ("E0111", "something else was expected here"),
    ("E0112", "an unknown statement"),
    ("E0113", "nested too deeply"),
    ("E0114", "no rig in the file, or not the one asked for"),
    ("E0115", "a block lacks an entry, or has one twice"),
    ("E0201", "an unknown name"),
    ("E0202", "a name declared twice"),
    ("E0203", "an unknown unit"),
    ("E0204", "definitions that stand for each other in a circle"),
    ("E0205", "a function with the wrong number of arguments"),
    ("E0206", "a name of the wrong kind for this place"),
    ("E0207", "`replace` or `remove` of what is not there"),
    ("E0208", "rigs that extend each other in a circle"),
    ("E0231", "a quantity of another dimension was expected"),
    ("E0232", "terms of different dimensions in a sum"),
    ("E0233", "a function or exponent needs a number without dimension"),
    ("E0234", "hertz where radians per second are meant"),
    ("E0301", "frames in a circle"),
    ("E0302", "an angle or offset that is not affine in the coordinates"),
    ("E0303", "an inertia tensor that no mass distribution has"),
    ("E0304", "a coordinate that moves no inertia"),
    ("E0305", "a coordinate that nothing uses"),
    ("E0306", "a mass or kinetic energy that is negative"),
    ("E0307", "equations written directly that do not fit the rig"),
    ("E0308", "a kinetic function that is not quadratic in the rates"),
    ("E0309", "a mix of inputs that cannot be undone"),
    ("E0310", "bounds, limits, priors, times or widths that make no sense"),
    ("E0311", "a trim with more unknowns than equations, or fewer"),
    ("E0312", "an assumption that does not fit the rig"),
    ("E0313", "an axis of length zero, or a direction that is not of length one"),
    ("E0314", "a parameter's value cannot be computed"),
    ("W0401", "a parameter that nothing uses"),
    ("W0402", "an input that nothing uses"),
    ("W0403", "a frame that carries nothing"),
    ("W0404", "an angle without unit of more than a turn"),
    ("N0501", "a parameter that only an assumption made unused"),
];
