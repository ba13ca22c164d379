//! Snapshots as their users run them: the example rigs are as theirs say, and a change of a rig is shown and fails.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}

fn rig(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(folder).args(arguments).output().expect("the program starts")
}

fn said(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder for the test");
    path
}

/// What a change of this program did to the example rigs is read here; meant ones are kept by `rig snapshot FILE`.
#[test]
fn every_example_rig_is_as_its_snapshot_says() {
    let rigs = root().join("examples/rigs");
    let mut names: Vec<String> = std::fs::read_dir(&rigs)
        .expect("example rigs")
        .flatten()
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .filter(|n| n.ends_with(".rig"))
        .collect();
    names.sort();
    assert!(names.len() >= 17, "{names:?}");
    let wrong: Vec<String> =
        names.iter().map(|n| rig(&rigs, &["snapshot", n, "--check"])).filter(|o| !o.status.success()).map(|o| said(&o)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_change_is_shown_term_by_term_and_fails() {
    let folder = folder("snapshot");
    let original = std::fs::read_to_string(root().join("examples/rigs/googol_mrb.rig")).expect("a rig");
    let base = std::fs::read_to_string(root().join("examples/rigs/googol.rig")).expect("a rig");
    std::fs::write(folder.join("googol.rig"), base).expect("written");
    let path = folder.join("googol_mrb.rig");
    std::fs::write(&path, &original).expect("written");
    let none = rig(&folder, &["snapshot", "googol_mrb.rig", "--check"]);
    assert!(none.status.code() == Some(1) && said(&none).contains("C0501"), "{}", said(&none));
    assert!(rig(&folder, &["snapshot", "googol_mrb.rig"]).status.success());
    assert!(rig(&folder, &["snapshot", "googol_mrb.rig", "--check"]).status.success());

    let changed = rig(&folder, &["snapshot", "googol_mrb.rig", "--check", "--json", "--set", "c0_eps=0.2"]);
    assert_eq!(changed.status.code(), Some(1));
    let document: Value = serde_json::from_slice(&changed.stdout).expect("one JSON document");
    assert_eq!(document["diagnostics"][0]["code"], "C0502");
    let changes = document["changes"].as_array().expect("changes");
    let has = |section: &str, was: &str, is: &str| {
        changes.iter().any(|c| c["section"] == section && c["was"][0].as_str() == Some(was) && c["is"][0].as_str() == Some(is))
    };
    assert!(has("parameters", "c0_eps = 0.0779 N*m*s", "c0_eps = 0.2 N*m*s"), "{changes:#?}");
    assert!(has("trim level", "eps'' by eps': -0.0530", "eps'' by eps': -0.1361"), "{changes:#?}");
    assert!(changes.iter().all(|c| c["section"] != "equations"), "a value is no term");

    // a term that is gone is seen in the equations
    std::fs::write(&path, original.replacen("neglect coriolis;", "neglect coriolis; neglect gravity in eps;", 1)).expect("written");
    let output = rig(&folder, &["snapshot", "googol_mrb.rig", "--check"]);
    assert!(output.status.code() == Some(1) && said(&output).contains("equations"), "{}", said(&output));
    assert!(said(&output).contains("m' g cos(eps)"), "{}", said(&output));
    // writing anew says what changed, and makes the check pass
    let anew = rig(&folder, &["snapshot", "googol_mrb.rig"]);
    assert!(anew.status.success() && said(&anew).contains("since its snapshot"), "{}", said(&anew));
    assert!(rig(&folder, &["snapshot", "googol_mrb.rig", "--check"]).status.success());
}

#[test]
fn a_file_of_somebody_else_is_not_overwritten() {
    let folder = folder("snapshot-foreign");
    std::fs::copy(root().join("examples/rigs/cart_pole.rig"), folder.join("cart_pole.rig")).expect("copied");
    std::fs::write(folder.join("cart_pole.snapshot.txt"), "my notes\n").expect("written");
    let refused = rig(&folder, &["snapshot", "cart_pole.rig"]);
    assert!(refused.status.code() == Some(1) && said(&refused).contains("C0401"), "{}", said(&refused));
    assert_eq!(std::fs::read_to_string(folder.join("cart_pole.snapshot.txt")).expect("stands"), "my notes\n");
}
