//! A measured record: time stamps and named columns in SI, and the one way in which files become one.
//!
//! [`read`] takes a CSV file or a description file (`.toml`, see `docs/records.md`); MATLAB files need a description, since
//! they do not say what their columns are. Nothing is resampled: time stamps need not be at a constant rate.

mod blocks;
mod description;
mod error;
mod expression;
mod header;
mod mat;
mod matching;
mod table;
mod text;

pub use blocks::Blocks;
pub use error::{Cause, RecordError};
pub use mat::{MatError, MatValue, Variable, read_mat};
pub use matching::{Bound, MatchError, bind, bind_signals};

use model_dsl::units::Unit;
use std::path::Path;

/// A measured record.
#[derive(Clone, Debug)]
pub struct Record {
    /// File that it was read from, as given.
    pub source: String,
    /// Time stamps [s], increasing; at least two.
    pub t: Vec<f64>,
    /// Columns, each with one value for each time stamp.
    pub columns: Vec<Column>,
    /// Inputs that were not logged but are known.
    pub declared: Vec<DeclaredInput>,
    /// How the rig stood at the first sample.
    pub start: Start,
}

/// One measured signal.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name, by which a rig's inputs and outputs find it.
    pub name: String,
    /// Unit that the file states; `None` where it states none, which means SI.
    pub unit: Option<Unit>,
    /// Values in SI.
    pub values: Vec<f64>,
}

/// An input that was not logged: constant, or stepped at known times.
#[derive(Clone, Debug, PartialEq)]
pub struct DeclaredInput {
    /// Name of the rig's input.
    pub name: String,
    /// Stated unit.
    pub unit: Option<Unit>,
    /// (from this time [s], value in SI), times increasing.
    pub steps: Vec<(f64, f64)>,
}

/// How the rig stood when the record began.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// At rest: all rates are zero, coordinates are those of the first sample.
    AtRest,
    /// In a steady state: rates are zero, coordinates are means over the first 0.2 s.
    Settled,
    /// Moving: coordinates and rates are estimated from the first 0.2 s.
    #[default]
    Free,
}

impl Record {
    /// The column of this name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|c| c.name == name)
    }

    /// Median time between samples [s].
    #[must_use]
    pub fn period(&self) -> f64 {
        let mut steps: Vec<f64> = self.t.windows(2).map(|w| w[1] - w[0]).collect();
        steps.sort_by(f64::total_cmp);
        steps.get(steps.len() / 2).copied().unwrap_or(0.0)
    }

    /// Time from first to last sample [s].
    #[must_use]
    pub fn duration(&self) -> f64 {
        match (self.t.first(), self.t.last()) {
            (Some(first), Some(last)) => last - first,
            _ => 0.0,
        }
    }
}

/// Reads a record: `.csv`, or a description file `.toml` (whose `file` is looked up beside it, then under `RIG_DATA`).
///
/// # Errors
/// [`RecordError`]: which file, which place in it, what is wrong and how to mend it.
pub fn read(path: &Path) -> Result<Record, RecordError> {
    let data = std::env::var_os("RIG_DATA").map(std::path::PathBuf::from);
    read_with(path, data.as_deref())
}

/// As [`read`], with the folder for files of descriptions given instead of taken from the environment.
///
/// # Errors
/// As [`read`].
pub fn read_with(path: &Path, data: Option<&Path>) -> Result<Record, RecordError> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    match extension.as_str() {
        "toml" => description::read(path, data),
        "mat" => Err(RecordError::new(path, Cause::NeedsDescription)),
        "rig" => Err(RecordError::new(path, Cause::IsRig)),
        _ => header::read(path),
    }
}

/// The two (or more) named columns of a CSV file without time, in SI.
pub(crate) fn named_columns(path: &Path) -> Result<Vec<Column>, RecordError> {
    Ok(header::columns(path, "V [V], f [N]")?.0)
}

/// Checks time stamps and makes the record. `row_word` and `rows` say where row k stands in the file.
fn finish(
    source: &Path,
    t: Vec<f64>,
    columns: Vec<Column>,
    declared: Vec<DeclaredInput>,
    start: Start,
    place: &dyn Fn(usize) -> error::Row,
) -> Result<Record, RecordError> {
    for (k, w) in t.windows(2).enumerate() {
        let row = place(k + 1);
        if w[1] < w[0] {
            return Err(RecordError::new(source, Cause::TimeBackwards { row, t: w[1], before: w[0] }));
        }
        if w[1] == w[0] {
            return Err(RecordError::new(source, Cause::TimeRepeats { row, t: w[1] }));
        }
    }
    if t.len() < 2 {
        return Err(RecordError::new(source, Cause::TooFewSamples { found: t.len() }));
    }
    Ok(Record { source: source.display().to_string(), t, columns, declared, start })
}
