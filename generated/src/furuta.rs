//! Furuta pendulum (QUBE-Servo 2).
//! Generated from `furuta.rig` (model 060d2e34); edit the rig, not this file.
//!
//! Uniform thin rods as in Quanser's QUBE-Servo 2 data sheet, motor rotor and hub on the arm's axis.
//! alpha = 0 hangs down; theta about the upright axis, alpha about the arm.
//!
//! 69 operations forward, 160 with A and B.
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
    /// arm [kg]
    pub m_r: f64,
    /// arm's length [m]
    pub r: f64,
    /// pendulum [kg]
    pub m_p: f64,
    /// pendulum's length [m]
    pub L_p: f64,
    /// motor rotor [kg*m^2]
    pub J_m: f64,
    /// hub [kg*m^2]
    pub J_h: f64,
    /// g [m/s^2]
    pub g: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m_r: 0.095,
        r: 0.085,
        m_p: 0.024,
        L_p: 0.129,
        J_m: 4e-6,
        J_h: 6e-7,
        g: 9.81,
    };

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 7]) -> Self {
        let [m_r, r, m_p, L_p, J_m, J_h, g] = values;
        Self { m_r, r, m_p, L_p, J_m, J_h, g }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 7] {
        [self.m_r, self.r, self.m_p, self.L_p, self.J_m, self.J_h, self.g]
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
    /// arm [rad]
    pub theta: f64,
    /// pendulum, 0 hanging [rad]
    pub alpha: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [theta, alpha] = values;
        Self { theta, alpha }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.theta, self.alpha]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// arm [rad/s]
    pub theta: f64,
    /// pendulum, 0 hanging [rad/s]
    pub alpha: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [theta, alpha] = values;
        Self { theta, alpha }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.theta, self.alpha]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// arm [rad/s^2]
    pub theta: f64,
    /// pendulum, 0 hanging [rad/s^2]
    pub alpha: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [theta, alpha] = values;
        Self { theta, alpha }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.theta, self.alpha]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// tau [N*m]
    pub tau: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 1]) -> Self {
        let [tau] = values;
        Self { tau }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 1] {
        [self.tau]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// theta [rad]
    pub theta: f64,
    /// alpha [rad]
    pub alpha: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [theta, alpha] = values;
        Self { theta, alpha }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.theta, self.alpha]
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

/// Mass matrix M(q), 2 x 2, symmetric; rows (theta, alpha).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 2]; 2] {
    let c_alpha = cos(q.alpha);
    let J_r = p.m_r * p.r * p.r / 12.0;
    let J_p = p.m_p * p.L_p * p.L_p / 12.0;
    let r_per_two = p.r / 2.0;
    // body arm_rod on arm
    let I_arm_yy = J_r + p.m_r * r_per_two * r_per_two;
    let L_p_per_two = p.L_p / 2.0;
    // body rod on pendulum
    let mc_pendulum_z = -p.m_p * L_p_per_two;
    let I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    // frame pendulum on arm
    let M_theta_alpha = -p.r * mc_pendulum_z * c_alpha;
    // frame arm on ground
    let arm_1 = I_arm_yy + I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p.r * p.r * p.m_p;
    [[arm_1 + p.J_m + p.J_h, M_theta_alpha], [M_theta_alpha, I_pendulum_xx]]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (theta, alpha).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_alpha, c_alpha) = sin_cos(q.alpha);
    let J_p = p.m_p * p.L_p * p.L_p / 12.0;
    let L_p_per_two = p.L_p / 2.0;
    // body rod on pendulum
    let mc_pendulum_z = -p.m_p * L_p_per_two;
    let I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    // frame pendulum on arm
    let omega_pendulum_y = s_alpha * v.theta;
    let omega_pendulum_z = c_alpha * v.theta;
    let pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    let f_moving_pendulum_z = -mc_pendulum_z * (v.alpha * v.alpha + omega_pendulum_y * omega_pendulum_y);
    let n_moving_pendulum_y = 2.0 * I_pendulum_xx * omega_pendulum_z * v.alpha - p.r * mc_pendulum_z * v.theta * v.theta;
    let a_pendulum_y = p.g * s_alpha;
    let f_pendulum_y = p.m_p * a_pendulum_y + mc_pendulum_z * pendulum_1;
    let f_pendulum_z = f_moving_pendulum_z + p.m_p * p.g * c_alpha;
    let n_pendulum_x = -mc_pendulum_z * a_pendulum_y - I_pendulum_xx * pendulum_1;
    let f_pendulum_1_y = f_pendulum_y * c_alpha - f_pendulum_z * s_alpha;
    let n_arm_z = n_moving_pendulum_y * s_alpha + p.r * f_pendulum_1_y;
    [n_arm_z, n_pendulum_x]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (theta, alpha).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_alpha, c_alpha) = sin_cos(q.alpha);
    let J_p = p.m_p * p.L_p * p.L_p / 12.0;
    let L_p_per_two = p.L_p / 2.0;
    // body rod on pendulum
    let mc_pendulum_z = -p.m_p * L_p_per_two;
    let I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    // frame pendulum on arm
    let omega_pendulum_y = s_alpha * v.theta;
    let omega_pendulum_z = c_alpha * v.theta;
    let pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    let f_moving_pendulum_z = -mc_pendulum_z * (v.alpha * v.alpha + omega_pendulum_y * omega_pendulum_y);
    let n_moving_pendulum_y = 2.0 * I_pendulum_xx * omega_pendulum_z * v.alpha - p.r * mc_pendulum_z * v.theta * v.theta;
    let f_moving_pendulum_1_y = mc_pendulum_z * pendulum_1 * c_alpha - f_moving_pendulum_z * s_alpha;
    let n_moving_arm_z = n_moving_pendulum_y * s_alpha + p.r * f_moving_pendulum_1_y;
    [n_moving_arm_z, -I_pendulum_xx * pendulum_1]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (theta, alpha).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 2] {
    let s_alpha = sin(q.alpha);
    let g_alpha = p.m_p * p.L_p * p.g * s_alpha / 2.0;
    [0.0, g_alpha]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (theta, alpha).
#[must_use]
pub fn dissipation(_q: &Coordinates, _v: &Rates, _p: &Parameters) -> [f64; 2] {
    [0.0, 0.0]
}

/// Generalized force Q [N m] of the inputs; rows (theta, alpha).
#[must_use]
pub fn generalized_force(_q: &Coordinates, u: &Inputs, _p: &Parameters) -> [f64; 2] {
    [u.tau, 0.0]
}

/// Input map dQ/du, 2 x 1; rows (theta, alpha), columns (tau).
#[must_use]
pub fn input_map(_q: &Coordinates, _p: &Parameters) -> [[f64; 1]; 2] {
    [[1.0], [0.0]]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_alpha, c_alpha) = sin_cos(q.alpha);
    let J_r = p.m_r * p.r * p.r / 12.0;
    let J_p = p.m_p * p.L_p * p.L_p / 12.0;
    let L_p_per_two = p.L_p / 2.0;
    // frame pendulum on arm
    let omega_pendulum_y = s_alpha * v.theta;
    let r_theta_dot = p.r * v.theta;
    let r_theta_dot_s_alpha = r_theta_dot * s_alpha;
    let r_per_two_theta_dot = p.r * v.theta / 2.0;
    // body arm_rod on arm
    let arm_rod_1 = 0.5 * (p.m_r * r_per_two_theta_dot * r_per_two_theta_dot + J_r * v.theta * v.theta);
    let L_p_per_two_omega_pendulum_y = L_p_per_two * omega_pendulum_y;
    // body rod on pendulum
    let rod_1 = r_theta_dot * c_alpha + L_p_per_two * v.alpha;
    let rod_2 = L_p_per_two_omega_pendulum_y * L_p_per_two_omega_pendulum_y + rod_1 * rod_1;
    let rod_3 = p.m_p * (r_theta_dot_s_alpha * r_theta_dot_s_alpha + rod_2);
    let rod_4 = 0.5 * (rod_3 + J_p * v.alpha * v.alpha + omega_pendulum_y * J_p * omega_pendulum_y);
    0.5 * v.theta * v.theta * (p.J_m + p.J_h) + arm_rod_1 + rod_4
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let c_alpha = cos(q.alpha);
    -p.m_p * p.L_p * p.g * c_alpha / 2.0
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 2] {
    let State { q, v } = x;
    let (s_alpha, c_alpha) = sin_cos(q.alpha);
    let J_r = p.m_r * p.r * p.r / 12.0;
    let J_p = p.m_p * p.L_p * p.L_p / 12.0;
    let r_per_two = p.r / 2.0;
    // body arm_rod on arm
    let I_arm_yy = J_r + p.m_r * r_per_two * r_per_two;
    let L_p_per_two = p.L_p / 2.0;
    // body rod on pendulum
    let mc_pendulum_z = -p.m_p * L_p_per_two;
    let I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    // frame pendulum on arm
    let omega_pendulum_y = s_alpha * v.theta;
    let omega_pendulum_z = c_alpha * v.theta;
    let alpha_pendulum_y = omega_pendulum_z * v.alpha;
    let pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    let f_moving_pendulum_z = -mc_pendulum_z * (v.alpha * v.alpha + omega_pendulum_y * omega_pendulum_y);
    let pendulum_2 = I_pendulum_xx * alpha_pendulum_y + I_pendulum_xx * (alpha_pendulum_y + s_alpha * a.theta);
    let n_net_pendulum_y = pendulum_2 - p.r * mc_pendulum_z * v.theta * v.theta;
    // gravity
    let a_pendulum_1_y = p.r * a.theta;
    // frame pendulum on arm
    let a_pendulum_y = p.g * s_alpha + a_pendulum_1_y * c_alpha;
    let a_pendulum_z = p.g * c_alpha - a_pendulum_1_y * s_alpha;
    let f_net_pendulum_y = p.m_p * a_pendulum_y + mc_pendulum_z * (pendulum_1 - a.alpha);
    let n_net_pendulum_x = I_pendulum_xx * a.alpha - mc_pendulum_z * a_pendulum_y - I_pendulum_xx * pendulum_1;
    let pendulum_3 = s_alpha * (f_moving_pendulum_z + p.m_p * a_pendulum_z);
    let pendulum_1_1 = p.r * (f_net_pendulum_y * c_alpha - pendulum_3);
    // frame arm on ground
    let n_net_arm_z = I_arm_yy * a.theta + n_net_pendulum_y * s_alpha + pendulum_1_1;
    [n_net_arm_z - u.tau + a.theta * (p.J_m + p.J_h), n_net_pendulum_x]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.theta, q.alpha])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 2] {
    let State { q, .. } = x;
    let c_alpha = cos(q.alpha);
    let J_r = p.m_r * p.r * p.r / 12.0;
    let J_p = p.m_p * p.L_p * p.L_p / 12.0;
    let r_per_two = p.r / 2.0;
    // body arm_rod on arm
    let I_arm_yy = J_r + p.m_r * r_per_two * r_per_two;
    let L_p_per_two = p.L_p / 2.0;
    // body rod on pendulum
    let mc_pendulum_z = -p.m_p * L_p_per_two;
    let I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    // frame pendulum on arm
    let M_theta_alpha = -p.r * mc_pendulum_z * c_alpha;
    // frame arm on ground
    let arm_1 = I_arm_yy + I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p.r * p.r * p.m_p;
    // M = L^T D L and back-substitution
    let pivot_theta = arm_1 + p.J_m + p.J_h - M_theta_alpha * M_theta_alpha / I_pendulum_xx;
    [pivot_theta, I_pendulum_xx]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 69 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_alpha, c_alpha) = sin_cos(q.alpha);
    let J_r = p.m_r * p.r * p.r / 12.0;
    let J_p = p.m_p * p.L_p * p.L_p / 12.0;
    let r_per_two = p.r / 2.0;
    // body arm_rod on arm
    let I_arm_yy = J_r + p.m_r * r_per_two * r_per_two;
    let L_p_per_two = p.L_p / 2.0;
    // body rod on pendulum
    let mc_pendulum_z = -p.m_p * L_p_per_two;
    let I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    // frame pendulum on arm
    let omega_pendulum_y = s_alpha * v.theta;
    let omega_pendulum_z = c_alpha * v.theta;
    let pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    let f_moving_pendulum_z = -mc_pendulum_z * (v.alpha * v.alpha + omega_pendulum_y * omega_pendulum_y);
    let n_moving_pendulum_y = 2.0 * I_pendulum_xx * omega_pendulum_z * v.alpha - p.r * mc_pendulum_z * v.theta * v.theta;
    let a_pendulum_y = p.g * s_alpha;
    let f_pendulum_y = p.m_p * a_pendulum_y + mc_pendulum_z * pendulum_1;
    let f_pendulum_z = f_moving_pendulum_z + p.m_p * p.g * c_alpha;
    let f_pendulum_1_y = f_pendulum_y * c_alpha - f_pendulum_z * s_alpha;
    let M_theta_alpha = -p.r * mc_pendulum_z * c_alpha;
    let n_arm_z = n_moving_pendulum_y * s_alpha + p.r * f_pendulum_1_y;
    // frame arm on ground
    let arm_1 = I_arm_yy + I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p.r * p.r * p.m_p;
    // balance of forces
    let tau_alpha = I_pendulum_xx * pendulum_1 + mc_pendulum_z * a_pendulum_y;
    // M = L^T D L and back-substitution
    let inv_alpha = 1.0 / I_pendulum_xx;
    let l_alpha_theta = M_theta_alpha * inv_alpha;
    let pivot_theta = arm_1 + p.J_m + p.J_h - M_theta_alpha * l_alpha_theta;
    let theta_ddot = (u.tau - n_arm_z - tau_alpha * l_alpha_theta) / pivot_theta;
    let alpha_ddot = tau_alpha * inv_alpha - l_alpha_theta * theta_ddot;
    positive(I_pendulum_xx, 1)?;
    positive(pivot_theta, 0)?;
    Ok(Accelerations::from_array([theta_ddot, alpha_ddot]))
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
/// 160 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///          theta alpha theta.dot alpha.dot | tau
/// theta'   .     .     1         .         | .
/// alpha'   .     .     .         1         | .
/// theta''  .     *     *         *         | *
/// alpha''  .     *     *         *         | *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_alpha, c_alpha) = sin_cos(q.alpha);
    let J_r = p.m_r * p.r * p.r / 12.0;
    let J_p = p.m_p * p.L_p * p.L_p / 12.0;
    let r_per_two = p.r / 2.0;
    // body arm_rod on arm
    let I_arm_yy = J_r + p.m_r * r_per_two * r_per_two;
    let L_p_per_two = p.L_p / 2.0;
    // body rod on pendulum
    let mc_pendulum_z = -p.m_p * L_p_per_two;
    let I_pendulum_xx = J_p - L_p_per_two * mc_pendulum_z;
    // frame pendulum on arm
    let omega_pendulum_y = s_alpha * v.theta;
    let omega_pendulum_z = c_alpha * v.theta;
    let alpha_pendulum_y = omega_pendulum_z * v.alpha;
    let alpha_pendulum_z = -omega_pendulum_y * v.alpha;
    let pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    let omega_pendulum_y_sq = omega_pendulum_y * omega_pendulum_y;
    let f_moving_pendulum_z = -mc_pendulum_z * (v.alpha * v.alpha + omega_pendulum_y_sq);
    let pendulum_2 = I_pendulum_xx * alpha_pendulum_y;
    let r_mc_pendulum_z_theta_dot_sq = p.r * mc_pendulum_z * v.theta * v.theta;
    let n_moving_pendulum_1_z = s_alpha * (2.0 * pendulum_2 - r_mc_pendulum_z_theta_dot_sq);
    let a_pendulum_y = p.g * s_alpha;
    let a_pendulum_z = p.g * c_alpha;
    let f_pendulum_y = p.m_p * a_pendulum_y + mc_pendulum_z * pendulum_1;
    let f_pendulum_1_y = f_pendulum_y * c_alpha - s_alpha * (f_moving_pendulum_z + p.m_p * a_pendulum_z);
    let M_theta_alpha = -p.r * mc_pendulum_z * c_alpha;
    // frame arm on ground
    let arm_1 = I_arm_yy + I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p.r * p.r * p.m_p;
    // balance of forces
    let tau_theta = u.tau - n_moving_pendulum_1_z - p.r * f_pendulum_1_y;
    let tau_alpha = I_pendulum_xx * pendulum_1 + mc_pendulum_z * a_pendulum_y;
    // M = L^T D L and back-substitution
    let inv_alpha = 1.0 / I_pendulum_xx;
    let l_alpha_theta = M_theta_alpha * inv_alpha;
    let pivot_theta = arm_1 + p.J_m + p.J_h - M_theta_alpha * l_alpha_theta;
    let inv_theta = 1.0 / pivot_theta;
    let theta_ddot = inv_theta * (tau_theta - tau_alpha * l_alpha_theta);
    let alpha_ddot = tau_alpha * inv_alpha - l_alpha_theta * theta_ddot;
    // derivatives with respect to alpha
    let by_alpha_1 = omega_pendulum_z * omega_pendulum_z - omega_pendulum_y_sq;
    let two_omega_pendulum_y = 2.0 * omega_pendulum_y;
    // derivatives with respect to theta_dot
    let by_theta_dot_1 = omega_pendulum_z * s_alpha + omega_pendulum_y * c_alpha;
    let I_pendulum_xx_by_theta_dot_1 = I_pendulum_xx * by_theta_dot_1;
    let by_theta_dot_2 = 2.0 * I_pendulum_xx * c_alpha * v.alpha - 2.0 * p.r * mc_pendulum_z * v.theta;
    let by_theta_dot_3 = mc_pendulum_z * two_omega_pendulum_y * s_alpha * s_alpha;
    let by_theta_dot_4 = p.r * (-mc_pendulum_z * by_theta_dot_1 * c_alpha - by_theta_dot_3);
    let by_theta_dot_5 = by_theta_dot_4 - by_theta_dot_2 * s_alpha - l_alpha_theta * I_pendulum_xx_by_theta_dot_1;
    let d_theta_ddot_by_theta_dot = inv_theta * by_theta_dot_5;
    let d_alpha_ddot_by_theta_dot = inv_alpha * I_pendulum_xx_by_theta_dot_1 - l_alpha_theta * d_theta_ddot_by_theta_dot;
    // derivatives with respect to alpha_dot
    let by_alpha_dot_1 = 2.0 * I_pendulum_xx * omega_pendulum_z * s_alpha;
    let d_theta_ddot_by_alpha_dot = inv_theta * (-2.0 * p.r * mc_pendulum_z * s_alpha * v.alpha - by_alpha_dot_1);
    let r_theta_ddot = p.r * theta_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = a_pendulum_z - r_theta_ddot * s_alpha;
    let slopes_2 = p.m_p * (a_pendulum_y + r_theta_ddot * c_alpha);
    let m_p_slopes_1 = p.m_p * slopes_1;
    let slopes_3 = pendulum_2 + I_pendulum_xx * (alpha_pendulum_y + theta_ddot * s_alpha);
    let slopes_4 = s_alpha * (slopes_2 + mc_pendulum_z * (pendulum_1 - alpha_ddot));
    let slopes_5 = c_alpha * (slopes_3 - r_mc_pendulum_z_theta_dot_sq);
    let slopes_6 = I_pendulum_xx * (theta_ddot * c_alpha + alpha_pendulum_z) + I_pendulum_xx * alpha_pendulum_z;
    let slopes_7 = c_alpha * (m_p_slopes_1 + mc_pendulum_z * by_alpha_1);
    let slopes_8 = s_alpha * (-mc_pendulum_z * omega_pendulum_z * two_omega_pendulum_y - slopes_2);
    let slopes_9 = c_alpha * (f_moving_pendulum_z + m_p_slopes_1) + slopes_8;
    let slopes_10 = p.r * (slopes_7 - slopes_4 - slopes_9);
    let slopes_11 = slopes_5 + slopes_6 * s_alpha + slopes_10;
    // derivatives with respect to alpha
    let by_alpha_2 = I_pendulum_xx * by_alpha_1 + mc_pendulum_z * slopes_1;
    let d_theta_ddot_by_alpha = -inv_theta * (slopes_11 + l_alpha_theta * by_alpha_2);
    let d_alpha_ddot_by_alpha = inv_alpha * by_alpha_2 - l_alpha_theta * d_theta_ddot_by_alpha;
    positive(I_pendulum_xx, 1)?;
    positive(pivot_theta, 0)?;
    Ok(Linearization {
        dx: [v.theta, v.alpha, theta_ddot, alpha_ddot],
        a: [
            [0.0, 0.0, 1.0, 0.0], // theta'
            [0.0, 0.0, 0.0, 1.0], // alpha'
            [0.0, d_theta_ddot_by_alpha, d_theta_ddot_by_theta_dot, d_theta_ddot_by_alpha_dot], // theta''
            [0.0, d_alpha_ddot_by_alpha, d_alpha_ddot_by_theta_dot, -l_alpha_theta * d_theta_ddot_by_alpha_dot], // alpha''
        ],
        b: [[0.0], [0.0], [inv_theta], [-l_alpha_theta * inv_theta]],
    })
}

/// Parameter Jacobian dx'/dp, 4 x 7; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 7]; 4], Singular> {
    let State { q, v } = x;
    let (s_alpha, c_alpha) = sin_cos(q.alpha);
    let r_sq = p.r * p.r;
    let L_p_sq = p.L_p * p.L_p;
    let r_per_two = p.r / 2.0;
    // body arm_rod on arm
    let mc_arm_x = p.m_r * r_per_two;
    let I_arm_yy = p.m_r * r_sq / 12.0 + r_per_two * mc_arm_x;
    let L_p_per_two = p.L_p / 2.0;
    // body rod on pendulum
    let mc_pendulum_z = -p.m_p * L_p_per_two;
    let I_pendulum_xx = p.m_p * L_p_sq / 12.0 - L_p_per_two * mc_pendulum_z;
    // frame pendulum on arm
    let omega_pendulum_y = s_alpha * v.theta;
    let omega_pendulum_z = c_alpha * v.theta;
    let alpha_pendulum_y = omega_pendulum_z * v.alpha;
    let pendulum_1 = omega_pendulum_y * omega_pendulum_z;
    let pendulum_2 = v.alpha * v.alpha + omega_pendulum_y * omega_pendulum_y;
    let f_moving_pendulum_z = -mc_pendulum_z * pendulum_2;
    let a_pendulum_y = p.g * s_alpha;
    let a_pendulum_z = p.g * c_alpha;
    let f_pendulum_y = p.m_p * a_pendulum_y + mc_pendulum_z * pendulum_1;
    let f_pendulum_1_y = f_pendulum_y * c_alpha - s_alpha * (f_moving_pendulum_z + p.m_p * a_pendulum_z);
    let mc_pendulum_z_s_alpha = mc_pendulum_z * s_alpha;
    let M_theta_alpha = -p.r * mc_pendulum_z * c_alpha;
    let theta_dot_sq = v.theta * v.theta;
    // frame arm on ground
    let arm_1 = I_arm_yy + I_pendulum_xx - I_pendulum_xx * c_alpha * c_alpha + p.r * p.r * p.m_p;
    // frame pendulum on arm
    let a_pendulum_1_x = -p.r * theta_dot_sq;
    let n_moving_pendulum_y = mc_pendulum_z * a_pendulum_1_x + 2.0 * I_pendulum_xx * alpha_pendulum_y;
    let n_arm_z = n_moving_pendulum_y * s_alpha + p.r * f_pendulum_1_y;
    // balance of forces
    let tau_alpha = I_pendulum_xx * pendulum_1 + mc_pendulum_z * a_pendulum_y;
    // M = L^T D L and back-substitution
    let inv_alpha = 1.0 / I_pendulum_xx;
    let l_alpha_theta = M_theta_alpha * inv_alpha;
    let pivot_theta = arm_1 + p.J_m + p.J_h - M_theta_alpha * l_alpha_theta;
    let inv_theta = 1.0 / pivot_theta;
    let theta_ddot = inv_theta * (u.tau - n_arm_z - tau_alpha * l_alpha_theta);
    let alpha_ddot = tau_alpha * inv_alpha - l_alpha_theta * theta_ddot;
    let theta_ddot_s_alpha = theta_ddot * s_alpha;
    let r_theta_ddot = p.r * theta_ddot;
    let theta_ddot_c_alpha = theta_ddot * c_alpha;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_pendulum_y + theta_ddot_s_alpha;
    let slopes_2 = a_pendulum_y + r_theta_ddot * c_alpha;
    let slopes_3 = a_pendulum_z - r_theta_ddot * s_alpha;
    let pendulum_1_minus_alpha_ddot = pendulum_1 - alpha_ddot;
    let slopes_4 = c_alpha * (p.m_p * slopes_2 + mc_pendulum_z * pendulum_1_minus_alpha_ddot);
    let slopes_5 = slopes_4 - s_alpha * (f_moving_pendulum_z + p.m_p * slopes_3);
    let slopes_6 = theta_ddot * (2.0 * p.m_r * p.r / 12.0 + 0.5 * mc_arm_x + 0.5 * p.m_r * r_per_two);
    let slopes_7 = mc_pendulum_z * theta_ddot_c_alpha;
    let slopes_8 = p.m_p * theta_ddot_c_alpha * c_alpha + p.m_p * theta_ddot_s_alpha * s_alpha;
    let slopes_9 = c_alpha * (slopes_2 - L_p_per_two * pendulum_1_minus_alpha_ddot);
    let slopes_10 = s_alpha * (slopes_3 + L_p_per_two * pendulum_2);
    // derivatives with respect to r
    let by_r_1 = mc_pendulum_z * theta_dot_sq * s_alpha;
    // derivatives with respect to m_p
    let by_m_p_1 = L_p_sq / 12.0 + L_p_per_two * L_p_per_two;
    let half_m_p = 0.5 * p.m_p;
    // derivatives with respect to L_p
    let by_L_p_1 = 2.0 * p.m_p * p.L_p / 12.0 - 0.5 * mc_pendulum_z + L_p_per_two * half_m_p;
    // derivatives with respect to g
    let by_g_1 = p.m_p * c_alpha * s_alpha - p.m_p * s_alpha * c_alpha;
    let d_theta_ddot_by_g = inv_theta * (-mc_pendulum_z_s_alpha * l_alpha_theta - p.r * by_g_1);
    let d_alpha_ddot_by_g = mc_pendulum_z_s_alpha * inv_alpha - l_alpha_theta * d_theta_ddot_by_g;
    // slopes of the balance of forces, at the accelerations found
    let slopes_11 = slopes_6 - by_r_1 + slopes_5 + p.r * slopes_8;
    let slopes_12 = alpha_ddot * by_m_p_1 - pendulum_1 * by_m_p_1;
    let slopes_13 = alpha_pendulum_y * by_m_p_1 + slopes_1 * by_m_p_1;
    let slopes_14 = L_p_per_two * slopes_2 + slopes_12;
    let slopes_15 = s_alpha * (slopes_13 - L_p_per_two * a_pendulum_1_x);
    let slopes_16 = slopes_15 + p.r * (slopes_9 - slopes_10);
    let slopes_17 = alpha_ddot * by_L_p_1 - pendulum_1 * by_L_p_1;
    let slopes_18 = alpha_pendulum_y * by_L_p_1 + slopes_1 * by_L_p_1;
    let slopes_19 = slopes_2 * half_m_p + slopes_17;
    let slopes_20 = pendulum_1_minus_alpha_ddot * half_m_p * c_alpha;
    let slopes_21 = s_alpha * (slopes_18 - a_pendulum_1_x * half_m_p);
    let slopes_22 = p.r * (pendulum_2 * half_m_p * s_alpha + slopes_20);
    // derivatives with respect to m_r
    let d_theta_ddot_by_m_r = -inv_theta * theta_ddot * (r_sq / 12.0 + r_per_two * r_per_two);
    // derivatives with respect to r
    let d_theta_ddot_by_r = inv_theta * (-l_alpha_theta * slopes_7 - slopes_11);
    let d_alpha_ddot_by_r = inv_alpha * slopes_7 - l_alpha_theta * d_theta_ddot_by_r;
    // derivatives with respect to m_p
    let d_theta_ddot_by_m_p = inv_theta * (l_alpha_theta * slopes_14 - slopes_16);
    let d_alpha_ddot_by_m_p = -inv_alpha * slopes_14 - l_alpha_theta * d_theta_ddot_by_m_p;
    // derivatives with respect to L_p
    let d_theta_ddot_by_L_p = inv_theta * (slopes_22 - slopes_21 + l_alpha_theta * slopes_19);
    let d_alpha_ddot_by_L_p = -inv_alpha * slopes_19 - l_alpha_theta * d_theta_ddot_by_L_p;
    // derivatives with respect to J_m
    let d_theta_ddot_by_J_m = -inv_theta * theta_ddot;
    let d_alpha_ddot_by_J_m = -l_alpha_theta * d_theta_ddot_by_J_m;
    positive(I_pendulum_xx, 1)?;
    positive(pivot_theta, 0)?;
    Ok([
        [0.0; 7], // theta'
        [0.0; 7], // alpha'
        // theta''
        Parameters {
            m_r: d_theta_ddot_by_m_r,
            r: d_theta_ddot_by_r,
            m_p: d_theta_ddot_by_m_p,
            L_p: d_theta_ddot_by_L_p,
            J_m: d_theta_ddot_by_J_m,
            J_h: d_theta_ddot_by_J_m,
            g: d_theta_ddot_by_g,
        }
        .to_array(),
        // alpha''
        Parameters {
            m_r: -l_alpha_theta * d_theta_ddot_by_m_r,
            r: d_alpha_ddot_by_r,
            m_p: d_alpha_ddot_by_m_p,
            L_p: d_alpha_ddot_by_L_p,
            J_m: d_alpha_ddot_by_J_m,
            J_h: d_alpha_ddot_by_J_m,
            g: d_alpha_ddot_by_g,
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 2 x 4.
    pub by_x: [[f64; 4]; 2],
    /// dy/dp, 2 x 7.
    pub by_p: [[f64; 7]; 2],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]],
        by_p: [
            [0.0; 7], // theta
            [0.0; 7], // alpha
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 4] = ["theta", "alpha", "theta.dot", "alpha.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 1] = ["tau"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 7] = ["m_r", "r", "m_p", "L_p", "J_m", "J_h", "g"];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 7] = ["kg", "m", "kg", "m", "kg*m^2", "kg*m^2", "m/s^2"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 2] = ["theta", "alpha"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 2] = ["rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Furuta;

impl Names for Furuta {
    fn rig(&self) -> &str {
        "Furuta"
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

impl Model for Furuta {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 2, lags: 0, inputs: 1, exogenous: 0, parameters: 7, outputs: 2 }
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
            0 => InputPath { limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0 },
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
