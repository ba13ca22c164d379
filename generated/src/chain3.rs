//! Spatial chain of three joints.
//! Generated from `chain3.rig` (model 644e8a88); edit the rig, not this file.
//!
//! Three slender links of 0.4, 0.3 and 0.2 m turn about z, y and x in turn, each with its own motor: the
//! shape of the chains on which derivation and speed are measured (joint axes alternate z, y, x, links along
//! x). Numbers: square aluminium bars of 30 mm, 2700 kg/m^3.
//!
//! 215 operations forward, 683 with A and B.
//! Derived twice, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::{sin, sin_cos};
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular, positive};

/// Parameters p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// m_1 [kg]
    pub m_1: f64,
    /// m_2 [kg]
    pub m_2: f64,
    /// m_3 [kg]
    pub m_3: f64,
    /// l_1 [m]
    pub l_1: f64,
    /// l_2 [m]
    pub l_2: f64,
    /// l_3 [m]
    pub l_3: f64,
    /// width of the bars [m]
    pub b: f64,
    /// c_1 [N*m*s]
    pub c_1: f64,
    /// c_2 [N*m*s]
    pub c_2: f64,
    /// c_3 [N*m*s]
    pub c_3: f64,
    /// g [m/s^2]
    pub g: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m_1: 0.972,
        m_2: 0.729,
        m_3: 0.486,
        l_1: 0.4,
        l_2: 0.3,
        l_3: 0.2,
        b: 0.03,
        c_1: 0.05,
        c_2: 0.04,
        c_3: 0.01,
        g: 9.81,
    };

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 11]) -> Self {
        let [m_1, m_2, m_3, l_1, l_2, l_3, b, c_1, c_2, c_3, g] = values;
        Self { m_1, m_2, m_3, l_1, l_2, l_3, b, c_1, c_2, c_3, g }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 11] {
        [self.m_1, self.m_2, self.m_3, self.l_1, self.l_2, self.l_3, self.b, self.c_1, self.c_2, self.c_3, self.g]
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
    /// q1 [rad]
    pub q1: f64,
    /// q2 [rad]
    pub q2: f64,
    /// q3 [rad]
    pub q3: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [q1, q2, q3] = values;
        Self { q1, q2, q3 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.q1, self.q2, self.q3]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// q1.dot [rad/s]
    pub q1: f64,
    /// q2.dot [rad/s]
    pub q2: f64,
    /// q3.dot [rad/s]
    pub q3: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [q1, q2, q3] = values;
        Self { q1, q2, q3 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.q1, self.q2, self.q3]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// q1.ddot [rad/s^2]
    pub q1: f64,
    /// q2.ddot [rad/s^2]
    pub q2: f64,
    /// q3.ddot [rad/s^2]
    pub q3: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [q1, q2, q3] = values;
        Self { q1, q2, q3 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.q1, self.q2, self.q3]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// tau_1 [N*m]
    pub tau_1: f64,
    /// tau_2 [N*m]
    pub tau_2: f64,
    /// tau_3 [N*m]
    pub tau_3: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [tau_1, tau_2, tau_3] = values;
        Self { tau_1, tau_2, tau_3 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.tau_1, self.tau_2, self.tau_3]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// q1 [rad]
    pub q1: f64,
    /// q2 [rad]
    pub q2: f64,
    /// q3 [rad]
    pub q3: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [q1, q2, q3] = values;
        Self { q1, q2, q3 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.q1, self.q2, self.q3]
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

/// Mass matrix M(q), 3 x 3, symmetric; rows (q1, q2, q3).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 3]; 3] {
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let l_1_per_two = p.l_1 / 2.0;
    let b_sq = p.b * p.b;
    // body bar_1 on link_1
    let I_link_1_yy = p.m_1 * (b_sq + p.l_1 * p.l_1) / 12.0 + p.m_1 * l_1_per_two * l_1_per_two;
    let l_2_per_two = p.l_2 / 2.0;
    // body bar_2 on link_2
    let mc_link_2_x = p.m_2 * l_2_per_two;
    let I_link_2_yy = p.m_2 * (b_sq + p.l_2 * p.l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    let l_3_per_two = p.l_3 / 2.0;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let I_link_3_yy = p.m_3 * b_sq / 6.0;
    let mc_link_3_y = p.m_3 * l_3_per_two;
    let I_link_3_xx = p.m_3 * (b_sq + p.l_3 * p.l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    let mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    // frame link_3 on link_2
    let M_q2_q3 = -p.l_2 * mc_link_3_y * c_q3;
    let l_2_mc_link_3_y_s_q3 = p.l_2 * mc_link_3_y_s_q3;
    let link_3_1 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    let M_q1_q3 = -link_3_1 - p.l_1 * mc_link_3_y_s_q3;
    let link_3_2 = c_q3 * (I_link_3_yy - I_link_3_xx);
    let link_3_2_c_q3 = link_3_2 * c_q3;
    let m_3_l_2 = p.m_3 * p.l_2;
    let l_2_m_3_l_2 = p.l_2 * m_3_l_2;
    // frame link_2 on link_1
    let link_2_1 = p.m_2 * b_sq / 6.0 + I_link_3_xx;
    let M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_2_c_q3 + l_2_m_3_l_2;
    let link_2_2 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    let M_q1_q2 = link_3_2 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    let link_2_3 = I_link_2_yy + I_link_3_yy - link_3_2_c_q3 + l_2_m_3_l_2 - link_2_1;
    let link_2_4 = link_2_3 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    let link_2_1_1 = p.l_1 * (link_2_2 + link_2_2 + p.l_1 * (p.m_2 + p.m_3));
    // frame link_1 on ground
    let M_q1_q1 = I_link_1_yy + link_2_1 + link_2_4 * c_q2 + link_2_1_1;
    [[M_q1_q1, M_q1_q2, M_q1_q3], [M_q1_q2, M_q2_q2, M_q2_q3], [M_q1_q3, M_q2_q3, I_link_3_xx]]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (q1, q2, q3).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 3] {
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let b_sq = p.b * p.b;
    let l_2_per_two = p.l_2 / 2.0;
    // body bar_2 on link_2
    let I_link_2_xx = p.m_2 * b_sq / 6.0;
    let mc_link_2_x = p.m_2 * l_2_per_two;
    let I_link_2_yy = p.m_2 * (b_sq + p.l_2 * p.l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    let l_3_per_two = p.l_3 / 2.0;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let I_link_3_yy = p.m_3 * b_sq / 6.0;
    let mc_link_3_y = p.m_3 * l_3_per_two;
    let I_link_3_xx = p.m_3 * (b_sq + p.l_3 * p.l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    // frame link_2 on link_1
    let omega_link_2_z = c_q2 * v.q1;
    let omega_link_2_x = -s_q2 * v.q1;
    let alpha_link_2_x = -omega_link_2_z * v.q2;
    let alpha_link_2_z = omega_link_2_x * v.q2;
    let two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    let link_2_1 = omega_link_2_z * omega_link_2_x;
    let link_2_2 = I_link_2_yy * alpha_link_2_z + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    // frame link_3 on link_2
    let omega_link_3_y = c_q3 * v.q2 + omega_link_2_z * s_q3;
    let omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v.q2;
    let omega_link_3_x = v.q3 + omega_link_2_x;
    let alpha_link_3_y = omega_link_3_z * v.q3 + alpha_link_2_z * s_q3;
    let alpha_link_3_z = alpha_link_2_z * c_q3 - omega_link_3_y * v.q3;
    let link_3_1 = omega_link_3_y * omega_link_3_z;
    let n_moving_link_3_y = I_link_3_yy * alpha_link_3_y;
    let link_3_2 = omega_link_3_y * omega_link_3_x * (I_link_3_yy - I_link_3_xx) + I_link_3_xx * alpha_link_3_z;
    // frame link_2 on link_1
    let a_link_2_1_x = -p.l_1 * v.q1 * v.q1;
    // frame link_3 on link_2
    let a_link_3_1_y = p.l_2 * two_alpha_link_2_z;
    // frame link_2 on link_1
    let a_link_2_z = p.g * c_q2 + a_link_2_1_x * s_q2;
    let a_link_2_x = a_link_2_1_x * c_q2 - p.g * s_q2;
    let link_2_3 = mc_link_2_x * a_link_2_z - link_2_1 * (I_link_2_xx - I_link_2_yy);
    // frame link_3 on link_2
    let a_link_3_1_x = a_link_2_x - p.l_2 * (v.q2 * v.q2 + omega_link_2_z * omega_link_2_z);
    let a_link_3_1_z = a_link_2_z + p.l_2 * link_2_1;
    let a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    let a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    let f_link_3_y = p.m_3 * a_link_3_y - mc_link_3_y * (omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x);
    let f_link_3_z = mc_link_3_y * (link_3_1 + alpha_link_2_x) + p.m_3 * a_link_3_z;
    let n_link_3_x = link_3_1 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    let n_link_3_z = link_3_2 - mc_link_3_y * a_link_3_1_x;
    let f_link_3_1_y = f_link_3_y * c_q3 - f_link_3_z * s_q3;
    let f_link_3_1_z = f_link_3_y * s_q3 + f_link_3_z * c_q3;
    let n_link_3_1_y = n_moving_link_3_y * c_q3 - n_link_3_z * s_q3;
    let n_link_3_1_z = n_moving_link_3_y * s_q3 + n_link_3_z * c_q3;
    // frame link_2 on link_1
    let n_link_2_y = n_link_3_1_y - p.l_2 * f_link_3_1_z - link_2_3;
    let n_link_2_z = n_link_3_1_z + p.l_2 * f_link_3_1_y + link_2_2;
    let n_link_2_1_z = n_link_2_z * c_q2 - s_q2 * (n_link_3_x + I_link_2_xx * alpha_link_2_x);
    let n_link_1_z = n_link_2_1_z + p.l_1 * (mc_link_2_x * two_alpha_link_2_z + f_link_3_1_y);
    [n_link_1_z, n_link_2_y, n_link_3_x]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (q1, q2, q3).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 3] {
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let b_sq = p.b * p.b;
    let l_2_per_two = p.l_2 / 2.0;
    // body bar_2 on link_2
    let I_link_2_xx = p.m_2 * b_sq / 6.0;
    let mc_link_2_x = p.m_2 * l_2_per_two;
    let I_link_2_yy = p.m_2 * (b_sq + p.l_2 * p.l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    let l_3_per_two = p.l_3 / 2.0;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let I_link_3_yy = p.m_3 * b_sq / 6.0;
    let mc_link_3_y = p.m_3 * l_3_per_two;
    let I_link_3_xx = p.m_3 * (b_sq + p.l_3 * p.l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    // frame link_2 on link_1
    let omega_link_2_z = c_q2 * v.q1;
    let omega_link_2_x = -s_q2 * v.q1;
    let alpha_link_2_x = -omega_link_2_z * v.q2;
    let alpha_link_2_z = omega_link_2_x * v.q2;
    let two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    let link_2_1 = omega_link_2_z * omega_link_2_x;
    let link_2_2 = I_link_2_yy * alpha_link_2_z + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    // frame link_3 on link_2
    let omega_link_3_y = c_q3 * v.q2 + omega_link_2_z * s_q3;
    let omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v.q2;
    let omega_link_3_x = v.q3 + omega_link_2_x;
    let alpha_link_3_y = omega_link_3_z * v.q3 + alpha_link_2_z * s_q3;
    let alpha_link_3_z = alpha_link_2_z * c_q3 - omega_link_3_y * v.q3;
    let link_3_1 = omega_link_3_y * omega_link_3_z;
    let n_moving_link_3_y = I_link_3_yy * alpha_link_3_y;
    let link_3_2 = omega_link_3_y * omega_link_3_x * (I_link_3_yy - I_link_3_xx) + I_link_3_xx * alpha_link_3_z;
    // frame link_2 on link_1
    let a_link_2_1_x = -p.l_1 * v.q1 * v.q1;
    let a_link_2_z = a_link_2_1_x * s_q2;
    let link_2_3 = link_2_1 * (I_link_2_xx - I_link_2_yy) - mc_link_2_x * a_link_2_z;
    // frame link_3 on link_2
    let a_link_3_1_y = p.l_2 * two_alpha_link_2_z;
    let a_link_3_1_x = a_link_2_1_x * c_q2 - p.l_2 * (v.q2 * v.q2 + omega_link_2_z * omega_link_2_z);
    let a_link_3_1_z = a_link_2_z + p.l_2 * link_2_1;
    let a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    let a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    let f_moving_link_3_y = p.m_3 * a_link_3_y - mc_link_3_y * (omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x);
    let f_moving_link_3_z = mc_link_3_y * (link_3_1 + alpha_link_2_x) + p.m_3 * a_link_3_z;
    let n_moving_link_3_x = link_3_1 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    let n_moving_link_3_z = link_3_2 - mc_link_3_y * a_link_3_1_x;
    let f_moving_link_3_1_y = f_moving_link_3_y * c_q3 - f_moving_link_3_z * s_q3;
    let f_moving_link_3_1_z = f_moving_link_3_y * s_q3 + f_moving_link_3_z * c_q3;
    let n_moving_link_3_1_y = n_moving_link_3_y * c_q3 - n_moving_link_3_z * s_q3;
    let n_moving_link_3_1_z = n_moving_link_3_y * s_q3 + n_moving_link_3_z * c_q3;
    // frame link_2 on link_1
    let n_moving_link_2_y = link_2_3 + n_moving_link_3_1_y - p.l_2 * f_moving_link_3_1_z;
    let n_moving_link_2_z = n_moving_link_3_1_z + p.l_2 * f_moving_link_3_1_y + link_2_2;
    let link_2_4 = s_q2 * (n_moving_link_3_x + I_link_2_xx * alpha_link_2_x);
    let link_2_1_1 = p.l_1 * (mc_link_2_x * two_alpha_link_2_z + f_moving_link_3_1_y);
    let n_moving_link_1_z = n_moving_link_2_z * c_q2 - link_2_4 + link_2_1_1;
    [n_moving_link_1_z, n_moving_link_2_y, n_moving_link_3_x]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (q1, q2, q3).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 3] {
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let l_3_per_two = p.l_3 / 2.0;
    let gravity_1 = p.g * (l_3_per_two * s_q2 * s_q3 + p.l_2 * c_q2);
    let g_q2 = -p.m_2 * p.l_2 * p.g * c_q2 / 2.0 - p.m_3 * gravity_1;
    let g_q3 = p.m_3 * p.g * l_3_per_two * c_q2 * c_q3;
    [0.0, g_q2, g_q3]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (q1, q2, q3).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 3] {
    [p.c_1 * v.q1, p.c_2 * v.q2, p.c_3 * v.q3]
}

/// Generalized force Q [N m] of the inputs; rows (q1, q2, q3).
#[must_use]
pub fn generalized_force(_q: &Coordinates, u: &Inputs, _p: &Parameters) -> [f64; 3] {
    [u.tau_1, u.tau_2, u.tau_3]
}

/// Input map dQ/du, 3 x 3; rows (q1, q2, q3), columns (tau_1, tau_2, tau_3).
#[must_use]
pub fn input_map(_q: &Coordinates, _p: &Parameters) -> [[f64; 3]; 3] {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let b_sq = p.b * p.b;
    let l_1_per_two_q1_dot = p.l_1 * v.q1 / 2.0;
    // body bar_1 on link_1
    let bar_1_1 = p.m_1 * v.q1 * v.q1 * (b_sq + p.l_1 * p.l_1) / 12.0;
    let bar_1_2 = 0.5 * (p.m_1 * l_1_per_two_q1_dot * l_1_per_two_q1_dot + bar_1_1);
    let l_2_per_two = p.l_2 / 2.0;
    let m_2_b_sq_plus_l_2_sq_per_12 = p.m_2 * (b_sq + p.l_2 * p.l_2) / 12.0;
    let l_2_per_two_q2_dot = l_2_per_two * v.q2;
    let l_3_per_two = p.l_3 / 2.0;
    let m_3_b_sq_plus_l_3_sq_per_12 = p.m_3 * (b_sq + p.l_3 * p.l_3) / 12.0;
    // frame link_2 on link_1
    let omega_link_2_z = c_q2 * v.q1;
    let omega_link_2_x = -s_q2 * v.q1;
    // frame link_3 on link_2
    let omega_link_3_y = c_q3 * v.q2 + omega_link_2_z * s_q3;
    let omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v.q2;
    let omega_link_3_x = v.q3 + omega_link_2_x;
    let l_1_q1_dot = p.l_1 * v.q1;
    let l_2_q2_dot = p.l_2 * v.q2;
    let link_3_1_1 = l_1_q1_dot + p.l_2 * omega_link_2_z;
    let link_3_1 = link_3_1_1 * c_q3 - l_2_q2_dot * s_q3;
    let link_3_2 = link_3_1_1 * s_q3 + l_2_q2_dot * c_q3;
    // body bar_2 on link_2
    let bar_2_1 = l_1_q1_dot + l_2_per_two * omega_link_2_z;
    let bar_2_2 = p.m_2 * (bar_2_1 * bar_2_1 + l_2_per_two_q2_dot * l_2_per_two_q2_dot);
    let bar_2_3 = p.m_2 * omega_link_2_x * b_sq * omega_link_2_x / 6.0 + m_2_b_sq_plus_l_2_sq_per_12 * v.q2 * v.q2;
    let bar_2_4 = bar_2_2 + omega_link_2_z * m_2_b_sq_plus_l_2_sq_per_12 * omega_link_2_z + bar_2_3;
    let l_3_per_two_omega_link_3_z = l_3_per_two * omega_link_3_z;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let bar_3_1 = l_3_per_two * omega_link_3_x - link_3_2;
    let bar_3_2 = l_3_per_two_omega_link_3_z * l_3_per_two_omega_link_3_z + link_3_1 * link_3_1;
    let m_3_bar_3_1_sq_plus_bar_3_2 = p.m_3 * (bar_3_1 * bar_3_1 + bar_3_2);
    let bar_3_3 = p.m_3 * omega_link_3_y * b_sq * omega_link_3_y / 6.0;
    let bar_3_4 = omega_link_3_x * m_3_b_sq_plus_l_3_sq_per_12 * omega_link_3_x + bar_3_3;
    let bar_3_5 = m_3_bar_3_1_sq_plus_bar_3_2 + omega_link_3_z * m_3_b_sq_plus_l_3_sq_per_12 * omega_link_3_z + bar_3_4;
    bar_1_2 + 0.5 * bar_2_4 + 0.5 * bar_3_5
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let (s_q2, c_q2) = sin_cos(q.q2);
    let s_q3 = sin(q.q3);
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let bar_3_1 = p.m_3 * p.g * (p.l_3 * c_q2 * s_q3 / 2.0 - p.l_2 * s_q2);
    bar_3_1 - p.m_2 * p.l_2 * p.g * s_q2 / 2.0
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 3] {
    let State { q, v } = x;
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let l_1_per_two = p.l_1 / 2.0;
    let b_sq = p.b * p.b;
    // body bar_1 on link_1
    let I_link_1_yy = p.m_1 * (b_sq + p.l_1 * p.l_1) / 12.0 + p.m_1 * l_1_per_two * l_1_per_two;
    let l_2_per_two = p.l_2 / 2.0;
    // body bar_2 on link_2
    let I_link_2_xx = p.m_2 * b_sq / 6.0;
    let mc_link_2_x = p.m_2 * l_2_per_two;
    let I_link_2_yy = p.m_2 * (b_sq + p.l_2 * p.l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    let l_3_per_two = p.l_3 / 2.0;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let I_link_3_yy = p.m_3 * b_sq / 6.0;
    let mc_link_3_y = p.m_3 * l_3_per_two;
    let I_link_3_xx = p.m_3 * (b_sq + p.l_3 * p.l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    // frame link_2 on link_1
    let omega_link_2_z = c_q2 * v.q1;
    let omega_link_2_x = -s_q2 * v.q1;
    let alpha_link_2_z = omega_link_2_x * v.q2;
    let link_2_1 = omega_link_2_z * omega_link_2_x;
    let alpha_link_2_x = -omega_link_2_z * v.q2 - s_q2 * a.q1;
    let alpha_link_2_z_2 = c_q2 * a.q1 + alpha_link_2_z;
    let link_2_2 = alpha_link_2_z_2 + alpha_link_2_z;
    // frame link_3 on link_2
    let omega_link_3_y = c_q3 * v.q2 + omega_link_2_z * s_q3;
    let omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v.q2;
    let omega_link_3_x = v.q3 + omega_link_2_x;
    let link_3_1 = omega_link_3_y * omega_link_3_z;
    let alpha_link_3_y = omega_link_3_z * v.q3 + c_q3 * a.q2 + alpha_link_2_z_2 * s_q3;
    let alpha_link_3_z = alpha_link_2_z_2 * c_q3 - s_q3 * a.q2 - omega_link_3_y * v.q3;
    let alpha_link_3_x = a.q3 + alpha_link_2_x;
    let n_net_link_3_y = I_link_3_yy * alpha_link_3_y;
    let link_3_2 = omega_link_3_y * omega_link_3_x * (I_link_3_yy - I_link_3_xx) + I_link_3_xx * alpha_link_3_z;
    // frame link_2 on link_1
    let a_link_2_1_x = -p.l_1 * v.q1 * v.q1;
    let a_link_2_z = p.g * c_q2 + a_link_2_1_x * s_q2;
    let a_link_2_x = a_link_2_1_x * c_q2 - p.g * s_q2;
    let link_2_3 = I_link_2_yy * a.q2 + link_2_1 * (I_link_2_xx - I_link_2_yy) - mc_link_2_x * a_link_2_z;
    // frame link_3 on link_2
    let a_link_3_1_x = a_link_2_x - p.l_2 * (v.q2 * v.q2 + omega_link_2_z * omega_link_2_z);
    let a_link_3_1_z = a_link_2_z - p.l_2 * (a.q2 - link_2_1);
    // gravity
    let a_link_2_1_y = p.l_1 * a.q1;
    // frame link_2 on link_1
    let link_2_4 = mc_link_2_x * a_link_2_1_y + I_link_2_yy * alpha_link_2_z_2 + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    // frame link_3 on link_2
    let a_link_3_1_y = a_link_2_1_y + p.l_2 * link_2_2;
    let a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    let a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    let f_net_link_3_y = p.m_3 * a_link_3_y - mc_link_3_y * (omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x);
    let f_net_link_3_z = p.m_3 * a_link_3_z + mc_link_3_y * (link_3_1 + alpha_link_3_x);
    let n_net_link_3_x = mc_link_3_y * a_link_3_z + link_3_1 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_3_x;
    let n_net_link_3_z = link_3_2 - mc_link_3_y * a_link_3_1_x;
    let f_net_link_3_1_y = f_net_link_3_y * c_q3 - f_net_link_3_z * s_q3;
    let f_net_link_3_1_z = f_net_link_3_y * s_q3 + f_net_link_3_z * c_q3;
    let n_net_link_3_1_y = n_net_link_3_y * c_q3 - n_net_link_3_z * s_q3;
    let n_net_link_3_1_z = n_net_link_3_y * s_q3 + n_net_link_3_z * c_q3;
    // frame link_2 on link_1
    let f_net_link_2_y = p.m_2 * a_link_2_1_y + mc_link_2_x * link_2_2 + f_net_link_3_1_y;
    let n_net_link_2_y = link_2_3 + n_net_link_3_1_y - p.l_2 * f_net_link_3_1_z;
    let n_net_link_2_z = link_2_4 + n_net_link_3_1_z + p.l_2 * f_net_link_3_1_y;
    let link_2_5 = s_q2 * (n_net_link_3_x + I_link_2_xx * alpha_link_2_x);
    // frame link_1 on ground
    let n_net_link_1_z = I_link_1_yy * a.q1 + n_net_link_2_z * c_q2 - link_2_5 + p.l_1 * f_net_link_2_y;
    [p.c_1 * v.q1 + n_net_link_1_z - u.tau_1, p.c_2 * v.q2 + n_net_link_2_y - u.tau_2, p.c_3 * v.q3 + n_net_link_3_x - u.tau_3]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.q1, q.q2, q.q3])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 3] {
    let State { q, .. } = x;
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let l_1_per_two = p.l_1 / 2.0;
    let b_sq = p.b * p.b;
    // body bar_1 on link_1
    let I_link_1_yy = p.m_1 * (b_sq + p.l_1 * p.l_1) / 12.0 + p.m_1 * l_1_per_two * l_1_per_two;
    let l_2_per_two = p.l_2 / 2.0;
    // body bar_2 on link_2
    let mc_link_2_x = p.m_2 * l_2_per_two;
    let I_link_2_yy = p.m_2 * (b_sq + p.l_2 * p.l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    let l_3_per_two = p.l_3 / 2.0;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let I_link_3_yy = p.m_3 * b_sq / 6.0;
    let mc_link_3_y = p.m_3 * l_3_per_two;
    let I_link_3_xx = p.m_3 * (b_sq + p.l_3 * p.l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    let mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    // frame link_3 on link_2
    let M_q2_q3 = -p.l_2 * mc_link_3_y * c_q3;
    let l_2_mc_link_3_y_s_q3 = p.l_2 * mc_link_3_y_s_q3;
    let link_3_1 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    let M_q1_q3 = -link_3_1 - p.l_1 * mc_link_3_y_s_q3;
    let link_3_2 = c_q3 * (I_link_3_yy - I_link_3_xx);
    let link_3_2_c_q3 = link_3_2 * c_q3;
    let m_3_l_2 = p.m_3 * p.l_2;
    let l_2_m_3_l_2 = p.l_2 * m_3_l_2;
    // frame link_2 on link_1
    let link_2_1 = p.m_2 * b_sq / 6.0 + I_link_3_xx;
    let M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_2_c_q3 + l_2_m_3_l_2;
    let link_2_2 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    let M_q1_q2 = link_3_2 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    let link_2_3 = I_link_2_yy + I_link_3_yy - link_3_2_c_q3 + l_2_m_3_l_2 - link_2_1;
    let link_2_4 = link_2_3 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    let link_2_1_1 = p.l_1 * (link_2_2 + link_2_2 + p.l_1 * (p.m_2 + p.m_3));
    // frame link_1 on ground
    let M_q1_q1 = I_link_1_yy + link_2_1 + link_2_4 * c_q2 + link_2_1_1;
    // M = L^T D L and back-substitution
    let inv_q3 = 1.0 / I_link_3_xx;
    let l_q3_q2 = M_q2_q3 * inv_q3;
    let pivot_q2 = M_q2_q2 - M_q2_q3 * l_q3_q2;
    let solve_1 = M_q1_q2 - M_q1_q3 * l_q3_q2;
    let pivot_q1 = M_q1_q1 - solve_1 * solve_1 / pivot_q2 - M_q1_q3 * M_q1_q3 * inv_q3;
    [pivot_q1, pivot_q2, I_link_3_xx]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 215 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let l_1_per_two = p.l_1 / 2.0;
    let b_sq = p.b * p.b;
    // body bar_1 on link_1
    let I_link_1_yy = p.m_1 * (b_sq + p.l_1 * p.l_1) / 12.0 + p.m_1 * l_1_per_two * l_1_per_two;
    let l_2_per_two = p.l_2 / 2.0;
    // body bar_2 on link_2
    let I_link_2_xx = p.m_2 * b_sq / 6.0;
    let mc_link_2_x = p.m_2 * l_2_per_two;
    let I_link_2_yy = p.m_2 * (b_sq + p.l_2 * p.l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    let l_3_per_two = p.l_3 / 2.0;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let I_link_3_yy = p.m_3 * b_sq / 6.0;
    let mc_link_3_y = p.m_3 * l_3_per_two;
    let I_link_3_xx = p.m_3 * (b_sq + p.l_3 * p.l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    // frame link_2 on link_1
    let omega_link_2_z = c_q2 * v.q1;
    let omega_link_2_x = -s_q2 * v.q1;
    let alpha_link_2_x = -omega_link_2_z * v.q2;
    let alpha_link_2_z = omega_link_2_x * v.q2;
    let two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    let link_2_1 = omega_link_2_z * omega_link_2_x;
    let link_2_2 = I_link_2_yy * alpha_link_2_z + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    let I_link_2_xx_plus_I_link_3_xx = I_link_2_xx + I_link_3_xx;
    // frame link_3 on link_2
    let omega_link_3_y = c_q3 * v.q2 + omega_link_2_z * s_q3;
    let omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v.q2;
    let omega_link_3_x = v.q3 + omega_link_2_x;
    let alpha_link_3_y = omega_link_3_z * v.q3 + alpha_link_2_z * s_q3;
    let alpha_link_3_z = alpha_link_2_z * c_q3 - omega_link_3_y * v.q3;
    let link_3_1 = omega_link_3_y * omega_link_3_z;
    let n_moving_link_3_y = I_link_3_yy * alpha_link_3_y;
    let link_3_2 = I_link_3_yy - I_link_3_xx;
    let link_3_3 = omega_link_3_y * omega_link_3_x * link_3_2 + I_link_3_xx * alpha_link_3_z;
    let mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    let M_q2_q3 = -p.l_2 * mc_link_3_y * c_q3;
    let l_2_mc_link_3_y_s_q3 = p.l_2 * mc_link_3_y_s_q3;
    let link_3_4 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    let M_q1_q3 = -link_3_4 - p.l_1 * mc_link_3_y_s_q3;
    let link_3_2_c_q3 = link_3_2 * c_q3;
    let link_3_2_c_q3_c_q3 = link_3_2_c_q3 * c_q3;
    // frame link_2 on link_1
    let a_link_2_1_x = -p.l_1 * v.q1 * v.q1;
    // frame link_3 on link_2
    let a_link_3_1_y = p.l_2 * two_alpha_link_2_z;
    let m_3_l_2 = p.m_3 * p.l_2;
    let l_2_m_3_l_2 = p.l_2 * m_3_l_2;
    // frame link_2 on link_1
    let a_link_2_z = p.g * c_q2 + a_link_2_1_x * s_q2;
    let a_link_2_x = a_link_2_1_x * c_q2 - p.g * s_q2;
    let link_2_3 = mc_link_2_x * a_link_2_z - link_2_1 * (I_link_2_xx - I_link_2_yy);
    let M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_2_c_q3_c_q3 + l_2_m_3_l_2;
    let link_2_4 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    let M_q1_q2 = link_3_2_c_q3 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    let link_2_5 = I_link_2_yy + I_link_3_yy - link_3_2_c_q3_c_q3 + l_2_m_3_l_2 - I_link_2_xx_plus_I_link_3_xx;
    let link_2_6 = link_2_5 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    // frame link_3 on link_2
    let a_link_3_1_x = a_link_2_x - p.l_2 * (v.q2 * v.q2 + omega_link_2_z * omega_link_2_z);
    let a_link_3_1_z = a_link_2_z + p.l_2 * link_2_1;
    let a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    let a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    let f_link_3_y = p.m_3 * a_link_3_y - mc_link_3_y * (omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x);
    let f_link_3_z = mc_link_3_y * (link_3_1 + alpha_link_2_x) + p.m_3 * a_link_3_z;
    let n_link_3_x = link_3_1 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    let n_link_3_z = link_3_3 - mc_link_3_y * a_link_3_1_x;
    let f_link_3_1_y = f_link_3_y * c_q3 - f_link_3_z * s_q3;
    let f_link_3_1_z = f_link_3_y * s_q3 + f_link_3_z * c_q3;
    let n_link_3_1_y = n_moving_link_3_y * c_q3 - n_link_3_z * s_q3;
    let n_link_3_1_z = n_moving_link_3_y * s_q3 + n_link_3_z * c_q3;
    // frame link_2 on link_1
    let n_link_2_y = n_link_3_1_y - p.l_2 * f_link_3_1_z - link_2_3;
    let n_link_2_z = n_link_3_1_z + p.l_2 * f_link_3_1_y + link_2_2;
    let n_link_2_1_z = n_link_2_z * c_q2 - s_q2 * (n_link_3_x + I_link_2_xx * alpha_link_2_x);
    let n_link_1_z = n_link_2_1_z + p.l_1 * (mc_link_2_x * two_alpha_link_2_z + f_link_3_1_y);
    let link_2_1_1 = p.l_1 * (link_2_4 + link_2_4 + p.l_1 * (p.m_2 + p.m_3));
    // frame link_1 on ground
    let M_q1_q1 = I_link_1_yy + I_link_2_xx_plus_I_link_3_xx + link_2_6 * c_q2 + link_2_1_1;
    // balance of forces
    let tau_q1 = u.tau_1 - p.c_1 * v.q1 - n_link_1_z;
    let tau_q2 = u.tau_2 - p.c_2 * v.q2 - n_link_2_y;
    let tau_q3 = u.tau_3 - p.c_3 * v.q3 - n_link_3_x;
    // M = L^T D L and back-substitution
    let inv_q3 = 1.0 / I_link_3_xx;
    let l_q3_q1 = M_q1_q3 * inv_q3;
    let l_q3_q2 = M_q2_q3 * inv_q3;
    let pivot_q2 = M_q2_q2 - M_q2_q3 * l_q3_q2;
    let inv_q2 = 1.0 / pivot_q2;
    let solve_1 = M_q1_q2 - M_q1_q3 * l_q3_q2;
    let l_q2_q1 = inv_q2 * solve_1;
    let pivot_q1 = M_q1_q1 - solve_1 * l_q2_q1 - M_q1_q3 * l_q3_q1;
    let tau_q3_l_q3_q2_minus_tau_q2 = tau_q3 * l_q3_q2 - tau_q2;
    let q1_ddot = (l_q2_q1 * tau_q3_l_q3_q2_minus_tau_q2 + tau_q1 - tau_q3 * l_q3_q1) / pivot_q1;
    let q2_ddot = -inv_q2 * tau_q3_l_q3_q2_minus_tau_q2 - l_q2_q1 * q1_ddot;
    let q3_ddot = tau_q3 * inv_q3 - l_q3_q1 * q1_ddot - l_q3_q2 * q2_ddot;
    positive(I_link_3_xx, 2)?;
    positive(pivot_q2, 1)?;
    positive(pivot_q1, 0)?;
    Ok(Accelerations::from_array([q1_ddot, q2_ddot, q3_ddot]))
}

/// x' and its Jacobians at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// x'.
    pub dx: [f64; 6],
    /// A = dx'/dx, 6 x 6.
    pub a: [[f64; 6]; 6],
    /// B = dx'/du, 6 x 3.
    pub b: [[f64; 3]; 6],
}

/// State derivative and its Jacobians A, B, exact, at any state.
/// 683 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///       q1 q2 q3 q1.dot q2.dot q3.dot | tau_1 tau_2 tau_3
/// q1'   .  .  .  1      .      .      | .     .     .
/// q2'   .  .  .  .      1      .      | .     .     .
/// q3'   .  .  .  .      .      1      | .     .     .
/// q1''  .  *  *  *      *      *      | *     *     *
/// q2''  .  *  *  *      *      *      | *     *     *
/// q3''  .  *  *  *      *      *      | *     *     *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let l_1_per_two = p.l_1 / 2.0;
    let b_sq = p.b * p.b;
    // body bar_1 on link_1
    let I_link_1_yy = p.m_1 * (b_sq + p.l_1 * p.l_1) / 12.0 + p.m_1 * l_1_per_two * l_1_per_two;
    let l_2_per_two = p.l_2 / 2.0;
    // body bar_2 on link_2
    let I_link_2_xx = p.m_2 * b_sq / 6.0;
    let mc_link_2_x = p.m_2 * l_2_per_two;
    let I_link_2_yy = p.m_2 * (b_sq + p.l_2 * p.l_2) / 12.0 + l_2_per_two * mc_link_2_x;
    let l_3_per_two = p.l_3 / 2.0;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let I_link_3_yy = p.m_3 * b_sq / 6.0;
    let mc_link_3_y = p.m_3 * l_3_per_two;
    let I_link_3_xx = p.m_3 * (b_sq + p.l_3 * p.l_3) / 12.0 + l_3_per_two * mc_link_3_y;
    // frame link_2 on link_1
    let omega_link_2_z = c_q2 * v.q1;
    let omega_link_2_x = -s_q2 * v.q1;
    let alpha_link_2_x = -omega_link_2_z * v.q2;
    let alpha_link_2_z = omega_link_2_x * v.q2;
    let omega_link_2_z_sq = omega_link_2_z * omega_link_2_z;
    let two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    let link_2_1 = omega_link_2_z * omega_link_2_x;
    let link_2_2 = I_link_2_xx - I_link_2_yy;
    let link_2_3 = omega_link_2_z_sq - omega_link_2_x * omega_link_2_x;
    let link_2_4 = I_link_2_yy - I_link_2_xx;
    let alpha_link_2_z_link_2_4 = alpha_link_2_z * link_2_4;
    let I_link_2_xx_plus_I_link_3_xx = I_link_2_xx + I_link_3_xx;
    // frame link_3 on link_2
    let omega_link_3_y = c_q3 * v.q2 + omega_link_2_z * s_q3;
    let omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v.q2;
    let omega_link_3_x = v.q3 + omega_link_2_x;
    let omega_link_3_z_q3_dot = omega_link_3_z * v.q3;
    let omega_link_3_y_q3_dot = omega_link_3_y * v.q3;
    let omega_link_3_z_sq = omega_link_3_z * omega_link_3_z;
    let link_3_1 = mc_link_3_y * (omega_link_3_z_sq + omega_link_3_x * omega_link_3_x);
    let link_3_2 = omega_link_3_y * omega_link_3_z;
    let n_moving_link_3_y = I_link_3_yy * (omega_link_3_z_q3_dot + alpha_link_2_z * s_q3);
    let link_3_3 = I_link_3_xx - I_link_3_yy;
    let link_3_2_link_3_3 = link_3_2 * link_3_3;
    let link_3_4 = I_link_3_yy - I_link_3_xx;
    let link_3_5 = omega_link_3_y * omega_link_3_x * link_3_4;
    let link_3_6 = link_3_5 - I_link_3_xx * (omega_link_3_y_q3_dot - alpha_link_2_z * c_q3);
    let mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    let M_q2_q3 = -p.l_2 * mc_link_3_y * c_q3;
    let l_2_mc_link_3_y_s_q3 = p.l_2 * mc_link_3_y_s_q3;
    let link_3_7 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    let M_q1_q3 = -link_3_7 - p.l_1 * mc_link_3_y_s_q3;
    let link_3_4_c_q3 = link_3_4 * c_q3;
    let link_3_4_c_q3_c_q3 = link_3_4_c_q3 * c_q3;
    // frame link_2 on link_1
    let a_link_2_1_x = -p.l_1 * v.q1 * v.q1;
    // frame link_3 on link_2
    let a_link_3_1_y = p.l_2 * two_alpha_link_2_z;
    let m_3_l_2 = p.m_3 * p.l_2;
    let l_2_m_3_l_2 = p.l_2 * m_3_l_2;
    // frame link_2 on link_1
    let a_link_2_z = p.g * c_q2 + a_link_2_1_x * s_q2;
    let a_link_2_x = a_link_2_1_x * c_q2 - p.g * s_q2;
    let M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_4_c_q3_c_q3 + l_2_m_3_l_2;
    let link_2_5 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    let M_q1_q2 = link_3_4_c_q3 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    let link_2_6 = I_link_2_yy + I_link_3_yy - link_3_4_c_q3_c_q3 + l_2_m_3_l_2 - I_link_2_xx_plus_I_link_3_xx;
    let link_2_7 = link_2_6 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    // frame link_3 on link_2
    let a_link_3_1_x = a_link_2_x - p.l_2 * (v.q2 * v.q2 + omega_link_2_z_sq);
    let a_link_3_1_z = a_link_2_z + p.l_2 * link_2_1;
    let a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    let a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    let f_link_3_y = p.m_3 * a_link_3_y - link_3_1;
    let f_link_3_z = mc_link_3_y * (link_3_2 + alpha_link_2_x) + p.m_3 * a_link_3_z;
    let mc_link_3_y_a_link_3_1_x = mc_link_3_y * a_link_3_1_x;
    let n_link_3_x = link_3_2_link_3_3 + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    let n_link_3_z = link_3_6 - mc_link_3_y_a_link_3_1_x;
    let f_link_3_1_y = f_link_3_y * c_q3 - f_link_3_z * s_q3;
    let f_link_3_1_z = f_link_3_y * s_q3 + f_link_3_z * c_q3;
    let n_link_3_1_y = n_moving_link_3_y * c_q3 - n_link_3_z * s_q3;
    let n_link_3_1_z = n_moving_link_3_y * s_q3 + n_link_3_z * c_q3;
    // frame link_2 on link_1
    let n_link_2_y = n_link_3_1_y - p.l_2 * f_link_3_1_z + link_2_1 * link_2_2 - mc_link_2_x * a_link_2_z;
    let n_link_2_z = n_link_3_1_z + p.l_2 * f_link_3_1_y + I_link_2_yy * alpha_link_2_z + alpha_link_2_z_link_2_4;
    let n_link_2_1_z = n_link_2_z * c_q2 - s_q2 * (n_link_3_x + I_link_2_xx * alpha_link_2_x);
    let n_link_1_z = n_link_2_1_z + p.l_1 * (mc_link_2_x * two_alpha_link_2_z + f_link_3_1_y);
    let link_2_1_1 = p.l_1 * (link_2_5 + link_2_5 + p.l_1 * (p.m_2 + p.m_3));
    // frame link_1 on ground
    let M_q1_q1 = I_link_1_yy + I_link_2_xx_plus_I_link_3_xx + link_2_7 * c_q2 + link_2_1_1;
    let c_q2_s_q3 = c_q2 * s_q3;
    let c_q2_c_q3 = c_q2 * c_q3;
    let c_q2_q2_dot = c_q2 * v.q2;
    let s_q2_q2_dot = s_q2 * v.q2;
    let omega_link_2_x_s_q3 = omega_link_2_x * s_q3;
    let omega_link_2_x_c_q3 = omega_link_2_x * c_q3;
    let I_link_3_yy_omega_link_3_z = I_link_3_yy * omega_link_3_z;
    // balance of forces
    let tau_q1 = u.tau_1 - p.c_1 * v.q1 - n_link_1_z;
    let tau_q2 = u.tau_2 - p.c_2 * v.q2 - n_link_2_y;
    let tau_q3 = u.tau_3 - p.c_3 * v.q3 - n_link_3_x;
    // M = L^T D L and back-substitution
    let inv_q3 = 1.0 / I_link_3_xx;
    let l_q3_q1 = M_q1_q3 * inv_q3;
    let l_q3_q2 = M_q2_q3 * inv_q3;
    let pivot_q2 = M_q2_q2 - M_q2_q3 * l_q3_q2;
    let inv_q2 = 1.0 / pivot_q2;
    let solve_1 = M_q1_q2 - M_q1_q3 * l_q3_q2;
    let l_q2_q1 = inv_q2 * solve_1;
    let pivot_q1 = M_q1_q1 - solve_1 * l_q2_q1 - M_q1_q3 * l_q3_q1;
    let inv_q1 = 1.0 / pivot_q1;
    let tau_q3_l_q3_q2_minus_tau_q2 = tau_q3 * l_q3_q2 - tau_q2;
    let q1_ddot = inv_q1 * (l_q2_q1 * tau_q3_l_q3_q2_minus_tau_q2 + tau_q1 - tau_q3 * l_q3_q1);
    let q2_ddot = -inv_q2 * tau_q3_l_q3_q2_minus_tau_q2 - l_q2_q1 * q1_ddot;
    let q3_ddot = tau_q3 * inv_q3 - l_q3_q1 * q1_ddot - l_q3_q2 * q2_ddot;
    let two_omega_link_2_z = 2.0 * omega_link_2_z;
    let two_omega_link_3_z = 2.0 * omega_link_3_z;
    let two_omega_link_3_x = 2.0 * omega_link_3_x;
    // derivatives with respect to q2
    let by_q2_1 = mc_link_3_y * (omega_link_2_z * two_omega_link_3_x - omega_link_2_x_c_q3 * two_omega_link_3_z);
    let by_q2_2 = omega_link_3_z * omega_link_2_x_s_q3 + omega_link_3_y * omega_link_2_x_c_q3;
    let by_q2_3 = link_3_4 * (omega_link_2_z * omega_link_3_y - omega_link_3_x * omega_link_2_x_s_q3);
    let by_q2_4 = mc_link_3_y * (a_link_2_z + p.l_2 * omega_link_2_x * two_omega_link_2_z);
    let by_q2_5 = mc_link_2_x * a_link_2_x + link_2_2 * link_2_3;
    let by_q2_6 = p.l_2 * link_2_3 - a_link_2_x;
    // derivatives with respect to q3
    let by_q3_1 = omega_link_3_z_sq - omega_link_3_y * omega_link_3_y;
    let link_3_3_by_q3_1 = link_3_3 * by_q3_1;
    let two_l_1_q1_dot = 2.0 * p.l_1 * v.q1;
    let two_l_1_q1_dot_s_q2 = two_l_1_q1_dot * s_q2;
    // derivatives with respect to q1_dot
    let by_q1_dot_1 = omega_link_2_z * s_q2 - omega_link_2_x * c_q2;
    let by_q1_dot_2 = mc_link_3_y * (c_q2_c_q3 * two_omega_link_3_z - two_omega_link_3_x * s_q2);
    let by_q1_dot_3 = omega_link_3_z * c_q2_s_q3 + omega_link_3_y * c_q2_c_q3;
    let by_q1_dot_4 = link_3_4 * (omega_link_3_x * c_q2_s_q3 - omega_link_3_y * s_q2);
    let by_q1_dot_5 = two_l_1_q1_dot * c_q2 + p.l_2 * two_omega_link_2_z * c_q2;
    let two_s_q2_q2_dot = 2.0 * s_q2_q2_dot;
    let by_q1_dot_6 = link_2_4 * s_q2_q2_dot + I_link_2_yy * s_q2_q2_dot;
    let by_q1_dot_7 = mc_link_2_x * two_l_1_q1_dot_s_q2 - link_2_2 * by_q1_dot_1;
    let l_2_two_s_q2_q2_dot = p.l_2 * two_s_q2_q2_dot;
    let by_q1_dot_8 = two_l_1_q1_dot_s_q2 + p.l_2 * by_q1_dot_1;
    let by_q1_dot_9 = by_q1_dot_8 * c_q3 - l_2_two_s_q2_q2_dot * s_q3;
    let by_q1_dot_10 = p.m_3 * (-l_2_two_s_q2_q2_dot * c_q3 - by_q1_dot_8 * s_q3);
    let by_q1_dot_11 = by_q1_dot_10 - by_q1_dot_2;
    let by_q1_dot_12 = mc_link_3_y * (by_q1_dot_3 - c_q2_q2_dot) - p.m_3 * by_q1_dot_9;
    let by_q1_dot_13 = I_link_3_yy * (c_q2_c_q3 * v.q3 - s_q2_q2_dot * s_q3);
    let by_q1_dot_14 = I_link_3_xx * (s_q2_q2_dot * c_q3 + c_q2_s_q3 * v.q3);
    let mc_link_3_y_by_q1_dot_9 = mc_link_3_y * by_q1_dot_9;
    let by_q1_dot_15 = link_3_3 * by_q1_dot_3 - I_link_3_xx * c_q2_q2_dot;
    let by_q1_dot_16 = mc_link_3_y * by_q1_dot_5 + by_q1_dot_4 - by_q1_dot_14;
    let by_q1_dot_17 = by_q1_dot_11 * c_q3 - by_q1_dot_12 * s_q3;
    let by_q1_dot_18 = by_q1_dot_13 * c_q3 - by_q1_dot_16 * s_q3;
    let by_q1_dot_19 = by_q1_dot_13 * s_q3 + by_q1_dot_16 * c_q3;
    let by_q1_dot_20 = p.l_2 * (by_q1_dot_11 * s_q3 + by_q1_dot_12 * c_q3);
    let by_q1_dot_21 = c_q2 * (by_q1_dot_19 + p.l_2 * by_q1_dot_17 - by_q1_dot_6);
    let by_q1_dot_22 = s_q2 * (by_q1_dot_15 - mc_link_3_y_by_q1_dot_9 - I_link_2_xx * c_q2_q2_dot);
    let by_q1_dot_23 = p.l_1 * (by_q1_dot_17 - mc_link_2_x * two_s_q2_q2_dot);
    let by_q1_dot_24 = p.c_1 + by_q1_dot_21 - by_q1_dot_22 + by_q1_dot_23;
    let by_q1_dot_25 = mc_link_3_y_by_q1_dot_9 - by_q1_dot_15;
    let by_q1_dot_26 = by_q1_dot_20 - l_q3_q2 * by_q1_dot_25 - by_q1_dot_7 - by_q1_dot_18;
    let d_q1_ddot_by_q1_dot = inv_q1 * (-l_q3_q1 * by_q1_dot_25 - by_q1_dot_24 - l_q2_q1 * by_q1_dot_26);
    let d_q2_ddot_by_q1_dot = inv_q2 * by_q1_dot_26 - l_q2_q1 * d_q1_ddot_by_q1_dot;
    let d_q3_ddot_by_q1_dot = inv_q3 * by_q1_dot_25 - l_q3_q1 * d_q1_ddot_by_q1_dot - l_q3_q2 * d_q2_ddot_by_q1_dot;
    // derivatives with respect to q2_dot
    let by_q2_dot_1 = mc_link_3_y * two_omega_link_3_z * s_q3;
    let by_q2_dot_2 = omega_link_3_z * c_q3 - omega_link_3_y * s_q3;
    let two_omega_link_2_x = 2.0 * omega_link_2_x;
    let by_q2_dot_3 = omega_link_2_x * link_2_4 + I_link_2_yy * omega_link_2_x;
    let l_2_two_omega_link_2_x = p.l_2 * two_omega_link_2_x;
    let l_2_two_omega_link_2_x_s_q3 = l_2_two_omega_link_2_x * s_q3;
    let by_q2_dot_4 = by_q2_dot_1 + p.m_3 * l_2_two_omega_link_2_x * c_q3;
    let by_q2_dot_5 = mc_link_3_y * (by_q2_dot_2 - omega_link_2_z) - p.m_3 * l_2_two_omega_link_2_x_s_q3;
    let by_q2_dot_6 = I_link_3_yy * (s_q3 * v.q3 - omega_link_2_x_s_q3);
    let by_q2_dot_7 = I_link_3_xx * (c_q3 * v.q3 - omega_link_2_x_c_q3);
    let by_q2_dot_8 = mc_link_3_y * l_2_two_omega_link_2_x_s_q3;
    let by_q2_dot_9 = link_3_3 * by_q2_dot_2 - I_link_3_xx * omega_link_2_z;
    let by_q2_dot_10 = link_3_4 * omega_link_3_x * c_q3 - by_q2_dot_7;
    let by_q2_dot_11 = 2.0 * p.l_2 * mc_link_3_y * v.q2 + by_q2_dot_10;
    let by_q2_dot_12 = by_q2_dot_4 * c_q3 - by_q2_dot_5 * s_q3;
    let by_q2_dot_13 = by_q2_dot_6 * c_q3 + by_q2_dot_11 * s_q3;
    let by_q2_dot_14 = by_q2_dot_11 * c_q3 - by_q2_dot_6 * s_q3;
    let by_q2_dot_15 = p.l_2 * (by_q2_dot_4 * s_q3 + by_q2_dot_5 * c_q3);
    let by_q2_dot_16 = c_q2 * (by_q2_dot_14 + p.l_2 * by_q2_dot_12 + by_q2_dot_3);
    let by_q2_dot_17 = s_q2 * (by_q2_dot_9 - by_q2_dot_8 - I_link_2_xx * omega_link_2_z);
    let by_q2_dot_18 = p.l_1 * (mc_link_2_x * two_omega_link_2_x + by_q2_dot_12);
    let by_q2_dot_19 = by_q2_dot_8 - by_q2_dot_9;
    let by_q2_dot_20 = by_q2_dot_13 + by_q2_dot_15 - p.c_2 - l_q3_q2 * by_q2_dot_19;
    let by_q2_dot_21 = by_q2_dot_16 - by_q2_dot_17 + by_q2_dot_18 + l_q2_q1 * by_q2_dot_20;
    let d_q1_ddot_by_q2_dot = inv_q1 * (-l_q3_q1 * by_q2_dot_19 - by_q2_dot_21);
    let d_q2_ddot_by_q2_dot = inv_q2 * by_q2_dot_20 - l_q2_q1 * d_q1_ddot_by_q2_dot;
    let d_q3_ddot_by_q2_dot = inv_q3 * by_q2_dot_19 - l_q3_q1 * d_q1_ddot_by_q2_dot - l_q3_q2 * d_q2_ddot_by_q2_dot;
    // derivatives with respect to q3_dot
    let by_q3_dot_1 = mc_link_3_y * two_omega_link_3_x;
    let by_q3_dot_2 = omega_link_3_y * link_3_4 - I_link_3_xx * omega_link_3_y;
    let by_q3_dot_1_c_q3 = by_q3_dot_1 * c_q3;
    let by_q3_dot_3 = I_link_3_yy_omega_link_3_z * c_q3 - by_q3_dot_2 * s_q3;
    let by_q3_dot_4 = I_link_3_yy_omega_link_3_z * s_q3 + by_q3_dot_2 * c_q3;
    let by_q3_dot_5 = c_q2 * (by_q3_dot_4 - p.l_2 * by_q3_dot_1_c_q3);
    let by_q3_dot_6 = by_q3_dot_3 + p.l_2 * by_q3_dot_1 * s_q3 - p.c_3 * l_q3_q2;
    let by_q3_dot_7 = p.l_1 * by_q3_dot_1_c_q3 - by_q3_dot_5 + l_q2_q1 * by_q3_dot_6 + p.c_3 * l_q3_q1;
    let d_q1_ddot_by_q3_dot = inv_q1 * by_q3_dot_7;
    let d_q2_ddot_by_q3_dot = -inv_q2 * by_q3_dot_6 - l_q2_q1 * d_q1_ddot_by_q3_dot;
    let d_q3_ddot_by_q3_dot = -l_q3_q1 * d_q1_ddot_by_q3_dot - p.c_3 * inv_q3 - l_q3_q2 * d_q2_ddot_by_q3_dot;
    let q1_ddot_c_q2 = q1_ddot * c_q2;
    let l_1_q1_ddot = p.l_1 * q1_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = q1_ddot * s_q2 - alpha_link_2_x;
    let slopes_2 = q1_ddot_c_q2 + alpha_link_2_z;
    let slopes_3 = mc_link_2_x * l_1_q1_ddot + I_link_2_yy * slopes_2 + alpha_link_2_z_link_2_4;
    let slopes_4 = l_1_q1_ddot + p.l_2 * (slopes_2 + alpha_link_2_z);
    let slopes_5 = a_link_2_z - p.l_2 * (q2_ddot - link_2_1);
    let slopes_6 = omega_link_3_z_q3_dot + slopes_2 * s_q3 + q2_ddot * c_q3;
    let slopes_7 = slopes_2 * c_q3 - q2_ddot * s_q3 - omega_link_3_y_q3_dot;
    let q3_ddot_minus_slopes_1 = q3_ddot - slopes_1;
    let slopes_8 = slopes_4 * c_q3 + slopes_5 * s_q3;
    let slopes_9 = slopes_5 * c_q3 - slopes_4 * s_q3;
    let m_3_slopes_8 = p.m_3 * slopes_8;
    let m_3_slopes_9 = p.m_3 * slopes_9;
    let m_3_slopes_8_minus_link_3_1 = m_3_slopes_8 - link_3_1;
    let slopes_10 = m_3_slopes_9 + mc_link_3_y * (link_3_2 + q3_ddot_minus_slopes_1);
    let I_link_3_yy_slopes_6 = I_link_3_yy * slopes_6;
    let slopes_11 = mc_link_3_y * slopes_9 + link_3_2_link_3_3 + I_link_3_xx * q3_ddot_minus_slopes_1;
    let slopes_12 = link_3_5 - mc_link_3_y_a_link_3_1_x + I_link_3_xx * slopes_7;
    let slopes_13 = m_3_slopes_8_minus_link_3_1 * c_q3;
    let slopes_10_s_q3 = slopes_10 * s_q3;
    let I_link_3_yy_slopes_6_s_q3 = I_link_3_yy_slopes_6 * s_q3;
    let slopes_12_c_q3 = slopes_12 * c_q3;
    let slopes_14 = I_link_3_yy_slopes_6_s_q3 + slopes_12_c_q3 + p.l_2 * (slopes_13 - slopes_10_s_q3);
    let slopes_15 = slopes_1 - alpha_link_2_x;
    let slopes_16 = I_link_2_yy * slopes_1 - alpha_link_2_x * link_2_4;
    let l_2_slopes_15 = p.l_2 * slopes_15;
    let slopes_17 = alpha_link_2_z + q1_ddot_c_q2;
    let slopes_18 = l_2_slopes_15 * s_q3 - by_q2_6 * c_q3;
    let slopes_19 = p.m_3 * (by_q2_6 * s_q3 + l_2_slopes_15 * c_q3);
    let by_q2_1_minus_slopes_19 = by_q2_1 - slopes_19;
    let slopes_20 = p.m_3 * slopes_18 + mc_link_3_y * (by_q2_2 - slopes_17);
    let slopes_21 = I_link_3_yy * (slopes_1 * s_q3 - omega_link_2_x_c_q3 * v.q3);
    let slopes_22 = I_link_3_xx * (-omega_link_2_x_s_q3 * v.q3 - slopes_1 * c_q3);
    let slopes_23 = link_3_3 * by_q2_2 - I_link_3_xx * slopes_17;
    let slopes_24 = mc_link_3_y * slopes_18 + slopes_23;
    let slopes_25 = by_q2_4 + slopes_22 - by_q2_3;
    let slopes_26 = by_q2_1_minus_slopes_19 * c_q3 - slopes_20 * s_q3;
    let slopes_27 = slopes_21 * c_q3 + slopes_25 * s_q3;
    let slopes_28 = slopes_25 * c_q3 - slopes_21 * s_q3;
    let slopes_29 = p.l_2 * (by_q2_1_minus_slopes_19 * s_q3 + slopes_20 * c_q3);
    let slopes_30 = c_q2 * (slopes_28 + p.l_2 * slopes_26 - slopes_16);
    let slopes_31 = slopes_30 - s_q2 * (slopes_3 + slopes_14);
    let slopes_32 = s_q2 * (slopes_24 - I_link_2_xx * slopes_2);
    let slopes_33 = c_q2 * (slopes_11 - I_link_2_xx * slopes_1) + slopes_32;
    let slopes_34 = p.l_1 * (slopes_26 - mc_link_2_x * slopes_15);
    let slopes_35 = mc_link_3_y * omega_link_3_y * two_omega_link_3_z + m_3_slopes_9;
    let slopes_36 = mc_link_3_y * by_q3_1 - m_3_slopes_8;
    let I_link_3_yy_slopes_7 = I_link_3_yy * slopes_7;
    let mc_link_3_y_slopes_8 = mc_link_3_y * slopes_8;
    let slopes_37 = omega_link_3_z * omega_link_3_x * link_3_4 - I_link_3_xx * slopes_6;
    let slopes_38 = slopes_35 * c_q3 - m_3_slopes_8_minus_link_3_1 * s_q3;
    let slopes_39 = slopes_10 * c_q3 + slopes_36 * s_q3;
    let slopes_40 = slopes_36 * c_q3 - slopes_10_s_q3;
    let slopes_38_minus_slopes_39 = slopes_38 - slopes_39;
    let slopes_41 = slopes_12_c_q3 + slopes_37 * s_q3;
    let slopes_42 = I_link_3_yy_slopes_6 * c_q3 + I_link_3_yy_slopes_7 * s_q3;
    let slopes_43 = slopes_37 * c_q3 - slopes_12 * s_q3;
    let slopes_44 = I_link_3_yy_slopes_7 * c_q3 - I_link_3_yy_slopes_6_s_q3 - slopes_41;
    let slopes_45 = p.l_2 * (slopes_13 + slopes_35 * s_q3 + slopes_40);
    let slopes_46 = c_q2 * (slopes_42 + slopes_43 + p.l_2 * slopes_38_minus_slopes_39);
    let slopes_47 = slopes_46 - s_q2 * (link_3_3_by_q3_1 - mc_link_3_y_slopes_8);
    // derivatives with respect to q2
    let by_q2_7 = slopes_27 + slopes_29 + by_q2_5 + l_q3_q2 * slopes_24;
    let by_q2_8 = slopes_31 - slopes_33 + slopes_34 + l_q2_q1 * by_q2_7;
    let d_q1_ddot_by_q2 = -inv_q1 * (by_q2_8 - l_q3_q1 * slopes_24);
    let d_q2_ddot_by_q2 = inv_q2 * by_q2_7 - l_q2_q1 * d_q1_ddot_by_q2;
    let d_q3_ddot_by_q2 = -l_q3_q2 * d_q2_ddot_by_q2 - inv_q3 * slopes_24 - l_q3_q1 * d_q1_ddot_by_q2;
    // derivatives with respect to q3
    let by_q3_2 = mc_link_3_y_slopes_8 - link_3_3_by_q3_1;
    let by_q3_3 = slopes_45 - slopes_44 - l_q3_q2 * by_q3_2;
    let by_q3_4 = slopes_47 + p.l_1 * slopes_38_minus_slopes_39 + l_q2_q1 * by_q3_3;
    let d_q1_ddot_by_q3 = inv_q1 * (-l_q3_q1 * by_q3_2 - by_q3_4);
    let d_q2_ddot_by_q3 = inv_q2 * by_q3_3 - l_q2_q1 * d_q1_ddot_by_q3;
    let d_q3_ddot_by_q3 = inv_q3 * by_q3_2 - l_q3_q1 * d_q1_ddot_by_q3 - l_q3_q2 * d_q2_ddot_by_q3;
    // derivatives with respect to tau_1
    let d_q2_ddot_by_tau_1 = -l_q2_q1 * inv_q1;
    let d_q3_ddot_by_tau_1 = -l_q3_q1 * inv_q1 - l_q3_q2 * d_q2_ddot_by_tau_1;
    // derivatives with respect to tau_2
    let d_q2_ddot_by_tau_2 = inv_q2 - l_q2_q1 * d_q2_ddot_by_tau_1;
    let d_q3_ddot_by_tau_2 = -l_q3_q2 * d_q2_ddot_by_tau_2 - l_q3_q1 * d_q2_ddot_by_tau_1;
    // derivatives with respect to tau_3
    let d_q1_ddot_by_tau_3 = inv_q1 * (l_q3_q2 * l_q2_q1 - l_q3_q1);
    let d_q2_ddot_by_tau_3 = -l_q3_q2 * inv_q2 - l_q2_q1 * d_q1_ddot_by_tau_3;
    let d_q3_ddot_by_tau_3 = inv_q3 - l_q3_q1 * d_q1_ddot_by_tau_3 - l_q3_q2 * d_q2_ddot_by_tau_3;
    positive(I_link_3_xx, 2)?;
    positive(pivot_q2, 1)?;
    positive(pivot_q1, 0)?;
    Ok(Linearization {
        dx: [v.q1, v.q2, v.q3, q1_ddot, q2_ddot, q3_ddot],
        a: [
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0], // q1'
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0], // q2'
            [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], // q3'
            [0.0, d_q1_ddot_by_q2, d_q1_ddot_by_q3, d_q1_ddot_by_q1_dot, d_q1_ddot_by_q2_dot, d_q1_ddot_by_q3_dot], // q1''
            [0.0, d_q2_ddot_by_q2, d_q2_ddot_by_q3, d_q2_ddot_by_q1_dot, d_q2_ddot_by_q2_dot, d_q2_ddot_by_q3_dot], // q2''
            [0.0, d_q3_ddot_by_q2, d_q3_ddot_by_q3, d_q3_ddot_by_q1_dot, d_q3_ddot_by_q2_dot, d_q3_ddot_by_q3_dot], // q3''
        ],
        b: [
            [0.0, 0.0, 0.0], // q1'
            [0.0, 0.0, 0.0], // q2'
            [0.0, 0.0, 0.0], // q3'
            [inv_q1, d_q2_ddot_by_tau_1, d_q1_ddot_by_tau_3], // q1''
            [d_q2_ddot_by_tau_1, d_q2_ddot_by_tau_2, d_q2_ddot_by_tau_3], // q2''
            [d_q3_ddot_by_tau_1, d_q3_ddot_by_tau_2, d_q3_ddot_by_tau_3], // q3''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 6 x 11; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 11]; 6], Singular> {
    let State { q, v } = x;
    let (s_q2, c_q2) = sin_cos(q.q2);
    let (s_q3, c_q3) = sin_cos(q.q3);
    let l_1_per_two = p.l_1 / 2.0;
    let b_sq = p.b * p.b;
    let b_sq_plus_l_1_sq = b_sq + p.l_1 * p.l_1;
    // body bar_1 on link_1
    let mc_link_1_x = p.m_1 * l_1_per_two;
    let I_link_1_yy = p.m_1 * b_sq_plus_l_1_sq / 12.0 + l_1_per_two * mc_link_1_x;
    let l_2_per_two = p.l_2 / 2.0;
    // body bar_2 on link_2
    let I_link_2_xx = p.m_2 * b_sq / 6.0;
    let b_sq_plus_l_2_sq = b_sq + p.l_2 * p.l_2;
    let mc_link_2_x = p.m_2 * l_2_per_two;
    let I_link_2_yy = p.m_2 * b_sq_plus_l_2_sq / 12.0 + l_2_per_two * mc_link_2_x;
    let l_3_per_two = p.l_3 / 2.0;
    let b_sq_plus_l_3_sq = b_sq + p.l_3 * p.l_3;
    // body bar_3 on link_3: the last bar is cranked: its centre lies beside the joint's axis
    let I_link_3_yy = p.m_3 * b_sq / 6.0;
    let mc_link_3_y = p.m_3 * l_3_per_two;
    let I_link_3_xx = p.m_3 * b_sq_plus_l_3_sq / 12.0 + l_3_per_two * mc_link_3_y;
    // frame link_2 on link_1
    let omega_link_2_z = c_q2 * v.q1;
    let omega_link_2_x = -s_q2 * v.q1;
    let alpha_link_2_x = -omega_link_2_z * v.q2;
    let alpha_link_2_z = omega_link_2_x * v.q2;
    let link_2_1 = v.q2 * v.q2 + omega_link_2_z * omega_link_2_z;
    let two_alpha_link_2_z = 2.0 * alpha_link_2_z;
    let link_2_2 = omega_link_2_z * omega_link_2_x;
    let link_2_3 = I_link_2_yy * alpha_link_2_z + alpha_link_2_z * (I_link_2_yy - I_link_2_xx);
    let I_link_2_xx_plus_I_link_3_xx = I_link_2_xx + I_link_3_xx;
    // frame link_3 on link_2
    let omega_link_3_y = c_q3 * v.q2 + omega_link_2_z * s_q3;
    let omega_link_3_z = omega_link_2_z * c_q3 - s_q3 * v.q2;
    let omega_link_3_x = v.q3 + omega_link_2_x;
    let omega_link_3_z_q3_dot = omega_link_3_z * v.q3;
    let omega_link_3_y_q3_dot = omega_link_3_y * v.q3;
    let link_3_1 = omega_link_3_y * omega_link_3_x;
    let link_3_2 = omega_link_3_z * omega_link_3_z + omega_link_3_x * omega_link_3_x;
    let mc_link_3_y_link_3_2 = mc_link_3_y * link_3_2;
    let link_3_3 = omega_link_3_y * omega_link_3_z;
    let n_moving_link_3_y = I_link_3_yy * (omega_link_3_z_q3_dot + alpha_link_2_z * s_q3);
    let link_3_4 = I_link_3_xx * (omega_link_3_y_q3_dot - alpha_link_2_z * c_q3);
    let link_3_5 = I_link_3_yy - I_link_3_xx;
    let mc_link_3_y_s_q3 = mc_link_3_y * s_q3;
    let M_q2_q3 = -p.l_2 * mc_link_3_y * c_q3;
    let l_2_mc_link_3_y_s_q3 = p.l_2 * mc_link_3_y_s_q3;
    let link_3_6 = l_2_mc_link_3_y_s_q3 * c_q2 + I_link_3_xx * s_q2;
    let M_q1_q3 = -link_3_6 - p.l_1 * mc_link_3_y_s_q3;
    let link_3_5_c_q3 = link_3_5 * c_q3;
    let link_3_5_c_q3_c_q3 = link_3_5_c_q3 * c_q3;
    let q1_dot_sq = v.q1 * v.q1;
    // frame link_2 on link_1
    let a_link_2_1_x = -p.l_1 * q1_dot_sq;
    // frame link_3 on link_2
    let a_link_3_1_y = p.l_2 * two_alpha_link_2_z;
    let m_3_l_2 = p.m_3 * p.l_2;
    let l_2_m_3_l_2 = p.l_2 * m_3_l_2;
    // frame link_2 on link_1
    let a_link_2_z = p.g * c_q2 + a_link_2_1_x * s_q2;
    let a_link_2_x = a_link_2_1_x * c_q2 - p.g * s_q2;
    let link_2_4 = mc_link_2_x * a_link_2_z - link_2_2 * (I_link_2_xx - I_link_2_yy);
    let M_q2_q2 = I_link_2_yy + I_link_3_xx + link_3_5_c_q3_c_q3 + l_2_m_3_l_2;
    let link_2_5 = c_q2 * (mc_link_2_x + m_3_l_2) + mc_link_3_y_s_q3 * s_q2;
    let M_q1_q2 = link_3_5_c_q3 * c_q2 * s_q3 - M_q2_q3 * s_q2;
    let link_2_6 = I_link_2_yy + I_link_3_yy - link_3_5_c_q3_c_q3 + l_2_m_3_l_2 - I_link_2_xx_plus_I_link_3_xx;
    let link_2_7 = link_2_6 * c_q2 + 2.0 * l_2_mc_link_3_y_s_q3 * s_q2;
    // frame link_3 on link_2
    let a_link_3_1_x = a_link_2_x - p.l_2 * link_2_1;
    let a_link_3_1_z = a_link_2_z + p.l_2 * link_2_2;
    let a_link_3_y = a_link_3_1_y * c_q3 + a_link_3_1_z * s_q3;
    let a_link_3_z = a_link_3_1_z * c_q3 - a_link_3_1_y * s_q3;
    let f_link_3_y = p.m_3 * a_link_3_y - mc_link_3_y_link_3_2;
    let f_link_3_z = mc_link_3_y * (link_3_3 + alpha_link_2_x) + p.m_3 * a_link_3_z;
    let n_link_3_x = link_3_3 * (I_link_3_xx - I_link_3_yy) + I_link_3_xx * alpha_link_2_x + mc_link_3_y * a_link_3_z;
    let n_link_3_z = link_3_1 * link_3_5 - link_3_4 - mc_link_3_y * a_link_3_1_x;
    let f_link_3_1_y = f_link_3_y * c_q3 - f_link_3_z * s_q3;
    let f_link_3_1_z = f_link_3_y * s_q3 + f_link_3_z * c_q3;
    let n_link_3_1_y = n_moving_link_3_y * c_q3 - n_link_3_z * s_q3;
    let n_link_3_1_z = n_moving_link_3_y * s_q3 + n_link_3_z * c_q3;
    // frame link_2 on link_1
    let n_link_2_y = n_link_3_1_y - p.l_2 * f_link_3_1_z - link_2_4;
    let n_link_2_z = n_link_3_1_z + p.l_2 * f_link_3_1_y + link_2_3;
    let n_link_2_1_z = n_link_2_z * c_q2 - s_q2 * (n_link_3_x + I_link_2_xx * alpha_link_2_x);
    let n_link_1_z = n_link_2_1_z + p.l_1 * (mc_link_2_x * two_alpha_link_2_z + f_link_3_1_y);
    let link_2_1_1 = p.l_1 * (link_2_5 + link_2_5 + p.l_1 * (p.m_2 + p.m_3));
    // frame link_1 on ground
    let M_q1_q1 = I_link_1_yy + I_link_2_xx_plus_I_link_3_xx + link_2_7 * c_q2 + link_2_1_1;
    let c_q2_c_q3 = c_q2 * c_q3;
    // balance of forces
    let tau_q1 = u.tau_1 - p.c_1 * v.q1 - n_link_1_z;
    let tau_q2 = u.tau_2 - p.c_2 * v.q2 - n_link_2_y;
    let tau_q3 = u.tau_3 - p.c_3 * v.q3 - n_link_3_x;
    // M = L^T D L and back-substitution
    let inv_q3 = 1.0 / I_link_3_xx;
    let l_q3_q1 = M_q1_q3 * inv_q3;
    let l_q3_q2 = M_q2_q3 * inv_q3;
    let pivot_q2 = M_q2_q2 - M_q2_q3 * l_q3_q2;
    let inv_q2 = 1.0 / pivot_q2;
    let solve_1 = M_q1_q2 - M_q1_q3 * l_q3_q2;
    let l_q2_q1 = inv_q2 * solve_1;
    let pivot_q1 = M_q1_q1 - solve_1 * l_q2_q1 - M_q1_q3 * l_q3_q1;
    let inv_q1 = 1.0 / pivot_q1;
    let tau_q3_l_q3_q2_minus_tau_q2 = tau_q3 * l_q3_q2 - tau_q2;
    let q1_ddot = inv_q1 * (l_q2_q1 * tau_q3_l_q3_q2_minus_tau_q2 + tau_q1 - tau_q3 * l_q3_q1);
    let q2_ddot = -inv_q2 * tau_q3_l_q3_q2_minus_tau_q2 - l_q2_q1 * q1_ddot;
    let q3_ddot = tau_q3 * inv_q3 - l_q3_q1 * q1_ddot - l_q3_q2 * q2_ddot;
    let l_1_q1_ddot = p.l_1 * q1_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = q1_ddot * s_q2 - alpha_link_2_x;
    let slopes_2 = q1_ddot * c_q2 + alpha_link_2_z;
    let slopes_2_plus_alpha_link_2_z = slopes_2 + alpha_link_2_z;
    let q2_ddot_minus_link_2_2 = q2_ddot - link_2_2;
    let slopes_3 = l_1_q1_ddot + p.l_2 * slopes_2_plus_alpha_link_2_z;
    let slopes_4 = a_link_2_z - p.l_2 * q2_ddot_minus_link_2_2;
    let slopes_5 = omega_link_3_z_q3_dot + slopes_2 * s_q3 + q2_ddot * c_q3;
    let slopes_6 = slopes_2 * c_q3 - q2_ddot * s_q3 - omega_link_3_y_q3_dot;
    let q3_ddot_minus_slopes_1 = q3_ddot - slopes_1;
    let slopes_7 = slopes_3 * c_q3 + slopes_4 * s_q3;
    let slopes_8 = slopes_4 * c_q3 - slopes_3 * s_q3;
    let slopes_9 = link_3_3 + q3_ddot_minus_slopes_1;
    let slopes_10 = p.m_3 * slopes_7 - mc_link_3_y_link_3_2;
    let slopes_11 = p.m_3 * slopes_8 + mc_link_3_y * slopes_9;
    let slopes_12 = slopes_10 * c_q3 - slopes_11 * s_q3;
    let slopes_13 = slopes_10 * s_q3 + slopes_11 * c_q3;
    let slopes_14 = slopes_12 + p.m_2 * l_1_q1_ddot + mc_link_2_x * slopes_2_plus_alpha_link_2_z;
    let slopes_15 = p.l_1 * (l_1_q1_ddot + l_2_per_two * slopes_2_plus_alpha_link_2_z);
    let slopes_16 = slopes_7 - l_3_per_two * link_3_2;
    let slopes_17 = slopes_8 + l_3_per_two * slopes_9;
    let slopes_18 = slopes_16 * c_q3 - slopes_17 * s_q3;
    let slopes_19 = p.l_2 * (slopes_16 * s_q3 + slopes_17 * c_q3);
    let slopes_20 = q1_ddot * (2.0 * p.m_1 * p.l_1 / 12.0 + 0.5 * mc_link_1_x + 0.5 * p.m_1 * l_1_per_two);
    let slopes_21 = slopes_2_plus_alpha_link_2_z * s_q3 + q2_ddot_minus_link_2_2 * c_q3;
    let slopes_22 = p.m_3 * (slopes_2_plus_alpha_link_2_z * c_q3 - q2_ddot_minus_link_2_2 * s_q3);
    let m_3_slopes_21 = p.m_3 * slopes_21;
    let mc_link_3_y_slopes_21 = mc_link_3_y * slopes_21;
    let slopes_23 = slopes_22 * c_q3 + m_3_slopes_21 * s_q3;
    let slopes_24 = p.l_2 * (slopes_22 * s_q3 - m_3_slopes_21 * c_q3);
    let b_sq_per_6 = b_sq / 6.0;
    // derivatives with respect to m_2
    let by_m_2_1 = b_sq_plus_l_2_sq / 12.0 + l_2_per_two * l_2_per_two;
    let by_m_2_2 = alpha_link_2_z * (by_m_2_1 - b_sq_per_6);
    // derivatives with respect to m_3
    let by_m_3_1 = b_sq_plus_l_3_sq / 12.0 + l_3_per_two * l_3_per_two;
    let by_m_3_2 = link_3_3 * (by_m_3_1 - b_sq_per_6);
    let by_m_3_3 = link_3_1 * (b_sq_per_6 - by_m_3_1);
    let q1_dot_sq_s_q2 = q1_dot_sq * s_q2;
    let mc_link_3_y_q1_dot_sq_c_q2 = mc_link_3_y * q1_dot_sq * c_q2;
    let half_m_2 = 0.5 * p.m_2;
    // derivatives with respect to l_2
    let by_l_2_1 = 2.0 * p.m_2 * p.l_2 / 12.0 + 0.5 * mc_link_2_x + l_2_per_two * half_m_2;
    let mc_link_3_y_link_2_1 = mc_link_3_y * link_2_1;
    let half_m_3 = 0.5 * p.m_3;
    // derivatives with respect to l_3
    let by_l_3_1 = 2.0 * p.m_3 * p.l_3 / 12.0 + 0.5 * mc_link_3_y + l_3_per_two * half_m_3;
    let link_3_2_half_m_3 = link_3_2 * half_m_3;
    let two_b = 2.0 * p.b;
    let m_2_two_b = p.m_2 * two_b;
    let m_2_two_b_per_6 = m_2_two_b / 6.0;
    let m_2_two_b_per_12 = m_2_two_b / 12.0;
    let m_3_two_b = p.m_3 * two_b;
    let m_3_two_b_per_12 = m_3_two_b / 12.0;
    let m_3_two_b_per_6 = m_3_two_b / 6.0;
    // derivatives with respect to b
    let by_b_1 = alpha_link_2_z * (m_2_two_b_per_12 - m_2_two_b_per_6);
    let by_b_2 = link_3_3 * (m_3_two_b_per_12 - m_3_two_b_per_6);
    let by_b_3 = link_3_1 * (m_3_two_b_per_6 - m_3_two_b_per_12);
    let mc_link_3_y_s_q2 = mc_link_3_y * s_q2;
    let m_3_c_q2_s_q3 = p.m_3 * c_q2 * s_q3;
    let m_3_c_q2_c_q3 = p.m_3 * c_q2_c_q3;
    let mc_link_3_y_c_q2_c_q3 = mc_link_3_y * c_q2_c_q3;
    // derivatives with respect to g
    let by_g_1 = m_3_c_q2_s_q3 * c_q3 - m_3_c_q2_c_q3 * s_q3;
    let by_g_2 = p.l_2 * (m_3_c_q2_s_q3 * s_q3 + m_3_c_q2_c_q3 * c_q3);
    let by_g_3 = mc_link_2_x * c_q2 + mc_link_3_y_s_q2 * s_q3 + by_g_2;
    let by_g_4 = c_q2 * (mc_link_3_y_s_q2 * c_q3 + p.l_2 * by_g_1);
    let by_g_5 = by_g_4 - mc_link_3_y_c_q2_c_q3 * s_q2 + p.l_1 * by_g_1;
    let by_g_6 = by_g_3 + l_q3_q2 * mc_link_3_y_c_q2_c_q3;
    let d_q1_ddot_by_g = -inv_q1 * (by_g_5 + l_q2_q1 * by_g_6 - l_q3_q1 * mc_link_3_y_c_q2_c_q3);
    let d_q2_ddot_by_g = inv_q2 * by_g_6 - l_q2_q1 * d_q1_ddot_by_g;
    let d_q3_ddot_by_g = -l_q3_q2 * d_q2_ddot_by_g - inv_q3 * mc_link_3_y_c_q2_c_q3 - l_q3_q1 * d_q1_ddot_by_g;
    // slopes of the balance of forces, at the accelerations found
    let slopes_25 = link_2_2 * (b_sq_per_6 - by_m_2_1) + q2_ddot * by_m_2_1;
    let slopes_26 = slopes_2 * by_m_2_1 + by_m_2_2;
    let slopes_27 = l_2_per_two * a_link_2_z - slopes_25;
    let slopes_28 = c_q2 * (l_2_per_two * l_1_q1_ddot + slopes_26);
    let slopes_29 = slopes_28 + slopes_1 * b_sq_per_6 * s_q2;
    let slopes_5_b_sq_per_6 = slopes_5 * b_sq_per_6;
    let slopes_30 = by_m_3_2 + q3_ddot_minus_slopes_1 * by_m_3_1;
    let slopes_31 = l_3_per_two * slopes_8 + slopes_30;
    let slopes_32 = by_m_3_3 - l_3_per_two * a_link_3_1_x + slopes_6 * by_m_3_1;
    let slopes_33 = slopes_5_b_sq_per_6 * c_q3 - slopes_32 * s_q3;
    let slopes_34 = slopes_5_b_sq_per_6 * s_q3 + slopes_32 * c_q3;
    let slopes_35 = c_q2 * (slopes_34 + p.l_2 * slopes_18);
    let slopes_36 = slopes_35 - slopes_31 * s_q2 + p.l_1 * slopes_18;
    let slopes_37 = q1_dot_sq_s_q2 * c_q3 + q1_ddot * s_q3;
    let slopes_38 = p.m_3 * (q1_ddot * c_q3 - q1_dot_sq_s_q2 * s_q3);
    let m_3_slopes_37 = p.m_3 * slopes_37;
    let mc_link_3_y_slopes_37 = mc_link_3_y * slopes_37;
    let slopes_39 = slopes_38 * c_q3 + m_3_slopes_37 * s_q3;
    let slopes_40 = p.l_2 * (slopes_38 * s_q3 - m_3_slopes_37 * c_q3);
    let slopes_41 = mc_link_2_x * q1_ddot + mc_link_3_y_q1_dot_sq_c_q2 * c_q3 + p.l_2 * slopes_39;
    let slopes_42 = slopes_41 * c_q2 + mc_link_3_y_slopes_37 * s_q2;
    let slopes_43 = p.l_1 * (p.m_2 * q1_ddot + slopes_39);
    let slopes_44 = slopes_20 + slopes_42 + slopes_14 + slopes_43;
    let slopes_45 = q2_ddot * by_l_2_1 - link_2_2 * by_l_2_1;
    let slopes_46 = slopes_2 * by_l_2_1 + alpha_link_2_z * by_l_2_1;
    let slopes_47 = mc_link_3_y_link_2_1 * s_q3 + slopes_13 + slopes_24;
    let slopes_48 = mc_link_3_y_link_2_1 * c_q3 + slopes_12 + p.l_2 * slopes_23;
    let slopes_49 = l_1_q1_ddot * half_m_2 + slopes_46 + slopes_48;
    let slopes_50 = slopes_49 * c_q2 + mc_link_3_y_slopes_21 * s_q2;
    let slopes_51 = p.l_1 * (slopes_2_plus_alpha_link_2_z * half_m_2 + slopes_23);
    let slopes_9_half_m_3 = slopes_9 * half_m_3;
    let slopes_52 = link_3_3 * by_l_3_1 + q3_ddot_minus_slopes_1 * by_l_3_1;
    let slopes_53 = slopes_6 * by_l_3_1 - link_3_1 * by_l_3_1;
    let slopes_54 = slopes_8 * half_m_3 + slopes_52;
    let slopes_55 = slopes_53 - a_link_3_1_x * half_m_3;
    let slopes_56 = link_3_2_half_m_3 * c_q3 + slopes_9_half_m_3 * s_q3;
    let slopes_57 = p.l_2 * (slopes_9_half_m_3 * c_q3 - link_3_2_half_m_3 * s_q3);
    let slopes_58 = c_q2 * (slopes_55 * c_q3 - p.l_2 * slopes_56);
    let slopes_59 = link_2_2 * (m_2_two_b_per_6 - m_2_two_b_per_12) + q2_ddot * m_2_two_b_per_12;
    let slopes_5_m_3_two_b_per_6 = slopes_5 * m_3_two_b_per_6;
    let slopes_60 = by_b_2 + q3_ddot_minus_slopes_1 * m_3_two_b_per_12;
    let slopes_61 = by_b_3 + slopes_6 * m_3_two_b_per_12;
    let slopes_62 = slopes_5_m_3_two_b_per_6 * c_q3 - slopes_61 * s_q3;
    let slopes_63 = slopes_5_m_3_two_b_per_6 * s_q3 + slopes_61 * c_q3;
    let slopes_64 = slopes_2 * m_2_two_b_per_12 + by_b_1 + slopes_63;
    let slopes_65 = s_q2 * (slopes_60 - slopes_1 * m_2_two_b_per_6);
    let slopes_66 = slopes_64 * c_q2 - slopes_65;
    // derivatives with respect to m_1
    let d_q1_ddot_by_m_1 = -inv_q1 * q1_ddot * (b_sq_plus_l_1_sq / 12.0 + l_1_per_two * l_1_per_two);
    let d_q2_ddot_by_m_1 = -l_q2_q1 * d_q1_ddot_by_m_1;
    let d_q3_ddot_by_m_1 = -l_q3_q2 * d_q2_ddot_by_m_1 - l_q3_q1 * d_q1_ddot_by_m_1;
    // derivatives with respect to m_2
    let d_q1_ddot_by_m_2 = -inv_q1 * (slopes_29 + slopes_15 + l_q2_q1 * slopes_27);
    let d_q2_ddot_by_m_2 = inv_q2 * slopes_27 - l_q2_q1 * d_q1_ddot_by_m_2;
    let d_q3_ddot_by_m_2 = -l_q3_q2 * d_q2_ddot_by_m_2 - l_q3_q1 * d_q1_ddot_by_m_2;
    // derivatives with respect to m_3
    let by_m_3_4 = slopes_19 - slopes_33 + l_q3_q2 * slopes_31;
    let d_q1_ddot_by_m_3 = -inv_q1 * (slopes_36 + l_q2_q1 * by_m_3_4 - l_q3_q1 * slopes_31);
    let d_q2_ddot_by_m_3 = inv_q2 * by_m_3_4 - l_q2_q1 * d_q1_ddot_by_m_3;
    let d_q3_ddot_by_m_3 = -l_q3_q2 * d_q2_ddot_by_m_3 - inv_q3 * slopes_31 - l_q3_q1 * d_q1_ddot_by_m_3;
    // derivatives with respect to l_1
    let by_l_1_1 = mc_link_3_y_q1_dot_sq_c_q2 * s_q3 + slopes_40 - mc_link_2_x * q1_dot_sq_s_q2;
    let by_l_1_2 = by_l_1_1 - l_q3_q2 * mc_link_3_y_slopes_37;
    let d_q1_ddot_by_l_1 = inv_q1 * (-l_q3_q1 * mc_link_3_y_slopes_37 - slopes_44 - l_q2_q1 * by_l_1_2);
    let d_q2_ddot_by_l_1 = inv_q2 * by_l_1_2 - l_q2_q1 * d_q1_ddot_by_l_1;
    let d_q3_ddot_by_l_1 = inv_q3 * mc_link_3_y_slopes_37 - l_q3_q1 * d_q1_ddot_by_l_1 - l_q3_q2 * d_q2_ddot_by_l_1;
    // derivatives with respect to l_2
    let by_l_2_2 = slopes_47 - slopes_45 + a_link_2_z * half_m_2;
    let by_l_2_3 = by_l_2_2 - l_q3_q2 * mc_link_3_y_slopes_21;
    let by_l_2_4 = slopes_50 + slopes_51 + l_q2_q1 * by_l_2_3;
    let d_q1_ddot_by_l_2 = inv_q1 * (-l_q3_q1 * mc_link_3_y_slopes_21 - by_l_2_4);
    let d_q2_ddot_by_l_2 = inv_q2 * by_l_2_3 - l_q2_q1 * d_q1_ddot_by_l_2;
    let d_q3_ddot_by_l_2 = inv_q3 * mc_link_3_y_slopes_21 - l_q3_q1 * d_q1_ddot_by_l_2 - l_q3_q2 * d_q2_ddot_by_l_2;
    // derivatives with respect to l_3
    let by_l_3_2 = p.l_1 * slopes_56 - slopes_58 + slopes_54 * s_q2;
    let by_l_3_3 = slopes_55 * s_q3 + slopes_57 + l_q3_q2 * slopes_54;
    let d_q1_ddot_by_l_3 = inv_q1 * (by_l_3_2 - l_q2_q1 * by_l_3_3 + l_q3_q1 * slopes_54);
    let d_q2_ddot_by_l_3 = inv_q2 * by_l_3_3 - l_q2_q1 * d_q1_ddot_by_l_3;
    let d_q3_ddot_by_l_3 = -l_q3_q1 * d_q1_ddot_by_l_3 - inv_q3 * slopes_54 - l_q3_q2 * d_q2_ddot_by_l_3;
    // derivatives with respect to b
    let by_b_4 = l_q3_q2 * slopes_60 - slopes_59 - slopes_62;
    let by_b_5 = p.m_1 * q1_ddot * two_b / 12.0 + slopes_66 + l_q2_q1 * by_b_4;
    let d_q1_ddot_by_b = -inv_q1 * (by_b_5 - l_q3_q1 * slopes_60);
    let d_q2_ddot_by_b = inv_q2 * by_b_4 - l_q2_q1 * d_q1_ddot_by_b;
    let d_q3_ddot_by_b = -l_q3_q2 * d_q2_ddot_by_b - inv_q3 * slopes_60 - l_q3_q1 * d_q1_ddot_by_b;
    // derivatives with respect to c_1
    let d_q1_ddot_by_c_1 = -inv_q1 * v.q1;
    let d_q2_ddot_by_c_1 = -l_q2_q1 * d_q1_ddot_by_c_1;
    let d_q3_ddot_by_c_1 = -l_q3_q2 * d_q2_ddot_by_c_1 - l_q3_q1 * d_q1_ddot_by_c_1;
    // derivatives with respect to c_2
    let d_q1_ddot_by_c_2 = inv_q1 * l_q2_q1 * v.q2;
    let d_q2_ddot_by_c_2 = -inv_q2 * v.q2 - l_q2_q1 * d_q1_ddot_by_c_2;
    let d_q3_ddot_by_c_2 = -l_q3_q1 * d_q1_ddot_by_c_2 - l_q3_q2 * d_q2_ddot_by_c_2;
    let l_q3_q2_q3_dot = l_q3_q2 * v.q3;
    // derivatives with respect to c_3
    let d_q1_ddot_by_c_3 = inv_q1 * (l_q3_q1 * v.q3 - l_q2_q1 * l_q3_q2_q3_dot);
    let d_q2_ddot_by_c_3 = inv_q2 * l_q3_q2_q3_dot - l_q2_q1 * d_q1_ddot_by_c_3;
    let d_q3_ddot_by_c_3 = -l_q3_q1 * d_q1_ddot_by_c_3 - inv_q3 * v.q3 - l_q3_q2 * d_q2_ddot_by_c_3;
    positive(I_link_3_xx, 2)?;
    positive(pivot_q2, 1)?;
    positive(pivot_q1, 0)?;
    Ok([
        [0.0; 11], // q1'
        [0.0; 11], // q2'
        [0.0; 11], // q3'
        // q1''
        Parameters {
            m_1: d_q1_ddot_by_m_1,
            m_2: d_q1_ddot_by_m_2,
            m_3: d_q1_ddot_by_m_3,
            l_1: d_q1_ddot_by_l_1,
            l_2: d_q1_ddot_by_l_2,
            l_3: d_q1_ddot_by_l_3,
            b: d_q1_ddot_by_b,
            c_1: d_q1_ddot_by_c_1,
            c_2: d_q1_ddot_by_c_2,
            c_3: d_q1_ddot_by_c_3,
            g: d_q1_ddot_by_g,
        }
        .to_array(),
        // q2''
        Parameters {
            m_1: d_q2_ddot_by_m_1,
            m_2: d_q2_ddot_by_m_2,
            m_3: d_q2_ddot_by_m_3,
            l_1: d_q2_ddot_by_l_1,
            l_2: d_q2_ddot_by_l_2,
            l_3: d_q2_ddot_by_l_3,
            b: d_q2_ddot_by_b,
            c_1: d_q2_ddot_by_c_1,
            c_2: d_q2_ddot_by_c_2,
            c_3: d_q2_ddot_by_c_3,
            g: d_q2_ddot_by_g,
        }
        .to_array(),
        // q3''
        Parameters {
            m_1: d_q3_ddot_by_m_1,
            m_2: d_q3_ddot_by_m_2,
            m_3: d_q3_ddot_by_m_3,
            l_1: d_q3_ddot_by_l_1,
            l_2: d_q3_ddot_by_l_2,
            l_3: d_q3_ddot_by_l_3,
            b: d_q3_ddot_by_b,
            c_1: d_q3_ddot_by_c_1,
            c_2: d_q3_ddot_by_c_2,
            c_3: d_q3_ddot_by_c_3,
            g: d_q3_ddot_by_g,
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 3 x 6.
    pub by_x: [[f64; 6]; 3],
    /// dy/dp, 3 x 11.
    pub by_p: [[f64; 11]; 3],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [
            [1.0, 0.0, 0.0, 0.0, 0.0, 0.0], // q1
            [0.0, 1.0, 0.0, 0.0, 0.0, 0.0], // q2
            [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], // q3
        ],
        by_p: [
            [0.0; 11], // q1
            [0.0; 11], // q2
            [0.0; 11], // q3
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 6] = ["q1", "q2", "q3", "q1.dot", "q2.dot", "q3.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 3] = ["tau_1", "tau_2", "tau_3"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 11] = ["m_1", "m_2", "m_3", "l_1", "l_2", "l_3", "b", "c_1", "c_2", "c_3", "g"];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 11] = ["kg", "kg", "kg", "m", "m", "m", "m", "N*m*s", "N*m*s", "N*m*s", "m/s^2"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 3] = ["q1", "q2", "q3"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 3] = ["rad", "rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Chain3;

impl Names for Chain3 {
    fn rig(&self) -> &str {
        "Chain3"
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

impl Model for Chain3 {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 3, lags: 0, inputs: 3, exogenous: 0, parameters: 11, outputs: 3 }
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
            0 => InputPath { limits: (-5.0, 5.0), delay: 0.0 },
            1 => InputPath { limits: (-5.0, 5.0), delay: 0.0 },
            2 => InputPath { limits: (-5.0, 5.0), delay: 0.0 },
            _ => InputPath { limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0 },
        }
    }

    fn output_path(&self, i: usize, _p: &[f64]) -> OutputPath {
        match i {
            0 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            1 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            2 => OutputPath { quantum: 0.0, wrapped: false, delay: 0.0, play: 0.0 },
            _ => OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false },
        }
    }
}
