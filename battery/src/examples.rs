//! Records to try the diagnosis on, in which something is hidden or nothing is.

use crate::conditions::{NOTHING, experiment};
use crate::rigs::Rig;
use crate::truth::experiment::{Excitation, Samples};
use crate::truth::plant::Plant;
use std::fmt::Write;

/// Samples of each record.
const SAMPLES: usize = 800;

/// Changes a plant.
type Change = fn(&mut Plant);

/// Letter, rig and secret of each example.
const EXAMPLES: [(&str, Rig, Change); 4] = [
    ("a", Rig::Pendulum, |p| p.joints[0].coulomb = 0.012),
    ("b", Rig::CartPole, |p| p.paths[0].delay = 0.025),
    ("c", Rig::Furuta, |_| {}),
    ("d", Rig::DoublePendulum, |p| p.periodic.push((0, 0, 11.0, 0.15, 0.0))),
];

/// The files: name and text.
#[must_use]
pub fn files() -> Vec<(String, String)> {
    let mut all = Vec::new();
    for (k, (letter, rig, change)) in EXAMPLES.into_iter().enumerate() {
        let seed = 100 + k as u64;
        let bench = rig.bench(seed);
        let mut plant = bench.plant.clone();
        change(&mut plant);
        let stem = format!("{letter}_{}", rig.name());
        all.push((format!("{stem}.rig"), rig.text().to_owned()));
        for (i, kind) in [Excitation::Steps, Excitation::Sines, Excitation::Chirp].into_iter().enumerate() {
            let samples = experiment(&bench, &plant, &NOTHING[1], kind, SAMPLES, seed * 10 + i as u64);
            all.push((format!("{stem}_{}.csv", i + 1), csv(rig, &samples)));
        }
    }
    all
}

fn csv(rig: Rig, samples: &Samples) -> String {
    let (outputs, inputs) = rig.names();
    let mut text = "t".to_owned();
    outputs.iter().chain(inputs).for_each(|name| text.push_str(&format!(",{name}")));
    text.push('\n');
    for (k, t) in samples.t.iter().enumerate() {
        let _ = write!(text, "{t:.6}");
        for y in &samples.y {
            let _ = write!(text, ",{:.7}", y[k]);
        }
        for u in &samples.u {
            let _ = write!(text, ",{:.6}", u[k]);
        }
        text.push('\n');
    }
    text
}
