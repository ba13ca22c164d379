//! Googol GHP2002, multi-rigid-body model.
//! Generated from `googol_mrb.rig` (model 236cb442); edit the rig, not this file.
//!
//! Eq. 13 of the seed paper, derived: the full physics under the paper's assumptions (no velocity
//! products, a constant diagonal mass matrix). The yaw-by-f_d term comes out without the misprinted
//! factor sin(theta); see `googol_eq13.rig`.
//!
//! Assumed: no velocity products; M = diag(I_psi, I_eps, I_theta).
//! 50 operations forward, 98 with A and B.
//! Derived twice before the assumptions, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::{cos, sin_cos};
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
    /// fuselage about its centre, along the arm [kg*m^2]
    pub I_x: f64,
    /// fuselage about its centre, upright [kg*m^2]
    pub I_z: f64,
    /// viscous friction of the column [N*m*s]
    pub c0_psi: f64,
    /// viscous friction of the elevation axis [N*m*s]
    pub c0_eps: f64,
    /// viscous friction of the pitch axis [N*m*s]
    pub c0_theta: f64,
    /// yaw inertia [kg*m^2]
    pub I_psi: f64,
    /// elevation inertia [kg*m^2]
    pub I_eps: f64,
    /// pitch inertia [kg*m^2]
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
        I_x: 0.0319,
        I_z: 0.0319,
        c0_psi: 0.4025,
        c0_eps: 0.0779,
        c0_theta: 0.00153,
        I_psi: 1.469,
        I_eps: 1.469,
        I_theta: 0.0319,
    };

    /// All zero: where derivatives with respect to the parameters start from.
    const ZERO: Self = Self::from_array([0.0; 17]);

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 17]) -> Self {
        let [m_h, m_b, m_c, g, l_oc, l_ob, l_oa, l_cd, l_df, I_x, I_z, c0_psi, c0_eps, c0_theta, I_psi, I_eps, I_theta] = values;
        Self { m_h, m_b, m_c, g, l_oc, l_ob, l_oa, l_cd, l_df, I_x, I_z, c0_psi, c0_eps, c0_theta, I_psi, I_eps, I_theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 17] {
        [
            self.m_h, self.m_b, self.m_c, self.g, self.l_oc, self.l_ob, self.l_oa, self.l_cd, self.l_df, self.I_x, self.I_z, self.c0_psi,
            self.c0_eps, self.c0_theta, self.I_psi, self.I_eps, self.I_theta,
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
pub fn mass_matrix(_q: &Coordinates, p: &Parameters) -> [[f64; 3]; 3] {
    [[p.I_psi, 0.0, 0.0], [0.0, p.I_eps, 0.0], [0.0, 0.0, p.I_theta]]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (psi, eps, theta).
#[must_use]
pub fn bias(q: &Coordinates, _v: &Rates, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    // gravity
    let gravity_1 = p.m_b * p.g * p.l_oa * c_eps - p.m_c * p.g * p.l_ob * c_eps;
    let gravity_2 = p.m_h * p.g * (p.l_cd * s_eps * c_theta + p.l_oc * c_eps);
    let g_theta = p.m_h * p.g * p.l_cd * c_eps * s_theta;
    [0.0, gravity_1 + gravity_2, g_theta]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (psi, eps, theta).
#[must_use]
pub fn velocity_products(_q: &Coordinates, _v: &Rates, _p: &Parameters) -> [f64; 3] {
    [0.0, 0.0, 0.0]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (psi, eps, theta).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let gravity_1 = p.m_b * p.g * p.l_oa * c_eps - p.m_c * p.g * p.l_ob * c_eps;
    let gravity_2 = p.m_h * p.g * (p.l_cd * s_eps * c_theta + p.l_oc * c_eps);
    let g_theta = p.m_h * p.g * p.l_cd * c_eps * s_theta;
    [0.0, gravity_1 + gravity_2, g_theta]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (psi, eps, theta).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 3] {
    [p.c0_psi * v.psi, p.c0_eps * v.eps, p.c0_theta * v.theta]
}

/// Generalized force Q [N m] of the inputs; rows (psi, eps, theta).
#[must_use]
pub fn generalized_force(q: &Coordinates, u: &Inputs, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let f_s = u.f_1 + u.f_2;
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // frame arm on column
    let arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    let n_applied_column_z = p.l_oc * f_s * c_eps * s_theta + arm_1;
    [n_applied_column_z, p.l_oc * f_s * c_theta, l_df_f_1 - l_df_f_2]
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

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let c_theta = cos(q.theta);
    // body counterweight on arm
    let counterweight_1 = p.m_b * p.g * p.l_oa * s_eps - p.m_c * p.g * p.l_ob * s_eps;
    // body fuselage on heli
    let fuselage_1 = p.m_h * p.g * (p.l_oc * s_eps - p.l_cd * c_eps * c_theta);
    counterweight_1 + fuselage_1
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 3] {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let f_s = u.f_1 + u.f_2;
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // frame arm on column
    let arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    let n_applied_column_z = p.l_oc * f_s * c_eps * s_theta + arm_1;
    // gravity
    let gravity_1 = p.m_b * p.g * p.l_oa * c_eps - p.m_c * p.g * p.l_ob * c_eps;
    let gravity_2 = p.m_h * p.g * (p.l_cd * s_eps * c_theta + p.l_oc * c_eps);
    let g_theta = p.m_h * p.g * p.l_cd * c_eps * s_theta;
    // balance of forces
    let balance_1 = gravity_1 + gravity_2 + p.I_eps * a.eps - p.l_oc * f_s * c_theta;
    [
        p.c0_psi * v.psi + p.I_psi * a.psi - n_applied_column_z, // psi
        p.c0_eps * v.eps + balance_1, // eps
        p.c0_theta * v.theta + g_theta + p.I_theta * a.theta - l_df_f_1 + l_df_f_2, // theta
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
pub fn pivots(_x: &State, p: &Parameters) -> [f64; 3] {
    [p.I_psi, p.I_eps, p.I_theta]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 50 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let f_s = u.f_1 + u.f_2;
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // frame arm on column
    let arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    let n_applied_column_z = p.l_oc * f_s * c_eps * s_theta + arm_1;
    // gravity
    let gravity_1 = p.m_b * p.g * p.l_oa * c_eps - p.m_c * p.g * p.l_ob * c_eps;
    let gravity_2 = p.m_h * p.g * (p.l_cd * s_eps * c_theta + p.l_oc * c_eps);
    let g_theta = p.m_h * p.g * p.l_cd * c_eps * s_theta;
    // balance of forces
    let tau_eps = p.l_oc * f_s * c_theta - p.c0_eps * v.eps - gravity_1 - gravity_2;
    let tau_theta = l_df_f_1 - p.c0_theta * v.theta - g_theta - l_df_f_2;
    // M = L^T D L and back-substitution
    let psi_ddot = (n_applied_column_z - p.c0_psi * v.psi) / p.I_psi;
    positive(p.I_theta, 2)?;
    positive(p.I_eps, 1)?;
    positive(p.I_psi, 0)?;
    Ok(Accelerations::from_array([psi_ddot, tau_eps / p.I_eps, tau_theta / p.I_theta]))
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
/// 98 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///          psi eps theta psi.dot eps.dot theta.dot | f_1 f_2
/// psi'     .   .   .     1       .       .         | .   .
/// eps'     .   .   .     .       1       .         | .   .
/// theta'   .   .   .     .       .       1         | .   .
/// psi''    .   *   *     *       .       .         | *   *
/// eps''    .   *   *     .       *       .         | *   *
/// theta''  .   *   *     .       .       *         | *   *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let f_s = u.f_1 + u.f_2;
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // force rotor_2 on heli
    let n_applied_heli_x = l_df_f_2 - l_df_f_1;
    // frame heli on arm
    let n_applied_arm_y = -p.l_oc * f_s * c_theta;
    let n_applied_arm_z = p.l_oc * f_s * s_theta;
    // frame arm on column
    let n_applied_column_z = n_applied_arm_z * c_eps + n_applied_heli_x * s_eps;
    let n_applied_column_x = n_applied_heli_x * c_eps - n_applied_arm_z * s_eps;
    let l_cd_s_theta = p.l_cd * s_theta;
    let l_cd_c_theta = p.l_cd * c_theta;
    let l_cd_c_theta_c_eps = l_cd_c_theta * c_eps;
    // gravity
    let gravity_1 = p.m_b * p.g * p.l_oa * c_eps - p.m_c * p.g * p.l_ob * c_eps;
    let gravity_2 = p.m_h * p.g * (l_cd_c_theta * s_eps + p.l_oc * c_eps);
    let g_theta = p.m_h * p.g * l_cd_s_theta * c_eps;
    // balance of forces
    let tau_eps = -p.c0_eps * v.eps - gravity_1 - gravity_2 - n_applied_arm_y;
    let tau_theta = l_df_f_1 - p.c0_theta * v.theta - g_theta - l_df_f_2;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / p.I_theta;
    let inv_eps = 1.0 / p.I_eps;
    let inv_psi = 1.0 / p.I_psi;
    let psi_ddot = inv_psi * (n_applied_column_z - p.c0_psi * v.psi);
    let l_oc_c_eps_s_theta = p.l_oc * c_eps * s_theta;
    let l_df_s_eps = p.l_df * s_eps;
    // derivatives with respect to eps
    let by_eps_1 = p.m_c * p.g * p.l_ob * s_eps - p.m_b * p.g * p.l_oa * s_eps;
    let by_eps_2 = p.m_h * p.g * (l_cd_c_theta_c_eps - p.l_oc * s_eps);
    let m_h_g_l_cd_s_theta_s_eps = p.m_h * p.g * l_cd_s_theta * s_eps;
    // derivatives with respect to theta
    let d_theta_ddot_by_theta = -p.m_h * p.g * inv_theta * l_cd_c_theta_c_eps;
    // derivatives with respect to f_1
    let d_eps_ddot_by_f_1 = p.l_oc * inv_eps * c_theta;
    let d_theta_ddot_by_f_1 = p.l_df * inv_theta;
    positive(p.I_theta, 2)?;
    positive(p.I_eps, 1)?;
    positive(p.I_psi, 0)?;
    Ok(Linearization {
        dx: [v.psi, v.eps, v.theta, psi_ddot, tau_eps * inv_eps, tau_theta * inv_theta],
        a: [
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0], // psi'
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0], // eps'
            [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], // theta'
            [0.0, n_applied_column_x * inv_psi, -inv_psi * n_applied_arm_y * c_eps, -p.c0_psi * inv_psi, 0.0, 0.0], // psi''
            // eps''
            [0.0, -inv_eps * (by_eps_1 + by_eps_2), inv_eps * (m_h_g_l_cd_s_theta_s_eps - n_applied_arm_z), 0.0, -p.c0_eps * inv_eps, 0.0],
            [0.0, inv_theta * m_h_g_l_cd_s_theta_s_eps, d_theta_ddot_by_theta, 0.0, 0.0, -p.c0_theta * inv_theta], // theta''
        ],
        b: [
            [0.0, 0.0], // psi'
            [0.0, 0.0], // eps'
            [0.0, 0.0], // theta'
            [inv_psi * (l_oc_c_eps_s_theta - l_df_s_eps), inv_psi * (l_oc_c_eps_s_theta + l_df_s_eps)], // psi''
            [d_eps_ddot_by_f_1, d_eps_ddot_by_f_1], // eps''
            [d_theta_ddot_by_f_1, -d_theta_ddot_by_f_1], // theta''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 6 x 17; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 17]; 6], Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let f_s = u.f_1 + u.f_2;
    // frame arm on column
    let a_arm_z = p.g * c_eps;
    let l_df_f_1 = p.l_df * u.f_1;
    let l_df_f_2 = p.l_df * u.f_2;
    // frame heli on arm
    let f_applied_heli_1_y = f_s * s_theta;
    let f_applied_heli_1_z = f_s * c_theta;
    // frame arm on column
    let arm_1 = s_eps * (l_df_f_2 - l_df_f_1);
    let n_applied_column_z = p.l_oc * f_applied_heli_1_y * c_eps + arm_1;
    let l_oa_c_eps = p.l_oa * c_eps;
    let l_ob_c_eps = p.l_ob * c_eps;
    // body fuselage on heli
    let fuselage_1 = p.l_cd * s_eps * c_theta + p.l_oc * c_eps;
    let g_l_oa_c_eps = p.g * l_oa_c_eps;
    let g_l_ob_c_eps = p.g * l_ob_c_eps;
    let g_fuselage_1 = p.g * fuselage_1;
    // gravity
    let g_eps = p.m_b * g_l_oa_c_eps - p.m_c * g_l_ob_c_eps + p.m_h * g_fuselage_1;
    let l_cd_c_eps_s_theta = p.l_cd * c_eps * s_theta;
    let g_l_cd_c_eps_s_theta = p.g * l_cd_c_eps_s_theta;
    // balance of forces
    let tau_eps = p.l_oc * f_applied_heli_1_z - p.c0_eps * v.eps - g_eps;
    let tau_theta = l_df_f_1 - p.c0_theta * v.theta - p.m_h * g_l_cd_c_eps_s_theta - l_df_f_2;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / p.I_theta;
    let inv_eps = 1.0 / p.I_eps;
    let inv_psi = 1.0 / p.I_psi;
    let psi_ddot = inv_psi * (n_applied_column_z - p.c0_psi * v.psi);
    // derivatives with respect to g
    let d_eps_ddot_by_g = -inv_eps * (p.m_b * l_oa_c_eps - p.m_c * l_ob_c_eps + p.m_h * fuselage_1);
    // derivatives with respect to l_oc
    let d_eps_ddot_by_l_oc = inv_eps * (f_applied_heli_1_z - p.m_h * a_arm_z);
    // derivatives with respect to l_cd
    let d_eps_ddot_by_l_cd = -p.m_h * p.g * inv_eps * s_eps * c_theta;
    let d_theta_ddot_by_l_cd = -p.m_h * p.g * inv_theta * c_eps * s_theta;
    // derivatives with respect to l_df
    let d_psi_ddot_by_l_df = inv_psi * s_eps * (u.f_2 - u.f_1);
    positive(p.I_theta, 2)?;
    positive(p.I_eps, 1)?;
    positive(p.I_psi, 0)?;
    Ok([
        [0.0; 17], // psi'
        [0.0; 17], // eps'
        [0.0; 17], // theta'
        // psi''
        Parameters {
            l_oc: inv_psi * f_applied_heli_1_y * c_eps,
            l_df: d_psi_ddot_by_l_df,
            c0_psi: -inv_psi * v.psi,
            I_psi: -inv_psi * psi_ddot,
            ..Parameters::ZERO
        }
        .to_array(),
        // eps''
        Parameters {
            m_h: -g_fuselage_1 * inv_eps,
            m_b: -g_l_oa_c_eps * inv_eps,
            m_c: g_l_ob_c_eps * inv_eps,
            g: d_eps_ddot_by_g,
            l_oc: d_eps_ddot_by_l_oc,
            l_ob: p.m_c * inv_eps * a_arm_z,
            l_oa: -p.m_b * inv_eps * a_arm_z,
            l_cd: d_eps_ddot_by_l_cd,
            c0_eps: -inv_eps * v.eps,
            I_eps: -inv_eps * tau_eps * inv_eps,
            ..Parameters::ZERO
        }
        .to_array(),
        // theta''
        Parameters {
            m_h: -g_l_cd_c_eps_s_theta * inv_theta,
            g: -p.m_h * inv_theta * l_cd_c_eps_s_theta,
            l_cd: d_theta_ddot_by_l_cd,
            l_df: inv_theta * (u.f_1 - u.f_2),
            c0_theta: -inv_theta * v.theta,
            I_theta: -inv_theta * tau_theta * inv_theta,
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
    /// dy/dp, 3 x 17.
    pub by_p: [[f64; 17]; 3],
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
            [0.0; 17], // psi
            [0.0; 17], // eps
            [0.0; 17], // theta
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 6] = ["psi", "eps", "theta", "psi.dot", "eps.dot", "theta.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 2] = ["f_1", "f_2"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 17] = [
    "m_h", "m_b", "m_c", "g", "l_oc", "l_ob", "l_oa", "l_cd", "l_df", "I_x", "I_z", "c0_psi", "c0_eps", "c0_theta", "I_psi", "I_eps",
    "I_theta",
];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 17] = [
    "kg", "kg", "kg", "m/s^2", "m", "m", "m", "m", "m", "kg*m^2", "kg*m^2", "N*m*s", "N*m*s", "N*m*s", "kg*m^2", "kg*m^2", "kg*m^2",
];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 3] = ["psi", "eps", "theta"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 3] = ["rad", "rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GoogolMrb;

impl Names for GoogolMrb {
    fn rig(&self) -> &str {
        "GoogolMrb"
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

impl Model for GoogolMrb {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 3, lags: 0, inputs: 2, exogenous: 0, parameters: 17, outputs: 3 }
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
