//! A written expression as plain text: `m_h g l_cd cos(theta) sin(eps)`, `psi'^2`.

use super::number::Number;
use super::tree::{Binding, Tree};

/// Text of an expression.
pub fn text(tree: &Tree) -> String {
    match tree {
        Tree::Number(x) => number(*x),
        Tree::Name(name) => name_text(name),
        Tree::Entry(what, names) => format!("{what}[{}]", names.join(", ")),
        Tree::Call(f, args) => format!("{f}({})", args.iter().map(text).collect::<Vec<_>>().join(", ")),
        Tree::Power(base, exponent) => {
            // psi'^2 reads well, -2^x and 1/2^x do not
            format!("{}^{}", within(base, Binding::Leaf), within(exponent, Binding::Leaf))
        }
        Tree::Product(factors) => {
            let mut out = String::new();
            for (i, factor) in factors.iter().enumerate() {
                let part = match factor.binding() {
                    // a quotient may stand first only: x a/b is (x a)/b, which has the same value but reads worse
                    Binding::Quotient if i > 0 => format!("({})", text(factor)),
                    _ => within(factor, Binding::Product),
                };
                if i > 0 {
                    out.push_str(if part.starts_with(|c: char| c.is_ascii_digit()) { " * " } else { " " });
                }
                out.push_str(&part);
            }
            out
        }
        Tree::Quotient(top, bottom) => format!("{}/{}", within(top, Binding::Product), within(bottom, Binding::Power)),
        Tree::Minus(inner) => format!("-{}", within(inner, Binding::Product)),
        Tree::Sum(terms) => {
            let mut out = String::new();
            for (i, (minus, term)) in terms.iter().enumerate() {
                out.push_str(match (i, minus) {
                    (0, true) => "-",
                    (0, false) => "",
                    (_, true) => " - ",
                    (_, false) => " + ",
                });
                out.push_str(&within(term, Binding::Product));
            }
            out
        }
    }
}

/// With brackets where it holds less tightly than needed.
fn within(tree: &Tree, needed: Binding) -> String {
    let text = text(tree);
    if tree.binding() < needed { format!("({text})") } else { text }
}

fn number(x: Number) -> String {
    match x.fraction() {
        Some((p, 1)) => format!("{p}"),
        Some((p, q)) => format!("{p}/{q}"),
        None => x.decimal_text(),
    }
}

/// `eps.dot` is eps', `m_prime` is m'.
pub fn name_text(name: &str) -> String {
    if let Some(base) = name.strip_suffix(".ddot") {
        return format!("{base}''");
    }
    if let Some(base) = name.strip_suffix(".dot") {
        return format!("{base}'");
    }
    match name.strip_suffix("_prime") {
        Some(base) if !base.is_empty() => format!("{base}'"),
        _ => name.to_owned(),
    }
}
