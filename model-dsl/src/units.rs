//! Units as the user writes them, and the dimensions behind them.

/// A unit: its text, its dimension, and what one of it is in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// As written (`N*m*s`), or derived for display.
    pub text: String,
    /// Value of one unit in SI.
    pub factor: f64,
}
