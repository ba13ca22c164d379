//! E0314: what is computed from parameters has a finite value.

use super::Context;
use crate::diagnostic::Diagnostic;
use crate::rig::{Expr, Span};

pub(super) fn check(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    let mut found = |what: &dyn Fn() -> String, e: &Expr, span: &dyn Fn() -> Span| {
        if let Some(x) = c.numbers.value(e)
            && !x.is_finite()
        {
            // what is computed from a name without a value is no second mistake
            let why = c.numbers.blame(e);
            if !why.ends_with("has no finite value") {
                diagnostics.push(
                    Diagnostic::error("E0314", format!("{} has no finite value with these parameters", what()), span(), why)
                        .help("change the parameter's value, or the expression"),
                );
            }
        }
    };
    for d in &c.rig.definitions {
        found(&|| format!("`{}`", d.name), &d.value, &|| c.definition(&d.name, d.span));
    }
    for b in &c.rig.bodies {
        found(&|| format!("the mass of `{}`", b.name), &b.mass, &|| c.mass(&b.name, b.span));
        for e in &b.inertia {
            found(&|| format!("the inertia of `{}`", b.name), e, &|| c.inertia(&b.name, b.span));
        }
        for e in &b.center {
            found(&|| format!("the centre of mass of `{}`", b.name), e, &|| b.span);
        }
    }
}
