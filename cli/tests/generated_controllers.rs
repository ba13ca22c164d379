//! Controllers as code: they read as they should, compile without warnings, and give the library's inputs.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}

fn rig(folder: &Path, arguments: &[&str]) {
    let output = Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(folder).args(arguments).output().expect("the program starts");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// A folder with the rig and scenario of a test, both changed as it needs them.
struct Case {
    folder: PathBuf,
    rig: String,
}

impl Case {
    fn new(name: &str, scenario: &str, rig_text: impl Fn(&str) -> String, change: impl Fn(&str) -> String) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("controllers").join(name);
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).expect("a folder");
        let text = std::fs::read_to_string(root().join(format!("examples/scenarios/{scenario}.toml"))).expect("the scenario");
        let text = change(&text).replace("../rigs/", "");
        let rig = text.lines().find_map(|l| l.strip_prefix("rig = \"")?.strip_suffix('"')).expect("its rig").to_owned();
        for entry in std::fs::read_dir(root().join("examples/rigs")).expect("the rigs") {
            let path = entry.expect("a rig").path();
            let text = std::fs::read_to_string(&path).expect("its text");
            let name = path.file_name().expect("its name");
            std::fs::write(folder.join(name), if name == rig.as_str() { rig_text(&text) } else { text }).expect("a copy");
        }
        std::fs::write(folder.join("loop.toml"), text).expect("the scenario is written");
        rig_run(&folder, &rig);
        Self { folder, rig }
    }

    /// The columns of the closed loop's record.
    fn columns(&self, names: &[String]) -> Vec<Vec<f64>> {
        let text = std::fs::read_to_string(self.folder.join("loop.csv")).expect("the record");
        let head: Vec<&str> = text.lines().next().expect("its head").split(',').collect();
        let at: Vec<usize> = names.iter().map(|n| head.iter().position(|h| h == n).unwrap_or_else(|| panic!("no column {n}"))).collect();
        let row = |line: &str| {
            let cells: Vec<&str> = line.split(',').collect();
            at.iter().map(|&i| cells[i].parse().expect("a number")).collect::<Vec<f64>>()
        };
        text.lines().skip(1).map(row).collect()
    }
}

fn rig_run(folder: &Path, name: &str) {
    rig(folder, &["closed-loop", "loop.toml", "--out", "loop.csv"]);
    for lang in ["rust", "c"] {
        rig(folder, &["generate", name, "--controller", "loop.toml", "--out", "code", "--lang", lang]);
        rig(folder, &["generate", name, "--controller", "loop.toml", "--out", "code", "--lang", lang, "--check"]);
    }
}

/// Feeds lines of numbers to a program and reads lines of numbers.
fn feed(program: &Path, rows: &[Vec<f64>]) -> Vec<f64> {
    let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("it starts");
    let mut text = String::new();
    for row in rows {
        let cells: Vec<String> = row.iter().map(|x| format!("{x:?}")).collect();
        let _ = writeln!(text, "{}", cells.join(" "));
    }
    let mut stdin = child.stdin.take().expect("its input");
    let writer = std::thread::spawn(move || stdin.write_all(text.as_bytes()));
    let output = child.wait_with_output().expect("it ends");
    writer.join().expect("the writer ends").expect("all is written");
    assert!(output.status.success());
    String::from_utf8_lossy(&output.stdout).split_whitespace().map(|x| x.parse().expect("a number")).collect()
}

fn tool(program: &str, folder: &Path, arguments: &[&str]) -> bool {
    match Command::new(program).current_dir(folder).args(arguments).output() {
        Ok(output) => {
            assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
            true
        }
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => false,
        Err(e) => panic!("{program}: {e}"),
    }
}

fn c_program(case: &Case, readings: &[&str], references: &[&str], inputs: &[&str]) -> Option<PathBuf> {
    let mut reads = String::new();
    let targets = references.iter().flat_map(|r| [format!("reference.{r}.value"), format!("reference.{r}.rate")]);
    let places: Vec<String> = readings.iter().map(|r| format!("reading.{r}")).chain(targets).collect();
    for (count, place) in places.iter().enumerate() {
        let _ = write!(reads, "{}scanf(\"%lf\", &{place}) == 1", if count == 0 { "" } else { " && " });
    }
    let prints: String = inputs.iter().map(|u| format!("        printf(\"%.17g\\n\", u.{u});\n")).collect();
    let main = format!(
        "#include \"loop.h\"\n#include <stdio.h>\n\nint main(void)\n{{\n    struct loop_memory memory;\n    struct loop_readings reading;\n    \
         struct loop_references reference;\n    struct loop_inputs u;\n    loop_start(&memory);\n    while ({reads}) {{\n        \
         loop_step(&memory, &reading, &reference, &u);\n{prints}    }}\n    return 0;\n}}\n"
    );
    let folder = case.folder.join("code");
    std::fs::write(folder.join("main.c"), main).expect("the program is written");
    let flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O1", "-o", "c_program", "main.c", "loop.c", "-lm"];
    tool("cc", &folder, &flags).then(|| folder.join("c_program"))
}

fn rust_program(case: &Case, readings: &[&str], references: &[&str]) -> PathBuf {
    let folder = case.folder.join("code");
    let runtime = root().join("runtime/src/lib.rs").display().to_string();
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    // with the standard library's functions the runtime needs no other crate
    assert!(tool(
        &rustc,
        &folder,
        &[
            "--edition",
            "2024",
            "--crate-type",
            "rlib",
            "--crate-name",
            "runtime",
            "--cfg",
            "feature=\"std\"",
            "--cap-lints",
            "allow",
            &runtime
        ]
    ));
    // the controller itself needs no standard library
    let text = std::fs::read_to_string(folder.join("loop.rs")).expect("the controller");
    let cut = text.lines().take_while(|l| l.starts_with("//!")).count();
    let lines: Vec<&str> = text.lines().collect();
    std::fs::write(folder.join("bare.rs"), format!("{}\n#![no_std]\n{}\n", lines[..cut].join("\n"), lines[cut..].join("\n")))
        .expect("a copy");
    let library = [
        "--edition",
        "2024",
        "--crate-type",
        "rlib",
        "--crate-name",
        "bare",
        "-D",
        "warnings",
        "--extern",
        "runtime=libruntime.rlib",
        "bare.rs",
    ];
    assert!(tool(&rustc, &folder, &library));
    let given: Vec<String> = readings.iter().enumerate().map(|(i, r)| format!("{r}: row[{i}]")).collect();
    let n = readings.len();
    let targets: Vec<String> = references
        .iter()
        .enumerate()
        .map(|(i, r)| format!("{r}: bare::Target {{ value: row[{}], rate: row[{}] }}", n + 2 * i, n + 2 * i + 1))
        .collect();
    let main = format!(
        "fn main() {{\n    let mut controller = bare::Controller::default();\n    for line in std::io::stdin().lines() {{\n        \
         let row: Vec<f64> = line.unwrap().split(' ').map(|x| x.parse().unwrap()).collect();\n        \
         let u = controller.step(&bare::Readings {{ {} }}, &bare::References {{ {} }});\n        \
         u.iter().for_each(|u| println!(\"{{u:?}}\"));\n    }}\n}}\n",
        given.join(", "),
        targets.join(", ")
    );
    std::fs::write(folder.join("main.rs"), main).expect("the program is written");
    let link = [
        "--edition",
        "2024",
        "-L",
        ".",
        "--extern",
        "bare=libbare.rlib",
        "--extern",
        "runtime=libruntime.rlib",
        "-o",
        "rust_program",
        "main.rs",
    ];
    assert!(tool(&rustc, &folder, &link));
    folder.join("rust_program")
}

/// Runs the library's loop, feeds what its controller read to the generated ones, compares the inputs.
fn agree(case: &Case, readings: &[&str], references: &[&str], inputs: &[&str]) {
    let names: Vec<String> = readings
        .iter()
        .map(|r| (*r).to_owned())
        .chain(references.iter().flat_map(|r| [format!("{r}.reference"), format!("{r}.dot.reference")]))
        .collect();
    let mut rows = case.columns(&names);
    // the record shows references as the encoder would show them
    let zeros: Vec<f64> = references.iter().map(|r| if *r == "elevation" { 27.5_f64.to_radians() } else { 0.0 }).collect();
    for row in &mut rows {
        for (i, zero) in zeros.iter().enumerate() {
            row[readings.len() + 2 * i] -= zero;
        }
    }
    let wanted: Vec<f64> = case.columns(&inputs.iter().map(|u| (*u).to_owned()).collect::<Vec<_>>()).concat();
    let size = wanted.iter().fold(0.0_f64, |m, u| m.max(u.abs()));
    let moved = wanted.iter().zip(&wanted[inputs.len()..]).filter(|(a, b)| a != b).count();
    assert!(moved > wanted.len() / 2, "the inputs move");
    let check = |language: &str, found: Vec<f64>| {
        assert_eq!(found.len(), wanted.len(), "{language}");
        let worst = found.iter().zip(&wanted).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs() / size));
        println!("{}: {language} differs by {worst:.1e} over {} inputs", case.rig, wanted.len());
        assert!(worst < 1e-12, "{}: {language}: {worst:.1e}", case.rig);
    };
    check("Rust", feed(&rust_program(case, readings, references), &rows));
    match c_program(case, readings, references, inputs) {
        Some(program) => check("C", feed(&program, &rows)),
        None => println!("generated C of {}: skipped (there is no C compiler `cc`)", case.rig),
    }
}

const NOISE: &str = "\n[noise]\nseed = 7\ndeviation = { psi = \"0.2 deg\", eps = \"0.2 deg\", theta = \"0.1 deg\" }\n";

fn same(text: &str) -> String {
    text.to_owned()
}

#[test]
fn tracking_with_integrals_and_the_manifold_in_closed_form() {
    let case = Case::new("integrals", "experiment_1", same, |text| {
        let text = text.replace("[controller.lqr]", "integrate = [\"theta\", \"eps\"]\n\n[controller.lqr]");
        text.replace("400, 1]", "400, 1, 50, 50]").replace("50 s", "10 s") + NOISE
    });
    agree(&case, &["eps", "theta"], &["eps", "theta"], &["f_1", "f_2"]);
}

#[test]
fn a_cascade_with_a_filtered_and_limited_reference() {
    let case = Case::new("cascade", "experiment_2", same, |text| {
        let filter = "rate = { filter = { omega = \"50 rad/s\", damping = 0.9 } }\nlimit = \"10 deg\"";
        text.replace("rate = \"zero\"", filter).replace("50 s", "10 s") + NOISE
    });
    agree(&case, &["psi", "eps", "theta"], &["psi", "eps"], &["f_1", "f_2"]);
}

/// An encoder that was switched on away from zero, and a feedforward that knows where the carriage is.
#[test]
fn a_measured_carriage_in_the_feedforward() {
    let case = Case::new("carriage", "ads_sweep", same, |text| {
        text.replace("hold = [\"elevation\", \"pitch\"]", "hold = [\"elevation\", \"pitch\", \"s\"]").replace("40 s", "10 s")
    });
    agree(&case, &["elevation", "pitch", "s"], &["elevation", "pitch"], &["V_f", "V_b"]);
}

/// Encoders that show one turn, at the angle where they wrap; the inputs of the operating point.
#[test]
fn wrapped_encoders() {
    let case = Case::new(
        "wrapped",
        "furuta_balance",
        |text| text.replace("    trim hanging", "    encoder theta: 8192 wrapped;\n    encoder alpha: 8192 wrapped;\n    trim hanging"),
        |text| text.replace("duration = \"10 s\"", "duration = \"4 s\""),
    );
    let shown = case.columns(&["alpha".to_owned()]).concat();
    assert!(shown.iter().any(|a| *a > 3.0) && shown.iter().any(|a| *a < -3.0), "the pendulum swings through where the encoder wraps");
    agree(&case, &["theta", "alpha"], &["theta"], &["tau"]);
}

const KALMAN: &str = "[rates.kalman]\nprocess = { \"theta.dot\" = 1.0, \"alpha.dot\" = 1.0 }";

/// A Kalman filter: readings correct its prediction, and what the limits leave of the inputs moves it on; integral action.
#[test]
fn a_kalman_filter() {
    let case = Case::new("kalman", "cart_pole_push", same, |text| {
        let start = text.find("[disturbances]").expect("a push");
        let end = text.find("[noise]").expect("noise");
        text[..start].to_owned() + &text[end..]
    });
    agree(&case, &["x", "theta"], &["x"], &["F"]);
}

/// The same with an encoder that shows one turn, around an operating point that is not zero.
#[test]
fn a_kalman_filter_on_wrapped_encoders() {
    let case = Case::new(
        "kalman_wrapped",
        "furuta_balance",
        |text| text.replace("    trim hanging", "    encoder theta: 8192 wrapped;\n    encoder alpha: 8192 wrapped;\n    trim hanging"),
        |text| {
            let text = text.replace("duration = \"10 s\"", "duration = \"4 s\"");
            text.replace("[rates.filter]\nomega = \"200 rad/s\"\ndamping = 0.9\nrule = \"tustin\"", KALMAN)
        },
    );
    let shown = case.columns(&["alpha".to_owned()]).concat();
    assert!(shown.iter().any(|a| *a > 3.0) && shown.iter().any(|a| *a < -3.0), "the pendulum swings through where the encoder wraps");
    agree(&case, &["theta", "alpha"], &["theta"], &["tau"]);
}

#[test]
fn the_texts() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("controllers").join("texts");
    let _ = std::fs::remove_dir_all(&folder);
    let out = folder.display().to_string();
    for lang in ["rust", "c"] {
        let scenario = "examples/scenarios/experiment_2.toml";
        rig(&root(), &["generate", "examples/rigs/googol_identified.rig", "--controller", scenario, "--out", &out, "--lang", lang]);
    }
    for lang in ["rust", "c"] {
        let scenario = "examples/scenarios/cart_pole_push.toml";
        rig(&root(), &["generate", "examples/rigs/cart_pole.rig", "--controller", scenario, "--out", &out, "--lang", lang]);
    }
    for file in ["experiment_2.rs", "experiment_2.h", "experiment_2.c", "cart_pole_push.rs", "cart_pole_push.h", "cart_pole_push.c"] {
        // no compiler's last digit stands in the snapshot
        let text = std::fs::read_to_string(folder.join(file)).expect("the file");
        insta::assert_snapshot!(file, rounded(&text));
    }
}

/// Numbers to nine digits: the last ones are the machine's.
fn rounded(text: &str) -> String {
    let mut out = String::new();
    let mut word = String::new();
    for c in text.chars().chain(['\n']) {
        let exponent = c == '-' && word.ends_with('e') && word.starts_with(|c: char| c.is_ascii_digit());
        if c.is_ascii_alphanumeric() || c == '.' || c == '_' || exponent {
            word.push(c);
            continue;
        }
        match word.parse::<f64>() {
            Ok(x) if word.len() > 12 && word.starts_with(|c: char| c.is_ascii_digit()) => {
                out.push_str(&format!("{:?}", format!("{x:.9e}").parse::<f64>().unwrap_or(x)))
            }
            _ => out.push_str(&word),
        }
        word.clear();
        out.push(c);
    }
    out.trim_end().to_owned() + "\n"
}
