//! What was changed in a text, line by line, with the lines around it.

use maud::{Markup, html};
use similar::{ChangeTag, TextDiff};

/// Unchanged lines that are shown on each side of a change.
const AROUND: usize = 3;

pub(crate) fn difference(name: &str, old: &str, new: &str) -> Markup {
    let found = TextDiff::from_lines(old, new);
    let groups = found.grouped_ops(AROUND);
    html! {
        figure.difference {
            figcaption { (name) @if groups.is_empty() { ": no line differs" } }
            @if !groups.is_empty() {
                pre { @for (k, group) in groups.iter().enumerate() {
                    @if k > 0 { span.gap { "…" } }
                    @for change in group.iter().flat_map(|op| found.iter_changes(op)) {
                        @let line = change.value().trim_end_matches(['\r', '\n']);
                        @match change.tag() {
                            ChangeTag::Insert => { ins { "+ " (line) } }
                            ChangeTag::Delete => { del { "- " (line) } }
                            ChangeTag::Equal => { span { "  " (line) } }
                        }
                    }
                } }
            }
        }
    }
}
