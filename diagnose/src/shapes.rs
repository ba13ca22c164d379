//! Shapes that nobody named: forces by which a gap outside of the catalogue shows itself, and ways in which an effect that was found may
//! differ from place to place.

use crate::effects::unit::is_angle;
use crate::effects::{Effect, Scales};
use crate::model::Prepared;
use crate::screen::Seen;
use ident::innovations::Shape;

/// Periods per turn that are looked for.
const HARMONICS: usize = 8;

/// Bumps over a range.
const BUMPS: usize = 6;
/// Smallest range of an angle that turns.
const TURNS: f64 = 2.0;

/// For each equation: periodic forces of each turning angle, and forces in parts of its position and rate.
pub fn unnamed<'a>(prepared: &Prepared, scales: &Scales) -> Vec<Seen<'a>> {
    let rig = &prepared.base.rig;
    let mut all = Vec::new();
    for (entry, &row) in prepared.coordinates.iter().enumerate() {
        let q = &rig.coordinates[row].name;
        let mut add = |shapes: Vec<Box<Shape>>, words: String| {
            all.push(Seen::Shape(shapes.into_iter().map(|shape| (entry, shape)).collect(), format!("on {q}, {words}")));
        };
        for i in 0..rig.coordinates.len() {
            of_angle(prepared, scales, i, &mut add);
        }
        of_place(prepared, scales, row, &mut add);
    }
    all
}

/// The effect multiplied by what depends on position and rate of the joints that it is about (of all where it is about none), on inputs, and
/// on time.
pub fn uneven<'a>(prepared: &Prepared, scales: &Scales, effect: &Effect, coefficients: &[usize]) -> Vec<Seen<'a>> {
    let rig = &prepared.base.rig;
    let named: Vec<&str> = effect.place.split(['>', '-', ',']).collect();
    let mut about: Vec<usize> = (0..rig.coordinates.len()).filter(|&i| named.contains(&rig.coordinates[i].name.as_str())).collect();
    if about.is_empty() {
        about = (0..rig.coordinates.len()).collect();
    }
    let mut all = Vec::new();
    let mut add = |shapes: Vec<Box<Shape>>, words: String| {
        if let [coefficient] = *coefficients {
            let weighted = shapes.into_iter().map(|shape| (coefficient, shape)).collect();
            all.push(Seen::Weighted(weighted, words));
        }
    };
    for i in about {
        of_angle(prepared, scales, i, &mut add);
        of_place(prepared, scales, i, &mut add);
    }
    for (j, input) in rig.inputs.iter().enumerate() {
        let largest = scales.input.get(j).map_or(0.0, |s| s.0);
        if largest > 0.0 {
            let powers = (1..3).map(|k| -> Box<Shape> { Box::new(move |_, _: &[f64], u| (u[j] / largest).powi(k)) });
            add(powers.collect(), format!("changing with {}", input.name));
        }
    }
    let duration = scales.duration.max(f64::MIN_POSITIVE);
    let powers = (1..3).map(|k| -> Box<Shape> { Box::new(move |t, _: &[f64], _| (t / duration).powi(k)) });
    add(powers.collect(), "changing as time goes".to_owned());
    all
}

/// Waves over a turning angle.
fn of_angle(prepared: &Prepared, scales: &Scales, i: usize, add: &mut impl FnMut(Vec<Box<Shape>>, String)) {
    let rig = &prepared.base.rig;
    let (lo, hi) = scales.range[i];
    if !is_angle(rig, i) || hi - lo < TURNS {
        return;
    }
    for k in 1..=HARMONICS {
        let order = k as f64;
        let sine: Box<Shape> = Box::new(move |_, x: &[f64], _| (order * x[i]).sin());
        let cosine: Box<Shape> = Box::new(move |_, x: &[f64], _| (order * x[i]).cos());
        add(vec![sine, cosine], format!("repeating {k} times per turn of {}", rig.coordinates[i].name));
    }
}

/// Bumps over the range of position and of rate.
fn of_place(prepared: &Prepared, scales: &Scales, i: usize, add: &mut impl FnMut(Vec<Box<Shape>>, String)) {
    let n = prepared.base.rig.coordinates.len();
    let (lo, hi) = scales.range[i];
    let rate = scales.rate[i];
    for (of, low, high, word) in [(i, lo, hi, "position"), (n + i, -2.0 * rate, 2.0 * rate, "rate")] {
        if high <= low {
            continue;
        }
        let width = (high - low) / BUMPS as f64;
        let bumps = (0..BUMPS).map(|k| -> Box<Shape> {
            let center = low + (k as f64 + 0.5) * width;
            Box::new(move |_, x: &[f64], _| (-((x[of] - center) / width).powi(2)).exp())
        });
        add(bumps.collect(), format!("depending on its {word}"));
    }
}
