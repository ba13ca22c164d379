//! Forward differentiation on the graph.

use super::graph::{F1, F2, Graph, Id, Node, SymbolId};

/// How derivatives are taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Derivative {
    /// Every function's own slope.
    Exact,
    /// Without the slope of regularized Coulomb friction ([`F1::SmoothSign`]), an artefact at rest.
    WithoutFrictionSlope,
}

impl Graph {
    /// Partial derivatives of `roots` with respect to one symbol.
    pub fn differentiate(&mut self, roots: &[Id], wrt: SymbolId, mode: Derivative) -> Vec<Id> {
        let order = self.reachable(roots);
        let zero = self.zero();
        let highest = order.last().map_or(0, |id| id.index() + 1);
        let mut slope = vec![zero; highest];
        for id in order {
            slope[id.index()] = self.slope_of(id, &slope, wrt, mode);
        }
        roots.iter().map(|id| slope[id.index()]).collect()
    }

    /// Jacobian: `result[i][j]` = d `roots[i]` / d `symbols[j]`.
    pub fn jacobian(&mut self, roots: &[Id], symbols: &[SymbolId], mode: Derivative) -> Vec<Vec<Id>> {
        let columns: Vec<Vec<Id>> = symbols.iter().map(|&s| self.differentiate(roots, s, mode)).collect();
        (0..roots.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
    }

    /// Directional derivative: symbols listed in `seeds` move with the given rates.
    pub fn directional(&mut self, roots: &[Id], seeds: &[(SymbolId, Id)]) -> Vec<Id> {
        let order = self.reachable(roots);
        let zero = self.zero();
        let highest = order.last().map_or(0, |id| id.index() + 1);
        let mut slope = vec![zero; highest];
        for id in order {
            slope[id.index()] = match self.node(id) {
                Node::Symbol(s) => seeds.iter().find(|(seed, _)| *seed == s).map_or(zero, |(_, rate)| *rate),
                _ => self.chain_rule(id, &slope, Derivative::Exact),
            };
        }
        roots.iter().map(|id| slope[id.index()]).collect()
    }

    fn slope_of(&mut self, id: Id, slope: &[Id], wrt: SymbolId, mode: Derivative) -> Id {
        match self.node(id) {
            Node::Symbol(s) if s == wrt => self.one(),
            Node::Symbol(_) => self.zero(),
            _ => self.chain_rule(id, slope, mode),
        }
    }

    fn chain_rule(&mut self, id: Id, slope: &[Id], mode: Derivative) -> Id {
        let of = |x: Id| slope[x.index()];
        match self.node(id) {
            Node::Number(_) | Node::Symbol(_) => self.zero(),
            Node::Add(a, b) => self.add(of(a), of(b)),
            Node::Sub(a, b) => self.sub(of(a), of(b)),
            Node::Mul(a, b) => {
                if a == b {
                    if self.is_zero(of(a)) {
                        return self.zero();
                    }
                    let two = self.num(2.0);
                    let twice = self.mul(two, a);
                    return self.mul(twice, of(a));
                }
                let left = self.mul(of(a), b);
                let right = self.mul(a, of(b));
                self.add(left, right)
            }
            Node::Div(a, b) => {
                let (da, db) = (of(a), of(b));
                // (da - (a/b) db) / b reuses the quotient
                let carried = self.mul(id, db);
                let top = self.sub(da, carried);
                self.div(top, b)
            }
            Node::Neg(a) => self.neg(of(a)),
            Node::Powi(a, n) => {
                if self.is_zero(of(a)) {
                    return self.zero();
                }
                let power = self.powi(a, n - 1);
                let k = self.num(f64::from(n));
                let outer = self.mul(k, power);
                self.mul(outer, of(a))
            }
            Node::Call(f, a) => {
                let inner = of(a);
                if self.is_zero(inner) {
                    return inner;
                }
                let outer = self.outer_slope(f, a, id, mode);
                self.mul(outer, inner)
            }
            Node::Call2(f, a, b) => self.slope2(f, a, b, id, of(a), of(b)),
        }
    }

    fn outer_slope(&mut self, f: F1, a: Id, value: Id, mode: Derivative) -> Id {
        let one = self.one();
        match f {
            F1::Sin => self.cos(a),
            F1::Cos => {
                let s = self.sin(a);
                self.neg(s)
            }
            F1::Tan => {
                let square = self.square(value);
                self.add(one, square)
            }
            F1::Asin | F1::Acos => {
                let square = self.square(a);
                let rest = self.sub(one, square);
                let root = self.call(F1::Sqrt, rest);
                let slope = self.div(one, root);
                if f == F1::Asin { slope } else { self.neg(slope) }
            }
            F1::Atan => {
                let square = self.square(a);
                let bottom = self.add(one, square);
                self.div(one, bottom)
            }
            F1::Sinh => self.call(F1::Cosh, a),
            F1::Cosh => self.call(F1::Sinh, a),
            F1::SmoothSign if mode == Derivative::WithoutFrictionSlope => self.zero(),
            F1::Tanh | F1::SmoothSign => {
                let square = self.square(value);
                self.sub(one, square)
            }
            F1::Exp => value,
            F1::Ln => self.div(one, a),
            F1::Sqrt => {
                let half = self.num(0.5);
                self.div(half, value)
            }
            F1::Abs => self.call(F1::Sign, a),
            F1::Sign | F1::Step => self.zero(),
        }
    }

    fn slope2(&mut self, f: F2, a: Id, b: Id, value: Id, da: Id, db: Id) -> Id {
        if self.is_zero(da) && self.is_zero(db) {
            return da;
        }
        match f {
            F2::Atan2 => {
                let (aa, bb) = (self.square(a), self.square(b));
                let bottom = self.add(aa, bb);
                let (left, right) = (self.mul(b, da), self.mul(a, db));
                let top = self.sub(left, right);
                self.div(top, bottom)
            }
            F2::Min | F2::Max => {
                let difference = if f == F2::Max { self.sub(a, b) } else { self.sub(b, a) };
                let takes_a = self.call(F1::Step, difference);
                let gap = self.sub(da, db);
                let extra = self.mul(takes_a, gap);
                self.add(db, extra)
            }
            F2::Pow => {
                // d(a^b) = b a^(b-1) da + a^b ln(a) db
                let one = self.one();
                let lower = self.sub(b, one);
                let power = self.call2(F2::Pow, a, lower);
                let outer = self.mul(b, power);
                let left = self.mul(outer, da);
                if self.is_zero(db) {
                    return left;
                }
                let log = self.call(F1::Ln, a);
                let grow = self.mul(value, log);
                let right = self.mul(grow, db);
                self.add(left, right)
            }
        }
    }
}
