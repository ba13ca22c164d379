//! Identification on other laboratories' records, judged on runs that were held out (docs/identification.md has the table).

use codegen::{Options, derive};
use cross_checks::{record_folder, rig_of, rigs_in, root};
use ident::fit::{EquationErrorFit, FitOptions, ParameterSpec, Preparation, RecordFigures, equation_error, figures, identify, select};
use ident::record::{Record, read_with};
use jit::InProcess;
use sim::Hold;

struct Bench {
    model: InProcess,
    specs: Vec<ParameterSpec>,
    records: Vec<Record>,
}

/// Rig (from `examples/rigs`), parameters to free (all that the rig frees where empty), records.
fn bench(rig: &str, free: &str, records: &[&str]) -> Option<Bench> {
    let Some(folder) = record_folder() else {
        println!("record test: skipped {rig} (RIG_DATA is not set)");
        return None;
    };
    println!("record test: ran {rig}");
    let rig = rig_of(&root().join(format!("examples/{rig}.rig")));
    let mut specs = ParameterSpec::of_rig(&rig);
    if !free.is_empty() {
        let free: Vec<String> = free.split(',').map(str::to_owned).collect();
        select(&mut specs, Some(&free), &[]).unwrap();
    }
    let records = records
        .iter()
        .map(|r| read_with(&root().join(format!("examples/records/{r}.toml")), Some(&folder)).unwrap_or_else(|e| panic!("{e}")))
        .collect();
    Some(Bench { model: InProcess::new(derive(&rig, Options::default()).unwrap()), specs, records })
}

impl Bench {
    /// Sets a starting or fixed value.
    fn set(&mut self, name: &str, value: f64) {
        self.specs.iter_mut().find(|s| s.name == name).unwrap().value = value;
    }

    /// Output error on the first `train` records; figures of the others.
    fn output_error(&self, train: usize, options: &FitOptions) -> Vec<RecordFigures> {
        let (train, test) = self.records.split_at(train);
        let fit = identify(&self.model, &self.specs, train, test, options).unwrap();
        assert!(fit.ending.converged(), "{}", fit.ending);
        fit.test
    }

    /// Equation error in weak form on the first `train` records; figures of the others over `horizon`, before and after.
    fn weak_form(&self, train: usize, window: usize, horizon: f64) -> [Vec<RecordFigures>; 2] {
        let (train, test) = self.records.split_at(train);
        let fit = equation_error(&self.model, &self.specs, train, Preparation::WeakForm { window }, Hold::Zero).unwrap();
        let before: Vec<f64> = self.specs.iter().map(|s| s.value).collect();
        [before, fit.p_of_record[0].clone()].map(|p| figures(&self.model, &p, test, Hold::Zero, Some(horizon)).unwrap())
    }
}

fn fit(figures: &RecordFigures, signal: &str) -> f64 {
    let found = figures.signals.iter().find(|s| s.signal == signal).and_then(|s| s.fit_percent).unwrap();
    println!("  {} {signal}: {found:.1} %", figures.record);
    found
}

#[test]
fn every_rig_of_a_record_is_sound() {
    let rigs = rigs_in("examples/measured");
    assert!(rigs.len() >= 10);
    for path in rigs {
        derive(&rig_of(&path), Options::default()).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
    }
}

#[test]
fn kawata_cart_driven_pendulum() {
    let records = ["pendulum_kawata_cdip_least_square_data", "pendulum_kawata_cdip_pend_data_200Hz"];
    let Some(bench) = bench("measured/kawata_cdip", "", &records) else { return };
    // 115 s of free swing, at the end of which a period that is wrong by 1 in 1000 shows
    assert!(fit(&bench.output_error(1, &FitOptions::default())[0], "phi") > 65.0);
}

#[test]
fn kawata_arm_driven_pendulum() {
    let records = ["pendulum_kawata_adip_pend_data_200Hz", "pendulum_kawata_adip_least_square_data"];
    let Some(bench) = bench("measured/kawata_adip", "J2,mu2", &records) else { return };
    let held_out = bench.output_error(1, &FitOptions { horizon: Some(0.5), ..FitOptions::default() });
    assert!(fit(&held_out[0], "phi2") > 70.0);
}

#[test]
fn qube_upright_in_windows_of_its_own() {
    let records = ["qube_furuta_decar_qube_20230828T161155_317_133_447", "qube_furuta_decar_qube_20230828T161658_307_080_776"];
    let Some(mut bench) = bench("measured/qube_decar", "", &records) else { return };
    // a part of the record, for speed
    let record = &mut bench.records[0];
    let keep = record.t.partition_point(|&t| t < 8.0);
    record.t.truncate(keep);
    record.columns.iter_mut().for_each(|c| c.values.truncate(keep));
    let options = FitOptions { shooting: Some(0.25), joined: false, ..FitOptions::default() };
    let held_out = bench.output_error(1, &options);
    assert!(held_out[0].horizon.is_some(), "an unstable rig is judged by predictions");
    assert!(fit(&held_out[0], "theta") > 90.0 && fit(&held_out[0], "alpha") > 50.0);
}

#[test]
fn aero_needs_the_rotors_angular_momentum() {
    let records = ["aero_ntnu2025_verification", "aero_ntnu2025_pitchcoef", "aero_ntnu2025_yawcoef"];
    let free = "d_x,K_main,K_tail,D_main,D_tail,c_pitch,c_yaw";
    let Some(published) = bench("measured/aero_ntnu", free, &records) else { return };
    let fitted = |bench: &Bench| identify(&bench.model, &bench.specs, &bench.records[..1], &[], &FitOptions::default()).unwrap();
    let without = fitted(&published);
    let Some(rotors) = bench("measured/aero_ntnu_rotors", &format!("{free},J_w,F_yaw,F_pitch"), &records) else { return };
    let with = fitted(&rotors);
    let [without, with] = [&without, &with].map(|f| (fit(&f.train[0], "yaw"), fit(&f.train[0], "pitch")));
    assert!(with.0 > 98.0 && with.1 > 82.0 && without.1 < 65.0, "{without:?} {with:?}");
}

#[test]
fn ntnu_helicopter_needs_lag_and_square_of_the_voltage() {
    let records = ["heli3_ntnu2020_pitchtest_m30_ang36", "heli3_ntnu2020_pitchtest_m35_ang45"];
    let mut pitch = Vec::new();
    for (rig, free) in [
        ("measured/ntnu_helicopter", "m_c,d,d_p,K_f,c_travel,c_elevation,c_pitch"),
        ("measured/ntnu_helicopter_rotors", "m_c,d,d_p,K_q,T_m,c_travel,c_elevation,c_pitch,t_travel,t_pitch"),
    ] {
        let Some(bench) = bench(rig, free, &records) else { return };
        let [_, after] = bench.weak_form(1, 250, 0.5);
        pitch.push((fit(&after[0], "pitch"), fit(&after[0], "elevation")));
    }
    assert!(pitch[0].0 < 60.0, "the course model: {pitch:?}");
    assert!(pitch[1].0 > 75.0 && pitch[1].1 > 78.0, "{pitch:?}");
}

#[test]
fn imperial_helicopter_contradicts_its_published_balance() {
    let Some(bench) = bench("measured/imperial_helicopter_rotors", "", &["heli3_imperial_run1", "heli3_imperial_run2"]) else { return };
    let [before, after] = bench.weak_form(1, 100, 0.5);
    assert!(fit(&before[0], "elevation") < 0.0);
    assert!(fit(&after[0], "elevation") > 83.0 && fit(&after[0], "travel") > 92.0);
}

#[test]
fn double_pendulum_on_its_other_trajectory() {
    let records = ["double_pendulum_dfki_designA_trajectory_03", "double_pendulum_dfki_designA_trajectory_11"];
    let Some(bench) = bench("rigs/double_pendulum", "m_2,r_2,I_1,I_2,I_r,c_f1,c_f2,b_1,b_2", &records) else { return };
    let options = FitOptions { shooting: Some(1.0), joined: false, horizon: Some(0.5), ..FitOptions::default() };
    let held_out = bench.output_error(1, &options);
    assert!(fit(&held_out[0], "q1") > 80.0 && fit(&held_out[0], "q2") > 55.0);
}

/// Published inverse-dynamics estimates: M, F_v, F_c, F_0.
const EMPS: [(&str, f64); 4] = [("M", 95.1089), ("F_v", 203.5034), ("F_c", 20.3935), ("F_0", -3.1648)];

#[test]
fn emps_by_equation_error_as_published() {
    let Some(mut bench) = bench("rigs/emps", "", &["emps_DATA_EMPS"]) else { return };
    // the published regressor has the sharp law
    bench.set("v_c", 1e-5);
    let preparation = Preparation::Filtered { cutoff: 100.0, order: 4, decimate: 10 };
    // the benchmark takes the command at the sample, as a line between samples does
    let EquationErrorFit { parameters, .. } = equation_error(&bench.model, &bench.specs, &bench.records, preparation, Hold::First).unwrap();
    for ((name, published), slack) in EMPS.into_iter().zip([0.01, 0.01, 0.01, 0.05]) {
        let found = parameters.iter().find(|e| e.name == name).unwrap().value;
        println!("  {name}: {found:.4}, published {published}");
        assert!((found / published - 1.0).abs() < slack, "{name}: {found} instead of {published}");
    }
}

#[test]
fn emps_by_the_force_of_its_closed_loop() {
    let Some(bench) = bench("measured/emps_closed_loop", "", &["emps_DATA_EMPS"]) else { return };
    let options = FitOptions { hold: Hold::First, ..FitOptions::default() };
    let fit = identify(&bench.model, &bench.specs, &bench.records, &[], &options).unwrap();
    for (name, published) in EMPS {
        let found = fit.parameters.iter().find(|e| e.name == name).unwrap().value;
        println!("  {name}: {found:.4}, published {published}");
        assert!((found / published - 1.0).abs() < 0.03, "{name}: {found} instead of {published}");
    }
}
