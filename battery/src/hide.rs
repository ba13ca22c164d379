//! Hides an effect of the catalogue in a plant: from its id, place and sizes to what really acts.

use crate::rigs::Rig;
use crate::truth::Row;
use crate::truth::chance::Chance;
use crate::truth::mechanics::Mechanics;
use crate::truth::plant::{Compliance, Plant};
use serde::{Deserialize, Serialize};

/// What is hidden, in the words of the catalogue.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hidden {
    /// Effect.
    pub effect: String,
    /// Place.
    pub place: String,
    /// Size of each parameter of the effect (SI), in the catalogue's order.
    pub sizes: Vec<f64>,
    /// Size over the smallest one that shows.
    pub multiple: f64,
}

/// How the clean rig moved: from this the numbers of a shape are taken that the catalogue has on a grid.
#[derive(Clone, Copy, Debug)]
pub struct Moved {
    /// Root-mean-square rates.
    pub rate: Row,
    /// Ranges.
    pub range: [(f64, f64); 3],
    /// Largest command of each input.
    pub command: Row,
}

/// Effects with a sign.
const POSITIVE: [&str; 13] = [
    "backlash",
    "flexible_mode",
    "viscous",
    "coulomb",
    "stribeck",
    "quadratic_drag",
    "spring",
    "input_delay",
    "actuator_lag",
    "actuator_deadzone",
    "actuator_saturation",
    "sensor_delay",
    "hard_stop",
];

/// Sizes at `multiple` times those that just show, with random signs and phases.
#[must_use]
pub fn sizes(effect: &str, detectable: &[f64], multiple: f64, chance: &mut Chance) -> Vec<f64> {
    let sign = if POSITIVE.contains(&effect) { 1.0 } else { chance.sign() };
    let mut own: Vec<f64> = detectable.iter().map(|d| sign * multiple * d).collect();
    match effect {
        "periodic_torque" => {
            let (s, c) = (std::f64::consts::TAU * chance.uniform()).sin_cos();
            own = vec![multiple * detectable[0] * s, multiple * detectable.get(1).copied().unwrap_or(0.0) * c];
        }
        // one of two parameters is the effect, the other its zero
        "spring" | "asymmetric_friction" => own.iter_mut().skip(1).for_each(|v| *v = 0.0),
        "base_tilt" => {
            let least = detectable.iter().copied().fold(f64::INFINITY, f64::min);
            own.iter_mut().zip(detectable).for_each(|(v, d)| *v = if *d > least { 0.0 } else { *v });
        }
        _ => {}
    }
    own
}

/// Hides it. `None` where this battery cannot, or where the size is none of this world.
#[must_use]
pub fn hide(plant: &mut Plant, rig: Rig, hidden: &Hidden, moved: &Moved) -> Option<()> {
    let (coordinates, inputs) = rig.names();
    let joint = |name: &str| coordinates.iter().position(|c| *c == name);
    let pair = |place: &str| place.split_once("->").map(|(a, b)| (a.to_owned(), b.to_owned()));
    let size = *hidden.sizes.first()?;
    let second = hidden.sizes.get(1).copied().unwrap_or(0.0);
    if !size.is_finite() || !second.is_finite() {
        return None;
    }
    let place = hidden.place.as_str();
    let effect = hidden.effect.as_str();
    match effect {
        "periodic_torque" => {
            let (from, to) = pair(place).unwrap_or((place.to_owned(), place.to_owned()));
            plant.periodic.push((joint(&from)?, joint(&to)?, 1.0, size, second));
        }
        "velocity_product" => {
            let (of, to) = pair(place)?;
            let (a, b) = of.split_once(',')?;
            plant.products.push((joint(a)?, joint(b)?, joint(&to)?, size));
        }
        "input_coupling" => {
            let (from, to) = pair(place)?;
            plant.couplings.push((inputs.iter().position(|u| **u == from)?, joint(&to)?, size));
        }
        "sensor_misalignment" => {
            let (other, own) = pair(place)?;
            within(size, 0.5)?;
            plant.sensors[joint(&own)?].misaligned = Some((joint(&other)?, size));
        }
        "backlash" => {
            let i = joint(place)?;
            plant.sensors[i].play = within(size, 0.2 * (moved.range[i].1 - moved.range[i].0))?;
        }
        "gravity_offset" | "base_tilt" => lean(plant, effect, place, size)?,
        _ if effect.starts_with("sensor_") => {
            let i = joint(place)?;
            let span = moved.range[i].1 - moved.range[i].0;
            let sensor = &mut plant.sensors[i];
            match effect {
                "sensor_bias" => sensor.bias = within(size, span)?,
                "sensor_scale" => sensor.scale = within(size, 0.5)?,
                "sensor_delay" => sensor.delay = within(size, 0.2)?,
                "sensor_drift" => sensor.drift = size,
                _ => return None,
            }
        }
        _ => match inputs.iter().position(|u| *u == place) {
            Some(j) => command(plant, effect, j, &hidden.sizes, moved)?,
            None => in_joint(plant, effect, joint(place)?, (size, second), moved)?,
        },
    }
    Some(())
}

/// A size that can be.
fn within(size: f64, most: f64) -> Option<f64> {
    (size.abs() <= most).then_some(size)
}

fn command(plant: &mut Plant, effect: &str, j: usize, sizes: &[f64], moved: &Moved) -> Option<()> {
    let size = *sizes.first()?;
    let largest = moved.command[j];
    let path = &mut plant.paths[j];
    match effect {
        "input_delay" => path.delay = within(size, 0.2)?,
        "actuator_lag" => path.lag = within(size, 0.3)?,
        "actuator_bias" => path.bias = within(size, largest)?,
        "actuator_gain" => path.gain = within(size, 0.6)?,
        "gain_curvature" => path.curvature = within(size, 0.5 / largest)?,
        "actuator_drift" => path.drift = size,
        "actuator_deadzone" => path.dead_zone = within(size, 0.5 * largest)?,
        "actuator_saturation" => path.saturation = (within(size, 1.0)?, 0.72 * largest),
        "flexible_mode" => {
            let [_, frequency, damping] = *sizes else { return None };
            path.compliance = Some(Compliance { ratio: within(size, 3.0)?, frequency, damping });
        }
        "start_transient" => path.transient = (within(size, 1.0)?, 1.0),
        _ => return None,
    }
    Some(())
}

fn in_joint(plant: &mut Plant, effect: &str, i: usize, (size, second): (f64, f64), moved: &Moved) -> Option<()> {
    let (low, high) = moved.range[i];
    let joint = &mut plant.joints[i];
    match effect {
        "viscous" => joint.viscous += size,
        "coulomb" => joint.coulomb += size,
        "stribeck" => joint.stribeck = (size, 0.2 * moved.rate[i]),
        "asymmetric_friction" => joint.asymmetric = (size, second),
        "quadratic_drag" => joint.quadratic = size,
        "spring" => joint.spring = (size, second),
        "cubic_spring" => joint.cubic = size,
        "constant_torque" => joint.constant = size,
        "hard_stop" => joint.stops = Some([(low + 0.12 * (high - low), size), (high - 0.12 * (high - low), second)]),
        _ => return None,
    }
    Some(())
}

/// What moves gravity: by rig, as far as its equations have it.
fn lean(plant: &mut Plant, effect: &str, place: &str, size: f64) -> Option<()> {
    match (&mut plant.mechanics, effect, place) {
        (Mechanics::Pendulum(p), "gravity_offset", "bob.x") => p.dx = within(size, 0.5 * p.l)?,
        (Mechanics::CartPole(p), "gravity_offset", "rod.x") => p.dx = within(size, 0.5 * p.l)?,
        (Mechanics::Pendulum(p), "base_tilt", "ground") => p.tilt = within(size, 0.5)?,
        _ => return None,
    }
    Some(())
}

/// Effects that no entry of the catalogue is.
pub const OUTSIDE: [&str; 3] = ["torque_ripple", "position_friction", "lugre"];

/// Hides one of [`OUTSIDE`] in joint `i`, of the size of the smallest constant or Coulomb force that shows.
#[must_use]
pub fn hide_outside(plant: &mut Plant, what: &str, i: usize, force: f64, rate: f64) -> Option<()> {
    let joint = &mut plant.joints[i];
    match what {
        // eleven periods a turn
        "torque_ripple" => plant.periodic.push((i, i, 11.0, force, 0.0)),
        "position_friction" => {
            joint.coulomb += force;
            joint.by_position = (0.9, 3.0);
        }
        "lugre" => {
            // bends by a fiftieth of what it goes in a second
            let stiffness = force / (0.02 * rate);
            joint.bristles =
                Some(crate::truth::plant::Bristles { stiffness, damping: 0.0, coulomb: force, rest: 1.6 * force, speed: 0.1 * rate });
        }
        _ => return None,
    }
    Some(())
}
