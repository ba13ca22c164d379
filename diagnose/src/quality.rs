//! Whether records can be used at all, and samples that are taken out of use.

use crate::model::Prepared;
use ident::fit::FitError;
use ident::innovations::{Noise, Track, likelihood};
use ident::preflight::{Change, FaultKind, Range, inspect};
use ident::record::Record;
use runtime::Model;
use sim::Hold;

/// Fewest samples of a record.
const FEWEST: usize = 200;
/// A sample this many robust standard deviations off its neighbours' line is an outlier.
const OUTLIER: f64 = 8.0;
/// A record with more outliers is not used.
const MOST_OUTLIERS: f64 = 0.10;

/// Faults of the records, in words. Outliers of the records as measured are discarded in the ones that are used.
pub fn look(prepared: &Prepared, p: &[f64], train: &mut [Track], test: &mut [Track], used: (&mut [Track], &mut [Track])) -> Vec<String> {
    let mut faults = Vec::new();
    let names = prepared.model.names();
    for (track, used) in train.iter_mut().chain(test).zip(used.0.iter_mut().chain(used.1)) {
        let file = track.source().to_owned();
        let samples = track.times().len();
        if samples < FEWEST {
            faults.push(format!("{file}: {samples} samples are too few to tell an effect from chance ({FEWEST} are needed)"));
            continue;
        }
        let mut bad: Vec<(usize, usize)> = Vec::new();
        for (output, values) in track.measured() {
            let quantum = prepared.model.output_path(output, p).quantum;
            let (lo, hi) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(*v), hi.max(*v)));
            if hi - lo <= 3.0 * quantum || hi <= lo {
                faults.push(format!("{file}: {} does not move (a dead channel, or nothing happened)", names.output(output)));
            }
            let found = outliers(values, quantum);
            if found.len() as f64 > MOST_OUTLIERS * samples as f64 {
                faults.push(format!("{file}: {} jumps in {} of {samples} samples: no motion of a rig", names.output(output), found.len()));
            }
            bad.extend(found.into_iter().map(|k| (output, k)));
        }
        for (output, k) in bad {
            if used.times().len() == samples {
                used.discard(output, k);
            }
        }
    }
    faults
}

/// A record whose outliers lie on the line between their neighbours, for runs that compare with every sample.
pub fn mended(prepared: &Prepared, p: &[f64], record: &Record) -> Record {
    let mut out = record.clone();
    let names = prepared.model.names();
    for i in 0..prepared.model.dimensions().outputs {
        let path = prepared.model.output_path(i, p);
        let Some(column) = out.columns.iter_mut().find(|c| c.name == names.output(i)) else { continue };
        // a turn of a wrapped angle is no outlier
        if path.wrapped {
            continue;
        }
        for k in outliers(&column.values, path.quantum) {
            let near = [k - 2, k - 1, k + 1, k + 2].map(|i| column.values[i]);
            let mut sorted = near;
            sorted.sort_by(f64::total_cmp);
            column.values[k] = 0.5 * (sorted[1] + sorted[2]);
        }
    }
    out
}

/// What was wired or logged wrongly: flipped signs, swapped channels, degrees for radians. Inputs of another run are left to the
/// filter (`strangers`), which a poor model does not mislead; what an effect of the
/// catalogue can be as well (a zero that is off) is left to it.
///
/// # Errors
/// Where a record does not fit the model.
pub fn mistaken(prepared: &Prepared, ranges: &[Range], records: &[Record], hold: Hold) -> Result<Vec<String>, FitError> {
    let found = inspect(&prepared.model, &prepared.specs, ranges, records, hold).map_err(FitError::from)?;
    let mistake = |kind: &FaultKind| match kind {
        FaultKind::Contradicts(suspect) => !matches!(suspect.change, Change::Offset(..) | Change::SignOfParameter(_) | Change::Foreign(_)),
        _ => false,
    };
    Ok(found.faults.iter().filter(|f| mistake(&f.kind)).map(|f| format!("{}: {}; {}", f.record, f.sentence(), f.mend())).collect())
}

/// Log-likelihood that the inputs of a record must be worth.
const WORTH: f64 = 5.0;

/// Records whose inputs explain nothing of their motion, neither with the fitted parameters nor with the rig's own.
///
/// # Errors
/// As the filter.
pub fn strangers(prepared: &Prepared, fitted: &[Vec<f64>], own: &[f64], noise: &Noise, tracks: &[Track]) -> Result<Vec<String>, FitError> {
    let mut faults = Vec::new();
    for (track, fitted) in tracks.iter().zip(fitted) {
        let mut worth = f64::NEG_INFINITY;
        for p in [fitted.as_slice(), own] {
            let Some(still) = track.without_inputs(&prepared.model, p) else {
                worth = f64::INFINITY;
                break;
            };
            let of = |track: &Track| likelihood(&prepared.model, p, track, noise).map(|l| l.map(|l| l.iter().sum::<f64>()));
            // what cannot be followed says nothing
            worth = match (of(track)?, of(&still)?) {
                (Some(with), Some(without)) => worth.max(with - without),
                _ => f64::INFINITY,
            };
        }
        if worth < WORTH {
            faults.push(format!(
                "{}: the inputs explain nothing of the motion (log-likelihood {worth:+.0} against their means): are they this record's own?",
                track.source()
            ));
        }
    }
    Ok(faults)
}

/// Samples that leave the line between their neighbours by far more than the others do, and come back.
fn outliers(values: &[f64], quantum: f64) -> Vec<usize> {
    if values.len() < 5 {
        return Vec::new();
    }
    // against the median of five: a single spike does not move it
    let off = |k: usize| {
        let mut near: Vec<f64> = (k - 2..=k + 2).filter(|&i| i != k).map(|i| values[i]).collect();
        near.sort_by(f64::total_cmp);
        values[k] - 0.5 * (near[1] + near[2])
    };
    let all: Vec<f64> = (2..values.len() - 2).map(off).collect();
    let mut sizes: Vec<f64> = all.iter().map(|v| v.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let scale = (1.4826 * sizes[sizes.len() / 2]).max(sizes[sizes.len() * 9 / 10] / 1.645).max(0.6 * quantum);
    all.iter().enumerate().filter(|(_, v)| v.abs() > OUTLIER * scale.max(f64::MIN_POSITIVE)).map(|(k, _)| k + 2).collect()
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
    let fastest = poles(prepared, p).iter().map(|p| p.im.abs()).fold(0.0, f64::max) / std::f64::consts::TAU;
    let wanted = RATE.max(PER_PERIOD * fastest);
    ((1.0 / (period * wanted) + 1e-6).floor() as usize).max(1)
}
