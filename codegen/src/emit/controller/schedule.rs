//! A regulator as code, u = u* - K (x - x*) without memory; where it was designed at several points, interpolated
//! between them (gain scheduling).

use super::{Signal, list, unit};
use crate::emit::about::wrapped;
use crate::emit::form::number;
use crate::emit::names::{Language, identifier};
use crate::emit::rust::WIDTH;
use std::fmt::Write;

/// Regulators over a grid of operating points.
#[derive(Clone, Debug)]
pub struct Schedule {
    /// Name of the module and of the C prefix.
    pub name: String,
    /// One line about it.
    pub title: String,
    /// Rig file and first digits of the model's hash.
    pub source: (String, String),
    /// What is swept, and its unit; `None` where there is one point only.
    pub variable: Option<(String, String)>,
    /// Its values, increasing; one where nothing is swept.
    pub grid: Vec<f64>,
    /// Period [s] that the gain was designed for, if any.
    pub period: Option<f64>,
    /// Columns of K.
    pub states: Vec<String>,
    /// Rows of K.
    pub inputs: Vec<String>,
    /// What it commands.
    pub signals: Vec<Signal>,
    /// How the signals move with the inputs (signals x inputs).
    pub directions: Vec<Vec<f64>>,
    /// K at each point.
    pub k: Vec<Vec<Vec<f64>>>,
    /// x* of the states at each point.
    pub x: Vec<Vec<f64>>,
    /// u* of the signals at each point.
    pub u: Vec<Vec<f64>>,
}

impl Schedule {
    fn header(&self) -> Vec<String> {
        let (rig, hash) = &self.source;
        let when = self.period.map_or_else(|| "In continuous time".to_owned(), |period| format!("Every {period:?} s"));
        let mut lines = vec![
            format!("{}.", self.title.trim_end_matches('.')),
            format!("Generated from `{rig}` (model {hash}) by `rig lqr`; edit the rig or the weights, not this file."),
            String::new(),
            format!("{when}: u = u* - K (x - x*), limited; x = ({}), K in ({}).", self.states.join(", "), self.inputs.join(", ")),
        ];
        if let Some((variable, unit_text)) = &self.variable {
            lines.push(format!(
                "K, x* and u* were designed at {} values of {variable} [{}]; straight between them, constant beyond the ends.",
                self.grid.len(),
                unit(unit_text)
            ));
        }
        lines.push("Units are SI and radians.".to_owned());
        lines
    }

    fn signals(&self) -> String {
        self.signals.iter().map(|s| format!("{} [{}]", s.name, unit(&s.unit))).collect::<Vec<_>>().join(", ")
    }
}

/// The rows of a table, one line each, with a remark.
fn lines(rows: &[Vec<f64>], open: &str, close: &str, indent: &str, remarks: &[String], mark: (&str, &str)) -> String {
    let mut out = String::new();
    for (row, remark) in rows.iter().zip(remarks) {
        let said = if remark.is_empty() { String::new() } else { format!(" {} {remark}{}", mark.0, mark.1) };
        let _ = writeln!(out, "{indent}{open}{}{close},{said}", list(row));
    }
    out
}

fn limit(x: f64, infinite: &str) -> String {
    if x.is_finite() {
        number(x)
    } else if x > 0.0 {
        infinite.to_owned()
    } else {
        format!("-{infinite}")
    }
}

/// A `no_std` Rust module that needs `core` only.
#[must_use]
pub fn schedule_rust(s: &Schedule) -> String {
    let (points, n, m, signals) = (s.grid.len(), s.states.len(), s.inputs.len(), s.signals.len());
    let mut out = String::new();
    for line in wrapped(&s.header(), WIDTH - 4) {
        let _ = writeln!(out, "{}", format!("//! {line}").trim_end());
    }
    out.push_str("#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::suboptimal_flops)]\n\n");
    let at: Vec<String> =
        s.grid.iter().map(|g| s.variable.as_ref().map_or_else(String::new, |(v, _)| format!("{v} = {}", number(*g)))).collect();
    if s.variable.is_some() {
        let _ = writeln!(out, "/// Where the regulators were designed.\npub const GRID: [f64; {points}] = [{}];\n", list(&s.grid));
    }
    let _ = writeln!(out, "/// Gains, one row an input: {}.\npub const GAINS: [[[f64; {n}]; {m}]; {points}] = [", s.inputs.join(", "));
    for (k, remark) in s.k.iter().zip(&at) {
        let said = if remark.is_empty() { String::new() } else { format!(" // {remark}") };
        let _ = writeln!(out, "    [{said}\n{}    ],", lines(k, "[", "]", "        ", &s.inputs, ("//", "")));
    }
    out.push_str("];\n\n");
    let _ = writeln!(out, "/// States x* of the points: {}.\npub const STATES: [[f64; {n}]; {points}] = [", s.states.join(", "));
    out.push_str(&lines(&s.x, "[", "]", "    ", &at, ("//", "")));
    let _ = writeln!(out, "];\n\n/// Inputs u* of the points: {}.\npub const INPUTS: [[f64; {signals}]; {points}] = [", s.signals());
    out.push_str(&lines(&s.u, "[", "]", "    ", &at, ("//", "")));
    let _ =
        writeln!(out, "];\n\n/// How the rig's inputs move with ({}).\nconst DIRECTIONS: [[f64; {m}]; {signals}] = [", s.inputs.join(", "));
    let names: Vec<String> = s.signals.iter().map(|s| s.name.clone()).collect();
    out.push_str(&lines(&s.directions, "[", "]", "    ", &names, ("//", "")));
    let _ = writeln!(out, "];\n\n/// Limits of the rig's inputs.\npub const LIMITS: [(f64, f64); {signals}] = [");
    for signal in &s.signals {
        let _ = writeln!(
            out,
            "    ({}, {}), // {}",
            limit(signal.limits.0, "f64::INFINITY"),
            limit(signal.limits.1, "f64::INFINITY"),
            signal.name
        );
    }
    out.push_str("];\n\n");
    let (argument, given) = match &s.variable {
        Some((v, _)) => {
            let v = identifier(Language::Rust, v);
            (format!("{v}: f64, "), v)
        }
        None => (String::new(), String::new()),
    };
    if s.variable.is_some() {
        let _ = writeln!(
            out,
            "/// The point before a value, and how far it is to the next one (0..1).\n\
             fn place(value: f64) -> (usize, f64) {{\n    let mut k = 0;\n    while k + 2 < GRID.len() && value >= GRID[k + 1] {{\n        k += 1;\n    }}\n    \
             let share = (value - GRID[k]) / (GRID[k + 1] - GRID[k]);\n    (k, share.max(0.0).min(1.0))\n}}\n\n\
             fn between<const N: usize>(table: &[[f64; N]], (k, share): (usize, f64)) -> [f64; N] {{\n    \
             core::array::from_fn(|i| (1.0 - share) * table[k][i] + share * table[k + 1][i])\n}}\n"
        );
        let _ = writeln!(
            out,
            "/// Gain K at a value of {given}.\n#[must_use]\npub fn gain({given}: f64) -> [[f64; {n}]; {m}] {{\n    let (k, share) = place({given});\n    \
             core::array::from_fn(|i| core::array::from_fn(|j| (1.0 - share) * GAINS[k][i][j] + share * GAINS[k + 1][i][j]))\n}}\n\n\
             /// State x* at a value of {given}.\n#[must_use]\npub fn state({given}: f64) -> [f64; {n}] {{\n    between(&STATES, place({given}))\n}}\n\n\
             /// Inputs u* at a value of {given}.\n#[must_use]\npub fn inputs({given}: f64) -> [f64; {signals}] {{\n    between(&INPUTS, place({given}))\n}}\n"
        );
    } else {
        let _ = writeln!(
            out,
            "/// Gain K.\n#[must_use]\npub fn gain() -> [[f64; {n}]; {m}] {{\n    GAINS[0]\n}}\n\n\
             /// State x*.\n#[must_use]\npub fn state() -> [f64; {n}] {{\n    STATES[0]\n}}\n\n\
             /// Inputs u*.\n#[must_use]\npub fn inputs() -> [f64; {signals}] {{\n    INPUTS[0]\n}}\n"
        );
    }
    let _ = writeln!(
        out,
        "/// The inputs {} for a state x = ({}).\n#[must_use]\npub fn command({argument}x: &[f64; {n}]) -> [f64; {signals}] {{\n    \
         let (k, at, hold) = (gain({given}), state({given}), inputs({given}));\n    \
         let feedback = k.map(|row| row.iter().zip(x.iter().zip(&at)).map(|(k, (x, at))| k * (x - at)).sum::<f64>());\n    \
         core::array::from_fn(|i| {{\n        \
         let asked = hold[i] - DIRECTIONS[i].iter().zip(&feedback).map(|(d, v)| d * v).sum::<f64>();\n        \
         asked.max(LIMITS[i].0).min(LIMITS[i].1)\n    }})\n}}",
        s.signals(),
        s.states.join(", ")
    );
    out
}

/// Header and source in C99: (name of the header, header, name of the source, source).
#[must_use]
pub fn schedule_c(s: &Schedule) -> [(String, String); 2] {
    let (points, n, m, signals) = (s.grid.len(), s.states.len(), s.inputs.len(), s.signals.len());
    let prefix = identifier(Language::C, &s.name);
    let guard = format!("{}_H", prefix.to_uppercase());
    let mut about = String::from("/*\n");
    for line in wrapped(&s.header(), 117) {
        let _ = writeln!(about, "{}", format!(" * {}", line.replace("*/", "* /")).trim_end());
    }
    about.push_str(" */\n");
    let (argument, given) = match &s.variable {
        Some((v, _)) => {
            let v = identifier(Language::C, v);
            (format!("double {v}, "), v)
        }
        None => (String::new(), String::new()),
    };
    let alone = if given.is_empty() { String::new() } else { format!("double {given}, ") };
    let declare = [
        (
            format!("void {prefix}_gain({alone}double k[{m}][{n}])"),
            format!("Gain K; rows {}; columns {}.", s.inputs.join(", "), s.states.join(", ")),
        ),
        (format!("void {prefix}_state({alone}double x[{n}])"), format!("State x*: {}.", s.states.join(", "))),
        (format!("void {prefix}_inputs({alone}double u[{signals}])"), format!("Inputs u*: {}.", s.signals())),
        (
            format!("void {prefix}_command({argument}const double x[{n}], double u[{signals}])"),
            format!("The inputs {} for a state x.", s.signals()),
        ),
    ];
    let mut header = format!("{about}#ifndef {guard}\n#define {guard}\n");
    for (text, doc) in &declare {
        let _ = write!(header, "\n/* {doc} */\n{text};\n");
    }
    header.push_str("\n#endif\n");

    let at: Vec<String> =
        s.grid.iter().map(|g| s.variable.as_ref().map_or_else(String::new, |(v, _)| format!("{v} = {}", number(*g)))).collect();
    let star = ("/*", " */");
    let mut out = format!("{about}#include \"{prefix}.h\"\n\n#include <math.h>\n\n");
    if s.variable.is_some() {
        let _ = writeln!(out, "/* Where the regulators were designed. */\nstatic const double GRID[{points}] = {{{}}};\n", list(&s.grid));
    }
    let _ = writeln!(out, "static const double GAINS[{points}][{m}][{n}] = {{");
    for (k, remark) in s.k.iter().zip(&at) {
        let said = if remark.is_empty() { String::new() } else { format!(" /* {remark} */") };
        let _ = writeln!(out, "    {{{said}\n{}    }},", lines(k, "{", "}", "        ", &s.inputs, star));
    }
    let _ = writeln!(out, "}};\n\nstatic const double STATES[{points}][{n}] = {{");
    out.push_str(&lines(&s.x, "{", "}", "    ", &at, star));
    let _ = writeln!(out, "}};\n\nstatic const double INPUTS[{points}][{signals}] = {{");
    out.push_str(&lines(&s.u, "{", "}", "    ", &at, star));
    let names: Vec<String> = s.signals.iter().map(|s| s.name.clone()).collect();
    let _ = writeln!(
        out,
        "}};\n\n/* How the rig's inputs move with ({}). */\nstatic const double DIRECTIONS[{signals}][{m}] = {{",
        s.inputs.join(", ")
    );
    out.push_str(&lines(&s.directions, "{", "}", "    ", &names, star));
    let _ = writeln!(out, "}};\n\nstatic const double LIMITS[{signals}][2] = {{");
    for signal in &s.signals {
        let _ =
            writeln!(out, "    {{{}, {}}}, /* {} */", limit(signal.limits.0, "HUGE_VAL"), limit(signal.limits.1, "HUGE_VAL"), signal.name);
    }
    out.push_str("};\n\n");
    let call = if given.is_empty() { String::new() } else { format!("{given}, ") };
    if s.variable.is_some() {
        let _ = writeln!(
            out,
            "/* The point before a value, and how far it is to the next one (0..1). */\nstatic int place(double value, double *share)\n{{\n    int k = 0;\n    \
             while (k + 2 < {points} && value >= GRID[k + 1]) {{\n        k++;\n    }}\n    \
             *share = fmin(fmax((value - GRID[k]) / (GRID[k + 1] - GRID[k]), 0.0), 1.0);\n    return k;\n}}\n"
        );
        let body = |target: &str, table: &str| {
            format!(
                "{{\n    double share;\n    const int at = place({given}, &share);\n    const double *low = {table}[at];\n    const double *high = {table}[at + 1];\n    \
                 double *to = {target};\n"
            )
        };
        let run = |count: usize| {
            format!("    for (int i = 0; i < {count}; i++) {{\n        to[i] = (1.0 - share) * low[i] + share * high[i];\n    }}\n}}\n\n")
        };
        let _ = write!(
            out,
            "{}\n{{\n    double share;\n    const int at = place({given}, &share);\n    for (int i = 0; i < {m}; i++) {{\n        for (int j = 0; j < {n}; j++) {{\n            \
             k[i][j] = (1.0 - share) * GAINS[at][i][j] + share * GAINS[at + 1][i][j];\n        }}\n    }}\n}}\n\n",
            declare[0].0
        );
        let _ = write!(out, "{}\n{}{}", declare[1].0, body("x", "STATES"), run(n));
        let _ = write!(out, "{}\n{}{}", declare[2].0, body("u", "INPUTS"), run(signals));
    } else {
        let copy = |target: &str, table: &str, count: usize| {
            format!(
                "{{\n    const double *from = {table};\n    double *to = {target};\n    for (int i = 0; i < {count}; i++) {{\n        to[i] = from[i];\n    }}\n}}\n\n"
            )
        };
        let _ = write!(
            out,
            "{}\n{{\n    for (int i = 0; i < {m}; i++) {{\n        for (int j = 0; j < {n}; j++) {{\n            k[i][j] = GAINS[0][i][j];\n        }}\n    }}\n}}\n\n",
            declare[0].0
        );
        let _ = write!(out, "{}\n{}", declare[1].0, copy("x", "STATES[0]", n));
        let _ = write!(out, "{}\n{}", declare[2].0, copy("u", "INPUTS[0]", signals));
    }
    let _ = writeln!(
        out,
        "{}\n{{\n    double k[{m}][{n}], at[{n}], hold[{signals}];\n    {prefix}_gain({call}k);\n    {prefix}_state({call}at);\n    {prefix}_inputs({call}hold);\n    \
         for (int i = 0; i < {signals}; i++) {{\n        u[i] = hold[i];\n    }}\n    \
         for (int r = 0; r < {m}; r++) {{\n        double feedback = 0.0;\n        for (int j = 0; j < {n}; j++) {{\n            feedback += k[r][j] * (x[j] - at[j]);\n        }}\n        \
         for (int i = 0; i < {signals}; i++) {{\n            u[i] -= DIRECTIONS[i][r] * feedback;\n        }}\n    }}\n    \
         for (int i = 0; i < {signals}; i++) {{\n        u[i] = fmin(fmax(u[i], LIMITS[i][0]), LIMITS[i][1]);\n    }}\n}}",
        declare[3].0
    );
    [(format!("{prefix}.h"), header), (format!("{prefix}.c"), out)]
}
