//! Units as the user writes them, and the dimensions behind them.

use std::fmt;
use std::ops::{Div, Mul};

/// Exponents of kg, m, s, A, K and of cycles (so that hertz are not radians per second).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Dimension([i16; 6]);

impl Dimension {
    /// No dimension: numbers, radians.
    pub const NONE: Self = Self([0; 6]);
    /// kg
    pub const MASS: Self = Self([1, 0, 0, 0, 0, 0]);
    /// m
    pub const LENGTH: Self = Self([0, 1, 0, 0, 0, 0]);
    /// s
    pub const TIME: Self = Self([0, 0, 1, 0, 0, 0]);
    /// kg m^2
    pub const INERTIA: Self = Self([1, 2, 0, 0, 0, 0]);
    /// m/s^2
    pub const ACCELERATION: Self = Self([0, 1, -2, 0, 0, 0]);
    /// N
    pub const FORCE: Self = Self([1, 1, -2, 0, 0, 0]);
    /// N m
    pub const TORQUE: Self = Self([1, 2, -2, 0, 0, 0]);
    /// W
    pub const POWER: Self = Self([1, 2, -3, 0, 0, 0]);

    /// To an integer power.
    #[must_use]
    pub fn powi(self, n: i16) -> Self {
        Self(self.0.map(|e| e.saturating_mul(n)))
    }

    /// Square root, if the exponents are even.
    #[must_use]
    pub fn sqrt(self) -> Option<Self> {
        self.0.iter().all(|e| e % 2 == 0).then(|| Self(self.0.map(|e| e / 2)))
    }

    /// Differs from another one by cycles only.
    #[must_use]
    pub fn equal_but_for_cycles(self, other: Self) -> bool {
        self.0[..5] == other.0[..5] && self.0[5] != other.0[5]
    }
}

impl Mul for Dimension {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k].saturating_add(other.0[k])))
    }
}

impl Div for Dimension {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k].saturating_sub(other.0[k])))
    }
}

impl fmt::Display for Dimension {
    /// In familiar units: `N m`, `N m/V`, `rad/s`-like ones as `1/s`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::NONE {
            return f.write_str("a plain number (or radians)");
        }
        let volt = Self([1, 2, -3, -1, 0, 0]);
        let newton = Self::FORCE;
        let candidates: [(&str, Self); 13] = [
            ("N", newton),
            ("N m", Self::TORQUE),
            ("N/m", newton / Self::LENGTH),
            ("N s/m", newton * Self::TIME / Self::LENGTH),
            ("N m s", Self::TORQUE * Self::TIME),
            ("W", Self::POWER),
            ("V", volt),
            ("N/V", newton / volt),
            ("N m/V", Self::TORQUE / volt),
            ("V s", volt * Self::TIME),
            ("N m/A", Self([1, 2, -2, -1, 0, 0])),
            ("ohm", Self([1, 2, -3, -2, 0, 0])),
            ("Hz", Self([0, 0, -1, 0, 0, 1])),
        ];
        if let Some((name, _)) = candidates.iter().find(|(_, d)| d == self) {
            return f.write_str(name);
        }
        let names = ["kg", "m", "s", "A", "K", "cycle"];
        let side = |positive: bool| {
            names
                .iter()
                .zip(self.0)
                .filter(|(_, e)| if positive { *e > 0 } else { *e < 0 })
                .map(|(n, e)| if e.abs() == 1 { (*n).to_owned() } else { format!("{n}^{}", e.abs()) })
                .collect::<Vec<_>>()
        };
        let (top, bottom) = (side(true), side(false));
        let top = if top.is_empty() { "1".to_owned() } else { top.join(" ") };
        match bottom.len() {
            0 => f.write_str(&top),
            1 => write!(f, "{top}/{}", bottom[0]),
            _ => write!(f, "{top}/({})", bottom.join(" ")),
        }
    }
}

/// A unit: its text, its dimension, and what one of it is in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// As written (`N*m*s`).
    pub text: String,
    /// Value of one unit in SI.
    pub factor: f64,
    /// Dimension.
    pub dimension: Dimension,
}

impl Unit {
    /// A number without unit.
    #[must_use]
    pub fn none() -> Self {
        Self { text: "1".to_owned(), factor: 1.0, dimension: Dimension::NONE }
    }

    /// The SI unit of a dimension, for display.
    #[must_use]
    pub fn si(dimension: Dimension) -> Self {
        let text = if dimension == Dimension::NONE { "1".to_owned() } else { dimension.to_string() };
        Self { text, factor: 1.0, dimension }
    }

    /// This unit per second.
    #[must_use]
    pub fn per_second(&self) -> Self {
        Self { text: format!("{}/s", self.text), factor: self.factor, dimension: self.dimension / Dimension::TIME }
    }

    /// The unit of this name, SI prefixes included.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let unit = |factor: f64, dimension: [i16; 6]| Some(Self { text: name.to_owned(), factor, dimension: Dimension(dimension) });
        let tau = std::f64::consts::TAU;
        match name {
            "rad" => return unit(1.0, [0; 6]),
            "deg" => return unit(tau / 360.0, [0; 6]),
            "turn" | "rev" => return unit(tau, [0; 6]),
            "rpm" => return unit(tau / 60.0, [0, 0, -1, 0, 0, 0]),
            "kg" => return unit(1.0, [1, 0, 0, 0, 0, 0]),
            "min" => return unit(60.0, [0, 0, 1, 0, 0, 0]),
            "h" => return unit(3600.0, [0, 0, 1, 0, 0, 0]),
            "inch" => return unit(0.0254, [0, 1, 0, 0, 0, 0]),
            "percent" => return unit(0.01, [0; 6]),
            "cycle" => return unit(1.0, [0, 0, 0, 0, 0, 1]),
            "kt" => return unit(1000.0, [1, 0, 0, 0, 0, 0]),
            _ => {}
        }
        if let Some((factor, dimension)) = prefixable(name) {
            return unit(factor, dimension);
        }
        for (prefix, scale) in
            [("m", 1e-3), ("k", 1e3), ("u", 1e-6), ("µ", 1e-6), ("n", 1e-9), ("c", 1e-2), ("M", 1e6), ("d", 1e-1), ("G", 1e9), ("p", 1e-12)]
        {
            if let Some((factor, dimension)) = name.strip_prefix(prefix).and_then(prefixable) {
                return unit(scale * factor, dimension);
            }
        }
        None
    }
}

/// Units that take SI prefixes.
fn prefixable(name: &str) -> Option<(f64, [i16; 6])> {
    Some(match name {
        "m" => (1.0, [0, 1, 0, 0, 0, 0]),
        "g" => (1e-3, [1, 0, 0, 0, 0, 0]),
        "t" => (1e3, [1, 0, 0, 0, 0, 0]),
        "s" => (1.0, [0, 0, 1, 0, 0, 0]),
        "A" => (1.0, [0, 0, 0, 1, 0, 0]),
        "K" => (1.0, [0, 0, 0, 0, 1, 0]),
        "N" => (1.0, [1, 1, -2, 0, 0, 0]),
        "J" => (1.0, [1, 2, -2, 0, 0, 0]),
        "W" => (1.0, [1, 2, -3, 0, 0, 0]),
        "V" => (1.0, [1, 2, -3, -1, 0, 0]),
        "ohm" | "Ohm" | "Ω" => (1.0, [1, 2, -3, -2, 0, 0]),
        "H" => (1.0, [1, 2, -2, -2, 0, 0]),
        "F" => (1.0, [-1, -2, 4, 2, 0, 0]),
        "C" => (1.0, [0, 0, 1, 1, 0, 0]),
        "T" => (1.0, [1, 0, -2, -1, 0, 0]),
        "Pa" => (1.0, [1, -1, -2, 0, 0, 0]),
        "Hz" => (1.0, [0, 0, -1, 0, 0, 1]),
        _ => return None,
    })
}

/// What was probably meant by a word that is no unit: another name, or a product without `*`.
#[must_use]
pub fn meant(word: &str) -> Option<String> {
    let plain = match word.to_lowercase().trim_end_matches('s') {
        "radian" => "rad",
        "degree" | "grad" => "deg",
        "newton" => "N",
        "meter" | "metre" => "m",
        "second" | "sec" => "s",
        "gram" => "g",
        "kilogram" | "kgram" | "kilo" => "kg",
        "volt" => "V",
        "ampere" | "amp" => "A",
        "hertz" => "Hz",
        "joule" => "J",
        "watt" => "W",
        "millisecond" | "msec" => "ms",
        "millimeter" | "millimetre" => "mm",
        "minute" => "min",
        "hour" => "h",
        "revolution" => "turn",
        "kelvin" => "K",
        "in" | "inche" => "inch",
        _ => "",
    };
    if !plain.is_empty() {
        return Some(plain.to_owned());
    }
    // Nms, Nm: each letter or two a unit
    let letters: Vec<char> = word.chars().collect();
    if (2..=5).contains(&letters.len()) {
        return product(&letters).filter(|p| p.len() > 1).map(|p| p.join("*"));
    }
    None
}

fn product(letters: &[char]) -> Option<Vec<String>> {
    if letters.is_empty() {
        return Some(Vec::new());
    }
    for length in [2, 1] {
        let Some((head, rest)) = letters.split_at_checked(length) else { continue };
        let name: String = head.iter().collect();
        let simple = ["N", "m", "s", "kg", "A", "V", "W", "J", "K"].contains(&name.as_str());
        if simple && let Some(rest) = product(rest) {
            return Some([vec![name], rest].concat());
        }
    }
    None
}
