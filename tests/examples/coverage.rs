//! How often 95 % intervals hold the truth: 100 random parameter sets of four rigs, seeded.
//!
//! `cargo run --release -p cross-checks --example coverage [-- RUNS [SEED [RIG]]]`

use cross_checks::coverage::{CASES, study};
use std::time::Instant;

fn main() {
    let number = |at: usize, otherwise: u64| std::env::args().nth(at).and_then(|a| a.parse().ok()).unwrap_or(otherwise);
    let (runs, seed) = (number(1, 100) as usize, number(2, 7));
    println!("{runs} random parameter sets a rig, seed {seed}; starting values off by a factor of two");
    println!(
        "{:18} {:>9} {:>9} {:>16} {:>9} {:>13} {:>12}   each parameter",
        "rig", "intervals", "covered", "95 % interval", "diverged", "worst error", "evaluations"
    );
    let only = std::env::args().nth(3);
    for case in CASES.iter().filter(|c| only.as_deref().is_none_or(|o| o == c.name)) {
        let began = Instant::now();
        let o = study(case, runs, seed);
        let (lo, hi) = o.share_interval();
        let each: Vec<String> =
            case.free.iter().zip(&o.covered).map(|(name, c)| format!("{name} {:.0}", 100.0 * *c as f64 / runs.max(1) as f64)).collect();
        println!(
            "{:18} {:>9} {:>7.1} % {:>7.1} .. {:>4.1} {:>9} {:>11.2} % {:>12.0}   {} ({:.1} s)",
            case.name,
            o.runs * o.covered.len(),
            100.0 * o.share(),
            100.0 * lo,
            100.0 * hi,
            o.diverged,
            100.0 * o.worst,
            o.evaluations as f64 / runs.max(1) as f64,
            each.join(", "),
            began.elapsed().as_secs_f64()
        );
    }
}
