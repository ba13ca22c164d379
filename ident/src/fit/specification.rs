//! What a fit may change: each parameter of a rig with its start, bounds and prior, and the overrides of a request.

use super::error::FitError;
use model_dsl::nearest;
use model_dsl::rig::{Expr, Rig, Symbol};

/// One parameter as a fit treats it, in the order of the model's p. Values are SI.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterSpec {
    /// Name.
    pub name: String,
    /// Starting value, and the value where it is fixed.
    pub value: f64,
    /// It is fitted.
    pub free: bool,
    /// A `const` of the rig: never free.
    pub constant: bool,
    /// Bounds.
    pub bounds: Option<(f64, f64)>,
    /// Standard deviation of the prior, whose mean is `prior_mean`.
    pub prior_sd: Option<f64>,
    /// Mean of the prior.
    pub prior_mean: f64,
    /// Belongs to the day: one value for each record.
    pub per_record: bool,
}

impl ParameterSpec {
    /// All parameters of a rig, as the rig says.
    #[must_use]
    pub fn of_rig(rig: &Rig) -> Vec<Self> {
        let positive = masses(rig);
        rig.parameters
            .iter()
            .enumerate()
            .map(|(i, p)| Self {
                name: p.name.clone(),
                value: p.value,
                free: !p.fixed && !p.constant,
                constant: p.constant,
                bounds: p.bounds.or_else(|| (positive.contains(&i) && p.value >= 0.0).then_some((0.0, f64::INFINITY))),
                prior_sd: p.prior_sd,
                prior_mean: p.value,
                per_record: p.per_record,
            })
            .collect()
    }

    /// Parameters of a model without a rig behind it, all of them free: names and nominal values.
    #[must_use]
    pub fn of_model(model: &dyn runtime::Model) -> Vec<Self> {
        let mut p = vec![0.0; model.dimensions().parameters];
        model.nominal(&mut p);
        p.iter()
            .enumerate()
            .map(|(i, &value)| Self {
                name: model.names().parameter(i).to_owned(),
                value,
                free: true,
                constant: false,
                bounds: None,
                prior_sd: None,
                prior_mean: value,
                per_record: false,
            })
            .collect()
    }
}

/// Parameters that are a body's mass or a moment of inertia: they cannot be negative.
fn masses(rig: &Rig) -> Vec<usize> {
    let alone = |e: &Expr| if let Expr::Symbol(Symbol::Parameter(i)) = e { Some(*i) } else { None };
    rig.bodies.iter().flat_map(|b| std::iter::once(&b.mass).chain(&b.inertia[..3]).filter_map(alone)).collect()
}

/// Applies a request: where `free` is given, these are free and no others, whatever the rig says; those of `fix` are fixed.
///
/// # Errors
/// [`FitError::UnknownParameter`], [`FitError::Constant`].
pub fn select(specs: &mut [ParameterSpec], free: Option<&[String]>, fix: &[String]) -> Result<(), FitError> {
    if let Some(free) = free {
        specs.iter_mut().for_each(|s| s.free = false);
        for name in free {
            let at = find(specs, name)?;
            if specs[at].constant {
                return Err(FitError::Constant { name: name.clone() });
            }
            specs[at].free = true;
        }
    }
    for name in fix {
        let at = find(specs, name)?;
        specs[at].free = false;
    }
    Ok(())
}

fn find(specs: &[ParameterSpec], name: &str) -> Result<usize, FitError> {
    specs.iter().position(|s| s.name == name).ok_or_else(|| FitError::UnknownParameter {
        name: name.to_owned(),
        near: nearest(name, specs.iter().map(|s| s.name.as_str())).map(str::to_owned),
    })
}

#[cfg(test)]
mod tests {
    use super::{ParameterSpec, select};
    use crate::fit::FitError;

    fn specs() -> Vec<ParameterSpec> {
        let text = "rig R { param m: kg = 2; param J: kg*m^2 = 1 +- 10 % in 0..3; param k: N*m/rad = 1 fixed; const g: m/s^2 = 9.81;
            coord q: rad; equation J * q.ddot = -k*q - m*g*(1 m)*sin(q); }";
        let checked = model_dsl::check_text("r.rig", text);
        ParameterSpec::of_rig(&checked.rig.unwrap_or_else(|| panic!("{:?}", checked.diagnostics)))
    }

    fn free(specs: &[ParameterSpec]) -> Vec<&str> {
        specs.iter().filter(|s| s.free).map(|s| s.name.as_str()).collect()
    }

    #[test]
    fn the_rig_decides_and_a_request_overrides() {
        let mut s = specs();
        assert_eq!(free(&s), ["m", "J"]);
        assert_eq!((s[1].prior_sd, s[1].bounds), (Some(0.1), Some((0.0, 3.0))));
        select(&mut s, None, &["m".to_owned()]).unwrap();
        assert_eq!(free(&s), ["J"]);
        select(&mut s, Some(&["k".to_owned(), "m".to_owned()]), &["m".to_owned()]).unwrap();
        assert_eq!(free(&s), ["k"]);
        assert_eq!(select(&mut s, Some(&["g".to_owned()]), &[]), Err(FitError::Constant { name: "g".to_owned() }));
        assert!(matches!(select(&mut s, None, &["K".to_owned()]), Err(FitError::UnknownParameter { .. })));
    }
}
