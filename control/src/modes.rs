//! Modes: eigenvalues as a person writes them, stability in continuous and discrete time, and who takes part.

use nalgebra::Complex;

/// Whether a matrix belongs to x' = A x or to x(k + 1) = A x(k).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Time {
    /// x' = A x: stable to the left of the imaginary axis.
    Continuous,
    /// x(k + 1) = A x(k): stable inside the unit circle.
    Discrete,
}

impl Time {
    /// How far an eigenvalue is beyond the limit of stability: its real part, or its modulus minus one.
    #[must_use]
    pub fn growth(self, z: Complex<f64>) -> f64 {
        match self {
            Self::Continuous => z.re,
            Self::Discrete => z.norm() - 1.0,
        }
    }

    /// The nearest point of the limit of stability.
    #[must_use]
    pub fn onto_limit(self, z: Complex<f64>) -> Complex<f64> {
        match self {
            Self::Continuous => Complex::new(0.0, z.im),
            Self::Discrete if z.norm() > 0.0 => z / z.norm(),
            Self::Discrete => Complex::new(1.0, 0.0),
        }
    }

    /// All eigenvalues are stable.
    #[must_use]
    pub fn stable(self, poles: &[Complex<f64>]) -> bool {
        poles.iter().all(|&z| self.growth(z) < 0.0)
    }
}

/// An eigenvalue in words: `-0.05 + 0.51i`, at most four digits.
#[must_use]
pub fn show(z: Complex<f64>) -> String {
    let digits = |x: f64| {
        let size = x.abs();
        if size != 0.0 && !(1e-3..1e5).contains(&size) {
            format!("{x:.3e}")
        } else {
            let places = if size >= 1000.0 { 0 } else { 4 };
            let text = format!("{x:.places$}");
            if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
        }
    };
    let re = digits(z.re + 0.0);
    let im = digits(z.im.abs());
    if z.im == 0.0 { re } else { format!("{re} {} {im}i", if z.im < 0.0 { '-' } else { '+' }) }
}

/// Names of the entries that make up most of a vector, largest first, at most four; `x1`, `x2` where there are no names.
#[must_use]
pub fn who(vector: &[f64], names: &[String]) -> String {
    let largest = vector.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let mut order: Vec<usize> = (0..vector.len()).filter(|&i| vector[i].abs() > 0.1 * largest).collect();
    // equal weights keep the order of the states
    order.sort_by(|&i, &j| (vector[j].abs() / largest * 1e6).round().total_cmp(&(vector[i].abs() / largest * 1e6).round()));
    let mut words: Vec<String> = order.iter().take(4).map(|&i| names.get(i).cloned().unwrap_or_else(|| format!("x{}", i + 1))).collect();
    if order.len() > 4 {
        words.push("...".to_owned());
    }
    words.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvalues_read_as_written() {
        let show = |re, im| show(Complex::new(re, im));
        assert_eq!(show(0.0, 0.0), "0");
        assert_eq!(show(-0.05, 0.51), "-0.05 + 0.51i");
        assert_eq!(show(-0.0, -2.0), "0 - 2i");
        assert_eq!(show(1.234e-7, 0.0), "1.234e-7");
    }
}
