//! `cargo xtask oracle [--check | --riccati] [--python PROGRAM]`: the declared rigs, derived by CasADi.
//!
//! Writes each rig's declared JSON to the target folder, runs `tests/oracle/derive.py` on it (which sees nothing
//! else) and keeps the numbers in `tests/oracle/data`. `--check` compares anew computed numbers with those that
//! stand there. `--riccati` runs `tests/oracle/riccati.py` instead, which writes `tests/oracle/riccati.json` (it needs
//! `requirements-riccati.txt`, and minutes). None of the numbers comes from our own derivation.

use codegen::emit::{declared, declared_fingerprint};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// Relative difference up to which numbers computed anew are those that stand there.
const TOLERANCE: f64 = 1e-10;
/// The same for gains, which come out of a Riccati equation.
const GAINS: f64 = 1e-7;

/// Runs the task.
pub fn run(arguments: &[String]) -> Result<String, String> {
    let (mut check, mut riccati) = (false, false);
    let mut python = "python3".to_owned();
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        match argument.as_str() {
            "--check" => check = true,
            "--riccati" => riccati = true,
            "--python" => python = rest.next().ok_or("`--python` wants a program")?.clone(),
            other => return Err(format!("`{other}` is not known; usage: cargo xtask oracle [--check | --riccati] [--python PROGRAM]")),
        }
    }
    let root = crate::root();
    if riccati {
        return if check {
            Err("`--riccati` writes its file anew; compare it by `git diff`".to_owned())
        } else {
            run_riccati(&root, &python)
        };
    }
    let data = root.join("tests/oracle/data");
    let work = root.join("target/oracle");
    for folder in [&data, &work] {
        std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    let jobs = rigs(&root)?.iter().map(|path| Job::prepare(path, &work)).collect::<Result<Vec<_>, _>>()?;
    let mut names = BTreeSet::new();
    for job in &jobs {
        if !names.insert(job.name.clone()) {
            return Err(format!("two rig files are called {}.rig; rename one", job.name));
        }
    }
    derive_all(&jobs, &python, &root.join("tests/oracle/derive.py"))?;
    let mut faults = Vec::new();
    let mut notes = Vec::new();
    for job in &jobs {
        let kept = data.join(format!("{}.json", job.name));
        if check {
            match compare(job, &kept) {
                Ok(None) => {}
                Ok(Some(note)) => notes.push(note),
                Err(fault) => faults.push(fault),
            }
        } else {
            std::fs::copy(&job.result, &kept).map_err(|e| format!("{}: {e}", kept.display()))?;
        }
    }
    for stale in left_over(&data, &names)? {
        if check {
            faults.push(format!("{} belongs to no rig", stale.display()));
        } else {
            std::fs::remove_file(&stale).map_err(|e| format!("{}: {e}", stale.display()))?;
        }
    }
    notes.dedup();
    if !faults.is_empty() {
        return Err(format!("{}\nrun `cargo xtask oracle` to write the numbers anew, and read what changed", faults.join("\n")));
    }
    notes.insert(0, format!("oracle: {} rigs derived by CasADi, {}", jobs.len(), if check { "no drift" } else { "numbers written" }));
    Ok(notes.join("\n"))
}

/// Writes the answers for Riccati equations anew.
fn run_riccati(root: &Path, python: &str) -> Result<String, String> {
    let status = Command::new(python)
        .arg(root.join("tests/oracle/riccati.py"))
        .stdin(Stdio::null())
        .status()
        .map_err(|e| format!("cannot run `{python}`: {e}; name a Python with tests/oracle/requirements-riccati.txt by `--python`"))?;
    if status.success() { Ok("oracle: tests/oracle/riccati.json written".to_owned()) } else { Err("riccati.py failed".to_owned()) }
}

/// Files of all rigs that the oracle covers, in order.
fn rigs(root: &Path) -> Result<Vec<PathBuf>, String> {
    let mut paths = Vec::new();
    for folder in ["examples/rigs", "tests/rigs/pass", "tests/rigs/statements"] {
        let Ok(entries) = std::fs::read_dir(root.join(folder)) else { continue };
        paths.extend(entries.flatten().map(|e| e.path()).filter(|p| p.extension().is_some_and(|x| x == "rig")));
    }
    if paths.is_empty() {
        return Err("no rigs found under examples/rigs".to_owned());
    }
    paths.sort();
    Ok(paths)
}

struct Job {
    name: String,
    fingerprint: String,
    declared: PathBuf,
    result: PathBuf,
}

impl Job {
    /// Checks the rig and writes its declared JSON.
    fn prepare(path: &Path, work: &Path) -> Result<Self, String> {
        let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
        let Some(rig) = checked.rig else {
            let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
            return Err(format!("{} is wrong:\n{}", path.display(), shown.join("\n")));
        };
        let name = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let value = declared(&rig);
        let job = Self {
            fingerprint: declared_fingerprint(&value),
            declared: work.join(format!("{name}.declared.json")),
            result: work.join(format!("{name}.result.json")),
            name,
        };
        std::fs::write(&job.declared, value.to_string()).map_err(|e| format!("{}: {e}", job.declared.display()))?;
        Ok(job)
    }
}

/// Runs the Python program on every rig, as many at a time as there are cores.
fn derive_all(jobs: &[Job], python: &str, program: &Path) -> Result<(), String> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let mut waiting = jobs.iter();
    let mut running: Vec<(&Job, Child)> = Vec::new();
    loop {
        while running.len() < cores
            && let Some(job) = waiting.next()
        {
            let child = Command::new(python)
                .arg(program)
                .args([&job.declared, &job.result])
                // one rig is small: threads of the linear algebra would only get in each other's way
                .env("OPENBLAS_NUM_THREADS", "1")
                .stdin(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .map_err(|e| format!("cannot run `{python}`: {e}; name a Python with tests/oracle/requirements.txt by `--python`"))?;
            running.push((job, child));
        }
        if running.is_empty() {
            return Ok(());
        }
        let (job, child) = running.remove(0);
        let output = child.wait_with_output().map_err(|e| format!("{}: {e}", job.name))?;
        if !output.status.success() {
            for (_, mut other) in running {
                let _ = other.kill();
                let _ = other.wait();
            }
            return Err(format!("derive.py failed on {}:\n{}", job.name, String::from_utf8_lossy(&output.stderr)));
        }
    }
}

/// Compares a result with the kept one; a note where only the CasADi version differs.
fn compare(job: &Job, kept: &Path) -> Result<Option<String>, String> {
    let mut old = read(kept)?;
    let mut new = read(&job.result)?;
    if old["declared"] != job.fingerprint.as_str() {
        return Err(format!("{} belongs to another state of the rig", kept.display()));
    }
    let (gains_were, gains_are) = (gains(&mut old), gains(&mut new));
    let pairs = [
        ("states", &old["states"], &new["states"], TOLERANCE),
        ("trims", &old["trims"], &new["trims"], TOLERANCE),
        ("gains", &gains_were, &gains_are, GAINS),
    ];
    for (part, old, new, tolerance) in pairs {
        let mut worst = (0.0, String::new());
        difference(old, new, part, 0.0, &mut worst)?;
        if worst.0 > tolerance {
            return Err(format!("{}: {} has drifted by {:.1e} (relative)", job.name, worst.1, worst.0));
        }
    }
    let (was, is) = (&old["casadi"], &new["casadi"]);
    Ok((was != is).then(|| format!("kept numbers are from CasADi {was}, these from {is}")))
}

/// Takes the gains out of a result.
fn gains(result: &mut Value) -> Value {
    let trims = result["trims"].as_array_mut();
    trims.into_iter().flatten().filter_map(|trim| trim.as_object_mut()).map(|trim| trim.remove("K").unwrap_or_default()).collect()
}

fn read(path: &Path) -> Result<Value, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    serde_json::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))
}

/// Largest difference of two trees of numbers, each relative to the largest number of its quantity.
fn difference(old: &Value, new: &Value, place: &str, size: f64, worst: &mut (f64, String)) -> Result<(), String> {
    match (old, new) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap_or(f64::NAN), b.as_f64().unwrap_or(f64::NAN));
            let size = size.max(a.abs());
            let d = if a == b { 0.0 } else { (a - b).abs() / size };
            if d.is_nan() || d > worst.0 {
                *worst = (if d.is_nan() { f64::INFINITY } else { d }, place.to_owned());
            }
            Ok(())
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            let size = size.max(largest(old));
            a.iter().zip(b).enumerate().try_for_each(|(k, (x, y))| difference(x, y, &format!("{place}/{k}"), size, worst))
        }
        (Value::Object(a), Value::Object(b)) if a.keys().eq(b.keys()) => {
            // at an operating point rates are rounding itself and states may be: below one they count as they stand; a
            // quantity whose terms cancel is rounding too, far below any inertia or force of a rig
            let least = |k: &str| if place.starts_with("trims") && ["x", "u", "rates", "residual"].contains(&k) { 1.0 } else { 1e-6 };
            a.iter().zip(b).try_for_each(|((k, x), (_, y))| difference(x, y, &format!("{place}/{k}"), least(k), worst))
        }
        _ if old == new => Ok(()),
        _ => Err(format!("{place} has another shape than it had")),
    }
}

/// Largest number of a matrix or vector; a list of objects has none.
fn largest(value: &Value) -> f64 {
    match value {
        Value::Number(x) => x.as_f64().unwrap_or(0.0).abs(),
        Value::Array(list) => list.iter().map(largest).fold(0.0, f64::max),
        _ => 0.0,
    }
}

/// Kept files whose rig is gone.
fn left_over(data: &Path, names: &BTreeSet<String>) -> Result<Vec<PathBuf>, String> {
    let entries = std::fs::read_dir(data).map_err(|e| format!("{}: {e}", data.display()))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|e| e.path()).filter(|p| p.extension().is_some_and(|x| x == "json")).collect();
    paths.retain(|p| p.file_stem().is_none_or(|s| !names.contains(s.to_string_lossy().as_ref())));
    paths.sort();
    Ok(paths)
}
