//! Cart and pole.
//! Generated from `cart_pole.rig` (model eaaaff00); edit the rig, not this file.
//!
//! The numbers of gymnasium's CartPole (cart 1 kg, pole 0.1 kg, half length 0.5 m), with the pole a
//! uniform rod. theta = 0 is upright, positive towards +x.
//!
//! 33 operations forward, 64 with A and B.
//! Derived twice, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::{cos, sin, sin_cos};
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular, positive};

/// Parameters p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// cart [kg]
    pub m_c: f64,
    /// pole [kg]
    pub m_p: f64,
    /// half the pole's length [m]
    pub l: f64,
    /// g [m/s^2]
    pub g: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m_c: 1.0,
        m_p: 0.1,
        l: 0.5,
        g: 9.8,
    };

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [m_c, m_p, l, g] = values;
        Self { m_c, m_p, l, g }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.m_c, self.m_p, self.l, self.g]
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
    /// cart [m]
    pub x: f64,
    /// pole [rad]
    pub theta: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [x, theta] = values;
        Self { x, theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.x, self.theta]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// cart [m/s]
    pub x: f64,
    /// pole [rad/s]
    pub theta: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [x, theta] = values;
        Self { x, theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.x, self.theta]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// cart [m/s^2]
    pub x: f64,
    /// pole [rad/s^2]
    pub theta: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [x, theta] = values;
        Self { x, theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.x, self.theta]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// F [N]
    pub F: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 1]) -> Self {
        let [F] = values;
        Self { F }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 1] {
        [self.F]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// x [m]
    pub x: f64,
    /// theta [rad]
    pub theta: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [x, theta] = values;
        Self { x, theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.x, self.theta]
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
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [x0, x1, x2, x3] = values;
        Self {
            q: Coordinates::from_array([x0, x1]),
            v: Rates::from_array([x2, x3]),
        }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        let [x0, x1] = self.q.to_array();
        let [x2, x3] = self.v.to_array();
        [x0, x1, x2, x3]
    }
}

/// Mass matrix M(q), 2 x 2, symmetric; rows (x, theta).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 2]; 2] {
    let c_theta = cos(q.theta);
    let J = p.m_p * p.l * p.l / 3.0;
    // body rod on pole
    let mc_pole_z = p.m_p * p.l;
    // frame pole on rail
    let M_x_theta = mc_pole_z * c_theta;
    [[p.m_c + p.m_p, M_x_theta], [M_x_theta, J + p.l * mc_pole_z]]
}

/// Bias h(q, v) [N, N m]: velocity products + gravity + springs; rows (x, theta).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_theta, c_theta) = sin_cos(q.theta);
    // body rod on pole
    let mc_pole_z = p.m_p * p.l;
    // frame pole on rail
    let a_pole_x = -p.g * s_theta;
    let f_pole_z = p.m_p * p.g * c_theta - mc_pole_z * v.theta * v.theta;
    let f_rail_x = f_pole_z * s_theta + p.m_p * a_pole_x * c_theta;
    [f_rail_x, mc_pole_z * a_pole_x]
}

/// Velocity products C(q, v) v [N, N m]: Coriolis and centrifugal terms; rows (x, theta).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let s_theta = sin(q.theta);
    // frame pole on rail
    let f_moving_pole_z = -p.m_p * p.l * v.theta * v.theta;
    [f_moving_pole_z * s_theta, 0.0]
}

/// Generalized gravity g(q) [N, N m]: what holds the rig still; rows (x, theta).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 2] {
    let s_theta = sin(q.theta);
    let g_theta = -p.m_p * p.l * p.g * s_theta;
    [0.0, g_theta]
}

/// Friction and dampers d(q, v) [N, N m], on the left-hand side; rows (x, theta).
#[must_use]
pub fn dissipation(_q: &Coordinates, _v: &Rates, _p: &Parameters) -> [f64; 2] {
    [0.0, 0.0]
}

/// Generalized force Q [N, N m] of the inputs; rows (x, theta).
#[must_use]
pub fn generalized_force(_q: &Coordinates, u: &Inputs, _p: &Parameters) -> [f64; 2] {
    [u.F, 0.0]
}

/// Input map dQ/du, 2 x 1; rows (x, theta), columns (F).
#[must_use]
pub fn input_map(_q: &Coordinates, _p: &Parameters) -> [[f64; 1]; 2] {
    [[1.0], [0.0]]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_theta, c_theta) = sin_cos(q.theta);
    let J = p.m_p * p.l * p.l / 3.0;
    let s_theta_x_dot = s_theta * v.x;
    // body rod on pole
    let rod_1 = c_theta * v.x + p.l * v.theta;
    let rod_2 = p.m_p * (rod_1 * rod_1 + s_theta_x_dot * s_theta_x_dot);
    0.5 * p.m_c * v.x * v.x + 0.5 * (rod_2 + J * v.theta * v.theta)
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let c_theta = cos(q.theta);
    p.m_p * p.l * p.g * c_theta
}

/// Inverse dynamics M a + h + d - Q [N, N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 2] {
    let State { q, v } = x;
    let (s_theta, c_theta) = sin_cos(q.theta);
    let J = p.m_p * p.l * p.l / 3.0;
    // body rod on pole
    let mc_pole_z = p.m_p * p.l;
    // frame pole on rail
    let a_pole_z = p.g * c_theta + s_theta * a.x;
    let a_pole_x = c_theta * a.x - p.g * s_theta;
    let f_net_pole_x = p.m_p * a_pole_x + mc_pole_z * a.theta;
    let f_net_pole_z = p.m_p * a_pole_z - mc_pole_z * v.theta * v.theta;
    let n_net_pole_y = a.theta * (J + p.l * mc_pole_z) + mc_pole_z * a_pole_x;
    // frame rail on ground
    let f_net_rail_x = p.m_c * a.x + f_net_pole_z * s_theta + f_net_pole_x * c_theta;
    [f_net_rail_x - u.F, n_net_pole_y]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.x, q.theta])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 2] {
    let State { q, .. } = x;
    let c_theta = cos(q.theta);
    let J = p.m_p * p.l * p.l / 3.0;
    // body rod on pole
    let mc_pole_z = p.m_p * p.l;
    let I_pole_xx = J + p.l * mc_pole_z;
    // frame pole on rail
    let M_x_theta = mc_pole_z * c_theta;
    // M = L^T D L and back-substitution
    let pivot_x = p.m_c + p.m_p - M_x_theta * M_x_theta / I_pole_xx;
    [pivot_x, I_pole_xx]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 33 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_theta, c_theta) = sin_cos(q.theta);
    let J = p.m_p * p.l * p.l / 3.0;
    // body rod on pole
    let mc_pole_z = p.m_p * p.l;
    let I_pole_xx = J + p.l * mc_pole_z;
    // frame pole on rail
    let a_pole_x = -p.g * s_theta;
    let n_weight_pole_y = mc_pole_z * a_pole_x;
    let f_pole_z = p.m_p * p.g * c_theta - mc_pole_z * v.theta * v.theta;
    let f_rail_x = f_pole_z * s_theta + p.m_p * a_pole_x * c_theta;
    let M_x_theta = mc_pole_z * c_theta;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / I_pole_xx;
    let l_theta_x = M_x_theta * inv_theta;
    let pivot_x = p.m_c + p.m_p - M_x_theta * l_theta_x;
    let x_ddot = (u.F - f_rail_x + n_weight_pole_y * l_theta_x) / pivot_x;
    let theta_ddot = -n_weight_pole_y * inv_theta - l_theta_x * x_ddot;
    positive(I_pole_xx, 1)?;
    positive(pivot_x, 0)?;
    Ok(Accelerations::from_array([x_ddot, theta_ddot]))
}

/// x' and its Jacobians at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// x'.
    pub dx: [f64; 4],
    /// A = dx'/dx, 4 x 4.
    pub a: [[f64; 4]; 4],
    /// B = dx'/du, 4 x 1.
    pub b: [[f64; 1]; 4],
}

/// State derivative and its Jacobians A, B, exact, at any state.
/// 64 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///          x theta x.dot theta.dot | F
/// x'       . .     1     .         | .
/// theta'   . .     .     1         | .
/// x''      . *     .     *         | *
/// theta''  . *     .     *         | *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_theta, c_theta) = sin_cos(q.theta);
    let J = p.m_p * p.l * p.l / 3.0;
    // body rod on pole
    let mc_pole_z = p.m_p * p.l;
    let I_pole_xx = J + p.l * mc_pole_z;
    // frame pole on rail
    let f_moving_pole_z = -mc_pole_z * v.theta * v.theta;
    let a_pole_z = p.g * c_theta;
    let a_pole_x = -p.g * s_theta;
    let n_weight_pole_y = mc_pole_z * a_pole_x;
    let f_rail_x = s_theta * (p.m_p * a_pole_z + f_moving_pole_z) + p.m_p * a_pole_x * c_theta;
    let M_x_theta = mc_pole_z * c_theta;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / I_pole_xx;
    let l_theta_x = M_x_theta * inv_theta;
    let pivot_x = p.m_c + p.m_p - M_x_theta * l_theta_x;
    let inv_x = 1.0 / pivot_x;
    let x_ddot = inv_x * (u.F - f_rail_x + n_weight_pole_y * l_theta_x);
    let theta_ddot = -n_weight_pole_y * inv_theta - l_theta_x * x_ddot;
    let a_pole_z_plus_x_ddot_s_theta = a_pole_z + x_ddot * s_theta;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = p.m_p * (x_ddot * c_theta + a_pole_x);
    let slopes_2 = p.m_p * a_pole_z_plus_x_ddot_s_theta;
    let slopes_3 = c_theta * (slopes_2 + f_moving_pole_z);
    let slopes_4 = s_theta * (slopes_1 + mc_pole_z * theta_ddot);
    let slopes_5 = mc_pole_z * a_pole_z_plus_x_ddot_s_theta;
    let slopes_6 = slopes_3 + slopes_1 * s_theta;
    // derivatives with respect to theta
    let by_theta_1 = slopes_4 + slopes_2 * c_theta - slopes_6;
    let d_x_ddot_by_theta = inv_x * (by_theta_1 - l_theta_x * slopes_5);
    let d_theta_ddot_by_theta = inv_theta * slopes_5 - l_theta_x * d_x_ddot_by_theta;
    // derivatives with respect to theta_dot
    let d_x_ddot_by_theta_dot = 2.0 * inv_x * mc_pole_z * s_theta * v.theta;
    positive(I_pole_xx, 1)?;
    positive(pivot_x, 0)?;
    Ok(Linearization {
        dx: [v.x, v.theta, x_ddot, theta_ddot],
        a: [
            [0.0, 0.0, 1.0, 0.0], // x'
            [0.0, 0.0, 0.0, 1.0], // theta'
            [0.0, d_x_ddot_by_theta, 0.0, d_x_ddot_by_theta_dot], // x''
            [0.0, d_theta_ddot_by_theta, 0.0, -l_theta_x * d_x_ddot_by_theta_dot], // theta''
        ],
        b: [[0.0], [0.0], [inv_x], [-l_theta_x * inv_x]],
    })
}

/// Parameter Jacobian dx'/dp, 4 x 4; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 4]; 4], Singular> {
    let State { q, v } = x;
    let (s_theta, c_theta) = sin_cos(q.theta);
    let l_sq = p.l * p.l;
    // body rod on pole
    let mc_pole_z = p.m_p * p.l;
    let I_pole_xx = p.m_p * l_sq / 3.0 + p.l * mc_pole_z;
    let theta_dot_sq = v.theta * v.theta;
    // frame pole on rail
    let a_pole_z = p.g * c_theta;
    let a_pole_x = -p.g * s_theta;
    let n_weight_pole_y = mc_pole_z * a_pole_x;
    let f_pole_z = p.m_p * a_pole_z - mc_pole_z * theta_dot_sq;
    let f_rail_x = f_pole_z * s_theta + p.m_p * a_pole_x * c_theta;
    let mc_pole_z_s_theta = mc_pole_z * s_theta;
    let M_x_theta = mc_pole_z * c_theta;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / I_pole_xx;
    let l_theta_x = M_x_theta * inv_theta;
    let pivot_x = p.m_c + p.m_p - M_x_theta * l_theta_x;
    let inv_x = 1.0 / pivot_x;
    let x_ddot = inv_x * (u.F - f_rail_x + n_weight_pole_y * l_theta_x);
    let theta_ddot = -n_weight_pole_y * inv_theta - l_theta_x * x_ddot;
    let x_ddot_c_theta_plus_a_pole_x = x_ddot * c_theta + a_pole_x;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = theta_ddot * (l_sq + l_sq / 3.0) + p.l * x_ddot_c_theta_plus_a_pole_x;
    let slopes_2 = s_theta * (a_pole_z + x_ddot * s_theta - p.l * theta_dot_sq);
    let slopes_3 = slopes_2 + c_theta * (x_ddot_c_theta_plus_a_pole_x + p.l * theta_ddot);
    let slopes_4 = p.m_p * x_ddot_c_theta_plus_a_pole_x + theta_ddot * (2.0 * p.m_p * p.l / 3.0 + 2.0 * mc_pole_z);
    // derivatives with respect to m_c
    let d_x_ddot_by_m_c = -inv_x * x_ddot;
    // derivatives with respect to m_p
    let d_x_ddot_by_m_p = inv_x * (l_theta_x * slopes_1 - slopes_3);
    let d_theta_ddot_by_m_p = -inv_theta * slopes_1 - l_theta_x * d_x_ddot_by_m_p;
    // derivatives with respect to l
    let by_l_1 = p.m_p * theta_dot_sq * s_theta - p.m_p * theta_ddot * c_theta;
    let d_x_ddot_by_l = inv_x * (by_l_1 + l_theta_x * slopes_4);
    let d_theta_ddot_by_l = -inv_theta * slopes_4 - l_theta_x * d_x_ddot_by_l;
    // derivatives with respect to g
    let by_g_1 = p.m_p * c_theta * s_theta - p.m_p * s_theta * c_theta;
    let d_x_ddot_by_g = inv_x * (by_g_1 - mc_pole_z_s_theta * l_theta_x);
    let d_theta_ddot_by_g = mc_pole_z_s_theta * inv_theta - l_theta_x * d_x_ddot_by_g;
    positive(I_pole_xx, 1)?;
    positive(pivot_x, 0)?;
    Ok([
        [0.0; 4], // x'
        [0.0; 4], // theta'
        // x''
        Parameters {
            m_c: d_x_ddot_by_m_c,
            m_p: d_x_ddot_by_m_p,
            l: d_x_ddot_by_l,
            g: d_x_ddot_by_g,
        }
        .to_array(),
        // theta''
        Parameters {
            m_c: -l_theta_x * d_x_ddot_by_m_c,
            m_p: d_theta_ddot_by_m_p,
            l: d_theta_ddot_by_l,
            g: d_theta_ddot_by_g,
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 2 x 4.
    pub by_x: [[f64; 4]; 2],
    /// dy/dp, 2 x 4.
    pub by_p: [[f64; 4]; 2],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]],
        by_p: [
            [0.0; 4], // x
            [0.0; 4], // theta
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 4] = ["x", "theta", "x.dot", "theta.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 1] = ["F"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 4] = ["m_c", "m_p", "l", "g"];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 4] = ["kg", "kg", "m", "m/s^2"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 2] = ["x", "theta"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 2] = ["m", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CartPole;

impl Names for CartPole {
    fn rig(&self) -> &str {
        "CartPole"
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

impl Model for CartPole {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 2, lags: 0, inputs: 1, exogenous: 0, parameters: 4, outputs: 2 }
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
        runtime::write(dx, 2, &a.to_array());
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
        runtime::write(d, 1, &[pivots[1]]);
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
            1 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            _ => OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false },
        }
    }
}
