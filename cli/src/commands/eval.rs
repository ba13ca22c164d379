//! `rig eval`.

use crate::args::Eval;
use crate::failure::Failure;
use crate::load;
use crate::output::{Answer, number};
use crate::point::Given;
use codegen::Options;
use codegen::expr::{Id, SymbolId, SymbolKind};
use serde_json::json;
use std::fmt::Write;

pub fn run(args: &Eval) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let equations = load::equations(&loaded, Options::default())?;
    let layout = &equations.layout;
    let given = Given::read(&loaded.rig, layout, &args.at)?;
    let (x, u) = given.vectors(layout);
    let n = layout.q.len();
    let g = &equations.graph;
    let value = |s: SymbolId| match g.symbol_info(s).kind {
        SymbolKind::Time => args.time,
        SymbolKind::Coordinate(i) => x[i],
        SymbolKind::Rate(i) => x[n + i],
        SymbolKind::Lag(i) => x[2 * n + i],
        SymbolKind::Signal(i) => u[i],
        SymbolKind::Parameter(i) => layout.nominal[i],
        SymbolKind::Acceleration(_) | SymbolKind::Definition(_) | SymbolKind::Inertial(_) => f64::NAN,
    };
    let vector = |ids: &[Id]| g.evaluate(ids, value);
    let matrix = |rows: &[Vec<Id>]| {
        let flat: Vec<Id> = rows.iter().flatten().copied().collect();
        let values = g.evaluate(&flat, value);
        let columns = rows.first().map_or(0, Vec::len).max(1);
        values.chunks(columns).map(<[f64]>::to_vec).collect::<Vec<_>>()
    };
    let (coordinates, pivots): (Vec<usize>, Vec<Id>) = equations.pivots_as_eliminated().into_iter().unzip();
    for (k, pivot) in coordinates.into_iter().zip(vector(&pivots)) {
        if !pivot.is_finite() || pivot <= 0.0 {
            let name = &layout.q[k].name;
            return Err(crate::operating::singular(name));
        }
    }
    let scalar = |id: Option<Id>| id.map(|id| vector(&[id])[0]);
    let m = matrix(&equations.mass_matrix);
    let dadp = matrix(&equations.parameter_jacobian[n..2 * n]);
    let acceleration = vector(&equations.acceleration);
    let json = json!({
        "rig": loaded.rig.name,
        "state": crate::output::named(layout.x().map(|v| v.name.as_str()), &x),
        "input": crate::output::named(layout.u.iter().map(|v| v.name.as_str()), &u),
        "M": m,
        "bias": vector(&equations.bias),
        "gravity": vector(&equations.gravity),
        "dissipation": vector(&equations.dissipation),
        "force": vector(&equations.force),
        "input_map": matrix(&equations.input_map),
        "acceleration": acceleration,
        "lag_rates": vector(&equations.lag_rates),
        "outputs": vector(&equations.outputs),
        "A": matrix(&equations.linear.a),
        "B": matrix(&equations.linear.b),
        "dadp": dadp,
        "kinetic": scalar(equations.kinetic),
        "potential": scalar(equations.potential),
    });
    let mut text = format!("{}\n", loaded.rig.name);
    let rows = [
        ("bias", &equations.bias),
        ("gravity", &equations.gravity),
        ("dissipation", &equations.dissipation),
        ("force", &equations.force),
        ("acceleration", &equations.acceleration),
    ];
    let _ = write!(text, "{:14}", "");
    for c in &layout.q {
        let _ = write!(text, "{:>14}", c.name);
    }
    text.push('\n');
    for (i, row) in m.iter().enumerate() {
        let _ = write!(text, "{:14}", format!("M[{}]", layout.q[i].name));
        for entry in row {
            let _ = write!(text, "{:>14}", number(*entry));
        }
        text.push('\n');
    }
    for (name, ids) in rows {
        let _ = write!(text, "{name:14}");
        for entry in vector(ids) {
            let _ = write!(text, "{:>14}", number(entry));
        }
        text.push('\n');
    }
    text.push_str("A, B, input map and parameter Jacobian: --json\n");
    Ok(Answer { text, json })
}
