//! A cascade: an outer proportional-derivative law whose output is the inner loop's reference (eq. 24 of the seed paper).

/// theta* = K_p (psi* - psi) + K_d (psi*' - psi'), limited.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cascade {
    /// K_p [rad/rad].
    pub proportional: f64,
    /// K_d [rad/(rad/s)].
    pub derivative: f64,
    /// Largest modulus of the inner reference [rad]; infinite for no limit.
    pub limit: f64,
}

impl Cascade {
    /// The inner reference for an error of the outer angle [rad] and of its rate [rad/s].
    #[must_use]
    pub fn reference(self, error: f64, rate_error: f64) -> f64 {
        let limit = self.limit.abs();
        (self.proportional * error + self.derivative * rate_error).max(-limit).min(limit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eq_24_and_its_limit() {
        let yaw = Cascade { proportional: 1.8, derivative: 0.2, limit: 0.3 };
        assert!((yaw.reference(0.1, -0.05) - 0.17).abs() < 1e-15);
        assert_eq!(yaw.reference(1.0, 0.0), 0.3);
        assert_eq!(yaw.reference(-1.0, 0.0), -0.3);
    }
}
