//! L D L^T of the mass matrix, unrolled on the graph.

use crate::expr::{Graph, Id};

/// Factor of a symmetric matrix: M = L D L^T with unit lower L.
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
    let mut pivots = Vec::with_capacity(n);
    let mut inverse_pivots = Vec::with_capacity(n);
    g.set_scope("solve");
    for j in 0..n {
        let mut d = m[j][j];
        let mut carried = vec![zero; n];
        for (k, value) in carried.iter_mut().enumerate().take(j) {
            // L_jk D_k
            *value = g.mul(l[j][k], pivots[k]);
            let part = g.mul(l[j][k], *value);
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
                let part = g.mul(l[i][k], carried[k]);
                value = g.sub(value, part);
            }
            l[i][j] = g.mul(value, inverse);
            g.label(l[i][j], format!("l_{}_{}", names[i], names[j]));
        }
    }
    Factor { l, inverse_pivots, pivots }
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
                let part = g.mul(self.l[k][i], y[k]);
                y[i] = g.sub(y[i], part);
            }
        }
        y
    }
}
