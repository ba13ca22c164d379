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

/// Expressions whose derivatives are wanted: what they need is gathered once, however many symbols follow.
#[derive(Clone, Debug)]
pub struct Differentiable {
    /// Nodes that the roots need, ascending, with the places of their operands in this list (a single operand twice).
    nodes: Vec<(Id, [u32; 2])>,
    /// Places of the roots.
    roots: Vec<u32>,
}

impl Differentiable {
    /// Gathers what `roots` need.
    #[must_use]
    pub fn new(g: &Graph, roots: &[Id]) -> Self {
        let reach = g.reach(roots);
        let place = |id: Id| reach.place(id) as u32;
        let operands = |id: Id| match g.node(id).operands() {
            [Some(a), Some(b)] => [place(a), place(b)],
            [a, b] => [a.or(b).map_or(0, place); 2],
        };
        let nodes = reach.ids().map(|id| (id, operands(id))).collect();
        Self { nodes, roots: roots.iter().map(|&id| reach.place(id) as u32).collect() }
    }

    /// Partial derivatives of the roots with respect to one symbol.
    pub fn by(&self, g: &mut Graph, wrt: SymbolId, mode: Derivative) -> Vec<Id> {
        self.along(g, |g, s| if s == wrt { g.one() } else { g.zero() }, mode)
    }

    /// Derivative along a direction, in which each symbol moves with the rate that `rate` gives.
    fn along(&self, g: &mut Graph, rate: impl Fn(&mut Graph, SymbolId) -> Id, mode: Derivative) -> Vec<Id> {
        let zero = g.zero();
        let mut slope: Vec<Id> = Vec::with_capacity(self.nodes.len());
        for &(id, operands) in &self.nodes {
            let value = match g.node(id) {
                Node::Symbol(s) => rate(g, s),
                Node::Number(_) => zero,
                node => match operands.map(|place| slope[place as usize]) {
                    // nothing moves; a division by the number zero says so in its slope too
                    still if still == [zero; 2] && !matches!(node, Node::Div(..)) => zero,
                    moving => g.chain_rule(id, node, moving, mode),
                },
            };
            slope.push(value);
        }
        self.roots.iter().map(|&place| slope[place as usize]).collect()
    }
}

impl Graph {
    /// Partial derivatives of `roots` with respect to one symbol; with respect to several: [`Differentiable`].
    pub fn differentiate(&mut self, roots: &[Id], wrt: SymbolId, mode: Derivative) -> Vec<Id> {
        Differentiable::new(self, roots).by(self, wrt, mode)
    }

    /// Gradient of one expression.
    pub fn gradient(&mut self, root: Id, symbols: &[SymbolId], mode: Derivative) -> Vec<Id> {
        let root = Differentiable::new(self, &[root]);
        symbols.iter().map(|&s| root.by(self, s, mode)[0]).collect()
    }

    /// Jacobian: `result[i][j]` = d `roots[i]` / d `symbols[j]`.
    pub fn jacobian(&mut self, roots: &[Id], symbols: &[SymbolId], mode: Derivative) -> Vec<Vec<Id>> {
        let gathered = Differentiable::new(self, roots);
        let columns: Vec<Vec<Id>> = symbols.iter().map(|&s| gathered.by(self, s, mode)).collect();
        (0..roots.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
    }

    /// Directional derivative: symbols listed in `seeds` move with the given rates.
    pub fn directional(&mut self, roots: &[Id], seeds: &[(SymbolId, Id)]) -> Vec<Id> {
        let rate = |g: &mut Graph, s| seeds.iter().find(|(seed, _)| *seed == s).map_or_else(|| g.zero(), |(_, rate)| *rate);
        Differentiable::new(self, roots).along(self, rate, Derivative::Exact)
    }

    /// Slope of a node from the slopes `da` and `db` of its operands.
    fn chain_rule(&mut self, id: Id, node: Node, [da, db]: [Id; 2], mode: Derivative) -> Id {
        match node {
            Node::Number(_) | Node::Symbol(_) => self.zero(),
            Node::Add(..) => self.add(da, db),
            Node::Sub(..) => self.sub(da, db),
            Node::Mul(a, b) => {
                if a == b {
                    if self.is_zero(da) {
                        return da;
                    }
                    let two = self.num(2.0);
                    let twice = self.mul(two, a);
                    return self.mul(twice, da);
                }
                let left = self.mul(da, b);
                let right = self.mul(a, db);
                self.add(left, right)
            }
            Node::Div(_, b) => {
                // (da - (a/b) db) / b reuses the quotient
                let carried = self.mul(id, db);
                let top = self.sub(da, carried);
                self.div(top, b)
            }
            Node::Neg(_) => self.neg(da),
            Node::Powi(a, n) => {
                if self.is_zero(da) {
                    return da;
                }
                let power = self.powi(a, n - 1);
                let k = self.num(f64::from(n));
                let outer = self.mul(k, power);
                self.mul(outer, da)
            }
            Node::Call(f, a) => {
                if self.is_zero(da) {
                    return da;
                }
                let outer = self.outer_slope(f, a, id, mode);
                self.mul(outer, da)
            }
            Node::Call2(f, a, b) => self.slope2(f, a, b, id, da, db),
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
