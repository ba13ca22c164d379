//! The page of `rig simulate`: all signals of a run.

use super::{bracketed, shown, times};
use crate::output::prime;
use codegen::Layout;
use report::{Block, Ink, Page, Plot, Series, Shape, Tone};
use sim::{Signals, Status, Trajectory};
use std::path::Path;

/// Most series in one plot.
const MOST: usize = 6;

/// A signal of a run.
pub struct Traced {
    /// Name.
    pub name: String,
    /// Unit (SI).
    pub unit: String,
    /// Values (SI).
    pub values: Vec<f64>,
}

/// The page.
pub fn page(rig: &str, layout: &Layout, signals: &Signals, run: &Trajectory, source: &Path, input: &Path) -> Page {
    let mut blocks = Vec::new();
    if run.status != Status::Completed {
        blocks.push(Block::Callout { tone: Tone::Warning, word: "Ended early:".to_owned(), sentence: run.status.to_string() });
    }
    let asked: Vec<Vec<f64>> = run.t.iter().map(|t| signals.at(*t)).collect();
    let inputs: Vec<Traced> = layout
        .u
        .iter()
        .enumerate()
        .map(|(i, u)| Traced { name: u.name.clone(), unit: u.unit.clone(), values: asked.iter().map(|row| row[i]).collect() })
        .collect();
    let outputs: Vec<Traced> = layout
        .outputs
        .iter()
        .enumerate()
        .map(|(i, o)| Traced { name: o.name.clone(), unit: o.unit.clone(), values: run.output(i) })
        .collect();
    let states: Vec<Traced> = layout
        .x()
        .enumerate()
        .filter(|(_, x)| !layout.outputs.iter().any(|o| o.name == x.name))
        .map(|(i, x)| Traced { name: prime(&x.name), unit: x.unit.clone(), values: (0..run.t.len()).map(|k| run.state(k)[i]).collect() })
        .collect();
    for (title, list, shape) in [("Inputs", inputs, Shape::Steps), ("Outputs", outputs, Shape::Line), ("Other states", states, Shape::Line)]
    {
        let plots = by_unit(&run.t, &list, &shape);
        if !plots.is_empty() {
            blocks.push(Block::Heading(title.to_owned()));
            blocks.push(Block::Plots(plots));
        }
    }
    Page {
        mark: super::mark(source, "simulate"),
        title: format!("{rig}: simulation"),
        subtitle: format!("{} samples, {}", run.t.len(), run.status),
        blocks,
        provenance: super::provenance(&[source, input]),
        time: None,
    }
}

/// One wide plot for the signals of each unit, more where they are many.
pub fn by_unit(t: &[f64], list: &[Traced], shape: &Shape) -> Vec<Plot> {
    let mut units: Vec<&str> = Vec::new();
    for signal in list {
        if !units.contains(&signal.unit.as_str()) {
            units.push(&signal.unit);
        }
    }
    let mut plots = Vec::new();
    for unit in units {
        let (factor, label) = shown(unit);
        let own: Vec<&Traced> = list.iter().filter(|s| s.unit == unit).collect();
        for few in own.chunks(MOST) {
            let series = few
                .iter()
                .enumerate()
                .map(|(k, s)| Series::line(s.name.clone(), Ink::Slot(k), t, &times(&s.values, factor)).drawn(shape.clone()))
                .collect();
            plots.push(Plot { series, wide: true, ..Plot::new("", "t [s]", bracketed(&label).trim_start()) });
        }
    }
    plots
}
