//! What is drawn of a pose, and where names find room.

use crate::pose::Pose;
use crate::svg::Svg;
use crate::view::{View, points, views};
use nalgebra::{Point3, Vector3};

/// Edge of the large panel [px].
const LARGE: f64 = 400.0;
/// Edge of a small one.
const SMALL: f64 = 200.0;
/// Room around what is drawn.
const MARGIN: f64 = 52.0;
/// Height of the line below.
const FOOT: f64 = 26.0;
/// Length of an axis or force on paper.
const SHAFT: f64 = 26.0;

/// The picture of a pose as an SVG file; `source` is the rig's file.
#[must_use]
pub fn picture(pose: &Pose, title: &str, source: &str) -> String {
    let views = views(pose);
    let width = if views.len() > 1 { LARGE + SMALL } else { LARGE };
    let mut svg = Svg::new(width, LARGE + FOOT);
    for (k, view) in views.iter().enumerate() {
        let (corner, size, margin) = match k {
            0 => ((0.0, 0.0), LARGE, MARGIN),
            _ => ((LARGE, (k - 1) as f64 * SMALL), SMALL, MARGIN / 2.0),
        };
        let mut panel = Panel::new(*view, pose, corner, size, margin, k == 0);
        panel.draw(&mut svg, pose);
    }
    let words = pose.coordinates.join(", ");
    if !words.is_empty() {
        svg.text("small", "start", (10.0, LARGE + FOOT - 10.0), &format!("at {words}"));
    }
    svg.finish(title, source)
}

/// One view on the paper.
struct Panel {
    view: View,
    corner: (f64, f64),
    size: f64,
    scale: f64,
    center: (f64, f64),
    /// Names are written in the large panel only.
    names: bool,
    /// Boxes that are taken: left, top, right, bottom.
    taken: Vec<[f64; 4]>,
}

impl Panel {
    fn new(view: View, pose: &Pose, corner: (f64, f64), size: f64, margin: f64, names: bool) -> Self {
        let flat: Vec<(f64, f64)> = points(pose).into_iter().map(|p| view.flat(p)).collect();
        let range = |of: &dyn Fn(&(f64, f64)) -> f64| {
            flat.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)))
        };
        let ((x0, x1), (y0, y1)) = (range(&|p| p.0), range(&|p| p.1));
        let spread = (x1 - x0).max(y1 - y0);
        let scale = if spread > 0.0 { (size - 2.0 * margin) / spread } else { 1.0 };
        Self { view, corner, size, scale, center: (0.5 * (x0 + x1), 0.5 * (y0 + y1)), names, taken: Vec::new() }
    }

    fn place(&self, p: Point3<f64>) -> (f64, f64) {
        let (x, y) = self.view.flat(p);
        let middle = self.size / 2.0;
        (self.corner.0 + middle + (x - self.center.0) * self.scale, self.corner.1 + middle - (y - self.center.1) * self.scale)
    }

    /// A direction on the paper, at most one long.
    fn direction(&self, v: Vector3<f64>) -> (f64, f64) {
        let (x, y) = self.view.direction(v);
        (x, -y)
    }

    fn draw(&mut self, svg: &mut Svg, pose: &Pose) {
        let k = if self.names { 1.0 } else { 0.6 };
        self.ground(svg, k);
        for (a, b) in &pose.springs {
            svg.line("spring", self.place(*a), self.place(*b));
        }
        for (a, b) in &pose.links {
            self.keep_free(self.place(*a), self.place(*b));
            svg.line("link", self.place(*a), self.place(*b));
        }
        let heaviest = pose.masses.iter().map(|m| m.mass).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
        for m in &pose.masses {
            svg.line("reach", self.place(m.origin), self.place(m.at));
            for e in &m.extents {
                let ends = (self.place(m.at - e), self.place(m.at + e));
                if (ends.0.0 - ends.1.0).hypot(ends.0.1 - ends.1.1) > 6.0 {
                    svg.line("rod", ends.0, ends.1);
                }
            }
        }
        let radius = |mass: f64| k * (3.5 + 6.5 * (mass.max(0.0) / heaviest).cbrt());
        for m in &pose.masses {
            let at = self.place(m.at);
            svg.circle("mass", at, radius(m.mass));
            self.block(at, radius(m.mass));
        }
        let mut labels: Vec<(&str, (f64, f64), &str)> = Vec::new();
        for j in &pose.joints {
            let at = self.place(j.at);
            let d = self.direction(j.axis);
            let long = d.0.hypot(d.1);
            if long < 0.2 {
                svg.circle("ring", at, 5.5 * k);
                svg.circle("axishead", at, 1.8 * k);
                self.block(at, 7.0);
                labels.push(("jointname", at, &j.name));
                continue;
            }
            let reach = (d.0 * SHAFT * k, d.1 * SHAFT * k);
            let (head, tail) = ((at.0 + reach.0, at.1 + reach.1), (at.0 - reach.0, at.1 - reach.1));
            let start = if j.slides { tail } else { at };
            svg.line("axis", start, head);
            svg.head("axishead", head, d, 7.0 * k);
            if j.slides {
                svg.head("axishead", tail, (-d.0, -d.1), 7.0 * k);
            } else {
                svg.circle("ring", at, 3.0 * k);
            }
            self.keep_free(start, head);
            labels.push(("jointname", head, &j.name));
        }
        for f in &pose.forces {
            let at = self.place(f.at);
            let d = self.direction(f.direction);
            if d.0.hypot(d.1) < 0.2 {
                continue;
            }
            let tip = (at.0 + d.0 * SHAFT * k * 1.3, at.1 + d.1 * SHAFT * k * 1.3);
            svg.line("force", at, tip);
            svg.head("forcehead", tip, d, 8.0 * k);
            self.keep_free(at, tip);
            labels.push(("forcename", tip, &f.name));
        }
        if self.names {
            labels.extend(pose.masses.iter().map(|m| ("massname", self.place(m.at), m.name.as_str())));
            for (class, at, name) in labels {
                self.name(svg, class, at, name);
            }
        }
        let foot = (self.corner.0 + 10.0, self.corner.1 + self.size - 8.0);
        svg.text("small", "start", foot, self.view.title);
        if self.view.title == "aslant" {
            self.tripod(svg);
        }
    }

    /// Ground's origin: a short line with hatching where z is up, else a cross.
    fn ground(&mut self, svg: &mut Svg, k: f64) {
        let at = self.place(Point3::origin());
        let half = 12.0 * k;
        svg.line("ground", (at.0 - half, at.1 + 9.0 * k), (at.0 + half, at.1 + 9.0 * k));
        for i in 0..5 {
            let x = at.0 - half + f64::from(i) * half / 2.0;
            svg.line("ground", (x, at.1 + 9.0 * k), (x - 4.0 * k, at.1 + 14.0 * k));
        }
        svg.line("ground", at, (at.0, at.1 + 9.0 * k));
        self.taken.push([at.0 - half - 4.0, at.1 + 8.0, at.0 + half, at.1 + 15.0]);
    }

    fn tripod(&self, svg: &mut Svg) {
        let at = (self.corner.0 + 34.0, self.corner.1 + self.size - 36.0);
        for (name, axis) in [("x", Vector3::x()), ("y", Vector3::y()), ("z", Vector3::z())] {
            let d = self.direction(axis);
            let tip = (at.0 + d.0 * 22.0, at.1 + d.1 * 22.0);
            svg.line("ground", at, tip);
            svg.text("small", "middle", (at.0 + d.0 * 30.0, at.1 + d.1 * 30.0 + 3.0), name);
        }
    }

    /// A disc that names keep away from.
    fn block(&mut self, at: (f64, f64), r: f64) {
        self.taken.push([at.0 - r, at.1 - r, at.0 + r, at.1 + r]);
    }

    /// A line that names keep away from.
    fn keep_free(&mut self, a: (f64, f64), b: (f64, f64)) {
        let steps = ((a.0 - b.0).hypot(a.1 - b.1) / 6.0).ceil().clamp(1.0, 200.0) as usize;
        for i in 0..=steps {
            let s = i as f64 / steps as f64;
            self.block((a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1)), 2.0);
        }
    }

    /// Writes a name near a place, where it covers least.
    fn name(&mut self, svg: &mut Svg, class: &str, at: (f64, f64), name: &str) {
        let width = 6.1 * name.chars().count() as f64;
        let mut best: Option<(f64, [f64; 4])> = None;
        for (ring, distance) in [12.0, 20.0, 30.0, 42.0].into_iter().enumerate() {
            for step in 0..12 {
                let angle = f64::from(step) * std::f64::consts::PI / 6.0;
                let (x, y) = (at.0 + distance * angle.cos(), at.1 - distance * angle.sin());
                // the box touches the place with the side that faces it
                let left = x - width * 0.5 * (1.0 - angle.cos());
                let found = [left, y - 5.5, left + width, y + 5.5];
                let outside = found[0] < self.corner.0 + 2.0
                    || found[2] > self.corner.0 + self.size - 2.0
                    || found[1] < self.corner.1 + 2.0
                    || found[3] > self.corner.1 + self.size - 20.0;
                let covered: f64 = self.taken.iter().map(|t| overlap(t, &found)).sum();
                let cost = covered + 4.0 * ring as f64 + if outside { 1e4 } else { 0.0 };
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, found));
                }
            }
        }
        if let Some((_, found)) = best {
            svg.text(class, "middle", (0.5 * (found[0] + found[2]), found[3] - 1.8), name);
            self.taken.push(found);
        }
    }
}

/// Common area of two boxes.
fn overlap(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    let side = |k: usize| (a[k + 2].min(b[k + 2]) - a[k].max(b[k])).max(0.0);
    side(0) * side(1)
}
