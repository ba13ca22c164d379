//! A rig on the test bench: model in the process, named trims, linear models along named inputs.

use codegen::{Direction, Options, derive, direction_by_name, operating_points};
use control::{LinearModel, Plant, Trim, TrimProblem};
use jit::InProcess;
use model_dsl::rig::Rig;
use nalgebra::DMatrix;
use runtime::Model;

/// A rig with its model and parameters.
pub struct Bench {
    /// The checked rig.
    pub rig: Rig,
    /// Its model.
    pub model: InProcess,
    /// Parameters.
    pub p: Vec<f64>,
}

impl Bench {
    /// An example rig by the name of its file, with parameters overridden (SI).
    ///
    /// # Panics
    /// Where the rig is wrong or has no such parameter: this is for tests.
    #[must_use]
    pub fn new(name: &str, set: &[(&str, f64)]) -> Self {
        let rig = crate::rig_of(&crate::root().join(format!("examples/rigs/{name}.rig")));
        let model = InProcess::new(derive(&rig, Options::default()).unwrap_or_else(|e| panic!("{name}: {e}")));
        let mut p = vec![0.0; model.dimensions().parameters];
        model.nominal(&mut p);
        for (parameter, value) in set {
            let i = (0..p.len()).find(|&i| model.names().parameter(i) == *parameter).unwrap_or_else(|| panic!("no parameter {parameter}"));
            p[i] = *value;
        }
        Self { rig, model, p }
    }

    /// The direction of a state, signal or mixed input.
    ///
    /// # Panics
    /// Where there is none of this name.
    #[must_use]
    pub fn direction(&self, name: &str) -> Direction {
        direction_by_name(&self.rig, &self.model.equations().layout, name).unwrap_or_else(|| panic!("no {name}"))
    }

    /// A named trim as a problem, with quantities held at other values than declared.
    ///
    /// # Panics
    /// Where the rig has no such trim.
    #[must_use]
    pub fn trim_problem(&self, trim: &str, at: &[(&str, f64)]) -> TrimProblem {
        let e = self.model.equations();
        let points = operating_points(&self.rig, &e.layout, e.lumps);
        let mut point = points.into_iter().find(|t| t.name == trim).unwrap_or_else(|| panic!("no trim {trim}"));
        for (name, value) in at {
            let direction = self.direction(name);
            point.held.retain(|(d, _)| !d.overlaps(&direction));
            point.held.push((direction, *value));
        }
        crate::trims::problem(point, &e.layout)
    }

    /// A named trim, solved.
    ///
    /// # Panics
    /// Where there is no operating point.
    #[must_use]
    pub fn trim(&self, trim: &str, at: &[(&str, f64)]) -> Trim {
        control::solve(&self.model, &self.p, &self.trim_problem(trim, at)).unwrap_or_else(|e| panic!("{trim}: {e}"))
    }

    /// How the signals move with each of the named inputs (signals x inputs).
    #[must_use]
    pub fn directions(&self, inputs: &[&str]) -> DMatrix<f64> {
        let mut m = DMatrix::zeros(self.model.dimensions().signals(), inputs.len());
        for (j, name) in inputs.iter().enumerate() {
            for (i, weight) in self.direction(name).signals {
                m[(i, j)] = weight;
            }
        }
        m
    }

    /// Linear model along the named inputs.
    ///
    /// # Panics
    /// Where there is none.
    #[must_use]
    pub fn linear(&self, trim: &Trim, inputs: &[&str]) -> LinearModel {
        control::linearize(&self.model, &self.p, &trim.x, &self.directions(inputs), |dx, a, b| {
            self.model.linearize_without_friction_slope(0.0, &trim.x, &trim.u, &self.p, dx, a, b)
        })
        .unwrap_or_else(|e| panic!("{e}"))
    }

    /// The linear model with names.
    #[must_use]
    pub fn plant(&self, trim: &Trim, inputs: &[&str]) -> Plant {
        let inputs_owned: Vec<String> = inputs.iter().map(|&s| s.to_owned()).collect();
        Plant::new(&self.model, &self.linear(trim, inputs), &inputs_owned)
    }
}
