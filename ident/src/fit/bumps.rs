//! Bumps of compact support along a record, onto which the weak form shifts the derivatives.

/// One bump.
pub(crate) struct Bump {
    /// First sample under it.
    pub first: usize,
    /// phi dt and phi'' dt by the trapezoidal rule, over the norm of phi.
    pub weights: Vec<f64>,
    pub second: Vec<f64>,
}

/// Bumps (s (1 - s))^4 along the record, overlapping by three quarters. (A cube would leave the trapezoidal rule an error of
/// order dt^2, since its second derivative has a kink at the ends.)
pub(crate) fn bumps(t: &[f64], window: usize) -> Vec<Bump> {
    let hop = (window / 4).max(1);
    (0..=t.len() - window)
        .step_by(hop)
        .map(|first| {
            let inside = &t[first..first + window];
            let length = inside[window - 1] - inside[0];
            let mut weights = Vec::with_capacity(window);
            let mut second = Vec::with_capacity(window);
            for k in 0..window {
                let s = (inside[k] - inside[0]) / length;
                let dt = 0.5 * (inside[(k + 1).min(window - 1)] - inside[k.saturating_sub(1)]) / length;
                let r = s * (1.0 - s);
                weights.push(256.0 * r.powi(4) * dt);
                // d2/ds2 of (s - s^2)^4
                second.push(256.0 * (12.0 * (r * (1.0 - 2.0 * s)).powi(2) - 8.0 * r.powi(3)) * dt / (length * length));
            }
            Bump { first, weights, second }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::bumps;

    #[test]
    fn bumps_shift_two_derivatives() {
        let t: Vec<f64> = (0..200).map(|k| 0.01 * f64::from(k)).collect();
        for b in bumps(&t, 60) {
            let inside = &t[b.first..b.first + 60];
            let apply = |w: &[f64], f: &dyn Fn(f64) -> f64| w.iter().zip(inside).map(|(w, t)| w * f(*t)).sum::<f64>();
            let (left, right) = (apply(&b.second, &|t: f64| (3.0 * t).sin()), apply(&b.weights, &|t: f64| -9.0 * (3.0 * t).sin()));
            // trapezoidal rule on a bump that is smooth at its ends
            assert!((left - right).abs() < 2e-4, "{left} {right}");
        }
    }
}
