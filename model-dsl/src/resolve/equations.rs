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
        self.row_unit = self.rig.coordinates.iter().map(|c| Dimension::TORQUE / c.unit.dimension).collect();
        for s in statements {
            if let Kind::Equation(lhs, _) = &s.kind {
                let mut quiet = Vec::new();
                let mut used = BTreeSet::new();
                let q = Checker { scope: &self.scope, diagnostics: &mut quiet, used: &mut used }.check(lhs, Allowed::Accelerations);
                if let Some(q) = q
                    && let Some(d) = q.dimension
                    && let Some(row) = accelerations(&q.expr).first()
                {
                    self.row_unit[*row] = d;
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
        for (s, lhs, rhs) in &list {
            let Some(q) = self.checker().check(lhs, Allowed::Accelerations) else { continue };
            let found = accelerations(&q.expr);
            let Some(mass) = mass_row(&q.expr) else {
                self.diagnostics.push(
                    Diagnostic::error(
                        "E0307",
                        "the left-hand side is a sum of accelerations with coefficients",
                        lhs.span,
                        "not of this form",
                    )
                    .help("write `I * eps.ddot = ..` or `eps.ddot = ..`"),
                );
                continue;
            };
            let taken: Vec<usize> = self.rig.equations.iter().map(|e| e.coordinate).collect();
            let Some(&row) = found.iter().find(|i| !taken.contains(i)) else {
                self.diagnostics.push(
                    Diagnostic::error("E0307", "this coordinate has its equation already", lhs.span, "a second one")
                        .help("one equation for each coordinate"),
                );
                continue;
            };
            let dimension = q.dimension.unwrap_or(Dimension::NONE);
            let value = self.expect(rhs, dimension, "the right-hand side", Allowed::Everything);
            self.rig.equations.push(Equation { coordinate: row, mass, rhs: value, unit: Unit::si(dimension), span: s.span });
        }
        let missing: Vec<&Coordinate> = self
            .rig
            .coordinates
            .iter()
            .enumerate()
            .filter(|(i, c)| !c.prescribed && !self.rig.equations.iter().any(|e| e.coordinate == *i))
            .map(|(_, c)| c)
            .collect();
        if self.rig.equations.len() == list.len()
            && let Some(c) = missing.first()
        {
            self.diagnostics.push(
                Diagnostic::error("E0307", format!("`{}` has no equation", c.name), c.span, "declared here")
                    .help("where one equation is written directly, every coordinate needs one"),
            );
        }
        if let Some(body) = self.rig.bodies.first() {
            self.diagnostics.push(
                Diagnostic::error("E0307", "a rig has either bodies or equations written directly", body.span, "a body")
                    .also(list[0].0.span, "an equation")
                    .help("remove the bodies, or let the program derive the equations"),
            );
        }
    }
}
