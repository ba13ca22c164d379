rig_macros::rig! {
    rig Pendulum {
        param m: kg = 0.2;
        param l: m = 0.3;
        coord theta: rad;
        frame rod = ground.rotate(y, theta);
        body bob on rod { mass m; at (0, 0, -l); }
        param K_t: N*m/V = 0.02;    // torque constant
        param K_f: N/V = 0.1188;    /// thrust constant
        input V_f: V;
        force front on rod at (0, l, 0): (0, 0, K_t * V_f);
    }
}

fn main() {}
