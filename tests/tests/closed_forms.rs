//! Rigs whose equations or frequencies are known in closed form.

use codegen::expr::{Id, SymbolKind};
use codegen::{Equations, Options, derive};
use cross_checks::close::relative;
use cross_checks::random::Random;
use nalgebra::DMatrix;
use std::fmt::Write;

/// Everything here is exact: what differs is rounding, and conditioning of eigenvalues.
const TOLERANCE: f64 = 1e-10;

fn equations(text: &str) -> Equations {
    let checked = model_dsl::check_text("closed_form.rig", text);
    let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
    let rig = checked.rig.unwrap_or_else(|| panic!("{text}\n{}", shown.join("\n")));
    derive(&rig, Options::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Values at coordinates and rates; nominal parameters, signals zero.
fn at(e: &Equations, roots: &[Id], q: &[f64], v: &[f64]) -> Vec<f64> {
    e.graph.evaluate(roots, |s| match e.graph.symbol_info(s).kind {
        SymbolKind::Coordinate(i) => q[i],
        SymbolKind::Rate(i) => v[i],
        SymbolKind::Parameter(i) => e.layout.nominal[i],
        _ => 0.0,
    })
}

/// n equal point masses on equal massless links, joint angles relative.
fn hanging_chain(n: usize, m: f64, l: f64, g: f64) -> String {
    let mut text = format!("rig Chain {{\n param m: kg = {m}; param l: m = {l}; const g: m/s^2 = {g};\n gravity g;\n");
    let mut parent = "ground".to_owned();
    for k in 1..=n {
        let offset = if k == 1 { "" } else { ".translate(0, 0, -l)" };
        let _ = writeln!(
            text,
            " coord q{k}: rad; frame f{k} = {parent}{offset}.rotate(y, q{k}); body b{k} on f{k} {{ mass m; at (0, 0, -l); }}"
        );
        parent = format!("f{k}");
    }
    text.push('}');
    text
}

/// Roots of the Laguerre polynomial L_n: eigenvalues of its Jacobi matrix (Golub and Welsch 1969), ascending.
fn laguerre_roots(n: usize) -> Vec<f64> {
    let jacobi = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
        0 => (2 * i + 1) as f64,
        1 => i.max(j) as f64,
        _ => 0.0,
    });
    let mut roots: Vec<f64> = jacobi.symmetric_eigenvalues().iter().copied().collect();
    roots.sort_by(f64::total_cmp);
    roots
}

#[test]
fn laguerre_roots_are_the_known_ones() {
    let root = 2.0_f64.sqrt();
    assert!(relative(&laguerre_roots(2), &[2.0 - root, 2.0 + root], 1.0) < 1e-15);
    // six decimals of any table
    assert!(relative(&laguerre_roots(3), &[0.415_775, 2.294_280, 6.289_945], 1.0) < 1e-6);
}

/// Small swings of a hanging chain: squared frequencies are g/l times the roots of L_n.
#[test]
fn hanging_chain_swings_at_laguerre_roots() {
    let (m, l, g) = (0.7, 0.31, 9.81);
    for n in 2..=8 {
        let e = equations(&hanging_chain(n, m, l, g));
        let still = vec![0.0; n];
        let block: Vec<Id> = e.linear.a[n..].iter().flat_map(|row| row[..n].to_vec()).collect();
        let stiffness = -DMatrix::from_row_slice(n, n, &at(&e, &block, &still, &still));
        let values = stiffness.complex_eigenvalues();
        assert!(values.iter().all(|x| x.im.abs() < TOLERANCE * x.re), "n = {n}: {values}");
        let mut squared: Vec<f64> = values.iter().map(|x| x.re).collect();
        squared.sort_by(f64::total_cmp);
        let worst = squared.iter().zip(laguerre_roots(n)).map(|(a, root)| (a * l / g / root - 1.0).abs()).fold(0.0, f64::max);
        println!("n = {n}: worst {worst:.1e}");
        assert!(worst < TOLERANCE, "n = {n}: {worst:e}");
    }
}

/// Planar arm of two slender links: M and h at one state, and M's well-known form at others.
#[test]
fn planar_arm() {
    let e = equations(
        "rig Arm {
            const g: m/s^2 = 9.81;
            param m1: kg = 1; param m2: kg = 0.8; param l1: m = 0.5; param l2: m = 0.4;
            derived J1: kg*m^2 = m1*l1^2/12; derived J2: kg*m^2 = m2*l2^2/12;
            coord q1: rad; coord q2: rad;
            frame upper = ground.rotate(-y, q1);
            frame lower = upper.translate(0, 0, -l1).rotate(-y, q2);
            body one on upper { mass m1; at (0, 0, -l1/2); inertia diag(J1, J1, 0); }
            body two on lower { mass m2; at (0, 0, -l2/2); inertia diag(J2, J2, 0); }
            gravity g;
        }",
    );
    let (q, v) = ([0.3, -0.7], [1.1, -0.4]);
    let m = at(&e, &e.mass_matrix.concat(), &q, &v);
    let h = at(&e, &e.bias, &q, &v);
    // twelve decimals are given
    assert!(relative(&m, &[0.448_374_749_966, 0.103_854_041_649, 0.103_854_041_649, 0.042_666_666_667], 1.0) < 1e-12, "{m:?}");
    assert!(relative(&h, &[1.236_046_628_903, -0.673_591_302_212], 1.0) < 1e-12, "{h:?}");

    let (m1, m2, l1, l2) = (1.0, 0.8, 0.5, 0.4);
    let (i1, i2, lc2) = (m1 * l1 * l1 / 3.0, m2 * l2 * l2 / 3.0, l2 / 2.0);
    let mut r = Random::new(5);
    for _ in 0..20 {
        let q = [r.within(-3.0, 3.0), r.within(-3.0, 3.0)];
        let c2 = q[1].cos();
        let m12 = i2 + m2 * l1 * lc2 * c2;
        let wanted = [i1 + i2 + m2 * l1 * l1 + 2.0 * m2 * l1 * lc2 * c2, m12, m12, i2];
        assert!(relative(&at(&e, &e.mass_matrix.concat(), &q, &[0.0; 2]), &wanted, 0.0) < 1e-14);
    }
}

/// l^2 m q'' = -m g l sin(q), and its linearization at the bottom and at the top.
#[test]
fn simple_pendulum() {
    let (l, g) = (0.37, 9.81);
    let e = equations(&hanging_chain(1, 0.2, l, g));
    for q in [-2.5_f64, -0.4, 0.0, 1.3, 3.0] {
        let a = at(&e, &e.acceleration, &[q], &[2.0])[0];
        assert!((a + g / l * q.sin()).abs() < 1e-13 * g / l);
        let slope = at(&e, &e.linear.a.concat(), &[q], &[2.0]);
        assert!(relative(&slope, &[0.0, 1.0, -g / l * q.cos(), 0.0], 1.0) < 1e-14);
    }
}

/// A bead on a straight rod that turns upright: s'' = s phi'^2 - 2 c s'/m .., and the rod feels 2 m s s' phi'.
#[test]
fn bead_on_a_turning_rod() {
    let e = equations(
        "rig Bead {
            param m: kg = 0.3; param I: kg*m^2 = 0.02; const g: m/s^2 = 9.81;
            coord phi: rad; coord s: m;
            frame rod = ground.rotate(z, phi);
            frame bead = rod.translate(s, 0, 0);
            body bar on rod { inertia diag(I, I, I); }
            body mass on bead { mass m; }
            gravity g;
        }",
    );
    let (m, inertia) = (0.3, 0.02);
    let mut r = Random::new(9);
    for _ in 0..20 {
        let (s, w, u) = (r.within(-1.0, 1.0), r.within(-3.0, 3.0), r.within(-2.0, 2.0));
        let a = at(&e, &e.acceleration, &[r.within(-3.0, 3.0), s], &[w, u]);
        let wanted = [-2.0 * m * s * u * w / (inertia + m * s * s), s * w * w];
        assert!(relative(&a, &wanted, 1.0) < 1e-13, "{a:?} {wanted:?}");
    }
}

/// A bead on a hoop that is turned at a constant rate: theta'' = sin(theta) (w^2 cos(theta) - g/R); above w^2 = g/R it
/// rests beside the bottom.
#[test]
fn bead_on_a_turning_hoop() {
    let (radius, w, g) = (0.25, 9.0, 9.81);
    let e = equations(&format!(
        "rig Hoop {{
            param m: kg = 0.1; param R: m = {radius}; param w: rad/s = {w}; const g: m/s^2 = {g};
            prescribed phi: rad = w * t; coord theta: rad;
            frame hoop = ground.rotate(z, phi);
            frame bead = hoop.rotate(-y, theta);
            body mass on bead {{ mass m; at (0, 0, -R); }}
            gravity g;
        }}"
    ));
    let mut r = Random::new(11);
    for _ in 0..20 {
        let theta = r.within(-3.0, 3.0);
        let a = at(&e, &e.acceleration, &[0.4, theta], &[w, r.within(-2.0, 2.0)]);
        let wanted = theta.sin() * (w * w * theta.cos() - g / radius);
        assert!((a[1] - wanted).abs() < 1e-13 * w * w && a[0] == 0.0);
    }
    let beside = (g / (radius * w * w)).acos();
    assert!(at(&e, &e.acceleration, &[0.0, beside], &[w, 0.0])[1].abs() < 1e-13 * w * w);
}

/// A planet: r'' = r phi'^2 - k/(m r^2), phi'' = -2 r' phi'/r; a potential written directly.
#[test]
fn central_force() {
    let (m, k) = (2.0, 3.5);
    let e = equations(&format!(
        "rig Planet {{
            param m: kg = {m}; param k: N*m^2 = {k};
            coord r: m; coord phi: rad;
            frame ray = ground.rotate(z, phi);
            frame planet = ray.translate(r, 0, 0);
            body mass on planet {{ mass m; }}
            potential attraction: -k / r;
        }}"
    ));
    let mut random = Random::new(13);
    for _ in 0..20 {
        let (r, u, w) = (random.within(0.5, 2.0), random.within(-1.0, 1.0), random.within(-2.0, 2.0));
        let a = at(&e, &e.acceleration, &[r, 1.0], &[u, w]);
        assert!(relative(&a, &[r * w * w - k / (m * r * r), -2.0 * u * w / r], 1.0) < 1e-13);
    }
    // a circle
    let r: f64 = 1.3;
    let w = (k / (m * r.powi(3))).sqrt();
    assert!(at(&e, &e.acceleration, &[r, 0.0], &[0.0, w]).iter().all(|a| a.abs() < 1e-14 * k));
}

/// Steady precession of a heavy symmetric top: I_3 w_3 W - I_1 W^2 cos(theta) = m g l with w_3 = psi' + W cos(theta).
#[test]
fn heavy_top_precesses() {
    let (i1, i3, m, l, g) = (0.004, 0.0015, 0.4, 0.06, 9.81);
    let e = equations(&format!(
        "rig Top {{
            param I_1: kg*m^2 = {i1}; param I_3: kg*m^2 = {i3}; param m: kg = {m}; param l: m = {l}; const g: m/s^2 = {g};
            coord phi: rad; coord theta: rad; coord psi: rad;
            frame top = ground.rotate(z, phi).rotate(x, theta).rotate(z, psi);
            body top_body on top {{ mass m; at (0, 0, l); inertia diag(I_1, I_1, I_3) about origin; }}
            gravity g;
        }}"
    ));
    for (theta, spin) in [(0.5_f64, 300.0_f64), (1.0, 400.0), (2.0, 250.0)] {
        // (I_3 - I_1) cos(theta) W^2 + I_3 psi' W - m g l = 0, the slow root
        let (a, b, c) = ((i3 - i1) * theta.cos(), i3 * spin, -m * g * l);
        let slow = 2.0 * -c / (b + (b * b - 4.0 * a * c).sqrt());
        let acceleration = at(&e, &e.acceleration, &[0.2, theta, 0.9], &[slow, 0.0, spin]);
        let scale = m * g * l / i1;
        assert!(acceleration.iter().all(|x| x.abs() < 1e-12 * scale), "{acceleration:?}, scale {scale}");
        // and not by chance: a tenth more and the top nutates
        let off = at(&e, &e.acceleration, &[0.2, theta, 0.9], &[1.1 * slow, 0.0, spin]);
        assert!(off[1].abs() > 1e-3 * scale);
    }
}
