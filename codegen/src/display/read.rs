//! From the graph to normal forms, within a budget.
//!
//! `read` multiplies everything out and gives up on what grows too long; `read_in_parts` keeps the
//! graph's own labelled values (`omega_arm_y`) as names with definitions beside them, and always ends.

use super::form::{AtomId, Class, Forms, MOST_TERMS, Monomial, Sum};
use super::number::Number;
use crate::expr::{Graph, Id, Node, SymbolId, SymbolKind};
use model_dsl::rig::Rig;
use model_dsl::units::{Dimension, Unit};
use rustc_hash::{FxHashMap, FxHashSet};
use std::rc::Rc;

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
    let none = super::form::Depends::default();
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
    forms.named(&d.name, class_of(&d.unit), super::form::Depends::default())
}

/// Reads one graph into forms.
pub struct Reader<'a> {
    rig: &'a Rig,
    graph: &'a Graph,
    symbols: FxHashMap<SymbolId, AtomId>,
    memo: FxHashMap<Id, Option<Rc<Sum>>>,
}

impl<'a> Reader<'a> {
    /// Reader of a rig's graph.
    pub fn new(rig: &'a Rig, graph: &'a Graph) -> Self {
        Self { rig, graph, symbols: FxHashMap::default(), memo: FxHashMap::default() }
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
        let atom = forms.named(&info.name, class, super::form::Depends::default());
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
                self.memo.insert(id, value.filter(|s| s.len() <= MOST_TERMS).map(Rc::new));
            }
        }
        roots.iter().map(|id| self.memo[id].clone()).collect()
    }

    /// Over the graph's labelled values, which are given names and definitions.
    pub fn read_in_parts(&mut self, forms: &mut Forms, roots: &[Id]) -> (Vec<Sum>, Vec<Part>) {
        let mut values: FxHashMap<Id, Rc<Sum>> = FxHashMap::default();
        let mut parts = Vec::new();
        let mut taken: FxHashSet<String> = FxHashSet::default();
        let mut numbered: FxHashMap<String, usize> = FxHashMap::default();
        for id in self.graph.reachable(roots) {
            let value = match self.value(forms, id, &|x| values.get(&x).cloned()) {
                Some(value) => value,
                None => self.opaque(forms, id, &values),
            };
            let short = value.len() <= 1 && value.0.iter().all(|(m, _)| m.0.len() <= 2);
            let label = self.graph.label_of(id);
            let long = value.len() > if label.is_some() { 1 } else { LONG_PART };
            let value = if short || !long || roots.contains(&id) {
                Rc::new(value)
            } else {
                let base = label.map_or_else(|| format!("{}_", self.graph.scope_of(id).replace([' ', '.'], "_")), str::to_owned);
                let mut name = base.clone();
                while label.is_none() && name == base || !taken.insert(name.clone()) {
                    let n = numbered.entry(base.clone()).or_insert(usize::from(label.is_some()));
                    *n += 1;
                    name = if label.is_some() { format!("{base}_{n}") } else { format!("{base}{n}") };
                }
                let atom = forms.named(&name, Class::Part, forms.depends_of(&value));
                parts.push(Part { atom, value });
                Rc::new(Sum::atom(atom))
            };
            values.insert(id, value);
        }
        let roots = roots.iter().map(|id| values[id].as_ref().clone()).collect();
        (roots, parts)
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
                Sum::atom(forms.call(f, x))
            }
            Node::Call2(f, a, b) => {
                let (x, y) = (of(a)?.as_ref().clone(), of(b)?.as_ref().clone());
                Sum::atom(forms.call2(f, x, y))
            }
        })
    }
}

/// A number, as a ratio of pi where it is one.
fn number(forms: &mut Forms, x: f64) -> Sum {
    match Number::over_pi(x) {
        Some(ratio) => {
            let pi = forms.named("pi", Class::Pi, super::form::Depends::default());
            Sum::term(Monomial(vec![(pi, 1)]), ratio)
        }
        None => Sum::number(Number::of(x)),
    }
}
