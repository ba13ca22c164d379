rig_macros::rig!("rigs/cart.rig", Cart, fast);

fn main() {}
