//! The model as judge: how much of the measured accelerations it leaves unexplained, with its parameters refitted.
//!
//! The weak form of equation error: no derivative of a coarse encoder is taken, no run is needed, so that unstable rigs and
//! wrong parameters are judged alike. Parameters may move by a factor of [`FREEDOM`] but keep their signs: a model that may
//! turn a gain over explains a turned sensor too.

use super::change::Change;
use crate::compare::is_angle;
use crate::compare::series::unwrap;
use crate::fit::{Data, FitError, Limits, ParameterSpec, Preparation, unexplained};
use crate::record::Record;
use runtime::Model;
use sim::Hold;

/// Parameters of a rig are known at least to this factor.
const FREEDOM: f64 = 4.0;
/// Samples to which a long record is thinned out, and samples of a window at least.
const SAMPLES: usize = 400;
const WINDOW_SAMPLES: usize = 24;

/// How well the model explains a record.
#[derive(Clone, Debug)]
pub(super) struct Judgement {
    /// For each coordinate the unexplained part of its accelerations: power of the error over power of the measured side.
    pub unexplained: Vec<(String, f64)>,
    /// For each coordinate the windows that do not overlap by more than half: about so many independent equations.
    pub windows: Vec<f64>,
    /// Parameters that explain it so well.
    pub p: Vec<f64>,
}

impl Judgement {
    /// ln of the product of the unexplained parts: the log-likelihood of errors of unknown size, but for a factor.
    pub fn score(&self, without: &[usize]) -> f64 {
        self.unexplained.iter().enumerate().filter(|(i, _)| !without.contains(i)).map(|(_, (_, e))| e.max(1e-12).ln()).sum()
    }

    /// ln of the likelihood ratio against another judgement, for normal errors of unknown size.
    pub fn evidence(&self, against: &Self, without: &[usize]) -> f64 {
        let gain = |i: usize| (against.unexplained[i].1.max(1e-12) / self.unexplained[i].1.max(1e-12)).ln();
        (0..self.windows.len()).filter(|i| !without.contains(i)).map(|i| 0.5 * self.windows[i] * gain(i)).sum()
    }

    /// Coordinates whose equation says nothing: they do not move.
    pub fn silent(&self) -> Vec<usize> {
        (0..self.unexplained.len()).filter(|&i| !self.unexplained[i].1.is_finite()).collect()
    }

    /// The largest unexplained part, as a ratio of amplitudes.
    pub fn worst(&self) -> f64 {
        self.unexplained.iter().map(|(_, e)| *e).filter(|e| e.is_finite()).fold(0.0_f64, f64::max).sqrt()
    }
}

/// Judges records of one model.
pub(super) struct Judge<'a> {
    pub model: &'a dyn Model,
    pub specs: &'a [ParameterSpec],
    pub hold: Hold,
    /// For each coordinate the length of its windows [s]: a slow motion under short ones is all noise.
    pub windows: Vec<f64>,
}

impl Judge<'_> {
    /// The model beside the record after some changes.
    pub fn judge(&self, record: &Record, changes: &[Change]) -> Result<Judgement, FitError> {
        let mut changed = record.clone();
        let mut specs = self.held();
        for change in changes {
            changed = change.apply(&changed);
            if let Change::SignOfParameter(name) = change {
                specs.iter_mut().filter(|s| s.name == *name).for_each(|s| {
                    s.value = -s.value;
                    s.bounds = s.bounds.map(|(lo, hi)| (-hi, -lo));
                });
            }
        }
        let limits = Limits { evaluations: 6, gradient: 1e-4, step: 1e-3, cost: 1e-4 };
        let mut lengths = self.windows.clone();
        lengths.sort_by(f64::total_cmp);
        lengths.dedup();
        let mut found = Judgement { unexplained: Vec::new(), windows: Vec::new(), p: Vec::new() };
        for length in lengths {
            let thin = self.thinned(&changed, length);
            let period = thin.duration() / (thin.t.len() - 1).max(1) as f64;
            let window = ((length / period).round() as usize).max(8);
            let data = [Data::new(&thin, self.model, self.hold)?];
            let (errors, p) = unexplained(self.model, &specs, &data, Preparation::WeakForm { window }, &limits)?;
            if found.unexplained.is_empty() {
                found =
                    Judgement { unexplained: errors.iter().map(|(n, _)| (n.clone(), 0.0)).collect(), windows: vec![0.0; errors.len()], p };
            }
            for (i, (_, e)) in errors.into_iter().enumerate().filter(|(i, _)| self.windows[*i] == length) {
                found.unexplained[i].1 = (e / 100.0).powi(2);
                found.windows[i] = record.duration() / (0.5 * length);
            }
        }
        Ok(found)
    }

    /// The parameters, each within a factor and with its sign.
    fn held(&self) -> Vec<ParameterSpec> {
        let mut specs = self.specs.to_vec();
        for s in &mut specs {
            s.prior_sd = None;
            if !s.free {
                continue;
            }
            let (a, b) = (s.value / FREEDOM, s.value * FREEDOM);
            let (lo, hi) = s.bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            let bounds = (a.min(b).max(lo), a.max(b).min(hi));
            // a value of zero has no factor: it stays
            s.free = bounds.0 < bounds.1 && (bounds.0..=bounds.1).contains(&s.value);
            s.bounds = s.free.then_some(bounds);
        }
        specs
    }

    /// Means over neighbouring samples where there are many: they take noise and steps out, and time.
    fn thinned(&self, record: &Record, window: f64) -> Record {
        let wanted = SAMPLES.max((record.duration() / window * WINDOW_SAMPLES as f64).ceil() as usize);
        let every = record.t.len() / wanted;
        let mut r = record.clone();
        let names = self.model.names();
        let angles: Vec<&str> =
            (0..self.model.dimensions().outputs).filter(|&i| is_angle(names.output_unit(i))).map(|i| names.output(i)).collect();
        r.columns.iter_mut().filter(|c| angles.contains(&c.name.as_str())).for_each(|c| unwrap(&mut c.values));
        if every < 2 {
            return r;
        }
        let means = |v: &[f64]| v.chunks_exact(every).map(|c| c.iter().sum::<f64>() / every as f64).collect::<Vec<f64>>();
        r.t = means(&r.t);
        r.columns.iter_mut().for_each(|c| c.values = means(&c.values));
        r
    }
}
