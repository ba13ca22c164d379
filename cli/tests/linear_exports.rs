//! Linear models and gains for other programs, and as code over a sweep.

use ident::record::{MatValue, read_mat};
use nalgebra::DMatrix;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("exports").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder");
    path
}

fn rig(arguments: &[&str]) -> Value {
    let output =
        Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(root()).args(arguments).arg("--json").output().expect("the program starts");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stdout));
    serde_json::from_slice(&output.stdout).expect("one JSON document")
}

fn matrix(value: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = serde_json::from_value(value.clone()).expect("rows of numbers");
    DMatrix::from_fn(rows.len(), rows.first().map_or(0, Vec::len), |i, j| rows[i][j])
}

const EQ_26: [&str; 12] = [
    "lqr",
    "examples/rigs/googol_identified.rig",
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
];

#[test]
fn a_mat_file_is_read_back_and_is_what_scipy_reads() {
    let path = folder("mat").join("eq_26.mat");
    let shown = path.display().to_string();
    let json = rig(&[&EQ_26[..], &["--export", &shown]].concat());
    let linear = rig(&["linearize", "examples/rigs/googol_identified.rig", "--at", "theta=5deg", "--inputs", "f_s,f_d"]);
    let wanted = [
        ("A", &linear["points"][0]["A"]),
        ("B", &linear["points"][0]["B"]),
        ("C", &linear["points"][0]["C"]),
        ("K", &json["K"]),
        ("P", &json["P"]),
    ];
    let variables = read_mat(&std::fs::read(&path).expect("the file")).expect("a MAT file");
    for (name, value) in wanted {
        let found = variables.iter().find(|v| v.name == name).unwrap_or_else(|| panic!("no {name}"));
        let MatValue::Matrix { rows, columns, values } = &found.value else { panic!("{name} is no matrix") };
        let found = DMatrix::from_column_slice(*rows, *columns, values);
        let wanted = matrix(value);
        assert!((&found - &wanted).norm() <= 1e-14 * wanted.norm(), "{name}: {found} {wanted}");
    }
    // our own file may be written over, another's not
    rig(&[&EQ_26[..], &["--export", &shown]].concat());
    let script = format!(
        "import json, sys\ntry:\n    from scipy.io import loadmat\nexcept ImportError:\n    sys.exit(77)\nm = loadmat({shown:?})\n\
         print(json.dumps({{'K': m['K'].tolist(), 'A': m['A'].tolist(), 'states': [s.strip() for s in m['states']], 'x0': m['x0'].ravel().tolist()}}))\n"
    );
    let Ok(output) = Command::new("python3").args(["-c", &script]).output() else {
        println!("SciPy: skipped (there is no python3)");
        return;
    };
    if output.status.code() == Some(77) {
        println!("SciPy: skipped (it is not installed)");
        return;
    }
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    println!("SciPy: read {shown}");
    assert_eq!(read["states"], linear["states"]);
    assert!((matrix(&read["K"]) - matrix(&json["K"])).norm() < 1e-13);
    assert!((matrix(&read["A"]) - matrix(&linear["points"][0]["A"])).norm() < 1e-13);
}

#[test]
fn a_script_holds_the_same_numbers() {
    let path = folder("m").join("eq_26.m");
    let json = rig(&[&EQ_26[..], &["--export", &path.display().to_string()]].concat());
    let text = std::fs::read_to_string(&path).expect("the script");
    let start = text.find("\nK = [").expect("K") + 6;
    let body = &text[start..start + text[start..].find("];").expect("its end")];
    let rows: Vec<Vec<f64>> = body.split(';').map(|row| row.split_whitespace().map(|x| x.parse().expect("a number")).collect()).collect();
    let found = DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j]);
    assert!((found - matrix(&json["K"])).norm() < 1e-14);
    assert!(text.contains("states = {'psi'; 'eps'; 'theta'; 'psi.dot'; 'eps.dot'; 'theta.dot'};"), "{text}");
    insta::assert_snapshot!(
        text.lines().map(|l| l.split(" = ").next().unwrap_or(l)).filter(|l| !l.starts_with(' ')).collect::<Vec<_>>().join("\n")
    );
}

#[test]
fn a_file_of_another_kind_is_refused() {
    let folder = folder("refused");
    let wrong = |file: &str| {
        let path = folder.join(file).display().to_string();
        let output = Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(root()).args([&EQ_26[..], &["--export", &path]].concat()).output();
        String::from_utf8_lossy(&output.expect("the program starts").stderr).replace(&folder.display().to_string(), "DIR")
    };
    assert_eq!(
        wrong("model.xlsx"),
        "error[C0404]: --export DIR/model.xlsx: the ending says nothing\n  = help: write a MAT file (`model.mat`) or a script (`model.m`)\n"
    );
    std::fs::write(folder.join("mine.mat"), [0_u8, 159, 146, 150]).expect("a file");
    assert!(wrong("mine.mat").starts_with("error[C0401]: DIR/mine.mat stands there already"));
}

const SWEEP: [&str; 12] = [
    "lqr",
    "examples/rigs/quanser_ads.rig",
    "--inputs",
    "V_s,V_d",
    "--states",
    "elevation,elevation.dot,pitch,pitch.dot",
    "--weights-x",
    "100,10,50,5",
    "--weights-u",
    "0.01,0.01",
    "--sweep",
    "s=-0.12m:0.12m:5",
];

/// Gains at five positions of the carriage, as code: those of the design at its points, stabilizing between them.
#[test]
fn scheduled_gains_are_those_of_the_design_and_stabilize_between() {
    let folder = folder("schedule");
    let shown = folder.display().to_string();
    for lang in ["rust", "c"] {
        rig(&[&SWEEP[..], &["--generate", &shown, "--lang", lang]].concat());
    }
    let json = rig(&SWEEP);
    let points = json["points"].as_array().expect("points");
    assert_eq!(points.len(), 5);
    // the points, and values between and beyond them
    let grid: Vec<f64> = serde_json::from_value(json["sweep"]["values"].clone()).expect("values");
    let between = [-0.09, -0.031, 0.05, 0.113];
    let values: Vec<f64> = grid.iter().copied().chain(between).chain([-1.0, 1.0]).collect();
    let list = values.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>().join(", ");
    let main = format!(
        "#![allow(dead_code)]\nmod quanser_ads_schedule;\nuse quanser_ads_schedule as s;\nfn main() {{\n    for v in [{list}] {{\n        \
         s::gain(v).as_flattened().iter().chain(&s::inputs(v)).chain(&s::command(v, &[0.02, -0.1, 0.03, 0.05])).for_each(|x| println!(\"{{x:?}}\"));\n    }}\n}}\n"
    );
    std::fs::write(folder.join("main.rs"), main).expect("the program");
    let run = |program: &str, arguments: &[&str]| -> Option<Vec<f64>> {
        let built = Command::new(program).current_dir(&folder).args(arguments).output();
        let built = match built {
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return None,
            other => other.expect("the compiler starts"),
        };
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        let output = Command::new(folder.join("program")).output().expect("it runs");
        Some(String::from_utf8_lossy(&output.stdout).split_whitespace().map(|x| x.parse().expect("a number")).collect())
    };
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let rust = run(&rustc, &["--edition", "2024", "-D", "warnings", "-o", "program", "main.rs"]).expect("there is a Rust compiler");
    let main = format!(
        "#include \"quanser_ads_schedule.h\"\n#include <stdio.h>\nint main(void)\n{{\n    const double at[] = {{{list}}};\n    const double x[4] = {{0.02, -0.1, 0.03, 0.05}};\n    \
         for (int p = 0; p < {}; p++) {{\n        double k[2][4], u[2], v[2];\n        quanser_ads_schedule_gain(at[p], k);\n        quanser_ads_schedule_inputs(at[p], u);\n        quanser_ads_schedule_command(at[p], x, v);\n        \
         for (int i = 0; i < 2; i++) {{\n            for (int j = 0; j < 4; j++) {{\n                printf(\"%.17g\\n\", k[i][j]);\n            }}\n        }}\n        \
         printf(\"%.17g\\n%.17g\\n%.17g\\n%.17g\\n\", u[0], u[1], v[0], v[1]);\n    }}\n    return 0;\n}}\n",
        values.len()
    );
    std::fs::write(folder.join("main.c"), main).expect("the program");
    let flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O1", "-o", "program", "main.c", "quanser_ads_schedule.c", "-lm"];
    match run("cc", &flags) {
        Some(c) => assert!(c.len() == rust.len() && c.iter().zip(&rust).all(|(a, b)| (a - b).abs() <= 1e-12 * b.abs().max(1.0))),
        None => println!("generated C: skipped (there is no C compiler `cc`)"),
    }
    let x = DMatrix::from_column_slice(4, 1, &[0.02, -0.1, 0.03, 0.05]);
    let of = |p: usize| {
        let row = &rust[12 * p..12 * p + 12];
        (DMatrix::from_row_slice(2, 4, &row[..8]), row[8..10].to_vec(), row[10..].to_vec())
    };
    for (p, point) in points.iter().enumerate() {
        let (k, u, command) = of(p);
        let wanted = matrix(&point["K"]);
        assert!((&k - &wanted).norm() <= 1e-14 * wanted.norm(), "at {}", grid[p]);
        // V_f = (V_s + V_d)/2, V_b = (V_s - V_d)/2
        let v = &k * &x;
        let wanted = [(u[0] - (v[0] + v[1]) / 2.0).clamp(-24.0, 24.0), (u[1] - (v[0] - v[1]) / 2.0).clamp(-24.0, 24.0)];
        assert!(command.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{command:?} {wanted:?}");
    }
    assert_eq!((of(9).0, of(10).0), (of(0).0, of(4).0), "constant beyond the ends");
    for (i, value) in between.iter().enumerate() {
        let at = format!("s={value}");
        let linear = rig(&["linearize", "examples/rigs/quanser_ads.rig", "--inputs", "V_s,V_d", "--at", &at]);
        let names: Vec<String> = serde_json::from_value(linear["states"].clone()).expect("names");
        let keep: Vec<usize> = ["elevation", "elevation.dot", "pitch", "pitch.dot"]
            .iter()
            .map(|s| names.iter().position(|n| n == s).expect("a state"))
            .collect();
        let (a, b) = (matrix(&linear["points"][0]["A"]), matrix(&linear["points"][0]["B"]));
        let a = DMatrix::from_fn(4, 4, |i, j| a[(keep[i], keep[j])]);
        let b = DMatrix::from_fn(4, 2, |i, j| b[(keep[i], j)]);
        let closed = a - b * of(5 + i).0;
        let slowest = closed.complex_eigenvalues().iter().fold(f64::NEG_INFINITY, |m, z| m.max(z.re));
        assert!(slowest < -1.0, "s = {value}: {slowest}");
    }
    for file in ["quanser_ads_schedule.rs", "quanser_ads_schedule.h", "quanser_ads_schedule.c"] {
        let text = std::fs::read_to_string(folder.join(file)).expect("the file");
        insta::assert_snapshot!(file, rounded(&text));
    }
}

/// One point without a sweep, sampled and with an integral: no table, no argument.
#[test]
fn a_single_regulator_is_written_too() {
    let folder = folder("single");
    let shown = folder.display().to_string();
    let integral = ["--integrate", "eps", "--discrete", "5ms", "--generate", &shown];
    let mut arguments = EQ_26.to_vec();
    arguments[9] = "180,10,400,1,50";
    for lang in ["rust", "c"] {
        rig(&[&arguments[..], &integral[..], &["--lang", lang]].concat());
    }
    std::fs::write(folder.join("main.c"), "#include \"googol_identified_regulator.h\"\nint main(void)\n{\n    const double x[5] = {0};\n    double u[2];\n    googol_identified_regulator_command(x, u);\n    return u[0] > 0.05 && u[0] < 4.0 ? 0 : 1;\n}\n").expect("the program");
    let flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-o", "program", "main.c", "googol_identified_regulator.c", "-lm"];
    if let Ok(built) = Command::new("cc").current_dir(&folder).args(flags).output() {
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        assert!(Command::new(folder.join("program")).status().expect("it runs").success());
    }
    let text = std::fs::read_to_string(folder.join("googol_identified_regulator.rs")).expect("the file");
    insta::assert_snapshot!(rounded(&text));
}

/// Numbers to nine digits: the last ones are the machine's.
fn rounded(text: &str) -> String {
    let mut out = String::new();
    let mut word = String::new();
    for c in text.chars().chain(['\n']) {
        if c.is_ascii_alphanumeric() || c == '.' || c == '_' {
            word.push(c);
            continue;
        }
        match word.parse::<f64>() {
            Ok(x) if word.len() > 12 && word.starts_with(|c: char| c.is_ascii_digit()) => {
                out.push_str(&format!("{:?}", format!("{x:.9e}").parse::<f64>().unwrap_or(x)));
            }
            _ => out.push_str(&word),
        }
        word.clear();
        out.push(c);
    }
    out.trim_end().to_owned() + "\n"
}
