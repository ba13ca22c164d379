//! Which columns of a matrix are independent, and what the others are made of.
//!
//! Columns are taken in order (Gram-Schmidt, each column twice against what was kept), so that a later column is told
//! over earlier ones: the order is the choice of the base (Gautier, Numerical calculation of the base inertial
//! parameters of robots, J. Robotic Systems 8(4), 1991).

use nalgebra::{DMatrix, DVector};

/// Columns sorted out.
pub struct Columns {
    /// Independent ones, in order.
    pub kept: Vec<usize>,
    /// Columns of zeros.
    pub dead: Vec<usize>,
    /// Dependent ones: the column, and (place in `kept`, coefficient).
    pub dependent: Vec<(usize, Vec<(usize, f64)>)>,
    /// Smallest part of a kept column that is new, relative to the column.
    pub least_kept: f64,
    /// Largest part of a dependent column that is new: rounding.
    pub most_dropped: f64,
}

/// Sorts the columns out; a column whose new part is below `tolerance` of its length is dependent.
pub fn columns(w: &DMatrix<f64>, tolerance: f64) -> Columns {
    let lengths: Vec<f64> = w.column_iter().map(|c| c.norm()).collect();
    let largest = lengths.iter().copied().fold(0.0, f64::max);
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut out = Columns { kept: Vec::new(), dead: Vec::new(), dependent: Vec::new(), least_kept: 1.0, most_dropped: 0.0 };
    let mut dependent = Vec::new();
    for (j, &length) in lengths.iter().enumerate() {
        if length <= f64::EPSILON * largest {
            out.dead.push(j);
            continue;
        }
        let mut rest: DVector<f64> = w.column(j) / length;
        for _ in 0..2 {
            for b in &basis {
                let along = b.dot(&rest);
                rest.axpy(-along, b, 1.0);
            }
        }
        let new = rest.norm();
        if new > tolerance {
            out.least_kept = out.least_kept.min(new);
            basis.push(rest / new);
            out.kept.push(j);
        } else {
            out.most_dropped = out.most_dropped.max(new);
            dependent.push(j);
        }
    }
    if dependent.is_empty() {
        return out;
    }
    // columns of one length keep the triangle well conditioned
    let kept = DMatrix::from_fn(w.nrows(), out.kept.len(), |i, k| w[(i, out.kept[k])] / lengths[out.kept[k]]);
    let qr = kept.qr();
    for j in dependent {
        let right = qr.q().transpose() * w.column(j);
        let Some(weights) = qr.r().solve_upper_triangular(&right) else { continue };
        let terms = weights.iter().enumerate().map(|(k, &x)| (k, x / lengths[out.kept[k]])).collect();
        out.dependent.push((j, cleaned(terms, &lengths, &out.kept, lengths[j])));
    }
    out
}

/// Without what is rounding; ratios of small whole numbers as such.
fn cleaned(terms: Vec<(usize, f64)>, lengths: &[f64], kept: &[usize], length: f64) -> Vec<(usize, f64)> {
    terms
        .into_iter()
        .filter(|&(k, x)| x.abs() * lengths[kept[k]] > 1e-8 * length)
        .map(|(k, x)| {
            let ratio = (1..=12).map(|q| (x * f64::from(q)).round() / f64::from(q)).find(|r| (r - x).abs() < 1e-8 * x.abs());
            (k, ratio.unwrap_or(x))
        })
        .collect()
}

/// Rank by singular values relative to the largest.
pub fn rank(m: &DMatrix<f64>, tolerance: f64) -> usize {
    if m.is_empty() {
        return 0;
    }
    let s = m.singular_values();
    let largest = s.max();
    s.iter().filter(|&&x| largest > 0.0 && x > tolerance * largest).count()
}
