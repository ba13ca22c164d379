//! Whole random rigs as text: trees of any shape, all kinds of joints, bodies, forces, springs and friction.

use crate::random::Random;
use std::fmt::Write;

/// Text of a random rig with `n` coordinates; every joint moves inertia, every tensor is one of a mass distribution.
#[must_use]
pub fn random_rig(seed: u64, n: usize) -> String {
    let mut r = Random::new(seed);
    let mut text = format!("rig Random{seed} {{\n    const g: m/s^2 = 9.81;\n    gravity g along {};\n", ["-z", "-y", "x"][r.below(3)]);
    let mut frames: Vec<String> = vec!["ground".to_owned()];
    let mut prismatic = Vec::new();
    for k in 0..n {
        let parent = frames[if r.chance(0.7) { frames.len() - 1 } else { r.below(frames.len()) }].clone();
        let slides = r.chance(0.25);
        prismatic.push(slides);
        let unit = if slides { "m" } else { "rad" };
        let _ = writeln!(text, "    coord q{k}: {unit};");
        let mut chain = String::new();
        if r.chance(0.6) {
            let _ = write!(chain, ".translate({}, {}, {})", offset(&mut r), offset(&mut r), offset(&mut r));
        }
        if r.chance(0.3) {
            let _ = write!(chain, ".rotate({}, {:.3})", axis(&mut r), r.within(-2.0, 2.0));
        }
        // a belt: the joint turns with an earlier joint too
        let other = (0..k).rev().find(|&j| prismatic[j] == slides).filter(|_| r.chance(0.2));
        let angle = other.map_or_else(|| format!("q{k}"), |j| format!("q{k} - {:.2} * q{j}", r.within(0.2, 1.5)));
        if slides {
            let mut parts = ["0".to_owned(), "0".to_owned(), "0".to_owned()];
            parts[r.below(3)] = angle;
            let _ = write!(chain, ".translate({})", parts.join(", "));
        } else {
            let _ = write!(chain, ".rotate({}, {angle})", axis(&mut r));
        }
        let _ = writeln!(text, "    frame f{k} = {parent}{chain};");
        frames.push(format!("f{k}"));
        // a body with three dimensions, so that no joint is without inertia
        let size = [r.within(0.1, 0.4), r.within(0.1, 0.4), r.within(0.1, 0.4)];
        let m = r.within(0.3, 2.0);
        let _ = writeln!(text, "    param m{k}: kg = {m:.4};");
        let tensor = |a: f64, b: f64| m * (a * a + b * b) / 12.0;
        let about = if r.chance(0.3) { " about origin" } else { "" };
        let center = if about.is_empty() { [r.within(-0.3, 0.3), r.within(-0.3, 0.3), r.within(-0.3, 0.3)] } else { [0.0; 3] };
        let _ = writeln!(
            text,
            "    body b{k} on f{k} {{ mass m{k}; at ({:.3}, {:.3}, {:.3}); inertia diag({:.5}, {:.5}, {:.5}){about}; }}",
            center[0],
            center[1],
            center[2],
            tensor(size[1], size[2]),
            tensor(size[0], size[2]),
            tensor(size[0], size[1])
        );
        extras(&mut r, &mut text, k, slides, &frames);
    }
    text.push_str("}\n");
    text
}

fn extras(r: &mut Random, text: &mut String, k: usize, slides: bool, frames: &[String]) {
    let (torque, force) = ("N*m", "N");
    let per = |unit: &str| if slides { format!("{unit}*s/m") } else { format!("{unit}*s") };
    let row = if slides { force } else { torque };
    if r.chance(0.5) {
        let _ = writeln!(text, "    param c{k}: {} = {:.3};\n    friction q{k} {{ viscous c{k}; }}", per(row), r.within(0.01, 0.4));
    }
    if r.chance(0.3) {
        let stiffness = if slides { "N/m" } else { "N*m" };
        let _ = writeln!(
            text,
            "    param k{k}: {stiffness} = {:.3};\n    spring s{k} on q{k} {{ stiffness k{k}; rest 0.1; }}",
            r.within(0.5, 5.0)
        );
    }
    if r.chance(0.5) {
        let _ = writeln!(text, "    input u{k}: {row};\n    torque t{k} on q{k}: u{k};");
    }
    if r.chance(0.4) {
        let _ = writeln!(
            text,
            "    input w{k}: N;\n    force p{k} on f{k} at ({}, {}, 0.1): (0, w{k}, 0){};",
            offset(r),
            offset(r),
            if r.chance(0.4) { " in ground" } else { "" }
        );
    }
    if r.chance(0.2) && frames.len() > 2 {
        let other = &frames[1 + r.below(frames.len() - 2)];
        let _ = writeln!(text, "    input x{k}: N*m;\n    torque y{k} on f{k}: (x{k}, 0, x{k}) against {other};");
    }
}

fn offset(r: &mut Random) -> String {
    if r.chance(0.4) { "0".to_owned() } else { format!("{:.3}", r.within(-0.6, 0.6)) }
}

fn axis(r: &mut Random) -> String {
    if r.chance(0.15) {
        return format!("({:.2}, {:.2}, {:.2})", r.within(0.2, 1.0), r.within(-1.0, 1.0), r.within(-1.0, 1.0));
    }
    ["x", "y", "z", "-x", "-y", "-z"][r.below(6)].to_owned()
}
