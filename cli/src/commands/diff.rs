//! `rig diff`.

use crate::args::Diff;
use crate::failure::Failure;
use crate::load;
use crate::output::Answer;
use codegen::{Lumps, Options};
use serde_json::json;

pub fn run(args: &Diff) -> Result<Answer, Failure> {
    let side = |path| -> Result<_, Failure> {
        let mut loaded = load::load_path(path, None, &[], true)?;
        loaded.lumps = Lumps::Expanded;
        let equations = load::equations(&loaded, Options { jacobians: false, ..Options::default() })?;
        Ok((loaded.rig, equations))
    };
    let (first, second) = (side(&args.first)?, side(&args.second)?);
    let diff = codegen::display::diff((&first.0, &first.1), (&second.0, &second.1));
    let list = |terms: &[codegen::display::DiffTerm]| {
        terms.iter().map(|t| json!({"quantity": t.quantity, "term": t.term, "size": t.size})).collect::<Vec<_>>()
    };
    let json = json!({"added": list(&diff.added), "removed": list(&diff.removed), "changed": list(&diff.changed)});
    Ok(Answer { text: diff.to_string(), json })
}
