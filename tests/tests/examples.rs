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
