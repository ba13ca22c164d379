//! The program as its users run it: exit codes, JSON with the fields that stay stable, files that are not overwritten.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}

fn rig(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(root()).args(arguments).output().expect("the program starts")
}

/// Runs with `--json` and expects exit code 0 and these fields.
fn json(arguments: &[&str], fields: &[&str]) -> Value {
    let output = rig(&[arguments, &["--json"]].concat());
    assert!(
        output.status.success(),
        "{arguments:?}: {}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    let value: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    for field in fields {
        assert!(value.get(field).is_some(), "{arguments:?} lacks `{field}`");
    }
    value
}

/// A fresh folder for files that a test writes.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder for the test");
    path
}

const IDENTIFIED: &str = "examples/rigs/googol_identified.rig";
const MRB: &str = "examples/rigs/googol_mrb.rig";
const RECORD: &str = "examples/records/simulated_steps.csv";

#[test]
fn every_command_answers_in_json() {
    json(&["check", MRB], &["rig", "coordinates", "states", "inputs", "outputs", "parameters", "diagnostics"]);
    let show = json(&["show", MRB], &["equations", "assumptions", "ops"]);
    for field in ["mass_matrix", "bias", "gravity", "input_map", "dissipation"] {
        assert!(show["equations"][field].is_string(), "{field}");
    }
    assert!(show["ops"]["forward_dynamics"].as_u64() < show["ops"]["jacobians"].as_u64());
    let eval = json(
        &["eval", "examples/rigs/googol.rig", "--at", "eps=0.1", "--at", "psi.dot=0.3", "--at", "f_1=1.5"],
        &["M", "bias", "gravity", "dissipation", "force", "input_map", "acceleration", "A", "B", "dadp", "kinetic", "potential"],
    );
    assert_eq!(eval["M"].as_array().map(Vec::len), Some(3));
    assert!(json(&["eval", IDENTIFIED], &[])["kinetic"].is_null(), "written directly: no energies");
    json(&["diff", MRB, "examples/rigs/googol_eq13.rig"], &["added", "removed", "changed"]);
    json(&["trim", IDENTIFIED, "--trim", "hover"], &["state", "input", "drift", "rank", "free"]);
    let linear = json(&["linearize", IDENTIFIED, "--sweep", "theta=-5deg:5deg:3"], &["states", "inputs", "outputs", "points"]);
    let points = linear["points"].as_array().expect("points");
    assert_eq!(points.len(), 3);
    for field in ["state", "input", "drift", "A", "B", "C", "D", "poles", "dropped", "input_delay"] {
        assert!(points[0].get(field).is_some(), "{field}");
    }
    assert!(points[0].get("output_play").is_none(), "no output has a play");
    let played = json(&["linearize", "tests/rigs/pass/play_of_a_sensor.rig", "--at", "theta=0"], &["points"])["points"][0].clone();
    assert_eq!((played["output_play"]["x"].as_f64(), played["output_delay"]["x"].as_f64()), (Some(0.0008), Some(0.005)));
    let compare = json(&["compare", IDENTIFIED, "--data", RECORD], &["rigs"]);
    for field in ["fit_percent", "rmse", "status", "valid_until", "horizon"] {
        assert!(compare["rigs"][0].get(field).is_some(), "{field}");
    }
}

/// Eq. 17 of the seed paper to its printed digits, with the damping that it used, and the yaw acceleration that it ignores.
#[test]
fn eq_17_in_one_command() {
    let value = json(&["linearize", IDENTIFIED, "--at", "theta=5deg", "--inputs", "f_s,f_d", "--set", "c_eps=0.10"], &["points"]);
    let point = &value["points"][0];
    let entry = |matrix: &str, i: usize, j: usize| point[matrix][i][j].as_f64().expect("a number");
    let printed = |value: f64, digits: usize, wanted: &str| assert_eq!(format!("{value:.digits$}"), wanted);
    printed(entry("A", 3, 3), 2, "-0.48");
    printed(entry("A", 3, 1), 3, "-0.004");
    printed(entry("A", 3, 2), 2, "1.63");
    printed(entry("B", 3, 0), 2, "0.05");
    printed(entry("A", 4, 1), 2, "-0.26");
    printed(entry("A", 4, 4), 1, "-0.1");
    printed(entry("A", 4, 2), 2, "-0.14");
    printed(entry("B", 4, 0), 2, "0.53");
    printed(entry("A", 5, 2), 2, "-25.55");
    printed(entry("A", 5, 5), 2, "-0.34");
    printed(entry("B", 5, 1), 2, "5.33");
    printed(point["drift"][0].as_f64().expect("a number"), 3, "0.142");
}

/// Eq. 26 of the seed paper to its printed digits.
#[test]
fn eq_26_in_one_command() {
    let value = json(
        &[
            "lqr",
            IDENTIFIED,
            "--at",
            "theta=5deg",
            "--inputs",
            "f_s,f_d",
            "--states",
            "eps,eps.dot,theta,theta.dot",
            "--weights-x",
            "180,10,400,1",
            "--weights-u",
            "1,1",
        ],
        &["K", "P", "poles", "states", "inputs", "trim", "residual"],
    );
    let wanted = [["12.929", "7.125", "-0.112", "-0.007"], ["-0.096", "-0.068", "15.773", "2.567"]];
    for (i, row) in wanted.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            assert_eq!(format!("{:.3}", value["K"][i][j].as_f64().expect("a number")), *entry, "K[{i}][{j}]");
        }
    }
}

#[test]
fn failures_say_where_and_exit_with_1() {
    for arguments in [
        &["check", "no_such.rig"][..],
        &["trim", IDENTIFIED, "--trim", "hovr"],
        &["eval", IDENTIFIED, "--at", "epsilon=1"],
        &["eval", IDENTIFIED, "--at", "eps"],
        &["eval", "examples/rigs/googol_srb.rig", "--at", "eps=90deg"],
        &["linearize", IDENTIFIED, "--inputs", "f_s,f_1"],
        &["linearize", IDENTIFIED, "--sweep", "theta=1"],
        &["compare", IDENTIFIED, "--data", "no_such.csv"],
        &["lqr", IDENTIFIED, "--weights-x", "1", "--weights-u", "1,1"],
    ] {
        let output = rig(&[arguments, &["--json"]].concat());
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        let value: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
        let first = &value["diagnostics"][0];
        assert!(first["code"].is_string() && first["message"].as_str().is_some_and(|m| m.len() > 10), "{arguments:?}: {value}");
    }
    assert_eq!(rig(&["frobnicate"]).status.code(), Some(2));
    assert_eq!(rig(&["eval"]).status.code(), Some(2));
}

#[test]
fn nothing_of_the_users_is_overwritten() {
    let folder = folder("overwrite");
    let out = folder.display().to_string();
    assert!(rig(&["generate", MRB, "--out", &out]).status.success());
    assert!(rig(&["generate", MRB, "--out", &out, "--check"]).status.success());
    let file = folder.join("googol_mrb.rs");
    // our own file may be written over, and a stale one is found
    let text = std::fs::read_to_string(&file).expect("the model");
    std::fs::write(&file, text.replace("1.8", "1.9")).expect("writable");
    assert_eq!(rig(&["generate", MRB, "--out", &out, "--check"]).status.code(), Some(1));
    assert!(rig(&["generate", MRB, "--out", &out]).status.success());
    // a file of the user's may not
    std::fs::write(&file, "mine\n").expect("writable");
    assert_eq!(rig(&["generate", MRB, "--out", &out]).status.code(), Some(1));
    assert_eq!(std::fs::read_to_string(&file).expect("still there"), "mine\n");
    let csv = folder.join("run.csv");
    std::fs::write(&csv, "mine\n").expect("writable");
    let path = csv.display().to_string();
    assert_eq!(rig(&["simulate", IDENTIFIED, "--input", RECORD, "--out", &path]).status.code(), Some(1));
    assert_eq!(std::fs::read_to_string(&csv).expect("still there"), "mine\n");
}

/// The C source includes the header beside it, whatever the rig in the file is called.
#[test]
fn c_files_are_named_after_the_rigs_file() {
    let folder = folder("c");
    let file = folder.join("mine.rig");
    std::fs::copy(root().join(IDENTIFIED), &file).expect("a copy of the rig");
    let (file, out) = (file.display().to_string(), folder.display().to_string());
    assert!(rig(&["generate", &file, "--out", &out, "--lang", "c"]).status.success());
    assert!(folder.join("mine.h").is_file());
    assert!(std::fs::read_to_string(folder.join("mine.c")).expect("the source").contains("#include \"mine.h\""));
}

/// What `rig simulate` writes is a record that `rig compare` reads: the model fits its own run.
#[test]
fn a_simulated_run_is_a_record() {
    let out = folder("simulate").join("run.csv").display().to_string();
    let run = json(
        &["simulate", IDENTIFIED, "--input", RECORD, "--at", "eps=-10deg", "--out", &out],
        &["samples", "final_state", "status", "valid_until"],
    );
    assert_eq!(run["samples"], 2001);
    assert_eq!(run["status"], "completed");
    let compare =
        json(&["compare", IDENTIFIED, "--data", &out, "--at", "eps.dot=0", "--at", "psi.dot=0", "--at", "theta.dot=0"], &["rigs"]);
    for signal in ["psi", "eps", "theta"] {
        let fit = compare["rigs"][0]["fit_percent"][signal].as_f64().expect("a fit");
        assert!(fit > 99.9, "{signal}: {fit}");
    }
}

#[test]
fn the_demonstration_runs() {
    let out = folder("demo").join("rig-demo").display().to_string();
    let value = json(&["demo", "--out", &out], &["files", "steps"]);
    assert_eq!(value["steps"].as_array().map(Vec::len), Some(7));
}
