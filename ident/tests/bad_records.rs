//! Every fault of a record with its message: file, column, row, and what to do.

mod common;

use common::{Random, folder, made};
use ident::record::{Record, read_with};
use std::path::Path;

/// Writes the file, reads it as a record and returns the message without the folder.
fn message(test: &str, file: &str, text: impl AsRef<[u8]>) -> String {
    let folder = folder(test);
    std::fs::write(folder.join(file), text).unwrap();
    shown(&folder, read_with(&folder.join(file), None))
}

fn shown(folder: &Path, result: Result<Record, ident::record::RecordError>) -> String {
    match result {
        Ok(record) => panic!("read: {record:?}"),
        Err(e) => e.to_string().replace(&format!("{}/", folder.display()), ""),
    }
}

/// A test's own folder each: they run side by side.
fn csv(text: &str) -> String {
    message(&format!("csv{:?}", std::thread::current().id()), "run.csv", text)
}

#[test]
fn a_good_record() {
    let folder = folder("good");
    std::fs::write(folder.join("run.csv"), "\u{feff}t [ms], theta [deg] ,V\r\n0,0,1\r\n5,180,-1\r\n12,90,0.5\r\n").unwrap();
    let record = read_with(&folder.join("run.csv"), None).unwrap();
    assert_eq!(record.t, [0.0, 0.005, 0.012]);
    let theta = &record.column("theta").unwrap().values;
    assert!((theta[1] - std::f64::consts::PI).abs() < 1e-15);
    assert_eq!(record.column("V").unwrap().values, [1.0, -1.0, 0.5]);
    assert!((record.duration() - 0.012).abs() < 1e-15 && (record.period() - 0.007).abs() < 1e-15);
}

#[test]
fn cells_and_rows() {
    assert_eq!(csv("t,theta\n0,1\n1,\n"), "run.csv: line 3: the cell of `theta` is empty; cut the record there, or fill in the sample");
    assert_eq!(csv("t,theta\n0,1\n1,abc\n"), "run.csv: line 3: `abc` in column `theta` is no number");
    assert_eq!(csv("t,theta\n0,1\n1,NaN\n"), "run.csv: line 3: `theta` is NaN; cut the record there (`from`, `to` in a description)");
    assert_eq!(csv("t,theta\n0,1\n1,inf\n"), "run.csv: line 3: `theta` is inf; cut the record there (`from`, `to` in a description)");
    assert_eq!(
        csv("t,theta\n0,1\n1,2,3\n"),
        "run.csv: line 3 has 3 cells, the lines before it have 2; decimal commas split numbers in two: export with decimal points"
    );
    assert_eq!(
        csv("t,theta\n0,1,2\n1,2,3\n"),
        "run.csv: line 2 has 3 cells, the lines before it have 2; decimal commas split numbers in two: export with decimal points"
    );
    assert_eq!(csv("t,theta\n0,1\n\n1,2\n"), "run.csv: line 3: the cell of `t` is empty; cut the record there, or fill in the sample");
}

#[test]
fn time() {
    assert_eq!(
        csv("t,theta\n0,1\n2,1\n1,1\n"),
        "run.csv: line 4: time runs backwards, from 2 s to 1 s; sort the samples, or split the record into runs"
    );
    assert_eq!(
        csv("t,theta\n0,1\n1,1\n1,1\n"),
        "run.csv: line 4: the time 1 s occurs twice; where a rounded time column was exported, leave it out and give the `rate` in a description"
    );
    assert_eq!(
        csv("time,theta\n0,1\n1,1\n"),
        "run.csv: there is no column of time; name it `t` (seconds), or give its column or the rate in a description file (columns: `time` and `theta`)"
    );
    assert_eq!(csv("t [m],theta\n0,1\n1,1\n"), "run.csv: `m` is no unit of time; write `t` (seconds), `t [ms]` or `t [min]`");
    assert_eq!(csv("t,theta\n0,1\n"), "run.csv: a record needs at least two samples, this has 1");
}

#[test]
fn header() {
    assert_eq!(
        csv("0,1\n1,2\n2,3\n"),
        "run.csv: the first line starts with the number `0`; it has to name the columns: `t, theta [deg], u`"
    );
    assert_eq!(csv("t,theta,theta\n0,1,2\n1,1,2\n"), "run.csv: two columns are named `theta`");
    assert_eq!(csv("t,\n0,1\n1,1\n"), "run.csv: column 2 has no name in the first line");
    assert_eq!(
        csv("t,theta [degg]\n0,1\n1,1\n"),
        "run.csv: unit of `theta`: there is no unit `degg`; write it as rigs do (`deg`, `mm`, `N*m`, `rad/s`), or leave it out where it is SI"
    );
    assert_eq!(
        csv("t,theta [deg\n0,1\n1,1\n"),
        "run.csv: the column name `theta [deg` has no unit in brackets at its end; write `theta [deg]`"
    );
    assert_eq!(
        csv("t,theta\n"),
        "run.csv: there are no samples; the first line names the columns (`t, theta [deg], u`), each line after it is one sample"
    );
    assert_eq!(
        csv(""),
        "run.csv: there are no samples; the first line names the columns (`t, theta [deg], u`), each line after it is one sample"
    );
}

#[test]
fn files() {
    let nowhere = folder("files").join("none.csv");
    let text = shown(&folder("files"), read_with(&nowhere, None));
    assert!(text.starts_with("none.csv: cannot be read: "), "{text}");
    assert_eq!(
        message("files", "run.csv", b"t,theta\n0,1\n1,\xff\n"),
        "run.csv: line 3 is not UTF-8 text; export the record as UTF-8 CSV, or describe a MATLAB file in a .toml"
    );
    assert_eq!(
        message("files", "run.mat", b"x"),
        "run.mat: a MATLAB file does not say what its columns are; write a .toml beside it that names the file, the variable and the column of each signal"
    );
}

/// A description beside a MATLAB file and a text file.
fn toml(text: &str) -> String {
    let name = format!("toml{:?}", std::thread::current().id());
    let folder = folder(&name);
    for name in ["run.mat", "level5.mat", "level4.mat"] {
        std::fs::copy(made(name), folder.join(name)).unwrap();
    }
    std::fs::write(folder.join("log.csv"), "t,a,b\n0,1,2\n1,3,nan\n2,5,6\n").unwrap();
    std::fs::write(folder.join("short.csv"), "t,a\n0,1\n1,3\n").unwrap();
    message(&name, "run.toml", text)
}

const RUN: &str = "file = \"run.mat\"\nvariable = \"data\"\norientation = \"rows\"\ntime = { column = 1 }\n";

#[test]
fn description_keys() {
    assert_eq!(toml("file = \"run.mat\"\nx\n"), "run.toml: line 2: key with no value, expected `=`");
    assert_eq!(
        toml(&format!("{RUN}[signals]\nx = {{ colunm = 2 }}\n")),
        "run.toml: there is no key `signals.x.colunm`; did you mean `column`?"
    );
    assert_eq!(
        toml(&format!("varable = \"x\"\n{RUN}[signals]\nx = {{ column = 2 }}\n")),
        "run.toml: there is no key `varable`; did you mean `variable`?"
    );
    assert_eq!(
        toml(&format!("{RUN}[signals]\nx = {{ column = 2 }}\n[inputs]\nu = {{ value = 2 }}\n")),
        "run.toml: there is no key `inputs.u.value`; the keys here are constant, steps, unit"
    );
    assert_eq!(toml("file = 3\n[signals]\nx = { column = 2 }\n"), "run.toml: `file` takes a text in quotes");
    assert_eq!(toml(RUN), "run.toml: the key `signals` is missing: each measured signal has a table `[signals.NAME]`");
    assert_eq!(
        toml(&format!("start = \"rest\"\n{RUN}[signals]\nx = {{ column = 2 }}\n")),
        "run.toml: `start` takes \"at_rest\", \"settled\" or \"free\""
    );
    assert_eq!(toml(&format!("{RUN}[signals]\nx = {{ column = 2, sign = 2 }}\n")), "run.toml: `signals.x.sign` takes 1 or -1");
    assert_eq!(
        toml(&format!("{RUN}[signals]\nx = {{ column = 2, limits = [5, -5] }}\n")),
        "run.toml: `signals.x.limits` takes two numbers, the lower one first: `[-5, 5]`"
    );
    assert_eq!(
        toml(&format!("{RUN}[signals]\nx = {{ column = 2, unit = \"degg\" }}\n")),
        "run.toml: unit of `x`: there is no unit `degg`; write it as rigs do (`deg`, `mm`, `N*m`, `rad/s`), or leave it out where it is SI"
    );
    assert_eq!(
        toml(&format!("{RUN}[signals]\nx = {{ unit = \"deg\" }}\n")),
        "run.toml: the key `signals.x.column` is missing: it says where in the file the signal stands"
    );
    assert_eq!(
        toml(&format!("rate = 100\n{RUN}[signals]\nx = {{ column = 2 }}\n")),
        "run.toml: `time` needs exactly one of `rate` and `[time]`"
    );
    assert_eq!(
        toml("rate = 100\n[signals]\nx = { column = 2 }\n"),
        "run.toml: the key `signals.x.file` is missing: it names the file with the samples"
    );
    assert_eq!(
        toml("rate = 0\nfile = \"log.csv\"\n[signals]\nx = { column = 2 }\n"),
        "run.toml: `rate` takes a positive number of samples per second"
    );
}

#[test]
fn described_files_and_columns() {
    assert_eq!(
        toml("file = \"lost/run.mat\"\n[signals]\nx = { column = 2 }\n"),
        "run.toml: the file `lost/run.mat` is not there; looked for it at `lost/run.mat`; the environment variable RIG_DATA, which may name the folder of records, is not set"
    );
    assert_eq!(
        toml("file = \"run.mat\"\nvariable = \"dta\"\ntime = { column = 1 }\n[signals]\nx = { column = 2 }\n"),
        "run.mat: there is no variable `dta`; matrices of numbers in this file: `data` and `other`"
    );
    assert_eq!(
        toml("file = \"run.mat\"\ntime = { column = 1 }\n[signals]\nx = { column = 2 }\n"),
        "run.mat: say which variable: `variable = \"..\"`; matrices of numbers in this file: `data` and `other`"
    );
    assert_eq!(
        toml("file = \"level5.mat\"\nvariable = \"struct\"\ntime = { column = 1 }\n[signals]\nx = { column = 2 }\n"),
        "level5.mat: the variable `struct` is a struct, not a matrix of numbers; in MATLAB save its columns: `data = [t, y1, y2]; save('run.mat', 'data', '-v7')`"
    );
    assert_eq!(toml(&format!("{RUN}[signals]\nx = {{ column = 4 }}\n")), "run.mat: `x` wants column 4, there are columns 1 to 3");
    assert_eq!(toml(&format!("{RUN}[signals]\nx = {{ column = 0 }}\n")), "run.mat: `x` wants column 0, there are columns 1 to 3");
    assert_eq!(
        toml("file = \"log.csv\"\n[signals]\nx = { column = \"c\" }\n"),
        "log.csv: `x` wants the column `c`; there are `t`, `a` and `b`"
    );
    assert_eq!(
        toml("file = \"log.csv\"\n[signals]\nx = { column = \"b\" }\n"),
        "log.csv: line 3: `b` is NaN; cut the record there (`from`, `to` in a description)"
    );
    assert_eq!(
        toml("file = \"log.csv\"\n[signals]\na = { column = \"a\" }\nx = { column = \"a\", file = \"short.csv\" }\n"),
        "short.csv: `x` has 2 samples, the record has 3; signals of several files must have been logged together"
    );
    assert_eq!(
        toml("file = \"log.csv\"\nfrom = 5\n[signals]\na = { column = \"a\" }\n"),
        "run.toml: fewer than two samples lie between 5 s and 2 s; the file goes from 0 s to 2 s"
    );
}

#[test]
fn expressions_and_declared_inputs() {
    assert_eq!(
        toml(&format!("{RUN}[signals]\nx = {{ expression = \"(a - b\" }}\n")),
        "run.toml: expression of `x`: `)` is missing at the end"
    );
    assert_eq!(
        toml("file = \"log.csv\"\n[signals]\nx = { expression = \"a - c\" }\n"),
        "log.csv: `x` wants the column `c`; there are `t`, `a` and `b`"
    );
    assert_eq!(
        toml(&format!("{RUN}[signals]\nx = {{ expression = \"a\", column = 2 }}\n")),
        "run.toml: `signals.x` needs exactly one of `column` and `expression`"
    );
    assert_eq!(
        toml("file = \"log.csv\"\n[signals]\nx = { expression = \"1 / (a - 1)\" }\n"),
        "log.csv: line 2: `x` is inf; cut the record there (`from`, `to` in a description)"
    );
    let input = |text: &str| toml(&format!("{RUN}[signals]\nx = {{ column = 2 }}\n[inputs]\nu = {text}\n"));
    assert_eq!(input("{ unit = \"V\" }"), "run.toml: `inputs.u` needs exactly one of `constant` and `steps`");
    assert_eq!(
        input("{ steps = [[1, 2]] }"),
        "run.toml: steps of `u`: the first one is at 1 s, after the first sample at 0 s; say the value before it too"
    );
    assert_eq!(input("{ steps = [[0, 2], [3, 1], [2, 1]] }"), "run.toml: steps of `u`: their times must increase, 2 s comes after 3 s");
    assert_eq!(input("{ steps = [[0, 2], 3] }"), "run.toml: `inputs.u.steps` takes pairs of time and value: `[[0, 1.7], [25, 1.3]]`");
    assert_eq!(input("{ steps = [] }"), "run.toml: steps of `u`: there is none");
}

#[test]
fn damaged_texts_never_panic() {
    let folder = folder("fuzz");
    std::fs::copy(made("run.mat"), folder.join("run.mat")).unwrap();
    let mut random = Random(7);
    let csv = "t,theta [deg],V\n0,1,2\n0.1,-3.5e-1,4\n0.2,5,6\n";
    let toml = format!(
        "{RUN}from = 0.25\n[columns]\na = 2\n[signals]\nx = {{ expression = \"-(a + 1)^2 / 3\", limits = [-1, 1], unit = \"deg\" }}\n[inputs]\nu = {{ steps = [[0, 1]] }}\n"
    );
    for (file, text) in [("run.csv", csv), ("run.toml", &toml)] {
        std::fs::write(folder.join(file), text).unwrap();
        assert!(read_with(&folder.join(file), None).is_ok());
        for _ in 0..300 {
            let mut bytes = text.as_bytes().to_vec();
            random.mutate(&mut bytes);
            std::fs::write(folder.join(file), &bytes).unwrap();
            if let Err(e) = read_with(&folder.join(file), None) {
                assert!(!e.to_string().is_empty());
            }
        }
    }
}
