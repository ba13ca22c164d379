//! From a checked rig to its equations: the one list of passes.
//!
//! lower -> tree -> M, velocity products, gravity, springs, dissipation, force -> assumptions ->
//! solve -> Jacobians -> compare with the second road. Reads no files and prints nothing.

mod assumptions;
mod check;
mod jacobians;
mod parts;

pub(crate) use parts::BodyRoad;

use crate::equations::{Equations, Layout, OutputVariable, Variable};
use crate::expr::{Graph, Id};
use crate::lower::{Lowering, Lumps};
use model_dsl::rig::Rig;
use rustc_hash::FxHasher;
use std::fmt;
use std::hash::{Hash, Hasher};

/// Choices of a derivation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Options {
    /// What a lump with a value of its own means.
    pub lumps: Lumps,
    /// Apply the declared assumptions.
    pub assumptions: bool,
    /// Derive Jacobians too (identification and control need them; equations alone do not).
    pub jacobians: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { lumps: Lumps::AsParameters, assumptions: true, jacobians: true }
    }
}

/// Why no equations came out.
#[derive(Clone, Debug, PartialEq)]
pub enum DeriveError {
    /// The two roads differ: a fault of this program, never of the rig.
    RoadsDiffer {
        /// What differs: `M[eps, theta]`.
        quantity: String,
        /// Relative difference.
        difference: f64,
    },
    /// The power balance does not hold: a fault of this program.
    EnergyBalance {
        /// Relative difference.
        difference: f64,
    },
}

impl fmt::Display for DeriveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::RoadsDiffer { quantity, difference } => {
                write!(
                    f,
                    "the two derivations differ in {quantity} by {difference:.1e} (relative); this is a fault of the program, please report the rig"
                )
            }
            Self::EnergyBalance { difference } => {
                write!(f, "the power balance is off by {difference:.1e} (relative); this is a fault of the program, please report the rig")
            }
        }
    }
}

impl std::error::Error for DeriveError {}

/// Derives the equations of a rig.
///
/// # Errors
/// [`DeriveError`] where the two derivations or the power balance disagree.
pub fn derive(rig: &Rig, options: Options) -> Result<Equations, DeriveError> {
    let mut graph = Graph::new();
    let lowering = Lowering::new(rig, options.lumps, options.assumptions, &mut graph);
    let layout = layout(rig, &lowering, &graph);
    let full = parts::assemble(rig, &lowering, &mut graph, options.assumptions);
    let cross_check = check::compare(rig, &lowering, &mut graph, &layout, &full)?;
    let parts = assumptions::apply(rig, &lowering, &mut graph, full, options.assumptions);
    let equations = jacobians::complete(rig, &lowering, graph, layout, parts, options, cross_check);
    Ok(equations)
}

fn layout(rig: &Rig, lowering: &Lowering, g: &Graph) -> Layout {
    let variable = |symbol, unit: &str, doc: &str| Variable {
        name: g.symbol_info(symbol).name.clone(),
        unit: unit.to_owned(),
        doc: doc.to_owned(),
        symbol,
    };
    let per = |unit: &str, power: &str| format!("{unit}/s{power}");
    let coordinates = |symbols: &[crate::expr::SymbolId], suffix: &dyn Fn(&str) -> String| {
        rig.coordinates.iter().zip(symbols).map(|(c, &s)| variable(s, &suffix(&c.unit.text), &c.doc)).collect::<Vec<_>>()
    };
    let lags = rig.actuators.iter().filter(|a| a.lag.is_some());
    let mut u: Vec<Variable> = rig.inputs.iter().zip(&lowering.u).map(|(i, &s)| variable(s, &i.unit.text, &i.doc)).collect();
    let exogenous = rig.coordinates.iter().filter(|c| c.prescribed && c.trajectory.is_none());
    u.extend(exogenous.zip(&lowering.u[rig.inputs.len()..]).map(|(c, &s)| variable(s, &per(&c.unit.text, "^2"), &c.doc)));
    Layout {
        rig: rig.name.clone(),
        doc: rig.doc.clone(),
        q: coordinates(&lowering.q, &|unit| unit.to_owned()),
        v: coordinates(&lowering.v, &|unit| per(unit, "")),
        a: coordinates(&lowering.a, &|unit| per(unit, "^2")),
        z: lags.zip(&lowering.z).map(|(a, &s)| variable(s, &a.unit.text, &a.doc)).collect(),
        u,
        inputs: rig.inputs.len(),
        p: rig.parameters.iter().zip(&lowering.p).map(|(p, &s)| variable(s, &p.unit.text, &p.doc)).collect(),
        nominal: rig.parameters.iter().map(|p| p.value).collect(),
        outputs: rig.outputs.iter().map(|o| OutputVariable { name: o.name.clone(), unit: o.unit.text.clone() }).collect(),
        t: lowering.t,
    }
}

/// Fingerprint over names, values and the operations that the roots need.
fn fingerprint(g: &Graph, layout: &Layout, roots: &[Id]) -> String {
    let mut hasher = FxHasher::default();
    layout.rig.hash(&mut hasher);
    for variable in layout.x().chain(&layout.u).chain(&layout.p) {
        (&variable.name, &variable.unit, &variable.doc).hash(&mut hasher);
    }
    for value in &layout.nominal {
        value.to_bits().hash(&mut hasher);
    }
    for output in &layout.outputs {
        (&output.name, &output.unit).hash(&mut hasher);
    }
    let tape = g.tape(roots);
    for op in &tape.ops {
        format!("{op:?}").hash(&mut hasher);
    }
    tape.roots.hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}
