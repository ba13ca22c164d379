//! `rig show`.

use crate::args::Show;
use crate::failure::Failure;
use crate::load;
use crate::output::Answer;
use codegen::Options;
use serde_json::json;

pub fn run(args: &Show) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let equations = load::equations(&loaded, Options { assumptions: !args.full, ..Options::default() })?;
    let strings = codegen::display::strings(&loaded.rig, &equations);
    let text = if args.latex { codegen::display::latex(&loaded.rig, &equations) } else { codegen::display::text(&loaded.rig, &equations) };
    let json = json!({
        "rig": loaded.rig.name,
        "equations": {
            "mass_matrix": strings.mass_matrix,
            "bias": strings.bias,
            "gravity": strings.gravity,
            "input_map": strings.input_map,
            "dissipation": strings.dissipation,
        },
        "latex": codegen::display::latex(&loaded.rig, &equations),
        "assumptions": equations.assumptions,
        "ops": {"forward_dynamics": equations.forward_operations(), "jacobians": equations.jacobian_operations()},
        "hash": equations.hash,
    });
    Ok(Answer { text, json })
}
