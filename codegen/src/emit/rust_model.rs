//! The model trait over the named functions of an emitted module.

use super::form::{Form, Rank, number};
use super::functions::Vector;
use super::plan::plan;
use super::rust::{Fields, WIDTH, type_of, unit, write_list};
use crate::equations::Equations;
use crate::expr::Id;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Writes the unit struct of the rig, its names and its implementation of `runtime::Model`.
pub fn write(out: &mut String, e: &Equations, fields: &Fields, calls: &mut BTreeSet<&'static str>) {
    let l = &e.layout;
    let (m, np, ny) = (l.u.len(), l.p.len(), l.outputs.len());
    let model = &fields.model;
    for (name, doc, values) in [
        ("STATE_NAMES", "Names of the states.", l.x().map(|v| v.name.as_str()).collect::<Vec<_>>()),
        ("INPUT_NAMES", "Names of the signals.", l.u.iter().map(|v| v.name.as_str()).collect()),
        ("PARAMETER_NAMES", "Names of the parameters.", l.p.iter().map(|v| v.name.as_str()).collect()),
        ("PARAMETER_UNITS", "Units of the parameters.", l.p.iter().map(|v| unit(&v.unit)).collect()),
        ("OUTPUT_NAMES", "Names of the measured outputs.", l.outputs.iter().map(|v| v.name.as_str()).collect()),
        ("OUTPUT_UNITS", "Units of the measured outputs.", l.outputs.iter().map(|v| unit(&v.unit)).collect()),
    ] {
        let quoted: Vec<Form> = values.iter().map(|v| Form::atom(Rank::Named, format!("{v:?}"))).collect();
        let _ = writeln!(out, "/// {doc}");
        write_list(out, 0, &format!("pub const {name}: [&str; {}] = [", values.len()), &quoted, &[], "];");
    }
    let _ = write!(
        out,
        "\n/// The rig behind the model trait: slices in, slices out, over the functions above.\n\
         #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]\npub struct {model};\n\n\
         impl Names for {model} {{\n    fn rig(&self) -> &str {{\n        {:?}\n    }}\n",
        l.rig
    );
    for (function, list) in [
        ("state", "STATE_NAMES"),
        ("signal", "INPUT_NAMES"),
        ("parameter", "PARAMETER_NAMES"),
        ("output", "OUTPUT_NAMES"),
        ("parameter_unit", "PARAMETER_UNITS"),
        ("output_unit", "OUTPUT_UNITS"),
    ] {
        let _ =
            write!(out, "\n    fn {function}(&self, i: usize) -> &str {{\n        {list}.get(i).copied().unwrap_or_default()\n    }}\n");
    }
    let _ = write!(
        out,
        "}}\n\nimpl Model for {model} {{\n    fn dimensions(&self) -> Dimensions {{\n        \
         Dimensions {{ coordinates: {}, lags: {}, inputs: {}, exogenous: {}, parameters: {np}, outputs: {ny} }}\n    }}\n\n    \
         fn names(&self) -> &dyn Names {{\n        self\n    }}\n",
        l.q.len(),
        l.z.len(),
        l.inputs,
        m - l.inputs,
    );
    let nominal = if np > 0 { "runtime::write(p, 0, &Parameters::NOMINAL.to_array());" } else { "let _ = p;" };
    let _ = write!(out, "\n    fn nominal(&self, p: &mut [f64]) {{\n        {nominal}\n    }}\n");

    let list = super::functions::functions(e);
    let arguments = |name: &str| list.iter().find(|f| f.name == name).map_or(Vec::new(), |f| f.arguments.clone());
    let call = |name: &str| {
        let given: Vec<String> =
            arguments(name).iter().map(|v| if *v == Vector::Time { "t".to_owned() } else { format!("&{}", v.letter()) }).collect();
        format!("{name}({})", given.join(", "))
    };
    let unpack = |name: &str| {
        let mut text = String::new();
        for v in arguments(name) {
            if v != Vector::Time {
                let _ = writeln!(text, "        let {0} = {1}::from_array(runtime::array({0}));", v.letter(), type_of(v));
            }
        }
        text
    };
    // names of arguments that the trait hands over and this model does not need start with an underscore
    let head = |name: &str, wanted: &[(Vector, &str)]| {
        let has = arguments(name);
        let list: Vec<String> =
            wanted.iter().map(|(v, ty)| format!("{}{}: {ty}", if has.contains(v) { "" } else { "_" }, v.letter())).collect();
        list.join(", ")
    };
    let slice = "&[f64]";
    let all = [(Vector::Time, "f64"), (Vector::State, slice), (Vector::Inputs, slice), (Vector::Parameters, slice)];
    let measured = [(Vector::Time, "f64"), (Vector::State, slice), (Vector::Parameters, slice)];

    // x' = [v | a | z']
    let nq = l.q.len();
    let _ = write!(
        out,
        "\n    fn rhs(&self, {}, dx: &mut [f64]) -> Result<(), Singular> {{\n{}",
        head("forward_dynamics", &all),
        unpack("forward_dynamics")
    );
    let _ = writeln!(out, "        let a = {}?;", call("forward_dynamics"));
    let _ = writeln!(out, "        runtime::write(dx, 0, &x.v.to_array());\n        runtime::write(dx, {nq}, &a.to_array());");
    if !l.z.is_empty() {
        let _ = writeln!(out, "        runtime::write(dx, {}, &{});", 2 * nq, call("lag_rates"));
    }
    out.push_str("        Ok(())\n    }\n");

    let b = if m > 0 { "b" } else { "_b" };
    let _ = write!(
        out,
        "\n    fn linearize(&self, {}, dx: &mut [f64], a: &mut [f64], {b}: &mut [f64]) -> Result<(), Singular> {{\n{}",
        head("linearize", &all),
        unpack("linearize")
    );
    let _ = writeln!(
        out,
        "        let linear = {}?;\n        runtime::write(dx, 0, &linear.dx);\n        runtime::write_rows(a, &linear.a);",
        call("linearize")
    );
    if m > 0 {
        out.push_str("        runtime::write_rows(b, &linear.b);\n");
    }
    out.push_str("        Ok(())\n    }\n");

    if np > 0 {
        let _ = write!(
            out,
            "\n    fn parameter_jacobian(&self, {}, dfdp: &mut [f64]) -> Result<(), Singular> {{\n{}        runtime::write_rows(dfdp, &{}?);\n        Ok(())\n    }}\n",
            head("parameter_jacobian", &all),
            unpack("parameter_jacobian"),
            call("parameter_jacobian")
        );
    } else {
        out.push_str("\n    fn parameter_jacobian(&self, _t: f64, _x: &[f64], _u: &[f64], _p: &[f64], _dfdp: &mut [f64]) -> Result<(), Singular> {\n        Ok(())\n    }\n");
    }
    if !e.pivots.is_empty() {
        let _ = write!(
            out,
            "\n    fn pivots(&self, {}, d: &mut [f64]) -> bool {{\n{}        d.fill(f64::INFINITY);\n        let pivots = {};\n",
            head("pivots", &measured),
            unpack("pivots"),
            call("pivots")
        );
        for (k, i) in e.free.iter().enumerate() {
            let _ = writeln!(out, "        runtime::write(d, {i}, &[pivots[{k}]]);");
        }
        out.push_str("        true\n    }\n");
    }
    if ny > 0 {
        let _ = write!(
            out,
            "\n    fn outputs(&self, {}, y: &mut [f64]) {{\n{}        runtime::write(y, 0, &{}.to_array());\n    }}\n",
            head("outputs", &measured),
            unpack("outputs"),
            call("outputs")
        );
        let dhdp = if np > 0 { "dhdp" } else { "_dhdp" };
        let _ = write!(
            out,
            "\n    fn output_jacobian(&self, {}, c: &mut [f64], {dhdp}: &mut [f64]) {{\n{}        let slopes = {};\n        runtime::write_rows(c, &slopes{});\n",
            head("output_jacobian", &measured),
            unpack("output_jacobian"),
            call("output_jacobian"),
            // without parameters there is one result, and no record
            if np > 0 { ".by_x" } else { "" }
        );
        if np > 0 {
            out.push_str("        runtime::write_rows(dhdp, &slopes.by_p);\n");
        }
        out.push_str("    }\n");
    } else {
        out.push_str("\n    fn outputs(&self, _t: f64, _x: &[f64], _p: &[f64], _y: &mut [f64]) {}\n");
        out.push_str("\n    fn output_jacobian(&self, _t: f64, _x: &[f64], _p: &[f64], _c: &mut [f64], _dhdp: &mut [f64]) {}\n");
    }
    let inputs: Vec<PathEntry> = e
        .input_paths
        .iter()
        .map(|(limits, delay)| {
            let (lo, hi) = limits.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            PathEntry { fixed: vec![format!("limits: ({}, {})", bound(lo), bound(hi))], values: vec![("delay", *delay)] }
        })
        .collect();
    path(out, e, fields, calls, "input_path", "InputPath", &inputs, "limits: (f64::NEG_INFINITY, f64::INFINITY), delay: 0.0");
    let outputs: Vec<PathEntry> = e
        .output_paths
        .iter()
        .map(|path| PathEntry {
            fixed: vec![format!("quantum: {}", number(path.quantum)), format!("wrapped: {}", path.wrapped)],
            values: vec![("delay", path.delay), ("play", path.play)],
        })
        .collect();
    path(out, e, fields, calls, "output_path", "OutputPath", &outputs, "delay: 0.0, play: 0.0, quantum: 0.0, wrapped: false");
    out.push_str("}\n");
}

fn bound(x: f64) -> String {
    if x == f64::NEG_INFINITY {
        "f64::NEG_INFINITY".to_owned()
    } else if x == f64::INFINITY {
        "f64::INFINITY".to_owned()
    } else {
        number(x)
    }
}

/// One arm of a path function.
struct PathEntry {
    /// Fields that are known, as text.
    fixed: Vec<String>,
    /// Fields over parameters.
    values: Vec<(&'static str, Id)>,
}

/// One of the two path functions: a match over the entries.
#[allow(clippy::too_many_arguments)]
fn path(
    out: &mut String,
    e: &Equations,
    fields: &Fields,
    calls: &mut BTreeSet<&'static str>,
    name: &str,
    record: &str,
    paths: &[PathEntry],
    none: &str,
) {
    let reads = paths.iter().flat_map(|path| &path.values).any(|(_, value)| e.graph.number_of(*value).is_none());
    let p = if reads { "p" } else { "_p" };
    let i = if paths.is_empty() { "_i" } else { "i" };
    let _ = writeln!(out, "\n    fn {name}(&self, {i}: usize, {p}: &[f64]) -> {record} {{");
    if paths.is_empty() {
        let _ = writeln!(out, "        {record} {{ {none} }}\n    }}");
        return;
    }
    if reads {
        out.push_str("        let p = Parameters::from_array(runtime::array(p));\n");
    }
    out.push_str("        match i {\n");
    for (k, path) in paths.iter().enumerate() {
        let roots: Vec<Id> = path.values.iter().map(|(_, value)| *value).collect();
        let plan = plan(&e.graph, &fields.vocabulary(e), fields.within(), &roots);
        calls.extend(plan.calls.iter().copied());
        let values = path.values.iter().zip(&plan.results).map(|((key, _), form)| format!("{key}: {}", form.text()));
        let members: Vec<String> = path.fixed.iter().cloned().chain(values).collect();
        if plan.statements.is_empty() {
            write_literal(out, 12, &format!("{k} => {record}"), &members, ",");
        } else {
            let _ = writeln!(out, "            {k} => {{");
            for statement in &plan.statements {
                super::rust::write_statement(out, statement, 16);
            }
            write_literal(out, 16, record, &members, "");
            out.push_str("            }\n");
        }
    }
    let _ = writeln!(out, "            _ => {record} {{ {none} }},\n        }}\n    }}");
}

/// head { members }tail, on one line where it is short enough.
fn write_literal(out: &mut String, indent: usize, head: &str, members: &[String], tail: &str) {
    let line = format!("{:indent$}{head} {{ {} }}{tail}", "", members.join(", "));
    if line.chars().count() <= WIDTH {
        let _ = writeln!(out, "{line}");
        return;
    }
    let _ = writeln!(out, "{:indent$}{head} {{", "");
    for member in members {
        let _ = writeln!(out, "{:indent$}    {member},", "");
    }
    let _ = writeln!(out, "{:indent$}}}{tail}", "");
}
