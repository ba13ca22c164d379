//! Trims: as many unknowns as equations.

use super::{Resolver, plural};
use crate::ast::{Expr as Ast, ExprKind, Name, Statement};
use crate::diagnostic::Diagnostic;
use crate::quantity::{Allowed, Checker};
use crate::rig::*;
use crate::units::Dimension;
use std::collections::BTreeSet;

impl Resolver<'_> {
    fn operand(&mut self, name: &Name, suffix: Option<&Name>) -> Option<(Symbol, Dimension)> {
        let ast =
            Ast::leaf(ExprKind::Name(name.clone(), suffix.cloned()), suffix.map_or(name.span, |s| Span { end: s.span.end, ..name.span }));
        // to be part of a trim is no use of a name
        let mut unused = BTreeSet::new();
        let q = Checker { used: &mut unused, ..self.checker() }.check(&ast, Allowed::Everything)?;
        let Expr::Symbol(symbol) = q.expr else { return None };
        // a trim is about commands, not about what comes out of an actuator
        let symbol = match symbol {
            Symbol::Actuator(k) => self.rig.inputs.iter().position(|i| i.name == self.rig.actuators[k].name).map_or(symbol, Symbol::Input),
            other => other,
        };
        if !matches!(symbol, Symbol::Coordinate(_) | Symbol::Rate(_) | Symbol::Input(_) | Symbol::Mixed(..)) {
            let mut d = Diagnostic::error(
                "E0206",
                format!("`{}` cannot be part of a trim", name.text),
                name.span,
                "not a coordinate, rate or input",
            );
            if let Some(m) = self.scope.names.get(&name.text) {
                d = d.also(m.span, format!("{}, declared here", m.what));
            }
            self.diagnostics
                .push(d.help("a trim fixes or solves for coordinates, rates (`psi.dot`) and inputs; it takes parameters at their values"));
            return None;
        }
        Some((symbol, q.dimension.unwrap_or_default()))
    }

    pub(super) fn trim(&mut self, s: &Statement, fixed: &[(Name, Option<Name>, Ast)], zero: &[Name], solve: &[(Name, Option<Name>)]) {
        let before = self.diagnostics.len();
        let mut out =
            Trim { name: s.name.text.clone(), fixed: Vec::new(), zero: self.coordinates(zero), solve: Vec::new(), span: s.name.span };
        for (name, suffix, value) in fixed {
            if let Some((symbol, dimension)) = self.operand(name, suffix.as_ref()) {
                let text = suffix.as_ref().map_or_else(|| name.text.clone(), |s| format!("{}.{}", name.text, s.text));
                let checked = self.expect(value, dimension, &format!("`{text}`"), Allowed::Parameters);
                if matches!(symbol, Symbol::Coordinate(_)) && dimension == Dimension::NONE {
                    self.many_turns(value, &checked);
                }
                if out.fixed.iter().any(|(s, _)| *s == symbol) {
                    self.diagnostics.push(
                        Diagnostic::error("E0311", format!("`{text}` is fixed twice"), name.span, "again here")
                            .help("keep one of its values"),
                    );
                }
                out.fixed.push((symbol, checked));
            }
        }
        for (name, suffix) in solve {
            if let Some((symbol, _)) = self.operand(name, suffix.as_ref()) {
                if out.fixed.iter().any(|(s, _)| *s == symbol) || out.solve.contains(&symbol) {
                    let what = if out.solve.contains(&symbol) { "solved for twice" } else { "both fixed and solved for" };
                    let d = Diagnostic::error("E0311", format!("`{}` is {what}", name.text), name.span, "solved for here");
                    self.diagnostics.push(d.help("take it out of one of them"));
                }
                out.solve.push(symbol);
            }
        }
        for (k, name) in zero.iter().enumerate() {
            if zero[..k].iter().any(|b| b.text == name.text) {
                self.diagnostics.push(
                    Diagnostic::error("E0311", format!("`{}` stands under `zero` twice", name.text), name.span, "again here")
                        .help("once is enough"),
                );
            }
        }
        for (&i, name) in out.zero.iter().zip(zero) {
            if self.rig.coordinates[i].prescribed {
                let d = Diagnostic::error(
                    "E0311",
                    format!("`{}` is prescribed: its acceleration is given, not solved for", name.text),
                    name.span,
                    "here",
                );
                self.diagnostics.push(d.help("take it out of `zero`"));
            }
        }
        if self.diagnostics.len() == before && self.scope.lost.is_empty() && out.zero.len() != out.solve.len() {
            let (e, u) = (out.zero.len(), out.solve.len());
            let (hint, label) = if e > u {
                ("solve for more coordinates, rates or inputs, or let an acceleration stay", "more equations than unknowns")
            } else {
                ("name more coordinates under `zero`, or fix some unknowns", "more unknowns than equations")
            };
            let message =
                format!("the trim `{}` has {u} unknown{} (`solve`) and {e} equation{} (`zero`)", s.name.text, plural(u), plural(e));
            self.diagnostics.push(Diagnostic::error("E0311", message, s.name.span, label).help(hint));
        }
        if let Some(before) = self.rig.trims.iter().find(|t| t.name == out.name) {
            let d = Diagnostic::error("E0202", format!("the trim `{}` is declared twice", out.name), s.name.span, "again here");
            self.diagnostics.push(d.also(before.span, "first here").help("rename one of them"));
        }
        self.rig.trims.push(out);
    }
}
