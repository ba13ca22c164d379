//! The text of a first rig from a record: what its columns say, and placeholders for what they do not.
//!
//! Which column is what is guessed from units and names; every guess stands in the text with its reason, so that it can be
//! corrected there.

use crate::preflight::quantum;
use crate::record::{Column, Record};
use model_dsl::units::Dimension;
use std::f64::consts::TAU;
use std::fmt::{self, Write};

/// Why there is no text.
#[derive(Clone, Debug, PartialEq)]
pub enum StarterError {
    /// The name is none that a rig can have.
    Name {
        /// As given.
        name: String,
    },
    /// A column that was named as an input is not there.
    NoColumn {
        /// Its name.
        name: String,
        /// Columns that are there.
        found: Vec<String>,
    },
    /// No column is a coordinate.
    NoCoordinate {
        /// Columns and what they were taken for.
        taken: Vec<(String, &'static str)>,
    },
}

impl fmt::Display for StarterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name { name } => write!(f, "`{name}` is no name for a rig: letters, digits and `_`, a letter first, as in `Heli`"),
            Self::NoColumn { name, found } => write!(f, "the record has no column `{name}`; it has {}", found.join(", ")),
            Self::NoCoordinate { taken } => {
                let list: Vec<String> = taken.iter().map(|(n, what)| format!("`{n}` ({what})")).collect();
                write!(
                    f,
                    "no column looks like an angle or a position: {}; give units in the header, as in `theta [deg]` or `x [mm]`, or name the inputs with `--inputs`",
                    list.join(", ")
                )
            }
        }
    }
}

impl std::error::Error for StarterError {}

/// What a column is taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    Input,
    /// A position; true where it turns.
    Coordinate(bool),
    /// The rate of the coordinate with this index among the columns.
    Rate(usize),
    Other,
}

impl Role {
    fn word(self) -> &'static str {
        match self {
            Self::Input => "an input",
            Self::Coordinate(_) => "a coordinate",
            Self::Rate(_) => "a rate",
            Self::Other => "nothing that a rig has",
        }
    }
}

/// The text of a rig called `name` whose inputs, coordinates and outputs are the record's columns. `inputs` names the inputs;
/// empty: guessed.
///
/// # Errors
/// [`StarterError`], one variant a cause.
pub fn starter(name: &str, record: &Record, inputs: &[String]) -> Result<String, StarterError> {
    if identifier(name) != name || name.chars().all(|c| c == '_') {
        return Err(StarterError::Name { name: name.to_owned() });
    }
    let columns = &record.columns;
    let found = || columns.iter().map(|c| c.name.clone()).chain(record.declared.iter().map(|d| d.name.clone())).collect::<Vec<_>>();
    if let Some(name) = inputs.iter().find(|n| !found().contains(n)) {
        return Err(StarterError::NoColumn { name: name.clone(), found: found() });
    }
    let roles = roles(columns, inputs);
    let coordinates: Vec<(usize, bool)> =
        roles.iter().enumerate().filter_map(|(k, r)| if let Role::Coordinate(turns) = r { Some((k, *turns)) } else { None }).collect();
    if coordinates.is_empty() {
        return Err(StarterError::NoCoordinate { taken: columns.iter().zip(&roles).map(|(c, r)| (c.name.clone(), r.word())).collect() });
    }
    let mut text = format!(
        "/// {name}\n///\n/// Started from the columns of {}. Everything marked TODO is a placeholder.\nrig {name} {{\n",
        file_name(&record.source)
    );
    text.push_str("    // -- inputs: put the amplifier's or actuator's limits in, as in `in -10..10`\n");
    let mut driven: Vec<(String, String)> = Vec::new();
    for (c, _) in columns.iter().zip(&roles).filter(|(_, r)| **r == Role::Input) {
        let unit = unit_of(c, "1");
        let (lo, hi) = range(&c.values);
        let guess = if c.unit.is_none() { "; TODO its unit, the record states none" } else { "" };
        let _ = writeln!(text, "    input {}: {unit};    // {} .. {} in the record{guess}", identifier(&c.name), number(lo), number(hi));
        driven.push((identifier(&c.name), unit));
    }
    for d in record.declared.iter().filter(|d| inputs.is_empty() || inputs.contains(&d.name)) {
        let unit = d.unit.as_ref().map_or_else(|| "1".to_owned(), |u| u.text.clone());
        let _ = writeln!(text, "    input {}: {unit};    // declared in the description of the record", identifier(&d.name));
        driven.push((identifier(&d.name), unit));
    }
    if driven.is_empty() {
        text.push_str("    // TODO the record has no input: free motion, or one that was not logged\n");
    }
    text.push_str("\n    // -- coordinates; a range, as in `in -60deg..60deg`, is where the axis can go\n");
    for &(k, turns) in &coordinates {
        let c = &columns[k];
        let q = identifier(&c.name);
        let unit = if turns { "rad" } else { "m" };
        let guess = if c.unit.is_none() { "; TODO the record states no unit, radians were taken" } else { "" };
        let (lo, hi) = range(&c.values);
        let seen = if turns {
            format!("{:.1} .. {:.1} deg", lo.to_degrees(), hi.to_degrees())
        } else {
            format!("{} .. {} m", number(lo), number(hi))
        };
        let renamed = if q == c.name { String::new() } else { format!("; in the record `{}`: name it alike, or describe it", c.name) };
        let _ = writeln!(text, "    coord {q}: {unit};    // {seen} in the record{guess}{renamed}");
    }
    text.push_str(
        "\n    // -- TODO the mechanics. One inertia, spring and damper for each axis, so that the file can be used at once.\n    \
         // Better: frames and bodies instead of these equations, from which the coupling of the axes follows, as in\n    \
         //     frame arm = ground.rotate(z, theta);\n    \
         //     body rod on arm { mass m; at (l / 2, 0, 0); inertia diag(0, J, J); }\n    \
         //     gravity g;    torque motor on theta: K * V;\n",
    );
    for &(k, turns) in &coordinates {
        mechanics(&mut text, &identifier(&columns[k].name), turns, &driven);
    }
    text.push_str("\n    // -- outputs\n");
    for &(k, turns) in &coordinates {
        text.push_str(&output(&columns[k], turns));
    }
    for (k, c) in columns.iter().enumerate() {
        match roles[k] {
            Role::Rate(of) => {
                let turns = coordinates.iter().any(|&(k, turns)| k == of && turns);
                let unit = if turns { "rad/s" } else { "m/s" };
                let _ = writeln!(text, "    output {}: {unit} = {}.dot;", identifier(&c.name), identifier(&columns[of].name));
            }
            Role::Other => {
                let unit = c.unit.as_ref().map_or_else(String::new, |u| format!(" [{}]", u.text));
                let _ = writeln!(text, "    // not used: the column `{}`{unit}", c.name);
            }
            _ => {}
        }
    }
    let names: Vec<String> = coordinates.iter().map(|&(k, _)| identifier(&columns[k].name)).collect();
    let _ = writeln!(text, "\n    trim rest {{ zero {0}; solve {0}; }}    // inputs at zero; TODO the point to work at", names.join(", "));
    text.push_str("}\n");
    Ok(text)
}

fn mechanics(text: &mut String, q: &str, turns: bool, driven: &[(String, String)]) {
    let (inertia, force, per) = if turns { ("kg*m^2", "N*m", "rad") } else { ("kg", "N", "m") };
    let (letter, damping) = if turns { ("J", "N*m*s") } else { ("m", "N*s/m") };
    let _ =
        writeln!(text, "    param {letter}_{q}: {inertia} = {};    // TODO inertia that moves with it", if turns { "0.01" } else { "1" });
    let _ = writeln!(text, "    param c_{q}: {damping} = {};    // TODO viscous friction", if turns { "0.01" } else { "1" });
    let _ = writeln!(
        text,
        "    param k_{q}: {force}/{per} = {};    // TODO stiffness, as of gravity about rest",
        if turns { "0.1" } else { "1" }
    );
    let mut sum = String::new();
    for (u, unit) in driven {
        let gain = match unit.as_str() {
            "1" => force.to_owned(),
            u if u == force => "1".to_owned(),
            u if u.contains(['*', '/', '^']) => format!("{force}/({u})"),
            u => format!("{force}/{u}"),
        };
        let _ = writeln!(text, "    param K_{q}_{u}: {gain} = 1;    // TODO how {u} drives {q}; remove it where it does not");
        let plus = if sum.is_empty() { "" } else { "+ " };
        let _ = write!(sum, "{plus}K_{q}_{u} * {u} ");
    }
    let _ = writeln!(text, "    equation {letter}_{q} * {q}.ddot = {sum}- k_{q} * {q} - c_{q} * {q}.dot;");
}

fn output(c: &Column, turns: bool) -> String {
    let q = identifier(&c.name);
    let seen = quantum(&c.values);
    let counts = seen.map(|s| if turns { TAU / s } else { 1.0 / s }).map(f64::round).filter(|n| (1.0..1e9).contains(n));
    match (counts, seen) {
        (Some(counts), Some(step)) => {
            let step = if turns { format!("{:.4} deg", step.to_degrees()) } else { format!("{} m", number(step)) };
            let of = if turns { "a turn" } else { "a metre" };
            format!(
                "    encoder {q}: {counts:.0};    // counts {of}: steps of {step} in the record (an encoder's, or the file's last digit)\n"
            )
        }
        _ => {
            let unit = if turns { "rad" } else { "m" };
            format!("    output {q}: {unit} = {q};    // no steps of an encoder seen\n")
        }
    }
}

fn roles(columns: &[Column], inputs: &[String]) -> Vec<Role> {
    let kind = |c: &Column| -> Role {
        if inputs.contains(&c.name) {
            return Role::Input;
        }
        let Some(unit) = &c.unit else {
            return if inputs.is_empty() && sounds_like_input(&c.name) {
                Role::Input
            } else if sounds_like_rate(&c.name) {
                Role::Other
            } else {
                Role::Coordinate(true)
            };
        };
        let turns = matches!(unit.text.as_str(), "rad" | "mrad" | "deg" | "turn" | "rev");
        let d = unit.dimension;
        let volt = Dimension::POWER / model_dsl::parse_unit("A").map_or(Dimension::NONE, |u| u.dimension);
        let ampere = Dimension::POWER / volt;
        if turns {
            Role::Coordinate(true)
        } else if d == Dimension::LENGTH {
            Role::Coordinate(false)
        } else if inputs.is_empty() && ([Dimension::FORCE, Dimension::TORQUE, volt, ampere].contains(&d) || sounds_like_input(&c.name)) {
            Role::Input
        } else {
            Role::Other
        }
    };
    let mut roles: Vec<Role> = columns.iter().map(kind).collect();
    // a rate is one of a coordinate whose name it begins with
    for k in 0..columns.len() {
        if roles[k] != Role::Other {
            continue;
        }
        let dimension = |c: &Column| c.unit.as_ref().map(|u| u.dimension);
        let of = (0..columns.len())
            .filter(|&j| matches!(roles[j], Role::Coordinate(_)) && columns[k].name.starts_with(&columns[j].name))
            .find(|&j| match dimension(&columns[k]) {
                None => true,
                Some(d) => d == dimension(&columns[j]).unwrap_or(Dimension::NONE) / Dimension::TIME,
            });
        if let Some(j) = of {
            roles[k] = Role::Rate(j);
        }
    }
    roles
}

/// Names of actuators' commands as people write them.
fn sounds_like_input(name: &str) -> bool {
    let small = name.to_lowercase();
    let words = ["volt", "torque", "force", "thrust", "pwm", "input", "cmd", "command", "tau", "current", "motor"];
    let heads = ["u", "v", "f", "i"];
    words.iter().any(|w| small.starts_with(w))
        || heads.iter().any(|h| small.strip_prefix(h).is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit() || c == '_')))
        || name.starts_with("V_")
        || name.starts_with("f_")
        || name.starts_with("F_")
        || name.starts_with("u_")
}

fn sounds_like_rate(name: &str) -> bool {
    let small = name.to_lowercase();
    ["_dot", ".dot", "_rate", "_speed", "_vel", "_velocity"].iter().any(|end| small.ends_with(end))
        || small.starts_with("omega")
        || small.starts_with("vel")
}

/// A name of the rig language from that of a column.
fn identifier(name: &str) -> String {
    const WORDS: [&str; 10] = ["t", "pi", "in", "on", "rig", "use", "input", "output", "coord", "param"];
    let mut text: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if !text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        text.insert_str(0, "q_");
    }
    if WORDS.contains(&text.as_str()) {
        text.push('_');
    }
    text
}

fn unit_of(c: &Column, otherwise: &str) -> String {
    c.unit.as_ref().map_or_else(|| otherwise.to_owned(), |u| u.text.clone())
}

fn range(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &y| (lo.min(y), hi.max(y)))
}

fn file_name(source: &str) -> String {
    std::path::Path::new(source).file_name().map_or_else(|| source.to_owned(), |n| n.to_string_lossy().into_owned())
}

fn number(x: f64) -> String {
    let text = format!("{x:.4}");
    if x != 0.0 && x.abs() < 1e-3 { format!("{x:.3e}") } else { text.trim_end_matches('0').trim_end_matches('.').to_owned() }
}
