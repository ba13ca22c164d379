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
    // arm upright: yaw and pitch turn about one axis; pitch, nearer to the tip, is eliminated first and leaves yaw nothing
    assert_eq!(coordinate, "psi");
    assert!((1.4..1.5).contains(t), "{t}");
    assert_eq!(c.valid_until, *t);
    // the last sample before it is at most 5 ms earlier
    let before = last[1] + last[4] * (t - c.trajectory.t[c.trajectory.t.len() - 1]);
    assert!((before.abs() - std::f64::consts::FRAC_PI_2).abs() < 1e-3, "{before}");
    assert!(c.signals.iter().all(|s| s.simulated.len() == c.trajectory.t.len() && s.fit_percent.is_some()));
}

/// Name, samples, period [s], and (column, lowest, highest) in SI.
type Expected = (&'static str, usize, f64, &'static [(&'static str, f64, f64)]);

/// Every description, its samples, period and length, and the extremes of what it measures (from the folders' READMEs).
const RECORDS: &[Expected] = &[
    ("googol_open_loop_steps", 10_001, 0.005, &[("theta", -0.24, 0.17), ("eps", -0.45, 0.13), ("psi", -0.01, 8.1)]),
    ("googol_elevation_identification", 10_001, 0.005, &[("eps", -0.54, 0.16), ("theta", -0.03, 0.02), ("psi", -0.01, 0.0)]),
    (
        "heli3_ntnu2020_pitchtest_m30_ang0",
        11_820,
        0.002,
        &[("V_front", -5.0, 5.0), ("V_back", -5.0, 5.0), ("elevation", -0.53, 0.15), ("pitch", -0.27, 0.25)],
    ),
    ("heli3_ntnu2020_pitchtest_m30_ang36", 13_112, 0.002, &[("V_front", -5.0, 5.0), ("travel", 0.0, 20.4)]),
    ("heli3_ntnu2020_pitchtest_m35_ang45", 14_112, 0.002, &[("V_back", -5.0, 5.0), ("travel", 0.0, 24.1)]),
    ("heli3_ntnu2020_lqr_best", 16_693, 0.002, &[("V_front", 0.0, 5.0), ("elevation", -0.53, -0.09), ("travel", 0.0, 18.4)]),
    ("heli3_ntnu2020_lqr_integral_best", 17_128, 0.002, &[("V_front", -1.0, 5.0), ("elevation", -0.53, 0.06), ("travel", 0.0, 27.8)]),
    ("heli3_imperial_1_Elev_3", 6347, 0.005, &[("elevation", -0.6, -0.44)]),
    ("heli3_imperial_1_Elev_5", 18889, 0.005, &[("elevation", -0.52, -0.1)]),
    ("heli3_imperial_1_Elev_7", 18127, 0.005, &[("elevation", -0.52, 0.3)]),
    ("heli3_imperial_1_Elev_9", 18161, 0.005, &[("elevation", -0.52, 0.6)]),
    ("heli3_imperial_2_Elev_3", 8439, 0.005, &[("elevation", -0.6, -0.44)]),
    ("heli3_imperial_2_Elev_5", 18480, 0.005, &[("elevation", -0.52, -0.1)]),
    ("heli3_imperial_2_Elev_7", 18453, 0.005, &[("elevation", -0.52, 0.3)]),
    ("heli3_imperial_2_Elev_9", 18203, 0.005, &[("elevation", -0.52, 0.6)]),
    ("heli3_imperial_1_Pitch_04", 1_292, 0.005, &[("pitch", -0.1, 1.9)]),
    ("heli3_imperial_1_Pitch_06", 769, 0.005, &[("pitch", -0.1, 1.9)]),
    ("heli3_imperial_1_Pitch_08", 618, 0.005, &[("pitch", -0.1, 1.9)]),
    ("heli3_imperial_1_Pitch_40", 810, 0.005, &[("pitch", -1.9, 0.1)]),
    ("heli3_imperial_1_Pitch_60", 650, 0.005, &[("pitch", -1.9, 0.1)]),
    ("heli3_imperial_1_Pitch_80", 636, 0.005, &[("pitch", -1.9, 0.1)]),
    ("heli3_imperial_2_Pitch_04", 1_169, 0.005, &[("pitch", -0.1, 1.9)]),
    ("heli3_imperial_2_Pitch_06", 768, 0.005, &[("pitch", -0.1, 1.9)]),
    ("heli3_imperial_2_Pitch_08", 698, 0.005, &[("pitch", -0.1, 1.9)]),
    ("heli3_imperial_2_Pitch_40", 747, 0.005, &[("pitch", -1.9, 0.1)]),
    ("heli3_imperial_2_Pitch_60", 713, 0.005, &[("pitch", -1.9, 0.1)]),
    ("heli3_imperial_2_Pitch_80", 620, 0.005, &[("pitch", -1.9, 0.1)]),
    (
        "heli3_imperial_run1",
        6_424,
        0.005,
        &[("elevation", -0.48, 0.18), ("V_front", -24.0, 24.0), ("travel", -0.19, 0.34), ("pitch", -0.35, 0.42)],
    ),
    ("heli3_imperial_run2", 7_141, 0.005, &[("elevation", -0.48, 0.18), ("V_back", -24.0, 24.0), ("travel", -0.2, 0.34)]),
    ("emps_DATA_EMPS", 24_841, 0.001, &[("q", -1e-3, 0.25), ("V", -4.4, 4.2)]),
    ("pendulum_kawata_cdip_least_square_data", 8_967, 0.001, &[("z", -0.002, 0.24), ("phi", -0.76, 0.76), ("V", -0.4, 2.0)]),
    ("pendulum_kawata_cdip_pend_data_200Hz", 23_100, 0.005, &[("phi", -1.0, 1.02)]),
    ("pendulum_kawata_adip_least_square_data", 8_953, 0.001, &[("phi1", -0.01, 1.21), ("phi2", -0.82, 0.81), ("V", -0.62, 3.0)]),
    ("pendulum_kawata_adip_pend_data_200Hz", 23_600, 0.005, &[("phi2", -1.22, 1.24)]),
    (
        "aero_ntnu2025_verification",
        17_501,
        0.002,
        &[("pitch", -0.28, 0.45), ("yaw", -1.83, 6.98), ("V_main", 0.0, 10.0), ("omega_tail", 0.0, 187.0)],
    ),
    ("aero_ntnu2025_pitchcoef", 15_001, 0.002, &[("pitch", -0.71, 0.62), ("V_main", -20.0, 0.0)]),
    ("aero_ntnu2025_yawcoef", 5_001, 0.002, &[("yaw", 0.0, 2.3), ("V_tail", 0.0, 20.0)]),
    ("aero_ntnu2025_coupling_free_pitch", 10_001, 0.002, &[("pitch", -0.94, 0.78), ("yaw_rate", -0.13, 4.4)]),
    ("aero_ntnu2025_coupling_locked_pitch", 10_001, 0.002, &[("yaw_rate", -0.2, 4.8)]),
    (
        "qube_furuta_decar_qube_20230828T161155_317_133_447",
        9_500,
        0.002,
        &[("theta", -0.54, 0.43), ("alpha", -0.27, 0.24), ("V", -10.0, 8.0)],
    ),
    ("qube_furuta_decar_qube_20230828T161658_307_080_776", 9_500, 0.002, &[("alpha", -0.4, 0.4), ("V", -10.0, 10.0)]),
    ("double_pendulum_dfki_designA_trajectory_03", 4_997, 0.002, &[("q1", -0.45, 0.33), ("q2", -1.82, 1.58), ("tau_1", -0.65, 0.72)]),
    ("double_pendulum_dfki_designA_trajectory_11", 3_857, 0.0015, &[("q1", -1.17, 3.2), ("q2", -2.25, 2.51), ("tau_2", -2.5, 4.7)]),
    ("heli3_sheffield_fan_FanDynData", 668, 0.015, &[("V", 0.0, 10.0), ("force", -0.005, 0.04)]),
];

#[test]
fn every_description_reads_its_record() {
    let folder = root().join("examples/records");
    let mut found: Vec<String> = std::fs::read_dir(&folder)
        .unwrap()
        .flatten()
        .filter_map(|e| Some(e.file_name().to_str()?.strip_suffix(".toml")?.to_owned()))
        .collect();
    found.sort();
    let mut listed: Vec<&str> = RECORDS.iter().map(|r| r.0).collect();
    listed.sort_unstable();
    assert_eq!(found, listed, "every description has its line above, and the other way round");
    let mut wrong = Vec::new();
    for (name, samples, period, ranges) in RECORDS {
        let Some(data) = folder_for(name) else { continue };
        let record = ident::record::read_with(&folder.join(format!("{name}.toml")), Some(&data)).unwrap_or_else(|e| panic!("{e}"));
        let extremes = |values: &[f64]| values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &v| (lo.min(v), hi.max(v)));
        let shown: Vec<String> = record
            .columns
            .iter()
            .map(|c| {
                let (lo, hi) = extremes(&c.values);
                format!("{} {lo:.3}..{hi:.3}", c.name)
            })
            .collect();
        println!("  {name}: {} samples, {:.1} ms, {:.1} s; {}", record.t.len(), 1e3 * record.period(), record.duration(), shown.join(", "));
        if record.t.len() != *samples || (record.period() - period).abs() > 0.25 * period {
            wrong.push(format!("{name}: {} samples every {} s, not {samples} every {period} s", record.t.len(), record.period()));
        }
        for (column, lo, hi) in *ranges {
            let (min, max) = extremes(&record.column(column).unwrap_or_else(|| panic!("{name}: no {column}")).values);
            // within the range, and using at least a third of it: no wrong unit, sign or column
            if !(min >= *lo && max <= *hi && max - min > (hi - lo) / 3.0) {
                wrong.push(format!("{name}: {column} is in {min}..{max}, not in {lo}..{hi}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn models_of_the_seed_over_the_record() {
    let Some(folder) = folder_for("googol_open_loop_steps, every model") else { return };
    for (rig, set) in [("googol_identified", &[][..]), ("googol", &[][..]), ("googol_mrb", &[][..]), ("googol_eq13", &[][..])] {
        let c = steps(&model(rig, Options::default()), set, &folder);
        println!(
            "  {rig}: fit % of psi, eps, theta = {:.1?}, {}, horizon {:?}",
            ["psi", "eps", "theta"].map(|s| figure(&c, s)),
            c.status,
            c.horizon()
        );
        assert_eq!((c.status, c.valid_until, c.prediction.is_none()), (Status::Completed, 50.0, true), "{rig}");
    }
}
