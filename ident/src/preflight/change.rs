//! What may have gone wrong in the wiring or in the export of a record, as a change that undoes it.

use crate::record::Record;
use std::f64::consts::PI;

/// A change of a record, or of the rig, after which they would agree.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// This measured output, with its sign turned.
    SignOfOutput(String),
    /// This input, with its sign turned.
    SignOfInput(String),
    /// The columns of these two outputs, exchanged.
    SwapOutputs(String, String),
    /// The columns of these two inputs, exchanged.
    SwapInputs(String, String),
    /// The column holds degrees and is read as radians.
    Degrees(String),
    /// The column holds radians and is read as degrees.
    Radians(String),
    /// The angle is counted from the other end: half a turn is added.
    HalfTurn(String),
    /// The output reads this much too little (SI).
    Offset(String, f64),
    /// The logged inputs do not belong to the motion: each held at its mean.
    Foreign(Vec<String>),
    /// The parameter of the rig, with its sign turned.
    SignOfParameter(String),
}

impl Change {
    /// The word for JSON.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::SignOfOutput(_) => "output_sign",
            Self::SignOfInput(_) => "input_sign",
            Self::SwapOutputs(..) => "outputs_swapped",
            Self::SwapInputs(..) => "inputs_swapped",
            Self::Degrees(_) => "degrees_as_radians",
            Self::Radians(_) => "radians_as_degrees",
            Self::HalfTurn(_) => "half_turn",
            Self::Offset(..) => "zero_offset",
            Self::Foreign(_) => "foreign_input",
            Self::SignOfParameter(_) => "parameter_sign",
        }
    }

    /// Turned or exchanged channels, which leave the size of everything as it is.
    #[must_use]
    pub fn is_wiring(&self) -> bool {
        matches!(self, Self::SignOfOutput(_) | Self::SignOfInput(_) | Self::SwapOutputs(..) | Self::SwapInputs(..))
    }

    /// Channels or parameters that it changes.
    #[must_use]
    pub fn channels(&self) -> Vec<String> {
        match self {
            Self::SwapOutputs(a, b) | Self::SwapInputs(a, b) => vec![a.clone(), b.clone()],
            Self::Foreign(names) => names.clone(),
            Self::SignOfOutput(a)
            | Self::SignOfInput(a)
            | Self::Degrees(a)
            | Self::Radians(a)
            | Self::HalfTurn(a)
            | Self::Offset(a, _)
            | Self::SignOfParameter(a) => vec![a.clone()],
        }
    }

    /// What it claims, without saying how sure it is: `the sign of `theta` is turned`.
    #[must_use]
    pub fn claim(&self) -> String {
        match self {
            Self::SignOfOutput(a) | Self::SignOfInput(a) => format!("`{a}` is logged with the wrong sign"),
            Self::SwapOutputs(a, b) | Self::SwapInputs(a, b) => format!("`{a}` and `{b}` are exchanged"),
            Self::Degrees(a) => format!("`{a}` is in degrees, but read as radians"),
            Self::Radians(a) => format!("`{a}` is in radians, but read as degrees"),
            Self::HalfTurn(a) => format!("`{a}` is logged half a turn away from the rig's zero"),
            Self::Offset(a, by) => format!(
                "the rest of the rig is not where `{a}` is zero: its encoder was switched on at {} of the rig, or the rig's masses and lengths are off",
                degrees(*by)
            ),
            Self::Foreign(names) => format!(
                "the logged {} {} not what drove the rig here",
                names.iter().map(|n| format!("`{n}`")).collect::<Vec<_>>().join(", "),
                if names.len() == 1 { "is" } else { "are" }
            ),
            Self::SignOfParameter(a) => format!("the parameter `{a}` has the wrong sign for this motion"),
        }
    }

    /// How to mend it, where the record is described (or named) by the user.
    #[must_use]
    pub fn mend(&self) -> String {
        match self {
            Self::SignOfOutput(a) => format!("in a description of the record: `{a} = {{ .., sign = -1 }}`; or turn its axis in the rig"),
            Self::SignOfInput(a) => format!("in a description of the record: `{a} = {{ .., sign = -1 }}`; or turn the actuator in the rig"),
            Self::SwapOutputs(a, b) | Self::SwapInputs(a, b) => {
                format!("exchange the columns: name the one `{b}` that is now `{a}`, and the other way round")
            }
            Self::Degrees(a) => format!("name the column `{a} [deg]`, or write `unit = \"deg\"` in its description"),
            Self::Radians(a) => format!("take `[deg]` out of the name of the column `{a}`, or write `unit = \"rad\"` in its description"),
            Self::HalfTurn(a) => {
                format!("in a description: `{a} = {{ .., offset = {PI:.4} }}` (or 180 with `unit = \"deg\"`); or count it so in the rig")
            }
            Self::Offset(a, by) => {
                format!(
                    "if the encoder was zeroed there, write `encoder {a}: .. zero at {}` in the rig; otherwise free the masses",
                    degrees(*by)
                )
            }
            Self::Foreign(_) => "check that input and output come from one run, and that their clocks start together".to_owned(),
            Self::SignOfParameter(a) => {
                format!("turn the sign of `{a}`, or look for the axis or the direction of gravity that it hangs on")
            }
        }
    }

    /// The changed record.
    pub(super) fn apply(&self, record: &Record) -> Record {
        let mut r = record.clone();
        match self {
            Self::SignOfOutput(a) => affine(&mut r, a, -1.0, 0.0),
            Self::SignOfInput(a) => affine(&mut r, a, -1.0, 0.0),
            Self::SwapOutputs(a, b) | Self::SwapInputs(a, b) => {
                let swapped = |name: &str| if name == a { b.clone() } else { a.clone() };
                r.columns.iter_mut().filter(|c| c.name == *a || c.name == *b).for_each(|c| c.name = swapped(&c.name));
                r.declared.iter_mut().filter(|c| c.name == *a || c.name == *b).for_each(|c| c.name = swapped(&c.name));
            }
            Self::Degrees(a) => affine(&mut r, a, PI / 180.0, 0.0),
            Self::Radians(a) => affine(&mut r, a, 180.0 / PI, 0.0),
            Self::HalfTurn(a) => affine(&mut r, a, 1.0, PI),
            Self::Offset(a, by) => affine(&mut r, a, 1.0, *by),
            Self::Foreign(names) => {
                for name in names {
                    if let Some(c) = r.columns.iter_mut().find(|c| c.name == *name) {
                        let mean = c.values.iter().sum::<f64>() / c.values.len().max(1) as f64;
                        c.values.iter_mut().for_each(|u| *u = mean);
                    }
                }
            }
            Self::SignOfParameter(_) => {}
        }
        r
    }
}

fn affine(record: &mut Record, name: &str, factor: f64, offset: f64) {
    if let Some(c) = record.columns.iter_mut().find(|c| c.name == name) {
        c.values.iter_mut().for_each(|y| *y = factor * *y + offset);
    }
    if let Some(d) = record.declared.iter_mut().find(|d| d.name == name) {
        d.steps.iter_mut().for_each(|(_, u)| *u = factor * *u + offset);
    }
}

fn degrees(radians: f64) -> String {
    format!("{:.1}deg", radians.to_degrees())
}
