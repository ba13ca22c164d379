//! Three-vectors and symmetric 3x3 tensors on the graph.

use crate::expr::{Graph, Id};

/// Components in some frame's axes.
pub type V3 = [Id; 3];

/// Symmetric tensor: xx, yy, zz, xy, xz, yz.
pub type Sym3 = [Id; 6];

/// Zero vector.
pub fn zero3(g: &mut Graph) -> V3 {
    [g.zero(); 3]
}

/// a + b
pub fn add3(g: &mut Graph, a: V3, b: V3) -> V3 {
    [g.add(a[0], b[0]), g.add(a[1], b[1]), g.add(a[2], b[2])]
}

/// a - b
pub fn sub3(g: &mut Graph, a: V3, b: V3) -> V3 {
    [g.sub(a[0], b[0]), g.sub(a[1], b[1]), g.sub(a[2], b[2])]
}

/// k a
pub fn scale3(g: &mut Graph, k: Id, a: V3) -> V3 {
    [g.mul(k, a[0]), g.mul(k, a[1]), g.mul(k, a[2])]
}

/// -a
pub fn neg3(g: &mut Graph, a: V3) -> V3 {
    [g.neg(a[0]), g.neg(a[1]), g.neg(a[2])]
}

/// a . b
pub fn dot3(g: &mut Graph, a: V3, b: V3) -> Id {
    let terms = [g.mul(a[0], b[0]), g.mul(a[1], b[1]), g.mul(a[2], b[2])];
    g.sum(&terms)
}

/// a x b
pub fn cross3(g: &mut Graph, a: V3, b: V3) -> V3 {
    let component = |g: &mut Graph, i: usize, j: usize| {
        let (left, right) = (g.mul(a[i], b[j]), g.mul(a[j], b[i]));
        g.sub(left, right)
    };
    [component(g, 1, 2), component(g, 2, 0), component(g, 0, 1)]
}

/// I a
pub fn tensor_times(g: &mut Graph, i: &Sym3, a: V3) -> V3 {
    let [xx, yy, zz, xy, xz, yz] = *i;
    [dot3(g, [xx, xy, xz], a), dot3(g, [xy, yy, yz], a), dot3(g, [xz, yz, zz], a)]
}

/// Sum of two tensors.
pub fn add_tensors(g: &mut Graph, a: &Sym3, b: &Sym3) -> Sym3 {
    std::array::from_fn(|k| g.add(a[k], b[k]))
}

/// m (c.c 1 - c c^T): what a point mass m at c adds about the origin.
pub fn point_inertia(g: &mut Graph, m: Id, c: V3) -> Sym3 {
    let mc = scale3(g, m, c);
    let s: V3 = std::array::from_fn(|k| g.mul(mc[k], c[k]));
    let product = |g: &mut Graph, i: usize, j: usize| {
        let p = g.mul(mc[i], c[j]);
        g.neg(p)
    };
    [g.add(s[1], s[2]), g.add(s[0], s[2]), g.add(s[0], s[1]), product(g, 0, 1), product(g, 0, 2), product(g, 1, 2)]
}
