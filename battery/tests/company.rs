//! Effects that are not alone: two that the records confirm only together, and a friction that no entry of the catalogue is.

use battery::conditions::{Condition, NOTHING};
use battery::rigs::Rig;
use battery::rows::tasks;
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
    let found = outcome("two", Rig::Drive, NOTHING[2], Hiding::These(&["actuator_drift", "actuator_lag"], 3.0), 6);
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
    let found = outcome("two", Rig::Pendulum, NOTHING[6], Hiding::These(&["spring", "actuator_deadzone"], 3.0), 10);
    assert_ne!(found.verdict, "bad_data", "{}", found.because);
    // stiffer than gravity: the base is lost, and what is tried has to begin anew
    assert!(all_right(&found), "{:?}: {}", found.said, found.because);
}

#[test]
fn what_stood_for_another_effect_gives_way_once_its_companion_is_there() {
    let found = outcome("two", Rig::DoublePendulum, NOTHING[1], Hiding::These(&["input_coupling", "sensor_drift"], 3.0), 39);
    assert!(all_right(&found), "{:?}: {}", found.said, found.because);
}

#[test]
fn a_compliance_is_found_with_its_resonance_and_damping() {
    let found = outcome("one", Rig::Pendulum, NOTHING[2], Hiding::This("flexible_mode", 3.0), 5);
    assert!(all_right(&found), "{:?}: {}", found.said, found.because);
    let (said, hidden) = (&found.said[0], &found.hidden[0]);
    assert_eq!(said.effect, "flexible_mode");
    for ((value, sd), truth) in said.values.iter().zip(&hidden.sizes) {
        assert!((value - truth).abs() < 3.0 * sd && *sd < 0.3 * truth, "{value} +- {sd}, hidden {truth}");
    }
}

#[test]
fn a_length_that_grew_into_a_spring_is_told() {
    // the spring is many times as stiff as gravity; a long arm does its work, until it is kept near the text
    let found = outcome("two", Rig::DoublePendulum, NOTHING[6], Hiding::These(&["spring", "backlash"], 3.0), 29);
    assert_eq!(found.verdict, "partial", "{:?}: {}", found.said, found.because);
    assert!(found.because.contains("where the text says 0.250 m"), "{}", found.because);
    let names: Vec<&str> = found.said.iter().map(|s| s.effect.as_str()).collect();
    assert_eq!(names, ["spring", "backlash"], "{}", found.because);
    let stiff = found.said[0].values[0];
    assert!((stiff.0 - found.hidden[0].sizes[0]).abs() < 3.0 * stiff.1, "{stiff:?}");
}

#[test]
fn a_search_whose_first_step_was_wrong_begins_once_more() {
    let rigs = [Rig::Pendulum, Rig::Drive, Rig::CartPole, Rig::Furuta, Rig::DoublePendulum];
    let all = tasks("two", 47, &rigs);
    let task = all.iter().find(|t| t.number == 46).expect("46 is less than 47");
    let found = run(task, None, false).expect("this can be hidden here");
    assert!(all_right(&found), "{:?}, hidden {:?}: {}", found.said, found.hidden, found.because);
}

#[test]
fn what_the_test_records_cannot_rule_out_is_listed_as_well() {
    // as large as what just shows: the training records find three as likely, of one of which the test record shows too little
    let small = Condition { reach: 0.1, ..NOTHING[1] };
    let found = outcome("one", Rig::DoublePendulum, small, Hiding::This("spring", 1.2), 3);
    let mut names: Vec<&str> =
        found.said.iter().flat_map(|s| s.equivalent.iter().map(|e| e.0.as_str()).chain([s.effect.as_str()])).collect();
    names.sort_unstable();
    assert_eq!(names, ["input_coupling", "sensor_misalignment", "spring"], "{}", found.because);
    assert_eq!(found.verdict, "ambiguous");
}
