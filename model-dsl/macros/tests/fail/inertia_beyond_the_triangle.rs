rig_macros::rig! {
    rig Wheel {
        coord psi: rad;
        frame disc = ground.rotate(z, psi);
        body wheel on disc { mass 1; inertia diag(0.01, 0.01, 0.05); }
    }
}

fn main() {}
