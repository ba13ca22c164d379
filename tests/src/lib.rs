//! Shared pieces of the cross-crate checks: where things lie, repeatable random numbers, random rigs.

pub mod bench_rig;
pub mod c_compiler;
pub mod c_program;
pub mod calls;
pub mod close;
pub mod coverage;
pub mod driven;
#[rustfmt::skip]
pub mod named;
pub mod odd_rigs;
pub mod random;
pub mod random_rig;
pub mod states;
pub mod trims;

use std::path::PathBuf;

/// The project's folder.
#[must_use]
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, PathBuf::from)
}

/// All rigs of `examples/rigs`, by name, in order.
#[must_use]
pub fn example_rigs() -> Vec<PathBuf> {
    rigs_in("examples/rigs")
}

/// All rigs that CasADi derives too, in order (the folders of `cargo xtask oracle`).
#[must_use]
pub fn oracle_rigs() -> Vec<PathBuf> {
    ["examples/rigs", "tests/rigs/pass", "tests/rigs/statements"].iter().flat_map(|folder| rigs_in(folder)).collect()
}

/// Rig files of a folder of the project, by name, in order; none where there is no such folder.
#[must_use]
pub fn rigs_in(folder: &str) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = std::fs::read_dir(root().join(folder))
        .map(|entries| entries.flatten().map(|e| e.path()).filter(|p| p.extension().is_some_and(|x| x == "rig")).collect())
        .unwrap_or_default();
    paths.sort();
    paths
}

/// Reads, checks and returns the rig of a file.
///
/// # Panics
/// Shows the diagnostics where the rig is wrong: this is for tests.
#[must_use]
pub fn rig_of(path: &std::path::Path) -> model_dsl::rig::Rig {
    let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
    let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    checked.rig.unwrap_or_else(|| panic!("{}:\n{}", path.display(), shown.join("\n")))
}

/// The folder of measured records and independent numbers, if the environment names it and it is there.
#[must_use]
pub fn record_folder() -> Option<PathBuf> {
    std::env::var_os("RIG_DATA").map(PathBuf::from).filter(|p| p.is_dir())
}
