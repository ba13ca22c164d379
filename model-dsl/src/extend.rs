//! `extends`, `replace`, `remove`: from a rig and its bases to one list of statements.
//! Knows statements by keyword and name; knows nothing of what they mean.

use crate::ast::{Action, File, Removal, RigItem, Statement};
use crate::diagnostic::{Diagnostic, nearest};
use crate::rig::Span;
use std::collections::BTreeMap;

/// Statements in order, and the places where names were removed.
pub struct Flat {
    /// Statements.
    pub statements: Vec<Statement>,
    /// Removed names, and where.
    pub removed: BTreeMap<String, Span>,
}

/// Statements of `rig`, base first, with replacements and removals done. `None` where a base is missing: what a rig would have without it means nothing.
pub fn flatten(files: &[File], rig: &RigItem, diagnostics: &mut Vec<Diagnostic>) -> Option<Flat> {
    let mut chain: Vec<&RigItem> = vec![rig];
    while let Some(base) = &chain[chain.len() - 1].extends {
        let Some(found) = find(files, &base.text) else {
            let names: Vec<&str> = files.iter().flat_map(|f| &f.rigs).map(|r| r.name.text.as_str()).collect();
            let mut d = Diagnostic::error("E0201", format!("there is no rig `{}` to extend", base.text), base.span, "unknown rig");
            d = match nearest(&base.text, names.iter().copied()) {
                Some(near) => d.help(format!("did you mean `{near}`?")),
                None => d.help("bring it in with `use \"file.rig\";`"),
            };
            // the base may be in a file that could not be read
            if !diagnostics.iter().any(|d| matches!(d.code, "E0104" | "E0105")) {
                diagnostics.push(d);
            }
            return None;
        };
        if chain.iter().any(|r| r.name.text == found.name.text) {
            diagnostics.push(
                Diagnostic::error("E0208", format!("`{}` extends itself in a circle", found.name.text), base.span, "closes the circle")
                    .help("a rig can extend only what does not extend it"),
            );
            return None;
        }
        chain.push(found);
    }
    let mut statements: Vec<Statement> = Vec::new();
    let mut removed = BTreeMap::new();
    for item in chain.into_iter().rev() {
        for removal in &item.removals {
            remove(&mut statements, removal, diagnostics);
            removed.insert(removal.name.text.clone(), removal.name.span);
        }
        for statement in &item.statements {
            add(&mut statements, statement, diagnostics);
        }
    }
    Some(Flat { statements, removed })
}

/// The rig of this name.
pub fn find<'a>(files: &'a [File], name: &str) -> Option<&'a RigItem> {
    files.iter().flat_map(|f| &f.rigs).find(|r| r.name.text == name)
}

fn same(a: &Statement, b: &Statement) -> bool {
    a.keyword == b.keyword && a.name.text == b.name.text && a.keyword != "equation"
}

/// Statements of one family may replace one another: a `prescribed` coordinate one that was free, a `const` a `param`.
fn family(s: &Statement) -> &'static str {
    match s.keyword {
        "const" | "derived" | "lump" => "param",
        "prescribed" => "coord",
        "encoder" => "output",
        "torque" => "force",
        own => own,
    }
}

fn add(statements: &mut Vec<Statement>, new: &Statement, diagnostics: &mut Vec<Diagnostic>) {
    if new.action == Action::Add {
        statements.push(new.clone());
        return;
    }
    // an equation is known by its left-hand side, everything else by keyword and name
    let place = if new.keyword == "equation" {
        statements.iter().position(|s| s.keyword == "equation" && equation_of(s) == equation_of(new))
    } else {
        statements.iter().position(|s| same(s, new) || (family(s) == family(new) && s.name.text == new.name.text))
    };
    match place {
        Some(place) => statements[place] = Statement { action: Action::Add, ..new.clone() },
        None => {
            let names: Vec<&str> = statements.iter().filter(|s| s.keyword == new.keyword).map(|s| s.name.text.as_str()).collect();
            let mut d = Diagnostic::error(
                "E0207",
                format!("there is no {} `{}` to replace", new.keyword, new.name.text),
                new.name.span,
                "nothing of this name before",
            );
            d = match nearest(&new.name.text, names.iter().copied()) {
                Some(near) => d.help(format!("did you mean `{near}`?")),
                None => d.help("to add it, leave out `replace`"),
            };
            diagnostics.push(d);
            statements.push(new.clone());
        }
    }
}

/// The coordinate whose acceleration stands on the left, found by its `.ddot`.
fn equation_of(statement: &Statement) -> Option<String> {
    use crate::ast::{Expr, ExprKind, Kind};
    fn first(e: &Expr) -> Option<String> {
        match &e.kind {
            ExprKind::Name(name, Some(suffix)) if suffix.text == "ddot" => Some(name.text.clone()),
            ExprKind::Name(..) | ExprKind::Number(..) => None,
            ExprKind::Neg(a) => first(a),
            ExprKind::Binary(_, a, b) => first(a).or_else(|| first(b)),
            ExprKind::Call(_, args) => args.iter().find_map(first),
        }
    }
    match &statement.kind {
        Kind::Equation(lhs, _) => first(lhs),
        _ => None,
    }
}

fn remove(statements: &mut Vec<Statement>, removal: &Removal, diagnostics: &mut Vec<Diagnostic>) {
    let wanted = |s: &Statement| {
        let kind = removal.keyword.as_ref().is_none_or(|k| k.text == s.keyword);
        let name = if s.keyword == "equation" {
            equation_of(s).as_deref() == Some(removal.name.text.as_str())
        } else {
            s.name.text == removal.name.text
        };
        kind && name
    };
    let found: Vec<&'static str> = statements.iter().filter(|s| wanted(s)).map(|s| s.keyword).collect();
    let mut kinds = found.clone();
    kinds.dedup();
    match kinds.len() {
        0 => {
            let names: Vec<&str> = statements.iter().map(|s| s.name.text.as_str()).collect();
            let mut d = Diagnostic::error(
                "E0207",
                format!("there is no `{}` to remove", removal.name.text),
                removal.name.span,
                "nothing of this name in the base",
            );
            if let Some(near) = nearest(&removal.name.text, names.iter().copied()) {
                d = d.help(format!("did you mean `{near}`?"));
            }
            diagnostics.push(d);
        }
        1 => statements.retain(|s| !wanted(s)),
        _ => {
            let d = Diagnostic::error(
                "E0207",
                format!("`{}` names several statements: {}", removal.name.text, kinds.join(", ")),
                removal.name.span,
                "which one?",
            )
            .help(format!("write `remove {} {};`", kinds[0], removal.name.text));
            diagnostics.push(d);
        }
    }
}
