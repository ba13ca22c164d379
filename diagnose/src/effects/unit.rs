//! Units of an effect's parameters, as the language writes them.

use model_dsl::rig::Rig;

/// A product of powers of named units.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Text(Vec<(String, i32)>);

impl Text {
    pub fn one() -> Self {
        Self(Vec::new())
    }

    /// From text as `N*m`, `1/(kg*m)`, `kg m^2/s^2`.
    pub fn read(text: &str) -> Self {
        let mut out = Self::one();
        let mut sign = 1;
        let mut depth_sign = Vec::new();
        let mut word = String::new();
        let flush = |word: &mut String, sign: &mut i32, depth: &[i32], out: &mut Self| {
            if !word.is_empty() {
                let (name, power) = word.split_once('^').unwrap_or((word, "1"));
                let outer: i32 = depth.iter().product();
                out.times(name, *sign * outer * power.parse::<i32>().unwrap_or(1));
                word.clear();
                *sign = 1;
            }
        };
        for c in text.chars() {
            match c {
                '*' | ' ' | '·' => flush(&mut word, &mut sign, &depth_sign, &mut out),
                '/' => {
                    flush(&mut word, &mut sign, &depth_sign, &mut out);
                    sign = -1;
                }
                '(' => {
                    depth_sign.push(sign);
                    sign = 1;
                }
                ')' => {
                    flush(&mut word, &mut sign, &depth_sign, &mut out);
                    depth_sign.pop();
                }
                c => word.push(c),
            }
        }
        flush(&mut word, &mut sign, &depth_sign, &mut out);
        out
    }

    fn times(&mut self, name: &str, power: i32) {
        // radians are plain numbers; degrees are not used here, values are SI
        if matches!(name, "1" | "rad" | "deg" | "turn" | "rev") || name.is_empty() {
            return;
        }
        match self.0.iter_mut().find(|(n, _)| n == name) {
            Some((_, p)) => *p += power,
            None => self.0.push((name.to_owned(), power)),
        }
        self.0.retain(|(_, p)| *p != 0);
    }

    pub fn by(&self, other: &Self, power: i32) -> Self {
        let mut out = self.clone();
        for (name, p) in &other.0 {
            out.times(name, p * power);
        }
        out
    }

    pub fn text(&self) -> String {
        let part = |positive: bool| -> Vec<String> {
            self.0
                .iter()
                .filter(|(_, p)| (*p > 0) == positive)
                .map(|(n, p)| if p.abs() == 1 { n.clone() } else { format!("{n}^{}", p.abs()) })
                .collect()
        };
        let (top, bottom) = (part(true), part(false));
        let top = if top.is_empty() { "1".to_owned() } else { top.join("*") };
        match bottom.len() {
            0 => top,
            1 => format!("{top}/{}", bottom[0]),
            _ => format!("{top}/({})", bottom.join("*")),
        }
    }
}

/// Unit of a coordinate (a plain number for an angle).
pub(crate) fn of_coordinate(rig: &Rig, i: usize) -> Text {
    if is_angle(rig, i) { Text::one() } else { Text::read("m") }
}

pub(crate) fn of_rate(rig: &Rig, i: usize) -> Text {
    of_coordinate(rig, i).by(&Text::read("s"), -1)
}

/// The coordinate is an angle.
pub(crate) fn is_angle(rig: &Rig, i: usize) -> bool {
    rig.coordinates[i].unit.dimension == model_dsl::units::Dimension::NONE
}

/// Unit of a coordinate's equation.
pub(crate) fn of_row(rig: &Rig, i: usize) -> Text {
    match rig.equations.iter().find(|e| e.coordinate == i) {
        Some(equation) => Text::read(&equation.unit.text),
        None if is_angle(rig, i) => Text::read("N*m"),
        None => Text::read("N"),
    }
}

#[cfg(test)]
mod tests {
    use super::Text;

    #[test]
    fn read_and_written() {
        for (from, to) in [("N*m", "N*m"), ("1/(kg*m)", "1/(kg*m)"), ("kg m^2/s^2", "kg*m^2/s^2"), ("rad/s^2", "1/s^2"), ("N/(m*s)", "N/(m*s)")] {
            assert_eq!(Text::read(from).text(), to);
        }
        assert_eq!(Text::read("N*m").by(&Text::read("1/s"), -1).text(), "N*m*s");
    }
}
