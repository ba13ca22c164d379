//! Matrices with names as MATLAB, Octave and SciPy read them: a MAT file of level 5 (not compressed), or a script.
//!
//! Several operating points are pages of one array: `A(:, :, k)`. Knows no rig.

use crate::failure::Failure;
use crate::write::{MARK, write, write_bytes};
use nalgebra::DMatrix;
use std::fmt::Write;
use std::path::Path;

/// What a name stands for.
pub enum Item {
    /// Pages of equal shape; one page is a matrix.
    Pages(Vec<DMatrix<f64>>),
    /// A list of names, one a row.
    Names(Vec<String>),
}

/// Names and what they stand for, in order.
pub struct Workspace {
    /// What it was made from.
    pub source: String,
    /// Names and items.
    pub items: Vec<(&'static str, Item)>,
}

impl Workspace {
    /// Columns of numbers as one page.
    pub fn column(values: &[f64]) -> Item {
        Item::Pages(vec![DMatrix::from_column_slice(values.len(), 1, values)])
    }

    /// Writes the file; its ending says how.
    pub fn write(&self, path: &Path, force: bool) -> Result<(), Failure> {
        match path.extension().map(|e| e.to_string_lossy().to_lowercase()).as_deref() {
            Some("mat") => write_bytes(path, &self.mat(), force),
            Some("m") => write(path, &self.script(), force),
            _ => Err(Failure::new("C0404", format!("--export {}: the ending says nothing", path.display()))
                .with_help("write a MAT file (`model.mat`) or a script (`model.m`)")),
        }
    }

    fn script(&self) -> String {
        let mut out = format!("% {MARK}{}`; SI units and radians.\n", self.source);
        for (name, item) in &self.items {
            match item {
                Item::Names(list) => {
                    let quoted: Vec<String> = list.iter().map(|n| format!("'{}'", n.replace('\'', "''"))).collect();
                    let _ = writeln!(out, "{name} = {{{}}};", quoted.join("; "));
                }
                Item::Pages(pages) => {
                    for (k, page) in pages.iter().enumerate() {
                        let place = if pages.len() > 1 { format!("{name}(:, :, {})", k + 1) } else { (*name).to_owned() };
                        if page.is_empty() {
                            let _ = writeln!(out, "{place} = zeros({}, {});", page.nrows(), page.ncols());
                            continue;
                        }
                        let rows: Vec<String> =
                            page.row_iter().map(|r| r.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(" ")).collect();
                        let _ = writeln!(out, "{place} = [{}];", rows.join(";\n    "));
                    }
                }
            }
        }
        out
    }

    /// MAT file, level 5: a header of 128 bytes, then one element for each name.
    fn mat(&self) -> Vec<u8> {
        let mut text = format!("MATLAB 5.0 MAT-file, {MARK}{}`", self.source);
        while text.len() > 116 {
            text.pop();
        }
        let mut out = format!("{text:116}").into_bytes();
        out.resize(124, 0);
        out.extend(0x0100_u16.to_le_bytes());
        out.extend(*b"IM");
        for (name, item) in &self.items {
            let (class, shape, kind, data): (u32, Vec<usize>, u32, Vec<u8>) = match item {
                Item::Pages(pages) => {
                    let (rows, columns) = pages.first().map_or((0, 0), DMatrix::shape);
                    let mut shape = vec![rows, columns];
                    if pages.len() > 1 {
                        shape.push(pages.len());
                    }
                    // column after column, page after page
                    (DOUBLES, shape, F64, pages.iter().flat_map(|p| p.iter()).flat_map(|x| x.to_le_bytes()).collect())
                }
                Item::Names(list) => {
                    let width = list.iter().map(|n| n.encode_utf16().count()).max().unwrap_or(0);
                    let rows: Vec<Vec<u16>> =
                        list.iter().map(|n| n.encode_utf16().chain(std::iter::repeat(u16::from(b' '))).take(width).collect()).collect();
                    let data = (0..width).flat_map(|j| rows.iter().map(move |r| r[j])).flat_map(u16::to_le_bytes).collect();
                    (CHARACTERS, vec![list.len(), width], U16, data)
                }
            };
            let mut body = Vec::new();
            element(&mut body, U32, &[class.to_le_bytes(), [0; 4]].concat());
            element(&mut body, I32, &shape.iter().flat_map(|n| i32::try_from(*n).unwrap_or(i32::MAX).to_le_bytes()).collect::<Vec<_>>());
            element(&mut body, I8, name.as_bytes());
            element(&mut body, kind, &data);
            element(&mut out, MATRIX, &body);
        }
        out
    }
}

/// Types of data elements, and classes of arrays.
const I8: u32 = 1;
const U16: u32 = 4;
const I32: u32 = 5;
const U32: u32 = 6;
const F64: u32 = 9;
const MATRIX: u32 = 14;
const CHARACTERS: u32 = 4;
const DOUBLES: u32 = 6;

/// A data element: type, length, bytes, filled up to a multiple of eight.
fn element(out: &mut Vec<u8>, kind: u32, bytes: &[u8]) {
    out.extend(kind.to_le_bytes());
    out.extend(u32::try_from(bytes.len()).unwrap_or(u32::MAX).to_le_bytes());
    out.extend(bytes);
    while !out.len().is_multiple_of(8) {
        out.push(0);
    }
}
