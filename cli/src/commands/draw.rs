//! `rig draw`.

use crate::args::Draw;
use crate::failure::Failure;
use crate::load;
use crate::operating;
use crate::output::Answer;
use codegen::Options;
use jit::InProcess;
use serde_json::json;

pub fn run(args: &Draw) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let q = if args.point.trim.is_none() && args.point.at.is_empty() {
        drawing::sample(&loaded.rig)
    } else {
        let model = InProcess::new(load::equations(&loaded, Options::default())?);
        let found = operating::find(&loaded, &model, &args.point)?;
        found.trim.x[..loaded.rig.coordinates.len()].to_vec()
    };
    let pose = drawing::pose(&loaded.rig, loaded.lumps, &q);
    if pose.links.is_empty() && pose.masses.is_empty() && pose.joints.is_empty() {
        return Err(Failure::new("C0601", format!("`{}` has no frames and no bodies: there is nothing to draw", loaded.rig.name))
            .with_help("equations written directly have no geometry"));
    }
    let source = args.rig.file.file_name().map_or_else(|| "rig".to_owned(), |n| n.to_string_lossy().into_owned());
    let title = loaded.rig.doc.lines().next().unwrap_or(&loaded.rig.name);
    let path = args.out.clone().unwrap_or_else(|| args.rig.file.with_extension("svg"));
    crate::write::write(&path, &drawing::picture(&pose, title, &source), args.force)?;
    let text = format!("wrote {}: {}\n", path.display(), pose.coordinates.join(", "));
    Ok(Answer { text, json: json!({"rig": loaded.rig.name, "files": [path], "q": q}) })
}
