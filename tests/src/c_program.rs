//! A C program that calls every function of an emitted model and prints what comes out, and its comparison with the graph.

use crate::c_compiler::{Compiled, compile_and_run};
use crate::close::relative;
use crate::random::Random;
use crate::states::Point;
use codegen::Equations;
use codegen::emit::{Shape, Vector, functions};
use std::fmt::Write;

/// As for the Rust: a few hundred operations, and a library of elementary functions that differs by an ulp.
const TOLERANCE: f64 = 1e-13;
const POINTS: usize = 12;

/// A program that prints the results of every function at every point, one number a line; a function that may
/// find the mass matrix singular prints its status first.
fn program(e: &Equations, prefix: &str, header: &str, points: &[Point]) -> String {
    let list = functions(e);
    let mut out = format!(
        "#include \"{header}\"\n#include <stdio.h>\n\nstatic void put(const double *values, int n)\n{{\n    \
         for (int i = 0; i < n; i++) {{\n        printf(\"%.17g\\n\", values[i]);\n    }}\n}}\n\n"
    );
    for (k, point) in points.iter().enumerate() {
        let numbers = |values: &[f64]| values.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>().join(", ");
        let given = point.arguments();
        let _ = writeln!(out, "static void point_{k}(void)\n{{");
        let z = if e.layout.z.is_empty() { String::new() } else { format!(", {{{}}}", numbers(given.z)) };
        let _ = writeln!(out, "    const struct {prefix}_state x = {{{{{}}}, {{{}}}{z}}};", numbers(given.q), numbers(given.v));
        for (name, letter, values) in [("accelerations", "a", given.a), ("inputs", "u", given.u), ("parameters", "p", given.p)] {
            if !values.is_empty() {
                let _ = writeln!(out, "    const struct {prefix}_{name} {letter} = {{{}}};", numbers(values));
            }
        }
        for function in &list {
            let mut arguments: Vec<String> = function
                .arguments
                .iter()
                .map(|v| match v {
                    Vector::Time => format!("{:?}", point.t),
                    v if v.is_part_of_state() => format!("&x.{}", v.letter()),
                    v => format!("&{}", v.letter()),
                })
                .collect();
            let _ = writeln!(out, "    {{");
            let mut puts = Vec::new();
            for (i, output) in function.outputs.iter().enumerate() {
                let n = output.roots.len();
                match output.shape {
                    Shape::Scalar => puts.push(format!("put(&r{i}, 1);")),
                    Shape::Array(_) => {
                        let _ = writeln!(out, "        double r{i}[{n}];");
                        arguments.push(format!("r{i}"));
                        puts.push(format!("put(r{i}, {n});"));
                    }
                    Shape::Matrix(r, c) | Shape::OverParameters(r, c) => {
                        let _ = writeln!(out, "        double r{i}[{r}][{c}];");
                        arguments.push(format!("r{i}"));
                        puts.push(format!("put(&r{i}[0][0], {n});"));
                    }
                    Shape::Named(vector) => {
                        let name = if vector == Vector::Outputs { "outputs" } else { "accelerations" };
                        let _ = writeln!(out, "        struct {prefix}_{name} r{i};");
                        arguments.push(format!("&r{i}"));
                        puts.push(format!("put((const double *)&r{i}, {n});"));
                    }
                }
            }
            let call = format!("{prefix}_{}({})", function.name, arguments.join(", "));
            let puts = puts.join(" ");
            let _ = if function.outputs.iter().any(|o| o.shape == Shape::Scalar) {
                writeln!(out, "        const double r0 = {call};\n        {puts}")
            } else if function.pivots.is_some() {
                writeln!(
                    out,
                    "        const int status = {call};\n        printf(\"%d\\n\", status);\n        if (status == 0) {{ {puts} }}"
                )
            } else {
                writeln!(out, "        {call};\n        {puts}")
            };
            let _ = writeln!(out, "    }}");
        }
        out.push_str("}\n\n");
    }
    out.push_str("int main(void)\n{\n");
    for k in 0..points.len() {
        let _ = writeln!(out, "    point_{k}();");
    }
    out.push_str("    return 0;\n}\n");
    out
}

/// Compiles the emitted C of a rig and compares every function with the graph at random points. `false` where there is no compiler.
///
/// # Panics
/// Where they differ: this is for tests.
#[must_use]
pub fn c_agrees_with_the_graph(name: &str, e: &Equations) -> bool {
    let c = codegen::emit::c(e, &format!("{name}.rig"));
    let prefix = c.prefix.clone();
    let mut random = Random::new(31);
    let points: Vec<Point> = (0..POINTS).map(|_| Point::random(e, &mut random)).collect();
    let main = program(e, &prefix, &c.header_name, &points);
    let files = [(c.header_name.as_str(), c.header.as_str()), (c.source_name.as_str(), c.source.as_str()), ("main.c", main.as_str())];
    let Compiled::Printed(printed) = compile_and_run(&format!("c_{name}"), &files) else { return false };
    let mut lines = printed.lines();
    let mut next = || lines.next().and_then(|l| l.parse::<f64>().ok()).unwrap_or(f64::NAN);
    for point in &points {
        for function in functions(e) {
            if let Some(pivots) = &function.pivots {
                let values = e.graph.evaluate(&pivots.iter().map(|p| p.1).collect::<Vec<_>>(), |s| point.value(e, s));
                let expected = pivots.iter().zip(values).find(|(_, d)| d.is_nan() || *d <= 0.0).map_or(0, |((i, _), _)| i + 1);
                assert_eq!(next(), expected as f64, "{name}: status of {}", function.name);
                if expected != 0 {
                    continue;
                }
            }
            for output in &function.outputs {
                let graph = e.graph.evaluate(&output.roots, |s| point.value(e, s));
                let result: Vec<f64> = graph.iter().map(|_| next()).collect();
                let difference = relative(&result, &graph, f64::MIN_POSITIVE);
                assert!(difference < TOLERANCE, "{name}: {} {}: {difference:.1e}\n{result:?}\n{graph:?}", function.name, output.name);
            }
        }
    }
    assert!(lines.next().is_none(), "{name}: the program printed more than the functions give");
    true
}
