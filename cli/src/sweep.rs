//! `--sweep name=a:b:n`: a series of operating points.

use crate::args::Point;
use crate::failure::Failure;
use crate::load::{self, Loaded};
use crate::point::Given;
use codegen::Direction;
use jit::InProcess;

/// A series of points along one quantity.
pub struct Sweep {
    /// What is swept.
    pub name: String,
    /// Its values (SI).
    pub values: Vec<f64>,
    /// How the model's vectors move with it.
    pub direction: Direction,
    /// The points.
    pub points: Vec<Point>,
}

impl Sweep {
    /// Reads `name=a:b:n`; the points are `base` with this value.
    pub fn read(text: &str, base: &Point, loaded: &Loaded, model: &InProcess) -> Result<Self, Failure> {
        let (name, texts) = values(text)?;
        let layout = &model.equations().layout;
        let mut sweep = Self {
            direction: Direction { name: name.clone(), states: Vec::new(), signals: Vec::new() },
            name,
            values: Vec::new(),
            points: Vec::new(),
        };
        for text in texts {
            if let Some((direction, value)) = Given::read(&loaded.rig, layout, std::slice::from_ref(&text))?.entries.into_iter().next() {
                sweep.values.push(value);
                sweep.direction = direction;
            }
            let mut at: Vec<String> =
                base.at.iter().filter(|t| t.split('=').next().map(str::trim) != Some(sweep.name.as_str())).cloned().collect();
            at.push(text);
            sweep.points.push(Point { at, trim: base.trim.clone() });
        }
        Ok(sweep)
    }
}

/// `name=a:b:n` to the name and n assignments.
fn values(text: &str) -> Result<(String, Vec<String>), Failure> {
    let wrong = || {
        Failure::new("C0106", format!("--sweep {text} is not of the form name=from:to:count"))
            .with_help("for example `--sweep theta=-10deg:10deg:5`")
    };
    let (name, range) = load::assignment(text)?;
    let parts: Vec<&str> = range.split(':').map(str::trim).collect();
    let [from, to, count] = parts[..] else { return Err(wrong()) };
    let count: usize = count.parse().ok().filter(|n| (1..=10_000).contains(n)).ok_or_else(wrong)?;
    let split = |s: &str| -> Option<(f64, String)> {
        let end = s
            .char_indices()
            .map(|(i, _)| i)
            .chain([s.len()])
            .rev()
            .find(|&i| s.get(..i).is_some_and(|head| head.trim().parse::<f64>().is_ok()))?;
        Some((s.get(..end)?.trim().parse().ok()?, s.get(end..)?.trim().to_owned()))
    };
    let ((a, unit_a), (b, unit_b)) = (split(from).ok_or_else(wrong)?, split(to).ok_or_else(wrong)?);
    if unit_a != unit_b {
        return Err(Failure::new("C0106", format!("--sweep {text}: both ends need the same unit"))
            .with_help("for example `--sweep theta=-10deg:10deg:5`"));
    }
    let step = |k: usize| if count == 1 { a } else { a + (b - a) * k as f64 / (count - 1) as f64 };
    Ok((name.to_owned(), (0..count).map(|k| format!("{name}={:?}{unit_a}", step(k))).collect()))
}
