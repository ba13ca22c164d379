//! How a run ends.

use std::fmt;

/// How a run ended, with the time where it did.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// The whole time was simulated.
    Completed,
    /// The mass matrix turned singular: this coordinate moves no inertia here.
    Singular {
        /// Name of the coordinate.
        coordinate: String,
        /// Time [s].
        t: f64,
    },
    /// A state grew beyond all numbers.
    NotFinite {
        /// Name of the state.
        state: String,
        /// Time [s].
        t: f64,
    },
    /// The step size fell below what the time can resolve: the solution has a pole or a jump here.
    StepCollapsed {
        /// Time [s].
        t: f64,
    },
    /// The allowed number of steps was used up.
    TooManySteps {
        /// Time [s].
        t: f64,
        /// Steps taken, rejected ones included.
        steps: usize,
    },
}

impl Status {
    /// The word for tables and JSON: `completed`, `singular`, `not_finite`, `step_collapsed`, `too_many_steps`.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::Completed => "completed",
            Self::Singular { .. } => "singular",
            Self::NotFinite { .. } => "not_finite",
            Self::StepCollapsed { .. } => "step_collapsed",
            Self::TooManySteps { .. } => "too_many_steps",
        }
    }

    /// Time at which the run ended early [s].
    #[must_use]
    pub fn time(&self) -> Option<f64> {
        match self {
            Self::Completed => None,
            Self::Singular { t, .. } | Self::NotFinite { t, .. } | Self::StepCollapsed { t } | Self::TooManySteps { t, .. } => Some(*t),
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Completed => f.write_str("completed"),
            Self::Singular { coordinate, t } => write!(f, "the mass matrix turned singular in `{coordinate}` at t = {t:.4} s"),
            Self::NotFinite { state, t } => write!(f, "`{state}` grew beyond all numbers at t = {t:.4} s"),
            Self::StepCollapsed { t } => write!(f, "the step size collapsed at t = {t:.4} s"),
            Self::TooManySteps { t, steps } => write!(f, "{steps} steps were used up at t = {t:.4} s"),
        }
    }
}
