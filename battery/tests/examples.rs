//! The records of `examples/hidden` are those of this program, and their rigs those of the battery.

use battery::examples::files;
use std::path::Path;

#[test]
fn examples_are_the_batterys_own() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/hidden");
    for (name, made) in files() {
        let path = folder.join(&name);
        let found = std::fs::read_to_string(&path)
            .unwrap_or_else(|e| panic!("{name}: {e}; run `cargo run -p battery -- --examples examples/hidden`"));
        if name.ends_with(".rig") {
            assert_eq!(found, made, "{name}");
            continue;
        }
        let record = ident::record::read(&path).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(record.t.len(), made.lines().count() - 1, "{name}");
        // other machines' sines may differ in the last place, so not every count is asked for
        let same = found.lines().zip(made.lines()).filter(|(a, b)| a == b).count();
        assert!(same * 10 > made.lines().count() * 9, "{name}: only {same} lines are as this program makes them");
    }
}
