//! Statements to the checked rig: every name resolved, every dimension checked, every number in SI.

use crate::ast::{
    self, Along as AstAlong, Assume, AxisExpr, AxisOrVector, BodyEntry, Entry, Expr as Ast, ExprKind, Kind, Name, Statement, Value,
};
use crate::diagnostic::{Diagnostic, nearest};
use crate::quantity::{Allowed, Checker, Meaning, Quantity, Scope, is_bare};
use crate::rig::*;
use crate::units::{Dimension, Unit};
use std::collections::BTreeSet;

/// Builds the rig from its statements; `None` where an error left a hole.
pub fn resolve(name: &Name, doc: &str, statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> (Rig, BTreeSet<Symbol>) {
    let rig = Rig {
        name: name.text.clone(),
        doc: doc.to_owned(),
        parameters: Vec::new(),
        definitions: Vec::new(),
        coordinates: Vec::new(),
        inputs: Vec::new(),
        actuators: Vec::new(),
        mixes: Vec::new(),
        frames: Vec::new(),
        bodies: Vec::new(),
        gravity: None,
        forces: Vec::new(),
        springs: Vec::new(),
        frictions: Vec::new(),
        dampers: Vec::new(),
        functions: Vec::new(),
        equations: Vec::new(),
        outputs: Vec::new(),
        trims: Vec::new(),
        assumptions: Vec::new(),
    };
    let mut r = Resolver { rig, scope: Scope::default(), diagnostics, used: BTreeSet::new(), row_unit: Vec::new() };
    r.values(statements);
    r.definitions(statements);
    r.inputs(statements);
    r.frames(statements);
    r.row_units(statements);
    for s in statements {
        r.statement(s);
    }
    r.equations(statements);
    if r.rig.outputs.is_empty() {
        for (i, c) in r.rig.coordinates.iter().enumerate() {
            r.rig.outputs.push(plain_output(c, i));
        }
    }
    (r.rig, r.used)
}

fn plain_output(c: &Coordinate, i: usize) -> Output {
    Output {
        name: c.name.clone(),
        unit: c.unit.clone(),
        value: Expr::Symbol(Symbol::Coordinate(i)),
        scale: None,
        bias: None,
        delay: None,
        encoder: None,
        span: c.span,
    }
}

struct Resolver<'a> {
    rig: Rig,
    scope: Scope,
    diagnostics: &'a mut Vec<Diagnostic>,
    used: BTreeSet<Symbol>,
    /// Dimension of each coordinate's equation.
    row_unit: Vec<Dimension>,
}

impl Resolver<'_> {
    fn checker(&mut self) -> Checker<'_> {
        Checker { scope: &self.scope, diagnostics: self.diagnostics, used: &mut self.used }
    }

    fn expect(&mut self, ast: &Ast, wanted: Dimension, what: &str, allowed: Allowed) -> Expr {
        self.checker().expect(ast, wanted, what, allowed).unwrap_or(Expr::Number(0.0))
    }

    fn vector(&mut self, v: &ast::Vector, wanted: Dimension, what: &str, allowed: Allowed) -> [Expr; 3] {
        if v.0.len() != 3 {
            self.diagnostics.push(
                Diagnostic::error("E0111", format!("a vector has three components, this has {}", v.0.len()), v.1, "here")
                    .help("write (x, y, z)"),
            );
        }
        std::array::from_fn(|k| v.0.get(k).map_or(Expr::Number(0.0), |e| self.expect(e, wanted, what, allowed)))
    }

    /// A number known now: literals and arithmetic of literals.
    fn constant(&mut self, ast: &Ast, unit: &Unit, what: &str) -> Option<f64> {
        let Quantity { expr, dimension, .. } = self.checker().check(ast, Allowed::Numbers)?;
        let Expr::Number(x) = expr else {
            self.diagnostics.push(
                Diagnostic::error("E0314", format!("{what} must be a number"), ast.span, "not a number")
                    .help("for a value computed from parameters use `derived`"),
            );
            return None;
        };
        if is_bare(ast) {
            // a bare number is in the declared unit
            return Some(x * unit.factor);
        }
        match dimension {
            Some(d) if d != unit.dimension => {
                self.checker().expect(ast, unit.dimension, what, Allowed::Numbers);
                None
            }
            _ => Some(x),
        }
    }

    fn declare(&mut self, name: &Name, symbol: Symbol, dimension: Option<Dimension>, what: &'static str) {
        if let Some(before) = self.scope.names.get(&name.text) {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("`{}` is declared twice", name.text), name.span, "again here")
                    .also(before.span, "first here")
                    .help(format!("rename one of them; to change it in a variant write `replace .. {} ..`", name.text)),
            );
            return;
        }
        if ["t", "pi", "ground"].contains(&name.text.as_str()) {
            self.diagnostics.push(Diagnostic::error(
                "E0202",
                format!("`{}` is a name of the language", name.text),
                name.span,
                "choose another name",
            ));
        }
        self.scope.order.push(name.text.clone());
        self.scope.names.insert(name.text.clone(), Meaning { symbol, dimension, span: name.span, what });
    }

    fn values(&mut self, statements: &[Statement]) {
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

    fn limits(&mut self, (lo, hi): &(Ast, Ast), unit: &Unit, what: &str) -> Option<(f64, f64)> {
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

    fn parameter(&mut self, name: &Name, doc: &str, unit: Unit, value: &Value, constant: bool, definition: Option<usize>) {
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
    fn definitions(&mut self, statements: &[Statement]) {
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

    fn visit(
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
    fn sort_definitions(&mut self) {
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

    fn inputs(&mut self, statements: &[Statement]) {
        for s in statements {
            if let Kind::Input(unit, limits, _) = &s.kind {
                let unit = self.checker().unit(unit);
                let index = self.rig.inputs.len();
                self.declare(&s.name, Symbol::Input(index), unit.as_ref().map(|u| u.dimension), "an input");
                let unit = unit.unwrap_or_else(Unit::none);
                let limits = limits.as_ref().and_then(|l| self.limits(l, &unit, "an input's range"));
                self.rig.inputs.push(Input { name: s.name.text.clone(), doc: s.doc.clone(), unit, limits, span: s.name.span });
            }
        }
        for s in statements {
            if let Kind::Mix(rows) = &s.kind {
                self.mix(rows, s.span);
            }
        }
        // an actuator sees inputs by their own names; what is written after it sees the actuator
        for s in statements {
            match &s.kind {
                Kind::Input(_, _, path) if !path.is_empty() => {
                    let Some(i) = self.rig.inputs.iter().position(|u| u.name == s.name.text) else { continue };
                    let unit = self.rig.inputs[i].unit.clone();
                    let index = self.rig.actuators.len();
                    let actuator = self.path(&s.name, &s.doc, unit, Expr::Symbol(Symbol::Input(i)), path);
                    self.rig.actuators.push(actuator);
                    self.used.insert(Symbol::Input(i));
                    if let Some(m) = self.scope.names.get_mut(&s.name.text) {
                        m.symbol = Symbol::Actuator(index);
                    }
                }
                Kind::Actuator(unit, map, path) => {
                    let unit = self.checker().unit(unit);
                    let dimension = unit.as_ref().map(|u| u.dimension);
                    let unit = unit.unwrap_or_else(Unit::none);
                    let map = self.expect(map, unit.dimension, "this actuator", Allowed::Everything);
                    let index = self.rig.actuators.len();
                    let actuator = self.path(&s.name, &s.doc, unit, map, path);
                    self.rig.actuators.push(actuator);
                    self.declare(&s.name, Symbol::Actuator(index), dimension, "an actuator");
                }
                _ => {}
            }
        }
    }

    fn path(&mut self, name: &Name, doc: &str, unit: Unit, map: Expr, entries: &[Entry]) -> Actuator {
        let mut out = Actuator {
            name: name.text.clone(),
            doc: doc.to_owned(),
            unit,
            map,
            delay: None,
            dead_zone: None,
            saturation: None,
            lag: None,
            span: name.span,
        };
        let dimension = out.unit.dimension;
        for e in entries {
            let value = &e.values[0];
            match e.key.text.as_str() {
                "delay" => out.delay = Some(self.expect(value, Dimension::TIME, "a delay", Allowed::Parameters)),
                "lag" => out.lag = Some(self.expect(value, Dimension::TIME, "a lag's time constant", Allowed::Parameters)),
                "dead_zone" => out.dead_zone = Some(self.expect(value, dimension, "this dead zone", Allowed::Parameters)),
                "saturate" if e.values.len() == 2 => {
                    let lo = self.expect(value, dimension, "this limit", Allowed::Parameters);
                    let hi = self.expect(&e.values[1], dimension, "this limit", Allowed::Parameters);
                    out.saturation = Some((lo, hi));
                }
                _ => self.entry_error(e, "delay T, dead_zone W, saturate LO..HI, lag TAU"),
            }
        }
        out
    }

    fn entry_error(&mut self, e: &Entry, known: &str) {
        self.diagnostics.push(
            Diagnostic::error("E0115", format!("`{}` does not fit here", e.key.text), e.key.span, "this entry")
                .help(format!("entries are {known}")),
        );
    }

    fn mix(&mut self, rows: &[(Name, Ast)], span: Span) {
        let mut checked = Vec::new();
        for (name, ast) in rows {
            if let Some(q) = self.checker().check(ast, Allowed::Inputs) {
                checked.push((name.clone(), q, ast.span));
            }
        }
        if checked.len() != rows.len() {
            return;
        }
        let mut inputs: Vec<usize> = Vec::new();
        for (_, q, _) in &checked {
            collect_inputs(&q.expr, &mut inputs);
        }
        inputs.sort_unstable();
        inputs.dedup();
        let mut matrix = Vec::new();
        for (_, q, place) in &checked {
            match linear_row(&q.expr, &inputs) {
                Some(row) => matrix.push(row),
                None => {
                    self.diagnostics.push(Diagnostic::error(
                        "E0309",
                        "a mix is a sum of inputs times numbers",
                        *place,
                        "not linear in the inputs",
                    ));
                    return;
                }
            }
        }
        if matrix.len() != inputs.len() || determinant(&matrix).abs() < 1e-12 {
            self.diagnostics.push(
                Diagnostic::error(
                    "E0309",
                    format!("{} mixed inputs from {} inputs cannot be undone", matrix.len(), inputs.len()),
                    span,
                    "this mix",
                )
                .help("a mix needs as many independent rows as it has inputs: `f_s = f_1 + f_2; f_d = f_1 - f_2;`"),
            );
            return;
        }
        let index = self.rig.mixes.len();
        let mut mix = Mix { names: Vec::new(), units: Vec::new(), inputs, rows: matrix, span };
        for (row, (name, q, _)) in checked.iter().enumerate() {
            self.declare(name, Symbol::Mixed(index, row), q.dimension, "a mixed input");
            mix.names.push(name.text.clone());
            let first = mix.inputs.first().map_or_else(Unit::none, |&i| self.rig.inputs[i].unit.clone());
            mix.units.push(if q.dimension == Some(first.dimension) { first } else { Unit::si(q.dimension.unwrap_or_default()) });
        }
        self.rig.mixes.push(mix);
    }

    fn frames(&mut self, statements: &[Statement]) {
        let list: Vec<(&Statement, &Name, &Vec<ast::Step>)> = statements
            .iter()
            .filter_map(|s| match &s.kind {
                Kind::Frame(parent, steps) => Some((s, parent, steps)),
                _ => None,
            })
            .collect();
        let names: Vec<String> = list.iter().map(|(s, _, _)| s.name.text.clone()).collect();
        for (k, (s, _, _)) in list.iter().enumerate() {
            if let Some(before) = names[..k].iter().position(|n| *n == s.name.text) {
                self.diagnostics.push(
                    Diagnostic::error("E0202", format!("the frame `{}` is declared twice", s.name.text), s.name.span, "again here")
                        .also(list[before].0.name.span, "first here"),
                );
            }
            if s.name.text == "ground" {
                self.diagnostics.push(Diagnostic::error(
                    "E0202",
                    "`ground` is the frame that does not move",
                    s.name.span,
                    "choose another name",
                ));
            }
        }
        let mut placed: Vec<String> = Vec::new();
        let mut waiting: Vec<usize> = (0..list.len()).collect();
        loop {
            let before = waiting.len();
            waiting.retain(|&k| {
                let (s, parent, steps) = list[k];
                let parent_ref = if parent.text == "ground" {
                    FrameRef::Ground
                } else if let Some(p) = placed.iter().position(|n| *n == parent.text) {
                    FrameRef::Frame(p)
                } else {
                    return true;
                };
                let steps = steps.iter().map(|step| self.step(step)).collect();
                self.rig.frames.push(Frame { name: s.name.text.clone(), doc: s.doc.clone(), parent: parent_ref, steps, span: s.name.span });
                placed.push(s.name.text.clone());
                false
            });
            if waiting.len() == before {
                break;
            }
        }
        for &k in &waiting {
            let (s, parent, _) = list[k];
            if names.contains(&parent.text) {
                let circle = in_circle(k, &list, &names);
                if circle {
                    self.diagnostics.push(
                        Diagnostic::error(
                            "E0301",
                            format!("the frame `{}` stands on itself", s.name.text),
                            parent.span,
                            "its chain comes back here",
                        )
                        .help("every chain of frames starts at `ground`"),
                    );
                }
            } else {
                let near = nearest(&parent.text, names.iter().map(String::as_str).chain(["ground"]));
                let mut d = Diagnostic::error("E0201", format!("there is no frame `{}`", parent.text), parent.span, "unknown frame");
                d = match near {
                    Some(near) => d.help(format!("did you mean `{near}`?")),
                    None => d.help("every chain of frames starts at `ground`"),
                };
                self.diagnostics.push(d);
            }
            // keep the name, so that bodies on it are no second error
            self.rig.frames.push(Frame {
                name: s.name.text.clone(),
                doc: String::new(),
                parent: FrameRef::Ground,
                steps: Vec::new(),
                span: s.name.span,
            });
        }
    }

    fn step(&mut self, step: &ast::Step) -> Step {
        match step {
            ast::Step::Rotate(axis, angle, _) => {
                let axis = match axis {
                    AxisExpr::Principal(index, negative) => Axis::Principal { index: *index, negative: *negative },
                    AxisExpr::Vector(v) => self.axis_vector(v),
                };
                let checked = self.expect(angle, Dimension::NONE, "a rotation", Allowed::Configuration);
                self.affine(&checked, angle.span, "angle");
                Step::Rotate { axis, angle: checked }
            }
            ast::Step::Translate(components, span) => {
                let v = (components.clone(), *span);
                let checked = self.vector(&v, Dimension::LENGTH, "a translation", Allowed::Configuration);
                for (value, ast) in checked.iter().zip(components) {
                    self.affine(value, ast.span, "offset");
                }
                Step::Translate(checked)
            }
        }
    }

    fn affine(&mut self, expr: &Expr, span: Span, what: &str) {
        if degree(expr).is_none_or(|d| d > 1) {
            self.diagnostics.push(
                Diagnostic::error(
                    "E0302",
                    format!("this {what} is not affine in the coordinates"),
                    span,
                    "products or functions of coordinates",
                )
                .help("a joint moves by a sum of coordinates times parameters, as in `q1 - 2 * q2 + 30deg`"),
            );
        }
    }

    fn axis_vector(&mut self, v: &ast::Vector) -> Axis {
        let mut n = [0.0; 3];
        for (k, slot) in n.iter_mut().enumerate() {
            if let Some(e) = v.0.get(k) {
                *slot = self.constant(e, &Unit::none(), "a component of an axis").unwrap_or(0.0);
            }
        }
        let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
        if v.0.len() != 3 || length <= 0.0 || !length.is_finite() {
            self.diagnostics.push(Diagnostic::error("E0313", "an axis is a vector of three numbers, not all zero", v.1, "this axis"));
            return Axis::Principal { index: 2, negative: false };
        }
        let unit = n.map(|x| x / length);
        for (index, &x) in unit.iter().enumerate() {
            if x.abs() == 1.0 {
                return Axis::Principal { index, negative: x < 0.0 };
            }
        }
        Axis::Vector(unit)
    }

    fn frame(&mut self, name: &Name) -> FrameRef {
        if name.text == "ground" {
            return FrameRef::Ground;
        }
        if let Some(i) = self.rig.frames.iter().position(|f| f.name == name.text) {
            return FrameRef::Frame(i);
        }
        if let Some(body) = self.rig.bodies.iter().find(|b| b.name == name.text) {
            return body.frame;
        }
        let names: Vec<&str> = self.rig.frames.iter().map(|f| f.name.as_str()).chain(["ground"]).collect();
        let mut d = Diagnostic::error("E0201", format!("there is no frame `{}`", name.text), name.span, "unknown frame");
        d = match nearest(&name.text, names.iter().copied()) {
            Some(near) => d.help(format!("did you mean `{near}`?")),
            None => d.help(format!("frames are {}", names.join(", "))),
        };
        self.diagnostics.push(d);
        FrameRef::Ground
    }

    fn coordinate(&mut self, name: &Name) -> Option<usize> {
        if let Some(i) = self.rig.coordinates.iter().position(|c| c.name == name.text) {
            return Some(i);
        }
        let names: Vec<&str> = self.rig.coordinates.iter().map(|c| c.name.as_str()).collect();
        let mut d = Diagnostic::error("E0201", format!("there is no coordinate `{}`", name.text), name.span, "unknown coordinate");
        d = match nearest(&name.text, names.iter().copied()) {
            Some(near) => d.help(format!("did you mean `{near}`?")),
            None => d.help(format!("coordinates are {}", names.join(", "))),
        };
        self.diagnostics.push(d);
        None
    }

    fn coordinates(&mut self, names: &[Name]) -> Vec<usize> {
        names.iter().filter_map(|n| self.coordinate(n)).collect()
    }

    /// Dimension of each row: N m or N, or what a directly written equation has on its left.
    fn row_units(&mut self, statements: &[Statement]) {
        self.row_unit = self.rig.coordinates.iter().map(|c| Dimension::TORQUE / c.unit.dimension).collect();
        for s in statements {
            if let Kind::Equation(lhs, _) = &s.kind {
                let mut quiet = Vec::new();
                let mut used = BTreeSet::new();
                let q = Checker { scope: &self.scope, diagnostics: &mut quiet, used: &mut used }.check(lhs, Allowed::Accelerations);
                if let Some(q) = q
                    && let Some(d) = q.dimension
                    && let Some(row) = accelerations(&q.expr).first()
                {
                    self.row_unit[*row] = d;
                }
            }
        }
    }

    fn equations(&mut self, statements: &[Statement]) {
        let list: Vec<(&Statement, &Ast, &Ast)> = statements
            .iter()
            .filter_map(|s| match &s.kind {
                Kind::Equation(l, r) => Some((s, l, r)),
                _ => None,
            })
            .collect();
        if list.is_empty() {
            return;
        }
        for (s, lhs, rhs) in &list {
            let Some(q) = self.checker().check(lhs, Allowed::Accelerations) else { continue };
            let found = accelerations(&q.expr);
            let Some(mass) = mass_row(&q.expr) else {
                self.diagnostics.push(
                    Diagnostic::error(
                        "E0307",
                        "the left-hand side is a sum of accelerations with coefficients",
                        lhs.span,
                        "not of this form",
                    )
                    .help("write `I * eps.ddot = ..` or `eps.ddot = ..`"),
                );
                continue;
            };
            let taken: Vec<usize> = self.rig.equations.iter().map(|e| e.coordinate).collect();
            let Some(&row) = found.iter().find(|i| !taken.contains(i)) else {
                self.diagnostics.push(
                    Diagnostic::error("E0307", "this coordinate has its equation already", lhs.span, "a second one")
                        .help("one equation for each coordinate"),
                );
                continue;
            };
            let dimension = q.dimension.unwrap_or(Dimension::NONE);
            let value = self.expect(rhs, dimension, "the right-hand side", Allowed::Everything);
            self.rig.equations.push(Equation { coordinate: row, mass, rhs: value, unit: Unit::si(dimension), span: s.span });
        }
        let missing: Vec<&Coordinate> = self
            .rig
            .coordinates
            .iter()
            .enumerate()
            .filter(|(i, c)| !c.prescribed && !self.rig.equations.iter().any(|e| e.coordinate == *i))
            .map(|(_, c)| c)
            .collect();
        if self.rig.equations.len() == list.len()
            && let Some(c) = missing.first()
        {
            self.diagnostics.push(
                Diagnostic::error("E0307", format!("`{}` has no equation", c.name), c.span, "declared here")
                    .help("where one equation is written directly, every coordinate needs one"),
            );
        }
        if let Some(body) = self.rig.bodies.first() {
            self.diagnostics.push(
                Diagnostic::error("E0307", "a rig has either bodies or equations written directly", body.span, "a body")
                    .also(list[0].0.span, "an equation")
                    .help("remove the bodies, or let the program derive the equations"),
            );
        }
    }

    fn statement(&mut self, s: &Statement) {
        let name = s.name.text.clone();
        let (doc, span) = (s.doc.clone(), s.name.span);
        match &s.kind {
            Kind::Body(frame, entries) => self.body(s, frame, entries),
            Kind::Gravity(value, along) => {
                let size = self.expect(value, Dimension::ACCELERATION, "gravity", Allowed::Parameters);
                let zero = Expr::Number(0.0);
                let acceleration = match along {
                    None => [zero.clone(), zero, negative(size)],
                    Some(AxisOrVector::Axis(k, minus)) => std::array::from_fn(|i| {
                        if i != *k {
                            zero.clone()
                        } else if *minus {
                            negative(size.clone())
                        } else {
                            size.clone()
                        }
                    }),
                    Some(AxisOrVector::Vector(v)) => {
                        let direction = self.vector(v, Dimension::NONE, "a direction", Allowed::Parameters);
                        direction.map(|d| {
                            if d == Expr::Number(0.0) { d } else { Expr::Binary(BinaryOp::Mul, Box::new(size.clone()), Box::new(d)) }
                        })
                    }
                };
                self.rig.gravity = Some(Gravity { acceleration, span: s.span });
            }
            Kind::Force(frame, at, vector, axes, against) => {
                let frame = self.frame(frame);
                let point = at.as_ref().map_or([Expr::Number(0.0), Expr::Number(0.0), Expr::Number(0.0)], |p| {
                    self.vector(p, Dimension::LENGTH, "a point", Allowed::Parameters)
                });
                let vector = self.vector(vector, Dimension::FORCE, "a force", Allowed::Everything);
                let axes = axes.as_ref().map_or(frame, |n| self.frame(n));
                let against = against.as_ref().map(|n| self.frame(n));
                self.unique(s, "force");
                self.rig.forces.push(Force { name, doc, kind: ForceKind::Force { frame, point, vector, axes, against }, span });
            }
            Kind::Torque(frame, vector, axes, against) => {
                let frame = self.frame(frame);
                let vector = self.vector(vector, Dimension::TORQUE, "a torque", Allowed::Everything);
                let axes = axes.as_ref().map_or(frame, |n| self.frame(n));
                let against = against.as_ref().map(|n| self.frame(n));
                self.unique(s, "torque");
                self.rig.forces.push(Force { name, doc, kind: ForceKind::Torque { frame, vector, axes, against }, span });
            }
            Kind::Generalized(place, value) => {
                let Some(coordinate) = self.coordinate(place) else { return };
                let unit = self.row_unit[coordinate];
                let value = self.expect(value, unit, &format!("the equation of `{}`", place.text), Allowed::Everything);
                self.unique(s, "torque");
                self.rig.forces.push(Force { name, doc, kind: ForceKind::Generalized { coordinate, value }, span });
            }
            Kind::Spring(along, entries) => self.spring(s, along, entries),
            Kind::Damper(along, entries) => {
                let along = self.along(along).0;
                let mut viscous = Expr::Number(0.0);
                for e in entries {
                    match e.key.text.as_str() {
                        "viscous" => {
                            viscous = self.expect(
                                &e.values[0],
                                Dimension::FORCE * Dimension::TIME / Dimension::LENGTH,
                                "a damper",
                                Allowed::Parameters,
                            )
                        }
                        _ => self.entry_error(e, "viscous C"),
                    }
                }
                self.unique(s, "damper");
                self.rig.dampers.push(Damper { name, along, viscous, span });
            }
            Kind::Friction(of, entries) => self.friction(s, of, entries),
            Kind::Function(kind, value) => {
                let (wanted, what, allowed) = match kind {
                    EnergyKind::Potential => (Dimension::TORQUE, "a potential energy", Allowed::Configuration),
                    EnergyKind::Kinetic => (Dimension::TORQUE, "a kinetic energy", Allowed::Motion),
                    EnergyKind::Dissipation => (Dimension::POWER, "a dissipation function", Allowed::Motion),
                };
                let value = self.expect(value, wanted, what, allowed);
                self.unique(s, "function");
                self.rig.functions.push(EnergyFunction { name, kind: *kind, value, span });
            }
            Kind::Encoder(entry) => {
                let Some(i) = self.coordinate(&s.name) else { return };
                self.used.insert(Symbol::Coordinate(i));
                let mut output = plain_output(&self.rig.coordinates[i], i);
                output.encoder = self.encoder(entry, output.unit.dimension);
                output.span = span;
                self.output(output, s);
            }
            Kind::Output(unit, value, entries) => {
                let Some(unit) = self.checker().unit(unit) else { return };
                let value = self.expect(value, unit.dimension, "this output", Allowed::Motion);
                let mut out = Output { name, unit: unit.clone(), value, scale: None, bias: None, delay: None, encoder: None, span };
                for e in entries {
                    let v = &e.values[0];
                    match e.key.text.as_str() {
                        "scale" => out.scale = Some(self.expect(v, Dimension::NONE, "a scale", Allowed::Parameters)),
                        "bias" => out.bias = Some(self.expect(v, unit.dimension, "this bias", Allowed::Parameters)),
                        "delay" => out.delay = Some(self.expect(v, Dimension::TIME, "a delay", Allowed::Parameters)),
                        "encoder" => out.encoder = self.encoder(e, unit.dimension),
                        _ => self.entry_error(e, "scale S, bias B, delay T, encoder COUNTS [zero at Z] [wrapped]"),
                    }
                }
                self.output(out, s);
            }
            Kind::Trim(fixed, zero, solve) => self.trim(s, fixed, zero, solve),
            Kind::Assume(list) => {
                for (a, place) in list {
                    self.assume(a, *place);
                }
            }
            _ => {}
        }
    }

    /// Names of forces, springs, dampers, frictions and functions are one family: assumptions name them.
    fn unique(&mut self, s: &Statement, _what: &str) {
        let rig = &self.rig;
        let before = rig
            .forces
            .iter()
            .map(|x| (&x.name, x.span))
            .chain(rig.springs.iter().map(|x| (&x.name, x.span)))
            .chain(rig.dampers.iter().map(|x| (&x.name, x.span)))
            .chain(rig.frictions.iter().map(|x| (&x.name, x.span)))
            .chain(rig.functions.iter().map(|x| (&x.name, x.span)))
            .find(|(n, _)| **n == s.name.text);
        if let Some((_, place)) = before {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("`{}` is declared twice", s.name.text), s.name.span, "again here")
                    .also(place, "first here")
                    .help("rename one of them"),
            );
        }
    }

    fn output(&mut self, output: Output, s: &Statement) {
        if let Some(before) = self.rig.outputs.iter().find(|o| o.name == output.name) {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("the output `{}` is declared twice", output.name), s.name.span, "again here")
                    .also(before.span, "first here"),
            );
            return;
        }
        self.rig.outputs.push(output);
    }

    fn encoder(&mut self, entry: &Entry, dimension: Dimension) -> Option<Encoder> {
        let counts = self.constant(&entry.values[0], &Unit::none(), "an encoder's counts")?;
        if counts <= 0.0 {
            self.diagnostics.push(Diagnostic::error("E0310", "an encoder has a positive number of counts", entry.values[0].span, "here"));
            return None;
        }
        let mut out = Encoder { counts, zero: None, wrapped: false };
        for (key, value) in &entry.options {
            match (key.text.as_str(), value) {
                ("wrapped", _) => out.wrapped = true,
                ("zero", Some(v)) => out.zero = Some(self.expect(v, dimension, "an encoder's zero", Allowed::Parameters)),
                _ => self.diagnostics.push(
                    Diagnostic::error("E0115", format!("`{}` is no option of an encoder", key.text), key.span, "here")
                        .help("options are `zero at VALUE` and `wrapped`"),
                ),
            }
        }
        Some(out)
    }

    fn body(&mut self, s: &Statement, frame: &Name, entries: &[BodyEntry]) {
        let zero = || Expr::Number(0.0);
        let frame = self.frame(frame);
        let mut body = Body {
            name: s.name.text.clone(),
            doc: s.doc.clone(),
            frame,
            mass: zero(),
            center: [zero(), zero(), zero()],
            inertia: std::array::from_fn(|_| zero()),
            about: InertiaPoint::CenterOfMass,
            span: s.name.span,
        };
        let mut seen = Vec::new();
        for e in entries {
            let key = match e {
                BodyEntry::Mass(v) => {
                    body.mass = self.expect(v, Dimension::MASS, "a mass", Allowed::Parameters);
                    "mass"
                }
                BodyEntry::At(v) => {
                    body.center = self.vector(v, Dimension::LENGTH, "a position", Allowed::Parameters);
                    "at"
                }
                BodyEntry::Inertia(v, origin, _) => {
                    body.inertia = std::array::from_fn(|k| {
                        v.get(k).map_or_else(zero, |e| self.expect(e, Dimension::INERTIA, "an inertia", Allowed::Parameters))
                    });
                    if *origin {
                        body.about = InertiaPoint::FrameOrigin;
                    }
                    "inertia"
                }
            };
            if seen.contains(&key) {
                self.diagnostics.push(Diagnostic::error(
                    "E0115",
                    format!("the body `{}` has `{key}` twice", body.name),
                    s.name.span,
                    "this body",
                ));
            }
            seen.push(key);
        }
        if !seen.contains(&"mass") && !seen.contains(&"inertia") {
            self.diagnostics.push(
                Diagnostic::error("E0115", format!("the body `{}` has no mass", body.name), s.name.span, "this body")
                    .help("write `mass m;` in it"),
            );
        }
        if let Some(before) = self.rig.bodies.iter().find(|b| b.name == body.name) {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("the body `{}` is declared twice", body.name), s.name.span, "again here")
                    .also(before.span, "first here"),
            );
        }
        self.rig.bodies.push(body);
    }

    fn along(&mut self, along: &AstAlong) -> (Along, Dimension) {
        match along {
            AstAlong::On(e) => match self.checker().check(e, Allowed::Configuration) {
                Some(q) => {
                    self.affine(&q.expr, e.span, "combination");
                    (Along::Coordinate(q.expr), q.dimension.unwrap_or(Dimension::NONE))
                }
                None => (Along::Coordinate(Expr::Number(0.0)), Dimension::NONE),
            },
            AstAlong::Between(ends) => {
                let ((f, p), (t, q)) = ends.as_ref();
                let from = (self.frame(f), self.vector(p, Dimension::LENGTH, "a point", Allowed::Parameters));
                let to = (self.frame(t), self.vector(q, Dimension::LENGTH, "a point", Allowed::Parameters));
                (Along::Points { from, to }, Dimension::LENGTH)
            }
        }
    }

    fn spring(&mut self, s: &Statement, along: &AstAlong, entries: &[Entry]) {
        let (along, x) = self.along(along);
        let row = match &along {
            Along::Coordinate(e) => self.row_of(e),
            Along::Points { .. } => Dimension::FORCE,
        };
        let mut out = Spring {
            name: s.name.text.clone(),
            along,
            stiffness: Expr::Number(0.0),
            rest: Expr::Number(0.0),
            cubic: Expr::Number(0.0),
            span: s.name.span,
        };
        for e in entries {
            let v = &e.values[0];
            match e.key.text.as_str() {
                "stiffness" => out.stiffness = self.expect(v, row / x, "this stiffness", Allowed::Parameters),
                "rest" => out.rest = self.expect(v, x, "this rest position", Allowed::Parameters),
                "cubic" => out.cubic = self.expect(v, row / x.powi(3), "this cubic stiffness", Allowed::Parameters),
                _ => self.entry_error(e, "stiffness K, rest X_0, cubic K_3"),
            }
        }
        self.unique(s, "spring");
        self.rig.springs.push(out);
    }

    /// Dimension of the equation of the first coordinate in an affine combination.
    fn row_of(&self, e: &Expr) -> Dimension {
        coordinates_in(e).first().map_or(Dimension::TORQUE, |&i| self.row_unit[i])
    }

    fn friction(&mut self, s: &Statement, of: &Ast, entries: &[Entry]) {
        let Some(q) = self.checker().check(of, Allowed::Configuration) else { return };
        self.affine(&q.expr, of.span, "combination");
        let row = self.row_of(&q.expr);
        let rate = q.dimension.unwrap_or(Dimension::NONE) / Dimension::TIME;
        let mut out = Friction {
            name: s.name.text.clone(),
            of: q.expr,
            viscous: None,
            coulomb: None,
            width: None,
            stribeck: None,
            quadratic: None,
            asymmetric: None,
            span: s.name.span,
        };
        for e in entries {
            let v = &e.values[0];
            let option = |key: &str| e.options.iter().find(|(k, _)| k.text == key).and_then(|(_, v)| v.clone());
            match e.key.text.as_str() {
                "viscous" => out.viscous = Some(self.expect(v, row / rate, "viscous friction", Allowed::Parameters)),
                "coulomb" => {
                    out.coulomb = Some(self.expect(v, row, "Coulomb friction", Allowed::Parameters));
                    if let Some(w) = option("width") {
                        out.width = Some(self.expect(&w, rate, "the width", Allowed::Parameters));
                    }
                }
                "stribeck" => {
                    let level = self.expect(v, row, "Stribeck friction", Allowed::Parameters);
                    match option("speed") {
                        Some(speed) => {
                            let speed = self.expect(&speed, rate, "the Stribeck speed", Allowed::Parameters);
                            out.stribeck = Some((level, speed));
                        }
                        None => self.diagnostics.push(
                            Diagnostic::error("E0115", "Stribeck friction needs its speed", e.key.span, "here")
                                .help("write `stribeck F_s speed v_s;`"),
                        ),
                    }
                    if let Some(w) = option("width") {
                        out.width = Some(self.expect(&w, rate, "the width", Allowed::Parameters));
                    }
                }
                "quadratic" => out.quadratic = Some(self.expect(v, row / (rate * rate), "quadratic drag", Allowed::Parameters)),
                "asymmetric" if e.values.len() == 2 => {
                    let slope = self.expect(v, row / rate, "the slope of asymmetric friction", Allowed::Parameters);
                    let offset = self.expect(&e.values[1], row, "the offset of asymmetric friction", Allowed::Parameters);
                    out.asymmetric = Some((slope, offset));
                }
                _ => self.entry_error(e, "viscous C, coulomb F [width W], stribeck F speed V, quadratic C, asymmetric SLOPE, OFFSET"),
            }
        }
        if (out.coulomb.is_some() || out.stribeck.is_some()) && out.width.is_none() {
            out.width = Some(Expr::Number(0.01));
        }
        self.unique(s, "friction");
        self.rig.frictions.push(out);
    }

    fn operand(&mut self, name: &Name, suffix: Option<&Name>) -> Option<(Symbol, Unit)> {
        let ast = Ast { span: name.span, kind: ExprKind::Name(name.clone(), suffix.cloned()) };
        let q = self.checker().check(&ast, Allowed::Everything)?;
        let Expr::Symbol(symbol) = q.expr else { return None };
        // a trim is about commands, not about what comes out of an actuator
        let symbol = match symbol {
            Symbol::Actuator(k) => self.rig.inputs.iter().position(|i| i.name == self.rig.actuators[k].name).map_or(symbol, Symbol::Input),
            other => other,
        };
        if !matches!(symbol, Symbol::Coordinate(_) | Symbol::Rate(_) | Symbol::Input(_) | Symbol::Mixed(..)) {
            self.diagnostics.push(Diagnostic::error(
                "E0206",
                format!("`{}` cannot be part of a trim", name.text),
                name.span,
                "not a coordinate, rate or input",
            ));
            return None;
        }
        Some((symbol, Unit::si(q.dimension.unwrap_or_default())))
    }

    fn trim(&mut self, s: &Statement, fixed: &[(Name, Option<Name>, Ast)], zero: &[Name], solve: &[(Name, Option<Name>)]) {
        let mut out =
            Trim { name: s.name.text.clone(), fixed: Vec::new(), zero: self.coordinates(zero), solve: Vec::new(), span: s.name.span };
        for (name, suffix, value) in fixed {
            if let Some((symbol, unit)) = self.operand(name, suffix.as_ref()) {
                let value = self.expect(value, unit.dimension, &format!("`{}`", name.text), Allowed::Parameters);
                out.fixed.push((symbol, value));
            }
        }
        for (name, suffix) in solve {
            if let Some((symbol, _)) = self.operand(name, suffix.as_ref()) {
                if out.fixed.iter().any(|(s, _)| *s == symbol) {
                    self.diagnostics.push(
                        Diagnostic::error("E0311", format!("`{}` is both fixed and solved for", name.text), name.span, "solved for here")
                            .help("take it out of one of them"),
                    );
                }
                out.solve.push(symbol);
            }
        }
        if out.zero.len() == zero.len() && out.solve.len() == solve.len() && out.zero.len() != out.solve.len() {
            let (e, u) = (out.zero.len(), out.solve.len());
            let hint = if e > u {
                "solve for more coordinates, rates or inputs, or let an acceleration stay"
            } else {
                "name more coordinates under `zero`, or fix some unknowns"
            };
            self.diagnostics.push(
                Diagnostic::error(
                    "E0311",
                    format!("the trim `{}` has {u} unknown{} and {e} equation{}", s.name.text, plural(u), plural(e)),
                    s.name.span,
                    "as many of one as of the other are needed",
                )
                .help(hint),
            );
        }
        if let Some(before) = self.rig.trims.iter().find(|t| t.name == out.name) {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("the trim `{}` is declared twice", out.name), s.name.span, "again here")
                    .also(before.span, "first here"),
            );
        }
        self.rig.trims.push(out);
    }

    fn assume(&mut self, a: &Assume, span: Span) {
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

fn plural(n: usize) -> &'static str {
    if n == 1 { "" } else { "s" }
}

fn negative(e: Expr) -> Expr {
    match e {
        Expr::Number(x) => Expr::Number(-x),
        other => Expr::Neg(Box::new(other)),
    }
}

fn names_in(ast: &Ast) -> Vec<String> {
    match &ast.kind {
        ExprKind::Number(..) => Vec::new(),
        ExprKind::Name(n, _) => vec![n.text.clone()],
        ExprKind::Neg(a) => names_in(a),
        ExprKind::Binary(_, a, b) => [names_in(a), names_in(b)].concat(),
        ExprKind::Call(_, args) => args.iter().flat_map(names_in).collect(),
    }
}

fn symbols_in(e: &Expr, out: &mut Vec<Symbol>) {
    match e {
        Expr::Number(_) => {}
        Expr::Symbol(s) => out.push(*s),
        Expr::Neg(a) => symbols_in(a, out),
        Expr::Binary(_, a, b) => {
            symbols_in(a, out);
            symbols_in(b, out);
        }
        Expr::Call(_, args) => args.iter().for_each(|a| symbols_in(a, out)),
    }
}

fn definitions_in(e: &Expr) -> Vec<usize> {
    let mut all = Vec::new();
    symbols_in(e, &mut all);
    all.into_iter().filter_map(|s| if let Symbol::Definition(k) = s { Some(k) } else { None }).collect()
}

fn coordinates_in(e: &Expr) -> Vec<usize> {
    let mut all = Vec::new();
    symbols_in(e, &mut all);
    all.into_iter().filter_map(|s| if let Symbol::Coordinate(k) = s { Some(k) } else { None }).collect()
}

fn accelerations(e: &Expr) -> Vec<usize> {
    let mut all = Vec::new();
    symbols_in(e, &mut all);
    all.into_iter().filter_map(|s| if let Symbol::Acceleration(k) = s { Some(k) } else { None }).collect()
}

fn collect_inputs(e: &Expr, out: &mut Vec<usize>) {
    let mut all = Vec::new();
    symbols_in(e, &mut all);
    out.extend(all.into_iter().filter_map(|s| if let Symbol::Input(k) = s { Some(k) } else { None }));
}

fn renumber(e: &Expr, place: &dyn Fn(usize) -> usize) -> Expr {
    match e {
        Expr::Symbol(Symbol::Definition(k)) => Expr::Symbol(Symbol::Definition(place(*k))),
        Expr::Number(_) | Expr::Symbol(_) => e.clone(),
        Expr::Neg(a) => Expr::Neg(Box::new(renumber(a, place))),
        Expr::Binary(op, a, b) => Expr::Binary(*op, Box::new(renumber(a, place)), Box::new(renumber(b, place))),
        Expr::Call(f, args) => Expr::Call(*f, args.iter().map(|a| renumber(a, place)).collect()),
    }
}

/// Degree in the coordinates: 0, 1, 2 or more; `None` for anything that is no polynomial in them.
fn degree(e: &Expr) -> Option<u32> {
    match e {
        Expr::Number(_) => Some(0),
        Expr::Symbol(Symbol::Coordinate(_)) => Some(1),
        Expr::Symbol(_) => Some(0),
        Expr::Neg(a) => degree(a),
        Expr::Binary(op, a, b) => {
            let (x, y) = (degree(a)?, degree(b)?);
            match op {
                BinaryOp::Add | BinaryOp::Sub => Some(x.max(y)),
                BinaryOp::Mul => Some(x + y),
                BinaryOp::Div => (y == 0).then_some(x),
                BinaryOp::Pow => match (**b).clone() {
                    _ if x == 0 && y == 0 => Some(0),
                    Expr::Number(n) if n == 1.0 => Some(x),
                    _ => None,
                },
            }
        }
        Expr::Call(_, args) => args.iter().all(|a| degree(a) == Some(0)).then_some(0),
    }
}

/// Coefficients of the inputs in a linear expression.
fn linear_row(e: &Expr, inputs: &[usize]) -> Option<Vec<f64>> {
    let zero = vec![0.0; inputs.len()];
    Some(match e {
        Expr::Symbol(Symbol::Input(k)) => inputs.iter().map(|i| f64::from(u8::from(i == k))).collect(),
        Expr::Number(x) if *x == 0.0 => zero,
        Expr::Neg(a) => linear_row(a, inputs)?.iter().map(|x| -x).collect(),
        Expr::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), a, b) => {
            let (x, y) = (linear_row(a, inputs)?, linear_row(b, inputs)?);
            let sign = if *op == BinaryOp::Add { 1.0 } else { -1.0 };
            x.iter().zip(y).map(|(p, q)| p + sign * q).collect()
        }
        Expr::Binary(BinaryOp::Mul, a, b) => match (a.as_ref(), b.as_ref()) {
            (Expr::Number(k), other) | (other, Expr::Number(k)) => linear_row(other, inputs)?.iter().map(|x| k * x).collect(),
            _ => return None,
        },
        Expr::Binary(BinaryOp::Div, a, b) => match b.as_ref() {
            Expr::Number(k) => linear_row(a, inputs)?.iter().map(|x| x / k).collect(),
            _ => return None,
        },
        _ => return None,
    })
}

fn determinant(m: &[Vec<f64>]) -> f64 {
    let mut m = m.to_vec();
    let n = m.len();
    let mut det = 1.0;
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| m[a][i].abs().total_cmp(&m[b][i].abs())).unwrap_or(i);
        m.swap(i, pivot);
        if pivot != i {
            det = -det;
        }
        det *= m[i][i];
        if m[i][i] == 0.0 {
            return 0.0;
        }
        for k in i + 1..n {
            let f = m[k][i] / m[i][i];
            for j in i..n {
                m[k][j] -= f * m[i][j];
            }
        }
    }
    det
}

/// Coefficients of the accelerations: terms `k * q.ddot`, `q.ddot`, with signs.
fn mass_row(e: &Expr) -> Option<Vec<(usize, Expr)>> {
    Some(match e {
        Expr::Symbol(Symbol::Acceleration(i)) => vec![(*i, Expr::Number(1.0))],
        Expr::Neg(a) => mass_row(a)?.into_iter().map(|(i, c)| (i, negative(c))).collect(),
        Expr::Binary(BinaryOp::Add, a, b) => [mass_row(a)?, mass_row(b)?].concat(),
        Expr::Binary(BinaryOp::Sub, a, b) => {
            let right: Vec<_> = mass_row(b)?.into_iter().map(|(i, c)| (i, negative(c))).collect();
            [mass_row(a)?, right].concat()
        }
        Expr::Binary(BinaryOp::Mul, a, b) => {
            let (k, rest) = if accelerations(a).is_empty() { (a, b) } else { (b, a) };
            if !accelerations(k).is_empty() {
                return None;
            }
            mass_row(rest)?.into_iter().map(|(i, c)| (i, times(k, c))).collect()
        }
        Expr::Binary(BinaryOp::Div, a, b) if accelerations(b).is_empty() => {
            mass_row(a)?.into_iter().map(|(i, c)| (i, Expr::Binary(BinaryOp::Div, Box::new(c), b.clone()))).collect()
        }
        _ => return None,
    })
}

fn times(k: &Expr, c: Expr) -> Expr {
    if c == Expr::Number(1.0) { k.clone() } else { Expr::Binary(BinaryOp::Mul, Box::new(k.clone()), Box::new(c)) }
}

/// Whether following parents from frame k comes back to k.
fn in_circle(k: usize, list: &[(&Statement, &Name, &Vec<ast::Step>)], names: &[String]) -> bool {
    let mut at = k;
    for _ in 0..=list.len() {
        let Some(next) = names.iter().position(|n| *n == list[at].1.text) else { return false };
        if next == k {
            return true;
        }
        at = next;
    }
    false
}
