//! One self-contained HTML page from headings, tables, series and differences of texts.
//!
//! A page refers to nothing outside itself: its style and its plots (SVG) stand in it. It follows the reader's choice of light
//! or dark, prints, and fits 900 pixels and a telephone. All text is escaped (by `maud`), and equal input gives equal bytes.
//!
//! Plots are drawn here and not by a library: those that emit SVG write fixed colours and fonts into each element (no dark
//! mode), and none thins long series without hiding peaks.
//!
//! Knows nothing of rigs, records and models: numbers come as series, or as texts that are ready to be read.
#![forbid(unsafe_code)]

mod difference;
mod page;
mod plot;
mod table;

pub use page::{Block, Page, Tone};
pub use plot::{Axis, Ink, Plot, Series, Shape};
pub use table::{Cell, Table};
