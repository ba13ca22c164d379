//! Algebraic Riccati equations, continuous (CARE) and discrete (DARE), with checked solutions.
//!
//! CARE: A^T X + X A - (X B + N) R^-1 (B^T X + N^T) + Q = 0.
//! DARE: A^T X A - X - (A^T X B + N) (R + B^T X B)^-1 (B^T X A + N^T) + Q = 0.
//!
//! Structured doubling (Chu, Fan, Lin 2005; CARE after a Cayley transform whose shift comes from the Hamiltonian
//! matrix), in balanced states and with X scaled to one, then Newton steps (Kleinman 1968; Hewer 1971). What comes out
//! is checked: symmetric, stable closed loop, X >= 0 where the weights are, relative residual. Knows matrices only.

use crate::balance::{riccati_scaling, scaled};
use crate::lyapunov::{lyapunov, stein};
use crate::modes::{Time, show, who};
use crate::reach::{Mode, Staircase, pbh, rounding};
use crate::schur::eigenvalues;
use nalgebra::{Cholesky, Complex, DMatrix, Dyn, SymmetricEigen};
use std::fmt;

/// Residuals above this are an error.
const RESIDUAL: f64 = 1e-9;
/// A solution as good as this needs no other start.
const GOOD: f64 = 1e-12;
/// A mode out of reach, or unseen and this near to the limit of stability relative to A, cannot be told from a marginal one.
const MARGINAL: f64 = 1e-10;
const DOUBLINGS: usize = 70;
const NEWTON_STEPS: usize = 12;

/// A checked solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Riccati {
    /// X (n x n), symmetric.
    pub x: DMatrix<f64>,
    /// K (m x n) of u = -K x.
    pub gain: DMatrix<f64>,
    /// Eigenvalues of A - B K, all stable.
    pub poles: Vec<Complex<f64>>,
    /// Norm of the equation's left-hand side over the sum of its terms' norms (Frobenius).
    pub residual: f64,
    /// Estimate of the relative error of X, to first order: what a change of the data by the residual (or by rounding,
    /// if that is more) does to X in balanced states.
    pub error: f64,
}

/// Why there is no solution.
#[derive(Clone, Debug, PartialEq)]
pub enum RiccatiError {
    /// A matrix has the wrong shape.
    Shape {
        /// `A`, `B`, `Q`, `R`, `N`.
        matrix: &'static str,
        /// Rows, columns.
        found: (usize, usize),
        /// Rows, columns.
        wanted: (usize, usize),
    },
    /// A matrix holds a value that is not finite.
    NotFinite {
        /// Which.
        matrix: &'static str,
    },
    /// A weight is not symmetric.
    NotSymmetric {
        /// Which.
        matrix: &'static str,
        /// Row and column (from 0) of the entry that differs most from its mirror.
        entry: (usize, usize),
    },
    /// R is not positive definite.
    InputWeight {
        /// Its smallest eigenvalue.
        eigenvalue: f64,
    },
    /// A mode that does not decay cannot be reached by any input: no gain stabilizes it.
    Unreachable(Mode),
    /// A mode on the limit of stability is not seen by the weight: the optimal gain leaves it alone.
    Unseen(Mode),
    /// No stabilizing solution was found.
    NoSolution {
        /// The mode that the inputs reach least among those that do not decay, or that the weight sees least.
        weakest: Mode,
    },
    /// A solution was found but it does not pass its checks: the problem is too badly conditioned for double precision.
    Inaccurate {
        /// Relative residual.
        residual: f64,
        /// Estimated relative error of X.
        error: f64,
        /// Smallest eigenvalue of X over the largest one.
        definiteness: f64,
        /// The mode that is hardest to reach or to see.
        weakest: Mode,
    },
}

impl RiccatiError {
    /// The message with names of states (for Kalman filters and observers the message speaks of the dual problem).
    #[must_use]
    pub fn with_names(&self, names: &[String]) -> String {
        let mode = |m: &Mode| format!("at {} ({})", show(m.eigenvalue), who(&m.combination, names));
        match self {
            Self::Shape { matrix, found, wanted } => {
                format!("{matrix} is {} x {}, {} x {} is needed", found.0, found.1, wanted.0, wanted.1)
            }
            Self::NotFinite { matrix } => format!("{matrix} holds a value that is not a finite number"),
            Self::NotSymmetric { matrix, entry: (i, j) } => {
                format!("{matrix} is not symmetric: its entries ({}, {}) and ({}, {}) differ", i + 1, j + 1, j + 1, i + 1)
            }
            Self::InputWeight { eigenvalue } => {
                format!(
                    "the weight of the inputs must be positive definite, its smallest eigenvalue is {eigenvalue:.3e}; every input must cost something"
                )
            }
            Self::Unreachable(m) => format!(
                "no input reaches the mode {}, which does not decay by itself: no gain can stabilize it; leave its states out of the design or choose another operating point",
                mode(m)
            ),
            Self::Unseen(m) => format!(
                "the weight does not see the mode {}, which does not decay by itself: give one of its states a weight, or leave it out of the design",
                mode(m)
            ),
            Self::NoSolution { weakest } => {
                format!(
                    "no stabilizing solution was found; nearest to being out of reach or unseen is the mode {}, relative distance {:.1e}",
                    mode(weakest),
                    weakest.distance
                )
            }
            Self::Inaccurate { residual, error, definiteness, weakest } => format!(
                "the solution is not accurate: relative residual {residual:.1e}, estimated relative error {error:.1e}, smallest over largest eigenvalue of X {definiteness:.1e}; hardest to reach or to see is the mode {}, relative distance {:.1e}",
                mode(weakest),
                weakest.distance
            ),
        }
    }
}

impl fmt::Display for RiccatiError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.with_names(&[]))
    }
}

impl std::error::Error for RiccatiError {}

/// The data of an equation: A (n x n), B (n x m), Q (n x n, symmetric), R (m x m, positive definite), and the cross
/// weight N (n x m) of the cost x^T Q x + 2 x^T N u + u^T R u.
#[derive(Clone, Copy, Debug)]
pub struct RiccatiData<'a> {
    /// A.
    pub a: &'a DMatrix<f64>,
    /// B.
    pub b: &'a DMatrix<f64>,
    /// Q.
    pub q: &'a DMatrix<f64>,
    /// R.
    pub r: &'a DMatrix<f64>,
    /// N, zero where there is none.
    pub cross: Option<&'a DMatrix<f64>>,
}

/// Stabilizing solution of the continuous equation.
///
/// # Errors
/// [`RiccatiError`], one variant a cause.
pub fn care(data: RiccatiData<'_>) -> Result<Riccati, RiccatiError> {
    solve(data, Time::Continuous)
}

/// Stabilizing solution of the discrete equation.
///
/// # Errors
/// [`RiccatiError`], one variant a cause.
pub fn dare(data: RiccatiData<'_>) -> Result<Riccati, RiccatiError> {
    solve(data, Time::Discrete)
}

/// Stabilizing solution of either equation.
///
/// # Errors
/// [`RiccatiError`], one variant a cause.
pub fn solve(data: RiccatiData<'_>, time: Time) -> Result<Riccati, RiccatiError> {
    check_data(&data)?;
    let core = Core::new(&data, time)?;
    core.check_modes()?;
    // everything is found in balanced states and with X of the size of one; the checks are made in the user's
    let (even, back) = core.balanced();
    let mut best: Option<Candidate> = None;
    for start in even.starts() {
        let Some((x, condition)) = even.refine(start) else { continue };
        let x = back.apply(&x);
        let found = core.candidate(x.clone(), condition);
        let again = if found.as_ref().is_some_and(|c| c.residual <= GOOD) {
            None
        } else {
            core.refine(x).and_then(|(x, _)| core.candidate(x, condition))
        };
        for candidate in [found, again].into_iter().flatten() {
            if best.as_ref().is_none_or(|b| candidate.residual < b.residual) {
                best = Some(candidate);
            }
        }
        if best.as_ref().is_some_and(|b| b.residual <= GOOD) {
            break;
        }
    }
    let best = best.ok_or_else(|| RiccatiError::NoSolution { weakest: even.weakest() })?;
    let eigen = SymmetricEigen::new(best.x.clone()).eigenvalues;
    let definiteness = if eigen.amax() > 0.0 { eigen.min() / eigen.amax() } else { 0.0 };
    let indefinite = core.weight_is_semidefinite() && definiteness < -1e-9;
    // a value that is not a number is not sound
    let sound = best.residual <= RESIDUAL && best.error <= 1.0 && !indefinite;
    if !sound {
        return Err(RiccatiError::Inaccurate { residual: best.residual, error: best.error, definiteness, weakest: even.weakest() });
    }
    let gain = best.gain + &core.feed;
    Ok(Riccati { poles: best.poles, residual: best.residual, error: best.error, x: best.x, gain })
}

fn check_data(data: &RiccatiData<'_>) -> Result<(), RiccatiError> {
    let (n, m) = (data.a.nrows(), data.b.ncols());
    let shapes = [("A", data.a, (n, n)), ("B", data.b, (n, m)), ("Q", data.q, (n, n)), ("R", data.r, (m, m))];
    for (matrix, value, wanted) in shapes.into_iter().chain(data.cross.map(|s| ("N", s, (n, m)))) {
        if value.shape() != wanted {
            return Err(RiccatiError::Shape { matrix, found: value.shape(), wanted });
        }
        if value.iter().any(|x| !x.is_finite()) {
            return Err(RiccatiError::NotFinite { matrix });
        }
    }
    for (matrix, value) in [("Q", data.q), ("R", data.r)] {
        if let Some(entry) = asymmetry(value) {
            return Err(RiccatiError::NotSymmetric { matrix, entry });
        }
    }
    Ok(())
}

/// The entry that differs most from its mirror, where the difference is more than rounding.
pub(crate) fn asymmetry(m: &DMatrix<f64>) -> Option<(usize, usize)> {
    let difference = m - m.transpose();
    (difference.amax() > 1e-10 * m.amax()).then(|| {
        let (i, j) = difference.iamax_full();
        (i.min(j), i.max(j))
    })
}

fn symmetric(m: &DMatrix<f64>) -> DMatrix<f64> {
    (m + m.transpose()) * 0.5
}

fn inverse_of(m: DMatrix<f64>) -> Option<DMatrix<f64>> {
    m.try_inverse().filter(|x| x.iter().all(|v| v.is_finite()))
}

/// The equation without cross term: A <- A - B R^-1 N^T, Q <- Q - N R^-1 N^T.
struct Core {
    time: Time,
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    q: DMatrix<f64>,
    r: DMatrix<f64>,
    /// G = B R^-1 B^T.
    g: DMatrix<f64>,
    r_factor: Cholesky<f64, Dyn>,
    /// R^-1 N^T, to be added to the gain.
    feed: DMatrix<f64>,
}

struct Candidate {
    x: DMatrix<f64>,
    gain: DMatrix<f64>,
    poles: Vec<Complex<f64>>,
    residual: f64,
    error: f64,
}

/// From X of the balanced equation to X: s D^-1 X D^-1, all powers of two.
struct Back {
    d: Vec<f64>,
    s: f64,
}

impl Back {
    fn apply(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(x.nrows(), x.ncols(), |i, j| x[(i, j)] / self.d[i] / self.d[j] * self.s)
    }
}

/// What the equation says of an X.
struct Residual {
    value: DMatrix<f64>,
    relative: f64,
    /// Sum of the norms of the terms.
    terms: f64,
    gain: DMatrix<f64>,
    closed: DMatrix<f64>,
}

impl Core {
    fn new(data: &RiccatiData<'_>, time: Time) -> Result<Self, RiccatiError> {
        let r = symmetric(data.r);
        let smallest = || r.clone().symmetric_eigenvalues().iter().copied().fold(f64::INFINITY, f64::min);
        let r_factor = Cholesky::new(r.clone()).ok_or_else(|| RiccatiError::InputWeight { eigenvalue: smallest() })?;
        let zero = DMatrix::zeros(data.a.nrows(), data.b.ncols());
        let cross = data.cross.unwrap_or(&zero);
        let feed = r_factor.solve(&cross.transpose());
        let g = symmetric(&(data.b * r_factor.solve(&data.b.transpose())));
        let (a, q) = (data.a - data.b * &feed, symmetric(&(data.q - cross * &feed)));
        let core = Self { time, a, b: data.b.clone(), q, r, g, r_factor, feed };
        if [&core.a, &core.g, &core.q].iter().any(|m| m.iter().any(|x| !x.is_finite())) {
            return Err(RiccatiError::NotFinite { matrix: "R^-1" });
        }
        Ok(core)
    }

    /// Refuses what no gain can mend, before any iteration.
    fn check_modes(&self) -> Result<(), RiccatiError> {
        let n = self.a.nrows();
        let not_finite = |_| RiccatiError::NotFinite { matrix: "A" };
        let size = self.a.norm();
        // zero but for rounding
        let clean = |z: Complex<f64>| {
            let part = |x: f64| if x.abs() <= rounding(n) * size { 0.0 } else { x };
            Complex::new(part(z.re), part(z.im))
        };
        let margin = MARGINAL * size.max(if self.time == Time::Discrete { 1.0 } else { 0.0 });
        let unreached = Staircase::new(&self.a, &self.b, rounding(n)).map_err(not_finite)?;
        for z in eigenvalues(&unreached.rest).map_err(not_finite)? {
            if self.time.growth(z) >= -margin {
                return Err(RiccatiError::Unreachable(pbh(&self.a, &self.b, clean(z))));
            }
        }
        let (at, weight) = (self.a.transpose(), &self.q);
        let weight = if weight.norm() > 0.0 { weight * (size.max(1e-300) / weight.norm()) } else { weight.clone() };
        let unseen = Staircase::new(&at, &weight, rounding(n)).map_err(not_finite)?;
        for z in eigenvalues(&unseen.rest).map_err(not_finite)? {
            if self.time.growth(z).abs() <= margin {
                return Err(RiccatiError::Unseen(pbh(&at, &weight, clean(z))));
            }
        }
        Ok(())
    }

    /// The mode that is nearest to being unreachable (if it does not decay) or unseen (if on the limit of stability).
    fn weakest(&self) -> Mode {
        let at = self.a.transpose();
        let weight = if self.q.norm() > 0.0 { &self.q * (self.a.norm() / self.q.norm()) } else { self.q.clone() };
        let modes = eigenvalues(&self.a).unwrap_or_default();
        let reach = modes.iter().filter(|&&z| self.time.growth(z) >= -1e-6).map(|&z| pbh(&self.a, &self.b, z));
        let see = modes.iter().map(|&z| pbh(&at, &weight, self.time.onto_limit(z)));
        reach.chain(see).min_by(|p, q| p.distance.total_cmp(&q.distance)).unwrap_or(Mode {
            eigenvalue: Complex::new(0.0, 0.0),
            distance: 0.0,
            combination: vec![0.0; self.a.nrows()],
        })
    }

    fn weight_is_semidefinite(&self) -> bool {
        let eigen = self.q.clone().symmetric_eigenvalues();
        eigen.iter().all(|&v| v >= -1e-12 * eigen.amax())
    }

    /// The same equation in balanced states x = D x', with Q and G equally large.
    fn balanced(&self) -> (Self, Back) {
        let n = self.a.nrows();
        // a power of four, so that B takes its root exactly
        let ratio = |g: &DMatrix<f64>, q: &DMatrix<f64>| {
            let s = (0.25 * (q.norm() / g.norm()).log2()).round().exp2().powi(2);
            if s.is_finite() && s > 0.0 { s } else { 1.0 }
        };
        let first = ratio(&self.g, &self.q);
        let d = riccati_scaling(&self.a, &(&self.g * first), &(&self.q / first));
        let a = scaled(&self.a, &d);
        let g = DMatrix::from_fn(n, n, |i, j| self.g[(i, j)] / d[i] / d[j]);
        let q = DMatrix::from_fn(n, n, |i, j| self.q[(i, j)] * d[i] * d[j]);
        let s = ratio(&g, &q);
        let b = DMatrix::from_fn(n, self.b.ncols(), |i, j| self.b[(i, j)] / d[i] * s.sqrt());
        let even =
            Self { time: self.time, a, b, q: q / s, r: self.r.clone(), g: g * s, r_factor: self.r_factor.clone(), feed: self.feed.clone() };
        (even, Back { d, s })
    }

    /// Solutions by doubling, for several shifts.
    fn starts(&self) -> impl Iterator<Item = DMatrix<f64>> + '_ {
        let shifts: Vec<f64> = match self.time {
            Time::Discrete => vec![0.0],
            Time::Continuous => shifts(&self.a, &self.g, &self.q),
        };
        shifts.into_iter().filter_map(|shift| {
            double(match self.time {
                Time::Discrete => (self.a.clone(), self.g.clone(), self.q.clone()),
                Time::Continuous => cayley(&self.a, &self.g, &self.q, shift)?,
            })
        })
    }

    fn residual(&self, x: &DMatrix<f64>) -> Option<Residual> {
        let xb = x * &self.b;
        let (gain, terms) = match self.time {
            Time::Continuous => {
                let gain = self.r_factor.solve(&xb.transpose());
                let xa = x * &self.a;
                (gain, [xa.transpose(), xa])
            }
            Time::Discrete => {
                let inner = Cholesky::new(symmetric(&(&self.r + self.b.transpose() * &xb)))?;
                let gain = inner.solve(&(xb.transpose() * &self.a));
                (gain, [self.a.transpose() * x * &self.a, -x.clone()])
            }
        };
        let quadratic = match self.time {
            Time::Continuous => &xb * &gain,
            Time::Discrete => self.a.transpose() * &xb * &gain,
        };
        let value = symmetric(&(&terms[0] + &terms[1] - &quadratic + &self.q));
        let sum = terms[0].norm() + terms[1].norm() + quadratic.norm() + self.q.norm();
        let relative = if sum > 0.0 { value.norm() / sum } else { 0.0 };
        let closed = &self.a - &self.b * &gain;
        relative.is_finite().then_some(Residual { value, relative, terms: sum, gain, closed })
    }

    /// Newton steps while they help, and how far X moves with the equation: the norm of the inverse of the closed
    /// loop's Lyapunov operator, times the size of the equation's terms, over that of X.
    fn refine(&self, x: DMatrix<f64>) -> Option<(DMatrix<f64>, f64)> {
        let mut x = symmetric(&x);
        let mut now = self.residual(&x)?;
        for _ in 0..NEWTON_STEPS {
            let Ok(step) = self.linear_equation(&now.closed, &now.value) else { break };
            let next_x = symmetric(&(&x + step));
            let Some(next) = self.residual(&next_x) else { break };
            if next.relative >= now.relative {
                break;
            }
            (x, now) = (next_x, next);
        }
        let n = x.nrows();
        // the operator is positive: its inverse is largest at I
        let inverse = self.linear_equation(&now.closed, &DMatrix::identity(n, n)).map_or(f64::INFINITY, |w| w.norm() / (n as f64).sqrt());
        let condition = if x.norm() > 0.0 { inverse * now.terms / x.norm() } else { 0.0 };
        Some((x, condition))
    }

    fn linear_equation(&self, closed: &DMatrix<f64>, value: &DMatrix<f64>) -> Result<DMatrix<f64>, crate::LyapunovError> {
        match self.time {
            Time::Continuous => lyapunov(&closed.transpose(), value),
            Time::Discrete => stein(&closed.transpose(), value),
        }
    }

    /// What an X is worth; `None` where its closed loop is not stable.
    fn candidate(&self, x: DMatrix<f64>, condition: f64) -> Option<Candidate> {
        let x = symmetric(&x);
        let now = self.residual(&x)?;
        let poles = eigenvalues(&now.closed).ok()?;
        let error = condition * now.relative.max(f64::EPSILON);
        self.time.stable(&poles).then_some(Candidate { x, gain: now.gain, poles, residual: now.relative, error })
    }
}

/// Shifts of the Cayley transform, best first: about the geometric mean of the Hamiltonian's eigenvalues.
fn shifts(a: &DMatrix<f64>, g: &DMatrix<f64>, q: &DMatrix<f64>) -> Vec<f64> {
    let n = a.nrows();
    let mut h = DMatrix::zeros(2 * n, 2 * n);
    h.view_mut((0, 0), (n, n)).copy_from(a);
    h.view_mut((0, n), (n, n)).copy_from(&-g);
    h.view_mut((n, 0), (n, n)).copy_from(&-q);
    h.view_mut((n, n), (n, n)).copy_from(&-a.transpose());
    let sizes: Vec<f64> = eigenvalues(&h).unwrap_or_default().iter().map(|z| z.norm()).filter(|&s| s > 0.0).collect();
    let (lo, hi) = sizes.iter().fold((f64::INFINITY, 0.0_f64), |(lo, hi), &s| (lo.min(s), hi.max(s)));
    if hi == 0.0 {
        return vec![1.0];
    }
    let middle = (lo.max(1e-12 * hi) * hi).sqrt();
    // A - shift I must be regular: other shifts stand by
    [1.0, 2.3, 0.45, 7.1, 0.13, 31.0].iter().map(|f| f * middle).collect()
}

type Triple = (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>);

/// Structured form (E, G, H) of the Cayley transform of a Hamiltonian matrix (Chu, Fan, Lin 2005, eq. 8-10).
fn cayley(a: &DMatrix<f64>, g: &DMatrix<f64>, q: &DMatrix<f64>, shift: f64) -> Option<Triple> {
    let n = a.nrows();
    let one = DMatrix::<f64>::identity(n, n);
    let inverse = inverse_of(a - &one * shift)?;
    let w = inverse_of((a - &one * shift).transpose() + q * &inverse * g)?;
    let e = one + w.transpose() * (2.0 * shift);
    let g0 = symmetric(&(&inverse * g * &w * (2.0 * shift)));
    let h0 = symmetric(&(&w * q * &inverse * (2.0 * shift)));
    Some((e, g0, h0))
}

/// The doubling iteration: E -> E (I + G H)^-1 E, G -> G + E (I + G H)^-1 G E^T, H -> H + E^T H (I + G H)^-1 E;
/// H tends to X.
fn double((mut e, mut g, mut h): Triple) -> Option<DMatrix<f64>> {
    let n = e.nrows();
    let mut last = f64::INFINITY;
    for _ in 0..DOUBLINGS {
        let lu = (DMatrix::identity(n, n) + &g * &h).lu();
        let we = lu.solve(&e)?;
        let wg = lu.solve(&g)?;
        let step = symmetric(&(e.transpose() * &h * &we));
        let next_g = symmetric(&(&g + &e * wg * e.transpose()));
        h += &step;
        e = &e * we;
        g = next_g;
        if !(h.iter().chain(g.iter()).chain(e.iter()).all(|x| x.is_finite())) {
            return None;
        }
        let change = step.norm();
        if change <= 1e-15 * h.norm() || (change <= 1e-10 * h.norm() && change >= last) {
            return Some(h);
        }
        last = change;
    }
    // slow convergence (poles on the limit of stability): Newton's method and the checks decide
    Some(h)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::dmatrix;

    fn solve_plain(a: &DMatrix<f64>, b: &DMatrix<f64>, q: &DMatrix<f64>, r: &DMatrix<f64>, time: Time) -> Result<Riccati, RiccatiError> {
        solve(RiccatiData { a, b, q, r, cross: None }, time)
    }

    #[test]
    fn double_integrator_has_its_closed_form() {
        let (a, b, q, r) = (dmatrix![0.0, 1.0; 0.0, 0.0], dmatrix![0.0; 1.0], dmatrix![1.0, 0.0; 0.0, 2.0], dmatrix![1.0]);
        let s = solve_plain(&a, &b, &q, &r, Time::Continuous).unwrap();
        assert!((s.x - dmatrix![2.0, 1.0; 1.0, 2.0]).norm() < 1e-14);
        assert!((s.gain - dmatrix![1.0, 2.0]).norm() < 1e-14);
    }

    #[test]
    fn discrete_integrator_gives_the_golden_ratio() {
        let one = dmatrix![1.0];
        let s = solve_plain(&one, &one, &one, &one, Time::Discrete).unwrap();
        assert!((s.x[(0, 0)] - 0.5 * (1.0 + 5.0_f64.sqrt())).abs() < 1e-15);
    }

    #[test]
    fn a_cross_weight_is_the_same_as_a_substitution_of_the_input() {
        // u = v - L x turns (A, B, Q, R, N) into (A - B L, B, Q - N L - L^T N^T + L^T R L, R, N - L^T R)
        let (a, b) = (dmatrix![0.2, 1.0; -0.3, 0.1], dmatrix![0.1; 1.0]);
        let (q, r, l) = (dmatrix![3.0, 0.5; 0.5, 2.0], dmatrix![2.0], dmatrix![0.4, -0.2]);
        for time in [Time::Continuous, Time::Discrete] {
            let plain = solve_plain(&a, &b, &q, &r, time).unwrap();
            let moved_a = &a - &b * &l;
            let moved_q = &q + l.transpose() * &r * &l;
            let cross = -l.transpose() * &r;
            let moved = solve(RiccatiData { a: &moved_a, b: &b, q: &moved_q, r: &r, cross: Some(&cross) }, time).unwrap();
            assert!((&moved.x - &plain.x).norm() < 1e-13 * plain.x.norm());
            assert!((moved.gain + &l - plain.gain).norm() < 1e-13);
        }
    }

    #[test]
    fn modes_out_of_reach_and_out_of_sight_are_named() {
        let names = ["psi".to_owned(), "psi.dot".to_owned(), "eps".to_owned()];
        let a = dmatrix![0.3, 0.0, 0.0; 0.0, -1.0, 1.0; 0.0, 0.0, -2.0];
        let (b, r) = (dmatrix![0.0; 0.0; 1.0], dmatrix![1.0]);
        let error = solve_plain(&a, &b, &DMatrix::identity(3, 3), &r, Time::Continuous).unwrap_err();
        assert_eq!(
            error.with_names(&names),
            "no input reaches the mode at 0.3 (psi), which does not decay by itself: no gain can stabilize it; leave its states out of the design or choose another operating point"
        );
        let a = dmatrix![0.0, 1.0, 0.0; 0.0, -1.0, 1.0; 0.0, 0.0, -2.0];
        let q = DMatrix::from_diagonal(&nalgebra::dvector![0.0, 1.0, 1.0]);
        let error = solve_plain(&a, &b, &q, &r, Time::Continuous).unwrap_err();
        assert_eq!(
            error.with_names(&names),
            "the weight does not see the mode at 0 (psi), which does not decay by itself: give one of its states a weight, or leave it out of the design"
        );
    }

    #[test]
    fn wrong_data_is_an_error_and_no_panic() {
        let (a, b, q, r) = (dmatrix![1.0], dmatrix![1.0], dmatrix![1.0], dmatrix![1.0]);
        let wide = DMatrix::identity(2, 2);
        let of = |a: &DMatrix<f64>, b: &DMatrix<f64>, q: &DMatrix<f64>, r: &DMatrix<f64>| {
            solve_plain(a, b, q, r, Time::Continuous).unwrap_err().to_string()
        };
        assert_eq!(of(&a, &b, &wide, &r), "Q is 2 x 2, 1 x 1 is needed");
        assert_eq!(of(&dmatrix![f64::NAN], &b, &q, &r), "A holds a value that is not a finite number");
        assert!(
            of(&a, &b, &q, &dmatrix![-1.0])
                .starts_with("the weight of the inputs must be positive definite, its smallest eigenvalue is -1.0")
        );
        assert!(
            of(&wide, &DMatrix::identity(2, 2), &dmatrix![1.0, 0.2; 0.1, 1.0], &wide).starts_with("Q is not symmetric: its entries (1, 2)")
        );
    }
}
