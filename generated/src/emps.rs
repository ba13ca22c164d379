//! EMPS, electro-mechanical positioning system.
//! Generated from `emps.rig` (model d1922771); edit the rig, not this file.
//!
//! A carriage on a ball screw with a direct-current motor, seen from the carriage: the benchmark of Janot,
//! Gautier and Brunot, "Data set and reference models of EMPS", Workshop on Nonlinear System Identification
//! Benchmarks, 2019, with its published inverse-dynamics estimates. The offset is part of the friction,
//! since the benchmark counts it there.
//!
//! 10 operations forward, 19 with A and B.
//! Derived twice, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::tanh;
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular, positive};

/// Parameters p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// carriage with screw and rotor [kg]
    pub M: f64,
    /// viscous friction [N*s/m]
    pub F_v: f64,
    /// Coulomb friction [N]
    pub F_c: f64,
    /// offset [N]
    pub F_0: f64,
    /// width of the Coulomb law's turn [m/s]
    pub v_c: f64,
    /// force by command [N/V]
    pub G: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        M: 95.1089,
        F_v: 203.5034,
        F_c: 20.3935,
        F_0: -3.1648,
        v_c: 0.001,
        G: 35.15065188,
    };

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 6]) -> Self {
        let [M, F_v, F_c, F_0, v_c, G] = values;
        Self { M, F_v, F_c, F_0, v_c, G }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 6] {
        [self.M, self.F_v, self.F_c, self.F_0, self.v_c, self.G]
    }
}

impl Default for Parameters {
    fn default() -> Self {
        Self::NOMINAL
    }
}

/// Coordinates q.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coordinates {
    /// q [m]
    pub q: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 1]) -> Self {
        let [q] = values;
        Self { q }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 1] {
        [self.q]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// q.dot [m/s]
    pub q: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 1]) -> Self {
        let [q] = values;
        Self { q }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 1] {
        [self.q]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// q.ddot [m/s^2]
    pub q: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 1]) -> Self {
        let [q] = values;
        Self { q }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 1] {
        [self.q]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// motor command [V]
    pub V: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 1]) -> Self {
        let [V] = values;
        Self { V }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 1] {
        [self.V]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// q [m]
    pub q: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 1]) -> Self {
        let [q] = values;
        Self { q }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 1] {
        [self.q]
    }
}

/// State x = [q | v].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Coordinates.
    pub q: Coordinates,
    /// Rates.
    pub v: Rates,
}

impl State {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [x0, x1] = values;
        Self {
            q: Coordinates::from_array([x0]),
            v: Rates::from_array([x1]),
        }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        let [x0] = self.q.to_array();
        let [x1] = self.v.to_array();
        [x0, x1]
    }
}

/// Mass matrix M(q), 1 x 1, symmetric; rows (q).
#[must_use]
pub fn mass_matrix(_q: &Coordinates, p: &Parameters) -> [[f64; 1]; 1] {
    [[p.M]]
}

/// Bias h(q, v) [N]: velocity products + gravity + springs; rows (q).
#[must_use]
pub fn bias(_q: &Coordinates, _v: &Rates, _p: &Parameters) -> [f64; 1] {
    [0.0]
}

/// Velocity products C(q, v) v [N]: Coriolis and centrifugal terms; rows (q).
#[must_use]
pub fn velocity_products(_q: &Coordinates, _v: &Rates, _p: &Parameters) -> [f64; 1] {
    [0.0]
}

/// Generalized gravity g(q) [N]: what holds the rig still; rows (q).
#[must_use]
pub fn gravity(_q: &Coordinates, _p: &Parameters) -> [f64; 1] {
    [0.0]
}

/// Friction and dampers d(q, v) [N], on the left-hand side; rows (q).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 1] {
    // friction of q
    let d_q = p.F_0 + p.F_v * v.q + p.F_c * tanh(v.q / p.v_c);
    [d_q]
}

/// Generalized force Q [N] of the inputs; rows (q).
#[must_use]
pub fn generalized_force(_q: &Coordinates, u: &Inputs, p: &Parameters) -> [f64; 1] {
    [p.G * u.V]
}

/// Input map dQ/du, 1 x 1; rows (q), columns (V).
#[must_use]
pub fn input_map(_q: &Coordinates, p: &Parameters) -> [[f64; 1]; 1] {
    [[p.G]]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(_q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    0.5 * p.M * v.q * v.q
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(_q: &Coordinates, _p: &Parameters) -> f64 {
    0.0
}

/// Inverse dynamics M a + h + d - Q [N]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 1] {
    let State { v, .. } = x;
    // friction of q
    let d_q = p.F_0 + p.F_v * v.q + p.F_c * tanh(v.q / p.v_c);
    [d_q + p.M * a.q - p.G * u.V]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.q])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(_x: &State, p: &Parameters) -> [f64; 1] {
    [p.M]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 10 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { v, .. } = x;
    // friction of q
    let d_q = p.F_0 + p.F_v * v.q + p.F_c * tanh(v.q / p.v_c);
    // M = L^T D L and back-substitution
    let q_ddot = (p.G * u.V - d_q) / p.M;
    positive(p.M, 0)?;
    Ok(Accelerations::from_array([q_ddot]))
}

/// x' and its Jacobians at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// x'.
    pub dx: [f64; 2],
    /// A = dx'/dx, 2 x 2.
    pub a: [[f64; 2]; 2],
    /// B = dx'/du, 2 x 1.
    pub b: [[f64; 1]; 2],
}

/// State derivative and its Jacobians A, B, exact, at any state.
/// 19 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///      q q.dot | V
/// q'   . 1     | .
/// q''  . *     | *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { v, .. } = x;
    let tanh_q_dot_per_v_c = tanh(v.q / p.v_c);
    // friction of q
    let d_q = p.F_0 + p.F_v * v.q + p.F_c * tanh_q_dot_per_v_c;
    // M = L^T D L and back-substitution
    let inv_q = 1.0 / p.M;
    let q_ddot = inv_q * (p.G * u.V - d_q);
    // derivatives with respect to q_dot
    let d_q_ddot_by_q_dot = -inv_q * (p.F_v + p.F_c * (1.0 - tanh_q_dot_per_v_c * tanh_q_dot_per_v_c) / p.v_c);
    positive(p.M, 0)?;
    Ok(Linearization {
        dx: [v.q, q_ddot],
        a: [[0.0, 1.0], [0.0, d_q_ddot_by_q_dot]],
        b: [[0.0], [p.G * inv_q]],
    })
}

/// As [`linearize`], without the slope of regularized Coulomb friction (at rest an artefact of its width).
/// 19 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///      q q.dot | V
/// q'   . 1     | .
/// q''  . *     | *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize_without_friction_slope(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { v, .. } = x;
    // friction of q
    let d_q = p.F_0 + p.F_v * v.q + p.F_c * tanh(v.q / p.v_c);
    // M = L^T D L and back-substitution
    let inv_q = 1.0 / p.M;
    let q_ddot = inv_q * (p.G * u.V - d_q);
    positive(p.M, 0)?;
    Ok(Linearization {
        dx: [v.q, q_ddot],
        a: [[0.0, 1.0], [0.0, -p.F_v * inv_q]],
        b: [[0.0], [p.G * inv_q]],
    })
}

/// Parameter Jacobian dx'/dp, 2 x 6; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 6]; 2], Singular> {
    let State { v, .. } = x;
    let q_dot_per_v_c = v.q / p.v_c;
    let tanh_q_dot_per_v_c = tanh(q_dot_per_v_c);
    // friction of q
    let d_q = p.F_0 + p.F_v * v.q + p.F_c * tanh_q_dot_per_v_c;
    // M = L^T D L and back-substitution
    let inv_q = 1.0 / p.M;
    let q_ddot = inv_q * (p.G * u.V - d_q);
    // derivatives with respect to v_c
    let d_q_ddot_by_v_c = p.F_c * inv_q * q_dot_per_v_c * (1.0 - tanh_q_dot_per_v_c * tanh_q_dot_per_v_c) / p.v_c;
    positive(p.M, 0)?;
    Ok([
        [0.0; 6], // q'
        // q''
        Parameters {
            M: -inv_q * q_ddot,
            F_v: -inv_q * v.q,
            F_c: -tanh_q_dot_per_v_c * inv_q,
            F_0: -inv_q,
            v_c: d_q_ddot_by_v_c,
            G: inv_q * u.V,
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 1 x 2.
    pub by_x: [[f64; 2]; 1],
    /// dy/dp, 1 x 6.
    pub by_p: [[f64; 6]; 1],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [[1.0, 0.0]],
        by_p: [
            [0.0; 6], // q
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 2] = ["q", "q.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 1] = ["V"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 6] = ["M", "F_v", "F_c", "F_0", "v_c", "G"];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 6] = ["kg", "N*s/m", "N", "N", "m/s", "N/V"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 1] = ["q"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 1] = ["m"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Emps;

impl Names for Emps {
    fn rig(&self) -> &str {
        "Emps"
    }

    fn state(&self, i: usize) -> &str {
        STATE_NAMES.get(i).copied().unwrap_or_default()
    }

    fn signal(&self, i: usize) -> &str {
        INPUT_NAMES.get(i).copied().unwrap_or_default()
    }

    fn parameter(&self, i: usize) -> &str {
        PARAMETER_NAMES.get(i).copied().unwrap_or_default()
    }

    fn output(&self, i: usize) -> &str {
        OUTPUT_NAMES.get(i).copied().unwrap_or_default()
    }

    fn parameter_unit(&self, i: usize) -> &str {
        PARAMETER_UNITS.get(i).copied().unwrap_or_default()
    }

    fn output_unit(&self, i: usize) -> &str {
        OUTPUT_UNITS.get(i).copied().unwrap_or_default()
    }
}

impl Model for Emps {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 1, lags: 0, inputs: 1, exogenous: 0, parameters: 6, outputs: 1 }
    }

    fn names(&self) -> &dyn Names {
        self
    }

    fn nominal(&self, p: &mut [f64]) {
        runtime::write(p, 0, &Parameters::NOMINAL.to_array());
    }

    fn rhs(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        let x = State::from_array(runtime::array(x));
        let u = Inputs::from_array(runtime::array(u));
        let p = Parameters::from_array(runtime::array(p));
        let a = forward_dynamics(&x, &u, &p)?;
        runtime::write(dx, 0, &x.v.to_array());
        runtime::write(dx, 1, &a.to_array());
        Ok(())
    }

    fn linearize(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64], a: &mut [f64], b: &mut [f64]) -> Result<(), Singular> {
        let x = State::from_array(runtime::array(x));
        let u = Inputs::from_array(runtime::array(u));
        let p = Parameters::from_array(runtime::array(p));
        let linear = linearize(&x, &u, &p)?;
        runtime::write(dx, 0, &linear.dx);
        runtime::write_rows(a, &linear.a);
        runtime::write_rows(b, &linear.b);
        Ok(())
    }

    fn parameter_jacobian(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], dfdp: &mut [f64]) -> Result<(), Singular> {
        let x = State::from_array(runtime::array(x));
        let u = Inputs::from_array(runtime::array(u));
        let p = Parameters::from_array(runtime::array(p));
        runtime::write_rows(dfdp, &parameter_jacobian(&x, &u, &p)?);
        Ok(())
    }

    fn pivots(&self, _t: f64, x: &[f64], p: &[f64], d: &mut [f64]) -> bool {
        let x = State::from_array(runtime::array(x));
        let p = Parameters::from_array(runtime::array(p));
        d.fill(f64::INFINITY);
        let pivots = pivots(&x, &p);
        runtime::write(d, 0, &[pivots[0]]);
        true
    }

    fn outputs(&self, _t: f64, x: &[f64], p: &[f64], y: &mut [f64]) {
        let x = State::from_array(runtime::array(x));
        let p = Parameters::from_array(runtime::array(p));
        runtime::write(y, 0, &outputs(&x, &p).to_array());
    }

    fn output_jacobian(&self, _t: f64, x: &[f64], p: &[f64], c: &mut [f64], dhdp: &mut [f64]) {
        let x = State::from_array(runtime::array(x));
        let p = Parameters::from_array(runtime::array(p));
        let slopes = output_jacobian(&x, &p);
        runtime::write_rows(c, &slopes.by_x);
        runtime::write_rows(dhdp, &slopes.by_p);
    }

    fn input_path(&self, i: usize, _p: &[f64]) -> InputPath {
        match i {
            0 => InputPath { limits: (-10.0, 10.0), delay: 0.0 },
            _ => InputPath { limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0 },
        }
    }

    fn output_path(&self, i: usize, _p: &[f64]) -> OutputPath {
        match i {
            0 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            _ => OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false },
        }
    }
}
