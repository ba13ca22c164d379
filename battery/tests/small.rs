//! A small part of the battery: nothing hidden and nothing named; one large effect and its name.

use battery::conditions::NOTHING;
use battery::rigs::Rig;
use battery::run::{Hiding, Outcome, Task, run};
use battery::table::right;
use diagnose::Method;

fn outcome(hiding: Hiding, number: u64) -> Outcome {
    let task = Task {
        row: "test",
        part: "test".to_owned(),
        rig: Rig::Pendulum,
        condition: NOTHING[2],
        hiding,
        method: Method::default(),
        number,
        stream: "test".to_owned(),
    };
    run(&task, None, false).expect("this can be hidden in a pendulum")
}

#[test]
fn where_nothing_is_hidden_nothing_is_named() {
    for number in 0..2 {
        let found = outcome(Hiding::Nothing, number);
        assert!(!found.failed, "{}", found.because);
        assert!(found.said.is_empty(), "no. {number}: {:?}", found.said);
        // one run in twenty is screened by chance; then the test record must have the last word, as it has above
        assert!(found.verdict == "no_gap" || found.screening_p < 0.05, "no. {number}: {} {}", found.verdict, found.because);
    }
}

#[test]
fn a_large_hidden_effect_is_named() {
    let found = outcome(Hiding::This("coulomb", 8.0), 1);
    assert!(!found.failed, "{}", found.because);
    let said = found.said.first().unwrap_or_else(|| panic!("nothing was named: {}", found.because));
    assert!(right(said, &found, 0), "hidden {:?}, said {:?}", found.hidden, found.said);
    assert!(found.test_ratio.is_some_and(|r| r <= 1.0), "predicted no worse: {:?}", found.test_ratio);
}

#[test]
fn a_delay_shorter_than_a_sample_is_found_again_by_its_refit() {
    let found = outcome(Hiding::This("input_delay", 4.0), 1);
    assert!(!found.failed, "{}", found.because);
    let said = found.said.first().unwrap_or_else(|| panic!("nothing was named: {}", found.because));
    assert!(["input_delay", "actuator_lag", "sensor_delay"].contains(&said.effect.as_str()), "said {:?}", found.said);
    let (delay, sd) = said.values[0];
    let hidden = found.hidden[0].sizes[0];
    assert!(hidden < 0.01 && (delay - hidden).abs() < 4.0 * sd, "hidden {hidden} s, found {delay} +- {sd} s");
}

#[test]
fn play_between_joint_and_sensor_is_named() {
    let found = outcome(Hiding::This("backlash", 4.0), 1);
    assert!(!found.failed, "{}", found.because);
    let said = found.said.first().unwrap_or_else(|| panic!("nothing was named: {}", found.because));
    assert_eq!((said.effect.as_str(), said.place.as_str()), ("backlash", "theta"), "{:?}", found.said);
    let ((width, sd), hidden) = (said.values[0], found.hidden[0].sizes[0]);
    // the smooth law turns at once, the truth goes through its play first
    assert!((width - hidden).abs() < 4.0 * sd.max(0.05 * hidden), "hidden {hidden} rad, found {width} +- {sd} rad");
}
