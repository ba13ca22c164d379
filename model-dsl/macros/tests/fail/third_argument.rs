rig_macros::rig!("tests/fail/rigs/good.rig", Cart, fast);

fn main() {}
