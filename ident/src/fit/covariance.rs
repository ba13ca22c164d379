//! Covariance of the estimates where the errors are coloured.
//!
//! With scores s_t (gradient of the cost of one time) and H the Gauss-Newton matrix, cov = H^-1 B H^-1, where B is the
//! long-run covariance of the scores: Bartlett kernel (W. K. Newey, K. D. West, Econometrica 55, 1987), bandwidth by
//! Andrews' rule (Econometrica 59, 1991), scores pre-whitened by a first-order autoregression each (D. W. K. Andrews,
//! J. C. Monahan, Econometrica 60, 1992). Where the bandwidth is not small against the record, the factor of the 95 %
//! interval grows after N. M. Kiefer and T. J. Vogelsang (Econometric Theory 21, 2005).

use super::objective::Rows;
use crate::spectrum::of_symmetric;
use nalgebra::{DMatrix, DVector};

/// In one line, for tables and JSON.
pub(crate) const SOURCE: &str = "Newey-West (Bartlett kernel, pre-whitened scores, Andrews' bandwidth), factor by Kiefer and Vogelsang";

/// Largest autoregression coefficient that is used for whitening.
const MOST_COLOURED: f64 = 0.97;

/// Covariance of the unknowns.
#[derive(Clone, Debug)]
pub(crate) struct Covariance {
    /// Of all unknowns; rows of those that are held or not told are zero.
    pub matrix: DMatrix<f64>,
    /// Unknowns whose errors are known.
    pub told: Vec<bool>,
    /// Half width of the 95 % interval in standard errors.
    pub factor: f64,
    /// Samples whose errors count as one: the length over which errors hang together.
    pub memory: f64,
    /// Variance over that of independent errors of unit variance, median over the unknowns.
    pub inflation: f64,
}

/// What `normal` has beyond the rows are priors; `held` unknowns stand at a bound.
pub(crate) fn covariance(rows: &[Rows], normal: &DMatrix<f64>, held: &[bool]) -> Covariance {
    let n = normal.nrows();
    let (inverse, told) = inverse(normal, held);
    // influence of each time on the estimates
    let series: Vec<DMatrix<f64>> = rows.iter().map(|r| influence(r, &inverse)).collect();
    let samples: usize = rows.iter().map(|r| r.times.len()).sum();
    let open: Vec<usize> = (0..n).filter(|&i| told[i]).collect();

    // first-order colour of each component, over all pieces
    let mut rho = vec![0.0; n];
    for &i in &open {
        let (mut now, mut lagged) = (0.0, 0.0);
        for s in &series {
            let row = s.row(i);
            now += row.iter().map(|v| v * v).sum::<f64>();
            lagged += row.iter().zip(row.iter().skip(1)).map(|(a, b)| a * b).sum::<f64>();
        }
        rho[i] = if now > 0.0 { (lagged / now).clamp(-MOST_COLOURED, MOST_COLOURED) } else { 0.0 };
    }
    let whitened: Vec<DMatrix<f64>> = series
        .iter()
        .map(|s| DMatrix::from_fn(n, s.ncols(), |i, t| s[(i, t)] - if t > 0 { rho[i] * s[(i, t - 1)] } else { 0.0 }))
        .collect();
    let bandwidth = bandwidth(&whitened, &open, samples);
    let mut middle = DMatrix::zeros(n, n);
    for s in &whitened {
        add_bartlett(s, bandwidth, &mut middle);
    }
    for i in 0..n {
        for j in 0..n {
            middle[(i, j)] /= (1.0 - rho[i]) * (1.0 - rho[j]);
        }
    }
    // estimated from the same samples that they were fitted to
    let unknowns = open.len() as f64;
    let rest = samples as f64 * rows.iter().map(|r| r.outputs).max().unwrap_or(1) as f64;
    middle *= rest / (rest - unknowns).max(1.0);
    // priors are observations of unit variance
    let by_priors = &inverse * (normal - of_rows(rows, n)) * &inverse;
    let matrix = middle + by_priors;
    let colour = open.iter().map(|&i| (1.0 + rho[i]) / (1.0 - rho[i])).fold(1.0, f64::max);
    let memory = bandwidth as f64 + colour - 1.0;
    let b = (memory / samples.max(1) as f64).min(1.0);
    let factor = 1.96 + 2.9694 * b + 0.4160 * b * b - 0.5324 * b * b * b;
    let mut ratios: Vec<f64> = open.iter().filter(|&&i| inverse[(i, i)] > 0.0).map(|&i| matrix[(i, i)] / inverse[(i, i)]).collect();
    ratios.sort_by(f64::total_cmp);
    let inflation = ratios.get(ratios.len() / 2).copied().unwrap_or(1.0);
    Covariance { matrix, told, factor, memory, inflation }
}

/// J^T J of the rows.
fn of_rows(rows: &[Rows], n: usize) -> DMatrix<f64> {
    let mut total = DMatrix::zeros(n, n);
    for rows in rows {
        let m = rows.columns.len();
        let mut local = vec![0.0; m * m];
        for (slope, j) in rows.slopes.iter().zip(rows.jacobian.chunks_exact(m.max(1))) {
            for (a, ja) in j.iter().enumerate() {
                let scaled = slope * ja;
                local[a * m + a..(a + 1) * m].iter_mut().zip(&j[a..]).for_each(|(n, j)| *n += scaled * j);
            }
        }
        for (a, &i) in rows.columns.iter().enumerate() {
            for (b, &j) in rows.columns.iter().enumerate() {
                total[(i, j)] += local[a.min(b) * m + a.max(b)];
            }
        }
    }
    total
}

/// H^-1 over the unknowns that are not held, without the directions in which H vanishes; and which unknowns have no part
/// in those.
fn inverse(normal: &DMatrix<f64>, held: &[bool]) -> (DMatrix<f64>, Vec<bool>) {
    let n = normal.nrows();
    let open: Vec<usize> = (0..n).filter(|&i| !held[i] && normal[(i, i)] > 0.0).collect();
    let scale: Vec<f64> = open.iter().map(|&i| normal[(i, i)].sqrt()).collect();
    let m = DMatrix::from_fn(open.len(), open.len(), |a, b| normal[(open[a], open[b])] / (scale[a] * scale[b]));
    let eigen = of_symmetric(m);
    let least = 1e-13 * open.len() as f64;
    let mut told = vec![false; n];
    let mut out = DMatrix::zeros(n, n);
    for (a, &i) in open.iter().enumerate() {
        told[i] = (0..open.len()).all(|k| eigen.eigenvalues[k] > least || eigen.eigenvectors[(a, k)].abs() < 1e-3);
        for (b, &j) in open.iter().enumerate() {
            out[(i, j)] = (0..open.len())
                .filter(|&k| eigen.eigenvalues[k] > least)
                .map(|k| eigen.eigenvectors[(a, k)] * eigen.eigenvectors[(b, k)] / eigen.eigenvalues[k])
                .sum::<f64>()
                / (scale[a] * scale[b]);
        }
    }
    (out, told)
}

/// H^-1 s_t, unknowns x times.
fn influence(rows: &Rows, inverse: &DMatrix<f64>) -> DMatrix<f64> {
    let (n, m) = (inverse.nrows(), rows.columns.len());
    // columns of H^-1 in the piece's order
    let local = DMatrix::from_fn(n, m, |i, c| inverse[(i, rows.columns[c])]);
    let mut out = DMatrix::zeros(n, rows.times.len());
    let mut score = DVector::zeros(m);
    for (t, mut column) in out.column_iter_mut().enumerate() {
        score.fill(0.0);
        for i in 0..rows.outputs {
            let at = t * rows.outputs + i;
            let weighted = rows.slopes[at] * rows.errors[at];
            score.iter_mut().zip(&rows.jacobian[at * m..(at + 1) * m]).for_each(|(s, j)| *s += weighted * j);
        }
        column.gemv(1.0, &local, &score, 0.0);
    }
    out
}

/// Andrews' rule for the Bartlett kernel and first-order colour, all components counting alike.
fn bandwidth(series: &[DMatrix<f64>], open: &[usize], samples: usize) -> usize {
    let (mut above, mut below) = (0.0, 0.0);
    for &i in open {
        let (mut now, mut lagged) = (0.0, 0.0);
        for s in series {
            let row = s.row(i);
            now += row.iter().map(|v| v * v).sum::<f64>();
            lagged += row.iter().zip(row.iter().skip(1)).map(|(a, b)| a * b).sum::<f64>();
        }
        if now > 0.0 {
            let r: f64 = (lagged / now).clamp(-MOST_COLOURED, MOST_COLOURED);
            // each with unit variance: sigma^2 = 1 - r^2
            let variance = 1.0 - r * r;
            above += 4.0 * r * r * variance * variance / ((1.0 - r).powi(6) * (1.0 + r).powi(2));
            below += variance * variance / (1.0 - r).powi(4);
        }
    }
    let alpha = if below > 0.0 { above / below } else { 0.0 };
    let longest = series.iter().map(DMatrix::ncols).max().unwrap_or(1);
    let rule = 1.1447 * (alpha * samples as f64).powf(1.0 / 3.0);
    (rule.ceil() as usize + 1).clamp(1, (longest / 2).max(1))
}

/// sum over lags l of (1 - |l|/bandwidth) sum_t s_t s_(t+l)^T, as sums over windows: the same number, in one pass.
fn add_bartlett(series: &DMatrix<f64>, bandwidth: usize, total: &mut DMatrix<f64>) {
    let (n, count) = series.shape();
    let mut window = DVector::zeros(n);
    for end in 0..count + bandwidth - 1 {
        if end < count {
            window += series.column(end);
        }
        if end >= bandwidth {
            window -= series.column(end - bandwidth);
        }
        total.ger(1.0 / bandwidth as f64, &window, &window, 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::add_bartlett;
    use nalgebra::DMatrix;

    #[test]
    fn windows_give_the_weighted_sum_over_lags() {
        let (n, count, bandwidth) = (2, 9, 4);
        let s = DMatrix::from_fn(n, count, |i, t| ((3 * t + 5 * i) as f64).sin());
        let mut wanted = DMatrix::zeros(n, n);
        for a in 0..count {
            for b in 0..count {
                let weight = 1.0 - a.abs_diff(b) as f64 / bandwidth as f64;
                if weight > 0.0 {
                    wanted += weight * s.column(a) * s.column(b).transpose();
                }
            }
        }
        let mut found = DMatrix::zeros(n, n);
        add_bartlett(&s, bandwidth, &mut found);
        assert!((found - wanted).amax() < 1e-13);
    }
}
