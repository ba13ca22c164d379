rig_macros::rig! {
    rig Links {
        coord a: rad;
        frame upper = lower.rotate(z, a);
        frame lower = upper.translate(0.3, 0, 0);
        body rod on lower { mass 1; }
    }
}

fn main() {}
