//! A list of roots as straight-line steps in an order of evaluation: what both ways of running a program
//! start from, and the reference way itself (an interpreter).
//!
//! Knows the graph; knows nothing of machine code. Calls of elementary functions come first, as far as their
//! arguments allow: machine code keeps no floating-point register across a call.

use crate::program::{Arguments, RESULTS};
use codegen::expr::{F1, F2, Graph, Id, Op, SymbolKind};

/// Where an input of a program stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// Time.
    Time,
    /// Entry of the state.
    X(usize),
    /// Entry of the signals.
    U(usize),
    /// Entry of the parameters.
    P(usize),
}

/// One step; operands are positions of earlier steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A number.
    Number(f64),
    /// An input.
    Input(Input),
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

impl Step {
    /// Operands.
    pub fn operands(self) -> impl Iterator<Item = u32> {
        let pair = match self {
            Step::Number(_) | Step::Input(_) => [None, None],
            Step::Add(a, b) | Step::Sub(a, b) | Step::Mul(a, b) | Step::Div(a, b) | Step::Call2(_, a, b) => [Some(a), Some(b)],
            Step::Neg(a) | Step::Powi(a, _) | Step::Call(_, a) => [Some(a), None],
        };
        pair.into_iter().flatten()
    }

    /// Costs nothing: a number or an input.
    pub fn is_leaf(self) -> bool {
        matches!(self, Step::Number(_) | Step::Input(_))
    }
}

/// Steps, and which of their values are results.
pub struct Tape {
    /// Steps in an order of evaluation.
    pub steps: Vec<Step>,
    /// Positions of the results' values, one list a result slice.
    pub results: [Vec<u32>; RESULTS],
    /// Positions of the pivots' values: a program reports the first that is not positive.
    pub pivots: Vec<u32>,
    /// Least lengths of x, u and p.
    pub lengths: [usize; 3],
}

impl Tape {
    /// Steps for results and pivots; `n` is the number of coordinates.
    pub fn new(g: &Graph, results: [&[Id]; RESULTS], pivots: &[Id], n: usize) -> Self {
        let roots: Vec<Id> = results.iter().copied().flatten().chain(pivots).copied().collect();
        let tape = g.tape(&roots);
        let steps: Vec<Step> = tape.ops.iter().map(|op| step(g, *op, n)).collect();
        let (steps, place) = calls_first(&steps);
        let mut lengths = [0; 3];
        for step in &steps {
            let (which, i) = match step {
                Step::Input(Input::X(i)) => (0, *i),
                Step::Input(Input::U(i)) => (1, *i),
                Step::Input(Input::P(i)) => (2, *i),
                _ => continue,
            };
            lengths[which] = lengths[which].max(i + 1);
        }
        let mut roots = tape.roots.iter().map(|&r| place[r as usize]);
        let results = results.map(|list| roots.by_ref().take(list.len()).collect());
        Self { steps, results, pivots: roots.collect(), lengths }
    }

    /// Runs the steps one by one: the reference, and the way for a program that is seldom asked.
    pub fn interpret(&self, a: Arguments, out: &mut [&mut [f64]; RESULTS], pivots: &mut [f64], values: &mut [f64]) {
        for (i, step) in self.steps.iter().enumerate() {
            let of = |i: u32| -> f64 { values[i as usize] };
            values[i] = match *step {
                Step::Number(x) => x,
                Step::Input(Input::Time) => a.t,
                Step::Input(Input::X(i)) => a.x[i],
                Step::Input(Input::U(i)) => a.u[i],
                Step::Input(Input::P(i)) => a.p[i],
                Step::Add(i, j) => of(i) + of(j),
                Step::Sub(i, j) => of(i) - of(j),
                Step::Mul(i, j) => of(i) * of(j),
                Step::Div(i, j) => of(i) / of(j),
                Step::Neg(i) => -of(i),
                Step::Powi(i, n) => of(i).powi(n),
                Step::Call(f, i) => f.apply(of(i)),
                Step::Call2(f, i, j) => f.apply(of(i), of(j)),
            };
        }
        for (slice, places) in out.iter_mut().zip(&self.results) {
            for (slot, &place) in slice.iter_mut().zip(places) {
                *slot = values[place as usize];
            }
        }
        for (slot, &place) in pivots.iter_mut().zip(&self.pivots) {
            *slot = values[place as usize];
        }
    }
}

fn step(g: &Graph, op: Op, n: usize) -> Step {
    match op {
        Op::Number(x) => Step::Number(x),
        Op::Symbol(s) => match g.symbol_info(s).kind {
            SymbolKind::Time => Step::Input(Input::Time),
            SymbolKind::Coordinate(i) => Step::Input(Input::X(i)),
            SymbolKind::Rate(i) => Step::Input(Input::X(n + i)),
            SymbolKind::Lag(i) => Step::Input(Input::X(2 * n + i)),
            SymbolKind::Signal(i) => Step::Input(Input::U(i)),
            SymbolKind::Parameter(i) => Step::Input(Input::P(i)),
            // solved for, or kept for display only: no quantity of a model reads them
            SymbolKind::Acceleration(_) | SymbolKind::Definition(_) | SymbolKind::Inertial(_) => Step::Number(f64::NAN),
        },
        Op::Add(a, b) => Step::Add(a, b),
        Op::Sub(a, b) => Step::Sub(a, b),
        Op::Mul(a, b) => Step::Mul(a, b),
        Op::Div(a, b) => Step::Div(a, b),
        Op::Neg(a) => Step::Neg(a),
        Op::Powi(a, n) => Step::Powi(a, n),
        Op::Call(f, a) => Step::Call(f, a),
        Op::Call2(f, a, b) => Step::Call2(f, a, b),
    }
}

/// Steps that calls need and calls, then the rest, each in its old order; and the new place of each old step.
fn calls_first(steps: &[Step]) -> (Vec<Step>, Vec<u32>) {
    let mut early: Vec<bool> = steps.iter().map(|s| matches!(s, Step::Call(..) | Step::Call2(..))).collect();
    for i in (0..steps.len()).rev() {
        if early[i] {
            for operand in steps[i].operands() {
                early[operand as usize] = true;
            }
        }
    }
    let order = (0..steps.len()).filter(|&i| early[i]).chain((0..steps.len()).filter(|&i| !early[i]));
    let mut place = vec![0_u32; steps.len()];
    let mut sorted = Vec::with_capacity(steps.len());
    for i in order {
        place[i] = sorted.len() as u32;
        let of = |a: u32| place[a as usize];
        sorted.push(match steps[i] {
            leaf @ (Step::Number(_) | Step::Input(_)) => leaf,
            Step::Add(a, b) => Step::Add(of(a), of(b)),
            Step::Sub(a, b) => Step::Sub(of(a), of(b)),
            Step::Mul(a, b) => Step::Mul(of(a), of(b)),
            Step::Div(a, b) => Step::Div(of(a), of(b)),
            Step::Neg(a) => Step::Neg(of(a)),
            Step::Powi(a, n) => Step::Powi(of(a), n),
            Step::Call(f, a) => Step::Call(f, of(a)),
            Step::Call2(f, a, b) => Step::Call2(f, of(a), of(b)),
        });
    }
    (sorted, place)
}
