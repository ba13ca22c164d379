//! Expressions: names to symbols, units to SI, dimensions checked.

mod explain;

use crate::ast::{Expr as Ast, ExprKind, Name, UnitExpr};
use crate::diagnostic::{Diagnostic, nearest};
use crate::rig::{BinaryOp, Expr, Function, Span, Symbol};
use crate::source::Sources;
use crate::units::{self, Dimension, Unit};
use explain::{hertz, unit_text};
use std::collections::HashMap;

/// After so many findings, suggestions are left out: they cost time, and nobody reads that far.
const MANY: usize = 20;

/// What a name means.
#[derive(Clone, Debug)]
pub struct Meaning {
    /// Symbol.
    pub symbol: Symbol,
    /// Dimension; `None` while it cannot be known because of an error elsewhere.
    pub dimension: Option<Dimension>,
    /// Where it was declared.
    pub span: Span,
    /// In words: `a parameter`.
    pub what: &'static str,
    /// First words of its comment.
    pub doc: String,
}

/// Names that expressions may use.
#[derive(Default)]
pub struct Scope {
    /// By name.
    pub names: HashMap<String, Meaning>,
    /// In order of declaration, for suggestions.
    pub order: Vec<String>,
    /// Names of statements that could not be read: uses of them are no second error.
    pub lost: std::collections::BTreeSet<String>,
    /// Names that a variant removed, and where.
    pub removed: std::collections::BTreeMap<String, Span>,
}

/// A checked expression and its dimension; `None` for a zero or a number whose dimension the place decides.
pub struct Quantity {
    /// Checked.
    pub expr: Expr,
    /// Dimension.
    pub dimension: Option<Dimension>,
    /// A bare number (with or without minus): takes the dimension of its place.
    bare: bool,
}

/// Groups of symbols that a place allows.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Allowed {
    /// Numbers only.
    Numbers,
    /// Parameters and definitions.
    Parameters,
    /// Parameters and time.
    Trajectory,
    /// Parameters and coordinates.
    Configuration,
    /// Parameters, coordinates, rates.
    Motion,
    /// Parameters, coordinates, rates, inputs, time.
    Everything,
    /// The left-hand side of an equation.
    Accelerations,
    /// Inputs only.
    Inputs,
}

impl Allowed {
    fn accepts(self, symbol: Symbol) -> bool {
        use Symbol as S;
        match symbol {
            S::Parameter(_) | S::Definition(_) => self != Self::Numbers,
            S::Time => matches!(self, Self::Trajectory | Self::Everything),
            S::Coordinate(_) => matches!(self, Self::Configuration | Self::Motion | Self::Everything | Self::Accelerations),
            S::Rate(_) => matches!(self, Self::Motion | Self::Everything),
            S::Input(_) => matches!(self, Self::Everything | Self::Inputs),
            S::Actuator(_) | S::Mixed(..) => self == Self::Everything,
            S::Acceleration(_) => self == Self::Accelerations,
        }
    }

    fn words(self) -> &'static str {
        match self {
            Self::Numbers => "a number",
            Self::Parameters => "parameters and numbers only",
            Self::Trajectory => "parameters and time only",
            Self::Configuration => "parameters and coordinates only",
            Self::Motion => "parameters, coordinates and rates only",
            Self::Everything => "no accelerations",
            Self::Accelerations => "accelerations times parameters and coordinates only",
            Self::Inputs => "inputs and numbers only",
        }
    }
}

/// Checks expressions against a scope.
pub struct Checker<'a> {
    /// Names.
    pub scope: &'a Scope,
    /// Texts, for lines in messages.
    pub sources: &'a Sources,
    /// Findings.
    pub diagnostics: &'a mut Vec<Diagnostic>,
    /// Symbols that were used.
    pub used: &'a mut std::collections::BTreeSet<Symbol>,
}

impl Checker<'_> {
    /// An expression in a place that wants a dimension. `what` says what the place is: `a force`.
    pub fn expect(&mut self, ast: &Ast, wanted: Dimension, what: &str, allowed: Allowed) -> Option<Expr> {
        let quantity = self.check(ast, allowed)?;
        match quantity.dimension {
            _ if quantity.bare => {}
            None => {}
            Some(found) if found == wanted => {}
            Some(found) => {
                let d = self.mismatch(ast, wanted, found, what);
                self.diagnostics.push(d);
                return None;
            }
        }
        Some(quantity.expr)
    }

    /// An expression and its dimension.
    pub fn check(&mut self, ast: &Ast, allowed: Allowed) -> Option<Quantity> {
        match &ast.kind {
            ExprKind::Number(x, None) => {
                // a bare zero fits any dimension
                let dimension = if *x == 0.0 { None } else { Some(Dimension::NONE) };
                Some(Quantity { expr: Expr::Number(*x), dimension, bare: true })
            }
            ExprKind::Number(x, Some(unit)) => {
                let unit = self.unit(unit)?;
                let value = x * unit.factor;
                if !value.is_finite() {
                    self.diagnostics.push(Diagnostic::error("E0102", "this number is too large in SI", ast.span, "overflows to infinity"));
                    return None;
                }
                Some(Quantity { expr: Expr::Number(value), dimension: Some(unit.dimension), bare: false })
            }
            ExprKind::Name(name, suffix) => self.name(name, suffix.as_ref(), ast.span, allowed),
            ExprKind::Neg(a) => {
                let a = self.check(a, allowed)?;
                let expr = match a.expr {
                    Expr::Number(x) => Expr::Number(-x),
                    other => Expr::Neg(Box::new(other)),
                };
                Some(Quantity { expr, ..a })
            }
            ExprKind::Binary(op, a, b) => self.binary(*op, a, b, ast.span, allowed),
            ExprKind::Call(name, args) => self.call(name, args, ast.span, allowed),
        }
    }

    fn name(&mut self, name: &Name, suffix: Option<&Name>, span: Span, allowed: Allowed) -> Option<Quantity> {
        if name.text == "pi" && suffix.is_none() && !self.scope.names.contains_key("pi") {
            return Some(Quantity { expr: Expr::Number(std::f64::consts::PI), dimension: Some(Dimension::NONE), bare: false });
        }
        if name.text == "t" && suffix.is_none() && !self.scope.names.contains_key("t") {
            return self.allowed(Symbol::Time, span, "time", allowed).then_some(Quantity {
                expr: Expr::Symbol(Symbol::Time),
                dimension: Some(Dimension::TIME),
                bare: false,
            });
        }
        let Some(meaning) = self.scope.names.get(&name.text) else {
            if self.scope.lost.contains(&name.text) {
                return None;
            }
            let mut d = Diagnostic::error("E0201", format!("there is no `{}` in this rig", name.text), name.span, "unknown name");
            let near = if self.diagnostics.len() > MANY { None } else { nearest(&name.text, self.scope.order.iter().map(String::as_str)) };
            if let Some(place) = self.scope.removed.get(&name.text) {
                self.diagnostics.push(d.also(*place, "removed here").help("replace or remove what uses it, too"));
                return None;
            }
            d = match near {
                _ if Unit::named(&name.text).is_some() => d
                    .help("a unit stands right behind its number, a compound one in brackets: `20 mm`, `0.1 [m/s]`")
                    .help(format!("for a parameter of this name, declare it: `param {}: UNIT = VALUE;`", name.text)),
                Some(near) => d.help(format!("did you mean `{near}`?")),
                None => d.help(format!("declare it, for example `param {}: UNIT = VALUE;`", name.text)),
            };
            self.diagnostics.push(d);
            return None;
        };
        let mut symbol = meaning.symbol;
        let mut dimension = meaning.dimension;
        let mut what = meaning.what;
        if let Some(suffix) = suffix {
            let order = match suffix.text.as_str() {
                "dot" => 1,
                "ddot" => 2,
                _ => {
                    self.diagnostics.push(
                        Diagnostic::error("E0201", format!("`.{}` means nothing", suffix.text), suffix.span, "expected `dot` or `ddot`")
                            .help("`eps.dot` is the rate of eps, `eps.ddot` its acceleration"),
                    );
                    return None;
                }
            };
            let Symbol::Coordinate(i) = symbol else {
                self.diagnostics.push(
                    Diagnostic::error(
                        "E0206",
                        format!("`{}` is {}: only coordinates have rates", name.text, meaning.what),
                        span,
                        "not a coordinate",
                    )
                    .also(meaning.span, "declared here"),
                );
                return None;
            };
            symbol = if order == 1 { Symbol::Rate(i) } else { Symbol::Acceleration(i) };
            what = if order == 1 { "a rate" } else { "an acceleration" };
            dimension = dimension.map(|d| d / Dimension::TIME.powi(order));
        }
        self.used.insert(symbol);
        if !self.allowed(symbol, span, what, allowed) {
            return None;
        }
        let dimension = dimension?;
        Some(Quantity { expr: Expr::Symbol(symbol), dimension: Some(dimension), bare: false })
    }

    fn allowed(&mut self, symbol: Symbol, span: Span, what: &str, allowed: Allowed) -> bool {
        let ok = allowed.accepts(symbol);
        if !ok {
            let d = Diagnostic::error("E0206", format!("{what} cannot stand here"), span, format!("this place takes {}", allowed.words()));
            self.diagnostics.push(match allowed {
                Allowed::Accelerations => d.help("on the left stand accelerations, as in `I * eps.ddot = ..`; all else goes to the right"),
                Allowed::Configuration if matches!(symbol, Symbol::Rate(_)) => {
                    d.help("what depends on rates is friction, a torque or a dissipation function")
                }
                _ => d,
            });
        }
        ok
    }

    fn binary(&mut self, op: BinaryOp, a: &Ast, b: &Ast, span: Span, allowed: Allowed) -> Option<Quantity> {
        if op == BinaryOp::Pow {
            return self.power(a, b, span, allowed);
        }
        let (left, right) = (self.check(a, allowed), self.check(b, allowed));
        let (left, right) = (left?, right?);
        let dimension = match op {
            BinaryOp::Mul => left.dimension.zip(right.dimension).map(|(x, y)| x * y),
            BinaryOp::Div => left.dimension.zip(right.dimension).map(|(x, y)| x / y),
            _ => {
                if let (Some(x), Some(y)) = (left.dimension, right.dimension)
                    && x != y
                {
                    let verb = if op == BinaryOp::Add { "added to" } else { "subtracted from" };
                    let (what, other) = if op == BinaryOp::Add { (x, y) } else { (y, x) };
                    let message = format!("{} cannot be {verb} {}", in_words(what), in_words(other));
                    let mut d = Diagnostic::error("E0232", message, b.span, in_words(y)).also(a.span, in_words(x));
                    d = if x.equal_but_for_cycles(y) { hertz(d) } else { d };
                    for (side, other) in [(a, y), (b, x)] {
                        if is_bare(side)
                            && let ExprKind::Number(n, None) = side.kind
                        {
                            d = d.help(format!("give the number a unit, as in `{n} {}`", unit_text(other)));
                        }
                    }
                    self.diagnostics.push(d);
                    return None;
                }
                left.dimension.or(right.dimension)
            }
        };
        let bare = left.bare && right.bare;
        let right_value = if let Expr::Number(y) = right.expr { Some(y) } else { None };
        let expr = match (&left.expr, &right.expr) {
            (Expr::Number(x), Expr::Number(y)) => Expr::Number(match op {
                BinaryOp::Add => x + y,
                BinaryOp::Sub => x - y,
                BinaryOp::Mul => x * y,
                _ => x / y,
            }),
            _ => Expr::Binary(op, Box::new(left.expr), Box::new(right.expr)),
        };
        let zero = op == BinaryOp::Div && right_value == Some(0.0);
        self.finite(&expr, span, if zero { "divides by zero" } else { "overflows to infinity" })?;
        Some(Quantity { expr, dimension, bare })
    }

    fn finite(&mut self, expr: &Expr, span: Span, why: &str) -> Option<()> {
        match expr {
            Expr::Number(x) if !x.is_finite() => {
                self.diagnostics.push(Diagnostic::error("E0102", "this has no finite value", span, why));
                None
            }
            _ => Some(()),
        }
    }

    fn power(&mut self, a: &Ast, b: &Ast, span: Span, allowed: Allowed) -> Option<Quantity> {
        let (base, exponent) = (self.check(a, allowed), self.check(b, allowed));
        let (base, exponent) = (base?, exponent?);
        if exponent.dimension.is_some_and(|d| d != Dimension::NONE) {
            self.diagnostics.push(Diagnostic::error(
                "E0233",
                "an exponent is a plain number",
                b.span,
                in_words(exponent.dimension.unwrap_or_default()),
            ));
            return None;
        }
        let dimension = match (base.dimension, &exponent.expr) {
            (None, _) => None,
            (Some(d), Expr::Number(n)) if n.fract() == 0.0 && n.abs() <= 64.0 => Some(d.powi(*n as i16)),
            (Some(d), _) if d == Dimension::NONE => Some(d),
            (Some(d), _) => {
                self.diagnostics.push(
                    Diagnostic::error("E0233", "a power that is no whole number needs a base without dimension", a.span, in_words(d))
                        .help("divide by a unit first: `(V / 1 V)^2.072`"),
                );
                return None;
            }
        };
        let bare = base.bare && exponent.bare;
        let expr = match (&base.expr, &exponent.expr) {
            (Expr::Number(x), Expr::Number(n)) => Expr::Number(x.powf(*n)),
            _ => Expr::Binary(BinaryOp::Pow, Box::new(base.expr), Box::new(exponent.expr)),
        };
        self.finite(&expr, span, "overflows to infinity")?;
        Some(Quantity { expr, dimension, bare })
    }

    fn call(&mut self, name: &Name, args: &[Ast], span: Span, allowed: Allowed) -> Option<Quantity> {
        let Some((_, function, arity)) = FUNCTIONS.iter().find(|(n, _, _)| *n == name.text) else {
            let mut d = Diagnostic::error("E0201", format!("there is no function `{}`", name.text), name.span, "unknown function");
            let other = match name.text.to_lowercase().as_str() {
                "sgn" | "signum" => Some("sign"),
                "arctan" | "atn" => Some("atan"),
                "arcsin" => Some("asin"),
                "arccos" => Some("acos"),
                "log" => Some("ln"),
                "tg" => Some("tan"),
                "sat" | "clip" | "clamp" => Some("saturate"),
                "fabs" => Some("abs"),
                "pow" => Some("x^y"),
                _ => None,
            };
            d = match other.or_else(|| nearest(&name.text, FUNCTIONS.iter().map(|(n, _, _)| *n))) {
                Some(near) => d.help(format!("did you mean `{near}`?")),
                None => d.help(format!("functions are {}", FUNCTIONS.iter().map(|(n, _, _)| *n).collect::<Vec<_>>().join(", "))),
            };
            self.diagnostics.push(d);
            return None;
        };
        let usage = match function {
            Function::Atan2 => "atan2(y, x)".to_owned(),
            Function::Saturate => "saturate(x, lower, upper)".to_owned(),
            Function::DeadZone => "dead_zone(x, half_width)".to_owned(),
            Function::Min | Function::Max => format!("{}(a, b)", name.text),
            _ => format!("{}(x)", name.text),
        };
        if args.len() != *arity {
            let d = Diagnostic::error(
                "E0205",
                format!("`{}` takes {arity} argument{}, this has {}", name.text, if *arity == 1 { "" } else { "s" }, args.len()),
                span,
                "here",
            );
            self.diagnostics.push(d.help(format!("write {usage}")));
            return None;
        }
        let checked: Vec<Option<Quantity>> = args.iter().map(|a| self.check(a, allowed)).collect();
        let checked: Vec<Quantity> = checked.into_iter().collect::<Option<_>>()?;
        let dimension = match function {
            Function::Sqrt => match checked[0].dimension {
                None => None,
                Some(d) => match d.sqrt() {
                    Some(root) => Some(root),
                    None => {
                        self.diagnostics.push(Diagnostic::error(
                            "E0233",
                            format!("{} has no square root as a unit", in_words(d)),
                            args[0].span,
                            "odd exponents",
                        ));
                        return None;
                    }
                },
            },
            Function::Abs => checked[0].dimension,
            Function::Sign => Some(Dimension::NONE),
            Function::Min | Function::Max | Function::Saturate | Function::DeadZone | Function::Atan2 => {
                let mut common: Option<Dimension> = None;
                for (quantity, arg) in checked.iter().zip(args) {
                    if quantity.bare {
                        continue;
                    }
                    match (common, quantity.dimension) {
                        (Some(x), Some(y)) if x != y => {
                            self.diagnostics.push(Diagnostic::error(
                                "E0232",
                                format!("the arguments of `{}` have different dimensions", name.text),
                                arg.span,
                                format!("{}, before it {}", in_words(y), in_words(x)),
                            ));
                            return None;
                        }
                        (None, d) => common = d,
                        _ => {}
                    }
                }
                if *function == Function::Atan2 { Some(Dimension::NONE) } else { common.or(checked[0].dimension) }
            }
            _ => {
                if let Some(d) = checked[0].dimension
                    && d != Dimension::NONE
                {
                    let cycles = d.equal_but_for_cycles(Dimension::NONE);
                    let this = if cycles { "counts cycles".to_owned() } else { format!("is {}", in_words(d)) };
                    let message = format!("`{}` takes an angle or a plain number, this {this}", name.text);
                    let mut diagnostic = Diagnostic::error(if cycles { "E0234" } else { "E0233" }, message, args[0].span, in_words(d));
                    if d == Dimension::NONE / Dimension::TIME {
                        diagnostic = diagnostic.help("a rate times time is an angle: multiply by `t`");
                    } else if d == Dimension::TIME {
                        diagnostic = diagnostic.help("multiply by a rate, as in `2 [rad/s] * t`");
                    } else if cycles {
                        diagnostic = hertz(diagnostic);
                    }
                    self.diagnostics.push(diagnostic);
                    return None;
                }
                Some(Dimension::NONE)
            }
        };
        let expr = Expr::Call(*function, checked.into_iter().map(|q| q.expr).collect());
        Some(Quantity { expr, dimension, bare: false })
    }

    /// A unit as written.
    pub fn unit(&mut self, unit: &UnitExpr) -> Option<Unit> {
        let mut out = Unit { text: unit.text.clone(), factor: 1.0, dimension: Dimension::NONE };
        for (name, exponent) in &unit.factors {
            if name.text == "1" {
                continue;
            }
            let Some(found) = Unit::named(&name.text) else {
                let known = ["kg", "m", "s", "N", "rad", "deg", "V", "A", "W", "J", "Hz", "mm", "ms", "rpm", "ohm", "turn", "inch", "min"];
                let mut d = Diagnostic::error("E0203", format!("there is no unit `{}`", name.text), name.span, "unknown unit");
                if self.scope.names.contains_key(&name.text) && name.span.start < unit.span.end {
                    self.diagnostics.push(
                        d.help(format!("`{}` is a name of this rig: a product is written with `*`, as in `2 * {}`", name.text, name.text)),
                    );
                    return None;
                }
                let near = units::meant(&name.text).or_else(|| nearest(&name.text, known).map(str::to_owned));
                if let Some(near) = near {
                    d = d.help(format!("did you mean `{near}`?"));
                }
                self.diagnostics.push(d.help("units are m, kg, s, A, K, rad, deg, turn, rpm, Hz, N, J, W, V, ohm and others, with SI prefixes; `1` is a plain number"));
                return None;
            };
            out.factor *= found.factor.powi(i32::from(*exponent));
            out.dimension = out.dimension * found.dimension.powi(*exponent);
        }
        Some(out)
    }
}

/// The language's functions, with their number of arguments.
pub const FUNCTIONS: [(&str, Function, usize); 19] = [
    ("sin", Function::Sin, 1),
    ("cos", Function::Cos, 1),
    ("tan", Function::Tan, 1),
    ("asin", Function::Asin, 1),
    ("acos", Function::Acos, 1),
    ("atan", Function::Atan, 1),
    ("atan2", Function::Atan2, 2),
    ("sinh", Function::Sinh, 1),
    ("cosh", Function::Cosh, 1),
    ("tanh", Function::Tanh, 1),
    ("exp", Function::Exp, 1),
    ("ln", Function::Ln, 1),
    ("sqrt", Function::Sqrt, 1),
    ("abs", Function::Abs, 1),
    ("sign", Function::Sign, 1),
    ("min", Function::Min, 2),
    ("max", Function::Max, 2),
    ("saturate", Function::Saturate, 3),
    ("dead_zone", Function::DeadZone, 2),
];

/// A dimension in a sentence.
pub fn in_words(d: Dimension) -> String {
    d.to_string()
}

/// Numbers without unit only: takes the unit of its place.
pub fn is_bare(ast: &Ast) -> bool {
    match &ast.kind {
        ExprKind::Number(_, unit) => unit.is_none(),
        ExprKind::Neg(a) => is_bare(a),
        ExprKind::Binary(_, a, b) => is_bare(a) && is_bare(b),
        _ => false,
    }
}
