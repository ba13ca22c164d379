//! Where answers and failures go: standard output for answers, standard error for everything else.

use crate::failure::Failure;
use serde_json::{Value, json};
use std::io::Write;

/// What a command found.
pub struct Answer {
    /// For people.
    pub text: String,
    /// For programs.
    pub json: Value,
}

/// Prints an answer.
pub fn answer(answer: &Answer, json: bool) {
    let text = if json { format!("{:#}\n", answer.json) } else { answer.text.clone() };
    // a closed pipe (`rig show | head`) is the reader's choice, no failure of ours
    let _ = std::io::stdout().lock().write_all(text.as_bytes());
}

/// Prints a failure.
pub fn failure(failure: &Failure, json: bool) {
    if json {
        let mut document = json!({"diagnostics": failure.diagnostics});
        failure.fields.iter().for_each(|(name, value)| document[*name] = value.clone());
        let _ = writeln!(std::io::stdout().lock(), "{document:#}");
    } else {
        let _ = writeln!(std::io::stderr().lock(), "{}", failure.text.trim_end());
    }
}

/// A number for people: six significant digits, no trailing zeros.
pub fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let size = x.abs().log10().floor();
    if !(-4.0..6.0).contains(&size) {
        return format!("{x:.5e}");
    }
    let digits = (5.0 - size).max(0.0) as usize;
    let text = format!("{x:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// An object of names and values.
pub fn named<'a>(names: impl Iterator<Item = &'a str>, values: &[f64]) -> Value {
    Value::Object(names.zip(values).map(|(n, v)| (n.to_owned(), json!(v))).collect())
}

/// A name as people write it: `eps.dot` is `eps'`.
pub fn prime(name: &str) -> String {
    match name.strip_suffix(".ddot") {
        Some(base) => format!("{base}''"),
        None => name.strip_suffix(".dot").map_or_else(|| name.to_owned(), |base| format!("{base}'")),
    }
}

/// Poles, conjugate pairs together.
pub fn poles_in_words(poles: &[nalgebra::Complex<f64>]) -> String {
    let mut words: Vec<String> = Vec::new();
    for z in poles {
        // eigenvalues at rounding distance from the origin are the origin
        let scale = poles.iter().fold(1e-3_f64, |m, p| m.max(p.norm()));
        let (re, im) = (if z.re.abs() < 1e-13 * scale { 0.0 } else { z.re }, z.im);
        if im.abs() < 1e-12 * scale {
            words.push(number(re));
        } else if im > 0.0 {
            words.push(format!("{} +- {}i", number(re), number(im)));
        }
    }
    words.join(", ")
}

/// A matrix with named rows and columns, a bar before column `bar`.
pub fn table(columns: &[String], rows: &[(String, Vec<f64>)], bar: usize) -> String {
    let mut cells: Vec<Vec<String>> = vec![std::iter::once(String::new()).chain(columns.iter().cloned()).collect()];
    // an entry that is rounding of the others is none
    let largest = rows.iter().flat_map(|r| &r.1).fold(0.0_f64, |m, x| m.max(x.abs()));
    let settled = |x: f64| if x.abs() < 1e-15 * largest { 0.0 } else { x };
    for (name, values) in rows {
        cells.push(std::iter::once(name.clone()).chain(values.iter().map(|x| entry(settled(*x)))).collect());
    }
    let widths: Vec<usize> =
        (0..=columns.len()).map(|c| cells.iter().filter_map(|r| r.get(c)).map(|cell| cell.chars().count()).max().unwrap_or(0)).collect();
    let mut text = String::new();
    for row in &cells {
        for (c, cell) in row.iter().enumerate() {
            if c == bar.saturating_add(1) {
                text.push_str("  |");
            }
            let pad = " ".repeat(widths[c] - cell.chars().count());
            text.push_str("  ");
            text.push_str(&if c == 0 { format!("{cell}{pad}") } else { format!("{pad}{cell}") });
        }
        text.push('\n');
    }
    text
}

/// An entry of a matrix: four decimals, or a power of ten where they would not show it.
fn entry(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if (1e-3..1e5).contains(&x.abs()) { format!("{x:.4}") } else { format!("{x:.3e}") }
}
