//! Motion with sharp friction: Runge-Kutta of fourth order between events, at which joints stick, slip and turn.

use super::plant::Plant;
use super::{MOST, Row};

/// Where a rig is.
#[derive(Clone, Debug, Default)]
pub struct State {
    /// Coordinates.
    pub q: Row,
    /// Rates.
    pub v: Row,
    /// Bent bristles.
    pub z: Row,
}

/// How a joint moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Mode {
    /// Nothing can hold it.
    #[default]
    Smooth,
    /// Held.
    Stuck,
    /// Slips in this direction.
    Slips(f64),
}

/// A rig in motion.
#[derive(Clone, Debug)]
pub struct Motion<'a> {
    plant: &'a Plant,
    n: usize,
    modes: [Mode; MOST],
    /// Where it is.
    pub state: State,
}

/// Most events within one step.
const EVENTS: usize = 12;
/// Halvings with which an event is found.
const HALVINGS: usize = 24;

impl<'a> Motion<'a> {
    /// At rest in `q`.
    #[must_use]
    pub fn new(plant: &'a Plant, q: Row) -> Self {
        let n = plant.mechanics.coordinates();
        let mut modes = [Mode::Smooth; MOST];
        for (mode, joint) in modes.iter_mut().zip(&plant.joints).take(n) {
            if joint.is_dry() {
                *mode = Mode::Stuck;
            }
        }
        Self { plant, n, modes, state: State { q, ..State::default() } }
    }

    /// Moves on by `h` under forces that stay.
    pub fn advance(&mut self, h: f64, u: &Row, pushed: &Row) {
        self.release(u, pushed);
        let mut left = h;
        for _ in 0..EVENTS {
            let next = self.step(left, u, pushed);
            if !self.turned(&next).any(|t| t) {
                self.state = next;
                left = 0.0;
                break;
            }
            // the first of the turns
            let (mut before, mut after) = (0.0, left);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (before + after);
                if self.turned(&self.step(middle, u, pushed)).any(|t| t) { after = middle } else { before = middle }
            }
            let next = self.step(after, u, pushed);
            let turned: Vec<bool> = self.turned(&next).collect();
            self.state = next;
            for (i, _) in turned.iter().enumerate().filter(|(_, t)| **t) {
                self.state.v[i] = 0.0;
                self.modes[i] = Mode::Stuck;
            }
            self.release(u, pushed);
            left -= after;
            if left <= 0.0 {
                break;
            }
        }
        if left > 0.0 {
            self.state = self.step(left, u, pushed);
        }
    }

    /// Joints that would go against their own direction.
    fn turned(&self, next: &State) -> impl Iterator<Item = bool> {
        let v = next.v;
        let modes = self.modes;
        (0..self.n).map(move |i| matches!(modes[i], Mode::Slips(sign) if v[i] * sign < 0.0))
    }

    /// Lets go of joints that are pushed harder than friction holds, one by one.
    fn release(&mut self, u: &Row, pushed: &Row) {
        for _ in 0..self.n {
            let (a, f, m) = self.accelerations(&self.state, u, pushed);
            let over = (0..self.n)
                .filter(|&i| self.modes[i] == Mode::Stuck)
                .map(|i| {
                    let net = f[i] - (0..self.n).map(|j| m[i][j] * a[j]).sum::<f64>();
                    (i, net, net.abs() - self.plant.joints[i].dry(self.state.q[i], 0.0))
                })
                .filter(|(_, _, over)| *over > 0.0)
                .max_by(|x, y| x.2.total_cmp(&y.2));
            match over {
                Some((i, net, _)) => self.modes[i] = Mode::Slips(net.signum()),
                None => break,
            }
        }
    }

    /// Accelerations, and forces and mass matrix that gave them; held joints have none.
    fn accelerations(&self, x: &State, u: &Row, pushed: &Row) -> (Row, Row, [Row; MOST]) {
        let (m, mut f) = self.plant.forces(&x.q, &x.v, u);
        for i in 0..self.n {
            f[i] += pushed[i];
            if let Mode::Slips(sign) = self.modes[i] {
                f[i] -= sign * self.plant.joints[i].dry(x.q[i], x.v[i]);
            }
            if let Some(bristles) = &self.plant.joints[i].bristles {
                f[i] += bristles.force(x.v[i], x.z[i]).0;
            }
        }
        // Gauss without pivots: a mass matrix is positive definite; rows of held joints say a = 0
        let (mut left, mut right) = (m, f);
        for i in (0..self.n).filter(|&i| self.modes[i] == Mode::Stuck) {
            left[i] = std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 });
            right[i] = 0.0;
        }
        for k in 0..self.n {
            for i in k + 1..self.n {
                let factor = left[i][k] / left[k][k];
                for j in k..self.n {
                    left[i][j] -= factor * left[k][j];
                }
                right[i] -= factor * right[k];
            }
        }
        let mut a = [0.0; MOST];
        for k in (0..self.n).rev() {
            let known: f64 = (k + 1..self.n).map(|j| left[k][j] * a[j]).sum();
            a[k] = (right[k] - known) / left[k][k];
        }
        (a, f, m)
    }

    /// One step of fourth order; joints stay as they are.
    fn step(&self, h: f64, u: &Row, pushed: &Row) -> State {
        let slope = |x: &State| {
            let (a, ..) = self.accelerations(x, u, pushed);
            let mut z = [0.0; MOST];
            for (i, z) in z.iter_mut().enumerate().take(self.n) {
                if let Some(bristles) = &self.plant.joints[i].bristles {
                    *z = bristles.force(x.v[i], x.z[i]).1;
                }
            }
            State { q: x.v, v: a, z }
        };
        let moved = |d: &State, h: f64| {
            let of = |x: &Row, d: &Row| std::array::from_fn(|i| x[i] + h * d[i]);
            State { q: of(&self.state.q, &d.q), v: of(&self.state.v, &d.v), z: of(&self.state.z, &d.z) }
        };
        let k1 = slope(&self.state);
        let k2 = slope(&moved(&k1, 0.5 * h));
        let k3 = slope(&moved(&k2, 0.5 * h));
        let k4 = slope(&moved(&k3, h));
        let mean =
            |f: fn(&State) -> &Row| -> Row { std::array::from_fn(|i| (f(&k1)[i] + 2.0 * f(&k2)[i] + 2.0 * f(&k3)[i] + f(&k4)[i]) / 6.0) };
        moved(&State { q: mean(|s| &s.q), v: mean(|s| &s.v), z: mean(|s| &s.z) }, h)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::truth::mechanics::{Drive, Mechanics};

    fn block() -> Plant {
        let mut plant = Plant::new(Mechanics::Drive(Drive { m: 2.0, gain: 1.0 }));
        plant.joints[0].coulomb = 3.0;
        plant
    }

    #[test]
    fn a_block_stays_until_it_is_pushed_harder_than_friction() {
        let plant = block();
        let mut motion = Motion::new(&plant, [0.0; MOST]);
        motion.advance(0.1, &[2.9, 0.0, 0.0], &[0.0; MOST]);
        assert_eq!(motion.state.v[0], 0.0);
        motion.advance(0.1, &[5.0, 0.0, 0.0], &[0.0; MOST]);
        // (5 - 3) / 2 for 0.1 s
        assert!((motion.state.v[0] - 0.1).abs() < 1e-12);
    }

    #[test]
    fn a_sliding_block_stops_where_it_must_and_stays() {
        let plant = block();
        let mut motion = Motion::new(&plant, [0.0; MOST]);
        motion.advance(0.5, &[7.0, 0.0, 0.0], &[0.0; MOST]);
        let (v, q) = (motion.state.v[0], motion.state.q[0]);
        for _ in 0..40 {
            motion.advance(0.07, &[0.0; MOST], &[0.0; MOST]);
        }
        assert_eq!(motion.state.v[0], 0.0);
        // v^2 / (2 F / m)
        assert!((motion.state.q[0] - q - v * v / 3.0).abs() < 1e-6, "{}", motion.state.q[0]);
    }
}
