//! Whether records can be used at all, and samples that are taken out of use.

use crate::figures::AHEAD;
use crate::model::Prepared;
use ident::fit::FitError;
use ident::innovations::Track;
use ident::preflight::{Change, FaultKind, Range, inspect};
use ident::record::{Column, Record};
use runtime::Model;
use sim::Hold;
use std::f64::consts::TAU;

/// Fewest samples of a record.
const FEWEST: usize = 200;
/// A sample this many robust standard deviations off its neighbours' line is an outlier.
const OUTLIER: f64 = 8.0;
/// A record with more outliers is not used.
const MOST_OUTLIERS: f64 = 0.10;

/// Faults of the records, in words. Outliers of the records as measured are discarded in the ones that are used.
pub fn look(prepared: &Prepared, p: &[f64], train: &[Record], test: &[Record], used: (&mut [Track], &mut [Track])) -> Vec<String> {
    let mut faults = Vec::new();
    let names = prepared.model.names();
    for (record, used) in train.iter().chain(test).zip(used.0.iter_mut().chain(used.1)) {
        let file = &record.source;
        let samples = record.t.len();
        if samples < FEWEST {
            faults.push(format!("{file}: {samples} samples are too few to tell an effect from chance ({FEWEST} are needed)"));
            continue;
        }
        for (output, column) in measured(prepared, record) {
            let path = prepared.model.output_path(output, p);
            let values = &column.values;
            let (lo, hi) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(*v), hi.max(*v)));
            if hi - lo <= 3.0 * path.quantum || hi <= lo {
                faults.push(format!("{file}: {} does not move (a dead channel, or nothing happened)", names.output(output)));
            }
            let found = outliers(values, path.quantum, path.wrapped.then_some(TAU));
            if found.len() as f64 > MOST_OUTLIERS * samples as f64 {
                faults.push(format!("{file}: {} jumps in {} of {samples} samples: no motion of a rig", names.output(output), found.len()));
            }
            if used.times().len() == samples {
                found.into_iter().for_each(|k| used.discard(output, k));
            }
        }
        faults.extend(twice(prepared, record));
    }
    faults
}

/// The outputs that a record has: index in the model and column.
fn measured<'r>(prepared: &Prepared, record: &'r Record) -> Vec<(usize, &'r Column)> {
    let names = prepared.model.names();
    let outputs = 0..prepared.model.dimensions().outputs;
    outputs.filter_map(|i| record.columns.iter().find(|c| c.name == names.output(i)).map(|c| (i, c))).collect()
}

/// Outputs that say different things of the rig, and have one and the same channel.
fn twice(prepared: &Prepared, record: &Record) -> Option<String> {
    let (all, names, outputs) = (measured(prepared, record), prepared.model.names(), &prepared.base.rig.outputs);
    let alike = |(i, a): &(usize, &Column), (j, b): &(usize, &Column)| {
        let other = outputs.get(*i).zip(outputs.get(*j)).is_none_or(|(a, b)| a.value != b.value);
        other && a.values == b.values && a.values.iter().any(|v| *v != a.values[0])
    };
    let pair = all.iter().enumerate().find_map(|(k, one)| Some((all[..k].iter().find(|other| alike(other, one))?.0, one.0)));
    let (i, j) = pair?;
    let file = &record.source;
    Some(format!("{file}: {} and {} are equal in every sample: one of them has the other's channel", names.output(i), names.output(j)))
}

/// A record whose outliers lie on the line between their neighbours, for runs that compare with every sample.
pub fn mended(prepared: &Prepared, p: &[f64], record: &Record) -> Record {
    let mut out = record.clone();
    let names = prepared.model.names();
    for (output, column) in measured(prepared, record) {
        let path = prepared.model.output_path(output, p);
        let turn = path.wrapped.then_some(TAU);
        let near = |v: f64| turn.map_or(v, |turn| v - turn * (v / turn).round());
        let bad = outliers(&column.values, path.quantum, turn);
        let Some(column) = out.columns.iter_mut().find(|c| c.name == names.output(output)) else { continue };
        let last = column.values.len() - 1;
        for &k in &bad {
            // samples before this one are mended already
            let next = (k + 1..=last).find(|i| !bad.contains(i));
            let at = |i: usize| column.values[i];
            column.values[k] = match (k.checked_sub(1), next) {
                (Some(a), Some(b)) => at(a) + near(at(b) - at(a)) / (b - a) as f64,
                (None, Some(b)) => at(b),
                (Some(a), None) => at(a),
                (None, None) => at(k),
            };
        }
    }
    out
}

/// A change after which more than this of the accelerations is unexplained convinces nobody: something large is missing besides, or instead.
const CONVINCES: f64 = 0.5;

/// What was wired or logged wrongly: flipped signs, swapped channels, degrees for radians. Inputs of another run are left to
/// `strangers`, which a poor model does not mislead; what an effect of the catalogue can be as well (a zero that is off) is left to it.
///
/// # Errors
/// Where a record does not fit the model.
pub fn mistaken(prepared: &Prepared, ranges: &[Range], records: &[Record], hold: Hold) -> Result<Vec<String>, FitError> {
    let found = inspect(&prepared.model, &prepared.specs, ranges, records, hold).map_err(FitError::from)?;
    let mistake = |kind: &FaultKind| match kind {
        FaultKind::Contradicts(suspect) if suspect.unexplained.1 > CONVINCES => false,
        FaultKind::Contradicts(suspect) => !matches!(suspect.change, Change::Offset(..) | Change::SignOfParameter(_) | Change::Foreign(_)),
        _ => false,
    };
    Ok(found.faults.iter().filter(|f| mistake(&f.kind)).map(|f| format!("{}: {}; {}", f.record, f.sentence(), f.mend())).collect())
}

/// Samples that leave the line between their neighbours by far more than the others do. The farthest is taken out first, so that it does
/// not make outliers of its neighbours. `turn`: values are angles modulo this.
fn outliers(values: &[f64], quantum: f64, turn: Option<f64>) -> Vec<usize> {
    let count = values.len();
    if count < 5 {
        return Vec::new();
    }
    let near = |v: f64| turn.map_or(v, |turn| v - turn * (v / turn).round());
    let mut good = vec![true; count];
    let off = |k: usize, good: &[bool]| -> f64 {
        let before: Vec<usize> = (0..k).rev().filter(|&i| good[i]).take(3).collect();
        let after: Vec<usize> = (k + 1..count).filter(|&i| good[i]).take(3).collect();
        let from = |a: usize, b: usize| {
            let slope = near(values[b] - values[a]) / (b as f64 - a as f64);
            near(values[k] - values[a] - slope * (k as f64 - a as f64))
        };
        match (&before[..], &after[..]) {
            ([a, ..], [b, ..]) => from(*a, *b),
            // the two that put it nearest to their line: one of the three may jump itself
            ([a, b, c], []) | ([], [a, b, c]) => {
                [from(*a, *b), from(*a, *c), from(*b, *c)].into_iter().min_by(|x, y| x.abs().total_cmp(&y.abs())).unwrap_or(0.0)
            }
            _ => 0.0,
        }
    };
    let mut all: Vec<f64> = (0..count).map(|k| off(k, &good).abs()).collect();
    let mut sizes = all.clone();
    sizes.sort_by(f64::total_cmp);
    // values that often stand still come in steps, whatever was declared
    let mut steps: Vec<f64> = values.windows(2).map(|v| near(v[1] - v[0]).abs()).filter(|v| *v > 0.0).collect();
    steps.sort_by(f64::total_cmp);
    let step = if 4 * steps.len() < 3 * count { steps.get(steps.len() / 2).copied().unwrap_or(0.0) } else { 0.0 };
    let quantum = quantum.max(step);
    let scale = (1.4826 * sizes[count / 2]).max(sizes[count * 9 / 10] / 1.645).max(0.6 * quantum).max(f64::MIN_POSITIVE);
    // where a rig that mostly rests moves, samples leave their neighbours' lines in company
    let about = |k: usize, good: &[bool]| {
        let others = (k.saturating_sub(8)..(k + 9).min(count)).filter(|i| i.abs_diff(k) > 1 && good[*i]);
        let mut near: Vec<f64> = others.map(|i| off(i, good).abs()).collect();
        near.sort_by(f64::total_cmp);
        near.get(near.len() / 2).copied().unwrap_or(0.0)
    };
    // and where it begins to move from rest, the line bends to one side for several samples: a lone sample bends its neighbours the other way
    let moving = |k: usize, good: &[bool]| {
        let before: Vec<usize> = (0..k).rev().filter(|&i| good[i]).take(3).collect();
        let after: Vec<usize> = (k + 1..count).filter(|&i| good[i]).take(3).collect();
        let alike = |of: f64, bend: f64| bend * of > 0.0 && bend.abs() > 0.25 * of.abs();
        // at an end the line is prolonged, which says nothing of bends
        let inner = |side: &[usize], i: usize| (side.len() > i + 1).then(|| off(side[i], good));
        let follows = |of: f64, side: &[usize], i: usize| inner(side, i).is_some_and(|bend| alike(of, bend));
        match (before.is_empty(), after.is_empty()) {
            (false, false) => {
                let own = off(k, good);
                let [left, right] = [&before, &after].map(|side| (follows(own, side, 0), follows(own, side, 1)));
                (left.0 && left.1) || (right.0 && right.1) || (left.0 && right.0)
            }
            (true, _) => inner(&after, 0).is_some_and(|first| follows(first, &after, 1)),
            (_, true) => inner(&before, 0).is_some_and(|first| follows(first, &before, 1)),
        }
    };
    let mut found = Vec::new();
    while let Some((k, size)) = all.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1)) {
        if size <= OUTLIER * scale || found.len() > count / 5 {
            break;
        }
        if size <= OUTLIER * about(k, &good) || moving(k, &good) {
            all[k] = 0.0;
            continue;
        }
        (good[k], all[k]) = (false, 0.0);
        found.push(k);
        let touched = (0..k).rev().filter(|&i| good[i]).take(3).chain((k + 1..count).filter(|&i| good[i]).take(3));
        for i in touched.collect::<Vec<_>>() {
            all[i] = off(i, &good).abs();
        }
    }
    found.sort_unstable();
    found
}

/// Fewest samples a second that are kept.
const RATE: f64 = 100.0;
/// Samples that the fastest mode of the model keeps in each of its periods.
const PER_PERIOD: f64 = 30.0;

/// Poles of the model at rest without inputs; none where it has none there.
fn poles(prepared: &Prepared, p: &[f64]) -> Vec<nalgebra::Complex<f64>> {
    let d = prepared.model.dimensions();
    let n = d.states();
    let (mut dx, mut a, mut b) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * d.signals()]);
    if prepared.model.linearize(0.0, &vec![0.0; n], &vec![0.0; d.signals()], p, &mut dx, &mut a, &mut b).is_err() {
        return Vec::new();
    }
    nalgebra::DMatrix::from_row_slice(n, n, &a).complex_eigenvalues().iter().copied().collect()
}

/// Seconds of a prediction: an error of an unstable rig must not grow more than by this exponent.
const GROWS: f64 = 1.5;

/// How far ahead predictions of this rig can be asked for [s].
pub fn ahead(prepared: &Prepared, p: &[f64]) -> f64 {
    let fastest = poles(prepared, p).iter().map(|pole| pole.re).fold(0.0, f64::max);
    // in hundredths, to be read
    if fastest * AHEAD > GROWS { (100.0 * GROWS / fastest).floor().max(1.0) / 100.0 } else { AHEAD }
}

/// An axis integrates: a free run over `duration` [s] gathers whatever force is left and says nothing of any one.
pub fn integrates(prepared: &Prepared, p: &[f64], duration: f64) -> bool {
    poles(prepared, p).iter().any(|pole| pole.norm() * duration < 1.0)
}

/// How many samples are averaged into one: filters look one sample ahead, and a record at 1 kHz would ask them about vibrations that no rigid
/// body has. Inputs and outputs are averaged alike, so that what relates them stays.
pub fn stride(prepared: &Prepared, p: &[f64], records: &[Record]) -> usize {
    let period = records.iter().map(Record::period).fold(0.0, f64::max);
    if period <= 0.0 {
        return 1;
    }
    let fastest = poles(prepared, p).iter().map(|p| p.im.abs()).fold(0.0, f64::max) / TAU;
    let wanted = RATE.max(PER_PERIOD * fastest);
    ((1.0 / (period * wanted) + 1e-6).floor() as usize).max(1)
}

/// Fewest samples a second, and of a record, from which an output error starts a fit.
const START_RATE: f64 = 20.0;
const START_SAMPLES: usize = 1500;

/// How many samples are averaged into one where only starting values are wanted: a free run sees no more than the rig's own modes.
pub fn stride_of_start(prepared: &Prepared, p: &[f64], record: &Record) -> usize {
    let fastest = poles(prepared, p).iter().map(|p| p.norm()).fold(0.0, f64::max) / TAU;
    let by_rate = (1.0 / (record.period() * START_RATE.max(PER_PERIOD * fastest)) + 1e-6).floor();
    (by_rate.min((record.t.len() / START_SAMPLES) as f64) as usize).max(1)
}

#[cfg(test)]
mod tests {
    use super::outliers;

    #[test]
    fn outliers_are_found_and_their_neighbours_left() {
        let mut values: Vec<f64> = (0..1500).map(|k| 0.01 * f64::from(k)).map(|t| 20.0 * (0.7 * t).sin() + (9.0 * t).sin()).collect();
        let mut bad: Vec<usize> = (1..30).map(|k: usize| k * k * 37 % 1480).collect();
        bad.extend([0, 700, 701, 703, 1499]);
        bad.sort_unstable();
        bad.dedup();
        for &k in &bad {
            values[k] += (if k % 2 == 0 { 1.0 } else { -1.0 }) * (8.0 + (k % 50) as f64);
        }
        assert_eq!(outliers(&values, 7.7e-4, None), bad);
    }

    #[test]
    fn outliers_in_company_are_all_found() {
        // from rest, as a rig starts
        let mut values: Vec<f64> = (0..1200).map(|k| 0.01 * f64::from(k)).map(|t| 0.2 * t * t * (-0.2 * t).exp()).collect();
        let bad = vec![2, 5, 13, 600, 1198];
        for (&k, by) in bad.iter().zip([-1.8, 3.6, -3.9, 1.0, 2.0]) {
            values[k] += by;
        }
        assert_eq!(outliers(&values, 1.6e-4, None), bad);
    }

    #[test]
    fn motion_that_begins_from_rest_is_no_outlier() {
        // thrown at the first sample and again later, and soon at rest
        let thrown = |t: f64| if t < 0.0 { 0.0 } else { 0.3 * (1.0 - (-12.0 * t).exp() * (1.0 + 12.0 * t)) };
        let mut values: Vec<f64> = (0..1200).map(|k| 0.01 * f64::from(k)).map(|t| thrown(t) - thrown(t - 7.0)).collect();
        assert_eq!(outliers(&values, 1e-5, None), Vec::<usize>::new());
        // a pair that jumps together, and a lone one while it moves
        for (k, by) in [(300, 0.2), (301, 0.14), (704, -0.1)] {
            values[k] += by;
        }
        assert_eq!(outliers(&values, 1e-5, None), vec![300, 301, 704]);
    }
}
