//! Paths of signals: inputs and actuators on their way in, mixes of inputs, outputs and encoders on their way out.

use super::Resolver;
use super::terms::{collect_inputs, determinant, linear_row};
use crate::ast::{Entry, Expr as Ast, Kind, Name, Statement, UnitExpr};
use crate::diagnostic::Diagnostic;
use crate::quantity::{Allowed, Checker, Quantity};
use crate::rig::*;
use crate::units::{Dimension, Unit};
use std::collections::BTreeSet;

impl Resolver<'_> {
    pub(super) fn inputs(&mut self, statements: &[Statement]) {
        for s in statements {
            if let Kind::Input(unit, limits, _) = &s.kind {
                let unit = self.checker().unit(unit);
                let index = self.rig.inputs.len();
                self.declare(&s.name, Symbol::Input(index), unit.as_ref().map(|u| u.dimension), "an input", &s.doc);
                let limits = limits.as_ref().zip(unit.as_ref()).and_then(|(l, unit)| self.limits(l, unit, "an input's range"));
                let unit = unit.unwrap_or_else(Unit::none);
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
                    let known = self.scope.names.get(&s.name.text).is_some_and(|m| m.dimension.is_some());
                    let unit = known.then(|| self.rig.inputs[i].unit.clone());
                    let index = self.rig.actuators.len();
                    let actuator = self.path(s, unit, Expr::Symbol(Symbol::Input(i)), path);
                    self.rig.actuators.push(actuator);
                    self.used.insert(Symbol::Input(i));
                    if let Some(m) = self.scope.names.get_mut(&s.name.text) {
                        m.symbol = Symbol::Actuator(index);
                    }
                }
                Kind::Actuator(unit, map, path) => {
                    let unit = self.checker().unit(unit);
                    let dimension = unit.as_ref().map(|u| u.dimension);
                    let map = self.expect(map, dimension, "this actuator", Allowed::Everything);
                    let index = self.rig.actuators.len();
                    let actuator = self.path(s, unit, map, path);
                    self.rig.actuators.push(actuator);
                    self.declare(&s.name, Symbol::Actuator(index), dimension, "an actuator", &s.doc);
                }
                _ => {}
            }
        }
    }

    fn path(&mut self, s: &Statement, unit: Option<Unit>, map: Expr, entries: &[Entry]) -> Actuator {
        let dimension = unit.as_ref().map(|u| u.dimension);
        self.entries(s, entries, &[]);
        let mut out = Actuator {
            name: s.name.text.clone(),
            doc: s.doc.clone(),
            unit: unit.unwrap_or_else(Unit::none),
            map,
            delay: None,
            dead_zone: None,
            saturation: None,
            lag: None,
            span: s.name.span,
        };
        for e in entries {
            let value = &e.values[0];
            match e.key.text.as_str() {
                "map" if s.keyword == "input" => out.map = self.expect(value, dimension, "this map", Allowed::Everything),
                "delay" => out.delay = Some(self.expect(value, Dimension::TIME, "a delay", Allowed::Parameters)),
                "lag" => out.lag = Some(self.expect(value, Dimension::TIME, "a lag's time constant", Allowed::Parameters)),
                "dead_zone" => out.dead_zone = Some(self.expect(value, dimension, "this dead zone", Allowed::Parameters)),
                "saturate" if e.values.len() == 2 => {
                    let lo = self.expect(value, dimension, "this limit", Allowed::Parameters);
                    let hi = self.expect(&e.values[1], dimension, "this limit", Allowed::Parameters);
                    out.saturation = Some((lo, hi));
                }
                _ => self.entry_error(
                    e,
                    if s.keyword == "input" {
                        "delay T, map EXPRESSION, dead_zone W, saturate LO..HI, lag TAU"
                    } else {
                        "delay T, dead_zone W, saturate LO..HI, lag TAU"
                    },
                ),
            }
        }
        out
    }

    pub(super) fn entry_error(&mut self, e: &Entry, known: &str) {
        self.diagnostics.push(
            Diagnostic::error("E0115", format!("`{}` does not fit here", e.key.text), e.key.span, "this entry")
                .help(format!("entries are {known}")),
        );
    }

    /// No entry twice, and those that are needed.
    pub(super) fn entries(&mut self, s: &Statement, entries: &[Entry], needed: &[&str]) {
        for (k, e) in entries.iter().enumerate() {
            if let Some(before) = entries[..k].iter().find(|b| b.key.text == e.key.text) {
                let d = Diagnostic::error("E0115", format!("`{}` stands twice in this block", e.key.text), e.key.span, "again here");
                self.diagnostics.push(d.also(before.key.span, "first here"));
            }
        }
        for key in needed.iter().filter(|key| !entries.iter().any(|e| e.key.text == **key)) {
            let d = Diagnostic::error("E0115", format!("the {} `{}` has no {key}", s.keyword, s.name.text), s.name.span, "this one");
            self.diagnostics.push(d.help(format!("write `{key} VALUE;` in its block")));
        }
    }

    pub(super) fn encoder_output(&mut self, s: &Statement, entry: &Entry) {
        let Some(i) = self.coordinate(&s.name) else { return };
        let mut output = plain_output(&self.rig.coordinates[i], i);
        output.encoder = self.encoder(entry, output.unit.dimension);
        output.span = s.name.span;
        self.output(output, s);
    }

    pub(super) fn declared_output(&mut self, s: &Statement, unit: &UnitExpr, value: &Ast, entries: &[Entry]) {
        let Some(unit) = self.checker().unit(unit) else { return };
        let value = self.expect(value, unit.dimension, "this output", Allowed::Motion);
        let name = s.name.text.clone();
        let mut out =
            Output { name, unit: unit.clone(), value, scale: None, bias: None, delay: None, play: None, encoder: None, span: s.name.span };
        self.entries(s, entries, &[]);
        for e in entries {
            let v = &e.values[0];
            match e.key.text.as_str() {
                "scale" => out.scale = Some(self.expect(v, Dimension::NONE, "a scale", Allowed::Parameters)),
                "bias" => out.bias = Some(self.expect(v, unit.dimension, "this bias", Allowed::Trajectory)),
                "delay" => out.delay = Some(self.expect(v, Dimension::TIME, "a delay", Allowed::Parameters)),
                "play" => out.play = Some(self.expect(v, unit.dimension, "this play", Allowed::Parameters)),
                "encoder" => out.encoder = self.encoder(e, unit.dimension),
                _ => self.entry_error(e, "scale S, bias B, delay T, play W, encoder COUNTS [zero at Z] [wrapped]"),
            }
        }
        self.output(out, s);
    }

    fn encoder_zero(&mut self, v: &Ast, dimension: Dimension) -> Expr {
        let checked = self.expect(v, dimension, "an encoder's zero", Allowed::Parameters);
        if dimension == Dimension::NONE {
            self.many_turns(v, &checked);
        }
        checked
    }

    fn mix(&mut self, rows: &[(Name, Ast)], span: Span) {
        if let Err(found) = self.mixed(rows, span) {
            self.diagnostics.extend(found);
            // what uses the mixed inputs is no second error
            self.scope.lost.extend(rows.iter().map(|(name, _)| name.text.clone()));
        }
    }

    fn mixed(&mut self, rows: &[(Name, Ast)], span: Span) -> Result<(), Option<Diagnostic>> {
        // an input is used where the mixed input is
        let mut unused = BTreeSet::new();
        let checked: Vec<Option<(&Name, Quantity, Span)>> = rows
            .iter()
            .map(|(name, ast)| Checker { used: &mut unused, ..self.checker() }.check(ast, Allowed::Inputs).map(|q| (name, q, ast.span)))
            .collect();
        let checked: Vec<(&Name, Quantity, Span)> = checked.into_iter().collect::<Option<_>>().ok_or(None)?;
        let mut inputs: Vec<usize> = Vec::new();
        for (_, q, _) in &checked {
            collect_inputs(&q.expr, &mut inputs);
        }
        inputs.sort_unstable();
        inputs.dedup();
        let mut matrix = Vec::new();
        for (_, q, place) in &checked {
            let not_linear = || {
                Diagnostic::error("E0309", "a mix is a sum of inputs times numbers", *place, "not linear in the inputs")
                    .help("write for example `f_s = f_1 + f_2;`")
            };
            matrix.push(linear_row(&q.expr, &inputs).ok_or_else(|| Some(not_linear()))?);
        }
        if matrix.len() != inputs.len() {
            let (m, n) = (matrix.len(), inputs.len());
            let message = format!(
                "{m} mixed input{} from {n} input{} cannot be undone",
                if m == 1 { "" } else { "s" },
                if n == 1 { "" } else { "s" }
            );
            return Err(Some(
                Diagnostic::error("E0309", message, span, "this mix")
                    .help("a mix has as many rows as it has inputs: `f_s = f_1 + f_2; f_d = f_1 - f_2;`"),
            ));
        }
        // relative to the size of its rows, so that the scale of the coefficients does not matter
        let size: f64 = matrix.iter().map(|row| row.iter().map(|x| x * x).sum::<f64>().sqrt()).product();
        if determinant(&matrix).abs() <= 1e-12 * size {
            let d = Diagnostic::error("E0309", "the rows of this mix are not independent: it cannot be undone", span, "this mix");
            return Err(Some(d.help("no row may be a combination of the others: `f_s = f_1 + f_2; f_d = f_1 - f_2;`")));
        }
        let index = self.rig.mixes.len();
        let mut mix = Mix { names: Vec::new(), units: Vec::new(), inputs, rows: matrix, span };
        for (row, (name, q, _)) in checked.iter().enumerate() {
            self.declare(name, Symbol::Mixed(index, row), q.dimension, "a mixed input", "");
            mix.names.push(name.text.clone());
            let first = mix.inputs.first().map_or_else(Unit::none, |&i| self.rig.inputs[i].unit.clone());
            mix.units.push(if q.dimension == Some(first.dimension) { first } else { Unit::si(q.dimension.unwrap_or_default()) });
        }
        self.rig.mixes.push(mix);
        Ok(())
    }

    pub(super) fn output(&mut self, output: Output, s: &Statement) {
        if let Some(before) = self.rig.outputs.iter().find(|o| o.name == output.name) {
            self.diagnostics.push(
                Diagnostic::error("E0202", format!("the output `{}` is declared twice", output.name), s.name.span, "again here")
                    .also(before.span, "first here"),
            );
            return;
        }
        self.rig.outputs.push(output);
    }

    pub(super) fn encoder(&mut self, entry: &Entry, dimension: Dimension) -> Option<Encoder> {
        let counts = self.constant(&entry.values[0], &Unit::none(), "an encoder's counts")?;
        if counts <= 0.0 {
            let d =
                Diagnostic::error("E0310", "an encoder has a positive number of counts", entry.values[0].span, format!("{counts} counts"));
            self.diagnostics.push(d.help("write its counts per turn (or per metre), all edges counted, as in `encoder psi: 4096;`"));
            return None;
        }
        let mut out = Encoder { counts, zero: None, wrapped: false };
        for (key, value) in &entry.options {
            match (key.text.as_str(), value) {
                ("wrapped", _) => out.wrapped = true,
                ("zero", Some(v)) => out.zero = Some(self.encoder_zero(v, dimension)),
                _ => self.diagnostics.push(
                    Diagnostic::error("E0115", format!("`{}` is no option of an encoder", key.text), key.span, "here")
                        .help("options are `zero at VALUE` and `wrapped`"),
                ),
            }
        }
        Some(out)
    }
}

pub(super) fn plain_output(c: &Coordinate, i: usize) -> Output {
    Output {
        name: c.name.clone(),
        unit: c.unit.clone(),
        value: Expr::Symbol(Symbol::Coordinate(i)),
        scale: None,
        bias: None,
        delay: None,
        play: None,
        encoder: None,
        span: c.span,
    }
}
