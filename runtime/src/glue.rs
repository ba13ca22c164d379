//! What the adaptors of generated models need: slices to arrays and back, the check of a pivot. Never panics.

use crate::Singular;

/// The first `N` entries of a slice. An entry that is missing is not a number, so that a slice of the
/// wrong length shows in every result.
#[inline]
#[must_use]
pub fn array<const N: usize>(slice: &[f64]) -> [f64; N] {
    match slice.first_chunk::<N>() {
        Some(values) => *values,
        None => core::array::from_fn(|i| slice.get(i).copied().unwrap_or(f64::NAN)),
    }
}

/// Writes values to a slice from an index on, as many as it holds.
#[inline]
pub fn write<const N: usize>(slice: &mut [f64], start: usize, values: &[f64; N]) {
    let Some(rest) = slice.get_mut(start..) else { return };
    match rest.first_chunk_mut::<N>() {
        Some(chunk) => *chunk = *values,
        None => rest.iter_mut().zip(values).for_each(|(to, from)| *to = *from),
    }
}

/// Writes a matrix row by row to a slice, as many entries as it holds.
#[inline]
pub fn write_rows<const C: usize, const R: usize>(slice: &mut [f64], rows: &[[f64; C]; R]) {
    for (to, from) in slice.iter_mut().zip(rows.as_flattened()) {
        *to = *from;
    }
}

/// Checks a pivot of the mass matrix, the one of this coordinate.
///
/// # Errors
/// [`Singular`] where it is not positive, or not a number.
#[inline]
pub fn positive(pivot: f64, coordinate: usize) -> Result<(), Singular> {
    if pivot > 0.0 { Ok(()) } else { Err(Singular { coordinate }) }
}
