//! Writing files without losing anything of the user's.

use crate::failure::Failure;
use std::path::Path;

/// The mark by which a file is known to be ours, in its first lines.
pub const MARK: &str = "Generated from `";

/// Writes a file. What stands there is replaced only if it carries our mark, or is equal, or `force` is given.
pub fn write(path: &Path, text: &str, force: bool) -> Result<(), Failure> {
    write_bytes(path, text.as_bytes(), force)
}

/// Refuses early what [`write`] would refuse: before work whose result has to go there.
pub fn permitted(path: &Path, force: bool) -> Result<(), Failure> {
    let foreign = match std::fs::read(path) {
        Ok(old) => !marked(&old),
        Err(_) => path.exists(),
    };
    if foreign && !force { Err(refuse(path)) } else { Ok(()) }
}

/// It carries our mark.
fn marked(old: &[u8]) -> bool {
    String::from_utf8_lossy(old).lines().take(8).any(|line| line.contains(MARK))
}

/// The same for a file that is no text; its mark stands in the first of its bytes.
pub fn write_bytes(path: &Path, bytes: &[u8], force: bool) -> Result<(), Failure> {
    if let Ok(old) = std::fs::read(path) {
        if old == bytes {
            return Ok(());
        }
        if !marked(&old) && !force {
            return Err(refuse(path));
        }
    } else if path.exists() && !force {
        return Err(refuse(path));
    }
    if let Some(parent) = path.parent().filter(|p| !p.as_os_str().is_empty()) {
        std::fs::create_dir_all(parent).map_err(|e| Failure::new("C0402", format!("cannot make the folder {}: {e}", parent.display())))?;
    }
    std::fs::write(path, bytes).map_err(|e| Failure::new("C0402", format!("cannot write {}: {e}", path.display())))
}

fn refuse(path: &Path) -> Failure {
    Failure::new("C0401", format!("{} stands there already and was not written by this program", path.display()))
        .with_help("choose another name, or overwrite it with --force")
}
