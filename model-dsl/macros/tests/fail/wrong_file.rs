rig_macros::rig!("tests/fail/rigs/wrong.rig");

fn main() {}
