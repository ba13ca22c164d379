//! Inverse dynamics as products of parameters times functions of the motion: ID = sum of c_j(p) Y_j(q, v, a, u).
//!
//! The products are read off the normal form, so they hold for every model: derived, under assumptions, or
//! written directly. What is linearly independent among the Y_j is not asked here.

use super::arrange::{Knowledge, written};
use super::entries::knowledge;
use super::form::{Atom, AtomId, Class, Forms, Monomial, Sum};
use super::number::Number;
use super::read::{Reader, register};
use super::text::text;
use crate::equations::Equations;
use crate::expr::Id;
use indexmap::{IndexMap, IndexSet};
use model_dsl::rig::Rig;

/// Work that may be spent on multiplying out.
const WORK: u64 = 4_000_000;

/// Inverse dynamics of the free coordinates, taken apart.
pub struct TorqueForm {
    forms: Forms,
    knowledge: Knowledge,
    products: Vec<(Monomial, Vec<Sum>)>,
    rows: usize,
    /// Parameters inside functions of the motion (the width of a friction law): at their present values.
    pub inside: Vec<String>,
}

/// Takes the model apart; `None` where its equations are too long to be multiplied out.
#[must_use]
pub fn torque_form(rig: &Rig, e: &Equations) -> Option<TorqueForm> {
    let mut forms = Forms::new();
    register(rig, &mut forms);
    let mut reader = Reader::new(rig, &e.graph);
    let roots: Vec<Id> = e.free.iter().map(|&i| e.inverse_dynamics[i]).collect();
    forms.work = WORK;
    let read: Option<Vec<_>> = reader.read(&mut forms, &roots).into_iter().collect();
    let read = read?;
    let mut products: IndexMap<Monomial, Vec<Vec<(Monomial, Number)>>> = IndexMap::new();
    let mut inside = IndexSet::new();
    for (row, sum) in read.iter().enumerate() {
        for (m, k) in &sum.0 {
            let (own, moving) = m.split(|a| forms.depends(a).is_static() && !is_pi(&forms, a));
            moving.0.iter().for_each(|f| parameters_in(&forms, f.0, &mut inside));
            if !own.0.is_empty() {
                products.entry(own).or_insert_with(|| vec![Vec::new(); roots.len()])[row].push((moving, *k));
            }
        }
    }
    let mut products: Vec<(Monomial, Vec<Sum>)> =
        products.into_iter().map(|(m, rows)| (m, rows.into_iter().map(Sum::collect).collect())).collect();
    // plain products first: longer ones are then told as what is added to them
    products.sort_by_key(|(m, _)| (m.0.iter().map(|f| f.1.unsigned_abs()).sum::<u32>(), m.clone()));
    let knowledge = knowledge(rig, e, &mut reader, &mut forms, &[]);
    let inside = inside.into_iter().collect();
    Some(TorqueForm { forms, knowledge, products, rows: roots.len(), inside })
}

fn is_pi(forms: &Forms, atom: AtomId) -> bool {
    matches!(forms.atom(atom), Atom::Name(i) if forms.name(*i).1 == Class::Pi)
}

/// Names of the parameters that an atom is made of.
fn parameters_in(forms: &Forms, atom: AtomId, found: &mut IndexSet<String>) {
    let mut within = |sums: &[&Sum]| {
        for (m, _) in sums.iter().flat_map(|s| &s.0) {
            m.0.iter().for_each(|f| parameters_in(forms, f.0, found));
        }
    };
    match forms.atom(atom) {
        Atom::Name(i) => {
            let (name, class) = forms.name(*i);
            if matches!(class, Class::Parameter | Class::Gravity | Class::Length) {
                found.insert(name.to_owned());
            }
        }
        Atom::Call(_, x) | Atom::Sum(x) => within(&[x]),
        Atom::Call2(_, x, y) => within(&[x, y]),
        Atom::Saturate(x, lo, hi) => within(&[x, lo, hi]),
    }
}

impl TorqueForm {
    /// Number of products.
    #[must_use]
    pub fn len(&self) -> usize {
        self.products.len()
    }

    /// No parameter stands in the equations.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.products.is_empty()
    }

    /// Rows of Y: the free coordinates.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Y at a state: rows x products. `value` gives every coordinate, rate, acceleration, signal and parameter by its name.
    #[must_use]
    pub fn regressor(&self, value: &dyn Fn(&str) -> f64) -> Vec<Vec<f64>> {
        let of = |name: &str, _: Class| value(name);
        (0..self.rows).map(|i| self.products.iter().map(|(_, rows)| self.forms.evaluate(&rows[i], &of)).collect()).collect()
    }

    /// Values of the products for the parameters that `value` gives.
    #[must_use]
    pub fn values(&self, value: &dyn Fn(&str) -> f64) -> Vec<f64> {
        self.products.iter().map(|(m, _)| self.forms.evaluate_monomial(m, &|name, _| value(name))).collect()
    }

    /// Names of the parameters in a product.
    #[must_use]
    pub fn parameters_of(&self, product: usize) -> Vec<String> {
        let mut found = IndexSet::new();
        self.products[product].0.0.iter().for_each(|f| parameters_in(&self.forms, f.0, &mut found));
        found.into_iter().collect()
    }

    /// A sum of products as a person writes it, lumps by their names.
    #[must_use]
    pub fn words(&mut self, terms: &[(usize, f64)]) -> String {
        let sum = Sum::collect(terms.iter().map(|&(j, k)| (self.products[j].0.clone(), Number::of(k))));
        text(&written(&mut self.forms, &self.knowledge, &sum))
    }
}
