//! A written expression as LaTeX: `m_h g l_{cd} \cos\theta \sin\epsilon`, `\dot{\psi}^2`.

use super::number::Number;
use super::tree::{Binding, Tree};

/// LaTeX of an expression.
pub fn latex(tree: &Tree) -> String {
    match tree {
        Tree::Number(x) => number(*x),
        Tree::Name(name) => name_latex(name),
        Tree::Entry(what, names) => {
            let names: Vec<String> = names.iter().map(|n| name_latex(n)).collect();
            // h_\psi, M_{\epsilon\theta}
            format!("{what}_{{{}}}", names.join(if names.iter().any(|n| !n.starts_with('\\')) { "," } else { "" }))
        }
        Tree::Call(f, args) => call(f, args, None),
        Tree::Power(base, exponent) => power(base, exponent),
        Tree::Product(factors) => {
            let mut out = String::new();
            for (i, factor) in factors.iter().enumerate() {
                let part = within(factor, Binding::Product);
                if i > 0 {
                    let digit = part.starts_with(|c: char| c.is_ascii_digit());
                    out.push_str(if digit || matches!(factor, Tree::Number(_)) { " \\cdot " } else { " " });
                }
                out.push_str(&part);
            }
            out
        }
        Tree::Quotient(top, bottom) => format!("\\frac{{{}}}{{{}}}", latex(top), latex(bottom)),
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

/// With brackets where it holds less tightly than needed. A fraction needs none but under a power.
fn within(tree: &Tree, needed: Binding) -> String {
    let text = latex(tree);
    if tree.binding() < needed { bracketed(&text) } else { text }
}

fn bracketed(text: &str) -> String {
    format!("\\left({text}\\right)")
}

fn power(base: &Tree, exponent: &Tree) -> String {
    if let (Tree::Call(f @ ("sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh"), args), Tree::Number(n)) = (base, exponent)
        && matches!(n.fraction(), Some((p, 1)) if p > 1)
    {
        return call(f, args, Some(&number(*n)));
    }
    let leaf = within(base, Binding::Leaf);
    // |x|^2 and \sqrt{x}^2 stand by themselves, ln(x)^2 and names with primes do not
    let leaf = match base {
        Tree::Name(name) if leaf.contains('\'') || name.ends_with(".lag") => bracketed(&leaf),
        Tree::Call("abs" | "sqrt", _) | Tree::Name(_) | Tree::Number(_) => leaf,
        Tree::Call(..) => bracketed(&leaf),
        _ => leaf,
    };
    format!("{leaf}^{{{}}}", latex(exponent))
}

fn call(f: &str, args: &[Tree], exponent: Option<&str>) -> String {
    let raised = exponent.map_or(String::new(), |n| format!("^{{{n}}}"));
    let list = args.iter().map(latex).collect::<Vec<_>>().join(", ");
    let operator = match f {
        "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "ln" | "min" | "max" | "exp" => format!("\\{f}"),
        "asin" | "acos" | "atan" => format!("\\arc{}", &f[1..]),
        "sqrt" => return format!("\\sqrt{{{list}}}"),
        "abs" => return format!("\\left|{list}\\right|"),
        "saturate" => "\\operatorname{sat}".to_owned(),
        "sign" => "\\operatorname{sgn}".to_owned(),
        other => format!("\\operatorname{{{}}}", other.replace('_', "\\_")),
    };
    match args {
        // \sin\theta, but \sin(2 \theta) and \tanh(\dot{\theta}/w)
        [Tree::Name(name)] if matches!(f, "sin" | "cos" | "tan") && !name.contains('.') => format!("{operator}{raised}{}", spaced(&list)),
        _ => format!("{operator}{raised}{}", bracketed(&list)),
    }
}

/// A space where a command would swallow the letter after it.
fn spaced(text: &str) -> String {
    if text.starts_with('\\') { text.to_owned() } else { format!(" {text}") }
}

fn number(x: Number) -> String {
    match x.fraction() {
        Some((p, 1)) => format!("{p}"),
        Some((p, q)) => format!("{}\\frac{{{}}}{{{q}}}", if p < 0 { "-" } else { "" }, p.abs()),
        None => {
            let text = x.decimal_text();
            match text.split_once('e') {
                Some((mantissa, exponent)) => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
                None => text,
            }
        }
    }
}

/// `eps.dot` is \dot{\epsilon}, `l_oc` is l_{oc}, `m_prime` is m', `c0_psi` is c_{0,\psi}, `f_1.lag` is f_{1,\mathrm{lag}}.
pub fn name_latex(name: &str) -> String {
    let (name, accent) = match (name.strip_suffix(".ddot"), name.strip_suffix(".dot")) {
        (Some(base), _) => (base, Some("ddot")),
        (None, Some(base)) => (base, Some("dot")),
        (None, None) => (name, None),
    };
    let (name, tail) = match name.strip_suffix(".lag") {
        Some(base) => (base, "lag"),
        None => (name, ""),
    };
    let (name, prime) = match name.strip_suffix("_prime") {
        Some(base) if !base.is_empty() => (base, true),
        _ => (name, false),
    };
    let mut pieces = name.split('_').filter(|p| !p.is_empty());
    let first = pieces.next().unwrap_or("x");
    let (letters, digits) = first.split_at(first.trim_end_matches(|c: char| c.is_ascii_digit()).len());
    let (letters, digits) = if letters.is_empty() { (digits, "") } else { (letters, digits) };
    let mut subscripts: Vec<String> = Vec::new();
    if !digits.is_empty() {
        subscripts.push(digits.to_owned());
    }
    subscripts.extend(pieces.map(|piece| greek(piece).unwrap_or_else(|| plain(piece))));
    if !tail.is_empty() {
        subscripts.push(format!("\\mathrm{{{tail}}}"));
    }
    let base = greek(letters)
        .unwrap_or_else(|| if letters.chars().count() == 1 { plain(letters) } else { format!("\\mathrm{{{}}}", plain(letters)) });
    let base = match accent {
        Some(accent) => format!("\\{accent}{{{base}}}"),
        None => base,
    };
    let base = if prime { format!("{base}'") } else { base };
    match subscripts.join(",").as_str() {
        "" => base,
        one if one.chars().count() == 1 => format!("{base}_{one}"),
        many => format!("{base}_{{{many}}}"),
    }
}

/// Letters that need no escape stay; Greek ones become commands, others are left out.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_string() } else { greek(&c.to_string()).unwrap_or_default() }).collect()
}

fn greek(word: &str) -> Option<String> {
    const LETTERS: [(&str, &str); 24] = [
        ("alpha", "α"),
        ("beta", "β"),
        ("gamma", "γ"),
        ("delta", "δ"),
        ("epsilon", "ϵ"),
        ("zeta", "ζ"),
        ("eta", "η"),
        ("theta", "θ"),
        ("iota", "ι"),
        ("kappa", "κ"),
        ("lambda", "λ"),
        ("mu", "μ"),
        ("nu", "ν"),
        ("xi", "ξ"),
        ("omicron", "ο"),
        ("pi", "π"),
        ("rho", "ρ"),
        ("sigma", "σ"),
        ("tau", "τ"),
        ("upsilon", "υ"),
        ("phi", "φ"),
        ("chi", "χ"),
        ("psi", "ψ"),
        ("omega", "ω"),
    ];
    const CAPITALS: [(&str, &str); 11] = [
        ("Gamma", "Γ"),
        ("Delta", "Δ"),
        ("Theta", "Θ"),
        ("Lambda", "Λ"),
        ("Xi", "Ξ"),
        ("Pi", "Π"),
        ("Sigma", "Σ"),
        ("Upsilon", "Υ"),
        ("Phi", "Φ"),
        ("Psi", "Ψ"),
        ("Omega", "Ω"),
    ];
    // \omicron is no command of plain LaTeX
    if matches!(word, "omicron" | "ο") {
        return Some("o".to_owned());
    }
    if matches!(word, "eps" | "ε") {
        return Some("\\varepsilon".to_owned());
    }
    LETTERS.iter().chain(&CAPITALS).find(|(name, letter)| *name == word || *letter == word).map(|(name, _)| format!("\\{name}"))
}
