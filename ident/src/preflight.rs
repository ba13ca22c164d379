//! A look at records before anything is fitted to them: facts of each channel, and faults of wiring and export.
//!
//! Facts come from the record alone ([`timing`], [`channels`], [`quantum`]); faults mostly from the model, which judges the
//! record as it is and after every change that is a usual mistake ([`suspects`], [`judge`]). Knows models through
//! [`runtime::Model`] only; says nothing to anybody, the program words it.

mod change;
mod channels;
mod delay;
mod fault;
mod judge;
mod quantum;
mod suspects;
mod timing;

pub use change::Change;
pub use channels::{InputFacts, OutputFacts};
pub use delay::Delay;
pub use fault::{Fault, FaultKind};
pub use quantum::quantum;
pub use suspects::Suspect;
pub use timing::{Gap, Timing};

use crate::compare::is_angle;
use crate::compare::series::unwrap;
use crate::fit::{Data, FitError, ParameterSpec, measured_coordinates};
use crate::record::{MatchError, Record, bind};
use judge::Judge;
use runtime::Model;
use sim::Hold;
use std::f64::consts::PI;

/// What was found.
#[derive(Clone, Debug)]
pub struct Preflight {
    /// One entry for each record.
    pub records: Vec<Facts>,
    /// Faults of all records; empty for clean ones.
    pub faults: Vec<Fault>,
}

/// Facts of one record.
#[derive(Clone, Debug)]
pub struct Facts {
    /// Record.
    pub source: String,
    /// Time stamps.
    pub timing: Timing,
    /// Measured outputs.
    pub outputs: Vec<OutputFacts>,
    /// Inputs.
    pub inputs: Vec<InputFacts>,
    /// Outputs of the model that the record does not have.
    pub missing: Vec<String>,
    /// Columns that the model has no use for.
    pub unused: Vec<String>,
    /// Delays from inputs to the motion.
    pub delays: Vec<Delay>,
    /// For each coordinate the part of its accelerations that the model leaves unexplained after a quick fit (ratio of
    /// amplitudes), without any change; empty where the model could not judge.
    pub unexplained: Vec<(String, f64)>,
    /// Signs and exchanges that this record cannot tell from the record as it is.
    pub untold: Vec<Change>,
    /// Why the model could not judge the record.
    pub not_judged: Option<String>,
}

/// Where an axis can go: name of the coordinate, from, to (SI).
pub type Range = (String, (f64, f64));

/// Inspects records of a model. `specs` say which parameters are not known well (the others are trusted), `ranges` how far
/// axes can go, where that is known.
///
/// # Errors
/// [`MatchError`] where a record does not fit the model's names.
pub fn inspect(
    model: &dyn Model,
    specs: &[ParameterSpec],
    ranges: &[Range],
    records: &[Record],
    hold: Hold,
) -> Result<Preflight, MatchError> {
    let mut found = Preflight { records: Vec::new(), faults: Vec::new() };
    for record in records {
        let (facts, kinds) = one(model, specs, ranges, record, hold)?;
        found.faults.extend(kinds.into_iter().map(|kind| Fault { record: record.source.clone(), kind }));
        found.records.push(facts);
    }
    Ok(found)
}

fn one(
    model: &dyn Model,
    specs: &[ParameterSpec],
    ranges: &[Range],
    record: &Record,
    hold: Hold,
) -> Result<(Facts, Vec<FaultKind>), MatchError> {
    let d = model.dimensions();
    let p: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let bound = bind(record, model, hold)?;
    let names = model.names();
    let mut outputs = Vec::new();
    let mut missing = Vec::new();
    for (i, values) in bound.outputs.iter().enumerate() {
        let (name, unit) = (names.output(i), names.output_unit(i));
        let Some(raw) = values else {
            missing.push(name.to_owned());
            continue;
        };
        let mut whole = raw.clone();
        if is_angle(unit) {
            unwrap(&mut whole);
        }
        outputs.push(channels::output(name, si(unit), &record.t, &whole, &whole, model.output_path(i, &p).quantum));
    }
    let inputs: Vec<InputFacts> = (0..d.signals())
        .map(|i| {
            let values: Vec<f64> = record.t.iter().map(|&t| bound.signals.at(t)[i]).collect();
            let limits = if i < d.inputs { model.input_path(i, &p).limits } else { (f64::NEG_INFINITY, f64::INFINITY) };
            let declared = record.declared.iter().any(|c| c.name == names.signal(i));
            channels::input(names.signal(i), names.signal_unit(i), &values, limits, declared)
        })
        .collect();
    let mut facts = Facts {
        source: record.source.clone(),
        timing: Timing::of(&record.t),
        outputs,
        inputs,
        missing,
        unused: bound.unused,
        delays: Vec::new(),
        unexplained: Vec::new(),
        untold: Vec::new(),
        not_judged: None,
    };
    let mut kinds = of_facts(&facts);
    match by_model(model, specs, ranges, record, hold, &mut facts) {
        Ok(suspects) => {
            // a wrong unit shows in the steps too, and a turned input beyond its limits: one fault, not two
            let explained: Vec<String> = suspects.iter().flat_map(|s| s.change.channels()).collect();
            kinds.retain(|k| match k {
                FaultKind::Quantum { output, .. } => !explained.contains(output),
                FaultKind::BeyondLimits { input, .. } => !explained.contains(input),
                _ => true,
            });
            kinds.splice(0..0, suspects.into_iter().map(FaultKind::Contradicts));
        }
        Err(e) => facts.not_judged = Some(e.to_string()),
    }
    Ok((facts, kinds))
}

/// Faults that need no model.
fn of_facts(facts: &Facts) -> Vec<FaultKind> {
    let mut kinds = Vec::new();
    if facts.timing.is_broken() {
        kinds.push(FaultKind::Gaps(facts.timing.gaps.clone()));
    }
    let moving = facts.outputs.iter().any(|o| !o.constant);
    for o in &facts.outputs {
        if o.constant && moving {
            kinds.push(FaultKind::Dead { output: o.name.clone(), value: o.first });
        }
        if let (Some(seen), Some(declared)) = (o.quantum_seen, o.quantum_declared)
            && (seen / declared - 1.0).abs() > 0.1
        {
            kinds.push(FaultKind::Quantum { output: o.name.clone(), seen, declared, unit: o.unit.clone() });
        }
    }
    for i in facts.inputs.iter().filter(|i| i.beyond > 0.0) {
        kinds.push(FaultKind::BeyondLimits {
            input: i.name.clone(),
            share: i.beyond,
            range: i.range,
            limits: i.limits,
            unit: i.unit.clone(),
        });
    }
    kinds
}

/// Faults that the model sees; fills in what it says of the record.
fn by_model(
    model: &dyn Model,
    specs: &[ParameterSpec],
    ranges: &[Range],
    record: &Record,
    hold: Hold,
    facts: &mut Facts,
) -> Result<Vec<Suspect>, FitError> {
    let moving: Vec<&OutputFacts> = facts.outputs.iter().filter(|o| !o.constant).collect();
    if record.t.len() < 60 || moving.is_empty() {
        return Err(FitError::EquationError {
            why: if moving.is_empty() { "no output moves".to_owned() } else { format!("{} samples are too few", record.t.len()) },
        });
    }
    let windows = windows(model, &facts.outputs, record);
    let shortest = windows.iter().copied().fold(f64::INFINITY, f64::min);
    // where the rig says how far an axis goes, a wrong zero must leave it there
    let room = |o: &OutputFacts| -> (f64, f64) {
        ranges.iter().find(|(name, _)| *name == o.name).map_or((-QUARTER, QUARTER), |(_, (lo, hi))| {
            let slack = 0.1 * (hi - lo);
            ((lo - slack - o.range.0).max(-QUARTER), (hi + slack - o.range.1).min(QUARTER))
        })
    };
    let names = suspects::Names {
        outputs: moving.iter().map(|o| (o.name.clone(), o.unit.clone())).collect(),
        inputs: facts.inputs.iter().filter(|i| i.range != (0.0, 0.0)).map(|i| (i.name.clone(), i.unit.clone())).collect(),
        from_zero: moving
            .iter()
            .filter(|o| o.unit == "rad" && o.range.1 - o.range.0 < 2.0 * PI)
            .filter(|o| o.first.abs() <= 2.0 * o.quantum_declared.or(o.quantum_seen).unwrap_or(0.0))
            .map(|o| (o.name.clone(), room(o)))
            .collect(),
        half_turns: moving
            .iter()
            .filter(|o| o.unit == "rad" && ranges.iter().all(|(name, (lo, hi))| *name != o.name || hi - lo > PI))
            .map(|o| o.name.clone())
            .collect(),
        parameters: specs.iter().filter(|s| s.value != 0.0).map(|s| s.name.clone()).collect(),
    };
    let judge = Judge { model, specs, hold, windows };
    let verdict = suspects::search(&judge, record, &names)?;
    facts.unexplained = verdict.as_it_is.unexplained.iter().map(|(n, e)| (n.clone(), e.sqrt())).collect();
    facts.untold = verdict.untold;
    if verdict.suspects.is_empty() {
        let p = &verdict.as_it_is.p;
        let data = Data::new(record, model, hold)?;
        let q = measured_coordinates(model, p, &data)?;
        // a rest that the model does not explain has delays of its own
        let told: Vec<usize> = (0..q.len()).filter(|&i| verdict.as_it_is.unexplained[i].1.sqrt() < delay::EXPLAINED).collect();
        facts.delays = delay::delays(model, p, &data, &q, shortest, &told);
    }
    Ok(verdict.suspects)
}

/// An encoder that is zeroed where the rig happens to rest is not further than this from its zero [rad].
const QUARTER: f64 = 0.5 * PI;

/// For each coordinate a window of about half a period of its motion, in two sizes at most.
fn windows(model: &dyn Model, outputs: &[OutputFacts], record: &Record) -> Vec<f64> {
    let duration = record.duration();
    let period = duration / (record.t.len() - 1) as f64;
    let length = |o: &OutputFacts| (0.7 * duration / (o.reversals as f64 + 1.0)).min(duration / 12.0).min(3.0).max(20.0 * period);
    let moving: Vec<&OutputFacts> = outputs.iter().filter(|o| !o.constant).collect();
    let fast = moving.iter().map(|o| length(o)).fold(f64::INFINITY, f64::min);
    let slow = moving.iter().map(|o| length(o)).fold(0.0, f64::max);
    (0..model.dimensions().coordinates)
        .map(|i| match moving.iter().find(|o| o.name == model.names().state(i)) {
            Some(o) if length(o) > (fast * slow).sqrt() && slow > 2.0 * fast => slow,
            _ => fast,
        })
        .collect()
}

/// The SI unit that values of this unit are given in.
fn si(unit: &str) -> &str {
    if is_angle(unit) { "rad" } else { unit }
}
