//! `rig new --example` as its users run it, in an empty folder.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("example_{name}"));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn rig(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(folder).args(arguments).output().expect("the program starts")
}

fn text(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Every file of `examples/rigs` is carried, as it stands there.
#[test]
fn every_example_is_handed_out_as_it_is() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, |p| p.join("examples/rigs"));
    let files = std::fs::read_dir(&here).expect("the examples").map(|f| f.expect("an entry").path());
    let mut names: Vec<String> = files
        .filter(|path| path.extension().is_some_and(|e| e == "rig"))
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    names.sort();
    let all = folder("all");
    let listed = text(&rig(&all, &["new", "--example"]));
    insta::assert_snapshot!("examples", listed);
    let known: Vec<&str> = listed.lines().filter_map(|l| l.split_whitespace().next()).filter(|&n| n != "next:").collect();
    assert_eq!(known, names);
    for name in names {
        let folder = folder(&name);
        text(&rig(&folder, &["new", "--example", &name]));
        let file = format!("{name}.rig");
        assert_eq!(std::fs::read(folder.join(&file)).expect("written"), std::fs::read(here.join(&file)).expect("the example"));
        text(&rig(&folder, &["check", &file]));
    }
}

/// What an example extends comes with it; nothing is overwritten, and nothing written where one file is refused.
#[test]
fn an_example_brings_its_bases_and_overwrites_nothing() {
    let folder = folder("bases");
    let said = text(&rig(&folder, &["new", "--example", "quanser_ads_driven", "--out", "mine.rig"]));
    assert_eq!(
        said,
        "wrote quanser.rig and quanser_ads.rig and mine.rig: Quanser 3-DOF helicopter with the active disturbance system, its carriage \
         driven by its motor\nnext: `rig show mine.rig`\n"
    );
    // the base stands there as it is carried: it is used
    assert!(text(&rig(&folder, &["new", "--example", "quanser_ads", "--out", "second.rig"])).starts_with("wrote second.rig: "));
    std::fs::write(folder.join("quanser.rig"), "rig Quanser { }").expect("a base of the user's own");
    let refused = rig(&folder, &["new", "--example", "quanser_ads", "--out", "third.rig"]);
    let said = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(1));
    assert!(said.contains("C0401") && said.contains("quanser.rig stands there already"), "{said}");
    assert!(!folder.join("third.rig").exists());
}

#[test]
fn a_wrong_example_is_told_and_a_record_is_no_example() {
    let folder = folder("wrong");
    let refused = rig(&folder, &["new", "--example", "quanzer"]);
    let said = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(1));
    assert!(said.contains("there is no example `quanzer`") && said.contains("quanser"), "{said}");
    for usage in
        [&["new"][..], &["new", "Bench"], &["new", "Bench", "--example", "quanser"], &["new", "--example", "emps", "--data", "a.csv"]]
    {
        assert_eq!(rig(&folder, usage).status.code(), Some(2), "{usage:?}");
    }
}
