//! U D L of the mass matrix, unrolled on the graph; U = L^T unless equations written directly couple accelerations
//! without symmetry.
//!
//! Coordinates are eliminated from the last to the first, so from the tips of a tree towards ground: entries that
//! vanish because two joints are on different branches stay zero (Featherstone, Rigid Body Dynamics Algorithms,
//! 2008, ch. 6.5), and the pivot of a joint is the inertia that it feels while all later joints are free.

use crate::expr::{Graph, Id};

/// Factor of a matrix: M = U D L with unit triangles.
pub struct Factor {
    /// Strictly lower part of L.
    l: Vec<Vec<Id>>,
    /// Strictly upper part of U.
    u: Vec<Vec<Id>>,
    /// 1 / D.
    inverse_pivots: Vec<Id>,
    /// D.
    pub pivots: Vec<Id>,
}

/// Factors a matrix, symmetric or not.
pub fn factor(g: &mut Graph, m: &[Vec<Id>], names: &[String]) -> Factor {
    let n = m.len();
    let symmetric = (0..n).all(|i| (0..i).all(|j| m[i][j] == m[j][i]));
    let zero = g.zero();
    let one = g.one();
    let mut l = vec![vec![zero; n]; n];
    let mut u = vec![vec![zero; n]; n];
    // D_k L_kj
    let mut carried = vec![vec![zero; n]; n];
    let (mut pivots, mut inverse_pivots) = (vec![zero; n], vec![zero; n]);
    g.set_scope("solve");
    for j in (0..n).rev() {
        let reduced = |g: &mut Graph, row: usize, column: usize, u: &[Vec<Id>], carried: &[Vec<Id>]| {
            let mut value = m[row][column];
            for k in j + 1..n {
                let part = g.mul(u[row][k], carried[k][column]);
                value = g.sub(value, part);
            }
            value
        };
        let d = reduced(g, j, j, &u, &carried);
        g.label(d, format!("pivot_{}", names[j]));
        pivots[j] = d;
        let inverse = g.div(one, d);
        g.label(inverse, format!("inv_{}", names[j]));
        inverse_pivots[j] = inverse;
        for i in 0..j {
            carried[j][i] = reduced(g, j, i, &u, &carried);
            l[j][i] = g.mul(carried[j][i], inverse);
            g.label(l[j][i], format!("l_{}_{}", names[j], names[i]));
            u[i][j] = l[j][i];
            if !symmetric {
                let value = reduced(g, i, j, &u, &carried);
                u[i][j] = g.mul(value, inverse);
                g.label(u[i][j], format!("u_{}_{}", names[i], names[j]));
            }
        }
    }
    Factor { l, u, inverse_pivots, pivots }
}

impl Factor {
    /// M^-1 b.
    pub fn solve(&self, g: &mut Graph, b: &[Id]) -> Vec<Id> {
        let n = b.len();
        let mut y = b.to_vec();
        for i in (0..n).rev() {
            for k in i + 1..n {
                let part = g.mul(self.u[i][k], y[k]);
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
