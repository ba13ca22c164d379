//! SVG elements as text; numbers with two decimals, names escaped.

use std::fmt::Write;

/// A growing drawing.
pub struct Svg {
    width: f64,
    height: f64,
    body: String,
}

/// A number on paper.
fn n(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

impl Svg {
    /// Empty paper [px].
    pub fn new(width: f64, height: f64) -> Self {
        Self { width, height, body: String::new() }
    }

    /// A line with a style of [`Svg::finish`].
    pub fn line(&mut self, class: &str, a: (f64, f64), b: (f64, f64)) {
        let _ = writeln!(self.body, r#"<line class="{class}" x1="{}" y1="{}" x2="{}" y2="{}"/>"#, n(a.0), n(a.1), n(b.0), n(b.1));
    }

    /// A disc or ring.
    pub fn circle(&mut self, class: &str, at: (f64, f64), r: f64) {
        let _ = writeln!(self.body, r#"<circle class="{class}" cx="{}" cy="{}" r="{}"/>"#, n(at.0), n(at.1), n(r));
    }

    /// A filled head of an arrow that points along (dx, dy).
    pub fn head(&mut self, class: &str, tip: (f64, f64), along: (f64, f64), size: f64) {
        let length = along.0.hypot(along.1).max(1e-9);
        let (x, y) = (along.0 / length * size, along.1 / length * size);
        let corner = |side: f64| (tip.0 - x + side * 0.45 * y, tip.1 - y - side * 0.45 * x);
        let (a, b) = (corner(1.0), corner(-1.0));
        let _ = writeln!(
            self.body,
            r#"<polygon class="{class}" points="{},{} {},{} {},{}"/>"#,
            n(tip.0),
            n(tip.1),
            n(a.0),
            n(a.1),
            n(b.0),
            n(b.1)
        );
    }

    /// Text; `anchor` is start, middle or end.
    pub fn text(&mut self, class: &str, anchor: &str, at: (f64, f64), text: &str) {
        let _ =
            writeln!(self.body, r#"<text class="{class}" text-anchor="{anchor}" x="{}" y="{}">{}</text>"#, n(at.0), n(at.1), escaped(text));
    }

    /// The file; `source` is named in its first lines.
    pub fn finish(self, title: &str, source: &str) -> String {
        let (w, h) = (n(self.width), n(self.height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\">\n\
             <!-- Generated from `{}` by `rig draw`. -->\n<title>{}</title>\n<style>\n{STYLE}</style>\n\
             <rect width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>\n{}</svg>\n",
            escaped(source).replace("--", "- -"),
            escaped(title),
            self.body
        )
    }
}

const STYLE: &str = "text { font: 11px sans-serif; fill: #333; }\n\
    .small { font-size: 10px; fill: #777; }\n\
    .massname { fill: #24557f; }\n\
    .jointname { fill: #b4500a; }\n\
    .forcename { fill: #2c7a39; }\n\
    line { stroke-linecap: round; }\n\
    .link { stroke: #555; stroke-width: 3; }\n\
    .reach { stroke: #3b6ea5; stroke-width: 1; stroke-dasharray: 3 3; }\n\
    .rod { stroke: #3b6ea5; stroke-width: 7; opacity: 0.35; }\n\
    .mass { fill: #3b6ea5; fill-opacity: 0.85; stroke: #fff; stroke-width: 1; }\n\
    .axis { stroke: #d2691e; stroke-width: 1.6; }\n\
    .axishead { fill: #d2691e; }\n\
    .ring { fill: #fff; stroke: #d2691e; stroke-width: 1.6; }\n\
    .force { stroke: #3a9a4a; stroke-width: 2; }\n\
    .forcehead { fill: #3a9a4a; }\n\
    .spring { stroke: #8a4fa0; stroke-width: 2; stroke-dasharray: 2 4; }\n\
    .ground { stroke: #999; stroke-width: 1; }\n";
