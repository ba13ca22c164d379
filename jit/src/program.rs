//! A list of roots as a program over slices: interpreted while it is new, machine code once it is in use.
//!
//! Knows both ways and when to change; holds the scratch memory, so that no call allocates.

use crate::compile::{NoCode, compile};
use crate::native::Code;
use crate::tape::Tape;
use codegen::expr::{Graph, Id};
use std::cell::RefCell;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, Ordering};

/// Result slices of a program.
pub const RESULTS: usize = 3;

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
}

/// How a model is evaluated.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Evaluation {
    /// Interpreted at first, compiled after some calls: right for a single question and for a long run.
    #[default]
    Adaptive,
    /// Compiled at the first call; interpreted only where the machine cannot be given code.
    Compiled,
    /// Interpreted always: the reference.
    Interpreted,
}

/// Calls after which a program is compiled. Compiling costs as much time as one to three thousand interpreted calls,
/// whatever the size.
const WARM: u32 = 1000;

/// A program for lists of roots.
pub struct Program {
    tape: Tape,
    evaluation: Evaluation,
    calls: AtomicU32,
    code: OnceLock<Result<Code, NoCode>>,
}

impl Program {
    /// Program of `results` and `pivots`; `n` is the number of coordinates.
    pub fn new(g: &Graph, results: [&[Id]; RESULTS], pivots: &[Id], n: usize, evaluation: Evaluation) -> Self {
        Self { tape: Tape::new(g, results, pivots, n), evaluation, calls: AtomicU32::new(0), code: OnceLock::new() }
    }

    /// Writes the results to `out`.
    ///
    /// # Errors
    /// The place of the first pivot that is not positive; the results are written all the same.
    ///
    /// # Panics
    /// Where a slice is shorter than the program reads, or a result slice has another length than its list.
    pub fn run(&self, a: Arguments, mut out: [&mut [f64]; RESULTS]) -> Result<(), usize> {
        let [x, u, p] = self.tape.lengths;
        assert!(a.x.len() >= x && a.u.len() >= u && a.p.len() >= p, "arguments are too short for this model");
        for (slice, list) in out.iter().zip(&self.tape.results) {
            assert_eq!(slice.len(), list.len(), "a result has another length in this model");
        }
        let pivots = self.tape.pivots.len();
        let first = |scratch: &[f64]| match scratch[..pivots].iter().position(|&d| d.is_nan() || d <= 0.0) {
            // a pivot that is not a number is singular too
            Some(k) => Err(k),
            None => Ok(()),
        };
        match self.code() {
            Some(code) => with_scratch(code.scratch(), |scratch| {
                code.run(a, &mut out, scratch);
                first(scratch)
            }),
            None => with_scratch(pivots + self.tape.steps.len(), |scratch| {
                let (head, values) = scratch.split_at_mut(pivots);
                self.tape.interpret(a, &mut out, head, values);
                first(head)
            }),
        }
    }

    fn code(&self) -> Option<&Code> {
        if let Some(code) = self.code.get() {
            return code.as_ref().ok();
        }
        let wanted = match self.evaluation {
            Evaluation::Interpreted => false,
            Evaluation::Compiled => true,
            Evaluation::Adaptive => self.calls.fetch_add(1, Ordering::Relaxed) >= WARM,
        };
        if !wanted {
            return None;
        }
        // whatever the reason, the interpreter gives the same numbers
        self.code.get_or_init(|| compile(&self.tape)).as_ref().ok()
    }

    /// Why this program is interpreted although it should be compiled by now.
    pub fn interpreted_because(&self) -> Option<&NoCode> {
        self.code.get()?.as_ref().err()
    }
}

/// Numbers that fit on the stack without being felt.
const SMALL: usize = 32;

/// Memory of `length` numbers for the time of one call: on the stack, or kept by the thread.
fn with_scratch<R>(length: usize, run: impl FnOnce(&mut [f64]) -> R) -> R {
    thread_local! {
        static SCRATCH: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
    }
    if length <= SMALL {
        return run(&mut [0.0; SMALL][..length]);
    }
    // taken out, not borrowed: a thread that is shutting down has none, and is given fresh memory
    let mut kept = SCRATCH.try_with(|s| s.take()).unwrap_or_default();
    if kept.len() < length {
        kept.resize(length, 0.0);
    }
    let result = run(&mut kept[..length]);
    let _ = SCRATCH.try_with(|s| s.replace(kept));
    result
}
