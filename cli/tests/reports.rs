//! Reports as users get them: complete in themselves, equal from run to run, and never over a file of the user's.

#[path = "../../report/tests/well_formed/mod.rs"]
mod well_formed;

use serde_json::Value;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const IDENTIFIED: &str = "examples/rigs/googol_identified.rig";
const RECORD: &str = "examples/records/simulated_steps.csv";

fn rig(arguments: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf);
    Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(root).args(arguments).output().expect("the program starts")
}

/// A fresh folder.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder for the test");
    path
}

fn json(arguments: &[&str]) -> Value {
    let output = rig(&[arguments, &["--json"]].concat());
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{arguments:?}: {text}{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_str(&text).expect("one JSON document")
}

/// The page without the line that says how long it took.
fn page(path: &Path) -> String {
    let text = std::fs::read_to_string(path).expect("the page was written");
    well_formed::check(&text);
    let Some((before, rest)) = text.split_once("<p class=\"time\">") else { return text };
    format!("{before}{}", rest.split_once("</p>").expect("the time ends").1)
}

fn headings(page: &str) -> Vec<&str> {
    page.split("<h2>").skip(1).filter_map(|part| part.split("</h2>").next()).collect()
}

/// Runs twice; both pages are equal.
fn twice(folder: &Path, arguments: &[&str]) -> String {
    let path = folder.join("report.html");
    let name = path.display().to_string();
    let mut pages = Vec::new();
    for _ in 0..2 {
        let found = json(&[arguments, &["--report", &name]].concat());
        assert_eq!(found["report"], name.as_str(), "{arguments:?}");
        pages.push(page(&path));
    }
    assert!(pages[0] == pages[1], "equal input, equal bytes: {arguments:?}");
    pages.remove(0)
}

#[test]
fn of_regulators_and_linear_models() {
    let folder = folder("report_linear");
    let design = ["lqr", IDENTIFIED, "--inputs", "f_s,f_d", "--states", "eps,theta,eps.dot,theta.dot", "--weights-u", "1,1"];
    let single = twice(&folder, &[&design[..], &["--integrate", "eps", "--weights-x", "1,1,1,1,1"]].concat());
    assert_eq!(headings(&single), ["Gain", "Poles", "The linear loop after a step of a reference", "Loops over frequency"]);
    assert!(single.contains("int eps") && single.contains("SHA-256 "));
    let sweep = ["--weights-x", "1,1,1,1", "--discrete", "10ms", "--sweep", "theta=-10deg:10deg:5"];
    let swept = twice(&folder, &[&design[..], &sweep].concat());
    assert_eq!(headings(&swept), ["Poles of the closed loop over the sweep", "Gains over the sweep"]);
    assert!(swept.contains("theta = -10 deg") && swept.contains("class=\"circle\""));
    let linear = twice(&folder, &["linearize", IDENTIFIED, "--sweep", "theta=-10deg:10deg:5"]);
    assert_eq!(headings(&linear), ["Poles over the sweep"]);
    assert_eq!(headings(&twice(&folder, &["linearize", "examples/rigs/cart_pole.rig"])), ["Poles", "Linear model"]);
}

#[test]
fn of_runs() {
    let folder = folder("report_runs");
    let csv = folder.join("run.csv").display().to_string();
    let run = twice(&folder, &["simulate", IDENTIFIED, "--input", RECORD, "--out", &csv, "--force"]);
    assert_eq!(headings(&run), ["Inputs", "Outputs", "Other states"]);
    let closed =
        twice(&folder, &["closed-loop", "examples/scenarios/experiment_1.toml", "--out", &csv, "--force", "--with", "duration=\"5s\""]);
    assert!(headings(&closed).starts_with(&["Errors against the references", "Signals and their references"]), "{:?}", headings(&closed));
    assert!(closed.contains("Dashed: its limits"));
}

#[test]
fn of_an_identification() {
    let folder = folder("report_identify");
    let fit = ["identify", IDENTIFIED, "--data", RECORD, "--free", "c_eps,c_theta"];
    let found = twice(&folder, &fit);
    assert_eq!(headings(&found), ["How the model follows the records", "Parameters", "simulated_steps (training)"]);
    assert!(found.contains("Dashed: where white errors stay 95 % of the time."));
    assert!(found.len() < 400_000, "{} bytes", found.len());

    let foreign = folder.join("mine.html");
    std::fs::write(&foreign, "<p>my own notes</p>\n").expect("a file of the user's");
    let name = foreign.display().to_string();
    let refused = rig(&[&fit[..], &["--report", &name]].concat());
    assert_eq!(refused.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("C0401"), "{}", String::from_utf8_lossy(&refused.stderr));
    assert_eq!(std::fs::read_to_string(&foreign).expect("still there"), "<p>my own notes</p>\n");
    assert!(rig(&[&fit[..], &["--report", &name, "--force"]].concat()).status.success());
    page(&foreign);
}

#[test]
fn of_a_diagnosis() {
    let folder = folder("report_diagnose");
    // the truth once more, otherwise excited
    let (input, test) = (folder.join("input.csv"), folder.join("other_steps.csv"));
    let mut text = String::from("t [s],f_1 [N],f_2 [N]\n");
    for k in 0..1000_u32 {
        let (sum, difference) = ([3.0, 2.7, 3.2, 2.9][(k / 170 % 4) as usize], [0.1, -0.15, 0.05][(k / 90 % 3) as usize]);
        let _ = writeln!(text, "{},{},{}", f64::from(k) * 0.02, 0.5 * (sum + difference), 0.5 * (sum - difference));
    }
    std::fs::write(&input, text).expect("an input");
    let (input, test) = (input.display().to_string(), test.display().to_string());
    json(&["simulate", "examples/hidden/googol_imbalance.rig", "--input", &input, "--out", &test, "--encoders"]);

    let out = folder.join("out");
    let name = out.display().to_string();
    let asked = [
        "diagnose",
        IDENTIFIED,
        "--data",
        RECORD,
        "--test",
        &test,
        "--free",
        "c_theta",
        "--effects",
        "constant_torque,viscous",
        "--out",
        &name,
    ];
    let mut pages = Vec::new();
    for _ in 0..2 {
        let found = json(&asked);
        assert_eq!(found["report"], out.join("index.html").display().to_string().as_str());
        assert!(found["effects"].as_array().is_some_and(|e| e.iter().any(|e| e["effect"] == "constant_torque")), "{found:#}");
        for poles in ["before", "after"] {
            assert_eq!(found["control"][poles].as_array().map(Vec::len), Some(6), "{:#}", found["control"]);
        }
        pages.push(page(&out.join("index.html")));
    }
    assert!(pages[0] == pages[1], "equal input, equal bytes");
    let expected = [
        "Where they disagree",
        "What could be missing",
        "What was found",
        "How much",
        "Parameters before and after",
        "What it means for a regulator",
    ];
    assert_eq!(headings(&pages[0]), expected);
    assert!(pages[0].contains("<ins>+     torque constant_theta on theta: tau_0_theta;</ins>"), "the patch stands in the page");
    let model = std::fs::read_to_string(out.join("model.rs")).expect("the model is regenerated");
    assert!(model.contains("tau_0_theta"));
    // bad data: a page too, without a patch
    let wrong = folder.join("wrong").display().to_string();
    let short = folder.join("short.csv");
    let lines: Vec<String> = std::fs::read_to_string(&test).expect("the record").lines().take(40).map(str::to_owned).collect();
    std::fs::write(&short, lines.join("\n")).expect("a short record");
    let found = json(&["diagnose", IDENTIFIED, "--data", &short.display().to_string(), "--test", &test, "--out", &wrong]);
    assert_eq!(found["verdict"], "bad_data");
    assert!(found["control"].is_null() && found["patched_model"].is_null());
    assert!(page(&Path::new(&wrong).join("index.html")).contains("bad data:"));
}
