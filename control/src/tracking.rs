//! Feedforward and state feedback on measured angles, as it runs on the rig (eq. 22 to 24 of the seed paper).
//!
//! u = u*(references) - K (x - x*) - K_i z: angles from the encoders (unwrapped), rates by an [`Estimation`], u* from the
//! trim manifold or of the operating point, an outer loop's reference from its cascade, integrals with back-calculation
//! at the limits.

use crate::cascade::Cascade;
use crate::closed_loop::Controller;
use crate::discretize::SampleError;
use crate::estimator::{Estimation, KalmanEstimator};
use crate::feedforward::Feedforward;
use crate::filter::{DerivativeFilter, Rule, Running};
use crate::gain::Gain;
use nalgebra::{DMatrix, DVector};
use runtime::Model;
use std::fmt;

/// Value and rate of a reference at a time [s].
pub type Trajectory<'a> = Box<dyn Fn(f64) -> (f64, f64) + 'a>;

/// Where the reference of an output comes from.
pub enum Reference<'a> {
    /// A function of time.
    Given(Trajectory<'a>),
    /// The output of a cascade whose outer output (which has a given reference) is named.
    Inner {
        /// The law.
        law: Cascade,
        /// The outer output.
        outer: String,
        /// Rate of this reference.
        rate: InnerRate,
    },
}

/// The rate of an inner reference, which nobody gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InnerRate {
    /// Zero: the feedback damps the inner coordinate's own rate.
    Zero,
    /// By a derivative filter on the reference.
    Filtered(DerivativeFilter),
}

/// The inputs that the feedback is added to.
pub enum Holding<'a> {
    /// Those of the operating point (one for each signal of the model).
    Point(Vec<f64>),
    /// Those that hold the references of these outputs, in the order of the feedforward's held states; an output without
    /// reference is held where it is measured.
    Manifold(Feedforward<'a>, Vec<String>),
}

/// What the deviations are taken from where there is no reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Operating {
    /// Value and rate of each output, in terms of its coordinate where it shows one.
    pub outputs: Vec<(f64, f64)>,
    /// What each output reads where its coordinate is zero (an encoder that was switched on elsewhere).
    pub zeros: Vec<f64>,
    /// States of the model that a Kalman filter estimates, by name, with their values.
    pub states: Vec<(String, f64)>,
}

/// Settings of a tracking controller.
pub struct Setup<'a> {
    /// The gain; its states are outputs, their rates `y.dot` and integrals `y.integral`, by name; with a Kalman filter any
    /// state of its model.
    pub gain: Gain,
    /// How the signals of the model move with the gain's inputs (signals x inputs).
    pub directions: DMatrix<f64>,
    /// References by output, in terms of its coordinate; where there is none, that of the operating point.
    pub references: Vec<(String, Reference<'a>)>,
    /// The operating point.
    pub operating: Operating,
    /// Inputs to start from.
    pub holding: Holding<'a>,
    /// Where rates come from.
    pub estimation: Estimation,
    /// Period [s].
    pub period: f64,
}

/// Why a tracking controller cannot be built.
#[derive(Clone, Debug, PartialEq)]
pub enum TrackingError {
    /// Something that the model does not measure.
    NotMeasured {
        /// What.
        name: String,
        /// What it does measure.
        outputs: Vec<String>,
    },
    /// An inner reference whose outer output has no reference of its own.
    OuterReference {
        /// The outer output.
        name: String,
    },
    /// The directions of inputs do not fit the model and the regulator.
    Directions,
    /// The gain was designed for another period.
    Period {
        /// Period of the gain [s].
        gain: f64,
        /// Period of the controller [s].
        controller: f64,
    },
    /// The filter cannot be sampled like this.
    Filter(SampleError),
}

impl fmt::Display for TrackingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotMeasured { name, outputs } => write!(f, "`{name}` is not measured; the outputs are {}", outputs.join(", ")),
            Self::OuterReference { name } => write!(f, "the outer loop needs a reference over time for `{name}`"),
            Self::Directions => f.write_str("the inputs of the gain do not fit the inputs of the model"),
            Self::Period { gain, controller } => {
                write!(f, "the gain was designed for a period of {gain} s, the controller runs at {controller} s")
            }
            Self::Filter(e) => e.fmt(f),
        }
    }
}

impl std::error::Error for TrackingError {}

/// What a column of the gain multiplies.
enum Column {
    Angle(usize),
    Rate(usize),
    Integral {
        output: usize,
        value: f64,
    },
    /// A state that only a Kalman filter knows, and its operating value.
    Estimated(usize, f64),
}

/// An angle, unwrapped, with its rate.
struct Channel {
    wrapped: bool,
    last: Option<f64>,
    filter: Running,
}

impl Channel {
    fn read(&mut self, value: f64) -> (f64, f64) {
        let turn = std::f64::consts::TAU;
        let angle = match self.last {
            Some(last) if self.wrapped => value + turn * ((last - value) / turn).round(),
            _ => value,
        };
        self.last = Some(angle);
        (angle, self.filter.next(angle))
    }
}

enum Source<'a> {
    None,
    Given(Trajectory<'a>),
    Inner { law: Cascade, outer: usize, rate: Option<Box<Running>> },
}

/// A tracking controller.
pub struct Tracking<'a> {
    gain: DMatrix<f64>,
    columns: Vec<Column>,
    anti_windup: DMatrix<f64>,
    directions: DMatrix<f64>,
    /// From signals to the regulator's inputs.
    mixing: DMatrix<f64>,
    sources: Vec<Source<'a>>,
    channels: Vec<Channel>,
    holding: Holding<'a>,
    held: Vec<usize>,
    operating: Vec<(f64, f64)>,
    zeros: Vec<f64>,
    kalman: Option<Box<KalmanEstimator>>,
    /// For each output, the states of the Kalman filter that are its value and its rate.
    estimated: Vec<(Option<usize>, Option<usize>)>,
    period: f64,
    references: Vec<Option<(f64, f64)>>,
    rates: Vec<f64>,
    asked: DVector<f64>,
    errors: Vec<f64>,
}

impl<'a> Tracking<'a> {
    /// Builds the controller for a model with parameters `p`.
    ///
    /// # Errors
    /// [`TrackingError`], one variant a cause.
    pub fn new(model: &dyn Model, p: &[f64], setup: Setup<'a>) -> Result<Self, TrackingError> {
        let d = model.dimensions();
        let outputs: Vec<String> = (0..d.outputs).map(|i| model.names().output(i).to_owned()).collect();
        let find = |name: &str, whole: &str| {
            outputs
                .iter()
                .position(|o| o == name)
                .ok_or_else(|| TrackingError::NotMeasured { name: whole.to_owned(), outputs: outputs.clone() })
        };
        let gain = setup.gain;
        if let Some(designed) = gain.period.filter(|&designed| (designed - setup.period).abs() > 1e-9 * setup.period) {
            return Err(TrackingError::Period { gain: designed, controller: setup.period });
        }
        if setup.directions.shape() != (d.signals(), gain.inputs.len())
            || setup.operating.outputs.len() != d.outputs
            || setup.operating.zeros.len() != d.outputs
        {
            return Err(TrackingError::Directions);
        }
        let known = |name: &str| setup.operating.states.iter().position(|(s, _)| s == name);
        let kalman = if let Estimation::Kalman(estimator) = &setup.estimation { Some(estimator.clone()) } else { None };
        let columns = gain
            .states
            .iter()
            .map(|name| match (name.strip_suffix(".integral"), name.strip_suffix(".dot")) {
                (Some(output), _) => Ok(Column::Integral { output: find(output, name)?, value: 0.0 }),
                (None, Some(output)) if outputs.iter().any(|o| o == output) => Ok(Column::Rate(find(output, name)?)),
                (None, None) if outputs.iter().any(|o| o == name) => Ok(Column::Angle(find(name, name)?)),
                _ => match known(name).filter(|_| kalman.is_some()) {
                    Some(k) => Ok(Column::Estimated(k, setup.operating.states[k].1)),
                    None => Err(TrackingError::NotMeasured { name: name.clone(), outputs: outputs.clone() }),
                },
            })
            .collect::<Result<Vec<_>, _>>()?;
        let filter = |f: DerivativeFilter| f.sampled(setup.period, Rule::ZeroOrderHold).map(Running::new).map_err(TrackingError::Filter);
        let mut sources: Vec<Source<'a>> = (0..d.outputs).map(|_| Source::None).collect();
        for (name, reference) in setup.references {
            sources[find(&name, &name)?] = match reference {
                Reference::Given(trajectory) => Source::Given(trajectory),
                Reference::Inner { law, outer, rate } => {
                    let rate = match rate {
                        InnerRate::Zero => None,
                        InnerRate::Filtered(f) => Some(Box::new(filter(f)?)),
                    };
                    Source::Inner { law, outer: find(&outer, &outer)?, rate }
                }
            };
        }
        for source in &sources {
            if let Source::Inner { outer, .. } = source
                && !matches!(sources[*outer], Source::Given(_))
            {
                return Err(TrackingError::OuterReference { name: outputs[*outer].clone() });
            }
        }
        let channels = (0..d.outputs)
            .map(|i| {
                Ok(Channel {
                    wrapped: model.output_path(i, p).wrapped,
                    last: None,
                    filter: Running::new(setup.estimation.of_one_angle(setup.period).map_err(TrackingError::Filter)?),
                })
            })
            .collect::<Result<Vec<_>, TrackingError>>()?;
        let held = match &setup.holding {
            Holding::Point(_) => Vec::new(),
            Holding::Manifold(_, names) => names.iter().map(|name| find(name, name)).collect::<Result<Vec<_>, _>>()?,
        };
        let estimated = outputs.iter().map(|o| (known(o), known(&format!("{o}.dot")))).collect();
        let mixing = setup.directions.clone().pseudo_inverse(1e-12).map_err(|_| TrackingError::Directions)?;
        Ok(Self {
            gain: gain.k,
            columns,
            anti_windup: gain.anti_windup,
            directions: setup.directions,
            mixing,
            sources,
            channels,
            holding: setup.holding,
            held,
            operating: setup.operating.outputs,
            zeros: setup.operating.zeros,
            kalman,
            estimated,
            period: setup.period,
            references: vec![None; d.outputs],
            rates: vec![0.0; d.outputs],
            asked: DVector::zeros(d.signals()),
            errors: vec![0.0; d.outputs],
        })
    }
}

impl Controller for Tracking<'_> {
    fn command(&mut self, t: f64, y: &[f64], u: &mut [f64]) -> Result<(), String> {
        let mut measured: Vec<(f64, f64)> = self.channels.iter_mut().zip(y).map(|(channel, &value)| channel.read(value)).collect();
        let mut state = DVector::zeros(0);
        let shown: Vec<f64> = measured.iter().zip(&self.zeros).map(|(m, zero)| m.0 - zero).collect();
        if let Some(kalman) = &mut self.kalman {
            let readings: Vec<f64> = measured.iter().map(|m| m.0).collect();
            state = kalman.read(&readings);
            for (m, (angle, rate)) in measured.iter_mut().zip(&self.estimated) {
                let of = |i: &Option<usize>, or: f64| i.and_then(|i| state.get(i).copied()).unwrap_or(or);
                *m = (of(angle, m.0), of(rate, m.1));
            }
        }
        for ((m, shown), (angle, _)) in measured.iter_mut().zip(&shown).zip(&self.estimated) {
            if self.kalman.is_none() || angle.is_none() {
                m.0 = *shown;
            }
        }
        let given: Vec<Option<(f64, f64)>> =
            self.sources.iter().map(|s| if let Source::Given(f) = s { Some(f(t)) } else { None }).collect();
        let wanted: Vec<Option<(f64, f64)>> = self
            .sources
            .iter_mut()
            .enumerate()
            .map(|(i, source)| match source {
                Source::None => None,
                Source::Given(_) => given[i],
                Source::Inner { law, outer, rate } => {
                    let (value, slope) = given[*outer].unwrap_or_default();
                    let inner = law.reference(value - measured[*outer].0, slope - measured[*outer].1);
                    Some((inner, rate.as_mut().map_or(0.0, |filter| filter.next(inner))))
                }
            })
            .collect();
        let base = match &mut self.holding {
            Holding::Point(u) => u.clone(),
            Holding::Manifold(feedforward, _) => {
                let references: Vec<f64> = self.held.iter().map(|&i| wanted[i].map_or(measured[i].0, |w| w.0)).collect();
                feedforward.at(&references).map_err(|e| e.to_string())?.u
            }
        };
        let target = |i: usize| wanted[i].unwrap_or(self.operating[i]);
        let error = |i: usize| measured[i].0 - target(i).0;
        let deviation = DVector::from_iterator(
            self.columns.len(),
            self.columns.iter().map(|column| match column {
                Column::Angle(i) => error(*i),
                Column::Rate(i) => measured[*i].1 - target(*i).1,
                Column::Integral { value, .. } => *value,
                Column::Estimated(k, at) => state.get(*k).copied().unwrap_or(f64::NAN) - at,
            }),
        );
        self.asked = DVector::from_vec(base) - &self.directions * (&self.gain * deviation);
        u.iter_mut().zip(self.asked.iter()).for_each(|(u, asked)| *u = *asked);
        self.errors = (0..y.len()).map(error).collect();
        self.references = wanted.iter().zip(&self.zeros).map(|(w, zero)| w.map(|(value, rate)| (value + zero, rate))).collect();
        self.rates = measured.iter().map(|m| m.1).collect();
        Ok(())
    }

    fn applied(&mut self, u: &[f64]) {
        let cut = DVector::from_fn(self.asked.len(), |i, _| u.get(i).map_or(0.0, |u| u - self.asked[i]));
        if let Some(kalman) = &mut self.kalman {
            let whole = DVector::from_fn(self.asked.len(), |i, _| u.get(i).map_or(self.asked[i], |u| *u));
            kalman.hold(&(&self.mixing * whole));
        }
        let back = &self.anti_windup * (&self.mixing * cut);
        let mut k = 0;
        for column in &mut self.columns {
            if let Column::Integral { output, value } = column {
                *value += self.period * (self.errors[*output] + back[k]);
                k += 1;
            }
        }
    }

    fn references(&self) -> &[Option<(f64, f64)>] {
        &self.references
    }

    fn rates(&self) -> &[f64] {
        &self.rates
    }
}
