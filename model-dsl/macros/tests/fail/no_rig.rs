rig_macros::rig! {}

fn main() {}
