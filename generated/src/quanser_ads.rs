//! Quanser 3-DOF helicopter with the active disturbance system, its carriage moved from outside.
//! Generated from `quanser_ads.rig` (model cb3099e2); edit the rig, not this file.
//!
//! A carriage on a ball screw slides along the arm and disturbs elevation and travel. Here its position
//! loop is taken to be stiff: its acceleration s.ddot is a signal, and it reacts on the arm. Travel
//! 11 in with home in the middle, at most 0.08 m/s (Quanser's manual of the active disturbance system); the
//! carriage's mass and the rail's place along the arm are not published.
//!
//! 189 operations forward, 706 with A and B.
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
    /// helicopter: both rotors [kg]
    pub m_h: f64,
    /// counterweight [kg]
    pub m_w: f64,
    /// elevation axis to pitch axis [m]
    pub L_a: f64,
    /// elevation axis to counterweight [m]
    pub L_w: f64,
    /// pitch axis to each rotor [m]
    pub L_h: f64,
    /// elevation axis down to the arm; not published [m]
    pub d: f64,
    /// thrust of a rotor by its voltage [N/V]
    pub K_f: f64,
    /// not published [N*m*s]
    pub c_travel: f64,
    /// not published [N*m*s]
    pub c_elevation: f64,
    /// not published [N*m*s]
    pub c_pitch: f64,
    /// g [m/s^2]
    pub g: f64,
    /// carriage; not published [kg]
    pub m_s: f64,
    /// elevation axis to home, along the arm; not published [m]
    pub s_0: f64,
}

impl Parameters {
    /// The values that the rig's file gives.
    pub const NOMINAL: Self = Self {
        m_h: 1.308,
        m_w: 1.924,
        L_a: 0.6604,
        L_w: 0.4699,
        L_h: 0.1778,
        d: 0.02,
        K_f: 0.1188,
        c_travel: 0.1,
        c_elevation: 0.1,
        c_pitch: 0.01,
        g: 9.81,
        m_s: 0.3,
        s_0: 0.0,
    };

    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 13]) -> Self {
        let [m_h, m_w, L_a, L_w, L_h, d, K_f, c_travel, c_elevation, c_pitch, g, m_s, s_0] = values;
        Self { m_h, m_w, L_a, L_w, L_h, d, K_f, c_travel, c_elevation, c_pitch, g, m_s, s_0 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 13] {
        [
            self.m_h, self.m_w, self.L_a, self.L_w, self.L_h, self.d, self.K_f, self.c_travel, self.c_elevation, self.c_pitch, self.g,
            self.m_s, self.s_0,
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
    /// travel [rad]
    pub travel: f64,
    /// helicopter up positive [rad]
    pub elevation: f64,
    /// front up positive [rad]
    pub pitch: f64,
    /// carriage, towards the helicopter [m]
    pub s: f64,
}

impl Coordinates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [travel, elevation, pitch, s] = values;
        Self { travel, elevation, pitch, s }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.travel, self.elevation, self.pitch, self.s]
    }
}

/// Rates v = q'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// travel.dot [rad/s]
    pub travel: f64,
    /// helicopter up positive [rad/s]
    pub elevation: f64,
    /// front up positive [rad/s]
    pub pitch: f64,
    /// carriage, towards the helicopter [m/s]
    pub s: f64,
}

impl Rates {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [travel, elevation, pitch, s] = values;
        Self { travel, elevation, pitch, s }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.travel, self.elevation, self.pitch, self.s]
    }
}

/// Accelerations a = q''.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accelerations {
    /// travel.ddot [rad/s^2]
    pub travel: f64,
    /// helicopter up positive [rad/s^2]
    pub elevation: f64,
    /// front up positive [rad/s^2]
    pub pitch: f64,
    /// carriage, towards the helicopter [m/s^2]
    pub s: f64,
}

impl Accelerations {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [travel, elevation, pitch, s] = values;
        Self { travel, elevation, pitch, s }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.travel, self.elevation, self.pitch, self.s]
    }
}

/// Signals u: inputs, then accelerations of prescribed coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// front motor [V]
    pub V_f: f64,
    /// back motor [V]
    pub V_b: f64,
    /// carriage, towards the helicopter [m/s^2]
    pub s_ddot: f64,
}

impl Inputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 3]) -> Self {
        let [V_f, V_b, s_ddot] = values;
        Self { V_f, V_b, s_ddot }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 3] {
        [self.V_f, self.V_b, self.s_ddot]
    }
}

/// Measured outputs y.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// travel [rad]
    pub travel: f64,
    /// elevation [rad]
    pub elevation: f64,
    /// pitch [rad]
    pub pitch: f64,
    /// s [m]
    pub s: f64,
}

impl Outputs {
    /// From an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn from_array(values: [f64; 4]) -> Self {
        let [travel, elevation, pitch, s] = values;
        Self { travel, elevation, pitch, s }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 4] {
        [self.travel, self.elevation, self.pitch, self.s]
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

/// Mass matrix M(q), 4 x 4, symmetric; rows (travel, elevation, pitch, s).
#[must_use]
pub fn mass_matrix(q: &Coordinates, p: &Parameters) -> [[f64; 4]; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let s_plus_s_0 = q.s + p.s_0;
    let d_m_s = p.d * p.m_s;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let m_h_per_two = p.m_h / 2.0;
    let L_h_L_h_m_h_per_two = p.L_h * p.L_h * m_h_per_two;
    // frame heli on arm
    let m_heli = 2.0 * m_h_per_two;
    let I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    let M_travel_pitch = I_heli_xx * s_elevation;
    let heli_1 = 2.0 * L_h_L_h_m_h_per_two * c_pitch;
    let heli_1_c_pitch = heli_1 * c_pitch;
    // frame arm on column
    let arm_1 = s_plus_s_0 * m_s_s_plus_s_0 - p.L_w * mc_arm_x;
    let d_d_m_heli_plus_m_w_plus_m_s = p.d * p.d * (m_heli + p.m_w + p.m_s);
    let arm_2 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    let M_elevation_elevation = arm_1 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    let M_travel_elevation = heli_1 * c_elevation * s_pitch;
    let arm_1_1 = arm_1 + L_a_L_a_m_heli + heli_1_c_pitch - arm_2;
    let arm_1_2 = 2.0 * p.d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    let arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    [
        [arm_2 + arm_1_3, M_travel_elevation, M_travel_pitch, 0.0], // travel
        [M_travel_elevation, M_elevation_elevation, 0.0, d_m_s], // elevation
        [M_travel_pitch, 0.0, I_heli_xx, 0.0], // pitch
        [0.0, d_m_s, 0.0, p.m_s], // s
    ]
}

/// Bias h(q, v) [N m, N m, N m, N]: velocity products + gravity + springs; rows (travel, elevation, pitch, s).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let s_plus_s_0 = q.s + p.s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    let m_h_per_two = p.m_h / 2.0;
    let L_h_L_h_m_h_per_two = p.L_h * p.L_h * m_h_per_two;
    // frame heli on arm
    let m_heli = 2.0 * m_h_per_two;
    let I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v.pitch;
    let n_moving_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y * omega_heli_z;
    let n_moving_heli_z = I_heli_xx * alpha_heli_z - 2.0 * omega_heli_y * L_h_L_h_m_h_per_two * (v.pitch + omega_arm_1_x);
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    // frame arm on column
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let a_arm_z = p.d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    let arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    let a_arm_x = p.g * s_elevation - p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_z_2 = a_arm_z + p.g * c_elevation;
    // frame heli on arm
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_z = p.L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    // frame rail on arm
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v.s;
    let f_moving_rail_y = p.m_s * a_rail_y;
    let a_rail_z = 2.0 * v.elevation * v.s + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    let f_rail_x = p.m_s * (a_arm_x - s_plus_s_0 * arm_1);
    // frame arm on column
    let arm_2 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    let arm_3 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = m_heli * (a_arm_x - p.L_a * arm_1);
    let f_heli_y = m_heli * a_heli_y;
    let f_heli_z = m_heli * a_heli_z;
    let f_heli_1_y = f_heli_y * c_pitch - f_heli_z * s_pitch;
    let f_heli_1_z = f_heli_y * s_pitch + f_heli_z * c_pitch;
    // frame arm on column
    let f_arm_x = f_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + f_rail_x;
    let f_arm_y = f_moving_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_heli_1_y;
    let n_arm_y = -arm_3 - n_moving_heli_z * s_pitch - p.L_a * f_heli_1_z;
    let n_arm_z = arm_2 + n_moving_heli_z * c_pitch + p.L_a * f_heli_1_y;
    let n_column_z = n_arm_z * c_elevation + s_elevation * (n_moving_heli_x + p.d * f_arm_y);
    [n_column_z, p.d * f_arm_x - n_arm_y, n_moving_heli_x, f_rail_x]
}

/// Velocity products C(q, v) v [N m, N m, N m, N]: Coriolis and centrifugal terms; rows (travel, elevation, pitch, s).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let s_plus_s_0 = q.s + p.s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    let m_h_per_two = p.m_h / 2.0;
    let L_h_L_h_m_h_per_two = p.L_h * p.L_h * m_h_per_two;
    // frame heli on arm
    let m_heli = 2.0 * m_h_per_two;
    let I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v.pitch;
    let n_moving_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y * omega_heli_z;
    let n_moving_heli_z = I_heli_xx * alpha_heli_z - 2.0 * omega_heli_y * L_h_L_h_m_h_per_two * (v.pitch + omega_arm_1_x);
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    // frame arm on column
    let a_arm_x = -p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let a_arm_z = p.d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    let arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    // frame heli on arm
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_z = a_arm_z + p.L_a * omega_arm_1_z_omega_arm_1_x;
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_moving_heli_x = -m_heli * (p.L_a * arm_1 - a_arm_x);
    let f_moving_heli_y = m_heli * a_heli_y;
    let f_moving_heli_z = m_heli * a_heli_z;
    let f_moving_heli_1_y = f_moving_heli_y * c_pitch - f_moving_heli_z * s_pitch;
    let f_moving_heli_1_z = f_moving_heli_y * s_pitch + f_moving_heli_z * c_pitch;
    // frame rail on arm
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v.s;
    let a_rail_z = a_arm_z + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + 2.0 * v.elevation * v.s;
    let f_moving_rail_x = -p.m_s * (s_plus_s_0 * arm_1 - a_arm_x);
    let f_moving_rail_y = p.m_s * a_rail_y;
    // frame arm on column
    let arm_2 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    let arm_3 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    let f_moving_arm_x = p.m_w * a_arm_x - mc_arm_x * arm_1 + f_moving_rail_x + f_moving_heli_x;
    let f_moving_arm_y = f_moving_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_moving_heli_1_y;
    let n_moving_arm_y = -arm_2 - n_moving_heli_z * s_pitch - p.L_a * f_moving_heli_1_z;
    let n_moving_arm_z = arm_3 + n_moving_heli_z * c_pitch + p.L_a * f_moving_heli_1_y;
    let n_moving_column_z = n_moving_arm_z * c_elevation + s_elevation * (n_moving_heli_x + p.d * f_moving_arm_y);
    [n_moving_column_z, p.d * f_moving_arm_x - n_moving_arm_y, n_moving_heli_x, f_moving_rail_x]
}

/// Generalized gravity g(q) [N m, N m, N m, N]: what holds the rig still; rows (travel, elevation, pitch, s).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let s_pitch = sin(q.pitch);
    let m_h_per_two = p.m_h / 2.0;
    let L_h_s_pitch = p.L_h * s_pitch;
    let L_a_c_elevation = p.L_a * c_elevation;
    let d_s_elevation = p.d * s_elevation;
    let gravity_1 = p.g * m_h_per_two * (L_a_c_elevation - s_elevation * (L_h_s_pitch - p.d));
    let gravity_2 = gravity_1 - p.m_w * p.g * (p.L_w * c_elevation - d_s_elevation);
    let gravity_3 = p.g * m_h_per_two * (L_a_c_elevation + s_elevation * (p.d + L_h_s_pitch));
    let gravity_4 = p.g * p.m_s * (d_s_elevation + c_elevation * (q.s + p.s_0));
    [0.0, gravity_2 + gravity_3 + gravity_4, 0.0, p.g * p.m_s * s_elevation]
}

/// Friction and dampers d(q, v) [N m, N m, N m, N], on the left-hand side; rows (travel, elevation, pitch, s).
#[must_use]
pub fn dissipation(_q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 4] {
    [p.c_travel * v.travel, p.c_elevation * v.elevation, p.c_pitch * v.pitch, 0.0]
}

/// Generalized force Q [N m, N m, N m, N] of the inputs; rows (travel, elevation, pitch, s).
#[must_use]
pub fn generalized_force(q: &Coordinates, u: &Inputs, p: &Parameters) -> [f64; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let F_f = p.K_f * u.V_f;
    let F_b = p.K_f * u.V_b;
    // force back on heli
    let f_applied_heli_z = F_f + F_b;
    let n_applied_heli_x = p.L_h * F_f - p.L_h * F_b;
    // frame heli on arm
    let f_applied_heli_1_y = -f_applied_heli_z * s_pitch;
    // frame arm on column
    let arm_1_1 = s_elevation * (n_applied_heli_x + p.d * f_applied_heli_1_y);
    let n_applied_column_z = arm_1_1 + p.L_a * f_applied_heli_1_y * c_elevation;
    [n_applied_column_z, p.L_a * f_applied_heli_z * c_pitch, n_applied_heli_x, 0.0]
}

/// Input map dQ/du, 4 x 3; rows (travel, elevation, pitch, s), columns (V_f, V_b, s.ddot).
#[must_use]
pub fn input_map(q: &Coordinates, p: &Parameters) -> [[f64; 3]; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let L_h_K_f = p.L_h * p.K_f;
    let K_f_s_pitch = p.K_f * s_pitch;
    let L_a_K_f_c_pitch = p.L_a * p.K_f * c_pitch;
    let d_K_f_s_pitch = p.d * K_f_s_pitch;
    let L_a_K_f_s_pitch_c_elevation = p.L_a * K_f_s_pitch * c_elevation;
    [
        // travel
        [
            s_elevation * (L_h_K_f - d_K_f_s_pitch) - L_a_K_f_s_pitch_c_elevation,
            -L_a_K_f_s_pitch_c_elevation - s_elevation * (L_h_K_f + d_K_f_s_pitch), 0.0,
        ],
        [L_a_K_f_c_pitch, L_a_K_f_c_pitch, 0.0], // elevation
        [L_h_K_f, -L_h_K_f, 0.0], // pitch
        [0.0, 0.0, 0.0], // s
    ]
}

/// Kinetic energy T(q, v) [J].
#[must_use]
pub fn kinetic_energy(q: &Coordinates, v: &Rates, p: &Parameters) -> f64 {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let s_plus_s_0 = q.s + p.s_0;
    let s_plus_s_0_elevation_dot = s_plus_s_0 * v.elevation;
    let m_h_per_two = p.m_h / 2.0;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    // frame heli on arm
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let d_elevation_dot = p.d * v.elevation;
    let d_omega_arm_1_x = p.d * omega_arm_1_x;
    let L_a_elevation_dot = p.L_a * v.elevation;
    let heli_1_1 = d_omega_arm_1_x + p.L_a * omega_arm_1_z;
    let heli_1 = heli_1_1 * c_pitch + L_a_elevation_dot * s_pitch;
    let heli_2 = L_a_elevation_dot * c_pitch - heli_1_1 * s_pitch;
    // frame rail on arm
    let rail_1 = d_omega_arm_1_x + s_plus_s_0 * omega_arm_1_z;
    let s_dot_plus_d_elevation_dot = v.s + d_elevation_dot;
    let L_w_elevation_dot = p.L_w * v.elevation;
    // body counterweight on arm
    let counterweight_1 = d_omega_arm_1_x - p.L_w * omega_arm_1_z;
    let counterweight_2 = d_elevation_dot * d_elevation_dot + counterweight_1 * counterweight_1;
    let L_h_omega_heli_z = p.L_h * omega_heli_z;
    // body front_rotor on heli
    let front_rotor_1 = p.L_h * (v.pitch + omega_arm_1_x);
    let front_rotor_2 = d_elevation_dot - L_h_omega_heli_z;
    let heli_2_plus_front_rotor_1 = heli_2 + front_rotor_1;
    let heli_1_sq = heli_1 * heli_1;
    let front_rotor_3 = front_rotor_2 * front_rotor_2 + heli_1_sq;
    let front_rotor_4 = 0.5 * m_h_per_two * (heli_2_plus_front_rotor_1 * heli_2_plus_front_rotor_1 + front_rotor_3);
    let front_rotor_5 = 0.5 * p.m_w * (L_w_elevation_dot * L_w_elevation_dot + counterweight_2) + front_rotor_4;
    // body back_rotor on heli
    let back_rotor_1 = d_elevation_dot + L_h_omega_heli_z;
    let heli_2_minus_front_rotor_1 = heli_2 - front_rotor_1;
    let back_rotor_2 = heli_1_sq + back_rotor_1 * back_rotor_1;
    let back_rotor_3 = 0.5 * m_h_per_two * (heli_2_minus_front_rotor_1 * heli_2_minus_front_rotor_1 + back_rotor_2);
    // body carriage on rail
    let carriage_1 = s_dot_plus_d_elevation_dot * s_dot_plus_d_elevation_dot + rail_1 * rail_1;
    let carriage_2 = 0.5 * p.m_s * (s_plus_s_0_elevation_dot * s_plus_s_0_elevation_dot + carriage_1);
    front_rotor_5 + back_rotor_3 + carriage_2
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let s_pitch = sin(q.pitch);
    let m_h_per_two = p.m_h / 2.0;
    let L_h_s_pitch = p.L_h * s_pitch;
    let L_a_s_elevation = p.L_a * s_elevation;
    // body front_rotor on heli
    let front_rotor_1 = p.g * m_h_per_two * (c_elevation * (L_h_s_pitch - p.d) + L_a_s_elevation);
    let d_c_elevation = p.d * c_elevation;
    let front_rotor_2 = front_rotor_1 - p.m_w * p.g * (d_c_elevation + p.L_w * s_elevation);
    // body back_rotor on heli
    let back_rotor_1 = p.g * m_h_per_two * (L_a_s_elevation - c_elevation * (p.d + L_h_s_pitch));
    // body carriage on rail
    let carriage_1 = p.g * p.m_s * (s_elevation * (q.s + p.s_0) - d_c_elevation);
    front_rotor_2 + back_rotor_1 + carriage_1
}

/// Inverse dynamics M a + h + d - Q [N m, N m, N m, N]: the generalized force that is missing for the accelerations a;
/// zero where a, v, q and u fit together.
#[must_use]
pub fn inverse_dynamics(x: &State, a: &Accelerations, u: &Inputs, p: &Parameters) -> [f64; 4] {
    let State { q, v } = x;
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let F_f = p.K_f * u.V_f;
    let F_b = p.K_f * u.V_b;
    let s_plus_s_0 = q.s + p.s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    let m_h_per_two = p.m_h / 2.0;
    let L_h_L_h_m_h_per_two = p.L_h * p.L_h * m_h_per_two;
    // frame heli on arm
    let m_heli = 2.0 * m_h_per_two;
    let I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    let alpha_arm_1_x_2 = alpha_arm_1_x + s_elevation * a.travel;
    let alpha_arm_1_z_2 = c_elevation * a.travel + alpha_arm_1_z;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let alpha_heli_z = s_pitch * a.elevation + alpha_arm_1_z_2 * c_pitch - omega_heli_y * v.pitch;
    let n_net_heli_z = I_heli_xx * alpha_heli_z - 2.0 * omega_heli_y * L_h_L_h_m_h_per_two * (v.pitch + omega_arm_1_x);
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    // frame arm on column
    let a_arm_z = p.d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    let arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let a_arm_z_2 = a_arm_z + p.g * c_elevation;
    let a_arm_y = p.d * (alpha_arm_1_x + alpha_arm_1_x_2);
    let a_arm_x = p.g * s_elevation - p.d * (omega_arm_1_z_omega_arm_1_x - a.elevation);
    let arm_2 = alpha_arm_1_z_2 + alpha_arm_1_z;
    let arm_3 = a.elevation + omega_arm_1_z_omega_arm_1_x;
    let arm_4 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + I_arm_yy * a.elevation;
    let arm_5 = I_arm_yy * alpha_arm_1_z_2 + I_arm_yy * alpha_arm_1_z + mc_arm_x * a_arm_y;
    // force back on heli
    let n_applied_heli_x = p.L_h * F_f - p.L_h * F_b;
    // frame heli on arm
    let a_heli_1_y = a_arm_y + p.L_a * arm_2;
    let a_heli_1_z = a_arm_z_2 + p.L_a * arm_3;
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_net_heli_x = m_heli * (a_arm_x - p.L_a * arm_1);
    let f_net_heli_y = m_heli * a_heli_y;
    // frame rail on arm
    let a_rail_y = 2.0 * omega_arm_1_z * v.s + a_arm_y + s_plus_s_0 * arm_2;
    let a_rail_z = 2.0 * v.elevation * v.s + a_arm_z_2 + s_plus_s_0 * arm_3;
    let a_rail_x = a.s + a_arm_x - s_plus_s_0 * arm_1;
    let f_net_rail_x = p.m_s * a_rail_x;
    let f_net_rail_y = p.m_s * a_rail_y;
    let f_net_heli_z = m_heli * a_heli_z - F_f - F_b;
    let n_net_heli_x = I_heli_xx * omega_heli_y * omega_heli_z + I_heli_xx * (a.pitch + alpha_arm_1_x_2) - n_applied_heli_x;
    // frame arm on column
    let arm_6 = arm_4 + p.m_s * s_plus_s_0 * a_rail_z;
    let f_net_arm_x = f_net_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + f_net_rail_x;
    // frame heli on arm
    let f_net_heli_1_y = f_net_heli_y * c_pitch - f_net_heli_z * s_pitch;
    let f_net_heli_1_z = f_net_heli_y * s_pitch + f_net_heli_z * c_pitch;
    let heli_1_1 = n_net_heli_z * c_pitch + p.L_a * f_net_heli_1_y;
    // frame arm on column
    let f_net_arm_y = p.m_w * a_arm_y + mc_arm_x * arm_2 + f_net_rail_y + f_net_heli_1_y;
    let n_net_arm_y = -arm_6 - n_net_heli_z * s_pitch - p.L_a * f_net_heli_1_z;
    let n_net_arm_z = arm_5 + s_plus_s_0 * f_net_rail_y + heli_1_1;
    let n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p.d * f_net_arm_y);
    [
        p.c_travel * v.travel + n_net_column_z, // travel
        p.c_elevation * v.elevation + p.d * f_net_arm_x - n_net_arm_y, // elevation
        p.c_pitch * v.pitch + n_net_heli_x, // pitch
        f_net_rail_x, // s
    ]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.travel, q.elevation + 0.4799655442984406, q.pitch, q.s])
}

/// Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is
/// positive definite; a vanishing one says which coordinate moves no inertia.
#[must_use]
pub fn pivots(x: &State, p: &Parameters) -> [f64; 3] {
    let State { q, .. } = x;
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let s_plus_s_0 = q.s + p.s_0;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let m_h_per_two = p.m_h / 2.0;
    let L_h_L_h_m_h_per_two = p.L_h * p.L_h * m_h_per_two;
    // frame heli on arm
    let m_heli = 2.0 * m_h_per_two;
    let I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    let M_travel_pitch = I_heli_xx * s_elevation;
    let heli_1 = 2.0 * L_h_L_h_m_h_per_two * c_pitch;
    let heli_1_c_pitch = heli_1 * c_pitch;
    // frame arm on column
    let arm_1 = s_plus_s_0 * m_s_s_plus_s_0 - p.L_w * mc_arm_x;
    let d_d_m_heli_plus_m_w_plus_m_s = p.d * p.d * (m_heli + p.m_w + p.m_s);
    let arm_2 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    let M_elevation_elevation = arm_1 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    let M_travel_elevation = heli_1 * c_elevation * s_pitch;
    let arm_1_1 = arm_1 + L_a_L_a_m_heli + heli_1_c_pitch - arm_2;
    let arm_1_2 = 2.0 * p.d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    let arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    // M = L^T D L and back-substitution
    let solve_1 = M_travel_elevation * M_travel_elevation / M_elevation_elevation;
    let solve_2 = arm_2 + arm_1_3 - solve_1;
    let pivot_travel = solve_2 - M_travel_pitch * M_travel_pitch / I_heli_xx;
    [pivot_travel, M_elevation_elevation, I_heli_xx]
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 189 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let F_f = p.K_f * u.V_f;
    let F_b = p.K_f * u.V_b;
    let s_plus_s_0 = q.s + p.s_0;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    let m_h_per_two = p.m_h / 2.0;
    let L_h_L_h_m_h_per_two = p.L_h * p.L_h * m_h_per_two;
    // frame heli on arm
    let m_heli = 2.0 * m_h_per_two;
    let I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    let two_L_h_L_h_m_h_per_two = 2.0 * L_h_L_h_m_h_per_two;
    let M_travel_pitch = I_heli_xx * s_elevation;
    let heli_1 = two_L_h_L_h_m_h_per_two * c_pitch;
    let heli_1_c_pitch = heli_1 * c_pitch;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    let M_travel_elevation = heli_1 * c_elevation * s_pitch;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v.pitch;
    let n_moving_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y * omega_heli_z;
    let n_moving_heli_z = I_heli_xx * alpha_heli_z - omega_heli_y * two_L_h_L_h_m_h_per_two * (v.pitch + omega_arm_1_x);
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    // frame arm on column
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let a_arm_z = p.d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    let arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    let a_arm_x = p.g * s_elevation - p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_z_2 = a_arm_z + p.g * c_elevation;
    let arm_2 = I_arm_yy + s_plus_s_0 * m_s_s_plus_s_0;
    let d_d_m_heli_plus_m_w_plus_m_s = p.d * p.d * (m_heli + p.m_w + p.m_s);
    let arm_3 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    // frame heli on arm
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_z = p.L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    // frame rail on arm
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v.s;
    let f_moving_rail_y = p.m_s * a_rail_y;
    let a_rail_z = 2.0 * v.elevation * v.s + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    let a_rail_x = u.s_ddot + a_arm_x - s_plus_s_0 * arm_1;
    // frame arm on column
    let arm_4 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    let arm_5 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    let M_elevation_elevation = arm_2 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = m_heli * (a_arm_x - p.L_a * arm_1);
    let f_heli_y = m_heli * a_heli_y;
    // frame arm on column
    let arm_1_1 = arm_2 + L_a_L_a_m_heli + heli_1_c_pitch - arm_3;
    let arm_1_2 = 2.0 * p.d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    let arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    // force back on heli
    let n_applied_heli_x = p.L_h * F_f - p.L_h * F_b;
    // frame rail on arm
    let f_net_heli_z = m_heli * a_heli_z - F_f - F_b;
    let n_net_heli_x = n_moving_heli_x - n_applied_heli_x;
    // frame heli on arm
    let f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    let f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    // frame arm on column
    let f_net_arm_x = f_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + p.m_s * a_rail_x;
    let f_net_arm_y = f_moving_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_net_heli_1_y;
    let n_net_arm_y = -arm_5 - n_moving_heli_z * s_pitch - p.L_a * f_net_heli_1_z;
    let n_net_arm_z = arm_4 + n_moving_heli_z * c_pitch + p.L_a * f_net_heli_1_y;
    let n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p.d * f_net_arm_y);
    // balance of forces
    let tau_elevation = n_net_arm_y - p.c_elevation * v.elevation - p.d * f_net_arm_x;
    let tau_pitch = -p.c_pitch * v.pitch - n_net_heli_x;
    // M = L^T D L and back-substitution
    let inv_pitch = 1.0 / I_heli_xx;
    let l_pitch_travel = M_travel_pitch * inv_pitch;
    let inv_elevation = 1.0 / M_elevation_elevation;
    let l_elevation_travel = M_travel_elevation * inv_elevation;
    let solve_1 = arm_3 + arm_1_3 - M_travel_elevation * l_elevation_travel;
    let pivot_travel = solve_1 - M_travel_pitch * l_pitch_travel;
    let solve_2 = tau_pitch * l_pitch_travel + p.c_travel * v.travel + n_net_column_z + tau_elevation * l_elevation_travel;
    let travel_ddot = -solve_2 / pivot_travel;
    let elevation_ddot = tau_elevation * inv_elevation - l_elevation_travel * travel_ddot;
    let pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    positive(I_heli_xx, 2)?;
    positive(M_elevation_elevation, 1)?;
    positive(pivot_travel, 0)?;
    Ok(Accelerations::from_array([travel_ddot, elevation_ddot, pitch_ddot, u.s_ddot]))
}

/// x' and its Jacobians at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// x'.
    pub dx: [f64; 8],
    /// A = dx'/dx, 8 x 8.
    pub a: [[f64; 8]; 8],
    /// B = dx'/du, 8 x 3.
    pub b: [[f64; 3]; 8],
}

/// State derivative and its Jacobians A, B, exact, at any state.
/// 706 operations.
///
/// Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.
/// ```text
///              travel elevation pitch s travel.dot elevation.dot pitch.dot s.dot | V_f V_b s.ddot
/// travel'      .      .         .     . 1          .             .         .     | .   .   .
/// elevation'   .      .         .     . .          1             .         .     | .   .   .
/// pitch'       .      .         .     . .          .             1         .     | .   .   .
/// s'           .      .         .     . .          .             .         1     | .   .   .
/// travel''     .      *         *     * *          *             *         *     | *   *   *
/// elevation''  .      *         *     * *          *             *         *     | *   *   *
/// pitch''      .      *         *     * *          *             *         *     | *   *   *
/// s''          .      .         .     . .          .             .         .     | .   .   1
/// ```
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn linearize(x: &State, u: &Inputs, p: &Parameters) -> Result<Linearization, Singular> {
    let State { q, v } = x;
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let F_f = p.K_f * u.V_f;
    let F_b = p.K_f * u.V_b;
    let s_plus_s_0 = q.s + p.s_0;
    let two_elevation_dot_s_dot = 2.0 * v.elevation * v.s;
    let d_m_s = p.d * p.m_s;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    let m_h_per_two = p.m_h / 2.0;
    let L_h_L_h_m_h_per_two = p.L_h * p.L_h * m_h_per_two;
    // frame heli on arm
    let m_heli = 2.0 * m_h_per_two;
    let I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    let c_pitch_elevation_dot = c_pitch * v.elevation;
    let two_L_h_L_h_m_h_per_two = 2.0 * L_h_L_h_m_h_per_two;
    let M_travel_pitch = I_heli_xx * s_elevation;
    let heli_1 = two_L_h_L_h_m_h_per_two * c_pitch;
    let heli_1_c_pitch = heli_1 * c_pitch;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    let a_arm_1_z = p.g * c_elevation;
    let a_arm_1_x = p.g * s_elevation;
    let M_travel_elevation = heli_1 * c_elevation * s_pitch;
    let omega_arm_1_z_s_pitch = omega_arm_1_z * s_pitch;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z_s_pitch - c_pitch_elevation_dot;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let omega_heli_x = v.pitch + omega_arm_1_x;
    let omega_heli_y_pitch_dot = omega_heli_y * v.pitch;
    let heli_2 = I_heli_xx * omega_heli_y * omega_heli_z;
    let heli_3 = omega_heli_y * omega_heli_x * two_L_h_L_h_m_h_per_two;
    let n_moving_heli_z = -heli_3 - I_heli_xx * (omega_heli_y_pitch_dot - alpha_arm_1_z * c_pitch);
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    // frame arm on column
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let omega_arm_1_x_sq = omega_arm_1_x * omega_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let omega_arm_1_z_sq = omega_arm_1_z * omega_arm_1_z;
    let arm_1 = elevation_dot_sq + omega_arm_1_z_sq;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    let I_arm_yy_alpha_arm_1_z = I_arm_yy * alpha_arm_1_z;
    let arm_2 = omega_arm_1_z_sq - omega_arm_1_x_sq;
    let a_arm_x = a_arm_1_x - p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_z = p.d * (omega_arm_1_x_sq + elevation_dot_sq) + a_arm_1_z;
    let arm_3 = I_arm_yy + s_plus_s_0 * m_s_s_plus_s_0;
    let d_d_m_heli_plus_m_w_plus_m_s = p.d * p.d * (m_heli + p.m_w + p.m_s);
    let arm_4 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    // frame heli on arm
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_z = p.L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    let two_omega_arm_1_z_s_dot = 2.0 * omega_arm_1_z * v.s;
    // frame rail on arm
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + two_omega_arm_1_z_s_dot;
    let f_moving_rail_y = p.m_s * a_rail_y;
    let a_rail_z = two_elevation_dot_s_dot + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    let a_rail_x = u.s_ddot + a_arm_x - s_plus_s_0 * arm_1;
    // frame arm on column
    let arm_5 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy_alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    let arm_6 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    let M_elevation_elevation = arm_3 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = m_heli * (a_arm_x - p.L_a * arm_1);
    let f_heli_y = m_heli * a_heli_y;
    // frame arm on column
    let arm_1_1 = arm_3 + L_a_L_a_m_heli + heli_1_c_pitch - arm_4;
    let arm_1_2 = 2.0 * p.d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    let arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    // force back on heli
    let f_applied_heli_z = F_f + F_b;
    let n_applied_heli_x = p.L_h * F_f - p.L_h * F_b;
    let c_elevation_elevation_dot = c_elevation * v.elevation;
    let s_elevation_elevation_dot = s_elevation * v.elevation;
    let omega_arm_1_x_c_pitch = omega_arm_1_x * c_pitch;
    // gravity
    let gravity_1 = c_pitch_elevation_dot - omega_arm_1_z_s_pitch;
    // frame rail on arm
    let f_net_heli_z = m_heli * a_heli_z - f_applied_heli_z;
    let n_net_heli_x = I_heli_xx * alpha_arm_1_x + heli_2 - n_applied_heli_x;
    // frame heli on arm
    let f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    let f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    // frame arm on column
    let f_net_arm_x = f_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + p.m_s * a_rail_x;
    let f_net_arm_y = f_moving_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_net_heli_1_y;
    let n_net_arm_y = -arm_6 - n_moving_heli_z * s_pitch - p.L_a * f_net_heli_1_z;
    let n_net_arm_z = arm_5 + n_moving_heli_z * c_pitch + p.L_a * f_net_heli_1_y;
    let n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p.d * f_net_arm_y);
    // balance of forces
    let tau_elevation = n_net_arm_y - p.c_elevation * v.elevation - p.d * f_net_arm_x;
    let tau_pitch = -p.c_pitch * v.pitch - n_net_heli_x;
    // M = L^T D L and back-substitution
    let inv_pitch = 1.0 / I_heli_xx;
    let l_pitch_travel = M_travel_pitch * inv_pitch;
    let inv_elevation = 1.0 / M_elevation_elevation;
    let l_elevation_travel = M_travel_elevation * inv_elevation;
    let solve_1 = arm_4 + arm_1_3 - M_travel_elevation * l_elevation_travel;
    let pivot_travel = solve_1 - M_travel_pitch * l_pitch_travel;
    let inv_travel = 1.0 / pivot_travel;
    let solve_2 = tau_pitch * l_pitch_travel + p.c_travel * v.travel + n_net_column_z + tau_elevation * l_elevation_travel;
    let travel_ddot = -inv_travel * solve_2;
    let elevation_ddot = tau_elevation * inv_elevation - l_elevation_travel * travel_ddot;
    let pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    let L_h_K_f = p.L_h * p.K_f;
    let K_f_s_pitch = p.K_f * s_pitch;
    let L_a_K_f_c_pitch = p.L_a * p.K_f * c_pitch;
    let d_K_f_s_pitch = p.d * K_f_s_pitch;
    let L_a_K_f_s_pitch_c_elevation = p.L_a * K_f_s_pitch * c_elevation;
    // input map
    let input_map_1 = L_a_K_f_s_pitch_c_elevation + s_elevation * (L_h_K_f + d_K_f_s_pitch);
    let omega_arm_1_x_s_pitch = omega_arm_1_x * s_pitch;
    let two_omega_arm_1_x = 2.0 * omega_arm_1_x;
    let two_omega_arm_1_z = 2.0 * omega_arm_1_z;
    // derivatives with respect to elevation
    let by_elevation_1 = omega_arm_1_x * two_omega_arm_1_z;
    let by_elevation_2 = I_heli_xx * (omega_heli_z * omega_arm_1_x_s_pitch + omega_heli_y * omega_arm_1_x_c_pitch);
    let by_elevation_3 = two_L_h_L_h_m_h_per_two * (omega_arm_1_z * omega_heli_y - omega_heli_x * omega_arm_1_x_s_pitch);
    let by_elevation_4 = p.d * omega_arm_1_z * two_omega_arm_1_x - a_arm_1_x;
    let a_arm_1_z_minus_d_arm_2 = a_arm_1_z - p.d * arm_2;
    let by_elevation_5 = by_elevation_4 + p.L_a * arm_2;
    let by_elevation_6 = m_heli * (p.L_a * by_elevation_1 + a_arm_1_z_minus_d_arm_2);
    let by_elevation_7 = p.m_s * (s_plus_s_0 * by_elevation_1 + a_arm_1_z_minus_d_arm_2);
    let by_elevation_8 = p.m_s * s_plus_s_0 * (by_elevation_4 + s_plus_s_0 * arm_2);
    let by_elevation_9 = p.m_w * a_arm_1_z_minus_d_arm_2 + mc_arm_x * by_elevation_1 + by_elevation_7;
    let by_elevation_10 = mc_arm_x * by_elevation_4 + I_arm_yy * arm_2 + by_elevation_8;
    let by_elevation_11 = p.d * (by_elevation_6 + by_elevation_9);
    // derivatives with respect to pitch
    let by_pitch_1 = I_heli_xx * (omega_heli_z * omega_heli_z + omega_heli_y * gravity_1);
    let c_elevation_s_pitch = c_elevation * s_pitch;
    // derivatives with respect to travel_dot
    let by_travel_dot_1 = omega_arm_1_x * c_elevation + omega_arm_1_z * s_elevation;
    let by_travel_dot_2 = p.d * two_omega_arm_1_x * s_elevation;
    let by_travel_dot_3 = two_omega_arm_1_z * c_elevation;
    let by_travel_dot_4 = omega_heli_z * c_elevation_s_pitch + omega_heli_y * c_elevation * c_pitch;
    let by_travel_dot_5 = two_L_h_L_h_m_h_per_two * (omega_heli_x * c_elevation_s_pitch + omega_heli_y * s_elevation);
    let d_by_travel_dot_1 = p.d * by_travel_dot_1;
    let by_travel_dot_6 = 2.0 * p.d * c_elevation_elevation_dot;
    let by_travel_dot_7 = 2.0 * s_elevation_elevation_dot;
    let by_travel_dot_8 = mc_arm_x * by_travel_dot_6 - 2.0 * I_arm_yy * s_elevation_elevation_dot;
    let by_travel_dot_9 = by_travel_dot_6 - p.L_a * by_travel_dot_7;
    let by_travel_dot_10 = by_travel_dot_2 + p.L_a * by_travel_dot_1;
    let by_travel_dot_11 = m_heli * (p.L_a * by_travel_dot_3 + d_by_travel_dot_1);
    let by_travel_dot_12 = m_heli * (by_travel_dot_9 * c_pitch + by_travel_dot_10 * s_pitch);
    let by_travel_dot_13 = m_heli * (by_travel_dot_10 * c_pitch - by_travel_dot_9 * s_pitch);
    let by_travel_dot_14 = I_heli_xx * (s_elevation_elevation_dot * c_pitch + c_elevation_s_pitch * v.pitch);
    let by_travel_dot_15 = I_heli_xx * by_travel_dot_4 + I_heli_xx * c_elevation_elevation_dot;
    let by_travel_dot_16 = by_travel_dot_5 + by_travel_dot_14;
    let by_travel_dot_17 = 2.0 * c_elevation * v.s + by_travel_dot_6 - s_plus_s_0 * by_travel_dot_7;
    let by_travel_dot_18 = p.m_s * (s_plus_s_0 * by_travel_dot_3 + d_by_travel_dot_1);
    let m_s_by_travel_dot_17 = p.m_s * by_travel_dot_17;
    let by_travel_dot_19 = p.m_s * s_plus_s_0 * (by_travel_dot_2 + s_plus_s_0 * by_travel_dot_1);
    let by_travel_dot_20 = mc_arm_x * by_travel_dot_3 + p.m_w * d_by_travel_dot_1 + by_travel_dot_18;
    let by_travel_dot_21 = p.m_w * by_travel_dot_6 - mc_arm_x * by_travel_dot_7 + m_s_by_travel_dot_17;
    let by_travel_dot_22 = mc_arm_x * by_travel_dot_2 + I_arm_yy * by_travel_dot_1 + by_travel_dot_19;
    let by_travel_dot_23 = by_travel_dot_12 * c_pitch - by_travel_dot_13 * s_pitch;
    let by_travel_dot_24 = p.L_a * (by_travel_dot_12 * s_pitch + by_travel_dot_13 * c_pitch);
    let by_travel_dot_25 = p.L_a * by_travel_dot_23 - by_travel_dot_16 * c_pitch;
    let by_travel_dot_26 = by_travel_dot_16 * s_pitch - by_travel_dot_22 - by_travel_dot_24;
    let by_travel_dot_27 = by_travel_dot_8 + s_plus_s_0 * m_s_by_travel_dot_17 + by_travel_dot_25;
    let by_travel_dot_28 = p.d * (-by_travel_dot_20 - by_travel_dot_11);
    let by_travel_dot_29 = s_elevation * (by_travel_dot_15 + p.d * (by_travel_dot_21 + by_travel_dot_23));
    let by_travel_dot_30 = p.c_travel + by_travel_dot_27 * c_elevation + by_travel_dot_29;
    let by_travel_dot_31 = by_travel_dot_26 - by_travel_dot_28;
    let by_travel_dot_32 = l_pitch_travel * by_travel_dot_15 - l_elevation_travel * by_travel_dot_31 - by_travel_dot_30;
    let d_travel_ddot_by_travel_dot = inv_travel * by_travel_dot_32;
    let d_elevation_ddot_by_travel_dot = inv_elevation * by_travel_dot_31 - l_elevation_travel * d_travel_ddot_by_travel_dot;
    let d_pitch_ddot_by_travel_dot = -inv_pitch * by_travel_dot_15 - l_pitch_travel * d_travel_ddot_by_travel_dot;
    let two_elevation_dot = 2.0 * v.elevation;
    let d_two_elevation_dot = p.d * two_elevation_dot;
    // derivatives with respect to elevation_dot
    let by_elevation_dot_1 = I_heli_xx * (omega_heli_y * s_pitch - omega_heli_z * c_pitch);
    let d_two_omega_arm_1_z = p.d * two_omega_arm_1_z;
    let two_omega_arm_1_x_2 = 2.0 * omega_arm_1_x;
    let by_elevation_dot_2 = mc_arm_x * d_two_omega_arm_1_z - 2.0 * I_arm_yy * omega_arm_1_x;
    let by_elevation_dot_3 = d_two_omega_arm_1_z - p.L_a * two_omega_arm_1_x_2;
    let by_elevation_dot_4 = m_heli * (by_elevation_dot_3 * c_pitch + d_two_elevation_dot * s_pitch);
    let by_elevation_dot_5 = m_heli * (d_two_elevation_dot * c_pitch - by_elevation_dot_3 * s_pitch);
    let by_elevation_dot_6 = I_heli_xx * (c_pitch * v.pitch - omega_arm_1_x_c_pitch);
    let by_elevation_dot_7 = by_elevation_dot_1 + I_heli_xx * omega_arm_1_z;
    let by_elevation_dot_8 = by_elevation_dot_6 + two_L_h_L_h_m_h_per_two * omega_heli_x * c_pitch;
    let by_elevation_dot_9 = p.m_s * (d_two_omega_arm_1_z - s_plus_s_0 * two_omega_arm_1_x_2);
    let by_elevation_dot_10 = mc_arm_x * two_elevation_dot + p.m_s * s_plus_s_0 * two_elevation_dot;
    let by_elevation_dot_11 = p.m_w * d_two_omega_arm_1_z - mc_arm_x * two_omega_arm_1_x_2 + by_elevation_dot_9;
    let by_elevation_dot_12 = mc_arm_x * d_two_elevation_dot + p.m_s * s_plus_s_0 * (d_two_elevation_dot + 2.0 * v.s);
    let by_elevation_dot_13 = by_elevation_dot_4 * c_pitch - by_elevation_dot_5 * s_pitch;
    let by_elevation_dot_14 = p.L_a * (by_elevation_dot_4 * s_pitch + by_elevation_dot_5 * c_pitch);
    let by_elevation_dot_15 = by_elevation_dot_8 * c_pitch + p.L_a * by_elevation_dot_13;
    let by_elevation_dot_16 = by_elevation_dot_12 + by_elevation_dot_8 * s_pitch + by_elevation_dot_14;
    let by_elevation_dot_17 = by_elevation_dot_2 + s_plus_s_0 * by_elevation_dot_9 + by_elevation_dot_15;
    let by_elevation_dot_18 = p.d * (-by_elevation_dot_10 - p.L_a * m_heli * two_elevation_dot);
    let by_elevation_dot_19 = s_elevation * (by_elevation_dot_7 + p.d * (by_elevation_dot_11 + by_elevation_dot_13));
    let by_elevation_dot_20 = by_elevation_dot_17 * c_elevation + by_elevation_dot_19;
    let by_elevation_dot_21 = p.c_elevation + by_elevation_dot_18 + by_elevation_dot_16;
    let by_elevation_dot_22 = l_pitch_travel * by_elevation_dot_7 - by_elevation_dot_20 + l_elevation_travel * by_elevation_dot_21;
    let d_travel_ddot_by_elevation_dot = inv_travel * by_elevation_dot_22;
    let d_elevation_ddot_by_elevation_dot = -l_elevation_travel * d_travel_ddot_by_elevation_dot - inv_elevation * by_elevation_dot_21;
    let d_pitch_ddot_by_elevation_dot = -inv_pitch * by_elevation_dot_7 - l_pitch_travel * d_travel_ddot_by_elevation_dot;
    // derivatives with respect to pitch_dot
    let by_pitch_dot_1 = I_heli_xx * gravity_1 - omega_heli_y * two_L_h_L_h_m_h_per_two;
    let by_pitch_dot_1_s_pitch = by_pitch_dot_1 * s_pitch;
    let by_pitch_dot_2 = by_pitch_dot_1 * c_elevation * c_pitch;
    let d_travel_ddot_by_pitch_dot = inv_travel
        * (p.c_pitch * l_pitch_travel - by_pitch_dot_2 + l_elevation_travel * by_pitch_dot_1_s_pitch);
    let d_elevation_ddot_by_pitch_dot = -l_elevation_travel * d_travel_ddot_by_pitch_dot - inv_elevation * by_pitch_dot_1_s_pitch;
    let d_pitch_ddot_by_pitch_dot = -p.c_pitch * inv_pitch - l_pitch_travel * d_travel_ddot_by_pitch_dot;
    let m_s_two_omega_arm_1_z = p.m_s * two_omega_arm_1_z;
    // derivatives with respect to s_dot
    let by_s_dot_1 = p.m_s * s_plus_s_0 * two_elevation_dot;
    let by_s_dot_2 = s_plus_s_0 * m_s_two_omega_arm_1_z * c_elevation;
    let by_s_dot_3 = by_s_dot_2 + p.d * m_s_two_omega_arm_1_z * s_elevation;
    let d_travel_ddot_by_s_dot = -inv_travel * (by_s_dot_3 - l_elevation_travel * by_s_dot_1);
    let d_elevation_ddot_by_s_dot = -inv_elevation * by_s_dot_1 - l_elevation_travel * d_travel_ddot_by_s_dot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_arm_1_x + travel_ddot * s_elevation;
    let slopes_2 = travel_ddot * c_elevation + alpha_arm_1_z;
    let alpha_arm_1_x_plus_slopes_1 = alpha_arm_1_x + slopes_1;
    let slopes_3 = p.d * alpha_arm_1_x_plus_slopes_1;
    let slopes_2_plus_alpha_arm_1_z = slopes_2 + alpha_arm_1_z;
    let slopes_4 = omega_arm_1_z_omega_arm_1_x + elevation_ddot;
    let slopes_5 = I_arm_yy * slopes_2 + I_arm_yy_alpha_arm_1_z + mc_arm_x * slopes_3;
    let slopes_6 = slopes_3 + p.L_a * slopes_2_plus_alpha_arm_1_z;
    let a_arm_z_plus_L_a_slopes_4 = a_arm_z + p.L_a * slopes_4;
    let slopes_7 = elevation_ddot * s_pitch + slopes_2 * c_pitch - omega_heli_y_pitch_dot;
    let slopes_8 = m_heli * (slopes_6 * c_pitch + a_arm_z_plus_L_a_slopes_4 * s_pitch);
    let slopes_9 = m_heli * (a_arm_z_plus_L_a_slopes_4 * c_pitch - slopes_6 * s_pitch);
    let slopes_10 = I_heli_xx * slopes_7 - heli_3;
    let slopes_11 = p.m_s * (two_omega_arm_1_z_s_dot + slopes_3 + s_plus_s_0 * slopes_2_plus_alpha_arm_1_z);
    let slopes_12 = p.m_s * (two_elevation_dot_s_dot + a_arm_z + s_plus_s_0 * slopes_4);
    let slopes_13 = slopes_9 - f_applied_heli_z;
    let slopes_14 = heli_2 + I_heli_xx * (slopes_1 + pitch_ddot) - n_applied_heli_x;
    let slopes_15 = p.m_w * slopes_3 + mc_arm_x * slopes_2_plus_alpha_arm_1_z + slopes_11;
    let slopes_16 = slopes_5 + s_plus_s_0 * slopes_11;
    let slopes_8_c_pitch = slopes_8 * c_pitch;
    let slopes_13_s_pitch = slopes_13 * s_pitch;
    let slopes_8_s_pitch = slopes_8 * s_pitch;
    let slopes_17 = slopes_8_c_pitch - slopes_13_s_pitch;
    let slopes_10_c_pitch = slopes_10 * c_pitch;
    let slopes_18 = s_elevation * (slopes_16 + slopes_10_c_pitch + p.L_a * slopes_17);
    let slopes_19 = c_elevation * (slopes_14 + p.d * (slopes_15 + slopes_17));
    let slopes_20 = p.d * slopes_2_plus_alpha_arm_1_z;
    let slopes_21 = I_arm_yy * alpha_arm_1_x - mc_arm_x * slopes_20 + I_arm_yy * slopes_1;
    let slopes_22 = slopes_20 - p.L_a * alpha_arm_1_x_plus_slopes_1;
    let slopes_23 = m_heli * (by_elevation_5 * s_pitch + slopes_22 * c_pitch);
    let slopes_24 = m_heli * (by_elevation_5 * c_pitch - slopes_22 * s_pitch);
    let I_heli_xx_slopes_2 = I_heli_xx * slopes_2;
    let slopes_25 = I_heli_xx * (omega_arm_1_x_s_pitch * v.pitch - slopes_1 * c_pitch);
    let slopes_26 = slopes_25 - by_elevation_3;
    let slopes_27 = p.m_s * (slopes_20 - 2.0 * omega_arm_1_x * v.s - s_plus_s_0 * alpha_arm_1_x_plus_slopes_1);
    let slopes_28 = p.m_w * slopes_20 - mc_arm_x * alpha_arm_1_x_plus_slopes_1 + slopes_27;
    let slopes_29 = slopes_23 * c_pitch - slopes_24 * s_pitch;
    let slopes_30 = p.L_a * (slopes_23 * s_pitch + slopes_24 * c_pitch);
    let slopes_31 = slopes_26 * c_pitch + p.L_a * slopes_29;
    let slopes_32 = by_elevation_10 + slopes_26 * s_pitch + slopes_30;
    let slopes_33 = s_plus_s_0 * slopes_27 - slopes_21 + slopes_31;
    let slopes_34 = I_heli_xx_slopes_2 - by_elevation_2 + p.d * (slopes_28 + slopes_29);
    let slopes_35 = slopes_19 + slopes_34 * s_elevation;
    let slopes_36 = slopes_33 * c_elevation - slopes_18 + slopes_35;
    let slopes_37 = elevation_ddot * c_pitch - slopes_2 * s_pitch;
    let slopes_38 = I_heli_xx * (slopes_37 - omega_heli_z * v.pitch);
    let slopes_39 = slopes_38 - omega_heli_z * omega_heli_x * two_L_h_L_h_m_h_per_two;
    let slopes_40 = slopes_13 * c_pitch - slopes_8_s_pitch;
    let slopes_41 = slopes_8_c_pitch + slopes_9 * s_pitch;
    let slopes_42 = slopes_9 * c_pitch - slopes_8_s_pitch - slopes_40;
    let slopes_43 = slopes_39 * c_pitch - slopes_10 * s_pitch;
    let slopes_44 = p.L_a * (slopes_41 - slopes_8_c_pitch - slopes_13_s_pitch);
    let slopes_45 = slopes_10_c_pitch + slopes_39 * s_pitch + slopes_44;
    let slopes_46 = c_elevation * (slopes_43 + p.L_a * slopes_42);
    let slopes_47 = slopes_46 + s_elevation * (by_pitch_1 + p.d * slopes_42);
    let slopes_48 = p.m_s * slopes_2_plus_alpha_arm_1_z;
    let slopes_49 = slopes_12 + p.m_s * s_plus_s_0 * slopes_4;
    let slopes_50 = c_elevation * (slopes_11 + s_plus_s_0 * slopes_48);
    let slopes_51 = slopes_50 + p.d * slopes_48 * s_elevation;
    // derivatives with respect to elevation
    let by_elevation_12 = slopes_32 + by_elevation_11;
    let by_elevation_13 = by_elevation_2 - I_heli_xx_slopes_2;
    let by_elevation_14 = l_elevation_travel * by_elevation_12 - slopes_36 - l_pitch_travel * by_elevation_13;
    let d_travel_ddot_by_elevation = inv_travel * by_elevation_14;
    let d_elevation_ddot_by_elevation = -inv_elevation * by_elevation_12 - l_elevation_travel * d_travel_ddot_by_elevation;
    let d_pitch_ddot_by_elevation = inv_pitch * by_elevation_13 - l_pitch_travel * d_travel_ddot_by_elevation;
    // derivatives with respect to pitch
    let by_pitch_2 = l_pitch_travel * by_pitch_1 - slopes_47 + l_elevation_travel * slopes_45;
    let d_travel_ddot_by_pitch = inv_travel * by_pitch_2;
    let d_elevation_ddot_by_pitch = -l_elevation_travel * d_travel_ddot_by_pitch - inv_elevation * slopes_45;
    let d_pitch_ddot_by_pitch = -inv_pitch * by_pitch_1 - l_pitch_travel * d_travel_ddot_by_pitch;
    let d_m_s_arm_1_minus_slopes_49 = p.d * p.m_s * arm_1 - slopes_49;
    // derivatives with respect to s
    let d_travel_ddot_by_s = inv_travel * (-l_elevation_travel * d_m_s_arm_1_minus_slopes_49 - slopes_51);
    let d_elevation_ddot_by_s = inv_elevation * d_m_s_arm_1_minus_slopes_49 - l_elevation_travel * d_travel_ddot_by_s;
    // derivatives with respect to V_f
    let by_V_f_1 = L_a_K_f_s_pitch_c_elevation + s_elevation * (d_K_f_s_pitch - L_h_K_f);
    let by_V_f_2 = l_elevation_travel * L_a_K_f_c_pitch;
    let l_pitch_travel_L_h_K_f = l_pitch_travel * L_h_K_f;
    let d_travel_ddot_by_V_f = inv_travel * (-by_V_f_2 - by_V_f_1 - l_pitch_travel_L_h_K_f);
    let by_V_f_3 = inv_elevation * L_a_K_f_c_pitch;
    let inv_pitch_L_h_K_f = inv_pitch * L_h_K_f;
    // derivatives with respect to V_b
    let d_travel_ddot_by_V_b = inv_travel * (l_pitch_travel_L_h_K_f - by_V_f_2 - input_map_1);
    // derivatives with respect to s_ddot
    let d_travel_ddot_by_s_ddot = inv_travel * d_m_s * l_elevation_travel;
    let d_elevation_ddot_by_s_ddot = -d_m_s * inv_elevation - l_elevation_travel * d_travel_ddot_by_s_ddot;
    positive(I_heli_xx, 2)?;
    positive(M_elevation_elevation, 1)?;
    positive(pivot_travel, 0)?;
    Ok(Linearization {
        dx: [v.travel, v.elevation, v.pitch, v.s, travel_ddot, elevation_ddot, pitch_ddot, u.s_ddot],
        a: [
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], // travel'
            [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0], // elevation'
            [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0], // pitch'
            [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], // s'
            // travel''
            [
                0.0, d_travel_ddot_by_elevation, d_travel_ddot_by_pitch, d_travel_ddot_by_s, d_travel_ddot_by_travel_dot,
                d_travel_ddot_by_elevation_dot, d_travel_ddot_by_pitch_dot, d_travel_ddot_by_s_dot,
            ],
            // elevation''
            [
                0.0, d_elevation_ddot_by_elevation, d_elevation_ddot_by_pitch, d_elevation_ddot_by_s, d_elevation_ddot_by_travel_dot,
                d_elevation_ddot_by_elevation_dot, d_elevation_ddot_by_pitch_dot, d_elevation_ddot_by_s_dot,
            ],
            // pitch''
            [
                0.0, d_pitch_ddot_by_elevation, d_pitch_ddot_by_pitch, -l_pitch_travel * d_travel_ddot_by_s, d_pitch_ddot_by_travel_dot,
                d_pitch_ddot_by_elevation_dot, d_pitch_ddot_by_pitch_dot, -l_pitch_travel * d_travel_ddot_by_s_dot,
            ],
            [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], // s''
        ],
        b: [
            [0.0, 0.0, 0.0], // travel'
            [0.0, 0.0, 0.0], // elevation'
            [0.0, 0.0, 0.0], // pitch'
            [0.0, 0.0, 0.0], // s'
            [d_travel_ddot_by_V_f, d_travel_ddot_by_V_b, d_travel_ddot_by_s_ddot], // travel''
            // elevation''
            [
                by_V_f_3 - l_elevation_travel * d_travel_ddot_by_V_f, by_V_f_3 - l_elevation_travel * d_travel_ddot_by_V_b,
                d_elevation_ddot_by_s_ddot,
            ],
            // pitch''
            [
                inv_pitch_L_h_K_f - l_pitch_travel * d_travel_ddot_by_V_f, -inv_pitch_L_h_K_f - l_pitch_travel * d_travel_ddot_by_V_b,
                -l_pitch_travel * d_travel_ddot_by_s_ddot,
            ],
            [0.0, 0.0, 1.0], // s''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 8 x 13; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 13]; 8], Singular> {
    let State { q, v } = x;
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let V_s = u.V_f + u.V_b;
    let F_f = p.K_f * u.V_f;
    let F_b = p.K_f * u.V_b;
    let s_plus_s_0 = q.s + p.s_0;
    let two_elevation_dot_s_dot = 2.0 * v.elevation * v.s;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    let m_h_per_two = p.m_h / 2.0;
    let L_h_m_h_per_two = p.L_h * m_h_per_two;
    let L_h_L_h_m_h_per_two = p.L_h * L_h_m_h_per_two;
    // frame heli on arm
    let m_heli = 2.0 * m_h_per_two;
    let I_heli_xx = 2.0 * L_h_L_h_m_h_per_two;
    let two_L_h_L_h_m_h_per_two = 2.0 * L_h_L_h_m_h_per_two;
    let M_travel_pitch = I_heli_xx * s_elevation;
    let heli_1 = two_L_h_L_h_m_h_per_two * c_pitch;
    let heli_1_c_pitch = heli_1 * c_pitch;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    let a_arm_1_x = p.g * s_elevation;
    let M_travel_elevation = heli_1 * c_elevation * s_pitch;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let omega_heli_y_pitch_dot = omega_heli_y * v.pitch;
    let heli_2 = I_heli_xx * (omega_heli_y_pitch_dot - alpha_arm_1_z * c_pitch);
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let heli_3 = omega_heli_y * (v.pitch + omega_arm_1_x);
    let n_moving_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y_omega_heli_z;
    let n_moving_heli_z = -heli_3 * two_L_h_L_h_m_h_per_two - heli_2;
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    // frame arm on column
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let arm_1 = omega_arm_1_x * omega_arm_1_x + elevation_dot_sq;
    let arm_2 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let mc_arm_x_arm_2 = mc_arm_x * arm_2;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    let a_arm_x = a_arm_1_x - p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_z = p.d * arm_1 + p.g * c_elevation;
    let arm_3 = I_arm_yy + s_plus_s_0 * m_s_s_plus_s_0;
    let d_d_m_heli_plus_m_w_plus_m_s = p.d * p.d * (m_heli + p.m_w + p.m_s);
    let arm_4 = I_heli_xx + d_d_m_heli_plus_m_w_plus_m_s;
    let L_a_arm_2 = p.L_a * arm_2;
    // frame heli on arm
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_z = p.L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    let s_plus_s_0_arm_2 = s_plus_s_0 * arm_2;
    let two_omega_arm_1_z_s_dot = 2.0 * omega_arm_1_z * v.s;
    // frame rail on arm
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + two_omega_arm_1_z_s_dot;
    let f_moving_rail_y = p.m_s * a_rail_y;
    let a_rail_z = two_elevation_dot_s_dot + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    let f_net_rail_x = p.m_s * (u.s_ddot + a_arm_x - s_plus_s_0_arm_2);
    // frame arm on column
    let arm_5 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_moving_rail_y;
    let arm_6 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    let M_elevation_elevation = arm_3 + I_heli_xx - heli_1_c_pitch + L_a_L_a_m_heli + d_d_m_heli_plus_m_w_plus_m_s;
    let f_net_arm_x = m_heli * (a_arm_x - L_a_arm_2) - mc_arm_x_arm_2 + p.m_w * a_arm_x + f_net_rail_x;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_y = m_heli * a_heli_y;
    // frame arm on column
    let arm_1_1 = arm_3 + L_a_L_a_m_heli + heli_1_c_pitch - arm_4;
    let arm_1_2 = 2.0 * p.d * s_elevation * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli);
    let arm_1_3 = c_elevation * (arm_1_1 * c_elevation + arm_1_2);
    // force back on heli
    let f_applied_heli_z = F_f + F_b;
    let n_applied_heli_x = p.L_h * F_f - p.L_h * F_b;
    // frame rail on arm
    let f_net_heli_z = m_heli * a_heli_z - f_applied_heli_z;
    let n_net_heli_x = n_moving_heli_x - n_applied_heli_x;
    // frame heli on arm
    let f_net_heli_1_y = f_heli_y * c_pitch - f_net_heli_z * s_pitch;
    let f_net_heli_1_z = f_heli_y * s_pitch + f_net_heli_z * c_pitch;
    // frame arm on column
    let f_net_arm_y = f_moving_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_net_heli_1_y;
    let n_net_arm_y = -arm_6 - n_moving_heli_z * s_pitch - p.L_a * f_net_heli_1_z;
    let n_net_arm_z = arm_5 + n_moving_heli_z * c_pitch + p.L_a * f_net_heli_1_y;
    let n_net_column_z = n_net_arm_z * c_elevation + s_elevation * (n_net_heli_x + p.d * f_net_arm_y);
    // balance of forces
    let tau_elevation = n_net_arm_y - p.c_elevation * v.elevation - p.d * f_net_arm_x;
    let tau_pitch = -p.c_pitch * v.pitch - n_net_heli_x;
    // M = L^T D L and back-substitution
    let inv_pitch = 1.0 / I_heli_xx;
    let l_pitch_travel = M_travel_pitch * inv_pitch;
    let inv_elevation = 1.0 / M_elevation_elevation;
    let l_elevation_travel = M_travel_elevation * inv_elevation;
    let solve_1 = arm_4 + arm_1_3 - M_travel_elevation * l_elevation_travel;
    let pivot_travel = solve_1 - M_travel_pitch * l_pitch_travel;
    let inv_travel = 1.0 / pivot_travel;
    let solve_2 = tau_pitch * l_pitch_travel + p.c_travel * v.travel + n_net_column_z + tau_elevation * l_elevation_travel;
    let travel_ddot = -inv_travel * solve_2;
    let elevation_ddot = tau_elevation * inv_elevation - l_elevation_travel * travel_ddot;
    let pitch_ddot = tau_pitch * inv_pitch - l_pitch_travel * travel_ddot;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_arm_1_x + travel_ddot * s_elevation;
    let slopes_2 = travel_ddot * c_elevation + alpha_arm_1_z;
    let alpha_arm_1_x_plus_slopes_1 = alpha_arm_1_x + slopes_1;
    let slopes_3 = p.d * alpha_arm_1_x_plus_slopes_1;
    let m_w_slopes_3 = p.m_w * slopes_3;
    let slopes_2_plus_alpha_arm_1_z = slopes_2 + alpha_arm_1_z;
    let slopes_4 = omega_arm_1_z_omega_arm_1_x + elevation_ddot;
    let slopes_5 = slopes_3 + p.L_a * slopes_2_plus_alpha_arm_1_z;
    let a_arm_z_plus_L_a_slopes_4 = a_arm_z + p.L_a * slopes_4;
    let slopes_6 = elevation_ddot * s_pitch + slopes_2 * c_pitch - omega_heli_y_pitch_dot;
    let slopes_1_plus_pitch_ddot = slopes_1 + pitch_ddot;
    let slopes_7 = slopes_5 * c_pitch + a_arm_z_plus_L_a_slopes_4 * s_pitch;
    let slopes_8 = a_arm_z_plus_L_a_slopes_4 * c_pitch - slopes_5 * s_pitch;
    let m_heli_slopes_7 = m_heli * slopes_7;
    let slopes_9 = two_omega_arm_1_z_s_dot + slopes_3 + s_plus_s_0 * slopes_2_plus_alpha_arm_1_z;
    let slopes_10 = two_elevation_dot_s_dot + a_arm_z + s_plus_s_0 * slopes_4;
    let m_s_slopes_9 = p.m_s * slopes_9;
    let slopes_11 = m_heli * slopes_8 - f_applied_heli_z;
    let slopes_12 = m_heli_slopes_7 * c_pitch - slopes_11 * s_pitch;
    let slopes_13 = m_w_slopes_3 + mc_arm_x * slopes_2_plus_alpha_arm_1_z + m_s_slopes_9 + slopes_12;
    let slopes_14 = p.m_s * slopes_2_plus_alpha_arm_1_z;
    let slopes_15 = p.m_s * slopes_10 + p.m_s * s_plus_s_0 * slopes_4;
    let slopes_16 = c_elevation * (m_s_slopes_9 + s_plus_s_0 * slopes_14);
    let slopes_17 = slopes_16 + p.d * slopes_14 * s_elevation;
    let slopes_18 = a_arm_1_x - p.d * (omega_arm_1_z_omega_arm_1_x - elevation_ddot);
    let slopes_18_minus_L_a_arm_2 = slopes_18 - L_a_arm_2;
    let slopes_19 = u.s_ddot + slopes_18 - s_plus_s_0_arm_2;
    let slopes_20 = p.m_w * slopes_18 - mc_arm_x_arm_2 + p.m_s * slopes_19;
    let slopes_21 = m_heli_slopes_7 * s_pitch + slopes_11 * c_pitch;
    let slopes_22 = slopes_7 * c_pitch - slopes_8 * s_pitch;
    let slopes_23 = p.L_a * (slopes_7 * s_pitch + slopes_8 * c_pitch);
    let d_L_w_arm_2_plus_slopes_18 = p.d * (p.L_w * arm_2 + slopes_18);
    let slopes_24 = p.d * s_elevation * (slopes_3 - p.L_w * slopes_2_plus_alpha_arm_1_z);
    let slopes_25 = m_heli * (slopes_2_plus_alpha_arm_1_z * c_pitch + slopes_4 * s_pitch);
    let slopes_26 = m_heli * (slopes_4 * c_pitch - slopes_2_plus_alpha_arm_1_z * s_pitch);
    let slopes_27 = slopes_25 * c_pitch - slopes_26 * s_pitch;
    let slopes_28 = p.L_a * (slopes_25 * s_pitch + slopes_26 * c_pitch);
    let slopes_29 = c_elevation * (slopes_12 + p.L_a * slopes_27);
    let slopes_30 = slopes_29 + p.d * slopes_27 * s_elevation;
    let slopes_31 = elevation_ddot - omega_arm_1_z_omega_arm_1_x;
    let slopes_32 = m_heli * (arm_1 * s_pitch + alpha_arm_1_x_plus_slopes_1 * c_pitch);
    let slopes_33 = m_heli * (arm_1 * c_pitch - alpha_arm_1_x_plus_slopes_1 * s_pitch);
    let slopes_34 = p.m_s * alpha_arm_1_x_plus_slopes_1;
    let slopes_35 = s_plus_s_0 * slopes_34 + mc_arm_x * alpha_arm_1_x_plus_slopes_1;
    let slopes_36 = slopes_32 * c_pitch - slopes_33 * s_pitch;
    let slopes_37 = p.L_a * (slopes_32 * s_pitch + slopes_33 * c_pitch);
    let slopes_38 = p.d * (p.m_w * alpha_arm_1_x_plus_slopes_1 + slopes_34 + slopes_36);
    let slopes_39 = p.d * (m_heli * slopes_31 + p.m_w * slopes_31 + p.m_s * slopes_31);
    let slopes_40 = m_heli * slopes_18_minus_L_a_arm_2 + slopes_20 + slopes_39;
    let slopes_41 = c_elevation * (slopes_35 + p.L_a * slopes_36);
    let slopes_42 = slopes_41 + s_elevation * (slopes_13 + slopes_38);
    let slopes_43 = s_plus_s_0 * slopes_10 + p.d * slopes_19;
    let slopes_44 = s_plus_s_0 * slopes_9 * c_elevation;
    let slopes_45 = slopes_44 + p.d * slopes_9 * s_elevation;
    let d_m_s_arm_2_minus_slopes_15 = p.d * p.m_s * arm_2 - slopes_15;
    // derivatives with respect to s
    let d_travel_ddot_by_s = inv_travel * (-l_elevation_travel * d_m_s_arm_2_minus_slopes_15 - slopes_17);
    let d_elevation_ddot_by_s = inv_elevation * d_m_s_arm_2_minus_slopes_15 - l_elevation_travel * d_travel_ddot_by_s;
    let half_L_h_L_h = 0.5 * p.L_h * p.L_h;
    let two_half_L_h_L_h = 2.0 * half_L_h_L_h;
    let L_w_sq = p.L_w * p.L_w;
    let two_mc_arm_x = 2.0 * mc_arm_x;
    let four_L_h_m_h_per_two = 4.0 * L_h_m_h_per_two;
    let F_f_minus_F_b = F_f - F_b;
    // derivatives with respect to d
    let by_d_1 = mc_arm_x * arm_1 + p.m_s * s_plus_s_0 * arm_1;
    let by_d_2 = by_d_1 + slopes_37 + slopes_40;
    let d_travel_ddot_by_d = inv_travel * (l_elevation_travel * by_d_2 - slopes_42);
    let d_elevation_ddot_by_d = -inv_elevation * by_d_2 - l_elevation_travel * d_travel_ddot_by_d;
    let L_h_V_f = p.L_h * u.V_f;
    let L_h_V_b = p.L_h * u.V_b;
    let L_h_V_f_minus_L_h_V_b = L_h_V_f - L_h_V_b;
    let V_s_s_pitch = V_s * s_pitch;
    let L_a_V_s_c_pitch = p.L_a * V_s * c_pitch;
    // derivatives with respect to K_f
    let by_K_f_1 = s_elevation * (L_h_V_b - L_h_V_f + p.d * V_s_s_pitch);
    let by_K_f_2 = p.L_a * V_s_s_pitch * c_elevation + by_K_f_1;
    let by_K_f_3 = l_elevation_travel * L_a_V_s_c_pitch + by_K_f_2 + l_pitch_travel * L_h_V_f_minus_L_h_V_b;
    let d_travel_ddot_by_K_f = -inv_travel * by_K_f_3;
    let d_elevation_ddot_by_K_f = inv_elevation * L_a_V_s_c_pitch - l_elevation_travel * d_travel_ddot_by_K_f;
    let d_pitch_ddot_by_K_f = inv_pitch * L_h_V_f_minus_L_h_V_b - l_pitch_travel * d_travel_ddot_by_K_f;
    let m_heli_c_elevation_s_pitch = m_heli * c_elevation * s_pitch;
    let m_heli_c_elevation_c_pitch = m_heli * c_elevation * c_pitch;
    // derivatives with respect to g
    let by_g_1 = mc_arm_x * c_elevation + p.m_s * s_plus_s_0 * c_elevation;
    let by_g_2 = m_heli_c_elevation_s_pitch * c_pitch - m_heli_c_elevation_c_pitch * s_pitch;
    let by_g_3 = p.L_a * (m_heli_c_elevation_s_pitch * s_pitch + m_heli_c_elevation_c_pitch * c_pitch);
    let by_g_4 = p.d * (m_heli * s_elevation + p.m_s * s_elevation + p.m_w * s_elevation);
    let by_g_5 = p.L_a * by_g_2 * c_elevation + p.d * by_g_2 * s_elevation;
    let by_g_6 = by_g_1 + by_g_3 + by_g_4;
    let d_travel_ddot_by_g = inv_travel * (l_elevation_travel * by_g_6 - by_g_5);
    let d_elevation_ddot_by_g = -inv_elevation * by_g_6 - l_elevation_travel * d_travel_ddot_by_g;
    // slopes of the balance of forces, at the accelerations found
    let slopes_46 = omega_heli_y_omega_heli_z * two_half_L_h_L_h + slopes_1_plus_pitch_ddot * two_half_L_h_L_h;
    let slopes_47 = slopes_6 * two_half_L_h_L_h - 2.0 * heli_3 * half_L_h_L_h;
    let slopes_48 = slopes_47 * s_pitch + slopes_23 + p.d * slopes_18_minus_L_a_arm_2;
    let slopes_49 = c_elevation * (slopes_47 * c_pitch + p.L_a * slopes_22);
    let slopes_50 = slopes_49 + s_elevation * (slopes_46 + p.d * slopes_22);
    let slopes_51 = slopes_2 * L_w_sq + alpha_arm_1_z * L_w_sq;
    let slopes_52 = p.L_w * a_arm_z - omega_arm_1_z_omega_arm_1_x * L_w_sq - elevation_ddot * L_w_sq;
    let slopes_53 = c_elevation * (slopes_51 - p.L_w * slopes_3) + slopes_24;
    let slopes_54 = p.m_w * a_arm_z + omega_arm_1_z_omega_arm_1_x * two_mc_arm_x + elevation_ddot * two_mc_arm_x;
    let slopes_55 = slopes_2 * two_mc_arm_x + alpha_arm_1_z * two_mc_arm_x + m_w_slopes_3;
    let slopes_56 = omega_heli_y_omega_heli_z * four_L_h_m_h_per_two + slopes_1_plus_pitch_ddot * four_L_h_m_h_per_two;
    let slopes_57 = slopes_6 * four_L_h_m_h_per_two - 4.0 * heli_3 * L_h_m_h_per_two;
    let slopes_57_s_pitch = slopes_57 * s_pitch;
    let slopes_58 = s_elevation * (slopes_56 - F_f_minus_F_b);
    let slopes_59 = slopes_57 * c_elevation * c_pitch + slopes_58;
    // derivatives with respect to m_h
    let by_m_h_1 = l_pitch_travel * slopes_46 - slopes_50 + l_elevation_travel * slopes_48;
    let d_travel_ddot_by_m_h = inv_travel * by_m_h_1;
    let d_elevation_ddot_by_m_h = -l_elevation_travel * d_travel_ddot_by_m_h - inv_elevation * slopes_48;
    let d_pitch_ddot_by_m_h = -inv_pitch * slopes_46 - l_pitch_travel * d_travel_ddot_by_m_h;
    // derivatives with respect to m_w
    let by_m_w_1 = slopes_52 - d_L_w_arm_2_plus_slopes_18;
    let d_travel_ddot_by_m_w = inv_travel * (-l_elevation_travel * by_m_w_1 - slopes_53);
    let d_elevation_ddot_by_m_w = inv_elevation * by_m_w_1 - l_elevation_travel * d_travel_ddot_by_m_w;
    // derivatives with respect to L_a
    let by_L_a_1 = p.d * m_heli * arm_2 - slopes_21 - slopes_28;
    let d_travel_ddot_by_L_a = inv_travel * (-l_elevation_travel * by_L_a_1 - slopes_30);
    let d_elevation_ddot_by_L_a = inv_elevation * by_L_a_1 - l_elevation_travel * d_travel_ddot_by_L_a;
    // derivatives with respect to L_w
    let by_L_w_1 = p.m_w * p.d * slopes_2_plus_alpha_arm_1_z * s_elevation + slopes_55 * c_elevation;
    let slopes_54_minus_d_m_w_arm_2 = slopes_54 - p.m_w * p.d * arm_2;
    let d_travel_ddot_by_L_w = inv_travel * (by_L_w_1 - l_elevation_travel * slopes_54_minus_d_m_w_arm_2);
    let d_elevation_ddot_by_L_w = inv_elevation * slopes_54_minus_d_m_w_arm_2 - l_elevation_travel * d_travel_ddot_by_L_w;
    // derivatives with respect to L_h
    let by_L_h_1 = F_f_minus_F_b - slopes_56;
    let by_L_h_2 = slopes_59 - l_elevation_travel * slopes_57_s_pitch + l_pitch_travel * by_L_h_1;
    let d_travel_ddot_by_L_h = -inv_travel * by_L_h_2;
    let d_elevation_ddot_by_L_h = -inv_elevation * slopes_57_s_pitch - l_elevation_travel * d_travel_ddot_by_L_h;
    let d_pitch_ddot_by_L_h = inv_pitch * by_L_h_1 - l_pitch_travel * d_travel_ddot_by_L_h;
    // derivatives with respect to c_travel
    let d_travel_ddot_by_c_travel = -inv_travel * v.travel;
    // derivatives with respect to c_elevation
    let d_travel_ddot_by_c_elevation = inv_travel * l_elevation_travel * v.elevation;
    let d_elevation_ddot_by_c_elevation = -inv_elevation * v.elevation - l_elevation_travel * d_travel_ddot_by_c_elevation;
    // derivatives with respect to c_pitch
    let d_travel_ddot_by_c_pitch = inv_travel * l_pitch_travel * v.pitch;
    let d_pitch_ddot_by_c_pitch = -inv_pitch * v.pitch - l_pitch_travel * d_travel_ddot_by_c_pitch;
    // derivatives with respect to m_s
    let d_travel_ddot_by_m_s = -inv_travel * (slopes_45 - l_elevation_travel * slopes_43);
    let d_elevation_ddot_by_m_s = -inv_elevation * slopes_43 - l_elevation_travel * d_travel_ddot_by_m_s;
    positive(I_heli_xx, 2)?;
    positive(M_elevation_elevation, 1)?;
    positive(pivot_travel, 0)?;
    Ok([
        [0.0; 13], // travel'
        [0.0; 13], // elevation'
        [0.0; 13], // pitch'
        [0.0; 13], // s'
        // travel''
        Parameters {
            m_h: d_travel_ddot_by_m_h,
            m_w: d_travel_ddot_by_m_w,
            L_a: d_travel_ddot_by_L_a,
            L_w: d_travel_ddot_by_L_w,
            L_h: d_travel_ddot_by_L_h,
            d: d_travel_ddot_by_d,
            K_f: d_travel_ddot_by_K_f,
            c_travel: d_travel_ddot_by_c_travel,
            c_elevation: d_travel_ddot_by_c_elevation,
            c_pitch: d_travel_ddot_by_c_pitch,
            g: d_travel_ddot_by_g,
            m_s: d_travel_ddot_by_m_s,
            s_0: d_travel_ddot_by_s,
        }
        .to_array(),
        // elevation''
        Parameters {
            m_h: d_elevation_ddot_by_m_h,
            m_w: d_elevation_ddot_by_m_w,
            L_a: d_elevation_ddot_by_L_a,
            L_w: d_elevation_ddot_by_L_w,
            L_h: d_elevation_ddot_by_L_h,
            d: d_elevation_ddot_by_d,
            K_f: d_elevation_ddot_by_K_f,
            c_travel: -l_elevation_travel * d_travel_ddot_by_c_travel,
            c_elevation: d_elevation_ddot_by_c_elevation,
            c_pitch: -l_elevation_travel * d_travel_ddot_by_c_pitch,
            g: d_elevation_ddot_by_g,
            m_s: d_elevation_ddot_by_m_s,
            s_0: d_elevation_ddot_by_s,
        }
        .to_array(),
        // pitch''
        Parameters {
            m_h: d_pitch_ddot_by_m_h,
            m_w: -l_pitch_travel * d_travel_ddot_by_m_w,
            L_a: -l_pitch_travel * d_travel_ddot_by_L_a,
            L_w: -l_pitch_travel * d_travel_ddot_by_L_w,
            L_h: d_pitch_ddot_by_L_h,
            d: -l_pitch_travel * d_travel_ddot_by_d,
            K_f: d_pitch_ddot_by_K_f,
            c_travel: -l_pitch_travel * d_travel_ddot_by_c_travel,
            c_elevation: -l_pitch_travel * d_travel_ddot_by_c_elevation,
            c_pitch: d_pitch_ddot_by_c_pitch,
            g: -l_pitch_travel * d_travel_ddot_by_g,
            m_s: -l_pitch_travel * d_travel_ddot_by_m_s,
            s_0: -l_pitch_travel * d_travel_ddot_by_s,
        }
        .to_array(),
        [0.0; 13], // s''
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 4 x 8.
    pub by_x: [[f64; 8]; 4],
    /// dy/dp, 4 x 13.
    pub by_p: [[f64; 13]; 4],
}

/// Jacobians of the measured outputs.
#[must_use]
pub fn output_jacobian(_x: &State, _p: &Parameters) -> OutputJacobian {
    OutputJacobian {
        by_x: [
            [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], // travel
            [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], // elevation
            [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], // pitch
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0], // s
        ],
        by_p: [
            [0.0; 13], // travel
            [0.0; 13], // elevation
            [0.0; 13], // pitch
            [0.0; 13], // s
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 8] = ["travel", "elevation", "pitch", "s", "travel.dot", "elevation.dot", "pitch.dot", "s.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 3] = ["V_f", "V_b", "s.ddot"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 13] = [
    "m_h", "m_w", "L_a", "L_w", "L_h", "d", "K_f", "c_travel", "c_elevation", "c_pitch", "g", "m_s", "s_0",
];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 13] = ["kg", "kg", "m", "m", "m", "m", "N/V", "N*m*s", "N*m*s", "N*m*s", "m/s^2", "kg", "m"];
/// Names of the measured outputs.
pub const OUTPUT_NAMES: [&str; 4] = ["travel", "elevation", "pitch", "s"];
/// Units of the measured outputs.
pub const OUTPUT_UNITS: [&str; 4] = ["rad", "rad", "rad", "m"];

/// The rig behind the model trait: slices in, slices out, over the functions above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct QuanserAds;

impl Names for QuanserAds {
    fn rig(&self) -> &str {
        "QuanserAds"
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

impl Model for QuanserAds {
    fn dimensions(&self) -> Dimensions {
        Dimensions { coordinates: 4, lags: 0, inputs: 2, exogenous: 1, parameters: 13, outputs: 4 }
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
            0 => OutputPath { quantum: 0.0007669903939428206, wrapped: false, delay: 0.0, play: 0.0 },
            1 => OutputPath { quantum: 0.0015339807878856412, wrapped: false, delay: 0.0, play: 0.0 },
            2 => OutputPath { quantum: 0.0015339807878856412, wrapped: false, delay: 0.0, play: 0.0 },
            3 => OutputPath { quantum: 2.0671407309409624e-6, wrapped: false, delay: 0.0, play: 0.0 },
            _ => OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false },
        }
    }
}
