//! Output error and innovations on records that a random torque drives, seeded.
//!
//! `cargo run --release -p cross-checks --example driven [-- RUNS [SEED]]`

use cross_checks::driven::{EXPERIMENTS, FORCE, TIME, study};

fn main() {
    let number = |at: usize, otherwise: u64| std::env::args().nth(at).and_then(|a| a.parse().ok()).unwrap_or(otherwise);
    let (runs, seed) = (number(1, 100) as usize, number(2, 7));
    println!("{runs} random parameter sets, seed {seed}; random torque of {FORCE} N m, correlated over {TIME} s");
    for experiment in &EXPERIMENTS {
        let (outputs, filtered, forces) = study(experiment, runs, seed, true);
        println!("{}\n  output error: {}\n  innovations:  {}", experiment.name, outputs.line(), filtered.line());
        let holds = |ci: Option<(f64, f64)>, truth: f64| usize::from(ci.is_some_and(|(lo, hi)| lo < truth && truth < hi));
        let covered = forces.iter().fold((0, 0), |(s, t), f| (s + holds(f.sd.ci95, FORCE), t + holds(f.time.ci95, TIME)));
        println!(
            "  random torque: {} fits, standard deviation covered {}, correlation time covered {}",
            forces.len(),
            covered.0,
            covered.1
        );
    }
}
