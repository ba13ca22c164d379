//! What pushes: forces, torques, springs, dampers, friction, functions of energy.

use super::Resolver;
use super::terms::coordinates_in;
use crate::ast::{Along as AstAlong, Entry, Expr as Ast, Statement};
use crate::diagnostic::Diagnostic;
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::Dimension;

impl Resolver<'_> {
    /// Names of forces, springs, dampers, frictions and functions are one family: assumptions name them.
    pub(super) fn unique(&mut self, s: &Statement, _what: &str) {
        let rig = &self.rig;
        let before = rig
            .forces
            .iter()
            .map(|x| (&x.name, x.span))
            .chain(rig.springs.iter().map(|x| (&x.name, x.span)))
            .chain(rig.dampers.iter().map(|x| (&x.name, x.span)))
            .chain(rig.frictions.iter().map(|x| (&x.name, x.span)))
            .chain(rig.functions.iter().map(|x| (&x.name, x.span)))
            .find(|(n, _)| **n == s.name.text);
        if let Some((_, place)) = before {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("`{}` is declared twice", s.name.text), s.name.span, "again here")
                    .also(place, "first here")
                    .help("rename one of them"),
            );
        }
    }

    pub(super) fn along(&mut self, along: &AstAlong) -> (Along, Dimension) {
        match along {
            AstAlong::On(e) => match self.checker().check(e, Allowed::Configuration) {
                Some(q) => {
                    self.affine(&q.expr, e.span, "combination");
                    (Along::Coordinate(q.expr), q.dimension.unwrap_or(Dimension::NONE))
                }
                None => (Along::Coordinate(Expr::Number(0.0)), Dimension::NONE),
            },
            AstAlong::Between(ends) => {
                let ((f, p), (t, q)) = ends.as_ref();
                let from = (self.frame(f), self.vector(p, Dimension::LENGTH, "a point", Allowed::Parameters));
                let to = (self.frame(t), self.vector(q, Dimension::LENGTH, "a point", Allowed::Parameters));
                (Along::Points { from, to }, Dimension::LENGTH)
            }
        }
    }

    pub(super) fn spring(&mut self, s: &Statement, along: &AstAlong, entries: &[Entry]) {
        let (along, x) = self.along(along);
        let row = match &along {
            Along::Coordinate(e) => self.row_of(e),
            Along::Points { .. } => Dimension::FORCE,
        };
        let mut out = Spring {
            name: s.name.text.clone(),
            along,
            stiffness: Expr::Number(0.0),
            rest: Expr::Number(0.0),
            cubic: Expr::Number(0.0),
            span: s.name.span,
        };
        for e in entries {
            let v = &e.values[0];
            match e.key.text.as_str() {
                "stiffness" => out.stiffness = self.expect(v, row / x, "this stiffness", Allowed::Parameters),
                "rest" => out.rest = self.expect(v, x, "this rest position", Allowed::Parameters),
                "cubic" => out.cubic = self.expect(v, row / x.powi(3), "this cubic stiffness", Allowed::Parameters),
                _ => self.entry_error(e, "stiffness K, rest X_0, cubic K_3"),
            }
        }
        self.unique(s, "spring");
        self.rig.springs.push(out);
    }

    /// Dimension of the equation of the first coordinate in an affine combination.
    pub(super) fn row_of(&self, e: &Expr) -> Dimension {
        coordinates_in(e).first().map_or(Dimension::TORQUE, |&i| self.row_unit[i])
    }

    pub(super) fn friction(&mut self, s: &Statement, of: &Ast, entries: &[Entry]) {
        let Some(q) = self.checker().check(of, Allowed::Configuration) else { return };
        self.affine(&q.expr, of.span, "combination");
        let row = self.row_of(&q.expr);
        let rate = q.dimension.unwrap_or(Dimension::NONE) / Dimension::TIME;
        let mut out = Friction {
            name: s.name.text.clone(),
            of: q.expr,
            viscous: None,
            coulomb: None,
            width: None,
            stribeck: None,
            quadratic: None,
            asymmetric: None,
            span: s.name.span,
        };
        for e in entries {
            let v = &e.values[0];
            let option = |key: &str| e.options.iter().find(|(k, _)| k.text == key).and_then(|(_, v)| v.clone());
            match e.key.text.as_str() {
                "viscous" => out.viscous = Some(self.expect(v, row / rate, "viscous friction", Allowed::Parameters)),
                "coulomb" => {
                    out.coulomb = Some(self.expect(v, row, "Coulomb friction", Allowed::Parameters));
                    if let Some(w) = option("width") {
                        out.width = Some(self.expect(&w, rate, "the width", Allowed::Parameters));
                    }
                }
                "stribeck" => {
                    let level = self.expect(v, row, "Stribeck friction", Allowed::Parameters);
                    match option("speed") {
                        Some(speed) => {
                            let speed = self.expect(&speed, rate, "the Stribeck speed", Allowed::Parameters);
                            out.stribeck = Some((level, speed));
                        }
                        None => self.diagnostics.push(
                            Diagnostic::error("E0115", "Stribeck friction needs its speed", e.key.span, "here")
                                .help("write `stribeck F_s speed v_s;`"),
                        ),
                    }
                    if let Some(w) = option("width") {
                        out.width = Some(self.expect(&w, rate, "the width", Allowed::Parameters));
                    }
                }
                "quadratic" => out.quadratic = Some(self.expect(v, row / (rate * rate), "quadratic drag", Allowed::Parameters)),
                "asymmetric" if e.values.len() == 2 => {
                    let slope = self.expect(v, row / rate, "the slope of asymmetric friction", Allowed::Parameters);
                    let offset = self.expect(&e.values[1], row, "the offset of asymmetric friction", Allowed::Parameters);
                    out.asymmetric = Some((slope, offset));
                }
                _ => self.entry_error(e, "viscous C, coulomb F [width W], stribeck F speed V, quadratic C, asymmetric SLOPE, OFFSET"),
            }
        }
        if (out.coulomb.is_some() || out.stribeck.is_some()) && out.width.is_none() {
            out.width = Some(Expr::Number(0.01));
        }
        self.unique(s, "friction");
        self.rig.frictions.push(out);
    }
}
