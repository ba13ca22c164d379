//! `rig draw` as its users run it.

use std::path::{Path, PathBuf};
use std::process::Command;

fn run(arguments: &[&str]) -> (bool, String) {
    let rigs = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, |p| p.join("examples/rigs"));
    let output = Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(rigs).args(arguments).output().expect("the program starts");
    (output.status.success(), format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr)))
}

#[test]
fn draws_a_trim_and_says_where_it_stands() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("raised.svg");
    let _ = std::fs::remove_file(&out);
    let path = out.display().to_string();
    let (done, said) = run(&["draw", "quanser.rig", "--trim", "raised", "--out", &path]);
    assert!(done && said.contains("elevation = 0.175 rad"), "{said}");
    let svg = std::fs::read_to_string(&out).expect("written");
    assert!(svg.starts_with("<svg") && svg.contains("elevation = 0.175 rad"), "{svg}");
    // drawn again at another pose, it replaces its own file
    let (done, said) = run(&["draw", "quanser.rig", "--at", "pitch=20deg", "--at", "V_s=0", "--at", "V_d=0", "--out", &path]);
    assert!(done && said.contains("pitch = 0.349 rad"), "{said}");
}

#[test]
fn what_has_no_geometry_is_told() {
    let (done, said) = run(&["draw", "googol_identified.rig", "--out", "nowhere.svg"]);
    assert!(!done && said.contains("C0601") && said.contains("no geometry"), "{said}");
}
