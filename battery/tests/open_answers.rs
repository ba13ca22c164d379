//! Where the records leave something open, the answer says so, and what would settle it: effects of the day, effects that no record can
//! tell apart, and the experiment that could.

use battery::conditions::{Condition, DAY, NOTHING};
use battery::rigs::Rig;
use battery::run::{Hiding, Outcome, Task, run};
use diagnose::patch::check;
use diagnose::{Diagnosis, Method, Options, Verdict, diagnose};
use ident::fit::ParameterSpec;
use ident::record::{Record, read};
use std::path::Path;

fn outcome(row: &'static str, hiding: Hiding, condition: Condition, folder: &Path) -> Outcome {
    let task = Task {
        row,
        part: "test".to_owned(),
        rig: Rig::Pendulum,
        condition,
        hiding,
        method: Method::default(),
        number: 1,
        stream: "test".to_owned(),
    };
    std::fs::create_dir_all(folder).unwrap();
    run(&task, Some(folder), false).expect("this can be hidden in a pendulum")
}

/// The same records once more, as the program has them, with a look for the next experiment.
fn again(row: &str, folder: &Path, only: &[&str]) -> Diagnosis {
    let stem = folder.join(format!("{row}_test_pendulum_1"));
    let text = std::fs::read_to_string(stem.with_extension("rig")).unwrap();
    let base = check(&[("pendulum.rig".to_owned(), text)], "Pendulum").unwrap();
    let specs = ParameterSpec::of_rig(&base.rig);
    let record = |name: &str| -> Record { read(Path::new(&format!("{}_{name}.csv", stem.display()))).unwrap_or_else(|e| panic!("{e}")) };
    let options = Options { next: true, only: only.iter().map(|id| (*id).to_owned()).collect(), ..Options::default() };
    diagnose(&base, &specs, &[record("steps"), record("sines")], &[record("chirp")], &options).unwrap_or_else(|e| panic!("{e}"))
}

fn folder(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

#[test]
fn what_belongs_to_the_day_is_said_to() {
    let found = outcome("day", Hiding::Nothing, DAY, &folder("day"));
    assert!(!found.failed, "{}", found.because);
    let [said] = &found.said[..] else { panic!("{:?}: {}", found.said, found.because) };
    assert!(said.by_record, "{said:?}");
    // one torque in both training records
    let [(a, s), (b, t)] = said.values[..] else { panic!("{said:?}") };
    assert!((a - b).abs() < 4.0 * s.hypot(t) && a > 5.0 * s, "{said:?}");
}

#[test]
fn a_delay_and_a_lag_are_told_apart_by_the_experiment_that_is_proposed() {
    let here = folder("delay");
    outcome("delay", Hiding::This("input_delay", 2.5), NOTHING[2], &here);
    let found = again("delay", &here, &["input_delay", "actuator_lag", "coulomb"]);
    assert_eq!(found.verdict, Verdict::Ambiguous, "{}", found.because);
    let next = found.next_experiment.expect("an experiment");
    let chance = next.rsplit(' ').nth(1).and_then(|percent| percent.parse::<f64>().ok());
    assert!(chance.is_some_and(|percent| percent > 50.0), "{next}");
}

#[test]
fn no_experiment_tells_a_motors_offset_from_a_torque() {
    let here = folder("bias");
    outcome("bias", Hiding::This("actuator_bias", 3.0), NOTHING[1], &here);
    let found = again("bias", &here, &["actuator_bias", "constant_torque", "coulomb"]);
    assert_eq!(found.verdict, Verdict::Ambiguous, "{}", found.because);
    let next = found.next_experiment.expect("words");
    assert!(next.contains("none of") && next.contains("another sensor"), "{next}");
}
