//! Sensors with play in the filter: the reading is a state more, which stands until the motion has gone through the play.
//!
//! With e = y - r, the reading moves by e - clamp(e, -w/2, w/2). For a normal e with mean and spread of the prediction this has a mean, and a
//! line that fits it best (statistical linearization: Gelb, Applied Optimal Estimation, 1974, 6.2), both smooth in w down to no play at all.

use super::filter::Column;
use super::transition::by_parameter;
use runtime::Model;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// What a reading does when the motion is `e` from it, for a normal e.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slack {
    /// Mean of its move.
    pub mean: f64,
    /// Slope of its move by e.
    pub slope: f64,
    /// Variance about the line.
    pub rest: f64,
    /// Derivative of the mean by the width of the play.
    pub by_width: f64,
}

impl Slack {
    /// For an e of mean `e` and standard deviation `sd`, and play of `width`.
    pub fn new(e: f64, sd: f64, width: f64) -> Self {
        let half = 0.5 * width;
        let (above, below) = ((half - e) / sd, (-half - e) / sd);
        if width == 0.0 {
            // it goes along, however well the motion is known
            let side = if e == 0.0 { 0.0 } else { 1.0 - 2.0 * tail(e / sd) };
            return Self { mean: e, slope: 1.0, rest: 0.0, by_width: -0.5 * side };
        }
        if !(above.is_finite() && below.is_finite() && above - below < 1e12) {
            // nothing is uncertain
            let moved = e - e.clamp(-half, half);
            let beyond = if moved == 0.0 { 0.0 } else { moved.signum() };
            return Self { mean: moved, slope: beyond.abs(), rest: 0.0, by_width: -0.5 * beyond };
        }
        let (over, under) = (tail(above), tail(-below));
        let (at_over, at_under) = (density(above), density(below));
        let mean = sd * (at_over - above * over) - sd * (at_under + below * under);
        let slope = over + under;
        let square = sd * sd * ((1.0 + above * above) * over - above * at_over + (1.0 + below * below) * under + below * at_under);
        let rest = (square - mean * mean - slope * slope * sd * sd).max(0.0);
        Self { mean, slope, rest, by_width: -0.5 * (over - under) }
    }
}

/// Probability that a standard normal number is larger.
fn tail(x: f64) -> f64 {
    0.5 * statrs::function::erf::erfc(x * FRAC_1_SQRT_2)
}

fn density(x: f64) -> f64 {
    (-0.5 * x * x).exp() / (2.0 * PI).sqrt()
}

/// A reading behind play, as the filter knows it.
#[derive(Clone, Debug)]
pub(crate) struct Reading {
    pub output: usize,
    /// Play.
    pub width: f64,
    /// Where it is thought to stand.
    pub value: f64,
    /// Variance of that.
    pub variance: f64,
    /// Covariance with states and disturbances.
    pub with: Vec<f64>,
    /// Its derivatives by the columns.
    pub by: Vec<f64>,
    /// Derivatives of the play by the columns.
    widths: Vec<(usize, f64)>,
}

impl Reading {
    /// Readings of the model's outputs that have play, or could have by their parameters.
    pub fn all(model: &dyn Model, p: &[f64], outputs: &[usize], columns: &[Column<'_>], order: usize) -> Vec<Self> {
        let elsewhere: Vec<f64> = p.iter().map(|p| p + (1e-3 * p.abs()).max(1e-6)).collect();
        let play = |o: usize, p: &[f64]| model.output_path(o, p).play;
        let mut all: Vec<Self> = outputs
            .iter()
            .filter(|&&output| play(output, p) > 0.0 || play(output, &elsewhere) != play(output, p))
            .map(|&output| {
                let width = play(output, p).max(0.0);
                Self { output, width, value: 0.0, variance: 0.0, with: vec![0.0; order], by: vec![0.0; columns.len()], widths: Vec::new() }
            })
            .collect();
        if all.is_empty() {
            return all;
        }
        for (column, of) in columns.iter().enumerate() {
            let (Column::Parameter(i) | Column::Weighted(i, _)) = of else { continue };
            for (output, slope) in by_parameter(p, *i, model.dimensions().outputs, play) {
                if let Some(own) = all.iter_mut().find(|own| own.output == output) {
                    own.widths.push((column, slope));
                }
            }
        }
        all
    }

    /// Begins where it is `known` to stand, or somewhere within the play about the motion's `value`, whose covariance with the states and
    /// variance follow; `c` are its derivatives by the states, `row` those by the columns with their sign turned.
    pub fn begin(&mut self, known: Option<&Self>, value: f64, (with, variance): (&[f64], f64), (c, row): (&[f64], &[f64])) {
        if let Some(known) = known {
            (self.value, self.variance) = (known.value, known.variance);
            // initial states are known apart from each other: of the covariance, what the motion itself has
            self.with.fill(0.0);
            self.with.iter_mut().zip(&known.with).zip(c).filter(|(_, c)| **c != 0.0).for_each(|((own, known), _)| *own = *known);
            return;
        }
        (self.value, self.variance) = (value, variance + self.width.powi(2) / 12.0);
        self.with.copy_from_slice(with);
        self.by.iter_mut().zip(row).for_each(|(by, row)| *by = -row);
    }

    /// Goes on with the states.
    pub fn go_on(&mut self, transition: &[f64]) {
        let order = self.with.len();
        self.with = transition.chunks_exact(order).map(|row| row.iter().zip(&self.with).map(|(f, w)| f * w).sum()).collect();
    }

    /// Goes on with the motion to where it will be read: `with` is the covariance of the motion with the states, `variance` its own and
    /// `cross` its covariance with this reading.
    pub fn follow(&mut self, slack: &Slack, with: &[f64], variance: f64, cross: f64) {
        let (g, stay) = (slack.slope, 1.0 - slack.slope);
        self.value += slack.mean;
        self.variance = stay * stay * self.variance + g * (2.0 * stay * cross + g * variance) + slack.rest;
        self.with.iter_mut().zip(with).for_each(|(own, with)| *own = stay * *own + g * with);
    }

    /// `row`, the derivatives of the motion with their sign turned, becomes that of the reading; `weight` is that of a column.
    pub fn turn(&mut self, slack: &Slack, weight: impl Fn(usize) -> f64, row: &mut [f64]) {
        self.by.iter_mut().zip(&*row).for_each(|(by, row)| *by = (1.0 - slack.slope) * *by - slack.slope * row);
        for &(column, slope) in &self.widths {
            self.by[column] += slack.by_width * slope * weight(column);
        }
        row.iter_mut().zip(&self.by).for_each(|(row, by)| *row = -by);
    }

    /// A value was measured whose covariance with this reading is `of`, with the states `with`, and whose variance is `total`.
    pub fn learn(&mut self, of: f64, with: &[f64], total: f64) {
        self.variance -= of * of / total;
        self.with.iter_mut().zip(with).for_each(|(own, with)| *own -= of * with / total);
    }
}

#[cfg(test)]
mod tests {
    use super::Slack;

    /// Means over a fine grid of normal numbers.
    fn by_quadrature(e: f64, sd: f64, width: f64) -> (f64, f64, f64) {
        let (mut mean, mut square, mut along, mut total) = (0.0, 0.0, 0.0, 0.0);
        for k in -40_000..=40_000 {
            let z = f64::from(k) * 2e-4;
            let weight = (-0.5 * z * z).exp();
            let at = e + sd * z;
            let moved = at - at.clamp(-0.5 * width, 0.5 * width);
            mean += weight * moved;
            square += weight * moved * moved;
            along += weight * moved * z;
            total += weight;
        }
        let (mean, slope) = (mean / total, along / total / sd);
        (mean, slope, square / total - mean * mean - slope * slope * sd * sd)
    }

    #[test]
    fn a_reading_behind_play_moves_as_its_mean_over_normal_numbers() {
        for (e, sd, width) in [(0.3, 0.5, 1.0), (-2.0, 0.4, 1.0), (0.0, 1.0, 0.2), (1.1, 0.1, 2.0), (5.0, 1.0, 0.0)] {
            let s = Slack::new(e, sd, width);
            let (mean, slope, rest) = by_quadrature(e, sd, width);
            assert!(
                (s.mean - mean).abs() < 1e-6 && (s.slope - slope).abs() < 1e-4 && (s.rest - rest).abs() < 1e-5,
                "{s:?} {mean} {slope} {rest}"
            );
            let h = 1e-5;
            let by = (Slack::new(e, sd, width + h).mean - Slack::new(e, sd, width - h).mean) / (2.0 * h);
            assert!((s.by_width - by).abs() < 1e-6, "{} {by}", s.by_width);
        }
    }

    #[test]
    fn without_play_it_goes_along() {
        for (e, sd) in [(0.0, 0.0), (0.3, 0.0), (0.3, 0.5), (-2.0, 0.1)] {
            let s = Slack::new(e, sd, 0.0);
            assert_eq!((s.mean, s.slope, s.rest), (e, 1.0, 0.0));
            let near = Slack::new(e, sd.max(1e-9), 1e-12);
            assert!(sd == 0.0 || (s.by_width - near.by_width).abs() < 1e-6, "{s:?} {near:?}");
        }
    }

    #[test]
    fn where_nothing_is_uncertain_it_is_the_play_itself() {
        for (e, mean, slope, by) in [(0.2, 0.0, 0.0, 0.0), (1.5, 1.0, 1.0, -0.5), (-0.9, -0.4, 1.0, 0.5)] {
            for sd in [0.0, 1e-9] {
                let s = Slack::new(e, sd, 1.0);
                assert!(
                    (s.mean - mean).abs() < 1e-12 && (s.slope - slope).abs() < 1e-12 && (s.by_width - by).abs() < 1e-12,
                    "{e} {sd}: {s:?}"
                );
            }
        }
    }
}
