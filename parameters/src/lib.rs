//! What a rig's equations can tell of its parameters, before any record: the minimal set, the relations between
//! lumps, and whether the declared masses and inertias can belong to a body.
//!
//! Works on checked rigs and derived equations; knows nothing of records, files and terminals.
#![forbid(unsafe_code)]

mod base;
mod consistency;
mod draws;
mod rank;
mod relations;

pub use base::{Base, BaseParameter, Links, TOLERANCE, base_parameters, links};
pub use consistency::{Finding, Inertia, Verdict, bodies, verdict};
pub use relations::{Known, Relation, Relations, of_base, of_lumps};
