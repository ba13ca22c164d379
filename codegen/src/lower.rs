//! Checked expressions onto the graph: names become symbols, functions become nodes.

use crate::expr::{F1, F2, Graph, Id, SymbolId, SymbolKind};
use model_dsl::rig::{AssumptionKind, BinaryOp, Expr, Function, Rig, Symbol};

/// What to do with a `lump` that has a value of its own.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Lumps {
    /// It is a parameter.
    #[default]
    AsParameters,
    /// Its definition stands in its place.
    Expanded,
}

/// The symbols of a rig on a graph, and the nodes that its names stand for.
pub struct Lowering {
    /// Coordinates.
    pub q: Vec<SymbolId>,
    /// Rates.
    pub v: Vec<SymbolId>,
    /// Accelerations, as arguments of inverse dynamics.
    pub a: Vec<SymbolId>,
    /// Actuator states.
    pub z: Vec<SymbolId>,
    /// Signals: inputs, then exogenous accelerations.
    pub u: Vec<SymbolId>,
    /// Parameters.
    pub p: Vec<SymbolId>,
    /// Time.
    pub t: SymbolId,
    /// For each coordinate, the signal or trajectory acceleration that prescribes it.
    pub prescribed: Vec<Option<Id>>,
    time: Id,
    parameters: Vec<Id>,
    definitions: Vec<Id>,
    coordinates: Vec<Id>,
    rates: Vec<Id>,
    inputs: Vec<Id>,
    /// What comes out of each actuator: its state, or its map.
    actuators: Vec<Id>,
    /// What goes into each actuator's lag.
    commands: Vec<Id>,
    mixes: Vec<Vec<Id>>,
}

impl Lowering {
    /// Makes all symbols of a rig. `set` assumptions put numbers in place of parameters.
    pub fn new(rig: &Rig, lumps: Lumps, apply_assumptions: bool, g: &mut Graph) -> Self {
        let symbol_id = |g: &Graph, id: Id| g.symbol_of(id).expect("a symbol was just made");
        let time = g.symbol("t", SymbolKind::Time);
        let coordinates: Vec<Id> = rig.coordinates.iter().enumerate().map(|(i, c)| g.symbol(&c.name, SymbolKind::Coordinate(i))).collect();
        let rates: Vec<Id> =
            rig.coordinates.iter().enumerate().map(|(i, c)| g.symbol(&format!("{}.dot", c.name), SymbolKind::Rate(i))).collect();
        let accelerations: Vec<Id> =
            rig.coordinates.iter().enumerate().map(|(i, c)| g.symbol(&format!("{}.ddot", c.name), SymbolKind::Acceleration(i))).collect();
        let inputs: Vec<Id> = rig.inputs.iter().enumerate().map(|(i, input)| g.symbol(&input.name, SymbolKind::Signal(i))).collect();
        let mut signals = inputs.clone();
        let exogenous: Vec<Option<Id>> = rig
            .coordinates
            .iter()
            .map(|c| {
                (c.prescribed && c.trajectory.is_none()).then(|| {
                    let id = g.symbol(&format!("{}.ddot", c.name), SymbolKind::Signal(signals.len()));
                    signals.push(id);
                    id
                })
            })
            .collect();
        let parameter_symbols: Vec<Id> =
            rig.parameters.iter().enumerate().map(|(i, p)| g.symbol(&p.name, SymbolKind::Parameter(i))).collect();
        let mut parameters = parameter_symbols.clone();
        if apply_assumptions {
            for assumption in &rig.assumptions {
                if let AssumptionKind::Set { parameter, value } = assumption.kind {
                    parameters[parameter] = g.num(value);
                }
            }
        }
        let mut lowering = Self {
            q: coordinates.iter().map(|&id| symbol_id(g, id)).collect(),
            v: rates.iter().map(|&id| symbol_id(g, id)).collect(),
            a: accelerations.iter().map(|&id| symbol_id(g, id)).collect(),
            z: Vec::new(),
            u: signals.iter().map(|&id| symbol_id(g, id)).collect(),
            p: parameter_symbols.iter().map(|&id| symbol_id(g, id)).collect(),
            t: symbol_id(g, time),
            prescribed: exogenous,
            time,
            parameters,
            definitions: Vec::new(),
            coordinates,
            rates,
            inputs,
            actuators: Vec::new(),
            commands: Vec::new(),
            mixes: Vec::new(),
        };
        for definition in &rig.definitions {
            let id = match (definition.parameter, lumps) {
                (Some(parameter), Lumps::AsParameters) => lowering.parameters[parameter],
                _ => {
                    let id = lowering.expr(g, &definition.value);
                    g.label(id, definition.name.clone());
                    id
                }
            };
            lowering.definitions.push(id);
        }
        // an actuator's map reads commands; what is written with a mixed input acts by what actuators deliver
        lowering.lower_mixes(rig, g, &lowering.inputs.clone());
        lowering.lower_actuators(rig, g);
        if rig.inputs.iter().any(|input| rig.actuators.iter().any(|a| a.name == input.name)) {
            let delivered: Vec<Id> = rig
                .inputs
                .iter()
                .zip(&lowering.inputs)
                .map(|(input, &command)| rig.actuators.iter().position(|a| a.name == input.name).map_or(command, |i| lowering.actuators[i]))
                .collect();
            lowering.mixes.clear();
            lowering.lower_mixes(rig, g, &delivered);
        }
        for (i, coordinate) in rig.coordinates.iter().enumerate() {
            if let Some(trajectory) = &coordinate.trajectory {
                let s = lowering.expr(g, trajectory);
                let rate = g.differentiate(&[s], lowering.t, crate::expr::Derivative::Exact)[0];
                let acceleration = g.differentiate(&[rate], lowering.t, crate::expr::Derivative::Exact)[0];
                lowering.prescribed[i] = Some(acceleration);
            }
        }
        lowering
    }

    fn lower_mixes(&mut self, rig: &Rig, g: &mut Graph, inputs: &[Id]) {
        for mix in &rig.mixes {
            let row = |g: &mut Graph, row: &Vec<f64>| {
                let terms: Vec<Id> = row
                    .iter()
                    .zip(&mix.inputs)
                    .map(|(&k, &input)| {
                        let k = g.num(k);
                        g.mul(k, inputs[input])
                    })
                    .collect();
                g.sum(&terms)
            };
            let values: Vec<Id> = mix.rows.iter().map(|r| row(g, r)).collect();
            for (value, name) in values.iter().zip(&mix.names) {
                g.label(*value, name.clone());
            }
            self.mixes.push(values);
        }
    }

    fn lower_actuators(&mut self, rig: &Rig, g: &mut Graph) {
        for actuator in &rig.actuators {
            let mut command = self.expr(g, &actuator.map);
            if let Some(width) = &actuator.dead_zone {
                let width = self.expr(g, width);
                command = dead_zone(g, command, width);
            }
            if let Some((lo, hi)) = &actuator.saturation {
                let (lo, hi) = (self.expr(g, lo), self.expr(g, hi));
                command = saturate(g, command, lo, hi);
            }
            self.commands.push(command);
            let out = match actuator.lag {
                Some(_) => {
                    let id = g.symbol(&format!("{}.lag", actuator.name), SymbolKind::Lag(self.z.len()));
                    self.z.extend(g.symbol_of(id));
                    id
                }
                None => {
                    g.label(command, actuator.name.clone());
                    command
                }
            };
            self.actuators.push(out);
        }
    }

    /// Rates of the actuator states: (w - z) / tau.
    pub fn lag_rates(&self, rig: &Rig, g: &mut Graph) -> Vec<Id> {
        let mut rates = Vec::new();
        for (i, actuator) in rig.actuators.iter().enumerate() {
            if let Some(tau) = &actuator.lag {
                let tau = self.expr(g, tau);
                let gap = g.sub(self.commands[i], self.actuators[i]);
                rates.push(g.div(gap, tau));
            }
        }
        rates
    }

    /// Node of a symbol.
    fn symbol(&self, symbol: Symbol) -> Id {
        match symbol {
            Symbol::Time => self.time,
            Symbol::Parameter(i) => self.parameters[i],
            Symbol::Definition(i) => self.definitions[i],
            Symbol::Coordinate(i) => self.coordinates[i],
            Symbol::Rate(i) => self.rates[i],
            // only prescribed accelerations stand in expressions of a checked rig
            Symbol::Acceleration(i) => self.prescribed[i].unwrap_or(self.coordinates[i]),
            Symbol::Input(i) => self.inputs[i],
            Symbol::Actuator(i) => self.actuators[i],
            Symbol::Mixed(mix, row) => self.mixes[mix][row],
        }
    }

    /// Nodes of the rates.
    #[must_use]
    pub fn rates(&self) -> &[Id] {
        &self.rates
    }

    /// Puts a checked expression onto the graph.
    pub fn expr(&self, g: &mut Graph, expr: &Expr) -> Id {
        match expr {
            Expr::Number(x) => g.num(*x),
            Expr::Symbol(s) => self.symbol(*s),
            Expr::Neg(a) => {
                let a = self.expr(g, a);
                g.neg(a)
            }
            Expr::Binary(op, a, b) => {
                let (a, b) = (self.expr(g, a), self.expr(g, b));
                match op {
                    BinaryOp::Add => g.add(a, b),
                    BinaryOp::Sub => g.sub(a, b),
                    BinaryOp::Mul => g.mul(a, b),
                    BinaryOp::Div => g.div(a, b),
                    BinaryOp::Pow => g.call2(F2::Pow, a, b),
                }
            }
            Expr::Call(f, args) => {
                let args: Vec<Id> = args.iter().map(|a| self.expr(g, a)).collect();
                call(g, *f, &args)
            }
        }
    }
}

fn call(g: &mut Graph, f: Function, args: &[Id]) -> Id {
    let one = |g: &mut Graph, f: F1| g.call(f, args[0]);
    match f {
        Function::Sin => one(g, F1::Sin),
        Function::Cos => one(g, F1::Cos),
        Function::Tan => one(g, F1::Tan),
        Function::Asin => one(g, F1::Asin),
        Function::Acos => one(g, F1::Acos),
        Function::Atan => one(g, F1::Atan),
        Function::Sinh => one(g, F1::Sinh),
        Function::Cosh => one(g, F1::Cosh),
        Function::Tanh => one(g, F1::Tanh),
        Function::Exp => one(g, F1::Exp),
        Function::Ln => one(g, F1::Ln),
        Function::Sqrt => one(g, F1::Sqrt),
        Function::Abs => one(g, F1::Abs),
        Function::Sign => one(g, F1::Sign),
        Function::Atan2 => g.call2(F2::Atan2, args[0], args[1]),
        Function::Min => g.call2(F2::Min, args[0], args[1]),
        Function::Max => g.call2(F2::Max, args[0], args[1]),
        Function::Saturate => saturate(g, args[0], args[1], args[2]),
        Function::DeadZone => dead_zone(g, args[0], args[1]),
    }
}

/// min(max(x, lo), hi)
fn saturate(g: &mut Graph, x: Id, lo: Id, hi: Id) -> Id {
    let above = g.call2(F2::Max, x, lo);
    g.call2(F2::Min, above, hi)
}

/// x - saturate(x, -w, w)
fn dead_zone(g: &mut Graph, x: Id, w: Id) -> Id {
    let minus = g.neg(w);
    let held = saturate(g, x, minus, w);
    g.sub(x, held)
}
