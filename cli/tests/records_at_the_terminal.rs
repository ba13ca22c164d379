//! `rig preflight`, `new`, `excite` and `fit-map` as their users run them.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("records_at_the_terminal").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder for the test");
    path
}

fn rig(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(folder).args(arguments).output().expect("the program starts")
}

fn text(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn json(folder: &Path, arguments: &[&str]) -> Value {
    serde_json::from_str(&text(&rig(folder, &[arguments, &["--json"]].concat()))).expect("one JSON document")
}

const RECORD: &str = "examples/records/simulated_steps.csv";
const IDENTIFIED: &str = "examples/rigs/googol_identified.rig";

/// The record that comes with the program, clean and with a turned column.
#[test]
fn preflight_in_words_and_in_json() {
    let clean = rig(&root(), &["preflight", IDENTIFIED, "--data", RECORD]);
    insta::assert_snapshot!("preflight_clean", text(&clean));
    let folder = folder("preflight");
    let record = std::fs::read_to_string(root().join(RECORD)).expect("the record");
    let turned: Vec<String> = record
        .lines()
        .map(|line| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if let Ok(y) = cells[5].parse::<f64>() {
                cells[5] = (-y).to_string();
            }
            cells.join(",")
        })
        .collect();
    std::fs::write(folder.join("turned.csv"), turned.join("\n")).expect("the record is written");
    let model = root().join(IDENTIFIED).display().to_string();
    let found = json(&folder, &["preflight", &model, "--data", "turned.csv"]);
    assert_eq!(found["records"][0]["outputs"].as_array().map(Vec::len), Some(3));
    let faults = found["faults"].as_array().expect("faults");
    assert_eq!(faults.len(), 1, "{faults:#?}");
    assert_eq!((&faults[0]["kind"], &faults[0]["channels"][0]), (&Value::from("output_sign"), &Value::from("theta")));
    insta::assert_snapshot!("preflight_turned", text(&rig(&folder, &["preflight", &model, "--data", "turned.csv"])));
}

/// What is written can be used at once, and stands for ever.
#[test]
fn a_new_rig_passes_its_check_and_is_never_overwritten() {
    let folder = folder("new");
    let mut record = "t,theta [deg],x [mm],V [V],theta_dot [deg/s],pos 1 [rad],temp [K]\n".to_owned();
    for k in 0..300 {
        let t = 0.01 * f64::from(k);
        let steps = (30.0 * (3.0 * t).sin() / 0.15).round() * 0.15;
        record += &format!(
            "{t:.2},{steps:.2},{:.6},{:.3},{:.4},{:.9},300\n",
            50.0 * t.sin(),
            5.0 * t.cos(),
            90.0 * (3.0 * t).cos(),
            (2.0 * t).sin()
        );
    }
    std::fs::write(folder.join("run.csv"), record).expect("the record is written");
    text(&rig(&folder, &["new", "Bench", "--data", "run.csv"]));
    let written = std::fs::read_to_string(folder.join("bench.rig")).expect("the rig");
    insta::assert_snapshot!("new_rig", written);
    text(&rig(&folder, &["check", "bench.rig"]));
    // two inputs, declared in a description
    std::fs::write(folder.join("log.txt"), "t;a\n0;1\n0.1;2\n0.2;4\n").expect("the file is written");
    std::fs::write(
        folder.join("run.toml"),
        "file = \"log.txt\"\ndelimiter = \"semicolon\"\n[signals]\neps = { column = \"a\", unit = \"deg\" }\n[inputs]\nf_1 = { constant = 1, unit = \"N\" }\nf_2 = { constant = 1, unit = \"N\" }\n",
    )
    .expect("the description is written");
    text(&rig(&folder, &["new", "Two", "--data", "run.toml"]));
    text(&rig(&folder, &["check", "two.rig"]));
    let again = rig(&folder, &["new", "Bench", "--data", "run.csv"]);
    assert_eq!(again.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&again.stderr).contains("never overwrites"));
    assert_eq!(std::fs::read_to_string(folder.join("bench.rig")).expect("the rig"), written);
    for (name, columns) in [("9lives", "t,theta\n0,1\n1,2\n"), ("Heat", "t,temp [K]\n0,1\n1,2\n")] {
        std::fs::write(folder.join("other.csv"), columns).expect("the record is written");
        assert_eq!(rig(&folder, &["new", name, "--data", "other.csv"]).status.code(), Some(1));
    }
}

/// Inputs within limits, coordinates within bounds; the same seed gives the same bytes; what is foretold comes true.
#[test]
fn an_excitation_stays_within_its_bounds() {
    let folder = folder("excite");
    let model = root().join(IDENTIFIED).display().to_string();
    let ask = |out: &str, more: &[&str]| {
        json(&folder, &[&["excite", model.as_str(), "--trim", "hover", "--within", "theta=8deg", "--out", out], more].concat())
    };
    let found = ask("a.csv", &[]);
    let excursion = |name: &str, k: usize| found["excursion"][name][k].as_f64().expect("a number").to_degrees();
    assert!(excursion("theta", 0) >= -3.01 && excursion("theta", 1) <= 13.01, "{found:#}");
    assert!(excursion("eps", 0) >= -28.7 && excursion("eps", 1) <= 28.7, "{found:#}");
    assert!(found["predicted"].as_array().is_some_and(|p| p.len() == 10 && p.iter().all(|p| p["std_error"].as_f64().is_some())));
    ask("b.csv", &[]);
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("the input");
    assert_eq!(read("a.csv"), read("b.csv"));
    ask("c.csv", &["--seed", "2"]);
    assert_ne!(read("a.csv"), read("c.csv"));
    for row in read("a.csv").lines().skip(1) {
        assert!(row.split(',').skip(1).all(|f| f.parse::<f64>().is_ok_and(|f| (0.05..=4.0).contains(&f))), "{row}");
    }
    // the run comes back as a record, and its fit has the errors that were foretold
    text(&rig(&folder, &["simulate", &model, "--input", "a.csv", "--out", "run.csv", "--encoders", "--at", "theta=5deg"]));
    let fit = json(&folder, &["identify", &model, "--data", "run.csv", "--fix", "b1,b4"]);
    for p in fit["parameters"].as_array().expect("parameters") {
        let foretold = found["predicted"].as_array().expect("predictions").iter().find(|q| q["name"] == p["name"]).expect("the parameter");
        let (value, truth, sd) = (p["value"].as_f64(), foretold["value"].as_f64(), foretold["std_error"].as_f64());
        let (value, truth, sd) = (value.expect("a value"), truth.expect("a value"), sd.expect("an error"));
        assert!((value - truth).abs() < 4.0 * sd, "{}: {value} instead of {truth} +- {sd}", p["name"]);
    }
    insta::assert_snapshot!("excite", text(&rig(&folder, &["excite", &model, "--trim", "hover", "--out", "d.csv", "--shape", "steps"])));
    // a user's file stays
    let refused = rig(&folder, &["excite", &model, "--out", "a.csv", "--trim", "level"]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("C0401"));
    // nothing can be done about an unstable point
    let upright = root().join("examples/rigs/furuta.rig").display().to_string();
    let refused = rig(&folder, &["excite", &upright, "--trim", "upright", "--out", "e.csv"]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("closed loop"));
    assert!(!folder.join("e.csv").exists());
}

#[test]
fn a_map_and_its_inverse() {
    let folder = folder("fit_map");
    // eq. 14 of the seed paper, with errors of a fixed pattern
    let mut pairs = "V [V],f [N]\n".to_owned();
    for k in 0..40 {
        let v = 0.3 + 0.075 * f64::from(k);
        let error = 0.01 * f64::from((k * 7 % 11) - 5) / 5.0;
        pairs += &format!("{v:.3},{:.5}\n", (0.3981 * v.powf(2.072) + 0.4988) * (1.0 + error));
    }
    std::fs::write(folder.join("pairs.csv"), &pairs).expect("the pairs are written");
    let found = json(&folder, &["fit-map", "pairs.csv", "--form", "power_offset", "--invert", "0.7,1.5"]);
    assert_eq!(found["form"], "power_offset");
    let inverse = found["inverse"]["values"][1]["x"].as_f64().expect("a number");
    assert!((inverse - ((1.5 - 0.4988) / 0.3981_f64).powf(1.0 / 2.072)).abs() < 0.02, "{inverse}");
    for field in ["parameters", "alternatives", "near_ties"] {
        assert!(found[field].is_array(), "{field}");
    }
    insta::assert_snapshot!("fit_map", text(&rig(&folder, &["fit-map", "pairs.csv"])));
    for (name, wrong) in [("three.csv", "a,b,c\n1,2,3\n"), ("few.csv", "a,b\n1,2\n2,3\n3,4\n"), ("none.csv", "1,2\n2,3\n")] {
        std::fs::write(folder.join(name), wrong).expect("the pairs are written");
    }
    let said = |arguments: &[&str]| {
        let output = rig(&folder, arguments);
        assert_eq!(output.status.code(), Some(1));
        String::from_utf8_lossy(&output.stderr).trim_end().to_owned()
    };
    let all = [
        said(&["fit-map", "three.csv"]),
        said(&["fit-map", "few.csv"]),
        said(&["fit-map", "none.csv"]),
        said(&["fit-map", "pairs.csv", "--form", "parabola"]),
    ];
    insta::assert_snapshot!("fit_map_wrong", all.join("\n\n"));
}
