//! CasADi on the same models: a virtual environment with a pinned version, and `casadi_peer.py` run in it.

use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// The version that is compared.
const CASADI: &str = "casadi==3.8.2";

/// Figures of one way in which CasADi is used.
pub struct Way {
    /// Operations of x', and of A and B.
    pub operations: [u64; 2],
    /// Compiling both with gcc -O3 -march=native [s].
    pub gcc_s: f64,
    /// Time per call of x', and of A and B [ns].
    pub call_ns: [f64; 2],
}

/// Figures of CasADi for one model.
pub struct Peer {
    /// Deriving from the Lagrangian [s].
    pub derive_s: f64,
    /// As its users write the model.
    pub users: Way,
    /// Given the equations that this project derives.
    pub ours: Way,
    /// Largest relative difference of the two in x', A and B.
    pub difference: f64,
}

/// Measures the models whose `<model>_export.py` stand in `folder`.
///
/// # Errors
/// Which of the programs python3, pip, gcc failed, and what it said.
pub fn measure(folder: &Path, script: &Path, models: &[&str]) -> Result<Vec<Peer>, String> {
    let python = environment(folder)?;
    let mut command = Command::new(python);
    command.arg(script).arg(folder).args(models);
    let out = run(&mut command)?;
    out.lines().map(|line| peer(line).ok_or_else(|| format!("{} printed something else than figures: {line}", script.display()))).collect()
}

/// Python of a virtual environment with CasADi, made where it is missing.
fn environment(folder: &Path) -> Result<std::path::PathBuf, String> {
    let home = folder.join("venv");
    let python = home.join("bin/python");
    let wanted = format!("import casadi, sys; sys.exit(casadi.__version__ != {:?})", CASADI.trim_start_matches("casadi=="));
    if Command::new(&python).args(["-c", &wanted]).output().is_ok_and(|o| o.status.success()) {
        return Ok(python);
    }
    run(Command::new("python3").args(["-m", "venv"]).arg(&home))?;
    run(Command::new(&python).args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", CASADI, "numpy"]))?;
    Ok(python)
}

fn run(command: &mut Command) -> Result<String, String> {
    let shown = format!("{command:?}");
    let out = command.output().map_err(|e| format!("{shown}: {e}"))?;
    if out.status.success() {
        Ok(String::from_utf8_lossy(&out.stdout).into_owned())
    } else {
        Err(format!("{shown} failed:\n{}", String::from_utf8_lossy(&out.stderr)))
    }
}

fn peer(line: &str) -> Option<Peer> {
    let figures: Value = serde_json::from_str(line).ok()?;
    let way = |name: &str| {
        let way = figures.get(name)?;
        Some(Way {
            operations: [way.get("f_ops")?.as_u64()?, way.get("jacobians_ops")?.as_u64()?],
            gcc_s: way.get("gcc_s")?.as_f64()?,
            call_ns: [way.get("f_ns")?.as_f64()?, way.get("jacobians_ns")?.as_f64()?],
        })
    };
    Some(Peer {
        derive_s: figures.get("derive_s")?.as_f64()?,
        users: way("users")?,
        ours: way("ours")?,
        difference: figures.get("difference")?.as_f64()?,
    })
}
