//! Statements to the checked rig: every name resolved, every dimension checked, every number in SI.
//! One family of statements a file; `mod.rs` knows their order and what they share.

mod assumptions;
mod bodies;
mod equations;
mod forces;
mod frames;
mod paths;
mod terms;
mod trims;
mod values;

use crate::ast::{
    self, Along as AstAlong, Assume, AxisExpr, AxisOrVector, BodyEntry, Entry, Expr as Ast, ExprKind, Kind, Name, Statement, Value,
};
use crate::diagnostic::{Diagnostic, nearest};
use crate::quantity::{Allowed, Checker, Meaning, Quantity, Scope, is_bare};
use crate::rig::*;
use crate::units::{Dimension, Unit};
use paths::plain_output;
use std::collections::BTreeSet;
use terms::negative;

/// Builds the rig from its statements; `None` where an error left a hole.
pub fn resolve(name: &Name, doc: &str, statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> (Rig, BTreeSet<Symbol>) {
    let rig = Rig {
        name: name.text.clone(),
        doc: doc.to_owned(),
        parameters: Vec::new(),
        definitions: Vec::new(),
        coordinates: Vec::new(),
        inputs: Vec::new(),
        actuators: Vec::new(),
        mixes: Vec::new(),
        frames: Vec::new(),
        bodies: Vec::new(),
        gravity: None,
        forces: Vec::new(),
        springs: Vec::new(),
        frictions: Vec::new(),
        dampers: Vec::new(),
        functions: Vec::new(),
        equations: Vec::new(),
        outputs: Vec::new(),
        trims: Vec::new(),
        assumptions: Vec::new(),
    };
    let mut r = Resolver { rig, scope: Scope::default(), diagnostics, used: BTreeSet::new(), row_unit: Vec::new() };
    r.values(statements);
    r.definitions(statements);
    r.inputs(statements);
    r.frames(statements);
    r.row_units(statements);
    for s in statements {
        r.statement(s);
    }
    r.equations(statements);
    if r.rig.outputs.is_empty() {
        for (i, c) in r.rig.coordinates.iter().enumerate() {
            r.rig.outputs.push(plain_output(c, i));
        }
    }
    (r.rig, r.used)
}

struct Resolver<'a> {
    rig: Rig,
    scope: Scope,
    diagnostics: &'a mut Vec<Diagnostic>,
    used: BTreeSet<Symbol>,
    /// Dimension of each coordinate's equation.
    row_unit: Vec<Dimension>,
}

impl Resolver<'_> {
    fn checker(&mut self) -> Checker<'_> {
        Checker { scope: &self.scope, diagnostics: self.diagnostics, used: &mut self.used }
    }

    fn expect(&mut self, ast: &Ast, wanted: Dimension, what: &str, allowed: Allowed) -> Expr {
        self.checker().expect(ast, wanted, what, allowed).unwrap_or(Expr::Number(0.0))
    }

    fn vector(&mut self, v: &ast::Vector, wanted: Dimension, what: &str, allowed: Allowed) -> [Expr; 3] {
        if v.0.len() != 3 {
            self.diagnostics.push(
                Diagnostic::error("E0111", format!("a vector has three components, this has {}", v.0.len()), v.1, "here")
                    .help("write (x, y, z)"),
            );
        }
        std::array::from_fn(|k| v.0.get(k).map_or(Expr::Number(0.0), |e| self.expect(e, wanted, what, allowed)))
    }

    /// A number known now: literals and arithmetic of literals.
    fn constant(&mut self, ast: &Ast, unit: &Unit, what: &str) -> Option<f64> {
        let Quantity { expr, dimension, .. } = self.checker().check(ast, Allowed::Numbers)?;
        let Expr::Number(x) = expr else {
            self.diagnostics.push(
                Diagnostic::error("E0314", format!("{what} must be a number"), ast.span, "not a number")
                    .help("for a value computed from parameters use `derived`"),
            );
            return None;
        };
        if is_bare(ast) {
            // a bare number is in the declared unit
            return Some(x * unit.factor);
        }
        match dimension {
            Some(d) if d != unit.dimension => {
                self.checker().expect(ast, unit.dimension, what, Allowed::Numbers);
                None
            }
            _ => Some(x),
        }
    }

    fn declare(&mut self, name: &Name, symbol: Symbol, dimension: Option<Dimension>, what: &'static str) {
        if let Some(before) = self.scope.names.get(&name.text) {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("`{}` is declared twice", name.text), name.span, "again here")
                    .also(before.span, "first here")
                    .help(format!("rename one of them; to change it in a variant write `replace .. {} ..`", name.text)),
            );
            return;
        }
        if ["t", "pi", "ground"].contains(&name.text.as_str()) {
            self.diagnostics.push(Diagnostic::error(
                "E0202",
                format!("`{}` is a name of the language", name.text),
                name.span,
                "choose another name",
            ));
        }
        self.scope.order.push(name.text.clone());
        self.scope.names.insert(name.text.clone(), Meaning { symbol, dimension, span: name.span, what });
    }

    fn coordinate(&mut self, name: &Name) -> Option<usize> {
        if let Some(i) = self.rig.coordinates.iter().position(|c| c.name == name.text) {
            return Some(i);
        }
        let names: Vec<&str> = self.rig.coordinates.iter().map(|c| c.name.as_str()).collect();
        let mut d = Diagnostic::error("E0201", format!("there is no coordinate `{}`", name.text), name.span, "unknown coordinate");
        d = match nearest(&name.text, names.iter().copied()) {
            Some(near) => d.help(format!("did you mean `{near}`?")),
            None => d.help(format!("coordinates are {}", names.join(", "))),
        };
        self.diagnostics.push(d);
        None
    }

    fn coordinates(&mut self, names: &[Name]) -> Vec<usize> {
        names.iter().filter_map(|n| self.coordinate(n)).collect()
    }

    fn statement(&mut self, s: &Statement) {
        let name = s.name.text.clone();
        let (doc, span) = (s.doc.clone(), s.name.span);
        match &s.kind {
            Kind::Body(frame, entries) => self.body(s, frame, entries),
            Kind::Gravity(value, along) => {
                let size = self.expect(value, Dimension::ACCELERATION, "gravity", Allowed::Parameters);
                let zero = Expr::Number(0.0);
                let acceleration = match along {
                    None => [zero.clone(), zero, negative(size)],
                    Some(AxisOrVector::Axis(k, minus)) => std::array::from_fn(|i| {
                        if i != *k {
                            zero.clone()
                        } else if *minus {
                            negative(size.clone())
                        } else {
                            size.clone()
                        }
                    }),
                    Some(AxisOrVector::Vector(v)) => {
                        let direction = self.vector(v, Dimension::NONE, "a direction", Allowed::Parameters);
                        direction.map(|d| {
                            if d == Expr::Number(0.0) { d } else { Expr::Binary(BinaryOp::Mul, Box::new(size.clone()), Box::new(d)) }
                        })
                    }
                };
                self.rig.gravity = Some(Gravity { acceleration, span: s.span });
            }
            Kind::Force(frame, at, vector, axes, against) => {
                let frame = self.frame(frame);
                let point = at.as_ref().map_or([Expr::Number(0.0), Expr::Number(0.0), Expr::Number(0.0)], |p| {
                    self.vector(p, Dimension::LENGTH, "a point", Allowed::Parameters)
                });
                let vector = self.vector(vector, Dimension::FORCE, "a force", Allowed::Everything);
                let axes = axes.as_ref().map_or(frame, |n| self.frame(n));
                let against = against.as_ref().map(|n| self.frame(n));
                self.unique(s, "force");
                self.rig.forces.push(Force { name, doc, kind: ForceKind::Force { frame, point, vector, axes, against }, span });
            }
            Kind::Torque(frame, vector, axes, against) => {
                let frame = self.frame(frame);
                let vector = self.vector(vector, Dimension::TORQUE, "a torque", Allowed::Everything);
                let axes = axes.as_ref().map_or(frame, |n| self.frame(n));
                let against = against.as_ref().map(|n| self.frame(n));
                self.unique(s, "torque");
                self.rig.forces.push(Force { name, doc, kind: ForceKind::Torque { frame, vector, axes, against }, span });
            }
            Kind::Generalized(place, value) => {
                let Some(coordinate) = self.coordinate(place) else { return };
                let unit = self.row_unit[coordinate];
                let value = self.expect(value, unit, &format!("the equation of `{}`", place.text), Allowed::Everything);
                self.unique(s, "torque");
                self.rig.forces.push(Force { name, doc, kind: ForceKind::Generalized { coordinate, value }, span });
            }
            Kind::Spring(along, entries) => self.spring(s, along, entries),
            Kind::Damper(along, entries) => {
                let along = self.along(along).0;
                let mut viscous = Expr::Number(0.0);
                for e in entries {
                    match e.key.text.as_str() {
                        "viscous" => {
                            viscous = self.expect(
                                &e.values[0],
                                Dimension::FORCE * Dimension::TIME / Dimension::LENGTH,
                                "a damper",
                                Allowed::Parameters,
                            )
                        }
                        _ => self.entry_error(e, "viscous C"),
                    }
                }
                self.unique(s, "damper");
                self.rig.dampers.push(Damper { name, along, viscous, span });
            }
            Kind::Friction(of, entries) => self.friction(s, of, entries),
            Kind::Function(kind, value) => {
                let (wanted, what, allowed) = match kind {
                    EnergyKind::Potential => (Dimension::TORQUE, "a potential energy", Allowed::Configuration),
                    EnergyKind::Kinetic => (Dimension::TORQUE, "a kinetic energy", Allowed::Motion),
                    EnergyKind::Dissipation => (Dimension::POWER, "a dissipation function", Allowed::Motion),
                };
                let value = self.expect(value, wanted, what, allowed);
                self.unique(s, "function");
                self.rig.functions.push(EnergyFunction { name, kind: *kind, value, span });
            }
            Kind::Encoder(entry) => {
                let Some(i) = self.coordinate(&s.name) else { return };
                self.used.insert(Symbol::Coordinate(i));
                let mut output = plain_output(&self.rig.coordinates[i], i);
                output.encoder = self.encoder(entry, output.unit.dimension);
                output.span = span;
                self.output(output, s);
            }
            Kind::Output(unit, value, entries) => {
                let Some(unit) = self.checker().unit(unit) else { return };
                let value = self.expect(value, unit.dimension, "this output", Allowed::Motion);
                let mut out = Output { name, unit: unit.clone(), value, scale: None, bias: None, delay: None, encoder: None, span };
                for e in entries {
                    let v = &e.values[0];
                    match e.key.text.as_str() {
                        "scale" => out.scale = Some(self.expect(v, Dimension::NONE, "a scale", Allowed::Parameters)),
                        "bias" => out.bias = Some(self.expect(v, unit.dimension, "this bias", Allowed::Parameters)),
                        "delay" => out.delay = Some(self.expect(v, Dimension::TIME, "a delay", Allowed::Parameters)),
                        "encoder" => out.encoder = self.encoder(e, unit.dimension),
                        _ => self.entry_error(e, "scale S, bias B, delay T, encoder COUNTS [zero at Z] [wrapped]"),
                    }
                }
                self.output(out, s);
            }
            Kind::Trim(fixed, zero, solve) => self.trim(s, fixed, zero, solve),
            Kind::Assume(list) => {
                for (a, place) in list {
                    self.assume(a, *place);
                }
            }
            _ => {}
        }
    }
}

fn plural(n: usize) -> &'static str {
    if n == 1 { "" } else { "s" }
}
