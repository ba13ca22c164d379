//! The derived equations as a Python module for CasADi: the same operations, so that its users can
//! take the model over, and so that its time can be compared with ours on equal terms.

use crate::equations::Equations;
use crate::expr::{F1, F2, Id, Op, SymbolId, SymbolKind};
use std::fmt::Write;

/// Python source with `forward_dynamics(x, u, p)` -> x' and `linearize(x, u, p)` -> A, B as CasADi functions.
#[must_use]
pub fn casadi(equations: &Equations) -> String {
    let layout = &equations.layout;
    let mut out = format!(
        "\"\"\"{}: derived equations for CasADi. Generated from `{}` (model {}); edit the rig, not this file.\n\n\
         x = [{}], u = [{}]; SI and radians.\n\"\"\"\nimport casadi as ca\n\n",
        layout.doc.lines().next().unwrap_or(&layout.rig),
        layout.rig,
        &equations.hash[..8],
        layout.x().map(|v| v.name.as_str()).collect::<Vec<_>>().join(", "),
        layout.u.iter().map(|v| v.name.as_str()).collect::<Vec<_>>().join(", "),
    );
    let _ = writeln!(out, "PARAMETERS = {{");
    for (p, value) in layout.p.iter().zip(&layout.nominal) {
        let _ = writeln!(out, "    {:?}: {value:?},  # {}", p.name, p.unit);
    }
    let _ = writeln!(out, "}}\n\nt = ca.SX.sym(\"t\")");
    for (name, length) in [("x", layout.states()), ("u", layout.u.len()), ("p", layout.p.len())] {
        let _ = writeln!(out, "{name} = ca.SX.sym({name:?}, {length})");
    }
    function(&mut out, equations, "forward_dynamics", &[("xdot", layout.states(), 1, equations.state_derivative())]);
    let flat = |rows: &[Vec<Id>]| rows.iter().flatten().copied().collect::<Vec<_>>();
    if !equations.linear.a.is_empty() {
        let (a, b) = (flat(&equations.linear.a), flat(&equations.linear.b));
        function(
            &mut out,
            equations,
            "linearize",
            &[("A", layout.states(), layout.states(), a), ("B", layout.states(), layout.u.len(), b)],
        );
    }
    out
}

fn function(out: &mut String, equations: &Equations, name: &str, results: &[(&str, usize, usize, Vec<Id>)]) {
    let roots: Vec<Id> = results.iter().flat_map(|(_, _, _, ids)| ids.iter().copied()).collect();
    let tape = equations.graph.tape(&roots);
    let _ = writeln!(out, "\n\ndef _{name}():\n    w = [None] * {}", tape.ops.len());
    for (i, op) in tape.ops.iter().enumerate() {
        let _ = writeln!(out, "    w[{i}] = {}", operation(equations, op));
    }
    let mut at = 0;
    let mut names = Vec::new();
    for (result, rows, columns, ids) in results {
        let places: Vec<String> = tape.roots[at..at + ids.len()].iter().map(|i| format!("w[{i}]")).collect();
        at += ids.len();
        let _ = writeln!(out, "    {result} = ca.reshape(ca.vertcat({}), {columns}, {rows}).T", places.join(", "));
        names.push(*result);
    }
    let quoted: Vec<String> = names.iter().map(|n| format!("{n:?}")).collect();
    let _ = writeln!(
        out,
        "    return ca.Function({name:?}, [t, x, u, p], [{}], [\"t\", \"x\", \"u\", \"p\"], [{}])\n\n\n{name} = _{name}()",
        names.join(", "),
        quoted.join(", ")
    );
}

fn operation(equations: &Equations, op: &Op) -> String {
    match *op {
        Op::Number(x) => format!("ca.SX({x:?})"),
        Op::Symbol(s) => symbol(equations, s),
        Op::Add(a, b) => format!("w[{a}] + w[{b}]"),
        Op::Sub(a, b) => format!("w[{a}] - w[{b}]"),
        Op::Mul(a, b) => format!("w[{a}] * w[{b}]"),
        Op::Div(a, b) => format!("w[{a}] / w[{b}]"),
        Op::Neg(a) => format!("-w[{a}]"),
        Op::Powi(a, n) => format!("w[{a}] ** {n}"),
        Op::Call(f, a) => {
            let name = match f {
                F1::Sin => "sin",
                F1::Cos => "cos",
                F1::Tan => "tan",
                F1::Asin => "asin",
                F1::Acos => "acos",
                F1::Atan => "atan",
                F1::Sinh => "sinh",
                F1::Cosh => "cosh",
                F1::Tanh | F1::SmoothSign => "tanh",
                F1::Exp => "exp",
                F1::Ln => "log",
                F1::Sqrt => "sqrt",
                F1::Abs => "fabs",
                F1::Sign => "sign",
                F1::Step => return format!("ca.if_else(w[{a}] > 0, 1.0, 0.0)"),
            };
            format!("ca.{name}(w[{a}])")
        }
        Op::Call2(f, a, b) => {
            let name = match f {
                F2::Atan2 => "atan2",
                F2::Min => "fmin",
                F2::Max => "fmax",
                F2::Pow => "power",
            };
            format!("ca.{name}(w[{a}], w[{b}])")
        }
    }
}

fn symbol(equations: &Equations, s: SymbolId) -> String {
    let n = equations.layout.q.len();
    match equations.graph.symbol_info(s).kind {
        SymbolKind::Time => "t".to_owned(),
        SymbolKind::Coordinate(i) => format!("x[{i}]"),
        SymbolKind::Rate(i) => format!("x[{}]", n + i),
        SymbolKind::Lag(i) => format!("x[{}]", 2 * n + i),
        SymbolKind::Signal(i) => format!("u[{i}]"),
        SymbolKind::Parameter(i) => format!("p[{i}]"),
        // not in forward dynamics and its Jacobians
        SymbolKind::Acceleration(_) | SymbolKind::Definition(_) | SymbolKind::Inertial(_) => "ca.SX(float('nan'))".to_owned(),
    }
}
