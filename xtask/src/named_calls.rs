//! Test support: the text of `tests/src/named.rs`, which calls every named function of every checked-in model.
//! The functions' signatures differ from rig to rig, so a program writes the calls.

use codegen::Equations;
use codegen::emit::{Shape, Vector, functions};
use std::fmt::Write;

/// The start of the file.
pub fn start() -> String {
    "//! Calls of every named function of the checked-in models, for tests.\n\
     //! Generated from `examples/rigs` by `cargo xtask gen`; edit the rigs, not this file.\n\n\
     use crate::calls::{Arguments, Called, Flat};\n"
        .to_owned()
}

/// Calls of one rig's functions.
pub fn write(out: &mut String, module: &str, equations: &Equations) {
    let list = functions(equations);
    let _ = writeln!(out, "\nfn {module}(given: &Arguments) -> Vec<Called> {{\n    use generated::{module}::*;");
    for vector in [Vector::Time, Vector::State, Vector::Coordinates, Vector::Rates, Vector::Accelerations, Vector::Lags, Vector::Inputs, Vector::Parameters] {
        if !list.iter().any(|f| f.arguments.contains(&vector)) {
            continue;
        }
        let letter = vector.letter();
        let _ = match vector {
            Vector::Time => writeln!(out, "    let t = given.t;"),
            _ => writeln!(out, "    let {letter} = {vector:?}::from_array(runtime::array(given.{letter}));"),
        };
    }
    out.push_str("    vec![\n");
    for function in &list {
        let arguments: Vec<String> =
            function.arguments.iter().map(|v| if *v == Vector::Time { "t".to_owned() } else { format!("&{}", v.letter()) }).collect();
        let call = format!("{}({})", function.name, arguments.join(", "));
        let single = function.outputs.len() == 1;
        let flat: Vec<String> = function
            .outputs
            .iter()
            .map(|o| {
                let field = if single { String::new() } else { format!(".{}", o.name) };
                let array = if matches!(o.shape, Shape::Named(_)) { ".to_array()" } else { "" };
                format!("r{field}{array}.flat()")
            })
            .collect();
        let value = format!("vec![{}]", flat.join(", "));
        let value = if function.pivots.is_some() { format!("{call}.map(|r| {value})") } else { format!("Ok({{ let r = {call}; {value} }})") };
        let _ = writeln!(out, "        ({:?}, {value}),", function.name);
    }
    out.push_str("    ]\n}\n");
}

/// The end: a choice by the rig's file.
pub fn finish<'a>(mut out: String, modules: impl Iterator<Item = &'a str>) -> String {
    out.push_str("\n/// Every named function of a rig's module at one state; `None` where there is no module of this name.\n#[must_use]\n");
    out.push_str("pub fn named(rig: &str, given: &Arguments) -> Option<Vec<Called>> {\n    Some(match rig {\n");
    for module in modules {
        let _ = writeln!(out, "        {module:?} => {module}(given),");
    }
    out.push_str("        _ => return None,\n    })\n}\n");
    out
}
