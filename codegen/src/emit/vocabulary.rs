//! What symbols and functions are called in the language that is written.

use super::form::Rank;
use super::names::Language;
use crate::expr::{F1, F2, Graph, SymbolId, SymbolKind};

/// One symbol.
#[derive(Clone, Debug)]
pub struct Word {
    /// Where it stands within products.
    pub rank: Rank,
    /// As code: `q.eps`.
    pub text: String,
    /// As part of the name of an intermediate value: `eps`.
    pub base: String,
}

/// Language and symbols.
pub struct Vocabulary {
    /// Language.
    pub language: Language,
    words: Vec<Word>,
}

impl Vocabulary {
    /// Asks `word` for each symbol of the graph.
    pub fn new(language: Language, graph: &Graph, mut word: impl FnMut(SymbolId, SymbolKind) -> (String, String)) -> Self {
        let words = graph
            .symbols()
            .map(|(id, info)| {
                let (text, base) = word(id, info.kind);
                let rank = if matches!(info.kind, SymbolKind::Parameter(_)) { Rank::Parameter } else { Rank::Variable };
                Word { rank, text, base }
            })
            .collect();
        Self { language, words }
    }

    /// A symbol's word.
    pub fn word(&self, symbol: SymbolId) -> &Word {
        &self.words[symbol.index()]
    }

    /// Name of a function of one argument.
    pub fn function(&self, f: F1) -> &'static str {
        match f {
            F1::Sin => "sin",
            F1::Cos => "cos",
            F1::Tan => "tan",
            F1::Asin => "asin",
            F1::Acos => "acos",
            F1::Atan => "atan",
            F1::Sinh => "sinh",
            F1::Cosh => "cosh",
            F1::Tanh | F1::SmoothSign => "tanh",
            F1::Exp => "exp",
            F1::Sqrt => "sqrt",
            F1::Sign => "sign",
            F1::Step => "step",
            F1::Ln => match self.language {
                Language::Rust => "ln",
                Language::C => "log",
            },
            F1::Abs => match self.language {
                Language::Rust => "abs",
                Language::C => "fabs",
            },
        }
    }

    /// Name of a function of two arguments.
    pub fn function2(&self, f: F2) -> &'static str {
        match (f, self.language) {
            (F2::Atan2, _) => "atan2",
            (F2::Pow, _) => "pow",
            (F2::Min, Language::Rust) => "min",
            (F2::Max, Language::Rust) => "max",
            (F2::Min, Language::C) => "fmin",
            (F2::Max, Language::C) => "fmax",
        }
    }
}
