//! What the emitted files look like, for review: the whole text for two rigs.

use codegen::{Options, derive};
use cross_checks::{rig_of, root};

#[test]
fn emitted_files_read_well() {
    for name in ["cart_pole", "googol_mrb"] {
        let rig = rig_of(&root().join(format!("examples/rigs/{name}.rig")));
        let e = derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let source = format!("{name}.rig");
        insta::assert_snapshot!(format!("{name}_rust"), codegen::emit::rust(&e, &source));
        let c = codegen::emit::c(&e, &source);
        insta::assert_snapshot!(format!("{name}_header"), c.header);
        insta::assert_snapshot!(format!("{name}_c"), c.source);
    }
}
