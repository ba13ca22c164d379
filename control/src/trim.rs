//! Trim: chosen accelerations vanish while chosen unknowns move; everything else is held.
//!
//! Newton's method with the model's exact Jacobian, steps by the pseudo-inverse (minimum norm, so that
//! directions that do nothing stay where they are) and halved until the residual falls. Equations and unknowns are
//! scaled to one another before any rank is decided, since newtons, volts and radians stand side by side. Actuator
//! states follow their commands: their rates are equations and they are unknowns, always.

use nalgebra::{DMatrix, DVector};
use runtime::Model;
use std::fmt;

/// An unknown of a trim: a direction in [x | u].
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// Name for messages and for free directions.
    pub name: String,
    /// (state, weight): how states move with the unknown.
    pub states: Vec<(usize, f64)>,
    /// (signal, weight): how signals move with the unknown.
    pub signals: Vec<(usize, f64)>,
}

impl Unknown {
    /// A single state.
    #[must_use]
    pub fn state(name: &str, i: usize) -> Self {
        Self { name: name.to_owned(), states: vec![(i, 1.0)], signals: Vec::new() }
    }

    /// A single signal.
    #[must_use]
    pub fn signal(name: &str, i: usize) -> Self {
        Self { name: name.to_owned(), states: Vec::new(), signals: vec![(i, 1.0)] }
    }
}

/// What is held, what moves and what vanishes.
#[derive(Clone, Debug)]
pub struct TrimProblem {
    /// State at the start; entries that no unknown moves stay.
    pub x: Vec<f64>,
    /// Signals at the start.
    pub u: Vec<f64>,
    /// Unknowns.
    pub unknowns: Vec<Unknown>,
    /// Coordinates whose accelerations vanish.
    pub zero: Vec<usize>,
}

/// An operating point.
#[derive(Clone, Debug, PartialEq)]
pub struct Trim {
    /// State.
    pub x: Vec<f64>,
    /// Signals.
    pub u: Vec<f64>,
    /// Accelerations that remain, all coordinates.
    pub drift: Vec<f64>,
    /// Largest residual of the equations [SI].
    pub residual: f64,
    /// Rank of the equations in the unknowns.
    pub rank: usize,
    /// Number of unknowns, actuator states not counted.
    pub unknowns: usize,
    /// Unknowns whose change changes no equation: (name, weight) for each direction.
    pub free: Vec<Vec<(String, f64)>>,
    /// Newton steps.
    pub iterations: usize,
}

/// Why no operating point was found.
#[derive(Clone, Debug, PartialEq)]
pub enum TrimError {
    /// As many equations as unknowns are needed.
    NotSquare {
        /// Names of the unknowns.
        unknowns: Vec<String>,
        /// Names of the coordinates whose accelerations vanish.
        equations: Vec<String>,
    },
    /// The problem does not fit the model: a vector or an index is too short or too large.
    Shape,
    /// The mass matrix is singular on the way.
    Singular {
        /// Coordinate that moves no inertia.
        coordinate: String,
    },
    /// The residual does not fall to rounding: no operating point near the start.
    NoConvergence {
        /// Acceleration that remains [SI].
        residual: f64,
        /// Coordinate (or actuator) whose acceleration (or rate) that is.
        coordinate: String,
        /// Rank of the equations there.
        rank: usize,
        /// Number of unknowns.
        unknowns: usize,
        /// Unknowns that change no equation there.
        free: Vec<Vec<(String, f64)>>,
        /// Newton steps.
        iterations: usize,
    },
    /// A value stopped being a number.
    NotFinite,
}

impl fmt::Display for TrimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotSquare { unknowns, equations } => write!(
                f,
                "{} to be solved for ({}) but {} to vanish ({}): as many of one as of the other are needed",
                count(unknowns.len(), "quantity", "quantities"),
                unknowns.join(", "),
                count(equations.len(), "acceleration", "accelerations"),
                equations.join(", ")
            ),
            Self::Shape => f.write_str("the trim does not fit the model: a vector has the wrong length or an index is out of range"),
            Self::Singular { coordinate } => write!(f, "the mass matrix is singular on the way: {coordinate} moves no inertia there"),
            Self::NoConvergence { residual, coordinate, rank, unknowns, free, iterations } => {
                write!(
                    f,
                    "no operating point near the start: after {} `{coordinate}` keeps an acceleration of {residual:.3e} (rank {rank} of {unknowns})",
                    count(*iterations, "step", "steps")
                )?;
                match free.first() {
                    Some(direction) => {
                        write!(f, "; nothing there depends on {}: solve for another quantity, or start elsewhere", words(direction))
                    }
                    None => f.write_str("; start elsewhere, or hold another quantity"),
                }
            }
            Self::NotFinite => f.write_str("a value of the model is not finite on the way to the operating point"),
        }
    }
}

fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

fn words(direction: &[(String, f64)]) -> String {
    let names: Vec<&str> = direction.iter().map(|(name, _)| name.as_str()).collect();
    if names.len() == 1 { names[0].to_owned() } else { format!("a combination of {}", names.join(", ")) }
}

impl std::error::Error for TrimError {}

const ITERATIONS: usize = 60;
/// Accelerations below this, relative to the terms that make them up, count as zero.
const TOLERANCE: f64 = 1e-11;
/// Size [SI] below which the terms of an equation are not told from none.
const FLOOR: f64 = 1e-4;
/// Singular values below this, relative to the largest one of the scaled equations, count as zero.
const RANK: f64 = 1e-9;

/// Finds the operating point.
///
/// # Errors
/// [`TrimError`], one variant a cause.
pub fn solve(model: &dyn Model, p: &[f64], problem: &TrimProblem) -> Result<Trim, TrimError> {
    let search = Search::new(model, p, problem)?;
    let (mut x, mut u) = (problem.x.clone(), problem.u.clone());
    let mut scale = vec![FLOOR; search.rows.len()];
    let mut iterations = 0;
    let point = loop {
        let point = search.at(&x, &u)?;
        scale.iter_mut().zip(&point.terms).for_each(|(s, t): (&mut f64, &f64)| *s = s.max(*t));
        let merit = size(&point.values, &scale);
        if merit <= 4.0 * f64::EPSILON || iterations == ITERATIONS {
            break point;
        }
        let step = Scaled::new(&point.jacobian, &scale).step(&point.values);
        let mut factor = 1.0;
        let next = loop {
            if factor < 1e-6 {
                break None;
            }
            let (x, u) = search.moved(&x, &u, &(&step * factor));
            if search.values(&x, &u).is_some_and(|values| size(&values, &scale) < merit) {
                break Some((x, u));
            }
            factor *= 0.5;
        };
        iterations += 1;
        match next {
            Some(next) => (x, u) = next,
            None => break point,
        }
    };
    let (rank, free) = Scaled::new(&point.jacobian, &scale).rank_and_free(&search);
    let unknowns = problem.unknowns.len();
    if size(&point.values, &scale) > TOLERANCE {
        let relative = |i: usize| point.values[i].abs() / scale[i];
        let worst = (0..search.rows.len()).max_by(|&i, &j| relative(i).total_cmp(&relative(j))).unwrap_or(0);
        let coordinate = search.row_name(worst);
        return Err(TrimError::NoConvergence { residual: point.values[worst], coordinate, rank, unknowns, free, iterations });
    }
    let n = model.dimensions().coordinates;
    Ok(Trim { free, drift: point.dx[n..2 * n].to_vec(), x, u, residual: point.values.amax(), rank, unknowns, iterations })
}

/// Largest value, each relative to the size of its equation's terms.
fn size(values: &DVector<f64>, scale: &[f64]) -> f64 {
    values.iter().zip(scale).fold(0.0, |m: f64, (v, s)| m.max(v.abs() / s))
}

/// The equations and unknowns of a problem.
struct Search<'a> {
    model: &'a dyn Model,
    p: &'a [f64],
    unknowns: Vec<Unknown>,
    /// Entries of x' that vanish.
    rows: Vec<usize>,
}

/// The equations at a point.
struct Point {
    dx: Vec<f64>,
    values: DVector<f64>,
    /// Equations x unknowns.
    jacobian: DMatrix<f64>,
    /// For each equation: its value and the parts of it that the state and each signal make up, added by modulus.
    terms: Vec<f64>,
}

impl<'a> Search<'a> {
    fn new(model: &'a dyn Model, p: &'a [f64], problem: &TrimProblem) -> Result<Self, TrimError> {
        let d = model.dimensions();
        let (n, states, signals) = (d.coordinates, d.states(), d.signals());
        let fits = problem.x.len() == states
            && problem.u.len() == signals
            && p.len() == d.parameters
            && problem.zero.iter().all(|&i| i < n)
            && problem.unknowns.iter().all(|k| k.states.iter().all(|&(i, _)| i < states) && k.signals.iter().all(|&(i, _)| i < signals));
        if !fits {
            return Err(TrimError::Shape);
        }
        if problem.unknowns.len() != problem.zero.len() {
            return Err(TrimError::NotSquare {
                unknowns: problem.unknowns.iter().map(|u| u.name.clone()).collect(),
                equations: problem.zero.iter().map(|&i| model.names().state(i).to_owned()).collect(),
            });
        }
        let mut unknowns = problem.unknowns.clone();
        unknowns.extend((0..d.lags).map(|k| Unknown::state("", 2 * n + k)));
        let rows = problem.zero.iter().map(|&i| n + i).chain((0..d.lags).map(|k| 2 * n + k)).collect();
        Ok(Self { model, p, unknowns, rows })
    }

    fn row_name(&self, row: usize) -> String {
        let n = self.model.dimensions().coordinates;
        self.rows.get(row).map_or_else(String::new, |&r| self.model.names().state(if r < 2 * n { r - n } else { r }).to_owned())
    }

    fn at(&self, x: &[f64], u: &[f64]) -> Result<Point, TrimError> {
        let (states, signals) = (x.len(), u.len());
        let (mut dx, mut a, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * signals]);
        self.model
            .linearize(0.0, x, u, self.p, &mut dx, &mut a, &mut b)
            .map_err(|s| TrimError::Singular { coordinate: self.model.names().state(s.coordinate).to_owned() })?;
        let jacobian = DMatrix::from_fn(self.rows.len(), self.unknowns.len(), |i, j| {
            let row = self.rows[i];
            let by_states: f64 = self.unknowns[j].states.iter().map(|&(k, w)| w * a[row * states + k]).sum();
            let by_signals: f64 = self.unknowns[j].signals.iter().map(|&(k, w)| w * b[row * signals + k]).sum();
            by_states + by_signals
        });
        let values = DVector::from_iterator(self.rows.len(), self.rows.iter().map(|&r| dx[r]));
        if jacobian.iter().chain(values.iter()).any(|v| !v.is_finite()) {
            return Err(TrimError::NotFinite);
        }
        let part = |m: &[f64], v: &[f64], row: usize| -> f64 {
            m[row * v.len()..(row + 1) * v.len()].iter().zip(v).map(|(m, v)| (m * v).abs()).sum()
        };
        let terms = self.rows.iter().map(|&r| dx[r].abs() + part(&a, x, r) + part(&b, u, r)).collect();
        Ok(Point { dx, values, jacobian, terms })
    }

    fn values(&self, x: &[f64], u: &[f64]) -> Option<DVector<f64>> {
        let mut dx = vec![0.0; x.len()];
        self.model.rhs(0.0, x, u, self.p, &mut dx).ok()?;
        let values = DVector::from_iterator(self.rows.len(), self.rows.iter().map(|&r| dx[r]));
        values.iter().all(|v| v.is_finite()).then_some(values)
    }

    fn moved(&self, x: &[f64], u: &[f64], step: &DVector<f64>) -> (Vec<f64>, Vec<f64>) {
        let (mut x, mut u) = (x.to_vec(), u.to_vec());
        for (unknown, s) in self.unknowns.iter().zip(step.iter()) {
            unknown.states.iter().for_each(|&(i, w)| x[i] += w * s);
            unknown.signals.iter().for_each(|&(i, w)| u[i] += w * s);
        }
        (x, u)
    }
}

/// The Jacobian with equations relative to their terms and unknowns relative to their largest effect.
struct Scaled {
    matrix: DMatrix<f64>,
    rows: Vec<f64>,
    columns: Vec<f64>,
}

impl Scaled {
    fn new(jacobian: &DMatrix<f64>, scale: &[f64]) -> Self {
        let or_one = |v: f64| if v > 0.0 { v } else { 1.0 };
        let rows: Vec<f64> = scale.iter().map(|&s| 1.0 / s).collect();
        let mut matrix = DMatrix::from_fn(jacobian.nrows(), jacobian.ncols(), |i, j| jacobian[(i, j)] * rows[i]);
        let columns: Vec<f64> = (0..matrix.ncols()).map(|j| 1.0 / or_one(matrix.column(j).amax())).collect();
        for (j, c) in columns.iter().enumerate() {
            matrix.column_mut(j).scale_mut(*c);
        }
        Self { matrix, rows, columns }
    }

    /// Step of least norm (in scaled unknowns) that makes the values vanish to first order.
    fn step(&self, values: &DVector<f64>) -> DVector<f64> {
        if self.matrix.is_empty() {
            return DVector::zeros(self.columns.len());
        }
        let wanted = DVector::from_fn(values.len(), |i, _| -values[i] * self.rows[i]);
        let svd = self.matrix.clone().svd(true, true);
        let threshold = 1e-10 * svd.singular_values.amax();
        let step = svd.solve(&wanted, threshold).unwrap_or_else(|_| DVector::zeros(self.columns.len()));
        DVector::from_fn(step.len(), |j, _| step[j] * self.columns[j])
    }

    /// Rank without the actuators' own equations, and the named directions that change no equation (weights relative to
    /// the largest one).
    fn rank_and_free(&self, search: &Search<'_>) -> (usize, Vec<Vec<(String, f64)>>) {
        if self.matrix.is_empty() {
            return (0, Vec::new());
        }
        let svd = self.matrix.clone().svd(false, true);
        let threshold = RANK * svd.singular_values.amax();
        let lags = search.model.dimensions().lags;
        let rank = svd.singular_values.iter().filter(|&&s| s > threshold && s > 0.0).count().saturating_sub(lags);
        let mut free = Vec::new();
        let Some(v_t) = svd.v_t else { return (rank, free) };
        for (k, &value) in svd.singular_values.iter().enumerate() {
            if value > threshold && value > 0.0 {
                continue;
            }
            let direction: Vec<f64> = (0..self.columns.len()).map(|j| v_t[(k, j)] * self.columns[j]).collect();
            let largest = direction.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(1.0);
            let named: Vec<(String, f64)> = search
                .unknowns
                .iter()
                .zip(&direction)
                .filter(|(u, w)| !u.name.is_empty() && (*w / largest).abs() > 1e-6)
                .map(|(u, w)| (u.name.clone(), w / largest))
                .collect();
            if !named.is_empty() {
                free.push(named);
            }
        }
        (rank, free)
    }
}
