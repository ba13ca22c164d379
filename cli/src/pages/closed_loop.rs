//! The page of `rig closed-loop`: references over signals, errors, inputs with their limits.

use super::runs::{Traced, by_unit};
use super::{bracketed, cell, times};
use crate::output::prime;
use crate::scenario::{Built, Machine};
use control::{Bench, Run, Status};
use report::{Block, Cell, Ink, Page, Plot, Series, Shape, Table, Tone};
use runtime::Model;
use std::path::Path;

/// What is shown.
pub struct Closed<'a> {
    /// Title.
    pub title: &'a str,
    /// The rig.
    pub plant: &'a Machine,
    /// Its controller.
    pub built: &'a Built<'a>,
    /// The run.
    pub run: &'a Run,
    /// How it was run.
    pub bench: &'a Bench,
    /// Time from which errors count a second time [s].
    pub settled: Option<f64>,
    /// How it ended, in words.
    pub ending: &'a str,
}

/// The page.
pub fn page(shown: &Closed<'_>, source: &Path) -> Page {
    let &Closed { title, plant, built, run, bench, settled, ending } = shown;
    let layout = plant.layout();
    let mut blocks = Vec::new();
    if run.status != Status::Complete {
        blocks.push(Block::Callout { tone: Tone::Bad, word: "Not to its end:".to_owned(), sentence: ending.to_owned() });
    }
    blocks.push(Block::Heading("Errors against the references".to_owned()));
    blocks.push(errors(plant, run, settled));
    let mut plots = Vec::new();
    let mut others = Vec::new();
    for (i, output) in layout.outputs.iter().enumerate() {
        let (factor, unit) = super::shown(&output.unit);
        let column = |rows: &[Vec<f64>]| rows.iter().map(|r| r[i]).collect::<Vec<f64>>();
        let reference: Vec<f64> = run.references.iter().map(|r| r[i].map_or(f64::NAN, |r| r.0)).collect();
        let truth = column(&run.y);
        if reference.iter().all(|r| r.is_nan()) {
            others.push(Traced { name: output.name.clone(), unit: output.unit.clone(), values: truth });
            continue;
        }
        let label = format!("{}{}", output.name, bracketed(&unit));
        let mut series = Vec::new();
        if bench.encoders {
            series.push(Series::line("as read", Ink::Measured, &run.t, &times(&column(&run.read), factor)));
        }
        series.push(Series::line("true", Ink::Model, &run.t, &times(&truth, factor)));
        series.push(Series::line("reference", Ink::Reference, &run.t, &times(&reference, factor)).drawn(Shape::Dashed));
        plots.push(Plot { series, wide: true, ..Plot::new(output.name.clone(), "t [s]", label) });
        let error: Vec<f64> = truth.iter().zip(&reference).map(|(y, r)| factor * (y - r)).collect();
        plots.push(Plot {
            series: vec![Series::line("", Ink::Model, &run.t, &error)],
            levels: vec![0.0],
            ..Plot::new(format!("{}: error", output.name), "t [s]", format!("error{}", bracketed(&unit)))
        });
    }
    if !plots.is_empty() {
        blocks.push(Block::Heading("Signals and their references".to_owned()));
        blocks.push(Block::Plots(plots));
    }
    let free = by_unit(&run.t, &others, &Shape::Line);
    if !free.is_empty() {
        blocks.push(Block::Heading("Outputs without reference".to_owned()));
        blocks.push(Block::Plots(free));
    }
    blocks.push(Block::Heading("Inputs".to_owned()));
    blocks.push(Block::Plots(inputs(plant, run, bench)));
    blocks.push(Block::Heading("Regulator".to_owned()));
    let columns: Vec<String> = built.gain.states.iter().map(|s| prime(s)).collect();
    let rows: Vec<(String, Vec<f64>)> =
        built.gain.inputs.iter().cloned().zip(built.gain.k.row_iter().map(|r| r.iter().copied().collect())).collect();
    blocks.push(super::matrix("K of u = u* - K (x - x*)", &columns, &rows));
    Page {
        mark: super::mark(source, "closed-loop"),
        title: title.to_owned(),
        subtitle: ending.to_owned(),
        blocks,
        provenance: super::provenance(&[source]),
        time: None,
    }
}

fn errors(plant: &Machine, run: &Run, settled: Option<f64>) -> Block {
    let mut rows = Vec::new();
    for (i, output) in plant.layout().outputs.iter().enumerate() {
        let (factor, unit) = super::shown(&output.unit);
        let Some((mean, rms)) = run.errors(i, 0.0) else { continue };
        let mut row = vec![Cell::Text(output.name.clone()), cell(mean * factor), cell(rms * factor)];
        if let Some(from) = settled {
            match run.errors(i, from) {
                Some((mean, rms)) => row.extend([cell(mean * factor), cell(rms * factor)]),
                None => row.extend(["-", "-"].map(|t| Cell::Number(t.to_owned()))),
            }
        }
        row.push(Cell::Text(unit));
        rows.push(row);
    }
    if rows.is_empty() {
        return Block::Text("No output has a reference.".to_owned());
    }
    let mut head = vec!["output".to_owned(), "mean |e|".to_owned(), "rms".to_owned()];
    if let Some(from) = settled {
        let from = crate::output::number(from);
        head.extend([format!("mean |e| from {from} s"), format!("rms from {from} s")]);
    }
    head.push(String::new());
    Block::Table(Table { caption: String::new(), head, rows })
}

/// Each input with its limits and how long it stood at them.
fn inputs(plant: &Machine, run: &Run, bench: &Bench) -> Vec<Plot> {
    let layout = plant.layout();
    (0..layout.inputs)
        .map(|i| {
            let variable = &layout.u[i];
            let (factor, unit) = super::shown(&variable.unit);
            let values: Vec<f64> = run.u.iter().map(|u| factor * u[i]).collect();
            let (lo, hi) = plant.model.input_path(i, plant.p()).limits;
            let levels: Vec<f64> = [lo, hi].into_iter().filter(|l| bench.limits && l.is_finite()).map(|l| l * factor).collect();
            let share = run.saturated_percent.get(i).copied().unwrap_or(0.0);
            let note = (!levels.is_empty()).then(|| format!("Dashed: its limits; at one of them in {share:.1} % of the samples."));
            Plot {
                series: vec![Series::line("", Ink::Model, &run.t, &values).drawn(Shape::Steps)],
                levels,
                note,
                ..Plot::new(variable.name.clone(), "t [s]", format!("{}{}", variable.name, bracketed(&unit)))
            }
        })
        .collect()
}
