//! From a scenario's keys to its controller: gain, feedforward, estimation of rates, references.

use crate::commands::linearize::{inputs_of, linear_at};
use crate::failure::Failure;
use crate::operating::Found;
use crate::scenario::build::{Machine, Scenario, outputs, unit};
use crate::scenario::file::{self, Cost, Rates};
use crate::scenario::source::Wrong;
use control::{
    AngleObserver, Cascade, DerivativeFilter, Estimation, Feedforward, Gain, Holding, InnerRate, KalmanEstimator, KalmanMatrices, Lqr,
    LqrDesign, LqrError, Operating, Plant, PlantModel, Reference, Rule, Sampled, Sampling, Setup, Tracking, Weight, WeightError, Weighted,
};
use nalgebra::{Complex, DMatrix, DVector};
use runtime::Model;
use toml::Spanned;

/// A controller, and what a person wants to know of it.
pub struct Built<'a> {
    /// The controller.
    pub tracking: Tracking<'a>,
    /// Its gain.
    pub gain: Gain,
    /// How the gain was designed, if it was.
    pub designed: Option<Lqr>,
    /// Where.
    pub found: Found,
    /// Values and rates of outputs there.
    pub operating: Operating,
    /// How the signals move with the gain's inputs (signals x inputs).
    pub directions: DMatrix<f64>,
    /// From one angle to its rate; where a Kalman filter knows the rates, that of the others.
    pub rates: Sampled,
    /// The Kalman filter.
    pub kalman: Option<KalmanMatrices>,
    /// Period [s].
    pub period: f64,
}

/// Builds the controller: designed on `design`, run on `plant`.
pub fn build<'a>(scenario: &'a Scenario, plant: &'a Machine, design: &'a Machine) -> Result<Built<'a>, Failure> {
    let source = &scenario.source;
    let keys = scenario.file.controller.get_ref();
    let table = scenario.file.controller.span();
    let failed =
        |span: std::ops::Range<usize>, message: String, help: Option<String>| source.wrong(&span, Wrong { message, label: "here", help });
    let signals = |machine: &Machine| machine.layout().u.iter().map(|u| u.name.clone()).collect::<Vec<_>>();
    if signals(plant) != signals(design) {
        let message =
            format!("the controller's rig has the inputs {}, the rig has {}", signals(design).join(", "), signals(plant).join(", "));
        return Err(failed(table.clone(), message, Some("design it for a rig with the same inputs".to_owned())));
    }
    let names = |list: &[Spanned<String>]| list.iter().map(|s| s.get_ref().clone()).collect::<Vec<String>>();
    let found_first = scenario.point(design, keys.trim.as_ref(), &keys.at, &table)?;
    let inputs = inputs_of(&design.loaded, &design.model, &names(&keys.inputs)).map_err(|f| {
        let span =
            keys.inputs.first().map_or_else(|| table.clone(), |first| first.span().start..keys.inputs.last().map_or(0, |l| l.span().end));
        source.caused(&span, &f)
    })?;
    let linear = linear_at(&design.model, found_first, &inputs.directions, false).map_err(|f| source.caused(&table, &f))?;
    let linear_plant = Plant::new(&design.model, &linear.model, &inputs.names);
    let period = scenario.seconds(&keys.period)?;
    if !(period > 0.0 && period.is_finite()) {
        return Err(failed(keys.period.span(), format!("the period must be a positive number of seconds, it is {period}"), None));
    }
    for name in &keys.states {
        if !name.get_ref().ends_with(".integral") {
            scenario.index("state", name, &linear_plant.states)?;
        }
    }
    for name in &keys.integrate {
        scenario.index("output", name, &linear_plant.outputs)?;
    }

    let (gain, designed) = match (&keys.lqr, &keys.gain) {
        (Some(weights), None) => {
            let w = weights.get_ref();
            let request = LqrDesign {
                states: names(&keys.states),
                integrate: names(&keys.integrate),
                weight_x: Weight::Diagonal(w.weights_x.get_ref().clone()),
                weight_u: Weight::Diagonal(w.weights_u.get_ref().clone()),
                sampling: match w.cost {
                    Cost::Continuous => Sampling::Continuous,
                    Cost::Integral => Sampling::Integral { period },
                    Cost::Sum => Sampling::Sum { period },
                },
            };
            let lqr = control::lqr(&linear_plant, &request).map_err(|e| {
                let span = match &e {
                    LqrError::Weight(WeightError::Length { of: Weighted::Inputs, .. } | WeightError::Sign { of: Weighted::Inputs, .. }) => {
                        w.weights_u.span()
                    }
                    LqrError::Weight(_) => w.weights_x.span(),
                    _ => weights.span(),
                };
                failed(span, e.to_string(), None)
            })?;
            (Gain::from(&lqr), Some(lqr))
        }
        (None, Some(given)) => {
            let mut states = if keys.states.is_empty() { linear_plant.states.clone() } else { names(&keys.states) };
            states.extend(keys.integrate.iter().map(|s| format!("{}.integral", s.get_ref())));
            let g = given.get_ref();
            let time = match (&g.tracking_time, keys.integrate.is_empty()) {
                (Some(time), _) => scenario.seconds(time)?,
                (None, true) => 1.0,
                (None, false) => {
                    let help = "`tracking_time = \"0.5 s\"`: how fast the integrals follow the limits".to_owned();
                    return Err(failed(
                        given.span(),
                        "a given gain with integrals needs a time for its anti-windup".to_owned(),
                        Some(help),
                    ));
                }
            };
            let gain = Gain::given(states, inputs.names.clone(), &g.k, time).map_err(|e| failed(given.span(), e.to_string(), None))?;
            (gain, None)
        }
        (lqr, _) => {
            let message = if lqr.is_some() { "two controllers at once" } else { "nothing says what the controller is" };
            let help = "give either `[controller.lqr]` with weights_x and weights_u, or `[controller.gain]` with K".to_owned();
            return Err(failed(table.clone(), message.to_owned(), Some(help)));
        }
    };

    let found = linear.found;
    let (x, u) = (&found.trim.x, &found.trim.u);
    let mut y = vec![0.0; design.layout().outputs.len()];
    design.model.outputs(0.0, x, design.p(), &mut y);
    let state = |name: &str| design.layout().x().position(|v| v.name == name).map(|i| x[i]);
    let output = |name: &str, y: &[f64]| design.layout().outputs.iter().position(|o| o.name == name).map_or(0.0, |i| y[i]);
    let mut origin = y.clone();
    design.model.outputs(0.0, &vec![0.0; x.len()], design.p(), &mut origin);
    let operating = Operating {
        outputs: plant
            .layout()
            .outputs
            .iter()
            .map(|o| (state(&o.name).unwrap_or_else(|| output(&o.name, &y)), state(&format!("{}.dot", o.name)).unwrap_or(0.0)))
            .collect(),
        zeros: plant.layout().outputs.iter().map(|o| if state(&o.name).is_some() { output(&o.name, &origin) } else { 0.0 }).collect(),
        states: design.layout().x().zip(x).map(|(v, x)| (v.name.clone(), *x)).collect(),
    };
    let point_inputs = &inputs.rows * DVector::from_column_slice(u);
    let kalman_model = KalmanModel { linear: &linear.model, plant: &linear_plant, x, u: point_inputs.as_slice() };
    let estimation = estimation(scenario, plant, &kalman_model, &operating, period)?;
    let rates = estimation.of_one_angle(period).map_err(|e| failed(scenario.file.rates.span(), e.to_string(), None))?;
    let kalman = if let Estimation::Kalman(filter) = &estimation { Some(filter.matrices()) } else { None };
    let (directions, kept) = (inputs.directions.clone(), operating.clone());
    let setup = Setup {
        gain: gain.clone(),
        directions: inputs.directions,
        references: references(scenario, plant)?,
        operating,
        holding: holding(scenario, design, u)?,
        estimation,
        period,
    };
    let tracking = Tracking::new(&plant.model, plant.p(), setup).map_err(|e| {
        let help = match &e {
            control::TrackingError::NotMeasured { .. } => {
                Some("feed back measured outputs and their rates (`states = [..]`), or estimate the state with `[rates.kalman]`".to_owned())
            }
            _ => None,
        };
        let span = match &e {
            control::TrackingError::OuterReference { name } => {
                scenario.file.cascades.values().find(|c| c.outer.get_ref() == name).map_or_else(|| table.clone(), |c| c.outer.span())
            }
            control::TrackingError::NotMeasured { name, .. } => {
                keys.states.iter().find(|s| s.get_ref() == name).map_or_else(|| table.clone(), Spanned::span)
            }
            control::TrackingError::Filter(_) => scenario.file.rates.span(),
            _ => table.clone(),
        };
        failed(span, e.to_string(), help)
    })?;
    Ok(Built { tracking, gain, designed, found, operating: kept, directions, rates, kalman, period })
}

/// The trim of the feedforward and the states that it holds; `None` where there is none.
pub fn trim_manifold(scenario: &Scenario, design: &Machine) -> Result<Option<(Found, Vec<usize>)>, Failure> {
    let Some(keys) = &scenario.file.feedforward else { return Ok(None) };
    let (table, keys) = (keys.span(), keys.get_ref());
    let found = scenario.point(design, keys.trim.as_ref(), &keys.at, &table)?;
    if found.as_given {
        let wrong = Wrong {
            message: "the feedforward has nothing to solve for".to_owned(),
            label: "here",
            help: Some("name a trim that solves for inputs, and hold nothing in `at` that it solves for".to_owned()),
        };
        return Err(scenario.source.wrong(&table, wrong));
    }
    let states: Vec<String> = design.layout().x().map(|v| v.name.clone()).collect();
    let held = keys.hold.iter().map(|name| scenario.index("state", name, &states)).collect::<Result<Vec<_>, _>>()?;
    let solved = |i: usize| found.problem.unknowns.iter().any(|k| k.states.iter().any(|&(s, _)| s == i));
    if let Some((_, name)) = held.iter().zip(&keys.hold).find(|(i, _)| solved(**i)) {
        let message = format!("`{}` is what this trim solves for: it cannot be held at its reference", name.get_ref());
        return Err(scenario.source.wrong(&name.span(), Wrong { message, label: "solved for", help: None }));
    }
    Ok(Some((found, held)))
}

fn holding<'a>(scenario: &'a Scenario, design: &'a Machine, u: &[f64]) -> Result<Holding<'a>, Failure> {
    let (Some(keys), Some((found, held))) = (&scenario.file.feedforward, trim_manifold(scenario, design)?) else {
        return Ok(Holding::Point(u.to_vec()));
    };
    let names = keys.get_ref().hold.iter().map(|s| s.get_ref().clone()).collect();
    let feedforward = Feedforward::new(&design.model, design.p(), found.problem, held)
        .map_err(|e| scenario.source.wrong(&keys.span(), Wrong { message: e.to_string(), label: "here", help: None }))?;
    Ok(Holding::Manifold(feedforward, names))
}

pub fn filter(scenario: &Scenario, keys: &file::Filter) -> Result<DerivativeFilter, Failure> {
    Ok(DerivativeFilter { omega: scenario.quantity(&keys.omega, &unit("rad/s"))?, damping: keys.damping })
}

fn references<'a>(scenario: &'a Scenario, plant: &'a Machine) -> Result<Vec<(String, Reference<'a>)>, Failure> {
    let file = &scenario.file;
    let outputs = outputs(plant.layout());
    let names: Vec<String> = outputs.iter().map(|o| o.0.clone()).collect();
    let rates: Vec<_> = outputs.iter().map(|(name, unit)| (name.clone(), unit.per_second())).collect();
    let mut stated = scenario.functions(plant, &file.reference_rates, "output", &rates)?;
    let mut list: Vec<(String, Reference<'a>)> = Vec::new();
    for (i, value) in scenario.functions(plant, &file.references, "output", &outputs)? {
        let rate = stated.iter().position(|(j, _)| *j == i).map(|k| stated.swap_remove(k).1);
        list.push((
            names[i].clone(),
            Reference::Given(Box::new(move |t| {
                let [position, slope, _] = value.at(t);
                (position, rate.as_ref().map_or(slope, |rate| rate.at(t)[0]))
            })),
        ));
    }
    if let Some((i, _)) = stated.first() {
        let span = file.reference_rates.keys().find(|k| *k.get_ref() == names[*i]).map_or(0..0, Spanned::span);
        let message = format!("a rate for the reference of `{}`, which has none", names[*i]);
        return Err(scenario
            .source
            .wrong(&span, Wrong { message, label: "here", help: Some("give its value under `[references]`".to_owned()) }));
    }
    for (name, keys) in &file.cascades {
        let i = scenario.index("output", name, &names)?;
        scenario.index("output", &keys.outer, &names)?;
        if list.iter().any(|(n, _)| n == name.get_ref()) {
            let message = format!("`{}` has a reference already", name.get_ref());
            return Err(scenario.source.wrong(&name.span(), Wrong { message, label: "given twice", help: None }));
        }
        let limit = keys.limit.as_ref().map_or(Ok(f64::INFINITY), |v| scenario.quantity(v, &outputs[i].1))?;
        let rate = match &keys.rate {
            file::InnerRate::Zero => InnerRate::Zero,
            file::InnerRate::Filter(f) => InnerRate::Filtered(filter(scenario, f)?),
        };
        let law = Cascade { proportional: keys.proportional, derivative: keys.derivative, limit };
        list.push((name.get_ref().clone(), Reference::Inner { law, outer: keys.outer.get_ref().clone(), rate }));
    }
    Ok(list)
}

/// The linear model that a Kalman filter is made of.
struct KalmanModel<'a> {
    linear: &'a control::LinearModel,
    plant: &'a Plant,
    x: &'a [f64],
    u: &'a [f64],
}

fn estimation(
    scenario: &Scenario,
    plant: &Machine,
    model: &KalmanModel<'_>,
    operating: &Operating,
    period: f64,
) -> Result<Estimation, Failure> {
    let span = scenario.file.rates.span();
    let wrong =
        |message: String, help: Option<&str>| scenario.source.wrong(&span, Wrong { message, label: "here", help: help.map(str::to_owned) });
    Ok(match scenario.file.rates.get_ref() {
        Rates::Filter(keys) => {
            let rule = match keys.rule {
                file::Rule::Hold => Rule::ZeroOrderHold,
                file::Rule::Tustin => Rule::Tustin,
            };
            Estimation::Filter(filter(scenario, keys)?, rule)
        }
        Rates::Differences => Estimation::Differences,
        Rates::Observer(keys) => {
            let poles: Vec<Complex<f64>> = keys
                .poles
                .get_ref()
                .iter()
                .flat_map(
                    |&(re, im)| if im == 0.0 { vec![Complex::new(re, 0.0)] } else { vec![Complex::new(re, im), Complex::new(re, -im)] },
                )
                .collect();
            if poles.len() < 2 || poles.iter().any(|z| z.re.is_nan() || z.re >= 0.0) {
                let help = "for example `poles = [[-60, 0], [-36, 48]]`: real and imaginary part, of a pair one";
                return Err(scenario.source.wrong(
                    &keys.poles.span(),
                    Wrong {
                        message: "an observer of rates needs two poles or more, all with negative real parts".to_owned(),
                        label: "here",
                        help: Some(help.to_owned()),
                    },
                ));
            }
            Estimation::Observer(AngleObserver::new(&poles))
        }
        Rates::Kalman(keys) => {
            let layout = plant.layout();
            let mut process = vec![0.0; model.plant.states.len()];
            for (name, intensity) in &keys.process {
                process[scenario.index("state", name, &model.plant.states)?] = *intensity;
            }
            let noise = scenario.file.noise.as_ref();
            let mut deviation = noise.map_or_else(
                || Ok(vec![0.0; layout.outputs.len()]),
                |n| scenario.deviations(plant, &n.deviation, vec![0.0; layout.outputs.len()]),
            )?;
            for (i, d) in deviation.iter_mut().enumerate() {
                // rounding to a quantum has its variance over twelve
                let quantum = if scenario.file.encoders { plant.model.output_path(i, plant.p()).quantum } else { 0.0 };
                *d = d.hypot(quantum / 12.0_f64.sqrt());
            }
            let deviation = scenario.deviations(plant, &keys.measurement, deviation)?;
            if let Some(i) = deviation.iter().position(|d| *d <= 0.0) {
                let name = &layout.outputs[i].name;
                return Err(wrong(
                    format!("`{name}` has no encoder and no noise: how far is it to be trusted?"),
                    Some(&format!("`measurement = {{ {name} = \"..\" }}`: its standard deviation")),
                ));
            }
            // rows of C in the order of the plant's outputs
            let mut known = model.plant.clone();
            let rows = layout
                .outputs
                .iter()
                .map(|o| known.reading(&o.name).map_err(|e| wrong(e.to_string(), None)))
                .collect::<Result<Vec<_>, _>>()?;
            known.c = DMatrix::from_fn(rows.len(), known.states.len(), |i, j| rows[i][(0, j)]);
            known.outputs = layout.outputs.iter().map(|o| o.name.clone()).collect();
            let y: Vec<f64> = operating.outputs.iter().zip(&operating.zeros).map(|(o, zero)| o.0 + zero).collect();
            let model = PlantModel { linear: model.linear, plant: &known, x: model.x, u: model.u, y: &y };
            let filter = KalmanEstimator::new(model, &process, &deviation, period).map_err(|e| wrong(e.to_string(), None))?;
            Estimation::Kalman(Box::new(filter))
        }
    })
}
