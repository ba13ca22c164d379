//! Explicit Runge-Kutta methods of fixed step: coefficients, and the polynomial between the ends of a step.

/// An explicit Runge-Kutta method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FixedMethod {
    /// The classical method of order 4; cubic Hermite polynomial inside a step. Cheapest where every sample is a step.
    Classical,
    /// Dormand and Prince, order 5, with Shampine's polynomial of order 4 inside a step (Hairer, Norsett, Wanner, "Solving
    /// Ordinary Differential Equations I", II.5 and II.6). Cheapest where a step spans many samples.
    DormandPrince,
}

/// Coefficients; the derivative at the end of a step is stage `stages` (counted from 0) of both methods.
pub(crate) struct Tableau {
    /// Times of the stages after the first, in steps.
    pub c: &'static [f64],
    /// Row s - 1 makes stage s from those before it.
    pub a: &'static [&'static [f64]],
    /// Weights of the step.
    pub b: &'static [f64],
    /// Weights of the last coefficient of the polynomial, the end's derivative included; empty for cubic Hermite.
    pub d: &'static [f64],
}

impl FixedMethod {
    pub(crate) fn tableau(self) -> &'static Tableau {
        match self {
            Self::Classical => &CLASSICAL,
            Self::DormandPrince => &DORMAND_PRINCE,
        }
    }
}

static CLASSICAL: Tableau =
    Tableau { c: &[0.5, 0.5, 1.0], a: &[&[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]], b: &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0], d: &[] };

static DORMAND_PRINCE: Tableau = Tableau {
    c: &[0.2, 0.3, 0.8, 8.0 / 9.0, 1.0],
    a: &[
        &[0.2],
        &[3.0 / 40.0, 9.0 / 40.0],
        &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
        &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
        &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    ],
    b: &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
    d: &[
        -12_715_105_075.0 / 11_282_082_432.0,
        0.0,
        87_487_479_700.0 / 32_700_410_799.0,
        -10_690_763_975.0 / 1_880_347_072.0,
        701_980_252_875.0 / 199_316_789_632.0,
        -1_453_857_185.0 / 822_651_844.0,
        69_997_945.0 / 29_380_423.0,
    ],
};

#[cfg(test)]
mod tests {
    use super::FixedMethod;

    #[test]
    fn rows_sum_to_the_times_of_their_stages() {
        for method in [FixedMethod::Classical, FixedMethod::DormandPrince] {
            let t = method.tableau();
            for (row, c) in t.a.iter().zip(t.c) {
                assert!((row.iter().sum::<f64>() - c).abs() < 1e-14);
            }
            assert!((t.b.iter().sum::<f64>() - 1.0).abs() < 1e-15);
            assert!(t.d.iter().sum::<f64>().abs() < 1e-14);
        }
    }
}
