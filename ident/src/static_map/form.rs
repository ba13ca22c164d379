//! The named forms of a static map y(x), with their derivatives and exact inverses.

/// A named form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// y = a x + c.
    Affine,
    /// y = a x^2 + b x + c.
    Quadratic,
    /// y = a x^3 + b x^2 + c x + d.
    Cubic,
    /// y = a x^b.
    Power,
    /// y = a x^b + c.
    PowerOffset,
    /// y = a (x - d) above d, 0 below.
    DeadZoneAffine,
    /// y = a (x - d)^2 + b (x - d) above d, 0 below.
    DeadZoneQuadratic,
    /// y = a (x - d)^b above d, 0 below.
    DeadZonePower,
}

/// All forms, in the order of tables.
pub const FORMS: [Form; 8] = [
    Form::Affine,
    Form::Quadratic,
    Form::Cubic,
    Form::Power,
    Form::PowerOffset,
    Form::DeadZoneAffine,
    Form::DeadZoneQuadratic,
    Form::DeadZonePower,
];

impl Form {
    /// The word for JSON and the command line.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Affine => "affine",
            Self::Quadratic => "quadratic",
            Self::Cubic => "cubic",
            Self::Power => "power",
            Self::PowerOffset => "power_offset",
            Self::DeadZoneAffine => "dead_zone_affine",
            Self::DeadZoneQuadratic => "dead_zone_quadratic",
            Self::DeadZonePower => "dead_zone_power",
        }
    }

    /// Names of its parameters, in order.
    #[must_use]
    pub fn parameters(self) -> &'static [&'static str] {
        match self {
            Self::Affine => &["a", "c"],
            Self::Quadratic => &["a", "b", "c"],
            Self::Cubic => &["a", "b", "c", "d"],
            Self::Power => &["a", "b"],
            Self::PowerOffset => &["a", "b", "c"],
            Self::DeadZoneAffine => &["a", "d"],
            Self::DeadZoneQuadratic => &["a", "b", "d"],
            Self::DeadZonePower => &["a", "b", "d"],
        }
    }

    /// Written out over names of abscissa and ordinate.
    #[must_use]
    pub fn written(self, x: &str, y: &str) -> String {
        match self {
            Self::Affine => format!("{y} = a {x} + c"),
            Self::Quadratic => format!("{y} = a {x}^2 + b {x} + c"),
            Self::Cubic => format!("{y} = a {x}^3 + b {x}^2 + c {x} + d"),
            Self::Power => format!("{y} = a {x}^b"),
            Self::PowerOffset => format!("{y} = a {x}^b + c"),
            Self::DeadZoneAffine => format!("{y} = a ({x} - d) above d, 0 below"),
            Self::DeadZoneQuadratic => format!("{y} = a ({x} - d)^2 + b ({x} - d) above d, 0 below"),
            Self::DeadZonePower => format!("{y} = a ({x} - d)^b above d, 0 below"),
        }
    }

    /// Needs x >= 0: a power with a broken exponent.
    #[must_use]
    pub fn needs_positive(self) -> bool {
        matches!(self, Self::Power | Self::PowerOffset)
    }

    /// The place of the parameter that enters neither linearly nor as a factor (exponent, dead zone), with starting values
    /// for abscissae up to `top`.
    pub(super) fn starts(self, top: f64) -> Vec<Vec<f64>> {
        let exponents = [0.4, 0.7, 1.0, 1.5, 2.0, 3.0];
        let zones = [0.02, 0.1, 0.2, 0.3, 0.4, 0.55, 0.7].map(|d| d * top);
        match self {
            Self::Affine | Self::Quadratic | Self::Cubic => vec![Vec::new()],
            Self::Power | Self::PowerOffset => exponents.iter().map(|&b| vec![b]).collect(),
            Self::DeadZoneAffine | Self::DeadZoneQuadratic => zones.iter().map(|&d| vec![d]).collect(),
            Self::DeadZonePower => zones.iter().flat_map(|&d| exponents[2..].iter().map(move |&b| vec![b, d])).collect(),
        }
    }

    /// Values of the terms with a linear coefficient at x, for given exponent and dead zone.
    pub(super) fn terms(self, x: f64, shape: &[f64]) -> Vec<f64> {
        let power = |x: f64, b: f64| if x > 0.0 { x.powf(b) } else { 0.0 };
        match (self, shape) {
            (Self::Affine, _) => vec![x, 1.0],
            (Self::Quadratic, _) => vec![x * x, x, 1.0],
            (Self::Cubic, _) => vec![x * x * x, x * x, x, 1.0],
            (Self::Power, [b, ..]) => vec![power(x, *b)],
            (Self::PowerOffset, [b, ..]) => vec![power(x, *b), 1.0],
            (Self::DeadZoneAffine, [d, ..]) => vec![(x - d).max(0.0)],
            (Self::DeadZoneQuadratic, [d, ..]) => vec![(x - d).max(0.0).powi(2), (x - d).max(0.0)],
            (Self::DeadZonePower, [b, d, ..]) => vec![power(x - d, *b)],
            _ => Vec::new(),
        }
    }

    /// Parameters in their order, from linear coefficients and shape.
    pub(super) fn assembled(self, linear: &[f64], shape: &[f64]) -> Vec<f64> {
        match (self, linear, shape) {
            (Self::Power | Self::DeadZonePower, _, _) | (Self::DeadZoneAffine | Self::DeadZoneQuadratic, _, _) => [linear, shape].concat(),
            (Self::PowerOffset, [a, c], [b]) => vec![*a, *b, *c],
            _ => linear.to_vec(),
        }
    }

    /// y(x) and its derivatives by the parameters.
    #[must_use]
    pub fn evaluate(self, p: &[f64], x: f64) -> (f64, Vec<f64>) {
        let power = |x: f64, b: f64| if x > 0.0 { (x.powf(b), x.powf(b) * x.ln()) } else { (0.0, 0.0) };
        match (self, p) {
            (Self::Affine, &[a, c]) => (a * x + c, vec![x, 1.0]),
            (Self::Quadratic, &[a, b, c]) => ((a * x + b) * x + c, vec![x * x, x, 1.0]),
            (Self::Cubic, &[a, b, c, d]) => (((a * x + b) * x + c) * x + d, vec![x * x * x, x * x, x, 1.0]),
            (Self::Power, &[a, b]) => {
                let (v, slope) = power(x, b);
                (a * v, vec![v, a * slope])
            }
            (Self::PowerOffset, &[a, b, c]) => {
                let (v, slope) = power(x, b);
                (a * v + c, vec![v, a * slope, 1.0])
            }
            (Self::DeadZoneAffine, &[a, d]) => {
                let s = (x - d).max(0.0);
                (a * s, vec![s, if s > 0.0 { -a } else { 0.0 }])
            }
            (Self::DeadZoneQuadratic, &[a, b, d]) => {
                let s = (x - d).max(0.0);
                ((a * s + b) * s, vec![s * s, s, if s > 0.0 { -2.0 * a * s - b } else { 0.0 }])
            }
            (Self::DeadZonePower, &[a, b, d]) => {
                let s = x - d;
                let (v, slope) = power(s, b);
                (a * v, vec![v, a * slope, if s > 0.0 { -a * b * v / s } else { 0.0 }])
            }
            _ => (f64::NAN, vec![f64::NAN; p.len()]),
        }
    }

    /// The exact inverse, written out with numbers over the name of the ordinate; `None` where there is no closed form that
    /// holds on the whole range.
    #[must_use]
    pub fn inverse(self, p: &[f64], x: &str, y: &str, range: (f64, f64)) -> Option<String> {
        let n = |v: f64| short(v);
        // y - c, y + |c|
        let minus = |name: &str, v: f64| if v < 0.0 { format!("{name} + {}", n(-v)) } else { format!("{name} - {}", n(v)) };
        Some(match (self, p) {
            (Self::Affine, &[a, c]) => format!("{x} = ({}) / {}", minus(y, c), n(a)),
            (Self::Quadratic, &[a, b, c]) => {
                // the branch on which the range lies
                let vertex = -b / (2.0 * a);
                let sign = if 0.5 * (range.0 + range.1) > vertex { '+' } else { '-' };
                format!("{x} = {} {sign} sqrt({} + ({}) / {})", n(vertex), n(vertex * vertex), minus(y, c), n(a))
            }
            (Self::Power, &[a, b]) => format!("{x} = ({y} / {})^(1 / {})", n(a), n(b)),
            (Self::PowerOffset, &[a, b, c]) => format!("{x} = (({}) / {})^(1 / {})", minus(y, c), n(a), n(b)),
            (Self::DeadZoneAffine, &[a, d]) => format!("{x} = {} + {y} / {} for {y} > 0", n(d), n(a)),
            (Self::DeadZoneQuadratic, &[a, b, d]) => {
                let s = -b / (2.0 * a);
                let sign = if a > 0.0 { '+' } else { '-' };
                format!("{x} = {} {sign} sqrt({} + {y} / {}) for {y} > 0", n(d + s), n(s * s), n(a))
            }
            (Self::DeadZonePower, &[a, b, d]) => format!("{x} = {} + ({y} / {})^(1 / {}) for {y} > 0", n(d), n(a), n(b)),
            _ => return None,
        })
    }

    /// x with y(x) = y, in the range; `None` where the map does not reach y there, or is not monotonic there.
    #[must_use]
    pub fn invert(self, p: &[f64], y: f64, range: (f64, f64)) -> Option<f64> {
        if !self.monotonic(p, range) {
            return None;
        }
        let at = |x: f64| self.evaluate(p, x).0 - y;
        let (mut lo, mut hi) = range;
        let (below, above) = (at(lo), at(hi));
        if !(below.is_finite() && above.is_finite()) || below * above > 0.0 {
            return None;
        }
        if above == 0.0 {
            return Some(hi);
        }
        // where the map is flat (a dead zone) the answer is its far end
        for _ in 0..200 {
            let middle = 0.5 * (lo + hi);
            if (at(middle) > 0.0) == (above > 0.0) { hi = middle } else { lo = middle }
        }
        Some(hi)
    }

    /// It rises, or falls, all along the range.
    #[must_use]
    pub fn monotonic(self, p: &[f64], range: (f64, f64)) -> bool {
        let steps = 400;
        let y: Vec<f64> =
            (0..=steps).map(|k| self.evaluate(p, range.0 + (range.1 - range.0) * f64::from(k) / f64::from(steps)).0).collect();
        y.windows(2).all(|w| w[1] >= w[0]) || y.windows(2).all(|w| w[1] <= w[0])
    }
}

/// Six significant digits.
fn short(v: f64) -> String {
    if v == 0.0 {
        return "0".to_owned();
    }
    let size = v.abs().log10().floor();
    if !(-4.0..6.0).contains(&size) {
        return format!("{v:.5e}");
    }
    let text = format!("{v:.*}", (5.0 - size).max(0.0) as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::{FORMS, Form};

    fn sample(form: Form) -> Vec<f64> {
        match form {
            Form::Affine => vec![1.3, 0.2],
            Form::Quadratic => vec![0.3, 0.2, -0.1],
            Form::Cubic => vec![0.1, 0.2, 0.3, -0.4],
            Form::Power => vec![0.4, 2.1],
            Form::PowerOffset => vec![0.3981, 2.072, 0.4988],
            Form::DeadZoneAffine => vec![1.3, 0.7],
            Form::DeadZoneQuadratic => vec![0.3, 0.1, 0.7],
            Form::DeadZonePower => vec![0.3, 1.7, 0.7],
        }
    }

    #[test]
    fn derivatives_are_those_of_the_values() {
        for form in FORMS {
            let p = sample(form);
            for x in [0.3, 1.1, 2.7] {
                let (_, slopes) = form.evaluate(&p, x);
                for (i, slope) in slopes.iter().enumerate() {
                    let moved = |h: f64| {
                        let mut q = p.clone();
                        q[i] += h;
                        form.evaluate(&q, x).0
                    };
                    let difference = (moved(1e-6) - moved(-1e-6)) / 2e-6;
                    assert!((slope - difference).abs() < 1e-8, "{form:?} {i} at {x}: {slope} {difference}");
                }
            }
        }
    }

    #[test]
    fn inverses_undo_their_maps() {
        for form in FORMS {
            let p = sample(form);
            for x in [0.9, 1.5, 2.9] {
                let back = form.invert(&p, form.evaluate(&p, x).0, (0.0, 3.0)).unwrap();
                assert!((back - x).abs() < 1e-9, "{form:?}: {back} for {x}");
            }
        }
        assert_eq!(Form::Affine.invert(&[1.0, 0.0], 4.0, (0.0, 3.0)), None);
        assert_eq!(Form::Quadratic.invert(&[1.0, 0.0, 0.0], 1.0, (-2.0, 3.0)), None);
        let text = Form::PowerOffset.inverse(&[0.3981, 2.072, 0.4988], "V", "f", (0.0, 3.0)).unwrap();
        assert_eq!(text, "V = ((f - 0.4988) / 0.3981)^(1 / 2.072)");
    }
}
