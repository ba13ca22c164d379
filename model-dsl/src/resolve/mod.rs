//! Statements to the checked rig: every name resolved, every dimension checked, every number in SI.
//! One family of statements a file; `mod.rs` knows their order and what they share.

mod assumptions;
mod bodies;
mod equations;
mod forces;
mod frames;
mod order;
mod paths;
mod terms;
mod trims;
mod values;

use crate::ast::{self, Expr as Ast, Kind, Name, Statement};
use crate::diagnostic::{Diagnostic, nearest};
use crate::extend::Flat;
use crate::quantity::{Allowed, Checker, Meaning, Quantity, Scope, is_bare};
use crate::rig::*;
use crate::source::Sources;
use crate::units::{Dimension, Unit};
use paths::plain_output;
use std::collections::BTreeSet;
use terms::{hole, names_in};

/// Builds the rig from its statements; `None` where an error left a hole.
pub fn resolve(name: &Name, doc: &str, flat: &Flat, sources: &Sources, diagnostics: &mut Vec<Diagnostic>) -> (Rig, BTreeSet<Symbol>) {
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
    let mut r = Resolver {
        rig,
        scope: Scope::default(),
        sources,
        diagnostics,
        used: BTreeSet::new(),
        row_unit: Vec::new(),
        circular: BTreeSet::new(),
    };
    r.scope.removed = flat.removed.clone();
    let statements = flat.statements.as_slice();
    r.scope.lost = statements.iter().filter(|s| matches!(s.kind, Kind::Broken)).map(|s| s.name.text.clone()).collect();
    r.values(statements);
    r.definitions(statements);
    r.inputs(statements);
    r.frames(statements);
    r.row_units(statements);
    // the order of statements does not matter: bodies are places for forces, and assumptions name what all others declare
    let rank = |s: &Statement| match s.kind {
        Kind::Body(..) => 0,
        Kind::Assume(_) => 2,
        _ => 1,
    };
    for pass in 0..3 {
        if pass == 2 {
            r.equations(statements);
        }
        for s in statements.iter().filter(|s| rank(s) == pass) {
            r.statement(s);
        }
    }
    if r.rig.coordinates.is_empty() && r.scope.lost.is_empty() {
        let d = Diagnostic::error("E0115", format!("the rig `{}` has no coordinates", name.text), name.span, "nothing can move");
        r.diagnostics.push(d.help("declare one, as in `coord theta: rad;`"));
    }
    if r.rig.outputs.is_empty() {
        for (i, c) in r.rig.coordinates.iter().enumerate() {
            r.rig.outputs.push(plain_output(c, i));
        }
    }
    (r.rig, r.used)
}

/// Words that an expression could not tell from a name.
const RESERVED: [&str; 12] = ["t", "pi", "ground", "in", "on", "at", "along", "against", "about", "value", "fixed", "per"];

struct Resolver<'a> {
    rig: Rig,
    scope: Scope,
    sources: &'a Sources,
    diagnostics: &'a mut Vec<Diagnostic>,
    used: BTreeSet<Symbol>,
    /// Dimension of each coordinate's equation; `None` where an error hides it.
    row_unit: Vec<Option<Dimension>>,
    /// Definitions in a circle.
    circular: BTreeSet<String>,
}

impl Resolver<'_> {
    fn checker(&mut self) -> Checker<'_> {
        Checker { scope: &self.scope, sources: self.sources, diagnostics: self.diagnostics, used: &mut self.used }
    }

    fn expect(&mut self, ast: &Ast, wanted: impl Into<Option<Dimension>>, what: &str, allowed: Allowed) -> Expr {
        let checked = match wanted.into() {
            Some(wanted) => self.checker().expect(ast, wanted, what, allowed),
            None => self.checker().check(ast, allowed).map(|q| q.expr),
        };
        checked.unwrap_or_else(hole)
    }

    fn vector(&mut self, v: &ast::Vector, wanted: Dimension, what: &str, allowed: Allowed) -> [Expr; 3] {
        if v.0.len() != 3 {
            self.diagnostics.push(
                Diagnostic::error("E0111", format!("a vector has three components, this has {}", v.0.len()), v.1, "here")
                    .help("write (x, y, z)"),
            );
        }
        std::array::from_fn(|k| v.0.get(k).map_or_else(hole, |e| self.expect(e, wanted, what, allowed)))
    }

    /// A number known now: literals and arithmetic of literals.
    fn constant(&mut self, ast: &Ast, unit: &Unit, what: &str) -> Option<f64> {
        if names_in(ast).iter().any(|n| n != "pi") {
            // also names that mean nothing: a number is what stands here
            let known: Vec<String> = names_in(ast).into_iter().filter(|n| self.scope.lost.contains(n)).collect();
            if known.is_empty() {
                let d = Diagnostic::error("E0206", format!("{what} takes a number, not an expression of names"), ast.span, "not a number");
                self.diagnostics.push(d.help("what is computed from parameters is declared with `derived` in place of `param`"));
            }
            return None;
        }
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

    fn declare(&mut self, name: &Name, symbol: Symbol, dimension: Option<Dimension>, what: &'static str, doc: &str) {
        if let Some(before) = self.scope.names.get(&name.text) {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("`{}` is declared twice", name.text), name.span, "again here")
                    .also(before.span, "first here")
                    .help("rename one of them; in a variant that extends this rig, write `replace` in front"),
            );
            return;
        }
        if RESERVED.contains(&name.text.as_str()) {
            let d = Diagnostic::error("E0202", format!("`{}` is a word of the language", name.text), name.span, "choose another name");
            self.diagnostics.push(d);
        }
        self.scope.order.push(name.text.clone());
        self.scope.names.insert(name.text.clone(), Meaning { symbol, dimension, span: name.span, what, doc: phrase(doc) });
    }

    /// A bare number where an angle stands, of more than a turn: probably degrees.
    fn many_turns(&mut self, ast: &Ast, checked: &Expr) {
        if let Expr::Number(x) = checked
            && is_bare(ast)
            && x.abs() > std::f64::consts::TAU
        {
            let d =
                Diagnostic::warning("W0404", format!("{x} rad is more than a full turn"), ast.span, "a number without unit is in radians");
            self.diagnostics.push(d.help(format!("if degrees are meant, write `{x}deg`")));
        }
    }

    fn coordinate(&mut self, name: &Name) -> Option<usize> {
        if let Some(i) = self.rig.coordinates.iter().position(|c| c.name == name.text) {
            return Some(i);
        }
        let names: Vec<&str> = self.rig.coordinates.iter().map(|c| c.name.as_str()).collect();
        let all = if names.is_empty() { "the rig has none".to_owned() } else { format!("coordinates are {}", names.join(", ")) };
        self.unknown("coordinate", name, &all, &names.iter().map(|n| (*n).to_owned()).collect::<Vec<_>>(), "E0201");
        None
    }

    /// A name that is none of its kind: of another kind, or of none. Names lost to an error were reported.
    fn unknown(&mut self, kind: &str, name: &Name, all: &str, known: &[String], code: &'static str) {
        if self.scope.lost.contains(&name.text) {
            return;
        }
        if let Some(m) = self.scope.names.get(&name.text) {
            let (what, span) = (m.what, m.span);
            let d =
                Diagnostic::error("E0206", format!("`{}` is {what}, not a {kind}", name.text), name.span, format!("a {kind} stands here"));
            self.diagnostics.push(d.also(span, "declared here").help(all.to_owned()));
            return;
        }
        if kind != "frame" && self.rig.frames.iter().any(|f| f.name == name.text) {
            let d =
                Diagnostic::error("E0206", format!("`{}` is a frame, not a {kind}", name.text), name.span, format!("a {kind} stands here"));
            self.diagnostics.push(d.help(all.to_owned()));
            return;
        }
        let d = Diagnostic::error(code, format!("there is no {kind} `{}`", name.text), name.span, format!("unknown {kind}"));
        self.diagnostics.push(match nearest(&name.text, known.iter().map(String::as_str)) {
            Some(near) => d.help(format!("did you mean `{near}`?")),
            None => d.help(all.to_owned()),
        });
    }

    fn coordinates(&mut self, names: &[Name]) -> Vec<usize> {
        names.iter().filter_map(|n| self.coordinate(n)).collect()
    }

    fn statement(&mut self, s: &Statement) {
        match &s.kind {
            Kind::Body(frame, entries) => self.body(s, frame, entries),
            Kind::Gravity(value, along) => self.gravity(s, value, along.as_ref()),
            Kind::Force(frame, at, vector, axes, against) => self.force(s, frame, at.as_ref(), vector, axes.as_ref(), against.as_ref()),
            Kind::Torque(frame, vector, axes, against) => self.torque(s, frame, vector, axes.as_ref(), against.as_ref()),
            Kind::Generalized(place, value) => self.generalized(s, place, value),
            Kind::Spring(along, entries) => self.spring(s, along, entries),
            Kind::Damper(along, entries) => self.damper(s, along, entries),
            Kind::Friction(of, entries) => self.friction(s, of, entries),
            Kind::Function(kind, value) => self.function(s, *kind, value),
            Kind::Encoder(entry) => self.encoder_output(s, entry),
            Kind::Output(unit, value, entries) => self.declared_output(s, unit, value, entries),
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

/// The first words of a comment, to name a thing by in a sentence: `thrust constant`.
fn phrase(doc: &str) -> String {
    let first = doc.lines().next().unwrap_or("").split([',', ';', '.', '(', ':']).next().unwrap_or("").trim();
    let few = first.split_whitespace().count() <= 5 && first.len() <= 40;
    if few { first.strip_prefix("the ").unwrap_or(first).to_owned() } else { String::new() }
}

fn plural(n: usize) -> &'static str {
    if n == 1 { "" } else { "s" }
}
