//! A small part of the coverage study (`cargo run --release -p cross-checks --example coverage`).

use cross_checks::coverage::{CASES, study};

#[test]
fn intervals_hold_the_truth_and_no_fit_diverges() {
    for (case, runs) in CASES.iter().zip([12, 6, 2, 8]) {
        let outcome = study(case, runs, 11);
        println!("{}: {:.1} % of {} intervals hold the truth", case.name, 100.0 * outcome.share(), runs * case.free.len());
        assert_eq!(outcome.diverged, 0, "{}", case.name);
        // consistent with 95 %: the binomial interval of what was seen reaches up to there
        assert!(outcome.share_interval().1 >= 0.95, "{}: {:?}", case.name, outcome);
        assert!(outcome.worst < 0.1, "{}: {:?}", case.name, outcome);
    }
}
