//! The delay from an input to the motion, by correlation.
//!
//! What the model does not explain with the input held at its mean, q'' - a(q, v, mean u), is correlated with what the input
//! would add, (da/du)(u(t - d) - mean u), over d. Parts of either that a constant, the coordinates, their rates and the signs
//! of these explain are taken out first: wrong springs and frictions look like delays, above all in closed loops. Needs no run and no fit. Inputs that act through a lag are left out: lag and
//! delay cannot be told apart like this.

use crate::fit::{Data, rates};
use runtime::Model;

/// Delay of one input.
#[derive(Clone, Debug, PartialEq)]
pub struct Delay {
    /// Input.
    pub input: String,
    /// Coordinate in which it shows best.
    pub coordinate: String,
    /// Delay beyond the one that the rig declares [s].
    pub seconds: f64,
    /// Correlation there.
    pub correlation: f64,
}

/// Correlations below this say nothing.
const LEAST: f64 = 0.8;
/// Changes of an input below which its delay may be that of something else.
const CHANGES: usize = 10;
/// Equations of which the model leaves more than this unexplained say nothing either (ratio of amplitudes).
pub(super) const EXPLAINED: f64 = 0.4;
/// Longest delay that is looked for [s].
const LONGEST: f64 = 0.5;

/// Delays of the inputs of one record; `q[i]` are the coordinates at its samples, `told` those
/// whose equations the model explains.
pub(super) fn delays(model: &dyn Model, p: &[f64], data: &Data, q: &[Vec<f64>], window: f64, told: &[usize]) -> Vec<Delay> {
    let d = model.dimensions();
    let (n, states, count) = (d.coordinates, d.states(), data.times.len());
    if d.lags > 0 || count < 50 {
        return Vec::new();
    }
    let t = &data.times;
    let period = (t[count - 1] - t[0]) / (count - 1) as f64;
    // short against the motion, so that edges stay where they are; the window is symmetric
    let samples = ((0.3 * window / period) as usize).max(8);
    let v: Vec<Vec<f64>> = q.iter().map(|q| rates(t, q, samples)).collect();
    let a: Vec<Vec<f64>> = v.iter().map(|v| rates(t, v, samples)).collect();
    // at a switch the mean of both sides: a held input is, on the average, half a sample late
    let both = |t: f64| {
        let (after, before) = (data.inputs(model, p, t), data.inputs(model, p, t - 1e-3 * period));
        after.iter().zip(&before).map(|(a, b)| 0.5 * (a + b)).collect::<Vec<f64>>()
    };
    let u: Vec<Vec<f64>> = t.iter().map(|&t| both(t)).collect();
    let mut found = Vec::new();
    for j in 0..d.inputs {
        let mean = u.iter().map(|u| u[j]).sum::<f64>() / count as f64;
        let drive: Vec<f64> = u.iter().map(|u| u[j] - mean).collect();
        let size = drive.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if drive.windows(2).filter(|w| (w[1] - w[0]).abs() > 1e-6 * size).count() < CHANGES {
            continue;
        }
        let mut rest = vec![vec![0.0; count]; n];
        let mut gain = vec![vec![0.0; count]; n];
        let (mut dx, mut jacobian, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * d.signals()]);
        let mut x = vec![0.0; states];
        for k in 0..count {
            for i in 0..n {
                (x[i], x[n + i]) = (q[i][k], v[i][k]);
            }
            let mut held = u[k].clone();
            held[j] = mean;
            if model.linearize(t[k], &x, &held, p, &mut dx, &mut jacobian, &mut b).is_err() {
                return found;
            }
            for i in 0..n {
                rest[i][k] = a[i][k] - dx[n + i];
                gain[i][k] = b[(n + i) * d.signals() + j];
            }
        }
        // twice smoothed as the accelerations are, so that both sides have the same bandwidth
        let smooth = |s: &[f64]| {
            let half = samples / 2;
            let mut sums = vec![0.0];
            s.iter().for_each(|x| sums.push(sums[sums.len() - 1] + x));
            (0..s.len())
                .map(|k| {
                    let (from, to) = (k.saturating_sub(half), (k + half + 1).min(s.len()));
                    (sums[to] - sums[from]) / (to - from) as f64
                })
                .collect::<Vec<f64>>()
        };
        let drive = smooth(&smooth(&drive));
        let reach = ((LONGEST / period) as usize).min(count / 4);
        let basis = basis(q, &v);
        let best = told
            .iter()
            .filter_map(|&i| {
                let mut y = rest[i].clone();
                project_out(&basis, &mut y);
                let at = |shift: usize| {
                    let mut w: Vec<f64> = (0..count).map(|k| gain[i][k] * drive[k.saturating_sub(shift)]).collect();
                    project_out(&basis, &mut w);
                    correlation(&y, &w)
                };
                let values: Vec<f64> = (0..=reach).map(at).collect();
                let k = (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
                // between samples: the vertex of a parabola
                let vertex = match (k.checked_sub(1).map(|l| values[l]), values.get(k + 1)) {
                    (Some(l), Some(r)) if l - 2.0 * values[k] + r < 0.0 => 0.5 * (l - r) / (l - 2.0 * values[k] + r),
                    _ => 0.0,
                };
                Some((i, (k as f64 + vertex) * period, values[k]))
            })
            .max_by(|a, b| a.2.total_cmp(&b.2));
        if let Some((i, seconds, correlation)) = best.filter(|b| b.2 > LEAST) {
            found.push(Delay {
                input: model.names().signal(j).to_owned(),
                coordinate: model.names().state(i).to_owned(),
                seconds: if seconds < period { 0.0 } else { seconds },
                correlation,
            });
        }
    }
    found
}

/// Orthonormal series that span a constant, coordinates, rates and signs of rates.
fn basis(q: &[Vec<f64>], v: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let count = q.first().map_or(0, Vec::len);
    let signs = v.iter().map(|v| {
        let size = v.iter().map(|v| v * v).sum::<f64>().sqrt() / (count as f64).sqrt();
        v.iter().map(|v| (10.0 * v / size.max(f64::MIN_POSITIVE)).tanh()).collect()
    });
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for mut series in std::iter::once(vec![1.0; count]).chain(q.iter().cloned()).chain(v.iter().cloned()).chain(signs) {
        let before = norm(&series);
        project_out(&basis, &mut series);
        let length = norm(&series);
        if length > 1e-9 * before {
            series.iter_mut().for_each(|x| *x /= length);
            basis.push(series);
        }
    }
    basis
}

fn norm(series: &[f64]) -> f64 {
    series.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn project_out(basis: &[Vec<f64>], series: &mut [f64]) {
    for b in basis {
        let along: f64 = b.iter().zip(series.iter()).map(|(b, s)| b * s).sum();
        series.iter_mut().zip(b).for_each(|(s, b)| *s -= along * b);
    }
}

fn correlation(y: &[f64], w: &[f64]) -> f64 {
    let size = norm(y) * norm(w);
    if size > 0.0 { y.iter().zip(w).map(|(y, w)| y * w).sum::<f64>() / size } else { 0.0 }
}
