//! Inertias of the rig's bodies, gathered per link: (m, m c, I about the link's origin).

use super::tree::Tree;
use super::vector::{Sym3, V3, add_tensors, add3, dot3, point_inertia, scale3, zero3};
use crate::expr::{Graph, Id};
use crate::lower::Lowering;
use model_dsl::rig::{Body, InertiaPoint, Rig};

/// Inertia of everything fixed to one link, about the link's origin, in its axes.
#[derive(Clone, Copy)]
pub struct Inertia {
    /// Mass [kg].
    pub m: Id,
    /// First moment m c [kg m].
    pub mc: V3,
    /// Tensor about the origin [kg m^2].
    pub i: Sym3,
}

impl Inertia {
    /// Nothing.
    pub fn none(g: &mut Graph) -> Self {
        Self { m: g.zero(), mc: zero3(g), i: [g.zero(); 6] }
    }

    /// Both together.
    pub fn plus(&self, g: &mut Graph, other: &Self) -> Self {
        Self { m: g.add(self.m, other.m), mc: add3(g, self.mc, other.mc), i: add_tensors(g, &self.i, &other.i) }
    }

    /// Nothing is known to be there: all entries are the number zero.
    pub fn is_none(&self, g: &Graph) -> bool {
        g.is_zero(self.m) && self.mc.iter().chain(&self.i).all(|&x| g.is_zero(x))
    }
}

/// Mass, centre and central tensor of one body, in its frame.
pub struct Central {
    /// Mass.
    pub m: Id,
    /// p_FC: centre of mass in the frame.
    pub c: V3,
    /// Tensor about the centre of mass.
    pub i: Sym3,
}

/// One body as declared, about its centre of mass.
pub fn central(body: &Body, lowering: &Lowering, g: &mut Graph) -> Central {
    let m = lowering.expr(g, &body.mass);
    let c: V3 = std::array::from_fn(|k| lowering.expr(g, &body.center[k]));
    let stated: Sym3 = std::array::from_fn(|k| lowering.expr(g, &body.inertia[k]));
    let i = match body.about {
        InertiaPoint::CenterOfMass => stated,
        InertiaPoint::FrameOrigin => {
            let shift = point_inertia(g, m, c);
            std::array::from_fn(|k| g.sub(stated[k], shift[k]))
        }
    };
    Central { m, c, i }
}

/// One body as declared, about its frame's origin.
pub fn about_origin(body: &Body, lowering: &Lowering, g: &mut Graph) -> Inertia {
    let m = lowering.expr(g, &body.mass);
    let c: V3 = std::array::from_fn(|k| lowering.expr(g, &body.center[k]));
    let stated: Sym3 = std::array::from_fn(|k| lowering.expr(g, &body.inertia[k]));
    let i = match body.about {
        InertiaPoint::CenterOfMass => {
            let shift = point_inertia(g, m, c);
            add_tensors(g, &stated, &shift)
        }
        InertiaPoint::FrameOrigin => stated,
    };
    Inertia { m, mc: scale3(g, m, c), i }
}

/// What each link carries. Bodies on ground move nothing and are left out.
pub fn per_link(rig: &Rig, tree: &Tree, lowering: &Lowering, g: &mut Graph, takes: impl Fn(usize) -> bool) -> Vec<Inertia> {
    let none = Inertia::none(g);
    let mut carried = vec![none; tree.links.len()];
    for (k, body) in rig.bodies.iter().enumerate() {
        if let Some(link) = tree.link_of(body.frame)
            && takes(k)
        {
            g.set_scope(body.name.clone());
            let inertia = about_origin(body, lowering, g);
            g.set_scope(tree.links[link].name.clone());
            carried[link] = carried[link].plus(g, &inertia);
        }
    }
    for (link, inertia) in carried.iter().enumerate() {
        let name = &tree.links[link].name;
        g.label(inertia.m, format!("m_{name}"));
        for (k, axis) in ["x", "y", "z"].iter().enumerate() {
            g.label(inertia.mc[k], format!("mc_{name}_{axis}"));
        }
        for (k, axes) in ["xx", "yy", "zz", "xy", "xz", "yz"].iter().enumerate() {
            g.label(inertia.i[k], format!("I_{name}_{axes}"));
        }
    }
    carried
}

/// Kinetic energy 1/2 m v_C^2 + 1/2 omega . I_C omega of one body.
pub fn kinetic(g: &mut Graph, body: &Central, omega: V3, v_origin: V3) -> Id {
    let swing = super::vector::cross3(g, omega, body.c);
    let v = add3(g, v_origin, swing);
    let vv = dot3(g, v, v);
    let linear = g.mul(body.m, vv);
    let l = super::vector::tensor_times(g, &body.i, omega);
    let angular = dot3(g, omega, l);
    let twice = g.add(linear, angular);
    let half = g.num(0.5);
    g.mul(half, twice)
}
