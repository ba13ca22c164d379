//! Every effect at every place of the example rigs: the patched text is a rig, and where the effect's parameters are zero it is the rig
//! that it was.

use diagnose::effects::{Edit, Effect, Scales, Signature, catalogue};
use diagnose::patch::{Base, Written, check, compose};
use jit::InProcess;
use model_dsl::{CheckOptions, FileLoader};
use runtime::Model;

const RIGS: [&str; 9] = ["googol", "googol_mrb", "googol_identified", "furuta", "cart_pole", "emps", "aero", "quanser", "double_pendulum"];

fn base(name: &str) -> Base {
    let file = format!("{}/../examples/rigs/{name}.rig", env!("CARGO_MANIFEST_DIR"));
    let checked = model_dsl::check(&file, &FileLoader, &CheckOptions::default());
    Base::new(checked.rig.unwrap_or_else(|| panic!("{name}: {:?}", checked.diagnostics)), checked.sources)
}

fn scales(base: &Base) -> Scales {
    let n = base.rig.coordinates.len();
    Scales { range: vec![(-2.0, 2.5); n], rate: vec![0.7; n], input: vec![(3.0, 2.0); base.rig.inputs.len()], duration: 20.0, period: 0.01 }
}

fn model(base: &Base) -> InProcess {
    InProcess::new(codegen::derive(&base.rig, codegen::Options::default()).unwrap_or_else(|e| panic!("{}: {e}", base.rig.name)))
}

fn patched(base: &Base, effect: &Effect, values: &[f64]) -> Base {
    let values = values.iter().map(|v| (*v, 0.0)).collect();
    let written = Written { effect, values, evidence: None, per_record: false, screened: false };
    let files = compose(base, &[written], &[]).unwrap_or_else(|e| panic!("{} {}: {e}", base.rig.name, effect.title()));
    check(&files, &base.rig.name).unwrap_or_else(|e| panic!("{} {}: {e}", base.rig.name, effect.title()))
}

/// x' of the states of `like` and y at some states, parameters by name from `like`.
fn behaviour(model: &InProcess, like: &InProcess) -> Vec<f64> {
    let d = model.dimensions();
    let mut p = vec![0.0; d.parameters];
    model.nominal(&mut p);
    let mut out = Vec::new();
    let place = |name: &str| (0..like.dimensions().states()).find(|&i| like.names().state(i) == name);
    for k in 0..5 {
        let u: Vec<f64> = (0..d.signals()).map(|i| 1.0 + 0.3 * (i as f64 + k as f64).cos()).collect();
        let of = |i: usize| -> f64 {
            let name = model.names().state(i);
            if let Some(i) = place(name) {
                return (1.3 * i as f64 + 0.7 * k as f64).sin() * 0.4;
            }
            // a new lag has settled, a compliance may swing as it likes
            let input = (0..d.signals()).find(|&j| model.names().signal(j) == name.trim_end_matches(".lag"));
            input.map_or(0.3, |j| u[j])
        };
        let x: Vec<f64> = (0..d.states()).map(of).collect();
        let (mut dx, mut y) = (vec![0.0; d.states()], vec![0.0; d.outputs]);
        model.rhs(0.3, &x, &u, &p, &mut dx).unwrap();
        model.outputs(0.3, &x, &p, &mut y);
        out.extend((0..d.states()).filter(|&i| place(model.names().state(i)).is_some()).map(|i| dx[i]));
        out.extend(y);
    }
    assert_eq!(model.dimensions().outputs, like.dimensions().outputs);
    out
}

#[test]
fn absent_effects_leave_the_rig_as_it_was() {
    let mut count = 0;
    for name in RIGS {
        let base = base(name);
        let plain = model(&base);
        let expected = behaviour(&plain, &plain);
        for effect in catalogue(&base.rig, &scales(&base)) {
            // an assumption has no null value; a lag of zero is the wire that it replaces: tried with a settled state
            if effect.signature == Signature::Towards {
                patched(&base, &effect, &[]);
                continue;
            }
            let lag = matches!(&effect.edit, Edit::Path { entry: "lag", .. });
            let value = if lag { 1e-3 } else { 0.0 };
            let with = model(&patched(&base, &effect, &effect.with(&vec![value; effect.parameters.len()])));
            let found = behaviour(&with, &plain);
            for (a, b) in found.iter().zip(&expected) {
                assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{name}, {}: {a} instead of {b}", effect.title());
            }
            count += 1;
        }
    }
    assert!(count > 300, "{count}");
}

#[test]
fn the_text_keeps_its_comments_and_gains_two_lines() {
    let base = base("googol_identified");
    let all = catalogue(&base.rig, &scales(&base));
    let effect = all.iter().find(|e| e.id == "constant_torque" && e.place == "theta").unwrap();
    let written = Written { effect, values: vec![(0.3123, 0.021)], evidence: Some("found".to_owned()), per_record: false, screened: false };
    let files = compose(&base, &[written], &[]).unwrap();
    let (before, after) = (&base.sources.files[0].1, &files[0].1);
    let added: Vec<&str> = after.lines().filter(|line| !before.contains(line.trim_end())).collect();
    assert_eq!(
        added,
        [
            "    // found",
            "    param tau_0_theta: 1/s^2 = 0.312 +- 0.021;  // constant torque",
            "    torque constant_theta on theta: tau_0_theta;"
        ]
    );
    assert!(before.lines().all(|line| after.contains(line)), "every line of the rig is still there");
}

#[test]
fn replaced_statements_say_what_they_said_before() {
    let base = base("quanser");
    let all = catalogue(&base.rig, &scales(&base));
    let text = |id: &str, place: &str| {
        let effect = all.iter().find(|e| e.id == id && e.place == place).unwrap_or_else(|| panic!("{id} on {place}"));
        let values = effect.parameters.iter().map(|_| (0.01, 0.0)).collect();
        let written = Written { effect, values, evidence: None, per_record: false, screened: false };
        compose(&base, &[written], &[]).unwrap()[0].1.clone()
    };
    let input = &base.rig.inputs[0].name;
    assert!(text("actuator_gain", input).contains(&format!("map (1 + g_{input}) * {input};")));
    let output = &base.rig.outputs[0].name;
    let with = text("sensor_bias", output);
    assert!(with.contains(&format!("bias y_0_{output};")) && with.contains("encoder "), "{with}");
}
