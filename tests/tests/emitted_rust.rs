//! Emitted Rust of rigs that are not checked in: compiled by rustc without warnings, run, and equal to the
//! in-process model through the model trait.

use cross_checks::close::relative;
use cross_checks::odd_rigs::odd_rigs;
use cross_checks::random::Random;
use cross_checks::states::Point;
use runtime::Model;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

const TOLERANCE: f64 = 1e-13;
const POINTS: usize = 6;

/// Everything that the trait gives, one list after the other; a singular mass matrix gives nothing.
fn all(model: &dyn Model, point: &Point) -> Vec<Vec<f64>> {
    let s = model.dimensions();
    let (n, m, np, ny) = (s.states(), s.signals(), s.parameters, s.outputs);
    let (t, x, u, p) = (point.t, &point.x, &point.u, &point.p);
    let (mut dx, mut dx_too, mut a, mut b) = (vec![0.0; n], vec![0.0; n], vec![0.0; n * n], vec![0.0; n * m]);
    let (mut by_p, mut y, mut c, mut dhdp) = (vec![0.0; n * np], vec![0.0; ny], vec![0.0; ny * n], vec![0.0; ny * np]);
    assert!(model.rhs(t, x, u, p, &mut dx).is_ok());
    assert!(model.linearize(t, x, u, p, &mut dx_too, &mut a, &mut b).is_ok());
    assert!(model.parameter_jacobian(t, x, u, p, &mut by_p).is_ok());
    model.outputs(t, x, p, &mut y);
    model.output_jacobian(t, x, p, &mut c, &mut dhdp);
    let delays = (0..s.inputs).map(|i| model.input_path(i, p).delay).collect();
    let ways = (0..ny).map(|i| model.output_path(i, p)).flat_map(|path| [path.delay, path.play, path.quantum]).collect();
    vec![dx, dx_too, a, b, by_p, y, c, dhdp, delays, ways]
}

/// The same as a program over the emitted module.
fn program(name: &str, points: &[Point]) -> String {
    let mut out = String::from("mod model;\nuse runtime::Model;\n\nfn main() {\n    let mut point = Vec::new();\n");
    for point in points {
        let _ = writeln!(
            out,
            "    point.push(({:?}, vec!{:?} as Vec<f64>, vec!{:?} as Vec<f64>, vec!{:?} as Vec<f64>));",
            point.t, point.x, point.u, point.p
        );
    }
    let _ = write!(
        out,
        "    let model = model::{name};
    let s = model.dimensions();
    let (n, m, np, ny) = (s.states(), s.signals(), s.parameters, s.outputs);
    for (t, x, u, p) in &point {{
        let (mut dx, mut dx_too, mut a, mut b) = (vec![0.0; n], vec![0.0; n], vec![0.0; n * n], vec![0.0; n * m]);
        let (mut by_p, mut y, mut c, mut dhdp) = (vec![0.0; n * np], vec![0.0; ny], vec![0.0; ny * n], vec![0.0; ny * np]);
        model.rhs(*t, x, u, p, &mut dx).unwrap();
        model.linearize(*t, x, u, p, &mut dx_too, &mut a, &mut b).unwrap();
        model.parameter_jacobian(*t, x, u, p, &mut by_p).unwrap();
        model.outputs(*t, x, p, &mut y);
        model.output_jacobian(*t, x, p, &mut c, &mut dhdp);
        let delays: Vec<f64> = (0..s.inputs).map(|i| model.input_path(i, p).delay).collect();
        let ways: Vec<f64> = (0..ny).map(|i| model.output_path(i, p)).flat_map(|path| [path.delay, path.play, path.quantum]).collect();
        for value in [dx, dx_too, a, b, by_p, y, c, dhdp, delays, ways].concat() {{
            println!(\"{{value:?}}\");
        }}
    }}
}}
"
    );
    out
}

fn rustc(folder: &Path, arguments: &[&str]) {
    let program = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(program)
        .current_dir(folder)
        .args(["--edition", "2024"])
        .args(arguments)
        .output()
        .unwrap_or_else(|e| panic!("rustc: {e}"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn odd_rigs_compile_and_agree() {
    let folder = cross_checks::root().join("target/emitted/rust");
    std::fs::create_dir_all(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    // with the standard library's functions the runtime needs no other crate
    let runtime = cross_checks::root().join("runtime/src/lib.rs").display().to_string();
    rustc(&folder, &["--crate-type", "rlib", "--crate-name", "runtime", "--cfg", "feature=\"std\"", "--cap-lints", "allow", &runtime]);
    for (name, e) in odd_rigs() {
        let text = codegen::emit::rust(&e, &format!("{name}.rig"));
        let long = text.lines().find(|line| line.chars().count() > 140);
        assert!(long.is_none(), "{name}: longer than 140 columns: {long:?}");
        assert_eq!(text.contains("_part_2"), name == "long", "{name}: only long functions are cut");
        let model = codegen::emit::rust_model_name(&e);
        let mut random = Random::new(3);
        let points: Vec<Point> = (0..POINTS).map(|_| Point::random(&e, &mut random)).collect();
        std::fs::write(folder.join("model.rs"), &text).unwrap_or_else(|e| panic!("{e}"));
        std::fs::write(folder.join("main.rs"), program(&model, &points)).unwrap_or_else(|e| panic!("{e}"));
        // functions that this program does not call are there for others
        rustc(&folder, &["-D", "warnings", "-A", "dead_code", "--extern", "runtime=libruntime.rlib", "-o", name, "main.rs"]);
        let ran = Command::new(folder.join(name)).output().unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(ran.status.success(), "{name}: {}", String::from_utf8_lossy(&ran.stderr));
        let printed = String::from_utf8_lossy(&ran.stdout).into_owned();
        let mut lines = printed.lines();
        let other = jit::InProcess::new(e);
        for point in &points {
            for (k, wanted) in all(&other, point).into_iter().enumerate() {
                let found: Vec<f64> = wanted.iter().map(|_| lines.next().and_then(|l| l.parse().ok()).unwrap_or(f64::NAN)).collect();
                let difference = relative(&found, &wanted, f64::MIN_POSITIVE);
                assert!(difference < TOLERANCE, "{name}, result {k}: {difference:.1e}\n{found:?}\n{wanted:?}");
            }
        }
    }
}
