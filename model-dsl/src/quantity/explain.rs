//! Messages about dimensions: what each factor is, which parameter of the rig would fit, hertz and radians per second.

use super::{Allowed, Checker, MANY, Meaning, in_words};
use crate::ast::{Expr as Ast, ExprKind};
use crate::diagnostic::Diagnostic;
use crate::rig::{BinaryOp, Expr, Symbol};
use crate::units::Dimension;

impl Checker<'_> {
    /// Another dimension was expected: says what each factor is, and which parameter would fit.
    pub(super) fn mismatch(&mut self, ast: &Ast, wanted: Dimension, found: Dimension, what: &str) -> Diagnostic {
        let needs = match wanted {
            Dimension::FORCE => "newtons".to_owned(),
            Dimension::TORQUE => "newton metres".to_owned(),
            Dimension::LENGTH => "metres".to_owned(),
            Dimension::MASS => "kilograms".to_owned(),
            Dimension::TIME => "seconds".to_owned(),
            Dimension::POWER => "watts".to_owned(),
            Dimension::NONE => "a plain number or an angle".to_owned(),
            d if d == Dimension::NONE / Dimension::TIME => "radians per second".to_owned(),
            other => in_words(other),
        };
        let factors = self.factors(ast);
        let label = match &factors {
            Some(list) if list.len() > 1 => {
                format!("{} is {}", list.iter().map(Factor::words).collect::<Vec<_>>().join(""), in_words(found))
            }
            _ => in_words(found),
        };
        if found.equal_but_for_cycles(wanted) {
            return hertz(Diagnostic::error("E0234", format!("{what} needs {needs}, this counts cycles"), ast.span, label));
        }
        let mut d = Diagnostic::error("E0231", format!("{what} needs {needs}, this is {}", in_words(found)), ast.span, label);
        if self.diagnostics.len() > MANY {
            return d;
        }
        if let ExprKind::Name(n, None) = &ast.kind
            && let Some(m) = self.scope.names.get(&n.text)
        {
            d = d.also(m.span, "declared here");
        }
        if let Some((x, name)) = self.unit_or_name(ast) {
            d = d.help(format!("`{x}{name}` is a number with a unit; for {x} times `{name}` of this rig write `{x} * {name}`"));
        }
        for help in self.fitting(&factors.unwrap_or_default(), wanted, found) {
            d = d.help(help);
        }
        d
    }

    /// A number with a unit that is also a name of the rig: `2m` where the mass `m` is meant.
    fn unit_or_name(&self, ast: &Ast) -> Option<(f64, String)> {
        match &ast.kind {
            ExprKind::Number(x, Some(unit)) if self.scope.names.contains_key(&unit.text) => Some((*x, unit.text.clone())),
            ExprKind::Number(..) | ExprKind::Name(..) => None,
            ExprKind::Neg(a) => self.unit_or_name(a),
            ExprKind::Binary(_, a, b) => self.unit_or_name(a).or_else(|| self.unit_or_name(b)),
            ExprKind::Call(_, args) => args.iter().find_map(|a| self.unit_or_name(a)),
        }
    }

    /// The factors of a product that have a dimension; `None` where it is no product of names and numbers.
    fn factors(&mut self, ast: &Ast) -> Option<Vec<Factor>> {
        let mut list = Vec::new();
        let mut open = vec![(ast, false)];
        while let Some((e, below)) = open.pop() {
            match &e.kind {
                ExprKind::Binary(BinaryOp::Mul, a, b) => open.extend([(b.as_ref(), below), (a.as_ref(), below)]),
                ExprKind::Binary(BinaryOp::Div, a, b) => open.extend([(b.as_ref(), !below), (a.as_ref(), below)]),
                ExprKind::Neg(a) => open.push((a, below)),
                _ => {
                    let (mut quiet, mut used) = (Vec::new(), std::collections::BTreeSet::new());
                    let q = Checker { scope: self.scope, sources: self.sources, diagnostics: &mut quiet, used: &mut used }
                        .check(e, Allowed::Everything)?;
                    let dimension = q.dimension?;
                    let (name, parameter) = match &e.kind {
                        ExprKind::Name(n, suffix) => {
                            let dotted = suffix.as_ref().map_or_else(|| n.text.clone(), |s| format!("{}.{}", n.text, s.text));
                            (dotted, matches!(q.expr, Expr::Symbol(Symbol::Parameter(_) | Symbol::Definition(_))))
                        }
                        ExprKind::Number(x, _) => (format!("{x}"), false),
                        ExprKind::Binary(BinaryOp::Pow, base, exponent) => match (&base.kind, &exponent.kind) {
                            (ExprKind::Name(n, None), ExprKind::Number(k, None)) => (format!("{}^{k}", n.text), false),
                            _ => return None,
                        },
                        _ if dimension == Dimension::NONE => continue,
                        _ => return None,
                    };
                    if dimension != Dimension::NONE {
                        let first = list.is_empty();
                        list.push(Factor { name, dimension, below, parameter, first });
                    }
                }
            }
            if list.len() > 6 {
                return None;
            }
        }
        Some(list)
    }

    /// Parameters of the rig that would mend a product: in place of one of its factors, or times all of it.
    fn fitting(&self, factors: &[Factor], wanted: Dimension, found: Dimension) -> Vec<String> {
        let in_use = |name: &str| factors.iter().any(|f| f.name == name);
        let find = |dimension: Dimension| {
            self.scope.order.iter().find_map(|n| {
                let m = self.scope.names.get(n)?;
                let fits = m.dimension == Some(dimension) && matches!(m.symbol, Symbol::Parameter(_) | Symbol::Definition(_)) && !in_use(n);
                fits.then_some((n, m))
            })
        };
        let said = |name: &str, m: &Meaning, dimension: Dimension| {
            let line = self.sources.place(m.span).map_or_else(String::new, |p| format!(", declared on line {}", p.line));
            (format!("`{name}` [{dimension}]"), line, m.doc.clone())
        };
        let mut helps = Vec::new();
        for f in factors.iter().filter(|f| f.parameter) {
            let dimension = if f.below { f.dimension * found / wanted } else { f.dimension * wanted / found };
            if dimension == Dimension::NONE {
                continue;
            }
            if let Some((name, m)) = find(dimension) {
                let (text, line, doc) = said(name, m, dimension);
                helps.push(if doc.is_empty() {
                    format!("{text}{line}, would fit in place of `{}`", f.name)
                } else {
                    format!("the {doc} of this rig is {text}{line}")
                });
            }
        }
        if factors.len() == 1 && !factors[0].parameter && found != Dimension::NONE {
            let dimension = wanted / found;
            if dimension != Dimension::NONE
                && let Some((name, m)) = find(dimension)
            {
                let (text, line, _) = said(name, m, dimension);
                helps.push(format!("times {text}{line}, it would be {}", in_words(wanted)));
            }
        }
        helps.truncate(2);
        helps
    }
}

/// A factor of a product, for messages.
struct Factor {
    name: String,
    dimension: Dimension,
    below: bool,
    parameter: bool,
    first: bool,
}

impl Factor {
    fn words(&self) -> String {
        let joint = match (self.first, self.below) {
            (true, false) => "",
            (true, true) => "1 over ",
            (false, false) => " times ",
            (false, true) => " over ",
        };
        format!("{joint}{} [{}]", self.name, self.dimension)
    }
}

/// A unit to write, in a message.
pub(super) fn unit_text(d: Dimension) -> String {
    let text = d.to_string();
    if text.contains([' ', '/', '^']) { format!("[{}]", text.replace(' ', "*")) } else { text }
}

pub(super) fn hertz(d: Diagnostic) -> Diagnostic {
    d.help("1 Hz is one cycle per second, 2 pi rad/s: write `rad/s`, or multiply by `2 * pi / 1 cycle`")
}
