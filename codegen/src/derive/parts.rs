//! The full derivation, body by body, kept apart by kind so that assumptions can act on the kinds.

use crate::expr::{Graph, Id};
use crate::lower::Lowering;
use crate::mechanics::bodies::{Inertia, per_link};
use crate::mechanics::newton_euler::{Wrench, angular_velocities, inertial_wrenches, mass_matrix, project};
use crate::mechanics::tree::Tree;
use crate::mechanics::{direct, forces, friction, lagrange, stored};
use model_dsl::rig::Rig;

/// Generalized quantities by kind.
pub struct Parts {
    /// Tree of elementary links; `None` for equations written directly.
    pub body_road: Option<BodyRoad>,
    /// M.
    pub mass_matrix: Vec<Vec<Id>>,
    /// Velocity products, kinetic functions included; `None` for equations written directly.
    pub coriolis: Option<Vec<Id>>,
    /// Gravity (for equations written directly: the bias).
    pub gravity: Vec<Id>,
    /// Springs and potentials.
    pub springs: Vec<Id>,
    /// Velocity products + gravity + springs.
    pub bias: Vec<Id>,
    /// Dissipation.
    pub dissipation: Vec<Id>,
    /// Generalized force.
    pub force: Vec<Id>,
    /// T.
    pub kinetic: Option<Id>,
    /// V.
    pub potential: Option<Id>,
    /// Assumptions in words.
    pub assumptions: Vec<String>,
}

/// What later passes need of the derivation body by body.
pub struct BodyRoad {
    /// Links.
    pub tree: Tree,
    /// What the links carry.
    pub inertia: Vec<Inertia>,
    /// Applied wrenches on the links.
    pub applied: Vec<Wrench>,
    /// Generalized forces written on coordinates.
    pub applied_on_coordinates: Vec<Id>,
    /// M and velocity products of kinetic functions.
    pub functions: lagrange::Kinetic,
}

impl BodyRoad {
    /// M a + velocity products + gravity - Q on the links, projected once, for given accelerations.
    pub fn residual(&self, rig: &Rig, lowering: &Lowering, g: &mut Graph, acceleration: &[Id]) -> Vec<Id> {
        let fall = stored::free_fall(rig, lowering, g);
        let omega = angular_velocities(&self.tree, g, lowering.rates());
        let inertial = inertial_wrenches(&self.tree, g, &self.inertia, &omega, lowering.rates(), acceleration, fall);
        let net: Vec<Wrench> = inertial.iter().zip(&self.applied).map(|(i, a)| i.minus(g, a)).collect();
        let mut tau = project(&self.tree, g, &net, "_net");
        for (i, value) in tau.iter_mut().enumerate() {
            *value = g.sub(*value, self.applied_on_coordinates[i]);
            *value = g.add(*value, self.functions.coriolis[i]);
            for (j, &a) in acceleration.iter().enumerate() {
                let part = g.mul(self.functions.mass_matrix[i][j], a);
                *value = g.add(*value, part);
            }
        }
        tau
    }
}

/// Derives all parts. `set` assumptions already stand in the lowering.
pub fn assemble(rig: &Rig, lowering: &Lowering, g: &mut Graph, _assumptions: bool) -> Parts {
    let n = rig.coordinates.len();
    let tree = Tree::new(rig, lowering, g);
    let dissipation = friction::dissipation(rig, &tree, lowering, g, |_| true);
    let spring_energy = stored::spring_potential(rig, &tree, lowering, g, |_| true);
    let springs = lagrange::from_potential(g, spring_energy, lowering);
    if !rig.equations.is_empty() {
        let direct = direct::take_apart(rig, lowering, g);
        let extra = forces::generalized(rig, &tree, lowering, g, |_| true);
        let add = |g: &mut Graph, a: &[Id], b: &[Id]| a.iter().zip(b).map(|(&x, &y)| g.add(x, y)).collect::<Vec<_>>();
        return Parts {
            body_road: None,
            mass_matrix: direct.mass_matrix,
            coriolis: None,
            bias: add(g, &direct.bias, &springs),
            gravity: direct.bias,
            springs,
            dissipation: add(g, &direct.dissipation, &dissipation),
            force: add(g, &direct.force, &extra),
            kinetic: None,
            potential: None,
            assumptions: Vec::new(),
        };
    }
    let inertia = per_link(rig, &tree, lowering, g, |_| true);
    let zero = g.zero();
    let still = vec![zero; n];
    let nothing = [zero; 3];
    let fall = stored::free_fall(rig, lowering, g);
    let omega = angular_velocities(&tree, g, lowering.rates());
    let rest: Vec<_> = omega.iter().map(|_| nothing).collect();

    let moving = inertial_wrenches(&tree, g, &inertia, &omega, lowering.rates(), &still, nothing);
    let mut coriolis = project(&tree, g, &moving, "_moving");
    let hanging = inertial_wrenches(&tree, g, &inertia, &rest, &still, &still, fall);
    let mut gravity = project(&tree, g, &hanging, "_weight");
    let both = inertial_wrenches(&tree, g, &inertia, &omega, lowering.rates(), &still, fall);
    let mut bias = project(&tree, g, &both, "");

    let mut m = mass_matrix(&tree, g, &inertia);
    let function_energy = stored::kinetic_functions(rig, lowering, g, |_| true);
    let functions = lagrange::from_kinetic_energy(g, function_energy, lowering);
    for i in 0..n {
        for (entry, &own) in m[i].iter_mut().zip(&functions.mass_matrix[i]) {
            *entry = g.add(*entry, own);
        }
        coriolis[i] = g.add(coriolis[i], functions.coriolis[i]);
        bias[i] = g.add(bias[i], functions.coriolis[i]);
        bias[i] = g.add(bias[i], springs[i]);
    }
    let applied = forces::all_wrenches(rig, &tree, lowering, g, |_| true);
    let applied_on_coordinates = forces::on_coordinates(rig, lowering, g, |_| true);
    let force = forces::generalized(rig, &tree, lowering, g, |_| true);
    let bodies_energy = lagrange::kinetic_energy(rig, &tree, lowering, g);
    let kinetic = g.add(bodies_energy, function_energy);
    let height = stored::gravity_potential(rig, &tree, lowering, g, |_| true);
    let potential = g.add(height, spring_energy);
    // dV/dq is the shorter form on small rigs, and the one that stands in notes
    g.set_scope("gravity");
    let pull = lagrange::from_potential(g, height, lowering);
    if g.operations(&pull) <= g.operations(&gravity) {
        gravity = pull;
    }
    Parts {
        body_road: Some(BodyRoad { tree, inertia, applied, applied_on_coordinates, functions }),
        mass_matrix: m,
        coriolis: Some(coriolis),
        gravity,
        springs,
        bias,
        dissipation,
        force,
        kinetic: Some(kinetic),
        potential: Some(potential),
        assumptions: Vec::new(),
    }
}
