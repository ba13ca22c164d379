//! Two arms on one column.
//! Generated from `tree.rig` (model 42640007); edit the rig, not this file.
//!
//! A branching rig: a driven column carries a left and a right arm, each with a shoulder that lifts it; the
//! right one has an elbow too. The arms push on one another through the column. A test bed of our own
//! (no published rig of this kind comes with numbers): tubes of 0.5 kg/m, hubs of 0.2 kg.
//!
//! 219 operations forward, 598 with A and B.
//! Derived twice, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::{cos, powi, sin, sin_cos};
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular, positive};

/// Parameters p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// column with its motor [kg*m^2]
    pub I_c: f64,
    /// column's axis to either shoulder [m]
    pub a: f64,
    /// left arm [m]
    pub l: f64,
    /// right upper arm [m]
    pub l_u: f64,
    /// right forearm [m]
    pub l_f: f64,
    /// tubes [kg/m]
    pub rho: f64,
    /// hub at the right elbow [kg]
    pub m_e: f64,
    /// weight at the left tip [kg]
    pub m_t: f64,
    /// column [N*m*s]
    pub c_psi: f64,
    /// shoulders and elbow [N*m*s]
    pub c_s: f64,
    /// g [m/s^2]
    pub g: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        I_c: 0.02,
        a: 0.1,
        l: 0.4,
        l_u: 0.25,
        l_f: 0.2,
        rho: 0.5,
        m_e: 0.2,
        m_t: 0.15,
        c_psi: 0.05,
        c_s: 0.02,
        g: 9.81,
    };

    /// All zero: where derivatives with respect to the parameters start from.
    const ZERO: Self = Self::from_array([0.0; 11]);

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 11]) -> Self {
        let [I_c, a, l, l_u, l_f, rho, m_e, m_t, c_psi, c_s, g] = values;
        Self { I_c, a, l, l_u, l_f, rho, m_e, m_t, c_psi, c_s, g }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 11] {
        [self.I_c, self.a, self.l, self.l_u, self.l_f, self.rho, self.m_e, self.m_t, self.c_psi, self.c_s, self.g]
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
    /// column [rad]
    pub psi: f64,
    /// left shoulder, up positive [rad]
    pub left: f64,
    /// right shoulder, up positive [rad]
    pub right: f64,
    /// right elbow, relative [rad]
    pub elbow: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [psi, left, right, elbow] = values;
        Self { psi, left, right, elbow }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.psi, self.left, self.right, self.elbow]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// column [rad/s]
    pub psi: f64,
    /// left shoulder, up positive [rad/s]
    pub left: f64,
    /// right shoulder, up positive [rad/s]
    pub right: f64,
    /// right elbow, relative [rad/s]
    pub elbow: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [psi, left, right, elbow] = values;
        Self { psi, left, right, elbow }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.psi, self.left, self.right, self.elbow]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// column [rad/s^2]
    pub psi: f64,
    /// left shoulder, up positive [rad/s^2]
    pub left: f64,
    /// right shoulder, up positive [rad/s^2]
    pub right: f64,
    /// right elbow, relative [rad/s^2]
    pub elbow: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [psi, left, right, elbow] = values;
        Self { psi, left, right, elbow }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.psi, self.left, self.right, self.elbow]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// tau_psi [N*m]
    pub tau_psi: f64,
    /// tau_l [N*m]
    pub tau_l: f64,
    /// tau_r [N*m]
    pub tau_r: f64,
    /// tau_e [N*m]
    pub tau_e: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [tau_psi, tau_l, tau_r, tau_e] = values;
        Self { tau_psi, tau_l, tau_r, tau_e }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.tau_psi, self.tau_l, self.tau_r, self.tau_e]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// psi [rad]
    pub psi: f64,
    /// left [rad]
    pub left: f64,
    /// right [rad]
    pub right: f64,
    /// elbow [rad]
    pub elbow: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [psi, left, right, elbow] = values;
        Self { psi, left, right, elbow }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.psi, self.left, self.right, self.elbow]
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
    pub const fn from_array(values: [f64; 8]) -> Self {
        let [x0, x1, x2, x3, x4, x5, x6, x7] = values;
        Self {
            q: Coordinates::from_array([x0, x1, x2, x3]),
            v: Rates::from_array([x4, x5, x6, x7]),
        }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 8] {
        let [x0, x1, x2, x3] = self.q.to_array();
        let [x4, x5, x6, x7] = self.v.to_array();
        [x0, x1, x2, x3, x4, x5, x6, x7]
    }
}

/// Mass matrix M(q), 4 x 4, symmetric; rows (psi, left, right, elbow).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 4]; 4] {
    let c_left = cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_rho = p.l * p.rho;
    let l_per_two = p.l / 2.0;
    let l_rho_l_per_two = l_rho * l_per_two;
    let l_m_t = p.l * p.m_t;
    // frame left_arm on column
    let I_left_arm_yy = p.rho * powi(p.l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p.l * l_m_t;
    let left_arm_1 = c_left * (l_rho_l_per_two + l_m_t);
    let l_u_rho = p.l_u * p.rho;
    let l_u_per_two = p.l_u / 2.0;
    let l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    let l_u_m_e = p.l_u * p.m_e;
    // frame right_arm on column
    let I_right_arm_yy = p.rho * powi(p.l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two + p.l_u * l_u_m_e;
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let mc_forearm_x = m_forearm * l_f_per_two;
    let I_forearm_yy = p.rho * powi(p.l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    let mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    let mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    // frame forearm on right_arm
    let M_right_elbow = I_forearm_yy + p.l_u * mc_forearm_x_c_elbow;
    let I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    let I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    let forearm_1 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    let forearm_1_1 = mc_forearm_x_c_elbow + p.l_u * m_forearm;
    let forearm_1_2 = p.l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    // frame right_arm on column
    let right_arm_1 = c_right * (l_u_rho_l_u_per_two + l_u_m_e + forearm_1_1);
    let right_arm_2 = right_arm_1 - mc_forearm_x_s_elbow * s_right;
    let right_arm_3 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_1;
    let right_arm_4 = 2.0 * s_right * (I_forearm_yy_c_elbow * s_elbow + p.l_u * mc_forearm_x_s_elbow);
    let right_arm_5 = c_right * (right_arm_3 * c_right - right_arm_4);
    let right_arm_1_1 = p.a * (right_arm_2 + right_arm_2 + p.a * (p.m_e + l_u_rho + m_forearm));
    // frame left_arm on column
    let left_arm_1_1 = p.a * (left_arm_1 + left_arm_1 + p.a * (p.m_t + l_rho));
    let left_arm_1_2 = I_left_arm_yy * c_left * c_left + left_arm_1_1;
    // frame column on ground
    let M_psi_psi = p.I_c + forearm_1 + right_arm_5 + right_arm_1_1 + left_arm_1_2;
    [
        [M_psi_psi, 0.0, 0.0, 0.0], // psi
        [0.0, I_left_arm_yy, 0.0, 0.0], // left
        [0.0, 0.0, I_right_arm_yy + I_forearm_yy + forearm_1_2, M_right_elbow], // right
        [0.0, 0.0, M_right_elbow, I_forearm_yy], // elbow
    ]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (psi, left, right, elbow).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 4] {
    let (s_left, c_left) = sin_cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_per_two = p.l / 2.0;
    let l_rho_l_per_two = p.l * p.rho * l_per_two;
    let l_m_t = p.l * p.m_t;
    // frame left_arm on column
    let mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    let I_left_arm_yy = p.rho * powi(p.l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p.l * l_m_t;
    let omega_left_arm_x = -s_left * v.psi;
    let alpha_left_arm_z = omega_left_arm_x * v.left;
    let n_moving_left_arm_1_z = 2.0 * I_left_arm_yy * alpha_left_arm_z * c_left;
    let l_u_per_two = p.l_u / 2.0;
    let l_u_rho_l_u_per_two = p.l_u * p.rho * l_u_per_two;
    let l_u_m_e = p.l_u * p.m_e;
    // frame right_arm on column
    let mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    let I_right_arm_yy = p.rho * powi(p.l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two + p.l_u * l_u_m_e;
    let omega_right_arm_z = c_right * v.psi;
    let omega_right_arm_x = s_right * v.psi;
    let alpha_right_arm_z = -omega_right_arm_x * v.right;
    let two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    let right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let mc_forearm_x = m_forearm * l_f_per_two;
    let I_forearm_yy = p.rho * powi(p.l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    // frame forearm on right_arm
    let omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    let omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    let omega_forearm_y = -v.right - v.elbow;
    let forearm_1 = omega_right_arm_z * s_elbow * v.right - alpha_right_arm_z * c_elbow;
    let alpha_forearm_z = -omega_forearm_x * v.elbow - forearm_1;
    let forearm_2 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z);
    let forearm_3 = omega_forearm_x * omega_forearm_y;
    let forearm_4 = omega_forearm_z * omega_forearm_x;
    // frame left_arm on column
    let a_left_arm_1_x = p.a * v.psi * v.psi;
    // frame forearm on right_arm
    let a_forearm_1_y = p.l_u * two_alpha_right_arm_z;
    let f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_3);
    let n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_3;
    let forearm_1_1 = n_moving_forearm_z * c_elbow + p.l_u * f_moving_forearm_y;
    // frame right_arm on column
    let n_moving_right_arm_z = 2.0 * I_right_arm_yy * alpha_right_arm_z + forearm_1_1;
    let right_arm_2 = n_moving_forearm_z * s_right * s_elbow;
    let a_right_arm_z = a_left_arm_1_x * s_right + p.g * c_right;
    let a_right_arm_x = p.g * s_right - a_left_arm_1_x * c_right;
    let right_arm_1_1 = p.a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    let right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_2 + right_arm_1_1;
    // frame column on ground
    let n_moving_column_z = right_arm_1_2 + n_moving_left_arm_1_z - 2.0 * p.a * mc_left_arm_x * alpha_left_arm_z;
    // frame left_arm on column
    let a_left_arm_z = a_left_arm_1_x * s_left + p.g * c_left;
    let n_left_arm_y = -I_left_arm_yy * omega_left_arm_x * c_left * v.psi - mc_left_arm_x * a_left_arm_z;
    // frame forearm on right_arm
    let a_forearm_1_x = a_right_arm_x - p.l_u * (v.right * v.right + omega_right_arm_z * omega_right_arm_z);
    let a_forearm_1_z = p.l_u * right_arm_1 + a_right_arm_z;
    let a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x * s_elbow;
    let a_forearm_x = a_forearm_1_z * s_elbow + a_forearm_1_x * c_elbow;
    let f_forearm_z = mc_forearm_x * forearm_4 + m_forearm * a_forearm_z;
    let n_forearm_y = -I_forearm_yy * forearm_4 - mc_forearm_x * a_forearm_z;
    let forearm_5 = s_elbow * (m_forearm * a_forearm_x - forearm_2);
    let forearm_1_2 = p.l_u * (f_forearm_z * c_elbow + forearm_5) - n_forearm_y;
    // frame right_arm on column
    let n_right_arm_y = -I_right_arm_yy * right_arm_1 - mc_right_arm_x * a_right_arm_z - forearm_1_2;
    [n_moving_column_z, n_left_arm_y, -n_right_arm_y, -n_forearm_y]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (psi, left, right, elbow).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 4] {
    let (s_left, c_left) = sin_cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_per_two = p.l / 2.0;
    let l_rho_l_per_two = p.l * p.rho * l_per_two;
    let l_m_t = p.l * p.m_t;
    // frame left_arm on column
    let mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    let I_left_arm_yy = p.rho * powi(p.l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p.l * l_m_t;
    let omega_left_arm_x = -s_left * v.psi;
    let alpha_left_arm_z = omega_left_arm_x * v.left;
    let left_arm_1 = I_left_arm_yy * omega_left_arm_x * c_left * v.psi;
    let n_moving_left_arm_1_z = 2.0 * I_left_arm_yy * alpha_left_arm_z * c_left;
    let l_u_per_two = p.l_u / 2.0;
    let l_u_rho_l_u_per_two = p.l_u * p.rho * l_u_per_two;
    let l_u_m_e = p.l_u * p.m_e;
    // frame right_arm on column
    let mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    let I_right_arm_yy = p.rho * powi(p.l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two + p.l_u * l_u_m_e;
    let omega_right_arm_z = c_right * v.psi;
    let omega_right_arm_x = s_right * v.psi;
    let alpha_right_arm_z = -omega_right_arm_x * v.right;
    let two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    let right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let mc_forearm_x = m_forearm * l_f_per_two;
    let I_forearm_yy = p.rho * powi(p.l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    // frame forearm on right_arm
    let omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    let omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    let omega_forearm_y = -v.right - v.elbow;
    let forearm_1 = omega_right_arm_z * s_elbow * v.right - alpha_right_arm_z * c_elbow;
    let alpha_forearm_z = -omega_forearm_x * v.elbow - forearm_1;
    let forearm_2 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z);
    let forearm_3 = omega_forearm_x * omega_forearm_y;
    let forearm_4 = omega_forearm_z * omega_forearm_x;
    // frame left_arm on column
    let a_left_arm_1_x = p.a * v.psi * v.psi;
    let n_moving_left_arm_y = -left_arm_1 - mc_left_arm_x * a_left_arm_1_x * s_left;
    // frame right_arm on column
    let a_right_arm_z = a_left_arm_1_x * s_right;
    // frame forearm on right_arm
    let a_forearm_1_y = p.l_u * two_alpha_right_arm_z;
    let a_forearm_1_x = -a_left_arm_1_x * c_right - p.l_u * (v.right * v.right + omega_right_arm_z * omega_right_arm_z);
    let a_forearm_1_z = a_right_arm_z + p.l_u * right_arm_1;
    let a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x * s_elbow;
    let a_forearm_x = a_forearm_1_z * s_elbow + a_forearm_1_x * c_elbow;
    let f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_3);
    let f_moving_forearm_z = m_forearm * a_forearm_z + mc_forearm_x * forearm_4;
    let n_moving_forearm_y = -I_forearm_yy * forearm_4 - mc_forearm_x * a_forearm_z;
    let n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_3;
    let forearm_5 = s_elbow * (m_forearm * a_forearm_x - forearm_2);
    let forearm_1_1 = p.l_u * (f_moving_forearm_z * c_elbow + forearm_5) - n_moving_forearm_y;
    let forearm_1_2 = n_moving_forearm_z * c_elbow + p.l_u * f_moving_forearm_y;
    // frame right_arm on column
    let n_moving_right_arm_y = -I_right_arm_yy * right_arm_1 - mc_right_arm_x * a_right_arm_z - forearm_1_1;
    let n_moving_right_arm_z = 2.0 * I_right_arm_yy * alpha_right_arm_z + forearm_1_2;
    let right_arm_2 = n_moving_forearm_z * s_right * s_elbow;
    let right_arm_1_1 = p.a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    let right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_2 + right_arm_1_1;
    // frame column on ground
    let n_moving_column_z = right_arm_1_2 + n_moving_left_arm_1_z - 2.0 * p.a * mc_left_arm_x * alpha_left_arm_z;
    [n_moving_column_z, n_moving_left_arm_y, -n_moving_right_arm_y, -n_moving_forearm_y]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (psi, left, right, elbow).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 4] {
    let c_left = cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let l_f_per_two_c_elbow = l_f_per_two * c_elbow;
    let l_f_per_two_s_right_s_elbow = l_f_per_two * s_right * s_elbow;
    let g_left = p.l * p.l * p.rho * p.g * c_left / 2.0 + p.l * p.m_t * p.g * c_left;
    let gravity_1 = p.l_u * p.l_u * p.rho * p.g * c_right / 2.0 + p.l_u * p.m_e * p.g * c_right;
    let gravity_2 = p.g * m_forearm * (c_right * (p.l_u + l_f_per_two_c_elbow) - l_f_per_two_s_right_s_elbow);
    let g_elbow = p.g * m_forearm * (l_f_per_two_c_elbow * c_right - l_f_per_two_s_right_s_elbow);
    [0.0, g_left, gravity_1 + gravity_2, g_elbow]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (psi, left, right, elbow).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 4] {
    [p.c_psi * v.psi, p.c_s * v.left, p.c_s * v.right, p.c_s * v.elbow]
}

/// Generalized force Q [N m] of the inputs; rows (psi, left, right, elbow).
#[must_use]
pub fn generalized_force(_q: &Coordinates, u: &Inputs, _p: &Parameters) -> [f64; 4] {
    [u.tau_psi, u.tau_l, u.tau_r, u.tau_e]
}

/// Input map dQ/du, 4 x 4; rows (psi, left, right, elbow), columns (tau_psi, tau_l, tau_r, tau_e).
#[must_use]
pub fn input_map(_q: &Coordinates, _p: &Parameters) -> [[f64; 4]; 4] {
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let c_left = cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_per_two = p.l / 2.0;
    let rho_l_pow3_per_12 = p.rho * powi(p.l, 3) / 12.0;
    let l_per_two_left_dot = l_per_two * v.left;
    let l_u_per_two = p.l_u / 2.0;
    let rho_l_u_pow3_per_12 = p.rho * powi(p.l_u, 3) / 12.0;
    let l_u_per_two_right_dot = l_u_per_two * v.right;
    let l_f_per_two = p.l_f / 2.0;
    let rho_l_f_pow3_per_12 = p.rho * powi(p.l_f, 3) / 12.0;
    // frame left_arm on column
    let omega_left_arm_z = c_left * v.psi;
    // frame right_arm on column
    let omega_right_arm_z = c_right * v.psi;
    // frame forearm on right_arm
    let omega_forearm_z = omega_right_arm_z * c_elbow - s_elbow * s_right * v.psi;
    let omega_forearm_y = -v.right - v.elbow;
    let a_psi_dot = p.a * v.psi;
    let l_u_right_dot = p.l_u * v.right;
    let forearm_1_1 = a_psi_dot + p.l_u * omega_right_arm_z;
    let l_u_right_dot_s_elbow = l_u_right_dot * s_elbow;
    // body left_tube on left_arm
    let left_tube_1 = a_psi_dot + l_per_two * omega_left_arm_z;
    let left_tube_2 = p.l * p.rho * (left_tube_1 * left_tube_1 + l_per_two_left_dot * l_per_two_left_dot);
    let left_tube_3 = rho_l_pow3_per_12 * v.left * v.left + omega_left_arm_z * rho_l_pow3_per_12 * omega_left_arm_z;
    let l_left_dot = p.l * v.left;
    // body left_tip on left_arm
    let left_tip_1 = a_psi_dot + p.l * omega_left_arm_z;
    let left_tip_2 = 0.5 * p.m_t * (left_tip_1 * left_tip_1 + l_left_dot * l_left_dot);
    let left_tip_3 = 0.5 * p.I_c * v.psi * v.psi + 0.5 * (left_tube_2 + left_tube_3) + left_tip_2;
    // body right_tube on right_arm
    let right_tube_1 = a_psi_dot + l_u_per_two * omega_right_arm_z;
    let right_tube_2 = right_tube_1 * right_tube_1 + l_u_per_two_right_dot * l_u_per_two_right_dot;
    let right_tube_3 = rho_l_u_pow3_per_12 * v.right * v.right + omega_right_arm_z * rho_l_u_pow3_per_12 * omega_right_arm_z;
    let right_tube_4 = left_tip_3 + 0.5 * (p.l_u * p.rho * right_tube_2 + right_tube_3);
    // body hub on right_arm
    let hub_1 = 0.5 * p.m_e * (forearm_1_1 * forearm_1_1 + l_u_right_dot * l_u_right_dot);
    // body fore_tube on forearm
    let fore_tube_1 = forearm_1_1 + l_f_per_two * omega_forearm_z;
    let fore_tube_2 = l_u_right_dot * c_elbow - l_f_per_two * omega_forearm_y;
    let fore_tube_3 = l_u_right_dot_s_elbow * l_u_right_dot_s_elbow + fore_tube_1 * fore_tube_1;
    let fore_tube_4 = p.l_f * p.rho * (fore_tube_2 * fore_tube_2 + fore_tube_3);
    let fore_tube_5 = omega_forearm_z * rho_l_f_pow3_per_12 * omega_forearm_z;
    let fore_tube_6 = fore_tube_4 + omega_forearm_y * rho_l_f_pow3_per_12 * omega_forearm_y + fore_tube_5;
    right_tube_4 + hub_1 + 0.5 * fore_tube_6
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let s_left = sin(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_f_per_two = p.l_f / 2.0;
    // body fore_tube on forearm
    let fore_tube_1 = s_right * (p.l_u + l_f_per_two * c_elbow);
    let fore_tube_2 = p.g * (l_f_per_two * c_right * s_elbow + fore_tube_1);
    // body left_tip on left_arm
    let left_tip_1 = p.l * p.l * p.rho * p.g * s_left / 2.0 + p.l * p.m_t * p.g * s_left;
    // body right_tube on right_arm
    let right_tube_1 = left_tip_1 + p.l_u * p.l_u * p.rho * p.g * s_right / 2.0;
    right_tube_1 + p.l_u * p.m_e * p.g * s_right + p.l_f * p.rho * fore_tube_2
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 4] {
    let State { q, v } = x;
    let (s_left, c_left) = sin_cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_rho = p.l * p.rho;
    let l_per_two = p.l / 2.0;
    let l_rho_l_per_two = l_rho * l_per_two;
    let l_m_t = p.l * p.m_t;
    // frame left_arm on column
    let mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    let I_left_arm_yy = p.rho * powi(p.l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p.l * l_m_t;
    let omega_left_arm_x = -s_left * v.psi;
    let alpha_left_arm_z = omega_left_arm_x * v.left;
    let alpha_left_arm_z_2 = c_left * a.psi + alpha_left_arm_z;
    let left_arm_1 = I_left_arm_yy * a.left - I_left_arm_yy * omega_left_arm_x * c_left * v.psi;
    let l_u_rho = p.l_u * p.rho;
    let l_u_per_two = p.l_u / 2.0;
    let l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    let l_u_m_e = p.l_u * p.m_e;
    // frame right_arm on column
    let mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    let I_right_arm_yy = p.rho * powi(p.l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two + p.l_u * l_u_m_e;
    let omega_right_arm_z = c_right * v.psi;
    let omega_right_arm_x = s_right * v.psi;
    let alpha_right_arm_z = -omega_right_arm_x * v.right;
    let right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    let alpha_right_arm_x = omega_right_arm_z * v.right + s_right * a.psi;
    let alpha_right_arm_z_2 = c_right * a.psi + alpha_right_arm_z;
    let right_arm_2 = alpha_right_arm_z_2 + alpha_right_arm_z;
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let mc_forearm_x = m_forearm * l_f_per_two;
    let I_forearm_yy = p.rho * powi(p.l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    // frame forearm on right_arm
    let omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    let omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    let omega_forearm_y = -v.right - v.elbow;
    let forearm_1 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z);
    let forearm_2 = omega_forearm_x * omega_forearm_y;
    let forearm_3 = omega_forearm_z * omega_forearm_x;
    let forearm_4 = alpha_right_arm_z_2 * c_elbow - alpha_right_arm_x * s_elbow;
    let alpha_forearm_z = forearm_4 - omega_forearm_x * v.elbow;
    // frame left_arm on column
    let a_left_arm_1_x = p.a * v.psi * v.psi;
    let a_left_arm_z = a_left_arm_1_x * s_left + p.g * c_left;
    // frame right_arm on column
    let a_right_arm_z = a_left_arm_1_x * s_right + p.g * c_right;
    let a_right_arm_x = p.g * s_right - a_left_arm_1_x * c_right;
    // frame forearm on right_arm
    let a_forearm_1_x = a_right_arm_x - p.l_u * (v.right * v.right + omega_right_arm_z * omega_right_arm_z);
    let a_forearm_1_z = a_right_arm_z + p.l_u * (a.right + right_arm_1);
    // gravity
    let alpha_forearm_y = -a.right - a.elbow;
    let a_left_arm_1_y = -p.a * a.psi;
    // frame left_arm on column
    let f_net_left_arm_y = a_left_arm_1_y * (p.m_t + l_rho) + mc_left_arm_x * (alpha_left_arm_z_2 + alpha_left_arm_z);
    let n_net_left_arm_z = mc_left_arm_x * a_left_arm_1_y + I_left_arm_yy * alpha_left_arm_z_2 + I_left_arm_yy * alpha_left_arm_z;
    // frame right_arm on column
    let right_arm_3 = I_right_arm_yy * alpha_right_arm_z_2 - mc_right_arm_x * a_left_arm_1_y + I_right_arm_yy * alpha_right_arm_z;
    // frame forearm on right_arm
    let a_forearm_1_y = p.l_u * right_arm_2 - a_left_arm_1_y;
    let a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x * s_elbow;
    let a_forearm_x = a_forearm_1_x * c_elbow + a_forearm_1_z * s_elbow;
    let f_net_forearm_y = m_forearm * a_forearm_1_y + mc_forearm_x * (alpha_forearm_z + forearm_2);
    let f_net_forearm_z = m_forearm * a_forearm_z + mc_forearm_x * (forearm_3 - alpha_forearm_y);
    let n_net_forearm_y = I_forearm_yy * alpha_forearm_y - mc_forearm_x * a_forearm_z - I_forearm_yy * forearm_3;
    let n_net_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_2;
    let n_net_left_arm_y = left_arm_1 - mc_left_arm_x * a_left_arm_z - u.tau_l;
    let forearm_5 = u.tau_r - mc_right_arm_x * a_right_arm_z - I_right_arm_yy * right_arm_1 - I_right_arm_yy * a.right;
    let forearm_6 = s_elbow * (m_forearm * a_forearm_x - forearm_1);
    let forearm_1_1 = p.l_u * (f_net_forearm_z * c_elbow + forearm_6) - n_net_forearm_y;
    // frame right_arm on column
    let f_net_right_arm_y = mc_right_arm_x * right_arm_2 - a_left_arm_1_y * (p.m_e + l_u_rho) + f_net_forearm_y;
    let n_net_right_arm_z = right_arm_3 + n_net_forearm_z * c_elbow + p.l_u * f_net_forearm_y;
    let n_net_right_arm_1_z = n_net_right_arm_z * c_right - n_net_forearm_z * s_right * s_elbow;
    // frame left_arm on column
    let left_arm_1_1 = n_net_left_arm_z * c_left - p.a * f_net_left_arm_y;
    // frame column on ground
    let n_net_column_z = p.I_c * a.psi + n_net_right_arm_1_z + p.a * f_net_right_arm_y + left_arm_1_1;
    [
        p.c_psi * v.psi + n_net_column_z - u.tau_psi, // psi
        p.c_s * v.left + n_net_left_arm_y, // left
        p.c_s * v.right + forearm_1_1 - forearm_5, // right
        p.c_s * v.elbow - n_net_forearm_y - u.tau_e, // elbow
    ]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.psi, q.left, q.right, q.elbow])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 4] {
    let State { q, .. } = x;
    let c_left = cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_rho = p.l * p.rho;
    let l_per_two = p.l / 2.0;
    let l_rho_l_per_two = l_rho * l_per_two;
    let l_m_t = p.l * p.m_t;
    // frame left_arm on column
    let I_left_arm_yy = p.rho * powi(p.l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p.l * l_m_t;
    let left_arm_1 = c_left * (l_rho_l_per_two + l_m_t);
    let l_u_rho = p.l_u * p.rho;
    let l_u_per_two = p.l_u / 2.0;
    let l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    let l_u_m_e = p.l_u * p.m_e;
    // frame right_arm on column
    let I_right_arm_yy = p.rho * powi(p.l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two + p.l_u * l_u_m_e;
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let mc_forearm_x = m_forearm * l_f_per_two;
    let I_forearm_yy = p.rho * powi(p.l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    let mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    let mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    // frame forearm on right_arm
    let M_right_elbow = I_forearm_yy + p.l_u * mc_forearm_x_c_elbow;
    let I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    let I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    let forearm_1 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    let forearm_1_1 = mc_forearm_x_c_elbow + p.l_u * m_forearm;
    let forearm_1_2 = p.l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    // frame right_arm on column
    let right_arm_1 = c_right * (l_u_rho_l_u_per_two + l_u_m_e + forearm_1_1);
    let right_arm_2 = right_arm_1 - mc_forearm_x_s_elbow * s_right;
    let right_arm_3 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_1;
    let right_arm_4 = 2.0 * s_right * (I_forearm_yy_c_elbow * s_elbow + p.l_u * mc_forearm_x_s_elbow);
    let right_arm_5 = c_right * (right_arm_3 * c_right - right_arm_4);
    let right_arm_1_1 = p.a * (right_arm_2 + right_arm_2 + p.a * (p.m_e + l_u_rho + m_forearm));
    // frame left_arm on column
    let left_arm_1_1 = p.a * (left_arm_1 + left_arm_1 + p.a * (p.m_t + l_rho));
    let left_arm_1_2 = I_left_arm_yy * c_left * c_left + left_arm_1_1;
    // frame column on ground
    let M_psi_psi = p.I_c + forearm_1 + right_arm_5 + right_arm_1_1 + left_arm_1_2;
    // M = L^T D L and back-substitution
    let pivot_right = I_right_arm_yy + I_forearm_yy + forearm_1_2 - M_right_elbow * M_right_elbow / I_forearm_yy;
    [M_psi_psi, I_left_arm_yy, pivot_right, I_forearm_yy]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 219 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_left, c_left) = sin_cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_rho = p.l * p.rho;
    let l_per_two = p.l / 2.0;
    let l_rho_l_per_two = l_rho * l_per_two;
    let l_m_t = p.l * p.m_t;
    // frame left_arm on column
    let mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    let I_left_arm_yy = p.rho * powi(p.l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p.l * l_m_t;
    let omega_left_arm_x = -s_left * v.psi;
    let alpha_left_arm_z = omega_left_arm_x * v.left;
    let n_moving_left_arm_1_z = 2.0 * I_left_arm_yy * alpha_left_arm_z * c_left;
    let mc_left_arm_x_c_left = mc_left_arm_x * c_left;
    let l_u_rho = p.l_u * p.rho;
    let l_u_per_two = p.l_u / 2.0;
    let l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    let l_u_m_e = p.l_u * p.m_e;
    // frame right_arm on column
    let mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    let I_right_arm_yy = p.rho * powi(p.l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two + p.l_u * l_u_m_e;
    let omega_right_arm_z = c_right * v.psi;
    let omega_right_arm_x = s_right * v.psi;
    let alpha_right_arm_z = -omega_right_arm_x * v.right;
    let two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    let right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let mc_forearm_x = m_forearm * l_f_per_two;
    let I_forearm_yy = p.rho * powi(p.l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    // frame forearm on right_arm
    let omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    let omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    let omega_forearm_y = -v.right - v.elbow;
    let forearm_1 = omega_right_arm_z * s_elbow * v.right - alpha_right_arm_z * c_elbow;
    let alpha_forearm_z = -omega_forearm_x * v.elbow - forearm_1;
    let forearm_2 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z);
    let forearm_3 = omega_forearm_x * omega_forearm_y;
    let forearm_4 = omega_forearm_z * omega_forearm_x;
    let mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    let mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    let M_right_elbow = I_forearm_yy + p.l_u * mc_forearm_x_c_elbow;
    let I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    let I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    let forearm_5 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    // frame left_arm on column
    let a_left_arm_1_x = p.a * v.psi * v.psi;
    let left_arm_1_1 = p.a * (p.a * (p.m_t + l_rho) - mc_left_arm_x_c_left - mc_left_arm_x_c_left);
    let left_arm_1_2 = I_left_arm_yy * c_left * c_left + left_arm_1_1;
    // frame forearm on right_arm
    let a_forearm_1_y = p.l_u * two_alpha_right_arm_z;
    let forearm_1_1 = mc_forearm_x_c_elbow + p.l_u * m_forearm;
    let forearm_1_2 = p.l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    let f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_3);
    let n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_3;
    let forearm_1_3 = n_moving_forearm_z * c_elbow + p.l_u * f_moving_forearm_y;
    // frame right_arm on column
    let n_moving_right_arm_z = 2.0 * I_right_arm_yy * alpha_right_arm_z + forearm_1_3;
    let right_arm_2 = n_moving_forearm_z * s_right * s_elbow;
    let a_right_arm_z = a_left_arm_1_x * s_right + p.g * c_right;
    let a_right_arm_x = p.g * s_right - a_left_arm_1_x * c_right;
    let right_arm_3 = c_right * (mc_right_arm_x + forearm_1_1);
    let right_arm_4 = right_arm_3 - mc_forearm_x_s_elbow * s_right;
    let right_arm_5 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_5;
    let right_arm_6 = 2.0 * s_right * (I_forearm_yy_c_elbow * s_elbow + p.l_u * mc_forearm_x_s_elbow);
    let right_arm_7 = c_right * (right_arm_5 * c_right - right_arm_6);
    let right_arm_1_1 = p.a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    let right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_2 + right_arm_1_1;
    let right_arm_1_3 = p.a * (right_arm_4 + right_arm_4 + p.a * (p.m_e + l_u_rho + m_forearm));
    // frame column on ground
    let n_moving_column_z = right_arm_1_2 + n_moving_left_arm_1_z - 2.0 * p.a * mc_left_arm_x * alpha_left_arm_z;
    let M_psi_psi = p.I_c + forearm_5 + right_arm_7 + right_arm_1_3 + left_arm_1_2;
    // frame left_arm on column
    let a_left_arm_z = a_left_arm_1_x * s_left + p.g * c_left;
    let n_left_arm_y = -I_left_arm_yy * omega_left_arm_x * c_left * v.psi - mc_left_arm_x * a_left_arm_z;
    // frame forearm on right_arm
    let a_forearm_1_x = a_right_arm_x - p.l_u * (v.right * v.right + omega_right_arm_z * omega_right_arm_z);
    let a_forearm_1_z = p.l_u * right_arm_1 + a_right_arm_z;
    let a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x * s_elbow;
    let a_forearm_x = a_forearm_1_z * s_elbow + a_forearm_1_x * c_elbow;
    let f_forearm_z = mc_forearm_x * forearm_4 + m_forearm * a_forearm_z;
    let n_forearm_y = -I_forearm_yy * forearm_4 - mc_forearm_x * a_forearm_z;
    let forearm_6 = s_elbow * (m_forearm * a_forearm_x - forearm_2);
    let forearm_1_4 = p.l_u * (f_forearm_z * c_elbow + forearm_6) - n_forearm_y;
    // frame right_arm on column
    let right_arm_8 = forearm_1_4 - u.tau_r + I_right_arm_yy * right_arm_1 + mc_right_arm_x * a_right_arm_z;
    // balance of forces
    let tau_psi = u.tau_psi - p.c_psi * v.psi - n_moving_column_z;
    let tau_left = u.tau_l - p.c_s * v.left - n_left_arm_y;
    let tau_elbow = n_forearm_y - p.c_s * v.elbow + u.tau_e;
    // M = L^T D L and back-substitution
    let inv_elbow = 1.0 / I_forearm_yy;
    let l_elbow_right = M_right_elbow * inv_elbow;
    let pivot_right = I_right_arm_yy + I_forearm_yy + forearm_1_2 - M_right_elbow * l_elbow_right;
    let right_ddot = (-tau_elbow * l_elbow_right - p.c_s * v.right - right_arm_8) / pivot_right;
    let elbow_ddot = tau_elbow * inv_elbow - l_elbow_right * right_ddot;
    positive(I_forearm_yy, 3)?;
    positive(pivot_right, 2)?;
    positive(I_left_arm_yy, 1)?;
    positive(M_psi_psi, 0)?;
    Ok(Accelerations::from_array([tau_psi / M_psi_psi, tau_left / I_left_arm_yy, right_ddot, elbow_ddot]))
}

/// x' and its Jacobians at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// x'.
    pub dx: [f64; 8],
    /// A = dx'/dx, 8 x 8.
    pub a: [[f64; 8]; 8],
    /// B = dx'/du, 8 x 4.
    pub b: [[f64; 4]; 8],
}

/// State derivative and its Jacobians A, B, exact, at any state.
/// 598 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///          psi left right elbow psi.dot left.dot right.dot elbow.dot | tau_psi tau_l tau_r tau_e
/// psi'     .   .    .     .     1       .        .         .         | .       .     .     .
/// left'    .   .    .     .     .       1        .         .         | .       .     .     .
/// right'   .   .    .     .     .       .        1         .         | .       .     .     .
/// elbow'   .   .    .     .     .       .        .         1         | .       .     .     .
/// psi''    .   *    *     *     *       *        *         *         | *       .     .     .
/// left''   .   *    .     .     *       *        .         .         | .       *     .     .
/// right''  .   .    *     *     *       .        *         *         | .       .     *     *
/// elbow''  .   .    *     *     *       .        *         *         | .       .     *     *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_left, c_left) = sin_cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_rho = p.l * p.rho;
    let l_per_two = p.l / 2.0;
    let l_rho_l_per_two = l_rho * l_per_two;
    let l_m_t = p.l * p.m_t;
    // frame left_arm on column
    let mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    let I_left_arm_yy = p.rho * powi(p.l, 3) / 12.0 + l_per_two * l_rho_l_per_two + p.l * l_m_t;
    let omega_left_arm_z = c_left * v.psi;
    let omega_left_arm_x = -s_left * v.psi;
    let alpha_left_arm_x = -omega_left_arm_z * v.left;
    let alpha_left_arm_z = omega_left_arm_x * v.left;
    let left_arm_1 = I_left_arm_yy * alpha_left_arm_z;
    let mc_left_arm_x_c_left = mc_left_arm_x * c_left;
    let l_u_rho = p.l_u * p.rho;
    let l_u_per_two = p.l_u / 2.0;
    let l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    let l_u_m_e = p.l_u * p.m_e;
    // frame right_arm on column
    let mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    let I_right_arm_yy = p.rho * powi(p.l_u, 3) / 12.0 + l_u_per_two * l_u_rho_l_u_per_two + p.l_u * l_u_m_e;
    let omega_right_arm_z = c_right * v.psi;
    let omega_right_arm_x = s_right * v.psi;
    let alpha_right_arm_x = omega_right_arm_z * v.right;
    let alpha_right_arm_z = -omega_right_arm_x * v.right;
    let omega_right_arm_z_sq = omega_right_arm_z * omega_right_arm_z;
    let two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    let right_arm_1 = omega_right_arm_z * omega_right_arm_x;
    let right_arm_2 = I_right_arm_yy * alpha_right_arm_z;
    let right_arm_3 = omega_right_arm_z_sq - omega_right_arm_x * omega_right_arm_x;
    let a_right_arm_x = p.g * s_right;
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let mc_forearm_x = m_forearm * l_f_per_two;
    let I_forearm_yy = p.rho * powi(p.l_f, 3) / 12.0 + l_f_per_two * mc_forearm_x;
    // frame forearm on right_arm
    let omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    let omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    let omega_forearm_y = -v.right - v.elbow;
    let omega_forearm_x_elbow_dot = omega_forearm_x * v.elbow;
    let alpha_forearm_z = alpha_right_arm_z * c_elbow - omega_forearm_x_elbow_dot - alpha_right_arm_x * s_elbow;
    let omega_forearm_z_sq = omega_forearm_z * omega_forearm_z;
    let forearm_1 = mc_forearm_x * (omega_forearm_y * omega_forearm_y + omega_forearm_z_sq);
    let forearm_2 = omega_forearm_x * omega_forearm_y;
    let forearm_3 = omega_forearm_z * omega_forearm_x;
    let forearm_4 = omega_forearm_z * omega_forearm_y;
    let forearm_5 = omega_forearm_z_sq - omega_forearm_x * omega_forearm_x;
    let I_forearm_yy_forearm_2 = I_forearm_yy * forearm_2;
    let mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    let mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    let M_right_elbow = I_forearm_yy + p.l_u * mc_forearm_x_c_elbow;
    let I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    let I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    let forearm_6 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    // frame left_arm on column
    let a_left_arm_1_x = p.a * v.psi * v.psi;
    let left_arm_1_1 = 2.0 * left_arm_1 * c_left - 2.0 * p.a * mc_left_arm_x * alpha_left_arm_z;
    let left_arm_1_2 = p.a * (p.a * (p.m_t + l_rho) - mc_left_arm_x_c_left - mc_left_arm_x_c_left);
    let left_arm_1_3 = I_left_arm_yy * c_left * c_left + left_arm_1_2;
    // frame right_arm on column
    let a_right_arm_x_2 = -a_left_arm_1_x * c_right;
    let a_right_arm_z = a_left_arm_1_x * s_right + p.g * c_right;
    let right_arm_4 = 2.0 * s_right * (I_forearm_yy_c_elbow * s_elbow + p.l_u * mc_forearm_x_s_elbow);
    // frame forearm on right_arm
    let a_forearm_1_y = p.l_u * two_alpha_right_arm_z;
    let a_forearm_1_x = a_right_arm_x + a_right_arm_x_2 - p.l_u * (v.right * v.right + omega_right_arm_z_sq);
    let a_forearm_1_z = p.l_u * right_arm_1 + a_right_arm_z;
    let forearm_1_1 = mc_forearm_x_c_elbow + p.l_u * m_forearm;
    let forearm_1_2 = p.l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    let f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_2);
    let n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy_forearm_2;
    let a_forearm_1_x_s_elbow = a_forearm_1_x * s_elbow;
    let a_forearm_1_x_c_elbow = a_forearm_1_x * c_elbow;
    let a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x_s_elbow;
    let f_forearm_x = m_forearm * (a_forearm_1_z * s_elbow + a_forearm_1_x_c_elbow) - forearm_1;
    let f_forearm_z = mc_forearm_x * forearm_3 + m_forearm * a_forearm_z;
    let n_forearm_y = -I_forearm_yy * forearm_3 - mc_forearm_x * a_forearm_z;
    let f_forearm_1_z = f_forearm_z * c_elbow + f_forearm_x * s_elbow;
    let forearm_7 = u.tau_r - I_right_arm_yy * right_arm_1 - mc_right_arm_x * a_right_arm_z;
    // frame right_arm on column
    let n_moving_right_arm_z = 2.0 * right_arm_2 + n_moving_forearm_z * c_elbow + p.l_u * f_moving_forearm_y;
    let right_arm_5 = n_moving_forearm_z * s_right * s_elbow;
    let right_arm_6 = c_right * (mc_right_arm_x + forearm_1_1);
    let right_arm_7 = right_arm_6 - mc_forearm_x_s_elbow * s_right;
    let right_arm_8 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_6;
    let right_arm_9 = c_right * (right_arm_8 * c_right - right_arm_4);
    let right_arm_1_1 = p.a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    let right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_5 + right_arm_1_1;
    let right_arm_1_3 = p.a * (right_arm_7 + right_arm_7 + p.a * (p.m_e + l_u_rho + m_forearm));
    // frame left_arm on column
    let a_left_arm_z = a_left_arm_1_x * s_left + p.g * c_left;
    let a_left_arm_x = a_left_arm_1_x * c_left - p.g * s_left;
    let n_left_arm_y = -I_left_arm_yy * omega_left_arm_z * omega_left_arm_x - mc_left_arm_x * a_left_arm_z;
    // frame column on ground
    let M_psi_psi = p.I_c + forearm_6 + right_arm_9 + right_arm_1_3 + left_arm_1_3;
    // gravity
    let gravity_1 = c_right * c_elbow - s_right * s_elbow;
    let s_left_left_dot = s_left * v.left;
    let s_right_right_dot = s_right * v.right;
    // balance of forces
    let tau_psi = u.tau_psi - p.c_psi * v.psi - right_arm_1_2 - left_arm_1_1;
    let tau_left = u.tau_l - p.c_s * v.left - n_left_arm_y;
    let tau_right = n_forearm_y - p.c_s * v.right - p.l_u * f_forearm_1_z + forearm_7;
    let tau_elbow = n_forearm_y - p.c_s * v.elbow + u.tau_e;
    // M = L^T D L and back-substitution
    let inv_elbow = 1.0 / I_forearm_yy;
    let l_elbow_right = M_right_elbow * inv_elbow;
    let pivot_right = I_right_arm_yy + I_forearm_yy + forearm_1_2 - M_right_elbow * l_elbow_right;
    let inv_right = 1.0 / pivot_right;
    let inv_left = 1.0 / I_left_arm_yy;
    let inv_psi = 1.0 / M_psi_psi;
    let psi_ddot = tau_psi * inv_psi;
    let right_ddot = inv_right * (tau_right - tau_elbow * l_elbow_right);
    let elbow_ddot = tau_elbow * inv_elbow - l_elbow_right * right_ddot;
    // derivatives with respect to left
    let by_left_1 = I_left_arm_yy * (omega_left_arm_z * omega_left_arm_z - omega_left_arm_x * omega_left_arm_x);
    let d_left_ddot_by_left = -inv_left * (by_left_1 - mc_left_arm_x * a_left_arm_x);
    let two_omega_right_arm_z = 2.0 * omega_right_arm_z;
    let two_omega_forearm_z = 2.0 * omega_forearm_z;
    // derivatives with respect to right
    let by_right_1 = mc_forearm_x * omega_forearm_x * two_omega_forearm_z;
    let I_forearm_yy_forearm_5 = I_forearm_yy * forearm_5;
    let by_right_2 = a_right_arm_x_2 + a_right_arm_x;
    let by_right_3 = a_right_arm_z + p.l_u * omega_right_arm_x * two_omega_right_arm_z;
    let by_right_4 = I_right_arm_yy * right_arm_3 - mc_right_arm_x * by_right_2;
    let by_right_5 = p.l_u * right_arm_3 - by_right_2;
    let by_right_6 = by_right_5 * c_elbow - by_right_3 * s_elbow;
    let by_right_7 = m_forearm * (by_right_3 * c_elbow + by_right_5 * s_elbow);
    let mc_forearm_x_forearm_5 = mc_forearm_x * forearm_5;
    let by_right_8 = I_forearm_yy_forearm_5 + mc_forearm_x * by_right_6;
    let by_right_9 = c_elbow * (m_forearm * by_right_6 + mc_forearm_x_forearm_5);
    let by_right_10 = p.l_u * (by_right_9 + s_elbow * (by_right_1 + by_right_7));
    let by_right_11 = l_elbow_right * by_right_8 - by_right_4 - by_right_8 - by_right_10;
    let d_right_ddot_by_right = inv_right * by_right_11;
    let d_elbow_ddot_by_right = -inv_elbow * by_right_8 - l_elbow_right * d_right_ddot_by_right;
    // derivatives with respect to psi_dot
    let by_psi_dot_1 = c_right * s_elbow + s_right * c_elbow;
    let two_a_psi_dot = 2.0 * p.a * v.psi;
    let by_psi_dot_2 = I_left_arm_yy * (omega_left_arm_z * s_left - omega_left_arm_x * c_left);
    let two_a_psi_dot_s_right = two_a_psi_dot * s_right;
    let by_psi_dot_3 = omega_right_arm_x * c_right + omega_right_arm_z * s_right;
    let omega_forearm_y_by_psi_dot_1 = omega_forearm_y * by_psi_dot_1;
    let by_psi_dot_4 = omega_forearm_x * gravity_1 + omega_forearm_z * by_psi_dot_1;
    let by_psi_dot_5 = two_a_psi_dot * c_right + p.l_u * two_omega_right_arm_z * c_right;
    let two_s_right_right_dot = 2.0 * s_right_right_dot;
    let l_u_two_s_right_right_dot = p.l_u * two_s_right_right_dot;
    let by_psi_dot_6 = two_a_psi_dot_s_right + p.l_u * by_psi_dot_3;
    let by_psi_dot_7 = s_right_right_dot * c_elbow + s_elbow * c_right * v.right;
    let by_psi_dot_8 = by_psi_dot_1 * v.elbow + by_psi_dot_7;
    let by_psi_dot_9 = by_psi_dot_5 * s_elbow + by_psi_dot_6 * c_elbow;
    let by_psi_dot_10 = m_forearm * (by_psi_dot_6 * s_elbow - by_psi_dot_5 * c_elbow);
    let by_psi_dot_11 = m_forearm * l_u_two_s_right_right_dot + mc_forearm_x * (by_psi_dot_8 - omega_forearm_y_by_psi_dot_1);
    let by_psi_dot_12 = I_forearm_yy * by_psi_dot_8 - I_forearm_yy * omega_forearm_y_by_psi_dot_1;
    let by_psi_dot_13 = I_forearm_yy * by_psi_dot_4 + mc_forearm_x * by_psi_dot_9;
    let by_psi_dot_14 = mc_forearm_x * l_u_two_s_right_right_dot + by_psi_dot_12;
    let by_psi_dot_15 = c_elbow * (m_forearm * by_psi_dot_9 + mc_forearm_x * by_psi_dot_4);
    let by_psi_dot_16 = s_elbow * (by_psi_dot_10 - mc_forearm_x * gravity_1 * two_omega_forearm_z);
    let by_psi_dot_17 = by_psi_dot_13 + p.l_u * (by_psi_dot_15 + by_psi_dot_16);
    let by_psi_dot_18 = by_psi_dot_14 * c_elbow + p.l_u * by_psi_dot_11;
    let by_psi_dot_19 = I_right_arm_yy * by_psi_dot_3 + mc_right_arm_x * two_a_psi_dot_s_right + by_psi_dot_17;
    let by_psi_dot_20 = c_right * (-2.0 * I_right_arm_yy * s_right_right_dot - by_psi_dot_18);
    let by_psi_dot_21 = by_psi_dot_20 + by_psi_dot_14 * s_right * s_elbow;
    let by_psi_dot_22 = p.a * (-mc_right_arm_x * two_s_right_right_dot - by_psi_dot_11);
    let by_psi_dot_23 = 2.0 * I_left_arm_yy * s_left_left_dot * c_left;
    let by_psi_dot_24 = 2.0 * p.a * mc_left_arm_x * s_left_left_dot - by_psi_dot_23;
    let d_psi_ddot_by_psi_dot = -inv_psi * (p.c_psi + by_psi_dot_21 + by_psi_dot_22 + by_psi_dot_24);
    let d_left_ddot_by_psi_dot = -inv_left * (by_psi_dot_2 - mc_left_arm_x * two_a_psi_dot * s_left);
    let d_right_ddot_by_psi_dot = inv_right * (l_elbow_right * by_psi_dot_13 - by_psi_dot_19);
    let d_elbow_ddot_by_psi_dot = -inv_elbow * by_psi_dot_13 - l_elbow_right * d_right_ddot_by_psi_dot;
    // derivatives with respect to left_dot
    let by_left_dot_1 = 2.0 * I_left_arm_yy * omega_left_arm_x * c_left - 2.0 * p.a * mc_left_arm_x * omega_left_arm_x;
    let two_l_u_right_dot = 2.0 * p.l_u * v.right;
    // derivatives with respect to right_dot
    let by_right_dot_1 = 2.0 * mc_forearm_x * omega_forearm_y;
    let two_l_u_right_dot_s_elbow = two_l_u_right_dot * s_elbow;
    let two_omega_right_arm_x = 2.0 * omega_right_arm_x;
    let l_u_two_omega_right_arm_x = p.l_u * two_omega_right_arm_x;
    let by_right_dot_2 = 2.0 * mc_forearm_x * omega_forearm_x;
    let by_right_dot_3 = m_forearm * l_u_two_omega_right_arm_x + by_right_dot_2;
    let by_right_dot_4 = mc_forearm_x * two_l_u_right_dot_s_elbow;
    let by_right_dot_5 = 2.0 * I_forearm_yy * omega_forearm_x;
    let by_right_dot_6 = mc_forearm_x * l_u_two_omega_right_arm_x + by_right_dot_5;
    let by_right_dot_7 = s_elbow * (m_forearm * two_l_u_right_dot * c_elbow - by_right_dot_1);
    let by_right_dot_8 = p.l_u * (m_forearm * two_l_u_right_dot_s_elbow * c_elbow - by_right_dot_7);
    let by_right_dot_9 = by_right_dot_6 * c_elbow + p.l_u * by_right_dot_3;
    let by_right_dot_10 = c_right * (-2.0 * I_right_arm_yy * omega_right_arm_x - by_right_dot_9);
    let by_right_dot_11 = by_right_dot_10 + by_right_dot_6 * s_right * s_elbow;
    let by_right_dot_12 = p.a * (-mc_right_arm_x * two_omega_right_arm_x - by_right_dot_3);
    let d_right_ddot_by_right_dot = inv_right * (l_elbow_right * by_right_dot_4 - p.c_s - by_right_dot_4 - by_right_dot_8);
    let d_elbow_ddot_by_right_dot = -inv_elbow * by_right_dot_4 - l_elbow_right * d_right_ddot_by_right_dot;
    // derivatives with respect to elbow_dot
    let by_elbow_dot_1 = c_right * (-by_right_dot_5 * c_elbow - p.l_u * by_right_dot_2);
    let by_elbow_dot_2 = by_elbow_dot_1 + by_right_dot_5 * s_right * s_elbow;
    let d_psi_ddot_by_elbow_dot = -inv_psi * (by_elbow_dot_2 - p.a * by_right_dot_2);
    let d_right_ddot_by_elbow_dot = inv_right * (p.c_s * l_elbow_right - p.l_u * by_right_dot_1 * s_elbow);
    let d_elbow_ddot_by_elbow_dot = -p.c_s * inv_elbow - l_elbow_right * d_right_ddot_by_elbow_dot;
    let a_psi_ddot = p.a * psi_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = psi_ddot * s_left - alpha_left_arm_x;
    let slopes_2 = I_left_arm_yy * (-alpha_left_arm_z - psi_ddot * c_left) - left_arm_1;
    let slopes_3 = alpha_right_arm_x + psi_ddot * s_right;
    let slopes_4 = alpha_right_arm_z + psi_ddot * c_right;
    let slopes_5 = mc_right_arm_x * a_psi_ddot + right_arm_2 + I_right_arm_yy * slopes_4;
    let slopes_6 = p.l_u * (-alpha_right_arm_z - slopes_4) - a_psi_ddot;
    let slopes_7 = a_right_arm_z + p.l_u * (right_arm_1 + right_ddot);
    let slopes_8 = slopes_3 * s_elbow - slopes_4 * c_elbow;
    let slopes_9 = slopes_3 * c_elbow + slopes_4 * s_elbow;
    let slopes_10 = omega_forearm_z * v.elbow + slopes_9;
    let slopes_11 = omega_forearm_x_elbow_dot + slopes_8;
    let slopes_12 = a_forearm_1_x_c_elbow + slopes_7 * s_elbow;
    let m_forearm_slopes_12 = m_forearm * slopes_12;
    let slopes_13 = m_forearm * (slopes_7 * c_elbow - a_forearm_1_x_s_elbow);
    let slopes_14 = slopes_13 + mc_forearm_x * (forearm_3 + right_ddot + elbow_ddot);
    let slopes_15 = mc_forearm_x * slopes_6 - I_forearm_yy_forearm_2 + I_forearm_yy * slopes_11;
    let slopes_15_c_elbow = slopes_15 * c_elbow;
    let slopes_15_s_elbow = slopes_15 * s_elbow;
    let slopes_16 = p.l_u * (m_forearm * slopes_6 + mc_forearm_x * (slopes_11 - forearm_2));
    let slopes_17 = s_right * (slopes_15_c_elbow - slopes_5 + slopes_16);
    let slopes_18 = s_left * (mc_left_arm_x * a_psi_ddot + slopes_2);
    let slopes_19 = c_left * (I_left_arm_yy * slopes_1 - I_left_arm_yy * alpha_left_arm_x);
    let slopes_20 = p.a * mc_left_arm_x * (slopes_1 - alpha_left_arm_x);
    let slopes_21 = alpha_right_arm_x + slopes_3;
    let l_u_slopes_21 = p.l_u * slopes_21;
    let slopes_22 = mc_forearm_x * (slopes_10 - forearm_4);
    let slopes_23 = m_forearm * l_u_slopes_21 + slopes_22;
    let slopes_24 = I_forearm_yy * slopes_10 - I_forearm_yy * forearm_4;
    let slopes_25 = mc_forearm_x * l_u_slopes_21 + slopes_24;
    let slopes_26 = slopes_25 * c_elbow + p.l_u * slopes_23;
    let slopes_27 = I_right_arm_yy * alpha_right_arm_x + I_right_arm_yy * slopes_3 + slopes_26;
    let slopes_25_s_right_s_elbow = slopes_25 * s_right * s_elbow;
    let slopes_28 = slopes_15_s_elbow * c_right + slopes_25_s_right_s_elbow;
    let slopes_29 = slopes_27 * c_right - slopes_17 - slopes_28;
    let slopes_30 = p.a * (mc_right_arm_x * slopes_21 + slopes_23);
    let mc_forearm_x_slopes_12 = mc_forearm_x * slopes_12;
    let slopes_31 = c_elbow * (mc_forearm_x_forearm_5 - m_forearm_slopes_12);
    let slopes_32 = s_elbow * (by_right_1 + slopes_13);
    let slopes_33 = c_elbow * (m_forearm_slopes_12 - forearm_1) + slopes_32;
    let slopes_34 = p.l_u * (slopes_31 - slopes_14 * s_elbow + slopes_33);
    let slopes_35 = slopes_24 * c_elbow - slopes_15_s_elbow + p.l_u * slopes_22;
    let slopes_36 = s_right * (slopes_15_c_elbow + slopes_24 * s_elbow);
    let slopes_37 = slopes_35 * c_right - slopes_36 + p.a * slopes_22;
    // derivatives with respect to left
    let d_psi_ddot_by_left = inv_psi * (slopes_19 - slopes_18 - slopes_20);
    // derivatives with respect to elbow
    let by_elbow_1 = mc_forearm_x_slopes_12 - I_forearm_yy_forearm_5;
    let by_elbow_2 = I_forearm_yy_forearm_5 - mc_forearm_x_slopes_12 + slopes_34 + l_elbow_right * by_elbow_1;
    let d_right_ddot_by_elbow = -inv_right * by_elbow_2;
    let d_elbow_ddot_by_elbow = inv_elbow * by_elbow_1 - l_elbow_right * d_right_ddot_by_elbow;
    // derivatives with respect to tau_r
    let d_elbow_ddot_by_tau_r = -l_elbow_right * inv_right;
    positive(I_forearm_yy, 3)?;
    positive(pivot_right, 2)?;
    positive(I_left_arm_yy, 1)?;
    positive(M_psi_psi, 0)?;
    Ok(Linearization {
        dx: [v.psi, v.left, v.right, v.elbow, psi_ddot, tau_left * inv_left, right_ddot, elbow_ddot],
        a: [
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], // psi'
            [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0], // left'
            [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0], // right'
            [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], // elbow'
            // psi''
            [
                0.0, d_psi_ddot_by_left, inv_psi * (slopes_29 + slopes_30), inv_psi * slopes_37, d_psi_ddot_by_psi_dot,
                -inv_psi * by_left_dot_1, -inv_psi * (by_right_dot_11 + by_right_dot_12), d_psi_ddot_by_elbow_dot,
            ],
            [0.0, d_left_ddot_by_left, 0.0, 0.0, d_left_ddot_by_psi_dot, -p.c_s * inv_left, 0.0, 0.0], // left''
            // right''
            [
                0.0, 0.0, d_right_ddot_by_right, d_right_ddot_by_elbow, d_right_ddot_by_psi_dot, 0.0, d_right_ddot_by_right_dot,
                d_right_ddot_by_elbow_dot,
            ],
            // elbow''
            [
                0.0, 0.0, d_elbow_ddot_by_right, d_elbow_ddot_by_elbow, d_elbow_ddot_by_psi_dot, 0.0, d_elbow_ddot_by_right_dot,
                d_elbow_ddot_by_elbow_dot,
            ],
        ],
        b: [
            [0.0, 0.0, 0.0, 0.0], // psi'
            [0.0, 0.0, 0.0, 0.0], // left'
            [0.0, 0.0, 0.0, 0.0], // right'
            [0.0, 0.0, 0.0, 0.0], // elbow'
            [inv_psi, 0.0, 0.0, 0.0], // psi''
            [0.0, inv_left, 0.0, 0.0], // left''
            [0.0, 0.0, inv_right, d_elbow_ddot_by_tau_r], // right''
            [0.0, 0.0, d_elbow_ddot_by_tau_r, inv_elbow - l_elbow_right * d_elbow_ddot_by_tau_r], // elbow''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 8 x 11; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 11]; 8], Singular> {
    let State { q, v } = x;
    let (s_left, c_left) = sin_cos(q.left);
    let (s_right, c_right) = sin_cos(q.right);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_rho = p.l * p.rho;
    let l_per_two = p.l / 2.0;
    let l_pow3 = powi(p.l, 3);
    let l_rho_l_per_two = l_rho * l_per_two;
    // body left_tube on left_arm
    let left_tube_1 = p.rho * l_pow3 / 12.0 + l_per_two * l_rho_l_per_two;
    let l_m_t = p.l * p.m_t;
    // frame left_arm on column
    let m_left_arm = p.m_t + l_rho;
    let mc_left_arm_x = -l_rho_l_per_two - l_m_t;
    let I_left_arm_yy = left_tube_1 + p.l * l_m_t;
    let omega_left_arm_x = -s_left * v.psi;
    let alpha_left_arm_z = omega_left_arm_x * v.left;
    let left_arm_1 = omega_left_arm_x * c_left * v.psi;
    let n_moving_left_arm_1_z = 2.0 * I_left_arm_yy * alpha_left_arm_z * c_left;
    let mc_left_arm_x_c_left = mc_left_arm_x * c_left;
    let l_u_rho = p.l_u * p.rho;
    let l_u_per_two = p.l_u / 2.0;
    let l_u_pow3 = powi(p.l_u, 3);
    let l_u_rho_l_u_per_two = l_u_rho * l_u_per_two;
    // body right_tube on right_arm
    let right_tube_1 = p.rho * l_u_pow3 / 12.0 + l_u_per_two * l_u_rho_l_u_per_two;
    let l_u_m_e = p.l_u * p.m_e;
    // frame right_arm on column
    let m_right_arm = p.m_e + l_u_rho;
    let mc_right_arm_x = l_u_rho_l_u_per_two + l_u_m_e;
    let I_right_arm_yy = right_tube_1 + p.l_u * l_u_m_e;
    let omega_right_arm_z = c_right * v.psi;
    let omega_right_arm_x = s_right * v.psi;
    let alpha_right_arm_x = omega_right_arm_z * v.right;
    let alpha_right_arm_z = -omega_right_arm_x * v.right;
    let right_arm_1 = v.right * v.right + omega_right_arm_z * omega_right_arm_z;
    let two_alpha_right_arm_z = 2.0 * alpha_right_arm_z;
    let right_arm_2 = omega_right_arm_z * omega_right_arm_x;
    // body fore_tube on forearm
    let m_forearm = p.l_f * p.rho;
    let l_f_per_two = p.l_f / 2.0;
    let l_f_pow3 = powi(p.l_f, 3);
    let mc_forearm_x = m_forearm * l_f_per_two;
    let I_forearm_yy = p.rho * l_f_pow3 / 12.0 + l_f_per_two * mc_forearm_x;
    // frame forearm on right_arm
    let omega_forearm_z = omega_right_arm_z * c_elbow - omega_right_arm_x * s_elbow;
    let omega_forearm_x = omega_right_arm_z * s_elbow + omega_right_arm_x * c_elbow;
    let omega_forearm_y = -v.right - v.elbow;
    let omega_forearm_x_elbow_dot = omega_forearm_x * v.elbow;
    let alpha_forearm_z = alpha_right_arm_z * c_elbow - omega_forearm_x_elbow_dot - alpha_right_arm_x * s_elbow;
    let forearm_1 = omega_forearm_y * omega_forearm_y + omega_forearm_z * omega_forearm_z;
    let mc_forearm_x_forearm_1 = mc_forearm_x * forearm_1;
    let forearm_2 = omega_forearm_x * omega_forearm_y;
    let forearm_3 = omega_forearm_z * omega_forearm_x;
    let mc_forearm_x_c_elbow = mc_forearm_x * c_elbow;
    let mc_forearm_x_s_elbow = mc_forearm_x * s_elbow;
    let M_right_elbow = I_forearm_yy + p.l_u * mc_forearm_x_c_elbow;
    let I_forearm_yy_c_elbow = I_forearm_yy * c_elbow;
    let I_forearm_yy_c_elbow_c_elbow = I_forearm_yy_c_elbow * c_elbow;
    let forearm_4 = I_forearm_yy - I_forearm_yy_c_elbow_c_elbow;
    let psi_dot_sq = v.psi * v.psi;
    // frame left_arm on column
    let a_left_arm_1_x = p.a * psi_dot_sq;
    let left_arm_1_1 = p.a * (p.a * m_left_arm - mc_left_arm_x_c_left - mc_left_arm_x_c_left);
    let left_arm_1_2 = I_left_arm_yy * c_left * c_left + left_arm_1_1;
    // frame forearm on right_arm
    let a_forearm_1_y = p.l_u * two_alpha_right_arm_z;
    let forearm_1_1 = mc_forearm_x_c_elbow + p.l_u * m_forearm;
    let forearm_1_2 = p.l_u * (mc_forearm_x_c_elbow + forearm_1_1);
    let f_moving_forearm_y = m_forearm * a_forearm_1_y - mc_forearm_x * (-alpha_forearm_z - forearm_2);
    let n_moving_forearm_z = mc_forearm_x * a_forearm_1_y + I_forearm_yy * alpha_forearm_z + I_forearm_yy * forearm_2;
    let forearm_1_3 = n_moving_forearm_z * c_elbow + p.l_u * f_moving_forearm_y;
    // frame right_arm on column
    let n_moving_right_arm_z = 2.0 * I_right_arm_yy * alpha_right_arm_z + forearm_1_3;
    let right_arm_3 = n_moving_forearm_z * s_right * s_elbow;
    let a_right_arm_z = a_left_arm_1_x * s_right + p.g * c_right;
    let a_right_arm_x = p.g * s_right - a_left_arm_1_x * c_right;
    let right_arm_4 = c_right * (mc_right_arm_x + forearm_1_1);
    let right_arm_5 = right_arm_4 - mc_forearm_x_s_elbow * s_right;
    let right_arm_6 = I_right_arm_yy + I_forearm_yy_c_elbow_c_elbow + forearm_1_2 - forearm_4;
    let right_arm_7 = 2.0 * s_right * (I_forearm_yy_c_elbow * s_elbow + p.l_u * mc_forearm_x_s_elbow);
    let right_arm_8 = c_right * (right_arm_6 * c_right - right_arm_7);
    let right_arm_1_1 = p.a * (mc_right_arm_x * two_alpha_right_arm_z + f_moving_forearm_y);
    let right_arm_1_2 = n_moving_right_arm_z * c_right - right_arm_3 + right_arm_1_1;
    let right_arm_1_3 = p.a * (right_arm_5 + right_arm_5 + p.a * (m_right_arm + m_forearm));
    // frame column on ground
    let n_moving_column_z = right_arm_1_2 + n_moving_left_arm_1_z - 2.0 * p.a * mc_left_arm_x * alpha_left_arm_z;
    let M_psi_psi = p.I_c + forearm_4 + right_arm_8 + right_arm_1_3 + left_arm_1_2;
    // frame left_arm on column
    let a_left_arm_z = a_left_arm_1_x * s_left + p.g * c_left;
    let n_left_arm_y = -I_left_arm_yy * left_arm_1 - mc_left_arm_x * a_left_arm_z;
    // frame forearm on right_arm
    let a_forearm_1_x = a_right_arm_x - p.l_u * right_arm_1;
    let a_forearm_1_z = p.l_u * right_arm_2 + a_right_arm_z;
    let a_forearm_1_x_s_elbow = a_forearm_1_x * s_elbow;
    let a_forearm_1_x_c_elbow = a_forearm_1_x * c_elbow;
    let a_forearm_z = a_forearm_1_z * c_elbow - a_forearm_1_x_s_elbow;
    let f_forearm_x = m_forearm * (a_forearm_1_z * s_elbow + a_forearm_1_x_c_elbow) - mc_forearm_x_forearm_1;
    let f_forearm_z = mc_forearm_x * forearm_3 + m_forearm * a_forearm_z;
    let n_forearm_y = -I_forearm_yy * forearm_3 - mc_forearm_x * a_forearm_z;
    let f_forearm_1_z = f_forearm_z * c_elbow + f_forearm_x * s_elbow;
    let forearm_5 = u.tau_r - I_right_arm_yy * right_arm_2 - mc_right_arm_x * a_right_arm_z;
    // gravity
    let gravity_1 = c_right * c_elbow - s_right * s_elbow;
    // balance of forces
    let tau_psi = u.tau_psi - p.c_psi * v.psi - n_moving_column_z;
    let tau_left = u.tau_l - p.c_s * v.left - n_left_arm_y;
    let tau_right = n_forearm_y - p.c_s * v.right - p.l_u * f_forearm_1_z + forearm_5;
    let tau_elbow = n_forearm_y - p.c_s * v.elbow + u.tau_e;
    // M = L^T D L and back-substitution
    let inv_elbow = 1.0 / I_forearm_yy;
    let l_elbow_right = M_right_elbow * inv_elbow;
    let pivot_right = I_right_arm_yy + I_forearm_yy + forearm_1_2 - M_right_elbow * l_elbow_right;
    let inv_right = 1.0 / pivot_right;
    let inv_left = 1.0 / I_left_arm_yy;
    let inv_psi = 1.0 / M_psi_psi;
    let psi_ddot = tau_psi * inv_psi;
    let left_ddot = tau_left * inv_left;
    let right_ddot = inv_right * (tau_right - tau_elbow * l_elbow_right);
    let elbow_ddot = tau_elbow * inv_elbow - l_elbow_right * right_ddot;
    let right_ddot_plus_elbow_ddot = right_ddot + elbow_ddot;
    let a_psi_ddot = p.a * psi_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_left_arm_z + psi_ddot * c_left;
    let slopes_2 = alpha_right_arm_z + psi_ddot * c_right;
    let slopes_3 = alpha_right_arm_z + slopes_2;
    let right_arm_2_plus_right_ddot = right_arm_2 + right_ddot;
    let a_psi_ddot_plus_l_u_slopes_3 = a_psi_ddot + p.l_u * slopes_3;
    let slopes_4 = a_right_arm_z + p.l_u * right_arm_2_plus_right_ddot;
    let slopes_5 = s_elbow * (alpha_right_arm_x + psi_ddot * s_right);
    let slopes_6 = omega_forearm_x_elbow_dot - slopes_2 * c_elbow + slopes_5;
    let slopes_7 = slopes_4 * c_elbow - a_forearm_1_x_s_elbow;
    let slopes_8 = a_forearm_1_x_c_elbow + slopes_4 * s_elbow;
    let slopes_6_minus_forearm_2 = slopes_6 - forearm_2;
    let slopes_9 = forearm_3 + right_ddot_plus_elbow_ddot;
    let slopes_10 = mc_forearm_x * slopes_6_minus_forearm_2 - m_forearm * a_psi_ddot_plus_l_u_slopes_3;
    let slopes_11 = alpha_left_arm_z + slopes_1;
    let slopes_12 = c_elbow * (m_forearm * slopes_7 + mc_forearm_x * slopes_9);
    let slopes_13 = slopes_12 + s_elbow * (m_forearm * slopes_8 - mc_forearm_x_forearm_1);
    let slopes_14 = slopes_10 - m_right_arm * a_psi_ddot - mc_right_arm_x * slopes_3;
    let m_forearm_psi_ddot = m_forearm * psi_ddot;
    let mc_forearm_x_psi_ddot = mc_forearm_x * psi_ddot;
    let slopes_15 = mc_right_arm_x * psi_ddot + mc_forearm_x_psi_ddot * c_elbow + p.l_u * m_forearm_psi_ddot;
    let slopes_16 = mc_forearm_x_psi_ddot * s_right * s_elbow;
    let slopes_17 = slopes_15 * c_right - slopes_16;
    let slopes_18 = p.a * (-m_right_arm * psi_ddot - m_forearm_psi_ddot);
    let slopes_19 = mc_left_arm_x * slopes_11 - m_left_arm * a_psi_ddot - p.a * m_left_arm * psi_ddot;
    let slopes_20 = mc_left_arm_x * psi_ddot * c_left + slopes_19;
    let rho_a_psi_ddot = p.rho * a_psi_ddot;
    let slopes_21 = right_arm_1 * s_elbow + right_arm_2_plus_right_ddot * c_elbow;
    let slopes_22 = m_forearm * (right_arm_2_plus_right_ddot * s_elbow - right_arm_1 * c_elbow);
    let m_forearm_slopes_3 = m_forearm * slopes_3;
    let mc_forearm_x_slopes_21 = mc_forearm_x * slopes_21;
    let mc_forearm_x_slopes_3 = mc_forearm_x * slopes_3;
    let slopes_23 = m_forearm * slopes_21 * c_elbow + slopes_22 * s_elbow;
    let slopes_24 = mc_forearm_x_slopes_21 + slopes_13 + p.l_u * slopes_23;
    let slopes_25 = slopes_10 - mc_forearm_x_slopes_3 * c_elbow - p.l_u * m_forearm_slopes_3;
    let slopes_26 = mc_forearm_x_slopes_3 * s_right * s_elbow;
    let l_a_psi_ddot = p.l * a_psi_ddot;
    let l_u_a_psi_ddot = p.l_u * a_psi_ddot;
    let psi_dot_sq_s_right = psi_dot_sq * s_right;
    let psi_dot_sq_c_right = psi_dot_sq * c_right;
    // derivatives with respect to a
    let by_a_1 = psi_dot_sq_c_right * s_elbow + psi_dot_sq_s_right * c_elbow;
    let by_a_2 = m_forearm * (psi_dot_sq_s_right * s_elbow - psi_dot_sq_c_right * c_elbow);
    let mc_forearm_x_by_a_1 = mc_forearm_x * by_a_1;
    let by_a_3 = m_forearm * by_a_1 * c_elbow + by_a_2 * s_elbow;
    let by_a_4 = mc_right_arm_x * psi_dot_sq_s_right + mc_forearm_x_by_a_1 + p.l_u * by_a_3;
    let d_psi_ddot_by_a = inv_psi * (slopes_20 - slopes_17 + slopes_14 + slopes_18);
    let d_left_ddot_by_a = inv_left * mc_left_arm_x * psi_dot_sq * s_left;
    let d_right_ddot_by_a = inv_right * (l_elbow_right * mc_forearm_x_by_a_1 - by_a_4);
    let d_elbow_ddot_by_a = -inv_elbow * mc_forearm_x_by_a_1 - l_elbow_right * d_right_ddot_by_a;
    let l_sq = p.l * p.l;
    // derivatives with respect to l
    let by_l_1 = p.rho * l_per_two + 0.5 * l_rho;
    let by_l_2 = 0.5 * l_rho_l_per_two + l_per_two * by_l_1;
    let m_t_plus_by_l_1 = p.m_t + by_l_1;
    let by_l_3 = 3.0 * p.rho * l_sq / 12.0 + by_l_2 + 2.0 * l_m_t;
    let l_u_sq = p.l_u * p.l_u;
    // derivatives with respect to l_u
    let by_l_u_1 = p.rho * l_u_per_two + 0.5 * l_u_rho;
    let by_l_u_2 = 0.5 * l_u_rho_l_u_per_two + l_u_per_two * by_l_u_1;
    let m_e_plus_by_l_u_1 = p.m_e + by_l_u_1;
    let by_l_u_3 = 3.0 * p.rho * l_u_sq / 12.0 + by_l_u_2 + 2.0 * l_u_m_e;
    // derivatives with respect to l_f
    let by_l_f_1 = p.rho * l_f_per_two + 0.5 * m_forearm;
    let by_l_f_2 = 3.0 * p.l_f * p.l_f * p.rho / 12.0 + 0.5 * mc_forearm_x + l_f_per_two * by_l_f_1;
    let l_l_per_two = p.l * l_per_two;
    // derivatives with respect to rho
    let by_rho_1 = l_pow3 / 12.0 + l_per_two * l_l_per_two;
    let l_u_l_u_per_two = p.l_u * l_u_per_two;
    let by_rho_2 = l_u_pow3 / 12.0 + l_u_per_two * l_u_l_u_per_two;
    let l_f_l_f_per_two = p.l_f * l_f_per_two;
    let by_rho_3 = l_f_pow3 / 12.0 + l_f_per_two * l_f_l_f_per_two;
    // derivatives with respect to g
    let by_g_1 = m_forearm * (c_right * s_elbow + s_right * c_elbow);
    let mc_forearm_x_gravity_1 = mc_forearm_x * gravity_1;
    let by_g_2 = m_forearm * gravity_1 * c_elbow + by_g_1 * s_elbow;
    let by_g_3 = mc_right_arm_x * c_right + mc_forearm_x_gravity_1 + p.l_u * by_g_2;
    let d_right_ddot_by_g = inv_right * (l_elbow_right * mc_forearm_x_gravity_1 - by_g_3);
    let d_elbow_ddot_by_g = -inv_elbow * mc_forearm_x_gravity_1 - l_elbow_right * d_right_ddot_by_g;
    // slopes of the balance of forces, at the accelerations found
    let slopes_27 = left_ddot * by_l_3 - left_arm_1 * by_l_3;
    let slopes_28 = alpha_left_arm_z * by_l_3 + slopes_1 * by_l_3;
    let slopes_29 = c_left * (-a_psi_ddot * m_t_plus_by_l_1 - slopes_28);
    let slopes_30 = slopes_29 + p.a * (-rho_a_psi_ddot - m_t_plus_by_l_1 * slopes_11);
    let slopes_31 = right_arm_2 * by_l_u_3 + right_ddot * by_l_u_3;
    let slopes_32 = alpha_right_arm_z * by_l_u_3 + slopes_2 * by_l_u_3;
    let slopes_33 = slopes_25 - a_psi_ddot * m_e_plus_by_l_u_1 - slopes_32;
    let slopes_34 = a_right_arm_z * m_e_plus_by_l_u_1 + slopes_31 + slopes_24;
    let slopes_35 = p.a * (-rho_a_psi_ddot - slopes_3 * m_e_plus_by_l_u_1 - m_forearm_slopes_3);
    let slopes_36 = slopes_6_minus_forearm_2 * by_l_f_1 - p.rho * a_psi_ddot_plus_l_u_slopes_3;
    let slopes_37 = forearm_3 * by_l_f_2 + right_ddot_plus_elbow_ddot * by_l_f_2;
    let slopes_38 = slopes_6 * by_l_f_2 - forearm_2 * by_l_f_2;
    let slopes_39 = slopes_7 * by_l_f_1 + slopes_37;
    let slopes_40 = slopes_38 - a_psi_ddot_plus_l_u_slopes_3 * by_l_f_1;
    let slopes_41 = c_elbow * (p.rho * slopes_7 + slopes_9 * by_l_f_1);
    let slopes_42 = s_elbow * (p.rho * slopes_8 - forearm_1 * by_l_f_1);
    let slopes_43 = slopes_39 + p.l_u * (slopes_41 + slopes_42);
    let slopes_44 = c_right * (slopes_40 * c_elbow + p.l_u * slopes_36);
    let slopes_45 = slopes_40 * s_right * s_elbow - slopes_44;
    let slopes_46 = left_ddot * by_rho_1 - left_arm_1 * by_rho_1;
    let slopes_47 = alpha_left_arm_z * by_rho_1 + slopes_1 * by_rho_1;
    let slopes_48 = right_arm_2 * by_rho_2 + right_ddot * by_rho_2;
    let slopes_49 = alpha_right_arm_z * by_rho_2 + slopes_2 * by_rho_2;
    let slopes_50 = slopes_6_minus_forearm_2 * l_f_l_f_per_two - p.l_f * a_psi_ddot_plus_l_u_slopes_3;
    let slopes_51 = forearm_3 * by_rho_3 + right_ddot_plus_elbow_ddot * by_rho_3;
    let slopes_52 = slopes_6 * by_rho_3 - forearm_2 * by_rho_3;
    let slopes_53 = slopes_7 * l_f_l_f_per_two + slopes_51;
    let slopes_54 = slopes_52 - a_psi_ddot_plus_l_u_slopes_3 * l_f_l_f_per_two;
    let slopes_55 = c_elbow * (p.l_f * slopes_7 + slopes_9 * l_f_l_f_per_two);
    let slopes_56 = s_elbow * (p.l_f * slopes_8 - forearm_1 * l_f_l_f_per_two);
    let slopes_57 = slopes_53 + p.l_u * (slopes_55 + slopes_56);
    let slopes_58 = slopes_54 * c_elbow + p.l_u * slopes_50;
    let slopes_59 = slopes_58 - a_psi_ddot * l_u_l_u_per_two - slopes_49;
    let slopes_60 = a_right_arm_z * l_u_l_u_per_two + slopes_48 + slopes_57;
    let slopes_54_s_right_s_elbow = slopes_54 * s_right * s_elbow;
    let slopes_61 = p.a * (slopes_50 - l_u_a_psi_ddot - slopes_3 * l_u_l_u_per_two);
    let slopes_62 = slopes_54_s_right_s_elbow - slopes_59 * c_right - slopes_61;
    let slopes_63 = c_left * (-a_psi_ddot * l_l_per_two - slopes_47);
    let slopes_64 = slopes_63 + p.a * (-l_a_psi_ddot - l_l_per_two * slopes_11);
    let slopes_65 = alpha_right_arm_z * l_u_sq + slopes_2 * l_u_sq;
    let slopes_66 = p.l_u * a_right_arm_z + right_arm_2 * l_u_sq + right_ddot * l_u_sq;
    let slopes_67 = c_right * (-l_u_a_psi_ddot - slopes_65) - p.a * a_psi_ddot_plus_l_u_slopes_3;
    let slopes_68 = alpha_left_arm_z * l_sq + slopes_1 * l_sq;
    let slopes_69 = p.l * a_left_arm_z - left_arm_1 * l_sq + left_ddot * l_sq;
    let slopes_70 = c_left * (-l_a_psi_ddot - slopes_68);
    // derivatives with respect to l
    let d_left_ddot_by_l = -inv_left * (a_left_arm_z * m_t_plus_by_l_1 + slopes_27);
    // derivatives with respect to l_u
    let d_psi_ddot_by_l_u = inv_psi * (slopes_35 + slopes_26 + slopes_33 * c_right);
    let d_right_ddot_by_l_u = inv_right * (l_elbow_right * mc_forearm_x_slopes_21 - slopes_34);
    let d_elbow_ddot_by_l_u = -inv_elbow * mc_forearm_x_slopes_21 - l_elbow_right * d_right_ddot_by_l_u;
    // derivatives with respect to l_f
    let d_psi_ddot_by_l_f = inv_psi * (p.a * slopes_36 - slopes_45);
    let d_right_ddot_by_l_f = inv_right * (l_elbow_right * slopes_39 - slopes_43);
    let d_elbow_ddot_by_l_f = -inv_elbow * slopes_39 - l_elbow_right * d_right_ddot_by_l_f;
    // derivatives with respect to rho
    let d_left_ddot_by_rho = -inv_left * (a_left_arm_z * l_l_per_two + slopes_46);
    let d_right_ddot_by_rho = inv_right * (l_elbow_right * slopes_53 - slopes_60);
    let d_elbow_ddot_by_rho = -inv_elbow * slopes_53 - l_elbow_right * d_right_ddot_by_rho;
    // derivatives with respect to m_e
    let d_right_ddot_by_m_e = -inv_right * slopes_66;
    // derivatives with respect to m_t
    let d_psi_ddot_by_m_t = inv_psi * (slopes_70 + p.a * (-a_psi_ddot - p.l * slopes_11));
    // derivatives with respect to c_s
    let d_right_ddot_by_c_s = inv_right * (l_elbow_right * v.elbow - v.right);
    let d_elbow_ddot_by_c_s = -inv_elbow * v.elbow - l_elbow_right * d_right_ddot_by_c_s;
    positive(I_forearm_yy, 3)?;
    positive(pivot_right, 2)?;
    positive(I_left_arm_yy, 1)?;
    positive(M_psi_psi, 0)?;
    Ok([
        [0.0; 11], // psi'
        [0.0; 11], // left'
        [0.0; 11], // right'
        [0.0; 11], // elbow'
        // psi''
        Parameters {
            I_c: -inv_psi * psi_ddot,
            a: d_psi_ddot_by_a,
            l: inv_psi * slopes_30,
            l_u: d_psi_ddot_by_l_u,
            l_f: d_psi_ddot_by_l_f,
            rho: inv_psi * (slopes_64 - slopes_62),
            m_e: inv_psi * slopes_67,
            m_t: d_psi_ddot_by_m_t,
            c_psi: -inv_psi * v.psi,
            ..Parameters::ZERO
        }
        .to_array(),
        // left''
        Parameters {
            a: d_left_ddot_by_a,
            l: d_left_ddot_by_l,
            rho: d_left_ddot_by_rho,
            m_t: -inv_left * slopes_69,
            c_s: -inv_left * v.left,
            g: mc_left_arm_x_c_left * inv_left,
            ..Parameters::ZERO
        }
        .to_array(),
        // right''
        Parameters {
            a: d_right_ddot_by_a,
            l_u: d_right_ddot_by_l_u,
            l_f: d_right_ddot_by_l_f,
            rho: d_right_ddot_by_rho,
            m_e: d_right_ddot_by_m_e,
            c_s: d_right_ddot_by_c_s,
            g: d_right_ddot_by_g,
            ..Parameters::ZERO
        }
        .to_array(),
        // elbow''
        Parameters {
            a: d_elbow_ddot_by_a,
            l_u: d_elbow_ddot_by_l_u,
            l_f: d_elbow_ddot_by_l_f,
            rho: d_elbow_ddot_by_rho,
            m_e: -l_elbow_right * d_right_ddot_by_m_e,
            c_s: d_elbow_ddot_by_c_s,
            g: d_elbow_ddot_by_g,
            ..Parameters::ZERO
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 4 x 8.
    pub by_x: [[f64; 8]; 4],
    /// dy/dp, 4 x 11.
    pub by_p: [[f64; 11]; 4],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [
            [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], // psi
            [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], // left
            [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], // right
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0], // elbow
        ],
        by_p: [
            [0.0; 11], // psi
            [0.0; 11], // left
            [0.0; 11], // right
            [0.0; 11], // elbow
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 8] = ["psi", "left", "right", "elbow", "psi.dot", "left.dot", "right.dot", "elbow.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 4] = ["tau_psi", "tau_l", "tau_r", "tau_e"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 11] = ["I_c", "a", "l", "l_u", "l_f", "rho", "m_e", "m_t", "c_psi", "c_s", "g"];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 11] = ["kg*m^2", "m", "m", "m", "m", "kg/m", "kg", "kg", "N*m*s", "N*m*s", "m/s^2"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 4] = ["psi", "left", "right", "elbow"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 4] = ["rad", "rad", "rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tree;

impl Names for Tree {
    fn rig(&self) -> &str {
        "Tree"
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

impl Model for Tree {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 4, lags: 0, inputs: 4, exogenous: 0, parameters: 11, outputs: 4 }
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
        runtime::write(dx, 4, &a.to_array());
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
        runtime::write(d, 3, &[pivots[3]]);
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
            0 => InputPath { limits: (-3.0, 3.0), delay: 0.0 },
            1 => InputPath { limits: (-3.0, 3.0), delay: 0.0 },
            2 => InputPath { limits: (-3.0, 3.0), delay: 0.0 },
            3 => InputPath { limits: (-1.0, 1.0), delay: 0.0 },
            _ => InputPath { limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0 },
        }
    }

    fn output_path(&self, i: usize, _p: &[f64]) -> OutputPath {
        match i {
            0 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            1 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            2 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            3 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            _ => OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false },
        }
    }
}
