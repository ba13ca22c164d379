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

/// Writes values to the start of a slice, as many as it holds.
#[inline]
pub fn write(slice: &mut [f64], values: &[f64]) {
    let n = values.len().min(slice.len());
    if let (Some(to), Some(from)) = (slice.get_mut(..n), values.get(..n)) {
        to.copy_from_slice(from);
    }
}

/// Writes values to a slice from an index on, as many as it holds.
#[inline]
pub fn write_at(slice: &mut [f64], start: usize, values: &[f64]) {
    if let Some(rest) = slice.get_mut(start..) {
        write(rest, values);
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
