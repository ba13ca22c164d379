//! `rig identify --method channels` as its users run it, on the records that come with the program.

use std::path::PathBuf;
use std::process::{Command, Output};

fn rig(more: &[&str]) -> Output {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..");
    let base =
        ["identify", "examples/rigs/googol_identified.rig", "--data", "examples/records/simulated_steps.csv", "--method", "channels"];
    Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(root).args(base).args(more).output().expect("the program starts")
}

#[test]
fn what_it_says() {
    let output = rig(&["--bandwidth", "10", "--mean", "3", "--free", "a1,a2,a3,b2,b3,c_psi,c_eps,c_theta"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    insta::assert_snapshot!(String::from_utf8_lossy(&output.stdout));
}

#[test]
fn what_it_refuses() {
    let told: Vec<String> = [&["--bandwidth", "0"][..], &["--mean", "1000"], &["--derivative", "guess"]]
        .iter()
        .map(|more| {
            let output = rig(more);
            assert!(!output.status.success());
            String::from_utf8_lossy(&output.stderr).lines().take(2).collect::<Vec<_>>().join("\n")
        })
        .collect();
    insta::assert_snapshot!(told.join("\n\n"));
}
