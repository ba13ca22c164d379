//! The command line: what can be asked, and how; each command's own arguments stand in `args/`. Wrong usage ends with
//! exit code 2.

mod base_parameters;
mod closed_loop;
mod compare;
mod demo;
mod diagnose;
mod diff;
mod draw;
mod eval;
mod excite;
mod export;
mod fit_map;
mod generate;
mod identify;
mod linearize;
mod lqr;
mod new;
mod preflight;
mod show;
mod simulate;
mod snapshot;
mod trim;

pub use base_parameters::BaseParameters;
pub use closed_loop::ClosedLoop;
pub use compare::Compare;
pub use demo::Demo;
pub use diagnose::{Diagnose, Steps};
pub use diff::Diff;
pub use draw::Draw;
pub use eval::Eval;
pub use excite::{Excite, Shape};
pub use export::{Export, Target};
pub use fit_map::FitMap;
pub use generate::Generate;
pub use identify::{Derivative, Identify, Method};
pub use linearize::Linearize;
pub use lqr::Lqr;
pub use new::New;
pub use preflight::Preflight;
pub use show::Show;
pub use simulate::Simulate;
pub use snapshot::Snapshot;
pub use trim::Trim;

use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Rig text in, models out.
#[derive(Parser)]
#[command(name = "rig", version, about, max_term_width = 100)]
pub struct Arguments {
    /// One JSON document on standard output, and nothing else there.
    #[arg(long, global = true)]
    pub json: bool,
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// Subcommands.
#[derive(Subcommand)]
pub enum Command {
    /// Parse a rig; check names, units and mechanics.
    Check(File),
    /// Print the equations as a person writes them.
    Show(Show),
    /// Numbers at one state: M, bias, forces, accelerations, Jacobians.
    Eval(Eval),
    /// What one model has and the other lacks, term by term.
    Diff(Diff),
    /// Write the model as Rust or C.
    Generate(Generate),
    /// Write the declared rig (json) or the derived equations (casadi, latex).
    Export(Export),
    /// Find an operating point.
    Trim(Trim),
    /// Linear models at operating points.
    Linearize(Linearize),
    /// Linear-quadratic regulator at an operating point.
    Lqr(Lqr),
    /// Simulate a rig under inputs from a record.
    Simulate(Simulate),
    /// Simulate a rig under a sampled controller with encoders and limits, as a scenario file says.
    ClosedLoop(ClosedLoop),
    /// Lay free runs of rigs over a measured record.
    Compare(Compare),
    /// Facts and faults of measured records, before anything is fitted to them.
    Preflight(Preflight),
    /// Start a rig from a record's header, or from an example.
    New(New),
    /// Propose a first input within the limits, and say what it would tell.
    Excite(Excite),
    /// Fit a static map (voltage to thrust) to pairs, and invert it.
    FitMap(FitMap),
    /// Fit a rig's parameters to measured records.
    Identify(Identify),
    /// Find where simulation and record disagree, name the missing effect, and show the gap shrink.
    Diagnose(Diagnose),
    /// The fewest combinations of parameters that the equations depend on, and relations between lumps.
    BaseParameters(BaseParameters),
    /// Draw the tree of frames and bodies at a pose, as SVG.
    Draw(Draw),
    /// Keep equations, operation counts and linear models beside a rig, and show what a change did.
    Snapshot(Snapshot),
    /// The whole chain on a rig and a record that the program carries with it.
    Demo(Demo),
}

/// A rig file and changes of its parameters.
#[derive(Args, Clone)]
pub struct File {
    /// The rig (`.rig`).
    pub file: PathBuf,
    /// Which rig of the file (default: the last one).
    #[arg(long, value_name = "NAME")]
    pub rig: Option<String>,
    /// Override a parameter: `name=value`, with an optional unit (`theta0=5deg`).
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Use the definitions behind lumps instead of their own values.
    #[arg(long)]
    pub expand_lumps: bool,
}

/// An operating point.
#[derive(Args, Clone)]
pub struct Point {
    /// Named trim of the rig (default: its first one).
    #[arg(long, value_name = "NAME")]
    pub trim: Option<String>,
    /// A coordinate, rate or input of the operating point. Giving what the trim would solve for takes
    /// the point as it is, without solving.
    #[arg(long = "at", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub at: Vec<String>,
}

/// What a logged input does between its samples.
#[derive(Clone, Copy, ValueEnum)]
pub enum Hold {
    /// Keeps the last sample, as a digital-to-analogue converter does.
    Zero,
    /// Goes straight from sample to sample.
    First,
}

impl From<Hold> for sim::Hold {
    fn from(hold: Hold) -> Self {
        match hold {
            Hold::Zero => Self::Zero,
            Hold::First => Self::First,
        }
    }
}

/// Languages of generated code.
#[derive(Clone, Copy, ValueEnum)]
pub enum Language {
    /// `no_std` Rust.
    Rust,
    /// C99.
    C,
}
