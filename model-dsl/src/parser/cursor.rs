//! Looking at tokens, taking them, saying what was expected, and going on behind a mistake.

use super::{Parsed, Parser, Reported, STATEMENTS};
use crate::ast::Name;
use crate::diagnostic::Diagnostic;
use crate::rig::Span;
use crate::token::{Kind as T, Token};

impl Parser<'_> {
    pub(super) fn peek_at(&self, k: usize) -> &Token {
        // documentation may stand anywhere; it is seen only by those who look for it
        self.tokens[self.at.min(self.tokens.len() - 1)..]
            .iter()
            .filter(|t| !matches!(t.kind, T::Doc(..)))
            .nth(k)
            .unwrap_or(&self.tokens[self.tokens.len() - 1])
    }

    pub(super) fn peek(&self) -> &Token {
        self.peek_at(0)
    }

    pub(super) fn next(&mut self) -> Token {
        while matches!(self.tokens.get(self.at).map(|t| &t.kind), Some(T::Doc(..))) {
            self.at += 1;
        }
        let token = self.tokens[self.at.min(self.tokens.len() - 1)].clone();
        if !matches!(token.kind, T::End) {
            self.at += 1;
        }
        token
    }

    pub(super) fn previous_end(&self) -> Span {
        self.tokens[..self.at].iter().rev().find(|t| !matches!(t.kind, T::Doc(..))).map_or_else(Span::default, |t| t.span)
    }

    pub(super) fn from(&self, start: Span) -> Span {
        let end = self.previous_end();
        Span { file: start.file, start: start.start, end: end.end.max(start.end) }
    }

    pub(super) fn is(&self, c: char) -> bool {
        matches!(self.peek().kind, T::Punct(p, _) if p == c)
    }

    pub(super) fn is_word(&self, word: &str) -> bool {
        matches!(&self.peek().kind, T::Ident(w) if w == word)
    }

    pub(super) fn eat(&mut self, c: char) -> bool {
        let found = self.is(c);
        if found {
            self.next();
        }
        found
    }

    pub(super) fn eat_word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        if found {
            self.next();
        }
        found
    }

    pub(super) fn is_range(&self) -> bool {
        matches!(self.peek().kind, T::Punct('.', true)) && matches!(self.peek_at(1).kind, T::Punct('.', _))
    }

    pub(super) fn is_prior(&self) -> bool {
        matches!(self.peek().kind, T::Punct('+', true)) && matches!(self.peek_at(1).kind, T::Punct('-', _))
    }

    pub(super) fn unexpected<X>(&mut self, wanted: &str) -> Parsed<X> {
        if !matches!(self.peek().kind, T::Bad) {
            let d = self.expected(wanted);
            self.diagnostics.push(d);
        }
        Err(Reported)
    }

    pub(super) fn expected(&self, wanted: &str) -> Diagnostic {
        let token = self.peek().clone();
        let found = match &token.kind {
            T::Ident(w) => format!("`{w}`"),
            T::Number(..) => "a number".to_owned(),
            T::Text(_) => "a text".to_owned(),
            T::Punct(c, _) => format!("`{c}`"),
            T::Doc(..) => "documentation".to_owned(),
            T::Bad => "a character without meaning".to_owned(),
            T::End => "the end of the text".to_owned(),
        };
        // what is missing at the end of a line is missed there, not on the next line
        let before = self.previous_end();
        let span =
            if token.newline && self.at > 0 && !matches!(token.kind, T::End) { Span { start: before.end, ..before } } else { token.span };
        let d = Diagnostic::error("E0111", format!("expected {wanted}, found {found}"), span, format!("expected {wanted} here"));
        if matches!(token.kind, T::Punct('\'', _)) { d.help("rates are written `eps.dot`, accelerations `eps.ddot`") } else { d }
    }

    pub(super) fn expect(&mut self, c: char) -> Parsed<Span> {
        if self.is(c) {
            return Ok(self.next().span);
        }
        let here = self.peek().clone();
        let before = self.previous_end();
        let end = Span { start: before.end, ..before };
        if here.kind == T::Bad {
            return Err(Reported);
        }
        if c == ';' && (here.newline || matches!(here.kind, T::Punct('}', _))) && self.at > 0 {
            // the slip is where the line ends; what follows is read as if the `;` stood there
            self.diagnostics.push(Diagnostic::error("E0111", "this statement does not end with `;`", end, "expected `;` here"));
            return Ok(end);
        }
        let mut d = self.expected(&format!("`{c}`"));
        let value = |k: &T| matches!(k, T::Ident(_) | T::Number(..) | T::Punct('(', _));
        let ends_value = matches!(
            self.tokens[..self.at].iter().rev().find(|t| !matches!(t.kind, T::Doc(..))).map(|t| &t.kind),
            Some(T::Ident(_) | T::Number(..) | T::Punct(')', _))
        );
        d = match (c, &here.kind) {
            (':', T::Punct('=', _)) => {
                d.help("`=` gives a value to parameters, frames and outputs; forces, torques and functions are written with `:`")
            }
            ('=', T::Punct(':', _)) => d.help("write `=` in front of a value; `:` stands in front of a unit"),
            (_, T::Punct('.', _)) if matches!(self.peek_at(1).kind, T::Punct('.', _)) => {
                d.help("a range stands behind `in`, as in `in 0..4`")
            }
            (';' | ')' | ',', k) if ends_value && value(k) => d.help("a product is written with `*`, as in `2 * m_h`"),
            _ => d,
        };
        self.diagnostics.push(d);
        Err(Reported)
    }

    /// Whether a block ends here: at its `}`, or, with an error, in front of the statement that follows it.
    pub(super) fn closed(&mut self, open: Span) -> bool {
        if self.eat('}') {
            return true;
        }
        let here = self.peek().clone();
        let next = &self.peek_at(1).kind;
        let statement = match &here.kind {
            T::Ident(word) if here.newline && word == "assume" => matches!(next, T::Punct('{', _)),
            T::Ident(word) if here.newline && word == "gravity" => !matches!(next, T::Punct(..)),
            T::Ident(word) if here.newline && word != "inertia" && STATEMENTS.contains(&word.as_str()) => {
                matches!(next, T::Ident(_) | T::Punct('{', _))
            }
            T::End => true,
            _ => false,
        };
        if statement {
            let label = if here.kind == T::End { "the text ends here" } else { "a new statement starts here" };
            self.diagnostics.push(
                Diagnostic::error("E0111", "this block is never closed", open, "opened here")
                    .also(here.span, label)
                    .help("close it with `}`"),
            );
        }
        statement
    }

    pub(super) fn expect_word(&mut self, word: &str) -> Parsed<()> {
        if self.eat_word(word) { Ok(()) } else { self.unexpected(&format!("`{word}`")) }
    }

    pub(super) fn name(&mut self, what: &str) -> Parsed<Name> {
        match &self.peek().kind {
            T::Ident(_) => {
                let token = self.next();
                let T::Ident(text) = token.kind else { return self.unexpected(what) };
                Ok(Name { text, span: token.span })
            }
            _ => self.unexpected(what),
        }
    }

    pub(super) fn names(&mut self, what: &str) -> Parsed<Vec<Name>> {
        let mut names = vec![self.name(what)?];
        while self.eat(',') {
            names.push(self.name(what)?);
        }
        Ok(names)
    }

    /// Documentation that stands right here.
    pub(super) fn docs(&mut self) -> String {
        let mut lines = Vec::new();
        while let Some(Token { kind: T::Doc(line, _), .. }) = self.tokens.get(self.at) {
            lines.push(line.clone());
            self.at += 1;
        }
        lines.join("\n")
    }

    /// Skips to behind the `;` or `}` that ends the statement which started at token `start`.
    pub(super) fn recover(&mut self, start: usize) {
        let mut depth: i32 = 0;
        for token in self.tokens.get(start..self.at).unwrap_or(&[]) {
            match token.kind {
                T::Punct('{', _) => depth += 1,
                T::Punct('}', _) => depth -= 1,
                _ => {}
            }
        }
        let mut depth = depth.max(0);
        loop {
            let here = self.peek();
            if here.newline
                && depth == 0
                && self.at > start
                && matches!(&here.kind, T::Ident(w) if STATEMENTS.contains(&w.as_str()))
                && matches!(self.peek_at(1).kind, T::Ident(_))
            {
                return;
            }
            match self.peek().kind {
                T::End => return,
                T::Punct(';', _) if depth == 0 => {
                    self.next();
                    return;
                }
                T::Punct('{', _) => depth += 1,
                T::Punct('}', _) if depth == 0 => return,
                T::Punct('}', _) => {
                    depth -= 1;
                    if depth == 0 {
                        self.next();
                        return;
                    }
                }
                _ => {}
            }
            self.next();
        }
    }
}
