//! First road: body by body. Recursive Newton-Euler for forces, composite bodies for the mass matrix
//! (Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 5 and 6), in classical three-vectors:
//! accelerations of link origins in link axes, moments about link origins.

use super::bodies::Inertia;
use super::tree::{Motion, Tree, axis_vector};
use super::vector::{Sym3, V3, add3, cross3, dot3, scale3, tensor_times, zero3};
use crate::expr::{Graph, Id};
use model_dsl::rig::Axis;

/// A force and a moment about the link's origin, in the link's axes.
#[derive(Clone, Copy)]
pub struct Wrench {
    /// Force [N].
    pub f: V3,
    /// Moment [N m].
    pub n: V3,
}

impl Wrench {
    /// No force.
    pub fn zero(g: &mut Graph) -> Self {
        Self { f: zero3(g), n: zero3(g) }
    }

    /// Both together.
    pub fn plus(&self, g: &mut Graph, other: &Self) -> Self {
        Self { f: add3(g, self.f, other.f), n: add3(g, self.n, other.n) }
    }

    /// One without the other.
    pub fn minus(&self, g: &mut Graph, other: &Self) -> Self {
        Self { f: super::vector::sub3(g, self.f, other.f), n: super::vector::sub3(g, self.n, other.n) }
    }
}

/// Angular velocity of each link, in its own axes.
pub fn angular_velocities(tree: &Tree, g: &mut Graph, speed: &[Id]) -> Vec<V3> {
    let mut omega: Vec<V3> = Vec::with_capacity(tree.links.len());
    for (k, link) in tree.links.iter().enumerate() {
        g.set_scope(link.name.clone());
        let parent = link.parent.map_or_else(|| zero3(g), |p| omega[p]);
        let carried = tree.to_link(g, k, parent);
        let own = match &link.motion {
            Motion::Rotate { axis, drives, .. } => {
                let rate = Tree::drive_rate(g, drives, speed);
                let e = axis_vector(g, *axis);
                scale3(g, rate, e)
            }
            Motion::Translate { .. } => zero3(g),
        };
        let total = add3(g, carried, own);
        label3(g, total, "omega", &link.name);
        omega.push(total);
    }
    omega
}

/// Velocities of link origins, each in its link's axes.
pub fn origin_velocities(tree: &Tree, g: &mut Graph, omega: &[V3], speed: &[Id]) -> Vec<V3> {
    let mut v: Vec<V3> = Vec::with_capacity(tree.links.len());
    for (k, link) in tree.links.iter().enumerate() {
        g.set_scope(link.name.clone());
        let parent = link.parent.map_or_else(|| zero3(g), |p| v[p]);
        let total = match &link.motion {
            Motion::Rotate { .. } => tree.to_link(g, k, parent),
            Motion::Translate { offset, drives } => {
                let w = link.parent.map_or_else(|| zero3(g), |p| omega[p]);
                let swing = cross3(g, w, *offset);
                let slide = Tree::drive_rate3(g, drives, speed);
                let moved = add3(g, parent, swing);
                add3(g, moved, slide)
            }
        };
        v.push(total);
    }
    v
}

/// Wrenches that move the links with given rates and accelerations against gravity: inverse dynamics,
/// before projection onto the joints.
///
/// `gravity` is the acceleration of free fall in ground; ground is given the opposite acceleration.
pub fn inertial_wrenches(
    tree: &Tree,
    g: &mut Graph,
    inertia: &[Inertia],
    omega: &[V3],
    speed: &[Id],
    acceleration: &[Id],
    gravity: V3,
) -> Vec<Wrench> {
    let mut alpha: Vec<V3> = Vec::with_capacity(tree.links.len());
    let mut a: Vec<V3> = Vec::with_capacity(tree.links.len());
    let mut wrenches = Vec::with_capacity(tree.links.len());
    let up = super::vector::neg3(g, gravity);
    for (k, link) in tree.links.iter().enumerate() {
        g.set_scope(link.name.clone());
        let (alpha_p, a_p, omega_p) = match link.parent {
            Some(p) => (alpha[p], a[p], omega[p]),
            None => (zero3(g), up, zero3(g)),
        };
        let (alpha_k, a_k) = match &link.motion {
            Motion::Rotate { axis, drives, .. } => {
                let rate = Tree::drive_rate(g, drives, speed);
                let e = axis_vector(g, *axis);
                let spin = scale3(g, rate, e);
                // R^T omega_P x e rate, with omega_K = R^T omega_P + e rate
                let bend = cross3(g, omega[k], spin);
                let push = Tree::drive_rate(g, drives, acceleration);
                let own = scale3(g, push, e);
                let carried = tree.to_link(g, k, alpha_p);
                let sum = add3(g, carried, bend);
                (add3(g, sum, own), tree.to_link(g, k, a_p))
            }
            Motion::Translate { offset, drives } => {
                let swing = Swing::new(omega_p, alpha_p).times(g, *offset);
                let mut total = add3(g, a_p, swing);
                if !drives.is_empty() {
                    let slide = Tree::drive_rate3(g, drives, speed);
                    let coriolis = cross3(g, omega_p, slide);
                    let two = g.num(2.0);
                    let twice = scale3(g, two, coriolis);
                    let push = Tree::drive_rate3(g, drives, acceleration);
                    total = add3(g, total, twice);
                    total = add3(g, total, push);
                }
                (alpha_p, total)
            }
        };
        label3(g, alpha_k, "alpha", &link.name);
        label3(g, a_k, "a", &link.name);
        let body = &inertia[k];
        let wrench = if body.is_none(g) {
            Wrench::zero(g)
        } else {
            let moved = scale3(g, body.m, a_k);
            let swung = Swing::new(omega[k], alpha_k).times(g, body.mc);
            let f = add3(g, moved, swung);
            let spin_up = tensor_times(g, &body.i, alpha_k);
            let gyro = gyroscopic(g, &body.i, omega[k]);
            let lever = cross3(g, body.mc, a_k);
            let n = add3(g, spin_up, gyro);
            let n = add3(g, n, lever);
            Wrench { f, n }
        };
        alpha.push(alpha_k);
        a.push(a_k);
        wrenches.push(wrench);
    }
    wrenches
}

/// omega x I omega. Over the axes of a tensor without products (or with one) by Euler's products omega_j omega_k, which
/// the accelerations of points use too.
fn gyroscopic(g: &mut Graph, i: &Sym3, omega: V3) -> V3 {
    let products = i[3..].iter().filter(|&&x| !g.is_zero(x)).count();
    if products > 1 {
        let momentum = tensor_times(g, i, omega);
        return cross3(g, omega, momentum);
    }
    // entries of I that couple the axes of component k: (b, c) are the next axes, a = k
    let off = |j: usize, l: usize| i[2 + j + l];
    std::array::from_fn(|a| {
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        let bc = g.mul(omega[b], omega[c]);
        let difference = g.sub(i[c], i[b]);
        let mut total = g.mul(difference, bc);
        let (bb, cc) = (g.square(omega[b]), g.square(omega[c]));
        let squares = g.sub(bb, cc);
        let (ab, ac) = (g.mul(omega[a], omega[b]), g.mul(omega[a], omega[c]));
        for (entry, rates, negative) in [(off(b, c), squares, false), (off(a, c), ab, false), (off(a, b), ac, true)] {
            let part = g.mul(entry, rates);
            total = if negative { g.sub(total, part) } else { g.add(total, part) };
        }
        total
    })
}

/// alpha x d + omega x (omega x d), with the matrix entries shared between all d of a link.
struct Swing {
    omega: V3,
    alpha: V3,
}

impl Swing {
    fn new(omega: V3, alpha: V3) -> Self {
        Self { omega, alpha }
    }

    fn times(&self, g: &mut Graph, d: V3) -> V3 {
        let mut out = zero3(g);
        for (i, component) in out.iter_mut().enumerate() {
            for (j, &dj) in d.iter().enumerate() {
                if g.is_zero(dj) {
                    continue;
                }
                let entry = self.entry(g, i, j);
                let part = g.mul(entry, dj);
                *component = g.add(*component, part);
            }
        }
        out
    }

    /// Entry of [alpha]x + [omega]x [omega]x.
    fn entry(&self, g: &mut Graph, i: usize, j: usize) -> Id {
        let w = self.omega;
        if i == j {
            let (k, l) = ((i + 1) % 3, (i + 2) % 3);
            let (wk, wl) = (g.square(w[k]), g.square(w[l]));
            let sum = g.add(wk, wl);
            return g.neg(sum);
        }
        let k = 3 - i - j;
        // [alpha]x at (0,1) is -alpha_z, at (1,0) +alpha_z, and cyclically
        let spin = if (i + 1) % 3 == j { g.neg(self.alpha[k]) } else { self.alpha[k] };
        let (lo, hi) = (i.min(j), i.max(j));
        let product = g.mul(w[lo], w[hi]);
        g.add(product, spin)
    }
}

/// Generalized forces of wrenches on the links: projection onto the joints on the way to ground. Forces
/// and moments on the links are labelled `f_` and `n_`, then `whose`.
pub fn project(tree: &Tree, g: &mut Graph, wrenches: &[Wrench], whose: &str) -> Vec<Id> {
    let mut total = wrenches.to_vec();
    let mut tau = vec![g.zero(); tree.coordinates];
    for (k, link) in tree.links.iter().enumerate().rev() {
        g.set_scope(link.name.clone());
        let Wrench { f, n } = total[k];
        label3(g, f, &format!("f{whose}"), &link.name);
        label3(g, n, &format!("n{whose}"), &link.name);
        let to_parent = match &link.motion {
            Motion::Rotate { axis, drives, .. } => {
                let along = project_axis(g, *axis, n);
                for &(c, drive) in drives {
                    let part = g.mul(drive, along);
                    tau[c] = g.add(tau[c], part);
                }
                link.parent.map(|_| Wrench { f: tree.to_parent(g, k, f), n: tree.to_parent(g, k, n) })
            }
            Motion::Translate { offset, drives } => {
                for &(c, drive) in drives {
                    let part = dot3(g, drive, f);
                    tau[c] = g.add(tau[c], part);
                }
                link.parent.map(|_| {
                    let lever = cross3(g, *offset, f);
                    Wrench { f, n: add3(g, n, lever) }
                })
            }
        };
        if let (Some(parent), Some(wrench)) = (link.parent, to_parent) {
            g.set_scope(tree.links[parent].name.clone());
            total[parent] = total[parent].plus(g, &wrench);
        }
    }
    tau
}

fn project_axis(g: &mut Graph, axis: Axis, n: V3) -> Id {
    let e = axis_vector(g, axis);
    dot3(g, e, n)
}

/// Mass matrix by composite bodies.
pub fn mass_matrix(tree: &Tree, g: &mut Graph, inertia: &[Inertia]) -> Vec<Vec<Id>> {
    let n = tree.coordinates;
    let zero = g.zero();
    let mut m = vec![vec![zero; n]; n];
    let mut composite = inertia.to_vec();
    for (k, link) in tree.links.iter().enumerate().rev() {
        g.set_scope(link.name.clone());
        // each way in which this link's joint moves: wrench for a unit acceleration of that way
        match &link.motion {
            Motion::Rotate { axis, drives, .. } if !drives.is_empty() => {
                let e = axis_vector(g, *axis);
                let c = composite[k];
                let wrench = Wrench { f: cross3(g, e, c.mc), n: tensor_times(g, &c.i, e) };
                let column = column_below(tree, g, k, wrench);
                for &(i, di) in drives {
                    spread(g, &mut m, i, di, &column);
                }
            }
            Motion::Translate { drives, .. } => {
                for &(i, direction) in drives {
                    let c = composite[k];
                    let wrench = Wrench { f: scale3(g, c.m, direction), n: cross3(g, c.mc, direction) };
                    let column = column_below(tree, g, k, wrench);
                    let one = g.one();
                    spread(g, &mut m, i, one, &column);
                }
            }
            Motion::Rotate { .. } => {}
        }
        if let Some(parent) = link.parent {
            let moved = to_parent(tree, g, k, &composite[k]);
            g.set_scope(tree.links[parent].name.clone());
            composite[parent] = composite[parent].plus(g, &moved);
        }
    }
    m
}

/// Contributions of one joint way to row i: `column` has, for each joint link from this one to ground,
/// the generalized force of each coordinate there. The link itself is counted once, its ancestors twice
/// (the entry and its mirror).
fn spread(g: &mut Graph, m: &mut [Vec<Id>], i: usize, di: Id, column: &[(bool, usize, Id)]) {
    for &(own, j, value) in column {
        let part = g.mul(di, value);
        m[i][j] = g.add(m[i][j], part);
        if !own {
            m[j][i] = g.add(m[j][i], part);
        }
    }
}

/// Generalized forces of a wrench at a link, at that link and at all its ancestors:
/// (at the link itself, coordinate, value).
fn column_below(tree: &Tree, g: &mut Graph, link: usize, wrench: Wrench) -> Vec<(bool, usize, Id)> {
    let mut column = Vec::new();
    let mut at = Some((link, wrench));
    while let Some((k, Wrench { f, n })) = at {
        let next = match &tree.links[k].motion {
            Motion::Rotate { axis, drives, .. } => {
                let along = project_axis(g, *axis, n);
                for &(c, drive) in drives {
                    let value = g.mul(drive, along);
                    column.push((k == link, c, value));
                }
                Wrench { f: tree.to_parent(g, k, f), n: tree.to_parent(g, k, n) }
            }
            Motion::Translate { offset, drives } => {
                for &(c, drive) in drives {
                    let value = dot3(g, drive, f);
                    column.push((k == link, c, value));
                }
                let lever = cross3(g, *offset, f);
                Wrench { f, n: add3(g, n, lever) }
            }
        };
        at = tree.links[k].parent.map(|p| (p, next));
    }
    column
}

/// A composite inertia, about the parent's origin in the parent's axes.
fn to_parent(tree: &Tree, g: &mut Graph, k: usize, body: &Inertia) -> Inertia {
    match &tree.links[k].motion {
        Motion::Rotate { axis, sin, cos, .. } => {
            Inertia { m: body.m, mc: tree.to_parent(g, k, body.mc), i: rotate_tensor(g, *axis, *sin, *cos, &body.i) }
        }
        Motion::Translate { offset, .. } => {
            // I' = I + (d.s 1 - (d mc^T + mc' d^T)) with mc' = mc + m d, s = mc + mc'
            let d = *offset;
            let carried = scale3(g, body.m, d);
            let mc = add3(g, body.mc, carried);
            let both = add3(g, body.mc, mc);
            let mut i = body.i;
            let along: V3 = std::array::from_fn(|k| g.mul(d[k], both[k]));
            for (entry, (j, l)) in [(0, (1, 2)), (1, (0, 2)), (2, (0, 1))] {
                let sum = g.add(along[j], along[l]);
                i[entry] = g.add(i[entry], sum);
            }
            for (entry, (j, l)) in [(3, (0, 1)), (4, (0, 2)), (5, (1, 2))] {
                let (left, right) = (g.mul(d[j], body.mc[l]), g.mul(d[l], mc[j]));
                let sum = g.add(left, right);
                i[entry] = g.sub(i[entry], sum);
            }
            Inertia { m: body.m, mc, i }
        }
    }
}

/// R I R^T for a rotation about one axis.
fn rotate_tensor(g: &mut Graph, axis: Axis, sin: Id, cos: Id, i: &[Id; 6]) -> [Id; 6] {
    match axis {
        Axis::Principal { index, negative } => {
            let sin = if negative { g.neg(sin) } else { sin };
            // (a, b, c) = (axis, next, next but one); entries by their pair of axes
            let (a, b, c) = (index, (index + 1) % 3, (index + 2) % 3);
            let at = |j: usize, k: usize| match (j.min(k), j.max(k)) {
                (0, 0) => 0,
                (1, 1) => 1,
                (2, 2) => 2,
                (0, 1) => 3,
                (0, 2) => 4,
                _ => 5,
            };
            let (bb, cc, bc, ab, ac) = (i[at(b, b)], i[at(c, c)], i[at(b, c)], i[at(a, b)], i[at(a, c)]);
            let mut out = *i;
            // bb' = cos^2 bb - 2 sin cos bc + sin^2 cc = cc + cos t, bc' = bc + sin t, with t = cos (bb - cc) - 2 sin bc
            let difference = g.sub(bb, cc);
            let two = g.num(2.0);
            let twice = g.mul(two, bc);
            let (left, right) = (g.mul(cos, difference), g.mul(sin, twice));
            let t = g.sub(left, right);
            let (turned, mixed) = (g.mul(cos, t), g.mul(sin, t));
            out[at(b, b)] = g.add(cc, turned);
            out[at(c, c)] = g.sub(bb, turned);
            out[at(b, c)] = g.add(bc, mixed);
            let (left, right) = (g.mul(cos, ab), g.mul(sin, ac));
            out[at(a, b)] = g.sub(left, right);
            let (left, right) = (g.mul(sin, ab), g.mul(cos, ac));
            out[at(a, c)] = g.add(left, right);
            out
        }
        Axis::Vector(_) => {
            let columns: [V3; 3] = [[i[0], i[3], i[4]], [i[3], i[1], i[5]], [i[4], i[5], i[2]]];
            let half = columns.map(|column| super::tree::rotate(g, axis, sin, cos, column));
            // half[j] = R I e_j; rows of R I, rotated again, give R I R^T
            let rows: [V3; 3] = std::array::from_fn(|r| [half[0][r], half[1][r], half[2][r]]);
            let full = rows.map(|row| super::tree::rotate(g, axis, sin, cos, row));
            [full[0][0], full[1][1], full[2][2], full[0][1], full[0][2], full[1][2]]
        }
    }
}

fn label3(g: &mut Graph, vector: V3, what: &str, link: &str) {
    for (k, axis) in ["x", "y", "z"].iter().enumerate() {
        g.label(vector[k], format!("{what}_{link}_{axis}"));
    }
}
