//! Equations of motion written directly, and the dimension of each coordinate's row.

use super::Resolver;
use super::terms::{accelerations, mass_row};
use crate::ast::{Expr as Ast, Kind, Statement};
use crate::diagnostic::Diagnostic;
use crate::quantity::{Allowed, Checker};
use crate::rig::*;
use crate::units::{Dimension, Unit};
use std::collections::BTreeSet;

impl Resolver<'_> {
    /// Dimension of each row: N m or N, or what a directly written equation has on its left.
    pub(super) fn row_units(&mut self, statements: &[Statement]) {
        self.row_unit = self
            .rig
            .coordinates
            .iter()
            .map(|c| self.scope.names.get(&c.name).and_then(|m| m.dimension).map(|d| Dimension::TORQUE / d))
            .collect();
        for s in statements {
            if let Kind::Equation(lhs, _) = &s.kind {
                let mut quiet = Vec::new();
                let mut used = BTreeSet::new();
                let q = Checker { scope: &self.scope, sources: self.sources, diagnostics: &mut quiet, used: &mut used }
                    .check(lhs, Allowed::Accelerations);
                if let Some(q) = q
                    && let Some(d) = q.dimension
                    && let Some(row) = accelerations(&q.expr).first()
                {
                    self.row_unit[*row] = Some(d);
                }
            }
        }
    }

    pub(super) fn equations(&mut self, statements: &[Statement]) {
        let list: Vec<(&Statement, &Ast, &Ast)> = statements
            .iter()
            .filter_map(|s| match &s.kind {
                Kind::Equation(l, r) => Some((s, l, r)),
                _ => None,
            })
            .collect();
        if list.is_empty() {
            return;
        }
        let lost = statements.iter().any(|s| s.keyword == "equation" && matches!(s.kind, Kind::Broken)) || !self.scope.lost.is_empty();
        for (s, lhs, rhs) in &list {
            let Some(q) = self.checker().check(lhs, Allowed::Accelerations) else {
                // what stands on the right is checked for names all the same
                self.expect(rhs, None, "the right-hand side", Allowed::Everything);
                continue;
            };
            let found = accelerations(&q.expr);
            let Some(mass) = mass_row(&q.expr) else {
                let d = Diagnostic::error(
                    "E0307",
                    "the left-hand side is a sum of accelerations with coefficients",
                    lhs.span,
                    "not of this form",
                );
                self.diagnostics.push(d.help("write `I * eps.ddot = ..` or `eps.ddot = ..`"));
                continue;
            };
            let taken: Vec<usize> = self.rig.equations.iter().map(|e| e.coordinate).collect();
            let Some(&row) = found.iter().find(|i| !taken.contains(i)) else {
                let mut d = Diagnostic::error("E0307", "this coordinate has its equation already", lhs.span, "a second one");
                if let Some(first) = found.first().and_then(|i| self.rig.equations.iter().find(|e| e.coordinate == *i)) {
                    d = d.also(first.span, "the first one");
                }
                self.diagnostics.push(d.help("one equation for each coordinate; to change one in a variant write `replace equation ..`"));
                continue;
            };
            if self.rig.coordinates[row].prescribed {
                let name = self.rig.coordinates[row].name.clone();
                let d = Diagnostic::error("E0307", format!("`{name}` is prescribed: it has no equation"), lhs.span, "an equation for it");
                self.diagnostics.push(d.help("write `coord` in place of `prescribed`, or remove the equation"));
            }
            let dimension = q.dimension.unwrap_or(Dimension::NONE);
            let value = self.expect(rhs, dimension, "the right-hand side", Allowed::Everything);
            self.rig.equations.push(Equation { coordinate: row, mass, rhs: value, unit: Unit::si(dimension), span: s.span });
        }
        let has = |i: usize| self.rig.equations.iter().any(|e| e.coordinate == i);
        let missing: Vec<&Coordinate> =
            self.rig.coordinates.iter().enumerate().filter(|(i, c)| !c.prescribed && !has(*i)).map(|(_, c)| c).collect();
        if self.rig.equations.len() == list.len()
            && !lost
            && let Some(c) = missing.first()
        {
            let d = Diagnostic::error("E0307", format!("`{}` has no equation", c.name), c.span, "declared here");
            self.diagnostics.push(d.help("where one equation is written directly, every coordinate needs one"));
        }
        let bodies = self.rig.bodies.first().map(|body| (body.span, "bodies", "a body"));
        let gravity = self.rig.gravity.as_ref().map(|gravity| (gravity.span, "gravity", "gravity"));
        let kinetic = self.rig.functions.iter().find(|f| f.kind == EnergyKind::Kinetic);
        let kinetic = kinetic.map(|f| (f.span, "kinetic functions", "a kinetic function"));
        // a mass matrix comes from the left-hand sides, so nothing may add to it, and gravity has no body to pull at
        for (span, what, label) in [bodies, gravity, kinetic].into_iter().flatten() {
            let d = Diagnostic::error("E0307", format!("a rig has either {what} or equations written directly"), span, label);
            self.diagnostics
                .push(d.also(list[0].0.span, "an equation").help(format!("remove the {what}, or let the program derive the equations")));
        }
    }
}
