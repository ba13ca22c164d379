//! `rig demo`: the whole chain on a rig and a record that the program carries with it.
//!
//! The files are written to a folder, so that the same commands can be tried by hand afterwards.

use crate::args::{Arguments, Demo};
use crate::failure::Failure;
use crate::output::Answer;
use clap::Parser;
use serde_json::json;
use std::fmt::Write;

const RIG: &str = include_str!("../../../examples/rigs/googol_identified.rig");
const RECORD: &str = include_str!("../../../examples/records/simulated_steps.csv");

pub fn run(args: &Demo) -> Result<Answer, Failure> {
    let rig = args.out.join("googol_identified.rig");
    let record = args.out.join("simulated_steps.csv");
    crate::write::write(&rig, RIG, args.force)?;
    crate::write::write(&record, RECORD, args.force)?;
    let (rig, record) = (rig.display().to_string(), record.display().to_string());
    let steps: [&[&str]; 7] = [
        &["check", &rig],
        &["show", &rig],
        &["trim", &rig, "--trim", "turn"],
        &["linearize", &rig, "--trim", "hover", "--inputs", "f_s,f_d"],
        &["compare", &rig, "--set", "c_eps=0.10", "--data", &record],
        &["identify", &rig, "--data", &record, "--free", "a1,a2,a3,b2,b3,c_psi,c_eps,c_theta"],
        &[
            "lqr",
            &rig,
            "--trim",
            "hover",
            "--inputs",
            "f_s,f_d",
            "--states",
            "eps,eps.dot,theta,theta.dot",
            "--weights-x",
            "180,10,400,1",
            "--weights-u",
            "1,1",
        ],
    ];
    let mut text = format!(
        "wrote {rig} (eq. 16 of the seed paper) and {record} (simulated by us, not measured; its truth has an effect that the rig lacks)\n"
    );
    let mut documents = Vec::new();
    for step in steps {
        let line = format!("rig {}", step.join(" "));
        let words = std::iter::once("rig").chain(step.iter().copied());
        let arguments = Arguments::try_parse_from(words).map_err(|e| Failure::new("C0901", format!("{line}: {e}")))?;
        let answer = super::run(arguments)?;
        let _ = write!(text, "\n$ {line}\n{}", answer.text);
        documents.push(json!({"command": line, "answer": answer.json}));
    }
    Ok(Answer { text, json: json!({"files": [rig, record], "steps": documents}) })
}
