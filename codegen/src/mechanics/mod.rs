//! Mechanics: from bodies, joints and forces to generalized quantities, on two roads.
//!
//! `newton_euler` goes body by body; `lagrange` goes through T and V; `check` compares them for
//! every rig. `forces`, `friction`, `stored` turn what acts on the bodies into generalized forces.
//! `direct` serves equations that were written directly. Nothing here knows of output or of text.

pub mod bodies;
pub mod direct;
pub mod forces;
pub mod friction;
pub mod lagrange;
pub mod newton_euler;
pub mod solve;
pub mod stored;
pub mod tree;
pub mod vector;
