rig_macros::rig! {
    rig Arm {
        coord psi: rad;
        coord theta: rad;
        frame arm = ground.rotate(z, psi);
        frame tip = arm.translate(0.3, 0, 0).rotate(x, theta);
        body bob on tip { mass 0.2; }
    }
}

fn main() {}
