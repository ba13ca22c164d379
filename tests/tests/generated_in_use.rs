//! Identification and control see models through their trait only: a checked-in model and one derived in the process
//! give the same numbers, to 1e-9 relative (both compute the same operations; sines differ by an ulp).

use codegen::{Options, derive};
use control::{LqrDesign, Plant, Sampling, TrimProblem, Unknown, Weight};
use cross_checks::close::relative;
use cross_checks::{rig_of, root};
use generated::googol_identified::GoogolIdentified;
use ident::fit::{FitOptions, ParameterSpec, identify, select};
use jit::InProcess;
use nalgebra::DMatrix;
use runtime::Model;

fn in_process() -> InProcess {
    let rig = rig_of(&root().join("examples/rigs/googol_identified.rig"));
    InProcess::new(derive(&rig, Options::default()).unwrap_or_else(|e| panic!("{e}")))
}

/// Operating point, linear model and gain, one after the other.
fn design(model: &dyn Model) -> Vec<f64> {
    let d = model.dimensions();
    let mut p = vec![0.0; d.parameters];
    model.nominal(&mut p);
    let mut x = vec![0.0; d.states()];
    x[2] = 5.0_f64.to_radians();
    let unknowns = vec![Unknown::signal("f_1", 0), Unknown::signal("f_2", 1)];
    let trim = control::solve(model, &p, &TrimProblem { x, u: vec![0.0; d.signals()], unknowns, zero: vec![1, 2] }).expect("a trim");
    let directions = DMatrix::from_row_slice(2, 2, &[0.5, 0.5, 0.5, -0.5]);
    let linear = control::linearize(model, &p, &trim.x, &directions, |dx, a, b| model.linearize(0.0, &trim.x, &trim.u, &p, dx, a, b))
        .expect("a linear model");
    let design = LqrDesign {
        states: ["eps", "eps.dot", "theta", "theta.dot"].map(str::to_owned).to_vec(),
        integrate: Vec::new(),
        weight_x: Weight::Diagonal(vec![180.0, 10.0, 400.0, 1.0]),
        weight_u: Weight::Diagonal(vec![1.0, 1.0]),
        sampling: Sampling::Continuous,
    };
    let plant = Plant::new(model, &linear, &["f_s".to_owned(), "f_d".to_owned()]);
    let lqr = control::lqr(&plant, &design).expect("a gain");
    trim.u.iter().chain(&trim.drift).chain(&linear.a).chain(&linear.b).chain(&lqr.k).copied().collect()
}

#[test]
fn a_regulator_is_the_same_on_both() {
    let (generated, derived) = (design(&GoogolIdentified), design(&in_process()));
    assert!(generated.len() > 60);
    assert!(relative(&generated, &derived, 1.0) < 1e-9, "{generated:?}\n{derived:?}");
}

#[test]
fn a_fit_is_the_same_on_both() {
    let record = ident::record::read(&root().join("examples/records/simulated_steps.csv")).unwrap_or_else(|e| panic!("{e}"));
    let fit = |model: &dyn Model| {
        let mut specs = ParameterSpec::of_model(model);
        let free = ["a1", "a2", "a3", "b2", "b3", "c_psi", "c_eps", "c_theta"].map(str::to_owned);
        select(&mut specs, Some(&free), &[]).unwrap_or_else(|e| panic!("{e}"));
        let fit = identify(model, &specs, std::slice::from_ref(&record), &[], &FitOptions::default()).unwrap_or_else(|e| panic!("{e}"));
        let errors: Vec<f64> = fit.parameters.iter().map(|e| e.std_error.expect("all are told")).collect();
        (fit.cost, fit.parameters.iter().map(|e| e.value).collect::<Vec<f64>>(), errors)
    };
    let (generated, derived) = (fit(&GoogolIdentified), fit(&in_process()));
    println!("cost {:e} {:e}\n{:?}\n{:?}", generated.0, derived.0, generated.1, derived.1);
    assert!((generated.0 - derived.0).abs() < 1e-9 * derived.0);
    assert!(relative(&generated.1, &derived.1, 0.0) < 1e-9);
    assert!(relative(&generated.2, &derived.2, 0.0) < 1e-9);
}
