rig_macros::rig!("rigs/none.rig");

fn main() {}
