//! The emitted C: compiled by the system's compiler without warnings, run, and equal to the graph's own evaluation.

use codegen::{Equations, Options, derive};
use cross_checks::c_program::c_agrees_with_the_graph;
use cross_checks::odd_rigs::odd_rigs;
use cross_checks::{example_rigs, rig_of};

fn check(name: &str, e: &Equations) {
    if !c_agrees_with_the_graph(name, e) {
        println!("emitted C of {name}: skipped (there is no C compiler `cc`)");
    }
}

#[test]
fn every_function_of_the_example_rigs_agrees_with_the_graph() {
    for path in example_rigs() {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let e = derive(&rig_of(&path), Options::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
        check(&name, &e);
    }
}

#[test]
fn every_function_of_odd_rigs_agrees_with_the_graph() {
    for (name, e) in odd_rigs() {
        check(name, &e);
    }
}
