//! Quanser 3-DOF helicopter with the active disturbance system, its carriage moved from outside.
//! Generated from `quanser_ads.rig` (model 5d570299); edit the rig, not this file.
//!
//! A carriage on a ball screw slides along the arm and disturbs elevation and travel. Here its position
//! loop is taken to be stiff: its acceleration s.ddot is a signal, and it reacts on the arm. Travel
//! 11 in with home in the middle, at most 0.08 m/s (Quanser's manual of the active disturbance system); the
//! carriage's mass and the rail's place along the arm are not published.
//!
//! 229 operations forward, 867 with A and B. Derived twice, body by body and by Lagrange: they agree; the power balance holds.
//!
//! M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.
#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]

use runtime::math::{sin, sin_cos};
use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular, positive};

/// Parameters p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// front rotor; both rotors 1.308 kg [kg]
    pub m_f: f64,
    /// back rotor [kg]
    pub m_b: f64,
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
        m_f: 0.654,
        m_b: 0.654,
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
    pub const fn from_array(values: [f64; 14]) -> Self {
        let [m_f, m_b, m_w, L_a, L_w, L_h, d, K_f, c_travel, c_elevation, c_pitch, g, m_s, s_0] = values;
        Self { m_f, m_b, m_w, L_a, L_w, L_h, d, K_f, c_travel, c_elevation, c_pitch, g, m_s, s_0 }
    }

    /// As an array in the model's order.
    #[inline]
    #[must_use]
    pub const fn to_array(&self) -> [f64; 14] {
        [
            self.m_f, self.m_b, self.m_w, self.L_a, self.L_w, self.L_h, self.d, self.K_f, self.c_travel, self.c_elevation, self.c_pitch,
            self.g, self.m_s, self.s_0,
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
    // frame rail on arm
    let s_plus_s_0 = q.s + p.s_0;
    let d_m_s = p.d * p.m_s;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    // body front_rotor on heli
    let m_f_L_h = p.m_f * p.L_h;
    // body back_rotor on heli
    let m_b_L_h = p.m_b * p.L_h;
    // frame heli on arm
    let m_heli = p.m_f + p.m_b;
    let mc_heli_y = m_f_L_h - m_b_L_h;
    let I_heli_xx = p.L_h * m_f_L_h + p.L_h * m_b_L_h;
    let mc_heli_y_s_pitch = mc_heli_y * s_pitch;
    let mc_heli_y_c_pitch = mc_heli_y * c_pitch;
    let M_elevation_pitch = p.L_a * mc_heli_y_c_pitch;
    let L_a_mc_heli_y_s_pitch = p.L_a * mc_heli_y_s_pitch;
    let M_travel_pitch = s_elevation * (I_heli_xx - p.d * mc_heli_y_s_pitch) - L_a_mc_heli_y_s_pitch * c_elevation;
    let I_heli_xx_c_pitch = I_heli_xx * c_pitch;
    let I_heli_xx_c_pitch_c_pitch = I_heli_xx_c_pitch * c_pitch;
    // frame arm on column
    let arm_1 = s_plus_s_0 * m_s_s_plus_s_0 - p.L_w * mc_arm_x;
    let arm_2 = p.d * (mc_heli_y_s_pitch + mc_heli_y_s_pitch - p.d * (m_heli + p.m_w + p.m_s));
    let I_heli_xx_minus_arm_2 = I_heli_xx - arm_2;
    // frame heli on arm
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    // frame arm on column
    let M_elevation_elevation = arm_1 + I_heli_xx - I_heli_xx_c_pitch_c_pitch + L_a_L_a_m_heli - arm_2;
    let arm_1_1 = c_elevation * (I_heli_xx_c_pitch * s_pitch - p.d * mc_heli_y_c_pitch);
    let M_travel_elevation = arm_1_1 + M_elevation_pitch * s_elevation;
    let arm_1_2 = 2.0 * (p.d * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli) - L_a_mc_heli_y_s_pitch);
    let arm_1_3 = c_elevation * (arm_1 + I_heli_xx_c_pitch_c_pitch + L_a_L_a_m_heli - I_heli_xx_minus_arm_2);
    let M_travel_travel = I_heli_xx_minus_arm_2 + c_elevation * (arm_1_3 + arm_1_2 * s_elevation);
    [
        [M_travel_travel, M_travel_elevation, M_travel_pitch, 0.0], // travel
        [M_travel_elevation, M_elevation_elevation, M_elevation_pitch, d_m_s], // elevation
        [M_travel_pitch, M_elevation_pitch, I_heli_xx, 0.0], // pitch
        [0.0, d_m_s, 0.0, p.m_s], // s
    ]
}

/// Bias h(q, v) [N m, N m, N m, N]: velocity products + gravity + springs; rows (travel, elevation, pitch, s).
#[must_use]
pub fn bias(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    // frame rail on arm
    let s_plus_s_0 = q.s + p.s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    // body front_rotor on heli
    let m_f_L_h = p.m_f * p.L_h;
    // body back_rotor on heli
    let m_b_L_h = p.m_b * p.L_h;
    // frame heli on arm
    let m_heli = p.m_f + p.m_b;
    let mc_heli_y = m_f_L_h - m_b_L_h;
    let I_heli_xx = p.L_h * m_f_L_h + p.L_h * m_b_L_h;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let omega_heli_x = v.pitch + omega_arm_1_x;
    let alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v.pitch;
    let omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    let heli_1 = mc_heli_y * (omega_heli_z * omega_heli_z + omega_heli_x * omega_heli_x);
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    // frame arm on column
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let a_arm_z = p.d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    let arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    let a_arm_x = p.g * s_elevation - p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_z_2 = a_arm_z + p.g * c_elevation;
    // frame heli on arm
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_x = a_arm_x - p.L_a * arm_1;
    let a_heli_1_z = p.L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    // frame rail on arm
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v.s;
    let f_rail_y = p.m_s * a_rail_y;
    let a_rail_z = 2.0 * v.elevation * v.s + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    let f_rail_x = p.m_s * (a_arm_x - s_plus_s_0 * arm_1);
    // frame arm on column
    let arm_2 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_rail_y;
    let arm_3 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = mc_heli_y * (omega_heli_y_omega_heli_x - alpha_heli_z) + m_heli * a_heli_1_x;
    let f_heli_y = m_heli * a_heli_y - heli_1;
    let f_heli_z = mc_heli_y * (alpha_arm_1_x + omega_heli_y_omega_heli_z) + m_heli * a_heli_z;
    let n_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y_omega_heli_z + mc_heli_y * a_heli_z;
    let n_heli_z = I_heli_xx * alpha_heli_z - I_heli_xx * omega_heli_y_omega_heli_x - mc_heli_y * a_heli_1_x;
    let f_heli_1_y = f_heli_y * c_pitch - f_heli_z * s_pitch;
    let f_heli_1_z = f_heli_y * s_pitch + f_heli_z * c_pitch;
    // frame arm on column
    let f_arm_x = f_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + f_rail_x;
    let f_arm_y = f_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_heli_1_y;
    let n_arm_y = -arm_3 - n_heli_z * s_pitch - p.L_a * f_heli_1_z;
    let n_arm_z = arm_2 + p.L_a * f_heli_1_y + n_heli_z * c_pitch;
    let n_column_z = n_arm_z * c_elevation + s_elevation * (n_heli_x + p.d * f_arm_y);
    [n_column_z, p.d * f_arm_x - n_arm_y, n_heli_x, f_rail_x]
}

/// Velocity products C(q, v) v [N m, N m, N m, N]: Coriolis and centrifugal terms; rows (travel, elevation, pitch, s).
#[must_use]
pub fn velocity_products(q: &Coordinates, v: &Rates, p: &Parameters) -> [f64; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    // frame rail on arm
    let s_plus_s_0 = q.s + p.s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    // body front_rotor on heli
    let m_f_L_h = p.m_f * p.L_h;
    // body back_rotor on heli
    let m_b_L_h = p.m_b * p.L_h;
    // frame heli on arm
    let m_heli = p.m_f + p.m_b;
    let mc_heli_y = m_f_L_h - m_b_L_h;
    let I_heli_xx = p.L_h * m_f_L_h + p.L_h * m_b_L_h;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let omega_heli_x = v.pitch + omega_arm_1_x;
    let alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v.pitch;
    let omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    let heli_1 = mc_heli_y * (omega_heli_z * omega_heli_z + omega_heli_x * omega_heli_x);
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    // frame arm on column
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    let a_arm_x = -p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let a_arm_z = p.d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    let arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    // frame heli on arm
    let a_heli_1_x = a_arm_x - p.L_a * arm_1;
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_z = a_arm_z + p.L_a * omega_arm_1_z_omega_arm_1_x;
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = mc_heli_y * (omega_heli_y_omega_heli_x - alpha_heli_z) + m_heli * a_heli_1_x;
    let f_heli_y = m_heli * a_heli_y - heli_1;
    let f_heli_z = m_heli * a_heli_z + mc_heli_y * (alpha_arm_1_x + omega_heli_y_omega_heli_z);
    let n_heli_x = mc_heli_y * a_heli_z + I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y_omega_heli_z;
    let n_heli_z = I_heli_xx * alpha_heli_z - mc_heli_y * a_heli_1_x - I_heli_xx * omega_heli_y_omega_heli_x;
    let f_heli_1_y = f_heli_y * c_pitch - f_heli_z * s_pitch;
    let f_heli_1_z = f_heli_y * s_pitch + f_heli_z * c_pitch;
    // frame rail on arm
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v.s;
    let a_rail_z = a_arm_z + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + 2.0 * v.elevation * v.s;
    let f_rail_x = -p.m_s * (s_plus_s_0 * arm_1 - a_arm_x);
    let f_rail_y = p.m_s * a_rail_y;
    // frame arm on column
    let arm_2 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    let arm_3 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_rail_y;
    let f_arm_x = f_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + f_rail_x;
    let f_arm_y = f_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_heli_1_y;
    let n_arm_y = -arm_2 - n_heli_z * s_pitch - p.L_a * f_heli_1_z;
    let n_arm_z = arm_3 + n_heli_z * c_pitch + p.L_a * f_heli_1_y;
    let n_column_z = n_arm_z * c_elevation + s_elevation * (n_heli_x + p.d * f_arm_y);
    [n_column_z, p.d * f_arm_x - n_arm_y, n_heli_x, f_rail_x]
}

/// Generalized gravity g(q) [N m, N m, N m, N]: what holds the rig still; rows (travel, elevation, pitch, s).
#[must_use]
pub fn gravity(q: &Coordinates, p: &Parameters) -> [f64; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    // body counterweight on arm
    let d_s_elevation = p.d * s_elevation;
    // body front_rotor on heli
    let L_h_s_pitch = p.L_h * s_pitch;
    let L_a_c_elevation = p.L_a * c_elevation;
    // gravity
    let gravity_1 = p.m_f * p.g * (L_a_c_elevation - s_elevation * (L_h_s_pitch - p.d));
    let gravity_2 = gravity_1 - p.m_w * p.g * (p.L_w * c_elevation - d_s_elevation);
    let gravity_3 = p.m_b * p.g * (L_a_c_elevation + s_elevation * (p.d + L_h_s_pitch));
    let gravity_4 = p.g * p.m_s * (d_s_elevation + c_elevation * (q.s + p.s_0));
    let g_L_h_c_elevation_c_pitch = p.L_h * p.g * c_elevation * c_pitch;
    let g_pitch = p.m_f * g_L_h_c_elevation_c_pitch - p.m_b * g_L_h_c_elevation_c_pitch;
    [0.0, gravity_2 + gravity_3 + gravity_4, g_pitch, p.g * p.m_s * s_elevation]
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
    let f_heli_z = F_f + F_b;
    let n_heli_x = p.L_h * F_f - p.L_h * F_b;
    // frame heli on arm
    let f_heli_1_y = -f_heli_z * s_pitch;
    // frame arm on column
    let n_column_z = s_elevation * (n_heli_x + p.d * f_heli_1_y) + p.L_a * f_heli_1_y * c_elevation;
    [n_column_z, p.L_a * f_heli_z * c_pitch, n_heli_x, 0.0]
}

/// Input map dQ/du, 4 x 3; rows (travel, elevation, pitch, s), columns (V_f, V_b, s.ddot).
#[must_use]
pub fn input_map(q: &Coordinates, p: &Parameters) -> [[f64; 3]; 4] {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    // input map
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
    // frame rail on arm
    let s_plus_s_0 = q.s + p.s_0;
    let s_plus_s_0_elevation_dot = s_plus_s_0 * v.elevation;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    // frame heli on arm
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    // frame arm on column
    let d_elevation_dot = p.d * v.elevation;
    let d_omega_arm_1_x = p.d * omega_arm_1_x;
    // frame heli on arm
    let L_a_elevation_dot = p.L_a * v.elevation;
    let heli_1_1 = d_omega_arm_1_x + p.L_a * omega_arm_1_z;
    let heli_1 = heli_1_1 * c_pitch + L_a_elevation_dot * s_pitch;
    let heli_2 = L_a_elevation_dot * c_pitch - heli_1_1 * s_pitch;
    // frame rail on arm
    let rail_1 = d_omega_arm_1_x + s_plus_s_0 * omega_arm_1_z;
    let s_dot_plus_d_elevation_dot = v.s + d_elevation_dot;
    // body counterweight on arm
    let L_w_elevation_dot = p.L_w * v.elevation;
    let counterweight_1 = d_omega_arm_1_x - p.L_w * omega_arm_1_z;
    let counterweight_2 = d_elevation_dot * d_elevation_dot + counterweight_1 * counterweight_1;
    let counterweight_3 = 0.5 * p.m_w * (L_w_elevation_dot * L_w_elevation_dot + counterweight_2);
    // body front_rotor on heli
    let L_h_omega_heli_z = p.L_h * omega_heli_z;
    let front_rotor_1 = p.L_h * (v.pitch + omega_arm_1_x);
    let front_rotor_2 = d_elevation_dot - L_h_omega_heli_z;
    let heli_2_plus_front_rotor_1 = heli_2 + front_rotor_1;
    let heli_1_sq = heli_1 * heli_1;
    let front_rotor_3 = heli_2_plus_front_rotor_1 * heli_2_plus_front_rotor_1 + front_rotor_2 * front_rotor_2 + heli_1_sq;
    // body back_rotor on heli
    let back_rotor_1 = d_elevation_dot + L_h_omega_heli_z;
    let heli_2_minus_front_rotor_1 = heli_2 - front_rotor_1;
    let back_rotor_2 = heli_2_minus_front_rotor_1 * heli_2_minus_front_rotor_1 + heli_1_sq + back_rotor_1 * back_rotor_1;
    let back_rotor_3 = counterweight_3 + 0.5 * p.m_f * front_rotor_3 + 0.5 * p.m_b * back_rotor_2;
    // body carriage on rail
    let carriage_1 = s_dot_plus_d_elevation_dot * s_dot_plus_d_elevation_dot + rail_1 * rail_1;
    let carriage_2 = 0.5 * p.m_s * (s_plus_s_0_elevation_dot * s_plus_s_0_elevation_dot + carriage_1);
    back_rotor_3 + carriage_2
}

/// Potential energy V(q) [J]: gravity and springs.
#[must_use]
pub fn potential_energy(q: &Coordinates, p: &Parameters) -> f64 {
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let s_pitch = sin(q.pitch);
    // body counterweight on arm
    let d_c_elevation = p.d * c_elevation;
    // body front_rotor on heli
    let L_h_s_pitch = p.L_h * s_pitch;
    let L_a_s_elevation = p.L_a * s_elevation;
    let front_rotor_1 = p.m_f * p.g * (c_elevation * (L_h_s_pitch - p.d) + L_a_s_elevation);
    let front_rotor_2 = front_rotor_1 - p.m_w * p.g * (d_c_elevation + p.L_w * s_elevation);
    // body back_rotor on heli
    let back_rotor_1 = p.m_b * p.g * (L_a_s_elevation - c_elevation * (p.d + L_h_s_pitch));
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
    // frame rail on arm
    let s_plus_s_0 = q.s + p.s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    // body front_rotor on heli
    let m_f_L_h = p.m_f * p.L_h;
    // body back_rotor on heli
    let m_b_L_h = p.m_b * p.L_h;
    // frame heli on arm
    let m_heli = p.m_f + p.m_b;
    let mc_heli_y = m_f_L_h - m_b_L_h;
    let I_heli_xx = p.L_h * m_f_L_h + p.L_h * m_b_L_h;
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
    let omega_heli_x = v.pitch + omega_arm_1_x;
    let omega_heli_y_pitch_dot = omega_heli_y * v.pitch;
    let omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    let heli_1 = mc_heli_y * (omega_heli_z * omega_heli_z + omega_heli_x * omega_heli_x);
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let heli_2 = s_pitch * a.elevation + alpha_arm_1_z_2 * c_pitch;
    let alpha_heli_x = a.pitch + alpha_arm_1_x_2;
    let heli_3 = I_heli_xx * (heli_2 - omega_heli_y_pitch_dot) - I_heli_xx * omega_heli_y_omega_heli_x;
    // frame arm on column
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
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
    let n_heli_x = p.L_h * F_f - p.L_h * F_b;
    // frame heli on arm
    let a_heli_1_x = a_arm_x - p.L_a * arm_1;
    let a_heli_1_y = a_arm_y + p.L_a * arm_2;
    let a_heli_1_z = a_arm_z_2 + p.L_a * arm_3;
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = m_heli * a_heli_1_x + mc_heli_y * (omega_heli_y_omega_heli_x + omega_heli_y_pitch_dot - heli_2);
    let f_heli_y = m_heli * a_heli_y - heli_1;
    let heli_4 = mc_heli_y * a_heli_z + I_heli_xx * omega_heli_y_omega_heli_z + I_heli_xx * alpha_heli_x;
    let n_heli_z = heli_3 - mc_heli_y * a_heli_1_x;
    // frame rail on arm
    let a_rail_y = 2.0 * omega_arm_1_z * v.s + a_arm_y + s_plus_s_0 * arm_2;
    let a_rail_z = 2.0 * v.elevation * v.s + a_arm_z_2 + s_plus_s_0 * arm_3;
    let a_rail_x = a.s + a_arm_x - s_plus_s_0 * arm_1;
    let f_rail_x = p.m_s * a_rail_x;
    let f_rail_y = p.m_s * a_rail_y;
    let f_heli_z = m_heli * a_heli_z + mc_heli_y * (omega_heli_y_omega_heli_z + alpha_heli_x) - F_f - F_b;
    let n_heli_x_2 = heli_4 - n_heli_x;
    // frame arm on column
    let arm_6 = arm_4 + p.m_s * s_plus_s_0 * a_rail_z;
    let f_arm_x = f_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + f_rail_x;
    // frame heli on arm
    let f_heli_1_y = f_heli_y * c_pitch - f_heli_z * s_pitch;
    let f_heli_1_z = f_heli_y * s_pitch + f_heli_z * c_pitch;
    let heli_1_1 = n_heli_z * c_pitch + p.L_a * f_heli_1_y;
    // frame arm on column
    let f_arm_y = p.m_w * a_arm_y + mc_arm_x * arm_2 + f_rail_y + f_heli_1_y;
    let n_arm_y = -arm_6 - n_heli_z * s_pitch - p.L_a * f_heli_1_z;
    let n_arm_z = arm_5 + s_plus_s_0 * f_rail_y + heli_1_1;
    let n_column_z = n_arm_z * c_elevation + s_elevation * (n_heli_x_2 + p.d * f_arm_y);
    [p.c_travel * v.travel + n_column_z, p.c_elevation * v.elevation + p.d * f_arm_x - n_arm_y, p.c_pitch * v.pitch + n_heli_x_2, f_rail_x]
}

/// Measured outputs y(x), with scale and bias, without delay and quantization.
#[must_use]
pub fn outputs(x: &State, _p: &Parameters) -> Outputs {
    let State { q, .. } = x;
    Outputs::from_array([q.travel, q.elevation + 0.4799655442984406, q.pitch, q.s])
}

/// Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.
/// 229 operations.
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn forward_dynamics(x: &State, u: &Inputs, p: &Parameters) -> Result<Accelerations, Singular> {
    let State { q, v } = x;
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let F_f = p.K_f * u.V_f;
    let F_b = p.K_f * u.V_b;
    // frame rail on arm
    let s_plus_s_0 = q.s + p.s_0;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    // body front_rotor on heli
    let m_f_L_h = p.m_f * p.L_h;
    // body back_rotor on heli
    let m_b_L_h = p.m_b * p.L_h;
    // frame heli on arm
    let m_heli = p.m_f + p.m_b;
    let mc_heli_y = m_f_L_h - m_b_L_h;
    let I_heli_xx = p.L_h * m_f_L_h + p.L_h * m_b_L_h;
    let mc_heli_y_s_pitch = mc_heli_y * s_pitch;
    let mc_heli_y_c_pitch = mc_heli_y * c_pitch;
    let M_elevation_pitch = p.L_a * mc_heli_y_c_pitch;
    let L_a_mc_heli_y_s_pitch = p.L_a * mc_heli_y_s_pitch;
    let M_travel_pitch = s_elevation * (I_heli_xx - p.d * mc_heli_y_s_pitch) - L_a_mc_heli_y_s_pitch * c_elevation;
    let I_heli_xx_c_pitch = I_heli_xx * c_pitch;
    let I_heli_xx_c_pitch_c_pitch = I_heli_xx_c_pitch * c_pitch;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    let arm_1_1 = c_elevation * (I_heli_xx_c_pitch * s_pitch - p.d * mc_heli_y_c_pitch);
    let M_travel_elevation = arm_1_1 + M_elevation_pitch * s_elevation;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let omega_heli_x = v.pitch + omega_arm_1_x;
    let alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y * v.pitch;
    let omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    let heli_1 = mc_heli_y * (omega_heli_z * omega_heli_z + omega_heli_x * omega_heli_x);
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    // frame arm on column
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let a_arm_z = p.d * (omega_arm_1_x * omega_arm_1_x + elevation_dot_sq);
    let arm_1 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    let a_arm_x = p.g * s_elevation - p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_z_2 = a_arm_z + p.g * c_elevation;
    let arm_2 = I_arm_yy + s_plus_s_0 * m_s_s_plus_s_0;
    let arm_3 = p.d * (mc_heli_y_s_pitch + mc_heli_y_s_pitch - p.d * (m_heli + p.m_w + p.m_s));
    let I_heli_xx_minus_arm_3 = I_heli_xx - arm_3;
    // frame heli on arm
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_x = a_arm_x - p.L_a * arm_1;
    let a_heli_1_z = p.L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    // frame rail on arm
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + 2.0 * omega_arm_1_z * v.s;
    let f_rail_y = p.m_s * a_rail_y;
    let a_rail_z = 2.0 * v.elevation * v.s + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z_2;
    let a_rail_x = u.s_ddot + a_arm_x - s_plus_s_0 * arm_1;
    // frame arm on column
    let arm_4 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_rail_y;
    let arm_5 = mc_arm_x * a_arm_z_2 + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    let M_elevation_elevation = arm_2 + I_heli_xx - I_heli_xx_c_pitch_c_pitch + L_a_L_a_m_heli - arm_3;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = mc_heli_y * (omega_heli_y_omega_heli_x - alpha_heli_z) + m_heli * a_heli_1_x;
    let f_heli_y = m_heli * a_heli_y - heli_1;
    let f_heli_z = mc_heli_y * (alpha_arm_1_x + omega_heli_y_omega_heli_z) + m_heli * a_heli_z;
    let n_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y_omega_heli_z + mc_heli_y * a_heli_z;
    let n_heli_z = I_heli_xx * alpha_heli_z - I_heli_xx * omega_heli_y_omega_heli_x - mc_heli_y * a_heli_1_x;
    // frame arm on column
    let arm_1_2 = 2.0 * (p.d * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli) - L_a_mc_heli_y_s_pitch);
    let arm_1_3 = c_elevation * (arm_2 + I_heli_xx_c_pitch_c_pitch + L_a_L_a_m_heli - I_heli_xx_minus_arm_3);
    let M_travel_travel = I_heli_xx_minus_arm_3 + c_elevation * (arm_1_3 + arm_1_2 * s_elevation);
    // force back on heli
    let n_heli_x_2 = p.L_h * F_f - p.L_h * F_b;
    // frame rail on arm
    let f_heli_z_2 = f_heli_z - F_f - F_b;
    let n_heli_x_3 = n_heli_x - n_heli_x_2;
    // frame heli on arm
    let f_heli_1_y = f_heli_y * c_pitch - f_heli_z_2 * s_pitch;
    let f_heli_1_z = f_heli_y * s_pitch + f_heli_z_2 * c_pitch;
    // frame arm on column
    let f_arm_x = f_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + p.m_s * a_rail_x;
    let f_arm_y = f_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_heli_1_y;
    let n_arm_y = -arm_5 - n_heli_z * s_pitch - p.L_a * f_heli_1_z;
    let n_arm_z = arm_4 + p.L_a * f_heli_1_y + n_heli_z * c_pitch;
    let n_column_z = n_arm_z * c_elevation + s_elevation * (n_heli_x_3 + p.d * f_arm_y);
    // balance of forces
    let tau_elevation = n_arm_y - p.c_elevation * v.elevation - p.d * f_arm_x;
    let tau_pitch = -p.c_pitch * v.pitch - n_heli_x_3;
    // M = L^T D L and back-substitution
    let inv_pitch = 1.0 / I_heli_xx;
    let l_pitch_travel = M_travel_pitch * inv_pitch;
    let l_pitch_elevation = M_elevation_pitch * inv_pitch;
    let pivot_elevation = M_elevation_elevation - M_elevation_pitch * l_pitch_elevation;
    let inv_elevation = 1.0 / pivot_elevation;
    let solve_1 = M_travel_elevation - M_travel_pitch * l_pitch_elevation;
    let l_elevation_travel = inv_elevation * solve_1;
    let solve_2 = M_travel_travel - solve_1 * l_elevation_travel;
    let pivot_travel = solve_2 - M_travel_pitch * l_pitch_travel;
    let solve_3 = tau_elevation - tau_pitch * l_pitch_elevation;
    let solve_4 = p.c_travel * v.travel + n_column_z + l_elevation_travel * solve_3;
    let travel_ddot = (-tau_pitch * l_pitch_travel - solve_4) / pivot_travel;
    let elevation_ddot = inv_elevation * solve_3 - l_elevation_travel * travel_ddot;
    let solve_5 = l_pitch_travel * travel_ddot - tau_pitch * inv_pitch;
    positive(I_heli_xx, 2)?;
    positive(pivot_elevation, 1)?;
    positive(pivot_travel, 0)?;
    Ok(Accelerations::from_array([travel_ddot, elevation_ddot, -solve_5 - l_pitch_elevation * elevation_ddot, u.s_ddot]))
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
/// 867 operations.
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
    // frame rail on arm
    let s_plus_s_0 = q.s + p.s_0;
    let two_elevation_dot_s_dot = 2.0 * v.elevation * v.s;
    let d_m_s = p.d * p.m_s;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    // body front_rotor on heli
    let m_f_L_h = p.m_f * p.L_h;
    // body back_rotor on heli
    let m_b_L_h = p.m_b * p.L_h;
    // frame heli on arm
    let m_heli = p.m_f + p.m_b;
    let mc_heli_y = m_f_L_h - m_b_L_h;
    let I_heli_xx = p.L_h * m_f_L_h + p.L_h * m_b_L_h;
    let c_pitch_elevation_dot = c_pitch * v.elevation;
    let mc_heli_y_s_pitch = mc_heli_y * s_pitch;
    let mc_heli_y_c_pitch = mc_heli_y * c_pitch;
    let M_elevation_pitch = p.L_a * mc_heli_y_c_pitch;
    let L_a_mc_heli_y_s_pitch = p.L_a * mc_heli_y_s_pitch;
    let M_travel_pitch = s_elevation * (I_heli_xx - p.d * mc_heli_y_s_pitch) - L_a_mc_heli_y_s_pitch * c_elevation;
    let I_heli_xx_c_pitch = I_heli_xx * c_pitch;
    let I_heli_xx_c_pitch_c_pitch = I_heli_xx_c_pitch * c_pitch;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    let a_arm_1_z = p.g * c_elevation;
    let a_arm_1_x = p.g * s_elevation;
    let arm_1_1 = c_elevation * (I_heli_xx_c_pitch * s_pitch - p.d * mc_heli_y_c_pitch);
    let M_travel_elevation = arm_1_1 + M_elevation_pitch * s_elevation;
    // frame heli on arm
    let omega_arm_1_z_s_pitch = omega_arm_1_z * s_pitch;
    let omega_heli_y = omega_arm_1_z_s_pitch - c_pitch_elevation_dot;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let omega_heli_x = v.pitch + omega_arm_1_x;
    let omega_heli_z_pitch_dot = omega_heli_z * v.pitch;
    let omega_heli_y_pitch_dot = omega_heli_y * v.pitch;
    let alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y_pitch_dot;
    let omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    let omega_heli_z_sq = omega_heli_z * omega_heli_z;
    let heli_1 = mc_heli_y * (omega_heli_z_sq + omega_heli_x * omega_heli_x);
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    let heli_2 = I_heli_xx * omega_heli_y_omega_heli_z;
    let omega_heli_z_omega_heli_x = omega_heli_z * omega_heli_x;
    let heli_3 = I_heli_xx * omega_heli_y_omega_heli_x;
    // frame arm on column
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
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
    let arm_4 = p.d * (mc_heli_y_s_pitch + mc_heli_y_s_pitch - p.d * (m_heli + p.m_w + p.m_s));
    let I_heli_xx_minus_arm_4 = I_heli_xx - arm_4;
    // frame heli on arm
    let L_a_arm_1 = p.L_a * arm_1;
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_x = a_arm_x - L_a_arm_1;
    let a_heli_1_z = p.L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    // frame rail on arm
    let two_omega_arm_1_z_s_dot = 2.0 * omega_arm_1_z * v.s;
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + two_omega_arm_1_z_s_dot;
    let f_rail_y = p.m_s * a_rail_y;
    let a_rail_z = two_elevation_dot_s_dot + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    let a_rail_x = u.s_ddot + a_arm_x - s_plus_s_0 * arm_1;
    // frame arm on column
    let arm_5 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy_alpha_arm_1_z + s_plus_s_0 * f_rail_y;
    let arm_6 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    let M_elevation_elevation = arm_3 + I_heli_xx - I_heli_xx_c_pitch_c_pitch + L_a_L_a_m_heli - arm_4;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = mc_heli_y * (omega_heli_y_omega_heli_x - alpha_heli_z) + m_heli * a_heli_1_x;
    let f_heli_y = m_heli * a_heli_y - heli_1;
    let f_heli_z = mc_heli_y * (alpha_arm_1_x + omega_heli_y_omega_heli_z) + m_heli * a_heli_z;
    let n_heli_x = I_heli_xx * alpha_arm_1_x + heli_2 + mc_heli_y * a_heli_z;
    let n_heli_z = I_heli_xx * alpha_heli_z - heli_3 - mc_heli_y * a_heli_1_x;
    // frame arm on column
    let arm_1_2 = 2.0 * (p.d * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli) - L_a_mc_heli_y_s_pitch);
    let arm_1_3 = c_elevation * (arm_3 + I_heli_xx_c_pitch_c_pitch + L_a_L_a_m_heli - I_heli_xx_minus_arm_4);
    let M_travel_travel = I_heli_xx_minus_arm_4 + c_elevation * (arm_1_3 + arm_1_2 * s_elevation);
    // force back on heli
    let f_heli_z_2 = F_f + F_b;
    let n_heli_x_2 = p.L_h * F_f - p.L_h * F_b;
    // gravity
    let c_elevation_c_pitch = c_elevation * c_pitch;
    let c_elevation_elevation_dot = c_elevation * v.elevation;
    let s_elevation_elevation_dot = s_elevation * v.elevation;
    let c_pitch_pitch_dot = c_pitch * v.pitch;
    let omega_arm_1_x_c_pitch = omega_arm_1_x * c_pitch;
    let gravity_1 = c_pitch_elevation_dot - omega_arm_1_z_s_pitch;
    // frame rail on arm
    let f_heli_z_3 = f_heli_z - f_heli_z_2;
    let n_heli_x_3 = n_heli_x - n_heli_x_2;
    // frame heli on arm
    let f_heli_1_y = f_heli_y * c_pitch - f_heli_z_3 * s_pitch;
    let f_heli_1_z = f_heli_y * s_pitch + f_heli_z_3 * c_pitch;
    // frame arm on column
    let f_arm_x = f_heli_x - mc_arm_x * arm_1 + p.m_w * a_arm_x + p.m_s * a_rail_x;
    let f_arm_y = f_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_heli_1_y;
    let n_arm_y = -arm_6 - n_heli_z * s_pitch - p.L_a * f_heli_1_z;
    let n_arm_z = arm_5 + p.L_a * f_heli_1_y + n_heli_z * c_pitch;
    let n_column_z = n_arm_z * c_elevation + s_elevation * (n_heli_x_3 + p.d * f_arm_y);
    // balance of forces
    let tau_elevation = n_arm_y - p.c_elevation * v.elevation - p.d * f_arm_x;
    let tau_pitch = -p.c_pitch * v.pitch - n_heli_x_3;
    // M = L^T D L and back-substitution
    let inv_pitch = 1.0 / I_heli_xx;
    let l_pitch_travel = M_travel_pitch * inv_pitch;
    let l_pitch_elevation = M_elevation_pitch * inv_pitch;
    let pivot_elevation = M_elevation_elevation - M_elevation_pitch * l_pitch_elevation;
    let inv_elevation = 1.0 / pivot_elevation;
    let solve_1 = M_travel_elevation - M_travel_pitch * l_pitch_elevation;
    let l_elevation_travel = inv_elevation * solve_1;
    let solve_2 = M_travel_travel - solve_1 * l_elevation_travel;
    let pivot_travel = solve_2 - M_travel_pitch * l_pitch_travel;
    let inv_travel = 1.0 / pivot_travel;
    let solve_3 = tau_elevation - tau_pitch * l_pitch_elevation;
    let solve_4 = p.c_travel * v.travel + n_column_z + l_elevation_travel * solve_3;
    let travel_ddot = inv_travel * (-tau_pitch * l_pitch_travel - solve_4);
    let elevation_ddot = inv_elevation * solve_3 - l_elevation_travel * travel_ddot;
    let solve_5 = l_pitch_travel * travel_ddot - tau_pitch * inv_pitch;
    let pitch_ddot = -solve_5 - l_pitch_elevation * elevation_ddot;
    // input map
    let L_h_K_f = p.L_h * p.K_f;
    let K_f_s_pitch = p.K_f * s_pitch;
    let L_a_K_f_c_pitch = p.L_a * p.K_f * c_pitch;
    let d_K_f_s_pitch = p.d * K_f_s_pitch;
    let L_a_K_f_s_pitch_c_elevation = p.L_a * K_f_s_pitch * c_elevation;
    let input_map_1 = L_a_K_f_s_pitch_c_elevation + s_elevation * (L_h_K_f + d_K_f_s_pitch);
    // derivatives with respect to elevation
    let omega_arm_1_x_s_pitch = omega_arm_1_x * s_pitch;
    let two_omega_arm_1_x = 2.0 * omega_arm_1_x;
    let two_omega_arm_1_z = 2.0 * omega_arm_1_z;
    let by_elevation_1 = omega_arm_1_x * two_omega_arm_1_z;
    let by_elevation_2 = omega_arm_1_x_s_pitch * v.pitch;
    let by_elevation_3 = omega_arm_1_z * omega_heli_y - omega_heli_x * omega_arm_1_x_s_pitch;
    let two_omega_heli_z = 2.0 * omega_heli_z;
    let two_omega_heli_x = 2.0 * omega_heli_x;
    let by_elevation_4 = mc_heli_y * (omega_arm_1_z * two_omega_heli_x - omega_arm_1_x_c_pitch * two_omega_heli_z);
    let by_elevation_5 = omega_heli_z * omega_arm_1_x_s_pitch + omega_heli_y * omega_arm_1_x_c_pitch;
    let by_elevation_6 = p.d * omega_arm_1_z * two_omega_arm_1_x - a_arm_1_x;
    let a_arm_1_z_minus_d_arm_2 = a_arm_1_z - p.d * arm_2;
    let by_elevation_7 = p.L_a * by_elevation_1 + a_arm_1_z_minus_d_arm_2;
    let by_elevation_8 = by_elevation_6 + p.L_a * arm_2;
    let by_elevation_9 = p.m_s * (s_plus_s_0 * by_elevation_1 + a_arm_1_z_minus_d_arm_2);
    let by_elevation_10 = p.m_s * s_plus_s_0 * (by_elevation_6 + s_plus_s_0 * arm_2);
    let by_elevation_11 = mc_arm_x * by_elevation_6 + I_arm_yy * arm_2 + by_elevation_10;
    // derivatives with respect to pitch
    let by_pitch_1 = omega_heli_z_sq + omega_heli_y * gravity_1;
    let I_heli_xx_by_pitch_1 = I_heli_xx * by_pitch_1;
    // derivatives with respect to travel_dot
    let c_elevation_s_pitch = c_elevation * s_pitch;
    let by_travel_dot_1 = omega_arm_1_x * c_elevation + omega_arm_1_z * s_elevation;
    let by_travel_dot_2 = p.d * two_omega_arm_1_x * s_elevation;
    let by_travel_dot_3 = two_omega_arm_1_z * c_elevation;
    let by_travel_dot_4 = omega_heli_x * c_elevation_s_pitch + omega_heli_y * s_elevation;
    let by_travel_dot_5 = mc_heli_y * (c_elevation_c_pitch * two_omega_heli_z + two_omega_heli_x * s_elevation);
    let by_travel_dot_6 = omega_heli_z * c_elevation_s_pitch + omega_heli_y * c_elevation_c_pitch;
    let d_by_travel_dot_1 = p.d * by_travel_dot_1;
    let by_travel_dot_7 = 2.0 * p.d * c_elevation_elevation_dot;
    let by_travel_dot_8 = 2.0 * s_elevation_elevation_dot;
    let by_travel_dot_9 = mc_arm_x * by_travel_dot_7 - 2.0 * I_arm_yy * s_elevation_elevation_dot;
    let by_travel_dot_10 = p.L_a * by_travel_dot_3 + d_by_travel_dot_1;
    let by_travel_dot_11 = by_travel_dot_7 - p.L_a * by_travel_dot_8;
    let by_travel_dot_12 = by_travel_dot_2 + p.L_a * by_travel_dot_1;
    let by_travel_dot_13 = s_elevation_elevation_dot * c_pitch + c_elevation_s_pitch * v.pitch;
    let by_travel_dot_14 = by_travel_dot_12 * c_pitch - by_travel_dot_11 * s_pitch;
    let by_travel_dot_15 = m_heli * (by_travel_dot_11 * c_pitch + by_travel_dot_12 * s_pitch);
    let by_travel_dot_16 = mc_heli_y * (by_travel_dot_4 + by_travel_dot_13) - m_heli * by_travel_dot_10;
    let by_travel_dot_17 = by_travel_dot_15 - by_travel_dot_5;
    let by_travel_dot_18 = m_heli * by_travel_dot_14 + mc_heli_y * (c_elevation_elevation_dot + by_travel_dot_6);
    let by_travel_dot_19 = mc_heli_y * by_travel_dot_14 + I_heli_xx * by_travel_dot_6 + I_heli_xx * c_elevation_elevation_dot;
    let by_travel_dot_20 = mc_heli_y * by_travel_dot_10 - I_heli_xx * by_travel_dot_4 - I_heli_xx * by_travel_dot_13;
    let by_travel_dot_21 = p.m_s * (s_plus_s_0 * by_travel_dot_3 + d_by_travel_dot_1);
    let by_travel_dot_22 = p.m_s * (2.0 * c_elevation * v.s + by_travel_dot_7 - s_plus_s_0 * by_travel_dot_8);
    let by_travel_dot_23 = p.m_s * s_plus_s_0 * (by_travel_dot_2 + s_plus_s_0 * by_travel_dot_1);
    let by_travel_dot_24 = mc_arm_x * by_travel_dot_2 + I_arm_yy * by_travel_dot_1 + by_travel_dot_23;
    let by_travel_dot_25 = by_travel_dot_17 * c_pitch - by_travel_dot_18 * s_pitch;
    let by_travel_dot_26 = p.L_a * (by_travel_dot_17 * s_pitch + by_travel_dot_18 * c_pitch);
    let by_travel_dot_27 = by_travel_dot_20 * c_pitch + p.L_a * by_travel_dot_25;
    let by_travel_dot_28 = by_travel_dot_16 - mc_arm_x * by_travel_dot_3 - p.m_w * d_by_travel_dot_1 - by_travel_dot_21;
    let by_travel_dot_29 = p.m_w * by_travel_dot_7 - mc_arm_x * by_travel_dot_8 + by_travel_dot_22 + by_travel_dot_25;
    let by_travel_dot_30 = c_elevation * (by_travel_dot_9 + s_plus_s_0 * by_travel_dot_22 + by_travel_dot_27);
    let by_travel_dot_31 = p.c_travel + by_travel_dot_30 + s_elevation * (by_travel_dot_19 + p.d * by_travel_dot_29);
    let by_travel_dot_32 = by_travel_dot_24 + by_travel_dot_20 * s_pitch + by_travel_dot_26 + p.d * by_travel_dot_28;
    let by_travel_dot_33 = l_pitch_elevation * by_travel_dot_19 - by_travel_dot_32;
    let by_travel_dot_34 = l_pitch_travel * by_travel_dot_19 - by_travel_dot_31 - l_elevation_travel * by_travel_dot_33;
    let d_travel_ddot_by_travel_dot = inv_travel * by_travel_dot_34;
    let d_elevation_ddot_by_travel_dot = inv_elevation * by_travel_dot_33 - l_elevation_travel * d_travel_ddot_by_travel_dot;
    let by_travel_dot_35 = inv_pitch * by_travel_dot_19 + l_pitch_travel * d_travel_ddot_by_travel_dot;
    // derivatives with respect to elevation_dot
    let two_elevation_dot = 2.0 * v.elevation;
    let d_two_elevation_dot = p.d * two_elevation_dot;
    let L_a_two_elevation_dot = p.L_a * two_elevation_dot;
    let omega_heli_x_c_pitch = omega_heli_x * c_pitch;
    let by_elevation_dot_1 = omega_heli_y * s_pitch - omega_heli_z * c_pitch;
    let d_two_omega_arm_1_z = p.d * two_omega_arm_1_z;
    let two_omega_arm_1_x_2 = 2.0 * omega_arm_1_x;
    let by_elevation_dot_2 = mc_arm_x * d_two_omega_arm_1_z - 2.0 * I_arm_yy * omega_arm_1_x;
    let by_elevation_dot_3 = d_two_omega_arm_1_z - p.L_a * two_omega_arm_1_x_2;
    let by_elevation_dot_4 = d_two_elevation_dot * c_pitch - by_elevation_dot_3 * s_pitch;
    let by_elevation_dot_5 = m_heli * (by_elevation_dot_3 * c_pitch + d_two_elevation_dot * s_pitch);
    let by_elevation_dot_6 =
        mc_heli_y * (omega_arm_1_x_c_pitch - c_pitch_pitch_dot - omega_heli_x_c_pitch)
            - m_heli * L_a_two_elevation_dot;
    let by_elevation_dot_7 = by_elevation_dot_5 - mc_heli_y * two_omega_heli_z * s_pitch;
    let by_elevation_dot_8 = m_heli * by_elevation_dot_4 + mc_heli_y * (omega_arm_1_z + by_elevation_dot_1);
    let by_elevation_dot_9 = I_heli_xx * omega_heli_x_c_pitch + I_heli_xx * (c_pitch_pitch_dot - omega_arm_1_x_c_pitch);
    let by_elevation_dot_10 = mc_heli_y * by_elevation_dot_4 + I_heli_xx * by_elevation_dot_1 + I_heli_xx * omega_arm_1_z;
    let by_elevation_dot_11 = mc_heli_y * L_a_two_elevation_dot + by_elevation_dot_9;
    let by_elevation_dot_12 = p.m_s * (d_two_omega_arm_1_z - s_plus_s_0 * two_omega_arm_1_x_2);
    let by_elevation_dot_13 = mc_arm_x * d_two_elevation_dot + p.m_s * s_plus_s_0 * (d_two_elevation_dot + 2.0 * v.s);
    let by_elevation_dot_14 = by_elevation_dot_7 * c_pitch - by_elevation_dot_8 * s_pitch;
    let by_elevation_dot_15 = p.L_a * (by_elevation_dot_7 * s_pitch + by_elevation_dot_8 * c_pitch);
    let by_elevation_dot_16 = by_elevation_dot_11 * c_pitch + p.L_a * by_elevation_dot_14;
    let by_elevation_dot_17 = by_elevation_dot_6 - mc_arm_x * two_elevation_dot - p.m_s * s_plus_s_0 * two_elevation_dot;
    let by_elevation_dot_18 = p.m_w * d_two_omega_arm_1_z - mc_arm_x * two_omega_arm_1_x_2 + by_elevation_dot_12 + by_elevation_dot_14;
    let by_elevation_dot_19 = p.d * by_elevation_dot_17 + by_elevation_dot_13 + by_elevation_dot_11 * s_pitch + by_elevation_dot_15;
    let by_elevation_dot_20 = c_elevation * (by_elevation_dot_2 + s_plus_s_0 * by_elevation_dot_12 + by_elevation_dot_16);
    let by_elevation_dot_21 = by_elevation_dot_20 + s_elevation * (by_elevation_dot_10 + p.d * by_elevation_dot_18);
    let by_elevation_dot_22 = l_pitch_elevation * by_elevation_dot_10 - p.c_elevation - by_elevation_dot_19;
    let by_elevation_dot_23 = l_pitch_travel * by_elevation_dot_10 - by_elevation_dot_21 - l_elevation_travel * by_elevation_dot_22;
    let d_travel_ddot_by_elevation_dot = inv_travel * by_elevation_dot_23;
    let d_elevation_ddot_by_elevation_dot = inv_elevation * by_elevation_dot_22 - l_elevation_travel * d_travel_ddot_by_elevation_dot;
    let by_elevation_dot_24 = inv_pitch * by_elevation_dot_10 + l_pitch_travel * d_travel_ddot_by_elevation_dot;
    // derivatives with respect to pitch_dot
    let mc_heli_y_two_omega_heli_x = mc_heli_y * two_omega_heli_x;
    let by_pitch_dot_1 = I_heli_xx * gravity_1 - I_heli_xx * omega_heli_y;
    let by_pitch_dot_2 = mc_heli_y_two_omega_heli_x * c_pitch;
    let by_pitch_dot_3 = p.L_a * mc_heli_y_two_omega_heli_x * s_pitch - by_pitch_dot_1 * s_pitch;
    let by_pitch_dot_4 = c_elevation * (by_pitch_dot_1 * c_pitch - p.L_a * by_pitch_dot_2);
    let by_pitch_dot_5 = p.d * by_pitch_dot_2 * s_elevation - by_pitch_dot_4;
    let by_pitch_dot_6 = by_pitch_dot_3 - 2.0 * p.d * mc_heli_y * omega_heli_y + p.c_pitch * l_pitch_elevation;
    let by_pitch_dot_7 = by_pitch_dot_5 - l_elevation_travel * by_pitch_dot_6 + p.c_pitch * l_pitch_travel;
    let d_travel_ddot_by_pitch_dot = inv_travel * by_pitch_dot_7;
    let d_elevation_ddot_by_pitch_dot = inv_elevation * by_pitch_dot_6 - l_elevation_travel * d_travel_ddot_by_pitch_dot;
    let by_pitch_dot_8 = p.c_pitch * inv_pitch + l_pitch_travel * d_travel_ddot_by_pitch_dot;
    // derivatives with respect to s_dot
    let m_s_two_omega_arm_1_z = p.m_s * two_omega_arm_1_z;
    let by_s_dot_1 = p.m_s * s_plus_s_0 * two_elevation_dot;
    let by_s_dot_2 = s_plus_s_0 * m_s_two_omega_arm_1_z * c_elevation + p.d * m_s_two_omega_arm_1_z * s_elevation;
    let d_travel_ddot_by_s_dot = inv_travel * (l_elevation_travel * by_s_dot_1 - by_s_dot_2);
    let d_elevation_ddot_by_s_dot = -inv_elevation * by_s_dot_1 - l_elevation_travel * d_travel_ddot_by_s_dot;
    let by_s_dot_3 = l_pitch_elevation * d_elevation_ddot_by_s_dot;
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
    let slopes_1_plus_pitch_ddot = slopes_1 + pitch_ddot;
    let slopes_8 = slopes_6 * c_pitch + a_arm_z_plus_L_a_slopes_4 * s_pitch;
    let slopes_9 = a_arm_z_plus_L_a_slopes_4 * c_pitch - slopes_6 * s_pitch;
    let m_heli_slopes_8 = m_heli * slopes_8;
    let m_heli_slopes_9 = m_heli * slopes_9;
    let m_heli_slopes_8_minus_heli_1 = m_heli_slopes_8 - heli_1;
    let slopes_10 = mc_heli_y * (a_arm_1_x - p.d * (omega_arm_1_z_omega_arm_1_x - elevation_ddot) - L_a_arm_1);
    let slopes_11 = I_heli_xx * slopes_7 - heli_3 - slopes_10;
    let slopes_12 = p.m_s * (two_omega_arm_1_z_s_dot + slopes_3 + s_plus_s_0 * slopes_2_plus_alpha_arm_1_z);
    let slopes_13 = p.m_s * (two_elevation_dot_s_dot + a_arm_z + s_plus_s_0 * slopes_4);
    let slopes_14 = m_heli_slopes_9 + mc_heli_y * (omega_heli_y_omega_heli_z + slopes_1_plus_pitch_ddot) - f_heli_z_2;
    let slopes_15 = mc_heli_y * slopes_9 + heli_2 + I_heli_xx * slopes_1_plus_pitch_ddot - n_heli_x_2;
    let slopes_16 = slopes_5 + s_plus_s_0 * slopes_12;
    let slopes_17 = m_heli_slopes_8_minus_heli_1 * c_pitch;
    let slopes_14_s_pitch = slopes_14 * s_pitch;
    let slopes_18 = slopes_17 - slopes_14_s_pitch;
    let slopes_11_c_pitch = slopes_11 * c_pitch;
    let slopes_19 = p.m_w * slopes_3 + mc_arm_x * slopes_2_plus_alpha_arm_1_z + slopes_12 + slopes_18;
    let slopes_20 = s_elevation * (slopes_16 + slopes_11_c_pitch + p.L_a * slopes_18);
    let slopes_21 = p.d * slopes_2_plus_alpha_arm_1_z;
    let slopes_22 = I_arm_yy * alpha_arm_1_x - mc_arm_x * slopes_21 + I_arm_yy * slopes_1;
    let slopes_23 = slopes_21 - p.L_a * alpha_arm_1_x_plus_slopes_1;
    let slopes_1_c_pitch = slopes_1 * c_pitch;
    let slopes_24 = by_elevation_8 * c_pitch - slopes_23 * s_pitch;
    let slopes_25 = m_heli * (by_elevation_8 * s_pitch + slopes_23 * c_pitch);
    let slopes_26 = m_heli * by_elevation_7 + mc_heli_y * (by_elevation_3 + slopes_1_c_pitch - by_elevation_2);
    let slopes_27 = slopes_25 - by_elevation_4;
    let slopes_28 = m_heli * slopes_24 + mc_heli_y * (slopes_2 - by_elevation_5);
    let slopes_29 = I_heli_xx * (by_elevation_2 - slopes_1_c_pitch) - I_heli_xx * by_elevation_3;
    let slopes_30 = mc_heli_y * slopes_24 + I_heli_xx * slopes_2 - I_heli_xx * by_elevation_5;
    let slopes_31 = slopes_29 - mc_heli_y * by_elevation_7;
    let slopes_32 = p.m_s * (slopes_21 - 2.0 * omega_arm_1_x * v.s - s_plus_s_0 * alpha_arm_1_x_plus_slopes_1);
    let slopes_33 = slopes_27 * c_pitch - slopes_28 * s_pitch;
    let slopes_34 = p.L_a * (slopes_27 * s_pitch + slopes_28 * c_pitch);
    let slopes_35 = slopes_31 * c_pitch + p.L_a * slopes_33;
    let slopes_36 = p.m_w * a_arm_1_z_minus_d_arm_2 + mc_arm_x * by_elevation_1 + by_elevation_9 + slopes_26;
    let slopes_37 = p.m_w * slopes_21 - mc_arm_x * alpha_arm_1_x_plus_slopes_1 + slopes_32 + slopes_33;
    let slopes_38 = c_elevation * (s_plus_s_0 * slopes_32 - slopes_22 + slopes_35);
    let slopes_39 = s_elevation * (slopes_30 + p.d * slopes_37);
    let slopes_40 = c_elevation * (slopes_15 + p.d * slopes_19) + slopes_39;
    let slopes_41 = elevation_ddot * c_pitch - slopes_2 * s_pitch;
    let slopes_42 = m_heli_slopes_9 - mc_heli_y * gravity_1 * two_omega_heli_z;
    let slopes_43 = mc_heli_y * by_pitch_1 - m_heli_slopes_8;
    let mc_heli_y_slopes_8 = mc_heli_y * slopes_8;
    let slopes_44 = I_heli_xx * (slopes_41 - omega_heli_z_pitch_dot) - I_heli_xx * omega_heli_z_omega_heli_x;
    let slopes_45 = slopes_14 * c_pitch + slopes_43 * s_pitch;
    let slopes_46 = slopes_43 * c_pitch - slopes_14_s_pitch;
    let slopes_47 = slopes_42 * c_pitch - m_heli_slopes_8_minus_heli_1 * s_pitch - slopes_45;
    let slopes_48 = slopes_44 * c_pitch - slopes_11 * s_pitch;
    let slopes_49 = p.L_a * (slopes_17 + slopes_42 * s_pitch + slopes_46);
    let slopes_50 = p.d * mc_heli_y * (omega_heli_z_omega_heli_x + omega_heli_z_pitch_dot - slopes_41);
    let slopes_51 = slopes_11_c_pitch + slopes_44 * s_pitch + slopes_49 + slopes_50;
    let slopes_52 = s_elevation * (I_heli_xx_by_pitch_1 - mc_heli_y_slopes_8 + p.d * slopes_47);
    let slopes_53 = c_elevation * (slopes_48 + p.L_a * slopes_47) + slopes_52;
    let slopes_54 = p.m_s * slopes_2_plus_alpha_arm_1_z;
    let slopes_55 = c_elevation * (slopes_12 + s_plus_s_0 * slopes_54);
    let slopes_56 = slopes_55 + p.d * slopes_54 * s_elevation;
    // derivatives with respect to elevation
    let by_elevation_12 = by_elevation_11 + slopes_31 * s_pitch + slopes_34 + p.d * slopes_36;
    let by_elevation_13 = l_pitch_elevation * slopes_30 - by_elevation_12;
    let by_elevation_14 = slopes_38 - slopes_20 + slopes_40 + l_elevation_travel * by_elevation_13;
    let d_travel_ddot_by_elevation = inv_travel * (l_pitch_travel * slopes_30 - by_elevation_14);
    let d_elevation_ddot_by_elevation = inv_elevation * by_elevation_13 - l_elevation_travel * d_travel_ddot_by_elevation;
    let by_elevation_15 = inv_pitch * slopes_30 + l_pitch_travel * d_travel_ddot_by_elevation;
    // derivatives with respect to pitch
    let by_pitch_2 = mc_heli_y_slopes_8 - I_heli_xx_by_pitch_1;
    let by_pitch_3 = slopes_51 + l_pitch_elevation * by_pitch_2;
    let by_pitch_4 = l_elevation_travel * by_pitch_3 - slopes_53 - l_pitch_travel * by_pitch_2;
    let d_travel_ddot_by_pitch = inv_travel * by_pitch_4;
    let d_elevation_ddot_by_pitch = -inv_elevation * by_pitch_3 - l_elevation_travel * d_travel_ddot_by_pitch;
    let by_pitch_5 = inv_pitch * by_pitch_2 - l_pitch_travel * d_travel_ddot_by_pitch;
    // derivatives with respect to s
    let by_s_1 = p.d * p.m_s * arm_1 - slopes_13 - p.m_s * s_plus_s_0 * slopes_4;
    let d_travel_ddot_by_s = -inv_travel * (slopes_56 + l_elevation_travel * by_s_1);
    let d_elevation_ddot_by_s = inv_elevation * by_s_1 - l_elevation_travel * d_travel_ddot_by_s;
    let d_pitch_ddot_by_s = -l_pitch_travel * d_travel_ddot_by_s - l_pitch_elevation * d_elevation_ddot_by_s;
    // derivatives with respect to V_f
    let by_V_f_1 = L_a_K_f_s_pitch_c_elevation + s_elevation * (d_K_f_s_pitch - L_h_K_f);
    let l_pitch_elevation_L_h_K_f = l_pitch_elevation * L_h_K_f;
    let by_V_f_2 = L_a_K_f_c_pitch - l_pitch_elevation_L_h_K_f;
    let l_pitch_travel_L_h_K_f = l_pitch_travel * L_h_K_f;
    let d_travel_ddot_by_V_f = -inv_travel * (by_V_f_1 + l_elevation_travel * by_V_f_2 + l_pitch_travel_L_h_K_f);
    let inv_pitch_L_h_K_f = inv_pitch * L_h_K_f;
    let d_elevation_ddot_by_V_f = inv_elevation * by_V_f_2 - l_elevation_travel * d_travel_ddot_by_V_f;
    let by_V_f_3 = inv_pitch_L_h_K_f - l_pitch_travel * d_travel_ddot_by_V_f;
    // derivatives with respect to V_b
    let by_V_b_1 = L_a_K_f_c_pitch + l_pitch_elevation_L_h_K_f;
    let d_travel_ddot_by_V_b = inv_travel * (l_pitch_travel_L_h_K_f - input_map_1 - l_elevation_travel * by_V_b_1);
    let d_elevation_ddot_by_V_b = inv_elevation * by_V_b_1 - l_elevation_travel * d_travel_ddot_by_V_b;
    let by_V_b_2 = inv_pitch_L_h_K_f + l_pitch_travel * d_travel_ddot_by_V_b;
    // derivatives with respect to s_ddot
    let d_travel_ddot_by_s_ddot = inv_travel * d_m_s * l_elevation_travel;
    let d_elevation_ddot_by_s_ddot = -d_m_s * inv_elevation - l_elevation_travel * d_travel_ddot_by_s_ddot;
    let by_s_ddot_1 = l_pitch_elevation * d_elevation_ddot_by_s_ddot;
    positive(I_heli_xx, 2)?;
    positive(pivot_elevation, 1)?;
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
                0.0, -by_elevation_15 - l_pitch_elevation * d_elevation_ddot_by_elevation,
                by_pitch_5 - l_pitch_elevation * d_elevation_ddot_by_pitch, d_pitch_ddot_by_s,
                -by_travel_dot_35 - l_pitch_elevation * d_elevation_ddot_by_travel_dot,
                -by_elevation_dot_24 - l_pitch_elevation * d_elevation_ddot_by_elevation_dot,
                -by_pitch_dot_8 - l_pitch_elevation * d_elevation_ddot_by_pitch_dot, -by_s_dot_3 - l_pitch_travel * d_travel_ddot_by_s_dot,
            ],
            [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], // s''
        ],
        b: [
            [0.0, 0.0, 0.0], // travel'
            [0.0, 0.0, 0.0], // elevation'
            [0.0, 0.0, 0.0], // pitch'
            [0.0, 0.0, 0.0], // s'
            [d_travel_ddot_by_V_f, d_travel_ddot_by_V_b, d_travel_ddot_by_s_ddot], // travel''
            [d_elevation_ddot_by_V_f, d_elevation_ddot_by_V_b, d_elevation_ddot_by_s_ddot], // elevation''
            // pitch''
            [
                by_V_f_3 - l_pitch_elevation * d_elevation_ddot_by_V_f, -by_V_b_2 - l_pitch_elevation * d_elevation_ddot_by_V_b,
                -by_s_ddot_1 - l_pitch_travel * d_travel_ddot_by_s_ddot,
            ],
            [0.0, 0.0, 1.0], // s''
        ],
    })
}

/// Parameter Jacobian dx'/dp, 8 x 14; columns in the order of [`Parameters`].
///
/// # Errors
/// [`Singular`] where the mass matrix is not positive definite.
pub fn parameter_jacobian(x: &State, u: &Inputs, p: &Parameters) -> Result<[[f64; 14]; 8], Singular> {
    let State { q, v } = x;
    let (s_elevation, c_elevation) = sin_cos(q.elevation);
    let (s_pitch, c_pitch) = sin_cos(q.pitch);
    let V_s = u.V_f + u.V_b;
    let F_f = p.K_f * u.V_f;
    let F_b = p.K_f * u.V_b;
    // frame rail on arm
    let s_plus_s_0 = q.s + p.s_0;
    let two_elevation_dot_s_dot = 2.0 * v.elevation * v.s;
    let m_s_s_plus_s_0 = p.m_s * s_plus_s_0;
    // body counterweight on arm
    let mc_arm_x = -p.m_w * p.L_w;
    let I_arm_yy = -p.L_w * mc_arm_x;
    // body front_rotor on heli
    let m_f_L_h = p.m_f * p.L_h;
    // body back_rotor on heli
    let m_b_L_h = p.m_b * p.L_h;
    // frame heli on arm
    let m_heli = p.m_f + p.m_b;
    let mc_heli_y = m_f_L_h - m_b_L_h;
    let I_heli_xx = p.L_h * m_f_L_h + p.L_h * m_b_L_h;
    let mc_heli_y_s_pitch = mc_heli_y * s_pitch;
    let mc_heli_y_c_pitch = mc_heli_y * c_pitch;
    let M_elevation_pitch = p.L_a * mc_heli_y_c_pitch;
    let L_a_mc_heli_y_s_pitch = p.L_a * mc_heli_y_s_pitch;
    let M_travel_pitch = s_elevation * (I_heli_xx - p.d * mc_heli_y_s_pitch) - L_a_mc_heli_y_s_pitch * c_elevation;
    let I_heli_xx_c_pitch = I_heli_xx * c_pitch;
    let I_heli_xx_c_pitch_c_pitch = I_heli_xx_c_pitch * c_pitch;
    // frame arm on column
    let omega_arm_1_z = c_elevation * v.travel;
    let omega_arm_1_x = s_elevation * v.travel;
    let alpha_arm_1_x = omega_arm_1_z * v.elevation;
    let alpha_arm_1_z = -omega_arm_1_x * v.elevation;
    let a_arm_1_x = p.g * s_elevation;
    let arm_1_1 = c_elevation * (I_heli_xx_c_pitch * s_pitch - p.d * mc_heli_y_c_pitch);
    let M_travel_elevation = arm_1_1 + M_elevation_pitch * s_elevation;
    // frame heli on arm
    let omega_heli_y = omega_arm_1_z * s_pitch - c_pitch * v.elevation;
    let omega_heli_z = s_pitch * v.elevation + omega_arm_1_z * c_pitch;
    let omega_heli_x = v.pitch + omega_arm_1_x;
    let omega_heli_y_pitch_dot = omega_heli_y * v.pitch;
    let alpha_heli_z = alpha_arm_1_z * c_pitch - omega_heli_y_pitch_dot;
    let omega_heli_y_omega_heli_x = omega_heli_y * omega_heli_x;
    let heli_1 = omega_heli_z * omega_heli_z + omega_heli_x * omega_heli_x;
    let mc_heli_y_heli_1 = mc_heli_y * heli_1;
    let omega_heli_y_omega_heli_z = omega_heli_y * omega_heli_z;
    // frame arm on column
    let omega_arm_1_z_omega_arm_1_x = omega_arm_1_z * omega_arm_1_x;
    let a_arm_y = 2.0 * p.d * alpha_arm_1_x;
    let elevation_dot_sq = v.elevation * v.elevation;
    let arm_1 = omega_arm_1_x * omega_arm_1_x + elevation_dot_sq;
    let arm_2 = elevation_dot_sq + omega_arm_1_z * omega_arm_1_z;
    let mc_arm_x_arm_2 = mc_arm_x * arm_2;
    let two_alpha_arm_1_z = 2.0 * alpha_arm_1_z;
    let a_arm_x = a_arm_1_x - p.d * omega_arm_1_z_omega_arm_1_x;
    let a_arm_z = p.d * arm_1 + p.g * c_elevation;
    let arm_3 = I_arm_yy + s_plus_s_0 * m_s_s_plus_s_0;
    let arm_4 = p.d * (mc_heli_y_s_pitch + mc_heli_y_s_pitch - p.d * (m_heli + p.m_w + p.m_s));
    let I_heli_xx_minus_arm_4 = I_heli_xx - arm_4;
    // frame heli on arm
    let L_a_arm_2 = p.L_a * arm_2;
    let a_heli_1_y = p.L_a * two_alpha_arm_1_z + a_arm_y;
    let a_heli_1_x = a_arm_x - L_a_arm_2;
    let a_heli_1_z = p.L_a * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    let L_a_m_heli = p.L_a * m_heli;
    let L_a_L_a_m_heli = p.L_a * L_a_m_heli;
    // frame rail on arm
    let s_plus_s_0_arm_2 = s_plus_s_0 * arm_2;
    let two_omega_arm_1_z_s_dot = 2.0 * omega_arm_1_z * v.s;
    let a_rail_y = s_plus_s_0 * two_alpha_arm_1_z + a_arm_y + two_omega_arm_1_z_s_dot;
    let f_rail_y = p.m_s * a_rail_y;
    let a_rail_z = two_elevation_dot_s_dot + s_plus_s_0 * omega_arm_1_z_omega_arm_1_x + a_arm_z;
    let f_rail_x = p.m_s * (u.s_ddot + a_arm_x - s_plus_s_0_arm_2);
    // frame arm on column
    let arm_5 = mc_arm_x * a_arm_y + 2.0 * I_arm_yy * alpha_arm_1_z + s_plus_s_0 * f_rail_y;
    let arm_6 = mc_arm_x * a_arm_z + I_arm_yy * omega_arm_1_z_omega_arm_1_x + p.m_s * s_plus_s_0 * a_rail_z;
    let M_elevation_elevation = arm_3 + I_heli_xx - I_heli_xx_c_pitch_c_pitch + L_a_L_a_m_heli - arm_4;
    // frame heli on arm
    let a_heli_y = a_heli_1_y * c_pitch + a_heli_1_z * s_pitch;
    let a_heli_z = a_heli_1_z * c_pitch - a_heli_1_y * s_pitch;
    let f_heli_x = mc_heli_y * (omega_heli_y_omega_heli_x - alpha_heli_z) + m_heli * a_heli_1_x;
    let f_heli_y = m_heli * a_heli_y - mc_heli_y_heli_1;
    let f_heli_z = mc_heli_y * (alpha_arm_1_x + omega_heli_y_omega_heli_z) + m_heli * a_heli_z;
    let n_heli_x = I_heli_xx * alpha_arm_1_x + I_heli_xx * omega_heli_y_omega_heli_z + mc_heli_y * a_heli_z;
    let n_heli_z = I_heli_xx * alpha_heli_z - I_heli_xx * omega_heli_y_omega_heli_x - mc_heli_y * a_heli_1_x;
    // frame arm on column
    let arm_1_2 = 2.0 * (p.d * (m_s_s_plus_s_0 + mc_arm_x + L_a_m_heli) - L_a_mc_heli_y_s_pitch);
    let arm_1_3 = c_elevation * (arm_3 + I_heli_xx_c_pitch_c_pitch + L_a_L_a_m_heli - I_heli_xx_minus_arm_4);
    let M_travel_travel = I_heli_xx_minus_arm_4 + c_elevation * (arm_1_3 + arm_1_2 * s_elevation);
    // force back on heli
    let f_heli_z_2 = F_f + F_b;
    let n_heli_x_2 = p.L_h * F_f - p.L_h * F_b;
    // gravity
    let c_elevation_c_pitch = c_elevation * c_pitch;
    // frame rail on arm
    let f_heli_z_3 = f_heli_z - f_heli_z_2;
    let n_heli_x_3 = n_heli_x - n_heli_x_2;
    // frame heli on arm
    let f_heli_1_y = f_heli_y * c_pitch - f_heli_z_3 * s_pitch;
    let f_heli_1_z = f_heli_y * s_pitch + f_heli_z_3 * c_pitch;
    // frame arm on column
    let f_arm_x = f_heli_x - mc_arm_x_arm_2 + p.m_w * a_arm_x + f_rail_x;
    let f_arm_y = f_rail_y + p.m_w * a_arm_y + mc_arm_x * two_alpha_arm_1_z + f_heli_1_y;
    let n_arm_y = -arm_6 - n_heli_z * s_pitch - p.L_a * f_heli_1_z;
    let n_arm_z = arm_5 + p.L_a * f_heli_1_y + n_heli_z * c_pitch;
    let n_column_z = n_arm_z * c_elevation + s_elevation * (n_heli_x_3 + p.d * f_arm_y);
    // balance of forces
    let tau_elevation = n_arm_y - p.c_elevation * v.elevation - p.d * f_arm_x;
    let tau_pitch = -p.c_pitch * v.pitch - n_heli_x_3;
    // M = L^T D L and back-substitution
    let inv_pitch = 1.0 / I_heli_xx;
    let l_pitch_travel = M_travel_pitch * inv_pitch;
    let l_pitch_elevation = M_elevation_pitch * inv_pitch;
    let pivot_elevation = M_elevation_elevation - M_elevation_pitch * l_pitch_elevation;
    let inv_elevation = 1.0 / pivot_elevation;
    let solve_1 = M_travel_elevation - M_travel_pitch * l_pitch_elevation;
    let l_elevation_travel = inv_elevation * solve_1;
    let solve_2 = M_travel_travel - solve_1 * l_elevation_travel;
    let pivot_travel = solve_2 - M_travel_pitch * l_pitch_travel;
    let inv_travel = 1.0 / pivot_travel;
    let solve_3 = tau_elevation - tau_pitch * l_pitch_elevation;
    let solve_4 = p.c_travel * v.travel + n_column_z + l_elevation_travel * solve_3;
    let travel_ddot = inv_travel * (-tau_pitch * l_pitch_travel - solve_4);
    let elevation_ddot = inv_elevation * solve_3 - l_elevation_travel * travel_ddot;
    let solve_5 = l_pitch_travel * travel_ddot - tau_pitch * inv_pitch;
    // slopes of the balance of forces, at the accelerations found
    let slopes_1 = alpha_arm_1_x + travel_ddot * s_elevation;
    let slopes_2 = travel_ddot * c_elevation + alpha_arm_1_z;
    let alpha_arm_1_x_plus_slopes_1 = alpha_arm_1_x + slopes_1;
    let slopes_3 = p.d * alpha_arm_1_x_plus_slopes_1;
    let slopes_4 = a_arm_1_x - p.d * (omega_arm_1_z_omega_arm_1_x - elevation_ddot);
    let m_w_slopes_3 = p.m_w * slopes_3;
    let slopes_2_plus_alpha_arm_1_z = slopes_2 + alpha_arm_1_z;
    let slopes_5 = omega_arm_1_z_omega_arm_1_x + elevation_ddot;
    let slopes_4_minus_L_a_arm_2 = slopes_4 - L_a_arm_2;
    let slopes_6 = slopes_3 + p.L_a * slopes_2_plus_alpha_arm_1_z;
    let a_arm_z_plus_L_a_slopes_5 = a_arm_z + p.L_a * slopes_5;
    let slopes_7 = elevation_ddot * s_pitch + slopes_2 * c_pitch;
    let slopes_8 = slopes_7 - omega_heli_y_pitch_dot;
    let slopes_9 = slopes_1 - solve_5 - l_pitch_elevation * elevation_ddot;
    let slopes_10 = slopes_6 * c_pitch + a_arm_z_plus_L_a_slopes_5 * s_pitch;
    let slopes_11 = a_arm_z_plus_L_a_slopes_5 * c_pitch - slopes_6 * s_pitch;
    let slopes_12 = omega_heli_y_omega_heli_z + slopes_9;
    let slopes_13 = m_heli * slopes_10 - mc_heli_y_heli_1;
    let slopes_14 = two_omega_arm_1_z_s_dot + slopes_3 + s_plus_s_0 * slopes_2_plus_alpha_arm_1_z;
    let slopes_15 = two_elevation_dot_s_dot + a_arm_z + s_plus_s_0 * slopes_5;
    let m_s_slopes_14 = p.m_s * slopes_14;
    let slopes_16 = m_heli * slopes_11 + mc_heli_y * slopes_12 - f_heli_z_2;
    let slopes_17 = slopes_13 * c_pitch - slopes_16 * s_pitch;
    let slopes_18 = m_w_slopes_3 + mc_arm_x * slopes_2_plus_alpha_arm_1_z + m_s_slopes_14 + slopes_17;
    let slopes_19 = p.m_s * slopes_2_plus_alpha_arm_1_z;
    let slopes_20 = p.m_s * slopes_15 + p.m_s * s_plus_s_0 * slopes_5;
    let slopes_21 = c_elevation * (m_s_slopes_14 + s_plus_s_0 * slopes_19);
    let slopes_22 = slopes_21 + p.d * slopes_19 * s_elevation;
    let slopes_23 = omega_heli_y_omega_heli_x + omega_heli_y_pitch_dot - slopes_7;
    let slopes_24 = u.s_ddot + slopes_4 - s_plus_s_0_arm_2;
    let slopes_25 = p.m_w * slopes_4 - mc_arm_x_arm_2 + p.m_s * slopes_24;
    let L_h_slopes_23 = p.L_h * slopes_23;
    let L_h_slopes_12 = p.L_h * slopes_12;
    let slopes_11_plus_L_h_slopes_12 = slopes_11 + L_h_slopes_12;
    let L_h_slopes_11 = p.L_h * slopes_11;
    let L_h_slopes_4_minus_L_a_arm_2 = p.L_h * slopes_4_minus_L_a_arm_2;
    let slopes_26 = p.d * (slopes_4_minus_L_a_arm_2 + L_h_slopes_23);
    let slopes_27 = slopes_11 - L_h_slopes_12;
    let slopes_28 = p.d * (slopes_4_minus_L_a_arm_2 - L_h_slopes_23);
    let d_slopes_4_plus_L_w_arm_2 = p.d * (slopes_4 + p.L_w * arm_2);
    let slopes_29 = p.d * s_elevation * (slopes_3 - p.L_w * slopes_2_plus_alpha_arm_1_z);
    let slopes_30 = slopes_5 * c_pitch - slopes_2_plus_alpha_arm_1_z * s_pitch;
    let slopes_31 = m_heli * (slopes_2_plus_alpha_arm_1_z * c_pitch + slopes_5 * s_pitch);
    let m_heli_slopes_30 = m_heli * slopes_30;
    let mc_heli_y_slopes_30 = mc_heli_y * slopes_30;
    let slopes_32 = slopes_31 * c_pitch - m_heli_slopes_30 * s_pitch;
    let slopes_33 = p.L_a * (slopes_31 * s_pitch + m_heli_slopes_30 * c_pitch);
    let slopes_34 = slopes_13 * s_pitch + slopes_16 * c_pitch + slopes_33;
    let slopes_35 = s_elevation * (mc_heli_y_slopes_30 + p.d * slopes_32);
    let slopes_36 = elevation_ddot - omega_arm_1_z_omega_arm_1_x;
    let slopes_37 = arm_1 * c_pitch - alpha_arm_1_x_plus_slopes_1 * s_pitch;
    let slopes_38 = m_heli * (arm_1 * s_pitch + alpha_arm_1_x_plus_slopes_1 * c_pitch);
    let m_heli_slopes_37 = m_heli * slopes_37;
    let mc_heli_y_slopes_37 = mc_heli_y * slopes_37;
    let mc_heli_y_slopes_36 = mc_heli_y * slopes_36;
    let slopes_39 = p.m_s * alpha_arm_1_x_plus_slopes_1;
    let slopes_40 = s_plus_s_0 * slopes_39 + mc_arm_x * alpha_arm_1_x_plus_slopes_1;
    let slopes_41 = slopes_38 * c_pitch - m_heli_slopes_37 * s_pitch;
    let slopes_42 = p.L_a * (slopes_38 * s_pitch + m_heli_slopes_37 * c_pitch);
    let slopes_43 = slopes_40 + p.L_a * slopes_41 - mc_heli_y_slopes_36 * c_pitch;
    let slopes_44 = p.d * (p.m_w * alpha_arm_1_x_plus_slopes_1 + slopes_39 + slopes_41);
    let slopes_45 = p.d * (m_heli * slopes_36 + p.m_w * slopes_36 + p.m_s * slopes_36);
    let slopes_46 = m_heli * slopes_4_minus_L_a_arm_2 + mc_heli_y * slopes_23 + slopes_25 + slopes_45;
    let slopes_47 = s_elevation * (mc_heli_y_slopes_37 + slopes_18 + slopes_44);
    let slopes_48 = s_plus_s_0 * slopes_15 + p.d * slopes_24;
    let slopes_49 = s_plus_s_0 * slopes_14 * c_elevation + p.d * slopes_14 * s_elevation;
    // derivatives with respect to s
    let d_m_s_arm_2_minus_slopes_20 = p.d * p.m_s * arm_2 - slopes_20;
    let d_travel_ddot_by_s = -inv_travel * (slopes_22 + l_elevation_travel * d_m_s_arm_2_minus_slopes_20);
    let d_elevation_ddot_by_s = inv_elevation * d_m_s_arm_2_minus_slopes_20 - l_elevation_travel * d_travel_ddot_by_s;
    let d_pitch_ddot_by_s = -l_pitch_travel * d_travel_ddot_by_s - l_pitch_elevation * d_elevation_ddot_by_s;
    // derivatives with respect to m_f
    let L_h_sq = p.L_h * p.L_h;
    let L_h_heli_1 = p.L_h * heli_1;
    // derivatives with respect to m_w
    let L_w_sq = p.L_w * p.L_w;
    // derivatives with respect to L_a
    let mc_heli_y_arm_2 = mc_heli_y * arm_2;
    let by_L_a_1 = p.d * m_heli * arm_2 - mc_heli_y_arm_2 * s_pitch - slopes_34;
    let by_L_a_2 = by_L_a_1 + l_pitch_elevation * mc_heli_y_slopes_30;
    // derivatives with respect to L_w
    let two_mc_arm_x = 2.0 * mc_arm_x;
    // derivatives with respect to L_h
    let m_f_minus_m_b = p.m_f - p.m_b;
    let two_m_f_L_h_plus_two_m_b_L_h = 2.0 * m_f_L_h + 2.0 * m_b_L_h;
    let heli_1_m_f_minus_m_b = heli_1 * m_f_minus_m_b;
    let F_f_minus_F_b = F_f - F_b;
    // derivatives with respect to d
    let by_d_1 = mc_arm_x * arm_1 + p.m_s * s_plus_s_0 * arm_1;
    let by_d_2 = mc_heli_y_slopes_36 * s_pitch - by_d_1 - slopes_42 - slopes_46;
    let by_d_3 = by_d_2 + l_pitch_elevation * mc_heli_y_slopes_37;
    let by_d_4 = slopes_43 * c_elevation + slopes_47 + l_elevation_travel * by_d_3;
    let d_travel_ddot_by_d = inv_travel * (l_pitch_travel * mc_heli_y_slopes_37 - by_d_4);
    let d_elevation_ddot_by_d = inv_elevation * by_d_3 - l_elevation_travel * d_travel_ddot_by_d;
    let by_d_5 = inv_pitch * mc_heli_y_slopes_37 + l_pitch_travel * d_travel_ddot_by_d;
    // derivatives with respect to K_f
    let L_h_V_f = p.L_h * u.V_f;
    let L_h_V_b = p.L_h * u.V_b;
    let L_h_V_f_minus_L_h_V_b = L_h_V_f - L_h_V_b;
    let V_s_s_pitch = V_s * s_pitch;
    let by_K_f_1 = s_elevation * (L_h_V_b - L_h_V_f + p.d * V_s_s_pitch);
    let by_K_f_2 = p.L_a * V_s_s_pitch * c_elevation + by_K_f_1;
    let by_K_f_3 = p.L_a * V_s * c_pitch - l_pitch_elevation * L_h_V_f_minus_L_h_V_b;
    let by_K_f_4 = by_K_f_2 + l_elevation_travel * by_K_f_3 + l_pitch_travel * L_h_V_f_minus_L_h_V_b;
    let d_travel_ddot_by_K_f = -inv_travel * by_K_f_4;
    let d_elevation_ddot_by_K_f = inv_elevation * by_K_f_3 - l_elevation_travel * d_travel_ddot_by_K_f;
    let by_K_f_5 = inv_pitch * L_h_V_f_minus_L_h_V_b - l_pitch_travel * d_travel_ddot_by_K_f;
    // derivatives with respect to g
    let m_heli_c_elevation_s_pitch = m_heli * c_elevation * s_pitch;
    let m_heli_c_elevation_c_pitch = m_heli * c_elevation_c_pitch;
    let by_g_1 = mc_heli_y * c_elevation_c_pitch;
    let mc_heli_y_s_elevation = mc_heli_y * s_elevation;
    let by_g_2 = mc_arm_x * c_elevation + p.m_s * s_plus_s_0 * c_elevation;
    let by_g_3 = m_heli_c_elevation_s_pitch * c_pitch - m_heli_c_elevation_c_pitch * s_pitch;
    let by_g_4 = p.L_a * (m_heli_c_elevation_s_pitch * s_pitch + m_heli_c_elevation_c_pitch * c_pitch);
    let by_g_5 = p.d * (m_heli * s_elevation + p.m_s * s_elevation + p.m_w * s_elevation);
    let by_g_6 = c_elevation * (p.L_a * by_g_3 - mc_heli_y_s_elevation * c_pitch);
    let by_g_7 = by_g_6 + s_elevation * (by_g_1 + p.d * by_g_3);
    let by_g_8 = mc_heli_y_s_elevation * s_pitch - by_g_2 - by_g_4 - by_g_5;
    let by_g_9 = by_g_8 + l_pitch_elevation * by_g_1;
    let by_g_10 = l_pitch_travel * by_g_1 - by_g_7 - l_elevation_travel * by_g_9;
    let d_travel_ddot_by_g = inv_travel * by_g_10;
    let d_elevation_ddot_by_g = inv_elevation * by_g_9 - l_elevation_travel * d_travel_ddot_by_g;
    let by_g_11 = inv_pitch * by_g_1 + l_pitch_travel * d_travel_ddot_by_g;
    // slopes of the balance of forces, at the accelerations found
    let slopes_10_minus_L_h_heli_1 = slopes_10 - L_h_heli_1;
    let slopes_50 = omega_heli_y_omega_heli_z * L_h_sq + slopes_9 * L_h_sq;
    let slopes_51 = slopes_8 * L_h_sq - omega_heli_y_omega_heli_x * L_h_sq;
    let L_h_slopes_11_plus_slopes_50 = L_h_slopes_11 + slopes_50;
    let slopes_52 = slopes_51 - L_h_slopes_4_minus_L_a_arm_2;
    let slopes_53 = slopes_10_minus_L_h_heli_1 * c_pitch - slopes_11_plus_L_h_slopes_12 * s_pitch;
    let slopes_54 = p.L_a * (slopes_10_minus_L_h_heli_1 * s_pitch + slopes_11_plus_L_h_slopes_12 * c_pitch);
    let slopes_55 = slopes_52 * s_pitch + slopes_54 + slopes_26;
    let slopes_56 = c_elevation * (slopes_52 * c_pitch + p.L_a * slopes_53);
    let slopes_57 = slopes_56 + s_elevation * (L_h_slopes_11_plus_slopes_50 + p.d * slopes_53);
    let slopes_10_plus_L_h_heli_1 = slopes_10 + L_h_heli_1;
    let slopes_58 = L_h_slopes_4_minus_L_a_arm_2 + slopes_51;
    let slopes_59 = slopes_10_plus_L_h_heli_1 * c_pitch - slopes_27 * s_pitch;
    let slopes_60 = p.L_a * (slopes_10_plus_L_h_heli_1 * s_pitch + slopes_27 * c_pitch);
    let slopes_61 = slopes_58 * s_pitch + slopes_60 + slopes_28;
    let slopes_62 = c_elevation * (slopes_58 * c_pitch + p.L_a * slopes_59);
    let slopes_63 = s_elevation * (slopes_50 - L_h_slopes_11 + p.d * slopes_59);
    let slopes_64 = slopes_2 * L_w_sq + alpha_arm_1_z * L_w_sq;
    let slopes_65 = p.L_w * a_arm_z - omega_arm_1_z_omega_arm_1_x * L_w_sq - elevation_ddot * L_w_sq;
    let slopes_66 = c_elevation * (slopes_64 - p.L_w * slopes_3) + slopes_29;
    let slopes_67 = mc_heli_y_arm_2 * c_pitch + slopes_17 + p.L_a * slopes_32;
    let slopes_68 = p.m_w * a_arm_z + omega_arm_1_z_omega_arm_1_x * two_mc_arm_x + elevation_ddot * two_mc_arm_x;
    let slopes_69 = slopes_2 * two_mc_arm_x + alpha_arm_1_z * two_mc_arm_x + m_w_slopes_3;
    let slopes_12_m_f_minus_m_b = slopes_12 * m_f_minus_m_b;
    let slopes_70 = omega_heli_y_omega_heli_z * two_m_f_L_h_plus_two_m_b_L_h + slopes_9 * two_m_f_L_h_plus_two_m_b_L_h;
    let slopes_71 = slopes_8 * two_m_f_L_h_plus_two_m_b_L_h - omega_heli_y_omega_heli_x * two_m_f_L_h_plus_two_m_b_L_h;
    let slopes_72 = slopes_11 * m_f_minus_m_b + slopes_70;
    let slopes_73 = slopes_71 - slopes_4_minus_L_a_arm_2 * m_f_minus_m_b;
    let slopes_74 = heli_1_m_f_minus_m_b * c_pitch + slopes_12_m_f_minus_m_b * s_pitch;
    let slopes_75 = p.L_a * (slopes_12_m_f_minus_m_b * c_pitch - heli_1_m_f_minus_m_b * s_pitch);
    let slopes_76 = slopes_73 * s_pitch + slopes_75 + p.d * m_f_minus_m_b * slopes_23;
    let slopes_77 = c_elevation * (slopes_73 * c_pitch - p.L_a * slopes_74);
    let slopes_78 = s_elevation * (slopes_72 - F_f_minus_F_b - p.d * slopes_74);
    // derivatives with respect to m_f
    let by_m_f_1 = l_pitch_elevation * L_h_slopes_11_plus_slopes_50 - slopes_55;
    let by_m_f_2 = l_pitch_travel * L_h_slopes_11_plus_slopes_50 - slopes_57 - l_elevation_travel * by_m_f_1;
    let d_travel_ddot_by_m_f = inv_travel * by_m_f_2;
    let d_elevation_ddot_by_m_f = inv_elevation * by_m_f_1 - l_elevation_travel * d_travel_ddot_by_m_f;
    let by_m_f_3 = inv_pitch * L_h_slopes_11_plus_slopes_50 + l_pitch_travel * d_travel_ddot_by_m_f;
    // derivatives with respect to m_b
    let by_m_b_1 = L_h_slopes_11 - slopes_50;
    let by_m_b_2 = slopes_61 + l_pitch_elevation * by_m_b_1;
    let by_m_b_3 = l_elevation_travel * by_m_b_2 - slopes_62 - slopes_63;
    let d_travel_ddot_by_m_b = inv_travel * (by_m_b_3 - l_pitch_travel * by_m_b_1);
    let d_elevation_ddot_by_m_b = -inv_elevation * by_m_b_2 - l_elevation_travel * d_travel_ddot_by_m_b;
    let by_m_b_4 = inv_pitch * by_m_b_1 - l_pitch_travel * d_travel_ddot_by_m_b;
    // derivatives with respect to m_w
    let by_m_w_1 = slopes_65 - d_slopes_4_plus_L_w_arm_2;
    let d_travel_ddot_by_m_w = -inv_travel * (slopes_66 + l_elevation_travel * by_m_w_1);
    let d_elevation_ddot_by_m_w = inv_elevation * by_m_w_1 - l_elevation_travel * d_travel_ddot_by_m_w;
    let d_pitch_ddot_by_m_w = -l_pitch_travel * d_travel_ddot_by_m_w - l_pitch_elevation * d_elevation_ddot_by_m_w;
    // derivatives with respect to L_a
    let by_L_a_3 = slopes_67 * c_elevation + slopes_35 + l_elevation_travel * by_L_a_2;
    let d_travel_ddot_by_L_a = inv_travel * (l_pitch_travel * mc_heli_y_slopes_30 - by_L_a_3);
    let d_elevation_ddot_by_L_a = inv_elevation * by_L_a_2 - l_elevation_travel * d_travel_ddot_by_L_a;
    let by_L_a_4 = inv_pitch * mc_heli_y_slopes_30 + l_pitch_travel * d_travel_ddot_by_L_a;
    // derivatives with respect to L_w
    let by_L_w_1 = p.m_w * p.d * slopes_2_plus_alpha_arm_1_z * s_elevation + slopes_69 * c_elevation;
    let slopes_68_minus_d_m_w_arm_2 = slopes_68 - p.m_w * p.d * arm_2;
    let d_travel_ddot_by_L_w = inv_travel * (by_L_w_1 - l_elevation_travel * slopes_68_minus_d_m_w_arm_2);
    let d_elevation_ddot_by_L_w = inv_elevation * slopes_68_minus_d_m_w_arm_2 - l_elevation_travel * d_travel_ddot_by_L_w;
    let d_pitch_ddot_by_L_w = -l_pitch_travel * d_travel_ddot_by_L_w - l_pitch_elevation * d_elevation_ddot_by_L_w;
    // derivatives with respect to L_h
    let by_L_h_1 = F_f_minus_F_b - slopes_72;
    let by_L_h_2 = slopes_76 + l_pitch_elevation * by_L_h_1;
    let by_L_h_3 = l_elevation_travel * by_L_h_2 - slopes_77 - slopes_78;
    let d_travel_ddot_by_L_h = inv_travel * (by_L_h_3 - l_pitch_travel * by_L_h_1);
    let d_elevation_ddot_by_L_h = -inv_elevation * by_L_h_2 - l_elevation_travel * d_travel_ddot_by_L_h;
    let by_L_h_4 = inv_pitch * by_L_h_1 - l_pitch_travel * d_travel_ddot_by_L_h;
    // derivatives with respect to c_travel
    let d_travel_ddot_by_c_travel = -inv_travel * v.travel;
    let d_elevation_ddot_by_c_travel = -l_elevation_travel * d_travel_ddot_by_c_travel;
    let by_c_travel_1 = l_pitch_elevation * d_elevation_ddot_by_c_travel;
    // derivatives with respect to c_elevation
    let d_travel_ddot_by_c_elevation = inv_travel * l_elevation_travel * v.elevation;
    let d_elevation_ddot_by_c_elevation = -inv_elevation * v.elevation - l_elevation_travel * d_travel_ddot_by_c_elevation;
    let by_c_elevation_1 = l_pitch_elevation * d_elevation_ddot_by_c_elevation;
    // derivatives with respect to c_pitch
    let l_pitch_elevation_pitch_dot = l_pitch_elevation * v.pitch;
    let d_travel_ddot_by_c_pitch = inv_travel * (l_pitch_travel * v.pitch - l_elevation_travel * l_pitch_elevation_pitch_dot);
    let d_elevation_ddot_by_c_pitch = inv_elevation * l_pitch_elevation_pitch_dot - l_elevation_travel * d_travel_ddot_by_c_pitch;
    let by_c_pitch_1 = inv_pitch * v.pitch + l_pitch_travel * d_travel_ddot_by_c_pitch;
    // derivatives with respect to m_s
    let d_travel_ddot_by_m_s = inv_travel * (l_elevation_travel * slopes_48 - slopes_49);
    let d_elevation_ddot_by_m_s = -inv_elevation * slopes_48 - l_elevation_travel * d_travel_ddot_by_m_s;
    let d_pitch_ddot_by_m_s = -l_pitch_elevation * d_elevation_ddot_by_m_s - l_pitch_travel * d_travel_ddot_by_m_s;
    positive(I_heli_xx, 2)?;
    positive(pivot_elevation, 1)?;
    positive(pivot_travel, 0)?;
    Ok([
        [0.0; 14], // travel'
        [0.0; 14], // elevation'
        [0.0; 14], // pitch'
        [0.0; 14], // s'
        // travel''
        Parameters {
            m_f: d_travel_ddot_by_m_f, m_b: d_travel_ddot_by_m_b, m_w: d_travel_ddot_by_m_w, L_a: d_travel_ddot_by_L_a,
            L_w: d_travel_ddot_by_L_w, L_h: d_travel_ddot_by_L_h, d: d_travel_ddot_by_d, K_f: d_travel_ddot_by_K_f,
            c_travel: d_travel_ddot_by_c_travel, c_elevation: d_travel_ddot_by_c_elevation, c_pitch: d_travel_ddot_by_c_pitch,
            g: d_travel_ddot_by_g, m_s: d_travel_ddot_by_m_s, s_0: d_travel_ddot_by_s,
        }.to_array(),
        // elevation''
        Parameters {
            m_f: d_elevation_ddot_by_m_f, m_b: d_elevation_ddot_by_m_b, m_w: d_elevation_ddot_by_m_w, L_a: d_elevation_ddot_by_L_a,
            L_w: d_elevation_ddot_by_L_w, L_h: d_elevation_ddot_by_L_h, d: d_elevation_ddot_by_d, K_f: d_elevation_ddot_by_K_f,
            c_travel: d_elevation_ddot_by_c_travel, c_elevation: d_elevation_ddot_by_c_elevation, c_pitch: d_elevation_ddot_by_c_pitch,
            g: d_elevation_ddot_by_g, m_s: d_elevation_ddot_by_m_s, s_0: d_elevation_ddot_by_s,
        }.to_array(),
        // pitch''
        Parameters {
            m_f: -by_m_f_3 - l_pitch_elevation * d_elevation_ddot_by_m_f, m_b: by_m_b_4 - l_pitch_elevation * d_elevation_ddot_by_m_b,
            m_w: d_pitch_ddot_by_m_w, L_a: -by_L_a_4 - l_pitch_elevation * d_elevation_ddot_by_L_a, L_w: d_pitch_ddot_by_L_w,
            L_h: by_L_h_4 - l_pitch_elevation * d_elevation_ddot_by_L_h, d: -by_d_5 - l_pitch_elevation * d_elevation_ddot_by_d,
            K_f: by_K_f_5 - l_pitch_elevation * d_elevation_ddot_by_K_f,
            c_travel: -l_pitch_travel * d_travel_ddot_by_c_travel - by_c_travel_1,
            c_elevation: -by_c_elevation_1 - l_pitch_travel * d_travel_ddot_by_c_elevation,
            c_pitch: -by_c_pitch_1 - l_pitch_elevation * d_elevation_ddot_by_c_pitch,
            g: -by_g_11 - l_pitch_elevation * d_elevation_ddot_by_g, m_s: d_pitch_ddot_by_m_s, s_0: d_pitch_ddot_by_s,
        }.to_array(),
        [0.0; 14], // s''
    ])
}

/// Jacobians of the measured outputs at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputJacobian {
    /// C = dy/dx, 4 x 8.
    pub by_x: [[f64; 8]; 4],
    /// dy/dp, 4 x 14.
    pub by_p: [[f64; 14]; 4],
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
            [0.0; 14], // travel
            [0.0; 14], // elevation
            [0.0; 14], // pitch
            [0.0; 14], // s
        ],
    }
}

/// Names of the states.
pub const STATE_NAMES: [&str; 8] = ["travel", "elevation", "pitch", "s", "travel.dot", "elevation.dot", "pitch.dot", "s.dot"];
/// Names of the signals.
pub const INPUT_NAMES: [&str; 3] = ["V_f", "V_b", "s.ddot"];
/// Names of the parameters.
pub const PARAMETER_NAMES: [&str; 14] = [
    "m_f", "m_b", "m_w", "L_a", "L_w", "L_h", "d", "K_f", "c_travel", "c_elevation", "c_pitch", "g", "m_s", "s_0",
];
/// Units of the parameters.
pub const PARAMETER_UNITS: [&str; 14] = ["kg", "kg", "kg", "m", "m", "m", "m", "N/V", "N*m*s", "N*m*s", "N*m*s", "m/s^2", "kg", "m"];
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
        Dimensions { coordinates: 4, lags: 0, inputs: 2, exogenous: 1, parameters: 14, outputs: 4 }
    }

    fn names(&self) -> &dyn Names {
        self
    }

    fn nominal(&self, p: &mut [f64]) {
        runtime::write(p, &Parameters::NOMINAL.to_array());
    }

    fn rhs(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        let x = State::from_array(runtime::array(x));
        let u = Inputs::from_array(runtime::array(u));
        let p = Parameters::from_array(runtime::array(p));
        let a = forward_dynamics(&x, &u, &p)?;
        runtime::write_at(dx, 0, &x.v.to_array());
        runtime::write_at(dx, 4, &a.to_array());
        Ok(())
    }

    fn linearize(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64], a: &mut [f64], b: &mut [f64]) -> Result<(), Singular> {
        let x = State::from_array(runtime::array(x));
        let u = Inputs::from_array(runtime::array(u));
        let p = Parameters::from_array(runtime::array(p));
        let linear = linearize(&x, &u, &p)?;
        runtime::write(dx, &linear.dx);
        runtime::write(a, linear.a.as_flattened());
        runtime::write(b, linear.b.as_flattened());
        Ok(())
    }

    fn parameter_jacobian(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], dfdp: &mut [f64]) -> Result<(), Singular> {
        let x = State::from_array(runtime::array(x));
        let u = Inputs::from_array(runtime::array(u));
        let p = Parameters::from_array(runtime::array(p));
        runtime::write(dfdp, parameter_jacobian(&x, &u, &p)?.as_flattened());
        Ok(())
    }

    fn outputs(&self, _t: f64, x: &[f64], p: &[f64], y: &mut [f64]) {
        let x = State::from_array(runtime::array(x));
        let p = Parameters::from_array(runtime::array(p));
        runtime::write(y, &outputs(&x, &p).to_array());
    }

    fn output_jacobian(&self, _t: f64, x: &[f64], p: &[f64], c: &mut [f64], dhdp: &mut [f64]) {
        let x = State::from_array(runtime::array(x));
        let p = Parameters::from_array(runtime::array(p));
        let slopes = output_jacobian(&x, &p);
        runtime::write(c, slopes.by_x.as_flattened());
        runtime::write(dhdp, slopes.by_p.as_flattened());
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
            0 => OutputPath { quantum: 0.0007669903939428206, wrapped: false, delay: 0.0 },
            1 => OutputPath { quantum: 0.0015339807878856412, wrapped: false, delay: 0.0 },
            2 => OutputPath { quantum: 0.0015339807878856412, wrapped: false, delay: 0.0 },
            3 => OutputPath { quantum: 2.0671407309409624e-6, wrapped: false, delay: 0.0 },
            _ => OutputPath { delay: 0.0, quantum: 0.0, wrapped: false },
        }
    }
}
