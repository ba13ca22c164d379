//! The seed paper's linear model and gain (eq. 17, 26), drift and trims, through the rig file and its derivation.

use control::{Feedforward, LqrDesign, Sampling, Unknown, Weight, lqr};
use cross_checks::bench_rig::Bench;
use cross_checks::random::Random;
use nalgebra::{DMatrix, dmatrix};
use runtime::Model;

const DEG: f64 = std::f64::consts::PI / 180.0;

fn design() -> LqrDesign {
    LqrDesign {
        states: ["eps", "eps.dot", "theta", "theta.dot"].map(str::to_owned).to_vec(),
        integrate: Vec::new(),
        weight_x: Weight::Diagonal(vec![180.0, 10.0, 400.0, 1.0]),
        weight_u: Weight::Diagonal(vec![1.0, 1.0]),
        sampling: Sampling::Continuous,
    }
}

/// Equal to all printed digits: within half a unit of the last one.
fn printed(found: &DMatrix<f64>, wanted: &DMatrix<f64>, unit: f64) {
    assert!((found - wanted).amax() <= 0.5 * unit, "found {found:.5} wanted {wanted:.5}");
}

#[test]
fn eq_17_comes_out_to_its_printed_digits_with_the_damping_of_the_open_loop_comparison() {
    let bench = Bench::new("googol_identified", &[("c_eps", 0.10)]);
    let trim = bench.trim("hover", &[]);
    let linear = bench.linear(&trim, &["f_s", "f_d"]);
    // rows psi'', eps'', theta''; columns psi, eps, theta, psi', eps', theta'
    let a = linear.a.rows(3, 3).into_owned();
    let wanted = dmatrix![
        0.0, -0.004, 1.63, -0.48, 0.0, 0.0;
        0.0, -0.26, -0.14, 0.0, -0.1, 0.0;
        0.0, 0.0, -25.55, 0.0, 0.0, -0.34
    ];
    printed(&a, &wanted, 0.01);
    printed(&dmatrix![a[(0, 1)]], &dmatrix![-0.004], 1e-3);
    printed(&linear.b.rows(3, 3).into_owned(), &dmatrix![0.05, 0.0; 0.53, 0.0; 0.0, 5.33], 0.01);
}

#[test]
fn eq_26_comes_out_to_all_printed_digits_with_the_damping_of_the_control_design() {
    let bench = Bench::new("googol_identified", &[]);
    let regulator = lqr(&bench.plant(&bench.trim("hover", &[]), &["f_s", "f_d"]), &design()).unwrap_or_else(|e| panic!("{e}"));
    printed(&regulator.k, &dmatrix![12.929, 7.125, -0.112, -0.007; -0.096, -0.068, 15.773, 2.567], 1e-3);
    assert!(regulator.residual < 1e-14 && regulator.neglected.is_empty());
    // the yaw states are not fed back: their own poles stay
    assert!(regulator.plant_poles.iter().any(|z| z.norm() == 0.0));
    assert!(regulator.plant_poles.iter().any(|z| (z.re + 0.4804).abs() < 1e-12));
    assert_eq!((&regulator.states[0][..], &regulator.inputs[..]), ("eps", &["f_s".to_owned(), "f_d".to_owned()][..]));
}

#[test]
fn gains_at_level_flight_and_with_the_rotors_as_inputs() {
    let bench = Bench::new("googol_identified", &[]);
    let level = bench.trim("level", &[]);
    let mixed = lqr(&bench.plant(&level, &["f_s", "f_d"]), &design()).unwrap_or_else(|e| panic!("{e}")).k;
    printed(&mixed, &dmatrix![12.9295, 7.1156, 0.0, 0.0; 0.0, 0.0, 15.7581, 2.5662], 1e-4);
    // the same weights on the rotors themselves are another problem
    let rotors = lqr(&bench.plant(&bench.trim("hover", &[]), &["f_1", "f_2"]), &design()).unwrap_or_else(|e| panic!("{e}")).k;
    let sum = dmatrix![1.0, 1.0; 1.0, -1.0] * rotors;
    printed(&dmatrix![sum[(0, 0)], sum[(0, 1)]; sum[(1, 2)], sum[(1, 3)]], &dmatrix![18.48, 8.93; 23.89, 3.25], 0.01);
}

#[test]
fn hover_drifts_in_yaw_and_the_turn_is_an_equilibrium() {
    let bench = Bench::new("googol_identified", &[]);
    let hover = bench.trim("hover", &[]);
    assert!((hover.drift[0] - 0.142).abs() < 5e-4 && hover.drift[1].abs().max(hover.drift[2].abs()) < 1e-14, "{:?}", hover.drift);
    assert_eq!((hover.rank, hover.unknowns), (2, 2));
    let turn = bench.trim("turn", &[]);
    assert!((turn.x[3] - 0.296).abs() < 5e-4, "{:?}", turn.x);
    assert!(turn.drift.iter().all(|a| a.abs() < 1e-14));
    assert!((turn.u[0] - 1.75).abs() < 5e-3 && (turn.u[1] - 1.33).abs() < 5e-3, "{:?}", turn.u);
    assert!((hover.x[2] - 5.0 * DEG).abs() < 1e-15);
}

#[test]
fn a_design_that_includes_the_angle_of_travel_without_weight_names_it() {
    let bench = Bench::new("googol_identified", &[]);
    let all = LqrDesign { states: Vec::new(), weight_x: Weight::Diagonal(vec![0.0, 180.0, 400.0, 0.0, 10.0, 1.0]), ..design() };
    let error = lqr(&bench.plant(&bench.trim("hover", &[]), &["f_s", "f_d"]), &all).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the weight does not see the mode at 0 (psi), which does not decay by itself: give one of its states a weight, or leave it out of the design"
    );
}

#[test]
fn feedforward_from_the_trim_manifold_is_the_closed_form() {
    let bench = Bench::new("googol_identified", &[]);
    let value = |name: &str| (0..bench.p.len()).find(|&i| bench.model.names().parameter(i) == name).map_or(f64::NAN, |i| bench.p[i]);
    let (a1, a2, a3, b1, b2) = (value("a1"), value("a2"), value("a3"), value("b1"), value("b2"));
    // states psi, eps, theta, ..: elevation and pitch are held
    let mut feedforward =
        Feedforward::new(&bench.model, &bench.p, bench.trim_problem("level", &[]), vec![1, 2]).unwrap_or_else(|e| panic!("{e}"));
    let mut random = Random::new(5);
    for _ in 0..200 {
        let (eps, theta) = (random.within(-0.6, 0.6), random.within(-1.0, 1.0));
        let trim = feedforward.at(&[eps, theta]).unwrap_or_else(|e| panic!("{eps} {theta}: {e}"));
        let f_s = (a1 * theta.cos() * eps.sin() + a2 * eps.cos()) / (b1 * theta.cos());
        let f_d = a3 * eps.cos() * theta.sin() / b2;
        assert!((trim.u[0] + trim.u[1] - f_s).abs() < 1e-12 * f_s.abs().max(1.0), "{trim:?}");
        assert!((trim.u[0] - trim.u[1] - f_d).abs() < 1e-12 * f_d.abs().max(1.0), "{trim:?}");
    }
}

#[test]
fn a_solved_trim_is_its_own_solution_and_free_directions_are_named() {
    let bench = Bench::new("googol_identified", &[]);
    let mut problem = bench.trim_problem("hover", &[]);
    let first = bench.trim("hover", &[]);
    (problem.x, problem.u) = (first.x.clone(), first.u.clone());
    let again = control::solve(&bench.model, &bench.p, &problem).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((again.iterations, &again.u), (0, &first.u));

    // the angle of travel changes nothing: solved for in place of a thrust, it is free, and the elevation cannot be held
    let mut wrong = bench.trim_problem("level", &[]);
    wrong.unknowns[1] = Unknown::state("psi", 0);
    let solved = control::solve(&bench.model, &bench.p, &wrong).unwrap_err();
    assert_eq!(
        solved.to_string(),
        "no operating point near the start: after 2 steps `eps` keeps an acceleration of -1.628e0 (rank 1 of 2); nothing there depends on psi: solve for another quantity, or start elsewhere"
    );
    wrong.unknowns.pop();
    let short = control::solve(&bench.model, &bench.p, &wrong).unwrap_err();
    assert_eq!(
        short.to_string(),
        "1 quantity to be solved for (f_1) but 2 accelerations to vanish (eps, theta): as many of one as of the other are needed"
    );
}

#[test]
fn every_named_trim_of_every_example_is_found_or_says_what_cannot_move() {
    for path in cross_checks::example_rigs() {
        let name = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let bench = Bench::new(&name, &[]);
        for trim in &bench.rig.trims {
            match control::solve(&bench.model, &bench.p, &bench.trim_problem(&trim.name, &[])) {
                Ok(found) => {
                    println!(
                        "{name:20} {:10} steps {} rank {}/{} residual {:.1e} drift {:.3?}",
                        trim.name, found.iterations, found.rank, found.unknowns, found.residual, found.drift
                    );
                    assert_eq!((found.rank, found.free.len()), (found.unknowns, 0), "{name} {}", trim.name);
                }
                // without friction no rate of travel balances the pull of a banked lift
                Err(error) => {
                    println!("{name:20} {:10} {error}", trim.name);
                    assert!(error.to_string().contains("nothing there depends on psi.dot"), "{name} {}: {error}", trim.name);
                    assert!(
                        matches!(&bench.model.equations().assumptions[..], [.., last] if last.contains("friction")),
                        "{name} {}",
                        trim.name
                    );
                }
            }
        }
    }
}
