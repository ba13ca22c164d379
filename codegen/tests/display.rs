//! Equations as a person writes them, read by eye in the snapshots; and the difference of two models.

use codegen::display::{diff, latex, strings, text};
use codegen::{Equations, Lumps, Options, derive};
use model_dsl::rig::Rig;
use std::fmt::Write;
use std::path::PathBuf;

fn example(name: &str) -> Rig {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../examples/rigs").join(name);
    let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
    let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    checked.rig.unwrap_or_else(|| panic!("{name}:\n{}", shown.join("\n")))
}

fn from_text(text: &str) -> Rig {
    let checked = model_dsl::check_text("test.rig", text);
    let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    checked.rig.unwrap_or_else(|| panic!("{}", shown.join("\n")))
}

fn equations(rig: &Rig) -> Equations {
    derive(rig, Options::default()).expect("equations")
}

fn examples() -> Vec<String> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../examples/rigs");
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .expect("example rigs")
        .flatten()
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .filter(|n| n.ends_with(".rig"))
        .collect();
    names.sort();
    names
}

#[test]
fn every_example_reads_like_notes() {
    for name in examples() {
        let rig = example(&name);
        let e = equations(&rig);
        let stem = name.trim_end_matches(".rig");
        insta::assert_snapshot!(format!("{stem}_text"), text(&rig, &e));
        insta::assert_snapshot!(format!("{stem}_latex"), latex(&rig, &e));
    }
}

#[test]
fn quantities_as_strings() {
    let rig = example("googol.rig");
    let s = strings(&rig, &equations(&rig));
    insta::assert_snapshot!(format!("{}\n\n{}\n\n{}\n\n{}\n\n{}", s.mass_matrix, s.bias, s.gravity, s.input_map, s.dissipation));
}

#[test]
fn gravity_of_the_helicopter_is_that_of_the_paper() {
    let rig = example("googol.rig");
    let gravity = strings(&rig, &equations(&rig)).gravity;
    assert_eq!(gravity, "gravity[eps] = m_h g l_cd cos(theta) sin(eps) + m' g cos(eps)\ngravity[theta] = m_h g l_cd cos(eps) sin(theta)");
}

fn difference(first: &Rig, second: &Rig) -> codegen::display::Diff {
    let options = Options { lumps: Lumps::Expanded, jacobians: false, ..Options::default() };
    let (a, b) = (derive(first, options).expect("equations"), derive(second, options).expect("equations"));
    diff((first, &a), (second, &b))
}

#[test]
fn differences_are_listed_with_sizes() {
    let mut out = String::new();
    for (a, b) in [
        ("googol.rig", "googol_mrb.rig"),
        ("googol_mrb.rig", "googol.rig"),
        ("googol_mrb.rig", "googol_eq13.rig"),
        ("googol_mrb.rig", "googol_identified.rig"),
        ("googol_mrb.rig", "googol_srb.rig"),
        ("furuta.rig", "cart_pole.rig"),
    ] {
        let _ = writeln!(out, "$ rig diff {a} {b}\n{}", difference(&example(a), &example(b)));
    }
    insta::assert_snapshot!(out);
}

#[test]
fn the_misprinted_term_is_the_only_difference() {
    let d = difference(&example("googol_mrb.rig"), &example("googol_eq13.rig"));
    assert!(d.added.is_empty() && d.removed.is_empty());
    let [term] = d.changed.as_slice() else { panic!("{d}") };
    assert_eq!((term.quantity.as_str(), term.term.as_str()), ("forces in psi", "-l_df sin(eps) f_d -> -l_df sin(eps) sin(theta) f_d"));
}

#[test]
fn every_example_equals_itself() {
    for name in examples() {
        let rig = example(&name);
        let d = difference(&rig, &rig);
        assert!(d.added.is_empty() && d.removed.is_empty() && d.changed.is_empty() && d.values.is_empty(), "{name}: {d}");
    }
}

/// One of everything that a rig can say.
const EVERYTHING: &str = r"
/// One of everything
rig Everything {
    param m: kg = 1;  param M: kg = 2;  param l: m = 0.5;  param J: kg*m^2 = 0.01;  param n: 1 = 3;  const g: m/s^2 = 9.81;
    param k: N/m = 3;  param k3: N/m^3 = 2;  param r: m = 0.1;  param k_t: N*m = 1.2;
    param c: N*s/m = 0.2;  param F_c: N*m = 0.3;  param F_s: N*m = 0.1;  param v_s: rad/s = 0.3;  param w: rad/s = 0.02;
    param c_2: N*m*s^2 = 0.1;  param tau_m: s = 0.05;  param K: N/V = 2;  param d: s = 0.01;  param tilt: rad = 0.1;
    coord x: m in -1..1;  coord alpha: rad;  coord beta: rad;  prescribed s: m;  prescribed y: m = 0.1 m * sin(2 [rad/s] * t);
    frame cart = ground.translate(x + s, 0, y);
    frame upper = cart.rotate(y, alpha + 30deg);
    frame lower = upper.translate(0, 0, -l).rotate(y, beta);
    body A on cart { mass M; }
    body B on upper { mass m; at (0, 0, -l); }
    body C on lower { mass m; at (0, 0, -l/2); inertia diag(J, J, 0); }
    gravity g along (sin(tilt), 0, -cos(tilt));
    input V: V in -10..10;  input tau: N*m;
    actuator F: N = K * V { delay d; dead_zone 0.2 N; saturate -5..5; lag tau_m; }
    actuator fan: N = 0.3981 N * (V / 1 V)^2.072 + 0.4988 N;
    force push on cart at (0, 0, 0): (F + fan, 0, 0) in ground;
    torque motor on lower: (0, tau, 0) against upper;
    spring coil on x { stiffness k; rest r; cubic k3; }
    spring rope from upper at (0, 0, -l) to ground at (1, 0, 1) { stiffness k; rest r; }
    spring elastic on alpha - beta { stiffness k_t; }
    friction alpha { coulomb F_c width w; stribeck F_s speed v_s; quadratic c_2; }
    friction elbow on alpha - beta { viscous 0.1 [N*m*s]; asymmetric 0.01 [N*m*s], 0.2 [N*m]; }
    damper oil from cart at (0, 0, 0) to ground at (1, 0, 2) { viscous c; }
    kinetic rotor: 1/2 * J * (n * beta.dot + alpha.dot)^2;
    potential magnet: k_t * exp(-alpha^2) + k_t * abs(beta) + k_t * atan2(alpha, beta);
    output height: m = l * cos(alpha) { scale 1.02; bias r; delay d; }
    output turned: deg = alpha - beta { play 0.2deg; }
    output moved: m = x { play 2 * r; }
    encoder alpha: 4096 zero at -27.5deg;
}";

#[test]
fn one_of_everything() {
    let rig = from_text(EVERYTHING);
    let e = equations(&rig);
    insta::assert_snapshot!("everything_text", text(&rig, &e));
    insta::assert_snapshot!("everything_latex", latex(&rig, &e));
}

/// A chain of joints about the given axes, with all parameters symbolic.
fn chain(axes: &str) -> Rig {
    let mut out = "/// Chain\nrig Chain { const g: m/s^2 = 9.81; gravity g;\n".to_owned();
    for (k, axis) in axes.chars().enumerate() {
        let k = k + 1;
        let parent = if k == 1 { "ground".to_owned() } else { format!("link{}.translate(0, 0, l_{})", k - 1, k - 1) };
        let _ = writeln!(
            out,
            "param m_{k}: kg = 1; param l_{k}: m = 0.4; param c_{k}: m = 0.1; param I_{k}x: kg*m^2 = 0.02; param I_{k}y: kg*m^2 = 0.03; param I_{k}z: kg*m^2 = 0.025;
             coord q{k}: rad; input tau_{k}: N*m; torque motor_{k} on q{k}: tau_{k};
             frame link{k} = {parent}.rotate({axis}, q{k});
             body b{k} on link{k} {{ mass m_{k}; at (0, c_{k} / 5, c_{k}); inertia diag(I_{k}x, I_{k}y, I_{k}z); }}"
        );
    }
    out.push('}');
    from_text(&out)
}

#[test]
fn planar_chains_use_sums_of_angles() {
    let rig = chain("yyy");
    insta::assert_snapshot!(text(&rig, &equations(&rig)));
}

#[test]
fn long_models_are_written_over_named_parts() {
    let rig = chain("zyyxyx");
    let e = derive(&rig, Options { jacobians: false, ..Options::default() }).expect("equations");
    let shown = text(&rig, &e);
    assert_eq!(shown, text(&rig, &e));
    // hand-expanded, these equations have some ten thousand terms
    assert!(shown.lines().count() < 500, "{} lines", shown.lines().count());
    assert!(shown.lines().all(|l| l.chars().count() <= 130), "a line is too long:\n{shown}");
    insta::assert_snapshot!("six_joints_beginning", shown.lines().take(60).collect::<Vec<_>>().join("\n"));
    let d = difference(&rig, &rig);
    assert!(d.changed.is_empty() && d.added.is_empty() && d.removed.is_empty());
}

#[test]
fn functions_of_functions_do_not_explode() {
    // written out, the last one has 2^40 names
    let mut out = "rig Nested { param d0: 1 = 0.3; coord q: rad; frame f = ground.rotate(z, q); body b on f { mass 1 kg; at (1, 0, 0); }\n"
        .to_owned();
    for k in 1..=40 {
        let _ = writeln!(out, "derived d{k}: 1 = sin(d{} + cos(d{}));", k - 1, k - 1);
    }
    out.push_str("torque t on q: 1 [N*m] * d40; }");
    let rig = from_text(&out);
    let shown = text(&rig, &equations(&rig));
    assert!(shown.len() < 20_000, "{shown}");
    assert_eq!(difference(&rig, &rig).to_string(), "the equations are the same\n");
}
