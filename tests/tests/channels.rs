//! The seed paper's way of identification: rates by an observer or a filter, one equation after the other.

use codegen::{Options, derive};
use cross_checks::{rig_of, root};
use ident::fit::{FitError, ParameterSpec, Preparation, RatesBy, channel_by_channel, select};
use ident::record::{Column, Record, Start};
use jit::InProcess;
use runtime::Model;
use sim::{Hold, Signal, Signals, simulate};

/// Eq. 16 at 200 Hz, thrusts in steps of 2 s that move every axis, no encoders.
fn swing(model: &InProcess) -> Record {
    let t: Vec<f64> = (0..8000).map(|k| 0.005 * f64::from(k)).collect();
    let stamps: Vec<f64> = (0..20).map(|k| 2.0 * f64::from(k)).collect();
    let levels = |seed: f64| -> Vec<f64> { (0..20).map(|k| 1.45 + 0.35 * (seed + 2.4 * f64::from(k)).sin()).collect() };
    let signal = |values: Vec<f64>| Signal { t: stamps.clone(), values, hold: Hold::Zero };
    let signals = Signals::new(vec![signal(levels(0.3)), signal(levels(1.9))]).unwrap();
    let mut p = vec![0.0; model.dimensions().parameters];
    model.nominal(&mut p);
    let run = simulate(model, &p, &[0.0, -0.3, 0.1, 0.0, 0.0, 0.0], &signals, &t, &sim::Options::default()).unwrap();
    let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
    let mut columns: Vec<Column> =
        ["psi", "eps", "theta"].iter().enumerate().map(|(i, n)| column(n, (0..t.len()).map(|k| run.state(k)[i]).collect())).collect();
    let inputs: Vec<Vec<f64>> = t.iter().map(|t| signals.at(*t)).collect();
    columns.extend(["f_1", "f_2"].iter().enumerate().map(|(i, n)| column(n, inputs.iter().map(|u| u[i]).collect())));
    Record { source: "swing".to_owned(), t, columns, declared: Vec::new(), start: Start::Free }
}

#[test]
fn each_equation_gives_its_own_parameters() {
    let rig = rig_of(&root().join("examples/rigs/googol_identified.rig"));
    let model = InProcess::new(derive(&rig, Options::default()).unwrap());
    let record = [swing(&model)];
    let mut specs = ParameterSpec::of_rig(&rig);
    let free = ["a1", "a2", "a3", "b1", "b2", "b3", "b4", "c_psi", "c_eps", "c_theta"].map(str::to_owned);
    select(&mut specs, Some(&free), &[]).unwrap();
    let truth: Vec<f64> = specs.iter().map(|s| s.value).collect();
    for s in specs.iter_mut().filter(|s| s.free) {
        s.value *= 1.7;
    }
    for (name, rates) in
        [("observer", RatesBy::Observer { bandwidth: 60.0 }), ("filter of eq. 23", RatesBy::Filter { bandwidth: 60.0, damping: 0.9 })]
    {
        let fit = channel_by_channel(&model, &specs, &record, Preparation::Observed { rates, mean: 4 }, Hold::Zero).unwrap();
        assert!(fit.ending.converged(), "{name}: {}", fit.ending);
        assert_eq!(fit.parameters.len(), free.len(), "{name}");
        for e in &fit.parameters {
            let i = specs.iter().position(|s| s.name == e.name).unwrap();
            println!("{name}: {} {:.4} for {:.4} +- {:.4}", e.name, e.value, truth[i], e.std_error.unwrap_or(f64::NAN));
            // the equations are not linear, and an observer mixes 30 ms of them
            let allowed = 0.05;
            assert!((e.value / truth[i] - 1.0).abs() < allowed, "{name}: {} is {} and not {}", e.name, e.value, truth[i]);
        }
        assert!(fit.error_percent.iter().all(|(_, e)| *e < 5.0), "{name}: {:?}", fit.error_percent);
    }
}

#[test]
fn what_an_observer_cannot_do_is_said() {
    let rig = rig_of(&root().join("examples/rigs/googol_identified.rig"));
    let model = InProcess::new(derive(&rig, Options::default()).unwrap());
    let record = [swing(&model)];
    let specs = ParameterSpec::of_rig(&rig);
    let ask = |bandwidth: f64, mean: usize| {
        let preparation = Preparation::Observed { rates: RatesBy::Observer { bandwidth }, mean };
        channel_by_channel(&model, &specs, &record, preparation, Hold::Zero).unwrap_err()
    };
    assert!(matches!(ask(-1.0, 60), FitError::NotPositive { .. }));
    assert!(ask(60.0, 5000).to_string().contains("too few for means of 5000"), "{}", ask(60.0, 5000));
}
