//! Measured curves, and how well the model fits them.

pub(crate) mod choose;
pub(crate) mod commands;

pub use commands::{Measured, OpenedMeasured};
