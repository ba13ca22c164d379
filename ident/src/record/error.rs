//! What can be wrong with a record, one variant a cause; messages name file, column and row.

use super::mat::MatError;
use std::fmt;
use std::path::Path;

/// A row in the user's own counting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Row {
    /// Line of a text file, from 1.
    Line(usize),
    /// Sample of a matrix, from 1.
    Sample(usize),
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(n) => write!(f, "line {n}"),
            Self::Sample(n) => write!(f, "sample {n}"),
        }
    }
}

/// A record that cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordError {
    /// The file.
    pub file: String,
    /// What is wrong with it.
    pub cause: Cause,
}

impl RecordError {
    pub(crate) fn new(file: &Path, cause: Cause) -> Self {
        Self { file: file.display().to_string(), cause }
    }
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.file, self.cause)
    }
}

impl std::error::Error for RecordError {}

/// What is wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// The file cannot be opened or read.
    CannotRead {
        /// The system's words.
        why: String,
    },
    /// The text is not UTF-8.
    NotText {
        /// Line of the first wrong byte.
        line: usize,
    },
    /// A MATLAB file was given where a record is wanted.
    NeedsDescription,
    /// The MATLAB file cannot be read.
    Mat(MatError),
    /// The file has no rows.
    NoRows,
    /// The first line holds numbers instead of names.
    NoHeader {
        /// What stands there.
        text: String,
        /// A header as it should be.
        example: &'static str,
    },
    /// A file of pairs with more or fewer columns than two.
    NoPairs {
        /// Columns that are there.
        found: Vec<String>,
    },
    /// A column has no name.
    NoName {
        /// From 1.
        column: usize,
    },
    /// Two columns have one name.
    TwiceNamed {
        /// The name.
        column: String,
    },
    /// No column of time.
    NoTime {
        /// Columns that are there.
        found: Vec<String>,
    },
    /// The unit of a column is none.
    Unit {
        /// Column or signal.
        column: String,
        /// Why.
        why: String,
    },
    /// The unit of time is no time.
    TimeUnit {
        /// As written.
        unit: String,
    },
    /// A bracket that does not close, or text after it.
    Bracket {
        /// Header as written.
        text: String,
    },
    /// A row with more or fewer cells.
    Cells {
        /// Where.
        row: Row,
        /// Cells of the header or of the first row.
        wanted: usize,
        /// Cells here.
        found: usize,
    },
    /// The cells are separated by something else than commas.
    Delimiter {
        /// What stands between them: `semicolons` or `tabs`.
        found: &'static str,
        /// The word for a description.
        word: &'static str,
    },
    /// Numbers are written with decimal commas.
    DecimalCommas {
        /// Where the first one stands.
        row: Row,
        /// As written.
        text: String,
    },
    /// A rig was given where a record is wanted.
    IsRig,
    /// A cell without anything in it.
    EmptyCell {
        /// Where.
        row: Row,
        /// Column.
        column: String,
    },
    /// A cell that is no number.
    NotANumber {
        /// Where.
        row: Row,
        /// Column.
        column: String,
        /// What stands there.
        text: String,
    },
    /// NaN or infinity.
    NotFinite {
        /// Where.
        row: Row,
        /// Column.
        column: String,
        /// The value.
        value: f64,
    },
    /// Time runs backwards.
    TimeBackwards {
        /// Where.
        row: Row,
        /// Time there.
        t: f64,
        /// Time before it.
        before: f64,
    },
    /// A time stamp occurs twice.
    TimeRepeats {
        /// Where.
        row: Row,
        /// Time there.
        t: f64,
    },
    /// Fewer than two samples.
    TooFewSamples {
        /// How many.
        found: usize,
    },
    /// A description is no TOML.
    Toml {
        /// Line, from 1.
        line: usize,
        /// What the parser says.
        why: String,
    },
    /// A key that descriptions do not have.
    UnknownKey {
        /// With the tables that it stands in: `signals.psi.colunm`.
        key: String,
        /// The nearest key, if one is near.
        near: Option<String>,
        /// All keys of that table.
        known: Vec<String>,
    },
    /// A key with a value of the wrong kind.
    KeyValue {
        /// The key.
        key: String,
        /// What it takes.
        wanted: String,
    },
    /// A key that is missing.
    MissingKey {
        /// The key.
        key: String,
        /// What it is for.
        why: String,
    },
    /// Keys that exclude each other.
    Either {
        /// The table.
        of: String,
        /// The keys.
        keys: &'static str,
    },
    /// The described file is in none of the places.
    NotFound {
        /// File as the description names it.
        file: String,
        /// Where it was looked for.
        looked: Vec<String>,
        /// `RIG_DATA` is set.
        data_set: bool,
    },
    /// A variable that the MATLAB file does not have.
    NoVariable {
        /// Wanted.
        variable: String,
        /// Matrices of numbers that are there.
        found: Vec<String>,
    },
    /// The file has several variables and the description names none.
    WhichVariable {
        /// Matrices of numbers that are there.
        found: Vec<String>,
    },
    /// A variable that is no matrix of numbers.
    VariableKind {
        /// Its name.
        variable: String,
        /// What it is.
        kind: &'static str,
    },
    /// A column number that the table does not have.
    NoColumnNumber {
        /// Signal.
        signal: String,
        /// From 1.
        number: i64,
        /// How many columns there are.
        columns: usize,
    },
    /// A column name that the table does not have.
    NoColumnName {
        /// Signal.
        signal: String,
        /// Wanted.
        name: String,
        /// Names that are there.
        found: Vec<String>,
    },
    /// An expression over columns is wrong.
    Expression {
        /// Signal.
        signal: String,
        /// Why.
        why: String,
    },
    /// A signal comes from a file with another number of samples.
    OtherLength {
        /// Signal.
        signal: String,
        /// Samples of the record.
        wanted: usize,
        /// Samples of that file.
        found: usize,
    },
    /// A stepped input does not say its value at the first sample, or its times do not increase.
    Steps {
        /// Input.
        input: String,
        /// Why.
        why: String,
    },
    /// No sample lies between `from` and `to`.
    EmptyPart {
        /// From [s].
        from: f64,
        /// To [s].
        to: f64,
        /// First and last time stamp of the file [s].
        file: (f64, f64),
    },
}

/// "a, b and c", at most eight of them.
pub(crate) fn list(names: &[String]) -> String {
    let shown: Vec<String> = names.iter().take(8).map(|n| format!("`{n}`")).collect();
    let more = names.len().saturating_sub(8);
    match (shown.as_slice(), more) {
        ([], _) => "nothing".to_owned(),
        ([one], _) => one.clone(),
        ([head @ .., last], 0) => format!("{} and {last}", head.join(", ")),
        (all, more) => format!("{} and {more} more", all.join(", ")),
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CannotRead { why } => write!(f, "cannot be read: {why}"),
            Self::NotText { line } => write!(f, "line {line} is not UTF-8 text; export the record as UTF-8 CSV, or describe a MATLAB file in a .toml"),
            Self::NeedsDescription => f.write_str(
                "a MATLAB file does not say what its columns are; write a .toml beside it that names the file, the variable and the column of each signal",
            ),
            Self::Mat(e) => write!(f, "{e}"),
            Self::NoRows => f.write_str("there are no samples; the first line names the columns (`t, theta [deg], u`), each line after it is one sample"),
            Self::NoHeader { text, example } => write!(f, "the first line starts with the number `{text}`; it has to name the columns: `{example}`"),
            Self::NoPairs { found } => write!(f, "pairs take two columns, abscissa then ordinate; here are {}: {}", found.len(), list(found)),
            Self::NoName { column } => write!(f, "column {column} has no name in the first line"),
            Self::TwiceNamed { column } => write!(f, "two columns are named `{column}`"),
            Self::NoTime { found } => write!(
                f,
                "there is no column of time; name it `t` (seconds), or give its column or the rate in a description file (columns: {})",
                list(found)
            ),
            Self::Unit { column, why } => {
                write!(f, "unit of `{column}`: {why}; write it as rigs do (`deg`, `mm`, `N*m`, `rad/s`), or leave it out where it is SI")
            }
            Self::TimeUnit { unit } => write!(f, "`{unit}` is no unit of time; write `t` (seconds), `t [ms]` or `t [min]`"),
            Self::Bracket { text } => write!(f, "the column name `{text}` has no unit in brackets at its end; write `theta [deg]`"),
            Self::Cells { row, wanted, found } => {
                write!(f, "{row} has {found} cells, the lines before it have {wanted}")?;
                if found > wanted { f.write_str("; decimal commas split numbers in two: export with decimal points") } else { Ok(()) }
            }
            Self::Delimiter { found, word } => write!(
                f,
                "the cells are separated by {found}; a record has commas: export it anew, or read it through a description with `delimiter = \"{word}\"`"
            ),
            Self::DecimalCommas { row, text } => {
                write!(f, "{row}: `{text}` has a decimal comma, which is not read; export the numbers with decimal points")
            }
            Self::IsRig => f.write_str("this is a rig, not a record; records are `.csv` files, or `.toml` files that describe one"),
            Self::EmptyCell { row, column } => write!(f, "{row}: the cell of `{column}` is empty; cut the record there, or fill in the sample"),
            Self::NotANumber { row, column, text } => write!(f, "{row}: `{text}` in column `{column}` is no number"),
            Self::NotFinite { row, column, value } => write!(f, "{row}: `{column}` is {value}; cut the record there (`from`, `to` in a description)"),
            Self::TimeBackwards { row, t, before } => write!(f, "{row}: time runs backwards, from {before} s to {t} s; sort the samples, or split the record into runs"),
            Self::TimeRepeats { row, t } => write!(
                f,
                "{row}: the time {t} s occurs twice; where a rounded time column was exported, leave it out and give the `rate` in a description"
            ),
            Self::TooFewSamples { found } => write!(f, "a record needs at least two samples, this has {found}"),
            Self::Toml { line, why } => write!(f, "line {line}: {why}"),
            Self::UnknownKey { key, near, known } => {
                write!(f, "there is no key `{key}`")?;
                match near {
                    Some(near) => write!(f, "; did you mean `{near}`?"),
                    None => write!(f, "; the keys here are {}", known.join(", ")),
                }
            }
            Self::KeyValue { key, wanted } => write!(f, "`{key}` takes {wanted}"),
            Self::MissingKey { key, why } => write!(f, "the key `{key}` is missing: {why}"),
            Self::Either { of, keys } => write!(f, "`{of}` needs exactly one of {keys}"),
            Self::NotFound { file, looked, data_set } => {
                write!(f, "the file `{file}` is not there; looked for it at {}", list(looked))?;
                if *data_set { Ok(()) } else { f.write_str("; the environment variable RIG_DATA, which may name the folder of records, is not set") }
            }
            Self::NoVariable { variable, found } => write!(f, "there is no variable `{variable}`; matrices of numbers in this file: {}", list(found)),
            Self::WhichVariable { found } => write!(f, "say which variable: `variable = \"..\"`; matrices of numbers in this file: {}", list(found)),
            Self::VariableKind { variable, kind } => {
                write!(f, "the variable `{variable}` is {kind}, not a matrix of numbers; in MATLAB save its columns: `data = [t, y1, y2]; save('run.mat', 'data', '-v7')`")
            }
            Self::NoColumnNumber { signal, number, columns } => write!(f, "`{signal}` wants column {number}, there are columns 1 to {columns}"),
            Self::NoColumnName { signal, name, found } => write!(f, "`{signal}` wants the column `{name}`; there are {}", list(found)),
            Self::Expression { signal, why } => write!(f, "expression of `{signal}`: {why}"),
            Self::OtherLength { signal, wanted, found } => {
                write!(f, "`{signal}` has {found} samples, the record has {wanted}; signals of several files must have been logged together")
            }
            Self::Steps { input, why } => write!(f, "steps of `{input}`: {why}"),
            Self::EmptyPart { from, to, file } => write!(f, "fewer than two samples lie between {from} s and {to} s; the file goes from {} s to {} s", file.0, file.1),
        }
    }
}
