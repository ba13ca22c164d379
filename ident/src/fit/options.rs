//! The choices of a fit.

use super::minimize::Limits;
use sim::{Hold, Pattern};

/// How output errors are made comparable.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Weights {
    /// By their standard deviation, estimated for each output together with the parameters: maximum likelihood for white
    /// errors. The default.
    #[default]
    Noise,
    /// By the standard deviation of the measured signal, for each record and output: makes the outputs' fit in percent
    /// count alike.
    Spread,
    /// By given scales (SI) for outputs, by name; outputs that are not named are not used.
    Given(Vec<(String, f64)>),
}

/// What large errors cost; with z the error over its scale, the cost of one is rho(z)/2.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Loss {
    /// z^2.
    #[default]
    Squares,
    /// Huber: z^2 up to k, then 2 k |z| - k^2. 95 % efficient at k = 1.345 where errors are normal.
    Huber(
        /// k.
        f64,
    ),
    /// Cauchy: k^2 ln(1 + (z/k)^2). 95 % efficient at k = 2.385.
    Cauchy(
        /// k.
        f64,
    ),
}

impl Loss {
    /// (rho, weight): the cost is rho/2, the gradient weight z.
    #[must_use]
    pub(crate) fn of(self, z: f64) -> (f64, f64) {
        match self {
            Self::Squares => (z * z, 1.0),
            Self::Huber(k) if z.abs() <= k => (z * z, 1.0),
            Self::Huber(k) => (2.0 * k * z.abs() - k * k, k / z.abs()),
            Self::Cauchy(k) => {
                let s = (z / k) * (z / k);
                (k * k * s.ln_1p(), 1.0 / (1.0 + s))
            }
        }
    }
}

/// What is known of a part of the initial state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// It is what the first samples say.
    Fixed,
    /// The first samples give a prior: value and standard error.
    Prior,
    /// It is fitted without one.
    Free,
}

/// How the initial states of the records are treated; without it, as each record says how it starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InitialStates {
    /// Coordinates.
    pub coordinates: Known,
    /// Rates; `Fixed` means at rest.
    pub rates: Known,
}

/// Where a fit starts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Starting {
    /// Nominal values and those from equation error, whichever fit better. The default.
    #[default]
    Best,
    /// The values of the specification.
    Nominal,
    /// Equation error.
    EquationError,
}

/// Choices of a fit.
#[derive(Clone, Debug)]
pub struct FitOptions {
    /// How output errors are weighted.
    pub weights: Weights,
    /// What large errors cost.
    pub loss: Loss,
    /// Initial states of the training records.
    pub initial: Option<InitialStates>,
    /// What logged inputs do between samples.
    pub hold: Hold,
    /// Starting values.
    pub starting: Starting,
    /// Multiple shooting: length of the pieces [s].
    pub shooting: Option<f64>,
    /// Whether pieces of multiple shooting are held together at their ends. Where they are not, each is a short run of its
    /// own from a fitted state: the way for rigs whose free run is unstable or driven by what the model does not know.
    pub joined: bool,
    /// Judge by predictions over this many seconds [s] instead of free runs; `None`: where the free run says nothing.
    pub horizon: Option<f64>,
    /// Integration steps; `None` chooses them so that the outputs' error stays below `tolerance`.
    pub pattern: Option<Pattern>,
    /// Allowed integration error of an output, in parts of its encoder's quantum, or of a 1e-4 part of its spread where it
    /// has none.
    pub tolerance: f64,
    /// When the search ends.
    pub limits: Limits,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            weights: Weights::default(),
            loss: Loss::default(),
            initial: None,
            hold: Hold::default(),
            starting: Starting::default(),
            shooting: None,
            joined: true,
            horizon: None,
            pattern: None,
            tolerance: 1e-3,
            limits: Limits::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Loss;

    #[test]
    fn losses_are_squares_near_zero_and_their_weights_are_slopes() {
        for loss in [Loss::Squares, Loss::Huber(1.345), Loss::Cauchy(2.385)] {
            assert!((loss.of(1e-3).0 - 1e-6).abs() < 1e-11);
            for z in [-4.0, -0.5, 0.3, 2.0, 7.0] {
                let h = 1e-5;
                let slope = (loss.of(z + h).0 - loss.of(z - h).0) / (4.0 * h);
                assert!((slope - loss.of(z).1 * z).abs() < 1e-8, "{loss:?} at {z}");
            }
        }
    }
}
