//! The JSON of a declared rig, as another program reads it.

use codegen::emit::{declared, declared_fingerprint};

const RIG: &str = "
/// Pendulum on a cart
rig Small {
    param m: kg = 0.2 +- 10 %;
    param l: m = 250 mm fixed;
    const g: m/s^2 = 9.81;
    lump w2: 1/s^2 = g / l value 39 in 30..50;
    coord x: m in -1..1;
    coord phi: rad;
    frame cart = ground.translate(x, 0, 0);
    frame rod = cart.rotate(-y, phi + 5deg);
    body trolley on cart { mass 1 kg; }
    body bob on rod { mass m; at (0, 0, -l); inertia diag(m*l^2/12, m*l^2/12, 0); }
    gravity g;
    input V: V in -10..10;
    actuator F: N = 2 [N/V] * V { dead_zone 0.1 N; lag 50 ms; }
    torque push on x: F * exp(-t / 1 s);
    friction phi { viscous 0.01 [N*m*s]; }
    encoder phi: 4096;
    output tip: m = x + l * sin(phi) { scale 1.01; play 0.4 mm; }
    trim down { x = 10 cm; zero x, phi; solve V, phi; }
    assume { neglect coriolis in x; }
}";

fn rig(text: &str) -> model_dsl::rig::Rig {
    let checked = model_dsl::check_text("small.rig", text);
    let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    checked.rig.unwrap_or_else(|| panic!("{}", shown.join("\n")))
}

#[test]
fn small_rig() {
    let value = declared(&rig(RIG));
    let mut lines = Vec::new();
    for (key, part) in value.as_object().expect("an object") {
        match part.as_array() {
            Some(list) => lines.extend(list.iter().map(|item| format!("{key}: {item}"))),
            None => lines.push(format!("{key} = {part}")),
        }
    }
    insta::assert_snapshot!(lines.join("\n"));
}

#[test]
fn the_fingerprint_sees_values_and_structure_but_not_comments() {
    let of = |text: &str| declared_fingerprint(&declared(&rig(text)));
    assert_eq!(of(RIG), of(&RIG.replace("Pendulum on a cart", "Cart with pendulum")));
    assert_ne!(of(RIG), of(&RIG.replace("250 mm", "251 mm")));
    assert_ne!(of(RIG), of(&RIG.replace("rotate(-y,", "rotate(y,")));
}
