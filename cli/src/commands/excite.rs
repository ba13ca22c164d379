//! `rig excite`: a first input, and what it would tell.

use crate::args::{Excite, Shape};
use crate::commands::linearize::at_point;
use crate::failure::Failure;
use crate::load::{self, Loaded, assignment, unknown};
use crate::output::{Answer, number};
use codegen::{Layout, Options};
use ident::excitation::{Excitation, Request, propose};
use jit::InProcess;
use nalgebra::DMatrix;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::fmt::Write;

/// Where a coordinate has no range: an angle at which nothing hits anything on most rigs, a short way on a rail.
const ANGLE: f64 = 20.0 * TAU / 360.0;
const LENGTH: f64 = 0.1;

pub fn run(args: &Excite) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::new(load::equations(&loaded, Options::default())?);
    let layout = &model.equations().layout;
    let directions = DMatrix::identity(layout.u.len(), layout.u.len());
    let linear = at_point(&loaded, &model, &args.point, &directions, false)?;
    let trim = &linear.found.trim;
    let within = within(&loaded, layout, &trim.x, &linear.found.cyclic, &args.within)?;
    let poles: Vec<f64> = linear.model.poles.iter().map(|z| z.norm() / TAU).filter(|f| *f > 1e-3).collect();
    let fastest = poles.iter().copied().fold(0.0, f64::max);
    let band = band(fastest, args.duration, args.rate);
    let request = Request {
        x: trim.x.clone(),
        u: trim.u.clone(),
        duration: args.duration,
        rate: args.rate,
        shape: match args.shape {
            Shape::Multisine => ident::excitation::Shape::Multisine,
            Shape::Steps => ident::excitation::Shape::Steps,
        },
        band,
        within: within.iter().map(|w| (w.below, w.above)).collect(),
        seed: args.seed,
    };
    let free: Vec<usize> = loaded.rig.parameters.iter().enumerate().filter(|(_, p)| !p.fixed && !p.constant).map(|(i, _)| i).collect();
    let found = propose(&model, &layout.nominal, &free, &request).map_err(|e| Failure::new("C0621", e.to_string()))?;
    crate::write::write(&args.out, &csv(layout, &found), args.force)?;
    let mut text = linear.found.words(&loaded, layout);
    let _ = writeln!(text, "\n{}", found.words);
    let _ = writeln!(
        text,
        "  band: {}; {} s at {} Hz",
        if fastest > 0.0 { format!("up to twice the fastest pole ({} Hz)", number(fastest)) } else { "no pole tells one, 2 Hz".to_owned() },
        number(args.duration),
        number(args.rate)
    );
    for (i, u) in layout.u.iter().take(layout.inputs).enumerate() {
        let limits = loaded.rig.inputs.get(i).and_then(|i| i.limits);
        let limits =
            limits.map_or_else(|| "no limits in the rig".to_owned(), |(lo, hi)| format!("limits {} .. {}", number(lo), number(hi)));
        let _ = writeln!(text, "  {:10} {} +- {} {}   ({limits})", u.name, number(trim.u[i]), number(found.amplitude[i]), u.unit);
    }
    for (i, q) in layout.q.iter().enumerate() {
        let _ = writeln!(
            text,
            "  {:10} goes from {} to {}   ({})",
            q.name,
            shown(found.excursion[i].0, &q.unit),
            shown(found.excursion[i].1, &q.unit),
            within[i].words
        );
    }
    let _ = writeln!(text, "  its size is limited by {}", found.limited_by);
    text.push_str(&told(&found));
    let _ = writeln!(text, "wrote {}", args.out.display());
    Ok(Answer { text, json: document(&loaded, layout, &found, args, band) })
}

/// From a few periods of the record to twice the fastest pole, well below the sampling rate.
fn band(fastest: f64, duration: f64, rate: f64) -> (f64, f64) {
    let low = 2.0 / duration;
    let high = if fastest > 0.0 { 2.0 * fastest } else { 2.0 };
    (low, high.min(rate / 10.0).max(4.0 * low))
}

/// How far a coordinate may go.
struct Within {
    below: f64,
    above: f64,
    words: String,
}

fn within(loaded: &Loaded, layout: &Layout, x: &[f64], cyclic: &[usize], given: &[String]) -> Result<Vec<Within>, Failure> {
    let mut list: Vec<Within> = Vec::new();
    for (i, q) in layout.q.iter().enumerate() {
        let range = loaded.rig.coordinates.iter().find(|c| c.name == q.name).and_then(|c| c.range);
        list.push(match range {
            Some((lo, hi)) => {
                let (below, above) = (0.5 * (x[i] - lo).max(0.0), 0.5 * (hi - x[i]).max(0.0));
                if below == 0.0 || above == 0.0 {
                    return Err(Failure::new("C0622", format!("`{}` is {} here, at an end of its range", q.name, shown(x[i], &q.unit)))
                        .with_help(&format!("start inside of it, as in `--at {}={}`", q.name, number(0.5 * (lo + hi)))));
                }
                Within { below, above, words: "half way to the ends of its range".to_owned() }
            }
            // it turns freely: nothing depends on where it is
            None if cyclic.contains(&i) => Within { below: f64::INFINITY, above: f64::INFINITY, words: "free to go anywhere".to_owned() },
            None => {
                let reach = if q.unit == "m" { LENGTH } else { ANGLE };
                Within {
                    below: reach,
                    above: reach,
                    words: format!("within {} of the point, since the rig gives no range", shown(reach, &q.unit)),
                }
            }
        });
    }
    for text in given {
        let (name, value) = assignment(text)?;
        let names: Vec<&str> = layout.q.iter().map(|q| q.name.as_str()).collect();
        let i = names.iter().position(|n| *n == name).ok_or_else(|| unknown("coordinate", name, &names))?;
        let unit = &loaded.rig.coordinates.iter().find(|c| c.name == name).map_or_else(model_dsl::units::Unit::none, |c| c.unit.clone());
        let reach = model_dsl::parse_value(value, unit).map_err(|e| Failure::new("C0102", format!("--within {text}: {e}")))?;
        if !(reach > 0.0 && reach.is_finite()) {
            return Err(Failure::new("C0622", format!("--within {text}: this must be a positive distance from the point")));
        }
        list[i] = Within { below: reach, above: reach, words: format!("within {}, as asked", shown(reach, &layout.q[i].unit)) };
    }
    Ok(list)
}

fn part(share: f64) -> String {
    if share < 1e-4 { "below 0.01 %".to_owned() } else { format!("{} %", number((1e4 * share).round() / 100.0)) }
}

fn shown(x: f64, unit: &str) -> String {
    if unit == "rad" { format!("{:.1} deg", x.to_degrees()) } else { format!("{} {unit}", number((1e6 * x).round() / 1e6)) }
}

fn told(found: &Excitation) -> String {
    let mut text = "\n  what such a record would tell, if the model is right and the encoders the only noise:\n".to_owned();
    let width = found.predicted.iter().map(|p| p.name.chars().count()).max().unwrap_or(0).max(9);
    for p in &found.predicted {
        let cell = match p.std_error {
            Some(s) if p.value != 0.0 => format!("+- {s:.1e}  ({})", part(s / p.value.abs())),
            Some(s) => format!("+- {s:.1e}"),
            None => "not told".to_owned(),
        };
        let _ = writeln!(text, "  {:width$} {:>12} {} {cell}", p.name, number(p.value), p.unit);
    }
    if found.predicted.is_empty() {
        text.push_str("  nothing: every parameter of the rig is fixed\n");
    }
    text
}

fn csv(layout: &Layout, found: &Excitation) -> String {
    let mut text = String::from("t");
    for u in &layout.u {
        let _ = write!(text, ",{} [{}]", u.name, u.unit);
    }
    text.push('\n');
    for (k, t) in found.t.iter().enumerate() {
        let _ = write!(text, "{:.6}", t);
        for series in &found.inputs {
            let _ = write!(text, ",{:.6}", series[k]);
        }
        text.push('\n');
    }
    text
}

fn document(loaded: &Loaded, layout: &Layout, found: &Excitation, args: &Excite, band: (f64, f64)) -> Value {
    let named =
        |list: Vec<Value>, names: &[codegen::Variable]| names.iter().map(|n| n.name.clone()).zip(list).collect::<serde_json::Map<_, _>>();
    json!({
        "rig": loaded.rig.name,
        "words": found.words,
        "samples": found.t.len(),
        "duration": args.duration,
        "rate": args.rate,
        "band": [band.0, band.1],
        "seed": args.seed,
        "amplitude": named(found.amplitude.iter().map(|a| json!(a)).collect(), &layout.u),
        "excursion": named(found.excursion.iter().map(|(lo, hi)| json!([lo, hi])).collect(), &layout.q),
        "limited_by": found.limited_by,
        "predicted": found.predicted.iter().map(|p| json!({"name": p.name, "value": p.value, "unit": p.unit, "std_error": p.std_error})).collect::<Vec<_>>(),
        "files": [args.out.display().to_string()],
    })
}
