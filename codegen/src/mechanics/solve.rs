//! L^T D L of the mass matrix, unrolled on the graph.
//!
//! Coordinates are eliminated from the last to the first, so from the tips of a tree towards ground: entries that
//! vanish because two joints are on different branches stay zero (Featherstone, Rigid Body Dynamics Algorithms,
//! 2008, ch. 6.5), and the pivot of a joint is the inertia that it feels while all later joints are free.

use crate::expr::{Graph, Id};

/// Factor of a symmetric matrix: M = L^T D L with unit lower L.
pub struct Factor {
    /// Strictly lower part of L.
    l: Vec<Vec<Id>>,
    /// 1 / D.
    inverse_pivots: Vec<Id>,
    /// D.
    pub pivots: Vec<Id>,
}

/// Factors a symmetric matrix.
pub fn factor(g: &mut Graph, m: &[Vec<Id>], names: &[String]) -> Factor {
    let n = m.len();
    let zero = g.zero();
    let one = g.one();
    let mut l = vec![vec![zero; n]; n];
    // D_k L_kj
    let mut carried = vec![vec![zero; n]; n];
    let (mut pivots, mut inverse_pivots) = (vec![zero; n], vec![zero; n]);
    g.set_scope("solve");
    for j in (0..n).rev() {
        let mut d = m[j][j];
        for k in j + 1..n {
            let part = g.mul(l[k][j], carried[k][j]);
            d = g.sub(d, part);
        }
        g.label(d, format!("pivot_{}", names[j]));
        pivots[j] = d;
        let inverse = g.div(one, d);
        g.label(inverse, format!("inv_{}", names[j]));
        inverse_pivots[j] = inverse;
        for i in 0..j {
            let mut value = m[j][i];
            for k in j + 1..n {
                let part = g.mul(l[k][i], carried[k][j]);
                value = g.sub(value, part);
            }
            carried[j][i] = value;
            l[j][i] = g.mul(value, inverse);
            g.label(l[j][i], format!("l_{}_{}", names[j], names[i]));
        }
    }
    Factor { l, inverse_pivots, pivots }
}

impl Factor {
    /// M^-1 b.
    pub fn solve(&self, g: &mut Graph, b: &[Id]) -> Vec<Id> {
        let n = b.len();
        let mut y = b.to_vec();
        for i in (0..n).rev() {
            for k in i + 1..n {
                let part = g.mul(self.l[k][i], y[k]);
                y[i] = g.sub(y[i], part);
            }
        }
        for (value, &inverse) in y.iter_mut().zip(&self.inverse_pivots) {
            *value = g.mul(*value, inverse);
        }
        for i in 0..n {
            for k in 0..i {
                let part = g.mul(self.l[i][k], y[k]);
                y[i] = g.sub(y[i], part);
            }
        }
        y
    }
}
