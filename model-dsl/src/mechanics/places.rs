//! Where statements and their entries stand in the text.

use super::Context;
use crate::ast::{BodyEntry, Entry, Kind, Statement};
use crate::rig::Span;

impl Context<'_> {
    /// The last statement of this keyword and name (the one that counts after `replace`).
    pub(super) fn statement(&self, keyword: &str, name: &str) -> Option<&Statement> {
        self.statements.iter().rev().find(|s| s.keyword == keyword && s.name.text == name)
    }

    /// From the keyword to the name: `frame heli`.
    pub(super) fn head(&self, keyword: &str, name: &str, otherwise: Span) -> Span {
        self.statement(keyword, name)
            .filter(|s| s.span.file == s.name.span.file)
            .map_or(otherwise, |s| Span { end: s.name.span.end, ..s.span })
    }

    /// The mass of a body.
    pub(super) fn mass(&self, body: &str, otherwise: Span) -> Span {
        self.body(body, |e| if let BodyEntry::Mass(v) = e { Some(v.span) } else { None }).unwrap_or(otherwise)
    }

    /// The inertia of a body.
    pub(super) fn inertia(&self, body: &str, otherwise: Span) -> Span {
        self.body(body, |e| if let BodyEntry::Inertia(_, _, span) = e { Some(*span) } else { None }).unwrap_or(otherwise)
    }

    fn body(&self, name: &str, find: impl Fn(&BodyEntry) -> Option<Span>) -> Option<Span> {
        match &self.statement("body", name)?.kind {
            Kind::Body(_, entries) => entries.iter().find_map(find),
            _ => None,
        }
    }

    /// The definition behind `=`.
    pub(super) fn definition(&self, name: &str, otherwise: Span) -> Span {
        let found = self.statement("lump", name).or_else(|| self.statement("derived", name));
        match found.map(|s| &s.kind) {
            Some(Kind::Define(_, definition, ..)) => definition.span,
            _ => otherwise,
        }
    }

    /// The value of an entry (`lag`) or of an option (`width`) in a statement's block.
    pub(super) fn entry(&self, keywords: &[&str], name: &str, key: &str, otherwise: Span) -> Span {
        let entries: &[Entry] = match keywords.iter().find_map(|k| self.statement(k, name)).map(|s| &s.kind) {
            Some(Kind::Input(.., entries) | Kind::Actuator(.., entries) | Kind::Output(.., entries) | Kind::Friction(_, entries)) => {
                entries
            }
            _ => return otherwise,
        };
        let option = |e: &Entry| e.options.iter().find(|(k, _)| k.text == key).and_then(|(_, v)| v.as_ref()).map(|v| v.span);
        let value = |e: &Entry| (e.key.text == key).then(|| e.values.first().map(|v| v.span)).flatten();
        entries.iter().find_map(|e| value(e).or_else(|| option(e))).unwrap_or(otherwise)
    }
}
