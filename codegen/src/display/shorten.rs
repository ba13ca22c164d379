//! Fewer terms by what a person knows: 1 - cos^2 = sin^2, sums of angles, mixed inputs, lumps, sums that
//! stand as factors, denominators that cancel. Every step keeps the value and takes terms away.

use super::form::{Atom, AtomId, Class, Depends, Forms, Monomial, Sum, content};
use super::number::Number;
use crate::expr::F1;
use std::cmp::Ordering;

/// Rounds that a rewrite may go; each takes at least one term away, so this is never reached in practice.
const ROUNDS: usize = 400;

/// 1 - cos^2 x = sin^2 x and the like, then cos a cos b - sin a sin b = cos(a + b) and its kin.
pub fn trigonometry(forms: &mut Forms, sum: &Sum) -> Sum {
    let sum = squares(forms, sum);
    angle_sums(forms, &sum)
}

/// For a R + b R cos^2 x: a R sin^2 x where a = -b, -a R cos 2x where b = -2a, and (a + b) R - b R sin^2 x where
/// that has no minus.
fn squares(forms: &mut Forms, sum: &Sum) -> Sum {
    let mut sum = sum.clone();
    for _ in 0..ROUNDS {
        let mut step = None;
        // highest powers first, so that cos^4 - cos^2 becomes -cos^2 sin^2
        let mut candidates: Vec<(i32, usize, AtomId)> = Vec::new();
        for (i, (m, _)) in sum.0.iter().enumerate() {
            for &(atom, n) in &m.0 {
                if n >= 2 && matches!(forms.atom(atom), Atom::Call(F1::Cos, _)) {
                    candidates.push((-n, i, atom));
                }
            }
        }
        candidates.sort_unstable();
        for (minus_n, i, cos) in candidates {
            let (m, b) = sum.0[i].clone();
            let base = m.with_power(cos, -minus_n - 2);
            let a = sum.coefficient(&base);
            if a.is_zero() {
                continue;
            }
            let both = a.add(b);
            let all_positive = !a.is_negative() && b.is_negative() && !both.is_negative();
            if both.is_zero() || all_positive || both == a.neg() {
                step = Some((m, a, b, base, cos));
                break;
            }
        }
        let Some((m, a, b, base, cos)) = step else { return sum };
        let Atom::Call(_, x) = forms.atom(cos).clone() else { return sum };
        if a.add(b) == a.neg() {
            let double = forms.call(F1::Cos, x.scaled(Number::integer(2)));
            let turned = base.with_power(double, base.power(double) + 1);
            sum = Sum::collect(sum.0.iter().cloned().chain([(m, b.neg()), (base, a.neg()), (turned, a.neg())]));
            continue;
        }
        let sin = forms.call(F1::Sin, x);
        let lifted = base.with_power(sin, base.power(sin) + 2);
        sum = Sum::collect(sum.0.iter().cloned().chain([(m, b.neg()), (base, b), (lifted, b.neg())]));
    }
    sum
}

/// cos a cos b -+ sin a sin b = cos(a +- b), sin a cos b +- cos a sin b = sin(a +- b).
fn angle_sums(forms: &mut Forms, sum: &Sum) -> Sum {
    let mut sum = sum.clone();
    for _ in 0..ROUNDS {
        let mut step = None;
        'search: for (m, k) in &sum.0 {
            let angles: Vec<(AtomId, F1, Sum)> =
                m.0.iter()
                    .filter(|f| f.1 > 0)
                    .filter_map(|f| match forms.atom(f.0) {
                        Atom::Call(g @ (F1::Sin | F1::Cos), x) => Some((f.0, *g, x.clone())),
                        _ => None,
                    })
                    .collect();
            for (i, (atom_a, f_a, a)) in angles.iter().enumerate() {
                for (atom_b, f_b, b) in &angles[i + 1..] {
                    if a == b {
                        continue;
                    }
                    // the partner has sin for cos and cos for sin
                    let turned = |f: F1| if f == F1::Sin { F1::Cos } else { F1::Sin };
                    let (Some(other_a), Some(other_b)) = (forms.find_call(turned(*f_a), a), forms.find_call(turned(*f_b), b)) else {
                        continue;
                    };
                    let lower = |m: &Monomial, atom: AtomId| m.with_power(atom, m.power(atom) - 1);
                    let rest = lower(&lower(m, *atom_a), *atom_b);
                    let raise = |m: &Monomial, atom: AtomId| m.with_power(atom, m.power(atom) + 1);
                    let partner = raise(&raise(&rest, other_a), other_b);
                    let j = sum.coefficient(&partner);
                    if j.is_zero() || j.abs() != k.abs() {
                        continue;
                    }
                    let equal = j == *k;
                    // (function, b added or subtracted, sign)
                    let (f, minus, k_new) = match (f_a, f_b) {
                        (F1::Cos, F1::Cos) => (F1::Cos, equal, *k),
                        (F1::Sin, F1::Sin) => (F1::Cos, equal, if equal { *k } else { k.neg() }),
                        // k sin a cos b + j cos a sin b
                        (F1::Sin, F1::Cos) => (F1::Sin, !equal, *k),
                        // k cos a sin b + j sin a cos b = j sin(a +- b)
                        _ => (F1::Sin, !equal, j),
                    };
                    let angle = a.plus(b, Number::integer(if minus { -1 } else { 1 }));
                    step = Some((m.clone(), *k, partner, j, rest, f, angle, k_new));
                    break 'search;
                }
            }
        }
        let Some((m, k, partner, j, rest, f, angle, k_new)) = step else { return sum };
        let (angle, k_new) = upright(f, angle, k_new);
        let atom = forms.call(f, angle);
        let merged = rest.with_power(atom, rest.power(atom) + 1);
        sum = Sum::collect(sum.0.iter().cloned().chain([(m, k.neg()), (partner, j.neg()), (merged, k_new)]));
    }
    sum
}

/// sin(b - a) = -sin(a - b): the first name of an angle has a plus.
fn upright(f: F1, angle: Sum, k: Number) -> (Sum, Number) {
    match angle.0.first() {
        Some((_, first)) if first.is_negative() => (angle.scaled(Number::integer(-1)), if f == F1::Sin { k.neg() } else { k }),
        _ => (angle, k),
    }
}

/// New inputs as combinations of old ones.
pub struct MixAtoms {
    /// The old inputs.
    pub old: Vec<AtomId>,
    /// The new inputs.
    pub new: Vec<AtomId>,
    /// old = inverse new
    pub inverse: Vec<Vec<Number>>,
}

/// Old inputs by mixed ones, where that takes terms away: a f_1 + a f_2 = a f_s.
pub fn mixed_inputs(sum: &Sum, mix: &MixAtoms) -> Sum {
    let mut rest: Vec<(Monomial, Vec<Number>)> = Vec::new();
    let mut out: Vec<(Monomial, Number)> = Vec::new();
    for (m, k) in &sum.0 {
        let (inputs, other) = m.split(|a| mix.old.contains(&a));
        let place = match inputs.0.as_slice() {
            [(atom, 1)] => mix.old.iter().position(|o| o == atom),
            _ => None,
        };
        match place {
            None => out.push((m.clone(), *k)),
            Some(j) => {
                let index = rest.iter().position(|r| r.0 == other).unwrap_or_else(|| {
                    rest.push((other, vec![Number::ZERO; mix.old.len()]));
                    rest.len() - 1
                });
                rest[index].1[j] = *k;
            }
        }
    }
    for (other, old) in rest {
        let new: Vec<Number> = (0..mix.new.len())
            .map(|i| old.iter().zip(&mix.inverse).fold(Number::ZERO, |total, (k, row)| total.add(k.mul(row[i]))))
            .collect();
        let count = |v: &[Number]| v.iter().filter(|k| !k.is_zero()).count();
        let (atoms, coefficients) = if count(&new) < count(&old) { (&mix.new, new) } else { (&mix.old, old) };
        out.extend(atoms.iter().zip(coefficients).map(|(&a, k)| (other.with_power(a, 1), k)));
    }
    Sum::collect(out)
}

/// Longest sum in which multiples of other sums are looked for.
const LONGEST_SEARCH: usize = 200;

/// Denominators that divide what stands over them.
pub fn cancelled(forms: &Forms, sum: &Sum) -> Sum {
    let mut sum = sum.clone();
    if sum.len() > LONGEST_SEARCH {
        return sum;
    }
    // what was tried without success: denominator, its power, moving factors beside it
    let mut tried: Vec<(AtomId, i32, Monomial)> = Vec::new();
    for _ in 0..ROUNDS {
        let mut step = None;
        'search: for (m, _) in &sum.0 {
            for &(atom, n) in &m.0 {
                let (true, Atom::Sum(bottom)) = (n < 0, forms.atom(atom)) else { continue };
                // the terms over this denominator whose other moving factors are the same
                let fixed = forms.depends(atom).is_static();
                let moving = |m: &Monomial| m.split(|a| fixed && !forms.depends(a).is_static()).0;
                let wanted = moving(m);
                let attempt = (atom, n, wanted.clone());
                if tried.contains(&attempt) {
                    continue;
                }
                tried.push(attempt);
                let (over, rest): (Vec<_>, Vec<_>) = sum.0.iter().cloned().partition(|(t, _)| t.power(atom) == n && moving(t) == wanted);
                if over.len() < bottom.len() {
                    continue;
                }
                let over = Sum::collect(over.into_iter().map(|(t, k)| (t.with_power(atom, 0), k)));
                if let Some(quotient) = exact_quotient(&over, bottom) {
                    step = Some(Sum::collect(rest.into_iter().chain(quotient.0.into_iter().map(|(t, k)| (t.with_power(atom, n + 1), k)))));
                    break 'search;
                }
            }
        }
        match step {
            Some(next) => {
                sum = next;
                tried.clear();
            }
            None => return sum,
        }
    }
    sum
}

/// A sum that is shown by one atom: a lump by its name, or a stretch (x - rest) as one factor.
pub struct Known {
    /// What it stands for.
    pub value: Sum,
    /// The atom.
    pub atom: AtomId,
}

/// Replaces multiples of known sums where that takes terms away, and powers of known products.
pub fn recognized(sum: &Sum, known: &[Known]) -> Sum {
    let mut sum = sum.clone();
    if sum.len() > LONGEST_SEARCH {
        return sum;
    }
    for entry in known {
        if let Some((product, k)) = entry.value.single() {
            sum = product_recognized(&sum, product, k, entry.atom);
            continue;
        }
        for _ in 0..ROUNDS {
            match once_recognized(&sum, entry) {
                Some(next) => sum = next,
                None => break,
            }
        }
    }
    sum
}

fn product_recognized(sum: &Sum, product: &Monomial, k: Number, atom: AtomId) -> Sum {
    if product.0.len() < 2 && !k.is_one() || product.0.is_empty() {
        return sum.clone();
    }
    Sum::collect(sum.0.iter().map(|(m, c)| {
        let (mut m, mut c) = (m.clone(), *c);
        while let Some(rest) = m.divided_by(product) {
            m = rest.with_power(atom, rest.power(atom) + 1);
            c = c.mul(k.inverse());
        }
        (m, c)
    }))
}

/// The terms to try: all, those that share a factor, and single multiples.
fn once_recognized(sum: &Sum, entry: &Known) -> Option<Sum> {
    let terms = entry.value.len();
    let attempt = |chosen: &dyn Fn(&Monomial) -> bool| {
        let (inside, outside): (Vec<_>, Vec<_>) = sum.0.iter().cloned().partition(|t| chosen(&t.0));
        if inside.len() < terms {
            return None;
        }
        let quotient = exact_quotient(&Sum(inside.clone()), &entry.value)?;
        let raised = quotient.0.into_iter().map(|(m, k)| (m.with_power(entry.atom, m.power(entry.atom) + 1), k));
        let next = Sum::collect(outside.into_iter().chain(raised));
        (next.len() < sum.len()).then_some(next)
    };
    if let Some(next) = attempt(&|_| true) {
        return Some(next);
    }
    let mut factors: Vec<AtomId> = sum.0.iter().flat_map(|t| t.0.0.iter().map(|f| f.0)).collect();
    factors.sort_unstable();
    factors.dedup();
    for atom in factors {
        if let Some(next) = attempt(&|m| m.power(atom) != 0) {
            return Some(next);
        }
    }
    // one multiple of it
    let (pivot, lead) = entry.value.0.first()?;
    for (m, k) in &sum.0 {
        let Some(q) = m.divided_by(pivot) else { continue };
        let scale = k.mul(lead.inverse());
        if entry.value.0.iter().all(|(b, c)| sum.coefficient(&q.times(b)) == c.mul(scale)) {
            let gone = entry.value.0.iter().map(|(b, c)| (q.times(b), c.mul(scale).neg()));
            let named = (q.with_power(entry.atom, q.power(entry.atom) + 1), scale);
            return Some(Sum::collect(sum.0.iter().cloned().chain(gone).chain([named])));
        }
    }
    None
}

/// sum / by, where it leaves no remainder.
pub fn exact_quotient(sum: &Sum, by: &Sum) -> Option<Sum> {
    let leading = |s: &Sum| s.0.iter().max_by(|a, b| lexicographic(&a.0, &b.0)).cloned();
    let (top, lead) = leading(by)?;
    // k (L - r)/L: negative powers of what is divided by are lifted first
    let mut lift = Monomial::one();
    for (atom, _) in by.0.iter().flat_map(|t| &t.0.0) {
        let lowest = sum.0.iter().map(|t| t.0.power(*atom)).min().unwrap_or(0);
        if lowest < 0 {
            lift = lift.with_power(*atom, -lowest);
        }
    }
    let mut rest = sum.shifted(&lift);
    let mut quotient = Vec::new();
    while let Some((m, k)) = leading(&rest) {
        if quotient.len() > sum.len() {
            return None;
        }
        let q = m.divided_by(&top)?;
        let scale = k.mul(lead.inverse());
        rest = Sum::collect(rest.0.iter().cloned().chain(by.0.iter().map(|(b, c)| (q.times(b), c.mul(scale).neg()))));
        // rounding must not keep the leading term alive
        if !rest.coefficient(&m).is_zero() {
            return None;
        }
        quotient.push((q, scale));
    }
    let back = lift.powi(-1);
    Some(Sum::collect(quotient.into_iter().map(|(q, k)| (q.times(&back), k))))
}

/// A monomial order: the power of the lowest atom that differs decides.
fn lexicographic(a: &Monomial, b: &Monomial) -> Ordering {
    let (mut i, mut j) = (0, 0);
    loop {
        match (a.0.get(i), b.0.get(j)) {
            (Some(x), Some(y)) if x.0 == y.0 => {
                if x.1 != y.1 {
                    return x.1.cmp(&y.1);
                }
                i += 1;
                j += 1;
            }
            (Some(x), Some(y)) if x.0 < y.0 => return x.1.cmp(&0),
            (Some(x), None) => return x.1.cmp(&0),
            (_, Some(y)) => return 0.cmp(&y.1),
            (None, None) => return Ordering::Equal,
        }
    }
}

/// Sums of coordinates, rates or signals that the graph has as factors: stretches, differences of rates.
pub fn as_factor(forms: &mut Forms, sum: &Sum) -> Option<Known> {
    if !(2..=4).contains(&sum.len()) {
        return None;
    }
    let mut moving = false;
    for (m, _) in &sum.0 {
        let (dynamic, _) = m.split(|a| !forms.depends(a).is_static());
        match dynamic.0.as_slice() {
            [] => {}
            [(atom, 1)] if is_variable(forms, *atom) => moving = true,
            _ => return None,
        }
    }
    if !moving {
        return None;
    }
    let (_, _, value) = content(sum);
    // the first that moves has a plus: (x - rest), not (rest - x)
    let first = value.0.iter().find(|(m, _)| m.0.iter().any(|f| !forms.depends(f.0).is_static()));
    let turned = first.is_some_and(|t| t.1.is_negative());
    let value = if turned { value.scaled(Number::integer(-1)) } else { value };
    let atom = forms.factor(value.clone());
    Some(Known { value, atom })
}

fn is_variable(forms: &Forms, atom: AtomId) -> bool {
    match forms.atom(atom) {
        Atom::Name(i) => {
            matches!(forms.name(*i).1, Class::Part | Class::Coordinate | Class::Rate | Class::Lag | Class::Signal | Class::Acceleration)
        }
        _ => false,
    }
}

/// k R a + k R b with equal k and signals a, b: k R (a + b), for inputs that no mix names.
pub fn signals_together(forms: &mut Forms, sum: &Sum) -> Sum {
    let is_signal = |forms: &Forms, a: AtomId| forms.depends(a) == Depends { signal: true, ..Depends::default() } && is_variable(forms, a);
    let mut groups: Vec<(AtomId, Sum)> = Vec::new();
    let mut out: Vec<(Monomial, Number)> = Vec::new();
    for (m, k) in &sum.0 {
        let (signal, rest) = m.split(|a| is_signal(forms, a));
        match signal.0.as_slice() {
            [(atom, 1)] => match groups.iter_mut().find(|g| g.0 == *atom) {
                Some(group) => group.1.0.push((rest, *k)),
                None => groups.push((*atom, Sum(vec![(rest, *k)]))),
            },
            _ => out.push((m.clone(), *k)),
        }
    }
    // by what multiplies the signal, term by term
    let mut rows: Vec<(Monomial, Vec<(AtomId, Number)>)> = Vec::new();
    for (atom, multiplier) in groups {
        for (rest, k) in multiplier.0 {
            match rows.iter_mut().find(|r| r.0 == rest) {
                Some(row) => row.1.push((atom, k)),
                None => rows.push((rest, vec![(atom, k)])),
            }
        }
    }
    for (rest, mut signals) in rows {
        while !signals.is_empty() {
            let (first, k) = signals[0];
            let (together, other): (Vec<_>, Vec<_>) = signals.into_iter().partition(|s| s.1.abs() == k.abs());
            signals = other;
            if together.len() < 2 {
                out.push((rest.with_power(first, 1), k));
                continue;
            }
            let sign = |j: Number| if j == k { Number::ONE } else { Number::integer(-1) };
            let inner = Sum::collect(together.iter().map(|&(a, j)| (Monomial(vec![(a, 1)]), sign(j))));
            let atom = forms.factor(inner);
            out.push((rest.with_power(atom, 1), k));
        }
    }
    Sum::collect(out)
}
