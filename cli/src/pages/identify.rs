//! The page of `rig identify`: how the model follows each record before and after, what is left, and what is known of the parameters.

use super::{bracketed, brief, cell, percent, short, shown, times};
use crate::output::number;
use ident::compare::{CompareOptions, Comparison, compare};
use ident::fit::{Estimate, RecordFigures};
use ident::record::Record;
use nalgebra::DMatrix;
use report::{Axis, Block, Cell, Ink, Page, Plot, Series, Table, Tone};
use runtime::Model;
use sim::{Hold, Status};
use std::path::Path;

/// What was identified.
pub struct Identified<'a> {
    /// Name of the rig.
    pub rig: &'a str,
    /// How, in words.
    pub facts: Vec<(String, String)>,
    /// What to look at.
    pub warnings: Vec<String>,
    /// Parameters.
    pub parameters: &'a [Estimate],
    /// Their correlation, where it is known.
    pub correlation: Option<&'a DMatrix<f64>>,
    /// Figures over training records, before and after.
    pub train: (&'a [RecordFigures], &'a [RecordFigures]),
    /// Figures over records held out.
    pub test: (&'a [RecordFigures], &'a [RecordFigures]),
    /// Runs over training records, then over those held out.
    pub runs: Vec<Laid>,
}

/// Runs before and after, laid over one record.
pub struct Laid {
    /// Name of the record.
    pub record: String,
    /// It was held out.
    pub held_out: bool,
    /// Times [s].
    pub t: Vec<f64>,
    /// Units of the outputs that were measured.
    pub units: Vec<String>,
    /// With the starting values; `None` where there is no such run.
    pub before: Option<Comparison>,
    /// With the estimates.
    pub after: Comparison,
}

/// Lays runs over a record; `None` where there is none. `initial` are states that are known.
pub fn lay(
    model: &dyn Model,
    (before, after): (&[f64], &[f64]),
    record: &Record,
    initial: &[(usize, f64)],
    hold: Hold,
    held_out: bool,
) -> Option<Laid> {
    let options = |initial: &[(usize, f64)]| CompareOptions { hold, initial: initial.to_vec(), ..CompareOptions::default() };
    let run = compare(model, after, record, &options(initial)).ok()?;
    let unit = |name: &str| {
        (0..model.dimensions().outputs)
            .find(|&i| model.names().output(i) == name)
            .map_or_else(String::new, |i| model.names().output_unit(i).to_owned())
    };
    Some(Laid {
        record: record.source.clone(),
        held_out,
        t: record.t.clone(),
        units: run.signals.iter().map(|s| unit(&s.name)).collect(),
        before: compare(model, before, record, &options(&[])).ok(),
        after: run,
    })
}

/// The page.
pub fn page(found: &Identified<'_>, source: &Path, records: &[&Path], time: Option<String>) -> Page {
    let mut blocks = vec![Block::Facts(found.facts.clone())];
    blocks.extend(found.warnings.iter().map(|w| Block::Callout {
        tone: Tone::Warning,
        word: "Look at this:".to_owned(),
        sentence: w.clone(),
    }));
    blocks.push(Block::Heading("How the model follows the records".to_owned()));
    blocks.push(Block::Table(figures(found)));
    blocks.push(Block::Heading("Parameters".to_owned()));
    blocks.push(Block::Table(parameters(found.parameters)));
    blocks.push(Block::Text("Dot: estimate; bar: 95 % interval; upright stroke: starting value. Each row has its own scale.".to_owned()));
    if let Some(correlation) = found.correlation {
        blocks.extend(pairs(found.parameters, correlation));
    }
    for laid in &found.runs {
        blocks.push(Block::Heading(format!("{} ({})", short(&laid.record), if laid.held_out { "held out" } else { "training" })));
        let figures = found.train.1.iter().chain(found.test.1).find(|f| f.record == laid.record);
        blocks.extend(over(laid, figures.and_then(|f| f.horizon)));
    }
    let mut files = vec![source];
    files.extend(records);
    Page {
        mark: super::mark(source, "identify"),
        title: format!("{}: identification", found.rig),
        subtitle: String::new(),
        blocks,
        provenance: super::provenance(&files),
        time,
    }
}

fn figures(found: &Identified<'_>) -> Table {
    let mut rows = Vec::new();
    for (role, (before, after)) in [("training", &found.train), ("held out", &found.test)] {
        for (k, figures) in after.iter().enumerate() {
            let units = found.runs.iter().find(|l| l.record == figures.record);
            for s in &figures.signals {
                let was = before.get(k).and_then(|b| b.signals.iter().find(|b| b.signal == s.signal));
                let unit = units.and_then(|l| l.after.signals.iter().position(|a| a.name == s.signal).map(|i| l.units[i].as_str()));
                let (factor, unit) = shown(unit.unwrap_or(""));
                let note = match (figures.horizon, figures.status == Status::Completed) {
                    (Some(h), _) => format!("predicted {} s ahead", number(h)),
                    (None, true) => "free run".to_owned(),
                    (None, false) => format!("free run up to {} s: {}", number(figures.valid_until), figures.status),
                };
                rows.push(vec![
                    Cell::Text(short(&figures.record)),
                    Cell::Text(role.to_owned()),
                    Cell::Text(s.signal.clone()),
                    was.map_or_else(|| Cell::Number("-".to_owned()), |w| percent(w.fit_percent)),
                    percent(s.fit_percent),
                    Cell::Number(s.rmse.map_or_else(|| "-".to_owned(), |e| format!("{} {unit}", brief(e * factor)))),
                    Cell::Text(note),
                ]);
            }
        }
    }
    let head = ["record", "", "signal", "fit before", "fit after", "rms error", ""];
    Table { caption: String::new(), head: head.map(str::to_owned).to_vec(), rows }
}

fn parameters(list: &[Estimate]) -> Table {
    let rows = list
        .iter()
        .map(|e| {
            let name = e.record.as_ref().map_or_else(|| e.name.clone(), |r| format!("{} ({})", e.name, short(r)));
            let told = if e.at_bound { "at its bound" } else { "not told" };
            vec![
                Cell::Text(name),
                cell(e.value),
                Cell::Text(e.unit.clone()),
                Cell::Number(e.std_error.map_or_else(|| told.to_owned(), brief)),
                Cell::Number(e.ci95.map_or_else(|| "-".to_owned(), |(lo, hi)| format!("{} .. {}", number(lo), number(hi)))),
                cell(e.initial),
                Cell::Interval { value: e.value, ends: e.ci95, other: Some(e.initial) },
            ]
        })
        .collect();
    let head = ["parameter", "value", "unit", "std. error", "95 % interval", "started at", ""];
    Table { caption: String::new(), head: head.map(str::to_owned).to_vec(), rows }
}

/// Parameters that move together.
const TOGETHER: f64 = 0.9;

fn pairs(list: &[Estimate], correlation: &DMatrix<f64>) -> Option<Block> {
    let mut rows: Vec<(f64, Vec<Cell>)> = Vec::new();
    for i in 0..list.len().min(correlation.nrows()) {
        for j in 0..i {
            let r = correlation[(i, j)];
            if r.abs() > TOGETHER {
                let text = format!("{r:.3}");
                rows.push((
                    r.abs(),
                    vec![Cell::Text(list[j].name.clone()), Cell::Text(list[i].name.clone()), Cell::Bar { share: r.abs(), text }],
                ));
            }
        }
    }
    rows.sort_by(|a, b| b.0.total_cmp(&a.0));
    let table = Table {
        caption: "Parameters whose errors go together (correlation beyond 0.9): the records tell a combination better than each."
            .to_owned(),
        head: ["", "and", "correlation"].map(str::to_owned).to_vec(),
        rows: rows.into_iter().map(|r| r.1).collect(),
    };
    (!table.rows.is_empty()).then_some(Block::Table(table))
}

/// Plots of one record.
fn over(laid: &Laid, horizon: Option<f64>) -> Vec<Block> {
    let mut blocks = Vec::new();
    if laid.after.status != Status::Completed {
        let sentence = format!("the free run ends early: {}", laid.after.status);
        blocks.push(Block::Callout { tone: Tone::Warning, word: "Look at this:".to_owned(), sentence });
    }
    if let Some(before) = laid.before.as_ref().filter(|b| b.status != Status::Completed) {
        blocks.push(Block::Text(format!("With the starting values the free run ends early: {}.", before.status)));
    }
    if let Some(h) = horizon {
        let text = format!(
            "The figures of this record are those of predictions {} s ahead, since its free run, shown here, says little: it amplifies every error of its initial state.",
            number(h)
        );
        blocks.push(Block::Text(text));
    }
    let mut plots = Vec::new();
    for (i, signal) in laid.after.signals.iter().enumerate() {
        let (factor, unit) = shown(&laid.units[i]);
        let label = format!("{}{}", signal.name, bracketed(&unit));
        plots.push(overlay(
            &signal.name,
            &label,
            factor,
            &laid.t,
            &signal.measured,
            laid.before.as_ref().and_then(|b| b.signals.get(i)).map(|s| s.simulated.as_slice()),
            &signal.simulated,
        ));
        plots.extend(left_over(&signal.name, &unit, &laid.t, &times(&signal.measured, factor), &times(&signal.simulated, factor)));
    }
    blocks.push(Block::Plots(plots));
    blocks
}

/// Measured, before and after.
pub fn overlay(title: &str, label: &str, factor: f64, t: &[f64], measured: &[f64], before: Option<&[f64]>, after: &[f64]) -> Plot {
    let mut series = vec![Series::line("measured", Ink::Measured, t, &times(measured, factor))];
    if let Some(before) = before {
        series.push(Series::line("before", Ink::Before, &t[..before.len().min(t.len())], &times(before, factor)));
    }
    series.push(Series::line("after", Ink::Model, &t[..after.len().min(t.len())], &times(after, factor)));
    Plot { series, wide: true, ..Plot::new(title, "t [s]", label) }
}

/// Lags of an autocorrelation that are drawn.
const LAGS: usize = 60;

/// The errors over time, and their autocorrelation with the bounds that white ones keep to.
fn left_over(name: &str, unit: &str, t: &[f64], measured: &[f64], simulated: &[f64]) -> Vec<Plot> {
    let errors: Vec<f64> = measured.iter().zip(simulated).map(|(m, s)| m - s).collect();
    let over_time = Plot {
        series: vec![Series::line("", Ink::Model, &t[..errors.len().min(t.len())], &errors)],
        levels: vec![0.0],
        ..Plot::new(format!("{name}: measured less simulated"), "t [s]", format!("error{}", bracketed(unit)))
    };
    let lags = LAGS.min(errors.len() / 4);
    let Some(correlation) = autocorrelation(&errors, lags) else { return vec![over_time] };
    let bound = 1.96 / (errors.len() as f64).sqrt();
    let x: Vec<f64> = (0..=lags).map(|l| l as f64).collect();
    let together = Plot {
        series: vec![Series::line("", Ink::Model, &x, &correlation).drawn(report::Shape::Stems)],
        levels: vec![bound, -bound],
        y: Axis::new("autocorrelation"),
        note: Some("Dashed: where white errors stay 95 % of the time.".to_owned()),
        ..Plot::new(format!("{name}: how the errors hang together"), "lag [samples]", "")
    };
    vec![over_time, together]
}

/// At lags of 0, 1, ..; `None` where the errors vanish or are too few.
fn autocorrelation(errors: &[f64], lags: usize) -> Option<Vec<f64>> {
    let mean = errors.iter().sum::<f64>() / errors.len().max(1) as f64;
    let centred: Vec<f64> = errors.iter().map(|e| e - mean).collect();
    let power: f64 = centred.iter().map(|e| e * e).sum();
    (lags > 0 && power > 0.0 && power.is_finite())
        .then(|| (0..=lags).map(|l| centred.iter().zip(&centred[l..]).map(|(a, b)| a * b).sum::<f64>() / power).collect())
}
