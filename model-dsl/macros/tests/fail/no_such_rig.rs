rig_macros::rig!("tests/fail/rigs/good.rig", Cartt);

fn main() {}
