//! What generated code and its users share: the model trait, a mathematics shim, LDL^T.
//!
//! `no_std`, no heap, no `unsafe`. Knows nothing of rigs, text or files. Generated models
//! implement [`Model`] by a thin adaptor over their named functions; the in-process model
//! implements the same trait, so that identification and control cannot tell them apart.
//!
//! The elementary functions are those of the crate `libm`, which need no operating system and are the
//! faster ones where this was measured (sine and cosine together 9 ns, of the standard library 13 ns);
//! with the feature `std` they are those of the standard library.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

mod glue;
pub mod math;
mod model;

pub use glue::{array, positive, write, write_rows};
pub use model::{Dimensions, InputPath, Model, Names, OutputPath, Singular, StateKind, sensitivities_by_parts};
