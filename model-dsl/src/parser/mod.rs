//! Recursive descent from tokens to the syntax tree. After an error it goes on behind the next `;` or `}`,
//! so that all errors of a file come at once. Nesting is limited, so that no text overflows the stack.

mod cursor;
mod expressions;
mod items;
mod statements;
mod values;
mod vectors;

use crate::ast::{Expr, File, UnitExpr};
use crate::diagnostic::Diagnostic;
use crate::token::{Kind as T, Token};

/// Deepest nesting of expressions.
const DEPTH: u32 = 64;
/// Longest sum or product.
const LENGTH: u32 = 400;
/// Most levels of an expression's tree: what walks over it is recursive.
const TREE: u32 = 500;

/// Words that start a statement.
const STATEMENTS: [&str; 26] = [
    "param",
    "const",
    "derived",
    "lump",
    "coord",
    "prescribed",
    "frame",
    "body",
    "gravity",
    "input",
    "actuator",
    "mix",
    "force",
    "torque",
    "spring",
    "damper",
    "friction",
    "potential",
    "kinetic",
    "dissipation",
    "equation",
    "encoder",
    "output",
    "trim",
    "assume",
    "remove",
];

/// Words that may stand behind a number; any other word there is taken for a unit.
const AFTER_VALUES: [&str; 16] =
    ["fixed", "in", "per", "width", "speed", "zero", "wrapped", "value", "along", "against", "about", "at", "on", "to", "of", "for"];

/// Parses the tokens of one file.
pub fn parse(tokens: &[Token], diagnostics: &mut Vec<Diagnostic>) -> File {
    let mut parser = Parser { tokens, at: 0, diagnostics, depth: 0 };
    parser.file()
}

/// Parses a single expression; the whole of the tokens must be one.
pub fn parse_expression(tokens: &[Token], diagnostics: &mut Vec<Diagnostic>) -> Option<Expr> {
    let mut parser = Parser { tokens, at: 0, diagnostics, depth: 0 };
    let expr = parser.expr().ok()?;
    if matches!(parser.peek().kind, T::End) { Some(expr) } else { parser.unexpected("the end").map_or(None, |()| None) }
}

/// Parses a unit; the whole of the tokens must be one.
pub fn parse_unit(tokens: &[Token], diagnostics: &mut Vec<Diagnostic>) -> Option<UnitExpr> {
    let mut parser = Parser { tokens, at: 0, diagnostics, depth: 0 };
    let unit = parser.unit().ok()?;
    if matches!(parser.peek().kind, T::End) { Some(unit) } else { parser.unexpected("the end").map_or(None, |()| None) }
}

/// An error that was reported already.
struct Reported;

type Parsed<T> = Result<T, Reported>;

struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    diagnostics: &'a mut Vec<Diagnostic>,
    depth: u32,
}
