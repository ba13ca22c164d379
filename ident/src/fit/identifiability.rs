//! Which parameters the records can tell.
//!
//! The Gauss-Newton matrix of the parameters, initial states eliminated and parameter priors left out, in relative changes
//! of the parameters: an eigenvector with a standard deviation above 100 % is a direction that the records do not tell.

use crate::spectrum::{of_symmetric, pseudo_inverse};
use nalgebra::{DMatrix, SymmetricEigen};

/// A direction in which parameters can change together unseen.
#[derive(Clone, Debug, PartialEq)]
pub struct TradeOff {
    /// What the records do tell of these parameters: `b1/a2` (only the ratio), `a*b` (only the product); for more than two
    /// their names.
    pub name: String,
    /// Parameters and their relative changes along the direction.
    pub members: Vec<(String, f64)>,
    /// Standard deviation of the relative change along it; infinite where there is no information at all.
    pub relative_sd: f64,
}

/// What the records can tell.
#[derive(Clone, Debug, PartialEq)]
pub struct Identifiable {
    /// Directions of the parameters that are told to better than 100 %.
    pub rank: usize,
    /// Fitted parameters.
    pub of: usize,
    /// Parameters that do not show, were all others known.
    pub dead: Vec<String>,
    /// Directions that are not told.
    pub trade_offs: Vec<TradeOff>,
}

/// `normal` over parameters, then other unknowns (whose priors are in it); `sizes` are the parameters' typical sizes,
/// `inflation` the variance of estimates over normal^-1.
pub(crate) fn identifiable(names: &[String], sizes: &[f64], normal: &DMatrix<f64>, inflation: f64) -> Identifiable {
    let (m, n) = (names.len(), normal.nrows());
    let reduced = eliminate(normal, m, n);
    let scaled = DMatrix::from_fn(m, m, |i, j| reduced[(i, j)] * sizes[i] * sizes[j] / inflation.max(f64::MIN_POSITIVE));
    let strongest = (0..m).fold(0.0_f64, |s, i| s.max(scaled[(i, i)]));
    let is_dead: Vec<bool> = (0..m).map(|i| !(scaled[(i, i)] > 1.0 && scaled[(i, i)] > 1e-24 * strongest)).collect();
    let open: Vec<usize> = (0..m).filter(|&i| !is_dead[i]).collect();
    let mut trade_offs = Vec::new();
    if !open.is_empty() {
        let live = DMatrix::from_fn(open.len(), open.len(), |a, b| scaled[(open[a], open[b])]);
        // columns of very different strength: directions are judged with each column at its own strength as well
        let SymmetricEigen { eigenvalues, eigenvectors } = of_symmetric(live.clone());
        let unit = DMatrix::from_fn(open.len(), open.len(), |a, b| live[(a, b)] / (live[(a, a)] * live[(b, b)]).sqrt());
        let dependent = of_symmetric(unit);
        let mut order: Vec<usize> = (0..open.len()).collect();
        order.sort_by(|&a, &b| eigenvalues[a].total_cmp(&eigenvalues[b]));
        let null = dependent.eigenvalues.iter().filter(|&&e| e < 1e-11 * open.len() as f64).count();
        for (position, &k) in order.iter().enumerate() {
            let exact = position < null;
            if !exact && eigenvalues[k] > 1.0 {
                break;
            }
            let relative_sd = if exact || eigenvalues[k] <= 0.0 { f64::INFINITY } else { 1.0 / eigenvalues[k].sqrt() };
            trade_offs.push(direction(names, &open, eigenvectors.column(k).as_slice(), relative_sd));
        }
    }
    Identifiable {
        rank: open.len() - trade_offs.len(),
        of: m,
        dead: (0..m).filter(|&i| is_dead[i]).map(|i| names[i].clone()).collect(),
        trade_offs,
    }
}

/// The matrix of the first m unknowns when the others follow them.
fn eliminate(normal: &DMatrix<f64>, m: usize, n: usize) -> DMatrix<f64> {
    let own = normal.view((0, 0), (m, m)).into_owned();
    if n == m {
        return own;
    }
    let across = normal.view((0, m), (m, n - m)).into_owned();
    let others = normal.view((m, m), (n - m, n - m)).into_owned();
    own - &across * pseudo_inverse(&others, 1e-13) * across.transpose()
}

fn direction(names: &[String], open: &[usize], v: &[f64], relative_sd: f64) -> TradeOff {
    let largest = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let mut members: Vec<(usize, f64)> = (0..v.len()).filter(|&a| v[a].abs() > 0.2 * largest).map(|a| (open[a], v[a])).collect();
    members.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()).then(a.0.cmp(&b.0)));
    let sign = members.first().map_or(1.0, |m| m.1.signum());
    let name = match members.as_slice() {
        [(i, _)] => names[*i].clone(),
        [(i, a), (j, b)] => {
            let (i, j) = (i.min(j), i.max(j));
            format!("{}{}{}", names[*i], if a * b > 0.0 { "/" } else { "*" }, names[*j])
        }
        more => more.iter().map(|(i, _)| names[*i].as_str()).collect::<Vec<_>>().join(", "),
    };
    TradeOff { name, members: members.into_iter().map(|(i, v)| (names[i].clone(), sign * v)).collect(), relative_sd }
}

#[cfg(test)]
mod tests {
    use super::identifiable;
    use nalgebra::DMatrix;

    fn of(rows: &[[f64; 3]], sizes: [f64; 3]) -> super::Identifiable {
        let j = DMatrix::from_fn(rows.len(), 3, |r, c| rows[r][c]);
        identifiable(&["a".to_owned(), "b".to_owned(), "c".to_owned()], &sizes, &(j.transpose() * j), 1.0)
    }

    #[test]
    fn ratios_products_and_dead_parameters() {
        // a/b: both grow by the same part unseen (a = 2, b = 4: the columns are as -2 to 1)
        let found = of(&[[200.0, -100.0, 0.0], [400.0, -200.0, 1e-3], [0.0, 0.0, 1e-3]], [2.0, 4.0, 1.0]);
        assert_eq!(found.dead, ["c"]);
        assert_eq!((found.rank, found.trade_offs[0].name.as_str()), (1, "a/b"));
        let found = of(&[[200.0, 100.0, 0.0], [400.0, 200.0, 0.0], [0.0, 0.0, 50.0]], [2.0, 4.0, 1.0]);
        assert_eq!((found.rank, found.trade_offs[0].name.as_str()), (2, "a*b"));
        let found = of(&[[200.0, 100.0, 0.0], [400.0, -200.0, 0.0], [0.0, 0.0, 50.0]], [2.0, 4.0, 1.0]);
        assert_eq!((found.rank, found.dead.len(), found.trade_offs.len()), (3, 0, 0));
    }
}
