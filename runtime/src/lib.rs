//! What generated code and its users share: the model trait, a mathematics shim, LDL^T.
//!
//! `no_std`, no heap, no `unsafe`. Knows nothing of rigs, text or files. Generated models
//! implement [`Model`] by a thin adaptor over their named functions; the in-process model
//! implements the same trait, so that identification and control cannot tell them apart.
#![no_std]
#![forbid(unsafe_code)]

pub mod math;
mod model;

pub use model::{Dimensions, InputPath, Model, Names, OutputPath, Singular, StateKind};
