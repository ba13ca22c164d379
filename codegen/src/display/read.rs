//! From the graph to normal forms, within a budget.
//!
//! `read` multiplies everything out and gives up on what grows too long; `read_in_parts` keeps the
//! graph's own labelled values (`omega_arm_y`) as names with definitions beside them, and always ends.
//! Functions of long arguments (the length of a spring between two points) may be named in both.

use super::form::{AtomId, Class, Depends, Forms, MOST_TERMS, MOST_WEIGHT, Monomial, Sum};
use super::number::Number;
use crate::expr::{F1, Graph, Id, Node, SymbolId, SymbolKind};
use model_dsl::rig::Rig;
use model_dsl::units::{Dimension, Unit};
use rustc_hash::FxHashMap;
use std::rc::Rc;

/// Terms of a function's argument, above which the function's value is given a name.
const LONG_ARGUMENT: usize = 5;
/// Names and functions in an argument, above which the same is done.
const HEAVY_ARGUMENT: u64 = 40;
/// Terms of a value without a label, above which it is given a name of its own.
const LONG_PART: usize = 6;

/// A named part of long expressions.
pub struct Part {
    /// Its name.
    pub atom: AtomId,
    /// What it stands for, over earlier parts.
    pub value: Sum,
}

/// Class of a parameter or lump by its unit: how it stands in a product.
fn class_of(unit: &Unit) -> Class {
    match unit.dimension {
        Dimension::ACCELERATION => Class::Gravity,
        Dimension::LENGTH => Class::Length,
        _ => Class::Parameter,
    }
}

/// Gives every name of a rig its place, in order of declaration: the order in which products are written.
pub fn register(rig: &Rig, forms: &mut Forms) {
    let none = Depends::default();
    for p in &rig.parameters {
        forms.named(&p.name, class_of(&p.unit), none);
    }
    for d in rig.definitions.iter().filter(|d| d.parameter.is_none()) {
        forms.named(&d.name, class_of(&d.unit), none);
    }
    for c in &rig.coordinates {
        forms.named(&c.name, Class::Coordinate, none);
    }
    for c in &rig.coordinates {
        forms.named(&format!("{}.dot", c.name), Class::Rate, none);
    }
    for m in &rig.mixes {
        for name in &m.names {
            forms.named(name, Class::Signal, none);
        }
    }
    for i in &rig.inputs {
        forms.named(&i.name, Class::Signal, none);
    }
}

/// The atom of a lump that is shown by its name.
pub fn lump_atom(rig: &Rig, definition: usize, forms: &mut Forms) -> AtomId {
    let d = &rig.definitions[definition];
    forms.named(&d.name, class_of(&d.unit), Depends::default())
}

/// Reads one graph into forms.
pub struct Reader<'a> {
    rig: &'a Rig,
    graph: &'a Graph,
    symbols: FxHashMap<SymbolId, AtomId>,
    memo: FxHashMap<Id, Option<Rc<Sum>>>,
    /// Named parts, each over earlier ones.
    pub parts: Vec<Part>,
    /// Whether functions of long arguments are given names; not where two models are compared.
    pub names_parts: bool,
    named_calls: FxHashMap<AtomId, AtomId>,
    taken: FxHashMap<String, usize>,
}

impl<'a> Reader<'a> {
    /// Reader of a rig's graph.
    pub fn new(rig: &'a Rig, graph: &'a Graph) -> Self {
        Self {
            rig,
            graph,
            symbols: FxHashMap::default(),
            memo: FxHashMap::default(),
            parts: Vec::new(),
            names_parts: false,
            named_calls: FxHashMap::default(),
            taken: FxHashMap::default(),
        }
    }

    /// The atom of a symbol.
    pub fn symbol(&mut self, forms: &mut Forms, symbol: SymbolId) -> AtomId {
        if let Some(&atom) = self.symbols.get(&symbol) {
            return atom;
        }
        let info = self.graph.symbol_info(symbol);
        let class = match info.kind {
            SymbolKind::Time => Class::Time,
            SymbolKind::Coordinate(_) => Class::Coordinate,
            SymbolKind::Rate(_) => Class::Rate,
            SymbolKind::Lag(_) => Class::Lag,
            SymbolKind::Signal(_) => Class::Signal,
            SymbolKind::Acceleration(_) => Class::Acceleration,
            SymbolKind::Parameter(i) => self.rig.parameters.get(i).map_or(Class::Parameter, |p| class_of(&p.unit)),
            SymbolKind::Definition(_) | SymbolKind::Inertial(_) => Class::Parameter,
        };
        let atom = forms.named(&info.name, class, Depends::default());
        self.symbols.insert(symbol, atom);
        atom
    }

    /// Multiplied out, with like terms collected; `None` for what grows too long.
    pub fn read(&mut self, forms: &mut Forms, roots: &[Id]) -> Vec<Option<Rc<Sum>>> {
        for id in self.graph.reachable(roots) {
            if !self.memo.contains_key(&id) {
                let memo = std::mem::take(&mut self.memo);
                let value = self.value(forms, id, &|x| memo.get(&x).cloned().flatten());
                self.memo = memo;
                let fits = |s: &Sum| s.len() <= MOST_TERMS && forms.weight(s) <= MOST_WEIGHT;
                self.memo.insert(id, value.filter(fits).map(Rc::new));
            }
        }
        roots.iter().map(|id| self.memo[id].clone()).collect()
    }

    /// Over the graph's labelled values, which become named parts.
    pub fn read_in_parts(&mut self, forms: &mut Forms, roots: &[Id]) -> Vec<Sum> {
        let mut values: FxHashMap<Id, Rc<Sum>> = FxHashMap::default();
        for id in self.graph.reachable(roots) {
            let value = match self.value(forms, id, &|x| values.get(&x).cloned()) {
                Some(value) => value,
                None => self.opaque(forms, id, &values),
            };
            let short = value.len() <= 1 && value.0.iter().all(|(m, _)| m.0.len() <= 2);
            let label = self.graph.label_of(id);
            let long = value.len() > if label.is_some() { 1 } else { LONG_PART };
            let value = if short || !long || roots.contains(&id) {
                value
            } else {
                let base = label.map_or_else(|| format!("{}_1", self.graph.scope_of(id)), str::to_owned);
                Sum::atom(self.part(forms, &base, value))
            };
            values.insert(id, Rc::new(value));
        }
        roots.iter().map(|id| values[id].as_ref().clone()).collect()
    }

    /// Names a value; names that were used before are numbered on.
    fn part(&mut self, forms: &mut Forms, base: &str, value: Sum) -> AtomId {
        let base: String = base.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
        let count = self.taken.entry(base.clone()).or_insert(0);
        *count += 1;
        let name = match (*count, base.strip_suffix("_1")) {
            (1, _) => base,
            (n, Some(stem)) => format!("{stem}_{n}"),
            (n, None) => format!("{base}_{n}"),
        };
        let atom = forms.named(&name, Class::Part, forms.depends_of(&value));
        self.parts.push(Part { atom, value });
        atom
    }

    /// A function's value, named where its argument is long.
    fn call(&mut self, forms: &mut Forms, id: Id, atom: AtomId, long: bool) -> Sum {
        if !self.names_parts || !long {
            return Sum::atom(atom);
        }
        if let Some(&part) = self.named_calls.get(&atom) {
            return Sum::atom(part);
        }
        // the root of a sum of squares under a spring or damper is its length
        let scope = self.graph.scope_of(id).to_owned();
        let connects = self.rig.springs.iter().any(|s| s.name == scope) || self.rig.dampers.iter().any(|d| d.name == scope);
        let base = if connects && matches!(self.graph.node(id), Node::Call(F1::Sqrt, _)) {
            format!("length_{scope}")
        } else {
            format!("{scope}_1")
        };
        let part = self.part(forms, &base, Sum::atom(atom));
        self.named_calls.insert(atom, part);
        Sum::atom(part)
    }

    /// A product or quotient that was not multiplied out: its operands as factors.
    fn opaque(&self, forms: &mut Forms, id: Id, values: &FxHashMap<Id, Rc<Sum>>) -> Sum {
        let factor = |forms: &mut Forms, x: Id| values.get(&x).map_or_else(Sum::zero, |s| Sum::atom(forms.factor(s.as_ref().clone())));
        let (a, b, n) = match self.graph.node(id) {
            Node::Powi(a, n) => (a, a, n - 1),
            Node::Div(a, b) => (a, b, -1),
            Node::Mul(a, b) => (a, b, 1),
            _ => return Sum::zero(),
        };
        let (a, b) = (factor(forms, a), factor(forms, b));
        match (a.single(), b.single()) {
            (Some((m, _)), Some((other, _))) => Sum::term(m.times(&other.powi(n)), Number::ONE),
            _ => Sum::zero(),
        }
    }

    fn value(&mut self, forms: &mut Forms, id: Id, of: &dyn Fn(Id) -> Option<Rc<Sum>>) -> Option<Sum> {
        Some(match self.graph.node(id) {
            Node::Number(bits) => number(forms, f64::from_bits(bits)),
            Node::Symbol(s) => Sum::atom(self.symbol(forms, s)),
            Node::Add(a, b) => of(a)?.plus(&of(b)?.as_ref().clone(), Number::ONE),
            Node::Sub(a, b) => of(a)?.plus(&of(b)?.as_ref().clone(), Number::integer(-1)),
            Node::Neg(a) => of(a)?.scaled(Number::integer(-1)),
            Node::Mul(a, b) => forms.product(&*of(a)?, &*of(b)?)?,
            Node::Div(a, b) => {
                let inverse = forms.inverse(&*of(b)?);
                forms.product(&*of(a)?, &inverse)?
            }
            Node::Powi(a, n) => forms.powi(&*of(a)?, n)?,
            Node::Call(f, a) => {
                let x = of(a)?.as_ref().clone();
                let long = x.len() > LONG_ARGUMENT || forms.weight(&x) > HEAVY_ARGUMENT;
                let atom = forms.call(f, x);
                self.call(forms, id, atom, long)
            }
            Node::Call2(f, a, b) => {
                let (x, y) = (of(a)?.as_ref().clone(), of(b)?.as_ref().clone());
                let long = x.len().max(y.len()) > LONG_ARGUMENT || forms.weight(&x).max(forms.weight(&y)) > HEAVY_ARGUMENT;
                let atom = forms.call2(f, x, y);
                self.call(forms, id, atom, long)
            }
        })
    }
}

/// A number, as a ratio of pi where it is one.
fn number(forms: &mut Forms, x: f64) -> Sum {
    match Number::over_pi(x) {
        Some(ratio) => {
            let pi = forms.named("pi", Class::Pi, Depends::default());
            Sum::term(Monomial(vec![(pi, 1)]), ratio)
        }
        None => Sum::number(Number::of(x)),
    }
}
