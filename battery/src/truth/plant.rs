//! A rig with everything that can be hidden in it: forces, what happens to a command, what a sensor makes of a motion.

use super::mechanics::Mechanics;
use super::{MOST, Row};

/// A rig as it really is.
#[derive(Clone, Debug)]
pub struct Plant {
    /// Equations.
    pub mechanics: Mechanics,
    /// Friction and other forces of each joint.
    pub joints: [Joint; MOST],
    /// Torque by an angle: angle, equation, periods per turn, sine, cosine.
    pub periodic: Vec<(usize, usize, f64, f64, f64)>,
    /// Product of rates: first, second, equation, coefficient.
    pub products: Vec<(usize, usize, usize, f64)>,
    /// Command on a coordinate: input, equation, coefficient.
    pub couplings: Vec<(usize, usize, f64)>,
    /// What happens to commands.
    pub paths: [Path; MOST],
    /// Sensors.
    pub sensors: [Sensor; MOST],
}

/// Forces in a joint; none where all is zero.
#[derive(Clone, Debug, Default)]
pub struct Joint {
    /// Viscous friction.
    pub viscous: f64,
    /// Coulomb friction, sharp.
    pub coulomb: f64,
    /// Static friction beyond it, and the speed over which it goes.
    pub stribeck: (f64, f64),
    /// Share by which dry friction changes with the position, and periods per unit of it.
    pub by_position: (f64, f64),
    /// Friction by abs(v), and offset.
    pub asymmetric: (f64, f64),
    /// Friction by v abs(v).
    pub quadratic: f64,
    /// Stiffness and force at zero.
    pub spring: (f64, f64),
    /// Cubic stiffness.
    pub cubic: f64,
    /// Constant force.
    pub constant: f64,
    /// Stops: position and stiffness, lower and upper.
    pub stops: Option<[(f64, f64); 2]>,
    /// Bristles instead of sharp friction.
    pub bristles: Option<Bristles>,
}

/// The LuGre law (C. Canudas de Wit et al., IEEE TAC 40, 1995): stiffness and damping of bristles, friction that they slide at.
#[derive(Clone, Copy, Debug)]
pub struct Bristles {
    /// Stiffness.
    pub stiffness: f64,
    /// Damping.
    pub damping: f64,
    /// Coulomb friction.
    pub coulomb: f64,
    /// Static friction.
    pub rest: f64,
    /// Speed between them.
    pub speed: f64,
}

/// From a command to what acts.
#[derive(Clone, Debug, Default)]
pub struct Path {
    /// Delay [s].
    pub delay: f64,
    /// Time constant [s].
    pub lag: f64,
    /// Offset.
    pub bias: f64,
    /// Relative gain more.
    pub gain: f64,
    /// Gain by the command.
    pub curvature: f64,
    /// Loss of gain by time [1/s].
    pub drift: f64,
    /// Half width of the dead zone.
    pub dead_zone: f64,
    /// Share that is lost beyond a limit.
    pub saturation: (f64, f64),
    /// Gain more at the start, over this time [s].
    pub transient: (f64, f64),
    /// What it moves hangs at a spring.
    pub compliance: Option<Compliance>,
}

/// A mass at a spring, between an actuator and what it moves.
#[derive(Clone, Copy, Debug)]
pub struct Compliance {
    /// Inertia beyond the spring over that before it.
    pub ratio: f64,
    /// Resonance of what is beyond, what is before being held [rad/s].
    pub frequency: f64,
    /// Its damping ratio.
    pub damping: f64,
}

impl Compliance {
    /// What acts in all while the spring is bent by `bent` units of the command.
    #[must_use]
    pub fn acts(&self, command: f64, bent: f64) -> f64 {
        command + self.ratio * (command - bent)
    }

    /// The spring after `h` under a command that stays: bend and its rate, by the classical Runge-Kutta rule.
    #[must_use]
    pub fn bend(&self, (bent, rate): (f64, f64), command: f64, h: f64) -> (f64, f64) {
        let w = self.frequency;
        let slope = |x: (f64, f64)| (x.1, w * w * (self.acts(command, x.0) - x.0) - 2.0 * self.damping * w * x.1);
        let on = |d: (f64, f64), h: f64| (bent + h * d.0, rate + h * d.1);
        let a = slope((bent, rate));
        let b = slope(on(a, 0.5 * h));
        let c = slope(on(b, 0.5 * h));
        let d = slope(on(c, h));
        on((a.0 + 2.0 * b.0 + 2.0 * c.0 + d.0, a.1 + 2.0 * b.1 + 2.0 * c.1 + d.1), h / 6.0)
    }
}

/// From a motion to a measured value.
#[derive(Clone, Debug, Default)]
pub struct Sensor {
    /// Zero.
    pub bias: f64,
    /// Relative scale more.
    pub scale: f64,
    /// Delay [s].
    pub delay: f64,
    /// Drift [1/s].
    pub drift: f64,
    /// Share of another coordinate.
    pub misaligned: Option<(usize, f64)>,
    /// Play between the joint and it: it stands until the joint has gone through.
    pub play: f64,
    /// Step of the encoder; zero for none.
    pub quantum: f64,
    /// Standard deviation of its noise.
    pub noise: f64,
}

impl Plant {
    /// A plant with nothing but equations.
    #[must_use]
    pub fn new(mechanics: Mechanics) -> Self {
        Self {
            mechanics,
            joints: Default::default(),
            periodic: Vec::new(),
            products: Vec::new(),
            couplings: Vec::new(),
            paths: Default::default(),
            sensors: Default::default(),
        }
    }

    /// Mass matrix, and forces without those that can hold a joint.
    #[must_use]
    pub fn forces(&self, q: &Row, v: &Row, u: &Row) -> ([Row; MOST], Row) {
        let (m, mut f) = self.mechanics.equations(q, v, u);
        for (i, joint) in self.joints.iter().enumerate().take(self.mechanics.coordinates()) {
            f[i] += joint.force(q[i], v[i]);
        }
        for &(angle, row, n, s, c) in &self.periodic {
            let (sin, cos) = (n * q[angle]).sin_cos();
            f[row] += s * sin + c * cos;
        }
        for &(i, j, row, k) in &self.products {
            f[row] += k * v[i] * v[j];
        }
        for &(input, row, k) in &self.couplings {
            f[row] += k * u[input];
        }
        (m, f)
    }
}

impl Joint {
    fn force(&self, q: f64, v: f64) -> f64 {
        let mut f = -self.viscous * v - self.asymmetric.0 * v.abs() - self.asymmetric.1 - self.quadratic * v * v.abs();
        f += self.spring.1 - self.spring.0 * q - self.cubic * q.powi(3) + self.constant;
        if let Some([lower, upper]) = self.stops {
            f += lower.1 * (lower.0 - q).max(0.0) - upper.1 * (q - upper.0).max(0.0);
        }
        f
    }

    /// It can stick.
    #[must_use]
    pub fn is_dry(&self) -> bool {
        self.coulomb > 0.0 || self.stribeck.0 > 0.0
    }

    /// Dry friction at a rate; what it can hold at rest.
    #[must_use]
    pub fn dry(&self, q: f64, v: f64) -> f64 {
        let falling = if self.stribeck.0 > 0.0 { self.stribeck.0 * (-(v / self.stribeck.1).powi(2)).exp() } else { 0.0 };
        (self.coulomb + falling) * (1.0 + self.by_position.0 * (self.by_position.1 * q).sin())
    }
}

impl Bristles {
    /// Force, and how the bristles bend on.
    #[must_use]
    pub fn force(&self, v: f64, bent: f64) -> (f64, f64) {
        let slides = self.coulomb + (self.rest - self.coulomb) * (-(v / self.speed).powi(2)).exp();
        let rate = v - self.stiffness * v.abs() / slides.max(1e-12) * bent;
        (-self.stiffness * bent - self.damping * rate, rate)
    }
}

impl Path {
    /// What is asked of the actuator by a (delayed) command, before its lag.
    #[must_use]
    pub fn asked(&self, t: f64, command: f64) -> f64 {
        let mut factor = (1.0 + self.gain) * (1.0 + self.curvature * command) * (1.0 - self.drift * t);
        if self.transient.1 > 0.0 {
            factor *= 1.0 + self.transient.0 * (-t / self.transient.1).exp();
        }
        let mut u = command * factor + self.bias;
        u -= u.clamp(-self.dead_zone, self.dead_zone);
        if self.saturation.0 != 0.0 {
            u -= self.saturation.0 * (u - u.clamp(-self.saturation.1, self.saturation.1));
        }
        u
    }
}
