//! `rig identify --method innovations` as its users run it.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const RIG: &str = "rig Cart { param m: kg = 1 in 0.1..10; param c: N*s/m = 0.5; param k: N/m = 2 fixed; param b: m/s = 0;
    coord x: m in -1..1; input F: N in -5..5; equation m * x.ddot = F - c * x.dot - k * x; }";

/// A cart that a random force pushes: 0.2 N, correlated over 0.1 s; positions with noise of 1 mm.
fn record(seed: u64) -> String {
    let mut state = seed;
    let mut uniform = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) as f64 + 0.5) / (1_u64 << 31) as f64
    };
    let mut normal = || (-2.0 * uniform().ln()).sqrt() * (std::f64::consts::TAU * uniform()).cos();
    let keep = (-0.01_f64 / 0.1).exp();
    let (mut text, mut x, mut v, mut w) = ("t,F,x\n".to_owned(), 0.1, 0.0, 0.2 * normal());
    for k in 0..1500 {
        let force = f64::from(k / 60 % 4) - 1.5;
        text += &format!("{:.2},{force},{:.6}\n", 0.01 * f64::from(k), x + 0.001 * normal());
        for _ in 0..20 {
            v += 0.0005 * (force + w - 0.7 * v - 2.0 * x) / 1.3;
            x += 0.0005 * v;
        }
        w = keep * w + 0.2 * (1.0 - keep * keep).sqrt() * normal();
    }
    text
}

fn folder() -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("innovations").join(format!("{:?}", std::thread::current().id()));
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder for the test");
    std::fs::write(path.join("cart.rig"), RIG).expect("the rig is written");
    for (name, seed) in [("one.csv", 1), ("two.csv", 2), ("three.csv", 3)] {
        std::fs::write(path.join(name), record(seed)).expect("a record is written");
    }
    path
}

fn rig(folder: &Path, more: &[&str]) -> Output {
    let base = ["identify", "cart.rig", "--data", "one.csv", "two.csv", "--test", "three.csv", "--method", "innovations"];
    Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(folder).args(base).args(more).output().expect("the program starts")
}

#[test]
fn the_answer_in_json_and_as_a_page() {
    let folder = folder();
    let output = rig(&folder, &["--json", "--report", "page.html"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let number = |v: &Value| v.as_f64().expect("a number");
    let holds = |ci: &Value, truth: f64| number(&ci[0]) < truth && truth < number(&ci[1]);
    for (i, (name, truth)) in [("m", 1.3), ("c", 0.7), ("b", f64::NAN)].into_iter().enumerate() {
        let p = &found["parameters"][i];
        assert_eq!(p["name"], name);
        assert!(truth.is_nan() || holds(&p["ci95"], truth), "{p}");
    }
    assert_eq!(found["identifiable"]["dead"], serde_json::json!(["b"]));
    let force = &found["random_forces"][0];
    assert_eq!((&force["coordinate"], &force["unit"]), (&"x".into(), &"N".into()));
    assert!(holds(&force["sd"]["ci95"], 0.2) && holds(&force["correlation_time"]["ci95"], 0.1), "{force}");
    assert!(holds(&found["output_noise"][0]["sd"]["ci95"], 0.001), "{}", found["output_noise"]);
    for field in ["initial_states", "objective", "cost", "log_likelihood", "rmse", "correlation", "evaluations", "seconds", "started_from"]
    {
        assert!(!found[field].is_null(), "{field}");
    }
    let white = found["whiteness"].as_array().expect("a list");
    assert!(white.len() == 2 && white.iter().all(|w| number(&w["p_value"]) > 0.001), "{white:?}");
    for (set, record) in [("train", "one.csv"), ("train", "two.csv"), ("test", "three.csv")] {
        assert!(number(&found["fit_percent"][set][record]["x"]) > 50.0, "{}", found["fit_percent"]);
    }
    let page = std::fs::read_to_string(folder.join("page.html")).expect("the page");
    assert!(page.contains("random force on x") && page.contains("noise of x"));
}

#[test]
fn what_it_says() {
    let folder = folder();
    let output = rig(&folder, &["--free", "m,c"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    // figures to three digits: the last ones are the machine's, as are effort and time
    // and of the probabilities only that they are not small
    let text: Vec<String> =
        String::from_utf8_lossy(&output.stdout).lines().skip(1).filter(|l| !l.contains("whiteness")).map(rounded).collect();
    insta::assert_snapshot!(text.join("\n"));
    let refused = rig(&folder, &["--windows", "1"]);
    assert_eq!(refused.status.code(), Some(1));
    insta::assert_snapshot!("refused", String::from_utf8_lossy(&refused.stderr).trim_end());
}

/// How large a force on what nobody measures is, no record tells.
#[test]
fn what_no_record_measures_is_not_pushed() {
    let folder = folder();
    let carriage = "coord y: m; equation m * y.ddot = k * (x - y) - c * y.dot; }";
    std::fs::write(folder.join("cart.rig"), RIG.replace("- k * x; }", &format!("- k * x; {carriage}"))).expect("the rig is written");
    let output = rig(&folder, &["--free", "m,c", "--json"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.contains("no training record measures y: it moves as the model says"), "{said}");
    let found: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let pushed: Vec<&Value> = found["random_forces"].as_array().expect("a list").iter().map(|f| &f["coordinate"]).collect();
    assert_eq!(pushed, ["x"]);
}

fn rounded(line: &str) -> String {
    let edge = |c: char| "();,".contains(c);
    let word = |w: &str| match w.trim_matches(edge).parse::<f64>() {
        Ok(x) if w.len() > 4 => w.replace(w.trim_matches(edge), &format!("{x:.2e}")),
        _ => w.to_owned(),
    };
    line.split(' ').map(word).collect::<Vec<_>>().join(" ")
}
