//! `rig`: the program. One file a subcommand; no mathematics here, all input and output here.

mod args;
mod commands;
mod control_change;
mod examples;
mod failure;
mod load;
mod operating;
mod output;
mod pages;
mod point;
mod scenario;
mod snapshot;
mod sweep;
mod workspace;
mod write;

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = args::Arguments::parse();
    let json = arguments.json;
    match commands::run(arguments) {
        Ok(answer) => {
            output::answer(&answer, json);
            ExitCode::SUCCESS
        }
        Err(failure) => {
            output::failure(&failure, json);
            ExitCode::from(1)
        }
    }
}
