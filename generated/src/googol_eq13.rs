//! Googol GHP2002, eq. 13 as printed.
//! Generated from `googol_eq13.rig` (model 563aaada); edit the rig, not this file.
//!
//! The seed paper's equations, written directly, with the printed factor sin(theta) in the
//! yaw-by-f_d term. `rig diff googol_mrb.rig googol_eq13.rig` shows that one term.
//!
//! 47 operations forward, 91 with A and B.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::sin_cos;
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
    /// psi [rad]
    pub psi: f64,
    /// eps [rad]
    pub eps: f64,
    /// theta [rad]
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
    /// psi.dot [rad/s]
    pub psi: f64,
    /// eps.dot [rad/s]
    pub eps: f64,
    /// theta.dot [rad/s]
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
    /// psi.ddot [rad/s^2]
    pub psi: f64,
    /// eps.ddot [rad/s^2]
    pub eps: f64,
    /// theta.ddot [rad/s^2]
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

/// Bias h(q, v) [unit of the row]: terms without rates and inputs, on the left-hand side; rows (psi, eps, theta).
#[must_use]
pub fn bias(q: &Coordinates, _v: &Rates, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let l_cd_m_h_g = p.m_h * p.g * p.l_cd;
    // equation of eps
    let g_eps = l_cd_m_h_g * s_eps * c_theta + p.g * m_prime * c_eps;
    [0.0, g_eps, l_cd_m_h_g * s_theta * c_eps]
}

/// Bias of the equations as written [unit of the row]; rows (psi, eps, theta).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let l_cd_m_h_g = p.m_h * p.g * p.l_cd;
    // equation of eps
    let g_eps = l_cd_m_h_g * s_eps * c_theta + p.g * m_prime * c_eps;
    [0.0, g_eps, l_cd_m_h_g * s_theta * c_eps]
}

/// Friction and dampers d(q, v) [unit of the row], on the left-hand side; rows (psi, eps, theta).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 3] {
    [p.c0_psi * v.psi, p.c0_eps * v.eps, p.c0_theta * v.theta]
}

/// Generalized force Q [unit of the row] of the inputs; rows (psi, eps, theta).
#[must_use]
pub fn generalized_force(q: &Coordinates, u: &Inputs, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let f_s = u.f_1 + u.f_2;
    let f_d = u.f_1 - u.f_2;
    let l_df_f_d_s_theta_s_eps = p.l_df * f_d * s_theta * s_eps;
    // equation of psi
    let Q_psi = p.l_oc * f_s * c_eps * s_theta - l_df_f_d_s_theta_s_eps;
    [Q_psi, p.l_oc * f_s * c_theta, p.l_df * f_d]
}

/// Input map dQ/du, 3 x 2; rows (psi, eps, theta), columns (f_1, f_2).
#[must_use]
pub fn input_map(q: &Coordinates, p: &Parameters) -> [[f64; 2]; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let l_oc_c_eps_s_theta = p.l_oc * c_eps * s_theta;
    let l_df_s_theta_s_eps = p.l_df * s_theta * s_eps;
    let l_oc_c_theta = p.l_oc * c_theta;
    [
        [l_oc_c_eps_s_theta - l_df_s_theta_s_eps, l_oc_c_eps_s_theta + l_df_s_theta_s_eps], // psi
        [l_oc_c_theta, l_oc_c_theta], // eps
        [p.l_df, -p.l_df], // theta
    ]
}

/// Inverse dynamics M a + h + d - Q [unit of the row]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 3] {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let f_s = u.f_1 + u.f_2;
    let f_d = u.f_1 - u.f_2;
    let l_df_f_d_s_theta_s_eps = p.l_df * f_d * s_theta * s_eps;
    // equation of psi
    let Q_psi = p.l_oc * f_s * c_eps * s_theta - l_df_f_d_s_theta_s_eps;
    let l_cd_m_h_g = p.m_h * p.g * p.l_cd;
    // equation of eps
    let g_eps = l_cd_m_h_g * s_eps * c_theta + p.g * m_prime * c_eps;
    // balance of forces
    let balance_1 = l_cd_m_h_g * s_theta * c_eps + p.I_theta * a.theta - p.l_df * f_d;
    [
        p.c0_psi * v.psi + p.I_psi * a.psi - Q_psi, // psi
        p.c0_eps * v.eps + g_eps + p.I_eps * a.eps - p.l_oc * f_s * c_theta, // eps
        p.c0_theta * v.theta + balance_1, // theta
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
/// 47 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let f_s = u.f_1 + u.f_2;
    let f_d = u.f_1 - u.f_2;
    let l_oc_f_s_c_eps_s_theta = p.l_oc * f_s * c_eps * s_theta;
    let l_cd_m_h_g = p.m_h * p.g * p.l_cd;
    // equation of eps
    let g_eps = l_cd_m_h_g * s_eps * c_theta + p.g * m_prime * c_eps;
    // balance of forces
    let tau_psi = l_oc_f_s_c_eps_s_theta - p.c0_psi * v.psi - p.l_df * f_d * s_theta * s_eps;
    let tau_eps = p.l_oc * f_s * c_theta - p.c0_eps * v.eps - g_eps;
    let tau_theta = p.l_df * f_d - p.c0_theta * v.theta - l_cd_m_h_g * s_theta * c_eps;
    positive(p.I_theta, 2)?;
    positive(p.I_eps, 1)?;
    positive(p.I_psi, 0)?;
    Ok(Accelerations::from_array([tau_psi / p.I_psi, tau_eps / p.I_eps, tau_theta / p.I_theta]))
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
/// 91 operations.
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
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let f_s = u.f_1 + u.f_2;
    let f_d = u.f_1 - u.f_2;
    let l_oc_c_eps = p.l_oc * c_eps;
    let l_oc_c_eps_s_theta = l_oc_c_eps * s_theta;
    let l_df_s_theta = p.l_df * s_theta;
    let l_df_s_theta_s_eps = l_df_s_theta * s_eps;
    let l_cd_m_h_g = p.m_h * p.g * p.l_cd;
    let l_cd_m_h_g_c_theta = l_cd_m_h_g * c_theta;
    let g_m_prime = p.g * m_prime;
    // equation of eps
    let g_eps = l_cd_m_h_g_c_theta * s_eps + g_m_prime * c_eps;
    let l_oc_c_theta = p.l_oc * c_theta;
    let l_cd_m_h_g_c_eps = l_cd_m_h_g * c_eps;
    // balance of forces
    let tau_psi = f_s * l_oc_c_eps_s_theta - p.c0_psi * v.psi - f_d * l_df_s_theta_s_eps;
    let tau_eps = f_s * l_oc_c_theta - p.c0_eps * v.eps - g_eps;
    let tau_theta = p.l_df * f_d - p.c0_theta * v.theta - l_cd_m_h_g_c_eps * s_theta;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / p.I_theta;
    let inv_eps = 1.0 / p.I_eps;
    let inv_psi = 1.0 / p.I_psi;
    let l_oc_f_s_s_theta_s_eps = p.l_oc * f_s * s_theta * s_eps;
    // derivatives with respect to eps
    let d_psi_ddot_by_eps = -inv_psi * (l_oc_f_s_s_theta_s_eps + f_d * l_df_s_theta * c_eps);
    let d_eps_ddot_by_eps = inv_eps * (g_m_prime * s_eps - l_cd_m_h_g_c_theta * c_eps);
    let d_theta_ddot_by_eps = inv_theta * l_cd_m_h_g * s_theta * s_eps;
    let l_df_f_d_s_eps_c_theta = p.l_df * f_d * s_eps * c_theta;
    // derivatives with respect to theta
    let by_theta_1 = l_cd_m_h_g * s_eps * s_theta - p.l_oc * f_s * s_theta;
    let d_psi_ddot_by_theta = inv_psi * (f_s * l_oc_c_eps * c_theta - l_df_f_d_s_eps_c_theta);
    // derivatives with respect to f_1
    let d_eps_ddot_by_f_1 = l_oc_c_theta * inv_eps;
    let d_theta_ddot_by_f_1 = p.l_df * inv_theta;
    positive(p.I_theta, 2)?;
    positive(p.I_eps, 1)?;
    positive(p.I_psi, 0)?;
    Ok(Linearization {
        dx: [v.psi, v.eps, v.theta, tau_psi * inv_psi, tau_eps * inv_eps, tau_theta * inv_theta],
        a: [
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0], // psi'
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0], // eps'
            [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], // theta'
            [0.0, d_psi_ddot_by_eps, d_psi_ddot_by_theta, -p.c0_psi * inv_psi, 0.0, 0.0], // psi''
            [0.0, d_eps_ddot_by_eps, inv_eps * by_theta_1, 0.0, -p.c0_eps * inv_eps, 0.0], // eps''
            [0.0, d_theta_ddot_by_eps, -inv_theta * l_cd_m_h_g_c_eps * c_theta, 0.0, 0.0, -p.c0_theta * inv_theta], // theta''
        ],
        b: [
            [0.0, 0.0], // psi'
            [0.0, 0.0], // eps'
            [0.0, 0.0], // theta'
            [inv_psi * (l_oc_c_eps_s_theta - l_df_s_theta_s_eps), inv_psi * (l_oc_c_eps_s_theta + l_df_s_theta_s_eps)], // psi''
            [d_eps_ddot_by_f_1, d_eps_ddot_by_f_1], // eps''
            [d_theta_ddot_by_f_1, -d_theta_ddot_by_f_1], // theta''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 6 x 15; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 15]; 6], Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_prime = p.m_h * p.l_oc + p.m_b * p.l_oa - p.m_c * p.l_ob;
    let f_s = u.f_1 + u.f_2;
    let f_d = u.f_1 - u.f_2;
    let l_oc_f_s_c_eps_s_theta = p.l_oc * f_s * c_eps * s_theta;
    let m_h_g = p.m_h * p.g;
    let l_cd_m_h_g = p.l_cd * m_h_g;
    // equation of eps
    let g_eps = l_cd_m_h_g * s_eps * c_theta + p.g * m_prime * c_eps;
    // balance of forces
    let tau_psi = l_oc_f_s_c_eps_s_theta - p.c0_psi * v.psi - p.l_df * f_d * s_theta * s_eps;
    let tau_eps = p.l_oc * f_s * c_theta - p.c0_eps * v.eps - g_eps;
    let tau_theta = p.l_df * f_d - p.c0_theta * v.theta - l_cd_m_h_g * s_theta * c_eps;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / p.I_theta;
    let inv_eps = 1.0 / p.I_eps;
    let inv_psi = 1.0 / p.I_psi;
    let g_l_cd = p.g * p.l_cd;
    // derivatives with respect to m_h
    let by_m_h_1 = g_l_cd * s_eps * c_theta + p.g * p.l_oc * c_eps;
    let d_theta_ddot_by_m_h = -inv_theta * g_l_cd * s_theta * c_eps;
    let m_h_l_cd = p.m_h * p.l_cd;
    // derivatives with respect to g
    let by_g_1 = m_h_l_cd * s_eps * c_theta + m_prime * c_eps;
    let d_theta_ddot_by_g = -inv_theta * m_h_l_cd * s_theta * c_eps;
    let m_h_g_c_eps = m_h_g * c_eps;
    // derivatives with respect to l_oc
    let d_psi_ddot_by_l_oc = inv_psi * f_s * c_eps * s_theta;
    let d_eps_ddot_by_l_oc = inv_eps * (f_s * c_theta - m_h_g_c_eps);
    // derivatives with respect to m_b
    let d_eps_ddot_by_m_b = -p.g * p.l_oa * inv_eps * c_eps;
    // derivatives with respect to m_c
    let d_eps_ddot_by_m_c = p.g * p.l_ob * inv_eps * c_eps;
    // derivatives with respect to l_ob
    let d_eps_ddot_by_l_ob = p.m_c * p.g * inv_eps * c_eps;
    // derivatives with respect to l_oa
    let d_eps_ddot_by_l_oa = -p.m_b * p.g * inv_eps * c_eps;
    // derivatives with respect to l_cd
    let d_eps_ddot_by_l_cd = -inv_eps * m_h_g * s_eps * c_theta;
    // derivatives with respect to l_df
    let d_psi_ddot_by_l_df = -inv_psi * f_d * s_theta * s_eps;
    positive(p.I_theta, 2)?;
    positive(p.I_eps, 1)?;
    positive(p.I_psi, 0)?;
    Ok([
        [0.0; 15], // psi'
        [0.0; 15], // eps'
        [0.0; 15], // theta'
        // psi''
        Parameters {
            l_oc: d_psi_ddot_by_l_oc,
            l_df: d_psi_ddot_by_l_df,
            c0_psi: -inv_psi * v.psi,
            I_psi: -inv_psi * tau_psi * inv_psi,
            ..Parameters::ZERO
        }
        .to_array(),
        // eps''
        Parameters {
            m_h: -inv_eps * by_m_h_1,
            m_b: d_eps_ddot_by_m_b,
            m_c: d_eps_ddot_by_m_c,
            g: -inv_eps * by_g_1,
            l_oc: d_eps_ddot_by_l_oc,
            l_ob: d_eps_ddot_by_l_ob,
            l_oa: d_eps_ddot_by_l_oa,
            l_cd: d_eps_ddot_by_l_cd,
            c0_eps: -inv_eps * v.eps,
            I_eps: -inv_eps * tau_eps * inv_eps,
            ..Parameters::ZERO
        }
        .to_array(),
        // theta''
        Parameters {
            m_h: d_theta_ddot_by_m_h,
            g: d_theta_ddot_by_g,
            l_cd: -inv_theta * m_h_g_c_eps * s_theta,
            l_df: f_d * inv_theta,
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
pub struct GoogolEq13;

impl Names for GoogolEq13 {
    fn rig(&self) -> &str {
        "GoogolEq13"
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

impl Model for GoogolEq13 {
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
