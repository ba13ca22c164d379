//! The rig language: text in, checked rig out.
//!
//! One grammar for files, for `rig! { .. }` (whose tokens `macro_text` writes out) and for the program. The passes, in order: `token` ->
//! `parser` -> `extend` -> `resolve` (with `quantity` for expressions and `units`) -> `mechanics`. Each reports all
//! that it finds; a [`rig::Rig`] comes out only if nothing is wrong. No input makes it panic.
#![forbid(unsafe_code)]

mod ast;
mod diagnostic;
mod extend;
mod macro_text;
mod mechanics;
mod parser;
mod quantity;
mod resolve;
pub mod rig;
mod source;
mod token;
pub mod units;

pub use diagnostic::{CATALOGUE, Diagnostic, Severity, nearest};
pub use macro_text::MacroText;
pub use source::{FileLoader, Loader, NoFiles, Place, Sources};

use rig::Rig;

/// Deepest chain of files: links in a file system can make circles that names do not show.
const DEEPEST: usize = 64;

/// Choices of a check.
#[derive(Clone, Debug, Default)]
pub struct CheckOptions {
    /// Which rig of the file; the last one where `None`.
    pub rig: Option<String>,
}

/// What a check found.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The rig, if nothing is wrong with it.
    pub rig: Option<Rig>,
    /// Findings, in the order of their places.
    pub diagnostics: Vec<Diagnostic>,
    /// Texts that the findings point into.
    pub sources: Sources,
}

/// Reads and checks a rig file and all files that it uses.
#[must_use]
pub fn check(root: &str, loader: &dyn Loader, options: &CheckOptions) -> Checked {
    let mut diagnostics = Vec::new();
    let mut sources = Sources::default();
    let mut files = Vec::new();
    read(root, None, loader, &mut sources, &mut files, &mut Vec::new(), &mut diagnostics);
    finish(files, sources, diagnostics, options)
}

/// Checks the tokens of a macro. `name` stands for the Rust file in messages; files that the rig uses are looked up by
/// the loader as they are written. Spans in file 0 can be taken back to the compiler's by the [`MacroText`].
#[must_use]
pub fn check_tokens(name: &str, tokens: proc_macro2::TokenStream, loader: &dyn Loader, options: &CheckOptions) -> (Checked, MacroText) {
    struct Root<'a> {
        name: &'a str,
        text: &'a str,
        loader: &'a dyn Loader,
    }
    impl Loader for Root<'_> {
        fn load(&self, name: &str) -> Result<Vec<u8>, String> {
            if name == self.name { Ok(self.text.as_bytes().to_vec()) } else { self.loader.load(name) }
        }
        fn beside(&self, from: &str, relative: &str) -> String {
            if from == self.name { relative.to_owned() } else { self.loader.beside(from, relative) }
        }
    }
    let text = MacroText::new(tokens);
    let root = Root { name, text: &text.text, loader };
    let checked = check(name, &root, options);
    (checked, text)
}

/// Checks a text that stands alone.
#[must_use]
pub fn check_text(name: &str, text: &str) -> Checked {
    struct One<'a>(&'a str);
    impl Loader for One<'_> {
        fn load(&self, name: &str) -> Result<Vec<u8>, String> {
            if name == "\0text" { Ok(self.0.as_bytes().to_vec()) } else { NoFiles.load(name) }
        }
    }
    let mut checked = check("\0text", &One(text), &CheckOptions::default());
    if let Some(file) = checked.sources.files.first_mut() {
        file.0 = name.to_owned();
    }
    checked
}

fn read(
    name: &str,
    by: Option<rig::Span>,
    loader: &dyn Loader,
    sources: &mut Sources,
    files: &mut Vec<ast::File>,
    chain: &mut Vec<String>,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let place = by.unwrap_or_default();
    if chain.iter().any(|n| n == name) {
        diagnostics.push(
            Diagnostic::error("E0105", format!("`{name}` uses itself in a circle"), place, "closes the circle")
                .help("move what both files need into a third one"),
        );
        return;
    }
    if sources.files.iter().any(|(n, _)| n == name) {
        return;
    }
    if chain.len() >= DEEPEST {
        diagnostics.push(Diagnostic::error("E0105", format!("files use each other more than {DEEPEST} deep"), place, "used here"));
        return;
    }
    let bytes = match loader.load(name) {
        Ok(bytes) => bytes,
        Err(why) => {
            diagnostics.push(Diagnostic::error("E0104", format!("cannot read `{name}`: {why}"), place, "used here"));
            return;
        }
    };
    let file = sources.files.len() as u32;
    let text = match String::from_utf8(bytes) {
        Ok(text) => text,
        Err(e) => {
            let at = e.utf8_error().valid_up_to();
            let text = String::from_utf8_lossy(e.as_bytes()).into_owned();
            sources.files.push((name.to_owned(), text));
            // the first broken byte became one replacement character
            let span = rig::Span { file, start: at as u32, end: (at + char::REPLACEMENT_CHARACTER.len_utf8()) as u32 };
            diagnostics.push(
                Diagnostic::error("E0104", format!("`{name}` is not UTF-8 text"), span, "from here on").help("save the file as UTF-8"),
            );
            return;
        }
    };
    if text.len() > u32::MAX as usize / 2 {
        diagnostics.push(Diagnostic::error("E0104", format!("`{name}` is too large"), place, "used here"));
        return;
    }
    let tokens = token::lex(file, &text, diagnostics);
    sources.files.push((name.to_owned(), text));
    let parsed = parser::parse(&tokens, diagnostics);
    chain.push(name.to_owned());
    for used in &parsed.uses {
        let path = loader.beside(name, &used.text);
        read(&path, Some(used.span), loader, sources, files, chain, diagnostics);
    }
    chain.pop();
    files.push(parsed);
}

fn finish(files: Vec<ast::File>, sources: Sources, mut diagnostics: Vec<Diagnostic>, options: &CheckOptions) -> Checked {
    let wanted = match &options.rig {
        Some(name) => extend::find(&files, name),
        None => files.last().and_then(|f| f.rigs.last()),
    };
    let mut rig = None;
    match wanted {
        Some(item) => {
            if let Some(flat) = extend::flatten(&files, item, &mut diagnostics) {
                let (resolved, used) = resolve::resolve(&item.name, &item.doc, &flat, &sources, &mut diagnostics);
                mechanics::check(&resolved, &flat.statements, &used, &mut diagnostics);
                rig = Some(resolved);
            }
        }
        None if diagnostics.is_empty() => {
            let names: Vec<&str> = files.iter().flat_map(|f| &f.rigs).map(|r| r.name.text.as_str()).collect();
            let message = match &options.rig {
                Some(name) => format!("there is no rig `{name}` in this file"),
                None => "there is no rig in this file".to_owned(),
            };
            let d = Diagnostic::error("E0114", message, rig::Span::default(), "");
            let near = options.rig.as_ref().and_then(|wanted| nearest(wanted, names.iter().copied()));
            diagnostics.push(match near {
                Some(near) => d.help(format!("did you mean `{near}`?")),
                None if names.is_empty() => d.help("write `rig NAME { .. }`"),
                None => d.help(format!("it has {}", names.join(", "))),
            });
        }
        None => {}
    }
    if diagnostics.iter().any(|d| d.severity == Severity::Error) {
        rig = None;
    }
    let diagnostics = diagnostic::tidy(diagnostics);
    Checked { rig, diagnostics, sources }
}

/// A value from the command line: a number with an optional unit (`5deg`, `0.3`, `8 deg/s`), in SI.
///
/// # Errors
/// A sentence for the user.
pub fn parse_value(text: &str, expected: &units::Unit) -> Result<f64, String> {
    let mut diagnostics = Vec::new();
    let bracketed = in_brackets(text);
    let text = bracketed.as_deref().unwrap_or(text);
    let tokens = token::lex(0, text, &mut diagnostics);
    let expr = parser::parse_expression(&tokens, &mut diagnostics);
    let scope = quantity::Scope::default();
    let sources = Sources { files: vec![("value".to_owned(), text.to_owned())] };
    let mut used = std::collections::BTreeSet::new();
    let checked = expr.as_ref().and_then(|e| {
        quantity::Checker { scope: &scope, sources: &sources, diagnostics: &mut diagnostics, used: &mut used }.expect(
            e,
            expected.dimension,
            "this",
            quantity::Allowed::Numbers,
        )
    });
    let bare = expr.as_ref().is_some_and(quantity::is_bare);
    match (checked, diagnostics.first()) {
        (Some(rig::Expr::Number(x)), None) => Ok(if bare { x * expected.factor } else { x }),
        (_, Some(d)) => Err(d.message.clone()),
        _ => Err(format!("`{text}` is no number")),
    }
}

/// `8 deg/s` as `8 [deg/s]`: outside of a rig nothing else can be meant.
fn in_brackets(text: &str) -> Option<String> {
    let cut = text.find(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E'))?;
    let (number, unit) = text.split_at_checked(cut)?;
    (unit.contains(['/', '*', '^']) && number.trim().parse::<f64>().is_ok() && parse_unit(unit).is_ok())
        .then(|| format!("{number}[{unit}]"))
}

/// A function of time as written in a rig (`4 deg * sin(2 [rad/s] * t)`); a bare number takes the unit of its place.
///
/// # Errors
/// A sentence for the user, and how to mend it where that is known.
pub fn parse_time_function(text: &str, expected: &units::Unit) -> Result<rig::Expr, (String, Option<String>)> {
    let mut diagnostics = Vec::new();
    let tokens = token::lex(0, text, &mut diagnostics);
    let expr = parser::parse_expression(&tokens, &mut diagnostics);
    let scope = quantity::Scope::default();
    let sources = Sources { files: vec![("function".to_owned(), text.to_owned())] };
    let mut used = std::collections::BTreeSet::new();
    let checked = expr.as_ref().and_then(|e| {
        quantity::Checker { scope: &scope, sources: &sources, diagnostics: &mut diagnostics, used: &mut used }.expect(
            e,
            expected.dimension,
            "this",
            quantity::Allowed::Trajectory,
        )
    });
    let bare = expr.as_ref().is_some_and(quantity::is_bare);
    match (checked, diagnostics.into_iter().find(|d| d.severity == Severity::Error)) {
        (Some(rig::Expr::Number(x)), None) if bare => Ok(rig::Expr::Number(x * expected.factor)),
        (Some(expr), None) => Ok(expr),
        (_, Some(d)) => Err((d.message.replace(" in this rig", ""), d.helps.into_iter().next())),
        (None, None) => Err((format!("`{text}` is no function of time"), None)),
    }
}

/// A unit as written in a rig (`deg`, `N*m*s`, `m/s^2`), for records and options.
///
/// # Errors
/// A sentence for the user.
pub fn parse_unit(text: &str) -> Result<units::Unit, String> {
    let mut diagnostics = Vec::new();
    let tokens = token::lex(0, text, &mut diagnostics);
    let parsed = parser::parse_unit(&tokens, &mut diagnostics);
    let scope = quantity::Scope::default();
    let mut used = std::collections::BTreeSet::new();
    let sources = Sources { files: vec![("unit".to_owned(), text.to_owned())] };
    let unit = parsed
        .as_ref()
        .and_then(|u| quantity::Checker { scope: &scope, sources: &sources, diagnostics: &mut diagnostics, used: &mut used }.unit(u));
    match (unit, diagnostics.first()) {
        (Some(unit), None) if unit.factor.is_finite() && unit.factor > 0.0 => Ok(unit),
        (_, Some(d)) => Err(d.message.clone()),
        _ => Err(format!("`{text}` is no unit")),
    }
}
