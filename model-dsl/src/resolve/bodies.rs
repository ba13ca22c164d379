//! Bodies.

use super::Resolver;
use super::terms::hole;
use crate::ast::{BodyEntry, Name, Statement};
use crate::diagnostic::Diagnostic;
use crate::quantity::Allowed;
use crate::rig::*;
use crate::units::Dimension;

impl Resolver<'_> {
    pub(super) fn body(&mut self, s: &Statement, frame: &Name, entries: &[BodyEntry]) {
        let zero = || Expr::Number(0.0);
        let place = self.frame(frame);
        let frame = place.unwrap_or(FrameRef::Ground);
        let mut body = Body {
            name: s.name.text.clone(),
            doc: s.doc.clone(),
            frame,
            mass: zero(),
            center: [zero(), zero(), zero()],
            inertia: std::array::from_fn(|_| zero()),
            about: InertiaPoint::CenterOfMass,
            span: s.name.span,
        };
        let mut seen = Vec::new();
        for e in entries {
            let key = match e {
                BodyEntry::Mass(v) => {
                    body.mass = self.expect(v, Dimension::MASS, "a mass", Allowed::Parameters);
                    "mass"
                }
                BodyEntry::At(v) => {
                    body.center = self.vector(v, Dimension::LENGTH, "a position", Allowed::Parameters);
                    "at"
                }
                BodyEntry::Inertia(v, origin, _) => {
                    body.inertia = std::array::from_fn(|k| {
                        v.get(k).map_or_else(zero, |e| self.expect(e, Dimension::INERTIA, "an inertia", Allowed::Parameters))
                    });
                    if *origin {
                        body.about = InertiaPoint::FrameOrigin;
                    }
                    "inertia"
                }
            };
            if seen.contains(&key) {
                let d = Diagnostic::error("E0115", format!("the body `{}` has `{key}` twice", body.name), s.name.span, "this body");
                self.diagnostics.push(d.help("one `mass`, one `at`, one `inertia`; two bodies may stand on one frame"));
            }
            seen.push(key);
        }
        if !seen.contains(&"mass") && !seen.contains(&"inertia") {
            body.mass = hole();
            let d = Diagnostic::error("E0115", format!("the body `{}` has no mass", body.name), s.name.span, "this body");
            self.diagnostics.push(d.help("write `mass m;` in its block"));
        }
        if place.is_none() {
            // nobody knows what it moves with
            body.mass = hole();
        }
        if let Some(before) = self.rig.bodies.iter().find(|b| b.name == body.name) {
            let d = Diagnostic::error("E0202", format!("the body `{}` is declared twice", body.name), s.name.span, "again here");
            self.diagnostics.push(d.also(before.span, "first here").help("rename one of them"));
        }
        self.rig.bodies.push(body);
    }
}
