//! From a normal form to what is written: terms grouped by what moves, coefficients collected and factored,
//! factors and terms in the order in which a person writes them.
//!
//! Where two ways of writing are possible the shorter text wins.

use super::form::{Atom, AtomId, Class, Forms, Monomial, Sum, content};
use super::number::Number;
use super::shorten::{self, Known, MixAtoms};
use super::text::text;
use super::tree::Tree;
use crate::expr::{F1, F2};
use rustc_hash::FxHashMap;
use std::cell::RefCell;

/// What a rig lets one recognize.
#[derive(Default)]
pub struct Knowledge {
    /// Lumps by their definitions.
    pub lumps: Vec<Known>,
    /// Mixed inputs.
    pub mixes: Vec<MixAtoms>,
    /// Sums that stand as factors: stretches, differences of rates.
    pub factors: Vec<Known>,
    /// Atoms that were written before.
    trees: RefCell<FxHashMap<AtomId, Tree>>,
}

impl Knowledge {
    /// Lumps, mixed inputs, factors.
    pub fn new(lumps: Vec<Known>, mixes: Vec<MixAtoms>, factors: Vec<Known>) -> Self {
        Self { lumps, mixes, factors, trees: RefCell::default() }
    }
}

/// A term: coefficient and product.
type Term = (Monomial, Number);

/// The written form of a normal form.
pub fn written(forms: &mut Forms, knowledge: &Knowledge, sum: &Sum) -> Tree {
    let short = shortened(forms, knowledge, sum);
    let terms = grouped(forms, knowledge, &short);
    let expanded = Tree::sum(trees(forms, knowledge, &terms));
    // (w - z)/tau: one denominator under all terms
    let (common, _, _) = content(&short);
    let below = Monomial(common.0.into_iter().filter(|f| f.1 < 0).collect());
    if terms.len() < 2 || below.0.is_empty() {
        return expanded;
    }
    let factor = forms.factor(short.shifted(&below.powi(-1)));
    let over_all = product(forms, knowledge, &below.with_power(factor, 1), Number::ONE);
    if text(&over_all).len() <= text(&expanded).len() { over_all } else { expanded }
}

/// Terms with their signs.
fn trees(forms: &mut Forms, knowledge: &Knowledge, terms: &[Term]) -> Vec<(bool, Tree)> {
    terms.iter().map(|(m, k)| (k.is_negative(), product(forms, knowledge, m, k.abs()))).collect()
}

/// A sum inside brackets: what moves before constants where it is an angle or a stretch, a term with a plus first.
fn bracketed(forms: &mut Forms, knowledge: &Knowledge, sum: &Sum) -> Tree {
    let mut terms = grouped(forms, knowledge, sum);
    let plain = |forms: &Forms, a: AtomId| forms.depends(a).is_static() || matches!(forms.atom(a), Atom::Name(_));
    if terms.iter().all(|t| t.0.0.iter().all(|f| plain(forms, f.0))) {
        terms.sort_by_key(|t| t.0.0.iter().all(|f| forms.depends(f.0).is_static()));
    }
    if let Some(first) = terms.iter().position(|t| !t.1.is_negative()) {
        terms[..=first].rotate_right(1);
    }
    Tree::sum(trees(forms, knowledge, &terms))
}

/// With fewer terms: denominators, mixed inputs, factors, trigonometry, lumps.
pub fn shortened(forms: &mut Forms, knowledge: &Knowledge, sum: &Sum) -> Sum {
    let mut sum = shorten::cancelled(forms, sum);
    for mix in &knowledge.mixes {
        sum = shorten::mixed_inputs(&sum, mix);
    }
    sum = shorten::recognized(&sum, &knowledge.factors);
    sum = shorten::trigonometry(forms, &sum);
    let mut out: Vec<Term> = Vec::new();
    for (moving, coefficient) in by_factor(&sum, |a| !forms.depends(a).is_static()) {
        let coefficient = shorten::recognized(&coefficient, &knowledge.lumps);
        out.extend(coefficient.shifted(&moving).0);
    }
    shorten::signals_together(forms, &Sum::collect(out))
}

/// Splits a sum by the factors that `takes` accepts: (their product, what multiplies it).
fn by_factor(sum: &Sum, takes: impl Fn(AtomId) -> bool) -> Vec<(Monomial, Sum)> {
    let mut groups: Vec<(Monomial, Vec<Term>)> = Vec::new();
    for (m, k) in &sum.0 {
        let (inside, outside) = m.split(&takes);
        match groups.iter_mut().find(|g| g.0 == inside) {
            Some(group) => group.1.push((outside, *k)),
            None => groups.push((inside, vec![(outside, *k)])),
        }
    }
    groups.into_iter().map(|(m, terms)| (m, Sum::collect(terms))).collect()
}

/// Terms as written, in order: by rates and signals, then by functions of position, then by coefficient.
fn grouped(forms: &mut Forms, knowledge: &Knowledge, sum: &Sum) -> Vec<Term> {
    // stretches and named lengths are taken out like rates
    let leads = |a: AtomId| match forms.atom(a) {
        Atom::Sum(_) => !forms.depends(a).is_static(),
        Atom::Name(i) => forms.depends(a).moves() || forms.name(*i).1 == Class::Part,
        _ => forms.depends(a).moves(),
    };
    let mut by_motion = by_factor(sum, leads);
    by_motion.sort_by_cached_key(|(v, _)| key(forms, v));
    let mut out = Vec::new();
    for (v, inner) in by_motion {
        let expanded = by_place(forms, knowledge, &inner, &v);
        if v.0.is_empty() || expanded.len() < 2 {
            out.extend(expanded);
            continue;
        }
        let (common, k, rest) = content(&inner);
        let factor = forms.factor(rest);
        let factored = vec![(common.times(&v).with_power(factor, 1), k)];
        out.extend(shorter(forms, knowledge, factored, expanded, 1.0));
    }
    out
}

/// Terms of one motion, each coefficient collected; `with` multiplies all.
fn by_place(forms: &mut Forms, knowledge: &Knowledge, sum: &Sum, with: &Monomial) -> Vec<Term> {
    let mut groups = by_factor(sum, |a| !forms.depends(a).is_static());
    groups.sort_by_cached_key(|(f, c)| {
        let lead = c.0.iter().map(|t| key(forms, &t.0)).min();
        (!f.0.is_empty(), lead, key(forms, f))
    });
    let mut out = Vec::new();
    while !groups.is_empty() {
        let (f, c) = groups.remove(0);
        // the same long coefficient again: C (F + G)
        let negative = c.scaled(Number::integer(-1));
        let mut places = vec![(f, Number::ONE)];
        if c.len() > 1 {
            groups.retain(|(g, other)| {
                let sign = if *other == c { Number::ONE } else { Number::integer(-1) };
                let same = *other == c || *other == negative;
                if same {
                    places.push((g.clone(), sign));
                }
                !same
            });
        }
        let place = if places.len() == 1 {
            Sum(places)
        } else {
            let (common, k, rest) = content(&Sum::collect(places));
            Sum::term(common.with_power(forms.factor(rest), 1), k)
        };
        for (f, k) in place.0 {
            out.extend(coefficient(forms, knowledge, &c.scaled(k), &f.times(with)));
        }
    }
    out
}

/// A coefficient times what it multiplies: as one factored term, or multiplied out, whichever is shorter.
fn coefficient(forms: &mut Forms, knowledge: &Knowledge, c: &Sum, with: &Monomial) -> Vec<Term> {
    let mut terms = c.0.clone();
    terms.sort_by_cached_key(|(m, _)| key(forms, m));
    if let Some(first) = terms.iter().position(|t| !t.1.is_negative()) {
        terms[..=first].rotate_right(1);
    }
    let expanded: Vec<Term> = terms.into_iter().map(|(m, k)| (m.times(with), k)).collect();
    if expanded.len() < 2 {
        return expanded;
    }
    let (common, k, rest) = content(c);
    let all_negative = rest.0.iter().all(|t| t.1.is_negative());
    let (k, rest) = if all_negative { (k.neg(), rest.scaled(Number::integer(-1))) } else { (k, rest) };
    // a minus in front of a bracket only where everything inside would have one
    let (k, rest) =
        if k.is_negative() && rest.0.iter().any(|t| t.1.is_negative()) { (k.neg(), rest.scaled(Number::integer(-1))) } else { (k, rest) };
    if common.0.is_empty() && k.abs().is_one() && with.0.is_empty() {
        return expanded;
    }
    let factor = forms.factor(rest);
    let factored = vec![(common.times(with).with_power(factor, 1), k)];
    // by itself a sum of products reads better than a product with a bracket, unless that is much shorter
    let bonus = if with.0.is_empty() { 0.7 } else { 1.0 };
    shorter(forms, knowledge, factored, expanded, bonus)
}

/// The first of two ways of writing if it is shorter than `bonus` times the other one.
fn shorter(forms: &mut Forms, knowledge: &Knowledge, one: Vec<Term>, other: Vec<Term>, bonus: f64) -> Vec<Term> {
    let mut length = |terms: &[Term]| text(&Tree::sum(trees(forms, knowledge, terms))).len() as f64;
    if length(&one) <= bonus * length(&other) { one } else { other }
}

/// Rank of a factor in a product, then its place within the rank.
type FactorKey = (u8, usize, AtomId);

/// Order of products: factor by factor, higher powers first.
fn key(forms: &Forms, m: &Monomial) -> Vec<(FactorKey, i32)> {
    let mut factors: Vec<(FactorKey, i32)> = m.0.iter().map(|&(a, n)| (factor_key(forms, a), -n)).collect();
    factors.sort_unstable();
    factors
}

fn factor_key(forms: &Forms, atom: AtomId) -> FactorKey {
    let depends = forms.depends(atom);
    let rank = match forms.atom(atom) {
        Atom::Name(i) => match forms.name(*i).1 {
            Class::Pi => 0,
            Class::Parameter => 1,
            Class::Gravity => 2,
            Class::Length => 3,
            Class::Part if depends.is_static() => 4,
            Class::Part if depends.moves() => 14,
            Class::Part => 8,
            Class::Coordinate | Class::Time => 9,
            Class::Rate => 15,
            Class::Lag | Class::Signal => 17,
            Class::Acceleration => 19,
        },
        _ if depends.signal => 18,
        _ if depends.rate => 16,
        _ if depends.is_static() => 5,
        Atom::Call(F1::Cos, _) => 10,
        Atom::Call(F1::Sin, _) => 11,
        Atom::Sum(_) => 13,
        _ => 12,
    };
    (rank, first_name(forms, atom), atom)
}

/// The earliest declared name in an atom, moving ones before parameters.
fn first_name(forms: &Forms, atom: AtomId) -> usize {
    let of = |sums: &[&Sum]| {
        sums.iter()
            .flat_map(|s| &s.0)
            .flat_map(|t| &t.0.0)
            .map(|f| (forms.depends(f.0).is_static(), first_name(forms, f.0)))
            .min()
            .map_or(0, |x| x.1)
    };
    match forms.atom(atom) {
        Atom::Name(i) => *i,
        Atom::Call(_, x) | Atom::Sum(x) => of(&[x]),
        Atom::Call2(_, x, y) => of(&[x, y]),
        Atom::Saturate(x, lo, hi) => of(&[x, lo, hi]),
    }
}

/// A product with a positive coefficient: what divides goes under a line, with what does not move.
pub fn product(forms: &mut Forms, knowledge: &Knowledge, m: &Monomial, k: Number) -> Tree {
    let mut factors = m.0.clone();
    factors.sort_by_cached_key(|f| factor_key(forms, f.0));
    let (above, below): (Vec<_>, Vec<_>) = factors.into_iter().partition(|f| f.1 > 0);
    let fixed = |forms: &Forms, list: &[(AtomId, i32)]| list.iter().map(|f| forms.depends(f.0).is_static()).collect::<Vec<bool>>();
    let (fixed_above, fixed_below) = (fixed(forms, &above), fixed(forms, &below));
    let mut powers = |list: Vec<(AtomId, i32)>| -> Vec<Tree> {
        list.into_iter()
            .map(|(atom, n)| {
                let tree = atom_tree(forms, knowledge, atom);
                if n.abs() == 1 { tree } else { Tree::Power(Box::new(tree), Box::new(Tree::integer(i64::from(n.abs())))) }
            })
            .collect()
    };
    let (above, below) = (powers(above), powers(below));
    // pi/6, not 1/6 pi
    let circle = above.first() == Some(&Tree::Name("pi".to_owned())) && k.fraction().is_some_and(|(_, q)| q != 1);
    if below.is_empty() && !circle {
        return Tree::product([vec![Tree::Number(k)], above].concat());
    }
    let (p, q) = match k.fraction() {
        Some((p, q)) => (Tree::integer(p), Tree::integer(q)),
        None => (Tree::Number(k), Tree::integer(1)),
    };
    let bottom = Tree::product([vec![q], below].concat());
    // m_h g l_cd/I_eps cos(theta), but cos(theta)/(1 + cos(theta)) and v/w
    let all = fixed_below.contains(&false) || !fixed_above.contains(&true);
    let (mut top, mut beside) = (vec![p], Vec::new());
    for (tree, fixed) in above.into_iter().zip(fixed_above) {
        if all || fixed { top.push(tree) } else { beside.push(tree) }
    }
    let quotient = Tree::Quotient(Box::new(Tree::product(top)), Box::new(bottom));
    Tree::product([vec![quotient], beside].concat())
}

fn atom_tree(forms: &mut Forms, knowledge: &Knowledge, atom: AtomId) -> Tree {
    if let Some(tree) = knowledge.trees.borrow().get(&atom) {
        return tree.clone();
    }
    let tree = new_atom_tree(forms, knowledge, atom);
    knowledge.trees.borrow_mut().insert(atom, tree.clone());
    tree
}

fn new_atom_tree(forms: &mut Forms, knowledge: &Knowledge, atom: AtomId) -> Tree {
    match forms.atom(atom).clone() {
        Atom::Name(i) => Tree::Name(forms.name(i).0.to_owned()),
        Atom::Call(f, x) => Tree::Call(name1(f), vec![argument(forms, knowledge, &x)]),
        Atom::Call2(F2::Pow, x, y) => Tree::Power(Box::new(argument(forms, knowledge, &x)), Box::new(argument(forms, knowledge, &y))),
        Atom::Call2(f, x, y) => Tree::Call(name2(f), vec![argument(forms, knowledge, &x), argument(forms, knowledge, &y)]),
        Atom::Saturate(x, lo, hi) => Tree::Call("saturate", [x, lo, hi].iter().map(|s| argument(forms, knowledge, s)).collect()),
        // its terms were shortened before, as part of the whole
        Atom::Sum(x) => bracketed(forms, knowledge, &x),
    }
}

/// By itself, as an argument of a function or an output: what moves stands before constants.
pub fn argument(forms: &mut Forms, knowledge: &Knowledge, sum: &Sum) -> Tree {
    let short = shortened(forms, knowledge, sum);
    let whole = written(forms, knowledge, sum);
    if matches!(whole, Tree::Sum(_)) { bracketed(forms, knowledge, &short) } else { whole }
}

fn name1(f: F1) -> &'static str {
    match f {
        F1::Sin => "sin",
        F1::Cos => "cos",
        F1::Tan => "tan",
        F1::Asin => "asin",
        F1::Acos => "acos",
        F1::Atan => "atan",
        F1::Sinh => "sinh",
        F1::Cosh => "cosh",
        F1::Tanh | F1::SmoothSign => "tanh",
        F1::Exp => "exp",
        F1::Ln => "ln",
        F1::Sqrt => "sqrt",
        F1::Abs => "abs",
        F1::Sign => "sign",
        F1::Step => "step",
    }
}

fn name2(f: F2) -> &'static str {
    match f {
        F2::Atan2 => "atan2",
        F2::Min => "min",
        F2::Max => "max",
        F2::Pow => "pow",
    }
}
