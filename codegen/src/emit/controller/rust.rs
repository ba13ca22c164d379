//! A controller as a `no_std` Rust module.

use super::kalman;
use super::{Column, Controller, Feedforward, Filter, Identifiers, Source, list, unit};
use crate::emit::about::wrapped;
use crate::emit::form::number;
use crate::emit::names::Language;
use crate::emit::rust::{WIDTH, rust_function_with};
use std::fmt::Write;

/// Rust source of a controller: one module that needs `core`, and the crate `runtime` where its feedforward has functions.
#[must_use]
pub fn controller_rust(c: &Controller) -> String {
    let names = c.identifiers(Language::Rust);
    let mut out = String::new();
    for line in wrapped(&c.header(), WIDTH - 4) {
        let _ = writeln!(out, "{}", format!("//! {line}").trim_end());
    }
    out.push_str("#![allow(non_snake_case, clippy::approx_constant, clippy::excessive_precision, clippy::let_and_return)]\n\n");
    let feedforward = feedforward(c, &mut out);
    constants(&mut out, c);
    if let Some(k) = &c.kalman {
        kalman::constants_rust(&mut out, c, k);
    }
    structs(&mut out, c, &names);
    out.push_str(&feedforward);
    filter(&mut out, c);
    step(&mut out, c, &names);
    out
}

fn feedforward(c: &Controller, out: &mut String) -> String {
    let signals: Vec<String> = c.signals.iter().map(|s| format!("{} [{}]", s.name, unit(&s.unit))).collect();
    match &c.feedforward {
        Feedforward::Constant(u, _) => {
            format!(
                "/// Inputs u* of the operating point: {}.\npub const FEEDFORWARD: [f64; {}] = [{}];\n\n",
                signals.join(", "),
                u.len(),
                list(u)
            )
        }
        Feedforward::Manifold(m, held) => {
            let (text, calls) = rust_function_with(&m.graph, "feedforward", &m.held, &m.parameters, &m.inputs);
            if !calls.is_empty() {
                let calls: Vec<&str> = calls.into_iter().collect();
                let list = if let [one] = calls[..] { one.to_owned() } else { format!("{{{}}}", calls.join(", ")) };
                let _ = writeln!(out, "use runtime::math::{list};\n");
            }
            let names: Vec<&str> = held.iter().map(|&i| c.channels[i].name.as_str()).collect();
            format!("/// Inputs u* that hold {}: {}.\n#[must_use]\n{text}\n", names.join(", "), signals.join(", "))
        }
    }
}

pub(super) fn matrix(out: &mut String, doc: &str, name: &str, rows: &[Vec<f64>], comments: &[String], public: bool) {
    let columns = rows.first().map_or(0, Vec::len);
    let _ = writeln!(out, "/// {doc}\n{}const {name}: [[f64; {columns}]; {}] = [", if public { "pub " } else { "" }, rows.len());
    for (row, comment) in rows.iter().zip(comments) {
        let _ = writeln!(out, "    [{}], // {comment}", list(row));
    }
    out.push_str("];\n\n");
}

fn constants(out: &mut String, c: &Controller) {
    let _ = writeln!(out, "/// Period [s].\npub const PERIOD: f64 = {};\n", number(c.period));
    matrix(out, "Gain K, one row an input.", "K", &c.k, &c.inputs, true);
    let signals: Vec<String> = c.signals.iter().map(|s| s.name.clone()).collect();
    matrix(out, &format!("How the rig's inputs move with ({}).", c.inputs.join(", ")), "DIRECTIONS", &c.directions, &signals, false);
    let limits: Vec<Vec<f64>> = c.signals.iter().map(|s| vec![s.limits.0, s.limits.1]).collect();
    let text = |x: f64| match x {
        f64::INFINITY => "f64::INFINITY".to_owned(),
        f64::NEG_INFINITY => "f64::NEG_INFINITY".to_owned(),
        x => number(x),
    };
    let _ = writeln!(out, "/// Limits of the rig's inputs.\npub const LIMITS: [(f64, f64); {}] = [", limits.len());
    for (row, name) in limits.iter().zip(&signals) {
        let _ = writeln!(out, "    ({}, {}), // {name}", text(row[0]), text(row[1]));
    }
    out.push_str("];\n\n");
    let integrals = c.integrals();
    if !integrals.is_empty() {
        let names: Vec<String> = integrals.iter().map(|&i| c.channels[i].name.clone()).collect();
        matrix(
            out,
            "Anti-windup: how the integrals follow what the limits take away, one row an integral.",
            "ANTI_WINDUP",
            &product(&c.anti_windup, &c.mixing),
            &names,
            false,
        );
    }
}

/// L (inputs of the gain) times their rows over the signals.
pub(super) fn product(left: &[Vec<f64>], right: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let columns = right.first().map_or(0, Vec::len);
    left.iter().map(|row| (0..columns).map(|j| row.iter().zip(right).map(|(l, r)| l * r[j]).sum()).collect()).collect()
}

fn structs(out: &mut String, c: &Controller, names: &Identifiers) {
    out.push_str("/// What is read, as the encoders show it.\n#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct Readings {\n");
    for (channel, name) in c.channels.iter().zip(&names.channels) {
        let _ = writeln!(out, "    /// {} [{}]\n    pub {name}: f64,", channel.name, unit(&channel.unit));
    }
    out.push_str("}\n\n");
    let given = c.given();
    if !given.is_empty() {
        out.push_str("/// A reference: where to, and how fast.\n#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct Target {\n    /// Value.\n    pub value: f64,\n    /// Rate.\n    pub rate: f64,\n}\n\n");
        out.push_str("/// References.\n#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct References {\n");
        for &i in &given {
            let _ = writeln!(out, "    /// {} [{}]\n    pub {}: Target,", c.channels[i].name, unit(&c.channels[i].unit), names.channels[i]);
        }
        out.push_str("}\n\n");
    }
}

fn filter_constant(out: &mut String, name: &str, doc: &str, f: &Filter) {
    let n = f.b.len();
    let rows: Vec<String> = f.a.iter().map(|row| format!("[{}]", list(row))).collect();
    let _ = writeln!(
        out,
        "/// {doc}\nconst {name}: Filter<{n}> = Filter {{\n    a: [{}],\n    b: [{}],\n    c: [{}],\n    d: {},\n    start: [{}],\n}};\n",
        rows.join(", "),
        list(&f.b),
        list(&f.c),
        number(f.d),
        list(&f.start)
    );
}

fn filter(out: &mut String, c: &Controller) {
    if c.has_filters() {
        out.push_str(
            "/// A sampled filter: output C x + D u, then x <- A x + B u. It starts in the steady state of its first input.\n\
         struct Filter<const N: usize> {\n    a: [[f64; N]; N],\n    b: [f64; N],\n    c: [f64; N],\n    d: f64,\n    start: [f64; N],\n}\n\n\
         impl<const N: usize> Filter<N> {\n    fn next(&self, state: &mut Option<[f64; N]>, input: f64) -> f64 {\n        \
         let x = state.unwrap_or(self.start.map(|s| s * input));\n        \
         let output = dot(&self.c, &x) + self.d * input;\n        \
         *state = Some(core::array::from_fn(|i| dot(&self.a[i], &x) + self.b[i] * input));\n        output\n    }\n}\n\n",
        );
    }
    out.push_str("fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {\n    a.iter().zip(b).map(|(a, b)| a * b).sum()\n}\n\n");
    if (0..c.channels.len()).any(|i| c.filters_rate(i)) {
        filter_constant(out, "RATE", "From an angle to its rate.", &c.filter);
    }
    for (i, source) in &c.references {
        if let Source::Inner { rate: Some(f), .. } = source {
            let name = &c.channels[*i].name;
            filter_constant(out, &format!("RATE_OF_REFERENCE_{i}"), &format!("From the reference of {name} to its rate."), f);
        }
    }
    if c.channels.iter().any(|channel| channel.wrapped) {
        out.push_str(
            "/// The angle nearest to the last one that an encoder shows as `angle`, modulo one turn.\n\
             fn unwrapped(last: Option<f64>, angle: f64) -> f64 {\n    let Some(last) = last else { return angle };\n    \
             let turns = (last - angle) / core::f64::consts::TAU;\n    \
             let whole = if turns < 0.0 { (turns - 0.5) as i64 } else { (turns + 0.5) as i64 };\n    \
             angle + core::f64::consts::TAU * whole as f64\n}\n\n",
        );
    }
}

fn step(out: &mut String, c: &Controller, names: &Identifiers) {
    let order = c.filter.b.len();
    let (integrals, given, m) = (c.integrals(), c.given(), c.signals.len());
    out.push_str("/// The controller, with what it remembers.\n#[derive(Clone, Debug, Default)]\npub struct Controller {\n");
    for (i, name) in names.channels.iter().enumerate() {
        if c.filters_rate(i) {
            let _ = writeln!(out, "    rate_{name}: Option<[f64; {order}]>,");
        }
        if c.channels[i].wrapped {
            let _ = writeln!(out, "    last_{name}: Option<f64>,");
        }
        if let Some(Source::Inner { rate: Some(f), .. }) = c.reference(i) {
            let _ = writeln!(out, "    rate_of_reference_{name}: Option<[f64; {}]>,", f.b.len());
        }
    }
    if !integrals.is_empty() {
        let _ = writeln!(out, "    integrals: [f64; {}],", integrals.len());
    }
    if let Some(k) = &c.kalman {
        let _ = writeln!(out, "    predicted: Option<[f64; {}]>,", k.states.len());
    }
    out.push_str("}\n\nimpl Controller {\n");
    let arguments = if given.is_empty() { "" } else { ", reference: &References" };
    let signals: Vec<String> = c.signals.iter().map(|s| format!("{} [{}]", s.name, unit(&s.unit))).collect();
    let _ = writeln!(
        out,
        "    /// One sample: the inputs {} to hold for a period.\n    #[must_use]\n    pub fn step(&mut self, reading: &Readings{arguments}) -> [f64; {m}] {{",
        signals.join(", ")
    );
    let mut reads = Vec::new();
    for (i, name) in names.channels.iter().enumerate() {
        if c.channels[i].wrapped {
            let _ = writeln!(
                out,
                "        let {name} = unwrapped(self.last_{name}, reading.{name});\n        self.last_{name} = Some({name});"
            );
            reads.push(name.clone());
        } else {
            reads.push(format!("reading.{name}"));
        }
    }
    if let Some(k) = &c.kalman {
        kalman::correct_rust(out, k, &reads);
    }
    out.push_str("        // values and rates\n");
    for (i, (name, read)) in names.channels.iter().zip(&reads).enumerate().filter(|(i, _)| c.is_used(*i)) {
        let zero = c.channels[i].zero;
        let zero = if zero == 0.0 { String::new() } else { format!(" - {}", number(zero)).replace("- -", "+ ") };
        let (value, rate) = c.estimated(i);
        let value = value.map_or_else(|| format!("{read}{zero}"), |k| format!("estimated[{k}]"));
        let rate = match rate {
            Some(k) => format!("estimated[{k}]"),
            None if c.needs_rate(i) => format!("RATE.next(&mut self.rate_{name}, {read})"),
            None => "0.0".to_owned(),
        };
        let _ = writeln!(out, "        let {name} = ({value}, {rate});");
    }
    out.push_str("        // where to\n");
    for i in c.ordered().into_iter().filter(|&i| c.needs_target(i)) {
        let name = &names.channels[i];
        match c.reference(i) {
            None => {
                let (value, rate) = c.channels[i].operating;
                let _ = writeln!(out, "        let to_{name} = ({}, {});", number(value), number(rate));
            }
            Some(Source::Given) => {
                let _ = writeln!(out, "        let to_{name} = (reference.{name}.value, reference.{name}.rate);");
            }
            Some(Source::Inner { outer, proportional, derivative, limit, rate }) => {
                let outer = &names.channels[*outer];
                let law = format!(
                    "{} * (to_{outer}.0 - {outer}.0) + {} * (to_{outer}.1 - {outer}.1)",
                    number(*proportional),
                    number(*derivative)
                );
                let limited = if limit.is_finite() { format!("({law}).max(-{0}).min({0})", number(*limit)) } else { law };
                let _ = writeln!(out, "        let to_{name} = {limited};");
                let slope = match rate {
                    Some(_) => format!("RATE_OF_REFERENCE_{i}.next(&mut self.rate_of_reference_{name}, to_{name})"),
                    None => "0.0".to_owned(),
                };
                let _ = writeln!(out, "        let to_{name} = (to_{name}, {slope});");
            }
        }
    }
    out.push_str("        // feedforward, feedback\n");
    match &c.feedforward {
        Feedforward::Constant(..) => out.push_str("        let hold = FEEDFORWARD;\n"),
        Feedforward::Manifold(_, held) => {
            let arguments: Vec<String> =
                held.iter().map(|&i| format!("{}{}.0", if c.reference(i).is_some() { "to_" } else { "" }, names.channels[i])).collect();
            let _ = writeln!(out, "        let hold = feedforward({});", arguments.join(", "));
        }
    }
    out.push_str("        let deviation = [\n");
    let mut integral = 0;
    for column in &c.columns {
        let entry = match *column {
            Column::Value(i) => format!("{0}.0 - to_{0}.0", names.channels[i]),
            Column::Rate(i) => format!("{0}.1 - to_{0}.1", names.channels[i]),
            Column::Integral(_) => {
                integral += 1;
                format!("self.integrals[{}]", integral - 1)
            }
            Column::State(k) => c.kalman.as_ref().map_or_else(String::new, |filter| kalman::deviation(filter, k)),
        };
        let _ = writeln!(out, "            {entry},");
    }
    out.push_str("        ];\n");
    out.push_str("        let feedback = K.map(|row| dot(&row, &deviation));\n");
    let _ = writeln!(out, "        let asked: [f64; {m}] = core::array::from_fn(|i| hold[i] - dot(&DIRECTIONS[i], &feedback));");
    let _ = writeln!(out, "        let u: [f64; {m}] = core::array::from_fn(|i| asked[i].max(LIMITS[i].0).min(LIMITS[i].1));");
    if !integrals.is_empty() {
        let _ = writeln!(out, "        // integrals, which follow what the limits take away");
        let _ = writeln!(out, "        let cut: [f64; {m}] = core::array::from_fn(|i| u[i] - asked[i]);");
        for (k, &i) in integrals.iter().enumerate() {
            let name = &names.channels[i];
            let _ = writeln!(out, "        self.integrals[{k}] += PERIOD * ({name}.0 - to_{name}.0 + dot(&ANTI_WINDUP[{k}], &cut));");
        }
    }
    if c.kalman.is_some() {
        out.push_str(kalman::PREDICT_RUST);
    }
    out.push_str("        u\n    }\n}\n");
}
