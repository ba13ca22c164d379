//! The normal form: sums of monomials with exact coefficients over atoms.
//!
//! An atom is a name, a function call (its arguments in normal form), or a sum taken as one factor.
//! sin^2 is always 1 - cos^2 here and sqrt(x)^2 is x, so that what cancels does cancel: two equal
//! polynomials in sines and cosines are one form. Atoms are shared between all forms of one table,
//! by name: forms of two rigs can be compared. Knows nothing of rigs and of printing.

use super::number::Number;
use crate::expr::{F1, F2};
use indexmap::{IndexMap, IndexSet};
use rustc_hash::{FxBuildHasher, FxHashMap};

/// Place of an atom in the table.
pub type AtomId = u32;

/// What a name stands for; the order is the order of factors in a product.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Class {
    /// pi
    Pi,
    /// A parameter or lump that is neither of the next two.
    Parameter,
    /// A parameter that is an acceleration.
    Gravity,
    /// A parameter that is a length.
    Length,
    /// A named part of a long expression.
    Part,
    /// A coordinate.
    Coordinate,
    /// Time.
    Time,
    /// A rate.
    Rate,
    /// An actuator's state.
    Lag,
    /// An input, mixed input or exogenous signal.
    Signal,
    /// An acceleration.
    Acceleration,
}

/// What an atom depends on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Depends {
    /// On coordinates or time.
    pub place: bool,
    /// On rates.
    pub rate: bool,
    /// On signals, actuator states or accelerations.
    pub signal: bool,
}

impl Depends {
    /// On nothing that moves.
    pub fn is_static(self) -> bool {
        self == Self::default()
    }

    /// On rates or signals.
    pub fn moves(self) -> bool {
        self.rate || self.signal
    }

    /// On what either depends.
    pub fn or(self, other: Self) -> Self {
        Self { place: self.place || other.place, rate: self.rate || other.rate, signal: self.signal || other.signal }
    }
}

/// One factor.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Atom {
    /// Index into the table's names.
    Name(usize),
    /// f(x)
    Call(F1, Sum),
    /// f(x, y)
    Call2(F2, Sum, Sum),
    /// min(max(x, lo), hi)
    Saturate(Sum, Sum, Sum),
    /// A sum as one factor.
    Sum(Sum),
}

/// Product of powers of atoms, by ascending atom; no power is 0.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub struct Monomial(pub Vec<(AtomId, i32)>);

impl Monomial {
    /// 1
    pub fn one() -> Self {
        Self::default()
    }

    /// The product, powers of equal atoms added.
    pub fn times(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.0.iter().peekable(), other.0.iter().peekable());
        let mut out = Vec::with_capacity(self.0.len() + other.0.len());
        loop {
            match (a.peek(), b.peek()) {
                (Some(&&(x, m)), Some(&&(y, n))) if x == y => {
                    let sum = m.saturating_add(n);
                    if sum != 0 {
                        out.push((x, sum));
                    }
                    a.next();
                    b.next();
                }
                (Some(&&(x, m)), Some(&&(y, _))) if x < y => {
                    out.push((x, m));
                    a.next();
                }
                (Some(&&f), None) => {
                    out.push(f);
                    a.next();
                }
                (_, Some(&&f)) => {
                    out.push(f);
                    b.next();
                }
                (None, None) => return Self(out),
            }
        }
    }

    /// To an integer power.
    pub fn powi(&self, n: i32) -> Self {
        if n == 0 { Self::one() } else { Self(self.0.iter().map(|&(a, k)| (a, k.saturating_mul(n))).collect()) }
    }

    /// self / other, where no power changes its sign: other divides self.
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        let divides = other.0.iter().all(|&(a, n)| {
            let own = self.power(a);
            if n > 0 { own >= n } else { own <= n }
        });
        divides.then(|| self.times(&other.powi(-1)))
    }

    /// Power of an atom.
    pub fn power(&self, atom: AtomId) -> i32 {
        self.0.binary_search_by_key(&atom, |f| f.0).map_or(0, |i| self.0[i].1)
    }

    /// With an atom's power set.
    pub fn with_power(&self, atom: AtomId, power: i32) -> Self {
        let mut out = self.0.clone();
        match (out.binary_search_by_key(&atom, |f| f.0), power) {
            (Ok(i), 0) => {
                out.remove(i);
            }
            (Ok(i), _) => out[i].1 = power,
            (Err(_), 0) => {}
            (Err(i), _) => out.insert(i, (atom, power)),
        }
        Self(out)
    }

    /// Factors that `takes` accepts, and the others.
    pub fn split(&self, takes: impl Fn(AtomId) -> bool) -> (Self, Self) {
        let (yes, no) = self.0.iter().partition(|f| takes(f.0));
        (Self(yes), Self(no))
    }
}

/// Terms by ascending monomial; no coefficient is zero.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Default)]
pub struct Sum(pub Vec<(Monomial, Number)>);

impl Sum {
    /// 0
    pub fn zero() -> Self {
        Self::default()
    }

    /// A number.
    pub fn number(x: Number) -> Self {
        Self::term(Monomial::one(), x)
    }

    /// One term.
    pub fn term(m: Monomial, k: Number) -> Self {
        if k.is_zero() { Self::zero() } else { Self(vec![(m, k)]) }
    }

    /// One atom.
    pub fn atom(atom: AtomId) -> Self {
        Self::term(Monomial(vec![(atom, 1)]), Number::ONE)
    }

    /// Number of terms.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// 0
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The only term, if there is one only.
    pub fn single(&self) -> Option<(&Monomial, Number)> {
        match self.0.as_slice() {
            [(m, k)] => Some((m, *k)),
            _ => None,
        }
    }

    /// From terms in any order, like ones added up.
    pub fn collect(terms: impl IntoIterator<Item = (Monomial, Number)>) -> Self {
        let mut total: IndexMap<Monomial, Number, FxBuildHasher> = IndexMap::default();
        for (m, k) in terms {
            let entry = total.entry(m).or_insert(Number::ZERO);
            *entry = entry.add(k);
        }
        let mut terms: Vec<_> = total.into_iter().filter(|(_, k)| !k.is_zero()).collect();
        terms.sort_unstable_by(|a, b| a.0.cmp(&b.0));
        Self(terms)
    }

    /// self + k other
    pub fn plus(&self, other: &Self, k: Number) -> Self {
        Self::collect(self.0.iter().cloned().chain(other.0.iter().map(|(m, c)| (m.clone(), c.mul(k)))))
    }

    /// k self
    pub fn scaled(&self, k: Number) -> Self {
        if k.is_zero() {
            return Self::zero();
        }
        Self(self.0.iter().map(|(m, c)| (m.clone(), c.mul(k))).collect())
    }

    /// Every term times a monomial, without rewriting: for factors that were taken out before.
    pub fn shifted(&self, by: &Monomial) -> Self {
        Self::collect(self.0.iter().map(|(m, c)| (m.times(by), *c)))
    }

    /// Coefficient of a monomial.
    pub fn coefficient(&self, m: &Monomial) -> Number {
        self.0.binary_search_by(|t| t.0.cmp(m)).map_or(Number::ZERO, |i| self.0[i].1)
    }
}

#[derive(Clone)]
/// Names and atoms, and how much work may still be spent.
pub struct Forms {
    names: IndexSet<(String, Class), FxBuildHasher>,
    atoms: IndexSet<Atom, FxBuildHasher>,
    depends: Vec<Depends>,
    weights: Vec<u64>,
    /// Products of terms that may still be formed before forms are given up.
    pub work: u64,
}

/// Largest weight that a form may have: functions of functions of sums grow as fast as products do.
pub const MOST_WEIGHT: u64 = 8000;
/// Largest number of terms that a form may have.
pub const MOST_TERMS: usize = 800;

impl Forms {
    /// Empty table.
    pub fn new() -> Self {
        Self { names: IndexSet::default(), atoms: IndexSet::default(), depends: Vec::new(), weights: Vec::new(), work: 600_000 }
    }

    /// A name's text and class.
    pub fn name(&self, index: usize) -> (&str, Class) {
        self.names.get_index(index).map_or(("", Class::Part), |(text, class)| (text, *class))
    }

    /// The atom of a name. A part depends on what it stands for, so that is given.
    pub fn named(&mut self, text: &str, class: Class, part: Depends) -> AtomId {
        let (index, _) = self.names.insert_full((text.to_owned(), class));
        let depends = match class {
            Class::Pi | Class::Parameter | Class::Gravity | Class::Length => Depends::default(),
            Class::Part => part,
            Class::Coordinate | Class::Time => Depends { place: true, ..Depends::default() },
            Class::Rate => Depends { rate: true, ..Depends::default() },
            Class::Lag | Class::Signal | Class::Acceleration => Depends { signal: true, ..Depends::default() },
        };
        self.intern(Atom::Name(index), depends)
    }

    fn intern(&mut self, atom: Atom, depends: Depends) -> AtomId {
        let (index, new) = self.atoms.insert_full(atom);
        if new {
            self.depends.push(depends);
            let inner = match &self.atoms[index] {
                Atom::Name(_) => 0,
                Atom::Call(_, x) | Atom::Sum(x) => self.weight(x),
                Atom::Call2(_, x, y) => self.weight(x).saturating_add(self.weight(y)),
                Atom::Saturate(x, lo, hi) => self.weight(x).saturating_add(self.weight(lo)).saturating_add(self.weight(hi)),
            };
            self.weights.push(inner.saturating_add(1));
        }
        index as AtomId
    }

    /// The atom's content.
    pub fn atom(&self, id: AtomId) -> &Atom {
        &self.atoms[id as usize]
    }

    /// What the atom depends on.
    pub fn depends(&self, id: AtomId) -> Depends {
        self.depends[id as usize]
    }

    /// Number of names and functions that a form has when it is written out.
    pub fn weight(&self, sum: &Sum) -> u64 {
        sum.0.iter().flat_map(|t| &t.0.0).fold(0, |w, f| w.saturating_add(self.weights[f.0 as usize]))
    }

    /// What a form depends on.
    pub fn depends_of(&self, sum: &Sum) -> Depends {
        sum.0.iter().flat_map(|(m, _)| &m.0).fold(Depends::default(), |d, f| d.or(self.depends(f.0)))
    }

    /// The atom f(x), if it is known already.
    pub fn find_call(&self, f: F1, x: &Sum) -> Option<AtomId> {
        self.atoms.get_index_of(&Atom::Call(f, x.clone())).map(|i| i as AtomId)
    }

    /// f(x) as an atom.
    pub fn call(&mut self, f: F1, x: Sum) -> AtomId {
        let depends = self.depends_of(&x);
        // the regularized sign of friction is the hyperbolic tangent that it is
        let f = if f == F1::SmoothSign { F1::Tanh } else { f };
        self.intern(Atom::Call(f, x), depends)
    }

    /// f(x, y) as an atom.
    pub fn call2(&mut self, f: F2, x: Sum, y: Sum) -> AtomId {
        let depends = self.depends_of(&x).or(self.depends_of(&y));
        if f == F2::Min
            && let Some((m, k)) = x.single()
            && k.is_one()
            && let [(atom, 1)] = m.0.as_slice()
            && let Atom::Call2(F2::Max, value, lo) = self.atom(*atom).clone()
        {
            return self.intern(Atom::Saturate(value, lo, y), depends);
        }
        self.intern(Atom::Call2(f, x, y), depends)
    }

    /// A sum as one factor.
    pub fn factor(&mut self, sum: Sum) -> AtomId {
        let depends = self.depends_of(&sum);
        self.intern(Atom::Sum(sum), depends)
    }

    /// a b, or `None` where it grows beyond what is worth showing.
    pub fn product(&mut self, a: &Sum, b: &Sum) -> Option<Sum> {
        let cost = a.len() as u64 * b.len() as u64;
        if cost > 40_000 || cost > self.work {
            return None;
        }
        self.work -= cost;
        let mut total: FxHashMap<Monomial, Number> = FxHashMap::default();
        let mut order: Vec<(Monomial, Number)> = Vec::new();
        for (m, j) in &a.0 {
            for (n, k) in &b.0 {
                order.push((m.times(n), j.mul(*k)));
            }
        }
        let mut steps = 0;
        while let Some((m, k)) = order.pop() {
            match self.rewritten(&m) {
                Some(parts) => {
                    steps += 1;
                    if steps > 100_000 {
                        return None;
                    }
                    order.extend(parts.0.into_iter().map(|(m, c)| (m, c.mul(k))));
                }
                None => {
                    let entry = total.entry(m).or_insert(Number::ZERO);
                    *entry = entry.add(k);
                }
            }
        }
        // each entry was added up in a fixed order, whatever the order of the entries
        let mut terms: Vec<_> = total.into_iter().filter(|(_, k)| !k.is_zero()).collect();
        terms.sort_unstable_by(|a, b| a.0.cmp(&b.0));
        (terms.len() <= MOST_TERMS).then_some(Sum(terms))
    }

    /// One step of sin^2 = 1 - cos^2, sqrt(x)^2 = x, or a sum of positive power multiplied out.
    fn rewritten(&mut self, m: &Monomial) -> Option<Sum> {
        for &(atom, n) in &m.0 {
            match self.atom(atom) {
                Atom::Call(F1::Sin, x) if n >= 2 => {
                    let x = x.clone();
                    let cos = self.call(F1::Cos, x);
                    let rest = m.with_power(atom, n - 2);
                    let lowered = rest.times(&Monomial(vec![(cos, 2)]));
                    return Some(Sum::collect([(rest, Number::ONE), (lowered, Number::integer(-1))]));
                }
                Atom::Call(F1::Sqrt, x) if n.abs() >= 2 => {
                    let x = x.clone();
                    let rest = m.with_power(atom, n - 2 * n.signum());
                    if n > 0 {
                        return Some(x.shifted(&rest));
                    }
                    let inverse = self.inverse(&x);
                    return Some(inverse.shifted(&rest));
                }
                Atom::Sum(x) if n > 0 => {
                    let x = x.clone();
                    return Some(x.shifted(&m.with_power(atom, n - 1)));
                }
                _ => {}
            }
        }
        None
    }

    /// 1 / x: a monomial turned over, or a sum as one factor of power -1.
    pub fn inverse(&mut self, x: &Sum) -> Sum {
        if let Some((m, k)) = x.single() {
            return Sum::term(m.powi(-1), k.inverse());
        }
        if x.is_zero() {
            // stays to be seen: its value is for the evaluation to show
            return Sum::term(Monomial(vec![(self.factor(Sum::zero()), -1)]), Number::ONE);
        }
        // 2 a b + 2 a c = 2 a (b + c), so that equal denominators are one atom
        let (content, k, rest) = content(x);
        let atom = self.factor(rest);
        Sum::term(Monomial(vec![(atom, -1)]).times(&content.powi(-1)), k.inverse())
    }

    /// x^n
    pub fn powi(&mut self, x: &Sum, n: i32) -> Option<Sum> {
        if n < 0 {
            let inverse = self.inverse(x);
            // one monomial: its powers stay monomials
            let (m, k) = inverse.single()?;
            return Some(Sum::term(m.powi(-n), k.powi(-n)));
        }
        let mut result = Sum::number(Number::ONE);
        for _ in 0..n {
            result = self.product(&result, x)?;
        }
        Some(result)
    }

    /// Value of a form.
    pub fn evaluate(&self, sum: &Sum, value: &dyn Fn(&str, Class) -> f64) -> f64 {
        sum.0.iter().map(|(m, k)| k.value() * self.evaluate_monomial(m, value)).sum()
    }

    /// Value of a product.
    pub fn evaluate_monomial(&self, m: &Monomial, value: &dyn Fn(&str, Class) -> f64) -> f64 {
        m.0.iter().map(|&(a, n)| self.evaluate_atom(a, value).powi(n)).product()
    }

    fn evaluate_atom(&self, atom: AtomId, value: &dyn Fn(&str, Class) -> f64) -> f64 {
        match self.atom(atom) {
            Atom::Name(i) => match self.name(*i) {
                (_, Class::Pi) => std::f64::consts::PI,
                (text, class) => value(text, class),
            },
            Atom::Call(f, x) => f.apply(self.evaluate(x, value)),
            Atom::Call2(f, x, y) => f.apply(self.evaluate(x, value), self.evaluate(y, value)),
            Atom::Saturate(x, lo, hi) => self.evaluate(x, value).max(self.evaluate(lo, value)).min(self.evaluate(hi, value)),
            Atom::Sum(x) => self.evaluate(x, value),
        }
    }
}

/// The common monomial and ratio of a sum, and what is left: x = k m rest. Positive powers in all
/// terms are taken out, negative ones that all terms share too; the leading coefficient of the rest is
/// positive.
pub fn content(x: &Sum) -> (Monomial, Number, Sum) {
    let Some((first, lead)) = x.0.first() else { return (Monomial::one(), Number::ONE, Sum::zero()) };
    let mut common = first.clone();
    for (m, _) in &x.0[1..] {
        common = Monomial(
            common
                .0
                .iter()
                .filter_map(|&(a, n)| {
                    let other = m.power(a);
                    let shared = if n > 0 { n.min(other).max(0) } else { n.max(other).min(0) };
                    (shared != 0).then_some((a, shared))
                })
                .collect(),
        );
    }
    let k = common_ratio(x);
    let k = if lead.is_negative() { k.neg() } else { k };
    let (back, inverse) = (common.powi(-1), k.inverse());
    (common, k, Sum::collect(x.0.iter().map(|(m, c)| (m.times(&back), c.mul(inverse)))))
}

/// Greatest ratio that leaves whole coefficients, where all are ratios with few digits; else 1.
fn common_ratio(x: &Sum) -> Number {
    let gcd = |mut a: i64, mut b: i64| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.abs()
    };
    if let Some((_, first)) = x.0.first()
        && x.0.iter().all(|(_, k)| k.abs() == first.abs())
    {
        return first.abs();
    }
    let (mut top, mut bottom) = (0_i64, 1_i64);
    for (_, k) in &x.0 {
        let Some((p, q)) = k.fraction() else { return Number::ONE };
        top = gcd(top, p);
        bottom = match (bottom / gcd(bottom, q)).checked_mul(q) {
            Some(b) if b < 10_000 => b,
            _ => return Number::ONE,
        };
    }
    Number::Ratio(top.max(1), bottom)
}
