//! Numbers of the display forms: exact ratios where a number is one, the float itself where not.
//!
//! Knows how a person would write a number. Knows nothing of expressions.

use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

/// Largest numerator or denominator of a ratio: floats hold these exactly.
const LIMIT: i128 = 1 << 53;
/// Rounding that one operation on floats leaves.
const ROUNDING: f64 = 4e-16;

/// A coefficient.
#[derive(Clone, Copy, Debug)]
pub enum Number {
    /// p / q in lowest terms, q > 0.
    Ratio(i64, i64),
    /// A number that is no short ratio and no short decimal.
    Float(f64),
}

impl Number {
    /// 0
    pub const ZERO: Self = Self::Ratio(0, 1);
    /// 1
    pub const ONE: Self = Self::Ratio(1, 1);

    /// The integer n.
    pub const fn integer(n: i64) -> Self {
        Self::Ratio(n, 1)
    }

    /// Reads a float: 0.5, 0.3333333333333333 and 0.0319 are ratios, sqrt(2)/2 is not.
    pub fn of(x: f64) -> Self {
        if !x.is_finite() {
            return Self::Float(x);
        }
        if let Some(ratio) = small_ratio(x, 64) {
            return ratio;
        }
        decimal(x).unwrap_or(Self::Float(x))
    }

    /// The number as a small ratio of pi, if it is one.
    pub fn over_pi(x: f64) -> Option<Self> {
        if matches!(Self::of(x), Self::Ratio(..)) {
            return None;
        }
        small_ratio(x / std::f64::consts::PI, 36)
    }

    /// Its value.
    pub fn value(self) -> f64 {
        match self {
            Self::Ratio(p, q) => p as f64 / q as f64,
            Self::Float(x) => x,
        }
    }

    /// Nothing.
    pub fn is_zero(self) -> bool {
        match self {
            Self::Ratio(p, _) => p == 0,
            Self::Float(x) => x == 0.0,
        }
    }

    /// Below zero.
    pub fn is_negative(self) -> bool {
        self.value() < 0.0
    }

    /// 1
    pub fn is_one(self) -> bool {
        self == Self::ONE
    }

    /// Without its sign.
    pub fn abs(self) -> Self {
        if self.is_negative() { self.neg() } else { self }
    }

    /// -x
    pub fn neg(self) -> Self {
        match self {
            Self::Ratio(p, q) => Self::Ratio(-p, q),
            Self::Float(x) => Self::Float(-x),
        }
    }

    /// x + y; what cancels to rounding is zero.
    pub fn add(self, other: Self) -> Self {
        if let (Self::Ratio(a, b), Self::Ratio(c, d)) = (self, other)
            && let Some(sum) = ratio(i128::from(a) * i128::from(d) + i128::from(c) * i128::from(b), i128::from(b) * i128::from(d))
        {
            return sum;
        }
        let (x, y) = (self.value(), other.value());
        let sum = x + y;
        if sum.abs() <= 8.0 * ROUNDING * x.abs().max(y.abs()) { Self::ZERO } else { Self::of(sum) }
    }

    /// x y
    pub fn mul(self, other: Self) -> Self {
        if let (Self::Ratio(a, b), Self::Ratio(c, d)) = (self, other)
            && let Some(product) = ratio(i128::from(a) * i128::from(c), i128::from(b) * i128::from(d))
        {
            return product;
        }
        Self::of(self.value() * other.value())
    }

    /// 1 / x for x that is not zero.
    pub fn inverse(self) -> Self {
        match self {
            Self::Ratio(p, q) if p != 0 => Self::Ratio(q * p.signum(), p.abs()),
            _ => Self::of(1.0 / self.value()),
        }
    }

    /// x^n
    pub fn powi(self, n: i32) -> Self {
        let mut result = Self::ONE;
        for _ in 0..n.unsigned_abs().min(256) {
            result = result.mul(self);
        }
        if n < 0 { result.inverse() } else { result }
    }

    /// Numerator and denominator, where it is written as a fraction (1/3, 3/8) and not as a decimal.
    pub fn fraction(self) -> Option<(i64, i64)> {
        let Self::Ratio(p, q) = self else { return None };
        if q == 1 {
            return Some((p, 1));
        }
        // fifths and tenths read better as decimals, thirds and halves do not
        let few = p.abs() < 100 && q <= 144;
        let only_2_and_3 = {
            let mut rest = q;
            while rest % 2 == 0 {
                rest /= 2;
            }
            while rest % 3 == 0 {
                rest /= 3;
            }
            rest == 1
        };
        if (few && only_2_and_3) || terminating(q).is_none() { Some((p, q)) } else { None }
    }

    /// As a decimal: what ends in full, the rest at eight digits.
    pub fn decimal_text(self) -> String {
        let ends = matches!(self, Self::Ratio(_, q) if terminating(q).is_some());
        let x = self.value();
        let mantissa = format!("{x:e}").split('e').next().map_or(0, |m| m.bytes().filter(u8::is_ascii_digit).count());
        let rounded = if ends || mantissa <= 10 { x } else { format!("{x:.7e}").parse().unwrap_or(x) };
        if rounded != 0.0 && !(1e-4..1e12).contains(&rounded.abs()) { format!("{rounded:e}") } else { format!("{rounded}") }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Ratio(a, b), Self::Ratio(c, d)) => a == c && b == d,
            (Self::Float(x), Self::Float(y)) => x.to_bits() == y.to_bits(),
            _ => false,
        }
    }
}

impl Eq for Number {}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match self {
            Self::Ratio(p, q) => (0_u8, p, q).hash(state),
            Self::Float(x) => (1_u8, x.to_bits()).hash(state),
        }
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Self) -> Ordering {
        self.value().total_cmp(&other.value()).then_with(|| matches!(self, Self::Float(_)).cmp(&matches!(other, Self::Float(_))))
    }
}

/// p / q in lowest terms, if it is small enough.
fn ratio(p: i128, q: i128) -> Option<Number> {
    let (mut a, mut b) = (p.unsigned_abs(), q.unsigned_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let divisor = (a.max(1) as i128) * q.signum();
    let (p, q) = (p / divisor, q / divisor);
    (p.abs() < LIMIT && q < LIMIT).then_some(Number::Ratio(p as i64, q as i64))
}

/// p / q with a small denominator that equals x to rounding, by continued fractions.
fn small_ratio(x: f64, largest: i64) -> Option<Number> {
    if x.abs() >= 1e9 {
        return (x.fract() == 0.0 && x.abs() < LIMIT as f64).then_some(Number::Ratio(x as i64, 1));
    }
    let (mut p0, mut q0, mut p1, mut q1) = (0_i64, 1_i64, 1_i64, 0_i64);
    let mut rest = x;
    for _ in 0..12 {
        let whole = rest.floor();
        if whole.abs() > 1e9 {
            return None;
        }
        let (p2, q2) = (whole as i64 * p1 + p0, whole as i64 * q1 + q0);
        if q2 > largest {
            return None;
        }
        (p0, q0, p1, q1) = (p1, q1, p2, q2);
        if (p1 as f64 / q1 as f64 - x).abs() <= ROUNDING * x.abs() {
            return ratio(i128::from(p1), i128::from(q1));
        }
        if rest == whole {
            return None;
        }
        rest = 1.0 / (rest - whole);
    }
    None
}

/// A decimal of at most twelve digits, exactly.
fn decimal(x: f64) -> Option<Number> {
    let text = format!("{x:e}");
    let (mantissa, exponent) = text.split_once('e')?;
    let exponent: i32 = exponent.parse().ok()?;
    let digits: String = mantissa.chars().filter(|c| *c != '.').collect();
    let places = mantissa.split_once('.').map_or(0, |(_, after)| after.len() as i32) - exponent;
    if digits.trim_start_matches('-').len() > 12 || !(0..=15).contains(&places) {
        return None;
    }
    ratio(i128::from(digits.parse::<i64>().ok()?), 10_i128.pow(places.unsigned_abs()))
}

/// Decimal places of 1/q, if it ends.
fn terminating(q: i64) -> Option<usize> {
    let (mut twos, mut fives, mut rest) = (0, 0, q);
    while rest % 2 == 0 {
        (rest, twos) = (rest / 2, twos + 1);
    }
    while rest % 5 == 0 {
        (rest, fives) = (rest / 5, fives + 1);
    }
    (rest == 1).then_some(twos.max(fives))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_a_person_means_them() {
        assert_eq!(Number::of(0.5), Number::Ratio(1, 2));
        assert_eq!(Number::of(1.0 / 3.0), Number::Ratio(1, 3));
        assert_eq!(Number::of(0.499_999_999_999_999_94), Number::Ratio(1, 2));
        assert_eq!(Number::of(-2.0), Number::Ratio(-2, 1));
        assert_eq!(Number::of(0.0319).decimal_text(), "0.0319");
        assert_eq!(Number::of(2.072).decimal_text(), "2.072");
        assert_eq!(Number::of(4e-6).decimal_text(), "4e-6");
        assert_eq!(Number::of(1.3e13).decimal_text(), "1.3e13");
        assert_eq!(Number::of(0.5_f64.sqrt()).decimal_text(), "0.70710678");
        assert_eq!(Number::over_pi(std::f64::consts::FRAC_PI_6), Some(Number::Ratio(1, 6)));
        assert_eq!(Number::over_pi(0.5), None);
        assert_eq!(Number::of(0.2).fraction(), None);
        assert_eq!(Number::of(0.75).fraction(), Some((3, 4)));
    }

    #[test]
    fn decimals_add_exactly_and_rounding_cancels() {
        assert_eq!(Number::of(0.1).add(Number::of(0.2)), Number::of(0.3));
        let root = Number::of(2.0_f64.sqrt());
        assert_eq!(root.mul(root), Number::integer(2));
        assert!(root.add(Number::of(-(2.0_f64.sqrt()) * (1.0 + 1e-16))).is_zero());
    }
}
