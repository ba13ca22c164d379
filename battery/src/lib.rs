//! The battery: rigs in which an effect is hidden, or none, and what the diagnosis makes of their records.
//!
//! `truth` simulates, by code that the fitting side does not have; `rigs` are the six rigs, `conditions` the experiments and what is wrong
//! with them, `hide` hides effects, `run` makes one run, `rows` lists the runs of a row, `table` counts; `examples` are the
//! records of `examples/hidden`, `growth` is what a diagnosis costs.
// dynamics are written by index, as in the books
#![allow(clippy::needless_range_loop)]
#![forbid(unsafe_code)]

pub mod conditions;
pub mod examples;
pub mod growth;
pub mod hide;
pub mod rigs;
pub mod rows;
pub mod run;
pub mod table;
pub mod truth;
