//! Weights of a quadratic cost as a user gives them, checked in the user's words.

use nalgebra::DMatrix;
use std::fmt;

/// A weight: its diagonal, or the whole symmetric matrix.
#[derive(Clone, Debug, PartialEq)]
pub enum Weight {
    /// One value for each state or input.
    Diagonal(Vec<f64>),
    /// Rows and columns in the order of the states or inputs.
    Full(DMatrix<f64>),
}

/// What a weight belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weighted {
    /// Q: positive semidefinite.
    States,
    /// R: positive definite.
    Inputs,
}

impl Weighted {
    const fn noun(self) -> &'static str {
        match self {
            Self::States => "states",
            Self::Inputs => "inputs",
        }
    }
}

/// What is wrong with a weight.
#[derive(Clone, Debug, PartialEq)]
pub enum WeightError {
    /// Not one value for each.
    Length {
        /// Whose.
        of: Weighted,
        /// How many values were given.
        found: usize,
        /// What they are for.
        names: Vec<String>,
    },
    /// A value that is not a number.
    NotFinite {
        /// Whose.
        of: Weighted,
        /// Which.
        name: String,
    },
    /// A negative weight, or a zero one on an input.
    Sign {
        /// Whose.
        of: Weighted,
        /// Which.
        name: String,
        /// Its value.
        value: f64,
    },
    /// Two entries that should be equal are not.
    NotSymmetric {
        /// Whose.
        of: Weighted,
        /// Row and column.
        names: (String, String),
    },
    /// The matrix rewards some combination.
    Indefinite {
        /// Whose.
        of: Weighted,
        /// Smallest eigenvalue.
        eigenvalue: f64,
        /// The combination.
        combination: String,
    },
}

impl fmt::Display for WeightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { of, found, names } => {
                let s = if *found == 1 { "" } else { "s" };
                write!(f, "{found} weight{s} for {} {}: one is needed for each of {}", names.len(), of.noun(), names.join(", "))
            }
            Self::NotFinite { of, name } => write!(f, "the weight of {name} (among the {}) is not a finite number", of.noun()),
            Self::Sign { of: Weighted::States, name, value } => write!(f, "the weight of {name} is {value}; a weight must not be negative"),
            Self::Sign { of: Weighted::Inputs, name, value } => {
                write!(f, "the weight of the input {name} is {value}; every input must cost something")
            }
            Self::NotSymmetric { of, names: (i, j) } => write!(f, "the weight of the {} is not symmetric in {i} and {j}", of.noun()),
            Self::Indefinite { of, eigenvalue, combination } => {
                write!(
                    f,
                    "the weight of the {} rewards a combination of {combination} (eigenvalue {eigenvalue:.3e}); it must not have negative eigenvalues",
                    of.noun()
                )
            }
        }
    }
}

impl std::error::Error for WeightError {}

impl Weight {
    /// The matrix (n x n for n names), checked.
    ///
    /// # Errors
    /// [`WeightError`], one variant a cause.
    pub fn matrix(&self, of: Weighted, names: &[String]) -> Result<DMatrix<f64>, WeightError> {
        let n = names.len();
        let m = match self {
            Self::Diagonal(values) if values.len() == n => DMatrix::from_fn(n, n, |i, j| if i == j { values[i] } else { 0.0 }),
            Self::Full(m) if m.shape() == (n, n) => m.clone(),
            Self::Diagonal(values) => return Err(WeightError::Length { of, found: values.len(), names: names.to_vec() }),
            Self::Full(m) => return Err(WeightError::Length { of, found: m.nrows().max(m.ncols()), names: names.to_vec() }),
        };
        for i in 0..n {
            if m.row(i).iter().any(|x| !x.is_finite()) {
                return Err(WeightError::NotFinite { of, name: names[i].clone() });
            }
            let value = m[(i, i)];
            if value < 0.0 || (value == 0.0 && of == Weighted::Inputs) {
                return Err(WeightError::Sign { of, name: names[i].clone(), value });
            }
        }
        if let Some((i, j)) = crate::riccati::asymmetry(&m) {
            return Err(WeightError::NotSymmetric { of, names: (names[i].clone(), names[j].clone()) });
        }
        let eigen = m.clone().symmetric_eigen();
        if n > 0 {
            let (k, least) = eigen.eigenvalues.argmin();
            let floor = 1e-13 * eigen.eigenvalues.amax();
            if least < -floor || (of == Weighted::Inputs && least <= floor) {
                let column: Vec<f64> = eigen.eigenvectors.column(k).iter().copied().collect();
                return Err(WeightError::Indefinite { of, eigenvalue: least, combination: crate::modes::who(&column, names) });
            }
        }
        Ok(m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    #[test]
    fn messages_speak_of_names() {
        let names = ["eps".to_owned(), "eps.dot".to_owned()];
        let say = |w: Weight, of| w.matrix(of, &names).unwrap_err().to_string();
        assert_eq!(say(Weight::Diagonal(vec![1.0]), Weighted::States), "1 weight for 2 states: one is needed for each of eps, eps.dot");
        assert_eq!(say(Weight::Diagonal(vec![1.0, -2.0]), Weighted::States), "the weight of eps.dot is -2; a weight must not be negative");
        assert_eq!(
            say(Weight::Diagonal(vec![0.0, 2.0]), Weighted::Inputs),
            "the weight of the input eps is 0; every input must cost something"
        );
        assert_eq!(
            say(Weight::Full(dmatrix![1.0, 0.5; 0.2, 1.0]), Weighted::States),
            "the weight of the states is not symmetric in eps and eps.dot"
        );
        assert_eq!(
            say(Weight::Full(dmatrix![1.0, 2.0; 2.0, 1.0]), Weighted::States),
            "the weight of the states rewards a combination of eps, eps.dot (eigenvalue -1.000e0); it must not have negative eigenvalues"
        );
        assert!(Weight::Diagonal(vec![0.0, 0.0]).matrix(Weighted::States, &names).is_ok());
    }
}
