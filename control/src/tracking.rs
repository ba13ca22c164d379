//! Feedforward and state feedback on measured angles, as it runs on the rig (eq. 22 to 24 of the seed paper).
//!
//! u = u*(references) - K (x - x*) - K_i z: angles from the encoders (unwrapped), rates from derivative filters, u* from
//! the trim manifold, an outer loop's reference from its cascade, integrals with back-calculation at the limits.

use crate::cascade::Cascade;
use crate::closed_loop::Controller;
use crate::discretize::SampleError;
use crate::feedforward::Feedforward;
use crate::filter::{DerivativeFilter, Rule, Running};
use crate::lqr::Lqr;
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

/// Settings of a tracking controller.
pub struct Setup<'a> {
    /// The regulator; its states are outputs, their rates `y.dot` and integrals `y.integral`, by name.
    pub lqr: &'a Lqr,
    /// How the signals of the model move with the regulator's inputs (signals x inputs).
    pub directions: DMatrix<f64>,
    /// References by output; where there is none it is zero.
    pub references: Vec<(String, Reference<'a>)>,
    /// Inputs that hold references; its held states are those of `held`.
    pub feedforward: Feedforward<'a>,
    /// Outputs whose references the feedforward holds, in its order.
    pub held: Vec<String>,
    /// Filter for rates.
    pub filter: DerivativeFilter,
    /// How it is sampled.
    pub rule: Rule,
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
    Integral { output: usize, value: f64 },
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
    feedforward: Feedforward<'a>,
    held: Vec<usize>,
    period: f64,
    references: Vec<Option<f64>>,
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
        let lqr = setup.lqr;
        if let Some(gain) = lqr.period.filter(|&gain| (gain - setup.period).abs() > 1e-9 * setup.period) {
            return Err(TrackingError::Period { gain, controller: setup.period });
        }
        if setup.directions.shape() != (d.signals(), lqr.inputs.len()) {
            return Err(TrackingError::Directions);
        }
        let columns = lqr
            .states
            .iter()
            .map(|name| match (name.strip_suffix(".integral"), name.strip_suffix(".dot")) {
                (Some(output), _) => Ok(Column::Integral { output: find(output, name)?, value: 0.0 }),
                (None, Some(output)) => Ok(Column::Rate(find(output, name)?)),
                (None, None) => Ok(Column::Angle(find(name, name)?)),
            })
            .collect::<Result<Vec<_>, _>>()?;
        let filter = |f: DerivativeFilter| f.sampled(setup.period, setup.rule).map(Running::new).map_err(TrackingError::Filter);
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
            .map(|i| Ok(Channel { wrapped: model.output_path(i, p).wrapped, last: None, filter: filter(setup.filter)? }))
            .collect::<Result<Vec<_>, TrackingError>>()?;
        let held = setup.held.iter().map(|name| find(name, name)).collect::<Result<Vec<_>, _>>()?;
        let mixing = setup.directions.clone().pseudo_inverse(1e-12).map_err(|_| TrackingError::Directions)?;
        Ok(Self {
            gain: lqr.k.clone(),
            columns,
            anti_windup: lqr.anti_windup.clone(),
            directions: setup.directions,
            mixing,
            sources,
            channels,
            feedforward: setup.feedforward,
            held,
            period: setup.period,
            references: vec![None; d.outputs],
            asked: DVector::zeros(d.signals()),
            errors: vec![0.0; d.outputs],
        })
    }
}

impl Controller for Tracking<'_> {
    fn command(&mut self, t: f64, y: &[f64], u: &mut [f64]) -> Result<(), String> {
        let measured: Vec<(f64, f64)> = self.channels.iter_mut().zip(y).map(|(channel, &value)| channel.read(value)).collect();
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
        let references: Vec<f64> = self.held.iter().map(|&i| wanted[i].unwrap_or_default().0).collect();
        let trim = self.feedforward.at(&references).map_err(|e| e.to_string())?;
        let error = |i: usize| measured[i].0 - wanted[i].unwrap_or_default().0;
        let deviation = DVector::from_iterator(
            self.columns.len(),
            self.columns.iter().map(|column| match column {
                Column::Angle(i) => error(*i),
                Column::Rate(i) => measured[*i].1 - wanted[*i].unwrap_or_default().1,
                Column::Integral { value, .. } => *value,
            }),
        );
        self.asked = DVector::from_vec(trim.u) - &self.directions * (&self.gain * deviation);
        u.iter_mut().zip(self.asked.iter()).for_each(|(u, asked)| *u = *asked);
        self.errors = (0..y.len()).map(error).collect();
        self.references = wanted.iter().map(|w| w.map(|(value, _)| value)).collect();
        Ok(())
    }

    fn applied(&mut self, u: &[f64]) {
        let cut = DVector::from_fn(self.asked.len(), |i, _| u.get(i).map_or(0.0, |u| u - self.asked[i]));
        let back = &self.anti_windup * (&self.mixing * cut);
        let mut k = 0;
        for column in &mut self.columns {
            if let Column::Integral { output, value } = column {
                *value += self.period * (self.errors[*output] + back[k]);
                k += 1;
            }
        }
    }

    fn references(&self) -> &[Option<f64>] {
        &self.references
    }
}
