//! Measured records, how well a model's free run follows them, and parameters fitted to them.
//!
//! [`record`] reads records as they are (CSV, MATLAB, or a description of another lab's file) and matches them to a
//! model; [`preflight`] inspects them, [`compare`] lays a free run over one, [`fit`] identifies. Knows models through [`runtime::Model`] only; of the rig language only its
//! units. [`static_map`] fits maps without motion to pairs; [`starter`] words a first rig; [`excitation`] proposes a first input; [`spectrum`] has the
//! eigenvalues that statistics ask for.
#![forbid(unsafe_code)]

pub mod compare;
pub mod excitation;
pub mod fit;
pub mod innovations;
pub mod parallel;
pub mod preflight;
pub mod record;
pub mod spectrum;
pub mod starter;
pub mod static_map;
