//! E0306, E0310, E0313: masses that are not negative, times and widths that are positive, saturation with two ends,
//! a direction of gravity that has length one.

use super::{Context, shown};
use crate::diagnostic::Diagnostic;
use crate::rig::{Expr, Span};

/// A value whose sign is checked.
struct Rule<'a> {
    /// Statements that may have it.
    keywords: &'static [&'static str],
    /// Entry or option.
    key: &'static str,
    /// In words.
    what: &'static str,
    /// Zero is fine.
    zero: bool,
    /// With a blank before it.
    unit: &'a str,
    /// Value of the unit in SI.
    factor: f64,
    help: &'static str,
}

const IN: &[&str] = &["input", "actuator"];
const LATE: &str = "a signal cannot arrive before it is sent";
const LAG: Rule = Rule {
    keywords: IN,
    key: "lag",
    what: "time constant",
    zero: false,
    unit: " s",
    factor: 1.0,
    help: "leave `lag` out for an actuator without lag",
};
const DELAY: Rule = Rule { keywords: IN, key: "delay", what: "delay", zero: true, unit: " s", factor: 1.0, help: LATE };
const DEAD_ZONE: Rule = Rule {
    keywords: IN,
    key: "dead_zone",
    what: "dead zone",
    zero: true,
    unit: "",
    factor: 1.0,
    help: "its half width is a positive number",
};
const OUTPUT_DELAY: Rule = Rule { keywords: &["output"], ..DELAY };
const PLAY: Rule = Rule {
    keywords: &["output"],
    key: "play",
    what: "play",
    zero: true,
    unit: "",
    factor: 1.0,
    help: "write its whole width, from one stop to the other",
};
const WIDTH: Rule = Rule {
    keywords: &["friction"],
    key: "width",
    what: "friction's width",
    zero: false,
    unit: "",
    factor: 1.0,
    help: "it is the speed over which Coulomb friction changes its sign, as in `coulomb F_c width 0.01`",
};
const SPEED: Rule = Rule {
    keywords: &["friction"],
    key: "speed",
    what: "Stribeck speed",
    zero: false,
    unit: "",
    factor: 1.0,
    help: "it is the speed over which static friction fades",
};

pub(super) fn check(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    masses(c, diagnostics);
    let mut positive = |rule: Rule<'_>, e: Option<&Expr>, name: &str, otherwise: Span| {
        let Some(x) = e.and_then(|e| c.numbers.value(e)) else { return };
        if x < 0.0 || (x == 0.0 && !rule.zero) {
            let needs = if rule.zero { "cannot be negative" } else { "must be positive" };
            let span = c.entry(rule.keywords, name, rule.key, otherwise);
            let d = Diagnostic::error(
                "E0310",
                format!("the {} of `{name}` {needs}", rule.what),
                span,
                format!("this is {}{}", shown(x / rule.factor), rule.unit),
            );
            diagnostics.push(d.help(rule.help));
        }
    };
    for a in &c.rig.actuators {
        positive(LAG, a.lag.as_ref(), &a.name, a.span);
        positive(DELAY, a.delay.as_ref(), &a.name, a.span);
        positive(DEAD_ZONE, a.dead_zone.as_ref(), &a.name, a.span);
    }
    for o in &c.rig.outputs {
        positive(OUTPUT_DELAY, o.delay.as_ref(), &o.name, o.span);
        let unit = if o.unit.text == "1" { String::new() } else { format!(" {}", o.unit.text) };
        positive(Rule { unit: &unit, factor: o.unit.factor, ..PLAY }, o.play.as_ref(), &o.name, o.span);
    }
    for f in &c.rig.frictions {
        positive(WIDTH, f.width.as_ref(), &f.name, f.span);
        positive(SPEED, f.stribeck.as_ref().map(|(_, speed)| speed), &f.name, f.span);
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
