//! The rigs that are measured: three that CasADi derives too, and families that grow.

use codegen::{Equations, Options, derive};
use model_dsl::rig::Rig;
use std::fmt::Write;

/// Rigs that are compared, by name.
pub const COMPARED: [(&str, &str); 3] = [
    ("heli3", include_str!("../rigs/heli3.rig")),
    ("chain4", include_str!("../rigs/chain4.rig")),
    ("spatial6", include_str!("../rigs/spatial6.rig")),
];

/// How the joints of a family hang together.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// One after the other, all axes parallel.
    Planar,
    /// One after the other, axes z, y, x in turn.
    Chain,
    /// Joint k hangs on joint k/2, axes z, y, x in turn.
    Tree,
}

/// Text of a rig of `n` joints.
#[must_use]
pub fn family(shape: Shape, n: usize) -> String {
    let mut text = String::from("rig Family {\n    param g: m/s^2 = 9.81;\n");
    for i in 1..=n {
        let _ = writeln!(text, "    param m_{i}: kg = 1; param l_{i}: m = 0.5; param I_{i}: kg*m^2 = 0.05; coord q_{i}: rad;");
    }
    for i in 1..=n {
        let parent = if shape == Shape::Tree { i / 2 } else { i - 1 };
        let base = if parent == 0 { "ground".to_owned() } else { format!("link_{parent}.translate(l_{parent}, 0, 0)") };
        let axis = if shape == Shape::Planar { "y" } else { ["z", "y", "x"][(i - 1) % 3] };
        let _ = writeln!(text, "    frame link_{i} = {base}.rotate({axis}, q_{i});");
    }
    for i in 1..=n {
        let _ = writeln!(text, "    body rod_{i} on link_{i} {{ mass m_{i}; at (l_{i}/2, 0, 0); inertia diag(I_{i}, I_{i}, I_{i}); }}");
        let _ = writeln!(text, "    input u_{i}: N*m; torque drive_{i} on q_{i}: u_{i};");
    }
    text.push_str("    gravity g;\n}\n");
    text
}

/// Parses and checks a rig.
///
/// # Errors
/// The diagnostics, as text.
pub fn check(name: &str, text: &str) -> Result<Rig, String> {
    let checked = model_dsl::check_text(name, text);
    checked.rig.ok_or_else(|| checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect::<Vec<_>>().join("\n"))
}

/// Derives a rig with all Jacobians.
///
/// # Errors
/// What `derive` says.
pub fn equations(rig: &Rig) -> Result<Equations, String> {
    derive(rig, Options::default()).map_err(|e| e.to_string())
}
