//! The rows of the battery: lists of runs.

use crate::conditions::{BAD, Condition, DAY, HIDING, NOTHING};
use crate::hide::OUTSIDE;
use crate::rigs::Rig;
use crate::run::{Hiding, Task};
use diagnose::Method;

/// Names of all rows.
pub const ROWS: [&str; 9] = ["nothing", "one", "two", "three", "outside", "dose", "bad-data", "day", "ablation"];

/// Sizes of the dose row, in multiples of what shows.
pub const DOSES: [f64; 7] = [0.25, 0.5, 0.75, 1.0, 1.5, 3.0, 8.0];
/// Effects of the dose row.
const DOSED: [&str; 4] = ["coulomb", "constant_torque", "input_delay", "quadratic_drag"];

struct Part {
    name: String,
    conditions: Vec<Condition>,
    hiding: Hiding,
    method: Method,
    rigs: Vec<Rig>,
    stream: String,
}

/// The runs of a row: `runs` of each part, parts in turn.
#[must_use]
pub fn tasks(row: &'static str, runs: u64, rigs: &[Rig]) -> Vec<Task> {
    let mut parts: Vec<Part> = Vec::new();
    let mut add = |name: &str, conditions: &[Condition], hiding: Hiding, method: Method, among: &[Rig], stream: &str| {
        let rigs: Vec<Rig> = rigs.iter().copied().filter(|r| among.contains(r)).collect();
        parts.push(Part {
            name: name.to_owned(),
            conditions: conditions.to_vec(),
            hiding,
            method,
            rigs,
            stream: format!("{row} {stream}"),
        });
    };
    let full = Method::default();
    let turning = [Rig::Pendulum, Rig::CartPole, Rig::Furuta, Rig::DoublePendulum];
    match row {
        "nothing" => NOTHING.iter().for_each(|c| add(c.name, &[*c], Hiding::Nothing, full, &Rig::ALL, c.name)),
        "one" => add("one", &HIDING, Hiding::Some(1, 3.0), full, &Rig::ALL, "one"),
        "two" => add("two", &HIDING, Hiding::Some(2, 3.0), full, &Rig::ALL, "two"),
        "three" => add("three", &HIDING, Hiding::Some(3, 3.0), full, &Rig::ALL, "three"),
        "outside" => {
            OUTSIDE.iter().for_each(|what| add(what, &HIDING, Hiding::Outside(what, 5.0), full, &turning, what));
            add("decoy", &HIDING, Hiding::Decoy(4.0), full, &Rig::ALL, "decoy");
            add("eaten", &[Condition { reach: 0.1, ..NOTHING[1] }], Hiding::Eaten(0.05), full, &turning, "eaten");
        }
        "dose" => {
            for effect in DOSED {
                for dose in DOSES {
                    let name = format!("{effect} x {dose}");
                    add(&name, &HIDING[..2], Hiding::This(effect, dose), full, &[Rig::Pendulum, Rig::CartPole], &name);
                }
            }
        }
        "bad-data" => BAD.iter().for_each(|c| add(c.name, &[*c], Hiding::Nothing, full, &Rig::ALL, c.name)),
        "day" => add("of-the-day", &[DAY], Hiding::Nothing, full, &Rig::ALL, "day"),
        "ablation" => {
            let torque = [NOTHING[2]];
            // a criterion that counts samples is another test in another length; without the test on other records its errors show
            let brief = [Condition { samples: Some(250), ..NOTHING[2] }];
            let alone = Method { other_records: false, ..full };
            add("brief: no other records", &brief, Hiding::Nothing, alone, &Rig::ALL, "brief");
            add("brief: BIC, no other records", &brief, Hiding::Nothing, Method { family: false, ..alone }, &Rig::ALL, "brief");
            add("nothing: full method", &torque, Hiding::Nothing, full, &Rig::ALL, "nothing");
            add("nothing: no whitening", &torque, Hiding::Nothing, Method { whitening: false, ..full }, &Rig::ALL, "nothing");
            add("nothing: BIC", &torque, Hiding::Nothing, Method { family: false, ..full }, &Rig::ALL, "nothing");
            add(
                "nothing: BIC, no other records",
                &torque,
                Hiding::Nothing,
                Method { family: false, other_records: false, ..full },
                &Rig::ALL,
                "nothing",
            );
            add("day: full method", &[DAY], Hiding::Nothing, full, &Rig::ALL, "day");
            add("day: no other records", &[DAY], Hiding::Nothing, Method { other_records: false, ..full }, &Rig::ALL, "day");
            add("one: full method", &HIDING, Hiding::Some(1, 3.0), full, &Rig::ALL, "one");
            add("one: no absorption", &HIDING, Hiding::Some(1, 3.0), Method { absorption: false, ..full }, &Rig::ALL, "one");
        }
        _ => {}
    }
    let mut all = Vec::new();
    for number in 0..runs {
        for part in parts.iter().filter(|p| !p.rigs.is_empty()) {
            let count = part.rigs.len() as u64;
            all.push(Task {
                row,
                part: part.name.clone(),
                rig: part.rigs[(number % count) as usize],
                condition: part.conditions[(number / count) as usize % part.conditions.len()],
                hiding: part.hiding,
                method: part.method,
                number,
                stream: part.stream.clone(),
            });
        }
    }
    all
}
