//! A linear model with the names of its states, inputs and outputs, and parts of it by name.
//!
//! Knows the model trait for the names only.

use crate::linear::LinearModel;
use nalgebra::DMatrix;
use runtime::Model;
use std::fmt;

/// x' = A x + B u, y = C x, as deviations from an operating point.
#[derive(Clone, Debug, PartialEq)]
pub struct Plant {
    /// Names of x (n).
    pub states: Vec<String>,
    /// Names of u (m).
    pub inputs: Vec<String>,
    /// Names of y (p).
    pub outputs: Vec<String>,
    /// n x n.
    pub a: DMatrix<f64>,
    /// n x m.
    pub b: DMatrix<f64>,
    /// p x n.
    pub c: DMatrix<f64>,
}

/// A name that the plant does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NameError {
    /// No such state, input or output.
    Unknown {
        /// `state`, `input`, `output`.
        kind: &'static str,
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<String>,
    },
    /// Named twice.
    Repeated {
        /// `state`, `input`, `output`.
        kind: &'static str,
        /// The name.
        name: String,
    },
}

impl fmt::Display for NameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { kind, name, known } => write!(f, "there is no {kind} `{name}`; the {kind}s are {}", known.join(", ")),
            Self::Repeated { kind, name } => write!(f, "the {kind} `{name}` is named twice"),
        }
    }
}

impl std::error::Error for NameError {}

/// A coupling that a design leaves out: the rate of `onto` depends on `from`.
#[derive(Clone, Debug, PartialEq)]
pub struct Coupling {
    /// State that is kept.
    pub onto: String,
    /// State that is left out.
    pub from: String,
    /// Entry of A.
    pub value: f64,
}

impl Plant {
    /// A model's linear model, `inputs` being the names of its columns of B.
    #[must_use]
    pub fn new(model: &dyn Model, linear: &LinearModel, inputs: &[String]) -> Self {
        let names = model.names();
        Self {
            states: (0..linear.a.nrows()).map(|i| names.state(i).to_owned()).collect(),
            inputs: inputs.to_vec(),
            outputs: (0..linear.c.nrows()).map(|i| names.output(i).to_owned()).collect(),
            a: linear.a.clone(),
            b: linear.b.clone(),
            c: linear.c.clone(),
        }
    }

    /// Indices of states by name.
    ///
    /// # Errors
    /// [`NameError`] where a name is unknown or repeated.
    pub fn states_by_name(&self, names: &[String]) -> Result<Vec<usize>, NameError> {
        indices("state", names, &self.states)
    }

    /// Indices of inputs by name.
    ///
    /// # Errors
    /// [`NameError`] where a name is unknown or repeated.
    pub fn inputs_by_name(&self, names: &[String]) -> Result<Vec<usize>, NameError> {
        indices("input", names, &self.inputs)
    }

    /// The part of the plant with these states; the others stay at their operating values. An output stays if it
    /// depends on kept states only.
    #[must_use]
    pub fn part(&self, keep: &[usize]) -> Self {
        let shown: Vec<usize> =
            (0..self.c.nrows()).filter(|&i| (0..self.states.len()).all(|j| keep.contains(&j) || self.c[(i, j)] == 0.0)).collect();
        Self {
            states: keep.iter().map(|&i| self.states[i].clone()).collect(),
            inputs: self.inputs.clone(),
            outputs: shown.iter().map(|&i| self.outputs[i].clone()).collect(),
            a: DMatrix::from_fn(keep.len(), keep.len(), |i, j| self.a[(keep[i], keep[j])]),
            b: DMatrix::from_fn(keep.len(), self.b.ncols(), |i, j| self.b[(keep[i], j)]),
            c: DMatrix::from_fn(shown.len(), keep.len(), |i, j| self.c[(shown[i], keep[j])]),
        }
    }

    /// Couplings from left-out states onto kept ones: what [`Plant::part`] neglects.
    #[must_use]
    pub fn neglected(&self, keep: &[usize]) -> Vec<Coupling> {
        let left: Vec<usize> = (0..self.states.len()).filter(|i| !keep.contains(i)).collect();
        let coupling =
            |&i: &usize, &j: &usize| Coupling { onto: self.states[i].clone(), from: self.states[j].clone(), value: self.a[(i, j)] };
        keep.iter().flat_map(|i| left.iter().map(move |j| coupling(i, j))).filter(|c| c.value != 0.0).collect()
    }

    /// The row that reads an output, or else a state, by its name (1 x n).
    ///
    /// # Errors
    /// [`NameError::Unknown`], with both lists.
    pub fn reading(&self, name: &str) -> Result<DMatrix<f64>, NameError> {
        if let Some(i) = self.outputs.iter().position(|o| o == name) {
            return Ok(self.c.rows(i, 1).into_owned());
        }
        match self.states.iter().position(|s| s == name) {
            Some(j) => Ok(DMatrix::from_fn(1, self.states.len(), |_, k| f64::from(u8::from(k == j)))),
            None => {
                let mut known = self.outputs.clone();
                known.extend(self.states.iter().filter(|s| !self.outputs.contains(s)).cloned());
                Err(NameError::Unknown { kind: "output", name: name.to_owned(), known })
            }
        }
    }
}

fn indices(kind: &'static str, names: &[String], known: &[String]) -> Result<Vec<usize>, NameError> {
    let mut found = Vec::with_capacity(names.len());
    for name in names {
        let Some(i) = known.iter().position(|k| k == name) else {
            return Err(NameError::Unknown { kind, name: name.clone(), known: known.to_vec() });
        };
        if found.contains(&i) {
            return Err(NameError::Repeated { kind, name: name.clone() });
        }
        found.push(i);
    }
    Ok(found)
}
