//! What stands behind the keyword of each statement, and the blocks in braces.

use super::{Parsed, Parser, Reported};
use crate::ast::{Along, Assume, AxisExpr, AxisOrVector, BodyEntry, Entry, Expr, ExprKind, Kind, Name};
use crate::diagnostic::Diagnostic;
use crate::rig::EnergyKind;
use crate::token::Kind as T;

impl Parser<'_> {
    pub(super) fn statement_body(&mut self, keyword: &str, word: &Name) -> Parsed<(Name, Kind)> {
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

    pub(super) fn trim(&mut self) -> Parsed<Kind> {
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

    pub(super) fn dotted(&mut self) -> Parsed<(Name, Option<Name>)> {
        let name = self.name("a coordinate, rate or input")?;
        let suffix = if self.is('.') && !self.is_range() {
            self.next();
            Some(self.name("`dot`")?)
        } else {
            None
        };
        Ok((name, suffix))
    }

    pub(super) fn assumption(&mut self) -> Parsed<Assume> {
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

    pub(super) fn along(&mut self) -> Parsed<Along> {
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

    pub(super) fn axes_and_against(&mut self) -> Parsed<(Option<Name>, Option<Name>)> {
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

    pub(super) fn body_entry(&mut self) -> Parsed<BodyEntry> {
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

    pub(super) fn optional_block(&mut self) -> Parsed<Vec<Entry>> {
        if self.is('{') {
            return self.block();
        }
        self.expect(';')?;
        Ok(Vec::new())
    }

    pub(super) fn block(&mut self) -> Parsed<Vec<Entry>> {
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

    pub(super) fn options(&mut self) -> Parsed<Vec<(Name, Option<Expr>)>> {
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
}
