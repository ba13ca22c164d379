//! The page: what stands on it, in which order, and how that becomes HTML.

use crate::difference::difference;
use crate::plot::{Plot, figure};
use crate::table::{Table, table};
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A page.
#[derive(Clone, Debug)]
pub struct Page {
    /// By what, and from what, it was written: stands in a comment in the first lines.
    pub mark: String,
    /// Title.
    pub title: String,
    /// One line under it.
    pub subtitle: String,
    /// What follows.
    pub blocks: Vec<Block>,
    /// Facts at the end that say where the page comes from: name and text.
    pub provenance: Vec<(String, String)>,
    /// How long it took, in words: the one line that differs from run to run.
    pub time: Option<String>,
}

/// How a sentence is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Good news.
    Good,
    /// Something to look at.
    Warning,
    /// Bad news.
    Bad,
    /// Neither.
    Plain,
}

impl Tone {
    fn class(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Warning => "warning",
            Self::Bad => "bad",
            Self::Plain => "plain",
        }
    }
}

/// A part of a page.
#[derive(Clone, Debug)]
pub enum Block {
    /// Heading of a section.
    Heading(String),
    /// Heading within a section.
    Subheading(String),
    /// A paragraph.
    Text(String),
    /// A sentence in a frame, with a word before it.
    Callout {
        /// How it is meant.
        tone: Tone,
        /// The word.
        word: String,
        /// The sentence.
        sentence: String,
    },
    /// Names and what they are.
    Facts(Vec<(String, String)>),
    /// Table.
    Table(Table),
    /// Plots: wide ones alone, others side by side where there is room.
    Plots(Vec<Plot>),
    /// What was changed in a text.
    Difference {
        /// Name of the text.
        name: String,
        /// Before.
        old: String,
        /// After.
        new: String,
    },
    /// Text as it is, in a fixed width.
    Code(String),
    /// Blocks that are shown on demand.
    Fold {
        /// What they are.
        title: String,
        /// Blocks.
        blocks: Vec<Block>,
    },
}

const STYLE: &str = include_str!("style.css");

impl Page {
    /// The page as HTML.
    #[must_use]
    pub fn html(&self) -> String {
        // two hyphens would end the comment
        let mark = self.mark.replace('\n', " ").replace("--", "- -").replace(['<', '>'], " ");
        let page = html! {
            (DOCTYPE)
            (PreEscaped(format!("\n<!-- {mark} -->\n")))
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    title { (self.title) }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    main {
                        header {
                            h1 { (self.title) }
                            @if !self.subtitle.is_empty() { p.subtitle { (self.subtitle) } }
                        }
                        @for block in &self.blocks { (render(block)) }
                    }
                    footer {
                        @if !self.provenance.is_empty() { (facts(&self.provenance)) }
                        @if let Some(time) = &self.time { p.time { (time) } }
                    }
                }
            }
        };
        let mut text = page.into_string();
        text.push('\n');
        text
    }
}

fn render(block: &Block) -> Markup {
    match block {
        Block::Heading(text) => html! { h2 { (text) } },
        Block::Subheading(text) => html! { h3 { (text) } },
        Block::Text(text) => html! { p { (text) } },
        Block::Callout { tone, word, sentence } => html! {
            p class={ "callout " (tone.class()) } { strong { (word) } " " (sentence) }
        },
        Block::Facts(list) => facts(list),
        Block::Table(data) => table(data),
        Block::Plots(plots) => html! { div.plots { @for plot in plots { (figure(plot)) } } },
        Block::Difference { name, old, new } => difference(name, old, new),
        Block::Code(text) => html! { pre { code { (text) } } },
        Block::Fold { title, blocks } => html! {
            details { summary { (title) } @for block in blocks { (render(block)) } }
        },
    }
}

fn facts(list: &[(String, String)]) -> Markup {
    html! {
        dl { @for (name, text) in list { div { dt { (name) } dd { (text) } } } }
    }
}
