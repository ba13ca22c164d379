//! From a scenario to the description of its controller as code.

use crate::failure::Failure;
use crate::scenario::build::{Machine, Scenario};
use crate::scenario::controller::{build, filter, trim_manifold};
use crate::scenario::file;
use crate::scenario::source::Wrong;
use codegen::Direction;
use codegen::emit::controller::{Channel, Column, Controller, Feedforward, Filter, Kalman, Signal, Source};
use control::{Rule, Sampled};
use nalgebra::DMatrix;
use runtime::Model;
use std::collections::BTreeSet;
use std::path::Path;

/// The controller of a scenario for a rig file.
pub fn code(scenario: &Scenario, path: &Path, rig: &Path) -> Result<Controller, Failure> {
    let source = &scenario.source;
    let own = source.folder.join(scenario.file.rig.get_ref());
    let same = |a: &Path, b: &Path| std::fs::canonicalize(a).ok().is_some_and(|a| std::fs::canonicalize(b).ok() == Some(a));
    if !same(&own, rig) {
        let message = format!("this scenario controls {}, not {}", own.display(), rig.display());
        return Err(source.wrong(&scenario.file.rig.span(), Wrong { message, label: "here", help: None }));
    }
    let plant = scenario.plant()?;
    let other = scenario.design()?;
    let design = other.as_ref().unwrap_or(&plant);
    let built = build(scenario, &plant, design)?;
    let layout = plant.layout();
    let outputs: Vec<&str> = layout.outputs.iter().map(|o| o.name.as_str()).collect();
    // names were checked when the controller was built
    let index = |name: &str| outputs.iter().position(|o| *o == name).unwrap_or(0);
    let states: Vec<&str> = built.operating.states.iter().map(|(name, _)| name.as_str()).collect();
    let state = |name: &str| states.iter().position(|s| *s == name);
    let columns: Vec<Column> = built
        .gain
        .states
        .iter()
        .map(|s| match (s.strip_suffix(".integral"), s.strip_suffix(".dot")) {
            (Some(o), _) => Column::Integral(index(o)),
            (None, Some(o)) if outputs.contains(&o) => Column::Rate(index(o)),
            (None, None) if outputs.contains(&s.as_str()) => Column::Value(index(s)),
            _ => Column::State(state(s).unwrap_or(0)),
        })
        .collect();
    let feedforward = feedforward(scenario, design, &built.found.trim.u, layout.inputs)?;
    let held: Vec<usize> = match &feedforward {
        Feedforward::Manifold(_, held) => held.iter().map(|&s| index(&design.layout().q[s].name)).collect(),
        Feedforward::Constant(..) => Vec::new(),
    };
    // outputs that something reads, in the rig's order
    let mut used: BTreeSet<usize> = held.iter().copied().collect();
    used.extend(columns.iter().filter_map(|c| match *c {
        Column::Value(i) | Column::Rate(i) | Column::Integral(i) => Some(i),
        Column::State(_) => None,
    }));
    if built.kalman.is_some() {
        used.extend(0..outputs.len());
    }
    for (name, keys) in &scenario.file.cascades {
        if used.contains(&index(name.get_ref())) {
            used.insert(index(keys.outer.get_ref()));
        }
    }
    let used: Vec<usize> = used.into_iter().collect();
    let place = |i: usize| used.iter().position(|&k| k == i).unwrap_or(0);
    let channels = used
        .iter()
        .map(|&i| Channel {
            name: layout.outputs[i].name.clone(),
            unit: layout.outputs[i].unit.clone(),
            wrapped: plant.model.output_path(i, plant.p()).wrapped,
            zero: built.operating.zeros[i],
            operating: built.operating.outputs[i],
        })
        .collect();
    let mut references: Vec<(usize, Source)> = scenario
        .file
        .references
        .keys()
        .map(|name| index(name.get_ref()))
        .filter(|i| used.contains(i))
        .map(|i| (place(i), Source::Given))
        .collect();
    for (name, keys) in &scenario.file.cascades {
        let i = index(name.get_ref());
        if !used.contains(&i) {
            continue;
        }
        let rate = match &keys.rate {
            file::InnerRate::Zero => None,
            file::InnerRate::Filter(f) => {
                let sampled = filter(scenario, f)?.sampled(built.period, Rule::ZeroOrderHold);
                Some(plain(&sampled.map_err(|e| Failure::new("C0603", e.to_string()))?))
            }
        };
        let unit = super::build::unit(&layout.outputs[i].unit);
        let limit = keys.limit.as_ref().map_or(Ok(f64::INFINITY), |v| scenario.quantity(v, &unit))?;
        let outer = place(index(keys.outer.get_ref()));
        references.push((place(i), Source::Inner { outer, proportional: keys.proportional, derivative: keys.derivative, limit, rate }));
    }
    let columns = columns
        .into_iter()
        .map(|c| match c {
            Column::Value(i) => Column::Value(place(i)),
            Column::Rate(i) => Column::Rate(place(i)),
            Column::Integral(i) => Column::Integral(place(i)),
            Column::State(k) => Column::State(k),
        })
        .collect();
    let feedforward = match feedforward {
        Feedforward::Manifold(m, _) => Feedforward::Manifold(m, held.into_iter().map(place).collect()),
        constant => constant,
    };
    let stem = |p: &Path| p.file_stem().map_or_else(|| "controller".to_owned(), |n| n.to_string_lossy().into_owned());
    let name = |p: &Path| p.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    let hash = &design.model.equations().hash;
    let mixing = built.directions.clone().pseudo_inverse(1e-12).unwrap_or_else(|_| built.directions.transpose());
    Ok(Controller {
        name: stem(path),
        title: scenario.file.title.clone().unwrap_or_else(|| format!("Controller for {}", plant.loaded.rig.name)),
        source: (name(path), name(rig), hash.get(..8).unwrap_or(hash).to_owned()),
        period: built.period,
        channels,
        filter: plain(&built.rates),
        kalman: built.kalman.as_ref().map(|k| {
            let b = &k.b * mixing.columns(0, layout.inputs);
            Kalman {
                states: states.iter().map(|s| (*s).to_owned()).collect(),
                a: rows(&k.a),
                constant: (&k.drift - &k.b * &k.point.1).iter().copied().collect(),
                b: rows(&b),
                c: rows(&k.c),
                correction: rows(&k.correction),
                first: rows(&k.first),
                x: k.point.0.iter().copied().collect(),
                y: k.point.2.iter().copied().collect(),
                shown: outputs.iter().map(|o| (state(o), state(&format!("{o}.dot")))).collect(),
            }
        }),
        references,
        columns,
        inputs: built.gain.inputs.clone(),
        k: rows(&built.gain.k),
        anti_windup: rows(&built.gain.anti_windup),
        directions: rows(&built.directions.rows(0, layout.inputs).into_owned()),
        mixing: rows(&mixing.columns(0, layout.inputs).into_owned()),
        signals: (0..layout.inputs)
            .map(|i| Signal {
                name: layout.u[i].name.clone(),
                unit: layout.u[i].unit.clone(),
                limits: if scenario.file.limits { plant.model.input_path(i, plant.p()).limits } else { (f64::NEG_INFINITY, f64::INFINITY) },
            })
            .collect(),
        feedforward,
    })
}

/// The trim manifold in closed form where there is one; held states as indices of coordinates.
fn feedforward(scenario: &Scenario, design: &Machine, u: &[f64], inputs: usize) -> Result<Feedforward, Failure> {
    let constant = |why: String| Feedforward::Constant(u[..inputs].to_vec(), why);
    let Some((found, held)) = trim_manifold(scenario, design)? else { return Ok(constant(String::new())) };
    let solved: Vec<Direction> = found
        .problem
        .unknowns
        .iter()
        .map(|k| Direction { name: k.name.clone(), states: k.states.clone(), signals: k.signals.clone() })
        .collect();
    Ok(match codegen::manifold(design.model.equations(), &solved, &found.problem.zero, &held, &found.trim.x, &found.trim.u) {
        Ok(mut manifold) => {
            manifold.inputs.truncate(inputs);
            Feedforward::Manifold(Box::new(manifold), held)
        }
        Err(why) => {
            eprintln!("note: u* is that of the operating point: there is no closed form of the trim manifold, since {why}");
            constant(why.to_string())
        }
    })
}

fn rows(m: &DMatrix<f64>) -> Vec<Vec<f64>> {
    m.row_iter().map(|r| r.iter().copied().collect()).collect()
}

fn plain(s: &Sampled) -> Filter {
    let n = s.a.nrows();
    let steady = (DMatrix::identity(n, n) - &s.a).lu().solve(&s.b.column(0).into_owned());
    Filter {
        a: rows(&s.a),
        b: s.b.column(0).iter().copied().collect(),
        c: s.c.row(0).iter().copied().collect(),
        d: s.d[(0, 0)],
        start: steady.filter(|x| x.iter().all(|v| v.is_finite())).map_or_else(|| vec![0.0; n], |x| x.iter().copied().collect()),
    }
}
