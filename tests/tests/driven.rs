//! A small part of the study of records that a random torque drives (`cargo run --release -p cross-checks --example driven`).

use cross_checks::driven::{EXPERIMENTS, FORCE, TIME, study};

#[test]
fn innovations_hold_the_truth_where_a_random_torque_drives_the_rig() {
    // a rig that falls over in a free run takes output error long
    for (experiment, runs, both) in [(&EXPERIMENTS[0], 6, true), (&EXPERIMENTS[1], 4, false)] {
        let (outputs, filtered, forces) = study(experiment, runs, 7, both);
        println!("{}\n  output error: {}\n  innovations:  {}", experiment.name, outputs.line(), filtered.line());
        assert_eq!(filtered.fitted, runs);
        // consistent with 95 %: the binomial interval of what was seen reaches up to there
        assert!(filtered.share_interval().1 >= 0.95, "{}", filtered.line());
        // J and K; of c, six records say too little to tell the methods apart
        for k in [0, 2] {
            let (own, other) = (filtered.error(k).1, outputs.error(k).1);
            assert!(own < if both { other } else { 0.15 }, "parameter {k}: {own} and {other}");
        }
        for (found, truth) in forces.iter().flat_map(|f| [(&f.sd, FORCE), (&f.time, TIME)]) {
            let (lo, hi) = found.ci95.expect("the record tells the random torque");
            // a wider interval than 95 %: of many intervals some miss
            let half = (hi / lo).sqrt();
            assert!(found.value / truth < half * half && truth / found.value < half * half, "{forces:?}");
        }
    }
}
