//! Equations behind the model trait.

use crate::program::{Arguments, Program};
use codegen::Equations;
use codegen::expr::Id;
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular};
use std::sync::OnceLock;

/// A model evaluated inside the process. Programs are made when they are first used.
pub struct InProcess {
    equations: Equations,
    names: Labels,
    rhs: OnceLock<Program>,
    linear: OnceLock<Program>,
    linear_without_friction_slope: OnceLock<Program>,
    parameters: OnceLock<Program>,
    outputs: OnceLock<Program>,
    output_jacobian: OnceLock<Program>,
    paths: OnceLock<Program>,
    pivots: OnceLock<Program>,
}

struct Labels {
    rig: String,
    states: Vec<String>,
    signals: Vec<(String, String)>,
    parameters: Vec<(String, String)>,
    outputs: Vec<(String, String)>,
}

impl Names for Labels {
    fn rig(&self) -> &str {
        &self.rig
    }
    fn state(&self, i: usize) -> &str {
        &self.states[i]
    }
    fn signal(&self, i: usize) -> &str {
        &self.signals[i].0
    }
    fn signal_unit(&self, i: usize) -> &str {
        &self.signals[i].1
    }
    fn parameter(&self, i: usize) -> &str {
        &self.parameters[i].0
    }
    fn output(&self, i: usize) -> &str {
        &self.outputs[i].0
    }
    fn parameter_unit(&self, i: usize) -> &str {
        &self.parameters[i].1
    }
    fn output_unit(&self, i: usize) -> &str {
        &self.outputs[i].1
    }
}

impl InProcess {
    /// Takes equations that were derived with Jacobians.
    #[must_use]
    pub fn new(equations: Equations) -> Self {
        let layout = &equations.layout;
        let names = Labels {
            rig: layout.rig.clone(),
            states: layout.x().map(|v| v.name.clone()).collect(),
            signals: layout.u.iter().map(|v| (v.name.clone(), v.unit.clone())).collect(),
            parameters: layout.p.iter().map(|v| (v.name.clone(), v.unit.clone())).collect(),
            outputs: layout.outputs.iter().map(|v| (v.name.clone(), v.unit.clone())).collect(),
        };
        Self {
            equations,
            names,
            rhs: OnceLock::new(),
            linear: OnceLock::new(),
            linear_without_friction_slope: OnceLock::new(),
            parameters: OnceLock::new(),
            outputs: OnceLock::new(),
            output_jacobian: OnceLock::new(),
            paths: OnceLock::new(),
            pivots: OnceLock::new(),
        }
    }

    /// The equations.
    #[must_use]
    pub fn equations(&self) -> &Equations {
        &self.equations
    }

    fn program(&self, roots: &[Id]) -> Program {
        Program::new(&self.equations.graph, roots, self.equations.layout.q.len())
    }

    /// Checks the pivots, which stand at the end of `values`.
    fn check(&self, pivots: &[f64]) -> Result<(), Singular> {
        // not `<= 0`: a pivot that is not a number is singular too
        match pivots.iter().position(|&d| !(d > 0.0)) {
            Some(k) => Err(Singular { coordinate: self.equations.free[k] }),
            None => Ok(()),
        }
    }

    fn run<const N: usize>(&self, program: &Program, a: Arguments, outs: [&mut [f64]; N]) -> Result<(), Singular> {
        let length: usize = outs.iter().map(|o| o.len()).sum();
        let mut values = vec![0.0; length + self.equations.pivots.len()];
        program.run(a, &mut values);
        let (results, pivots) = values.split_at(length);
        let mut at = 0;
        for out in outs {
            out.copy_from_slice(&results[at..at + out.len()]);
            at += out.len();
        }
        self.check(pivots)
    }

    fn linear_roots(&self, linear: &codegen::Linear) -> Vec<Id> {
        let e = &self.equations;
        let mut roots = e.state_derivative();
        roots.extend(linear.a.iter().flatten().chain(linear.b.iter().flatten()).chain(&e.pivots));
        roots
    }

    /// As [`Model::linearize`], without the slope of regularized Coulomb friction.
    ///
    /// # Errors
    /// [`Singular`] where the mass matrix is not positive definite.
    #[allow(clippy::too_many_arguments)]
    pub fn linearize_without_friction_slope(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64], a: &mut [f64], b: &mut [f64]) -> Result<(), Singular> {
        let e = &self.equations;
        let linear = e.linear_without_friction_slope.as_ref().unwrap_or(&e.linear);
        let program = self.linear_without_friction_slope.get_or_init(|| self.program(&self.linear_roots(linear)));
        self.run(program, Arguments { t, x, u, p, a: &[] }, [dx, a, b])
    }
}

impl Model for InProcess {
    fn dimensions(&self) -> Dimensions {
        let l = &self.equations.layout;
        Dimensions {
            coordinates: l.q.len(),
            lags: l.z.len(),
            inputs: l.inputs,
            exogenous: l.u.len() - l.inputs,
            parameters: l.p.len(),
            outputs: l.outputs.len(),
        }
    }

    fn names(&self) -> &dyn Names {
        &self.names
    }

    fn nominal(&self, p: &mut [f64]) {
        p.copy_from_slice(&self.equations.layout.nominal);
    }

    fn rhs(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        let program = self.rhs.get_or_init(|| {
            let mut roots = self.equations.state_derivative();
            roots.extend(&self.equations.pivots);
            self.program(&roots)
        });
        self.run(program, Arguments { t, x, u, p, a: &[] }, [dx])
    }

    fn linearize(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64], a: &mut [f64], b: &mut [f64]) -> Result<(), Singular> {
        let program = self.linear.get_or_init(|| self.program(&self.linear_roots(&self.equations.linear)));
        self.run(program, Arguments { t, x, u, p, a: &[] }, [dx, a, b])
    }

    fn parameter_jacobian(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dfdp: &mut [f64]) -> Result<(), Singular> {
        let e = &self.equations;
        let program = self.parameters.get_or_init(|| {
            let mut roots = e.parameter_jacobian.concat();
            roots.extend(&e.pivots);
            self.program(&roots)
        });
        self.run(program, Arguments { t, x, u, p, a: &[] }, [dfdp])
    }

    fn pivots(&self, t: f64, x: &[f64], p: &[f64], d: &mut [f64]) -> bool {
        let e = &self.equations;
        let mut values = vec![0.0; e.pivots.len()];
        self.pivots.get_or_init(|| self.program(&e.pivots)).run(Arguments { t, x, u: &[], p, a: &[] }, &mut values);
        d.fill(f64::INFINITY);
        e.free.iter().zip(values).for_each(|(&k, value)| d[k] = value);
        true
    }

    fn outputs(&self, t: f64, x: &[f64], p: &[f64], y: &mut [f64]) {
        self.outputs.get_or_init(|| self.program(&self.equations.outputs)).run(Arguments { t, x, u: &[], p, a: &[] }, y);
    }

    fn output_jacobian(&self, t: f64, x: &[f64], p: &[f64], c: &mut [f64], dhdp: &mut [f64]) {
        let e = &self.equations;
        let program = self.output_jacobian.get_or_init(|| {
            let mut roots = e.output_jacobian.concat();
            roots.extend(e.output_parameter_jacobian.iter().flatten());
            self.program(&roots)
        });
        let mut values = vec![0.0; c.len() + dhdp.len()];
        program.run(Arguments { t, x, u: &[], p, a: &[] }, &mut values);
        let (left, right) = values.split_at(c.len());
        c.copy_from_slice(left);
        dhdp.copy_from_slice(right);
    }

    fn input_path(&self, i: usize, p: &[f64]) -> InputPath {
        let e = &self.equations;
        let limits = e.input_paths.get(i).and_then(|path| path.0).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        InputPath { limits, delay: self.delay(i, p) }
    }

    fn output_path(&self, i: usize, p: &[f64]) -> OutputPath {
        let e = &self.equations;
        let (_, quantum, wrapped) = e.output_paths[i];
        OutputPath { delay: self.delay(e.input_paths.len() + i, p), quantum, wrapped }
    }
}

impl InProcess {
    /// Delay k of the input paths, then of the output paths [s].
    fn delay(&self, k: usize, p: &[f64]) -> f64 {
        let e = &self.equations;
        let count = e.input_paths.len() + e.output_paths.len();
        if k >= count {
            return 0.0;
        }
        let program = self.paths.get_or_init(|| {
            let roots: Vec<Id> = e.input_paths.iter().map(|p| p.1).chain(e.output_paths.iter().map(|p| p.0)).collect();
            self.program(&roots)
        });
        let mut values = vec![0.0; count];
        program.run(Arguments { t: 0.0, x: &[], u: &[], p, a: &[] }, &mut values);
        values[k]
    }
}
