//! `rig!`: a rig in Rust code becomes a module with its model, at compile time.
//!
//! ```ignore
//! rig! {
//!     /// A cart on a rail
//!     rig Cart {
//!         param m: kg = 2;          // comments vanish; `///` documents
//!         coord x: m;
//!         frame carriage = ground.translate(x, 0, 0);
//!         body load on carriage { mass m; }
//!     }
//! }
//! rig!("rigs/googol.rig");              // the last rig of a file, beside Cargo.toml
//! rig!("rigs/googol.rig", GoogolMrb);   // or the one of this name
//! ```
//!
//! The module is called as the rig, in small letters (`googol_mrb`); it needs the crate `runtime` only. Messages are those
//! of the program, at the tokens that they are about. A file that was read is tracked: when it changes, the model is
//! derived anew. Knows how to talk with the compiler; knows nothing of rigs.
#![forbid(unsafe_code)]

mod report;

use codegen::{Options, derive, emit};
use model_dsl::{CheckOptions, Checked, FileLoader, Loader, MacroText, Severity};
use proc_macro2::{Span, TokenStream, TokenTree};
use quote::quote;
use std::path::{Path, PathBuf};

/// A rig as a module with its model; see the crate's documentation.
#[proc_macro]
pub fn rig(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand(input.into()).into()
}

/// Files beside `Cargo.toml`.
struct Beside(PathBuf);

impl Beside {
    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Loader for Beside {
    fn load(&self, name: &str) -> Result<Vec<u8>, String> {
        FileLoader.load(&self.path(name).to_string_lossy())
    }
}

fn expand(input: TokenStream) -> TokenStream {
    let loader = Beside(std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default());
    let file = Span::call_site().file();
    let (checked, text, first) = match path_and_name(&input) {
        Ok(Some((path, name))) => (model_dsl::check(&path, &loader, &CheckOptions { rig: name }), None, 0),
        Ok(None) => {
            let (checked, text) = model_dsl::check_tokens(&file, input, &loader, &CheckOptions::default());
            (checked, Some(text), 1)
        }
        Err(wrong) => return wrong,
    };
    let tracked = tracked(&checked, &loader, first);
    let module = module(&checked, text.as_ref(), &file);
    quote! { #tracked #module }
}

/// The file and the rig's name in `rig!("file.rig", Name)`; `None` where the rig itself stands in the macro.
fn path_and_name(input: &TokenStream) -> Result<Option<(String, Option<String>)>, TokenStream> {
    let trees: Vec<TokenTree> = input.clone().into_iter().collect();
    let Some(TokenTree::Literal(literal)) = trees.first() else { return Ok(None) };
    let Ok(path) = syn::parse_str::<syn::LitStr>(&literal.to_string()) else {
        return Err(report::error("expected a file name in quotes, as in `rig!(\"googol.rig\")`", (literal.span(), literal.span())));
    };
    match &trees[1..] {
        [] => Ok(Some((path.value(), None))),
        [TokenTree::Punct(comma)] if comma.as_char() == ',' => Ok(Some((path.value(), None))),
        [TokenTree::Punct(comma), TokenTree::Ident(name), rest @ ..] if comma.as_char() == ',' && rest.len() < 2 => {
            Ok(Some((path.value(), Some(name.to_string()))))
        }
        [first, ..] => Err(report::error("expected `rig!(\"file.rig\")` or `rig!(\"file.rig\", Name)`", (first.span(), first.span()))),
    }
}

/// The compiler notes that the expansion depends on these files.
fn tracked(checked: &Checked, loader: &Beside, first: usize) -> TokenStream {
    let paths = checked.sources.files.iter().skip(first).map(|(name, _)| loader.path(name)).filter(|p| p.is_file());
    let paths = paths.map(|p| p.canonicalize().unwrap_or(p).to_string_lossy().into_owned());
    quote! { #(const _: &[u8] = ::core::include_bytes!(#paths);)* }
}

fn module(checked: &Checked, text: Option<&MacroText>, file: &str) -> TokenStream {
    let mut out = TokenStream::new();
    for d in &checked.diagnostics {
        out.extend(match d.severity {
            Severity::Error => report::error(&report::words(d, &checked.sources, text), report::place(d, text)),
            Severity::Warning => report::warning(&report::words(d, &checked.sources, text), report::place(d, text)),
            Severity::Note => TokenStream::new(),
        });
    }
    let Some(rig) = &checked.rig else { return out };
    let nowhere = (Span::call_site(), Span::call_site());
    let equations = match derive(rig, Options::default()) {
        Ok(equations) => equations,
        Err(why) => return report::error(&why.to_string(), nowhere),
    };
    let source = if text.is_some() { file } else { checked.sources.files.first().map_or(file, |(name, _)| name) };
    let source = Path::new(source).file_name().map_or_else(|| source.to_owned(), |n| n.to_string_lossy().into_owned());
    match emit::rust(&equations, &source).parse::<TokenStream>() {
        Ok(code) => {
            let name = syn::Ident::new(&module_name(&rig.name), Span::call_site());
            // every token of the expansion has the macro's place, which looks like a missing comma before a sign
            out.extend(quote! { #[allow(clippy::possible_missing_comma)] pub mod #name { #code } });
        }
        Err(why) => {
            out.extend(report::error(&format!("the generated code cannot be read: {why}; this is a fault of the program"), nowhere))
        }
    }
    out
}

/// `GoogolMrb` to `googol_mrb`, a name that Rust takes.
fn module_name(rig: &str) -> String {
    let mut out = String::new();
    let letters: Vec<char> = rig.chars().collect();
    for (k, &c) in letters.iter().enumerate() {
        let after_small = k > 0 && (letters[k - 1].is_lowercase() || letters[k - 1].is_numeric());
        let before_small = k > 0 && letters[k - 1].is_uppercase() && letters.get(k + 1).is_some_and(|n| n.is_lowercase());
        if c.is_uppercase() && (after_small || before_small) {
            out.push('_');
        }
        out.extend(c.to_lowercase());
    }
    if syn::parse_str::<syn::Ident>(&out).is_ok() { out } else { format!("{out}_rig") }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The expansion outside of the compiler: same tokens, no places.
    fn expanded(text: &str) -> String {
        expand(text.parse().expect("tokens")).to_string()
    }

    #[test]
    fn a_file_becomes_a_module_and_is_tracked_with_all_that_it_uses() {
        let code = expanded("\"../../examples/rigs/googol_mrb.rig\"");
        assert!(code.contains("pub mod googol_mrb"), "{code}");
        for file in ["googol_mrb.rig", "googol.rig"] {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/rigs").join(file).canonicalize().expect("the rig");
            assert!(code.contains(&format!(":: include_bytes ! ({:?})", path.to_string_lossy())), "{file} is not tracked");
        }
        let inline = expanded("use \"../../examples/rigs/googol.rig\"; rig Other extends Googol { }");
        assert!(inline.contains("pub mod other") && inline.contains("googol.rig"));
    }

    #[test]
    fn a_wrong_file_is_shown_with_its_lines() {
        let code = expanded("\"../../tests/rigs/fail/force_of_volts.rig\"");
        assert!(code.contains("compile_error") && !code.contains("pub mod"));
        assert!(code.contains("[E0231] a force needs newtons, this is V\\n  --> ../../tests/rigs/fail/force_of_volts.rig:19:48"), "{code}");
        // mended, it is compiled anew
        assert!(code.contains("include_bytes"));
    }

    #[test]
    fn the_rig_that_is_named_is_taken() {
        assert!(expanded("\"../../tests/rigs/statements/extends_replace_remove.rig\"").contains("pub mod variant"));
        assert!(expanded("\"../../tests/rigs/statements/extends_replace_remove.rig\", Base").contains("pub mod base"));
        let missing = expanded("\"../../tests/rigs/statements/extends_replace_remove.rig\", Bse");
        assert!(missing.contains("[E0114] there is no rig `Bse` in this file") && missing.contains("did you mean `Base`?"), "{missing}");
    }

    #[test]
    fn modules_are_called_as_rigs_in_small_letters() {
        let pairs = [
            ("GoogolMrb", "googol_mrb"),
            ("Chain3", "chain3"),
            ("SRBModel", "srb_model"),
            ("Match", "match_rig"),
            ("already_small", "already_small"),
        ];
        for (rig, module) in pairs {
            assert_eq!(module_name(rig), module);
        }
    }
}
