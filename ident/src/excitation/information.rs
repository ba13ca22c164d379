//! What a record of an input would tell: standard errors from the sensitivities of the outputs along the run.

use super::ExciteError;
use crate::spectrum::of_symmetric;
use nalgebra::DMatrix;
use runtime::Model;
use sim::{FixedMethod, Forward, Pattern, Signals, Status};

/// What is foretold of one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Predicted {
    /// Parameter.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Value that the run was simulated with.
    pub value: f64,
    /// Standard error; `None` where the record would not tell it.
    pub std_error: Option<f64>,
}

/// Noise of an output without an encoder, as a part of its spread.
const NOISE: f64 = 1e-3;
/// Eigenvalues of the scaled information below this part of the largest one are directions that nothing tells.
const TOLD: f64 = 1e-12;

/// Standard errors of the parameters `free` from outputs along a run from `x0`, coordinates and rates of which are unknown
/// too. Errors are white: a step of the encoder over sqrt 12.
///
/// # Errors
/// [`ExciteError::Simulation`].
pub fn predict(
    model: &dyn Model,
    p: &[f64],
    free: &[usize],
    x0: &[f64],
    signals: &Signals,
    t: &[f64],
) -> Result<Vec<Predicted>, ExciteError> {
    let d = model.dimensions();
    let states = d.states();
    let others = 2 * d.coordinates;
    let columns = free.len() + others;
    let outputs: Vec<usize> = (0..d.outputs).collect();
    let period = t.last().copied().unwrap_or(1.0) / (t.len().max(2) - 1) as f64;
    let pattern = Pattern { method: FixedMethod::Classical, step: 0.5 * period };
    let mut forward = Forward::new(model, signals, t, &outputs, free, others, pattern).map_err(ExciteError::Simulation)?;
    let mut s0 = vec![0.0; states * columns];
    for i in 0..others {
        s0[i * columns + free.len() + i] = 1.0;
    }
    let mut rows: Vec<(usize, f64, Vec<f64>)> = Vec::with_capacity(t.len() * d.outputs);
    let status = forward.run(p, x0, &s0, &mut |_, i, y, dy| rows.push((i, y, dy.to_vec()))).map_err(ExciteError::Simulation)?;
    let sigma: Vec<f64> = (0..d.outputs)
        .map(|i| {
            let quantum = model.output_path(i, p).quantum;
            if quantum > 0.0 {
                return quantum / 12.0_f64.sqrt();
            }
            let values: Vec<f64> = rows.iter().filter(|r| r.0 == i).map(|r| r.1).collect();
            let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
            NOISE * (values.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / values.len().max(1) as f64).sqrt()
        })
        .collect();
    let mut information = DMatrix::<f64>::zeros(columns, columns);
    for (i, _, dy) in &rows {
        let w = if sigma[*i] > 0.0 { 1.0 / (sigma[*i] * sigma[*i]) } else { 0.0 };
        for a in 0..columns {
            for b in 0..columns {
                information[(a, b)] += w * dy[a] * dy[b];
            }
        }
    }
    let errors = if status == Status::Completed { standard_errors(&information) } else { vec![None; columns] };
    Ok(free
        .iter()
        .zip(errors)
        .map(|(&i, std_error)| Predicted {
            name: model.names().parameter(i).to_owned(),
            unit: model.names().parameter_unit(i).to_owned(),
            value: p[i],
            std_error,
        })
        .collect())
}

/// Square roots of the diagonal of the inverse, where the direction is told.
fn standard_errors(information: &DMatrix<f64>) -> Vec<Option<f64>> {
    let n = information.nrows();
    let scale: Vec<f64> = (0..n).map(|i| information[(i, i)].sqrt()).collect();
    let unit = |i: usize| if scale[i] > 0.0 { 1.0 / scale[i] } else { 0.0 };
    let scaled = DMatrix::from_fn(n, n, |i, j| information[(i, j)] * unit(i) * unit(j));
    let eigen = of_symmetric(scaled);
    let least = TOLD * eigen.eigenvalues.max();
    (0..n)
        .map(|i| {
            if scale[i] == 0.0 || !scale[i].is_finite() {
                return None;
            }
            let mut sum = 0.0;
            for k in 0..n {
                let (v, l) = (eigen.eigenvectors[(i, k)], eigen.eigenvalues[k]);
                if l > least {
                    sum += v * v / l;
                } else if v * v > 1e-6 {
                    return None;
                }
            }
            Some(sum.sqrt() / scale[i])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::standard_errors;
    use nalgebra::DMatrix;

    #[test]
    fn of_a_straight_line_and_of_what_is_not_told() {
        // y = a + b t at t = 0..4, and a column without effect
        let rows: Vec<[f64; 3]> = (0..5).map(|t| [1.0, f64::from(t), 0.0]).collect();
        let information = DMatrix::from_fn(3, 3, |i, j| rows.iter().map(|r| r[i] * r[j]).sum());
        let found = standard_errors(&information);
        assert!((found[0].unwrap() - 0.6_f64.sqrt()).abs() < 1e-12 && (found[1].unwrap() - 0.1_f64.sqrt()).abs() < 1e-12);
        assert_eq!(found[2], None);
        // two columns that do the same
        let twice = DMatrix::from_fn(2, 2, |_, _| 5.0);
        assert_eq!(standard_errors(&twice), [None, None]);
    }
}
