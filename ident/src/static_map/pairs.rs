//! Pairs from a CSV file: a header with two names, units in brackets, then numbers.

use crate::record::{Cause, RecordError, named_columns};
use std::path::Path;

/// One side of the pairs.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name.
    pub name: String,
    /// Unit of the values (SI), where the file states one.
    pub unit: Option<String>,
    /// Values in SI.
    pub values: Vec<f64>,
}

/// Pairs: abscissa, ordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Pairs {
    /// First column.
    pub x: Axis,
    /// Second column.
    pub y: Axis,
}

/// Reads pairs.
///
/// # Errors
/// [`RecordError`]: which file, which place in it, what is wrong and how to mend it.
pub fn read_pairs(path: &Path) -> Result<Pairs, RecordError> {
    let mut columns = named_columns(path)?;
    if columns.len() != 2 {
        let found = columns.into_iter().map(|c| c.name).collect();
        return Err(RecordError { file: path.display().to_string(), cause: Cause::NoPairs { found } });
    }
    let mut side = |at: usize| {
        let c = columns.remove(at);
        let unit = c.unit.map(|u| if u.factor == 1.0 { u.text } else { model_dsl::units::Unit::si(u.dimension).text });
        Axis { name: c.name, unit, values: c.values }
    };
    let x = side(0);
    Ok(Pairs { x, y: side(0) })
}
