//! Pages of `rig linearize` and `rig lqr`: poles, gains, what the linear loop does, and all of it over a sweep.

use super::response::{Loop, spans};
use super::{bracketed, cell, matrix, shown};
use crate::commands::linearize::Linearized;
use crate::load::Loaded;
use crate::output::{number, prime};
use crate::sweep::Sweep;
use codegen::Layout;
use control::{Lqr, Plant};
use nalgebra::Complex;
use report::{Axis, Block, Cell, Ink, Page, Plot, Series, Shape, Table, Tone};
use std::path::Path;

/// What both pages are of.
pub struct Source<'a> {
    /// The rig.
    pub loaded: &'a Loaded,
    /// Its model's names.
    pub layout: &'a Layout,
    /// Its file.
    pub file: &'a Path,
    /// Inputs of the linear models.
    pub inputs: &'a [String],
    /// The sweep, if there is one.
    pub sweep: Option<&'a Sweep>,
}

impl Source<'_> {
    fn page(&self, command: &str, what: &str, blocks: Vec<Block>) -> Page {
        let subtitle = self.sweep.map_or_else(String::new, |s| format!("{} points over {}", s.values.len(), s.name));
        Page {
            mark: super::mark(self.file, command),
            title: format!("{}: {what}", self.loaded.rig.name),
            subtitle,
            blocks,
            provenance: super::provenance(&[self.file]),
            time: None,
        }
    }

    /// Factor and unit of the swept quantity.
    fn swept(&self) -> (f64, String) {
        let Some(sweep) = self.sweep else { return (1.0, String::new()) };
        let unit = |index: Option<usize>, list: Vec<&str>| index.and_then(|i| list.get(i).map(|u| (*u).to_owned()));
        let state = unit(sweep.direction.states.first().map(|d| d.0), self.layout.x().map(|v| v.unit.as_str()).collect());
        let signal = || unit(sweep.direction.signals.first().map(|d| d.0), self.layout.u.iter().map(|v| v.unit.as_str()).collect());
        shown(&state.or_else(signal).unwrap_or_default())
    }
}

/// The page of `rig linearize`.
pub fn linearize(source: &Source<'_>, models: &[Linearized]) -> Page {
    let mut blocks = Vec::new();
    if let (None, Some(linear)) = (source.sweep, models.first()) {
        blocks.push(Block::Code(linear.found.words(source.loaded, source.layout)));
        blocks.push(Block::Heading("Poles".to_owned()));
        blocks.push(Block::Plots(vec![poles("Poles", None, &[("", Ink::Model, Shape::Crosses, &linear.model.poles)])]));
        blocks.push(Block::Heading("Linear model".to_owned()));
        let states: Vec<String> = source.layout.x().map(|v| prime(&v.name)).collect();
        let rows: Vec<(String, Vec<f64>)> = states
            .iter()
            .enumerate()
            .map(|(i, s)| (format!("{s}'"), linear.model.a.row(i).iter().chain(linear.model.b.row(i).iter()).copied().collect()))
            .collect();
        let columns: Vec<String> = states.iter().chain(source.inputs).cloned().collect();
        blocks.push(matrix("x' = A (x - x*) + B (u - u*); the columns of B are those of the inputs", &columns, &rows));
    } else {
        blocks.push(Block::Heading("Poles over the sweep".to_owned()));
        let all: Vec<&[Complex<f64>]> = models.iter().map(|m| m.model.poles.as_slice()).collect();
        blocks.extend(over(source, &all, None));
    }
    source.page("linearize", "linear model", blocks)
}

/// The page of `rig lqr`.
pub fn lqr(source: &Source<'_>, designs: &[(Linearized, Lqr)], plants: &[Plant]) -> Page {
    let mut blocks = Vec::new();
    if let (None, Some((linear, found)), Some(plant)) = (source.sweep, designs.first(), plants.first()) {
        blocks.push(Block::Code(linear.found.words(source.loaded, source.layout)));
        blocks.extend(one(source, linear, found, plant));
    } else {
        let period = designs.first().and_then(|d| d.1.period);
        blocks.push(Block::Heading("Poles of the closed loop over the sweep".to_owned()));
        let all: Vec<&[Complex<f64>]> = designs.iter().map(|d| d.1.plant_poles.as_slice()).collect();
        blocks.extend(over(source, &all, period));
        blocks.push(Block::Heading("Gains over the sweep".to_owned()));
        blocks.extend(gains(source, designs));
    }
    source.page("lqr", "linear-quadratic regulator", blocks)
}

fn column(state: &str) -> String {
    state.strip_suffix(".integral").map_or_else(|| prime(state), |name| format!("int {name}"))
}

/// A regulator at one point.
fn one(source: &Source<'_>, linear: &Linearized, found: &Lqr, plant: &Plant) -> Vec<Block> {
    let mut blocks = Vec::new();
    for c in &found.neglected {
        let sentence = format!("{}' depends on {} by {}, which the design leaves out", prime(&c.onto), prime(&c.from), number(c.value));
        blocks.push(Block::Callout { tone: Tone::Warning, word: "Neglected:".to_owned(), sentence });
    }
    blocks.push(Block::Heading("Gain".to_owned()));
    let columns: Vec<String> = found.states.iter().map(|s| column(s)).collect();
    let rows: Vec<(String, Vec<f64>)> = found.inputs.iter().cloned().zip(found.k.row_iter().map(|r| r.iter().copied().collect())).collect();
    blocks.push(matrix("K of u = u* - K (x - x*)", &columns, &rows));
    blocks.push(Block::Text(format!("Relative residual of the Riccati equation: {:.0e}.", found.residual)));

    blocks.push(Block::Heading("Poles".to_owned()));
    let open: Vec<Complex<f64>> = linear.model.poles.iter().map(|s| found.period.map_or(*s, |period| (*s * period).exp())).collect();
    let both: [Poles<'_>; 2] =
        [("without regulator", Ink::Before, Shape::Crosses, &open), ("with it", Ink::Model, Shape::Rings, &found.plant_poles)];
    let mut table = Table { caption: String::new(), head: ["", "poles"].map(str::to_owned).to_vec(), rows: Vec::new() };
    for (name, _, _, list) in &both {
        table.rows.push(vec![Cell::Text((*name).to_owned()), Cell::Text(crate::output::poles_in_words(list))]);
    }
    blocks.push(Block::Plots(vec![poles("Poles", found.period, &both)]));
    blocks.push(Block::Table(table));
    let Some(closed) = Loop::new(plant, found) else { return blocks };
    let (length, band) = spans(&found.poles, found.period);
    let steps = steps(source, found, plant, &closed, length);
    if !steps.is_empty() {
        blocks.push(Block::Heading("The linear loop after a step of a reference".to_owned()));
        blocks.push(Block::Text(
            "From the operating point, the inputs beside u*; u* itself is left as it is (no feedforward), no limit counts.".to_owned(),
        ));
        blocks.push(Block::Plots(steps));
    }
    blocks.push(Block::Heading("Loops over frequency".to_owned()));
    blocks.push(Block::Text("Each loop broken at its input, the others closed.".to_owned()));
    blocks.extend(loops(found, &closed, band));
    blocks
}

fn steps(source: &Source<'_>, found: &Lqr, plant: &Plant, closed: &Loop, length: f64) -> Vec<Plot> {
    let coordinates = &source.layout.q;
    let mut plots = Vec::new();
    for (j, q) in coordinates.iter().enumerate().filter(|(_, q)| found.states.contains(&q.name)) {
        let (factor, unit) = shown(&q.unit);
        let Some(step) = closed.step(j, 1.0 / factor, length) else { continue };
        let mut moved = Vec::new();
        for (i, other) in coordinates.iter().enumerate().filter(|(_, other)| other.unit == q.unit && plant.states.contains(&other.name)) {
            let values: Vec<f64> = step.x.iter().map(|x| factor * x[i]).collect();
            moved.push(Series::line(other.name.clone(), Ink::Slot(i), &step.t, &values));
        }
        plots.push(Plot {
            series: moved,
            levels: vec![1.0],
            ..Plot::new(format!("{} by 1 {unit}", q.name), "t [s]", bracketed(&unit).trim_start())
        });
        let inputs = found
            .inputs
            .iter()
            .enumerate()
            .map(|(i, name)| {
                let values: Vec<f64> = step.u.iter().map(|u| u[i]).collect();
                let shape = if found.period.is_some() { Shape::Steps } else { Shape::Line };
                Series::line(name.clone(), Ink::Slot(i), &step.t, &values).drawn(shape)
            })
            .collect();
        plots.push(Plot { series: inputs, ..Plot::new(format!("{} by 1 {unit}: inputs", q.name), "t [s]", "u - u* (SI)") });
    }
    plots
}

fn loops(found: &Lqr, closed: &Loop, band: (f64, f64)) -> Vec<Block> {
    let mut table = Table {
        caption: String::new(),
        head: ["loop", "gain 1 at [rad/s]", "phase margin [deg]", "least distance to -1"].map(str::to_owned).to_vec(),
        rows: Vec::new(),
    };
    let (mut gain, mut phase) = (Vec::new(), Vec::new());
    for (i, name) in found.inputs.iter().enumerate() {
        let broken = closed.broken(i, band);
        gain.push(Series::line(name.clone(), Ink::Slot(i), &broken.w, &broken.gain));
        phase.push(Series::line(name.clone(), Ink::Slot(i), &broken.w, &broken.phase));
        let none = || Cell::Number("-".to_owned());
        table.rows.push(vec![
            Cell::Text(name.clone()),
            broken.margin.map_or_else(none, |m| Cell::Number(format!("{:.3}", m.0))),
            broken.margin.map_or_else(none, |m| Cell::Number(format!("{:.1}", m.1))),
            if broken.distance.is_finite() { Cell::Number(format!("{:.3}", broken.distance)) } else { none() },
        ]);
    }
    let frequency = Axis { label: "frequency [rad/s]".to_owned(), log: true, range: None };
    let plots = vec![
        Plot {
            series: gain,
            levels: vec![1.0],
            x: frequency.clone(),
            y: Axis { label: "|L|".to_owned(), log: true, range: None },
            ..Plot::new("Gain", "", "")
        },
        Plot { series: phase, levels: vec![-180.0], x: frequency, ..Plot::new("Phase", "", "phase [deg]") },
    ];
    vec![Block::Plots(plots), Block::Table(table)]
}

type Poles<'a> = (&'a str, Ink, Shape, &'a [Complex<f64>]);

/// Poles in the complex plane.
fn poles(title: &str, period: Option<f64>, sets: &[Poles<'_>]) -> Plot {
    let series = sets
        .iter()
        .map(|(name, ink, shape, poles)| {
            let (x, y): (Vec<f64>, Vec<f64>) = poles.iter().map(|z| (z.re, z.im)).unzip();
            Series::line(*name, *ink, &x, &y).drawn(shape.clone())
        })
        .collect();
    let (x, y) = if period.is_some() { ("Re z", "Im z") } else { ("Re s [1/s]", "Im s [1/s]") };
    Plot { series, equal: true, circle: period.is_some(), levels: vec![0.0], ..Plot::new(title, x, y) }
}

/// Poles over a sweep: in the plane from its first to its last point, and their real parts.
fn over(source: &Source<'_>, all: &[&[Complex<f64>]], period: Option<f64>) -> Vec<Block> {
    let Some(sweep) = source.sweep else { return Vec::new() };
    let (factor, unit) = source.swept();
    let at = |k: usize| format!("{} = {} {unit}", sweep.name, number(factor * sweep.values.get(k).copied().unwrap_or(f64::NAN)));
    let between: Vec<Complex<f64>> = all.iter().skip(1).take(all.len().saturating_sub(2)).flat_map(|p| p.iter().copied()).collect();
    let (first, last) = (at(0), at(all.len().saturating_sub(1)));
    let (none, mut sets) = (Vec::new(), Vec::new());
    if !between.is_empty() {
        sets.push(("between", Ink::Measured, Shape::Dots, between.as_slice()));
    }
    sets.push((first.as_str(), Ink::Before, Shape::Crosses, all.first().copied().unwrap_or(&none)));
    if all.len() > 1 {
        sets.push((last.as_str(), Ink::Model, Shape::Rings, all.last().copied().unwrap_or(&none)));
    }
    let label = format!("{}{}", sweep.name, bracketed(&unit));
    let (mut x, mut y) = (Vec::new(), Vec::new());
    for (value, poles) in sweep.values.iter().zip(all) {
        for z in *poles {
            x.push(factor * value);
            y.push(if period.is_some() { z.norm() } else { z.re });
        }
    }
    let (name, bound) = if period.is_some() { ("|z|", 1.0) } else { ("Re s [1/s]", 0.0) };
    let stable = Plot {
        series: vec![Series::line("", Ink::Model, &x, &y).drawn(Shape::Dots)],
        levels: vec![bound],
        note: Some("Dashed: the border of stability.".to_owned()),
        ..Plot::new("Over the sweep", label.clone(), name)
    };
    let table = Table {
        caption: String::new(),
        head: vec![label, if period.is_some() { "poles (of z)" } else { "poles" }.to_owned()],
        rows: sweep.values.iter().zip(all).map(|(v, p)| vec![cell(v * factor), Cell::Text(crate::output::poles_in_words(p))]).collect(),
    };
    vec![Block::Plots(vec![poles("In the complex plane", period, &sets), stable]), Block::Table(table)]
}

/// Each row of K over the sweep.
fn gains(source: &Source<'_>, designs: &[(Linearized, Lqr)]) -> Vec<Block> {
    let (Some(sweep), Some((_, first))) = (source.sweep, designs.first()) else { return Vec::new() };
    let (factor, unit) = source.swept();
    let values: Vec<f64> = sweep.values.iter().map(|v| v * factor).collect();
    let label = format!("{}{}", sweep.name, bracketed(&unit));
    let mut plots = Vec::new();
    let mut blocks = Vec::new();
    for (i, input) in first.inputs.iter().enumerate() {
        let series = first.states.iter().enumerate().map(|(j, state)| {
            let gain: Vec<f64> = designs.iter().map(|d| d.1.k[(i, j)]).collect();
            Series::line(column(state), Ink::Slot(j), &values, &gain)
        });
        plots.push(Plot { series: series.collect(), ..Plot::new(format!("K, row {input}"), label.clone(), "gain (SI)") });
        let mut head = vec![label.clone()];
        head.extend(first.states.iter().map(|s| column(s)));
        let rows = values
            .iter()
            .zip(designs)
            .map(|(v, d)| std::iter::once(cell(*v)).chain(d.1.k.row(i).iter().map(|k| cell(*k))).collect())
            .collect();
        blocks.push(Block::Table(Table { caption: format!("K, row {input}"), head, rows }));
    }
    blocks.insert(0, Block::Plots(plots));
    blocks
}
