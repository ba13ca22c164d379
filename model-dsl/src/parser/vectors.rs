//! Steps of frames, axes and vectors.

use super::{Parsed, Parser, Reported};
use crate::ast::{AxisExpr, Step, Vector};
use crate::diagnostic::Diagnostic;
use crate::token::Kind as T;

impl Parser<'_> {
    pub(super) fn step(&mut self) -> Parsed<Step> {
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

    pub(super) fn axis(&mut self) -> Parsed<AxisExpr> {
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

    pub(super) fn vector(&mut self) -> Parsed<Vector> {
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
    pub(super) fn looks_like_vector(&self) -> bool {
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
}
