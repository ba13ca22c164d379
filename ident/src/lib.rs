//! Measured records, and how well a model's free run follows them.
//!
//! [`record`] reads records as they are (CSV, MATLAB, or a description of another lab's file) and matches them to a
//! model; [`compare`] lays a free run over one. Knows models through [`runtime::Model`] only; of the rig language only its
//! units.
#![forbid(unsafe_code)]

pub mod compare;
pub mod record;
