//! Delimited text to a table: header lines, delimiter, numbers. Knows nothing of units and signals.

use super::error::{Cause, RecordError, Row};
use super::table::Table;
use std::path::Path;

/// How a text file is laid out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    /// What stands between cells; `None`: any run of blanks and tabs.
    pub delimiter: Option<u8>,
    /// Lines before the numbers; the first of them names the columns.
    pub header: usize,
}

/// Reads a text file.
pub(crate) fn read(path: &Path, layout: Layout) -> Result<Table, RecordError> {
    let bytes = std::fs::read(path).map_err(|e| RecordError::new(path, Cause::CannotRead { why: e.to_string() }))?;
    parse(path, &bytes, layout)
}

/// Parses the bytes of a text file; `path` is for messages.
pub(crate) fn parse(path: &Path, bytes: &[u8], layout: Layout) -> Result<Table, RecordError> {
    let error = |cause| RecordError::new(path, cause);
    let text = std::str::from_utf8(bytes).map_err(|e| {
        let line = bytes[..e.valid_up_to()].iter().filter(|&&b| b == b'\n').count() + 1;
        error(Cause::NotText { line })
    })?;
    // a byte-order mark is no name; lines are counted by their `\n`
    let mut text = text.strip_prefix('\u{feff}').unwrap_or(text).replace("\r\n", "\n");
    if !text.ends_with('\n') {
        text.push('\n');
    }
    let text = text.as_str();
    let header = text.lines().next().unwrap_or_default();
    let mut names = Vec::new();
    if layout.header > 0 {
        split(header.as_bytes(), layout.delimiter, &mut |_, cells| {
            names = cells.iter().map(|c| (*c).to_owned()).collect();
            Ok(())
        })?;
    }
    // what the header is separated by tells what the rest is
    for (found, word, other) in [("semicolons", "semicolon", b';'), ("tabs", "tab", b'\t')] {
        let cells = header.as_bytes().iter().filter(|b| **b == other).count();
        if layout.delimiter == Some(b',') && cells > 0 && cells >= names.len() {
            return Err(error(Cause::Delimiter { found, word }));
        }
    }
    let mut table = Table { names, columns: Vec::new(), first_line: Some(layout.header + 1) };
    let mut next = 1;
    split(skip_lines(text, layout.header).as_bytes(), layout.delimiter, &mut |line, cells| {
        let row = Row::Line(layout.header + line);
        if line != next {
            // a blank line between samples: is a sample missing?
            return Err(error(Cause::EmptyCell { row: Row::Line(layout.header + next), column: table.name(0) }));
        }
        next += 1;
        if table.columns.is_empty() {
            table.columns = vec![Vec::new(); cells.len()];
        }
        if cells.len() != table.columns.len() {
            return Err(error(Cause::Cells { row, wanted: table.columns.len(), found: cells.len() }));
        }
        for (j, cell) in cells.iter().enumerate() {
            if cell.is_empty() {
                return Err(error(Cause::EmptyCell { row, column: table.name(j) }));
            }
            let value: f64 = cell.parse().map_err(|_| {
                let text: String = cell.chars().take(40).collect();
                let comma = cell.replacen(',', ".", 1).parse::<f64>().is_ok();
                error(if comma { Cause::DecimalCommas { row, text } } else { Cause::NotANumber { row, column: table.name(j), text } })
            })?;
            table.columns[j].push(value);
        }
        Ok(())
    })?;
    if table.columns.is_empty() {
        return Err(error(Cause::NoRows));
    }
    // header cells that name no column (a delimiter at the end of the line) are dropped
    let width = table.columns.len();
    if table.names.len() > width && table.names[width..].iter().all(String::is_empty) {
        table.names.truncate(width);
    }
    Ok(table)
}

fn skip_lines(text: &str, lines: usize) -> &str {
    let mut rest = text;
    for _ in 0..lines {
        rest = rest.find('\n').map_or("", |at| &rest[at + 1..]);
    }
    rest
}

type OnRow<'a> = dyn FnMut(usize, &[&str]) -> Result<(), RecordError> + 'a;

/// Calls `on_row` with the line (from 1) and the cells of each line that is not blank.
fn split(text: &[u8], delimiter: Option<u8>, on_row: &mut OnRow) -> Result<(), RecordError> {
    let Some(delimiter) = delimiter else {
        for (k, line) in text.split(|&b| b == b'\n').enumerate() {
            // the text was checked to be UTF-8
            let line = std::str::from_utf8(line).unwrap_or_default();
            let cells: Vec<&str> = line.split_whitespace().collect();
            if !cells.is_empty() {
                on_row(k + 1, &cells)?;
            }
        }
        return Ok(());
    };
    let mut reader =
        csv::ReaderBuilder::new().has_headers(false).flexible(true).delimiter(delimiter).trim(csv::Trim::All).from_reader(text);
    let mut record = csv::StringRecord::new();
    while let Ok(true) = reader.read_record(&mut record) {
        // the reader now stands behind the line's end; where a record began it does not say, since it skips blank lines
        let line = usize::try_from(reader.position().line()).unwrap_or(usize::MAX) - 1;
        let cells: Vec<&str> = record.iter().collect();
        if cells.iter().any(|c| !c.is_empty()) {
            on_row(line, &cells)?;
        }
    }
    Ok(())
}
