//! Memory of compiled programs is given back. Alone in its process: other tests would be counted too.

use codegen::{Options, derive};
use cross_checks::random_rig::random_rig;
use jit::{Evaluation, InProcess};
use runtime::Model;

/// Pages of address space of this process, where the system tells.
fn pages() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    text.split_whitespace().next()?.parse().ok()
}

#[test]
fn dropped_models_give_their_memory_back() {
    let rig = model_dsl::check_text("random.rig", &random_rig(3, 2)).rig.expect("a random rig is a rig");
    let run = |times: usize| {
        for _ in 0..times {
            let e = derive(&rig, Options { jacobians: false, ..Options::default() }).unwrap_or_else(|error| panic!("{error}"));
            let model = InProcess::evaluated(e, Evaluation::Compiled);
            let d = model.dimensions();
            let mut p = vec![0.0; d.parameters];
            model.nominal(&mut p);
            let mut dx = vec![0.0; d.states()];
            model.rhs(0.0, &vec![0.1; d.states()], &vec![0.2; d.signals()], &p, &mut dx).expect("a regular point");
            assert!(model.interpreted_because().is_none());
        }
    };
    run(20);
    let Some(before) = pages() else { return };
    run(400);
    let after = pages().unwrap_or(before);
    // each program has at least one page of code
    assert!(after < before + 200, "{before} pages before, {after} after 400 programs");
}
