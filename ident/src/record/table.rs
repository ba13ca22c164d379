//! Columns of numbers as a file has them: no units, no meaning yet.

use super::error::Row;

/// A table of numbers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Table {
    /// Names from the header, one a column; empty where there are none.
    pub names: Vec<String>,
    /// Columns of equal length.
    pub columns: Vec<Vec<f64>>,
    /// Line of the first row in a text file.
    pub first_line: Option<usize>,
}

impl Table {
    /// Number of samples.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }

    /// Where row k stands in the file.
    pub fn place(&self, k: usize) -> Row {
        match self.first_line {
            Some(line) => Row::Line(line + k),
            None => Row::Sample(k + 1),
        }
    }

    /// Name of column j for messages.
    pub fn name(&self, j: usize) -> String {
        self.names.get(j).cloned().unwrap_or_else(|| format!("column {}", j + 1))
    }

    /// Samples along rows instead of down columns.
    pub fn transposed(self) -> Self {
        let rows = self.rows();
        let columns = (0..rows).map(|k| self.columns.iter().map(|c| c[k]).collect()).collect();
        Self { names: Vec::new(), columns, first_line: None }
    }
}
