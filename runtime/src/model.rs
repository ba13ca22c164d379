//! The model of a rig as identification, control and simulation see it: slices in, slices out.

/// Sizes of a model. The state is x = [q | v | z] (coordinates, their rates, actuator states),
/// so `states` = 2 `coordinates` + `lags`; the signal u = [inputs | exogenous], where the
/// exogenous signals are the accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimensions {
    /// Generalized coordinates, prescribed ones included.
    pub coordinates: usize,
    /// Actuator states.
    pub lags: usize,
    /// Commands to actuators.
    pub inputs: usize,
    /// Exogenous signals.
    pub exogenous: usize,
    /// Parameters.
    pub parameters: usize,
    /// Measured outputs.
    pub outputs: usize,
}

impl Dimensions {
    /// Length of x.
    #[must_use]
    pub const fn states(&self) -> usize {
        2 * self.coordinates + self.lags
    }

    /// Scratch that [`Model::sensitivities`] needs.
    #[must_use]
    pub const fn sensitivity_work(&self) -> usize {
        self.states() * (self.signals() + self.parameters)
    }

    /// Length of u, exogenous signals included.
    #[must_use]
    pub const fn signals(&self) -> usize {
        self.inputs + self.exogenous
    }
}

/// The mass matrix is not positive definite: the pivot of this coordinate vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Singular {
    /// Index of the coordinate.
    pub coordinate: usize,
}

/// What a state is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StateKind {
    /// Coordinate with this index.
    Coordinate(usize),
    /// Rate of the coordinate with this index.
    Rate(usize),
    /// Actuator state with this index.
    Lag(usize),
}

/// Names, units and the like of a model's vectors. Borrowed; of length as in [`Dimensions`].
pub trait Names {
    /// Name of the rig.
    fn rig(&self) -> &str;
    /// Name of state i: `eps`, `eps.dot`, `f_1.lag`.
    fn state(&self, i: usize) -> &str;
    /// Name of signal i (inputs, then exogenous signals `s.ddot`).
    fn signal(&self, i: usize) -> &str;
    /// Name of parameter i.
    fn parameter(&self, i: usize) -> &str;
    /// Name of output i.
    fn output(&self, i: usize) -> &str;
    /// Unit of parameter i, as text.
    fn parameter_unit(&self, i: usize) -> &str;
    /// Unit of signal i, as text; empty where it is not known.
    fn signal_unit(&self, _i: usize) -> &str {
        ""
    }
    /// Unit of output i, as text.
    fn output_unit(&self, i: usize) -> &str;
}

/// The path by which input i enters: limits, then delay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputPath {
    /// Lower and upper limit (SI), infinite where there is none.
    pub limits: (f64, f64),
    /// Delay [s].
    pub delay: f64,
}

/// The path by which output i leaves, after `outputs` (which applies scale and bias): delay, then play, then encoder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputPath {
    /// Delay [s].
    pub delay: f64,
    /// Whole width W of the play between value and sensor (SI), zero where there is none: the reading r stands until the
    /// value y has gone through the play, r = clamp(r, y - W/2, y + W/2), and begins in its middle.
    pub play: f64,
    /// Quantum of the encoder (SI), zero where there is none.
    pub quantum: f64,
    /// The encoder reads modulo one turn.
    pub wrapped: bool,
}

/// A model: x' = f(t, x, u, p), y = h(x, p), with exact Jacobians.
///
/// Matrices are row-major slices: `a[i * columns + j]`. Slices have exactly the lengths that
/// [`Model::dimensions`] says; an implementation may panic on others.
pub trait Model: Sync {
    /// Sizes.
    fn dimensions(&self) -> Dimensions;
    /// Names and units.
    fn names(&self) -> &dyn Names;
    /// Nominal parameters (SI), written to `p`.
    fn nominal(&self, p: &mut [f64]);
    /// x' = f(t, x, u, p).
    ///
    /// # Errors
    /// [`Singular`] where the mass matrix is not positive definite.
    fn rhs(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular>;
    /// x' and A = df/dx (states x states), B = df/du (states x signals).
    ///
    /// # Errors
    /// [`Singular`] where the mass matrix is not positive definite.
    #[allow(clippy::too_many_arguments)]
    fn linearize(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64], a: &mut [f64], b: &mut [f64]) -> Result<(), Singular>;
    /// df/dp (states x parameters).
    ///
    /// # Errors
    /// [`Singular`] where the mass matrix is not positive definite.
    fn parameter_jacobian(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dfdp: &mut [f64]) -> Result<(), Singular>;
    /// What sensitivities are integrated with: x', A = df/dx and the columns `columns` of df/dp (states x columns), in one
    /// evaluation. `work` has at least [`Dimensions::sensitivity_work`] numbers.
    ///
    /// # Errors
    /// [`Singular`] where the mass matrix is not positive definite.
    #[allow(clippy::too_many_arguments)]
    fn sensitivities(
        &self,
        t: f64,
        x: &[f64],
        u: &[f64],
        p: &[f64],
        columns: &[usize],
        dx: &mut [f64],
        a: &mut [f64],
        dfdp: &mut [f64],
        work: &mut [f64],
    ) -> Result<(), Singular> {
        sensitivities_by_parts(self, t, x, u, p, columns, dx, a, dfdp, work)
    }
    /// Pivots D of the mass matrix M = L^T D L, one a coordinate (infinite where a coordinate is prescribed), written to
    /// `d`; false where the model does not give them. Pivot k vanishes where coordinate k moves no inertia.
    fn pivots(&self, _t: f64, _x: &[f64], _p: &[f64], _d: &mut [f64]) -> bool {
        false
    }
    /// y = h(t, x, p), without delay, play and quantization.
    fn outputs(&self, t: f64, x: &[f64], p: &[f64], y: &mut [f64]);
    /// C = dh/dx (outputs x states), dh/dp (outputs x parameters).
    fn output_jacobian(&self, t: f64, x: &[f64], p: &[f64], c: &mut [f64], dhdp: &mut [f64]);
    /// How input i enters.
    fn input_path(&self, i: usize, p: &[f64]) -> InputPath;
    /// How output i leaves.
    fn output_path(&self, i: usize, p: &[f64]) -> OutputPath;
}

/// [`Model::sensitivities`] from [`Model::linearize`] and [`Model::parameter_jacobian`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
#[allow(clippy::too_many_arguments)]
pub fn sensitivities_by_parts<M: Model + ?Sized>(
    model: &M,
    t: f64,
    x: &[f64],
    u: &[f64],
    p: &[f64],
    columns: &[usize],
    dx: &mut [f64],
    a: &mut [f64],
    dfdp: &mut [f64],
    work: &mut [f64],
) -> Result<(), Singular> {
    let d = model.dimensions();
    let (b, all) = work.split_at_mut(d.states() * d.signals());
    model.linearize(t, x, u, p, dx, a, b)?;
    if columns.is_empty() {
        return Ok(());
    }
    let all = &mut all[..d.states() * d.parameters];
    model.parameter_jacobian(t, x, u, p, all)?;
    // q' = v has no parameters
    let (by_positions, rest) = dfdp.split_at_mut(d.coordinates * columns.len());
    by_positions.fill(0.0);
    for (to, from) in rest.chunks_exact_mut(columns.len()).zip(all.chunks_exact(d.parameters).skip(d.coordinates)) {
        for (to, &j) in to.iter_mut().zip(columns) {
            *to = from[j];
        }
    }
    Ok(())
}
