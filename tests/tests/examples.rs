//! Every example rig passes its checks and derives on both roads.

use codegen::{Options, derive};
use cross_checks::{example_rigs, rig_of};

#[test]
fn every_example_rig_derives() {
    let rigs = example_rigs();
    assert!(!rigs.is_empty());
    for path in rigs {
        let rig = rig_of(&path);
        let e = derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        println!(
            "{:24} {:?} ops {} / {}",
            path.file_stem().unwrap_or_default().to_string_lossy(),
            e.cross_check,
            e.forward_operations(),
            e.jacobian_operations()
        );
    }
}

/// A rig to copy has nothing that its checks warn of, a title, and a source or an explanation. (What an assumption
/// leaves without effect is a note, no warning.)
#[test]
fn every_example_rig_is_tidy() {
    for path in example_rigs() {
        let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
        let shown: Vec<String> = checked
            .diagnostics
            .iter()
            .filter(|d| d.severity != model_dsl::Severity::Note)
            .map(|d| d.render(&checked.sources, false))
            .collect();
        assert!(shown.is_empty(), "{}:\n{}", path.display(), shown.join("\n"));
        let rig = checked.rig.unwrap_or_else(|| panic!("{}", path.display()));
        assert!(rig.doc.lines().count() >= 3, "{}: a title and some lines about it", path.display());
        for line in std::fs::read_to_string(&path).unwrap_or_default().lines() {
            assert!(line.chars().count() <= 150 && line.trim_end() == line, "{}: {line}", path.display());
        }
    }
}
