//! `rig lqr`.

use crate::args::{Language, Lqr as Arguments};
use crate::commands::linearize::{Inputs, Linearized, add_models, add_names, at_point, inputs_of, source_name};
use crate::failure::Failure;
use crate::load::{self, Loaded};
use crate::output::{Answer, number, poles_in_words, prime, table};
use crate::pages;
use crate::sweep::Sweep;
use crate::workspace::{Item, Workspace};
use codegen::Options;
use codegen::emit::controller::{Schedule, Signal, schedule_c, schedule_rust};
use control::{Lqr, LqrDesign, LqrError, NameError, Plant, Sampling, Weight};
use jit::InProcess;
use nalgebra::DMatrix;
use runtime::Model;
use serde_json::{Value, json};
use std::fmt::Write;

pub fn run(args: &Arguments) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::new(load::equations(&loaded, Options::default())?);
    let layout = &model.equations().layout;
    // a regulator moves inputs; accelerations of prescribed coordinates only where asked for
    let named =
        if args.inputs.is_empty() { layout.u[..layout.inputs].iter().map(|u| u.name.clone()).collect() } else { args.inputs.clone() };
    let inputs = inputs_of(&loaded, &model, &named)?;
    let sweep = args.sweep.as_deref().map(|text| Sweep::read(text, &args.point, &loaded, &model)).transpose()?;
    let points = sweep.as_ref().map_or_else(|| vec![args.point.clone()], |s| s.points.clone());
    let design = design(args)?;
    let mut designs: Vec<(Linearized, Lqr)> = Vec::new();
    let mut plants: Vec<Plant> = Vec::new();
    let mut text = String::new();
    let mut left_out = false;
    for point in &points {
        let linear = at_point(&loaded, &model, point, &inputs.directions, args.friction_slope)?;
        let plant = Plant::new(&model, &linear.model, &inputs.names);
        let found = control::lqr(&plant, &design).map_err(|e| failure(&e, point, sweep.is_some()))?;
        left_out = found.states.len() - found.integrals < plant.states.len();
        if sweep.is_none() {
            text.push_str(&linear.found.words(&loaded, layout));
            text.push_str(&one(&found, left_out));
        }
        designs.push((linear, found));
        plants.push(plant);
    }
    if let Some(sweep) = &sweep {
        text.push_str(&swept(sweep, &inputs, &designs, left_out));
    }
    let mut written = Vec::new();
    if let Some(path) = &args.export {
        export(&model, args, &inputs, sweep.as_ref(), &designs).write(path, args.force)?;
        written.push(path.display().to_string());
    }
    if let Some(folder) = &args.generate {
        let schedule = schedule(&loaded, &model, args, &inputs, sweep.as_ref(), &designs)?;
        let files = match args.lang {
            Language::Rust => vec![(format!("{}.rs", schedule.name), schedule_rust(&schedule))],
            Language::C => schedule_c(&schedule).to_vec(),
        };
        for (name, text) in files {
            let path = folder.join(name);
            crate::write::write(&path, &text, args.force)?;
            written.push(path.display().to_string());
        }
    }
    if let Some(path) = &args.report {
        let source = pages::linear::Source { loaded: &loaded, layout, file: &args.rig.file, inputs: &inputs.names, sweep: sweep.as_ref() };
        pages::write(path, &pages::linear::lqr(&source, &designs, &plants), args.force)?;
        written.push(path.display().to_string());
    }
    if !written.is_empty() {
        let _ = writeln!(text, "wrote {}", written.join(", "));
    }
    let documents: Vec<Value> = designs.iter().map(|(linear, found)| document(&loaded, &model, linear, found)).collect();
    let mut json = match (&sweep, documents) {
        (None, mut documents) => documents.pop().unwrap_or_default(),
        (Some(sweep), documents) => {
            json!({"rig": loaded.rig.name, "sweep": {"name": sweep.name, "values": sweep.values}, "points": documents})
        }
    };
    json["files"] = json!(written);
    json["report"] = json!(args.report.as_ref().map(|p| p.display().to_string()));
    Ok(Answer { text, json })
}

fn design(args: &Arguments) -> Result<LqrDesign, Failure> {
    let period = args
        .discrete
        .as_ref()
        .map(|text| {
            let seconds = model_dsl::parse_unit("s").map_err(|e| Failure::new("C0102", e))?;
            model_dsl::parse_value(text, &seconds)
                .map_err(|e| Failure::new("C0102", format!("--discrete {text}: {e}")).with_help("the sampling period: `0.005`, `5ms`"))
        })
        .transpose()?;
    let trimmed = |list: &[String]| list.iter().map(|s| s.trim().to_owned()).collect::<Vec<_>>();
    Ok(LqrDesign {
        states: trimmed(&args.states),
        integrate: trimmed(&args.integrate),
        weight_x: Weight::Diagonal(args.weights_x.clone()),
        weight_u: Weight::Diagonal(args.weights_u.clone()),
        sampling: match (period, args.sum) {
            (None, _) => Sampling::Continuous,
            (Some(period), true) => Sampling::Sum { period },
            (Some(period), false) => Sampling::Integral { period },
        },
    })
}

fn gain_table(found: &Lqr) -> String {
    let columns: Vec<String> = found.states.iter().map(|s| column(s)).collect();
    let rows: Vec<(String, Vec<f64>)> = found.inputs.iter().cloned().zip(found.k.row_iter().map(|r| r.iter().copied().collect())).collect();
    table(&columns, &rows, usize::MAX)
}

/// `eps.integral` as people write it.
fn column(state: &str) -> String {
    state.strip_suffix(".integral").map_or_else(|| prime(state), |name| format!("int {name}"))
}

/// One regulator in words.
fn one(found: &Lqr, left_out: bool) -> String {
    let mut text = String::from("\nu = u* - K (x - x*)   K:\n");
    text.push_str(&gain_table(found));
    let kind = if found.period.is_some() { " (of z)" } else { "" };
    let _ = writeln!(text, "poles{kind}: {}", poles_in_words(&found.poles));
    if left_out {
        let _ = writeln!(text, "poles of the whole model with this gain{kind}: {}", poles_in_words(&found.plant_poles));
    }
    if found.integrals > 0 {
        let names: Vec<&str> = found.states.iter().filter_map(|s| s.strip_suffix(".integral")).collect();
        let _ = writeln!(
            text,
            "integrals: z' = y - y* + L (u_applied - u_asked); at a limit z follows within {} s   L:",
            number(found.tracking_time)
        );
        let rows: Vec<(String, Vec<f64>)> =
            names.iter().map(|n| format!("int {n}")).zip(found.anti_windup.row_iter().map(|r| r.iter().copied().collect())).collect();
        text.push_str(&table(&found.inputs, &rows, usize::MAX));
    }
    for c in &found.neglected {
        let _ = writeln!(
            text,
            "neglected: {}' depends on {} by {}, which the design leaves out",
            prime(&c.onto),
            prime(&c.from),
            number(c.value)
        );
    }
    let _ = writeln!(text, "Riccati residual {:.0e} (relative)", found.residual);
    text
}

/// The regulators of a sweep: one table an input, and the poles.
fn swept(sweep: &Sweep, inputs: &Inputs, designs: &[(Linearized, Lqr)], left_out: bool) -> String {
    let Some((_, first)) = designs.first() else { return String::new() };
    let columns: Vec<String> = first.states.iter().map(|s| column(s)).chain(["u*".to_owned()]).collect();
    let mut text = String::from("u = u* - K (x - x*)\n");
    for (i, input) in first.inputs.iter().enumerate() {
        let rows: Vec<(String, Vec<f64>)> = sweep
            .values
            .iter()
            .zip(designs)
            .map(|(value, (linear, found))| {
                let terms = || inputs.rows.row(i).iter().zip(&linear.found.trim.u).map(|(r, u)| r * u).collect::<Vec<f64>>();
                let (at, size) = (terms().iter().sum::<f64>(), terms().iter().fold(0.0_f64, |m, x| m.max(x.abs())));
                // what cancels to rounding is nothing
                let at = if at.abs() < 1e-12 * size { 0.0 } else { at };
                let row = found.k.row(i).iter().copied().chain([at]).collect();
                (format!("{} = {}", sweep.name, number(*value)), row)
            })
            .collect();
        let _ = write!(text, "\nK, row {input}:\n{}", table(&columns, &rows, first.states.len()));
    }
    let kind = if first.period.is_some() { " (of z)" } else { "" };
    let what = if left_out { " of the whole model with the gain" } else { "" };
    let _ = writeln!(text, "\npoles{what}{kind}:");
    for (value, (_, found)) in sweep.values.iter().zip(designs) {
        let _ = writeln!(text, "  {:>12}  {}", number(*value), poles_in_words(&found.plant_poles));
    }
    let worst = designs.iter().map(|d| d.1.residual).fold(0.0, f64::max);
    let _ = writeln!(text, "Riccati residuals at most {worst:.0e} (relative)");
    text
}

fn rows(m: &DMatrix<f64>) -> Vec<Vec<f64>> {
    m.row_iter().map(|r| r.iter().copied().collect()).collect()
}

fn document(loaded: &Loaded, model: &InProcess, linear: &Linearized, found: &Lqr) -> Value {
    let poles = |p: &[nalgebra::Complex<f64>]| p.iter().map(|z| [z.re, z.im]).collect::<Vec<_>>();
    json!({
        "rig": loaded.rig.name,
        "K": rows(&found.k),
        "P": rows(&found.p),
        "poles": poles(&found.poles),
        "plant_poles": poles(&found.plant_poles),
        "states": found.states,
        "integrals": found.integrals,
        "inputs": found.inputs,
        "trim": linear.found.json(loaded, &model.equations().layout),
        "residual": found.residual,
        "neglected": found.neglected.iter().map(|c| json!({"onto": c.onto, "from": c.from, "value": c.value})).collect::<Vec<_>>(),
        "anti_windup": rows(&found.anti_windup),
        "tracking_time": if found.integrals > 0 { json!(found.tracking_time) } else { json!(null) },
        "period": found.period,
    })
}

/// The models and gains for other programs.
fn export(model: &InProcess, args: &Arguments, inputs: &Inputs, sweep: Option<&Sweep>, designs: &[(Linearized, Lqr)]) -> Workspace {
    let layout = &model.equations().layout;
    let mut workspace = Workspace { source: source_name(&args.rig.file), items: Vec::new() };
    let models: Vec<&Linearized> = designs.iter().map(|d| &d.0).collect();
    add_models(&mut workspace, &models, inputs, sweep);
    workspace.items.push(("K", Item::Pages(designs.iter().map(|d| d.1.k.clone()).collect())));
    workspace.items.push(("P", Item::Pages(designs.iter().map(|d| d.1.p.clone()).collect())));
    if let Some((_, first)) = designs.first() {
        if first.integrals > 0 {
            workspace.items.push(("L", Item::Pages(designs.iter().map(|d| d.1.anti_windup.clone()).collect())));
        }
        if let Some(period) = first.period {
            workspace.items.push(("Ts", Workspace::column(&[period])));
        }
        workspace.items.push(("states_K", Item::Names(first.states.clone())));
    }
    let states: Vec<&str> = layout.x().map(|v| v.name.as_str()).collect();
    let outputs: Vec<&str> = layout.outputs.iter().map(|o| o.name.as_str()).collect();
    add_names(&mut workspace, &states, &inputs.names, &outputs);
    workspace
}

/// The regulators as code.
fn schedule(
    loaded: &Loaded,
    model: &InProcess,
    args: &Arguments,
    inputs: &Inputs,
    sweep: Option<&Sweep>,
    designs: &[(Linearized, Lqr)],
) -> Result<Schedule, Failure> {
    let equations = model.equations();
    let layout = &equations.layout;
    let Some((_, first)) = designs.first() else {
        return Err(Failure::new("C0106", "nothing to write: the sweep has no points"));
    };
    if let Some(sweep) = sweep.filter(|s| s.values.len() < 2 || s.values.windows(2).any(|w| w[1] <= w[0])) {
        return Err(Failure::new(
            "C0106",
            format!("the sweep over {} needs two points or more, from the smaller to the larger value", sweep.name),
        )
        .with_help("gains are interpolated between its points: `--sweep theta=-10deg:10deg:5`"));
    }
    let variable = sweep.map(|sweep| {
        let of_state = sweep.direction.states.first().and_then(|&(i, _)| layout.x().nth(i).map(|v| v.unit.clone()));
        let unit = of_state.or_else(|| sweep.direction.signals.first().map(|&(i, _)| layout.u[i].unit.clone()));
        (sweep.name.clone(), unit.unwrap_or_default())
    });
    let place: Vec<Option<usize>> = first.states.iter().map(|s| layout.x().position(|v| v.name == *s)).collect();
    let stem = args.rig.file.file_stem().map_or_else(|| "rig".to_owned(), |s| s.to_string_lossy().into_owned());
    let hash = equations.hash.get(..8).unwrap_or(&equations.hash).to_owned();
    Ok(Schedule {
        name: format!("{stem}_{}", if sweep.is_some() { "schedule" } else { "regulator" }),
        title: format!("{} for {}", if sweep.is_some() { "Scheduled regulator" } else { "Regulator" }, loaded.rig.name),
        source: (source_name(&args.rig.file), hash),
        variable,
        grid: sweep.map_or_else(|| vec![0.0], |s| s.values.clone()),
        period: first.period,
        states: first.states.clone(),
        inputs: first.inputs.clone(),
        signals: (0..layout.inputs)
            .map(|i| Signal {
                name: layout.u[i].name.clone(),
                unit: layout.u[i].unit.clone(),
                limits: model.input_path(i, &layout.nominal).limits,
            })
            .collect(),
        directions: rows(&inputs.directions.rows(0, layout.inputs).into_owned()),
        k: designs.iter().map(|d| rows(&d.1.k)).collect(),
        // integrals are zero where the rig is to be
        x: designs.iter().map(|d| place.iter().map(|i| i.map_or(0.0, |i| d.0.found.trim.x[i])).collect()).collect(),
        u: designs.iter().map(|d| d.0.found.trim.u[..layout.inputs].to_vec()).collect(),
    })
}

fn failure(error: &LqrError, point: &crate::args::Point, swept: bool) -> Failure {
    let at = point.at.last().filter(|_| swept).map_or_else(String::new, |at| format!(" (at {at})"));
    let failure = Failure::new("C0306", format!("{error}{at}"));
    match error {
        LqrError::Riccati { .. } => {
            failure.with_help("leave states out that no input reaches (--states), weigh what has to be seen, or add an input")
        }
        LqrError::Name(NameError::Unknown { name, known, .. }) => match model_dsl::nearest(name, known.iter().map(String::as_str)) {
            Some(near) => failure.with_help(&format!("did you mean `{near}`?")),
            None => failure.with_help("names are those of `rig linearize`: `eps`, `eps.dot`, `f_s`"),
        },
        LqrError::Name(_) => failure.with_help("name each of them once"),
        LqrError::Weight(_) => {
            failure.with_help("--weights-x takes one number for each state (then each integral), --weights-u one for each input")
        }
        LqrError::Empty => failure.with_help("declare an input, or name some with --inputs"),
        LqrError::Sampling(_) => failure.with_help("--discrete takes the sampling period: `0.005`, `5ms`"),
        LqrError::NoConvergence(_) => failure,
    }
}
