//! Effects that are not alone: two that the records confirm only together, and a friction that no entry of the catalogue is.

use battery::conditions::{Condition, NOTHING};
use battery::rigs::Rig;
use battery::run::{Hiding, Outcome, Task, run};
use battery::table::all_right;
use diagnose::Method;

fn outcome(row: &'static str, rig: Rig, condition: Condition, hiding: Hiding, number: u64) -> Outcome {
    let task =
        Task { row, part: row.to_owned(), rig, condition, hiding, method: Method::default(), number, stream: format!("{row} {row}") };
    run(&task, None, false).expect("this can be hidden here")
}

#[test]
fn effects_that_contradict_between_records_while_one_is_missing_pass_together() {
    // alone, each record shows another size of the lag, and the drift is its shadow
    let found = outcome("two", Rig::Drive, NOTHING[2], Hiding::Some(2, 3.0), 6);
    let hidden: Vec<&str> = found.hidden.iter().map(|h| h.effect.as_str()).collect();
    assert_eq!(hidden, ["actuator_drift", "actuator_lag"]);
    assert!(all_right(&found), "{:?}: {}", found.said, found.because);
}

#[test]
fn friction_that_depends_on_position_is_called_by_what_it_is() {
    let found = outcome("outside", Rig::Pendulum, NOTHING[1], Hiding::Outside("position_friction", 5.0), 0);
    assert!(!found.failed, "{}", found.because);
    // it has three waves a turn, which no effect of the catalogue has
    assert_eq!(found.verdict, "partial", "{:?}: {}", found.said, found.because);
    assert!(found.because.contains("is not the same everywhere: repeating 3 times per turn of theta"), "{}", found.because);
}

#[test]
fn a_spring_that_the_text_lacks_makes_no_strangers_of_the_records() {
    let found = outcome("two", Rig::Pendulum, NOTHING[6], Hiding::Some(2, 3.0), 10);
    assert!(found.hidden.iter().any(|h| h.effect == "spring"), "{:?}", found.hidden);
    assert_ne!(found.verdict, "bad_data", "{}", found.because);
}
