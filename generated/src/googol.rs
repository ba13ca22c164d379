//! Googol GHP2002 3-DOF helicopter, full physics.
//! Generated from `googol.rig` (model 55b1ef6d); edit the rig, not this file.
//!
//! Three bodies: arm and counterweight (point masses on the arm), and the fuselage with both rotors,
//! hanging l_cd below the pitch axis. Numbers: Table 1 of Li et al., Journal of Jilin University
//! (Engineering), 54(11), 2024, doi 10.13229/j.cnki.jdxbgxb.20220745; viscous friction as the authors
//! used it before identification, times the inertias.
//!
//! 175 operations forward, 637 with A and B.
//! Derived twice, body by body and by Lagrange: they agree; the power balance holds.
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
    };

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 14]) -> Self {
        let [m_h, m_b, m_c, g, l_oc, l_ob, l_oa, l_cd, l_df, I_x, I_z, c0_psi, c0_eps, c0_theta] = values;
        Self { m_h, m_b, m_c, g, l_oc, l_ob, l_oa, l_cd, l_df, I_x, I_z, c0_psi, c0_eps, c0_theta }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 14] {
        [
            self.m_h, self.m_b, self.m_c, self.g, self.l_oc, self.l_ob, self.l_oa, self.l_cd, self.l_df, self.I_x, self.I_z, self.c0_psi,
            self.c0_eps, self.c0_theta,
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
    // frame arm on column
    let I_arm_yy = p.m_b * p.l_oa * p.l_oa + p.m_c * p.l_ob * p.l_ob;
    // body fuselage on heli
    let mc_heli_z = -p.m_h * p.l_cd;
    let I_heli_yy = -p.l_cd * mc_heli_z;
    let I_heli_xx = p.I_x + I_heli_yy;
    // frame heli on arm
    let M_eps_theta = -p.l_oc * mc_heli_z * s_theta;
    let l_oc_mc_heli_z_c_theta = p.l_oc * mc_heli_z * c_theta;
    let M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    let I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p.I_z);
    let heli_1 = I_heli_yy_minus_I_z_c_theta * c_theta;
    let l_oc_m_h_l_oc = p.m_h * p.l_oc * p.l_oc;
    // frame arm on column
    let M_eps_eps = I_arm_yy + p.I_z + heli_1 + l_oc_m_h_l_oc;
    let M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    let arm_1 = c_eps * (I_arm_yy + I_heli_yy - heli_1 + l_oc_m_h_l_oc - I_heli_xx);
    let arm_2 = c_eps * (arm_1 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    [
        [I_heli_xx + arm_2, M_psi_eps, M_psi_theta], // psi
        [M_psi_eps, M_eps_eps, M_eps_theta], // eps
        [M_psi_theta, M_eps_theta, I_heli_xx], // theta
    ]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (psi, eps, theta).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_b_l_oa = p.m_b * p.l_oa;
    let m_c_l_ob = p.m_c * p.l_ob;
    // frame arm on column
    let I_arm_yy = p.l_oa * m_b_l_oa + p.l_ob * m_c_l_ob;
    let omega_arm_z = c_eps * v.psi;
    let omega_arm_x = s_eps * v.psi;
    let alpha_arm_x = omega_arm_z * v.eps;
    let alpha_arm_z = -omega_arm_x * v.eps;
    let omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    let a_arm_z = p.g * c_eps;
    let arm_1 = I_arm_yy * omega_arm_z_omega_arm_x + a_arm_z * (m_b_l_oa - m_c_l_ob);
    // body fuselage on heli
    let mc_heli_z = -p.m_h * p.l_cd;
    let I_heli_yy = -p.l_cd * mc_heli_z;
    let I_heli_xx = p.I_x + I_heli_yy;
    // frame heli on arm
    let omega_heli_y = -c_theta * v.eps - omega_arm_z * s_theta;
    let omega_heli_z = omega_arm_z * c_theta - s_theta * v.eps;
    let omega_heli_x = omega_arm_x - v.theta;
    let alpha_heli_y = -alpha_arm_z * s_theta - omega_heli_z * v.theta;
    let alpha_heli_z = omega_heli_y * v.theta + alpha_arm_z * c_theta;
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let heli_1 = I_heli_yy * alpha_heli_y + omega_heli_z * omega_heli_x * (I_heli_xx - p.I_z);
    let n_moving_heli_z = p.I_z * alpha_heli_z - p.I_x * omega_heli_y * omega_heli_x;
    let a_heli_1_x = -p.l_oc * (v.eps * v.eps + omega_arm_z * omega_arm_z);
    let a_heli_1_y = 2.0 * p.l_oc * alpha_arm_z;
    let a_heli_1_z = p.l_oc * omega_arm_z_omega_arm_x + a_arm_z;
    let a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    let a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    let f_heli_y = p.m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    let f_heli_z = p.m_h * a_heli_z - mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y);
    let n_heli_x = I_heli_xx * alpha_arm_x + omega_heli_y_omega_heli_z * (p.I_z - I_heli_yy) - mc_heli_z * a_heli_y;
    let n_heli_y = heli_1 + mc_heli_z * (p.g * s_eps + a_heli_1_x);
    let f_heli_1_y = f_heli_y * c_theta + f_heli_z * s_theta;
    let f_heli_1_z = f_heli_z * c_theta - f_heli_y * s_theta;
    let n_heli_1_y = n_moving_heli_z * s_theta + n_heli_y * c_theta;
    let n_heli_1_z = n_moving_heli_z * c_theta - n_heli_y * s_theta;
    // frame arm on column
    let n_arm_z = 2.0 * I_arm_yy * alpha_arm_z + n_heli_1_z + p.l_oc * f_heli_1_y;
    let h_eps = arm_1 - n_heli_1_y + p.l_oc * f_heli_1_z;
    let n_column_z = n_arm_z * c_eps + n_heli_x * s_eps;
    [n_column_z, h_eps, -n_heli_x]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (psi, eps, theta).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 3] {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    // frame arm on column
    let I_arm_yy = p.m_b * p.l_oa * p.l_oa + p.m_c * p.l_ob * p.l_ob;
    let omega_arm_z = c_eps * v.psi;
    let omega_arm_x = s_eps * v.psi;
    let alpha_arm_x = omega_arm_z * v.eps;
    let alpha_arm_z = -omega_arm_x * v.eps;
    let omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    // body fuselage on heli
    let mc_heli_z = -p.m_h * p.l_cd;
    let I_heli_yy = -p.l_cd * mc_heli_z;
    let I_heli_xx = p.I_x + I_heli_yy;
    // frame heli on arm
    let omega_heli_y = -c_theta * v.eps - omega_arm_z * s_theta;
    let omega_heli_z = omega_arm_z * c_theta - s_theta * v.eps;
    let omega_heli_x = omega_arm_x - v.theta;
    let alpha_heli_y = -alpha_arm_z * s_theta - omega_heli_z * v.theta;
    let alpha_heli_z = omega_heli_y * v.theta + alpha_arm_z * c_theta;
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let n_moving_heli_z = p.I_z * alpha_heli_z - p.I_x * omega_heli_y * omega_heli_x;
    let a_heli_1_x = -p.l_oc * (v.eps * v.eps + omega_arm_z * omega_arm_z);
    let a_heli_1_y = 2.0 * p.l_oc * alpha_arm_z;
    let a_heli_1_z = p.l_oc * omega_arm_z_omega_arm_x;
    let a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    let a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    let f_moving_heli_y = p.m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    let f_moving_heli_z = p.m_h * a_heli_z - mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y);
    let n_moving_heli_x = I_heli_xx * alpha_arm_x - mc_heli_z * a_heli_y + omega_heli_y_omega_heli_z * (p.I_z - I_heli_yy);
    let n_moving_heli_y = mc_heli_z * a_heli_1_x + I_heli_yy * alpha_heli_y + omega_heli_z * omega_heli_x * (I_heli_xx - p.I_z);
    let f_moving_heli_1_y = f_moving_heli_y * c_theta + f_moving_heli_z * s_theta;
    let f_moving_heli_1_z = f_moving_heli_z * c_theta - f_moving_heli_y * s_theta;
    let n_moving_heli_1_y = n_moving_heli_y * c_theta + n_moving_heli_z * s_theta;
    let n_moving_heli_1_z = n_moving_heli_z * c_theta - n_moving_heli_y * s_theta;
    // frame arm on column
    let n_moving_arm_z = 2.0 * I_arm_yy * alpha_arm_z + n_moving_heli_1_z + p.l_oc * f_moving_heli_1_y;
    let n_moving_column_z = n_moving_arm_z * c_eps + n_moving_heli_x * s_eps;
    [
        n_moving_column_z, // psi
        I_arm_yy * omega_arm_z_omega_arm_x - n_moving_heli_1_y + p.l_oc * f_moving_heli_1_z, // eps
        -n_moving_heli_x, // theta
    ]
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

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    // frame arm on column
    let omega_arm_z = c_eps * v.psi;
    // frame heli on arm
    let omega_heli_y = -c_theta * v.eps - omega_arm_z * s_theta;
    let omega_heli_z = omega_arm_z * c_theta - s_theta * v.eps;
    let omega_heli_x = s_eps * v.psi - v.theta;
    let l_oc_omega_arm_z = p.l_oc * omega_arm_z;
    let l_oc_eps_dot = p.l_oc * v.eps;
    let heli_1 = l_oc_omega_arm_z * c_theta - l_oc_eps_dot * s_theta;
    let heli_2 = l_oc_omega_arm_z * s_theta + l_oc_eps_dot * c_theta;
    let l_oa_omega_arm_z = p.l_oa * omega_arm_z;
    let l_oa_eps_dot = p.l_oa * v.eps;
    // body beam on arm
    let beam_1 = 0.5 * p.m_b * (l_oa_omega_arm_z * l_oa_omega_arm_z + l_oa_eps_dot * l_oa_eps_dot);
    let l_ob_omega_arm_z = p.l_ob * omega_arm_z;
    let l_ob_eps_dot = p.l_ob * v.eps;
    // body counterweight on arm
    let counterweight_1 = 0.5 * p.m_c * (l_ob_omega_arm_z * l_ob_omega_arm_z + l_ob_eps_dot * l_ob_eps_dot);
    let l_cd_omega_heli_y = p.l_cd * omega_heli_y;
    // body fuselage on heli
    let fuselage_1 = heli_1 + p.l_cd * omega_heli_x;
    let fuselage_2 = l_cd_omega_heli_y * l_cd_omega_heli_y + fuselage_1 * fuselage_1;
    let fuselage_3 = p.m_h * (heli_2 * heli_2 + fuselage_2);
    let fuselage_4 = 0.5 * (fuselage_3 + p.I_x * omega_heli_x * omega_heli_x + p.I_z * omega_heli_z * omega_heli_z);
    beam_1 + counterweight_1 + fuselage_4
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
    let m_b_l_oa = p.m_b * p.l_oa;
    let m_c_l_ob = p.m_c * p.l_ob;
    // frame arm on column
    let I_arm_yy = p.l_oa * m_b_l_oa + p.l_ob * m_c_l_ob;
    let omega_arm_z = c_eps * v.psi;
    let omega_arm_x = s_eps * v.psi;
    let alpha_arm_z = -omega_arm_x * v.eps;
    let omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    let a_arm_z = p.g * c_eps;
    let arm_1 = a_arm_z * (m_b_l_oa - m_c_l_ob);
    let alpha_arm_x = omega_arm_z * v.eps + s_eps * a.psi;
    let alpha_arm_z_2 = c_eps * a.psi + alpha_arm_z;
    let arm_2 = arm_1 + I_arm_yy * omega_arm_z_omega_arm_x + I_arm_yy * a.eps;
    // body fuselage on heli
    let mc_heli_z = -p.m_h * p.l_cd;
    let I_heli_yy = -p.l_cd * mc_heli_z;
    let I_heli_xx = p.I_x + I_heli_yy;
    // frame heli on arm
    let omega_heli_y = -c_theta * v.eps - omega_arm_z * s_theta;
    let omega_heli_z = omega_arm_z * c_theta - s_theta * v.eps;
    let omega_heli_x = omega_arm_x - v.theta;
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let alpha_heli_y = -omega_heli_z * v.theta - c_theta * a.eps - alpha_arm_z_2 * s_theta;
    let alpha_heli_z = alpha_arm_z_2 * c_theta - s_theta * a.eps + omega_heli_y * v.theta;
    let heli_1 = omega_heli_z * omega_heli_x * (I_heli_xx - p.I_z) + I_heli_yy * alpha_heli_y;
    let n_net_heli_z = p.I_z * alpha_heli_z - p.I_x * omega_heli_y * omega_heli_x;
    let a_heli_1_x = -p.l_oc * (v.eps * v.eps + omega_arm_z * omega_arm_z);
    let a_heli_1_y = p.l_oc * (alpha_arm_z_2 + alpha_arm_z);
    let a_heli_1_z = a_arm_z + p.l_oc * (a.eps + omega_arm_z_omega_arm_x);
    // force rotor_2 on heli
    let n_applied_heli_x = p.l_df * u.f_2 - p.l_df * u.f_1;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    let a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    let f_net_heli_y = p.m_h * a_heli_y + mc_heli_z * (a.theta - alpha_arm_x + omega_heli_y_omega_heli_z);
    let heli_2 = I_heli_xx * (alpha_arm_x - a.theta) - mc_heli_z * a_heli_y + omega_heli_y_omega_heli_z * (p.I_z - I_heli_yy);
    let n_net_heli_y = heli_1 + mc_heli_z * (p.g * s_eps + a_heli_1_x);
    let f_net_heli_z = p.m_h * a_heli_z - mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y) - u.f_1 - u.f_2;
    let f_net_heli_1_y = f_net_heli_y * c_theta + f_net_heli_z * s_theta;
    let f_net_heli_1_z = f_net_heli_z * c_theta - f_net_heli_y * s_theta;
    let n_net_heli_1_y = n_net_heli_y * c_theta + n_net_heli_z * s_theta;
    let n_net_heli_1_z = n_net_heli_z * c_theta - n_net_heli_y * s_theta;
    // frame arm on column
    let n_net_arm_z = I_arm_yy * alpha_arm_z_2 + I_arm_yy * alpha_arm_z + n_net_heli_1_z + p.l_oc * f_net_heli_1_y;
    let n_net_column_z = n_net_arm_z * c_eps + s_eps * (heli_2 - n_applied_heli_x);
    [
        p.c0_psi * v.psi + n_net_column_z, // psi
        p.c0_eps * v.eps + arm_2 - n_net_heli_1_y + p.l_oc * f_net_heli_1_z, // eps
        p.c0_theta * v.theta + n_applied_heli_x - heli_2, // theta
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
    // frame arm on column
    let I_arm_yy = p.m_b * p.l_oa * p.l_oa + p.m_c * p.l_ob * p.l_ob;
    // body fuselage on heli
    let mc_heli_z = -p.m_h * p.l_cd;
    let I_heli_yy = -p.l_cd * mc_heli_z;
    let I_heli_xx = p.I_x + I_heli_yy;
    // frame heli on arm
    let M_eps_theta = -p.l_oc * mc_heli_z * s_theta;
    let l_oc_mc_heli_z_c_theta = p.l_oc * mc_heli_z * c_theta;
    let M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    let I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p.I_z);
    let heli_1 = I_heli_yy_minus_I_z_c_theta * c_theta;
    let l_oc_m_h_l_oc = p.m_h * p.l_oc * p.l_oc;
    // frame arm on column
    let M_eps_eps = I_arm_yy + p.I_z + heli_1 + l_oc_m_h_l_oc;
    let M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    let arm_1 = c_eps * (I_arm_yy + I_heli_yy - heli_1 + l_oc_m_h_l_oc - I_heli_xx);
    let arm_2 = c_eps * (arm_1 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / I_heli_xx;
    let l_theta_eps = M_eps_theta * inv_theta;
    let pivot_eps = M_eps_eps - M_eps_theta * l_theta_eps;
    let solve_1 = M_psi_eps - M_psi_theta * l_theta_eps;
    let solve_2 = I_heli_xx + arm_2 - solve_1 * solve_1 / pivot_eps;
    let pivot_psi = solve_2 - M_psi_theta * M_psi_theta * inv_theta;
    [pivot_psi, pivot_eps, I_heli_xx]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 175 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_b_l_oa = p.m_b * p.l_oa;
    let m_c_l_ob = p.m_c * p.l_ob;
    // frame arm on column
    let I_arm_yy = p.l_oa * m_b_l_oa + p.l_ob * m_c_l_ob;
    let omega_arm_z = c_eps * v.psi;
    let omega_arm_x = s_eps * v.psi;
    let alpha_arm_x = omega_arm_z * v.eps;
    let alpha_arm_z = -omega_arm_x * v.eps;
    let omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    let a_arm_z = p.g * c_eps;
    let arm_1 = I_arm_yy * omega_arm_z_omega_arm_x + a_arm_z * (m_b_l_oa - m_c_l_ob);
    // body fuselage on heli
    let mc_heli_z = -p.m_h * p.l_cd;
    let I_heli_yy = -p.l_cd * mc_heli_z;
    let I_heli_xx = p.I_x + I_heli_yy;
    // frame heli on arm
    let omega_heli_y = -c_theta * v.eps - omega_arm_z * s_theta;
    let omega_heli_z = omega_arm_z * c_theta - s_theta * v.eps;
    let omega_heli_x = omega_arm_x - v.theta;
    let alpha_heli_y = -alpha_arm_z * s_theta - omega_heli_z * v.theta;
    let alpha_heli_z = omega_heli_y * v.theta + alpha_arm_z * c_theta;
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let heli_1 = I_heli_yy * alpha_heli_y + omega_heli_z * omega_heli_x * (I_heli_xx - p.I_z);
    let n_moving_heli_z = p.I_z * alpha_heli_z - p.I_x * omega_heli_y * omega_heli_x;
    let M_eps_theta = -p.l_oc * mc_heli_z * s_theta;
    let l_oc_mc_heli_z_c_theta = p.l_oc * mc_heli_z * c_theta;
    let M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    let I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p.I_z);
    let heli_2 = I_heli_yy_minus_I_z_c_theta * c_theta;
    let a_heli_1_x = -p.l_oc * (v.eps * v.eps + omega_arm_z * omega_arm_z);
    let a_heli_1_y = 2.0 * p.l_oc * alpha_arm_z;
    let a_heli_1_z = p.l_oc * omega_arm_z_omega_arm_x + a_arm_z;
    let l_oc_m_h_l_oc = p.m_h * p.l_oc * p.l_oc;
    let a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    let a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    let f_heli_y = p.m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    let f_heli_z = p.m_h * a_heli_z - mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y);
    let n_heli_x = I_heli_xx * alpha_arm_x + omega_heli_y_omega_heli_z * (p.I_z - I_heli_yy) - mc_heli_z * a_heli_y;
    let n_heli_y = heli_1 + mc_heli_z * (p.g * s_eps + a_heli_1_x);
    let n_heli_1_y = n_moving_heli_z * s_theta + n_heli_y * c_theta;
    let n_heli_1_z = n_moving_heli_z * c_theta - n_heli_y * s_theta;
    let f_net_heli_z = f_heli_z - u.f_1 - u.f_2;
    let f_net_heli_1_y = f_heli_y * c_theta + f_net_heli_z * s_theta;
    let f_net_heli_1_z = f_net_heli_z * c_theta - f_heli_y * s_theta;
    // frame arm on column
    let M_eps_eps = I_arm_yy + p.I_z + heli_2 + l_oc_m_h_l_oc;
    let M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    let arm_2 = c_eps * (I_arm_yy + I_heli_yy - heli_2 + l_oc_m_h_l_oc - I_heli_xx);
    let arm_3 = c_eps * (arm_2 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    let n_net_arm_z = 2.0 * I_arm_yy * alpha_arm_z + n_heli_1_z + p.l_oc * f_net_heli_1_y;
    // force rotor_2 on heli
    let n_applied_heli_x = p.l_df * u.f_2 - p.l_df * u.f_1;
    // frame arm on column
    let n_net_column_z = n_net_arm_z * c_eps + s_eps * (n_heli_x - n_applied_heli_x);
    // balance of forces
    let tau_eps = n_heli_1_y - p.c0_eps * v.eps - arm_1 - p.l_oc * f_net_heli_1_z;
    let tau_theta = n_heli_x - p.c0_theta * v.theta - n_applied_heli_x;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / I_heli_xx;
    let l_theta_psi = M_psi_theta * inv_theta;
    let l_theta_eps = M_eps_theta * inv_theta;
    let pivot_eps = M_eps_eps - M_eps_theta * l_theta_eps;
    let inv_eps = 1.0 / pivot_eps;
    let solve_1 = M_psi_eps - M_psi_theta * l_theta_eps;
    let l_eps_psi = inv_eps * solve_1;
    let pivot_psi = I_heli_xx + arm_3 - solve_1 * l_eps_psi - M_psi_theta * l_theta_psi;
    let solve_2 = tau_eps - tau_theta * l_theta_eps;
    let psi_ddot = -(p.c0_psi * v.psi + n_net_column_z + l_eps_psi * solve_2 + tau_theta * l_theta_psi) / pivot_psi;
    let eps_ddot = inv_eps * solve_2 - l_eps_psi * psi_ddot;
    let theta_ddot = tau_theta * inv_theta - l_theta_psi * psi_ddot - l_theta_eps * eps_ddot;
    positive(I_heli_xx, 2)?;
    positive(pivot_eps, 1)?;
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
/// 637 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///          psi eps theta psi.dot eps.dot theta.dot | f_1 f_2
/// psi'     .   .   .     1       .       .         | .   .
/// eps'     .   .   .     .       1       .         | .   .
/// theta'   .   .   .     .       .       1         | .   .
/// psi''    .   *   *     *       *       *         | *   *
/// eps''    .   *   *     *       *       *         | *   *
/// theta''  .   *   *     *       *       *         | *   *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_b_l_oa = p.m_b * p.l_oa;
    let m_c_l_ob = p.m_c * p.l_ob;
    let f_s = u.f_1 + u.f_2;
    // frame arm on column
    let mc_arm_x = m_b_l_oa - m_c_l_ob;
    let I_arm_yy = p.l_oa * m_b_l_oa + p.l_ob * m_c_l_ob;
    let omega_arm_z = c_eps * v.psi;
    let omega_arm_x = s_eps * v.psi;
    let alpha_arm_x = omega_arm_z * v.eps;
    let alpha_arm_z = -omega_arm_x * v.eps;
    let omega_arm_z_sq = omega_arm_z * omega_arm_z;
    let omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    let I_arm_yy_alpha_arm_z = I_arm_yy * alpha_arm_z;
    let arm_1 = omega_arm_z_sq - omega_arm_x * omega_arm_x;
    let a_arm_z = p.g * c_eps;
    let a_arm_x = p.g * s_eps;
    // body fuselage on heli
    let mc_heli_z = -p.m_h * p.l_cd;
    let I_heli_yy = -p.l_cd * mc_heli_z;
    let I_heli_xx = p.I_x + I_heli_yy;
    let s_theta_eps_dot = s_theta * v.eps;
    let omega_arm_z_c_theta = omega_arm_z * c_theta;
    // frame heli on arm
    let omega_heli_y = -c_theta * v.eps - omega_arm_z * s_theta;
    let omega_heli_z = omega_arm_z_c_theta - s_theta_eps_dot;
    let omega_heli_x = omega_arm_x - v.theta;
    let omega_heli_z_theta_dot = omega_heli_z * v.theta;
    let omega_heli_y_theta_dot = omega_heli_y * v.theta;
    let omega_heli_z_omega_heli_x = omega_heli_z * omega_heli_x;
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let omega_heli_y_sq = omega_heli_y * omega_heli_y;
    let heli_1 = mc_heli_z * (omega_heli_x * omega_heli_x + omega_heli_y_sq);
    let I_z_minus_I_heli_yy = p.I_z - I_heli_yy;
    let heli_2 = omega_heli_y_omega_heli_z * I_z_minus_I_heli_yy;
    let omega_heli_z_sq = omega_heli_z * omega_heli_z;
    let omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    let I_heli_xx_minus_I_z = I_heli_xx - p.I_z;
    let heli_3 = omega_heli_z_omega_heli_x * I_heli_xx_minus_I_z;
    let heli_4 = p.I_x * omega_heli_y_omega_heli_x;
    let heli_5 = I_heli_yy * (-alpha_arm_z * s_theta - omega_heli_z_theta_dot) + heli_3;
    let n_moving_heli_z = -heli_4 - p.I_z * (-omega_heli_y_theta_dot - alpha_arm_z * c_theta);
    let M_eps_theta = -p.l_oc * mc_heli_z * s_theta;
    let l_oc_mc_heli_z_c_theta = p.l_oc * mc_heli_z * c_theta;
    let M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    let I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p.I_z);
    let heli_6 = I_heli_yy_minus_I_z_c_theta * c_theta;
    let a_heli_1_x = -p.l_oc * (v.eps * v.eps + omega_arm_z_sq);
    let a_heli_1_y = 2.0 * p.l_oc * alpha_arm_z;
    let a_heli_1_z = p.l_oc * omega_arm_z_omega_arm_x + a_arm_z;
    let l_oc_m_h_l_oc = p.m_h * p.l_oc * p.l_oc;
    let a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    let a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    let f_heli_y = p.m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    let heli_7 = mc_heli_z * (a_arm_x + a_heli_1_x);
    let n_heli_x = I_heli_xx * alpha_arm_x + heli_2 - mc_heli_z * a_heli_y;
    let n_heli_y = heli_5 + heli_7;
    let n_heli_1_y = n_moving_heli_z * s_theta + n_heli_y * c_theta;
    let n_heli_1_z = n_moving_heli_z * c_theta - n_heli_y * s_theta;
    let f_net_heli_z = p.m_h * a_heli_z - heli_1 - f_s;
    let f_net_heli_1_y = f_heli_y * c_theta + f_net_heli_z * s_theta;
    let f_net_heli_1_z = f_net_heli_z * c_theta - f_heli_y * s_theta;
    // frame arm on column
    let M_eps_eps = I_arm_yy + p.I_z + heli_6 + l_oc_m_h_l_oc;
    let M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    let arm_2 = c_eps * (I_arm_yy + I_heli_yy - heli_6 + l_oc_m_h_l_oc - I_heli_xx);
    let arm_3 = c_eps * (arm_2 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    let n_net_arm_z = 2.0 * I_arm_yy_alpha_arm_z + n_heli_1_z + p.l_oc * f_net_heli_1_y;
    let arm_4 = I_arm_yy * omega_arm_z_omega_arm_x + mc_arm_x * a_arm_z - n_heli_1_y + p.l_oc * f_net_heli_1_z;
    // force rotor_2 on heli
    let n_applied_heli_x = p.l_df * u.f_2 - p.l_df * u.f_1;
    let c_eps_s_theta = c_eps * s_theta;
    let c_eps_c_theta = c_eps * c_theta;
    let l_oc_c_theta = p.l_oc * c_theta;
    let c_eps_eps_dot = c_eps * v.eps;
    let s_eps_eps_dot = s_eps * v.eps;
    let omega_arm_x_s_theta = omega_arm_x * s_theta;
    let omega_arm_x_c_theta = omega_arm_x * c_theta;
    // frame arm on column
    let n_net_column_z = n_net_arm_z * c_eps + s_eps * (n_heli_x - n_applied_heli_x);
    // balance of forces
    let tau_theta = n_heli_x - p.c0_theta * v.theta - n_applied_heli_x;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / I_heli_xx;
    let l_theta_psi = M_psi_theta * inv_theta;
    let l_theta_eps = M_eps_theta * inv_theta;
    let pivot_eps = M_eps_eps - M_eps_theta * l_theta_eps;
    let inv_eps = 1.0 / pivot_eps;
    let solve_1 = M_psi_eps - M_psi_theta * l_theta_eps;
    let l_eps_psi = inv_eps * solve_1;
    let pivot_psi = I_heli_xx + arm_3 - solve_1 * l_eps_psi - M_psi_theta * l_theta_psi;
    let inv_psi = 1.0 / pivot_psi;
    let solve_2 = tau_theta * l_theta_eps + p.c0_eps * v.eps + arm_4;
    let psi_ddot = -inv_psi * (p.c0_psi * v.psi + n_net_column_z - l_eps_psi * solve_2 + tau_theta * l_theta_psi);
    let eps_ddot = -inv_eps * solve_2 - l_eps_psi * psi_ddot;
    let theta_ddot = tau_theta * inv_theta - l_theta_psi * psi_ddot - l_theta_eps * eps_ddot;
    let l_oc_c_eps_s_theta = p.l_oc * c_eps * s_theta;
    let l_df_s_eps = p.l_df * s_eps;
    let two_omega_arm_z = 2.0 * omega_arm_z;
    // derivatives with respect to eps
    let by_eps_1 = omega_heli_z * omega_arm_x_s_theta - omega_heli_y * omega_arm_x_c_theta;
    let two_omega_heli_x = 2.0 * omega_heli_x;
    let two_omega_heli_y = 2.0 * omega_heli_y;
    let by_eps_2 = mc_heli_z * (omega_arm_z * two_omega_heli_x + omega_arm_x_s_theta * two_omega_heli_y);
    let by_eps_3 = I_heli_xx_minus_I_z * (omega_arm_z * omega_heli_z - omega_heli_x * omega_arm_x_c_theta);
    let by_eps_4 = mc_heli_z * (a_arm_z + p.l_oc * omega_arm_x * two_omega_arm_z);
    let l_oc_arm_1_minus_a_arm_x = p.l_oc * arm_1 - a_arm_x;
    // derivatives with respect to psi_dot
    let by_psi_dot_1 = omega_arm_x * c_eps + omega_arm_z * s_eps;
    let by_psi_dot_2 = omega_heli_z * c_eps_s_theta - omega_heli_y * c_eps_c_theta;
    let by_psi_dot_3 = mc_heli_z * (two_omega_heli_x * s_eps - c_eps_s_theta * two_omega_heli_y);
    let by_psi_dot_4 = I_heli_xx_minus_I_z * (omega_heli_x * c_eps_c_theta + omega_heli_z * s_eps);
    let by_psi_dot_5 = p.l_oc * mc_heli_z * two_omega_arm_z * c_eps;
    let two_l_oc_s_eps_eps_dot = 2.0 * p.l_oc * s_eps_eps_dot;
    let l_oc_by_psi_dot_1 = p.l_oc * by_psi_dot_1;
    let by_psi_dot_6 = two_l_oc_s_eps_eps_dot * c_theta + l_oc_by_psi_dot_1 * s_theta;
    let by_psi_dot_7 = p.m_h * (l_oc_by_psi_dot_1 * c_theta - two_l_oc_s_eps_eps_dot * s_theta);
    let by_psi_dot_8 = p.m_h * by_psi_dot_6 + mc_heli_z * (c_eps_eps_dot + by_psi_dot_2);
    let by_psi_dot_9 = by_psi_dot_7 - by_psi_dot_3;
    let by_psi_dot_10 = I_heli_yy * (c_eps_c_theta * v.theta - s_eps_eps_dot * s_theta);
    let by_psi_dot_11 = p.I_z * (s_eps_eps_dot * c_theta + c_eps_s_theta * v.theta);
    let by_psi_dot_12 = I_heli_xx * c_eps_eps_dot - I_z_minus_I_heli_yy * by_psi_dot_2;
    let by_psi_dot_13 = p.I_x * (omega_heli_x * c_eps_s_theta - omega_heli_y * s_eps) - by_psi_dot_11;
    let by_psi_dot_14 = mc_heli_z * by_psi_dot_6 + by_psi_dot_12;
    let by_psi_dot_15 = by_psi_dot_4 - by_psi_dot_5 - by_psi_dot_10;
    let by_psi_dot_16 = by_psi_dot_15 * c_theta + by_psi_dot_13 * s_theta;
    let by_psi_dot_17 = by_psi_dot_13 * c_theta - by_psi_dot_15 * s_theta;
    let by_psi_dot_18 = p.l_oc * (by_psi_dot_9 * c_theta + by_psi_dot_8 * s_theta);
    let by_psi_dot_19 = p.l_oc * (by_psi_dot_9 * s_theta - by_psi_dot_8 * c_theta);
    let by_psi_dot_20 = by_psi_dot_17 - 2.0 * I_arm_yy * s_eps_eps_dot + by_psi_dot_19;
    let by_psi_dot_21 = p.c0_psi + by_psi_dot_20 * c_eps + by_psi_dot_14 * s_eps;
    let by_psi_dot_22 = by_psi_dot_16 - by_psi_dot_18 - I_arm_yy * by_psi_dot_1;
    let by_psi_dot_23 = by_psi_dot_22 - l_theta_eps * by_psi_dot_14;
    let d_psi_ddot_by_psi_dot = inv_psi * (-l_theta_psi * by_psi_dot_14 - by_psi_dot_21 - l_eps_psi * by_psi_dot_23);
    let d_eps_ddot_by_psi_dot = inv_eps * by_psi_dot_23 - l_eps_psi * d_psi_ddot_by_psi_dot;
    let d_theta_ddot_by_psi_dot = inv_theta * by_psi_dot_14 - l_theta_psi * d_psi_ddot_by_psi_dot - l_theta_eps * d_eps_ddot_by_psi_dot;
    // derivatives with respect to eps_dot
    let by_eps_dot_1 = omega_heli_z * c_theta + omega_heli_y * s_theta;
    let by_eps_dot_2 = mc_heli_z * two_omega_heli_y * c_theta;
    let two_l_oc_omega_arm_x = 2.0 * p.l_oc * omega_arm_x;
    let two_l_oc_omega_arm_x_c_theta = two_l_oc_omega_arm_x * c_theta;
    let by_eps_dot_3 = p.m_h * two_l_oc_omega_arm_x_c_theta + mc_heli_z * (omega_arm_z + by_eps_dot_1);
    let by_eps_dot_4 = by_eps_dot_2 - p.m_h * two_l_oc_omega_arm_x * s_theta;
    let by_eps_dot_5 = I_heli_yy * (s_theta * v.theta + omega_arm_x_s_theta);
    let by_eps_dot_6 = p.I_z * (c_theta * v.theta + omega_arm_x_c_theta);
    let by_eps_dot_7 = by_eps_dot_5 - I_heli_xx_minus_I_z * omega_heli_x * s_theta;
    let by_eps_dot_8 = p.I_x * omega_heli_x * c_theta - by_eps_dot_6;
    let by_eps_dot_9 = mc_heli_z * two_l_oc_omega_arm_x_c_theta + I_heli_xx * omega_arm_z - I_z_minus_I_heli_yy * by_eps_dot_1;
    let by_eps_dot_10 = by_eps_dot_7 - 2.0 * p.l_oc * mc_heli_z * v.eps;
    let by_eps_dot_11 = by_eps_dot_10 * c_theta + by_eps_dot_8 * s_theta;
    let by_eps_dot_12 = by_eps_dot_8 * c_theta - by_eps_dot_10 * s_theta;
    let by_eps_dot_13 = p.l_oc * (by_eps_dot_4 * c_theta + by_eps_dot_3 * s_theta);
    let by_eps_dot_14 = p.l_oc * (by_eps_dot_4 * s_theta - by_eps_dot_3 * c_theta);
    let by_eps_dot_15 = c_eps * (by_eps_dot_12 - 2.0 * I_arm_yy * omega_arm_x + by_eps_dot_14);
    let by_eps_dot_16 = p.c0_eps + by_eps_dot_13 - by_eps_dot_11 + l_theta_eps * by_eps_dot_9;
    let by_eps_dot_17 = l_eps_psi * by_eps_dot_16 - by_eps_dot_15 - by_eps_dot_9 * s_eps;
    let d_psi_ddot_by_eps_dot = inv_psi * (by_eps_dot_17 - l_theta_psi * by_eps_dot_9);
    let d_eps_ddot_by_eps_dot = -inv_eps * by_eps_dot_16 - l_eps_psi * d_psi_ddot_by_eps_dot;
    let d_theta_ddot_by_eps_dot = inv_theta * by_eps_dot_9 - l_theta_psi * d_psi_ddot_by_eps_dot - l_theta_eps * d_eps_ddot_by_eps_dot;
    let two_mc_heli_z_omega_heli_x = 2.0 * mc_heli_z * omega_heli_x;
    // derivatives with respect to theta_dot
    let by_theta_dot_1 = I_heli_xx_minus_I_z * (s_theta_eps_dot - omega_arm_z_c_theta) - I_heli_yy * omega_heli_z;
    let by_theta_dot_2 = p.I_z * omega_heli_y + p.I_x * omega_heli_y;
    let by_theta_dot_3 = by_theta_dot_1 * c_theta + by_theta_dot_2 * s_theta;
    let by_theta_dot_4 = by_theta_dot_1 * s_theta - by_theta_dot_2 * c_theta;
    let by_theta_dot_5 = c_eps * (p.l_oc * two_mc_heli_z_omega_heli_x * s_theta - by_theta_dot_4);
    let by_theta_dot_6 = by_theta_dot_3 - p.l_oc * two_mc_heli_z_omega_heli_x * c_theta + p.c0_theta * l_theta_eps;
    let d_psi_ddot_by_theta_dot = -inv_psi * (by_theta_dot_5 + l_eps_psi * by_theta_dot_6 - p.c0_theta * l_theta_psi);
    let d_eps_ddot_by_theta_dot = inv_eps * by_theta_dot_6 - l_eps_psi * d_psi_ddot_by_theta_dot;
    let d_theta_ddot_by_theta_dot = -p.c0_theta * inv_theta - l_theta_psi * d_psi_ddot_by_theta_dot - l_theta_eps * d_eps_ddot_by_theta_dot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_arm_x + psi_ddot * s_eps;
    let slopes_2 = alpha_arm_z + psi_ddot * c_eps;
    let slopes_3 = p.l_oc * (-alpha_arm_z - slopes_2);
    let slopes_4 = a_arm_z + p.l_oc * (omega_arm_z_omega_arm_x + eps_ddot);
    let slopes_5 = omega_heli_z_theta_dot + eps_ddot * c_theta + slopes_2 * s_theta;
    let slopes_6 = eps_ddot * s_theta - omega_heli_y_theta_dot - slopes_2 * c_theta;
    let slopes_1_minus_theta_ddot = slopes_1 - theta_ddot;
    let slopes_7 = slopes_3 * c_theta + slopes_4 * s_theta;
    let slopes_8 = slopes_4 * c_theta - slopes_3 * s_theta;
    let m_h_slopes_7 = p.m_h * slopes_7;
    let m_h_slopes_8 = p.m_h * slopes_8;
    let slopes_9 = mc_heli_z * (slopes_1_minus_theta_ddot - omega_heli_y_omega_heli_z) + m_h_slopes_7;
    let heli_4_plus_I_z_slopes_6 = heli_4 + p.I_z * slopes_6;
    let slopes_10 = I_heli_xx * slopes_1_minus_theta_ddot + heli_2 + mc_heli_z * slopes_7;
    let slopes_11 = heli_3 - I_heli_yy * slopes_5 + heli_7;
    let slopes_12 = m_h_slopes_8 - heli_1 - f_s;
    let slopes_9_c_theta = slopes_9 * c_theta;
    let slopes_12_s_theta = slopes_12 * s_theta;
    let slopes_11_s_theta = slopes_11 * s_theta;
    let slopes_13 = heli_4_plus_I_z_slopes_6 * c_theta;
    let slopes_14 = p.l_oc * (slopes_12_s_theta - slopes_9_c_theta) - slopes_13 - slopes_11_s_theta;
    let slopes_15 = s_eps * (slopes_14 + I_arm_yy_alpha_arm_z + I_arm_yy * slopes_2);
    let slopes_16 = c_eps * (slopes_10 - n_applied_heli_x);
    let slopes_17 = p.l_oc * (alpha_arm_x + slopes_1);
    let slopes_18 = l_oc_arm_1_minus_a_arm_x * s_theta + slopes_17 * c_theta;
    let slopes_19 = p.m_h * (l_oc_arm_1_minus_a_arm_x * c_theta - slopes_17 * s_theta);
    let slopes_20 = p.m_h * slopes_18 - mc_heli_z * (by_eps_1 - slopes_2);
    let slopes_19_minus_by_eps_2 = slopes_19 - by_eps_2;
    let slopes_21 = I_heli_yy * (omega_arm_x_c_theta * v.theta + slopes_1 * s_theta);
    let slopes_22 = p.I_z * (omega_arm_x_s_theta * v.theta - slopes_1 * c_theta);
    let slopes_23 = I_z_minus_I_heli_yy * by_eps_1 + I_heli_xx * slopes_2;
    let slopes_24 = p.I_x * (-omega_arm_z * omega_heli_y - omega_heli_x * omega_arm_x_s_theta) + slopes_22;
    let slopes_25 = slopes_23 + mc_heli_z * slopes_18;
    let slopes_26 = by_eps_3 + slopes_21 + by_eps_4;
    let slopes_27 = slopes_26 * c_theta + slopes_24 * s_theta;
    let slopes_28 = slopes_24 * c_theta - slopes_26 * s_theta;
    let slopes_29 = p.l_oc * (slopes_20 * s_theta + slopes_19_minus_by_eps_2 * c_theta);
    let slopes_30 = p.l_oc * (slopes_19_minus_by_eps_2 * s_theta - slopes_20 * c_theta);
    let slopes_31 = slopes_28 + slopes_30 - I_arm_yy * alpha_arm_x - I_arm_yy * slopes_1;
    let slopes_32 = slopes_16 + slopes_25 * s_eps;
    let slopes_33 = slopes_31 * c_eps - slopes_15 + slopes_32;
    let slopes_34 = m_h_slopes_8 - mc_heli_z * (omega_heli_y_sq - omega_heli_z_sq);
    let slopes_35 = mc_heli_z * omega_heli_z * two_omega_heli_y - m_h_slopes_7;
    let slopes_36 = omega_heli_y_omega_heli_x * I_heli_xx_minus_I_z + I_heli_yy * slopes_6;
    let slopes_37 = p.I_x * omega_heli_z_omega_heli_x - p.I_z * slopes_5;
    let slopes_38 = I_z_minus_I_heli_yy * (omega_heli_z_sq - omega_heli_y_sq) - mc_heli_z * slopes_8;
    let slopes_39 = slopes_34 * c_theta - slopes_9 * s_theta;
    let slopes_40 = slopes_12 * c_theta + slopes_35 * s_theta;
    let slopes_41 = slopes_9_c_theta + slopes_34 * s_theta;
    let slopes_42 = slopes_11_s_theta - slopes_36 * c_theta;
    let slopes_43 = slopes_11 * c_theta + slopes_36 * s_theta;
    let slopes_44 = slopes_37 * c_theta + heli_4_plus_I_z_slopes_6 * s_theta;
    let slopes_45 = slopes_37 * s_theta - slopes_13 - slopes_42;
    let slopes_46 = p.l_oc * (slopes_35 * c_theta - slopes_12_s_theta + slopes_41);
    let slopes_47 = slopes_44 - slopes_43 + p.l_oc * (slopes_40 - slopes_39);
    // derivatives with respect to eps
    let by_eps_5 = slopes_27 - slopes_29 - I_arm_yy * arm_1 + mc_arm_x * a_arm_x;
    let by_eps_6 = by_eps_5 - l_theta_eps * slopes_25;
    let d_psi_ddot_by_eps = inv_psi * (-l_theta_psi * slopes_25 - slopes_33 - l_eps_psi * by_eps_6);
    let d_eps_ddot_by_eps = inv_eps * by_eps_6 - l_eps_psi * d_psi_ddot_by_eps;
    let d_theta_ddot_by_eps = inv_theta * slopes_25 - l_theta_psi * d_psi_ddot_by_eps - l_theta_eps * d_eps_ddot_by_eps;
    // derivatives with respect to theta
    let by_theta_1 = slopes_38 * s_eps - slopes_47 * c_eps;
    let by_theta_2 = slopes_45 - slopes_46 + l_theta_eps * slopes_38;
    let d_psi_ddot_by_theta = inv_psi * (by_theta_1 - l_eps_psi * by_theta_2 + l_theta_psi * slopes_38);
    let d_eps_ddot_by_theta = inv_eps * by_theta_2 - l_eps_psi * d_psi_ddot_by_theta;
    let d_theta_ddot_by_theta = -l_theta_psi * d_psi_ddot_by_theta - inv_theta * slopes_38 - l_theta_eps * d_eps_ddot_by_theta;
    let l_df_l_theta_eps = p.l_df * l_theta_eps;
    // derivatives with respect to f_1
    let by_f_1_1 = l_oc_c_theta - l_df_l_theta_eps;
    let l_df_l_theta_psi = p.l_df * l_theta_psi;
    let by_f_1_2 = l_oc_c_eps_s_theta - l_df_s_eps - l_eps_psi * by_f_1_1 - l_df_l_theta_psi;
    let d_psi_ddot_by_f_1 = inv_psi * by_f_1_2;
    let l_df_inv_theta = p.l_df * inv_theta;
    let d_eps_ddot_by_f_1 = inv_eps * by_f_1_1 - l_eps_psi * d_psi_ddot_by_f_1;
    let d_theta_ddot_by_f_1 = l_df_inv_theta - l_theta_psi * d_psi_ddot_by_f_1 - l_theta_eps * d_eps_ddot_by_f_1;
    // derivatives with respect to f_2
    let by_f_2_1 = l_oc_c_theta + l_df_l_theta_eps;
    let by_f_2_2 = l_oc_c_eps_s_theta + l_df_s_eps - l_eps_psi * by_f_2_1 + l_df_l_theta_psi;
    let d_psi_ddot_by_f_2 = inv_psi * by_f_2_2;
    let d_eps_ddot_by_f_2 = inv_eps * by_f_2_1 - l_eps_psi * d_psi_ddot_by_f_2;
    let d_theta_ddot_by_f_2 = -l_theta_psi * d_psi_ddot_by_f_2 - l_df_inv_theta - l_theta_eps * d_eps_ddot_by_f_2;
    positive(I_heli_xx, 2)?;
    positive(pivot_eps, 1)?;
    positive(pivot_psi, 0)?;
    Ok(Linearization {
        dx: [v.psi, v.eps, v.theta, psi_ddot, eps_ddot, theta_ddot],
        a: [
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0], // psi'
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0], // eps'
            [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], // theta'
            [0.0, d_psi_ddot_by_eps, d_psi_ddot_by_theta, d_psi_ddot_by_psi_dot, d_psi_ddot_by_eps_dot, d_psi_ddot_by_theta_dot], // psi''
            [0.0, d_eps_ddot_by_eps, d_eps_ddot_by_theta, d_eps_ddot_by_psi_dot, d_eps_ddot_by_eps_dot, d_eps_ddot_by_theta_dot], // eps''
            // theta''
            [0.0, d_theta_ddot_by_eps, d_theta_ddot_by_theta, d_theta_ddot_by_psi_dot, d_theta_ddot_by_eps_dot, d_theta_ddot_by_theta_dot],
        ],
        b: [
            [0.0, 0.0], // psi'
            [0.0, 0.0], // eps'
            [0.0, 0.0], // theta'
            [d_psi_ddot_by_f_1, d_psi_ddot_by_f_2], // psi''
            [d_eps_ddot_by_f_1, d_eps_ddot_by_f_2], // eps''
            [d_theta_ddot_by_f_1, d_theta_ddot_by_f_2], // theta''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 6 x 14; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 14]; 6], Singular> {
    let State { q, v } = x;
    let (s_eps, c_eps) = sin_cos(q.eps);
    let (s_theta, c_theta) = sin_cos(q.theta);
    let m_b_l_oa = p.m_b * p.l_oa;
    let m_c_l_ob = p.m_c * p.l_ob;
    let f_s = u.f_1 + u.f_2;
    let f_d = u.f_1 - u.f_2;
    // frame arm on column
    let mc_arm_x = m_b_l_oa - m_c_l_ob;
    let I_arm_yy = p.l_oa * m_b_l_oa + p.l_ob * m_c_l_ob;
    let omega_arm_z = c_eps * v.psi;
    let omega_arm_x = s_eps * v.psi;
    let alpha_arm_x = omega_arm_z * v.eps;
    let alpha_arm_z = -omega_arm_x * v.eps;
    let arm_1 = v.eps * v.eps + omega_arm_z * omega_arm_z;
    let omega_arm_z_omega_arm_x = omega_arm_z * omega_arm_x;
    let a_arm_z = p.g * c_eps;
    // body fuselage on heli
    let mc_heli_z = -p.m_h * p.l_cd;
    let I_heli_yy = -p.l_cd * mc_heli_z;
    let I_heli_xx = p.I_x + I_heli_yy;
    // frame heli on arm
    let omega_heli_y = -c_theta * v.eps - omega_arm_z * s_theta;
    let omega_heli_z = omega_arm_z * c_theta - s_theta * v.eps;
    let omega_heli_x = omega_arm_x - v.theta;
    let omega_heli_z_theta_dot = omega_heli_z * v.theta;
    let omega_heli_y_theta_dot = omega_heli_y * v.theta;
    let omega_heli_z_omega_heli_x = omega_heli_z * omega_heli_x;
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let heli_1 = omega_heli_x * omega_heli_x + omega_heli_y * omega_heli_y;
    let mc_heli_z_heli_1 = mc_heli_z * heli_1;
    let heli_2 = I_heli_yy * (-alpha_arm_z * s_theta - omega_heli_z_theta_dot);
    let omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    let n_moving_heli_z = -p.I_x * omega_heli_y_omega_heli_x - p.I_z * (-omega_heli_y_theta_dot - alpha_arm_z * c_theta);
    let M_eps_theta = -p.l_oc * mc_heli_z * s_theta;
    let l_oc_mc_heli_z_c_theta = p.l_oc * mc_heli_z * c_theta;
    let M_psi_theta = l_oc_mc_heli_z_c_theta * c_eps - I_heli_xx * s_eps;
    let I_heli_yy_minus_I_z_c_theta = c_theta * (I_heli_yy - p.I_z);
    let heli_3 = I_heli_yy_minus_I_z_c_theta * c_theta;
    let a_heli_1_y = 2.0 * p.l_oc * alpha_arm_z;
    let a_heli_1_x = p.g * s_eps - p.l_oc * arm_1;
    let a_heli_1_z = p.l_oc * omega_arm_z_omega_arm_x + a_arm_z;
    let l_oc_m_h_l_oc = p.m_h * p.l_oc * p.l_oc;
    let a_heli_y = a_heli_1_y * c_theta - a_heli_1_z * s_theta;
    let a_heli_z = a_heli_1_y * s_theta + a_heli_1_z * c_theta;
    let f_heli_y = p.m_h * a_heli_y - mc_heli_z * (alpha_arm_x - omega_heli_y_omega_heli_z);
    let n_heli_x = I_heli_xx * alpha_arm_x + omega_heli_y_omega_heli_z * (p.I_z - I_heli_yy) - mc_heli_z * a_heli_y;
    let n_heli_y = heli_2 + omega_heli_z_omega_heli_x * (I_heli_xx - p.I_z) + mc_heli_z * a_heli_1_x;
    let n_heli_1_y = n_moving_heli_z * s_theta + n_heli_y * c_theta;
    let n_heli_1_z = n_moving_heli_z * c_theta - n_heli_y * s_theta;
    let f_net_heli_z = p.m_h * a_heli_z - mc_heli_z_heli_1 - f_s;
    let f_net_heli_1_y = f_heli_y * c_theta + f_net_heli_z * s_theta;
    let f_net_heli_1_z = f_net_heli_z * c_theta - f_heli_y * s_theta;
    // frame arm on column
    let M_eps_eps = I_arm_yy + p.I_z + heli_3 + l_oc_m_h_l_oc;
    let M_psi_eps = I_heli_yy_minus_I_z_c_theta * c_eps * s_theta - M_eps_theta * s_eps;
    let arm_2 = c_eps * (I_arm_yy + I_heli_yy - heli_3 + l_oc_m_h_l_oc - I_heli_xx);
    let arm_3 = c_eps * (arm_2 - 2.0 * l_oc_mc_heli_z_c_theta * s_eps);
    let n_net_arm_z = 2.0 * I_arm_yy * alpha_arm_z + n_heli_1_z + p.l_oc * f_net_heli_1_y;
    let arm_4 = I_arm_yy * omega_arm_z_omega_arm_x + mc_arm_x * a_arm_z - n_heli_1_y + p.l_oc * f_net_heli_1_z;
    // force rotor_2 on heli
    let n_applied_heli_x = p.l_df * u.f_2 - p.l_df * u.f_1;
    let c_eps_s_theta = c_eps * s_theta;
    // frame arm on column
    let n_net_column_z = n_net_arm_z * c_eps + s_eps * (n_heli_x - n_applied_heli_x);
    // balance of forces
    let tau_theta = n_heli_x - p.c0_theta * v.theta - n_applied_heli_x;
    // M = L^T D L and back-substitution
    let inv_theta = 1.0 / I_heli_xx;
    let l_theta_psi = M_psi_theta * inv_theta;
    let l_theta_eps = M_eps_theta * inv_theta;
    let pivot_eps = M_eps_eps - M_eps_theta * l_theta_eps;
    let inv_eps = 1.0 / pivot_eps;
    let solve_1 = M_psi_eps - M_psi_theta * l_theta_eps;
    let l_eps_psi = inv_eps * solve_1;
    let pivot_psi = I_heli_xx + arm_3 - solve_1 * l_eps_psi - M_psi_theta * l_theta_psi;
    let inv_psi = 1.0 / pivot_psi;
    let solve_2 = tau_theta * l_theta_eps + p.c0_eps * v.eps + arm_4;
    let psi_ddot = -inv_psi * (p.c0_psi * v.psi + n_net_column_z - l_eps_psi * solve_2 + tau_theta * l_theta_psi);
    let eps_ddot = -inv_eps * solve_2 - l_eps_psi * psi_ddot;
    let theta_ddot = tau_theta * inv_theta - l_theta_psi * psi_ddot - l_theta_eps * eps_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_arm_z + psi_ddot * c_eps;
    let alpha_arm_z_plus_slopes_1 = alpha_arm_z + slopes_1;
    let slopes_2 = omega_arm_z_omega_arm_x + eps_ddot;
    let slopes_3 = p.l_oc * alpha_arm_z_plus_slopes_1;
    let a_arm_z_plus_l_oc_slopes_2 = a_arm_z + p.l_oc * slopes_2;
    let slopes_4 = omega_heli_z_theta_dot + eps_ddot * c_theta + slopes_1 * s_theta;
    let slopes_5 = eps_ddot * s_theta - omega_heli_y_theta_dot - slopes_1 * c_theta;
    let slopes_6 = alpha_arm_x - theta_ddot + psi_ddot * s_eps;
    let slopes_7 = a_arm_z_plus_l_oc_slopes_2 * s_theta - slopes_3 * c_theta;
    let slopes_8 = a_arm_z_plus_l_oc_slopes_2 * c_theta + slopes_3 * s_theta;
    let m_h_slopes_7 = p.m_h * slopes_7;
    let slopes_9 = slopes_6 - omega_heli_y_omega_heli_z;
    let slopes_10 = mc_heli_z * slopes_9 + m_h_slopes_7;
    let slopes_11 = p.m_h * slopes_8 - mc_heli_z_heli_1 - f_s;
    let slopes_12 = slopes_11 * s_theta - slopes_10 * c_theta;
    let slopes_13 = slopes_11 * c_theta + slopes_10 * s_theta;
    let l_cd_slopes_9_minus_slopes_7 = p.l_cd * slopes_9 - slopes_7;
    let slopes_8_plus_l_cd_heli_1 = slopes_8 + p.l_cd * heli_1;
    let slopes_14 = p.l_oc * (slopes_8_plus_l_cd_heli_1 * c_theta - l_cd_slopes_9_minus_slopes_7 * s_theta);
    let slopes_15 = p.l_oc * (l_cd_slopes_9_minus_slopes_7 * c_theta + slopes_8_plus_l_cd_heli_1 * s_theta);
    let slopes_16 = slopes_2 * s_theta - alpha_arm_z_plus_slopes_1 * c_theta;
    let m_h_slopes_16 = p.m_h * slopes_16;
    let slopes_17 = p.m_h * (slopes_2 * c_theta + alpha_arm_z_plus_slopes_1 * s_theta);
    let mc_heli_z_slopes_16 = mc_heli_z * slopes_16;
    let slopes_18 = p.l_oc * (m_h_slopes_16 * s_theta + slopes_17 * c_theta);
    let slopes_19 = p.l_oc * (slopes_17 * s_theta - m_h_slopes_16 * c_theta);
    let m_h_slopes_9 = p.m_h * slopes_9;
    let l_cd_sq = p.l_cd * p.l_cd;
    let l_oa_sq = p.l_oa * p.l_oa;
    let l_ob_sq = p.l_ob * p.l_ob;
    // derivatives with respect to m_c
    let by_m_c_1 = p.l_ob * a_arm_z - omega_arm_z_omega_arm_x * l_ob_sq - eps_ddot * l_ob_sq;
    let mc_heli_z_s_eps = mc_heli_z * s_eps;
    let m_h_c_eps_s_theta = p.m_h * c_eps_s_theta;
    let m_h_c_eps_c_theta = p.m_h * c_eps * c_theta;
    let mc_heli_z_c_eps_s_theta = mc_heli_z * c_eps_s_theta;
    // derivatives with respect to g
    let by_g_1 = p.l_oc * (m_h_c_eps_s_theta * s_theta + m_h_c_eps_c_theta * c_theta);
    let by_g_2 = p.l_oc * (m_h_c_eps_c_theta * s_theta - m_h_c_eps_s_theta * c_theta);
    let by_g_3 = mc_arm_x * c_eps - mc_heli_z_s_eps * c_theta + by_g_1;
    let by_g_4 = c_eps * (by_g_2 - mc_heli_z_s_eps * s_theta);
    let by_g_5 = l_theta_eps * mc_heli_z_c_eps_s_theta + by_g_3;
    let by_g_6 = l_eps_psi * by_g_5 - mc_heli_z_c_eps_s_theta * s_eps - by_g_4;
    let d_psi_ddot_by_g = inv_psi * (by_g_6 - l_theta_psi * mc_heli_z_c_eps_s_theta);
    let d_eps_ddot_by_g = -inv_eps * by_g_5 - l_eps_psi * d_psi_ddot_by_g;
    let d_theta_ddot_by_g = inv_theta * mc_heli_z_c_eps_s_theta - l_theta_psi * d_psi_ddot_by_g - l_theta_eps * d_eps_ddot_by_g;
    let mc_heli_z_arm_1 = mc_heli_z * arm_1;
    // derivatives with respect to l_oc
    let by_l_oc_1 = mc_heli_z_arm_1 * c_theta + slopes_13 + slopes_18;
    let by_l_oc_2 = by_l_oc_1 + l_theta_eps * mc_heli_z_slopes_16;
    let two_m_c_l_ob = 2.0 * m_c_l_ob;
    // derivatives with respect to l_ob
    let by_l_ob_1 = p.m_c * a_arm_z - omega_arm_z_omega_arm_x * two_m_c_l_ob - eps_ddot * two_m_c_l_ob;
    let two_m_b_l_oa = 2.0 * m_b_l_oa;
    let two_mc_heli_z = 2.0 * mc_heli_z;
    let m_h_heli_1 = p.m_h * heli_1;
    // derivatives with respect to I_x
    let by_I_x_1 = omega_heli_z_omega_heli_x * c_theta;
    let by_I_x_2 = omega_heli_z_omega_heli_x * s_theta;
    let by_I_x_3 = c_eps * (-omega_heli_y_omega_heli_x * c_theta - by_I_x_2);
    let by_I_x_4 = by_I_x_1 - omega_heli_y_omega_heli_x * s_theta - l_theta_eps * slopes_6;
    let by_I_x_5 = by_I_x_3 + slopes_6 * s_eps + l_eps_psi * by_I_x_4;
    let d_psi_ddot_by_I_x = inv_psi * (-l_theta_psi * slopes_6 - by_I_x_5);
    let d_eps_ddot_by_I_x = inv_eps * by_I_x_4 - l_eps_psi * d_psi_ddot_by_I_x;
    let d_theta_ddot_by_I_x = inv_theta * slopes_6 - l_theta_psi * d_psi_ddot_by_I_x - l_theta_eps * d_eps_ddot_by_I_x;
    // slopes of the balance of forces, at the accelerations found
    let slopes_20 = slopes_6 * l_cd_sq - omega_heli_y_omega_heli_z * l_cd_sq;
    let slopes_21 = omega_heli_z_omega_heli_x * l_cd_sq - slopes_4 * l_cd_sq;
    let slopes_22 = slopes_20 - p.l_cd * slopes_7;
    let slopes_23 = slopes_21 - p.l_cd * a_heli_1_x;
    let slopes_24 = c_eps * (slopes_15 - slopes_23 * s_theta);
    let slopes_25 = p.l_oa * a_arm_z + omega_arm_z_omega_arm_x * l_oa_sq + eps_ddot * l_oa_sq;
    let slopes_26 = c_eps * (-alpha_arm_z * l_oa_sq - slopes_1 * l_oa_sq);
    let slopes_27 = c_eps * (-alpha_arm_z * l_ob_sq - slopes_1 * l_ob_sq);
    let slopes_28 = slopes_12 + slopes_19 + mc_heli_z_arm_1 * s_theta;
    let slopes_29 = c_eps * (-alpha_arm_z * two_m_c_l_ob - slopes_1 * two_m_c_l_ob);
    let slopes_30 = p.m_b * a_arm_z + omega_arm_z_omega_arm_x * two_m_b_l_oa + eps_ddot * two_m_b_l_oa;
    let slopes_31 = c_eps * (-alpha_arm_z * two_m_b_l_oa - slopes_1 * two_m_b_l_oa);
    let slopes_32 = 2.0 * omega_heli_y_omega_heli_z * mc_heli_z - slopes_6 * two_mc_heli_z;
    let slopes_33 = slopes_4 * two_mc_heli_z - omega_heli_z_omega_heli_x * two_mc_heli_z;
    let slopes_32_minus_m_h_slopes_7 = slopes_32 - m_h_slopes_7;
    let slopes_34 = slopes_33 - p.m_h * a_heli_1_x;
    let slopes_35 = p.l_oc * (m_h_heli_1 * c_theta - m_h_slopes_9 * s_theta);
    let slopes_36 = p.l_oc * (m_h_heli_1 * s_theta + m_h_slopes_9 * c_theta);
    let slopes_37 = c_eps * (slopes_36 - slopes_34 * s_theta);
    let slopes_38 = c_eps * (by_I_x_2 - slopes_5 * c_theta);
    // derivatives with respect to m_h
    let by_m_h_1 = slopes_23 * c_theta - slopes_14 - l_theta_eps * slopes_22;
    let by_m_h_2 = slopes_24 + slopes_22 * s_eps + l_eps_psi * by_m_h_1;
    let d_psi_ddot_by_m_h = inv_psi * (-l_theta_psi * slopes_22 - by_m_h_2);
    let d_eps_ddot_by_m_h = inv_eps * by_m_h_1 - l_eps_psi * d_psi_ddot_by_m_h;
    let d_theta_ddot_by_m_h = inv_theta * slopes_22 - l_theta_psi * d_psi_ddot_by_m_h - l_theta_eps * d_eps_ddot_by_m_h;
    // derivatives with respect to m_b
    let d_psi_ddot_by_m_b = inv_psi * (slopes_26 + l_eps_psi * slopes_25);
    let d_eps_ddot_by_m_b = -inv_eps * slopes_25 - l_eps_psi * d_psi_ddot_by_m_b;
    let d_theta_ddot_by_m_b = -l_theta_psi * d_psi_ddot_by_m_b - l_theta_eps * d_eps_ddot_by_m_b;
    // derivatives with respect to m_c
    let d_psi_ddot_by_m_c = inv_psi * (slopes_27 - l_eps_psi * by_m_c_1);
    let d_eps_ddot_by_m_c = inv_eps * by_m_c_1 - l_eps_psi * d_psi_ddot_by_m_c;
    let d_theta_ddot_by_m_c = -l_theta_psi * d_psi_ddot_by_m_c - l_theta_eps * d_eps_ddot_by_m_c;
    // derivatives with respect to l_oc
    let by_l_oc_3 = mc_heli_z_slopes_16 * s_eps + slopes_28 * c_eps;
    let d_psi_ddot_by_l_oc = inv_psi * (l_eps_psi * by_l_oc_2 - by_l_oc_3 - l_theta_psi * mc_heli_z_slopes_16);
    let d_eps_ddot_by_l_oc = -inv_eps * by_l_oc_2 - l_eps_psi * d_psi_ddot_by_l_oc;
    let d_theta_ddot_by_l_oc = inv_theta * mc_heli_z_slopes_16 - l_theta_psi * d_psi_ddot_by_l_oc - l_theta_eps * d_eps_ddot_by_l_oc;
    // derivatives with respect to l_ob
    let d_psi_ddot_by_l_ob = inv_psi * (slopes_29 - l_eps_psi * by_l_ob_1);
    let d_eps_ddot_by_l_ob = inv_eps * by_l_ob_1 - l_eps_psi * d_psi_ddot_by_l_ob;
    let d_theta_ddot_by_l_ob = -l_theta_psi * d_psi_ddot_by_l_ob - l_theta_eps * d_eps_ddot_by_l_ob;
    // derivatives with respect to l_oa
    let d_psi_ddot_by_l_oa = inv_psi * (slopes_31 + l_eps_psi * slopes_30);
    let d_eps_ddot_by_l_oa = -inv_eps * slopes_30 - l_eps_psi * d_psi_ddot_by_l_oa;
    let d_theta_ddot_by_l_oa = -l_theta_psi * d_psi_ddot_by_l_oa - l_theta_eps * d_eps_ddot_by_l_oa;
    // derivatives with respect to l_cd
    let by_l_cd_1 = slopes_34 * c_theta - slopes_35 - l_theta_eps * slopes_32_minus_m_h_slopes_7;
    let by_l_cd_2 = slopes_37 + slopes_32_minus_m_h_slopes_7 * s_eps + l_eps_psi * by_l_cd_1;
    let d_psi_ddot_by_l_cd = inv_psi * (-l_theta_psi * slopes_32_minus_m_h_slopes_7 - by_l_cd_2);
    let d_eps_ddot_by_l_cd = inv_eps * by_l_cd_1 - l_eps_psi * d_psi_ddot_by_l_cd;
    let d_theta_ddot_by_l_cd = inv_theta * slopes_32_minus_m_h_slopes_7
        - l_theta_psi * d_psi_ddot_by_l_cd
        - l_theta_eps * d_eps_ddot_by_l_cd;
    let f_d_l_theta_eps = f_d * l_theta_eps;
    // derivatives with respect to l_df
    let d_psi_ddot_by_l_df = inv_psi * (l_eps_psi * f_d_l_theta_eps - f_d * s_eps - f_d * l_theta_psi);
    let d_eps_ddot_by_l_df = -inv_eps * f_d_l_theta_eps - l_eps_psi * d_psi_ddot_by_l_df;
    let d_theta_ddot_by_l_df = f_d * inv_theta - l_theta_psi * d_psi_ddot_by_l_df - l_theta_eps * d_eps_ddot_by_l_df;
    // derivatives with respect to I_z
    let by_I_z_1 = omega_heli_y_omega_heli_z * l_theta_eps + by_I_x_1 + slopes_5 * s_theta;
    let by_I_z_2 = l_eps_psi * by_I_z_1 - omega_heli_y_omega_heli_z * s_eps - slopes_38;
    let d_psi_ddot_by_I_z = inv_psi * (by_I_z_2 - omega_heli_y_omega_heli_z * l_theta_psi);
    let d_eps_ddot_by_I_z = -inv_eps * by_I_z_1 - l_eps_psi * d_psi_ddot_by_I_z;
    let d_theta_ddot_by_I_z = omega_heli_y_omega_heli_z * inv_theta - l_theta_psi * d_psi_ddot_by_I_z - l_theta_eps * d_eps_ddot_by_I_z;
    // derivatives with respect to c0_psi
    let d_psi_ddot_by_c0_psi = -inv_psi * v.psi;
    let d_eps_ddot_by_c0_psi = -l_eps_psi * d_psi_ddot_by_c0_psi;
    let d_theta_ddot_by_c0_psi = -l_theta_psi * d_psi_ddot_by_c0_psi - l_theta_eps * d_eps_ddot_by_c0_psi;
    // derivatives with respect to c0_eps
    let d_psi_ddot_by_c0_eps = inv_psi * l_eps_psi * v.eps;
    let d_eps_ddot_by_c0_eps = -inv_eps * v.eps - l_eps_psi * d_psi_ddot_by_c0_eps;
    let d_theta_ddot_by_c0_eps = -l_theta_psi * d_psi_ddot_by_c0_eps - l_theta_eps * d_eps_ddot_by_c0_eps;
    let l_theta_eps_theta_dot = l_theta_eps * v.theta;
    // derivatives with respect to c0_theta
    let d_psi_ddot_by_c0_theta = -inv_psi * (l_eps_psi * l_theta_eps_theta_dot - l_theta_psi * v.theta);
    let d_eps_ddot_by_c0_theta = inv_eps * l_theta_eps_theta_dot - l_eps_psi * d_psi_ddot_by_c0_theta;
    let d_theta_ddot_by_c0_theta = -inv_theta * v.theta - l_theta_psi * d_psi_ddot_by_c0_theta - l_theta_eps * d_eps_ddot_by_c0_theta;
    positive(I_heli_xx, 2)?;
    positive(pivot_eps, 1)?;
    positive(pivot_psi, 0)?;
    Ok([
        [0.0; 14], // psi'
        [0.0; 14], // eps'
        [0.0; 14], // theta'
        // psi''
        Parameters {
            m_h: d_psi_ddot_by_m_h,
            m_b: d_psi_ddot_by_m_b,
            m_c: d_psi_ddot_by_m_c,
            g: d_psi_ddot_by_g,
            l_oc: d_psi_ddot_by_l_oc,
            l_ob: d_psi_ddot_by_l_ob,
            l_oa: d_psi_ddot_by_l_oa,
            l_cd: d_psi_ddot_by_l_cd,
            l_df: d_psi_ddot_by_l_df,
            I_x: d_psi_ddot_by_I_x,
            I_z: d_psi_ddot_by_I_z,
            c0_psi: d_psi_ddot_by_c0_psi,
            c0_eps: d_psi_ddot_by_c0_eps,
            c0_theta: d_psi_ddot_by_c0_theta,
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
            l_cd: d_eps_ddot_by_l_cd,
            l_df: d_eps_ddot_by_l_df,
            I_x: d_eps_ddot_by_I_x,
            I_z: d_eps_ddot_by_I_z,
            c0_psi: d_eps_ddot_by_c0_psi,
            c0_eps: d_eps_ddot_by_c0_eps,
            c0_theta: d_eps_ddot_by_c0_theta,
        }
        .to_array(),
        // theta''
        Parameters {
            m_h: d_theta_ddot_by_m_h,
            m_b: d_theta_ddot_by_m_b,
            m_c: d_theta_ddot_by_m_c,
            g: d_theta_ddot_by_g,
            l_oc: d_theta_ddot_by_l_oc,
            l_ob: d_theta_ddot_by_l_ob,
            l_oa: d_theta_ddot_by_l_oa,
            l_cd: d_theta_ddot_by_l_cd,
            l_df: d_theta_ddot_by_l_df,
            I_x: d_theta_ddot_by_I_x,
            I_z: d_theta_ddot_by_I_z,
            c0_psi: d_theta_ddot_by_c0_psi,
            c0_eps: d_theta_ddot_by_c0_eps,
            c0_theta: d_theta_ddot_by_c0_theta,
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 3 x 6.
    pub by_x: [[f64; 6]; 3],
    /// dy/dp, 3 x 14.
    pub by_p: [[f64; 14]; 3],
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
            [0.0; 14], // psi
            [0.0; 14], // eps
            [0.0; 14], // theta
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 6] = ["psi", "eps", "theta", "psi.dot", "eps.dot", "theta.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 2] = ["f_1", "f_2"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 14] = [
    "m_h", "m_b", "m_c", "g", "l_oc", "l_ob", "l_oa", "l_cd", "l_df", "I_x", "I_z", "c0_psi", "c0_eps", "c0_theta",
];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 14] = ["kg", "kg", "kg", "m/s^2", "m", "m", "m", "m", "m", "kg*m^2", "kg*m^2", "N*m*s", "N*m*s", "N*m*s"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 3] = ["psi", "eps", "theta"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 3] = ["rad", "rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Googol;

impl Names for Googol {
    fn rig(&self) -> &str {
        "Googol"
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

impl Model for Googol {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 3, lags: 0, inputs: 2, exogenous: 0, parameters: 14, outputs: 3 }
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
