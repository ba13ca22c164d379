//! E0306, E0310, E0313: masses that are not negative, times and widths that are positive, saturation with two ends,
//! a direction of gravity that has length one.

use super::{Context, shown};
use crate::diagnostic::Diagnostic;
use crate::rig::{Expr, Span};

pub(super) fn check(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    masses(c, diagnostics);
    let mut positive = |what: String, e: Option<&Expr>, zero: bool, unit: &str, span: Span, help: &str| {
        let Some(x) = e.and_then(|e| c.numbers.value(e)) else { return };
        if x < 0.0 || (x == 0.0 && !zero) {
            let needs = if zero { "cannot be negative" } else { "must be positive" };
            diagnostics.push(Diagnostic::error("E0310", format!("{what} {needs}"), span, format!("this is {}{unit}", shown(x))).help(help));
        }
    };
    for a in &c.rig.actuators {
        let at = |key| c.entry(&["input", "actuator"], &a.name, key, a.span);
        positive(
            format!("the time constant of `{}`", a.name),
            a.lag.as_ref(),
            false,
            " s",
            at("lag"),
            "leave `lag` out for an actuator without lag",
        );
        positive(
            format!("the delay of `{}`", a.name),
            a.delay.as_ref(),
            true,
            " s",
            at("delay"),
            "a signal cannot arrive before it is sent",
        );
        positive(
            format!("the dead zone of `{}`", a.name),
            a.dead_zone.as_ref(),
            true,
            "",
            at("dead_zone"),
            "its half width is a positive number",
        );
    }
    for o in &c.rig.outputs {
        let at = c.entry(&["output"], &o.name, "delay", o.span);
        positive(format!("the delay of `{}`", o.name), o.delay.as_ref(), true, " s", at, "a signal cannot arrive before it is sent");
    }
    for f in &c.rig.frictions {
        let at = |key| c.entry(&["friction"], &f.name, key, f.span);
        positive(
            format!("the width of the friction of `{}`", f.name),
            f.width.as_ref(),
            false,
            "",
            at("width"),
            "the width is the speed over which Coulomb friction changes its sign, as in `coulomb F_c width 0.01`",
        );
        let speed = f.stribeck.as_ref().map(|(_, speed)| speed);
        positive(
            format!("the Stribeck speed of `{}`", f.name),
            speed,
            false,
            "",
            at("speed"),
            "it is the speed over which static friction fades",
        );
    }
    for a in &c.rig.actuators {
        if let Some((lo, hi)) = &a.saturation
            && let (Some(lo), Some(hi)) = (c.numbers.value(lo), c.numbers.value(hi))
            && lo >= hi
        {
            let span = c.entry(&["input", "actuator"], &a.name, "saturate", a.span);
            diagnostics.push(
                Diagnostic::error(
                    "E0310",
                    format!("the saturation of `{}` goes from {} to {}: nothing lies between", a.name, shown(lo), shown(hi)),
                    span,
                    "lower end",
                )
                .help("write `saturate LOWER..UPPER;`"),
            );
        }
    }
    gravity(c, diagnostics);
}

fn masses(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    for b in &c.rig.bodies {
        if let Some(m) = c.numbers.value(&b.mass)
            && m < 0.0
        {
            diagnostics.push(
                Diagnostic::error(
                    "E0306",
                    format!("the mass of `{}` is negative", b.name),
                    c.mass(&b.name, b.span),
                    format!("this is {} kg with these parameters", shown(m)),
                )
                .help("a part that was cut away belongs into the mass and the centre of the body that it was cut from"),
            );
        }
    }
}

fn gravity(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    let Some(gravity) = &c.rig.gravity else { return };
    let Some(direction) = &gravity.direction else { return };
    let Some(n) = direction.iter().map(|e| c.numbers.value(e)).collect::<Option<Vec<f64>>>() else { return };
    let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
    // rounded cosines are fine, forgotten ones are not
    if (length - 1.0).abs() > 1e-3 {
        diagnostics.push(
            Diagnostic::error(
                "E0313",
                "the direction of gravity is not of length one",
                gravity.span,
                format!("its length is {}", shown(length)),
            )
            .help("write a unit vector, as in `gravity g along (sin(tilt), 0, -cos(tilt));`"),
        );
    }
}
