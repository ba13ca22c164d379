//! L D U of the mass matrix, unrolled on the graph; U = L^T unless equations written directly couple accelerations
//! without symmetry.

use crate::expr::{Graph, Id};

/// Factor of a matrix: M = L D U with unit triangles.
pub struct Factor {
    /// Strictly lower part of L.
    l: Vec<Vec<Id>>,
    /// Strictly upper part of U: for a symmetric matrix that of L^T.
    u: Vec<Vec<Id>>,
    /// 1 / D.
    inverse_pivots: Vec<Id>,
    /// D.
    pub pivots: Vec<Id>,
}

/// Factors a matrix; of a `symmetric` one only the lower triangle is read.
pub fn factor(g: &mut Graph, m: &[Vec<Id>], names: &[String], symmetric: bool) -> Factor {
    let n = m.len();
    let zero = g.zero();
    let one = g.one();
    let mut l = vec![vec![zero; n]; n];
    let mut u = vec![vec![zero; n]; n];
    let mut pivots = Vec::with_capacity(n);
    let mut inverse_pivots = Vec::with_capacity(n);
    g.set_scope("solve");
    for j in 0..n {
        let mut d = m[j][j];
        let (mut column, mut row) = (vec![zero; n], vec![zero; n]);
        for k in 0..j {
            // D_k U_kj and L_jk D_k: the same where U = L^T
            column[k] = g.mul(u[k][j], pivots[k]);
            row[k] = g.mul(l[j][k], pivots[k]);
            let part = g.mul(l[j][k], column[k]);
            d = g.sub(d, part);
        }
        g.label(d, format!("pivot_{}", names[j]));
        pivots.push(d);
        let inverse = g.div(one, d);
        g.label(inverse, format!("inv_{}", names[j]));
        inverse_pivots.push(inverse);
        for i in j + 1..n {
            let mut value = m[i][j];
            for k in 0..j {
                let part = g.mul(l[i][k], column[k]);
                value = g.sub(value, part);
            }
            l[i][j] = g.mul(value, inverse);
            g.label(l[i][j], format!("l_{}_{}", names[i], names[j]));
            u[j][i] = l[i][j];
            if !symmetric {
                let mut value = m[j][i];
                for k in 0..j {
                    let part = g.mul(row[k], u[k][i]);
                    value = g.sub(value, part);
                }
                u[j][i] = g.mul(value, inverse);
                g.label(u[j][i], format!("u_{}_{}", names[j], names[i]));
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
        for i in 0..n {
            for k in 0..i {
                let part = g.mul(self.l[i][k], y[k]);
                y[i] = g.sub(y[i], part);
            }
        }
        for (value, &inverse) in y.iter_mut().zip(&self.inverse_pivots) {
            *value = g.mul(*value, inverse);
        }
        for i in (0..n).rev() {
            for k in i + 1..n {
                let part = g.mul(self.u[i][k], y[k]);
                y[i] = g.sub(y[i], part);
            }
        }
        y
    }
}
