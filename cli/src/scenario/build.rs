//! From a scenario's keys to the plant, its start and what comes from outside.

use crate::failure::Failure;
use crate::load::{self, Loaded};
use crate::operating::{self, Found};
use crate::point::Given;
use crate::scenario::file::{Assignments, File, Functions, Point, Value};
use crate::scenario::source::{Source, Wrong};
use codegen::{Layout, Options, TimeFunction};
use control::{Bench, Noise, Signal, Surroundings};
use jit::InProcess;
use model_dsl::nearest;
use model_dsl::units::Unit;
use std::ops::Range;
use toml::Spanned;

/// A rig with its model.
pub struct Machine {
    /// The checked rig.
    pub loaded: Loaded,
    /// The model.
    pub model: InProcess,
}

impl Machine {
    /// Names and sizes.
    pub fn layout(&self) -> &Layout {
        &self.model.equations().layout
    }

    /// Parameters.
    pub fn p(&self) -> &[f64] {
        &self.layout().nominal
    }
}

/// A scenario that was read, with its text.
pub struct Scenario {
    /// The text.
    pub source: Source,
    /// The keys.
    pub file: File,
}

/// Functions of time, with the index of what each is for.
type Indexed = Vec<(usize, TimeFunction)>;

impl Scenario {
    /// Reads the keys.
    pub fn parse(source: Source) -> Result<Self, Failure> {
        let file: File = toml::from_str(source.text()).map_err(|e| source.toml(&e))?;
        Ok(Self { source, file })
    }

    /// The rig that is controlled.
    pub fn plant(&self) -> Result<Machine, Failure> {
        self.machine(&self.file.rig, &[&self.file.set])
    }

    /// The rig that the controller is designed for, if it is another one.
    pub fn design(&self) -> Result<Option<Machine>, Failure> {
        let controller = self.file.controller.get_ref();
        match &controller.rig {
            Some(rig) => self.machine(rig, &[&controller.set]).map(Some),
            None if controller.set.is_empty() => Ok(None),
            None => self.machine(&self.file.rig, &[&self.file.set, &controller.set]).map(Some),
        }
    }

    fn machine(&self, rig: &Spanned<String>, sets: &[&Assignments]) -> Result<Machine, Failure> {
        let path = self.source.folder.join(rig.get_ref());
        if !path.is_file() {
            return Err(self.source.wrong(
                &rig.span(),
                Wrong { message: format!("there is no rig {}", path.display()), label: "looked up beside the scenario", help: None },
            ));
        }
        let texts: Vec<String> = sets.iter().flat_map(|set| assignments(set)).collect();
        let blamed = |failure: Failure| match sets.iter().rev().find_map(|set| culprit(set, &failure)) {
            Some(span) => self.source.caused(&span, &failure),
            None => failure,
        };
        let loaded = load::load_path(&path, None, &texts, self.file.expand_lumps).map_err(blamed)?;
        let model = InProcess::new(load::equations(&loaded, Options::default())?);
        Ok(Machine { loaded, model })
    }

    /// A value with a unit.
    pub fn quantity(&self, value: &Spanned<Value>, unit: &Unit) -> Result<f64, Failure> {
        let text = match value.get_ref() {
            Value::Number(x) => format!("{x:?}"),
            Value::Text(text) => text.clone(),
        };
        model_dsl::parse_value(&text, unit)
            .map_err(|message| self.source.wrong(&value.span(), Wrong { message, label: "here", help: None }))
    }

    /// Seconds.
    pub fn seconds(&self, value: &Spanned<Value>) -> Result<f64, Failure> {
        self.quantity(value, &unit("s"))
    }

    /// A name among others.
    pub fn index(&self, what: &str, name: &Spanned<String>, known: &[String]) -> Result<usize, Failure> {
        known.iter().position(|k| k == name.get_ref()).ok_or_else(|| {
            let near = nearest(name.get_ref(), known.iter().map(String::as_str));
            let help = match near {
                Some(near) => Some(format!("did you mean `{near}`?")),
                None if known.is_empty() => None,
                None => Some(format!("it has {}", known.join(", "))),
            };
            let message = format!("the rig has no {what} `{}`", name.get_ref());
            self.source.wrong(&name.span(), Wrong { message, label: "unknown", help })
        })
    }

    /// The operating point of a table.
    pub fn point(
        &self,
        machine: &Machine,
        trim: Option<&Spanned<String>>,
        at: &Assignments,
        table: &Range<usize>,
    ) -> Result<Found, Failure> {
        let point = crate::args::Point { trim: trim.map(|t| t.get_ref().clone()), at: assignments(at) };
        operating::find(&machine.loaded, &machine.model, &point).map_err(|failure| {
            let span = culprit(at, &failure).or_else(|| trim.map(Spanned::span)).unwrap_or_else(|| table.clone());
            self.source.caused(&span, &failure)
        })
    }

    /// A function of time.
    pub fn function(&self, machine: &Machine, value: &Spanned<Value>, unit: &Unit) -> Result<TimeFunction, Failure> {
        let text = match value.get_ref() {
            Value::Number(x) => format!("{x:?}"),
            Value::Text(text) => text.clone(),
        };
        let expr = model_dsl::parse_time_function(&text, unit)
            .map_err(|(message, help)| self.source.wrong(&value.span(), Wrong { message, label: "this function of t", help }))?;
        Ok(TimeFunction::new(&machine.loaded.rig, &expr))
    }

    /// Functions of time for named things, with the unit of each.
    pub fn functions(&self, machine: &Machine, table: &Functions, what: &str, known: &[(String, Unit)]) -> Result<Indexed, Failure> {
        let names: Vec<String> = known.iter().map(|k| k.0.clone()).collect();
        table
            .iter()
            .map(|(name, value)| {
                let i = self.index(what, name, &names)?;
                Ok((i, self.function(machine, value, &known[i].1)?))
            })
            .collect()
    }

    /// Bench and surroundings.
    pub fn bench<'a>(&self, plant: &'a Machine) -> Result<(Bench, Surroundings<'a>), Failure> {
        let (file, layout) = (&self.file, plant.layout());
        let period = self.seconds(&file.controller.get_ref().period)?;
        let max_step = file.max_step.as_ref().map_or(Ok(0.001), |v| self.seconds(v))?;
        let mut x = self.start(plant, &file.start)?;
        let n = layout.q.len();
        let moved: Vec<(usize, (String, Unit))> = (layout.inputs..layout.u.len())
            .filter_map(|k| {
                let name = layout.u[k].name.strip_suffix(".ddot")?;
                let i = layout.q.iter().position(|q| q.name == name)?;
                Some((i, (name.to_owned(), unit(&layout.q[i].unit))))
            })
            .collect();
        let known: Vec<(String, Unit)> = moved.iter().map(|m| m.1.clone()).collect();
        let functions = self.functions(plant, &file.motion, "prescribed coordinate", &known)?;
        let mut exogenous: Vec<Signal<'a>> = Vec::new();
        for (k, (i, (name, _))) in moved.iter().enumerate() {
            // what nothing moves stands still
            let Some((_, motion)) = functions.iter().find(|(j, _)| *j == k) else {
                exogenous.push(Box::new(|_| 0.0));
                continue;
            };
            let [position, rate, _] = motion.at(0.0);
            if let Some((key, value)) =
                file.start.at.iter().find(|(key, _)| key.get_ref() == name || *key.get_ref() == format!("{name}.dot"))
            {
                let message = format!("`{}` starts where its motion starts", key.get_ref());
                return Err(self
                    .source
                    .wrong(&value.span(), Wrong { message, label: "given twice", help: Some("leave it out here".to_owned()) }));
            }
            (x[*i], x[n + *i]) = (position, rate);
            let motion = motion.clone();
            exogenous.push(Box::new(move |t| motion.at(t)[2]));
        }
        let inputs: Vec<(String, Unit)> = layout.u[..layout.inputs].iter().map(|u| (u.name.clone(), unit(&u.unit))).collect();
        let disturbances = self
            .functions(plant, &file.disturbances, "input", &inputs)?
            .into_iter()
            .map(|(i, f)| (i, Box::new(move |t| f.at(t)[0]) as Signal<'a>))
            .collect();
        let noise = match &file.noise {
            None => None,
            Some(noise) => {
                Some(Noise { deviation: self.deviations(plant, &noise.deviation, vec![0.0; layout.outputs.len()])?, seed: noise.seed })
            }
        };
        let bench = Bench { x, period, duration: self.seconds(&file.duration)?, max_step, encoders: file.encoders, limits: file.limits };
        Ok((bench, Surroundings { exogenous, disturbances, noise }))
    }

    /// Standard deviations of outputs over what they are otherwise.
    pub fn deviations(&self, plant: &Machine, table: &Assignments, mut otherwise: Vec<f64>) -> Result<Vec<f64>, Failure> {
        let outputs = outputs(plant.layout());
        let names: Vec<String> = outputs.iter().map(|o| o.0.clone()).collect();
        for (name, value) in table {
            let i = self.index("output", name, &names)?;
            otherwise[i] = self.quantity(value, &outputs[i].1)?;
        }
        Ok(otherwise)
    }

    fn start(&self, plant: &Machine, start: &Point) -> Result<Vec<f64>, Failure> {
        if start.trim.is_some() {
            return Ok(self.point(plant, start.trim.as_ref(), &start.at, &(0..0))?.trim.x);
        }
        let given = Given::read(&plant.loaded.rig, plant.layout(), &assignments(&start.at)).map_err(|failure| {
            match culprit(&start.at, &failure) {
                Some(span) => self.source.caused(&span, &failure),
                None => failure,
            }
        })?;
        Ok(given.vectors(plant.layout()).0)
    }
}

/// Outputs and their units.
pub fn outputs(layout: &Layout) -> Vec<(String, Unit)> {
    layout.outputs.iter().map(|o| (o.name.clone(), unit(&o.unit))).collect()
}

/// A unit of the model's own, which was checked.
pub fn unit(text: &str) -> Unit {
    model_dsl::parse_unit(text).unwrap_or_else(|_| Unit::none())
}

/// `name=value` for what the command line takes in this form.
fn assignments(table: &Assignments) -> Vec<String> {
    table
        .iter()
        .map(|(name, value)| match value.get_ref() {
            Value::Number(x) => format!("{}={x:?}", name.get_ref()),
            Value::Text(text) => format!("{}={text}", name.get_ref()),
        })
        .collect()
}

/// The entry that a failure speaks of.
fn culprit(table: &Assignments, failure: &Failure) -> Option<Range<usize>> {
    table
        .iter()
        .find(|(name, _)| {
            failure.text.contains(&format!("`{}`", name.get_ref())) || failure.text.contains(&format!(" {}=", name.get_ref()))
        })
        .map(|(name, _)| name.span())
}
