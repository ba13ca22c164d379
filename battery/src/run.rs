//! One run: a rig, an experiment, perhaps something hidden; the diagnosis; and what it says beside the truth.

use crate::conditions::{Condition, Fault, experiment, spoil};
use crate::hide::{Hidden, Moved, hide, hide_outside, sizes};
use crate::rigs::{Bench, Rig};
use crate::truth::chance::Chance;
use crate::truth::experiment::{Excitation, Samples};
use crate::truth::plant::Plant;
use diagnose::effects::{Scales, catalogue};
use diagnose::patch::Base;
use diagnose::{Candidate, DiagnoseError, Diagnosis, Method, Options, Step, diagnose};
use ident::fit::ParameterSpec;
use ident::record::{Column, Record, Start};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Samples of a training record; there are two.
const TRAIN: usize = 1200;
/// Samples of the test record.
const TEST: usize = 1600;

/// What is to be hidden.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hiding {
    /// Nothing.
    Nothing,
    /// As many effects as this, each of another class, at a multiple of what shows.
    Some(usize, f64),
    /// This effect, wherever it can be, at a multiple of what shows.
    This(&'static str, f64),
    /// These effects together, wherever they can be, at a multiple of what shows.
    These(&'static [&'static str], f64),
    /// One of [`crate::hide::OUTSIDE`], at a multiple of the Coulomb friction that shows.
    Outside(&'static str, f64),
    /// An effect that is taken out of the catalogue then, and that no other entry imitates.
    Decoy(f64),
    /// A spring beside gravity, where small swings cannot tell it from that.
    Eaten(f64),
}

/// A run to be made.
#[derive(Clone, Debug)]
pub struct Task {
    /// Row of the battery.
    pub row: &'static str,
    /// What of the row, in the table.
    pub part: String,
    /// Rig.
    pub rig: Rig,
    /// Experiment.
    pub condition: Condition,
    /// What is hidden.
    pub hiding: Hiding,
    /// Parts of the method that are left out.
    pub method: Method,
    /// Number within the part; with `stream` it is the seed.
    pub number: u64,
    /// Name of the stream of seeds: tasks that are to be compared have the same.
    pub stream: String,
}

/// An effect that was said.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Said {
    /// Effect.
    pub effect: String,
    /// Place.
    pub place: String,
    /// What it cannot be told from.
    pub equivalent: Vec<(String, String)>,
    /// Parameters: value and standard error, infinite where nothing is known of it.
    #[serde(deserialize_with = "or_infinite")]
    pub values: Vec<(f64, f64)>,
    /// Its class among the first candidates.
    pub class: usize,
    /// Its p-value.
    pub p: f64,
    /// Gain on the test record and half its interval.
    pub gain: (f64, f64),
    /// It has a value for each record.
    #[serde(default)]
    pub by_record: bool,
}

/// Pairs of numbers; JSON has `null` for one that is infinite.
fn or_infinite<'de, D: serde::Deserializer<'de>>(from: D) -> Result<Vec<(f64, f64)>, D::Error> {
    let all = Vec::<(Option<f64>, Option<f64>)>::deserialize(from)?;
    Ok(all.into_iter().map(|(value, sd)| (value.unwrap_or(f64::INFINITY), sd.unwrap_or(f64::INFINITY))).collect())
}

/// A line of the results.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Outcome {
    /// Row.
    pub row: String,
    /// Part.
    pub part: String,
    /// Rig.
    pub rig: String,
    /// Number.
    pub number: u64,
    /// What was hidden.
    pub hidden: Vec<Hidden>,
    /// Verdict, or what went wrong.
    pub verdict: String,
    /// The program failed.
    pub failed: bool,
    /// Why.
    pub because: String,
    /// Smallest p-value of the first screening.
    pub screening_p: f64,
    /// Effects.
    pub said: Vec<Said>,
    /// The strongest identifiable candidate, and its class.
    pub strongest: Option<(String, String, usize)>,
    /// Class of each hidden effect among the first candidates; 0 where it is none of them.
    pub truth_class: Vec<usize>,
    /// Members of each hidden effect's class.
    pub class_size: Vec<usize>,
    /// Share of the gap that was closed, by signal.
    pub shrink: Vec<(String, f64)>,
    /// Squared error of predictions of the test record after over that before, mean over signals.
    pub test_ratio: Option<f64>,
    /// Seconds.
    pub seconds: f64,
}

/// Families of effects that are screened: at most forty candidates at a time.
fn families(rig: Rig, number: u64) -> Vec<&'static str> {
    let first = [
        "coulomb",
        "quadratic_drag",
        "asymmetric_friction",
        "cubic_spring",
        "constant_torque",
        "input_delay",
        "actuator_deadzone",
        "gain_curvature",
        "actuator_gain",
        "actuator_bias",
        "sensor_bias",
        "sensor_scale",
        "sensor_delay",
    ];
    let second = [
        "coulomb",
        "quadratic_drag",
        "spring",
        "stribeck",
        "actuator_lag",
        "actuator_saturation",
        "actuator_drift",
        "start_transient",
        "input_coupling",
        "sensor_drift",
        "sensor_misalignment",
        "base_tilt",
        "backlash",
        "flexible_mode",
    ];
    let single = ["periodic_torque", "hard_stop", "gravity_offset", "added_mass"];
    let flying =
        ["coulomb", "quadratic_drag", "spring", "constant_torque", "velocity_product", "input_coupling", "actuator_lag", "sensor_drift"];
    match rig {
        Rig::Pendulum | Rig::Drive => first.into_iter().chain(second).chain(single).fold(Vec::new(), |mut all, id| {
            if !all.contains(&id) {
                all.push(id);
            }
            all
        }),
        Rig::Helicopter if number % 2 == 1 => flying.to_vec(),
        Rig::Helicopter => first.into_iter().filter(|id| *id != "asymmetric_friction" && *id != "sensor_delay").collect(),
        _ if number.is_multiple_of(2) => first.to_vec(),
        _ => second.into_iter().chain(["hard_stop", "gravity_offset"]).collect(),
    }
}

/// Records of the fitting side.
#[must_use]
pub fn record(name: &str, samples: &Samples, rig: Rig) -> Record {
    let (outputs, inputs) = rig.names();
    let column = |name: &str, values: &Vec<f64>| Column { name: name.to_owned(), unit: None, values: values.clone() };
    let columns = outputs.iter().zip(&samples.y).chain(inputs.iter().zip(&samples.u)).map(|(n, v)| column(n, v)).collect();
    Record { source: name.to_owned(), t: samples.t.clone(), columns, declared: Vec::new(), start: Start::Free }
}

/// The rig as its user has it.
fn base(rig: Rig) -> Result<Base, String> {
    let files = [(format!("{}.rig", rig.name()), rig.text().to_owned())];
    diagnose::patch::check(&files, rig.title()).map_err(|e| e.to_string())
}

/// Two training records and a test record with another excitation.
#[must_use]
pub fn experiments(bench: &Bench, plant: &Plant, condition: &Condition, seed: u64) -> Vec<Samples> {
    let kinds = [(Excitation::Steps, TRAIN), (Excitation::Sines, TRAIN), (Excitation::Chirp, TEST)];
    let mut all = Vec::new();
    for (k, (kind, samples)) in kinds.into_iter().enumerate() {
        let mut plant = plant.clone();
        if condition.fault == Some(Fault::OfTheDay) && k < 2 {
            plant.joints[0].constant += 0.06 * bench.strong[0];
        }
        let count = condition.samples.unwrap_or(samples);
        all.push(experiment(bench, &plant, condition, kind, count, seed.wrapping_mul(7).wrapping_add(k as u64)));
    }
    all
}

struct Setting {
    /// Say what a diagnosis does.
    aloud: bool,
    base: Base,
    specs: Vec<ParameterSpec>,
    bench: Bench,
    seed: u64,
}

impl Setting {
    fn tell(&self, text: &str) {
        if self.aloud {
            eprintln!("{text}");
        }
    }

    /// Effects that the catalogue has for this rig, moved as it is.
    fn known(&self, plant: &Plant, task: &Task) -> Vec<String> {
        let condition = Condition { fault: None, ..task.condition };
        let all = experiments(&self.bench, plant, &condition, self.seed);
        let n = plant.mechanics.coordinates();
        let range = (0..n)
            .map(|i| all[..2].iter().fold((f64::INFINITY, f64::NEG_INFINITY), |r, s| (r.0.min(s.range[i].0), r.1.max(s.range[i].1))))
            .collect();
        let rate = (0..n).map(|i| all[0].rate[i]).collect();
        let duration = all[0].t.last().copied().unwrap_or(0.0);
        let scales = Scales { range, rate, input: vec![(1.0, 1.0); task.rig.names().1.len()], duration, period: self.bench.period };
        catalogue(&self.base.rig, &scales).into_iter().map(|e| e.id).collect()
    }

    fn records(&self, task: &Task, plant: &Plant, chance: &mut Chance) -> (Vec<Record>, Moved) {
        let mut all = experiments(&self.bench, plant, &task.condition, self.seed);
        let first = &all[0];
        let mut command = [0.0; 3];
        for (j, u) in first.u.iter().enumerate() {
            command[j] = u.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        }
        let moved = Moved { rate: first.rate, range: first.range, command };
        if let Some(fault) = task.condition.fault {
            let other = match fault {
                Fault::OtherRig => {
                    let rig = if task.rig == Rig::Pendulum { Rig::DoublePendulum } else { Rig::Pendulum };
                    let bench = rig.bench(self.seed);
                    experiments(&bench, &bench.plant, &task.condition, self.seed + 1)
                }
                _ => experiments(&self.bench, plant, &task.condition, self.seed + 1),
            };
            spoil(&mut all, &other, fault, chance);
        }
        let names = ["steps", "sines", "chirp"];
        (all.iter().zip(names).map(|(s, n)| record(n, s, task.rig)).collect(), moved)
    }

    fn diagnose(&self, (train, test): (&[Record], &[Record]), only: &[String], until: Step, method: Method) -> Result<Diagnosis, String> {
        let ask = |only: Vec<String>| {
            let options = Options { only, until, method, progress: &|t| self.tell(t), ..Options::default() };
            diagnose(&self.base, &self.specs, train, test, &options)
        };
        let run = || {
            let found = match ask(only.to_vec()) {
                // ranges that the filter sees are not quite those that were
                Err(DiagnoseError::UnknownEffect { known, .. }) => ask(only.iter().filter(|id| known.contains(id)).cloned().collect()),
                found => found,
            };
            found.map_err(|e| e.to_string())
        };
        self.tell(&format!("diagnosing {}", self.base.rig.name));
        // a fault of the program is a result, too
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).unwrap_or_else(|panic| {
            let text = panic.downcast_ref::<String>().cloned().or_else(|| panic.downcast_ref::<&str>().map(|s| (*s).to_owned()));
            Err(format!("panic: {}", text.unwrap_or_default()))
        })
    }
}

/// What the files of a run begin with.
fn stem(row: &str, part: &str, rig: Rig, number: u64) -> String {
    format!("{row}_{}_{}_{number}", part.replace([' ', ':', '*'], "_"), rig.name())
}

/// Writes the rig and the records of a run, for `rig diagnose`.
fn save(folder: &Path, task: &Task, records: &[Record]) -> std::io::Result<()> {
    let stem = stem(task.row, &task.part, task.rig, task.number);
    std::fs::write(folder.join(format!("{stem}.rig")), task.rig.text())?;
    for record in records {
        let mut text = std::iter::once("t").chain(record.columns.iter().map(|c| c.name.as_str())).collect::<Vec<_>>().join(",");
        for (k, t) in record.t.iter().enumerate() {
            text.push_str(&format!("\n{t}"));
            record.columns.iter().for_each(|c| text.push_str(&format!(",{}", c.values[k])));
        }
        std::fs::write(folder.join(format!("{stem}_{}.csv", record.source)), text + "\n")?;
    }
    Ok(())
}

/// Diagnoses the records of a run again that were kept, with the program as it is now.
///
/// # Errors
/// Where they cannot be read.
pub fn again(outcome: &Outcome, folder: &Path) -> Result<Outcome, String> {
    let rig = Rig::ALL.into_iter().find(|r| r.name() == outcome.rig).ok_or_else(|| format!("there is no rig `{}`", outcome.rig))?;
    let base = base(rig)?;
    let specs = ParameterSpec::of_rig(&base.rig);
    let setting = Setting { aloud: false, base, specs, bench: rig.bench(0), seed: 0 };
    let stem = stem(&outcome.row, &outcome.part, rig, outcome.number);
    let names = ["steps", "sines", "chirp"];
    let records: Vec<Record> = names
        .iter()
        .map(|name| ident::record::read(&folder.join(format!("{stem}_{name}.csv"))).map_err(|e| e.to_string()))
        .collect::<Result<_, _>>()?;
    let only: Vec<String> = families(rig, outcome.number).into_iter().map(str::to_owned).collect();
    let began = std::time::Instant::now();
    let found = setting.diagnose((&records[..2], &records[2..]), &only, Step::Patch, Method::default());
    let mut new = Outcome { seconds: began.elapsed().as_secs_f64(), said: Vec::new(), failed: false, test_ratio: None, ..outcome.clone() };
    match found {
        Ok(found) => fill(&mut new, &found),
        Err(why) => (new.verdict, new.failed, new.because) = ("failed".to_owned(), true, why),
    }
    Ok(new)
}

/// Makes a run, its files to `keep`; `aloud` says what a diagnosis does. `None` where there is nothing that could be hidden.
#[must_use]
pub fn run(task: &Task, keep: Option<&Path>, aloud: bool) -> Option<Outcome> {
    let mut naming = Chance::new(task.number, &task.stream);
    let seed = (naming.uniform() * 1e15) as u64;
    let mut chance = Chance::new(seed, "hide");
    let mut outcome = Outcome {
        row: task.row.to_owned(),
        part: task.part.clone(),
        rig: task.rig.name().to_owned(),
        number: task.number,
        hidden: Vec::new(),
        verdict: String::new(),
        failed: false,
        because: String::new(),
        screening_p: 1.0,
        said: Vec::new(),
        strongest: None,
        truth_class: Vec::new(),
        class_size: Vec::new(),
        shrink: Vec::new(),
        test_ratio: None,
        seconds: 0.0,
    };
    let fail = |mut outcome: Outcome, why: String| {
        outcome.verdict = "failed".to_owned();
        outcome.failed = true;
        outcome.because = why;
        Some(outcome)
    };
    let base = match base(task.rig) {
        Ok(base) => base,
        Err(why) => return fail(outcome, why),
    };
    let specs = ParameterSpec::of_rig(&base.rig);
    let setting = Setting { aloud, base, specs, bench: task.rig.bench(seed), seed };
    let mut plant = setting.bench.plant.clone();
    // only what can act on this rig
    let known = setting.known(&plant, task);
    let mut only: Vec<String> = families(task.rig, task.number).into_iter().map(str::to_owned).filter(|id| known.contains(id)).collect();
    let wanted: &[&str] = match &task.hiding {
        Hiding::This(effect, _) => std::slice::from_ref(effect),
        Hiding::These(effects, _) => effects,
        Hiding::Eaten(_) => &["spring"],
        _ => &[],
    };
    for effect in wanted {
        if !only.iter().any(|o| o == effect) {
            only.push((*effect).to_owned());
        }
    }
    if task.hiding != Hiding::Nothing {
        let (records, moved) = setting.records(task, &plant, &mut chance);
        let clean = match setting.diagnose((&records[..2], &records[2..]), &only, Step::Screen, Method::default()) {
            Ok(clean) => clean,
            Err(why) => return fail(outcome, format!("without the effect: {why}")),
        };
        let alone: Vec<usize> = clean.candidates.iter().map(|c| c.class).filter(|class| of_one_effect(&clean.candidates, *class)).collect();
        let eaten = matches!(task.hiding, Hiding::Eaten(_));
        let mut told = if eaten { clean.candidates } else { shown_by_both(clean.candidates) };
        if let Hiding::Decoy(_) = task.hiding {
            told.retain(|c| alone.contains(&c.class));
        }
        let with = |plant: &Plant| {
            let (records, _) = setting.records(task, plant, &mut Chance::new(seed, "alone"));
            setting
                .diagnose((&records[..2], &records[2..]), &only, Step::Screen, Method::default())
                .map_or_else(|_| Vec::new(), |f| f.candidates)
        };
        outcome.hidden = choose(task, &told, &with, &mut plant, &moved, &mut chance)?;
        if let Hiding::Decoy(_) = task.hiding {
            only.retain(|id| outcome.hidden.iter().all(|h| h.effect != *id));
        }
    }
    let (records, _) = setting.records(task, &plant, &mut chance);
    if let Some(Err(why)) = keep.map(|folder| save(folder, task, &records)) {
        return fail(outcome, why.to_string());
    }
    let began = std::time::Instant::now();
    let found = setting.diagnose((&records[..2], &records[2..]), &only, Step::Patch, task.method);
    outcome.seconds = began.elapsed().as_secs_f64();
    match found {
        Ok(found) => {
            fill(&mut outcome, &found);
            Some(outcome)
        }
        Err(why) => fail(outcome, why),
    }
}

/// No other effect imitates those of this class.
fn of_one_effect(candidates: &[Candidate], class: usize) -> bool {
    let mut ids = candidates.iter().filter(|c| c.class == class && c.status != "not identifiable").map(|c| &c.effect);
    ids.next().is_some_and(|first| ids.all(|id| id == first))
}

/// A spring is eaten where the smallest that shows is as many times as stiff.
const EATEN: f64 = 3.0;
/// The most by which the test record may show an effect less than the training records do, to be of use against it.
const DULLER: f64 = 3.0;

/// Candidates that the training records and the test record can show, with the size that shows in both: an effect that the test record
/// is blind to cannot be confirmed by it, whoever is asked.
fn shown_by_both(candidates: Vec<Candidate>) -> Vec<Candidate> {
    let both = |mut c: Candidate| {
        for (own, in_test) in c.minimal_detectable.iter_mut().zip(&c.detectable_in_test) {
            // parameters that neither can show stay as they are
            if own.1.is_finite() && *in_test > DULLER * own.1 {
                return None;
            }
            own.1 = own.1.max(*in_test);
        }
        Some(c)
    };
    candidates.into_iter().filter(|c| c.status != "not identifiable").filter_map(both).collect()
}

/// What is hidden, and where. `with` are the candidates of a first screening of another plant: effects are of different classes where the
/// records of each alone say so. (Where an effect of several parameters is not there, its direction is that of the noise.)
fn choose(
    task: &Task,
    candidates: &[Candidate],
    with: &dyn Fn(&Plant) -> Vec<Candidate>,
    plant: &mut Plant,
    moved: &Moved,
    chance: &mut Chance,
) -> Option<Vec<Hidden>> {
    let told: Vec<&Candidate> = candidates.iter().collect();
    let detectable = |c: &Candidate| c.minimal_detectable.iter().map(|m| m.1).collect::<Vec<f64>>();
    let (count, multiple) = match task.hiding {
        Hiding::Nothing => return Some(Vec::new()),
        Hiding::Some(count, multiple) => (count, multiple),
        Hiding::These(effects, multiple) => (effects.len(), multiple),
        Hiding::This(_, multiple) | Hiding::Decoy(multiple) | Hiding::Eaten(multiple) => (1, multiple),
        Hiding::Outside(what, multiple) => {
            let (coordinates, _) = task.rig.names();
            let i = chance.index(coordinates.len());
            // the force that shows least: the largest of the joint's own
            let force =
                told.iter().filter(|c| c.effect == "coulomb" && c.place == coordinates[i]).map(|c| detectable(c)[0]).fold(0.0, f64::max);
            if force <= 0.0 {
                return None;
            }
            hide_outside(plant, what, i, multiple * force, moved.rate[i])?;
            let place = coordinates[i].to_owned();
            return Some(vec![Hidden { effect: what.to_owned(), place, sizes: vec![multiple * force], multiple }]);
        }
    };
    if let Hiding::Eaten(share) = task.hiding {
        // as stiff as a share of gravity, in the last joint where the fitted parameters hide it from these records
        let (coordinates, _) = task.rig.names();
        return (0..coordinates.len()).rev().find_map(|i| {
            let bent = std::array::from_fn(|k| if k == i { 0.01 } else { 0.0 });
            let (_, f) = plant.mechanics.equations(&bent, &[0.0; 3], &[0.0; 3]);
            let stiffness = share * f[i].abs() / 0.01;
            let shows = told.iter().find(|c| c.effect == "spring" && c.place == coordinates[i]).map(|c| detectable(c)[0]);
            if stiffness == 0.0 || shows.is_none_or(|shows| shows < EATEN * stiffness) {
                return None;
            }
            let (effect, place) = ("spring".to_owned(), coordinates[i].to_owned());
            let hidden = Hidden { effect, place, sizes: vec![stiffness, 0.0], multiple: share };
            hide(plant, task.rig, &hidden, moved)?;
            Some(vec![hidden])
        });
    }
    let clean = plant.clone();
    let mut chosen: Vec<(Hidden, usize, Vec<Candidate>)> = Vec::new();
    // by effect first, so that effects with many places do not crowd out others
    for _ in 0..60 {
        if chosen.len() == count {
            break;
        }
        let mut ids: Vec<&str> = told.iter().map(|c| c.effect.as_str()).collect();
        ids.sort_unstable();
        ids.dedup();
        match task.hiding {
            Hiding::This(effect, _) => ids.retain(|id| *id == effect),
            Hiding::These(effects, _) => ids.retain(|id| *id == effects[chosen.len()]),
            _ => {}
        }
        let id = *ids.get(chance.index(ids.len()))?;
        let own: Vec<&&Candidate> = told.iter().filter(|c| c.effect == id).collect();
        let c = own.get(chance.index(own.len()))?;
        let twice = |h: &Hidden| h.effect == c.effect && h.place == c.place;
        if chosen.iter().any(|(h, class, _)| *class == c.class || twice(h)) {
            continue;
        }
        let detectable = detectable(c);
        if detectable.is_empty() {
            continue;
        }
        let mut own = sizes(id, &detectable, multiple, chance);
        if let Some(at) = c.shape.as_deref().and_then(|s| s.strip_prefix("at ")?.strip_suffix(" rad/s")?.parse::<f64>().ok()) {
            // beside the grid's frequency, and little damped
            own.extend([1.1 * at, 0.03]);
        }
        let hidden = Hidden { effect: c.effect.clone(), place: c.place.clone(), sizes: own, multiple };
        let (mut both, mut alone) = (plant.clone(), clean.clone());
        if hide(&mut both, task.rig, &hidden, moved).is_none() || hide(&mut alone, task.rig, &hidden, moved).is_none() {
            continue;
        }
        let own = if count > 1 { with(&alone) } else { Vec::new() };
        if chosen.iter().all(|(h, _, theirs)| !of_one_class(&own, h, &hidden) && !of_one_class(theirs, h, &hidden)) {
            *plant = both;
            chosen.push((hidden, c.class, own));
        }
    }
    (chosen.len() == count).then(|| chosen.into_iter().map(|(h, ..)| h).collect())
}

/// A screening cannot tell them apart.
fn of_one_class(candidates: &[Candidate], a: &Hidden, b: &Hidden) -> bool {
    let classes =
        |h: &Hidden| candidates.iter().filter(|c| c.effect == h.effect && c.place == h.place).map(|c| c.class).collect::<Vec<_>>();
    let of_b = classes(b);
    classes(a).iter().any(|class| of_b.contains(class))
}

fn fill(outcome: &mut Outcome, found: &Diagnosis) {
    let class = |effect: &str, place: &str| found.candidates.iter().find(|c| c.effect == effect && c.place == place).map_or(0, |c| c.class);
    found.verdict.id().clone_into(&mut outcome.verdict);
    outcome.because.clone_from(&found.because);
    outcome.screening_p = found.screening_p;
    outcome.said = found
        .findings
        .iter()
        .map(|f| Said {
            effect: f.effect.clone(),
            place: f.place.clone(),
            equivalent: f.equivalent.clone(),
            values: f.parameters.iter().map(|v| (v.value, v.sd)).collect(),
            class: class(&f.effect, &f.place),
            p: f.p_value,
            gain: f.heldout_gain,
            by_record: f.per_record,
        })
        .collect();
    outcome.strongest =
        found.candidates.iter().find(|c| c.status != "not identifiable").map(|c| (c.effect.clone(), c.place.clone(), c.class));
    outcome.truth_class = outcome.hidden.iter().map(|h| class(&h.effect, &h.place)).collect();
    outcome.class_size = outcome
        .truth_class
        .iter()
        .map(|k| {
            let mut names: Vec<(&str, &str)> = found
                .candidates
                .iter()
                .filter(|c| c.class == *k && c.status != "not identifiable")
                .map(|c| (c.effect.as_str(), c.place.as_str()))
                .collect();
            names.sort_unstable();
            names.dedup();
            names.len()
        })
        .collect();
    outcome.shrink.clone_from(&found.gap_shrink);
    // each step's error over that before it
    outcome.test_ratio = (!found.findings.is_empty()).then(|| found.findings.iter().map(|f| f.error_ratio).product());
}

#[cfg(test)]
mod tests {
    use super::Said;

    #[test]
    fn a_coefficient_of_which_nothing_is_known_is_read_again() {
        let said = Said {
            effect: "hard_stop".to_owned(),
            place: "q".to_owned(),
            equivalent: Vec::new(),
            values: vec![(10.7, 1.5), (16.9, f64::INFINITY)],
            class: 2,
            p: 1e-6,
            gain: (4e-3, 5e-3),
            by_record: false,
        };
        let line = serde_json::to_string(&said).unwrap();
        let again: Said = serde_json::from_str(&line).unwrap();
        assert_eq!(again.values, said.values);
    }
}
