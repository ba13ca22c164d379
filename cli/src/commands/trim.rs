//! `rig trim`.

use crate::args::Trim;
use crate::failure::Failure;
use crate::load;
use crate::operating;
use crate::output::Answer;
use codegen::Options;
use jit::InProcess;

pub fn run(args: &Trim) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let model = InProcess::new(load::equations(&loaded, Options::default())?);
    let found = operating::find(&loaded, &model, &args.point)?;
    let layout = &model.equations().layout;
    let mut json = found.json(&loaded, layout);
    json["rig"] = loaded.rig.name.clone().into();
    json["states"] = layout.x().map(|v| v.name.as_str()).collect::<Vec<_>>().into();
    json["inputs"] = layout.u.iter().map(|v| v.name.as_str()).collect::<Vec<_>>().into();
    json["coordinates"] = layout.q.iter().map(|v| v.name.as_str()).collect::<Vec<_>>().into();
    Ok(Answer { text: found.words(&loaded, layout), json })
}
