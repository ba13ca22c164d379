//! Tables: texts, numbers, bars and intervals in their rows.

use maud::{Markup, html};

/// A table.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// What it shows.
    pub caption: String,
    /// Headings of its columns.
    pub head: Vec<String>,
    /// Rows.
    pub rows: Vec<Vec<Cell>>,
}

/// A cell.
#[derive(Clone, Debug)]
pub enum Cell {
    /// A text, from the left.
    Text(String),
    /// A number, from the right.
    Number(String),
    /// A number with a bar of this share of the longest one (0 to 1).
    Bar {
        /// Length.
        share: f64,
        /// Number.
        text: String,
    },
    /// An estimate with its interval, drawn on a scale of its own.
    Interval {
        /// Estimate.
        value: f64,
        /// Ends of the interval.
        ends: Option<(f64, f64)>,
        /// A value beside it: where the search started, what is published.
        other: Option<f64>,
    },
}

pub(crate) fn table(data: &Table) -> Markup {
    let column = |k: usize| data.rows.first().and_then(|row| row.get(k));
    let right = |cell: Option<&Cell>| matches!(cell, Some(Cell::Number(_)));
    html! {
        @if !data.caption.is_empty() { p.caption { (data.caption) } }
        div.table {
            table {
                @if !data.head.is_empty() {
                    thead { tr { @for (k, name) in data.head.iter().enumerate() {
                        th scope="col" class=[right(column(k)).then_some("n")] { (name) }
                    } } }
                }
                tbody { @for row in &data.rows { tr { @for cell in row { (draw(cell)) } } } }
            }
        }
    }
}

fn draw(cell: &Cell) -> Markup {
    match cell {
        Cell::Text(text) => html! { td { (text) } },
        Cell::Number(text) => html! { td.n { (text) } },
        Cell::Bar { share, text } => {
            let percent = if share.is_finite() { 100.0 * share.clamp(0.0, 1.0) } else { 0.0 };
            html! { td.bar { span.rod style=(format!("width:{percent:.1}%")) {} span { (text) } } }
        }
        Cell::Interval { value, ends, other } => interval(*value, *ends, *other),
    }
}

/// Width of a drawn interval [px].
const WIDTH: f64 = 150.0;

fn interval(value: f64, ends: Option<(f64, f64)>, other: Option<f64>) -> Markup {
    let all = [Some(value), ends.map(|e| e.0), ends.map(|e| e.1), other];
    let (lo, hi) =
        all.into_iter().flatten().filter(|v| v.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
    let span = if hi > lo { hi - lo } else { 1.0 };
    let place = |v: f64| format!("{:.1}", 8.0 + (WIDTH - 16.0) * if hi > lo { (v - lo) / span } else { 0.5 });
    html! {
        td {
            svg.interval viewBox="0 0 150 16" width="150" height="16" role="img" aria-label="interval" {
                line.axis x1="0" y1="8" x2="150" y2="8" {}
                @if let Some((a, b)) = ends.filter(|e| e.0.is_finite() && e.1.is_finite()) {
                    line.reach x1=(place(a)) y1="8" x2=(place(b)) y2="8" {}
                    line.end x1=(place(a)) y1="3" x2=(place(a)) y2="13" {}
                    line.end x1=(place(b)) y1="3" x2=(place(b)) y2="13" {}
                }
                @if let Some(o) = other.filter(|o| o.is_finite()) { line.other x1=(place(o)) y1="2" x2=(place(o)) y2="14" {} }
                @if value.is_finite() { circle cx=(place(value)) cy="8" r="3" {} }
            }
        }
    }
}
