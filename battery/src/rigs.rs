//! The six rigs: their texts as a user has them, and the plants behind, whose numbers differ from the texts' by the seed.

use crate::truth::chance::Chance;
use crate::truth::experiment::Loop;
use crate::truth::mechanics::{CartPole, DoublePendulum, Drive, Furuta, Helicopter, Mechanics, Pendulum};
use crate::truth::plant::Plant;
use crate::truth::{MOST, Row};
use std::f64::consts::TAU;

/// A rig of the battery.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rig {
    /// A bob on a rod with a motor.
    Pendulum,
    /// A hanging pole on a cart.
    CartPole,
    /// A rotary pendulum, hanging.
    Furuta,
    /// A helicopter on a stand.
    Helicopter,
    /// Two links with motors.
    DoublePendulum,
    /// A carriage on a screw.
    Drive,
}

/// A rig on a table.
#[derive(Clone, Debug)]
pub struct Bench {
    /// What it really is.
    pub plant: Plant,
    /// Where it hangs.
    pub start: Row,
    /// Sampling period [s].
    pub period: f64,
    /// Mean and reach of each command.
    pub command: [(f64, f64); MOST],
    /// Slowest and fastest command [Hz].
    pub band: (f64, f64),
    /// Torque that is large for each joint: pushes are shares of it.
    pub strong: Row,
    /// A regulator that holds it.
    pub regulator: Loop,
}

impl Rig {
    /// All.
    pub const ALL: [Self; 6] = [Self::Pendulum, Self::CartPole, Self::Furuta, Self::Helicopter, Self::DoublePendulum, Self::Drive];

    /// Its name on the command line and in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Pendulum => "pendulum",
            Self::CartPole => "cart_pole",
            Self::Furuta => "furuta",
            Self::Helicopter => "helicopter",
            Self::DoublePendulum => "double_pendulum",
            Self::Drive => "drive",
        }
    }

    /// Its name in its text.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Pendulum => "Pendulum",
            Self::CartPole => "CartPole",
            Self::Furuta => "Furuta",
            Self::Helicopter => "Helicopter",
            Self::DoublePendulum => "DoublePendulum",
            Self::Drive => "Drive",
        }
    }

    /// The user's text.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Pendulum => include_str!("../rigs/pendulum.rig"),
            Self::CartPole => include_str!("../rigs/cart_pole.rig"),
            Self::Furuta => include_str!("../rigs/furuta.rig"),
            Self::Helicopter => include_str!("../rigs/helicopter.rig"),
            Self::DoublePendulum => include_str!("../rigs/double_pendulum.rig"),
            Self::Drive => include_str!("../rigs/drive.rig"),
        }
    }

    /// Coordinates, inputs and (as the battery's rigs have them) outputs by name.
    #[must_use]
    pub fn names(self) -> (&'static [&'static str], &'static [&'static str]) {
        match self {
            Self::Pendulum => (&["theta"], &["tau"]),
            Self::CartPole => (&["x", "theta"], &["F"]),
            Self::Furuta => (&["theta", "alpha"], &["tau"]),
            Self::Helicopter => (&["psi", "eps", "theta"], &["f_1", "f_2"]),
            Self::DoublePendulum => (&["q1", "q2"], &["tau_1", "tau_2"]),
            Self::Drive => (&["q"], &["V"]),
        }
    }

    /// One of its kind: free numbers of the text are off by a few percent, friction by a fifth.
    #[must_use]
    pub fn bench(self, seed: u64) -> Bench {
        let mut chance = Chance::new(seed, "bench");
        let mut near = |value: f64, share: f64| value * (1.0 + share * chance.normal().clamp(-2.5, 2.5));
        let (few, fifth) = (0.04, 0.2);
        let turn = |counts: f64| TAU / counts;
        match self {
            Self::Pendulum => {
                let (l, j, b) = (near(0.25, few), near(0.002, few), near(0.006, fifth));
                let mut plant = Plant::new(Mechanics::Pendulum(Pendulum { m: 0.3, l, dx: 0.0, j, tilt: 0.0 }));
                plant.joints[0].viscous = b;
                bench(
                    plant,
                    &[turn(8192.0)],
                    0.01,
                    [(0.0, 0.45), (0.0, 0.0)],
                    (0.1, 1.6),
                    [0.7, 0.0, 0.0],
                    [(2.0, 0.15), (0.0, 0.0)],
                    [0, 0],
                    0.8,
                )
            }
            Self::CartPole => {
                let (m_c, l, j) = (near(0.9, few), near(0.3, few), near(0.008, few));
                let (b_x, b_t) = (near(3.0, fifth), near(0.004, fifth));
                let mut plant = Plant::new(Mechanics::CartPole(CartPole { m_c, m_p: 0.25, l, dx: 0.0, j }));
                (plant.joints[0].viscous, plant.joints[1].viscous) = (b_x, b_t);
                bench(
                    plant,
                    &[1.0 / 40_000.0, turn(4096.0)],
                    0.01,
                    [(0.0, 4.0), (0.0, 0.0)],
                    (0.2, 2.5),
                    [3.0, 0.7, 0.0],
                    [(30.0, 4.0), (0.0, 0.0)],
                    [0, 0],
                    0.25,
                )
            }
            Self::Furuta => {
                let (j_arm, l, j) = (near(3e-4, few), near(0.065, few), near(4e-5, few));
                let (b_t, b_a) = (near(4e-4, fifth), near(2e-5, fifth));
                let mut plant = Plant::new(Mechanics::Furuta(Furuta { j_arm, r: 0.085, m: 0.03, l, j }));
                (plant.joints[0].viscous, plant.joints[1].viscous) = (b_t, b_a);
                bench(
                    plant,
                    &[turn(8192.0), turn(8192.0)],
                    0.005,
                    [(0.0, 0.006), (0.0, 0.0)],
                    (0.3, 4.0),
                    [0.005, 0.02, 0.0],
                    [(0.02, 1e-3), (0.0, 0.0)],
                    [0, 0],
                    0.8,
                )
            }
            Self::Helicopter => {
                let a = [near(0.2634, few), near(1.6279, 0.02), near(25.6488, few)];
                let b = [near(0.531, 0.02), near(5.3292, few), near(0.531, few), 0.1157];
                let damping = [near(0.48, fifth), near(0.3, fifth), near(0.6, fifth)];
                let hover = 0.5 * a[1] / b[0];
                let mut plant = Plant::new(Mechanics::Helicopter(Helicopter { a, b }));
                for (joint, c) in plant.joints.iter_mut().zip(damping) {
                    joint.viscous = c;
                }
                // levelled by the elevation's error, pitch left to its pendulum
                bench(
                    plant,
                    &[turn(8192.0); 3],
                    0.02,
                    [(hover, 0.35), (hover, 0.35)],
                    (0.06, 1.2),
                    [0.5, 0.4, 5.0],
                    [(0.6, 0.8), (0.6, 0.8)],
                    [1, 1],
                    0.25,
                )
            }
            Self::DoublePendulum => {
                let (r, i) = ([near(0.25, few), near(0.18, few)], [near(0.05, few), near(0.026, few)]);
                let damping = [near(0.04, fifth), near(0.02, fifth)];
                let links = DoublePendulum { m: [0.56, 0.6], r, l: 0.3, i, rotor: 8e-5, n: 6.0 };
                let mut plant = Plant::new(Mechanics::DoublePendulum(links));
                (plant.joints[0].viscous, plant.joints[1].viscous) = (damping[0], damping[1]);
                bench(
                    plant,
                    &[turn(16384.0); 2],
                    0.01,
                    [(0.0, 1.2), (0.0, 0.5)],
                    (0.2, 2.0),
                    [4.0, 1.0, 0.0],
                    [(4.0, 0.4), (2.0, 0.15)],
                    [0, 1],
                    0.5,
                )
            }
            Self::Drive => {
                let (m, f_v, f_c) = (near(95.0, few), near(205.0, fifth), near(20.0, 0.1));
                let mut plant = Plant::new(Mechanics::Drive(Drive { m, gain: 35.15 }));
                plant.joints[0].viscous = f_v;
                plant.joints[0].coulomb = f_c;
                bench(
                    plant,
                    &[1.0 / 200_000.0],
                    0.01,
                    [(0.0, 2.5), (0.0, 0.0)],
                    (0.2, 2.5),
                    [40.0, 0.0, 0.0],
                    [(60.0, 10.0), (0.0, 0.0)],
                    [0, 0],
                    0.1,
                )
            }
        }
    }
}

#[allow(clippy::too_many_arguments)]
fn bench(
    mut plant: Plant,
    quanta: &[f64],
    period: f64,
    command: [(f64, f64); 2],
    band: (f64, f64),
    strong: Row,
    gain: [(f64, f64); 2],
    output: [usize; 2],
    reference: f64,
) -> Bench {
    for (sensor, quantum) in plant.sensors.iter_mut().zip(quanta) {
        sensor.quantum = *quantum;
        // wires carry a little more than the counts
        sensor.noise = 0.3 * quantum;
    }
    let regulator = Loop { output: [output[0], output[1], 0], gain: [gain[0], gain[1], (0.0, 0.0)], reference: [reference; MOST] };
    Bench { plant, start: [0.0; MOST], period, command: [command[0], command[1], (0.0, 0.0)], band, strong, regulator }
}
