//! States and signals from `name=value`.

use crate::failure::Failure;
use crate::load::{assignment, unknown};
use codegen::{Direction, Layout, direction_by_name};
use model_dsl::rig::Rig;
use model_dsl::units::Unit;

/// Values of `--at`: which quantity, how the model's vectors move with it, its value (SI).
pub struct Given {
    /// In the order given.
    pub entries: Vec<(Direction, f64)>,
}

impl Given {
    /// Reads `--at` assignments.
    pub fn read(rig: &Rig, layout: &Layout, texts: &[String]) -> Result<Self, Failure> {
        let mut entries: Vec<(Direction, f64)> = Vec::new();
        for text in texts {
            let (name, value) = assignment(text)?;
            let Some(direction) = direction_by_name(rig, layout, name) else {
                let mixed = rig.mixes.iter().flat_map(|m| &m.names);
                let names: Vec<&str> = layout.x().chain(&layout.u).map(|v| v.name.as_str()).chain(mixed.map(String::as_str)).collect();
                return Err(unknown("coordinate, rate, actuator state or input", name, &names));
            };
            let unit = unit_of(rig, layout, &direction);
            let value = model_dsl::parse_value(value, &unit).map_err(|e| Failure::new("C0102", format!("{text}: {e}")))?;
            let same_mix = |a: &str, b: &str| rig.mixes.iter().any(|m| m.names.iter().any(|n| n == a) && m.names.iter().any(|n| n == b));
            if let Some((before, _)) = entries.iter().find(|(d, _)| d.name == name || (d.overlaps(&direction) && !same_mix(&d.name, name)))
            {
                let message = if before.name == name {
                    format!("`{name}` is given twice")
                } else {
                    format!("`{name}` and `{}` set the same input", before.name)
                };
                return Err(Failure::new("C0105", message).with_help("leave one of them out"));
            }
            entries.push((direction, value));
        }
        Ok(Self { entries })
    }

    /// State and signals, zero where nothing was given.
    pub fn vectors(&self, layout: &Layout) -> (Vec<f64>, Vec<f64>) {
        let (mut x, mut u) = (vec![0.0; layout.states()], vec![0.0; layout.u.len()]);
        for (direction, value) in &self.entries {
            direction.add(*value, &mut x, &mut u);
        }
        (x, u)
    }
}

/// Unit in which a bare number for this quantity is understood.
pub fn unit_of(rig: &Rig, layout: &Layout, direction: &Direction) -> Unit {
    let n = layout.q.len();
    if let Some(&(i, _)) = direction.states.first() {
        if i < n {
            return rig.coordinates[i].unit.clone();
        }
        if i < 2 * n {
            return rig.coordinates[i - n].unit.per_second();
        }
        return rig.actuators.iter().filter(|a| a.lag.is_some()).nth(i - 2 * n).map_or_else(Unit::none, |a| a.unit.clone());
    }
    if let Some((mix, row)) = rig.mixes.iter().find_map(|m| m.names.iter().position(|x| *x == direction.name).map(|r| (m, r))) {
        return mix.units[row].clone();
    }
    match direction.signals.first() {
        Some(&(i, _)) if i < layout.inputs => rig.inputs[i].unit.clone(),
        Some(&(i, _)) => {
            let moved = rig.coordinates.iter().filter(|c| c.prescribed && c.trajectory.is_none()).nth(i - layout.inputs);
            moved.map_or_else(Unit::none, |c| c.unit.per_second().per_second())
        }
        None => Unit::none(),
    }
}
