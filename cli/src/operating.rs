//! Operating points: a named trim with the command line's values, solved, and put into words.

use crate::args::Point;
use crate::failure::Failure;
use crate::load::{Loaded, unknown};
use crate::output::{named, number, prime};
use crate::point::Given;
use codegen::{Direction, Layout, operating_points};
use control::{Trim, TrimError, TrimProblem, Unknown};
use jit::InProcess;
use runtime::Model;
use serde_json::{Value, json};
use std::fmt::Write;

/// An operating point, found or taken as given.
pub struct Found {
    /// Name of the trim that it comes from.
    pub name: Option<String>,
    /// What was found. Where nothing was solved, rank is that of no equations.
    pub trim: Trim,
    /// Nothing was solved: the point is as it was given.
    pub as_given: bool,
    /// Coordinates that no equation depends on.
    pub cyclic: Vec<usize>,
    /// For a coordinate that is left drifting: the steady rate at which it would not.
    pub steady: Vec<(usize, f64)>,
    /// Names of what was solved for.
    solved: Vec<String>,
    /// What was solved; no unknowns where the point was taken as given.
    pub problem: TrimProblem,
}

/// Finds the operating point of a rig.
pub fn find(loaded: &Loaded, model: &InProcess, point: &Point) -> Result<Found, Failure> {
    let layout = &model.equations().layout;
    let given = Given::read(&loaded.rig, layout, &point.at)?;
    let declared = operating_points(&loaded.rig, layout, loaded.lumps);
    let chosen = match &point.trim {
        Some(name) => match declared.iter().find(|t| t.name == *name) {
            Some(found) => Some(found),
            None => {
                let names: Vec<&str> = declared.iter().map(|t| t.name.as_str()).collect();
                return Err(if names.is_empty() {
                    Failure::new("C0103", format!("this rig has no trim `{name}`"))
                        .with_help("declare one: `trim NAME { zero ..; solve ..; }`")
                } else {
                    unknown("trim", name, &names)
                });
            }
        },
        None => declared.first(),
    };
    let (mut x, mut u) = given.vectors(layout);
    let held = chosen.map(|t| t.held.as_slice()).unwrap_or_default();
    for (direction, value) in held.iter().filter(|(d, _)| !given.entries.iter().any(|(g, _)| g.overlaps(d))) {
        direction.add(*value, &mut x, &mut u);
    }
    let p = &layout.nominal;
    let solved: &[Direction] = chosen.map(|t| t.solved.as_slice()).unwrap_or_default();
    let as_given = chosen.is_none() || solved.iter().any(|s| given.entries.iter().any(|(g, _)| g.overlaps(s)));
    let problem = if as_given {
        TrimProblem { x, u, unknowns: Vec::new(), zero: Vec::new() }
    } else {
        TrimProblem { x, u, unknowns: solved.iter().map(unknown_of).collect(), zero: chosen.map(|t| t.zero.clone()).unwrap_or_default() }
    };
    let name = chosen.map(|t| t.name.clone());
    let trim = control::solve(model, p, &problem).map_err(|e| failure(&e, name.as_deref(), layout))?;
    let cyclic = cyclic(model, layout, &trim)?;
    let steady = if as_given { Vec::new() } else { steady(model, layout, &problem, &trim, &cyclic) };
    let solved = if as_given { Vec::new() } else { solved.iter().map(|d| d.name.clone()).collect() };
    Ok(Found { name: if as_given { None } else { name }, trim, as_given, cyclic, steady, solved, problem })
}

fn unknown_of(direction: &Direction) -> Unknown {
    Unknown { name: direction.name.clone(), states: direction.states.clone(), signals: direction.signals.clone() }
}

fn failure(error: &TrimError, name: Option<&str>, layout: &Layout) -> Failure {
    let trim = name.map_or_else(|| "this point".to_owned(), |n| format!("the trim `{n}`"));
    match error {
        TrimError::Singular { coordinate } => singular(coordinate),
        TrimError::NoConvergence { residual, coordinate, rank, unknowns, free, iterations } => {
            let unit = layout.q.iter().find(|q| q.name == *coordinate).map_or("SI", |q| q.unit.as_str());
            let message = format!(
                "{trim} has no solution near its start: after {iterations} steps an acceleration of {} {unit}/s^2 remains in `{coordinate}`",
                number(*residual)
            );
            let stuck: Vec<&str> = free.iter().flatten().map(|(n, _)| n.as_str()).collect();
            let help = if stuck.is_empty() {
                "no value of the unknowns may exist for these numbers; give a start nearer to it, or hold something else with --at"
                    .to_owned()
            } else {
                format!(
                    "{} moves nothing there (rank {rank} of {unknowns}): solve for something that moves `{coordinate}`",
                    stuck.join(", ")
                )
            };
            Failure::new("C0303", message).with_help(&help)
        }
        TrimError::NotSquare { .. } | TrimError::Shape => Failure::new("C0302", format!("{trim}: {error}")),
        TrimError::NotFinite => Failure::new("C0304", format!("{trim}: a value stops being a number on the way"))
            .with_help("check parameters that divide, and roots and logarithms of the rig"),
    }
}

/// The mass matrix is singular at a state.
pub fn singular(coordinate: &str) -> Failure {
    Failure::new("C0301", format!("the mass matrix is singular at this state: `{coordinate}` moves no inertia here"))
        .with_help("choose another state with --at, or give what this joint carries an inertia")
}

/// Coordinates whose columns of A vanish: nothing depends on them at this point.
fn cyclic(model: &InProcess, layout: &Layout, trim: &Trim) -> Result<Vec<usize>, Failure> {
    let (states, signals) = (layout.states(), layout.u.len());
    let (mut dx, mut a, mut b) = (vec![0.0; states], vec![0.0; states * states], vec![0.0; states * signals]);
    model.linearize(0.0, &trim.x, &trim.u, &layout.nominal, &mut dx, &mut a, &mut b).map_err(|s| singular(&layout.q[s.coordinate].name))?;
    Ok((0..layout.q.len()).filter(|&j| (0..states).all(|i| a[i * states + j] == 0.0)).collect())
}

/// Steady rates: each drifting cyclic coordinate's rate joins the unknowns and its acceleration the equations.
fn steady(model: &InProcess, layout: &Layout, problem: &TrimProblem, trim: &Trim, cyclic: &[usize]) -> Vec<(usize, f64)> {
    let n = layout.q.len();
    let drifting: Vec<usize> = cyclic.iter().copied().filter(|&i| !problem.zero.contains(&i) && trim.drift[i].abs() > 1e-9).collect();
    if drifting.is_empty() || drifting.iter().any(|&i| problem.unknowns.iter().any(|u| u.states.iter().any(|&(k, _)| k == n + i))) {
        return Vec::new();
    }
    let mut extended = problem.clone();
    (extended.x, extended.u) = (trim.x.clone(), trim.u.clone());
    for &i in &drifting {
        extended.unknowns.push(Unknown::state(&layout.v[i].name, n + i));
        extended.zero.push(i);
    }
    match control::solve(model, &layout.nominal, &extended) {
        Ok(found) if found.rank == found.unknowns => drifting.into_iter().map(|i| (i, found.x[n + i])).collect(),
        _ => Vec::new(),
    }
}

impl Found {
    /// The point in words: values, residual, rank, what is free, what drifts, what exceeds its limits.
    pub fn words(&self, loaded: &Loaded, layout: &Layout) -> String {
        let n = layout.q.len();
        let (x, u) = (&self.trim.x, &self.trim.u);
        let mut parts: Vec<String> = Vec::new();
        for (i, q) in layout.q.iter().enumerate() {
            if self.cyclic.contains(&i) && x[i] == 0.0 {
                continue;
            }
            parts.push(format!("{} {}", q.name, value(x[i], &q.unit)));
        }
        for (i, v) in layout.v.iter().enumerate().filter(|(i, _)| x[n + i] != 0.0) {
            parts.push(format!("{} {}", prime(&v.name), value(x[n + i], &format!("{}/s", layout.q[i].unit))));
        }
        for (i, s) in layout.u.iter().enumerate() {
            parts.push(format!("{} {}", s.name, value(u[i], &s.unit)));
        }
        let title = self.name.as_ref().map_or_else(|| "point: ".to_owned(), |n| format!("trim {n}: "));
        let mut text = format!("{title}{}", parts.join(", "));
        if self.as_given {
            text.push_str("     as given, nothing solved");
        } else {
            let _ = write!(text, "     residual {}, rank {} of {}", short(self.trim.residual), self.trim.rank, self.trim.unknowns);
        }
        let cyclic: Vec<&str> = self.cyclic.iter().map(|&i| layout.q[i].name.as_str()).collect();
        if !cyclic.is_empty() {
            let _ = write!(
                text,
                ", {} free",
                if cyclic.len() == 1 { format!("{} is", cyclic[0]) } else { format!("{} are", cyclic.join(", ")) }
            );
        }
        text.push('\n');
        for direction in &self.trim.free {
            let list: Vec<String> = direction.iter().map(|(name, weight)| format!("{} {name}", number(*weight))).collect();
            let _ = writeln!(text, "free direction: {} (the equations do not decide it; the start was kept)", list.join(" + "));
        }
        // what is solved to rounding is no drift
        let scale = self.trim.drift.iter().fold(1.0_f64, |m, d| m.max(d.abs()));
        for (i, q) in layout.q.iter().enumerate() {
            if self.trim.drift[i].abs() > 1e-12 * scale {
                let _ = write!(text, "{}'' is {} {}/s^2 here", q.name, number(self.trim.drift[i]), q.unit);
                match self.steady.iter().find(|(k, _)| *k == i) {
                    Some((_, rate)) => {
                        let _ = write!(
                            text,
                            ": not an equilibrium; it vanishes in steady motion at {}' = {} {}/s",
                            q.name,
                            number(*rate),
                            q.unit
                        );
                    }
                    None => text.push_str(": not an equilibrium, the linear model carries it as a constant term"),
                }
                text.push('\n');
            }
        }
        for (input, value) in loaded.rig.inputs.iter().zip(u) {
            if let Some((lo, hi)) = input.limits.filter(|(lo, hi)| value < lo || value > hi) {
                let _ = writeln!(
                    text,
                    "{} = {} {} lies outside its limits {}..{}",
                    input.name,
                    number(*value),
                    input.unit.text,
                    number(lo),
                    number(hi)
                );
            }
        }
        text
    }

    /// States, signals and mixed inputs by name.
    fn named(&self, loaded: &Loaded, layout: &Layout) -> Value {
        let mut all = named(layout.x().chain(&layout.u).map(|v| v.name.as_str()), &[self.trim.x.as_slice(), &self.trim.u].concat());
        if let Value::Object(map) = &mut all {
            for mix in &loaded.rig.mixes {
                for (name, row) in mix.names.iter().zip(&mix.rows) {
                    let value: f64 = row.iter().zip(&mix.inputs).map(|(k, &i)| k * self.trim.u[i]).sum();
                    map.insert(name.clone(), json!(value));
                }
            }
        }
        all
    }

    /// Fields of the JSON documents: vectors in the order of `states`, `inputs` and `coordinates`.
    pub fn json(&self, loaded: &Loaded, layout: &Layout) -> Value {
        let n = layout.q.len();
        let mut free: Vec<Value> =
            self.trim.free.iter().map(|d| Value::Object(d.iter().map(|(name, w)| (name.clone(), json!(w))).collect())).collect();
        free.extend(
            self.cyclic
                .iter()
                .filter(|&&i| !self.trim.free.iter().flatten().any(|(name, _)| *name == layout.q[i].name))
                .map(|&i| json!({&layout.q[i].name: 1.0})),
        );
        json!({
            "trim": self.name,
            "state": self.trim.x,
            "input": self.trim.u,
            "drift": self.trim.drift,
            "named": self.named(loaded, layout),
            "solved": self.solved,
            "residual": self.trim.residual,
            "rank": self.trim.rank,
            "unknowns": self.trim.unknowns,
            "free": free,
            "steady": Value::Object(self.steady.iter().map(|(i, r)| (layout.x().nth(n + i).map_or_else(String::new, |v| v.name.clone()), json!(r))).collect()),
            "iterations": self.trim.iterations,
        })
    }
}

/// A value with its unit; angles in degrees.
fn value(x: f64, unit: &str) -> String {
    // rounding of a sine of pi is no value
    if x.abs() < 1e-12 {
        return "0".to_owned();
    }
    if unit == "rad" { format!("{} deg", number(x.to_degrees())) } else { format!("{} {unit}", number(x)) }
}

fn short(x: f64) -> String {
    if x == 0.0 { "0".to_owned() } else { format!("{x:.0e}") }
}
