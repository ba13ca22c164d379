//! Tokens, from text or from a macro's tokens. Lexes by Rust's rules; knows nothing of grammar.

use crate::diagnostic::Diagnostic;
use crate::rig::Span;

/// Kinds of tokens.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// Name or keyword.
    Ident(String),
    /// Number and the unit glued to it (`10deg`), which may be empty.
    Number(f64, String),
    /// `"text"`
    Text(String),
    /// One character of punctuation; `joint` says that the next one touches it.
    Punct(char, bool),
    /// `/// text`, or (true) a comment behind a statement on the same line.
    Doc(String, bool),
    /// End of the source.
    End,
}

/// A token and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    /// What it is.
    pub kind: Kind,
    /// Where it is.
    pub span: Span,
}

/// Lexes text. Errors are reported, and lexing goes on.
pub fn lex(file: u32, text: &str, diagnostics: &mut Vec<Diagnostic>) -> Vec<Token> {
    let mut lexer = Lexer { file, text, at: 0, tokens: Vec::new(), diagnostics };
    lexer.run();
    lexer.tokens
}

struct Lexer<'a> {
    file: u32,
    text: &'a str,
    at: usize,
    tokens: Vec<Token>,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl Lexer<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or("")
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn span(&self, start: usize) -> Span {
        Span { file: self.file, start: start as u32, end: self.at as u32 }
    }

    fn push(&mut self, kind: Kind, start: usize) {
        let span = self.span(start);
        self.tokens.push(Token { kind, span });
    }

    fn take_while(&mut self, accept: impl Fn(char) -> bool) -> &str {
        let start = self.at;
        while let Some(c) = self.peek() {
            if !accept(c) {
                break;
            }
            self.at += c.len_utf8();
        }
        self.text.get(start..self.at).unwrap_or("")
    }

    fn run(&mut self) {
        while let Some(c) = self.peek() {
            let start = self.at;
            if c.is_whitespace() || c == '\u{feff}' {
                self.at += c.len_utf8();
            } else if self.rest().starts_with("//") {
                self.comment();
            } else if self.rest().starts_with("/*") {
                match self.rest().find("*/") {
                    Some(length) => self.at += length + 2,
                    None => {
                        self.at = self.text.len();
                        let span = Span { file: self.file, start: start as u32, end: start as u32 + 2 };
                        self.diagnostics.push(
                            Diagnostic::error("E0103", "this comment is never closed", span, "opened here").help("close it with `*/`"),
                        );
                    }
                }
            } else if c.is_alphabetic() || c == '_' {
                let word = self.take_while(|c| c.is_alphanumeric() || c == '_').to_owned();
                self.push(Kind::Ident(word), start);
            } else if c.is_ascii_digit() {
                self.number();
            } else if c == '"' {
                self.string();
            } else if c.is_ascii_punctuation() {
                self.at += 1;
                let joint = self.peek().is_some_and(|n| n.is_ascii_punctuation());
                self.push(Kind::Punct(c, joint), start);
            } else {
                self.at += c.len_utf8();
                let span = self.span(start);
                self.diagnostics.push(
                    Diagnostic::error("E0101", format!("the character `{}` has no meaning here", c.escape_debug()), span, "this character")
                        .help("the language uses letters, digits, `_` and ASCII punctuation; text may stand in comments"),
                );
            }
        }
        let end = self.text.len();
        self.tokens.push(Token { kind: Kind::End, span: Span { file: self.file, start: end as u32, end: end as u32 } });
    }

    fn comment(&mut self) {
        let start = self.at;
        let line = self.take_while(|c| c != '\n').to_owned();
        let outer = line.starts_with("///") && !line.starts_with("////");
        let first_on_line = self.text.get(..start).is_none_or(|before| before.rsplit('\n').next().is_none_or(|l| l.trim().is_empty()));
        let after_statement = matches!(self.tokens.last(), Some(Token { kind: Kind::Punct(';' | '}', _), .. }));
        if outer || (!first_on_line && after_statement) {
            let text = line.trim_start_matches('/').trim().to_owned();
            self.push(Kind::Doc(text, !first_on_line && after_statement), start);
        }
    }

    fn number(&mut self) {
        let start = self.at;
        self.take_while(|c| c.is_ascii_digit() || c == '_');
        // a dot belongs to the number unless it starts a range or a name
        let after = self.rest().as_bytes();
        if after.first() == Some(&b'.') && after.get(1).is_some_and(u8::is_ascii_digit)
            || after.first() == Some(&b'.') && after.get(1).is_none_or(|c| !c.is_ascii_alphabetic() && *c != b'.' && *c != b'_')
        {
            self.at += 1;
            self.take_while(|c| c.is_ascii_digit() || c == '_');
        }
        let after = self.rest().as_bytes();
        if matches!(after.first(), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(after.get(1), Some(b'+' | b'-')));
            if after.get(1 + sign).is_some_and(u8::is_ascii_digit) {
                self.at += 1 + sign;
                self.take_while(|c| c.is_ascii_digit());
            }
        }
        let digits: String = self.text.get(start..self.at).unwrap_or("0").replace('_', "");
        let suffix = self.take_while(|c| c.is_alphanumeric() || c == '_').to_owned();
        let value = digits.parse::<f64>().unwrap_or(f64::NAN);
        if !value.is_finite() {
            let span = self.span(start);
            self.diagnostics.push(
                Diagnostic::error("E0102", format!("the number {} is too large", shorten(&digits)), span, "overflows to infinity")
                    .help("numbers go up to 1.8e308"),
            );
        }
        self.push(Kind::Number(if value.is_finite() { value } else { 0.0 }, suffix), start);
    }

    fn string(&mut self) {
        let start = self.at;
        self.at += 1;
        let text = self.take_while(|c| c != '"' && c != '\n').to_owned();
        if self.peek() == Some('"') {
            self.at += 1;
        } else {
            let span = self.span(start);
            self.diagnostics.push(
                Diagnostic::error("E0103", "this text is never closed", span, "opened here").help("close it with `\"` on the same line"),
            );
        }
        self.push(Kind::Text(text), start);
    }
}

fn shorten(digits: &str) -> String {
    if digits.chars().count() > 24 { format!("{}..", digits.chars().take(20).collect::<String>()) } else { digits.to_owned() }
}

/// Tokens of a macro; spans number the tokens: token k of the flattened stream is bytes k..k+1 of file 0.
pub fn from_macro(stream: proc_macro2::TokenStream, spans: &mut Vec<proc_macro2::Span>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Token> {
    let mut tokens = Vec::new();
    flatten(stream, &mut tokens, spans, diagnostics);
    let end = spans.len() as u32;
    tokens.push(Token { kind: Kind::End, span: Span { file: 0, start: end, end } });
    tokens
}

fn flatten(
    stream: proc_macro2::TokenStream,
    tokens: &mut Vec<Token>,
    spans: &mut Vec<proc_macro2::Span>,
    diagnostics: &mut Vec<Diagnostic>,
) {
    use proc_macro2::{Delimiter, Spacing, TokenTree};
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        let mut push = |kind: Kind, span: proc_macro2::Span| {
            let at = spans.len() as u32;
            spans.push(span);
            tokens.push(Token { kind, span: Span { file: 0, start: at, end: at + 1 } });
        };
        match tree {
            TokenTree::Ident(ident) => {
                let text = ident.to_string();
                push(Kind::Ident(text.strip_prefix("r#").unwrap_or(&text).to_owned()), ident.span());
            }
            TokenTree::Punct(punct) => {
                // `/// text` reaches a macro as `#[doc = "text"]`
                if punct.as_char() == '#'
                    && let Some(TokenTree::Group(group)) = trees.peek()
                    && let Some(text) = doc_text(&group.stream())
                {
                    let span = group.span();
                    trees.next();
                    push(Kind::Doc(text, false), span);
                    continue;
                }
                push(Kind::Punct(punct.as_char(), punct.spacing() == Spacing::Joint), punct.span());
            }
            TokenTree::Literal(literal) => {
                let text = literal.to_string();
                let mut found = Vec::new();
                let inner = lex(0, &text, &mut found);
                match inner.first().map(|t| &t.kind) {
                    Some(kind @ (Kind::Number(..) | Kind::Text(_))) if found.is_empty() => push(kind.clone(), literal.span()),
                    _ => {
                        push(Kind::Number(0.0, String::new()), literal.span());
                        let at = spans.len() as u32 - 1;
                        let span = Span { file: 0, start: at, end: at + 1 };
                        diagnostics.push(Diagnostic::error(
                            "E0102",
                            format!("`{}` is no number of this language", shorten(&text)),
                            span,
                            "this literal",
                        ));
                    }
                }
            }
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ('(', ')'),
                    Delimiter::Brace => ('{', '}'),
                    Delimiter::Bracket => ('[', ']'),
                    Delimiter::None => {
                        flatten(group.stream(), tokens, spans, diagnostics);
                        continue;
                    }
                };
                push(Kind::Punct(open, false), group.span_open());
                flatten(group.stream(), tokens, spans, diagnostics);
                let at = spans.len() as u32;
                spans.push(group.span_close());
                tokens.push(Token { kind: Kind::Punct(close, false), span: Span { file: 0, start: at, end: at + 1 } });
            }
        }
    }
}

fn doc_text(stream: &proc_macro2::TokenStream) -> Option<String> {
    let mut trees = stream.clone().into_iter();
    let (first, _, third) = (trees.next()?, trees.next()?, trees.next()?);
    if first.to_string() != "doc" {
        return None;
    }
    let text = third.to_string();
    Some(text.trim_matches('"').trim().to_owned())
}
