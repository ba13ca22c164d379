//! Forces that nobody named: columns by which a gap outside of the catalogue shows itself.

use crate::effects::Scales;
use crate::effects::unit::is_angle;
use crate::model::Prepared;
use crate::screen::Seen;
use ident::innovations::Shape;

/// Periods per turn that are looked for.
const HARMONICS: usize = 8;

/// For each equation: periodic forces of each turning angle, and forces in parts of its position and rate.
pub fn unnamed<'a>(prepared: &Prepared, scales: &Scales) -> Vec<Seen<'a>> {
    let rig = &prepared.base.rig;
    let n = rig.coordinates.len();
    let mut all = Vec::new();
    for (entry, &row) in prepared.coordinates.iter().enumerate() {
        let q = &rig.coordinates[row].name;
        for (i, c) in rig.coordinates.iter().enumerate() {
            let (lo, hi) = scales.range[i];
            if !is_angle(rig, i) || hi - lo < 2.0 {
                continue;
            }
            for k in 1..=HARMONICS {
                let order = k as f64;
                let sine: Box<Shape> = Box::new(move |_, x: &[f64], _| (order * x[i]).sin());
                let cosine: Box<Shape> = Box::new(move |_, x: &[f64], _| (order * x[i]).cos());
                all.push(Seen::Shape(vec![(entry, sine), (entry, cosine)], format!("on {q}, repeating {k} times per turn of {}", c.name)));
            }
        }
        // bumps over the range of position and of rate
        let (lo, hi) = scales.range[row];
        let rate = scales.rate[row];
        for (of, low, high, word) in [(row, lo, hi, "position"), (n + row, -2.0 * rate, 2.0 * rate, "rate")] {
            if high <= low {
                continue;
            }
            let shapes: Vec<(usize, Box<Shape>)> = (0..6)
                .map(|k| {
                    let (center, width) = (low + (f64::from(k) + 0.5) * (high - low) / 6.0, (high - low) / 6.0);
                    let bump: Box<Shape> = Box::new(move |_, x: &[f64], _| (-((x[of] - center) / width).powi(2)).exp());
                    (entry, bump)
                })
                .collect();
            all.push(Seen::Shape(shapes, format!("on {q}, depending on its {word}")));
        }
    }
    all
}
