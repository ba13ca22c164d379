//! Identifiers of emitted code: the rig's names where the language takes them, no clashes.

use std::collections::HashSet;

/// A language's rules for identifiers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Language {
    /// Rust, edition 2024.
    Rust,
    /// C99.
    C,
}

const RUST: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else", "enum", "extern", "false",
    "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "self", "Self", "static", "struct", "super", "trait", "true", "try", "type", "typeof", "union", "unsafe", "unsized", "use", "virtual",
    "where", "while", "yield", "_",
];

const C: &[&str] = &[
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum", "extern", "float", "for", "goto", "if",
    "inline", "int", "long", "register", "restrict", "return", "short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union",
    "unsigned", "void", "volatile", "while", "_Bool", "_Complex", "_Imaginary",
    // C++ includes the header too; some compilers define the last ones as macros
    "asm", "bool", "catch", "class", "delete", "explicit", "export", "false", "friend", "mutable", "namespace", "new", "operator", "private",
    "protected", "public", "template", "this", "throw", "true", "try", "typename", "using", "virtual", "and", "or", "not", "xor", "NAN",
    "INFINITY", "NULL", "M_PI", "linux", "unix", "_",
];

/// Arguments of a model's functions.
pub const LETTERS: &[&str] = &["t", "x", "q", "v", "a", "z", "u", "p"];

/// Functions and values that bodies of functions call by their names.
pub const CALLED_RUST: &[&str] = &[
    "sin", "cos", "sin_cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "ln", "sqrt",
    "abs", "sign", "step", "atan2", "min", "max", "pow", "powi", "positive", "Ok", "Err", "Some", "None",
];

/// Results of a model's functions in C, where they are arguments.
pub const RESULTS_C: &[&str] = &["m", "h", "c", "g", "d", "f", "s", "r", "y", "b", "dx", "dz", "by_x", "by_p"];

/// The same for C.
pub const CALLED_C: &[&str] = &[
    "sin", "cos", "tan", "asin",
    "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "fabs", "fmin", "fmax", "pow", "atan2", "sign", "step", "powi",
];

/// Hands out identifiers, each once.
pub struct Names {
    language: Language,
    taken: HashSet<String>,
}

impl Names {
    /// With names that are taken from the start.
    pub fn new<S: AsRef<str>>(language: Language, taken: &[S]) -> Self {
        Self { language, taken: taken.iter().map(|s| s.as_ref().to_owned()).collect() }
    }

    /// An identifier as close to `wanted` as the language and earlier names allow.
    pub fn take(&mut self, wanted: &str) -> String {
        let plain = identifier(self.language, wanted);
        let mut name = plain.clone();
        let mut k = 2;
        while !self.taken.insert(name.clone()) {
            name = if plain.ends_with('_') { format!("{plain}{k}") } else { format!("{plain}_{k}") };
            k += 1;
        }
        name
    }
}

/// `wanted` as an identifier of the language: `eps.dot` becomes `eps_dot`, a keyword gets an underscore,
/// C gets `alpha` for the Greek letter.
pub fn identifier(language: Language, wanted: &str) -> String {
    let mut name = String::new();
    for c in wanted.chars() {
        match language {
            _ if c == '_' || c.is_ascii_alphanumeric() => name.push(c),
            Language::Rust if c.is_alphanumeric() => name.push(c),
            Language::C if c.is_alphanumeric() => match latin(c) {
                Some(latin) => name.push_str(latin),
                None => name.push_str(&format!("u{:04x}", c as u32)),
            },
            _ => name.push('_'),
        }
    }
    if name.is_empty() || name.starts_with(|c: char| c.is_numeric()) {
        name.insert(0, '_');
    }
    let words = match language {
        Language::Rust => RUST,
        Language::C => C,
    };
    if words.contains(&name.as_str()) {
        name.push('_');
    }
    name
}

/// `GoogolMrb` as `googol_mrb`.
pub fn snake(name: &str) -> String {
    let mut out = String::new();
    let mut before: Option<char> = None;
    for c in name.chars() {
        if c.is_uppercase() && before.is_some_and(|b| b.is_lowercase() || b.is_ascii_digit()) {
            out.push('_');
        }
        out.extend(c.to_lowercase());
        before = Some(c);
    }
    out
}

/// The Greek letters, spelled out.
fn latin(c: char) -> Option<&'static str> {
    Some(match c {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' | 'ϵ' => "eps",
        'ζ' => "zeta",
        'η' => "eta",
        'θ' | 'ϑ' => "theta",
        'ι' => "iota",
        'κ' => "kappa",
        'λ' => "lambda",
        'μ' | 'µ' => "mu",
        'ν' => "nu",
        'ξ' => "xi",
        'ο' => "omicron",
        'π' => "pi",
        'ρ' => "rho",
        'σ' | 'ς' => "sigma",
        'τ' => "tau",
        'υ' => "upsilon",
        'φ' | 'ϕ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Γ' => "Gamma",
        'Δ' => "Delta",
        'Θ' => "Theta",
        'Λ' => "Lambda",
        'Ξ' => "Xi",
        'Π' => "Pi",
        'Σ' => "Sigma",
        'Φ' => "Phi",
        'Ψ' => "Psi",
        'Ω' => "Omega",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::{Language, Names, identifier, snake};

    #[test]
    fn names_are_those_of_the_rig_where_the_language_takes_them() {
        assert_eq!(identifier(Language::Rust, "eps.dot"), "eps_dot");
        assert_eq!(identifier(Language::Rust, "type"), "type_");
        assert_eq!(identifier(Language::Rust, "θ_1"), "θ_1");
        assert_eq!(identifier(Language::C, "θ_1"), "theta_1");
        assert_eq!(identifier(Language::C, "double"), "double_");
        assert_eq!(snake("GoogolEq13"), "googol_eq13");
        assert_eq!(snake("CartPole"), "cart_pole");
        let mut names = Names::new(Language::C, &["q"]);
        assert_eq!([names.take("q"), names.take("θ"), names.take("theta"), names.take("l_1"), names.take("l_1")], ["q_2", "theta", "theta_2", "l_1", "l_1_2"]);
    }
}
