//! Forward dynamics by L^T D L, and every Jacobian by the implicit formula
//! d a / d x = -M^-1 d(ID)/dx, ID = M a + bias + dissipation - Q, reusing the factor.

use super::parts::Parts;
use super::{Options, fingerprint};
use crate::equations::{CrossCheck, Equations, Layout, Linear, OutputPath};
use crate::expr::{Derivative, Differentiable, F1, Graph, Id, Node, SymbolId};
use crate::lower::Lowering;
use crate::mechanics::solve::{Factor, factor};
use model_dsl::rig::{ForceKind, FrameRef, Rig};

/// Completes the equations from the parts.
pub fn complete(
    rig: &Rig,
    lowering: &Lowering,
    mut graph: Graph,
    layout: Layout,
    parts: Parts,
    options: Options,
    cross_check: CrossCheck,
) -> Equations {
    let g = &mut graph;
    let n = rig.coordinates.len();
    let free: Vec<usize> = (0..n).filter(|&i| !rig.coordinates[i].prescribed).collect();
    let names: Vec<String> = free.iter().map(|&i| rig.coordinates[i].name.clone()).collect();

    for (what, values) in [("g", &parts.gravity), ("h", &parts.bias), ("d", &parts.dissipation), ("Q", &parts.force)] {
        for (c, &value) in rig.coordinates.iter().zip(values) {
            g.label(value, format!("{what}_{}", c.name));
        }
    }

    // forward dynamics: M_FF a_F = -(M_FS a_S + bias + dissipation - Q)_F
    let zero = g.zero();
    let given: Vec<Id> = lowering.prescribed.iter().map(|p| p.unwrap_or(zero)).collect();
    let rest = residual(rig, lowering, g, &parts, &given);
    let m: Vec<Vec<Id>> = free.iter().map(|&i| free.iter().map(|&j| parts.mass_matrix[i][j]).collect()).collect();
    for (i, row) in m.iter().enumerate() {
        for (j, &entry) in row.iter().enumerate().skip(i) {
            g.label(entry, format!("M_{}_{}", names[i], names[j]));
        }
    }
    let right: Vec<Id> = free.iter().map(|&i| g.neg(rest[i])).collect();
    for (name, &r) in names.iter().zip(&right) {
        g.label(r, format!("tau_{name}"));
    }
    let factored = factor(g, &m, &names);
    let solved = factored.solve(g, &right);
    let mut acceleration = given;
    for (&i, &a) in free.iter().zip(&solved) {
        g.label(a, format!("{}_ddot", rig.coordinates[i].name));
        acceleration[i] = a;
    }

    // inverse dynamics over the symbols of the accelerations
    let wanted: Vec<Id> = rig
        .coordinates
        .iter()
        .enumerate()
        .map(|(i, c)| g.symbol(&format!("{}.ddot", c.name), crate::expr::SymbolKind::Acceleration(i)))
        .collect();
    let inverse_dynamics = residual(rig, lowering, g, &parts, &wanted);

    let lag_rates = lowering.lag_rates(rig, g);
    let outputs = outputs(rig, lowering, g);
    g.set_scope("input_map");
    let input_map = g.jacobian(&parts.force, &lowering.u, Derivative::Exact);
    let x: Vec<SymbolId> = layout.x().map(|v| v.symbol).collect();

    let mut linear = Linear { a: Vec::new(), b: Vec::new() };
    let mut linear_without_friction_slope = None;
    let (mut parameter_jacobian, mut output_jacobian, mut output_parameter_jacobian) = (Vec::new(), Vec::new(), Vec::new());
    if options.jacobians {
        let context = Implicit {
            free: &free,
            factored: &factored,
            inverse_dynamics: &inverse_dynamics,
            acceleration: &acceleration,
            lag_rates: &lag_rates,
            lowering,
        };
        linear = Linear { a: context.columns(g, &x, Derivative::Exact), b: context.columns(g, &lowering.u, Derivative::Exact) };
        let regularized = g.reachable(&parts.dissipation).into_iter().any(|id| matches!(g.node(id), Node::Call(F1::SmoothSign, _)));
        if regularized {
            linear_without_friction_slope = Some(Linear {
                a: context.columns(g, &x, Derivative::WithoutFrictionSlope),
                b: context.columns(g, &lowering.u, Derivative::WithoutFrictionSlope),
            });
        }
        parameter_jacobian = context.columns(g, &lowering.p, Derivative::Exact);
        output_jacobian = g.jacobian(&outputs, &x, Derivative::Exact);
        output_parameter_jacobian = g.jacobian(&outputs, &lowering.p, Derivative::Exact);
    }

    let trajectories = rig
        .coordinates
        .iter()
        .enumerate()
        .filter_map(|(i, c)| {
            let s = lowering.expr(g, c.trajectory.as_ref()?);
            let rate = g.differentiate(&[s], lowering.t, Derivative::Exact)[0];
            Some((i, s, rate))
        })
        .collect();
    let input_paths = rig
        .inputs
        .iter()
        .enumerate()
        .map(|(i, input)| {
            let delay = rig.actuators.iter().find(|a| a.delay.is_some() && reads(&a.map, i)).and_then(|a| a.delay.as_ref());
            (input.limits, delay.map_or(zero, |d| lowering.expr(g, d)))
        })
        .collect();
    let output_paths = rig
        .outputs
        .iter()
        .map(|o| {
            let delay = o.delay.as_ref().map_or(zero, |d| lowering.expr(g, d));
            let play = o.play.as_ref().map_or(zero, |w| lowering.expr(g, w));
            let (quantum, wrapped) = o.encoder.as_ref().map_or((0.0, false), |e| {
                let turn = if o.unit.text == "m" { 1.0 } else { std::f64::consts::TAU };
                (turn / e.counts, e.wrapped)
            });
            OutputPath { delay, play, quantum, wrapped }
        })
        .collect();

    let mut roots: Vec<Id> = acceleration.iter().chain(&lag_rates).chain(&outputs).copied().collect();
    roots.extend(parts.mass_matrix.iter().flatten().chain(&parts.bias).chain(&parts.force));
    let hash = fingerprint(g, &layout, &roots);
    Equations {
        layout,
        lumps: options.lumps,
        mass_matrix: parts.mass_matrix,
        bias: parts.bias,
        coriolis: parts.coriolis,
        gravity: parts.gravity,
        springs: parts.springs,
        dissipation: parts.dissipation,
        force: parts.force,
        input_map,
        lag_rates,
        outputs,
        kinetic: parts.kinetic,
        potential: parts.potential,
        free,
        acceleration,
        pivots: factored.pivots,
        inverse_dynamics,
        linear,
        linear_without_friction_slope,
        parameter_jacobian,
        output_jacobian,
        output_parameter_jacobian,
        trajectories,
        input_paths,
        output_paths,
        assumptions: parts.assumptions,
        scopes: scopes(rig),
        cross_check,
        hash,
        graph,
    }
}

/// M a + bias + dissipation - Q for given accelerations, on the tree where no assumption intervened.
fn residual(rig: &Rig, lowering: &Lowering, g: &mut Graph, parts: &Parts, acceleration: &[Id]) -> Vec<Id> {
    let mut total = match &parts.body_road {
        Some(road) => {
            let mut total = road.residual(rig, lowering, g, acceleration);
            g.set_scope("balance");
            for (value, &spring) in total.iter_mut().zip(&parts.springs) {
                *value = g.add(*value, spring);
            }
            total
        }
        None => {
            g.set_scope("balance");
            (0..parts.bias.len())
                .map(|i| {
                    let mut value = parts.bias[i];
                    for (j, &a) in acceleration.iter().enumerate() {
                        let part = g.mul(parts.mass_matrix[i][j], a);
                        value = g.add(value, part);
                    }
                    g.sub(value, parts.force[i])
                })
                .collect()
        }
    };
    for (value, &d) in total.iter_mut().zip(&parts.dissipation) {
        *value = g.add(*value, d);
    }
    total
}

/// What frames, bodies and forces are, for comments in emitted code.
fn scopes(rig: &Rig) -> Vec<(String, String)> {
    let frame = |f: FrameRef| match f {
        FrameRef::Ground => "ground".to_owned(),
        FrameRef::Frame(i) => rig.frames[i].name.clone(),
    };
    let with_doc = |words: String, doc: &str| match doc.lines().next().filter(|d| !d.is_empty()) {
        Some(doc) => format!("{words}: {doc}"),
        None => words,
    };
    let mut scopes = Vec::new();
    for f in &rig.frames {
        let words = with_doc(format!("frame {} on {}", f.name, frame(f.parent)), &f.doc);
        scopes.extend((1..f.steps.len()).map(|k| (format!("{}_{k}", f.name), words.clone())));
        scopes.push((f.name.clone(), words));
    }
    for b in &rig.bodies {
        scopes.push((b.name.clone(), with_doc(format!("body {} on {}", b.name, frame(b.frame)), &b.doc)));
    }
    for f in &rig.forces {
        let words = match &f.kind {
            ForceKind::Force { frame: on, .. } => format!("force {} on {}", f.name, frame(*on)),
            ForceKind::Torque { frame: on, .. } => format!("torque {} on {}", f.name, frame(*on)),
            ForceKind::Generalized { coordinate, .. } => format!("torque {} on {}", f.name, rig.coordinates[*coordinate].name),
        };
        scopes.push((f.name.clone(), with_doc(words, &f.doc)));
    }
    scopes.extend(rig.frictions.iter().map(|f| (format!("friction_{}", f.name), format!("friction of {}", f.name))));
    scopes.extend(rig.springs.iter().map(|s| (s.name.clone(), format!("spring {}", s.name))));
    scopes.extend(rig.dampers.iter().map(|d| (d.name.clone(), format!("damper {}", d.name))));
    scopes.extend(rig.functions.iter().map(|f| (f.name.clone(), format!("{} energy {}", format!("{:?}", f.kind).to_lowercase(), f.name))));
    scopes.extend(
        rig.equations.iter().map(|q| &rig.coordinates[q.coordinate].name).map(|name| (name.clone(), format!("equation of {name}"))),
    );
    scopes
}

/// y = scale * value + bias, an encoder's zero subtracted.
fn outputs(rig: &Rig, lowering: &Lowering, g: &mut Graph) -> Vec<Id> {
    rig.outputs
        .iter()
        .map(|o| {
            g.set_scope(o.name.clone());
            let mut y = lowering.expr(g, &o.value);
            if let Some(scale) = &o.scale {
                let scale = lowering.expr(g, scale);
                y = g.mul(scale, y);
            }
            if let Some(bias) = &o.bias {
                let bias = lowering.expr(g, bias);
                y = g.add(y, bias);
            }
            if let Some(zero) = o.encoder.as_ref().and_then(|e| e.zero.as_ref()) {
                let zero = lowering.expr(g, zero);
                y = g.sub(y, zero);
            }
            y
        })
        .collect()
}

fn reads(expr: &model_dsl::rig::Expr, input: usize) -> bool {
    use model_dsl::rig::{Expr, Symbol};
    match expr {
        Expr::Number(_) => false,
        Expr::Symbol(s) => *s == Symbol::Input(input),
        Expr::Neg(a) => reads(a, input),
        Expr::Binary(_, a, b) => reads(a, input) || reads(b, input),
        Expr::Call(_, args) => args.iter().any(|a| reads(a, input)),
    }
}

struct Implicit<'a> {
    free: &'a [usize],
    factored: &'a Factor,
    inverse_dynamics: &'a [Id],
    acceleration: &'a [Id],
    lag_rates: &'a [Id],
    lowering: &'a Lowering,
}

impl Implicit<'_> {
    /// d x' / d symbols, states x symbols.
    fn columns(&self, g: &mut Graph, symbols: &[SymbolId], mode: Derivative) -> Vec<Vec<Id>> {
        let n = self.acceleration.len();
        let zero = g.zero();
        let states = 2 * n + self.lag_rates.len();
        let mut out = vec![vec![zero; symbols.len()]; states];
        let roots: Vec<Id> = self.free.iter().map(|&i| self.inverse_dynamics[i]).collect();
        let rows = Differentiable::new(g, &roots);
        let prescribed: Vec<(usize, Differentiable)> =
            self.lowering.prescribed.iter().enumerate().filter_map(|(i, given)| Some((i, Differentiable::new(g, &[(*given)?])))).collect();
        let lag_rates: Vec<Differentiable> = self.lag_rates.iter().map(|&rate| Differentiable::new(g, &[rate])).collect();
        let a = &self.lowering.a;
        // slopes over the acceleration symbols, which then take their solved values all at once
        let mut slopes: Vec<Id> = Vec::new();
        for &s in symbols {
            g.set_scope(format!("by_{}", g.symbol_info(s).name.replace('.', "_")));
            slopes.extend(rows.by(g, s, mode));
        }
        let solution = self.acceleration;
        g.set_scope("slopes");
        let slopes = g.substitute(&slopes, |s| a.iter().position(|&x| x == s).map(|i| solution[i]));
        for (j, &s) in symbols.iter().enumerate() {
            let what = g.symbol_info(s).name.replace('.', "_");
            g.set_scope(format!("by_{what}"));
            if let Some(k) = self.lowering.v.iter().position(|&v| v == s) {
                out[k][j] = g.one();
            }
            let mut column: Vec<Id> = slopes[j * roots.len()..(j + 1) * roots.len()].to_vec();
            // a prescribed acceleration (a signal, or a trajectory over parameters) enters the free rows through M: its
            // symbol stands in ID as `a`
            for &(i, ref given) in &prescribed {
                let slope = given.by(g, s, mode)[0];
                if g.is_zero(slope) {
                    continue;
                }
                out[n + i][j] = slope;
                let through = rows.by(g, a[i], mode);
                for (value, part) in column.iter_mut().zip(through) {
                    let part = g.mul(part, slope);
                    *value = g.add(*value, part);
                }
            }
            let right: Vec<Id> = column.iter().map(|&d| g.neg(d)).collect();
            let solved = self.factored.solve(g, &right);
            for (&i, &d) in self.free.iter().zip(&solved) {
                g.label(d, format!("d_{}_ddot_by_{what}", self.lowering_name(g, i)));
                out[n + i][j] = d;
            }
            for (k, rate) in lag_rates.iter().enumerate() {
                out[2 * n + k][j] = rate.by(g, s, mode)[0];
            }
        }
        out
    }

    fn lowering_name(&self, g: &Graph, i: usize) -> String {
        g.symbol_info(self.lowering.q[i]).name.clone()
    }
}
