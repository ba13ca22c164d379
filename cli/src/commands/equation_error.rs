//! `rig identify --method equation-error` and `--method channels`: estimates without a run of the model, judged by its free runs all the same.

use super::identify::{each, estimates, followed, horizons, paths, report};
use crate::args::{Derivative, Identify, Method};
use crate::failure::Failure;
use crate::output::{Answer, number};
use crate::pages::{
    self,
    identify::{Identified, lay},
};
use ident::fit::{EquationErrorFit, ParameterSpec, Preparation, RatesBy, RecordFigures, channel_by_channel, equation_error, figures};
use ident::record::Record;
use runtime::Model;
use serde_json::{Value, json};
use std::fmt::Write;

pub fn run(
    args: &Identify,
    rig: &str,
    model: &dyn Model,
    specs: &[ParameterSpec],
    (records, tests): (&[Record], &[Record]),
) -> Result<Answer, Failure> {
    let (w, channels) = (args.bandwidth, args.method == Method::Channels);
    let preparation = match args.cutoff {
        _ if channels => {
            let rates = match args.derivative {
                Derivative::Observer => RatesBy::Observer { bandwidth: w },
                Derivative::Filter => RatesBy::Filter { bandwidth: w, damping: 0.9 },
            };
            Preparation::Observed { rates, mean: args.mean }
        }
        Some(cutoff) => Preparation::Filtered { cutoff, order: args.order, decimate: args.decimate },
        None => Preparation::WeakForm { window: args.bump },
    };
    let failed = |e: ident::fit::FitError| Failure::new("C0504", e.to_string());
    let way = if channels { channel_by_channel } else { equation_error };
    let fit = way(model, specs, records, preparation, args.hold.into()).map_err(failed)?;
    let nominal: Vec<f64> = specs.iter().map(|s| s.value).collect();
    // parameters of the day stay at their starting values on records that were not fitted
    let mut shared = nominal.clone();
    for e in fit.parameters.iter().filter(|e| e.record.is_none()) {
        shared.iter_mut().zip(specs).filter(|(_, s)| s.name == e.name).for_each(|(p, _)| *p = e.value);
    }
    let of = |p: &[f64], record: &Record| figures(model, p, std::slice::from_ref(record), args.hold.into(), args.horizon);
    let mut judged = Judged::default();
    for (record, p) in records.iter().zip(&fit.p_of_record) {
        judged.train.extend(of(p, record).map_err(failed)?);
        judged.before.extend(of(&nominal, record).map_err(failed)?);
    }
    for record in tests {
        judged.test.extend(of(&shared, record).map_err(failed)?);
        judged.before_test.extend(of(&nominal, record).map_err(failed)?);
    }
    let way = match preparation {
        Preparation::Filtered { cutoff, order, decimate } => format!(
            "derivatives by central differences behind a zero-phase Butterworth filter of order {order} at {} Hz, every {decimate}. equation",
            number(cutoff)
        ),
        Preparation::Observed { rates, mean } => {
            let by = if matches!(rates, RatesBy::Observer { .. }) { "an observer" } else { "the filter of eq. 23" };
            format!("channel by channel; rates by {by} of {} rad/s, means of {mean} samples", number(w))
        }
        Preparation::WeakForm { window } => format!("weak form, test functions of {window} samples"),
    };
    let mut answer = Answer { text: words(rig, &way, &fit, &judged), json: document(rig, &way, &fit, &judged) };
    report(args, &mut answer, || {
        let hold = args.hold.into();
        let trained = records.iter().zip(&fit.p_of_record).filter_map(|(r, p)| lay(model, (&nominal, p), r, &[], hold, false));
        let held = tests.iter().filter_map(|r| lay(model, (&nominal, &shared), r, &[], hold, true));
        let errors = fit.error_percent.iter().map(|(q, e)| format!("{q} {} %", number(*e))).collect::<Vec<_>>().join(", ");
        let untold: Vec<&str> = fit.parameters.iter().filter(|e| e.std_error.is_none() && !e.at_bound).map(|e| e.name.as_str()).collect();
        let facts = [("ended", fit.ending.to_string()), ("equation error", way.clone()), ("error of the equations", errors)];
        let found = Identified {
            rig,
            facts: facts.map(|(n, t)| (n.to_owned(), t)).to_vec(),
            warnings: if untold.is_empty() { Vec::new() } else { vec![format!("not told by the records: {}", untold.join(", "))] },
            parameters: &fit.parameters,
            correlation: None,
            train: (&judged.before, &judged.train),
            test: (&judged.before_test, &judged.test),
            runs: trained.chain(held).collect(),
        };
        pages::identify::page(&found, &args.rig.file, &paths(args), None)
    })?;
    Ok(answer)
}

/// Free runs with the estimates and with the starting values.
#[derive(Default)]
struct Judged {
    train: Vec<RecordFigures>,
    before: Vec<RecordFigures>,
    test: Vec<RecordFigures>,
    before_test: Vec<RecordFigures>,
}

fn words(rig: &str, way: &str, fit: &EquationErrorFit, judged: &Judged) -> String {
    let mut text = format!("{rig}: equation error, {}\n{way}\n\n", fit.ending);
    estimates(&mut text, &fit.parameters);
    let errors: Vec<String> =
        fit.error_percent.iter().map(|(q, e)| format!("{} {} %", crate::output::prime(&format!("{q}.ddot")), number(*e))).collect();
    let _ = writeln!(text, "  error of the equations over their measured side: {}\n", errors.join(", "));
    followed(&mut text, "training", &judged.before, &judged.train);
    followed(&mut text, "held out", &judged.before_test, &judged.test);
    text
}

fn document(rig: &str, way: &str, fit: &EquationErrorFit, judged: &Judged) -> Value {
    let both = |f: &dyn Fn(&ident::fit::SignalFigure) -> Value| json!({"train": each(&judged.train, f), "test": each(&judged.test, f)});
    json!({
        "rig": rig,
        "parameters": fit.parameters.iter().map(|e| json!({
            "name": e.name, "record": e.record, "value": e.value, "unit": e.unit, "std_error": e.std_error,
            "ci95": e.ci95.map(|(lo, hi)| [lo, hi]), "initial": e.initial, "at_bound": e.at_bound,
        })).collect::<Vec<_>>(),
        "objective": format!("equation error: {way}"),
        "equation_error_percent": fit.error_percent.iter().map(|(q, e)| (q.clone(), json!(e))).collect::<serde_json::Map<_, _>>(),
        "status": fit.ending.id(),
        "fit_percent": both(&|s| json!(s.fit_percent)),
        "rmse": both(&|s| json!(s.rmse)),
        "horizon": horizons([&judged.train, &judged.test]),
        "evaluations": fit.evaluations,
    })
}
