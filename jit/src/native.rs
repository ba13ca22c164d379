//! The one place with `unsafe`: machine code is owned, called and freed here.
//!
//! What the safety of a call rests on: [`Code`] is made only by [`crate::compile`] from a [`Tape`], whose code reads
//! inputs below `tape.lengths`, writes results below the lengths of `tape.results`, and touches scratch below
//! [`Code::scratch`]; [`Code::run`] is given that tape's slices after their lengths were checked.
#![allow(unsafe_code)]

use crate::program::{Arguments, RESULTS};
use crate::tape::Tape;
use cranelift_jit::JITModule;
use cranelift_module::FuncId;
use std::sync::Mutex;

/// What machine code is given: one pointer to this. `compile` knows the offsets.
#[repr(C)]
pub struct Frame {
    /// Time.
    pub t: f64,
    /// State.
    pub x: *const f64,
    /// Signals.
    pub u: *const f64,
    /// Parameters.
    pub p: *const f64,
    /// Result slices.
    pub out: [*mut f64; RESULTS],
    /// Scratch memory, the pivots first.
    pub scratch: *mut f64,
}

type Entry = unsafe extern "C" fn(*const Frame);

/// Machine code of one program.
pub struct Code {
    /// Run one after the other.
    entries: Vec<Entry>,
    scratch: usize,
    lengths: ([usize; 3], [usize; RESULTS]),
    /// Owns the memory that `entries` point into. Taken out on drop only; the lock makes the module shareable.
    module: Mutex<Option<JITModule>>,
}

impl Code {
    /// Takes a module whose definitions are finalized. `parts` were compiled from `tape` with the signature of
    /// [`Entry`] in the host's C calling convention, and need `scratch` numbers of scratch memory.
    pub fn new(module: JITModule, parts: &[FuncId], tape: &Tape, scratch: usize) -> Self {
        let entries = parts
            .iter()
            .map(|&id| {
                let start = module.get_finalized_function(id);
                // SAFETY: `start` is the address of a finalized function with the signature of `Entry` in the
                // host's C calling convention, and stays valid as long as `module` is not freed, which is
                // when `entries` is dropped too. Function and data pointers have one size on every host that
                // cranelift has a backend for.
                unsafe { std::mem::transmute::<*const u8, Entry>(start) }
            })
            .collect();
        let results = std::array::from_fn(|k| tape.results[k].len());
        Self { entries, scratch: scratch.max(tape.pivots.len()), lengths: (tape.lengths, results), module: Mutex::new(Some(module)) }
    }

    /// Numbers of scratch memory that a call needs.
    pub fn scratch(&self) -> usize {
        self.scratch
    }

    /// Runs the code.
    ///
    /// # Panics
    /// Where a slice is shorter than the code reads or writes.
    pub fn run(&self, a: Arguments, out: &mut [&mut [f64]; RESULTS], scratch: &mut [f64]) {
        let ([x, u, p], results) = self.lengths;
        assert!(a.x.len() >= x && a.u.len() >= u && a.p.len() >= p && scratch.len() >= self.scratch);
        assert!(out.iter().zip(results).all(|(slice, length)| slice.len() >= length));
        let frame = Frame {
            t: a.t,
            x: a.x.as_ptr(),
            u: a.u.as_ptr(),
            p: a.p.as_ptr(),
            out: out.each_mut().map(|o| o.as_mut_ptr()),
            scratch: scratch.as_mut_ptr(),
        };
        for entry in &self.entries {
            // SAFETY: the code lives (see `new`); it reads and writes through the frame's pointers below the
            // lengths that were asserted above, and the borrows `a`, `out` and `scratch` outlive the call. It keeps
            // no pointer, and reads no memory but the frame, so that several threads may run it at once.
            unsafe { entry(&raw const frame) };
        }
    }
}

impl Drop for Code {
    fn drop(&mut self) {
        let module = self.module.get_mut().unwrap_or_else(std::sync::PoisonError::into_inner).take();
        if let Some(module) = module {
            // SAFETY: `self` is borrowed mutably, so no call is under way, and `entries` are never given out:
            // none of them can be called after this.
            unsafe { module.free_memory() };
        }
    }
}

/// sin and cos of an angle at once, to `out[0]` and `out[1]`.
///
/// # Safety
/// `out` points to memory for two numbers.
pub unsafe extern "C" fn sin_cos(x: f64, out: *mut f64) {
    let (sin, cos) = x.sin_cos();
    // SAFETY: what the caller promises. `compile` passes the address of two neighbouring scratch numbers.
    unsafe {
        *out = sin;
        *out.add(1) = cos;
    }
}
