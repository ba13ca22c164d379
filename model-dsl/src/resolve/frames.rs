//! Frames: chains of rotations and translations, parents before children.

use super::RESERVED;
use super::Resolver;
use super::order::Order;
use super::terms::{degree, hole};
use crate::ast::{self, AxisExpr, Kind, Name, Statement};
use crate::diagnostic::Diagnostic;
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::{Dimension, Unit};
use std::collections::{BTreeSet, HashMap};

impl Resolver<'_> {
    pub(super) fn frames(&mut self, statements: &[Statement]) {
        let list: Vec<(&Statement, &Name, &Vec<ast::Step>)> = statements
            .iter()
            .filter_map(|s| if let Kind::Frame(parent, steps) = &s.kind { Some((s, parent, steps)) } else { None })
            .collect();
        let mut first: HashMap<&str, usize> = HashMap::new();
        for (k, (s, _, _)) in list.iter().enumerate() {
            if RESERVED.contains(&s.name.text.as_str()) {
                let what = if s.name.text == "ground" { "is the frame that does not move" } else { "is a word of the language" };
                self.diagnostics.push(Diagnostic::error("E0202", format!("`{}` {what}", s.name.text), s.name.span, "choose another name"));
            }
            if let Some(before) = first.get(s.name.text.as_str()) {
                let d = Diagnostic::error("E0202", format!("the frame `{}` is declared twice", s.name.text), s.name.span, "again here");
                self.diagnostics.push(d.also(list[*before].0.name.span, "first here").help("rename one of them"));
            } else {
                first.insert(&s.name.text, k);
            }
        }
        let needs: Vec<Vec<usize>> =
            list.iter().map(|(_, parent, _)| first.get(parent.text.as_str()).copied().into_iter().collect()).collect();
        let order = Order::of(&needs);
        for circle in &order.circles {
            let (s, parent, _) = list[circle[0]];
            let mut d = Diagnostic::error(
                "E0301",
                format!("the frame `{}` stands on itself", s.name.text),
                parent.span,
                "its chain comes back to it",
            );
            for &k in &circle[1..] {
                d = d.also(list[k].1.span, format!("by way of `{}`", list[k].0.name.text));
            }
            self.diagnostics.push(d.help("every chain of frames starts at `ground`"));
        }
        let stuck: BTreeSet<usize> = order.stuck.iter().copied().collect();
        let mut place: HashMap<&str, usize> = HashMap::new();
        for &k in &order.order {
            let (s, parent, steps) = list[k];
            let mut known = !stuck.contains(&k);
            let parent_ref = match place.get(parent.text.as_str()) {
                Some(&p) => FrameRef::Frame(p),
                None => {
                    if parent.text != "ground" && known {
                        known = false;
                        let names: Vec<String> = list.iter().map(|(s, _, _)| s.name.text.clone()).chain(["ground".to_owned()]).collect();
                        self.unknown("frame", parent, "every chain of frames starts at `ground`", &names, "E0201");
                    }
                    FrameRef::Ground
                }
            };
            let mut steps: Vec<Step> = steps.iter().map(|step| self.step(step)).collect();
            if !known {
                // nobody knows where it is: checks of mechanics pass over what stands on it
                steps.push(Step::Translate([hole(), hole(), hole()]));
            }
            if first.get(s.name.text.as_str()) == Some(&k) {
                place.insert(&s.name.text, self.rig.frames.len());
            }
            self.rig.frames.push(Frame { name: s.name.text.clone(), doc: s.doc.clone(), parent: parent_ref, steps, span: s.name.span });
        }
    }

    pub(super) fn step(&mut self, step: &ast::Step) -> Step {
        match step {
            ast::Step::Rotate(axis, angle) => {
                let axis = match axis {
                    AxisExpr::Principal(index, negative) => Axis::Principal { index: *index, negative: *negative },
                    AxisExpr::Vector(v) => self.axis_vector(v),
                };
                let checked = self.expect(angle, Dimension::NONE, "a rotation", Allowed::Configuration);
                self.affine(&checked, angle.span, "angle");
                self.many_turns(angle, &checked);
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
                *slot = self.constant(e, &Unit::none(), "a component of an axis").unwrap_or(f64::NAN);
            }
        }
        let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
        if v.0.len() == 3 && length.is_nan() {
            return Axis::Vector([f64::NAN; 3]);
        }
        if v.0.len() != 3 || length <= 0.0 || !length.is_finite() {
            let d = Diagnostic::error("E0313", "an axis is a vector of three numbers, not all zero", v.1, "this axis");
            self.diagnostics.push(d.help("write (a, b, c); its length does not matter"));
            return Axis::Vector([f64::NAN; 3]);
        }
        let unit = n.map(|x| x / length);
        for (index, &x) in unit.iter().enumerate() {
            if x.abs() == 1.0 {
                return Axis::Principal { index, negative: x < 0.0 };
            }
        }
        Axis::Vector(unit)
    }

    /// The frame of this name, or that of the body of this name; `None` with an error where there is none.
    pub(super) fn frame(&mut self, name: &Name) -> Option<FrameRef> {
        if name.text == "ground" {
            return Some(FrameRef::Ground);
        }
        if let Some(i) = self.rig.frames.iter().position(|f| f.name == name.text) {
            return Some(FrameRef::Frame(i));
        }
        if let Some(body) = self.rig.bodies.iter().find(|b| b.name == name.text) {
            return Some(body.frame);
        }
        let names: Vec<String> = self.rig.frames.iter().map(|f| f.name.clone()).chain(["ground".to_owned()]).collect();
        let all = format!("frames are {}", names.join(", "));
        self.unknown("frame", name, &all, &names, "E0201");
        None
    }
}
