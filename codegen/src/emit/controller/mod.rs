//! A sampled controller as code: what it is (plain numbers and names), and the parts of its text that languages share.
//!
//! Knows nothing of how it was designed. `rust` and `c` print the same steps: read, estimate rates, references,
//! feedforward, feedback, limits, integrals.

mod c;
mod kalman;
mod rust;
mod schedule;

use crate::emit::names::{Language, Names};
use crate::manifold::Manifold;

pub use c::{ControllerC, controller_c};
pub use kalman::Kalman;
pub use rust::controller_rust;
pub use schedule::{Schedule, schedule_c, schedule_rust};

/// A sampled controller: u = u* - K (x - x*), limited.
#[derive(Clone, Debug)]
pub struct Controller {
    /// Name of the module and of the C prefix: `experiment_1`.
    pub name: String,
    /// One line about it.
    pub title: String,
    /// What it was made from, for the header: file, rig file, first digits of the model's hash.
    pub source: (String, String, String),
    /// Period [s].
    pub period: f64,
    /// Outputs that it reads.
    pub channels: Vec<Channel>,
    /// From an output to its rate, where no Kalman filter knows it.
    pub filter: Filter,
    /// Filter that knows the states.
    pub kalman: Option<Kalman>,
    /// References of channels; a channel without one is held at its `operating` value.
    pub references: Vec<(usize, Source)>,
    /// Columns of K.
    pub columns: Vec<Column>,
    /// Rows of K.
    pub inputs: Vec<String>,
    /// K (inputs x columns).
    pub k: Vec<Vec<f64>>,
    /// Anti-windup gain (integrals x inputs), integrals in the order of `columns`.
    pub anti_windup: Vec<Vec<f64>>,
    /// How the signals move with the inputs (signals x inputs).
    pub directions: Vec<Vec<f64>>,
    /// Inputs of signals (inputs x signals).
    pub mixing: Vec<Vec<f64>>,
    /// What it commands.
    pub signals: Vec<Signal>,
    /// What the feedback is added to.
    pub feedforward: Feedforward,
}

/// An output that is read.
#[derive(Clone, Debug)]
pub struct Channel {
    /// Name in the rig.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// It is read modulo one turn.
    pub wrapped: bool,
    /// What it reads where its coordinate is zero.
    pub zero: f64,
    /// Value and rate where there is no reference.
    pub operating: (f64, f64),
}

/// A sampled filter: output C x + D u, then x <- A x + B u.
#[derive(Clone, Debug, PartialEq)]
pub struct Filter {
    /// A, row by row.
    pub a: Vec<Vec<f64>>,
    /// B.
    pub b: Vec<f64>,
    /// C.
    pub c: Vec<f64>,
    /// D.
    pub d: f64,
    /// Its state in steady state for an input of one.
    pub start: Vec<f64>,
}

/// Where a reference comes from.
#[derive(Clone, Debug)]
pub enum Source {
    /// The caller.
    Given,
    /// An outer loop.
    Inner {
        /// Channel of the outer loop.
        outer: usize,
        /// K_p.
        proportional: f64,
        /// K_d.
        derivative: f64,
        /// Largest modulus, infinite for none.
        limit: f64,
        /// Filter for its rate; zero where `None`.
        rate: Option<Filter>,
    },
}

/// What a column of K multiplies: a channel's error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// Of its value.
    Value(usize),
    /// Of its rate.
    Rate(usize),
    /// Integrated.
    Integral(usize),
    /// A state that only the Kalman filter knows.
    State(usize),
}

/// An input of the rig.
#[derive(Clone, Debug)]
pub struct Signal {
    /// Name in the rig.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Limits, infinite where there are none.
    pub limits: (f64, f64),
}

/// What the feedback is added to.
#[derive(Clone, Debug)]
pub enum Feedforward {
    /// Inputs of the operating point, and why not the trim manifold (empty where it was not asked for).
    Constant(Vec<f64>, String),
    /// The inputs that hold channels at their references (or where they are measured).
    Manifold(Box<Manifold>, Vec<usize>),
}

/// Identifiers of a language for everything with a name.
struct Identifiers {
    channels: Vec<String>,
    signals: Vec<String>,
}

impl Controller {
    fn identifiers(&self, language: Language) -> Identifiers {
        let mut taken =
            vec!["self", "reading", "reference", "deviation", "feedback", "u", "asked", "hold", "cut", "memory", "inputs", "dot", "i"];
        if self.kalman.is_some() {
            taken.extend(kalman::LOCALS);
        }
        let mut names = Names::new(language, &taken);
        let channels = self.channels.iter().map(|c| names.take(&c.name)).collect();
        let mut names = Names::new::<&str>(language, &[]);
        Identifiers { channels, signals: self.signals.iter().map(|s| names.take(&s.name)).collect() }
    }

    fn reference(&self, channel: usize) -> Option<&Source> {
        self.references.iter().find(|(i, _)| *i == channel).map(|(_, source)| source)
    }

    /// Channels whose references the caller gives.
    fn given(&self) -> Vec<usize> {
        (0..self.channels.len()).filter(|&i| matches!(self.reference(i), Some(Source::Given))).collect()
    }

    /// Channels in an order in which outer loops come before inner ones.
    fn ordered(&self) -> Vec<usize> {
        let inner = |i: &usize| matches!(self.reference(*i), Some(Source::Inner { .. }));
        let all = || 0..self.channels.len();
        all().filter(|i| !inner(i)).chain(all().filter(inner)).collect()
    }

    /// Something asks for the rate of this channel.
    fn needs_rate(&self, channel: usize) -> bool {
        self.columns.contains(&Column::Rate(channel)) || self.is_outer(channel)
    }

    /// Something asks where this channel is to be.
    fn needs_target(&self, channel: usize) -> bool {
        let held = matches!(&self.feedforward, Feedforward::Manifold(_, held) if held.contains(&channel));
        let column = |c: &Column| matches!(*c, Column::Value(i) | Column::Rate(i) | Column::Integral(i) if i == channel);
        self.columns.iter().any(column) || self.is_outer(channel) || (held && self.reference(channel).is_some())
    }

    /// The states that the Kalman filter has for a channel's value and rate.
    fn estimated(&self, channel: usize) -> (Option<usize>, Option<usize>) {
        self.kalman.as_ref().and_then(|k| k.shown.get(channel).copied()).unwrap_or_default()
    }

    /// The rate of this channel is filtered from its readings.
    fn filters_rate(&self, channel: usize) -> bool {
        self.needs_rate(channel) && self.estimated(channel).1.is_none()
    }

    /// Some rate is filtered.
    fn has_filters(&self) -> bool {
        (0..self.channels.len()).any(|i| self.filters_rate(i))
            || self.references.iter().any(|(_, s)| matches!(s, Source::Inner { rate: Some(_), .. }))
    }

    /// Something asks where this channel is: all but those that only the Kalman filter reads.
    fn is_used(&self, channel: usize) -> bool {
        self.kalman.is_none()
            || self.needs_target(channel)
            || matches!(&self.feedforward, Feedforward::Manifold(_, held) if held.contains(&channel))
    }

    fn is_outer(&self, channel: usize) -> bool {
        self.references.iter().any(|(_, s)| matches!(s, Source::Inner { outer, .. } if *outer == channel))
    }

    fn integrals(&self) -> Vec<usize> {
        self.columns.iter().filter_map(|c| if let Column::Integral(i) = c { Some(*i) } else { None }).collect()
    }

    /// Header: what it is, where it comes from.
    fn header(&self) -> Vec<String> {
        let (file, rig, hash) = &self.source;
        let columns: Vec<String> = self
            .columns
            .iter()
            .map(|c| match *c {
                Column::Value(i) => self.channels[i].name.clone(),
                Column::Rate(i) => format!("{}'", self.channels[i].name),
                Column::Integral(i) => format!("integral of {}", self.channels[i].name),
                Column::State(k) => self.kalman.as_ref().map_or_else(String::new, |filter| filter.states[k].clone()),
            })
            .collect();
        let feedforward = match &self.feedforward {
            Feedforward::Constant(_, why) if why.is_empty() => "u* are the inputs of the operating point.".to_owned(),
            Feedforward::Constant(_, why) => {
                format!("u* are the inputs of the operating point: there is no closed form of the trim manifold, since {why}.")
            }
            Feedforward::Manifold(_, held) => {
                let names: Vec<&str> = held.iter().map(|&i| self.channels[i].name.as_str()).collect();
                format!("u* holds {} where they are to be: the trim manifold in closed form.", names.join(", "))
            }
        };
        let mut lines = vec![
            format!("{}.", self.title.trim_end_matches('.')),
            format!("Generated from `{file}` and `{rig}` (model {hash}); edit these, not this file."),
            String::new(),
            format!(
                "Every {:?} s: u = u* - K (x - x*), limited; x = ({}), K in ({}).",
                self.period,
                columns.join(", "),
                self.inputs.join(", ")
            ),
            feedforward,
        ];
        lines.extend(self.kalman.as_ref().map(kalman::about));
        lines.push("Units are SI and radians. No heap, no input or output.".to_owned());
        lines
    }
}

/// `1.0, 2.0`.
fn list(values: &[f64]) -> String {
    values.iter().map(|x| super::form::number(*x)).collect::<Vec<_>>().join(", ")
}

/// A unit for documentation.
fn unit(text: &str) -> &str {
    if text.is_empty() { "1" } else { text }
}
