//! Equations of motion of six rigs, by hand: M(q) a = f(q, v, u), friction apart from what the base has left out.

use super::{MOST, Row};

/// Standard gravity [m/s^2].
const G: f64 = 9.81;

/// A rig's equations.
#[derive(Clone, Debug)]
pub enum Mechanics {
    /// A bob on a rod with a motor.
    Pendulum(Pendulum),
    /// A hanging pole on a cart that is pushed.
    CartPole(CartPole),
    /// A rotary pendulum.
    Furuta(Furuta),
    /// A helicopter of three degrees of freedom, lumped: accelerations.
    Helicopter(Helicopter),
    /// Two links with a motor each, the second one's belt over the shoulder.
    DoublePendulum(DoublePendulum),
    /// A carriage on a screw.
    Drive(Drive),
}

/// theta = 0 hangs.
#[derive(Clone, Debug)]
pub struct Pendulum {
    /// Mass [kg].
    pub m: f64,
    /// Axis down to the centre of mass [m].
    pub l: f64,
    /// Centre of mass off the rod [m].
    pub dx: f64,
    /// Inertia about the centre [kg m^2].
    pub j: f64,
    /// Lean of the base [rad].
    pub tilt: f64,
}

/// theta = 0 hangs.
#[derive(Clone, Debug)]
pub struct CartPole {
    /// Cart [kg].
    pub m_c: f64,
    /// Pole [kg].
    pub m_p: f64,
    /// Axis down to the pole's centre [m].
    pub l: f64,
    /// Its centre off the pole [m].
    pub dx: f64,
    /// Inertia about the centre [kg m^2].
    pub j: f64,
}

/// alpha = 0 hangs.
#[derive(Clone, Debug)]
pub struct Furuta {
    /// Arm with rotor and hub about the axis, without the pendulum [kg m^2].
    pub j_arm: f64,
    /// Arm's length [m].
    pub r: f64,
    /// Pendulum's mass [kg].
    pub m: f64,
    /// Pendulum's half length [m].
    pub l: f64,
    /// Pendulum's inertia about its centre [kg m^2].
    pub j: f64,
}

/// Constants of the lumped equations.
#[derive(Clone, Debug)]
pub struct Helicopter {
    /// Gravity over inertia [1/s^2].
    pub a: [f64; 3],
    /// Thrust over inertia [1/(kg m)].
    pub b: [f64; 4],
}

/// q1 = 0 hangs; q2 relative to the upper link.
#[derive(Clone, Debug)]
pub struct DoublePendulum {
    /// Masses [kg].
    pub m: [f64; 2],
    /// Joints to centres of mass [m].
    pub r: [f64; 2],
    /// Shoulder to elbow [m].
    pub l: f64,
    /// Inertias about the joints [kg m^2].
    pub i: [f64; 2],
    /// Rotors [kg m^2].
    pub rotor: f64,
    /// Gear ratio.
    pub n: f64,
}

/// A mass.
#[derive(Clone, Debug)]
pub struct Drive {
    /// Mass [kg].
    pub m: f64,
    /// Force by command [N/V].
    pub gain: f64,
}

impl Mechanics {
    /// Number of coordinates.
    #[must_use]
    pub fn coordinates(&self) -> usize {
        match self {
            Self::Pendulum(_) | Self::Drive(_) => 1,
            Self::CartPole(_) | Self::Furuta(_) | Self::DoublePendulum(_) => 2,
            Self::Helicopter(_) => 3,
        }
    }

    /// Mass matrix and forces.
    #[must_use]
    pub fn equations(&self, q: &Row, v: &Row, u: &Row) -> ([Row; MOST], Row) {
        let mut m = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut f = [0.0; MOST];
        match self {
            Self::Pendulum(p) => {
                let (s, c) = q[0].sin_cos();
                let (st, ct) = p.tilt.sin_cos();
                m[0][0] = p.j + p.m * (p.l * p.l + p.dx * p.dx);
                f[0] = u[0] + p.m * G * (st * (p.l * c - p.dx * s) - ct * (p.l * s + p.dx * c));
            }
            Self::CartPole(p) => {
                let (s, c) = q[1].sin_cos();
                let across = p.m_p * (p.l * c - p.dx * s);
                let along = p.m_p * (p.l * s + p.dx * c);
                m[0] = [p.m_c + p.m_p, across, 0.0];
                m[1] = [across, p.j + p.m_p * (p.l * p.l + p.dx * p.dx), 0.0];
                f[0] = u[0] + along * v[1] * v[1];
                f[1] = -G * along;
            }
            Self::Furuta(p) => {
                let (s, c) = q[1].sin_cos();
                let k = p.m * p.l * p.l + p.j;
                let h = p.m * p.r * p.l;
                m[0] = [p.j_arm + p.m * p.r * p.r + k * s * s, h * c, 0.0];
                m[1] = [h * c, k, 0.0];
                f[0] = u[0] - 2.0 * k * s * c * v[0] * v[1] + h * s * v[1] * v[1];
                f[1] = k * s * c * v[0] * v[0] - p.m * G * p.l * s;
            }
            Self::Helicopter(p) => {
                let (se, ce) = q[1].sin_cos();
                let (st, ct) = q[2].sin_cos();
                let (sum, difference) = (u[0] + u[1], u[0] - u[1]);
                f[0] = p.b[2] * st * ce * sum - p.b[3] * st * se * difference;
                f[1] = -p.a[0] * ct * se - p.a[1] * ce + p.b[0] * ct * sum;
                f[2] = -p.a[2] * ce * st + p.b[1] * difference;
            }
            Self::DoublePendulum(p) => {
                let h = p.m[1] * p.l * p.r[1];
                let (s2, c2) = q[1].sin_cos();
                let m11 = p.i[0] + p.i[1] + p.m[1] * p.l * p.l + 2.0 * h * c2 + p.rotor * (p.n * p.n + 1.0);
                let m12 = p.i[1] + h * c2 - p.n * p.rotor;
                m[0] = [m11, m12, 0.0];
                m[1] = [m12, p.i[1] + p.n * p.n * p.rotor, 0.0];
                let lower = p.m[1] * p.r[1] * G * (q[0] + q[1]).sin();
                f[0] = u[0] + h * s2 * (2.0 * v[0] * v[1] + v[1] * v[1]) - (p.m[0] * p.r[0] + p.m[1] * p.l) * G * q[0].sin() - lower;
                f[1] = u[1] - h * s2 * v[0] * v[0] - lower;
            }
            Self::Drive(p) => {
                m[0][0] = p.m;
                f[0] = p.gain * u[0];
            }
        }
        (m, f)
    }
}
