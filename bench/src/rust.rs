//! The generated Rust of the same models: written to a package of its own, compiled and run, as CasADi's C is.

use codegen::Equations;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Figures of one model's generated Rust.
pub struct Generated {
    /// Lines of source.
    pub lines: usize,
    /// `cargo build --release` of the one model, its dependency built before [s].
    pub build_s: f64,
    /// Time per call of x', and of x' with A and B [ns].
    pub call_ns: [f64; 2],
}

/// Writes, compiles and runs the models.
///
/// # Errors
/// What could not be written, and what cargo says.
pub fn measure(folder: &Path, bench: &Path, models: &[(&str, &Equations)]) -> Result<Vec<Generated>, String> {
    let package = folder.join("rust");
    let write = |path: &str, text: &str| {
        let place = package.join(path);
        if let Some(parent) = place.parent() {
            std::fs::create_dir_all(parent).map_err(|e| format!("{}: {e}", parent.display()))?;
        }
        std::fs::write(&place, text).map_err(|e| format!("{}: {e}", place.display()))
    };
    let runtime = bench.join("../runtime");
    write(
        "Cargo.toml",
        &format!(
            "[package]\nname = \"measured\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\n\
             runtime = {{ path = {:?}, features = [\"std\"] }}\n",
            runtime.display().to_string()
        ),
    )?;
    // the lock file of the workspace holds the versions; cargo drops what is not needed
    std::fs::copy(bench.join("../Cargo.lock"), package.join("Cargo.lock")).map_err(|e| format!("Cargo.lock: {e}"))?;
    write("src/lib.rs", "//! The bench's generated models are its programs.\n")?;
    let mut lines = Vec::new();
    for (name, equations) in models {
        let source = codegen::emit::rust(equations, &format!("{name}.rig"));
        lines.push(source.lines().count());
        write(&format!("src/{name}.rs"), &source)?;
        write(
            &format!("src/bin/measure_{name}.rs"),
            &format!(
                "#[path = \"../{name}.rs\"]\n#[allow(dead_code)]\nmod model;\n#[path = {:?}]\n#[allow(dead_code)]\nmod timing;\n#[path = {:?}]\n\
                 #[allow(dead_code)]\nmod calls;\n\nfn main() {{\n    let figures = calls::both(&model::{});\n    println!(\"{{}} {{}}\", figures[0], figures[1]);\n}}\n",
                bench.join("src/timing.rs").display().to_string(),
                bench.join("src/calls.rs").display().to_string(),
                // these rigs' names are names in Rust as they stand
                equations.layout.rig
            ),
        )?;
    }
    let target = package.join("target");
    let cargo = |arguments: &[&str]| {
        let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        command.current_dir(&package).args(arguments).arg("--quiet").env("CARGO_TARGET_DIR", &target);
        // as CasADi's C: for this machine
        command.env("RUSTFLAGS", "-C target-cpu=native");
        let out = command.output().map_err(|e| format!("{command:?}: {e}"))?;
        if out.status.success() {
            Ok(String::from_utf8_lossy(&out.stdout).into_owned())
        } else {
            Err(format!("{command:?} failed:\n{}", String::from_utf8_lossy(&out.stderr)))
        }
    };
    cargo(&["build", "--release", "--lib"])?;
    let mut figures = Vec::new();
    for ((name, _), lines) in models.iter().zip(lines) {
        let program = format!("measure_{name}");
        // a file that is newer than its product is compiled again, so that every run measures
        let _ = std::fs::remove_file(target.join("release").join(&program));
        let touched = package.join(format!("src/{name}.rs"));
        let text = std::fs::read(&touched).map_err(|e| format!("{}: {e}", touched.display()))?;
        std::fs::write(&touched, text).map_err(|e| format!("{}: {e}", touched.display()))?;
        let start = Instant::now();
        cargo(&["build", "--release", "--bin", &program])?;
        let build_s = start.elapsed().as_secs_f64();
        let out = cargo(&["run", "--release", "--bin", &program])?;
        let numbers: Vec<f64> = out.split_whitespace().filter_map(|s| s.parse().ok()).collect();
        let [forward, linear] = numbers[..] else { return Err(format!("{program} printed {out:?}")) };
        figures.push(Generated { lines, build_s, call_ns: [forward, linear] });
    }
    Ok(figures)
}
