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
                    let names: Vec<&str> = self.rig.parameters.iter().map(|p| p.name.as_str()).collect();
                    let mut d =
                        Diagnostic::error("E0312", format!("there is no parameter `{}` to set", name.text), name.span, "unknown parameter");
                    if let Some(near) = nearest(&name.text, names) {
                        d = d.help(format!("did you mean `{near}`?"));
                    }
                    self.diagnostics.push(d);
                    return;
                };
                let unit = self.rig.parameters[parameter].unit.clone();
                let Some(value) = self.constant(value, &unit, "an assumed value") else { return };
                AssumptionKind::Set { parameter, value }
            }
            Assume::NeglectInertia(row, column) => {
                let (Some(row), Some(column)) = (self.coordinate(row), self.coordinate(column)) else { return };
                AssumptionKind::NeglectInertia { row, column }
            }
            Assume::Diagonal(entries) => {
                let free: Vec<usize> = (0..self.rig.coordinates.len()).filter(|&i| !self.rig.coordinates[i].prescribed).collect();
                if entries.len() != free.len() {
                    self.diagnostics.push(Diagnostic::error(
                        "E0312",
                        format!("the mass matrix has {} diagonal entries, this has {}", free.len(), entries.len()),
                        span,
                        "one entry for each coordinate",
                    ));
                    return;
                }
                let wanted: Vec<Dimension> =
                    free.iter().map(|&i| self.row_unit[i] * Dimension::TIME.powi(2) / self.rig.coordinates[i].unit.dimension).collect();
                let checked = entries.iter().zip(wanted).map(|(e, d)| self.expect(e, d, "this inertia", Allowed::Parameters)).collect();
                AssumptionKind::InertiaDiagonal(checked)
            }
            Assume::Neglect(what, of, within) => {
                let rows = rows(self, within);
                match what.text.as_str() {
                    "coriolis" => AssumptionKind::NeglectCoriolis { rows },
                    "friction" => AssumptionKind::NeglectFriction { rows },
                    "gravity" => {
                        let mut bodies = Vec::new();
                        for name in of {
                            match self.rig.bodies.iter().position(|b| b.name == name.text) {
                                Some(k) => bodies.push(k),
                                None => {
                                    let names: Vec<&str> = self.rig.bodies.iter().map(|b| b.name.as_str()).collect();
                                    let mut d =
                                        Diagnostic::error("E0312", format!("there is no body `{}`", name.text), name.span, "unknown body");
                                    if let Some(near) = nearest(&name.text, names) {
                                        d = d.help(format!("did you mean `{near}`?"));
                                    }
                                    self.diagnostics.push(d);
                                }
                            }
                        }
                        AssumptionKind::NeglectGravity { bodies: (!of.is_empty()).then_some(bodies), rows }
                    }
                    name => {
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
                        if !names.contains(&name) {
                            let near =
                                nearest(name, names.into_iter().chain(["coriolis", "gravity", "friction", "inertia"])).map(str::to_owned);
                            let mut d = Diagnostic::error(
                                "E0312",
                                format!("this assumption names nothing: there is no `{name}`"),
                                what.span,
                                "unknown term",
                            );
                            d = match near {
                                Some(near) => d.help(format!("did you mean `{near}`?")),
                                None => d.help("assumptions name coriolis, gravity, friction, inertia[a, b], or a force, spring, damper or function of the rig"),
                            };
                            self.diagnostics.push(d);
                            return;
                        }
                        AssumptionKind::NeglectTerm { name: name.to_owned(), rows }
                    }
                }
            }
        };
        self.rig.assumptions.push(Assumption { kind, span });
    }
}
