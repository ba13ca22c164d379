//! MAT level 4: for each variable a header of five words (type, rows, columns, imaginary, length of the name), the name,
//! the numbers. The type's decimal digits are byte order, 0, kind of number, kind of matrix ("MAT-File Format", MathWorks).

use super::{MatError, MatValue, Number, Variable, word};

pub(super) fn read(bytes: &[u8]) -> Result<Vec<Variable>, MatError> {
    let mut variables = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let (variable, next) = match variable(bytes, at) {
            Ok(found) => found,
            // a first header that makes no sense: some other file
            Err(MatError::Corrupt { .. } | MatError::Truncated { .. }) if at == 0 && type_word(bytes, 0).is_none() => {
                return Err(MatError::NotMat);
            }
            Err(e) => return Err(e),
        };
        variables.push(variable);
        at = next;
    }
    if variables.is_empty() { Err(MatError::NotMat) } else { Ok(variables) }
}

/// Type, and whether words are big-endian.
fn type_word(bytes: &[u8], at: usize) -> Option<(u32, bool)> {
    let little = word(bytes, at, false)?;
    if little < 1000 && digits(little) {
        return Some((little, false));
    }
    let big = word(bytes, at, true)?;
    ((1000..2000).contains(&big) && digits(big - 1000)).then(|| (big - 1000, true))
}

fn digits(kind: u32) -> bool {
    kind / 100 == 0 && kind / 10 % 10 <= 5 && kind % 10 <= 2
}

fn variable(bytes: &[u8], at: usize) -> Result<(Variable, usize), MatError> {
    let Some((kind, big)) = type_word(bytes, at) else {
        return Err(MatError::Corrupt { why: "no variable of level 4 begins here".to_owned(), offset: at });
    };
    let truncated = |what: String| MatError::Truncated { what, offset: at };
    let field = |k: usize| word(bytes, at + 4 * k, big).map(|w| w as usize).ok_or_else(|| truncated("the header of a variable".to_owned()));
    let (rows, columns, imaginary, name_length) = (field(1)?, field(2)?, field(3)?, field(4)?);
    let name_at = at + 20;
    let name_bytes = name_at
        .checked_add(name_length)
        .and_then(|end| bytes.get(name_at..end))
        .ok_or_else(|| truncated("the name of a variable".to_owned()))?;
    let name = String::from_utf8_lossy(name_bytes).trim_end_matches('\0').to_owned();
    let number = match kind / 10 % 10 {
        0 => Number::F64,
        1 => Number::F32,
        2 => Number::I32,
        3 => Number::I16,
        4 => Number::U16,
        _ => Number::U8,
    };
    let parts = if imaginary == 0 { 1 } else { 2 };
    let data_at = name_at + name_length;
    let data = rows
        .checked_mul(columns)
        .and_then(|n| n.checked_mul(number.size()))
        .and_then(|n| n.checked_mul(parts))
        .and_then(|n| n.checked_add(data_at))
        .and_then(|end| bytes.get(data_at..end))
        .ok_or_else(|| truncated(format!("the variable `{name}` ({rows} x {columns})")))?;
    let value = match (kind % 10, parts) {
        (1, _) => MatValue::Other("text"),
        (2, _) => MatValue::Other("a sparse matrix"),
        (_, 2) => MatValue::Other("a complex matrix"),
        _ => MatValue::Matrix { rows, columns, values: number.decode(data, big) },
    };
    Ok((Variable { name, value }, data_at + data.len()))
}
