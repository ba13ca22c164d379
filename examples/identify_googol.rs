//! Identification on a checked-in model: eq. 16 of the seed paper on its open-loop record, the initial rates free.
//!
//! `RIG_DATA=<folder of records> cargo run --release -p ident --example identify_googol [RECORD.toml] [REPEATS]`
//!
//! The program needs no rig file and no derivation: `generated::googol_identified` is a model like any other. With the
//! weights below the cost is the one that SciPy's least squares over a CasADi model find.

use generated::googol_identified::GoogolIdentified;
use ident::fit::{FitError, FitOptions, InitialStates, Known, ParameterSpec, Starting, Weights, identify, select};
use std::path::PathBuf;

fn main() {
    if let Err(message) = run() {
        eprintln!("{message}");
        std::process::exit(1);
    }
}

fn run() -> Result<(), String> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments
        .next()
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../examples/records/googol_open_loop_steps.toml"), PathBuf::from);
    let repeats: usize = match arguments.next() {
        Some(text) => text.parse().map_err(|_| format!("`{text}` is no number of repeats"))?,
        None => 1,
    };
    let record = ident::record::read(&path).map_err(|e| e.to_string())?;
    let refused = |e: FitError| e.to_string();

    let free = ["a1", "a2", "a3", "b2", "b3", "c_psi", "c_eps", "c_theta"].map(str::to_owned);
    let mut specs = ParameterSpec::of_model(&GoogolIdentified);
    select(&mut specs, Some(&free), &[]).map_err(refused)?;
    if let Some(c_eps) = specs.iter_mut().find(|s| s.name == "c_eps") {
        c_eps.value = 0.10;
    }
    let scales = [("psi", 1.0), ("eps", 0.1), ("theta", 0.03)].map(|(name, scale)| (name.to_owned(), scale));
    let options = FitOptions {
        weights: Weights::Given(scales.to_vec()),
        initial: Some(InitialStates { coordinates: Known::Fixed, rates: Known::Free }),
        starting: Starting::Nominal,
        ..FitOptions::default()
    };
    let records = [record];
    let mut fit = identify(&GoogolIdentified, &specs, &records, &[], &options).map_err(refused)?;
    let mut seconds = (fit.search_seconds, fit.seconds);
    for _ in 1..repeats {
        fit = identify(&GoogolIdentified, &specs, &records, &[], &options).map_err(refused)?;
        seconds = (seconds.0.min(fit.search_seconds), seconds.1.min(fit.seconds));
    }

    println!("{}; cost {:.4} after {} evaluations, {} start", fit.ending, fit.cost, fit.evaluations, fit.started_from);
    for e in &fit.parameters {
        println!("  {:8} {:10.5} +- {:.5} {}", e.name, e.value, e.std_error.unwrap_or(f64::NAN), e.unit);
    }
    for s in fit.initial_states.iter().filter(|s| s.free) {
        println!("  {:8} {:10.5} at the first sample", s.state, s.value);
    }
    for s in fit.train.iter().flat_map(|r| &r.signals) {
        println!("  {:8} fit {:.2} %", s.signal, s.fit_percent.unwrap_or(f64::NAN));
    }
    let (search, all) = seconds;
    println!(
        "search {:.1} ms, with intervals, whiteness and figures {:.1} ms (best of {repeats}); steps {:?}",
        1e3 * search,
        1e3 * all,
        fit.patterns
    );
    Ok(())
}
