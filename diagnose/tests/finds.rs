//! The simulated example from end to end: the hidden torque is named, with its size, and nothing is named where nothing is hidden.

use diagnose::patch::Base;
use diagnose::{Diagnosis, Options, Verdict, diagnose};
use ident::fit::{ParameterSpec, select};
use ident::record::{Record, read};
use model_dsl::{CheckOptions, FileLoader};
use std::path::PathBuf;

fn examples() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../examples")
}

fn run(rig: &str, train: &[Record], test: &[Record]) -> Diagnosis {
    let file = examples().join(rig).display().to_string();
    let checked = model_dsl::check(&file, &FileLoader, &CheckOptions::default());
    let base = Base { rig: checked.rig.unwrap(), sources: checked.sources, unwatched: Vec::new() };
    let mut specs = ParameterSpec::of_rig(&base.rig);
    select(&mut specs, None, &["b1".to_owned(), "b4".to_owned()]).unwrap();
    let only =
        ["viscous", "quadratic_drag", "constant_torque", "gain_curvature", "sensor_scale", "input_coupling"].map(str::to_owned).to_vec();
    diagnose(&base, &specs, train, test, &Options { only, ..Options::default() }).unwrap_or_else(|e| panic!("{e}"))
}

fn record(name: &str) -> Record {
    read(&examples().join("records").join(name)).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn the_hidden_torque_is_named_with_its_size() {
    let found = run("rigs/googol_identified.rig", &[record("simulated_steps.csv")], &[record("simulated_doublets.csv")]);
    let [finding] = &found.findings[..] else { panic!("{:?}: {}", found.findings, found.because) };
    assert_eq!((finding.effect.as_str(), finding.place.as_str()), ("constant_torque", "theta"));
    let value = &finding.parameters[0];
    // hidden: 0.31 1/s^2
    assert!((value.value - 0.31).abs() < 0.01, "{value:?}");
    assert!(finding.heldout_gain.0 > finding.heldout_gain.1);
    assert!(found.gap_shrink.iter().any(|(signal, share)| signal == "theta" && *share > 0.8), "{:?}", found.gap_shrink);
    assert!(found.patched[0].1.contains("torque constant_theta on theta: tau_0_theta;"));
}

#[test]
fn nothing_is_named_where_nothing_is_hidden() {
    let found = run("hidden/googol_imbalance.rig", &[record("simulated_steps.csv")], &[record("simulated_doublets.csv")]);
    assert!(found.findings.is_empty(), "{:?}", found.findings);
    assert_eq!(found.verdict, Verdict::NoGap, "{}", found.because);
}

#[test]
fn a_quiet_record_is_refused() {
    let mut short = record("simulated_steps.csv");
    short.t.truncate(50);
    short.columns.iter_mut().for_each(|c| c.values.truncate(50));
    let found = run("rigs/googol_identified.rig", &[short], &[record("simulated_doublets.csv")]);
    assert_eq!(found.verdict, Verdict::BadData);
    assert!(found.because.contains("too few"), "{}", found.because);
}
