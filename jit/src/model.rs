//! Equations behind the model trait.

use crate::compile::NoCode;
use crate::program::{Arguments, Evaluation, Program, RESULTS};
use crate::selection::Selections;
use codegen::Equations;
use codegen::expr::Id;
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular};
use std::sync::OnceLock;

/// A model evaluated inside the process. Programs are made when they are first used.
pub struct InProcess {
    equations: Equations,
    evaluation: Evaluation,
    names: Labels,
    rhs: OnceLock<Program>,
    linear: OnceLock<Program>,
    linear_without_friction_slope: OnceLock<Program>,
    parameters: OnceLock<Program>,
    outputs: OnceLock<Program>,
    output_jacobian: OnceLock<Program>,
    paths: OnceLock<Program>,
    pivots: OnceLock<Program>,
    selections: Selections,
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
        Self::evaluated(equations, Evaluation::default())
    }

    /// As [`InProcess::new`], compiled from the first call on: for work on several threads. When code takes over from the interpreter would
    /// otherwise hang on how the threads run, and with it the last digit of a result.
    #[must_use]
    pub fn at_work(equations: Equations) -> Self {
        Self::evaluated(equations, Evaluation::Compiled)
    }

    /// As [`InProcess::new`], evaluated in a chosen way.
    #[must_use]
    pub fn evaluated(equations: Equations, evaluation: Evaluation) -> Self {
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
            evaluation,
            names,
            rhs: OnceLock::new(),
            linear: OnceLock::new(),
            linear_without_friction_slope: OnceLock::new(),
            parameters: OnceLock::new(),
            outputs: OnceLock::new(),
            output_jacobian: OnceLock::new(),
            paths: OnceLock::new(),
            pivots: OnceLock::new(),
            selections: Selections::default(),
        }
    }

    /// Why machine code was wanted and could not be had, so that forward dynamics are interpreted; `None` where
    /// nothing is amiss. The numbers are the same, only slower.
    #[must_use]
    pub fn interpreted_because(&self) -> Option<&NoCode> {
        self.rhs.get()?.interpreted_because()
    }

    /// The equations.
    #[must_use]
    pub fn equations(&self) -> &Equations {
        &self.equations
    }

    fn program(&self, results: [&[Id]; RESULTS], pivots: &[Id]) -> Program {
        Program::new(&self.equations.graph, results, pivots, self.equations.layout.q.len(), self.evaluation)
    }

    fn linear_program(&self, linear: &codegen::Linear) -> Program {
        let e = &self.equations;
        self.program([&e.state_derivative(), &linear.a.concat(), &linear.b.concat()], &self.eliminated())
    }

    /// Pivots in the order in which the first that fails is at fault.
    fn eliminated(&self) -> Vec<Id> {
        self.equations.pivots_as_eliminated().into_iter().map(|(_, pivot)| pivot).collect()
    }

    /// The coordinate of the pivot at this place of [`InProcess::eliminated`].
    fn singular(&self, pivot: usize) -> Singular {
        let free = &self.equations.free;
        Singular { coordinate: free[free.len() - 1 - pivot] }
    }

    /// As [`Model::linearize`], without the slope of regularized Coulomb friction.
    ///
    /// # Errors
    /// [`Singular`] where the mass matrix is not positive definite.
    #[allow(clippy::too_many_arguments)]
    pub fn linearize_without_friction_slope(
        &self,
        t: f64,
        x: &[f64],
        u: &[f64],
        p: &[f64],
        dx: &mut [f64],
        a: &mut [f64],
        b: &mut [f64],
    ) -> Result<(), Singular> {
        let e = &self.equations;
        let linear = e.linear_without_friction_slope.as_ref().unwrap_or(&e.linear);
        let program = self.linear_without_friction_slope.get_or_init(|| self.linear_program(linear));
        program.run(Arguments { t, x, u, p }, [dx, a, b]).map_err(|k| self.singular(k))
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
        let e = &self.equations;
        let program = self.rhs.get_or_init(|| self.program([&e.state_derivative(), &[], &[]], &self.eliminated()));
        program.run(Arguments { t, x, u, p }, [dx, &mut [], &mut []]).map_err(|k| self.singular(k))
    }

    fn linearize(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64], a: &mut [f64], b: &mut [f64]) -> Result<(), Singular> {
        let program = self.linear.get_or_init(|| self.linear_program(&self.equations.linear));
        program.run(Arguments { t, x, u, p }, [dx, a, b]).map_err(|k| self.singular(k))
    }

    fn parameter_jacobian(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dfdp: &mut [f64]) -> Result<(), Singular> {
        let e = &self.equations;
        let program = self.parameters.get_or_init(|| self.program([&e.parameter_jacobian.concat(), &[], &[]], &self.eliminated()));
        program.run(Arguments { t, x, u, p }, [dfdp, &mut [], &mut []]).map_err(|k| self.singular(k))
    }

    fn sensitivities(
        &self,
        t: f64,
        x: &[f64],
        u: &[f64],
        p: &[f64],
        columns: &[usize],
        dx: &mut [f64],
        a: &mut [f64],
        dfdp: &mut [f64],
        work: &mut [f64],
    ) -> Result<(), Singular> {
        let e = &self.equations;
        let program = self.selections.get(columns, || {
            let selected: Vec<Id> = e.parameter_jacobian.iter().flat_map(|row| columns.iter().map(|&j| row[j])).collect();
            self.program([&e.state_derivative(), &e.linear.a.concat(), &selected], &self.eliminated())
        });
        match program {
            Some(program) => program.run(Arguments { t, x, u, p }, [dx, a, dfdp]).map_err(|k| self.singular(k)),
            None => runtime::sensitivities_by_parts(self, t, x, u, p, columns, dx, a, dfdp, work),
        }
    }

    fn pivots(&self, t: f64, x: &[f64], p: &[f64], d: &mut [f64]) -> bool {
        let e = &self.equations;
        let mut values = vec![0.0; e.pivots.len()];
        let program = self.pivots.get_or_init(|| self.program([&e.pivots, &[], &[]], &[]));
        never_singular(program.run(Arguments { t, x, u: &[], p }, [&mut values, &mut [], &mut []]));
        d.fill(f64::INFINITY);
        e.free.iter().zip(values).for_each(|(&k, value)| d[k] = value);
        true
    }

    fn outputs(&self, t: f64, x: &[f64], p: &[f64], y: &mut [f64]) {
        let program = self.outputs.get_or_init(|| self.program([&self.equations.outputs, &[], &[]], &[]));
        never_singular(program.run(Arguments { t, x, u: &[], p }, [y, &mut [], &mut []]));
    }

    fn output_jacobian(&self, t: f64, x: &[f64], p: &[f64], c: &mut [f64], dhdp: &mut [f64]) {
        let e = &self.equations;
        let program = self
            .output_jacobian
            .get_or_init(|| self.program([&e.output_jacobian.concat(), &e.output_parameter_jacobian.concat(), &[]], &[]));
        never_singular(program.run(Arguments { t, x, u: &[], p }, [c, dhdp, &mut []]));
    }

    fn input_path(&self, i: usize, p: &[f64]) -> InputPath {
        let e = &self.equations;
        let limits = e.input_paths.get(i).and_then(|path| path.0).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let delay = if i < e.input_paths.len() { self.path_values(p)[i] } else { 0.0 };
        InputPath { limits, delay }
    }

    fn output_path(&self, i: usize, p: &[f64]) -> OutputPath {
        let e = &self.equations;
        let codegen::OutputPath { quantum, wrapped, .. } = e.output_paths[i];
        let values = self.path_values(p);
        let (_, outputs) = values.split_at(e.input_paths.len());
        OutputPath { delay: outputs[i], play: outputs[e.output_paths.len() + i], quantum, wrapped }
    }
}

impl InProcess {
    /// Delays of the input paths [s], delays of the output paths [s], plays of the output paths.
    fn path_values(&self, p: &[f64]) -> Vec<f64> {
        let e = &self.equations;
        let program = self.paths.get_or_init(|| {
            let outputs = e.output_paths.iter().map(|path| path.delay).chain(e.output_paths.iter().map(|path| path.play));
            let roots: Vec<Id> = e.input_paths.iter().map(|path| path.1).chain(outputs).collect();
            self.program([&roots, &[], &[]], &[])
        });
        let mut values = vec![0.0; e.input_paths.len() + 2 * e.output_paths.len()];
        never_singular(program.run(Arguments { t: 0.0, x: &[], u: &[], p }, [&mut values, &mut [], &mut []]));
        values
    }
}

/// A program without pivots has none that could vanish.
fn never_singular(result: Result<(), usize>) {
    debug_assert!(result.is_ok());
}
