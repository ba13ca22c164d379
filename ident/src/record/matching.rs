//! A record against a model's names: which column is which input and which output.

use super::error::list;
use super::{Column, Record};
use model_dsl::nearest;
use model_dsl::units::Unit;
use runtime::Model;
use sim::{Hold, Signal, Signals};
use std::fmt;

/// A record whose signals are those of a model.
#[derive(Clone, Debug)]
pub struct Bound {
    /// Inputs, then exogenous signals, in the model's order.
    pub signals: Signals,
    /// For each output of the model, its measured values in SI, where it was logged.
    pub outputs: Vec<Option<Vec<f64>>>,
    /// Columns that the model has no use for.
    pub unused: Vec<String>,
}

/// Why a record does not fit a model.
#[derive(Clone, Debug, PartialEq)]
pub enum MatchError {
    /// An input that the record does not have.
    NoInput {
        /// Record.
        file: String,
        /// Input.
        input: String,
        /// A column with nearly this name.
        near: Option<String>,
        /// Columns that are there.
        found: Vec<String>,
    },
    /// No output of the model was measured.
    NoOutput {
        /// Record.
        file: String,
        /// Outputs of the model.
        outputs: Vec<String>,
        /// Columns that are there.
        found: Vec<String>,
    },
    /// A unit of another dimension than the rig's.
    Unit {
        /// Record.
        file: String,
        /// Column.
        column: String,
        /// Unit in the record.
        unit: String,
        /// Unit in the rig.
        rig: String,
        /// What the rig has it for: `input` or `output`.
        what: &'static str,
    },
    /// A record that did not come from a file: lengths differ, or numbers are not finite.
    Inconsistent {
        /// Record.
        file: String,
        /// What is wrong.
        why: String,
    },
}

impl fmt::Display for MatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoInput { file, input, near, found } => {
                write!(f, "{file}: the rig's input `{input}` is not in the record (columns: {})", list(found))?;
                if let Some(near) = near {
                    write!(f, "; is it the column `{near}`?")?;
                }
                write!(
                    f,
                    "\nif it was not logged, declare it in a description file: `[inputs.{input}]` with `constant = 0` or `steps = [[0, 1.7], [25, 1.3]]`"
                )
            }
            Self::NoOutput { file, outputs, found } => {
                write!(
                    f,
                    "{file}: none of the rig's outputs {} is in the record (columns: {}); name the columns as the rig does",
                    list(outputs),
                    list(found)
                )
            }
            Self::Unit { file, column, unit, rig, what } => {
                write!(f, "{file}: `{column}` is in {unit}, but the rig's {what} of this name is in {rig}")
            }
            Self::Inconsistent { file, why } => write!(f, "{file}: {why}"),
        }
    }
}

impl std::error::Error for MatchError {}

/// Matches a record to a model. Every input (and exogenous signal) must be there, and at least one output.
///
/// `hold` says what logged inputs do between samples; declared inputs are stepped at their own times.
///
/// # Errors
/// [`MatchError`], one variant a cause.
pub fn bind(record: &Record, model: &dyn Model, hold: Hold) -> Result<Bound, MatchError> {
    let d = model.dimensions();
    let names = model.names();
    let signals = bind_signals(record, model, hold)?;
    let mut outputs = Vec::new();
    for i in 0..d.outputs {
        let name = names.output(i);
        outputs.push(match record.column(name) {
            None => None,
            Some(column) => {
                check_unit(record, name, column.unit.as_ref(), names.output_unit(i), "output")?;
                if let Some(k) = column.values.iter().position(|y| !y.is_finite()) {
                    return Err(MatchError::Inconsistent {
                        file: record.source.clone(),
                        why: format!("value {} of `{name}` is {}", k + 1, column.values[k]),
                    });
                }
                Some(column.values.clone())
            }
        });
    }
    if outputs.iter().all(Option::is_none) {
        return Err(MatchError::NoOutput {
            file: record.source.clone(),
            outputs: (0..d.outputs).map(|i| names.output(i).to_owned()).collect(),
            found: found(record),
        });
    }
    let used = |name: &str| (0..d.signals()).any(|i| names.signal(i) == name) || (0..d.outputs).any(|i| names.output(i) == name);
    let unused = record.columns.iter().map(|c| c.name.clone()).filter(|n| !used(n)).collect();
    Ok(Bound { signals, outputs, unused })
}

fn found(record: &Record) -> Vec<String> {
    record.columns.iter().map(|c| c.name.clone()).chain(record.declared.iter().map(|i| i.name.clone())).collect()
}

/// The signals of a model (inputs, then exogenous ones) from a record that need not hold its outputs.
///
/// # Errors
/// [`MatchError`], one variant a cause.
pub fn bind_signals(record: &Record, model: &dyn Model, hold: Hold) -> Result<Signals, MatchError> {
    let d = model.dimensions();
    let names = model.names();
    let file = || record.source.clone();
    if let Some(column) = record.columns.iter().find(|c| c.values.len() != record.t.len() || record.t.len() < 2) {
        let why = format!("`{}` has {} values for {} time stamps", column.name, column.values.len(), record.t.len());
        return Err(MatchError::Inconsistent { file: file(), why });
    }
    let mut signals = Vec::new();
    for i in 0..d.signals() {
        let name = names.signal(i);
        let unit = names.signal_unit(i);
        let signal = if let Some(declared) = record.declared.iter().find(|s| s.name == name) {
            check_unit(record, name, declared.unit.as_ref(), unit, "input")?;
            Signal {
                t: declared.steps.iter().map(|s| s.0).collect(),
                values: declared.steps.iter().map(|s| s.1).collect(),
                hold: Hold::Zero,
            }
        } else if let Some(Column { values, unit: stated, .. }) = record.column(name) {
            check_unit(record, name, stated.as_ref(), unit, "input")?;
            Signal { t: record.t.clone(), values: values.clone(), hold }
        } else {
            let near = nearest(name, record.columns.iter().map(|c| c.name.as_str())).map(str::to_owned);
            return Err(MatchError::NoInput { file: file(), input: name.to_owned(), near, found: found(record) });
        };
        signals.push(signal);
    }
    Signals::new(signals).map_err(|e| MatchError::Inconsistent { file: file(), why: e.to_string() })
}

fn check_unit(record: &Record, column: &str, stated: Option<&Unit>, rig: &str, what: &'static str) -> Result<(), MatchError> {
    let (Some(stated), Ok(wanted)) = (stated, model_dsl::parse_unit(rig)) else { return Ok(()) };
    if stated.dimension == wanted.dimension {
        return Ok(());
    }
    Err(MatchError::Unit { file: record.source.clone(), column: column.to_owned(), unit: stated.text.clone(), rig: rig.to_owned(), what })
}
