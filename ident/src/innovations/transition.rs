//! From one sample to the next: state, its transition matrix and what parameters add.
//!
//! The state takes classical Runge-Kutta steps; matrices come from the Jacobians at the middle of a step, as the fourth-order
//! series of the exponential. No step crosses a switch of an input.

use super::filter::Column;
use super::noise::{Dry, Noise};
use runtime::Model;
use sim::Segment;

/// Longest step times the model's fastest rate.
const REACH: f64 = 0.35;
/// Longest step in time constants of a lag.
const REACH_OF_LAG: f64 = 1.2;
/// Most steps between two switches.
const MOST: f64 = 40.0;

/// The model cannot be integrated on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stopped;

/// What is carried along: x, d, the covariance of both, and the sensitivities of both by rows.
pub(crate) struct Carried {
    /// States, then disturbances.
    pub state: Vec<f64>,
    /// Covariance, order x order; empty where it is not wanted.
    pub covariance: Vec<f64>,
    /// order x columns.
    pub sensitivity: Vec<f64>,
    /// Transition matrix since it was set to one, order x order; empty where it is not wanted.
    pub transition: Vec<f64>,
}

pub(crate) struct Stepper<'a> {
    model: &'a dyn Model,
    /// Parameters by which disturbances enter.
    entries: Vec<usize>,
    /// 1 / correlation time of each disturbance.
    decay: Vec<f64>,
    /// Variance of each.
    variance: Vec<f64>,
    columns: &'a [Column<'a>],
    /// Parameters whose derivatives are asked of the model: disturbances, then those of the columns.
    asked: Vec<usize>,
    dry: Vec<Dry>,
    /// Time between the samples [s].
    pub sample: f64,
    /// Columns that delay an input: column, input, seconds for one unit of the column.
    delayed: Vec<(usize, usize, f64)>,
    fastest: f64,
    p: Vec<f64>,
    n: usize,
    k: [Vec<f64>; 4],
    x: Vec<f64>,
    u: Vec<f64>,
    a: Vec<f64>,
    b: Vec<f64>,
    dfdp: Vec<f64>,
    work: Vec<f64>,
    dx: Vec<f64>,
    other: Vec<f64>,
    forcing: Vec<f64>,
    phi: Vec<f64>,
    psi: Vec<f64>,
    power: Vec<f64>,
    next: Vec<f64>,
    full: Vec<f64>,
    spare: Vec<f64>,
}

impl<'a> Stepper<'a> {
    pub fn new(model: &'a dyn Model, p: &[f64], noise: &Noise, variance: Vec<f64>, decay: Vec<f64>, columns: &'a [Column<'a>]) -> Self {
        let entries = &noise.entries;
        let d = model.dimensions();
        let n = d.states();
        let order = n + entries.len();
        let mut asked = entries.clone();
        asked.extend(columns.iter().filter_map(|c| if let Column::Parameter(i) | Column::Weighted(i, _) = c { Some(*i) } else { None }));
        let zeros = |length: usize| vec![0.0; length];
        Self {
            model,
            entries: entries.clone(),
            dry: noise.dry.clone(),
            sample: 0.0,
            decay,
            variance,
            columns,
            delayed: delayed(model, p, columns),
            fastest: 0.0,
            p: p.to_vec(),
            n,
            k: std::array::from_fn(|_| zeros(n)),
            x: zeros(n),
            u: zeros(d.signals()),
            a: zeros(n * n),
            b: zeros(n * d.signals()),
            dfdp: zeros(n * asked.len()),
            work: zeros(d.sensitivity_work()),
            dx: zeros(n),
            other: zeros(n),
            forcing: zeros(n * columns.len()),
            phi: zeros(n * n),
            psi: zeros(n * n),
            power: zeros(n * n),
            next: zeros(order * order.max(columns.len())),
            full: zeros(order * order),
            spare: zeros(order * order),
            asked,
        }
    }

    /// Parameters, disturbances in their places as last set.
    pub fn parameters(&self) -> &[f64] {
        &self.p
    }

    /// Carries everything over one stretch on which the inputs are straight.
    pub fn stretch(&mut self, segment: &Segment, from: f64, to: f64, carried: &mut Carried) -> Result<(), Stopped> {
        if self.fastest == 0.0 {
            self.jacobians(from, segment, carried)?;
        }
        let steps = ((to - from) * self.fastest / REACH).ceil().clamp(1.0, MOST) as usize;
        let h = (to - from) / steps as f64;
        for k in 0..steps {
            self.step(segment, from + h * k as f64, h, carried)?;
        }
        Ok(())
    }

    fn jacobians(&mut self, t: f64, segment: &Segment, carried: &Carried) -> Result<(), Stopped> {
        self.x.copy_from_slice(&carried.state[..self.n]);
        self.evaluate(t, segment)
    }

    /// A, df/dp and the rest at `self.x`.
    fn evaluate(&mut self, t: f64, segment: &Segment) -> Result<(), Stopped> {
        segment.at(t, &mut self.u);
        let Self { model, x, u, p, asked, dx, a, dfdp, work, .. } = self;
        model.sensitivities(t, x, u, p, asked, dx, a, dfdp, work).map_err(|_| Stopped)?;
        if !self.delayed.is_empty() {
            let Self { model, x, u, p, other, power, b, .. } = self;
            model.linearize(t, x, u, p, other, power, b).map_err(|_| Stopped)?;
        }
        self.fastest = fastest(&self.a, self.n, 2 * self.model.dimensions().coordinates);
        Ok(())
    }

    /// A switch of the inputs by `jump` at time t: what a delay would change.
    pub fn switch(&mut self, t: f64, segment: &Segment, jump: &[f64], carried: &mut Carried) -> Result<(), Stopped> {
        if self.delayed.is_empty() {
            return Ok(());
        }
        self.jacobians(t, segment, carried)?;
        let (m, signals) = (self.columns.len(), self.u.len());
        for &(c, j, seconds) in &self.delayed {
            for i in 0..self.n {
                carried.sensitivity[i * m + c] -= self.b[i * signals + j] * jump[j] * seconds;
            }
        }
        Ok(())
    }

    fn step(&mut self, segment: &Segment, t: f64, h: f64, carried: &mut Carried) -> Result<(), Stopped> {
        let (n, nd, m) = (self.n, self.entries.len(), self.columns.len());
        let order = n + nd;
        for (k, &i) in self.entries.iter().enumerate() {
            self.p[i] = carried.state[n + k];
        }
        // the state
        for stage in 0..4 {
            let c = [0.0, 0.5, 0.5, 1.0][stage];
            for i in 0..n {
                self.x[i] = carried.state[i] + if stage == 0 { 0.0 } else { c * h * self.k[stage - 1][i] };
            }
            segment.at(t + c * h, &mut self.u);
            let (x, u, p, k) = (&self.x, &self.u, &self.p, &mut self.k[stage]);
            self.model.rhs(t + c * h, x, u, p, k).map_err(|_| Stopped)?;
        }
        for i in 0..n {
            self.x[i] = carried.state[i] + 0.5 * h * self.k[1][i];
        }
        self.evaluate(t + 0.5 * h, segment)?;
        for i in 0..n {
            carried.state[i] += h / 6.0 * (self.k[0][i] + 2.0 * self.k[1][i] + 2.0 * self.k[2][i] + self.k[3][i]);
            if !carried.state[i].is_finite() {
                return Err(Stopped);
            }
        }
        self.series(h);

        // [phi, psi B_d; 0, decay]
        let asked = self.asked.len();
        self.full.fill(0.0);
        for i in 0..n {
            self.full[i * order..i * order + n].copy_from_slice(&self.phi[i * n..(i + 1) * n]);
            for k in 0..nd {
                self.full[i * order + n + k] = (0..n).map(|j| self.psi[i * n + j] * self.dfdp[j * asked + k]).sum();
            }
        }
        for k in 0..nd {
            let kept = (-h * self.decay[k]).exp();
            self.full[(n + k) * order + n + k] = kept;
            carried.state[n + k] *= kept;
        }
        if m > 0 {
            self.columns(t + 0.5 * h, segment)?;
            self.next[..order * m].fill(0.0);
            product(&self.full, &carried.sensitivity, &mut self.next, order, order, m);
            product(&self.psi, &self.forcing, &mut self.next, n, n, m);
            carried.sensitivity.copy_from_slice(&self.next[..order * m]);
        }
        if !carried.covariance.is_empty() {
            self.spare.fill(0.0);
            product(&self.full, &carried.covariance, &mut self.spare, order, order, order);
            // times the transpose
            for i in 0..order {
                for j in i..order {
                    let value: f64 = (0..order).map(|l| self.spare[i * order + l] * self.full[j * order + l]).sum();
                    carried.covariance[i * order + j] = value;
                    carried.covariance[j * order + i] = value;
                }
            }
            for k in 0..nd {
                let at = (n + k) * order + n + k;
                carried.covariance[at] += self.variance[k] * -(-2.0 * h * self.decay[k]).exp_m1();
            }
            for dry in &self.dry {
                // the smooth law over the rate's distribution: what is left of its variance
                let (rate, width) = (carried.state[dry.rate], dry.width.of(&self.p));
                let spread = (carried.covariance[dry.rate * order + dry.rate].max(0.0) + width * width).sqrt();
                let sure = (std::f64::consts::FRAC_2_PI.sqrt() * rate / spread.max(f64::MIN_POSITIVE)).tanh();
                let power = dry.level.of(&self.p).powi(2) * (1.0 - sure * sure) * self.sample * h;
                for i in 0..n {
                    let by = power * self.dfdp[i * asked + dry.entry];
                    for j in 0..n {
                        carried.covariance[i * order + j] += by * self.dfdp[j * asked + dry.entry];
                    }
                }
            }
        }
        if !carried.transition.is_empty() {
            self.spare.fill(0.0);
            product(&self.full, &carried.transition, &mut self.spare, order, order, order);
            carried.transition.copy_from_slice(&self.spare);
        }
        Ok(())
    }

    /// What each column adds to x'.
    fn columns(&mut self, t: f64, segment: &Segment) -> Result<(), Stopped> {
        let (n, m, asked, signals) = (self.n, self.columns.len(), self.asked.len(), self.u.len());
        let mut parameter = self.entries.len();
        for (c, column) in self.columns.iter().enumerate() {
            match column {
                Column::Parameter(_) => {
                    for i in 0..n {
                        self.forcing[i * m + c] = self.dfdp[i * asked + parameter];
                    }
                    parameter += 1;
                }
                Column::Weighted(_, shape) => {
                    let weight = shape(t, &self.x, &self.u);
                    for i in 0..n {
                        self.forcing[i * m + c] = self.dfdp[i * asked + parameter] * weight;
                    }
                    parameter += 1;
                }
                Column::InputDelay(_) => (0..n).for_each(|i| self.forcing[i * m + c] = 0.0),
                Column::OutputDelay(_) => {}
                Column::Shaped(entry, shape) => {
                    let size = shape(t, &self.x, &self.u);
                    for i in 0..n {
                        self.forcing[i * m + c] = self.dfdp[i * asked + entry] * size;
                    }
                }
                Column::Towards(model) => {
                    let (x, u, p, other) = (&self.x, &self.u, &self.p, &mut self.other);
                    model.rhs(t, x, u, p, other).map_err(|_| Stopped)?;
                    for (row, (other, own)) in self.forcing.chunks_exact_mut(m).zip(self.other.iter().zip(&self.dx)) {
                        row[c] = other - own;
                    }
                }
            }
        }
        for &(c, j, seconds) in &self.delayed {
            for i in 0..n {
                self.forcing[i * m + c] -= self.b[i * signals + j] * segment.slopes[j] * seconds;
            }
        }
        Ok(())
    }

    /// phi = exp(h A), psi = integral of exp(s A) over 0..h, to fourth order.
    fn series(&mut self, h: f64) {
        let n = self.n;
        self.phi.fill(0.0);
        self.psi.fill(0.0);
        self.power.fill(0.0);
        for i in 0..n {
            self.phi[i * n + i] = 1.0;
            self.psi[i * n + i] = h;
            self.power[i * n + i] = 1.0;
        }
        for k in 1..=4 {
            let factor = h / f64::from(k);
            let spare = &mut self.spare[..n * n];
            spare.fill(0.0);
            product(&self.power, &self.a, spare, n, n, n);
            for ((power, next), (phi, psi)) in self.power.iter_mut().zip(spare.iter()).zip(self.phi.iter_mut().zip(&mut self.psi)) {
                *power = factor * next;
                *phi += *power;
                *psi += *power * h / f64::from(k + 1);
            }
        }
    }
}

/// Which columns delay which inputs, and by how much.
fn delayed(model: &dyn Model, p: &[f64], columns: &[Column<'_>]) -> Vec<(usize, usize, f64)> {
    let mut found = Vec::new();
    for (c, column) in columns.iter().enumerate() {
        match column {
            Column::InputDelay(j) => found.push((c, *j, 1.0)),
            Column::Parameter(i) => found.extend(
                by_parameter(p, *i, model.dimensions().inputs, |j, p| model.input_path(j, p).delay).into_iter().map(|(j, s)| (c, j, s)),
            ),
            _ => {}
        }
    }
    found
}

/// The derivatives of `count` delays by a parameter, those that are not zero.
pub(super) fn by_parameter(p: &[f64], parameter: usize, count: usize, delay: impl Fn(usize, &[f64]) -> f64) -> Vec<(usize, f64)> {
    let size = (1e-3 * p[parameter].abs()).max(1e-6);
    let mut moved = p.to_vec();
    let mut at = |by: f64| {
        moved[parameter] = p[parameter] + by;
        (0..count).map(|j| delay(j, &moved)).collect::<Vec<_>>()
    };
    let (above, below) = (at(size), at(-size));
    (0..count).map(|j| (j, (above[j] - below[j]) / (2.0 * size))).filter(|(_, s)| *s != 0.0).collect()
}

/// `out` += a b, with a (rows x inner) and b (inner x columns).
pub(crate) fn product(a: &[f64], b: &[f64], out: &mut [f64], rows: usize, inner: usize, columns: usize) {
    for i in 0..rows {
        let target = &mut out[i * columns..(i + 1) * columns];
        for l in 0..inner {
            let factor = a[i * inner + l];
            if factor != 0.0 {
                target.iter_mut().zip(&b[l * columns..(l + 1) * columns]).for_each(|(t, b)| *t += factor * b);
            }
        }
    }
}

/// A bound of the size of A's eigenvalues that does not take a stiff spring's constant for a rate: of A^2, its root; over the states that
/// move. A lag behind them is one decay: its end is exact whatever the step, and what it does on the way lasts no longer than itself.
fn fastest(a: &[f64], n: usize, moving: usize) -> f64 {
    let mut largest = 0.0_f64;
    for i in 0..moving {
        let mut sum = 0.0;
        for j in 0..moving {
            sum += (0..moving).map(|l| a[i * n + l] * a[l * n + j]).sum::<f64>().abs();
        }
        largest = largest.max(sum);
    }
    let lag = (moving..n).map(|i| a[i * n + i].abs()).fold(0.0, f64::max);
    largest.sqrt().max(lag * REACH / REACH_OF_LAG).max(1e-9)
}
