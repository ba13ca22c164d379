//! A file, its rigs, and their statements one by one.

use super::{Parsed, Parser, Reported, STATEMENTS};
use crate::ast::{Action, File, Kind, Name, Removal, RigItem, Statement};
use crate::diagnostic::{Diagnostic, nearest};
use crate::token::{Kind as T, Token};

impl Parser<'_> {
    pub(super) fn file(&mut self) -> File {
        let mut file = File::default();
        loop {
            let doc = self.docs();
            if matches!(self.peek().kind, T::End) {
                return file;
            }
            let start = self.at;
            let result = if self.eat_word("use") {
                self.use_item().map(|name| file.uses.push(name))
            } else if self.is_word("rig") {
                self.rig(doc).map(|rig| file.rigs.push(rig))
            } else {
                let mut d = self.expected("`rig` or `use`");
                if !file.rigs.is_empty() {
                    d = d.help("a rig ends at its last `}`: is there one too many above?");
                } else if matches!(&self.peek().kind, T::Ident(w) if STATEMENTS.contains(&w.as_str())) {
                    d = d.help("statements stand in a rig: `rig NAME { .. }`");
                }
                self.diagnostics.push(d);
                Err(Reported)
            };
            if result.is_err() {
                // one message for all that stands outside of rigs
                self.at = self.at.max(start + 1);
                while !(self.is_word("rig") || self.is_word("use") || matches!(self.peek().kind, T::End)) {
                    self.next();
                }
            }
        }
    }

    pub(super) fn use_item(&mut self) -> Parsed<Name> {
        let token = self.next();
        if token.kind == T::Bad {
            return Err(Reported);
        }
        let T::Text(text) = token.kind else {
            self.diagnostics.push(Diagnostic::error("E0111", "expected a file name in quotes", token.span, "expected \"file.rig\" here"));
            return Err(Reported);
        };
        self.expect(';')?;
        Ok(Name { text, span: token.span })
    }

    pub(super) fn rig(&mut self, doc: String) -> Parsed<RigItem> {
        self.expect_word("rig")?;
        let name = self.name("the rig's name")?;
        let extends = if self.eat_word("extends") { Some(self.name("the name of the rig to extend")?) } else { None };
        let open = self.expect('{')?;
        let mut rig = RigItem { name, doc, extends, statements: Vec::new(), removals: Vec::new() };
        loop {
            let doc = self.docs();
            if self.eat('}') {
                return Ok(rig);
            }
            let here = self.peek().clone();
            let next_item = here.newline && (self.is_word("rig") || self.is_word("use"));
            if here.kind == T::End || next_item {
                let label = if next_item { "the next one starts here" } else { "the text ends here" };
                self.diagnostics.push(
                    Diagnostic::error("E0111", format!("the rig `{}` is never closed", rig.name.text), open, "opened here")
                        .also(here.span, label)
                        .help("close it with `}`"),
                );
                return Ok(rig);
            }
            let before = self.at;
            if self.statement(doc, &mut rig).is_err() {
                self.recover(before);
                self.lost(before, &mut rig);
            }
        }
    }

    /// Keeps the names that a statement with an error would have declared, so that their uses are no second error.
    pub(super) fn lost(&mut self, start: usize, rig: &mut RigItem) {
        let tokens: Vec<&Token> = self.tokens[start..self.at].iter().filter(|t| !matches!(t.kind, T::Doc(..))).collect();
        let word = |k: usize| match tokens.get(k).map(|t| &t.kind) {
            Some(T::Ident(w)) => Some(w.as_str()),
            _ => None,
        };
        let first = usize::from(word(0) == Some("replace"));
        let Some(written) = word(first) else { return };
        let known = STATEMENTS
            .iter()
            .find(|s| **s == written)
            .copied()
            .or_else(|| nearest(written, STATEMENTS).and_then(|near| STATEMENTS.iter().find(|s| **s == near).copied()));
        let keyword = known.unwrap_or("param");
        let named = |k: usize| {
            tokens.get(k).and_then(|t| if let T::Ident(w) = &t.kind { Some(Name { text: w.clone(), span: t.span }) } else { None })
        };
        let names: Vec<Name> = match keyword {
            "mix" => (first + 1..tokens.len())
                .filter(|&k| matches!(tokens.get(k + 1).map(|t| &t.kind), Some(T::Punct('=', _))))
                .filter_map(named)
                .collect(),
            "remove" | "gravity" | "assume" => Vec::new(),
            _ => named(first + 1).into_iter().collect(),
        };
        for name in names {
            let span = name.span;
            rig.statements.push(Statement { name, keyword, doc: String::new(), action: Action::Add, kind: Kind::Broken, span });
        }
        if matches!(keyword, "equation" | "gravity" | "assume") {
            let span = tokens[0].span;
            rig.statements.push(Statement {
                name: Name { text: keyword.to_owned(), span },
                keyword,
                doc: String::new(),
                action: Action::Add,
                kind: Kind::Broken,
                span,
            });
        }
    }

    pub(super) fn statement(&mut self, mut doc: String, rig: &mut RigItem) -> Parsed<()> {
        let start = self.peek().span;
        if self.eat_word("remove") {
            loop {
                let first = self.name("the name to remove")?;
                let removal = match &self.peek().kind {
                    T::Ident(_) => Removal { keyword: Some(first), name: self.name("the name to remove")? },
                    _ => Removal { keyword: None, name: first },
                };
                rig.removals.push(removal);
                if !self.eat(',') {
                    break;
                }
            }
            self.expect(';')?;
            return Ok(());
        }
        let action = if self.eat_word("replace") { Action::Replace } else { Action::Add };
        let word = self.name("a statement")?;
        let Some(keyword) = STATEMENTS.iter().find(|s| **s == word.text) else {
            let mut d = Diagnostic::error("E0112", format!("there is no statement `{}`", word.text), word.span, "unknown statement");
            let other = match word.text.as_str() {
                "joint" | "revolute" | "prismatic" | "hinge" => "a joint is a step of a frame: `frame NAME = PARENT.rotate(axis, angle);`",
                "link" | "mass" | "inertia" | "rigid" => {
                    "masses stand in bodies: `body NAME on FRAME { mass m; at (x, y, z); inertia diag(..); }`"
                }
                "parameter" | "let" | "var" | "parameters" => "did you mean `param`?",
                "constant" => "did you mean `const`?",
                "coordinate" | "dof" | "state" => "did you mean `coord`?",
                "sensor" | "measure" | "measurement" => "what is measured is an `output`, or an `encoder` of a coordinate",
                "motor" | "rotor" | "thruster" => "declare an `input`, perhaps an `actuator`, and a `force` or `torque` that it gives",
                "damping" | "drag" => "on a coordinate write `friction`, between two points `damper`",
                "assumption" | "neglect" | "set" => "assumptions stand in a block: `assume { neglect coriolis; }`",
                "equilibrium" | "operating_point" => "did you mean `trim`?",
                _ => "",
            };
            d = match nearest(&word.text, STATEMENTS) {
                _ if !other.is_empty() => d.help(other),
                Some(near) => d.help(format!("did you mean `{near}`?")),
                None => d.help(format!("statements are {}", STATEMENTS.join(", "))),
            };
            self.diagnostics.push(d);
            return Err(Reported);
        };
        let (name, kind) = self.statement_body(keyword, &word)?;
        let span = self.from(start);
        let trailing = self.trailing();
        if doc.is_empty() {
            doc = trailing;
        }
        rig.statements.push(Statement { name, keyword, doc, action, kind, span });
        Ok(())
    }

    /// A comment behind the statement on its last line.
    pub(super) fn trailing(&mut self) -> String {
        match self.tokens.get(self.at) {
            Some(Token { kind: T::Doc(text, true), .. }) => {
                let text = text.clone();
                self.at += 1;
                text
            }
            _ => String::new(),
        }
    }
}
