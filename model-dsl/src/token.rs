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
    /// Something that was reported by the lexer: the parser says nothing more about it.
    Bad,
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
    /// First on its line.
    pub newline: bool,
}

/// Lexes text. Errors are reported, and lexing goes on.
pub fn lex(file: u32, text: &str, diagnostics: &mut Vec<Diagnostic>) -> Vec<Token> {
    let mut lexer = Lexer { file, text, at: 0, tokens: Vec::new(), newline: true, diagnostics };
    lexer.run();
    lexer.tokens
}

struct Lexer<'a> {
    file: u32,
    text: &'a str,
    at: usize,
    tokens: Vec<Token>,
    newline: bool,
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
        // documentation at the end of a line does not hide the break behind it
        let newline = std::mem::replace(&mut self.newline, false);
        self.tokens.push(Token { kind, span, newline });
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
                self.newline |= c == '\n';
                self.at += c.len_utf8();
            } else if self.rest().starts_with("//") {
                self.comment();
            } else if self.rest().starts_with("/*") {
                match self.rest().find("*/") {
                    Some(length) => self.at += length + 2,
                    None => {
                        // the rest of the line is lost, so that what follows is no second error
                        self.take_while(|c| c != '\n');
                        let span = Span { file: self.file, start: start as u32, end: start as u32 + 2 };
                        self.diagnostics.push(
                            Diagnostic::error("E0103", "this comment is never closed", span, "opened here").help("close it with `*/`"),
                        );
                    }
                }
            } else if c.is_alphabetic() || c == '_' {
                let word = self.take_while(in_word).to_owned();
                self.push(Kind::Ident(word), start);
            } else if c.is_ascii_digit() {
                self.number();
            } else if c == '"' {
                self.string();
            } else if c.is_ascii_punctuation() {
                self.at += 1;
                // by Rust's rule: touches another operator, not a bracket, a quote or a comment
                let comment = self.rest().starts_with("//") || self.rest().starts_with("/*");
                let joint = !comment && self.peek().is_some_and(|n| "=<>!~+-*/%^&|@.,;:#$?'".contains(n));
                self.push(Kind::Punct(c, joint), start);
            } else {
                self.at += c.len_utf8();
                let help = match c {
                    '·' | '×' | '∙' | '⋅' => "a product is written with `*`",
                    '−' | '–' | '—' => "a minus sign is `-`",
                    '²' => "a square is written `^2`",
                    '³' => "a cube is written `^3`",
                    '°' => "degrees are written `5deg`",
                    '÷' => "a quotient is written with `/`",
                    '“' | '”' | '„' | '«' | '»' => "a text stands between `\"` and `\"`",
                    '‘' | '’' | '′' => "rates are written `eps.dot`, accelerations `eps.ddot`",
                    '±' => "a prior is written with `+-`",
                    _ => "the language uses letters, digits, `_` and ASCII punctuation; any text may stand in comments",
                };
                let span = self.span(start);
                let d =
                    Diagnostic::error("E0101", format!("the character `{}` has no meaning here", c.escape_debug()), span, "this character");
                self.diagnostics.push(d.help(help));
                self.push(Kind::Bad, start);
            }
        }
        let end = self.text.len();
        self.tokens.push(Token { kind: Kind::End, span: Span { file: self.file, start: end as u32, end: end as u32 }, newline: true });
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
        let suffix = self.take_while(in_word).to_owned();
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
            self.push(Kind::Bad, start);
            return;
        }
        self.push(Kind::Text(text), start);
    }
}

/// Continues a name: letters, ASCII digits, `_`.
fn in_word(c: char) -> bool {
    c.is_alphabetic() || c.is_ascii_digit() || c == '_'
}

fn shorten(digits: &str) -> String {
    if digits.chars().count() > 24 { format!("{}..", digits.chars().take(20).collect::<String>()) } else { digits.to_owned() }
}
