//! What a snapshot of a rig holds, as text in sections, and how two snapshots differ.
//!
//! Numbers are written with six digits and compared with a tolerance, so that another machine's rounding is no change.

use crate::args::Point;
use crate::commands::linearize::{Linearized, at_point, inputs_of};
use crate::failure::Failure;
use crate::load::Loaded;
use crate::output::{number, poles_in_words, prime, table};
use jit::InProcess;
use similar::{DiffOp, capture_diff_slices};
use std::fmt::Write;

/// Relative difference of two numbers below which they are the same.
const SAME: f64 = 1e-4;
/// Size below which a number is the rounding of zero.
const NOTHING: f64 = 1e-9;

/// Title and lines.
pub type Section = (String, Vec<String>);

/// The sections of a rig: equations, operations, parameters, one for each named trim.
pub fn sections(loaded: &Loaded, model: &InProcess) -> Result<Vec<Section>, Failure> {
    let rig = &loaded.rig;
    let e = model.equations();
    let lines = |text: &str| text.lines().map(|l| l.trim_end().to_owned()).collect::<Vec<_>>();
    let mut all = vec![
        ("equations".to_owned(), trimmed(lines(&codegen::display::text(rig, e)))),
        (
            "operations".to_owned(),
            vec![format!("forward dynamics {}", e.forward_operations()), format!("with A and B {}", e.jacobian_operations())],
        ),
        (
            "parameters".to_owned(),
            e.layout
                .p
                .iter()
                .zip(&e.layout.nominal)
                .map(|(p, x)| format!("{} = {} {}", p.name, number(*x), p.unit).trim_end().to_owned())
                .collect(),
        ),
    ];
    let inputs = inputs_of(loaded, model, &[])?;
    for trim in &rig.trims {
        let point = Point { trim: Some(trim.name.clone()), at: Vec::new() };
        let lines = match at_point(loaded, model, &point, &inputs.directions, false) {
            Ok(linear) => trim_lines(model, &linear, &inputs.names),
            Err(failure) => failure.text.lines().map(str::to_owned).collect(),
        };
        all.push((format!("trim {}", trim.name), lines));
    }
    Ok(all)
}

/// Without the lines on operations and checks, which have a section or go without saying.
fn trimmed(mut lines: Vec<String>) -> Vec<String> {
    lines.retain(|l| !l.contains(" operations forward,"));
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    lines
}

fn trim_lines(model: &InProcess, linear: &Linearized, inputs: &[String]) -> Vec<String> {
    let layout = &model.equations().layout;
    let n = layout.q.len();
    let trim = &linear.found.trim;
    let clean = |x: f64| if x.abs() < NOTHING { 0.0 } else { x };
    let mut lines = Vec::new();
    let at = layout.x().zip(&trim.x).chain(layout.u.iter().zip(&trim.u));
    let at: Vec<String> = at.filter(|(_, x)| clean(**x) != 0.0).map(|(v, x)| format!("{} = {}", prime(&v.name), number(*x))).collect();
    lines.push(if at.is_empty() { "at zero".to_owned() } else { format!("at {}", at.join(", ")) });
    for (q, drift) in layout.q.iter().zip(&trim.drift).filter(|(_, d)| clean(**d) != 0.0) {
        lines.push(format!("drift {}'' = {}", q.name, number(*drift)));
    }
    let states: Vec<String> = layout.x().map(|v| prime(&v.name)).collect();
    let columns: Vec<String> = states.iter().chain(inputs).cloned().collect();
    let rows: Vec<(String, Vec<f64>)> = (n..states.len())
        .map(|i| {
            let name = if i < 2 * n { format!("{}''", states[i - n]) } else { format!("{}'", states[i]) };
            (name, linear.model.a.row(i).iter().chain(linear.model.b.row(i).iter()).map(|x| clean(*x)).collect())
        })
        .collect();
    lines.extend(table(&columns, &rows, states.len()).lines().map(|l| l.trim_end().to_owned()));
    let poles: Vec<_> = linear.model.poles.iter().map(|z| nalgebra::Complex::new(settled(z.re), settled(z.im))).collect();
    lines.push(format!("poles {}", poles_in_words(&poles)));
    lines
}

/// A double eigenvalue is known to half the digits only: what is that near to zero is zero.
fn settled(x: f64) -> f64 {
    if x.abs() < 1e-6 { 0.0 } else { x }
}

/// The file of a snapshot.
pub fn write(source: &str, sections: &[Section]) -> String {
    let mut out = format!("# Generated from `{source}` by `rig snapshot`; compare with `rig snapshot {source} --check`.\n");
    for (title, lines) in sections {
        let _ = write!(out, "\n[{title}]\n");
        lines.iter().for_each(|l| out.push_str(&format!("{l}\n")));
    }
    out
}

/// Reads a file of [`write`].
pub fn read(text: &str) -> Vec<Section> {
    let mut all: Vec<Section> = Vec::new();
    for line in text.lines() {
        match line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
            Some(title) => all.push((title.to_owned(), Vec::new())),
            None => {
                if let Some((_, lines)) = all.last_mut() {
                    lines.push(line.trim_end().to_owned());
                }
            }
        }
    }
    for (_, lines) in &mut all {
        while lines.last().is_some_and(String::is_empty) {
            lines.pop();
        }
    }
    all
}

/// A difference of two snapshots.
pub struct Change {
    /// Section.
    pub section: String,
    /// Lines that were, in the old one.
    pub was: Vec<String>,
    /// Lines that are.
    pub is: Vec<String>,
}

/// What changed, section by section.
pub fn changes(old: &[Section], new: &[Section]) -> Vec<Change> {
    let mut all = Vec::new();
    for (title, lines) in new {
        let before = old.iter().find(|s| s.0 == *title).map(|s| s.1.as_slice()).unwrap_or_default();
        for op in capture_diff_slices(similar::Algorithm::Patience, before, lines) {
            if let DiffOp::Equal { .. } = op {
                continue;
            }
            let (was, is) = (before[op.old_range()].to_vec(), lines[op.new_range()].to_vec());
            if was.len() == is.len() {
                // one change a line reads better than blocks, and rounding drops out
                let header = |all: &[String]| all.iter().find(|l| l.contains("  |  ")).cloned();
                let headers = header(before).zip(header(lines)).filter(|(a, b)| a.split_whitespace().eq(b.split_whitespace()));
                for (a, b) in was.into_iter().zip(is).filter(|(a, b)| !same(a, b)) {
                    let entries = headers.as_ref().and_then(|(h, _)| entries(h, &a, &b));
                    let changed = entries.unwrap_or_else(|| vec![(a, b)]);
                    all.extend(changed.into_iter().map(|(a, b)| Change { section: title.clone(), was: vec![a], is: vec![b] }));
                }
            } else {
                all.push(Change { section: title.clone(), was, is });
            }
        }
    }
    let gone = old.iter().filter(|s| new.iter().all(|n| n.0 != s.0));
    all.extend(gone.map(|s| Change { section: s.0.clone(), was: s.1.clone(), is: Vec::new() }));
    all
}

/// The entries in which two rows of one table differ, each with its row and column; `None` for lines that are no rows.
fn entries(header: &str, a: &str, b: &str) -> Option<Vec<(String, String)>> {
    let words = |l: &str| l.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let (columns, a, b) = (words(header), words(a), words(b));
    if a.len() != columns.len() + 1 || b.len() != a.len() || a[0] != b[0] || !a.contains(&"|".to_owned()) {
        return None;
    }
    let cell = |row: &[String], k: usize| format!("{} by {}: {}", row[0], columns[k], row[k + 1]);
    Some((0..columns.len()).filter(|&k| !same(&a[k + 1], &b[k + 1])).map(|k| (cell(&a, k), cell(&b, k))).collect())
}

/// Equal words, numbers within rounding.
fn same(a: &str, b: &str) -> bool {
    let (a, b): (Vec<&str>, Vec<&str>) = (a.split_whitespace().collect(), b.split_whitespace().collect());
    let number = |s: &str| s.trim_end_matches([',', 'i']).parse::<f64>().ok();
    a.len() == b.len()
        && a.iter().zip(&b).all(|(x, y)| {
            x == y || matches!((number(x), number(y)), (Some(x), Some(y)) if (x - y).abs() <= SAME * x.abs().max(y.abs()).max(1e-3))
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn section(title: &str, lines: &[&str]) -> Section {
        (title.to_owned(), lines.iter().map(|l| (*l).to_owned()).collect())
    }

    #[test]
    fn a_snapshot_reads_back_as_it_was_written() {
        let all = vec![section("equations", &["I psi'' = -c psi'", "", "  with m' = 1"]), section("trim level", &["at zero"])];
        assert_eq!(read(&write("a.rig", &all)), all);
    }

    #[test]
    fn rounding_is_no_change_and_a_term_is_one() {
        let old = [section("trim level", &["eps''  -0.2624  1.00001", "poles -0.05 +- 0.509802i, 0"]), section("gone", &["x"])];
        let new = [section("trim level", &["eps''  -0.2624  1.00000", "poles -0.05 +- 0.609802i, 0"])];
        let found = changes(&old, &new);
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].was[0].as_str(), found[0].is[0].as_str()), ("poles -0.05 +- 0.509802i, 0", "poles -0.05 +- 0.609802i, 0"));
        assert_eq!((found[1].section.as_str(), found[1].is.len()), ("gone", 0));
    }
}
