//! Acrobot.
//! Generated from `acrobot.rig` (model 993e11c5); edit the rig, not this file.
//!
//! Two links with a motor at the elbow only: the acrobot of the dm_control suite (suite/acrobot.xml,
//! Tassa et al. 2018, arXiv 1801.00690). Links are capsules of 1 kg and 1 m; both angles are 0 with the
//! arm standing upright, elbow relative to the upper arm.
//!
//! 61 operations forward, 146 with A and B.
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
    /// upper arm [kg]
    pub m_1: f64,
    /// lower arm [kg]
    pub m_2: f64,
    /// shoulder to elbow [m]
    pub l_1: f64,
    /// shoulder to the upper arm's centre [m]
    pub l_c1: f64,
    /// elbow to the lower arm's centre [m]
    pub l_c2: f64,
    /// upper arm across, about its centre [kg*m^2]
    pub I_1: f64,
    /// upper arm along [kg*m^2]
    pub J_1: f64,
    /// lower arm across, about its centre [kg*m^2]
    pub I_2: f64,
    /// lower arm along [kg*m^2]
    pub J_2: f64,
    /// damping of the shoulder [N*m*s]
    pub c_1: f64,
    /// damping of the elbow [N*m*s]
    pub c_2: f64,
    /// g [m/s^2]
    pub g: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m_1: 1.0,
        m_2: 1.0,
        l_1: 1.0,
        l_c1: 0.5,
        l_c2: 0.5,
        I_1: 0.0955703125,
        J_1: 0.001234375,
        I_2: 0.09530365719649561,
        J_2: 0.0011857754693366711,
        c_1: 0.05,
        c_2: 0.05,
        g: 9.81,
    };

    /// All zero: where derivatives with respect to the parameters start from.
    const ZERO: Self = Self::from_array([0.0; 12]);

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 12]) -> Self {
        let [m_1, m_2, l_1, l_c1, l_c2, I_1, J_1, I_2, J_2, c_1, c_2, g] = values;
        Self { m_1, m_2, l_1, l_c1, l_c2, I_1, J_1, I_2, J_2, c_1, c_2, g }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 12] {
        [self.m_1, self.m_2, self.l_1, self.l_c1, self.l_c2, self.I_1, self.J_1, self.I_2, self.J_2, self.c_1, self.c_2, self.g]
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
    /// shoulder [rad]
    pub shoulder: f64,
    /// elbow [rad]
    pub elbow: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [shoulder, elbow] = values;
        Self { shoulder, elbow }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.shoulder, self.elbow]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// shoulder.dot [rad/s]
    pub shoulder: f64,
    /// elbow.dot [rad/s]
    pub elbow: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [shoulder, elbow] = values;
        Self { shoulder, elbow }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.shoulder, self.elbow]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// shoulder.ddot [rad/s^2]
    pub shoulder: f64,
    /// elbow.ddot [rad/s^2]
    pub elbow: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [shoulder, elbow] = values;
        Self { shoulder, elbow }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.shoulder, self.elbow]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// elbow motor [N*m]
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
    /// shoulder [rad]
    pub shoulder: f64,
    /// elbow [rad]
    pub elbow: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [shoulder, elbow] = values;
        Self { shoulder, elbow }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.shoulder, self.elbow]
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

/// Mass matrix M(q), 2 x 2, symmetric; rows (shoulder, elbow).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 2]; 2] {
    let c_elbow = cos(q.elbow);
    // body upper_arm on upper
    let I_upper_xx = p.I_1 + p.m_1 * p.l_c1 * p.l_c1;
    // body lower_arm on lower
    let mc_lower_z = p.m_2 * p.l_c2;
    let I_lower_xx = p.I_2 + p.l_c2 * mc_lower_z;
    let mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    // frame lower on upper
    let M_shoulder_elbow = I_lower_xx + p.l_1 * mc_lower_z_c_elbow;
    // frame upper on ground
    let M_shoulder_shoulder = I_upper_xx + I_lower_xx + p.l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p.m_2 * p.l_1);
    [[M_shoulder_shoulder, M_shoulder_elbow], [M_shoulder_elbow, I_lower_xx]]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (shoulder, elbow).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_shoulder, c_shoulder) = sin_cos(q.shoulder);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // body lower_arm on lower
    let mc_lower_z = p.m_2 * p.l_c2;
    // frame lower on upper
    let omega_lower_y = v.shoulder + v.elbow;
    // frame upper on ground
    let a_upper_x = -p.g * s_shoulder;
    // frame lower on upper
    let a_lower_1_z = p.g * c_shoulder - p.l_1 * v.shoulder * v.shoulder;
    let a_lower_z = a_lower_1_z * c_elbow + a_upper_x * s_elbow;
    let a_lower_x = a_upper_x * c_elbow - a_lower_1_z * s_elbow;
    let f_lower_z = p.m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = f_lower_z * s_elbow + p.m_2 * a_lower_x * c_elbow;
    // frame upper on ground
    let n_upper_y = p.l_1 * f_lower_1_x + n_lower_y + p.m_1 * p.l_c1 * a_upper_x;
    [n_upper_y, n_lower_y]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (shoulder, elbow).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // body lower_arm on lower
    let mc_lower_z = p.m_2 * p.l_c2;
    // frame lower on upper
    let omega_lower_y = v.shoulder + v.elbow;
    let a_lower_1_z = -p.l_1 * v.shoulder * v.shoulder;
    let a_lower_x = -a_lower_1_z * s_elbow;
    let f_moving_lower_z = p.m_2 * a_lower_1_z * c_elbow - mc_lower_z * omega_lower_y * omega_lower_y;
    let n_moving_lower_y = mc_lower_z * a_lower_x;
    let f_moving_lower_1_x = p.m_2 * a_lower_x * c_elbow + f_moving_lower_z * s_elbow;
    [n_moving_lower_y + p.l_1 * f_moving_lower_1_x, n_moving_lower_y]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (shoulder, elbow).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 2] {
    let (s_shoulder, c_shoulder) = sin_cos(q.shoulder);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    let l_c2_c_elbow = p.l_c2 * c_elbow;
    let l_c2_c_shoulder_s_elbow = p.l_c2 * c_shoulder * s_elbow;
    let gravity_1 = p.m_2 * p.g * (s_shoulder * (p.l_1 + l_c2_c_elbow) + l_c2_c_shoulder_s_elbow);
    let g_shoulder = -p.m_1 * p.l_c1 * p.g * s_shoulder - gravity_1;
    let g_elbow = -p.m_2 * p.g * (l_c2_c_shoulder_s_elbow + l_c2_c_elbow * s_shoulder);
    [g_shoulder, g_elbow]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (shoulder, elbow).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    [p.c_1 * v.shoulder, p.c_2 * v.elbow]
}

/// Generalized force Q [N m] of the inputs; rows (shoulder, elbow).
#[must_use]
pub fn generalized_force(_q: &Coordinates, u: &Inputs, _p: &Parameters) -> [f64; 2] {
    [0.0, u.tau]
}

/// Input map dQ/du, 2 x 1; rows (shoulder, elbow), columns (tau).
#[must_use]
pub fn input_map(_q: &Coordinates, _p: &Parameters) -> [[f64; 1]; 2] {
    [[0.0], [1.0]]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // frame lower on upper
    let omega_lower_y = v.shoulder + v.elbow;
    let l_1_shoulder_dot = p.l_1 * v.shoulder;
    let l_1_shoulder_dot_s_elbow = l_1_shoulder_dot * s_elbow;
    let l_c1_shoulder_dot = p.l_c1 * v.shoulder;
    // body upper_arm on upper
    let upper_arm_1 = 0.5 * (p.m_1 * l_c1_shoulder_dot * l_c1_shoulder_dot + p.I_1 * v.shoulder * v.shoulder);
    // body lower_arm on lower
    let lower_arm_1 = l_1_shoulder_dot * c_elbow + p.l_c2 * omega_lower_y;
    let lower_arm_2 = p.m_2 * (lower_arm_1 * lower_arm_1 + l_1_shoulder_dot_s_elbow * l_1_shoulder_dot_s_elbow);
    upper_arm_1 + 0.5 * (lower_arm_2 + p.I_2 * omega_lower_y * omega_lower_y)
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let (s_shoulder, c_shoulder) = sin_cos(q.shoulder);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // body lower_arm on lower
    let lower_arm_1 = c_shoulder * (p.l_1 + p.l_c2 * c_elbow);
    let lower_arm_2 = p.m_2 * p.g * (lower_arm_1 - p.l_c2 * s_shoulder * s_elbow);
    p.m_1 * p.l_c1 * p.g * c_shoulder + lower_arm_2
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 2] {
    let State { q, v } = x;
    let (s_shoulder, c_shoulder) = sin_cos(q.shoulder);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // body upper_arm on upper
    let mc_upper_z = p.m_1 * p.l_c1;
    // body lower_arm on lower
    let mc_lower_z = p.m_2 * p.l_c2;
    // frame lower on upper
    let omega_lower_y = v.shoulder + v.elbow;
    // frame upper on ground
    let a_upper_x = -p.g * s_shoulder;
    // frame lower on upper
    let a_lower_1_z = p.g * c_shoulder - p.l_1 * v.shoulder * v.shoulder;
    let a_lower_1_x = p.l_1 * a.shoulder + a_upper_x;
    // gravity
    let alpha_lower_y = a.shoulder + a.elbow;
    // frame lower on upper
    let a_lower_z = a_lower_1_z * c_elbow + a_lower_1_x * s_elbow;
    let a_lower_x = a_lower_1_x * c_elbow - a_lower_1_z * s_elbow;
    let f_net_lower_x = p.m_2 * a_lower_x + mc_lower_z * alpha_lower_y;
    let f_net_lower_z = p.m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    let n_net_lower_y = alpha_lower_y * (p.I_2 + p.l_c2 * mc_lower_z) + mc_lower_z * a_lower_x;
    let f_net_lower_1_x = f_net_lower_z * s_elbow + f_net_lower_x * c_elbow;
    // frame upper on ground
    let n_net_upper_y = a.shoulder * (p.I_1 + p.l_c1 * mc_upper_z) + mc_upper_z * a_upper_x + n_net_lower_y + p.l_1 * f_net_lower_1_x;
    [p.c_1 * v.shoulder + n_net_upper_y, p.c_2 * v.elbow + n_net_lower_y - u.tau]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.shoulder, q.elbow])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 2] {
    let State { q, .. } = x;
    let c_elbow = cos(q.elbow);
    // body upper_arm on upper
    let I_upper_xx = p.I_1 + p.m_1 * p.l_c1 * p.l_c1;
    // body lower_arm on lower
    let mc_lower_z = p.m_2 * p.l_c2;
    let I_lower_xx = p.I_2 + p.l_c2 * mc_lower_z;
    let mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    // frame lower on upper
    let M_shoulder_elbow = I_lower_xx + p.l_1 * mc_lower_z_c_elbow;
    // frame upper on ground
    let M_shoulder_shoulder = I_upper_xx + I_lower_xx + p.l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p.m_2 * p.l_1);
    // M = L^T D L and back-substitution
    let pivot_shoulder = M_shoulder_shoulder - M_shoulder_elbow * M_shoulder_elbow / I_lower_xx;
    [pivot_shoulder, I_lower_xx]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 61 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_shoulder, c_shoulder) = sin_cos(q.shoulder);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // body upper_arm on upper
    let mc_upper_z = p.m_1 * p.l_c1;
    // body lower_arm on lower
    let mc_lower_z = p.m_2 * p.l_c2;
    let I_lower_xx = p.I_2 + p.l_c2 * mc_lower_z;
    // frame lower on upper
    let omega_lower_y = v.shoulder + v.elbow;
    let mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    let M_shoulder_elbow = I_lower_xx + p.l_1 * mc_lower_z_c_elbow;
    // frame upper on ground
    let a_upper_x = -p.g * s_shoulder;
    // frame lower on upper
    let a_lower_1_z = p.g * c_shoulder - p.l_1 * v.shoulder * v.shoulder;
    let lower_1_1 = I_lower_xx + p.l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p.m_2 * p.l_1);
    let a_lower_z = a_lower_1_z * c_elbow + a_upper_x * s_elbow;
    let a_lower_x = a_upper_x * c_elbow - a_lower_1_z * s_elbow;
    let f_lower_z = p.m_2 * a_lower_z - mc_lower_z * omega_lower_y * omega_lower_y;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = f_lower_z * s_elbow + p.m_2 * a_lower_x * c_elbow;
    // frame upper on ground
    let n_upper_y = p.l_1 * f_lower_1_x + n_lower_y + mc_upper_z * a_upper_x;
    let M_shoulder_shoulder = p.I_1 + p.l_c1 * mc_upper_z + lower_1_1;
    // balance of forces
    let tau_elbow = u.tau - n_lower_y - p.c_2 * v.elbow;
    // M = L^T D L and back-substitution
    let inv_elbow = 1.0 / I_lower_xx;
    let l_elbow_shoulder = M_shoulder_elbow * inv_elbow;
    let pivot_shoulder = M_shoulder_shoulder - M_shoulder_elbow * l_elbow_shoulder;
    let shoulder_ddot = -(p.c_1 * v.shoulder + n_upper_y + tau_elbow * l_elbow_shoulder) / pivot_shoulder;
    let elbow_ddot = tau_elbow * inv_elbow - l_elbow_shoulder * shoulder_ddot;
    positive(I_lower_xx, 1)?;
    positive(pivot_shoulder, 0)?;
    Ok(Accelerations::from_array([shoulder_ddot, elbow_ddot]))
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
/// 146 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///             shoulder elbow shoulder.dot elbow.dot | tau
/// shoulder'   .        .     1            .         | .
/// elbow'      .        .     .            1         | .
/// shoulder''  *        *     *            *         | *
/// elbow''     *        *     *            *         | *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_shoulder, c_shoulder) = sin_cos(q.shoulder);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // body upper_arm on upper
    let mc_upper_z = p.m_1 * p.l_c1;
    // body lower_arm on lower
    let mc_lower_z = p.m_2 * p.l_c2;
    let I_lower_xx = p.I_2 + p.l_c2 * mc_lower_z;
    // frame lower on upper
    let omega_lower_y = v.shoulder + v.elbow;
    let mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y * omega_lower_y;
    let mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    let M_shoulder_elbow = I_lower_xx + p.l_1 * mc_lower_z_c_elbow;
    // frame upper on ground
    let a_upper_z = p.g * c_shoulder;
    let a_upper_x = -p.g * s_shoulder;
    let a_upper_x_s_elbow = a_upper_x * s_elbow;
    let a_upper_x_c_elbow = a_upper_x * c_elbow;
    // frame lower on upper
    let f_weight_lower_x = -p.m_2 * (a_upper_z * s_elbow - a_upper_x_c_elbow);
    let a_lower_1_z = a_upper_z - p.l_1 * v.shoulder * v.shoulder;
    let lower_1_1 = I_lower_xx + p.l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p.m_2 * p.l_1);
    let a_lower_1_z_c_elbow = a_lower_1_z * c_elbow;
    let a_lower_1_z_s_elbow = a_lower_1_z * s_elbow;
    let a_lower_x = a_upper_x_c_elbow - a_lower_1_z_s_elbow;
    let f_lower_z = p.m_2 * (a_lower_1_z_c_elbow + a_upper_x_s_elbow) - mc_lower_z_omega_lower_y_sq;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = f_lower_z * s_elbow + p.m_2 * a_lower_x * c_elbow;
    // frame upper on ground
    let n_upper_y = p.l_1 * f_lower_1_x + n_lower_y + mc_upper_z * a_upper_x;
    let M_shoulder_shoulder = p.I_1 + p.l_c1 * mc_upper_z + lower_1_1;
    // balance of forces
    let tau_elbow = u.tau - n_lower_y - p.c_2 * v.elbow;
    // M = L^T D L and back-substitution
    let inv_elbow = 1.0 / I_lower_xx;
    let l_elbow_shoulder = M_shoulder_elbow * inv_elbow;
    let pivot_shoulder = M_shoulder_shoulder - M_shoulder_elbow * l_elbow_shoulder;
    let inv_shoulder = 1.0 / pivot_shoulder;
    let shoulder_ddot = -inv_shoulder * (p.c_1 * v.shoulder + n_upper_y + tau_elbow * l_elbow_shoulder);
    let elbow_ddot = tau_elbow * inv_elbow - l_elbow_shoulder * shoulder_ddot;
    // derivatives with respect to shoulder
    let by_shoulder_1 = a_upper_x_s_elbow + a_upper_z * c_elbow;
    let mc_lower_z_by_shoulder_1 = mc_lower_z * by_shoulder_1;
    let by_shoulder_2 = p.l_1 * (f_weight_lower_x * s_elbow - p.m_2 * by_shoulder_1 * c_elbow);
    let by_shoulder_3 = mc_upper_z * a_upper_z + mc_lower_z_by_shoulder_1 - by_shoulder_2;
    let d_shoulder_ddot_by_shoulder = inv_shoulder * (by_shoulder_3 - l_elbow_shoulder * mc_lower_z_by_shoulder_1);
    let d_elbow_ddot_by_shoulder = inv_elbow * mc_lower_z_by_shoulder_1 - l_elbow_shoulder * d_shoulder_ddot_by_shoulder;
    let two_l_1_shoulder_dot = 2.0 * p.l_1 * v.shoulder;
    let two_mc_lower_z_omega_lower_y = 2.0 * mc_lower_z * omega_lower_y;
    let two_l_1_shoulder_dot_s_elbow = two_l_1_shoulder_dot * s_elbow;
    // derivatives with respect to shoulder_dot
    let by_shoulder_dot_1 = mc_lower_z * two_l_1_shoulder_dot_s_elbow;
    let by_shoulder_dot_2 = s_elbow * (two_mc_lower_z_omega_lower_y + p.m_2 * two_l_1_shoulder_dot * c_elbow);
    let by_shoulder_dot_3 = p.l_1 * (p.m_2 * two_l_1_shoulder_dot_s_elbow * c_elbow - by_shoulder_dot_2);
    let by_shoulder_dot_4 = l_elbow_shoulder * by_shoulder_dot_1 - p.c_1 - by_shoulder_dot_1 - by_shoulder_dot_3;
    let d_shoulder_ddot_by_shoulder_dot = inv_shoulder * by_shoulder_dot_4;
    let d_elbow_ddot_by_shoulder_dot = -inv_elbow * by_shoulder_dot_1 - l_elbow_shoulder * d_shoulder_ddot_by_shoulder_dot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = a_upper_x + p.l_1 * shoulder_ddot;
    let slopes_2 = a_lower_1_z_c_elbow + slopes_1 * s_elbow;
    let slopes_3 = p.m_2 * (a_lower_1_z_s_elbow - slopes_1 * c_elbow);
    let m_2_slopes_2 = p.m_2 * slopes_2;
    let slopes_4 = c_elbow * (m_2_slopes_2 - mc_lower_z_omega_lower_y_sq);
    let slopes_5 = s_elbow * (mc_lower_z * (elbow_ddot + shoulder_ddot) - slopes_3);
    let mc_lower_z_slopes_2 = mc_lower_z * slopes_2;
    let slopes_6 = slopes_5 + m_2_slopes_2 * c_elbow;
    let slopes_7 = p.l_1 * (slopes_4 - slopes_3 * s_elbow - slopes_6);
    // derivatives with respect to elbow
    let d_shoulder_ddot_by_elbow = inv_shoulder * (mc_lower_z_slopes_2 - slopes_7 - l_elbow_shoulder * mc_lower_z_slopes_2);
    let d_elbow_ddot_by_elbow = inv_elbow * mc_lower_z_slopes_2 - l_elbow_shoulder * d_shoulder_ddot_by_elbow;
    // derivatives with respect to elbow_dot
    let d_shoulder_ddot_by_elbow_dot = inv_shoulder * (p.l_1 * two_mc_lower_z_omega_lower_y * s_elbow + p.c_2 * l_elbow_shoulder);
    let d_elbow_ddot_by_elbow_dot = -p.c_2 * inv_elbow - l_elbow_shoulder * d_shoulder_ddot_by_elbow_dot;
    // derivatives with respect to tau
    let d_shoulder_ddot_by_tau = -l_elbow_shoulder * inv_shoulder;
    positive(I_lower_xx, 1)?;
    positive(pivot_shoulder, 0)?;
    Ok(Linearization {
        dx: [v.shoulder, v.elbow, shoulder_ddot, elbow_ddot],
        a: [
            [0.0, 0.0, 1.0, 0.0], // shoulder'
            [0.0, 0.0, 0.0, 1.0], // elbow'
            // shoulder''
            [d_shoulder_ddot_by_shoulder, d_shoulder_ddot_by_elbow, d_shoulder_ddot_by_shoulder_dot, d_shoulder_ddot_by_elbow_dot],
            [d_elbow_ddot_by_shoulder, d_elbow_ddot_by_elbow, d_elbow_ddot_by_shoulder_dot, d_elbow_ddot_by_elbow_dot], // elbow''
        ],
        b: [
            [0.0], // shoulder'
            [0.0], // elbow'
            [d_shoulder_ddot_by_tau], // shoulder''
            [inv_elbow - l_elbow_shoulder * d_shoulder_ddot_by_tau], // elbow''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 4 x 12; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 12]; 4], Singular> {
    let State { q, v } = x;
    let (s_shoulder, c_shoulder) = sin_cos(q.shoulder);
    let (s_elbow, c_elbow) = sin_cos(q.elbow);
    // body upper_arm on upper
    let mc_upper_z = p.m_1 * p.l_c1;
    // body lower_arm on lower
    let mc_lower_z = p.m_2 * p.l_c2;
    let I_lower_xx = p.I_2 + p.l_c2 * mc_lower_z;
    // frame lower on upper
    let omega_lower_y = v.shoulder + v.elbow;
    let omega_lower_y_sq = omega_lower_y * omega_lower_y;
    let mc_lower_z_omega_lower_y_sq = mc_lower_z * omega_lower_y_sq;
    let mc_lower_z_c_elbow = mc_lower_z * c_elbow;
    let M_shoulder_elbow = I_lower_xx + p.l_1 * mc_lower_z_c_elbow;
    let shoulder_dot_sq = v.shoulder * v.shoulder;
    // frame upper on ground
    let a_upper_x = -p.g * s_shoulder;
    // frame lower on upper
    let a_lower_1_z = p.g * c_shoulder - p.l_1 * shoulder_dot_sq;
    let lower_1_1 = I_lower_xx + p.l_1 * (mc_lower_z_c_elbow + mc_lower_z_c_elbow + p.m_2 * p.l_1);
    let a_lower_1_z_c_elbow = a_lower_1_z * c_elbow;
    let a_lower_1_z_s_elbow = a_lower_1_z * s_elbow;
    let a_lower_x = a_upper_x * c_elbow - a_lower_1_z_s_elbow;
    let f_lower_z = p.m_2 * (a_lower_1_z_c_elbow + a_upper_x * s_elbow) - mc_lower_z_omega_lower_y_sq;
    let n_lower_y = mc_lower_z * a_lower_x;
    let f_lower_1_x = f_lower_z * s_elbow + p.m_2 * a_lower_x * c_elbow;
    // frame upper on ground
    let n_upper_y = p.l_1 * f_lower_1_x + n_lower_y + mc_upper_z * a_upper_x;
    let M_shoulder_shoulder = p.I_1 + p.l_c1 * mc_upper_z + lower_1_1;
    // balance of forces
    let tau_elbow = u.tau - n_lower_y - p.c_2 * v.elbow;
    // M = L^T D L and back-substitution
    let inv_elbow = 1.0 / I_lower_xx;
    let l_elbow_shoulder = M_shoulder_elbow * inv_elbow;
    let pivot_shoulder = M_shoulder_shoulder - M_shoulder_elbow * l_elbow_shoulder;
    let inv_shoulder = 1.0 / pivot_shoulder;
    let shoulder_ddot = -inv_shoulder * (p.c_1 * v.shoulder + n_upper_y + tau_elbow * l_elbow_shoulder);
    let elbow_ddot = tau_elbow * inv_elbow - l_elbow_shoulder * shoulder_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = elbow_ddot + shoulder_ddot;
    let slopes_2 = a_upper_x + p.l_1 * shoulder_ddot;
    let slopes_3 = a_lower_1_z_c_elbow + slopes_2 * s_elbow;
    let slopes_4 = a_lower_1_z_s_elbow - slopes_2 * c_elbow;
    let m_2_slopes_4 = p.m_2 * slopes_4;
    let slopes_5 = c_elbow * (mc_lower_z * slopes_1 - m_2_slopes_4);
    let slopes_6 = s_elbow * (p.m_2 * slopes_3 - mc_lower_z_omega_lower_y_sq) + slopes_5;
    let slopes_1_l_c2_sq = p.l_c2 * p.l_c2 * slopes_1;
    let l_c2_slopes_4 = p.l_c2 * slopes_4;
    let slopes_7 = c_elbow * (p.l_c2 * slopes_1 - slopes_4);
    let slopes_8 = s_elbow * (slopes_3 - p.l_c2 * omega_lower_y_sq) + slopes_7;
    let slopes_9 = slopes_1_l_c2_sq - l_c2_slopes_4 + p.l_1 * slopes_8;
    let slopes_10 = shoulder_dot_sq * s_elbow + shoulder_ddot * c_elbow;
    let slopes_11 = p.m_2 * (shoulder_dot_sq * c_elbow - shoulder_ddot * s_elbow);
    let mc_lower_z_slopes_10 = mc_lower_z * slopes_10;
    let slopes_12 = p.m_2 * slopes_10 * c_elbow - slopes_11 * s_elbow;
    let slopes_13 = mc_lower_z_slopes_10 + slopes_6 + p.l_1 * slopes_12;
    let two_slopes_1_mc_lower_z = 2.0 * slopes_1 * mc_lower_z;
    let slopes_14 = p.m_2 * slopes_1 * c_elbow - p.m_2 * omega_lower_y_sq * s_elbow;
    let slopes_15 = two_slopes_1_mc_lower_z - m_2_slopes_4 + p.l_1 * slopes_14;
    // derivatives with respect to g
    let by_g_1 = c_shoulder * s_elbow + s_shoulder * c_elbow;
    let by_g_2 = p.m_2 * (c_shoulder * c_elbow - s_shoulder * s_elbow);
    let mc_lower_z_by_g_1 = mc_lower_z * by_g_1;
    let by_g_3 = by_g_2 * s_elbow - p.m_2 * by_g_1 * c_elbow;
    let by_g_4 = mc_upper_z * s_shoulder - p.l_1 * by_g_3 + mc_lower_z_by_g_1;
    let d_shoulder_ddot_by_g = inv_shoulder * (by_g_4 - l_elbow_shoulder * mc_lower_z_by_g_1);
    let d_elbow_ddot_by_g = inv_elbow * mc_lower_z_by_g_1 - l_elbow_shoulder * d_shoulder_ddot_by_g;
    // derivatives with respect to m_1
    let d_shoulder_ddot_by_m_1 = inv_shoulder * (-p.l_c1 * a_upper_x - p.l_c1 * p.l_c1 * shoulder_ddot);
    // derivatives with respect to m_2
    let by_m_2_1 = l_c2_slopes_4 - slopes_1_l_c2_sq;
    let d_shoulder_ddot_by_m_2 = -inv_shoulder * (slopes_9 + l_elbow_shoulder * by_m_2_1);
    let d_elbow_ddot_by_m_2 = inv_elbow * by_m_2_1 - l_elbow_shoulder * d_shoulder_ddot_by_m_2;
    // derivatives with respect to l_1
    let d_shoulder_ddot_by_l_1 = inv_shoulder * (l_elbow_shoulder * mc_lower_z_slopes_10 - slopes_13);
    let d_elbow_ddot_by_l_1 = -inv_elbow * mc_lower_z_slopes_10 - l_elbow_shoulder * d_shoulder_ddot_by_l_1;
    // derivatives with respect to l_c1
    let d_shoulder_ddot_by_l_c1 = inv_shoulder * (-p.m_1 * a_upper_x - 2.0 * shoulder_ddot * mc_upper_z);
    // derivatives with respect to l_c2
    let by_l_c2_1 = m_2_slopes_4 - two_slopes_1_mc_lower_z;
    let d_shoulder_ddot_by_l_c2 = -inv_shoulder * (slopes_15 + l_elbow_shoulder * by_l_c2_1);
    let d_elbow_ddot_by_l_c2 = inv_elbow * by_l_c2_1 - l_elbow_shoulder * d_shoulder_ddot_by_l_c2;
    // derivatives with respect to I_1
    let d_shoulder_ddot_by_I_1 = -inv_shoulder * shoulder_ddot;
    // derivatives with respect to I_2
    let by_I_2_1 = shoulder_ddot + elbow_ddot;
    let d_shoulder_ddot_by_I_2 = inv_shoulder * (l_elbow_shoulder * by_I_2_1 - by_I_2_1);
    let d_elbow_ddot_by_I_2 = -inv_elbow * by_I_2_1 - l_elbow_shoulder * d_shoulder_ddot_by_I_2;
    // derivatives with respect to c_1
    let d_shoulder_ddot_by_c_1 = -inv_shoulder * v.shoulder;
    // derivatives with respect to c_2
    let d_shoulder_ddot_by_c_2 = inv_shoulder * l_elbow_shoulder * v.elbow;
    let d_elbow_ddot_by_c_2 = -inv_elbow * v.elbow - l_elbow_shoulder * d_shoulder_ddot_by_c_2;
    positive(I_lower_xx, 1)?;
    positive(pivot_shoulder, 0)?;
    Ok([
        [0.0; 12], // shoulder'
        [0.0; 12], // elbow'
        // shoulder''
        Parameters {
            m_1: d_shoulder_ddot_by_m_1,
            m_2: d_shoulder_ddot_by_m_2,
            l_1: d_shoulder_ddot_by_l_1,
            l_c1: d_shoulder_ddot_by_l_c1,
            l_c2: d_shoulder_ddot_by_l_c2,
            I_1: d_shoulder_ddot_by_I_1,
            I_2: d_shoulder_ddot_by_I_2,
            c_1: d_shoulder_ddot_by_c_1,
            c_2: d_shoulder_ddot_by_c_2,
            g: d_shoulder_ddot_by_g,
            ..Parameters::ZERO
        }
        .to_array(),
        // elbow''
        Parameters {
            m_1: -l_elbow_shoulder * d_shoulder_ddot_by_m_1,
            m_2: d_elbow_ddot_by_m_2,
            l_1: d_elbow_ddot_by_l_1,
            l_c1: -l_elbow_shoulder * d_shoulder_ddot_by_l_c1,
            l_c2: d_elbow_ddot_by_l_c2,
            I_1: -l_elbow_shoulder * d_shoulder_ddot_by_I_1,
            I_2: d_elbow_ddot_by_I_2,
            c_1: -l_elbow_shoulder * d_shoulder_ddot_by_c_1,
            c_2: d_elbow_ddot_by_c_2,
            g: d_elbow_ddot_by_g,
            ..Parameters::ZERO
        }
        .to_array(),
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 2 x 4.
    pub by_x: [[f64; 4]; 2],
    /// dy/dp, 2 x 12.
    pub by_p: [[f64; 12]; 2],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]],
        by_p: [
            [0.0; 12], // shoulder
            [0.0; 12], // elbow
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 4] = ["shoulder", "elbow", "shoulder.dot", "elbow.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 1] = ["tau"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 12] = ["m_1", "m_2", "l_1", "l_c1", "l_c2", "I_1", "J_1", "I_2", "J_2", "c_1", "c_2", "g"];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 12] = ["kg", "kg", "m", "m", "m", "kg*m^2", "kg*m^2", "kg*m^2", "kg*m^2", "N*m*s", "N*m*s", "m/s^2"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 2] = ["shoulder", "elbow"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 2] = ["rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Acrobot;

impl Names for Acrobot {
    fn rig(&self) -> &str {
        "Acrobot"
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

impl Model for Acrobot {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 2, lags: 0, inputs: 1, exogenous: 0, parameters: 12, outputs: 2 }
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
            0 => InputPath { limits: (-2.0, 2.0), delay: 0.0 },
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
