//! Paths of signals: inputs and actuators on their way in, mixes of inputs, outputs and encoders on their way out.

use super::Resolver;
use super::terms::{collect_inputs, determinant, linear_row};
use crate::ast::{Entry, Expr as Ast, Kind, Name, Statement};
use crate::diagnostic::Diagnostic;
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::{Dimension, Unit};

impl Resolver<'_> {
    pub(super) fn inputs(&mut self, statements: &[Statement]) {
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

    pub(super) fn path(&mut self, name: &Name, doc: &str, unit: Unit, map: Expr, entries: &[Entry]) -> Actuator {
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

    pub(super) fn entry_error(&mut self, e: &Entry, known: &str) {
        self.diagnostics.push(
            Diagnostic::error("E0115", format!("`{}` does not fit here", e.key.text), e.key.span, "this entry")
                .help(format!("entries are {known}")),
        );
    }

    pub(super) fn mix(&mut self, rows: &[(Name, Ast)], span: Span) {
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
}

pub(super) fn plain_output(c: &Coordinate, i: usize) -> Output {
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
