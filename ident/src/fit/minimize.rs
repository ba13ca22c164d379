//! Minimization of a sum of squares with bounds, from its value, gradient and Gauss-Newton matrix.
//!
//! [`Minimizer`] is the door; behind it a Levenberg-Marquardt search with Moré's scaling (J. J. Moré, "The
//! Levenberg-Marquardt algorithm: implementation and theory", 1978), Nielsen's rule for the damping (H. B. Nielsen,
//! "Damping parameter in Marquardt's method", 1999) and bounds by an active set. The objective hands over J^T J and not J: a
//! record has 10^4 to 10^5 rows and a dozen columns, and the products are summed while it is integrated.

use nalgebra::{Cholesky, DMatrix, DVector};
use std::fmt;

/// Value, gradient and Gauss-Newton matrix of an objective.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// Value.
    pub cost: f64,
    /// Gradient.
    pub gradient: DVector<f64>,
    /// J^T J, positive semidefinite.
    pub normal: DMatrix<f64>,
}

/// What is minimized.
pub trait Objective {
    /// Unknowns.
    fn unknowns(&self) -> usize;
    /// Lower and upper bound of unknown i.
    fn bounds(&self, i: usize) -> (f64, f64);
    /// A size by which unknown i may change, used where the objective does not depend on it.
    fn size(&self, i: usize) -> f64;
    /// The objective; `None` where it cannot be evaluated (the run died), which counts as worse than anything.
    fn evaluate(&mut self, x: &[f64]) -> Option<Evaluation>;
}

/// When a search ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Evaluations.
    pub evaluations: usize,
    /// Largest cosine between the errors and a column of J.
    pub gradient: f64,
    /// Relative change of the scaled unknowns.
    pub step: f64,
    /// Relative decrease of the cost, foreseen and found; the step that foresees less is taken and is the last. With 10^4 errors, 1e-10 is
    /// 1e-3 of a standard error.
    pub cost: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { evaluations: 200, gradient: 1e-10, step: 1e-10, cost: 1e-10 }
    }
}

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The errors are orthogonal to every column of J that is not held by a bound.
    Gradient,
    /// Steps no longer change the unknowns.
    Step,
    /// Steps no longer lower the cost.
    Cost,
    /// The errors vanish.
    Exact,
    /// The allowed evaluations were used up; the best point found is given.
    TooManyEvaluations,
    /// No step lowers the cost although the gradient is not zero: the objective is not smooth here, or not accurate enough.
    NoProgress,
    /// The objective cannot be evaluated at the start.
    NoStart,
}

impl Ending {
    /// The word for tables and JSON.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Gradient => "converged_gradient",
            Self::Step => "converged_step",
            Self::Cost => "converged_cost",
            Self::Exact => "exact",
            Self::TooManyEvaluations => "too_many_evaluations",
            Self::NoProgress => "no_progress",
            Self::NoStart => "no_start",
        }
    }

    /// A minimum was reached.
    #[must_use]
    pub fn converged(self) -> bool {
        matches!(self, Self::Gradient | Self::Step | Self::Cost | Self::Exact)
    }
}

impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Gradient => "converged: the gradient vanishes",
            Self::Step => "converged: steps no longer change the unknowns",
            Self::Cost => "converged: steps no longer lower the cost",
            Self::Exact => "converged: the errors vanish",
            Self::TooManyEvaluations => "not converged: the allowed evaluations were used up",
            Self::NoProgress => "not converged: no step lowers the cost although the gradient is not zero",
            Self::NoStart => "the model cannot be run from the starting values",
        })
    }
}

/// What a search found.
#[derive(Clone, Debug)]
pub struct Minimum {
    /// The best point.
    pub x: Vec<f64>,
    /// The objective there; `None` only for [`Ending::NoStart`].
    pub at: Option<Evaluation>,
    /// How the search ended.
    pub ending: Ending,
    /// Evaluations.
    pub evaluations: usize,
}

impl Minimum {
    /// Cost; infinite where the search could not begin.
    #[must_use]
    pub fn cost(&self) -> f64 {
        self.at.as_ref().map_or(f64::INFINITY, |at| at.cost)
    }
}

/// A method of minimization.
pub trait Minimizer {
    /// Searches from `start`, which is moved into the bounds first.
    fn minimize(&self, objective: &mut dyn Objective, start: &[f64], limits: &Limits) -> Minimum;
}

/// Levenberg-Marquardt with bounds.
#[derive(Clone, Copy, Debug, Default)]
pub struct LevenbergMarquardt;

impl Minimizer for LevenbergMarquardt {
    fn minimize(&self, objective: &mut dyn Objective, start: &[f64], limits: &Limits) -> Minimum {
        let n = objective.unknowns();
        let bounds: Vec<(f64, f64)> = (0..n).map(|i| objective.bounds(i)).collect();
        let mut x: Vec<f64> = start.iter().zip(&bounds).map(|(x, (lo, hi))| x.max(*lo).min(*hi)).collect();
        let mut evaluations = 1;
        let Some(mut at) = objective.evaluate(&x) else {
            return Minimum { x, at: None, ending: Ending::NoStart, evaluations };
        };
        // column norms, the largest seen; a column that vanishes everywhere is scaled by the unknown's size
        let mut scale = vec![0.0_f64; n];
        let mut damping = 1e-3;
        let mut growth = 2.0;
        let ending = loop {
            for (i, scale) in scale.iter_mut().enumerate() {
                let floor = 1e-8 * (2.0 * at.cost).sqrt() / objective.size(i).abs().max(f64::MIN_POSITIVE);
                *scale = scale.max(at.normal[(i, i)].max(0.0).sqrt()).max(floor).max(f64::MIN_POSITIVE);
            }
            if at.cost == 0.0 {
                break Ending::Exact;
            }
            let held: Vec<bool> = (0..n).map(|i| holds(x[i], at.gradient[i], bounds[i])).collect();
            let errors = (2.0 * at.cost).sqrt();
            let steepest = (0..n).filter(|&i| !held[i]).fold(0.0_f64, |m, i| m.max((at.gradient[i] / (scale[i] * errors)).abs()));
            if steepest <= limits.gradient {
                break Ending::Gradient;
            }
            // damp until a step lowers the cost
            let accepted = loop {
                if evaluations >= limits.evaluations {
                    break Err(Ending::TooManyEvaluations);
                }
                let Some(step) = step(&at, &scale, damping, &x, &bounds, &held) else {
                    damping = (damping * growth).max(1e-12);
                    growth *= 2.0;
                    if damping > 1e20 {
                        break Err(Ending::NoProgress);
                    }
                    continue;
                };
                let foreseen = -(at.gradient.dot(&step) + 0.5 * step.dot(&(&at.normal * &step)));
                let scaled = |v: &dyn Fn(usize) -> f64| (0..n).map(|i| (scale[i] * v(i)).powi(2)).sum::<f64>().sqrt();
                let (length, size) = (scaled(&|i| step[i]), scaled(&|i| x[i]));
                let trial: Vec<f64> = (0..n).map(|i| (x[i] + step[i]).max(bounds[i].0).min(bounds[i].1)).collect();
                // so little is left to gain, so near, that the quadratic model gives it as well, and no damping hides more
                // (a direction that rounding alone tells from none foresees as little, and goes far)
                let near = damping <= 1e-3 && (0..n).all(|i| step[i].abs() <= 1e-3 * x[i].abs().max(objective.size(i).abs()));
                if near && foreseen >= 0.0 && foreseen <= limits.cost * at.cost {
                    x = trial;
                    at.cost -= foreseen;
                    at.gradient += &at.normal * &step;
                    break Err(Ending::Cost);
                }
                evaluations += 1;
                let found = objective.evaluate(&trial).filter(|e| e.cost.is_finite());
                let gain = found.as_ref().map_or(f64::NEG_INFINITY, |e| at.cost - e.cost);
                let small_cost = foreseen.abs() <= limits.cost * at.cost && gain.abs() <= limits.cost * at.cost;
                let small_step = length <= limits.step * size.max(f64::MIN_POSITIVE);
                if let Some(better) = found.filter(|_| gain > 1e-4 * foreseen && foreseen > 0.0) {
                    let ratio = gain / foreseen;
                    damping *= (1.0 - (2.0 * ratio - 1.0).powi(3)).max(1.0 / 5.0);
                    // a good step twice over: all but undamped, so that the end is quadratic
                    if ratio > 0.9 {
                        damping *= 0.2;
                    }
                    growth = 2.0;
                    x = trial;
                    at = better;
                    break Ok((small_cost, small_step));
                }
                if small_cost {
                    break Err(Ending::Cost);
                }
                if small_step {
                    break Err(Ending::Step);
                }
                damping = (damping * growth).max(1e-8);
                growth *= 2.0;
                if damping > 1e20 {
                    break Err(Ending::NoProgress);
                }
            };
            match accepted {
                Err(ending) => break ending,
                Ok((true, _)) => break Ending::Cost,
                Ok((_, true)) => break Ending::Step,
                Ok(_) => {}
            }
        };
        Minimum { x, at: Some(at), ending, evaluations }
    }
}

/// The unknown stands at a bound and the gradient presses it against it.
fn holds(x: f64, gradient: f64, (lo, hi): (f64, f64)) -> bool {
    x <= lo && gradient > 0.0 || x >= hi && gradient < 0.0
}

/// The damped step; unknowns that would leave their bounds go to them, and the others are solved again.
fn step(at: &Evaluation, scale: &[f64], damping: f64, x: &[f64], bounds: &[(f64, f64)], held: &[bool]) -> Option<DVector<f64>> {
    let n = x.len();
    let mut step = DVector::zeros(n);
    let mut open: Vec<usize> = (0..n).filter(|&i| !held[i]).collect();
    while !open.is_empty() {
        // in scaled unknowns, so that the factorization meets a matrix with a diagonal near one
        let m = DMatrix::from_fn(open.len(), open.len(), |r, c| {
            let (i, j) = (open[r], open[c]);
            at.normal[(i, j)] / (scale[i] * scale[j]) + if r == c { damping } else { 0.0 }
        });
        let given = &at.normal * &step;
        let right = DVector::from_fn(open.len(), |r, _| -(at.gradient[open[r]] + given[open[r]]) / scale[open[r]]);
        let solved = Cholesky::new(m)?.solve(&right);
        if solved.iter().any(|s| !s.is_finite()) {
            return None;
        }
        let mut left = Vec::new();
        for (r, &i) in open.iter().enumerate() {
            step[i] = solved[r] / scale[i];
            let (lo, hi) = bounds[i];
            if x[i] + step[i] < lo || x[i] + step[i] > hi {
                left.push(i);
            }
        }
        if left.is_empty() {
            break;
        }
        for &i in &left {
            step[i] = (x[i] + step[i]).max(bounds[i].0).min(bounds[i].1) - x[i];
        }
        open.retain(|i| !left.contains(i));
        open.iter().for_each(|&i| step[i] = 0.0);
    }
    Some(step)
}

#[cfg(test)]
mod tests {
    use super::{Ending, Evaluation, LevenbergMarquardt, Limits, Minimizer, Objective};
    use nalgebra::{DMatrix, DVector};

    /// Residuals and their Jacobian.
    struct Residuals<F> {
        of: F,
        bounds: Vec<(f64, f64)>,
    }

    impl<F: Fn(&[f64]) -> Option<(Vec<f64>, Vec<Vec<f64>>)>> Objective for Residuals<F> {
        fn unknowns(&self) -> usize {
            self.bounds.len()
        }
        fn bounds(&self, i: usize) -> (f64, f64) {
            self.bounds[i]
        }
        fn size(&self, _: usize) -> f64 {
            1.0
        }
        fn evaluate(&mut self, x: &[f64]) -> Option<Evaluation> {
            let (r, j) = (self.of)(x)?;
            let r = DVector::from_vec(r);
            let j = DMatrix::from_fn(j.len(), x.len(), |a, b| j[a][b]);
            Some(Evaluation { cost: 0.5 * r.norm_squared(), gradient: j.transpose() * &r, normal: j.transpose() * j })
        }
    }

    const OPEN: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

    #[allow(clippy::unnecessary_wraps)]
    fn rosenbrock(x: &[f64]) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
        Some((vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]], vec![vec![-20.0 * x[0], 10.0], vec![-1.0, 0.0]]))
    }

    #[test]
    fn a_curved_valley() {
        let mut problem = Residuals { of: rosenbrock, bounds: vec![OPEN; 2] };
        let m = LevenbergMarquardt.minimize(&mut problem, &[-1.2, 1.0], &Limits::default());
        assert!(m.ending.converged() && (m.x[0] - 1.0).abs() < 1e-7 && (m.x[1] - 1.0).abs() < 1e-7, "{m:?}");
        assert!(m.evaluations < 40, "{}", m.evaluations);
    }

    #[test]
    fn bounds_hold_and_the_rest_is_optimal() {
        let mut problem = Residuals { of: rosenbrock, bounds: vec![(-2.0, 0.5), OPEN] };
        let m = LevenbergMarquardt.minimize(&mut problem, &[-1.2, 1.0], &Limits::default());
        assert!(m.ending.converged() && m.x[0] == 0.5 && (m.x[1] - 0.25).abs() < 1e-7, "{m:?}");
    }

    #[test]
    fn an_unknown_without_effect_stays() {
        let of = |x: &[f64]| Some((vec![x[0] - 3.0, 1.0], vec![vec![1.0, 0.0], vec![0.0, 0.0]]));
        let m = LevenbergMarquardt.minimize(&mut Residuals { of, bounds: vec![OPEN; 2] }, &[0.0, 7.0], &Limits::default());
        assert!(m.ending.converged() && (m.x[0] - 3.0).abs() < 1e-9 && m.x[1] == 7.0, "{m:?}");
    }

    #[test]
    fn where_the_run_dies_the_step_is_shortened() {
        let of = |x: &[f64]| (x[0] < 2.0).then(|| (vec![10.0 * (x[0].powi(3) - 1.0)], vec![vec![30.0 * x[0] * x[0]]]));
        let m = LevenbergMarquardt.minimize(&mut Residuals { of, bounds: vec![OPEN] }, &[0.05], &Limits::default());
        assert!(m.ending.converged() && (m.x[0] - 1.0).abs() < 1e-9, "{m:?}");
        let m = LevenbergMarquardt.minimize(&mut Residuals { of, bounds: vec![OPEN] }, &[3.0], &Limits::default());
        assert_eq!(m.ending, Ending::NoStart);
    }
}
