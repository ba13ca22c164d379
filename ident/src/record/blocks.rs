//! Records with fewer samples, each the mean of a block.

use super::Record;

/// A record with blocks of `count` samples averaged; `wrapped` columns are angles modulo one turn. Inputs go straight from block to block
/// afterwards. One of `held`, which keeps its value until the next sample, has the middle of its block half a sample later than an output
/// that is read at the samples: it is read at the outputs' middle.
pub fn averaged(record: &Record, count: usize, wrapped: &[String], held: &[String]) -> Record {
    if count < 2 {
        return record.clone();
    }
    let blocks = |values: &[f64], turn: Option<f64>| -> Vec<f64> {
        values
            .chunks_exact(count)
            .map(|block| {
                let near = |v: f64| turn.map_or(v, |turn| v - turn * ((v - block[0]) / turn).round());
                block.iter().map(|v| near(*v)).sum::<f64>() / count as f64
            })
            .collect()
    };
    let mut out = record.clone();
    out.t = blocks(&record.t, None);
    for column in &mut out.columns {
        let turn = wrapped.contains(&column.name).then_some(std::f64::consts::TAU);
        column.values = blocks(&column.values, turn);
        if held.contains(&column.name) {
            let share = 0.5 / count as f64;
            for k in (1..column.values.len()).rev() {
                column.values[k] -= share * (column.values[k] - column.values[k - 1]);
            }
        }
    }
    out
}
