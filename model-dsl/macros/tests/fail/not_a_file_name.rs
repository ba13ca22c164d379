rig_macros::rig!(42);

fn main() {}
