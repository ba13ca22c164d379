//! Description files: which file, which columns, which units (reference: `docs/records.md`).
//!
//! The TOML is walked by hand, so that an unknown key can name the nearest known one.

use super::error::{Cause, RecordError};
use super::expression::{self, Expression};
use super::mat::{MatValue, Variable, read_mat};
use super::table::Table;
use super::{Column, DeclaredInput, Record, Start, finish, header, text};
use model_dsl::nearest;
use model_dsl::units::Unit;
use std::path::{Path, PathBuf};
use toml::{Table as Toml, Value};

const TOP: [&str; 16] = [
    "title",
    "file",
    "variable",
    "orientation",
    "header",
    "delimiter",
    "rate",
    "first",
    "start",
    "from",
    "to",
    "time",
    "columns",
    "signals",
    "inputs",
    "notes",
];
const TIME: [&str; 4] = ["column", "variable", "file", "unit"];
const SIGNAL: [&str; 11] =
    ["file", "variable", "orientation", "header", "delimiter", "column", "expression", "scale", "sign", "offset", "unit"];
const SIGNAL_LIMITS: &str = "limits";
const INPUT: [&str; 3] = ["constant", "steps", "unit"];

/// Reads a description and the files that it names.
pub(crate) fn read(path: &Path, data: Option<&Path>) -> Result<Record, RecordError> {
    let error = |cause| RecordError::new(path, cause);
    let bytes = std::fs::read(path).map_err(|e| error(Cause::CannotRead { why: e.to_string() }))?;
    let text = String::from_utf8(bytes).map_err(|e| {
        let valid = e.utf8_error().valid_up_to();
        error(Cause::NotText { line: e.as_bytes()[..valid].iter().filter(|&&b| b == b'\n').count() + 1 })
    })?;
    let root: Toml = text.parse().map_err(|e: toml::de::Error| {
        let line = e.span().map_or(1, |span| text[..span.start.min(text.len())].matches('\n').count() + 1);
        error(Cause::Toml { line, why: e.message().to_owned() })
    })?;
    Reader { path, data, files: Vec::new() }.record(&root)
}

/// Where samples of a signal come from.
#[derive(Clone, Debug, PartialEq)]
struct Source {
    file: Option<String>,
    variable: Option<String>,
    rows: bool,
    header: Option<usize>,
    delimiter: Option<Option<u8>>,
}

/// A file that has been read.
struct Loaded {
    source: Source,
    path: PathBuf,
    table: Table,
}

struct Reader<'a> {
    path: &'a Path,
    data: Option<&'a Path>,
    files: Vec<Loaded>,
}

type Fallible<T> = Result<T, RecordError>;

impl Reader<'_> {
    fn error(&self, cause: Cause) -> RecordError {
        RecordError::new(self.path, cause)
    }

    fn record(&mut self, root: &Toml) -> Fallible<Record> {
        self.known("", root, &TOP)?;
        let main = self.source("", root, None)?;
        let names = self.named_columns(root)?;
        let signals = self.tables(root, "signals")?;
        let inputs = self.tables(root, "inputs")?;
        if signals.is_empty() {
            return Err(self.error(Cause::MissingKey {
                key: "signals".to_owned(),
                why: "each measured signal has a table `[signals.NAME]`".to_owned(),
            }));
        }
        let (t, place) = self.time(root, &main, &signals)?;
        let (from, to) = (self.number("", root, "from")?, self.number("", root, "to")?);
        let keep: Vec<usize> = (0..t.len()).filter(|&k| from.is_none_or(|from| t[k] >= from) && to.is_none_or(|to| t[k] <= to)).collect();
        if keep.len() < 2 && (from.is_some() || to.is_some()) {
            let file = (t.first().copied().unwrap_or(f64::NAN), t.last().copied().unwrap_or(f64::NAN));
            return Err(self.error(Cause::EmptyPart { from: from.unwrap_or(file.0), to: to.unwrap_or(file.1), file }));
        }
        let mut columns = Vec::new();
        for (name, table) in &signals {
            columns.push(self.signal(name, table, &main, &names, t.len(), &keep)?);
        }
        let t: Vec<f64> = keep.iter().map(|&k| t[k]).collect();
        let mut declared = Vec::new();
        for (name, table) in &inputs {
            declared.push(self.declared(name, table, t.first().copied().unwrap_or(0.0))?);
        }
        let start = self.start(root)?;
        let source = self.path.to_owned();
        // time stamps are told in the file that they come from
        let (file, first_line) = place;
        let row = move |k: usize| {
            let k = keep.get(k).copied().unwrap_or(k);
            first_line.map_or(super::error::Row::Sample(k + 1), |line| super::error::Row::Line(line + k))
        };
        let mut record = finish(file.as_deref().unwrap_or(&source), t, columns, declared, start, &row)?;
        record.source = source.display().to_string();
        Ok(record)
    }

    // ---- keys ----

    fn known(&self, of: &str, table: &Toml, known: &[&str]) -> Fallible<()> {
        match table.keys().find(|key| !known.contains(&key.as_str())) {
            None => Ok(()),
            Some(key) => Err(self.error(Cause::UnknownKey {
                key: path_of(of, key),
                near: nearest(key, known.iter().copied()).map(str::to_owned),
                known: known.iter().map(|k| (*k).to_owned()).collect(),
            })),
        }
    }

    fn wrong(&self, of: &str, key: &str, wanted: &str) -> RecordError {
        self.error(Cause::KeyValue { key: path_of(of, key), wanted: wanted.to_owned() })
    }

    fn text(&self, of: &str, table: &Toml, key: &str) -> Fallible<Option<String>> {
        match table.get(key) {
            None => Ok(None),
            Some(Value::String(text)) => Ok(Some(text.clone())),
            Some(_) => Err(self.wrong(of, key, "a text in quotes")),
        }
    }

    fn number(&self, of: &str, table: &Toml, key: &str) -> Fallible<Option<f64>> {
        table.get(key).map(|value| as_number(value).ok_or_else(|| self.wrong(of, key, "a number"))).transpose()
    }

    /// The tables `[key.NAME]`, sorted by name.
    fn tables(&self, root: &Toml, key: &str) -> Fallible<Vec<(String, Toml)>> {
        let Some(value) = root.get(key) else { return Ok(Vec::new()) };
        let Value::Table(tables) = value else { return Err(self.wrong("", key, &format!("tables: `[{key}.NAME]`"))) };
        tables
            .iter()
            .map(|(name, value)| match value {
                Value::Table(table) => Ok((name.clone(), table.clone())),
                _ => Err(self.wrong(key, name, "a table: `{ column = 2 }`")),
            })
            .collect()
    }

    fn start(&self, root: &Toml) -> Fallible<Start> {
        Ok(match self.text("", root, "start")?.as_deref() {
            None | Some("free") => Start::Free,
            Some("at_rest") => Start::AtRest,
            Some("settled") => Start::Settled,
            Some(_) => return Err(self.wrong("", "start", "\"at_rest\", \"settled\" or \"free\"")),
        })
    }

    fn unit(&self, of: &str, table: &Toml) -> Fallible<Option<Unit>> {
        let Some(text) = self.text(of, table, "unit")? else { return Ok(None) };
        match model_dsl::parse_unit(&text) {
            Ok(unit) => Ok(Some(unit)),
            Err(why) => Err(self.error(Cause::Unit { column: of.rsplit('.').next().unwrap_or(of).to_owned(), why })),
        }
    }

    fn source(&self, of: &str, table: &Toml, parent: Option<&Source>) -> Fallible<Source> {
        let rows = match self.text(of, table, "orientation")?.as_deref() {
            None => parent.is_some_and(|p| p.rows),
            Some("columns") => false,
            Some("rows") => true,
            Some(_) => return Err(self.wrong(of, "orientation", "\"columns\" (one signal a column) or \"rows\" (one signal a row)")),
        };
        let header = match table.get("header") {
            None => parent.and_then(|p| p.header),
            Some(Value::Integer(n)) if (0..=1000).contains(n) => Some(usize::try_from(*n).unwrap_or(0)),
            Some(_) => return Err(self.wrong(of, "header", "the number of lines before the numbers")),
        };
        let delimiter = match self.text(of, table, "delimiter")?.as_deref() {
            None => parent.and_then(|p| p.delimiter),
            Some("," | "comma") => Some(Some(b',')),
            Some(";" | "semicolon") => Some(Some(b';')),
            Some("\t" | "tab") => Some(Some(b'\t')),
            Some(" " | "blank") => Some(None),
            Some(_) => return Err(self.wrong(of, "delimiter", "\"comma\", \"semicolon\", \"tab\" or \"blank\" (any run of blanks)")),
        };
        let file = self.text(of, table, "file")?;
        let variable = self.text(of, table, "variable")?;
        Ok(Source {
            file: file.or_else(|| parent.and_then(|p| p.file.clone())),
            variable: variable.or_else(|| parent.and_then(|p| p.variable.clone())),
            rows,
            header,
            delimiter,
        })
    }

    /// `[columns]`: names for columns, for use in expressions.
    fn named_columns(&self, root: &Toml) -> Fallible<Vec<(String, i64)>> {
        let Some(value) = root.get("columns") else { return Ok(Vec::new()) };
        let Value::Table(table) = value else { return Err(self.wrong("", "columns", "a table of names and column numbers: `V_s = 4`")) };
        table
            .iter()
            .map(|(name, value)| match value {
                Value::Integer(n) => Ok((name.clone(), *n)),
                _ => Err(self.wrong("columns", name, "a column number, counted from 1")),
            })
            .collect()
    }

    // ---- files ----

    fn load(&mut self, signal: &str, source: &Source) -> Fallible<usize> {
        if let Some(k) = self.files.iter().position(|f| f.source == *source) {
            return Ok(k);
        }
        let Some(file) = &source.file else {
            let key = if signal.is_empty() { "file".to_owned() } else { format!("{signal}.file") };
            return Err(self.error(Cause::MissingKey { key, why: "it names the file with the samples".to_owned() }));
        };
        let path = self.find(file)?;
        let is_mat = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("mat"));
        let table = if is_mat {
            let bytes = std::fs::read(&path).map_err(|e| RecordError::new(&path, Cause::CannotRead { why: e.to_string() }))?;
            let variables = read_mat(&bytes).map_err(|e| RecordError::new(&path, Cause::Mat(e)))?;
            matrix(variables, source).map_err(|cause| RecordError::new(&path, cause))?
        } else {
            let tabs = path.extension().is_some_and(|e| !e.eq_ignore_ascii_case("csv"));
            let delimiter = source.delimiter.unwrap_or(Some(if tabs { b'\t' } else { b',' }));
            let header = source.header.unwrap_or(1);
            let table = text::read(&path, text::Layout { delimiter, header })?;
            if source.rows { table.transposed() } else { table }
        };
        self.files.push(Loaded { source: source.clone(), path, table });
        Ok(self.files.len() - 1)
    }

    /// Beside the description, then under the folder of records.
    fn find(&self, file: &str) -> Fallible<PathBuf> {
        let beside = self.path.parent().unwrap_or_else(|| Path::new("")).join(file);
        let mut looked = vec![beside.display().to_string()];
        if beside.is_file() {
            return Ok(beside);
        }
        if let Some(data) = self.data {
            let path = data.join(file);
            if path.is_file() {
                return Ok(path);
            }
            looked.push(path.display().to_string());
        }
        Err(self.error(Cause::NotFound { file: file.to_owned(), looked, data_set: self.data.is_some() }))
    }

    fn column_number(&self, signal: &str, loaded: usize, number: i64) -> Fallible<usize> {
        let table = &self.files[loaded].table;
        match usize::try_from(number) {
            Ok(n) if n >= 1 && n <= table.columns.len() => Ok(n - 1),
            _ => Err(RecordError::new(
                &self.files[loaded].path,
                Cause::NoColumnNumber { signal: signal.to_owned(), number, columns: table.columns.len() },
            )),
        }
    }

    /// A column by its name in the header.
    fn column_name(&self, signal: &str, loaded: usize, name: &str, aliases: &[(String, i64)]) -> Fallible<usize> {
        if let Some((_, number)) = aliases.iter().find(|(alias, _)| alias == name) {
            return self.column_number(signal, loaded, *number);
        }
        let table = &self.files[loaded].table;
        table.names.iter().position(|n| n == name).ok_or_else(|| {
            let found = aliases.iter().map(|(alias, _)| alias.clone()).chain(table.names.iter().cloned()).collect();
            RecordError::new(&self.files[loaded].path, Cause::NoColumnName { signal: signal.to_owned(), name: name.to_owned(), found })
        })
    }

    fn column(&self, of: &str, signal: &str, loaded: usize, table: &Toml, aliases: &[(String, i64)]) -> Fallible<usize> {
        match table.get("column") {
            Some(Value::Integer(n)) => self.column_number(signal, loaded, *n),
            Some(Value::String(name)) => self.column_name(signal, loaded, name, aliases),
            Some(_) => Err(self.wrong(of, "column", "a column number, counted from 1, or the column's name in the file")),
            // a vector needs no number
            None if self.files[loaded].table.columns.len() == 1 => Ok(0),
            None => {
                Err(self
                    .error(Cause::MissingKey { key: path_of(of, "column"), why: "it says where in the file the signal stands".to_owned() }))
            }
        }
    }

    // ---- time ----

    /// Time stamps, and the file and first line that they stand in (for messages).
    #[allow(clippy::type_complexity)]
    fn time(&mut self, root: &Toml, main: &Source, signals: &[(String, Toml)]) -> Fallible<(Vec<f64>, (Option<PathBuf>, Option<usize>))> {
        let rate = self.number("", root, "rate")?;
        let first = self.number("", root, "first")?;
        if let Some(rate) = rate {
            if root.contains_key("time") {
                return Err(self.error(Cause::Either { of: "time".to_owned(), keys: "`rate` and `[time]`" }));
            }
            if !(rate > 0.0 && rate.is_finite()) {
                return Err(self.wrong("", "rate", "a positive number of samples per second"));
            }
            let (name, table) = &signals[0];
            let source = self.source(&path_of("signals", name), table, Some(main))?;
            let loaded = self.load(&path_of("signals", name), &source)?;
            let first = first.unwrap_or(0.0);
            let t = (0..self.files[loaded].table.rows()).map(|k| first + k as f64 / rate).collect();
            return Ok((t, (None, None)));
        }
        if first.is_some() {
            return Err(self.error(Cause::MissingKey {
                key: "rate".to_owned(),
                why: "`first` is the time of the first sample where there is no time column".to_owned(),
            }));
        }
        let empty = Toml::new();
        let table = match root.get("time") {
            None => &empty,
            Some(Value::Table(table)) => table,
            Some(_) => return Err(self.wrong("", "time", "a table: `[time]` with `column`, `unit`")),
        };
        self.known("time", table, &TIME)?;
        let source = self.source("time", table, Some(main))?;
        let loaded = self.load("time", &source)?;
        let column = if table.contains_key("column") || self.files[loaded].table.columns.len() == 1 {
            self.column("time", "time", loaded, table, &[])?
        } else {
            let names = &self.files[loaded].table.names;
            match names.iter().position(|n| n == "t" || n == "time") {
                Some(k) => k,
                None => return Err(RecordError::new(&self.files[loaded].path, Cause::NoTime { found: names.clone() })),
            }
        };
        let unit = self.unit("time", table)?;
        header::check_time_unit(unit.as_ref()).map_err(|cause| self.error(cause))?;
        let factor = unit.map_or(1.0, |u| u.factor);
        let file = &self.files[loaded];
        let t: Vec<f64> = file.table.columns[column].iter().map(|t| t * factor).collect();
        if let Some(k) = t.iter().position(|t| !t.is_finite()) {
            return Err(RecordError::new(
                &file.path,
                Cause::NotFinite { row: file.table.place(k), column: file.table.name(column), value: t[k] },
            ));
        }
        Ok((t, (Some(file.path.clone()), file.table.first_line)))
    }

    // ---- signals ----

    fn signal(
        &mut self,
        name: &str,
        table: &Toml,
        main: &Source,
        aliases: &[(String, i64)],
        samples: usize,
        keep: &[usize],
    ) -> Fallible<Column> {
        let of = path_of("signals", name);
        self.known(&of, table, &[&SIGNAL[..], &[SIGNAL_LIMITS]].concat())?;
        let source = self.source(&of, table, Some(main))?;
        let loaded = self.load(&of, &source)?;
        let (formula, uses): (Expression, Vec<usize>) = match (table.contains_key("column"), self.text(&of, table, "expression")?) {
            (true, Some(_)) => return Err(self.error(Cause::Either { of, keys: "`column` and `expression`" })),
            (_, None) => (Expression::Name(0), vec![self.column(&of, name, loaded, table, aliases)?]),
            (false, Some(text)) => {
                let (formula, names) =
                    expression::parse(&text).map_err(|why| self.error(Cause::Expression { signal: name.to_owned(), why }))?;
                let uses = names.iter().map(|n| self.column_name(name, loaded, n, aliases)).collect::<Result<_, _>>()?;
                (formula, uses)
            }
        };
        let scale = self.number(&of, table, "scale")?.unwrap_or(1.0);
        let sign = match table.get("sign").map(as_number) {
            None => 1.0,
            Some(Some(s)) if s.abs() == 1.0 => s,
            Some(_) => return Err(self.wrong(&of, "sign", "1 or -1")),
        };
        let offset = self.number(&of, table, "offset")?.unwrap_or(0.0);
        let unit = self.unit(&of, table)?;
        let factor = unit.as_ref().map_or(1.0, |u| u.factor);
        let (low, high) = self.limits(&of, table)?;
        let file = &self.files[loaded];
        if file.table.rows() != samples {
            return Err(RecordError::new(
                &file.path,
                Cause::OtherLength { signal: name.to_owned(), wanted: samples, found: file.table.rows() },
            ));
        }
        let mut values = Vec::with_capacity(keep.len());
        let mut cells = vec![0.0; uses.len()];
        for &k in keep {
            for (cell, &j) in cells.iter_mut().zip(&uses) {
                *cell = file.table.columns[j][k];
                if !cell.is_finite() {
                    return Err(RecordError::new(
                        &file.path,
                        Cause::NotFinite { row: file.table.place(k), column: file.table.name(j), value: *cell },
                    ));
                }
            }
            let value = (sign * scale * formula.value(&cells) + offset).max(low).min(high) * factor;
            if !value.is_finite() {
                return Err(RecordError::new(&file.path, Cause::NotFinite { row: file.table.place(k), column: name.to_owned(), value }));
            }
            values.push(value);
        }
        Ok(Column { name: name.to_owned(), unit, values })
    }

    fn limits(&self, of: &str, table: &Toml) -> Fallible<(f64, f64)> {
        let Some(value) = table.get(SIGNAL_LIMITS) else { return Ok((f64::NEG_INFINITY, f64::INFINITY)) };
        match value.as_array().map(|a| a.iter().map(as_number).collect::<Vec<_>>()).as_deref() {
            Some([Some(low), Some(high)]) if low <= high => Ok((*low, *high)),
            _ => Err(self.wrong(of, SIGNAL_LIMITS, "two numbers, the lower one first: `[-5, 5]`")),
        }
    }

    fn declared(&self, name: &str, table: &Toml, first: f64) -> Fallible<DeclaredInput> {
        let of = path_of("inputs", name);
        self.known(&of, table, &INPUT)?;
        let unit = self.unit(&of, table)?;
        let factor = unit.as_ref().map_or(1.0, |u| u.factor);
        let steps = match (self.number(&of, table, "constant")?, table.get("steps")) {
            (Some(value), None) => vec![(first, value * factor)],
            (None, Some(Value::Array(steps))) => {
                let mut out: Vec<(f64, f64)> = Vec::new();
                for step in steps {
                    match step.as_array().map(|a| a.iter().map(as_number).collect::<Vec<_>>()).as_deref() {
                        Some([Some(t), Some(value)]) => out.push((*t, value * factor)),
                        _ => return Err(self.wrong(&of, "steps", "pairs of time and value: `[[0, 1.7], [25, 1.3]]`")),
                    }
                }
                out
            }
            (None, Some(_)) => return Err(self.wrong(&of, "steps", "pairs of time and value: `[[0, 1.7], [25, 1.3]]`")),
            _ => return Err(self.error(Cause::Either { of, keys: "`constant` and `steps`" })),
        };
        let why = |why: String| self.error(Cause::Steps { input: name.to_owned(), why });
        match steps.first() {
            None => return Err(why("there is none".to_owned())),
            Some((t, _)) if *t > first => {
                return Err(why(format!("the first one is at {t} s, after the first sample at {first} s; say the value before it too")));
            }
            Some(_) => {}
        }
        if let Some(w) = steps.windows(2).find(|w| w[1].0 <= w[0].0) {
            return Err(why(format!("their times must increase, {} s comes after {} s", w[1].0, w[0].0)));
        }
        if steps.iter().any(|(t, value)| !t.is_finite() || !value.is_finite()) {
            return Err(why("a number is not finite".to_owned()));
        }
        Ok(DeclaredInput { name: name.to_owned(), unit, steps })
    }
}

fn path_of(of: &str, key: &str) -> String {
    if of.is_empty() { key.to_owned() } else { format!("{of}.{key}") }
}

#[allow(clippy::cast_precision_loss)] // numbers that people write
fn as_number(value: &Value) -> Option<f64> {
    match value {
        Value::Integer(n) => Some(*n as f64),
        Value::Float(x) if !x.is_nan() => Some(*x),
        _ => None,
    }
}

/// The variable that the source names, as a table of samples.
fn matrix(variables: Vec<Variable>, source: &Source) -> Result<Table, Cause> {
    let found: Vec<String> = variables.iter().filter(|v| matches!(v.value, MatValue::Matrix { .. })).map(|v| v.name.clone()).collect();
    let chosen = match &source.variable {
        Some(name) => variables.into_iter().find(|v| v.name == *name).ok_or_else(|| Cause::NoVariable { variable: name.clone(), found })?,
        None if found.len() == 1 => variables.into_iter().find(|v| v.name == found[0]).ok_or(Cause::NoRows)?,
        None => return Err(Cause::WhichVariable { found }),
    };
    match chosen.value {
        MatValue::Other(kind) => Err(Cause::VariableKind { variable: chosen.name, kind }),
        MatValue::Matrix { rows: 0, .. } | MatValue::Matrix { columns: 0, .. } => Err(Cause::NoRows),
        MatValue::Matrix { rows, columns, values } => {
            // a vector is one signal, whichever way it lies
            let columns = if rows == 1 || columns == 1 {
                vec![values]
            } else if source.rows {
                (0..rows).map(|i| values.iter().skip(i).step_by(rows).copied().collect()).collect()
            } else {
                values.chunks(rows).map(<[f64]>::to_vec).collect()
            };
            Ok(Table { names: Vec::new(), columns, first_line: None })
        }
    }
}
