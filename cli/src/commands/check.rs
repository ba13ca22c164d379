//! `rig check`.

use crate::args::File;
use crate::failure::Failure;
use crate::load;
use crate::output::Answer;
use codegen::Options;
use serde_json::{Value, json};

pub fn run(file: &File) -> Result<Answer, Failure> {
    let loaded = load::load(file)?;
    load::say(&loaded.checked, |severity| severity == model_dsl::Severity::Note);
    let rig = &loaded.rig;
    // the derivation is part of the check: both roads must agree
    let equations = load::equations(&loaded, Options { jacobians: false, ..Options::default() })?;
    let layout = &equations.layout;
    let names = |v: &[codegen::Variable]| v.iter().map(|x| x.name.clone()).collect::<Vec<_>>();
    let states: Vec<String> = layout.x().map(|x| x.name.clone()).collect();
    let outputs: Vec<String> = layout.outputs.iter().map(|o| o.name.clone()).collect();
    let parameters: Vec<Value> = rig
        .parameters
        .iter()
        .map(|p| json!({"name": p.name, "value": p.value, "unit": p.unit.text, "prior_sd": p.prior_sd, "fixed": p.fixed}))
        .collect();
    let json = json!({
        "rig": rig.name,
        "coordinates": names(&layout.q),
        "states": states,
        "inputs": names(&layout.u[..layout.inputs]),
        "outputs": outputs,
        "parameters": parameters,
        "diagnostics": load::diagnostics_json(&loaded.checked),
    });
    let text = format!(
        "{}: {} ({}), {} ({}), {}, {}. {}\n",
        rig.name,
        count(layout.q.len(), "coordinate"),
        names(&layout.q).join(", "),
        count(layout.inputs, "input"),
        names(&layout.u[..layout.inputs]).join(", "),
        count(rig.parameters.len(), "parameter"),
        if rig.bodies.len() == 1 { "1 body".to_owned() } else { format!("{} bodies", rig.bodies.len()) },
        crate::commands::verdict(&equations),
    );
    Ok(Answer { text, json })
}

fn count(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}
