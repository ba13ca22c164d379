//! Googol GHP2002, single-rigid-body model.
//! Generated from `googol_srb.rig` (model 7ec63ed6); edit the rig, not this file.
//!
//! Eq. 1 to 5 of the seed paper: arm, counterweight and fuselage are one body on a ball joint, l_cd = 0,
//! friction and velocity products neglected. The mass matrix is T^T I T with T of eq. 2 and
//! I = diag(I_theta, I_eps, I_psi) in the body's axes (the first one is the pitch axis; the paper prints
//! the opposite order). Gravity has the sign that physics gives it; eq. 5 prints the other one.
//! Without l_cd there is no pitch stiffness, and at eps = +-90 deg the mass matrix is singular.
//!
//! Assumed: l_cd = 0; no velocity products; no friction.
//! 60 operations forward, 141 with A and B.
//! Derived twice before the assumptions, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::{cos, sin, sin_cos};
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular, positive};

/// Parameters p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// fuselage with both rotors [kg]
    pub m_h: f64,
    /// arm [kg]
    pub m_b: f64,
    /// counterweight [kg]
    pub m_c: f64,
    /// gravity [m/s^2]
    pub g: f64,
    /// elevation axis to pitch axis [m]
    pub l_oc: f64,
    /// elevation axis to counterweight [m]
    pub l_ob: f64,
    /// elevation axis to the arm's centre [m]
    pub l_oa: f64,
    /// pitch axis down to the fuselage [m]
    pub l_cd: f64,
    /// pitch axis to each rotor, sideways [m]
    pub l_df: f64,
    /// viscous friction of the column [N*m*s]
    pub c0_psi: f64,
    /// viscous friction of the elevation axis [N*m*s]
    pub c0_eps: f64,
    /// viscous friction of the pitch axis [N*m*s]
    pub c0_theta: f64,
    /// without friction and velocity products no rate of turn balances the thrust [kg*m^2]
    pub I_psi: f64,
    /// about the sideways axis [kg*m^2]
    pub I_eps: f64,
    /// about the arm [kg*m^2]
    pub I_theta: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m_h: 1.8,
        m_b: 0.67948,
        m_c: 3.433,
        g: 9.81,
        l_oc: 0.78,
        l_ob: 0.33,
        l_oa: 0.2296,
        l_cd: 0.1,
        l_df: 0.17,
        c0_psi: 0.4025,
        c0_eps: 0.0779,
        c0_theta: 0.00153,
        I_psi: 1.469,
        I_eps: 1.469,
        I_theta: 0.0319,
    };

    /// All zero: where derivatives with respect to the parameters start from.
    const ZERO: Self = Self::from_array([0.0; 15]);

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 15]) -> Self {
        let [m_h, m_b, m_c, g, l_oc, l_ob, l_oa, l_cd, l_df, c0_psi, c0_eps, c0_theta, I_psi, I_eps, I_theta] = values;
        Self { m_h, m_b, m_c, g, l_oc, l_ob, l_oa, l_cd, l_df, c0_psi, c0_eps, c0_theta, I_psi, I_eps, I_theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 15] {
        [
            self.m_h, self.m_b, self.m_c, self.g, self.l_oc, self.l_ob, self.l_oa, self.l_cd, self.l_df, self.c0_psi, self.c0_eps,
            self.c0_theta, self.I_psi, self.I_eps, self.I_theta,
        ]
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
    /// yaw (travel) [rad]
    pub psi: f64,
    /// elevation, up positive [rad]
    pub eps: f64,
    /// pitch [rad]
    pub theta: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [psi, eps, theta] = values;
        Self { psi, eps, theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.psi, self.eps, self.theta]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// yaw (travel) [rad/s]
    pub psi: f64,
    /// elevation, up positive [rad/s]
    pub eps: f64,
    /// pitch [rad/s]
    pub theta: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [psi, eps, theta] = values;
        Self { psi, eps, theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.psi, self.eps, self.theta]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// yaw (travel) [rad/s^2]
    pub psi: f64,
    /// elevation, up positive [rad/s^2]
    pub eps: f64,
    /// pitch [rad/s^2]
    pub theta: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [psi, eps, theta] = values;
        Self { psi, eps, theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.psi, self.eps, self.theta]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// thrust of the rotor at -y [N]
    pub f_1: f64,
    /// thrust of the rotor at +y [N]
    pub f_2: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [f_1, f_2] = values;
        Self { f_1, f_2 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.f_1, self.f_2]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// psi [rad]
    pub psi: f64,
    /// eps [rad]
    pub eps: f64,
    /// theta [rad]
    pub theta: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [psi, eps, theta] = values;
        Self { psi, eps, theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.psi, self.eps, self.theta]
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
    pub const fn from_array(values: [f64; 6]) -> Self {
        let [x0, x1, x2, x3, x4, x5] = values;
        Self {
            q: Coordinates::from_array([x0, x1, x2]),
            v: Rates::from_array([x3, x4, x5]),
        }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 6] {
        let [x0, x1, x2] = self.q.to_array();
        let [x3, x4, x5] = self.v.to_array();
        [x0, x1, x2, x3, x4, x5]
    }
}

/// Mass matrix M(q), 3 x 3, symmetric; rows (psi, eps, theta).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 3]; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    // frame heli on arm
    let M_psi_theta = -p.I_theta * s_eps;
    let I_eps_minus_I_psi_c_theta = c_theta * (p.I_eps - p.I_psi);
    let heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    // frame arm on column
    let M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    let M_psi_psi = p.I_theta + c_eps * c_eps * (p.I_eps - heli_1 - p.I_theta);
    [
        [M_psi_psi, M_psi_eps, M_psi_theta], // psi
        [M_psi_eps, p.I_psi + heli_1, 0.0], // eps
        [M_psi_theta, 0.0, p.I_theta], // theta
    ]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (psi, eps, theta).
#[must_use]
pub fn bias(q: &Coordinates, _v: &Rates, p: &Parameters) -> [f64; 3] {
    let c_eps = cos(q.eps);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let m = p.m_c + p.m_h + p.m_b;
    // gravity
    let g_eps = p.g * m * m_prime * c_eps / m;
    [0.0, g_eps, 0.0]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (psi, eps, theta).
#[must_use]
pub fn velocity_products(_q: &Coordinates, _v: &Rates, _p: &Parameters) -> [f64; 3] {
    [0.0, 0.0, 0.0]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (psi, eps, theta).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 3] {
    let c_eps = cos(q.eps);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let m = p.m_c + p.m_h + p.m_b;
    let g_eps = p.g * m * m_prime * c_eps / m;
    [0.0, g_eps, 0.0]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (psi, eps, theta).
#[must_use]
pub fn dissipation(_q: &Coordinates, _v: &Rates, _p: &Parameters) -> [f64; 3] {
    [0.0, 0.0, 0.0]
}

/// Generalized force Q [N m] of the inputs; rows (psi, eps, theta).
#[must_use]
pub fn generalized_force(q: &Coordinates, u: &Inputs, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // force rotor_2 on heli
    let n_applied_heli_y = -p.l_oc * u.f_1 - p.l_oc * u.f_2;
    // frame arm on column
    let arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    let n_applied_column_z = arm_1 - n_applied_heli_y * c_eps * s_theta;
    [n_applied_column_z, -n_applied_heli_y * c_theta, l_df_f_1 - l_df_f_2]
}

/// Input map dQ/du, 3 x 2; rows (psi, eps, theta), columns (f_1, f_2).
#[must_use]
pub fn input_map(q: &Coordinates, p: &Parameters) -> [[f64; 2]; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let l_oc_c_theta = p.l_oc * c_theta;
    let l_oc_c_eps_s_theta = p.l_oc * c_eps * s_theta;
    let l_df_s_eps = p.l_df * s_eps;
    [
        [l_oc_c_eps_s_theta - l_df_s_eps, l_oc_c_eps_s_theta + l_df_s_eps], // psi
        [l_oc_c_theta, l_oc_c_theta], // eps
        [p.l_df, -p.l_df], // theta
    ]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let m = p.m_c + p.m_h + p.m_b;
    let m_prime_per_m = m_prime / m;
    let m_prime_m_prime_per_m = m_prime * m_prime_per_m;
    // frame arm on column
    let omega_arm_z = c_eps * v.psi;
    // frame heli on arm
    let omega_heli_y = -c_theta * v.eps - omega_arm_z * s_theta;
    let omega_heli_z = omega_arm_z * c_theta - s_theta * v.eps;
    let omega_heli_x = s_eps * v.psi - v.theta;
    let m_prime_per_m_omega_heli_z = m_prime_per_m * omega_heli_z;
    let m_prime_per_m_omega_heli_y = m_prime_per_m * omega_heli_y;
    // body aircraft on heli
    let aircraft_1 = m
        * (m_prime_per_m_omega_heli_z * m_prime_per_m_omega_heli_z + m_prime_per_m_omega_heli_y * m_prime_per_m_omega_heli_y);
    let aircraft_2 = p.I_theta * omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y * (p.I_eps - m_prime_m_prime_per_m);
    let aircraft_3 = omega_heli_z * omega_heli_z * (p.I_psi - m_prime_m_prime_per_m) + aircraft_2;
    0.5 * (aircraft_1 + aircraft_3)
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let s_eps = sin(q.eps);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let m = p.m_c + p.m_h + p.m_b;
    p.g * m * m_prime * s_eps / m
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 3] {
    let State { q, .. } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let m = p.m_c + p.m_h + p.m_b;
    // frame heli on arm
    let M_psi_theta = -p.I_theta * s_eps;
    let I_eps_minus_I_psi_c_theta = c_theta * (p.I_eps - p.I_psi);
    let heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    // frame arm on column
    let M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    let M_psi_psi = p.I_theta + c_eps * c_eps * (p.I_eps - heli_1 - p.I_theta);
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // force rotor_2 on heli
    let n_applied_heli_y = -p.l_oc * u.f_1 - p.l_oc * u.f_2;
    // frame arm on column
    let arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    let n_applied_column_z = arm_1 - n_applied_heli_y * c_eps * s_theta;
    // gravity
    let g_eps = p.g * m * m_prime * c_eps / m;
    // balance of forces
    let balance_1 = g_eps + M_psi_eps * a.psi + a.eps * (p.I_psi + heli_1);
    [
        M_psi_psi * a.psi + M_psi_eps * a.eps + M_psi_theta * a.theta - n_applied_column_z, // psi
        balance_1 + n_applied_heli_y * c_theta, // eps
        p.I_theta * a.theta + M_psi_theta * a.psi - l_df_f_1 + l_df_f_2, // theta
    ]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.psi, q.eps, q.theta])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 3] {
    let State { q, .. } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    // frame heli on arm
    let M_psi_theta = -p.I_theta * s_eps;
    let I_eps_minus_I_psi_c_theta = c_theta * (p.I_eps - p.I_psi);
    let heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    let M_eps_eps = p.I_psi + heli_1;
    // frame arm on column
    let M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    let M_psi_psi = p.I_theta + c_eps * c_eps * (p.I_eps - heli_1 - p.I_theta);
    // M = L^T D L and back-substitution
    let pivot_psi = M_psi_psi - M_psi_eps * M_psi_eps / M_eps_eps - M_psi_theta * M_psi_theta / p.I_theta;
    [pivot_psi, M_eps_eps, p.I_theta]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 60 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, .. } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let m = p.m_c + p.m_h + p.m_b;
    // frame heli on arm
    let M_psi_theta = -p.I_theta * s_eps;
    let I_eps_minus_I_psi_c_theta = c_theta * (p.I_eps - p.I_psi);
    let heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    let M_eps_eps = p.I_psi + heli_1;
    // frame arm on column
    let M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    let M_psi_psi = p.I_theta + c_eps * c_eps * (p.I_eps - heli_1 - p.I_theta);
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // force rotor_2 on heli
    let n_applied_heli_y = -p.l_oc * u.f_1 - p.l_oc * u.f_2;
    // frame heli on arm
    let Q_theta = l_df_f_1 - l_df_f_2;
    // frame arm on column
    let arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    let n_applied_column_z = arm_1 - n_applied_heli_y * c_eps * s_theta;
    // gravity
    let g_eps = p.g * m * m_prime * c_eps / m;
    // balance of forces
    let tau_eps = -n_applied_heli_y * c_theta - g_eps;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / p.I_theta;
    let l_theta_psi = M_psi_theta * inv_theta;
    let inv_eps = 1.0 / M_eps_eps;
    let l_eps_psi = M_psi_eps * inv_eps;
    let pivot_psi = M_psi_psi - M_psi_eps * l_eps_psi - M_psi_theta * l_theta_psi;
    let psi_ddot = (n_applied_column_z - tau_eps * l_eps_psi - Q_theta * l_theta_psi) / pivot_psi;
    let eps_ddot = tau_eps * inv_eps - l_eps_psi * psi_ddot;
    let theta_ddot = Q_theta * inv_theta - l_theta_psi * psi_ddot;
    positive(p.I_theta, 2)?;
    positive(M_eps_eps, 1)?;
    positive(pivot_psi, 0)?;
    Ok(Accelerations::from_array([psi_ddot, eps_ddot, theta_ddot]))
}

/// x' and its Jacobians at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// x'.
    pub dx: [f64; 6],
    /// A = dx'/dx, 6 x 6.
    pub a: [[f64; 6]; 6],
    /// B = dx'/du, 6 x 2.
    pub b: [[f64; 2]; 6],
}

/// State derivative and its Jacobians A, B, exact, at any state.
/// 141 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///          psi eps theta psi.dot eps.dot theta.dot | f_1 f_2
/// psi'     .   .   .     1       .       .         | .   .
/// eps'     .   .   .     .       1       .         | .   .
/// theta'   .   .   .     .       .       1         | .   .
/// psi''    .   *   *     .       .       .         | *   *
/// eps''    .   *   *     .       .       .         | *   *
/// theta''  .   *   *     .       .       .         | *   *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let m = p.m_c + p.m_h + p.m_b;
    let m_prime_per_m = m_prime / m;
    // frame heli on arm
    let M_psi_theta = -p.I_theta * s_eps;
    let I_theta_c_eps = p.I_theta * c_eps;
    let I_eps_minus_I_psi = p.I_eps - p.I_psi;
    let I_eps_minus_I_psi_c_theta = I_eps_minus_I_psi * c_theta;
    let heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    let heli_2 = I_eps_minus_I_psi_c_theta * s_theta;
    let M_eps_eps = p.I_psi + heli_1;
    // frame arm on column
    let M_psi_eps = heli_2 * c_eps;
    let heli_2_s_eps = heli_2 * s_eps;
    let arm_1 = p.I_eps - heli_1 - p.I_theta;
    let arm_1_c_eps = arm_1 * c_eps;
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // force rotor_2 on heli
    let n_applied_heli_x = l_df_f_2 - l_df_f_1;
    let n_applied_heli_y = -p.l_oc * u.f_1 - p.l_oc * u.f_2;
    // frame heli on arm
    let Q_theta = l_df_f_1 - l_df_f_2;
    let n_applied_arm_y = n_applied_heli_y * c_theta;
    let n_applied_arm_z = -n_applied_heli_y * s_theta;
    // frame arm on column
    let n_applied_column_z = n_applied_arm_z * c_eps + n_applied_heli_x * s_eps;
    let n_applied_column_x = n_applied_heli_x * c_eps - n_applied_arm_z * s_eps;
    // gravity
    let g_eps = p.g * m * m_prime_per_m * c_eps;
    // balance of forces
    let tau_eps = -n_applied_arm_y - g_eps;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / p.I_theta;
    let l_theta_psi = M_psi_theta * inv_theta;
    let inv_eps = 1.0 / M_eps_eps;
    let l_eps_psi = M_psi_eps * inv_eps;
    let pivot_psi = p.I_theta + arm_1_c_eps * c_eps - M_psi_eps * l_eps_psi - M_psi_theta * l_theta_psi;
    let inv_psi = 1.0 / pivot_psi;
    let psi_ddot = inv_psi * (n_applied_column_z - tau_eps * l_eps_psi - Q_theta * l_theta_psi);
    let eps_ddot = tau_eps * inv_eps - l_eps_psi * psi_ddot;
    let theta_ddot = Q_theta * inv_theta - l_theta_psi * psi_ddot;
    let l_oc_c_theta = p.l_oc * c_theta;
    let l_oc_c_eps_s_theta = p.l_oc * c_eps * s_theta;
    let l_df_s_eps = p.l_df * s_eps;
    let arm_1_c_eps_s_eps = arm_1 * c_eps * s_eps;
    let I_eps_minus_I_psi_s_theta = I_eps_minus_I_psi * s_theta;
    // derivatives with respect to theta
    let by_theta_1 = heli_2 + I_eps_minus_I_psi_s_theta * c_theta;
    let by_theta_2 = c_eps * (heli_1 - I_eps_minus_I_psi_s_theta * s_theta);
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = psi_ddot * (arm_1_c_eps * s_eps + arm_1_c_eps_s_eps);
    let slopes_2 = slopes_1 + heli_2_s_eps * eps_ddot + I_theta_c_eps * theta_ddot;
    let slopes_3 = p.g * m * m_prime_per_m * s_eps + heli_2_s_eps * psi_ddot;
    let I_theta_c_eps_psi_ddot = I_theta_c_eps * psi_ddot;
    let slopes_4 = psi_ddot * by_theta_1 * c_eps * c_eps;
    let slopes_5 = n_applied_arm_z + psi_ddot * by_theta_2 - eps_ddot * by_theta_1;
    // derivatives with respect to eps
    let by_eps_1 = n_applied_column_x + slopes_2 - l_eps_psi * slopes_3;
    let d_psi_ddot_by_eps = inv_psi * (by_eps_1 - l_theta_psi * I_theta_c_eps_psi_ddot);
    let d_eps_ddot_by_eps = inv_eps * slopes_3 - l_eps_psi * d_psi_ddot_by_eps;
    let d_theta_ddot_by_eps = inv_theta * I_theta_c_eps_psi_ddot - l_theta_psi * d_psi_ddot_by_eps;
    // derivatives with respect to theta
    let by_theta_3 = n_applied_arm_y * c_eps + slopes_4 + eps_ddot * by_theta_2;
    let d_psi_ddot_by_theta = inv_psi * (l_eps_psi * slopes_5 - by_theta_3);
    let d_eps_ddot_by_theta = -inv_eps * slopes_5 - l_eps_psi * d_psi_ddot_by_theta;
    let l_eps_psi_l_oc_c_theta = l_eps_psi * l_oc_c_theta;
    let l_df_l_theta_psi = p.l_df * l_theta_psi;
    // derivatives with respect to f_1
    let d_psi_ddot_by_f_1 = inv_psi * (l_oc_c_eps_s_theta - l_df_s_eps - l_eps_psi_l_oc_c_theta - l_df_l_theta_psi);
    let inv_eps_l_oc_c_theta = inv_eps * l_oc_c_theta;
    let l_df_inv_theta = p.l_df * inv_theta;
    // derivatives with respect to f_2
    let d_psi_ddot_by_f_2 = inv_psi * (l_oc_c_eps_s_theta + l_df_s_eps - l_eps_psi_l_oc_c_theta + l_df_l_theta_psi);
    positive(p.I_theta, 2)?;
    positive(M_eps_eps, 1)?;
    positive(pivot_psi, 0)?;
    Ok(Linearization {
        dx: [v.psi, v.eps, v.theta, psi_ddot, eps_ddot, theta_ddot],
        a: [
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0], // psi'
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0], // eps'
            [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], // theta'
            [0.0, d_psi_ddot_by_eps, d_psi_ddot_by_theta, 0.0, 0.0, 0.0], // psi''
            [0.0, d_eps_ddot_by_eps, d_eps_ddot_by_theta, 0.0, 0.0, 0.0], // eps''
            [0.0, d_theta_ddot_by_eps, -l_theta_psi * d_psi_ddot_by_theta, 0.0, 0.0, 0.0], // theta''
        ],
        b: [
            [0.0, 0.0], // psi'
            [0.0, 0.0], // eps'
            [0.0, 0.0], // theta'
            [d_psi_ddot_by_f_1, d_psi_ddot_by_f_2], // psi''
            [inv_eps_l_oc_c_theta - l_eps_psi * d_psi_ddot_by_f_1, inv_eps_l_oc_c_theta - l_eps_psi * d_psi_ddot_by_f_2], // eps''
            [l_df_inv_theta - l_theta_psi * d_psi_ddot_by_f_1, -l_theta_psi * d_psi_ddot_by_f_2 - l_df_inv_theta], // theta''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 6 x 15; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 15]; 6], Singular> {
    let State { q, .. } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let m = p.m_c + p.m_h + p.m_b;
    let f_s = u.f_1 + u.f_2;
    let f_d = u.f_1 - u.f_2;
    let m_prime_per_m = m_prime / m;
    let m_prime_per_m_c_eps = m_prime_per_m * c_eps;
    // frame heli on arm
    let M_psi_theta = -p.I_theta * s_eps;
    let I_eps_minus_I_psi_c_theta = c_theta * (p.I_eps - p.I_psi);
    let heli_1 = I_eps_minus_I_psi_c_theta * c_theta;
    let M_eps_eps = p.I_psi + heli_1;
    // frame arm on column
    let M_psi_eps = I_eps_minus_I_psi_c_theta * c_eps * s_theta;
    let M_psi_psi = p.I_theta + c_eps * c_eps * (p.I_eps - heli_1 - p.I_theta);
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // force rotor_2 on heli
    let n_applied_heli_y = -p.l_oc * u.f_1 - p.l_oc * u.f_2;
    // frame heli on arm
    let Q_theta = l_df_f_1 - l_df_f_2;
    // frame arm on column
    let arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    let n_applied_column_z = arm_1 - n_applied_heli_y * c_eps * s_theta;
    let g_m_prime_per_m_c_eps = p.g * m_prime_per_m_c_eps;
    // balance of forces
    let tau_eps = -n_applied_heli_y * c_theta - m * g_m_prime_per_m_c_eps;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / p.I_theta;
    let l_theta_psi = M_psi_theta * inv_theta;
    let inv_eps = 1.0 / M_eps_eps;
    let l_eps_psi = M_psi_eps * inv_eps;
    let pivot_psi = M_psi_psi - M_psi_eps * l_eps_psi - M_psi_theta * l_theta_psi;
    let inv_psi = 1.0 / pivot_psi;
    let psi_ddot = inv_psi * (n_applied_column_z - tau_eps * l_eps_psi - Q_theta * l_theta_psi);
    let eps_ddot = tau_eps * inv_eps - l_eps_psi * psi_ddot;
    let theta_ddot = Q_theta * inv_theta - l_theta_psi * psi_ddot;
    // derivatives with respect to m_h
    let by_m_h_1 = g_m_prime_per_m_c_eps + p.g * m * c_eps * (p.l_oc - m_prime_per_m) / m;
    let d_psi_ddot_by_m_h = inv_psi * l_eps_psi * by_m_h_1;
    let d_eps_ddot_by_m_h = -inv_eps * by_m_h_1 - l_eps_psi * d_psi_ddot_by_m_h;
    // derivatives with respect to m_b
    let by_m_b_1 = g_m_prime_per_m_c_eps + p.g * m * c_eps * (p.l_oa - m_prime_per_m) / m;
    let d_psi_ddot_by_m_b = inv_psi * l_eps_psi * by_m_b_1;
    let d_eps_ddot_by_m_b = -inv_eps * by_m_b_1 - l_eps_psi * d_psi_ddot_by_m_b;
    let m_m_prime_per_m_c_eps = m * m_prime_per_m_c_eps;
    // derivatives with respect to g
    let d_psi_ddot_by_g = inv_psi * l_eps_psi * m_m_prime_per_m_c_eps;
    let d_eps_ddot_by_g = -inv_eps * m_m_prime_per_m_c_eps - l_eps_psi * d_psi_ddot_by_g;
    let g_m_m_c_per_m_c_eps = p.m_c * p.g * m * c_eps / m;
    // derivatives with respect to l_ob
    let d_psi_ddot_by_l_ob = -inv_psi * l_eps_psi * g_m_m_c_per_m_c_eps;
    let d_eps_ddot_by_l_ob = inv_eps * g_m_m_c_per_m_c_eps - l_eps_psi * d_psi_ddot_by_l_ob;
    let g_m_m_b_per_m_c_eps = p.m_b * p.g * m * c_eps / m;
    // derivatives with respect to l_oa
    let d_psi_ddot_by_l_oa = inv_psi * l_eps_psi * g_m_m_b_per_m_c_eps;
    let d_eps_ddot_by_l_oa = -inv_eps * g_m_m_b_per_m_c_eps - l_eps_psi * d_psi_ddot_by_l_oa;
    let c_theta_sq = c_theta * c_theta;
    let one_minus_c_theta_sq = 1.0 - c_theta_sq;
    let c_eps_s_theta_c_theta = c_eps * s_theta * c_theta;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = eps_ddot * c_eps_s_theta_c_theta;
    let slopes_2 = psi_ddot * c_eps_s_theta_c_theta;
    let slopes_3 = slopes_1 + psi_ddot * one_minus_c_theta_sq * c_eps * c_eps;
    let slopes_4 = slopes_2 + eps_ddot * c_theta_sq;
    // derivatives with respect to m_c
    let by_m_c_1 = p.g * m * c_eps * (p.l_ob + m_prime_per_m) / m - g_m_prime_per_m_c_eps;
    let d_psi_ddot_by_m_c = -inv_psi * l_eps_psi * by_m_c_1;
    let d_eps_ddot_by_m_c = inv_eps * by_m_c_1 - l_eps_psi * d_psi_ddot_by_m_c;
    // derivatives with respect to l_oc
    let by_l_oc_1 = f_s * c_theta - p.m_h * p.g * m * c_eps / m;
    let d_psi_ddot_by_l_oc = inv_psi * (f_s * c_eps * s_theta - l_eps_psi * by_l_oc_1);
    let d_eps_ddot_by_l_oc = inv_eps * by_l_oc_1 - l_eps_psi * d_psi_ddot_by_l_oc;
    // derivatives with respect to l_df
    let d_psi_ddot_by_l_df = inv_psi * (s_eps * (u.f_2 - u.f_1) - f_d * l_theta_psi);
    let d_theta_ddot_by_l_df = f_d * inv_theta - l_theta_psi * d_psi_ddot_by_l_df;
    // derivatives with respect to I_psi
    let by_I_psi_1 = slopes_1 - psi_ddot * c_theta_sq * c_eps * c_eps;
    let by_I_psi_2 = slopes_2 - eps_ddot * one_minus_c_theta_sq;
    let d_psi_ddot_by_I_psi = inv_psi * (by_I_psi_1 - l_eps_psi * by_I_psi_2);
    let d_eps_ddot_by_I_psi = inv_eps * by_I_psi_2 - l_eps_psi * d_psi_ddot_by_I_psi;
    // derivatives with respect to I_eps
    let d_psi_ddot_by_I_eps = inv_psi * (l_eps_psi * slopes_4 - slopes_3);
    let d_eps_ddot_by_I_eps = -inv_eps * slopes_4 - l_eps_psi * d_psi_ddot_by_I_eps;
    // derivatives with respect to I_theta
    let by_I_theta_1 = theta_ddot * s_eps - psi_ddot * (1.0 - c_eps * c_eps);
    let by_I_theta_2 = psi_ddot * s_eps - theta_ddot;
    let d_psi_ddot_by_I_theta = inv_psi * (by_I_theta_1 - l_theta_psi * by_I_theta_2);
    let d_theta_ddot_by_I_theta = inv_theta * by_I_theta_2 - l_theta_psi * d_psi_ddot_by_I_theta;
    positive(p.I_theta, 2)?;
    positive(M_eps_eps, 1)?;
    positive(pivot_psi, 0)?;
    Ok([
        [0.0; 15], // psi'
        [0.0; 15], // eps'
        [0.0; 15], // theta'
        // psi''
        Parameters {
            m_h: d_psi_ddot_by_m_h,
            m_b: d_psi_ddot_by_m_b,
            m_c: d_psi_ddot_by_m_c,
            g: d_psi_ddot_by_g,
            l_oc: d_psi_ddot_by_l_oc,
            l_ob: d_psi_ddot_by_l_ob,
            l_oa: d_psi_ddot_by_l_oa,
            l_df: d_psi_ddot_by_l_df,
            I_psi: d_psi_ddot_by_I_psi,
            I_eps: d_psi_ddot_by_I_eps,
            I_theta: d_psi_ddot_by_I_theta,
            ..Parameters::ZERO
        }
        .to_array(),
        // eps''
        Parameters {
            m_h: d_eps_ddot_by_m_h,
            m_b: d_eps_ddot_by_m_b,
            m_c: d_eps_ddot_by_m_c,
            g: d_eps_ddot_by_g,
            l_oc: d_eps_ddot_by_l_oc,
            l_ob: d_eps_ddot_by_l_ob,
            l_oa: d_eps_ddot_by_l_oa,
            l_df: -l_eps_psi * d_psi_ddot_by_l_df,
            I_psi: d_eps_ddot_by_I_psi,
            I_eps: d_eps_ddot_by_I_eps,
            I_theta: -l_eps_psi * d_psi_ddot_by_I_theta,
            ..Parameters::ZERO
        }
        .to_array(),
        // theta''
        Parameters {
            m_h: -l_theta_psi * d_psi_ddot_by_m_h,
            m_b: -l_theta_psi * d_psi_ddot_by_m_b,
            m_c: -l_theta_psi * d_psi_ddot_by_m_c,
            g: -l_theta_psi * d_psi_ddot_by_g,
            l_oc: -l_theta_psi * d_psi_ddot_by_l_oc,
            l_ob: -l_theta_psi * d_psi_ddot_by_l_ob,
            l_oa: -l_theta_psi * d_psi_ddot_by_l_oa,
            l_df: d_theta_ddot_by_l_df,
            I_psi: -l_theta_psi * d_psi_ddot_by_I_psi,
            I_eps: -l_theta_psi * d_psi_ddot_by_I_eps,
            I_theta: d_theta_ddot_by_I_theta,
            ..Parameters::ZERO
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 3 x 6.
    pub by_x: [[f64; 6]; 3],
    /// dy/dp, 3 x 15.
    pub by_p: [[f64; 15]; 3],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [
            [1.0, 0.0, 0.0, 0.0, 0.0, 0.0], // psi
            [0.0, 1.0, 0.0, 0.0, 0.0, 0.0], // eps
            [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], // theta
        ],
        by_p: [
            [0.0; 15], // psi
            [0.0; 15], // eps
            [0.0; 15], // theta
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 6] = ["psi", "eps", "theta", "psi.dot", "eps.dot", "theta.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 2] = ["f_1", "f_2"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 15] = [
    "m_h", "m_b", "m_c", "g", "l_oc", "l_ob", "l_oa", "l_cd", "l_df", "c0_psi", "c0_eps", "c0_theta", "I_psi", "I_eps", "I_theta",
];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 15] = [
    "kg", "kg", "kg", "m/s^2", "m", "m", "m", "m", "m", "N*m*s", "N*m*s", "N*m*s", "kg*m^2", "kg*m^2", "kg*m^2",
];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 3] = ["psi", "eps", "theta"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 3] = ["rad", "rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GoogolSrb;

impl Names for GoogolSrb {
    fn rig(&self) -> &str {
        "GoogolSrb"
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

impl Model for GoogolSrb {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 3, lags: 0, inputs: 2, exogenous: 0, parameters: 15, outputs: 3 }
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
        runtime::write(dx, 3, &a.to_array());
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
        runtime::write(d, 2, &[pivots[2]]);
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
            0 => InputPath { limits: (0.05, 4.0), delay: 0.0 },
            1 => InputPath { limits: (0.05, 4.0), delay: 0.0 },
            _ => InputPath { limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0 },
        }
    }

    fn output_path(&self, i: usize, _p: &[f64]) -> OutputPath {
        match i {
            0 => OutputPath { quantum: 0.001308996938995747, wrapped: false, delay: 0.0, play: 0.0 },
            1 => OutputPath { quantum: 0.002617993877991494, wrapped: false, delay: 0.0, play: 0.0 },
            2 => OutputPath { quantum: 0.002617993877991494, wrapped: false, delay: 0.0, play: 0.0 },
            _ => OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false },
        }
    }
}
