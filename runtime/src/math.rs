//! Elementary functions for `core`-only code: one place that says which library computes them.

#[cfg(not(feature = "std"))]
pub use libm::{acos, asin, atan, atan2, cos, cosh, exp, fabs as abs, log as ln, pow, sin, sinh, sqrt, tan, tanh};

#[cfg(feature = "std")]
pub use standard::{abs, acos, asin, atan, atan2, cos, cosh, exp, ln, pow, sin, sinh, sqrt, tan, tanh};

/// The standard library's methods as functions.
#[cfg(feature = "std")]
mod standard {
    macro_rules! functions {
        ($($name:ident $method:ident $doc:literal)*) => {
            $(
                #[doc = $doc]
                #[inline]
                #[must_use]
                pub fn $name(x: f64) -> f64 {
                    x.$method()
                }
            )*
        };
    }
    functions! {
        sin sin "Sine."
        cos cos "Cosine."
        tan tan "Tangent."
        asin asin "Inverse sine."
        acos acos "Inverse cosine."
        atan atan "Inverse tangent."
        sinh sinh "Hyperbolic sine."
        cosh cosh "Hyperbolic cosine."
        tanh tanh "Hyperbolic tangent."
        exp exp "Exponential."
        ln ln "Natural logarithm."
        sqrt sqrt "Square root."
        abs abs "Absolute value."
    }

    /// Angle of the point (x, y).
    #[inline]
    #[must_use]
    pub fn atan2(y: f64, x: f64) -> f64 {
        y.atan2(x)
    }

    /// a^b
    #[inline]
    #[must_use]
    pub fn pow(a: f64, b: f64) -> f64 {
        a.powf(b)
    }
}

/// Sine and cosine of an angle [rad], in this order.
#[inline]
#[must_use]
pub fn sin_cos(x: f64) -> (f64, f64) {
    #[cfg(feature = "std")]
    return x.sin_cos();
    #[cfg(not(feature = "std"))]
    return libm::sincos(x);
}

/// The smaller of two; of a number and not-a-number, the number.
#[inline]
#[must_use]
pub fn min(a: f64, b: f64) -> f64 {
    a.min(b)
}

/// The larger of two; of a number and not-a-number, the number.
#[inline]
#[must_use]
pub fn max(a: f64, b: f64) -> f64 {
    a.max(b)
}

/// a^n by repeated squaring.
#[inline]
#[must_use]
pub fn powi(a: f64, n: i32) -> f64 {
    let mut left = n.unsigned_abs();
    let (mut square, mut result) = (a, 1.0);
    while left > 0 {
        if left % 2 == 1 {
            result *= square;
        }
        square *= square;
        left /= 2;
    }
    if n < 0 { 1.0 / result } else { result }
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
