//! What is written: a tree of sums, products, quotients, powers and calls, the same for every printer.
//!
//! Printers differ in signs and brackets only; where brackets are needed is decided here, once.

use super::number::Number;
use model_dsl::rig::{BinaryOp, Expr, Function, Rig, Symbol};

/// A written expression.
#[derive(Clone, PartialEq, Debug)]
pub enum Tree {
    /// A number.
    Number(Number),
    /// A name of the rig: `eps`, `eps.dot`, `m_h`.
    Name(String),
    /// M[eps, theta], h[psi]: an entry of a vector or matrix.
    Entry(&'static str, Vec<String>),
    /// f(x, ..)
    Call(&'static str, Vec<Tree>),
    /// x^y
    Power(Box<Tree>, Box<Tree>),
    /// Factors, side by side.
    Product(Vec<Tree>),
    /// x / y
    Quotient(Box<Tree>, Box<Tree>),
    /// -x
    Minus(Box<Tree>),
    /// Terms with their signs (true: minus).
    Sum(Vec<(bool, Tree)>),
}

/// How tightly an expression holds together; a looser one inside a tighter one needs brackets.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Binding {
    /// a + b, -a
    Sum,
    /// a b
    Product,
    /// a / b: as tight as a product, but not to be followed by a factor in a denominator
    Quotient,
    /// a^b
    Power,
    /// A name, a call, a number without sign
    Leaf,
}

impl Tree {
    /// An integer.
    pub fn integer(n: i64) -> Self {
        Self::Number(Number::integer(n))
    }

    /// Product of factors; ones are left out.
    pub fn product(factors: Vec<Tree>) -> Self {
        let mut flat = Vec::with_capacity(factors.len());
        for factor in factors {
            match factor {
                Self::Number(x) if x.is_one() => {}
                Self::Product(inner) => flat.extend(inner),
                other => flat.push(other),
            }
        }
        match flat.len() {
            0 => Self::integer(1),
            1 => flat.swap_remove(0),
            _ => Self::Product(flat),
        }
    }

    /// Sum of signed terms; sums inside are opened, zeros left out.
    pub fn sum(terms: Vec<(bool, Tree)>) -> Self {
        let mut flat = Vec::with_capacity(terms.len());
        for (minus, term) in terms {
            push_term(&mut flat, minus, term);
        }
        match flat.as_slice() {
            [] => Self::integer(0),
            [(false, _)] => flat.swap_remove(0).1,
            [(true, _)] => Self::Minus(Box::new(flat.swap_remove(0).1)),
            _ => Self::Sum(flat),
        }
    }

    /// The terms of a sum.
    pub fn into_terms(self) -> Vec<(bool, Tree)> {
        let mut flat = Vec::new();
        push_term(&mut flat, false, self);
        flat
    }

    /// Nothing.
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Number(x) if x.is_zero())
    }

    /// How tightly it holds together.
    pub fn binding(&self) -> Binding {
        match self {
            Self::Sum(_) | Self::Minus(_) => Binding::Sum,
            Self::Product(_) => Binding::Product,
            Self::Quotient(..) => Binding::Quotient,
            Self::Power(..) => Binding::Power,
            Self::Number(x) if x.is_negative() => Binding::Sum,
            Self::Number(x) if x.fraction().is_some_and(|(_, q)| q != 1) => Binding::Quotient,
            Self::Number(_) | Self::Name(_) | Self::Entry(..) | Self::Call(..) => Binding::Leaf,
        }
    }

    /// A checked expression as it was written.
    pub fn of_expr(rig: &Rig, expr: &Expr) -> Self {
        match expr {
            Expr::Number(x) => match Number::over_pi(*x) {
                Some(ratio) => Self::product(vec![Self::Number(ratio), Self::Name("pi".to_owned())]),
                None => Self::Number(Number::of(*x)),
            },
            Expr::Symbol(s) => Self::Name(name_of(rig, *s)),
            Expr::Neg(a) => Self::sum(vec![(true, Self::of_expr(rig, a))]),
            Expr::Binary(op, a, b) => {
                let (a, b) = (Self::of_expr(rig, a), Self::of_expr(rig, b));
                match op {
                    BinaryOp::Add => Self::sum(vec![(false, a), (false, b)]),
                    BinaryOp::Sub => Self::sum(vec![(false, a), (true, b)]),
                    BinaryOp::Mul => Self::product(vec![a, b]),
                    BinaryOp::Div => Self::Quotient(Box::new(a), Box::new(b)),
                    BinaryOp::Pow => Self::Power(Box::new(a), Box::new(b)),
                }
            }
            Expr::Call(f, args) => Self::Call(function_name(*f), args.iter().map(|a| Self::of_expr(rig, a)).collect()),
        }
    }
}

fn push_term(flat: &mut Vec<(bool, Tree)>, minus: bool, term: Tree) {
    match term {
        Tree::Sum(inner) => {
            for (m, t) in inner {
                push_term(flat, m != minus, t);
            }
        }
        Tree::Minus(inner) => push_term(flat, !minus, *inner),
        Tree::Number(x) if x.is_zero() => {}
        Tree::Number(x) if x.is_negative() => flat.push((!minus, Tree::Number(x.neg()))),
        other => flat.push((minus, other)),
    }
}

/// A name of the rig as the rig writes it.
pub fn name_of(rig: &Rig, symbol: Symbol) -> String {
    let coordinate = |i: usize| &rig.coordinates[i].name;
    match symbol {
        Symbol::Time => "t".to_owned(),
        Symbol::Parameter(i) => rig.parameters[i].name.clone(),
        Symbol::Definition(i) => rig.definitions[i].name.clone(),
        Symbol::Coordinate(i) => coordinate(i).clone(),
        Symbol::Rate(i) => format!("{}.dot", coordinate(i)),
        Symbol::Acceleration(i) => format!("{}.ddot", coordinate(i)),
        Symbol::Input(i) => rig.inputs[i].name.clone(),
        Symbol::Actuator(i) => rig.actuators[i].name.clone(),
        Symbol::Mixed(mix, row) => rig.mixes[mix].names[row].clone(),
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
