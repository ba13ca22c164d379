//! C99: a header and a source file, structs and functions prefixed by the rig's name; no heap, no globals.
//! The same content as the Rust module, printed from the same plans.

use super::about::{Header, about, wrapped};
use super::form::{Form, number};
use super::functions::{Function, Shape, Vector, entries, functions, place};
use super::names::{CALLED_C, LETTERS, Language, Names, RESULTS_C, identifier, snake};
use super::plan::{Defines, Plan, Statement, plan};
use super::rust::{base_name, field_names, unit};
use super::split::{Import, Part, split};
use super::vocabulary::Vocabulary;
use crate::equations::{Equations, Variable};
use crate::expr::{Graph, Id, SymbolId};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Columns.
const WIDTH: usize = 140;

/// A model in C.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CSource {
    /// Name of the header, which the source includes: `googol_mrb.h`.
    pub header_name: String,
    /// What the names of structs and functions begin with: `googol_mrb`.
    pub prefix: String,
    /// Name of the source: `googol_mrb.c`.
    pub source_name: String,
    /// Text of the header.
    pub header: String,
    /// Text of the source.
    pub source: String,
}

/// C99 source of a model. `source` is the name of the rig's file, for the header.
///
/// The equations should have been derived with Jacobians; without them the functions that need them are left out.
#[must_use]
pub fn c(equations: &Equations, source: &str) -> CSource {
    let e = equations;
    let fields = Fields::new(e);
    let prefix = &fields.prefix;
    let guard = format!("{}_H", prefix.to_uppercase());
    let words: Vec<String> =
        Header::new(e, source).lines(WIDTH - 6).iter().map(|line| format!(" * {line}").trim_end().to_owned()).collect();
    let comment = format!("/*\n{}\n */\n", words.join("\n"));
    let mut header = format!("{comment}#ifndef {guard}\n#define {guard}\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n");
    structs(&mut header, e, &fields);
    let mut body = String::new();
    let mut calls = BTreeSet::new();
    if !e.layout.p.is_empty() {
        let _ = writeln!(header, "/* The values that the rig's file gives. */\nvoid {prefix}_nominal(struct {prefix}_parameters *p);\n");
        let _ = writeln!(body, "void {prefix}_nominal(struct {prefix}_parameters *p)\n{{");
        for (field, value) in fields.of(Vector::Parameters).iter().zip(&e.layout.nominal) {
            let _ = writeln!(body, "    p->{field} = {};", number(*value));
        }
        body.push_str("}\n\n");
    }
    for function in functions(e) {
        let prototype = prototype(&fields, &function);
        let doc = wrapped(&function.doc, WIDTH - 6);
        let lines = doc.iter().filter(|line| !line.starts_with("```"));
        let mut lines: Vec<String> = lines.map(|line| in_c(line)).collect();
        if function.pivots.is_some() {
            lines.push(String::new());
            lines.push("Returns 0, or 1 + the index of the coordinate at which the mass matrix is not positive definite;".to_owned());
            lines.push("then the results are not written.".to_owned());
        }
        match lines.as_slice() {
            [one] => {
                let _ = writeln!(header, "/* {one} */");
            }
            several => {
                header.push_str("/*\n");
                for line in several {
                    let _ = writeln!(header, "{}", format!(" * {line}").trim_end());
                }
                header.push_str(" */\n");
            }
        }
        let _ = writeln!(header, "{prototype};\n");
        write_function(&mut body, e, &fields, &function, &prototype, &mut calls);
    }
    header.push_str("#ifdef __cplusplus\n}\n#endif\n\n");
    let _ = writeln!(header, "#endif /* {guard} */");
    // the header is named after the rig's file, as the files themselves are
    let stem = source.rsplit(['/', '\\']).next().unwrap_or(source);
    let stem = stem.strip_suffix(".rig").unwrap_or(stem);
    let header_name = format!("{stem}.h");
    let mut text = format!("{comment}#include \"{header_name}\"\n\n#include <math.h>\n\n");
    if body.contains("NEVER_INLINE ") {
        text.push_str(
            "/* A compiler would inline a function that is called once, and undo the split of long functions. */\n\
             #if defined(__GNUC__)\n#define NEVER_INLINE __attribute__((noinline))\n#else\n#define NEVER_INLINE\n#endif\n\n",
        );
    }
    text.push_str(&helpers(&calls));
    text.push_str(body.trim_end());
    text.push('\n');
    CSource { source_name: format!("{stem}.c"), header_name, prefix: prefix.clone(), header, source: text }
}

/// A few expressions as one C function over named numbers: `void name(double a, double b, double y[N])`,
/// with the static functions that it calls before it.
#[must_use]
pub fn c_function(graph: &Graph, name: &str, arguments: &[SymbolId], results: &[Id]) -> String {
    c_function_with(graph, name, arguments, &[], results)
}

/// The same, with symbols that have values of their own.
pub(super) fn c_function_with(graph: &Graph, name: &str, arguments: &[SymbolId], constants: &[(SymbolId, f64)], results: &[Id]) -> String {
    let mut names = Names::new(Language::C, &[CALLED_C, &["y"]].concat());
    let symbols: Vec<SymbolId> = arguments.iter().copied().chain(constants.iter().map(|c| c.0)).collect();
    let given: Vec<String> = symbols.iter().map(|&s| names.take(&graph.symbol_info(s).name)).collect();
    let vocabulary = Vocabulary::new(Language::C, graph, |s, _| {
        let text = symbols.iter().position(|&a| a == s).map_or_else(|| "NAN".to_owned(), |i| given[i].clone());
        (text.clone(), text)
    });
    let plan = plan(graph, &vocabulary, names, results);
    let mut typed: Vec<String> = given.iter().take(arguments.len()).map(|a| format!("double {a}")).collect();
    typed.push(format!("double y[{}]", results.len()));
    let mut out = helpers(&plan.calls);
    let _ = writeln!(out, "void {}({})\n{{", identifier(Language::C, name), typed.join(", "));
    let read = plan.symbols();
    for (a, _) in given.iter().zip(arguments).filter(|(_, s)| !read.contains(s)) {
        let _ = writeln!(out, "    (void){a};");
    }
    for ((symbol, value), name) in constants.iter().zip(&given[arguments.len()..]).filter(|((s, _), _)| read.contains(s)) {
        let remark = super::rust::remark(graph, *symbol, name, "/*");
        let close = if remark.is_empty() { "" } else { " */" };
        let _ = writeln!(out, "    const double {name} = {};{remark}{close}", super::form::number(*value));
    }
    for statement in &plan.statements {
        write_statement(&mut out, statement);
    }
    for (i, value) in plan.results.iter().enumerate() {
        assign(&mut out, &format!("y[{i}] = "), value, "");
    }
    out.push_str("}\n");
    out
}

/// Functions that C99's library does not have, where they are called.
fn helpers(calls: &BTreeSet<&'static str>) -> String {
    let mut out = String::new();
    if calls.contains("sign") {
        out.push_str("/* -1, 0 or 1 */\nstatic double sign(double x)\n{\n    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;\n}\n\n");
    }
    if calls.contains("step") {
        out.push_str("/* 1 where x > 0, otherwise 0 */\nstatic double step(double x)\n{\n    return x > 0.0 ? 1.0 : 0.0;\n}\n\n");
    }
    if calls.contains("powi") {
        out.push_str(
            "/* a^n by repeated squaring */\nstatic double powi(double a, int n)\n{\n    unsigned left = n < 0 ? 0u - (unsigned)n : (unsigned)n;\n    \
             double square = a;\n    double result = 1.0;\n    while (left > 0u) {\n        if (left % 2u == 1u) {\n            result *= square;\n        }\n        \
             square *= square;\n        left /= 2u;\n    }\n    return n < 0 ? 1.0 / result : result;\n}\n\n",
        );
    }
    out
}

/// Names of structs and fields.
struct Fields {
    prefix: String,
    lists: Vec<(Vector, Vec<String>)>,
}

impl Fields {
    fn new(e: &Equations) -> Self {
        let all = [Vector::Coordinates, Vector::Rates, Vector::Accelerations, Vector::Lags, Vector::Inputs, Vector::Parameters];
        let mut lists: Vec<(Vector, Vec<String>)> =
            all.iter().map(|&v| (v, field_names(Language::C, v, entries(e, v).unwrap_or(&[])))).collect();
        let mut names = Names::new::<&str>(Language::C, &[]);
        lists.push((Vector::Outputs, e.layout.outputs.iter().map(|y| names.take(&y.name)).collect()));
        Self { prefix: identifier(Language::C, &snake(&e.layout.rig)), lists }
    }

    fn of(&self, vector: Vector) -> &[String] {
        self.lists.iter().find(|(v, _)| *v == vector).map_or(&[], |(_, names)| names)
    }

    fn vocabulary(&self, e: &Equations) -> Vocabulary {
        Vocabulary::new(Language::C, &e.graph, |s, kind| {
            let vector = Vector::of(kind);
            if vector == Vector::Time {
                return ("t".to_owned(), "t".to_owned());
            }
            let field = self.of(vector).get(place(&e.graph, s)).map_or("missing", String::as_str);
            (format!("{}->{field}", vector.letter()), base_name(vector, field))
        })
    }

    fn type_of(&self, vector: Vector) -> String {
        let word = TYPES.iter().find(|t| t.0 == vector).map_or("state", |t| t.1);
        format!("struct {}_{word}", self.prefix)
    }
}

const TYPES: [(Vector, &str, &str); 7] = [
    (Vector::Parameters, "parameters", "Parameters p."),
    (Vector::Coordinates, "coordinates", "Coordinates q."),
    (Vector::Rates, "rates", "Rates v = q'."),
    (Vector::Lags, "lags", "Actuator states z."),
    (Vector::Accelerations, "accelerations", "Accelerations a = q''."),
    (Vector::Inputs, "inputs", "Signals u: inputs, then accelerations of prescribed coordinates."),
    (Vector::Outputs, "outputs", "Measured outputs y."),
];

fn structs(out: &mut String, e: &Equations, fields: &Fields) {
    for (vector, _, doc) in TYPES {
        let names = fields.of(vector);
        if names.is_empty() {
            continue;
        }
        let docs: Vec<String> = match vector {
            Vector::Outputs => e.layout.outputs.iter().map(|y| format!("[{}]", unit(&y.unit))).collect(),
            _ => entries(e, vector).unwrap_or(&[]).iter().map(field_doc).collect(),
        };
        let _ = writeln!(out, "/* {doc} */\n{} {{", fields.type_of(vector));
        let width = names.iter().map(|n| n.len()).max().unwrap_or(0) + 1;
        for (field, doc) in names.iter().zip(docs) {
            let _ = writeln!(out, "    double {:width$} /* {} */", format!("{field};"), in_c(&doc));
        }
        let _ = writeln!(out, "}};\n");
    }
    let prefix = &fields.prefix;
    let lags = if e.layout.z.is_empty() { String::new() } else { format!("    struct {prefix}_lags z;\n") };
    let letters = if e.layout.z.is_empty() { "q | v" } else { "q | v | z" };
    let _ = writeln!(
        out,
        "/* State x = [{letters}]. */\nstruct {prefix}_state {{\n    struct {prefix}_coordinates q;\n    struct {prefix}_rates v;\n{lags}}};\n"
    );
}

fn field_doc(v: &Variable) -> String {
    let first = v.doc.lines().next().unwrap_or("").trim();
    format!("{first} [{}]", unit(&v.unit)).trim().to_owned()
}

/// Text that may stand in a comment.
fn in_c(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *").replace("[`", "").replace("`]", "")
}

/// `*` and a name, or `name[3][2]`.
fn result_argument(fields: &Fields, name: &str, shape: Shape) -> Option<String> {
    Some(match shape {
        Shape::Scalar => return None,
        Shape::Array(n) => format!("double {name}[{n}]"),
        Shape::Matrix(r, c) | Shape::OverParameters(r, c) => format!("double {name}[{r}][{c}]"),
        Shape::Named(vector) => format!("{} *{name}", fields.type_of(vector)),
    })
}

/// The result's name: inverse dynamics has an argument `a` and forward dynamics a result of that name.
fn prototype(fields: &Fields, function: &Function) -> String {
    let mut list: Vec<String> = function
        .arguments
        .iter()
        .map(|&v| if v == Vector::Time { "double t".to_owned() } else { format!("const {} *{}", fields.type_of(v), v.letter()) })
        .collect();
    list.extend(function.outputs.iter().filter_map(|o| result_argument(fields, o.name, o.shape)));
    let scalar = function.outputs.iter().any(|o| o.shape == Shape::Scalar);
    let result = if scalar {
        "double"
    } else if function.pivots.is_some() {
        "int"
    } else {
        "void"
    };
    signature(&format!("{result} {}_{}", fields.prefix, plain_name(function)), &list)
}

/// Name and arguments, one a line where one line would be too long.
fn signature(name: &str, list: &[String]) -> String {
    let line = format!("{name}({})", list.join(", "));
    if line.chars().count() < WIDTH { line } else { format!("{name}(\n    {})", list.join(",\n    ")) }
}

fn plain_name(function: &Function) -> String {
    identifier(Language::C, &function.name)
}

fn write_function(
    out: &mut String,
    e: &Equations,
    fields: &Fields,
    function: &Function,
    prototype: &str,
    calls: &mut BTreeSet<&'static str>,
) {
    let roots = function.roots();
    let plan = plan(&e.graph, &fields.vocabulary(e), Names::new(Language::C, &[LETTERS, RESULTS_C, CALLED_C].concat()), &roots);
    calls.extend(plan.calls.iter().copied());
    let name = format!("{}_{}", fields.prefix, plain_name(function));
    let (parts, rest) = split(&plan);
    for (k, part) in parts.iter().enumerate() {
        let vectors = vectors_of(e, &plan, part);
        let mut typed: Vec<String> = vectors
            .iter()
            .map(|&v| if v == Vector::Time { "double t".to_owned() } else { format!("const {} *{}", fields.type_of(v), v.letter()) })
            .collect();
        typed.extend(part.parts_used().iter().map(|&j| format!("const double part_{}[{}]", j + 1, part.lengths[j])));
        typed.push(format!("double part_{}[{}]", k + 1, part.exports.len()));
        let head = signature(&format!("NEVER_INLINE static void {name}_part_{}", k + 1), &typed);
        let _ = writeln!(out, "/* Part {} of {name}. */\n{head}\n{{", k + 1);
        write_imports(out, &part.imports, &plan);
        write_statements(out, e, &function.name, &plan, &part.own);
        for (i, value) in part.exports.iter().enumerate() {
            let _ = writeln!(out, "    part_{}[{i}] = {};", k + 1, value.name(&plan));
        }
        out.push_str("}\n\n");
    }
    let _ = writeln!(out, "{prototype}\n{{");
    let mut used = vectors_of(e, &plan, &rest);
    for part in &parts {
        used.extend(vectors_of(e, &plan, part));
    }
    used.extend(plan.result_symbols.iter().map(|&s| Vector::of(e.graph.symbol_info(s).kind)));
    let has_state = function.arguments.contains(&Vector::State);
    if has_state {
        for v in used.iter().filter(|v| v.is_part_of_state()) {
            let _ = writeln!(out, "    const {} *{1} = &x->{1};", fields.type_of(*v), v.letter());
        }
    }
    for (k, part) in parts.iter().enumerate() {
        let _ = writeln!(out, "    double part_{}[{}];", k + 1, part.exports.len());
    }
    for v in &function.arguments {
        let is_used = used.contains(v) || *v == Vector::State && used.iter().any(|u| u.is_part_of_state());
        if !is_used {
            let _ = writeln!(out, "    (void){};", v.letter());
        }
    }
    for (k, part) in parts.iter().enumerate() {
        let mut list: Vec<String> = vectors_of(e, &plan, part).iter().map(|v| v.letter().to_owned()).collect();
        list.extend(part.parts_used().iter().map(|j| format!("part_{}", j + 1)));
        list.push(format!("part_{}", k + 1));
        let _ = writeln!(out, "    {name}_part_{}({});", k + 1, list.join(", "));
    }
    write_imports(out, &rest.imports, &plan);
    write_statements(out, e, &function.name, &plan, &rest.own);
    write_results(out, fields, function, &plan);
    out.push_str("}\n\n");
}

fn vectors_of(e: &Equations, plan: &Plan, part: &Part) -> BTreeSet<Vector> {
    part.own.clone().flat_map(|k| &plan.statements[k].symbols).map(|&s| Vector::of(e.graph.symbol_info(s).kind)).collect()
}

fn write_imports(out: &mut String, imports: &[Import], plan: &Plan) {
    for import in imports {
        let _ = writeln!(out, "    const double {} = part_{}[{}];", import.value.name(plan), import.part + 1, import.index);
    }
}

fn write_statements(out: &mut String, e: &Equations, within: &str, plan: &Plan, range: &std::ops::Range<usize>) {
    let mut before: Option<String> = None;
    for statement in &plan.statements[range.clone()] {
        if statement.needs_comment {
            let comment = about(e, &statement.scope);
            if let Some(comment) = comment.as_ref().filter(|words| comment != before && *words != within) {
                let _ = writeln!(out, "    /* {} */", in_c(comment));
            }
            before = comment;
        }
        write_statement(out, statement);
    }
}

fn write_statement(out: &mut String, statement: &Statement) {
    match &statement.defines {
        Defines::Value { name, value } => assign(out, &format!("const double {name} = "), value, ""),
        Defines::SinCos { sin, cos, angle } => {
            let angle = angle.text();
            let _ = writeln!(out, "    const double {sin} = sin({angle});\n    const double {cos} = cos({angle});");
        }
    }
}

/// `left value; comment`, in several lines where it is long.
fn assign(out: &mut String, left: &str, value: &Form, comment: &str) {
    let line = format!("    {left}{};", value.text());
    if line.chars().count() <= WIDTH {
        let _ = writeln!(out, "{line}{comment}");
        return;
    }
    let lines: Vec<String> = value
        .pieces()
        .iter()
        .enumerate()
        .map(|(i, piece)| if i == 0 { piece.clone() } else { format!("\n        {}", piece.trim_start()) })
        .collect();
    let _ = writeln!(out, "    {left}{};{comment}", lines.concat());
}

/// Checks of pivots, then the results, entry by entry.
fn write_results(out: &mut String, fields: &Fields, function: &Function, plan: &Plan) {
    let count: usize = function.outputs.iter().map(|o| o.roots.len()).sum();
    let pivots: Vec<_> = function.pivots.iter().flatten().zip(&plan.results[count..]).collect();
    for ((coordinate, _), value) in &pivots {
        let _ = writeln!(out, "    if (!({} > 0.0)) {{\n        return {};\n    }}", value.text(), coordinate + 1);
    }
    let mut at = 0;
    for output in &function.outputs {
        let values = &plan.results[at..at + output.roots.len()];
        at += output.roots.len();
        let row = |i: usize| output.rows.get(i).map_or(String::new(), |name| format!(" /* {name} */"));
        match output.shape {
            Shape::Scalar => {
                assign(out, "return ", &values[0], "");
            }
            Shape::Array(_) => {
                for (i, value) in values.iter().enumerate() {
                    assign(out, &format!("{}[{i}] = ", output.name), value, &row(i));
                }
            }
            Shape::Named(vector) => {
                for (field, value) in fields.of(vector).iter().zip(values) {
                    assign(out, &format!("{}->{field} = ", output.name), value, "");
                }
            }
            Shape::Matrix(rows, columns) | Shape::OverParameters(rows, columns) => {
                write_matrix(out, output.name, rows, columns, values, &row)
            }
        }
    }
    if function.pivots.is_some() {
        out.push_str("    return 0;\n");
    }
}

/// Zeros by a loop, the rest entry by entry, each row with a comment.
fn write_matrix(out: &mut String, name: &str, rows: usize, columns: usize, values: &[Form], row: &dyn Fn(usize) -> String) {
    let texts: Vec<String> = values.iter().map(Form::text).collect();
    if texts.iter().any(|t| t == "0.0") {
        let _ = writeln!(
            out,
            "    for (int i = 0; i < {rows}; i++) {{\n        for (int j = 0; j < {columns}; j++) {{\n            {name}[i][j] = 0.0;\n        }}\n    }}"
        );
    }
    for i in 0..rows {
        let mut comment = row(i);
        for j in 0..columns {
            if texts[i * columns + j] != "0.0" {
                assign(out, &format!("{name}[{i}][{j}] = "), &values[i * columns + j], &comment);
                comment.clear();
            }
        }
    }
}
