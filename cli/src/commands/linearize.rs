//! `rig linearize`.

use crate::args::{Linearize, Point};
use crate::failure::Failure;
use crate::load::{self, Loaded, unknown};
use crate::operating::{self, Found};
use crate::output::{Answer, number, poles_in_words, prime, table};
use codegen::{Options, direction_by_name};
use control::{LinearModel, LinearizeError};
use jit::InProcess;
use nalgebra::DMatrix;
use runtime::Model;
use serde_json::{Value, json};
use std::fmt::Write;

/// The linear model at one operating point, and what it leaves out.
pub struct Linearized {
    /// Operating point.
    pub found: Found,
    /// A, B, C, D, drift, poles.
    pub model: LinearModel,
    /// Entries of A that the slope of regularized friction would add: (row, column, value).
    pub dropped: Vec<(usize, usize, f64)>,
}

pub fn run(args: &Linearize) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::new(load::equations(&loaded, Options::default())?);
    let layout = &model.equations().layout;
    let inputs = inputs_of(&loaded, &model, &args.inputs)?;
    let points: Vec<Point> = match &args.sweep {
        None => vec![args.point.clone()],
        Some(sweep) => sweep_values(sweep)?
            .into_iter()
            .map(|value| {
                let mut at: Vec<String> =
                    args.point.at.iter().filter(|t| t.split('=').next().map(str::trim) != value.split('=').next()).cloned().collect();
                at.push(value);
                Point { at, trim: args.point.trim.clone() }
            })
            .collect(),
    };
    let mut text = String::new();
    let mut documents: Vec<Value> = Vec::new();
    let states: Vec<&str> = layout.x().map(|v| v.name.as_str()).collect();
    let outputs: Vec<&str> = layout.outputs.iter().map(|o| o.name.as_str()).collect();
    for point in &points {
        let linear = at_point(&loaded, &model, point, &inputs.directions, args.friction_slope)?;
        if !text.is_empty() {
            text.push('\n');
        }
        text.push_str(&linear.found.words(&loaded, layout));
        text.push_str(&rows_of_rates(&linear.model, &states, &inputs.names, layout.q.len()));
        let _ = writeln!(text, "poles: {}", poles_in_words(&linear.model.poles));
        for (i, j, value) in &linear.dropped {
            let _ = writeln!(
                text,
                "left out: the slope of regularized friction, {} at A[{}, {}] (--friction-slope keeps it)",
                number(*value),
                prime(states[*i]),
                prime(states[*j])
            );
        }
        let mut document = document(&loaded, &model, &linear, &states);
        document["input"] = (&inputs.rows * nalgebra::DVector::from_column_slice(&linear.found.trim.u)).as_slice().into();
        documents.push(document);
    }
    let json = json!({"rig": loaded.rig.name, "states": states, "inputs": inputs.names, "outputs": outputs, "points": documents});
    Ok(Answer { text, json })
}

/// Linear model at one point.
pub fn at_point(
    loaded: &Loaded,
    model: &InProcess,
    point: &Point,
    directions: &DMatrix<f64>,
    friction_slope: bool,
) -> Result<Linearized, Failure> {
    linear_at(model, operating::find(loaded, model, point)?, directions, friction_slope)
}

/// Linear model at a point that was found.
pub fn linear_at(model: &InProcess, found: Found, directions: &DMatrix<f64>, friction_slope: bool) -> Result<Linearized, Failure> {
    let layout = &model.equations().layout;
    let (x, u, p) = (&found.trim.x, &found.trim.u, &layout.nominal);
    let linear = |slope: bool| {
        control::linearize(model, p, x, directions, |dx, a, b| {
            if slope { model.linearize(0.0, x, u, p, dx, a, b) } else { model.linearize_without_friction_slope(0.0, x, u, p, dx, a, b) }
        })
        .map_err(|e| match e {
            LinearizeError::Singular { coordinate } => operating::singular(&coordinate),
            LinearizeError::Directions { .. } | LinearizeError::NotFinite => {
                Failure::new("C0305", e.to_string()).with_help("choose another state with --at: the rig's equations have no slope here")
            }
        })
    };
    let (kept, other) = (linear(friction_slope)?, linear(true)?);
    let difference = &other.a - &kept.a;
    let dropped = (0..difference.nrows())
        .flat_map(|i| (0..difference.ncols()).map(move |j| (i, j)))
        .map(|(i, j)| (i, j, difference[(i, j)]))
        .filter(|(_, _, d)| *d != 0.0)
        .collect();
    Ok(Linearized { found, model: kept, dropped })
}

/// Inputs of the linear model.
pub struct Inputs {
    /// Names.
    pub names: Vec<String>,
    /// How the model's signals move with each: signals x inputs.
    pub directions: DMatrix<f64>,
    /// Each input over the model's signals: inputs x signals.
    pub rows: DMatrix<f64>,
}

/// The inputs asked for; the model's own signals where none were.
pub fn inputs_of(loaded: &Loaded, model: &InProcess, names: &[String]) -> Result<Inputs, Failure> {
    let layout = &model.equations().layout;
    let names: Vec<String> = if names.is_empty() {
        layout.u.iter().map(|v| v.name.clone()).collect()
    } else {
        names.iter().map(|n| n.trim().to_owned()).collect()
    };
    let mut directions = DMatrix::zeros(layout.u.len(), names.len());
    let mut rows = DMatrix::zeros(names.len(), layout.u.len());
    for (k, name) in names.iter().enumerate() {
        let direction = direction_by_name(&loaded.rig, layout, name).filter(|d| d.states.is_empty());
        let Some(direction) = direction else {
            let mixed = loaded.rig.mixes.iter().flat_map(|m| &m.names);
            let known: Vec<&str> = layout.u.iter().map(|v| v.name.as_str()).chain(mixed.map(String::as_str)).collect();
            return Err(unknown("input", name, &known));
        };
        if names[..k].contains(name) {
            return Err(Failure::new("C0105", format!("`{name}` is given twice")).with_help("name each input once"));
        }
        direction.signals.iter().for_each(|&(i, w)| directions[(i, k)] = w);
        match loaded.rig.mixes.iter().find_map(|m| m.names.iter().position(|n| n == name).map(|r| (m, r))) {
            Some((mix, row)) => mix.inputs.iter().zip(&mix.rows[row]).for_each(|(&i, &w)| rows[(k, i)] = w),
            None => direction.signals.iter().for_each(|&(i, w)| rows[(k, i)] = w),
        }
    }
    // each input moves alone: a mixed input beside one that it is made of does not
    let alone = &rows * &directions - DMatrix::identity(names.len(), names.len());
    if alone.iter().any(|x| x.abs() > 1e-9) {
        return Err(Failure::new("C0104", format!("the inputs {} depend on each other", names.join(", ")))
            .with_help("take the mixed inputs, or the rig's own, but not both"));
    }
    Ok(Inputs { names, directions, rows })
}

/// `name=a:b:n` to n assignments.
fn sweep_values(text: &str) -> Result<Vec<String>, Failure> {
    let wrong = || {
        Failure::new("C0106", format!("--sweep {text} is not of the form name=from:to:count"))
            .with_help("for example `--sweep theta=-10deg:10deg:5`")
    };
    let (name, range) = load::assignment(text)?;
    let parts: Vec<&str> = range.split(':').map(str::trim).collect();
    let [from, to, count] = parts[..] else { return Err(wrong()) };
    let count: usize = count.parse().ok().filter(|n| (1..=10_000).contains(n)).ok_or_else(wrong)?;
    let split = |s: &str| -> Option<(f64, String)> {
        let end = s
            .char_indices()
            .map(|(i, _)| i)
            .chain([s.len()])
            .rev()
            .find(|&i| s.get(..i).is_some_and(|head| head.trim().parse::<f64>().is_ok()))?;
        Some((s.get(..end)?.trim().parse().ok()?, s.get(end..)?.trim().to_owned()))
    };
    let ((a, unit_a), (b, unit_b)) = (split(from).ok_or_else(wrong)?, split(to).ok_or_else(wrong)?);
    if unit_a != unit_b {
        return Err(Failure::new("C0106", format!("--sweep {text}: both ends need the same unit"))
            .with_help("for example `--sweep theta=-10deg:10deg:5`"));
    }
    let step = |k: usize| if count == 1 { a } else { a + (b - a) * k as f64 / (count - 1) as f64 };
    Ok((0..count).map(|k| format!("{name}={:?}{unit_a}", step(k))).collect())
}

/// Rows of the accelerations and actuator states; columns states | inputs.
fn rows_of_rates(model: &LinearModel, states: &[&str], inputs: &[String], n: usize) -> String {
    let head = |i: usize| if i < 2 * n { format!("{}''", states[i - n]) } else { prime(&format!("{}.dot", states[i])) };
    let columns: Vec<String> = states.iter().map(|s| prime(s)).chain(inputs.iter().cloned()).collect();
    let rows: Vec<(String, Vec<f64>)> =
        (n..states.len()).map(|i| (head(i), model.a.row(i).iter().chain(model.b.row(i).iter()).copied().collect())).collect();
    format!("\n{}", table(&columns, &rows, states.len()))
}

fn document(loaded: &Loaded, model: &InProcess, linear: &Linearized, states: &[&str]) -> Value {
    let layout = &model.equations().layout;
    let rows = |m: &DMatrix<f64>| m.row_iter().map(|r| r.iter().copied().collect::<Vec<f64>>()).collect::<Vec<_>>();
    let delays = |count: usize, name: &dyn Fn(usize) -> String, delay: &dyn Fn(usize) -> f64| {
        Value::Object((0..count).map(|i| (name(i), json!(delay(i)))).collect())
    };
    let p = &layout.nominal;
    let mut document = linear.found.json(loaded, layout);
    document["constant"] = json!(linear.model.drift);
    document["A"] = json!(rows(&linear.model.a));
    document["B"] = json!(rows(&linear.model.b));
    document["C"] = json!(rows(&linear.model.c));
    document["D"] = json!(rows(&linear.model.d));
    document["poles"] = json!(linear.model.poles.iter().map(|z| [z.re, z.im]).collect::<Vec<_>>());
    document["dropped"] = linear
        .dropped
        .iter()
        .map(|(i, j, v)| json!({"what": "slope of regularized friction", "row": states[*i], "column": states[*j], "value": v}))
        .collect();
    document["input_delay"] = delays(layout.inputs, &|i| layout.u[i].name.clone(), &|i| model.input_path(i, p).delay);
    document["output_delay"] = delays(layout.outputs.len(), &|i| layout.outputs[i].name.clone(), &|i| model.output_path(i, p).delay);
    document
}
