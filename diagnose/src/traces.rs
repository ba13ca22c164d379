//! Series that show a diagnosis: what pushed the rig, and its runs before and after. They decide nothing.

use crate::answer::{Overlaid, Pushed, Traced};
use crate::effects::unit::of_row;
use crate::model::Prepared;
use ident::compare::{CompareOptions, compare};
use ident::fit::FitError;
use ident::innovations::{Noise, Track, smooth};
use ident::record::Record;
use runtime::Model;
use sim::Hold;

/// The smoothed disturbance of each equation over each record.
///
/// # Errors
/// As [`smooth`].
pub fn pushed(prepared: &Prepared, p: &[Vec<f64>], noise: &Noise, tracks: &[Track], records: &[Record]) -> Result<Vec<Pushed>, FitError> {
    let (model, rig) = (&prepared.model, &prepared.base.rig);
    let (names, d) = (model.names(), model.dimensions());
    let layout = &model.equations().layout;
    let mut all = Vec::new();
    for ((track, p), record) in tracks.iter().zip(p).zip(records) {
        let Some(found) = smooth(model, p, track, noise)? else { continue };
        let t = track.times();
        let inputs: Vec<Vec<f64>> = t.iter().map(|t| track.inputs(model, p, *t)).collect();
        let units: Vec<&str> = layout.x().map(|v| v.unit.as_str()).collect();
        let mut against: Vec<Traced> = (0..2 * d.coordinates)
            .map(|i| Traced {
                name: names.state(i).to_owned(),
                unit: units.get(i).map_or_else(String::new, |u| (*u).to_owned()),
                values: found.state.iter().map(|x| x[i]).collect(),
            })
            .collect();
        against.extend(rig.inputs.iter().enumerate().map(|(j, input)| Traced {
            name: input.name.clone(),
            unit: input.unit.text.clone(),
            values: inputs.iter().map(|u| u.get(j).copied().unwrap_or(f64::NAN)).collect(),
        }));
        for (k, &row) in prepared.coordinates.iter().enumerate() {
            all.push(Pushed {
                record: record.source.clone(),
                equation: rig.coordinates[row].name.clone(),
                unit: of_row(rig, row).text(),
                t: t.to_vec(),
                force: found.state.iter().map(|x| x[d.states() + k]).collect(),
                sd: found.sd.iter().map(|sd| sd[k]).collect(),
                against: against.clone(),
            });
        }
    }
    Ok(all)
}

/// Free runs of the refitted base over all records.
pub fn before(
    model: &dyn Model,
    p_train: &[Vec<f64>],
    p_test: &[Vec<f64>],
    train: &[Record],
    test: &[Record],
    hold: Hold,
) -> Vec<Overlaid> {
    let mut all = Vec::new();
    for (record, p, held_out) in walk((train, p_train), (test, p_test)) {
        for (signal, measured, simulated) in run(model, p, record, hold) {
            let output = (0..model.dimensions().outputs).find(|&i| model.names().output(i) == signal);
            all.push(Overlaid {
                record: record.source.clone(),
                held_out,
                unit: output.map_or_else(String::new, |i| model.names().output_unit(i).to_owned()),
                signal,
                t: record.t.clone(),
                measured,
                before: simulated,
                after: None,
            });
        }
    }
    all
}

/// The same of the patched model, beside what [`before`] gave.
pub fn after(
    all: &mut [Overlaid],
    model: &dyn Model,
    p_train: &[Vec<f64>],
    p_test: &[Vec<f64>],
    train: &[Record],
    test: &[Record],
    hold: Hold,
) {
    for (record, p, held_out) in walk((train, p_train), (test, p_test)) {
        for (signal, _, simulated) in run(model, p, record, hold) {
            if let Some(own) = all.iter_mut().find(|o| o.record == record.source && o.held_out == held_out && o.signal == signal) {
                own.after = Some(simulated);
            }
        }
    }
}

/// Records and their parameters, and whether they were held out.
fn walk<'a>(
    (train, p_train): (&'a [Record], &'a [Vec<f64>]),
    (test, p_test): (&'a [Record], &'a [Vec<f64>]),
) -> impl Iterator<Item = (&'a Record, &'a Vec<f64>, bool)> {
    let held = test.iter().zip(p_test).map(|(record, p)| (record, p, true));
    train.iter().zip(p_train).map(|(record, p)| (record, p, false)).chain(held)
}

/// Name, measured and simulated values of each output; none where the record does not fit the model.
fn run(model: &dyn Model, p: &[f64], record: &Record, hold: Hold) -> Vec<(String, Vec<f64>, Vec<f64>)> {
    let options = CompareOptions { hold, ..CompareOptions::default() };
    let found = compare(model, p, record, &options).map(|c| c.signals).unwrap_or_default();
    found.into_iter().map(|s| (s.name, s.measured, s.simulated)).collect()
}
