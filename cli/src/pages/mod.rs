//! Reports: what the commands found, as pages. One file a command; this one has what they share.

pub mod closed_loop;
pub mod diagnose;
pub mod identify;
pub mod linear;
mod response;
pub mod runs;
mod sources;

use crate::commands::linearize::source_name;
use crate::failure::Failure;
use crate::output::number;
use report::{Block, Cell, Page, Table};
use std::path::Path;

pub use sources::provenance;

/// Writes a page; what stands there and is not ours stays.
pub fn write(path: &Path, page: &Page, force: bool) -> Result<(), Failure> {
    crate::write::write(path, &page.html(), force)
}

/// The mark of a page, as [`crate::write`] wants it.
pub fn mark(source: &Path, command: &str) -> String {
    format!("{}{}` by rig {command}.", crate::write::MARK, source_name(source))
}

/// By how much values are multiplied to be shown, and the unit in which they are: angles in degrees.
pub fn shown(unit: &str) -> (f64, String) {
    let degrees = 180.0 / std::f64::consts::PI;
    match unit {
        "rad" => (degrees, "deg".to_owned()),
        _ => match unit.strip_prefix("rad/") {
            Some(rest) => (degrees, format!("deg/{rest}")),
            None => (1.0, unit.to_owned()),
        },
    }
}

/// A unit after a name; nothing for a plain number.
pub fn bracketed(unit: &str) -> String {
    if unit.is_empty() || unit == "1" { String::new() } else { format!(" [{unit}]") }
}

/// Values in the unit in which they are shown.
pub fn times(values: &[f64], factor: f64) -> Vec<f64> {
    values.iter().map(|v| v * factor).collect()
}

/// Three digits: what errors and estimates of sizes are worth.
pub fn brief(value: f64) -> String {
    let rounded = format!("{value:.2e}");
    let text = rounded.parse().map_or_else(|_| rounded.clone(), number);
    if text.contains('e') { rounded } else { text }
}

/// A number with its unit, where it has one.
pub fn with_unit(number: String, unit: &str) -> String {
    if unit == "1" { number } else { format!("{number} {unit}") }
}

/// A number of a table.
pub fn cell(value: f64) -> Cell {
    Cell::Number(number(value))
}

/// A percentage of a table; `None`: the signal is constant.
pub fn percent(value: Option<f64>) -> Cell {
    Cell::Number(value.map_or_else(|| "constant".to_owned(), |v| format!("{v:.1} %")))
}

/// A matrix with named rows and columns.
pub fn matrix(caption: &str, columns: &[String], rows: &[(String, Vec<f64>)]) -> Block {
    Block::Table(Table {
        caption: caption.to_owned(),
        head: std::iter::once(String::new()).chain(columns.iter().cloned()).collect(),
        rows: rows
            .iter()
            .map(|(name, values)| std::iter::once(Cell::Text(name.clone())).chain(values.iter().map(|v| cell(*v))).collect())
            .collect(),
    })
}

/// A name of a record that fits a table: its file without folder and ending. (The whole list stands at the end of a page.)
pub fn short(source: &str) -> String {
    Path::new(source).file_stem().map_or_else(|| source.to_owned(), |s| s.to_string_lossy().into_owned())
}
