//! The declared rig as JSON: what the user wrote, resolved to names and SI, before any derivation.
//!
//! Knows the checked rig only and takes nothing from the derivation, so that another program (the CasADi
//! oracle, a reader of exports) can derive the equations by itself. The format is described in
//! `docs/declared-json.md`; [`FORMAT`] changes when the meaning of a field does.

use model_dsl::rig::{
    Actuator, Along, AssumptionKind, Axis, BinaryOp, Body, Coordinate, EnergyKind, Expr, Force, ForceKind, Frame, FrameRef, Friction,
    Function, InertiaPoint, Output, Parameter, Rig, Step, Symbol, Trim,
};
use serde_json::{Map, Value, json};

/// Version of the format.
pub const FORMAT: u32 = 1;

/// The declared rig; numbers in SI and radians, expressions as small trees.
#[must_use]
pub fn declared(rig: &Rig) -> Value {
    let w = Writer { rig };
    json!({
        "format": FORMAT,
        "rig": rig.name,
        "parameters": rig.parameters.iter().map(|p| w.parameter(p)).collect::<Vec<_>>(),
        "definitions": rig.definitions.iter().map(|d| json!({
            "name": d.name, "unit": d.unit.text, "value": w.expr(&d.value), "lump": d.is_lump,
            "parameter": d.parameter.map(|i| rig.parameters[i].name.as_str()),
        })).collect::<Vec<_>>(),
        "coordinates": rig.coordinates.iter().map(|c| w.coordinate(c)).collect::<Vec<_>>(),
        "inputs": rig.inputs.iter().map(|i| json!({ "name": i.name, "unit": i.unit.text, "limits": pair(i.limits) })).collect::<Vec<_>>(),
        "actuators": rig.actuators.iter().map(|a| w.actuator(a)).collect::<Vec<_>>(),
        "mixes": rig.mixes.iter().map(|m| json!({
            "names": m.names, "inputs": m.inputs.iter().map(|&i| rig.inputs[i].name.as_str()).collect::<Vec<_>>(), "rows": m.rows,
        })).collect::<Vec<_>>(),
        "frames": rig.frames.iter().map(|f| w.frame_of(f)).collect::<Vec<_>>(),
        "bodies": rig.bodies.iter().map(|b| w.body(b)).collect::<Vec<_>>(),
        "gravity": rig.gravity.as_ref().map(|g| w.exprs(&g.acceleration)),
        "forces": rig.forces.iter().map(|f| w.force(f)).collect::<Vec<_>>(),
        "springs": rig.springs.iter().map(|s| json!({
            "name": s.name, "along": w.along(&s.along), "stiffness": w.expr(&s.stiffness), "rest": w.expr(&s.rest), "cubic": w.expr(&s.cubic),
        })).collect::<Vec<_>>(),
        "frictions": rig.frictions.iter().map(|f| w.friction(f)).collect::<Vec<_>>(),
        "dampers": rig.dampers.iter().map(|d| json!({
            "name": d.name, "along": w.along(&d.along), "viscous": w.expr(&d.viscous),
        })).collect::<Vec<_>>(),
        "functions": rig.functions.iter().map(|f| json!({
            "name": f.name, "value": w.expr(&f.value),
            "kind": match f.kind { EnergyKind::Potential => "potential", EnergyKind::Kinetic => "kinetic", EnergyKind::Dissipation => "dissipation" },
        })).collect::<Vec<_>>(),
        "equations": rig.equations.iter().map(|e| json!({
            "coordinate": rig.coordinates[e.coordinate].name,
            "mass": e.mass.iter().map(|(i, k)| json!({ "coordinate": rig.coordinates[*i].name, "coefficient": w.expr(k) })).collect::<Vec<_>>(),
            "rhs": w.expr(&e.rhs),
        })).collect::<Vec<_>>(),
        "outputs": rig.outputs.iter().map(|o| w.output(o)).collect::<Vec<_>>(),
        "trims": rig.trims.iter().map(|t| w.trim(t)).collect::<Vec<_>>(),
        "assumptions": rig.assumptions.iter().map(|a| w.assumption(&a.kind)).collect::<Vec<_>>(),
    })
}

/// Fingerprint of a declared rig: FNV-1a (64 bits, 16 hex digits) over its compact text.
#[must_use]
pub fn declared_fingerprint(declared: &Value) -> String {
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for byte in declared.to_string().bytes() {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    }
    format!("{hash:016x}")
}

struct Writer<'a> {
    rig: &'a Rig,
}

impl Writer<'_> {
    fn parameter(&self, p: &Parameter) -> Value {
        json!({
            "name": p.name, "unit": p.unit.text, "value": p.value, "prior_sd": p.prior_sd, "bounds": pair(p.bounds),
            "fixed": p.fixed, "constant": p.constant, "per_record": p.per_record,
        })
    }

    fn coordinate(&self, c: &Coordinate) -> Value {
        json!({
            "name": c.name, "unit": c.unit.text, "range": pair(c.range), "prescribed": c.prescribed, "trajectory": self.maybe(c.trajectory.as_ref()),
        })
    }

    fn actuator(&self, a: &Actuator) -> Value {
        json!({
            "name": a.name, "unit": a.unit.text, "map": self.expr(&a.map), "delay": self.maybe(a.delay.as_ref()),
            "dead_zone": self.maybe(a.dead_zone.as_ref()),
            "saturation": a.saturation.as_ref().map(|(lo, hi)| json!([self.expr(lo), self.expr(hi)])),
            "lag": self.maybe(a.lag.as_ref()),
        })
    }

    fn frame_of(&self, f: &Frame) -> Value {
        let steps: Vec<Value> = f
            .steps
            .iter()
            .map(|step| match step {
                Step::Rotate { axis, angle } => json!({ "rotate": axis_vector(*axis), "angle": self.expr(angle) }),
                Step::Translate(offset) => json!({ "translate": self.exprs(offset) }),
            })
            .collect();
        json!({ "name": f.name, "parent": self.frame(f.parent), "steps": steps })
    }

    fn body(&self, b: &Body) -> Value {
        let about = match b.about {
            InertiaPoint::CenterOfMass => "center_of_mass",
            InertiaPoint::FrameOrigin => "frame_origin",
        };
        json!({
            "name": b.name, "frame": self.frame(b.frame), "mass": self.expr(&b.mass), "center": self.exprs(&b.center),
            "inertia": self.exprs(&b.inertia), "about": about,
        })
    }

    fn force(&self, f: &Force) -> Value {
        let reaction = |against: &Option<FrameRef>| against.map(|a| self.frame(a));
        match &f.kind {
            ForceKind::Force { frame, point, vector, axes, against } => json!({
                "name": f.name, "kind": "force", "frame": self.frame(*frame), "point": self.exprs(point), "vector": self.exprs(vector),
                "axes": self.frame(*axes), "against": reaction(against),
            }),
            ForceKind::Torque { frame, vector, axes, against } => json!({
                "name": f.name, "kind": "torque", "frame": self.frame(*frame), "vector": self.exprs(vector), "axes": self.frame(*axes),
                "against": reaction(against),
            }),
            ForceKind::Generalized { coordinate, value } => json!({
                "name": f.name, "kind": "generalized", "coordinate": self.rig.coordinates[*coordinate].name, "value": self.expr(value),
            }),
        }
    }

    fn along(&self, along: &Along) -> Value {
        let point = |(frame, p): &(FrameRef, [Expr; 3])| json!({ "frame": self.frame(*frame), "point": self.exprs(p) });
        match along {
            Along::Coordinate(e) => json!({ "of": self.expr(e) }),
            Along::Points { from, to } => json!({ "from": point(from), "to": point(to) }),
        }
    }

    fn friction(&self, f: &Friction) -> Value {
        let two = |p: &Option<(Expr, Expr)>| p.as_ref().map(|(a, b)| json!([self.expr(a), self.expr(b)]));
        json!({
            "name": f.name, "of": self.expr(&f.of), "viscous": self.maybe(f.viscous.as_ref()), "coulomb": self.maybe(f.coulomb.as_ref()),
            "width": self.maybe(f.width.as_ref()), "stribeck": two(&f.stribeck), "quadratic": self.maybe(f.quadratic.as_ref()),
            "asymmetric": two(&f.asymmetric),
        })
    }

    fn output(&self, o: &Output) -> Value {
        let mut output = json!({
            "name": o.name, "unit": o.unit.text, "value": self.expr(&o.value), "scale": self.maybe(o.scale.as_ref()),
            "bias": self.maybe(o.bias.as_ref()), "delay": self.maybe(o.delay.as_ref()),
            "encoder": o.encoder.as_ref().map(|e| json!({ "counts": e.counts, "zero": self.maybe(e.zero.as_ref()), "wrapped": e.wrapped })),
        });
        // not null without one: the fingerprint of a rig that has no play stays what it was
        if let Some(play) = &o.play {
            output["play"] = self.expr(play);
        }
        output
    }

    fn trim(&self, t: &Trim) -> Value {
        json!({
            "name": t.name,
            "fixed": t.fixed.iter().map(|(s, value)| json!({ "of": self.symbol(*s), "value": self.expr(value) })).collect::<Vec<_>>(),
            "zero": self.rows(&t.zero),
            "solve": t.solve.iter().map(|s| self.symbol(*s)).collect::<Vec<_>>(),
        })
    }

    fn assumption(&self, kind: &AssumptionKind) -> Value {
        let rows = |rows: &Option<Vec<usize>>| rows.as_ref().map(|r| self.rows(r));
        match kind {
            AssumptionKind::Set { parameter, value } => json!({ "set": self.rig.parameters[*parameter].name, "value": value }),
            AssumptionKind::NeglectCoriolis { rows: r } => json!({ "neglect": "coriolis", "rows": rows(r) }),
            AssumptionKind::NeglectGravity { bodies, rows: r } => {
                let bodies = bodies.as_ref().map(|list| list.iter().map(|&k| self.rig.bodies[k].name.as_str()).collect::<Vec<_>>());
                json!({ "neglect": "gravity", "bodies": bodies, "rows": rows(r) })
            }
            AssumptionKind::NeglectFriction { rows: r } => json!({ "neglect": "friction", "rows": rows(r) }),
            AssumptionKind::NeglectTerm { name, rows: r } => json!({ "neglect": "term", "name": name, "rows": rows(r) }),
            AssumptionKind::NeglectInertia { row, column } => json!({ "neglect": "inertia", "entry": self.rows(&[*row, *column]) }),
            AssumptionKind::InertiaDiagonal(entries) => json!({ "inertia_diagonal": self.exprs(entries) }),
        }
    }

    fn rows(&self, rows: &[usize]) -> Vec<&str> {
        rows.iter().map(|&i| self.rig.coordinates[i].name.as_str()).collect()
    }

    fn frame(&self, frame: FrameRef) -> &str {
        match frame {
            FrameRef::Ground => "ground",
            FrameRef::Frame(i) => &self.rig.frames[i].name,
        }
    }

    fn maybe(&self, e: Option<&Expr>) -> Value {
        e.map_or(Value::Null, |e| self.expr(e))
    }

    fn exprs(&self, list: &[Expr]) -> Value {
        list.iter().map(|e| self.expr(e)).collect()
    }

    fn symbol(&self, symbol: Symbol) -> Value {
        let rig = self.rig;
        let (key, name) = match symbol {
            Symbol::Time => return json!("t"),
            Symbol::Parameter(i) => ("param", &rig.parameters[i].name),
            Symbol::Definition(i) => ("definition", &rig.definitions[i].name),
            Symbol::Coordinate(i) => ("coord", &rig.coordinates[i].name),
            Symbol::Rate(i) => ("rate", &rig.coordinates[i].name),
            Symbol::Acceleration(i) => ("accel", &rig.coordinates[i].name),
            Symbol::Input(i) => ("input", &rig.inputs[i].name),
            Symbol::Actuator(i) => ("actuator", &rig.actuators[i].name),
            Symbol::Mixed(i, row) => ("mix", &rig.mixes[i].names[row]),
        };
        Value::Object(Map::from_iter([(key.to_owned(), json!(name))]))
    }

    fn expr(&self, e: &Expr) -> Value {
        match e {
            Expr::Number(x) => json!(x),
            Expr::Symbol(s) => self.symbol(*s),
            Expr::Neg(a) => json!(["neg", self.expr(a)]),
            Expr::Binary(op, a, b) => {
                let op = match op {
                    BinaryOp::Add => "+",
                    BinaryOp::Sub => "-",
                    BinaryOp::Mul => "*",
                    BinaryOp::Div => "/",
                    BinaryOp::Pow => "^",
                };
                json!([op, self.expr(a), self.expr(b)])
            }
            Expr::Call(f, args) => {
                let mut list = vec![json!(function_name(*f))];
                list.extend(args.iter().map(|a| self.expr(a)));
                Value::Array(list)
            }
        }
    }
}

fn pair(limits: Option<(f64, f64)>) -> Value {
    limits.map_or(Value::Null, |(lo, hi)| json!([lo, hi]))
}

fn axis_vector(axis: Axis) -> [f64; 3] {
    match axis {
        Axis::Principal { index, negative } => std::array::from_fn(|k| match (k == index, negative) {
            (false, _) => 0.0,
            (true, false) => 1.0,
            (true, true) => -1.0,
        }),
        Axis::Vector(v) => v,
    }
}

fn function_name(f: Function) -> &'static str {
    match f {
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Asin => "asin",
        Function::Acos => "acos",
        Function::Atan => "atan",
        Function::Atan2 => "atan2",
        Function::Sinh => "sinh",
        Function::Cosh => "cosh",
        Function::Tanh => "tanh",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Sqrt => "sqrt",
        Function::Abs => "abs",
        Function::Sign => "sign",
        Function::Min => "min",
        Function::Max => "max",
        Function::Saturate => "saturate",
        Function::DeadZone => "dead_zone",
    }
}
