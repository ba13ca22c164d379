//! One file a subcommand.

mod base_parameters;
mod check;
mod closed_loop;
mod compare;
mod demo;
mod diagnose;
mod diff;
mod draw;
mod equation_error;
mod eval;
mod excite;
mod export;
mod fit_map;
mod generate;
mod identify;
mod innovations;
pub mod linearize;
mod lqr;
mod new;
mod preflight;
mod show;
mod simulate;
mod snapshot;
mod trim;

use crate::args::{Arguments, Command};
use crate::failure::Failure;
use crate::output::Answer;
use codegen::{CrossCheck, Equations};

/// Runs what was asked for.
pub fn run(arguments: Arguments) -> Result<Answer, Failure> {
    match arguments.command {
        Command::BaseParameters(a) => base_parameters::run(&a),
        Command::Check(a) => check::run(&a),
        Command::Show(a) => show::run(&a),
        Command::Draw(a) => draw::run(&a),
        Command::Eval(a) => eval::run(&a),
        Command::Diff(a) => diff::run(&a),
        Command::Diagnose(a) => diagnose::run(&a),
        Command::Demo(a) => demo::run(&a),
        Command::Generate(a) => generate::run(&a),
        Command::Export(a) => export::run(&a),
        Command::Trim(a) => trim::run(&a),
        Command::Linearize(a) => linearize::run(&a),
        Command::Identify(a) => identify::run(&a),
        Command::Lqr(a) => lqr::run(&a),
        Command::Snapshot(a) => snapshot::run(&a),
        Command::Simulate(a) => simulate::run(&a),
        Command::ClosedLoop(a) => closed_loop::run(&a),
        Command::Compare(a) => compare::run(&a),
        Command::Preflight(a) => preflight::run(&a),
        Command::New(a) => new::run(&a),
        Command::Excite(a) => excite::run(&a),
        Command::FitMap(a) => fit_map::run(&a),
    }
}

/// How the derivation was checked, in one sentence.
pub fn verdict(equations: &Equations) -> &'static str {
    match equations.cross_check {
        CrossCheck::Agree { .. } => "Derived twice, agree; energy balance holds.",
        CrossCheck::NotApplicable => "Equations written directly: no second derivation, no energies.",
    }
}
