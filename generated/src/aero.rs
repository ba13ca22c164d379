//! Quanser Aero, two degrees of freedom.
//! Generated from `aero.rig` (model dcde74f4); edit the rig, not this file.
//!
//! A beam with two rotors at its ends on a yoke that turns: the main rotor lifts, the tail rotor pushes
//! sideways, and each turns the beam by its drag too. Speeds follow the voltages. Geometry, masses and
//! coefficients: extended Kalman filter of an NTNU master thesis, 2025
//! (github.com/finnferdinand/orbital-stabilization-quanser-aero); its yaw inertia leaves out
//! m_e d_x^2 (at most 0.3 %), which comes out here.
//!
//! 67 operations forward, 155 with A and B.
//! Derived twice, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::{abs, cos, sign, sin, sin_cos};
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular, positive};

/// Parameters p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// propeller assembly, each [kg]
    pub m_pa: f64,
    /// motor, each; and the mass that hangs below the axis [kg]
    pub m_e: f64,
    /// beam: 0.089 + 0.089 + 0.280 [kg]
    pub m_rod: f64,
    /// yoke [kg]
    pub m_y: f64,
    /// pitch axis to each rotor [m]
    pub d_t: f64,
    /// pitch axis down to the hanging mass [m]
    pub d_x: f64,
    /// length of the beam [m]
    pub l_t: f64,
    /// radius of the yoke [m]
    pub r_y: f64,
    /// g [m/s^2]
    pub g: f64,
    /// speed of a rotor by its voltage [rad/(V*s)]
    pub K_omega: f64,
    /// thrust of the main rotor by speed squared [N*s^2]
    pub K_main: f64,
    /// thrust of the tail rotor by speed squared [N*s^2]
    pub K_tail: f64,
    /// drag torque of the main rotor by speed squared, over d_t [N*s^2]
    pub D_main: f64,
    /// drag torque of the tail rotor by speed squared, over d_t [N*s^2]
    pub D_tail: f64,
    /// c_pitch [N*m*s]
    pub c_pitch: f64,
    /// c_yaw [N*m*s]
    pub c_yaw: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m_pa: 0.146,
        m_e: 0.2,
        m_rod: 0.458,
        m_y: 0.526,
        d_t: 0.158,
        d_x: 0.016,
        l_t: 0.165,
        r_y: 0.02,
        g: 9.81,
        K_omega: 17.38,
        K_main: 1.26e-6,
        K_tail: 1.26e-6,
        D_main: 1.08e-6,
        D_tail: 1.08e-6,
        c_pitch: 0.0031,
        c_yaw: 0.0075,
    };

    /// All zero: where derivatives with respect to the parameters start from.
    const ZERO: Self = Self::from_array([0.0; 16]);

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 16]) -> Self {
        let [m_pa, m_e, m_rod, m_y, d_t, d_x, l_t, r_y, g, K_omega, K_main, K_tail, D_main, D_tail, c_pitch, c_yaw] = values;
        Self { m_pa, m_e, m_rod, m_y, d_t, d_x, l_t, r_y, g, K_omega, K_main, K_tail, D_main, D_tail, c_pitch, c_yaw }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 16] {
        [
            self.m_pa, self.m_e, self.m_rod, self.m_y, self.d_t, self.d_x, self.l_t, self.r_y, self.g, self.K_omega, self.K_main,
            self.K_tail, self.D_main, self.D_tail, self.c_pitch, self.c_yaw,
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
    /// yaw [rad]
    pub yaw: f64,
    /// nose up positive [rad]
    pub pitch: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [yaw, pitch] = values;
        Self { yaw, pitch }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.yaw, self.pitch]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// yaw.dot [rad/s]
    pub yaw: f64,
    /// nose up positive [rad/s]
    pub pitch: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [yaw, pitch] = values;
        Self { yaw, pitch }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.yaw, self.pitch]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// yaw.ddot [rad/s^2]
    pub yaw: f64,
    /// nose up positive [rad/s^2]
    pub pitch: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [yaw, pitch] = values;
        Self { yaw, pitch }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.yaw, self.pitch]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// main motor [V]
    pub V_m: f64,
    /// tail motor [V]
    pub V_t: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [V_m, V_t] = values;
        Self { V_m, V_t }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.V_m, self.V_t]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// yaw [rad]
    pub yaw: f64,
    /// pitch [rad]
    pub pitch: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 2]) -> Self {
        let [yaw, pitch] = values;
        Self { yaw, pitch }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 2] {
        [self.yaw, self.pitch]
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

/// Mass matrix M(q), 2 x 2, symmetric; rows (yaw, pitch).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 2]; 2] {
    let c_pitch = cos(q.pitch);
    let I_rod = p.m_rod * p.l_t * p.l_t / 12.0;
    let I_y = p.m_y * p.r_y * p.r_y / 2.0;
    let d_t_d_t_m_pa_plus_m_e = p.d_t * p.d_t * (p.m_pa + p.m_e);
    // frame beam on yoke
    let I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    // body hanging on beam
    let I_beam_xx = p.m_e * p.d_x * p.d_x;
    // frame yoke on ground
    let M_yaw_yaw = I_y + I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    [[M_yaw_yaw, 0.0], [0.0, I_beam_zz + I_beam_xx]]
}

/// Bias h(q, v) [N m]: velocity products + gravity + springs; rows (yaw, pitch).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let I_rod = p.m_rod * p.l_t * p.l_t / 12.0;
    let d_t_d_t_m_pa_plus_m_e = p.d_t * p.d_t * (p.m_pa + p.m_e);
    // frame beam on yoke
    let I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    let omega_beam_z = c_pitch * v.yaw;
    let omega_beam_x = s_pitch * v.yaw;
    let n_moving_beam_z = -2.0 * I_beam_zz * omega_beam_x * v.pitch;
    // body hanging on beam
    let mc_beam_z = -p.m_e * p.d_x;
    let I_beam_xx = -p.d_x * mc_beam_z;
    // frame beam on yoke
    let n_moving_beam_y = omega_beam_z * omega_beam_x * (I_beam_xx - I_beam_zz);
    let n_moving_beam_x = 2.0 * I_beam_xx * omega_beam_z * v.pitch;
    let n_moving_yoke_z = n_moving_beam_z * c_pitch + n_moving_beam_x * s_pitch;
    let h_pitch = -p.g * mc_beam_z * s_pitch - n_moving_beam_y;
    [n_moving_yoke_z, h_pitch]
}

/// Velocity products C(q, v) v [N m]: Coriolis and centrifugal terms; rows (yaw, pitch).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let I_rod = p.m_rod * p.l_t * p.l_t / 12.0;
    let d_t_d_t_m_pa_plus_m_e = p.d_t * p.d_t * (p.m_pa + p.m_e);
    // frame beam on yoke
    let I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    let omega_beam_z = c_pitch * v.yaw;
    let omega_beam_x = s_pitch * v.yaw;
    let n_moving_beam_z = -2.0 * I_beam_zz * omega_beam_x * v.pitch;
    // body hanging on beam
    let I_beam_xx = p.m_e * p.d_x * p.d_x;
    // frame beam on yoke
    let n_moving_beam_y = omega_beam_z * omega_beam_x * (I_beam_xx - I_beam_zz);
    let n_moving_beam_x = 2.0 * I_beam_xx * omega_beam_z * v.pitch;
    let n_moving_yoke_z = n_moving_beam_z * c_pitch + n_moving_beam_x * s_pitch;
    [n_moving_yoke_z, -n_moving_beam_y]
}

/// Generalized gravity g(q) [N m]: what holds the rig still; rows (yaw, pitch).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 2] {
    let s_pitch = sin(q.pitch);
    let g_pitch = p.m_e * p.d_x * p.g * s_pitch;
    [0.0, g_pitch]
}

/// Friction and dampers d(q, v) [N m], on the left-hand side; rows (yaw, pitch).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 2] {
    [p.c_yaw * v.yaw, p.c_pitch * v.pitch]
}

/// Generalized force Q [N m] of the inputs; rows (yaw, pitch).
#[must_use]
pub fn generalized_force(q: &Coordinates, u: &Inputs, p: &Parameters) -> [f64; 2] {
    let c_pitch = cos(q.pitch);
    let w_m = p.K_omega * u.V_m;
    let w_t = p.K_omega * u.V_t;
    let abs_w_m = abs(w_m);
    let abs_w_t = abs(w_t);
    // force push on beam
    let n_applied_beam_z = p.d_t * p.K_tail * w_t * abs_w_t - p.d_t * p.D_main * abs_w_m * w_m;
    // torque drag_tail on beam
    let n_applied_beam_y = -p.d_t * p.K_main * w_m * abs_w_m - p.d_t * p.D_tail * abs_w_t * w_t;
    [n_applied_beam_z * c_pitch, -n_applied_beam_y]
}

/// Input map dQ/du, 2 x 2; rows (yaw, pitch), columns (V_m, V_t).
#[must_use]
pub fn input_map(q: &Coordinates, u: &Inputs, p: &Parameters) -> [[f64; 2]; 2] {
    let c_pitch = cos(q.pitch);
    let w_m = p.K_omega * u.V_m;
    let w_t = p.K_omega * u.V_t;
    let abs_w_m = abs(w_m);
    let d_t_D_main = p.d_t * p.D_main;
    let abs_w_t = abs(w_t);
    let d_t_D_tail = p.d_t * p.D_tail;
    let K_omega_sign_w_m = p.K_omega * sign(w_m);
    let K_omega_abs_w_m_d_t_D_main = p.K_omega * abs_w_m * d_t_D_main;
    let K_omega_sign_w_t = p.K_omega * sign(w_t);
    // input map
    let input_map_1 = p.d_t * (p.K_omega * p.K_tail * abs_w_t + p.K_tail * w_t * K_omega_sign_w_t);
    let K_omega_abs_w_t_d_t_D_tail = p.K_omega * abs_w_t * d_t_D_tail;
    [
        [-c_pitch * (w_m * d_t_D_main * K_omega_sign_w_m + K_omega_abs_w_m_d_t_D_main), input_map_1 * c_pitch], // yaw
        // pitch
        [
            p.d_t * (p.K_omega * p.K_main * abs_w_m + p.K_main * w_m * K_omega_sign_w_m),
            w_t * d_t_D_tail * K_omega_sign_w_t + K_omega_abs_w_t_d_t_D_tail,
        ],
    ]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let I_rod = p.m_rod * p.l_t * p.l_t / 12.0;
    let I_y = p.m_y * p.r_y * p.r_y / 2.0;
    // frame beam on yoke
    let omega_beam_z = c_pitch * v.yaw;
    // body rod on beam
    let rod_1 = 0.5 * I_y * v.yaw * v.yaw + 0.5 * (I_rod * v.pitch * v.pitch + omega_beam_z * I_rod * omega_beam_z);
    let d_t_omega_beam_z = p.d_t * omega_beam_z;
    let d_t_pitch_dot = p.d_t * v.pitch;
    // body main_rotor on beam
    let main_rotor_1 = d_t_omega_beam_z * d_t_omega_beam_z + d_t_pitch_dot * d_t_pitch_dot;
    let main_rotor_2 = 0.5 * main_rotor_1 * (p.m_pa + p.m_e);
    let d_x_pitch_dot = p.d_x * v.pitch;
    let d_x_s_pitch_yaw_dot = p.d_x * s_pitch * v.yaw;
    // body hanging on beam
    let hanging_1 = 0.5 * p.m_e * (d_x_pitch_dot * d_x_pitch_dot + d_x_s_pitch_yaw_dot * d_x_s_pitch_yaw_dot);
    main_rotor_2 + rod_1 + main_rotor_2 + hanging_1
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let c_pitch = cos(q.pitch);
    -p.m_e * p.d_x * p.g * c_pitch
}

/// Inverse dynamics M a + h + d - Q [N m]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 2] {
    let State { q, v } = x;
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let I_rod = p.m_rod * p.l_t * p.l_t / 12.0;
    let I_y = p.m_y * p.r_y * p.r_y / 2.0;
    let w_m = p.K_omega * u.V_m;
    let w_t = p.K_omega * u.V_t;
    let d_t_d_t_m_pa_plus_m_e = p.d_t * p.d_t * (p.m_pa + p.m_e);
    // frame beam on yoke
    let I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    let omega_beam_z = c_pitch * v.yaw;
    let omega_beam_x = s_pitch * v.yaw;
    let alpha_beam_x = omega_beam_z * v.pitch;
    let alpha_beam_z = -omega_beam_x * v.pitch;
    // body hanging on beam
    let mc_beam_z = -p.m_e * p.d_x;
    let I_beam_xx = -p.d_x * mc_beam_z;
    // frame beam on yoke
    let n_moving_beam_y = omega_beam_z * omega_beam_x * (I_beam_xx - I_beam_zz);
    let n_net_beam_x = I_beam_xx * alpha_beam_x + I_beam_xx * (alpha_beam_x + s_pitch * a.yaw);
    let beam_1 = n_moving_beam_y - a.pitch * (I_beam_zz + I_beam_xx) + p.g * mc_beam_z * s_pitch;
    let abs_w_m = abs(w_m);
    let abs_w_t = abs(w_t);
    // force push on beam
    let n_applied_beam_z = p.d_t * p.K_tail * w_t * abs_w_t - p.d_t * p.D_main * abs_w_m * w_m;
    // torque drag_tail on beam
    let n_applied_beam_y = -p.d_t * p.K_main * w_m * abs_w_m - p.d_t * p.D_tail * abs_w_t * w_t;
    // frame beam on yoke
    let n_net_beam_z = I_beam_zz * (c_pitch * a.yaw + alpha_beam_z) + I_beam_zz * alpha_beam_z - n_applied_beam_z;
    // frame yoke on ground
    let n_net_yoke_z = I_y * a.yaw + n_net_beam_z * c_pitch + n_net_beam_x * s_pitch;
    [p.c_yaw * v.yaw + n_net_yoke_z, p.c_pitch * v.pitch + n_applied_beam_y - beam_1]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.yaw, q.pitch])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 2] {
    let State { q, .. } = x;
    let c_pitch = cos(q.pitch);
    let I_rod = p.m_rod * p.l_t * p.l_t / 12.0;
    let I_y = p.m_y * p.r_y * p.r_y / 2.0;
    let d_t_d_t_m_pa_plus_m_e = p.d_t * p.d_t * (p.m_pa + p.m_e);
    // frame beam on yoke
    let I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    // body hanging on beam
    let I_beam_xx = p.m_e * p.d_x * p.d_x;
    // frame yoke on ground
    let M_yaw_yaw = I_y + I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    [M_yaw_yaw, I_beam_zz + I_beam_xx]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 67 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let I_rod = p.m_rod * p.l_t * p.l_t / 12.0;
    let I_y = p.m_y * p.r_y * p.r_y / 2.0;
    let w_m = p.K_omega * u.V_m;
    let w_t = p.K_omega * u.V_t;
    let d_t_d_t_m_pa_plus_m_e = p.d_t * p.d_t * (p.m_pa + p.m_e);
    // frame beam on yoke
    let I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    let omega_beam_z = c_pitch * v.yaw;
    let omega_beam_x = s_pitch * v.yaw;
    let n_moving_beam_z = -2.0 * I_beam_zz * omega_beam_x * v.pitch;
    // body hanging on beam
    let mc_beam_z = -p.m_e * p.d_x;
    let I_beam_xx = -p.d_x * mc_beam_z;
    // frame beam on yoke
    let I_beam_yy = I_beam_zz + I_beam_xx;
    let n_moving_beam_y = omega_beam_z * omega_beam_x * (I_beam_xx - I_beam_zz);
    let n_moving_beam_x = 2.0 * I_beam_xx * omega_beam_z * v.pitch;
    let n_beam_y = n_moving_beam_y + p.g * mc_beam_z * s_pitch;
    // frame yoke on ground
    let M_yaw_yaw = I_y + I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    let abs_w_m = abs(w_m);
    let abs_w_t = abs(w_t);
    // force push on beam
    let n_applied_beam_z = p.d_t * p.K_tail * w_t * abs_w_t - p.d_t * p.D_main * abs_w_m * w_m;
    // torque drag_tail on beam
    let n_applied_beam_y = -p.d_t * p.K_main * w_m * abs_w_m - p.d_t * p.D_tail * abs_w_t * w_t;
    // frame beam on yoke
    let n_net_yoke_z = n_moving_beam_x * s_pitch + c_pitch * (n_moving_beam_z - n_applied_beam_z);
    // balance of forces
    let tau_pitch = n_beam_y - n_applied_beam_y - p.c_pitch * v.pitch;
    // M = L^T D L and back-substitution
    let yaw_ddot = -(p.c_yaw * v.yaw + n_net_yoke_z) / M_yaw_yaw;
    positive(I_beam_yy, 1)?;
    positive(M_yaw_yaw, 0)?;
    Ok(Accelerations::from_array([yaw_ddot, tau_pitch / I_beam_yy]))
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
/// 155 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///          yaw pitch yaw.dot pitch.dot | V_m V_t
/// yaw'     .   .     1       .         | .   .
/// pitch'   .   .     .       1         | .   .
/// yaw''    .   *     *       *         | *   *
/// pitch''  .   *     *       *         | *   *
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let I_rod = p.m_rod * p.l_t * p.l_t / 12.0;
    let I_y = p.m_y * p.r_y * p.r_y / 2.0;
    let w_m = p.K_omega * u.V_m;
    let w_t = p.K_omega * u.V_t;
    let d_t_d_t_m_pa_plus_m_e = p.d_t * p.d_t * (p.m_pa + p.m_e);
    // frame beam on yoke
    let I_beam_zz = d_t_d_t_m_pa_plus_m_e + I_rod + d_t_d_t_m_pa_plus_m_e;
    let omega_beam_z = c_pitch * v.yaw;
    let omega_beam_x = s_pitch * v.yaw;
    let alpha_beam_x = omega_beam_z * v.pitch;
    let alpha_beam_z = -omega_beam_x * v.pitch;
    let I_beam_zz_alpha_beam_z = I_beam_zz * alpha_beam_z;
    // body hanging on beam
    let mc_beam_z = -p.m_e * p.d_x;
    let I_beam_xx = -p.d_x * mc_beam_z;
    // frame beam on yoke
    let I_beam_yy = I_beam_zz + I_beam_xx;
    let I_beam_xx_alpha_beam_x = I_beam_xx * alpha_beam_x;
    let I_beam_xx_minus_I_beam_zz = I_beam_xx - I_beam_zz;
    let n_beam_y = omega_beam_z * omega_beam_x * I_beam_xx_minus_I_beam_zz + p.g * mc_beam_z * s_pitch;
    // frame yoke on ground
    let M_yaw_yaw = I_y + I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    let K_main_w_m = p.K_main * w_m;
    let abs_w_m = abs(w_m);
    let d_t_D_main = p.d_t * p.D_main;
    let w_m_d_t_D_main = w_m * d_t_D_main;
    let K_tail_w_t = p.K_tail * w_t;
    let abs_w_t = abs(w_t);
    // force push on beam
    let n_applied_beam_z = p.d_t * K_tail_w_t * abs_w_t - abs_w_m * w_m_d_t_D_main;
    let d_t_D_tail = p.d_t * p.D_tail;
    let w_t_d_t_D_tail = w_t * d_t_D_tail;
    // torque drag_tail on beam
    let n_applied_beam_y = -p.d_t * K_main_w_m * abs_w_m - abs_w_t * w_t_d_t_D_tail;
    // frame beam on yoke
    let beam_1 = c_pitch * (2.0 * I_beam_zz_alpha_beam_z - n_applied_beam_z);
    let n_net_yoke_z = 2.0 * I_beam_xx_alpha_beam_x * s_pitch + beam_1;
    // balance of forces
    let tau_pitch = n_beam_y - n_applied_beam_y - p.c_pitch * v.pitch;
    // M = L^T D L and back-substitution
    let inv_pitch = 1.0 / I_beam_yy;
    let inv_yaw = 1.0 / M_yaw_yaw;
    let yaw_ddot = -inv_yaw * (p.c_yaw * v.yaw + n_net_yoke_z);
    let K_omega_sign_w_m = p.K_omega * sign(w_m);
    // input map
    let input_map_1 = p.d_t * (p.K_omega * p.K_main * abs_w_m + K_main_w_m * K_omega_sign_w_m);
    let input_map_2 = w_m_d_t_D_main * K_omega_sign_w_m + p.K_omega * abs_w_m * d_t_D_main;
    let K_omega_sign_w_t = p.K_omega * sign(w_t);
    let input_map_3 = p.d_t * (p.K_omega * p.K_tail * abs_w_t + K_tail_w_t * K_omega_sign_w_t);
    let input_map_4 = w_t_d_t_D_tail * K_omega_sign_w_t + p.K_omega * abs_w_t * d_t_D_tail;
    // derivatives with respect to pitch
    let by_pitch_1 = I_beam_xx_minus_I_beam_zz * (omega_beam_z * omega_beam_z - omega_beam_x * omega_beam_x);
    let d_pitch_ddot_by_pitch = inv_pitch * (by_pitch_1 + p.g * mc_beam_z * c_pitch);
    // derivatives with respect to yaw_dot
    let by_yaw_dot_1 = I_beam_xx_minus_I_beam_zz * (omega_beam_x * c_pitch + omega_beam_z * s_pitch);
    let by_yaw_dot_2 = 2.0 * I_beam_zz * c_pitch * s_pitch * v.pitch;
    let by_yaw_dot_3 = p.c_yaw - by_yaw_dot_2 + 2.0 * I_beam_xx * s_pitch * c_pitch * v.pitch;
    // derivatives with respect to pitch_dot
    let by_pitch_dot_1 = 2.0 * I_beam_zz * omega_beam_x * c_pitch;
    let d_yaw_ddot_by_pitch_dot = -inv_yaw * (2.0 * I_beam_xx * omega_beam_z * s_pitch - by_pitch_dot_1);
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_beam_x + yaw_ddot * s_pitch;
    let slopes_2 = alpha_beam_z + yaw_ddot * c_pitch;
    let slopes_3 = s_pitch * (n_applied_beam_z - I_beam_zz_alpha_beam_z - I_beam_zz * slopes_2);
    let slopes_4 = c_pitch * (I_beam_zz * alpha_beam_x + I_beam_zz * slopes_1) - slopes_3;
    let slopes_5 = s_pitch * (-I_beam_xx * alpha_beam_z - I_beam_xx * slopes_2);
    let slopes_6 = c_pitch * (I_beam_xx_alpha_beam_x + I_beam_xx * slopes_1) - slopes_5;
    positive(I_beam_yy, 1)?;
    positive(M_yaw_yaw, 0)?;
    Ok(Linearization {
        dx: [v.yaw, v.pitch, yaw_ddot, tau_pitch * inv_pitch],
        a: [
            [0.0, 0.0, 1.0, 0.0], // yaw'
            [0.0, 0.0, 0.0, 1.0], // pitch'
            [0.0, inv_yaw * (slopes_4 - slopes_6), -inv_yaw * by_yaw_dot_3, d_yaw_ddot_by_pitch_dot], // yaw''
            [0.0, d_pitch_ddot_by_pitch, inv_pitch * by_yaw_dot_1, -p.c_pitch * inv_pitch], // pitch''
        ],
        b: [
            [0.0, 0.0], // yaw'
            [0.0, 0.0], // pitch'
            [-inv_yaw * input_map_2 * c_pitch, inv_yaw * input_map_3 * c_pitch], // yaw''
            [inv_pitch * input_map_1, inv_pitch * input_map_4], // pitch''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 4 x 16; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 16]; 4], Singular> {
    let State { q, v } = x;
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let l_t_sq = p.l_t * p.l_t;
    let r_y_sq = p.r_y * p.r_y;
    let w_m = p.K_omega * u.V_m;
    let w_t = p.K_omega * u.V_t;
    let d_t_m_pa_plus_m_e = p.d_t * (p.m_pa + p.m_e);
    let d_t_d_t_m_pa_plus_m_e = p.d_t * d_t_m_pa_plus_m_e;
    // frame beam on yoke
    let I_beam_zz = d_t_d_t_m_pa_plus_m_e + p.m_rod * l_t_sq / 12.0 + d_t_d_t_m_pa_plus_m_e;
    let omega_beam_z = c_pitch * v.yaw;
    let omega_beam_x = s_pitch * v.yaw;
    let alpha_beam_x = omega_beam_z * v.pitch;
    let alpha_beam_z = -omega_beam_x * v.pitch;
    let omega_beam_z_omega_beam_x = omega_beam_z * omega_beam_x;
    let a_beam_x = p.g * s_pitch;
    // body hanging on beam
    let mc_beam_z = -p.m_e * p.d_x;
    let I_beam_xx = -p.d_x * mc_beam_z;
    // frame beam on yoke
    let I_beam_yy = I_beam_zz + I_beam_xx;
    let n_beam_y = omega_beam_z_omega_beam_x * (I_beam_xx - I_beam_zz) + mc_beam_z * a_beam_x;
    let beam_1 = I_beam_xx + c_pitch * c_pitch * (I_beam_zz - I_beam_xx);
    // frame yoke on ground
    let M_yaw_yaw = p.m_y * r_y_sq / 2.0 + beam_1;
    let K_main_w_m = p.K_main * w_m;
    let abs_w_m = abs(w_m);
    // force lift on beam
    let f_applied_beam_z = K_main_w_m * abs_w_m;
    let d_t_D_main = p.d_t * p.D_main;
    let w_m_d_t_D_main = w_m * d_t_D_main;
    let K_tail_w_t = p.K_tail * w_t;
    let abs_w_t = abs(w_t);
    // force push on beam
    let f_applied_beam_y = -K_tail_w_t * abs_w_t;
    let n_applied_beam_z = -p.d_t * f_applied_beam_y - abs_w_m * w_m_d_t_D_main;
    let d_t_D_tail = p.d_t * p.D_tail;
    let w_t_d_t_D_tail = w_t * d_t_D_tail;
    // torque drag_tail on beam
    let n_applied_beam_y = -p.d_t * f_applied_beam_z - abs_w_t * w_t_d_t_D_tail;
    // frame beam on yoke
    let n_net_beam_z = 2.0 * I_beam_zz * alpha_beam_z - n_applied_beam_z;
    let n_net_yoke_z = 2.0 * I_beam_xx * alpha_beam_x * s_pitch + n_net_beam_z * c_pitch;
    // balance of forces
    let tau_pitch = n_beam_y - n_applied_beam_y - p.c_pitch * v.pitch;
    // M = L^T D L and back-substitution
    let inv_pitch = 1.0 / I_beam_yy;
    let inv_yaw = 1.0 / M_yaw_yaw;
    let yaw_ddot = -inv_yaw * (p.c_yaw * v.yaw + n_net_yoke_z);
    let pitch_ddot = tau_pitch * inv_pitch;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_beam_x + yaw_ddot * s_pitch;
    let slopes_2 = alpha_beam_z + yaw_ddot * c_pitch;
    let d_t_sq = p.d_t * p.d_t;
    let two_d_t_sq = 2.0 * d_t_sq;
    // derivatives with respect to m_pa
    let d_pitch_ddot_by_m_pa = inv_pitch * (-2.0 * omega_beam_z_omega_beam_x * d_t_sq - pitch_ddot * two_d_t_sq);
    let d_x_sq = p.d_x * p.d_x;
    // derivatives with respect to m_e
    let by_m_e_1 = omega_beam_z_omega_beam_x * (d_x_sq - two_d_t_sq);
    let by_m_e_2 = by_m_e_1 - pitch_ddot * (two_d_t_sq + d_x_sq) - p.d_x * a_beam_x;
    let l_t_sq_per_12 = l_t_sq / 12.0;
    // derivatives with respect to m_rod
    let d_pitch_ddot_by_m_rod = -inv_pitch * (omega_beam_z_omega_beam_x * l_t_sq_per_12 + pitch_ddot * l_t_sq_per_12);
    let four_d_t_m_pa_plus_m_e = 4.0 * d_t_m_pa_plus_m_e;
    let two_mc_beam_z = 2.0 * mc_beam_z;
    // derivatives with respect to d_x
    let by_d_x_1 = pitch_ddot * two_mc_beam_z - omega_beam_z_omega_beam_x * two_mc_beam_z - p.m_e * a_beam_x;
    let two_m_rod_l_t_per_12 = 2.0 * p.m_rod * p.l_t / 12.0;
    // derivatives with respect to l_t
    let d_pitch_ddot_by_l_t = -inv_pitch * (omega_beam_z_omega_beam_x * two_m_rod_l_t_per_12 + pitch_ddot * two_m_rod_l_t_per_12);
    let sign_w_m_V_m = sign(w_m) * u.V_m;
    // derivatives with respect to K_omega
    let by_K_omega_1 = p.d_t * (p.K_main * abs_w_m * u.V_m + K_main_w_m * sign_w_m_V_m);
    let by_K_omega_2 = w_m_d_t_D_main * sign_w_m_V_m + abs_w_m * d_t_D_main * u.V_m;
    let sign_w_t_V_t = sign(w_t) * u.V_t;
    let by_K_omega_3 = p.d_t * (p.K_tail * abs_w_t * u.V_t + K_tail_w_t * sign_w_t_V_t);
    let by_K_omega_4 = w_t_d_t_D_tail * sign_w_t_V_t + abs_w_t * d_t_D_tail * u.V_t;
    let d_yaw_ddot_by_K_omega = -inv_yaw * c_pitch * (by_K_omega_2 - by_K_omega_3);
    // slopes of the balance of forces, at the accelerations found
    let slopes_3 = c_pitch * (-alpha_beam_z * two_d_t_sq - slopes_2 * two_d_t_sq);
    let slopes_4 = s_pitch * (alpha_beam_x * d_x_sq + slopes_1 * d_x_sq);
    let slopes_5 = c_pitch * (-alpha_beam_z * l_t_sq_per_12 - slopes_2 * l_t_sq_per_12);
    let slopes_6 = 4.0 * omega_beam_z_omega_beam_x * d_t_m_pa_plus_m_e + pitch_ddot * four_d_t_m_pa_plus_m_e;
    let slopes_7 = alpha_beam_z * four_d_t_m_pa_plus_m_e + slopes_2 * four_d_t_m_pa_plus_m_e;
    let slopes_8 = c_pitch * (-f_applied_beam_y - p.D_main * abs_w_m * w_m - slopes_7);
    let slopes_9 = s_pitch * (-alpha_beam_x * two_mc_beam_z - slopes_1 * two_mc_beam_z);
    let slopes_10 = c_pitch * (-alpha_beam_z * two_m_rod_l_t_per_12 - slopes_2 * two_m_rod_l_t_per_12);
    // derivatives with respect to m_y
    let d_yaw_ddot_by_m_y = -inv_yaw * yaw_ddot * r_y_sq / 2.0;
    // derivatives with respect to d_t
    let d_pitch_ddot_by_d_t = inv_pitch * (f_applied_beam_z + p.D_tail * abs_w_t * w_t - slopes_6);
    // derivatives with respect to r_y
    let d_yaw_ddot_by_r_y = -2.0 * p.m_y * p.r_y * inv_yaw * yaw_ddot / 2.0;
    // derivatives with respect to K_main
    let d_pitch_ddot_by_K_main = p.d_t * inv_pitch * w_m * abs_w_m;
    // derivatives with respect to K_tail
    let d_yaw_ddot_by_K_tail = p.d_t * inv_yaw * w_t * abs_w_t * c_pitch;
    // derivatives with respect to D_main
    let d_yaw_ddot_by_D_main = -p.d_t * inv_yaw * abs_w_m * w_m * c_pitch;
    // derivatives with respect to D_tail
    let d_pitch_ddot_by_D_tail = p.d_t * inv_pitch * abs_w_t * w_t;
    positive(I_beam_yy, 1)?;
    positive(M_yaw_yaw, 0)?;
    Ok([
        [0.0; 16], // yaw'
        [0.0; 16], // pitch'
        // yaw''
        Parameters {
            m_pa: inv_yaw * slopes_3,
            m_e: inv_yaw * (slopes_3 - slopes_4),
            m_rod: inv_yaw * slopes_5,
            m_y: d_yaw_ddot_by_m_y,
            d_t: inv_yaw * slopes_8,
            d_x: -inv_yaw * slopes_9,
            l_t: inv_yaw * slopes_10,
            r_y: d_yaw_ddot_by_r_y,
            K_omega: d_yaw_ddot_by_K_omega,
            K_tail: d_yaw_ddot_by_K_tail,
            D_main: d_yaw_ddot_by_D_main,
            c_yaw: -inv_yaw * v.yaw,
            ..Parameters::ZERO
        }
        .to_array(),
        // pitch''
        Parameters {
            m_pa: d_pitch_ddot_by_m_pa,
            m_e: inv_pitch * by_m_e_2,
            m_rod: d_pitch_ddot_by_m_rod,
            d_t: d_pitch_ddot_by_d_t,
            d_x: inv_pitch * by_d_x_1,
            l_t: d_pitch_ddot_by_l_t,
            g: mc_beam_z * inv_pitch * s_pitch,
            K_omega: inv_pitch * (by_K_omega_1 + by_K_omega_4),
            K_main: d_pitch_ddot_by_K_main,
            D_tail: d_pitch_ddot_by_D_tail,
            c_pitch: -inv_pitch * v.pitch,
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
    /// dy/dp, 2 x 16.
    pub by_p: [[f64; 16]; 2],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]],
        by_p: [
            [0.0; 16], // yaw
            [0.0; 16], // pitch
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 4] = ["yaw", "pitch", "yaw.dot", "pitch.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 2] = ["V_m", "V_t"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 16] = [
    "m_pa", "m_e", "m_rod", "m_y", "d_t", "d_x", "l_t", "r_y", "g", "K_omega", "K_main", "K_tail", "D_main", "D_tail", "c_pitch", "c_yaw",
];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 16] = [
    "kg", "kg", "kg", "kg", "m", "m", "m", "m", "m/s^2", "rad/(V*s)", "N*s^2", "N*s^2", "N*s^2", "N*s^2", "N*m*s", "N*m*s",
];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 2] = ["yaw", "pitch"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 2] = ["rad", "rad"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Aero;

impl Names for Aero {
    fn rig(&self) -> &str {
        "Aero"
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

impl Model for Aero {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 2, lags: 0, inputs: 2, exogenous: 0, parameters: 16, outputs: 2 }
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
            0 => InputPath { limits: (-24.0, 24.0), delay: 0.0 },
            1 => InputPath { limits: (-24.0, 24.0), delay: 0.0 },
            _ => InputPath { limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0 },
        }
    }

    fn output_path(&self, i: usize, _p: &[f64]) -> OutputPath {
        match i {
            0 => OutputPath { quantum: 0.0015339807878856412, wrapped: false, delay: 0.0, play: 0.0 },
            1 => OutputPath { quantum: 0.0030679615757712823, wrapped: false, delay: 0.0, play: 0.0 },
            _ => OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false },
        }
    }
}
