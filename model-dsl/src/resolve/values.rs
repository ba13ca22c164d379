//! Values: parameters, constants, lumps, derived parameters, coordinates and their trajectories.

use super::Resolver;
use super::terms::{definitions_in, names_in, renumber};
use crate::ast::{Expr as Ast, ExprKind, Kind, Name, Statement, Value};
use crate::diagnostic::Diagnostic;
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::{Dimension, Unit};

impl Resolver<'_> {
    pub(super) fn values(&mut self, statements: &[Statement]) {
        for s in statements {
            match &s.kind {
                Kind::Param(unit, value, constant) => {
                    let unit = self.checker().unit(unit);
                    let index = self.rig.parameters.len();
                    self.declare(
                        &s.name,
                        Symbol::Parameter(index),
                        unit.as_ref().map(|u| u.dimension),
                        if *constant { "a constant" } else { "a parameter" },
                    );
                    let unit = unit.unwrap_or_else(Unit::none);
                    self.parameter(&s.name, &s.doc, unit, value, *constant, None);
                }
                Kind::Define(unit, definition, own, is_lump) => {
                    let declared = unit.as_ref().and_then(|u| self.checker().unit(u));
                    let index = self.rig.definitions.len();
                    // an inferred unit is filled in when its definition is checked
                    self.declare(
                        &s.name,
                        Symbol::Definition(index),
                        declared.as_ref().map(|u| u.dimension),
                        if *is_lump { "a lump" } else { "a derived parameter" },
                    );
                    let parameter = own.as_ref().map(|_| self.rig.parameters.len());
                    if let Some(value) = own {
                        let unit = declared.clone().unwrap_or_else(Unit::none);
                        self.parameter(&s.name, &s.doc, unit, value, false, Some(index));
                    }
                    let _ = definition;
                    self.rig.definitions.push(Definition {
                        name: s.name.text.clone(),
                        doc: s.doc.clone(),
                        unit: declared.unwrap_or_else(Unit::none),
                        value: Expr::Number(0.0),
                        is_lump: *is_lump,
                        parameter,
                        span: s.name.span,
                    });
                }
                Kind::Coord(unit, range, _, prescribed) => {
                    let unit = self.checker().unit(unit);
                    let index = self.rig.coordinates.len();
                    if let Some(u) = &unit
                        && u.dimension != Dimension::NONE
                        && u.dimension != Dimension::LENGTH
                    {
                        self.diagnostics.push(
                            Diagnostic::error(
                                "E0231",
                                format!("a coordinate is an angle or a length, this is {}", u.dimension),
                                s.name.span,
                                "declared here",
                            )
                            .help("write `rad` or `m`"),
                        );
                    }
                    self.declare(&s.name, Symbol::Coordinate(index), unit.as_ref().map(|u| u.dimension), "a coordinate");
                    let unit = unit.unwrap_or_else(Unit::none);
                    let range = range.as_ref().and_then(|r| self.limits(r, &unit, "a range"));
                    // coordinates live in SI; the declared unit is for what is given and shown
                    let text = if unit.dimension == Dimension::LENGTH { "m" } else { "rad" };
                    let si = Unit { text: text.to_owned(), factor: 1.0, dimension: unit.dimension };
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
            self.diagnostics.push(
                Diagnostic::error(
                    "E0310",
                    format!("{what} goes from the lower to the upper end, this is empty"),
                    span,
                    "nothing lies in here",
                )
                .help("write lower..upper"),
            );
            return None;
        }
        Some((a, b))
    }

    pub(super) fn parameter(&mut self, name: &Name, doc: &str, unit: Unit, value: &Value, constant: bool, definition: Option<usize>) {
        let number = self.constant(&value.value, &unit, "a parameter's value").unwrap_or(0.0);
        let prior_sd = value.prior.as_ref().and_then(|p| {
            let relative = matches!(&p.kind, ExprKind::Number(_, Some(u)) if u.text == "%");
            let sd = if relative {
                self.constant(p, &Unit::none(), "a prior").map(|x| x * number.abs())
            } else {
                self.constant(p, &unit, "a prior")
            };
            match sd {
                Some(sd) if sd <= 0.0 => {
                    self.diagnostics.push(
                        Diagnostic::error("E0310", "a prior needs a positive standard deviation", p.span, "this is zero or less")
                            .help("write `fixed` to hold the value, or leave `+-` out to leave it free"),
                    );
                    None
                }
                other => other,
            }
        });
        let bounds = value.bounds.as_ref().and_then(|b| self.limits(b, &unit, "a parameter's bounds"));
        if let (Some((lo, hi)), Some((_, end))) = (bounds, &value.bounds)
            && !(lo..=hi).contains(&number)
        {
            self.diagnostics.push(
                Diagnostic::error("E0310", format!("the value of `{}` lies outside its bounds", name.text), value.value.span, "this value")
                    .also(end.span, "upper bound"),
            );
        }
        self.rig.parameters.push(Parameter {
            name: name.text.clone(),
            doc: doc.to_owned(),
            unit,
            value: number,
            prior_sd,
            bounds,
            fixed: value.fixed || constant,
            constant,
            per_record: value.per_record,
            definition,
            span: name.span,
        });
    }

    /// Checks definitions in an order in which each stands behind what it uses.
    pub(super) fn definitions(&mut self, statements: &[Statement]) {
        let list: Vec<(&Statement, &Ast)> = statements
            .iter()
            .filter_map(|s| match &s.kind {
                Kind::Define(_, definition, _, _) => Some((s, definition)),
                _ => None,
            })
            .collect();
        let index_of = |name: &str| list.iter().position(|(s, _)| s.name.text == name);
        let mut state = vec![0_u8; list.len()];
        let mut order = Vec::new();
        for k in 0..list.len() {
            self.visit(k, &list, &index_of, &mut state, &mut order);
        }
        for k in order {
            let (s, definition) = list[k];
            let declared = matches!(&s.kind, Kind::Define(Some(_), ..));
            let unit = self.rig.definitions[k].unit.clone();
            if declared {
                let value = self.expect(definition, unit.dimension, &format!("`{}`", s.name.text), Allowed::Parameters);
                self.rig.definitions[k].value = value;
            } else if let Some(q) = self.checker().check(definition, Allowed::Parameters) {
                let dimension = q.dimension.unwrap_or(Dimension::NONE);
                self.rig.definitions[k].value = q.expr;
                self.rig.definitions[k].unit = Unit::si(dimension);
                if let Some(m) = self.scope.names.get_mut(&s.name.text) {
                    m.dimension = Some(dimension);
                }
                if let Some(p) = self.rig.definitions[k].parameter {
                    self.rig.parameters[p].unit = Unit::si(dimension);
                }
            }
        }
        self.sort_definitions();
    }

    pub(super) fn visit(
        &mut self,
        k: usize,
        list: &[(&Statement, &Ast)],
        index_of: &dyn Fn(&str) -> Option<usize>,
        state: &mut [u8],
        order: &mut Vec<usize>,
    ) {
        if state[k] == 2 {
            return;
        }
        if state[k] == 1 {
            let name = &list[k].0.name;
            self.diagnostics.push(Diagnostic::error(
                "E0204",
                format!("`{}` is defined by itself", name.text),
                name.span,
                "closes a circle of definitions",
            ));
            return;
        }
        state[k] = 1;
        for name in names_in(list[k].1) {
            if let Some(j) = index_of(&name) {
                self.visit(j, list, index_of, state, order);
            }
        }
        state[k] = 2;
        order.push(k);
    }

    /// Puts definitions behind the ones that they use, and renumbers.
    pub(super) fn sort_definitions(&mut self) {
        let n = self.rig.definitions.len();
        let mut order: Vec<usize> = Vec::new();
        while order.len() < n {
            let next =
                (0..n).find(|k| !order.contains(k) && definitions_in(&self.rig.definitions[*k].value).iter().all(|d| order.contains(d)));
            match next {
                Some(k) => order.push(k),
                None => break,
            }
        }
        if order.len() < n || order.windows(2).all(|w| w[0] < w[1]) {
            return;
        }
        let place = |old: usize| order.iter().position(|&k| k == old).unwrap_or(old);
        let mut sorted: Vec<Definition> = order.iter().map(|&k| self.rig.definitions[k].clone()).collect();
        for d in &mut sorted {
            d.value = renumber(&d.value, &place);
        }
        self.rig.definitions = sorted;
        for p in &mut self.rig.parameters {
            p.definition = p.definition.map(place);
        }
        for m in self.scope.names.values_mut() {
            if let Symbol::Definition(k) = m.symbol {
                m.symbol = Symbol::Definition(place(k));
            }
        }
        self.used = self.used.iter().map(|s| if let Symbol::Definition(k) = s { Symbol::Definition(place(*k)) } else { *s }).collect();
    }
}
