//! Diagonal scaling of states (powers of two, so that nothing is rounded): of a matrix, and of a Riccati equation.
//!
//! Osborne's method: rows and columns of the (Hamiltonian) matrix are made equally large. Knows matrices only.

use nalgebra::DMatrix;

const SWEEPS: usize = 12;

/// d with D^-1 A D balanced (length n).
pub(crate) fn state_scaling(a: &DMatrix<f64>) -> Vec<f64> {
    let zero = DMatrix::zeros(a.nrows(), a.ncols());
    riccati_scaling(a, &zero, &zero)
}

/// D^-1 A D.
pub(crate) fn scaled(a: &DMatrix<f64>, d: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| a[(i, j)] / d[i] * d[j])
}

/// d that balances the Hamiltonian [A, G; Q, A^T] by diag(D, D^-1): A -> D^-1 A D, G -> D^-1 G D^-1, Q -> D Q D.
pub(crate) fn riccati_scaling(a: &DMatrix<f64>, g: &DMatrix<f64>, q: &DMatrix<f64>) -> Vec<f64> {
    let n = a.nrows();
    let mut d = vec![1.0_f64; n];
    for _ in 0..SWEEPS {
        let mut changed = false;
        for i in 0..n {
            let (mut row, mut column) = (0.0, 0.0);
            for j in 0..n {
                if j != i {
                    row += (a[(i, j)] * d[j] / d[i]).abs();
                    column += (a[(j, i)] * d[i] / d[j]).abs();
                }
                row += (g[(i, j)] / d[i] / d[j]).abs();
                column += (q[(i, j)] * d[i] * d[j]).abs();
            }
            if !(row > 0.0 && column > 0.0 && row.is_finite() && column.is_finite()) {
                continue;
            }
            let factor = (0.5 * (row / column).log2()).round().exp2();
            if factor != 1.0 && column * factor + row / factor < 0.95 * (row + column) && (1e-60..1e60).contains(&(d[i] * factor)) {
                d[i] *= factor;
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    d
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_badly_scaled_matrix_comes_out_even() {
        let a = DMatrix::from_row_slice(3, 3, &[1.0, 1e6, 0.0, 1e-6, 2.0, 1e4, 0.0, 1e-4, 3.0]);
        let b = scaled(&a, &state_scaling(&a));
        assert!(b.amax() < 10.0, "{b}");
    }
}
