//! Linear-quadratic regulators by name: continuous and sampled, of a part of the plant, with integral action.
//!
//! u = u* - K (x - x*) - K_i z, with z' = y - y* for each integrated quantity (sampled: z(k+1) = z(k) + T (y - y*)).
//!
//! A design that keeps a part of the states treats the others as constants at the operating point: exact where no
//! left-out state enters the rates of kept ones (yaw on a 3-DOF helicopter), an approximation otherwise; the couplings
//! that it neglects are listed, and the poles of the whole plant with the gain in place are returned beside the
//! design's own.

use crate::discretize::{SampleError, sampled_cost, zero_order_hold};
use crate::gain::back_calculation;
use crate::modes::Time;
use crate::plant::{Coupling, NameError, Plant};
use crate::riccati::{RiccatiData, RiccatiError, solve};
use crate::schur::{NoConvergence, eigenvalues};
use crate::weight::{Weight, WeightError, Weighted};
use nalgebra::{Complex, DMatrix};
use std::fmt;

/// How the controller runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    /// Continuous time; the cost is the integral of x^T Q x + u^T R u.
    Continuous,
    /// Inputs held over a period [s]; the cost is the sum of x^T Q x + u^T R u over the samples (MATLAB's `dlqr`).
    Sum {
        /// Period [s].
        period: f64,
    },
    /// Inputs held over a period [s]; the cost is the integral, as in continuous time (MATLAB's `lqrd`).
    Integral {
        /// Period [s].
        period: f64,
    },
}

impl Sampling {
    /// Period [s], if there is one.
    #[must_use]
    pub fn period(self) -> Option<f64> {
        match self {
            Self::Continuous => None,
            Self::Sum { period } | Self::Integral { period } => Some(period),
        }
    }

    fn time(self) -> Time {
        if self.period().is_some() { Time::Discrete } else { Time::Continuous }
    }
}

/// What is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct LqrDesign {
    /// States that are kept, in the order of the weights and of K's columns; empty: all.
    pub states: Vec<String>,
    /// Outputs (or states) whose deviation is integrated; their weights follow those of the states.
    pub integrate: Vec<String>,
    /// Q: one weight for each kept state, then one for each integrated quantity.
    pub weight_x: Weight,
    /// R.
    pub weight_u: Weight,
    /// Continuous or sampled.
    pub sampling: Sampling,
}

/// A regulator.
#[derive(Clone, Debug, PartialEq)]
pub struct Lqr {
    /// Columns of K: kept states, then `y.integral` for each integrated quantity.
    pub states: Vec<String>,
    /// How many of `states` are integrals.
    pub integrals: usize,
    /// Rows of K.
    pub inputs: Vec<String>,
    /// K (inputs x states).
    pub k: DMatrix<f64>,
    /// Solution of the Riccati equation (states x states): the cost from x is x^T P x.
    pub p: DMatrix<f64>,
    /// Poles of the kept part with the gain in place (of z in discrete time).
    pub poles: Vec<Complex<f64>>,
    /// Poles of the whole plant with the gain in place.
    pub plant_poles: Vec<Complex<f64>>,
    /// Relative residual of the Riccati equation.
    pub residual: f64,
    /// What the design neglects by leaving states out.
    pub neglected: Vec<Coupling>,
    /// Anti-windup gain L (integrals x inputs) of z' = y - y* + L (u_applied - u_asked), by back-calculation:
    /// while inputs saturate, z follows them with the time constant `tracking_time`. No rows without integrals.
    pub anti_windup: DMatrix<f64>,
    /// Time constant of back-calculation [s]: the geometric mean of the slowest and the fastest pole's.
    pub tracking_time: f64,
    /// Period [s], if sampled.
    pub period: Option<f64>,
}

/// Why there is no regulator.
#[derive(Clone, Debug, PartialEq)]
pub enum LqrError {
    /// A state, input or output that the plant does not have.
    Name(NameError),
    /// A weight is wrong.
    Weight(WeightError),
    /// No states or no inputs.
    Empty,
    /// The plant cannot be sampled like this.
    Sampling(SampleError),
    /// The Riccati equation has no solution.
    Riccati {
        /// Why.
        error: RiccatiError,
        /// Names of the states of the equation.
        states: Vec<String>,
    },
    /// A matrix of the plant is not finite.
    NoConvergence(NoConvergence),
}

impl fmt::Display for LqrError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(e) => e.fmt(f),
            Self::Weight(e) => e.fmt(f),
            Self::Empty => f.write_str("a design needs at least one state and one input"),
            Self::Sampling(e) => e.fmt(f),
            Self::Riccati { error, states } => f.write_str(&error.with_names(states)),
            Self::NoConvergence(e) => e.fmt(f),
        }
    }
}

impl std::error::Error for LqrError {}

/// Designs a regulator.
///
/// # Errors
/// [`LqrError`], one variant a cause.
pub fn lqr(plant: &Plant, design: &LqrDesign) -> Result<Lqr, LqrError> {
    let keep = if design.states.is_empty() {
        (0..plant.states.len()).collect()
    } else {
        plant.states_by_name(&design.states).map_err(LqrError::Name)?
    };
    if keep.is_empty() || plant.inputs.is_empty() {
        return Err(LqrError::Empty);
    }
    let part = plant.part(&keep);
    let readings = design.integrate.iter().map(|name| part.reading(name).map_err(LqrError::Name)).collect::<Result<Vec<_>, _>>()?;
    let mut states = part.states.clone();
    states.extend(design.integrate.iter().map(|name| format!("{name}.integral")));
    let q = design.weight_x.matrix(Weighted::States, &states).map_err(LqrError::Weight)?;
    let r = design.weight_u.matrix(Weighted::Inputs, &plant.inputs).map_err(LqrError::Weight)?;

    let (a, b) = with_integrals(&part.a, &part.b, &readings, design.sampling)?;
    let cost = match design.sampling {
        Sampling::Integral { period } => {
            let (a, b) = with_integrals(&part.a, &part.b, &readings, Sampling::Continuous)?;
            let cost = sampled_cost(&a, &b, &q, &r, period).map_err(LqrError::Sampling)?;
            (cost.q, cost.r, Some(cost.n))
        }
        Sampling::Continuous | Sampling::Sum { .. } => (q, r, None),
    };
    let data = RiccatiData { a: &a, b: &b, q: &cost.0, r: &cost.1, cross: cost.2.as_ref() };
    let solution = solve(data, design.sampling.time()).map_err(|error| LqrError::Riccati { error, states: states.clone() })?;

    let whole: Vec<DMatrix<f64>> = readings.iter().map(|row| spread(row, &keep, plant.states.len())).collect();
    let (a, b) = with_integrals(&plant.a, &plant.b, &whole, design.sampling)?;
    let integrals = readings.len();
    let mut columns: Vec<usize> = keep.clone();
    columns.extend(plant.states.len()..plant.states.len() + integrals);
    let closed = a - b * spread(&solution.gain, &columns, plant.states.len() + integrals);
    let plant_poles = eigenvalues(&closed).map_err(LqrError::NoConvergence)?;

    let tracking_time = tracking_time(&solution.poles, design.sampling);
    let k_i = solution.gain.columns(keep.len(), integrals).into_owned();
    let anti_windup = back_calculation(&k_i, tracking_time);
    Ok(Lqr {
        states,
        integrals,
        inputs: plant.inputs.clone(),
        k: solution.gain,
        p: solution.x,
        poles: solution.poles,
        plant_poles,
        residual: solution.residual,
        neglected: plant.neglected(&keep),
        anti_windup,
        tracking_time,
        period: design.sampling.period(),
    })
}

/// Columns of a part put where they stand in the whole.
fn spread(part: &DMatrix<f64>, columns: &[usize], width: usize) -> DMatrix<f64> {
    let mut whole = DMatrix::zeros(part.nrows(), width);
    for (k, &j) in columns.iter().enumerate() {
        whole.set_column(j, &part.column(k));
    }
    whole
}

/// The (sampled) plant with the integrals behind its states.
fn with_integrals(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    readings: &[DMatrix<f64>],
    sampling: Sampling,
) -> Result<(DMatrix<f64>, DMatrix<f64>), LqrError> {
    let (plant_a, plant_b) = match sampling.period() {
        None => (a.clone(), b.clone()),
        Some(period) => zero_order_hold(a, b, period).map_err(LqrError::Sampling)?,
    };
    let (n, m, count) = (a.nrows(), b.ncols(), readings.len());
    let mut whole_a = DMatrix::zeros(n + count, n + count);
    let mut whole_b = DMatrix::zeros(n + count, m);
    whole_a.view_mut((0, 0), (n, n)).copy_from(&plant_a);
    whole_b.view_mut((0, 0), (n, m)).copy_from(&plant_b);
    for (k, row) in readings.iter().enumerate() {
        let scale = sampling.period().unwrap_or(1.0);
        whole_a.view_mut((n + k, 0), (1, n)).copy_from(&(row * scale));
        if sampling.period().is_some() {
            whole_a[(n + k, n + k)] = 1.0;
        }
    }
    Ok((whole_a, whole_b))
}

fn tracking_time(poles: &[Complex<f64>], sampling: Sampling) -> f64 {
    let speed = |z: &Complex<f64>| match sampling.period() {
        None => z.norm(),
        Some(period) => z.norm().max(1e-6).ln().abs().max(f64::MIN_POSITIVE) / period,
    };
    let (slow, fast) = poles.iter().map(speed).fold((f64::INFINITY, 0.0_f64), |(lo, hi), s| (lo.min(s), hi.max(s)));
    1.0 / (slow * fast).sqrt().max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    fn names(list: &[&str]) -> Vec<String> {
        list.iter().map(|&s| s.to_owned()).collect()
    }

    /// Two double integrators; the second one is pushed by the first.
    fn plant() -> Plant {
        Plant {
            states: names(&["x", "x.dot", "y", "y.dot"]),
            inputs: names(&["F"]),
            outputs: names(&["x", "y"]),
            a: dmatrix![0.0, 1.0, 0.0, 0.0; 0.0, 0.0, 0.3, 0.0; 0.0, 0.0, 0.0, 1.0; 2.0, 0.0, 0.0, 0.0],
            b: dmatrix![0.0; 1.0; 0.0; 0.0],
            c: dmatrix![1.0, 0.0, 0.0, 0.0; 0.0, 0.0, 1.0, 0.0],
        }
    }

    fn design(states: &[&str], integrate: &[&str], weights: &[f64], sampling: Sampling) -> LqrDesign {
        LqrDesign {
            states: names(states),
            integrate: names(integrate),
            weight_x: Weight::Diagonal(weights.to_vec()),
            weight_u: Weight::Diagonal(vec![1.0]),
            sampling,
        }
    }

    #[test]
    fn a_part_is_designed_alone_and_says_what_it_neglects() {
        let s = lqr(&plant(), &design(&["x", "x.dot"], &[], &[1.0, 2.0], Sampling::Continuous)).unwrap();
        assert!((s.k - dmatrix![1.0, 2.0]).norm() < 1e-13);
        assert_eq!(s.neglected, [Coupling { onto: "x.dot".to_owned(), from: "y".to_owned(), value: 0.3 }]);
        assert_eq!((s.poles.len(), s.plant_poles.len()), (2, 4));
    }

    #[test]
    fn integral_action_moves_the_pole_at_zero() {
        let s = lqr(&plant(), &design(&["x", "x.dot"], &["x"], &[1.0, 2.0, 0.5], Sampling::Continuous)).unwrap();
        assert_eq!(s.states[2], "x.integral");
        assert!(Time::Continuous.stable(&s.poles));
        // while the force is held by its limits, z goes to where the asked force is the applied one
        let rate = (&s.anti_windup * s.k.columns(2, 1))[(0, 0)];
        assert!((rate + 1.0 / s.tracking_time).abs() < 1e-12);
    }

    #[test]
    fn sampled_gains_tend_to_the_continuous_one() {
        let weights = [1.0, 2.0, 0.5];
        let wanted = lqr(&plant(), &design(&["x", "x.dot"], &["x"], &weights, Sampling::Continuous)).unwrap().k;
        let error = |period: f64| {
            let fine = lqr(&plant(), &design(&["x", "x.dot"], &["x"], &weights, Sampling::Integral { period })).unwrap();
            (fine.k - &wanted).norm() / wanted.norm()
        };
        let (long, short) = (error(1e-2), error(1e-3));
        assert!(short < 2e-3 && (long / short - 10.0).abs() < 1.0, "{long} {short}");
    }

    #[test]
    fn mistakes_are_told_in_the_users_words() {
        let say = |d: LqrDesign| lqr(&plant(), &d).unwrap_err().to_string();
        assert_eq!(
            say(design(&["x", "z"], &[], &[1.0, 1.0], Sampling::Continuous)),
            "there is no state `z`; the states are x, x.dot, y, y.dot"
        );
        assert_eq!(say(design(&["x", "x"], &[], &[1.0, 1.0], Sampling::Continuous)), "the state `x` is named twice");
        assert_eq!(
            say(design(&["x", "x.dot"], &["y"], &[1.0; 3], Sampling::Continuous)),
            "there is no output `y`; the outputs are x, x.dot"
        );
        assert_eq!(
            say(design(&["x", "x.dot"], &["x"], &[1.0; 2], Sampling::Continuous)),
            "2 weights for 3 states: one is needed for each of x, x.dot, x.integral"
        );
        assert_eq!(
            say(design(&["x"], &[], &[1.0], Sampling::Continuous)),
            "no input reaches the mode at 0 (x), which does not decay by itself: no gain can stabilize it; leave its states out of the design or choose another operating point"
        );
        assert_eq!(
            say(design(&[], &[], &[1.0; 4], Sampling::Sum { period: -1.0 })),
            "the sampling period must be a positive number of seconds, it is -1"
        );
    }
}
