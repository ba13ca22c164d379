//! Instructions per call, by valgrind: repeatable where wall time is not.

use crate::calls::{Quantity, calls};
use crate::rigs;
use jit::{Evaluation, InProcess};
use std::process::Command;

/// The hidden argument by which this program is run under valgrind.
pub const REPEAT: &str = "--repeat";

/// Calls a compared model `count` times: what runs under valgrind.
///
/// # Errors
/// Where the arguments are not those that [`per_call`] gives.
pub fn repeat(arguments: &[String]) -> Result<(), String> {
    let [model, what, count] = arguments else { return Err(format!("{REPEAT} is for internal use")) };
    let (name, text) = rigs::COMPARED.into_iter().find(|(name, _)| name == model).ok_or("no such model")?;
    let model = InProcess::evaluated(rigs::equations(&rigs::check(name, text)?)?, Evaluation::Compiled);
    let what = if what == "linear" { Quantity::Linear } else { Quantity::Forward };
    let count: u32 = count.parse().map_err(|_| "no count")?;
    calls(&model, what, |call| (0..count).for_each(|i| call(f64::from(i) * 1e-9)))
}

/// Instructions per call of x', and of x' with A and B, of a compared model in the process.
///
/// # Errors
/// Where valgrind is not there or fails.
pub fn per_call(model: &str) -> Result<[f64; 2], String> {
    let (few, many) = (100_u32, 1100_u32);
    let total = |what: &str, count: u32| counted(&[REPEAT, model, what, &count.to_string()]);
    let each = |what: &str| Ok::<f64, String>((total(what, many)? - total(what, few)?) / f64::from(many - few));
    Ok([each("forward")?, each("linear")?])
}

/// Instructions of a whole run of this program with hidden arguments.
///
/// # Errors
/// Where valgrind is not there or fails.
pub fn counted(arguments: &[&str]) -> Result<f64, String> {
    let program = std::env::current_exe().map_err(|e| e.to_string())?;
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]).arg(&program).args(arguments);
    let out = command.output().map_err(|e| format!("valgrind: {e}"))?;
    let said = String::from_utf8_lossy(&out.stderr);
    let collected = said.lines().find_map(|line| line.split("Collected :").nth(1)).and_then(|n| n.trim().parse().ok());
    collected.filter(|_| out.status.success()).ok_or_else(|| format!("valgrind failed:\n{said}"))
}
