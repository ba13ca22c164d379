//! Rust: structs with named fields, a function a quantity, and the model trait over them.
//!
//! The text is written directly, 140 columns wide, in rustfmt's manner.

use super::about::{Header, about, wrapped};
use super::form::Form;
use super::functions::{Function, Output, Shape, Vector, entries, functions, place};
use super::names::{CALLED_RUST, LETTERS, Language, Names, identifier};
use super::plan::{Defines, Plan, Statement, plan};
use super::rust_model;
use super::split::{Part, split};
use super::vocabulary::Vocabulary;
use crate::equations::{Equations, Variable};
use crate::expr::{Graph, Id, SymbolId};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Columns.
pub(super) const WIDTH: usize = 140;

/// Rust source of a model: one module that needs `core` and the crate `runtime` only.
///
/// `source` is the name of the rig's file, for the header. The equations should have been derived with Jacobians;
/// without them the functions that need them are left out, and so is the model trait.
#[must_use]
pub fn rust(equations: &Equations, source: &str) -> String {
    let fields = Fields::new(equations);
    let mut calls = BTreeSet::new();
    let mut body = String::new();
    structs(&mut body, equations, &fields);
    for function in functions(equations) {
        write_function(&mut body, equations, &fields, &function, &mut calls);
    }
    let mut uses: Vec<&str> = Vec::new();
    if !equations.linear.a.is_empty() {
        rust_model::write(&mut body, equations, &fields, &mut calls);
        uses.extend(["Dimensions", "InputPath", "Model", "Names", "OutputPath"]);
    }
    uses.extend(["Singular", "positive"].iter().filter(|name| body.contains(&format!("{name}(")) || **name == "Singular"));
    let mut out = String::new();
    for line in Header::new(equations, source).lines(WIDTH - 4) {
        let _ = writeln!(out, "{}", format!("//! {line}").trim_end());
    }
    out.push_str("#![allow(non_snake_case, rustdoc::broken_intra_doc_links)]\n");
    out.push_str("#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments)]\n\n");
    if !calls.is_empty() {
        let list: Vec<&str> = calls.into_iter().collect();
        let _ = writeln!(out, "use runtime::math::{};", braced(&list));
    }
    let _ = writeln!(out, "use runtime::{};\n", braced(&uses));
    out.push_str(&body);
    out
}

/// Name of the unit struct that implements `runtime::Model` in the text of [`rust`]: `GoogolMrb`.
#[must_use]
pub fn rust_model_name(equations: &Equations) -> String {
    Fields::new(equations).model
}

/// A few expressions as one Rust function over named numbers: `pub fn name(a: f64, b: f64) -> [f64; N]`.
/// It calls functions of `runtime::math` by their names.
#[must_use]
pub fn rust_function(graph: &Graph, name: &str, arguments: &[SymbolId], results: &[Id]) -> String {
    rust_function_with(graph, name, arguments, &[], results).0
}

/// The same, with symbols that have values of their own; and the names of `runtime::math` that it calls.
pub(super) fn rust_function_with(
    graph: &Graph,
    name: &str,
    arguments: &[SymbolId],
    constants: &[(SymbolId, f64)],
    results: &[Id],
) -> (String, BTreeSet<&'static str>) {
    let mut names = Names::new(Language::Rust, CALLED_RUST);
    let symbols: Vec<SymbolId> = arguments.iter().copied().chain(constants.iter().map(|c| c.0)).collect();
    let given: Vec<String> = symbols.iter().map(|&s| names.take(&graph.symbol_info(s).name)).collect();
    let vocabulary = Vocabulary::new(Language::Rust, graph, |s, _| {
        let text = symbols.iter().position(|&a| a == s).map_or_else(|| "f64::NAN".to_owned(), |i| given[i].clone());
        (text.clone(), text)
    });
    let plan = plan(graph, &vocabulary, names, results);
    let read = plan.symbols();
    let typed: Vec<String> =
        given.iter().zip(arguments).map(|(a, s)| format!("{}{a}: f64", if read.contains(s) { "" } else { "_" })).collect();
    let mut out = format!("pub fn {}({}) -> [f64; {}] {{\n", identifier(Language::Rust, name), typed.join(", "), results.len());
    for ((symbol, value), name) in constants.iter().zip(&given[arguments.len()..]).filter(|((s, _), _)| read.contains(s)) {
        let _ = writeln!(out, "    let {name} = {};{}", super::form::number(*value), remark(graph, *symbol, name, "//"));
    }
    for statement in &plan.statements {
        write_statement(&mut out, statement, 4);
    }
    write_list(&mut out, 4, "[", &plan.results, &[], "]");
    out.push_str("}\n");
    (out, plan.calls)
}

/// The rig's name of a constant, where the language could not take it.
pub(super) fn remark(graph: &Graph, symbol: SymbolId, name: &str, mark: &str) -> String {
    let own = &graph.symbol_info(symbol).name;
    if own == name { String::new() } else { format!(" {mark} {own}") }
}

/// Names of fields and types.
pub(super) struct Fields {
    /// Type of the unit struct: `GoogolMrb`.
    pub model: String,
    lists: Vec<(Vector, Vec<String>)>,
}

impl Fields {
    fn new(e: &Equations) -> Self {
        let all = [Vector::Coordinates, Vector::Rates, Vector::Accelerations, Vector::Lags, Vector::Inputs, Vector::Parameters];
        let mut lists: Vec<(Vector, Vec<String>)> =
            all.iter().map(|&v| (v, field_names(Language::Rust, v, entries(e, v).unwrap_or(&[])))).collect();
        let mut names = Names::new::<&str>(Language::Rust, &[]);
        lists.push((Vector::Outputs, e.layout.outputs.iter().map(|y| names.take(&y.name)).collect()));
        let mut types: Vec<&str> = TYPES.iter().map(|t| t.1).collect();
        types.extend([
            "Linearization",
            "OutputJacobian",
            "Dimensions",
            "InputPath",
            "Model",
            "Names",
            "OutputPath",
            "Singular",
            "Ok",
            "Err",
            "Result",
        ]);
        let model = Names::new(Language::Rust, &types).take(&e.layout.rig);
        Self { model, lists }
    }

    /// Fields of a vector.
    pub fn of(&self, vector: Vector) -> &[String] {
        self.lists.iter().find(|(v, _)| *v == vector).map_or(&[], |(_, names)| names)
    }

    pub(super) fn vocabulary(&self, e: &Equations) -> Vocabulary {
        Vocabulary::new(Language::Rust, &e.graph, |s, kind| {
            let vector = Vector::of(kind);
            if vector == Vector::Time {
                return ("t".to_owned(), "t".to_owned());
            }
            let i = place(&e.graph, s);
            let field = self.of(vector).get(i).map_or("missing", String::as_str);
            (format!("{}.{field}", vector.letter()), base_name(vector, field))
        })
    }

    /// Names that values within functions must not take.
    pub(super) fn within(&self) -> Names {
        let mut taken: Vec<&str> = [LETTERS, CALLED_RUST].concat();
        taken.extend(CONSTANTS);
        taken.extend(TYPES.iter().map(|t| t.1));
        taken.push(&self.model);
        Names::new(Language::Rust, &taken)
    }
}

/// Constants of a module, besides those of structs.
const CONSTANTS: &[&str] = &[
    "COORDINATES",
    "STATES",
    "INPUTS",
    "PARAMETERS",
    "OUTPUTS",
    "STATE_NAMES",
    "INPUT_NAMES",
    "PARAMETER_NAMES",
    "PARAMETER_UNITS",
    "OUTPUT_NAMES",
    "OUTPUT_UNITS",
];

/// Field names of a vector, without the suffix that its type says already.
pub(super) fn field_names(language: Language, vector: Vector, entries: &[Variable]) -> Vec<String> {
    let mut names = Names::new::<&str>(language, &[]);
    let suffix = match vector {
        Vector::Rates => ".dot",
        Vector::Accelerations => ".ddot",
        Vector::Lags => ".lag",
        _ => "",
    };
    entries.iter().map(|v| names.take(v.name.strip_suffix(suffix).unwrap_or(&v.name))).collect()
}

/// How a symbol is called within the names of intermediate values.
pub(super) fn base_name(vector: Vector, field: &str) -> String {
    match vector {
        Vector::Rates => format!("{field}_dot"),
        Vector::Accelerations => format!("{field}_ddot"),
        Vector::Lags => format!("{field}_lag"),
        _ => field.to_owned(),
    }
}

/// Structs of numbers, in the order of their declaration.
const TYPES: [(Vector, &str, &str); 8] = [
    (Vector::Parameters, "Parameters", "Parameters p."),
    (Vector::Coordinates, "Coordinates", "Coordinates q."),
    (Vector::Rates, "Rates", "Rates v = q'."),
    (Vector::Lags, "Lags", "Actuator states z."),
    (Vector::Accelerations, "Accelerations", "Accelerations a = q''."),
    (Vector::Inputs, "Inputs", "Signals u: inputs, then accelerations of prescribed coordinates."),
    (Vector::Outputs, "Outputs", "Measured outputs y."),
    (Vector::State, "State", "State x = [q | v | z]."),
];

/// Type of a vector.
pub(super) fn type_of(vector: Vector) -> &'static str {
    TYPES.iter().find(|t| t.0 == vector).map_or("f64", |t| t.1)
}

fn structs(out: &mut String, e: &Equations, fields: &Fields) {
    for (vector, name, doc) in TYPES {
        let docs: Vec<String> = match vector {
            Vector::State => {
                state_struct(out, e);
                continue;
            }
            Vector::Outputs => e.layout.outputs.iter().map(|y| format!("{} [{}]", y.name, unit(&y.unit))).collect(),
            _ => entries(e, vector).unwrap_or(&[]).iter().map(field_doc).collect(),
        };
        let names = fields.of(vector);
        if names.is_empty() {
            continue;
        }
        let default = if vector == Vector::Parameters { "" } else { "Default, " };
        let _ = writeln!(out, "/// {doc}\n#[derive(Clone, Copy, Debug, {default}PartialEq)]\npub struct {name} {{");
        for (field, doc) in names.iter().zip(docs) {
            let _ = writeln!(out, "    /// {doc}\n    pub {field}: f64,");
        }
        let n = names.len();
        let _ = writeln!(out, "}}\n\nimpl {name} {{");
        if vector == Vector::Parameters {
            out.push_str("    /// The values that the rig's file gives.\n    pub const NOMINAL: Self = Self {\n");
            for (field, value) in names.iter().zip(&e.layout.nominal) {
                let _ = writeln!(out, "        {field}: {},", super::form::number(*value));
            }
            out.push_str("    };\n\n");
            if functions(e).iter().any(|f| f.has_sparse_rows(&e.graph)) {
                let _ = writeln!(
                    out,
                    "    /// All zero: where derivatives with respect to the parameters start from.\n    const ZERO: Self = Self::from_array([0.0; {}]);\n",
                    names.len()
                );
            }
        }
        let _ = writeln!(out, "    /// From an array in the model's order.\n    #[inline]\n    #[must_use]");
        let _ = writeln!(out, "    pub const fn from_array(values: [f64; {n}]) -> Self {{");
        let listed: Vec<Form> = names.iter().map(|f| Form::atom(super::form::Rank::Named, f.clone())).collect();
        let mut pattern = String::new();
        write_list(&mut pattern, 8, "let [", &listed, &[], "] = values;");
        out.push_str(&pattern);
        write_list(out, 8, "Self { ", &listed, &[], " }");
        let _ = writeln!(out, "    }}\n\n    /// As an array in the model's order.\n    #[inline]\n    #[must_use]");
        let _ = writeln!(out, "    pub const fn to_array(&self) -> [f64; {n}] {{");
        let own: Vec<Form> = names.iter().map(|f| Form::atom(super::form::Rank::Named, format!("self.{f}"))).collect();
        write_list(out, 8, "[", &own, &[], "]");
        out.push_str("    }\n}\n\n");
        if vector == Vector::Parameters {
            let _ = writeln!(out, "impl Default for {name} {{\n    fn default() -> Self {{\n        Self::NOMINAL\n    }}\n}}\n");
        }
    }
}

fn state_struct(out: &mut String, e: &Equations) {
    let l = &e.layout;
    let parts: Vec<(&str, &str, &str, usize)> = [
        ("q", "Coordinates", "Coordinates.", l.q.len()),
        ("v", "Rates", "Rates.", l.v.len()),
        ("z", "Lags", "Actuator states.", l.z.len()),
    ]
    .into_iter()
    .filter(|p| p.3 > 0)
    .collect();
    let letters: Vec<&str> = parts.iter().map(|p| p.0).collect();
    let n = l.states();
    let _ =
        writeln!(out, "/// State x = [{}].\n#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct State {{", letters.join(" | "));
    for (field, name, doc, _) in &parts {
        let _ = writeln!(out, "    /// {doc}\n    pub {field}: {name},");
    }
    let names: Vec<String> = (0..n).map(|i| format!("x{i}")).collect();
    let atoms = |names: &[String]| -> Vec<Form> { names.iter().map(|f| Form::atom(super::form::Rank::Named, f.clone())).collect() };
    let _ = writeln!(out, "}}\n\nimpl State {{\n    /// From an array in the model's order.\n    #[inline]\n    #[must_use]");
    let _ = writeln!(out, "    pub const fn from_array(values: [f64; {n}]) -> Self {{");
    write_list(out, 8, "let [", &atoms(&names), &[], "] = values;");
    out.push_str("        Self {\n");
    let mut at = 0;
    for (field, name, _, length) in &parts {
        write_list(out, 12, &format!("{field}: {name}::from_array(["), &atoms(&names[at..at + length]), &[], "]),");
        at += length;
    }
    let _ = writeln!(out, "        }}\n    }}\n\n    /// As an array in the model's order.\n    #[inline]\n    #[must_use]");
    let _ = writeln!(out, "    pub const fn to_array(&self) -> [f64; {n}] {{");
    let mut at = 0;
    for (field, _, _, length) in &parts {
        write_list(out, 8, "let [", &atoms(&names[at..at + length]), &[], &format!("] = self.{field}.to_array();"));
        at += length;
    }
    write_list(out, 8, "[", &atoms(&names), &[], "]");
    out.push_str("    }\n}\n\n");
}

fn field_doc(v: &Variable) -> String {
    let first = v.doc.lines().next().unwrap_or("").trim();
    let what = if first.is_empty() { v.name.as_str() } else { first };
    format!("{what} [{}]", unit(&v.unit))
}

pub(super) fn unit(text: &str) -> &str {
    if text.is_empty() { "1" } else { text }
}

fn braced(names: &[&str]) -> String {
    match names {
        [one] => (*one).to_owned(),
        _ => format!("{{{}}}", names.join(", ")),
    }
}

/// One function, with its parts before it where it is long.
fn write_function(out: &mut String, e: &Equations, fields: &Fields, function: &Function, calls: &mut BTreeSet<&'static str>) {
    let roots = function.roots();
    let plan = plan(&e.graph, &fields.vocabulary(e), fields.within(), &roots);
    calls.extend(plan.calls.iter().copied());
    if function.record == "Linearization" && function.name == "linearize" || function.record == "OutputJacobian" {
        record(out, function);
    }
    let name = identifier(Language::Rust, &function.name);
    let (parts, rest) = split(&plan);
    for (k, part) in parts.iter().enumerate() {
        write_part(out, e, &name, &plan, part, k);
    }
    for line in wrapped(&function.doc, WIDTH - 4) {
        let _ = writeln!(out, "{}", format!("/// {line}").trim_end());
    }
    if function.pivots.is_some() {
        out.push_str("///\n/// # Errors\n/// [`Singular`] where the mass matrix is not positive definite.\n");
    }
    let used = used_vectors(e, &plan, &rest, &parts);
    let given: Vec<String> = function
        .arguments
        .iter()
        .map(|&v| {
            let is_used = used.contains(&v) || v == Vector::State && used.iter().any(|u| u.is_part_of_state());
            let mark = if is_used { "" } else { "_" };
            if v == Vector::Time { format!("{mark}t: f64") } else { format!("{mark}{}: &{}", v.letter(), type_of(v)) }
        })
        .collect();
    let plain = result_type(function);
    let result = if function.pivots.is_some() { format!("Result<{plain}, Singular>") } else { plain };
    if function.pivots.is_none() {
        out.push_str("#[must_use]\n");
    }
    let _ = writeln!(out, "pub fn {name}({}) -> {result} {{", given.join(", "));
    if function.arguments.contains(&Vector::State) {
        let taken: Vec<&str> = used.iter().filter(|v| v.is_part_of_state()).map(|v| v.letter()).collect();
        let all = 2 + usize::from(!e.layout.z.is_empty());
        let dots = if taken.len() < all { ", .." } else { "" };
        if !taken.is_empty() {
            let _ = writeln!(out, "    let State {{ {}{dots} }} = x;", taken.join(", "));
        }
    }
    for (k, part) in parts.iter().enumerate() {
        let _ = writeln!(out, "    let part_{0} = {name}_part_{0}({1});", k + 1, part_arguments(e, &plan, part).join(", "));
    }
    write_imports(out, &rest.imports, &plan);
    write_statements(out, e, &function.name, &plan, &rest.own);
    write_results(out, fields, function, &plan);
    out.push_str("}\n\n");
}

fn record(out: &mut String, function: &Function) {
    let what = if function.record == "Linearization" {
        "x' and its Jacobians at one state."
    } else {
        "Jacobians of the measured outputs at one state."
    };
    let _ = writeln!(out, "/// {what}\n#[derive(Clone, Copy, Debug, PartialEq)]\npub struct {} {{", function.record);
    for output in &function.outputs {
        let _ = writeln!(out, "    /// {}.\n    pub {}: {},", output.doc, output.name, shape_type(output.shape));
    }
    out.push_str("}\n\n");
}

fn shape_type(shape: Shape) -> String {
    match shape {
        Shape::Scalar => "f64".to_owned(),
        Shape::Array(n) => format!("[f64; {n}]"),
        Shape::Matrix(r, c) | Shape::OverParameters(r, c) => format!("[[f64; {c}]; {r}]"),
        Shape::Named(vector) => type_of(vector).to_owned(),
    }
}

fn result_type(function: &Function) -> String {
    match function.outputs.as_slice() {
        [one] => shape_type(one.shape),
        _ => function.record.to_owned(),
    }
}

/// Vectors that the body of a function reads, its calls of parts included.
fn used_vectors(e: &Equations, plan: &Plan, rest: &Part, parts: &[Part]) -> BTreeSet<Vector> {
    let mut used = vectors_of(e, plan, rest);
    for part in parts {
        used.extend(vectors_of(e, plan, part));
    }
    used.extend(plan.result_symbols.iter().map(|&s| Vector::of(e.graph.symbol_info(s).kind)));
    used
}

fn vectors_of(e: &Equations, plan: &Plan, part: &Part) -> BTreeSet<Vector> {
    part.own.clone().flat_map(|k| &plan.statements[k].symbols).map(|&s| Vector::of(e.graph.symbol_info(s).kind)).collect()
}

/// What a part is called with.
fn part_arguments(e: &Equations, plan: &Plan, part: &Part) -> Vec<String> {
    let vectors = vectors_of(e, plan, part);
    let mut list: Vec<String> = vectors.iter().map(|v| v.letter().to_owned()).collect();
    list.extend(part.parts_used().iter().map(|k| format!("&part_{}", k + 1)));
    list
}

fn write_part(out: &mut String, e: &Equations, name: &str, plan: &Plan, part: &Part, k: usize) {
    let vectors = vectors_of(e, plan, part);
    let mut typed: Vec<String> =
        vectors.iter().map(|&v| if v == Vector::Time { "t: f64".to_owned() } else { format!("{}: &{}", v.letter(), type_of(v)) }).collect();
    typed.extend(part.parts_used().iter().map(|&j| format!("part_{}: &[f64; {}]", j + 1, part.lengths[j])));
    let n = part.exports.len();
    let _ = writeln!(out, "/// Part {} of [`{name}`]: values that later parts need.", k + 1);
    // a compiler would inline a function that is called once, and undo the split
    let head = format!("fn {name}_part_{}(", k + 1);
    let line = format!("{head}{}) -> [f64; {n}] {{", typed.join(", "));
    let signature =
        if line.chars().count() <= WIDTH { line } else { format!("{head}\n    {},\n) -> [f64; {n}] {{", typed.join(",\n    ")) };
    let _ = writeln!(out, "#[inline(never)]\n{signature}");
    write_imports(out, &part.imports, plan);
    write_statements(out, e, name, plan, &part.own);
    let exports: Vec<Form> = part.exports.iter().map(|x| Form::atom(super::form::Rank::Named, x.name(plan).to_owned())).collect();
    write_list(out, 4, "[", &exports, &[], "]");
    out.push_str("}\n\n");
}

fn write_imports(out: &mut String, imports: &[super::split::Import], plan: &Plan) {
    for import in imports {
        let _ = writeln!(out, "    let {} = part_{}[{}];", import.value.name(plan), import.part + 1, import.index);
    }
}

fn write_statements(out: &mut String, e: &Equations, within: &str, plan: &Plan, range: &std::ops::Range<usize>) {
    let mut before: Option<String> = None;
    for statement in &plan.statements[range.clone()] {
        if statement.needs_comment {
            let comment = about(e, &statement.scope);
            if let Some(comment) = comment.as_ref().filter(|words| comment != before && *words != within) {
                let _ = writeln!(out, "    // {comment}");
            }
            before = comment;
        }
        write_statement(out, statement, 4);
    }
}

pub(super) fn write_statement(out: &mut String, statement: &Statement, indent: usize) {
    let (left, value) = match &statement.defines {
        Defines::Value { name, value } => (format!("let {name} = "), value.clone()),
        Defines::SinCos { sin, cos, angle } => (format!("let ({sin}, {cos}) = "), Form::call(format!("sin_cos({})", angle.text()), 0)),
    };
    let line = format!("{:indent$}{left}{};", "", value.text());
    if line.chars().count() <= WIDTH {
        let _ = writeln!(out, "{line}");
        return;
    }
    let _ = writeln!(out, "{:indent$}{left}{};", "", broken(&value, indent));
}

/// An expression in several lines, rustfmt's way: each further term starts a line.
fn broken(value: &Form, indent: usize) -> String {
    let more = indent + 4;
    let lines: Vec<String> = value
        .pieces()
        .iter()
        .enumerate()
        .map(|(i, piece)| if i == 0 { piece.clone() } else { format!("\n{:more$}{}", "", piece.trim_start()) })
        .collect();
    lines.concat()
}

/// `open a, b, c close` on one line where it fits, otherwise one a line with a comment, or filled lines
/// where there are no comments.
pub(super) fn write_list(out: &mut String, indent: usize, open: &str, values: &[Form], comments: &[String], close: &str) {
    let texts: Vec<String> = values.iter().map(Form::text).collect();
    let line = format!("{:indent$}{open}{}{close}", "", texts.join(", "));
    if line.chars().count() <= WIDTH && !texts.iter().any(|t| t.len() > 60) {
        let _ = writeln!(out, "{line}");
        return;
    }
    let _ = writeln!(out, "{:indent$}{}", "", open.trim_end());
    let inner = indent + 4;
    if comments.is_empty() {
        let mut line = String::new();
        for text in &texts {
            if !line.is_empty() && inner + line.chars().count() + text.chars().count() + 2 > WIDTH {
                let _ = writeln!(out, "{:inner$}{}", "", line.trim_end());
                line.clear();
            }
            line.push_str(text);
            line.push_str(", ");
        }
        let _ = writeln!(out, "{:inner$}{}", "", line.trim_end());
    } else {
        for ((text, value), comment) in texts.iter().zip(values).zip(comments) {
            let line = format!("{:inner$}{text}, // {comment}", "");
            if line.chars().count() <= WIDTH {
                let _ = writeln!(out, "{line}");
            } else {
                let _ = writeln!(out, "{:inner$}// {comment}\n{:inner$}{},", "", "", broken(value, inner));
            }
        }
    }
    let _ = writeln!(out, "{:indent$}{}", "", close.trim_start_matches([' ', ',']));
}

/// Checks of pivots, then the value.
fn write_results(out: &mut String, fields: &Fields, function: &Function, plan: &Plan) {
    let mut at = 0;
    let mut blocks: Vec<(&Output, &[Form])> = Vec::new();
    for output in &function.outputs {
        blocks.push((output, &plan.results[at..at + output.roots.len()]));
        at += output.roots.len();
    }
    for ((coordinate, _), value) in function.pivots.iter().flatten().zip(&plan.results[at..]) {
        let _ = writeln!(out, "    positive({}, {coordinate})?;", value.text());
    }
    let (before, after) = if function.pivots.is_some() { ("Ok(", ")") } else { ("", "") };
    match blocks.as_slice() {
        [(output, values)] => write_value(out, fields, 4, before, output, values, after),
        several => {
            let _ = writeln!(out, "    {before}{} {{", function.record);
            for (output, values) in several {
                write_value(out, fields, 8, &format!("{}: ", output.name), output, values, ",");
            }
            let _ = writeln!(out, "    }}{after}");
        }
    }
}

fn write_value(out: &mut String, fields: &Fields, indent: usize, before: &str, output: &Output, values: &[Form], after: &str) {
    match output.shape {
        Shape::Scalar => {
            let line = format!("{:indent$}{before}{}{after}", "", values[0].text());
            if line.chars().count() <= WIDTH {
                let _ = writeln!(out, "{line}");
            } else {
                let _ = writeln!(out, "{:indent$}{before}{}{after}", "", broken(&values[0], indent));
            }
        }
        Shape::Array(_) => write_list(out, indent, &format!("{before}["), values, &output.rows, &format!("]{after}")),
        Shape::Named(vector) => {
            let open = format!("{before}{}::from_array([", type_of(vector));
            write_list(out, indent, &open, values, &output.rows, &format!("]){after}"));
        }
        Shape::OverParameters(_, columns) => {
            let _ = writeln!(out, "{:indent$}{before}[", "");
            let inner = indent + 4;
            for (row, name) in values.chunks(columns.max(1)).zip(&output.rows) {
                let listed: Vec<String> = fields
                    .of(Vector::Parameters)
                    .iter()
                    .zip(row)
                    .map(|(field, value)| (field, value.text()))
                    .filter(|(_, text)| text != "0.0")
                    .map(|(field, text)| format!("{field}: {text}"))
                    .collect();
                if listed.is_empty() {
                    let _ = writeln!(out, "{:inner$}[0.0; {columns}], // {name}", "");
                    continue;
                }
                let _ = writeln!(out, "{:inner$}// {name}\n{:inner$}Parameters {{", "", "");
                for entry in &listed {
                    let _ = writeln!(out, "{:1$}{entry},", "", inner + 4);
                }
                if listed.len() < columns {
                    let _ = writeln!(out, "{:1$}..Parameters::ZERO", "", inner + 4);
                }
                let _ = writeln!(out, "{:inner$}}}\n{:inner$}.to_array(),", "", "");
            }
            let _ = writeln!(out, "{:indent$}]{after}", "");
        }
        Shape::Matrix(_, columns) => {
            let rows: Vec<&[Form]> = values.chunks(columns.max(1)).collect();
            let texts: Vec<String> =
                rows.iter().map(|row| format!("[{}]", row.iter().map(Form::text).collect::<Vec<_>>().join(", "))).collect();
            let line = format!("{:indent$}{before}[{}]{after}", "", texts.join(", "));
            if line.chars().count() <= 100 {
                let _ = writeln!(out, "{line}");
                return;
            }
            let _ = writeln!(out, "{:indent$}{before}[", "");
            let inner = indent + 4;
            for ((row, text), name) in rows.iter().zip(&texts).zip(&output.rows) {
                let line = format!("{:inner$}{text}, // {name}", "");
                if line.chars().count() <= WIDTH {
                    let _ = writeln!(out, "{line}");
                } else if row.iter().all(|f| f.text() == row[0].text()) {
                    let _ = writeln!(out, "{:inner$}[{}; {columns}], // {name}", "", row[0].text());
                } else {
                    let _ = writeln!(out, "{:inner$}// {name}", "");
                    write_list(out, inner, "[", row, &[], "],");
                }
            }
            let _ = writeln!(out, "{:indent$}]{after}", "");
        }
    }
}
