//! How space is laid onto paper: parallel projections, and which of them tell something of a pose.

use crate::pose::Pose;
use nalgebra::{Point3, Vector3};

/// A parallel projection.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// What it is called.
    pub title: &'static str,
    /// To the right on paper.
    pub right: Vector3<f64>,
    /// Up on paper.
    pub up: Vector3<f64>,
}

impl View {
    /// Place on paper, up positive.
    pub fn flat(&self, p: Point3<f64>) -> (f64, f64) {
        (self.right.dot(&p.coords), self.up.dot(&p.coords))
    }

    /// A direction on paper.
    pub fn direction(&self, v: Vector3<f64>) -> (f64, f64) {
        (self.right.dot(&v), self.up.dot(&v))
    }
}

/// All points that must be on the paper.
pub fn points(pose: &Pose) -> Vec<Point3<f64>> {
    let mut all = vec![Point3::origin()];
    all.extend(pose.links.iter().chain(&pose.springs).flat_map(|(a, b)| [*a, *b]));
    all.extend(pose.joints.iter().map(|j| j.at));
    all.extend(pose.forces.iter().map(|f| f.at));
    for m in &pose.masses {
        all.push(m.at);
        all.extend(m.extents.iter().flat_map(|e| [m.at + e, m.at - e]));
    }
    all
}

/// Views that show a pose: one for what lies in a plane, else a slanted one, then from the front and from above.
pub fn views(pose: &Pose) -> Vec<View> {
    let front = View { title: "from the front: x to the right, z up", right: Vector3::x(), up: Vector3::z() };
    let side = View { title: "from the side: y to the right, z up", right: Vector3::y(), up: Vector3::z() };
    let above = View { title: "from above: x to the right, y up", right: Vector3::x(), up: Vector3::y() };
    let all = points(pose);
    let spread = |k: usize| {
        let (lo, hi) = all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), p| (lo.min(p[k]), hi.max(p[k])));
        hi - lo
    };
    let largest = (0..3).map(spread).fold(0.0, f64::max);
    let flat = |k: usize| spread(k) <= 1e-9 * largest;
    match (flat(0), flat(1), flat(2)) {
        (_, true, _) => vec![front],
        (true, false, _) => vec![side],
        (false, false, true) => vec![above],
        (false, false, false) => {
            let (s, c) = 30_f64.to_radians().sin_cos();
            let (down, level) = 25_f64.to_radians().sin_cos();
            let slanted = View { title: "aslant", right: Vector3::new(c, s, 0.0), up: Vector3::new(-s * down, c * down, level) };
            vec![slanted, front, above]
        }
    }
}
