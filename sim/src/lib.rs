//! Trajectories of a model: integration from input switch to input switch, with a status for every way a run ends.
//!
//! A signal passes limits and delay (`input_path`), then x' = f(t, x, u, p) is integrated, then outputs are delayed and,
//! if asked for, quantized (`output_path`). [`simulate`] is adaptive; [`Forward`] has a fixed step and carries exact
//! derivatives with respect to the initial state and the parameters. Knows models through [`runtime::Model`] only;
//! knows nothing of rigs, text and records.
#![forbid(unsafe_code)]

mod error;
mod integrate;
mod output_path;
mod sensitivity;
mod signals;
mod simulate;
mod status;
mod tableau;

pub use error::SimError;
pub use integrate::Method;
pub use output_path::{encoder, play};
pub use sensitivity::{Forward, Pattern, Sink};
pub use signals::{Hold, Path, Segment, Signal, Signals};
pub use simulate::input_paths;
pub use simulate::{Options, Trajectory, simulate};
pub use status::Status;
pub use tableau::FixedMethod;
