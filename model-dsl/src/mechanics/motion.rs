//! E0304: every free coordinate moves inertia, and no two move the same one. Small forward kinematics in numbers: the
//! mass matrix sum m J_v^T J_v + J_w^T I J_w at a few pseudo-random configurations within the ranges of travel.

use super::matrix::{M3, UNIT, V3, add, cross, dot, eigen, rotation, scale, steiner, tensor, times, turn, turn_back};
use super::{Context, shown};
use crate::diagnostic::Diagnostic;
use crate::rig::{AssumptionKind, Axis, Body, EnergyKind, Expr, FrameRef, InertiaPoint, Rig, Span, Step, Symbol};

/// Beyond this many coordinates only the question "does anything stand on its frames" is asked.
const LARGEST: usize = 64;
/// Rounding of kinematics squared lies near 1e-30 of m (1 + L^2), real inertias far above this.
const NOTHING: f64 = 1e-24;
/// Smallest eigenvalue of the mass matrix scaled to ones on its diagonal: rounding is near 1e-15.
const SINGULAR: f64 = 1e-13;

/// A configuration: pseudo-random (a low-discrepancy sequence), within the ranges of travel.
pub(super) fn sample(rig: &Rig, k: usize) -> Vec<f64> {
    let place = |i: usize| {
        let (lo, hi) = rig.coordinates[i].range.unwrap_or((-1.0, 1.0));
        let golden = 0.618_033_988_749_894_9;
        lo + (hi - lo) * (0.37 + golden * (k + 1) as f64 * (i + 1) as f64 + 0.237 * i as f64).fract()
    };
    (0..rig.coordinates.len()).map(place).collect()
}

/// Where a frame is, and how it moves with each coordinate; components in ground.
#[derive(Clone)]
struct Pose {
    /// R_GF
    r: M3,
    /// p_GF
    p: V3,
    /// Columns of the Jacobian of the origin's velocity.
    linear: Vec<V3>,
    /// Columns of the Jacobian of the angular velocity.
    angular: Vec<V3>,
}

pub(super) fn check(c: &Context<'_>, unused: &[bool], diagnostics: &mut Vec<Diagnostic>) {
    let n = c.rig.coordinates.len();
    let free: Vec<usize> = (0..n).filter(|&i| !c.rig.coordinates[i].prescribed && !unused[i]).collect();
    if let Some(entries) =
        c.rig.assumptions.iter().find_map(|a| if let AssumptionKind::InertiaDiagonal(e) = &a.kind { Some((e, a.span)) } else { None })
    {
        return assumed(c, entries.0, entries.1, diagnostics);
    }
    if !c.rig.equations.is_empty() {
        return equations(c, &free, diagnostics);
    }
    if n > LARGEST {
        return structural(c, &free, diagnostics);
    }
    let samples: Vec<(Vec<Vec<f64>>, f64)> = (0..3).map(|k| mass_matrix(c, &sample(c.rig, k))).collect();
    if samples.iter().any(|(m, _)| m.iter().flatten().any(|x| !x.is_finite())) {
        return;
    }
    let moved = |i: usize| samples.iter().any(|(m, size)| m[i][i].abs() > NOTHING * size);
    let mut moving = Vec::new();
    for i in free {
        if moved(i) {
            moving.push(i);
        } else {
            diagnostics.push(nothing_moves(c, i));
        }
    }
    jointly(c, &moving, &samples, diagnostics);
}

/// M, and the size m (1 + L^2) + I that its entries are small against.
fn mass_matrix(c: &Context<'_>, q: &[f64]) -> (Vec<Vec<f64>>, f64) {
    let n = q.len();
    let mut m = vec![vec![0.0; n]; n];
    let mut size = 0.0;
    let ground = Pose { r: UNIT, p: [0.0; 3], linear: vec![[0.0; 3]; n], angular: vec![[0.0; 3]; n] };
    let mut poses: Vec<Pose> = Vec::new();
    for frame in &c.rig.frames {
        let parent = match frame.parent {
            FrameRef::Ground => &ground,
            FrameRef::Frame(k) => poses.get(k).unwrap_or(&ground),
        };
        let mut pose = parent.clone();
        for step in &frame.steps {
            walk(c, &mut pose, step, q);
        }
        poses.push(pose);
    }
    for b in &c.rig.bodies {
        let pose = match b.frame {
            FrameRef::Ground => &ground,
            FrameRef::Frame(k) => poses.get(k).unwrap_or(&ground),
        };
        let (mass, center, inertia) = body(c, b);
        let arm = turn(&pose.r, center);
        let linear: Vec<V3> = (0..n).map(|i| add(pose.linear[i], cross(pose.angular[i], arm))).collect();
        let angular: Vec<V3> = pose.angular.iter().map(|w| turn_back(&pose.r, *w)).collect();
        for i in 0..n {
            let spin = turn(&inertia, angular[i]);
            for j in 0..n {
                m[i][j] += mass * dot(linear[i], linear[j]) + dot(spin, angular[j]);
            }
        }
        let reach = add(pose.p, arm);
        size += mass.abs() * (1.0 + dot(reach, reach)) + inertia.iter().flatten().fold(0.0_f64, |s, x| s.max(x.abs()));
    }
    for f in c.rig.functions.iter().filter(|f| f.kind == EnergyKind::Kinetic) {
        // T is quadratic in the rates: the mixed second derivative is a difference of values
        let at = |i: usize, j: Option<usize>| {
            let mut v = vec![0.0; n];
            v[i] += 1.0;
            if let Some(j) = j {
                v[j] += 1.0;
            }
            c.numbers.at(&f.value, q, &v)
        };
        let alone: Vec<f64> = (0..n).map(|i| at(i, None)).collect();
        for i in 0..n {
            for j in 0..n {
                let entry = if i == j { 2.0 * alone[i] } else { at(i, Some(j)) - alone[i] - alone[j] };
                m[i][j] += entry;
                size += entry.abs();
            }
        }
    }
    (m, size)
}

/// Mass, centre of mass, and the inertia about it.
fn body(c: &Context<'_>, b: &Body) -> (f64, V3, M3) {
    let at = |e: &Expr| c.numbers.at(e, &[], &[]);
    let (mass, center) = (at(&b.mass), std::array::from_fn(|k| at(&b.center[k])));
    let mut inertia = tensor(std::array::from_fn(|k| at(&b.inertia[k])));
    if matches!(b.about, InertiaPoint::FrameOrigin) {
        let moved = steiner(mass, center);
        inertia = std::array::from_fn(|i| std::array::from_fn(|j| inertia[i][j] - moved[i][j]));
    }
    (mass, center, inertia)
}

fn walk(c: &Context<'_>, pose: &mut Pose, step: &Step, q: &[f64]) {
    let n = q.len();
    // affine in the coordinates: the slope is the difference of two values
    let slope = |e: &Expr, i: usize| {
        let mut one = vec![0.0; n];
        one[i] = 1.0;
        if uses(e, i) { c.numbers.at(e, &one, &[]) - c.numbers.at(e, &vec![0.0; n], &[]) } else { 0.0 }
    };
    match step {
        Step::Rotate { axis, angle } => {
            let axis = direction(axis);
            let in_ground = turn(&pose.r, axis);
            for i in 0..n {
                pose.angular[i] = add(pose.angular[i], scale(slope(angle, i), in_ground));
            }
            pose.r = times(&pose.r, &rotation(axis, c.numbers.at(angle, q, &[])));
        }
        Step::Translate(offset) => {
            let arm = turn(&pose.r, std::array::from_fn(|k| c.numbers.at(&offset[k], q, &[])));
            for i in 0..n {
                let slide = turn(&pose.r, std::array::from_fn(|k| slope(&offset[k], i)));
                pose.linear[i] = add(pose.linear[i], add(slide, cross(pose.angular[i], arm)));
            }
            pose.p = add(pose.p, arm);
        }
    }
}

fn direction(axis: &Axis) -> V3 {
    match axis {
        Axis::Principal { index, negative } => std::array::from_fn(|k| {
            if k != *index {
                0.0
            } else if *negative {
                -1.0
            } else {
                1.0
            }
        }),
        Axis::Vector(v) => *v,
    }
}

fn uses(e: &Expr, i: usize) -> bool {
    match e {
        Expr::Number(_) => false,
        Expr::Symbol(s) => *s == Symbol::Coordinate(i),
        Expr::Neg(a) => uses(a, i),
        Expr::Binary(_, a, b) => uses(a, i) || uses(b, i),
        Expr::Call(_, args) => args.iter().any(|a| uses(a, i)),
    }
}

fn moves(step: &Step, i: usize) -> bool {
    match step {
        Step::Rotate { angle, .. } => uses(angle, i),
        Step::Translate(offset) => offset.iter().any(|e| uses(e, i)),
    }
}

/// Frames that carry mass or inertia.
fn carrying(c: &Context<'_>, bodies: &[(f64, V3, M3)]) -> Vec<bool> {
    let mut out = vec![false; c.rig.frames.len()];
    for (b, (mass, _, inertia)) in c.rig.bodies.iter().zip(bodies) {
        if let FrameRef::Frame(k) = b.frame
            && (*mass != 0.0 || inertia.iter().flatten().any(|x| *x != 0.0))
        {
            out[k] = true;
        }
    }
    for k in (0..out.len()).rev() {
        if out[k]
            && let FrameRef::Frame(parent) = c.rig.frames[k].parent
        {
            out[parent] = true;
        }
    }
    out
}

fn structural(c: &Context<'_>, free: &[usize], diagnostics: &mut Vec<Diagnostic>) {
    let bodies: Vec<_> = c.rig.bodies.iter().map(|b| body(c, b)).collect();
    let carrying = carrying(c, &bodies);
    let mut moved = vec![false; c.rig.coordinates.len()];
    let mut mark = |e: &Expr| {
        for s in e.symbols() {
            if let Symbol::Coordinate(i) | Symbol::Rate(i) = s {
                moved[i] = true;
            }
        }
    };
    for (frame, _) in c.rig.frames.iter().zip(&carrying).filter(|(_, carries)| **carries) {
        for step in &frame.steps {
            match step {
                Step::Rotate { angle, .. } => mark(angle),
                Step::Translate(offset) => offset.iter().for_each(&mut mark),
            }
        }
    }
    for f in c.rig.functions.iter().filter(|f| f.kind == EnergyKind::Kinetic) {
        mark(&f.value);
    }
    for &i in free.iter().filter(|&&i| !moved[i]) {
        diagnostics.push(nothing_moves(c, i));
    }
}

/// Why M[i, i] = 0.
fn nothing_moves(c: &Context<'_>, i: usize) -> Diagnostic {
    let q = &c.rig.coordinates[i];
    let message = format!("`{}` moves no inertia", q.name);
    let frames: Vec<usize> = (0..c.rig.frames.len()).filter(|&k| c.rig.frames[k].steps.iter().any(|s| moves(s, i))).collect();
    let Some(&first) = frames.first() else {
        return Diagnostic::error("E0304", message, q.span, format!("no frame moves with `{}`", q.name)).help(format!(
            "let a frame move with it, as in `frame NAME = ground.{};`, and put a body on that",
            joint(q.unit.text == "m", &q.name)
        ));
    };
    let frame = &c.rig.frames[first];
    let span = c.head("frame", &frame.name, frame.span);
    // bodies on the frame, or on what it carries
    let mut carried = vec![false; c.rig.frames.len()];
    for k in 0..carried.len() {
        carried[k] = frames.contains(&k) || matches!(c.rig.frames[k].parent, FrameRef::Frame(p) if carried[p]);
    }
    let bodies: Vec<&Body> = c.rig.bodies.iter().filter(|b| matches!(b.frame, FrameRef::Frame(k) if carried[k])).collect();
    let massless = bodies.iter().all(|b| {
        let (m, _, inertia) = body(c, b);
        m == 0.0 && inertia.iter().flatten().all(|x| *x == 0.0)
    });
    let entry = format!("M[{0}, {0}] = 0", q.name);
    let every = if bodies.iter().all(|b| matches!(b.frame, FrameRef::Frame(k) if frames.contains(&k))) {
        format!("every body on `{}`", frame.name)
    } else {
        format!("every body that `{}` carries", frame.name)
    };
    if bodies.is_empty() {
        return Diagnostic::error("E0304", message, span, format!("no body stands on `{}`, so {entry}", frame.name))
            .help(format!("put a body on it: `body NAME on {} {{ mass m; at (x, y, z); }}`", frame.name));
    }
    if massless {
        return Diagnostic::error("E0304", message, span, format!("{every} has mass 0, so {entry}"))
            .help(format!("give a body on `{}` a mass or an inertia", frame.name));
    }
    let axis = frame.steps.iter().find_map(|s| match s {
        Step::Rotate { axis, angle } if uses(angle, i) => Some(match axis {
            Axis::Principal { index, .. } => ["x", "y", "z"][*index].to_owned(),
            Axis::Vector(v) => format!("({}, {}, {})", shown(v[0]), shown(v[1]), shown(v[2])),
        }),
        _ => None,
    });
    match axis {
        Some(axis) if frames.len() == 1 => {
            let points = bodies.iter().all(|b| b.inertia.iter().all(|e| c.numbers.at(e, &[], &[]) == 0.0));
            let label = if points {
                format!("{every} is a point on the axis {axis}, so {entry}")
            } else {
                format!("{every} lies on the axis {axis} and has no inertia about it, so {entry}")
            };
            Diagnostic::error("E0304", message, span, label)
                .help(format!("give a body on `{}` an inertia, or an offset from the axis", frame.name))
        }
        _ => Diagnostic::error("E0304", message, span, format!("the steps that `{}` drives undo each other, so {entry}", q.name))
            .help("check the signs in the chain of frames"),
    }
}

fn joint(slides: bool, name: &str) -> String {
    if slides { format!("translate({name}, 0, 0)") } else { format!("rotate(z, {name})") }
}

/// Far from singular: all pivots of L D L^T are well above zero. Most rigs need no eigenvalues.
fn regular(matrix: &[Vec<f64>]) -> bool {
    let mut m = matrix.to_vec();
    let n = m.len();
    for k in 0..n {
        if m[k][k].is_nan() || m[k][k] < 1e-8 {
            return false;
        }
        let pivot = m[k].clone();
        for row in m.iter_mut().skip(k + 1) {
            let f = row[k] / pivot[k];
            for (x, p) in row.iter_mut().zip(&pivot).skip(k) {
                *x -= f * p;
            }
        }
    }
    true
}

/// Coordinates that move the same inertia, and inertias that are negative.
fn jointly(c: &Context<'_>, moving: &[usize], samples: &[(Vec<Vec<f64>>, f64)], diagnostics: &mut Vec<Diagnostic>) {
    let negative_mass = diagnostics.iter().any(|d| matches!(d.code, "E0303" | "E0306" | "E0308"));
    if moving.is_empty() || negative_mass {
        return;
    }
    let mut worst: Option<(f64, Vec<f64>)> = None;
    for (m, _) in samples {
        if moving.iter().any(|&i| m[i][i] <= 0.0) {
            // singular at this configuration only, or negative at it
            if let Some(&i) = moving.iter().find(|&&i| m[i][i] < 0.0) {
                let q = &c.rig.coordinates[i];
                diagnostics.push(
                    Diagnostic::error(
                        "E0306",
                        format!("the kinetic energy is negative when `{}` moves", q.name),
                        q.span,
                        format!("M[{0}, {0}] = {1}", q.name, shown(m[i][i])),
                    )
                    .help("check the signs of inertias in `kinetic` functions"),
                );
                return;
            }
            return;
        }
        let scaled: Vec<Vec<f64>> =
            moving.iter().map(|&i| moving.iter().map(|&j| m[i][j] / (m[i][i] * m[j][j]).sqrt()).collect()).collect();
        if regular(&scaled) {
            return;
        }
        let Some((least, vector)) = eigen(&scaled).into_iter().next() else { return };
        if worst.as_ref().is_none_or(|(w, _)| least > *w) {
            worst = Some((least, vector));
        }
    }
    let Some((least, vector)) = worst else { return };
    if least > SINGULAR {
        return;
    }
    let named: Vec<usize> = in_null_space(&vector).into_iter().map(|k| moving[k]).collect();
    let names: Vec<String> = named.iter().map(|&i| format!("`{}`", c.rig.coordinates[i].name)).collect();
    let list = match names.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => names.join(""),
    };
    let mut d = Diagnostic::error(
        "E0304",
        format!("{list} move the same inertia: the mass matrix is singular"),
        c.rig.coordinates[named[0]].span,
        "one of them",
    );
    for &i in &named[1..] {
        d = d.also(c.rig.coordinates[i].span, "and this one");
    }
    diagnostics
        .push(d.help("together they have a motion that moves nothing: put a body between them, or make one a combination of the others"));
}

fn assumed(c: &Context<'_>, entries: &[Expr], span: Span, diagnostics: &mut Vec<Diagnostic>) {
    let free = c.rig.coordinates.iter().filter(|q| !q.prescribed);
    for (e, q) in entries.iter().zip(free) {
        if let Some(x) = c.numbers.value(e)
            && x <= 0.0
        {
            diagnostics.push(
                Diagnostic::error(
                    "E0304",
                    format!("`{}` moves no inertia", q.name),
                    span,
                    format!("the assumed M[{0}, {0}] is {1}", q.name, shown(x)),
                )
                .help("an assumed inertia is positive"),
            );
        }
    }
}

/// Equations written directly determine every acceleration.
fn equations(c: &Context<'_>, free: &[usize], diagnostics: &mut Vec<Diagnostic>) {
    let n = c.rig.coordinates.len();
    let mut nulls: Option<(f64, Vec<f64>)> = None;
    for k in 0..3 {
        let q = sample(c.rig, k);
        let mut m = vec![vec![0.0; n]; n];
        for e in &c.rig.equations {
            for (j, k) in &e.mass {
                m[e.coordinate][*j] += c.numbers.at(k, &q, &[]);
            }
        }
        let mut a: Vec<Vec<f64>> = free.iter().map(|&i| free.iter().map(|&j| m[i][j]).collect()).collect();
        if a.iter().flatten().any(|x| !x.is_finite()) {
            return;
        }
        for row in &mut a {
            let size = row.iter().fold(0.0_f64, |s, x| s.max(x.abs()));
            row.iter_mut().for_each(|x| *x = if size > 0.0 { *x / size } else { 0.0 });
        }
        let square: Vec<Vec<f64>> =
            (0..free.len()).map(|i| (0..free.len()).map(|j| a.iter().map(|row| row[i] * row[j]).sum()).collect()).collect();
        let Some(first) = eigen(&square).into_iter().next() else { return };
        if nulls.as_ref().is_none_or(|(w, _)| first.0 > *w) {
            nulls = Some(first);
        }
    }
    let Some((least, vector)) = nulls else { return };
    if least > SINGULAR {
        return;
    }
    let named = in_null_space(&vector);
    let names: Vec<String> = named.iter().map(|&k| format!("{}.ddot", c.rig.coordinates[free[k]].name)).collect();
    let q = &c.rig.coordinates[free[named[0]]];
    let span = c.rig.equations.iter().find(|e| e.coordinate == free[named[0]]).map_or(q.span, |e| e.span);
    let label = if named.len() == 1 {
        format!("with these parameters, `{}` has the coefficient 0", names[0])
    } else {
        format!("with these parameters, every equation has the same combination of {}", names.join(", "))
    };
    diagnostics.push(
        Diagnostic::error("E0304", format!("the equations do not determine `{}`", names.join("`, `")), span, label)
            .help("the coefficients of the accelerations must make an invertible matrix"),
    );
}

/// Entries that take part in a null vector.
fn in_null_space(vector: &[f64]) -> Vec<usize> {
    let largest = vector.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    (0..vector.len()).filter(|&k| vector[k].abs() > 1e-4 * largest).collect()
}
