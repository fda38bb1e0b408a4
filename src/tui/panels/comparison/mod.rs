//! Curves to compare with the model: frozen and loaded references, and measured curves.

mod commands;
pub(crate) mod view;

pub use commands::{Comparison, Reference};
