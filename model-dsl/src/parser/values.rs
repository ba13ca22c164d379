//! Ranges, values with priors and bounds, and units.

use super::{AFTER_VALUES, Parsed, Parser};
use crate::ast::{Expr, Name, UnitExpr, Value};
use crate::rig::Span;
use crate::token::Kind as T;

impl Parser<'_> {
    pub(super) fn range(&mut self) -> Parsed<(Expr, Expr)> {
        let lo = self.expr()?;
        if !self.is_range() {
            return self.unexpected("`..` between the limits");
        }
        self.next();
        self.next();
        Ok((lo, self.expr()?))
    }

    pub(super) fn value(&mut self) -> Parsed<Value> {
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

    pub(super) fn unit(&mut self) -> Parsed<UnitExpr> {
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

    pub(super) fn unit_factor(&mut self, sign: i16, unit: &mut UnitExpr) -> Parsed<()> {
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

    /// A unit behind a number: glued to it, one word, `%`, or in brackets.
    pub(super) fn literal_unit(&mut self, place: &Span, suffix: String) -> Parsed<Option<UnitExpr>> {
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
