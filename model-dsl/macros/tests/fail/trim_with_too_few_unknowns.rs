rig_macros::rig! {
    rig Pendulum {
        param m: kg = 0.2;
        param l: m = 0.3;
        coord theta: rad;
        frame rod = ground.rotate(y, theta);
        body bob on rod { mass m; at (0, 0, -l); }
        trim held { zero theta; }
    }
}

fn main() {}
