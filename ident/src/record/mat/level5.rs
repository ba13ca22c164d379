//! MAT level 5: a header of 128 bytes, then elements of tag (type, length) and data, padded to 8 bytes; an array is an
//! element whose data are elements again: flags, dimensions, name, numbers. An element may be compressed as a whole
//! ("MAT-File Format", MathWorks).

use super::{MatError, MatValue, Number, Variable, word};
use std::io::Read;

/// Unpacked bytes of one variable: more than any record of a laboratory.
const LIMIT: usize = 1 << 30;

const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;

pub(super) fn read(bytes: &[u8], big: bool) -> Result<Vec<Variable>, MatError> {
    let mut variables = Vec::new();
    let mut at = 128;
    while at < bytes.len() {
        let (element, next) = element(bytes, at, big)?;
        match element.kind {
            MATRIX => variables.push(array(element.data, big, at)?),
            COMPRESSED => {
                let unpacked = inflate(element.data, at)?;
                let (inner, _) = self::element(&unpacked, 0, big)?;
                if inner.kind != MATRIX {
                    return Err(MatError::Corrupt {
                        why: format!("a compressed element holds type {} where an array is expected", inner.kind),
                        offset: at,
                    });
                }
                variables.push(array(inner.data, big, at)?);
            }
            // other elements at the top level belong to no variable
            _ => {}
        }
        at = next;
    }
    Ok(variables)
}

struct Element<'a> {
    kind: u32,
    data: &'a [u8],
}

/// The element at `at`, and where the next one begins.
fn element(bytes: &[u8], at: usize, big: bool) -> Result<(Element<'_>, usize), MatError> {
    let truncated = || MatError::Truncated { what: "an element".to_owned(), offset: at };
    let tag = word(bytes, at, big).ok_or_else(truncated)?;
    // small elements keep length and data within the tag
    if tag >> 16 != 0 {
        let length = (tag >> 16) as usize;
        if length > 4 {
            return Err(MatError::Corrupt { why: format!("a small element of {length} bytes"), offset: at });
        }
        let data = bytes.get(at + 4..at + 4 + length).ok_or_else(truncated)?;
        return Ok((Element { kind: tag & 0xffff, data }, at + 8));
    }
    let length = word(bytes, at + 4, big).ok_or_else(truncated)? as usize;
    let end = at.checked_add(8).and_then(|a| a.checked_add(length)).ok_or_else(truncated)?;
    let data = bytes.get(at + 8..end).ok_or_else(truncated)?;
    // compressed elements are not padded; the last one of a file may lack its padding
    let next = if tag == COMPRESSED { end } else { end.checked_next_multiple_of(8).ok_or_else(truncated)? };
    Ok((Element { kind: tag, data }, next))
}

fn inflate(data: &[u8], offset: usize) -> Result<Vec<u8>, MatError> {
    let mut unpacked = Vec::new();
    flate2::read::ZlibDecoder::new(data).take(LIMIT as u64 + 1).read_to_end(&mut unpacked).map_err(|_| MatError::Inflate { offset })?;
    if unpacked.len() > LIMIT { Err(MatError::TooLarge { limit: LIMIT }) } else { Ok(unpacked) }
}

fn number(kind: u32) -> Option<Number> {
    Some(match kind {
        1 => Number::I8,
        2 => Number::U8,
        3 => Number::I16,
        4 => Number::U16,
        5 => Number::I32,
        6 => Number::U32,
        7 => Number::F32,
        9 => Number::F64,
        12 => Number::I64,
        13 => Number::U64,
        _ => return None,
    })
}

fn array(bytes: &[u8], big: bool, offset: usize) -> Result<Variable, MatError> {
    let corrupt = |why: &str| MatError::Corrupt { why: why.to_owned(), offset };
    let (flags, at) = element(bytes, 0, big)?;
    let flags = word(flags.data, 0, big).ok_or_else(|| corrupt("an array without flags"))?;
    let class = flags & 0xff;
    if class == 17 {
        return Ok(Variable { name: "opaque object".to_owned(), value: MatValue::Other("an object") });
    }
    let (dimensions, at) = element(bytes, at, big)?;
    if dimensions.kind != 5 || dimensions.data.len() < 8 {
        return Err(corrupt("an array without dimensions"));
    }
    let sizes: Vec<f64> = Number::I32.decode(dimensions.data, big);
    let (name, at) = element(bytes, at, big)?;
    let name = String::from_utf8_lossy(name.data).trim_end_matches('\0').to_owned();
    let other = match class {
        1 => Some("a cell array"),
        2 => Some("a struct"),
        3 => Some("an object"),
        4 => Some("text"),
        5 => Some("a sparse matrix"),
        6..=15 if flags & 0x0800 != 0 => Some("a complex matrix"),
        6..=15 if sizes.len() > 2 => Some("an array of more than two dimensions"),
        6..=15 => None,
        16 => Some("a function"),
        _ => return Err(corrupt(&format!("`{name}` has the unknown class {class}"))),
    };
    if let Some(other) = other {
        return Ok(Variable { name, value: MatValue::Other(other) });
    }
    if sizes.iter().any(|&s| s < 0.0) {
        return Err(corrupt(&format!("`{name}` has a negative size")));
    }
    // exact: 32-bit integers
    let (rows, columns) = (sizes[0] as usize, sizes[1] as usize);
    let (data, _) = element(bytes, at, big)?;
    let number = number(data.kind).ok_or_else(|| corrupt(&format!("`{name}` holds numbers of the unknown type {}", data.kind)))?;
    let values = number.decode(data.data, big);
    if rows.checked_mul(columns) != Some(values.len()) {
        return Err(corrupt(&format!("`{name}` says {rows} x {columns} and holds {} numbers", values.len())));
    }
    Ok(Variable { name, value: MatValue::Matrix { rows, columns, values } })
}
