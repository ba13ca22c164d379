//! Records with fewer samples, each the mean of a block.

use super::Record;
use runtime::Model;
use sim::Hold;

/// What a model's signals are when blocks of samples are averaged.
#[derive(Clone, Debug)]
pub struct Blocks {
    /// Measured angles that are known modulo one turn.
    wrapped: Vec<String>,
    /// What drives the rig: inputs and accelerations of prescribed coordinates.
    signals: Vec<String>,
    /// What those do between samples.
    hold: Hold,
}

impl Blocks {
    /// The signals of `model` at its parameters `p`, and what those that drive it do between the samples of a record.
    #[must_use]
    pub fn of(model: &dyn Model, p: &[f64], hold: Hold) -> Self {
        let (d, names) = (model.dimensions(), model.names());
        let wraps = |i: &usize| model.output_path(*i, p).wrapped;
        Self {
            wrapped: (0..d.outputs).filter(wraps).map(|i| names.output(i).to_owned()).collect(),
            signals: (0..d.signals()).map(|i| names.signal(i).to_owned()).collect(),
            hold,
        }
    }

    /// What the signals do between the samples of a record of blocks of `count`.
    #[must_use]
    pub fn hold(&self, count: usize) -> Hold {
        if count < 2 { self.hold } else { Hold::First }
    }

    /// A record with blocks of `count` samples averaged, each in the middle of its block. What drives the rig goes straight from block to
    /// block, so that it turns the means of a double integral's samples into those of the record's: see [`straightened`].
    #[must_use]
    pub fn averaged(&self, record: &Record, count: usize) -> Record {
        if count < 2 {
            return record.clone();
        }
        let means = |values: &[f64], turn: Option<f64>| -> Vec<f64> {
            values
                .chunks_exact(count)
                .map(|block| {
                    let near = |v: f64| turn.map_or(v, |turn| v - turn * ((v - block[0]) / turn).round());
                    block.iter().map(|v| near(*v)).sum::<f64>() / count as f64
                })
                .collect()
        };
        let mut out = record.clone();
        out.t = means(&record.t, None);
        for column in &mut out.columns {
            column.values = if self.signals.contains(&column.name) {
                straightened(&column.values, count, self.hold)
            } else {
                means(&column.values, self.wrapped.contains(&column.name).then_some(std::f64::consts::TAU))
            };
        }
        out
    }
}

/// Corners, in the middles of blocks of `count` samples, of the line of straight pieces that is nearest, in least squares, to the moving
/// mean of a signal over as many samples.
///
/// Means of blocks follow a rig's equations (as far as those are linear) when the moving mean of its signals drives it. Straight lines
/// through that mean's own values would lose (omega h)^2 / 12 of what acts at omega, h long a block: a mass would come out as much too
/// small. The nearest line has the same integral against each hat between neighbouring corners, and that integral is all of a force that a
/// double integral's second difference sees.
fn straightened(values: &[f64], count: usize, hold: Hold) -> Vec<f64> {
    let corners = values.len() / count;
    if corners < 2 {
        return values.chunks_exact(count).map(|block| block.iter().sum::<f64>() / count as f64).collect();
    }
    let c = count as f64;
    // integral over the piece from sample i to the next, times a hat that goes from `a` there to `b`, of the signal
    let piece = |i: usize, a: f64, b: f64| match hold {
        Hold::Zero => values[i] * (a + b) / 2.0,
        Hold::First => values[i] * (2.0 * a + b) / 6.0 + values[i + 1] * (a + 2.0 * b) / 6.0,
    };
    // a hat of unit height and unit area, rising to sample `top` or falling from it, and the mean over a block of such tops
    let rising = |top: usize| (0..count).map(|j| piece(top - count + j, j as f64 / c, (j + 1) as f64 / c)).sum::<f64>() / c;
    let falling = |top: usize| (0..count).map(|j| piece(top + j, 1.0 - j as f64 / c, 1.0 - (j + 1) as f64 / c)).sum::<f64>() / c;
    let over = |k: usize, side: &dyn Fn(usize) -> f64| (k * count..(k + 1) * count).map(side).sum::<f64>() / c;
    let mut right: Vec<f64> = (0..corners)
        .map(|k| {
            let before = if k > 0 { over(k, &rising) } else { 0.0 };
            let after = if k + 1 < corners { over(k, &falling) } else { 0.0 };
            before + after
        })
        .collect();
    // hats against hats: 2/3 (1/3 at the ends) with themselves, 1/6 with their neighbours
    let own = |k: usize| if k == 0 || k + 1 == corners { 1.0 / 3.0 } else { 2.0 / 3.0 };
    let mut diagonal: Vec<f64> = (0..corners).map(own).collect();
    for k in 1..corners {
        let share = 1.0 / 6.0 / diagonal[k - 1];
        diagonal[k] -= share / 6.0;
        right[k] -= share * right[k - 1];
    }
    right[corners - 1] /= diagonal[corners - 1];
    for k in (0..corners - 1).rev() {
        right[k] = (right[k] - right[k + 1] / 6.0) / diagonal[k];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::straightened;
    use sim::Hold;

    /// Positions of a unit mass from rest under a force, at the samples, each piece of which is integrated exactly.
    fn driven(force: &[f64], step: f64, hold: Hold) -> Vec<f64> {
        let (mut q, mut v, mut out) = (0.0, 0.0, vec![0.0]);
        for pair in force.windows(2) {
            let (a, b) = (pair[0], if hold == Hold::Zero { pair[0] } else { pair[1] });
            q += step * v + step * step * (2.0 * a + b) / 6.0;
            v += step * (a + b) / 2.0;
            out.push(q);
        }
        out
    }

    fn means(values: &[f64], count: usize) -> Vec<f64> {
        values.chunks_exact(count).map(|b| b.iter().sum::<f64>() / count as f64).collect()
    }

    #[test]
    fn a_mass_moves_between_blocks_as_its_mean_did() {
        for hold in [Hold::Zero, Hold::First] {
            for count in [2, 3, 10] {
                // far faster than the blocks, and steps
                let force: Vec<f64> =
                    (0..40 * count).map(|k| (0.7 * k as f64).sin() + (0.03 * k as f64).cos() + f64::from(u8::from(k > 133))).collect();
                let q = means(&driven(&force, 1.0, hold), count);
                let block = count as f64;
                let corners = straightened(&force, count, hold);
                for (k, w) in q.windows(3).enumerate() {
                    let seen = (w[2] - 2.0 * w[1] + w[0]) / (block * block);
                    let said = (corners[k] + 4.0 * corners[k + 1] + corners[k + 2]) / 6.0;
                    assert!((seen - said).abs() < 1e-12 * q.last().unwrap().abs(), "{count} {k}: {seen} {said}");
                }
            }
        }
    }

    #[test]
    fn a_constant_stays_and_a_line_moves_by_half_a_sample_where_it_is_held() {
        let line: Vec<f64> = (0..60).map(|k| 3.0 + 0.5 * f64::from(k)).collect();
        for (hold, late) in [(Hold::First, 0.0), (Hold::Zero, 0.25)] {
            for (k, corner) in straightened(&line, 6, hold).iter().enumerate() {
                // a staircase is no line: at the ends, where half a hat is all there is, the middle of a stair is a little off
                assert!((corner - (3.0 + 0.5 * (6.0 * k as f64 + 2.5) - late)).abs() < 0.05, "{k}: {corner}");
            }
            assert!(straightened(&[2.0; 60], 6, hold).iter().all(|c| (c - 2.0).abs() < 1e-12));
        }
    }
}
