//! Effects of the user's own, from a TOML file:
//!
//! ```toml
//! [[effect]]
//! id = "ripple"
//! place = "psi"
//! text = "torque ripple on psi: A_r * sin(24 * psi);"
//! parameters = [{ name = "A_r", unit = "N*m", doc = "cogging" }]
//! ```

use super::{Edit, Effect, EffectParameter, Signature};
use serde::Deserialize;
use std::fmt;

/// Why a file of effects was not read.
#[derive(Clone, Debug, PartialEq)]
pub enum OwnError {
    /// It is no such file.
    Format {
        /// What the reader says, with the place.
        why: String,
    },
    /// An effect without parameters cannot be tested.
    NoParameter {
        /// Effect.
        id: String,
    },
}

impl fmt::Display for OwnError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Format { why } => write!(f, "{}", why.trim_end()),
            Self::NoParameter { id } => {
                write!(f, "the effect `{id}` has no parameter: give it one that is zero where the effect is absent")
            }
        }
    }
}

impl std::error::Error for OwnError {}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    effect: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    id: String,
    place: String,
    text: String,
    parameters: Vec<Parameter>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Parameter {
    name: String,
    unit: String,
    #[serde(default)]
    positive: bool,
    #[serde(default)]
    doc: String,
}

/// Reads effects.
///
/// # Errors
/// [`OwnError`].
pub fn read_own(text: &str) -> Result<Vec<Effect>, OwnError> {
    let file: File = toml::from_str(text).map_err(|e| OwnError::Format { why: e.to_string() })?;
    file.effect
        .into_iter()
        .map(|e| {
            if e.parameters.is_empty() {
                return Err(OwnError::NoParameter { id: e.id });
            }
            let parameters = e
                .parameters
                .into_iter()
                .map(|p| EffectParameter { name: p.name, unit: p.unit, positive: p.positive, most: None, doc: p.doc, shape: None })
                .collect();
            let (edit, signature) = (Edit::Add(e.text), Signature::Parameters);
            Ok(Effect { id: e.id, place: e.place, parameters, shape: None, edit, signature, of_the_day: false, by_record: false })
        })
        .collect()
}
