//! The equations of a rig, as expressions on one graph: what every printer and evaluator is given.
//!
//! Made by [`crate::derive`] only. Convention, everywhere in the project:
//! M(q) a + bias(q, v) + dissipation(q, v) = force(q, v, z, u), with bias = velocity products +
//! gravity + springs and potentials. State x = [q | v | z], signals u = [inputs | exogenous].

use crate::expr::{Graph, Id, SymbolId};
use crate::lower::Lumps;

/// Everything derived from one rig.
#[non_exhaustive]
pub struct Equations {
    /// Where all expressions live.
    pub graph: Graph,
    /// Names and symbols of the model's vectors.
    pub layout: Layout,
    /// How lumps were treated.
    pub lumps: Lumps,
    /// M, all coordinates (a prescribed coordinate's row is what it would take to hold its motion).
    pub mass_matrix: Vec<Vec<Id>>,
    /// Velocity products + gravity + springs and potentials.
    pub bias: Vec<Id>,
    /// Velocity products alone; `None` for equations written directly.
    pub coriolis: Option<Vec<Id>>,
    /// Gravity alone (for equations written directly: the bias).
    pub gravity: Vec<Id>,
    /// Springs and potentials alone.
    pub springs: Vec<Id>,
    /// Friction, dampers, dissipation functions.
    pub dissipation: Vec<Id>,
    /// Generalized force Q(q, v, z, u).
    pub force: Vec<Id>,
    /// dQ/du, coordinates x signals.
    pub input_map: Vec<Vec<Id>>,
    /// z'.
    pub lag_rates: Vec<Id>,
    /// y, with scale and bias, without delay, play and quantization.
    pub outputs: Vec<Id>,
    /// T; `None` for equations written directly and where assumptions replaced M.
    pub kinetic: Option<Id>,
    /// V; `None` for equations written directly.
    pub potential: Option<Id>,
    /// Coordinates that are free, in order.
    pub free: Vec<usize>,
    /// Accelerations of all coordinates.
    pub acceleration: Vec<Id>,
    /// Pivots of the free coordinates' mass matrix, in the order of `free`: positive, or the model is singular. They
    /// are eliminated from the last to the first: the last one that is not positive is at fault.
    pub pivots: Vec<Id>,
    /// Inverse dynamics of all coordinates: M a + bias + dissipation - Q as a function of the symbols
    /// `layout.a`.
    pub inverse_dynamics: Vec<Id>,
    /// d x'/ d x, d x'/ d u, with every slope.
    pub linear: Linear,
    /// The same without the slope of regularized Coulomb friction; `None` where there is none.
    pub linear_without_friction_slope: Option<Linear>,
    /// d x' / d p, states x parameters.
    pub parameter_jacobian: Vec<Vec<Id>>,
    /// d y / d x, outputs x states.
    pub output_jacobian: Vec<Vec<Id>>,
    /// d y / d p, outputs x parameters.
    pub output_parameter_jacobian: Vec<Vec<Id>>,
    /// Position and rate of prescribed coordinates with a trajectory: (coordinate, s(t), s'(t)).
    pub trajectories: Vec<(usize, Id, Id)>,
    /// Input paths: limits, and the delay as an expression over parameters.
    pub input_paths: Vec<(Option<(f64, f64)>, Id)>,
    /// Output paths.
    pub output_paths: Vec<OutputPath>,
    /// Assumptions in words, in the order in which they were applied.
    pub assumptions: Vec<String>,
    /// What the scopes of the graph are about, in words, for comments: (scope, words).
    pub scopes: Vec<(String, String)>,
    /// How the two roads compared.
    pub cross_check: CrossCheck,
    /// Fingerprint of the model (16 hex digits): equal for equal equations, names and values.
    pub hash: String,
}

/// How an output leaves, after scale and bias: delay, play, encoder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputPath {
    /// Delay [s], over parameters.
    pub delay: Id,
    /// Whole width of the play, over parameters; zero where there is none.
    pub play: Id,
    /// Quantum of the encoder (SI), zero where there is none.
    pub quantum: f64,
    /// The encoder reads modulo one turn.
    pub wrapped: bool,
}

impl Equations {
    /// x' = [v | a | z'].
    #[must_use]
    pub fn state_derivative(&self) -> Vec<Id> {
        let rates = self.layout.v.iter().map(|v| self.graph.node_of_symbol(v.symbol));
        rates.chain(self.acceleration.iter().copied()).chain(self.lag_rates.iter().copied()).collect()
    }

    /// Pivots in the order in which they are eliminated, each with its coordinate: the first one that is not
    /// positive (or not a number) is at fault, those after it are spoilt by it.
    #[must_use]
    pub fn pivots_as_eliminated(&self) -> Vec<(usize, Id)> {
        self.free.iter().copied().zip(self.pivots.iter().copied()).rev().collect()
    }

    /// Scalar operations of forward dynamics, common subexpressions shared.
    #[must_use]
    pub fn forward_operations(&self) -> usize {
        self.graph.operations(&self.state_derivative())
    }

    /// Scalar operations of forward dynamics together with A and B.
    #[must_use]
    pub fn jacobian_operations(&self) -> usize {
        let mut roots = self.state_derivative();
        roots.extend(self.linear.a.iter().flatten());
        roots.extend(self.linear.b.iter().flatten());
        self.graph.operations(&roots)
    }
}

/// State and input Jacobians of x'.
pub struct Linear {
    /// states x states.
    pub a: Vec<Vec<Id>>,
    /// states x signals.
    pub b: Vec<Vec<Id>>,
}

/// Names and symbols of the vectors of a model.
#[derive(Clone, Debug)]
pub struct Layout {
    /// Name of the rig.
    pub rig: String,
    /// Documentation of the rig.
    pub doc: String,
    /// Coordinates.
    pub q: Vec<Variable>,
    /// Rates.
    pub v: Vec<Variable>,
    /// Accelerations (arguments of inverse dynamics).
    pub a: Vec<Variable>,
    /// Actuator states.
    pub z: Vec<Variable>,
    /// Signals: `inputs` inputs, then exogenous accelerations.
    pub u: Vec<Variable>,
    /// Number of inputs among the signals.
    pub inputs: usize,
    /// Parameters.
    pub p: Vec<Variable>,
    /// Nominal values of the parameters (SI).
    pub nominal: Vec<f64>,
    /// Outputs (their symbols are unused).
    pub outputs: Vec<OutputVariable>,
    /// Time.
    pub t: SymbolId,
}

impl Layout {
    /// Length of x.
    #[must_use]
    pub fn states(&self) -> usize {
        2 * self.q.len() + self.z.len()
    }

    /// Variables of x in order.
    pub fn x(&self) -> impl Iterator<Item = &Variable> {
        self.q.iter().chain(&self.v).chain(&self.z)
    }
}

/// One entry of a vector.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Name in the rig.
    pub name: String,
    /// Unit, SI, as text.
    pub unit: String,
    /// Documentation.
    pub doc: String,
    /// Symbol on the graph.
    pub symbol: SymbolId,
}

/// One output.
#[derive(Clone, Debug)]
pub struct OutputVariable {
    /// Name in the rig.
    pub name: String,
    /// Unit as text.
    pub unit: String,
}

/// Result of comparing the two derivations and of the energy balance at random states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CrossCheck {
    /// Largest relative differences: body by body against Lagrange, and power balance.
    Agree {
        /// |M - M'| and |bias - bias'| relative to their size.
        derivations: f64,
        /// |dE/dt - power| relative to the power's terms.
        energy: f64,
    },
    /// Directly written equations have one road only.
    NotApplicable,
}
