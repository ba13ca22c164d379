//! A controller as C99.

use super::kalman;
use super::rust::product;
use super::{Column, Controller, Feedforward, Filter, Identifiers, Source, list, unit};
use crate::emit::about::wrapped;
use crate::emit::c::c_function_with;
use crate::emit::form::number;
use crate::emit::names::{Language, identifier};
use std::fmt::Write;

/// C source of a controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ControllerC {
    /// Name of the header file.
    pub header_name: String,
    /// Header file.
    pub header: String,
    /// Name of the source file.
    pub source_name: String,
    /// Source file.
    pub source: String,
    /// What the names begin with.
    pub prefix: String,
}

/// Header and source of a controller; they need C99's library only.
#[must_use]
pub fn controller_c(c: &Controller) -> ControllerC {
    let names = c.identifiers(Language::C);
    let prefix = identifier(Language::C, &c.name);
    let mut about = String::from("/*\n");
    for line in wrapped(&c.header(), 117) {
        let _ = writeln!(about, "{}", format!(" * {}", line.replace("*/", "* /")).trim_end());
    }
    about.push_str(" */\n");
    let header = format!("{about}{}", header(c, &names, &prefix));
    let mut source = format!("{about}#include \"{prefix}.h\"\n\n#include <math.h>\n\n");
    constants(&mut source, c);
    if let Some(k) = &c.kalman {
        kalman::constants_c(&mut source, c, k);
    }
    feedforward(&mut source, c);
    filters(&mut source, c);
    step(&mut source, c, &names, &prefix);
    ControllerC { header_name: format!("{prefix}.h"), header, source_name: format!("{prefix}.c"), source, prefix }
}

fn header(c: &Controller, names: &Identifiers, prefix: &str) -> String {
    let guard = format!("{}_H", prefix.to_uppercase());
    let mut out =
        format!("#ifndef {guard}\n#define {guard}\n\n/* Period [s]. */\n#define {}_PERIOD {}\n\n", prefix.to_uppercase(), number(c.period));
    let _ = writeln!(out, "/* What is read, as the encoders show it. */\nstruct {prefix}_readings {{");
    for (channel, name) in c.channels.iter().zip(&names.channels) {
        let _ = writeln!(out, "    double {name}; /* [{}] */", unit(&channel.unit));
    }
    out.push_str("};\n\n");
    let given = c.given();
    if !given.is_empty() {
        let _ = writeln!(
            out,
            "/* A reference: where to, and how fast. */\nstruct {prefix}_target {{\n    double value;\n    double rate;\n}};\n"
        );
        let _ = writeln!(out, "struct {prefix}_references {{");
        for &i in &given {
            let _ = writeln!(out, "    struct {prefix}_target {}; /* [{}] */", names.channels[i], unit(&c.channels[i].unit));
        }
        out.push_str("};\n\n");
    }
    let _ = writeln!(out, "/* Inputs of the rig. */\nstruct {prefix}_inputs {{");
    for (signal, name) in c.signals.iter().zip(&names.signals) {
        let _ = writeln!(out, "    double {name}; /* [{}] */", unit(&signal.unit));
    }
    let _ = writeln!(out, "}};\n\n/* What the controller remembers. */\nstruct {prefix}_memory {{");
    let order = c.filter.b.len();
    for (i, name) in names.channels.iter().enumerate() {
        if c.filters_rate(i) {
            let _ = writeln!(out, "    double rate_{name}[{order}];");
        }
        if c.channels[i].wrapped {
            let _ = writeln!(out, "    double last_{name};");
        }
        if let Some(Source::Inner { rate: Some(f), .. }) = c.reference(i) {
            let _ = writeln!(out, "    double rate_of_reference_{name}[{}];", f.b.len());
        }
    }
    let integrals = c.integrals().len();
    if integrals > 0 {
        let _ = writeln!(out, "    double integrals[{integrals}];");
    }
    if let Some(k) = &c.kalman {
        let _ = writeln!(out, "    double predicted[{}];", k.states.len());
    }
    out.push_str("    int started;\n};\n\n");
    let reference = if given.is_empty() { String::new() } else { format!("\n    const struct {prefix}_references *reference,") };
    let _ = writeln!(out, "/* Forgets everything. */\nvoid {prefix}_start(struct {prefix}_memory *memory);\n");
    let _ = writeln!(
        out,
        "/* One sample: the inputs to hold for a period. */\nvoid {prefix}_step(\n    struct {prefix}_memory *memory,\n    const struct {prefix}_readings *reading,{reference}\n    struct {prefix}_inputs *inputs);\n\n#endif"
    );
    out
}

pub(super) fn matrix(out: &mut String, doc: &str, name: &str, rows: &[Vec<f64>], comments: &[String]) {
    let columns = rows.first().map_or(0, Vec::len);
    let _ = writeln!(out, "/* {doc} */\nstatic const double {name}[{}][{columns}] = {{", rows.len());
    for (row, comment) in rows.iter().zip(comments) {
        let _ = writeln!(out, "    {{{}}}, /* {} */", list(row), comment.replace("*/", "* /"));
    }
    out.push_str("};\n\n");
}

fn constants(out: &mut String, c: &Controller) {
    if !c.integrals().is_empty() {
        let _ = writeln!(out, "/* [s] */\nstatic const double PERIOD = {};\n", number(c.period));
    }
    matrix(out, "Gain K, one row an input.", "K", &c.k, &c.inputs);
    let signals: Vec<String> = c.signals.iter().map(|s| s.name.clone()).collect();
    matrix(out, &format!("How the rig's inputs move with ({}).", c.inputs.join(", ")), "DIRECTIONS", &c.directions, &signals);
    let text = |x: f64| match x {
        f64::INFINITY => "HUGE_VAL".to_owned(),
        f64::NEG_INFINITY => "-HUGE_VAL".to_owned(),
        x => number(x),
    };
    let _ = writeln!(out, "/* Limits of the rig's inputs. */\nstatic const double LIMITS[{}][2] = {{", c.signals.len());
    for s in &c.signals {
        let _ = writeln!(out, "    {{{}, {}}}, /* {} */", text(s.limits.0), text(s.limits.1), s.name);
    }
    out.push_str("};\n\n");
    let integrals = c.integrals();
    if !integrals.is_empty() {
        let names: Vec<String> = integrals.iter().map(|&i| c.channels[i].name.clone()).collect();
        matrix(
            out,
            "Anti-windup: how the integrals follow what the limits take away, one row an integral.",
            "ANTI_WINDUP",
            &product(&c.anti_windup, &c.mixing),
            &names,
        );
    }
}

fn feedforward(out: &mut String, c: &Controller) {
    match &c.feedforward {
        Feedforward::Constant(u, _) => {
            let _ =
                writeln!(out, "/* Inputs u* of the operating point. */\nstatic const double FEEDFORWARD[{}] = {{{}}};\n", u.len(), list(u));
        }
        Feedforward::Manifold(m, held) => {
            let names: Vec<&str> = held.iter().map(|&i| c.channels[i].name.as_str()).collect();
            let text = c_function_with(&m.graph, "feedforward", &m.held, &m.parameters, &m.inputs);
            let text =
                text.replace("void feedforward(", &format!("/* Inputs u* that hold {}. */\nstatic void feedforward(", names.join(", ")));
            let _ = writeln!(out, "{text}");
        }
    }
}

fn filter_constant(out: &mut String, name: &str, doc: &str, f: &Filter) {
    let n = f.b.len();
    let a: Vec<f64> = f.a.concat();
    let _ = writeln!(
        out,
        "/* {doc}: A row by row, B, C, D, state in steady state. */\nstatic const double {name}_A[{}] = {{{}}};\nstatic const double {name}_B[{n}] = {{{}}};\nstatic const double {name}_C[{n}] = {{{}}};\nstatic const double {name}_D = {};\nstatic const double {name}_START[{n}] = {{{}}};\n",
        a.len(),
        list(&a),
        list(&f.b),
        list(&f.c),
        number(f.d),
        list(&f.start)
    );
}

fn filters(out: &mut String, c: &Controller) {
    let mut longest = 0;
    if (0..c.channels.len()).any(|i| c.filters_rate(i)) {
        filter_constant(out, "RATE", "From an angle to its rate", &c.filter);
        longest = c.filter.b.len();
    }
    for (i, source) in &c.references {
        if let Source::Inner { rate: Some(f), .. } = source {
            filter_constant(out, &format!("RATE_OF_REFERENCE_{i}"), "From a reference to its rate", f);
            longest = longest.max(f.b.len());
        }
    }
    out.push_str(
        "static double dot(const double *a, const double *b, int n)\n{\n    double sum = 0.0;\n    for (int i = 0; i < n; i++) {\n        sum += a[i] * b[i];\n    }\n    return sum;\n}\n\n",
    );
    if c.has_filters() {
        let _ = writeln!(
            out,
            "/* Output C x + D u, then x <- A x + B u. */\n\
             static double filtered(const double *a, const double *b, const double *c, double d, int n, double *x, double u)\n{{\n    \
             const double output = dot(c, x, n) + d * u;\n    double next[{longest}];\n    \
             for (int i = 0; i < n; i++) {{\n        next[i] = dot(a + i * n, x, n) + b[i] * u;\n    }}\n    \
             for (int i = 0; i < n; i++) {{\n        x[i] = next[i];\n    }}\n    return output;\n}}\n\n\
             /* A filter starts in the steady state of its first input. */\n\
             static void settle(const double *start, int n, double *x, double u)\n{{\n    for (int i = 0; i < n; i++) {{\n        x[i] = start[i] * u;\n    }}\n}}\n"
        );
    }
    if c.channels.iter().any(|channel| channel.wrapped) {
        out.push_str(
            "/* The angle nearest to the last one that an encoder shows as `angle`, modulo one turn. */\n\
             static double unwrapped(double last, double angle)\n{\n    const double turn = 6.283185307179586;\n    \
             return angle + turn * round((last - angle) / turn);\n}\n\n",
        );
    }
}

fn step(out: &mut String, c: &Controller, names: &Identifiers, prefix: &str) {
    let order = c.filter.b.len();
    let (integrals, given) = (c.integrals(), c.given());
    let (m, k, n) = (c.signals.len(), c.inputs.len(), c.columns.len());
    let _ = writeln!(
        out,
        "void {prefix}_start(struct {prefix}_memory *memory)\n{{\n    static const struct {prefix}_memory nothing;\n    *memory = nothing;\n}}\n"
    );
    let reference = if given.is_empty() { String::new() } else { format!("\n    const struct {prefix}_references *reference,") };
    let _ = writeln!(
        out,
        "void {prefix}_step(\n    struct {prefix}_memory *memory,\n    const struct {prefix}_readings *reading,{reference}\n    struct {prefix}_inputs *inputs)\n{{"
    );
    let mut reads = Vec::new();
    for (i, name) in names.channels.iter().enumerate() {
        if c.channels[i].wrapped {
            let _ = writeln!(
                out,
                "    const double turned_{name} = memory->started ? unwrapped(memory->last_{name}, reading->{name}) : reading->{name};\n    memory->last_{name} = turned_{name};"
            );
            reads.push(format!("turned_{name}"));
        } else {
            reads.push(format!("reading->{name}"));
        }
    }
    if let Some(k) = &c.kalman {
        kalman::correct_c(out, k, &reads);
    }
    out.push_str("    /* values and rates */\n");
    for (i, (name, read)) in names.channels.iter().zip(&reads).enumerate().filter(|(i, _)| c.is_used(*i)) {
        let zero = c.channels[i].zero;
        let zero = if zero == 0.0 { String::new() } else { format!(" - {}", number(zero)).replace("- -", "+ ") };
        let (value, rate) = c.estimated(i);
        let value = value.map_or_else(|| format!("{read}{zero}"), |k| format!("estimated[{k}]"));
        let _ = writeln!(out, "    const double {name} = {value};");
        if !c.needs_rate(i) {
            continue;
        }
        let _ = match rate {
            Some(k) => writeln!(out, "    const double {name}_rate = estimated[{k}];"),
            None => writeln!(
                out,
                "    if (!memory->started) {{\n        settle(RATE_START, {order}, memory->rate_{name}, {read});\n    }}\n    const double {name}_rate = filtered(RATE_A, RATE_B, RATE_C, RATE_D, {order}, memory->rate_{name}, {read});"
            ),
        };
    }
    out.push_str("    /* where to */\n");
    for i in c.ordered().into_iter().filter(|&i| c.needs_target(i)) {
        let name = &names.channels[i];
        match c.reference(i) {
            None => {
                let (value, rate) = c.channels[i].operating;
                let _ = writeln!(out, "    const double to_{name} = {};", number(value));
                if c.needs_rate(i) {
                    let _ = writeln!(out, "    const double to_{name}_rate = {};", number(rate));
                }
            }
            Some(Source::Given) => {
                let _ = writeln!(out, "    const double to_{name} = reference->{name}.value;");
                if c.needs_rate(i) {
                    let _ = writeln!(out, "    const double to_{name}_rate = reference->{name}.rate;");
                }
            }
            Some(Source::Inner { outer, proportional, derivative, limit, rate }) => {
                let outer = &names.channels[*outer];
                let law = format!(
                    "{} * (to_{outer} - {outer}) + {} * (to_{outer}_rate - {outer}_rate)",
                    number(*proportional),
                    number(*derivative)
                );
                let limited = if limit.is_finite() { format!("fmin(fmax({law}, -{0}), {0})", number(*limit)) } else { law };
                let _ = writeln!(out, "    const double to_{name} = {limited};");
                match rate {
                    _ if !c.needs_rate(i) => {}
                    Some(f) => {
                        let order = f.b.len();
                        let r = format!("RATE_OF_REFERENCE_{i}");
                        let _ = writeln!(
                            out,
                            "    if (!memory->started) {{\n        settle({r}_START, {order}, memory->rate_of_reference_{name}, to_{name});\n    }}\n    const double to_{name}_rate = filtered({r}_A, {r}_B, {r}_C, {r}_D, {order}, memory->rate_of_reference_{name}, to_{name});"
                        );
                    }
                    None => {
                        let _ = writeln!(out, "    const double to_{name}_rate = 0.0;");
                    }
                }
            }
        }
    }
    out.push_str("    memory->started = 1;\n    /* feedforward, feedback */\n");
    let hold = match &c.feedforward {
        Feedforward::Constant(..) => "FEEDFORWARD",
        Feedforward::Manifold(_, held) => {
            let arguments: Vec<String> =
                held.iter().map(|&i| format!("{}{}", if c.reference(i).is_some() { "to_" } else { "" }, names.channels[i])).collect();
            let _ = writeln!(out, "    double hold[{m}];\n    feedforward({}, hold);", arguments.join(", "));
            "hold"
        }
    };
    let _ = writeln!(out, "    const double deviation[{n}] = {{");
    let mut integral = 0;
    for column in &c.columns {
        let entry = match *column {
            Column::Value(i) => format!("{0} - to_{0}", names.channels[i]),
            Column::Rate(i) => format!("{0}_rate - to_{0}_rate", names.channels[i]),
            Column::Integral(_) => {
                integral += 1;
                format!("memory->integrals[{}]", integral - 1)
            }
            Column::State(k) => c.kalman.as_ref().map_or_else(String::new, |filter| kalman::deviation(filter, k)),
        };
        let _ = writeln!(out, "        {entry},");
    }
    let _ = writeln!(
        out,
        "    }};\n    double feedback[{k}];\n    for (int i = 0; i < {k}; i++) {{\n        feedback[i] = dot(K[i], deviation, {n});\n    }}\n    double u[{m}];"
    );
    if !integrals.is_empty() {
        let _ = writeln!(out, "    double cut[{m}];");
    }
    let cut = if integrals.is_empty() { "" } else { "        cut[i] = u[i] - asked;\n" };
    let _ = writeln!(
        out,
        "    for (int i = 0; i < {m}; i++) {{\n        const double asked = {hold}[i] - dot(DIRECTIONS[i], feedback, {k});\n        u[i] = fmin(fmax(asked, LIMITS[i][0]), LIMITS[i][1]);\n{cut}    }}"
    );
    if !integrals.is_empty() {
        out.push_str("    /* integrals, which follow what the limits take away */\n");
        for (k, &i) in integrals.iter().enumerate() {
            let name = &names.channels[i];
            let _ = writeln!(out, "    memory->integrals[{k}] += PERIOD * ({name} - to_{name} + dot(ANTI_WINDUP[{k}], cut, {m}));");
        }
    }
    if let Some(filter) = &c.kalman {
        kalman::predict_c(out, filter, m);
    }
    for (i, name) in names.signals.iter().enumerate() {
        let _ = writeln!(out, "    inputs->{name} = u[{i}];");
    }
    out.push_str("}\n");
}
