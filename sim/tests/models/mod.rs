//! Hand-written models with exact derivatives, for the tests of trajectories.
#![allow(dead_code, clippy::too_many_arguments)]

use runtime::{Dimensions, InputPath, Model, Names, OutputPath, Singular};

/// What a hand-written model says.
pub trait Equations: Sync {
    const COORDINATES: usize;
    const LAGS: usize = 0;
    const INPUTS: usize = 1;
    const PARAMETERS: usize = 1;
    const LIMITS: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);
    const DELAY: f64 = 0.0;
    const OUTPUT_PATH: OutputPath = OutputPath { delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false };
    fn rhs(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular>;
    fn slopes(&self, _t: f64, _x: &[f64], _u: &[f64], _p: &[f64], _a: &mut [f64], _b: &mut [f64], _dp: &mut [f64]) {}
    fn output_path(&self, _p: &[f64]) -> OutputPath {
        Self::OUTPUT_PATH
    }
}

/// Behind the model trait: outputs are the coordinates.
pub struct Hand<E>(pub E);

impl<E: Equations> Names for Hand<E> {
    fn rig(&self) -> &str {
        "hand"
    }
    fn state(&self, i: usize) -> &str {
        if i < E::COORDINATES { ["q0", "q1"][i] } else { ["q0.dot", "q1.dot", "u.lag"][i - E::COORDINATES] }
    }
    fn signal(&self, _: usize) -> &str {
        "u"
    }
    fn parameter(&self, _: usize) -> &str {
        "p"
    }
    fn output(&self, i: usize) -> &str {
        ["q0", "q1"][i]
    }
    fn parameter_unit(&self, _: usize) -> &str {
        "1"
    }
    fn output_unit(&self, _: usize) -> &str {
        "m"
    }
}

impl<E: Equations> Model for Hand<E> {
    fn dimensions(&self) -> Dimensions {
        Dimensions {
            coordinates: E::COORDINATES,
            lags: E::LAGS,
            inputs: E::INPUTS,
            exogenous: 0,
            parameters: E::PARAMETERS,
            outputs: E::COORDINATES,
        }
    }
    fn names(&self) -> &dyn Names {
        self
    }
    fn nominal(&self, p: &mut [f64]) {
        p.fill(1.0);
    }
    fn rhs(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        self.0.rhs(t, x, u, p, dx)
    }
    fn linearize(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64], a: &mut [f64], b: &mut [f64]) -> Result<(), Singular> {
        self.0.rhs(t, x, u, p, dx)?;
        self.0.slopes(t, x, u, p, a, b, &mut vec![0.0; x.len() * p.len()]);
        Ok(())
    }
    fn parameter_jacobian(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dfdp: &mut [f64]) -> Result<(), Singular> {
        self.0.slopes(t, x, u, p, &mut vec![0.0; x.len() * x.len()], &mut vec![0.0; x.len() * u.len()], dfdp);
        Ok(())
    }
    fn outputs(&self, _t: f64, x: &[f64], _p: &[f64], y: &mut [f64]) {
        y.copy_from_slice(&x[..E::COORDINATES]);
    }
    fn output_jacobian(&self, _t: f64, x: &[f64], _p: &[f64], c: &mut [f64], dhdp: &mut [f64]) {
        c.fill(0.0);
        dhdp.fill(0.0);
        (0..E::COORDINATES).for_each(|i| c[i * x.len() + i] = 1.0);
    }
    fn input_path(&self, _: usize, _: &[f64]) -> InputPath {
        InputPath { limits: E::LIMITS, delay: E::DELAY }
    }
    fn output_path(&self, _: usize, p: &[f64]) -> OutputPath {
        self.0.output_path(p)
    }
}

/// q'' = -w^2 q - 2 d q' + z, z' = (u - z) / tau: linear, with a lag. p = (w, d, tau).
pub struct Linear;

impl Equations for Linear {
    const COORDINATES: usize = 1;
    const LAGS: usize = 1;
    const PARAMETERS: usize = 3;
    fn rhs(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        dx.copy_from_slice(&[x[1], -p[0] * p[0] * x[0] - 2.0 * p[1] * x[1] + x[2], (u[0] - x[2]) / p[2]]);
        Ok(())
    }
    fn slopes(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], a: &mut [f64], b: &mut [f64], dp: &mut [f64]) {
        a.copy_from_slice(&[0.0, 1.0, 0.0, -p[0] * p[0], -2.0 * p[1], 1.0, 0.0, 0.0, -1.0 / p[2]]);
        b.copy_from_slice(&[0.0, 0.0, 1.0 / p[2]]);
        dp.copy_from_slice(&[0.0, 0.0, 0.0, -2.0 * p[0] * x[0], -2.0 * x[1], 0.0, 0.0, 0.0, -(u[0] - x[2]) / (p[2] * p[2])]);
    }
}

/// Pendulum q'' = -p0 sin q - p1 q' + p2 u.
pub struct Pendulum;

impl Equations for Pendulum {
    const COORDINATES: usize = 1;
    const PARAMETERS: usize = 3;
    fn rhs(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        dx.copy_from_slice(&[x[1], -p[0] * x[0].sin() - p[1] * x[1] + p[2] * u[0]]);
        Ok(())
    }
    fn slopes(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], a: &mut [f64], b: &mut [f64], dp: &mut [f64]) {
        a.copy_from_slice(&[0.0, 1.0, -p[0] * x[0].cos(), -p[1]]);
        b.copy_from_slice(&[0.0, p[2]]);
        dp.copy_from_slice(&[0.0, 0.0, 0.0, -x[0].sin(), -x[1], u[0]]);
    }
}

/// The pendulum behind a play of 2 p3, read late.
pub struct Played;

impl Equations for Played {
    const COORDINATES: usize = 1;
    const PARAMETERS: usize = 4;
    fn rhs(&self, t: f64, x: &[f64], u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        Pendulum.rhs(t, x, u, p, dx)
    }
    fn slopes(&self, _t: f64, x: &[f64], u: &[f64], p: &[f64], a: &mut [f64], b: &mut [f64], dp: &mut [f64]) {
        a.copy_from_slice(&[0.0, 1.0, -p[0] * x[0].cos(), -p[1]]);
        b.copy_from_slice(&[0.0, p[2]]);
        dp.copy_from_slice(&[0.0, 0.0, 0.0, 0.0, -x[0].sin(), -x[1], u[0], 0.0]);
    }
    fn output_path(&self, p: &[f64]) -> OutputPath {
        OutputPath { delay: 0.03, play: 2.0 * p[3], quantum: 0.0, wrapped: false }
    }
}

/// Two masses between stiffening springs: q0'' = -q0 - q0^3 + q1 - q0, q1'' = -q1 - q1^3 + q0 - q1. No damping.
pub struct Duffing;

impl Duffing {
    pub fn energy(x: &[f64]) -> f64 {
        let spring = |q: f64| 0.5 * q * q + 0.25 * q.powi(4);
        0.5 * (x[2] * x[2] + x[3] * x[3]) + spring(x[0]) + spring(x[1]) + 0.5 * (x[0] - x[1]).powi(2)
    }
}

impl Equations for Duffing {
    const COORDINATES: usize = 2;
    fn rhs(&self, _t: f64, x: &[f64], _u: &[f64], _p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        let force = |q: f64| q + q.powi(3);
        dx.copy_from_slice(&[x[2], x[3], -force(x[0]) + x[1] - x[0], -force(x[1]) + x[0] - x[1]]);
        Ok(())
    }
}

/// Double integrator with limits, input delay and an encoder behind an output delay.
pub struct Paths;

impl Equations for Paths {
    const COORDINATES: usize = 1;
    const LIMITS: (f64, f64) = (-1.0, 1.0);
    const DELAY: f64 = 0.125;
    const OUTPUT_PATH: OutputPath = OutputPath { delay: 0.25, play: 0.0, quantum: 0.01, wrapped: false };
    fn rhs(&self, _t: f64, x: &[f64], u: &[f64], _p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        dx.copy_from_slice(&[x[1], u[0]]);
        Ok(())
    }
}

/// q' = u: a position that is led along straight lines, read behind a play of 0.5, late and in steps of 0.125.
pub struct Led;

impl Equations for Led {
    const COORDINATES: usize = 1;
    const OUTPUT_PATH: OutputPath = OutputPath { delay: 0.25, play: 0.5, quantum: 0.125, wrapped: false };
    fn rhs(&self, _t: f64, _x: &[f64], u: &[f64], _p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        dx.copy_from_slice(&[u[0], 0.0]);
        Ok(())
    }
}

/// An output path that cannot be: its play is negative.
pub struct Misread;

impl Equations for Misread {
    const COORDINATES: usize = 1;
    const OUTPUT_PATH: OutputPath = OutputPath { delay: 0.0, play: -0.5, quantum: 0.0, wrapped: false };
    fn rhs(&self, _t: f64, x: &[f64], u: &[f64], _p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        dx.copy_from_slice(&[x[1], u[0]]);
        Ok(())
    }
}

/// Van der Pol's oscillator, q'' = p (1 - q^2) q' - q: stiff for large p.
pub struct VanDerPol;

impl Equations for VanDerPol {
    const COORDINATES: usize = 1;
    fn rhs(&self, _t: f64, x: &[f64], _u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        dx.copy_from_slice(&[x[1], p[0] * (1.0 - x[0] * x[0]) * x[1] - x[0]]);
        Ok(())
    }
    fn slopes(&self, _t: f64, x: &[f64], _u: &[f64], p: &[f64], a: &mut [f64], _b: &mut [f64], dp: &mut [f64]) {
        a.copy_from_slice(&[0.0, 1.0, -2.0 * p[0] * x[0] * x[1] - 1.0, p[0] * (1.0 - x[0] * x[0])]);
        dp.copy_from_slice(&[0.0, (1.0 - x[0] * x[0]) * x[1]]);
    }
}

/// Falls at constant speed p; the mass matrix is singular from q = 1 on.
pub struct Wall;

impl Equations for Wall {
    const COORDINATES: usize = 1;
    fn rhs(&self, _t: f64, x: &[f64], _u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        if x[0] >= 1.0 {
            return Err(Singular { coordinate: 0 });
        }
        dx.copy_from_slice(&[p[0], 0.0]);
        Ok(())
    }
}

/// q'' = e^q: no solution beyond a finite time. From rest at q = 0 that time is pi / sqrt 2.
pub struct Explosion;

impl Equations for Explosion {
    const COORDINATES: usize = 1;
    fn rhs(&self, _t: f64, x: &[f64], _u: &[f64], _p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        dx.copy_from_slice(&[x[1], x[0].exp()]);
        Ok(())
    }
}

/// q'' = p^2 q: grows beyond all numbers.
pub struct Growth;

impl Equations for Growth {
    const COORDINATES: usize = 1;
    fn rhs(&self, _t: f64, x: &[f64], _u: &[f64], p: &[f64], dx: &mut [f64]) -> Result<(), Singular> {
        dx.copy_from_slice(&[x[1], p[0] * p[0] * x[0]]);
        Ok(())
    }
}
