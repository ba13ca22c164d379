//! Values: parameters, constants, lumps, derived parameters, coordinates and their trajectories.

use super::Resolver;
use super::order::Order;
use super::terms::{hole, names_in};
use crate::ast::{Expr as Ast, ExprKind, Kind, Name, Statement, Value};
use crate::diagnostic::Diagnostic;
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::{Dimension, Unit};
use std::collections::HashMap;

impl Resolver<'_> {
    pub(super) fn values(&mut self, statements: &[Statement]) {
        let list = written(statements);
        let order = sorted(&list);
        self.circles(&list, &order);
        // where each definition stands among those sorted, by its place in the text
        let mut place = vec![0; list.len()];
        for (index, &k) in order.order.iter().enumerate() {
            place[k] = index;
        }
        let mut definitions: Vec<Option<Definition>> = vec![None; list.len()];
        let mut seen = 0;
        for s in statements {
            match &s.kind {
                Kind::Param(unit, value, constant) => {
                    let unit = self.checker().unit(unit);
                    let what = if *constant { "a constant" } else { "a parameter" };
                    self.declare(&s.name, Symbol::Parameter(self.rig.parameters.len()), unit.as_ref().map(|u| u.dimension), what, &s.doc);
                    let parameter = self.parameter(&s.name, &s.doc, unit.as_ref(), value, *constant, None);
                    self.rig.parameters.push(parameter);
                }
                Kind::Define(unit, _, own, is_lump) => {
                    let declared = unit.as_ref().and_then(|u| self.checker().unit(u));
                    let index = place[seen];
                    seen += 1;
                    // an inferred unit is filled in when its definition is checked
                    let what = if *is_lump { "a lump" } else { "a derived parameter" };
                    self.declare(&s.name, Symbol::Definition(index), declared.as_ref().map(|u| u.dimension), what, &s.doc);
                    let parameter = own.as_ref().map(|_| self.rig.parameters.len());
                    if let Some(value) = own {
                        // so is a value whose unit is inferred
                        let parameter = self.parameter(&s.name, &s.doc, declared.as_ref(), value, false, Some(index));
                        self.rig.parameters.push(parameter);
                    }
                    definitions[index] = Some(Definition {
                        name: s.name.text.clone(),
                        doc: s.doc.clone(),
                        unit: declared.unwrap_or_else(Unit::none),
                        value: hole(),
                        is_lump: *is_lump,
                        parameter,
                        span: s.name.span,
                    });
                }
                Kind::Coord(unit, range, _, prescribed) => {
                    let place = unit.span;
                    let mut unit = self.checker().unit(unit);
                    let index = self.rig.coordinates.len();
                    if let Some(u) = &unit
                        && u.dimension != Dimension::NONE
                        && u.dimension != Dimension::LENGTH
                    {
                        let d = Diagnostic::error(
                            "E0231",
                            format!("a coordinate is an angle or a length, this is {}", u.dimension),
                            place,
                            "its unit",
                        );
                        self.diagnostics.push(d.help("write `rad` or `m`"));
                        unit = None;
                    }
                    self.declare(&s.name, Symbol::Coordinate(index), unit.as_ref().map(|u| u.dimension), "a coordinate", &s.doc);
                    let range = range.as_ref().zip(unit.as_ref()).and_then(|(r, unit)| self.limits(r, unit, "a range"));
                    // coordinates live in SI; the declared unit is for what is given and shown
                    let dimension = unit.map_or(Dimension::NONE, |u| u.dimension);
                    let text = if dimension == Dimension::LENGTH { "m" } else { "rad" };
                    let si = Unit { text: text.to_owned(), factor: 1.0, dimension };
                    self.rig.coordinates.push(Coordinate {
                        name: s.name.text.clone(),
                        doc: s.doc.clone(),
                        unit: si,
                        range,
                        prescribed: *prescribed,
                        trajectory: None,
                        span: s.name.span,
                    });
                }
                _ => {}
            }
        }
        self.rig.definitions = definitions.into_iter().flatten().collect();
        for s in statements {
            if let Kind::Coord(_, _, Some(trajectory), true) = &s.kind
                && let Some(index) = self.rig.coordinates.iter().position(|c| c.name == s.name.text)
            {
                let dimension = self.rig.coordinates[index].unit.dimension;
                let value = self.expect(trajectory, dimension, "this coordinate", Allowed::Trajectory);
                self.rig.coordinates[index].trajectory = Some(value);
            }
        }
    }

    pub(super) fn limits(&mut self, (lo, hi): &(Ast, Ast), unit: &Unit, what: &str) -> Option<(f64, f64)> {
        let (a, b) = (self.constant(lo, unit, "a limit"), self.constant(hi, unit, "a limit"));
        let (a, b) = (a?, b?);
        if a >= b {
            let span = Span { end: hi.span.end, ..lo.span };
            let d = Diagnostic::error("E0310", format!("{what} runs from low to high: nothing lies in this one"), span, "an empty range");
            let swapped = self.sources.text(hi.span).zip(self.sources.text(lo.span)).filter(|_| a > b);
            self.diagnostics.push(
                swapped.map_or_else(|| d.clone().help("write LOWER..UPPER"), |(lo, hi)| d.clone().help(format!("write `{lo}..{hi}`"))),
            );
            return None;
        }
        Some((a, b))
    }

    /// A parameter's value in its unit; `None` where the unit is wrong, or is not known yet.
    fn parameter(
        &mut self,
        name: &Name,
        doc: &str,
        unit: Option<&Unit>,
        value: &Value,
        constant: bool,
        definition: Option<usize>,
    ) -> Parameter {
        let mut out = Parameter {
            name: name.text.clone(),
            doc: doc.to_owned(),
            unit: unit.cloned().unwrap_or_else(Unit::none),
            value: f64::NAN,
            prior_sd: None,
            bounds: None,
            fixed: value.fixed || constant,
            constant,
            per_record: value.per_record,
            definition,
            span: name.span,
        };
        let Some(unit) = unit else { return out };
        if let Some(number) = self.constant(&value.value, unit, &format!("`{}`", name.text)) {
            out.value = number;
        }
        out.prior_sd = value.prior.as_ref().and_then(|p| self.prior(p, unit, out.value));
        out.bounds = value.bounds.as_ref().and_then(|b| self.limits(b, unit, "a parameter's bounds"));
        if let (Some((lo, hi)), Some((start, end))) = (out.bounds, &value.bounds)
            && (out.value < lo || out.value > hi)
        {
            let bounds = Span { end: end.span.end, ..start.span };
            let d =
                Diagnostic::error("E0310", format!("the value of `{}` lies outside its bounds", name.text), value.value.span, "this value");
            self.diagnostics.push(d.also(bounds, "its bounds"));
        }
        out
    }

    /// Standard deviation of a prior: relative with `%`, otherwise in the parameter's unit.
    fn prior(&mut self, p: &Ast, unit: &Unit, value: f64) -> Option<f64> {
        let relative = matches!(&p.kind, ExprKind::Number(_, Some(u)) if u.text == "%");
        let sd = if relative { self.constant(p, &Unit::none(), "a prior")? * value.abs() } else { self.constant(p, unit, "a prior")? };
        if sd <= 0.0 {
            let zero = relative && value == 0.0;
            let label = if zero { "a percentage of zero is zero" } else { "this is zero or less" };
            let help = if zero {
                "write the standard deviation in the parameter's unit"
            } else {
                "write `fixed` to hold the value, or leave `+-` out to leave it free"
            };
            self.diagnostics.push(Diagnostic::error("E0310", "a prior needs a positive standard deviation", p.span, label).help(help));
            return None;
        }
        Some(sd)
    }

    /// Checks definitions in an order in which each stands behind what it uses; circles are reported.
    pub(super) fn definitions(&mut self, statements: &[Statement]) {
        let list = definitions_of(statements);
        for (k, &(s, definition)) in list.iter().enumerate() {
            let Kind::Define(written, _, own, _) = &s.kind else { continue };
            if self.circular.contains(&s.name.text) {
                self.rig.definitions[k].value = hole();
                continue;
            }
            let unit = self.rig.definitions[k].unit.clone();
            if written.is_some() {
                // where the declared unit was wrong, only names are checked
                let wanted = self.scope.names.get(&s.name.text).and_then(|m| m.dimension);
                self.rig.definitions[k].value =
                    self.expect(definition, wanted.map(|_| unit.dimension), &format!("`{}`", s.name.text), Allowed::Parameters);
            } else {
                let found = self.checker().check(definition, Allowed::Parameters);
                let dimension = found.as_ref().map(|q| q.dimension.unwrap_or(Dimension::NONE));
                self.rig.definitions[k].value = found.map_or_else(hole, |q| q.expr);
                if let Some(m) = self.scope.names.get_mut(&s.name.text)
                    && m.symbol == Symbol::Definition(k)
                {
                    m.dimension = dimension;
                }
                self.rig.definitions[k].unit = Unit::si(dimension.unwrap_or_default());
                if let (Some(p), Some(value), Some(_)) = (self.rig.definitions[k].parameter, own, dimension) {
                    let unit = self.rig.definitions[k].unit.clone();
                    self.rig.parameters[p] = self.parameter(&s.name, &s.doc, Some(&unit), value, false, Some(k));
                }
            }
        }
    }

    /// Definitions that stand for each other in a circle, each circle reported once.
    fn circles(&mut self, list: &[(&Statement, &Ast)], order: &Order) {
        for circle in &order.circles {
            let names: Vec<&str> = circle.iter().map(|&k| list[k].0.name.text.as_str()).collect();
            let first = &list[circle[0]].0.name;
            let message = if names.len() == 1 {
                format!("`{}` is defined by itself", names[0])
            } else {
                format!("{} are defined by each other", names.iter().map(|n| format!("`{n}`")).collect::<Vec<_>>().join(", "))
            };
            let mut d = Diagnostic::error("E0204", message, first.span, "stands for itself in the end");
            for &k in &circle[1..] {
                d = d.also(list[k].0.name.span, "by way of this");
            }
            self.diagnostics.push(d.help("give one of them a value of its own with `param`"));
        }
        self.circular = order.stuck.iter().map(|&k| list[k].0.name.text.clone()).collect();
    }
}

/// `lump` and `derived` statements, each behind what it uses; otherwise in the order of the text.
fn definitions_of(statements: &[Statement]) -> Vec<(&Statement, &Ast)> {
    let list = written(statements);
    sorted(&list).order.into_iter().map(|k| list[k]).collect()
}

fn written(statements: &[Statement]) -> Vec<(&Statement, &Ast)> {
    statements.iter().filter_map(|s| if let Kind::Define(_, definition, ..) = &s.kind { Some((s, definition)) } else { None }).collect()
}

fn sorted(list: &[(&Statement, &Ast)]) -> Order {
    let place: HashMap<&str, usize> = list.iter().enumerate().rev().map(|(k, (s, _))| (s.name.text.as_str(), k)).collect();
    let needs: Vec<Vec<usize>> =
        list.iter().map(|(_, definition)| names_in(definition).iter().filter_map(|n| place.get(n.as_str()).copied()).collect()).collect();
    Order::of(&needs)
}
