rig_macros::rig! {
    rig Pendulum {
        param m: kg = 0.2;
        param l: m = 0.3;
        coord theta: rad;
        frame rod = ground.rotate(y, theta);
        body bob on rod { mass m; at (0, 0, -l); }
        param tau_max: N*m = 2;
        input V: V;
        torque motor on theta: tau_mex * V / 1 V - tau_mex;
    }
}

fn main() {}
