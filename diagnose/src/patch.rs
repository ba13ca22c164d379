//! From a rig's text and effects to the text that has them.
//!
//! Works on the texts of all files of the rig, by spans, so that comments and layout stay; knows nothing of numbers but those that it
//! is told to write.

use crate::effects::{Edit, Effect};
use crate::forces::Force;
use model_dsl::rig::{Assumption, AssumptionKind, FrameRef, Rig, Span};
use model_dsl::{CheckOptions, Checked, Loader, Severity, Sources};
use std::collections::BTreeMap;
use std::fmt;

/// A rig with the texts that it came from.
#[derive(Clone, Debug)]
pub struct Base {
    /// The checked rig.
    pub rig: Rig,
    /// Its files; the first is the one that was read.
    pub sources: Sources,
    /// Coordinates that no random force pushes, since no training record shows them.
    pub unwatched: Vec<usize>,
}

impl Base {
    /// A rig with its texts, all of whose coordinates may be pushed.
    #[must_use]
    pub fn new(rig: Rig, sources: Sources) -> Self {
        Self { rig, sources, unwatched: Vec::new() }
    }
}

/// An effect with the values that its text is to say: one for each of its parameters, with standard error.
#[derive(Clone, Debug)]
pub struct Written<'a> {
    /// The effect.
    pub effect: &'a Effect,
    /// (value, standard error) of each parameter; zero without error where there is none.
    pub values: Vec<(f64, f64)>,
    /// Its evidence, for the comment above.
    pub evidence: Option<String>,
    /// Its parameters get one value for each record.
    pub per_record: bool,
    /// Only its derivatives at the null value are wanted.
    pub screened: bool,
}

/// A patch that did not work out.
#[derive(Clone, Debug, PartialEq)]
pub enum PatchError {
    /// The patched text is no rig.
    Rejected {
        /// What the check says.
        why: String,
    },
    /// The rig's text is not where it was said to be.
    Place {
        /// What was looked for.
        what: String,
    },
    /// The equations of the patched rig could not be derived.
    Derive {
        /// Why.
        why: String,
    },
}

impl fmt::Display for PatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rejected { why } => write!(f, "the patched rig does not pass its check:\n{why}"),
            Self::Place { what } => write!(f, "the text of {what} was not found in the rig's files"),
            Self::Derive { why } => f.write_str(why),
        }
    }
}

impl std::error::Error for PatchError {}

/// Files in memory.
struct Texts<'a>(&'a [(String, String)]);

impl Loader for Texts<'_> {
    fn load(&self, name: &str) -> Result<Vec<u8>, String> {
        self.0
            .iter()
            .find(|(file, _)| file == name)
            .map(|(_, text)| text.as_bytes().to_vec())
            .ok_or_else(|| "there is no such file".to_owned())
    }
}

/// Checks texts; the first file is the root.
///
/// # Errors
/// [`PatchError::Rejected`].
pub fn check(files: &[(String, String)], rig: &str) -> Result<Base, PatchError> {
    let root = files.first().map_or("", |(name, _)| name.as_str());
    let Checked { rig, diagnostics, sources } = model_dsl::check(root, &Texts(files), &CheckOptions { rig: Some(rig.to_owned()) });
    match rig {
        Some(rig) => Ok(Base::new(rig, sources)),
        None => {
            let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error);
            Err(PatchError::Rejected { why: errors.map(|d| d.render(&sources, false)).collect::<Vec<_>>().join("\n") })
        }
    }
}

/// The texts with `effects` added, and with the forces of `pushed`.
///
/// # Errors
/// [`PatchError::Place`].
pub fn compose(base: &Base, effects: &[Written<'_>], pushed: &[Force]) -> Result<Vec<(String, String)>, PatchError> {
    let mut files = base.sources.files.clone();
    let mut edits: Vec<(Span, String)> = Vec::new();
    let mut more: Vec<String> = Vec::new();
    let rig = &base.rig;
    for Force { coordinate, parameter, unit } in pushed {
        more.push(format!("param {parameter}: {unit} = 0;"));
        more.push(format!("torque {parameter}_on on {}: {parameter};", rig.coordinates[*coordinate].name));
    }
    for written in effects {
        if let Some(evidence) = &written.evidence {
            more.extend(evidence.lines().map(|l| format!("// {l}")));
        }
        for (p, (value, sd)) in written.effect.parameters.iter().zip(&written.values) {
            let spread = if *sd > 0.0 && sd.is_finite() { format!(" +- {}", digits(*sd, 2)) } else { String::new() };
            let value = if *sd > 0.0 && sd.is_finite() { near(*value, *sd) } else { number(*value) };
            let day = if written.per_record { " per record" } else { "" };
            more.push(format!("param {}: {} = {value}{spread}{day};  // {}", p.name, p.unit, p.doc));
        }
        match &written.effect.edit {
            Edit::Add(statement) => more.push(statement_of(base, statement)?),
            Edit::Assumption(k) => {
                let span = rig.assumptions[*k].span;
                let text = base.sources.text(span).unwrap_or_default();
                let kept = if written.evidence.is_some() { format!("// {}", text.replace('\n', " ")) } else { String::new() };
                edits.push((span, if kept.is_empty() { String::new() } else { format!("{kept}\n       ") }));
            }
            Edit::Map { besides, .. } if !written.screened => more.extend(besides.iter().cloned()),
            Edit::Map { .. } | Edit::Path { .. } | Edit::Output { .. } | Edit::Center { .. } | Edit::Gravity(_) => {}
        }
    }
    diagonal(base, effects, &mut edits);
    inputs(base, effects, &mut edits)?;
    outputs(base, effects, &mut edits, &mut more)?;
    bodies(base, effects, &mut edits)?;
    if let Some(along) = effects.iter().find_map(|w| if let Edit::Gravity(along) = &w.effect.edit { Some(along) } else { None }) {
        let gravity = rig.gravity.as_ref().ok_or(PatchError::Place { what: "gravity".to_owned() })?;
        let statement = statement(base, gravity.span, "gravity")?;
        let text = base.sources.text(statement).unwrap_or_default();
        let end = text.find(" along ").unwrap_or(text.len() - 1);
        let head = text.get(..end).unwrap_or_default().trim_end();
        edits.push((statement, format!("{head} along {along};")));
    }
    // from the back, so that places stay
    edits.sort_by_key(|(span, _)| std::cmp::Reverse((span.file, span.start)));
    // additions stand at the end of the rig's block; the block is found before texts move
    let (file, at) = block_end(&files, &rig.name).ok_or(PatchError::Place { what: format!("rig {}", rig.name) })?;
    if !more.is_empty() {
        let lines: String = more.iter().map(|l| format!("    {l}\n")).collect();
        let text = &files[file].1;
        let gap = if text.get(..at).is_some_and(|t| t.ends_with('\n')) { "" } else { "\n" };
        let place = Span { file: file as u32, start: at as u32, end: at as u32 };
        edits.push((place, format!("{gap}{lines}")));
        edits.sort_by_key(|(span, _)| std::cmp::Reverse((span.file, span.start)));
    }
    for (span, text) in edits {
        if let Some((_, file)) = files.get_mut(span.file as usize)
            && file.is_char_boundary(span.start as usize)
            && file.is_char_boundary(span.end as usize)
        {
            file.replace_range(span.start as usize..span.end as usize, &text);
        }
    }
    Ok(files)
}

/// Coordinates that effects bring.
fn more_coordinates(effects: &[Written<'_>]) -> usize {
    effects.iter().filter(|w| !w.screened && matches!(&w.effect.edit, Edit::Map { besides, .. } if !besides.is_empty())).count()
}

/// A mass matrix that is written down gets an entry for each coordinate more.
fn diagonal(base: &Base, effects: &[Written<'_>], edits: &mut Vec<(Span, String)>) {
    let more = ", 1 [kg*m^2]".repeat(more_coordinates(effects));
    if more.is_empty() {
        return;
    }
    let dropped = |k: usize| effects.iter().any(|w| w.effect.edit == Edit::Assumption(k));
    let diagonal = |(k, a): &(usize, &Assumption)| matches!(a.kind, AssumptionKind::InertiaDiagonal(_)) && !dropped(*k);
    for (_, assumption) in base.rig.assumptions.iter().enumerate().filter(diagonal) {
        let text = base.sources.text(assumption.span).unwrap_or_default();
        let open = text.find("diag").and_then(|at| Some(at + text.get(at..)?.find('(')?));
        if let Some(close) = open.and_then(|open| closing(text, open)) {
            let at = assumption.span.start + close as u32;
            edits.push((Span { start: at, end: at, ..assumption.span }, more.clone()));
        }
    }
}

/// A statement whose places are filled in.
fn statement_of(base: &Base, statement: &str) -> Result<String, PatchError> {
    let Some((head, rest)) = statement.split_once("{center of ") else { return Ok(statement.to_owned()) };
    let Some((index, tail)) = rest.split_once('}') else { return Ok(statement.to_owned()) };
    let body = index.parse::<usize>().ok().and_then(|k| base.rig.bodies.get(k));
    let body = body.ok_or(PatchError::Place { what: "a body".to_owned() })?;
    let center = center_text(base, body.span)?.map_or_else(|| "(0, 0, 0)".to_owned(), |(_, parts)| format!("({})", parts.join(", ")));
    Ok(format!("{head}{center}{tail}"))
}

fn inputs(base: &Base, effects: &[Written<'_>], edits: &mut Vec<(Span, String)>) -> Result<(), PatchError> {
    for (j, input) in base.rig.inputs.iter().enumerate() {
        let (mut factors, mut addends, mut path) = (Vec::new(), Vec::new(), BTreeMap::new());
        for written in effects {
            match &written.effect.edit {
                Edit::Map { input, factor, addend, screened, .. } if *input == j => {
                    factors.extend(factor.clone());
                    addends.extend(if written.screened { screened.clone().or_else(|| addend.clone()) } else { addend.clone() });
                }
                Edit::Path { input, entry, value } if *input == j => {
                    path.insert(*entry, value.clone());
                }
                _ => {}
            }
        }
        if factors.is_empty() && addends.is_empty() && path.is_empty() {
            continue;
        }
        let place = statement(base, input.span, "input")?;
        let text = base.sources.text(place).unwrap_or_default();
        let (head, mut entries) = entries_of(text);
        let own = entries.iter().find(|(key, _)| key == "map").map(|(_, value)| format!("({value})"));
        let u = own.unwrap_or_else(|| input.name.clone());
        if !factors.is_empty() || !addends.is_empty() {
            let filled = |list: Vec<String>| list.into_iter().map(|t| t.replace("{u}", &u)).collect::<Vec<_>>();
            let product = filled(factors).into_iter().chain([u.clone()]).collect::<Vec<_>>().join(" * ");
            let map = [product].into_iter().chain(filled(addends)).collect::<Vec<_>>().join(" ");
            entries.retain(|(key, _)| key != "map");
            entries.push(("map".to_owned(), map));
        }
        for (entry, value) in path {
            match entries.iter_mut().find(|(key, _)| key == entry) {
                Some((_, own)) => *own = format!("{own} + {value}"),
                None => entries.push((entry.to_owned(), value)),
            }
        }
        let body: String = entries.iter().map(|(key, value)| format!(" {key} {value};")).collect();
        edits.push((place, format!("{} {{{body} }}", head.trim_end())));
    }
    Ok(())
}

fn outputs(base: &Base, effects: &[Written<'_>], edits: &mut Vec<(Span, String)>, more: &mut Vec<String>) -> Result<(), PatchError> {
    let touched = |k: usize| effects.iter().any(|w| matches!(&w.effect.edit, Edit::Output { output, .. } if *output == k));
    // a coordinate more would be measured where no output is said
    if more_coordinates(effects) == 0 && !(0..base.rig.outputs.len()).any(touched) {
        return Ok(());
    }
    for (k, output) in base.rig.outputs.iter().enumerate() {
        let changes = effects.iter().filter_map(|w| match &w.effect.edit {
            Edit::Output { output, entry, value } if *output == k => Some((*entry, value.clone())),
            _ => None,
        });
        let found = ["encoder", "output"].into_iter().find_map(|word| statement(base, output.span, word).ok().map(|s| (word, s)));
        let (mut value, mut entries) = (output.name.clone(), Vec::new());
        if let Some((word, place)) = found {
            if !touched(k) {
                continue;
            }
            let text = base.sources.text(place).unwrap_or_default();
            if word == "encoder" {
                let counts = text.split_once(':').map_or("", |(_, c)| c).trim_end_matches(';').trim();
                entries.push(("encoder".to_owned(), counts.to_owned()));
            } else {
                let (head, own) = entries_of(text);
                value = head.split_once('=').map_or(value, |(_, v)| v.trim().trim_end_matches(';').to_owned());
                entries = own;
            }
        }
        for (entry, added) in changes {
            let start = match entry {
                "scale" => Some("1"),
                _ => None,
            };
            let (key, added) = if entry == "drift" { ("bias", format!("{added} * t")) } else { (entry, added) };
            if key == "value" {
                value = format!("{value} + {added}");
                continue;
            }
            match entries.iter_mut().find(|(own, _)| own == key) {
                Some((_, own)) => *own = format!("{own} + {added}"),
                None => entries.push((key.to_owned(), start.map_or(added.clone(), |s| format!("{s} + {added}")))),
            }
        }
        let body: String = entries.iter().map(|(key, value)| format!(" {key} {value};")).collect();
        let tail = if body.is_empty() { ";".to_owned() } else { format!(" {{{body} }}") };
        let written = format!("output {}: {} = {value}{tail}", output.name, output.unit.text);
        match found {
            Some((_, place)) => edits.push((place, written)),
            // every coordinate was measured without being said
            None => more.push(written),
        }
    }
    Ok(())
}

fn bodies(base: &Base, effects: &[Written<'_>], edits: &mut Vec<(Span, String)>) -> Result<(), PatchError> {
    for (k, body) in base.rig.bodies.iter().enumerate() {
        let shifts: Vec<(usize, &String)> = effects
            .iter()
            .filter_map(|w| match &w.effect.edit {
                Edit::Center { body, axis, value } if *body == k => Some((*axis, value)),
                _ => None,
            })
            .collect();
        if shifts.is_empty() {
            continue;
        }
        debug_assert!(!matches!(body.frame, FrameRef::Ground));
        let found = center_text(base, body.span)?;
        let mut parts = found.as_ref().map_or_else(|| vec!["0".to_owned(); 3], |(_, parts)| parts.clone());
        for (axis, value) in shifts {
            parts[axis] = if parts[axis] == "0" { value.clone() } else { format!("{} + {value}", parts[axis]) };
        }
        let written = format!("({})", parts.join(", "));
        match found {
            Some((place, _)) => edits.push((place, written)),
            None => {
                let statement = statement(base, body.span, "body")?;
                let text = base.sources.text(statement).unwrap_or_default();
                let open = text.find('{').ok_or(PatchError::Place { what: format!("body {}", body.name) })?;
                let at = statement.start + open as u32 + 1;
                edits.push((Span { file: statement.file, start: at, end: at }, format!(" at {written};")));
            }
        }
    }
    Ok(())
}

/// Place and components of a body's `at (..)`, if it has one.
fn center_text(base: &Base, name: Span) -> Result<Option<(Span, Vec<String>)>, PatchError> {
    let place = statement(base, name, "body")?;
    let text = base.sources.text(place).unwrap_or_default();
    let mut from = 0;
    while let Some(found) = text.get(from..).and_then(|t| t.find("at")) {
        let at = from + found;
        from = at + 2;
        let before = text.get(..at).and_then(|t| t.chars().next_back()).unwrap_or(' ');
        let rest = text.get(at + 2..).unwrap_or_default();
        if before.is_alphanumeric() || before == '_' || !rest.trim_start().starts_with('(') {
            continue;
        }
        let open = at + 2 + (rest.len() - rest.trim_start().len());
        let Some(close) = closing(text, open) else { continue };
        let inside = text.get(open + 1..close).unwrap_or_default();
        let parts = split(inside, ',').into_iter().map(|s| s.trim().to_owned()).collect::<Vec<_>>();
        if parts.len() == 3 {
            let span = Span { file: place.file, start: place.start + open as u32, end: place.start + close as u32 + 1 };
            return Ok(Some((span, parts)));
        }
    }
    Ok(None)
}

/// The whole statement that has its name at `name`, from its keyword to its `;` or its block's end.
fn statement(base: &Base, name: Span, keyword: &str) -> Result<Span, PatchError> {
    let lost = || PatchError::Place { what: format!("the statement `{keyword}`") };
    let (_, text) = base.sources.files.get(name.file as usize).ok_or_else(lost)?;
    let before = text.get(..name.start as usize).ok_or_else(lost)?;
    // the span may begin at the keyword itself
    let start = if text.get(name.start as usize..).is_some_and(|t| t.starts_with(keyword)) && keyword == "gravity" {
        name.start as usize
    } else {
        let trimmed = before.trim_end();
        trimmed.strip_suffix(keyword).map(str::len).ok_or_else(lost)?
    };
    let mut at = start;
    let bytes = text.as_bytes();
    while at < bytes.len() {
        match bytes[at] {
            b'/' if bytes.get(at + 1) == Some(&b'/') => {
                while at < bytes.len() && bytes[at] != b'\n' {
                    at += 1;
                }
            }
            b';' => return Ok(Span { file: name.file, start: start as u32, end: at as u32 + 1 }),
            b'{' => {
                let close = closing(text, at).ok_or_else(lost)?;
                return Ok(Span { file: name.file, start: start as u32, end: close as u32 + 1 });
            }
            b'(' => at = closing(text, at).ok_or_else(lost)?,
            _ => {}
        }
        at += 1;
    }
    Err(lost())
}

/// The bracket that closes the one at `open`; comments are passed over.
fn closing(text: &str, open: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut depth = 0_i32;
    let mut at = open;
    while at < bytes.len() {
        match bytes[at] {
            b'/' if bytes.get(at + 1) == Some(&b'/') => {
                while at < bytes.len() && bytes[at] != b'\n' {
                    at += 1;
                }
            }
            b'(' | b'{' | b'[' => depth += 1,
            b')' | b'}' | b']' => {
                depth -= 1;
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => {}
        }
        at += 1;
    }
    None
}

/// Parts between `by` outside of brackets.
fn split(text: &str, by: char) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut depth = 0;
    for c in text.chars() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if c == by && depth == 0 {
            parts.push(String::new());
        } else if let Some(last) = parts.last_mut() {
            last.push(c);
        }
    }
    parts
}

/// What stands before a statement's block, and the block's entries.
fn entries_of(text: &str) -> (String, Vec<(String, String)>) {
    let Some(open) = text.find('{') else { return (text.trim_end_matches(';').to_owned(), Vec::new()) };
    let close = closing(text, open).unwrap_or(text.len() - 1);
    let clean: String = text
        .get(open + 1..close)
        .unwrap_or_default()
        .lines()
        .map(|l| l.split("//").next().unwrap_or_default())
        .collect::<Vec<_>>()
        .join(" ");
    let entries = split(&clean, ';')
        .into_iter()
        .filter_map(|entry| entry.trim().split_once(' ').map(|(key, value)| (key.to_owned(), value.trim().to_owned())))
        .collect();
    (text.get(..open).unwrap_or_default().to_owned(), entries)
}

/// File and place of the brace that closes the rig's block.
fn block_end(files: &[(String, String)], rig: &str) -> Option<(usize, usize)> {
    for (k, (_, text)) in files.iter().enumerate() {
        let mut from = 0;
        while let Some(found) = text.get(from..).and_then(|t| t.find("rig ")) {
            let at = from + found;
            from = at + 4;
            let line = text.get(..at).unwrap_or_default().rsplit('\n').next().unwrap_or_default();
            let rest = text.get(at + 4..).unwrap_or_default().trim_start();
            let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            if line.contains("//") || name != rig {
                continue;
            }
            let open = text.get(at..)?.find('{')? + at;
            let close = closing(text, open)?;
            // in front of the brace, at the beginning of its line
            let before = text.get(..close)?;
            let start = before.rfind('\n').map_or(0, |n| n + 1);
            let own_line = before.get(start..)?.trim().is_empty();
            return Some((k, if own_line { start } else { close }));
        }
    }
    None
}

/// A number as the language reads it.
pub(crate) fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let plain = format!("{value}");
    if plain.len() <= 8 { plain } else { format!("{value:e}") }
}

/// With this many significant digits.
pub(crate) fn digits(value: f64, count: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_owned();
    }
    let places = count as i32 - 1 - value.abs().log10().floor() as i32;
    if (0..=9).contains(&places) {
        format!("{value:.*}", places as usize)
    } else if (-6..0).contains(&places) {
        let scale = 10_f64.powi(-places);
        format!("{}", (value / scale).round() * scale)
    } else {
        format!("{value:.*e}", count - 1)
    }
}

/// As many digits as its standard error leaves meaning.
pub(crate) fn near(value: f64, sd: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let count = (value.abs().log10().floor() - sd.log10().floor()) as i32 + 2;
    digits(value, count.clamp(1, 9) as usize)
}

#[cfg(test)]
mod tests {
    use super::{digits, near};

    #[test]
    fn numbers_have_the_digits_that_mean_something() {
        assert_eq!(digits(0.312_345, 3), "0.312");
        assert_eq!(digits(12_345.0, 2), "12000");
        assert_eq!(near(0.3123, 0.021), "0.312");
        assert_eq!(near(25.64, 1.3), "25.6");
        assert_eq!(digits(1.5e-12, 2), "1.5e-12");
    }
}
