//! What generated code and its users share: the model trait, a mathematics shim, LDL^T.
//!
//! `no_std`, no heap, no `unsafe`. Knows nothing of rigs, text or files. Generated models
//! implement [`Model`] by a thin adaptor over their named functions; the in-process model
//! implements the same trait, so that identification and control cannot tell them apart.
//!
//! With the feature `std` the elementary functions are those of the standard library, which are
//! faster; without it, those of the crate `libm`, which need no operating system.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

mod glue;
pub mod math;
mod model;

pub use glue::{array, positive, write, write_at};
pub use model::{Dimensions, InputPath, Model, Names, OutputPath, Singular, StateKind, sensitivities_by_parts};
