//! The system's C compiler, for tests of emitted C.

use std::path::PathBuf;
use std::process::Command;

/// What became of a program.
pub enum Compiled {
    /// It ran and printed this.
    Printed(String),
    /// There is no `cc` on this machine.
    NoCompiler,
}

/// Writes files to a folder of this name, compiles the `.c` ones as strict C99 without warnings, and runs the program.
///
/// # Panics
/// Shows what the compiler said, or how the program ended: this is for tests.
#[must_use]
pub fn compile_and_run(name: &str, files: &[(&str, &str)]) -> Compiled {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../target/emitted").join(name);
    // nothing of an earlier run may help this one
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    for (file, text) in files {
        std::fs::write(folder.join(file), text).unwrap_or_else(|e| panic!("{file}: {e}"));
    }
    let sources = files.iter().map(|f| f.0).filter(|f| f.ends_with(".c"));
    let mut cc = Command::new("cc");
    cc.current_dir(&folder).args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O1", "-o", "program"]).args(sources).arg("-lm");
    let built = match cc.output() {
        Ok(output) => output,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Compiled::NoCompiler,
        Err(error) => panic!("cc: {error}"),
    };
    assert!(built.status.success(), "{name}: the C compiler said\n{}", String::from_utf8_lossy(&built.stderr));
    let ran = Command::new(folder.join("program")).output().unwrap_or_else(|e| panic!("{name}: {e}"));
    assert!(ran.status.success(), "{name}: the program ended with {}", ran.status);
    Compiled::Printed(String::from_utf8_lossy(&ran.stdout).into_owned())
}
