//! A list of roots as a program over slices: a tape, interpreted.

use codegen::expr::{Graph, Id, Op, SymbolKind};

/// Arguments of a program.
#[derive(Clone, Copy)]
pub struct Arguments<'a> {
    /// Time [s].
    pub t: f64,
    /// State.
    pub x: &'a [f64],
    /// Signals.
    pub u: &'a [f64],
    /// Parameters.
    pub p: &'a [f64],
    /// Accelerations.
    pub a: &'a [f64],
}

#[derive(Clone, Copy)]
enum Source {
    Time,
    X(usize),
    U(usize),
    P(usize),
    A(usize),
    Missing,
}

/// A program for a list of roots.
pub struct Program {
    ops: Vec<Op>,
    roots: Vec<u32>,
    sources: Vec<Source>,
}

impl Program {
    /// Program of `roots`; `n` is the number of coordinates.
    pub fn new(g: &Graph, roots: &[Id], n: usize) -> Self {
        let tape = g.tape(roots);
        let sources = g
            .symbols()
            .map(|(_, s)| match s.kind {
                SymbolKind::Time => Source::Time,
                SymbolKind::Coordinate(i) => Source::X(i),
                SymbolKind::Rate(i) => Source::X(n + i),
                SymbolKind::Lag(i) => Source::X(2 * n + i),
                SymbolKind::Signal(i) => Source::U(i),
                SymbolKind::Parameter(i) => Source::P(i),
                SymbolKind::Acceleration(i) => Source::A(i),
                SymbolKind::Definition(_) | SymbolKind::Inertial(_) => Source::Missing,
            })
            .collect();
        Self { ops: tape.ops, roots: tape.roots, sources }
    }

    /// Values of the roots, written to `out`.
    pub fn run(&self, a: Arguments, out: &mut [f64]) {
        let mut values = Vec::with_capacity(self.ops.len());
        for op in &self.ops {
            let of = |i: u32| -> f64 { values[i as usize] };
            let value = match *op {
                Op::Number(x) => x,
                Op::Symbol(s) => match self.sources[s.index()] {
                    Source::Time => a.t,
                    Source::X(i) => a.x[i],
                    Source::U(i) => a.u[i],
                    Source::P(i) => a.p[i],
                    Source::A(i) => a.a[i],
                    Source::Missing => f64::NAN,
                },
                Op::Add(i, j) => of(i) + of(j),
                Op::Sub(i, j) => of(i) - of(j),
                Op::Mul(i, j) => of(i) * of(j),
                Op::Div(i, j) => of(i) / of(j),
                Op::Neg(i) => -of(i),
                Op::Powi(i, n) => of(i).powi(n),
                Op::Call(f, i) => f.apply(of(i)),
                Op::Call2(f, i, j) => f.apply(of(i), of(j)),
            };
            values.push(value);
        }
        for (slot, &root) in out.iter_mut().zip(&self.roots) {
            *slot = values[root as usize];
        }
    }
}
