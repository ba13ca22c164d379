//! Maintenance of the project: `cargo xtask gen [--check]`, `gallery [--check]`, `witness`, `oracle [--check | --riccati] [--python PROGRAM]`.
//! One file a task; each says what it did, or what is wrong and how to mend it.

mod gallery;
mod gen_models;
mod named_calls;
mod oracle;
mod witness;

use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let rest = arguments.get(1..).unwrap_or(&[]);
    let result =
        match arguments.first().map(String::as_str) {
            Some("gen") => gen_models::run(rest),
            Some("gallery") => gallery::run(rest),
            Some("witness") => witness::run(rest),
            Some("oracle") => oracle::run(rest),
            _ => Err("usage: cargo xtask gen [--check] | gallery [--check] | witness | oracle [--check | --riccati] [--python PROGRAM]"
                .to_owned()),
        };
    match result {
        Ok(said) => {
            println!("{said}");
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("xtask: {why}");
            ExitCode::FAILURE
        }
    }
}

/// The project's folder.
fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, PathBuf::from)
}
