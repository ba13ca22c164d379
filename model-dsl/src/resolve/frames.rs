//! Frames: chains of rotations and translations, parents before children.

use super::Resolver;
use super::terms::degree;
use crate::ast::{self, AxisExpr, Kind, Name, Statement};
use crate::diagnostic::{Diagnostic, nearest};
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::{Dimension, Unit};

impl Resolver<'_> {
    pub(super) fn frames(&mut self, statements: &[Statement]) {
        let list: Vec<(&Statement, &Name, &Vec<ast::Step>)> = statements
            .iter()
            .filter_map(|s| match &s.kind {
                Kind::Frame(parent, steps) => Some((s, parent, steps)),
                _ => None,
            })
            .collect();
        let names: Vec<String> = list.iter().map(|(s, _, _)| s.name.text.clone()).collect();
        for (k, (s, _, _)) in list.iter().enumerate() {
            if let Some(before) = names[..k].iter().position(|n| *n == s.name.text) {
                self.diagnostics.push(
                    Diagnostic::error("E0202", format!("the frame `{}` is declared twice", s.name.text), s.name.span, "again here")
                        .also(list[before].0.name.span, "first here"),
                );
            }
            if s.name.text == "ground" {
                self.diagnostics.push(Diagnostic::error(
                    "E0202",
                    "`ground` is the frame that does not move",
                    s.name.span,
                    "choose another name",
                ));
            }
        }
        let mut placed: Vec<String> = Vec::new();
        let mut waiting: Vec<usize> = (0..list.len()).collect();
        loop {
            let before = waiting.len();
            waiting.retain(|&k| {
                let (s, parent, steps) = list[k];
                let parent_ref = if parent.text == "ground" {
                    FrameRef::Ground
                } else if let Some(p) = placed.iter().position(|n| *n == parent.text) {
                    FrameRef::Frame(p)
                } else {
                    return true;
                };
                let steps = steps.iter().map(|step| self.step(step)).collect();
                self.rig.frames.push(Frame { name: s.name.text.clone(), doc: s.doc.clone(), parent: parent_ref, steps, span: s.name.span });
                placed.push(s.name.text.clone());
                false
            });
            if waiting.len() == before {
                break;
            }
        }
        for &k in &waiting {
            let (s, parent, _) = list[k];
            if names.contains(&parent.text) {
                let circle = in_circle(k, &list, &names);
                if circle {
                    self.diagnostics.push(
                        Diagnostic::error(
                            "E0301",
                            format!("the frame `{}` stands on itself", s.name.text),
                            parent.span,
                            "its chain comes back here",
                        )
                        .help("every chain of frames starts at `ground`"),
                    );
                }
            } else {
                let near = nearest(&parent.text, names.iter().map(String::as_str).chain(["ground"]));
                let mut d = Diagnostic::error("E0201", format!("there is no frame `{}`", parent.text), parent.span, "unknown frame");
                d = match near {
                    Some(near) => d.help(format!("did you mean `{near}`?")),
                    None => d.help("every chain of frames starts at `ground`"),
                };
                self.diagnostics.push(d);
            }
            // keep the name, so that bodies on it are no second error
            self.rig.frames.push(Frame {
                name: s.name.text.clone(),
                doc: String::new(),
                parent: FrameRef::Ground,
                steps: Vec::new(),
                span: s.name.span,
            });
        }
    }

    pub(super) fn step(&mut self, step: &ast::Step) -> Step {
        match step {
            ast::Step::Rotate(axis, angle, _) => {
                let axis = match axis {
                    AxisExpr::Principal(index, negative) => Axis::Principal { index: *index, negative: *negative },
                    AxisExpr::Vector(v) => self.axis_vector(v),
                };
                let checked = self.expect(angle, Dimension::NONE, "a rotation", Allowed::Configuration);
                self.affine(&checked, angle.span, "angle");
                Step::Rotate { axis, angle: checked }
            }
            ast::Step::Translate(components, span) => {
                let v = (components.clone(), *span);
                let checked = self.vector(&v, Dimension::LENGTH, "a translation", Allowed::Configuration);
                for (value, ast) in checked.iter().zip(components) {
                    self.affine(value, ast.span, "offset");
                }
                Step::Translate(checked)
            }
        }
    }

    pub(super) fn affine(&mut self, expr: &Expr, span: Span, what: &str) {
        if degree(expr).is_none_or(|d| d > 1) {
            self.diagnostics.push(
                Diagnostic::error(
                    "E0302",
                    format!("this {what} is not affine in the coordinates"),
                    span,
                    "products or functions of coordinates",
                )
                .help("a joint moves by a sum of coordinates times parameters, as in `q1 - 2 * q2 + 30deg`"),
            );
        }
    }

    pub(super) fn axis_vector(&mut self, v: &ast::Vector) -> Axis {
        let mut n = [0.0; 3];
        for (k, slot) in n.iter_mut().enumerate() {
            if let Some(e) = v.0.get(k) {
                *slot = self.constant(e, &Unit::none(), "a component of an axis").unwrap_or(0.0);
            }
        }
        let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
        if v.0.len() != 3 || length <= 0.0 || !length.is_finite() {
            self.diagnostics.push(Diagnostic::error("E0313", "an axis is a vector of three numbers, not all zero", v.1, "this axis"));
            return Axis::Principal { index: 2, negative: false };
        }
        let unit = n.map(|x| x / length);
        for (index, &x) in unit.iter().enumerate() {
            if x.abs() == 1.0 {
                return Axis::Principal { index, negative: x < 0.0 };
            }
        }
        Axis::Vector(unit)
    }

    pub(super) fn frame(&mut self, name: &Name) -> FrameRef {
        if name.text == "ground" {
            return FrameRef::Ground;
        }
        if let Some(i) = self.rig.frames.iter().position(|f| f.name == name.text) {
            return FrameRef::Frame(i);
        }
        if let Some(body) = self.rig.bodies.iter().find(|b| b.name == name.text) {
            return body.frame;
        }
        let names: Vec<&str> = self.rig.frames.iter().map(|f| f.name.as_str()).chain(["ground"]).collect();
        let mut d = Diagnostic::error("E0201", format!("there is no frame `{}`", name.text), name.span, "unknown frame");
        d = match nearest(&name.text, names.iter().copied()) {
            Some(near) => d.help(format!("did you mean `{near}`?")),
            None => d.help(format!("frames are {}", names.join(", "))),
        };
        self.diagnostics.push(d);
        FrameRef::Ground
    }
}

/// Whether following parents from frame k comes back to k.
pub(super) fn in_circle(k: usize, list: &[(&Statement, &Name, &Vec<ast::Step>)], names: &[String]) -> bool {
    let mut at = k;
    for _ in 0..=list.len() {
        let Some(next) = names.iter().position(|n| *n == list[at].1.text) else { return false };
        if next == k {
            return true;
        }
        at = next;
    }
    false
}
