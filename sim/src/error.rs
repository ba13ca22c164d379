//! What can be wrong with the arguments of a simulation. How a run ends is a `Status`, not an error.

use std::fmt;

/// Why no simulation was started.
#[derive(Clone, Debug, PartialEq)]
pub enum SimError {
    /// A vector has the wrong length.
    Length {
        /// What it is: `parameters`.
        what: &'static str,
        /// Length that the model needs.
        wanted: usize,
        /// Length that was given.
        found: usize,
    },
    /// A number is not finite.
    NotFinite {
        /// Which: `initial state eps.dot`.
        what: String,
    },
    /// Time stamps do not increase.
    Order {
        /// `times of the outputs` or `time stamps of the signals`.
        what: &'static str,
        /// Index of the first stamp that is not later than the one before it.
        index: usize,
        /// That stamp [s].
        t: f64,
    },
    /// There is nothing to simulate or no signal sample.
    Empty {
        /// What is empty.
        what: &'static str,
    },
    /// A tolerance or step is not a positive number.
    Option {
        /// Which.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A delay of the model is negative or not finite with these parameters.
    Delay {
        /// Input or output.
        of: String,
        /// Its value [s].
        value: f64,
    },
    /// A play of the model is negative or not finite with these parameters.
    Play {
        /// Output.
        of: String,
        /// Its value (SI).
        value: f64,
    },
}

impl fmt::Display for SimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { what, wanted, found } => write!(f, "{found} {what} were given, the model has {wanted}"),
            Self::NotFinite { what } => write!(f, "{what} is not a finite number"),
            Self::Order { what, index, t } => write!(f, "the {what} must increase, number {} ({t} s) does not", index + 1),
            Self::Empty { what } => write!(f, "there are no {what}"),
            Self::Option { what, value } => write!(f, "{what} must be a positive number, not {value}"),
            Self::Delay { of, value } => write!(f, "the delay of {of} is {value} s; a delay is zero or positive"),
            Self::Play { of, value } => write!(f, "the play of {of} is {value}; a play is zero or positive"),
        }
    }
}

impl std::error::Error for SimError {}
