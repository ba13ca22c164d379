//! Wrong rigs and their messages: `tests/rigs/fail/*.rig`. A file's name is the rule that it breaks; the message that a
//! user sees stands at its end, in lines that begin with `//~`. `RIG_BLESS=1` writes them anew: then read each one as
//! the person who made the mistake. Good rigs are in `tests/rigs/statements`, one for each, and in `tests/rigs/pass`.

use model_dsl::{CATALOGUE, CheckOptions, Checked, Loader, Severity};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/rigs").join(name)
}

fn rigs(name: &str) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder(name))
        .expect("the folder of rigs")
        .map(|e| e.expect("an entry").path())
        .filter(|p| p.extension().is_some_and(|x| x == "rig"))
        .collect();
    paths.sort();
    paths
}

/// The rig and what is expected of it.
fn split(bytes: &[u8]) -> (Vec<u8>, String) {
    let at = bytes.windows(4).position(|w| w == b"\n//~").map_or(bytes.len(), |k| k + 1);
    let expected = String::from_utf8_lossy(&bytes[at..])
        .lines()
        .map(|l| l.strip_prefix("//~").unwrap_or(l))
        .map(|l| l.strip_prefix(' ').unwrap_or(l))
        .collect::<Vec<_>>()
        .join("\n");
    (bytes[..at].to_vec(), expected)
}

/// Reads from the folder, without the expected messages.
struct Folder(PathBuf);

impl Loader for Folder {
    fn load(&self, name: &str) -> Result<Vec<u8>, String> {
        let bytes = std::fs::read(self.0.join(name)).map_err(|_| "there is no such file".to_owned())?;
        let mut rig = split(&bytes).0;
        while rig.ends_with(b"\n\n") {
            rig.pop();
        }
        Ok(rig)
    }
}

fn check(folder_name: &str, path: &Path) -> Checked {
    let name = path.file_name().expect("a file").to_string_lossy().into_owned();
    model_dsl::check(&name, &Folder(folder(folder_name)), &CheckOptions::default())
}

fn rendered(checked: &Checked) -> String {
    let all: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    // nothing stands at the end of a line, so that editors leave the files alone
    all.join("\n\n").lines().map(str::trim_end).collect::<Vec<_>>().join("\n")
}

#[test]
fn every_wrong_rig_says_what_is_wrong() {
    let bless = std::env::var_os("RIG_BLESS").is_some();
    let mut wrong = Vec::new();
    for path in rigs("fail") {
        let checked = check("fail", &path);
        let bytes = std::fs::read(&path).expect("a readable file");
        let (mut rig, expected) = split(&bytes);
        let found = rendered(&checked);
        assert!(!checked.diagnostics.is_empty(), "{}: nothing is wrong", path.display());
        let errors = checked.diagnostics.iter().any(|d| d.severity == Severity::Error);
        assert_eq!(checked.rig.is_none(), errors, "{}: a rig comes out if and only if there is no error", path.display());
        if found == expected {
            continue;
        }
        if bless {
            while rig.ends_with(b"\n\n") {
                rig.pop();
            }
            rig.extend_from_slice(b"\n");
            for line in found.lines() {
                rig.extend_from_slice(format!("//~ {line}").trim_end().as_bytes());
                rig.push(b'\n');
            }
            std::fs::write(&path, rig).expect("a writable file");
        } else {
            wrong.push(format!("{}:\n{found}\n-- expected:\n{expected}", path.display()));
        }
    }
    assert!(wrong.is_empty(), "{}\n(RIG_BLESS=1 writes the messages anew)", wrong.join("\n\n"));
}

#[test]
fn every_good_rig_passes() {
    for name in ["statements", "pass"] {
        for path in rigs(name) {
            let checked = check(name, &path);
            let fine = checked.diagnostics.iter().all(|d| d.severity == Severity::Note);
            assert!(fine && checked.rig.is_some(), "{}:\n{}", path.display(), rendered(&checked));
        }
    }
}

#[test]
fn every_code_of_the_catalogue_has_a_wrong_rig_and_every_code_in_use_is_in_the_catalogue() {
    let shown: BTreeSet<&str> = rigs("fail").iter().flat_map(|p| check("fail", p).diagnostics).map(|d| d.code).collect();
    let known: BTreeSet<&str> = CATALOGUE.iter().map(|(code, _)| *code).collect();
    assert_eq!(known.len(), CATALOGUE.len(), "a code stands in the catalogue twice");
    let missing: Vec<&&str> = known.difference(&shown).collect();
    assert!(missing.is_empty(), "no wrong rig for {missing:?}");
    let mut used = BTreeSet::new();
    codes_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut used);
    let unknown: Vec<&String> = used.iter().filter(|c| !known.contains(c.as_str())).collect();
    assert!(unknown.is_empty(), "not in the catalogue: {unknown:?}");
    let idle: Vec<&&str> = known.iter().filter(|c| !used.contains(**c)).collect();
    assert!(idle.is_empty(), "in the catalogue, but nothing reports it: {idle:?}");
}

/// Codes in quotes in the sources, but for the catalogue itself.
fn codes_in(folder: &Path, out: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).expect("the sources").flatten() {
        let path = entry.path();
        if path.is_dir() {
            codes_in(&path, out);
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a source file");
        let text = text.split("pub const CATALOGUE").next().unwrap_or("");
        for part in text.split('"').filter(|p| p.len() == 5 && p.starts_with(['E', 'W', 'N']) && p[1..].bytes().all(|b| b.is_ascii_digit()))
        {
            // "E0200" is a bound in a comparison, no code
            if part != "E0200" {
                out.insert(part.to_owned());
            }
        }
    }
}
