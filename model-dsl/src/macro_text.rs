//! The tokens of a macro, written out as text again: then the one lexer and the one parser read them, and messages look
//! as they do for files. Lines and columns are those of the Rust file where the compiler tells them; each token's place
//! is remembered, so that a span can be taken back to the compiler's.

use crate::rig::Span;
use proc_macro2::{Delimiter, LineColumn, Spacing, TokenStream, TokenTree};

/// Text of a macro's tokens, and where they came from.
#[derive(Clone, Debug, Default)]
pub struct MacroText {
    /// The text.
    pub text: String,
    /// Start and end in the text of each token, in ascending order, and the compiler's span.
    tokens: Vec<(u32, u32, proc_macro2::Span)>,
    /// Where the text has arrived: line from 1, column from 0, in characters.
    line: usize,
    column: usize,
    /// The last token was an operator that touches the next one.
    joint: bool,
}

/// More empty lines or columns than this are not written: the places come from elsewhere.
const FARTHEST: usize = 100_000;

impl MacroText {
    /// Writes out a macro's tokens.
    #[must_use]
    pub fn new(stream: TokenStream) -> Self {
        let mut out = Self { line: 1, ..Self::default() };
        out.stream(stream);
        out
    }

    /// The compiler's spans of the first and the last token that a span touches.
    #[must_use]
    pub fn origin(&self, span: Span) -> Option<(proc_macro2::Span, proc_macro2::Span)> {
        // an empty span belongs to the token in front of it
        let start = span.start.min(span.end.saturating_sub(1));
        let from = self.tokens.partition_point(|t| t.1 <= start);
        let to = self.tokens.partition_point(|t| t.0 < span.end.max(span.start + 1));
        let from = from.min(self.tokens.len().checked_sub(1)?);
        let to = to.max(from + 1).min(self.tokens.len());
        Some((self.tokens[from].2, self.tokens[to - 1].2))
    }

    fn stream(&mut self, stream: TokenStream) {
        let mut trees = stream.into_iter().peekable();
        while let Some(tree) = trees.next() {
            match tree {
                TokenTree::Ident(ident) => {
                    let text = ident.to_string();
                    self.token(text.strip_prefix("r#").unwrap_or(&text), ident.span(), false);
                }
                TokenTree::Literal(literal) => self.token(&literal.to_string(), literal.span(), false),
                TokenTree::Punct(punct) => {
                    // `/// text` reaches a macro as `#[doc = " text"]`
                    if punct.as_char() == '#'
                        && let Some(TokenTree::Group(group)) = trees.peek()
                        && let Some(text) = doc(&group.stream())
                    {
                        self.doc(&text, punct.span());
                        trees.next();
                        continue;
                    }
                    self.token(&punct.as_char().to_string(), punct.span(), punct.spacing() == Spacing::Joint);
                }
                TokenTree::Group(group) => {
                    let (open, close) = match group.delimiter() {
                        Delimiter::Parenthesis => ("(", ")"),
                        Delimiter::Brace => ("{", "}"),
                        Delimiter::Bracket => ("[", "]"),
                        Delimiter::None => {
                            self.stream(group.stream());
                            continue;
                        }
                    };
                    self.token(open, group.span_open(), false);
                    self.stream(group.stream());
                    self.token(close, group.span_close(), false);
                }
            }
        }
    }

    fn token(&mut self, text: &str, span: proc_macro2::Span, joint: bool) {
        self.go_to(span.start());
        self.put(text, span);
        self.joint = joint;
    }

    fn doc(&mut self, text: &str, span: proc_macro2::Span) {
        self.joint = false;
        self.go_to(span.start());
        for line in text.split('\n') {
            self.put(&format!("/// {}", line.trim()), span);
            self.break_line();
        }
    }

    fn put(&mut self, text: &str, span: proc_macro2::Span) {
        let start = self.text.len() as u32;
        self.text.push_str(text);
        self.tokens.push((start, self.text.len() as u32, span));
        self.column += text.chars().count();
    }

    fn break_line(&mut self) {
        self.text.push('\n');
        self.line += 1;
        self.column = 0;
    }

    /// Blanks up to a place; where it lies behind (tokens of another macro), one blank.
    fn go_to(&mut self, place: LineColumn) {
        let ahead = (place.line, place.column) >= (self.line, self.column);
        if ahead && place.line - self.line < FARTHEST && place.column < FARTHEST {
            while self.line < place.line {
                self.break_line();
            }
            let blanks = place.column - self.column;
            self.text.extend(std::iter::repeat_n(' ', blanks));
            self.column = place.column;
        } else if !self.joint {
            self.text.push(' ');
            self.column += 1;
        }
    }
}

/// The text of `[doc = ".."]`.
fn doc(stream: &TokenStream) -> Option<String> {
    let mut trees = stream.clone().into_iter();
    let (first, equals, third) = (trees.next()?, trees.next()?, trees.next()?);
    let is_doc = matches!(&first, TokenTree::Ident(i) if i == "doc") && matches!(&equals, TokenTree::Punct(p) if p.as_char() == '=');
    match third {
        TokenTree::Literal(literal) if is_doc => Some(unquoted(&literal.to_string())),
        _ => None,
    }
}

/// The value of a string literal as Rust writes it.
fn unquoted(literal: &str) -> String {
    if let Some(raw) = literal.strip_prefix('r') {
        return raw.trim_matches('#').trim_matches('"').to_owned();
    }
    let inner = literal.strip_prefix('"').and_then(|l| l.strip_suffix('"')).unwrap_or(literal);
    let mut out = String::new();
    let mut chars = inner.chars();
    while let Some(c) = chars.next() {
        if c != '\\' {
            out.push(c);
            continue;
        }
        match chars.next() {
            Some('n') => out.push('\n'),
            Some('t') => out.push('\t'),
            Some('r') | None => {}
            Some('u') => {
                let code: String = chars.by_ref().skip_while(|c| *c == '{').take_while(|c| *c != '}').collect();
                out.extend(u32::from_str_radix(&code, 16).ok().and_then(char::from_u32));
            }
            Some(other) => out.push(other),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::{Kind, lex};
    use std::path::Path;

    fn kinds(text: &str) -> Vec<Kind> {
        // a macro does not see `//` comments
        lex(0, text, &mut Vec::new()).into_iter().map(|t| t.kind).filter(|k| !matches!(k, Kind::Doc(_, true))).collect()
    }

    #[test]
    fn tokens_of_a_macro_are_those_of_the_text() {
        for folder in ["../examples/rigs", "../tests/rigs/statements", "../tests/rigs/pass"] {
            for entry in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).expect("rigs").flatten() {
                if entry.path().extension().is_none_or(|x| x != "rig") {
                    continue;
                }
                let Ok(text) = std::fs::read_to_string(entry.path()) else { continue };
                let stream: TokenStream = text.parse().expect("Rust's lexer takes it");
                let written = MacroText::new(stream);
                assert_eq!(kinds(&written.text), kinds(&text), "{}", entry.path().display());
            }
        }
    }

    #[test]
    fn a_span_leads_back_to_its_tokens() {
        let text = "rig A {\n    param m: kg = 1.8;\n}";
        let written = MacroText::new(text.parse().expect("tokens"));
        assert_eq!(written.text, text);
        let at = text.find("m: kg").expect("there") as u32;
        let (first, last) = written.origin(Span { file: 0, start: at, end: at + 5 }).expect("tokens");
        assert_eq!((first.start().line, first.start().column), (2, 10));
        assert_eq!((last.end().line, last.end().column), (2, 15));
        // the end of a line belongs to the token in front of it
        let (end, _) = written.origin(Span { file: 0, start: at + 11, end: at + 11 }).expect("a token");
        assert_eq!(end.start().column, 18);
    }

    #[test]
    fn documentation_survives() {
        let written = MacroText::new("/// Title \"x\"\n///\n/// more\nrig A { }".parse().expect("tokens"));
        assert_eq!(kinds(&written.text)[..3], kinds("/// Title \"x\"\n///\n/// more\nrig A { }")[..3]);
    }
}
