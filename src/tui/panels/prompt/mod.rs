//! Prompts for one line.

mod commands;
mod questions;
pub(crate) mod view;

pub use questions::Question;
