//! `rig!`: models that it makes, and messages that the compiler shows. The messages are in `fail/*.stderr`
//! (`TRYBUILD=overwrite` writes them anew; then read each one as the person who made the mistake).

use runtime::Model;

rig_macros::rig! {
    /// A pendulum
    rig Pendulum {
        param m: kg = 0.2;
        param l: m = 0.4;            /// pivot to bob
        const g: m/s^2 = 9.81;
        coord theta: rad;
        frame rod = ground.rotate(y, theta);
        body bob on rod { mass m; at (0, 0, -l); }
        gravity g;
        input tau: N*m;
        torque motor on theta: tau - 0.01 [N*m*s] * theta.dot;
    }
}

rig_macros::rig!("../../examples/rigs/googol_mrb.rig");
rig_macros::rig!("../../tests/rigs/statements/extends_replace_remove.rig", Base);

rig_macros::rig! {
    use "../../examples/rigs/cart_pole.rig";

    rig HeavyPole extends CartPole {
        replace param m_p: kg = 0.4;
    }
}

#[test]
fn a_pendulum_falls_as_it_should() {
    use pendulum::{Coordinates, Inputs, Parameters, Rates, State};
    let x = State { q: Coordinates { theta: 0.3 }, v: Rates { theta: 0.7 } };
    let a = pendulum::forward_dynamics(&x, &Inputs { tau: 0.05 }, &Parameters::NOMINAL).expect("a regular mass matrix");
    let (m, l, g) = (0.2, 0.4, 9.81);
    let wanted = (0.05 - 0.01 * 0.7 - m * g * l * 0.3_f64.sin()) / (m * l * l);
    assert!((a.theta - wanted).abs() < 1e-12 * wanted.abs(), "{} is not {wanted}", a.theta);
}

#[test]
fn files_and_their_variants_become_modules() {
    assert_eq!(googol_mrb::GoogolMrb.dimensions().coordinates, 3);
    assert_eq!(base::Base.names().state(0), "x");
    assert_eq!(heavy_pole::Parameters::NOMINAL.m_p, 0.4);
    assert_eq!(heavy_pole::HeavyPole.dimensions().parameters, 4);
}

#[test]
fn messages_of_the_macro() {
    trybuild::TestCases::new().compile_fail("tests/fail/*.rs");
}
