//! Measured records: every description is read, and the published fits of the seed's models come out.

use codegen::{Lumps, Options, derive};
use cross_checks::{record_folder, rig_of, root};
use ident::compare::{CompareOptions, Comparison, compare};
use jit::InProcess;
use runtime::Model;
use sim::Status;

/// The folder of records, or a line that says what was skipped.
fn folder_for(name: &str) -> Option<std::path::PathBuf> {
    let folder = record_folder();
    match folder {
        Some(_) => println!("record test: ran {name}"),
        None => println!("record test: skipped {name} (RIG_DATA is not set)"),
    }
    folder
}

fn model(rig: &str, options: Options) -> InProcess {
    let rig = rig_of(&root().join(format!("examples/rigs/{rig}.rig")));
    InProcess::new(derive(&rig, options).unwrap())
}

fn parameters(model: &InProcess, set: &[(&str, f64)]) -> Vec<f64> {
    let count = model.dimensions().parameters;
    let mut p = vec![0.0; count];
    model.nominal(&mut p);
    for (name, value) in set {
        let i = (0..count).find(|&i| model.names().parameter(i) == *name).unwrap_or_else(|| panic!("no parameter {name}"));
        p[i] = *value;
    }
    p
}

fn steps(model: &InProcess, set: &[(&str, f64)], folder: &std::path::Path) -> Comparison {
    let record = ident::record::read_with(&root().join("examples/records/googol_open_loop_steps.toml"), Some(folder)).unwrap();
    compare(model, &parameters(model, set), &record, &CompareOptions::default()).unwrap()
}

fn figure(c: &Comparison, signal: &str) -> f64 {
    c.signals.iter().find(|s| s.name == signal).and_then(|s| s.fit_percent).unwrap()
}

#[test]
fn identified_model_fits_its_own_record_as_the_paper_says() {
    let Some(folder) = folder_for("googol_open_loop_steps, identified") else { return };
    let c = steps(&model("googol_identified", Options::default()), &[("c_eps", 0.10)], &folder);
    let found = ["psi", "eps", "theta"].map(|s| figure(&c, s));
    println!("identified: fit % of psi, eps, theta = {found:.2?}, {} steps", c.trajectory.steps);
    for (found, wanted) in found.into_iter().zip([68.0, 21.5, 45.0]) {
        assert!((found - wanted).abs() <= 1.0, "{found} instead of {wanted}");
    }
}

#[test]
fn values_before_identification_fit_as_badly_as_the_paper_says() {
    let Some(folder) = folder_for("googol_open_loop_steps, not identified") else { return };
    let model = model("googol_identified", Options { lumps: Lumps::Expanded, ..Options::default() });
    let c = steps(&model, &[("c_psi", 0.274), ("c_eps", 0.053), ("c_theta", 0.048)], &folder);
    let found = ["psi", "eps", "theta"].map(|s| figure(&c, s));
    println!("not identified: fit % of psi, eps, theta = {found:.2?}");
    for (found, wanted) in found.into_iter().zip([63.0, -446.0, -7.0]) {
        assert!((found - wanted).abs() <= 1.0, "{found} instead of {wanted}");
    }
}

#[test]
fn single_rigid_body_model_dies_at_a_right_angle() {
    let Some(folder) = folder_for("googol_open_loop_steps, single rigid body") else { return };
    let c = steps(&model("googol_srb", Options::default()), &[], &folder);
    let last = c.trajectory.state(c.trajectory.t.len() - 1);
    println!("googol_srb: {}; eps = {:.4} rad at {:.3} s", c.status, last[1], c.trajectory.t[c.trajectory.t.len() - 1]);
    let Status::Singular { coordinate, t } = &c.status else { panic!("{}", c.status) };
    // arm upright: yaw and pitch turn about one axis
    assert_eq!(coordinate, "theta");
    assert!((1.4..1.5).contains(t), "{t}");
    assert_eq!(c.valid_until, *t);
    // the last sample before it is at most 5 ms earlier
    let before = last[1] + last[4] * (t - c.trajectory.t[c.trajectory.t.len() - 1]);
    assert!((before.abs() - std::f64::consts::FRAC_PI_2).abs() < 1e-3, "{before}");
    assert!(c.signals.iter().all(|s| s.simulated.len() == c.trajectory.t.len() && s.fit_percent.is_some()));
}
