//! Assumptions, and what they name.

use super::Resolver;
use crate::ast::{Assume, Name};
use crate::diagnostic::{Diagnostic, nearest};
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::Dimension;

impl Resolver<'_> {
    pub(super) fn assume(&mut self, a: &Assume, span: Span) {
        let rows = |r: &mut Self, names: &[Name]| (!names.is_empty()).then(|| r.coordinates(names));
        let kind = match a {
            Assume::Set(name, value) => {
                let Some(parameter) = self.rig.parameters.iter().position(|p| p.name == name.text) else {
                    let names: Vec<String> = self.rig.parameters.iter().map(|p| p.name.clone()).collect();
                    self.unknown("parameter", name, "`set` takes a parameter or constant and a number", &names, "E0312");
                    return;
                };
                let unit = self.rig.parameters[parameter].unit.clone();
                let Some(value) = self.constant(value, &unit, &format!("`{}`", name.text)) else { return };
                AssumptionKind::Set { parameter, value }
            }
            Assume::NeglectInertia(row, column) => {
                let (Some(row), Some(column)) = (self.coordinate(row), self.coordinate(column)) else { return };
                AssumptionKind::NeglectInertia { row, column }
            }
            Assume::Diagonal(entries) => {
                let free: Vec<usize> = (0..self.rig.coordinates.len()).filter(|&i| !self.rig.coordinates[i].prescribed).collect();
                if entries.len() != free.len() {
                    if self.scope.lost.is_empty() {
                        let message = format!(
                            "the mass matrix has {} diagonal entr{}, this has {}",
                            free.len(),
                            if free.len() == 1 { "y" } else { "ies" },
                            entries.len()
                        );
                        let names: Vec<&str> = free.iter().map(|&i| self.rig.coordinates[i].name.as_str()).collect();
                        let d = Diagnostic::error("E0312", message, span, "one entry for each coordinate")
                            .help(format!("their order is {}", names.join(", ")));
                        self.diagnostics.push(d);
                    }
                    return;
                }
                let wanted: Vec<Option<Dimension>> = free
                    .iter()
                    .map(|&i| self.row_unit[i].map(|d| d * Dimension::TIME.powi(2) / self.rig.coordinates[i].unit.dimension))
                    .collect();
                let checked = entries.iter().zip(wanted).map(|(e, d)| self.expect(e, d, "this inertia", Allowed::Parameters)).collect();
                AssumptionKind::InertiaDiagonal(checked)
            }
            Assume::Neglect(what, of, within) => {
                let rows = rows(self, within);
                if what.text != "gravity"
                    && let Some(name) = of.first()
                {
                    let d = Diagnostic::error("E0312", format!("`neglect {} of ..` means nothing", what.text), name.span, "a body");
                    self.diagnostics.push(
                        d.help("bodies are named with gravity: `neglect gravity of fuselage;`; rows with `in`: `neglect coriolis in psi;`"),
                    );
                    return;
                }
                match what.text.as_str() {
                    "coriolis" => {
                        self.neglectable(
                            self.rig.equations.is_empty(),
                            what,
                            "equations written directly have no velocity products to tell apart",
                        );
                        AssumptionKind::NeglectCoriolis { rows }
                    }
                    "friction" => {
                        let any = !self.rig.frictions.is_empty()
                            || !self.rig.dampers.is_empty()
                            || self.rig.functions.iter().any(|f| f.kind == EnergyKind::Dissipation);
                        self.neglectable(any, what, "the rig has no friction");
                        AssumptionKind::NeglectFriction { rows }
                    }
                    "gravity" => {
                        self.neglectable(self.rig.gravity.is_some(), what, "the rig has no gravity");
                        AssumptionKind::NeglectGravity { bodies: (!of.is_empty()).then(|| self.named_bodies(of)), rows }
                    }
                    name => {
                        if !self.is_term(name, what) {
                            return;
                        }
                        AssumptionKind::NeglectTerm { name: name.to_owned(), rows }
                    }
                }
            }
        };
        self.rig.assumptions.push(Assumption { kind, span });
    }

    fn neglectable(&mut self, there: bool, what: &Name, why: &str) {
        if !there && self.scope.lost.is_empty() {
            let d = Diagnostic::error("E0312", format!("there is no {} to neglect", what.text), what.span, why);
            self.diagnostics.push(d.help("remove the assumption"));
        }
    }

    fn named_bodies(&mut self, of: &[Name]) -> Vec<usize> {
        let mut bodies = Vec::new();
        for name in of {
            match self.rig.bodies.iter().position(|b| b.name == name.text) {
                Some(k) => bodies.push(k),
                None => {
                    let names: Vec<String> = self.rig.bodies.iter().map(|b| b.name.clone()).collect();
                    self.unknown("body", name, &format!("bodies are {}", names.join(", ")), &names, "E0312");
                }
            }
        }
        bodies
    }

    /// Whether a force, spring, damper, friction or function has this name.
    fn is_term(&mut self, name: &str, place: &Name) -> bool {
        let rig = &self.rig;
        let names: Vec<&str> = rig
            .forces
            .iter()
            .map(|x| x.name.as_str())
            .chain(rig.springs.iter().map(|x| x.name.as_str()))
            .chain(rig.dampers.iter().map(|x| x.name.as_str()))
            .chain(rig.frictions.iter().map(|x| x.name.as_str()))
            .chain(rig.functions.iter().map(|x| x.name.as_str()))
            .collect();
        if names.contains(&name) {
            return true;
        }
        if !self.scope.lost.contains(name) {
            let near = nearest(name, names.into_iter().chain(["coriolis", "gravity", "friction", "inertia"]));
            let d = Diagnostic::error(
                "E0312",
                format!("this assumption names nothing: there is no `{name}` to neglect"),
                place.span,
                "unknown term",
            );
            self.diagnostics.push(match near {
                Some(near) => d.help(format!("did you mean `{near}`?")),
                None => {
                    d.help("assumptions name coriolis, gravity, friction, inertia[a, b], or a force, spring, damper or function of the rig")
                }
            });
        }
        false
    }
}
