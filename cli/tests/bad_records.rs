//! Broken records, each with the message as the program prints it: the file, the place in it, what is wrong, how to mend it.

use std::path::{Path, PathBuf};
use std::process::Command;

const RIG: &str = "rig Cart { param m: kg = 1; param c: N*s/m = 0.5; param k: N/m = 2; coord x: m; coord q: rad;
    equation m * x.ddot = F - c * x.dot - k * x; equation q.ddot = -9 [1/s^2] * q - 0.1 [1/s] * q.dot; input F: N in -5..5; }";

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bad_records").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder for the test");
    std::fs::write(path.join("cart.rig"), RIG).expect("the rig is written");
    path
}

/// What the program says to a record, and that it says it as a failure.
fn said(folder: &Path, command: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_rig"))
        .current_dir(folder)
        .env_remove("RIG_DATA")
        .args(command)
        .output()
        .expect("the program starts");
    let text = String::from_utf8_lossy(&output.stderr).trim_end().to_owned();
    assert_eq!(output.status.code(), Some(1), "{command:?}: {text}");
    assert!(!text.contains("panicked"), "{text}");
    text
}

const HEADER: &str = "t,F [N],x [mm],q [deg]\n";

/// 40 good rows, for records that go wrong at one place.
fn rows() -> Vec<String> {
    (0..40).map(|k| format!("{:.2},{},{},{}", 0.1 * f64::from(k), k % 5, k, 2 * k)).collect()
}

fn with(change: impl FnOnce(&mut Vec<String>)) -> Vec<u8> {
    let mut rows = rows();
    change(&mut rows);
    (HEADER.to_owned() + &rows.join("\n") + "\n").into_bytes()
}

#[test]
fn what_is_said_to_broken_csv_records() {
    let plain = || rows().join("\n") + "\n";
    let cases: Vec<(&str, Vec<u8>)> = vec![
        ("empty file", Vec::new()),
        ("header only", HEADER.into()),
        ("one sample", format!("{HEADER}0,1,2,3\n").into()),
        ("no header", plain().into()),
        ("no column of time", HEADER.replace("t,", "sample,").into_bytes().into_iter().chain(plain().into_bytes()).collect()),
        ("column missing in a row", with(|r| r[5] = "0.50,1,2".to_owned())),
        ("a cell too many", with(|r| r[5] = "0.50,1,2,3,4".to_owned())),
        ("empty cell", with(|r| r[5] = "0.50,1,,3".to_owned())),
        ("NaN", with(|r| r[5] = "0.50,1,NaN,3".to_owned())),
        ("infinite", with(|r| r[5] = "0.50,1,2,inf".to_owned())),
        ("text in a column", with(|r| r[5] = "0.50,1,overflow,3".to_owned())),
        ("time runs backwards", with(|r| r[5] = "0.10,1,2,3".to_owned())),
        ("time stands", with(|r| r[5] = "0.40,1,2,3".to_owned())),
        ("unit nonsense", HEADER.replace("mm", "milimeter").into_bytes().into_iter().chain(plain().into_bytes()).collect()),
        ("unit of another dimension", HEADER.replace("mm", "V").into_bytes().into_iter().chain(plain().into_bytes()).collect()),
        ("bracket left open", HEADER.replace("[mm]", "[mm").into_bytes().into_iter().chain(plain().into_bytes()).collect()),
        ("column twice", HEADER.replace("q [deg]", "x [mm]").into_bytes().into_iter().chain(plain().into_bytes()).collect()),
        ("column without name", HEADER.replace("q [deg]", "").into_bytes().into_iter().chain(plain().into_bytes()).collect()),
        ("input never logged", HEADER.replace("F [N]", "force [N]").into_bytes().into_iter().chain(plain().into_bytes()).collect()),
        (
            "outputs of another rig",
            HEADER.replace("x [mm]", "psi").replace("q [deg]", "eps").into_bytes().into_iter().chain(plain().into_bytes()).collect(),
        ),
        ("semicolons", (HEADER.to_owned() + &plain()).replace(',', ";").into()),
        ("tabs", (HEADER.to_owned() + &plain()).replace(',', "\t").into()),
        ("decimal commas", (HEADER.to_owned() + &plain()).replace(',', ";").replace('.', ",").into()),
        ("decimal commas between commas", with(|r| r.iter_mut().for_each(|r| *r = r.replace('.', ",")))),
        ("binary garbage", (0..2000_u32).map(|k| (k.wrapping_mul(2_654_435_761) >> 13) as u8).collect()),
        ("UTF-16", "\u{feff}t,F,x\n0,1,2\n".encode_utf16().flat_map(u16::to_le_bytes).collect()),
    ];
    let folder = folder("csv");
    let mut all = String::new();
    for (name, bytes) in cases {
        std::fs::write(folder.join("run.csv"), bytes).expect("the record is written");
        all += &format!("-- {name}\n{}\n\n", said(&folder, &["preflight", "cart.rig", "--data", "run.csv"]));
    }
    insta::assert_snapshot!(all);
}

#[test]
fn what_is_said_to_broken_files_and_descriptions() {
    let folder = folder("files");
    let made = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/records");
    let level5 = std::fs::read(made.join("level5_compressed.mat")).expect("a MAT file of the tests");
    let level4 = std::fs::read(made.join("level4.mat")).expect("a MAT file of the tests");
    let text = |mat: &str| format!("file = \"{mat}\"\nvariable = \"data\"\ntime = {{ column = 1 }}\n[signals]\nx = {{ column = 2 }}\n");
    let mut all = String::new();
    let mut case = |name: &str, file: &str, bytes: &[u8], toml: &str| {
        std::fs::write(folder.join(file), bytes).expect("the file is written");
        std::fs::write(folder.join("run.toml"), toml).expect("the description is written");
        all += &format!("-- {name}\n{}\n\n", said(&folder, &["preflight", "cart.rig", "--data", "run.toml"]));
    };
    case("MAT file cut short, level 5", "cut5.mat", &level5[..level5.len() * 2 / 3], &text("cut5.mat"));
    case("MAT file cut short, level 4", "cut4.mat", &level4[..level4.len() * 2 / 3], &text("cut4.mat"));
    case("MAT file of level 7.3", "new.mat", &[b"MATLAB 7.3 MAT-file".as_slice(), &[0; 600]].concat(), &text("new.mat"));
    case("no MAT file at all", "none.mat", b"hello, this is a text and no matrix\n", &text("none.mat"));
    case("empty MAT file", "empty.mat", b"", &text("empty.mat"));
    case("no such variable", "good.mat", &level5, &text("good.mat").replace("data", "dta"));
    case("no such file", "other.mat", &level5, &text("lost.mat"));
    case("unknown key", "good.mat", &level5, &text("good.mat").replace("variable", "varable"));
    case("no TOML", "good.mat", &level5, "file: good.mat\n");
    case(
        "decimal commas",
        "comma.txt",
        b"t;x\n0,0;1,5\n0,1;1,6\n",
        "file = \"comma.txt\"\ndelimiter = \"semicolon\"\n[signals]\nx = { column = \"x\" }\n",
    );
    case(
        "input neither logged nor declared",
        "good.csv",
        b"t,x\n0,1\n1,2\n2,3\n",
        "file = \"good.csv\"\n[signals]\nx = { column = \"x\", unit = \"m\" }\n",
    );
    all += &format!("-- a MAT file without a description\n{}\n\n", said(&folder, &["preflight", "cart.rig", "--data", "good.mat"]));
    all += &format!("-- no such record\n{}\n\n", said(&folder, &["preflight", "cart.rig", "--data", "lost.csv"]));
    all += &format!("-- a folder\n{}\n\n", said(&folder, &["preflight", "cart.rig", "--data", "."]));
    all += &format!("-- a rig as a record\n{}\n\n", said(&folder, &["preflight", "cart.rig", "--data", "cart.rig"]));
    std::fs::write(folder.join("short.csv"), "t,F,x,q\n0,0,1,1\n0.1,0,1.1,1.2\n").expect("the record is written");
    all += &format!("-- fewer samples than unknowns\n{}\n\n", said(&folder, &["identify", "cart.rig", "--data", "short.csv"]));
    insta::assert_snapshot!(all);
}

/// What is odd but usable is no failure: it is said as a fact or as a fault, and the program goes on.
#[test]
fn what_is_said_to_odd_records() {
    let folder = folder("odd");
    let mut seed = 1_u64;
    let mut jitter = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / (1_u64 << 31) as f64
    };
    let (mut huge, mut t) = (HEADER.to_owned(), 0.0);
    for k in 0..400 {
        t += 0.001 + 0.04 * jitter() * jitter();
        huge += &format!("{t:.5},{:.3},{:.3},0\n", if k % 80 < 40 { 7 } else { -7 }, 100.0 * (0.9 * t).sin());
    }
    std::fs::write(folder.join("odd.csv"), &huge).expect("the record is written");
    std::fs::write(folder.join("short.csv"), HEADER.to_owned() + &rows()[..12].join("\n")).expect("the record is written");
    let output = Command::new(env!("CARGO_BIN_EXE_rig"))
        .current_dir(&folder)
        .args(["preflight", "cart.rig", "--data", "odd.csv", "short.csv"])
        .output()
        .expect("the program starts");
    assert!(output.status.success());
    insta::assert_snapshot!(String::from_utf8_lossy(&output.stdout));
}

/// Signals that stand still have errors that vanish: the fit goes on with what moves, and says what it cannot tell.
#[test]
fn what_is_said_to_a_record_whose_signals_stand_still() {
    let folder = folder("still");
    let rig = "rig Two { param m: kg = 1; param c: N*s/m = 0.5; param k: N/m = 2 fixed; param d: 1/s = 0.1; coord x: m; coord q: rad;
    equation m * x.ddot = F - c * x.dot - k * x; equation q.ddot = -9 [1/s^2] * sin(q) - d * q.dot; input F: N in -5..5; output x: m = x; encoder q: 2400; }";
    std::fs::write(folder.join("two.rig"), rig).expect("the rig is written");
    let (mut text, mut x, mut v) = ("t,F,x,q\n".to_owned(), 0.0, 0.0);
    for k in 0..400 {
        let force = f64::from(k / 50 % 3);
        text += &format!("{:.2},{force},{x:.5},0\n", 0.02 * f64::from(k));
        for _ in 0..20 {
            v += 0.001 * (force - 0.6 * v - 2.0 * x) / 1.2;
            x += 0.001 * v;
        }
    }
    std::fs::write(folder.join("still.csv"), text).expect("the record is written");
    let output = Command::new(env!("CARGO_BIN_EXE_rig"))
        .current_dir(&folder)
        .args(["identify", "two.rig", "--data", "still.csv", "--rates", "rest"])
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout);
    let told: Vec<&str> =
        text.lines().filter(|l| ["without effect", "the records tell", "training"].iter().any(|w| l.contains(w))).collect();
    insta::assert_snapshot!(told.join("\n"));
}
