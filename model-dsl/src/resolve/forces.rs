//! What pushes: gravity, forces, torques, springs, dampers, friction, functions of energy.

use super::Resolver;
use super::terms::{coordinates_in, hole, negative};
use crate::ast::{self, Along as AstAlong, AxisOrVector, Entry, Expr as Ast, Name, Statement};
use crate::diagnostic::Diagnostic;
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::Dimension;

const ZERO: Expr = Expr::Number(0.0);

impl Resolver<'_> {
    pub(super) fn gravity(&mut self, s: &Statement, value: &Ast, along: Option<&AxisOrVector>) {
        if let Some(before) = &self.rig.gravity {
            let d = Diagnostic::error("E0202", "gravity is declared twice", s.span, "again here").also(before.span, "first here");
            self.diagnostics.push(d.help("remove one; to change it in a variant write `replace gravity ..`"));
        }
        let size = self.expect(value, Dimension::ACCELERATION, "gravity", Allowed::Parameters);
        let mut direction = None;
        let acceleration = match along {
            None => [ZERO, ZERO, negative(size)],
            Some(AxisOrVector::Axis(k, minus)) => std::array::from_fn(|i| match (i == *k, minus) {
                (false, _) => ZERO,
                (true, true) => negative(size.clone()),
                (true, false) => size.clone(),
            }),
            Some(AxisOrVector::Vector(v)) => {
                let written = self.vector(v, Dimension::NONE, "a direction", Allowed::Parameters);
                direction = Some(written.clone());
                written.map(|d| if d == ZERO { d } else { Expr::Binary(BinaryOp::Mul, Box::new(size.clone()), Box::new(d)) })
            }
        };
        self.rig.gravity = Some(Gravity { acceleration, direction, span: s.span });
    }

    pub(super) fn force(
        &mut self,
        s: &Statement,
        on: &Name,
        at: Option<&ast::Vector>,
        components: &ast::Vector,
        axes: Option<&Name>,
        against: Option<&Name>,
    ) {
        let (frame, axes, against) = self.acting(on, axes, against);
        let point = at.map_or([ZERO, ZERO, ZERO], |p| self.vector(p, Dimension::LENGTH, "a point", Allowed::Parameters));
        let before = self.diagnostics.len();
        let vector = self.vector(components, Dimension::FORCE, "a force", Allowed::Everything);
        self.torque_meant(s, on, frame, components, before);
        self.unique(s);
        self.push_force(s, ForceKind::Force { frame, point, vector, axes, against });
    }

    /// A force whose components are torques: says how the torque is written.
    fn torque_meant(&mut self, s: &Statement, on: &Name, frame: FrameRef, components: &ast::Vector, before: usize) {
        // about the frame's own joint axis, if it has one: that is what a torque on it is for
        let axis = match frame {
            FrameRef::Frame(k) => self.rig.frames[k].steps.iter().rev().find_map(|step| match step {
                Step::Rotate { axis: Axis::Principal { index, .. }, .. } => Some(*index),
                _ => None,
            }),
            FrameRef::Ground => None,
        };
        for (k, e) in components.0.iter().enumerate() {
            let found = self.diagnostics[before..]
                .iter()
                .position(|d| d.code == "E0231" && d.labels[0].0 == e.span && d.message.ends_with("this is N m"));
            let Some(found) = found else { continue };
            let written = self.sources.text(e.span).unwrap_or("tau");
            let parts: Vec<&str> = (0..3).map(|i| if i == axis.unwrap_or(k) { written } else { "0" }).collect();
            let d = self.diagnostics[before + found].clone();
            self.diagnostics[before + found] =
                d.help(format!("for a torque write `torque {} on {}: ({});`", s.name.text, on.text, parts.join(", ")));
        }
    }

    pub(super) fn torque(&mut self, s: &Statement, on: &Name, components: &ast::Vector, axes: Option<&Name>, against: Option<&Name>) {
        if let Some(m) = self.scope.names.get(&on.text)
            && matches!(m.symbol, Symbol::Coordinate(_))
            && !self.rig.frames.iter().any(|f| f.name == on.text)
        {
            let d = Diagnostic::error(
                "E0206",
                format!("a torque on the coordinate `{}` is one number, not a vector", on.text),
                components.1,
                "three components",
            );
            self.diagnostics.push(
                d.also(m.span, "a coordinate").help(format!("write `torque {} on {}: VALUE;`, or name a frame", s.name.text, on.text)),
            );
            return;
        }
        let (frame, axes, against) = self.acting(on, axes, against);
        let vector = self.vector(components, Dimension::TORQUE, "a torque", Allowed::Everything);
        self.unique(s);
        self.push_force(s, ForceKind::Torque { frame, vector, axes, against });
    }

    fn acting(&mut self, on: &Name, axes: Option<&Name>, against: Option<&Name>) -> (FrameRef, FrameRef, Option<FrameRef>) {
        let frame = self.frame(on).unwrap_or(FrameRef::Ground);
        let axes = axes.map_or(frame, |n| self.frame(n).unwrap_or(frame));
        let against = against.and_then(|n| self.frame(n));
        (frame, axes, against)
    }

    fn push_force(&mut self, s: &Statement, kind: ForceKind) {
        self.rig.forces.push(Force { name: s.name.text.clone(), doc: s.doc.clone(), kind, span: s.name.span });
    }

    pub(super) fn generalized(&mut self, s: &Statement, place: &Name, value: &Ast) {
        if !self.scope.names.contains_key(&place.text) && self.rig.frames.iter().any(|f| f.name == place.text) {
            let d = Diagnostic::error(
                "E0206",
                format!("a torque on the frame `{}` has three components", place.text),
                value.span,
                "one number",
            );
            let written = self.sources.text(value.span).unwrap_or("tau");
            self.diagnostics
                .push(d.help(format!("write `torque {} on {}: (0, 0, {written});`, or name a coordinate", s.name.text, place.text)));
            return;
        }
        let Some(coordinate) = self.coordinate(place) else { return };
        let unit = self.row_unit[coordinate];
        let value = self.expect(value, unit, &format!("the equation of `{}`", place.text), Allowed::Everything);
        self.unique(s);
        self.push_force(s, ForceKind::Generalized { coordinate, value });
    }

    pub(super) fn function(&mut self, s: &Statement, kind: EnergyKind, value: &Ast) {
        let (wanted, what, allowed) = match kind {
            EnergyKind::Potential => (Dimension::TORQUE, "a potential energy", Allowed::Configuration),
            EnergyKind::Kinetic => (Dimension::TORQUE, "a kinetic energy", Allowed::Motion),
            EnergyKind::Dissipation => (Dimension::POWER, "a dissipation function", Allowed::Motion),
        };
        let value = self.expect(value, wanted, what, allowed);
        self.unique(s);
        self.rig.functions.push(EnergyFunction { name: s.name.text.clone(), kind, value, span: s.name.span });
    }

    /// Names of forces, springs, dampers, frictions and functions are one family: assumptions name them.
    fn unique(&mut self, s: &Statement) {
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
            let d = Diagnostic::error("E0202", format!("`{}` is declared twice", s.name.text), s.name.span, "again here")
                .also(place, "first here");
            let help = if s.keyword == "friction" {
                "give it a name of its own: `friction NAME on COORDINATE { .. }`"
            } else {
                "rename one of them"
            };
            self.diagnostics.push(d.help(help));
        }
    }

    fn along(&mut self, along: &AstAlong) -> (Along, Option<Dimension>) {
        match along {
            AstAlong::On(e) => match self.checker().check(e, Allowed::Configuration) {
                Some(q) => {
                    self.affine(&q.expr, e.span, "combination");
                    (Along::Coordinate(q.expr), Some(q.dimension.unwrap_or(Dimension::NONE)))
                }
                None => (Along::Coordinate(hole()), None),
            },
            AstAlong::Between(ends) => {
                let ((f, p), (t, q)) = ends.as_ref();
                let from = (self.frame(f).unwrap_or(FrameRef::Ground), self.vector(p, Dimension::LENGTH, "a point", Allowed::Parameters));
                let to = (self.frame(t).unwrap_or(FrameRef::Ground), self.vector(q, Dimension::LENGTH, "a point", Allowed::Parameters));
                (Along::Points { from, to }, Some(Dimension::LENGTH))
            }
        }
    }

    pub(super) fn damper(&mut self, s: &Statement, along: &AstAlong, entries: &[Entry]) {
        let (along, x) = self.along(along);
        let row = match &along {
            Along::Coordinate(e) => self.row_of(e),
            Along::Points { .. } => Some(Dimension::FORCE),
        };
        let mut viscous = hole();
        self.entries(s, entries, &["viscous"]);
        for e in entries {
            match e.key.text.as_str() {
                "viscous" => {
                    let wanted = row.zip(x).map(|(row, x)| row * Dimension::TIME / x);
                    viscous = self.expect(&e.values[0], wanted, "a damper", Allowed::Parameters);
                }
                _ => self.entry_error(e, "viscous C"),
            }
        }
        self.unique(s);
        self.rig.dampers.push(Damper { name: s.name.text.clone(), along, viscous, span: s.name.span });
    }

    pub(super) fn spring(&mut self, s: &Statement, along: &AstAlong, entries: &[Entry]) {
        let (along, x) = self.along(along);
        let row = match &along {
            Along::Coordinate(e) => self.row_of(e),
            Along::Points { .. } => Some(Dimension::FORCE),
        };
        let per = |n: i16| row.zip(x).map(|(row, x)| row / x.powi(n));
        let mut out = Spring { name: s.name.text.clone(), along, stiffness: ZERO, rest: ZERO, cubic: ZERO, span: s.name.span };
        let needed: &[&str] = if entries.iter().any(|e| e.key.text == "cubic") { &[] } else { &["stiffness"] };
        self.entries(s, entries, needed);
        for e in entries {
            let v = &e.values[0];
            match e.key.text.as_str() {
                "stiffness" => out.stiffness = self.expect(v, per(1), "this stiffness", Allowed::Parameters),
                "rest" => out.rest = self.expect(v, x, "this rest position", Allowed::Parameters),
                "cubic" => out.cubic = self.expect(v, per(3), "this cubic stiffness", Allowed::Parameters),
                _ => self.entry_error(e, "stiffness K, rest X_0, cubic K_3"),
            }
        }
        self.unique(s);
        self.rig.springs.push(out);
    }

    /// Dimension of the equation of the first coordinate in an affine combination.
    fn row_of(&self, e: &Expr) -> Option<Dimension> {
        coordinates_in(e).first().and_then(|&i| self.row_unit[i])
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
        if entries.is_empty() {
            let d = Diagnostic::error("E0115", format!("the friction of `{}` has no entry", out.name), s.name.span, "nothing in its block");
            self.diagnostics.push(d.help("write for example `viscous c;`"));
        }
        self.entries(s, entries, &[]);
        for e in entries {
            let v = &e.values[0];
            let option = |key: &str| e.options.iter().find(|(k, _)| k.text == key).and_then(|(_, v)| v.clone());
            let per = |d: Dimension| row.map(|row| row / d);
            match e.key.text.as_str() {
                "viscous" => out.viscous = Some(self.expect(v, per(rate), "viscous friction", Allowed::Parameters)),
                "coulomb" => out.coulomb = Some(self.expect(v, row, "Coulomb friction", Allowed::Parameters)),
                "stribeck" => {
                    let level = self.expect(v, row, "Stribeck friction", Allowed::Parameters);
                    match option("speed") {
                        Some(speed) => out.stribeck = Some((level, self.expect(&speed, rate, "the Stribeck speed", Allowed::Parameters))),
                        None => self.diagnostics.push(
                            Diagnostic::error("E0115", "Stribeck friction needs its speed", e.key.span, "here")
                                .help("write `stribeck F_s speed v_s;`"),
                        ),
                    }
                }
                "quadratic" => out.quadratic = Some(self.expect(v, per(rate * rate), "quadratic drag", Allowed::Parameters)),
                "asymmetric" if e.values.len() == 2 => {
                    let slope = self.expect(v, per(rate), "the slope of asymmetric friction", Allowed::Parameters);
                    let offset = self.expect(&e.values[1], row, "the offset of asymmetric friction", Allowed::Parameters);
                    out.asymmetric = Some((slope, offset));
                }
                _ => self.entry_error(e, "viscous C, coulomb F [width W], stribeck F speed V, quadratic C, asymmetric SLOPE, OFFSET"),
            }
            if matches!(e.key.text.as_str(), "coulomb" | "stribeck")
                && let Some(w) = option("width")
            {
                out.width = Some(self.expect(&w, rate, "the width", Allowed::Parameters));
            }
        }
        if (out.coulomb.is_some() || out.stribeck.is_some()) && out.width.is_none() {
            out.width = Some(Expr::Number(0.01));
        }
        self.unique(s);
        self.rig.frictions.push(out);
    }
}
