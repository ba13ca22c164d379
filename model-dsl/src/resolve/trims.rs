//! Trims: as many unknowns as equations.

use super::{Resolver, plural};
use crate::ast::{Expr as Ast, ExprKind, Name, Statement};
use crate::diagnostic::Diagnostic;
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::Unit;

impl Resolver<'_> {
    pub(super) fn operand(&mut self, name: &Name, suffix: Option<&Name>) -> Option<(Symbol, Unit)> {
        let ast = Ast { span: name.span, kind: ExprKind::Name(name.clone(), suffix.cloned()) };
        let q = self.checker().check(&ast, Allowed::Everything)?;
        let Expr::Symbol(symbol) = q.expr else { return None };
        // a trim is about commands, not about what comes out of an actuator
        let symbol = match symbol {
            Symbol::Actuator(k) => self.rig.inputs.iter().position(|i| i.name == self.rig.actuators[k].name).map_or(symbol, Symbol::Input),
            other => other,
        };
        if !matches!(symbol, Symbol::Coordinate(_) | Symbol::Rate(_) | Symbol::Input(_) | Symbol::Mixed(..)) {
            self.diagnostics.push(Diagnostic::error(
                "E0206",
                format!("`{}` cannot be part of a trim", name.text),
                name.span,
                "not a coordinate, rate or input",
            ));
            return None;
        }
        Some((symbol, Unit::si(q.dimension.unwrap_or_default())))
    }

    pub(super) fn trim(&mut self, s: &Statement, fixed: &[(Name, Option<Name>, Ast)], zero: &[Name], solve: &[(Name, Option<Name>)]) {
        let mut out =
            Trim { name: s.name.text.clone(), fixed: Vec::new(), zero: self.coordinates(zero), solve: Vec::new(), span: s.name.span };
        for (name, suffix, value) in fixed {
            if let Some((symbol, unit)) = self.operand(name, suffix.as_ref()) {
                let value = self.expect(value, unit.dimension, &format!("`{}`", name.text), Allowed::Parameters);
                out.fixed.push((symbol, value));
            }
        }
        for (name, suffix) in solve {
            if let Some((symbol, _)) = self.operand(name, suffix.as_ref()) {
                if out.fixed.iter().any(|(s, _)| *s == symbol) {
                    self.diagnostics.push(
                        Diagnostic::error("E0311", format!("`{}` is both fixed and solved for", name.text), name.span, "solved for here")
                            .help("take it out of one of them"),
                    );
                }
                out.solve.push(symbol);
            }
        }
        if out.zero.len() == zero.len() && out.solve.len() == solve.len() && out.zero.len() != out.solve.len() {
            let (e, u) = (out.zero.len(), out.solve.len());
            let hint = if e > u {
                "solve for more coordinates, rates or inputs, or let an acceleration stay"
            } else {
                "name more coordinates under `zero`, or fix some unknowns"
            };
            self.diagnostics.push(
                Diagnostic::error(
                    "E0311",
                    format!("the trim `{}` has {u} unknown{} and {e} equation{}", s.name.text, plural(u), plural(e)),
                    s.name.span,
                    "as many of one as of the other are needed",
                )
                .help(hint),
            );
        }
        if let Some(before) = self.rig.trims.iter().find(|t| t.name == out.name) {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("the trim `{}` is declared twice", out.name), s.name.span, "again here")
                    .also(before.span, "first here"),
            );
        }
        self.rig.trims.push(out);
    }
}
