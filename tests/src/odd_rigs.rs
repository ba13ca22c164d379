//! Rigs that put the printers to the test: every kind of state and signal, names that are words of the languages
//! or Greek, no inputs, no parameters, and one that is long enough to be cut into parts.

use crate::random_rig::random_rig;
use codegen::{Equations, Options, derive};

const EVERYTHING: &str = "
/// Everything at once
rig Everything {
    param m: kg = 1.2;                   // what */ moves
    param type: m = 0.4;
    param double: kg*m^2 = 0.05;
    param λ: N*m*s = 0.1;
    param lambda: N*m = 0.02;
    param tau_m: s = 0.05;
    param wait: s = 0.02;
    const g: m/s^2 = 9.81;

    coord θ: rad;
    coord sin: rad in -1..1;
    prescribed s: m;
    prescribed r: m = 0.1 m * sin(2 [rad/s] * t);
    frame cart = ground.translate(s, r, 0);
    frame arm = cart.rotate(y, θ);
    frame tip = arm.translate(type, 0, 0).rotate((1, 0, 1), sin - 0.5 * θ);
    body beam on arm { mass m; at (type / 2, 0, 0); inertia diag(double, double, double); }
    body end on tip { mass 0.5 * m; at (0, 0.1, -0.2); inertia diag(double, double, double); }
    gravity g;

    input while: N in -3..3 { delay wait; lag tau_m; }
    input V: V in -5..5 { delay 2 * wait; }
    torque motor on sin: 0.01 [N*m/V] * V;
    force fan on tip at (0, 0.1, 0): (0, 0, while);
    friction θ { viscous λ; coulomb lambda width 0.01; }
    friction sin { viscous λ; quadratic 0.01 [N*m*s^2]; }
    spring coil on sin { stiffness 0.3 [N*m]; rest 0.1; }

    encoder θ: 4096 zero at -27.5deg wrapped;
    output height: m = type * sin(θ) { scale 1.02; delay 3 * wait; play 0.01 * type; }
    output lift: m = r + 0.5 * type * sin(θ) { play 2 mm; }
}
";

const BARE: &str = "
/// A pendulum with numbers only
rig Bare {
    coord q: rad;
    frame rod = ground.rotate(x, q);
    body bob on rod { mass 2; at (0, 0, -0.5); }
    gravity 9.81;
}
";

/// Names and equations.
///
/// # Panics
/// Where one of them is wrong: this is for tests.
#[must_use]
pub fn odd_rigs() -> Vec<(&'static str, Equations)> {
    let long = random_rig(3, 7);
    [("everything", EVERYTHING), ("bare", BARE), ("long", long.as_str())]
        .into_iter()
        .map(|(name, text)| {
            let checked = model_dsl::check_text(name, text);
            let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
            let rig = checked.rig.unwrap_or_else(|| panic!("{name}:\n{}", shown.join("\n")));
            (name, derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{name}: {error}")))
        })
        .collect()
}
