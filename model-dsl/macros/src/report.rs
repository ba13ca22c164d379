//! Findings to the compiler: one `compile_error!` each, from its first to its last token; warnings by a deprecated
//! constant, since stable Rust offers macros no other way.

use model_dsl::{Diagnostic, MacroText, Sources};
use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

/// First and last token of the main place; the macro's call where it lies in a file that the rig uses.
pub fn place(d: &Diagnostic, text: Option<&MacroText>) -> (Span, Span) {
    let nowhere = (Span::call_site(), Span::call_site());
    let Some((span, _)) = d.labels.first().filter(|(span, _)| span.file == 0) else { return nowhere };
    text.and_then(|t| t.origin(*span)).unwrap_or(nowhere)
}

/// The message with all that belongs to it. The compiler shows the lines of the main place itself; of a place in
/// another file it knows nothing, so there the message brings its own.
pub fn words(d: &Diagnostic, sources: &Sources, text: Option<&MacroText>) -> String {
    let Some(((main, label), others)) = d.labels.split_first().filter(|((span, _), _)| text.is_some() && span.file == 0) else {
        let rendered = d.render(sources, false);
        let shown = rendered.split_once('\n').map_or("", |(_, rest)| rest);
        return format!("[{}] {}\n{shown}", d.code, d.message).trim_end().to_owned();
    };
    let mut out = format!("[{}] {}", d.code, d.message);
    // an empty place is the end of what stands in front of it
    let label = &if main.start == main.end && !label.is_empty() { format!("{label}, behind what is underlined") } else { label.clone() };
    let in_message = |label: &str| label.is_empty() || d.message.ends_with(label);
    if !in_message(label) {
        let shown = sources.text(*main).filter(|t| !t.is_empty() && t.len() <= 60 && !t.contains('\n'));
        out.push_str(&shown.map_or_else(|| format!("\n  {label}"), |t| format!("\n  `{t}`: {label}")));
    }
    for (span, label) in others {
        if let Some(place) = sources.place(*span) {
            let file = if span.file == 0 { String::new() } else { format!("{}, ", place.file) };
            out.push_str(&format!("\n  {file}line {}: {}", place.line, said(sources.text(*span), label)));
        }
    }
    for help in &d.helps {
        out.push_str(&format!("\n  help: {help}"));
    }
    out
}

fn said(text: Option<&str>, label: &str) -> String {
    match text.filter(|t| !t.is_empty() && t.len() <= 60 && !t.contains('\n')) {
        Some(text) => format!("`{text}` {label}"),
        None => label.to_owned(),
    }
}

/// `::core::compile_error! { ".." }`: the compiler underlines from the first token's span to the last one's.
pub fn error(message: &str, (first, last): (Span, Span)) -> TokenStream {
    let mut literal = proc_macro2::Literal::string(message);
    literal.set_span(last);
    let mut group = Group::new(Delimiter::Brace, TokenStream::from(TokenTree::Literal(literal)));
    group.set_span(last);
    let punct = |c: char, spacing: Spacing| {
        let mut p = Punct::new(c, spacing);
        p.set_span(first);
        TokenTree::Punct(p)
    };
    let ident = |name: &str| TokenTree::Ident(Ident::new(name, first));
    [
        punct(':', Spacing::Joint),
        punct(':', Spacing::Alone),
        ident("core"),
        punct(':', Spacing::Joint),
        punct(':', Spacing::Alone),
        ident("compile_error"),
        punct('!', Spacing::Alone),
        TokenTree::Group(group),
    ]
    .into_iter()
    .collect()
}

/// A use, at the first token, of a constant that is deprecated for the reason given.
pub fn warning(message: &str, (first, _): (Span, Span)) -> TokenStream {
    let used = quote_spanned! { first.resolved_at(Span::call_site()) => rig };
    quote! {
        const _: () = {
            #[allow(non_upper_case_globals)]
            #[deprecated(note = #message)]
            const rig: () = ();
            #used
        };
    }
}
