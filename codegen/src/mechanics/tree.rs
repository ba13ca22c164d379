//! The kinematic tree as elementary links: each link is one rotation or one translation away from
//! its parent, so that a frame chain costs no full rotation matrices.
//!
//! Notation: link L with parent P; R_PL turns components in L's axes into P's axes.

use super::vector::{V3, add3, cross3, scale3, zero3};
use crate::expr::{Derivative, Graph, Id, SymbolId};
use crate::lower::Lowering;
use model_dsl::rig::{Axis, FrameRef, Rig, Step};

/// How a link is reached from its parent.
pub enum Motion {
    /// Rotation about a unit axis.
    Rotate {
        /// Axis (the same components in parent's and link's axes).
        axis: Axis,
        /// sin and cos of the angle.
        sin: Id,
        /// cos of the angle.
        cos: Id,
        /// Coordinates that turn it: (coordinate, d angle / d coordinate).
        drives: Vec<(usize, Id)>,
    },
    /// Translation by p_PL, components in the parent's axes.
    Translate {
        /// Offset.
        offset: V3,
        /// Coordinates that move it: (coordinate, d offset / d coordinate).
        drives: Vec<(usize, V3)>,
    },
}

/// An elementary link.
pub struct Link {
    /// Parent link; `None` for ground.
    pub parent: Option<usize>,
    /// Motion.
    pub motion: Motion,
    /// Short name for labels: the frame's name, numbered within a chain of several steps.
    pub name: String,
}

/// All links, parents before children, and where each frame ends.
pub struct Tree {
    /// Links.
    pub links: Vec<Link>,
    /// Link of each frame of the rig; `None` is ground (a frame without steps on ground).
    pub frame_link: Vec<Option<usize>>,
    /// Number of coordinates.
    pub coordinates: usize,
}

impl Tree {
    /// Builds the tree of a rig.
    pub fn new(rig: &Rig, lowering: &Lowering, g: &mut Graph) -> Self {
        let mut links: Vec<Link> = Vec::new();
        let mut frame_link: Vec<Option<usize>> = Vec::new();
        for frame in &rig.frames {
            let mut at = match frame.parent {
                FrameRef::Ground => None,
                FrameRef::Frame(i) => frame_link[i],
            };
            g.set_scope(frame.name.clone());
            let steps = frame.steps.len();
            for (k, step) in frame.steps.iter().enumerate() {
                let motion = match step {
                    Step::Rotate { axis, angle } => {
                        let angle = lowering.expr(g, angle);
                        let drives = drives_of(g, angle, &lowering.q);
                        Motion::Rotate { axis: *axis, sin: g.sin(angle), cos: g.cos(angle), drives }
                    }
                    Step::Translate(offset) => {
                        let offset: V3 = std::array::from_fn(|i| lowering.expr(g, &offset[i]));
                        let parts: [Vec<(usize, Id)>; 3] = offset.map(|x| drives_of(g, x, &lowering.q));
                        let zero = g.zero();
                        let drives = (0..lowering.q.len())
                            .map(|c| (c, std::array::from_fn(|i| parts[i].iter().find(|(k, _)| *k == c).map_or(zero, |(_, x)| *x))))
                            .filter(|(_, column): &(usize, V3)| column.iter().any(|&x| !g.is_zero(x)))
                            .collect();
                        Motion::Translate { offset, drives }
                    }
                };
                let name = if k + 1 == steps { frame.name.clone() } else { format!("{}_{}", frame.name, k + 1) };
                links.push(Link { parent: at, motion, name });
                at = Some(links.len() - 1);
            }
            frame_link.push(at);
        }
        Self { links, frame_link, coordinates: rig.coordinates.len() }
    }

    /// The link of a frame reference.
    #[must_use]
    pub fn link_of(&self, frame: FrameRef) -> Option<usize> {
        match frame {
            FrameRef::Ground => None,
            FrameRef::Frame(i) => self.frame_link[i],
        }
    }

    /// Components in the link's axes of a vector given in its parent's axes: R_PL^T a.
    pub fn to_link(&self, g: &mut Graph, link: usize, a: V3) -> V3 {
        match &self.links[link].motion {
            Motion::Rotate { axis, sin, cos, .. } => {
                let back = g.neg(*sin);
                rotate(g, *axis, back, *cos, a)
            }
            Motion::Translate { .. } => a,
        }
    }

    /// Components in the parent's axes of a vector given in the link's axes: R_PL a.
    pub fn to_parent(&self, g: &mut Graph, link: usize, a: V3) -> V3 {
        match &self.links[link].motion {
            Motion::Rotate { axis, sin, cos, .. } => rotate(g, *axis, *sin, *cos, a),
            Motion::Translate { .. } => a,
        }
    }

    /// Path of links from ground down to `link`, ground's end first.
    fn path(&self, link: Option<usize>) -> Vec<usize> {
        let mut path = Vec::new();
        let mut at = link;
        while let Some(i) = at {
            path.push(i);
            at = self.links[i].parent;
        }
        path.reverse();
        path
    }

    /// Splits the ways to two links at their nearest common ancestor: links below it on either side.
    fn split(&self, from: Option<usize>, to: Option<usize>) -> (Vec<usize>, Vec<usize>) {
        let (a, b) = (self.path(from), self.path(to));
        let shared = a.iter().zip(&b).take_while(|(x, y)| x == y).count();
        (a[shared..].to_vec(), b[shared..].to_vec())
    }

    /// A free vector given in `from`'s axes, in `to`'s axes.
    pub fn express(&self, g: &mut Graph, vector: V3, from: Option<usize>, to: Option<usize>) -> V3 {
        let (up, down) = self.split(from, to);
        let mut a = vector;
        for &link in up.iter().rev() {
            a = self.to_parent(g, link, a);
        }
        for &link in &down {
            a = self.to_link(g, link, a);
        }
        a
    }

    /// A point given in `from` (origin and axes), in `to`.
    pub fn express_point(&self, g: &mut Graph, point: V3, from: Option<usize>, to: Option<usize>) -> V3 {
        let (up, down) = self.split(from, to);
        let mut a = point;
        for &link in up.iter().rev() {
            a = self.to_parent(g, link, a);
            if let Motion::Translate { offset, .. } = &self.links[link].motion {
                a = add3(g, a, *offset);
            }
        }
        for &link in &down {
            if let Motion::Translate { offset, .. } = &self.links[link].motion {
                a = super::vector::sub3(g, a, *offset);
            }
            a = self.to_link(g, link, a);
        }
        a
    }

    /// Deepest link that is an ancestor of both (or one of them).
    #[must_use]
    pub fn common(&self, a: Option<usize>, b: Option<usize>) -> Option<usize> {
        let (a, b) = (self.path(a), self.path(b));
        a.iter().zip(&b).take_while(|(x, y)| x == y).last().map(|(x, _)| *x)
    }

    /// Rate of a rotation's angle, or any sum over drives: sum_k drive_k speed_k.
    pub fn drive_rate(g: &mut Graph, drives: &[(usize, Id)], speed: &[Id]) -> Id {
        let terms: Vec<Id> = drives.iter().map(|(k, d)| g.mul(*d, speed[*k])).collect();
        g.sum(&terms)
    }

    /// Rate of a translation's offset.
    pub fn drive_rate3(g: &mut Graph, drives: &[(usize, V3)], speed: &[Id]) -> V3 {
        let mut total = zero3(g);
        for (k, d) in drives {
            let part = scale3(g, speed[*k], *d);
            total = add3(g, total, part);
        }
        total
    }
}

/// d x / d q_k for every coordinate that x (affine in q) depends on.
pub fn drives_of(g: &mut Graph, x: Id, q: &[SymbolId]) -> Vec<(usize, Id)> {
    let slopes = g.gradient(x, q, Derivative::Exact);
    slopes.into_iter().enumerate().filter(|(_, d)| !g.is_zero(*d)).collect()
}

/// Unit vector of an axis.
pub fn axis_vector(g: &mut Graph, axis: Axis) -> V3 {
    match axis {
        Axis::Principal { index, negative } => {
            let mut e = zero3(g);
            e[index] = g.num(if negative { -1.0 } else { 1.0 });
            e
        }
        Axis::Vector(v) => v.map(|x| g.num(x)),
    }
}

/// R(axis, angle) a, right-handed.
pub fn rotate(g: &mut Graph, axis: Axis, sin: Id, cos: Id, a: V3) -> V3 {
    match axis {
        Axis::Principal { index, negative } => {
            let sin = if negative { g.neg(sin) } else { sin };
            let (j, k) = ((index + 1) % 3, (index + 2) % 3);
            let mut b = a;
            let (cj, sk) = (g.mul(cos, a[j]), g.mul(sin, a[k]));
            let (sj, ck) = (g.mul(sin, a[j]), g.mul(cos, a[k]));
            b[j] = g.sub(cj, sk);
            b[k] = g.add(sj, ck);
            b
        }
        Axis::Vector(_) => {
            // Rodrigues: a + sin e x a + (1 - cos) e x (e x a)
            let e = axis_vector(g, axis);
            let ea = cross3(g, e, a);
            let eea = cross3(g, e, ea);
            let one = g.one();
            let versine = g.sub(one, cos);
            let (left, right) = (scale3(g, sin, ea), scale3(g, versine, eea));
            let sum = add3(g, a, left);
            add3(g, sum, right)
        }
    }
}
