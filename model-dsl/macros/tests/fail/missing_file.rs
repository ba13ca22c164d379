rig_macros::rig!("tests/fail/rigs/none.rig");

fn main() {}
