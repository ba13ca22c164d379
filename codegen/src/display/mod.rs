//! Equations as a person writes them.

mod plain;

pub use plain::plain;
