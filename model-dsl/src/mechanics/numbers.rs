//! Expressions to numbers, at the parameters' values.

use crate::rig::{AssumptionKind, BinaryOp, Expr, Function, Rig, Symbol};

/// Values of parameters and definitions.
pub struct Numbers<'a> {
    rig: &'a Rig,
    parameters: Vec<f64>,
    definitions: Vec<f64>,
    /// Definitions behind which an earlier error left a hole.
    holes: Vec<bool>,
}

impl<'a> Numbers<'a> {
    /// Evaluates all definitions, which stand behind what they use.
    pub fn new(rig: &'a Rig) -> Self {
        Self::with(rig, rig.parameters.iter().map(|p| p.value).collect())
    }

    /// With the values that `set` assumes in place of the parameters' own.
    pub fn assumed(rig: &'a Rig) -> Self {
        let mut parameters: Vec<f64> = rig.parameters.iter().map(|p| p.value).collect();
        for a in &rig.assumptions {
            if let AssumptionKind::Set { parameter, value } = a.kind {
                parameters[parameter] = value;
            }
        }
        Self::with(rig, parameters)
    }

    fn with(rig: &'a Rig, parameters: Vec<f64>) -> Self {
        let mut numbers = Self { rig, parameters, definitions: Vec::new(), holes: Vec::new() };
        for d in &rig.definitions {
            let (value, hole) = match d.parameter {
                Some(p) => (numbers.parameters[p], numbers.parameters[p].is_nan()),
                None => (numbers.at(&d.value, &[], &[]), !numbers.known(&d.value)),
            };
            numbers.definitions.push(value);
            numbers.holes.push(hole);
        }
        numbers
    }

    /// Whether no earlier error left a hole in it.
    pub fn known(&self, e: &Expr) -> bool {
        match e {
            Expr::Number(x) => !x.is_nan(),
            Expr::Symbol(Symbol::Parameter(k)) => !self.parameters[*k].is_nan(),
            // a definition that is not there yet stands in a circle, which was reported
            Expr::Symbol(Symbol::Definition(k)) => self.holes.get(*k).is_some_and(|hole| !hole),
            Expr::Symbol(_) => true,
            Expr::Neg(a) => self.known(a),
            Expr::Binary(_, a, b) => self.known(a) && self.known(b),
            Expr::Call(_, args) => args.iter().all(|a| self.known(a)),
        }
    }

    /// Value over parameters alone, if no hole is in it; it may be infinite or NaN.
    pub fn value(&self, e: &Expr) -> Option<f64> {
        self.known(e).then(|| self.at(e, &[], &[]))
    }

    /// Value at coordinates and rates; time, inputs and what is not given are zero.
    pub fn at(&self, e: &Expr, q: &[f64], v: &[f64]) -> f64 {
        match e {
            Expr::Number(x) => *x,
            Expr::Symbol(s) => match *s {
                Symbol::Parameter(k) => self.parameters[k],
                Symbol::Definition(k) => self.definitions.get(k).copied().unwrap_or(f64::NAN),
                Symbol::Coordinate(k) => q.get(k).copied().unwrap_or(0.0),
                Symbol::Rate(k) => v.get(k).copied().unwrap_or(0.0),
                Symbol::Time | Symbol::Acceleration(_) | Symbol::Input(_) | Symbol::Actuator(_) | Symbol::Mixed(..) => 0.0,
            },
            Expr::Neg(a) => -self.at(a, q, v),
            Expr::Binary(op, a, b) => {
                let (x, y) = (self.at(a, q, v), self.at(b, q, v));
                match op {
                    BinaryOp::Add => x + y,
                    BinaryOp::Sub => x - y,
                    BinaryOp::Mul => x * y,
                    BinaryOp::Div => x / y,
                    BinaryOp::Pow => x.powf(y),
                }
            }
            Expr::Call(f, args) => {
                let x: Vec<f64> = args.iter().map(|a| self.at(a, q, v)).collect();
                function(*f, &x)
            }
        }
    }

    /// Why an expression over parameters has no finite value, in words.
    pub fn blame(&self, e: &Expr) -> String {
        let inner = match e {
            Expr::Number(_) | Expr::Symbol(_) => None,
            Expr::Neg(a) => Some(self.blame(a)),
            Expr::Binary(_, a, b) => [a, b].into_iter().find(|x| !self.at(x, &[], &[]).is_finite()).map(|x| self.blame(x)),
            Expr::Call(_, args) => args.iter().find(|x| !self.at(x, &[], &[]).is_finite()).map(|x| self.blame(x)),
        };
        if let Some(inner) = inner {
            return inner;
        }
        match e {
            Expr::Symbol(s) => format!("{} has no finite value", self.name(*s)),
            Expr::Binary(BinaryOp::Div, _, b) if self.at(b, &[], &[]) == 0.0 => format!("divides by {}, which is 0", self.words(b)),
            Expr::Binary(BinaryOp::Pow, a, _) if self.at(a, &[], &[]) < 0.0 => format!("a power of {}, which is negative", self.words(a)),
            Expr::Call(f, args) => {
                let argument =
                    args.first().map_or_else(String::new, |a| format!("{} = {}", self.words(a), super::shown(self.at(a, &[], &[]))));
                format!("`{}` has no value at {argument}", format!("{f:?}").to_lowercase())
            }
            _ => "overflows".to_owned(),
        }
    }

    fn words(&self, e: &Expr) -> String {
        match e {
            Expr::Symbol(s) => self.name(*s),
            Expr::Number(x) => super::shown(*x),
            _ => "a term".to_owned(),
        }
    }

    fn name(&self, s: Symbol) -> String {
        match s {
            Symbol::Parameter(k) => format!("`{}`", self.rig.parameters[k].name),
            Symbol::Definition(k) => format!("`{}`", self.rig.definitions[k].name),
            _ => "a term".to_owned(),
        }
    }
}

fn function(f: Function, x: &[f64]) -> f64 {
    let at = |k: usize| x.get(k).copied().unwrap_or(f64::NAN);
    let a = at(0);
    match f {
        Function::Sin => a.sin(),
        Function::Cos => a.cos(),
        Function::Tan => a.tan(),
        Function::Asin => a.asin(),
        Function::Acos => a.acos(),
        Function::Atan => a.atan(),
        Function::Atan2 => a.atan2(at(1)),
        Function::Sinh => a.sinh(),
        Function::Cosh => a.cosh(),
        Function::Tanh => a.tanh(),
        Function::Exp => a.exp(),
        Function::Ln => a.ln(),
        Function::Sqrt => a.sqrt(),
        Function::Abs => a.abs(),
        Function::Sign => {
            if a == 0.0 {
                0.0
            } else {
                a.signum()
            }
        }
        Function::Min => a.min(at(1)),
        Function::Max => a.max(at(1)),
        Function::Saturate => a.max(at(1)).min(at(2)),
        Function::DeadZone => a - a.max(-at(1)).min(at(1)),
    }
}
