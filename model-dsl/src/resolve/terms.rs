//! Questions about checked expressions: which symbols, what degree, which coefficients.

use crate::ast::{Expr as Ast, ExprKind};
use crate::rig::{BinaryOp, Expr, Symbol};

/// What stands where an error was reported: checks of mechanics pass over it.
pub(super) fn hole() -> Expr {
    Expr::Number(f64::NAN)
}

pub(super) fn negative(e: Expr) -> Expr {
    match e {
        Expr::Number(x) => Expr::Number(-x),
        other => Expr::Neg(Box::new(other)),
    }
}

pub(super) fn names_in(ast: &Ast) -> Vec<String> {
    match &ast.kind {
        ExprKind::Number(..) => Vec::new(),
        ExprKind::Name(n, _) => vec![n.text.clone()],
        ExprKind::Neg(a) => names_in(a),
        ExprKind::Binary(_, a, b) => [names_in(a), names_in(b)].concat(),
        ExprKind::Call(_, args) => args.iter().flat_map(names_in).collect(),
    }
}

pub(super) fn coordinates_in(e: &Expr) -> Vec<usize> {
    e.symbols().into_iter().filter_map(|s| if let Symbol::Coordinate(k) = s { Some(k) } else { None }).collect()
}

pub(super) fn accelerations(e: &Expr) -> Vec<usize> {
    e.symbols().into_iter().filter_map(|s| if let Symbol::Acceleration(k) = s { Some(k) } else { None }).collect()
}

pub(super) fn collect_inputs(e: &Expr, out: &mut Vec<usize>) {
    out.extend(e.symbols().into_iter().filter_map(|s| if let Symbol::Input(k) = s { Some(k) } else { None }));
}

/// Degree in the coordinates: 0, 1, 2 or more; `None` for anything that is no polynomial in them.
pub(super) fn degree(e: &Expr) -> Option<u32> {
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
                    Expr::Number(1.0) => Some(x),
                    _ => None,
                },
            }
        }
        Expr::Call(_, args) => args.iter().all(|a| degree(a) == Some(0)).then_some(0),
    }
}

/// Coefficients of the inputs in a linear expression.
pub(super) fn linear_row(e: &Expr, inputs: &[usize]) -> Option<Vec<f64>> {
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

pub(super) fn determinant(m: &[Vec<f64>]) -> f64 {
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
            let pivot = m[i].clone();
            for (x, p) in m[k].iter_mut().zip(&pivot).skip(i) {
                *x -= f * p;
            }
        }
    }
    det
}

/// Coefficients of the accelerations: terms `k * q.ddot`, `q.ddot`, with signs.
pub(super) fn mass_row(e: &Expr) -> Option<Vec<(usize, Expr)>> {
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

pub(super) fn times(k: &Expr, c: Expr) -> Expr {
    if c == Expr::Number(1.0) { k.clone() } else { Expr::Binary(BinaryOp::Mul, Box::new(k.clone()), Box::new(c)) }
}
