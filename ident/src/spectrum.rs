//! Eigenvalues of symmetric matrices, in a bounded number of steps, whatever the entries. Knows nothing of records or models.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Steps for each row before the search for eigenvalues is given up; two or three are usual.
const STEPS: usize = 100;

/// Eigenvalues and eigenvectors (columns) of the symmetric matrix `m`, n x n. A normal matrix whose entries are not all finite says nothing: its
/// eigenvalues are zero. (The library's own way has no bound on its steps.)
#[must_use]
pub fn of_symmetric(m: DMatrix<f64>) -> SymmetricEigen<f64, nalgebra::Dyn> {
    let n = m.nrows();
    let nothing = || SymmetricEigen { eigenvectors: DMatrix::identity(n, n), eigenvalues: DVector::zeros(n) };
    if n == 0 || m.iter().any(|v| !v.is_finite()) {
        return nothing();
    }
    SymmetricEigen::try_new(m, f64::EPSILON, STEPS * n).unwrap_or_else(nothing)
}

/// Inverse of the symmetric matrix `m` with no negative eigenvalues over its own directions: entries are judged at the size of their rows, and
/// directions that are `least` of that or weaker get nothing.
#[must_use]
pub fn pseudo_inverse(m: &DMatrix<f64>, least: f64) -> DMatrix<f64> {
    let n = m.nrows();
    let scale: Vec<f64> = (0..n).map(|i| if m[(i, i)] > 0.0 { m[(i, i)].sqrt().recip() } else { 0.0 }).collect();
    let eigen = of_symmetric(DMatrix::from_fn(n, n, |i, j| m[(i, j)] * scale[i] * scale[j]));
    let largest = eigen.eigenvalues.amax();
    let mut inverse = DMatrix::zeros(n, n);
    for (k, value) in eigen.eigenvalues.iter().enumerate() {
        if *value > least * largest {
            let vector = eigen.eigenvectors.column(k);
            inverse.ger(value.recip(), &vector, &vector, 1.0);
        }
    }
    DMatrix::from_fn(n, n, |i, j| inverse[(i, j)] * scale[i] * scale[j])
}

#[cfg(test)]
mod tests {
    use super::{of_symmetric, pseudo_inverse};
    use nalgebra::DMatrix;

    #[test]
    fn what_is_no_number_says_nothing_and_ends() {
        for bad in [f64::NAN, f64::INFINITY] {
            let m = DMatrix::from_row_slice(3, 3, &[1.0, bad, 0.0, bad, 2.0, 0.5, 0.0, 0.5, 3.0]);
            assert!(of_symmetric(m.clone()).eigenvalues.iter().all(|e| *e == 0.0));
            assert!(pseudo_inverse(&m, 1e-12).iter().all(|e| *e == 0.0));
        }
        // entries whose squares are beyond the largest number
        let huge = DMatrix::from_row_slice(2, 2, &[1e300, 5e299, 5e299, 1e300]);
        assert!((of_symmetric(huge).eigenvalues.max() / 1.5e300 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn rows_of_very_different_size_are_told_and_a_dead_one_is_left_out() {
        let m = DMatrix::from_row_slice(3, 3, &[1e12, 1.0, 0.0, 1.0, 1e-10, 0.0, 0.0, 0.0, 0.0]);
        let inverse = pseudo_inverse(&m, 1e-12);
        let product = &m * &inverse;
        for (i, row) in product.row_iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                let wanted = if i == j && i < 2 { 1.0 } else { 0.0 };
                let size = (m[(i, i)] / m[(j, j)].max(f64::MIN_POSITIVE)).sqrt().max(1.0);
                assert!((value - wanted).abs() < 1e-12 * size.min(1e12), "({i}, {j}): {value}");
            }
        }
    }
}
