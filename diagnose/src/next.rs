//! The next experiment: the input, among steps, slow and fast sweeps within what the rig allows, whose record would tell most. Where the
//! rig leaves its range under every one of them, they are added to the commands of a regulator.
//!
//! Each is simulated with the effect in the model, without noise, and the rivals are fitted to that record: by how much the likelihood of
//! the best of them stays behind is the evidence that such a record would bring. The filter's noise says how much chance there is in it.

use crate::chance::{Chance, below};
use crate::effects::{Effect, Signature};
use crate::model::{Included, Prepared, prepare};
use crate::regulated::{Regulator, Seen};
use crate::search::{Question, SEPARATES, State, carry};
use ident::fit::ParameterSpec;
use ident::innovations::{EstimateOptions, Track, estimate, pass};
use ident::record::{Column, Record, Start};
use runtime::Model;
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
    name: String,
    /// Where the input stays.
    mean: f64,
    /// What is added to that.
    added: Vec<f64>,
}

/// Sizes that are tried, in parts of how far the input was seen to move.
const FREELY: [f64; 2] = [1.0, 0.5];
/// A regulator itself moves the input.
const REGULATED: [f64; 4] = [1.0, 0.5, 0.2, 0.05];

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
    let evidence = |record: &Record| {
        let with = likeliest(open.with, &open.with.prepared, &p, record, ask, false)?;
        let behind = |prepared: &Prepared| {
            let from = carry(&open.with.prepared, &p, prepared);
            likeliest(open.with, prepared, &from, record, ask, true).map_or(0.0, |other| with - other)
        };
        Some(others.iter().map(behind).fold(f64::INFINITY, f64::min))
    };
    let model = &open.with.prepared.model;
    let mut found: Vec<(f64, String)> = Vec::new();
    for design in designs(open.with, &p, first, &ground.t, &FREELY) {
        let Some(record) = driven(model, &p, &ground, &design, first) else { continue };
        found.extend(evidence(&record).map(|e| (e, format!("drive {} with {}", design.name, design.words))));
    }
    if found.is_empty()
        && let Some(regulator) = Regulator::new(model, &p, &ground.seen, ground.t[1] - ground.t[0])
    {
        for design in designs(open.with, &p, first, &ground.t, &REGULATED) {
            let at = (ground.t.as_slice(), ground.start.as_slice());
            let Some(run) = regulator.run((model, &p), at, (design.input, &design.added), |x| ground.inside(x)) else { continue };
            let record = recorded(model, &ground.t, (&run.u, &run.y), first);
            found.extend(evidence(&record).map(|e| (e, format!("with a regulator at work, add to {} {}", design.name, design.words))));
        }
    }
    let tried = found.len();
    let best = found.into_iter().reduce(|best, other| if other.0 > best.0 { other } else { best });
    let what = format!("{} on {}", own.effect.id, own.effect.place);
    let names: Vec<String> = rivals.iter().map(|e| format!("{} on {}", e.id, e.place)).collect();
    let purpose =
        if names.is_empty() { format!("show {what} as it was found") } else { format!("tell {what} from {}", names.join(" and ")) };
    let Some((evidence, words)) = best else {
        return Some(format!(
            "none of the inputs that were tried keeps the model within what was seen or the range that the rig gives, nor does a regulator: to \
             {purpose}, use your own and move its reference"
        ));
    };
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
    seen: Seen,
}

impl Ground {
    fn inside(&self, x: &[f64]) -> bool {
        self.room.iter().zip(x).all(|((lo, hi), x)| *lo <= *x && *x <= *hi)
    }
}

fn ground(state: &State, tracks: &[Track]) -> Option<Ground> {
    let first = tracks.first()?;
    let times = first.times();
    let period = (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64;
    let t: Vec<f64> = (0..times.len().min(SAMPLES)).map(|k| period * k as f64).collect();
    let model = &state.prepared.model;
    let d = model.dimensions();
    let (mut x, mut u) = (Spread::new(d.states()), Spread::new(d.signals()));
    let mut start = None;
    for (track, p) in tracks.iter().zip(&state.fitted.found.p) {
        let found = pass(model, p, track, &state.fitted.found.noise, &[]).ok().flatten()?;
        let order = found.states.len() / track.times().len();
        start.get_or_insert_with(|| found.states[..d.states()].to_vec());
        found.states.chunks_exact(order).for_each(|own| x.see(own));
        track.times().iter().for_each(|t| u.see(&track.inputs(model, p, *t)));
    }
    let rig = &state.prepared.base.rig;
    let room = (0..d.coordinates)
        .map(|i| {
            let (lo, hi) = x.range[i];
            let room = BEYOND * (hi - lo);
            rig.coordinates.get(i).and_then(|c| c.range).unwrap_or((lo - room, hi + room))
        })
        .collect();
    let seen = Seen { x: x.mean(), x_spread: x.half(), u: u.mean(), u_spread: u.half() };
    Some(Ground { t, start: start?, room, seen })
}

/// What numbers were seen to be.
struct Spread {
    range: Vec<(f64, f64)>,
    sum: Vec<f64>,
    count: f64,
}

impl Spread {
    fn new(count: usize) -> Self {
        Self { range: vec![(f64::INFINITY, f64::NEG_INFINITY); count], sum: vec![0.0; count], count: 0.0 }
    }

    fn see(&mut self, values: &[f64]) {
        self.range.iter_mut().zip(values).for_each(|(r, v)| *r = (r.0.min(*v), r.1.max(*v)));
        self.sum.iter_mut().zip(values).for_each(|(s, v)| *s += v);
        self.count += 1.0;
    }

    fn mean(&self) -> Vec<f64> {
        self.sum.iter().map(|s| s / self.count).collect()
    }

    /// Half of each range; one where nothing moved.
    fn half(&self) -> Vec<f64> {
        self.range.iter().map(|(lo, hi)| if hi > lo { 0.5 * (hi - lo) } else { 1.0 }).collect()
    }
}

/// Inputs that are tried: each input, by parts of how far it was seen to move and as far as its limits allow; the others stay where they
/// were at the first sample.
fn designs(state: &State, p: &[f64], first: &Track, t: &[f64], parts: &[f64]) -> Vec<Design> {
    let model = &state.prepared.model;
    let rig = &state.prepared.base.rig;
    let duration = t[t.len() - 1];
    let period = t[1] - t[0];
    let mut all = Vec::new();
    for (j, input) in rig.inputs.iter().enumerate() {
        let seen: Vec<f64> = first.times().iter().map(|t| first.inputs(model, p, *t)[j]).collect();
        let mean = seen.iter().sum::<f64>() / seen.len() as f64;
        let largest = seen.iter().map(|u| (u - mean).abs()).fold(0.0, f64::max);
        let mut sizes: Vec<f64> = parts.iter().map(|part| part * largest).collect();
        if let Some((lo, hi)) = input.limits {
            sizes.push((hi - mean).min(mean - lo));
        }
        sizes.retain(|s| *s > 0.0);
        sizes.dedup();
        for size in sizes {
            let unit = &input.unit.text;
            let size_words = format!("{} {unit}", crate::patch::digits(size, 2));
            let mut add = |words: String, value: &mut dyn FnMut(f64) -> f64| {
                let added = t.iter().map(|t| size * value(*t)).collect();
                all.push(Design { words, input: j, name: input.name.clone(), mean, added });
            };
            for parts in [8.0, 24.0] {
                let length = duration / parts;
                let mut chance = Chance::new(1);
                let levels: Vec<f64> = (0..=parts as usize).map(|_| 2.0 * chance.uniform() - 1.0).collect();
                add(format!("steps of up to {size_words}, each {} s long", crate::patch::digits(length, 2)), &mut |t| {
                    let level = levels[((t / length) as usize).min(levels.len() - 1)];
                    level.signum() * (0.3 + 0.7 * level.abs())
                });
            }
            let top = (0.05 / period).min(20.0 * 2.0 / duration);
            for (from, to) in [(0.5 / duration, 3.0 / duration), (2.0 / duration, top), (top, 4.0 * top)] {
                let rate = (to / from).ln() / duration;
                add(
                    format!("{size_words} sweeping from {} to {} Hz", crate::patch::digits(from, 2), crate::patch::digits(to, 2)),
                    &mut |t| (TAU * from * (rate * t).exp_m1() / rate).sin(),
                );
            }
        }
    }
    all
}

/// The record that the model would make when it is driven; `None` where it leaves its range.
fn driven(model: &dyn Model, p: &[f64], ground: &Ground, design: &Design, first: &Track) -> Option<Record> {
    let t = &ground.t;
    let resting = first.inputs(model, p, first.times()[0]);
    let applied = |k: usize| {
        let mut u = resting.clone();
        u[design.input] = design.mean + design.added[k];
        u
    };
    let u: Vec<Vec<f64>> = (0..t.len()).map(applied).collect();
    let of = |j: usize| Signal { t: t.clone(), values: u.iter().map(|u| u[j]).collect(), hold: sim::Hold::Zero };
    let options = sim::Options { relative: 1e-8, absolute: 1e-10, ..sim::Options::default() };
    let run = simulate(model, p, &ground.start, &Signals::new((0..resting.len()).map(of).collect()).ok()?, t, &options).ok()?;
    if run.status != Status::Completed || !(0..t.len()).all(|k| ground.inside(run.state(k))) {
        return None;
    }
    let y: Vec<Vec<f64>> = (0..t.len()).map(|k| run.outputs(k).to_vec()).collect();
    Some(recorded(model, t, (&u, &y), first))
}

/// Signals and measured outputs as a record.
fn recorded(model: &dyn Model, t: &[f64], (u, y): (&[Vec<f64>], &[Vec<f64>]), first: &Track) -> Record {
    let names = model.names();
    let column = |name: &str, of: &[Vec<f64>], i: usize| Column {
        name: name.to_owned(),
        unit: None,
        values: of.iter().map(|values| values[i]).collect(),
    };
    let signals = (0..model.dimensions().signals()).map(|j| column(names.signal(j), u, j));
    let columns = signals.chain(first.measured().map(|(output, _)| column(names.output(output), y, output))).collect();
    Record { source: "the next experiment".to_owned(), t: t.to_vec(), columns, declared: Vec::new(), start: Start::Free }
}
