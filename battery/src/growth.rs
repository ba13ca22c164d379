//! What a diagnosis costs as samples and candidates grow: the 3-DOF helicopter with dry friction on its elevation that the text lacks. Each
//! case runs in a process of its own, so that its peak of memory is its own.

use crate::conditions::{NOTHING, experiment};
use crate::rigs::Rig;
use crate::run::record;
use crate::truth::experiment::Excitation;
use diagnose::effects::IDS;
use diagnose::{Options, Step, diagnose};
use ident::fit::ParameterSpec;
use serde::{Deserialize, Serialize};
use std::process::Command;

/// Samples of the training records together, and entries of the catalogue; all of them where there are this many.
const CASES: [(usize, usize); 7] = [(2_500, 32), (5_000, 32), (10_000, 32), (20_000, 32), (5_000, 8), (5_000, 16), (5_000, 24)];
/// Seed of the rig and its records.
const SEED: u64 = 5;

/// What one case took.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Cost {
    samples: usize,
    candidates: usize,
    /// Up to the end of the first screening, and to the end [s].
    seconds: [f64; 2],
    /// Largest resident memory [MB], where the machine tells.
    memory: Option<f64>,
    said: Vec<String>,
    verdict: String,
}

/// Makes one case in this process.
///
/// # Errors
/// What the diagnosis says.
pub fn case(samples: usize, entries: usize) -> Result<Cost, String> {
    let rig = Rig::Helicopter;
    let bench = rig.bench(SEED);
    let mut plant = bench.plant.clone();
    plant.joints[1].coulomb += 0.03 * bench.strong[1];
    let records: Vec<_> = [Excitation::Steps, Excitation::Sines, Excitation::Chirp]
        .into_iter()
        .zip(["steps", "sines", "chirp"])
        .enumerate()
        .map(|(k, (kind, name))| record(name, &experiment(&bench, &plant, &NOTHING[1], kind, samples / 2, SEED * 10 + k as u64), rig))
        .collect();
    let base = diagnose::patch::check(&[(format!("{}.rig", rig.name()), rig.text().to_owned())], rig.title()).map_err(|e| e.to_string())?;
    let specs = ParameterSpec::of_rig(&base.rig);
    let only: Vec<String> = IDS.iter().take(entries).map(|id| (*id).to_owned()).collect();
    let began = std::time::Instant::now();
    let run = |until: Step| {
        let options = Options { only: only.clone(), until, ..Options::default() };
        diagnose(&base, &specs, &records[..2], &records[2..], &options).map_err(|e| e.to_string())
    };
    run(Step::Screen)?;
    let screened = began.elapsed().as_secs_f64();
    let found = run(Step::Patch)?;
    let whole = began.elapsed().as_secs_f64() - screened;
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|l| l.strip_prefix("VmHWM:")?.trim().split(' ').next()?.parse::<f64>().ok());
    Ok(Cost {
        samples,
        candidates: found.candidates.len(),
        seconds: [screened, whole],
        memory: peak.map(|kilobytes| kilobytes / 1024.0),
        said: found.findings.iter().map(|f| format!("{} on {}", f.effect, f.place)).collect(),
        verdict: found.verdict.id().to_owned(),
    })
}

/// Runs all cases and prints them as Markdown.
///
/// # Errors
/// Where a case does not come to its end.
pub fn table() -> Result<String, String> {
    let program = std::env::current_exe().map_err(|e| e.to_string())?;
    let mut text = "| samples to learn from | candidates | s to the end of the first screening | s in all | MB | verdict, effects |\n|---|---|---|---|---|---|\n".to_owned();
    for (samples, entries) in CASES {
        let out = Command::new(&program)
            .args(["--growth-case", &samples.to_string(), &entries.to_string()])
            .output()
            .map_err(|e| format!("{}: {e}", program.display()))?;
        let cost: Cost = serde_json::from_slice(&out.stdout).map_err(|_| String::from_utf8_lossy(&out.stderr).into_owned())?;
        let memory = cost.memory.map_or_else(|| "-".to_owned(), |m| format!("{m:.0}"));
        text.push_str(&format!(
            "| {} | {} | {:.1} | {:.1} | {memory} | {}: {} |\n",
            cost.samples,
            cost.candidates,
            cost.seconds[0],
            cost.seconds[1],
            cost.verdict,
            cost.said.join(", ")
        ));
    }
    Ok(text)
}
