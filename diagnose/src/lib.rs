//! Where simulation and measured record disagree, which physical effect is missing, what the rig's text looks like with it, and how
//! far the gap shrinks on a record that was not used.
//!
//! [`diagnose`] is the way in; `workflow` is its list of steps. The model is a text, so an effect is a line of text ([`effects`]); a
//! patched text is derived like any other ([`patch`]). Statistics are those of a filter that lets the rig be pushed at random
//! ([`ident::innovations`]); all candidates are scored at once (`screen`), the few best refitted, and one accepted only if records that it
//! was not found on agree (`accept`).
//!
//! Knows the rig language, the derivation and `ident`; reads no files and prints nothing.
#![forbid(unsafe_code)]

mod accept;
mod answer;
mod base_fit;
mod beginning;
mod chance;
mod compliance;
pub mod effects;
mod error;
mod figures;
pub mod forces;
mod locate;
mod model;
mod next;
mod options;
pub mod patch;
mod quality;
mod regulated;
mod screen;
mod search;
mod shapes;
mod shown;
mod strained;
mod strangers;
mod swap;
mod together;
mod traces;
mod turn;
mod unseen;
mod verdict;
mod watched;
mod workflow;

pub use answer::{Candidate, Diagnosis, EffectValue, Figure, Figures, Finding, Moved, Overlaid, Place, Pushed, Traced, Verdict};
pub use chance::Chance;
pub use error::DiagnoseError;
pub use options::{Method, Options, Step};
pub use workflow::diagnose;
