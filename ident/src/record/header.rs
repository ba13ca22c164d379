//! A record as CSV: the first line names the columns, `t` and the rig's names, units in brackets.

use super::error::{Cause, RecordError};
use super::table::Table;
use super::{Column, Record, Start, finish, text};
use model_dsl::units::{Dimension, Unit};
use std::path::Path;

/// Reads a CSV record.
pub(crate) fn read(path: &Path) -> Result<Record, RecordError> {
    let (mut columns, table) = columns(path, "t, theta [deg], u")?;
    let error = |cause| RecordError::new(path, cause);
    let Some(at) = columns.iter().position(|c| c.name == "t") else {
        return Err(error(Cause::NoTime { found: columns.into_iter().map(|c| c.name).collect() }));
    };
    let time = columns.remove(at);
    check_time_unit(time.unit.as_ref()).map_err(&error)?;
    finish(path, time.values, columns, Vec::new(), Start::default(), &|k| table.place(k))
}

/// Named columns of a CSV file in SI; `example` is a header as it should be.
pub(crate) fn columns(path: &Path, example: &'static str) -> Result<(Vec<Column>, Table), RecordError> {
    let error = |cause| RecordError::new(path, cause);
    let bytes = std::fs::read(path).map_err(|e| error(Cause::CannotRead { why: e.to_string() }))?;
    let table = text::parse(path, &bytes, text::Layout { delimiter: Some(b','), header: 1 })?;
    if let Some(number) = table.names.first().filter(|n| n.parse::<f64>().is_ok()) {
        return Err(error(Cause::NoHeader { text: number.clone(), example }));
    }
    if table.names.len() != table.columns.len() {
        return Err(error(Cause::Cells { row: table.place(0), wanted: table.names.len(), found: table.columns.len() }));
    }
    let mut columns: Vec<Column> = Vec::new();
    for (j, (header, mut values)) in table.names.iter().zip(table.columns.iter().cloned()).enumerate() {
        let (name, unit) = split_unit(header).map_err(&error)?;
        if name.is_empty() {
            return Err(error(Cause::NoName { column: j + 1 }));
        }
        if columns.iter().any(|c| c.name == name) {
            return Err(error(Cause::TwiceNamed { column: name }));
        }
        if let Some(k) = values.iter().position(|v| !v.is_finite()) {
            return Err(error(Cause::NotFinite { row: table.place(k), column: name, value: values[k] }));
        }
        if let Some(unit) = &unit {
            values.iter_mut().for_each(|v| *v *= unit.factor);
        }
        columns.push(Column { name, unit, values });
    }
    Ok((columns, table))
}

/// A unit of time, or none.
pub(crate) fn check_time_unit(unit: Option<&Unit>) -> Result<(), Cause> {
    match unit {
        Some(unit) if unit.dimension != Dimension::TIME => Err(Cause::TimeUnit { unit: unit.text.clone() }),
        _ => Ok(()),
    }
}

/// `theta [deg]` to its name and unit.
pub(crate) fn split_unit(header: &str) -> Result<(String, Option<Unit>), Cause> {
    let Some((name, rest)) = header.split_once('[') else {
        return Ok((header.trim().to_owned(), None));
    };
    let Some(unit) = rest.trim_end().strip_suffix(']') else {
        return Err(Cause::Bracket { text: header.to_owned() });
    };
    let name = name.trim().to_owned();
    match model_dsl::parse_unit(unit.trim()) {
        Ok(unit) => Ok((name, Some(unit))),
        Err(why) => Err(Cause::Unit { column: name, why }),
    }
}
