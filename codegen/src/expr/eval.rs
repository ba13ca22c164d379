//! Evaluation inside the process without a compiler: a tape of operations over a slice.

use super::graph::{F1, F2, Graph, Id, Node, SymbolId};

/// One operation of a [`Tape`]; operands are positions of earlier results.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Op {
    /// A number.
    Number(f64),
    /// The value of a symbol.
    Symbol(SymbolId),
    /// a + b
    Add(u32, u32),
    /// a - b
    Sub(u32, u32),
    /// a * b
    Mul(u32, u32),
    /// a / b
    Div(u32, u32),
    /// -a
    Neg(u32),
    /// a^n
    Powi(u32, i32),
    /// f(a)
    Call(F1, u32),
    /// f(a, b)
    Call2(F2, u32, u32),
}

/// Straight-line program for a list of roots.
#[derive(Clone, Debug)]
pub struct Tape {
    /// Operations; the result of `ops[i]` is value i.
    pub ops: Vec<Op>,
    /// For each root, the position of its value.
    pub roots: Vec<u32>,
}

impl Graph {
    /// Straight-line program that computes `roots`.
    #[must_use]
    pub fn tape(&self, roots: &[Id]) -> Tape {
        let reach = self.reach(roots);
        let place = |id: Id| reach.place(id) as u32;
        let ops = reach
            .ids()
            .map(|id| match self.node(id) {
                Node::Number(bits) => Op::Number(f64::from_bits(bits)),
                Node::Symbol(s) => Op::Symbol(s),
                Node::Add(a, b) => Op::Add(place(a), place(b)),
                Node::Sub(a, b) => Op::Sub(place(a), place(b)),
                Node::Mul(a, b) => Op::Mul(place(a), place(b)),
                Node::Div(a, b) => Op::Div(place(a), place(b)),
                Node::Neg(a) => Op::Neg(place(a)),
                Node::Powi(a, n) => Op::Powi(place(a), n),
                Node::Call(f, a) => Op::Call(f, place(a)),
                Node::Call2(f, a, b) => Op::Call2(f, place(a), place(b)),
            })
            .collect();
        Tape { ops, roots: roots.iter().map(|&id| place(id)).collect() }
    }

    /// Values of `roots` where each symbol has the value that `value` gives.
    #[must_use]
    pub fn evaluate(&self, roots: &[Id], value: impl Fn(SymbolId) -> f64) -> Vec<f64> {
        self.tape(roots).run(value)
    }
}

impl Tape {
    /// Runs the program.
    #[must_use]
    pub fn run(&self, value: impl Fn(SymbolId) -> f64) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.ops.len());
        for op in &self.ops {
            let of = |i: u32| values[i as usize];
            let result = match *op {
                Op::Number(x) => x,
                Op::Symbol(s) => value(s),
                Op::Add(a, b) => of(a) + of(b),
                Op::Sub(a, b) => of(a) - of(b),
                Op::Mul(a, b) => of(a) * of(b),
                Op::Div(a, b) => of(a) / of(b),
                Op::Neg(a) => -of(a),
                Op::Powi(a, n) => of(a).powi(n),
                Op::Call(f, a) => f.apply(of(a)),
                Op::Call2(f, a, b) => f.apply(of(a), of(b)),
            };
            values.push(result);
        }
        self.roots.iter().map(|&i| values[i as usize]).collect()
    }
}
