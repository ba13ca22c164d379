//! Double pendulum with quasi-direct drives and a belt to the elbow.
//! Generated from `double_pendulum.rig` (model b0557872); edit the rig, not this file.
//!
//! Both motors sit at the shoulder end; the second one drives the elbow through a belt, so that its rotor
//! turns by q1 - n q2. Both rotors turn n times as fast as their joints. Identified numbers of design A.0,
//! model 2.0, of the DFKI underactuated lab (github.com/dfki-ric-underactuated-lab/double_pendulum,
//! BSD-3-Clause): inertias about the joints, rotor inertia, friction. The published friction law is
//! b v + c_f atan(100 v); here the same level, c_f pi/2, and the same slope at rest in one regularized
//! Coulomb law. q1 = 0 hangs; q2 relative to the upper link.
//!
//! 83 operations forward, 182 with A and B.
//! Derived twice, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::{cos, sin_cos, tanh};
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular, positive};

/// Parameters p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// upper link [kg]
    pub m_1: f64,
    /// lower link [kg]
    pub m_2: f64,
    /// shoulder to the upper link's centre [m]
    pub r_1: f64,
    /// elbow to the lower link's centre [m]
    pub r_2: f64,
    /// shoulder to elbow [m]
    pub l_1: f64,
    /// upper link about the shoulder [kg*m^2]
    pub I_1: f64,
    /// lower link about the elbow [kg*m^2]
    pub I_2: f64,
    /// rotor of either motor [kg*m^2]
    pub I_r: f64,
    /// gear ratio [1]
    pub n: f64,
    /// viscous friction, shoulder [N*m*s]
    pub b_1: f64,
    /// viscous friction, elbow [N*m*s]
    pub b_2: f64,
    /// dry friction, shoulder (level / (pi/2)) [N*m]
    pub c_f1: f64,
    /// dry friction, elbow (level / (pi/2)) [N*m]
    pub c_f2: f64,
    /// width of the dry friction's turn: pi/2 / 100 [rad/s]
    pub v_c: f64,
    /// g [m/s^2]
    pub g: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m_1: 0.5593806151425046,
        m_2: 0.6043459469186889,
        r_1: 0.3,
        r_2: 0.18377686083653508,
        l_1: 0.3,
        I_1: 0.053470810264216295,
        I_2: 0.02392374528789766,
        I_r: 7.659297952841183e-5,
        n: 6.0,
        b_1: 0.001,
        b_2: 0.001,
        c_f1: 0.093,
        c_f2: 0.078,
        v_c: 0.015707963267948967,
        g: 9.81,
    };

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 15]) -> Self {
        let [m_1, m_2, r_1, r_2, l_1, I_1, I_2, I_r, n, b_1, b_2, c_f1, c_f2, v_c, g] = values;
        Self { m_1, m_2, r_1, r_2, l_1, I_1, I_2, I_r, n, b_1, b_2, c_f1, c_f2, v_c, g }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 15] {
        [
            self.m_1, self.m_2, self.r_1, self.r_2, self.l_1, self.I_1, self.I_2, self.I_r, self.n, self.b_1, self.b_2, self.c_f1,
            self.c_f2, self.v_c, self.g,
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
    /// shoulder, 0 hanging [rad]
    pub q1: f64,
    /// elbow, relative [rad]
    pub q2: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [q1, q2] = values;
        Self { q1, q2 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.q1, self.q2]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// shoulder, 0 hanging [rad/s]
    pub q1: f64,
    /// elbow, relative [rad/s]
    pub q2: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [q1, q2] = values;
        Self { q1, q2 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.q1, self.q2]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// shoulder, 0 hanging [rad/s^2]
    pub q1: f64,
    /// elbow, relative [rad/s^2]
    pub q2: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [q1, q2] = values;
        Self { q1, q2 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.q1, self.q2]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// at the shoulder [N*m]
    pub tau_1: f64,
    /// at the elbow, through the belt [N*m]
    pub tau_2: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [tau_1, tau_2] = values;
        Self { tau_1, tau_2 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.tau_1, self.tau_2]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// q1 [rad]
    pub q1: f64,
    /// q2 [rad]
    pub q2: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [q1, q2] = values;
        Self { q1, q2 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.q1, self.q2]
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

/// Mass matrix M(q), 2 x 2, symmetric; rows (q1, q2).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 2]; 2] {
    let c_q2 = cos(q.q2);
    let m_2_r_2_c_q2 = p.m_2 * p.r_2 * c_q2;
    let I_2_plus_l_1_m_2_r_2_c_q2 = p.I_2 + p.l_1 * m_2_r_2_c_q2;
    // frame upper on ground
    let upper_1 = p.I_1 + p.I_2 + p.l_1 * (m_2_r_2_c_q2 + m_2_r_2_c_q2 + p.m_2 * p.l_1);
    let half_I_r = 0.5 * p.I_r;
    let two_n = 2.0 * p.n;
    let two_n_2 = 2.0 * p.n;
    // kinetic energy rotor_2
    let M_q1_q1 = upper_1 + p.I_r + p.n * half_I_r * two_n;
    let M_q2_q2 = p.I_2 + p.n * half_I_r * two_n_2;
    [
        [M_q1_q1, I_2_plus_l_1_m_2_r_2_c_q2 - half_I_r * two_n_2], // q1
        [I_2_plus_l_1_m_2_r_2_c_q2 - half_I_r * two_n, M_q2_q2], // q2
    ]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (q1, q2).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_q1, c_q1) = sin_cos(q.q1);
    let (s_q2, c_q2) = sin_cos(q.q2);
    // body lower_link on lower
    let mc_lower_z = -p.m_2 * p.r_2;
    // frame lower on upper
    let omega_lower_y = -v.q1 - v.q2;
    // frame upper on ground
    let a_upper_x = p.g * s_q1;
    // frame lower on upper
    let a_lower_1_z = p.l_1 * v.q1 * v.q1 + p.g * c_q1;
    let a_lower_z = a_lower_1_z * c_q2 - a_upper_x * s_q2;
    let a_lower_x = a_upper_x * c_q2 + a_lower_1_z * s_q2;
    let f_lower_z = p.m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = p.m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    // frame upper on ground
    let n_upper_y = n_lower_y - p.m_1 * p.r_1 * a_upper_x - p.l_1 * f_lower_1_x;
    [-n_upper_y, -n_lower_y]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (q1, q2).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_q2, c_q2) = sin_cos(q.q2);
    // body lower_link on lower
    let mc_lower_z = -p.m_2 * p.r_2;
    // frame lower on upper
    let omega_lower_y = -v.q1 - v.q2;
    let a_lower_1_z = p.l_1 * v.q1 * v.q1;
    let a_lower_x = a_lower_1_z * s_q2;
    let f_moving_lower_z = p.m_2 * a_lower_1_z * c_q2 - mc_lower_z * omega_lower_y * omega_lower_y;
    let n_moving_lower_y = mc_lower_z * a_lower_x;
    let f_moving_lower_1_x = p.m_2 * a_lower_x * c_q2 - f_moving_lower_z * s_q2;
    [p.l_1 * f_moving_lower_1_x - n_moving_lower_y, -n_moving_lower_y]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (q1, q2).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 2] {
    let (s_q1, c_q1) = sin_cos(q.q1);
    let (s_q2, c_q2) = sin_cos(q.q2);
    let r_2_c_q2 = p.r_2 * c_q2;
    let r_2_c_q1_s_q2 = p.r_2 * c_q1 * s_q2;
    let gravity_1 = p.m_2 * p.g * (s_q1 * (p.l_1 + r_2_c_q2) + r_2_c_q1_s_q2);
    let g_q1 = p.m_1 * p.r_1 * p.g * s_q1 + gravity_1;
    let g_q2 = p.m_2 * p.g * (r_2_c_q1_s_q2 + r_2_c_q2 * s_q1);
    [g_q1, g_q2]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (q1, q2).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    // friction of q1
    let d_q1 = p.b_1 * v.q1 + 1.5707963267948966 * p.c_f1 * tanh(v.q1 / p.v_c);
    // friction of q2
    let d_q2 = p.b_2 * v.q2 + 1.5707963267948966 * p.c_f2 * tanh(v.q2 / p.v_c);
    [d_q1, d_q2]
}

/// Generalized force Q [N m] of the inputs; rows (q1, q2).
#[must_use]
pub fn generalized_force(_q: &Coordinates, u: &Inputs, _p: &Parameters) -> [f64; 2] {
    [u.tau_1, u.tau_2]
}

/// Input map dQ/du, 2 x 2; rows (q1, q2), columns (tau_1, tau_2).
#[must_use]
pub fn input_map(_q: &Coordinates, _p: &Parameters) -> [[f64; 2]; 2] {
    [[1.0, 0.0], [0.0, 1.0]]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_q2, c_q2) = sin_cos(q.q2);
    // frame lower on upper
    let omega_lower_y = -v.q1 - v.q2;
    let half_I_r = 0.5 * p.I_r;
    let n_q1_dot = p.n * v.q1;
    let q1_dot_minus_n_q2_dot = v.q1 - p.n * v.q2;
    // kinetic energy rotor_2
    let rotor_2_1 = half_I_r * q1_dot_minus_n_q2_dot * q1_dot_minus_n_q2_dot;
    let rotor_2_2 = half_I_r * n_q1_dot * n_q1_dot + rotor_2_1;
    let l_1_q1_dot = p.l_1 * v.q1;
    let l_1_q1_dot_s_q2 = l_1_q1_dot * s_q2;
    let r_1_q1_dot = p.r_1 * v.q1;
    // body upper_link on upper
    let upper_link_1 = 0.5 * (p.m_1 * r_1_q1_dot * r_1_q1_dot + v.q1 * v.q1 * (p.I_1 - p.m_1 * p.r_1 * p.r_1));
    // body lower_link on lower
    let lower_link_1 = l_1_q1_dot * c_q2 - p.r_2 * omega_lower_y;
    let lower_link_2 = p.m_2 * (lower_link_1 * lower_link_1 + l_1_q1_dot_s_q2 * l_1_q1_dot_s_q2);
    let lower_link_3 = 0.5 * (lower_link_2 + omega_lower_y * omega_lower_y * (p.I_2 - p.m_2 * p.r_2 * p.r_2));
    rotor_2_2 + upper_link_1 + lower_link_3
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let (s_q1, c_q1) = sin_cos(q.q1);
    let (s_q2, c_q2) = sin_cos(q.q2);
    let l_1_plus_r_2_c_q2_c_q1 = c_q1 * (p.l_1 + p.r_2 * c_q2);
    // body lower_link on lower
    let lower_link_1 = p.m_2 * p.g * (p.r_2 * s_q1 * s_q2 - l_1_plus_r_2_c_q2_c_q1);
    lower_link_1 - p.m_1 * p.r_1 * p.g * c_q1
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 2] {
    let State { q, v } = x;
    let (s_q1, c_q1) = sin_cos(q.q1);
    let (s_q2, c_q2) = sin_cos(q.q2);
    // friction of q1
    let d_q1 = p.b_1 * v.q1 + 1.5707963267948966 * p.c_f1 * tanh(v.q1 / p.v_c);
    // friction of q2
    let d_q2 = p.b_2 * v.q2 + 1.5707963267948966 * p.c_f2 * tanh(v.q2 / p.v_c);
    // body lower_link on lower
    let mc_lower_z = -p.m_2 * p.r_2;
    // frame lower on upper
    let omega_lower_y = -v.q1 - v.q2;
    // frame upper on ground
    let a_upper_x = p.g * s_q1;
    // frame lower on upper
    let a_lower_1_z = p.l_1 * v.q1 * v.q1 + p.g * c_q1;
    let a_lower_1_x = a_upper_x + p.l_1 * a.q1;
    let half_I_r = 0.5 * p.I_r;
    let two_n = 2.0 * p.n;
    let two_n_2 = 2.0 * p.n;
    // gravity
    let alpha_lower_y = -a.q1 - a.q2;
    // frame lower on upper
    let a_lower_z = a_lower_1_z * c_q2 - a_lower_1_x * s_q2;
    let a_lower_x = a_lower_1_z * s_q2 + a_lower_1_x * c_q2;
    let f_net_lower_x = p.m_2 * a_lower_x + mc_lower_z * alpha_lower_y;
    let f_net_lower_z = p.m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    let n_net_lower_y = p.I_2 * alpha_lower_y + mc_lower_z * a_lower_x;
    let f_net_lower_1_x = f_net_lower_x * c_q2 - f_net_lower_z * s_q2;
    // frame upper on ground
    let n_net_upper_y = n_net_lower_y - p.m_1 * p.r_1 * a_upper_x - p.I_1 * a.q1 - p.l_1 * f_net_lower_1_x;
    let upper_1 = a.q1 * (p.I_r + p.n * half_I_r * two_n) - n_net_upper_y - u.tau_1;
    let upper_2 = n_net_lower_y + u.tau_2 + half_I_r * two_n * a.q1;
    [d_q1 + upper_1 - half_I_r * two_n_2 * a.q2, d_q2 - upper_2 + p.n * half_I_r * two_n_2 * a.q2]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.q1, q.q2])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 2] {
    let State { q, .. } = x;
    let c_q2 = cos(q.q2);
    let m_2_r_2_c_q2 = p.m_2 * p.r_2 * c_q2;
    let I_2_plus_l_1_m_2_r_2_c_q2 = p.I_2 + p.l_1 * m_2_r_2_c_q2;
    // frame upper on ground
    let upper_1 = p.I_1 + p.I_2 + p.l_1 * (m_2_r_2_c_q2 + m_2_r_2_c_q2 + p.m_2 * p.l_1);
    let half_I_r = 0.5 * p.I_r;
    let two_n = 2.0 * p.n;
    let two_n_2 = 2.0 * p.n;
    // kinetic energy rotor_2
    let M_q1_q1 = upper_1 + p.I_r + p.n * half_I_r * two_n;
    let M_q2_q2 = p.I_2 + p.n * half_I_r * two_n_2;
    // M = L^T D L and back-substitution
    let u_q1_q2 = (I_2_plus_l_1_m_2_r_2_c_q2 - half_I_r * two_n_2) / M_q2_q2;
    let pivot_q1 = M_q1_q1 - u_q1_q2 * (I_2_plus_l_1_m_2_r_2_c_q2 - half_I_r * two_n);
    [pivot_q1, M_q2_q2]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 83 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_q1, c_q1) = sin_cos(q.q1);
    let (s_q2, c_q2) = sin_cos(q.q2);
    // friction of q1
    let d_q1 = p.b_1 * v.q1 + 1.5707963267948966 * p.c_f1 * tanh(v.q1 / p.v_c);
    // friction of q2
    let d_q2 = p.b_2 * v.q2 + 1.5707963267948966 * p.c_f2 * tanh(v.q2 / p.v_c);
    // body lower_link on lower
    let mc_lower_z = -p.m_2 * p.r_2;
    // frame lower on upper
    let omega_lower_y = -v.q1 - v.q2;
    let mc_lower_z_c_q2 = mc_lower_z * c_q2;
    let lower_1 = p.I_2 - p.l_1 * mc_lower_z_c_q2;
    // frame upper on ground
    let a_upper_x = p.g * s_q1;
    let upper_1 = p.I_1 + p.I_2 + p.l_1 * (p.m_2 * p.l_1 - mc_lower_z_c_q2 - mc_lower_z_c_q2);
    // frame lower on upper
    let a_lower_1_z = p.l_1 * v.q1 * v.q1 + p.g * c_q1;
    let a_lower_z = a_lower_1_z * c_q2 - a_upper_x * s_q2;
    let a_lower_x = a_upper_x * c_q2 + a_lower_1_z * s_q2;
    let f_lower_z = p.m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = p.m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    // frame upper on ground
    let n_upper_y = n_lower_y - p.m_1 * p.r_1 * a_upper_x - p.l_1 * f_lower_1_x;
    let half_I_r = 0.5 * p.I_r;
    let two_n = 2.0 * p.n;
    let two_n_2 = 2.0 * p.n;
    // kinetic energy rotor_2
    let M_q1_q1 = upper_1 + p.I_r + p.n * half_I_r * two_n;
    let lower_1_minus_half_I_r_two_n = lower_1 - half_I_r * two_n;
    let M_q2_q2 = p.I_2 + p.n * half_I_r * two_n_2;
    // balance of forces
    let tau_q2 = n_lower_y - d_q2 + u.tau_2;
    // M = L^T D L and back-substitution
    let inv_q2 = 1.0 / M_q2_q2;
    let u_q1_q2 = inv_q2 * (lower_1 - half_I_r * two_n_2);
    let pivot_q1 = M_q1_q1 - lower_1_minus_half_I_r_two_n * u_q1_q2;
    let q1_ddot = (n_upper_y - tau_q2 * u_q1_q2 - d_q1 + u.tau_1) / pivot_q1;
    let q2_ddot = tau_q2 * inv_q2 - lower_1_minus_half_I_r_two_n * inv_q2 * q1_ddot;
    positive(M_q2_q2, 1)?;
    positive(pivot_q1, 0)?;
    Ok(Accelerations::from_array([q1_ddot, q2_ddot]))
}

/// x' and its Jacobians at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// x'.
    pub dx: [f64; 4],
    /// A = dx'/dx, 4 x 4.
    pub a: [[f64; 4]; 4],
    /// B = dx'/du, 4 x 2.
    pub b: [[f64; 2]; 4],
}

/// State derivative and its Jacobians A, B, exact, at any state.
/// 182 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///       q1 q2 q1.dot q2.dot | tau_1 tau_2
/// q1'   .  .  1      .      | .     .
/// q2'   .  .  .      1      | .     .
/// q1''  *  *  *      *      | *     *
/// q2''  *  *  *      *      | *     *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_q1, c_q1) = sin_cos(q.q1);
    let (s_q2, c_q2) = sin_cos(q.q2);
    // friction of q1
    let friction_q1_1 = 1.5707963267948966 * p.c_f1;
    let tanh_q1_dot_per_v_c = tanh(v.q1 / p.v_c);
    let d_q1 = p.b_1 * v.q1 + friction_q1_1 * tanh_q1_dot_per_v_c;
    // friction of q2
    let friction_q2_1 = 1.5707963267948966 * p.c_f2;
    let tanh_q2_dot_per_v_c = tanh(v.q2 / p.v_c);
    let d_q2 = p.b_2 * v.q2 + friction_q2_1 * tanh_q2_dot_per_v_c;
    // body upper_link on upper
    let mc_upper_z = -p.m_1 * p.r_1;
    // body lower_link on lower
    let mc_lower_z = -p.m_2 * p.r_2;
    // frame lower on upper
    let omega_lower_y = -v.q1 - v.q2;
    let mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y * omega_lower_y;
    let mc_lower_z_c_q2 = mc_lower_z * c_q2;
    let lower_1 = p.I_2 - p.l_1 * mc_lower_z_c_q2;
    // frame upper on ground
    let a_upper_z = p.g * c_q1;
    let a_upper_x = p.g * s_q1;
    let upper_1 = p.I_1 + p.I_2 + p.l_1 * (p.m_2 * p.l_1 - mc_lower_z_c_q2 - mc_lower_z_c_q2);
    let a_upper_x_s_q2 = a_upper_x * s_q2;
    let a_upper_x_c_q2 = a_upper_x * c_q2;
    // frame lower on upper
    let a_lower_z = a_upper_z * c_q2 - a_upper_x_s_q2;
    let f_weight_lower_x = p.m_2 * (a_upper_z * s_q2 + a_upper_x_c_q2);
    let f_weight_lower_1_z = p.m_2 * a_lower_z * c_q2 + f_weight_lower_x * s_q2;
    let a_lower_1_z = p.l_1 * v.q1 * v.q1 + a_upper_z;
    let a_lower_1_z_c_q2 = a_lower_1_z * c_q2;
    let a_lower_1_z_s_q2 = a_lower_1_z * s_q2;
    let a_lower_x = a_upper_x_c_q2 + a_lower_1_z_s_q2;
    let f_lower_z = p.m_2 * (a_lower_1_z_c_q2 - a_upper_x_s_q2) - mc_lower_z_omega_lower_y_sq;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = p.m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    // frame upper on ground
    let n_upper_y = mc_upper_z * a_upper_x + n_lower_y - p.l_1 * f_lower_1_x;
    let half_I_r = 0.5 * p.I_r;
    let two_n = 2.0 * p.n;
    let two_n_2 = 2.0 * p.n;
    // kinetic energy rotor_2
    let M_q1_q1 = upper_1 + p.I_r + p.n * half_I_r * two_n;
    let lower_1_minus_half_I_r_two_n = lower_1 - half_I_r * two_n;
    let M_q2_q2 = p.I_2 + p.n * half_I_r * two_n_2;
    // balance of forces
    let tau_q2 = n_lower_y - d_q2 + u.tau_2;
    // M = L^T D L and back-substitution
    let inv_q2 = 1.0 / M_q2_q2;
    let l_q2_q1 = lower_1_minus_half_I_r_two_n * inv_q2;
    let u_q1_q2 = inv_q2 * (lower_1 - half_I_r * two_n_2);
    let pivot_q1 = M_q1_q1 - lower_1_minus_half_I_r_two_n * u_q1_q2;
    let inv_q1 = 1.0 / pivot_q1;
    let q1_ddot = inv_q1 * (n_upper_y - tau_q2 * u_q1_q2 - d_q1 + u.tau_1);
    let q2_ddot = tau_q2 * inv_q2 - l_q2_q1 * q1_ddot;
    let mc_lower_z_a_lower_z = mc_lower_z * a_lower_z;
    // derivatives with respect to q1
    let by_q1_1 = mc_upper_z * a_upper_z - u_q1_q2 * mc_lower_z_a_lower_z + mc_lower_z_a_lower_z - p.l_1 * f_weight_lower_1_z;
    let d_q1_ddot_by_q1 = inv_q1 * by_q1_1;
    let d_q2_ddot_by_q1 = inv_q2 * mc_lower_z_a_lower_z - l_q2_q1 * d_q1_ddot_by_q1;
    let inv_v_c = 1.0 / p.v_c;
    // derivatives with respect to q1_dot
    let by_q1_dot_1 = p.b_1 + friction_q1_1 * inv_v_c * (1.0 - tanh_q1_dot_per_v_c * tanh_q1_dot_per_v_c);
    let two_l_1_q1_dot = 2.0 * p.l_1 * v.q1;
    let two_mc_lower_z_omega_lower_y = 2.0 * mc_lower_z * omega_lower_y;
    let two_l_1_q1_dot_s_q2 = two_l_1_q1_dot * s_q2;
    let by_q1_dot_2 = mc_lower_z * two_l_1_q1_dot_s_q2;
    let by_q1_dot_3 = s_q2 * (two_mc_lower_z_omega_lower_y + p.m_2 * two_l_1_q1_dot * c_q2);
    let by_q1_dot_4 = p.l_1 * (p.m_2 * two_l_1_q1_dot_s_q2 * c_q2 - by_q1_dot_3);
    let by_q1_dot_5 = by_q1_dot_2 - u_q1_q2 * by_q1_dot_2 - by_q1_dot_1 - by_q1_dot_4;
    let d_q1_ddot_by_q1_dot = inv_q1 * by_q1_dot_5;
    let d_q2_ddot_by_q1_dot = inv_q2 * by_q1_dot_2 - l_q2_q1 * d_q1_ddot_by_q1_dot;
    // derivatives with respect to q2_dot
    let by_q2_dot_1 = p.b_2 + friction_q2_1 * inv_v_c * (1.0 - tanh_q2_dot_per_v_c * tanh_q2_dot_per_v_c);
    let d_q1_ddot_by_q2_dot = inv_q1 * (p.l_1 * two_mc_lower_z_omega_lower_y * s_q2 + u_q1_q2 * by_q2_dot_1);
    let d_q2_ddot_by_q2_dot = -inv_q2 * by_q2_dot_1 - l_q2_q1 * d_q1_ddot_by_q2_dot;
    let a_upper_x_plus_l_1_q1_ddot = a_upper_x + p.l_1 * q1_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = a_lower_1_z_c_q2 - a_upper_x_plus_l_1_q1_ddot * s_q2;
    let slopes_2 = p.m_2 * (a_lower_1_z_s_q2 + a_upper_x_plus_l_1_q1_ddot * c_q2);
    let m_2_slopes_1 = p.m_2 * slopes_1;
    let slopes_3 = c_q2 * (m_2_slopes_1 - mc_lower_z_omega_lower_y_sq);
    let slopes_4 = s_q2 * (slopes_2 - mc_lower_z * (q1_ddot + q2_ddot));
    let mc_lower_z_slopes_1 = mc_lower_z * slopes_1;
    let slopes_3_minus_slopes_2_s_q2 = slopes_3 - slopes_2 * s_q2;
    let slopes_5 = p.l_1 * (m_2_slopes_1 * c_q2 - slopes_4 - slopes_3_minus_slopes_2_s_q2);
    // derivatives with respect to q2
    let d_q1_ddot_by_q2 = inv_q1 * (mc_lower_z_slopes_1 - u_q1_q2 * mc_lower_z_slopes_1 - slopes_5);
    let d_q2_ddot_by_q2 = inv_q2 * mc_lower_z_slopes_1 - l_q2_q1 * d_q1_ddot_by_q2;
    // derivatives with respect to tau_2
    let d_q1_ddot_by_tau_2 = -u_q1_q2 * inv_q1;
    positive(M_q2_q2, 1)?;
    positive(pivot_q1, 0)?;
    Ok(Linearization {
        dx: [v.q1, v.q2, q1_ddot, q2_ddot],
        a: [
            [0.0, 0.0, 1.0, 0.0], // q1'
            [0.0, 0.0, 0.0, 1.0], // q2'
            [d_q1_ddot_by_q1, d_q1_ddot_by_q2, d_q1_ddot_by_q1_dot, d_q1_ddot_by_q2_dot], // q1''
            [d_q2_ddot_by_q1, d_q2_ddot_by_q2, d_q2_ddot_by_q1_dot, d_q2_ddot_by_q2_dot], // q2''
        ],
        b: [
            [0.0, 0.0], // q1'
            [0.0, 0.0], // q2'
            [inv_q1, d_q1_ddot_by_tau_2], // q1''
            [-l_q2_q1 * inv_q1, inv_q2 - l_q2_q1 * d_q1_ddot_by_tau_2], // q2''
        ],
    })
}

/// As [`linearize`], without the slope of regularized Coulomb friction (at rest an artefact of its width).
/// 182 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///       q1 q2 q1.dot q2.dot | tau_1 tau_2
/// q1'   .  .  1      .      | .     .
/// q2'   .  .  .      1      | .     .
/// q1''  *  *  *      *      | *     *
/// q2''  *  *  *      *      | *     *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize_without_friction_slope(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_q1, c_q1) = sin_cos(q.q1);
    let (s_q2, c_q2) = sin_cos(q.q2);
    // friction of q1
    let d_q1 = p.b_1 * v.q1 + 1.5707963267948966 * p.c_f1 * tanh(v.q1 / p.v_c);
    // friction of q2
    let d_q2 = p.b_2 * v.q2 + 1.5707963267948966 * p.c_f2 * tanh(v.q2 / p.v_c);
    // body upper_link on upper
    let mc_upper_z = -p.m_1 * p.r_1;
    // body lower_link on lower
    let mc_lower_z = -p.m_2 * p.r_2;
    // frame lower on upper
    let omega_lower_y = -v.q1 - v.q2;
    let mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y * omega_lower_y;
    let mc_lower_z_c_q2 = mc_lower_z * c_q2;
    let lower_1 = p.I_2 - p.l_1 * mc_lower_z_c_q2;
    // frame upper on ground
    let a_upper_z = p.g * c_q1;
    let a_upper_x = p.g * s_q1;
    let upper_1 = p.I_1 + p.I_2 + p.l_1 * (p.m_2 * p.l_1 - mc_lower_z_c_q2 - mc_lower_z_c_q2);
    let a_upper_x_s_q2 = a_upper_x * s_q2;
    let a_upper_x_c_q2 = a_upper_x * c_q2;
    // frame lower on upper
    let a_lower_z = a_upper_z * c_q2 - a_upper_x_s_q2;
    let f_weight_lower_x = p.m_2 * (a_upper_z * s_q2 + a_upper_x_c_q2);
    let f_weight_lower_1_z = p.m_2 * a_lower_z * c_q2 + f_weight_lower_x * s_q2;
    let a_lower_1_z = p.l_1 * v.q1 * v.q1 + a_upper_z;
    let a_lower_1_z_c_q2 = a_lower_1_z * c_q2;
    let a_lower_1_z_s_q2 = a_lower_1_z * s_q2;
    let a_lower_x = a_upper_x_c_q2 + a_lower_1_z_s_q2;
    let f_lower_z = p.m_2 * (a_lower_1_z_c_q2 - a_upper_x_s_q2) - mc_lower_z_omega_lower_y_sq;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = p.m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    // frame upper on ground
    let n_upper_y = mc_upper_z * a_upper_x + n_lower_y - p.l_1 * f_lower_1_x;
    let half_I_r = 0.5 * p.I_r;
    let two_n = 2.0 * p.n;
    let two_n_2 = 2.0 * p.n;
    // kinetic energy rotor_2
    let M_q1_q1 = upper_1 + p.I_r + p.n * half_I_r * two_n;
    let lower_1_minus_half_I_r_two_n = lower_1 - half_I_r * two_n;
    let M_q2_q2 = p.I_2 + p.n * half_I_r * two_n_2;
    // balance of forces
    let tau_q2 = n_lower_y - d_q2 + u.tau_2;
    // M = L^T D L and back-substitution
    let inv_q2 = 1.0 / M_q2_q2;
    let l_q2_q1 = lower_1_minus_half_I_r_two_n * inv_q2;
    let u_q1_q2 = inv_q2 * (lower_1 - half_I_r * two_n_2);
    let pivot_q1 = M_q1_q1 - lower_1_minus_half_I_r_two_n * u_q1_q2;
    let inv_q1 = 1.0 / pivot_q1;
    let q1_ddot = inv_q1 * (n_upper_y - tau_q2 * u_q1_q2 - d_q1 + u.tau_1);
    let q2_ddot = tau_q2 * inv_q2 - l_q2_q1 * q1_ddot;
    let mc_lower_z_a_lower_z = mc_lower_z * a_lower_z;
    // derivatives with respect to q1
    let by_q1_1 = mc_upper_z * a_upper_z - u_q1_q2 * mc_lower_z_a_lower_z + mc_lower_z_a_lower_z - p.l_1 * f_weight_lower_1_z;
    let d_q1_ddot_by_q1 = inv_q1 * by_q1_1;
    let d_q2_ddot_by_q1 = inv_q2 * mc_lower_z_a_lower_z - l_q2_q1 * d_q1_ddot_by_q1;
    let two_l_1_q1_dot = 2.0 * p.l_1 * v.q1;
    let two_mc_lower_z_omega_lower_y = 2.0 * mc_lower_z * omega_lower_y;
    let two_l_1_q1_dot_s_q2 = two_l_1_q1_dot * s_q2;
    // derivatives with respect to q1_dot
    let by_q1_dot_1 = mc_lower_z * two_l_1_q1_dot_s_q2;
    let by_q1_dot_2 = s_q2 * (two_mc_lower_z_omega_lower_y + p.m_2 * two_l_1_q1_dot * c_q2);
    let by_q1_dot_3 = p.l_1 * (p.m_2 * two_l_1_q1_dot_s_q2 * c_q2 - by_q1_dot_2);
    let d_q1_ddot_by_q1_dot = inv_q1 * (by_q1_dot_1 - u_q1_q2 * by_q1_dot_1 - p.b_1 - by_q1_dot_3);
    let d_q2_ddot_by_q1_dot = inv_q2 * by_q1_dot_1 - l_q2_q1 * d_q1_ddot_by_q1_dot;
    let a_upper_x_plus_l_1_q1_ddot = a_upper_x + p.l_1 * q1_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = a_lower_1_z_c_q2 - a_upper_x_plus_l_1_q1_ddot * s_q2;
    let slopes_2 = p.m_2 * (a_lower_1_z_s_q2 + a_upper_x_plus_l_1_q1_ddot * c_q2);
    let m_2_slopes_1 = p.m_2 * slopes_1;
    let slopes_3 = c_q2 * (m_2_slopes_1 - mc_lower_z_omega_lower_y_sq);
    let slopes_4 = s_q2 * (slopes_2 - mc_lower_z * (q1_ddot + q2_ddot));
    let mc_lower_z_slopes_1 = mc_lower_z * slopes_1;
    let slopes_3_minus_slopes_2_s_q2 = slopes_3 - slopes_2 * s_q2;
    let slopes_5 = p.l_1 * (m_2_slopes_1 * c_q2 - slopes_4 - slopes_3_minus_slopes_2_s_q2);
    // derivatives with respect to q2
    let d_q1_ddot_by_q2 = inv_q1 * (mc_lower_z_slopes_1 - u_q1_q2 * mc_lower_z_slopes_1 - slopes_5);
    let d_q2_ddot_by_q2 = inv_q2 * mc_lower_z_slopes_1 - l_q2_q1 * d_q1_ddot_by_q2;
    // derivatives with respect to tau_2
    let d_q1_ddot_by_tau_2 = -u_q1_q2 * inv_q1;
    // derivatives with respect to q2_dot
    let d_q1_ddot_by_q2_dot = inv_q1 * (p.l_1 * two_mc_lower_z_omega_lower_y * s_q2 + p.b_2 * u_q1_q2);
    let d_q2_ddot_by_q2_dot = -p.b_2 * inv_q2 - l_q2_q1 * d_q1_ddot_by_q2_dot;
    positive(M_q2_q2, 1)?;
    positive(pivot_q1, 0)?;
    Ok(Linearization {
        dx: [v.q1, v.q2, q1_ddot, q2_ddot],
        a: [
            [0.0, 0.0, 1.0, 0.0], // q1'
            [0.0, 0.0, 0.0, 1.0], // q2'
            [d_q1_ddot_by_q1, d_q1_ddot_by_q2, d_q1_ddot_by_q1_dot, d_q1_ddot_by_q2_dot], // q1''
            [d_q2_ddot_by_q1, d_q2_ddot_by_q2, d_q2_ddot_by_q1_dot, d_q2_ddot_by_q2_dot], // q2''
        ],
        b: [
            [0.0, 0.0], // q1'
            [0.0, 0.0], // q2'
            [inv_q1, d_q1_ddot_by_tau_2], // q1''
            [-l_q2_q1 * inv_q1, inv_q2 - l_q2_q1 * d_q1_ddot_by_tau_2], // q2''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 4 x 15; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 15]; 4], Singular> {
    let State { q, v } = x;
    let (s_q1, c_q1) = sin_cos(q.q1);
    let (s_q2, c_q2) = sin_cos(q.q2);
    // friction of q1
    let friction_q1_1 = 1.5707963267948966 * p.c_f1;
    let q1_dot_per_v_c = v.q1 / p.v_c;
    let tanh_q1_dot_per_v_c = tanh(q1_dot_per_v_c);
    let d_q1 = p.b_1 * v.q1 + friction_q1_1 * tanh_q1_dot_per_v_c;
    // friction of q2
    let friction_q2_1 = 1.5707963267948966 * p.c_f2;
    let q2_dot_per_v_c = v.q2 / p.v_c;
    let tanh_q2_dot_per_v_c = tanh(q2_dot_per_v_c);
    let d_q2 = p.b_2 * v.q2 + friction_q2_1 * tanh_q2_dot_per_v_c;
    // body upper_link on upper
    let mc_upper_z = -p.m_1 * p.r_1;
    // body lower_link on lower
    let mc_lower_z = -p.m_2 * p.r_2;
    // frame lower on upper
    let omega_lower_y = -v.q1 - v.q2;
    let omega_lower_y_sq = omega_lower_y * omega_lower_y;
    let mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y_sq;
    let mc_lower_z_c_q2 = mc_lower_z * c_q2;
    let lower_1 = p.I_2 - p.l_1 * mc_lower_z_c_q2;
    let q1_dot_sq = v.q1 * v.q1;
    // frame upper on ground
    let a_upper_x = p.g * s_q1;
    let upper_1 = p.I_1 + p.I_2 + p.l_1 * (p.m_2 * p.l_1 - mc_lower_z_c_q2 - mc_lower_z_c_q2);
    // frame lower on upper
    let a_lower_1_z = p.l_1 * q1_dot_sq + p.g * c_q1;
    let a_lower_1_z_c_q2 = a_lower_1_z * c_q2;
    let a_lower_1_z_s_q2 = a_lower_1_z * s_q2;
    let a_lower_x = a_upper_x * c_q2 + a_lower_1_z_s_q2;
    let f_lower_z = p.m_2 * (a_lower_1_z_c_q2 - a_upper_x * s_q2) - mc_lower_z_omega_lower_y_sq;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = p.m_2 * a_lower_x * c_q2 - f_lower_z * s_q2;
    // frame upper on ground
    let n_upper_y = mc_upper_z * a_upper_x + n_lower_y - p.l_1 * f_lower_1_x;
    let half_I_r = 0.5 * p.I_r;
    let two_n = 2.0 * p.n;
    let n_two_n = p.n * two_n;
    let two_n_2 = 2.0 * p.n;
    let n_two_n_2 = p.n * two_n_2;
    // kinetic energy rotor_2
    let M_q1_q1 = upper_1 + p.I_r + half_I_r * n_two_n;
    let lower_1_minus_half_I_r_two_n = lower_1 - half_I_r * two_n;
    let M_q2_q2 = p.I_2 + half_I_r * n_two_n_2;
    // balance of forces
    let tau_q2 = n_lower_y - d_q2 + u.tau_2;
    // M = L^T D L and back-substitution
    let inv_q2 = 1.0 / M_q2_q2;
    let l_q2_q1 = lower_1_minus_half_I_r_two_n * inv_q2;
    let u_q1_q2 = inv_q2 * (lower_1 - half_I_r * two_n_2);
    let pivot_q1 = M_q1_q1 - lower_1_minus_half_I_r_two_n * u_q1_q2;
    let inv_q1 = 1.0 / pivot_q1;
    let q1_ddot = inv_q1 * (n_upper_y - tau_q2 * u_q1_q2 - d_q1 + u.tau_1);
    let q2_ddot = tau_q2 * inv_q2 - l_q2_q1 * q1_ddot;
    let q1_ddot_plus_q2_ddot = q1_ddot + q2_ddot;
    let a_upper_x_plus_l_1_q1_ddot = a_upper_x + p.l_1 * q1_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = a_lower_1_z_c_q2 - a_upper_x_plus_l_1_q1_ddot * s_q2;
    let slopes_2 = a_lower_1_z_s_q2 + a_upper_x_plus_l_1_q1_ddot * c_q2;
    let m_2_slopes_2 = p.m_2 * slopes_2;
    let slopes_3 = c_q2 * (m_2_slopes_2 - mc_lower_z * q1_ddot_plus_q2_ddot);
    let slopes_4 = slopes_3 - s_q2 * (p.m_2 * slopes_1 - mc_lower_z_omega_lower_y_sq);
    let r_2_slopes_2 = p.r_2 * slopes_2;
    let slopes_5 = s_q2 * (slopes_1 + p.r_2 * omega_lower_y_sq);
    let slopes_6 = c_q2 * (slopes_2 + p.r_2 * q1_ddot_plus_q2_ddot) - slopes_5;
    let slopes_7 = p.m_2 * q1_ddot_plus_q2_ddot * c_q2 - p.m_2 * omega_lower_y_sq * s_q2;
    let slopes_8 = q1_dot_sq * s_q2 + q1_ddot * c_q2;
    let slopes_9 = p.m_2 * (q1_dot_sq * c_q2 - q1_ddot * s_q2);
    let mc_lower_z_slopes_8 = mc_lower_z * slopes_8;
    let slopes_10 = p.m_2 * slopes_8 * c_q2 - slopes_9 * s_q2;
    let slopes_11 = slopes_4 - mc_lower_z_slopes_8 + p.l_1 * slopes_10;
    let slopes_12 = p.n * q1_ddot - 0.5 * q2_ddot * n_two_n_2;
    let slopes_13 = p.I_r * q1_ddot - 4.0 * p.n * q2_ddot * half_I_r;
    // derivatives with respect to v_c
    let by_v_c_1 = friction_q1_1 * q1_dot_per_v_c * (1.0 - tanh_q1_dot_per_v_c * tanh_q1_dot_per_v_c) / p.v_c;
    let by_v_c_2 = friction_q2_1 * q2_dot_per_v_c * (1.0 - tanh_q2_dot_per_v_c * tanh_q2_dot_per_v_c) / p.v_c;
    let d_q1_ddot_by_v_c = inv_q1 * (by_v_c_1 - u_q1_q2 * by_v_c_2);
    let d_q2_ddot_by_v_c = inv_q2 * by_v_c_2 - l_q2_q1 * d_q1_ddot_by_v_c;
    let c_q1_s_q2_plus_s_q1_c_q2 = c_q1 * s_q2 + s_q1 * c_q2;
    // derivatives with respect to g
    let by_g_1 = p.m_2 * (c_q1 * c_q2 - s_q1 * s_q2);
    let by_g_2 = mc_lower_z * c_q1_s_q2_plus_s_q1_c_q2;
    let by_g_3 = p.m_2 * c_q1_s_q2_plus_s_q1_c_q2 * c_q2 - by_g_1 * s_q2;
    let by_g_4 = p.l_1 * by_g_3 - mc_upper_z * s_q1 - by_g_2;
    let d_q1_ddot_by_g = inv_q1 * (-u_q1_q2 * by_g_2 - by_g_4);
    let d_q2_ddot_by_g = inv_q2 * by_g_2 - l_q2_q1 * d_q1_ddot_by_g;
    // derivatives with respect to m_1
    let d_q1_ddot_by_m_1 = -p.r_1 * inv_q1 * a_upper_x;
    // derivatives with respect to m_2
    let d_q1_ddot_by_m_2 = inv_q1 * (u_q1_q2 * r_2_slopes_2 - r_2_slopes_2 - p.l_1 * slopes_6);
    let d_q2_ddot_by_m_2 = -inv_q2 * r_2_slopes_2 - l_q2_q1 * d_q1_ddot_by_m_2;
    // derivatives with respect to r_1
    let d_q1_ddot_by_r_1 = -p.m_1 * a_upper_x * inv_q1;
    // derivatives with respect to r_2
    let d_q1_ddot_by_r_2 = inv_q1 * (u_q1_q2 * m_2_slopes_2 - m_2_slopes_2 - p.l_1 * slopes_7);
    let d_q2_ddot_by_r_2 = -inv_q2 * m_2_slopes_2 - l_q2_q1 * d_q1_ddot_by_r_2;
    // derivatives with respect to l_1
    let d_q1_ddot_by_l_1 = inv_q1 * (-u_q1_q2 * mc_lower_z_slopes_8 - slopes_11);
    let d_q2_ddot_by_l_1 = inv_q2 * mc_lower_z_slopes_8 - l_q2_q1 * d_q1_ddot_by_l_1;
    // derivatives with respect to I_1
    let d_q1_ddot_by_I_1 = -inv_q1 * q1_ddot;
    let q2_ddot_plus_q1_ddot = q2_ddot + q1_ddot;
    // derivatives with respect to I_2
    let d_q1_ddot_by_I_2 = inv_q1 * (u_q1_q2 * q2_ddot_plus_q1_ddot - q2_ddot_plus_q1_ddot);
    let d_q2_ddot_by_I_2 = -inv_q2 * q2_ddot_plus_q1_ddot - l_q2_q1 * d_q1_ddot_by_I_2;
    // derivatives with respect to I_r
    let d_q1_ddot_by_I_r = -inv_q1 * (q1_ddot * (1.0 + 0.5 * n_two_n) - p.n * q2_ddot + u_q1_q2 * slopes_12);
    let d_q2_ddot_by_I_r = inv_q2 * slopes_12 - l_q2_q1 * d_q1_ddot_by_I_r;
    // derivatives with respect to n
    let d_q1_ddot_by_n = -inv_q1 * (4.0 * p.n * q1_ddot * half_I_r - p.I_r * q2_ddot + u_q1_q2 * slopes_13);
    let d_q2_ddot_by_n = inv_q2 * slopes_13 - l_q2_q1 * d_q1_ddot_by_n;
    // derivatives with respect to b_1
    let d_q1_ddot_by_b_1 = -inv_q1 * v.q1;
    // derivatives with respect to b_2
    let d_q1_ddot_by_b_2 = inv_q1 * u_q1_q2 * v.q2;
    let d_q2_ddot_by_b_2 = -inv_q2 * v.q2 - l_q2_q1 * d_q1_ddot_by_b_2;
    // derivatives with respect to c_f1
    let d_q1_ddot_by_c_f1 = -1.5707963267948966 * inv_q1 * tanh_q1_dot_per_v_c;
    // derivatives with respect to c_f2
    let by_c_f2_1 = 1.5707963267948966 * tanh_q2_dot_per_v_c;
    let d_q1_ddot_by_c_f2 = inv_q1 * u_q1_q2 * by_c_f2_1;
    let d_q2_ddot_by_c_f2 = -inv_q2 * by_c_f2_1 - l_q2_q1 * d_q1_ddot_by_c_f2;
    positive(M_q2_q2, 1)?;
    positive(pivot_q1, 0)?;
    Ok([
        [0.0; 15], // q1'
        [0.0; 15], // q2'
        // q1''
        Parameters {
            m_1: d_q1_ddot_by_m_1,
            m_2: d_q1_ddot_by_m_2,
            r_1: d_q1_ddot_by_r_1,
            r_2: d_q1_ddot_by_r_2,
            l_1: d_q1_ddot_by_l_1,
            I_1: d_q1_ddot_by_I_1,
            I_2: d_q1_ddot_by_I_2,
            I_r: d_q1_ddot_by_I_r,
            n: d_q1_ddot_by_n,
            b_1: d_q1_ddot_by_b_1,
            b_2: d_q1_ddot_by_b_2,
            c_f1: d_q1_ddot_by_c_f1,
            c_f2: d_q1_ddot_by_c_f2,
            v_c: d_q1_ddot_by_v_c,
            g: d_q1_ddot_by_g,
        }
        .to_array(),
        // q2''
        Parameters {
            m_1: -l_q2_q1 * d_q1_ddot_by_m_1,
            m_2: d_q2_ddot_by_m_2,
            r_1: -l_q2_q1 * d_q1_ddot_by_r_1,
            r_2: d_q2_ddot_by_r_2,
            l_1: d_q2_ddot_by_l_1,
            I_1: -l_q2_q1 * d_q1_ddot_by_I_1,
            I_2: d_q2_ddot_by_I_2,
            I_r: d_q2_ddot_by_I_r,
            n: d_q2_ddot_by_n,
            b_1: -l_q2_q1 * d_q1_ddot_by_b_1,
            b_2: d_q2_ddot_by_b_2,
            c_f1: -l_q2_q1 * d_q1_ddot_by_c_f1,
            c_f2: d_q2_ddot_by_c_f2,
            v_c: d_q2_ddot_by_v_c,
            g: d_q2_ddot_by_g,
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 2 x 4.
    pub by_x: [[f64; 4]; 2],
    /// dy/dp, 2 x 15.
    pub by_p: [[f64; 15]; 2],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]],
        by_p: [
            [0.0; 15], // q1
            [0.0; 15], // q2
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 4] = ["q1", "q2", "q1.dot", "q2.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 2] = ["tau_1", "tau_2"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 15] = [
    "m_1", "m_2", "r_1", "r_2", "l_1", "I_1", "I_2", "I_r", "n", "b_1", "b_2", "c_f1", "c_f2", "v_c", "g",
];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 15] = [
    "kg", "kg", "m", "m", "m", "kg*m^2", "kg*m^2", "kg*m^2", "1", "N*m*s", "N*m*s", "N*m", "N*m", "rad/s", "m/s^2",
];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 2] = ["q1", "q2"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 2] = ["rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DoublePendulum;

impl Names for DoublePendulum {
    fn rig(&self) -> &str {
        "DoublePendulum"
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

impl Model for DoublePendulum {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 2, lags: 0, inputs: 2, exogenous: 0, parameters: 15, outputs: 2 }
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
            1 => InputPath { limits: (-10.0, 10.0), delay: 0.0 },
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
