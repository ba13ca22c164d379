//! Where the disagreement acts: the smoothed disturbance of each equation, by time, by state and by shape.

use crate::answer::Place;
use crate::effects::unit::of_row;
use crate::model::Prepared;
use crate::patch::digits;
use ident::fit::FitError;
use ident::innovations::{Noise, Smoothed, Track, smooth};

/// A disturbance below this share of its own standard error is not looked at.
const LOUD: f64 = 0.5;
/// A shape must explain this share to be mentioned.
const EXPLAINS: f64 = 0.25;

/// One place for each equation that is pushed beyond chance.
///
/// # Errors
/// As [`smooth`].
pub fn locate(prepared: &Prepared, p: &[Vec<f64>], noise: &Noise, tracks: &[Track]) -> Result<Vec<Place>, FitError> {
    let mut smoothed: Vec<Smoothed> = Vec::new();
    for (track, p) in tracks.iter().zip(p) {
        match smooth(&prepared.model, p, track, noise)? {
            Some(s) => smoothed.push(s),
            None => return Ok(Vec::new()),
        }
    }
    let rig = &prepared.base.rig;
    let coordinates = rig.coordinates.len();
    let states = 2 * coordinates + rig.actuators.iter().filter(|a| a.lag.is_some()).count();
    let mut places = Vec::new();
    for (k, &row) in prepared.coordinates.iter().enumerate() {
        let mut samples: Vec<Sample> = Vec::new();
        for (r, (s, track)) in smoothed.iter().zip(tracks).enumerate() {
            for (i, t) in track.times().iter().enumerate() {
                let x = &s.state[i];
                let u = track.inputs(&prepared.model, &p[r], *t);
                samples.push(Sample { record: r, t: *t, d: x[states + k], sd: s.sd[i][k], x: x[..2 * coordinates].to_vec(), u });
            }
        }
        let size = rms(samples.iter().map(|s| s.d));
        let uncertain = rms(samples.iter().map(|s| s.sd));
        if size.is_nan() || size < LOUD * uncertain {
            continue;
        }
        let unit = of_row(rig, row).text();
        let shapes = shapes(rig, row, coordinates);
        let total: f64 = samples.iter().map(|s| s.d * s.d).sum();
        let mut best: Option<(f64, &str)> = None;
        for (name, shape) in &shapes {
            let phi: Vec<f64> = samples.iter().map(shape).collect();
            let own: f64 = phi.iter().map(|v| v * v).sum();
            let with: f64 = phi.iter().zip(&samples).map(|(v, s)| v * s.d).sum();
            let share = if own > 0.0 { with * with / own / total } else { 0.0 };
            if best.is_none_or(|(b, _)| share > b) {
                best = Some((share, name));
            }
        }
        let region = region(rig, row, coordinates, &samples);
        let q = &rig.coordinates[row].name;
        let mut sentence = format!("{q}: pushed by {} {unit} rms", digits(size, 2));
        match best.filter(|(share, _)| *share > EXPLAINS) {
            Some((share, name)) => sentence.push_str(&format!(", {:.0} % of it {name}", 100.0 * share)),
            None => sentence.push_str(", of no simple shape"),
        }
        if !region.is_empty() {
            sentence.push_str(&format!("; mostly {region}"));
        }
        places.push(Place { equation: q.clone(), sentence, windows: windows(&samples), region, size, unit });
    }
    places.sort_by(|a, b| b.size.total_cmp(&a.size));
    Ok(places)
}

struct Sample {
    record: usize,
    t: f64,
    d: f64,
    sd: f64,
    x: Vec<f64>,
    u: Vec<f64>,
}

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, n) = values.fold((0.0, 0.0), |(s, n), v| (s + v * v, n + 1.0));
    if n > 0.0 { (sum / n).sqrt() } else { 0.0 }
}

type Named = (String, Box<dyn Fn(&Sample) -> f64>);

/// Simple shapes of a disturbance, in words.
fn shapes(rig: &model_dsl::rig::Rig, row: usize, coordinates: usize) -> Vec<Named> {
    let mut all: Vec<Named> = vec![("constant".to_owned(), Box::new(|_: &Sample| 1.0))];
    for (i, c) in rig.coordinates.iter().enumerate() {
        let v = coordinates + i;
        let name = &c.name;
        let own = if i == row { "" } else { "of another axis, " };
        all.push((format!("{own}proportional to {name}'"), Box::new(move |s: &Sample| s.x[v])));
        all.push((format!("{own}following the sign of {name}'"), Box::new(move |s: &Sample| s.x[v].signum())));
        all.push((format!("{own}even in {name}'"), Box::new(move |s: &Sample| s.x[v] * s.x[v])));
        all.push((format!("{own}growing faster than {name}'"), Box::new(move |s: &Sample| s.x[v] * s.x[v].abs())));
        all.push((format!("{own}proportional to {name}"), Box::new(move |s: &Sample| s.x[i])));
        all.push((format!("{own}like sin({name})"), Box::new(move |s: &Sample| s.x[i].sin())));
        all.push((format!("{own}like cos({name})"), Box::new(move |s: &Sample| s.x[i].cos())));
    }
    for (j, input) in rig.inputs.iter().enumerate() {
        all.push((format!("proportional to {}", input.name), Box::new(move |s: &Sample| s.u[j])));
    }
    all.push(("growing with time".to_owned(), Box::new(|s: &Sample| s.t)));
    all
}

/// The split of one variable that gathers most of the disturbance in one part.
fn region(rig: &model_dsl::rig::Rig, row: usize, coordinates: usize, samples: &[Sample]) -> String {
    let mut variables: Vec<Named> = Vec::new();
    for (i, c) in rig.coordinates.iter().enumerate() {
        let v = coordinates + i;
        let unit = if crate::effects::unit::is_angle(rig, i) { "rad" } else { "m" };
        if i == row {
            variables.push((format!("|{}'| {{}} {unit}/s", c.name), Box::new(move |s: &Sample| s.x[v].abs())));
        }
        variables.push((format!("{} {{}} {unit}", c.name), Box::new(move |s: &Sample| s.x[i])));
    }
    for (j, input) in rig.inputs.iter().enumerate() {
        variables.push((format!("{} {{}} {}", input.name, input.unit.text), Box::new(move |s: &Sample| s.u[j])));
    }
    variables.push(("t {} s".to_owned(), Box::new(|s: &Sample| s.t)));
    let total: f64 = samples.iter().map(|s| s.d * s.d).sum();
    let mut best = (0.0, String::new());
    for (name, of) in &variables {
        let mut pairs: Vec<(f64, f64)> = samples.iter().map(|s| (of(s), s.d * s.d)).collect();
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut sum = 0.0;
        for (k, pair) in pairs.iter().enumerate() {
            sum += pair.1;
            let share = (k + 1) as f64 / pairs.len() as f64;
            if !(0.05..=0.95).contains(&share) || k % 16 != 0 {
                continue;
            }
            // gathered beyond its share of time
            for (gathered, time, sign) in [(sum / total, share, "<"), (1.0 - sum / total, 1.0 - share, ">")] {
                let gain = gathered - time;
                if gathered > 0.7 && time < 0.5 && gain > best.0 {
                    best = (
                        gain,
                        format!(
                            "at {} ({:.0} % of it in {:.0} % of the time)",
                            name.replace("{}", &format!("{sign} {}", digits(pair.0, 2))),
                            100.0 * gathered,
                            100.0 * time
                        ),
                    );
                }
            }
        }
    }
    best.1
}

/// Stretches of the first record in which the disturbance stays beyond two standard errors on one side.
fn windows(samples: &[Sample]) -> Vec<(f64, f64)> {
    let mut found: Vec<(f64, f64)> = Vec::new();
    let mut begun: Option<(f64, f64, f64)> = None;
    for s in samples.iter().filter(|s| s.record == 0) {
        let side = if s.d.abs() > 2.0 * s.sd { s.d.signum() } else { 0.0 };
        begun = match begun {
            Some((from, _, was)) if was == side => Some((from, s.t, side)),
            other => {
                if let Some((from, to, _)) = other.filter(|(_, _, was)| *was != 0.0) {
                    found.push((from, to));
                }
                (side != 0.0).then_some((s.t, s.t, side))
            }
        };
    }
    if let Some((from, to, _)) = begun {
        found.push((from, to));
    }
    found.sort_by(|a, b| (b.1 - b.0).total_cmp(&(a.1 - a.0)));
    found.truncate(8);
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}
