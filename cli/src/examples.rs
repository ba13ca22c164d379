//! The example rigs, carried inside the program: an installed `rig` hands them out.

/// A rig with the name of its file.
#[derive(Clone, Copy)]
pub struct Example {
    /// `quanser`; the file is `quanser.rig`.
    pub name: &'static str,
    /// The file's text.
    pub text: &'static str,
}

/// All examples, by name.
pub const EXAMPLES: [Example; 17] = [
    Example { name: "acrobot", text: include_str!("../../examples/rigs/acrobot.rig") },
    Example { name: "aero", text: include_str!("../../examples/rigs/aero.rig") },
    Example { name: "cart_pole", text: include_str!("../../examples/rigs/cart_pole.rig") },
    Example { name: "chain3", text: include_str!("../../examples/rigs/chain3.rig") },
    Example { name: "double_pendulum", text: include_str!("../../examples/rigs/double_pendulum.rig") },
    Example { name: "emps", text: include_str!("../../examples/rigs/emps.rig") },
    Example { name: "flexible_joint", text: include_str!("../../examples/rigs/flexible_joint.rig") },
    Example { name: "furuta", text: include_str!("../../examples/rigs/furuta.rig") },
    Example { name: "googol", text: include_str!("../../examples/rigs/googol.rig") },
    Example { name: "googol_eq13", text: include_str!("../../examples/rigs/googol_eq13.rig") },
    Example { name: "googol_identified", text: include_str!("../../examples/rigs/googol_identified.rig") },
    Example { name: "googol_mrb", text: include_str!("../../examples/rigs/googol_mrb.rig") },
    Example { name: "googol_srb", text: include_str!("../../examples/rigs/googol_srb.rig") },
    Example { name: "quanser", text: include_str!("../../examples/rigs/quanser.rig") },
    Example { name: "quanser_ads", text: include_str!("../../examples/rigs/quanser_ads.rig") },
    Example { name: "quanser_ads_driven", text: include_str!("../../examples/rigs/quanser_ads_driven.rig") },
    Example { name: "tree", text: include_str!("../../examples/rigs/tree.rig") },
];

impl Example {
    /// The example of this name, with or without the file's ending.
    pub fn find(name: &str) -> Option<Self> {
        EXAMPLES.into_iter().find(|e| e.name == name.strip_suffix(".rig").unwrap_or(name))
    }

    /// The first line of its documentation.
    pub fn about(&self) -> &'static str {
        self.text.lines().find_map(|line| line.strip_prefix("///")).map_or("", str::trim)
    }

    /// Name of its file.
    pub fn file(&self) -> String {
        format!("{}.rig", self.name)
    }

    /// The examples that it is built on (`use "quanser.rig";`), theirs first.
    pub fn bases(&self) -> Vec<Self> {
        let mut bases: Vec<Self> = Vec::new();
        let used = self.text.lines().filter_map(|line| line.strip_prefix("use \"")?.split('"').next());
        for base in used.filter_map(Self::find) {
            for needed in base.bases().into_iter().chain([base]) {
                if bases.iter().all(|b| b.name != needed.name) {
                    bases.push(needed);
                }
            }
        }
        bases
    }
}
