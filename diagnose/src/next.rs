//! The next experiment: the input, among steps, slow and fast sweeps within what the rig allows, whose record would tell most.
//!
//! Each is simulated with the effect in the model, without noise, and the rivals are fitted to that record: by how much the likelihood of
//! the best of them stays behind is the evidence that such a record would bring. The filter's noise says how much chance there is in it.

use crate::chance::{Chance, below};
use crate::effects::{Effect, Signature};
use crate::model::{Included, Prepared, prepare};
use crate::search::{Question, SEPARATES, State, carry};
use ident::fit::ParameterSpec;
use ident::innovations::{EstimateOptions, Track, estimate, pass};
use ident::record::{Column, Record, Start};
use runtime::Model as _;
use sim::{Signal, Signals, Status, simulate};
use std::f64::consts::TAU;

/// How far beyond what was seen a coordinate without a range may go, in parts of what was seen.
const BEYOND: f64 = 0.5;
/// Most samples of a proposed record.
const SAMPLES: usize = 2000;

/// What is to be told, from what.
pub(crate) struct Open<'a> {
    /// The model with the effect.
    pub with: &'a State,
    /// Its number among the accepted ones of that model.
    pub effect: usize,
    /// What it is to be told from; none: that it is there at all.
    pub rivals: Vec<&'a Effect>,
}

struct Design {
    words: String,
    input: usize,
    values: Vec<f64>,
}

/// Words for the best experiment, or for why there is none; `None` where the question cannot be put (no record, a model that is not derived).
pub(crate) fn propose(ask: &Question<'_>, open: &Open<'_>, tracks: &[Track]) -> Option<String> {
    let first = tracks.first()?;
    let p = open.with.fitted.mean();
    let mut plain: Vec<Included> = open.with.accepted.clone();
    let own = plain.remove(open.effect);
    // without it, and with each rival in its place
    let rivals: Vec<&Effect> = open.rivals.iter().copied().filter(|e| !e.by_record).collect();
    let mut others = Vec::new();
    for rival in &rivals {
        let mut included = plain.clone();
        // delays and lags begin where this one is, everything else at nothing
        let timing = matches!(rival.signature, Signature::InputDelay(_) | Signature::OutputDelay(_));
        let size: Vec<f64> = if timing { own_values(open, &p).into_iter().take(1).map(f64::abs).collect() } else { Vec::new() };
        included.push(Included { effect: (*rival).clone(), start: rival.with(&size), held: Vec::new() });
        others.push(prepare(ask.base, &open.with.fitted.asked, &included, included.len()).ok()?);
    }
    if others.is_empty() {
        others.push(prepare(ask.base, &open.with.fitted.asked, &plain, plain.len()).ok()?);
    }
    let ground = ground(open.with, tracks)?;
    let mut best: Option<(f64, String)> = None;
    let mut tried = 0;
    for design in designs(open.with, &p, first, &ground.t) {
        let Some(record) = simulated(&open.with.prepared, &p, &ground, &design, first) else { continue };
        let Some(with) = likeliest(open.with, &open.with.prepared, &p, &record, ask, false) else { continue };
        tried += 1;
        let behind = |prepared: &Prepared| {
            let from = carry(&open.with.prepared, &p, prepared);
            likeliest(open.with, prepared, &from, &record, ask, true).map_or(0.0, |other| with - other)
        };
        let evidence = others.iter().map(behind).fold(f64::INFINITY, f64::min);
        if best.as_ref().is_none_or(|b| evidence > b.0) {
            best = Some((evidence, design.words));
        }
    }
    let what = format!("{} on {}", own.effect.id, own.effect.place);
    let names: Vec<String> = rivals.iter().map(|e| format!("{} on {}", e.id, e.place)).collect();
    let purpose =
        if names.is_empty() { format!("show {what} as it was found") } else { format!("tell {what} from {}", names.join(" and ")) };
    if tried == 0 {
        return Some(format!(
            "none of the inputs that were tried keeps the model within what was seen or the range that the rig gives: to {purpose}, use a regulator \
             and move its reference"
        ));
    }
    let (evidence, words) = best?;
    // the difference of log-likelihoods has the variance of twice its mean
    let chance = if evidence > 0.0 { below((evidence - SEPARATES) / (2.0 * evidence).sqrt()) } else { 0.0 };
    Some(if chance < 0.05 {
        format!("none of {tried} inputs that were tried would {purpose}: another sensor might")
    } else {
        let percent = if chance > 0.99 { "more than 99".to_owned() } else { format!("{:.0}", 100.0 * chance) };
        format!("{words}: such a record would {purpose} with a probability of {percent} %")
    })
}

/// Coefficients of the effect that is asked about.
fn own_values(open: &Open<'_>, p: &[f64]) -> Vec<f64> {
    open.with.prepared.of_effect[open.effect].iter().map(|&i| p[i]).collect()
}

/// Log-likelihood of the record, at `p` or fitted from there.
fn likeliest(state: &State, prepared: &Prepared, p: &[f64], record: &Record, ask: &Question<'_>, fit: bool) -> Option<f64> {
    let noise = state.fitted.noise_in(prepared, true);
    let mut tracks = [Track::new(record, &prepared.model, p, ask.options.hold).ok()?];
    let specs: Vec<ParameterSpec> = prepared.specs.iter().map(|s| ParameterSpec { free: s.free && fit, ..s.clone() }).collect();
    let effort = EstimateOptions { rounds: 0, evaluations: 12, ..EstimateOptions::default() };
    estimate(&prepared.model, &specs, &mut tracks, &[p.to_vec()], noise, effort).ok().map(|found| found.log_likelihood)
}

/// What all experiments that are tried have in common.
struct Ground {
    t: Vec<f64>,
    /// State at which the first record began.
    start: Vec<f64>,
    /// How far each coordinate may go.
    room: Vec<(f64, f64)>,
}

fn ground(state: &State, tracks: &[Track]) -> Option<Ground> {
    let first = tracks.first()?;
    let times = first.times();
    let period = (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64;
    let t: Vec<f64> = (0..times.len().min(SAMPLES)).map(|k| period * k as f64).collect();
    let n = state.prepared.model.dimensions().states();
    let coordinates = state.prepared.model.dimensions().coordinates;
    let mut seen = vec![(f64::INFINITY, f64::NEG_INFINITY); coordinates];
    let mut start = None;
    for (track, p) in tracks.iter().zip(&state.fitted.found.p) {
        let found = pass(&state.prepared.model, p, track, &state.fitted.found.noise, &[]).ok().flatten()?;
        let order = found.states.len() / track.times().len();
        start.get_or_insert_with(|| found.states[..n].to_vec());
        for x in found.states.chunks_exact(order) {
            seen.iter_mut().zip(x).for_each(|(s, x)| *s = (s.0.min(*x), s.1.max(*x)));
        }
    }
    let rig = &state.prepared.base.rig;
    for (i, s) in seen.iter_mut().enumerate() {
        let room = BEYOND * (s.1 - s.0);
        *s = rig.coordinates.get(i).and_then(|c| c.range).unwrap_or((s.0 - room, s.1 + room));
    }
    Some(Ground { t, start: start?, room: seen })
}

/// Inputs that are tried: each input, as large as it was seen and as large as its limits allow; the others stay where they were at the
/// first sample.
fn designs(state: &State, p: &[f64], first: &Track, t: &[f64]) -> Vec<Design> {
    let model = &state.prepared.model;
    let rig = &state.prepared.base.rig;
    let duration = t[t.len() - 1];
    let period = t[1] - t[0];
    let mut all = Vec::new();
    for (j, input) in rig.inputs.iter().enumerate() {
        let seen: Vec<f64> = first.times().iter().map(|t| first.inputs(model, p, *t)[j]).collect();
        let mean = seen.iter().sum::<f64>() / seen.len() as f64;
        let largest = seen.iter().map(|u| (u - mean).abs()).fold(0.0, f64::max);
        let mut sizes = vec![largest, 0.5 * largest];
        if let Some((lo, hi)) = input.limits {
            sizes.push((hi - mean).min(mean - lo));
        }
        sizes.retain(|s| *s > 0.0);
        sizes.dedup();
        for size in sizes {
            let unit = &input.unit.text;
            let size_words = format!("{} {unit}", crate::patch::digits(size, 2));
            let mut add = |words: String, value: &mut dyn FnMut(f64) -> f64| {
                let values = t.iter().map(|t| mean + size * value(*t)).collect();
                all.push(Design { words, input: j, values });
            };
            for parts in [8.0, 24.0] {
                let length = duration / parts;
                let mut chance = Chance::new(1);
                let levels: Vec<f64> = (0..=parts as usize).map(|_| 2.0 * chance.uniform() - 1.0).collect();
                add(
                    format!("drive {} with steps of up to {size_words}, each {} s long", input.name, crate::patch::digits(length, 2)),
                    &mut |t| {
                        let level = levels[((t / length) as usize).min(levels.len() - 1)];
                        level.signum() * (0.3 + 0.7 * level.abs())
                    },
                );
            }
            let top = (0.05 / period).min(20.0 * 2.0 / duration);
            for (from, to) in [(0.5 / duration, 3.0 / duration), (2.0 / duration, top), (top, 4.0 * top)] {
                let rate = (to / from).ln() / duration;
                add(
                    format!(
                        "drive {} with {size_words} sweeping from {} to {} Hz",
                        input.name,
                        crate::patch::digits(from, 2),
                        crate::patch::digits(to, 2)
                    ),
                    &mut |t| (TAU * from * (rate * t).exp_m1() / rate).sin(),
                );
            }
        }
    }
    all
}

/// The record that the model would make; `None` where it leaves its range.
fn simulated(prepared: &Prepared, p: &[f64], Ground { t, start, room }: &Ground, design: &Design, first: &Track) -> Option<Record> {
    let model = &prepared.model;
    let d = model.dimensions();
    let resting = first.inputs(model, p, first.times()[0]);
    let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
    let mut signals = Vec::new();
    let mut columns = Vec::new();
    for j in 0..d.signals() {
        let values = if j == design.input { design.values.clone() } else { vec![resting.get(j).copied().unwrap_or(0.0); t.len()] };
        signals.push(Signal { t: t.to_vec(), values: values.clone(), hold: sim::Hold::Zero });
        columns.push(column(model.names().signal(j), values));
    }
    let options = sim::Options { relative: 1e-8, absolute: 1e-10, ..sim::Options::default() };
    let run = simulate(model, p, start, &Signals::new(signals).ok()?, t, &options).ok()?;
    if run.status != Status::Completed {
        return None;
    }
    let inside = |k: usize| room.iter().zip(run.state(k)).all(|((lo, hi), x)| *lo <= *x && *x <= *hi);
    if !(0..t.len()).all(inside) {
        return None;
    }
    for (output, _) in first.measured() {
        columns.push(column(model.names().output(output), (0..t.len()).map(|k| run.outputs(k)[output]).collect()));
    }
    Some(Record { source: "the next experiment".to_owned(), t: t.to_vec(), columns, declared: Vec::new(), start: Start::Free })
}
