//! A rig's named trims as problems for `control::solve`.

use control::{TrimProblem, Unknown};
use model_dsl::rig::{BinaryOp, Expr, Function, Rig, Symbol, Trim};
use nalgebra::DMatrix;
use runtime::Model;

/// The problem of a named trim: what is listed is held, what is solved moves, the rest is zero.
#[must_use]
pub fn problem(rig: &Rig, model: &dyn Model, trim: &Trim, p: &[f64]) -> TrimProblem {
    let d = model.dimensions();
    let (mut x, mut u) = (vec![0.0; d.states()], vec![0.0; d.signals()]);
    for (symbol, value) in &trim.fixed {
        let value = number(rig, value, p);
        let held = unknown(rig, *symbol);
        for (i, w) in held.states {
            x[i] += w * value;
        }
        for (i, w) in held.signals {
            u[i] += w * value;
        }
    }
    TrimProblem { x, u, unknowns: trim.solve.iter().map(|&s| unknown(rig, s)).collect(), zero: trim.zero.clone() }
}

/// The direction in which a name of a trim moves state and signals.
#[must_use]
pub fn unknown(rig: &Rig, symbol: Symbol) -> Unknown {
    let n = rig.coordinates.len();
    match symbol {
        Symbol::Coordinate(i) => Unknown::state(&rig.coordinates[i].name, i),
        Symbol::Rate(i) => Unknown::state(&format!("{}.dot", rig.coordinates[i].name), n + i),
        Symbol::Input(i) => Unknown::signal(&rig.inputs[i].name, i),
        Symbol::Mixed(k, row) => {
            let mix = &rig.mixes[k];
            let size = mix.inputs.len();
            let inverse = DMatrix::from_fn(size, size, |i, j| mix.rows[i][j]).try_inverse().expect("a checked mix can be undone");
            let signals = mix.inputs.iter().enumerate().map(|(j, &input)| (input, inverse[(j, row)])).collect();
            Unknown { name: mix.names[row].clone(), states: Vec::new(), signals }
        }
        other => unreachable!("{other:?} does not stand in a checked trim"),
    }
}

/// Value of an expression over parameters.
fn number(rig: &Rig, expr: &Expr, p: &[f64]) -> f64 {
    match expr {
        Expr::Number(x) => *x,
        Expr::Symbol(Symbol::Parameter(i)) => p[*i],
        Expr::Symbol(Symbol::Definition(i)) => {
            rig.definitions[*i].parameter.map_or_else(|| number(rig, &rig.definitions[*i].value, p), |k| p[k])
        }
        Expr::Symbol(other) => unreachable!("{other:?} does not stand in a trim's values"),
        Expr::Neg(a) => -number(rig, a, p),
        Expr::Binary(op, a, b) => {
            let (a, b) = (number(rig, a, p), number(rig, b, p));
            match op {
                BinaryOp::Add => a + b,
                BinaryOp::Sub => a - b,
                BinaryOp::Mul => a * b,
                BinaryOp::Div => a / b,
                BinaryOp::Pow => a.powf(b),
            }
        }
        Expr::Call(f, args) => {
            let args: Vec<f64> = args.iter().map(|a| number(rig, a, p)).collect();
            match f {
                Function::Sin => args[0].sin(),
                Function::Cos => args[0].cos(),
                Function::Asin => args[0].asin(),
                Function::Acos => args[0].acos(),
                Function::Atan2 => args[0].atan2(args[1]),
                Function::Sqrt => args[0].sqrt(),
                other => unimplemented!("{other:?} in a trim of a test's rig"),
            }
        }
    }
}
