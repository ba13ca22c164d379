rig_macros::rig! {
    rig Cart {
        parm m: kg = 1;
        coord x: m;
        frame cart = ground.translate(x, 0, 0);
        body block on cart { mass 20 mm; }
    }
}

fn main() {}
