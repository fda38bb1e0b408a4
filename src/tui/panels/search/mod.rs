//! The search of the tree.

mod commands;

pub use commands::Search;
