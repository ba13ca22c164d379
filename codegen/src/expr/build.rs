//! Construction with never-worse rewrites: constants folded, signs pulled outward, like terms of
//! two operands merged, sin^2 + cos^2 recognized.

use super::graph::{F1, F2, Graph, Id, Node};

impl Graph {
    /// A number.
    pub fn num(&mut self, x: f64) -> Id {
        let x = if x == 0.0 { 0.0 } else { x };
        self.insert(Node::Number(x.to_bits()))
    }

    /// 0.
    pub fn zero(&mut self) -> Id {
        self.num(0.0)
    }

    /// 1.
    pub fn one(&mut self) -> Id {
        self.num(1.0)
    }

    /// The node is the number 0.
    #[must_use]
    pub fn is_zero(&self, id: Id) -> bool {
        self.number_of(id) == Some(0.0)
    }

    fn is_one(&self, id: Id) -> bool {
        self.number_of(id) == Some(1.0)
    }

    /// -a
    pub fn neg(&mut self, a: Id) -> Id {
        match self.node(a) {
            Node::Number(bits) => self.num(-f64::from_bits(bits)),
            Node::Neg(x) => x,
            Node::Sub(x, y) => self.sub(y, x),
            Node::Mul(x, y) if self.number_of(x).is_some() || self.number_of(y).is_some() => {
                let (k, rest) = if self.number_of(x).is_some() { (x, y) } else { (y, x) };
                let k = self.neg(k);
                self.mul(k, rest)
            }
            _ => self.insert(Node::Neg(a)),
        }
    }

    /// a + b
    pub fn add(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        if let (Some(x), Some(y)) = (self.number_of(a), self.number_of(b)) {
            return self.num(x + y);
        }
        match (self.node(a), self.node(b)) {
            (Node::Neg(x), Node::Neg(y)) => {
                let sum = self.add(x, y);
                return self.neg(sum);
            }
            (_, Node::Neg(y)) => return self.sub(a, y),
            (Node::Neg(x), _) => return self.sub(b, x),
            (Node::Sub(x, y), _) if y == b => return x,
            (_, Node::Sub(x, y)) if y == a => return x,
            _ => {}
        }
        if a == b {
            let two = self.num(2.0);
            return self.mul(two, a);
        }
        if let Some(id) = self.pythagoras(a, b) {
            return id;
        }
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        self.insert(Node::Add(a, b))
    }

    /// a - b
    pub fn sub(&mut self, a: Id, b: Id) -> Id {
        if a == b {
            return self.zero();
        }
        if self.is_zero(b) {
            return a;
        }
        if self.is_zero(a) {
            return self.neg(b);
        }
        if let (Some(x), Some(y)) = (self.number_of(a), self.number_of(b)) {
            return self.num(x - y);
        }
        match (self.node(a), self.node(b)) {
            (Node::Neg(x), Node::Neg(y)) => return self.sub(y, x),
            (_, Node::Neg(y)) => return self.add(a, y),
            (Node::Neg(x), _) => {
                let sum = self.add(x, b);
                return self.neg(sum);
            }
            (Node::Add(x, y), _) if x == b => return y,
            (Node::Add(x, y), _) if y == b => return x,
            (_, Node::Add(x, y)) if x == a => return self.neg(y),
            (_, Node::Add(x, y)) if y == a => return self.neg(x),
            (Node::Sub(x, y), _) if x == b => return self.neg(y),
            (_, Node::Sub(x, y)) if x == a => return y,
            _ => {}
        }
        self.insert(Node::Sub(a, b))
    }

    /// a * b
    pub fn mul(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) || self.is_zero(b) {
            return self.zero();
        }
        if self.is_one(a) {
            return b;
        }
        if self.is_one(b) {
            return a;
        }
        match (self.number_of(a), self.number_of(b)) {
            (Some(x), Some(y)) => return self.num(x * y),
            (Some(-1.0), _) => return self.neg(b),
            (_, Some(-1.0)) => return self.neg(a),
            (Some(x), None) => return self.scale(x, b),
            (None, Some(y)) => return self.scale(y, a),
            (None, None) => {}
        }
        match (self.node(a), self.node(b)) {
            (Node::Neg(x), Node::Neg(y)) => return self.mul(x, y),
            (Node::Neg(x), _) => {
                let product = self.mul(x, b);
                return self.neg(product);
            }
            (_, Node::Neg(y)) => {
                let product = self.mul(a, y);
                return self.neg(product);
            }
            (Node::Div(x, y), _) if y == b => return x,
            (_, Node::Div(x, y)) if y == a => return x,
            _ => {}
        }
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        self.insert(Node::Mul(a, b))
    }

    /// k * a with a that is no number
    fn scale(&mut self, k: f64, a: Id) -> Id {
        match self.node(a) {
            Node::Neg(x) => self.scale_plain(-k, x),
            Node::Mul(x, y) if self.number_of(x).is_some() => {
                let inner = self.number_of(x).unwrap_or(1.0);
                self.scale_plain(k * inner, y)
            }
            Node::Mul(x, y) if self.number_of(y).is_some() => {
                let inner = self.number_of(y).unwrap_or(1.0);
                self.scale_plain(k * inner, x)
            }
            _ => self.scale_plain(k, a),
        }
    }

    fn scale_plain(&mut self, k: f64, a: Id) -> Id {
        if k == 1.0 {
            return a;
        }
        if k == -1.0 {
            return self.neg(a);
        }
        if k == 0.0 {
            return self.zero();
        }
        let k = self.num(k);
        let (a, b) = if k <= a { (k, a) } else { (a, k) };
        self.insert(Node::Mul(a, b))
    }

    /// a / b. A division by the number zero stays as it is: its value is for the evaluation to show.
    pub fn div(&mut self, a: Id, b: Id) -> Id {
        if self.is_one(b) {
            return a;
        }
        if self.is_zero(a) && !self.is_zero(b) {
            return a;
        }
        if let (Some(x), Some(y)) = (self.number_of(a), self.number_of(b)) {
            return self.num(x / y);
        }
        if a == b {
            return self.one();
        }
        match (self.node(a), self.node(b)) {
            (Node::Neg(x), Node::Neg(y)) => return self.div(x, y),
            (Node::Neg(x), _) => {
                let quotient = self.div(x, b);
                return self.neg(quotient);
            }
            (_, Node::Neg(y)) => {
                let quotient = self.div(a, y);
                return self.neg(quotient);
            }
            (Node::Mul(x, y), _) if x == b => return y,
            (Node::Mul(x, y), _) if y == b => return x,
            _ => {}
        }
        self.insert(Node::Div(a, b))
    }

    /// a^2
    pub fn square(&mut self, a: Id) -> Id {
        self.mul(a, a)
    }

    /// a^n
    pub fn powi(&mut self, a: Id, n: i32) -> Id {
        match n {
            0 => return self.one(),
            1 => return a,
            2 => return self.mul(a, a),
            _ => {}
        }
        if let Some(x) = self.number_of(a) {
            return self.num(x.powi(n));
        }
        match self.node(a) {
            Node::Neg(x) => {
                let power = self.powi(x, n);
                if n % 2 == 0 { power } else { self.neg(power) }
            }
            _ if n == -1 => {
                let one = self.one();
                self.div(one, a)
            }
            _ => self.insert(Node::Powi(a, n)),
        }
    }

    /// f(a)
    pub fn call(&mut self, f: F1, a: Id) -> Id {
        if let Some(x) = self.number_of(a) {
            let value = f.apply(x);
            if value.is_finite() {
                return self.num(value);
            }
        }
        if let Node::Neg(x) = self.node(a) {
            match f {
                F1::Sin | F1::Tan | F1::Asin | F1::Atan | F1::Sinh | F1::Tanh | F1::Sign | F1::SmoothSign => {
                    let value = self.call(f, x);
                    return self.neg(value);
                }
                F1::Cos | F1::Cosh | F1::Abs => return self.call(f, x),
                _ => {}
            }
        }
        self.insert(Node::Call(f, a))
    }

    /// f(a, b)
    pub fn call2(&mut self, f: F2, a: Id, b: Id) -> Id {
        if let (Some(x), Some(y)) = (self.number_of(a), self.number_of(b)) {
            let value = f.apply(x, y);
            if value.is_finite() {
                return self.num(value);
            }
        }
        if f == F2::Pow
            && let Some(n) = self.number_of(b)
        {
            if n.fract() == 0.0 && n.abs() <= 64.0 {
                return self.powi(a, n as i32);
            }
            if n == 0.5 {
                return self.call(F1::Sqrt, a);
            }
        }
        self.insert(Node::Call2(f, a, b))
    }

    /// sin(a)
    pub fn sin(&mut self, a: Id) -> Id {
        self.call(F1::Sin, a)
    }

    /// cos(a)
    pub fn cos(&mut self, a: Id) -> Id {
        self.call(F1::Cos, a)
    }

    /// Sum of a list.
    pub fn sum(&mut self, terms: &[Id]) -> Id {
        let mut total = self.zero();
        for &term in terms {
            total = self.add(total, term);
        }
        total
    }

    /// k sin^2 x + k cos^2 x = k for the two operands of a sum.
    fn pythagoras(&mut self, a: Id, b: Id) -> Option<Id> {
        let (ka, fa, xa) = self.squared_trig(a)?;
        let (kb, fb, xb) = self.squared_trig(b)?;
        if xa == xb && fa != fb && ka == kb {
            return Some(match ka {
                Some(k) => k,
                None => self.one(),
            });
        }
        None
    }

    /// Reads `sin(x) * sin(x)` or `k * (sin(x) * sin(x))`.
    fn squared_trig(&self, id: Id) -> Option<(Option<Id>, F1, Id)> {
        let Node::Mul(a, b) = self.node(id) else { return None };
        if a == b {
            return match self.node(a) {
                Node::Call(f @ (F1::Sin | F1::Cos), x) => Some((None, f, x)),
                _ => None,
            };
        }
        for (square, k) in [(a, b), (b, a)] {
            if let Node::Mul(c, d) = self.node(square)
                && c == d
                && let Node::Call(f @ (F1::Sin | F1::Cos), x) = self.node(c)
            {
                return Some((Some(k), f, x));
            }
        }
        None
    }
}

impl F1 {
    /// The function's value.
    #[must_use]
    pub fn apply(self, x: f64) -> f64 {
        match self {
            F1::Sin => x.sin(),
            F1::Cos => x.cos(),
            F1::Tan => x.tan(),
            F1::Asin => x.asin(),
            F1::Acos => x.acos(),
            F1::Atan => x.atan(),
            F1::Sinh => x.sinh(),
            F1::Cosh => x.cosh(),
            F1::Tanh | F1::SmoothSign => x.tanh(),
            F1::Exp => x.exp(),
            F1::Ln => x.ln(),
            F1::Sqrt => x.sqrt(),
            F1::Abs => x.abs(),
            F1::Sign => {
                if x > 0.0 {
                    1.0
                } else if x < 0.0 {
                    -1.0
                } else {
                    0.0
                }
            }
            F1::Step => {
                if x > 0.0 {
                    1.0
                } else {
                    0.0
                }
            }
        }
    }
}

impl F2 {
    /// The function's value.
    #[must_use]
    pub fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            F2::Atan2 => a.atan2(b),
            F2::Min => a.min(b),
            F2::Max => a.max(b),
            F2::Pow => a.powf(b),
        }
    }
}
