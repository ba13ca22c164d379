//! Long functions in parts: compilers take more than their share of time over very long ones.

use super::plan::{Plan, Value};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Statements of the longest function that stays whole.
const LONGEST: usize = 800;
/// Statements of a part. Measured on a six-joint chain in space: rustc takes 1.6 times as long with one part.
const PART: usize = 300;

/// A value taken over from an earlier part.
pub struct Import {
    /// The part.
    pub part: usize,
    /// Place among the values that it exports.
    pub index: usize,
    /// The value.
    pub value: Value,
}

/// A run of statements that is a function of its own.
pub struct Part {
    /// Its statements.
    pub own: Range<usize>,
    /// What it takes over, in order of definition.
    pub imports: Vec<Import>,
    /// What later parts need of it.
    pub exports: Vec<Value>,
    /// Number of values that each earlier part exports.
    pub lengths: Vec<usize>,
}

impl Part {
    /// Earlier parts that it takes values from.
    pub fn parts_used(&self) -> Vec<usize> {
        self.imports.iter().map(|i| i.part).collect::<BTreeSet<_>>().into_iter().collect()
    }
}

/// Parts, and what stays in the function itself (statements and results).
pub fn split(plan: &Plan) -> (Vec<Part>, Part) {
    let n = plan.statements.len();
    let count = if n <= LONGEST { 0 } else { n.div_ceil(PART) };
    let size = if count == 0 { 0 } else { n.div_ceil(count) };
    let ranges: Vec<Range<usize>> = (0..count).map(|k| k * size..((k + 1) * size).min(n)).collect();
    let part_of = |statement: usize| ranges.iter().position(|r| r.contains(&statement));
    // what crosses: values that a later part or the results use
    let mut crossing: Vec<BTreeSet<Value>> = vec![BTreeSet::new(); count];
    let mut needed: Vec<BTreeSet<Value>> = vec![BTreeSet::new(); count + 1];
    let mut take = |used: Value, by: usize| {
        if let Some(part) = part_of(used.statement)
            && part < by
        {
            crossing[part].insert(used);
            needed[by].insert(used);
        }
    };
    for (by, range) in ranges.iter().enumerate() {
        for statement in range.clone() {
            for &used in &plan.statements[statement].uses {
                take(used, by);
            }
        }
    }
    for &used in &plan.result_uses {
        take(used, count);
    }
    let places: Vec<BTreeMap<Value, usize>> = crossing.iter().map(|set| set.iter().enumerate().map(|(i, &v)| (v, i)).collect()).collect();
    let lengths: Vec<usize> = crossing.iter().map(BTreeSet::len).collect();
    let imports = |by: usize| {
        let found = needed[by].iter().filter_map(|&value| {
            let part = part_of(value.statement)?;
            Some(Import { part, index: places[part][&value], value })
        });
        found.collect::<Vec<_>>()
    };
    let parts = ranges
        .iter()
        .enumerate()
        .map(|(k, range)| Part {
            own: range.clone(),
            imports: imports(k),
            exports: crossing[k].iter().copied().collect(),
            lengths: lengths.clone(),
        })
        .collect();
    let own = if count == 0 { 0..n } else { n..n };
    (parts, Part { own, imports: imports(count), exports: Vec::new(), lengths })
}
