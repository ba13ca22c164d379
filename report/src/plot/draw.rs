//! A plot as SVG inside a figure; its legend is text of the page, so that it breaks into lines on a narrow screen.

use super::axis::{Scale, horizontal, vertical};
use super::thin::thin;
use super::{Plot, Series, Shape};
use maud::{Markup, html};
use std::fmt::Write;

/// Sizes of a plot [px].
struct Frame {
    width: f64,
    height: f64,
    left: f64,
    top: f64,
    inner: (f64, f64),
}

const RIGHT: f64 = 12.0;
const BOTTOM: f64 = 36.0;

pub(crate) fn figure(plot: &Plot) -> Markup {
    let (width, height) = match (plot.wide, plot.equal) {
        (true, _) => (860.0, 230.0),
        (false, true) => (420.0, 320.0),
        (false, false) => (420.0, 240.0),
    };
    let (left, top) = (62.0, 8.0);
    let frame = Frame { width, height, left, top, inner: (width - left - RIGHT, height - top - BOTTOM) };
    let scales = horizontal(plot).zip(vertical(plot));
    let (drawn, cut) = match scales {
        Some((x, y)) => {
            let (x, y) = if plot.equal { equal(x, y, &frame) } else { (x, y) };
            draw(plot, &frame, x, y)
        }
        None => (html! { p.empty { "no values" } }, false),
    };
    html! {
        figure class=[plot.wide.then_some("wide")] {
            figcaption {
                @if !plot.title.is_empty() { strong { (plot.title) } }
                @for series in plot.series.iter().filter(|s| !s.name.is_empty()) {
                    " " span class={ "key " (series.ink.class()) " " (key(&series.shape)) } { (series.name) }
                }
            }
            div.scroll { (drawn) }
            @if cut { p.note { "Values beyond the frame are cut." } }
            @if let Some(note) = &plot.note { p.note { (note) } }
        }
    }
}

fn key(shape: &Shape) -> &'static str {
    match shape {
        Shape::Line | Shape::Steps | Shape::Stems => "k-line",
        Shape::Dashed => "k-dashed",
        Shape::Dots => "k-dot",
        Shape::Rings => "k-ring",
        Shape::Crosses => "k-cross",
        Shape::Band(_) => "k-band",
    }
}

/// The scale that is too fine is widened until both are equal.
fn equal(x: Scale, y: Scale, frame: &Frame) -> (Scale, Scale) {
    let per_pixel = |s: &Scale, pixels: f64| (s.to - s.from) / pixels;
    let unit = per_pixel(&x, frame.inner.0).max(per_pixel(&y, frame.inner.1));
    let widened = |s: Scale, pixels: f64| {
        let (middle, half) = (0.5 * s.from + 0.5 * s.to, 0.5 * unit * pixels);
        Scale { from: middle - half, to: middle + half, log: false }
    };
    (widened(x, frame.inner.0), widened(y, frame.inner.1))
}

/// Places far outside need not be exact, but must be numbers.
const FAR: f64 = 20_000.0;

struct Places<'a> {
    frame: &'a Frame,
    x: Scale,
    y: Scale,
}

impl Places<'_> {
    fn x(&self, v: f64) -> f64 {
        (self.x.place(v) * self.frame.inner.0).clamp(-FAR, FAR)
    }

    fn y(&self, v: f64) -> f64 {
        ((1.0 - self.y.place(v)) * self.frame.inner.1).clamp(-FAR, FAR)
    }

    fn outside(&self, v: f64) -> bool {
        v.is_finite() && !(-0.001..=1.001).contains(&self.y.place(v))
    }
}

fn one(v: f64) -> String {
    let text = format!("{v:.1}");
    if text == "-0.0" { "0.0".to_owned() } else { text }
}

fn draw(plot: &Plot, frame: &Frame, x: Scale, y: Scale) -> (Markup, bool) {
    let places = Places { frame, x, y };
    let cut = plot.series.iter().any(|s| s.y.iter().any(|v| places.outside(*v)));
    let (w, h) = frame.inner;
    let (x_ticks, y_ticks) = (x.ticks((w / 80.0) as usize), y.ticks((h / 38.0) as usize));
    let drawn = html! {
        svg.plot viewBox=(format!("0 0 {} {}", frame.width, frame.height)) role="img" aria-label=(plot.title) {
            @for (value, label) in &x_ticks {
                @let at = frame.left + places.x(*value);
                line.grid x1=(one(at)) y1=(one(frame.top)) x2=(one(at)) y2=(one(frame.top + h)) {}
                text x=(one(at)) y=(one(frame.top + h + 14.0)) text-anchor="middle" { (label) }
            }
            @for (value, label) in &y_ticks {
                @let at = frame.top + places.y(*value);
                line.grid x1=(one(frame.left)) y1=(one(at)) x2=(one(frame.left + w)) y2=(one(at)) {}
                text x=(one(frame.left - 5.0)) y=(one(at + 3.5)) text-anchor="end" { (label) }
            }
            text.label x=(one(frame.left + 0.5 * w)) y=(one(frame.height - 6.0)) text-anchor="middle" { (plot.x.label) }
            text.label transform=(format!("translate(11 {}) rotate(-90)", one(frame.top + 0.5 * h))) text-anchor="middle" { (plot.y.label) }
            svg x=(one(frame.left)) y=(one(frame.top)) width=(one(w)) height=(one(h)) {
                @for (from, to) in &plot.windows {
                    @let (a, b) = (places.x(*from), places.x(*to));
                    rect.window x=(one(a)) y="0" width=(one((b - a).max(1.0))) height=(one(h)) {}
                }
                @if plot.circle {
                    circle.circle cx=(one(places.x(0.0))) cy=(one(places.y(0.0))) r=(one(places.x(1.0) - places.x(0.0))) {}
                }
                @for level in &plot.levels {
                    line.level x1="0" y1=(one(places.y(*level))) x2=(one(w)) y2=(one(places.y(*level))) {}
                }
                @for series in &plot.series { (shape(series, &places)) }
            }
            rect.frame x=(one(frame.left)) y=(one(frame.top)) width=(one(w)) height=(one(h)) {}
        }
    };
    (drawn, cut)
}

fn shape(series: &Series, places: &Places<'_>) -> Markup {
    let columns = places.frame.inner.0 as usize;
    let range = (places.x.from, places.x.to);
    let class = series.ink.class();
    let points = || thin(&series.x, &series.y, columns, range);
    match &series.shape {
        Shape::Line => html! { path class={ "l " (class) } d=(path(&points(), places, false)) {} },
        Shape::Dashed => html! { path class={ "l dashed " (class) } d=(path(&points(), places, false)) {} },
        Shape::Steps => html! { path class={ "l " (class) } d=(path(&points(), places, true)) {} },
        Shape::Band(other) => {
            let (lower, upper) = (points(), thin(&series.x, other, columns, range));
            html! { path class={ "band " (class) } d=(band(&lower, &upper, places)) {} }
        }
        Shape::Stems => {
            let mut d = String::new();
            for (x, y) in series.x.iter().zip(&series.y).filter(|(x, y)| x.is_finite() && y.is_finite()) {
                let _ = write!(d, "M{} {}V{}", one(places.x(*x)), one(places.y(0.0)), one(places.y(*y)));
            }
            html! { path class={ "stem " (class) } d=(d) {} }
        }
        Shape::Dots => html! { path class={ "dots " (class) } d=(marks(series, places, "h0")) {} },
        Shape::Crosses => html! { path class={ "marks " (class) } d=(marks(series, places, "m-4 -4l8 8m0 -8l-8 8")) {} },
        Shape::Rings => html! { path class={ "marks " (class) } d=(marks(series, places, "m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0")) {} },
    }
}

fn path(points: &[super::thin::Point], places: &Places<'_>, steps: bool) -> String {
    let mut d = String::new();
    let mut down = false;
    let mut last = String::new();
    for point in points {
        let Some((x, y)) = point else {
            down = false;
            continue;
        };
        let (x, y) = (one(places.x(*x)), one(places.y(*y)));
        if !down {
            let _ = write!(d, "M{x} {y}");
        } else if steps {
            let _ = write!(d, "H{x}V{y}");
        } else if last != format!("{x} {y}") {
            let _ = write!(d, "L{x} {y}");
        }
        last = format!("{x} {y}");
        down = true;
    }
    d
}

/// The area between two thinned series. Each has its own points; its outline goes along one and back along the other, so gaps are
/// closed over.
fn band(lower: &[super::thin::Point], upper: &[super::thin::Point], places: &Places<'_>) -> String {
    let outline: Vec<(f64, f64)> = lower.iter().flatten().copied().chain(upper.iter().rev().flatten().copied()).collect();
    let mut d = String::new();
    for (k, (x, y)) in outline.iter().enumerate() {
        let _ = write!(d, "{}{} {}", if k == 0 { "M" } else { "L" }, one(places.x(*x)), one(places.y(*y)));
    }
    if !d.is_empty() {
        d.push('Z');
    }
    d
}

/// A mark at each point; where many fall on one place of two pixels, one.
fn marks(series: &Series, places: &Places<'_>, mark: &str) -> String {
    let mut seen = std::collections::BTreeSet::new();
    let mut d = String::new();
    for (x, y) in series.x.iter().zip(&series.y).filter(|(x, y)| x.is_finite() && y.is_finite()) {
        let (x, y) = (places.x(*x), places.y(*y));
        if seen.insert(((x / 2.0).round() as i64, (y / 2.0).round() as i64)) {
            let _ = write!(d, "M{} {}{mark}", one(x), one(y));
        }
    }
    d
}
