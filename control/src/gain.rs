//! A feedback gain by the names of what it multiplies: designed, or given.

use crate::lqr::Lqr;
use nalgebra::DMatrix;
use std::fmt;

/// u = u* - K (x - x*), with integrals behind the states.
#[derive(Clone, Debug, PartialEq)]
pub struct Gain {
    /// Columns of K: `y`, `y.dot`, `y.integral`, or another state of the model (which needs an estimator).
    pub states: Vec<String>,
    /// Rows of K.
    pub inputs: Vec<String>,
    /// K (inputs x states).
    pub k: DMatrix<f64>,
    /// Anti-windup gain L (integrals x inputs) of z' = y - y* + L (u_applied - u_asked).
    pub anti_windup: DMatrix<f64>,
    /// Period that it was designed for [s], if any.
    pub period: Option<f64>,
}

/// What is wrong with a given gain.
#[derive(Clone, Debug, PartialEq)]
pub enum GainError {
    /// Not one row for each input.
    Rows {
        /// Rows.
        found: usize,
        /// Inputs.
        inputs: Vec<String>,
    },
    /// A row has not one entry for each state.
    Columns {
        /// The input of the row.
        input: String,
        /// Entries.
        found: usize,
        /// States.
        states: Vec<String>,
    },
    /// An entry, or the time constant of the anti-windup, is not finite (or not positive).
    Value {
        /// What.
        what: String,
    },
}

impl fmt::Display for GainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rows { found, inputs } => {
                write!(f, "the gain has {found} rows for {} inputs: one is needed for each of {}", inputs.len(), inputs.join(", "))
            }
            Self::Columns { input, found, states } => write!(
                f,
                "the gain's row of {input} has {found} entries for {} states: one is needed for each of {}",
                states.len(),
                states.join(", ")
            ),
            Self::Value { what } => write!(f, "{what} makes no sense in a gain"),
        }
    }
}

impl std::error::Error for GainError {}

impl From<&Lqr> for Gain {
    fn from(lqr: &Lqr) -> Self {
        Self {
            states: lqr.states.clone(),
            inputs: lqr.inputs.clone(),
            k: lqr.k.clone(),
            anti_windup: lqr.anti_windup.clone(),
            period: lqr.period,
        }
    }
}

impl Gain {
    /// A gain as it is given, row by row; integrals (`y.integral`) follow the limits with the time constant
    /// `tracking_time` [s].
    ///
    /// # Errors
    /// [`GainError`], one variant a cause.
    pub fn given(states: Vec<String>, inputs: Vec<String>, rows: &[Vec<f64>], tracking_time: f64) -> Result<Self, GainError> {
        if rows.len() != inputs.len() {
            return Err(GainError::Rows { found: rows.len(), inputs });
        }
        if let Some(i) = rows.iter().position(|row| row.len() != states.len()) {
            return Err(GainError::Columns { input: inputs[i].clone(), found: rows[i].len(), states });
        }
        if let Some(x) = rows.iter().flatten().find(|x| !x.is_finite()) {
            return Err(GainError::Value { what: format!("the entry {x}") });
        }
        if !(tracking_time > 0.0 && tracking_time.is_finite()) {
            return Err(GainError::Value { what: format!("a tracking time of {tracking_time} s") });
        }
        let k = DMatrix::from_fn(inputs.len(), states.len(), |i, j| rows[i][j]);
        let integrals: Vec<usize> = (0..states.len()).filter(|&j| states[j].ends_with(".integral")).collect();
        let k_i = DMatrix::from_fn(inputs.len(), integrals.len(), |i, j| k[(i, integrals[j])]);
        Ok(Self { anti_windup: back_calculation(&k_i, tracking_time), states, inputs, k, period: None })
    }
}

/// L = -K_i^+ / tracking_time: makes z' = .. - z / tracking_time while the inputs are held by their limits.
pub(crate) fn back_calculation(k_i: &DMatrix<f64>, tracking_time: f64) -> DMatrix<f64> {
    let (inputs, integrals) = k_i.shape();
    if integrals == 0 {
        return DMatrix::zeros(0, inputs);
    }
    let floor = 1e-10 * k_i.norm();
    k_i.clone().pseudo_inverse(floor).map_or_else(|_| DMatrix::zeros(integrals, inputs), |m| m / tracking_time) * -1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_given_gain_is_checked_in_the_users_words() {
        let names = |list: &[&str]| list.iter().map(|&s| s.to_owned()).collect::<Vec<_>>();
        let say = |rows: &[Vec<f64>], time: f64| Gain::given(names(&["x", "x.dot"]), names(&["F"]), rows, time).unwrap_err().to_string();
        assert_eq!(say(&[], 1.0), "the gain has 0 rows for 1 inputs: one is needed for each of F");
        assert_eq!(say(&[vec![1.0]], 1.0), "the gain's row of F has 1 entries for 2 states: one is needed for each of x, x.dot");
        assert_eq!(say(&[vec![1.0, f64::NAN]], 1.0), "the entry NaN makes no sense in a gain");
        assert_eq!(say(&[vec![1.0, 2.0]], 0.0), "a tracking time of 0 s makes no sense in a gain");
    }

    #[test]
    fn integrals_of_a_given_gain_follow_the_limits() {
        let names = |list: &[&str]| list.iter().map(|&s| s.to_owned()).collect::<Vec<_>>();
        let gain = Gain::given(names(&["x", "x.integral"]), names(&["F"]), &[vec![3.0, 2.0]], 0.5).unwrap();
        assert!((gain.anti_windup[(0, 0)] + 1.0).abs() < 1e-15);
    }
}
