//! Flexible joint: a link in gravity, driven through a spring.
//! Generated from `flexible_joint.rig` (model 8bd255ae); edit the rig, not this file.
//!
//! Motor and link of one joint, between them a stiff spring with a little damping: the single-link arm of
//! Spong, "Modeling and control of elastic joint robots", J. Dyn. Syst. Meas. Control 109 (1987). Numbers of
//! a small harmonic-drive joint, seen from the link's side, chosen here: the paper keeps symbols.
//!
//! 38 operations forward, 74 with A and B.
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
    /// link [kg]
    pub m: f64,
    /// length of the link [m]
    pub l: f64,
    /// rotor times gear ratio squared [kg*m^2]
    pub J: f64,
    /// stiffness of the joint, per radian [N*m]
    pub k: f64,
    /// its hardening, per radian cubed [N*m]
    pub k_3: f64,
    /// damping within the joint [N*m*s]
    pub c_k: f64,
    /// motor's friction [N*m*s]
    pub c_m: f64,
    /// g [m/s^2]
    pub g: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m: 1.2,
        l: 0.35,
        J: 0.08,
        k: 45.0,
        k_3: 120.0,
        c_k: 0.05,
        c_m: 0.4,
        g: 9.81,
    };

    /// All zero: where derivatives with respect to the parameters start from.
    const ZERO: Self = Self::from_array([0.0; 8]);

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 8]) -> Self {
        let [m, l, J, k, k_3, c_k, c_m, g] = values;
        Self { m, l, J, k, k_3, c_k, c_m, g }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 8] {
        [self.m, self.l, self.J, self.k, self.k_3, self.c_k, self.c_m, self.g]
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
    /// motor, behind the gear [rad]
    pub motor: f64,
    /// link, 0 hanging [rad]
    pub link: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [motor, link] = values;
        Self { motor, link }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.motor, self.link]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// motor, behind the gear [rad/s]
    pub motor: f64,
    /// link, 0 hanging [rad/s]
    pub link: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [motor, link] = values;
        Self { motor, link }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.motor, self.link]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// motor, behind the gear [rad/s^2]
    pub motor: f64,
    /// link, 0 hanging [rad/s^2]
    pub link: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [motor, link] = values;
        Self { motor, link }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.motor, self.link]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// motor torque times gear ratio [N*m]
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
    /// motor [rad]
    pub motor: f64,
    /// link [rad]
    pub link: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [motor, link] = values;
        Self { motor, link }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.motor, self.link]
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

/// Mass matrix M(q), 2 x 2, symmetric; rows (motor, link).
#[must_use]
pub fn mass_matrix(_q: &Coordinates, p: &Parameters) -> [[f64; 2]; 2] {
    let I_l = p.m * p.l * p.l / 12.0;
    let l_per_two = p.l / 2.0;
    // body rod on arm
    let I_arm_xx = I_l + p.m * l_per_two * l_per_two;
    [[p.J, 0.0], [0.0, I_arm_xx]]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (motor, link).
#[must_use]
pub fn bias(q: &Coordinates, _v: &Rates, p: &Parameters) -> [f64; 2] {
    let s_link = sin(q.link);
    let motor_minus_link = q.motor - q.link;
    let half_k = 0.5 * p.k;
    let quarter_k_3 = 0.25 * p.k_3;
    let two_motor_minus_link = 2.0 * motor_minus_link;
    let two_motor_minus_link_sq = 2.0 * motor_minus_link * motor_minus_link;
    // spring coil
    let coil_1 = quarter_k_3 * two_motor_minus_link * two_motor_minus_link_sq;
    let two_motor_minus_link_2 = 2.0 * motor_minus_link;
    let coil_2 = quarter_k_3 * two_motor_minus_link_sq * two_motor_minus_link_2;
    // frame arm on ground
    let n_weight_arm_y = -p.m * p.l * p.g * s_link / 2.0;
    // kinetic energy rotor
    let h_link = -half_k * two_motor_minus_link_2 - coil_2 - n_weight_arm_y;
    [half_k * two_motor_minus_link + coil_1, h_link]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (motor, link).
#[must_use]
pub fn velocity_products(_q: &Coordinates, _v: &Rates, _p: &Parameters) -> [f64; 2] {
    [0.0, 0.0]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (motor, link).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 2] {
    let s_link = sin(q.link);
    let g_link = p.m * p.l * p.g * s_link / 2.0;
    [0.0, g_link]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (motor, link).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    // friction of within
    let d_link = -p.c_k * (v.motor - v.link);
    [p.c_m * v.motor - d_link, d_link]
}

/// Generalized force Q [N m] of the inputs; rows (motor, link).
#[must_use]
pub fn generalized_force(_q: &Coordinates, u: &Inputs, _p: &Parameters) -> [f64; 2] {
    [u.tau, 0.0]
}

/// Input map dQ/du, 2 x 1; rows (motor, link), columns (tau).
#[must_use]
pub fn input_map(_q: &Coordinates, _p: &Parameters) -> [[f64; 1]; 2] {
    [[1.0], [0.0]]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(_q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let I_l = p.m * p.l * p.l / 12.0;
    let l_per_two_link_dot = p.l * v.link / 2.0;
    // body rod on arm
    let rod_1 = 0.5 * (p.m * l_per_two_link_dot * l_per_two_link_dot + I_l * v.link * v.link);
    0.5 * p.J * v.motor * v.motor + rod_1
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let c_link = cos(q.link);
    let motor_minus_link = q.motor - q.link;
    let motor_minus_link_sq = motor_minus_link * motor_minus_link;
    // spring coil
    let coil_1 = 0.5 * p.k * motor_minus_link_sq + 0.25 * p.k_3 * motor_minus_link_sq * motor_minus_link_sq;
    coil_1 - p.m * p.l * p.g * c_link / 2.0
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 2] {
    let State { q, v } = x;
    let s_link = sin(q.link);
    let I_l = p.m * p.l * p.l / 12.0;
    let motor_minus_link = q.motor - q.link;
    // friction of within
    let d_link = -p.c_k * (v.motor - v.link);
    let half_k = 0.5 * p.k;
    let quarter_k_3 = 0.25 * p.k_3;
    let two_motor_minus_link = 2.0 * motor_minus_link;
    let two_motor_minus_link_sq = 2.0 * motor_minus_link * motor_minus_link;
    // spring coil
    let coil_1 = quarter_k_3 * two_motor_minus_link * two_motor_minus_link_sq;
    let two_motor_minus_link_2 = 2.0 * motor_minus_link;
    let coil_2 = quarter_k_3 * two_motor_minus_link_sq * two_motor_minus_link_2;
    let l_per_two = p.l / 2.0;
    // body rod on arm
    let mc_arm_z = -p.m * l_per_two;
    // frame arm on ground
    let n_net_arm_y = p.g * mc_arm_z * s_link - a.link * (I_l - l_per_two * mc_arm_z);
    // balance of forces
    let balance_1 = half_k * two_motor_minus_link + coil_1 + p.J * a.motor - u.tau;
    [
        p.c_m * v.motor - d_link + balance_1, // motor
        d_link - half_k * two_motor_minus_link_2 - coil_2 - n_net_arm_y, // link
    ]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.motor, q.link])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(_x: &State, p: &Parameters) -> [f64; 2] {
    let I_l = p.m * p.l * p.l / 12.0;
    let l_per_two = p.l / 2.0;
    // body rod on arm
    let I_arm_xx = I_l + p.m * l_per_two * l_per_two;
    [p.J, I_arm_xx]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 38 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let s_link = sin(q.link);
    let I_l = p.m * p.l * p.l / 12.0;
    let motor_minus_link = q.motor - q.link;
    // friction of within
    let d_link = -p.c_k * (v.motor - v.link);
    let half_k = 0.5 * p.k;
    let quarter_k_3 = 0.25 * p.k_3;
    let two_motor_minus_link = 2.0 * motor_minus_link;
    let two_motor_minus_link_sq = 2.0 * motor_minus_link * motor_minus_link;
    // spring coil
    let coil_1 = quarter_k_3 * two_motor_minus_link * two_motor_minus_link_sq;
    let two_motor_minus_link_2 = 2.0 * motor_minus_link;
    let coil_2 = quarter_k_3 * two_motor_minus_link_sq * two_motor_minus_link_2;
    let l_per_two = p.l / 2.0;
    // body rod on arm
    let mc_arm_z = -p.m * l_per_two;
    let I_arm_xx = I_l - l_per_two * mc_arm_z;
    // kinetic energy rotor
    let h_link = -half_k * two_motor_minus_link_2 - coil_2 - p.g * mc_arm_z * s_link;
    // balance of forces
    let tau_motor = d_link - p.c_m * v.motor - half_k * two_motor_minus_link - coil_1 + u.tau;
    // M = L^T D L and back-substitution
    let link_ddot = (-d_link - h_link) / I_arm_xx;
    positive(I_arm_xx, 1)?;
    positive(p.J, 0)?;
    Ok(Accelerations::from_array([tau_motor / p.J, link_ddot]))
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
/// 74 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///          motor link motor.dot link.dot | tau
/// motor'   .     .    1         .        | .
/// link'    .     .    .         1        | .
/// motor''  *     *    *         *        | *
/// link''   *     *    *         *        | .
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_link, c_link) = sin_cos(q.link);
    let I_l = p.m * p.l * p.l / 12.0;
    let motor_minus_link = q.motor - q.link;
    // friction of within
    let d_link = -p.c_k * (v.motor - v.link);
    let motor_minus_link_sq = motor_minus_link * motor_minus_link;
    let half_k = 0.5 * p.k;
    let quarter_k_3 = 0.25 * p.k_3;
    let two_motor_minus_link = 2.0 * motor_minus_link;
    let two_motor_minus_link_sq = 2.0 * motor_minus_link_sq;
    // spring coil
    let coil_1 = quarter_k_3 * two_motor_minus_link * two_motor_minus_link_sq;
    let two_motor_minus_link_2 = 2.0 * motor_minus_link;
    let coil_2 = quarter_k_3 * two_motor_minus_link_sq * two_motor_minus_link_2;
    let l_per_two = p.l / 2.0;
    // body rod on arm
    let mc_arm_z = -p.m * l_per_two;
    let I_arm_xx = I_l - l_per_two * mc_arm_z;
    // kinetic energy rotor
    let h_link = -half_k * two_motor_minus_link_2 - coil_2 - p.g * mc_arm_z * s_link;
    // balance of forces
    let tau_motor = d_link - p.c_m * v.motor - half_k * two_motor_minus_link - coil_1 + u.tau;
    // M = L^T D L and back-substitution
    let inv_link = 1.0 / I_arm_xx;
    let inv_motor = 1.0 / p.J;
    let four_motor_minus_link = 4.0 * motor_minus_link;
    let four_motor_minus_link_sq = 4.0 * motor_minus_link_sq;
    // derivatives with respect to motor
    let by_motor_1 = p.k + quarter_k_3 * (four_motor_minus_link_sq + two_motor_minus_link * four_motor_minus_link);
    let four_motor_minus_link_sq_2 = 4.0 * motor_minus_link_sq;
    let by_motor_2 = p.k - quarter_k_3 * (-two_motor_minus_link_2 * four_motor_minus_link - four_motor_minus_link_sq_2);
    let four_motor_minus_link_2 = 4.0 * motor_minus_link;
    // derivatives with respect to link
    let by_link_1 = p.k + quarter_k_3 * (four_motor_minus_link_sq + two_motor_minus_link_2 * four_motor_minus_link_2);
    let by_link_2 = p.k - quarter_k_3 * (-four_motor_minus_link_sq_2 - two_motor_minus_link * four_motor_minus_link_2);
    let d_link_ddot_by_link = -inv_link * (by_link_1 - p.g * mc_arm_z * c_link);
    // derivatives with respect to motor_dot
    let d_link_ddot_by_motor_dot = p.c_k * inv_link;
    positive(I_arm_xx, 1)?;
    positive(p.J, 0)?;
    Ok(Linearization {
        dx: [v.motor, v.link, tau_motor * inv_motor, inv_link * (-d_link - h_link)],
        a: [
            [0.0, 0.0, 1.0, 0.0], // motor'
            [0.0, 0.0, 0.0, 1.0], // link'
            [-inv_motor * by_motor_1, inv_motor * by_link_2, -inv_motor * (p.c_k + p.c_m), p.c_k * inv_motor], // motor''
            [inv_link * by_motor_2, d_link_ddot_by_link, d_link_ddot_by_motor_dot, -d_link_ddot_by_motor_dot], // link''
        ],
        b: [[0.0], [0.0], [inv_motor], [0.0]],
    })
}

/// Parameter Jacobian dx'/dp, 4 x 8; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 8]; 4], Singular> {
    let State { q, v } = x;
    let s_link = sin(q.link);
    let l_sq = p.l * p.l;
    let motor_minus_link = q.motor - q.link;
    let motor_dot_minus_link_dot = v.motor - v.link;
    // friction of within
    let d_link = -p.c_k * motor_dot_minus_link_dot;
    let half_k = 0.5 * p.k;
    let quarter_k_3 = 0.25 * p.k_3;
    let two_motor_minus_link = 2.0 * motor_minus_link;
    let two_motor_minus_link_sq = 2.0 * motor_minus_link * motor_minus_link;
    // spring coil
    let coil_1 = two_motor_minus_link * two_motor_minus_link_sq;
    let h_motor = half_k * two_motor_minus_link + quarter_k_3 * coil_1;
    let two_motor_minus_link_2 = 2.0 * motor_minus_link;
    let coil_2 = two_motor_minus_link_sq * two_motor_minus_link_2;
    let coil_3 = half_k * two_motor_minus_link_2 + quarter_k_3 * coil_2;
    let l_per_two = p.l / 2.0;
    // body rod on arm
    let mc_arm_z = -p.m * l_per_two;
    let I_arm_xx = p.m * l_sq / 12.0 - l_per_two * mc_arm_z;
    // frame arm on ground
    let a_arm_x = p.g * s_link;
    // balance of forces
    let tau_motor = d_link - p.c_m * v.motor - h_motor + u.tau;
    let tau_link = coil_3 - d_link + mc_arm_z * a_arm_x;
    // M = L^T D L and back-substitution
    let inv_link = 1.0 / I_arm_xx;
    let inv_motor = 1.0 / p.J;
    let link_ddot = tau_link * inv_link;
    let half_m = 0.5 * p.m;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = link_ddot * (l_sq / 12.0 + l_per_two * l_per_two);
    let slopes_2 = link_ddot * (2.0 * p.m * p.l / 12.0 - 0.5 * mc_arm_z + l_per_two * half_m);
    // derivatives with respect to m
    let d_link_ddot_by_m = -inv_link * (l_per_two * a_arm_x + slopes_1);
    // derivatives with respect to l
    let d_link_ddot_by_l = -inv_link * (a_arm_x * half_m + slopes_2);
    positive(I_arm_xx, 1)?;
    positive(p.J, 0)?;
    Ok([
        [0.0; 8], // motor'
        [0.0; 8], // link'
        // motor''
        Parameters {
            J: -inv_motor * tau_motor * inv_motor,
            k: inv_motor * (q.link - q.motor),
            k_3: -0.25 * inv_motor * coil_1,
            c_k: inv_motor * (v.link - v.motor),
            c_m: -inv_motor * v.motor,
            ..Parameters::ZERO
        }
        .to_array(),
        // link''
        Parameters {
            m: d_link_ddot_by_m,
            l: d_link_ddot_by_l,
            k: motor_minus_link * inv_link,
            k_3: 0.25 * inv_link * coil_2,
            c_k: motor_dot_minus_link_dot * inv_link,
            g: mc_arm_z * inv_link * s_link,
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
    /// dy/dp, 2 x 8.
    pub by_p: [[f64; 8]; 2],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]],
        by_p: [
            [0.0; 8], // motor
            [0.0; 8], // link
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 4] = ["motor", "link", "motor.dot", "link.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 1] = ["tau"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 8] = ["m", "l", "J", "k", "k_3", "c_k", "c_m", "g"];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 8] = ["kg", "m", "kg*m^2", "N*m", "N*m", "N*m*s", "N*m*s", "m/s^2"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 2] = ["motor", "link"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 2] = ["rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FlexibleJoint;

impl Names for FlexibleJoint {
    fn rig(&self) -> &str {
        "FlexibleJoint"
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

impl Model for FlexibleJoint {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 2, lags: 0, inputs: 1, exogenous: 0, parameters: 8, outputs: 2 }
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
