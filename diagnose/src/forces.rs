//! A force on every free coordinate, by a parameter that is zero: how random forces enter a rig; and where its friction is random, too.

use crate::effects::unit::of_row;
use crate::patch::{Base, PatchError, check, compose};
use ident::innovations::{Dry, Level};
use model_dsl::rig::{Expr, Friction, Rig, Symbol};

/// A coordinate that is pushed.
#[derive(Clone, Debug, PartialEq)]
pub struct Force {
    /// Index of the coordinate.
    pub coordinate: usize,
    /// Name of the parameter by which the force enters.
    pub parameter: String,
    /// Its unit.
    pub unit: String,
}

/// One force for each coordinate whose motion is not prescribed and that the training records show.
#[must_use]
pub fn forces(base: &Base) -> Vec<Force> {
    let rig = &base.rig;
    let free = (0..rig.coordinates.len()).filter(|&i| !rig.coordinates[i].prescribed && !base.unwatched.contains(&i));
    free.map(|i| Force { coordinate: i, parameter: format!("pushed_{}", rig.coordinates[i].name), unit: of_row(rig, i).text() }).collect()
}

/// The rig with these forces; values of its parameters as in `base.rig`, whatever its text says.
///
/// # Errors
/// [`PatchError`].
pub fn with_forces(base: &Base) -> Result<(Base, Vec<Force>), PatchError> {
    let forces = forces(base);
    let mut pushed = check(&compose(base, &[], &forces)?, &base.rig.name)?;
    for parameter in &mut pushed.rig.parameters {
        if let Some(own) = base.rig.parameters.iter().find(|p| p.name == parameter.name) {
            parameter.value = own.value;
        }
    }
    Ok((pushed, forces))
}

/// Dry frictions of single coordinates whose level and width are names or numbers; `coordinates` are those that are pushed.
#[must_use]
pub fn dry_frictions(rig: &Rig, coordinates: &[usize]) -> Vec<Dry> {
    let level = |e: &Option<Expr>| match e {
        Some(Expr::Symbol(Symbol::Parameter(i))) => Some(Level::Parameter(*i)),
        Some(Expr::Number(value)) => Some(Level::Value(*value)),
        _ => None,
    };
    let of = |f: &Friction| {
        let Expr::Symbol(Symbol::Coordinate(i)) = &f.of else { return None };
        let entry = coordinates.iter().position(|c| c == i)?;
        Some(Dry { entry, rate: rig.coordinates.len() + i, level: level(&f.coulomb)?, width: level(&f.width)? })
    };
    rig.frictions.iter().filter_map(of).collect()
}
