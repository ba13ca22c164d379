//! Figures of speed, on the machine at hand: deriving, compiling in the process, evaluating; beside the generated
//! Rust, and beside CasADi as its users write the same models and given our equations.
//!
//! `cargo run --release -p bench -- [--no-casadi] [--no-rust] [--no-growth] [--instructions] [--steps]`. CasADi needs python3
//! (it is installed in an environment of its own below the target folder) and gcc; `--instructions`
//! and `--steps` need valgrind; `--steps` prints the growth of each step and nothing else.

mod calls;
mod casadi;
mod growth;
mod hand;
mod instructions;
mod ours;
mod rigs;
mod rust;
mod steps;
mod table;
mod timing;

use ours::Figures;
use runtime::Model;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use table::Table;

const USAGE: &str = "usage: bench [--no-casadi] [--no-rust] [--no-growth] [--instructions] [--steps]";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let result = match arguments.first() {
        Some(first) if first == instructions::REPEAT => instructions::repeat(&arguments[1..]),
        Some(first) if first == steps::STEP => steps::run(&arguments[1..]),
        _ => run(&arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<(), String> {
    // cargo bench adds a flag of its own
    let known = ["--no-casadi", "--no-rust", "--no-growth", "--instructions", "--steps", "--bench"];
    if let Some(unknown) = arguments.iter().find(|a| !known.contains(&a.as_str())) {
        return Err(format!("{unknown}: {USAGE}"));
    }
    let asked = |flag: &str| arguments.iter().any(|a| a == flag);
    if asked("--steps") {
        print!("{}", steps::table()?);
        return Ok(());
    }
    let bench = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let folder = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| bench.join("../target"), PathBuf::from).join("bench");
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;

    let mut figures = Vec::new();
    let mut equations = Vec::new();
    for (name, text) in rigs::COMPARED {
        let (f, e) = ours::measure(&rigs::check(name, text)?, 20)?;
        let module = folder.join(format!("{name}_export.py"));
        std::fs::write(&module, codegen::emit::casadi(&e)).map_err(|e| format!("{}: {e}", module.display()))?;
        figures.push(f);
        equations.push((name, e));
    }
    let models: Vec<(&str, &codegen::Equations)> = equations.iter().map(|(name, e)| (*name, e)).collect();
    let rust = if asked("--no-rust") { None } else { Some(rust::measure(&folder, &bench, &models)?) };
    let peers = if asked("--no-casadi") { None } else { Some(peers(&folder, &bench)?) };
    print!("{}", calls_table(&figures, rust.as_deref(), peers.as_deref()));
    println!("\n{}", hand_written(&figures[0], rust.as_deref())?);
    print!("\n{}", making_table(&figures, rust.as_deref(), peers.as_deref()));
    if asked("--instructions") {
        println!("\ninstructions per call in the process, x' and [x', A, B]:");
        for (name, _) in rigs::COMPARED {
            let [forward, linear] = instructions::per_call(name)?;
            println!("  {name:<9} {forward:>7.0} {linear:>7.0}");
        }
    }
    if !asked("--no-growth") {
        print!("\n{}", growth::table()?);
    }
    Ok(())
}

fn peers(folder: &Path, bench: &Path) -> Result<Vec<casadi::Peer>, String> {
    let names = rigs::COMPARED.map(|(name, _)| name);
    let peers = casadi::measure(folder, &bench.join("casadi_peer.py"), &names)?;
    for (name, peer) in names.iter().zip(&peers) {
        // the two derive on their own; rounding of different orders of summation stays far below
        if peer.difference > 1e-9 {
            return Err(format!("{name}: CasADi's own derivation and ours differ by {:.1e}", peer.difference));
        }
    }
    Ok(peers)
}

/// Time per call. CasADi's [A, B] are compared with our x', A and B together.
fn calls_table(figures: &[Figures], rust: Option<&[rust::Generated]>, peers: Option<&[casadi::Peer]>) -> Table {
    let mut table = Table::new(
        "time per call [ns], least of many batches; in brackets CasADi's time over that of our generated Rust (or in process)",
        &["model", "what", "ops", "interpreted", "in process", "Rust", "CasADi ops", "CasADi", "", "CasADi, our equations", ""],
    );
    for (k, (name, _)) in rigs::COMPARED.iter().enumerate() {
        for (w, what) in ["x'", "[A, B]"].into_iter().enumerate() {
            let own = figures[k].call_ns[w];
            let generated = rust.map(|r| r[k].call_ns[w]);
            let best = generated.unwrap_or(own);
            let mut row = vec![(*name).to_owned(), what.to_owned(), figures[k].operations[w].to_string()];
            row.extend([figures[k].interpreted_ns[w], own].map(|ns| format!("{ns:.0}")));
            row.push(generated.map_or_else(String::new, |ns| format!("{ns:.0}")));
            if let Some(peer) = peers.map(|p| &p[k]) {
                row.push(peer.users.operations[w].to_string());
                for way in [&peer.users, &peer.ours] {
                    row.push(format!("{:.0}", way.call_ns[w]));
                    row.push(format!("({:.2})", way.call_ns[w] / best));
                }
            }
            table.row(row);
        }
    }
    table
}

fn making_table(figures: &[Figures], rust: Option<&[rust::Generated]>, peers: Option<&[casadi::Peer]>) -> Table {
    let mut table = Table::new(
        "making the model",
        &[
            "model",
            "derive [ms]",
            "compile x' [ms]",
            "[A, B] [ms]",
            "Rust [lines]",
            "cargo build [s]",
            "CasADi derive [s]",
            "gcc [s]",
            "gcc, our equations [s]",
        ],
    );
    for (k, (name, _)) in rigs::COMPARED.iter().enumerate() {
        let f = &figures[k];
        let mut row =
            vec![(*name).to_owned(), format!("{:.1}", f.derive_ms), format!("{:.1}", f.compile_ms[0]), format!("{:.1}", f.compile_ms[1])];
        row.extend(rust.map_or_else(|| vec![String::new(); 2], |r| vec![r[k].lines.to_string(), format!("{:.1}", r[k].build_s)]));
        if let Some(p) = peers.map(|p| &p[k]) {
            row.extend([format!("{:.2}", p.derive_s), format!("{:.1}", p.users.gcc_s), format!("{:.1}", p.ours.gcc_s)]);
        }
        table.row(row);
    }
    table
}

/// The helicopter's forward dynamics by hand: the limit of the machine, and a check of what was derived.
fn hand_written(figures: &Figures, rust: Option<&[rust::Generated]>) -> Result<String, String> {
    let (name, text) = rigs::COMPARED[0];
    let model = jit::InProcess::new(rigs::equations(&rigs::check(name, text)?)?);
    let calls::Point { x, u, p } = calls::Point::of(&model);
    let wrong = |_| "heli3 has other sizes than the function written by hand".to_owned();
    let (mut x, u, p): ([f64; 6], [f64; 2], [f64; 16]) =
        (x.try_into().map_err(wrong)?, u.try_into().map_err(wrong)?, p.try_into().map_err(wrong)?);
    let mut derived = [0.0; 6];
    model.rhs(0.0, &x, &u, &p, &mut derived).map_err(|_| "heli3 is singular")?;
    let by_hand = hand::heli3(&x, &u, &p);
    let difference = derived.iter().zip(by_hand).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs() / a.abs()));
    if difference.is_nan() || difference >= 1e-12 {
        return Err(format!("heli3 by hand and as derived differ by {difference:.1e}: {by_hand:?}, {derived:?}"));
    }
    let start = x[0];
    let ns = timing::per_call(|change| {
        x[0] = start + change;
        black_box(hand::heli3(black_box(&x), black_box(&u), black_box(&p)));
    });
    let generated = rust.map_or_else(String::new, |r| format!(", generated Rust {:.1}", r[0].call_ns[0]));
    Ok(format!("heli3 x' written by hand {ns:.1} ns{generated}, in process {:.1} (values agree to {difference:.0e})", figures.call_ns[0]))
}
