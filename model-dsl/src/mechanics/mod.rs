//! Checks of mechanics on the resolved rig, at its parameters' values: one check a file.
//!
//! Knows the checked rig and, for places, the statements behind it. Where an earlier error left a hole (a number that
//! is NaN), a check that needs it says nothing: one mistake, one message.

mod inertia;
mod kinetic;
mod matrix;
mod motion;
mod numbers;
mod places;
mod signs;
mod unused;
mod values;

use crate::ast::Statement;
use crate::diagnostic::{Diagnostic, Severity};
use crate::rig::{Rig, Symbol};
use numbers::Numbers;
use std::collections::BTreeSet;

/// What the checks look at.
struct Context<'a> {
    rig: &'a Rig,
    statements: &'a [Statement],
    used: &'a BTreeSet<Symbol>,
    numbers: Numbers<'a>,
}

/// Runs all checks. Those that ask what is missing wait until nothing is lost to an error of another kind.
pub fn check(rig: &Rig, statements: &[Statement], used: &BTreeSet<Symbol>, diagnostics: &mut Vec<Diagnostic>) {
    let mut context = Context { rig, statements, used, numbers: Numbers::new(rig) };
    let error = |d: &Diagnostic| d.severity == Severity::Error;
    // a statement that could not be read, or a name that means nothing, may be the very thing that seems to be missing
    let complete = !diagnostics.iter().any(|d| {
        error(d) && (d.code < "E0200" || matches!(d.code, "E0104" | "E0105" | "E0201" | "E0202" | "E0203" | "E0207" | "E0208" | "E0307"))
    });
    values::check(&context, diagnostics);
    signs::check(&context, diagnostics);
    inertia::check(&context, diagnostics);
    kinetic::check(&context, diagnostics);
    // an equation that was left out would have used its coordinate
    let written = statements.iter().filter(|s| s.keyword == "equation").count();
    if complete && written == rig.equations.len() {
        let unused = unused::coordinates(&context, diagnostics);
        // equations are solved for accelerations with what `set` assumes
        context.numbers = Numbers::assumed(rig);
        motion::check(&context, &unused, diagnostics);
    }
    if !diagnostics.iter().any(error) {
        unused::check(&context, diagnostics);
    }
}

/// A number for people: four digits, without trailing zeros.
fn shown(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let size = x.abs().log10().floor();
    if (-4.0..6.0).contains(&size) {
        let digits = (3.0 - size).max(0.0) as usize;
        let text = format!("{x:.digits$}");
        return if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text };
    }
    format!("{x:.3e}")
}
