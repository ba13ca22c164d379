//! Where a page comes from: the program's version, and the SHA-256 of each file that it was made of (as `sha256sum` prints it).

use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The program, then each file with its hash; the data file of a description too.
pub fn provenance(files: &[&Path]) -> Vec<(String, String)> {
    let mut all: Vec<PathBuf> = Vec::new();
    for file in files {
        let described = described(file);
        for path in std::iter::once(file.to_path_buf()).chain(described) {
            if !all.contains(&path) {
                all.push(path);
            }
        }
    }
    let mut list = vec![("program".to_owned(), format!("rig {}", env!("CARGO_PKG_VERSION")))];
    list.extend(all.iter().map(|path| {
        let name = crate::commands::linearize::source_name(path);
        (name, std::fs::read(path).map_or_else(|e| format!("cannot be read again: {e}"), |bytes| format!("SHA-256 {}", hex(&bytes))))
    }));
    list
}

/// The data file of a description, where the reader of records finds it.
fn described(path: &Path) -> Option<PathBuf> {
    if path.extension().is_none_or(|e| e != "toml") {
        return None;
    }
    let text = std::fs::read_to_string(path).ok()?;
    let table: toml::Table = toml::from_str(&text).ok()?;
    let file = table.get("file")?.as_str()?;
    let beside = path.parent().map_or_else(|| PathBuf::from(file), |folder| folder.join(file));
    if beside.exists() {
        return Some(beside);
    }
    std::env::var_os("RIG_DATA").map(|data| Path::new(&data).join(file)).filter(|p| p.exists())
}

fn hex(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
