//! What emitted files say in words: the header, and what a block of statements is about.

use crate::equations::{CrossCheck, Equations};

/// Text at the top of a file.
pub struct Header(Vec<String>);

impl Header {
    /// Title, where the file comes from, the rig's words, assumptions, size.
    pub fn new(e: &Equations, source: &str) -> Self {
        let l = &e.layout;
        let mut doc = l.doc.lines().map(str::trim);
        let title = doc.next().filter(|t| !t.is_empty()).unwrap_or(&l.rig);
        let mut lines = vec![format!("{}.", title.trim_end_matches('.'))];
        lines.push(format!("Generated from `{source}` (model {}); edit the rig, not this file.", e.hash.get(..8).unwrap_or(&e.hash)));
        let rest: Vec<&str> = doc.skip_while(|t| t.is_empty()).collect();
        if !rest.is_empty() {
            lines.push(String::new());
            lines.extend(rest.iter().map(|t| (*t).to_owned()));
        }
        lines.push(String::new());
        if !e.assumptions.is_empty() {
            lines.push(format!("Assumed: {}.", e.assumptions.join("; ")));
        }
        let jacobians = if e.linear.a.is_empty() { String::new() } else { format!(", {} with A and B", e.jacobian_operations()) };
        let checked = match e.cross_check {
            CrossCheck::Agree { .. } if !e.assumptions.is_empty() => {
                Some("Derived twice before the assumptions, body by body and by Lagrange: they agree; the power balance holds.")
            }
            CrossCheck::Agree { .. } => Some("Derived twice, body by body and by Lagrange: they agree; the power balance holds."),
            CrossCheck::NotApplicable => None,
        };
        lines.push(format!("{} operations forward{jacobians}.", e.forward_operations()));
        lines.extend(checked.map(str::to_owned));
        lines.push(String::new());
        lines.push("M(q) a + h(q, v) + d(q, v) = Q, state x = [q | v | z] with v = q', a = q''. SI units and radians.".to_owned());
        Self(lines)
    }

    /// Its lines, of at most so many characters.
    pub fn lines(&self, width: usize) -> Vec<String> {
        wrapped(&self.0, width)
    }
}

/// Words in lines of at most so many characters. Lines of a table (between ``` lines) stay as they are.
pub fn wrapped(lines: &[String], width: usize) -> Vec<String> {
    let mut out = Vec::new();
    let mut table = false;
    for line in lines {
        table ^= line.starts_with("```");
        if table || line.chars().count() <= width {
            out.push(line.clone());
            continue;
        }
        let mut row = String::new();
        for word in line.split(' ') {
            if !row.is_empty() && row.chars().count() + 1 + word.chars().count() > width {
                out.push(std::mem::take(&mut row));
            }
            if !row.is_empty() {
                row.push(' ');
            }
            row.push_str(word);
        }
        out.push(row);
    }
    out
}

/// What the statements of a scope are about.
pub fn about(e: &Equations, scope: &str) -> Option<String> {
    if scope.is_empty() {
        return None;
    }
    if scope == "solve" {
        return Some("M = L^T D L and back-substitution".to_owned());
    }
    if scope == "balance" {
        return Some("balance of forces".to_owned());
    }
    if scope == "gravity" {
        return Some("gravity".to_owned());
    }
    if scope == "input_map" {
        return Some("input map".to_owned());
    }
    if scope == "slopes" {
        return Some("slopes of the balance of forces, at the accelerations found".to_owned());
    }
    if let Some(what) = scope.strip_prefix("by_") {
        return Some(format!("derivatives with respect to {what}"));
    }
    Some(e.scopes.iter().find(|(name, _)| name == scope).map_or_else(|| scope.to_owned(), |(_, words)| words.clone()))
}
