//! `rig identify --method innovations`: parameters together with the random forces that drive the rig.

use super::identify::{document, page, report, words};
use crate::args::Identify;
use crate::failure::Failure;
use crate::load::Loaded;
use crate::output::{Answer, number};
use crate::pages::short;
use codegen::Options;
use diagnose::forces::{dry_frictions, with_forces};
use diagnose::patch::Base;
use ident::fit::ParameterSpec;
use ident::innovations::{Driven, InnovationsFit, InnovationsOptions, Positive, Track, identify, unwatched};
use ident::record::Record;
use jit::InProcess;
use serde_json::{Value, json};

pub fn run(args: &Identify, loaded: Loaded, asked: &[ParameterSpec], (records, tests): (&[Record], &[Record])) -> Result<Answer, Failure> {
    misplaced(args)?;
    let lumps = loaded.lumps;
    let base = Base::new(loaded.rig, loaded.checked.sources);
    let (pushed, forces) = with_forces(&base).map_err(|e| Failure::new("C0504", e.to_string()))?;
    let equations =
        codegen::derive(&pushed.rig, Options { lumps, ..Options::default() }).map_err(|e| Failure::new("C0201", e.to_string()))?;
    let model = InProcess::at_work(equations);
    let mut specs = ParameterSpec::of_rig(&pushed.rig);
    for spec in &mut specs {
        match asked.iter().find(|s| s.name == spec.name) {
            Some(own) => *spec = own.clone(),
            None => spec.free = false,
        }
    }
    let options =
        InnovationsOptions { hold: args.hold.into(), horizon: args.horizon, block: args.decimate.max(1), ..InnovationsOptions::default() };
    let nominal: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let tracks = records
        .iter()
        .map(|r| Track::new(r, &model, &nominal, options.hold))
        .collect::<Result<Vec<_>, _>>()
        .map_err(|e| Failure::new("C0504", e.to_string()))?;
    let unwatched = unwatched(&model, &nominal, &tracks);
    for &i in &unwatched {
        eprintln!("no training record measures {}: it moves as the model says", base.rig.coordinates[i].name);
    }
    let entries: Vec<(String, usize)> = forces
        .iter()
        .filter(|f| !unwatched.contains(&f.coordinate))
        .filter_map(|f| Some((base.rig.coordinates[f.coordinate].name.clone(), specs.iter().position(|s| s.name == f.parameter)?)))
        .collect();
    let coordinates: Vec<usize> = forces.iter().map(|f| f.coordinate).filter(|i| !unwatched.contains(i)).collect();
    let driven = Driven { forces: entries, dry: dry_frictions(&pushed.rig, &coordinates) };
    eprintln!(
        "fitting {} parameters and the sizes of random forces on {} coordinates to {} records ..",
        specs.iter().filter(|s| s.free).count(),
        driven.forces.len(),
        records.len()
    );
    let found = identify(&model, &specs, &driven, records, tests, &options).map_err(|e| Failure::new("C0504", e.to_string()))?;
    let rig = &base.rig.name;
    let told = facts(&found);
    let short = found.forces.iter().filter(|f| f.sd.ci95.is_some() && f.time.at_bound).map(|f| {
        let text = "is as short as the samples: it may stand for the encoder's steps and make up for the model; average samples with `--decimate N`";
        (format!("look at this: the random force on {}", f.coordinate), text.to_owned())
    });
    let told: Vec<(String, String)> = told.into_iter().chain(short).collect();
    let lines: Vec<String> = told.iter().map(|(name, text)| format!("{name}: {text}")).collect();
    let mut answer = Answer { text: words(rig, &found.fit, &lines), json: json_of(rig, &found) };
    report(args, &mut answer, || page(args, rig, &model, &found.fit, &told, (records, tests)))?;
    Ok(answer)
}

/// Options that belong to other methods are not passed over in silence.
fn misplaced(args: &Identify) -> Result<(), Failure> {
    let given = [
        ("--robust", args.robust),
        ("--shooting", args.shooting.is_some()),
        ("--windows", args.windows.is_some()),
        ("--cutoff", args.cutoff.is_some()),
        ("--rates", args.rates.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((option, _)) => Err(Failure::new("C0504", format!("`{option}` has no meaning for `--method innovations`")).with_help(
            "the filter begins at the state of the first samples, weighs errors by the noises that it finds, and needs no pieces",
        )),
        None => Ok(()),
    }
}

fn positive(p: &Positive, unit: &str) -> String {
    let interval = match p.ci95 {
        Some((lo, hi)) => format!(" ({} .. {})", number(lo), number(hi)),
        None if p.at_bound => " (at the end of its range)".to_owned(),
        None => " (not told)".to_owned(),
    };
    format!("{} {unit}{interval}", number(p.value))
}

/// Random forces and noises, as they are said.
fn facts(found: &InnovationsFit) -> Vec<(String, String)> {
    let forces = found.forces.iter().map(|f| {
        let text = format!("{}, correlated over {}", positive(&f.sd, &f.unit), positive(&f.time, "s"));
        (format!("random force on {}", f.coordinate), text)
    });
    let noise = found.noise.iter().map(|n| (format!("noise of {}", n.output), positive(&n.sd, "(SI)")));
    let white: Vec<String> =
        found.fit.whiteness.iter().map(|w| format!("{} in {} p = {}", w.output, short(&w.record), number(w.p_value))).collect();
    let white = (!white.is_empty()).then(|| ("whiteness of the innovations (Ljung and Box)".to_owned(), white.join("; ")));
    forces.chain(noise).chain(white).collect()
}

fn json_of(rig: &str, found: &InnovationsFit) -> Value {
    let of = |p: &Positive| json!({"value": p.value, "ci95": p.ci95.map(|(lo, hi)| [lo, hi]), "at_bound": p.at_bound});
    let mut document = document(rig, &found.fit);
    document["method"] = json!("innovations");
    document["log_likelihood"] = json!(found.log_likelihood);
    document["random_forces"] = found
        .forces
        .iter()
        .map(|f| json!({"coordinate": f.coordinate, "unit": f.unit, "sd": of(&f.sd), "correlation_time": of(&f.time)}))
        .collect();
    document["output_noise"] = found.noise.iter().map(|n| json!({"output": n.output, "sd": of(&n.sd)})).collect();
    document
}
