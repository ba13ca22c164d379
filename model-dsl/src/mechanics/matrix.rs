//! Small vectors and symmetric matrices: what the checks need, by Jacobi rotations.

/// Three components.
pub type V3 = [f64; 3];
/// Rows.
pub type M3 = [V3; 3];

/// Unit matrix.
pub const UNIT: M3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// a + b
pub fn add(a: V3, b: V3) -> V3 {
    std::array::from_fn(|k| a[k] + b[k])
}

/// k a
pub fn scale(k: f64, a: V3) -> V3 {
    a.map(|x| k * x)
}

/// a . b
pub fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a x b
pub fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// R a
pub fn turn(r: &M3, a: V3) -> V3 {
    r.map(|row| dot(row, a))
}

/// R^T a
pub fn turn_back(r: &M3, a: V3) -> V3 {
    std::array::from_fn(|k| r[0][k] * a[0] + r[1][k] * a[1] + r[2][k] * a[2])
}

/// A B
pub fn times(a: &M3, b: &M3) -> M3 {
    a.map(|row| turn_back(b, row))
}

/// Rotation by an angle about a unit axis (Rodrigues).
pub fn rotation(n: V3, angle: f64) -> M3 {
    let (s, c) = angle.sin_cos();
    let skew = [[0.0, -n[2], n[1]], [n[2], 0.0, -n[0]], [-n[1], n[0], 0.0]];
    std::array::from_fn(|i| std::array::from_fn(|j| c * UNIT[i][j] + s * skew[i][j] + (1.0 - c) * n[i] * n[j]))
}

/// The symmetric tensor of Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
pub fn tensor(i: [f64; 6]) -> M3 {
    [[i[0], i[3], i[4]], [i[3], i[1], i[5]], [i[4], i[5], i[2]]]
}

/// Steiner's term m (c.c 1 - c c^T).
pub fn steiner(m: f64, c: V3) -> M3 {
    std::array::from_fn(|i| std::array::from_fn(|j| m * (dot(c, c) * UNIT[i][j] - c[i] * c[j])))
}

/// Eigenvalues in ascending order, and the eigenvector of each, of a symmetric matrix (cyclic Jacobi).
pub fn eigen(matrix: &[Vec<f64>]) -> Vec<(f64, Vec<f64>)> {
    let n = matrix.len();
    let mut a = matrix.to_vec();
    let mut v: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..64 {
        let off: f64 = (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| a[i][j] * a[i][j]).sum();
        let all: f64 = a.iter().flatten().map(|x| x * x).sum();
        if off <= 1e-36 * all {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                if a[p][q] == 0.0 {
                    continue;
                }
                let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                for row in &mut a {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let (rp, rq) = (a[p].clone(), a[q].clone());
                for k in 0..n {
                    a[p][k] = c * rp[k] - s * rq[k];
                    a[q][k] = s * rp[k] + c * rq[k];
                }
                for row in &mut v {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
            }
        }
    }
    let mut out: Vec<(f64, Vec<f64>)> = (0..n).map(|k| (a[k][k], v.iter().map(|row| row[k]).collect())).collect();
    out.sort_by(|x, y| x.0.total_cmp(&y.0));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvalues_of_a_known_matrix() {
        // eigenvalues 1, 2, 4 by construction
        let found: Vec<f64> = eigen(&[vec![2.0, 0.0, 0.0], vec![0.0, 2.5, 1.5], vec![0.0, 1.5, 2.5]]).into_iter().map(|e| e.0).collect();
        for (x, wanted) in found.iter().zip([1.0, 2.0, 4.0]) {
            assert!((x - wanted).abs() < 1e-14, "{found:?}");
        }
    }

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y() {
        let y = turn(&rotation([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2), [1.0, 0.0, 0.0]);
        assert!((y[1] - 1.0).abs() < 1e-15 && y[0].abs() < 1e-15);
    }
}
