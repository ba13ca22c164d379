//! `rig linearize`.

use crate::args::{Linearize, Point};
use crate::failure::Failure;
use crate::load::{self, Loaded, unknown};
use crate::operating::{self, Found};
use crate::output::{Answer, number, poles_in_words, prime, table};
use crate::pages;
use crate::sweep::Sweep;
use crate::workspace::{Item, Workspace};
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
    let sweep = args.sweep.as_deref().map(|text| Sweep::read(text, &args.point, &loaded, &model)).transpose()?;
    let points = sweep.as_ref().map_or_else(|| vec![args.point.clone()], |s| s.points.clone());
    let mut models: Vec<Linearized> = Vec::new();
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
        models.push(linear);
    }
    if let Some(sweep) = &sweep {
        let _ = writeln!(text, "\npoles over {}:", sweep.name);
        for (value, linear) in sweep.values.iter().zip(&models) {
            let _ = writeln!(text, "  {:>12}  {}", number(*value), poles_in_words(&linear.model.poles));
        }
    }
    let mut written = Vec::new();
    if let Some(path) = &args.export {
        let mut workspace = Workspace { source: source_name(&args.rig.file), items: Vec::new() };
        add_models(&mut workspace, &models.iter().collect::<Vec<_>>(), &inputs, sweep.as_ref());
        add_names(&mut workspace, &states, &inputs.names, &outputs);
        workspace.write(path, args.force)?;
        let _ = writeln!(text, "wrote {}", path.display());
        written.push(path.display().to_string());
    }
    if let Some(path) = &args.report {
        let source = pages::linear::Source { loaded: &loaded, layout, file: &args.rig.file, inputs: &inputs.names, sweep: sweep.as_ref() };
        pages::write(path, &pages::linear::linearize(&source, &models), args.force)?;
        let _ = writeln!(text, "wrote {}", path.display());
        written.push(path.display().to_string());
    }
    let json = json!({"report": args.report.as_ref().map(|p| p.display().to_string()), "rig": loaded.rig.name, "states": states, "inputs": inputs.names, "outputs": outputs, "points": documents, "files": written});
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

/// Rows of the accelerations and actuator states; columns states | inputs.
fn rows_of_rates(model: &LinearModel, states: &[&str], inputs: &[String], n: usize) -> String {
    let head = |i: usize| if i < 2 * n { format!("{}''", states[i - n]) } else { prime(&format!("{}.dot", states[i])) };
    let columns: Vec<String> = states.iter().map(|s| prime(s)).chain(inputs.iter().cloned()).collect();
    let rows: Vec<(String, Vec<f64>)> =
        (n..states.len()).map(|i| (head(i), model.a.row(i).iter().chain(model.b.row(i).iter()).copied().collect())).collect();
    format!("\n{}", table(&columns, &rows, states.len()))
}

/// Name of a file, without its folder.
pub fn source_name(path: &std::path::Path) -> String {
    path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned())
}

/// A, B, C, D, the point and its drift for other programs; pages where there are several points.
pub fn add_models(workspace: &mut Workspace, models: &[&Linearized], inputs: &Inputs, sweep: Option<&Sweep>) {
    let pages = |of: &dyn Fn(&Linearized) -> DMatrix<f64>| Item::Pages(models.iter().map(|l| of(l)).collect());
    let columns = |of: &dyn Fn(&Linearized) -> Vec<f64>| {
        let columns: Vec<Vec<f64>> = models.iter().map(|l| of(l)).collect();
        let rows = columns.first().map_or(0, Vec::len);
        Item::Pages(vec![DMatrix::from_fn(rows, columns.len(), |i, j| columns[j][i])])
    };
    workspace.items.extend([
        ("A", pages(&|l| l.model.a.clone())),
        ("B", pages(&|l| l.model.b.clone())),
        ("C", pages(&|l| l.model.c.clone())),
        ("D", pages(&|l| l.model.d.clone())),
        ("x0", columns(&|l| l.found.trim.x.clone())),
        ("u0", columns(&|l| (&inputs.rows * nalgebra::DVector::from_column_slice(&l.found.trim.u)).as_slice().to_vec())),
        ("dx0", columns(&|l| l.model.drift.clone())),
    ]);
    if let Some(sweep) = sweep {
        workspace.items.push(("sweep", Workspace::column(&sweep.values)));
        workspace.items.push(("sweep_name", Item::Names(vec![sweep.name.clone()])));
    }
}

/// Names of states, inputs and outputs.
pub fn add_names(workspace: &mut Workspace, states: &[&str], inputs: &[String], outputs: &[&str]) {
    let owned = |list: &[&str]| Item::Names(list.iter().map(|s| (*s).to_owned()).collect());
    workspace.items.extend([("states", owned(states)), ("inputs", Item::Names(inputs.to_vec())), ("outputs", owned(outputs))]);
}

fn document(loaded: &Loaded, model: &InProcess, linear: &Linearized, states: &[&str]) -> Value {
    let layout = &model.equations().layout;
    let rows = |m: &DMatrix<f64>| m.row_iter().map(|r| r.iter().copied().collect::<Vec<f64>>()).collect::<Vec<_>>();
    let by_name = |count: usize, name: &dyn Fn(usize) -> String, value: &dyn Fn(usize) -> f64| {
        Value::Object((0..count).map(|i| (name(i), json!(value(i)))).collect())
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
    document["input_delay"] = by_name(layout.inputs, &|i| layout.u[i].name.clone(), &|i| model.input_path(i, p).delay);
    document["output_delay"] = by_name(layout.outputs.len(), &|i| layout.outputs[i].name.clone(), &|i| model.output_path(i, p).delay);
    if (0..layout.outputs.len()).any(|i| model.output_path(i, p).play > 0.0) {
        document["output_play"] = by_name(layout.outputs.len(), &|i| layout.outputs[i].name.clone(), &|i| model.output_path(i, p).play);
    }
    document
}
