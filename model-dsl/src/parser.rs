//! Recursive descent from tokens to the syntax tree. After an error it goes on behind the next `;` or `}`,
//! so that all errors of a file come at once. Nesting is limited, so that no text overflows the stack.

use crate::ast::{
    Action, Along, Assume, AxisExpr, AxisOrVector, BodyEntry, Entry, Expr, ExprKind, File, Kind, Name, Removal, RigItem, Statement, Step,
    UnitExpr, Value, Vector,
};
use crate::diagnostic::{Diagnostic, nearest};
use crate::rig::{BinaryOp, EnergyKind, Span};
use crate::token::{Kind as T, Token};

/// Deepest nesting of expressions.
const DEPTH: u32 = 64;
/// Longest sum or product.
const LENGTH: u32 = 400;
/// Most levels of an expression's tree: what walks over it is recursive.
const TREE: u32 = 500;

/// Words that start a statement.
const STATEMENTS: [&str; 26] = [
    "param",
    "const",
    "derived",
    "lump",
    "coord",
    "prescribed",
    "frame",
    "body",
    "gravity",
    "input",
    "actuator",
    "mix",
    "force",
    "torque",
    "spring",
    "damper",
    "friction",
    "potential",
    "kinetic",
    "dissipation",
    "equation",
    "encoder",
    "output",
    "trim",
    "assume",
    "remove",
];

/// Words that may stand behind a number; any other word there is taken for a unit.
const AFTER_VALUES: [&str; 16] =
    ["fixed", "in", "per", "width", "speed", "zero", "wrapped", "value", "along", "against", "about", "at", "on", "to", "of", "for"];

/// Parses the tokens of one file.
pub fn parse(tokens: &[Token], diagnostics: &mut Vec<Diagnostic>) -> File {
    let mut parser = Parser { tokens, at: 0, diagnostics, depth: 0 };
    parser.file()
}

/// Parses a single expression; the whole of the tokens must be one.
pub fn parse_expression(tokens: &[Token], diagnostics: &mut Vec<Diagnostic>) -> Option<Expr> {
    let mut parser = Parser { tokens, at: 0, diagnostics, depth: 0 };
    let expr = parser.expr().ok()?;
    if matches!(parser.peek().kind, T::End) { Some(expr) } else { parser.unexpected("the end").map_or(None, |()| None) }
}

/// Parses a unit; the whole of the tokens must be one.
pub fn parse_unit(tokens: &[Token], diagnostics: &mut Vec<Diagnostic>) -> Option<UnitExpr> {
    let mut parser = Parser { tokens, at: 0, diagnostics, depth: 0 };
    let unit = parser.unit().ok()?;
    if matches!(parser.peek().kind, T::End) { Some(unit) } else { parser.unexpected("the end").map_or(None, |()| None) }
}

/// An error that was reported already.
struct Reported;

type Parsed<T> = Result<T, Reported>;

struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    diagnostics: &'a mut Vec<Diagnostic>,
    depth: u32,
}

impl Parser<'_> {
    fn peek_at(&self, k: usize) -> &Token {
        // documentation may stand anywhere; it is seen only by those who look for it
        self.tokens[self.at.min(self.tokens.len() - 1)..]
            .iter()
            .filter(|t| !matches!(t.kind, T::Doc(..)))
            .nth(k)
            .unwrap_or(&self.tokens[self.tokens.len() - 1])
    }

    fn peek(&self) -> &Token {
        self.peek_at(0)
    }

    fn next(&mut self) -> Token {
        while matches!(self.tokens.get(self.at).map(|t| &t.kind), Some(T::Doc(..))) {
            self.at += 1;
        }
        let token = self.tokens[self.at.min(self.tokens.len() - 1)].clone();
        if !matches!(token.kind, T::End) {
            self.at += 1;
        }
        token
    }

    fn previous_end(&self) -> Span {
        self.tokens[..self.at].iter().rev().find(|t| !matches!(t.kind, T::Doc(..))).map_or_else(Span::default, |t| t.span)
    }

    fn from(&self, start: Span) -> Span {
        let end = self.previous_end();
        Span { file: start.file, start: start.start, end: end.end.max(start.end) }
    }

    fn is(&self, c: char) -> bool {
        matches!(self.peek().kind, T::Punct(p, _) if p == c)
    }

    fn is_word(&self, word: &str) -> bool {
        matches!(&self.peek().kind, T::Ident(w) if w == word)
    }

    fn eat(&mut self, c: char) -> bool {
        let found = self.is(c);
        if found {
            self.next();
        }
        found
    }

    fn eat_word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        if found {
            self.next();
        }
        found
    }

    fn is_range(&self) -> bool {
        matches!(self.peek().kind, T::Punct('.', true)) && matches!(self.peek_at(1).kind, T::Punct('.', _))
    }

    fn is_prior(&self) -> bool {
        matches!(self.peek().kind, T::Punct('+', true)) && matches!(self.peek_at(1).kind, T::Punct('-', _))
    }

    fn unexpected<X>(&mut self, wanted: &str) -> Parsed<X> {
        if !matches!(self.peek().kind, T::Bad) {
            let d = self.expected(wanted);
            self.diagnostics.push(d);
        }
        Err(Reported)
    }

    fn expected(&self, wanted: &str) -> Diagnostic {
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

    fn expect(&mut self, c: char) -> Parsed<Span> {
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
    fn closed(&mut self, open: Span) -> bool {
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

    fn expect_word(&mut self, word: &str) -> Parsed<()> {
        if self.eat_word(word) { Ok(()) } else { self.unexpected(&format!("`{word}`")) }
    }

    fn name(&mut self, what: &str) -> Parsed<Name> {
        match &self.peek().kind {
            T::Ident(_) => {
                let token = self.next();
                let T::Ident(text) = token.kind else { return self.unexpected(what) };
                Ok(Name { text, span: token.span })
            }
            _ => self.unexpected(what),
        }
    }

    fn names(&mut self, what: &str) -> Parsed<Vec<Name>> {
        let mut names = vec![self.name(what)?];
        while self.eat(',') {
            names.push(self.name(what)?);
        }
        Ok(names)
    }

    /// Documentation that stands right here.
    fn docs(&mut self) -> String {
        let mut lines = Vec::new();
        while let Some(Token { kind: T::Doc(line, _), .. }) = self.tokens.get(self.at) {
            lines.push(line.clone());
            self.at += 1;
        }
        lines.join("\n")
    }

    /// Skips to behind the `;` or `}` that ends the statement which started at token `start`.
    fn recover(&mut self, start: usize) {
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

    fn file(&mut self) -> File {
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

    fn use_item(&mut self) -> Parsed<Name> {
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

    fn rig(&mut self, doc: String) -> Parsed<RigItem> {
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
    fn lost(&mut self, start: usize, rig: &mut RigItem) {
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

    fn statement(&mut self, mut doc: String, rig: &mut RigItem) -> Parsed<()> {
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
    fn trailing(&mut self) -> String {
        match self.tokens.get(self.at) {
            Some(Token { kind: T::Doc(text, true), .. }) => {
                let text = text.clone();
                self.at += 1;
                text
            }
            _ => String::new(),
        }
    }

    fn statement_body(&mut self, keyword: &str, word: &Name) -> Parsed<(Name, Kind)> {
        Ok(match keyword {
            "param" | "const" => {
                let name = self.name("the parameter's name")?;
                if !self.is(':') {
                    return self.unexpected("`:` and the unit (`: kg`, `: 1` for a plain number)");
                }
                self.next();
                let unit = self.unit()?;
                self.expect('=')?;
                let value = self.value()?;
                self.expect(';')?;
                (name, Kind::Param(unit, value, keyword == "const"))
            }
            "derived" | "lump" => {
                let name = self.name("a name")?;
                let unit = if self.eat(':') { Some(self.unit()?) } else { None };
                self.expect('=')?;
                let definition = self.expr()?;
                let own = if keyword == "lump" && self.eat_word("value") { Some(self.value()?) } else { None };
                self.expect(';')?;
                (name, Kind::Define(unit, definition, own, keyword == "lump"))
            }
            "coord" | "prescribed" => {
                let name = self.name("the coordinate's name")?;
                self.expect(':')?;
                let unit = self.unit()?;
                let trajectory = if keyword == "prescribed" && self.eat('=') { Some(self.expr()?) } else { None };
                let range = if self.eat_word("in") { Some(self.range()?) } else { None };
                self.expect(';')?;
                (name, Kind::Coord(unit, range, trajectory, keyword == "prescribed"))
            }
            "frame" => {
                let name = self.name("the frame's name")?;
                self.expect('=')?;
                let parent = self.name("the parent frame (`ground` or another frame)")?;
                let mut steps = Vec::new();
                while self.eat('.') {
                    steps.push(self.step()?);
                }
                self.expect(';')?;
                (name, Kind::Frame(parent, steps))
            }
            "body" => {
                let name = self.name("the body's name")?;
                self.expect_word("on")?;
                let frame = self.name("a frame")?;
                let open = self.expect('{')?;
                let mut entries = Vec::new();
                while !self.closed(open) {
                    entries.push(self.body_entry()?);
                }
                self.eat(';');
                (name, Kind::Body(frame, entries))
            }
            "gravity" => {
                let value = self.expr()?;
                let along = if self.eat_word("along") {
                    Some(match self.axis()? {
                        AxisExpr::Principal(k, negative) => AxisOrVector::Axis(k, negative),
                        AxisExpr::Vector(v) => AxisOrVector::Vector(v),
                    })
                } else {
                    None
                };
                self.expect(';')?;
                (word.clone(), Kind::Gravity(value, along))
            }
            "input" => {
                let name = self.name("the input's name")?;
                self.expect(':')?;
                let unit = self.unit()?;
                let limits = if self.eat_word("in") { Some(self.range()?) } else { None };
                let path = self.optional_block()?;
                (name, Kind::Input(unit, limits, path))
            }
            "actuator" => {
                let name = self.name("the actuator's name")?;
                self.expect(':')?;
                let unit = self.unit()?;
                self.expect('=')?;
                let map = self.expr()?;
                let path = self.optional_block()?;
                (name, Kind::Actuator(unit, map, path))
            }
            "mix" => {
                let open = self.expect('{')?;
                let mut rows = Vec::new();
                while !self.closed(open) {
                    let name = self.name("a new input's name")?;
                    self.expect('=')?;
                    rows.push((name, self.expr()?));
                    self.expect(';')?;
                }
                self.eat(';');
                (word.clone(), Kind::Mix(rows))
            }
            "force" => {
                let name = self.name("the force's name")?;
                self.expect_word("on")?;
                let frame = self.name("a frame")?;
                let at = if self.eat_word("at") { Some(self.vector()?) } else { None };
                self.expect(':')?;
                let vector = self.vector()?;
                let (axes, against) = self.axes_and_against()?;
                self.expect(';')?;
                (name, Kind::Force(frame, at, vector, axes, against))
            }
            "torque" => {
                let name = self.name("the torque's name")?;
                self.expect_word("on")?;
                let place = self.name("a frame or a coordinate")?;
                self.expect(':')?;
                if self.is('(') && self.looks_like_vector() {
                    let vector = self.vector()?;
                    let (axes, against) = self.axes_and_against()?;
                    self.expect(';')?;
                    (name, Kind::Torque(place, vector, axes, against))
                } else {
                    let value = self.expr()?;
                    self.expect(';')?;
                    (name, Kind::Generalized(place, value))
                }
            }
            "spring" | "damper" => {
                let name = self.name("a name")?;
                let along = self.along()?;
                let entries = self.block()?;
                (name, if keyword == "spring" { Kind::Spring(along, entries) } else { Kind::Damper(along, entries) })
            }
            "friction" => {
                let name = self.name("a coordinate, or a name and `on`")?;
                let of = if self.eat_word("on") { self.expr()? } else { Expr::leaf(ExprKind::Name(name.clone(), None), name.span) };
                let entries = self.block()?;
                (name, Kind::Friction(of, entries))
            }
            "potential" | "kinetic" | "dissipation" => {
                let name = self.name("a name")?;
                self.expect(':')?;
                let value = self.expr()?;
                self.expect(';')?;
                let kind = match keyword {
                    "potential" => EnergyKind::Potential,
                    "kinetic" => EnergyKind::Kinetic,
                    _ => EnergyKind::Dissipation,
                };
                (name, Kind::Function(kind, value))
            }
            "equation" => {
                let lhs = self.expr()?;
                self.expect('=')?;
                let rhs = self.expr()?;
                self.expect(';')?;
                (Name { text: "equation".to_owned(), span: lhs.span }, Kind::Equation(lhs, rhs))
            }
            "encoder" => {
                let name = self.name("a coordinate")?;
                self.expect(':')?;
                let counts = self.expr()?;
                let options = self.options()?;
                self.expect(';')?;
                let entry = Entry { key: name.clone(), values: vec![counts], options };
                (name, Kind::Encoder(entry))
            }
            "output" => {
                let name = self.name("the output's name")?;
                self.expect(':')?;
                let unit = self.unit()?;
                self.expect('=')?;
                let value = self.expr()?;
                let path = self.optional_block()?;
                (name, Kind::Output(unit, value, path))
            }
            "trim" => {
                let name = self.name("the trim's name")?;
                (name, self.trim()?)
            }
            _ => {
                let open = self.expect('{')?;
                let mut list = Vec::new();
                while !self.closed(open) {
                    let start = self.peek().span;
                    let assumption = self.assumption()?;
                    list.push((assumption, self.from(start)));
                }
                self.eat(';');
                (word.clone(), Kind::Assume(list))
            }
        })
    }

    fn trim(&mut self) -> Parsed<Kind> {
        let open = self.expect('{')?;
        let (mut fixed, mut zero, mut solve) = (Vec::new(), Vec::new(), Vec::new());
        while !self.closed(open) {
            if self.is_word("zero") && !matches!(self.peek_at(1).kind, T::Punct('=' | '.', _)) {
                self.next();
                zero.extend(self.names("a coordinate whose acceleration vanishes")?);
            } else if self.is_word("solve") && !matches!(self.peek_at(1).kind, T::Punct('=' | '.', _)) {
                self.next();
                loop {
                    solve.push(self.dotted()?);
                    if !self.eat(',') {
                        break;
                    }
                }
            } else {
                let (name, suffix) = self.dotted()?;
                self.expect('=')?;
                let value = self.expr()?;
                fixed.push((name, suffix, value));
            }
            self.expect(';')?;
        }
        self.eat(';');
        Ok(Kind::Trim(fixed, zero, solve))
    }

    fn dotted(&mut self) -> Parsed<(Name, Option<Name>)> {
        let name = self.name("a coordinate, rate or input")?;
        let suffix = if self.is('.') && !self.is_range() {
            self.next();
            Some(self.name("`dot`")?)
        } else {
            None
        };
        Ok((name, suffix))
    }

    fn assumption(&mut self) -> Parsed<Assume> {
        if self.eat_word("set") {
            let name = self.name("a parameter")?;
            self.expect('=')?;
            let value = self.expr()?;
            self.expect(';')?;
            return Ok(Assume::Set(name, value));
        }
        if self.eat_word("inertia") {
            self.expect_word("diag")?;
            let (entries, _) = self.vector()?;
            self.expect(';')?;
            return Ok(Assume::Diagonal(entries));
        }
        if !self.eat_word("neglect") {
            return self.unexpected("`neglect`, `set` or `inertia`");
        }
        let what = self.name("what is neglected")?;
        if what.text == "inertia" && self.eat('[') {
            let row = self.name("a coordinate")?;
            self.expect(',')?;
            let column = self.name("a coordinate")?;
            self.expect(']')?;
            self.expect(';')?;
            return Ok(Assume::NeglectInertia(row, column));
        }
        let of = if self.eat_word("of") { self.names("a body")? } else { Vec::new() };
        let within = if self.eat_word("in") { self.names("a coordinate")? } else { Vec::new() };
        self.expect(';')?;
        Ok(Assume::Neglect(what, of, within))
    }

    fn along(&mut self) -> Parsed<Along> {
        if self.eat_word("on") {
            return Ok(Along::On(self.expr()?));
        }
        self.expect_word("from")?;
        let from = self.name("a frame")?;
        self.expect_word("at")?;
        let p = self.vector()?;
        self.expect_word("to")?;
        let to = self.name("a frame")?;
        self.expect_word("at")?;
        let q = self.vector()?;
        Ok(Along::Between(Box::new(((from, p), (to, q)))))
    }

    fn axes_and_against(&mut self) -> Parsed<(Option<Name>, Option<Name>)> {
        let (mut axes, mut against) = (None, None);
        loop {
            if self.eat_word("in") {
                axes = Some(self.name("a frame")?);
            } else if self.eat_word("against") {
                against = Some(self.name("a frame")?);
            } else {
                return Ok((axes, against));
            }
        }
    }

    fn body_entry(&mut self) -> Parsed<BodyEntry> {
        let entry = if self.eat_word("mass") {
            BodyEntry::Mass(self.expr()?)
        } else if self.eat_word("at") {
            BodyEntry::At(self.vector()?)
        } else if self.is_word("inertia") {
            let start = self.next().span;
            let diagonal = self.eat_word("diag");
            let (mut entries, span) = self.vector()?;
            let wanted = if diagonal { 3 } else { 6 };
            if entries.len() != wanted {
                let what = if diagonal { "diag(I_xx, I_yy, I_zz)" } else { "(I_xx, I_yy, I_zz, I_xy, I_xz, I_yz)" };
                self.diagnostics.push(
                    Diagnostic::error(
                        "E0111",
                        format!("an inertia tensor has {wanted} entries here, this has {}", entries.len()),
                        span,
                        "entries",
                    )
                    .help(format!("write {what}")),
                );
                return Err(Reported);
            }
            while entries.len() < 6 {
                entries.push(Expr::leaf(ExprKind::Number(0.0, None), span));
            }
            let mut origin = false;
            if self.eat_word("about") {
                if self.eat_word("origin") {
                    origin = true;
                } else if !self.eat_word("center") {
                    return self.unexpected("`origin` or `center`");
                }
            }
            BodyEntry::Inertia(entries, origin, self.from(start))
        } else {
            return self.unexpected("`mass`, `at` or `inertia`");
        };
        self.expect(';')?;
        Ok(entry)
    }

    fn optional_block(&mut self) -> Parsed<Vec<Entry>> {
        if self.is('{') {
            return self.block();
        }
        self.expect(';')?;
        Ok(Vec::new())
    }

    fn block(&mut self) -> Parsed<Vec<Entry>> {
        let open = self.expect('{')?;
        let mut entries = Vec::new();
        while !self.closed(open) {
            let key = self.name("an entry")?;
            let mut values = vec![self.expr()?];
            if self.is_range() {
                self.next();
                self.next();
                values.push(self.expr()?);
            }
            while self.eat(',') {
                values.push(self.expr()?);
            }
            let options = self.options()?;
            self.expect(';')?;
            entries.push(Entry { key, values, options });
        }
        self.eat(';');
        Ok(entries)
    }

    fn options(&mut self) -> Parsed<Vec<(Name, Option<Expr>)>> {
        let mut options = Vec::new();
        while matches!(self.peek().kind, T::Ident(_)) {
            let key = self.name("an option")?;
            let value = match key.text.as_str() {
                "wrapped" => None,
                "zero" => {
                    self.expect_word("at")?;
                    Some(self.expr()?)
                }
                "width" | "speed" => Some(self.expr()?),
                _ => {
                    self.diagnostics.push(
                        Diagnostic::error("E0111", format!("`{}` is no option here", key.text), key.span, "unknown option")
                            .help("options are `width`, `speed` (friction), `zero at`, `wrapped` (encoder)"),
                    );
                    return Err(Reported);
                }
            };
            options.push((key, value));
        }
        Ok(options)
    }

    fn step(&mut self) -> Parsed<Step> {
        let name = self.name("`rotate` or `translate`")?;
        match name.text.as_str() {
            "rotate" => {
                self.expect('(')?;
                let axis = self.axis()?;
                self.expect(',')?;
                let angle = self.expr()?;
                self.expect(')')?;
                Ok(Step::Rotate(axis, angle))
            }
            "translate" => {
                let (components, _) = self.vector()?;
                let span = self.from(name.span);
                if components.len() != 3 {
                    self.diagnostics.push(
                        Diagnostic::error(
                            "E0111",
                            format!("a translation has three components, this has {}", components.len()),
                            span,
                            "here",
                        )
                        .help("write translate(x, y, z)"),
                    );
                    return Err(Reported);
                }
                Ok(Step::Translate(components, span))
            }
            other => {
                self.diagnostics.push(
                    Diagnostic::error(
                        "E0111",
                        format!("a frame is reached by `rotate` and `translate`, not by `{other}`"),
                        name.span,
                        "unknown step",
                    )
                    .help("write .rotate(axis, angle) or .translate(x, y, z)"),
                );
                Err(Reported)
            }
        }
    }

    fn axis(&mut self) -> Parsed<AxisExpr> {
        if self.is('(') {
            return Ok(AxisExpr::Vector(self.vector()?));
        }
        let negative = self.eat('-');
        let name = self.name("an axis: x, y, z, -x, -y, -z or (a, b, c)")?;
        match ["x", "y", "z"].iter().position(|a| *a == name.text) {
            Some(index) => Ok(AxisExpr::Principal(index, negative)),
            None => {
                self.diagnostics.push(
                    Diagnostic::error(
                        "E0111",
                        format!("`{}` is no axis", name.text),
                        name.span,
                        if ["X", "Y", "Z"].contains(&name.text.as_str()) { "axes are written small" } else { "expected an axis" },
                    )
                    .help("axes are x, y, z, -x, -y, -z or (a, b, c)"),
                );
                Err(Reported)
            }
        }
    }

    fn vector(&mut self) -> Parsed<Vector> {
        let start = self.expect('(')?;
        let mut items = Vec::new();
        if !self.is(')') {
            items.push(self.expr()?);
            while self.eat(',') {
                items.push(self.expr()?);
            }
        }
        self.expect(')')?;
        Ok((items, self.from(start)))
    }

    /// `(a, b, ..)` with a comma outside of inner parentheses.
    fn looks_like_vector(&self) -> bool {
        let mut depth = 0;
        for k in 0.. {
            match self.peek_at(k).kind {
                T::Punct('(', _) => depth += 1,
                T::Punct(')', _) => {
                    depth -= 1;
                    if depth == 0 {
                        return false;
                    }
                }
                T::Punct(',', _) if depth == 1 => return true,
                T::Punct(';' | '{' | '}', _) | T::End => return false,
                _ => {}
            }
            if k > 4096 {
                return false;
            }
        }
        false
    }

    fn range(&mut self) -> Parsed<(Expr, Expr)> {
        let lo = self.expr()?;
        if !self.is_range() {
            return self.unexpected("`..` between the limits");
        }
        self.next();
        self.next();
        Ok((lo, self.expr()?))
    }

    fn value(&mut self) -> Parsed<Value> {
        let value = self.expr()?;
        let mut out = Value { value, prior: None, bounds: None, fixed: false, per_record: false };
        loop {
            if self.is_prior() {
                self.next();
                self.next();
                out.prior = Some(self.expr()?);
            } else if self.eat_word("in") {
                out.bounds = Some(self.range()?);
            } else if self.eat_word("fixed") {
                out.fixed = true;
            } else if self.eat_word("per") {
                self.expect_word("record")?;
                out.per_record = true;
            } else {
                return Ok(out);
            }
        }
    }

    fn unit(&mut self) -> Parsed<UnitExpr> {
        let start = self.peek().span;
        let mut unit = UnitExpr { factors: Vec::new(), text: String::new(), span: start };
        let mut sign = 1;
        loop {
            self.unit_factor(sign, &mut unit)?;
            if self.is('*') {
                self.next();
                unit.text.push('*');
                sign = 1;
            } else if self.is('/') {
                self.next();
                unit.text.push('/');
                sign = -1;
            } else {
                break;
            }
        }
        unit.span = self.from(start);
        Ok(unit)
    }

    fn unit_factor(&mut self, sign: i16, unit: &mut UnitExpr) -> Parsed<()> {
        if self.eat('(') {
            // kg/(m*s)
            unit.text.push('(');
            let mut inner = sign;
            loop {
                self.nested(|p| p.unit_factor(inner, unit))?;
                if self.eat('*') {
                    unit.text.push('*');
                    inner = sign;
                } else if self.eat('/') {
                    unit.text.push('/');
                    inner = -sign;
                } else {
                    break;
                }
            }
            unit.text.push(')');
            self.expect(')')?;
            return Ok(());
        }
        let token = self.peek().clone();
        let name = match token.kind {
            T::Ident(text) => text,
            T::Number(x, ref suffix) if x == 1.0 && suffix.is_empty() => "1".to_owned(),
            T::Punct('%', _) => "percent".to_owned(),
            _ => return self.unexpected("a unit, as in `kg`, `N*m*s`, `m/s^2`, or `1`"),
        };
        self.next();
        unit.text.push_str(if name == "percent" { "%" } else { &name });
        let mut exponent: i16 = 1;
        if self.eat('^') {
            let negative = self.eat('-');
            match self.peek().kind {
                T::Number(x, ref suffix) if x.fract() == 0.0 && x <= 12.0 && suffix.is_empty() => {
                    exponent = if negative { -(x as i16) } else { x as i16 };
                    self.next();
                    unit.text.push_str(&format!("^{exponent}"));
                }
                _ => return self.unexpected("a whole number as exponent of a unit"),
            }
        }
        unit.factors.push((Name { text: name, span: token.span }, sign * exponent));
        Ok(())
    }

    fn expr(&mut self) -> Parsed<Expr> {
        self.nested(Self::sum)
    }

    fn nested<X>(&mut self, parse: impl FnOnce(&mut Self) -> Parsed<X>) -> Parsed<X> {
        if self.depth >= DEPTH {
            let span = self.peek().span;
            self.diagnostics.push(
                Diagnostic::error("E0113", format!("nested more than {DEPTH} deep"), span, "too deep here")
                    .help("name parts of it with `derived` or `lump`"),
            );
            return Err(Reported);
        }
        self.depth += 1;
        let result = parse(self);
        self.depth -= 1;
        result
    }

    fn limit(&mut self, length: u32) -> Parsed<()> {
        if length < LENGTH {
            return Ok(());
        }
        let span = self.peek().span;
        self.diagnostics.push(
            Diagnostic::error("E0113", format!("more than {LENGTH} terms in one expression"), span, "too long here")
                .help("name parts of it with `derived` or `lump`"),
        );
        Err(Reported)
    }

    fn binary(&mut self, op: BinaryOp, a: Expr, b: Expr) -> Parsed<Expr> {
        let expr = binary(op, a, b);
        if expr.depth > TREE {
            self.diagnostics.push(
                Diagnostic::error("E0113", format!("an expression of more than {TREE} levels"), expr.span, "too deep")
                    .help("name parts of it with `derived` or `lump`"),
            );
            return Err(Reported);
        }
        Ok(expr)
    }

    fn sum(&mut self) -> Parsed<Expr> {
        let mut left = self.product()?;
        let mut terms = 0;
        loop {
            if self.is_prior() {
                return Ok(left);
            }
            let op = if self.is('+') {
                BinaryOp::Add
            } else if self.is('-') {
                BinaryOp::Sub
            } else {
                return Ok(left);
            };
            self.next();
            let right = self.product()?;
            left = self.binary(op, left, right)?;
            terms += 1;
            self.limit(terms)?;
        }
    }

    fn product(&mut self) -> Parsed<Expr> {
        let mut left = self.unary()?;
        let mut factors = 0;
        loop {
            let op = if self.is('*') {
                BinaryOp::Mul
            } else if self.is('/') {
                BinaryOp::Div
            } else {
                return Ok(left);
            };
            self.next();
            if op == BinaryOp::Mul && self.is('*') {
                let span = self.peek().span;
                let span = Span { start: span.start.saturating_sub(1), ..span };
                self.diagnostics
                    .push(Diagnostic::error("E0111", "there is no operator `**`", span, "here").help("a power is written `x^2`"));
                return Err(Reported);
            }
            let right = self.unary()?;
            left = self.binary(op, left, right)?;
            factors += 1;
            self.limit(factors)?;
        }
    }

    fn unary(&mut self) -> Parsed<Expr> {
        if self.is('-') {
            let start = self.next().span;
            let inner = self.nested(Self::unary)?;
            let span = Span { end: inner.span.end, ..start };
            return Ok(Expr { depth: inner.depth + 1, kind: ExprKind::Neg(Box::new(inner)), span });
        }
        let base = self.primary()?;
        if self.eat('^') {
            let exponent = self.nested(Self::unary)?;
            return self.binary(BinaryOp::Pow, base, exponent);
        }
        Ok(base)
    }

    fn primary(&mut self) -> Parsed<Expr> {
        let token = self.peek().clone();
        match token.kind {
            T::Number(x, suffix) => {
                self.next();
                let unit = self.literal_unit(&token.span, suffix)?;
                Ok(Expr::leaf(ExprKind::Number(x, unit), self.from(token.span)))
            }
            T::Ident(text) => {
                self.next();
                let name = Name { text, span: token.span };
                if self.is('(') {
                    let (args, _) = self.nested(Self::vector)?;
                    let depth = 1 + args.iter().map(|a| a.depth).max().unwrap_or(0);
                    return Ok(Expr { kind: ExprKind::Call(name, args), span: self.from(token.span), depth });
                }
                let suffix = if self.is('.') && !self.is_range() {
                    self.next();
                    Some(self.name("`dot` or `ddot`")?)
                } else {
                    None
                };
                Ok(Expr::leaf(ExprKind::Name(name, suffix), self.from(token.span)))
            }
            T::Punct('(', _) => {
                self.next();
                let inner = self.expr()?;
                self.expect(')')?;
                Ok(Expr { span: self.from(token.span), ..inner })
            }
            _ => self.unexpected("a number, a name or `(`"),
        }
    }

    /// A unit behind a number: glued to it, one word, `%`, or in brackets.
    fn literal_unit(&mut self, place: &Span, suffix: String) -> Parsed<Option<UnitExpr>> {
        if !suffix.is_empty() {
            return Ok(Some(UnitExpr { text: suffix.clone(), factors: vec![(Name { text: suffix, span: *place }, 1)], span: *place }));
        }
        if self.eat('[') {
            let unit = self.unit()?;
            self.expect(']')?;
            return Ok(Some(unit));
        }
        let token = self.peek().clone();
        match token.kind {
            T::Punct('%', _) => {
                self.next();
                Ok(Some(UnitExpr {
                    text: "%".to_owned(),
                    factors: vec![(Name { text: "percent".to_owned(), span: token.span }, 1)],
                    span: token.span,
                }))
            }
            T::Ident(word)
                if !token.newline && !AFTER_VALUES.contains(&word.as_str()) && !matches!(self.peek_at(1).kind, T::Punct('(' | '=', _)) =>
            {
                self.next();
                Ok(Some(UnitExpr { text: word.clone(), factors: vec![(Name { text: word, span: token.span }, 1)], span: token.span }))
            }
            _ => Ok(None),
        }
    }
}

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    let span = Span { file: a.span.file, start: a.span.start, end: b.span.end };
    Expr { depth: 1 + a.depth.max(b.depth), kind: ExprKind::Binary(op, Box::new(a), Box::new(b)), span }
}
