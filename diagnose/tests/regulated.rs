//! A rig that falls without its regulator: the next experiment is one with a regulator at work.

use diagnose::{Chance, Options, Verdict, diagnose};
use ident::fit::ParameterSpec;
use ident::record::{Column, Record, Start};

/// A pendulum on its head, pushed by a motor.
const INVERTED: &str = "rig Inverted {
    param J: kg*m^2 = 0.02; param mgl: N*m = 0.5; param c: N*m*s/rad = 0.01; const K: N*m/V = 0.2;
    coord q: rad; input V: V in -12..12;
    equation J * q.ddot = K * V + mgl * sin(q) - c * q.dot;
    encoder q: 20000;
}";

/// A record in closed loop: the motor acts `late` seconds after its command.
fn record(name: &str, seed: u64, late: f64) -> Record {
    let mut chance = Chance::new(seed);
    let (h, every) = (5e-4, 20);
    let (mut q, mut v, mut torque, mut reference, mut command) = (0.02_f64, 0.0_f64, 0.0_f64, 0.0_f64, 0.0);
    let mut commands: Vec<f64> = Vec::new();
    let count = std::f64::consts::TAU / 20_000.0;
    let mut before = q;
    let (mut t, mut y, mut u) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..(every * 1200) {
        if k % (every * 90) == 0 {
            reference = 0.12 * (2.0 * chance.uniform() - 1.0);
        }
        if k % every == 0 {
            let read = (q / count).round() * count;
            command = -8.0 * (read - reference) - 0.6 * (read - before) / (h * f64::from(every));
            command = (command - 2.5 * reference).clamp(-12.0, 12.0);
            before = read;
            t.push(f64::from(k) * h);
            y.push(read);
            u.push(command);
        }
        commands.push(command);
        let then = (k as usize).saturating_sub((late / h).round() as usize);
        torque += -torque * h / 0.2 + 0.002 * (2.0 * h / 0.2).sqrt() * chance.normal();
        v += h * (0.2 * commands[then] + torque + 0.5 * q.sin() - 0.01 * v) / 0.02;
        q += h * v;
    }
    let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
    Record { source: name.to_owned(), t, columns: vec![column("V", u), column("q", y)], declared: Vec::new(), start: Start::Free }
}

#[test]
fn the_next_experiment_of_a_rig_that_falls_has_a_regulator_at_work() {
    let base = diagnose::patch::check(&[("inverted.rig".to_owned(), INVERTED.to_owned())], "Inverted").unwrap();
    let specs = ParameterSpec::of_rig(&base.rig);
    let only = ["input_delay", "actuator_lag"].map(str::to_owned).to_vec();
    let [first, second, third] = [1, 2, 3].map(|seed| record(&format!("record {seed}"), seed, 3.5e-3));
    let options = Options { next: true, only, ..Options::default() };
    let found = diagnose(&base, &specs, &[first, second], &[third], &options).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(found.verdict, Verdict::Ambiguous, "{} {:?}", found.because, found.findings);
    let next = found.next_experiment.expect("an experiment");
    assert!(next.starts_with("with a regulator at work, add to V "), "{next}");
    // a lag has another band than a delay: a fast sweep tells one from the other
    let chance = next.rsplit(' ').nth(1).and_then(|percent| percent.parse::<f64>().ok());
    assert!(next.contains("sweeping") && chance.is_some_and(|percent| percent > 50.0), "{next}");
}
