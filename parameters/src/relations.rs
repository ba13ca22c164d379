//! Relations that hold between lumps (or base parameters) whatever the unknown parameters are.
//!
//! The logarithms of the lumps, differentiated by the logarithms of the unknown parameters at several random points,
//! side by side: a product of powers of lumps that is constant is a left null vector of that matrix. Found vectors
//! are made whole numbers and tried at points that had no part in finding them.

use crate::base::Base;
use crate::draws::Draws;
use crate::rank::rank;
use codegen::{definitions, display};
use model_dsl::rig::{Parameter, Rig};
use nalgebra::DMatrix;
use std::collections::BTreeSet;

/// Step of the differences, in the logarithm.
const STEP: f64 = 1e-5;
/// Random points at which slopes are taken.
const POINTS: usize = 3;
/// Relative size below which a slope is rounding of differences.
const ROUNDING: f64 = 1e-7;

/// Which parameters count as known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Known {
    /// Constants of the rig, and lengths that it marks as fixed: what a ruler tells.
    Lengths,
    /// These by name, and no others.
    These(BTreeSet<String>),
}

impl Known {
    fn has(&self, p: &Parameter) -> bool {
        match self {
            Self::Lengths => p.constant || (p.fixed && p.unit.dimension == model_dsl::units::Dimension::LENGTH),
            Self::These(names) => names.contains(&p.name),
        }
    }
}

/// A product of powers that the definitions fix.
pub struct Relation {
    /// (lump, power).
    pub powers: Vec<(String, i32)>,
    /// What the definitions say that it is, over known parameters.
    pub means: String,
    /// Its value by the definitions.
    pub expected: f64,
    /// Its value by the lumps' own values.
    pub found: f64,
}

impl Relation {
    /// found / expected: 1 where the values agree with the definitions.
    #[must_use]
    pub fn factor(&self) -> f64 {
        self.found / self.expected
    }

    /// `a1 b2/(a3 b1)`
    #[must_use]
    pub fn product(&self) -> String {
        let side = |sign: i32| {
            let factor = |(n, k): &(String, i32)| {
                if k.abs() == 1 { n.clone() } else { format!("{n}^{}", k.abs()) }
            };
            self.powers.iter().filter(|p| p.1 * sign > 0).map(factor).collect::<Vec<_>>()
        };
        let (top, bottom) = (side(1), side(-1));
        let top = if top.is_empty() { "1".to_owned() } else { top.join(" ") };
        match bottom.len() {
            0 => top,
            1 => format!("{top}/{}", bottom[0]),
            _ => format!("{top}/({})", bottom.join(" ")),
        }
    }
}

/// What is related.
pub struct Relations {
    /// Quantities in question.
    pub quantities: Vec<String>,
    /// How many of them can be chosen freely.
    pub freedom: usize,
    /// Parameters that were taken as known.
    pub known: Vec<String>,
    /// Products that the definitions fix.
    pub products: Vec<Relation>,
}

/// Relations between the lumps that have values of their own, and the parameters that stand beside them in the
/// equations (`others`: each free by itself); `None` where no lump has a value.
#[must_use]
pub fn of_lumps(rig: &Rig, known: &Known, others: &[String], seed: u64) -> Option<Relations> {
    let lumps: Vec<usize> = (0..rig.definitions.len()).filter(|&i| rig.definitions[i].parameter.is_some()).collect();
    if lumps.is_empty() {
        return None;
    }
    let mut d = definitions(rig);
    let roots: Vec<_> = lumps.iter().map(|&i| d.values[i]).collect();
    let tape = d.graph.tape(&roots);
    let symbols = d.parameters.clone();
    let value = |p: &[f64]| tape.run(|s| symbols.iter().position(|&x| x == s).map_or(0.0, |i| p[i]));
    let (vectors, freedom) = invariants(rig, known, &value, seed);
    let own: Vec<f64> = lumps.iter().map(|&i| rig.definitions[i].parameter.map_or(f64::NAN, |k| rig.parameters[k].value)).collect();
    let nominal: Vec<f64> = rig.parameters.iter().map(|p| p.value).collect();
    let defined = value(&nominal);
    let product = |of: &[f64], powers: &[i32]| of.iter().zip(powers).map(|(x, &k)| x.powi(k)).product::<f64>();
    let names: Vec<String> = lumps.iter().map(|&i| rig.definitions[i].name.clone()).collect();
    let products = vectors
        .into_iter()
        .map(|powers| {
            let (expected, found) = (product(&defined, &powers), product(&own, &powers));
            let factors: Vec<_> = roots.iter().zip(&powers).filter(|(_, k)| **k != 0).map(|(&id, &k)| d.graph.powi(id, k)).collect();
            let one = d.graph.one();
            let id = factors.into_iter().fold(one, |total, f| d.graph.mul(total, f));
            let means = display::value(rig, &d.graph, id).unwrap_or_default();
            let powers = names.iter().cloned().zip(powers).filter(|p| p.1 != 0).collect();
            Relation { powers, means, expected, found }
        })
        .collect();
    let beside: Vec<String> = others.iter().filter(|n| !names.contains(n)).cloned().collect();
    let freedom = freedom + beside.len();
    let known = known_names(rig, known, |i| lumps.iter().all(|&l| rig.definitions[l].parameter != Some(i)));
    Some(Relations { quantities: names.into_iter().chain(beside).collect(), freedom, known, products })
}

/// Relations between base parameters as functions of the rig's parameters.
#[must_use]
pub fn of_base(rig: &Rig, base: &Base, known: &Known, seed: u64) -> Relations {
    let value = |p: &[f64]| {
        let products = base.form.values(&|name| rig.parameters.iter().position(|x| x.name == name).map_or(0.0, |i| p[i]));
        base.parameters.iter().map(|b| b.terms.iter().map(|&(j, k)| k * products[j]).sum()).collect::<Vec<f64>>()
    };
    let (vectors, freedom) = invariants(rig, known, &value, seed);
    let nominal: Vec<f64> = rig.parameters.iter().map(|p| p.value).collect();
    let now = value(&nominal);
    // a base parameter that is known by itself is no relation and no freedom
    let single = |powers: &Vec<i32>| powers.iter().filter(|k| **k != 0).count() == 1;
    let fixed = |i: usize| vectors.iter().any(|v| single(v) && v[i] != 0);
    let quantities = base.parameters.iter().enumerate().filter(|(i, _)| !fixed(*i)).map(|(_, b)| b.text.clone()).collect();
    let products = vectors
        .iter()
        .filter(|v| !single(v))
        .map(|powers| {
            let expected: f64 = now.iter().zip(powers).map(|(x, &k)| x.powi(k)).product();
            let named = base.parameters.iter().zip(powers).filter(|p| *p.1 != 0);
            let powers = named.map(|(b, &k)| (if b.text.contains(' ') { format!("({})", b.text) } else { b.text.clone() }, k)).collect();
            Relation { powers, means: String::new(), expected, found: expected }
        })
        .collect();
    Relations { quantities, freedom, known: known_names(rig, known, |_| true), products }
}

fn known_names(rig: &Rig, known: &Known, asks: impl Fn(usize) -> bool) -> Vec<String> {
    let listed = rig.parameters.iter().enumerate().filter(|(i, p)| known.has(p) && asks(*i));
    listed.map(|(_, p)| p.name.clone()).collect()
}

/// Whole-number vectors k such that the product of `value`^k does not depend on the unknown parameters, and the rank of
/// the values as functions of them.
fn invariants(rig: &Rig, known: &Known, value: &dyn Fn(&[f64]) -> Vec<f64>, seed: u64) -> (Vec<Vec<i32>>, usize) {
    let unknown: Vec<usize> = (0..rig.parameters.len()).filter(|&i| !known.has(&rig.parameters[i])).collect();
    let mut draws = Draws::new(seed);
    let mut point = || -> Vec<f64> {
        let mut p: Vec<f64> = rig.parameters.iter().map(|p| p.value).collect();
        for &i in &unknown {
            let spread = (0.4 * draws.unit()).exp();
            p[i] = if p[i] == 0.0 { spread } else { p[i] * spread };
        }
        p
    };
    let count = value(&point()).len();
    let mut slopes = DMatrix::zeros(count, POINTS * unknown.len());
    for block in 0..POINTS {
        let p = point();
        for (c, &i) in unknown.iter().enumerate() {
            let at = |step: f64| {
                let mut moved = p.clone();
                moved[i] *= step.exp();
                value(&moved)
            };
            let (above, below) = (at(STEP), at(-STEP));
            for (r, (a, b)) in above.iter().zip(&below).enumerate() {
                let slope = (a.abs().ln() - b.abs().ln()) / (2.0 * STEP);
                slopes[(r, block * unknown.len() + c)] = if slope.is_finite() { slope } else { f64::from(u8::from(a != b)) };
            }
        }
    }
    let freedom = rank(&slopes.columns(0, unknown.len()).into_owned(), ROUNDING);
    let tries: Vec<Vec<f64>> = (0..3).map(|_| value(&point())).collect();
    let constant = |powers: &Vec<i32>| {
        let of = |values: &[f64]| values.iter().zip(powers).map(|(x, &k)| f64::from(k) * x.abs().ln()).sum::<f64>();
        tries.iter().all(|t| (of(t) - of(&tries[0])).abs() < 1e-9)
    };
    let found = left_null(&slopes).into_iter().filter_map(|v| whole(&v)).filter(constant).collect();
    (found, freedom)
}

/// A basis of the left null space in echelon form, as sparse as that form is: last rows are told over first ones.
fn left_null(m: &DMatrix<f64>) -> Vec<Vec<f64>> {
    let n = m.nrows();
    // rows are reduced from the first to the last, with a record of what was done to each
    let mut kept: Vec<(Vec<f64>, Vec<f64>, usize)> = Vec::new();
    let mut null = Vec::new();
    for i in 0..n {
        let mut row: Vec<f64> = m.row(i).iter().copied().collect();
        let mut record = vec![0.0; n];
        record[i] = 1.0;
        for (other, made, pivot) in &kept {
            let factor = row[*pivot] / other[*pivot];
            row.iter_mut().zip(other).for_each(|(x, y)| *x -= factor * y);
            record.iter_mut().zip(made).for_each(|(x, y)| *x -= factor * y);
        }
        let largest = row.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).map(|(k, x)| (k, x.abs()));
        match largest {
            Some((pivot, size)) if size > ROUNDING * 100.0 => kept.push((row, record, pivot)),
            _ => null.push(record),
        }
    }
    null
}

/// A vector as small whole numbers; `None` where it is none.
fn whole(v: &[f64]) -> Option<Vec<i32>> {
    let least = v.iter().map(|x| x.abs()).filter(|x| *x > 1e-4).fold(f64::INFINITY, f64::min);
    (1..=12).find_map(|q| {
        let scaled: Vec<f64> = v.iter().map(|x| x / least * f64::from(q)).collect();
        let near = scaled.iter().all(|x| (x - x.round()).abs() < 1e-3 && x.abs() < 100.0);
        near.then(|| scaled.iter().map(|x| x.round() as i32).collect())
    })
}
