//! Plots: series over axes, drawn as SVG that takes its colours from the page.

mod axis;
mod draw;
mod thin;

pub(crate) use draw::figure;

/// An axis.
#[derive(Clone, Debug, Default)]
pub struct Axis {
    /// What it shows, with its unit.
    pub label: String,
    /// Powers of ten in equal steps.
    pub log: bool,
    /// Its ends; `None`: those of the data.
    pub range: Option<(f64, f64)>,
}

impl Axis {
    /// An axis from end to end of its data.
    #[must_use]
    pub fn new(label: impl Into<String>) -> Self {
        Self { label: label.into(), ..Self::default() }
    }
}

/// What a series stands for; decides its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// What was measured. Where there is such a series, others do not stretch the axis far beyond it.
    Measured,
    /// What the model says.
    Model,
    /// What it said before.
    Before,
    /// What was asked for.
    Reference,
    /// A limit.
    Limit,
    /// One of several of the same kind.
    Slot(usize),
}

impl Ink {
    fn class(self) -> String {
        match self {
            Self::Measured => "measured".to_owned(),
            Self::Model => "model".to_owned(),
            Self::Before => "before".to_owned(),
            Self::Reference => "reference".to_owned(),
            Self::Limit => "limit".to_owned(),
            Self::Slot(k) => format!("s{}", k % 8),
        }
    }
}

/// How a series is drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// From sample to sample.
    Line,
    /// The same, dashed.
    Dashed,
    /// Each value holds up to the next sample.
    Steps,
    /// A dot at each sample.
    Dots,
    /// A ring at each sample.
    Rings,
    /// A cross at each sample.
    Crosses,
    /// A line from zero up to each sample.
    Stems,
    /// The area between the series and this one.
    Band(Vec<f64>),
}

/// A series: equally many x and y.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name in the legend; none where empty.
    pub name: String,
    /// Colour.
    pub ink: Ink,
    /// Shape.
    pub shape: Shape,
    /// Abscissas.
    pub x: Vec<f64>,
    /// Ordinates; what is not finite is a gap.
    pub y: Vec<f64>,
}

impl Series {
    /// A line.
    #[must_use]
    pub fn line(name: impl Into<String>, ink: Ink, x: &[f64], y: &[f64]) -> Self {
        Self { name: name.into(), ink, shape: Shape::Line, x: x.to_vec(), y: y.to_vec() }
    }

    /// In another shape.
    #[must_use]
    pub fn drawn(mut self, shape: Shape) -> Self {
        self.shape = shape;
        self
    }
}

/// A plot.
#[derive(Clone, Debug, Default)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Series, later ones above earlier ones.
    pub series: Vec<Series>,
    /// Marked stretches of the horizontal axis.
    pub windows: Vec<(f64, f64)>,
    /// Values with a horizontal line.
    pub levels: Vec<f64>,
    /// Both axes have one scale.
    pub equal: bool,
    /// The circle of radius 1 about the origin is drawn.
    pub circle: bool,
    /// Over the full width of the page.
    pub wide: bool,
    /// A sentence under it.
    pub note: Option<String>,
}

impl Plot {
    /// An empty plot.
    #[must_use]
    pub fn new(title: impl Into<String>, x: impl Into<String>, y: impl Into<String>) -> Self {
        Self { title: title.into(), x: Axis::new(x), y: Axis::new(y), ..Self::default() }
    }
}
