//! Elementary functions for `core`-only code: one place that says which library computes them.

pub use libm::{acos, asin, atan, atan2, cos, cosh, exp, fabs as abs, log as ln, pow, sin, sinh, sqrt, tan, tanh};

/// Sine and cosine of an angle [rad], in this order.
#[inline]
#[must_use]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// -1, 0 or 1.
#[inline]
#[must_use]
pub fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}

/// 1 where x > 0, otherwise 0.
#[inline]
#[must_use]
pub fn step(x: f64) -> f64 {
    if x > 0.0 { 1.0 } else { 0.0 }
}
