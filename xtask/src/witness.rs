//! `cargo xtask witness`: the checked-in models build without the standard library.
//!
//! No target without an operating system need be installed for it. The witness crate is `#![no_std]` itself,
//! has its own panic handler, and links as a static library: if any crate below it used `std`, that one
//! would bring a second panic handler, and the build would fail. That it can fail is shown as well, by building it
//! once more with the feature `with_std`.

use std::path::Path;
use std::process::{Command, Output};

/// Runs the task.
pub fn run(arguments: &[String]) -> Result<String, String> {
    if !arguments.is_empty() {
        return Err("usage: cargo xtask witness".to_owned());
    }
    let root = crate::root();
    let folder = root.join("generated/witness");
    let without = build(&root, &folder, &[])?;
    if !without.status.success() {
        return Err(format!("the checked-in models do not build without std:\n{}", String::from_utf8_lossy(&without.stderr)));
    }
    let with = build(&root, &folder, &["--features", "with_std"])?;
    let said = String::from_utf8_lossy(&with.stderr);
    if with.status.success() || !said.contains("panic_impl") {
        return Err(format!("the witness proves nothing: with std it should fail for a second panic handler, but said:\n{said}"));
    }
    Ok("the checked-in models build without std (and the witness fails where std is let in)".to_owned())
}

fn build(root: &Path, folder: &Path, more: &[&str]) -> Result<Output, String> {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(["build", "--release", "--quiet", "--manifest-path"]).arg(folder.join("Cargo.toml"));
    command.arg("--target-dir").arg(root.join("target/witness")).args(more);
    command.output().map_err(|e| format!("cargo: {e}"))
}
