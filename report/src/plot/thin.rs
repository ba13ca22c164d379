//! Long series, thinned to what a screen can show: of each pixel column the first, smallest, largest and last value, so that no
//! peak is lost.

/// A point, or a gap.
pub type Point = Option<(f64, f64)>;

/// Thins a series over increasing x to `columns` columns between `from` and `to`. Series that are short, or that go back, stay.
pub fn thin(x: &[f64], y: &[f64], columns: usize, (from, to): (f64, f64)) -> Vec<Point> {
    let n = x.len().min(y.len());
    let point = |k: usize| (x[k].is_finite() && y[k].is_finite()).then(|| (x[k], y[k]));
    let forward = x[..n].windows(2).all(|w| w[1] >= w[0]);
    if n <= 4 * columns || !forward || to.partial_cmp(&from) != Some(std::cmp::Ordering::Greater) {
        return (0..n).map(point).collect();
    }
    let column = |k: usize| ((x[k] - from) / (to - from) * columns as f64).floor();
    let mut out = Vec::with_capacity(4 * columns);
    let mut k = 0;
    while k < n {
        if point(k).is_none() {
            out.push(None);
            while k < n && point(k).is_none() {
                k += 1;
            }
            continue;
        }
        let (first, here) = (k, column(k));
        let (mut least, mut most) = (k, k);
        while k < n && column(k) == here && point(k).is_some() {
            if y[k] < y[least] {
                least = k;
            }
            if y[k] > y[most] {
                most = k;
            }
            k += 1;
        }
        let mut kept = [first, least, most, k - 1];
        kept.sort_unstable();
        let mut before = None;
        for i in kept {
            if before != Some(i) {
                out.push(point(i));
            }
            before = Some(i);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::thin;

    #[test]
    fn peaks_stay() {
        let x: Vec<f64> = (0..20_000).map(f64::from).collect();
        let mut y: Vec<f64> = x.iter().map(|t| (t * 1e-3).sin()).collect();
        (y[7_777], y[7_778], y[12_345]) = (9.0, -9.0, f64::NAN);
        let points = thin(&x, &y, 600, (0.0, 20_000.0));
        assert!(points.len() < 2_500, "{}", points.len());
        assert!(points.contains(&Some((7_777.0, 9.0))) && points.contains(&Some((7_778.0, -9.0))));
        assert_eq!(points.iter().filter(|p| p.is_none()).count(), 1, "a gap stays a gap");
        assert_eq!(points.first(), Some(&Some((0.0, 0.0))));
        assert_eq!(points.last().and_then(|p| *p).map(|p| p.0), Some(19_999.0));
        let inside: Vec<f64> = points.iter().flatten().map(|p| p.0).collect();
        assert!(inside.windows(2).all(|w| w[1] > w[0]), "in order, none twice");
    }

    #[test]
    fn what_goes_back_stays() {
        let x: Vec<f64> = (0..9_000).map(|k| f64::from(k % 100)).collect();
        assert_eq!(thin(&x, &x, 10, (0.0, 100.0)).len(), 9_000);
    }
}
