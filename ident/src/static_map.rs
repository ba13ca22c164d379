//! Static maps from pairs: the thrust of a propeller by its voltage, the force of a valve by its command.
//!
//! Every named form is fitted by nonlinear least squares, with errors of one size and, where the ordinate does not change its
//! sign, with errors in proportion; the corrected Akaike criterion chooses, and says what it can hardly tell apart.

mod fitting;
mod form;
mod pairs;

pub use fitting::{Errors, Fitted};
pub use form::{FORMS, Form};
pub use pairs::{Axis, Pairs, read_pairs};

use std::fmt;

/// Forms fitted to pairs, the best first.
#[derive(Clone, Debug, PartialEq)]
pub struct MapFit {
    /// By rising corrected Akaike criterion; each form once, with the errors that suit it best.
    pub forms: Vec<Fitted>,
    /// Least and largest abscissa.
    pub range: (f64, f64),
}

/// Forms whose criterion is within this of the best one can hardly be told from it.
pub const NEAR_TIE: f64 = 2.0;

impl MapFit {
    /// The chosen form.
    #[must_use]
    pub fn chosen(&self) -> Option<&Fitted> {
        self.forms.first()
    }

    /// Forms that the pairs can hardly tell from the chosen one.
    #[must_use]
    pub fn near_ties(&self) -> Vec<&Fitted> {
        let Some(best) = self.chosen() else { return Vec::new() };
        self.forms[1..].iter().filter(|f| f.aicc - best.aicc < NEAR_TIE).collect()
    }
}

/// Why no map was fitted.
#[derive(Clone, Debug, PartialEq)]
pub enum MapError {
    /// Abscissae and ordinates differ in number, or a number is not finite.
    Pairs {
        /// What is wrong.
        why: String,
    },
    /// Too few pairs.
    TooFew {
        /// How many.
        found: usize,
        /// How many different abscissae.
        different: usize,
    },
    /// The form that was asked for does not go through these pairs.
    NoFit {
        /// Form.
        form: &'static str,
    },
}

impl fmt::Display for MapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pairs { why } => f.write_str(why),
            Self::TooFew { found, different } => {
                write!(
                    f,
                    "{found} pairs at {different} different abscissae are too few: a map of two parameters needs at least five at three"
                )
            }
            Self::NoFit { form } => write!(
                f,
                "the form `{form}` cannot be fitted to these pairs: a power needs abscissae that are not negative, and every form three more pairs than parameters"
            ),
        }
    }
}

impl std::error::Error for MapError {}

/// Fits the forms (all where `only` is `None`) to pairs.
///
/// # Errors
/// [`MapError`], one variant a cause.
pub fn fit_map(x: &[f64], y: &[f64], only: Option<Form>) -> Result<MapFit, MapError> {
    if x.len() != y.len() {
        return Err(MapError::Pairs { why: format!("{} abscissae, but {} ordinates", x.len(), y.len()) });
    }
    if let Some(k) = x.iter().zip(y).position(|(x, y)| !(x.is_finite() && y.is_finite())) {
        return Err(MapError::Pairs { why: format!("pair {} is not finite", k + 1) });
    }
    let mut different = x.to_vec();
    different.sort_by(f64::total_cmp);
    different.dedup();
    if x.len() < 5 || different.len() < 3 {
        return Err(MapError::TooFew { found: x.len(), different: different.len() });
    }
    let one_sign = y.iter().all(|y| *y > 0.0) || y.iter().all(|y| *y < 0.0);
    let mut forms: Vec<Fitted> = FORMS
        .into_iter()
        .filter(|f| only.is_none_or(|o| o == *f))
        // as many different abscissae as parameters, or the form is not fixed by them
        .filter(|f| f.parameters().len() <= different.len())
        .filter_map(|form| {
            let constant = fitting::fit(form, Errors::Constant, x, y);
            let proportional = if one_sign { fitting::fit(form, Errors::Proportional, x, y) } else { None };
            [constant, proportional].into_iter().flatten().min_by(|a, b| a.aicc.total_cmp(&b.aicc))
        })
        .collect();
    forms.sort_by(|a, b| a.aicc.total_cmp(&b.aicc));
    match (forms.is_empty(), only) {
        (true, Some(form)) => Err(MapError::NoFit { form: form.id() }),
        (true, None) => Err(MapError::TooFew { found: x.len(), different: different.len() }),
        _ => Ok(MapFit { forms, range: (different[0], different[different.len() - 1]) }),
    }
}
