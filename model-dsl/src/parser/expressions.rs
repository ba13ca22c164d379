//! Expressions: sums, products, powers, calls; nesting is limited.

use super::{DEPTH, LENGTH, Parsed, Parser, Reported, TREE};
use crate::ast::{Expr, ExprKind, Name};
use crate::diagnostic::Diagnostic;
use crate::rig::{BinaryOp, Span};
use crate::token::Kind as T;

impl Parser<'_> {
    pub(super) fn expr(&mut self) -> Parsed<Expr> {
        self.nested(Self::sum)
    }

    pub(super) fn nested<X>(&mut self, parse: impl FnOnce(&mut Self) -> Parsed<X>) -> Parsed<X> {
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

    pub(super) fn limit(&mut self, length: u32) -> Parsed<()> {
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

    pub(super) fn binary(&mut self, op: BinaryOp, a: Expr, b: Expr) -> Parsed<Expr> {
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

    pub(super) fn sum(&mut self) -> Parsed<Expr> {
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

    pub(super) fn product(&mut self) -> Parsed<Expr> {
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

    pub(super) fn unary(&mut self) -> Parsed<Expr> {
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

    pub(super) fn primary(&mut self) -> Parsed<Expr> {
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
}

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    let span = Span { file: a.span.file, start: a.span.start, end: b.span.end };
    Expr { depth: 1 + a.depth.max(b.depth), kind: ExprKind::Binary(op, Box::new(a), Box::new(b)), span }
}
